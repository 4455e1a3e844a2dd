//! Derivations of surfaces whose coordinates, degrees, normals and offsets are known by hand.

use std::rc::Rc;

use hodograph_algebra::{
    Bidegree, Calculus, Complex, ControlNet, Curve, CurveError, Derivation, DifferentialGeometry, Fraction,
    Hermite, Interval, KnownProperties, Offset, OffsetError, Poly, Preimage, SweptSurface, Variable, Vector,
    integer, moving_frame_curve, ratio,
};

fn u() -> Variable {
    Variable::new(0, "u")
}

fn v() -> Variable {
    Variable::new(1, "v")
}

fn poly(variable: &Variable) -> Poly {
    Poly::variable(variable)
}

/// The quarter of the unit circle, as FN (16) has it: (1 − t²)/(1 + t²) and 2t/(1 + t²).
fn circle(t: &Variable) -> [Fraction; 2] {
    let weight = poly(t).pow(2) + Poly::one();
    let over = |numerator: Poly| Fraction::new(numerator, [(weight.clone(), 1)]);
    [over(Poly::one() - poly(t).pow(2)), over(poly(t).scale(&integer(2)))]
}

fn surface(position: Vector) -> SweptSurface {
    SweptSurface::new(position, [u(), v()], [Interval::unit(), Interval::unit()])
}

fn derive(position: Vector) -> Derivation {
    surface(position).derive().expect("a surface")
}

fn geometry(derivation: &Derivation) -> &DifferentialGeometry {
    derivation.geometry.as_ref().expect("there is no limit")
}

fn net(derivation: &Derivation) -> &ControlNet {
    derivation.control_net.as_ref().expect("there is no limit")
}

fn degrees(derivation: &Derivation) -> [(i64, i64); 4] {
    derivation.homogeneous.degrees().map(|degree| (degree.u, degree.v))
}

fn ph_curve(preimage: &Preimage, start: &Complex) -> Curve {
    let parts = preimage.curve(&v(), start);
    let position = Vector::new(parts.position.re.into(), parts.position.im.into(), Fraction::zero());
    let known = KnownProperties { speed: Some(parts.speed.into()), ..KnownProperties::default() };
    Curve::new(&v(), position, Some(Interval::unit()), known, Rc::default())
}

fn translation(path: &Curve, x: &Fraction, z: &Fraction) -> Vector {
    let across = path.normal().expect("a normal").scale(x);
    &(path.position() + &across) + &Vector::unit(2).scale(z)
}

fn point(x: i64, y: i64) -> Complex {
    Complex::new(Poly::integer(x), Poly::integer(y))
}

fn example_2() -> Curve {
    let data = Hermite::new(&point(0, 0), &point(0, 4), &point(2, 2), &point(4, 0)).expect("Hermite data");
    ph_curve(&data.least_rotation().expect("one best solution"), &Complex::zero())
}

#[test]
fn the_sphere() {
    let ([x, z], [cosine, sine]) = (circle(&u()), circle(&v()));
    let derivation = derive(Vector::new(&x * &cosine, &x * &sine, z));
    assert_eq!(degrees(&derivation), [(2, 2), (2, 2), (2, 1), (1, 2)]);
    // The unit normal of the unit sphere is, up to its sign, its position.
    assert!(geometry(&derivation).normal.is_rational());
    let unit = geometry(&derivation)
        .normal
        .unit(&derivation.parameters, &derivation.domain)
        .expect("a rational normal");
    let position = derivation.homogeneous.cartesian();
    assert_eq!(unit, -&position);
    assert_eq!(geometry(&derivation).singular_zeros, ["u = 1"]);
    // So the offset at the distance r is the sphere scaled by 1 − r.
    let Offset::Rational(offset) = &geometry(&derivation).offset else {
        panic!("a sphere's offset is rational")
    };
    let shrunk = Fraction::from(Poly::one() - Poly::variable(&derivation.distance));
    assert_eq!(offset.cartesian(), position.scale(&shrunk));
    assert!(geometry(&derivation).normal.is_valid());
}

