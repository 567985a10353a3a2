//! Any shader on a canvas of another color format.

use core::marker::PhantomData;

use super::{Fragment, Output, PixelFormat, Precise, Shader};
use crate::mesh::Primitive;

/// Shader `S` on a canvas of color format `C`; see [`Shader::converted`].
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Converted<S, C> {
    shader: S,
    color: PhantomData<C>,
}

impl<S, C> Converted<S, C> {
    /// `shader`, for a canvas of color `C`.
    #[must_use]
    pub(super) const fn new(shader: S) -> Self {
        Self {
            shader,
            color: PhantomData,
        }
    }
}

impl<S: Shader<Color: Output<Color: PixelFormat>>, C: PixelFormat> Shader for Converted<S, C> {
    type Color = <S::Color as Output>::With<C>;
    type Varyings = S::Varyings;

    const READS_DEPTH: bool = S::READS_DEPTH;

    #[inline]
    fn varyings(&self, primitive: &Primitive<'_>) -> [S::Varyings; 3] {
        self.shader.varyings(primitive)
    }

    #[inline]
    fn shade(&self, at: &Fragment, varyings: S::Varyings) -> Option<Self::Color> {
        Some(self.shader.shade(at, varyings)?.map(Precise::converted))
    }
}

#[cfg(test)]
mod tests {
    use super::super::FaceColors;
    use super::super::fixture::{IDENTITY, face, fragment, shade};
    use super::*;
    use crate::{Mesh, Vec3};
    use embedded_graphics::pixelcolor::{BinaryColor, Gray4, Rgb565, Rgb888, RgbColor};

    #[test]
    fn the_inner_shader_computes_the_color() {
        let positions = [Vec3::ZERO, Vec3::X, Vec3::Y];
        let mesh = Mesh::new(&positions, &[[0, 1, 2]; 2]).unwrap();
        let colors = [Rgb888::BLACK, Rgb888::new(8, 120, 200)];
        let shader = Converted::<_, Rgb565>::new(FaceColors::new(&colors));
        let (shader, [corner, ..]) = face(shader, &IDENTITY, &mesh, 1);
        assert_eq!(shade(&shader, corner), Rgb565::new(1, 30, 24));
    }

    #[test]
    fn coarse_colors_are_dithered() {
        let gray = Converted::<_, Gray4>::new(super::super::Flat::new(Rgb888::new(8, 8, 8)));
        // 8/255 of 15 steps is 0.47 of a step.
        let lit = (0..64).filter(|i| {
            gray.shade(&fragment(0, 0), ())
                .unwrap()
                .finish(fragment(i % 8, i / 8).point)
                == Gray4::new(1)
        });
        assert_eq!(lit.count(), 30);
        let white = Converted::<_, BinaryColor>::new(super::super::Flat::new(Rgb565::WHITE));
        assert!((0..64).all(|i| {
            white
                .shade(&fragment(0, 0), ())
                .unwrap()
                .finish(fragment(i % 8, i / 8).point)
                == BinaryColor::On
        }));
    }
}
