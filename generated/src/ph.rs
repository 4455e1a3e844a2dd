//! Planar PH quintics at run time: their preimages from Hermite data and from control points.
//!
//! A planar PH quintic s has the hodograph s' = w² with a complex polynomial w of degree 2, its *preimage*. Families of
//! surfaces along such curves take its Bernstein coefficients w_0, w_1, w_2 on \[0, 1\], each as `[re, im]`.
//!
//! ```
//! use hodograph::ph::hermite;
//! let [w0, w1, w2] = hermite([0.0, 0.0], [0.0, 4.0], [2.0, 2.0], [4.0, 0.0]).unwrap();
//! assert!((w0[0] - 2.0_f64.sqrt()).abs() < 1e-15 && (w0[1] - 2.0_f64.sqrt()).abs() < 1e-15);
//! assert!((w1[0] - 1.4034).abs() < 1e-4 && (w1[1] - 0.5813).abs() < 1e-4 && w2 == [2.0, 0.0]);
//! ```

use core::fmt;

use crate::float::{atan2, sqrt};

/// A complex number, or a point of the plane.
type Complex = [f64; 2];

/// The Bernstein coefficients w_0, w_1, w_2 of a preimage.
pub type Preimage = [[f64; 2]; 3];

/// Why there is no preimage.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum PhError {
    /// A number is infinite or NaN, or numbers are so large or small that products overflow or vanish.
    NotFinite,
    /// A tangent at an end is zero, or two control points at an end coincide.
    ZeroTangent,
    /// The control points are not those of a PH quintic.
    NotPh,
}

impl fmt::Display for PhError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::NotFinite => "the data of the curve are not finite, or out of range",
            Self::ZeroTangent => "the tangent at an end of the curve is zero",
            Self::NotPh => "the control points are not those of a PH quintic",
        })
    }
}

impl core::error::Error for PhError {}

/// The preimage of the PH quintic from `from` to `to` with these derivatives at its ends, that of least absolute rotation
/// index among the four (Farouki & Neff 1995).
///
/// With w_0² = s'(0), w_2² = s'(1) the middle coefficient solves
/// 2w_1² + 3(w_0 + w_2)w_1 + 3w_0² + 3w_2² + w_0w_2 = 15·(s(1) − s(0)). Two curves whose tangents turn equally far, as
/// for symmetric data, are told apart by rounding alone.
///
/// # Accuracy
/// The curve meets the data within 64 units of 2⁻⁵³ of the largest of |s(1) − s(0)|, |s'(0)| and |s'(1)|, as the tests measure it, also
/// where two of the four curves nearly coincide. There the preimage itself is less certain: w_1 contains the root of a
/// difference D, and its error is some 2⁻⁵³·(size of D's terms)/√|D|.
///
/// # Errors
/// [`PhError::NotFinite`] and [`PhError::ZeroTangent`].
pub fn hermite(
    from: [f64; 2],
    tangent: [f64; 2],
    to: [f64; 2],
    end_tangent: [f64; 2],
) -> Result<Preimage, PhError> {
    let [first, others @ ..] = hermite_solutions(from, tangent, to, end_tangent)?;
    let mut best = (rotation(&first), first);
    for preimage in others {
        let turned = rotation(&preimage);
        if turned < best.0 {
            best = (turned, preimage);
        }
    }
    Ok(best.1)
}

/// The preimages of all four PH quintics with these Hermite data; −w would give the same curves.
///
/// # Errors
/// [`PhError::NotFinite`] and [`PhError::ZeroTangent`].
pub fn hermite_solutions(
    from: [f64; 2],
    tangent: [f64; 2],
    to: [f64; 2],
    end_tangent: [f64; 2],
) -> Result<[Preimage; 4], PhError> {
    let data = [from, tangent, to, end_tangent];
    if !data.as_flattened().iter().all(|x| x.is_finite()) {
        return Err(PhError::NotFinite);
    }
    if tangent == [0.0; 2] || end_tangent == [0.0; 2] {
        return Err(PhError::ZeroTangent);
    }
    let chord = subtract(to, from);
    let (w0, end) = (root(tangent), root(end_tangent));
    let mut solutions = [[[0.0; 2]; 3]; 4];
    for (pair, w2) in solutions.chunks_exact_mut(2).zip([end, scale(end, -1.0)]) {
        // 16·w_1 = −12(w_0 + w_2) ± 4√(120 c − 15(w_0² + w_2²) + 10 w_0 w_2)
        let ends = scale(add(tangent, end_tangent), -15.0);
        let radicand = add(add(scale(chord, 120.0), ends), scale(multiply(w0, w2), 10.0));
        let (middle, difference) = (scale(add(w0, w2), -0.75), scale(root(radicand), 0.25));
        for (preimage, sign) in pair.iter_mut().zip([1.0, -1.0]) {
            *preimage = [w0, add(middle, scale(difference, sign)), w2];
        }
    }
    let finite = solutions.as_flattened().as_flattened().iter().all(|x| x.is_finite());
    if finite { Ok(solutions) } else { Err(PhError::NotFinite) }
}

