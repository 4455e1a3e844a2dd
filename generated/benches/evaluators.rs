//! The evaluators of the catalogue, in the build that users have: instructions are chosen at run time unless the build chooses them.
//!
//! `tests/peers` has the same works beside other libraries, generic evaluators and a plain fill of memory.

use std::time::Duration;

use divan::counter::ItemsCount;
use divan::{Bencher, black_box};
use hodograph::catalogue::evolute_sweep::EvoluteSweep;
use hodograph::catalogue::generalized_conical_example_5::GeneralizedConicalExample5;
use hodograph::catalogue::generalized_conical_quadratic::GeneralizedConicalQuadratic;
use hodograph::catalogue::offset_translation_example_3::OffsetTranslationExample3;
use hodograph::catalogue::offset_translation_example_3_negative_square::OffsetTranslationExample3NegativeSquare;
use hodograph::catalogue::offset_translation_example_3_square::OffsetTranslationExample3Square;
use hodograph::catalogue::oriented_involute_example_4::OrientedInvoluteExample4;
use hodograph::catalogue::oriented_translation_example_2::OrientedTranslationExample2;
use hodograph::catalogue::oriented_translation_family::{OrientedTranslationFamily, Parameters};
use hodograph::catalogue::scaled_rotation_example_1::ScaledRotationExample1;
use hodograph::{
    First, FirstOrder, Float, Item, Local, LocalGeometry, Normal, Point, Second, SecondOrder, Separated,
    Stages, Surface, Sweep, Task, Undefined, Variant, ph,
};

fn main() {
    let benchmarks = divan::Divan::default().sample_count(30).max_time(Duration::from_millis(300));
    benchmarks.config_with_args().main();
}

/// Points of a row.
const COLUMNS: usize = 1000;
/// Rows that are evaluated in the cache.
const ROWS: usize = 32;

/// Numbers spread evenly over an interval, without its end.
fn parameters<F: Float>([first, last]: [f64; 2], count: usize) -> Vec<F> {
    (0..count).map(|k| F::of(first + (last - first) * ((k as f64 + 0.5) / count as f64))).collect()
}

/// A task on a grid of 1000 by so many parameters, into memory.
fn stored<T: Task, I: Item<F, T>, F: Float>(
    bencher: Bencher<'_, '_>,
    surface: &(impl Sweep + Stages<T>),
    rows: usize,
) {
    let domain = surface.domain();
    let (us, vs) = (parameters::<F>(domain.u, COLUMNS), parameters::<F>(domain.v, rows));
    let mut out = vec![I::none(); rows * COLUMNS];
    let batch = surface.batch(T::default());
    bencher.counter(ItemsCount::new(out.len())).bench_local(|| batch.grid(&us, &vs, &mut out[..]));
}

/// A task along rows of 1000 parameters, one after the other in the cache.
fn of_rows<T: Task, I: Item<F, T>, F: Float>(bencher: Bencher<'_, '_>, surface: &(impl Sweep + Stages<T>)) {
    let domain = surface.domain();
    let (us, vs) = (parameters::<F>(domain.u, COLUMNS), parameters::<F>(domain.v, ROWS));
    let mut out = vec![I::none(); COLUMNS];
    let rows = surface.batch(T::default()).rows::<COLUMNS, F>(&us).expect("a row has this length");
    bencher.counter(ItemsCount::new(ROWS * COLUMNS)).bench_local(|| {
        for &v in &vs {
            let _ = black_box(rows.row(v, &mut out[..]));
            black_box(&out);
        }
    });
}

/// A task at 1000 independent parameters, in the cache.
fn independent<T: Task, I: Item<F, T>, F: Float>(
    bencher: Bencher<'_, '_>,
    surface: &(impl Sweep + Stages<T>),
) {
    let domain = surface.domain();
    let us = parameters::<F>(domain.u, COLUMNS);
    let mut vs = parameters::<F>(domain.v, COLUMNS);
    vs.reverse();
    let mut out = vec![I::none(); COLUMNS];
    let batch = surface.batch(T::default());
    bencher.counter(ItemsCount::new(COLUMNS)).bench_local(|| {
        let result = batch.points(&us, &vs, &mut out[..]);
        black_box(&out);
        result
    });
}

/// Calls of a method, one for each of 1000 points.
fn called<S: Sweep, I>(
    bencher: Bencher<'_, '_>,
    surface: &S,
    method: impl Fn(&S, f64, f64) -> Result<I, Undefined>,
) {
    let domain = surface.domain();
    let (us, vs) = (parameters::<f64>(domain.u, COLUMNS), parameters::<f64>(domain.v, COLUMNS));
    bencher.counter(ItemsCount::new(COLUMNS)).bench_local(|| {
        for (&u, &v) in us.iter().zip(vs.iter().rev()) {
            let _ = black_box(method(surface, black_box(u), v));
        }
    });
}

