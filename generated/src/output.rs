//! Where batches write: slices of items, or a slice for each component.

use crate::batch::{BatchError, Values, check_length, is_finite, sum};
use crate::machine::points;
use crate::real::{Float, Rounded};
use crate::task::{First, Homogeneous, Local, Normal, Part, Point, Second, Separated, Stages, Task};
use crate::values::{FirstOrder, LocalGeometry, SecondOrder};

/// The results of a task at many points: `&mut [I]` with an [`Item`], or `[&mut [F]; N]` with a slice for each of its numbers.
pub trait Output<F: Float, T: Task>: Send {
    /// Consecutive places of the output.
    type Window<'a>: Window<F, T>
    where
        Self: 'a;

    /// Checks that there are places for this number of points, no more and no less.
    ///
    /// # Errors
    /// [`BatchError::Length`].
    fn check(&self, expected: usize) -> Result<(), BatchError>;

    /// The places before `middle`, and those from there on.
    fn split(self, middle: usize) -> (Self, Self)
    where
        Self: Sized;

    /// The places from `start` to `start + length`.
    fn window(&mut self, start: usize, length: usize) -> Self::Window<'_>;
}

/// Consecutive places of an output.
pub trait Window<F: Float, T: Task> {
    /// Writes the first `length` values. The result is zero only if all numbers are finite.
    fn fill(&mut self, length: usize, values: &impl Values<F, T>) -> F::Bits;

    /// Writes the first values, those at (`us[i]`, `vs[i]`), as far as the machine has a faster way than [`fill`](Window::fill).
    /// Returns how many, and what is `true` only if all numbers are finite.
    #[inline(always)]
    fn fill_points<S: Stages<T>, R: Rounded<F>>(&mut self, _: &S, _: &[F], _: &[F]) -> (usize, bool) {
        (0, true)
    }

    /// Replaces a result that is not finite by what stands for one that does not exist, and tells whether there was one.
    fn replace(&mut self, i: usize) -> bool;
}

/// The result of a task at a point.
pub trait Item<F: Float, T: Task>: Copy + Send {
    /// The result of its numbers, which are finite, by their places in the task.
    fn of(number: impl Fn(usize) -> F) -> Self;

    /// Evaluates the first points as [`Window::fill_points`] does.
    #[inline(always)]
    fn points<S: Stages<T>, R: Rounded<F>>(_: &S, _: &[F], _: &[F], _: &mut [Self]) -> (usize, bool) {
        (0, true)
    }

    /// What stands for a result that does not exist.
    fn none() -> Self;

    /// Whether all numbers are finite.
    fn is_finite(&self) -> bool;
}

macro_rules! items {
    ($($task:ident => $item:ty, |$number:ident| $of:expr, $none:expr, |$item_:ident| $finite:expr $(, $points:ident)?;)*) => {
        $(
            impl<F: Float> Item<F, $task> for $item {
                #[inline(always)]
                fn of($number: impl Fn(usize) -> F) -> Self {
                    $of
                }

                #[inline(always)]
                fn none() -> Self {
                    $none
                }

                fn is_finite(&self) -> bool {
                    let $item_ = self;
                    $finite
                }

                $(#[inline(always)]
                fn points<S: Stages<$task>, R: Rounded<F>>(
                    surface: &S,
                    us: &[F],
                    vs: &[F],
                    out: &mut [Self],
                ) -> (usize, bool) {
                    $points::<$task, F, S, R>(surface, us, vs, out)
                })?
            }
        )*
    };
}

items! {
    Homogeneous => [F; 4], |number| [number(0), number(1), number(2), number(3)], [F::INFINITY; 4], |item| is_finite(item);
    Point => [F; 3], |number| [number(0), number(1), number(2)], [F::INFINITY; 3], |item| is_finite(item), points;
    Separated => [F; 3], |number| [number(0), number(1), number(2)], [F::INFINITY; 3], |item| is_finite(item), points;
    First => FirstOrder<F>, |number| FirstOrder::of(number), [F::INFINITY; 9].into(), |item| is_finite(&item.numbers());
    Second => SecondOrder<F>, |number| SecondOrder::of(number), [F::INFINITY; 18].into(), |item| is_finite(&item.numbers());
    Normal => [F; 3], |number| [number(0), number(1), number(2)], [F::default(); 3], |item| is_finite(item);
    Local => Option<LocalGeometry<F>>, |number| Some(LocalGeometry::of(number)), None, |item| item.is_some_and(|item| is_finite(&item.numbers()));
}

