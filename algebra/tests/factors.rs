//! Greatest common divisors, squarefree decompositions and resultants against naive twins, over several fields.

#[path = "naive/euclid.rs"]
mod euclid;
#[path = "support/factors.rs"]
mod support;

use euclid::naive_gcd;
use hodograph_algebra::{Poly, Variable, budget, integer, ratio};
use proptest::prelude::*;
use support::{Coefficients, determinant, polynomials, sylvester, variables};

/// Checks the gcd of a·g and b·g in all ways.
fn check_gcd(a: &Poly, b: &Poly, g: &Poly) -> Result<(), TestCaseError> {
    let (x, y) = (a * g, b * g);
    let gcd = x.gcd(&y);
    prop_assert!(gcd.is_valid());
    prop_assert_eq!(&gcd, &naive_gcd(&x, &y));
    prop_assert_eq!(&gcd, &y.gcd(&x));
    prop_assert_eq!(&gcd, &gcd.normalized());
    prop_assert!(g.divides(&gcd) && gcd.divides(&x) && gcd.divides(&y));
    if !gcd.is_zero() {
        let cofactors = [&x, &y].map(|poly| poly.exact_div(&gcd).expect("the gcd divides"));
        prop_assert!(Poly::coprime(&cofactors));
    }
    Ok(())
}

fn check_squarefree(factors: &[(Poly, u32)]) -> Result<(), TestCaseError> {
    let poly: Poly = factors.iter().map(|(factor, multiplicity)| factor.pow(*multiplicity)).product();
    let decomposition = poly.squarefree();
    prop_assert_eq!(&decomposition.product(), &poly);
    prop_assert!(decomposition.unit.is_constant());
    for (i, (factor, multiplicity)) in decomposition.factors.iter().enumerate() {
        prop_assert!(!factor.is_constant() && *multiplicity > 0 && *factor == factor.normalized());
        for variable in factor.occurring_variables() {
            let common = naive_gcd(factor, &factor.derivative(&variable));
            prop_assert!(!common.contains(&variable), "{} has the square of a factor of {}", factor, common);
        }
        for (other, _) in &decomposition.factors[..i] {
            prop_assert!(naive_gcd(factor, other).is_one());
        }
    }
    if !poly.is_zero() {
        for (factor, multiplicity) in factors {
            // A factor that was put in with some multiplicity divides the product of what has at least that one.
            let parts = decomposition.factors.iter().filter(|(_, found)| found >= multiplicity);
            let product: Poly = parts.map(|(part, found)| part.pow(*found)).product();
            prop_assert!(factor.is_constant() || factor.divides(&product));
        }
    }
    Ok(())
}

fn check_resultant(a: &Poly, b: &Poly) -> Result<(), TestCaseError> {
    let [variable, ..] = variables();
    let resultant = a.resultant(b, &variable);
    if a.is_zero() || b.is_zero() {
        prop_assert!(resultant.is_zero());
    } else {
        prop_assert_eq!(resultant, determinant(sylvester(a, b, &variable)));
    }
    Ok(())
}

macro_rules! over {
    ($name:ident, $coefficients:expr, $cases:expr) => {
        mod $name {
            use super::*;

            proptest! {
                #![proptest_config(ProptestConfig::with_cases($cases))]

                #[test]
                fn gcd_agrees_with_the_naive_one(
                    a in polynomials($coefficients, 3, 2),
                    b in polynomials($coefficients, 3, 2),
                    g in polynomials($coefficients, 3, 2),
                ) {
                    check_gcd(&a, &b, &g)?;
                }

                #[test]
                fn squarefree_factors_multiply_to_the_input(
                    a in polynomials($coefficients, 3, 1),
                    b in polynomials($coefficients, 2, 1),
                ) {
                    check_squarefree(&[(a, 1), (b, 2)])?;
                }

                #[test]
                fn resultant_is_sylvesters_determinant(
                    a in polynomials($coefficients, 3, 2),
                    b in polynomials($coefficients, 3, 2),
                ) {
                    check_resultant(&a, &b)?;
                }
            }
        }
    };
}

over!(rationals, Coefficients::Rational, 200);
over!(quadratic, Coefficients::Quadratic, 60);
over!(tower, Coefficients::Tower, 12);

fn u() -> Poly {
    Poly::variable(&Variable::new(0, "u"))
}

fn v() -> Poly {
    Poly::variable(&Variable::new(1, "v"))
}

#[test]
fn gcd_of_trivial_operands() {
    let zero = Poly::zero();
    let third = Poly::constant(ratio(-1, 3));
    assert_eq!(zero.gcd(&zero), zero);
    assert_eq!(zero.gcd(&third), Poly::one());
    assert_eq!((u() * &third).gcd(&zero), u());
    assert_eq!((u() * &third).gcd(&third), Poly::one());
    assert_eq!(u().gcd(&v()), Poly::one());
    assert_eq!((u() * v()).gcd(&(v() * v())), v());
    assert_eq!(Poly::gcd_many(&[]), zero);
    assert!(!Poly::coprime(&[zero.clone(), zero]));
}

