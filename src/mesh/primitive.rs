//! A shader's view of a mesh: a triangle, edge or point, and its corners.

use embedded_graphics::pixelcolor::Rgb888;

use super::Placement;
use super::index::{Element, Index, Indices};
use crate::math::{Direction, Vec2, Vec3};
use crate::num::Scalar;
use crate::num::wide::scaled_cross;

/// A triangle, edge or point of a mesh that is about to be drawn.
///
/// ```
/// use embedded_graphics::pixelcolor::Gray8;
/// use fixel::prelude::*;
/// use fixel::{Primitive, Window};
/// use fixel::shade::PerFace;
///
/// /// Faces that look up are light, others dark.
/// #[derive(Clone, Copy)]
/// struct Snow;
///
/// impl Shader for Snow {
///     type Color = Gray8;
///     type Varyings = PerFace<u8>;
///
///     fn varyings(&self, face: &Primitive) -> [PerFace<u8>; 3] {
///         [PerFace(if face.normal().y > fx!(0) { 250 } else { 50 }); 3]
///     }
///
///     fn shade(&self, _: &Fragment, PerFace(luma): PerFace<u8>) -> Option<Gray8> {
///         Some(Gray8::new(luma))
///     }
/// }
///
/// let mut pixels = [Gray8::new(0); 1];
/// let projection = Projection::orthographic(Window::centered(fx!(2), fx!(2)), fx!(0), fx!(9))?;
/// let from_above = Camera::top(Vec3::ZERO, fx!(5));
/// let positions = [vec3!(-9, 0, 9), vec3!(9, 0, 9), vec3!(0, 0, -9)];
/// let ground = Mesh::new(&positions, &[[0, 1, 2]])?;
/// let mut canvas = Canvas::new(&mut pixels, 1, 1)?;
/// canvas.draw(&ground, &(projection * from_above), &Snow);
/// assert_eq!(pixels, [Gray8::new(250)]);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Primitive<'a> {
    pub(crate) placement: &'a Placement<'a>,
    pub(crate) indices: Indices,
    /// For a triangle: twice its area on the screen, the upper 32 of 64 bits; negative if the corners run
    /// counter-clockwise.
    pub(crate) area: i32,
    /// For an outline's edge, if depths are biased: the greatest change of depth from one pixel to the next on the
    /// faces beside the edge, in the format [`WideFloatDepth`](crate::canvas::WideFloatDepth). The last bit says whether
    /// the edge is a crease between two faces that are turned the same way. Otherwise 0.
    pub(crate) slope_beside: u16,
    /// The address of the draw list's entry for this primitive; 0 if it does not come from a list.
    pub(crate) entry: usize,
}

