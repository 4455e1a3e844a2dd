//! Surfaces of several pieces, one after the other in v.
//!
//! A sweep through frames is a spline: between two frames it has a formula of its own, which is expanded as a surface of its own.
//! [`Piecewise`] makes one surface of all of them, and evaluates at each v the piece that this v belongs to.

use core::fmt;
use core::marker::PhantomData;

use crate::batch::{Batch, BatchError, Failures, Grid, Points, check_length};
use crate::bounds::Bounds;
use crate::dispatch::{Variant, run, run_wide};
use crate::output::Output;
use crate::real::{Float, Real};
use crate::surface::{Domain, Patch, Surface};
use crate::task::{Normal, Point, Staged, Stages, Sweep, Task};
use crate::undefined::Undefined;
use crate::values::{FirstOrder, LocalGeometry, SecondOrder};

/// The pieces of a surface, as they are generated.
pub trait Pieces: Copy + Default + fmt::Debug + PartialEq + Send + Sync + 'static {
    /// The name of the sweep.
    const NAME: &'static str;
    /// The largest degrees of all pieces in u and in v.
    const DEGREE: (u32, u32);
    /// The rectangle of parameters of all pieces together.
    const DOMAIN: Domain;
    /// The joints: where one piece ends and the next one begins, ascending; one less than there are pieces. Of a joint that is no
    /// float it is the next larger one.
    const JOINTS: &'static [f64];
    /// The bounds that hold on all pieces.
    const BOUNDS: Option<&'static Bounds>;
    /// An upper bound for the length of the jump at a joint, from rounding alone: the largest difference of the points that two
    /// neighbors compute there, in `f64` plain and fused, then in `f32` plain and fused; infinite where nothing is proved.
    const JUMPS: [f64; 4];

    /// Hands the piece of this number over to a visitor; of a number that is too large, the last piece.
    fn visit<V: Visitor>(piece: usize, visitor: V) -> V::Output;
}

/// What is done with a piece, whichever it is.
pub trait Visitor {
    /// The result.
    type Output;

    /// Does it.
    fn visit<S: Sweep + Copy>(self, piece: S) -> Self::Output;
}

/// A surface of several pieces, which meet at joints v = const.
///
/// The piece between two joints is evaluated from the first one on, and without the second one, which belongs to the next
/// piece; before the first and after the last joint, outside of the domain too, it is the first and the last piece. A result has
/// the bits that the piece by itself gives.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Piecewise<P> {
    variant: Option<Variant>,
    pieces: PhantomData<P>,
}

impl<P: Pieces> Piecewise<P> {
    /// The surface.
    pub const NEW: Self = Self { variant: None, pieces: PhantomData };
    /// The name of the sweep.
    pub const NAME: &'static str = P::NAME;
    /// The largest degrees of all pieces in u and in v.
    pub const DEGREE: (u32, u32) = P::DEGREE;
    /// The parameters over which the surface is stated.
    pub const DOMAIN: Domain = P::DOMAIN;
    /// Where one piece ends and the next one begins, ascending; see [`Pieces::JOINTS`].
    pub const JOINTS: &'static [f64] = P::JOINTS;
    /// How many pieces there are.
    pub const COUNT: usize = P::JOINTS.len() + 1;

    /// The number of the piece, from 0 on, that is evaluated at v.
    #[inline]
    #[must_use]
    pub fn piece_at<F: Float>(&self, v: F) -> usize {
        let v = v.to_f64();
        P::JOINTS.partition_point(|&joint| joint <= v)
    }

    /// Hands the piece of this number over to a visitor, in the variant of the surface; of a number that is too large, the last
    /// piece.
    #[inline]
    pub fn visit<V: Visitor>(&self, piece: usize, visitor: V) -> V::Output {
        P::visit(piece, InVariant { variant: self.variant, visitor })
    }

    /// An upper bound for the length of the jump of points at a joint, which the exact surface does not have.
    #[must_use]
    pub fn jump<F: Float>(&self, variant: Variant) -> f64 {
        P::JUMPS[crate::bounds::place::<F>(variant)]
    }

