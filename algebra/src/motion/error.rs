//! Why there is no motion through given frames.

use std::fmt;

use crate::Poly;

/// The largest number of frames of one motion.
pub const MAX_FRAMES: usize = 64;

/// Why there is no motion through given frames. Frames are counted from 1 in the messages.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum MotionError {
    /// Fewer than two frames.
    TooFew(usize),
    /// More than [`MAX_FRAMES`] frames.
    TooMany(usize),
    /// The quaternion of a frame is zero.
    ZeroQuaternion {
        /// The index of the frame.
        frame: usize,
    },
    /// The quaternion of a frame does not have the length 1.
    NotUnit {
        /// The index of the frame.
        frame: usize,
        /// The squared length.
        norm2: Poly,
    },
    /// The scale of a frame is zero or negative.
    Scale {
        /// The index of the frame.
        frame: usize,
    },
    /// A frame is the one before it once more.
    Repeated {
        /// The index of the second of them.
        frame: usize,
    },
    /// More or fewer knots than frames.
    KnotCount {
        /// How many knots there are.
        knots: usize,
        /// How many frames there are.
        frames: usize,
    },
    /// A knot is not greater than the one before it.
    KnotOrder {
        /// The index of the knot.
        knot: usize,
    },
    /// The motion is to be periodic, but the last frame is not the first one.
    Open,
    /// The motion is to be periodic, but the last quaternion of the shortest arcs is the negative of the first one, and their
    /// points in 4-space differ.
    OppositeSheet,
    /// The spline cannot have these ends.
    Ends,
}

impl MotionError {
    /// The index of the frame that it is about, if it is about one.
    #[must_use]
    pub fn frame(&self) -> Option<usize> {
        match self {
            MotionError::ZeroQuaternion { frame }
            | MotionError::NotUnit { frame, .. }
            | MotionError::Scale { frame }
            | MotionError::Repeated { frame } => Some(*frame),
            _ => None,
        }
    }
}

impl fmt::Display for MotionError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            MotionError::TooFew(frames) => {
                write!(f, "a motion needs two frames at least, and here {} {frames}", are(*frames))
            }
            MotionError::TooMany(frames) => {
                write!(f, "{frames} frames are more than the limit of {MAX_FRAMES}")
            }
            MotionError::ZeroQuaternion { frame } => {
                write!(f, "the quaternion of frame {} is zero, so it has no orientation", frame + 1)
            }
            MotionError::NotUnit { frame, norm2 } => {
                write!(f, "the quaternion q of frame {} is no unit quaternion: |q|² = {norm2}", frame + 1)
            }
            MotionError::Scale { frame } => write!(f, "the scale of frame {} is not positive", frame + 1),
            MotionError::Repeated { frame } => {
                write!(f, "frame {} is the same as frame {frame}", frame + 1)
            }
            MotionError::KnotCount { knots, frames } => {
                write!(f, "there {} {knots} knots for {frames} frames", are(*knots))
            }
            MotionError::KnotOrder { knot } => {
                write!(f, "knot {} is not greater than the one before it", knot + 1)
            }
            MotionError::Open => f.write_str("the last frame is not the first one, so the motion is not closed"),
            MotionError::OppositeSheet => f.write_str(
                "along the shortest arcs the last quaternion is the negative of the first one, so their points in \
                 4-space differ",
            ),
            MotionError::Ends => f.write_str("a quadratic spline cannot close, and has one free derivative only"),
        }
    }
}

impl std::error::Error for MotionError {}

fn are(count: usize) -> &'static str {
    if count == 1 { "is" } else { "are" }
}
