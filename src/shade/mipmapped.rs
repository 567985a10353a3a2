//! Textures with mipmap levels: each pixel shows the level that suits its distance.

use embedded_graphics::geometry::Size;

use super::{Fragment, PerFace, Shader, Texel, Texels, Textured};
use crate::error::Error;
use crate::math::Vec3;
use crate::mesh::Primitive;
use crate::num::log2;
use crate::texture::{Blend, Filter, Nearest, Sampler, Trilinear};
use crate::view::{Projection, Viewport};

/// The density of edges and points: less than the density of any triangle, so that edges and points have level 0.
const FINEST: i32 = -(1 << 20);

/// The type parameter `D` of a [`Textured`] that is [`mipmapped`](Textured::mipmapped). It chooses the level of each
/// pixel.
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Mipmapped {
    /// log₂((near · 65,536)² · pixel), with 8 fraction bits; `pixel` is a pixel's size at a distance of 1.
    scale: i32,
}

impl<S: Sampler, const CLAMPED: bool, F> Textured<S, CLAMPED, F> {
    /// Shows at each pixel the level of a [`Mipmap`](crate::texture::Mipmap) that suits the pixel's distance, so that
    /// the texture does not flicker far away. `projection` is the projection of the draw call. `frame` is the size of
    /// the frame in pixels. For a draw call with a viewport, pass the size of the viewport instead.
    ///
    #[cfg_attr(doc, doc = page_picture!("mipmapped", "A tiled floor: the left half without mipmaps flickers in the distance, the right half is even"))]
    /// A pixel shows the nearest texel of the nearest level, a blend of four texels of that level
    /// ([`bilinear`](Self::bilinear)), or a blend of two levels ([`trilinear`](Self::trilinear)).
    ///
    /// ```
    /// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::{Gray4, Gray8, GrayColor}};
    /// use fixel::{prelude::*, texture::Mipmap};
    /// static FLOOR: Mesh = shape!(plane(1, 1));
    /// // Black and white stripes of one texel; the levels above are gray.
    /// let mut texels = [Gray8::BLACK; Mipmap::<Gray8>::len(16, 16)];
    /// texels[..256].iter_mut().step_by(2).for_each(|texel| *texel = Gray8::WHITE);
    /// let stripes = Mipmap::build(&mut texels, 16, 16)?;
    /// let projection = Projection::perspective(deg!(90), (12, 12), fx!(0.5), fx!(20))?;
    /// let mvp = projection * Transform::translate(vec3!(0, -1, 0)) * Transform::scale(fx!(9));
    /// let mut display = MockDisplay::new();
    /// let mut pixels = [Gray4::BLACK; 144];
    /// let mut canvas = Canvas::new(&mut pixels, 12, 12)?;
    /// let stripes = Textured::new(stripes).mipmapped(&projection, (12, 12))?;
    /// canvas.draw(&FLOOR, &mvp, &stripes.converted());
    /// canvas.show(&mut display)?;
    /// display.assert_pattern(&[
    ///     "000000000000", "000000000000", "000000000000", "000000000000", "000000000000", "000000000000",
    ///     "000000000000", "888787878887", "FFF000FFF000", "FF0000FFFF00", "F00000FFFFF0", "000000FFFFFF",
    /// ]);
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`Error::Count`] unless width and height are from 1 to [`Viewport::MAX`].
    ///
    /// # The level
    ///
    /// At level 0, a pixel shows a texel of the texture; at level n, a pixel shows the mean of 2ⁿ x 2ⁿ texels. The
    /// level at a pixel is
    ///
    /// > log₂(density · z / focal · z / d)
    ///
    /// where z is the distance along the view direction, `focal` is the focal length in pixels, d is the distance of
    /// the eye from the triangle's plane, and `density` is the number of texels per unit of length on the triangle, as
    /// a mean of both directions of the texture. A pixel covers z / focal units of length at the distance z. On a plane
    /// that is seen at an angle, the pixel covers z / d times this length along the line of sight. The level suits this
    /// direction, in which the texture is foreshortened most, as is usual in graphics hardware; in the other direction,
    /// the picture is softer than necessary. Toward the corners of the picture, the pixel covers more than the formula
    /// says: up to the pixel's true distance divided by z times as much.
    ///
    /// `density` and d are computed once for each triangle, and z comes from [`Fragment::depth`]. The level differs
    /// from the formula by at most 1/8 if the pixel's depth is at least 32 of 65,535, and if d and the triangle's sides
    /// are at least 1/16 unit long. A level below 0 counts as 0. Edges and points show level 0, and so do triangles
    /// with all three texture coordinates on one line.
    ///
    /// The formula holds for a perspective projection. Under a parallel projection, distant surfaces do not become
    /// smaller. So choose a texture with about as many texels as the surface has pixels on the screen.
    ///
    /// # Accuracy
    ///
    /// The table lists how far a pixel's channel is, on average, from the mean of the texture over the pixel's area,
    /// for channels from 0 to 255. The pixels show the benchmark's floor, from 1 to 20 units ahead of the eye. The
    /// checkered texture has 64x64 texels in squares of 8x8 texels, and repeats 1, 8 or 32 times on the floor. The
    /// numbers are means over eight positions of the eye. `cargo test --test accuracy mipmap -- --nocapture` prints
    /// these figures.
    ///
    /// | | 1 repeat | 8 repeats | 32 repeats |
    /// |---|---:|---:|---:|
    /// | level 0 | 1.75 | 11.51 | 25.69 |
    /// | level 0, bilinear | 4.67 | 9.93 | 18.82 |
    /// | mipmapped | 1.75 | 8.62 | 15.13 |
    /// | mipmapped, bilinear | 4.73 | 6.26 | 7.05 |
    /// | mipmapped, trilinear | 4.67 | 6.06 | 6.42 |
    ///
    /// With 1 repeat, a bilinear filter has a greater error, because it also softens the edges of near squares.
    ///
    /// # Cost
    ///
    /// The table lists x86-64 instructions per pixel of the benchmark's floor (default mode, 64x64 texels of Rgb565, no
    /// pixel at level 0 in the last row). For microcontrollers, the project's program `kernels` prints such figures, in
    /// the lines whose names contain "mipmap" or "trilinear". In addition, computing `density` takes a few hundred
    /// instructions for each triangle.
    ///
    /// | | nearest | bilinear | trilinear |
    /// |---|---:|---:|---:|
    /// | rows of texels | 20 | 83 | |
    /// | a [`Mipmap`](crate::texture::Mipmap) at level 0 | 28 | 112 | |
    /// | mipmapped | 73 | 192 | 269 |
    pub fn mipmapped(
        self,
        projection: &Projection,
        frame: impl Into<Size>,
    ) -> Result<Textured<S, CLAMPED, F, Mipmapped>, Error> {
        let Size { width, height } = frame.into();
        let [x, y] = projection
            .pixel(&Viewport::new(0, 0, width, height)?)
            .map(|size| log2(size.value.unsigned_abs()) - (size.exp << 8));
        let near = log2(projection.near().to_bits().unsigned_abs().into());
        let scale = 2 * near + ((x + y) >> 1);
        Ok(Textured::of(self.texture, Mipmapped { scale }))
    }
}