impl Primitive<'_> {
    /// Whether this is a triangle with its front toward the eye, by the same rule as for culling; false for an edge or
    /// a point. With this function, a shader can give the two sides of a sheet different colors:
    ///
    /// ```
    /// use embedded_graphics::pixelcolor::Gray8;
    /// use fixel::prelude::*;
    /// use fixel::{Primitive, Window};
    /// use fixel::shade::PerFace;
    /// #[derive(Clone, Copy)]
    /// struct Card;
    /// impl Shader for Card {
    ///     type Color = Gray8;
    ///     type Varyings = PerFace<u8>;
    ///     fn varyings(&self, face: &Primitive) -> [PerFace<u8>; 3] {
    ///         [PerFace(if face.is_front() { 250 } else { 50 }); 3]
    ///     }
    ///     fn shade(&self, _: &Fragment, PerFace(luma): PerFace<u8>) -> Option<Gray8> {
    ///         Some(Gray8::new(luma))
    ///     }
    /// }
    /// static SQUARE: Mesh = shape!(plane(1, 1));
    /// let projection = Projection::orthographic(Window::centered(fx!(2), fx!(2)), fx!(0), fx!(9))?;
    /// let options = DrawOptions::new().with_cull(Cull::Nothing);
    /// for (turn, expected) in [(0, 250), (180, 50)] {
    ///     let mvp = projection * Camera::top(Vec3::ZERO, fx!(5)) * Transform::rotate_x(Angle::from_degrees(turn));
    ///     let mut pixels = [Gray8::new(0); 4];
    ///     Canvas::new(&mut pixels, 2, 2)?.draw_with(&options, &SQUARE, &mvp, &Card);
    ///     assert_eq!(pixels, [Gray8::new(expected); 4]);
    /// }
    /// # Ok::<(), Error>(())
    /// ```
    #[must_use]
    #[inline]
    pub const fn is_front(&self) -> bool {
        // An area of 0 does not matter, because a triangle without area has no pixels.
        self.indices.face().is_some() && (self.area < 0) != self.placement.view.is_mirror
    }

    /// The index of the triangle among the mesh's [`faces`](crate::Mesh::faces); `None` for an edge or a point. In a
    /// [part](crate::Mesh::part) of a mesh, triangles keep the indices that they have in the whole mesh.
    #[must_use]
    #[inline]
    pub const fn face(&self) -> Option<usize> {
        match self.indices.face() {
            // The sum cannot wrap, because it is an index of a list in memory.
            Some(face) => Some(self.placement.mesh.first_face.wrapping_add(face)),
            None => None,
        }
    }

    /// The index of the edge among the mesh's [`edge_indices`](crate::Mesh::edge_indices) or, if an outline is drawn, among
    /// the [outline's edges](super::Outline::edges); `None` for a triangle or a point.
    ///
    /// ```
    /// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Gray4};
    /// use fixel::prelude::*;
    /// use fixel::{Primitive, Window};
    /// use fixel::shade::PerFace;
    /// #[derive(Clone, Copy)]
    /// struct Numbered;
    /// impl Shader for Numbered {
    ///     type Color = Gray4;
    ///     type Varyings = PerFace<u8>;
    ///     fn varyings(&self, edge: &Primitive) -> [PerFace<u8>; 3] {
    ///         [PerFace(edge.edge().map_or(0, |edge| edge as u8 + 1)); 3]
    ///     }
    ///     fn shade(&self, _: &Fragment, PerFace(number): PerFace<u8>) -> Option<Gray4> {
    ///         Some(Gray4::new(number))
    ///     }
    /// }
    /// let corners = [vec3!(0, 0, 0), vec3!(3, 0, 0), vec3!(3, 3, 0)];
    /// let bent = Mesh::new(&corners, &[])?.with_edges(&[[0, 1], [1, 2]])?;
    /// let projection = Projection::orthographic(Window::centered(fx!(8), fx!(8)), fx!(-1), fx!(1))?;
    /// let mut pixels = [Gray4::new(0); 64];
    /// let mut canvas = Canvas::new(&mut pixels, 8, 8)?;
    /// canvas.draw(bent.edges(LineStyle::HAIRLINE), &projection, &Numbered);
    /// let mut display = MockDisplay::new();
    /// canvas.show(&mut display)?;
    /// display.assert_pattern(&[
    ///     "00000000",
    ///     "00000002",
    ///     "00000002",
    ///     "00000002",
    ///     "00001112",
    ///     "00000000",
    ///     "00000000",
    ///     "00000000",
    /// ]);
    /// # Ok::<(), Error>(())
    /// ```
    #[must_use]
    #[inline]
    pub const fn edge(&self) -> Option<usize> {
        match self.indices.element {
            Element::Edge(edge) => Some(edge),
            Element::Face(_) | Element::Point => None,
        }
    }

    /// Calls `f` with each of the three corners and returns the results. For an edge, the second end comes twice; for
    /// a point, all three corners are the same.
    #[must_use]
    #[inline]
    pub fn corners<T>(&self, mut f: impl FnMut(&Corner<'_>) -> T) -> [T; 3] {
        core::array::from_fn(|corner| {
            f(&Corner {
                primitive: self,
                corner,
            })
        })
    }

    /// Like [`corners`](Self::corners), for numbers that depend only on what `reads` says. They are looked up in the draw
    /// call's cache, if there is one and `keeps` is true. `numbers` has the right length.
    #[inline]
    pub(crate) fn cached_corners<N: Copy + AsRef<[i32]> + AsMut<[i32]>>(
        &self,
        (keeps, reads): (bool, Reads),
        numbers: N,
        mut f: impl FnMut(&Corner<'_>) -> N,
    ) -> [N; 3] {
        let cache = self.placement.corners.filter(|_| keeps);
        self.corners(
            |corner| match cache.and_then(|cache| Some((cache, corner.key(reads)?))) {
                Some((cache, key)) => cache.numbers(key, numbers, || f(corner)),
                None => f(corner),
            },
        )
    }

    /// The positions of the three corners in model space.
    #[must_use]
    pub fn positions(&self) -> [Vec3; 3] {
        let mesh = self.placement.mesh;
        self.indices.corners.map(|index| mesh.position(index))
    }

    /// The positions of the three corners in eye space, rounded to nearest; they saturate to the range of [`Scalar`].
    pub(crate) fn eye_positions(&self) -> [Vec3; 3] {
        let view = &self.placement.view;
        self.positions().map(|position| view.point(position))
    }

    /// The normal of the triangle's plane in model space: (b − a) × (c − a) for the corners a, b and c.
    ///
    /// The normal is scaled so that its largest component is between 16,384 and 32,768. For a triangle without area,
    /// the normal is zero. Sides are first rounded down to multiples of 2⁻¹⁵, so the normal is inaccurate unless the
    /// sides are much longer than 2⁻¹⁵.
    #[must_use]
    pub fn normal(&self) -> Vec3 {
        let [a, b, c] = self.positions().map(Vec3::to_bits);
        // A difference takes 33 bits; half of it fits into 32.
        let side = |from: i32, to: i32| ((i64::from(to) - i64::from(from)) >> 1) as i32;
        let [b, c] = [b, c].map(|p| [side(a[0], p[0]), side(a[1], p[1]), side(a[2], p[2])]);
        Vec3::from_bits(scaled_cross(b, c))
    }

    /// The direction of [`normal`](Self::normal) in world space, where lights are.
    #[must_use]
    pub fn world_normal(&self) -> Direction {
        self.placement.direction(self.normal())
    }

    /// The mean of the three corners in world space. The mean is computed in model space, accurate to 2⁻¹⁶. After the
    /// transform to world space, the mean is rounded to nearest, and saturates to the range of [`Scalar`].
    #[must_use]
    pub fn world_middle(&self) -> Vec3 {
        let [a, b, c] = self.positions().map(Vec3::to_bits);
        let mean = |a: i32, b: i32, c: i32| {
            let sum = i64::from(a) + i64::from(b) + i64::from(c);
            // The result is a third of a sum of 34 bits. The factor, 2^32 / 3, is rounded down, so that the product
            // fits into 64 bits.
            ((sum * 0x5555_5555 + (1 << 31)) >> 32) as i32
        };
        let middle = [
            mean(a[0], b[0], c[0]),
            mean(a[1], b[1], c[1]),
            mean(a[2], b[2], c[2]),
        ];
        self.placement.model.point(Vec3::from_bits(middle))
    }
}

/// What the numbers that an effect keeps for a corner depend on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Reads {
    Position,
    Normal,
    Both,
}

