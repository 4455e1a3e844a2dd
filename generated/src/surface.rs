//! The trait of every swept surface.

use core::marker::PhantomData;

use crate::batch::{Batch, BatchError, is_finite};
use crate::bounds::Bounds;
use crate::dispatch::{Kernel, Variant, run};
use crate::real::{Float, Rounded};
use crate::task::{
    First, Homogeneous, Local, Normal, Part, Point, Second, Separated, Stages, Sweep, Task, convert,
};
use crate::undefined::Undefined;
use crate::values::{FirstOrder, LocalGeometry, SecondOrder};

/// The rectangle of parameters over which a surface is stated.
///
/// Evaluators accept every float; what is certified of a surface, such as its regularity and the sides of its normal, is
/// certified on its domain. The rectangle is closed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Domain {
    /// First and last value of u.
    pub u: [f64; 2],
    /// First and last value of v.
    pub v: [f64; 2],
}

impl Domain {
    /// Whether (u, v) lies in the closed rectangle.
    ///
    /// ```
    /// let unit_square = hodograph::Domain { u: [0.0, 1.0], v: [0.0, 1.0] };
    /// assert!(unit_square.contains(0.5, 1.0));
    /// assert!(!unit_square.contains(0.5, f64::NAN));
    /// ```
    #[must_use]
    pub fn contains(&self, u: f64, v: f64) -> bool {
        self.u[0] <= u && u <= self.u[1] && self.v[0] <= v && v <= self.v[1]
    }

    /// The domain's point at the fractions (s, t) of its sides; (0, 0) and (1, 1) are opposite corners exactly.
    ///
    /// ```
    /// let domain = hodograph::Domain { u: [-1.0, 1.0], v: [0.0, 3.0] };
    /// assert_eq!(domain.at(0.5, 1.0), (0.0, 3.0));
    /// ```
    #[must_use]
    pub fn at(&self, s: f64, t: f64) -> (f64, f64) {
        let between = |[first, last]: [f64; 2], t: f64| first * (1.0 - t) + last * t;
        (between(self.u, s), between(self.v, t))
    }
}

/// The control points of an offset, of those of the surface and what each unit of distance adds to X, Y and Z.
#[must_use]
pub fn offset_net<const N: usize>(net: &[([f64; 4], [f64; 3]); N], r: f64) -> [[f64; 4]; N] {
    net.map(|([w, x, y, z], [a, b, c])| [w, x + r * a, y + r * b, z + r * c])
}

/// What is stated of a surface as a whole: the same in every precision.
pub trait Patch {
    /// The name of the surface in the formula that it was generated from.
    fn name(&self) -> &str;

    /// The patch degree: the largest degrees of W, X, Y and Z in u and in v.
    fn degree(&self) -> (u32, u32);

    /// The rectangle of parameters over which the surface is stated.
    fn domain(&self) -> Domain;

    /// The Bézier control points over [`domain`](Patch::domain), homogeneous (W, X, Y, Z); the index of u is the
    /// outer one, so that with degree (m, n) the point b_ij is `control_net()[i * (n + 1) + j]`.
    fn control_net(&self) -> &[[f64; 4]];

    /// Proved bounds of the errors of all evaluators over [`domain`](Patch::domain).
    ///
    /// Members of families have none that are known when they are compiled: [`error_bounds`](crate::error_bounds) proves theirs at run time.
    fn bounds(&self) -> Option<&Bounds> {
        None
    }
}

/// A rational surface R(u, v) = (X, Y, Z)/W with everything that is evaluated of it, in the precision `F`.
///
/// The trait is object safe, so that callers can hold `&dyn Surface`. Every [`Sweep`] implements it for `f64` and `f32`; the
/// type of the parameters says which is meant.
///
/// All parameters are accepted, outside of the [domain](Patch::domain) too. Where there is no finite result, as at a pole
/// W = 0, methods say why, with [`Undefined`]; none returns infinity or NaN.
///
/// Everything is evaluated in one [`Variant`], that of the machine unless the surface is [pinned](Sweep::pinned) to another;
/// within one variant a number has the same bits whichever method computes it, with the exception of
/// [`separated_point`](Surface::separated_point), which is the point that the methods for derivatives return.
pub trait Surface<F: Float = f64>: Patch {
    /// The variant that the surface is evaluated in.
    fn variant(&self) -> Variant;

