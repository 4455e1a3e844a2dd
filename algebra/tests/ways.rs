//! Fast ways against naive twins, on operands that are large enough for all of them.

#[path = "naive/brown.rs"]
mod brown;
#[path = "support/config.rs"]
mod config;
#[path = "naive/packed.rs"]
mod packed;
#[path = "naive/pairs.rs"]
mod pairs;
#[path = "naive/square_root.rs"]
mod square_root;

use brown::brown_gcd;
use config::config;
use hodograph_algebra::{
    ControlNet, Fraction, Homogeneous, Int, Interval, Poly, SweptSurface, Variable, Vector, integer, ratio,
    rational_sqrt,
};
use num_integer::binomial;
use packed::{pack, product_by_heap, product_by_map, quotient_by_map};
use pairs::Pair;
use proptest::prelude::*;
use square_root::square_root;

const VARIABLES: usize = 4;

fn variables() -> Vec<Variable> {
    (0..VARIABLES as u32).map(|rank| Variable::new(rank, "x")).collect()
}

/// Polynomials over the rationals of at most `terms` terms with exponents up to `highest`, whose coefficients have up to `bits` more
/// bits.
fn polynomials(terms: usize, highest: u32, bits: u32) -> impl Strategy<Value = Poly> {
    let term = (prop::collection::vec(0..=highest, VARIABLES), -9_i64..=9, 0..=bits);
    prop::collection::vec(term, 1..=terms).prop_map(|terms| {
        let value = |(exponents, value, bits): (Vec<u32>, i64, u32)| {
            let powers = variables().into_iter().zip(exponents);
            let monomial: Poly =
                powers.map(|(variable, exponent)| Poly::variable(&variable).pow(exponent)).product();
            monomial.scale(&(Int::from(value).shl(bits.into()) + Int::from(value)).into())
        };
        terms.into_iter().map(value).sum()
    })
}

/// Operands of all shapes: dense, sparse, scattered, and with large coefficients.
fn operands() -> impl Strategy<Value = [Poly; 3]> {
    let shape = |terms, highest, bits| {
        [polynomials(terms, highest, bits), polynomials(terms, highest, bits), polynomials(2, highest, bits)]
    };
    prop_oneof![shape(60, 2, 8), shape(30, 9, 0), shape(12, 500, 30), shape(8, 3, 300)]
}

proptest! {
    #![proptest_config(config(48))]

    #[test]
    fn products_and_quotients([a, b, r] in operands()) {
        prop_assume!(!a.is_zero() && !b.is_zero());
        let names = variables();
        let [x, y] = [&a, &b].map(|poly| pack(poly, &names));
        let product = &a * &b;
        prop_assert_eq!(&pack(&product, &names), &product_by_map(&x, &y));
        prop_assert_eq!(product_by_heap(&x, &y), product_by_map(&x, &y));
        for dividend in [product.clone(), product + r * &a] {
            // Primitive polynomials have primitive integer quotients.
            let expected = quotient_by_map(&pack(&dividend, &names), &y, VARIABLES);
            prop_assert_eq!(dividend.exact_div(&b).map(|quotient| pack(&quotient, &names)), expected);
        }
    }

    #[test]
    fn gcds(a in polynomials(6, 3, 0), b in polynomials(6, 3, 0), g in polynomials(8, 4, 0)) {
        prop_assume!(!a.is_zero() && !b.is_zero() && !g.is_zero());
        let (x, y) = (&a * &g, &b * &g);
        prop_assert_eq!(Some(x.gcd(&y)), brown_gcd(&x, &y, &variables()));
    }

    #[test]
    fn squares(f in polynomials(5, 3, 4), g in polynomials(2, 2, 0), factor in 1_i64..5) {
        let square = &f * &f;
        for poly in [square.clone(), square.scale(&integer(factor)), &square * &g, square + &g] {
            let split = poly.square_split();
            prop_assert_eq!(&split.root * &split.root * &split.odd * &split.unit, poly.clone());
            let root = square_root(&poly);
            let unit = split.unit.to_rational().and_then(|unit| rational_sqrt(&unit));
            let found = unit.filter(|_| split.is_square()).map(|unit| split.root.scale(&unit));
            prop_assert_eq!(found, root);
        }
    }

    #[test]
    fn equality_of_polynomials_of_different_rings(a in polynomials(5, 3, 0), b in polynomials(2, 3, 0)) {
        let further = Poly::variable(&Variable::new(Variable::SYMBOL, "a")) * Poly::sqrt_of(&integer(2));
        let widened = &a + &further - &further;
        prop_assert_eq!(&widened, &a);
        prop_assert!(widened.is_valid());
        prop_assert_eq!(&widened + &b == a, b.is_zero());
    }
}

