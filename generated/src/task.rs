//! What generated code implements: what is asked of a surface (tasks), and how it is computed (stages).

use crate::batch::Batch;
use crate::dispatch::Variant;
use crate::real::Real;
use crate::surface::Patch;

/// An array of numbers that an evaluator passes from one stage to the next, or returns.
pub trait Part<R: Copy + Default>: Copy {
    /// How many numbers there are.
    const LENGTH: usize;

    /// The parts of N points, number by number, so that vector instructions work on many points at once.
    type Strip<const N: usize>;

    /// A strip of zeros.
    fn strip<const N: usize>() -> Self::Strip<N>;

    /// Puts a part at the place `i` < N of a strip.
    fn store<const N: usize>(self, strip: &mut Self::Strip<N>, i: usize);

    /// The part at the place `i` < N of a strip.
    fn load<const N: usize>(strip: &Self::Strip<N>, i: usize) -> Self;

    /// The number `k` < [`LENGTH`](Part::LENGTH) of the part at the place `i` < N of a strip.
    fn load_number<const N: usize>(strip: &Self::Strip<N>, k: usize, i: usize) -> R;

    /// The part with these numbers.
    fn of(number: impl FnMut(usize) -> R) -> Self;

    /// The number at the place `k` < [`LENGTH`](Part::LENGTH).
    fn get(&self, k: usize) -> R;
}

impl<R: Copy + Default, const M: usize> Part<R> for [R; M] {
    const LENGTH: usize = M;

    type Strip<const N: usize> = [[R; N]; M];

    #[inline(always)]
    fn strip<const N: usize>() -> [[R; N]; M] {
        [[R::default(); N]; M]
    }

    #[inline(always)]
    fn store<const N: usize>(self, strip: &mut [[R; N]; M], i: usize) {
        let mut k = 0;
        while k < M {
            strip[k][i] = self[k];
            k += 1;
        }
    }

    #[inline(always)]
    fn load<const N: usize>(strip: &[[R; N]; M], i: usize) -> Self {
        let mut part = [R::default(); M];
        let mut k = 0;
        while k < M {
            part[k] = strip[k][i];
            k += 1;
        }
        part
    }

    #[inline(always)]
    fn load_number<const N: usize>(strip: &[[R; N]; M], k: usize, i: usize) -> R {
        strip[k][i]
    }

    #[inline(always)]
    fn of(mut number: impl FnMut(usize) -> R) -> Self {
        let mut part = [R::default(); M];
        let mut k = 0;
        while k < M {
            part[k] = number(k);
            k += 1;
        }
        part
    }

    #[inline(always)]
    fn get(&self, k: usize) -> R {
        self[k]
    }
}

/// The part of other numbers, one by one.
#[inline(always)]
pub(crate) fn convert<A: Copy + Default, B: Copy + Default, P: Part<A>, Q: Part<B>>(
    part: P,
    convert: impl Fn(A) -> B,
) -> Q {
    Q::of(|k| convert(part.get(k)))
}

/// What is evaluated at a point in one pass: a list of numbers.
pub trait Task: Copy + Default + Send + Sync + 'static {
    /// The numbers.
    type Values<R: Copy + Default>: Part<R>;

    /// Whether the task has no result where the surface has no normal, as for [`Normal`] and [`Local`].
    const NEEDS_NORMAL: bool;

    /// Hands a sweep over, which has the stages of every task, as a surface with those of this one.
    fn staged<S: Sweep, V: Staged<Self>>(surface: &S, visitor: V) -> V::Output;
}

/// What is done with a surface that has the stages of a task, whichever surface and task they are.
pub trait Staged<T: Task> {
    /// The result.
    type Output;

    /// Does it.
    fn visit<S: Sweep + Stages<T>>(self, surface: &S) -> Self::Output;
}

