//! Batches have the bits of single evaluations, in every task, precision and variant.

use std::fmt::Debug;

use hodograph::catalogue::{
    evolute_sweep, generalized_conical_example_5, generalized_conical_quadratic,
    offset_translation_example_3, offset_translation_example_3_negative_square,
    offset_translation_example_3_square, oriented_involute_example_4, oriented_translation_example_2,
    oriented_translation_family, scaled_rotation_example_1,
};
use hodograph::{
    BatchError, First, FirstOrder, Float, Homogeneous, Item, Local, LocalGeometry, Normal, Pinned, Point,
    Second, SecondOrder, Separated, Stages, Surface, Sweep, Task, Undefined, Variant,
};
use hodograph_tests::random::SplitMix64;

/// Columns and rows of grids, of which the one has more columns than are computed at a time, the other more rows.
const GRIDS: [(usize, usize); 2] = [(COLUMNS, 4), (7, 35)];
const COLUMNS: usize = 260;

/// One result, as numbers.
type Single<const N: usize> = Result<[f64; N], Undefined>;

/// The numbers of items of a batch; `None` for those that stand for no result.
trait Numbers<F, const N: usize> {
    fn numbers(&self) -> Option<[F; N]>;
}

impl<F: Float, const N: usize> Numbers<F, N> for [F; N] {
    fn numbers(&self) -> Option<[F; N]> {
        self.iter().all(|x| x.is_finite()).then_some(*self)
    }
}

impl<F: Float> Numbers<F, 9> for FirstOrder<F> {
    fn numbers(&self) -> Option<[F; 9]> {
        FirstOrder::numbers(self).numbers()
    }
}

impl<F: Float> Numbers<F, 18> for SecondOrder<F> {
    fn numbers(&self) -> Option<[F; 18]> {
        SecondOrder::numbers(self).numbers()
    }
}

impl<F: Float> Numbers<F, 39> for Option<LocalGeometry<F>> {
    fn numbers(&self) -> Option<[F; 39]> {
        self.as_ref().map(LocalGeometry::numbers)
    }
}

fn widened<F: Float, const N: usize>(numbers: [F; N]) -> [u64; N] {
    numbers.map(|x| x.to_f64().to_bits())
}

/// The parameters of rows and columns, and single results for all of them.
struct Places<F> {
    us: Vec<F>,
    vs: Vec<F>,
}

impl<F: Float> Places<F> {
    fn new(surface: &impl Sweep, (columns, rows): (usize, usize)) -> Places<F> {
        let mut random = SplitMix64::new(7);
        let domain = surface.domain();
        let mut list = |count: usize, at: &dyn Fn(f64) -> f64| -> Vec<F> {
            (0..count).map(|_| F::of(at(random.next_f64()))).collect()
        };
        let mut us = list(columns, &|t| domain.at(t, 0.0).0);
        let mut vs = list(rows, &|t| domain.at(0.0, t).1);
        // Corners, where some surfaces are singular, and what is no place.
        (us[2], us[columns - 2], us[columns / 2]) = (F::of(domain.u[0]), F::of(domain.u[1]), F::NAN);
        vs[0] = F::of(domain.v[0]);
        if rows > 4 {
            (vs[rows - 2], vs[rows / 2]) = (F::of(domain.v[1]), F::INFINITY);
        }
        Places { us, vs }
    }
}

