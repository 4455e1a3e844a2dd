//! Motions: splines through the frames' positions, orientations and scales.

use crate::motion::error::MotionError;
use crate::motion::frame::{Frame, along_shortest_arcs, checked, dot};
use crate::motion::segment::MotionSegment;
use crate::motion::sphere::{Lift, from_sphere};
use crate::motion::spline::{Ends, Smoothness, Spline};
use crate::{Poly, Variable, integer};

/// How the orientation comes from a curve in 4-space.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Orientation {
    /// As in JW: the quaternions are lifted off the sphere by M⁻¹, a spline passes through their points, and
    /// [`onto_sphere`](crate::onto_sphere) maps it back. The rotation's degree is four times that of the spline.
    #[default]
    Sphere,
    /// A spline through the quaternions themselves, which is not on the sphere between them, and its homogeneous
    /// Euler–Rodrigues matrix. The rotation's degree is twice that of the spline.
    Direct,
}

/// How a motion ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum MotionEnds {
    /// All splines are natural.
    #[default]
    Natural,
    /// All derivatives are zero.
    AtRest,
    /// The last frame is the first one, where the motion goes on smoothly.
    Periodic,
}

/// The choices that a motion through frames leaves.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct MotionOptions {
    /// The parameter at each frame; 0, 1, 2, … without.
    pub knots: Option<Vec<Poly>>,
    /// How the orientation is interpolated.
    pub orientation: Orientation,
    /// Which points of 4-space stand for the quaternions, for [`Orientation::Sphere`].
    pub lift: Lift,
    /// The splines of position, orientation and scale.
    pub smoothness: [Smoothness; 3],
    /// The ends of all three splines.
    pub ends: MotionEnds,
    /// The derivatives of the position at both ends, in place of what `ends` says.
    pub tangents: Option<[[Poly; 3]; 2]>,
    /// Whether quaternions of other lengths than 1 are divided by them.
    pub normalize: bool,
}

impl Default for MotionOptions {
    fn default() -> MotionOptions {
        MotionOptions {
            knots: None,
            orientation: Orientation::default(),
            lift: Lift::default(),
            smoothness: [Smoothness::Cubic; 3],
            ends: MotionEnds::default(),
            tangents: None,
            normalize: false,
        }
    }
}

/// A piecewise rational motion through frames (JW sections 2 and 4).
///
/// A unit quaternion and its negative are one rotation: of both, the one is taken that is nearer to the frame before (the shortest
/// arc). The same holds in 4-space, where M maps a point and its negative to one quaternion, but for [`Lift::Positive`].
/// M⁻¹ is undefined at the pole, the quaternion 1, to which M maps the hyperplane x4 = 0: there the point is taken that
/// is the mean of the next points on both sides that are no poles, moved into the hyperplane; `(1, 0, 0, 0)` if that is zero
/// or there are none.
///
/// # Example
/// ```
/// use hodograph_algebra::{Frame, Motion, MotionOptions, Poly, Variable, Vector, ratio};
/// let frame = |x: i64, q: [(i64, i64); 4]| Frame {
///     position: [x, 0, 0].map(Poly::integer),
///     quaternion: q.map(|(n, d)| Poly::constant(ratio(n, d))),
///     scale: Poly::one(),
/// };
/// let turned = [(3, 5), (0, 1), (0, 1), (4, 5)];
/// let frames = [frame(0, [(0, 1), (0, 1), (0, 1), (1, 1)]), frame(1, turned)];
/// let motion = Motion::through(&frames, &MotionOptions::default()).unwrap();
/// let v = Variable::new(1, "v");
/// let segment = motion.segment(0, &v);
/// // The frame's rotation about the z-axis with cosine −7/25.
/// let there = segment.rotate(&Vector::unit(0)).map(|f| f.substitute(&[(v.clone(), ratio(1, 1).into())].into()).unwrap());
/// assert_eq!(there.to_string(), "(-7/25, 24/25, 0)");
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Motion {
    position: Spline,
    scale: Spline,
    curve: Spline,
    orientation: Orientation,
    is_scaled: bool,
}

