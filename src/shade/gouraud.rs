//! Interpolated vertex colors.

use core::marker::PhantomData;

use super::{Fragment, PixelFormat, Precise, Shader};
use crate::mesh::Primitive;

/// The mesh's vertex colors, interpolated in correct perspective; white if the mesh has no colors.
///
#[cfg_attr(doc, doc = page_picture!("gouraud", "A cube whose corners' colors flow into each other"))]
/// The canvas's color type decides how the vertex colors are interpolated and rounded: see
/// [`PixelFormat`](super::PixelFormat). Gray is interpolated as one value.
///
/// ```
/// use embedded_graphics::mock_display::MockDisplay;
/// use embedded_graphics::pixelcolor::{Gray4, GrayColor, Rgb888, RgbColor};
/// use fixel::prelude::*;
/// use fixel::Window;
/// static SQUARE: Mesh = shape!(plane(1, 1));
/// let projection = Projection::orthographic(Window::centered(fx!(2), fx!(2)), fx!(0), fx!(2))?;
/// let mvp = projection * Camera::top(Vec3::ZERO, fx!(1));
/// let mut pixels = [Gray4::BLACK; 16];
/// let mut canvas = Canvas::new(&mut pixels, 8, 2)?;
/// let (left, right) = (Rgb888::BLACK, Rgb888::WHITE);
/// let colors = [left, right, left, right];
/// let mesh = SQUARE.with_colors(&colors, None)?;
/// canvas.draw(&mesh, &mvp, &Gouraud::new());
/// let mut display = MockDisplay::new();
/// canvas.show(&mut display)?;
/// // Sixteen grays are few, so they are dithered.
/// display.assert_pattern(&[
///     "03478ACE",
///     "13569ADE",
/// ]);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Gouraud<C> {
    color: PhantomData<C>,
}

impl<C> Gouraud<C> {
    /// A shader of the vertex colors, for a canvas of color `C`.
    #[must_use]
    pub const fn new() -> Self {
        Self { color: PhantomData }
    }
}

impl<C: PixelFormat> Shader for Gouraud<C> {
    type Color = Precise<C>;
    type Varyings = Precise<C>;

    #[inline]
    fn varyings(&self, primitive: &Primitive<'_>) -> [Self::Varyings; 3] {
        primitive.corners(|corner| Precise::of_rgb(corner.color()))
    }

    #[inline]
    fn shade(&self, _: &Fragment, color: Precise<C>) -> Option<Precise<C>> {
        Some(color)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fixtures::shader::{IDENTITY, count, face, shade};
    use crate::{Mesh, Vec3};
    use embedded_graphics::pixelcolor::{BinaryColor, Gray8, Rgb565, Rgb888, RgbColor};

    #[test]
    fn corners_have_their_own_colors() {
        let positions = [Vec3::ZERO, Vec3::X, Vec3::Y];
        let colors = [Rgb888::RED, Rgb888::new(0, 128, 255), Rgb888::WHITE];
        let mesh = Mesh::new(&positions, &[[0, 1, 2]])
            .and_then(|mesh| mesh.with_colors(&colors, None))
            .unwrap();
        let (shader, corners) = face(Gouraud::<Rgb565>::new(), &IDENTITY, &mesh, 0);
        let shown = corners.map(|corner| shade(&shader, corner));
        assert_eq!(shown, [Rgb565::RED, Rgb565::new(0, 32, 31), Rgb565::WHITE]);
        let (shader, corners) = face(Gouraud::<Gray8>::new(), &IDENTITY, &mesh, 0);
        let shown = corners.map(|corner| shade(&shader, corner));
        assert_eq!(shown, [76, 104, 255].map(Gray8::new));
    }

    #[test]
    fn gray_is_one_value() {
        assert_eq!(count(&Gouraud::<Rgb565>::new()), 3);
        assert_eq!(count(&Gouraud::<BinaryColor>::new()), 1);
    }
}
