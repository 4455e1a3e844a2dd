//! Splines and motions against what defines them: interpolation, continuity, ends, and rotations.

#[path = "support/config.rs"]
mod config;

use std::collections::BTreeMap;

use config::config;
use hodograph_algebra::{
    Ends, Fraction, Frame, Lift, Motion, MotionEnds, MotionError, MotionOptions, Orientation, Poly,
    Smoothness, Spline, Variable, Vector, bernstein_product, bernstein_sum, integer, ratio,
};
use proptest::prelude::*;

fn parameter() -> Variable {
    Variable::new(1, "v")
}

fn numbers(values: &[i64]) -> Vec<Poly> {
    values.iter().map(|&value| Poly::integer(value)).collect()
}

/// The n-th derivative at a number.
fn derivative(poly: &Poly, n: usize, at: &Poly) -> Poly {
    let v = parameter();
    (0..n).fold(poly.clone(), |poly, _| poly.derivative(&v)).evaluate(&BTreeMap::from([(v, at.clone())]))
}

/// Increasing knots, and points of two coordinates.
fn data() -> impl Strategy<Value = (Vec<Poly>, Vec<Vec<Poly>>)> {
    prop::collection::vec((1_i64..4, -5_i64..6, -5_i64..6), 2..7).prop_map(|steps| {
        let mut knot = 0;
        let knots = steps.iter().map(|(step, ..)| {
            knot += step;
            Poly::integer(knot)
        });
        let knots = knots.collect();
        (knots, steps.iter().map(|(_, x, y)| numbers(&[*x, *y])).collect())
    })
}