/// Every sweep of the catalogue, by single calls and on grids.
mod catalogue {
    use super::*;

    macro_rules! for_all {
        ($($(#[$documentation:meta])* $name:ident, |$bencher:ident, $surface:ident| $bench:expr;)*) => {
            $(
                $(#[$documentation])*
                #[divan::bench(types = [
                    ScaledRotationExample1,
                    OrientedTranslationExample2,
                    OffsetTranslationExample3,
                    OffsetTranslationExample3Square,
                    OffsetTranslationExample3NegativeSquare,
                    OrientedInvoluteExample4,
                    EvoluteSweep,
                    GeneralizedConicalExample5,
                    GeneralizedConicalQuadratic,
                ])]
                fn $name<S: Sweep + Default>($bencher: Bencher<'_, '_>) {
                    let $surface = &S::default();
                    $bench
                }
            )*
        };
    }

    for_all! {
        point_called, |bencher, surface| called(bencher, surface, |surface, u, v| surface.point(u, v));
        normal_called, |bencher, surface| called(bencher, surface, |surface, u, v| surface.unit_normal(u, v));
        local_geometry_called, |bencher, surface| called(bencher, surface, |surface, u, v| surface.local_geometry(u, v));
        points_independent, |bencher, surface| independent::<Point, [f64; 3], f64>(bencher, surface);
        points_of_row, |bencher, surface| of_rows::<Separated, [f64; 3], f64>(bencher, surface);
        normals_of_row, |bencher, surface| of_rows::<Normal, [f64; 3], f64>(bencher, surface);
        local_geometry_of_row, |bencher, surface| of_rows::<Local, Option<LocalGeometry>, f64>(bencher, surface);
    }
}

/// Everything that is evaluated of one sweep, on grids of 1000 by 1000 points or fewer where items are large.
mod oriented_translation {
    use super::*;

    const SURFACE: OrientedTranslationExample2 = OrientedTranslationExample2;

    #[divan::bench]
    fn fill(bencher: Bencher<'_, '_>) {
        let mut out = vec![0.0; 3000 * COLUMNS];
        let items = bencher.counter(ItemsCount::new(1000 * COLUMNS));
        items.bench_local(|| {
            out.fill(black_box(1.5));
            black_box(&out);
        });
    }

    #[divan::bench(types = [f64, f32])]
    fn points<F: Float>(bencher: Bencher<'_, '_>) {
        stored::<Point, [F; 3], F>(bencher, &SURFACE, 1000);
    }

    #[divan::bench(types = [f64, f32])]
    fn separated_points<F: Float>(bencher: Bencher<'_, '_>) {
        stored::<Separated, [F; 3], F>(bencher, &SURFACE, 1000);
    }

    #[divan::bench(args = [Variant::Plain, Variant::Fused])]
    fn points_pinned(bencher: Bencher<'_, '_>, variant: Variant) {
        stored::<Point, [f64; 3], f64>(bencher, &SURFACE.pinned(variant), 1000);
    }

    #[divan::bench]
    fn normals(bencher: Bencher<'_, '_>) {
        stored::<Normal, [f64; 3], f64>(bencher, &SURFACE, 1000);
    }

    #[divan::bench]
    fn first_order(bencher: Bencher<'_, '_>) {
        stored::<First, FirstOrder, f64>(bencher, &SURFACE, 500);
    }

    #[divan::bench]
    fn second_order(bencher: Bencher<'_, '_>) {
        stored::<Second, SecondOrder, f64>(bencher, &SURFACE, 200);
    }

    #[divan::bench]
    fn local_geometry(bencher: Bencher<'_, '_>) {
        stored::<Local, Option<LocalGeometry>, f64>(bencher, &SURFACE, 100);
    }

    #[divan::bench(types = [f64, f32])]
    fn independent_points<F: Float>(bencher: Bencher<'_, '_>) {
        independent::<Point, [F; 3], F>(bencher, &SURFACE);
    }
}

/// The member of a family that is the concrete sweep.
mod family {
    use super::*;

    fn member() -> OrientedTranslationFamily {
        let path = ph::hermite([0.0, 0.0], [0.0, 4.0], [2.0, 2.0], [4.0, 0.0]).expect("data of Example 2");
        OrientedTranslationFamily::new(Parameters { s: path }).expect("a regular path")
    }

    #[divan::bench]
    fn point_called(bencher: Bencher<'_, '_>) {
        called(bencher, &member(), |surface, u, v| surface.point(u, v));
    }

    #[divan::bench]
    fn points_of_row(bencher: Bencher<'_, '_>) {
        of_rows::<Separated, [f64; 3], f64>(bencher, &member());
    }

    #[divan::bench]
    fn independent_points(bencher: Bencher<'_, '_>) {
        independent::<Point, [f64; 3], f64>(bencher, &member());
    }
}
