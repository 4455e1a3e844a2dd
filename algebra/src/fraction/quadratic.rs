//! Rational functions with the square root of one polynomial.

use std::collections::BTreeMap;
use std::fmt;

use num_traits::Signed;

use crate::{Fraction, Poly, Variable, ratio};

/// A function `a + b·√q` with rational functions a and b and a polynomial q: an element of a quadratic extension of the field
/// of rational functions.
///
/// The radicand is squarefree and has no numeric factor but a sign, and it is no number: `√(8u²v)` is kept as `2√2·u·√v`. A
/// function without root has the radicand 1. `√q` is the root that is not negative where q is not negative, which is where the
/// function is real.
///
/// Sums and products exist for functions with the same radicand, or where one of the two is rational.
///
/// # Example
/// ```
/// use hodograph_algebra::{Fraction, Poly, QuadraticFraction, Variable};
/// let u = Fraction::from(Poly::variable(&Variable::new(0, "u")));
/// let q = &(&u * &u) + &Fraction::one();
/// let root = QuadraticFraction::root_of(&q).unwrap();
/// assert_eq!(root.times(&root).unwrap().to_rational_function(), Some(q));
/// let inverse = root.plus(&u.into()).unwrap().reciprocal().unwrap();
/// assert_eq!(inverse.to_string(), "-u + sqrt(u^2 + 1)");
/// ```
#[derive(Clone, Debug)]
pub struct QuadraticFraction {
    rational: Fraction,
    root: Fraction,
    radicand: Poly,
}

impl From<Fraction> for QuadraticFraction {
    fn from(rational: Fraction) -> QuadraticFraction {
        QuadraticFraction { rational, root: Fraction::zero(), radicand: Poly::one() }
    }
}

impl QuadraticFraction {
    /// A square root of a rational function: `f·√q` where it is `f²·q`; `None` for zero and for negative numbers, and where the
    /// root of its numeric factor is not available.
    ///
    /// Where `f` is negative it is the negative root.
    #[must_use]
    pub fn root_of(radicand: &Fraction) -> Option<QuadraticFraction> {
        let radicand = radicand.lowest_terms();
        if radicand.is_zero() {
            return None;
        }
        let odd = radicand.factors().iter().filter(|(_, exponent)| exponent % 2 == 1);
        let split =
            odd.fold(radicand.numerator().clone(), |product, (factor, _)| product * factor).square_split();
        let below =
            radicand.factors().iter().map(|(factor, exponent)| (factor.clone(), exponent.div_ceil(2)));
        let negative = split.unit.sign().is_lt();
        if negative && split.odd.is_one() {
            return None;
        }
        let (unit, odd) = if negative { (-split.unit, -split.odd) } else { (split.unit, split.odd) };
        let factor = Fraction::new(split.root * unit.sqrt()?, below);
        Some(QuadraticFraction::new(Fraction::zero(), factor, odd))
    }

    /// The function `rational + root·√radicand` for a squarefree radicand without numeric factor, or 1.
    fn new(rational: Fraction, root: Fraction, radicand: Poly) -> QuadraticFraction {
        if radicand.is_one() {
            return (&rational + &root).into();
        }
        if root.is_zero() {
            return rational.into();
        }
        QuadraticFraction { rational, root, radicand }
    }

    /// The summand without root, `a`.
    #[must_use]
    pub fn rational_part(&self) -> &Fraction {
        &self.rational
    }

    /// The factor of the root, `b`; zero if the function is rational.
    #[must_use]
    pub fn root_part(&self) -> &Fraction {
        &self.root
    }

    /// The radicand q; 1 if the function is rational.
    #[must_use]
    pub fn radicand(&self) -> &Poly {
        &self.radicand
    }

    /// Whether it is a rational function.
    #[must_use]
    pub fn is_rational(&self) -> bool {
        self.root.is_zero()
    }

    /// The rational function that it is, if it is one.
    #[must_use]
    pub fn to_rational_function(&self) -> Option<Fraction> {
        self.is_rational().then(|| self.rational.clone())
    }