#[test]
fn example_2_lives_in_degree_4_and_is_regular() {
    let [x, z] = circle(&u());
    let derivation = derive(translation(&example_2(), &x, &z));
    assert_eq!(degrees(&derivation), [(2, 4), (2, 9), (2, 9), (1, 4)]);
    assert_eq!(derivation.homogeneous.degree(), Bidegree { u: 2, v: 9 });
    let relations = (0..2).map(|i| derivation.field.relation(i).to_string()).collect::<Vec<_>>();
    assert_eq!((derivation.field.degree(), relations[0].as_str()), (4, "sqrt2^2 - 2"));
    assert_eq!(relations[1], "theta^2 - 100*sqrt2 - 110");
    assert!(geometry(&derivation).singular.is_regular());
    assert!(geometry(&derivation).speeds.iter().all(|speed| speed.certified));
    // The control net begins at R(0, 0) = p(0) = (1, 0, 0).
    let [w, x, y, z] = &net(&derivation).points[0][0];
    assert!(w == x && y.is_zero() && z.is_zero() && !w.is_zero());
}

#[test]
fn the_control_net_interpolates_the_corners() {
    let [x, z] = circle(&u());
    let derivation = derive(translation(&example_2(), &x, &z));
    let [m, n] = net(&derivation).degree.map(|degree| degree as usize);
    for (i, j) in [(0, 0), (0, n), (m, 0), (m, n)] {
        let at = |corner: bool| Poly::integer(corner.into());
        for (coordinate, corner) in
            derivation.homogeneous.coordinates().iter().zip(&net(&derivation).points[i][j])
        {
            assert_eq!(coordinate.substitute(&u(), &at(i > 0)).substitute(&v(), &at(j > 0)), *corner);
        }
    }
}

#[test]
fn a_factor_of_the_hodograph_is_common_to_the_coordinates() {
    // s' = h·w² with h = v² + 1: formula (18) has the common factor h.
    let coefficients = vec![Complex::one(), Complex::one() + Complex::i(), Complex::one() + Complex::one()];
    let factor = poly(&v()).pow(2) + Poly::one();
    let preimage = Preimage::new(coefficients).expect("a preimage").with_factor(factor.clone());
    let path = ph_curve(&preimage, &Complex::zero());
    let derivation = derive(translation(&path, &poly(&u()).into(), &poly(&u()).pow(2).into()));
    assert_eq!(*derivation.homogeneous.common_factor(), factor);
    assert_eq!(derivation.homogeneous.raw_degree(), Bidegree { u: 2, v: 13 });
    assert_eq!(derivation.homogeneous.degree(), Bidegree { u: 2, v: 11 });
    assert_eq!(derivation.homogeneous.raw_degrees()[0], Bidegree { u: 0, v: 6 });
    assert!(Poly::coprime(derivation.homogeneous.coordinates()));
    // The profile (u, u²) has the irrational speed √(1 + 4u²).
    let Offset::Irrational { odd } = &geometry(&derivation).offset else {
        panic!("the offset is not rational")
    };
    assert_eq!(odd.to_string(), "4*u^2 + 1");
}

#[test]
fn symbolic_quintics_have_the_generic_degrees() {
    let [x, z] = circle(&u());
    let path = ph_curve(&Preimage::symbolic(5, "").expect("an odd degree"), &Complex::zero());
    let derivation = derive(translation(&path, &x, &z));
    assert_eq!(degrees(&derivation), [(2, 4), (2, 9), (2, 9), (1, 4)]);
    assert_eq!(derivation.symbols.len(), 6);
    assert_eq!(
        derivation.homogeneous.coordinates().each_ref().map(|poly| poly.terms().len()),
        [72, 578, 672, 36]
    );
    // The published term counts of the normal's numerators.
    let mut terms = geometry(&derivation).normal.numerator().each_ref().map(|poly| poly.terms().len());
    terms.sort_unstable();
    assert_eq!(terms, [36, 54, 72]);
    assert!(geometry(&derivation).offset.is_rational());
}

