//! Polynomials whose sign is decided on: evaluated so that it is right wherever the result is not 0.
//!
//! The difference of two floats has the right sign, and so have products of what has it, and sums of what is known to have the
//! same sign. So a root at an end of the domain, or at its middle, is taken out as a factor x − a or b − x; what is left is
//! usually positive. 1 − u² is (1 − u)·(1 + u), whose error is small relative to itself.
//!
//! A polynomial of both parameters is a sum of products of such factors if all of them have one sign on the domain, else
//! a sum in the Bernstein basis of the domain if its coefficients have one sign. If neither is so, its sign is not proved to be
//! right where it is small.

use hodograph_algebra::{BoxSign, Interval, Poly, Variable, ratio};

use super::accurate;
use super::forms::Range;
use super::separate::{Parameters, Separation};
use super::surface::polynomials;
use super::univariate::Builder;
use crate::program::{Input, Value};

/// The value of a polynomial of both parameters whose coefficients are numbers.
pub(super) fn signed(builder: &mut Builder<'_>, poly: &Poly) -> Value {
    let known: Vec<Poly> = builder.known.iter().map(|(_, poly)| poly.clone()).collect();
    let separation = Separation::new(std::slice::from_ref(poly), None, builder.parameters, &known);
    let terms: Vec<[Signed; 2]> = separation
        .basis
        .iter()
        .zip(&separation.cofactors[0])
        .filter(|(_, cofactor)| !cofactor.is_zero())
        .map(|(f, g)| [Signed::of(builder, f, Input::U), Signed::of(builder, g, Input::V)])
        .collect();
    let sign = |[f, g]: &[Signed; 2]| Some(f.sign? * g.sign?);
    let signs: Vec<Option<i64>> = terms.iter().map(sign).collect();
    let agree = signs.iter().all(|sign| sign.is_some() && *sign == signs[0]);
    if terms.len() > 1 && !agree {
        return accurate::of_one_sign(builder, poly)
            .unwrap_or_else(|| polynomials(builder, std::slice::from_ref(poly))[0]);
    }
    let products: Vec<(Value, Value)> =
        terms.iter().map(|[f, g]| (f.value(builder, Input::U), g.value(builder, Input::V))).collect();
    builder.sum_of_products(&products)
}

/// A polynomial of one parameter, as a product of differences and the rest.
struct Signed {
    /// Differences x − a or b − x with their exponents.
    differences: Vec<(Poly, bool, u32)>,
    rest: Poly,
    /// 1 or −1 if no value of it on the domain has the other sign.
    sign: Option<i64>,
}

impl Builder<'_> {
    /// The value of a polynomial that has roots at the ends of the domain, with these taken out; `None` if it has none, but for
    /// a root 0, which is a factor of what is evaluated around 0 anyway.
    pub(super) fn with_roots(&mut self, poly: &Poly, input: Input) -> Option<Value> {
        let mut signed = Signed::without_sign(poly);
        for (end, is_below) in ends(self, input)? {
            if !end.is_zero() {
                signed.take_out(self.parameters, input, end, is_below);
            }
        }
        (!signed.differences.is_empty()).then(|| signed.value(self, input))
    }
}

/// The ends of a parameter's domain, and whether the parameter is above.
fn ends(builder: &Builder<'_>, input: Input) -> Option<[(Poly, bool); 2]> {
    let [start, end] = builder.range(input)?.ends().clone();
    Some([(start, true), (end, false)])
}

impl Signed {
    fn of(builder: &Builder<'_>, poly: &Poly, input: Input) -> Signed {
        let mut signed = Signed::without_sign(poly);
        let Some(ends) = ends(builder, input) else { return signed };
        let middle = (&ends[0].0 + &ends[1].0).scale(&ratio(1, 2));
        for (end, is_below) in ends {
            signed.take_out(builder.parameters, input, end, is_below);
        }
        let is_definite = signed.take_out(builder.parameters, input, middle, true).is_multiple_of(2);
        let variable = variable(builder.parameters, input);
        let interval = builder.range(input).and_then(Range::interval);
        signed.sign = sign(&signed.rest, variable, interval).filter(|_| is_definite);
        signed
    }