    /// Whether it is zero.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.rational.is_zero() && self.root.is_zero()
    }

    /// The radicand that both are written over, if there is one.
    fn common_radicand(&self, other: &QuadraticFraction) -> Option<Poly> {
        match (self.is_rational(), other.is_rational()) {
            (true, _) => Some(other.radicand.clone()),
            (_, true) => Some(self.radicand.clone()),
            _ => (self.radicand == other.radicand).then(|| self.radicand.clone()),
        }
    }

    /// The sum; `None` if the radicands differ.
    #[must_use]
    pub fn plus(&self, other: &QuadraticFraction) -> Option<QuadraticFraction> {
        let radicand = self.common_radicand(other)?;
        Some(QuadraticFraction::new(&self.rational + &other.rational, &self.root + &other.root, radicand))
    }

    /// The difference; `None` if the radicands differ.
    #[must_use]
    pub fn minus(&self, other: &QuadraticFraction) -> Option<QuadraticFraction> {
        self.plus(&other.scale(&Poly::integer(-1).into()))
    }

    /// The product with a rational function.
    #[must_use]
    pub fn scale(&self, factor: &Fraction) -> QuadraticFraction {
        QuadraticFraction::new(&self.rational * factor, &self.root * factor, self.radicand.clone())
    }

    /// The product; `None` if the radicands differ, unless both are multiples of roots.
    #[must_use]
    pub fn times(&self, other: &QuadraticFraction) -> Option<QuadraticFraction> {
        let Some(radicand) = self.common_radicand(other) else {
            // √p·√q = √(pq)
            if !self.rational.is_zero() || !other.rational.is_zero() {
                return None;
            }
            let root = QuadraticFraction::root_of(&(&self.radicand * &other.radicand).into())?;
            return Some(root.scale(&(&self.root * &other.root)));
        };
        let square = &(&self.root * &other.root) * &Fraction::from(radicand.clone());
        let rational = (&(&self.rational * &other.rational) + &square).reduced();
        let root = (&(&self.rational * &other.root) + &(&self.root * &other.rational)).reduced();
        Some(QuadraticFraction::new(rational, root, radicand))
    }

    /// The reciprocal; `None` for zero.
    #[must_use]
    pub fn reciprocal(&self) -> Option<QuadraticFraction> {
        if self.is_rational() {
            return self.rational.reciprocal(&[]).map(QuadraticFraction::from);
        }
        let radicand = Fraction::from(self.radicand.clone());
        if self.rational.is_zero() {
            let inverse = (&self.root * &radicand).reciprocal(std::slice::from_ref(&self.radicand))?;
            return Some(QuadraticFraction::new(Fraction::zero(), inverse, self.radicand.clone()));
        }
        // 1/(a + b√q) = (a − b√q)/(a² − b²q); q is no square, so the norm vanishes with both parts only.
        let norm = &(&self.rational * &self.rational) - &(&(&self.root * &self.root) * &radicand);
        let inverse = norm.reduced().reciprocal(&[])?;
        let conjugate = QuadraticFraction::new(self.rational.clone(), -&self.root, self.radicand.clone());
        let QuadraticFraction { rational, root, radicand } = conjugate.scale(&inverse);
        Some(QuadraticFraction::new(rational.reduced(), root.reduced(), radicand))
    }

    /// The partial derivative by `variable`, where `derive` differentiates rational functions by it:
    /// `a' + (b' + b·q'/(2q))·√q`.
    #[must_use]
    pub fn derivation(&self, derive: &dyn Fn(&Fraction) -> Fraction) -> QuadraticFraction {
        let inner = derive(&self.radicand.clone().into()).scale(&ratio(1, 2));
        let inner = &inner * &Fraction::new(Poly::one(), [(self.radicand.clone(), 1)]);
        let root = &derive(&self.root) + &(&self.root * &inner);
        QuadraticFraction::new(derive(&self.rational), root.reduced(), self.radicand.clone())
    }

    /// The function with fractions in place of variables; `None` where a denominator becomes zero, or the radicand a negative
    /// number.
    #[must_use]
    pub fn substitute(&self, values: &BTreeMap<Variable, Fraction>) -> Option<QuadraticFraction> {
        let at = |f: &Fraction| f.substitute(values).or_else(|| f.lowest_terms().substitute(values));
        let rational = at(&self.rational)?;
        let radicand = at(&self.radicand.clone().into())?;
        if self.is_rational() || radicand.is_zero() {
            return Some(rational.into());
        }
        let root = match radicand.to_number() {
            Some(number) => Fraction::from(number.sqrt()?).into(),
            None => QuadraticFraction::root_of(&radicand)?,
        };
        root.scale(&at(&self.root)?).plus(&rational.into())
    }

    /// The same function with `map`, which does not change the value of a rational function, applied to both parts.
    #[must_use]
    pub fn map(&self, map: &dyn Fn(&Fraction) -> Fraction) -> QuadraticFraction {
        QuadraticFraction::new(map(&self.rational), map(&self.root), self.radicand.clone())
    }

    /// The variables that occur, in their order.
    #[must_use]
    pub fn occurring_variables(&self) -> Vec<Variable> {
        let mut all = self.rational.occurring_variables();
        all.extend(self.root.occurring_variables());
        all.extend(self.radicand.occurring_variables());
        all.sort();
        all.dedup();
        all
    }

    /// Whether the representation is as described at [`QuadraticFraction`].
    #[must_use]
    pub fn is_valid(&self) -> bool {
        let radicand =
            if self.radicand.content().is_negative() { -&self.radicand } else { self.radicand.clone() };
        let squarefree = || radicand.square_split().odd == radicand && !radicand.is_constant();
        self.rational.is_valid()
            && self.root.is_valid()
            && (if self.root.is_zero() { self.radicand.is_one() } else { squarefree() })
    }
}

impl PartialEq for QuadraticFraction {
    fn eq(&self, other: &QuadraticFraction) -> bool {
        // The roots of different radicands are independent of each other over the rational functions.
        self.minus(other).is_some_and(|difference| difference.is_zero())
    }
}

impl Eq for QuadraticFraction {}

impl fmt::Display for QuadraticFraction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.is_rational() {
            return write!(f, "{}", self.rational);
        }
        let (rational, root) = (self.rational.reduced(), self.root.reduced());
        let plain = |f: &Fraction| f.factors().is_empty() && f.numerator().monomial_count() == 1;
        let factor = if plain(&root) { root.to_string() } else { format!("({root})") };
        let root = match factor.as_str() {
            "1" => format!("sqrt({})", self.radicand),
            "-1" => format!("-sqrt({})", self.radicand),
            _ => format!("{factor}*sqrt({})", self.radicand),
        };
        if rational.is_zero() {
            return f.write_str(&root);
        }
        match root.strip_prefix('-') {
            Some(rest) => write!(f, "{rational} - {rest}"),
            None => write!(f, "{rational} + {root}"),
        }
    }
}
