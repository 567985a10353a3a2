//! Shaders that record their input instead of computing a color.

use std::cell::RefCell;

use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor};
use fixel::prelude::*;
use fixel::shade::{PerFace, Texels};

/// The interpolated values of a pixel.
#[derive(Clone, Copy, Debug)]
pub struct Seen {
    pub face: usize,
    pub pixel: [i32; 2],
    /// The column and row of the texture, in units of 2⁻¹⁶ texel.
    pub texel: [i32; 2],
}

/// A shader that records the texel at every pixel of every triangle. The recorder has the varyings of a texture.
#[derive(Clone, Copy)]
pub struct Recorder<'a> {
    pub seen: &'a RefCell<Vec<Seen>>,
    /// The base-2 logarithm of the texture's side in texels. If the logarithm is at least 4, no bit of u and v is lost.
    pub texels_log2: u32,
}

impl Shader for Recorder<'_> {
    type Color = Rgb565;
    type Varyings = (Texels, PerFace<usize>);

    fn varyings(&self, primitive: &Primitive<'_>) -> [Self::Varyings; 3] {
        let up = self.texels_log2 + 16 - TexCoord::FRAC_BITS;
        primitive.corners(|corner| {
            let texel = corner.uv().to_bits().map(|bits| bits << up);
            (Texels(texel), PerFace(primitive.face().unwrap_or_default()))
        })
    }

    fn shade(
        &self,
        at: &Fragment,
        (Texels(texel), PerFace(face)): Self::Varyings,
    ) -> Option<Rgb565> {
        self.seen.borrow_mut().push(Seen {
            face,
            pixel: [at.point.x, at.point.y],
            texel,
        });
        None
    }
}

/// The corners of a triangle, as the crate receives them.
#[derive(Clone, Copy, Debug)]
pub struct Recorded {
    pub face: usize,
    /// For each corner: u and v, and red, green and blue from 0 to 255.
    pub corners: [[f64; 5]; 3],
}

/// A shader that records the corners of the triangles that are drawn.
#[derive(Clone, Copy)]
pub struct Survey<'a>(pub &'a RefCell<Vec<Recorded>>);

impl Shader for Survey<'_> {
    type Color = Rgb565;
    type Varyings = ();

    fn varyings(&self, primitive: &Primitive<'_>) -> [(); 3] {
        let corners = primitive.corners(|corner| {
            let [u, v] = corner.uv().to_bits();
            let [u, v] = [u, v].map(|bits| f64::from(TexCoord::from_bits(bits)));
            let color: Rgb888 = corner.color();
            let [r, g, b] = [color.r(), color.g(), color.b()].map(f64::from);
            [u, v, r, g, b]
        });
        let face = primitive.face().unwrap_or_default();
        self.0.borrow_mut().push(Recorded { face, corners });
        [(); 3]
    }

    fn shade(&self, _: &Fragment, (): ()) -> Option<Rgb565> {
        None
    }
}
