//! From homogeneous coordinates to points and derivatives, by the quotient rule.

use crate::{Jet, Number, Partials};

/// The derivatives of (X, Y, Z)/W up to an order, from those of the homogeneous coordinates.
#[inline(always)]
pub(crate) fn partials<N: Number>(order: usize, jet: &Jet<N>) -> Partials<N> {
    let inverse = N::of(1.0) / jet[0][0];
    let zero = N::of(0.0);
    let mut partials = [[zero; 3]; 6];
    for c in 0..3 {
        let of = |k: usize| jet[k][c + 1];
        let weight = |k: usize| jet[k][0];
        let r = of(0) * inverse;
        partials[0][c] = r;
        if order > 0 {
            let r_u = (of(1) - weight(1) * r) * inverse;
            let r_v = (of(2) - weight(2) * r) * inverse;
            partials[1][c] = r_u;
            partials[2][c] = r_v;
            if order > 1 {
                let twice = N::of(2.0);
                partials[3][c] = (of(3) - twice * weight(1) * r_u - weight(3) * r) * inverse;
                partials[4][c] = (of(4) - weight(1) * r_v - weight(2) * r_u - weight(4) * r) * inverse;
                partials[5][c] = (of(5) - twice * weight(2) * r_v - weight(5) * r) * inverse;
            }
        }
    }
    partials
}
