//! The space in which a model turns.

use super::{Point, basis};
use fixel_assets::vector::{along, dot, sub};

/// The number of sides of the polygon around each circle.
const SIDES: u32 = 72;

/// Returns points with a convex hull that contains `points` in every pose, while they turn around the axis through
/// `about` in the direction `up`, which has length one.
///
/// For a turn around the axis, only the radius and the height of each point matter. Only points on the convex outline
/// of all radii and heights are kept. Such a point moves along a circle, and the result has the corners of a polygon
/// around this circle. The polygon is larger than the circle by a thousandth.
pub fn swept(points: &[Point], about: Point, up: Point) -> Vec<Point> {
    let Some([right, back, _]) = [[1.0, 0.0, 0.0], [0.0, 0.0, 1.0]]
        .into_iter()
        .find_map(|aside| basis(up, aside))
    else {
        return points.to_vec();
    };
    let mut profile: Vec<[f64; 2]> = points
        .iter()
        .map(|&p| {
            let p = sub(p, about);
            [dot(p, up), dot(p, right).hypot(dot(p, back))]
        })
        .collect();
    profile.sort_by(|a, b| a[0].total_cmp(&b[0]).then(b[1].total_cmp(&a[1])));
    let mut outline: Vec<[f64; 2]> = Vec::new();
    for p in profile {
        while let [.., a, b] = outline[..] {
            // Drop point b if it lies on the line from a to p, or below this line.
            if (b[1] - a[1]) * (p[0] - a[0]) > (p[1] - a[1]) * (b[0] - a[0]) {
                break;
            }
            outline.pop();
        }
        outline.push(p);
    }
    let step = std::f64::consts::TAU / f64::from(SIDES);
    let corners = |&[height, radius]: &[f64; 2]| {
        let radius = radius / (step / 2.0).cos();
        (0..SIDES).map(move |side| {
            let (sin, cos) = (f64::from(side) * step).sin_cos();
            let aside = along(along(about, right, cos * radius), back, sin * radius);
            along(aside, up, height)
        })
    };
    outline.iter().flat_map(corners).collect()
}
