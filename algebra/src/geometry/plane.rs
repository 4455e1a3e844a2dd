//! The plane that a curve lies in.

use std::collections::BTreeMap;

use super::curve::rational_root;
use super::curve_error::CurveError;
use super::sample::sample_sign;
use super::vector::Vector;
use crate::{Fraction, Interval, Poly, Variable};

/// The unit vector orthogonal to the plane of a curve with this hodograph, which is not zero: its last component other
/// than zero is positive, as those of **k** for the xy-plane, **j** for the xz-plane and **i** for the yz-plane are.
///
/// `moving` are the parameter and the functions of it; all else is constant. The coefficients of the hodograph span the
/// plane's directions: the vector product of two of them that are independent is orthogonal to the plane if it is to all.
/// A straight line lies in many planes: the coordinate plane in which `position` lies is taken, else the one that it is
/// parallel to, xy before xz before yz.
///
/// # Errors
/// [`CurveError::NotPlanar`], [`CurveError::Line`], [`CurveError::IrrationalPlane`].
pub(crate) fn axis(position: &Vector, hodograph: &Vector, moving: &[Variable]) -> Result<Vector, CurveError> {
    for vector in [position, hodograph] {
        if let Some(axis) = (0..3).rev().find(|&axis| vector.components()[axis].is_zero()) {
            return Ok(Vector::unit(axis));
        }
    }
    let coefficients = coefficients(hodograph, moving);
    let first = coefficients.first().ok_or(CurveError::Point)?;
    let crosses = coefficients.iter().map(|other| first.cross(other));
    let cross = crosses.into_iter().find(|cross| !cross.is_zero()).ok_or(CurveError::Line)?;
    if !coefficients.iter().all(|coefficient| cross.dot(coefficient).is_zero()) {
        return Err(CurveError::NotPlanar);
    }
    unit(&cross)
}

/// The coefficients of a vector, up to a common factor, as a polynomial in the moving variables.
fn coefficients(vector: &Vector, moving: &[Variable]) -> Vec<Vector> {
    let common = Fraction::common_denominator(vector.components());
    let [x, y, z] = vector
        .components()
        .each_ref()
        .map(|component| component.numerator_over(&common).coefficients_of(moving));
    let keys = x.keys().chain(y.keys()).chain(z.keys()).map(|key| (key.clone(), ()));
    let keys: BTreeMap<Vec<u32>, ()> = keys.collect();
    let of = |part: &BTreeMap<Vec<u32>, Poly>, key: &[u32]| {
        Fraction::from(part.get(key).cloned().unwrap_or_else(Poly::zero))
    };
    keys.keys().map(|key| Vector::new(of(&x, key), of(&y, key), of(&z, key))).collect()
}

/// The unit vector along a vector of polynomials in symbols, with the sign of [`axis`].
fn unit(vector: &Vector) -> Result<Vector, CurveError> {
    let parts = vector.components().each_ref().map(|component| component.numerator().clone());
    let content = Poly::gcd_many(&parts);
    let parts = parts.map(|part| part.exact_div(&content).unwrap_or(part));
    let number = Poly::common_content(&parts).recip();
    let parts = parts.map(|part| part.scale(&number));
    let last = parts.iter().rev().find(|part| !part.is_zero()).ok_or(CurveError::Line)?;
    // Where symbols decide on the sign, the leading term is positive.
    let negative = last.leading_coefficient().sign().is_lt();
    let squared: Poly = parts.iter().map(|part| part * part).sum();
    let length = rational_root(&squared.clone().into())
        .map_err(|_| CurveError::IrrationalPlane { squared: Box::new(squared) })?;
    // A sum of squares without common factor keeps the sign of its root.
    let any = Variable::new(0, "");
    let reversed = sample_sign(&length, &any, &Interval::unit()).is_lt();
    let inverse = length.reciprocal(&[]).ok_or(CurveError::Line)?;
    let [x, y, z] = parts.map(Fraction::from);
    let unit = Vector::new(x, y, z).scale(&inverse).reduced();
    Ok(if negative != reversed { -&unit } else { unit })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{integer, ratio};

    fn v() -> Poly {
        Poly::variable(&Variable::new(1, "v"))
    }

    fn axis_of(x: Poly, y: Poly, z: Poly) -> Result<String, CurveError> {
        let parameter = Variable::new(1, "v");
        let position = Vector::new(x.into(), y.into(), z.into());
        let hodograph = position.derivative(&parameter);
        let axis = axis(&position, &hodograph, std::slice::from_ref(&parameter))?;
        assert!(axis.dot(&hodograph).is_zero());
        assert_eq!(axis.norm2(), Fraction::one());
        Ok(axis.to_string())
    }

    #[test]
    fn planes_and_their_axes() {
        let (x, one) = (v(), Poly::one());
        let square = x.pow(2);
        let zero = Poly::zero;
        assert_eq!(axis_of(x.clone(), square.clone(), zero()).unwrap(), "(0, 0, 1)");
        assert_eq!(axis_of(x.clone(), zero(), square.clone()).unwrap(), "(0, 1, 0)");
        assert_eq!(axis_of(zero(), x.clone(), square.clone()).unwrap(), "(1, 0, 0)");
        // Parallel to a coordinate plane.
        assert_eq!(axis_of(x.clone(), square.clone(), one.clone()).unwrap(), "(0, 0, 1)");
        // 3x = 4z: the axis (-3, 0, 4)/5, whatever the direction of the curve.
        let scaled = |k: i64| x.scale(&integer(k));
        assert_eq!(axis_of(scaled(4), square.clone(), scaled(3)).unwrap(), "(-3/5, 0, 4/5)");
        assert_eq!(axis_of(scaled(4), -&square, scaled(3)).unwrap(), "(-3/5, 0, 4/5)");
        // x + y + z = 1.
        let rest = &one - &x - &square;
        assert_eq!(axis_of(x.clone(), square.clone(), rest).unwrap(), "(1/3*sqrt3, 1/3*sqrt3, 1/3*sqrt3)");
        // x = y, where the z-component of the axis is zero.
        assert_eq!(axis_of(x.clone(), x.clone(), square.clone()).unwrap(), "(-1/2*sqrt2, 1/2*sqrt2, 0)");
    }

    #[test]
    fn curves_without_a_plane() {
        let x = v();
        let (square, cube) = (x.pow(2), x.pow(3));
        assert_eq!(axis_of(x.clone(), square.clone(), cube), Err(CurveError::NotPlanar));
        assert_eq!(axis_of(x.clone(), x.scale(&ratio(1, 2)), -&x), Err(CurveError::Line));
        let c = Poly::variable(&Variable::new(Variable::SYMBOL, "c"));
        let error = axis_of(x.clone(), square.clone(), &c * &x).unwrap_err();
        assert_eq!(error, CurveError::IrrationalPlane { squared: Box::new(c.pow(2) + Poly::one()) });
        // A symbolic plane with a rational unit normal: 2c·x = (1 − c²)·z.
        let (a, b) = (c.scale(&integer(2)), Poly::one() - c.pow(2));
        let axis = axis_of(&b * &x, square, &a * &x).unwrap();
        assert_eq!(axis, "(2*c/(c^2 + 1), 0, (c^2 - 1)/(c^2 + 1))");
    }
}
