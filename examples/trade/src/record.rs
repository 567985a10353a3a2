//! Shaders that write down what they are given, in place of a colour.

use std::cell::RefCell;

use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor};
use fixel::mode::Tolerance;
use fixel::prelude::*;

/// What was interpolated at a pixel.
#[derive(Clone, Copy, Debug)]
pub struct Seen {
    pub face: usize,
    pub pixel: [i32; 2],
    /// Column and row of the texture, in units of 2⁻¹⁶ texel.
    pub texel: [i32; 2],
}

/// Writes down the texel under every pixel of every triangle: the varyings are those of a texture.
#[derive(Clone, Copy)]
pub struct Recorder<'a> {
    pub seen: &'a RefCell<Vec<Seen>>,
    /// Texels along the texture, as a power of two: 4 or more, so that no bit of u and v is lost.
    pub texels_log2: u32,
    pub face: usize,
}

impl Shader<2> for Recorder<'_> {
    type Color = Rgb565;

    const TOLERANCES: [Tolerance; 2] = [Tolerance::Texels; 2];

    fn varyings(&self, vertex: &Corner<'_>) -> [i32; 2] {
        let up = self.texels_log2 + 16 - TexCoord::FRAC_NBITS;
        vertex.uv().to_bits().map(|bits| bits << up)
    }

    fn face(self, _: &mut [[i32; 2]; 3], face: &Face<'_>) -> Self {
        Self {
            face: face.index(),
            ..self
        }
    }

    fn shade(&self, sample: &Fragment, texel: [i32; 2]) -> Option<Rgb565> {
        self.seen.borrow_mut().push(Seen {
            face: self.face,
            pixel: [sample.point.x, sample.point.y],
            texel,
        });
        None
    }
}

/// What a triangle's corners were given to the crate as.
#[derive(Clone, Copy, Debug)]
pub struct Given {
    pub face: usize,
    /// u, v, and red, green and blue of 255.
    pub corners: [[f64; 5]; 3],
}

/// Writes down the corners of the triangles that are drawn.
#[derive(Clone, Copy)]
pub struct Survey<'a>(pub &'a RefCell<Vec<Given>>);

impl Shader<5> for Survey<'_> {
    type Color = Rgb565;

    fn varyings(&self, vertex: &Corner<'_>) -> [i32; 5] {
        let ([u, v], color): (_, Rgb888) = (vertex.uv().to_bits(), vertex.color());
        let [r, g, b] = [color.r(), color.g(), color.b()].map(i32::from);
        [u, v, r, g, b]
    }

    fn face(self, corners: &mut [[i32; 5]; 3], face: &Face<'_>) -> Self {
        let corners = corners.map(|[u, v, r, g, b]| {
            let [u, v] = [u, v].map(|bits| TexCoord::from_bits(bits).to_num());
            let [r, g, b] = [r, g, b].map(f64::from);
            [u, v, r, g, b]
        });
        let face = face.index();
        self.0.borrow_mut().push(Given { face, corners });
        self
    }

    fn shade(&self, _: &Fragment, _: [i32; 5]) -> Option<Rgb565> {
        None
    }
}
