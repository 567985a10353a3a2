//! Meshes whose attributes have 8 or 16 bits.

use core::ops::Range;

use embedded_graphics::pixelcolor::{Rgb888, RgbColor};

use super::attribute::Attribute;
use super::{Index, Indices, Mesh, Positions, Primitive};
use crate::{Vec2, Vec3};

/// A mesh that takes less flash: positions have 16 bits a component, normals 8 bits, and texture coordinates 16 or 8
/// bits.
///
/// [`shape!`](crate::shape) and [`include_mesh!`](crate::include_mesh) make it with the argument `quantized_16` or
/// `quantized_8`; the number is the bits of a texture coordinate:
///
/// | list | bytes in a [`Mesh`] | here | largest error |
/// |---|---|---|---|
/// | positions | 12 | 6 | see [`Mesh::short`] |
/// | normals | 12 | 3 | 0.32 degrees |
/// | texture coordinates, `quantized_16` | 8 | 4 | 1/131,070 of their range, and 2⁻²¹ repeats |
/// | texture coordinates, `quantized_8` | 8 | 2 | 1/510 of their range, and 2⁻²¹ repeats |
///
/// A normal's largest component becomes ±127, and the others are rounded to nearest, halves up. This turns the normal
/// by at most asin(√½ / 127). For u and v each, the range from the least texture coordinate to the greatest is divided
/// into equal steps. Where coordinates run from 0 to 1, a texture with 64 texels in a row moves by up to 1/2048 texel
/// with 16 bits, and by up to 1/8 texel with 8.
///
/// Draw the [`mesh`](Self::mesh) like any other, with a shader that [`shader`](Self::shader) has wrapped. The wrapper
/// unpacks the attributes of each triangle that is drawn; for normals, this takes 130 instructions on Cortex-M4. Its
/// code takes 1.4 KB, so a quantized mesh saves flash if it has more than about 70 vertices.
///
/// ```
/// use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor};
/// use fixel::mesh::Quantized;
/// use fixel::prelude::*;
/// static BALL: Quantized = shape!(sphere(16, 12), quantized_8).without_uvs();
/// let mut pixels = [Rgb565::BLACK; 64];
/// let mut canvas = Canvas::new(&mut pixels, 8, 8)?;
/// let projection = Projection::perspective(deg!(60), (1, 1), fx!(1), fx!(10))?;
/// let mvp = projection * Transform::translate(vec3!(0, 0, -3));
/// let sun = Light::new(vec3!(1, 2, 3), fx!(0.2), fx!(0.8))?;
/// let clay = Flat::rgb(Rgb888::new(236, 214, 190)).lit(sun);
/// canvas.draw(BALL.mesh(), &mvp, &BALL.shader(clay));
/// assert_ne!(pixels[4 * 8 + 4], Rgb565::BLACK);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Quantized<'a> {
    mesh: Mesh<'a>,
    normals: Attribute<'a, [i8; 3]>,
    uvs: Uvs<'a>,
    grid: UvGrid,
}

