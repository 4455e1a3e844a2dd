//! One segment of a motion, with all that a sweep along it needs.

use crate::motion::path::Orientation;
use crate::motion::sphere::onto_sphere;
use crate::motion::spline::bernstein_sum;
use crate::{Bernstein, Fraction, Interval, Poly, Quaternion, Variable, Vector};

/// One segment of a [`Motion`](crate::Motion): rational functions of its parameter.
#[derive(Clone, Debug)]
pub struct MotionSegment {
    variable: Variable,
    interval: Interval,
    position: [Poly; 3],
    scale: Option<Poly>,
    curve: Quaternion,
    /// The quaternion's numerators, and the squared norm of the curve.
    quaternion: Quaternion,
    norm2: Poly,
    orientation: Orientation,
    axes: [Vector; 3],
}

impl MotionSegment {
    /// The segment with these polynomials: three of the position, four of the curve in 4-space.
    pub(crate) fn new(
        variable: &Variable,
        interval: Interval,
        position: Vec<Poly>,
        scale: Option<Poly>,
        curve: Vec<Poly>,
        orientation: Orientation,
    ) -> MotionSegment {
        let part = |parts: &[Poly], axis: usize| parts.get(axis).cloned().unwrap_or_else(Poly::zero);
        let [w, x, y, z] = [0, 1, 2, 3].map(|axis| Fraction::from(part(&curve, axis)));
        let curve = Quaternion::new(w, x, y, z);
        let norm2 = curve.norm2().to_poly().unwrap_or_else(Poly::one);
        let (quaternion, power) = match orientation {
            Orientation::Sphere => (onto_sphere(&curve), 2),
            Orientation::Direct => (curve.clone(), 1),
        };
        let weight = Fraction::new(Poly::one(), [(norm2.clone(), power)]);
        let axes = [0, 1, 2].map(|axis| {
            let image = quaternion.sandwich(&Vector::unit(axis));
            image.map(|component| component * &weight)
        });
        MotionSegment {
            variable: variable.clone(),
            interval,
            position: [0, 1, 2].map(|axis| part(&position, axis)),
            scale,
            curve,
            quaternion,
            norm2,
            orientation,
            axes,
        }
    }

    /// The parameter.
    #[must_use]
    pub fn parameter(&self) -> &Variable {
        &self.variable
    }

    /// The interval of the parameter.
    #[must_use]
    pub fn interval(&self) -> &Interval {
        &self.interval
    }

    /// The position `P(v)` of the reference point.
    #[must_use]
    pub fn position(&self) -> Vector {
        let [x, y, z] = self.position.clone().map(Fraction::from);
        Vector::new(x, y, z)
    }

    /// The size `S(v)`; 1 if all frames have that size.
    #[must_use]
    pub fn scale(&self) -> Fraction {
        self.scale.clone().map_or_else(Fraction::one, Fraction::from)
    }

    /// The spline in 4-space that the orientation comes from.
    #[must_use]
    pub fn curve(&self) -> &Quaternion {
        &self.curve
    }

    /// The quaternion of the orientation: a unit quaternion for [`Orientation::Sphere`], the curve itself for
    /// [`Orientation::Direct`].
    #[must_use]
    pub fn quaternion(&self) -> Quaternion {
        match self.orientation {
            Orientation::Sphere => {
                let weight = Fraction::new(Poly::one(), [(self.norm2.clone(), 1)]);
                self.quaternion.scale(&weight)
            }
            Orientation::Direct => self.quaternion.clone(),
        }
    }

    /// The common denominator of the rotation matrix: `|C|⁴` for [`Orientation::Sphere`] (JW (12)), `|Q|²` for
    /// [`Orientation::Direct`].
    #[must_use]
    pub fn weight(&self) -> Poly {
        match self.orientation {
            Orientation::Sphere => self.norm2.pow(2),
            Orientation::Direct => self.norm2.clone(),
        }
    }

    /// The rotated vector `O(v) a`.
    #[must_use]
    pub fn rotate(&self, a: &Vector) -> Vector {
        let turned = a.components().iter().zip(&self.axes).filter(|(part, _)| !part.is_zero());
        turned.fold(Vector::zero(), |sum, (part, axis)| &sum + &axis.scale(part))
    }

    /// The exact sweep `P(v) + O(v) S(v) c` (JW (1)) of a point or curve `c`.
    #[must_use]
    pub fn sweep(&self, c: &Vector) -> Vector {
        &self.position() + &self.rotate(&self.scaled(c))
    }

    /// The surface of the control net that JW Theorem 7.1 prints, or Theorem 7.2 if the scale varies. Its control points add
    /// those of the elevated position curve to the rotated ones, without regard to the weights: the reference point follows
    /// [`published_position`](MotionSegment::published_position) instead of `P(v)`. The rotation is that of JW (11); the matrix that Lemma 6.2
    /// prints for it is the transposed one.
    #[must_use]
    pub fn published(&self, c: &Vector) -> Vector {
        &self.published_position() + &self.rotate(&self.scaled(c))
    }

    /// The rational curve `Σ wⱼ pⱼ⁺ Bⱼ / Σ wⱼ Bⱼ` of JW Theorems 7.1 and 7.2, with the control points of the position curve and
    /// the weights of the rotation, both elevated to the degree of the rotation, plus that of the scale if it varies.
    #[must_use]
    pub fn published_position(&self) -> Vector {
        let weight = self.weight();
        let degree = |poly: &Poly| poly.degree(&self.variable).unwrap_or(0);
        let own = self.position.iter().map(degree).max().unwrap_or(0);
        let degree = (degree(&weight) + self.scale.as_ref().map_or(0, degree)).max(own);
        let t = (Poly::variable(&self.variable) - self.interval.lower()) * self.interval.width().inverse();
        let weights = self.bernstein(&weight, degree);
        let over = Fraction::new(
            Poly::one(),
            [(self.norm2.clone(), if self.orientation == Orientation::Sphere { 2 } else { 1 })],
        );
        let [x, y, z] = self.position.each_ref().map(|coordinate| {
            let points = self.bernstein(coordinate, degree);
            let products: Vec<Poly> = points.iter().zip(&weights).map(|(p, w)| p * w).collect();
            &Fraction::from(bernstein_sum(&products, &t)) * &over
        });
        Vector::new(x, y, z)
    }

    fn bernstein(&self, poly: &Poly, degree: u32) -> Vec<Poly> {
        let domain = [(self.variable.clone(), self.interval.clone())];
        let form = Bernstein::with_degrees(poly, &domain, &[degree]);
        form.map(|form| form.coefficients().to_vec()).unwrap_or_default()
    }

    fn scaled(&self, c: &Vector) -> Vector {
        match &self.scale {
            Some(scale) => c.scale(&scale.clone().into()),
            None => c.clone(),
        }
    }
}
