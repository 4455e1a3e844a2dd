//! The control net of a rational Bézier patch, which is all that the evaluators of this package know of a surface.

/// A rational Bézier patch over the unit square, of degrees that are known at run time.
#[derive(Clone, Debug)]
pub struct Net {
    /// The degree in u.
    pub m: usize,
    /// The degree in v.
    pub n: usize,
    /// The homogeneous control points (W, X, Y, Z); b_ij is `points[i * (n + 1) + j]`.
    pub points: Vec<[f64; 4]>,
}

impl Net {
    /// The patch of a bidegree with these control points.
    ///
    /// # Panics
    /// If their number is not that of the bidegree.
    #[must_use]
    pub fn new((m, n): (u32, u32), points: &[[f64; 4]]) -> Self {
        let (m, n) = (m as usize, n as usize);
        assert_eq!(points.len(), (m + 1) * (n + 1), "a net of bidegree ({m}, {n})");
        Self { m, n, points: points.to_vec() }
    }

    /// The control points of each index of u, in the order of v.
    pub fn rows(&self) -> impl Iterator<Item = &[[f64; 4]]> {
        self.points.chunks_exact(self.n + 1)
    }

    /// The coefficients of u^i·v^j in the place of the control points.
    ///
    /// The forward differences are exact, of integers in a unit far below the rounding of the net: floats would lose most of their
    /// digits.
    #[must_use]
    pub fn power_coefficients(&self) -> Vec<[f64; 4]> {
        let largest = self.points.as_flattened().iter().fold(1.0, |size: f64, c| size.max(c.abs()));
        let unit = 2.0_f64.powi(largest.log2() as i32 - 69);
        let mut coefficients: Vec<[i128; 4]> =
            self.points.iter().map(|point| point.map(|c| (c / unit) as i128)).collect();
        let columns = self.n + 1;
        for row in coefficients.chunks_exact_mut(columns) {
            differences(row, 1);
        }
        for j in 0..columns {
            differences(&mut coefficients[j..], columns);
        }
        coefficients.into_iter().map(|point| point.map(|c| c as f64 * unit)).collect()
    }
}

/// Replaces b_0, …, b_n, which stand `step` apart, by C(n, j)·Δ^j b_0.
fn differences(points: &mut [[i128; 4]], step: usize) {
    let count = points.len().div_ceil(step);
    for level in 1..count {
        for k in (level..count).rev() {
            let before = points[(k - 1) * step];
            for (c, b) in points[k * step].iter_mut().zip(before) {
                *c -= b;
            }
        }
    }
    let mut binomial = 1;
    for j in 0..count {
        for c in &mut points[j * step] {
            *c *= binomial;
        }
        binomial = binomial * (count - 1 - j) as i128 / (j + 1) as i128;
    }
}

#[cfg(test)]
mod tests {
    use super::Net;

    #[test]
    fn power_coefficients_of_a_product() {
        // (1 − u)·(1 − v)² + 3·u·v² in every coordinate
        let net: Vec<[f64; 4]> = [1.0, 0.0, 0.0, 0.0, 0.0, 3.0].map(|c| [c; 4]).to_vec();
        let expected = [1.0, -2.0, 1.0, -1.0, 2.0, 2.0].map(|c| [c; 4]);
        assert_eq!(Net::new((1, 2), &net).power_coefficients(), expected);
    }
}
