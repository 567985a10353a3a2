//! Sprites: rectangles that face the viewer.

use embedded_graphics::pixelcolor::Rgb888;

use crate::error::{Error, check_above, check_count, check_length, ok};
use crate::math::{Vec2, Vec3};
use crate::num::{Angle, Scalar, TexCoord};

/// Sprites, also called billboards: a rectangle at each position of a list, parallel to the image plane.
/// [`Canvas::draw`](crate::Canvas::draw) draws all sprites of the list, for example particles, in one call.
///
/// All sprites have the same size, in units of the world or in pixels. On each sprite, texture coordinates run from (0,
/// 0) at the top left to (1, 1) at the bottom right. With an [axis](Self::with_axis), sprites turn toward the viewer
/// only about that axis, as trees should. Each sprite may have a [scale](Self::with_scales), a
/// [color](Self::with_colors), a [frame](Self::with_frames) and an [angle](Self::with_angles) of its own.
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor};
/// use fixel::prelude::*;
/// let projection = Projection::perspective(deg!(90), (2, 1), fx!(1), fx!(10))?;
/// let mut pixels = [BinaryColor::Off; 16 * 8];
/// let mut canvas = Canvas::new(&mut pixels, 16, 8)?;
/// canvas.clear(BinaryColor::Off);
///
/// // A unit at a distance of 2 is two pixels wide, and a unit at a distance of 4 is one pixel wide.
/// let positions = [vec3!(-2, 0, -2), vec3!(0, 0, -4), vec3!(4, 0, -4)];
/// let sprites = Sprites::new(&positions, (fx!(2), fx!(3)))?;
/// let white = Flat::new(BinaryColor::On);
/// let drawn = canvas.draw(&sprites, &projection, &white);
/// assert_eq!((drawn.submitted, drawn.drawn), (6, 6)); // triangles
///
/// let mut display = MockDisplay::new();
/// canvas.show(&mut display)?;
/// display.assert_pattern(&[
///     "................",
///     "..####..........",
///     "..####.##..##...",
///     "..####.##..##...",
///     "..####.##..##...",
///     "..####..........",
///     "..####..........",
///     "................",
/// ]);
/// # Ok::<(), Error>(())
/// ```
///
/// Sprites are drawn in the order of their positions. Sort [blended](crate::canvas::Blending) sprites from back to
/// front:
///
/// ```
/// use fixel::prelude::*;
/// let view = Camera::look_at(vec3!(0, 2, 6), Vec3::ZERO, Vec3::Y)?.view();
/// let mut smoke = [vec3!(0, 0, 2), vec3!(0, 1, -3), vec3!(0, 2, 0)];
/// smoke.sort_unstable_by_key(|&place| view.point(place).z); // the eye looks along −z
/// assert_eq!(smoke, [vec3!(0, 1, -3), vec3!(0, 2, 0), vec3!(0, 0, 2)]);
/// # Ok::<(), Error>(())
/// ```
///
/// # How they are drawn
///
/// A sprite is two triangles, drawn by the same rules as the triangles of a mesh. Nothing is culled, because sprites
/// have no backs. A sprite with neither an [axis](Self::with_axis) nor an [angle](Self::with_angles) is an upright
/// rectangle on the screen. It is drawn as a single rectangle, which costs less than two triangles. Its pixels and
/// depths are the same as those of two triangles, and its varyings (the numbers that the shader interpolates) are as
/// accurate. Such a sprite is nevertheless drawn as two triangles if the rectangle is clipped, if the shader has
/// [values per face](crate::shade::PerFace) (as with mipmaps), or if a varying changes both across and down, as the
/// light of a lamp does.
///
/// Every shader works with sprites, and sees them as a mesh in eye space, with normals that point toward the viewer.
/// The two triangles of sprite i have the indices 2i and 2i + 1. The offsets of the four corners from the sprite's
/// position are accurate to 2⁻²⁶ of the longest offset, and less accurate if the axis is near the line of sight. The
/// position and each corner are rounded to the nearest [`Scalar`]s in eye space. Let w be a corner's distance from the
/// eye, and s its slope x/w or y/w in eye space: the rounding moves the corner on the screen by at most 2⁻¹⁶ · (1 + s)
/// · focal length / w pixels along each axis. A sprite with a corner beyond ±32,768 in eye space is not drawn.
///
/// Sprites with holes ([`cut_out`](crate::Textured::cut_out)) may be drawn in any order if the canvas has a depth
/// buffer, because a hole does not change the stored depth.
///
/// ```
/// use embedded_graphics::pixelcolor::Gray8;
/// use fixel::{prelude::*, texture::Raw};
/// let tree = Raw::<Gray8>::new(&[
///     0, 9, 9, 0,
///     9, 9, 9, 9,
///     0, 9, 9, 0,
///     0, 9, 9, 0,
/// ], 4, 4)?;
/// let projection = Projection::perspective(deg!(90), (2, 1), fx!(0.5), fx!(20))?;
/// let camera = Camera::look_at(vec3!(0, 1.5, 0), vec3!(0, 1.5, -1), Vec3::Y)?;
/// let mut pixels = [Gray8::new(0); 24 * 12];
/// let mut canvas = Canvas::new(&mut pixels, 24, 12)?;
///
/// // Trees that stand on the floor, one twice as far away as the other.
/// let places = [vec3!(-1.5, 0, -1.5), vec3!(2, 0, -3)];
/// let trees = Sprites::new(&places, (fx!(2), fx!(2)))?
///     .with_axis(Vec3::Y)?
///     .with_anchor(vec2!(0.5, 1));
/// let leaves = Textured::new(tree).clamped().cut_out(Gray8::new(0));
/// canvas.draw(&trees, &(projection * camera), &leaves);
/// let shown: Vec<String> = canvas.pixels().collect::<Vec<_>>().chunks(24)
///     .map(|row| row.iter().map(|p| if *p == Gray8::new(0) { '.' } else { '#' }).collect()).collect();
/// assert_eq!(shown, [
///     "........................",
///     "........................",
///     "........................",
///     "........................",
///     "....####................",
///     "....####.......##.......",
///     "..########....####......",
///     "..########.....##.......",
///     "....####.......##.......",
///     "....####................",
///     "....####................",
///     "....####................",
/// ]);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Sprites<'a, A = ()> {
    pub(crate) positions: &'a [Vec3],
    /// Width and height.
    pub(crate) size: [Scalar; 2],
    pub(crate) is_in_pixels: bool,
    pub(crate) axis: Option<Vec3>,
    pub(crate) anchor: Vec2,
    /// One scale for each position, or an empty slice. `colors` and `frames` also have one element for each position,
    /// or are empty.
    pub(crate) scales: &'a [Scalar],
    pub(crate) colors: &'a [Rgb888],
    pub(crate) frames: &'a [u16],
    /// Columns and rows of frames in the texture.
    pub(crate) grid: [u16; 2],
    pub(crate) inset: Vec2,
    /// Nothing, or one angle for each position.
    pub(crate) angles: A,
}

