//! Hodograph's evaluators beside each other: precisions, threads and families.

use std::cell::RefCell;

use hodograph::catalogue::oriented_translation_example_2::OrientedTranslationExample2;
use hodograph::catalogue::oriented_translation_family::{
    OrientedTranslationFamily, Parameters as Coefficients,
};
use hodograph::{Stages, Sweep, ph};
use hodograph_peers::Point;

use crate::measure::{Settings, Work};
use crate::ours::{Evaluated, Items, SeparatedPoint, Store, with_ours};
use crate::peers::Peers;
use crate::way::{COLUMNS, Parameters, Way};

const ROWS: usize = 1000;
const SURFACE: OrientedTranslationExample2 = OrientedTranslationExample2;

/// Both precisions.
pub(crate) fn precisions(settings: &Settings) -> Result<(), String> {
    for way in [Way::StoredGrid, Way::Rows] {
        both_precisions::<SeparatedPoint>(settings, way)?;
    }
    for way in [Way::StoredPoints, Way::Points, Way::Calls] {
        both_precisions::<Point>(settings, way)?;
    }
    Ok(())
}

fn both_precisions<Q: Evaluated<3>>(settings: &Settings, way: Way) -> Result<(), String>
where
    OrientedTranslationExample2: Stages<Q::Task>,
{
    let peers = Peers::new(&SURFACE);
    let (doubles, singles) = (Parameters::<f64>::new(ROWS), Parameters::<f32>::new(ROWS));
    let in_doubles = RefCell::new(<Items<Q::Item<f64>> as Store<Q, f64, 3>>::new(ROWS * COLUMNS));
    let in_singles = RefCell::new(<Items<Q::Item<f32>> as Store<Q, f32, 3>>::new(ROWS * COLUMNS));
    let of_doubles = peers.reference::<Q, _, 3>(way, &doubles);
    let of_singles = peers.reference::<Q, _, 3>(way, &singles);
    let work = Work::new(&way.title("Precision: points"));
    let work = with_ours::<Q, _, _, _, 3>(work, "f32", &SURFACE, way, &singles, &in_singles, of_singles);
    let work = work.within(1e-5);
    let work = with_ours::<Q, _, _, _, 3>(work, "f64", &SURFACE, way, &doubles, &in_doubles, of_doubles);
    let work = if way == Way::Calls { work } else { work.wanted("f64", 1.8) };
    work.measure(settings)
}

/// All threads and one.
pub(crate) fn threads(settings: &Settings) -> Result<(), String> {
    let peers = Peers::new(&SURFACE);
    let parameters = Parameters::new(ROWS);
    let way = Way::StoredGrid;
    let reference = peers.reference::<SeparatedPoint, _, 3>(way, &parameters);
    let out = RefCell::new(Items(vec![[0.0; 3]; ROWS * COLUMNS]));
    let name = format!("{} threads", rayon::current_num_threads());
    let work = Work::new(&way.title("Threads: points"));
    let work = work.with(&name, ROWS * COLUMNS, reference, |sink| {
        let out = &mut out.borrow_mut().0[..];
        let batch = SURFACE.batch(hodograph::Separated);
        let result = batch.parallel_grid(&parameters.us, &parameters.vs, &mut *out);
        result.expect("the grid has points everywhere");
        sink(0, out.len(), &|k| out[k]);
    });
    let name = "one thread";
    with_ours::<SeparatedPoint, _, _, _, 3>(work, name, &SURFACE, way, &parameters, &out, reference)
        .measure(settings)
}

/// The member of a family that is the concrete sweep.
pub(crate) fn families(settings: &Settings) -> Result<(), String> {
    let path =
        ph::hermite([0.0, 0.0], [0.0, 4.0], [2.0, 2.0], [4.0, 0.0]).map_err(|error| error.to_string())?;
    let member =
        OrientedTranslationFamily::new(Coefficients { s: path }).map_err(|error| error.to_string())?;
    for way in [Way::StoredGrid, Way::Rows] {
        member_and_sweep::<SeparatedPoint>(settings, way, &member)?;
    }
    for way in [Way::Points, Way::Calls] {
        member_and_sweep::<Point>(settings, way, &member)?;
    }
    Ok(())
}

fn member_and_sweep<Q: Evaluated<3>>(
    settings: &Settings,
    way: Way,
    member: &OrientedTranslationFamily,
) -> Result<(), String>
where
    OrientedTranslationExample2: Stages<Q::Task>,
    OrientedTranslationFamily: Stages<Q::Task>,
{
    let peers = Peers::new(&SURFACE);
    let parameters = Parameters::new(ROWS);
    let out = RefCell::new(<Items<Q::Item<f64>> as Store<Q, f64, 3>>::new(ROWS * COLUMNS));
    let reference = peers.reference::<Q, _, 3>(way, &parameters);
    let work = Work::new(&way.title("Family: points"));
    let name = "member of the family";
    let work = with_ours::<Q, _, _, _, 3>(work, name, member, way, &parameters, &out, reference);
    let name = "concrete sweep";
    let work = with_ours::<Q, _, _, _, 3>(work, name, &SURFACE, way, &parameters, &out, reference);
    work.wanted(name, 1.0 / 1.2).measure(settings)
}