/// Compares the ways of a batch with single evaluations.
fn check<S, T, F, I, const N: usize>(
    surface: &S,
    task: T,
    places: &Places<F>,
    none: I,
    single: impl Fn(F, F) -> Result<[F; N], Undefined>,
) where
    S: Sweep + Stages<T>,
    T: Task<Values<F> = [F; N]> + Debug,
    F: Float,
    I: Item<F, T> + Numbers<F, N> + PartialEq + Debug,
{
    let Places { us, vs } = places;
    let name = format!("{task:?} of {} in {:?}", surface.name(), surface.pinned_variant());
    let expected: Vec<Single<N>> = vs
        .iter()
        .flat_map(|&v| us.iter().map(move |&u| (u, v)))
        .map(|(u, v)| single(u, v).map(|numbers| numbers.map(Float::to_f64)))
        .collect();
    let outcome = |expected: &[Single<N>]| -> Result<usize, BatchError> {
        let count = expected.iter().filter(|single| single.is_err()).count();
        match expected.iter().position(Result::is_err) {
            Some(first) if !T::NEEDS_NORMAL => Err(BatchError::Undefined { count, first }),
            _ => Ok(count),
        }
    };
    let compare = |items: &[I], expected: &[Single<N>], way: &str| {
        assert_eq!(items.len(), expected.len());
        for (place, (item, single)) in items.iter().zip(expected).enumerate() {
            match single {
                Ok(numbers) => {
                    let found = item.numbers().map(widened);
                    assert_eq!(found, Some(numbers.map(f64::to_bits)), "{name}, {way}, place {place}");
                }
                Err(_) => assert_eq!(item, &none, "{name}, {way}, place {place}"),
            }
        }
    };
    let batch = surface.batch(task);

    let mut items = vec![none; us.len() * vs.len()];
    assert_eq!(batch.grid(us, vs, items.as_mut_slice()), outcome(&expected), "{name}");
    compare(&items, &expected, "grid");

    let mut numbers = vec![F::NAN; N * us.len() * vs.len()];
    let mut slices = numbers.chunks_mut(us.len() * vs.len());
    let slices: [&mut [F]; N] = std::array::from_fn(|_| slices.next().unwrap());
    assert_eq!(batch.grid(us, vs, slices), outcome(&expected), "{name}");
    let missing = if T::NEEDS_NORMAL { F::default() } else { F::INFINITY };
    for (place, single) in expected.iter().enumerate() {
        let found: [F; N] = std::array::from_fn(|k| numbers[k * us.len() * vs.len() + place]);
        let wanted = single.unwrap_or([missing.to_f64(); N]).map(f64::to_bits);
        assert_eq!(widened(found), wanted, "{name}, slices, place {place}");
    }

    for (&v, row) in vs.iter().zip(expected.chunks(us.len())) {
        let mut items = vec![none; us.len()];
        let all = vec![v; us.len()];
        assert_eq!(batch.points(us, &all, items.as_mut_slice()), outcome(row), "{name}");
        compare(&items, row, "points");
    }

    let rows = batch.rows::<COLUMNS, F>(us).unwrap();
    assert_eq!((rows.len(), rows.is_empty()), (us.len(), false));
    for (&v, row) in vs.iter().zip(expected.chunks(us.len())) {
        let mut items = vec![none; us.len()];
        assert_eq!(rows.row(v, items.as_mut_slice()), outcome(row), "{name}");
        compare(&items, row, "rows");
    }

    // Wrong lengths are refused before anything is written.
    let mut short = vec![none; 3];
    let wrong = Err(BatchError::Length { expected: 4, found: 3 });
    assert_eq!(batch.grid(&us[..2], &vs[..2], short.as_mut_slice()), wrong, "{name}");
    assert_eq!(batch.points(&us[..4], &vs[..4], short.as_mut_slice()), wrong, "{name}");
    assert_eq!(short, vec![none; 3], "{name}");
    assert!(batch.rows::<2, F>(us).is_err(), "{name}");
}

/// All tasks of a surface in one precision.
fn check_tasks<S: Sweep, F: Float>(surface: &Pinned<S>)
where
    Pinned<S>: Surface<F>,
{
    for grid in GRIDS {
        check_grid(surface, &Places::new(surface, grid));
    }
}

fn check_grid<S: Sweep, F: Float>(s: &Pinned<S>, places: &Places<F>)
where
    Pinned<S>: Surface<F>,
{
    let infinite = F::INFINITY;
    check(s, Homogeneous, places, [infinite; 4], |u, v| s.homogeneous(u, v));
    check(s, Point, places, [infinite; 3], |u, v| s.point(u, v));
    check(s, Separated, places, [infinite; 3], |u, v| s.separated_point(u, v));
    let first = FirstOrder::from([infinite; 9]);
    check(s, First, places, first, |u, v| s.first_order(u, v).map(|first| first.numbers()));
    let second = SecondOrder::from([infinite; 18]);
    check(s, Second, places, second, |u, v| s.second_order(u, v).map(|second| second.numbers()));
    check(s, Normal, places, [F::default(); 3], |u, v| s.unit_normal(u, v));
    check(s, Local, places, None, |u, v| s.local_geometry(u, v).map(|local| local.numbers()));
    check_methods(s, places);
}

