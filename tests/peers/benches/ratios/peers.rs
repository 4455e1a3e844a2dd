//! A surface beside evaluators that know its control net.

use std::cell::RefCell;
use std::hint::black_box;

use hodograph::Patch;
use hodograph_peers::{Curvo, DeCasteljau, Evaluator, Hoisted, Horner, Net, Point, Quantity, Truck};

use crate::measure::Work;
use crate::ours::{Evaluated, Items};
use crate::way::{COLUMNS, Parameters, Vs, Way};

/// The name of the alternative that only fills the buffer.
pub(crate) const FILL: &str = "plain fill of the buffer";
/// The names of alternatives that are evaluators.
pub(crate) const HORNER: &str = "generic Horner";
pub(crate) const CURVO: &str = "curvo";
pub(crate) const TRUCK: &str = "truck-geometry";

/// Evaluators of the same surface.
pub(crate) struct Peers {
    reference: DeCasteljau,
    horner: Horner,
    hoisted: RefCell<Hoisted>,
    truck: Truck,
    curvo: Curvo,
}

impl Peers {
    /// The peers of a surface over the unit square.
    pub(crate) fn new(surface: &impl Patch) -> Self {
        let net = Net::new(surface.degree(), surface.control_net());
        Self {
            reference: DeCasteljau::new(&net),
            horner: Horner::new(&net),
            hoisted: RefCell::new(Hoisted::new(&net)),
            truck: Truck::new(&net),
            curvo: Curvo::new(&net),
        }
    }

