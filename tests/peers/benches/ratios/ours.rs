//! Hodograph's functions for each quantity that the peers compute.

use std::cell::RefCell;
use std::ops::Range;

use hodograph::{FirstOrder, Float, Item, LocalGeometry, Output, SecondOrder, Stages, Surface, Sweep, Task};
use hodograph_peers::{First, Local, Normal, Number, Partials, Point, Quantity, Second};

use crate::measure::Work;
use crate::way::{COLUMNS, Parameters, Way};

/// A quantity as Hodograph's evaluators compute it.
pub(crate) trait Evaluated<const L: usize>: Quantity<L> {
    /// The task that computes it.
    type Task: Task;
    /// The result of the task at a point.
    type Item<F: Float>: Item<F, Self::Task>;

    /// A single result; no alternative is timed at points that have none.
    fn single<F: Float, S: Sweep>(surface: &S, u: F, v: F) -> Self::Item<F>;

    /// The result with these numbers.
    fn item(numbers: [f64; L]) -> Self::Item<f64>;

    /// The numbers of a result.
    fn numbers<F: Float>(item: &Self::Item<F>) -> [f64; L];
}

/// The point in the form for grids.
#[derive(Clone, Copy, Debug)]
pub(crate) struct SeparatedPoint;

impl Quantity<3> for SeparatedPoint {
    const ORDER: usize = 0;
    #[inline(always)]
    fn of<N: Number>(partials: &Partials<N>) -> [N; 3] {
        Point::of(partials)
    }
}

macro_rules! vectors {
    ($($quantity:ident: $task:ident, $method:ident;)*) => {
        $(
            impl Evaluated<3> for $quantity {
                type Task = hodograph::$task;
                type Item<F: Float> = [F; 3];

                #[inline(always)]
                fn single<F: Float, S: Sweep>(surface: &S, u: F, v: F) -> [F; 3] {
                    surface.$method(u, v).unwrap_or([F::NAN; 3])
                }
                #[inline(always)]
                fn item(numbers: [f64; 3]) -> [f64; 3] {
                    numbers
                }
                fn numbers<F: Float>(item: &[F; 3]) -> [f64; 3] {
                    item.map(F::to_f64)
                }
            }
        )*
    };
}

vectors! {
    Point: Point, point;
    SeparatedPoint: Separated, separated_point;
    Normal: Normal, unit_normal;
}

impl Evaluated<9> for First {
    type Task = hodograph::First;
    type Item<F: Float> = FirstOrder<F>;

    #[inline(always)]
    fn single<F: Float, S: Sweep>(surface: &S, u: F, v: F) -> FirstOrder<F> {
        surface.first_order(u, v).unwrap_or([F::NAN; 9].into())
    }
    #[inline(always)]
    fn item(numbers: [f64; 9]) -> FirstOrder {
        numbers.into()
    }
    fn numbers<F: Float>(item: &FirstOrder<F>) -> [f64; 9] {
        item.numbers().map(F::to_f64)
    }
}

impl Evaluated<18> for Second {
    type Task = hodograph::Second;
    type Item<F: Float> = SecondOrder<F>;

    #[inline(always)]
    fn single<F: Float, S: Sweep>(surface: &S, u: F, v: F) -> SecondOrder<F> {
        surface.second_order(u, v).unwrap_or([F::NAN; 18].into())
    }
    #[inline(always)]
    fn item(numbers: [f64; 18]) -> SecondOrder {
        numbers.into()
    }
    fn numbers<F: Float>(item: &SecondOrder<F>) -> [f64; 18] {
        item.numbers().map(F::to_f64)
    }
}

impl Evaluated<39> for Local {
    type Task = hodograph::Local;
    type Item<F: Float> = Option<LocalGeometry<F>>;

    #[inline(always)]
    fn single<F: Float, S: Sweep>(surface: &S, u: F, v: F) -> Option<LocalGeometry<F>> {
        surface.local_geometry(u, v).ok()
    }
    #[inline(always)]
    fn item(numbers: [f64; 39]) -> Option<LocalGeometry> {
        Some(numbers.into())
    }
    fn numbers<F: Float>(item: &Option<LocalGeometry<F>>) -> [f64; 39] {
        item.map_or([f64::NAN; 39], |local| local.numbers().map(F::to_f64))
    }
}

/// Where the results of all points of a quantity are kept.
pub(crate) trait Store<Q: Evaluated<L>, F: Float, const L: usize> {
    /// A store of so many results.
    fn new(count: usize) -> Self;

    /// Consecutive places, as batches write to them.
    fn places(&mut self, places: Range<usize>) -> impl Output<F, Q::Task>;

