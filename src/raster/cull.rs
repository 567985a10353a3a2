//! Face culling.

/// Which triangles are left out: those that show their back, those that show their front, or none.
///
/// A triangle shows its front if its corners run counter-clockwise on the screen. If a transform mirrors the mesh (its
/// matrix has a negative determinant), fixel reverses this rule: the corners of a front then run clockwise. So a
/// mirrored mesh still shows the outside of its faces. Unlike in OpenGL, do not change the culling for a transform that
/// mirrors, for a [mirrored camera](crate::Camera::mirrored), or for the [shadow](crate::Transform::shadow) of a closed
/// mesh.
///
/// ```
/// use embedded_graphics::pixelcolor::Gray8;
/// use fixel::prelude::*;
/// use fixel::NormalView;
/// static BOX: Mesh = shape!(cuboid(vec3!(1, 2, 3)));
/// let projection = Projection::perspective(deg!(60), (32, 24), fx!(1), fx!(20))?;
/// let pose = Transform::translate(vec3!(2, 0, -9)) * Transform::rotate_y(deg!(30));
/// let mirror = Transform::scale_axes(vec3!(-1, 1, 1));
/// let mut shown = [pose, mirror * pose].map(|model| {
///     let mut pixels = [Gray8::new(0); 32 * 24];
///     let mut canvas = Canvas::new(&mut pixels, 32, 24).unwrap();
///     canvas.draw(&BOX, &(projection * model), &NormalView::<Gray8>::new());
///     pixels.map(|pixel| pixel != Gray8::new(0))
/// });
/// shown[1].chunks_mut(32).for_each(|row| row.reverse());
/// assert_eq!(shown[0], shown[1]);
/// # Ok::<(), Error>(())
/// ```
///
/// ```
/// use fixel::prelude::*;
/// let both_sides: DrawOptions = DrawOptions::new().with_cull(Cull::Nothing);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Cull {
    /// No triangles: both sides are drawn.
    Nothing,
    /// Triangles seen from behind.
    #[default]
    Back,
    /// Triangles seen from the front.
    Front,
}

impl Cull {
    /// Whether a triangle is culled; `area` is positive if its corners run clockwise on the screen.
    #[inline]
    pub(crate) const fn leaves_out(self, area: i64) -> bool {
        match self {
            Self::Nothing => area == 0,
            Self::Back => area >= 0,
            Self::Front => area <= 0,
        }
    }

    /// The same choice, as a choice of windings on the screen. If the mesh is mirrored, front and back are exchanged.
    #[inline]
    pub(crate) const fn mirrored(self, is_mirror: bool) -> Self {
        match self {
            Self::Back if is_mirror => Self::Front,
            Self::Front if is_mirror => Self::Back,
            cull => cull,
        }
    }
}