/// The preimage of the PH quintic with these Bézier control points.
///
/// The points are those of a PH quintic if its legs are w_0², w_0w_1, (2w_1² + w_0w_2)/3, w_1w_2 and w_2², divided by 5; this
/// is checked to 10⁻⁹ of the longest leg.
///
/// # Errors
/// [`PhError`].
///
/// # Example
/// ```
/// use hodograph::ph::{PhError, from_control_points};
/// // w = 1 + i·t: s = (t − t³/3, t²)
/// let points = [[0.0, 0.0], [0.2, 0.0], [0.4, 0.1], [17.0 / 30.0, 0.3], [2.0 / 3.0, 0.6], [2.0 / 3.0, 1.0]];
/// let preimage = from_control_points(&points).unwrap();
/// let exact = [[1.0, 0.0], [1.0, 0.5], [1.0, 1.0]];
/// for (found, exact) in preimage.as_flattened().iter().zip(exact.as_flattened()) {
///     assert!((found - exact).abs() < 1e-12);
/// }
/// let mut other = points;
/// other[3][0] += 0.1;
/// assert_eq!(from_control_points(&other), Err(PhError::NotPh));
/// ```
pub fn from_control_points(points: &[[f64; 2]; 6]) -> Result<Preimage, PhError> {
    let mut legs = [[0.0; 2]; 5];
    for (leg, pair) in legs.iter_mut().zip(points.windows(2)) {
        *leg = scale(subtract(pair[1], pair[0]), 5.0);
    }
    let [first, second, third, fourth, last] = legs;
    if !legs.as_flattened().iter().all(|x| x.is_finite()) {
        return Err(PhError::NotFinite);
    }
    if first == [0.0; 2] || last == [0.0; 2] {
        return Err(PhError::ZeroTangent);
    }
    let w0 = root(first);
    let w1 = divide(second, w0);
    let end = root(last);
    // Of both signs the one that fits.
    let misfit = |w2: Complex| {
        let middle = scale(add(scale(multiply(w1, w1), 2.0), multiply(w0, w2)), 1.0 / 3.0);
        let (a, b) = (subtract(middle, third), subtract(multiply(w1, w2), fourth));
        dot(a, a) + dot(b, b)
    };
    let (plus, minus) = (misfit(end), misfit(scale(end, -1.0)));
    let (error, w2) = if plus <= minus { (plus, end) } else { (minus, scale(end, -1.0)) };
    let longest = legs.iter().fold(0.0, |longest: f64, leg| longest.max(dot(*leg, *leg)));
    // NaN fits nothing.
    if error <= longest * 1e-18 { Ok([w0, w1, w2]) } else { Err(PhError::NotPh) }
}

/// How far the tangent of the curve turns, ∫|θ'| for θ = arg w² on \[0, 1\], in radians.
#[must_use]
pub fn rotation(preimage: &Preimage) -> f64 {
    let [w0, w1, w2] = *preimage;
    // The curvature changes its sign with Im(w̄w'), whose Bernstein coefficients these are.
    let [a, b, c] = [cross(w0, w1), 0.5 * cross(w0, w2), cross(w1, w2)];
    let mut ends = inflections(a, b, c);
    ends.sort_unstable_by(f64::total_cmp);
    let mut turned = 0.0;
    let (mut start, mut rest) = (0.0, *preimage);
    for end in ends {
        if end <= start || end >= 1.0 {
            continue;
        }
        let (before, after) = split(&rest, (end - start) / (1.0 - start));
        turned += angle(&before, 32).abs();
        (start, rest) = (end, after);
    }
    2.0 * (turned + angle(&rest, 32).abs())
}

