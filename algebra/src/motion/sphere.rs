//! Euler's map from 4-space onto the sphere of unit quaternions, and its inverse.

use crate::{Fraction, Poly, Quaternion, integer};

/// The image of a point of 4-space on the sphere S³ (JW (4), after Euler and Aida):
///
/// ```text
/// M(x1, x2, x3, x4) = (x1² + x2² + x3² − x4², 2 x1 x4, 2 x2 x4, 2 x3 x4) / (x1² + x2² + x3² + x4²)
/// ```
///
/// The result is the numerators; their common denominator is the squared norm of `point`, which is their own norm. With
/// `p = x4 − x1 i − x2 j − x3 k` it is `−p²`: the map squares quaternions, so `point` and its multiples have one image, and
/// M doubles every degree.
///
/// # Example
/// ```
/// use hodograph_algebra::{Fraction, Quaternion, from_sphere, Lift, integer, onto_sphere};
/// let point = |parts: [i64; 4]| {
///     let [w, x, y, z] = parts.map(|part| Fraction::from(integer(part)));
///     Quaternion::new(w, x, y, z)
/// };
/// let image = onto_sphere(&point([2, 0, 1, 1]));
/// assert_eq!(image, point([4, 4, 0, 2]));
/// assert_eq!(image.norm2(), Fraction::from(integer(36)));
/// // The whole hyperplane x4 = 0 goes to the pole.
/// assert_eq!(onto_sphere(&point([1, 2, 2, 0])), point([9, 0, 0, 0]));
/// ```
#[must_use]
pub fn onto_sphere(point: &Quaternion) -> Quaternion {
    let [a, b, c, d] = point.components();
    let square = |part: &Fraction| part * part;
    let rest = &(&square(a) + &square(b)) + &square(c);
    let double = d.scale(&integer(2));
    Quaternion::new(&rest - &square(d), a * &double, b * &double, c * &double)
}

/// Which of the points that M maps to a unit quaternion stands for it: they are a line through 0, without 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Lift {
    /// `(x2, x3, x4, 1 − x1)`: no root is taken, so that rational quaternions have rational points. [`Motion`](crate::Motion) takes it
    /// or its negative, whichever is nearer to the point of the frame before.
    #[default]
    Projective,
    /// The same over `2·√((1 − x1)/2)`: the points of length 1, of which [`Motion`](crate::Motion) takes the one that is nearer to
    /// that of the frame before.
    Unit,
    /// The same point of length 1 with the positive last coordinate, as in JW (5). Two orientations on both sides of the pole, which is the
    /// orientation without a turn, have points far from each other, so that the motion between them takes the long way.
    Positive,
}

/// A point of 4-space that [`onto_sphere`] maps to the unit quaternion `q`; its last coordinate is positive. `None` at the
/// pole `q = 1`, to which M maps the hyperplane x4 = 0, and no other point.
///
/// # Example
/// ```
/// use hodograph_algebra::{Lift, Poly, from_sphere, ratio};
/// let q = [(-7, 25), (24, 25), (0, 1), (0, 1)].map(|(n, d)| Poly::constant(ratio(n, d)));
/// let [projective, unit] = [Lift::Projective, Lift::Unit].map(|lift| from_sphere(&q, lift).unwrap());
/// assert_eq!(projective.map(|part| part.to_string()), ["24/25", "0", "0", "32/25"]);
/// assert_eq!(unit.map(|part| part.to_string()), ["3/5", "0", "0", "4/5"]);
/// assert_eq!(from_sphere(&[1, 0, 0, 0].map(Poly::integer), Lift::Unit), None);
/// ```
///
/// # Panics
/// If the parts are no numbers.
#[must_use]
pub fn from_sphere(q: &[Poly; 4], lift: Lift) -> Option<[Poly; 4]> {
    let [x1, x2, x3, x4] = q;
    let height = Poly::one() - x1;
    if height.is_zero() {
        return None;
    }
    let point = [x2.clone(), x3.clone(), x4.clone(), height.clone()];
    match lift {
        Lift::Projective => Some(point),
        Lift::Unit | Lift::Positive => {
            // 1 − x1 is positive on the sphere, but for the pole.
            let length = height.scale(&integer(2)).sqrt()?;
            let inverse = length.inverse();
            Some(point.map(|part| part * &inverse))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Variable, ratio};

    #[test]
    fn the_image_is_minus_a_square() {
        let part = |name| Fraction::from(Poly::variable(&Variable::new(Variable::SYMBOL, name)));
        let [a, b, c, d] = ["a", "b", "c", "d"].map(part);
        let p = Quaternion::new(d.clone(), -&a, -&b, -&c);
        let point = Quaternion::new(a, b, c, d);
        let image = onto_sphere(&point);
        assert_eq!(image, -(&p * &p));
        assert_eq!(image.norm2(), point.norm2().pow(2));
    }

    #[test]
    fn both_lifts_have_the_quaternion_for_their_image() {
        for (n, w) in [([2, 3, 6, 0], 7), ([1, 2, 2, 4], 5), ([-1, 1, 1, 1], 2), ([0, 3, 0, 4], 5)] {
            let q = n.map(|part| Poly::constant(ratio(part, w)));
            for lift in [Lift::Projective, Lift::Unit] {
                let point = from_sphere(&q, lift).unwrap();
                assert!(point[3].sign().is_gt());
                let [w, x, y, z] = point.clone().map(Fraction::from);
                let point = Quaternion::new(w, x, y, z);
                let norm2 = point.norm2();
                assert_eq!(lift == Lift::Unit, norm2.is_one());
                let image = onto_sphere(&point).map(|part| part.checked_div(&norm2).unwrap());
                assert_eq!(image.components(), &q.clone().map(Fraction::from));
            }
        }
    }
}
