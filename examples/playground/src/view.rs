//! The settings of a picture that the page asks for.

use core::ops::Range;

use embedded_graphics::geometry::Size;
use fixel::prelude::*;
use fixel::view::Perspective;

/// The settings of a picture. The page writes them as 32-bit numbers, in this order.
#[derive(Clone, Copy, Debug)]
#[repr(C)]
pub struct View {
    /// An index of `Scene::ALL`.
    pub scene: u32,
    /// 0 `Exact`, 1 `Newton`, 2 `Fast`, 3 `Affine`, 4 `Compact`.
    pub mode: u32,
    /// Of mode `Fast`, in units of 2^-16 texel.
    pub tolerance: i32,
    pub width: u32,
    pub height: u32,
    /// The first row of a band, and its number of rows.
    pub first_row: u32,
    pub rows: u32,
    /// 1 for the scene's own camera, in which it is measured.
    pub is_home: u32,
    /// The eye's turn about the center, as fractions of 2^32.
    pub yaw: u32,
    pub pitch: u32,
    /// From the center, in units of 2^-16 like all lengths.
    pub distance: i32,
    pub center: [i32; 3],
    /// The model's size.
    pub scale: i32,
    /// Vertical field of view, as a fraction of 2^32.
    pub fov: u32,
    pub near: i32,
    pub far: i32,
    /// Turns of the eye by less than a pixel, to the right and down.
    pub shift: [u32; 2],
    /// 1 if back faces are drawn too.
    pub is_two_sided: u32,
    /// 1 for a display in black and white.
    pub is_mono: u32,
}

impl View {
    pub const EMPTY: Self = Self {
        scene: 0,
        mode: 0,
        tolerance: 0,
        width: 0,
        height: 0,
        first_row: 0,
        rows: 0,
        is_home: 0,
        yaw: 0,
        pitch: 0,
        distance: 0,
        center: [0; 3],
        scale: 0,
        fov: 0,
        near: 0,
        far: 0,
        shift: [0; 2],
        is_two_sided: 0,
        is_mono: 0,
    };

    pub fn size(&self) -> Size {
        Size::new(self.width, self.height)
    }

    /// The band's pixels in the frame's memory.
    pub fn band(&self) -> Range<usize> {
        let pixels = |rows: u32| (self.width as usize).saturating_mul(rows as usize);
        pixels(self.first_row)..pixels(self.first_row.saturating_add(self.rows))
    }

    pub fn cull(&self) -> Cull {
        if self.is_two_sided == 0 {
            Cull::Back
        } else {
            Cull::Nothing
        }
    }

    /// The eye on a sphere around the center, looking at it.
    ///
    /// # Errors
    ///
    /// The field of view, a plane or the size is out of range.
    pub fn mvp(&self) -> Result<Mvp<Perspective>, Error> {
        let scalar = Scalar::from_bits;
        let projection = Projection::perspective(
            Angle::from_bits(self.fov),
            (self.width, self.height),
            scalar(self.near),
            scalar(self.far),
        )?;
        let [right, down] = self.shift.map(Angle::from_bits);
        let view = Transform::rotate_x(down)
            * Transform::rotate_y(right)
            * Transform::translate(Vec3::new(fx!(0), fx!(0), -scalar(self.distance)))
            * Transform::rotate_x(Angle::from_bits(self.pitch))
            * Transform::rotate_y(Angle::from_bits(self.yaw))
            * Transform::translate(-Vec3::from_bits(self.center));
        Ok(projection * Camera::from_view(view) * Transform::scale(scalar(self.scale)))
    }
}
