//! Colours that are constant over a mesh or a triangle.

use embedded_graphics::pixelcolor::PixelColor;

use super::{Fragment, Shader};
use crate::mesh::{Corner, Face};

/// One colour for everything.
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor};
/// use fixel::prelude::*;
/// static SQUARE: Mesh = shape!(plane(1, 1));
/// let projection = Projection::orthographic(Window::centered(fx!(2), fx!(2)), fx!(0), fx!(2))?;
/// let mvp = projection * Camera::top(Vec3::ZERO, fx!(1));
/// let mut pixels = [BinaryColor::Off; 32];
/// let mut canvas = Canvas::new(&mut pixels, 8, 4)?;
/// let half = Transform::scale(fx!(0.5));
/// canvas.draw(&SQUARE, &(mvp * half), &Flat::new(BinaryColor::On));
/// let mut display = MockDisplay::new();
/// canvas.show(&mut display)?;
/// display.assert_pattern(&["........", "..####..", "..####..", "........"]);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Flat<C> {
    color: C,
}

impl<C: PixelColor> Flat<C> {
    /// A shader of this colour.
    #[must_use]
    pub const fn new(color: C) -> Self {
        Self { color }
    }
}

impl<C: PixelColor> Shader<0> for Flat<C> {
    type Color = C;

    const READS_DEPTH: bool = false;

    #[inline]
    fn varyings(&self, _: &Corner<'_>) -> [i32; 0] {
        []
    }

    #[inline]
    fn shade(&self, _: &Fragment, _: [i32; 0]) -> Option<C> {
        Some(self.color)
    }
}

/// One colour per triangle, in the order of the mesh's faces.
///
/// Triangles beyond the end of the list have its last colour; without any colours they are
/// black (the colour's default). Edges and points have the first.
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::{Rgb565, RgbColor}};
/// use fixel::prelude::*;
/// static SQUARE: Mesh = shape!(plane(1, 1));
/// let projection = Projection::orthographic(Window::centered(fx!(2), fx!(2)), fx!(0), fx!(2))?;
/// let mvp = projection * Camera::top(Vec3::ZERO, fx!(1));
/// let mut pixels = [Rgb565::BLACK; 16];
/// let mut canvas = Canvas::new(&mut pixels, 4, 4)?;
/// let colors = [Rgb565::RED, Rgb565::BLUE];
/// canvas.draw(&SQUARE, &mvp, &FaceColors::new(&colors));
/// let mut display = MockDisplay::new();
/// canvas.show(&mut display)?;
/// display.assert_pattern(&[
///     "BBBB",
///     "RBBB",
///     "RRBB",
///     "RRRB",
/// ]);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FaceColors<'a, C> {
    colors: &'a [C],
    current: C,
}

impl<'a, C: PixelColor + Default> FaceColors<'a, C> {
    /// A shader of these colours.
    #[must_use]
    pub fn new(colors: &'a [C]) -> Self {
        Self {
            colors,
            current: colors.first().copied().unwrap_or_default(),
        }
    }
}

impl<C: PixelColor> Shader<0> for FaceColors<'_, C> {
    type Color = C;

    const READS_DEPTH: bool = false;

    #[inline]
    fn varyings(&self, _: &Corner<'_>) -> [i32; 0] {
        []
    }

    #[inline]
    fn face(self, _: &mut [[i32; 0]; 3], face: &Face<'_>) -> Self {
        let color = self.colors.get(face.index()).or(self.colors.last());
        Self {
            current: color.copied().unwrap_or(self.current),
            ..self
        }
    }

    #[inline]
    fn shade(&self, _: &Fragment, _: [i32; 0]) -> Option<C> {
        Some(self.current)
    }
}

#[cfg(test)]
mod tests {
    use super::super::trial::{IDENTITY, face, shade};
    use super::*;
    use crate::{Mesh, Vec3};
    use embedded_graphics::pixelcolor::{Gray8, GrayColor};

    #[test]
    fn colours_go_by_the_face() {
        let positions = [Vec3::ZERO, Vec3::X, Vec3::Y];
        let mesh = Mesh::new(&positions, &[[0, 1, 2]; 4]).unwrap();
        let colors = [Gray8::new(10), Gray8::new(20), Gray8::new(30)];
        let shown = |colors: &[Gray8]| {
            [0, 1, 2, 3].map(|i| {
                let (shader, _) = face(FaceColors::new(colors), &IDENTITY, &mesh, i);
                shade(&shader, []).luma()
            })
        };
        assert_eq!(shown(&colors), [10, 20, 30, 30]);
        assert_eq!(shown(&[]), [0; 4]);
    }
}
