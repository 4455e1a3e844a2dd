//! Spatial PH curves and their frames, against the definitions.

use hodograph_algebra::{
    AdaptedFrame, CanalError, Complex, Curve, CurveError, Fraction, Interval, KnownProperties, Poly,
    Quaternion, SpatialHermite, SpatialHermiteError, SpatialPreimage, Variable, Vector, integer,
};
use proptest::prelude::*;

#[path = "support/config.rs"]
mod config;

fn v() -> Variable {
    Variable::new(1, "v")
}

fn number(n: i64) -> Fraction {
    integer(n).into()
}

fn quaternion([w, x, y, z]: [i64; 4]) -> Quaternion {
    let [w, x, y, z] = [w, x, y, z].map(number);
    Quaternion::new(w, x, y, z)
}

fn curve_of(preimage: &SpatialPreimage) -> Curve {
    let parts = preimage.curve(&v(), &Vector::zero());
    let known = KnownProperties {
        speed: Some(parts.speed),
        quaternion: Some(parts.quaternion),
        rotation: parts.rotation,
        ..KnownProperties::default()
    };
    Curve::new(&v(), parts.position, Some(Interval::unit()), known, Default::default())
}

fn curve(coefficients: &[[i64; 4]]) -> Curve {
    curve_of(&SpatialPreimage::new(coefficients.iter().copied().map(quaternion).collect()).unwrap())
}

/// The same curve, of which nothing is known but its position.
fn anonymous(curve: &Curve) -> Curve {
    let known = KnownProperties::default();
    Curve::new(&v(), curve.position().clone(), curve.domain().cloned(), known, Default::default())
}

/// That a frame is orthonormal, right-handed, adapted to the curve, and turns as it says.
fn check(curve: &Curve, frame: &AdaptedFrame) {
    let AdaptedFrame { tangent, f, g, spin, .. } = frame;
    assert_eq!(*tangent, curve.tangent().unwrap());
    assert_eq!([f.norm2(), g.norm2()], [Fraction::one(), Fraction::one()]);
    assert!(f.dot(tangent).is_zero());
    assert_eq!(tangent.cross(f), *g);
    assert_eq!(f.derivative(&v()).dot(g), *spin);
}

fn small() -> impl Strategy<Value = [i64; 4]> {
    [-3..4_i64, -3..4_i64, -3..4_i64, -3..4_i64]
}

fn vector() -> impl Strategy<Value = Vector> {
    [-3..4_i64, -3..4_i64, -3..4_i64].prop_map(|part| {
        let [x, y, z] = part.map(number);
        Vector::new(x, y, z)
    })
}

