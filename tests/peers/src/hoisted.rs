//! Rows of u: what depends on v alone is computed once for each row.

use crate::horner::step;
use crate::{Jet, LANES, Lanes, Net, Number, Quantity, rational};

/// A rational patch along rows v = const: the coefficients of the row's polynomials of u by Horner's scheme in v, then Horner's scheme
/// in u for several points side by side. The degrees are known at run time.
#[derive(Clone, Debug)]
pub struct Hoisted {
    n: usize,
    coefficients: Vec<[f64; 4]>,
    /// For each power of u: the coefficient, its derivative by v, and half its second.
    row: Vec<[[f64; 4]; 3]>,
}

impl Hoisted {
    /// The evaluator of a patch.
    #[must_use]
    pub fn new(net: &Net) -> Self {
        Self { n: net.n, coefficients: net.power_coefficients(), row: vec![[[0.0; 4]; 3]; net.m + 1] }
    }

    /// Items of a quantity at (`us[k]`, v).
    ///
    /// # Panics
    /// If the lengths differ.
    #[inline(always)]
    pub fn row<Q: Quantity<L>, I, const L: usize>(
        &mut self,
        us: &[f64],
        v: f64,
        out: &mut [I],
        item: impl Fn([f64; L]) -> I,
    ) {
        assert_eq!(us.len(), out.len(), "a result for each point");
        for (of_v, row) in self.row.iter_mut().zip(self.coefficients.chunks_exact(self.n + 1)) {
            *of_v = [[0.0; 4]; 3];
            for &coefficient in row.iter().rev() {
                step(Q::ORDER, of_v, v, coefficient);
            }
        }
        // Registers do not suffice for second derivatives side by side.
        let side_by_side = if Q::ORDER < 2 { us.len() / LANES * LANES } else { 0 };
        let (us, us_left) = us.split_at(side_by_side);
        let (out, out_left) = out.split_at_mut(side_by_side);
        let (us, out) = (us.as_chunks::<LANES>().0, out.as_chunks_mut::<LANES>().0);
        for (&us, out) in us.iter().zip(out) {
            let values = Q::of(&rational::partials(Q::ORDER, &self.jet(Q::ORDER, Lanes(us))));
            for (k, out) in out.iter_mut().enumerate() {
                *out = item(values.map(|value| value.0[k]));
            }
        }
        for (&u, out) in us_left.iter().zip(out_left) {
            *out = item(Q::of(&rational::partials(Q::ORDER, &self.jet(Q::ORDER, u))));
        }
    }

    /// The homogeneous coordinates and their derivatives on the row.
    #[inline(always)]
    fn jet<N: Number>(&self, order: usize, u: N) -> Jet<N> {
        let zero = [N::of(0.0); 4];
        let mut of_u = [[zero; 3]; 3];
        for of_v in self.row.iter().rev() {
            for derivative in 0..=order {
                step(order - derivative, &mut of_u[derivative], u, of_v[derivative].map(N::of));
            }
        }
        let twice = |a: [N; 4]| a.map(|c| c + c);
        let [value, slope, bend] = of_u;
        [value[0], value[1], slope[0], twice(value[2]), slope[1], twice(bend[0])]
    }
}