/// The zeros of the polynomial with these Bernstein coefficients, as far as there are real ones; others are infinite.
fn inflections(a: f64, b: f64, c: f64) -> [f64; 2] {
    // In x = t/(1 − t): a + 2b·x + c·x² = 0
    let discriminant = b * b - a * c;
    if discriminant < 0.0 {
        return [f64::INFINITY; 2];
    }
    let q = -(b + if b < 0.0 { -sqrt(discriminant) } else { sqrt(discriminant) });
    // x = q/c and a/q; t = x/(1 + x)
    [q / (q + c), a / (a + q)].map(|t| if t.is_finite() { t } else { f64::INFINITY })
}

/// How far w turns on \[0, 1\], with its sign; halved until it is certain to turn by less than a right angle.
fn angle(w: &Preimage, depth: u32) -> f64 {
    let [w0, w1, w2] = *w;
    let acute = dot(w0, w1) > 0.0 && dot(w1, w2) > 0.0 && dot(w0, w2) > 0.0;
    if acute || depth == 0 {
        return atan2(cross(w0, w2), dot(w0, w2));
    }
    let (before, after) = split(w, 0.5);
    angle(&before, depth - 1) + angle(&after, depth - 1)
}

/// Both parts of the polynomial at t, by de Casteljau's scheme.
fn split([w0, w1, w2]: &Preimage, t: f64) -> (Preimage, Preimage) {
    let between = |a: Complex, b: Complex| add(scale(a, 1.0 - t), scale(b, t));
    let (left, right) = (between(*w0, *w1), between(*w1, *w2));
    let middle = between(left, right);
    ([*w0, left, middle], [middle, right, *w2])
}

/// The square root with nonnegative real part.
fn root([x, y]: Complex) -> Complex {
    let size = x.abs().max(y.abs());
    if size == 0.0 {
        return [0.0; 2];
    }
    // √z = √size·√(z/size), where nothing overflows.
    let (x, y) = (x / size, y / size);
    let large = sqrt(0.5 * (x.abs() + sqrt(x * x + y * y)));
    let small = 0.5 * y / large;
    let factor = sqrt(size);
    let [re, im] = if x >= 0.0 {
        [large, small]
    } else if y < 0.0 {
        [-small, -large]
    } else {
        [small, large]
    };
    [factor * re, factor * im]
}

fn add(a: Complex, b: Complex) -> Complex {
    [a[0] + b[0], a[1] + b[1]]
}

fn subtract(a: Complex, b: Complex) -> Complex {
    [a[0] - b[0], a[1] - b[1]]
}

fn scale(a: Complex, factor: f64) -> Complex {
    a.map(|x| x * factor)
}

fn multiply(a: Complex, b: Complex) -> Complex {
    [a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]]
}

fn divide(a: Complex, b: Complex) -> Complex {
    let square = dot(b, b);
    [dot(a, b) / square, cross(b, a) / square]
}

fn dot(a: Complex, b: Complex) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

fn cross(a: Complex, b: Complex) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

#[cfg(test)]
mod tests {
    use super::{PhError, Preimage, hermite, hermite_solutions, multiply, root, rotation};

    /// 15·(s(1) − s(0))
    fn chord([w0, w1, w2]: &Preimage) -> [f64; 2] {
        let terms = [
            (3.0, *w0, *w0),
            (3.0, *w0, *w1),
            (2.0, *w1, *w1),
            (1.0, *w0, *w2),
            (3.0, *w1, *w2),
            (3.0, *w2, *w2),
        ];
        terms.iter().fold([0.0; 2], |[x, y], (factor, a, b)| {
            let [p, q] = multiply(*a, *b);
            [x + factor * p, y + factor * q]
        })
    }