    /// The same surface, always evaluated in one variant.
    #[must_use]
    pub fn pinned(self, variant: Variant) -> Self {
        Self { variant: Some(variant), ..self }
    }

    /// A task of the surface, to be evaluated at many points.
    #[inline]
    #[must_use]
    pub fn batch<T: Task>(&self, _: T) -> PiecewiseBatch<P, T> {
        PiecewiseBatch { surface: *self, task: PhantomData }
    }
}

/// A piece in the variant of the whole.
#[derive(Clone, Copy)]
pub(crate) struct Within<S> {
    pub(crate) piece: S,
    variant: Option<Variant>,
}

impl<S: Sweep> Sweep for Within<S> {
    #[inline(always)]
    fn pinned_variant(&self) -> Option<Variant> {
        self.variant
    }
}

crate::task::forward! {
    Within<S>, |within| within.piece;
}

struct InVariant<V> {
    variant: Option<Variant>,
    visitor: V,
}

impl<V: Visitor> Visitor for InVariant<V> {
    type Output = V::Output;

    #[inline(always)]
    fn visit<S: Sweep + Copy>(self, piece: S) -> V::Output {
        self.visitor.visit(Within { piece, variant: self.variant })
    }
}

impl<P: Pieces> Patch for Piecewise<P> {
    fn name(&self) -> &str {
        P::NAME
    }

    fn degree(&self) -> (u32, u32) {
        P::DEGREE
    }

    fn domain(&self) -> Domain {
        P::DOMAIN
    }

    /// None: each piece has its own.
    fn control_net(&self) -> &[[f64; 4]] {
        &[]
    }

    fn bounds(&self) -> Option<&Bounds> {
        P::BOUNDS
    }
}

macro_rules! of_the_piece {
    ($($method:ident($($argument:ident),*) -> $result:ty;)*) => {
        $(
            #[inline]
            fn $method(&self, $($argument: F,)* u: F, v: F) -> Result<$result, Undefined> {
                struct Call<F> {
                    $($argument: F,)*
                    u: F,
                    v: F,
                }
                impl<F: Float> Visitor for Call<F> {
                    type Output = Result<$result, Undefined>;

                    #[inline(always)]
                    fn visit<S: Sweep + Copy>(self, piece: S) -> Self::Output {
                        Surface::<F>::$method(&piece, $(self.$argument,)* self.u, self.v)
                    }
                }
                self.visit(self.piece_at(v), Call { $($argument,)* u, v })
            }
        )*
    };
}

impl<P: Pieces, F: Float> Surface<F> for Piecewise<P> {
    #[inline]
    fn variant(&self) -> Variant {
        self.variant.unwrap_or_else(Variant::native)
    }

    of_the_piece! {
        homogeneous() -> [F; 4];
        point() -> [F; 3];
        separated_point() -> [F; 3];
        partial_u() -> [F; 3];
        partial_v() -> [F; 3];
        first_order() -> FirstOrder<F>;
        second_order() -> SecondOrder<F>;
        unit_normal() -> [F; 3];
        local_geometry() -> LocalGeometry<F>;
        speed_u() -> F;
        speed_v() -> F;
        offset_point(r) -> [F; 3];
        offset_first_order(r) -> FirstOrder<F>;
    }

    fn grid(&self, us: &[F], vs: &[F], out: &mut [[F; 3]]) -> Result<(), BatchError> {
        self.batch(Point).grid(us, vs, out).map(|_| ())
    }

    fn normal_grid(&self, us: &[F], vs: &[F], out: &mut [[F; 3]]) -> Result<usize, BatchError> {
        self.batch(Normal).grid(us, vs, out)
    }

    fn points(&self, us: &[F], vs: &[F], out: &mut [[F; 3]]) -> Result<(), BatchError> {
        self.batch(Point).points(us, vs, out).map(|_| ())
    }
}

