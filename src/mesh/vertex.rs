//! A mesh as a shader sees it: one corner, one face.

use embedded_graphics::pixelcolor::{Rgb888, RgbColor};

use super::mesh::{Element, Mesh};
use crate::math::Transform;
use crate::{Scalar, Vec2, Vec3};

/// One triangle of a mesh, on its way to be drawn.
///
/// ```
/// use embedded_graphics::pixelcolor::Gray8;
/// use fixel::prelude::*;
///
/// /// Faces that look up are light, others dark.
/// #[derive(Clone, Copy)]
/// struct Snow(u8);
///
/// impl Shader<0> for Snow {
///     type Color = Gray8;
///
///     fn varyings(&self, _: &Corner) -> [i32; 0] {
///         []
///     }
///
///     fn face(self, _: &mut [[i32; 0]; 3], face: &Face) -> Self {
///         Self(if face.normal().y > 0 { 250 } else { 50 })
///     }
///
///     fn shade(&self, _: &Fragment, _: [i32; 0]) -> Option<Gray8> {
///         Some(Gray8::new(self.0))
///     }
/// }
///
/// let mut pixels = [Gray8::new(0); 1];
/// let projection = Projection::orthographic(Window::centered(fx!(2), fx!(2)), fx!(0), fx!(9))?;
/// let from_above = Camera::top(Vec3::ZERO, fx!(5));
/// let positions = [vec3!(-9, 0, 9), vec3!(9, 0, 9), vec3!(0, 0, -9)];
/// let ground = Mesh::new(&positions, &[[0, 1, 2]])?;
/// let mut canvas = Canvas::new(&mut pixels, 1, 1)?;
/// canvas.draw(&ground, &(projection * from_above * Transform::IDENTITY), &Snow(0));
/// assert_eq!(pixels, [Gray8::new(250)]);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Face<'a> {
    pub(crate) mesh: &'a Mesh<'a>,
    /// From model to eye space.
    pub(crate) view: &'a Transform,
    pub(crate) element: Element,
}

impl Face<'_> {
    /// Which triangle of the mesh this is, the first being 0; an edge or point counts as triangle 0.
    #[must_use]
    pub const fn index(&self) -> usize {
        match self.element.face {
            Some(face) => face,
            None => 0,
        }
    }

    /// The three corners in model space.
    #[must_use]
    pub fn positions(&self) -> [Vec3; 3] {
        self.element.indices.map(|index| self.mesh.position(index))
    }

    /// The texture coordinates of the corners; (0, 0) where the mesh has none.
    #[must_use]
    #[inline]
    pub fn uvs(&self) -> [Vec2; 3] {
        [0, 1, 2].map(|corner| self.mesh.uv(self.element, corner).unwrap_or_default())
    }

    /// The plane's normal in model space, (b − a) × (c − a), scaled to a largest component between
    /// 8192 and 32768, so that a small triangle's direction is as good as a large one's;
    /// zero for a triangle without area.
    #[must_use]
    pub fn normal(&self) -> Vec3 {
        let [a, b, c] = self.positions().map(Vec3::to_bits);
        // Differences take 33 bits; halved they fit 32 and the difference of two products 64.
        let side = |from: i32, to: i32| (i64::from(to) - i64::from(from)) >> 1;
        let [b, c] = [b, c].map(|p| [side(a[0], p[0]), side(a[1], p[1]), side(a[2], p[2])]);
        let cross = |i: usize, j: usize| (b[i] * c[j]).saturating_sub(b[j] * c[i]);
        let normal = [cross(1, 2), cross(2, 0), cross(0, 1)];
        let bits = normal.iter().fold(0, |all, x| all | x.unsigned_abs());
        // One leading zero stays, for the sign.
        let up = bits.leading_zeros().clamp(1, 63) - 1;
        Vec3::from_bits(normal.map(|x| ((x << up) >> 32) as i32))
    }
}

/// One corner of a triangle or end of a line, on its way to be drawn.
///
/// ```
/// use embedded_graphics::pixelcolor::Gray8;
/// use fixel::prelude::*;
///
/// /// Fog: what is ten units away is white, what is at the eye black.
/// #[derive(Clone, Copy)]
/// struct Fog;
///
/// impl Shader<1> for Fog {
///     type Color = Gray8;
///
///     fn varyings(&self, vertex: &Corner) -> [i32; 1] {
///         [vertex.distance().to_bits()]
///     }
///
///     fn shade(&self, _: &Fragment, [distance]: [i32; 1]) -> Option<Gray8> {
///         Some(Gray8::new((distance / 2570).clamp(0, 255) as u8))
///     }
/// }
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Corner<'a> {
    pub(crate) face: &'a Face<'a>,
    pub(crate) corner: usize,
}

impl Corner<'_> {
    /// The position in model space.
    #[must_use]
    #[inline]
    pub fn position(&self) -> Vec3 {
        match self.face.element.indices.get(self.corner) {
            Some(&index) => self.face.mesh.position(index),
            None => Vec3::ZERO,
        }
    }

    /// The distance ahead of the eye: −z in eye space, saturated to the format.
    #[must_use]
    #[inline]
    pub fn distance(&self) -> Scalar {
        self.face.view.point(self.position()).z.saturating_neg()
    }

    /// The texture coordinate; (0, 0) where the mesh has none.
    #[must_use]
    #[inline]
    pub fn uv(&self) -> Vec2 {
        self.face
            .mesh
            .uv(self.face.element, self.corner)
            .unwrap_or_default()
    }

    /// The normal in model space, of any length; where the mesh has none, the triangle's own.
    #[must_use]
    #[inline]
    pub fn normal(&self) -> Vec3 {
        match self.face.mesh.normal(self.face.element, self.corner) {
            Some(normal) => normal,
            None => self.face.normal(),
        }
    }

    /// The colour; white where the mesh has none.
    #[must_use]
    #[inline]
    pub fn color(&self) -> Rgb888 {
        self.face
            .mesh
            .color(self.face.element, self.corner)
            .unwrap_or(Rgb888::WHITE)
    }

    /// The triangle that this is a corner of.
    #[must_use]
    #[inline]
    pub fn face(&self) -> &Face<'_> {
        self.face
    }
}
