//! Families of surfaces, whose coefficients are set at run time: what is checked of them, and functions of their
//! coefficients.

use core::fmt;

use crate::real::{Plain, Real, Rounded};
use crate::surface::Domain;

/// Why a surface of a family cannot be made of the given parameters.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum ParameterError {
    /// A parameter is infinite or NaN.
    NotFinite {
        /// The name of the field.
        parameter: &'static str,
    },
    /// The parameters are so large, or so small, that coefficients overflow.
    Overflow,
    /// The weight W vanishes near (u, v), or comes so near to zero that rounding cannot tell.
    Pole {
        /// The first parameter of a place nearby.
        u: f64,
        /// The second parameter of a place nearby.
        v: f64,
    },
    /// The parametric speed of a curve vanishes or changes its sign on the domain, or comes so near to zero that rounding
    /// cannot tell.
    Speed,
}

impl fmt::Display for ParameterError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotFinite { parameter } => write!(f, "`{parameter}` is not finite"),
            Self::Overflow => f.write_str("the coefficients of the surface overflow"),
            Self::Pole { u, v } => write!(
                f,
                "the weight of the surface vanishes, or comes too near to zero, at about u = {u}, v = {v}"
            ),
            Self::Speed => f.write_str(
                "the parametric speed of a curve vanishes on the domain, or comes too near to zero",
            ),
        }
    }
}

impl core::error::Error for ParameterError {}

/// √x of a coefficient.
///
/// ```
/// assert_eq!(hodograph::family::root(6.25), 2.5);
/// ```
#[must_use]
pub fn root(x: f64) -> f64 {
    Plain::new(x).sqrt().value()
}

/// [`Real::orient`] of a coefficient.
///
/// ```
/// use hodograph::family::orient;
/// assert_eq!((orient(2.0, 3.0), orient(2.0, -1.0)), (2.0, -2.0));
/// assert!(orient(2.0, 0.0).is_nan());
/// ```
#[must_use]
pub fn orient(x: f64, by: f64) -> f64 {
    Plain::new(x).orient(Plain::new(by)).value()
}

/// [`Real::scale`] of coefficients.
///
/// ```
/// assert_eq!(hodograph::family::scale(0.0, -8.0, 1.0), 0.125);
/// ```
#[must_use]
pub fn scale(a: f64, b: f64, c: f64) -> f64 {
    Plain::scale(Plain::new(a), Plain::new(b), Plain::new(c)).value()
}

/// Checks the values of a parameter.
///
/// # Errors
/// [`ParameterError::NotFinite`] with its name.
pub fn check_finite(parameter: &'static str, values: &[f64]) -> Result<(), ParameterError> {
    if values.iter().all(|value| value.is_finite()) {
        Ok(())
    } else {
        Err(ParameterError::NotFinite { parameter })
    }
}

/// Checks that a control net is finite, and that its weight vanishes nowhere on the domain.
///
/// The net has `columns` points for each index of u.
///
/// # Errors
/// [`ParameterError::Overflow`] and [`ParameterError::Pole`].
pub fn check_net<const L: usize>(
    net: &[[f64; 4]; L],
    columns: usize,
    domain: &Domain,
) -> Result<(), ParameterError> {
    if !net.iter().flatten().all(|value| value.is_finite()) {
        return Err(ParameterError::Overflow);
    }
    let weights = net.map(|[w, ..]| w);
    let size = weights.iter().fold(0.0, |size: f64, w| size.max(w.abs()));
    let margin = MARGIN * size;
    match first_zero(&weights, columns, margin, [0.0, 1.0], [0.0, 1.0], DEPTH) {
        None => Ok(()),
        Some((s, t)) => {
            let (u, v) = domain.at(s, t);
            Err(ParameterError::Pole { u, v })
        }
    }
}

/// Checks that a polynomial is positive, given by its Bernstein coefficients.
///
/// # Errors
/// [`ParameterError::Speed`].
pub fn check_speed<const L: usize>(coefficients: &[f64; L]) -> Result<(), ParameterError> {
    let size = coefficients.iter().fold(0.0, |size: f64, c| size.max(c.abs()));
    let found = first_zero(coefficients, L, MARGIN * size, [0.0, 1.0], [0.0, 1.0], DEPTH);
    if found.is_none() && coefficients[0] > 0.0 { Ok(()) } else { Err(ParameterError::Speed) }
}

/// How near to zero, relative to the largest coefficient, rounding cannot tell from it.
const MARGIN: f64 = 1e-13;

/// How often a domain is halved.
const DEPTH: u32 = 48;

