//! Real roots of polynomials in one variable, exactly.

use std::cmp::Ordering;
use std::fmt;

use super::bernstein::variations;
use super::interval::Interval;
use super::isolate::{self, Place, sign_at};
use super::net::Net;
use crate::number::enclosure::Enclosure;
use crate::{Int, Poly, Rational, Variable, budget, ratio};

/// A real root of a polynomial in one variable.
///
/// It is an exact number where it is rational or a root of a linear or quadratic factor that was found; otherwise it is
/// the only root of a squarefree polynomial in an open interval with rational ends. Rational roots are always
/// recognized. Everything asked of it is answered exactly.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RealRoot {
    variable: Variable,
    multiplicity: u32,
    value: Value,
}

#[derive(Clone, Debug, PartialEq, Eq)]
enum Value {
    Exact(Poly),
    /// An irrational root, simple, and the only one of `poly` in the interval; `rising` tells whether `poly` is negative
    /// at the lower end.
    Isolated {
        poly: Poly,
        lower: Rational,
        upper: Rational,
        rising: bool,
    },
}

impl Poly {
    /// All real roots of a polynomial in `variable` alone, in ascending order, with their multiplicities; `None` for the
    /// zero polynomial, and if other variables occur.
    ///
    /// The squarefree part is isolated by bisection of Bernstein forms on an interval that holds all real roots.
    ///
    /// # Example
    /// ```
    /// use hodograph_algebra::{Poly, Variable};
    /// let u = Variable::new(0, "u");
    /// let x = Poly::variable(&u);
    /// let f = (&x - Poly::integer(1)).pow(2) * (x.pow(2) - Poly::integer(2)) * (x.pow(3) - Poly::integer(3));
    /// let roots = f.real_roots(&u).unwrap();
    /// let multiplicities: Vec<u32> = roots.iter().map(|root| root.multiplicity()).collect();
    /// assert_eq!(multiplicities, [1, 2, 1, 1]);
    /// assert_eq!(roots[1].to_string(), "1");
    /// assert_eq!(roots[3].to_decimal(5), "1.44225");
    /// ```
    #[must_use]
    pub fn real_roots(&self, variable: &Variable) -> Option<Vec<RealRoot>> {
        roots_between(self, variable, None)
    }

    /// The real roots in a closed interval, its ends included, as [`Poly::real_roots`] gives them.
    ///
    /// # Example
    /// ```
    /// use hodograph_algebra::{Interval, Poly, Variable};
    /// let u = Variable::new(0, "u");
    /// let f = Poly::variable(&u).pow(2) - Poly::variable(&u);
    /// let roots = f.real_roots_in(&u, &Interval::unit()).unwrap();
    /// assert_eq!(roots.iter().map(ToString::to_string).collect::<Vec<_>>(), ["0", "1"]);
    /// ```
    #[must_use]
    pub fn real_roots_in(&self, variable: &Variable, interval: &Interval) -> Option<Vec<RealRoot>> {
        roots_between(self, variable, Some(interval))
    }
}

impl RealRoot {
    /// The variable of the polynomial that it is a root of.
    #[must_use]
    pub fn variable(&self) -> &Variable {
        &self.variable
    }

    /// How often it is a root of the polynomial that was asked about.
    #[must_use]
    pub fn multiplicity(&self) -> u32 {
        self.multiplicity
    }

    /// The root as a number of a field, if it is known as one; every rational root is.
    #[must_use]
    pub fn exact(&self) -> Option<&Poly> {
        match &self.value {
            Value::Exact(number) => Some(number),
            Value::Isolated { .. } => None,
        }
    }

    /// The root, if it is rational.
    #[must_use]
    pub fn to_rational(&self) -> Option<Rational> {
        self.exact().and_then(Poly::to_rational)
    }

    /// An interval of width at most `2^-bits` that holds the root.
    ///
    /// Complexity: some evaluations of the polynomial each time the number of bits doubles.
    #[must_use]
    pub fn enclosure(&self, bits: u64) -> Enclosure {
        match self.refined(bits).value {
            Value::Exact(number) => number.enclosure(bits),
            Value::Isolated { lower, upper, .. } => Enclosure::new(lower, upper),
        }
    }

    /// The same root in an isolating interval of width at most `2^-bits`; an exact root as it is.
    #[must_use]
    pub fn refined(&self, bits: u64) -> RealRoot {
        self.narrowed(&Rational::new(Int::ONE, Int::ONE.shl(bits)))
    }

