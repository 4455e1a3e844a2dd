//! What is asked of an evaluator at a point, as it is found from the point and its derivatives alone.

use crate::{Number, Partials};

/// A quantity of `L` numbers at a point of a surface.
pub trait Quantity<const L: usize> {
    /// The order of the derivatives that it takes.
    const ORDER: usize;

    /// The quantity where the surface has these derivatives.
    fn of<N: Number>(partials: &Partials<N>) -> [N; L];
}

/// The point R.
#[derive(Clone, Copy, Debug)]
pub struct Point;

/// R, R_u, R_v.
#[derive(Clone, Copy, Debug)]
pub struct First;

/// R, R_u, R_v, R_uu, R_uv, R_vv.
#[derive(Clone, Copy, Debug)]
pub struct Second;

/// The unit normal.
#[derive(Clone, Copy, Debug)]
pub struct Normal;

/// [`Second`] and [`Normal`], the fundamental forms E, F, G, L, M, N, the Gaussian and the mean curvature, the principal ones, the
/// larger one first, the parametric speeds, and the derivatives of the unit normal.
#[derive(Clone, Copy, Debug)]
pub struct Local;

impl Quantity<3> for Point {
    const ORDER: usize = 0;
    #[inline(always)]
    fn of<N: Number>(partials: &Partials<N>) -> [N; 3] {
        partials[0]
    }
}

impl Quantity<9> for First {
    const ORDER: usize = 1;
    #[inline(always)]
    fn of<N: Number>(partials: &Partials<N>) -> [N; 9] {
        std::array::from_fn(|k| partials[k / 3][k % 3])
    }
}

impl Quantity<18> for Second {
    const ORDER: usize = 2;
    #[inline(always)]
    fn of<N: Number>(partials: &Partials<N>) -> [N; 18] {
        std::array::from_fn(|k| partials[k / 3][k % 3])
    }
}

impl Quantity<3> for Normal {
    const ORDER: usize = 1;
    #[inline(always)]
    fn of<N: Number>(&[_, r_u, r_v, ..]: &Partials<N>) -> [N; 3] {
        let normal = cross(r_u, r_v);
        times(N::of(1.0) / dot(normal, normal).sqrt(), normal)
    }
}

impl Quantity<39> for Local {
    const ORDER: usize = 2;
    #[inline(always)]
    fn of<N: Number>(partials: &Partials<N>) -> [N; 39] {
        let [_, r_u, r_v, r_uu, r_uv, r_vv] = *partials;
        let area_normal = cross(r_u, r_v);
        let [e, f, g] = [dot(r_u, r_u), dot(r_u, r_v), dot(r_v, r_v)];
        let area2 = dot(area_normal, area_normal);
        let unit = times(N::of(1.0) / area2.sqrt(), area_normal);
        let [l, m, n] = [dot(unit, r_uu), dot(unit, r_uv), dot(unit, r_vv)];
        let inverse = N::of(1.0) / area2;
        let gaussian = (l * n - m * m) * inverse;
        let mean = (e * n - N::of(2.0) * f * m + g * l) * inverse * N::of(0.5);
        let root = half_difference(mean, [e, f, g], [l, m, n], inverse);
        // The equations of Weingarten.
        let normal_u = sum(times((f * m - g * l) * inverse, r_u), times((f * l - e * m) * inverse, r_v));
        let normal_v = sum(times((f * n - g * m) * inverse, r_u), times((f * m - e * n) * inverse, r_v));
        let mut values = [N::of(0.0); 39];
        let [first, second] = [[e, f, g], [l, m, n]];
        let curvatures = [gaussian, mean, mean + root, mean - root, e.sqrt(), g.sqrt()];
        let parts: [&[N]; 6] = [&unit, &first, &second, &curvatures, &normal_u, &normal_v];
        for (value, part) in
            values.iter_mut().zip(partials.iter().flatten().chain(parts.into_iter().flatten()))
        {
            *value = *part;
        }
        values
    }
}

/// √(H² − K), half the difference of the principal curvatures, as √(((a − c)/2)² + b²) of the shape operator in an orthonormal
/// basis along R_u: it has no negative radicand.
#[inline(always)]
fn half_difference<N: Number>(mean: N, [e, f, _]: [N; 3], [l, m, _]: [N; 3], inverse: N) -> N {
    let a = l / e;
    let b2 = (m - f * a) * (m - f * a) * inverse;
    let half = a - mean;
    half.mul_add(half, b2).sqrt()
}

#[inline(always)]
fn cross<N: Number>(a: [N; 3], b: [N; 3]) -> [N; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

#[inline(always)]
fn dot<N: Number>(a: [N; 3], b: [N; 3]) -> N {
    a[0].mul_add(b[0], a[1].mul_add(b[1], a[2] * b[2]))
}

#[inline(always)]
fn times<N: Number>(factor: N, a: [N; 3]) -> [N; 3] {
    a.map(|c| factor * c)
}

#[inline(always)]
fn sum<N: Number>(a: [N; 3], b: [N; 3]) -> [N; 3] {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}