/// Points of which many components are computed at a time, before they are written item by item.
const BUFFER: usize = 32;

impl<F: Float, T: Task, I: Item<F, T>> Output<F, T> for &mut [I] {
    type Window<'a>
        = &'a mut [I]
    where
        Self: 'a;

    #[inline(always)]
    fn check(&self, expected: usize) -> Result<(), BatchError> {
        check_length(expected, self.len())
    }

    fn split(self, middle: usize) -> (Self, Self) {
        self.split_at_mut(middle)
    }

    #[inline(always)]
    fn window(&mut self, start: usize, length: usize) -> &mut [I] {
        &mut self[start..start + length]
    }
}

impl<F: Float, T: Task, I: Item<F, T>> Window<F, T> for &mut [I] {
    #[inline(always)]
    fn fill(&mut self, length: usize, values: &impl Values<F, T>) -> F::Bits {
        let mut defect = F::Bits::default();
        let items = &mut self[..length];
        if <T::Values<F> as Part<F>>::LENGTH <= 4 {
            for (i, item) in items.iter_mut().enumerate() {
                let values = values.at(i);
                defect = defect | sum(&values).defect();
                *item = I::of(|k| values.get(k));
            }
        } else {
            let mut buffer = <T::Values<F> as Part<F>>::strip::<BUFFER>();
            for (k, items) in items.chunks_mut(BUFFER).enumerate() {
                let length = items.len().min(BUFFER);
                for i in 0..length {
                    let values = values.at(k * BUFFER + i);
                    defect = defect | sum(&values).defect();
                    values.store(&mut buffer, i);
                }
                for (i, item) in items.iter_mut().enumerate() {
                    // The place is hidden from compilers: they would scatter the components of many items, which is slower.
                    let i = core::hint::black_box(i) % BUFFER;
                    *item = I::of(|k| <T::Values<F> as Part<F>>::load_number(&buffer, k, i));
                }
            }
        }
        defect
    }

    #[inline(always)]
    fn fill_points<S: Stages<T>, R: Rounded<F>>(&mut self, surface: &S, us: &[F], vs: &[F]) -> (usize, bool) {
        I::points::<S, R>(surface, us, vs, self)
    }

    #[inline(always)]
    fn replace(&mut self, i: usize) -> bool {
        let bad = !self[i].is_finite();
        if bad {
            self[i] = I::none();
        }
        bad
    }
}

impl<F: Float, T: Task<Values<F> = [F; N]>, const N: usize> Output<F, T> for [&mut [F]; N] {
    type Window<'a>
        = [&'a mut [F]; N]
    where
        Self: 'a;

    #[inline(always)]
    fn check(&self, expected: usize) -> Result<(), BatchError> {
        self.iter().try_for_each(|slice| check_length(expected, slice.len()))
    }

    fn split(self, middle: usize) -> (Self, Self) {
        let mut rest: [&mut [F]; N] = core::array::from_fn(|_| Default::default());
        let mut rests = rest.iter_mut();
        let first = self.map(|slice| {
            let (first, second) = slice.split_at_mut(middle);
            if let Some(rest) = rests.next() {
                *rest = second;
            }
            first
        });
        (first, rest)
    }

    #[inline(always)]
    fn window(&mut self, start: usize, length: usize) -> [&mut [F]; N] {
        self.each_mut().map(|slice| &mut slice[start..start + length])
    }
}

impl<F: Float, T: Task<Values<F> = [F; N]>, const N: usize> Window<F, T> for [&mut [F]; N] {
    #[inline(always)]
    fn fill(&mut self, length: usize, values: &impl Values<F, T>) -> F::Bits {
        let mut defect = F::Bits::default();
        let columns = self.each_mut().map(|slice| &mut slice[..length]);
        #[allow(clippy::needless_range_loop)]
        for i in 0..length {
            let values = values.at(i);
            defect = defect | sum(&values).defect();
            for k in 0..N {
                columns[k][i] = values[k];
            }
        }
        defect
    }

    #[inline(always)]
    fn replace(&mut self, i: usize) -> bool {
        let bad = self.iter().any(|slice| !slice[i].is_finite());
        if bad {
            let number = if T::NEEDS_NORMAL { F::default() } else { F::INFINITY };
            for slice in self {
                slice[i] = number;
            }
        }
        bad
    }
}
