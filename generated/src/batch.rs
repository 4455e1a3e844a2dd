//! Evaluation at many points: on grids, at independent points, and a row at a time.
//!
//! A [`Batch`] evaluates a [task](crate::task::Task) of a surface. Everything has the bits that a single evaluation of the same
//! task and variant has; nothing is allocated.
//!
//! # Points that do not exist
//! Batches never write NaN. Where a surface has a pole, or a result is beyond the range of floats, the item's components are
//! all infinite, and the batch ends with [`BatchError::Undefined`] after everything else has been written. Where the surface
//! merely has no normal, a unit normal is written as the zero vector and [`LocalGeometry`] as `None`, and the batch says how
//! many there are.

use core::fmt;
use core::marker::PhantomData;

use crate::dispatch::{Kernel, Variant, run, run_wide};
use crate::output::{Output, Window};
use crate::real::{Float, Rounded};
use crate::task::{Part, Stages, Sweep, Task, convert};
#[allow(unused_imports)]
use crate::values::LocalGeometry;

/// Why a batch has not been evaluated, or not everywhere.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum BatchError {
    /// A slice has `found` items where `expected` are needed; nothing has been written.
    Length {
        /// Items that are needed.
        expected: usize,
        /// Items that the slice has.
        found: usize,
    },
    /// The batch has more points than a slice, or than the strip of its rows, can hold; nothing has been written.
    TooLarge,
    /// The surface has no value at `count` points, of which `first` is the first in the output; all others have been written.
    Undefined {
        /// How many points there are.
        count: usize,
        /// The place of the first in the output.
        first: usize,
    },
}

impl fmt::Display for BatchError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Length { expected, found } => {
                write!(f, "{expected} items are needed, but a slice has {found}")
            }
            Self::TooLarge => f.write_str("there are more points than can be held"),
            Self::Undefined { count, first } => {
                write!(f, "the surface has no value at {count} points, the first of which is that at {first}")
            }
        }
    }
}

impl core::error::Error for BatchError {}

/// Checks the length of a slice.
pub(crate) fn check_length(expected: usize, found: usize) -> Result<(), BatchError> {
    if expected == found { Ok(()) } else { Err(BatchError::Length { expected, found }) }
}

/// Points of which the stage of u is held at a time: a compromise between the size of the strip, which is on the stack and
/// should stay in the fastest cache, the number of times that the stage of v is computed anew, and the length of what is written
/// to memory without a gap, which is written faster the longer it is. This takes 32 kB at 64 bytes a point.
const STRIP: usize = 512;

/// The same for tasks that need no more than 32 bytes of the stage of u.
const LONG_STRIP: usize = 1024;

/// The same for tasks that need more than 64 bytes of it.
const SHORT_STRIP: usize = 128;

/// Parameters v whose stage is computed at a time.
const BLOCK: usize = 32;

/// A task of a surface, to be evaluated at many points.
#[derive(Debug)]
pub struct Batch<'a, S, T> {
    surface: &'a S,
    pub(crate) variant: Option<Variant>,
    task: PhantomData<T>,
}

impl<S, T: Task> Clone for Batch<'_, S, T> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<S, T: Task> Copy for Batch<'_, S, T> {}

impl<'a, S: Sweep, T> Batch<'a, S, T> {
    /// Evaluates a task of a surface.
    #[inline]
    #[must_use]
    pub fn new(surface: &'a S, _: T) -> Self {
        Self { surface, variant: surface.pinned_variant(), task: PhantomData }
    }
}

impl<'a, S: Stages<T>, T: Task> Batch<'a, S, T> {
    /// A task of a surface in a variant.
    #[inline(always)]
    pub(crate) fn with(surface: &'a S, variant: Option<Variant>) -> Self {
        Self { surface, variant, task: PhantomData }
    }

    /// Evaluates at every (u, v) of a grid: the item of (`us[i]`, `vs[j]`) is that at `j * us.len() + i`, a row for each v.
    ///
    /// What depends on one parameter alone is computed once for many points. Returns the number of points without a normal,
    /// which is 0 for tasks that need none.
    ///
    /// # Errors
    /// [`BatchError`] if the output does not have `us.len() * vs.len()` items, or if the surface has no value at some points.
    #[inline]
    pub fn grid<F: Float>(
        &self,
        us: &[F],
        vs: &[F],
        mut out: impl Output<F, T>,
    ) -> Result<usize, BatchError> {
        out.check(us.len().checked_mul(vs.len()).ok_or(BatchError::TooLarge)?)?;
        run(self.variant, Grid { batch: *self, us, vs, out: &mut out }).result::<T>()
    }

