//! Rational functions that keep their denominators as products of known factors.

mod display;
mod operators;
pub(crate) mod quadratic;

use std::collections::BTreeMap;

use crate::poly::{Poly, Variable};
use crate::{Rational, budget, integer};

/// A rational function: a polynomial over a product of powers of known factors.
///
/// Factors are kept because geometry supplies them: the weight of a profile, the parametric speed of a sweep curve.
/// (Compare W. S. Brown, *On computing with factored rational expressions*, 1974.) Sums use the least common multiple of the
/// *known* factors, and only known factors are tried when a fraction is
/// [reduced](Fraction::reduced). Sums and products do not cancel by themselves, so that a formula keeps the denominators
/// it was written with; equality is that of rational functions all the same.
///
/// # Example
/// ```
/// use hodograph_algebra::{Fraction, Poly, Variable};
/// let u = Fraction::from(Poly::variable(&Variable::new(0, "u")));
/// let one = Fraction::from(Poly::one());
/// let weight = &one + &(&u * &u);
/// let x = &(&one - &(&u * &u)) / &weight;
/// assert_eq!(x.to_string(), "(-u^2 + 1)/(u^2 + 1)");
/// assert_eq!(&x + &one, &(&one + &one) / &weight);
/// ```
#[derive(Clone)]
pub struct Fraction {
    numerator: Poly,
    /// Normalized factors that are not constant, with positive exponents, distinct, in a fixed order.
    factors: Vec<(Poly, u32)>,
}

impl Fraction {
    /// Zero.
    #[must_use]
    pub fn zero() -> Fraction {
        Poly::zero().into()
    }

    /// One.
    #[must_use]
    pub fn one() -> Fraction {
        Poly::one().into()
    }

    /// The fraction `numerator / Π factor^exponent`. Factors need not be normalized; they are not zero.
    ///
    /// # Panics
    /// If a factor is zero.
    #[must_use]
    pub fn new(numerator: Poly, factors: impl IntoIterator<Item = (Poly, u32)>) -> Fraction {
        let mut fraction = Fraction::from(numerator);
        for (factor, exponent) in factors.into_iter().filter(|(_, exponent)| *exponent > 0) {
            assert!(!factor.is_zero(), "a fraction with the denominator zero");
            let normalized = factor.normalized();
            // factor = unit · normalized
            let unit = factor.leading_coefficient() * normalized.leading_coefficient().inverse();
            fraction.numerator *= unit.inverse().pow(exponent);
            if !normalized.is_constant() {
                insert(&mut fraction.factors, normalized, exponent);
            }
        }
        if fraction.is_zero() { Fraction::zero() } else { fraction }
    }

    /// The numerator over [`Fraction::denominator`].
    #[must_use]
    pub fn numerator(&self) -> &Poly {
        &self.numerator
    }

    /// The factors of the denominator with their exponents.
    #[must_use]
    pub fn factors(&self) -> &[(Poly, u32)] {
        &self.factors
    }

    /// The denominator, multiplied out.
    #[must_use]
    pub fn denominator(&self) -> Poly {
        product(&self.factors)
    }

