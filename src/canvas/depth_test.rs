//! How a draw call uses the depth buffer.

use super::depth::DepthBuffer;
use crate::num::Scalar;
use crate::num::wide::at_least;
use crate::sealed::Sealed;

/// How a draw call uses the canvas's depth buffer.
/// [`DrawOptions::with_depth_test`](crate::DrawOptions::with_depth_test) chooses one of these types, or [`Biased`] around
/// one of them:
///
/// | depth test | draws a pixel if | stores its depth | for |
/// |---|---|---|---|
/// | [`TestAndWrite`] | it is at least as near as the stored depth | yes | opaque surfaces: the default |
/// | [`TestOnly`] | it is at least as near | no | glass |
/// | [`TestNearer`] | it is clearly nearer | yes | shadows that darken each pixel once |
/// | [`TestBehind`] | it is farther | no | hidden parts, drawn in another color or dimmed |
/// | [`WriteOnly`] | always | yes | the first surface of a frame |
/// | [`NoTest`] | always | no | a sky, an overlay |
///
/// ```
/// use fixel::{prelude::*, canvas::TestOnly};
/// let glass = DrawOptions::new().with_depth_test(TestOnly);
/// ```
#[cfg_attr(doc, doc = include_str!("../guide/tables.html"))]
pub trait DepthTest: Copy + Sealed {
    /// Whether a pixel is drawn only if its depth [passes](Self::passes).
    #[doc(hidden)]
    const TESTS: bool;

    /// Whether the depths of drawn pixels are stored.
    #[doc(hidden)]
    const WRITES: bool;

    /// Whether a pixel with this depth is drawn over a stored depth.
    #[doc(hidden)]
    fn passes(depth: u32, stored: u16) -> bool;

    /// Whether depths are moved before they are tested and stored.
    #[doc(hidden)]
    const IS_BIASED: bool = false;

    /// How the depths of a primitive are moved; `()` if they are not.
    #[doc(hidden)]
    type Bias: Copy + Default;

    /// The bias of a primitive in which 1/w changes by at most `steepness` per pixel.
    #[doc(hidden)]
    #[inline]
    fn bias(&self, steepness: u32) -> Self::Bias {
        let _ = steepness;
        Self::Bias::default()
    }

    /// The same bias for a span with interpolants that are shifted left by `up`.
    #[doc(hidden)]
    #[inline]
    fn shifted(bias: Self::Bias, up: u32) -> Self::Bias {
        let _ = up;
        bias
    }

    /// The depth to test and store, from an interpolant `q` · 2^-`down`.
    #[doc(hidden)]
    #[inline]
    fn depth<D: DepthBuffer>(bias: Self::Bias, q: u32, down: u32) -> u32 {
        let _ = bias;
        D::encode(q, down)
    }
}

/// How much nearer a pixel must be for [`TestNearer`], in units of the stored depth.
const MARGIN: u32 = 3;

#[inline]
fn nearer(depth: u32, stored: u16) -> bool {
    depth > u32::from(stored) + MARGIN
}

#[inline]
fn farther(depth: u32, stored: u16) -> bool {
    !at_least(depth, stored)
}

#[inline]
fn always(_: u32, _: u16) -> bool {
    true
}

