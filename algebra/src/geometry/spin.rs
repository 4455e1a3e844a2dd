//! Rational rotations with a given spin.

use std::collections::BTreeMap;
use std::fmt;

use crate::{Complex, Fraction, Poly, Rational, Variable, budget, integer, ratio};

/// Why no rational rotation has a given spin: see [`Rotation::with_spin`].
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum SpinError {
    /// The spin has a pole that is not simple.
    MultiplePole {
        /// The factor of the denominator that vanishes there.
        factor: Box<Poly>,
    },
    /// The spin does not vanish at infinity.
    NotProper,
    /// At the zeros of a factor of the denominator the residues of 2·I·h are not integers.
    Residues {
        /// The factor, of the function that was decided.
        factor: Box<Poly>,
        /// The polynomial in `r` whose zeros are the squares of these residues.
        squares: Box<Poly>,
        /// The values of the symbols for which they are those; nothing without symbols.
        at: BTreeMap<Variable, Rational>,
    },
    /// No values of the symbols were found that tell.
    Undecided,
}

impl fmt::Display for SpinError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            SpinError::MultiplePole { factor } => write!(f, "{factor} divides the denominator of h twice"),
            SpinError::NotProper => {
                f.write_str("the degree of the numerator of h is not below that of its denominator")
            }
            SpinError::Residues { factor, squares, at } => {
                write!(
                    f,
                    "at the zeros of {factor} the residues of 2*I*h are not integers: their squares r are the zeros of \
                     {squares}"
                )?;
                if at.is_empty() {
                    return Ok(());
                }
                let values: Vec<String> =
                    at.iter().map(|(symbol, value)| format!("{symbol} = {value}")).collect();
                write!(f, ", where {}, and so for general values", values.join(", "))
            }
            SpinError::Undecided => f.write_str("no values of the symbols were found that tell"),
        }
    }
}

impl std::error::Error for SpinError {}

/// A rotation of the plane by the angle `2·arg W`, for a polynomial `W = a + I·b` with coprime `a` and `b`.
///
/// Its cosine and sine are rational, and every rational rotation is of this form (Hilbert's Theorem 90: the polynomial
/// `W = 1 + cos + I·sin`, up to a real factor).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Rotation {
    /// The polynomial `W`.
    pub polynomial: Complex,
}

impl Rotation {
    /// The rotation for which `Im(conj(W)·W')/|W|² = h`, half the rate at which it turns, with `W > 0` at `start`; it is the
    /// only one up to the choice of its beginning.
    ///
    /// Over the complex numbers `2·I·h = W'/W − W̄'/W̄ = Σ m_z (1/(v − z) − 1/(v − z̄))`, the sum over the zeros `z` of `W`
    /// with their multiplicities. So there is one exactly if `h = N/D` vanishes at infinity, has simple poles, and all
    /// residues `2·I·N/D'` of `2·I·h` are integers. The candidates for these come from the resultant of D and `N − t·D'`, as in
    /// the method of Rothstein and Trager for integrals; that the zeros of `D_m = gcd(D, 4N² + m²D'²)`, at which the residues are
    /// ±m, are all zeros of D decides. `W` is the product of the `gcd(D_m, 2N + I·m·D')ᵐ`, and that it has the spin h is
    /// checked.
    ///
    /// Symbols are constants: residues that are integers stay what they are where symbols change, so that values for which the
    /// poles stay simple and the residues are no integers refute for general values.
    ///
    /// # Errors
    /// [`SpinError`], which says what `h` lacks.
    ///
    /// # Example
    /// ```
    /// use hodograph_algebra::{Fraction, Poly, Rotation, Variable};
    /// let v = Variable::new(1, "v");
    /// let x = Poly::variable(&v);
    /// let over = |n: i64| Fraction::new(Poly::integer(n), [(x.pow(2) + Poly::one(), 1)]);
    /// let rotation = Rotation::with_spin(&over(1), &v, &Poly::one()).unwrap();
    /// assert_eq!(rotation.polynomial.to_string(), "v + 1 + I*(v - 1)");
    /// let twice = Rotation::with_spin(&over(-2), &v, &Poly::one()).unwrap();
    /// assert_eq!(twice.polynomial.to_string(), "2*v + I*(-v^2 + 1)");
    /// let half = Fraction::new(Poly::one(), [(x.pow(2) + Poly::integer(4), 1)]);
    /// assert_eq!(
    ///     Rotation::with_spin(&half, &v, &Poly::one()).unwrap_err().to_string(),
    ///     "at the zeros of v^2 + 4 the residues of 2*I*h are not integers: their squares r are the zeros of 4*r - 1",
    /// );
    /// ```
    pub fn with_spin(h: &Fraction, variable: &Variable, start: &Poly) -> Result<Rotation, SpinError> {
        let h = h.lowest_terms();
        let (numerator, denominator) = (h.numerator().clone(), h.denominator());
        if numerator.is_zero() {
            return Ok(Rotation { polynomial: Complex::one() });
        }
        for (factor, multiplicity) in denominator.squarefree().factors {
            if multiplicity > 1 && factor.contains(variable) {
                return Err(SpinError::MultiplePole { factor: Box::new(factor) });
            }
        }
        if numerator.degree(variable) >= denominator.degree(variable) {
            return Err(SpinError::NotProper);
        }
        let spin = Spin { derivative: denominator.derivative(variable), numerator, denominator };
        let parts = budget::doing("the residues of a spin", || spin.parts(variable))?;
        let polynomial = parts.iter().fold(Complex::one(), |product, (m, zeros)| product * zeros.pow(*m));
        let rotation = Rotation::begun(&polynomial, variable, start);
        if rotation.spin(variable) == h { Ok(rotation) } else { Err(SpinError::Undecided) }
    }

