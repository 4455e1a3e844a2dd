//! The conditions on symbols that change degrees, against derivations with values in place of the symbols.

use std::collections::BTreeMap;
use std::rc::Rc;

use hodograph_algebra::{
    Complex, Conditions, Curve, Fraction, Homogeneous, Interval, KnownProperties, Locus, PhCurve, Poly,
    Preimage, Variable, Vector, integer,
};
use proptest::prelude::*;

fn parameters() -> [Variable; 2] {
    [Variable::new(0, "u"), Variable::new(1, "v")]
}

fn variable(name: &str) -> Variable {
    Variable::new(Variable::SYMBOL, name)
}

fn symbol(name: &str) -> Poly {
    Poly::variable(&variable(name))
}

/// The PH curve whose preimage has the Bernstein coefficients `a_j + I b_j`.
fn symbolic_ph(degree: usize, parameter: &Variable) -> Curve {
    let coefficient = |j| Complex::new(symbol(&format!("a{j}")), symbol(&format!("b{j}")));
    let preimage = Preimage::new((0..=degree).map(coefficient).collect()).unwrap();
    let PhCurve { position, .. } = preimage.curve(parameter, &Complex::new(Poly::zero(), Poly::zero()));
    let position = Vector::new(position.re.into(), position.im.into(), Fraction::zero());
    Curve::new(parameter, position, Some(Interval::unit()), KnownProperties::default(), Rc::default())
}

/// The circle (16): x = (1 − u²)/(1 + u²), z = 2u/(1 + u²).
fn circle(u: &Variable) -> [Fraction; 2] {
    let square = Poly::variable(u).pow(2);
    let over_weight = |numerator: Poly| Fraction::new(numerator, [(&square + Poly::one(), 1)]);
    [over_weight(Poly::one() - &square), over_weight(Poly::variable(u).scale(&integer(2)))]
}

/// The oriented translation (17) of a profile along a curve.
fn oriented_translation(curve: &Curve, [x, z]: &[Fraction; 2]) -> Vector {
    &(curve.position() + &curve.normal().unwrap().scale(x)) + &Vector::unit(2).scale(z)
}

/// The oriented involute sweep (25).
fn oriented_involute(curve: &Curve, [x, z]: &[Fraction; 2]) -> Vector {
    &(&curve.involute().unwrap() - &curve.tangent().unwrap().scale(x)) + &Vector::unit(2).scale(z)
}

/// The generalized conical sweep (30) with the linear scale (29).
fn conical(curve: &Curve, [x, z]: &[Fraction; 2]) -> Vector {
    let [c0, c1] = ["c0", "c1"].map(|name| Fraction::from(symbol(name)));
    let (length, arclength) = (curve.length().unwrap(), curve.arclength().unwrap());
    let scale = &(&(&c0 * &(&length - &arclength)) + &(&c1 * &arclength)) / &length;
    let profile = &curve.normal().unwrap().scale(x) + &Vector::unit(2).scale(z);
    curve.position() + &profile.scale(&scale)
}

/// A sweep of a polynomial profile with symbolic coefficients along a fixed PH cubic.
fn symbolic_profile(v: &Variable, u: &Variable) -> Vector {
    let number = |re, im| Complex::new(Poly::integer(re), Poly::integer(im));
    let preimage = Preimage::new(vec![number(1, 0), number(2, 1)]).unwrap();
    let PhCurve { position, .. } = preimage.curve(v, &number(0, 0));
    let position = Vector::new(position.re.into(), position.im.into(), Fraction::zero());
    let curve = Curve::new(v, position, Some(Interval::unit()), KnownProperties::default(), Rc::default());
    let t = Poly::variable(u);
    let x = symbol("x0") + symbol("x1") * &t + symbol("x2") * t.pow(2);
    let weight = symbol("w1") * &t + Poly::one();
    let z = symbol("z0") + symbol("z1") * &t;
    oriented_translation(&curve, &[Fraction::new(x, [(weight.clone(), 1)]), Fraction::new(z, [(weight, 1)])])
}

