//! Polynomials and rational functions of one parameter.

use hodograph_algebra::{Poly, Variable};

/// A quotient of two polynomials of one parameter, without common factor.
#[derive(Clone, PartialEq, Debug)]
pub(super) struct Quotient {
    pub(super) numerator: Poly,
    /// Normalized: 1 if it is constant, a known polynomial if it is a multiple of one.
    pub(super) denominator: Poly,
}

impl Quotient {
    /// `numerator / denominator`, where the denominator is scaled to one of `preferred` if it can be.
    pub(super) fn new<'a>(
        numerator: &Poly,
        denominator: &Poly,
        preferred: impl IntoIterator<Item = &'a Poly>,
    ) -> Quotient {
        let common = numerator.gcd(denominator);
        let (Some(numerator), Some(denominator)) =
            (numerator.exact_div(&common), denominator.exact_div(&common))
        else {
            unreachable!("a greatest common divisor divides");
        };
        let preferred =
            preferred.into_iter().find_map(|poly| Some((denominator.number_quotient(poly)?, poly.clone())));
        let (factor, scaled) = preferred.unwrap_or_else(|| {
            let normal = denominator.normalized();
            (ratio_of(&denominator, &normal), normal)
        });
        Quotient { numerator: numerator * factor.inverse(), denominator: scaled }
    }

    /// The polynomial `numerator`.
    pub(super) fn polynomial(numerator: Poly) -> Quotient {
        Quotient { numerator, denominator: Poly::one() }
    }

    /// The derivative by `parameter`: (n'd − nd')/d², reduced. A denominator that is d or d² up to a number is scaled
    /// to it.
    pub(super) fn derivative(&self, parameter: &Variable, preferred: &[Poly]) -> Quotient {
        let (n, d) = (&self.numerator, &self.denominator);
        if d.is_one() {
            return Quotient::polynomial(n.derivative(parameter));
        }
        let numerator = n.derivative(parameter) * d - n * d.derivative(parameter);
        let square = d * d;
        Quotient::new(&numerator, &square, preferred.iter().chain([d, &square]))
    }

    pub(super) fn is_zero(&self) -> bool {
        self.numerator.is_zero()
    }
}

/// The number `a / b` for polynomials that are multiples of each other by one.
pub(super) fn ratio_of(a: &Poly, b: &Poly) -> Poly {
    a.leading_coefficient() * b.leading_coefficient().inverse()
}

/// Whether the polynomials are multiples of each other by a number.
pub(super) fn proportional(a: &Poly, b: &Poly) -> bool {
    !a.is_zero() && !b.is_zero() && a.number_quotient(b).is_some()
}

/// The coefficients of the remainder of `a` by `b` with respect to `parameter`: as many as the degree of `b`. The leading
/// coefficient of `b` is a number.
pub(super) fn remainder(a: &Poly, b: &Poly, parameter: &Variable) -> Vec<Poly> {
    let divisor = b.monic().coefficients(parameter);
    let degree = divisor.len() - 1;
    let mut rest = a.coefficients(parameter);
    while rest.len() > degree {
        let Some(leading) = rest.pop() else { break };
        if leading.is_zero() {
            continue;
        }
        let shift = rest.len() - degree;
        for (place, coefficient) in divisor[..degree].iter().enumerate() {
            rest[shift + place] = &rest[shift + place] - &(&leading * coefficient);
        }
    }
    rest.resize(degree, Poly::zero());
    rest
}

#[cfg(test)]
mod tests {
    use hodograph_algebra::{Poly, Variable, integer};

    use super::{Quotient, remainder};

    #[test]
    fn quotients_are_reduced_and_normalized() {
        let v = Variable::new(1, "v");
        let x = Poly::variable(&v);
        let sigma = x.pow(2) + Poly::integer(1);
        let known = [-&sigma];
        let quotient = Quotient::new(&(&sigma * &x).scale(&integer(-2)), &(&sigma * (&x - Poly::one())), &[]);
        assert_eq!(quotient.numerator, Poly::integer(-2) * &x);
        assert_eq!(quotient.denominator, &x - Poly::one());
        let quotient = Quotient::new(&x, &(Poly::integer(3) * &sigma), &known);
        assert_eq!(quotient.denominator, -&sigma);
        assert_eq!(&quotient.numerator * Poly::integer(-3), x);
        // (v/(1 + v²))' = (1 − v²)/(1 + v²)²
        let derivative = Quotient::new(&x, &sigma, &[]).derivative(&v, &[]);
        assert_eq!(derivative.numerator, Poly::one() - x.pow(2));
        assert_eq!(derivative.denominator, sigma.pow(2));
    }

    #[test]
    fn remainders_have_the_degree_of_the_divisor() {
        let v = Variable::new(1, "v");
        let x = Poly::variable(&v);
        let divisor = Poly::integer(2) * x.pow(2) + Poly::integer(2);
        assert_eq!(remainder(&x.pow(3), &divisor, &v), [Poly::zero(), Poly::integer(-1)]);
        assert_eq!(remainder(&Poly::one(), &divisor, &v), [Poly::one(), Poly::zero()]);
        assert_eq!(remainder(&x, &Poly::integer(5), &v), []);
    }
}
