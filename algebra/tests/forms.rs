//! Fundamental forms, curvatures and similarity offsets against their definitions.

#[path = "support/config.rs"]
mod config;

use hodograph_algebra::{
    CurvatureZeros, FormError, FormFunction, Fraction, Interval, Poly, QuadraticFraction, SweptSurface,
    Variable, Vector, integer, ratio,
};
use proptest::prelude::*;

fn parameters() -> [Variable; 2] {
    [Variable::new(0, "u"), Variable::new(1, "v")]
}

/// A patch of bidegree (1, 1) over a positive weight, with small coefficients.
fn patches() -> impl Strategy<Value = SweptSurface> {
    prop::collection::vec(-2_i64..3, 16).prop_map(|numbers| {
        let [u, v] = parameters().each_ref().map(Poly::variable);
        let poly = |numbers: &[i64]| {
            let monomials = (0..2).flat_map(|i| (0..2).map(move |j| (i, j)));
            monomials.zip(numbers).map(|((i, j), n)| u.pow(i) * v.pow(j) * Poly::integer(*n)).sum::<Poly>()
        };
        let parts: Vec<Poly> = numbers.chunks(4).map(poly).collect();
        let weight = Poly::integer(1) + parts[3].pow(2);
        let over = |numerator: &Poly| Fraction::new(numerator.clone(), [(weight.clone(), 1)]);
        let position = Vector::new(over(&parts[0]), over(&parts[1]), over(&parts[2]));
        SweptSurface::new(position, parameters(), [Interval::unit(), Interval::unit()])
    })
}

fn named(name: &str) -> FormFunction {
    FormFunction::named(name).unwrap()
}

/// The functions f₀, f₁, f₂ of GE.
fn similarity_functions() -> [FormFunction; 3] {
    let constant = |n: i64| FormFunction::from(Fraction::from(integer(n)));
    let f0 = named("L").plus(&constant(-2).times(&named("M"))).plus(&named("N"));
    let f1 = named("H").times(&named("K").reciprocal().unwrap());
    [f0, f1, named("H").reciprocal().unwrap()]
}

proptest! {
    #![proptest_config(config::config(6))]

    #[test]
    fn forms_are_those_of_their_definitions(surface in patches()) {
        prop_assume!(surface.is_surface());
        let forms = surface.forms().unwrap();
        let [u, v] = parameters();
        let position = surface.position();
        let [along_u, along_v] = [&u, &v].map(|by| position.derivative(by));
        let second = [along_u.derivative(&u), along_u.derivative(&v), along_v.derivative(&v)];
        let cross = along_u.cross(&along_v);
        let determinant = cross.norm2();
        let value = |name| forms.value(&named(name)).unwrap();
        let first = [along_u.norm2(), along_u.dot(&along_v), along_v.norm2()];
        for (name, own) in ["E", "F", "G"].into_iter().zip(&first) {
            prop_assert_eq!(value(name), QuadraticFraction::from(own.clone()));
        }
        // √(EG − F²)
        let root = forms.length().unwrap().scale(forms.normal().factor());
        prop_assert_eq!(root.times(&root).unwrap(), QuadraticFraction::from(determinant.clone()));
        let triple = second.map(|second| cross.dot(&second));
        for (name, own) in ["L", "M", "N"].into_iter().zip(&triple) {
            let value = value(name);
            prop_assert!(value.is_valid());
            prop_assert_eq!(value.times(&root).unwrap(), QuadraticFraction::from(own.clone()));
        }
        let [e, f, g] = &first;
        let [l, m, n] = &triple;
        let gaussian = &(&(l * n) - &(m * m)) / &determinant.pow(2);
        prop_assert_eq!(value("K"), QuadraticFraction::from(gaussian.clone()));
        let mean = &(&(e * n) + &(g * l)) - &(f * m).scale(&integer(2));
        let twice = mean.scale(&ratio(1, 2));
        let cubed = root.times(&root).unwrap().times(&root).unwrap();
        prop_assert_eq!(value("H").times(&cubed).unwrap(), QuadraticFraction::from(twice.clone()));
        let everywhere = |zeros| matches!(zeros, CurvatureZeros::Everywhere);
        prop_assert_eq!(everywhere(forms.gaussian_zeros()), gaussian.is_zero());
        prop_assert_eq!(everywhere(forms.mean_zeros()), twice.is_zero());

        // f·n₁ = g/(EG − F²)·(R_u × R_v), where f = g/√(EG − F²).
        let parts = [
            Some(&(l - &m.scale(&integer(2))) + n),
            (!gaussian.is_zero()).then(|| &twice / &(&gaussian * &determinant)),
            (!twice.is_zero()).then(|| &determinant.pow(2) / &twice),
        ];
        for (function, part) in similarity_functions().iter().zip(parts) {
            let offset = surface.similarity_offset(function, &ratio(3, 5).into());
            match part {
                None => {
                    let vanishes = matches!(offset, Err(FormError::Vanishes { .. }));
                    prop_assert!(vanishes);
                }
                Some(part) => {
                    let step = cross.scale(&(&part / &determinant)).scale_by(&ratio(3, 5));
                    let offset = offset.unwrap();
                    prop_assert_eq!(offset.position(), &(position + &step));
                }
            }
        }
        // A formula of both parities, and one with a denominator of both.
        let mixed = named("L").plus(&named("E"));
        let parts = value("L").plus(&value("E")).unwrap();
        prop_assert_eq!(forms.value(&mixed).unwrap(), parts.clone());
        if !parts.is_zero() {
            let inverse = forms.value(&mixed.reciprocal().unwrap()).unwrap();
            prop_assert_eq!(inverse.times(&parts).unwrap(), QuadraticFraction::from(Fraction::one()));
        }
        prop_assert_eq!(surface.similarity_offset(&mixed, &Fraction::one()).unwrap_err(), FormError::Mixed);
    }
}

#[test]
fn weights_are_those_of_similarities() {
    let weights = similarity_functions().map(|function| function.weight());
    assert_eq!(weights, [Some(1); 3]);
    let e_over_l = named("E").times(&named("L").reciprocal().unwrap());
    assert_eq!(e_over_l.weight(), Some(1));
    // A common factor without weight is none of the formula.
    let sum = named("E").plus(&named("L"));
    assert_eq!(sum.weight(), None);
    assert_eq!(sum.times(&named("M")).times(&sum.reciprocal().unwrap()).weight(), Some(1));
    assert_eq!(named("K").pow(2).weight(), Some(-4));
}

#[test]
fn planes_have_no_curvatures_to_divide_by() {
    let [u, v] = parameters().each_ref().map(|parameter| Fraction::from(Poly::variable(parameter)));
    let plane = Vector::new(u.clone(), v.clone(), &u + &v.pow(2));
    let flat = Vector::new(u.clone(), v.clone(), &u + &v);
    let surface = |position| SweptSurface::new(position, parameters(), [Interval::unit(), Interval::unit()]);
    let [f0, f1, f2] = similarity_functions();
    let error = surface(plane).similarity_offset(&f1, &Fraction::one()).unwrap_err();
    assert!(error.to_string().contains("developable"), "{error}");
    let flat = surface(flat);
    let error = flat.similarity_offset(&f2, &Fraction::one()).unwrap_err();
    assert!(error.to_string().contains("minimal"), "{error}");
    assert_eq!(flat.similarity_offset(&f0, &Fraction::one()).unwrap().position(), flat.position());
}
