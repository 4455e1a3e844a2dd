//! Planar PH quintics that interpolate first-order Hermite data.

use std::cell::OnceCell;
use std::cmp::Ordering;
use std::fmt;

use super::preimage::Preimage;
use super::rotation::{Planar, Real, Rounded, Turning};
use crate::number::complex::minimize_complex;
use crate::{Complex, budget, integer, ratio};

/// The precisions, in bits, at which enclosures are tried before exact numbers.
const PRECISIONS: [u64; 2] = [96, 384];

/// Digits after the point of the decimals in messages.
const MESSAGE_DIGITS: u32 = 4;

/// The planar PH quintics `s' = w²` with given end points and end tangents `s(0)`, `s'(0)`, `s(1)`, `s'(1)` (Farouki
/// and Neff, *Hermite interpolation by Pythagorean hodograph quintics*, 1995).
///
/// With `w₀² = s'(0)` and `w₂² = s'(1)` the third condition, `w₀² + w₀w₁ + (2w₁² + w₀w₂)/3 + w₁w₂ + w₂² = 5·(s(1) −
/// s(0))`, is quadratic in `w₁`: `4w₁ = −3(w₀ + w₂) ± √(120·(s(1) − s(0)) − 15·(w₀² + w₂²) + 10·w₀w₂)`.
///
/// Up to a common sign of all coefficients there are four solutions, with these indices; `w₀` and the square root are
/// principal values:
///
/// | index | w₂ | root in w₁ |
/// | --- | --- | --- |
/// | 0 | principal root of `s'(1)` | + |
/// | 1 | principal root of `s'(1)` | − |
/// | 2 | its negative | + |
/// | 3 | its negative | − |
///
/// Where the root is zero, the two solutions with it are one, and both indices name it.
///
/// # Example
/// ```
/// use hodograph_algebra::{Complex, Hermite, Poly};
/// let point = |x, y| Complex::new(Poly::integer(x), Poly::integer(y));
/// // The data of FN Example 4.
/// let data = Hermite::new(&point(0, 0), &point(-2, 0), &point(0, 1), &point(2, 0)).unwrap();
/// let w = data.least_rotation().unwrap();
/// let texts: Vec<String> = w.coefficients().iter().map(ToString::to_string).collect();
/// assert_eq!(texts[0], "I*(sqrt2)");
/// assert_eq!(texts[2], "sqrt2");
/// assert_eq!(w.coefficients()[1].to_decimal(6), "1.030990 + 1.030990*I");
/// ```
#[derive(Clone, Debug)]
pub struct Hermite {
    w0: Complex,
    w2: Complex,
    /// The radicand of the root in `w₁` for the principal `w₂` and for its negative, each with its root, once computed.
    radicands: [(Complex, OnceCell<Complex>); 2],
}

/// One of the four Hermite data.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum HermiteDatum {
    /// The point `s(0)`.
    Start,
    /// The derivative `s'(0)`.
    StartTangent,
    /// The point `s(1)`.
    End,
    /// The derivative `s'(1)`.
    EndTangent,
}

impl fmt::Display for HermiteDatum {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            HermiteDatum::Start => "start point s(0)",
            HermiteDatum::StartTangent => "start tangent s'(0)",
            HermiteDatum::End => "end point s(1)",
            HermiteDatum::EndTangent => "end tangent s'(1)",
        })
    }
}

/// A solution, as a message lists it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct HermiteSolution {
    /// Its index, as stated at [`Hermite`].
    pub index: usize,
    /// Its preimage.
    pub preimage: Preimage,
}

impl fmt::Display for HermiteSolution {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "solution {}:", self.index)?;
        for (j, w) in self.preimage.coefficients().iter().enumerate() {
            let separator = if j == 0 { ' ' } else { ';' };
            let space = if j == 0 { "" } else { " " };
            write!(f, "{separator}{space}w{j} = {w} ≈ {}", w.to_decimal(MESSAGE_DIGITS))?;
        }
        Ok(())
    }
}

/// Why Hermite data have no solution, or not the one asked for.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum HermiteError {
    /// A point or tangent contains a parameter or a symbol.
    NotANumber {
        /// The first such one.
        datum: HermiteDatum,
    },
    /// A tangent is the zero vector, for which the end of the curve would have no direction.
    ZeroTangent {
        /// The first such one.
        datum: HermiteDatum,
    },
    /// There is no solution of this index.
    NoSuchSolution {
        /// The index asked for.
        index: usize,
    },
    /// Several solutions have the least absolute rotation index.
    Tie {
        /// These solutions, at least two.
        solutions: Vec<HermiteSolution>,
    },
}