    /// Computes a single result for a place.
    fn single<S: Sweep>(&mut self, place: usize, surface: &S, u: F, v: F);

    /// The numbers of the result at a place.
    fn numbers(&self, place: usize) -> [f64; L];
}

/// The results one after the other.
pub(crate) struct Items<I>(pub(crate) Vec<I>);

impl<Q: Evaluated<L>, F: Float, const L: usize> Store<Q, F, L> for Items<Q::Item<F>> {
    fn new(count: usize) -> Self {
        Self(vec![Q::Item::<F>::none(); count])
    }
    fn places(&mut self, places: Range<usize>) -> impl Output<F, Q::Task> {
        &mut self.0[places]
    }
    #[inline(always)]
    fn single<S: Sweep>(&mut self, place: usize, surface: &S, u: F, v: F) {
        call::<Q, F, S, L>(surface, u, v, &mut self.0[place]);
    }
    fn numbers(&self, place: usize) -> [f64; L] {
        Q::numbers(&self.0[place])
    }
}

/// Vectors in a slice for each coordinate.
pub(crate) struct Coordinates<F>([Vec<F>; 3]);

impl<Q, F: Float> Store<Q, F, 3> for Coordinates<F>
where
    Q: Evaluated<3, Item<F> = [F; 3]>,
    for<'a> [&'a mut [F]; 3]: Output<F, Q::Task>,
{
    fn new(count: usize) -> Self {
        Self([(); 3].map(|()| vec![F::default(); count]))
    }
    fn places(&mut self, places: Range<usize>) -> impl Output<F, Q::Task> {
        self.0.each_mut().map(|slice| &mut slice[places.clone()])
    }
    fn single<S: Sweep>(&mut self, place: usize, surface: &S, u: F, v: F) {
        for (slice, number) in self.0.iter_mut().zip(Q::single(surface, u, v)) {
            slice[place] = number;
        }
    }
    fn numbers(&self, place: usize) -> [f64; 3] {
        self.0.each_ref().map(|slice| slice[place].to_f64())
    }
}

/// Adds a surface's own functions for a quantity to a work.
pub(crate) fn with_ours<'a, Q, F, S, O, const L: usize>(
    work: Work<'a, L>,
    name: &str,
    surface: &'a S,
    way: Way,
    parameters: &'a Parameters<F>,
    out: &'a RefCell<O>,
    reference: impl Fn(usize) -> [f64; L] + 'a,
) -> Work<'a, L>
where
    Q: Evaluated<L>,
    F: Float,
    S: Sweep + Stages<Q::Task>,
    O: Store<Q, F, L>,
{
    let Parameters { us, vs, scattered_us, scattered_vs } = parameters;
    // Calls take longer than batches.
    let count = if way == Way::Calls { vs.len().min(50) } else { vs.len() };
    let all = count * COLUMNS;
    work.with(name, all, reference, move |sink| {
        let out = &mut *out.borrow_mut();
        let batch = surface.batch(Q::Task::default());
        let mut rows = |of_row: &mut dyn FnMut(usize, &mut O)| {
            for j in 0..count {
                of_row(j, out);
                sink(j * COLUMNS, COLUMNS, &|k| out.numbers(k));
            }
        };
        let row = 0..COLUMNS;
        match way {
            Way::StoredGrid => {
                batch.grid(us, vs, out.places(0..all)).expect("the grid has points everywhere");
                sink(0, all, &|k| out.numbers(k));
            }
            Way::StoredPoints => {
                batch.points(scattered_us, scattered_vs, out.places(0..all)).expect("all points exist");
                sink(0, all, &|k| out.numbers(k));
            }
            Way::Rows => {
                let prepared = batch.rows::<COLUMNS, F>(us).expect("a row has this length");
                rows(&mut |j, out| {
                    prepared.row(vs[j], out.places(row.clone())).expect("the row has points everywhere");
                });
            }
            Way::Points => rows(&mut |j, out| {
                let (us, vs) = (&scattered_us[..COLUMNS], &scattered_vs[j..j + COLUMNS]);
                batch.points(us, vs, out.places(row.clone())).expect("all points exist");
            }),
            Way::Calls => rows(&mut |j, out| {
                for (i, (&u, &v)) in scattered_us[..COLUMNS].iter().zip(&scattered_vs[j..]).enumerate() {
                    out.single(i, surface, u, v);
                }
            }),
        }
    })
}

/// A single result by a call that is not inlined, as most are; it writes to the result's place.
#[inline(never)]
fn call<Q: Evaluated<L>, F: Float, S: Sweep, const L: usize>(surface: &S, u: F, v: F, out: &mut Q::Item<F>) {
    *out = Q::single(surface, u, v);
}
