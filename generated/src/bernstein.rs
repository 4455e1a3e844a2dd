//! Polynomials in the Bernstein basis, for the control nets of families.
//!
//! An array of n + 1 coefficients is a polynomial of degree n over the interval at hand. All operations add, multiply and
//! average coefficients, so they are as stable as the basis is.

/// a + `sign`·b, at the degree of the result, which is that of neither less.
///
/// ```
/// use hodograph::bernstein::sum;
/// let result: [f64; 3] = sum(&[0.0, 1.0], &[1.0, 0.0, 0.0], 1.0);
/// assert_eq!(result, [1.0, 0.5, 1.0]);
/// ```
#[must_use]
pub fn sum<const A: usize, const B: usize, const C: usize>(
    a: &[f64; A],
    b: &[f64; B],
    sign: f64,
) -> [f64; C] {
    let (mut sum, b): ([f64; C], [f64; C]) = (elevated(a), elevated(b));
    for (a, b) in sum.iter_mut().zip(b) {
        *a += sign * b;
    }
    sum
}

/// `factor`·a.
#[must_use]
pub fn scaled<const A: usize>(a: &[f64; A], factor: f64) -> [f64; A] {
    a.map(|a| a * factor)
}

/// a·b, of the sum of their degrees: the coefficient k is Σ C(m, i)·C(n, k − i)/C(m + n, k)·a_i·b_{k−i}.
///
/// ```
/// use hodograph::bernstein::product;
/// let square: [f64; 3] = product(&[0.0, 1.0], &[0.0, 1.0]);
/// assert_eq!(square, [0.0, 0.0, 1.0]);
/// ```
#[must_use]
pub fn product<const A: usize, const B: usize, const C: usize>(a: &[f64; A], b: &[f64; B]) -> [f64; C] {
    debug_assert_eq!(A + B, C + 1);
    let mut result = [0.0; C];
    multiply(a, b, &mut result);
    result
}

/// Adds a·b to `product`, which is zero and of the length of the product.
fn multiply(a: &[f64], b: &[f64], product: &mut [f64]) {
    let mut of_a = 1.0;
    for (i, x) in a.iter().enumerate() {
        let mut of_b = 1.0;
        for (j, y) in b.iter().enumerate() {
            product[i + j] += of_a * x * (of_b * y);
            of_b = next_binomial(of_b, b.len() - 1, j);
        }
        of_a = next_binomial(of_a, a.len() - 1, i);
    }
    let (mut of_c, degree) = (1.0, product.len() - 1);
    for (k, c) in product.iter_mut().enumerate() {
        *c /= of_c;
        of_c = next_binomial(of_c, degree, k);
    }
}

/// Σ c_i·bⁱ for numbers c_0, …, c_n and a polynomial b, by Horner's scheme.
///
/// ```
/// use hodograph::bernstein::horner;
/// // 1 + 2t² over [0, 1]
/// let result: [f64; 3] = horner(&[1.0, 0.0, 2.0], &[0.0, 1.0]);
/// assert_eq!(result, [1.0, 1.0, 3.0]);
/// ```
#[must_use]
pub fn horner<const N: usize, const B: usize, const C: usize>(
    coefficients: &[f64; N],
    base: &[f64; B],
) -> [f64; C] {
    debug_assert_eq!((N - 1) * (B - 1) + 1, C);
    let mut sum = [0.0; C];
    let mut length = 1;
    for (k, c) in coefficients.iter().rev().enumerate() {
        if k > 0 {
            let mut next = [0.0; C];
            multiply(&sum[..length], base, &mut next[..length + B - 1]);
            (sum, length) = (next, length + B - 1);
        }
        for s in &mut sum[..length] {
            *s += c;
        }
    }
    sum
}

/// C(n, k + 1) from C(n, k).
fn next_binomial(binomial: f64, n: usize, k: usize) -> f64 {
    binomial * (n - k) as f64 / (k + 1) as f64
}

