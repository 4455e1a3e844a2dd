//! How errors of operands become errors of results, in one format and variant.
//!
//! The error of a computed value x̂ is kept in two forms. Absolutely, |x̂ − x| ≤ `absolute`; and relatively, as
//! |x̂ − x| ≤ `relative`·|x| + `tiny`, where `tiny` comes from underflow alone. The second one survives where x
//! vanishes. The rules are those of running error analysis (Higham, *Accuracy and Stability of Numerical
//! Algorithms*, 2nd ed., 2002, §2.2, §3.3, with all terms of second order), with the half unit in the last
//! place of a rounded result in place of u·|x|: a number below 2^(k+1) in magnitude is rounded by at most
//! u·2^k, and by at most half of the least subnormal number η where it is subnormal. Sums of floats do not
//! underflow (ibid., problem 2.19), and a difference of two floats within a factor of two of each other is
//! exact (Sterbenz; ibid., theorem 2.5).

use super::dyadic::Dyadic;
use super::place::Place;
use super::{Precision, Rounding};
use crate::program::Variant;

/// A factor of an error relative to a value, in units of 2^-16 u; [`Relative::UNKNOWN`] if there is none.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(super) struct Relative(u64);

impl Relative {
    /// No error.
    pub(super) const NONE: Relative = Relative(0);
    /// u
    const UNIT: Relative = Relative(1 << 16);
    /// What may be worth being improved.
    const LARGE: Relative = Relative(16 << 16);
    /// No bound.
    pub(super) const UNKNOWN: Relative = Relative(u64::MAX);

    /// Whether it is a bound.
    pub(super) fn is_known(self) -> bool {
        self.0 != u64::MAX
    }
}

/// Bounds of the error of a computed value.
#[derive(Clone, Copy, Debug)]
pub(super) struct Error {
    pub(super) absolute: Dyadic,
    pub(super) relative: Relative,
    pub(super) tiny: Dyadic,
    /// Whether there are bounds; all others say nothing if not.
    pub(super) is_known: bool,
    /// Whether x̂ is 0 or has the sign of x, which is not 0 then.
    pub(super) keeps_sign: bool,
}

impl Error {
    /// The error of what is exact.
    pub(super) const NONE: Error =
        Error { keeps_sign: true, ..Error::new(Dyadic::ZERO, Relative::NONE, Dyadic::ZERO) };

    /// No bound.
    pub(super) const UNKNOWN: Error = Error {
        absolute: Dyadic::ZERO,
        relative: Relative::UNKNOWN,
        tiny: Dyadic::ZERO,
        is_known: false,
        keeps_sign: false,
    };

    const fn new(absolute: Dyadic, relative: Relative, tiny: Dyadic) -> Error {
        Error { absolute, relative, tiny, is_known: true, keeps_sign: false }
    }

    /// Whether the value is exact.
    pub(super) fn is_none(&self) -> bool {
        self.is_known && self.absolute.is_zero()
    }

    /// The larger errors of both.
    pub(super) fn max(&self, other: &Error) -> Error {
        Error {
            absolute: self.absolute.max(other.absolute),
            relative: self.relative.max(other.relative),
            tiny: self.tiny.max(other.tiny),
            is_known: self.is_known && other.is_known,
            keeps_sign: self.keeps_sign && other.keeps_sign,
        }
    }
}

/// An operand: its values and their error.
pub(super) type Operand<'a> = (&'a Place, &'a Error);

/// What happens to a result.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Rounds {
    /// It is a float.
    Exactly,
    /// It is a float unless it is subnormal.
    WhereSubnormal,
    /// It is rounded, and a float where it is subnormal.
    Sum,
    /// It is rounded.
    Product,
}

/// Powers of two, by their least and greatest exponents, which a value is multiplied by in the computation but
/// not in the exact values that it is compared with.
pub(super) type Spread = (i32, i32);

/// A format of floats, and how a product is added in it.
#[derive(Clone, Copy, Debug)]
pub(super) struct Format {
    /// u = 2^-bits
    bits: i32,
    /// The exponent of half the least subnormal number.
    underflow: i32,
    /// The exponent of the least normal number.
    normal: i32,
    /// Numbers below 2^limit do not overflow.
    limit: i32,
    fused: bool,
}

