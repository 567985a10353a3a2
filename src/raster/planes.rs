//! The planes that a primitive's interpolants lie in.

use super::Triangle;
use crate::interpolate::{Plane, Run, Scale, Slope, Steps, weigh};

/// A number that is interpolated over a primitive.
#[derive(Clone, Copy, Debug)]
pub(super) struct Interpolant {
    /// The attribute at the corners of the mesh's triangle; of depth nothing.
    pub(super) corners: [i32; 3],
    scale: Scale,
    plane: Plane,
    /// What it gains from one column to the next.
    step: i32,
    /// What it is at the pixel last asked for.
    value: i32,
}

impl Interpolant {
    const NONE: Self = Self {
        corners: [0; 3],
        scale: Scale::ONE,
        plane: Plane::NONE,
        step: 0,
        value: 0,
    };

    /// Lays the plane through the values at a triangle's corners.
    #[inline(never)]
    fn lay(&mut self, slope: &Slope, values: [i32; 3]) {
        self.plane = slope.plane(values);
        self.step = slope.value(self.plane.dx());
    }

    #[inline]
    fn go(&mut self, slope: &Slope, x: i32, y: i32) {
        self.value = slope.value(self.plane.at(x, y));
    }
}

/// The interpolants of a primitive: 1/w (or depth), and the attributes over w.
///
/// What is done with them is the same for any number of attributes, and code for each number would
/// be most of a small program: the methods are those of an unsized list, which this becomes.
#[derive(Debug)]
pub(super) struct Planes<P: ?Sized = [Interpolant]> {
    slope: Slope,
    q: Interpolant,
    pub(super) p: P,
}

/// The least 1/w: what the steps of a run may take from it and add to attributes over w is less than
/// a thirty-second, which [`weigh`] leaves room for.
///
/// It only ever lifts a corner more than half a million times as far as the nearest one.
const LEAST_WEIGHT: u32 = 1 << 11;

impl Planes {
    /// Lays the planes through a triangle's corners, for attributes that are divided by w or not;
    /// gives the exponent of 1/w.
    #[inline(never)]
    pub(super) fn lay(&mut self, triangle: &Triangle<'_>, perspective: bool) -> u8 {
        let corners = triangle.corners;
        // The corners' interpolants of depth with one exponent.
        let exponent = corners
            .iter()
            .fold(0, |most, corner| corner.exponent.max(most));
        let q = corners.each_ref().map(|corner| {
            let down = u32::from(exponent - corner.exponent);
            corner.q.checked_shr(down).unwrap_or(0).max(LEAST_WEIGHT)
        });
        self.slope = Slope::new(
            corners.each_ref().map(|corner| corner.screen),
            triangle.area,
        );
        self.q.lay(&self.slope, q.map(u32::cast_signed));
        let weights = if perspective { q } else { [1 << 30; 3] };
        for p in &mut self.p {
            let mut values = match triangle.weights {
                None => p.corners,
                Some(weights) => weights.map(|weights| weights.mix(&p.corners)),
            };
            p.scale = weigh(&mut values, weights);
            p.lay(&self.slope, values);
        }
        exponent
    }

    /// Goes to the pixel `x` columns and `y` rows from the one that corner 0 lies in.
    #[inline(never)]
    pub(super) fn go(&mut self, x: i32, y: i32) {
        self.q.go(&self.slope, x, y);
        for p in &mut self.p {
            p.go(&self.slope, x, y);
        }
    }
}

impl<const N: usize> Planes<[Interpolant; N]> {
    /// Nothing to interpolate.
    pub(super) const NONE: Self = Self {
        slope: Slope::NONE,
        q: Interpolant::NONE,
        p: [Interpolant::NONE; N],
    };

    /// The interpolants at the pixel last gone to.
    #[inline]
    pub(super) fn run(&self) -> Run<N> {
        Run {
            q: self.q.value.cast_unsigned(),
            p: self.p.each_ref().map(|p| p.value),
        }
    }

    /// What a column adds, and how the attributes are scaled.
    #[inline]
    pub(super) fn steps(&self) -> Steps<N> {
        Steps {
            q: self.q.step,
            p: self.p.each_ref().map(|p| p.step),
            scale: self.p.each_ref().map(|p| p.scale),
        }
    }
}
