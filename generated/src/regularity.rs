//! What exists at regular points of a surface only: unit normals and offset points.

use crate::float::sqrt;

/// A vector that a surface has at its regular points only, such as its unit normal or the point of an offset.
///
/// A point is *singular* where R_u × R_v vanishes, or is not defined at all (as at a pole W = 0). No evaluator
/// answers with NaN in place of a normal: it answers [`Regularity::Singular`].
///
/// ```
/// use hodograph::Regularity;
/// let normal = Regularity::unit([0.0, 3.0, 4.0]);
/// assert_eq!(normal, Regularity::Regular([0.0, 0.6, 0.8]));
/// assert_eq!(Regularity::unit([0.0; 3]).regular(), None);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[must_use]
pub enum Regularity {
    /// The point is regular; the vector has finite components.
    Regular([f64; 3]),
    /// The surface has no normal there.
    Singular,
}

impl Regularity {
    /// The vector at a regular point, else `None`.
    #[inline]
    #[must_use]
    pub const fn regular(self) -> Option<[f64; 3]> {
        match self {
            Self::Regular(vector) => Some(vector),
            Self::Singular => None,
        }
    }

    /// Whether the point is singular.
    #[inline]
    #[must_use]
    pub const fn is_singular(self) -> bool {
        matches!(self, Self::Singular)
    }

    /// `vector` where its components are finite, else [`Regularity::Singular`].
    #[inline]
    pub fn finite(vector: [f64; 3]) -> Self {
        let [x, y, z] = vector;
        if x.is_finite() && y.is_finite() && z.is_finite() { Self::Regular(vector) } else { Self::Singular }
    }

    /// The unit vector n/‖n‖ of the direction `n`, singular where `n` is zero or not finite.
    ///
    /// Directions so short or long that ‖n‖² leaves the range of `f64` are scaled first.
    #[inline]
    pub fn unit(direction: [f64; 3]) -> Self {
        // Above the lower limit no square that matters has lost bits to underflow.
        const SMALLEST: f64 = 1e-280;
        let [x, y, z] = direction;
        let square = x * x + y * y + z * z;
        if (SMALLEST..=f64::MAX).contains(&square) {
            let norm = sqrt(square);
            return Self::Regular([x / norm, y / norm, z / norm]);
        }
        Self::scaled_unit(direction)
    }

    #[cold]
    fn scaled_unit([x, y, z]: [f64; 3]) -> Self {
        let largest = x.abs().max(y.abs()).max(z.abs());
        let scaled = [x / largest, y / largest, z / largest];
        // A zero or infinite direction has just become NaN, as has one with a NaN component.
        match Self::finite(scaled) {
            Self::Regular([x, y, z]) => {
                let norm = sqrt(x * x + y * y + z * z);
                Self::finite([x / norm, y / norm, z / norm])
            }
            Self::Singular => Self::Singular,
        }
    }

    /// The point at distance `r` along the unit normal that `self` is: p + r·n.
    ///
    /// Singular where the normal is, and where the point is not finite.
    #[inline]
    pub fn offset(self, point: [f64; 3], r: f64) -> Self {
        let ([x, y, z], Self::Regular([a, b, c])) = (point, self) else { return Self::Singular };
        Self::finite([x + r * a, y + r * b, z + r * c])
    }
}

#[cfg(test)]
mod tests {
    use super::Regularity;

    #[test]
    fn unit_vectors_keep_their_direction_at_every_size() {
        for size in [1e-310, 1e-200, 1e-100, 1.0, 1e100, 1e200, 1e307] {
            let Regularity::Regular([x, y, z]) = Regularity::unit([2.0 * size, -3.0 * size, 6.0 * size])
            else {
                panic!("{size:e} is not singular");
            };
            // The smallest size is subnormal, with some 13 digits left.
            for (found, exact) in [(x, 2.0 / 7.0), (y, -3.0 / 7.0), (z, 6.0 / 7.0)] {
                assert!((found - exact).abs() < 1e-12, "{size:e}: {found} is not {exact}");
            }
        }
    }

    #[test]
    fn directions_that_are_none_are_singular() {
        let none = [0.0, -0.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
        for bad in none {
            assert!(Regularity::unit([bad, 0.0, 0.0]).is_singular());
        }
        assert!(Regularity::unit([f64::NAN, 1.0, 0.0]).is_singular());
        assert!(Regularity::unit([1e-200, f64::NAN, 0.0]).is_singular());
        assert!(Regularity::unit([1.0, f64::INFINITY, 0.0]).is_singular());
    }

    #[test]
    fn offsets_are_regular_only_at_finite_points() {
        let normal = Regularity::Regular([0.0, 0.0, -1.0]);
        assert_eq!(normal.offset([1.0, 2.0, 3.0], 0.5), Regularity::Regular([1.0, 2.0, 2.5]));
        assert!(normal.offset([1.0, f64::NAN, 3.0], 0.5).is_singular());
        assert!(normal.offset([1.0, 2.0, f64::INFINITY], 0.5).is_singular());
        assert!(Regularity::Singular.offset([1.0, 2.0, 3.0], 0.5).is_singular());
    }
}
