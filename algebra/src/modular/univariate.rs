//! Dense polynomials in one variable over a prime field.

use super::field::{PrimeField, Residue};
use crate::budget;

/// A polynomial in one variable over F_p: coefficients by ascending degree, the last one nonzero.
///
/// The field is not stored; every operation gets it.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct Univariate {
    coefficients: Vec<Residue>,
}

impl Univariate {
    /// The polynomial with these coefficients, by ascending degree.
    pub(crate) fn new(mut coefficients: Vec<Residue>) -> Self {
        while coefficients.last().is_some_and(|leading| leading.is_zero()) {
            coefficients.pop();
        }
        Self { coefficients }
    }

    /// A constant.
    pub(crate) fn constant(value: Residue) -> Self {
        Self::new(vec![value])
    }

    /// The coefficients by ascending degree; none for zero.
    pub(crate) fn coefficients(&self) -> &[Residue] {
        &self.coefficients
    }

    /// Whether this is the zero polynomial.
    pub(crate) fn is_zero(&self) -> bool {
        self.coefficients.is_empty()
    }

    /// Whether this is constant (zero included).
    pub(crate) fn is_constant(&self) -> bool {
        self.coefficients.len() <= 1
    }

    /// The degree; zero for the zero polynomial too.
    pub(crate) fn degree(&self) -> usize {
        self.coefficients.len().saturating_sub(1)
    }

    /// The coefficient of the highest power; zero for the zero polynomial.
    pub(crate) fn leading(&self) -> Residue {
        self.coefficients.last().copied().unwrap_or_default()
    }

    /// The value at `point`, by Horner's rule.
    pub(crate) fn evaluate(&self, field: &PrimeField, point: Residue) -> Residue {
        self.coefficients
            .iter()
            .rev()
            .fold(Residue::ZERO, |value, &coefficient| field.add(field.mul(value, point), coefficient))
    }

    /// The polynomial times a constant.
    pub(crate) fn scale(&self, field: &PrimeField, factor: Residue) -> Self {
        Self::new(self.coefficients.iter().map(|&coefficient| field.mul(coefficient, factor)).collect())
    }

    /// The polynomial divided by its leading coefficient; zero stays zero.
    pub(crate) fn monic(&self, field: &PrimeField) -> Self {
        field.invert(self.leading()).map_or_else(Self::default, |inverse| self.scale(field, inverse))
    }

    /// The product, by the classical method.
    pub(crate) fn mul(&self, field: &PrimeField, other: &Self) -> Self {
        if self.is_zero() || other.is_zero() {
            return Self::default();
        }
        budget::spend((self.coefficients.len() * other.coefficients.len()) as u64);
        let mut product = vec![Residue::ZERO; self.coefficients.len() + other.coefficients.len() - 1];
        for (i, &a) in self.coefficients.iter().enumerate() {
            for (target, &b) in product[i..].iter_mut().zip(&other.coefficients) {
                *target = field.add(*target, field.mul(a, b));
            }
        }
        Self::new(product)
    }

    /// Quotient and remainder of the division by `divisor`, or `None` if that is zero.
    pub(crate) fn divide(&self, field: &PrimeField, divisor: &Self) -> Option<(Self, Self)> {
        let inverse = field.invert(divisor.leading())?;
        let length = divisor.coefficients.len();
        if self.coefficients.len() < length {
            return Some((Self::default(), self.clone()));
        }
        let steps = self.coefficients.len() - length + 1;
        budget::spend((steps * length) as u64);
        let mut remainder = self.coefficients.clone();
        let mut quotient = vec![Residue::ZERO; steps];
        for shift in (0..steps).rev() {
            let factor = field.mul(remainder[shift + length - 1], inverse);
            quotient[shift] = factor;
            for (target, &b) in remainder[shift..].iter_mut().zip(&divisor.coefficients) {
                *target = field.sub(*target, field.mul(factor, b));
            }
        }
        Some((Self::new(quotient), Self::new(remainder)))
    }

    /// The monic greatest common divisor; zero only of two zeros.
    ///
    /// Euclid's algorithm on pseudo-remainders, in O(mn) products for the degrees m and n: an inversion costs more than it saves at
    /// the degrees that occur, and so does all that is asymptotically faster.
    pub(crate) fn gcd(&self, field: &PrimeField, other: &Self) -> Self {
        let (mut high, mut low) = (self.coefficients.clone(), other.coefficients.clone());
        budget::spend((high.len() * low.len()) as u64);
        if high.len() < low.len() {
            (high, low) = (low, high);
        }
        while low.len() > 1 {
            pseudo_remainder(field, &mut high, &low);
            (high, low) = (low, high);
        }
        if low.is_empty() { Self::new(high).monic(field) } else { Self::constant(field.one()) }
    }
}