proptest! {
    #![proptest_config(config::config(24))]

    #[test]
    fn hodographs_are_pythagorean(coefficients in prop::collection::vec(small(), 1..5)) {
        prop_assume!(coefficients.iter().any(|c| *c != [0; 4]));
        let curve = curve(&coefficients);
        let frame = curve.euler_rodrigues_frame().unwrap();
        check(&curve, &frame);
        prop_assert_eq!(curve.position().derivative(&v()), curve.hodograph().clone());
        prop_assert_eq!(curve.speed().unwrap().pow(2), curve.hodograph().norm2());
        // The speed as a square root, and the frame without the preimage, are those of the same curve.
        let anonymous = anonymous(&curve);
        prop_assert_eq!(anonymous.speed().unwrap(), curve.speed().unwrap());
        check(&anonymous, &anonymous.euler_rodrigues_frame().unwrap());
    }

    #[test]
    fn constrained_quintics_have_rational_frames(a0 in small(), a1 in small(), c in -3..4_i64) {
        prop_assume!(a0 != [0; 4]);
        let preimage = SpatialPreimage::constrained_quintic(&quaternion(a0), &quaternion(a1), &number(c)).unwrap();
        prop_assert!(preimage.quintic_constraint().unwrap().is_zero());
        let curve = curve_of(&preimage);
        let frame = curve.rotation_minimizing_frame().unwrap();
        check(&curve, &frame);
        prop_assert!(frame.spin.is_zero());
        // It begins as the Euler-Rodrigues frame.
        let start = [(v(), Fraction::zero())].into();
        let at_start = |vector: &Vector| vector.map(|part| part.lowest_terms().substitute(&start).unwrap());
        prop_assert_eq!(at_start(&frame.f), at_start(&curve.euler_rodrigues_frame().unwrap().f));
        // Nothing depends on how the curve was made.
        let anonymous = anonymous(&curve);
        let other = anonymous.rotation_minimizing_frame().unwrap();
        check(&anonymous, &other);
        let angle = [frame.f.dot(&other.f), frame.f.dot(&other.g)];
        prop_assert!(angle.iter().all(|part| part.lowest_terms().to_number().is_some()));
    }

    #[test]
    fn quintics_between_derivatives(start in vector(), end in vector(), mirrored in any::<bool>()) {
        prop_assume!(!start.is_zero() && !end.is_zero());
        let data = SpatialHermite::new(&start, &end).unwrap();
        let preimage = data.preimage(None, mirrored).unwrap();
        prop_assert!(preimage.quintic_constraint().unwrap().is_zero());
        let parts = preimage.curve(&v(), &Vector::zero());
        for (value, derivative) in [(0, &start), (1, &end)] {
            let at = [(v(), number(value))].into();
            prop_assert_eq!(&parts.hodograph.map(|part| part.substitute(&at).unwrap()), derivative);
        }
        // Three square roots at most, and that of the real factor of the preimage.
        prop_assert!(parts.quaternion.components().iter().all(|part| part.numerator().ring().field().degree() <= 16));
        let frame = curve_of(&preimage).rotation_minimizing_frame().unwrap();
        prop_assert!(frame.spin.is_zero());
    }

    #[test]
    fn every_constrained_quintic_is_one_between_its_derivatives(a0 in small(), a1 in small(), c in -3..4_i64) {
        let [a0, a1] = [a0, a1].map(quaternion);
        prop_assume!(!a0.is_zero());
        let given = SpatialPreimage::constrained_quintic(&a0, &a1, &number(c)).unwrap();
        let hodograph = given.curve(&v(), &Vector::zero()).hodograph;
        let [start, end] =
            [0, 1].map(|value| hodograph.map(|part| part.substitute(&[(v(), number(value))].into()).unwrap()));
        prop_assume!(!start.cross(&end).is_zero());
        let relative = (&a0.conj() * &a1).scale(&a0.norm2().reciprocal(&[]).unwrap());
        let [re, im] = [0, 1].map(|index: usize| relative.components()[index].to_number().unwrap());
        let data = SpatialHermite::new(&start, &end).unwrap();
        let found = data.preimage(Some(&Complex::new(re, im)), c < 0).unwrap();
        prop_assert_eq!(found.curve(&v(), &Vector::zero()).hodograph, hodograph);
    }
}

#[test]
fn middle_coefficients_have_bounds() {
    let data = |end: [i64; 3]| {
        let [x, y, z] = end.map(number);
        SpatialHermite::new(&Vector::unit(0), &Vector::new(x, y, z)).unwrap()
    };
    let one = Complex::from(Poly::one());
    assert_eq!(
        data([0, 1, 0]).preimage(Some(&one), false).unwrap_err().to_string(),
        "no such quintic has this middle coefficient: |middle|^2 lies between 0.146447 and 0.853553"
    );
    assert!(data([-2, 0, 0]).preimage(Some(&one), false).unwrap_err().to_string().contains("opposite"));
    assert!(data([0, 1, 0]).preimage(Some(&Complex::zero()), false).is_err());
    assert_eq!(
        SpatialHermite::new(&Vector::unit(0), &Vector::zero()).unwrap_err(),
        SpatialHermiteError::Zero { end: true }
    );
}

/// With symbols for everything: the frame of every constrained quintic is found, and checked.
#[test]
fn symbolic_quintics_have_rational_frames() {
    let symbol = |name: &str| Fraction::from(Poly::variable(&Variable::new(Variable::SYMBOL, name)));
    let [a0, a1] = ["0", "1"].map(|index| {
        let [w, x, y, z] = ["a", "b", "c", "d"].map(|letter| symbol(&format!("{letter}{index}")));
        Quaternion::new(w, x, y, z)
    });
    let preimage = SpatialPreimage::constrained_quintic(&a0, &a1, &symbol("e")).unwrap();
    let frame = curve_of(&preimage).rotation_minimizing_frame().unwrap();
    assert!(frame.spin.is_zero());
    let rotation = frame.rotation.unwrap();
    let speed = curve_of(&preimage).speed().unwrap();
    assert!(Fraction::from(rotation.norm2()) == &a0.norm2() * &speed);
}

