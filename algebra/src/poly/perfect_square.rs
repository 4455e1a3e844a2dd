//! The perfect-square test.

use super::Poly;

/// A polynomial as `unit · root² · odd`: what [`Poly::square_split`] gives.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SquareSplit {
    /// The factor without variables: a number of the field, zero only for the zero polynomial.
    pub unit: Poly,
    /// The largest polynomial whose square divides, normalized.
    pub root: Poly,
    /// What remains: squarefree, normalized, and 1 exactly if the polynomial is a square up to the unit.
    pub odd: Poly,
}

impl SquareSplit {
    /// Whether it is, up to a number, the square of a polynomial.
    #[must_use]
    pub fn is_square(&self) -> bool {
        self.odd.is_one() || self.unit.is_zero()
    }
}

impl Poly {
    /// Splits off the largest square: `self = unit · root² · odd` with `odd` squarefree.
    ///
    /// The factors of odd multiplicity in the squarefree decomposition are what keeps a polynomial from being a square;
    /// the square root of a real polynomial is rational over the real numbers exactly if `odd` is 1 and `unit` is
    /// positive.
    ///
    /// ```
    /// use hodograph_algebra::{Poly, Variable};
    /// let u = Poly::variable(&Variable::new(0, "u"));
    /// let split = ((&u + Poly::one()).pow(2) * &u * Poly::integer(3)).square_split();
    /// assert_eq!((split.unit, split.root, split.odd), (Poly::integer(3), &u + Poly::one(), u));
    /// ```
    #[must_use]
    pub fn square_split(&self) -> SquareSplit {
        let decomposition = self.squarefree();
        let (mut root, mut odd) = (Poly::one(), Poly::one());
        for (factor, multiplicity) in &decomposition.factors {
            root *= factor.pow(multiplicity / 2);
            if multiplicity % 2 == 1 {
                odd *= factor;
            }
        }
        SquareSplit { unit: decomposition.unit, root, odd }
    }
}