impl<'a> Sprites<'a> {
    /// The greatest number of columns of [frames](Self::with_frames) in a texture, and the greatest number of rows.
    pub const MAX_FRAMES: u32 = 1024;

    /// Sprites with the same width and height in world units. Positions are in model space. A scale in the model's
    /// transform moves the sprites, but does not change their size.
    ///
    /// # Errors
    ///
    /// [`Error::OutOfRange`] unless width and height are above 0.
    pub const fn new(positions: &'a [Vec3], size: (Scalar, Scalar)) -> Result<Self, Error> {
        let (width, height) = size;
        ok!(check_above("width of a sprite", width, Scalar::ZERO));
        ok!(check_above("height of a sprite", height, Scalar::ZERO));
        Ok(Self {
            positions,
            size: [width, height],
            is_in_pixels: false,
            axis: None,
            anchor: Vec2::new(TexCoord::from_bits(1 << 19), TexCoord::from_bits(1 << 19)),
            scales: &[],
            colors: &[],
            frames: &[],
            grid: [1; 2],
            inset: Vec2::ZERO,
            angles: (),
        })
    }

    /// Sprites with the same width and height in pixels, at any distance, such as marks on a map. Each sprite has the
    /// depth of its position.
    ///
    /// ```
    /// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor};
    /// use fixel::prelude::*;
    /// let projection = Projection::perspective(deg!(90), (2, 1), fx!(1), fx!(50))?;
    /// let mut pixels = [BinaryColor::Off; 16 * 8];
    /// let mut canvas = Canvas::new(&mut pixels, 16, 8)?;
    /// canvas.clear(BinaryColor::Off);
    /// let positions = [vec3!(-2, 0, -2), vec3!(20, 0, -40)];
    /// let marks = Sprites::in_pixels(&positions, (fx!(4), fx!(2)))?;
    /// canvas.draw(&marks, &projection, &Flat::new(BinaryColor::On));
    ///
    /// let mut display = MockDisplay::new();
    /// canvas.show(&mut display)?;
    /// display.assert_pattern(&[
    ///     "................",
    ///     "................",
    ///     "................",
    ///     "..####..####....",
    ///     "..####..####....",
    ///     "................",
    ///     "................",
    ///     "................",
    /// ]);
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// The same as for [`new`](Self::new).
    pub const fn in_pixels(positions: &'a [Vec3], size: (Scalar, Scalar)) -> Result<Self, Error> {
        Ok(Self {
            is_in_pixels: true,
            ..ok!(Self::new(positions, size))
        })
    }

