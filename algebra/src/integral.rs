//! Integrals of rational functions: their rational parts, exactly.

use crate::poly::gcd::exact_quotient;
use crate::{Fraction, Poly, Variable, budget, ratio};

/// The integral of a rational function `f` of one variable: `f = rational' + remainder`.
///
/// # Example
/// `∫ (v² + 3)/(v² + 1)² dv = v/(v² + 1) + 2·arctan v`:
/// ```
/// use hodograph_algebra::{Fraction, Poly, Variable};
/// let v = Variable::new(1, "v");
/// let square = Poly::variable(&v).pow(2);
/// let f = Fraction::new(&square + Poly::integer(3), [(square + Poly::one(), 2)]);
/// let integral = f.integral(&v);
/// assert_eq!(integral.rational.to_string(), "v/(v^2 + 1)");
/// assert_eq!(integral.remainder.to_string(), "2/(v^2 + 1)");
/// assert!(!integral.is_rational());
/// ```
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Integral {
    /// The rational part, up to a constant.
    pub rational: Fraction,
    /// What has no rational integral: zero, or a proper fraction with a squarefree denominator, the integral of which is
    /// a sum of logarithms and arctangents.
    pub remainder: Fraction,
}

impl Integral {
    /// Whether the integral is a rational function.
    #[must_use]
    pub fn is_rational(&self) -> bool {
        self.remainder.is_zero()
    }
}

impl Fraction {
    /// The integral by `variable`, split into its rational part and a remainder without one; all other variables are
    /// constants of general value.
    ///
    /// Hermite's reduction in its linear form (Bronstein, *Symbolic Integration I*, section 2.2): after the polynomial
    /// part each squarefree factor `V` of the denominator `U·Vᵐ` is lowered from `m` to 1, by `m − 1` linear systems of
    /// at most `2·deg V − 1` equations, solved without fractions.
    #[must_use]
    pub fn integral(&self, variable: &Variable) -> Integral {
        let lowest = self.lowest_terms();
        if !lowest.factors().iter().any(|(factor, _)| factor.contains(variable)) {
            let rational = Fraction::new(lowest.numerator().integral(variable), lowest.factors().to_vec());
            return Integral { rational, remainder: Fraction::zero() };
        }
        budget::doing("the integral of a rational function", || Reduction::new(&lowest, variable).run())
    }
}

/// A fraction `scale · numerator / Π powers` on its way to a squarefree denominator, and what was integrated so far.
struct Reduction<'a> {
    variable: &'a Variable,
    rational: Fraction,
    /// Free of the variable.
    scale: Fraction,
    numerator: Poly,
    /// Pairwise coprime and squarefree, primitive in the variable.
    powers: Vec<(Poly, u32)>,
}

