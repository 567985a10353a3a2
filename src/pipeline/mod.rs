//! The draw call: a mesh through its stages onto a canvas.

mod assemble;
mod cache;
mod call;
mod clip;
mod line_style;
mod list;
mod options;
mod outline;
mod points;
mod ray;
mod run;
mod sprites;
mod vertex;

pub use line_style::LineStyle;
pub use list::{
    EdgeList, Object, Prepared, PreparedEdgeScene, PreparedEdges, PreparedScene, TriangleList,
};
pub use options::DrawOptions;
pub use ray::{Hit, Ray};

use core::ops::Range;

use embedded_graphics::geometry::Point;
use embedded_graphics::pixelcolor::PixelColor;

use call::Call;
use list::PreparedCall;
use options::PixelOptions;
use sprites::Quads;
use vertex::Projector;

use crate::mesh::{Bounds, Mesh, Missing, Outline, Positions, Sprites};
use crate::num::{Subpixel, block::BlockFloat};
use crate::raster::{Blitter, PointStyle, ScreenVertex};
use crate::shade::ShaderFor;
use crate::span::{Blit, Mode, Painter, is_plane};
use crate::target::{Blending, Canvas, DepthBuffer, DepthTest, Label, Storage};
use crate::view::{ModelToPicture, ProjectionKind};
use crate::{Error, Vec3};

/// The result of a draw call: how many triangles, edges or points there were, and how many were drawn.
///
/// ```
/// use embedded_graphics::pixelcolor::Gray8;
/// use fixel::prelude::*;
/// let mut pixels = [Gray8::new(0); 64];
/// let mut canvas = Canvas::new(&mut pixels, 8, 8)?;
/// let projection = Projection::perspective(Angle::from_degrees(90), (1, 1), fx!(0.1), fx!(10))?;
/// let mvp = projection * Transform::translate(vec3!(0, 0, -1));
/// let positions = [vec3!(-1, -1, 0), vec3!(1, -1, 0), vec3!(-1, 1, 0)];
/// let triangle = Mesh::new(&positions, &[[0, 1, 2], [0, 2, 1]])?;
/// let drawn = canvas.draw(&triangle, &mvp, &Flat::new(Gray8::new(255)));
/// assert_eq!((drawn.submitted, drawn.drawn, drawn.clipped), (2, 1, 0));
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Drawn {
    /// The number of triangles, edges or points in the mesh.
    pub submitted: u32,
    /// The number of these that may have changed a pixel. Triangles count if they are not culled and meet the viewport
    /// and the canvas's rows. Lines and points count if any part of them lies between the near and the far plane and in
    /// the guard band, ±2048 pixels around the viewport's center; prepared edges must also reach the canvas's rows.
    pub drawn: u32,
    /// The number of these that were clipped by a plane of the view volume or of the guard band.
    pub clipped: u32,
    /// The attributes that the shader asked for and the mesh lacks.
    pub missing: Missing,
}

/// The screen position of a point of model space; [`Canvas::project`] returns it.
///
/// ```
/// use embedded_graphics::pixelcolor::Gray8;
/// use fixel::prelude::*;
/// let mut pixels = [Gray8::new(0); 64];
/// let canvas = Canvas::new(&mut pixels, 8, 8)?;
/// let projection = Projection::perspective(Angle::from_degrees(90), (1, 1), fx!(0.5), fx!(10))?;
/// let at = canvas.project(&DrawOptions::new(), &projection, vec3!(0.5, 1, -2)).unwrap();
/// assert_eq!((at.x.to_num(), at.y.to_num()), (5, 2));
/// assert_eq!(at.depth, 65535 / 4);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct ScreenPoint {
    /// Columns from the frame's left edge, rounded to the nearest 1/256. A pixel's center is half a column from its
    /// edges.
    pub x: Subpixel,
    /// Rows from the frame's top edge, rounded to the nearest 1/256.
    pub y: Subpixel,
    /// The depth as the canvas's depth buffer would store it; linear if the canvas has none.
    pub depth: u16,
}

