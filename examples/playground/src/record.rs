//! Shaders that record their input.

use core::cell::Cell;

use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
use fixel::Primitive;
use fixel::prelude::*;
use fixel::shade::{PerFace, Texels};

/// A texel of the size that modes promise: 16 fraction bits. Texture coordinates have 20.
const SHIFT: u32 = TexCoord::FRAC_BITS - 16;

/// Writes the texel under each pixel and the corners of each triangle. It has the varyings of a texture, so a mode
/// interpolates them as it interpolates a texture's.
#[derive(Clone, Copy)]
pub struct Recorder<'a> {
    /// Of the frame: index of the triangle plus 1, column, row.
    pub pixels: &'a [Cell<[i32; 3]>],
    pub width: u32,
    /// Width and height of the texture; then of each corner x, y, z, u, v.
    pub triangles: &'a [Cell<[i32; 17]>],
    /// The index of the mesh's first triangle.
    pub first: usize,
    pub texels: [u32; 2],
    pub mesh: Mesh<'a>,
}

impl Shader for Recorder<'_> {
    type Color = Rgb565;
    type Varyings = (Texels, PerFace<i32>);

    fn varyings(&self, primitive: &Primitive<'_>) -> [Self::Varyings; 3] {
        let face = primitive.face().unwrap_or_default();
        let index = self.first + face;
        let plus_one = i32::try_from(index + 1).unwrap_or_default();
        let [width, height] = self.texels.map(u32::cast_signed);
        let uvs = primitive.corners(|corner| corner.uv().to_bits());
        let corners = self.mesh.faces().get(face);
        if let (Some(triangle), Some(face)) = (self.triangles.get(index), corners) {
            let mut corners = [0; 17];
            [corners[0], corners[1]] = [width, height];
            for ((corner, &at), uv) in corners[2..].chunks_exact_mut(5).zip(face).zip(uvs) {
                let position = self.mesh.positions().get(at.into()).unwrap_or_default();
                corner[..3].copy_from_slice(&position.to_bits());
                corner[3..].copy_from_slice(&uv);
            }
            triangle.set(corners);
        }
        uvs.map(|[u, v]| {
            // A texture of 512 texels that repeats up to 64 times fits; of larger ones only the error is wrong.
            let texels = [(u, width), (v, height)]
                .map(|(at, size)| (i64::from(at) * i64::from(size)) >> SHIFT);
            (Texels(texels.map(|texel| texel as i32)), PerFace(plus_one))
        })
    }

    fn shade(
        &self,
        at: &Fragment,
        (Texels([u, v]), PerFace(triangle)): Self::Varyings,
    ) -> Option<Rgb565> {
        let place = at.point.y.cast_unsigned() * self.width + at.point.x.cast_unsigned();
        if let Some(pixel) = self.pixels.get(place as usize) {
            pixel.set([triangle, u, v]);
        }
        Some(Rgb565::BLACK)
    }
}