    /// Evaluates at every (`us[i]`, `vs[i]`).
    ///
    /// Returns the number of points without a normal, which is 0 for tasks that need none.
    ///
    /// # Errors
    /// [`BatchError`] if the three slices differ in length, or if the surface has no value at some points.
    #[inline]
    pub fn points<F: Float>(
        &self,
        us: &[F],
        vs: &[F],
        mut out: impl Output<F, T>,
    ) -> Result<usize, BatchError> {
        check_length(us.len(), vs.len())?;
        out.check(us.len())?;
        run_wide(self.variant, Points { batch: *self, us, vs, out: &mut out }).result::<T>()
    }

    /// Prepares rows over `us`, for consumers that want one row of a grid after the other in the fastest cache.
    ///
    /// # Errors
    /// [`BatchError::TooLarge`] if there are more than `N` parameters.
    #[inline]
    pub fn rows<const N: usize, F: Float>(&self, us: &[F]) -> Result<Rows<'a, S, T, F, N>, BatchError> {
        if us.len() > N {
            return Err(BatchError::TooLarge);
        }
        let mut rows = Rows { batch: *self, strip: <OfU<S, T, F> as Part<F>>::strip(), length: us.len() };
        run(self.variant, Prepare { rows: &mut rows, us });
        Ok(rows)
    }
}

/// A task of a surface for up to `N` parameters u, of which all that does not depend on v is computed.
///
/// It holds no more than what the stage of u passes on, and can be on the stack.
pub struct Rows<'a, S: Stages<T>, T: Task, F: Float, const N: usize> {
    batch: Batch<'a, S, T>,
    strip: <OfU<S, T, F> as Part<F>>::Strip<N>,
    length: usize,
}

impl<S: Stages<T>, T: Task, F: Float, const N: usize> Rows<'_, S, T, F, N> {
    /// The number of points in a row.
    #[must_use]
    pub fn len(&self) -> usize {
        self.length
    }

    /// Whether rows have no points.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.length == 0
    }

    /// Evaluates at (`us[i]`, v) for all parameters u.
    ///
    /// Returns the number of points without a normal, which is 0 for tasks that need none.
    ///
    /// # Errors
    /// [`BatchError`] if the output does not have as many items as there are parameters u, or if the surface has no value at
    /// some points.
    #[inline]
    pub fn row(&self, v: F, mut out: impl Output<F, T>) -> Result<usize, BatchError> {
        out.check(self.length)?;
        run_wide(self.batch.variant, Row { rows: self, v, out: &mut out }).result::<T>()
    }
}

/// Points without a value.
#[derive(Clone, Copy, Default)]
pub(crate) struct Failures {
    pub(crate) count: usize,
    pub(crate) first: usize,
}

impl Failures {
    #[inline(always)]
    fn add(&mut self, index: usize) {
        self.first = if self.count == 0 { index } else { self.first.min(index) };
        self.count += 1;
    }

    /// Adds those of a part of the output that begins at the place `start`.
    pub(crate) fn add_all(&mut self, part: Failures, start: usize) {
        if self.count == 0 {
            self.first = start + part.first;
        }
        self.count += part.count;
    }

    #[inline(always)]
    pub(crate) fn result<T: Task>(self) -> Result<usize, BatchError> {
        if T::NEEDS_NORMAL || self.count == 0 {
            Ok(self.count)
        } else {
            Err(BatchError::Undefined { count: self.count, first: self.first })
        }
    }
}

type OfU<S, T, R> = <S as Stages<T>>::OfU<R>;
type OfV<S, T, R> = <S as Stages<T>>::OfV<R>;

pub(crate) struct Grid<'a, S, T, F, O> {
    pub(crate) batch: Batch<'a, S, T>,
    pub(crate) us: &'a [F],
    pub(crate) vs: &'a [F],
    pub(crate) out: &'a mut O,
}