/// The division over a number field that takes off one monomial in the variables after the other.
fn field_quotient(dividend: &Poly, divisor: &Poly) -> Option<Poly> {
    let leading = |poly: &Poly| poly.ring().exponents(poly.ring().variable_part(poly.terms()[0].monomial));
    let names = variables();
    let exponents = |poly: &Poly| {
        let own = leading(poly);
        names
            .iter()
            .map(|name| poly.ring().position(name).map_or(0, |place| own[place]))
            .collect::<Vec<u32>>()
    };
    let (inverse, lowest) = (divisor.leading_coefficient().inverse(), exponents(divisor));
    let (mut rest, mut quotient) = (dividend.clone(), Poly::zero());
    while !rest.is_zero() {
        let mut term = rest.leading_coefficient() * &inverse;
        for ((name, exponent), least) in names.iter().zip(exponents(&rest)).zip(&lowest) {
            term *= Poly::variable(name).pow(exponent.checked_sub(*least)?);
        }
        // Remainders of lower degree in another variable need not end.
        if names.iter().any(|name| term.degree(name) > dividend.degree(name)) {
            return None;
        }
        rest -= &term * divisor;
        quotient += term;
    }
    Some(quotient)
}

proptest! {
    #![proptest_config(config(16))]

    #[test]
    fn quotients_over_number_fields(
        parts in prop::array::uniform4(polynomials(8, 3, 0)),
        nested in any::<bool>(),
    ) {
        let root = Poly::sqrt_of(&integer(2));
        let theta = (Poly::integer(110) + &root * Poly::integer(100)).sqrt().expect("a positive number");
        let other = if nested { theta } else { Poly::sqrt_of(&integer(5)) };
        let [a, b, c, d] = parts;
        let (x, y) = (&a + &b * &root + &c * &other, &d + &b * (&other * &root) + &c);
        prop_assume!(!y.is_zero() && !x.is_zero());
        let product = &x * &y;
        prop_assert_eq!(product.exact_div(&y), Some(x));
        for dividend in [product.clone(), product + &a] {
            prop_assert_eq!(dividend.exact_div(&y), field_quotient(&dividend, &y));
        }
    }
}

/// Polynomials of low degree in two parameters.
fn bivariate() -> impl Strategy<Value = Poly> {
    prop::collection::vec((0..3_u32, 0..3_u32, -4..5_i64), 1..4).prop_map(|terms| {
        let [u, v] = parameters();
        let term =
            |(i, j, value)| Poly::variable(&u).pow(i) * Poly::variable(&v).pow(j) * Poly::integer(value);
        terms.into_iter().map(term).sum()
    })
}

fn parameters() -> [Variable; 2] {
    [Variable::new(0, "u"), Variable::new(1, "v")]
}

/// Rational functions over powers of two known factors.
fn fractions() -> impl Strategy<Value = Fraction> {
    (bivariate(), 0..3_u32, 0..2_u32).prop_map(|(numerator, i, j)| {
        let [u, v] = parameters().map(|parameter| Poly::variable(&parameter));
        Fraction::new(numerator, [(u.pow(2) + Poly::one(), i), (&u * &v + Poly::integer(2), j)])
    })
}

/// Whether a pair in lowest terms is a fraction.
fn check(pair: &Pair, fraction: &Fraction) -> Result<(), TestCaseError> {
    prop_assert_eq!(fraction.numerator() * &pair.denominator, &pair.numerator * fraction.denominator());
    let lowest = fraction.lowest_terms().denominator();
    prop_assert_eq!(lowest.normalized(), pair.denominator.normalized());
    Ok(())
}