    #[test]
    fn data_are_met_to_the_stated_accuracy() {
        let mut state = 1995_u64;
        let mut number = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
        };
        let mut largest: f64 = 0.0;
        for k in 0..20_000 {
            let (tangent, end) = ([number(), number()], [number(), number()]);
            let mut to = [4.0 * number(), 4.0 * number()];
            if k % 2 == 0 {
                // Two of the curves coincide but for rounding: 120 c = 15(w_0² + w_2²) − 10 w_0 w_2.
                let product = multiply(root(tangent), root(end));
                to = [0, 1].map(|i| (15.0 * (tangent[i] + end[i]) - 10.0 * product[i]) / 120.0);
            }
            let length = |[x, y]: [f64; 2]| (x * x + y * y).sqrt();
            let size = length(to).max(length(tangent)).max(length(end));
            for preimage in hermite_solutions([0.0; 2], tangent, to, end).unwrap() {
                let [x, y] = chord(&preimage);
                largest = largest.max(length([x / 15.0 - to[0], y / 15.0 - to[1]]) / size);
                let [[a, b], _, [c, d]] = preimage.map(|w| multiply(w, w));
                largest = largest.max(length([a - tangent[0], b - tangent[1]]) / size);
                largest = largest.max(length([c - end[0], d - end[1]]) / size);
            }
        }
        let units = largest * 2.0 / f64::EPSILON;
        assert!((1.0..=64.0).contains(&units), "{units} units");
    }

    #[test]
    fn solutions_interpolate() {
        let data = [
            ([0.0, 0.0], [0.0, 4.0], [2.0, 2.0], [4.0, 0.0]),
            ([0.0, 0.0], [-2.0, 0.0], [0.0, 1.0], [2.0, 0.0]),
            ([-3.0, 1.0], [1e-3, -2.0], [5.0, 7.0], [-3.0, -3.0]),
        ];
        for (from, tangent, to, end) in data {
            for preimage in hermite_solutions(from, tangent, to, end).unwrap() {
                let [x, y] = chord(&preimage);
                assert!((x - 15.0 * (to[0] - from[0])).abs() < 1e-12, "{preimage:?}");
                assert!((y - 15.0 * (to[1] - from[1])).abs() < 1e-12, "{preimage:?}");
                for (w, tangent) in [(preimage[0], tangent), (preimage[2], end)] {
                    let [x, y] = multiply(w, w);
                    assert!((x - tangent[0]).abs() < 1e-14 && (y - tangent[1]).abs() < 1e-14);
                }
            }
        }
    }

    #[test]
    fn the_chosen_solution_turns_least() {
        let preimage = hermite([0.0, 0.0], [0.0, 4.0], [2.0, 2.0], [4.0, 0.0]).unwrap();
        // The curve of Example 2 turns by a right angle without inflection.
        assert!((rotation(&preimage) - core::f64::consts::FRAC_PI_2).abs() < 1e-12);
        let preimage = hermite([0.0, 0.0], [-2.0, 0.0], [0.0, 1.0], [2.0, 0.0]).unwrap();
        assert!((rotation(&preimage) - core::f64::consts::PI).abs() < 1e-12);
    }

    #[test]
    fn turning_back_counts() {
        // w = 1 + i·t(1 − t) turns by arctan(1/4) and back.
        let turned = rotation(&[[1.0, 0.0], [1.0, 0.5], [1.0, 0.0]]);
        assert!((turned - 4.0 * 0.25_f64.atan()).abs() < 1e-14, "{turned}");
        // Once around: w = e^(iφ)-like with three right angles.
        assert!(rotation(&[[1.0, 0.0], [-4.0, 4.0], [1.0, -1.0]]) > 2.0);
    }

    #[test]
    fn bad_data_are_told() {
        assert_eq!(hermite([0.0; 2], [0.0; 2], [1.0, 0.0], [1.0, 0.0]), Err(PhError::ZeroTangent));
        assert_eq!(hermite([f64::NAN, 0.0], [1.0, 0.0], [1.0, 0.0], [1.0, 0.0]), Err(PhError::NotFinite));
        assert_eq!(hermite([0.0; 2], [1.0, 0.0], [f64::MAX, 0.0], [1.0, 0.0]), Err(PhError::NotFinite));
    }

    #[test]
    fn roots_are_principal() {
        let roots = [([4.0, 0.0], [2.0, 0.0]), ([-4.0, 0.0], [0.0, 2.0]), ([0.0, -2.0], [1.0, -1.0])];
        for (z, [x, y]) in roots {
            let [re, im] = root(z);
            assert!((re - x).abs() < 1e-15 && (im - y).abs() < 1e-15, "{z:?}");
        }
        assert_eq!(root([1e300, 0.0]), [1e150, 0.0]);
        assert_eq!(root([0.0, 0.0]), [0.0, 0.0]);
    }
}
