//! Perspective-correct values at a point of a triangle, and their changes from pixel to pixel.
//!
//! 1/w and attribute/w are linear on the screen. Let λᵢ be the weights of the corners, which are linear in x and y.
//! With N = Σ λᵢ aᵢ/wᵢ and D = Σ λᵢ/wᵢ, the attribute is a = N/D. By the quotient rule, ∂a/∂x = (∂N/∂x − a ∂D/∂x)/D.

use super::coverage::{Corners, Snapped, area2, area2_f64, center, center_snapped, edge};
use super::view::unsnap;

/// Barycentric weights of a triangle's corners at a point; their sum is 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Barycentric {
    /// The weights. A corner's weight is negative if the opposite edge lies between the corner and the point.
    pub value: [f64; 3],
    /// The change of the weights per pixel to the right.
    pub dx: [f64; 3],
    /// The change of the weights per pixel down.
    pub dy: [f64; 3],
}

impl Barycentric {
    /// The weights, from twice the area of the whole triangle, and twice the areas of three parts. Each part is the
    /// triangle between the point and the edge opposite a corner.
    fn new(&[a, b, c]: &Corners, opposite: [f64; 3], area: f64) -> Self {
        let over_area = |[a, b, c]: [f64; 3]| [a / area, b / area, c / area];
        Self {
            value: over_area(opposite),
            dx: over_area([b[1] - c[1], c[1] - a[1], a[1] - b[1]]),
            dy: over_area([c[0] - b[0], a[0] - c[0], b[0] - a[0]]),
        }
    }
}

/// Barycentric weights at a point; `None` for a triangle without area.
pub fn weights(t: &Corners, p: [f64; 2]) -> Option<Barycentric> {
    let area = area2_f64(t);
    if area == 0. || !area.is_finite() {
        return None;
    }
    let &[a, b, c] = t;
    let with = |from, to| area2_f64(&[from, to, p]);
    Some(Barycentric::new(
        t,
        [with(b, c), with(c, a), with(a, b)],
        area,
    ))
}

/// Barycentric weights at the center of a pixel, for snapped corners (24.8). Each weight is the quotient of two exact
/// integers. The weight is rounded three times: in both conversions to f64, and in the division.
pub fn weights_snapped(t: Snapped, pixel: [i32; 2]) -> Option<Barycentric> {
    let area = area2(t);
    if area == 0 {
        return None;
    }
    let (p, [a, b, c]) = (center_snapped(pixel), t);
    // The divisor is a power of two, so the quotient is exact.
    let in_pixels = |units: i128| units as f64 / 65536.;
    let with = |from, to| in_pixels(edge(from, to, p));
    let corners = [unsnap(a), unsnap(b), unsnap(c)];
    let opposite = [with(b, c), with(c, a), with(a, b)];
    Some(Barycentric::new(&corners, opposite, in_pixels(area)))
}

/// The values of a triangle at a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Value<const N: usize> {
    /// Homogeneous w.
    pub w: f64,
    /// The change of 1/w per pixel to the right, and per pixel down.
    pub inverse_w_gradient: [f64; 2],
    /// The attributes.
    pub attributes: [f64; N],
    /// The change of the attributes per pixel to the right, at this point.
    pub dx: [f64; N],
    /// The change of the attributes per pixel down, at this point.
    pub dy: [f64; N],
}

/// The perspective-correct value for these weights, from `w` and `attributes` at the corners.
///
/// If all w are equal, this is linear interpolation. Outside the triangle, 1/w can fall to 0. Where it is negative, the
/// value has no meaning.
pub fn interpolate<const N: usize>(
    weights: &Barycentric,
    w: [f64; 3],
    attributes: &[[f64; N]; 3],
) -> Value<N> {
    let sum =
        |weights: &[f64; 3], [a, b, c]: [f64; 3]| weights[0] * a + weights[1] * b + weights[2] * c;
    let inverse = [1. / w[0], 1. / w[1], 1. / w[2]];
    let d = sum(&weights.value, inverse);
    let (d_dx, d_dy) = (sum(&weights.dx, inverse), sum(&weights.dy, inverse));
    let [mut a, mut dx, mut dy] = [[0.; N]; 3];
    for k in 0..N {
        let over_w = [
            attributes[0][k] / w[0],
            attributes[1][k] / w[1],
            attributes[2][k] / w[2],
        ];
        a[k] = sum(&weights.value, over_w) / d;
        dx[k] = (sum(&weights.dx, over_w) - a[k] * d_dx) / d;
        dy[k] = (sum(&weights.dy, over_w) - a[k] * d_dy) / d;
    }
    Value {
        w: 1. / d,
        inverse_w_gradient: [d_dx, d_dy],
        attributes: a,
        dx,
        dy,
    }
}

/// The value at the center of a pixel, for snapped corners (24.8); `None` for a triangle without area.
pub fn at_pixel_snapped<const N: usize>(
    t: Snapped,
    w: [f64; 3],
    attributes: &[[f64; N]; 3],
    pixel: [i32; 2],
) -> Option<Value<N>> {
    weights_snapped(t, pixel).map(|weights| interpolate(&weights, w, attributes))
}

/// The value at the center of a pixel, for corners in pixels; `None` for a triangle without area.
pub fn at_pixel<const N: usize>(
    t: &Corners,
    w: [f64; 3],
    attributes: &[[f64; N]; 3],
    pixel: [i32; 2],
) -> Option<Value<N>> {
    weights(t, center(pixel)).map(|weights| interpolate(&weights, w, attributes))
}