    /// The homogeneous coordinates (W, X, Y, Z) at (u, v).
    ///
    /// # Errors
    /// [`Undefined::Parameter`] and [`Undefined::Overflow`].
    fn homogeneous(&self, u: F, v: F) -> Result<[F; 4], Undefined>;

    /// The point R(u, v) = (X/W, Y/W, Z/W), computed with one division.
    ///
    /// # Errors
    /// [`Undefined`] where W = 0 or the point is not finite.
    fn point(&self, u: F, v: F) -> Result<[F; 3], Undefined>;

    /// The point R(u, v) in the form that is fastest on grids, with quotients of u alone and of v alone.
    ///
    /// It differs from [`point`](Surface::point) by rounding.
    ///
    /// # Errors
    /// As for [`point`](Surface::point).
    fn separated_point(&self, u: F, v: F) -> Result<[F; 3], Undefined>;

    /// The partial derivative R_u = ∂R/∂u at (u, v).
    ///
    /// # Errors
    /// As for [`point`](Surface::point).
    fn partial_u(&self, u: F, v: F) -> Result<[F; 3], Undefined>;

    /// The partial derivative R_v = ∂R/∂v at (u, v).
    ///
    /// # Errors
    /// As for [`point`](Surface::point).
    fn partial_v(&self, u: F, v: F) -> Result<[F; 3], Undefined>;

    /// The point with both first derivatives, in one pass.
    ///
    /// # Errors
    /// As for [`point`](Surface::point).
    fn first_order(&self, u: F, v: F) -> Result<FirstOrder<F>, Undefined>;

    /// The point with all first and second derivatives, in one pass.
    ///
    /// # Errors
    /// As for [`point`](Surface::point).
    fn second_order(&self, u: F, v: F) -> Result<SecondOrder<F>, Undefined>;

    /// The unit normal of the surface at (u, v): the unit vector of R_u × R_v.
    ///
    /// On the domain it turns over where the common factor of the components of R_u × R_v changes its sign; outside of the
    /// domain it may continue smoothly instead. It is computed from polynomials without common factor, so that it may exist where
    /// R_u and R_v do not: as a limit at a pole, or where they overflow.
    ///
    /// # Errors
    /// [`Undefined`]; that is [`Undefined::Singular`] where R_u × R_v, as it is computed, vanishes.
    fn unit_normal(&self, u: F, v: F) -> Result<[F; 3], Undefined>;

    /// The differential geometry at (u, v): derivatives, normal, fundamental forms, curvatures and speeds, in one pass.
    ///
    /// # Errors
    /// As for [`unit_normal`](Surface::unit_normal).
    fn local_geometry(&self, u: F, v: F) -> Result<LocalGeometry<F>, Undefined>;

    /// The parametric speed ‖R_u‖ of the curves v = const.
    ///
    /// # Errors
    /// As for [`point`](Surface::point).
    fn speed_u(&self, u: F, v: F) -> Result<F, Undefined>;

    /// The parametric speed ‖R_v‖ of the curves u = const.
    ///
    /// # Errors
    /// As for [`point`](Surface::point).
    fn speed_v(&self, u: F, v: F) -> Result<F, Undefined>;

    /// The point R + r·N of the offset surface at the signed distance `r` along the unit normal N.
    ///
    /// # Errors
    /// As for [`unit_normal`](Surface::unit_normal).
    fn offset_point(&self, r: F, u: F, v: F) -> Result<[F; 3], Undefined>;

    /// The point R + r·N of the offset surface with its derivatives R_u + r·N_u and R_v + r·N_v.
    ///
    /// # Errors
    /// As for [`unit_normal`](Surface::unit_normal).
    fn offset_first_order(&self, r: F, u: F, v: F) -> Result<FirstOrder<F>, Undefined>;