#[test]
fn gcd_of_different_fields_meets_in_their_composite() {
    let (two, three) = (Poly::sqrt_of(&integer(2)), Poly::sqrt_of(&integer(3)));
    let a = (u() - &two) * (u() - &three);
    assert_eq!(a.gcd(&(u().pow(2) - Poly::integer(2))), u() - &two);
    assert_eq!(a.gcd(&(u().pow(2) - Poly::integer(6))), Poly::one());
    // √2·u + 2 and u + √2 are associated.
    assert_eq!((&two * u() + Poly::integer(2)).gcd(&(u() + &two)), u() + &two);
}

#[test]
fn gcd_with_large_coefficients_and_leading_coefficients_that_vanish_at_many_points() {
    let large = Poly::integer(10).pow(40) + Poly::constant(ratio(1, 7));
    let g = (v().pow(2) - Poly::integer(1)) * u().pow(3) + &large * v() * u() + Poly::constant(ratio(3, 11));
    let a = &g * (u().pow(4) * v() + &large);
    let b = &g * (u() * v().pow(5) - Poly::integer(13));
    assert_eq!(a.gcd(&b), g.normalized());
}

#[test]
fn gcd_where_the_first_primes_are_unlucky() {
    // Modulo each of the first three primes p of the sequence both are the same polynomial.
    let primes = [57_i64, 87, 117].map(|gap| Poly::integer((1 << 62) - gap));
    let product: Poly = primes.into_iter().product();
    assert_eq!((u() + v()).gcd(&(u() + v() + &product)), Poly::one());
    let (a, b) = ((u() + v()) * (u() * &product + v()), (u() + v()) * (v() + Poly::one()));
    assert_eq!(a.gcd(&b), u() + v());
}

#[test]
fn gcd_ends_at_its_budget() {
    let g = (u() + v() + Poly::one()).pow(8);
    let (a, b) = (&g * (u() - v()).pow(3), &g * (u() + v() * Poly::integer(7)));
    assert_eq!(budget::with_budget(u64::MAX, || a.gcd(&b)), Ok(g));
    assert!(budget::with_budget(3_000, || a.gcd(&b)).is_err());
}

#[test]
fn contents_and_primitive_parts() {
    let [variable, ..] = variables();
    let poly = (u().pow(2) * v() + u()) * (v() - Poly::integer(2)) * Poly::constant(ratio(2, 3));
    assert_eq!(poly.content_in(&variable), v() - Poly::integer(2));
    assert_eq!(poly.primitive_in(&variable) * poly.content_in(&variable), poly);
    assert!(Poly::zero().primitive_in(&variable).is_zero());
}

#[test]
fn resultants_without_the_variable() {
    let [variable, ..] = variables();
    assert_eq!(v().resultant(&u().pow(3), &variable), v().pow(3));
    assert_eq!(v().resultant(&Poly::integer(5), &variable), Poly::one());
}

/// The parametric speed of a planar Pythagorean-hodograph quintic with symbolic preimage, and its length.
fn symbolic_speed() -> (Poly, Poly) {
    let symbol = |name: &str| Poly::variable(&Variable::new(Variable::SYMBOL, name));
    let rest = Poly::one() - v();
    let quadratic = |names: [&str; 3]| {
        let [first, second, third] = names.map(symbol);
        first * rest.pow(2) + second * &rest * v() * Poly::integer(2) + third * v().pow(2)
    };
    let (a, b) = (quadratic(["a0", "a1", "a2"]), quadratic(["b0", "b1", "b2"]));
    let speed = a.pow(2) + b.pow(2);
    let variable = Variable::new(1, "v");
    let length = speed.integral(&variable).substitute(&variable, &Poly::one());
    (speed, length)
}

#[test]
fn gcd_in_many_variables_is_found_by_sparse_interpolation() {
    let (speed, length) = symbolic_speed();
    let a = &speed * u().pow(2) - &length;
    let b = &length * u() * v() + &speed + Poly::integer(3);
    assert_eq!((&a * &speed).gcd(&(&b * &speed)), speed.normalized());
    let product = &speed * &length;
    // Interpolation on the full grid takes several times as much.
    let work = || (&a * &product).gcd(&(&b * &product));
    assert_eq!(budget::with_budget(8_000_000, work), Ok(product.normalized()));
    let root = Poly::sqrt_of(&integer(2));
    let twisted = &speed * &root * v() + &length;
    assert_eq!((&a * &twisted).gcd(&(&b * &twisted)), twisted.normalized());
}

#[test]
fn squarefree_factors_of_many_variables() {
    let (speed, length) = symbolic_speed();
    let decomposition = (&speed.pow(3) * &length * u().pow(2)).squarefree();
    let factors = [(u(), 2), (length.normalized(), 1), (speed.normalized(), 3)];
    assert_eq!(decomposition.factors, factors);
    assert_eq!(decomposition.radical(), (speed * length * u()).normalized());
}