/// A place of the rectangle where a polynomial with this Bernstein net cannot be told from zero; `None` if its sign is
/// certified to be the same everywhere.
///
/// A rectangle is halved in the direction in which its net changes sign more often: so that a factor of one parameter, as
/// weights have, needs no more halves than it would alone.
fn first_zero<const L: usize>(
    net: &[f64; L],
    columns: usize,
    margin: f64,
    s: [f64; 2],
    t: [f64; 2],
    depth: u32,
) -> Option<(f64, f64)> {
    if net.iter().all(|&c| c > margin) || net.iter().all(|&c| c < -margin) {
        return None;
    }
    let rows = L / columns;
    let corners =
        [(0, s[0], t[0]), (columns - 1, s[0], t[1]), ((rows - 1) * columns, s[1], t[0]), (L - 1, s[1], t[1])];
    if let Some(&(_, s, t)) = corners.iter().find(|&&(place, ..)| net[place].abs() <= margin) {
        return Some((s, t));
    }
    let middle = |[first, last]: [f64; 2]| 0.5 * (first + last);
    if depth == 0 {
        return Some((middle(s), middle(t)));
    }
    let differ = |a: usize, b: usize| {
        (net[a] > margin) != (net[b] > margin) || (net[a] < -margin) != (net[b] < -margin)
    };
    // Changes for each line of the net, over a common denominator.
    let changes_u = rows * (columns..L).filter(|&place| differ(place - columns, place)).count();
    let changes_v = columns * (1..L).filter(|&place| place % columns > 0 && differ(place - 1, place)).count();
    let longer_u = rows > 1 && (columns == 1 || s[1] - s[0] >= t[1] - t[0]);
    let along_u = if changes_u == changes_v { longer_u } else { changes_u > changes_v };
    let (left, right) = halves(net, columns, along_u);
    let ends = if along_u { s } else { t };
    let [before, after] = [[ends[0], middle(ends)], [middle(ends), ends[1]]];
    let half = |net: &[f64; L], part: [f64; 2]| {
        let (s, t) = if along_u { (part, t) } else { (s, part) };
        first_zero(net, columns, margin, s, t, depth - 1)
    };
    half(&left, before).or_else(|| half(&right, after))
}

/// The nets of both halves in one direction, by de Casteljau's scheme.
fn halves<const L: usize>(net: &[f64; L], columns: usize, along_u: bool) -> ([f64; L], [f64; L]) {
    let (mut left, mut right) = (*net, *net);
    let (count, step, lines, next) =
        if along_u { (L / columns, columns, columns, 1) } else { (columns, 1, L / columns, columns) };
    for line in 0..lines {
        let at = |k: usize| line * next + k * step;
        for level in 1..count {
            for k in 0..count - level {
                right[at(k)] = 0.5 * (right[at(k)] + right[at(k + 1)]);
            }
            left[at(level)] = right[at(0)];
        }
    }
    (left, right)
}

#[cfg(test)]
mod tests {
    use super::{ParameterError, check_finite, check_net, check_speed};
    use crate::Domain;

    const DOMAIN: Domain = Domain { u: [0.0, 2.0], v: [0.0, 1.0] };

    fn net<const L: usize>(weights: [f64; L]) -> [[f64; 4]; L] {
        weights.map(|w| [w, 0.0, 0.0, 0.0])
    }

    #[test]
    fn weights_without_zeros_pass() {
        assert_eq!(check_net(&net([1.0, 2.0, 3.0, 4.0]), 2, &DOMAIN), Ok(()));
        assert_eq!(check_net(&net([-1.0, -2.0]), 2, &DOMAIN), Ok(()));
        // (2v − 1)² + 1/100 has a negative coefficient.
        assert_eq!(check_net(&net([1.01, -0.99, 1.01]), 3, &DOMAIN), Ok(()));
        // The same in u.
        assert_eq!(check_net(&net([1.01, -0.99, 1.01]), 1, &DOMAIN), Ok(()));
    }

    #[test]
    fn zeros_are_found() {
        for (weights, columns) in
            [([1.0, -1.0, 1.0], 3), ([1.0, -1.0, 1.0], 1), ([1.0, 0.0, -1.0], 3), ([0.0; 3], 3)]
        {
            assert!(matches!(check_net(&net(weights), columns, &DOMAIN), Err(ParameterError::Pole { .. })));
        }
        // (3v − 1)², which touches zero in the interior of halves.
        let Err(ParameterError::Pole { u, v }) = check_net(&net([1.0, -2.0, 4.0]), 3, &DOMAIN) else {
            panic!()
        };
        assert!((v - 1.0 / 3.0).abs() < 1e-4, "{u} {v}");
        // Changes of sign: (2v − 1)·(3 − u), and 2u − 1.
        let Err(ParameterError::Pole { v, .. }) = check_net(&net([-3.0, 3.0, -1.0, 1.0]), 2, &DOMAIN) else {
            panic!()
        };
        assert_eq!(v, 0.5);
        let Err(ParameterError::Pole { u, .. }) = check_net(&net([-1.0, 3.0]), 1, &DOMAIN) else { panic!() };
        assert_eq!(u, 0.5);
        assert_eq!(check_net(&net([1.0, f64::INFINITY]), 2, &DOMAIN), Err(ParameterError::Overflow));
    }

    #[test]
    fn numbers_and_speeds() {
        assert_eq!(check_finite("c0", &[0.0, -1.0]), Ok(()));
        assert_eq!(check_finite("c0", &[f64::NAN]), Err(ParameterError::NotFinite { parameter: "c0" }));
        assert_eq!(check_speed(&[1.0, 2.0]), Ok(()));
        assert_eq!(check_speed(&[-1.0, -2.0]), Err(ParameterError::Speed));
        assert_eq!(check_speed(&[1.0, -2.0]), Err(ParameterError::Speed));
    }
}
