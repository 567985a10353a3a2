//! Shaders for debugging: they show depth and normals.

use core::marker::PhantomData;

use embedded_graphics::pixelcolor::Rgb888;

use super::{Fragment, PixelFormat, Precise, Shader};
use crate::mesh::Primitive;

/// Depth as gray: white is near, black is far.
///
#[cfg_attr(doc, doc = page_picture!("depth_view", "A ring that is bright in front and dark behind"))]
/// Whatever the format of the depth buffer, the view shows [`Fragment::depth`], which falls from 65535 at the near
/// plane toward 0. In perspective, this depth is linear in 1/distance, so most scenes are dark;
/// [`between`](Self::between) spreads a part of the range from black to white.
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::{Gray4, GrayColor}};
/// use fixel::prelude::*;
/// use fixel::{DepthView, Window};
/// static SQUARE: Mesh = shape!(plane(1, 1));
/// let projection = Projection::orthographic(Window::centered(fx!(2), fx!(2)), fx!(0), fx!(2))?;
/// let mvp = projection * Camera::top(Vec3::ZERO, fx!(1));
/// let mut pixels = [Gray4::BLACK; 16];
/// let mut canvas = Canvas::new(&mut pixels, 8, 2)?;
/// // Tilted out of the plane: the right side is nearer.
/// let slope = Transform::rotate_z(Angle::from_degrees(45)) * Transform::scale(fx!(1.414));
/// canvas.draw(&SQUARE, &(mvp * slope), &DepthView::new());
/// let mut display = MockDisplay::new();
/// canvas.show(&mut display)?;
/// display.assert_pattern(&[
///     "03478ACE",
///     "13569ADE",
/// ]);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct DepthView<C> {
    far: u16,
    range: u16,
    /// Left shift that moves the range's highest bit to bit 15.
    shift: u32,
    /// 2^31 divided by the shifted range: 2^15 to 2^16.
    gain: u32,
    color: PhantomData<C>,
}

impl<C> DepthView<C> {
    /// A view that shows depth 0 as black and depth 65535 as white.
    #[must_use]
    pub const fn new() -> Self {
        Self::between(0, u16::MAX)
    }

    /// A view that shows the depth `far` and all lower depths as black, and the depth `near` and all greater depths as
    /// white. If `near` is not greater than `far`, every depth above `far` is white.
    #[must_use]
    pub const fn between(far: u16, near: u16) -> Self {
        let range = match near.saturating_sub(far) {
            0 => 1,
            range => range,
        };
        let shift = range.leading_zeros();
        Self {
            far,
            range,
            shift,
            gain: (1 << 31) / ((range as u32) << shift),
            color: PhantomData,
        }
    }
}

impl<C> Default for DepthView<C> {
    fn default() -> Self {
        Self::new()
    }
}

impl<C: PixelFormat> Shader for DepthView<C> {
    type Color = Precise<C>;
    type Varyings = ();

    #[inline]
    fn varyings(&self, _: &Primitive<'_>) -> [(); 3] {
        [(); 3]
    }

    #[inline]
    fn shade(&self, at: &Fragment, (): ()) -> Option<Precise<C>> {
        let above = at.depth.saturating_sub(self.far).min(self.range);
        // Before the last shift, the product is at most 2^31. White becomes at least 65,536 − 2, because the gain is
        // rounded down.
        let fraction = ((u32::from(above) << self.shift) * self.gain) >> 15;
        let levels = C::MAX_STEPS.map(|white| white * fraction.cast_signed());
        Some(Precise::from_levels(levels))
    }
}

/// The direction of normals in world space as a color.
///
#[cfg_attr(doc, doc = page_picture!("normal_view", "A ring in the colors of its normals"))]
/// Red shows x, green shows y and blue shows z: dark at −1, half bright at 0, bright at +1. Gray canvases show the luma
/// of this color.
///
/// The view shows the mesh's normals, or each triangle's own normal if the mesh has none. A normal without a direction
/// is mid-gray. Between the vertices, the colors are interpolated, and not the directions.
///
/// ```
/// use embedded_graphics::pixelcolor::Rgb888;
/// use fixel::prelude::*;
/// use fixel::{NormalView, Window};
/// static SQUARE: Mesh = shape!(plane(1, 1));
/// let projection = Projection::orthographic(Window::centered(fx!(2), fx!(2)), fx!(0), fx!(2))?;
/// let mvp = projection * Camera::top(Vec3::ZERO, fx!(1));
/// let mut pixels = [Rgb888::new(0, 0, 0); 4];
/// let mut canvas = Canvas::new(&mut pixels, 2, 2)?;
/// canvas.draw(&SQUARE, &mvp, &NormalView::new());
/// // The normal is (0, 1, 0).
/// assert!(canvas.pixels().all(|pixel| pixel == Rgb888::new(128, 255, 128)));
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct NormalView<C> {
    color: PhantomData<C>,
}