impl Format {
    pub(super) fn new(rounding: Rounding) -> Format {
        let fused = rounding.variant == Variant::Fused;
        match rounding.precision {
            Precision::Double => Format { bits: 53, underflow: -1075, normal: -1022, limit: 1023, fused },
            Precision::Single => Format { bits: 24, underflow: -150, normal: -126, limit: 127, fused },
        }
    }

    /// A number in units of u.
    pub(super) fn in_units(&self, number: Dyadic) -> Dyadic {
        number.scaled(self.bits)
    }

    /// A relative error as a number.
    pub(super) fn number(&self, relative: Relative) -> Dyadic {
        Dyadic::new((relative.0.min(1 << 62)) as i64, -self.bits - 16)
    }

    /// `error`/`least` for `least` > 0.
    pub(super) fn relative(&self, error: Dyadic, least: Dyadic) -> Relative {
        let quotient = error.over(least).scaled(self.bits + 16);
        self.known(quotient.ceiling().unwrap_or(u64::MAX))
    }

    /// A relative error that is at most 1/2 and small enough to be computed with.
    fn known(&self, relative: u64) -> Relative {
        let most = 1_u64 << (self.bits + 15).min(60);
        if relative <= most { Relative(relative) } else { Relative::UNKNOWN }
    }

    /// (1 + a)(1 + b) − 1
    fn compound(&self, a: Relative, b: Relative) -> Relative {
        if a.0 == 0 {
            return b;
        }
        if b.0 == 0 {
            return a;
        }
        if a.0 == u64::MAX || b.0 == u64::MAX {
            return Relative::UNKNOWN;
        }
        let shift = self.bits + 16;
        // Known ones are at most 2^60.
        let product = match a.0 < 1 << 31 && b.0 < 1 << 31 {
            // The shift is 40 or 69.
            true => (a.0 * b.0) >> shift.min(63),
            false => ((a.0 as u128 * b.0 as u128) >> shift) as u64,
        };
        self.known(a.0 + b.0 + product + 1)
    }

    /// The error of a result whose operands alone give it the error `passed`.
    fn rounded(&self, place: &Place, passed: Error, rounds: Rounds, spread: Spread) -> Error {
        let mut error = passed;
        let largest = place.largest.plus(passed.absolute);
        let binade = largest.magnitude();
        if binade + spread.1 >= self.limit {
            return Error::UNKNOWN;
        }
        if rounds == Rounds::Exactly || largest.is_zero() {
            return error;
        }
        let underflow = self.underflow - spread.0;
        // What is passed is at most half of a value then.
        let close = passed.relative.is_known() && passed.tiny.is_zero();
        let normal = close && place.least.magnitude() + spread.0 > self.normal + 1;
        if rounds == Rounds::WhereSubnormal {
            if !normal {
                error.absolute = error.absolute.plus(Dyadic::power_of_two(underflow));
                error.tiny = error.tiny.plus(Dyadic::power_of_two(underflow));
            }
            return error;
        }
        // A power of two as the largest result is a float itself.
        let half_unit = if largest.is_power_of_two() { binade - 1 } else { binade } - self.bits;
        let exponent = if rounds == Rounds::Product && half_unit < underflow { underflow } else { half_unit };
        error.absolute = error.absolute.plus(Dyadic::power_of_two(exponent));
        error.relative = self.compound(error.relative, Relative::UNIT);
        if error.tiny.is_positive() {
            error.tiny = error.tiny.plus(error.tiny.scaled(-self.bits));
        }
        if rounds == Rounds::Product && !normal {
            error.tiny = error.tiny.plus(Dyadic::power_of_two(underflow));
        }
        error
    }

    /// The same error with the absolute bound that the relative one gives, where it is better.
    pub(super) fn lessened(&self, place: &Place, error: &Error) -> Error {
        if !error.relative.is_known() {
            return *error;
        }
        let product = self.number(error.relative).times(place.largest).plus(error.tiny);
        Error { absolute: error.absolute.min(product), ..*error }
    }

