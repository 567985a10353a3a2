//! Distances from a point to a segment or a triangle on the screen, in pixels.

use super::coverage::{Corners, area2_f64};

/// The fraction along a segment, from 0 to 1, at which the segment is closest to `p`; 0 for a segment without length.
pub fn closest(a: [f64; 2], b: [f64; 2], p: [f64; 2]) -> f64 {
    let along = [b[0] - a[0], b[1] - a[1]];
    let square = along[0] * along[0] + along[1] * along[1];
    if square == 0. {
        return 0.;
    }
    let t = ((p[0] - a[0]) * along[0] + (p[1] - a[1]) * along[1]) / square;
    t.clamp(0., 1.)
}

/// The distance from `p` to a segment.
pub fn to_segment(a: [f64; 2], b: [f64; 2], p: [f64; 2]) -> f64 {
    let t = closest(a, b, p);
    let at = |i: usize| a[i] + t * (b[i] - a[i]) - p[i];
    let (x, y) = (at(0), at(1));
    (x * x + y * y).sqrt()
}

/// The distance from `p` to a triangle of either winding; 0 inside the triangle.
pub fn to_triangle(t: &Corners, p: [f64; 2]) -> f64 {
    let [a, b, c] = *t;
    let sign = area2_f64(t).signum();
    let sides = [[a, b], [b, c], [c, a]];
    let inside = |[from, to]: &[[f64; 2]; 2]| sign * area2_f64(&[*from, *to, p]) >= 0.;
    if area2_f64(t) != 0. && sides.iter().all(inside) {
        return 0.;
    }
    let to = |[from, to]: [[f64; 2]; 2]| to_segment(from, to, p);
    to(sides[0]).min(to(sides[1])).min(to(sides[2]))
}
