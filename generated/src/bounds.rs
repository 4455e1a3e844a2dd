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
}

impl Bound {
    /// The bound of |computed − exact| in a precision and a variant; infinite where nothing is proved.
    #[must_use]
    pub fn error<F: Float>(&self, variant: Variant) -> f64 {
        self.errors[place::<F>(variant)]
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
/// domain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds {
    /// W, X, Y and Z.
    pub homogeneous: Bound,
    /// The point.
    pub point: Bound,
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