/// Texture coordinates, in steps of a grid.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub enum StoredUvs<'a> {
    Bytes(&'a [[u8; 2]]),
    Words(&'a [[u16; 2]]),
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
enum Uvs<'a> {
    Bytes(Attribute<'a, [u8; 2]>),
    Words(Attribute<'a, [u16; 2]>),
}

/// Equal steps from the least texture coordinate to the greatest: `origin` + n · `step`, in units of 2⁻²⁰.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct UvGrid {
    origin: [i32; 2],
    step: [u32; 2],
}

impl UvGrid {
    /// The grid around these texture coordinates, with `most` steps.
    #[must_use]
    pub const fn around(uvs: &[Vec2], most: u16) -> Self {
        let (mut origin, mut step) = ([0; 2], [0; 2]);
        let mut axis = 0;
        while axis < 2 && !uvs.is_empty() {
            let (mut low, mut high) = (i32::MAX, i32::MIN);
            let mut at = 0;
            while at < uvs.len() {
                let bits = uvs[at].to_bits()[axis];
                low = if bits < low { bits } else { low };
                high = if bits > high { bits } else { high };
                at += 1;
            }
            origin[axis] = low;
            step[axis] = high.abs_diff(low).div_ceil(most as u32);
            axis += 1;
        }
        Self { origin, step }
    }

    /// The nearest point of the grid, in steps.
    #[must_use]
    pub const fn nearest(&self, uv: Vec2) -> [u16; 2] {
        let mut steps = [0; 2];
        let mut axis = 0;
        while axis < 2 {
            let from_origin = uv.to_bits()[axis].abs_diff(self.origin[axis]);
            let step = self.step[axis];
            if step > 0 {
                // At most `most`, because that many steps reach the greatest coordinate.
                steps[axis] = ((from_origin as u64 + step as u64 / 2) / step as u64) as u16;
            }
            axis += 1;
        }
        steps
    }

    /// A point of the grid. (The last one may lie beyond the greatest coordinate by less than a unit a step.)
    fn uv(&self, [u, v]: [u16; 2]) -> Vec2 {
        let bits = |axis: usize, steps: u16| {
            let beyond = u64::from(steps) * u64::from(self.step[axis]);
            let wide = i64::from(self.origin[axis]) + beyond.cast_signed();
            wide.min(i32::MAX.into()) as i32
        };
        Vec2::from_bits([bits(0, u), bits(1, v)])
    }
}

/// The largest component of a stored normal.
const LONGEST: i64 = 127;
/// The shift that makes a stored normal about as long as one in the bits of a `Vec3`.
const UP: u32 = 9;

/// A normal with 8 bits a component: the largest becomes 127, others are rounded to nearest, halves up.
#[must_use]
pub const fn short_normal(normal: Vec3) -> [i8; 3] {
    let bits = normal.to_bits();
    let mut most = 0;
    let mut axis = 0;
    while axis < 3 {
        let size = (bits[axis] as i64).abs();
        most = if size > most { size } else { most };
        axis += 1;
    }
    let mut short = [0; 3];
    let mut axis = 0;
    while axis < 3 && most > 0 {
        let twice = 2 * LONGEST * bits[axis] as i64 + most;
        short[axis] = twice.div_euclid(2 * most) as i8;
        axis += 1;
    }
    short
}

fn long_normal(short: [i8; 3]) -> Vec3 {
    Vec3::from_bits(short.map(|x| i32::from(x) << UP))
}

impl<'a> Quantized<'a> {
    /// The mesh with these lists, which are known to fit it; it must have neither normals nor texture coordinates of its
    /// own. Lists of faces may be empty.
    #[doc(hidden)]
    #[must_use]
    pub const fn new(
        mesh: Mesh<'a>,
        normals: (&'a [[i8; 3]], &'a [[Index; 3]]),
        (uvs, uv_faces): (StoredUvs<'a>, &'a [[Index; 3]]),
        grid: UvGrid,
    ) -> Self {
        Self {
            normals: Attribute::of_lists(normals),
            uvs: match uvs {
                StoredUvs::Bytes(uvs) => Uvs::Bytes(Attribute::of_lists((uvs, uv_faces))),
                StoredUvs::Words(uvs) => Uvs::Words(Attribute::of_lists((uvs, uv_faces))),
            },
            mesh,
            grid,
        }
    }

    /// The mesh without normals and texture coordinates, to be drawn with a shader that [`shader`](Self::shader) made.
    #[must_use]
    pub const fn mesh(&self) -> &Mesh<'a> {
        &self.mesh
    }

    /// The mesh reduced to a range of its triangles, as [`Mesh::part`] does.
    #[must_use]
    pub fn part(&self, faces: Range<usize>) -> Self {
        let faces = self.mesh.part_range(&faces);
        Self {
            mesh: self.mesh.part(faces.clone()),
            normals: self.normals.part(&faces),
            uvs: match self.uvs {
                Uvs::Bytes(uvs) => Uvs::Bytes(uvs.part(&faces)),
                Uvs::Words(uvs) => Uvs::Words(uvs.part(&faces)),
            },
            ..*self
        }
    }

    /// The mesh without its texture coordinates. A `static` of the result takes no flash for them.
    #[must_use]
    pub const fn without_uvs(self) -> Self {
        let uvs = Uvs::Bytes(Attribute::NONE);
        Self { uvs, ..self }
    }

    /// The mesh without its normals. A `static` of the result takes no flash for them. Light then falls on flat faces.
    #[must_use]
    pub const fn without_normals(self) -> Self {
        let normals = Attribute::NONE;
        Self { normals, ..self }
    }

    /// The mesh without its edges. A `static` of the result takes no flash for them.
    #[must_use]
    pub const fn without_edges(self) -> Self {
        let mesh = self.mesh.without_edges();
        Self { mesh, ..self }
    }

    /// Calls `f` with the primitive that has the unpacked attributes.
    #[inline]
    pub(crate) fn unpacked<T>(
        &self,
        primitive: &Primitive<'_>,
        f: impl FnOnce(&Primitive<'_>) -> T,
    ) -> T {
        let indices = primitive.indices;
        let normals = all(
            |corner| Some(long_normal(self.normals.at(indices, corner)?)),
            || primitive.normal(),
        );
        let uvs = all(|corner| self.uv(indices, corner), Vec2::default);
        let colors = all(
            |corner| primitive.mesh.colors.at(indices, corner),
            || Rgb888::WHITE,
        );
        let positions = primitive.positions();
        let mut mesh = Mesh::of_lists(
            Positions::long(&positions),
            (&[], &[]),
            (uvs.as_slice().as_flattened(), &[]),
            (normals.as_slice().as_flattened(), &[]),
            (colors.as_slice().as_flattened(), &[]),
        );
        mesh.first_face = primitive.mesh.first_face;
        f(&Primitive {
            mesh: &mesh,
            placement: primitive.placement,
            indices: Indices {
                element: indices.element,
                corners: [0, 1, 2],
            },
        })
    }

    fn uv(&self, indices: Indices, corner: usize) -> Option<Vec2> {
        let steps = match self.uvs {
            Uvs::Bytes(uvs) => uvs.at(indices, corner)?.map(u16::from),
            Uvs::Words(uvs) => uvs.at(indices, corner)?,
        };
        Some(self.grid.uv(steps))
    }
}

/// The values at the three corners, some of which may be `missing`; `None` if all are.
fn all<T: Copy>(value: impl Fn(usize) -> Option<T>, missing: impl Fn() -> T) -> Option<[T; 3]> {
    let values = [value(0), value(1), value(2)];
    if values.iter().all(Option::is_none) {
        return None;
    }
    Some(values.map(|value| value.unwrap_or_else(&missing)))
}
