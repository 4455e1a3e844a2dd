//! Evaluation on the grid of two lists of parameters.

use core::fmt;

/// Why a grid could not be evaluated; nothing has been written then.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum GridError {
    /// The output holds `found` points where the grid has `expected`.
    Length {
        /// Points of the grid: the number of u parameters times that of v parameters.
        expected: usize,
        /// Points that the output holds.
        found: usize,
    },
    /// The grid has more points than a slice can hold.
    TooLarge,
}

impl fmt::Display for GridError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Length { expected, found } => {
                write!(f, "the grid has {expected} points, but the output holds {found}")
            }
            Self::TooLarge => f.write_str("the grid has more points than a slice can hold"),
        }
    }
}

impl core::error::Error for GridError {}

/// Checks that an output of `found` points is that of a grid of `us` by `vs` parameters.
///
/// # Errors
/// [`GridError::Length`] if it is not, [`GridError::TooLarge`] if no slice is.
#[inline]
pub fn check_length(us: usize, vs: usize, found: usize) -> Result<(), GridError> {
    match us.checked_mul(vs) {
        None => Err(GridError::TooLarge),
        Some(expected) if expected != found => Err(GridError::Length { expected, found }),
        Some(_) => Ok(()),
    }
}

/// Parameters u whose share of the work is held at a time; a compromise between the size of the buffer on the
/// stack and the number of times that the share of v is computed anew.
const STRIP: usize = 256;

/// Evaluates a surface at every (u, v) of a grid from three parts: what depends on u alone, on v alone, and on both.
///
/// The point at (`us[i]`, `vs[j]`) is `out[j * us.len() + i]`. The part of u is computed once for each u, that of v
/// once for each v and strip of 256 parameters u; nothing is allocated. Every point is
/// `join(&of_u(u), &of_v(v))`, so it has the bits of a single evaluation.
///
/// # Errors
/// [`GridError`] if the length of `out` is not that of the grid.
#[inline]
pub fn staged<const M: usize, const N: usize>(
    us: &[f64],
    vs: &[f64],
    out: &mut [[f64; 3]],
    of_u: impl Fn(f64) -> [f64; M],
    of_v: impl Fn(f64) -> [f64; N],
    join: impl Fn(&[f64; M], &[f64; N]) -> [f64; 3],
) -> Result<(), GridError> {
    check_length(us.len(), vs.len(), out.len())?;
    let mut strip = [[0.0; M]; STRIP];
    for (k, us_of_strip) in us.chunks(STRIP).enumerate() {
        let strip = &mut strip[..us_of_strip.len()];
        for (part, &u) in strip.iter_mut().zip(us_of_strip) {
            *part = of_u(u);
        }
        for (row, &v) in out.chunks_exact_mut(us.len()).zip(vs) {
            let part_of_v = of_v(v);
            for (point, part_of_u) in row[k * STRIP..].iter_mut().zip(strip.iter()) {
                *point = join(part_of_u, &part_of_v);
            }
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::{GridError, STRIP, check_length, staged};

    #[test]
    fn lengths_are_checked() {
        assert_eq!(check_length(3, 4, 12), Ok(()));
        assert_eq!(check_length(3, 4, 11), Err(GridError::Length { expected: 12, found: 11 }));
        assert_eq!(check_length(usize::MAX, 2, 0), Err(GridError::TooLarge));
    }

    #[test]
    fn every_point_is_written_in_its_place() {
        let join = |&[u]: &[f64; 1], &[v]: &[f64; 1]| [u, v, u * v];
        for (m, n) in [(0, 0), (0, 3), (3, 0), (1, 1), (STRIP, 2), (STRIP + 1, 3), (3 * STRIP - 1, 2)] {
            let us: std::vec::Vec<f64> = (0..m).map(|i| i as f64).collect();
            let vs: std::vec::Vec<f64> = (0..n).map(|j| 0.5 + j as f64).collect();
            let mut out = std::vec![[f64::NAN; 3]; m * n];
            assert_eq!(staged(&us, &vs, &mut out, |u| [u], |v| [v], join), Ok(()));
            for (j, &v) in vs.iter().enumerate() {
                for (i, &u) in us.iter().enumerate() {
                    assert_eq!(out[j * m + i], [u, v, u * v]);
                }
            }
        }
    }
}