/// A rotation that is stated but wrong counts for nothing.
#[test]
fn known_rotations_are_checked() {
    let preimage = SpatialPreimage::constrained_quintic(
        &quaternion([2, 0, 0, 0]),
        &quaternion([1, 2, 1, 0]),
        &number(2),
    );
    let preimage = preimage.unwrap();
    let parts = preimage.curve(&v(), &Vector::zero());
    let with = |rotation: Complex| {
        let known = KnownProperties {
            quaternion: Some(parts.quaternion.clone()),
            rotation: Some(rotation),
            ..KnownProperties::default()
        };
        let curve =
            Curve::new(&v(), parts.position.clone(), Some(Interval::unit()), known, Default::default());
        curve.rotation_minimizing_frame().unwrap().rotation
    };
    let wrong = Complex::new(Poly::variable(&v()), Poly::one());
    assert_eq!(with(wrong), with(parts.rotation.clone().unwrap()));
    assert_eq!(with(Complex::zero()), with(parts.rotation.clone().unwrap()));
    let general = SpatialPreimage::new(vec![
        quaternion([1, 0, 0, 0]),
        quaternion([1, 1, 0, 2]),
        quaternion([0, 1, 2, -1]),
    ]);
    assert_eq!(general.unwrap().quintic_rotation(&v()), None);
}

#[test]
fn most_quintics_have_none() {
    let general = curve(&[[1, 0, 0, 0], [1, 1, 0, 2], [0, 1, 2, -1]]);
    let Err(CurveError::NoRationalFrame { error, .. }) = general.rotation_minimizing_frame() else {
        panic!()
    };
    assert!(error.to_string().starts_with("at the zeros of"), "{error}");
    assert!(anonymous(&general).rotation_minimizing_frame().is_err());
    let symbolic = SpatialPreimage::symbolic(5, "").unwrap();
    let error = curve_of(&symbolic).rotation_minimizing_frame().unwrap_err();
    assert!(error.to_string().contains("and so for general values"), "{error}");
}

#[test]
fn cubics_have_one_only_in_planes() {
    for [a, b, c, d] in [[1, 1, 0, 0], [2, 0, 1, 0], [0, 0, 1, 1], [1, 2, 3, 1], [2, 1, 0, -1]] {
        let cubic = curve(&[[1, 0, 0, 0], [a, b, c, d]]);
        let planar = cubic.torsion().map_or(true, |torsion| torsion.is_zero());
        assert_eq!(cubic.rotation_minimizing_frame().is_ok(), planar, "{a} {b} {c} {d}");
    }
}

/// `A = v² − 2 + v i − 3v j + k`, with a primitive hodograph that lies in no plane and a rational frame, does not satisfy
/// the quintic constraint.
#[test]
fn quintics_of_a_second_kind() {
    let coefficients = [[-2, 0, 0, 1], [-2, 0, 0, 1], [-1, 1, -3, 1]].map(quaternion);
    let half = Quaternion::new(
        number(-2),
        number(1).scale(&hodograph_algebra::ratio(1, 2)),
        Fraction::zero(),
        number(1),
    );
    let j = Quaternion::from(Vector::unit(1)).scale_by(&hodograph_algebra::ratio(-3, 2));
    let [first, _, last] = coefficients;
    let preimage = SpatialPreimage::new(vec![first, &half + &j, last]).unwrap();
    assert_eq!(preimage.polynomial(&v()).to_string(), "(v^2 - 2, v, -3*v, 1)");
    assert_eq!(preimage.quintic_constraint().unwrap().to_string(), "(0, 5, 0)");
    let curve = curve_of(&preimage);
    let frame = curve.rotation_minimizing_frame().unwrap();
    check(&curve, &frame);
    assert!(frame.spin.is_zero());
    assert_eq!(frame.rotation.unwrap().to_string(), "1 + I*(v)");
    let hodograph = curve.hodograph().components().each_ref().map(|part| part.to_poly().unwrap());
    assert!(Poly::coprime(&hodograph));
    assert!(!curve.torsion().unwrap().is_zero());
}