/// What a surface is at values of its symbols, derived anew: the degrees of each coordinate, those of the patch, and
/// whether the specialized coordinates have a common factor; `None` if there is no surface.
struct Specialized {
    degrees: [[i64; 2]; 4],
    patch: [i64; 2],
    has_common_factor: bool,
}

fn specialize(surface: &Homogeneous, values: &BTreeMap<Variable, Poly>) -> Option<Specialized> {
    let coordinates = surface.coordinates().each_ref().map(|coordinate| coordinate.evaluate(values));
    if coordinates[0].is_zero() {
        return None;
    }
    let parameters = surface.parameters();
    let degree = |poly: &Poly| parameters.each_ref().map(|by| poly.degree(by).map_or(-1, i64::from));
    let degrees = coordinates.each_ref().map(degree);
    let most = |by: usize| degrees.iter().map(|degree| degree[by]).max().unwrap();
    Some(Specialized { degrees, patch: [most(0), most(1)], has_common_factor: !Poly::coprime(&coordinates) })
}

/// Compares what the conditions predict for values of the symbols with the degrees there.
fn check(surface: &Homogeneous, conditions: &Conditions, values: &BTreeMap<Variable, Poly>) {
    let inside = |locus: &Locus| locus.contains(values).expect("all symbols have values");
    let Some(specialized) = specialize(surface, values) else {
        assert!(inside(&conditions.weight), "W vanishes at {values:?}");
        return;
    };
    assert!(!inside(&conditions.weight), "W does not vanish at {values:?}");
    for (index, generic) in surface.degrees().into_iter().enumerate() {
        for (by, generic) in [generic.u, generic.v].into_iter().enumerate() {
            let lower = specialized.degrees[index][by] < generic;
            assert_eq!(inside(&conditions.coordinates[index][by]), lower, "{index} {by} at {values:?}");
        }
    }
    let patch = surface.degree();
    for (by, generic) in [patch.u, patch.v].into_iter().enumerate() {
        assert_eq!(
            inside(&conditions.patch[by]),
            specialized.patch[by] < generic,
            "patch {by} at {values:?}"
        );
    }
    assert!(conditions.undetermined.is_empty());
    let mut possible = false;
    for case in &conditions.common_factors {
        // Where the parameter is not eliminated, the polynomials themselves tell.
        let certain = match &case.locus {
            Some(locus) => inside(locus),
            None => {
                let moving: Vec<Poly> = case.polynomials.iter().map(|poly| poly.evaluate(values)).collect();
                moving.iter().all(Poly::is_zero) || !Poly::coprime(&moving)
            }
        };
        possible |= certain;
        if certain && case.exact && !inside(&case.except) {
            assert!(specialized.has_common_factor, "a common factor is predicted at {values:?}");
        }
    }
    assert!(possible || !specialized.has_common_factor, "a common factor at {values:?}");
}

/// Every symbol of the surface with one of the numbers, which are small to hit the exceptions often.
fn assign(surface: &Homogeneous, numbers: &[i64]) -> BTreeMap<Variable, Poly> {
    let variables = surface.coordinates().iter().flat_map(Poly::occurring_variables);
    let symbols: std::collections::BTreeSet<Variable> =
        variables.filter(|variable| !surface.parameters().contains(variable)).collect();
    symbols.into_iter().zip(numbers.iter().cycle()).map(|(s, n)| (s, Poly::integer(*n))).collect()
}