impl<S: Stages<T>, T: Task, F: Float, O: Output<F, T>> Kernel<F> for Grid<'_, S, T, F, O> {
    type Output = Failures;

    #[inline(always)]
    fn run<R: Rounded<F>>(self) -> Failures {
        if const { <OfU<S, T, R> as Part<R>>::LENGTH * size_of::<F>() <= 32 } {
            self.in_strips::<R, LONG_STRIP>()
        } else if const { <OfU<S, T, R> as Part<R>>::LENGTH * size_of::<F>() <= 64 } {
            self.in_strips::<R, STRIP>()
        } else {
            self.in_strips::<R, SHORT_STRIP>()
        }
    }
}

impl<S: Stages<T>, T: Task, F: Float, O: Output<F, T>> Grid<'_, S, T, F, O> {
    #[inline(always)]
    fn in_strips<R: Rounded<F>, const N: usize>(self) -> Failures {
        let surface = self.batch.surface;
        let mut failures = Failures::default();
        let mut strip = <OfU<S, T, R> as Part<R>>::strip::<N>();
        let mut block = <OfV<S, T, R> as Part<R>>::strip::<BLOCK>();
        let columns = self.us.len();
        for (k, us) in self.us.chunks(N).enumerate() {
            stage::<R, F, OfU<S, T, R>, N>(us, &mut strip, |u| surface.of_u(u));
            for (l, vs) in self.vs.chunks(BLOCK).enumerate() {
                stage::<R, F, OfV<S, T, R>, BLOCK>(vs, &mut block, |v| surface.of_v(v));
                for j in 0..vs.len() {
                    let of_v = <OfV<S, T, R> as Part<R>>::load(&block, j);
                    let start = (l * BLOCK + j) * columns + k * N;
                    let window = self.out.window(start, us.len());
                    let joined = Joined::<S, T, R, N> { surface, strip: &strip, of_v };
                    fill(window, us.len().min(N), start, joined, &mut failures);
                }
            }
        }
        failures
    }
}

pub(crate) struct Points<'a, S, T, F, O> {
    pub(crate) batch: Batch<'a, S, T>,
    pub(crate) us: &'a [F],
    pub(crate) vs: &'a [F],
    pub(crate) out: &'a mut O,
}

impl<S: Stages<T>, T: Task, F: Float, O: Output<F, T>> Kernel<F> for Points<'_, S, T, F, O> {
    type Output = Failures;

    #[inline(always)]
    fn run<R: Rounded<F>>(self) -> Failures {
        let surface = self.batch.surface;
        let mut failures = Failures::default();
        for (k, (us, vs)) in self.us.chunks(STRIP).zip(self.vs.chunks(STRIP)).enumerate() {
            let start = k * STRIP;
            let filled = {
                let mut window = self.out.window(start, us.len());
                let (filled, are_finite) = window.fill_points::<S, R>(surface, us, vs);
                if !are_finite {
                    repair(window, filled, start, &mut failures);
                }
                filled
            };
            if filled < us.len() {
                let (us, vs, start) = (&us[filled..], &vs[filled..], start + filled);
                let window = self.out.window(start, us.len());
                let independent =
                    Independent { surface, us, vs: &vs[..us.len()], rounding: PhantomData::<R> };
                fill(window, us.len(), start, independent, &mut failures);
            }
        }
        failures
    }
}

struct Prepare<'a, 'b, S: Stages<T>, T: Task, F: Float, const N: usize> {
    rows: &'a mut Rows<'b, S, T, F, N>,
    us: &'a [F],
}

impl<S: Stages<T>, T: Task, F: Float, const N: usize> Kernel<F> for Prepare<'_, '_, S, T, F, N> {
    type Output = ();

    #[inline(always)]
    fn run<R: Rounded<F>>(self) {
        let surface = self.rows.batch.surface;
        for (i, &u) in self.us.iter().enumerate() {
            let of_u: OfU<S, T, F> = convert(<S as Stages<T>>::of_u(surface, R::new(u)), R::value);
            of_u.store(&mut self.rows.strip, i);
        }
    }
}

struct Row<'a, 'b, S: Stages<T>, T: Task, F: Float, const N: usize, O> {
    rows: &'a Rows<'b, S, T, F, N>,
    v: F,
    out: &'a mut O,
}