/// A task of a surface of several pieces, to be evaluated at many points.
///
/// Parameters v that follow one another and belong to one piece are evaluated together. Everything has the bits of single
/// evaluations, and nothing is allocated.
#[derive(Clone, Copy, Debug)]
pub struct PiecewiseBatch<P, T> {
    surface: Piecewise<P>,
    task: PhantomData<T>,
}

impl<P: Pieces, T: Task> PiecewiseBatch<P, T> {
    /// Evaluates at every (u, v) of a grid as [`Batch::grid`] does. It is fastest where the parameters v are sorted.
    ///
    /// # Errors
    /// As for [`Batch::grid`].
    pub fn grid<F: Float>(&self, us: &[F], vs: &[F], out: impl Output<F, T>) -> Result<usize, BatchError> {
        self.on_grid(us, vs, out, |piece, us, vs, out| self.staged(piece, OnGrid { us, vs, out }))
    }

    /// Evaluates a grid, rows of one piece at a time.
    pub(crate) fn on_grid<F: Float, O: Output<F, T>>(
        &self,
        us: &[F],
        vs: &[F],
        mut out: O,
        evaluate: impl Fn(usize, &[F], &[F], O) -> Failures,
    ) -> Result<usize, BatchError> {
        out.check(us.len().checked_mul(vs.len()).ok_or(BatchError::TooLarge)?)?;
        let mut all = Failures::default();
        let mut done = 0;
        while let Some(run) = self.run_of(&vs[done..]) {
            let (part, rest) = out.split(us.len() * run.length);
            let failures = evaluate(run.piece, us, &vs[done..done + run.length], part);
            all.add_all(failures, us.len() * done);
            out = rest;
            done += run.length;
        }
        all.result::<T>()
    }

    /// Evaluates at every (`us[i]`, `vs[i]`) as [`Batch::points`] does. It is fastest where many neighbors belong to one piece.
    ///
    /// # Errors
    /// As for [`Batch::points`].
    pub fn points<F: Float>(
        &self,
        us: &[F],
        vs: &[F],
        mut out: impl Output<F, T>,
    ) -> Result<usize, BatchError> {
        check_length(us.len(), vs.len())?;
        out.check(us.len())?;
        let mut all = Failures::default();
        let mut done = 0;
        while let Some(run) = self.run_of(&vs[done..]) {
            let (part, rest) = out.split(run.length);
            let (us, vs) = (&us[done..done + run.length], &vs[done..done + run.length]);
            let failures = self.staged(run.piece, AtPoints { us, vs, out: part });
            all.add_all(failures, done);
            out = rest;
            done += run.length;
        }
        all.result::<T>()
    }

    /// The parameters at the beginning that belong to one piece; `None` if there are no parameters.
    fn run_of<F: Float>(&self, vs: &[F]) -> Option<Run> {
        let (first, others) = vs.split_first()?;
        let piece = self.surface.piece_at(*first);
        let length = 1 + others.iter().take_while(|&&v| self.surface.piece_at(v) == piece).count();
        Some(Run { piece, length })
    }

    /// Hands a piece over, with the stages of the task.
    #[inline]
    pub(crate) fn staged<V: Staged<T>>(&self, piece: usize, visitor: V) -> V::Output {
        self.surface.visit(piece, WithStages { visitor, task: PhantomData })
    }
}

/// Parameters that belong to one piece.
struct Run {
    piece: usize,
    length: usize,
}

struct WithStages<V, T> {
    visitor: V,
    task: PhantomData<T>,
}

impl<T: Task, V: Staged<T>> Visitor for WithStages<V, T> {
    type Output = V::Output;

    #[inline(always)]
    fn visit<S: Sweep + Copy>(self, piece: S) -> V::Output {
        T::staged(&piece, self.visitor)
    }
}

struct OnGrid<'a, F, O> {
    us: &'a [F],
    vs: &'a [F],
    out: O,
}

impl<F: Float, T: Task, O: Output<F, T>> Staged<T> for OnGrid<'_, F, O> {
    type Output = Failures;

    #[inline(always)]
    fn visit<S: Sweep + Stages<T>>(mut self, piece: &S) -> Failures {
        let batch = Batch::with(piece, piece.pinned_variant());
        run(batch.variant, Grid { batch, us: self.us, vs: self.vs, out: &mut self.out })
    }
}