    /// The rotation with this polynomial up to constant and real factors, with `W > 0` at `start`.
    pub(crate) fn begun(polynomial: &Complex, variable: &Variable, start: &Poly) -> Rotation {
        Rotation { polynomial: begun(polynomial, variable, start) }
    }

    /// Half the rate at which it turns: `Im(conj(W)·W')/|W|²`.
    #[must_use]
    pub fn spin(&self, variable: &Variable) -> Fraction {
        let w = &self.polynomial;
        let turning = &w.re * w.im.derivative(variable) - w.re.derivative(variable) * &w.im;
        let norm = w.norm2();
        if norm.is_constant() { turning.into() } else { Fraction::new(turning, [(norm, 1)]) }
    }
}

/// The polynomial times the conjugate of its value at `start`, without real factors.
fn begun(polynomial: &Complex, variable: &Variable, start: &Poly) -> Complex {
    let at = |part: &Poly| part.substitute(variable, start);
    let value = Complex::new(at(&polynomial.re), at(&polynomial.im));
    let turned = if value.is_zero() { polynomial.clone() } else { polynomial * &value.conj() };
    let common = turned.re.gcd(&turned.im);
    let divided = |part: &Poly| part.exact_div(&common).unwrap_or_else(|| part.clone());
    let parts = [divided(&turned.re), divided(&turned.im)];
    let scale = Poly::common_content(&parts).recip();
    let [re, im] = parts.map(|part| part.scale(&scale));
    let negative = re.substitute(variable, start).leading_coefficient().sign().is_lt();
    let result = Complex::new(re, im);
    if negative { -result } else { result }
}

/// A function `N/D` in lowest terms with simple poles.
struct Spin {
    numerator: Poly,
    denominator: Poly,
    derivative: Poly,
}

impl Spin {
    /// The factor of the denominator at whose zeros the residues of `2·I·N/D` are ±m, and the complex polynomial whose zeros
    /// are those with the residue m.
    fn zeros_with_residue(&self, m: u32, variable: &Variable) -> (Poly, Complex) {
        let twice = self.numerator.scale(&integer(2));
        let multiple = self.derivative.scale(&integer(i64::from(m)));
        let pair = self.denominator.gcd(&(&twice * &twice + &multiple * &multiple)).primitive_in(variable);
        if !pair.contains(variable) {
            return (Poly::one(), Complex::one());
        }
        let zeros = Complex::from(pair.clone()).gcd(&Complex::new(twice, multiple), variable);
        (pair, zeros)
    }

