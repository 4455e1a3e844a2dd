//! The sweeps of a circular arc along a PH quintic.

use std::rc::Rc;

use hodograph_algebra::{
    Complex, Curve, Fraction, Interval, KnownProperties, PhCurve, Poly, Preimage, SweptSurface, Variable,
    Vector, integer,
};

/// The variables of the sweeps with symbols for the preimage.
pub(crate) const VARIABLES: &[&str] = &["u", "v", "a0", "b0", "a1", "b1", "a2", "b2", "c0", "c1"];
/// The variables where only the scale has symbols.
pub(crate) const PARAMETERS_AND_SCALE: &[&str] = &["u", "v", "c0", "c1"];

fn u() -> Variable {
    Variable::new(0, "u")
}

fn v() -> Variable {
    Variable::new(1, "v")
}

/// The PH quintic with symbols for the coefficients of its preimage.
pub(crate) fn symbolic_path() -> Curve {
    path(&Preimage::symbolic(5, "").expect("5 is odd"))
}

/// The PH quintic with `w₀, w₁, w₂ = 1 + 2i, 3 + i, 2 − i`.
pub(crate) fn numeric_path() -> Curve {
    let coefficients =
        [(1, 2), (3, 1), (2, -1)].map(|(a, b)| Complex::new(Poly::integer(a), Poly::integer(b)));
    path(&Preimage::new(coefficients.to_vec()).expect("it is not zero"))
}

/// The PH curve from the origin with the given preimage.
pub(crate) fn path(preimage: &Preimage) -> Curve {
    let w = preimage.polynomial(&v());
    let PhCurve { position, speed, .. } = preimage.curve(&v(), &Complex::zero());
    let known = KnownProperties {
        speed: Some(speed.into()),
        preimage: Some([w.re, w.im]),
        ..KnownProperties::default()
    };
    let position = Vector::new(position.re.into(), position.im.into(), Fraction::zero());
    Curve::new(&v(), position, Some(Interval::unit()), known, Rc::default())
}

/// The profile FN (16): `x = (1 − u²)/(1 + u²)`, `z = 2u/(1 + u²)`.
fn profile() -> [Fraction; 2] {
    let square = Poly::variable(&u()).pow(2);
    let over_weight = |numerator: Poly| Fraction::new(numerator, [(&square + Poly::one(), 1)]);
    [over_weight(Poly::one() - &square), over_weight(Poly::variable(&u()).scale(&integer(2)))]
}

fn surface(position: Vector) -> SweptSurface {
    SweptSurface::new(position, [u(), v()], [Interval::unit(), Interval::unit()])
}

/// The oriented translation FN (17): `R = s + x n + z k`.
pub(crate) fn translation() -> SweptSurface {
    oriented_translation(&symbolic_path())
}

/// The oriented translation along a curve.
pub(crate) fn oriented_translation(path: &Curve) -> SweptSurface {
    let [x, z] = profile();
    let (normal, tangent) = (path.normal().expect("a PH curve has a rational normal"), path.tangent());
    let across = &normal.scale(&x) + &Vector::unit(2).scale(&z);
    surface(path.position() + &across)
        .with_directions(&[normal, tangent.expect("a PH curve has a rational tangent")])
}

/// The oriented involute sweep FN (25): `R = c − x t + z k` with the involute `c = s − s(v) t`.
pub(crate) fn involute() -> SweptSurface {
    let path = symbolic_path();
    let [x, z] = profile();
    let tangent = path.tangent().expect("a PH curve has a rational tangent");
    let involute = path.involute().expect("a PH curve has a polynomial arc length");
    surface(&(&involute - &tangent.scale(&x)) + &Vector::unit(2).scale(&z))
}

/// The generalized conical sweep FN (30): `R = s + c(v) (x n + z k)` with `c(v) = (c₀ (S − s(v)) + c₁ s(v))/S`.
pub(crate) fn conical(path: Curve) -> SweptSurface {
    let [x, z] = profile();
    let [c0, c1] =
        ["c0", "c1"].map(|name| Fraction::from(Poly::variable(&Variable::new(Variable::SYMBOL, name))));
    let expected = "a PH curve has a polynomial arc length";
    let (arclength, length) = (path.arclength().expect(expected), path.length().expect(expected));
    let scale = &(&(&c0 * &(&length - &arclength)) + &(&c1 * &arclength)) / &length;
    let normal = path.normal().expect("a PH curve has a rational normal");
    let across = &normal.scale(&x) + &Vector::unit(2).scale(&z);
    surface(path.position() + &across.scale(&scale))
}

/// W, X, Y, Z of a surface.
pub(crate) fn coordinates(surface: &SweptSurface) -> Vec<Poly> {
    surface.homogeneous().coordinates().to_vec()
}

/// The components of the numerator of the normal of a surface, whose coprimality is certified on the way.
pub(crate) fn normal(surface: &SweptSurface) -> Vec<Poly> {
    surface.normal().expect("the sweep is a surface").numerator().to_vec()
}