struct AtPoints<'a, F, O> {
    us: &'a [F],
    vs: &'a [F],
    out: O,
}

impl<F: Float, T: Task, O: Output<F, T>> Staged<T> for AtPoints<'_, F, O> {
    type Output = Failures;

    #[inline(always)]
    fn visit<S: Sweep + Stages<T>>(mut self, piece: &S) -> Failures {
        let batch = Batch::with(piece, piece.pinned_variant());
        run_wide(batch.variant, Points { batch, us: self.us, vs: self.vs, out: &mut self.out })
    }
}

#[cfg(test)]
mod tests {
    use std::vec::Vec;

    use super::{Pieces, Piecewise, Visitor};
    use crate::batch::BatchError;
    use crate::bounds::Bounds;
    use crate::dispatch::Variant;
    use crate::surface::{Domain, Patch, Surface};
    use crate::task::{First, Normal, Point, Sweep};
    use crate::testing::Cone;
    use crate::undefined::Undefined;

    /// The cone, then the cone in the plain variant, then the cone again.
    #[derive(Clone, Copy, Debug, Default, PartialEq)]
    struct Cones;

    impl Pieces for Cones {
        const NAME: &'static str = "cones";
        const DEGREE: (u32, u32) = (1, 2);
        const DOMAIN: Domain = Domain { u: [0.0, 0.5], v: [0.0, 3.0] };
        const JOINTS: &'static [f64] = &[1.0, 2.0];
        const BOUNDS: Option<&'static Bounds> = None;
        const JUMPS: [f64; 4] = [0.0, 1.0, 2.0, 3.0];

        fn visit<V: Visitor>(piece: usize, visitor: V) -> V::Output {
            match piece {
                0 => visitor.visit(Cone),
                1 => visitor.visit(Shifted),
                _ => visitor.visit(Cone),
            }
        }
    }

    /// The cone with another u, so that it shows which piece is evaluated.
    #[derive(Clone, Copy)]
    struct Shifted;

    mod shifted {
        use super::Shifted;
        use crate::real::Real;
        use crate::surface::{Domain, Patch};
        use crate::task::{Stages, Sweep, Task};
        use crate::testing::Cone;

        impl Patch for Shifted {
            fn name(&self) -> &str {
                "shifted"
            }
            fn degree(&self) -> (u32, u32) {
                (1, 2)
            }
            fn domain(&self) -> Domain {
                Cone.domain()
            }
            fn control_net(&self) -> &[[f64; 4]] {
                &[]
            }
        }

        impl Sweep for Shifted {}

        impl<T: Task> Stages<T> for Shifted
        where
            Cone: Stages<T>,
        {
            type OfU<R: Copy + Default> = <Cone as Stages<T>>::OfU<R>;
            type OfV<R: Copy + Default> = <Cone as Stages<T>>::OfV<R>;

            fn of_u<R: Real>(&self, u: R) -> Self::OfU<R> {
                <Cone as Stages<T>>::of_u(&Cone, u + R::of(0.25))
            }
            fn of_v<R: Real>(&self, v: R) -> Self::OfV<R> {
                <Cone as Stages<T>>::of_v(&Cone, v)
            }
            fn join<R: Real>(&self, of_u: Self::OfU<R>, of_v: Self::OfV<R>) -> T::Values<R> {
                <Cone as Stages<T>>::join(&Cone, of_u, of_v)
            }
        }
    }

    const CONES: Piecewise<Cones> = Piecewise::NEW;

