//! The exact offsets of a surface with rational unit normal, as patches that depend on the distance linearly.

use hodograph_algebra::{Bernstein, Essentials, Poly};

use crate::round::{RoundError, nearest};

/// The Bézier form of the offsets R + r·N: homogeneous control points p + r·n, for every r.
#[derive(Clone, PartialEq, Debug)]
pub struct OffsetPatch {
    /// The patch degree, for a general r.
    pub degree: (u32, u32),
    /// The points p and the vectors n over the domain, homogeneous, rounded; the index of u is the outer one.
    pub net: Vec<[[f64; 4]; 2]>,
}

impl OffsetPatch {
    /// The patch for a derived surface whose normal's numerators have the length ρ.
    ///
    /// With g = gcd(W, ρ), the offset is (W·ρ/g, X·ρ/g + r·n_x·W/g, …), from which the factor that is common for every r is
    /// taken out.
    ///
    /// # Errors
    /// [`RoundError`] if a control point is beyond the range of floats.
    pub(crate) fn of(
        derivation: &Essentials,
        normal: &[Poly; 3],
        length: &Poly,
    ) -> Result<Option<OffsetPatch>, RoundError> {
        let [weight, coordinates @ ..] = derivation.homogeneous.coordinates();
        let common = weight.gcd(length);
        let (Some(of_weight), Some(of_length)) = (weight.exact_div(&common), length.exact_div(&common))
        else {
            return Ok(None);
        };
        let points = coordinates.iter().map(|coordinate| coordinate * &of_length);
        let mut polys: Vec<Poly> = std::iter::once(weight * &of_length).chain(points).collect();
        polys.extend(normal.iter().map(|component| component * &of_weight));
        let common = Poly::gcd_many(&polys);
        let reduced: Option<Vec<Poly>> = polys.iter().map(|poly| poly.exact_div(&common)).collect();
        let Some(mut polys) = reduced else { return Ok(None) };
        // Most offsets have the weight of the surface.
        if let Some(factor) = weight.number_quotient(&polys[0]) {
            polys.iter_mut().for_each(|poly| *poly = &*poly * &factor);
        }
        let degree = derivation.parameters.each_ref().map(|parameter| {
            let degrees = polys.iter().filter_map(|poly| poly.degree(parameter));
            degrees.max().unwrap_or(0)
        });
        let domain: Vec<_> =
            derivation.parameters.iter().cloned().zip(derivation.domain.iter().cloned()).collect();
        let length = (degree[0] as usize + 1) * (degree[1] as usize + 1);
        let mut net = vec![[[0.0; 4]; 2]; length];
        // The normal has no weight.
        let places = [(0, 0), (0, 1), (0, 2), (0, 3), (1, 1), (1, 2), (1, 3)];
        for (poly, (part, coordinate)) in polys.iter().zip(places) {
            let Some(form) = Bernstein::with_degrees(poly, &domain, &degree) else { continue };
            for (point, coefficient) in net.iter_mut().zip(form.coefficients()) {
                point[part][coordinate] = nearest(coefficient)?;
            }
        }
        Ok(Some(OffsetPatch { degree: (degree[0], degree[1]), net }))
    }
}