impl<S: Sampler<Color: Blend>, const CLAMPED: bool> Textured<S, CLAMPED, Nearest, Mipmapped> {
    /// Blends the four texels around each pixel in each of the two levels nearest to the pixel's level, then blends the
    /// two results, so that no edge is visible between pixels of different levels.
    ///
    /// Each blend is rounded as described for [`bilinear`](Self::bilinear). The position between two levels is rounded
    /// down to 1/32 of a level for colors of 16 bits, or to 1/256 for other colors.
    #[must_use]
    pub const fn trilinear(self) -> Textured<S, CLAMPED, Trilinear, Mipmapped> {
        Textured::of(self.texture, self.detail)
    }
}

impl<S: Sampler<Color: Texel>, const CLAMPED: bool, F: Filter<S::Color>> Shader
    for Textured<S, CLAMPED, F, Mipmapped>
{
    type Color = <S::Color as Texel>::Source;
    type Varyings = (Texels, PerFace<i32>);

    const READS_DEPTH: bool = true;

    #[inline]
    fn varyings(&self, primitive: &Primitive<'_>) -> [Self::Varyings; 3] {
        let texels = self.corners(primitive);
        let density = if primitive.face().is_some() {
            let eyes = primitive.eye_positions().map(Vec3::to_bits);
            self.detail.scale + density(eyes, texels.map(|Texels(at)| at))
        } else {
            FINEST
        };
        texels.map(|at| (at, PerFace(density)))
    }

    #[inline]
    fn shade(
        &self,
        at: &Fragment,
        (texels, PerFace(density)): Self::Varyings,
    ) -> Option<Self::Color> {
        self.color(texels, density - depth_log2(at.depth))
    }
}

/// log₂(density / d), with 8 fraction bits, of a triangle with these corners in eye space and in texels.
///
/// Let n be the cross product of two sides in eye space, and t the cross product of the same sides in texels. The
/// density is √(t / |n|). For a corner a, d is |n · a| / |n|. So the result is log₂(√(t · |n|) / |n · a|).
#[inline(never)]
fn density([a, b, c]: [[i32; 3]; 3], [d, e, f]: [[i32; 2]; 3]) -> i32 {
    let side = |from: i32, to: i32| i64::from(to) - i64::from(from);
    let (b, b_down) = limited([side(a[0], b[0]), side(a[1], b[1]), side(a[2], b[2])]);
    let (c, c_down) = limited([side(a[0], c[0]), side(a[1], c[1]), side(a[2], c[2])]);
    let cross = |i: usize, j: usize| b[i] * c[j] - b[j] * c[i];
    // The cross product is below 2^61; `limited` cuts the product to below 2^30.
    let (n, n_down) = limited([cross(1, 2), cross(2, 0), cross(0, 1)]);
    let squared = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
    let along = n[0] * i64::from(a[0]) + n[1] * i64::from(a[1]) + n[2] * i64::from(a[2]);

    let (e, e_down) = limited([side(d[0], e[0]), side(d[1], e[1])]);
    let (f, f_down) = limited([side(d[0], f[0]), side(d[1], f[1])]);
    let texels = e[0] * f[1] - e[1] * f[0];

    let log2 = |number: i64, down: u32| log2(number.unsigned_abs()) + (down << 8).cast_signed();
    let down = b_down + c_down + n_down;
    // Areas are in units of 2^-32, and n · a is in units of 2^-48.
    let length = (log2(squared, 0) >> 1) + (down << 8).cast_signed();
    ((log2(texels, e_down + f_down) + length) >> 1) - log2(along, down) + (16 << 8)
}

