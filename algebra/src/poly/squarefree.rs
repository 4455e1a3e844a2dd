//! Squarefree decomposition.

use super::gcd::{exact_quotient, split_monomial};
use super::ring::Variable;
use super::{Poly, Rational};

/// A polynomial as a product of powers of squarefree polynomials: `unit · Π factor^multiplicity`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Squarefree {
    /// The factor without variables: a number of the field, zero only for the zero polynomial.
    pub unit: Poly,
    /// Factors with their multiplicities: not constant, squarefree, [normalized](Poly::normalized) and pairwise coprime.
    /// Several of them may have the same multiplicity.
    pub factors: Vec<(Poly, u32)>,
}

impl Squarefree {
    /// The polynomial that was decomposed.
    #[must_use]
    pub fn product(&self) -> Poly {
        let powers = self.factors.iter().map(|(factor, multiplicity)| factor.pow(*multiplicity));
        powers.fold(self.unit.clone(), |product, power| product * power)
    }

    /// The product of all factors once each: the normalized polynomial without repeated factors that has the same zeros.
    #[must_use]
    pub fn radical(&self) -> Poly {
        self.factors.iter().fold(Poly::one(), |product, (factor, _)| product * factor)
    }
}

impl Poly {
    /// The squarefree decomposition over the number field.
    ///
    /// Monomials are split off; then, one variable after the other, the content is split off, and the primitive part is
    /// decomposed by Yun's algorithm (*On square-free decomposition algorithms*, 1976): as many gcds as the highest
    /// multiplicity.
    ///
    /// ```
    /// use hodograph_algebra::{Poly, Variable};
    /// let (u, v) = (Poly::variable(&Variable::new(0, "u")), Poly::variable(&Variable::new(1, "v")));
    /// let f = (&u + &v).pow(3) * &v * Poly::integer(-2);
    /// let decomposition = f.squarefree();
    /// assert_eq!(decomposition.unit, Poly::integer(-2));
    /// assert_eq!(decomposition.factors, [(v.clone(), 1), (u + v, 3)]);
    /// assert_eq!(decomposition.product(), f);
    /// ```
    #[must_use]
    pub fn squarefree(&self) -> Squarefree {
        if self.is_zero() {
            return Squarefree { unit: Poly::zero(), factors: Vec::new() };
        }
        let (exponents, mut rest) = split_monomial(self);
        let variables = self.ring.variables().iter().zip(exponents).filter(|(_, exponent)| *exponent > 0);
        let mut factors: Vec<(Poly, u32)> =
            variables.map(|(variable, exponent)| (Poly::variable(variable), exponent)).collect();
        while let Some(variable) = main_variable(&rest) {
            let content = rest.content_in(&variable);
            factors.extend(yun(&exact_quotient(&rest, &content), &variable));
            rest = content;
        }
        // Leading coefficients multiply, and those of the factors are rational.
        let leading = |(factor, multiplicity): &(Poly, u32)| factor.leading_coefficient().pow(*multiplicity);
        let scale = factors.iter().map(leading).filter_map(|value| value.to_rational()).product::<Rational>();
        let unit = self.leading_coefficient().scale(&scale.recip()).pruned();
        Squarefree { unit, factors }
    }
}

/// The variable of the lowest positive degree.
fn main_variable(poly: &Poly) -> Option<Variable> {
    poly.occurring_variables().into_iter().min_by_key(|variable| poly.degree(variable))
}

/// Yun's algorithm for a polynomial that is primitive with respect to `variable`.
fn yun(poly: &Poly, variable: &Variable) -> Vec<(Poly, u32)> {
    let derivative = poly.derivative(variable);
    let repeated = poly.gcd(&derivative);
    if repeated.is_one() {
        return vec![(poly.normalized(), 1)];
    }
    let mut factors = Vec::new();
    // Invariant: `product` is the product of all factors of multiplicity i and more, `rest` is the sum over them of
    // (multiplicity − i)·factor'·(product of the others).
    let mut product = exact_quotient(poly, &repeated);
    let mut rest = exact_quotient(&derivative, &repeated) - product.derivative(variable);
    let mut multiplicity = 1;
    while !product.is_constant() {
        let factor = product.gcd(&rest);
        product = exact_quotient(&product, &factor);
        rest = exact_quotient(&rest, &factor) - product.derivative(variable);
        if !factor.is_one() {
            factors.push((factor, multiplicity));
        }
        multiplicity += 1;
    }
    factors
}