impl<C> NormalView<C> {
    /// A view of normals, for a canvas of color `C`.
    #[must_use]
    pub const fn new() -> Self {
        Self { color: PhantomData }
    }
}

impl<C: PixelFormat> Shader for NormalView<C> {
    type Color = Precise<C>;
    type Varyings = Precise<C>;

    const READS_DEPTH: bool = false;

    #[inline]
    fn varyings(&self, primitive: &Primitive<'_>) -> [Self::Varyings; 3] {
        // A channel is 255 · (n + 1)/2, rounded to nearest; n is in units of 2^-30. The clamp is for unit vectors with
        // a component that is too great in its last bits.
        let channel = |n: i32| {
            let steps = (255 * (i64::from(n) + (1 << 30)) + (1 << 30)) >> 31;
            steps.clamp(0, 255).cast_unsigned() as u8
        };
        primitive.corners(|corner| {
            let [x, y, z] = corner.world_normal().to_bits();
            let color = Rgb888::new(channel(x), channel(y), channel(z));
            Precise::of_rgb(color)
        })
    }

    #[inline]
    fn shade(&self, _: &Fragment, color: Precise<C>) -> Option<Precise<C>> {
        Some(color)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fixtures::shader::{IDENTITY, face, scale, shade};
    use crate::{Mesh, Vec3, vec3};
    use embedded_graphics::geometry::Point;
    use embedded_graphics::pixelcolor::{BinaryColor, Gray8, GrayColor};

    fn gray(view: DepthView<Gray8>, depth: u16) -> u8 {
        let point = Point::zero();
        let color = view.shade(&Fragment { point, depth }, ()).unwrap();
        color.finish(point).luma()
    }

    #[test]
    fn depth_is_linear_and_saturates() {
        for depth in 0..=u16::MAX {
            let error = f64::from(gray(DepthView::new(), depth)) - f64::from(depth) / 257.0;
            // The tolerance beyond rounding is two units, each 2^-16 of white.
            assert!(error.abs() < 0.5 + 2.0 * 255.0 / 65536.0, "{depth}");
        }
        let view = DepthView::between(1000, 1255);
        assert_eq!([0, 1000, 1001, 1128].map(|d| gray(view, d)), [0, 0, 1, 128]);
        assert_eq!([1254, 1255, 65535].map(|d| gray(view, d)), [254, 255, 255]);
        for far in [0, 7, 65535] {
            assert_eq!(gray(DepthView::between(far, far), far), 0);
            assert_eq!(
                gray(DepthView::between(far, 0), far.saturating_add(1)),
                if far < 65535 { 255 } else { 0 }
            );
        }
    }

    #[test]
    fn nearest_is_white_where_dithered() {
        for i in 0..64 {
            for (depth, color) in [(0, BinaryColor::Off), (65535, BinaryColor::On)] {
                let point = Point::new(i % 8, i / 8);
                let shown = DepthView::<BinaryColor>::new().shade(&Fragment { point, depth }, ());
                assert_eq!(shown.unwrap().finish(point), color);
            }
        }
    }

    #[test]
    fn normals_have_the_color_of_their_direction() {
        let positions = [Vec3::ZERO, Vec3::X, Vec3::Y];
        let normals = [vec3!(5, 0, 0), vec3!(0, -1, 0), Vec3::ZERO];
        let mesh = Mesh::new(&positions, &[[0, 1, 2]])
            .and_then(|mesh| mesh.with_normals(&normals, None))
            .unwrap();
        let shown = |model| {
            let (shader, corners) = face(NormalView::<Rgb888>::new(), model, &mesh, 0);
            corners.map(|corner| shade(&shader, corner))
        };
        assert_eq!(
            shown(&IDENTITY),
            [
                Rgb888::new(255, 128, 128),
                Rgb888::new(128, 0, 128),
                Rgb888::new(128, 128, 128)
            ]
        );
        assert_eq!(
            shown(&scale([-(1 << 29), 1 << 29, 1 << 29]))[0],
            Rgb888::new(0, 128, 128)
        );
    }
}
