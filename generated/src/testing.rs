//! A surface for the tests of this crate, written by hand.

use crate::real::Real;
use crate::surface::{Domain, Patch};
use crate::task::{First, Homogeneous, Local, Normal, Part, Point, Second, Separated, Stages, Sweep, Task};

/// R = (uv, v², v)/(1 − u), with poles at u = 1 and singular points at v = 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Cone;

impl Patch for Cone {
    fn name(&self) -> &str {
        "cone"
    }
    fn degree(&self) -> (u32, u32) {
        (1, 2)
    }
    fn domain(&self) -> Domain {
        Domain { u: [0.0, 0.5], v: [0.0, 1.0] }
    }
    fn control_net(&self) -> &[[f64; 4]] {
        const NET: [[f64; 4]; 6] = [
            [1.0, 0.0, 0.0, 0.0],
            [1.0, 0.0, 0.0, 0.5],
            [1.0, 0.0, 1.0, 1.0],
            [0.5, 0.0, 0.0, 0.0],
            [0.5, 0.25, 0.0, 0.5],
            [0.5, 0.5, 1.0, 1.0],
        ];
        &NET
    }
}

impl Sweep for Cone {}

macro_rules! stages {
    ($task:ident, $m:literal, $n:literal, $of_u:expr, $of_v:expr, $join:expr) => {
        impl Stages<$task> for Cone {
            type OfU<R: Copy + Default> = [R; $m];
            type OfV<R: Copy + Default> = [R; $n];

            #[inline(always)]
            fn of_u<R: Real>(&self, u: R) -> [R; $m] {
                let of_u: fn(R) -> [R; $m] = $of_u;
                of_u(u)
            }
            #[inline(always)]
            fn of_v<R: Real>(&self, v: R) -> [R; $n] {
                let of_v: fn(R) -> [R; $n] = $of_v;
                of_v(v)
            }
            #[inline(always)]
            fn join<R: Real>(&self, of_u: [R; $m], of_v: [R; $n]) -> <$task as Task>::Values<R> {
                let join: fn([R; $m], [R; $n]) -> <$task as Task>::Values<R> = $join;
                join(of_u, of_v)
            }
        }
    };
}

/// 1/(1 − u) and u/(1 − u).
#[inline(always)]
fn quotients<R: Real>(u: R) -> [R; 2] {
    let inverse = R::of(1.0) / (R::of(1.0) - u);
    [inverse, u * inverse]
}

#[inline(always)]
fn second<R: Real>([i, q]: [R; 2], [v, square]: [R; 2]) -> [R; 18] {
    let (zero, one, two) = (R::of(0.0), R::of(1.0), R::of(2.0));
    let (i2, i3) = (i * i, i * i * i);
    let derivative = two.mul_add(v, zero);
    [
        [q * v, square * i, v * i],
        [v * i2, square * i2, v * i2],
        [q, derivative * i, i],
        [two * v * i3, two * square * i3, two * v * i3],
        [one * i2, derivative * i2, i2],
        [zero, two * i, zero],
    ]
    .as_flattened()
    .try_into()
    .unwrap_or([zero; 18])
}

/// The direction (−v, u − 1, v(2 − u)), with the side of R_u × R_v where u < 1.
#[inline(always)]
fn normal<R: Real>(u: R, v: R) -> [R; 3] {
    let direction = [-v, u - R::of(1.0), (-v).mul_add(u, v + v)];
    let scale = R::scale(direction[0], direction[1], direction[2]);
    let [x, y, z] = direction.map(|component| (component * scale).orient(v));
    let norm = dot([x, y, z], [x, y, z]).sqrt();
    [x / norm, y / norm, z / norm]
}

#[inline(always)]
fn dot<R: Real>(a: [R; 3], b: [R; 3]) -> R {
    a[2].mul_add(b[2], a[1].mul_add(b[1], a[0] * b[0]))
}

#[inline(always)]
fn cross<R: Real>(a: [R; 3], b: [R; 3]) -> [R; 3] {
    [
        a[1].mul_add(b[2], -(a[2] * b[1])),
        a[2].mul_add(b[0], -(a[0] * b[2])),
        a[0].mul_add(b[1], -(a[1] * b[0])),
    ]
}

#[inline(always)]
fn local<R: Real>([u, i, q]: [R; 3], [v, square]: [R; 2]) -> [R; 39] {
    let s = second([i, q], [v, square]);
    let three = |k: usize| [s[k], s[k + 1], s[k + 2]];
    let (ru, rv, ruu, ruv, rvv) = (three(3), three(6), three(9), three(12), three(15));
    let n = normal(u, v);
    let (e, f, g) = (dot(ru, ru), dot(ru, rv), dot(rv, rv));
    let (l, m, last) = (dot(n, ruu), dot(n, ruv), dot(n, rvv));
    let area = dot(n, cross(ru, rv));
    let (over_e, over_area) = (R::of(1.0) / e, R::of(1.0) / area);
    let a = l * over_e;
    let rest = (-f).mul_add(a, m);
    let b = rest * over_area;
    let c = e.mul_add(last, -(f * (m + rest))) * over_area * over_area;
    let half = R::of(0.5);
    let (mean, difference) = ((a + c) * half, (a - c) * half);
    let root = difference.mul_add(difference, b * b).sqrt();
    let across = cross(n, ru);
    let nu: [R; 3] = Part::of(|k| -(a.mul_add(ru[k], b * across[k])));
    let nv: [R; 3] =
        Part::of(|k| (f * over_e).mul_add(nu[k], -(area * over_e * b.mul_add(ru[k], c * across[k]))));
    let rest = [n, [e, f, g], [l, m, last], [a.mul_add(c, -(b * b)), mean, mean + root]];
    let end = [[mean - root, e.sqrt(), g.sqrt()], nu, nv];
    Part::of(|k| match k {
        0..18 => s[k],
        18..30 => rest.as_flattened()[k - 18],
        _ => end.as_flattened()[k - 30],
    })
}

stages!(Homogeneous, 2, 2, |u| [R::of(1.0) - u, u], |v| [v, v * v], |[w, u], [v, square]| {
    [w, u * v, square, v]
});
stages!(Point, 2, 2, |u| [R::of(1.0) - u, u], |v| [v, v * v], |[w, u], [v, square]| {
    let inverse = R::of(1.0) / w;
    [u * v * inverse, square * inverse, v * inverse]
});
stages!(Separated, 2, 2, quotients, |v| [v, v * v], |[i, q], [v, square]| [q * v, square * i, v * i]);
stages!(First, 2, 2, quotients, |v| [v, v * v], |u, v| {
    let numbers = second(u, v);
    Part::of(|k| numbers[k])
});
stages!(Second, 2, 2, quotients, |v| [v, v * v], second);
stages!(Normal, 1, 1, |u| [u], |v| [v], |[u], [v]| normal(u, v));
stages!(
    Local,
    3,
    2,
    |u| {
        let [i, q] = quotients(u);
        [u, i, q]
    },
    |v| [v, v * v],
    local
);