    /// The residues m > 0 of `2·I·N/D`, if all are integers, each with the polynomial whose zeros have it.
    fn parts(&self, variable: &Variable) -> Result<Vec<(u32, Complex)>, SpinError> {
        let parts = [&self.numerator, &self.denominator];
        let mut symbols: Vec<Variable> = parts.iter().flat_map(|part| part.occurring_variables()).collect();
        symbols.retain(|symbol| symbol != variable);
        symbols.sort();
        symbols.dedup();
        for trial in 0..24 {
            let at = sample(&symbols, trial);
            let values = at.iter().map(|(symbol, value)| (symbol.clone(), Poly::constant(value.clone())));
            let values = values.collect();
            let numerator = self.numerator.evaluate(&values);
            let denominator = self.denominator.evaluate(&values);
            // The poles must be as many, simple and in the same places.
            if denominator.degree(variable) != self.denominator.degree(variable) {
                continue;
            }
            let derivative = denominator.derivative(variable);
            if !denominator.gcd(&derivative).is_constant() || !numerator.gcd(&denominator).is_constant() {
                continue;
            }
            let special = Spin { numerator, denominator, derivative };
            let residues = special.residues(variable).map_err(|parts| {
                let [factor, squares] = parts.map(Box::new);
                SpinError::Residues { factor, squares, at }
            })?;
            // Residues that are integers by chance are found out by the degrees.
            let pairs: Vec<_> = residues.iter().map(|&m| self.zeros_with_residue(m, variable)).collect();
            let found: u32 = pairs.iter().filter_map(|(pair, _)| pair.degree(variable)).sum();
            if Some(found) == self.denominator.degree(variable) {
                return Ok(residues.into_iter().zip(pairs.into_iter().map(|(_, zeros)| zeros)).collect());
            }
        }
        Err(SpinError::Undecided)
    }

    /// The absolute values of the residues where all coefficients are numbers, if they are integers; or else the factor of the
    /// denominator at whose zeros they are not, with the polynomial of their squares.
    fn residues(&self, variable: &Variable) -> Result<Vec<u32>, Box<[Poly; 2]>> {
        let unknown = Variable::new(Variable::SYMBOL, "r");
        // With t = r'/2 the zeros are r' = −I·residue; those of the product with r' and −r' come in pairs, and as a
        // polynomial in r'² it has the zeros −residue².
        let slope = Poly::variable(&unknown).scale(&ratio(1, 2)) * &self.derivative;
        let resultant = |moved: Poly| self.denominator.resultant(&moved, variable);
        let product = resultant(&self.numerator - &slope) * resultant(&self.numerator + &slope);
        let even = product.coefficients(&unknown).into_iter().step_by(2).enumerate();
        let squares = even.map(|(index, part)| if index.is_multiple_of(2) { part } else { -part });
        let squares = Poly::from_coefficients(&unknown, &squares.collect::<Vec<Poly>>());
        let (mut found, mut other, mut rest) = (Vec::new(), Poly::one(), self.denominator.clone());
        for (factor, _) in squares.squarefree().factors {
            let roots = factor.real_roots(&unknown).unwrap_or_default();
            let mut left = factor;
            for root in roots.iter().filter_map(|root| root.to_rational()) {
                let Some(m) = integer_root(&root) else { continue };
                left = left.exact_div(&(Poly::variable(&unknown) - Poly::constant(root))).unwrap_or(left);
                let (pair, _) = self.zeros_with_residue(m, variable);
                rest = rest.exact_div(&pair).unwrap_or(rest);
                found.push(m);
            }
            other *= left;
        }
        if rest.contains(variable) {
            Err(Box::new([rest.normalized(), other.normalized()]))
        } else {
            Ok(found)
        }
    }
}

/// The positive integer whose square is given.
fn integer_root(square: &Rational) -> Option<u32> {
    let root = crate::rational_sqrt(square).filter(Rational::is_integer)?;
    u32::try_from(root.to_integer().small()?).ok().filter(|root| *root > 0)
}