/// A corner of a triangle, an end of an edge, or a point that is about to be drawn.
///
/// ```
/// use embedded_graphics::pixelcolor::Gray8;
/// use fixel::prelude::*;
/// use fixel::Primitive;
///
/// /// Black at the eye, white at a distance of ten units.
/// #[derive(Clone, Copy)]
/// struct Fog;
///
/// impl Shader for Fog {
///     type Color = Gray8;
///     type Varyings = [i32; 1];
///
///     fn varyings(&self, primitive: &Primitive) -> [[i32; 1]; 3] {
///         primitive.corners(|corner| [corner.distance().to_bits()])
///     }
///
///     fn shade(&self, _: &Fragment, [distance]: [i32; 1]) -> Option<Gray8> {
///         Some(Gray8::new((distance / 2570).clamp(0, 255) as u8))
///     }
/// }
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Corner<'a> {
    primitive: &'a Primitive<'a>,
    corner: usize,
}

impl Corner<'_> {
    /// The index of the corner's position in the mesh's [`positions`](crate::Mesh::positions). A
    /// [part](crate::Mesh::part) of a mesh keeps all positions, so the indices are the same as in the whole mesh. Use
    /// the index to look up your own values, one per position.
    #[must_use]
    #[inline]
    pub fn index(&self) -> Index {
        let index = self.primitive.indices.corners.get(self.corner);
        index.copied().unwrap_or_default()
    }

    /// The indices of what `reads` says, in one number. `None` if other corners have a normal of their own, but this one
    /// has the normal of its triangle.
    #[inline]
    fn key(&self, reads: Reads) -> Option<u32> {
        let Primitive {
            placement, indices, ..
        } = self.primitive;
        let normals = &placement.mesh.normals;
        let position = u32::from(self.index());
        if reads == Reads::Position || normals.faces.is_none() {
            return Some(position);
        }
        let normal = normals.index(*indices, self.corner)?;
        if normal >= normals.values.len() {
            return None;
        }
        let normal = normal as u32;
        Some(match reads {
            Reads::Normal => normal,
            _ => position | normal << 16,
        })
    }

    /// The position in model space.
    #[must_use]
    #[inline]
    pub fn position(&self) -> Vec3 {
        let index = self.primitive.indices.corners.get(self.corner);
        index.map_or(Vec3::ZERO, |&index| {
            self.primitive.placement.mesh.position(index)
        })
    }

    /// The position in world space (where lights are), rounded to nearest and saturated to the range of [`Scalar`].
    #[must_use]
    #[inline]
    pub fn world_position(&self) -> Vec3 {
        self.primitive.placement.model.point(self.position())
    }

    /// The distance from the eye along the view direction: −z in eye space, saturated to the range of [`Scalar`].
    #[must_use]
    #[inline]
    pub fn distance(&self) -> Scalar {
        -self.primitive.placement.view.z(self.position())
    }

    /// The texture coordinate; (0, 0) if the mesh has none at this corner.
    #[must_use]
    #[inline]
    pub fn uv(&self) -> Vec2 {
        let Primitive {
            placement, indices, ..
        } = self.primitive;
        let uv = placement.mesh.uvs.at(*indices, self.corner);
        uv.unwrap_or_else(|| placement.lacks_uvs())
    }

    /// The normal in model space, of any length; the triangle's own normal if the mesh has none at this corner.
    #[must_use]
    #[inline]
    pub fn normal(&self) -> Vec3 {
        let Primitive {
            placement, indices, ..
        } = self.primitive;
        let normal = placement.mesh.normals.at(*indices, self.corner);
        normal.unwrap_or_else(|| self.primitive.normal())
    }

    /// The color; white if the mesh has none at this corner.
    #[must_use]
    #[inline]
    pub fn color(&self) -> Rgb888 {
        let Primitive {
            placement, indices, ..
        } = self.primitive;
        let color = placement.mesh.colors.full_at(*indices, self.corner);
        color.unwrap_or_else(|| placement.lacks_colors())
    }

    /// The direction of [`normal`](Self::normal) in world space, where lights are. The direction stays perpendicular to
    /// the surface if the model is stretched or mirrored.
    #[must_use]
    #[inline]
    pub fn world_normal(&self) -> Direction {
        self.primitive.placement.direction(self.normal())
    }

    /// The triangle, edge or point that has this corner.
    #[must_use]
    #[inline]
    pub const fn primitive(&self) -> &Primitive<'_> {
        self.primitive
    }
}