    /// Whether it is zero.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.numerator.is_zero()
    }

    /// Whether it is written as 1.
    pub(crate) fn is_one(&self) -> bool {
        self.factors.is_empty() && self.numerator.is_one()
    }

    /// The polynomial that it is, if it is one.
    #[must_use]
    pub fn to_poly(&self) -> Option<Poly> {
        if self.factors.is_empty() {
            return Some(self.numerator.clone());
        }
        let reduced = self.reduced();
        reduced.factors.is_empty().then_some(reduced.numerator)
    }

    /// The number that it is, if no variable occurs in it.
    #[must_use]
    pub fn to_number(&self) -> Option<Poly> {
        self.to_poly().filter(Poly::is_constant)
    }

    /// The rational number that it is, if it is one.
    #[must_use]
    pub fn to_rational(&self) -> Option<Rational> {
        self.to_number().and_then(|number| number.to_rational())
    }

    /// The reciprocal; `None` for zero. The numerator becomes known factors by its squarefree decomposition, after the
    /// factors of `known` have been taken out.
    #[must_use]
    pub fn reciprocal(&self, known: &[Poly]) -> Option<Fraction> {
        if self.is_zero() {
            return None;
        }
        let mut rest = self.numerator.clone();
        let mut factors = Vec::new();
        for factor in known {
            let (multiplicity, quotient) = rest.take_out(factor);
            factors.push((factor.clone(), multiplicity));
            rest = quotient;
        }
        let decomposition = budget::doing("the factors of a denominator", || rest.squarefree());
        factors.extend(decomposition.factors);
        Some(Fraction::new(self.denominator() * decomposition.unit.inverse(), factors))
    }

    /// The quotient; `None` if `divisor` is zero.
    #[must_use]
    pub fn checked_div(&self, divisor: &Fraction) -> Option<Fraction> {
        let known: Vec<Poly> = self.factors.iter().map(|(factor, _)| factor.clone()).collect();
        Some(self * &divisor.reciprocal(&known)?)
    }

    /// `self` to the power `exponent`.
    #[must_use]
    pub fn pow(&self, exponent: u32) -> Fraction {
        let factors = self.factors.iter().map(|(factor, e)| (factor.clone(), e.saturating_mul(exponent)));
        let factors = if exponent == 0 { Vec::new() } else { factors.collect() };
        Fraction { numerator: self.numerator.pow(exponent), factors }
    }

    /// `self · factor`.
    #[must_use]
    pub fn scale(&self, factor: &Rational) -> Fraction {
        let numerator = self.numerator.scale(factor);
        if numerator.is_zero() {
            Fraction::zero()
        } else {
            Fraction { numerator, factors: self.factors.clone() }
        }
    }

    /// The same rational function with every known factor cancelled as often as it divides the numerator.
    #[must_use]
    pub fn reduced(&self) -> Fraction {
        if self.is_zero() {
            return Fraction::zero();
        }
        let (numerator, factors) = cancelled(&self.numerator, &self.factors);
        Fraction { numerator, factors }
    }

    /// The product of [reduced](Fraction::reduced) fractions, reduced.
    ///
    /// The numerator of each fraction is divided by factors of the other one before the numerators are multiplied, as for numbers
    /// (Henrici, *A subroutine for computations with rational numbers*, 1956): trial divisions of short operands instead of
    /// those of their product.
    #[must_use]
    pub fn reduced_product(&self, other: &Fraction) -> Fraction {
        if self.is_zero() || other.is_zero() {
            return Fraction::zero();
        }
        let (numerator, others) = cancelled(&self.numerator, &other.factors);
        let (other_numerator, factors) = cancelled(&other.numerator, &self.factors);
        (&Fraction { numerator, factors } * &Fraction { numerator: other_numerator, factors: others })
            .reduced()
    }

    /// The same rational function in lowest terms: what numerator and known factors have in common is found by gcds, so
    /// factors may split.
    #[must_use]
    pub fn lowest_terms(&self) -> Fraction {
        let reduced = self.reduced();
        let mut numerator = reduced.numerator;
        let mut factors: Vec<(Poly, u32)> = Vec::new();
        for (factor, exponent) in reduced.factors {
            if numerator.gcd(&factor).is_constant() {
                insert(&mut factors, factor, exponent);
                continue;
            }
            let mut rest = factor.pow(exponent);
            loop {
                let common = numerator.gcd(&rest);
                if common.is_constant() {
                    break;
                }
                let divided = (numerator.exact_div(&common), rest.exact_div(&common));
                let (Some(n), Some(r)) = divided else { break };
                (numerator, rest) = (n, r);
            }
            let decomposition = rest.squarefree();
            numerator *= decomposition.unit.inverse();
            for (part, multiplicity) in decomposition.factors {
                insert(&mut factors, part, multiplicity);
            }
        }
        Fraction { numerator, factors }
    }

    /// The partial derivative by `variable`, reduced.
    #[must_use]
    pub fn derivative(&self, variable: &Variable) -> Fraction {
        self.derivation(&|poly| poly.derivative(variable).into())
    }

    /// The image under a derivation `d`, which is given on polynomials: `d(n/Πf^e) = (dn·Πf − n·Σ e·df·Π others)/Πf^(e+1)`,
    /// reduced. Only factors that are not constant for `d` enter.
    #[must_use]
    pub fn derivation(&self, d: &dyn Fn(&Poly) -> Fraction) -> Fraction {
        let moving: Vec<(&Poly, u32, Fraction)> = self
            .factors
            .iter()
            .map(|(factor, exponent)| (factor, *exponent, d(factor)))
            .filter(|(_, _, derivative)| !derivative.is_zero())
            .collect();
        let whole: Fraction = moving.iter().map(|(factor, ..)| (*factor).clone()).product::<Poly>().into();
        let mut numerator = &d(&self.numerator) * &whole;
        for (index, (_, exponent, derivative)) in moving.iter().enumerate() {
            let others = moving.iter().enumerate().filter(|(other, _)| *other != index);
            let others: Poly = others.map(|(_, (factor, ..))| (*factor).clone()).product();
            let term =
                &(derivative * &Fraction::from(&self.numerator * others)) * &integer(i64::from(*exponent));
            numerator = &numerator - &term;
        }
        let denominator = Fraction {
            numerator: Poly::one(),
            factors: self
                .factors
                .iter()
                .map(|(factor, exponent)| {
                    let moves = moving.iter().any(|(other, ..)| *other == factor);
                    (factor.clone(), exponent + u32::from(moves))
                })
                .collect(),
        };
        (&numerator * &denominator).reduced()
    }

    /// The rational function with fractions in place of variables; `None` where a denominator becomes zero.
    #[must_use]
    pub fn substitute(&self, values: &BTreeMap<Variable, Fraction>) -> Option<Fraction> {
        let mut result = substitute_poly(&self.numerator, values);
        for (factor, exponent) in &self.factors {
            let value = substitute_poly(factor, values);
            result = result.checked_div(&value.pow(*exponent))?;
        }
        Some(result)
    }

    /// The variables that occur, in their order.
    #[must_use]
    pub fn occurring_variables(&self) -> Vec<Variable> {
        let mut all = self.numerator.occurring_variables();
        for (factor, _) in &self.factors {
            all.extend(factor.occurring_variables());
        }
        all.sort();
        all.dedup();
        all
    }

    /// The same rational function with `map` applied to the numerator and to every factor; `map` is a homomorphism that
    /// maps no factor to zero.
    #[must_use]
    pub fn map(&self, mut map: impl FnMut(&Poly) -> Poly) -> Fraction {
        let factors: Vec<(Poly, u32)> = self.factors.iter().map(|(factor, e)| (map(factor), *e)).collect();
        Fraction::new(map(&self.numerator), factors)
    }

    /// Whether the representation is as described at [`Fraction`]: factors that are normalized, not constant and distinct,
    /// with positive exponents, and none for zero.
    #[must_use]
    pub fn is_valid(&self) -> bool {
        let distinct = |(index, (factor, _)): (usize, &(Poly, u32))| {
            self.factors[..index].iter().all(|(other, _)| other != factor)
        };
        let normalized = |(factor, exponent): &(Poly, u32)| {
            *exponent > 0 && !factor.is_constant() && factor.normalized() == *factor && factor.is_valid()
        };
        self.numerator.is_valid()
            && (!self.is_zero() || self.factors.is_empty())
            && self.factors.iter().all(normalized)
            && self.factors.iter().enumerate().all(distinct)
    }

    /// The factors of the least common denominator of `fractions`.
    #[must_use]
    pub fn common_denominator<'a>(fractions: impl IntoIterator<Item = &'a Fraction>) -> Vec<(Poly, u32)> {
        let mut common: Vec<(Poly, u32)> = Vec::new();
        for (factor, exponent) in fractions.into_iter().flat_map(|fraction| &fraction.factors) {
            match common.iter_mut().find(|(other, _)| other == factor) {
                Some((_, most)) => *most = (*most).max(*exponent),
                None => insert(&mut common, factor.clone(), *exponent),
            }
        }
        common
    }

    /// The numerator of `self` over the denominator `Π common`, whose factors include those of `self`.
    #[must_use]
    pub fn numerator_over(&self, common: &[(Poly, u32)]) -> Poly {
        let mut numerator = self.numerator.clone();
        for (factor, exponent) in common {
            let own = self.factors.iter().find(|(other, _)| other == factor).map_or(0, |(_, own)| *own);
            if *exponent > own {
                numerator *= factor.pow(exponent - own);
            }
        }
        numerator
    }
}