impl<S: Stages<T>, T: Task, F: Float, const N: usize, O: Output<F, T>> Kernel<F>
    for Row<'_, '_, S, T, F, N, O>
{
    type Output = Failures;

    #[inline(always)]
    fn run<R: Rounded<F>>(self) -> Failures {
        let mut failures = Failures::default();
        let surface = self.rows.batch.surface;
        let of_v = <S as Stages<T>>::of_v(surface, R::new(self.v));
        let length = self.rows.length;
        let window = self.out.window(0, length);
        let prepared = Prepared::<S, T, R, F, N> { surface, strip: &self.rows.strip, of_v };
        fill(window, length.min(N), 0, prepared, &mut failures);
        failures
    }
}

/// Computes a stage for a list of parameters.
#[inline(always)]
fn stage<R: Rounded<F>, F: Float, P: Part<R>, const N: usize>(
    parameters: &[F],
    strip: &mut P::Strip<N>,
    of: impl Fn(R) -> P,
) {
    for (i, &parameter) in parameters.iter().enumerate().take(N) {
        of(R::new(parameter)).store(strip, i);
    }
}

/// Values of a task by the places where they are written.
pub trait Values<F: Float, T: Task> {
    /// The value at a place.
    fn at(&self, i: usize) -> T::Values<F>;
}

/// Those of a row, of strips of both stages.
struct Joined<'a, S: Stages<T>, T: Task, R: Copy + Default, const N: usize> {
    surface: &'a S,
    strip: &'a <OfU<S, T, R> as Part<R>>::Strip<N>,
    of_v: OfV<S, T, R>,
}

impl<F: Float, S: Stages<T>, T: Task, R: Rounded<F>, const N: usize> Values<F, T> for Joined<'_, S, T, R, N> {
    #[inline(always)]
    fn at(&self, i: usize) -> T::Values<F> {
        let of_u = <OfU<S, T, R> as Part<R>>::load(self.strip, i);
        convert(<S as Stages<T>>::join(self.surface, of_u, self.of_v), R::value)
    }
}

/// Those of a row, of a strip of floats.
struct Prepared<'a, S: Stages<T>, T: Task, R: Copy + Default, F: Float, const N: usize> {
    surface: &'a S,
    strip: &'a <OfU<S, T, F> as Part<F>>::Strip<N>,
    of_v: OfV<S, T, R>,
}

impl<F: Float, S: Stages<T>, T: Task, R: Rounded<F>, const N: usize> Values<F, T>
    for Prepared<'_, S, T, R, F, N>
{
    #[inline(always)]
    fn at(&self, i: usize) -> T::Values<F> {
        let of_u: OfU<S, T, R> = convert(<OfU<S, T, F> as Part<F>>::load(self.strip, i), R::new);
        convert(<S as Stages<T>>::join(self.surface, of_u, self.of_v), R::value)
    }
}

/// Those of independent points.
struct Independent<'a, S, R, F> {
    surface: &'a S,
    us: &'a [F],
    vs: &'a [F],
    rounding: PhantomData<R>,
}

impl<F: Float, S: Stages<T>, T: Task, R: Rounded<F>> Values<F, T> for Independent<'_, S, R, F> {
    #[inline(always)]
    fn at(&self, i: usize) -> T::Values<F> {
        let of_u = <S as Stages<T>>::of_u(self.surface, R::new(self.us[i]));
        let of_v = <S as Stages<T>>::of_v(self.surface, R::new(self.vs[i]));
        convert(<S as Stages<T>>::join(self.surface, of_u, of_v), R::value)
    }
}

/// Writes the values of `length` points, and replaces those that are not finite.
#[inline(always)]
fn fill<F: Float, T: Task, W: Window<F, T>>(
    mut window: W,
    length: usize,
    start: usize,
    values: impl Values<F, T>,
    failures: &mut Failures,
) {
    if window.fill(length, &values) != F::Bits::default() {
        repair(window, length, start, failures);
    }
}

/// Replaces the values that are not finite among those of `length` points.
#[inline(always)]
fn repair<F: Float, T: Task, W: Window<F, T>>(
    mut window: W,
    length: usize,
    start: usize,
    failures: &mut Failures,
) {
    for i in 0..length {
        if window.replace(i) {
            failures.add(start + i);
        }
    }
}

/// Whether all numbers are finite.
#[inline(always)]
pub(crate) fn is_finite<F: Float>(values: &impl Part<F>) -> bool {
    sum(values).is_finite() || all_finite(values)
}