impl Motion {
    /// The motion through these frames.
    ///
    /// # Errors
    /// [`MotionError`]: what is wrong with the frames, the knots or the ends.
    pub fn through(frames: &[Frame], options: &MotionOptions) -> Result<Motion, MotionError> {
        let frames = checked(frames, options.normalize)?;
        let knots = match &options.knots {
            Some(knots) => knots.clone(),
            None => (0..frames.len() as i64).map(Poly::integer).collect(),
        };
        if knots.len() != frames.len() {
            return Err(MotionError::KnotCount { knots: knots.len(), frames: frames.len() });
        }
        if let Some(index) = knots.windows(2).position(|pair| pair[0].compare(&pair[1]).is_ge()) {
            return Err(MotionError::KnotOrder { knot: index + 1 });
        }
        let quaternions = along_shortest_arcs(&frames);
        let (first, last) = (&frames[0], &frames[frames.len() - 1]);
        let mut opposite = false;
        if options.ends == MotionEnds::Periodic {
            if !first.is_same(last) {
                return Err(MotionError::Open);
            }
            opposite = quaternions[0] != quaternions[quaternions.len() - 1];
            if opposite && options.orientation == Orientation::Sphere {
                return Err(MotionError::OppositeSheet);
            }
        }
        let ends = |dimension: usize, opposite: bool| match options.ends {
            MotionEnds::Natural => Ends::Natural,
            MotionEnds::AtRest => Ends::Clamped(vec![Poly::zero(); dimension], vec![Poly::zero(); dimension]),
            MotionEnds::Periodic => Ends::Periodic { opposite },
        };
        let [of_position, of_orientation, of_scale] = options.smoothness;
        let position_ends = match &options.tangents {
            Some([start, end]) => Ends::Clamped(start.to_vec(), end.to_vec()),
            None => ends(3, false),
        };
        let both = options.tangents.is_some() || options.ends == MotionEnds::AtRest;
        if both && (of_position == Smoothness::Quadratic)
            || options.ends == MotionEnds::AtRest && options.smoothness.contains(&Smoothness::Quadratic)
        {
            return Err(MotionError::Ends);
        }
        let points = match options.orientation {
            Orientation::Sphere => lifted(&quaternions, options.lift),
            Orientation::Direct => quaternions.into_iter().map(Vec::from).collect(),
        };
        let positions: Vec<Vec<Poly>> = frames.iter().map(|frame| frame.position.to_vec()).collect();
        let scales: Vec<Vec<Poly>> = frames.iter().map(|frame| vec![frame.scale.clone()]).collect();
        Ok(Motion {
            position: Spline::through(&knots, &positions, of_position, &position_ends)?,
            curve: Spline::through(&knots, &points, of_orientation, &ends(4, opposite))?,
            scale: Spline::through(&knots, &scales, of_scale, &ends(1, false))?,
            orientation: options.orientation,
            is_scaled: frames.iter().any(|frame| !frame.scale.is_one()),
        })
    }

    /// The parameters of the frames, in increasing order.
    #[must_use]
    pub fn knots(&self) -> &[Poly] {
        self.position.knots()
    }

    /// The number of segments, which is that of the frames less one.
    #[must_use]
    pub fn segment_count(&self) -> usize {
        self.knots().len() - 1
    }

    /// A segment as a rational motion of `variable`, which runs from its knot to the next one.
    ///
    /// # Panics
    /// If there is no such segment.
    #[must_use]
    pub fn segment(&self, index: usize, variable: &Variable) -> MotionSegment {
        let interval = self.position.interval(index).unwrap_or_else(crate::Interval::unit);
        let scale = self.is_scaled.then(|| self.scale.polynomials(index, variable).swap_remove(0));
        MotionSegment::new(
            variable,
            interval,
            self.position.polynomials(index, variable),
            scale,
            self.curve.polynomials(index, variable),
            self.orientation,
        )
    }
}

/// Points of 4-space that M maps to unit quaternions, for the pole as [`Motion`] says.
fn lifted(quaternions: &[[Poly; 4]], lift: Lift) -> Vec<Vec<Poly>> {
    let mut points: Vec<Option<[Poly; 4]>> = quaternions.iter().map(|q| from_sphere(q, lift)).collect();
    if lift != Lift::Positive {
        // M maps a point and its negative to one quaternion.
        let mut last: Option<[Poly; 4]> = None;
        for point in points.iter_mut().flatten() {
            if last.as_ref().is_some_and(|last| dot(last, point).sign().is_lt()) {
                *point = point.each_ref().map(|part| -part);
            }
            last = Some(point.clone());
        }
    }
    let point = |index: usize| {
        if let Some(point) = &points[index] {
            return point.to_vec();
        }
        let before = points[..index].iter().rev().flatten().next();
        let after = points[index..].iter().flatten().next();
        let neighbors: Vec<&[Poly; 4]> = before.into_iter().chain(after).collect();
        let share = integer(neighbors.len().max(1) as i64).recip();
        let mean =
            |axis: usize| neighbors.iter().fold(Poly::zero(), |sum, point| sum + &point[axis]).scale(&share);
        let [x, y, z] = [0, 1, 2].map(mean);
        if x.is_zero() && y.is_zero() && z.is_zero() {
            return [1, 0, 0, 0].map(Poly::integer).to_vec();
        }
        vec![x, y, z, Poly::zero()]
    };
    (0..points.len()).map(point).collect()
}
