//! A triangle drawn by the crate and by the model.

use fixel::canvas::DepthBuffer;
use fixel::prelude::*;
use fixel::view::ProjectionKind;

use support::drawing::{Drawing, Seen};
use support::mode::Mode;
use support::reference::attributes::{interpolate, weights_snapped};
use support::reference::coverage::{Snapped, covered};

/// A triangle and all inputs of the model.
#[derive(Clone, Copy)]
pub struct Triangle<K, const N: usize> {
    pub size: (u32, u32),
    pub mvp: Mvp<K>,
    pub positions: [Vec3; 3],
    /// Each attribute at the three corners.
    pub values: [[i32; 3]; N],
    /// The w at each corner by which attributes are divided.
    pub w: [f64; 3],
    /// The depths at the corners, by the formula of the projection. Depth is linear on the screen.
    pub depth: [f64; 3],
}

/// The model's values at a pixel.
pub struct Model<const N: usize> {
    pub pixel: [i32; 2],
    pub w: f64,
    /// The greatest w in the row of the pixel.
    pub farthest: f64,
    pub values: [f64; N],
    pub depth: f64,
}

impl<K: ProjectionKind, const N: usize> Triangle<K, N> {
    fn drawing(&self, mode: Mode) -> Drawing<'_, K> {
        Drawing {
            size: self.size,
            options: DrawOptions::new().with_cull(Cull::Nothing),
            mode,
            mesh: Mesh::new(&self.positions, &[[0, 1, 2]]).unwrap(),
            mvp: self.mvp,
        }
    }

    /// The positions of the corners in 24.8; `None` if the triangle is clipped or two corners coincide.
    pub fn screen(&self) -> Option<Snapped> {
        match self.drawing(Mode::Exact).snapped(&self.positions)[..] {
            [Some(a), Some(b), Some(c)] if a != b && b != c && c != a => Some([a, b, c]),
            _ => None,
        }
    }

    /// The model's values at the pixels of a triangle with the corners `screen`, row by row.
    pub fn model(&self, screen: Snapped) -> Vec<Model<N>> {
        let attributes = [0, 1, 2].map(|corner: usize| self.values.map(|v| f64::from(v[corner])));
        let depth = self.depth.map(|depth| [depth]);
        let at = |pixel| {
            let weights = weights_snapped(screen, pixel).unwrap();
            let value = interpolate(&weights, self.w, &attributes);
            let [depth] = interpolate(&weights, [1.; 3], &depth).attributes;
            Model {
                pixel,
                w: value.w,
                farthest: 0.,
                values: value.attributes,
                depth,
            }
        };
        let (width, height) = self.size;
        let mut pixels: Vec<Model<N>> = covered(screen, width, height).map(at).collect();
        for row in pixels.chunk_by_mut(|a, b| a.pixel[1] == b.pixel[1]) {
            let farthest = row.iter().fold(0., |most: f64, model| most.max(model.w));
            for model in row {
                model.farthest = farthest;
            }
        }
        pixels
    }

    /// The triangle's depths in a buffer of format `F`, row by row.
    pub fn depths<F: DepthBuffer>(&self, mode: Mode) -> Vec<u16> {
        self.drawing(mode).depths::<F>()
    }

    /// The pixels that the crate draws in a mode, row by row.
    pub fn draw(&self, mode: Mode) -> Vec<Seen<N>> {
        let mut seen = self.drawing(mode).all(&|vertex| {
            let corner = self.positions.iter().position(|&p| p == vertex.position());
            self.values.map(|value| value[corner.unwrap()])
        });
        seen.sort_by_key(|seen| (seen.pixel[1], seen.pixel[0]));
        seen
    }
}