    /// What each alternative of a work should find at a point.
    pub(crate) fn reference<'a, Q: Quantity<L>, F: hodograph::Float, const L: usize>(
        &'a self,
        way: Way,
        parameters: &'a Parameters<F>,
    ) -> impl Fn(usize) -> [f64; L] + Copy + 'a {
        move |k| {
            let (u, v) = parameters.at(way, k);
            self.reference.at::<Q, L>(u, v)
        }
    }

    /// Adds a plain fill of the same buffer to a work, generic evaluators and other libraries. Slow ones compute fewer rows.
    pub(crate) fn with_all<'a, Q: Evaluated<L>, const L: usize>(
        &'a self,
        work: Work<'a, L>,
        way: Way,
        parameters: &'a Parameters<f64>,
        out: &'a RefCell<Items<Q::Item<f64>>>,
    ) -> Work<'a, L> {
        let all = parameters.vs.len();
        let work = match way {
            Way::Calls => work,
            _ => work.measure_only(FILL, all * COLUMNS, move || {
                let out = &mut out.borrow_mut().0[..];
                out.fill(black_box(Q::item([1.5; L])));
                black_box(out);
            }),
        };
        let work = match way {
            Way::StoredGrid | Way::Rows => self.with_hoisted::<Q, L>(work, way, parameters, out),
            _ => work,
        };
        let work = self.with_horner::<Q, L>(work, HORNER, way, parameters, out);
        // Registers do not suffice for more than points and normals side by side.
        let work = if way == Way::Calls || L > 3 {
            work
        } else {
            self.with_vectors::<Q, L>(work, way, parameters, out)
        };
        let name = "generic de Casteljau";
        let work = self.with_pointwise::<Q, _, L>(work, name, 10, &self.reference, way, parameters, out);
        let work = self.with_pointwise::<Q, _, L>(work, CURVO, 5, &self.curvo, way, parameters, out);
        self.with_pointwise::<Q, _, L>(work, TRUCK, 2, &self.truck, way, parameters, out)
    }

    /// Adds curvo's own function for grids, which allocates its results.
    pub(crate) fn with_regular_points<'a>(&'a self, work: Work<'a, 3>) -> Work<'a, 3> {
        let rows = 10;
        // The index of u is the outer one.
        let reference = move |k: usize| {
            let (u, v) = ((k / rows) as f64 / (COLUMNS - 1) as f64, (k % rows) as f64 / (rows - 1) as f64);
            self.reference.at::<Point, 3>(u, v)
        };
        work.with("curvo, a regular grid at a time", COLUMNS * rows, reference, move |sink| {
            let points = self.curvo.regular_points(COLUMNS, rows);
            sink(0, COLUMNS * rows, &|k| points[k / rows][k % rows].coords.into());
        })
    }

    /// Adds Horner's scheme in both parameters, under a name.
    pub(crate) fn with_horner<'a, Q: Evaluated<L>, const L: usize>(
        &'a self,
        work: Work<'a, L>,
        name: &str,
        way: Way,
        parameters: &'a Parameters<f64>,
        out: &'a RefCell<Items<Q::Item<f64>>>,
    ) -> Work<'a, L> {
        self.with_pointwise::<Q, _, L>(work, name, 25, &self.horner, way, parameters, out)
    }

    /// Adds the generic evaluator of rows.
    fn with_hoisted<'a, Q: Evaluated<L>, const L: usize>(
        &'a self,
        work: Work<'a, L>,
        way: Way,
        parameters: &'a Parameters<f64>,
        out: &'a RefCell<Items<Q::Item<f64>>>,
    ) -> Work<'a, L> {
        let rows = parameters.vs.len().min(100);
        let reference = self.reference::<Q, _, L>(way, parameters);
        work.with("generic, v hoisted", rows * COLUMNS, reference, move |sink| {
            let (hoisted, out) = (&mut *self.hoisted.borrow_mut(), &mut out.borrow_mut().0[..]);
            for j in some(rows, parameters) {
                let out = &mut out[way.place(j)];
                hoisted.row::<Q, _, L>(&parameters.us, parameters.vs[j], out, Q::item);
                sink(j * COLUMNS, COLUMNS, &|i| Q::numbers(&out[i]));
            }
        })
    }

    /// Adds Horner's scheme for several points at a time.
    fn with_vectors<'a, Q: Evaluated<L>, const L: usize>(
        &'a self,
        work: Work<'a, L>,
        way: Way,
        parameters: &'a Parameters<f64>,
        out: &'a RefCell<Items<Q::Item<f64>>>,
    ) -> Work<'a, L> {
        let rows = parameters.vs.len().min(100);
        let reference = self.reference::<Q, _, L>(way, parameters);
        work.with("generic Horner, points in vectors", rows * COLUMNS, reference, move |sink| {
            let out = &mut out.borrow_mut().0[..];
            for j in some(rows, parameters) {
                let out = &mut out[way.place(j)];
                match parameters.row(way, j) {
                    (us, Vs::Each(vs)) => self.horner.points::<Q, _, L>(us, vs, out, Q::item),
                    (us, Vs::All(v)) => self.horner.points::<Q, _, L>(us, &[v; COLUMNS], out, Q::item),
                }
                sink(j * COLUMNS, COLUMNS, &|i| Q::numbers(&out[i]));
            }
        })
    }

    /// Adds an evaluator of single points.
    #[expect(clippy::too_many_arguments, reason = "an evaluator, and what all alternatives take")]
    fn with_pointwise<'a, Q: Evaluated<L>, E: Evaluator, const L: usize>(
        &'a self,
        work: Work<'a, L>,
        name: &str,
        rows: usize,
        evaluator: &'a E,
        way: Way,
        parameters: &'a Parameters<f64>,
        out: &'a RefCell<Items<Q::Item<f64>>>,
    ) -> Work<'a, L> {
        let rows = parameters.vs.len().min(rows);
        let reference = self.reference::<Q, _, L>(way, parameters);
        work.with(name, rows * COLUMNS, reference, move |sink| {
            let out = &mut out.borrow_mut().0[..];
            for j in some(rows, parameters) {
                let out = &mut out[way.place(j)];
                let (us, vs) = parameters.row(way, j);
                for (i, (&u, out)) in us.iter().zip(&mut *out).enumerate() {
                    let v = vs.at(i);
                    if way == Way::Calls {
                        call::<Q, E, L>(evaluator, u, v, out);
                    } else {
                        *out = Q::item(evaluator.at::<Q, L>(u, v));
                    }
                }
                sink(j * COLUMNS, COLUMNS, &|i| Q::numbers(&out[i]));
            }
        })
    }
}

/// So many rows, spread over all.
fn some(rows: usize, parameters: &Parameters<f64>) -> impl Iterator<Item = usize> {
    let all = parameters.vs.len();
    (0..rows).map(move |k| k * all / rows)
}

/// A single result by a call that is not inlined, as most are; it writes to the result's place.
#[inline(never)]
fn call<Q: Evaluated<L>, E: Evaluator, const L: usize>(
    evaluator: &E,
    u: f64,
    v: f64,
    out: &mut Q::Item<f64>,
) {
    *out = Q::item(evaluator.at::<Q, L>(u, v));
}
