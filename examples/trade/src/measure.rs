//! The errors of a scene in each mode, compared with the f64 model.

use embedded_graphics::pixelcolor::Gray8;
use fixel::prelude::*;
use fixel::shade::Texels;
use fixel::view::Perspective;

use super::Result;
use support::mode::Mode;
use support::moves::exact;
use support::recorder::{Probe, Record, record};
use support::reference::coverage::{Bounds, covered_in};
use support::reference::raster::{self, pieces};
use support::reference::scenes::SIZE;
use support::reference::view::View;

/// The modes, with their names in tables and in tests/instructions.csv. To measure another mode, add a line.
pub const MODES: [(&str, Mode); 5] = [
    ("exact", Mode::Exact),
    ("newton", Mode::Newton),
    ("narrow", Mode::NewtonNarrow),
    ("fast", Mode::Fast(fx!(0.25))),
    ("affine", Mode::Affine),
];

/// Fraction bits of a texel's column and row. With them, no bit of u and v is lost on a texture of 256x256.
const FRACTION: u32 = 16;
const TEXELS_LOG2: u32 = 8;

/// A set of drawings, and the errors of all their pixels in each of the [`MODES`].
pub struct Scene {
    pub name: &'static str,
    pub errors: [Errors; MODES.len()],
}

/// Statistics of texel errors.
#[derive(Clone, Copy, Default)]
pub struct Errors {
    pub max: f64,
    sum: f64,
    count: usize,
}

impl Errors {
    fn add(&mut self, error: f64) {
        self.max = self.max.max(error);
        self.sum += error;
        self.count += 1;
    }

    pub fn mean(&self) -> f64 {
        self.sum / self.count as f64
    }
}

/// The exact column and row of the texture at a pixel of a triangle.
struct Expected {
    face: usize,
    pixel: [i32; 2],
    texel: [f64; 2],
}

impl Scene {
    pub fn new(name: &'static str) -> Self {
        Self {
            name,
            errors: Default::default(),
        }
    }

    /// Draws a mesh in each mode, and adds the errors at every pixel of every triangle, including hidden pixels.
    ///
    /// # Errors
    ///
    /// The crate clips the mesh, or draws other pixels than the model.
    pub fn add(&mut self, mesh: &Mesh<'_>, mvp: &Mvp<Perspective>, view: &View) -> Result<()> {
        let mut model = None;
        for ((_, mode), errors) in MODES.into_iter().zip(&mut self.errors) {
            let drawn = drawn(mesh, mvp, mode)?;
            let model = match &mut model {
                Some(model) => model,
                none => none.insert(
                    expected(mesh, mvp, view, &drawn)
                        .map_err(|error| format!("{}: {error}", self.name))?,
                ),
            };
            let drawn_pixels = drawn.seen.iter().map(|seen| (seen.face, seen.pixel));
            if !drawn_pixels.eq(model.iter().map(|wanted| (wanted.face, wanted.pixel))) {
                return Err(
                    format!("{}: the crate draws other pixels than the model", self.name).into(),
                );
            }
            for (seen, wanted) in drawn.seen.iter().zip(model) {
                let [column, row] = [0, 1]
                    .map(|axis: usize| (in_texels(seen.values[axis]) - wanted.texel[axis]).abs());
                errors.add(column.max(row));
            }
        }
        Ok(())
    }
}

fn in_texels(bits: i32) -> f64 {
    f64::from(bits) / f64::from(1 << FRACTION)
}

/// A canvas's memory.
fn blank() -> Vec<Gray8> {
    vec![Gray8::new(0); SIZE.0 as usize * SIZE.1 as usize]
}

/// Draws a mesh, and records the texel at every pixel of every triangle, sorted by face, row and column.
fn drawn(mesh: &Mesh<'_>, mvp: &Mvp<Perspective>, mode: Mode) -> Result<Record<2>> {
    const UP: u32 = TEXELS_LOG2 + FRACTION - TexCoord::FRAC_BITS;
    let mut pixels = blank();
    let mut canvas = Canvas::new(&mut pixels, SIZE.0, SIZE.1)?;
    let probe = Probe {
        values: &|corner| Texels(corner.uv().to_bits().map(|bits| bits << UP)),
        color: None::<Gray8>,
    };
    let mut record = record(probe, |recorder| {
        mode.draw(&mut canvas, &DrawOptions::new(), mesh, mvp, recorder);
    });
    record
        .seen
        .sort_unstable_by_key(|seen| (seen.face, seen.pixel[1], seen.pixel[0]));
    Ok(record)
}

/// The exact texels at every pixel of the triangles that were drawn, sorted by face, row and column. The model gets the
/// crate's texture coordinates and snapped corners.
fn expected(
    mesh: &Mesh<'_>,
    mvp: &Mvp<Perspective>,
    view: &View,
    drawn: &Record<2>,
) -> Result<Vec<Expected>> {
    let screen = Viewport::new(0, 0, SIZE.0, SIZE.1)?;
    let places: Vec<_> = mesh
        .positions()
        .iter()
        .map(|point| {
            let place = screen.project(point, mvp)?;
            Some([place.x.to_bits(), place.y.to_bits()])
        })
        .collect();

    let positions: Vec<_> = mesh.positions().iter().map(exact).collect();
    let (faces, attributes): (Vec<_>, Vec<_>) = drawn
        .corners
        .iter()
        .map(|(face, corners)| {
            let texels = corners.map(|corner| corner.map(in_texels));
            (mesh.faces()[*face].map(usize::from), texels)
        })
        .unzip();
    let model = raster::Mesh {
        positions: &positions,
        faces: &faces,
        attributes: &attributes,
    };
    let mut expected = Vec::with_capacity(drawn.seen.len());
    for piece in pieces(&model, view) {
        let corners = piece.sources.map(|source| places[source?]);
        let [Some(a), Some(b), Some(c)] = corners else {
            return Err("a triangle is clipped".into());
        };
        let (face, piece) = (drawn.corners[piece.face].0, piece.snapped_to([a, b, c]));
        for pixel in covered_in([a, b, c], Bounds::new(SIZE.0, SIZE.1)) {
            let value = piece.at(pixel).ok_or("a triangle has no area")?;
            expected.push(Expected {
                face,
                pixel,
                texel: value.attributes,
            });
        }
    }
    Ok(expected)
}
