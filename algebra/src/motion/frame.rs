//! Frames: where a curve is, how it is turned, and how large.

use crate::Poly;
use crate::motion::error::{MAX_FRAMES, MotionError};

/// A frame of a curve (JW Definition 1): position, orientation and scale, all numbers.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Frame {
    /// The position of the curve's reference point.
    pub position: [Poly; 3],
    /// The unit quaternion of the orientation, the scalar part first. It and its negative are the same rotation.
    pub quaternion: [Poly; 4],
    /// The size, which is positive.
    pub scale: Poly,
}

impl Frame {
    fn norm2(&self) -> Poly {
        dot(&self.quaternion, &self.quaternion)
    }

    /// Whether both put a curve into the same place.
    #[must_use]
    pub fn is_same(&self, other: &Frame) -> bool {
        let opposite = self.quaternion.each_ref().map(|part| -part);
        self.position == other.position
            && self.scale == other.scale
            && (self.quaternion == other.quaternion || opposite == other.quaternion)
    }
}

/// Checks frames one by one, and in their order; with `normalize`, quaternions of other lengths than 1 are divided by them,
/// which adjoins roots where they are no squares.
pub(crate) fn checked(frames: &[Frame], normalize: bool) -> Result<Vec<Frame>, MotionError> {
    if frames.len() < 2 {
        return Err(MotionError::TooFew(frames.len()));
    }
    if frames.len() > MAX_FRAMES {
        return Err(MotionError::TooMany(frames.len()));
    }
    let mut checked: Vec<Frame> = Vec::new();
    for (index, frame) in frames.iter().enumerate() {
        let mut frame = frame.clone();
        let norm2 = frame.norm2();
        if norm2.is_zero() {
            return Err(MotionError::ZeroQuaternion { frame: index });
        }
        if !norm2.is_one() {
            let length = if normalize { norm2.sqrt() } else { None };
            let Some(length) = length else { return Err(MotionError::NotUnit { frame: index, norm2 }) };
            let inverse = length.inverse();
            frame.quaternion = frame.quaternion.map(|part| part * &inverse);
        }
        if !frame.scale.sign().is_gt() {
            return Err(MotionError::Scale { frame: index });
        }
        if checked.last().is_some_and(|last| last.is_same(&frame)) {
            return Err(MotionError::Repeated { frame: index });
        }
        checked.push(frame);
    }
    Ok(checked)
}

/// Chooses of each quaternion and its negative, which are the same rotation, the one that is nearer to the one chosen before it:
/// the shortest arc of the sphere. The first one stays as it is, and so does one that is orthogonal to its predecessor.
pub(crate) fn along_shortest_arcs(frames: &[Frame]) -> Vec<[Poly; 4]> {
    let mut chosen: Vec<[Poly; 4]> = Vec::new();
    for frame in frames {
        let mut quaternion = frame.quaternion.clone();
        if chosen.last().is_some_and(|last| dot(last, &quaternion).sign().is_lt()) {
            quaternion = quaternion.map(|part| -part);
        }
        chosen.push(quaternion);
    }
    chosen
}

pub(crate) fn dot(a: &[Poly; 4], b: &[Poly; 4]) -> Poly {
    a.iter().zip(b).fold(Poly::zero(), |sum, (a, b)| sum + a * b)
}
