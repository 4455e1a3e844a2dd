//! The surfaces of `curvo`.

use curvo::prelude::NurbsSurface3D;
use nalgebra::{Point3, Point4};

use crate::{Evaluator, Net, Partials};

/// A patch as curvo's rational B-spline surface.
#[derive(Clone, Debug)]
pub struct Curvo(NurbsSurface3D<f64>);

impl Curvo {
    /// The surface of a patch.
    #[must_use]
    pub fn new(net: &Net) -> Self {
        let knots = |degree: usize| [vec![0.0; degree + 1], vec![1.0; degree + 1]].concat();
        let point = |&[w, x, y, z]: &[f64; 4]| Point4::new(x, y, z, w);
        let points = net.rows().map(|row| row.iter().map(point).collect()).collect();
        Self(NurbsSurface3D::new(net.m, net.n, knots(net.m), knots(net.n), points))
    }

    /// The points of a grid of equidistant parameters by its own function for such grids, which finds the basis functions of each
    /// parameter once; the index of u is the outer one.
    #[must_use]
    pub fn regular_points(&self, columns: usize, rows: usize) -> Vec<Vec<Point3<f64>>> {
        self.0.regular_sample_points(columns - 1, rows - 1)
    }
}

impl Evaluator for Curvo {
    #[inline(always)]
    fn partials(&self, order: usize, u: f64, v: f64) -> Partials<f64> {
        let mut partials = [[0.0; 3]; 6];
        if order == 0 {
            partials[0] = self.0.point_at(u, v).coords.into();
            return partials;
        }
        // By the order in u, then in v.
        let derivatives = self.0.rational_derivatives(u, v, order);
        let places = [(0, 0), (1, 0), (0, 1), (2, 0), (1, 1), (0, 2)];
        for (partial, (i, j)) in partials.iter_mut().zip(places) {
            if i + j <= order {
                *partial = derivatives[i][j].into();
            }
        }
        partials
    }
}