    /// The same error with the best relative bound that can be told from it: where x is not 0, there is one
    /// without `tiny`.
    pub(super) fn best(&self, place: &Place, error: &Error) -> Error {
        if !place.least.is_positive() {
            return *error;
        }
        let direct = self.relative(error.absolute, place.least);
        let folded = match error.relative.is_known() && error.tiny.is_positive() {
            true => self.known(error.relative.0 + self.relative(error.tiny, place.least).0.min(1 << 62)),
            false => error.relative,
        };
        let relative = direct.min(folded);
        if relative.is_known() { Error { relative, tiny: Dyadic::ZERO, ..*error } } else { *error }
    }

    /// The error of a constant that is off by `absolute`.
    pub(super) fn constant(&self, place: &Place, absolute: Dyadic) -> Error {
        if place.largest.plus(absolute).magnitude() >= self.limit {
            return Error::UNKNOWN;
        }
        let relative = match absolute.is_zero() {
            true => Relative::NONE,
            false if place.least.is_positive() => self.relative(absolute, place.least),
            false => Relative::UNKNOWN,
        };
        Error::new(absolute, relative, Dyadic::ZERO)
    }

    /// What a·b has from a and b: e_a·(|b| + e_b) + e_b·|a|, where e_a·|b| is at most r_a·|a·b| too, and so on.
    fn passed_product(&self, (a, of_a): Operand<'_>, (b, of_b): Operand<'_>, product: &Place) -> Error {
        let part = |error: &Error, other: &Place| {
            let part = error.absolute.times(other.largest);
            match error.relative.is_known() && error.tiny.is_zero() {
                true => part.min(self.number(error.relative).times(product.largest)),
                false => part,
            }
        };
        let mut absolute = Dyadic::ZERO;
        if !of_a.absolute.is_zero() {
            absolute = part(of_a, b).plus(of_a.absolute.times(of_b.absolute));
        }
        if !of_b.absolute.is_zero() {
            absolute = absolute.plus(part(of_b, a));
        }
        let mut tiny = Dyadic::ZERO;
        if of_a.tiny.is_positive() {
            tiny = of_a.tiny.times(b.largest.plus(of_b.absolute));
        }
        if of_b.tiny.is_positive() {
            let factor = a.largest.plus(of_a.absolute).plus(of_a.tiny);
            tiny = tiny.plus(of_b.tiny.times(factor));
        }
        Error::new(absolute, self.compound(of_a.relative, of_b.relative), tiny)
    }

    /// What a + b has from a and b; `agree` says that they have one sign.
    fn passed_sum(&self, of_a: &Error, of_b: &Error, agree: bool) -> Error {
        let relative = match agree {
            true => of_a.relative.max(of_b.relative),
            // A difference of floats is rounded, and nothing else.
            false if of_a.is_none() && of_b.is_none() => Relative::NONE,
            false => Relative::UNKNOWN,
        };
        let tiny = if agree { of_a.tiny.plus(of_b.tiny) } else { Dyadic::ZERO };
        Error::new(of_a.absolute.plus(of_b.absolute), relative, tiny)
    }

    /// The error of a + b, whose values are at `place`.
    pub(super) fn sum(
        &self,
        (a, of_a): Operand<'_>,
        (b, of_b): Operand<'_>,
        place: &Place,
        spread: Spread,
    ) -> Error {
        if !of_a.is_known || !of_b.is_known {
            return Error::UNKNOWN;
        }
        let agree = a.range.agrees_with(&b.range);
        let rounds = if !agree && is_exact(a, of_a, b, of_b) { Rounds::Exactly } else { Rounds::Sum };
        let error = self.rounded(place, self.passed_sum(of_a, of_b, agree), rounds, spread);
        self.improved(place, error)
    }

    /// The error of a·b, whose values are at `place`; `rounds` says what happens to the product.
    pub(super) fn product(
        &self,
        (a, of_a): Operand<'_>,
        (b, of_b): Operand<'_>,
        place: &Place,
        rounds: Rounds,
        spread: Spread,
    ) -> Error {
        if !of_a.is_known || !of_b.is_known {
            return Error::UNKNOWN;
        }
        self.rounded(place, self.passed_product((a, of_a), (b, of_b), place), rounds, spread)
    }

