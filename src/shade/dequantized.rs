//! Attributes of a quantized mesh, unpacked for any shader.

use super::{Fragment, Shader};
use crate::mesh::{Primitive, Quantized};

/// A shader that sees the attributes of a [`Quantized`] mesh; made by [`Quantized::shader`].
///
#[cfg_attr(doc, doc = page_picture!("dequantized", "The same ring with numbers of 32 bits, and quantized"))]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Dequantized<'a, F> {
    mesh: &'a Quantized<'a>,
    shader: F,
}

impl Quantized<'_> {
    /// A shader that sees this mesh's normals and texture coordinates. Wrap the whole shader, with its lights.
    ///
    /// The shader may also draw a mesh with other positions and the same faces, such as one of
    /// [`Keyframes`](crate::mesh::Keyframes). If only some corners of a triangle have texture coordinates, the others
    /// get (0, 0), and [`Drawn::missing`](crate::Drawn::missing) does not report it.
    #[must_use]
    pub const fn shader<F: Shader>(&self, shader: F) -> Dequantized<'_, F> {
        Dequantized { mesh: self, shader }
    }
}

impl<F: Shader> Shader for Dequantized<'_, F> {
    type Color = F::Color;
    type Varyings = F::Varyings;

    const READS_DEPTH: bool = F::READS_DEPTH;

    #[inline]
    fn varyings(&self, primitive: &Primitive<'_>) -> [F::Varyings; 3] {
        let shader = self.shader;
        self.mesh
            .unpacked(primitive, |primitive| shader.varyings(primitive))
    }

    #[inline]
    fn shade(&self, at: &Fragment, varyings: F::Varyings) -> Option<F::Color> {
        self.shader.shade(at, varyings)
    }
}