/// Declares depth tests: the condition under which a pixel is drawn, whether depths are tested, and whether they are
/// stored.
macro_rules! depth_tests {
    ($($(#[$doc:meta])+ $name:ident $passes:ident $tests:literal $writes:literal;)+) => {$(
        $(#[$doc])+
        #[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
        #[cfg_attr(feature = "defmt", derive(defmt::Format))]
        pub struct $name;

        impl Sealed for $name {}

        impl DepthTest for $name {
            const TESTS: bool = $tests;
            const WRITES: bool = $writes;
            type Bias = ();

            #[inline]
            fn passes(depth: u32, stored: u16) -> bool {
                $passes(depth, stored)
            }
        }
    )+};
}

depth_tests! {
        /// Draws a pixel if it is at least as near as the stored depth, and stores its depth: the default.
        ///
        /// ```
        /// use fixel::{prelude::*, canvas::TestAndWrite};
        /// assert_eq!(DrawOptions::new(), DrawOptions::new().with_depth_test(TestAndWrite));
        /// ```
        TestAndWrite at_least true true;
        /// Draws a pixel if it is at least as near as the stored depth, and keeps the stored depth: for glass and other
        /// surfaces that must not hide later surfaces.
        ///
        /// ```
        /// use fixel::{prelude::*, canvas::TestOnly};
        /// let glass = DrawOptions::new().with_depth_test(TestOnly);
        /// ```
        TestOnly at_least true false;
        /// Draws a pixel if it is nearer than the stored depth by more than three units of the stored depth, and stores
        /// its depth: for shadows.
        ///
        /// If several faces lie in one plane, each pixel shows only the first of them. So a shadow of many faces, drawn
        /// with [`Multiply`](super::Multiply) or [`Opacity`](super::Opacity), darkens each pixel once.
        /// [`Biased::coplanar`] moves the shadow in front of the ground.
        ///
        /// Why three units: rounding makes depths in one plane differ by up to three units, if the depth changes by at
        /// most 256 units from pixel to pixel. (A corner is rounded by 1/512 pixel along each axis, which moves depths
        /// by one unit, and depths are rounded down.)
        ///
        /// ```
        /// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::{Gray4, GrayColor}};
        /// use fixel::{Window, prelude::*, canvas::{Biased, Multiply, TestNearer}};
        /// static RING: Mesh = shape!(torus(fx!(0.4), 16, 8));
        /// static GROUND: Mesh = shape!(plane(1, 1));
        /// let projection = Projection::orthographic(Window::centered(fx!(4), fx!(4)), fx!(0), fx!(8))?;
        /// let view = projection * Camera::top(Vec3::ZERO, fx!(4));
        /// let (mut pixels, mut depths) = ([Gray4::BLACK; 256], [0; 256]);
        /// let mut canvas = Canvas::new(&mut pixels, 16, 16)?.with_depth(&mut depths)?;
        /// canvas.clear(Gray4::BLACK);
        /// canvas.draw(&GROUND, &(view * Transform::scale(fx!(4))), &Flat::new(Gray4::WHITE));
        ///
        /// let onto_ground = view * Transform::scale_axes(vec3!(1, 0, 1));
        /// let once = DrawOptions::new().with_depth_test(Biased::coplanar(TestNearer));
        /// let shadow = once.with_blending(Multiply).with_cull(Cull::Nothing);
        /// canvas.draw_with(&shadow, &RING, &onto_ground, &Flat::new(Gray4::new(6)));
        /// let mut display = MockDisplay::new();
        /// canvas.show(&mut display)?;
        /// display.assert_pattern(&[
        ///     "FFFFFFFFFFFFFFFF", "FFFFFFFFFFFFFFFF",
        ///     "FFFFFFF66FFFFFFF", "FFFFF666666FFFFF",
        ///     "FFFF66666666FFFF", "FFF6666666666FFF",
        ///     "FFF666FFFF666FFF", "FF6666FFFF6666FF",
        ///     "FF6666FFFF6666FF", "FFF666FFFF666FFF",
        ///     "FFF6666666666FFF", "FFFF66666666FFFF",
        ///     "FFFFF666666FFFFF", "FFFFFFF66FFFFFFF",
        ///     "FFFFFFFFFFFFFFFF", "FFFFFFFFFFFFFFFF",
        /// ]);
        /// # Ok::<(), Error>(())
        /// ```
        TestNearer nearer true true;
        /// Draws a pixel if it is farther than the stored depth, and keeps the stored depth: for hidden parts, such as
        /// the silhouette of a figure behind a wall.
        ///
        /// ```
        /// use fixel::{prelude::*, canvas::{Opacity, TestBehind}};
        /// let hidden = DrawOptions::new().with_depth_test(TestBehind).with_blending(Opacity(90));
        /// ```
        TestBehind farther true false;
        /// Draws every pixel and stores its depth.
        ///
        /// ```
        /// use fixel::{prelude::*, canvas::WriteOnly};
        /// let first_in_the_frame = DrawOptions::new().with_depth_test(WriteOnly);
        /// ```
        WriteOnly always false true;
        /// Draws every pixel and keeps the stored depths: for a sky, or an overlay.
        ///
        /// ```
        /// use fixel::{prelude::*, canvas::NoTest};
        /// let sky = DrawOptions::new().with_cull(Cull::Nothing).with_depth_test(NoTest);
        /// ```
        NoTest always false false;
}

/// A depth test with depths that are moved before they are tested and stored.
///
/// On a Cortex-M4, moving the depths costs 8 to 12 instructions for each drawn pixel and 5 to 8 for each hidden pixel.
/// On a Cortex-M0+, the costs are 15 or 16 instructions for each drawn pixel and 12 to 14 for each hidden pixel.
///
/// If the depths of a mesh are moved away from the eye, lines and decals on its surface are drawn without gaps:
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor};
/// use fixel::{prelude::*, canvas::{Biased, TestAndWrite}};
/// static BOX: Mesh = shape!(cuboid(vec3!(1, 1, 1)));
/// let projection = Projection::perspective(Angle::from_degrees(60), (1, 1), fx!(0.5), fx!(8))?;
/// let turn = Transform::rotate_x(deg!(25)) * Transform::rotate_y(deg!(30));
/// let mvp = projection * Transform::translate(vec3!(0, 0, -1.9)) * turn;
/// let (mut color, mut depth) = ([BinaryColor::Off; 24 * 24], [0; 24 * 24]);
/// let mut canvas = Canvas::new(&mut color, 24, 24)?.with_depth(&mut depth)?;
/// canvas.clear(BinaryColor::Off);
/// let behind = DrawOptions::new().with_depth_test(Biased::behind(TestAndWrite));
/// assert_eq!((behind.depth_test.steps, behind.depth_test.slope), (-2, fx!(-1)));
/// canvas.draw_with(&behind, &BOX, &mvp, &Flat::new(BinaryColor::Off));
/// canvas.draw(BOX.edges(LineStyle::HAIRLINE), &mvp, &Flat::new(BinaryColor::On));
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Biased<Z = super::TestAndWrite> {
    /// The wrapped test.
    pub test: Z,
    /// How far depths move toward the eye, in units of the stored depth. A negative number moves depths away.
    pub steps: i32,
    /// A further move toward the eye, for sloping surfaces, in depth differences between neighboring pixels.
    pub slope: Scalar,
}

/// The bias of a primitive.
#[derive(Clone, Copy, Debug, Default)]
pub struct Bias {
    /// See [`Biased::steps`].
    steps: i32,
    /// The number that is added to half of 1/w because of the slope: half of [`Biased::slope`] times the greatest
    /// change of 1/w per pixel.
    added: i32,
    /// By how many bits a span's 1/w is shifted left.
    up: u32,
}

impl<Z> Biased<Z> {
    /// `test` with depths moved by `steps` units of the stored depth and by `slope` times the depth difference between
    /// neighboring pixels. (The depth difference is the greater of two: to the next pixel in the row, and to the next
    /// in the column.) Positive values move a surface nearer. Depths saturate at both ends of their range.
    ///
    /// For an edge of an [outline](crate::Mesh::outline), up to three depth differences are computed: one along the
    /// line, and one on each of the edge's two faces, unless the face is culled. The greatest of them counts. On a face
    /// that is much narrower than a pixel, the difference to the neighboring pixel, which is outside the face, would be
    /// too large. Therefore, the difference on a face is limited to the difference between its nearest and its farthest
    /// corner. If the edge is not a crease, the limit is twice as high, because on a round body, pixels of the edge may
    /// lie over the next face, which is farther away.
    #[must_use]
    pub const fn new(test: Z, steps: i32, slope: Scalar) -> Self {
        Self { test, steps, slope }
    }

    /// `test` with depths moved away by two units of the stored depth and by the depth difference between neighboring
    /// pixels. With this bias, edges drawn over the mesh have no gaps.
    ///
    /// There is one exception. If the near plane clips a very narrow triangle, the triangle's new corners are rounded
    /// to 1/256 pixel. The rounding tilts the triangle, so that the triangle may hide a pixel of its own edge.
    ///
    /// For silhouettes of round bodies, this bias is too small. Instead, draw the mesh without a bias, and its outline
    /// with [`in_front`](Self::in_front).
    #[must_use]
    pub const fn behind(test: Z) -> Self {
        Self::new(test, -2, crate::fx!(-1))
    }

    /// `test` with depths moved nearer by seven units of the stored depth, for a surface in the plane of a surface that
    /// is already drawn: a shadow on the ground, a sign on a wall. With [`TestNearer`] as `test`, each pixel of the new
    /// surface is drawn only once, even where its faces overlap.
    ///
    /// If the depth changes by at most 256 units from pixel to pixel, no pixel is missing. The new surface also covers
    /// things that are up to seven units nearer than it. A unit is w² / (65,535 · near) long at the distance w.
    #[must_use]
    pub const fn coplanar(test: Z) -> Self {
        Self::new(test, 7, Scalar::ZERO)
    }

    /// `test` with depths moved nearer by two units of the stored depth and by the depth difference between neighboring
    /// pixels, for [outlines](crate::Mesh::outline) over a mesh that is drawn without a bias.
    ///
    /// The center of a line's pixel may be half a pixel away from the line. At that center, a face may be nearer than
    /// the line, but by less than the bias. In a test with balls and cans, 0.5 % of the silhouette pixels are missing,
    /// all of them on balls that are only a few pixels wide. On the other hand, a line is visible through a surface
    /// that is in front of it by less than the bias.
    #[must_use]
    pub const fn in_front(test: Z) -> Self {
        Self::new(test, 2, crate::fx!(1))
    }
}

impl<Z> Sealed for Biased<Z> {}

impl<Z: DepthTest<Bias = ()>> DepthTest for Biased<Z> {
    const TESTS: bool = Z::TESTS;
    const WRITES: bool = Z::WRITES;
    const IS_BIASED: bool = true;
    type Bias = Bias;

    #[inline]
    fn passes(depth: u32, stored: u16) -> bool {
        Z::passes(depth, stored)
    }

    #[inline]
    fn bias(&self, steepness: u32) -> Bias {
        // The product of 32 bits and 32 bits fits in 64 bits. The clamp changes no depth, because the sum of `added`
        // and 1/w saturates anyway.
        let added = (i64::from(self.slope.to_bits()) * i64::from(steepness)) >> 17;
        Bias {
            steps: self.steps,
            added: added.clamp(i32::MIN.into(), i32::MAX.into()) as i32,
            up: 0,
        }
    }

    #[inline]
    fn shifted(bias: Bias, up: u32) -> Bias {
        Bias { up, ..bias }
    }

    #[inline]
    fn depth<D: DepthBuffer>(bias: Bias, q: u32, down: u32) -> u32 {
        // This undoes the span's left shift, which loses no bit, and halves `q`. Without halving, the sum might exceed
        // the 31 bits of 1/w, because a bias can move a line nearer than the primitive's nearest corner.
        let up = bias.up.wrapping_add(1);
        let (q, down) = (q >> (up & 31), down.wrapping_sub(up));
        let sum = q.cast_signed().saturating_add(bias.added);
        let q = sum.max(0).cast_unsigned();
        let code = D::encode(q, down).cast_signed();
        code.saturating_add(bias.steps)
            .clamp(0, 0xffff)
            .cast_unsigned()
    }
}

#[cfg(test)]
mod tests {
    use super::super::{FloatDepth, LinearDepth, TestAndWrite, WideFloatDepth};
    use super::*;
    use crate::fx;
    use crate::random::cases;
    use rand::Rng;

    const TOP: u32 = 0xffff;

    /// The depth of a test with a bias, in a primitive of this steepness.
    fn moved<D: DepthBuffer>(
        steps: i32,
        slope: Scalar,
        steepness: u32,
        [q, down]: [u32; 2],
    ) -> u32 {
        let bias = Biased::new(TestAndWrite, steps, slope).bias(steepness);
        <Biased>::depth::<D>(bias, q, down)
    }

    /// The near plane has the greatest depth, and infinity has the least, whatever the bias.
    #[test]
    fn depths_saturate_at_both_ends() {
        fn check<D: DepthBuffer>(least: u32) {
            let (near, far) = ([(1 << 31) - 1, 15], [0, 15]);
            for steps in [0, 1, 2, 0x8000, 0xfffe, 0xffff, 0x1_0000, i32::MAX] {
                assert_eq!(moved::<D>(steps, fx!(0), 0, near), TOP);
                // Away from its end, each depth moves by as many steps as there are.
                let most = steps.cast_unsigned().min(TOP);
                assert_eq!(moved::<D>(-steps, fx!(0), 0, near), TOP - most);
                assert_eq!(moved::<D>(steps, fx!(0), 0, far), TOP.min(least + most));
                assert_eq!(
                    moved::<D>(-steps, fx!(0), 0, far),
                    least.saturating_sub(most)
                );
            }
            assert_eq!(moved::<D>(i32::MIN, fx!(0), 0, near), 0);
            for slope in [fx!(0.5), fx!(1), fx!(2), Scalar::MAX] {
                for steepness in [1 << 16, 1 << 24, 1 << 30, u32::MAX] {
                    assert_eq!(moved::<D>(0, slope, steepness, near), TOP);
                    assert_eq!(moved::<D>(2, slope, steepness, near), TOP);
                    assert_eq!(moved::<D>(0, -slope, steepness, far), least);
                }
            }
            assert_eq!(moved::<D>(0, Scalar::MAX, u32::MAX, far), TOP);
            assert_eq!(moved::<D>(0, Scalar::MIN, u32::MAX, near), least);
        }
        check::<LinearDepth>(0);
        check::<FloatDepth>(0);
        // With a shift of 14, which only a bias has, 0 is stored as 2^-15: the depth at 2^31 times the near plane's distance. No far plane is farther.
        check::<WideFloatDepth>(1 << 11);
    }

    /// Compares with exact numbers. Halving `q` loses up to one unit of `q`, and so does the rounding of `added`, so a
    /// depth may be rounded down as if it were up to two units less. Half of the sum has 31 bits.
    #[test]
    fn depths_move_by_the_slope_and_then_by_the_steps() {
        cases(1 << 14, |random| {
            let up = random.random_range(0..16_u32);
            let down = random.random_range(15..32_u32);
            let q = random.random_range(0..1_u32 << 31) >> up >> random.random_range(0..31_u32);
            let slope = Scalar::from_bits(random.random::<i32>() >> random.random_range(0..32_u32));
            let steepness = random.random::<u32>() >> random.random_range(0..32_u32);
            let steps = random.random_range(-70..=70);

            let code = moved::<LinearDepth>(steps, slope, steepness, [q, down]);
            let sum = i64::from(q)
                + (i64::from(slope.to_bits()) * i64::from(steepness)).div_euclid(1 << 16);
            let exact = |sum: i64| {
                let code = sum.clamp(0, (1 << 32) - 1) >> down;
                (code + i64::from(steps)).clamp(0, TOP.into())
            };
            let range = exact(sum - 2)..=exact(sum);
            assert!(
                range.contains(&i64::from(code)),
                "{code} is not in {range:?}"
            );

            let bias = Biased::new(TestAndWrite, steps, slope).bias(steepness);
            let bias = <Biased>::shifted(bias, up);
            let shifted = <Biased>::depth::<LinearDepth>(bias, q << up, down + up);
            assert_eq!(shifted, code, "shifted left by {up}");
        });
    }

    /// A square in the near plane, moved nearer, and moved as far away as possible.
    #[test]
    fn stored_depths_do_not_wrap() {
        use crate::{Window, prelude::*};
        use embedded_graphics::pixelcolor::Gray8;
        static SQUARE: Mesh = shape!(plane(1, 1));
        fn drawn<D: DepthBuffer>(test: Biased<WriteOnly>) -> [u16; 16] {
            let window = Window::centered(fx!(1), fx!(1));
            let projection = Projection::orthographic(window, fx!(1), fx!(2)).unwrap();
            let view = projection * Camera::top(Vec3::ZERO, fx!(1));
            let (mut pixels, mut depths) = ([Gray8::new(0); 16], [7; 16]);
            let canvas = Canvas::new(&mut pixels, 4, 4).unwrap();
            let mut canvas = canvas.with_depth_format::<D>(&mut depths).unwrap();
            let options = DrawOptions::new().with_depth_test(test);
            canvas.draw_with(&options, &SQUARE, &view, &Flat::new(Gray8::new(9)));
            depths
        }
        fn check<D: DepthBuffer>() {
            for (steps, slope) in [(2, fx!(1)), (0, fx!(4)), (i32::MAX, Scalar::MAX)] {
                let near = drawn::<D>(Biased::new(WriteOnly, steps, slope));
                assert_eq!(near, [0xffff; 16], "{steps} {slope}");
                let far = drawn::<D>(Biased::new(WriteOnly, -(steps.max(0xffff)), -slope));
                assert_eq!(far, [0; 16], "{steps} {slope}");
            }
        }
        check::<LinearDepth>();
        check::<FloatDepth>();
        check::<WideFloatDepth>();
    }
}
