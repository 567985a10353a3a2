//! The box around a mesh.

use super::Mesh;
use crate::math::Vec3;

/// A box with sides parallel to the axes of model space, such as the smallest one around a mesh.
///
/// A mesh [keeps](Mesh::with_bounds) its box, so that a draw call ends after one test if the mesh is out of view.
/// [`Canvas::is_in_view`](crate::Canvas::is_in_view) uses the box to tell whether a mesh may have pixels in the canvas,
/// and [`Viewport::rectangle_on_screen`](crate::Viewport::rectangle_on_screen) returns a rectangle that contains these
/// pixels. If the box is stored in a `static`, the compiler computes it:
///
/// ```
/// use fixel::mesh::Bounds;
/// use fixel::prelude::*;
/// static BALL: Mesh = shape!(sphere(16, 12));
/// static BOUNDS: Bounds = BALL.bounds();
/// assert_eq!(BOUNDS, Bounds::new(vec3!(-1, -1, -1), vec3!(1, 1, 1)));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Bounds {
    /// The corner with the least coordinates.
    pub least: Vec3,
    /// The corner with the greatest coordinates.
    pub most: Vec3,
}

impl Bounds {
    /// The box that has these two points as opposite corners.
    #[must_use]
    pub const fn new(a: Vec3, b: Vec3) -> Self {
        Self { least: a, most: a }.with(b)
    }

    /// The smallest box around this box and a point.
    #[must_use]
    pub const fn with(self, point: Vec3) -> Self {
        let ([mut least, mut most], point) =
            ([self.least.to_bits(), self.most.to_bits()], point.to_bits());
        let mut axis = 0;
        while axis < 3 {
            if point[axis] < least[axis] {
                least[axis] = point[axis];
            }
            if point[axis] > most[axis] {
                most[axis] = point[axis];
            }
            axis += 1;
        }
        Self {
            least: Vec3::from_bits(least),
            most: Vec3::from_bits(most),
        }
    }
}

impl Mesh<'_> {
    /// The mesh with a box around all of its positions. If the box is out of view, a draw call ends after one test,
    /// however large the mesh is.
    ///
    /// Meshes of [`shape!`](crate::shape), [`include_mesh!`](crate::include_mesh) and [`checked`](Self::checked) have
    /// their [`bounds`](Self::bounds) from the start. For positions that are made while the program runs, such as
    /// [keyframes](super::Keyframes), give a box that contains all positions at all times. A position outside the box
    /// may not be drawn.
    ///
    /// In a program that is optimized for size (`opt-level` "s" or "z"), draw calls do not test boxes;
    /// [`is_in_view`](crate::Canvas::is_in_view) does.
    ///
    /// ```
    /// use fixel::mesh::Bounds;
    /// use fixel::prelude::*;
    /// let flag = [vec3!(0, 0, 0), vec3!(1, 0, 0.1), vec3!(1, 1, -0.1)]; // waves by up to 0.2
    /// let mesh = Mesh::new(&flag, &[[0, 1, 2]])?
    ///     .with_bounds(Bounds::new(vec3!(0, 0, -0.2), vec3!(1, 1, 0.2)));
    /// # Ok::<(), Error>(())
    /// ```
    #[must_use]
    pub const fn with_bounds(self, bounds: Bounds) -> Self {
        let positions = self.positions.with_bounds(bounds);
        Self { positions, ..self }
    }

    /// Finds the smallest box around all positions, with sides parallel to the axes; if there are no positions, the box
    /// contains only the origin.
    #[must_use]
    pub const fn bounds(&self) -> Bounds {
        let positions = self.positions();
        let Some(first) = positions.get(0) else {
            return Bounds::new(Vec3::ZERO, Vec3::ZERO);
        };
        let mut bounds = Bounds::new(first, first);
        let mut at = 1;
        while let Some(position) = positions.get(at) {
            bounds = bounds.with(position);
            at += 1;
        }
        bounds
    }
}
