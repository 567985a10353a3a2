//! Drawing with a shader that records its input.

use embedded_graphics::pixelcolor::Gray8;
use fixel::Primitive;
use fixel::canvas::DepthBuffer;
use fixel::prelude::*;
use fixel::shade::{Tolerance, Varyings};
use fixel::view::ProjectionKind;

use crate::mode::Mode;
pub use crate::recorder::Seen;
use crate::recorder::{Coordinates, Probe, record};

/// A point on the screen: its position in units of 1/256 pixel, and its depth as a depth buffer stores it.
#[derive(Clone, Copy, Debug)]
pub struct Spot {
    pub x: i32,
    pub y: i32,
    pub depth: u16,
}

/// The values that a test interpolates.
type Values<'a, const N: usize> = &'a dyn Fn(&Corner<'_>) -> [i32; N];

/// The first `M` numbers; 0 where there are fewer.
fn first<const N: usize, const M: usize>(numbers: [i32; N]) -> [i32; M] {
    std::array::from_fn(|i| numbers.get(i).copied().unwrap_or_default())
}

/// A mesh, its transforms and its options: everything that a drawing needs.
pub struct Drawing<'a, K> {
    pub size: (u32, u32),
    /// All options except the mode.
    pub options: DrawOptions,
    pub mode: Mode,
    pub mesh: Mesh<'a>,
    pub mvp: Mvp<K>,
}

impl<K: ProjectionKind> Drawing<'_, K> {
    /// Every pixel of every triangle, in drawing order, including hidden pixels.
    pub fn all<const N: usize>(&self, values: Values<'_, N>) -> Vec<Seen<N>> {
        self.record(values, false, self.size.1)
    }

    /// The same pixels, drawn in bands of `rows` rows.
    pub fn all_in_bands<const N: usize>(&self, rows: u32, values: Values<'_, N>) -> Vec<Seen<N>> {
        self.record(values, false, rows)
    }

    /// Every pixel that passes the depth test, in drawing order. At each position, the last of these pixels is visible.
    pub fn shown<const N: usize>(&self, values: Values<'_, N>) -> Vec<Seen<N>> {
        self.record(values, true, self.size.1)
    }

    /// The visible face at each pixel, row by row. Draws in the default mode, because all modes except `Compact` show
    /// the same faces.
    pub fn faces(&self) -> Vec<Option<usize>> {
        let (mut pixels, mut depth) = self.blank();
        let mut canvas = self.canvas(&mut pixels).with_depth(&mut depth).unwrap();
        let record = record(Flat::new(Gray8::new(255)), |recorder| {
            canvas.draw_with(&self.options, &self.mesh, &self.mvp, recorder);
        });
        let mut faces = vec![None; depth.len()];
        for Seen::<0> { pixel, face, .. } in record.seen {
            let [x, y] = pixel.map(|at| usize::try_from(at).unwrap());
            faces[y * self.size.0 as usize + x] = Some(face);
        }
        faces
    }

    fn record<const N: usize>(
        &self,
        values: Values<'_, N>,
        draws: bool,
        rows: u32,
    ) -> Vec<Seen<N>> {
        let (mut pixels, mut depth) = self.blank();
        const { assert!(N <= 3) };
        // All tests interpolate three numbers, so that each mode is compiled only once.
        let probe = Probe {
            values: &|corner| Coordinates::<3>(first(values(corner))),
            color: draws.then_some(Gray8::new(255)),
        };
        let (width, height) = self.size;
        let length = (width * rows) as usize;
        let bands = pixels.chunks_mut(length).zip(depth.chunks_mut(length));
        let mut all = Vec::new();
        for (top, (pixels, depth)) in (0..).step_by(rows as usize).zip(bands) {
            let band = Canvas::band(pixels, width, height, top).unwrap();
            let mut band = band.with_depth(depth).unwrap();
            let record = record::<_, 3>(probe, |recorder| {
                self.draw(&mut band, recorder);
            });
            all.extend(record.seen);
        }
        let all = all.into_iter();
        all.map(|seen| seen.with_values(first(seen.values)))
            .collect()
    }

    /// A canvas's memory before drawing: black pixels, and depths of 0.
    fn blank(&self) -> (Vec<Gray8>, Vec<u16>) {
        let (width, height) = self.size;
        let count = width as usize * height as usize;
        (vec![Gray8::new(0); count], vec![0; count])
    }

    fn canvas<'p>(&self, pixels: &'p mut [Gray8]) -> Canvas<'p, Gray8> {
        Canvas::new(pixels, self.size.0, self.size.1).unwrap()
    }

    fn draw<S: ShaderFor<Gray8>, D: DepthBuffer>(
        &self,
        canvas: &mut Canvas<'_, Gray8, Native, D>,
        shader: &S,
    ) {
        self.mode
            .draw(canvas, &self.options, &self.mesh, &self.mvp, shader);
    }

    /// The depths in a buffer of the format `F` after drawing, row by row.
    pub fn depths<F: DepthBuffer>(&self) -> Vec<u16> {
        let (mut pixels, mut depth) = self.blank();
        let canvas = self.canvas(&mut pixels);
        let mut canvas = canvas.with_depth_format::<F>(&mut depth).unwrap();
        // This shader has varyings, so each mode interpolates.
        self.draw(&mut canvas, &Raw(None));
        depth
    }

    /// The positions that the crate computes for points, in 1/256 pixel; `None` for points that it clips.
    pub fn snapped(&self, points: &[Vec3]) -> Vec<Option<[i32; 2]>> {
        let spots = self.spots(points).into_iter();
        spots
            .map(|spot| spot.map(|spot| [spot.x, spot.y]))
            .collect()
    }

    /// The positions and depths that the crate computes for points; `None` for points that it clips.
    pub fn spots(&self, points: &[Vec3]) -> Vec<Option<Spot>> {
        let (mut pixels, _) = self.blank();
        let whole = self.canvas(&mut pixels).viewport();
        let screen = self.options.viewport.unwrap_or(whole);
        points
            .iter()
            .map(|&point| {
                let place = screen.project(point, &self.mvp)?;
                Some(Spot {
                    x: place.x.to_bits(),
                    y: place.y.to_bits(),
                    depth: place.depth::<LinearDepth>(),
                })
            })
            .collect()
    }
}