    /// Writes R(`us[i]`, `vs[j]`) to `out[j * us.len() + i]`, a row for each v, with the bits of [`point`](Surface::point).
    ///
    /// Nothing is allocated; what depends on one parameter alone is computed once for many points. Derivatives, normals,
    /// separate slices of coordinates and rows are found under [`Sweep::batch`].
    ///
    /// # Errors
    /// [`BatchError`] if the length of `out` is not `us.len() * vs.len()`, and nothing is written then; or if the surface has no
    /// value at some points, which are infinite then, after all others have been written.
    fn grid(&self, us: &[F], vs: &[F], out: &mut [[F; 3]]) -> Result<(), BatchError>;

    /// Writes the unit normal at (`us[i]`, `vs[j]`) to `out[j * us.len() + i]`, and the zero vector where there is none; returns
    /// how many there are of those.
    ///
    /// # Errors
    /// [`BatchError`] if the length of `out` is not `us.len() * vs.len()`; nothing is written then.
    fn normal_grid(&self, us: &[F], vs: &[F], out: &mut [[F; 3]]) -> Result<usize, BatchError>;

    /// Writes R(`us[i]`, `vs[i]`) to `out[i]`, with the bits of [`point`](Surface::point).
    ///
    /// # Errors
    /// [`BatchError`] if the slices differ in length, and nothing is written then; or if the surface has no value at some
    /// points, which are infinite then, after all others have been written.
    fn points(&self, us: &[F], vs: &[F], out: &mut [[F; 3]]) -> Result<(), BatchError>;
}

impl<S: Sweep, F: Float> Surface<F> for S {
    #[inline]
    fn variant(&self) -> Variant {
        self.pinned_variant().unwrap_or_else(Variant::native)
    }

    #[inline]
    fn homogeneous(&self, u: F, v: F) -> Result<[F; 4], Undefined> {
        // They exist at poles.
        let overflow = |reason| if reason == Undefined::Pole { Undefined::Overflow } else { reason };
        evaluate::<Homogeneous, S, F, _>(self, u, v).map_err(overflow)
    }

    #[inline]
    fn point(&self, u: F, v: F) -> Result<[F; 3], Undefined> {
        evaluate::<Point, S, F, _>(self, u, v)
    }

    #[inline]
    fn separated_point(&self, u: F, v: F) -> Result<[F; 3], Undefined> {
        evaluate::<Separated, S, F, _>(self, u, v)
    }

    #[inline]
    fn partial_u(&self, u: F, v: F) -> Result<[F; 3], Undefined> {
        select::<First, S, F, 3>(self, u, v, 3)
    }

    #[inline]
    fn partial_v(&self, u: F, v: F) -> Result<[F; 3], Undefined> {
        select::<First, S, F, 3>(self, u, v, 6)
    }

    #[inline]
    fn first_order(&self, u: F, v: F) -> Result<FirstOrder<F>, Undefined> {
        evaluate::<First, S, F, _>(self, u, v)
    }

    #[inline]
    fn second_order(&self, u: F, v: F) -> Result<SecondOrder<F>, Undefined> {
        evaluate::<Second, S, F, _>(self, u, v)
    }

    #[inline]
    fn unit_normal(&self, u: F, v: F) -> Result<[F; 3], Undefined> {
        evaluate::<Normal, S, F, _>(self, u, v)
    }

    #[inline]
    fn local_geometry(&self, u: F, v: F) -> Result<LocalGeometry<F>, Undefined> {
        evaluate::<Local, S, F, _>(self, u, v)
    }

    #[inline]
    fn speed_u(&self, u: F, v: F) -> Result<F, Undefined> {
        select::<Local, S, F, 1>(self, u, v, 31).map(|[speed]| speed)
    }

    #[inline]
    fn speed_v(&self, u: F, v: F) -> Result<F, Undefined> {
        select::<Local, S, F, 1>(self, u, v, 32).map(|[speed]| speed)
    }

    #[inline]
    fn offset_point(&self, r: F, u: F, v: F) -> Result<[F; 3], Undefined> {
        if !r.is_finite() {
            return Err(Undefined::Parameter);
        }
        run(self.pinned_variant(), OffsetPoint { surface: self, r, u, v })
    }