/// The same polynomial with coefficients of a degree that is not less.
///
/// ```
/// use hodograph::bernstein::elevated;
/// let line: [f64; 3] = elevated(&[1.0, 2.0]);
/// assert_eq!(line, [1.0, 1.5, 2.0]);
/// ```
#[must_use]
pub fn elevated<const A: usize, const C: usize>(a: &[f64; A]) -> [f64; C] {
    debug_assert!(A <= C);
    let mut result = [0.0; C];
    result[..A].copy_from_slice(a);
    for length in A..C {
        result[length] = result[length - 1];
        for i in (1..length).rev() {
            let share = i as f64 / length as f64;
            result[i] = share * result[i - 1] + (1.0 - share) * result[i];
        }
    }
    result
}

/// The coefficients of 1, t, …, tⁿ of the Bézier curve with these control points over \[0, 1\], which a family with a
/// `polynomial_curve` takes; with homogeneous control points those of a rational curve.
///
/// The coefficient of t^j is C(n, j)·Δ^j b_0, with the forward difference Δ.
///
/// ```
/// use hodograph::bernstein::power_coefficients;
/// // t², 2t − t²
/// let parabola = power_coefficients(&[[0.0, 0.0], [0.0, 1.0], [1.0, 1.0]]);
/// assert_eq!(parabola, [[0.0, 0.0], [0.0, 2.0], [1.0, -1.0]]);
/// ```
#[must_use]
pub fn power_coefficients<const D: usize, const N: usize>(points: &[[f64; D]; N]) -> [[f64; D]; N] {
    let mut coefficients = *points;
    let mut binomial = 1.0;
    for j in 0..N {
        for k in (j + 1..N).rev() {
            let before = coefficients[k - 1];
            for (c, b) in coefficients[k].iter_mut().zip(before) {
                *c -= b;
            }
        }
        for c in &mut coefficients[j] {
            *c *= binomial;
        }
        binomial = next_binomial(binomial, N - 1, j);
    }
    coefficients
}

/// Adds `factor`·u_i·v_j to a coordinate of each point (i, j) of a net, the index of u outer.
pub fn accumulate<const M: usize, const N: usize, const L: usize>(
    net: &mut [[f64; 4]; L],
    coordinate: usize,
    factor: f64,
    u: &[f64; M],
    v: &[f64; N],
) {
    for (row, u) in net.chunks_exact_mut(N).zip(u) {
        for (point, v) in row.iter_mut().zip(v) {
            point[coordinate] += factor * u * v;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{accumulate, elevated, product, scaled, sum};

    #[test]
    fn products_and_sums_are_those_of_the_polynomials() {
        // (1 + t)² (2 − t) = 2 + 3t − t³
        let (rising, falling) = ([1.0, 2.0], [2.0, 1.0]);
        let square: [f64; 3] = product(&rising, &rising);
        let cubic: [f64; 4] = product(&square, &falling);
        assert_eq!(cubic, [2.0, 3.0, 4.0, 4.0]);
        let difference: [f64; 4] = sum(&cubic, &scaled(&falling, 2.0), -1.0);
        // 2 + 3t − t³ − 4 + 2t = −2 + 5t − t³
        for (found, expected) in difference.iter().zip([-2.0, -1.0 / 3.0, 4.0 / 3.0, 2.0]) {
            assert!((found - expected).abs() < 1e-15);
        }
        let constant: [f64; 5] = elevated(&[7.0]);
        assert_eq!(constant, [7.0; 5]);
    }

    #[test]
    fn nets_are_sums_of_products() {
        let mut net = [[0.0; 4]; 6];
        accumulate(&mut net, 2, 2.0, &[1.0, 3.0], &[0.0, 1.0, 5.0]);
        assert_eq!(net.map(|point| point[2]), [0.0, 2.0, 10.0, 0.0, 6.0, 30.0]);
        assert_eq!(net[5][0], 0.0);
    }
}