    /// The root as a decimal, correctly rounded to `digits` places after the point.
    #[must_use]
    pub fn to_decimal(&self, digits: u32) -> String {
        let mut root = self.refined(4 * u64::from(digits) + 4);
        loop {
            match &root.value {
                Value::Exact(number) => return number.to_decimal(digits),
                Value::Isolated { lower, upper, .. } => {
                    let decimal = |end: &Rational| Poly::constant(end.clone()).to_decimal(digits);
                    let (low, high) = (decimal(lower), decimal(upper));
                    // The root is irrational, hence no midpoint of two decimals: this ends.
                    if low == high {
                        return low;
                    }
                }
            }
            root = root.sharpened();
        }
    }

    /// Compares the root with another one by their values, whatever their variables and multiplicities.
    ///
    /// Equality is decided by the greatest common divisor of both polynomials, which has a root in both intervals
    /// exactly if the roots agree.
    #[must_use]
    pub fn compare(&self, other: &RealRoot) -> Ordering {
        let (mut a, mut b) = (self.clone(), other.clone());
        let mut shared = None;
        loop {
            let (lower, upper) = match (&a.value, &b.value) {
                (_, Value::Exact(number)) => return a.compare_number(number),
                (Value::Exact(number), _) => return b.compare_number(number).reverse(),
                (
                    Value::Isolated { lower: p, upper: q, poly: f, .. },
                    Value::Isolated { lower: r, upper: s, poly: g, .. },
                ) => {
                    if q <= r {
                        return Ordering::Less;
                    }
                    if s <= p {
                        return Ordering::Greater;
                    }
                    let g = g.substitute(&b.variable, &Poly::variable(&a.variable));
                    shared.get_or_insert_with(|| f.gcd(&g));
                    (p.max(r).clone(), q.min(s).clone())
                }
            };
            // The ends are no roots of one of the polynomials, hence none of the divisor.
            if shared.as_ref().is_some_and(|divisor| changes_sign(divisor, &a.variable, &lower, &upper)) {
                return Ordering::Equal;
            }
            (a, b) = (a.sharpened(), b.sharpened());
        }
    }

    /// Compares the root with a number of a field.
    ///
    /// # Panics
    /// If `number` has variables.
    #[must_use]
    pub fn compare_number(&self, number: &Poly) -> Ordering {
        match &self.value {
            Value::Exact(value) => value.compare(number),
            Value::Isolated { poly, lower, upper, rising } => {
                if number.compare(&Poly::constant(lower.clone())) != Ordering::Greater {
                    return Ordering::Greater;
                }
                if number.compare(&Poly::constant(upper.clone())) != Ordering::Less {
                    return Ordering::Less;
                }
                // The polynomial is negative below its root if it rises.
                let sign = poly.substitute(&self.variable, number).sign();
                if *rising { sign.reverse() } else { sign }
            }
        }
    }

    /// The sign of `poly`, a polynomial in the variable of the root, at the root; `None` if other variables occur.
    #[must_use]
    pub fn sign_of(&self, poly: &Poly) -> Option<Ordering> {
        if poly.occurring_variables().iter().any(|variable| *variable != self.variable) {
            return None;
        }
        if poly.is_constant() {
            return Some(poly.sign());
        }
        let mut root = self.clone();
        if let Value::Isolated { poly: own, lower, upper, .. } = &root.value
            && changes_sign(&own.gcd(poly), &self.variable, lower, upper)
        {
            return Some(Ordering::Equal);
        }
        // The root is no root of `poly`, so in the end no root of it is left in the interval.
        loop {
            let (lower, upper) = match &root.value {
                Value::Exact(number) => return Some(poly.substitute(&self.variable, number).sign()),
                Value::Isolated { lower, upper, .. } => (lower, upper),
            };
            let interval = Interval::new(Poly::constant(lower.clone()), Poly::constant(upper.clone()))?;
            let net = Net::of(poly, &[(self.variable.clone(), interval)])?;
            if variations(net.signs()) == 0 {
                return net.signs().find(|sign| sign.is_ne());
            }
            root = root.sharpened();
        }
    }

    /// Numbers at or below and at or above the root, with no other root of the polynomial asked about between them and
    /// it: the root itself if it is exact, else the ends of its interval.
    pub(crate) fn bounds(&self) -> (Poly, Poly) {
        match &self.value {
            Value::Exact(number) => (number.clone(), number.clone()),
            Value::Isolated { lower, upper, .. } => {
                (Poly::constant(lower.clone()), Poly::constant(upper.clone()))
            }
        }
    }

    fn narrowed(&self, width: &Rational) -> RealRoot {
        let Value::Isolated { poly, lower, upper, rising } = &self.value else { return self.clone() };
        let ends = (lower.clone(), upper.clone());
        let value = match isolate::narrow(poly, &self.variable, ends, *rising, width) {
            Place::Point(number) => Value::Exact(Poly::constant(number)),
            Place::Open(lower, upper) => {
                Value::Isolated { poly: poly.clone(), lower, upper, rising: *rising }
            }
        };
        RealRoot { value, ..self.clone() }
    }