    #[test]
    fn each_v_has_the_piece_that_begins_at_or_before_it() {
        let pieces = [-1.0, 0.0, 0.999, 1.0, 1.5, 2.0, 5.0, f64::NAN].map(|v| CONES.piece_at(v));
        assert_eq!(pieces, [0, 0, 0, 1, 1, 2, 2, 0]);
        assert_eq!(CONES.piece_at(1.0_f32), 1);
        assert_eq!(Piecewise::<Cones>::COUNT, 3);
        for v in [0.5, 1.0, 1.5, 2.0, 2.5] {
            let expected = if (1.0..2.0).contains(&v) { Cone.point(0.5, v) } else { Cone.point(0.25, v) };
            assert_eq!(CONES.point(0.25, v), expected);
            assert_eq!(CONES.pinned(Variant::Plain).point(0.25, v), {
                let u = if (1.0..2.0).contains(&v) { 0.5 } else { 0.25 };
                Cone.pinned(Variant::Plain).point(u, v)
            });
        }
        assert_eq!(CONES.point(0.75, 1.5), Err(Undefined::Pole));
        assert_eq!(CONES.point(0.5, f64::NAN), Err(Undefined::Parameter));
        assert_eq!((CONES.name(), CONES.degree(), CONES.control_net().len()), ("cones", (1, 2), 0));
        assert_eq!([CONES.jump::<f64>(Variant::Fused), CONES.jump::<f32>(Variant::Plain)], [1.0, 2.0]);
    }

    #[test]
    fn batches_have_the_bits_of_single_points() {
        let us: Vec<f64> = (0..70).map(|i| f64::from(i) / 101.0).collect();
        let vs: Vec<f64> = (0..80).map(|j| f64::from(j * 37 % 80) / 26.0).collect();
        let mut grid = std::vec![[0.0; 3]; us.len() * vs.len()];
        for variant in [Variant::Plain, Variant::Fused] {
            let surface = CONES.pinned(variant);
            assert_eq!(surface.batch(Point).grid(&us, &vs, &mut grid[..]), Ok(0));
            for (j, &v) in vs.iter().enumerate() {
                for (i, &u) in us.iter().enumerate() {
                    assert_eq!(Ok(grid[j * us.len() + i]), surface.point(u, v));
                }
            }
            let (mut points, us) =
                (std::vec![[0.0; 3]; vs.len()], &vs.iter().map(|v| v / 9.0).collect::<Vec<_>>());
            surface.points(us, &vs, &mut points).unwrap();
            assert!(points.iter().zip(us).zip(&vs).all(|((p, &u), &v)| Ok(*p) == surface.point(u, v)));
            let mut first = std::vec![[0.0; 9].into(); vs.len()];
            assert_eq!(surface.batch(First).points(us, &vs, &mut first[..]), Ok(0));
            assert!(first.iter().zip(us).zip(&vs).all(|((p, &u), &v)| Ok(*p) == surface.first_order(u, v)));
        }
    }

    #[test]
    fn points_without_a_value_are_counted_over_all_pieces() {
        // Poles are at u = 1, and at u = 3/4 on the second piece; normals are missing at v = 0.
        let (us, vs) = ([0.5, 0.75, 1.0], [0.5, 1.5, 2.5]);
        let mut grid = [[0.0; 3]; 9];
        let expected = Err(BatchError::Undefined { count: 3, first: 2 });
        assert_eq!(CONES.grid(&us, &vs, &mut grid), expected.map(|_: ()| ()));
        assert_eq!(
            CONES.batch(Point).grid(&us[..2], &vs, &mut grid[..6]),
            Err(BatchError::Undefined { count: 1, first: 3 })
        );
        assert_eq!(CONES.batch(Normal).grid(&us[..1], &[0.0, 1.5, 0.0], &mut grid[..3]), Ok(2));
        assert_eq!((grid[0], grid[2]), ([0.0; 3], [0.0; 3]));
        assert_eq!(CONES.grid(&us, &vs, &mut grid[1..]), Err(BatchError::Length { expected: 9, found: 8 }));
        assert_eq!(CONES.points(&us, &vs[1..], &mut grid), Err(BatchError::Length { expected: 3, found: 2 }));
        assert_eq!(CONES.batch(Point).grid::<f64>(&us, &[], &mut [][..] as &mut [[f64; 3]]), Ok(0));
    }
}