/// Values of symbols that meet no simple relation.
fn sample(symbols: &[Variable], trial: i64) -> BTreeMap<Variable, Rational> {
    let value = |seed: i64| ratio(3 + 7 * seed + trial * seed * seed, 5 + 2 * seed + trial);
    (1_i64..).zip(symbols).map(|(seed, symbol)| (symbol.clone(), value(seed))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn v() -> Variable {
        Variable::new(1, "v")
    }

    /// The polynomial with these roots and the leading coefficient 1 + 2 I.
    fn with_roots(roots: &[(Poly, i64)]) -> Complex {
        let factor = |(re, im): &(Poly, i64)| Complex::new(Poly::variable(&v()) - re, Poly::integer(-im));
        let unit = Complex::new(Poly::one(), Poly::integer(2));
        roots.iter().map(factor).fold(unit, |product, factor| product * factor)
    }

    /// That the rotation by `2·arg w` is found again, up to its beginning.
    fn is_found(w: &Complex) {
        let given = Rotation { polynomial: w.clone() };
        let h = given.spin(&v());
        let found = Rotation::with_spin(&h, &v(), &Poly::integer(5)).unwrap();
        assert_eq!(found.spin(&v()), h);
        // conj(w)·W does not turn.
        let relative = &w.conj() * &found.polynomial;
        let at = |part: &Poly, value: i64| part.substitute(&v(), &Poly::integer(value));
        assert!(found.polynomial.im.substitute(&v(), &Poly::integer(5)).is_zero());
        let (re, im) = (at(&relative.re, 5), at(&relative.im, 5));
        assert_eq!(&relative.re * &im, &relative.im * &re);
    }

    #[test]
    fn rotations_are_found_from_their_spin() {
        let [a, b] = [2, 3].map(|n| Poly::sqrt_of(&integer(n)));
        let n = Poly::integer;
        is_found(&with_roots(&[]));
        is_found(&with_roots(&[(n(0), 1)]));
        is_found(&with_roots(&[(n(0), 1), (n(0), 1), (n(0), 1), (n(2), -3)]));
        is_found(&with_roots(&[(n(1), 2), (n(1), -5), (n(4), 1), (n(4), 1)]));
        is_found(&with_roots(&[(a.clone(), 1), (b, -1), (a, 2)]));
        let c = Poly::variable(&Variable::new(Variable::SYMBOL, "c"));
        is_found(&with_roots(&[(c.clone(), 1), (c.pow(2), -2), (c, 1)]));
    }

    #[test]
    fn what_no_rotation_has_is_refused() {
        let x = Poly::variable(&v());
        let quadratic = x.pow(2) + Poly::one();
        let decide = |numerator: Poly, denominator: &Poly| {
            let h = Fraction::new(numerator, [(denominator.clone(), 1)]);
            Rotation::with_spin(&h, &v(), &Poly::zero()).unwrap_err().to_string()
        };
        assert!(
            decide(Poly::one(), &quadratic.pow(2)).contains("v^2 + 1 divides the denominator of h twice")
        );
        assert!(decide(x.pow(3), &quadratic).contains("not below"));
        assert!(decide(x.clone(), &quadratic).contains("their squares r are the zeros of r + 1"));
        assert!(decide(Poly::one(), &x).contains("zeros of r + 4"));
        // One good pair of poles and one bad one.
        let other = x.pow(2) + Poly::integer(2);
        let sum = &other + &quadratic;
        let message = decide(sum, &(&quadratic * &other));
        assert!(message.contains("at the zeros of v^2 + 2 the"), "{message}");
        assert!(message.contains("the zeros of 2*r - 1"), "{message}");
        // A residue with a real and an imaginary part.
        assert!(decide(&x + Poly::one(), &quadratic).contains("the zeros of r^2 + 4"));
        let c = Poly::variable(&Variable::new(Variable::SYMBOL, "c"));
        assert!(decide(c, &quadratic).contains("where c = 10/7, and so for general values"));
    }
}
