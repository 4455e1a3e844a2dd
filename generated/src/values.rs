//! What is known of a surface near a point.

/// A point with both first derivatives.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C)]
pub struct FirstOrder<F = f64> {
    /// R.
    pub point: [F; 3],
    /// R_u = ∂R/∂u.
    pub partial_u: [F; 3],
    /// R_v = ∂R/∂v.
    pub partial_v: [F; 3],
}

/// A point with all first and second derivatives.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C)]
pub struct SecondOrder<F = f64> {
    /// R.
    pub point: [F; 3],
    /// R_u = ∂R/∂u.
    pub partial_u: [F; 3],
    /// R_v = ∂R/∂v.
    pub partial_v: [F; 3],
    /// R_uu = ∂²R/∂u².
    pub partial_uu: [F; 3],
    /// R_uv = ∂²R/∂u∂v.
    pub partial_uv: [F; 3],
    /// R_vv = ∂²R/∂v².
    pub partial_vv: [F; 3],
}

/// The differential geometry at a regular point.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[repr(C)]
pub struct LocalGeometry<F = f64> {
    /// The point with its derivatives.
    pub derivatives: SecondOrder<F>,
    /// The unit normal N.
    pub normal: [F; 3],
    /// The first fundamental form: E = R_u·R_u, F = R_u·R_v, G = R_v·R_v.
    pub first_form: [F; 3],
    /// The second fundamental form: L = N·R_uu, M = N·R_uv, N = N·R_vv.
    pub second_form: [F; 3],
    /// The Gaussian curvature K = (LN − M²)/(EG − F²).
    pub gaussian: F,
    /// The mean curvature H = (EN − 2FM + GL)/(2(EG − F²)).
    pub mean: F,
    /// The principal curvatures, the larger one first.
    pub principal: [F; 2],
    /// The parametric speeds ‖R_u‖ and ‖R_v‖.
    pub speeds: [F; 2],
    /// ∂N/∂u.
    pub normal_u: [F; 3],
    /// ∂N/∂v.
    pub normal_v: [F; 3],
}

impl<F: Copy> SecondOrder<F> {
    /// The point with its first derivatives alone.
    #[must_use]
    pub fn first_order(&self) -> FirstOrder<F> {
        FirstOrder { point: self.point, partial_u: self.partial_u, partial_v: self.partial_v }
    }
}

impl<F: Copy> From<[F; 9]> for FirstOrder<F> {
    /// R, R_u and R_v of their components, in this order.
    #[inline(always)]
    fn from(values: [F; 9]) -> Self {
        Self::of(|k| values[k])
    }
}

impl<F: Copy> From<[F; 18]> for SecondOrder<F> {
    /// R, R_u, R_v, R_uu, R_uv and R_vv of their components, in this order.
    #[inline(always)]
    fn from(values: [F; 18]) -> Self {
        Self::of(|k| values[k])
    }
}

impl<F: Copy> From<[F; 39]> for LocalGeometry<F> {
    /// All fields of their components, in the order of the fields.
    #[inline(always)]
    fn from(values: [F; 39]) -> Self {
        Self::of(|k| values[k])
    }
}

impl<F: Copy> FirstOrder<F> {
    /// All fields of their components, by places from 0 to 8.
    #[inline(always)]
    pub(crate) fn of(number: impl Fn(usize) -> F) -> Self {
        Self { point: three(&number, 0), partial_u: three(&number, 3), partial_v: three(&number, 6) }
    }
}

impl<F: Copy> SecondOrder<F> {
    /// All fields of their components, by places from 0 to 17.
    #[inline(always)]
    pub(crate) fn of(number: impl Fn(usize) -> F) -> Self {
        Self {
            point: three(&number, 0),
            partial_u: three(&number, 3),
            partial_v: three(&number, 6),
            partial_uu: three(&number, 9),
            partial_uv: three(&number, 12),
            partial_vv: three(&number, 15),
        }
    }
}

impl<F: Copy> LocalGeometry<F> {
    /// All fields of their components, by places from 0 to 38.
    #[inline(always)]
    pub(crate) fn of(number: impl Fn(usize) -> F) -> Self {
        Self {
            derivatives: SecondOrder::of(&number),
            normal: three(&number, 18),
            first_form: three(&number, 21),
            second_form: three(&number, 24),
            gaussian: number(27),
            mean: number(28),
            principal: [number(29), number(30)],
            speeds: [number(31), number(32)],
            normal_u: three(&number, 33),
            normal_v: three(&number, 36),
        }
    }
}

impl<F: Copy + Default> FirstOrder<F> {
    /// All components, in the order of the fields.
    #[must_use]
    pub fn numbers(&self) -> [F; 9] {
        gather(&[&self.point, &self.partial_u, &self.partial_v])
    }
}

impl<F: Copy + Default> SecondOrder<F> {
    /// All components, in the order of the fields.
    #[must_use]
    pub fn numbers(&self) -> [F; 18] {
        let Self { point, partial_u, partial_v, partial_uu, partial_uv, partial_vv } = self;
        gather(&[point, partial_u, partial_v, partial_uu, partial_uv, partial_vv])
    }
}

impl<F: Copy + Default> LocalGeometry<F> {
    /// All components, in the order of the fields.
    #[must_use]
    pub fn numbers(&self) -> [F; 39] {
        gather(&[
            &self.derivatives.numbers(),
            &self.normal,
            &self.first_form,
            &self.second_form,
            &[self.gaussian, self.mean],
            &self.principal,
            &self.speeds,
            &self.normal_u,
            &self.normal_v,
        ])
    }
}

/// All numbers of several lists.
fn gather<F: Copy + Default, const N: usize>(lists: &[&[F]]) -> [F; N] {
    let mut numbers = [F::default(); N];
    for (number, &value) in numbers.iter_mut().zip(lists.iter().copied().flatten()) {
        *number = value;
    }
    numbers
}

/// Three numbers from a place on.
#[inline(always)]
fn three<F>(number: &impl Fn(usize) -> F, at: usize) -> [F; 3] {
    [number(at), number(at + 1), number(at + 2)]
}

#[cfg(test)]
mod tests {
    use super::{FirstOrder, LocalGeometry, SecondOrder};

    #[test]
    fn numbers_keep_their_order() {
        let numbers: [f32; 39] = core::array::from_fn(|k| k as f32);
        let local = LocalGeometry::from(numbers);
        assert_eq!(local.numbers(), numbers);
        assert_eq!((local.normal, local.first_form), ([18.0, 19.0, 20.0], [21.0, 22.0, 23.0]));
        assert_eq!((local.second_form, local.gaussian, local.mean), ([24.0, 25.0, 26.0], 27.0, 28.0));
        assert_eq!((local.principal, local.speeds), ([29.0, 30.0], [31.0, 32.0]));
        assert_eq!((local.normal_u, local.normal_v), ([33.0, 34.0, 35.0], [36.0, 37.0, 38.0]));
        let second: [f32; 18] = core::array::from_fn(|k| k as f32);
        assert_eq!(local.derivatives, SecondOrder::from(second));
        assert_eq!(local.derivatives.partial_vv, [15.0, 16.0, 17.0]);
        let first: [f32; 9] = core::array::from_fn(|k| k as f32);
        assert_eq!(local.derivatives.first_order(), FirstOrder::from(first));
        assert_eq!((local.derivatives.numbers(), FirstOrder::from(first).numbers()), (second, first));
    }
}