fn substitute_poly(poly: &Poly, values: &BTreeMap<Variable, Fraction>) -> Fraction {
    let polynomial: Option<BTreeMap<Variable, Poly>> = values
        .iter()
        .map(|(variable, value)| {
            value.factors.is_empty().then(|| (variable.clone(), value.numerator.clone()))
        })
        .collect();
    if let Some(polynomial) = polynomial {
        return poly.evaluate(&polynomial).into();
    }
    // All monomials over one common denominator, by Horner's rule in each variable.
    let Some((variable, value)) = values.iter().find(|(variable, _)| poly.contains(variable)) else {
        return poly.clone().into();
    };
    // The rest is substituted into the coefficients first, so that what is put in is never substituted again.
    let rest: BTreeMap<Variable, Fraction> =
        values.iter().filter(|(other, _)| *other != variable).map(|(v, f)| (v.clone(), f.clone())).collect();
    let coefficients = poly.coefficients(variable);
    coefficients
        .iter()
        .rev()
        .fold(Fraction::zero(), |sum, coefficient| &(&sum * value) + &substitute_poly(coefficient, &rest))
}

/// A nonzero numerator and factors of a denominator, each factor cancelled as often as it divides.
fn cancelled(numerator: &Poly, factors: &[(Poly, u32)]) -> (Poly, Vec<(Poly, u32)>) {
    let mut numerator = numerator.clone();
    let mut rest = Vec::new();
    for (factor, exponent) in factors {
        let mut left = *exponent;
        while left > 0 {
            let Some(quotient) = numerator.exact_div(factor) else { break };
            numerator = quotient;
            left -= 1;
        }
        if left > 0 {
            rest.push((factor.clone(), left));
        }
    }
    (numerator, rest)
}

fn product(factors: &[(Poly, u32)]) -> Poly {
    factors.iter().map(|(factor, exponent)| factor.pow(*exponent)).product()
}

/// Adds `factor^exponent` to an ordered list.
fn insert(factors: &mut Vec<(Poly, u32)>, factor: Poly, exponent: u32) {
    if let Some((_, own)) = factors.iter_mut().find(|(other, _)| *other == factor) {
        *own += exponent;
        return;
    }
    // The order decides how a denominator prints: short factors first, then as text.
    let order = |a: &Poly, b: &Poly| {
        a.terms().len().cmp(&b.terms().len()).then_with(|| a.to_string().cmp(&b.to_string()))
    };
    let place = factors.partition_point(|(other, _)| order(other, &factor).is_lt());
    factors.insert(place, (factor, exponent));
}