#[cfg(test)]
mod tests {
    use core::array::from_fn;

    use super::*;
    use crate::mesh::CornerCache;
    use crate::{Mesh, Transform, shape, vec3};

    /// The test includes corners at the ends of the range.
    #[test]
    fn the_middle_is_the_mean_of_the_corners() {
        let (least, most) = (i32::MIN, i32::MAX);
        for corners in [
            [least; 3],
            [most; 3],
            [most, most, most - 2],
            [least, least, least + 4],
            [least, most, most],
            [0, 1, 1],
            [-1, -1, 0],
        ] {
            let positions = corners.map(|x| Vec3::from_bits([x, 0, x]));
            let mesh = Mesh::new(&positions, &[[0, 1, 2]]).unwrap();
            let placement = Placement::new(&mesh, &Transform::IDENTITY, Transform::IDENTITY);
            let primitive = placement.primitive(Indices::of_face(0, [0, 1, 2]), 0);
            let [x, y, z] = primitive.world_middle().to_bits();
            let sum: i64 = corners.map(i64::from).iter().sum();
            // The result is within one unit of a third of the sum.
            assert!((3 * i64::from(x) - sum).abs() <= 3, "{corners:?}: {x}");
            assert_eq!((y, z), (0, x));
        }
    }

    /// A box has 8 positions and 6 normals, and 24 pairs of a position and a normal.
    #[test]
    fn numbers_are_kept_for_each_position_or_normal_or_both() {
        static BOX: Mesh = shape!(cuboid(vec3!(1, 2, 3)));
        for (reads, different) in [(Reads::Position, 8), (Reads::Normal, 6), (Reads::Both, 24)] {
            let cache = CornerCache::new();
            let mut placement = Placement::new(&BOX, &Transform::IDENTITY, Transform::IDENTITY);
            placement.corners = Some(&cache);
            let mut computed = 0;
            for (face, corners) in BOX.faces().iter().enumerate() {
                let primitive = placement.primitive(Indices::of_face(face, *corners), 0);
                let numbers = |corner: &Corner<'_>| {
                    let (position, normal) = (corner.position(), corner.normal());
                    let [position, normal] = [position, normal].map(Vec3::to_bits);
                    let is_read = [reads != Reads::Normal, reads != Reads::Position];
                    from_fn(|at| {
                        let of = [position, normal][at / 3][at % 3];
                        if is_read[at / 3] { of } else { 0 }
                    })
                };
                let kept = primitive.cached_corners((true, reads), [0; 6], |corner| {
                    computed += 1;
                    numbers(corner)
                });
                assert_eq!(kept, primitive.corners(numbers));
            }
            // The four corners of a side follow each other, so none of them is computed twice.
            assert_eq!(computed, different, "{reads:?}");
        }
    }
}