    /// Turns each sprite by an angle of its own, counter-clockwise about its [anchor](Self::with_anchor), in the plane
    /// of its rectangle: a leaf in the wind, the needle of a compass. Sprites with angles have the type
    /// `Sprites<&[Angle]>`. So a program without angles contains no code for them.
    ///
    /// ```
    /// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor};
    /// use fixel::prelude::*;
    /// let projection = Projection::perspective(deg!(90), (3, 1), fx!(1), fx!(50))?;
    /// let mut pixels = [BinaryColor::Off; 24 * 8];
    /// let mut canvas = Canvas::new(&mut pixels, 24, 8)?;
    /// canvas.clear(BinaryColor::Off);
    /// // Three needles that begin at their positions, and point up at the angle 0.
    /// let places = [vec3!(-4, -1, -2), vec3!(0, 0, -2), vec3!(4, 0, -2)];
    /// let angles = [deg!(0), deg!(45), deg!(90)];
    /// let needles = Sprites::in_pixels(&places, (fx!(2), fx!(6)))?
    ///     .with_anchor(vec2!(0.5, 1))
    ///     .with_angles(&angles)?;
    /// canvas.draw(&needles, &projection, &Flat::new(BinaryColor::On));
    ///
    /// let mut display = MockDisplay::new();
    /// canvas.show(&mut display)?;
    /// display.assert_pattern(&[
    ///     "...##..###..............",
    ///     "...##...###.............",
    ///     "...##....###............",
    ///     "...##.....##..######....",
    ///     "...##.........######....",
    ///     "...##...................",
    ///     "........................",
    ///     "........................",
    /// ]);
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`Error::Count`] unless there is one angle for each position.
    pub const fn with_angles(self, angles: &'a [Angle]) -> Result<Sprites<'a, &'a [Angle]>, Error> {
        ok!(check_length("angles", angles.len(), self.positions.len()));
        Ok(self.turned(angles))
    }
}

impl<'a> Sprites<'a, &'a [Angle]> {
    /// The angle of each sprite.
    #[must_use]
    pub const fn angles(&self) -> &'a [Angle] {
        self.angles
    }

    /// The same sprites without angles.
    pub(crate) const fn upright(&self) -> Sprites<'a> {
        self.turned(())
    }
}