impl<'a> Reduction<'a> {
    fn new(integrand: &Fraction, variable: &'a Variable) -> Reduction<'a> {
        let decomposition = integrand.denominator().squarefree();
        let mut scale = vec![(decomposition.unit, 1)];
        let mut powers = Vec::new();
        for (factor, exponent) in decomposition.factors {
            let content = factor.content_in(variable);
            let primitive = exact_quotient(&factor, &content);
            scale.push((content, exponent));
            if primitive.contains(variable) {
                powers.push((primitive, exponent));
            } else {
                scale.push((primitive, exponent));
            }
        }
        let scale = Fraction::new(Poly::one(), scale);
        let numerator = integrand.numerator().clone();
        Reduction { variable, rational: Fraction::zero(), scale, numerator, powers }
    }

    fn run(mut self) -> Integral {
        self.integrate_polynomial_part();
        for place in 0..self.powers.len() {
            while self.powers[place].1 > 1 && !self.numerator.is_zero() {
                self.lower(place);
            }
        }
        let remainder = &Fraction::new(self.numerator, self.powers) * &self.scale;
        Integral { rational: self.rational.lowest_terms(), remainder: remainder.lowest_terms() }
    }

    fn integrate_polynomial_part(&mut self) {
        let denominator: Poly = self.powers.iter().map(|(factor, exponent)| factor.pow(*exponent)).product();
        let division = pseudo_divide(&self.numerator, &denominator, self.variable);
        let scale = &self.scale * &Fraction::new(Poly::one(), [(division.multiplier, 1)]);
        self.rational =
            &self.rational + &(&scale * &Fraction::from(division.quotient.integral(self.variable)));
        self.set(scale, division.remainder);
    }

    /// Lowers the exponent `m` of the factor `V`: with `B·U·V' ≡ −A/(m − 1)` modulo `V` and `deg B < deg V`
    /// `A/(U·Vᵐ) = (B/Vᵐ⁻¹)' + ((A + (m − 1)·B·U·V')/V − B'·U)/(U·Vᵐ⁻¹)`.
    fn lower(&mut self, place: usize) {
        let (factor, exponent) = self.powers[place].clone();
        self.powers[place].1 -= 1;
        if let Some(quotient) = self.numerator.exact_div(&factor) {
            self.numerator = quotient;
            return;
        }
        let others = self.powers.iter().enumerate().filter(|(other, _)| *other != place);
        let others: Poly = others.map(|(_, (other, exponent))| other.pow(*exponent)).product();
        let slope = &others * factor.derivative(self.variable);
        let modulo = |poly: &Poly| pseudo_divide(poly, &factor, self.variable);
        let (reduced_slope, target) = (modulo(&slope), modulo(&self.numerator));
        // quotient · slope ≡ determinant · numerator, both with the multipliers of the pseudo-divisions.
        let (quotient, determinant) =
            modular_quotient(&target.remainder, &reduced_slope.remainder, &factor, self.variable);
        let quotient = quotient * reduced_slope.multiplier;
        let determinant = determinant * target.multiplier;
        let times = i64::from(exponent) - 1;
        let integrated = quotient.scale(&ratio(-1, times));
        let lower = [(determinant.clone(), 1), (factor.clone(), exponent - 1)];
        let part = Fraction::new(integrated.clone(), lower);
        self.rational = &self.rational + &(&part * &self.scale);
        let divisible = &determinant * &self.numerator - &quotient * &slope;
        let rest = exact_quotient(&divisible, &factor) - integrated.derivative(self.variable) * others;
        let scale = &self.scale * &Fraction::new(Poly::one(), [(determinant, 1)]);
        self.set(scale, rest);
    }

    /// Sets what is left to integrate, without common factors of numerator and scale.
    fn set(&mut self, scale: Fraction, numerator: Poly) {
        if numerator.is_zero() {
            (self.scale, self.numerator) = (Fraction::one(), Poly::zero());
            return;
        }
        let content = numerator.content_in(self.variable);
        self.numerator = exact_quotient(&numerator, &content);
        self.scale = (&scale * &Fraction::from(content)).lowest_terms();
    }
}

/// `multiplier · dividend = quotient · divisor + remainder`, the degree of the remainder below that of the divisor.
struct PseudoDivision {
    multiplier: Poly,
    quotient: Poly,
    remainder: Poly,
}

/// The division of polynomials in `variable` whose coefficients form no field; the multiplier is a power of the divisor's
/// leading coefficient.
fn pseudo_divide(dividend: &Poly, divisor: &Poly, variable: &Variable) -> PseudoDivision {
    let divisor = divisor.coefficients(variable);
    let mut rest = dividend.coefficients(variable);
    let (mut multiplier, mut quotient) = (Poly::one(), Vec::new());
    let Some((leading, lower)) = divisor.split_last() else {
        return PseudoDivision { multiplier, quotient: Poly::zero(), remainder: dividend.clone() };
    };
    while rest.len() > lower.len() {
        let top = rest.pop().unwrap_or_else(Poly::zero);
        if top.is_zero() {
            quotient.insert(0, top);
            continue;
        }
        let shift = rest.len() - lower.len();
        for (power, coefficient) in rest.iter_mut().enumerate() {
            *coefficient = &*coefficient * leading;
            if power >= shift {
                *coefficient -= &top * &lower[power - shift];
            }
        }
        for coefficient in &mut quotient {
            *coefficient = &*coefficient * leading;
        }
        quotient.insert(0, top);
        multiplier *= leading;
    }
    PseudoDivision {
        multiplier,
        quotient: Poly::from_coefficients(variable, &quotient),
        remainder: Poly::from_coefficients(variable, &rest),
    }
}

/// `b` and a nonzero `d` free of the variable with `b·divisor ≡ d·dividend` modulo `modulus`, where divisor and modulus
/// are coprime, both dividend and divisor are of lower degree than the modulus, and so is `b`.
///
/// The unknowns are the coefficients of `b` and `c` in `b·divisor + c·modulus = d·dividend`: the matrix is Sylvester's,
/// and `d` is its determinant.
fn modular_quotient(dividend: &Poly, divisor: &Poly, modulus: &Poly, variable: &Variable) -> (Poly, Poly) {
    let [target, of_divisor, of_modulus] =
        [dividend, divisor, modulus].map(|poly| poly.coefficients(variable));
    let unknown = of_modulus.len() - 1;
    let size = unknown + of_divisor.len().saturating_sub(1);
    let shifted = |coefficients: &[Poly], row: usize, shift: usize| {
        row.checked_sub(shift).and_then(|at| coefficients.get(at)).cloned().unwrap_or_else(Poly::zero)
    };
    let row = |power: usize| -> Vec<Poly> {
        let of_b = (0..unknown).map(|shift| shifted(&of_divisor, power, shift));
        let of_c = (0..size - unknown).map(|shift| shifted(&of_modulus, power, shift));
        of_b.chain(of_c).chain([shifted(&target, power, 0)]).collect()
    };
    let (solution, determinant) = solve((0..size).map(row).collect());
    (Poly::from_coefficients(variable, &solution[..unknown]), determinant)
}

/// The solution `x` of the regular system `M·x = d·b`, where `d` is the determinant of `M` up to sign and the rows are
/// those of `M` with `b` behind them.
///
/// Fraction-free elimination to a diagonal matrix (Bareiss, *Sylvester's identity and multistep integer-preserving
/// Gaussian elimination*, 1968): O(n³) products and exact divisions, of minors of the matrix.
fn solve(mut rows: Vec<Vec<Poly>>) -> (Vec<Poly>, Poly) {
    let mut previous = Poly::one();
    for column in 0..rows.len() {
        if let Some(found) = (column..rows.len()).find(|&row| !rows[row][column].is_zero()) {
            rows.swap(column, found);
        }
        let pivot_row = rows[column].clone();
        let pivot = &pivot_row[column];
        for row in rows.iter_mut().enumerate().filter(|(index, _)| *index != column).map(|(_, row)| row) {
            let factor = row[column].clone();
            for (entry, above) in row.iter_mut().zip(&pivot_row) {
                *entry = exact_quotient(&(&*entry * pivot - &factor * above), &previous);
            }
        }
        previous = pivot.clone();
    }
    let solution = rows.iter().filter_map(|row| row.last().cloned()).collect();
    (solution, previous)
}