    #[inline]
    fn offset_first_order(&self, r: F, u: F, v: F) -> Result<FirstOrder<F>, Undefined> {
        if !r.is_finite() {
            return Err(Undefined::Parameter);
        }
        run(self.pinned_variant(), OffsetFirstOrder { surface: self, r, u, v })
    }

    #[inline]
    fn grid(&self, us: &[F], vs: &[F], out: &mut [[F; 3]]) -> Result<(), BatchError> {
        Batch::new(self, Point).grid(us, vs, out).map(|_| ())
    }

    #[inline]
    fn normal_grid(&self, us: &[F], vs: &[F], out: &mut [[F; 3]]) -> Result<usize, BatchError> {
        Batch::new(self, Normal).grid(us, vs, out)
    }

    #[inline]
    fn points(&self, us: &[F], vs: &[F], out: &mut [[F; 3]]) -> Result<(), BatchError> {
        Batch::new(self, Point).points(us, vs, out).map(|_| ())
    }
}

/// The numbers of a task at a point.
#[inline(always)]
fn at<T: Task, S: Stages<T>, R: Rounded<F>, F: Float>(surface: &S, u: F, v: F) -> T::Values<R> {
    surface.join(surface.of_u(R::new(u)), surface.of_v(R::new(v)))
}

/// What a task gives, in the variant of the surface.
#[inline(always)]
fn evaluate<T: Task, S: Sweep + Stages<T>, F: Float, I: From<T::Values<F>>>(
    surface: &S,
    u: F,
    v: F,
) -> Result<I, Undefined> {
    run(
        surface.pinned_variant(),
        Evaluate { surface, u, v, task: PhantomData::<T>, result: PhantomData::<I> },
    )
}

struct Evaluate<'a, T, S, F, I> {
    surface: &'a S,
    u: F,
    v: F,
    task: PhantomData<T>,
    result: PhantomData<I>,
}

impl<T: Task, S: Sweep + Stages<T>, F: Float, I: From<T::Values<F>>> Kernel<F> for Evaluate<'_, T, S, F, I> {
    type Output = Result<I, Undefined>;

    #[inline(always)]
    fn run<R: Rounded<F>>(self) -> Result<I, Undefined> {
        let values: T::Values<F> = convert(at::<T, S, R, F>(self.surface, self.u, self.v), R::value);
        finite(self.surface, self.u, self.v, values, T::NEEDS_NORMAL)
    }
}

/// N numbers of a task, from the place `from` on. Those that are not needed for them are not computed.
#[inline(always)]
fn select<T: Task, S: Sweep + Stages<T>, F: Float, const N: usize>(
    surface: &S,
    u: F,
    v: F,
    from: usize,
) -> Result<[F; N], Undefined> {
    run(surface.pinned_variant(), Select { surface, u, v, from, task: PhantomData::<T> })
}

struct Select<'a, T, S, F, const N: usize> {
    surface: &'a S,
    u: F,
    v: F,
    from: usize,
    task: PhantomData<T>,
}

impl<T: Task, S: Sweep + Stages<T>, F: Float, const N: usize> Kernel<F> for Select<'_, T, S, F, N> {
    type Output = Result<[F; N], Undefined>;

    #[inline(always)]
    fn run<R: Rounded<F>>(self) -> Result<[F; N], Undefined> {
        let values = at::<T, S, R, F>(self.surface, self.u, self.v);
        let selected: [F; N] = Part::of(|k| values.get(self.from + k).value());
        finite(self.surface, self.u, self.v, selected, false)
    }
}

struct OffsetPoint<'a, S, F> {
    surface: &'a S,
    r: F,
    u: F,
    v: F,
}

impl<S: Sweep, F: Float> Kernel<F> for OffsetPoint<'_, S, F> {
    type Output = Result<[F; 3], Undefined>;

    #[inline(always)]
    fn run<R: Rounded<F>>(self) -> Result<[F; 3], Undefined> {
        let r = R::new(self.r);
        let point = at::<Point, S, R, F>(self.surface, self.u, self.v);
        let normal = at::<Normal, S, R, F>(self.surface, self.u, self.v);
        let offset: [F; 3] = Part::of(|k| r.mul_add(normal[k], point[k]).value());
        finite(self.surface, self.u, self.v, offset, true)
    }
}

