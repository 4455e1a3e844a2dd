//! De Casteljau's scheme in both parameters.

use std::cell::RefCell;

use crate::{Evaluator, Jet, Net, Partials, rational};

/// A rational patch by de Casteljau's scheme on the homogeneous net, in the parameter of the lower degree first, which takes fewer
/// steps. The degrees are known at run time.
#[derive(Clone, Debug)]
pub struct DeCasteljau {
    /// Whether the scheme is in v first.
    v_first: bool,
    /// The control points in lines of the first parameter.
    points: Vec<[f64; 4]>,
    /// The number of points of a line, and of lines.
    counts: [usize; 2],
    scratch: RefCell<Scratch>,
}

/// Room for the points of a line, and for those of all lines with both derivatives.
#[derive(Clone, Debug)]
struct Scratch {
    line: Vec<[f64; 4]>,
    of_lines: [Vec<[f64; 4]>; 3],
}

impl DeCasteljau {
    /// The evaluator of a patch.
    #[must_use]
    pub fn new(net: &Net) -> Self {
        let v_first = net.n < net.m;
        let points = if v_first {
            net.points.clone()
        } else {
            let columns = 0..=net.n;
            columns.flat_map(|j| net.rows().map(move |row| row[j])).collect()
        };
        let [of_u, of_v] = [net.m + 1, net.n + 1];
        let counts = if v_first { [of_v, of_u] } else { [of_u, of_v] };
        let room = || vec![[0.0; 4]; of_u.max(of_v)];
        let scratch = RefCell::new(Scratch { line: room(), of_lines: [room(), room(), room()] });
        Self { v_first, points, counts, scratch }
    }

    /// The homogeneous coordinates and their derivatives up to an order.
    #[inline(always)]
    fn jet(&self, order: usize, u: f64, v: f64) -> Jet<f64> {
        let [s, t] = if self.v_first { [v, u] } else { [u, v] };
        let [points, lines] = self.counts;
        let Scratch { line: scratch, of_lines } = &mut *self.scratch.borrow_mut();
        for (i, line) in self.points.chunks_exact(points).enumerate() {
            scratch[..points].copy_from_slice(line);
            let of_line = scheme(order, &mut scratch[..points], s);
            for (of_lines, value) in of_lines.iter_mut().zip(of_line).take(order + 1) {
                of_lines[i] = value;
            }
        }
        let [values, slopes, bends] = of_lines;
        let [value, by_t, by_tt] = scheme(order, &mut values[..lines], t);
        let mut jet = [value, [0.0; 4], by_t, [0.0; 4], [0.0; 4], by_tt];
        if order > 0 {
            [jet[1], jet[4], _] = scheme(order - 1, &mut slopes[..lines], t);
        }
        if order > 1 {
            [jet[3], ..] = scheme(0, &mut bends[..lines], t);
        }
        if self.v_first {
            jet.swap(1, 2);
            jet.swap(3, 5);
        }
        jet
    }
}

/// The value and the derivatives up to an order of a polynomial curve; its control points are overwritten.
#[inline(always)]
fn scheme(order: usize, points: &mut [[f64; 4]], t: f64) -> [[f64; 4]; 3] {
    let degree = points.len() - 1;
    let mut values = [[0.0; 4]; 3];
    for left in (1..=degree).rev() {
        // left + 1 points are left.
        if order > 1 && left == 2 {
            let factor = (degree * (degree - 1)) as f64;
            values[2] = std::array::from_fn(|c| factor * (points[2][c] - 2.0 * points[1][c] + points[0][c]));
        }
        if order > 0 && left == 1 {
            values[1] = std::array::from_fn(|c| degree as f64 * (points[1][c] - points[0][c]));
        }
        let mut before = points[0];
        for k in 0..left {
            let next = points[k + 1];
            points[k] = std::array::from_fn(|c| t.mul_add(next[c] - before[c], before[c]));
            before = next;
        }
    }
    values[0] = points[0];
    values
}

impl Evaluator for DeCasteljau {
    #[inline(always)]
    fn partials(&self, order: usize, u: f64, v: f64) -> Partials<f64> {
        rational::partials(order, &self.jet(order, u, v))
    }
}
