//! The perfect-square test.

use super::Poly;
use super::images::Frame;
use crate::Int;
use crate::modular::field::PrimeField;
use crate::modular::lift::{Chinese, Modulo};
use crate::modular::multivariate::Multivariate;

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
    /// positive. Squares are found without that decomposition, from their roots modulo primes. Complexity: for a square with a
    /// root of n terms, O(n² log n) for each prime; else that of [`Poly::squarefree`].
    ///
    /// ```
    /// use hodograph_algebra::{Poly, Variable};
    /// let u = Poly::variable(&Variable::new(0, "u"));
    /// let split = ((&u + Poly::one()).pow(2) * &u * Poly::integer(3)).square_split();
    /// assert_eq!((split.unit, split.root, split.odd), (Poly::integer(3), &u + Poly::one(), u));
    /// ```
    #[must_use]
    pub fn square_split(&self) -> SquareSplit {
        if let Some(root) = self.root_up_to_number() {
            // The leading coefficient of the root is rational.
            let unit = self.leading_coefficient() * root.leading_coefficient().pow(2).inverse();
            return SquareSplit { unit: unit.pruned(), root, odd: Poly::one() };
        }
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

    /// The normalized polynomial of whose square it is a multiple by a number of the field, if there is one.
    ///
    /// The root with the leading coefficient 1 has that as its image modulo every prime where the leading coefficient does not
    /// vanish: no image, no root. The images are lifted, and the square of the result decides.
    fn root_up_to_number(&self) -> Option<Poly> {
        if self.is_constant() {
            return None;
        }
        let degrees = self.degrees();
        let positions: Vec<usize> = (0..degrees.len()).filter(|&i| degrees[i] > 0).collect();
        if degrees.iter().any(|degree| degree % 2 == 1) {
            return None;
        }
        let most: Vec<u32> = positions.iter().map(|&i| degrees[i]).collect();
        let frame = Frame::new([self, self], positions, &most);
        let terms = frame.terms(self);
        // Over the rationals a primitive polynomial is the square of one with integer coefficients, by Gauss's lemma. Else the
        // root with the leading coefficient 1 is looked for.
        let (leading, number) = if frame.is_rational() {
            (self.terms[0].coefficient.exact_sqrt()?, Poly::one())
        } else {
            (Int::ONE, self.primitive().leading_coefficient())
        };
        let mut fields = PrimeField::sequence();
        let mut known: Chinese<(u128, usize)> = Chinese::new();
        let mut before = None;
        loop {
            let splitting = frame.splitting(&mut fields);
            let field = splitting.field();
            let residues = terms.residues(&splitting);
            let scale = leading.modulo(field);
            let mut images: Vec<Multivariate> = Vec::new();
            for choice in 0..splitting.basis().len() {
                let image = terms.image_of(&splitting, choice, &residues);
                if image.leading_word() != terms.leading_word() {
                    break;
                }
                images.push(image.monic_root(field, frame.layout())?.scale(field, scale));
            }
            if images.len() < splitting.basis().len() || scale.is_zero() {
                continue;
            }
            known.absorb(field, &splitting.lift_coefficients(&images));
            let root = if frame.is_rational() {
                // Integers that one more prime does not change are very likely right.
                let values = known.symmetric();
                let stable = before.as_ref() == Some(&values);
                before = Some(values.clone());
                stable.then(|| frame.poly((values.into_iter().collect(), Int::ONE)))
            } else {
                known.reconstruct().map(|values| frame.poly(values))
            };
            if let Some(root) = root
                && &root * &root * &number == self.primitive()
            {
                return Some(root.normalized());
            }
        }
    }
}