#[test]
fn curves_and_points_are_no_surfaces() {
    let sum = Fraction::from(poly(&u()) + poly(&v()));
    let curve = surface(Vector::new(sum.clone(), &sum * &sum, Fraction::one()));
    assert!(matches!(curve.derive(), Err(OffsetError::NoSurface)));
    let point = surface(Vector::new(Fraction::one(), Fraction::zero(), Fraction::zero()));
    assert!(matches!(point.derive(), Err(OffsetError::NoSurface)));
}

#[test]
fn speed_decides_what_a_curve_offers() {
    let curve = |x: Poly, y: Poly| {
        let position = Vector::new(x.into(), y.into(), Fraction::zero());
        Curve::new(&v(), position, Some(Interval::unit()), KnownProperties::default(), Rc::default())
    };
    let t = poly(&v());
    // A parabola: |s'|² = 1 + 4t².
    let parabola = curve(t.clone(), t.pow(2));
    let error = parabola.normal().unwrap_err();
    assert!(error.to_string().contains("4*v^2 + 1 is not a square"), "{error}");
    // A PH cubic, recognized by its speed 1 + t² alone.
    let cubic = curve(&t - t.pow(3).scale(&ratio(1, 3)), t.pow(2));
    assert_eq!(cubic.speed().unwrap().to_string(), "v^2 + 1");
    assert_eq!(cubic.arclength().unwrap().to_string(), "1/3*v^3 + v");
    assert_eq!(cubic.length().unwrap().to_rational(), Some(ratio(4, 3)));
    // The speed √2 needs a radical; the straight line has no evolute.
    let line = curve(t.clone(), t.clone());
    assert_eq!(line.speed().unwrap().to_string(), "sqrt2");
    assert_eq!(line.evolute(), Err(CurveError::Straight));
    assert_eq!(curve(Poly::one(), Poly::one()).tangent(), Err(CurveError::Point));
    // The circle has the curvature 1, and its center as evolute.
    let [x, y] = circle(&v());
    let circle = Curve::new(
        &v(),
        Vector::new(x, y, Fraction::zero()),
        None,
        KnownProperties::default(),
        Rc::default(),
    );
    assert_eq!(circle.curvature().unwrap(), Fraction::one());
    assert!(circle.evolute().unwrap().is_zero());
    assert!(matches!(circle.arclength(), Err(CurveError::ArcLength { .. })));
    assert_eq!(circle.length(), Err(CurveError::NoDomain));
}

#[test]
fn frames_turn_with_the_curvature_of_every_curve() {
    // FN (3), (4), (5) and (24), (28) for unknown speed and curvature.
    let mut calculus = Calculus::new();
    let sigma = Fraction::from(calculus.function("sigma", &v()));
    let kappa = Fraction::from(calculus.function("kappa", &v()));
    let (position, known) = moving_frame_curve("s", &v(), &sigma, &kappa, &mut calculus);
    let calculus = Rc::new(calculus);
    let curve = Curve::new(&v(), position, None, known, calculus.clone());
    let (tangent, normal) = (curve.tangent().unwrap(), curve.normal().unwrap());
    let derivative = |vector: &Vector| calculus.vector_derivative(vector, &v());
    let turning = &sigma * &kappa;
    assert_eq!(normal.cross(&tangent), Vector::unit(2));
    assert_eq!(derivative(&tangent), -&normal.scale(&turning));
    assert_eq!(derivative(&normal), tangent.scale(&turning));
    assert_eq!(curve.curvature().unwrap(), kappa);
    let arclength = curve.arclength().unwrap();
    assert_eq!(derivative(&curve.involute().unwrap()), normal.scale(&(&arclength * &turning)));
    let radius = kappa.reciprocal(&[]).unwrap();
    let falling = -&calculus.derivative(&radius, &v());
    assert_eq!(derivative(&curve.evolute().unwrap()), normal.scale(&falling));
}