struct OffsetFirstOrder<'a, S, F> {
    surface: &'a S,
    r: F,
    u: F,
    v: F,
}

impl<S: Sweep, F: Float> Kernel<F> for OffsetFirstOrder<'_, S, F> {
    type Output = Result<FirstOrder<F>, Undefined>;

    #[inline(always)]
    fn run<R: Rounded<F>>(self) -> Result<FirstOrder<F>, Undefined> {
        let r = R::new(self.r);
        let local = at::<Local, S, R, F>(self.surface, self.u, self.v);
        // N, N_u and N_v are those numbers from 18, 33 and 36 on.
        let offset: [F; 9] = Part::of(|k| {
            let normal = if k < 3 { 18 + k } else { 30 + k };
            r.mul_add(local[normal], local[k]).value()
        });
        finite(self.surface, self.u, self.v, offset, true)
    }
}

/// What the numbers are, if they are finite, else why they are not.
#[inline(always)]
fn finite<S: Sweep, F: Float, V: Part<F>, I: From<V>>(
    surface: &S,
    u: F,
    v: F,
    values: V,
    needs_normal: bool,
) -> Result<I, Undefined> {
    if is_finite(&values) { Ok(I::from(values)) } else { Err(reason(surface, u, v, needs_normal)) }
}

/// Why something at (u, v) is not finite.
#[cold]
#[inline(never)]
fn reason<S: Sweep, F: Float>(surface: &S, u: F, v: F, needs_normal: bool) -> Undefined {
    if !u.is_finite() || !v.is_finite() {
        return Undefined::Parameter;
    }
    let (coordinates, normal) = run(surface.pinned_variant(), Circumstances { surface, u, v });
    if coordinates[0] == F::default() {
        Undefined::Pole
    } else if needs_normal && is_finite(&coordinates) && !is_finite(&normal) {
        Undefined::Singular
    } else {
        Undefined::Overflow
    }
}

/// The homogeneous coordinates, the weight first, with those of the point; and the normal.
struct Circumstances<'a, S, F> {
    surface: &'a S,
    u: F,
    v: F,
}

impl<S: Sweep, F: Float> Kernel<F> for Circumstances<'_, S, F> {
    type Output = ([F; 7], [F; 3]);

    #[inline(always)]
    fn run<R: Rounded<F>>(self) -> ([F; 7], [F; 3]) {
        let homogeneous = at::<Homogeneous, S, R, F>(self.surface, self.u, self.v);
        let point = at::<Point, S, R, F>(self.surface, self.u, self.v);
        let normal = at::<Normal, S, R, F>(self.surface, self.u, self.v);
        (
            Part::of(|k| if k < 4 { homogeneous[k].value() } else { point[k - 4].value() }),
            Part::of(|k| normal[k].value()),
        )
    }
}

#[cfg(test)]
mod tests {
    use super::{Patch, Surface};
    use crate::dispatch::Variant;
    use crate::task::Sweep;
    use crate::testing::Cone;
    use crate::undefined::Undefined;

    #[test]
    fn surfaces_work_as_trait_objects() {
        let surfaces: [&dyn Surface; 2] = [&Cone, &Cone.pinned(Variant::Plain)];
        for surface in surfaces {
            assert_eq!(surface.point(0.5, 1.0), Ok([1.0, 2.0, 2.0]));
            let (m, n) = surface.degree();
            assert_eq!(surface.control_net().len() as u32, (m + 1) * (n + 1));
            let mut out = [[0.0; 3]; 2];
            assert_eq!(surface.grid(&[0.0, 0.5], &[1.0], &mut out), Ok(()));
            assert_eq!(out, [[0.0, 1.0, 1.0], [1.0, 2.0, 2.0]]);
            assert_eq!((surface.name(), surface.domain()), (Cone.name(), Cone.domain()));
        }
        assert_eq!(surfaces[1].variant(), Variant::Plain);
        let single: &dyn Surface<f32> = &Cone;
        assert_eq!(single.point(0.5, 1.0), Ok([1.0, 2.0, 2.0]));
        assert_eq!(single.variant(), Variant::native());
    }

