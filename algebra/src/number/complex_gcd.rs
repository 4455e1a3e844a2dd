//! Common divisors of complex polynomials.

use crate::{Complex, Poly, Variable, budget};

impl Complex {
    /// The greatest common divisor of two polynomials in `variable` with complex coefficients, up to a factor without
    /// `variable`: that of polynomials in one variable over the complex numbers of the field, or over the complex rational
    /// functions of the symbols. Real factors without `variable` are left out; zero only for two zeros.
    ///
    /// It is Euclid's algorithm: over numbers with monic remainders, with symbols with pseudo-remainders from which real
    /// contents are split off. Degrees here are those of preimages, so that growth does not matter.
    ///
    /// # Example
    /// ```
    /// use hodograph_algebra::{Complex, Poly, Variable};
    /// let v = Variable::new(1, "v");
    /// let x = Poly::variable(&v);
    /// let real = Complex::from(x.pow(2) + Poly::one());
    /// let other = Complex::new(x.pow(2), x.clone());
    /// assert_eq!(real.gcd(&other, &v).to_string(), "v + I");
    /// ```
    #[must_use]
    pub fn gcd(&self, other: &Complex, variable: &Variable) -> Complex {
        let numbers = [&self.re, &self.im, &other.re, &other.im]
            .iter()
            .all(|part| part.occurring_variables().iter().all(|occurring| occurring == variable));
        let normalized = |coefficients: Vec<Complex>| match coefficients.last() {
            Some(leading) if numbers => {
                let inverse = leading.inverse();
                coefficients.iter().map(|coefficient| coefficient * &inverse).collect()
            }
            _ => without_content(coefficients),
        };
        let mut a = normalized(coefficients(self, variable));
        let mut b = normalized(coefficients(other, variable));
        if a.len() < b.len() {
            (a, b) = (b, a);
        }
        while !b.is_empty() {
            let rest = normalized(pseudo_remainder(a, &b));
            (a, b) = (b, rest);
        }
        // The leading coefficient becomes real.
        let turned = match a.last() {
            Some(leading) if !leading.im.is_zero() => {
                let turn = leading.conj();
                without_content(a.iter().map(|coefficient| coefficient * &turn).collect())
            }
            _ => a,
        };
        polynomial(&turned, variable)
    }
}

/// The coefficients of the powers of `variable`, without leading zeros.
pub(crate) fn coefficients(poly: &Complex, variable: &Variable) -> Vec<Complex> {
    let (re, im) = (poly.re.coefficients(variable), poly.im.coefficients(variable));
    let at = |list: &[Poly], index: usize| list.get(index).cloned().unwrap_or_else(Poly::zero);
    (0..re.len().max(im.len())).map(|index| Complex::new(at(&re, index), at(&im, index))).collect()
}

/// The polynomial with these coefficients.
pub(crate) fn polynomial(coefficients: &[Complex], variable: &Variable) -> Complex {
    let part = |part: fn(&Complex) -> &Poly| {
        let parts: Vec<Poly> = coefficients.iter().map(|coefficient| part(coefficient).clone()).collect();
        Poly::from_coefficients(variable, &parts)
    };
    Complex::new(part(|z| &z.re), part(|z| &z.im))
}

/// The coefficients without their common real factor.
fn without_content(coefficients: Vec<Complex>) -> Vec<Complex> {
    let parts: Vec<Poly> = coefficients.iter().flat_map(|z| [z.re.clone(), z.im.clone()]).collect();
    let common = Poly::gcd_many(&parts);
    let number = Poly::common_content(&parts);
    if common.is_zero() {
        return coefficients;
    }
    let scale = number.recip();
    let divided = |part: &Poly| part.exact_div(&common).unwrap_or_else(|| part.clone()).scale(&scale);
    let split = coefficients.iter().map(|z| Complex::new(divided(&z.re), divided(&z.im)));
    split.collect()
}

/// The remainder of a multiple of `a` modulo `b`, by coefficients without leading zeros; `b` is not empty.
fn pseudo_remainder(mut a: Vec<Complex>, b: &[Complex]) -> Vec<Complex> {
    let Some(leading) = b.last() else { return a };
    while a.len() >= b.len() {
        budget::spend(a.len() as u64);
        let factor = a.pop().unwrap_or_else(Complex::zero);
        let shift = a.len() + 1 - b.len();
        for (index, coefficient) in a.iter_mut().enumerate() {
            *coefficient = &*coefficient * leading;
            if index >= shift {
                *coefficient = &*coefficient - &factor * &b[index - shift];
            }
        }
        while a.last().is_some_and(Complex::is_zero) {
            a.pop();
        }
    }
    a
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::integer;

    fn v() -> Variable {
        Variable::new(1, "v")
    }

    /// The polynomial with these roots, and the leading coefficient 2 − I.
    fn with_roots(roots: &[(i64, i64)]) -> Complex {
        let factor = |&(re, im): &(i64, i64)| {
            Complex::new(Poly::variable(&v()) - Poly::integer(re), Poly::integer(-im))
        };
        let unit = Complex::new(Poly::integer(2), Poly::integer(-1));
        roots.iter().map(factor).fold(unit, |product, factor| product * factor)
    }

    /// Whether both are multiples of each other by a factor without the variable.
    fn associated(a: &Complex, b: &Complex) -> bool {
        let [a, b] = [a, b].map(|z| coefficients(z, &v()));
        let (Some(p), Some(q)) = (a.last(), b.last()) else { return a.len() == b.len() };
        a.len() == b.len() && a.iter().zip(&b).all(|(x, y)| x * q == y * p)
    }

    #[test]
    fn common_roots_are_the_roots_of_the_divisor() {
        let roots = [(1, 2), (1, -2), (0, 1), (3, 0), (-1, 1), (0, 1)];
        for mask in 0..64_u32 {
            let chosen = |mask: u32| -> Vec<(i64, i64)> {
                (0..6).filter(|bit| mask >> bit & 1 == 1).map(|bit| roots[bit]).collect()
            };
            let others = [(7, 7), (-5, 3)];
            let a = with_roots(&[chosen(mask), others[..1].to_vec()].concat());
            let b = with_roots(&[chosen(mask), others[1..].to_vec()].concat());
            assert!(associated(&a.gcd(&b, &v()), &with_roots(&chosen(mask))), "{mask}");
        }
        assert!(Complex::zero().gcd(&Complex::zero(), &v()).is_zero());
        assert!(associated(&Complex::zero().gcd(&with_roots(&[(1, 1)]), &v()), &with_roots(&[(1, 1)])));
    }

    #[test]
    fn symbols_are_constants() {
        let c = Poly::variable(&Variable::new(Variable::SYMBOL, "c"));
        let x = Poly::variable(&v());
        // (v + I c), times v − 1 and times c·(v + 2 + I).
        let common = Complex::new(x.clone(), c.clone());
        let a = common.times_real(&(&x - Poly::one()));
        let b = &common * &Complex::new(&c * (&x + Poly::integer(2)), c.clone());
        assert_eq!(a.gcd(&b, &v()), common);
        let real = Complex::from((x.pow(2) + c.pow(2)).scale(&integer(3)));
        assert!(associated(&real.gcd(&b, &v()), &common));
    }
}
