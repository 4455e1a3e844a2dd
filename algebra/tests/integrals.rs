//! Integrals of rational functions, compared with derivatives and with one linear system for the whole integral.

use hodograph_algebra::{Fraction, Integral, Poly, Variable, budget, integer, ratio};
use proptest::prelude::*;

fn v() -> Variable {
    Variable::new(1, "v")
}

fn symbol(name: &str) -> Poly {
    Poly::variable(&Variable::new(Variable::SYMBOL, name))
}

/// A polynomial of degree at most 2 in v; coefficients are numbers, with `rich` now and then √2 and a symbol too.
fn poly(rich: bool) -> impl Strategy<Value = Poly> {
    prop::collection::vec((-3..4_i64, 0..8_u8), 1..4).prop_map(move |coefficients| {
        let coefficient = |(value, kind): (i64, u8)| match kind {
            0 if rich => Poly::sqrt_of(&integer(2)).scale(&integer(value)),
            1 if rich => symbol("c").scale(&integer(value)),
            _ => Poly::integer(value),
        };
        let coefficients: Vec<Poly> = coefficients.into_iter().map(coefficient).collect();
        Poly::from_coefficients(&v(), &coefficients)
    })
}

fn fraction(rich: bool) -> impl Strategy<Value = Fraction> {
    let nonzero = move || poly(rich).prop_map(|poly| if poly.is_zero() { Poly::one() } else { poly });
    (poly(rich), poly(rich), nonzero(), nonzero(), 0..4_u32)
        .prop_map(|(a, b, f, g, exponent)| Fraction::new(a * b, [(f, 1), (g, exponent)]))
}

/// What every integral fulfils: `f = rational' + remainder`, and the remainder is a proper fraction with simple poles.
fn check(f: &Fraction, integral: &Integral) {
    let v = v();
    let Integral { rational, remainder } = integral;
    assert_eq!(&rational.derivative(&v) + remainder, *f, "the integral of {f}");
    let denominator = remainder.denominator();
    let degree = |poly: &Poly| poly.degree(&v).map_or(-1, i64::from);
    assert!(remainder.is_zero() || degree(remainder.numerator()) < degree(&denominator), "{remainder}");
    let repeated = denominator.gcd(&denominator.derivative(&v));
    assert!(!repeated.contains(&v), "the denominator of {remainder} has repeated factors");
    assert!(rational.is_valid() && remainder.is_valid());
}

/// Whether the proper part of `f` has a rational integral `B/D⁻`, with `D⁻` the gcd of the denominator and its derivative:
/// one linear system for all coefficients of `B` (Horowitz and Ostrogradsky, without the remainder).
fn has_rational_integral(f: &Fraction) -> bool {
    let v = v();
    let f = f.lowest_terms();
    let denominator = f.denominator();
    let repeated = denominator.gcd(&denominator.derivative(&v));
    let degree = |poly: &Poly| poly.degree(&v).unwrap_or(0);
    // A polynomial part only raises the degree of B.
    let most = degree(f.numerator()).max(degree(&denominator)) + 1 + degree(&repeated);
    let power = |k: u32| Fraction::new(Poly::variable(&v).pow(k), [(repeated.clone(), 1)]).derivative(&v);
    let columns: Vec<Fraction> = (0..=most).map(power).chain([f]).collect();
    let common = Fraction::common_denominator(&columns);
    let columns: Vec<Vec<Poly>> =
        columns.iter().map(|column| column.numerator_over(&common).coefficients(&v)).collect();
    let rows = columns.iter().map(Vec::len).max().unwrap_or(0);
    let entry = |row: usize, column: &[Poly]| column.get(row).cloned().unwrap_or_else(Poly::zero).into();
    let matrix: Vec<Vec<Fraction>> =
        (0..rows).map(|row| columns.iter().map(|column| entry(row, column)).collect()).collect();
    !pivots(matrix).contains(&(columns.len() - 1))
}

