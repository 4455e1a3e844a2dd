//! Polynomials as products, for people.

use hodograph_algebra::{Homogeneous, Poly, Variable};

/// A number and powers of polynomials whose product a polynomial is.
#[derive(Clone, Debug)]
pub(super) struct Factors {
    /// The number.
    pub(super) unit: Poly,
    /// The others, not constant.
    pub(super) factors: Vec<(Poly, u32)>,
}

impl Factors {
    /// The weight by the factors that the formula's denominators supply.
    pub(super) fn of_weight(homogeneous: &Homogeneous) -> Factors {
        let weight = &homogeneous.coordinates()[0];
        let factors = homogeneous.weight_factors().to_vec();
        let product: Poly = factors.iter().map(|(factor, exponent)| factor.pow(*exponent)).product();
        match weight.exact_div(&product) {
            Some(unit) if unit.is_constant() => Factors { unit, factors }.with_rational_unit(),
            _ => Factors::of(weight, homogeneous.parameters()),
        }
    }

    /// A polynomial with the factors split off that depend on one parameter alone, and with its content before it.
    ///
    /// Both are contents, that is gcds of coefficients; they are given with their multiplicities.
    pub(super) fn of(poly: &Poly, parameters: &[Variable; 2]) -> Factors {
        if poly.is_constant() {
            return Factors { unit: poly.clone(), factors: Vec::new() };
        }
        let mut rest = poly.clone();
        let mut factors = Vec::new();
        for parameter in parameters {
            let content = rest.content_in(parameter);
            if let (false, Some(quotient)) = (content.is_constant(), rest.exact_div(&content)) {
                let decomposition = content.squarefree();
                factors.extend(decomposition.factors);
                rest = quotient * decomposition.unit;
            }
        }
        if rest.is_constant() {
            return Factors { unit: rest, factors }.with_rational_unit();
        }
        factors.push((rest.primitive(), 1));
        Factors { unit: Poly::constant(rest.content().clone()), factors }
    }

    /// The same product with an irrational unit multiplied into the longest of the simple factors: over a number field that
    /// is how the formula has it, mostly.
    fn with_rational_unit(mut self) -> Factors {
        if self.unit.to_rational().is_some() {
            return self;
        }
        let simple = self.factors.iter_mut().filter(|(_, exponent)| *exponent == 1);
        if let Some((factor, _)) = simple.max_by_key(|(factor, _)| factor.terms().len()) {
            let product = &*factor * &self.unit;
            *factor = product.primitive();
            self.unit = Poly::constant(product.content().clone());
        }
        self
    }
}

#[cfg(test)]
mod tests {
    use hodograph_algebra::{integer, ratio};

    use super::*;

    fn product(factors: &Factors) -> Poly {
        factors
            .factors
            .iter()
            .fold(factors.unit.clone(), |all, (factor, exponent)| all * factor.pow(*exponent))
    }

    #[test]
    fn factors_multiply_to_the_polynomial() {
        let parameters = [Variable::new(0, "u"), Variable::new(1, "v")];
        let [u, v] = parameters.each_ref().map(Poly::variable);
        let root = Poly::sqrt_of(&integer(2));
        let f = (&u + Poly::one()).pow(2)
            * (v.pow(2) + &root)
            * (&u * &v + Poly::integer(3)).scale(&ratio(-2, 3));
        let split = Factors::of(&f, &parameters);
        assert_eq!(product(&split), f);
        assert_eq!(split.factors.len(), 3);
        assert_eq!(split.factors[0].0.to_string(), "v^2 + sqrt2");
        assert_eq!(split.factors[1], (u + Poly::one(), 2));
        for poly in [Poly::zero(), root, v] {
            assert_eq!(product(&Factors::of(&poly, &parameters)), poly);
        }
    }
}