/// The vector product of the partial derivatives, over one denominator.
fn cross_of_derivatives(position: &[Pair; 3]) -> [Pair; 3] {
    let [along_u, along_v] =
        parameters().map(|p| position.each_ref().map(|component| component.derivative(&p)));
    let minor = |i: usize, j: usize| along_u[i].mul(&along_v[j]).sub(&along_u[j].mul(&along_v[i]));
    [minor(1, 2), minor(2, 0), minor(0, 1)]
}

proptest! {
    #![proptest_config(config(32))]

    #[test]
    fn known_factors(a in fractions(), b in fractions()) {
        let [x, y] = [&a, &b].map(Pair::of);
        check(&x, &a)?;
        check(&x.sub(&y), &(&a - &b))?;
        check(&x.mul(&y), &(&a * &b))?;
        for parameter in parameters() {
            check(&x.derivative(&parameter), &a.derivative(&parameter))?;
        }
    }

    #[test]
    fn coordinates_normals_and_nets(x in fractions(), y in fractions(), z in fractions()) {
        let domain = [Interval::unit(), Interval::new(Poly::integer(-1), Poly::integer(2)).expect("an interval")];
        let surface = SweptSurface::new(Vector::new(x.clone(), y.clone(), z.clone()), parameters(), domain.clone());
        let position = [&x, &y, &z].map(Pair::of);
        // Homogeneous coordinates: the same point, without a common factor.
        let homogeneous = surface.homogeneous();
        let [w, coordinates @ ..] = homogeneous.coordinates();
        for (pair, coordinate) in position.iter().zip(coordinates) {
            prop_assert_eq!(coordinate * &pair.denominator, w * &pair.numerator);
        }
        prop_assert!(Poly::coprime(homogeneous.coordinates()));
        check_net(homogeneous, &domain)?;
        // The normal: along the product of the derivatives, without a common factor, whatever directions are known.
        let naive = cross_of_derivatives(&position);
        let Ok(normal) = surface.normal() else {
            prop_assert!(naive.iter().all(|component| component.numerator.is_zero()));
            return Ok(());
        };
        prop_assert!(normal.is_valid());
        for (pair, component) in naive.iter().zip(normal.numerator()) {
            check(pair, &(normal.factor() * &Fraction::from(component.clone())))?;
        }
        let known = surface.homogeneous().cartesian();
        let along = [known.derivative(&parameters()[0]), Vector::unit(2)];
        let again = SweptSurface::new(known, parameters(), domain).with_directions(&along);
        prop_assert_eq!(again.normal().expect("a surface").numerator(), normal.numerator());
        let square: Poly = normal.numerator().iter().map(|component| component * component).sum();
        prop_assert_eq!(normal.squared_length().expanded(), Some(&square));
    }
}

/// Whether the control net, multiplied with the Bernstein polynomials, gives the coordinates.
fn check_net(surface: &Homogeneous, domain: &[Interval; 2]) -> Result<(), TestCaseError> {
    let net = ControlNet::of(surface, domain);
    let basis = [0, 1].map(|axis: usize| {
        let t = (Poly::variable(&parameters()[axis]) - domain[axis].lower()) * domain[axis].width().inverse();
        let degree = net.degree[axis];
        let element = |i: u32| {
            let product = t.pow(i) * (Poly::one() - &t).pow(degree - i);
            product.scale(&ratio(binomial(i64::from(degree), i64::from(i)), 1))
        };
        (0..=degree).map(element).collect::<Vec<Poly>>()
    });
    for (place, coordinate) in surface.coordinates().iter().enumerate() {
        let mut sum = Poly::zero();
        for (row, left) in net.points.iter().zip(&basis[0]) {
            for (point, right) in row.iter().zip(&basis[1]) {
                sum += &point[place] * left * right;
            }
        }
        prop_assert_eq!(&sum, coordinate);
    }
    Ok(())
}

#[test]
fn the_table_of_twins_names_tests_that_exist() {
    let table = include_str!("../src/algorithms.md");
    let mut names = 0;
    for row in table.lines().filter(|line| line.contains("`: `")) {
        let mut source = String::new();
        for quoted in row.split('`').skip(1).step_by(2) {
            if quoted.ends_with(".rs") {
                let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join(quoted);
                source = std::fs::read_to_string(&path).expect(quoted);
            } else if !source.is_empty() {
                assert!(source.contains(&format!("fn {quoted}(")), "{quoted}");
                names += 1;
            }
        }
    }
    assert!(names > 30);
}
