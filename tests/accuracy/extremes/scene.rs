//! Triangles with their view, in the numbers of the crate and of the model.

use fixel::prelude::*;
use fixel::view::Perspective;

use super::verdict::Verdict;
use support::counter::BOTH_SIDES;
use support::moves::{Move, exact, number, product, rounded};
use support::reference::projection::focal;
use support::reference::view::{self, View};

/// A triangle's corners.
pub type Corners = [[f64; 3]; 3];

/// Texture coordinates of three corners that show a texture of 256 texels once: the texture's column and row, with 16
/// fraction bits.
pub const ONCE: [[i32; 2]; 3] = [[0, 0], [256 << 16, 0], [0, 256 << 16]];

/// A scene: triangles, their texture coordinates, and their view.
#[derive(Clone, Debug)]
pub struct Scene {
    pub size: (u32, u32),
    pub options: DrawOptions,
    pub positions: Vec<Vec3>,
    pub faces: Vec<[u16; 3]>,
    /// The column and row of the texture at each position, with 16 fraction bits.
    pub texels: Vec<[i32; 2]>,
    pub mvp: Mvp<Perspective>,
    pub view: View,
    /// For each position, the sum of the absolute values of all terms of its coordinates in eye space, including all
    /// offsets.
    pub sums: Vec<f64>,
}

/// A view of triangles: a projection, the moves before it, and a viewport. All numbers of the view must be exact in the
/// crate's formats.
#[derive(Clone, Debug)]
pub struct TriangleView {
    pub size: (u32, u32),
    /// Focal length in pixels.
    pub focal: f64,
    pub near: f64,
    pub far: f64,
    /// Moves from model space to eye space; the last one acts first.
    pub moves: Vec<Move>,
    pub viewport: Option<Viewport>,
}

impl TriangleView {
    /// A small picture of a room.
    pub const ROOM: Self = Self {
        size: (96, 72),
        focal: 60.,
        near: 0.25,
        far: 100.,
        moves: Vec::new(),
        viewport: None,
    };

    /// A scene of one triangle, with corners rounded to the crate's nearest positions.
    pub fn scene(&self, corners: Corners, texels: [[i32; 2]; 3]) -> Scene {
        let positions = corners.map(rounded).to_vec();
        let (transform, eye) = product(&self.moves);
        let (width, height) = self.viewport.map_or(self.size, |viewport| {
            (viewport.size().width, viewport.size().height)
        });
        let projection = Projection::from_focal_length(
            number(self.focal),
            (width, height),
            number(self.near),
            number(self.far),
        );
        let sum = |p: &Vec3| exact(*p).map(f64::abs).iter().sum::<f64>();
        let offset: f64 = self
            .moves
            .iter()
            .map(|part| match part {
                Move::To(offset) => sum(offset),
                _ => 0.,
            })
            .sum();
        Scene {
            size: self.size,
            options: self
                .viewport
                .map_or(BOTH_SIDES, |viewport| BOTH_SIDES.with_viewport(viewport)),
            sums: positions.iter().map(|p| sum(p) + offset).collect(),
            positions,
            faces: vec![[0, 1, 2]],
            texels: texels.to_vec(),
            mvp: projection.unwrap() * transform,
            view: View {
                eye,
                projection: focal(self.focal, (width, height), self.near, self.far),
                viewport: view::Viewport {
                    x: self.viewport.map_or(0, |viewport| viewport.top_left().x),
                    y: self.viewport.map_or(0, |viewport| viewport.top_left().y),
                    width,
                    height,
                },
            },
        }
    }

    /// Judges a triangle that shows a texture once. The triangle is judged three times, with a different corner as the
    /// first corner, because the fan of a clipped triangle starts there.
    pub fn judge(&self, [a, b, c]: Corners) -> Verdict {
        let mut verdict = Verdict::default();
        for corners in [[a, b, c], [b, c, a], [c, a, b]] {
            verdict.merge(self.scene(corners, ONCE).judge());
        }
        verdict
    }

    /// The position at the distance `w` that appears at a point of the screen. The point is in pixels from the middle,
    /// with y up.
    pub fn at(&self, [x, y]: [f64; 2], w: f64) -> [f64; 3] {
        [x * w / self.focal, y * w / self.focal, -w]
    }
}

impl Scene {
    /// The index of a position.
    pub fn index(&self, position: Vec3) -> usize {
        self.positions.iter().position(|&p| p == position).unwrap()
    }
}

/// Merges many verdicts into the worst.
pub fn worst(verdicts: impl IntoIterator<Item = Verdict>) -> Verdict {
    let mut all = Verdict::default();
    for verdict in verdicts {
        all.merge(verdict);
    }
    all
}

/// Pseudo-random numbers from 0 to 1, the same in every run. The numbers are the upper bits of Knuth's MMIX generator.
pub struct Random(pub u64);

impl Random {
    pub fn next(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 32) as f64 / 2_f64.powi(32)
    }

    pub fn below(&mut self, end: usize) -> usize {
        (self.next() * end as f64) as usize
    }

    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.next()
    }
}