/// Varyings of three numbers, each with a tolerance.
#[derive(Clone, Copy)]
pub struct Rough([i32; 3]);

impl Varyings for Rough {
    type Lanes = [(); 3];
    type Face = ();

    fn tolerance(lane: usize) -> Tolerance {
        [
            Tolerance::Texels,
            Tolerance::Units(1 << 20),
            Tolerance::Units(u32::MAX),
        ][lane]
    }

    fn split(self) -> ([i32; 3], ()) {
        (self.0, ())
    }

    fn join(numbers: [i32; 3], (): ()) -> Self {
        Self(numbers)
    }
}

/// A shader with varyings of any magnitude. One varying jumps between the ends of its format. Every pixel gets the given
/// color, or without one a color that depends on all bits of the varyings.
#[derive(Clone, Copy)]
pub struct Raw(pub Option<Gray8>);

impl Shader for Raw {
    type Color = Gray8;
    type Varyings = Rough;

    fn varyings(&self, primitive: &Primitive<'_>) -> [Rough; 3] {
        primitive.corners(|corner| {
            let [x, y, _] = corner.position().to_bits();
            let end = if y & 1 == 0 { i32::MIN } else { i32::MAX };
            Rough([x, corner.uv().x.to_bits(), end])
        })
    }

    fn shade(&self, at: &Fragment, Rough([a, b, c]): Rough) -> Option<Gray8> {
        let [mixed, ..] = (a ^ a >> 16 ^ b ^ c ^ i32::from(at.depth)).to_le_bytes();
        self.0.or(Some(Gray8::new(mixed)))
    }
}