impl<C: PixelColor, O: Storage<C>, D: DepthBuffer> Canvas<'_, C, O, D> {
    /// Projects a mesh's triangles with `mvp` to the whole frame, and draws the part in this canvas. Back faces are
    /// culled, depth is tested if the canvas has a depth buffer, and attributes are interpolated in correct
    /// perspective.
    ///
    /// `mvp` is a [`Projection`](crate::Projection) times a camera and a model transform (an [`Mvp`](crate::Mvp)), or
    /// a projection alone. Drawing cannot fail: parts outside the view are clipped away.
    pub fn draw(
        &mut self,
        mesh: &Mesh<'_>,
        mvp: &impl ModelToPicture,
        shader: &impl ShaderFor<C>,
    ) -> Drawn {
        self.draw_with(&DrawOptions::new(), mesh, mvp, shader)
    }

    /// Draws a mesh's triangles like [`draw`](Self::draw), with options.
    pub fn draw_with<M: Mode, Z: DepthTest, B: Blending<C>>(
        &mut self,
        options: &DrawOptions<M, Z, B>,
        mesh: &Mesh<'_>,
        mvp: &impl ModelToPicture,
        shader: &impl ShaderFor<B::Source>,
    ) -> Drawn {
        let painter = (*shader, options.pixels.blending);
        self.paint(options, (mesh, mvp), painter, run::draw)
    }

    /// Draws the triangles that were [prepared](TriangleList::prepare) for this frame and meet this canvas's rows. The
    /// pixels are those of [`draw_with`](Self::draw_with), but nothing is transformed again.
    ///
    /// # Errors
    ///
    /// [`Error::Frame`] if the canvas's frame differs in size from the frame that they were prepared for.
    pub fn draw_prepared<M: Mode, Z: DepthTest, B: Blending<C>, K: ProjectionKind>(
        &mut self,
        prepared: &Prepared<'_, K, M, Z, B>,
        shader: &impl ShaderFor<B::Source>,
    ) -> Result<Drawn, Error> {
        let painter = (*shader, prepared.pixels.blending);
        let list = (&prepared.call, &prepared.pixels);
        self.paint_prepared(list, painter, |rows, blitter| prepared.draw(rows, blitter))
    }

    /// Draws the edges that were [prepared](EdgeList::prepare) for this frame and meet this canvas's rows. The pixels
    /// are those of [`draw_edges`](Self::draw_edges) or [`draw_outline`](Self::draw_outline), but nothing is
    /// transformed again.
    ///
    /// # Errors
    ///
    /// As for [`draw_prepared`](Self::draw_prepared).
    pub fn draw_prepared_edges<
        M: Mode,
        Z: DepthTest,
        B: Blending<C>,
        L: LineStyle<C>,
        K: ProjectionKind,
    >(
        &mut self,
        prepared: &PreparedEdges<'_, K, M, Z, B, L>,
        shader: &impl ShaderFor<B::Source>,
    ) -> Result<Drawn, Error> {
        let state = L::State::default();
        let painter = L::painter(&state, *shader, prepared.pixels.blending);
        let list = (&prepared.call, &prepared.pixels);
        self.paint_prepared(list, painter, |rows, blitter| {
            let line = prepared.line.bind(&state);
            prepared.draw(&line, prepared.line.reach(), rows, blitter)
        })
    }

    /// Draws a mesh's [edges](Mesh::edges) as lines in the [style](DrawOptions::with_line) of the options: by default,
    /// one pixel wide.
    pub fn draw_edges<M: Mode, Z: DepthTest, B: Blending<C>, L: LineStyle<C>>(
        &mut self,
        options: &DrawOptions<M, Z, B, L>,
        mesh: &Mesh<'_>,
        mvp: &impl ModelToPicture,
        shader: &impl ShaderFor<B::Source>,
    ) -> Drawn {
        let state = L::State::default();
        let painter = L::painter(&state, *shader, options.pixels.blending);
        self.paint(options, (mesh, mvp), painter, |call, blitter| {
            options.line.edges(&state, call, blitter)
        })
    }

    /// Draws a mesh's [`Outline`] as [`draw_edges`](Self::draw_edges) draws edges: those creases and silhouettes of
    /// which at least one face is not culled.
    ///
    /// Faces are found to be front or back by the same rule as for drawn triangles, so the outline of a closed mesh has
    /// no gaps.
    ///
    /// To remove hidden lines, draw the faces first, in the color of the background and slightly behind their true
    /// depth:
    ///
    /// ```
    /// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor};
    /// use fixel::{prelude::*, target::{Biased, TestAndWrite}};
    /// static CAN: Mesh = shape!(cylinder(16));
    /// static RIMS: Outline = outline!(CAN, deg!(30));
    /// let projection = Projection::perspective(deg!(40), (1, 1), fx!(1), fx!(9))?;
    /// let camera = Camera::look_at(vec3!(0, 2, 4), Vec3::ZERO, Vec3::Y)?;
    /// let mvp = projection * camera;
    /// let (mut color, mut depth) = ([BinaryColor::Off; 24 * 24], [0; 24 * 24]);
    /// let mut canvas = Canvas::new(&mut color, 24, 24)?.with_depth(&mut depth)?;
    /// canvas.clear(BinaryColor::Off);
    /// let behind = DrawOptions::new().with_depth(Biased::behind(TestAndWrite));
    /// canvas.draw_with(&behind, &CAN, &mvp, &Flat::new(BinaryColor::Off));
    /// canvas.draw_outline(&DrawOptions::new(), &CAN, &RIMS, &mvp, &Flat::new(BinaryColor::On));
    /// let mut display = MockDisplay::new();
    /// canvas.show(&mut display)?;
    /// display.assert_pattern(&[
    ///     "........................",
    ///     "........................",
    ///     "........................",
    ///     ".....##############.....",
    ///     "....#..............#....",
    ///     "...##..............##...",
    ///     "...#.###........###.#...",
    ///     "...#....########....#...",
    ///     "....#..............#....",
    ///     "....#..............#....",
    ///     "....#..............#....",
    ///     "....#..............#....",
    ///     "....#..............#....",
    ///     "....#..............#....",
    ///     "....#..............#....",
    ///     "....#..............#....",
    ///     "....#..............#....",
    ///     ".....#............#.....",
    ///     ".....#............#.....",
    ///     ".....#............#.....",
    ///     ".....#............#.....",
    ///     ".......#........#.......",
    ///     "........########........",
    ///     "........................",
    /// ]);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn draw_outline<M: Mode, Z: DepthTest, B: Blending<C>, L: LineStyle<C>>(
        &mut self,
        options: &DrawOptions<M, Z, B, L>,
        mesh: &Mesh<'_>,
        outline: &Outline<'_>,
        mvp: &impl ModelToPicture,
        shader: &impl ShaderFor<B::Source>,
    ) -> Drawn {
        let state = L::State::default();
        let painter = L::painter(&state, *shader, options.pixels.blending);
        self.paint(options, (mesh, mvp), painter, |call, blitter| {
            let line = options.line.bind(&state);
            outline::outline(call, outline, &line, blitter)
        })
    }

    /// Draws a mesh's positions as points: for each, the pixel that contains it.
    pub fn draw_points<M: Mode, Z: DepthTest, B: Blending<C>>(
        &mut self,
        options: &DrawOptions<M, Z, B>,
        mesh: &Mesh<'_>,
        mvp: &impl ModelToPicture,
        shader: &impl ShaderFor<B::Source>,
    ) -> Drawn {
        let painter = (*shader, options.pixels.blending);
        self.paint(options, (mesh, mvp), painter, run::points)
    }

    /// Draws a mesh's positions as squares or discs: see [`PointStyle`]. All pixels of a square or disc have the depth
    /// and the attributes of its position.
    ///
    /// ```
    /// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor};
    /// use fixel::prelude::*;
    /// let stars = [vec3!(-4, 0, -4), vec3!(0.5, 0, -8), vec3!(9, 0, -16)];
    /// let mesh = Mesh::new(&stars, &[])?;
    /// let projection = Projection::perspective(deg!(60), (24, 9), fx!(1), fx!(20))?;
    /// let mut color = [BinaryColor::Off; 24 * 9];
    /// let mut canvas = Canvas::new(&mut color, 24, 9)?;
    /// let style = PointStyle::round(fx!(4))?.attenuated();
    /// let white = Flat::new(BinaryColor::On);
    /// canvas.draw_sized_points(&DrawOptions::new(), &mesh, style, &projection, &white);
    /// let mut display = MockDisplay::new();
    /// canvas.show(&mut display)?;
    /// display.assert_pattern(&[
    ///     "........................",
    ///     "..#####.................",
    ///     ".#######................",
    ///     "########...###..........",
    ///     "########...###.##.......",
    ///     "########...###..........",
    ///     ".#######................",
    ///     "..#####.................",
    ///     "........................",
    /// ]);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn draw_sized_points<M: Mode, Z: DepthTest, B: Blending<C>>(
        &mut self,
        options: &DrawOptions<M, Z, B>,
        mesh: &Mesh<'_>,
        style: PointStyle,
        mvp: &impl ModelToPicture,
        shader: &impl ShaderFor<B::Source>,
    ) -> Drawn {
        let screen = options.screen(self.frame_size());
        let half = points::HalfSize::new(style, mvp.projection_of(), &screen.viewport);
        let painter = (*shader, options.pixels.blending);
        self.paint(options, (mesh, mvp), painter, |call, blitter| {
            points::sized_points(call, &half, style.is_round(), blitter)
        })
    }

    /// Draws sprites: two triangles for each position, by the same rules as a mesh's triangles. Nothing is culled,
    /// because sprites have no backs.
    ///
    /// A sprite without an [axis](Sprites::with_axis) is a rectangle on the screen. It is drawn as one primitive, which
    /// costs less than two triangles, unless it is clipped, its shader has [values per face](crate::shade::PerFace) (as
    /// mipmaps have), or a varying changes both across and down, as the light of a lamp does. It has the same pixels
    /// and depths as the triangles, and its varyings are as accurate.
    ///
    /// Every shader works: to it, sprites are a mesh in eye space whose normals point towards the viewer. The two
    /// triangles of sprite i have the indices 2i and 2i + 1. Corners are rounded to the nearest
    /// [`Scalar`](crate::Scalar)s in eye space, which moves them by at most 2⁻¹⁶ · focal length / w pixels. A sprite
    /// with a corner beyond ±32,768 in eye space is not drawn.
    ///
    /// With [`cut_out`](crate::Textured::cut_out), sprites may be drawn in any order, because holes leave depths as
    /// they are.
    ///
    /// ```
    /// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Gray8};
    /// use fixel::prelude::*;
    /// static TREE: TextureArray<Gray8, 4, 4> = TextureArray::gray8(&[
    ///     0, 9, 9, 0,
    ///     9, 9, 9, 9,
    ///     0, 9, 9, 0,
    ///     0, 9, 9, 0,
    /// ]);
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
    /// let leaves = Textured::new(&TREE).clamped().cut_out(Gray8::new(0));
    /// canvas.draw_sprites(&DrawOptions::new(), &trees, &(projection * camera), &leaves);
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
    pub fn draw_sprites<M: Mode, Z: DepthTest, B: Blending<C>, V: ModelToPicture>(
        &mut self,
        options: &DrawOptions<M, Z, B>,
        sprites: &Sprites<'_>,
        mvp: &V,
        shader: &impl ShaderFor<B::Source>,
    ) -> Drawn {
        let screen = options.screen(self.frame_size());
        let scissor = screen.scissor(self.rows());
        let quads = Quads::new(sprites, mvp, &screen.viewport);
        let painter = (*shader, options.pixels.blending);
        let modes = (options.pixels.mode, options.pixels.depth);
        let depth_shift = quads.projector.depth_shift();
        let mut blit = Blit::<_, _, _, V::Kind, _, _>::new(modes, self, painter, depth_shift);
        quads.draw(&scissor, &|halves| is_plane(&painter, halves), &mut blit)
    }

    /// The screen position of a point of model space, with the same bits as when it is drawn.
    ///
    /// The result is `None` if the point is nearer than the near plane, beyond the far plane, or more than 2048
    /// pixels left or right of, above or below the viewport's center. The position may lie outside the viewport.
    ///
    /// Use it to place a [`label`](Self::label) beside an object. For the opposite way, from a pixel into the scene,
    /// see [`ray`](Self::ray).
    #[must_use]
    pub fn project<M, Z, B, L>(
        &self,
        options: &DrawOptions<M, Z, B, L>,
        mvp: &impl ModelToPicture,
        point: Vec3,
    ) -> Option<ScreenPoint> {
        let viewport = options.screen(self.frame_size()).viewport;
        let projector = Projector::new(
            Positions::of_one(&point),
            mvp.projection_of(),
            &mvp.model_view_of(),
            &viewport,
        );
        let mut at = ScreenVertex::UNSET;
        projector.project(0, &mut at);
        if at.outcode != 0 {
            return None;
        }
        let [x, y] = at.screen.map(Subpixel::from_bits);
        Some(ScreenPoint {
            x,
            y,
            depth: D::encode(at.q, projector.depth_shift().of(at.exponent)) as u16,
        })
    }

    /// A [`DrawTarget`](embedded_graphics::draw_target::DrawTarget) for text, or for anything else that
    /// embedded-graphics draws, at a point of the scene. Its origin is the pixel that contains `at`, and nearer
    /// surfaces hide what is drawn.
    ///
    /// A label at a point of a surface may be hidden by parts of the same surface that are nearer. To avoid this, give
    /// [`ScreenPoint::depth`] a greater value, or project a point in front of the surface.
    ///
    /// ```
    /// use embedded_graphics::mock_display::MockDisplay;
    /// use embedded_graphics::mono_font::{MonoTextStyle, ascii::FONT_4X6};
    /// use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
    /// use embedded_graphics::{Drawable, geometry::Point, text::Text};
    /// use fixel::prelude::*;
    /// static WALL: Mesh = shape!(cuboid(vec3!(1, 1, 1)));
    /// let projection = Projection::perspective(deg!(90), (2, 1), fx!(0.5), fx!(20))?;
    /// let (mut pixels, mut depths) = ([Rgb565::BLACK; 26 * 13], [0; 26 * 13]);
    /// let mut canvas = Canvas::new(&mut pixels, 26, 13)?.with_depth(&mut depths)?;
    /// canvas.clear(Rgb565::BLACK);
    ///
    /// let wall = projection * Transform::translate(vec3!(0, 0, -3));
    /// canvas.draw(&WALL, &wall, &Flat::new(Rgb565::BLUE));
    /// // One label behind the front of the wall, and one in front of it.
    /// let style = MonoTextStyle::new(&FONT_4X6, Rgb565::WHITE);
    /// for (text, point) in [("Behind", vec3!(-12, 1, -6)), ("Before", vec3!(-5.4, -2, -2.9))] {
    ///     if let Some(at) = canvas.project(&DrawOptions::new(), &projection, point) {
    ///         Text::new(text, Point::zero(), style).draw(&mut canvas.label(at))?;
    ///     }
    /// }
    ///
    /// let mut display = MockDisplay::new();
    /// canvas.show(&mut display)?;
    /// display.assert_pattern(&[
    ///     "KKKKKKKKKKKKKKKKKKKKKKKKKK",
    ///     "WWKKKKKKWKKKKWKKKKKKKKWKKK",
    ///     "WKWKKWKKWWKKKKKKWWKKKWWKKK",
    ///     "WWKKWKWKWKBBBBBBWKWKWKWKKK",
    ///     "WKWKWWKKWKBBBBBBWKWKWKWKKK",
    ///     "WWKKKWWKWKBBBBBBWKWKKWWKKK",
    ///     "WWKKKKKKKKBBBBBBKKKKKKKKKK",
    ///     "WKWKKWKKKWBBBBBBWKWKKWKKKK",
    ///     "WWKKWKWKWWBBBBBBWWKKWKWKKK",
    ///     "WKWKWWKKKWBBBBBBWKKKWWKKKK",
    ///     "WWKKKWWKKWKKKWKKWKKKKWWKKK",
    ///     "KKKKKKKKKKKKKKKKKKKKKKKKKK",
    ///     "KKKKKKKKKKKKKKKKKKKKKKKKKK",
    /// ]);
    /// # Ok::<(), Error>(())
    /// ```
    #[must_use]
    pub fn label(&mut self, at: ScreenPoint) -> Label<'_, Self> {
        // A subpixel has eight fraction bits; a shift rounds down.
        let [x, y] = [at.x, at.y].map(|at| at.to_bits() >> 8);
        Label::new(self, Point::new(x, y), at.depth)
    }

    /// Whether a mesh within `bounds` may have a pixel in this canvas. If the result is `false`, it certainly has none.
    ///
    /// On a Cortex-M4 the test takes 4,700 instructions, most of them for a set-up that every draw call needs before
    /// its first vertex. So if you skip a mesh that is out of view, or in another band, it costs no more than that.
    ///
    /// ```
    /// use embedded_graphics::pixelcolor::Gray8;
    /// use fixel::mesh::Bounds;
    /// use fixel::prelude::*;
    /// static BALL: Mesh = shape!(sphere(16, 12));
    /// static BOUNDS: Bounds = BALL.bounds();
    /// let mut pixels = [Gray8::new(0); 64];
    /// let mut canvas = Canvas::new(&mut pixels, 8, 8)?;
    /// let projection = Projection::perspective(deg!(60), (1, 1), fx!(0.5), fx!(100))?;
    /// for (x, is_seen) in [(fx!(0), true), (fx!(9), false)] {
    ///     let mvp = projection * Transform::translate(Vec3::new(x, fx!(0), fx!(-5)));
    ///     if canvas.is_in_view(&DrawOptions::new(), &BOUNDS, &mvp) {
    ///         canvas.draw(&BALL, &mvp, &Flat::new(Gray8::new(9)));
    ///     }
    ///     assert_eq!(canvas.is_in_view(&DrawOptions::new(), &BOUNDS, &mvp), is_seen);
    /// }
    /// # Ok::<(), Error>(())
    /// ```
    #[must_use]
    pub fn is_in_view<M, Z, B, L>(
        &self,
        options: &DrawOptions<M, Z, B, L>,
        bounds: &Bounds,
        mvp: &impl ModelToPicture,
    ) -> bool {
        let screen = options.screen(self.frame_size());
        let projector = Projector::new(
            Positions::of_one(&Vec3::ZERO),
            mvp.projection_of(),
            &mvp.model_view_of(),
            &screen.viewport,
        );
        let scissor = screen.scissor(self.rows());
        !scissor.is_empty() && !projector.misses(bounds, &scissor)
    }

    /// The size of `bounds` on the screen: the length of their diagonal, seen at the distance of their center, in
    /// pixels, rounded down. Use it to choose among meshes with different levels of detail.
    ///
    /// It is `u32::MAX` if the eye is nearer to the center than half of the diagonal, or if the bounds are behind the
    /// eye. Corners are rounded to [`Scalar`](crate::Scalar)s in eye space.
    ///
    /// ```
    /// use embedded_graphics::pixelcolor::Gray8;
    /// use fixel::mesh::Bounds;
    /// use fixel::prelude::*;
    /// static FINE: Mesh = shape!(sphere(24, 16));
    /// static COARSE: Mesh = shape!(sphere(8, 6));
    /// static BOUNDS: Bounds = FINE.bounds();
    /// let mut pixels = [Gray8::new(0); 64 * 64];
    /// let mut canvas = Canvas::new(&mut pixels, 64, 64)?;
    /// let projection = Projection::perspective(deg!(60), (1, 1), fx!(0.5), fx!(100))?;
    /// for (distance, faces) in [(4, FINE.faces().len()), (40, COARSE.faces().len())] {
    ///     let mvp = projection * Transform::translate(Vec3::from_ints(0, 0, -distance));
    ///     let level = match canvas.size_on_screen(&DrawOptions::new(), &BOUNDS, &mvp) {
    ///         24.. => &FINE,
    ///         _ => &COARSE,
    ///     };
    ///     let drawn = canvas.draw(level, &mvp, &Flat::new(Gray8::new(9)));
    ///     assert_eq!(drawn.submitted, faces as u32);
    /// }
    /// # Ok::<(), Error>(())
    /// ```
    #[must_use]
    pub fn size_on_screen<M, Z, B, L, V: ModelToPicture>(
        &self,
        options: &DrawOptions<M, Z, B, L>,
        bounds: &Bounds,
        mvp: &V,
    ) -> u32 {
        let view = mvp.model_view_of();
        let (a, b) = (view.point(bounds.least()), view.point(bounds.most()));
        let diagonal = a.distance(b).to_bits();
        // Twice the distance of the middle.
        let ahead = -(i64::from(a.z.to_bits()) + i64::from(b.z.to_bits()));
        if V::Kind::PERSPECTIVE && ahead <= i64::from(diagonal) {
            return u32::MAX;
        }
        let viewport = options.screen(self.frame_size()).viewport;
        let [width, _] = mvp.projection_of().pixel(&viewport);
        let pixel = if V::Kind::PERSPECTIVE {
            width.times(BlockFloat::new(ahead, 17))
        } else {
            width
        };
        let size = BlockFloat::new(diagonal.into(), 16).over(pixel);
        // Rounded to 2^-8, then down.
        u32::try_from(size.at(8) >> 8).unwrap_or(u32::MAX)
    }

    /// Sets up a draw call and runs it.
    #[inline]
    fn paint<M: Mode, Z: DepthTest, B: Copy, L: Copy, V: ModelToPicture, P: Painter<Color = C>>(
        &mut self,
        options: &DrawOptions<M, Z, B, L>,
        (mesh, mvp): (&Mesh<'_>, &V),
        painter: P,
        stages: impl FnOnce(&Call<'_, V::Kind>, &mut dyn Blitter) -> Drawn,
    ) -> Drawn {
        let call = Call::new(&options.screen(self.frame_size()), self.rows(), mesh, mvp);
        let modes = (options.pixels.mode, options.pixels.depth);
        let mut blit =
            Blit::<_, _, _, V::Kind, _, _>::new(modes, self, painter, call.projector.depth_shift());
        stages(&call, &mut blit)
    }

    /// The same for primitives that are prepared.
    #[inline]
    fn paint_prepared<M: Mode, Z: DepthTest, B, K: ProjectionKind, P: Painter<Color = C>>(
        &mut self,
        (call, pixels): (&PreparedCall<'_, K>, &PixelOptions<M, Z, B>),
        painter: P,
        stages: impl FnOnce(&Range<u32>, &mut dyn Blitter) -> Drawn,
    ) -> Result<Drawn, Error> {
        call.screen.check(self.frame_size())?;
        let rows = self.rows().clone();
        let modes = (pixels.mode, pixels.depth);
        let mut blit = Blit::<_, _, _, K, _, _>::new(modes, self, painter, call.depth_shift);
        Ok(stages(&rows, &mut blit))
    }
}