proptest! {
    #![proptest_config(config(24))]

    #[test]
    fn splines_interpolate_and_are_smooth((knots, points) in data(), cubic: bool) {
        let smoothness = if cubic { Smoothness::Cubic } else { Smoothness::Quadratic };
        let spline = Spline::through(&knots, &points, smoothness, &Ends::Natural).unwrap();
        let v = parameter();
        let pieces: Vec<Vec<Poly>> = (1..knots.len()).map(|i| spline.polynomials(i - 1, &v)).collect();
        for (i, piece) in pieces.iter().enumerate() {
            for (axis, poly) in piece.iter().enumerate() {
                prop_assert!(poly.degree(&v).unwrap_or(0) as usize <= smoothness.degree());
                prop_assert_eq!(&derivative(poly, 0, &knots[i]), &points[i][axis]);
                prop_assert_eq!(&derivative(poly, 0, &knots[i + 1]), &points[i + 1][axis]);
                if let Some(next) = pieces.get(i + 1) {
                    for order in 1..smoothness.degree() {
                        let [left, right] = [poly, &next[axis]].map(|poly| derivative(poly, order, &knots[i + 1]));
                        prop_assert_eq!(left, right);
                    }
                }
            }
        }
        if cubic {
            for axis in 0..2 {
                let last = pieces.len() - 1;
                prop_assert!(derivative(&pieces[0][axis], 2, &knots[0]).is_zero());
                prop_assert!(derivative(&pieces[last][axis], 2, &knots[last + 1]).is_zero());
            }
        }
    }

    #[test]
    fn natural_quadratic_splines_bend_least((knots, points) in data(), change in 1_i64..4) {
        let bending = |ends: &Ends| {
            let spline = Spline::through(&knots, &points, Smoothness::Quadratic, ends).unwrap();
            let v = parameter();
            let piece = |i: usize| {
                let second = derivative(&spline.polynomials(i, &v)[0], 2, &knots[i]);
                &second * &second * (&knots[i + 1] - &knots[i])
            };
            (0..knots.len() - 1).map(piece).fold(Poly::zero(), |sum, part| sum + part)
        };
        let natural = Spline::through(&knots, &points, Smoothness::Quadratic, &Ends::Natural).unwrap();
        let start = derivative(&natural.polynomials(0, &parameter())[0], 1, &knots[0]);
        for sign in [-1, 1] {
            let other = vec![&start + Poly::constant(ratio(sign, change)), Poly::zero()];
            let end = vec![Poly::zero(), Poly::zero()];
            prop_assert!(bending(&Ends::Clamped(other, end)).compare(&bending(&Ends::Natural)).is_gt());
        }
    }

    #[test]
    fn clamped_and_closed_splines_have_their_ends((knots, points) in data(), tangent in -4_i64..5) {
        let v = parameter();
        let last = knots.len() - 1;
        let ends = Ends::Clamped(numbers(&[tangent, 0]), numbers(&[0, tangent]));
        let spline = Spline::through(&knots, &points, Smoothness::Cubic, &ends).unwrap();
        prop_assert_eq!(derivative(&spline.polynomials(0, &v)[0], 1, &knots[0]), Poly::integer(tangent));
        prop_assert_eq!(derivative(&spline.polynomials(last - 1, &v)[1], 1, &knots[last]), Poly::integer(tangent));
        for opposite in [false, true] {
            let mut points = points.clone();
            points[last] = points[0].iter().map(|x| if opposite { -x } else { x.clone() }).collect();
            let spline = Spline::through(&knots, &points, Smoothness::Cubic, &Ends::Periodic { opposite }).unwrap();
            for order in 0..3 {
                let start = derivative(&spline.polynomials(0, &v)[0], order, &knots[0]);
                let end = derivative(&spline.polynomials(last - 1, &v)[0], order, &knots[last]);
                prop_assert_eq!(if opposite { -end } else { end }, start);
            }
        }
    }

    #[test]
    fn products_of_bernstein_forms(b in prop::collection::vec(-9_i64..10, 1..8), c in prop::collection::vec(-9_i64..10, 1..8)) {
        let (b, c, t) = (numbers(&b), numbers(&c), Poly::variable(&parameter()));
        let product = bernstein_sum(&bernstein_product(&b, &c), &t);
        prop_assert_eq!(product, bernstein_sum(&b, &t) * bernstein_sum(&c, &t));
    }

    #[test]
    fn motions_pass_through_their_frames(parts in prop::collection::vec((-3_i64..4, -3_i64..4, -3_i64..4, 1_i64..4), 2..5)) {
        // The square of an integer quaternion over its norm is a rational unit quaternion.
        let frames: Vec<Frame> = parts.iter().enumerate().map(|(n, &(x, y, z, w))| {
            let norm = w * w + x * x + y * y + z * z;
            let square = [w * w - x * x - y * y - z * z, 2 * w * x, 2 * w * y, 2 * w * z];
            Frame {
                position: [n as i64, x, y].map(Poly::integer),
                quaternion: square.map(|part| Poly::constant(ratio(part, norm))),
                scale: Poly::integer(1 + n as i64 % 2),
            }
        }).collect();
        let v = parameter();
        for orientation in [Orientation::Sphere, Orientation::Direct] {
            for lift in [Lift::Projective, Lift::Positive] {
                let options = MotionOptions { orientation, lift, ..MotionOptions::default() };
                let motion = Motion::through(&frames, &options).unwrap();
                for (index, frame) in frames.iter().enumerate() {
                    let segment = motion.segment(index.min(frames.len() - 2), &v);
                    let at = BTreeMap::from([(v.clone(), Fraction::from(motion.knots()[index].clone()))]);
                    let value = |vector: &Vector| vector.map(|part| part.substitute(&at).unwrap());
                    let point = Vector::new(integer(3).into(), integer(-1).into(), integer(2).into());
                    let [w, x, y, z] = frame.quaternion.clone().map(Fraction::from);
                    let rotated = hodograph_algebra::Quaternion::new(w, x, y, z).sandwich(&point);
                    prop_assert_eq!(&value(&segment.rotate(&point)), &rotated);
                    let [x, y, z] = frame.position.clone().map(Fraction::from);
                    let swept = &Vector::new(x, y, z) + &rotated.scale(&frame.scale.clone().into());
                    prop_assert_eq!(&value(&segment.sweep(&point)), &swept);
                    prop_assert_eq!(&value(&segment.published(&point)), &swept);
                    prop_assert_eq!(segment.rotate(&point).norm2(), Fraction::from(integer(14)));
                }
            }
        }
    }
}

fn frame(x: i64, quaternion: [i64; 4]) -> Frame {
    Frame {
        position: [x, 0, 0].map(Poly::integer),
        quaternion: quaternion.map(Poly::integer),
        scale: Poly::one(),
    }
}