/// Complex factors on the right of a preimage change its hodograph by a real factor, and its frames not at all.
#[test]
fn hodographs_with_factors() {
    let t = Fraction::from(Poly::variable(&v()));
    let one = Fraction::one();
    let base = SpatialPreimage::constrained_quintic(
        &quaternion([1, 0, 2, 0]),
        &quaternion([1, 1, 0, 2]),
        &number(1),
    );
    let base = base.unwrap().polynomial(&v());
    let factor = Quaternion::new(t.clone(), one, Fraction::zero(), Fraction::zero());
    let product = &base * &factor;
    let hodograph = product.sandwich(&Vector::unit(0));
    let position = hodograph.map(|part| part.to_poly().unwrap().integral(&v()).into());
    for known in [Some(product), None] {
        let known = KnownProperties { quaternion: known, ..KnownProperties::default() };
        let curve = Curve::new(&v(), position.clone(), None, known, Default::default());
        let frame = curve.rotation_minimizing_frame().unwrap();
        check(&curve, &frame);
        assert!(frame.spin.is_zero());
    }
}

#[test]
fn frenet_frames() {
    // A PH cubic is a helix: its Frenet frame is rational.
    let cubic = curve(&[[1, 0, 0, 0], [1, 2, 3, 1]]);
    let frame = cubic.frenet_frame().unwrap();
    check(&cubic, &frame);
    assert!(!frame.spin.is_zero());
    let quintic = curve(&[[1, 0, 0, 0], [1, 1, 0, 2], [0, 1, 2, -1]]);
    let error = quintic.frenet_frame().unwrap_err();
    assert!(matches!(error, CurveError::IrrationalFrenet { .. }), "{error}");
    // At a point it is made of square roots.
    let at = quintic.frenet_frame_at(&Poly::integer(1)).unwrap();
    assert_eq!(at.f.norm2(), Fraction::one());
    assert!(at.f.dot(&at.tangent).is_zero());
    let values = [(v(), number(1))].into();
    assert_eq!(at.spin, quintic.frenet_spin().unwrap().substitute(&values).unwrap());
    assert_eq!(curve(&[[1, 0, 0, 0]]).frenet_frame(), Err(CurveError::Straight));
    assert_eq!(curve(&[[1, 0, 0, 0]]).rotation_minimizing_frame().unwrap().f, Vector::unit(1));
}

/// Each point is at the distance r from the spine and the envelope condition `(R − s)·s' = −r r'` holds.
#[test]
fn canal_surfaces() {
    let u = Variable::new(0, "u");
    let spine = curve(&[[1, 0, 0, 0], [1, 2, 1, 1]]);
    let frame = spine.euler_rodrigues_frame().unwrap();
    let t = Fraction::from(Poly::variable(&v()));
    for radius in [number(3), &t.scale(&hodograph_algebra::ratio(1, 4)) + &number(2)] {
        let surface = spine.canal(&frame, &radius, &u).unwrap();
        let distance = &surface - spine.position();
        assert_eq!(distance.norm2(), radius.pow(2));
        let growth = (&radius * &radius.derivative(&v())).scale(&integer(-1));
        assert_eq!(distance.dot(spine.hodograph()), growth);
        assert!(!surface.derivative(&u).is_zero());
    }
    let fast = spine.canal(&frame, &t.scale(&integer(100)), &u).unwrap_err();
    assert!(matches!(fast, CanalError::Imaginary { .. }), "{fast}");
    let line = Vector::new(Fraction::zero(), Fraction::zero(), Poly::variable(&v()).into());
    let line = Curve::new(&v(), line, None, KnownProperties::default(), Default::default());
    let frame_of_line = line.euler_rodrigues_frame().unwrap();
    let refused = |radius: Poly| line.canal(&frame_of_line, &radius.into(), &u).unwrap_err().to_string();
    let changing = refused(Poly::variable(&v()).pow(2));
    assert!(changing.contains("it changes its sign with its factor 2*v - 1;"), "{changing}");
    let nowhere = refused(Poly::variable(&v()).scale(&integer(2)));
    assert!(nowhere.contains("it is -3, which is nowhere positive"), "{nowhere}");
    let high = spine.canal(&frame, &t.pow(4), &u).unwrap_err();
    assert!(matches!(high, CanalError::Unsplit { .. } | CanalError::Imaginary { .. }), "{high}");
}
