//! Draws surfaces of the catalogue as an SVG picture on standard output: `picture.svg` beside the package's manifest.

use std::fmt::Write;

use hodograph::{Surface, Sweep, Undefined, Variant, catalogue};

/// Facets along each parameter.
const FACETS: usize = 18;
/// An orthonormal frame: right, up, and toward the eye.
const VIEW: [[f64; 3]; 3] = [[0.8, -0.6, 0.0], [0.36, 0.48, 0.8], [-0.48, -0.64, 0.6]];
/// Where the light comes from, in space.
const LIGHT: [f64; 3] = [0.0, -0.6, 0.8];
/// Width of a panel, and its height without the caption.
const PANEL: [f64; 2] = [300.0, 250.0];

fn main() -> Result<(), Undefined> {
    print!("{}", picture()?);
    Ok(())
}

fn picture() -> Result<String, Undefined> {
    use catalogue::{
        offset_translation_example_3, oriented_translation_example_2, scaled_rotation_example_1,
    };
    // The same on every machine.
    let rotation = scaled_rotation_example_1::ScaledRotationExample1.pinned(Variant::Plain);
    let translation = oriented_translation_example_2::OrientedTranslationExample2.pinned(Variant::Plain);
    let offset = offset_translation_example_3::OffsetTranslationExample3.pinned(Variant::Plain);
    let panels: [(&dyn Surface, &str, &str); 3] = [
        (&rotation, "scaled rotation", "#3b7a57"),
        (&translation, "oriented translation", "#2f5d8a"),
        (&offset, "offset translation", "#8a4b2f"),
    ];
    let [width, height] = [PANEL[0] * panels.len() as f64, PANEL[1] + 30.0];
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" font-family=\"sans-serif\">\n\
         <rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n"
    );
    for (index, (surface, caption, color)) in panels.into_iter().enumerate() {
        let left = PANEL[0] * index as f64;
        let (m, n) = surface.degree();
        let center = left + PANEL[0] / 2.0;
        draw(&mut svg, surface, left, color)?;
        let bottom = PANEL[1] + 14.0;
        let text = format!("{caption}, degree ({m}, {n})");
        let line = format!(
            "<text x=\"{center}\" y=\"{bottom}\" text-anchor=\"middle\" font-size=\"13\" fill=\"#333\">{text}</text>"
        );
        svg.push_str(&line);
        svg.push('\n');
    }
    svg.push_str("</svg>\n");
    Ok(svg)
}

/// One facet: its distance to the eye, corners on the page, and how much light it gets.
struct Facet {
    depth: f64,
    corners: [[f64; 2]; 4],
    light: f64,
}

fn draw(svg: &mut String, surface: &dyn Surface, left: f64, color: &str) -> Result<(), Undefined> {
    let at = |i: usize, j: usize| {
        let share = |k: usize| k as f64 / FACETS as f64;
        surface.domain().at(share(i), share(j))
    };
    let page = |point: [f64; 3]| [dot(VIEW[0], point), -dot(VIEW[1], point)];
    let mut facets = Vec::new();
    for i in 0..FACETS {
        for j in 0..FACETS {
            let mut corners = [[0.0; 3]; 4];
            for (corner, (i, j)) in corners.iter_mut().zip([(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)]) {
                let (u, v) = at(i, j);
                *corner = surface.point(u, v)?;
            }
            let sum =
                corners.iter().fold([0.0; 3], |sum, corner| [0, 1, 2].map(|axis| sum[axis] + corner[axis]));
            let (u0, v0) = at(i, j);
            let (u1, v1) = at(i + 1, j + 1);
            let normal = surface.unit_normal((u0 + u1) / 2.0, (v0 + v1) / 2.0);
            let light = normal.map_or(0.0, |normal| dot(normal, LIGHT).abs());
            facets.push(Facet { depth: dot(VIEW[2], sum), corners: corners.map(page), light });
        }
    }
    facets.sort_by(|a, b| a.depth.total_cmp(&b.depth));
    let corners = || facets.iter().flat_map(|facet| facet.corners);
    let range = |axis: usize| {
        let least = corners().map(|corner| corner[axis]).fold(f64::INFINITY, f64::min);
        let most = corners().map(|corner| corner[axis]).fold(f64::NEG_INFINITY, f64::max);
        (least, most)
    };
    let [(x0, x1), (y0, y1)] = [range(0), range(1)];
    let margin = 24.0;
    let scale = ((PANEL[0] - 2.0 * margin) / (x1 - x0)).min((PANEL[1] - 2.0 * margin) / (y1 - y0));
    let place = |[x, y]: [f64; 2]| {
        let x = left + PANEL[0] / 2.0 + scale * (x - (x0 + x1) / 2.0);
        let y = PANEL[1] / 2.0 + scale * (y - (y0 + y1) / 2.0);
        format!("{x:.1},{y:.1}")
    };
    for facet in &facets {
        let points = facet.corners.map(place).join(" ");
        let shade = 0.25 + 0.75 * facet.light;
        // A white facet shines through the colored one as much as there is light.
        let opacity = 1.0 - 0.6 * shade;
        let line = format!(
            "<polygon points=\"{points}\" fill=\"{color}\" fill-opacity=\"{opacity:.2}\" stroke=\"{color}\" \
             stroke-width=\"0.3\"/>"
        );
        let _ = writeln!(svg, "<polygon points=\"{points}\" fill=\"white\"/>{line}");
    }
    Ok(())
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_picture_in_the_package_is_this_one() {
        let expected = include_str!("../picture.svg");
        assert!(
            super::picture().as_deref() == Ok(expected),
            "run `cargo run -p hodograph --example picture > generated/picture.svg` in the workspace"
        );
    }
}