    fn without_sign(poly: &Poly) -> Signed {
        Signed { differences: Vec::new(), rest: poly.clone(), sign: None }
    }

    /// Takes out the factor x − a, or a − x, as often as it is there.
    fn take_out(&mut self, parameters: &Parameters, input: Input, root: Poly, is_below: bool) -> u32 {
        let variable = variable(parameters, input);
        let difference = Poly::variable(variable) - &root;
        let factor = if is_below { difference } else { -difference };
        let mut exponent = 0;
        while let Some(quotient) = self.rest.exact_div(&factor).filter(|_| self.rest.contains(variable)) {
            self.rest = quotient;
            exponent += 1;
        }
        if exponent > 0 {
            self.differences.push((root, is_below, exponent));
        }
        exponent
    }

    fn value(&self, builder: &mut Builder<'_>, input: Input) -> Value {
        let parameter = builder.program.input(input);
        let mut value = builder.polynomial(&self.rest);
        for (root, is_below, exponent) in &self.differences {
            let difference = builder.distance(parameter, root, *is_below);
            let power = builder.power(difference, *exponent as usize);
            value = builder.program.multiply(power, value);
        }
        value
    }
}

fn variable(Parameters { u, v }: &Parameters, input: Input) -> &Variable {
    if input == Input::U { u } else { v }
}

/// The sign of a polynomial that has no zeros on an interval.
fn sign(poly: &Poly, variable: &Variable, interval: Option<Interval>) -> Option<i64> {
    let domain: Vec<(Variable, Interval)> = vec![(variable.clone(), interval?)];
    match poly.sign_on(&domain)? {
        BoxSign::Positive => Some(1),
        BoxSign::Negative => Some(-1),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use hodograph_algebra::{Poly, Variable, integer};

    use super::super::separate::Parameters;
    use super::super::{Preference, univariate::Builder};
    use super::signed;
    use crate::program::{Floats, Variant, interpret};
    use crate::round::round;

    /// The value of a polynomial at (u, v) on the unit square, in floats.
    fn value(poly: &Poly, (u, v): (f64, f64)) -> f64 {
        let parameters = Parameters { u: Variable::new(0, "u"), v: Variable::new(1, "v") };
        let domain = [[integer(0), integer(1)], [integer(0), integer(1)]];
        let mut builder = Builder::new(&parameters, &[], &domain, Preference::Fast);
        let value = signed(&mut builder, poly);
        let program = round(&builder.program).unwrap();
        interpret(&program, &[value], &Floats { u, v, symbols: &[], variant: Variant::Plain }).unwrap()[0]
    }

    #[test]
    fn signs_are_right_next_to_zeros() {
        let (u, v) = (Poly::variable(&Variable::new(0, "u")), Poly::variable(&Variable::new(1, "v")));
        let below = 1.0 - 2.0_f64.powi(-53);
        let circle = Poly::one() - u.pow(2);
        assert_eq!(value(&circle, (below, 0.0)), 2.0_f64.powi(-52));
        // (1 − u²)·(1 + v) + v·(2 − v)
        let sum = &circle * (Poly::one() + &v) + &v * (Poly::integer(2) - &v);
        let found = value(&sum, (below, 2.0_f64.powi(-60)));
        assert!((found / (2.0_f64.powi(-52) + 2.0_f64.powi(-59)) - 1.0).abs() < 1e-15, "{found:e}");
        // 1 − u·v is in no product, but in the Bernstein basis of one sign: (1 − u) + u·(1 − v).
        let corner = Poly::one() - &u * &v;
        let found = value(&corner, (below, below));
        assert!((found / 2.0_f64.powi(-52) - 1.0).abs() < 1e-15, "{found:e}");
        assert_eq!(value(&corner, (1.0, 1.0)), 0.0);
        // A line of zeros within the domain.
        assert!(value(&(&u * Poly::integer(2) - Poly::one()), (0.5 + 2.0_f64.powi(-53), 0.0)) > 0.0);
    }
}
