//! Formulas in the coefficients of the two fundamental forms, and how similarities scale them.

use std::fmt;

use crate::{Fraction, Poly, Variable};

/// A rational function of the coefficients E, F, G, L, M, N of the fundamental forms, as a formula: the same for all surfaces.
///
/// Its own coefficients are functions of the parameters and symbols. Under a direct similarity of ratio ϱ the coefficients E, F, G
/// are multiplied by ϱ², and L, M, N by ϱ (GE Proposition 4.3). A formula that is multiplied by ϱʷ has the
/// [weight](FormFunction::weight) w; one of weight 1 is a *similarity function* (GE Definition 4.1).
///
/// # Example
/// ```
/// use hodograph_algebra::FormFunction;
/// let [mean, gaussian] = ["H", "K"].map(|name| FormFunction::named(name).unwrap());
/// let f1 = mean.times(&gaussian.reciprocal().unwrap());
/// assert_eq!(f1.to_string(), "(1/2*E*N - F*M + 1/2*G*L)/(L*N - M^2)");
/// assert_eq!((mean.weight(), gaussian.weight(), f1.weight()), (Some(-1), Some(-2), Some(1)));
/// assert_eq!(mean.plus(&gaussian).weight(), None);
/// ```
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct FormFunction {
    formula: Fraction,
}

/// The rank of the variables E, …, N: they are neither parameters nor symbols.
const RANK: u32 = Variable::SYMBOL - 1;

/// The names of the coefficients of the first fundamental form, `E = R_u·R_u`, `F = R_u·R_v`, `G = R_v·R_v`, and of the second
/// one, `L = R_uu·n₁`, `M = R_uv·n₁`, `N = R_vv·n₁` (GE (4.2), (4.3)).
const NAMES: [&str; 6] = ["E", "F", "G", "L", "M", "N"];

/// How often ϱ multiplies each of them under a similarity of ratio ϱ.
const WEIGHTS: [i64; 6] = [2, 2, 2, 1, 1, 1];

/// The variable that stands for a coefficient.
fn letter(index: usize) -> Poly {
    Poly::variable(&Variable::new(RANK, NAMES[index]))
}

/// `EG − F²`, the determinant of the first form.
pub(super) fn first_determinant() -> Poly {
    letter(0) * letter(2) - letter(1).pow(2)
}

/// `LN − M²`, the determinant of the second form.
pub(super) fn second_determinant() -> Poly {
    letter(3) * letter(5) - letter(4).pow(2)
}

/// `EN − 2FM + GL`, the mixed determinant of both forms.
pub(super) fn mixed_determinant() -> Poly {
    letter(0) * letter(5) - Poly::integer(2) * letter(1) * letter(4) + letter(2) * letter(3)
}

impl From<Fraction> for FormFunction {
    /// A function of the parameters and symbols, which does not depend on the forms.
    fn from(coefficient: Fraction) -> FormFunction {
        FormFunction { formula: coefficient }
    }
}

impl FormFunction {
    /// The coefficient, or curvature, of this name: `E`, `F`, `G`, `L`, `M`, `N`; `K = (LN − M²)/(EG − F²)`, the Gaussian
    /// curvature; `H = (EN − 2FM + GL)/(2(EG − F²))`, the mean curvature (GE (5.2)).
    #[must_use]
    pub fn named(name: &str) -> Option<FormFunction> {
        let over = |numerator: Poly| Fraction::new(numerator, [(first_determinant(), 1)]);
        let formula = match name {
            "K" => over(second_determinant()),
            "H" => over(mixed_determinant()).scale(&crate::ratio(1, 2)),
            _ => letter(NAMES.iter().position(|known| *known == name)?).into(),
        };
        Some(FormFunction { formula })
    }

    /// The formula, in the variables E, …, N.
    #[must_use]
    pub fn formula(&self) -> &Fraction {
        &self.formula
    }

    /// The sum.
    #[must_use]
    pub fn plus(&self, other: &FormFunction) -> FormFunction {
        FormFunction { formula: &self.formula + &other.formula }
    }

    /// The product.
    #[must_use]
    pub fn times(&self, other: &FormFunction) -> FormFunction {
        FormFunction { formula: (&self.formula * &other.formula).reduced() }
    }

    /// The reciprocal; `None` for zero.
    #[must_use]
    pub fn reciprocal(&self) -> Option<FormFunction> {
        let known = [first_determinant(), second_determinant(), mixed_determinant()];
        Some(FormFunction { formula: self.formula.reciprocal(&known)? })
    }

    /// The power.
    #[must_use]
    pub fn pow(&self, exponent: u32) -> FormFunction {
        FormFunction { formula: self.formula.pow(exponent) }
    }

    /// The exponent w of the factor ϱʷ that a direct similarity of ratio ϱ brings; `None` if the terms of the formula scale
    /// differently, so that there is no such factor. Zero has the weight 1, as it has any other.
    ///
    /// In lowest terms a formula has a weight exactly if numerator and denominator each do.
    #[must_use]
    pub fn weight(&self) -> Option<i64> {
        if self.formula.is_zero() {
            return Some(1);
        }
        let formula = self.formula.lowest_terms();
        let mut weight = homogeneous_weight(formula.numerator())?;
        for (factor, exponent) in formula.factors() {
            weight -= i64::from(*exponent) * homogeneous_weight(factor)?;
        }
        Some(weight)
    }
}

/// The exponents of E, …, N in each monomial in them, with its coefficient.
pub(super) fn monomials(poly: &Poly) -> Vec<([u32; 6], Poly)> {
    let letters = NAMES.map(|name| Variable::new(RANK, name));
    let terms = poly.coefficients_of(&letters).into_iter();
    terms
        .map(|(exponents, coefficient)| {
            let mut own = [0; 6];
            own.iter_mut().zip(exponents).for_each(|(own, exponent)| *own = exponent);
            (own, coefficient)
        })
        .collect()
}

/// The weight of all terms of a polynomial, if they have one.
fn homogeneous_weight(poly: &Poly) -> Option<i64> {
    let mut weights = monomials(poly).into_iter().map(|(exponents, _)| {
        exponents.iter().zip(WEIGHTS).map(|(exponent, weight)| i64::from(*exponent) * weight).sum::<i64>()
    });
    let first = weights.next()?;
    weights.all(|weight| weight == first).then_some(first)
}

impl fmt::Display for FormFunction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}", self.formula.lowest_terms())
    }
}