/// The methods of `Surface` that have a part of a task, or a batch of their own.
fn check_methods<F: Float>(surface: &dyn Surface<F>, Places { us, vs }: &Places<F>) {
    let places = vs.iter().flat_map(|&v| us.iter().step_by(3).map(move |&u| (u, v)));
    for (u, v) in places {
        if let Ok(first) = surface.first_order(u, v) {
            assert_eq!(surface.partial_u(u, v), Ok(first.partial_u));
            assert_eq!(surface.partial_v(u, v), Ok(first.partial_v));
            assert_eq!(surface.separated_point(u, v), Ok(first.point));
        }
        if let Ok(local) = surface.local_geometry(u, v) {
            assert_eq!(surface.first_order(u, v), Ok(local.derivatives.first_order()));
            assert_eq!(surface.second_order(u, v), Ok(local.derivatives));
            assert_eq!(Ok(local.normal), surface.unit_normal(u, v));
            assert_eq!(surface.speed_u(u, v), Ok(local.speeds[0]));
            assert_eq!(surface.speed_v(u, v), Ok(local.speeds[1]));
        }
    }
    let mut normals = vec![[F::NAN; 3]; us.len() * vs.len()];
    let missing = surface.normal_grid(us, vs, &mut normals).unwrap();
    let mut undefined = 0;
    for (place, normal) in normals.iter().enumerate() {
        let single = surface.unit_normal(us[place % us.len()], vs[place / us.len()]);
        assert_eq!(*normal, single.unwrap_or_default());
        undefined += usize::from(single.is_err());
    }
    assert_eq!(missing, undefined);
    let mut points = vec![[F::NAN; 3]; us.len().min(vs.len())];
    let outcome = surface.points(&us[..points.len()], &vs[..points.len()], &mut points);
    assert_eq!(outcome.is_ok(), points.iter().flatten().all(|x| x.is_finite()));
    for ((&u, &v), point) in us.iter().zip(vs).zip(points) {
        assert_eq!(point, surface.point(u, v).unwrap_or([F::INFINITY; 3]));
    }
}

fn check_surface<S: Sweep + Copy>(surface: S) {
    for variant in [Variant::Plain, Variant::Fused] {
        let pinned = surface.pinned(variant);
        assert_eq!(Surface::<f64>::variant(&pinned), variant);
        check_tasks::<S, f64>(&pinned);
        check_tasks::<S, f32>(&pinned);
    }
    // Without a choice it is the machine's.
    let native = surface.pinned(Variant::native());
    assert_eq!(surface.point(0.3, 0.7), native.point(0.3, 0.7));
    assert_eq!(surface.local_geometry(0.3_f32, 0.7), native.local_geometry(0.3, 0.7));
}

macro_rules! tests {
    ($($module:ident, $surface:ident;)*) => {
        $(
            #[test]
            fn $module() {
                check_surface($module::$surface);
            }
        )*
    };
}

tests! {
    scaled_rotation_example_1, ScaledRotationExample1;
    oriented_translation_example_2, OrientedTranslationExample2;
    offset_translation_example_3, OffsetTranslationExample3;
    offset_translation_example_3_square, OffsetTranslationExample3Square;
    offset_translation_example_3_negative_square, OffsetTranslationExample3NegativeSquare;
    oriented_involute_example_4, OrientedInvoluteExample4;
    evolute_sweep, EvoluteSweep;
    generalized_conical_example_5, GeneralizedConicalExample5;
    generalized_conical_quadratic, GeneralizedConicalQuadratic;
}

#[test]
fn families() {
    use oriented_translation_family::{OrientedTranslationFamily, Parameters};
    let s = [[1.5, 1.25], [0.5, -1.0], [2.0, 0.25]];
    check_surface(OrientedTranslationFamily::new(Parameters { s }).unwrap());
}