#[test]
fn what_is_wrong_with_frames_is_told() {
    let wrong = |frames: &[Frame]| Motion::through(frames, &MotionOptions::default()).unwrap_err();
    let unit = frame(0, [0, 0, 0, 1]);
    assert_eq!(wrong(std::slice::from_ref(&unit)), MotionError::TooFew(1));
    assert_eq!(wrong(&vec![unit.clone(); 65]), MotionError::TooMany(65));
    assert_eq!(wrong(&[unit.clone(), frame(1, [0; 4])]), MotionError::ZeroQuaternion { frame: 1 });
    let error = wrong(&[unit.clone(), frame(1, [1, 1, 0, 0])]);
    assert_eq!(error.to_string(), "the quaternion q of frame 2 is no unit quaternion: |q|² = 2");
    // A quaternion and its negative are one orientation.
    assert_eq!(wrong(&[unit.clone(), frame(0, [0, 0, 0, -1])]), MotionError::Repeated { frame: 1 });
    let flat = Frame { scale: Poly::zero(), ..frame(1, [0, 1, 0, 0]) };
    assert_eq!(wrong(&[unit.clone(), flat]), MotionError::Scale { frame: 1 });
    let with = |options: MotionOptions| {
        let frames = [unit.clone(), frame(1, [0, 1, 0, 0]), frame(0, [0, 0, 0, -1])];
        Motion::through(&frames, &options).unwrap_err()
    };
    let options = MotionOptions::default();
    assert_eq!(
        with(MotionOptions { knots: Some(numbers(&[0, 1])), ..options.clone() }),
        MotionError::KnotCount { knots: 2, frames: 3 },
    );
    assert_eq!(
        with(MotionOptions { knots: Some(numbers(&[0, 1, 1])), ..options.clone() }),
        MotionError::KnotOrder { knot: 2 },
    );
    let smoothness = [Smoothness::Quadratic; 3];
    assert_eq!(
        with(MotionOptions { ends: MotionEnds::AtRest, smoothness, ..options.clone() }),
        MotionError::Ends,
    );
    let open = [unit.clone(), frame(1, [0, 1, 0, 0])];
    let periodic = MotionOptions { ends: MotionEnds::Periodic, ..options };
    assert_eq!(Motion::through(&open, &periodic).unwrap_err(), MotionError::Open);
}

#[test]
fn quaternions_are_normalized_on_demand() {
    let frames = [frame(0, [0, 0, 0, 1]), frame(1, [1, 1, 0, 0])];
    let options = MotionOptions { normalize: true, ..MotionOptions::default() };
    let v = parameter();
    let segment = Motion::through(&frames, &options).unwrap().segment(0, &v);
    let at = BTreeMap::from([(v, Fraction::one())]);
    let turned = segment.rotate(&Vector::unit(1)).map(|part| part.substitute(&at).unwrap());
    assert_eq!(turned, Vector::unit(2));
}

#[test]
fn a_pole_between_others_takes_the_mean_of_their_points() {
    let [up, down] = [[(4, 5), (3, 5)], [(4, 5), (-3, 5)]].map(|[w, x]| {
        let [w, x] = [w, x].map(|(n, d)| Poly::constant(ratio(n, d)));
        Frame { quaternion: [w, x, Poly::zero(), Poly::zero()], ..frame(0, [1, 0, 0, 0]) }
    });
    let frames = [up, frame(1, [1, 0, 0, 0]), down];
    let v = parameter();
    let motion = Motion::through(&frames, &MotionOptions::default()).unwrap();
    // Of both points of the third frame the nearer one is taken, on the other side of the hyperplane.
    let curve = motion.segment(1, &v).curve().clone();
    let at = |n| BTreeMap::from([(v.clone(), Fraction::from(integer(n)))]);
    let point = |n| curve.map(|part| part.substitute(&at(n)).unwrap()).to_string();
    assert_eq!([point(1), point(2)], ["(3/5, 0, 0, 0)", "(3/5, 0, 0, -1/5)"]);
    // So the orientation goes straight through the pole, and stays near it.
    let middle = motion.segment(0, &v);
    let half = BTreeMap::from([(v.clone(), Fraction::from(ratio(1, 2)))]);
    let cosine =
        middle.quaternion().map(|part| part.substitute(&half).unwrap()).scalar().to_rational().unwrap();
    assert!(cosine > ratio(9, 10) && cosine < integer(1), "{cosine}");
}