/// The surfaces that are specialized, with their conditions.
fn surfaces() -> Vec<(Homogeneous, Conditions)> {
    let [u, v] = parameters();
    let profile = circle(&u);
    let (cubic, quintic) = (symbolic_ph(1, &v), symbolic_ph(2, &v));
    let formulas = [
        oriented_translation(&cubic, &profile),
        oriented_translation(&quintic, &profile),
        oriented_involute(&cubic, &profile),
        oriented_involute(&quintic, &profile),
        conical(&cubic, &profile),
        symbolic_profile(&v, &u),
    ];
    let surface = |formula: &Vector| {
        let surface = Homogeneous::of(formula, &parameters());
        let conditions = Conditions::of(&surface);
        (surface, conditions)
    };
    formulas.iter().map(surface).collect()
}

thread_local! {
    static SURFACES: Vec<(Homogeneous, Conditions)> = surfaces();
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    #[test]
    fn degrees_change_where_the_conditions_say(numbers in prop::collection::vec(-2_i64..=2, 8)) {
        SURFACES.with(|surfaces| {
            for (surface, conditions) in surfaces {
                check(surface, conditions, &assign(surface, &numbers));
            }
        });
    }

    #[test]
    fn degrees_change_on_the_loci_themselves(
        numbers in prop::collection::vec(-3_i64..=3, 8),
        choice in 0_usize..1000,
    ) {
        SURFACES.with(|surfaces| {
            for (surface, conditions) in surfaces {
                let loci = conditions.coordinates.iter().flatten().chain(&conditions.patch);
                let loci = loci.chain(conditions.common_factors.iter().filter_map(|case| case.locus.as_ref()));
                let alternatives: Vec<&Vec<Poly>> = loci.flat_map(Locus::alternatives).collect();
                let mut values = assign(surface, &numbers);
                // What is linear can be satisfied: one symbol after the other takes the value that the rest demands.
                for poly in alternatives[choice % alternatives.len()] {
                    let Some((solved, value)) = solution(poly, &values) else { continue };
                    values.insert(solved, value);
                }
                check(surface, conditions, &values);
            }
        });
    }
}

/// A symbol in which the polynomial is linear, and its value where the polynomial vanishes and the others are as given.
fn solution(poly: &Poly, values: &BTreeMap<Variable, Poly>) -> Option<(Variable, Poly)> {
    poly.occurring_variables().into_iter().find_map(|symbol| {
        let mut others = values.clone();
        others.remove(&symbol);
        let image = poly.evaluate(&others);
        let coefficients = image.coefficients(&symbol);
        let [constant, slope] = <[Poly; 2]>::try_from(coefficients).ok()?;
        Some((symbol, -(constant * slope.inverse())))
    })
}

/// The polynomial whose vanishing means that a and b of a symbolic preimage have a common zero.
fn preimage_resultant(degree: usize) -> Poly {
    let [_, v] = parameters();
    let bernstein = |name: &str| {
        let t = Poly::variable(&v);
        let binomials: &[i64] = if degree == 1 { &[1, 1] } else { &[1, 2, 1] };
        let term = |(j, binomial): (usize, &i64)| {
            let powers = t.pow(j as u32) * (Poly::one() - &t).pow((degree - j) as u32);
            symbol(&format!("{name}{j}")) * powers.scale(&integer(*binomial))
        };
        binomials.iter().enumerate().map(term).sum::<Poly>()
    };
    bernstein("a").resultant(&bernstein("b"), &v).normalized()
}

#[test]
fn oriented_translation_has_a_common_factor_exactly_where_the_hodograph_is_not_primitive() {
    SURFACES.with(|surfaces| {
        for (degree, index) in [(1, 0), (2, 1), (1, 2), (2, 3)] {
            let cases = surfaces[index].1.common_factors.as_slice();
            let [case] = cases else { panic!("one case of {index}: {cases:?}") };
            let locus = case.locus.as_ref().unwrap();
            assert_eq!(locus.alternatives(), [vec![preimage_resultant(degree)]]);
            assert!(case.exact);
            // Both leading coefficients vanish there: the common zero is at infinity.
            assert_eq!(case.except.alternatives().len(), 1);
        }
    });
}

