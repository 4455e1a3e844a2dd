//! Hodograph's evaluators beside a plain fill of memory, generic evaluators and other libraries, measured in turns: the tables have
//! the ratios that hold within the run.

mod growth;
mod measure;
mod ours;
mod own;
mod peers;
mod way;

use std::cell::RefCell;

use hodograph::catalogue::oriented_translation_example_2::OrientedTranslationExample2;
use hodograph::{Stages, Sweep, Variant};
use hodograph_peers::{First, Local, Normal, Point, Second};

use crate::measure::{Settings, Work};
use crate::ours::{Coordinates, Evaluated, Items, SeparatedPoint, Store, with_ours};
use crate::peers::{CURVO, FILL, HORNER, Peers, TRUCK};
use crate::way::{COLUMNS, Parameters, Way};

/// The ratios to other alternatives that are asked for.
type Wanted<'a> = &'a [(&'a str, f64)];

fn main() -> Result<(), String> {
    let settings = Settings::from_arguments()?;
    let surface = OrientedTranslationExample2;
    let peers = Peers::new(&surface);
    points(&settings, &surface, &peers)?;
    beside_peers::<Normal, _, 3>(
        &settings,
        "Unit normals",
        &surface,
        &peers,
        1000,
        &[(Way::StoredGrid, &[(FILL, 0.8)]), (Way::Rows, &[]), (Way::Points, &[]), (Way::Calls, &[])],
    )?;
    // Fewer rows where more is stored of a point, so that the memory is about as large.
    let of_horner: Wanted<'_> = &[(HORNER, 4.0)];
    beside_peers::<First, _, 9>(
        &settings,
        "Points with both derivatives",
        &surface,
        &peers,
        200,
        &[(Way::StoredGrid, of_horner), (Way::Rows, of_horner), (Way::Calls, &[])],
    )?;
    let ways: &[(Way, Wanted<'_>)] = &[(Way::StoredGrid, &[]), (Way::Rows, &[]), (Way::Calls, &[])];
    beside_peers::<Second, _, 18>(&settings, "Points with second derivatives", &surface, &peers, 100, ways)?;
    beside_peers::<Local, _, 39>(&settings, "Forms and curvatures", &surface, &peers, 50, ways)?;
    growth::growth(&settings)?;
    growth::growth_through_frames(&settings)?;
    own::precisions(&settings)?;
    own::threads(&settings)?;
    own::families(&settings)
}

/// Points in all ways, in both forms and both layouts.
fn points(settings: &Settings, surface: &OrientedTranslationExample2, peers: &Peers) -> Result<(), String> {
    let parameters = Parameters::new(1000);
    let out = store::<Point, Items<[f64; 3]>, 3>(&parameters);
    let coordinates = store::<Point, Coordinates<f64>, 3>(&parameters);
    let plain = surface.pinned(Variant::Plain);
    for (way, wanted) in [
        (Way::StoredGrid, &[(FILL, 0.9)][..]),
        (Way::Rows, &[(FILL, 2.5)]),
        (Way::StoredPoints, &[(FILL, 0.6)]),
        (Way::Points, &[(FILL, 1.0)]),
        (Way::Calls, &[(HORNER, 2.0), (CURVO, 8.0), (TRUCK, 8.0)]),
    ] {
        let reference = peers.reference::<Point, _, 3>(way, &parameters);
        let work = Work::new(&way.title("Points"));
        let grid = matches!(way, Way::StoredGrid | Way::Rows);
        let name = "hodograph, separated form";
        let separated = |work| {
            with_ours::<SeparatedPoint, _, _, _, 3>(work, name, surface, way, &parameters, &out, reference)
        };
        let work = if grid { separated(work) } else { work };
        let work =
            with_ours::<Point, _, _, _, 3>(work, "hodograph", surface, way, &parameters, &out, reference);
        let work = if grid { work } else { separated(work) };
        let name = "hodograph, rounded after each operation";
        let work = with_ours::<Point, _, _, _, 3>(work, name, &plain, way, &parameters, &out, reference);
        let name = "hodograph, coordinates in slices";
        let work = if way == Way::Calls {
            work
        } else {
            with_ours::<Point, _, _, _, 3>(work, name, surface, way, &parameters, &coordinates, reference)
        };
        let work = peers.with_all::<Point, 3>(work, way, &parameters, &out);
        let work = if grid { peers.with_regular_points(work) } else { work };
        wanted.iter().fold(work, |work, (name, ratio)| work.wanted(name, *ratio)).measure(settings)?;
    }
    Ok(())
}

/// A quantity beside all peers, in several ways.
fn beside_peers<Q: Evaluated<L>, S: Sweep + Stages<Q::Task>, const L: usize>(
    settings: &Settings,
    quantity: &str,
    surface: &S,
    peers: &Peers,
    rows: usize,
    ways: &[(Way, Wanted<'_>)],
) -> Result<(), String> {
    let parameters = Parameters::new(rows);
    let out = store::<Q, Items<Q::Item<f64>>, L>(&parameters);
    for &(way, wanted) in ways {
        let reference = peers.reference::<Q, _, L>(way, &parameters);
        let work = Work::new(&way.title(quantity));
        let work = with_ours::<Q, _, _, _, L>(work, "hodograph", surface, way, &parameters, &out, reference);
        let work = peers.with_all::<Q, L>(work, way, &parameters, &out);
        wanted.iter().fold(work, |work, (name, ratio)| work.wanted(name, *ratio)).measure(settings)?;
    }
    Ok(())
}

/// A place for the results at all points.
fn store<Q: Evaluated<L>, O: Store<Q, f64, L>, const L: usize>(parameters: &Parameters<f64>) -> RefCell<O> {
    RefCell::new(O::new(parameters.vs.len() * COLUMNS))
}
