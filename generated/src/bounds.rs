//! Proved bounds of the errors of evaluators.

use crate::dispatch::Variant;
use crate::real::Float;

/// What is proved of the numbers that an evaluator computes, over the whole domain of a surface, in both precisions and
/// variants.
///
/// Every bound holds for the very sequence of operations of the generated code: for the rounding of its constants, of every
/// operation, and for underflow. The parameters count as exact.
///
/// ```
/// use hodograph::Variant;
/// use hodograph::catalogue::oriented_translation_example_2::OrientedTranslationExample2;
/// let bound = OrientedTranslationExample2::BOUNDS.point;
/// // Some units of 2^-53 of the surface's size, which is 4.
/// assert!(bound.error::<f64>(Variant::Plain) < 16.0 * 4.0 * 2.0_f64.powi(-53));
/// assert!(bound.error::<f32>(Variant::Fused) < 16.0 * 4.0 * 2.0_f64.powi(-24));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bound {
    /// |computed − exact| is at most this for each number: in `f64` plain and fused, then in `f32` plain and fused; infinite where
    /// nothing is proved.
    pub errors: [f64; 4],
    /// The same divided by |exact|, for every number; infinite where a number may vanish.
    pub relative_errors: [f64; 4],
    /// The largest number has somewhere at least this magnitude.
    pub size: f64,
    /// No number has a greater magnitude; infinite where that is not known.
    pub most: f64,
}

impl Bound {
    /// The bound of |computed − exact| in a precision and a variant; infinite where nothing is proved.
    #[must_use]
    pub fn error<F: Float>(&self, variant: Variant) -> f64 {
        self.errors[place::<F>(variant)]
    }

    /// Whether a bound says nothing, or no more than that all numbers are of their size: 0 is as near.
    ///
    /// ```
    /// use hodograph::Bound;
    /// let bound = Bound { errors: [1e-9, 1e-9, 3.0, f64::INFINITY], relative_errors: [f64::INFINITY; 4], size: 1.5, most: 2.0 };
    /// assert!(!bound.is_vacuous::<f64>(hodograph::Variant::Plain) && bound.is_vacuous::<f32>(hodograph::Variant::Plain));
    /// ```
    #[must_use]
    pub fn is_vacuous<F: Float>(&self, variant: Variant) -> bool {
        let error = self.error::<F>(variant);
        error > 0.0 && error >= self.most || error.is_infinite()
    }

    /// The bound of |computed − exact| / |exact| in a precision and a variant; infinite where nothing is proved.
    #[must_use]
    pub fn relative_error<F: Float>(&self, variant: Variant) -> f64 {
        self.relative_errors[place::<F>(variant)]
    }
}

/// The place in the arrays of [`Bound`] of a precision and a variant.
pub(crate) fn place<F: Float>(variant: Variant) -> usize {
    // Whatever is not single precision is double.
    let single = size_of::<F>() == size_of::<f32>();
    2 * usize::from(single) + usize::from(variant == Variant::Fused)
}

/// The bounds of everything that is evaluated of a surface, as far as it is certain of each of them that it is defined on the
/// domain, or but for singular points, where what needs a normal is answered by [`Undefined::Singular`](crate::Undefined).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// W, X, Y and Z.
    pub homogeneous: Bound,
    /// The point.
    pub point: Bound,
    /// |computed − exact| of x, y and z of the point, each in `f64` plain and fused, then in `f32` plain and fused.
    pub coordinates: [[f64; 4]; 3],
    /// The point in its separated form.
    pub separated_point: Bound,
    /// R_u.
    pub partial_u: Bound,
    /// R_v.
    pub partial_v: Bound,
    /// R_uu.
    pub partial_uu: Bound,
    /// R_uv.
    pub partial_uv: Bound,
    /// R_vv.
    pub partial_vv: Bound,
    /// The unit normal.
    pub unit_normal: Bound,
    /// E, F and G.
    pub first_form: Bound,
    /// L, M and N.
    pub second_form: Bound,
    /// The Gaussian curvature.
    pub gaussian: Bound,
    /// The mean curvature.
    pub mean: Bound,
    /// The principal curvatures.
    pub principal: Bound,
    /// The parametric speeds.
    pub speeds: Bound,
    /// The derivative of the unit normal by u.
    pub normal_u: Bound,
    /// The derivative of the unit normal by v.
    pub normal_v: Bound,
}

impl Bounds {
    /// The bound of |computed − exact| for each coordinate of an offset point at the distance `r`; infinite where nothing is
    /// proved.
    ///
    /// With the bounds of the point and of the normal, and u for the unit roundoff, it is
    /// e + |r|·e_n + u·(2·|r|·(1 + e_n) + max|R| + e), for a product that is rounded before it is added, or not; and the least number
    /// of the precision, for underflow. Overflow is excluded, or there is no bound.
    ///
    /// ```
    /// use hodograph::Variant;
    /// use hodograph::catalogue::oriented_translation_example_2::OrientedTranslationExample2;
    /// let bounds = OrientedTranslationExample2::BOUNDS;
    /// let (near, far) = (bounds.offset_point::<f64>(Variant::Plain, 0.1), bounds.offset_point::<f64>(Variant::Plain, -100.0));
    /// assert!(bounds.point.error::<f64>(Variant::Plain) < near && near < 1e-14 && near < far && far < 1e-12);
    /// assert!(bounds.offset_point::<f32>(Variant::Plain, 1e38) < 1e33);
    /// assert!(bounds.offset_point::<f32>(Variant::Plain, 1e39).is_infinite());
    /// ```
    #[must_use]
    pub fn offset_point<F: Float>(&self, variant: Variant, r: f64) -> f64 {
        offset::<F>(&self.point, &self.unit_normal, variant, r)
    }

    /// The bounds of |computed − exact| for each coordinate of the point and of the derivatives by u and by v of an offset at the
    /// distance `r`, as they are computed together: like [`Bounds::offset_point`], from those of R, R_u, R_v and n, n_u, n_v.
    #[must_use]
    pub fn offset_first_order<F: Float>(&self, variant: Variant, r: f64) -> [f64; 3] {
        [
            offset::<F>(&self.separated_point, &self.unit_normal, variant, r),
            offset::<F>(&self.partial_u, &self.normal_u, variant, r),
            offset::<F>(&self.partial_v, &self.normal_v, variant, r),
        ]
    }
}

/// The bound of a + r·b, computed by one product that is added.
fn offset<F: Float>(a: &Bound, b: &Bound, variant: Variant, r: f64) -> f64 {
    let (of_a, of_b) = (a.error::<F>(variant), b.error::<F>(variant));
    if !(of_a + of_b + a.most + b.most).is_finite() {
        return f64::INFINITY;
    }
    let single = size_of::<F>() == size_of::<f32>();
    let (unit, least) = if single { (f32::EPSILON.into(), 1e-45) } else { (f64::EPSILON, 5e-324) };
    // The number before the last rounding, and twice the unit roundoff for what is rounded of second order.
    let product = r.abs() * (b.most + of_b);
    // A number of twice this size overflows.
    let half = F::LARGEST / 2.0;
    let size = product + a.most + of_a;
    if size.is_nan() || size >= half {
        return f64::INFINITY;
    }
    let rounding = 0.5 * unit * (1.0 + 4.0 * unit) * (2.0 * product + a.most + of_a) + 2.0 * least;
    // The floats of this sum are off by less than 2^-50 of it.
    (of_a + r.abs() * of_b + rounding) * (1.0 + 8.0 * f64::EPSILON) + f64::from_bits(8)
}
