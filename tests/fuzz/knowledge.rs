//! The f64 model's triangles, and bounds on the crate's deviation from these triangles.

use fixel::prelude::*;

use support::moves::{Move, exact, product, relative, size};
use support::reference::clip::Plane;
use support::reference::projection::{Kind, Projection as ModelProjection};
use support::reference::view::{Projected, View, Viewport as ModelViewport};

/// Half of the guard band's width, in pixels.
const GUARD: f64 = 2048.;

/// The corners of a triangle, and the bounds of the crate's errors, which tests/accuracy/mvps.rs derives.
pub struct Knowledge {
    pub view: View,
    pub at: [Projected; 3],
    /// The largest coefficient of the clip coordinates: of x and y in pixels, and of depth in units in which the depth
    /// range is half of the guard band's width. (All clip coordinates have the same exponent.)
    scale: f64,
    /// For each corner: a bound on the error of its clip coordinates, divided by `scale`. The quotient has the unit of
    /// a distance.
    errors: [f64; 3],
}

impl Knowledge {
    pub fn new(
        moves: &[Move],
        projection: &ModelProjection,
        window: Viewport,
        corners: [Vec3; 3],
    ) -> Self {
        let (_, eye) = product(moves);
        let view = View {
            eye,
            projection: *projection,
            viewport: ModelViewport {
                x: window.top_left().x,
                y: window.top_left().y,
                width: window.size().width,
                height: window.size().height,
            },
        };
        let parallel = projection.kind == Kind::Parallel;
        let pixels = |axis: usize, size: u32| {
            let row = projection.matrix[axis].into_iter();
            f64::from(size) / 2. * row.fold(0., |most: f64, m| most.max(m.abs()))
        };
        let of_depth = if parallel {
            GUARD / (projection.far - projection.near)
        } else {
            GUARD
        };
        let scale = pixels(0, window.size().width)
            .max(pixels(1, window.size().height))
            .max(of_depth);
        // In a parallel projection, the offset of depth counts as a distance, too.
        let offset = if parallel {
            projection.near.abs().max(projection.far.abs()).max(1.)
        } else {
            0.
        };
        Self {
            at: corners.map(|corner| view.project(exact(corner))),
            errors: corners.map(|corner| relative(moves) * (size(moves, corner) + offset)),
            view,
            scale,
        }
    }

    pub fn is_parallel(&self) -> bool {
        self.view.projection.kind == Kind::Parallel
    }

    /// A bound on the error of a corner's distance or, in a parallel projection, of its depth as a fraction of the
    /// depth range.
    pub fn of_depth(&self, corner: usize) -> f64 {
        self.errors[corner] * self.scale / GUARD
    }

    /// A bound on the error of a clipped outline anywhere in the guard band, in pixels, before rounding. The bound
    /// contains the factor 2, because away from the middle, an error of w causes an error of x, too.
    pub fn of_place(&self) -> f64 {
        let most = self.errors.into_iter().fold(0., f64::max);
        let nearest = if self.is_parallel() {
            1.
        } else {
            self.view.projection.near
        };
        2. * most * self.scale / nearest
    }

    /// The clipping planes that keep distances from `near` times the near plane's distance to `far` times the far
    /// plane's distance.
    ///
    /// z = a·w − b, where a = (f + n)/(f − n) and b = 2fn/(f − n). So z is above −k·w beyond the distance n′ if k =
    /// b/n′ − a.
    pub fn planes(&self, near: f64, far: f64) -> [Plane; 2] {
        let ModelProjection {
            near: n, far: f, ..
        } = self.view.projection;
        let (a, b) = ((f + n) / (f - n), 2. * f * n / (f - n));
        let (near, far) = (b / (n * near) - a, a - b / (f * far));
        [[0., 0., 1., near], [0., 0., -1., far]]
    }
}
