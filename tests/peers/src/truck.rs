//! The surfaces of `truck-geometry`.

use truck_geometry::prelude::{
    BSplineSurface, Homogeneous, KnotVec, NurbsSurface, ParametricSurface, Point3, Vector3, Vector4,
};

use crate::{Evaluator, Net, Partials};

/// A patch as truck's rational B-spline surface.
#[derive(Clone, Debug)]
pub struct Truck(NurbsSurface<Vector4>);

impl Truck {
    /// The surface of a patch.
    #[must_use]
    pub fn new(net: &Net) -> Self {
        let knots = (KnotVec::bezier_knot(net.m), KnotVec::bezier_knot(net.n));
        let point = |&[w, x, y, z]: &[f64; 4]| Vector4::new(x, y, z, w);
        let points = net.rows().map(|row| row.iter().map(point).collect()).collect();
        Self(NurbsSurface::new(BSplineSurface::new(knots, points)))
    }
}

impl Evaluator for Truck {
    /// As its own `subs`, `uder`, … find them, without finding the homogeneous coordinates anew for each. Of truck 0.5.0's second
    /// derivatives those by u and by v twice lack the factor of the degree less one.
    #[inline(always)]
    fn partials(&self, order: usize, u: f64, v: f64) -> Partials<f64> {
        let mut partials = [[0.0; 3]; 6];
        let homogeneous = self.0.non_rationalized();
        let value = homogeneous.subs(u, v);
        let Point3 { x, y, z } = value.to_point();
        partials[0] = [x, y, z];
        if order > 0 {
            let (by_u, by_v) = (homogeneous.uder(u, v), homogeneous.vder(u, v));
            partials[1] = array(value.rat_der(by_u));
            partials[2] = array(value.rat_der(by_v));
            if order > 1 {
                let (degree_u, degree_v) = homogeneous.degrees();
                let by_uu = homogeneous.uuder(u, v) * (degree_u as f64 - 1.0);
                let by_vv = homogeneous.vvder(u, v) * (degree_v as f64 - 1.0);
                partials[3] = array(value.rat_der2(by_u, by_uu));
                partials[4] = array(value.rat_cross_der(by_u, by_v, homogeneous.uvder(u, v)));
                partials[5] = array(value.rat_der2(by_v, by_vv));
            }
        }
        partials
    }
}

#[inline(always)]
fn array(Vector3 { x, y, z }: Vector3) -> [f64; 3] {
    [x, y, z]
}