/// Cuts numbers of at most 62 bits to 30 bits by one right shift; returns the numbers and the shift.
#[inline]
fn limited<const N: usize>(numbers: [i64; N]) -> ([i64; N], u32) {
    let bits = numbers.iter().fold(0, |all, x| all | x.unsigned_abs());
    let down = 34_u32.saturating_sub(bits.leading_zeros());
    (numbers.map(|x| x >> down), down)
}

/// log₂((depth + ½)²) of a pixel, with 8 fraction bits. For depths of 16 and more, the error is at most 0.05.
#[inline]
fn depth_log2(depth: u16) -> i32 {
    /// Half of 0.086, the greatest error of the straight line below.
    const MIDDLE: i32 = 11;
    let depth = u32::from(depth);
    let squared = (depth * (depth + 1)) | 1;
    let zeros = squared.leading_zeros();
    // log₂(1 + m) is about m.
    let mantissa = (squared << zeros) >> 23;
    mantissa.cast_signed() + MIDDLE + ((30 - zeros.cast_signed()) << 8)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn extremes_do_not_overflow() {
        let ends = [i32::MIN, -1, 0, 1, i32::MAX];
        let corners = ends.map(|x| [x, x ^ 0x5555, !x]);
        for (i, a) in corners.into_iter().enumerate() {
            for b in corners {
                for c in corners {
                    let texels = [[a[0], b[0]], [c[0], a[1]], [b[1], ends[i]]];
                    let density = density([a, b, c], texels);
                    // The density is at most half of 64 + 95, plus 16, and at least -111.
                    assert!((-111 << 8..=96 << 8).contains(&density), "{density}");
                }
            }
        }
    }

    #[test]
    fn the_logarithm_of_a_depth_is_close() {
        for depth in 0..=u16::MAX {
            let exact = 2. * (f64::from(depth) + 0.5).log2();
            let error = f64::from(depth_log2(depth)) / 256. - exact;
            // The error is at most half of 0.086, plus a unit for the cut, plus a unit for the rounding of `MIDDLE`.
            assert!(depth < 16 || error.abs() <= 0.05, "{depth}: {error}");
        }
        assert!(depth_log2(0) <= depth_log2(1));
    }
    /// A rectangle that faces the eye, in frames with a pixel for each texel of level 0, 1 and 2. Each frame is a copy of
    /// its level. The level has an error of at most 1/8, far from the half at which the nearest level changes.
    #[test]
    fn a_frame_with_a_pixel_for_each_texel_of_a_level_copies_the_level() {
        use crate::texture::Mipmap;
        use crate::{Canvas, Mesh, Scalar, fx, vec2};
        use embedded_graphics::pixelcolor::{Gray8, GrayColor};
        let texels: [_; 84] = core::array::from_fn(|at| Gray8::new(at as u8 + 1));
        let uvs = [vec2!(0, 1), vec2!(1, 1), vec2!(1, 0), vec2!(0, 0)];
        for (size, x, y) in [([16, 4], fx!(4), fx!(1)), ([4, 16], fx!(1), fx!(4))] {
            let (z, faces) = (fx!(-4), [[0, 1, 2], [0, 2, 3]]);
            let corners = [(-x, -y), (x, -y), (x, y), (-x, y)].map(|(x, y)| Vec3::new(x, y, z));
            let mesh = Mesh::new(&corners, &faces).unwrap();
            let mesh = mesh.with_uvs(&uvs, None).unwrap();
            let mipmap = Mipmap::new(&texels, size[0], size[1]).unwrap();
            let mut rest = &texels[..];
            for level in 0..3 {
                let frame = (size[0] >> level, size[1] >> level);
                let (shown, others) = rest.split_at((frame.0 * frame.1) as usize);
                rest = others;
                // A focal length of half the longer side shows 8 units at a distance of 4.
                let focal = Scalar::from_bits(8 << 16 >> level);
                let projection =
                    Projection::from_focal_length(focal, frame, fx!(1), fx!(9)).unwrap();
                let shader = Textured::new(mipmap).mipmapped(&projection, frame).unwrap();
                let mut pixels = std::vec![Gray8::BLACK; shown.len()];
                let mut canvas = Canvas::new(&mut pixels, frame.0, frame.1).unwrap();
                canvas.draw(&mesh, &projection, &shader);
                assert_eq!(pixels, shown, "{size:?}, level {level}");
            }
        }
    }
}