    /// The error of a·b + c, whose values are at `place`, and those of a·b at `product`.
    pub(super) fn product_and_sum(
        &self,
        [(a, of_a), (b, of_b), (c, of_c)]: [Operand<'_>; 3],
        product: &Place,
        place: &Place,
        rounds: Rounds,
        spread: Spread,
    ) -> Error {
        if !of_a.is_known || !of_b.is_known || !of_c.is_known {
            return Error::UNKNOWN;
        }
        let passed = self.passed_product((a, of_a), (b, of_b), product);
        if !self.fused {
            let first = self.rounded(product, passed, rounds, spread);
            return self.sum((product, &first), (c, of_c), place, spread);
        }
        let passed = self.passed_sum(&passed, of_c, product.range.agrees_with(&c.range));
        let error = self.rounded(place, passed, Rounds::Product, spread);
        self.improved(place, error)
    }

    /// The error of a sum, whose relative error is not what it gets from the relative errors of its terms.
    fn improved(&self, place: &Place, error: Error) -> Error {
        // A sum of a small number with a large relative error and a large number has a small one.
        let poor = error.relative > Relative::LARGE || error.tiny.is_positive();
        if poor && error.is_known { self.best(place, &error) } else { error }
    }

    /// A lower bound of |b̂| and a bound of |b̂ − b|/|b|; the first is not above 0 if b̂ may be 0.
    fn off_zero(&self, b: &Place, of_b: &Error) -> (Dyadic, Relative) {
        if !of_b.is_known || !b.least.is_positive() {
            return (Dyadic::ZERO, Relative::UNKNOWN);
        }
        let least = -of_b.absolute.plus(-b.least);
        let direct = self.relative(of_b.absolute, b.least);
        let relative = if of_b.tiny.is_zero() { direct.min(of_b.relative) } else { direct };
        if relative.is_known() { (least, relative) } else { (Dyadic::ZERO, relative) }
    }

    /// The error of a/b, whose values are at `place`; none if b̂ may be 0.
    pub(super) fn quotient(
        &self,
        of_a: &Error,
        (b, of_b): Operand<'_>,
        place: &Place,
        spread: Spread,
    ) -> Error {
        let (least, relative) = self.off_zero(b, of_b);
        if !of_a.is_known || !least.is_positive() {
            return Error::UNKNOWN;
        }
        // â/b̂ − a/b = (δa − (a/b)·δb)/b̂
        let absolute = of_a.absolute.plus(place.largest.times(of_b.absolute)).over(least);
        // (1 + r_a)/(1 − r_b) ≤ (1 + r_a)(1 + r_b + 2 r_b²) for r_b ≤ 1/2
        let square = self.compound(relative, relative);
        let inverse = match square.is_known() {
            // 2 r + r² − r is r + r², and once more r².
            true => self.known(square.0 + (square.0 - 2 * relative.0) - relative.0),
            false => Relative::UNKNOWN,
        };
        let tiny = if of_a.tiny.is_positive() { of_a.tiny.over(least) } else { Dyadic::ZERO };
        let passed = Error::new(absolute, self.compound(of_a.relative, inverse), tiny);
        self.lessened(place, &self.rounded(place, passed, Rounds::Product, spread))
    }

    /// The error of √x, whose values are at `place`; none if x̂ may be 0 or below.
    pub(super) fn root(&self, (x, of_x): Operand<'_>, place: &Place, spread: Spread) -> Error {
        let (least, relative) = self.off_zero(x, of_x);
        if !least.is_positive() {
            return Error::UNKNOWN;
        }
        // |√x̂ − √x| = |x̂ − x|/(√x̂ + √x)
        let roots = -(-least.root_down()).plus(-x.least.root_down());
        let absolute = of_x.absolute.over(roots);
        let passed = Error::new(absolute, self.half(relative), Dyadic::ZERO);
        self.lessened(place, &self.rounded(place, passed, Rounds::Sum, spread))
    }

    /// The relative error of a root whose radicand has this one: 1 − √(1 − r) ≤ r/2 + r²/2 for r ≤ 1.
    fn half(&self, relative: Relative) -> Relative {
        let square = self.compound(relative, relative);
        if square.is_known() { self.known((square.0 - relative.0).div_ceil(2)) } else { square }
    }

    /// The error of √(a² + b² + …), whose values are at `place`; it is bounded where the root vanishes too.
    ///
    /// The root is the norm of (a, b, …), which changes by no more than the norm of the change. Each square is
    /// rounded at most as many times as there are squares, which changes the sum relative to itself.
    pub(super) fn norm(&self, parts: &[Operand<'_>], place: &Place, spread: Spread) -> Error {
        let mut squares = Dyadic::ZERO;
        let mut relative = Relative::NONE;
        let mut rounding = Relative::NONE;
        let mut normal = true;
        for (part, error) in parts {
            if !error.is_known {
                return Error::UNKNOWN;
            }
            squares = squares.plus(error.absolute.times(error.absolute));
            relative = if error.tiny.is_zero() { relative.max(error.relative) } else { Relative::UNKNOWN };
            rounding = self.compound(rounding, Relative::UNIT);
            // What is passed is at most half of a value then.
            let close = error.relative.is_known() && error.tiny.is_zero();
            normal &= close && 2 * (part.least.magnitude() + spread.0) > self.normal + 4;
        }
        let (change, half) = (squares.root(), self.half(rounding));
        let mut absolute = change.plus(self.number(half).times(place.largest.plus(change)));
        let mut tiny = Dyadic::ZERO;
        if !normal {
            // √(x + t) ≤ √x + √t, and there are at most four subnormal squares.
            tiny = Dyadic::power_of_two(self.underflow + 2 - 2 * spread.0).root();
            absolute = absolute.plus(tiny);
        }
        let passed = Error::new(absolute, self.compound(relative, half), tiny);
        self.rounded(place, passed, Rounds::Sum, spread)
    }

    /// The better bounds of two.
    pub(super) fn better(&self, a: &Error, b: &Error) -> Error {
        if !a.is_known || !b.is_known {
            return if a.is_known { *a } else { *b };
        }
        let absolute = a.absolute.min(b.absolute);
        let first = a.relative < b.relative || a.relative == b.relative && a.tiny < b.tiny;
        let (relative, tiny) = if first { (a.relative, a.tiny) } else { (b.relative, b.tiny) };
        Error::new(absolute, relative, tiny)
    }

    /// The error of the distance from a number in parts, at most 5 u of it.
    pub(super) fn distance(&self, place: &Place) -> Error {
        let relative = Relative(5 * Relative::UNIT.0);
        Error::new(self.number(relative).times(place.largest), relative, Dyadic::ZERO)
    }

    /// Whether the sign of x̂ is known to be that of x.
    pub(super) fn is_certain(&self, (x, of_x): Operand<'_>) -> bool {
        of_x.is_known && of_x.absolute.is_below(x.least)
    }

    /// Whether the sum a + b is 0 or has the right sign: operands that do and whose signs agree, or two floats.
    pub(super) fn sum_keeps_sign(&self, (a, of_a): Operand<'_>, (b, of_b): Operand<'_>) -> bool {
        let agree = of_a.keeps_sign && of_b.keeps_sign && a.range.agrees_with(&b.range);
        agree || of_a.is_none() && of_b.is_none()
    }

    /// The exponents of the powers of two that bring the largest of three computed numbers, which is between
    /// `least` and `largest`, to between 1 and 2; `None` if there may be none in the format.
    pub(super) fn scales(&self, least: Dyadic, largest: Dyadic) -> Option<Spread> {
        let exponents = (-largest.magnitude(), -least.magnitude());
        (least.is_positive() && least.magnitude() >= self.normal && largest.magnitude() < self.limit)
            .then_some(exponents)
    }
}

/// Whether a + b is a difference of floats within a factor of two of each other.
fn is_exact(a: &Place, of_a: &Error, b: &Place, of_b: &Error) -> bool {
    let distance = a.largest.magnitude() - b.largest.magnitude();
    if !(-1..=1).contains(&distance) || a.least.is_zero() || b.least.is_zero() {
        return false;
    }
    let low = |place: &Place, error: &Error| -error.absolute.plus(-place.least);
    let high = |place: &Place, error: &Error| place.largest.plus(error.absolute);
    low(a, of_a).scaled(1) >= high(b, of_b) && low(b, of_b).scaled(1) >= high(a, of_a)
}