/// Replaces `high` by a nonzero multiple of its remainder modulo `low`, which is not constant.
fn pseudo_remainder(field: &PrimeField, high: &mut Vec<Residue>, low: &[Residue]) {
    let leading = low[low.len() - 1];
    while high.len() >= low.len() {
        let factor = high[high.len() - 1];
        let shift = high.len() - low.len();
        for coefficient in &mut high[..shift] {
            *coefficient = field.mul(*coefficient, leading);
        }
        for (target, &b) in high[shift..].iter_mut().zip(low) {
            *target = field.sub(field.mul(*target, leading), field.mul(factor, b));
        }
        while high.last().is_some_and(|leading| leading.is_zero()) {
            high.pop();
        }
    }
}

/// The interpolation on fixed, pairwise distinct points: the polynomials of Lagrange, once for many sets of values.
#[derive(Clone, Debug)]
pub(crate) struct Interpolation {
    /// For each point, the polynomial that is one there and zero at the others.
    basis: Vec<Univariate>,
}

impl Interpolation {
    /// Prepares n `points`, in O(n²); `None` if two of them are equal.
    pub(crate) fn new(field: &PrimeField, points: &[Residue]) -> Option<Self> {
        let linear = |point: Residue| Univariate::new(vec![field.neg(point), field.one()]);
        let one = Univariate::constant(field.one());
        let vanishing = points.iter().fold(one, |product, &point| product.mul(field, &linear(point)));
        let mut basis = Vec::with_capacity(points.len());
        for &point in points {
            let (quotient, _) = vanishing.divide(field, &linear(point))?;
            basis.push(quotient.scale(field, field.invert(quotient.evaluate(field, point))?));
        }
        Some(Self { basis })
    }

    /// The polynomial of degree below n that takes these n values, in O(n²).
    pub(crate) fn interpolate(&self, field: &PrimeField, values: &[Residue]) -> Univariate {
        let mut sum = vec![Residue::ZERO; self.basis.len()];
        budget::spend((self.basis.len() * self.basis.len()) as u64);
        for (polynomial, &value) in self.basis.iter().zip(values) {
            if !value.is_zero() {
                for (target, &coefficient) in sum.iter_mut().zip(&polynomial.coefficients) {
                    *target = field.add(*target, field.mul(value, coefficient));
                }
            }
        }
        Univariate::new(sum)
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn field() -> PrimeField {
        PrimeField::new(10_007).unwrap()
    }

    fn polynomial(coefficients: &[i64]) -> Univariate {
        Univariate::new(coefficients.iter().map(|&coefficient| field().residue(coefficient)).collect())
    }

    fn polynomials() -> impl Strategy<Value = Univariate> {
        prop::collection::vec(-3_i64..=3, 0..7).prop_map(|coefficients| polynomial(&coefficients))
    }

    #[test]
    fn small_gcds() {
        let field = field();
        let gcd = polynomial(&[-1, 0, 1]).gcd(&field, &polynomial(&[1, 2, 1]));
        assert_eq!(gcd, polynomial(&[1, 1]));
        assert_eq!(polynomial(&[]).gcd(&field, &polynomial(&[2, 4])), polynomial(&[5004, 1]));
        assert!(polynomial(&[]).gcd(&field, &polynomial(&[])).is_zero());
        assert_eq!(polynomial(&[5]).gcd(&field, &polynomial(&[])), polynomial(&[1]));
        assert_eq!(polynomial(&[1, 1]).divide(&field, &polynomial(&[])), None);
        assert!(Interpolation::new(&field, &[field.one(), field.one()]).is_none());
    }

    proptest! {
        #[test]
        fn division_recombines(a in polynomials(), b in polynomials()) {
            let field = field();
            prop_assume!(!b.is_zero());
            let (quotient, remainder) = a.divide(&field, &b).unwrap();
            prop_assert!(remainder.is_zero() || remainder.degree() < b.degree());
            let product = quotient.mul(&field, &b);
            for point in (0..20).map(|point| field.residue(point)) {
                let sum = field.add(product.evaluate(&field, point), remainder.evaluate(&field, point));
                prop_assert_eq!(sum, a.evaluate(&field, point));
            }
        }

        #[test]
        fn gcd_is_common_and_greatest(a in polynomials(), b in polynomials(), g in polynomials()) {
            let field = field();
            prop_assume!(!a.is_zero() && !b.is_zero() && !g.is_zero());
            let (x, y) = (a.mul(&field, &g), b.mul(&field, &g));
            let gcd = x.gcd(&field, &y);
            let (x_rest, x_remainder) = x.divide(&field, &gcd).unwrap();
            let (y_rest, y_remainder) = y.divide(&field, &gcd).unwrap();
            prop_assert!(x_remainder.is_zero() && y_remainder.is_zero());
            prop_assert!(x_rest.gcd(&field, &y_rest).is_constant());
            prop_assert!(gcd.divide(&field, &g).unwrap().1.is_zero());
        }

        #[test]
        fn interpolation_inverts_evaluation(a in polynomials()) {
            let field = field();
            let points: Vec<_> = (1..10).map(|point| field.residue(point * point)).collect();
            let values: Vec<_> = points.iter().map(|&point| a.evaluate(&field, point)).collect();
            let interpolation = Interpolation::new(&field, &points).unwrap();
            prop_assert_eq!(interpolation.interpolate(&field, &values), a);
        }
    }
}
