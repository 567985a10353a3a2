//! The seam between geometry and colour: what a shader wants interpolated, and what it makes of it.

use embedded_graphics::geometry::Point;
use embedded_graphics::pixelcolor::PixelColor;

use crate::math::Transform;
use crate::mesh::{Corner, Face};
use crate::span::Tolerance;

/// A pixel about to be shaded.
///
/// ```
/// use embedded_graphics::{geometry::Point, pixelcolor::Gray8};
/// use fixel::prelude::*;
/// let pixel = Fragment { point: Point::new(4, 2), depth: 65535 };
/// assert_eq!(Flat::new(Gray8::new(7)).shade(&pixel, []), Some(Gray8::new(7)));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Fragment {
    /// Column and row in the frame, (0, 0) at the top left.
    pub point: Point,
    /// Depth in linear steps of 1/w, whatever the depth buffer: near plane 65535, falling towards 0 with distance.
    pub depth: u16,
}

/// How a surface is coloured: `N` values per vertex, interpolated in perspective, to a colour.
///
/// Two methods are needed: [`varyings`](Self::varyings) says what to interpolate, and
/// [`shade`](Self::shade) makes a colour of it, or `None` to leave the pixel as it is.
/// A varying is an `i32` in whatever unit the shader likes; it comes back in the same unit, off by
/// what the [mode](crate::span) may be: 60 units or so in the default one, and by as much it may exceed the range
/// of its triangle's corners. So let a unit be far below what is seen, such as 2⁻¹⁶.
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::{Rgb565, RgbColor}};
/// use fixel::prelude::*;
///
/// /// Stripes along the texture's u.
/// #[derive(Clone, Copy)]
/// struct Stripes;
///
/// impl Shader<1> for Stripes {
///     type Color = Rgb565;
///
///     fn varyings(&self, vertex: &Corner) -> [i32; 1] {
///         [vertex.uv().x.to_bits()] // 2^20 is 1
///     }
///
///     fn shade(&self, _: &Fragment, [u]: [i32; 1]) -> Option<Rgb565> {
///         Some(if u & 0x4_0000 == 0 { Rgb565::WHITE } else { Rgb565::RED })
///     }
/// }
///
/// static SQUARE: Mesh = shape!(plane(1, 1));
/// let projection = Projection::orthographic(Window::centered(fx!(2), fx!(2)), fx!(0), fx!(2))?;
/// let mvp = projection * Camera::top(Vec3::ZERO, fx!(1));
/// let mut pixels = [Rgb565::BLACK; 16];
/// let mut canvas = Canvas::new(&mut pixels, 8, 2)?;
/// canvas.draw(&SQUARE, &mvp, &Stripes);
/// let mut display = MockDisplay::new();
/// canvas.show(&mut display)?;
/// display.assert_pattern(&["WWRRWWRR", "WWRRWWRR"]);
/// # Ok::<(), Error>(())
/// ```
pub trait Shader<const N: usize>: Copy {
    /// The colour that comes out; the canvas must have the same.
    type Color: PixelColor;

    /// Whether [`shade`](Self::shade) looks at [`Fragment::depth`].
    ///
    /// Where neither it nor a depth buffer does, and there are no varyings, depth is not worked
    /// out, and the sample's is 0.
    const READS_DEPTH: bool = true;

    /// By how much each varying may be off where that spares dividing by w at every pixel, as it does in triangles that
    /// hardly change in depth: what is not seen. The modes [`Newton`](crate::span::Newton) and
    /// [`Fast`](crate::span::Fast) go by it.
    ///
    /// By default nothing. A shader around another one passes on that one's.
    const TOLERANCES: [Tolerance; N] = [Tolerance::Units(0); N];

    /// The values to interpolate, at one corner of a triangle or end of a line.
    fn varyings(&self, vertex: &Corner<'_>) -> [i32; N];

    /// The colour of a pixel, or `None` to leave both its colour and its depth as they are.
    fn shade(&self, sample: &Fragment, varyings: [i32; N]) -> Option<Self::Color>;

    /// This shader made ready for a draw call; `model` takes the mesh to world space.
    ///
    /// For what depends on the pose but not on the vertex, such as the transform of normals.
    #[must_use]
    #[inline]
    fn begin(self, model: &Transform) -> Self {
        let _ = model;
        self
    }

    /// This shader made ready for one triangle, before clipping; it may change the `corners`' varyings.
    ///
    /// For what is constant over a triangle, such as its colour.
    #[must_use]
    #[inline]
    fn face(self, corners: &mut [[i32; N]; 3], face: &Face<'_>) -> Self {
        let _ = (corners, face);
        self
    }
}
