//! How the cost of a point grows with the degree of the path.

use std::cell::RefCell;

use hodograph::{Sweep, sweep};
use hodograph_peers::Point;

use crate::measure::{Settings, Work};
use crate::ours::{Items, SeparatedPoint, with_ours};
use crate::peers::Peers;
use crate::way::{COLUMNS, Parameters, Way};

sweep! {
    /// The quarter circle along a PH quintic, in the curve's normal plane.
    sweep along_degree_5 {
        profile p(u) = (1 - u^2)/(1 + u^2)*i + 2*u/(1 + u^2)*k;
        path s(v) = ph([6, 8 + 2*I, 7 + 5*I]);
        surface R = s + p.x*s.normal + p.z*k;
        domain u in 0..1, v in 0..1;
    }
}

sweep! {
    /// The quarter circle along a PH curve of degree 9, in the curve's normal plane.
    sweep along_degree_9 {
        profile p(u) = (1 - u^2)/(1 + u^2)*i + 2*u/(1 + u^2)*k;
        path s(v) = ph([6, 7 + 2*I, 8 + 3*I, 8 + 4*I, 7 + 6*I]);
        surface R = s + p.x*s.normal + p.z*k;
        domain u in 0..1, v in 0..1;
    }
}

sweep! {
    /// The quarter circle along a PH curve of degree 13, in the curve's normal plane.
    sweep along_degree_13 {
        profile p(u) = (1 - u^2)/(1 + u^2)*i + 2*u/(1 + u^2)*k;
        path s(v) = ph([6, 7 + I, 8 + 2*I, 8 + 3*I, 8 + 4*I, 7 + 5*I, 6 + 6*I]);
        surface R = s + p.x*s.normal + p.z*k;
        domain u in 0..1, v in 0..1;
    }
}

sweep! {
    /// A half circle through two frames, by the spline of the quaternions themselves: of degree 9 in v.
    sweep through_frames_directly {
        profile c(u) = (0, 2*u/(1 + u^2), (u^2 - 1)/(1 + u^2));
        frames F(v) = frames([frame((0, 0, 2), (24/25, 0, 0, 7/25), 1), frame((4, 3/2, 3/2), (71/73, 12/73, 0, 12/73), 5/4),
            frame((8, 3/2, 1/2), (71/73, -12/73, 0, -12/73), 3/2)], orientation = direct);
        surface R = F.sweep(c);
        domain u in 0..1;
    }
}

sweep! {
    /// The same through points of the unit sphere: of degree 15 in v.
    sweep through_frames {
        profile c(u) = (0, 2*u/(1 + u^2), (u^2 - 1)/(1 + u^2));
        frames F(v) = frames([frame((0, 0, 2), (24/25, 0, 0, 7/25), 1), frame((4, 3/2, 3/2), (71/73, 12/73, 0, 12/73), 5/4),
            frame((8, 3/2, 1/2), (71/73, -12/73, 0, -12/73), 3/2)]);
        surface R = F.sweep(c);
        domain u in 0..1;
    }
}

/// A sweep through frames in its forms of degree 9 and of degree 15 in v, one piece of each.
pub(crate) fn growth_through_frames(settings: &Settings) -> Result<(), String> {
    let direct = through_frames_directly_1::ThroughFramesDirectly1;
    let exact = through_frames_1::ThroughFrames1;
    let peers = [Peers::new(&direct), Peers::new(&exact)];
    let parameters = Parameters::new(1000);
    let out = RefCell::new(Items(vec![[0.0; 3]; 1000 * COLUMNS]));
    for way in [Way::StoredGrid, Way::Rows] {
        let work = Work::new(&way.title("Growth through frames: points"));
        let work = add(work, "hodograph, degree 15", &exact, &peers[1], way, &parameters, &out);
        let work = add(work, "hodograph, degree 9", &direct, &peers[0], way, &parameters, &out);
        work.wanted("hodograph, degree 9", 0.9).measure(settings)?;
    }
    Ok(())
}

/// Sweeps along paths of degree 5, 9 and 13, whose patches are of degree 9, 17 and 25 in v.
pub(crate) fn growth(settings: &Settings) -> Result<(), String> {
    let (five, nine) = (along_degree_5::AlongDegree5, along_degree_9::AlongDegree9);
    let thirteen = along_degree_13::AlongDegree13;
    let [of_five, of_nine, of_thirteen] = [Peers::new(&five), Peers::new(&nine), Peers::new(&thirteen)];
    let parameters = Parameters::new(1000);
    let out = RefCell::new(Items(vec![[0.0; 3]; 1000 * COLUMNS]));
    for (way, wanted) in [(Way::StoredGrid, Some(0.9)), (Way::Rows, Some(0.9)), (Way::Calls, None)] {
        let work = Work::new(&way.title("Growth: points"));
        let work = add(work, "hodograph, PH degree 13", &thirteen, &of_thirteen, way, &parameters, &out);
        let work = add(work, "hodograph, PH degree 9", &nine, &of_nine, way, &parameters, &out);
        let work = add(work, "hodograph, PH degree 5", &five, &of_five, way, &parameters, &out);
        let work = wanted.into_iter().fold(work, |work, ratio| work.wanted("hodograph, PH degree 5", ratio));
        let peers = [("13", &of_thirteen), ("9", &of_nine), ("5", &of_five)];
        let work = peers.into_iter().fold(work, |work, (degree, peers)| {
            peers.with_horner::<Point, 3>(
                work,
                &format!("generic Horner, PH degree {degree}"),
                way,
                &parameters,
                &out,
            )
        });
        work.measure(settings)?;
    }
    Ok(())
}

fn add<'a, S: Sweep>(
    work: Work<'a, 3>,
    name: &str,
    surface: &'a S,
    peers: &'a Peers,
    way: Way,
    parameters: &'a Parameters<f64>,
    out: &'a RefCell<Items<[f64; 3]>>,
) -> Work<'a, 3> {
    let reference = peers.reference::<Point, _, 3>(way, parameters);
    if way == Way::Calls {
        with_ours::<Point, _, _, _, 3>(work, name, surface, way, parameters, out, reference)
    } else {
        with_ours::<SeparatedPoint, _, _, _, 3>(work, name, surface, way, parameters, out, reference)
    }
}