/// The same, where the sum of the numbers may merely be beyond the range of floats.
#[cold]
fn all_finite<F: Float, P: Part<F>>(values: &P) -> bool {
    (0..P::LENGTH).all(|k| values.get(k).is_finite())
}

/// The sum of all numbers, which is finite only if they all are.
#[inline(always)]
pub(crate) fn sum<F: Float, P: Part<F>>(values: &P) -> F {
    // Two chains are as deep as the computations that they follow.
    let (mut even, mut odd) = (F::default(), F::default());
    let mut k = 0;
    while k < P::LENGTH {
        let value = values.get(k);
        if k < 2 {
            if k == 0 { even = value } else { odd = value }
        } else if k % 2 == 0 {
            even = even + value;
        } else {
            odd = odd + value;
        }
        k += 1;
    }
    if P::LENGTH > 1 { even + odd } else { even }
}

#[cfg(test)]
mod tests {
    use std::vec::Vec;

    use super::{BLOCK, Batch, BatchError, LONG_STRIP, STRIP, is_finite};
    use crate::dispatch::Variant;
    use crate::output::Item;
    use crate::real::Float;
    use crate::surface::Surface;
    use crate::task::{First, Homogeneous, Local, Normal, Point, Second, Separated, Stages, Sweep, Task};
    use crate::testing::Cone;
    use crate::undefined::Undefined;

    /// Parameters with the poles' u = 1, the singular points' v = 0 and what is no number among them.
    fn parameters<F: Float>(count: usize, seed: u64) -> Vec<F> {
        let special = [1.0, 0.0, 0.5, f64::NAN, f64::INFINITY, 1e300, -1.0, 1e-200];
        let mut state = seed;
        (0..count)
            .map(|i| {
                state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
                if i % 37 == 5 {
                    F::of(special[(state >> 60) as usize % special.len()])
                } else {
                    F::of((state >> 40) as f64 / f64::from(1 << 24))
                }
            })
            .collect()
    }

    /// Checks all batches of a task against the single evaluations.
    fn check<F: Float, T: Task, I: Item<F, T> + PartialEq + core::fmt::Debug>(
        batch: Batch<'_, impl Stages<T>, T>,
        single: impl Fn(F, F) -> Result<I, Undefined>,
    ) {
        let none = I::none();
        for (m, n) in
            [(0, 0), (0, 3), (3, 0), (1, 1), (STRIP + 1, 2), (5, BLOCK + 1), (LONG_STRIP + 9, 2), (40, 7)]
        {
            let (us, vs) = (parameters::<F>(m, 1), parameters::<F>(n, 2));
            let expected: Vec<I> = vs
                .iter()
                .flat_map(|&v| us.iter().map(move |&u| (u, v)))
                .map(|(u, v)| single(u, v).unwrap_or(none))
                .collect();
            let undefined = |from: usize, to: usize| {
                let places = || (from..to).filter(|&k| single(us[k % m], vs[k / m]).is_err());
                match places().next() {
                    Some(first) if !T::NEEDS_NORMAL => {
                        Err(BatchError::Undefined { count: places().count(), first: first - from })
                    }
                    _ => Ok(places().count()),
                }
            };
            let mut out = std::vec![none; m * n];
            assert_eq!(batch.grid(&us, &vs, &mut out[..]), undefined(0, m * n));
            assert_eq!(out, expected);
            let rows = batch.rows::<{ LONG_STRIP + 9 }, F>(&us).unwrap();
            assert_eq!((rows.len(), rows.is_empty()), (m, m == 0));
            for (j, &v) in vs.iter().enumerate() {
                let row = &mut out[..m];
                assert_eq!(rows.row(v, &mut *row), undefined(j * m, j * m + m));
                assert_eq!(*row, expected[j * m..][..m]);
            }
            let outcome = undefined(0, m * n);
            let us: Vec<F> = (0..m * n).map(|k| us[k % m]).collect();
            let vs: Vec<F> = (0..m * n).map(|k| vs[k / m]).collect();
            out.fill(none);
            assert_eq!(batch.points(&us, &vs, &mut out[..]), outcome);
            assert_eq!(out, expected);
        }
    }