/// The columns with a pivot.
fn pivots(mut rows: Vec<Vec<Fraction>>) -> Vec<usize> {
    let mut pivots = Vec::new();
    for column in 0..rows[0].len() {
        let done = pivots.len();
        let Some(found) = (done..rows.len()).find(|&row| !rows[row][column].is_zero()) else { continue };
        rows.swap(done, found);
        let pivot = rows[done].clone();
        for row in rows.iter_mut().skip(done + 1) {
            let factor = row[column].checked_div(&pivot[column]).unwrap();
            for (entry, above) in row.iter_mut().zip(&pivot) {
                *entry = (&*entry - &(&factor * above)).lowest_terms();
            }
        }
        pivots.push(column);
    }
    pivots
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn the_derivative_gives_the_integrand_back(f in fraction(true)) {
        check(&f, &f.integral(&v()));
    }

    #[test]
    fn derivatives_have_rational_integrals(f in fraction(true)) {
        let derivative = f.derivative(&v());
        let integral = derivative.integral(&v());
        check(&derivative, &integral);
        prop_assert!(integral.is_rational());
        // Both differ by a constant.
        prop_assert!((&integral.rational - &f).derivative(&v()).is_zero());
    }

    #[test]
    fn rational_integrals_are_those_of_one_linear_system(f in fraction(false), rational in any::<bool>()) {
        let f = if rational { f.derivative(&v()) } else { f };
        prop_assert_eq!(f.integral(&v()).is_rational(), has_rational_integral(&f));
    }
}

/// By hand: `∫ 1/v² = −1/v`, `∫ 2/(1 + v²)² = v/(1 + v²) + ∫ 1/(1 + v²)`, `∫ (1 + v²)²/v² = v³/3 + 2v − 1/v`.
#[test]
fn integrals_worked_out_by_hand() {
    let x = Poly::variable(&v());
    let circle = x.pow(2) + Poly::one();
    let table = [
        (Fraction::new(Poly::one(), [(x.clone(), 2)]), "-1/v", "0"),
        (Fraction::new(Poly::integer(2), [(circle.clone(), 2)]), "v/(v^2 + 1)", "1/(v^2 + 1)"),
        (Fraction::new(circle.pow(2), [(x.clone(), 2)]), "(1/3*v^4 + 2*v^2 - 1)/v", "0"),
        (Fraction::new(Poly::integer(2), [(circle.clone(), 1)]), "0", "2/(v^2 + 1)"),
        (Fraction::new(x.clone(), [(circle.clone(), 1)]), "0", "v/(v^2 + 1)"),
        (Fraction::new(x.scale(&ratio(-2, 1)), [(circle, 2)]), "1/(v^2 + 1)", "0"),
        (Fraction::zero(), "0", "0"),
    ];
    for (f, rational, remainder) in table {
        let integral = f.integral(&v());
        check(&f, &integral);
        assert_eq!(integral.rational.to_string(), rational, "the integral of {f}");
        assert_eq!(integral.remainder.to_string(), remainder, "the integral of {f}");
    }
}

/// Symbols are constants of general value: of `1/(v² + c)²` only the general case has an arctangent.
#[test]
fn symbols_are_general_constants() {
    let (x, c) = (Poly::variable(&v()), symbol("c"));
    let f = Fraction::new(Poly::one(), [(x.pow(2) + &c, 2)]);
    let integral = f.integral(&v());
    check(&f, &integral);
    assert_eq!(integral.rational, Fraction::new(x.clone(), [(c.scale(&integer(2)), 1), (x.pow(2) + &c, 1)]));
    assert_eq!(
        integral.remainder,
        Fraction::new(Poly::one(), [(c.scale(&integer(2)), 1), (x.pow(2) + &c, 1)])
    );
    // A content of the denominator is a constant factor.
    let f = Fraction::new(Poly::one(), [((&c + Poly::one()) * (&c + x.pow(2)), 1)]);
    check(&f, &f.integral(&v()));
}

/// The square of a symbolic quartic is within reach, and what is not ends by its budget.
#[test]
fn symbolic_quartics() {
    let coefficients: Vec<Poly> = (0..5).map(|k| symbol(&format!("c{k}"))).collect();
    let quartic = Poly::from_coefficients(&v(), &coefficients);
    let f = Fraction::new(Poly::one(), [(quartic.clone(), 1)]);
    let derivative = f.derivative(&v());
    let integral = budget::with_budget(budget::DEFAULT_LIMIT, || derivative.integral(&v())).unwrap();
    assert!(integral.is_rational());
    assert_eq!(integral.rational, f);
    let heavy = Fraction::new(Poly::one(), [(quartic, 4)]);
    assert!(budget::with_budget(1000, || heavy.integral(&v())).is_err());
}
