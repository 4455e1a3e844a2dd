//! Evaluators measured against exact evaluation.

use std::collections::BTreeMap;

use hodograph::{Surface, Undefined};
use hodograph_algebra::{Derivation, Rational};

use crate::fixed::Fixed;
use crate::oracle::Oracle;
use crate::precision::Quantity;
use crate::random::SplitMix64;

/// Random points of each surface, beside its corners and the middles of its edges.
const RANDOM_POINTS: usize = 1000;

/// Distances at which offset points are evaluated.
pub const DISTANCES: [f64; 4] = [-1.25, 0.0, 1.0 / 3.0, 2.0];

/// Half the step between floats of size 1: the unit of errors.
pub const UNIT: f64 = f64::EPSILON / 2.0;

/// The width of enclosures is below this, so that smaller sizes and errors are those of zero.
pub const RESOLUTION: f64 = 1e-80;

/// The corners and the middles of the edges of a surface's domain, then random points in it.
#[must_use]
pub fn parameters(surface: &dyn Surface) -> Vec<(f64, f64)> {
    let mut random = SplitMix64::new(2014);
    let thirds = [0.0, 0.5, 1.0];
    let border = thirds.iter().flat_map(|&s| thirds.iter().map(move |&t| (s, t)));
    let border = border.filter(|&at| at != (0.5, 0.5));
    let random = (0..RANDOM_POINTS).map(|_| (random.next_f64(), random.next_f64()));
    border.chain(random).map(|(s, t)| surface.domain().at(s, t)).collect()
}

/// The largest error and the largest absolute value of each component of a quantity.
#[derive(Debug, Default)]
pub struct Errors {
    components: Vec<(f64, f64)>,
}

impl Errors {
    fn record(&mut self, floats: &[f64], truth: &[Fixed]) {
        assert_eq!(floats.len(), truth.len());
        self.components.resize(floats.len(), (0.0, 0.0));
        for ((largest, size), (&float, truth)) in self.components.iter_mut().zip(floats.iter().zip(truth)) {
            *largest = largest.max(truth.distance(float));
            *size = size.max(truth.magnitude());
        }
    }

    /// The error of each component relative to its own size, in units; an error of a component that is zero everywhere
    /// is relative to the size of the vector.
    #[must_use]
    pub fn of_components(&self) -> Vec<f64> {
        let relative = |&(error, size): &(f64, f64)| {
            let size = if size > RESOLUTION { size } else { self.size() };
            if error > RESOLUTION { error / size / UNIT } else { 0.0 }
        };
        self.components.iter().map(relative).collect()
    }

    /// The largest error relative to the size of the quantity, in units. Homogeneous coordinates are measured each by
    /// itself, since they have no common size.
    #[must_use]
    pub fn relative(&self, quantity: Quantity) -> f64 {
        if matches!(quantity, Quantity::Homogeneous | Quantity::ControlNet) {
            return self.of_components().into_iter().fold(0.0, f64::max);
        }
        let error = self.components.iter().map(|&(error, _)| error).fold(0.0, f64::max);
        if error > RESOLUTION { error / self.size() / UNIT } else { 0.0 }
    }

    fn size(&self) -> f64 {
        self.components.iter().map(|&(_, size)| size).fold(0.0, f64::max)
    }
}

/// All quantities at all points of a surface, compared with exact evaluation. The homogeneous coordinates of the surface
/// are those of the derivation times `scale`.
///
/// # Panics
/// If a normal or an offset point is there where there is none, or the other way around, or anything else is not there.
#[must_use]
pub fn measure(
    surface: &dyn Surface,
    derivation: &Derivation,
    scale: &Rational,
) -> BTreeMap<Quantity, Errors> {
    let oracle = Oracle::new(derivation);
    let scale = Fixed::of(scale);
    let mut errors: BTreeMap<Quantity, Errors> = BTreeMap::new();
    let mut record = |quantity, floats: &[f64], truth: &[Fixed]| {
        errors.entry(quantity).or_default().record(floats, truth);
    };
    for (u, v) in parameters(surface) {
        let name = surface.name();
        let truth = oracle.at(u, v);
        let homogeneous = there(surface, u, v, surface.homogeneous(u, v));
        let exact = truth.homogeneous.each_ref().map(|coordinate| coordinate.mul(&scale));
        record(Quantity::Homogeneous, &homogeneous, &exact);
        record(Quantity::Point, &there(surface, u, v, surface.point(u, v)), &truth.point);
        record(Quantity::Point, &there(surface, u, v, surface.separated_point(u, v)), &truth.point);
        record(Quantity::PartialU, &there(surface, u, v, surface.partial_u(u, v)), &truth.partial_u);
        record(Quantity::PartialV, &there(surface, u, v, surface.partial_v(u, v)), &truth.partial_v);
        let speeds = [surface.speed_u(u, v), surface.speed_v(u, v)].map(|speed| there(surface, u, v, speed));
        record(Quantity::SpeedU, &speeds[..1], &truth.speeds[..1]);
        record(Quantity::SpeedV, &speeds[1..], &truth.speeds[1..]);
        match (surface.unit_normal(u, v), truth.unit_normal()) {
            (Ok(normal), Some(truth)) => record(Quantity::UnitNormal, &normal, truth),
            (Err(Undefined::Singular), None) => {}
            (found, exact) => panic!("{name} at ({u}, {v}) has the normal {found:?}, exactly {exact:?}"),
        }
        for r in DISTANCES {
            match (surface.offset_point(r, u, v), &truth.offset_point(r)) {
                (Ok(point), Some(truth)) => record(Quantity::OffsetPoint, &point, truth),
                (Err(Undefined::Singular), None) => {}
                (found, exact) => panic!("{name} at ({u}, {v}) has the offset {found:?}, exactly {exact:?}"),
            }
        }
        record(Quantity::ControlNet, &bezier_point(surface, u, v), &exact);
    }
    errors
}

/// What a surface has at (u, v).
fn there<T>(surface: &dyn Surface, u: f64, v: f64, result: Result<T, Undefined>) -> T {
    result.unwrap_or_else(|reason| panic!("{} at ({u}, {v}): {reason}", surface.name()))
}

/// The homogeneous point of a surface's control net at (u, v), by de Casteljau's scheme in u, then in v.
fn bezier_point(surface: &dyn Surface, u: f64, v: f64) -> [f64; 4] {
    let hodograph::Domain { u: [u_first, u_last], v: [v_first, v_last] } = surface.domain();
    let (s, t) = ((u - u_first) / (u_last - u_first), (v - v_first) / (v_last - v_first));
    let rows = surface.control_net().chunks(surface.degree().1 as usize + 1);
    de_casteljau(rows.map(|row| de_casteljau(row.to_vec(), t)).collect(), s)
}

fn de_casteljau(mut points: Vec<[f64; 4]>, t: f64) -> [f64; 4] {
    while points.len() > 1 {
        points = points
            .windows(2)
            .map(|pair| std::array::from_fn(|i| (1.0 - t) * pair[0][i] + t * pair[1][i]))
            .collect();
    }
    points[0]
}