    fn check_all<F: Float>(surface: impl Sweep + Surface<F>)
    where
        [F; 3]: PartialEq,
    {
        let s = &surface;
        check::<F, Homogeneous, [F; 4]>(s.batch(Homogeneous), |u, v| s.homogeneous(u, v));
        check::<F, Point, [F; 3]>(s.batch(Point), |u, v| s.point(u, v));
        check::<F, Separated, [F; 3]>(s.batch(Separated), |u, v| s.separated_point(u, v));
        check::<F, First, _>(s.batch(First), |u, v| s.first_order(u, v));
        check::<F, Second, _>(s.batch(Second), |u, v| s.second_order(u, v));
        check::<F, Normal, [F; 3]>(s.batch(Normal), |u, v| s.unit_normal(u, v));
        check::<F, Local, _>(s.batch(Local), |u, v| s.local_geometry(u, v).map(Some));
    }

    #[test]
    fn batches_have_the_bits_of_single_evaluations() {
        for variant in [Variant::Plain, Variant::Fused] {
            check_all::<f64>(Cone.pinned(variant));
            check_all::<f32>(Cone.pinned(variant));
        }
        check_all::<f64>(Cone);
        check_all::<f32>(Cone);
    }

    #[test]
    fn finite_numbers_may_have_an_infinite_sum() {
        let [large, infinite] = [f64::MAX, f64::INFINITY];
        assert!(
            is_finite(&[large; 3]) && is_finite(&[large, 1.0, -large, large, large]) && is_finite(&[0.0; 9])
        );
        assert!(!is_finite(&[infinite, 1.0, -infinite]) && !is_finite(&[0.0, 0.0, f64::NAN, 0.0]));
    }

    #[test]
    fn slices_of_components_hold_the_same() {
        let (us, vs) = (parameters::<f64>(LONG_STRIP + 9, 3), parameters::<f64>(5, 4));
        let length = us.len() * vs.len();
        let mut items = std::vec![[0.0; 3]; length];
        let [mut x, mut y, mut z] = [0; 3].map(|_| std::vec![0.0; length]);
        let result = Cone.batch(Point).grid(&us, &vs, &mut items[..]);
        assert!(matches!(result, Err(BatchError::Undefined { .. })));
        assert_eq!(Cone.batch(Point).grid(&us, &vs, [&mut x[..], &mut y, &mut z]), result);
        assert!(items.iter().zip(&x).zip(&y).zip(&z).all(|(((p, &x), &y), &z)| *p == [x, y, z]));
        let result = Cone.batch(Normal).grid(&us, &vs, &mut items[..]);
        assert!(matches!(result, Ok(1..)));
        assert_eq!(Cone.batch(Normal).grid(&us, &vs, [&mut x[..], &mut y, &mut z]), result);
        assert!(items.iter().zip(&x).zip(&y).zip(&z).all(|(((p, &x), &y), &z)| *p == [x, y, z]));
    }

    #[test]
    fn nothing_is_written_to_outputs_of_wrong_lengths() {
        let (us, vs) = ([0.25, 0.5], [1.0, 2.0, 3.0]);
        let mut out = [[7.0; 3]; 7];
        let wrong = Err(BatchError::Length { expected: 6, found: 7 });
        assert_eq!(Cone.batch(Point).grid(&us, &vs, &mut out[..]), wrong);
        assert_eq!(Cone.grid(&us, &vs, &mut out), Err(BatchError::Length { expected: 6, found: 7 }));
        assert_eq!(Cone.normal_grid(&us, &vs, &mut out), wrong);
        let (mut x, mut y, mut z) = ([7.0; 6], [7.0; 6], [7.0; 5]);
        let wrong = Cone.batch(Separated).grid(&us, &vs, [&mut x[..], &mut y, &mut z]);
        assert_eq!(wrong, Err(BatchError::Length { expected: 6, found: 5 }));
        assert_eq!(Cone.points(&us, &vs, &mut out), Err(BatchError::Length { expected: 2, found: 3 }));
        let wrong = Cone.points(&us, &vs[..2], &mut out);
        assert_eq!(wrong, Err(BatchError::Length { expected: 2, found: 7 }));
        assert!(Cone.batch(Point).rows::<1, f64>(&us).is_err());
        let rows = Cone.batch(Point).rows::<2, f64>(&us).unwrap();
        assert_eq!(rows.row(1.0, &mut out[..]), Err(BatchError::Length { expected: 2, found: 7 }));
        assert_eq!((out, x, y, z), ([[7.0; 3]; 7], [7.0; 6], [7.0; 6], [7.0; 5]));
    }
}