impl fmt::Display for HermiteError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            HermiteError::NotANumber { datum } => {
                write!(f, "the {datum} must be a pair of numbers, without parameters or symbols")
            }
            HermiteError::ZeroTangent { datum } => {
                write!(f, "the {datum} is zero; a PH quintic needs nonzero tangents at both ends")
            }
            HermiteError::NoSuchSolution { index } => {
                write!(f, "there is no solution {index}: the four solutions are numbered from 0 to 3")
            }
            HermiteError::Tie { solutions } => {
                write!(
                    f,
                    "{} of the PH quintics with these Hermite data have the same least absolute rotation index; \
                     choose one by its number",
                    solutions.len()
                )?;
                solutions.iter().try_for_each(|solution| write!(f, "\n  {solution}"))
            }
        }
    }
}

impl std::error::Error for HermiteError {}

impl Hermite {
    /// The interpolation of the points `start`, `end` and the derivatives `start_tangent`, `end_tangent` at the
    /// parameters 0 and 1, all of which are numbers `x + I·y`.
    ///
    /// # Errors
    /// [`HermiteError::NotANumber`] and [`HermiteError::ZeroTangent`].
    pub fn new(
        start: &Complex,
        start_tangent: &Complex,
        end: &Complex,
        end_tangent: &Complex,
    ) -> Result<Hermite, HermiteError> {
        let data = [
            (HermiteDatum::Start, start),
            (HermiteDatum::StartTangent, start_tangent),
            (HermiteDatum::End, end),
            (HermiteDatum::EndTangent, end_tangent),
        ];
        if let Some((datum, _)) = data.iter().find(|(_, value)| !value.is_constant()) {
            return Err(HermiteError::NotANumber { datum: *datum });
        }
        let tangents = [data[1], data[3]];
        if let Some((datum, _)) = tangents.iter().find(|(_, value)| value.is_zero()) {
            return Err(HermiteError::ZeroTangent { datum: *datum });
        }
        // All numbers over one field, so that it is joined only here.
        let roots = [start_tangent.sqrt(), end_tangent.sqrt()];
        let [w0, w2, known] = budget::doing("the outer coefficients of a PH quintic", || {
            let tangents = (start_tangent + end_tangent).scale(&integer(15));
            let known = (end - start).scale(&integer(120)) - tangents;
            let [w0, w2] = roots;
            minimize_complex(&[w0, w2, known])
        });
        let product = (&w0 * &w2).scale(&integer(10));
        let radicands = [&known + &product, &known - &product].map(|radicand| (radicand, OnceCell::new()));
        Ok(Hermite { w0, w2, radicands })
    }

    /// The indices of the solutions that differ, in ascending order: four, or fewer where solutions coincide.
    #[must_use]
    pub fn indices(&self) -> Vec<usize> {
        (0..4_usize)
            .filter(|index| index.is_multiple_of(2) || !self.radicands[index / 2].0.is_zero())
            .collect()
    }

    /// The solution with the given index, as stated at [`Hermite`], over a field with as few generators as
    /// [`minimize_field`](crate::minimize_field) finds.
    ///
    /// # Errors
    /// [`HermiteError::NoSuchSolution`] if `index` is above 3.
    pub fn solution(&self, index: usize) -> Result<Preimage, HermiteError> {
        if index > 3 {
            return Err(HermiteError::NoSuchSolution { index });
        }
        let coefficients = minimize_complex(&self.exact(index));
        Ok(Preimage::nonzero(coefficients.to_vec()))
    }

    /// The solution of least absolute rotation index `(1/2π)·∫|κ| ds`, the one without needless loops.
    ///
    /// The indices are compared exactly. A solution whose parametric speed vanishes somewhere, so that its tangent is
    /// not defined there, is taken only where all are of that kind.
    ///
    /// # Errors
    /// [`HermiteError::Tie`] if several solutions attain the least index, which symmetric data can make them do.
    pub fn least_rotation(&self) -> Result<Preimage, HermiteError> {
        budget::doing("the rotation indices of PH quintics", || {
            let mut least: Vec<usize> = Vec::new();
            for index in self.indices() {
                let order = least.first().map_or(Ordering::Less, |first| self.compare(index, *first));
                if order.is_lt() {
                    least.clear();
                }
                if order.is_le() {
                    least.push(index);
                }
            }
            if let [only] = least[..] {
                return self.solution(only);
            }
            let mut solutions = Vec::new();
            for index in least {
                solutions.push(HermiteSolution { index, preimage: self.solution(index)? });
            }
            Err(HermiteError::Tie { solutions })
        })
    }

