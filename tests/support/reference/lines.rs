//! Values along a projected segment. On the screen, 1/z is linear along the segment.

use super::clip::{ALL_PLANES, ClipVertex, Plane, segment};
use super::distance::{closest, to_segment};
use super::view::View;

/// The depth at fraction `q` on the screen between depths z0 and z1: 1/z is linear in q.
pub fn depth(z0: f64, z1: f64, q: f64) -> f64 {
    1. / (1. / z0 + q * (1. / z1 - 1. / z0))
}

/// The fraction in space of the point at fraction `q` on the screen.
pub fn fraction_in_space(z0: f64, z1: f64, q: f64) -> f64 {
    q * z0 / (z1 - q * (z1 - z0))
}

/// The fraction on the screen of the point at fraction `t` in space.
pub fn fraction_on_screen(z0: f64, z1: f64, t: f64) -> f64 {
    t * z1 / (z0 + t * (z1 - z0))
}

/// Linear interpolation: a at q = 0, b at q = 1.
pub fn lerp(a: f64, b: f64, q: f64) -> f64 {
    a + q * (b - a)
}

/// The fraction in space of the point at `q` on the screen, from homogeneous w: q / lerp(w1/w0, 1, q).
pub fn homogeneous_fraction(w0: f64, w1: f64, q: f64) -> f64 {
    q / lerp(w1 / w0, 1., q)
}

/// The perspective-correct value at `q` on the screen: lerp(a/w0, b/w1, q) / lerp(1/w0, 1/w1, q).
pub fn interpolate(a: f64, b: f64, w0: f64, w1: f64, q: f64) -> f64 {
    lerp(a / w0, b / w1, q) / lerp(1. / w0, 1. / w1, q)
}

/// A segment on the screen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line<const N: usize> {
    /// Ends in pixels.
    pub screen: [[f64; 2]; 2],
    /// Homogeneous w at the ends.
    pub w: [f64; 2],
    /// Distance ahead of the eye at the ends.
    pub distance: [f64; 2],
    /// Attributes at the ends.
    pub attributes: [[f64; N]; 2],
}

/// The values of a line at one point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LineValue<const N: usize> {
    /// Position in pixels.
    pub screen: [f64; 2],
    /// Homogeneous w.
    pub w: f64,
    /// Distance ahead of the eye.
    pub distance: f64,
    /// Attributes.
    pub attributes: [f64; N],
}

impl<const N: usize> Line<N> {
    /// A segment of clip space, clipped to the six planes; `None` if it misses the view volume.
    pub fn new(ends: [ClipVertex<N>; 2], view: &View) -> Option<Self> {
        Self::clipped(ends, view, &ALL_PLANES)
    }

    /// A segment of clip space, clipped to `planes`, which must keep w positive.
    pub fn clipped(ends: [ClipVertex<N>; 2], view: &View, planes: &[Plane]) -> Option<Self> {
        let ends = segment(ends, planes)?;
        let places = ends.map(|end| view.on_screen(end.position));
        Some(Self {
            screen: places.map(|place| place.screen),
            w: places.map(|place| place.w),
            distance: places.map(|place| place.distance),
            attributes: ends.map(|end| end.attributes),
        })
    }

    /// The values at fraction `q` of the way on the screen.
    pub fn at(&self, q: f64) -> LineValue<N> {
        let [w0, w1] = self.w;
        let value = |a: f64, b: f64| interpolate(a, b, w0, w1, q);
        LineValue {
            screen: std::array::from_fn(|i| lerp(self.screen[0][i], self.screen[1][i], q)),
            w: value(w0, w1),
            distance: value(self.distance[0], self.distance[1]),
            attributes: std::array::from_fn(|i| {
                value(self.attributes[0][i], self.attributes[1][i])
            }),
        }
    }

    /// The fraction at which the infinite line reaches this x (axis 0) or y (axis 1) in pixels. A line is drawn with
    /// this fraction, column by column or row by row. The fraction is infinite or NaN if the line is parallel to the
    /// other axis.
    pub fn fraction_at(&self, axis: usize, at: f64) -> f64 {
        let [start, end] = self.screen.map(|point| point[axis]);
        (at - start) / (end - start)
    }

    /// The fraction along the line on the screen, from 0 to 1, at which the line is closest to a point in pixels.
    pub fn closest(&self, p: [f64; 2]) -> f64 {
        closest(self.screen[0], self.screen[1], p)
    }
}

/// The share of a pixel that an anti-aliased line covers. The share is computed as if the line's border were parallel
/// to a side of the pixel: the part of the pixel's width that is at most half of the line's width from the segment.
pub fn share(ends: [[f64; 2]; 2], width: f64, center: [f64; 2]) -> f64 {
    let [a, b] = ends;
    (width / 2. + 0.5 - to_segment(a, b, center)).clamp(0., 1.)
}
