//! Grids on several threads.

use crate::batch::{Batch, BatchError, Failures, Grid};
use crate::dispatch::run;
use crate::output::Output;
use crate::pieces::{Pieces, PiecewiseBatch};
use crate::real::Float;
use crate::task::{Staged, Stages, Sweep, Task};

/// Points below which a grid is not divided further: some tens of microseconds of work.
const POINTS: usize = 1 << 14;

impl<S: Stages<T> + Sync, T: Task> Batch<'_, S, T> {
    /// Evaluates at every (u, v) of a grid as [`grid`](Batch::grid) does, to the bit, with rows divided among the threads of
    /// Rayon's current pool.
    ///
    /// # Errors
    /// As for [`grid`](Batch::grid).
    pub fn parallel_grid<F: Float>(
        &self,
        us: &[F],
        vs: &[F],
        out: impl Output<F, T>,
    ) -> Result<usize, BatchError> {
        out.check(us.len().checked_mul(vs.len()).ok_or(BatchError::TooLarge)?)?;
        divide(*self, us, vs, out).result::<T>()
    }
}

/// Evaluates a grid, on several threads where it is large.
fn divide<S: Stages<T> + Sync, T: Task, F: Float>(
    batch: Batch<'_, S, T>,
    us: &[F],
    vs: &[F],
    mut out: impl Output<F, T>,
) -> Failures {
    if vs.len() < 2 || us.len() * vs.len() <= POINTS {
        return run(batch.variant, Grid { batch, us, vs, out: &mut out });
    }
    let (first, second) = vs.split_at(vs.len() / 2);
    let middle = us.len() * first.len();
    let (before, after) = out.split(middle);
    let (mut failures, others) =
        rayon::join(|| divide(batch, us, first, before), || divide(batch, us, second, after));
    failures.add_all(others, middle);
    failures
}

impl<P: Pieces, T: Task> PiecewiseBatch<P, T> {
    /// Evaluates at every (u, v) of a grid as [`grid`](PiecewiseBatch::grid) does, to the bit, with rows divided among the threads of
    /// Rayon's current pool.
    ///
    /// # Errors
    /// As for [`grid`](PiecewiseBatch::grid).
    pub fn parallel_grid<F: Float>(
        &self,
        us: &[F],
        vs: &[F],
        out: impl Output<F, T>,
    ) -> Result<usize, BatchError> {
        self.on_grid(us, vs, out, |piece, us, vs, out| self.staged(piece, OnThreads { us, vs, out }))
    }
}

struct OnThreads<'a, F, O> {
    us: &'a [F],
    vs: &'a [F],
    out: O,
}

impl<F: Float, T: Task, O: Output<F, T>> Staged<T> for OnThreads<'_, F, O> {
    type Output = Failures;

    #[inline(always)]
    fn visit<S: Sweep + Stages<T>>(self, piece: &S) -> Failures {
        divide(Batch::with(piece, piece.pinned_variant()), self.us, self.vs, self.out)
    }
}

#[cfg(test)]
mod tests {
    use crate::batch::BatchError;
    use crate::task::{Normal, Point, Sweep};
    use crate::testing::Cone;

    #[test]
    fn grids_are_those_of_one_thread() {
        let us: std::vec::Vec<f64> = (0..301).map(|i| f64::from(i) / 200.0).collect();
        let vs: std::vec::Vec<f64> = (0..500).map(|j| f64::from(j - 250) / 100.0).collect();
        let mut one = std::vec![[0.0; 3]; us.len() * vs.len()];
        let mut many = one.clone();
        let expected = Cone.batch(Point).grid(&us, &vs, &mut one[..]);
        // Poles are at u = 1, the place 200 of each row.
        assert_eq!(expected, Err(BatchError::Undefined { count: vs.len(), first: 200 }));
        assert_eq!(Cone.batch(Point).parallel_grid(&us, &vs, &mut many[..]), expected);
        assert_eq!(one, many);
        let [mut x, mut y, mut z] = [0; 3].map(|_| std::vec![0.0; us.len() * vs.len()]);
        let expected = Cone.batch(Normal).grid(&us, &vs, &mut one[..]);
        assert_eq!(Cone.batch(Normal).parallel_grid(&us, &vs, [&mut x[..], &mut y, &mut z]), expected);
        assert!(one.iter().zip(&x).zip(&y).zip(&z).all(|(((n, &x), &y), &z)| *n == [x, y, z]));
        assert!(Cone.batch(Point).parallel_grid(&us, &vs, &mut one[1..]).is_err());
        assert_eq!(Cone.batch(Point).parallel_grid::<f32>(&[], &[], &mut [][..] as &mut [[f32; 3]]), Ok(0));
    }
}