macro_rules! tasks {
    ($($(#[$documentation:meta])* $name:ident, $length:literal, $normal:literal;)*) => {
        $(
            $(#[$documentation])*
            #[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
            pub struct $name;

            impl Task for $name {
                type Values<R: Copy + Default> = [R; $length];
                const NEEDS_NORMAL: bool = $normal;

                #[inline(always)]
                fn staged<S: Sweep, V: Staged<Self>>(surface: &S, visitor: V) -> V::Output {
                    visitor.visit(surface)
                }
            }
        )*
    };
}

tasks! {
    /// The homogeneous coordinates (W, X, Y, Z).
    Homogeneous, 4, false;
    /// The point in the form with one division, for single points.
    Point, 3, false;
    /// The point in the form with the fewest operations for each point of a grid: quotients are those of u alone and of v alone
    /// as far as they can be.
    Separated, 3, false;
    /// The point in its separated form, R_u and R_v.
    First, 9, false;
    /// The numbers of [`First`], then R_uu, R_uv and R_vv.
    Second, 18, false;
    /// The unit normal.
    Normal, 3, true;
    /// The numbers of [`Second`], then the unit normal N, the coefficients E, F, G of the first and L, M, N of the second
    /// fundamental form, the Gaussian, mean and both principal curvatures, the parametric speeds, N_u and N_v.
    Local, 39, true;
}

/// How the numbers of a task are computed, in three stages: from u alone, from v alone, and from both.
///
/// All three functions are inlined into the loops that call them. A number is the same in all tasks that have it, to the bit.
pub trait Stages<T: Task> {
    /// What is passed on of u.
    type OfU<R: Copy + Default>: Part<R>;
    /// What is passed on of v.
    type OfV<R: Copy + Default>: Part<R>;

    /// What depends on u alone.
    fn of_u<R: Real>(&self, u: R) -> Self::OfU<R>;

    /// What depends on v alone.
    fn of_v<R: Real>(&self, v: R) -> Self::OfV<R>;

    /// The numbers of the task.
    fn join<R: Real>(&self, of_u: Self::OfU<R>, of_v: Self::OfV<R>) -> T::Values<R>;
}

/// A surface with all stages that the runtime needs: what an expansion implements.
///
/// Whoever only uses surfaces needs [`Surface`](crate::Surface), which every sweep is, and [`batch`](Sweep::batch).
pub trait Sweep:
    Patch
    + Stages<Homogeneous>
    + Stages<Point>
    + Stages<Separated>
    + Stages<First>
    + Stages<Second>
    + Stages<Normal>
    + Stages<Local>
    + Sync
{
    /// The variant that it is always evaluated in; `None` for that of the machine, [`Variant::native`].
    #[inline(always)]
    fn pinned_variant(&self) -> Option<Variant> {
        None
    }

    /// A task of the surface, to be evaluated at many points.
    #[inline]
    fn batch<T>(&self, task: T) -> Batch<'_, Self, T>
    where
        Self: Sized,
    {
        Batch::new(self, task)
    }

    /// The same surface, always evaluated in one variant.
    fn pinned(self, variant: Variant) -> Pinned<Self>
    where
        Self: Sized,
    {
        Pinned { surface: self, variant }
    }
}

/// A surface that is always evaluated in one variant, whatever the machine has.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pinned<S> {
    /// The surface.
    pub surface: S,
    /// The variant.
    pub variant: Variant,
}

impl<S: Sweep> Sweep for Pinned<S> {
    #[inline(always)]
    fn pinned_variant(&self) -> Option<Variant> {
        Some(self.variant)
    }
}

impl<S: Sweep> Sweep for &S {
    #[inline(always)]
    fn pinned_variant(&self) -> Option<Variant> {
        (**self).pinned_variant()
    }
}

macro_rules! forward {
    ($($surface:ty, |$self:ident| $inner:expr;)*) => {
        $(
            impl<S: Patch> crate::surface::Patch for $surface {
                fn name(&self) -> &str {
                    let $self = self;
                    $inner.name()
                }
                fn degree(&self) -> (u32, u32) {
                    let $self = self;
                    $inner.degree()
                }
                fn domain(&self) -> crate::surface::Domain {
                    let $self = self;
                    $inner.domain()
                }
                fn control_net(&self) -> &[[f64; 4]] {
                    let $self = self;
                    $inner.control_net()
                }
                fn bounds(&self) -> Option<&crate::bounds::Bounds> {
                    let $self = self;
                    $inner.bounds()
                }
            }

            impl<T: crate::task::Task, S: crate::task::Stages<T>> crate::task::Stages<T> for $surface {
                type OfU<R: Copy + Default> = S::OfU<R>;
                type OfV<R: Copy + Default> = S::OfV<R>;

                #[inline(always)]
                fn of_u<R: Real>(&self, u: R) -> S::OfU<R> {
                    let $self = self;
                    $inner.of_u(u)
                }
                #[inline(always)]
                fn of_v<R: Real>(&self, v: R) -> S::OfV<R> {
                    let $self = self;
                    $inner.of_v(v)
                }
                #[inline(always)]
                fn join<R: Real>(&self, of_u: S::OfU<R>, of_v: S::OfV<R>) -> T::Values<R> {
                    let $self = self;
                    $inner.join(of_u, of_v)
                }
            }
        )*
    };
}

pub(crate) use forward;

forward! {
    Pinned<S>, |pinned| pinned.surface;
    &S, |reference| **reference;
}
