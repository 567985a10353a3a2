//! The planes that a primitive's interpolants lie in.

use super::Triangle;
use crate::num::wide::product;
use crate::span::{FAR, Plane, Run, Scale, Slope, Steps, weigh};

/// An attribute that is interpolated over a primitive.
#[derive(Clone, Copy, Debug)]
pub(super) struct Attribute {
    /// What it is at the corners of the mesh's triangle.
    pub(super) corners: [i32; 3],
    /// A triangle is drawn affinely if that takes it less than this from what is right.
    pub(super) tolerance: u32,
    /// The plane of it over w, or of itself.
    plane: Plane,
    scale: Scale,
}

/// The interpolants of a primitive: 1/w (or depth), and the attributes over w.
///
/// What is done with them is the same for any number of attributes, and code for each number would
/// be most of a small program: the methods are those of an unsized list, which this becomes.
#[derive(Debug)]
pub(super) struct Planes<P: ?Sized = [Attribute]> {
    slope: Slope,
    q: Plane,
    /// The least 1/w of a corner.
    least: u32,
    is_affine: bool,
    pub(super) p: P,
}

/// The least 1/w: what the steps of a run may take from it and add to attributes over w is less than
/// a thirty-second, which [`weigh`] leaves room for.
///
/// It only ever lifts a corner more than half a million times as far as the nearest one.
const LEAST_WEIGHT: u32 = 1 << 11;

/// The greatest 1/w: rounding may add 40 units to it, and it is to stay below 2^31.
const MOST_WEIGHT: u32 = (1 << 31) - 64;

impl Attribute {
    /// Whether it may be interpolated without regard to 1/w, which is `least` and changes by so much.
    ///
    /// With weights λ that add up to 1, the one value is Σλf, the other Σλqf / Σλq. They differ by the
    /// covariance of q and f over the mean q, which is at most a quarter of the product of their ranges by that.
    #[inline]
    fn is_affine(&self, least: u32, change: u32) -> bool {
        let [a, b, c] = self.corners;
        let (low, high) = (a.min(b).min(c), a.max(b).max(c));
        low >= -Scale::MOST_AFFINE
            && high <= Scale::MOST_AFFINE
            && product(high - low, change.cast_signed())
                < product((4 * self.tolerance).cast_signed(), least.cast_signed())
    }
}

impl Planes {
    /// Lays the planes through a triangle's corners, for attributes that are divided by w or not, of so many bits at least;
    /// gives the exponent of 1/w.
    #[inline(never)]
    pub(super) fn lay(
        &mut self,
        triangle: &Triangle<'_>,
        perspective: bool,
        least_bits: u32,
    ) -> u8 {
        let [a, b, c] = triangle.corners;
        // The corners' interpolants of depth with one exponent.
        let exponent = a.exponent.max(b.exponent).max(c.exponent);
        let q = [a, b, c].map(|corner| {
            let down = u32::from(exponent - corner.exponent);
            // Of 31 bits.
            let q = corner.q >> down.min(31);
            q.clamp(LEAST_WEIGHT, MOST_WEIGHT)
        });
        let [first, second, third] = q;
        self.least = first.min(second).min(third);
        self.slope = Slope::new([a.screen, b.screen, c.screen], triangle.area);
        let slope = &self.slope;
        slope.lay(q.map(u32::cast_signed), &mut self.q);
        let (weights, least_bits) = if !perspective {
            ([1 << 30; 3], least_bits)
        } else if self.least > FAR {
            (q, least_bits)
        } else {
            (q, 1)
        };
        let change = first.max(second).max(third) - self.least;
        self.is_affine = perspective && self.p.iter().all(|p| p.is_affine(self.least, change));
        for p in &mut self.p {
            let mut values = match triangle.weights {
                None => p.corners,
                Some(weights) => weights.map(|weights| weights.mix(&p.corners)),
            };
            p.scale = if self.is_affine {
                values = values.map(|value| value << Scale::AFFINE_UP);
                Scale::AFFINE
            } else {
                weigh(&mut values, weights, least_bits)
            };
            slope.lay(values, &mut p.plane);
        }
        exponent
    }
}

impl<const N: usize> Planes<[Attribute; N]> {
    /// Nothing to interpolate.
    pub(super) const NONE: Self = Self {
        slope: Slope::NONE,
        q: Plane::NONE,
        least: 0,
        is_affine: true,
        p: [Attribute {
            corners: [0; 3],
            tolerance: 0,
            plane: Plane::NONE,
            scale: Scale::ONE,
        }; N],
    };

    /// The interpolants `x` columns and `y` rows from the pixel that corner 0 lies in.
    #[inline]
    pub(super) fn run(&self, x: i32, y: i32) -> Run<N> {
        if self.slope.is_near() {
            return Run {
                q: self.q.near(x, y).cast_unsigned(),
                p: self.p.each_ref().map(|p| p.plane.near(x, y)),
            };
        }
        let at = |plane: &Plane| self.slope.far(plane, x, y);
        Run {
            q: at(&self.q).cast_unsigned(),
            p: self.p.each_ref().map(|p| at(&p.plane)),
        }
    }

    /// What a column adds, how the attributes are scaled, and by how much 1/w is shifted `down` to be a depth.
    #[inline]
    pub(super) fn steps(&self, down: u32) -> Steps<N> {
        Steps {
            q: self.q.step,
            p: self.p.each_ref().map(|p| p.plane.step),
            scale: self.p.each_ref().map(|p| p.scale),
            depth: down,
            least: self.least,
            is_affine: self.is_affine,
        }
    }
}