    #[test]
    fn what_does_not_exist_has_a_reason() {
        let s = Cone;
        assert_eq!(s.point(1.0, 0.5), Err(Undefined::Pole));
        assert_eq!(s.unit_normal(1.0, 0.0), Err(Undefined::Pole));
        assert_eq!(s.unit_normal(0.5, 0.0), Err(Undefined::Singular));
        assert_eq!(s.local_geometry(0.5, 0.0), Err(Undefined::Singular));
        assert_eq!(s.offset_point(1.0, 0.5, -0.0), Err(Undefined::Singular));
        assert_eq!(s.homogeneous(1.0, 0.5), Ok([0.0, 0.5, 0.25, 0.5]));
        assert_eq!(s.homogeneous(1.0, 1e200), Err(Undefined::Overflow));
        assert_eq!(s.point(0.0, 1e200), Err(Undefined::Overflow));
        for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
            assert_eq!(s.point(bad, 0.5), Err(Undefined::Parameter));
            assert_eq!(s.speed_v(0.5, bad), Err(Undefined::Parameter));
            assert_eq!(s.unit_normal(0.5, bad), Err(Undefined::Parameter));
        }
        for bad in [f64::NAN, f64::INFINITY] {
            assert_eq!(s.offset_point(bad, 0.25, 0.5), Err(Undefined::Parameter));
            assert_eq!(s.offset_first_order(bad, 0.25, 0.5), Err(Undefined::Parameter));
        }
        // What needs no normal is not singular.
        assert_eq!(s.second_order(1.0 - f64::EPSILON, 1e290), Err(Undefined::Overflow));
        // The speed of the curves v = const vanishes at singular points, and is a number there.
        assert_eq!(s.speed_u(0.5, 0.0), Ok(0.0));
    }

    #[test]
    fn numbers_are_the_same_whichever_method_computes_them() {
        for i in 0..100 {
            let (u, v) = (f64::from(i) / 101.0 - 0.3, f64::from(i * i % 101) / 101.0 + 0.001);
            let local = Cone.local_geometry(u, v).unwrap();
            let second = Cone.second_order(u, v).unwrap();
            assert_eq!((local.derivatives, local.normal), (second, Cone.unit_normal(u, v).unwrap()));
            assert_eq!(second.first_order(), Cone.first_order(u, v).unwrap());
            assert_eq!(second.point, Cone.separated_point(u, v).unwrap());
            assert_eq!(second.partial_u, Cone.partial_u(u, v).unwrap());
            assert_eq!(second.partial_v, Cone.partial_v(u, v).unwrap());
            assert_eq!(local.speeds, [Cone.speed_u(u, v).unwrap(), Cone.speed_v(u, v).unwrap()]);
        }
    }

    #[test]
    fn offsets_are_along_the_normal() {
        let (r, u, v) = (0.125, 0.25, 0.75);
        let (local, offset) = (Cone.local_geometry(u, v).unwrap(), Cone.offset_first_order(r, u, v).unwrap());
        let point = Cone.offset_point(r, u, v).unwrap();
        let of = |base: [f64; 3], direction: [f64; 3]| [0, 1, 2].map(|k| base[k] + r * direction[k]);
        let close = |a: [f64; 3], b: [f64; 3]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-14);
        assert!(close(point, of(local.derivatives.point, local.normal)) && close(offset.point, point));
        assert!(close(offset.partial_u, of(local.derivatives.partial_u, local.normal_u)));
        assert!(close(offset.partial_v, of(local.derivatives.partial_v, local.normal_v)));
        // The derivatives of the offset are those that differences have.
        let h = 1e-5;
        let [after, before] = [h, -h].map(|h| Cone.offset_point(r, u, v + h).unwrap());
        let differences = [0, 1, 2].map(|k| (after[k] - before[k]) / (2.0 * h));
        assert!(offset.partial_v.iter().zip(differences).all(|(found, other)| (found - other).abs() < 1e-8));
    }
}
