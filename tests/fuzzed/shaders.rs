//! Shaders that show or tell what they are given.

use std::cell::RefCell;

use embedded_graphics::pixelcolor::{PixelColor, Rgb565};
use fixel::mode::Tolerance;
use fixel::prelude::*;

/// Every bit of up to three values, mixed into the colour; some pixels are left out.
///
/// The first two are texture coordinates, as wide as they come, the third jumps from end to end of its format.
#[derive(Clone, Copy, Debug)]
pub struct Bits<const N: usize>;

impl<const N: usize> Shader for Bits<N> {
    type Color = Rgb565;

    const TOLERANCES: [Tolerance; N] = [Tolerance::Texels; N];

    fn varyings(&self, vertex: &Corner<'_>) -> [i32; N] {
        let [u, v] = vertex.uv().to_bits();
        let far = vertex.position().y.to_bits() & 0x1000 == 0;
        let all = [u, v, if far { i32::MIN } else { i32::MAX }];
        std::array::from_fn(|i| all[i])
    }

    fn shade(&self, sample: &Fragment, values: [i32; N]) -> Option<Rgb565> {
        let [x, y] = [sample.point.x, sample.point.y];
        let rest = [x, y, i32::from(sample.depth)];
        let mix = values
            .iter()
            .chain(&rest)
            .fold(0x811c_9dc5_u32, |mix, &value| {
                (mix ^ value.cast_unsigned())
                    .wrapping_mul(0x0100_0193)
                    .rotate_left(7)
            });
        let [red, green, blue, holes] = mix.to_be_bytes();
        (holes > 5).then_some(Rgb565::new(red, green, blue))
    }
}

/// A shader whose colours are turned into those of the canvas, each into another.
#[derive(Clone, Copy, Debug)]
pub struct Wide<F>(pub F);

impl<F: Shader<Color: Into<Rgb565>>> Shader for Wide<F> {
    type Color = Rgb565;

    const READS_DEPTH: bool = F::READS_DEPTH;
    const TOLERANCES: [Tolerance; N] = F::TOLERANCES;

    fn varyings(&self, vertex: &Corner<'_>) -> [i32; N] {
        self.0.varyings(vertex)
    }

    fn shade(&self, sample: &Fragment, values: [i32; N]) -> Option<Rgb565> {
        self.0.shade(sample, values).map(Into::into)
    }

    fn begin(self, model: &Transform) -> Self {
        Self(self.0.begin(model))
    }

    fn face(self, corners: &mut [[i32; N]; 3], face: &Face<'_>) -> Self {
        Self(self.0.face(corners, face))
    }
}

/// A pixel that a shader was asked for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Seen<C, const N: usize> {
    pub pixel: [i32; 2],
    pub depth: u16,
    /// The triangle's place in the mesh.
    pub face: usize,
    pub values: [i32; N],
    pub color: Option<C>,
}

/// What was written down of a draw call.
#[derive(Debug)]
pub struct Record<C, const N: usize> {
    pub seen: Vec<Seen<C, N>>,
    /// The values at the corners of triangles.
    pub corners: Vec<(usize, [[i32; N]; 3])>,
}

impl<C, const N: usize> Default for Record<C, N> {
    fn default() -> Self {
        Self {
            seen: Vec::new(),
            corners: Vec::new(),
        }
    }
}

/// A shader that writes down what another one does.
#[derive(Clone, Copy, Debug)]
pub struct Recorder<'a, F, C, const N: usize> {
    pub shader: F,
    pub record: &'a RefCell<Record<C, N>>,
    pub face: usize,
}

impl<F: Shader<Color = C>, C: PixelColor> Shader for Recorder<'_, F, C, N> {
    type Color = C;

    const TOLERANCES: [Tolerance; N] = F::TOLERANCES;

    fn varyings(&self, vertex: &Corner<'_>) -> [i32; N] {
        self.shader.varyings(vertex)
    }

    fn begin(self, model: &Transform) -> Self {
        Self {
            shader: self.shader.begin(model),
            ..self
        }
    }

    fn face(self, corners: &mut [[i32; N]; 3], face: &Face<'_>) -> Self {
        let shader = self.shader.face(corners, face);
        let index = face.index();
        self.record.borrow_mut().corners.push((index, *corners));
        Self {
            shader,
            face: index,
            ..self
        }
    }

    fn shade(&self, sample: &Fragment, values: [i32; N]) -> Option<C> {
        let color = self.shader.shade(sample, values);
        self.record.borrow_mut().seen.push(Seen {
            pixel: [sample.point.x, sample.point.y],
            depth: sample.depth,
            face: self.face,
            values,
            color,
        });
        color
    }
}
