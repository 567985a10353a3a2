//! Any shader on a canvas of another colour.

use core::marker::PhantomData;

use embedded_graphics::pixelcolor::Rgb888;

use super::{Fragment, Levels, Shader};
use crate::math::Transform;
use crate::mesh::{Corner, Face};
use crate::span::Tolerance;

/// The colours of shader `F` in the canvas's format `C`: rounded, or dithered where `C` is
/// coarse (see [`Levels`]).
///
/// A texture of another colour than the canvas's is converted pixel by pixel this way; to store
/// it in the canvas's colour is faster.
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::{BinaryColor, Rgb888}};
/// use fixel::prelude::*;
/// static SKIN: TextureArray<Rgb888, 2, 1> = TextureArray::rgb888(&[255, 255, 255, 0, 128, 0]);
/// static SQUARE: Mesh = shape!(plane(1, 1));
/// let projection = Projection::orthographic(fx!(-1), fx!(1), fx!(-1), fx!(1), fx!(0), fx!(2))?;
/// let mvp = projection * Camera::top(Vec3::ZERO, fx!(1));
/// let mut pixels = [BinaryColor::Off; 48];
/// let mut canvas = Canvas::new(&mut pixels, 12, 4)?;
/// let skin = Textured::new(&SKIN);
/// canvas.draw(&SQUARE, &mvp, &Converted::new(skin));
/// let mut display = MockDisplay::new();
/// canvas.show(&mut display)?;
/// display.assert_pattern(&[
///     "######......",
///     "#######.#.#.",
///     "######......",
///     "#######.#.#.",
/// ]);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Converted<F, C> {
    shader: F,
    color: PhantomData<C>,
}

impl<F, C> Converted<F, C> {
    /// `shader`, for a canvas of colour `C`.
    #[must_use]
    pub const fn new(shader: F) -> Self {
        Self {
            shader,
            color: PhantomData,
        }
    }
}

impl<F, C, const N: usize> Shader<N> for Converted<F, C>
where
    F: Shader<N>,
    F::Color: Into<Rgb888>,
    C: Levels,
{
    type Color = C;

    const READS_DEPTH: bool = F::READS_DEPTH;
    const TOLERANCES: [Tolerance; N] = F::TOLERANCES;

    #[inline]
    fn varyings(&self, vertex: &Corner<'_>) -> [i32; N] {
        self.shader.varyings(vertex)
    }

    #[inline]
    fn shade(&self, sample: &Fragment, varyings: [i32; N]) -> Option<C> {
        let color = self.shader.shade(sample, varyings)?;
        Some(C::from_rgb(color.into(), sample.point))
    }

    #[inline]
    fn begin(self, model: &Transform) -> Self {
        Self::new(self.shader.begin(model))
    }

    #[inline]
    fn face(self, corners: &mut [[i32; N]; 3], face: &Face<'_>) -> Self {
        Self::new(self.shader.face(corners, face))
    }
}

#[cfg(test)]
mod tests {
    use super::super::FaceColors;
    use super::super::trial::{IDENTITY, face, sample, shade};
    use super::*;
    use crate::{Mesh, Vec3};
    use embedded_graphics::pixelcolor::{BinaryColor, Gray4, Rgb565, RgbColor};

    #[test]
    fn the_fragment_inside_is_asked() {
        let positions = [Vec3::ZERO, Vec3::X, Vec3::Y];
        let mesh = Mesh::new(&positions, &[[0, 1, 2]; 2]).unwrap();
        let colors = [Rgb888::BLACK, Rgb888::new(8, 120, 200)];
        let (shader, _) = face(
            Converted::new(FaceColors::new(&colors)),
            &IDENTITY,
            &mesh,
            1,
        );
        assert_eq!(shade::<_, Rgb565, 0>(&shader, []), Rgb565::new(1, 30, 24));
    }

    #[test]
    fn coarse_colours_are_dithered() {
        let grey = Converted::<_, Gray4>::new(super::super::Flat::new(Rgb888::new(8, 8, 8)));
        // 8/255 of 15 steps is 0.47 of a step.
        let lit = (0..64).filter(|i| grey.shade(&sample(i % 8, i / 8), []) == Some(Gray4::new(1)));
        assert_eq!(lit.count(), 30);
        let white = Converted::<_, BinaryColor>::new(super::super::Flat::new(Rgb565::WHITE));
        assert!((0..64).all(|i| white.shade(&sample(i % 8, i / 8), []) == Some(BinaryColor::On)));
    }
}