impl<'a, A: Copy> Sprites<'a, A> {
    /// The same sprites with these angles, or with none.
    const fn turned<B: Copy>(&self, angles: B) -> Sprites<'a, B> {
        Sprites {
            positions: self.positions,
            size: self.size,
            is_in_pixels: self.is_in_pixels,
            axis: self.axis,
            anchor: self.anchor,
            scales: self.scales,
            colors: self.colors,
            frames: self.frames,
            grid: self.grid,
            inset: self.inset,
            angles,
        }
    }

    /// Lets the sprites turn only about an axis: their vertical sides are parallel to the axis, and their horizontal
    /// sides are parallel to the image plane. The axis is a direction in model space, of any length. For a tree, the
    /// axis points up.
    ///
    /// A sprite seen along its axis is so narrow that it has no pixels.
    ///
    /// # Errors
    ///
    /// [`Error::NoDirection`] if the axis is zero.
    pub const fn with_axis(self, axis: Vec3) -> Result<Self, Error> {
        if let [0, 0, 0] = axis.to_bits() {
            return Err(Error::ZERO_DIRECTION);
        }
        Ok(Self {
            axis: Some(axis),
            ..self
        })
    }

    /// Sets the anchor: the point of the rectangle, as a texture coordinate, that lies at the sprite's position. The
    /// default is (0.5, 0.5), which is the middle. Use (0.5, 1) for something that stands on the ground. If a
    /// coordinate is below 0 or above 1, the point lies outside the sprite.
    #[must_use]
    pub const fn with_anchor(self, anchor: Vec2) -> Self {
        Self { anchor, ..self }
    }

    /// Multiplies the size of each sprite by a scale of its own. A scale of 0 hides the sprite, and a negative scale
    /// turns it by 180°. A sprite with a corner beyond ±32,768 in eye space is not drawn.
    ///
    /// # Errors
    ///
    /// [`Error::Count`] unless there is one scale for each position.
    pub const fn with_scales(self, scales: &'a [Scalar]) -> Result<Self, Error> {
        ok!(check_length("scales", scales.len(), self.positions.len()));
        Ok(Self { scales, ..self })
    }

    /// Gives each sprite a color, for shaders that read [vertex colors](crate::Corner::color):
    /// [`Gouraud`](crate::Gouraud) and `tinted` shaders.
    ///
    /// # Errors
    ///
    /// [`Error::Count`] unless there is one color for each position.
    pub const fn with_colors(self, colors: &'a [Rgb888]) -> Result<Self, Error> {
        ok!(check_length("colors", colors.len(), self.positions.len()));
        Ok(Self { colors, ..self })
    }

    /// Divides the texture into a grid of columns and rows, and shows one cell of this grid, a frame, on each sprite.
    /// Frames are counted from 0 at the top left, row by row. Frame numbers wrap: after the last frame comes the first.
    ///
    /// # Errors
    ///
    /// [`Error::Count`] unless there are from 1 to [`MAX_FRAMES`](Sprites::MAX_FRAMES) columns and rows;
    /// [`Error::Count`] unless there is one frame for each position.
    pub const fn with_frames(self, grid: (u16, u16), frames: &'a [u16]) -> Result<Self, Error> {
        let (columns, rows) = grid;
        ok!(check_count(
            "columns",
            columns as usize,
            [1, Sprites::MAX_FRAMES as usize]
        ));
        ok!(check_count(
            "rows",
            rows as usize,
            [1, Sprites::MAX_FRAMES as usize]
        ));
        ok!(check_length("frames", frames.len(), self.positions.len()));
        Ok(Self {
            frames,
            grid: [columns, rows],
            ..self
        })
    }

    /// Leaves out the border of each frame or, if there are no frames, of the whole texture. `inset` is the size of the
    /// border: a fraction of the texture's width on the left and on the right, and a fraction of its height at the top
    /// and at the bottom.
    ///
    /// At the border, a [bilinear](crate::Textured::bilinear) filter also blends texels of neighboring frames. An inset
    /// of half a texel prevents this: 1/128 for a texture of 64 texels. With mipmaps, the inset must be half a texel of
    /// the smallest level that is drawn: 1/16 if this level has 8 texels.
    ///
    /// ```
    /// use embedded_graphics::pixelcolor::{Gray8, GrayColor};
    /// use fixel::prelude::*;
    /// use fixel::Window;
    /// // Two frames of two texels each: a dark frame and a bright frame.
    /// static SHEET: [[Gray8; 4]; 1] = [[Gray8::new(9), Gray8::new(9), Gray8::new(200), Gray8::new(200)]];
    /// let projection = Projection::orthographic(Window::centered(fx!(8), fx!(8)), fx!(-1), fx!(1))?;
    /// let dark = Sprites::new(&[Vec3::ZERO], (fx!(8), fx!(8)))?.with_frames((2, 1), &[0])?;
    /// let most = |sprites: &Sprites| {
    ///     let mut pixels = [Gray8::BLACK; 64];
    ///     Canvas::new(&mut pixels, 8, 8)?.draw(sprites, &projection, &Textured::new(&SHEET).bilinear());
    ///     Ok::<_, Error>(pixels.iter().map(|pixel| pixel.luma()).max())
    /// };
    /// assert!(most(&dark)? > Some(50));
    /// assert_eq!(most(&dark.with_inset(vec2!(0.125, 0)))?, Some(9)); // half of a quarter
    /// # Ok::<(), Error>(())
    /// ```
    #[must_use]
    pub const fn with_inset(self, inset: Vec2) -> Self {
        Self { inset, ..self }
    }

    /// The positions, in model space.
    #[must_use]
    pub const fn positions(&self) -> &'a [Vec3] {
        self.positions
    }

    /// Width and height at scale 1.
    #[must_use]
    pub const fn size(&self) -> (Scalar, Scalar) {
        let [width, height] = self.size;
        (width, height)
    }

    /// Whether the size is in pixels.
    #[must_use]
    pub const fn is_in_pixels(&self) -> bool {
        self.is_in_pixels
    }

    /// The axis about which the sprites turn, if there is one.
    #[must_use]
    pub const fn axis(&self) -> Option<Vec3> {
        self.axis
    }

    /// The point of a sprite's rectangle, as a texture coordinate, that lies at the sprite's position.
    #[must_use]
    pub const fn anchor(&self) -> Vec2 {
        self.anchor
    }

    /// The scale of each sprite; empty if all sprites have scale 1.
    #[must_use]
    pub const fn scales(&self) -> &'a [Scalar] {
        self.scales
    }

    /// The color of each sprite; empty if sprites have no colors.
    #[must_use]
    pub const fn colors(&self) -> &'a [Rgb888] {
        self.colors
    }

    /// The frame of each sprite; empty if all sprites show the first frame.
    #[must_use]
    pub const fn frames(&self) -> &'a [u16] {
        self.frames
    }

    /// Columns and rows of frames in the texture.
    #[must_use]
    pub const fn grid(&self) -> (u16, u16) {
        let [columns, rows] = self.grid;
        (columns, rows)
    }

    /// The border that is left out of each frame.
    #[must_use]
    pub const fn inset(&self) -> Vec2 {
        self.inset
    }

    /// The texture coordinates of a sprite's left, right, top and bottom side.
    pub(crate) fn frame(&self, sprite: usize) -> [TexCoord; 4] {
        let [columns, rows] = self.grid.map(u32::from);
        let frame = self.frames.get(sprite).copied().unwrap_or_default();
        // The constructors refuse a grid with 0 parts. With at most 1024 parts, `cell` << 20 is at most 2^30.
        let part = |cell: u32, parts: u32| {
            let bits = (cell << 20).checked_div(parts).unwrap_or_default();
            TexCoord::from_bits(bits.cast_signed())
        };
        let (row, column) = (
            u32::from(frame).checked_div(columns).unwrap_or_default(),
            u32::from(frame).checked_rem(columns).unwrap_or_default(),
        );
        let row = row.checked_rem(rows).unwrap_or_default();
        let Vec2 { x, y } = self.inset;
        [
            part(column, columns) + x,
            part(column + 1, columns) - x,
            part(row, rows) + y,
            part(row + 1, rows) - y,
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{fx, vec2, vec3};

    #[test]
    fn options_can_be_read() {
        let (positions, scales, frames) = ([Vec3::ZERO], [fx!(2)], [3]);
        let (colors, grid) = ([Rgb888::new(1, 2, 3)], (4, 2));
        let size = (fx!(1), fx!(3));
        let plain = Sprites::new(&positions, size).unwrap();
        assert!(!plain.is_in_pixels() && plain.scales().is_empty() && plain.colors().is_empty());
        assert_eq!((plain.axis(), plain.anchor()), (None, vec2!(0.5, 0.5)));
        assert_eq!((plain.grid(), plain.frames()), ((1, 1), &[][..]));
        let all = Sprites::in_pixels(&positions, size)
            .and_then(|all| all.with_axis(Vec3::Y)?.with_scales(&scales))
            .and_then(|all| all.with_colors(&colors)?.with_frames(grid, &frames))
            .unwrap()
            .with_anchor(vec2!(0.5, 1));
        assert!(all.is_in_pixels() && all.size() == size && all.grid() == grid);
        assert_eq!((all.axis(), all.anchor()), (Some(Vec3::Y), vec2!(0.5, 1)));
        assert_eq!((all.scales(), all.colors()), (&scales[..], &colors[..]));
        assert_eq!(all.frames(), frames);
        // Options may follow angles, and come before them.
        let turned = all.with_angles(&[Angle::QUARTER]).unwrap();
        assert_eq!(turned.angles(), [Angle::QUARTER]);
        assert_eq!((turned.axis(), turned.scales()), (all.axis(), all.scales()));
        let other = plain.with_angles(&[Angle::QUARTER]).unwrap();
        assert_eq!(other.with_scales(&scales).unwrap().scales(), scales);
        assert!(plain.with_angles(&[]).is_err());
    }

    #[test]
    fn frames_are_counted_row_by_row() {
        let positions = [Vec3::ZERO; 4];
        let sprites = Sprites::new(&positions, (fx!(1), fx!(1))).unwrap();
        let numbers = [0, 3, 6, 11];
        let sprites = sprites.with_frames((4, 2), &numbers).unwrap();
        let cells = [0, 1, 2, 3].map(|sprite| sprites.frame(sprite).map(f64::from));
        assert_eq!(
            cells,
            [
                [0., 0.25, 0., 0.5],
                [0.75, 1., 0., 0.5],
                [0.5, 0.75, 0.5, 1.],
                // There are eight frames, so the eleventh frame is the third.
                [0.75, 1., 0., 0.5],
            ]
        );
        let most = u16::try_from(Sprites::MAX_FRAMES).unwrap();
        let last = [u16::MAX; 4];
        let sprites = sprites.with_frames((most, most), &last).unwrap();
        assert_eq!(sprites.frame(0)[1], TexCoord::ONE);
    }

    #[test]
    fn sprites_of_bad_sizes_axes_or_lists_are_refused() {
        let size = (fx!(1), fx!(2));
        for (width, height) in [(fx!(0), fx!(1)), (fx!(1), fx!(-1))] {
            assert!(matches!(
                Sprites::in_pixels(&[], (width, height)),
                Err(Error::OutOfRange { .. })
            ));
        }
        let sprites = Sprites::new(&[Vec3::ZERO], size).unwrap();
        assert_eq!(sprites.with_axis(Vec3::ZERO), Err(Error::ZERO_DIRECTION));
        assert!(sprites.with_axis(vec3!(0, 0, 0.0001)).is_ok());
        let length = |of| Error::Count {
            of,
            given: 2,
            min: 1,
            max: 1,
        };
        assert_eq!(sprites.with_scales(&[fx!(1); 2]), Err(length("scales")));
        assert_eq!(sprites.with_frames((1, 1), &[0; 2]), Err(length("frames")));
        for grid in [(0, 1), (1, 0), (1025, 1), (1, 1025)] {
            assert!(matches!(
                sprites.with_frames(grid, &[0]),
                Err(Error::Count { .. })
            ));
        }
    }
}