#[test]
fn a_conical_sweep_has_a_common_factor_where_the_scale_shares_a_zero_with_the_speed() {
    let [_, v] = parameters();
    let curve = symbolic_ph(1, &v);
    let (length, arclength) = (curve.length().unwrap(), curve.arclength().unwrap());
    let [c0, c1] = ["c0", "c1"].map(|name| Fraction::from(symbol(name)));
    let scale = &(&c0 * &(&length - &arclength)) + &(&c1 * &arclength);
    let shared = curve.speed().unwrap().numerator().resultant(scale.numerator(), &v);
    SURFACES.with(|surfaces| {
        let conditions = &surfaces[4].1;
        let loci: Vec<String> =
            conditions.common_factors.iter().map(|case| case.locus.as_ref().unwrap().to_string()).collect();
        assert_eq!(loci.len(), 3);
        assert_eq!(loci[0], "c0 == 0 and c1 == 0");
        assert_eq!(loci[1], "a0*b1 - a1*b0 == 0");
        let last = &conditions.common_factors[2].locus.as_ref().unwrap().alternatives()[0][0];
        assert!(last.divides(&shared));
        assert!(conditions.common_factors.iter().all(|case| case.exact));
        assert_eq!(
            conditions.coordinates[3][0].to_string(),
            "c0 == 0 and c1 == 0 or a0 == 0 and a1 == 0 and b0 == 0 and b1 == 0"
        );
    });
}

#[test]
fn the_degrees_of_the_coordinates_of_a_ph_quintic_sweep() {
    SURFACES.with(|surfaces| {
        let conditions = &surfaces[1].1;
        let [w, x, y, z] = &conditions.coordinates;
        assert_eq!(w[1].to_string(), "a0 - 2*a1 + a2 == 0 and b0 - 2*b1 + b2 == 0");
        assert_eq!(
            x[1].to_string(),
            "a0 - 2*a1 + a2 + b0 - 2*b1 + b2 == 0 or a0 - 2*a1 + a2 - b0 + 2*b1 - b2 == 0"
        );
        assert_eq!(y[1].to_string(), "a0 - 2*a1 + a2 == 0 or b0 - 2*b1 + b2 == 0");
        assert_eq!(z[1], w[1]);
        assert_eq!(conditions.patch[1], w[1]);
        let origin = "a0 == 0 and a1 == 0 and a2 == 0 and b0 == 0 and b1 == 0 and b2 == 0";
        assert_eq!(conditions.weight.to_string(), origin);
        assert_eq!(conditions.patch[0].to_string(), origin);
    });
}

#[test]
fn a_surface_without_symbols_has_no_conditions() {
    let [u, v] = parameters().each_ref().map(|parameter| Fraction::from(Poly::variable(parameter)));
    let root = Fraction::from(Poly::sqrt_of(&integer(2)));
    let surface = Vector::new(&u / &(&v + &root), &root * &v, &(&u * &u) * &v);
    assert!(Conditions::of(&Homogeneous::of(&surface, &parameters())).is_empty());
}

#[test]
fn factors_of_the_weight_in_both_parameters() {
    // R = (u, v, (uv + a)/(uv + b)): the factor uv + b divides the numerator of z where a = b, and no other.
    let [u, v] = parameters().each_ref().map(|parameter| Fraction::from(Poly::variable(parameter)));
    let [a, b] = ["a", "b"].map(|name| Fraction::from(symbol(name)));
    let product = &u * &v;
    let surface = Vector::new(u, v, &(&product + &a) / &(&product + &b));
    let conditions = Conditions::of(&Homogeneous::of(&surface, &parameters()));
    let loci = conditions.common_factors.iter().map(|case| case.locus.clone().unwrap());
    let union = loci.fold(Locus::empty(), |union, locus| union.union(&locus));
    assert_eq!(union.to_string(), "a - b == 0");
    assert!(conditions.coordinates[0].iter().all(Locus::is_empty));
}
