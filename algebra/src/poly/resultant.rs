//! Resultants.

use super::Poly;
use super::gcd::exact_quotient;
use super::ring::Variable;

impl Poly {
    /// The resultant of two polynomials in `variable`, the determinant of Sylvester's matrix: a polynomial in the other
    /// variables, which vanishes where both have a common zero or both leading coefficients vanish.
    ///
    /// It is zero if one of the two is zero. Contents are split off, then the subresultant polynomial remainder sequence
    /// of Collins and Brown runs (Cohen, *A Course in Computational Algebraic Number Theory*, Algorithm 3.3.7): all
    /// divisions are exact, and coefficients grow only as the subresultants do. Complexity: O(mn) products and exact
    /// divisions of coefficients for the degrees m and n. Interpolated modular resultants (Collins, *The calculation of
    /// multivariate polynomial resultants*, 1971) would gain where both are large; those that occur are small.
    ///
    /// ```
    /// use hodograph_algebra::{Poly, Variable};
    /// let (x, y) = (Variable::new(0, "x"), Poly::variable(&Variable::new(1, "y")));
    /// let f = Poly::variable(&x).pow(2) - &y;
    /// let g = Poly::variable(&x) - Poly::integer(3);
    /// assert_eq!(f.resultant(&g, &x), Poly::integer(9) - y);
    /// ```
    #[must_use]
    pub fn resultant(&self, other: &Poly, variable: &Variable) -> Poly {
        if self.is_zero() || other.is_zero() {
            return Poly::zero();
        }
        let (a_content, b_content) = (self.content_in(variable), other.content_in(variable));
        let mut a = exact_quotient(self, &a_content).coefficients(variable);
        let mut b = exact_quotient(other, &b_content).coefficients(variable);
        let (m, n) = (degree(&a), degree(&b));
        let contents = a_content.pow(n) * b_content.pow(m);
        let mut negative = false;
        if m < n {
            (a, b) = (b, a);
            negative = m % 2 == 1 && n % 2 == 1;
        }
        let (mut scale, mut height) = (Poly::one(), Poly::one());
        while b.len() > 1 {
            let (m, n) = (degree(&a), degree(&b));
            negative ^= m % 2 == 1 && n % 2 == 1;
            let divisor = &scale * height.pow(m - n);
            let remainder = pseudo_remainder(&a, &b);
            if remainder.is_empty() {
                return Poly::zero();
            }
            a = b;
            b = remainder.iter().map(|coefficient| exact_quotient(coefficient, &divisor)).collect();
            scale = leading(&a).clone();
            height = ratio_of_powers(&scale, &height, m - n);
        }
        let last = ratio_of_powers(leading(&b), &height, degree(&a));
        let result = contents * last;
        if negative { -result } else { result }
    }
}

/// The degree of a nonzero polynomial that is given by its coefficients.
fn degree(coefficients: &[Poly]) -> u32 {
    // Degrees are exponents, which fit.
    (coefficients.len() - 1) as u32
}

fn leading(coefficients: &[Poly]) -> &Poly {
    &coefficients[coefficients.len() - 1]
}

/// base^exponent / height^(exponent − 1), which is a polynomial where it is used; `height` for the exponent zero.
fn ratio_of_powers(base: &Poly, height: &Poly, exponent: u32) -> Poly {
    match exponent {
        0 => height.clone(),
        _ => exact_quotient(&base.pow(exponent), &height.pow(exponent - 1)),
    }
}

/// The remainder r of lc(b)^(deg a − deg b + 1)·a modulo b, by coefficients without leading zeros; deg a ≥ deg b > 0.
fn pseudo_remainder(a: &[Poly], b: &[Poly]) -> Vec<Poly> {
    let mut rest = a.to_vec();
    for _ in 0..=a.len() - b.len() {
        let factor = rest.pop().unwrap_or_else(Poly::zero);
        let shift = rest.len() + 1 - b.len();
        for (i, coefficient) in rest.iter_mut().enumerate() {
            *coefficient = &*coefficient * leading(b);
            if i >= shift {
                *coefficient -= &factor * &b[i - shift];
            }
        }
    }
    while rest.last().is_some_and(Poly::is_zero) {
        rest.pop();
    }
    rest
}