    /// The root in an interval of at most 1/16 of the width.
    fn sharpened(&self) -> RealRoot {
        let Value::Isolated { lower, upper, .. } = &self.value else { return self.clone() };
        self.narrowed(&((upper - lower) * ratio(1, 16)))
    }
}

impl fmt::Display for RealRoot {
    /// The number, if it is exact, such as `1/2`; else `root of u^3 - 2 in (1, 3/2)`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.value {
            Value::Exact(number) => number.fmt(f),
            Value::Isolated { poly, lower, upper, .. } => write!(f, "root of {poly} in ({lower}, {upper})"),
        }
    }
}

fn changes_sign(poly: &Poly, variable: &Variable, lower: &Rational, upper: &Rational) -> bool {
    sign_at(poly, variable, lower) != sign_at(poly, variable, upper)
}

fn roots_between(poly: &Poly, variable: &Variable, interval: Option<&Interval>) -> Option<Vec<RealRoot>> {
    if poly.is_zero() || poly.occurring_variables().iter().any(|other| other != variable) {
        return None;
    }
    if poly.is_constant() {
        return Some(Vec::new());
    }
    budget::doing("the real roots of a polynomial", || {
        let squarefree = poly.squarefree();
        let radical = squarefree.radical();
        let (lower, upper) = match interval {
            Some(interval) => outer_ends(interval),
            None => {
                let bound = isolate::root_bound(&radical, variable);
                (-&bound, bound)
            }
        };
        let mut roots = Vec::new();
        for place in isolate::isolate(&radical, variable, &lower, &upper) {
            let factor = squarefree.factors.iter().find(|(factor, _)| vanishes_at(factor, variable, &place));
            let Some((factor, multiplicity)) = factor else { continue };
            let value = match place {
                Place::Point(number) => Value::Exact(Poly::constant(number)),
                Place::Open(lower, upper) => {
                    let rising = sign_at(factor, variable, &lower).is_lt();
                    Value::Isolated { poly: factor.clone(), lower, upper, rising }
                }
            };
            let root = RealRoot { variable: variable.clone(), multiplicity: *multiplicity, value };
            roots.push(recognize_rational(root));
        }
        for (factor, _) in &squarefree.factors {
            recognize_quadratic(factor, &mut roots);
        }
        if let Some(interval) = interval {
            roots.retain(|root| {
                root.compare_number(interval.lower()) != Ordering::Less
                    && root.compare_number(interval.upper()) != Ordering::Greater
            });
        }
        Some(roots)
    })
}

/// Rational numbers at or outside the ends.
fn outer_ends(interval: &Interval) -> (Rational, Rational) {
    let end = |number: &Poly| match number.to_rational() {
        Some(value) => Enclosure::exact(value),
        None => number.enclosure(8).rounded(8),
    };
    (end(interval.lower()).lower().clone(), end(interval.upper()).upper().clone())
}

fn vanishes_at(poly: &Poly, variable: &Variable, place: &Place) -> bool {
    match place {
        Place::Point(number) => sign_at(poly, variable, number).is_eq(),
        Place::Open(lower, upper) => changes_sign(poly, variable, lower, upper),
    }
}

/// The root as a number, if it is rational.
///
/// A rational root is one of the greatest common divisor `h` of the polynomial's coordinates in the number field, which
/// is a polynomial over the integers; its denominator divides the leading coefficient `c` of `h`. In an interval
/// narrower than `1/c` there is at most one multiple of `1/c` to try.
fn recognize_rational(root: RealRoot) -> RealRoot {
    let Value::Isolated { poly, lower, upper, .. } = &root.value else { return root };
    let coordinates: Vec<Poly> = poly.generator_coefficients().into_values().collect();
    let rational_part = Poly::gcd_many(&coordinates);
    if rational_part.is_constant() || !changes_sign(&rational_part, &root.variable, lower, upper) {
        return root;
    }
    let Some(leading) = rational_part.terms().first().map(|term| term.coefficient.clone()) else {
        return root;
    };
    let narrow = root.refined(leading.bits() + 1);
    let Value::Isolated { lower, .. } = &narrow.value else { return narrow };
    let candidate = (lower * Rational::from(leading.clone())).floor().to_integer() + Int::ONE;
    let candidate = Poly::constant(Rational::new(candidate, leading));
    if narrow.compare_number(&candidate).is_eq() {
        return RealRoot { value: Value::Exact(candidate), ..root };
    }
    root
}

