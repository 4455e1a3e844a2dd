//! What is left of the curvatures where a derivative of the surface vanishes, and surfaces that bend alike everywhere.
//!
//! Where the profile of a rotation meets its axis, R_v and n_v vanish together: both have a factor φ(u), such as 1 − u², and so
//! have F and the signed area. The shape operator stays as it is if all of them are divided by φ, and is then defined and
//! bounded where φ = 0.

use hodograph_algebra::{BoxSign, Fraction, Interval, Poly, Rational, Variable, ratio};

use super::Derived;
use super::weingarten::Base;

/// A factor that vanishes with a derivative, and what is left when it is divided out.
pub(super) struct Common {
    /// φ
    pub(super) factor: Poly,
    /// R_Y/φ as numerators over the last field.
    pub(super) partial: [Poly; 3],
    /// The square of the weight.
    pub(super) square: Poly,
    /// (N_Y·ρ − N·ρ_Y)/φ where there is a root ρ, else (N_Y·h − N·h_Y)/φ for the content h(y) of N where φ = 0.
    pub(super) slope: [Poly; 3],
    /// ρ², or h: over this the slope is that of N/ρ or, up to multiples of N, of N.
    pub(super) denominator: Poly,
}

impl Common {
    /// The largest power of x − a, for the ends a of the domain of the base, that R_Y and the derivative by Y of what the unit
    /// normal is made of have in common with the factor of R_u × R_v; `None` if there is none.
    pub(super) fn of(derived: &Derived<'_>, base: Base) -> Option<Common> {
        let (singular, normal) = (derived.singular?, derived.normal?);
        let [x, y] = base.order(derived.parameters);
        let [domain, _] = base.order(derived.domain.each_ref());
        let mut factors = Vec::new();
        let mut content = Poly::one();
        for end in domain {
            let factor = Poly::variable(x) - Poly::constant(end.clone());
            let mut rest = singular.clone();
            while let Some(quotient) = rest.exact_div(&factor) {
                if factors.is_empty() {
                    content = Poly::gcd_many(&normal.each_ref().map(|n| n.at(&[(x, end)])));
                }
                factors.push(factor.clone());
                rest = quotient;
            }
        }
        if factors.is_empty() {
            return None;
        }
        let [weight, coordinates @ ..] = derived.homogeneous;
        let root = derived.normal_root.unwrap_or(&content);
        if root.is_zero()
            || derived.normal_root.is_none()
                && !is_definite(root, y, base.order(derived.domain.each_ref())[1])
        {
            return None;
        }
        let slope = |n: &Poly, d: &Poly| n.derivative(y) * d - n * d.derivative(y);
        let mut common = Common {
            factor: Poly::one(),
            partial: coordinates.each_ref().map(|coordinate| slope(coordinate, weight)),
            square: weight * weight,
            slope: normal.each_ref().map(|n| slope(n, root)),
            denominator: if derived.normal_root.is_some() { root * root } else { root.clone() },
        };
        for factor in factors {
            let divided = |polys: &[Poly; 3]| {
                let divided: Option<Vec<Poly>> = polys.iter().map(|poly| poly.exact_div(&factor)).collect();
                <[Poly; 3]>::try_from(divided?).ok()
            };
            if let (Some(partial), Some(slope)) = (divided(&common.partial), divided(&common.slope)) {
                (common.partial, common.slope) = (partial, slope);
                common.factor = &common.factor * &factor;
            }
        }
        (!common.factor.is_one()).then_some(common)
    }

    /// The factor of R_u × R_v, divided as well.
    pub(super) fn divided(&self, factor: &Fraction) -> Option<Fraction> {
        let quotient = Fraction::from(Poly::one()).checked_div(&Fraction::from(self.factor.clone()))?;
        Some((factor * &quotient).lowest_terms())
    }
}

/// Whether a polynomial of one parameter is certified to have no zeros on its domain.
fn is_definite(poly: &Poly, variable: &Variable, domain: &[Rational; 2]) -> bool {
    let [start, end] = domain.each_ref().map(|end| Poly::constant(end.clone()));
    let Some(interval) = Interval::new(start, end) else { return false };
    matches!(poly.sign_on(&[(variable.clone(), interval)]), Some(BoxSign::Positive | BoxSign::Negative))
}

/// The principal curvature on the side of N of a sphere, for which R = c + r·N/ρ: −1/r. `None` for other surfaces.
pub(super) fn of_sphere(derived: &Derived<'_>) -> Option<Poly> {
    let (normal, root) = (derived.normal?, derived.normal_root?);
    let [weight, coordinates @ ..] = derived.homogeneous;
    let at = |fractions: [i64; 2], poly: &Poly| {
        let place = |k: usize| -> Rational {
            let [first, last] = &derived.domain[k];
            first + (last - first) * ratio(fractions[k], 16)
        };
        let (u, v) = (place(0), place(1));
        let [of_u, of_v] = derived.parameters;
        poly.at(&[(of_u, &u), (of_v, &v)])
    };
    let both = |fractions: [i64; 2]| -> Option<[[Poly; 3]; 2]> {
        let values = |polys: &[Poly; 3], over: &Poly| -> Option<[Poly; 3]> {
            let over = at(fractions, over);
            if over.is_zero() || !over.is_constant() {
                return None;
            }
            let inverse = over.inverse();
            Some(polys.each_ref().map(|poly| at(fractions, poly) * &inverse))
        };
        Some([values(coordinates, weight)?, values(normal, root)?])
    };
    // The radius that three points agree on.
    let places = [[5, 4], [11, 3], [7, 13]].map(both);
    let [Some(first), Some(second), Some(third)] = &places else { return None };
    let differences = |to: &[[Poly; 3]; 2]| -> Vec<(Poly, Poly)> {
        (0..3).map(|i| (&to[0][i] - &first[0][i], &to[1][i] - &first[1][i])).collect()
    };
    let known = [second, third].map(differences).concat();
    let (of_point, of_normal) = known.iter().find(|(_, of_normal)| !of_normal.is_zero())?;
    let radius = of_point * &of_normal.inverse();
    if radius.is_zero() || known.iter().any(|(point, normal)| *point != normal * &radius) {
        return None;
    }
    let over = weight * root;
    let is_center = |(x, n): (&Poly, &Poly)| {
        let rest = x * root - &radius * n * weight;
        rest.is_zero() || rest.number_quotient(&over).is_some()
    };
    coordinates.iter().zip(normal).all(is_center).then(|| -radius.inverse())
}