    /// Compares the absolute rotation indices of two solutions: by enclosures where these are enough, else exactly.
    fn compare(&self, a: usize, b: usize) -> Ordering {
        for bits in PRECISIONS {
            let turnings = [a, b].map(|index| Turning::of(&self.rounded(index, bits)));
            if let [Some(a), Some(b)] = turnings
                && let Some(order) = a.compare(&b)
            {
                return order;
            }
        }
        let turnings = [a, b].map(|index| {
            let [w0, w1, w2] = &self.exact(index);
            Turning::of(&[w0.into(), w1.into(), w2.into()])
        });
        match turnings {
            [Some(a), Some(b)] => a.compare(&b).unwrap_or(Ordering::Equal),
            _ => unreachable!("the signs of exact numbers are known"),
        }
    }

    fn exact(&self, index: usize) -> [Complex; 3] {
        let (radicand, root) = &self.radicands[index / 2];
        let root =
            root.get_or_init(|| budget::doing("the middle coefficient of a PH quintic", || radicand.sqrt()));
        let w2 = if index < 2 { self.w2.clone() } else { -&self.w2 };
        let outer = (&self.w0 + &w2).scale(&integer(3));
        let w1 = if index.is_multiple_of(2) { root - outer } else { -(root + outer) };
        [self.w0.clone(), w1.scale(&ratio(1, 4)), w2]
    }

    /// Enclosures of the coefficients of a solution, times 4.
    fn rounded(&self, index: usize, bits: u64) -> [Planar<Rounded>; 3] {
        budget::spend(bits);
        let round = |z: &Complex| Planar { re: Rounded::new(&z.re, bits), im: Rounded::new(&z.im, bits) };
        let root = rounded_sqrt(&self.radicands[index / 2].0, bits);
        let root = if index.is_multiple_of(2) { root } else { root.negated() };
        let (w0, w2) = (round(&self.w0), round(&self.w2));
        let w2 = if index < 2 { w2 } else { w2.negated() };
        let sum = w0.plus(&w2);
        let w1 = root.plus(&sum.plus(&sum).plus(&sum).negated());
        let fourfold = |z: &Planar<Rounded>| {
            let double = z.plus(z);
            double.plus(&double)
        };
        [fourfold(&w0), w1, fourfold(&w2)]
    }
}

/// Enclosures of the parts of the principal square root: `√((|z| ± a)/2)` for `z = a + I·b`, the second with the sign
/// of `b`.
fn rounded_sqrt(z: &Complex, bits: u64) -> Planar<Rounded> {
    let (a, b) = (Rounded::new(&z.re, bits), Rounded::new(&z.im, bits));
    let absolute = a.times(&a).plus(&b.times(&b)).root();
    let (re, im) = (absolute.plus(&a).half().root(), absolute.minus(&a).half().root());
    Planar { re, im: if z.im.sign().is_lt() { im.negated() } else { im } }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Poly;

    fn point(x: i64, y: i64) -> Complex {
        Complex::new(Poly::integer(x), Poly::integer(y))
    }

    #[test]
    fn enclosures_hold_the_exact_coefficients() {
        for tangents in [[(0, 4), (4, 0)], [(-2, 0), (2, 0)], [(-3, 4), (0, -1)], [(2, -3), (1, 0)]] {
            let [(x0, y0), (x1, y1)] = tangents;
            let data = Hermite::new(&point(0, 0), &point(x0, y0), &point(2, 1), &point(x1, y1)).unwrap();
            for index in data.indices() {
                let exact = data.exact(index);
                for (w, rounded) in exact.iter().zip(data.rounded(index, 64)) {
                    for (part, rounded) in [(&w.re, &rounded.re), (&w.im, &rounded.im)] {
                        let difference = rounded.minus(&Rounded::new(&part.scale(&integer(4)), 64));
                        assert!(difference.known_sign().is_none_or(Ordering::is_eq), "{tangents:?}, {index}");
                    }
                }
            }
        }
    }

    #[test]
    fn enclosures_and_exact_numbers_order_alike() {
        for (x, y) in [(2, 2), (-1, 3), (1, -4)] {
            let data = Hermite::new(&point(0, 0), &point(0, 4), &point(x, y), &point(4, 0)).unwrap();
            for a in 0..4 {
                for b in 0..a {
                    let exact = [a, b].map(|index| {
                        let [w0, w1, w2] = &data.exact(index);
                        Turning::of(&[w0.into(), w1.into(), w2.into()]).unwrap()
                    });
                    assert_eq!(exact[0].compare(&exact[1]), Some(data.compare(a, b)), "({x}, {y}): {a}, {b}");
                }
            }
        }
    }
}
