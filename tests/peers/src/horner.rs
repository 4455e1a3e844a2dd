//! Horner's scheme in both parameters.

use crate::{Evaluator, Jet, LANES, Lanes, Net, Number, Partials, Quantity, rational};

/// A rational patch by Horner's scheme in v, then in u, on power coefficients of degrees that are known at run time.
#[derive(Clone, Debug)]
pub struct Horner {
    n: usize,
    coefficients: Vec<[f64; 4]>,
}

impl Horner {
    /// The evaluator of a patch.
    #[must_use]
    pub fn new(net: &Net) -> Self {
        Self { n: net.n, coefficients: net.power_coefficients() }
    }

    /// Items of a quantity at (`us[k]`, `vs[k]`), several points side by side.
    ///
    /// # Panics
    /// If the lengths differ.
    #[inline(always)]
    pub fn points<Q: Quantity<L>, I, const L: usize>(
        &self,
        us: &[f64],
        vs: &[f64],
        out: &mut [I],
        item: impl Fn([f64; L]) -> I,
    ) {
        assert!(us.len() == vs.len() && us.len() == out.len(), "a result for each point");
        let (us, us_left) = us.as_chunks::<LANES>();
        let (vs, vs_left) = vs.as_chunks::<LANES>();
        let (out, out_left) = out.as_chunks_mut::<LANES>();
        for ((&us, &vs), out) in us.iter().zip(vs).zip(out) {
            let jet = self.jet(Q::ORDER, Lanes(us), Lanes(vs));
            let values = Q::of(&rational::partials(Q::ORDER, &jet));
            for (k, out) in out.iter_mut().enumerate() {
                *out = item(values.map(|value| value.0[k]));
            }
        }
        for ((&u, &v), out) in us_left.iter().zip(vs_left).zip(out_left) {
            *out = item(self.at::<Q, L>(u, v));
        }
    }

    /// The homogeneous coordinates and their derivatives up to an order.
    #[inline(always)]
    fn jet<N: Number>(&self, order: usize, u: N, v: N) -> Jet<N> {
        let zero = [N::of(0.0); 4];
        let mut jet = [zero; 6];
        for row in self.coefficients.chunks_exact(self.n + 1).rev() {
            // Of the row: its value, its derivative and half its second.
            let mut of_v = [zero; 3];
            for &coefficient in row.iter().rev() {
                step(order, &mut of_v, v, coefficient.map(N::of));
            }
            let [value, slope, bend] = of_v;
            let [mut in_u, mut slope_in_u] = [[jet[0], jet[1], jet[3]], [jet[2], jet[4], zero]];
            step(order, &mut in_u, u, value);
            if order > 0 {
                step(order - 1, &mut slope_in_u, u, slope);
            }
            if order > 1 {
                let mut bend_in_u = [jet[5], zero, zero];
                step(0, &mut bend_in_u, u, bend);
                jet[5] = bend_in_u[0];
            }
            [jet[0], jet[1], jet[3]] = in_u;
            [jet[2], jet[4], _] = slope_in_u;
        }
        if order > 1 {
            let twice = |a: [N; 4]| a.map(|c| c + c);
            [jet[3], jet[5]] = [twice(jet[3]), twice(jet[5])];
        }
        jet
    }
}

/// A step of Horner's scheme for the value, the derivative and half the second derivative.
#[inline(always)]
pub(crate) fn step<N: Number>(order: usize, values: &mut [[N; 4]; 3], t: N, next: [N; 4]) {
    for c in 0..4 {
        if order > 1 {
            values[2][c] = values[2][c].mul_add(t, values[1][c]);
        }
        if order > 0 {
            values[1][c] = values[1][c].mul_add(t, values[0][c]);
        }
        values[0][c] = values[0][c].mul_add(t, next[c]);
    }
}

impl Evaluator for Horner {
    #[inline(always)]
    fn partials(&self, order: usize, u: f64, v: f64) -> Partials<f64> {
        rational::partials(order, &self.jet(order, u, v))
    }
}