/// Makes roots of `factor` exact if at most two of its roots are not known to be rational.
fn recognize_quadratic(factor: &Poly, roots: &mut [RealRoot]) {
    let Some(position) = roots.iter().position(|root| root.is_isolated_root_of(factor)) else { return };
    let variable = roots[position].variable.clone();
    let mut rest = factor.clone();
    for root in roots.iter() {
        if let Some(number) = root.to_rational() {
            rest = rest.take_out(&(Poly::variable(&variable) - Poly::constant(number))).1;
        }
    }
    let numbers = match rest.coefficients(&variable).as_slice() {
        [c, b] => vec![-(c * b.inverse())],
        [c, b, a] => {
            let Some(root) = (b * b - (a * c).scale(&crate::integer(4))).sqrt() else { return };
            let half = a.inverse().scale(&ratio(1, 2));
            vec![(-b - &root) * &half, (root - b) * half]
        }
        _ => return,
    };
    for root in roots.iter_mut().filter(|root| root.is_isolated_root_of(factor)) {
        if let Some(number) = numbers.iter().find(|number| root.compare_number(number).is_eq()) {
            root.value = Value::Exact(number.clone());
        }
    }
}

impl RealRoot {
    fn is_isolated_root_of(&self, factor: &Poly) -> bool {
        matches!(&self.value, Value::Isolated { poly, .. } if poly == factor)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::integer;

    fn u() -> Variable {
        Variable::new(0, "u")
    }

    fn texts(poly: &Poly) -> Vec<String> {
        poly.real_roots(&u()).unwrap().iter().map(ToString::to_string).collect()
    }

    #[test]
    fn roots_are_as_exact_as_they_can_be() {
        let x = Poly::variable(&u());
        let f = x.scale(&integer(3)) - Poly::one();
        assert_eq!(texts(&f), ["1/3"]);
        assert_eq!(texts(&(x.pow(2) - Poly::integer(2))), ["-sqrt2", "sqrt2"]);
        assert_eq!(
            texts(&(&f * (x.pow(2) - &x - Poly::one()))),
            ["-1/2*sqrt5 + 1/2", "1/3", "1/2*sqrt5 + 1/2"]
        );
        assert_eq!(texts(&(x.pow(3) - Poly::integer(2))), ["root of u^3 - 2 in (0, 4)"]);
        assert_eq!(texts(&(x.pow(2) + Poly::one())), [""; 0]);
        let root = Poly::sqrt_of(&integer(2));
        let over_field = (&x - &root) * (&x - Poly::constant(ratio(2, 7)));
        assert_eq!(texts(&over_field), ["2/7", "sqrt2"]);
        assert!(Poly::zero().real_roots(&u()).is_none());
        assert!((x + Poly::variable(&Variable::new(1, "v"))).real_roots(&u()).is_none());
        assert_eq!(Poly::one().real_roots(&u()), Some(Vec::new()));
    }

    #[test]
    fn ends_that_are_irrational_count_exactly() {
        let x = Poly::variable(&u());
        let root = Poly::sqrt_of(&integer(2));
        let f = (x.pow(2) - Poly::integer(2)) * (&x - Poly::constant(ratio(14_142, 10_000)));
        let interval = Interval::new(root.clone(), Poly::integer(5)).unwrap();
        let roots = f.real_roots_in(&u(), &interval).unwrap();
        assert_eq!(roots.len(), 1);
        assert_eq!(roots[0].exact(), Some(&root));
    }

    #[test]
    fn signs_and_comparisons_at_roots() {
        let x = Poly::variable(&u());
        let cube = x.pow(3) - Poly::integer(2);
        let root = cube.real_roots(&u()).unwrap().remove(0);
        assert_eq!(root.sign_of(&(&cube * &x)), Some(Ordering::Equal));
        assert_eq!(root.sign_of(&(&x - Poly::constant(ratio(1259, 1000)))), Some(Ordering::Greater));
        assert_eq!(root.sign_of(&(&x - Poly::constant(ratio(126, 100)))), Some(Ordering::Less));
        assert_eq!(root.sign_of(&Poly::variable(&Variable::new(1, "v"))), None);
        let same = (&cube * (x.pow(3) + &x - Poly::integer(7))).real_roots(&u()).unwrap();
        assert_eq!(root.compare(&same[0]), Ordering::Equal);
        assert_eq!(root.compare(&same[1]), Ordering::Less);
        assert_eq!(root.compare_number(&Poly::sqrt_of(&integer(2))), Ordering::Less);
        assert_eq!(root.to_decimal(30), "1.259921049894873164767210607278");
        assert!(root.enclosure(100).width() <= Rational::new(Int::ONE, Int::ONE.shl(100)));
    }
}
