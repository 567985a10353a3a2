//! The draw call: a mesh through its stages onto a canvas.
//!
//! [`run`] has the stages in order. This file has the canvas's methods that start them. Two files have its
//! methods that draw nothing: [`on_screen`] tells where a point or a mesh is on the screen, [`ray`] what is seen at a
//! pixel.

mod assemble;
mod cache;
mod call;
mod clip;
mod line_style;
mod list;
mod on_screen;
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
pub use on_screen::ScreenPoint;
pub use options::DrawOptions;
pub use ray::{Hit, Ray};

use core::ops::Range;

use embedded_graphics::pixelcolor::PixelColor;

use call::Call;
use list::PreparedCall;
use options::PixelOptions;
use sprites::Quads;

use crate::Error;
use crate::canvas::{Blending, Canvas, DepthBuffer, DepthTest, Storage};
use crate::mesh::{Mesh, Missing, Outline, Sprites};
use crate::raster::{Blitter, PointStyle};
use crate::shade::ShaderFor;
use crate::span::{Blit, Mode, Shading, is_plane};
use crate::view::{AsMvp, ProjectionKind};

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
    /// The number of these that may have changed a pixel. Triangles count if they are not culled and the smallest
    /// upright rectangle around them contains a pixel center of the viewport in the canvas's rows. Lines and points
    /// count if any part of them lies between the near and the far plane and in the guard band, ±2048 pixels around the
    /// viewport's center; prepared edges must also reach a row of the viewport in the canvas.
    pub drawn: u32,
    /// The number of these that were clipped by a plane of the view volume or of the guard band.
    pub clipped: u32,
    /// The attributes that the shader asked for and the mesh lacks.
    pub missing: Missing,
}

impl<C: PixelColor, O: Storage<C>, D: DepthBuffer> Canvas<'_, C, O, D> {
    /// Projects a mesh's triangles with `mvp` to the whole frame, and draws the part in this canvas. Back faces are
    /// culled, depth is tested if the canvas has a depth buffer, and attributes are interpolated in correct
    /// perspective.
    ///
    /// `mvp` is a [`Projection`](crate::Projection) times a camera and a model transform (an [`Mvp`](crate::Mvp)), or
    /// a projection alone. Drawing cannot fail: parts outside the view are clipped away.
    pub fn draw(&mut self, mesh: &Mesh<'_>, mvp: &impl AsMvp, shader: &impl ShaderFor<C>) -> Drawn {
        self.draw_with(&DrawOptions::new(), mesh, mvp, shader)
    }

    /// Draws a mesh's triangles like [`draw`](Self::draw), with options.
    pub fn draw_with<M: Mode, Z: DepthTest, B: Blending<C>>(
        &mut self,
        options: &DrawOptions<M, Z, B>,
        mesh: &Mesh<'_>,
        mvp: &impl AsMvp,
        shader: &impl ShaderFor<C>,
    ) -> Drawn {
        let shading = (*shader, options.pixels.blending);
        self.run_stages(options, (mesh, mvp), shading, run::draw)
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
        shader: &impl ShaderFor<C>,
    ) -> Result<Drawn, Error> {
        let shading = (*shader, prepared.pixels.blending);
        let list = (&prepared.call, &prepared.pixels);
        self.run_prepared(list, shading, |rows, blitter| prepared.draw(rows, blitter))
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
        shader: &impl ShaderFor<C>,
    ) -> Result<Drawn, Error> {
        let state = L::State::default();
        let shading = L::shading(&state, *shader, prepared.pixels.blending);
        let list = (&prepared.call, &prepared.pixels);
        self.run_prepared(list, shading, |rows, blitter| {
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
        mvp: &impl AsMvp,
        shader: &impl ShaderFor<C>,
    ) -> Drawn {
        let state = L::State::default();
        let shading = L::shading(&state, *shader, options.pixels.blending);
        self.run_stages(options, (mesh, mvp), shading, |call, blitter| {
            options.line.edges(&state, call, blitter)
        })
    }

    /// Draws a mesh's [`Outline`] as [`draw_edges`](Self::draw_edges) draws edges: those creases and silhouettes of
    /// which at least one face is not culled.
    ///
    /// Faces are found to be front or back by the same rule as for drawn triangles, so the outline of a closed mesh has
    /// no gaps.
    ///
    /// To remove hidden lines, draw the faces first, in the color of the background and behind their true depth. For
    /// creases, [`Biased::behind`](crate::canvas::Biased::behind) is far enough; silhouettes need
    /// [`Biased::behind_outlines`](crate::canvas::Biased::behind_outlines).
    ///
    /// ```
    /// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor};
    /// use fixel::{prelude::*, canvas::{Biased, TestAndWrite}};
    /// static CAN: Mesh = shape!(cylinder(16));
    /// static RIMS: Outline = outline!(CAN, deg!(30));
    /// let projection = Projection::perspective(deg!(40), (1, 1), fx!(1), fx!(9))?;
    /// let camera = Camera::look_at(vec3!(0, 2, 4), Vec3::ZERO, Vec3::Y)?;
    /// let mvp = projection * camera;
    /// let (mut color, mut depth) = ([BinaryColor::Off; 24 * 24], [0; 24 * 24]);
    /// let mut canvas = Canvas::new(&mut color, 24, 24)?.with_depth(&mut depth)?;
    /// canvas.clear(BinaryColor::Off);
    /// let behind = DrawOptions::new().with_depth(Biased::behind_outlines(TestAndWrite));
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
        mvp: &impl AsMvp,
        shader: &impl ShaderFor<C>,
    ) -> Drawn {
        let state = L::State::default();
        let shading = L::shading(&state, *shader, options.pixels.blending);
        self.run_stages(options, (mesh, mvp), shading, |call, blitter| {
            let line = options.line.bind(&state);
            outline::outline(call, outline, &line, blitter)
        })
    }

    /// Draws a mesh's positions as points: for each, the pixel that contains it.
    pub fn draw_points<M: Mode, Z: DepthTest, B: Blending<C>>(
        &mut self,
        options: &DrawOptions<M, Z, B>,
        mesh: &Mesh<'_>,
        mvp: &impl AsMvp,
        shader: &impl ShaderFor<C>,
    ) -> Drawn {
        let shading = (*shader, options.pixels.blending);
        self.run_stages(options, (mesh, mvp), shading, run::points)
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
        mvp: &impl AsMvp,
        shader: &impl ShaderFor<C>,
    ) -> Drawn {
        let screen = options.screen(self.frame_size());
        let half = points::HalfSize::new(style, mvp.projection_of(), &screen.viewport);
        let shading = (*shader, options.pixels.blending);
        self.run_stages(options, (mesh, mvp), shading, |call, blitter| {
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
    /// Every shader works: to it, sprites are a mesh in eye space whose normals point toward the viewer. The two
    /// triangles of sprite i have the indices 2i and 2i + 1. A corner's way from the sprite's position is accurate to
    /// 2⁻²⁶ of the longest one. Then corners are rounded to the nearest [`Scalar`](crate::Scalar)s in eye space, which
    /// moves them by at most 2⁻¹⁶ · focal length / w pixels. A sprite with a corner beyond ±32,768 in eye space is not
    /// drawn.
    ///
    /// With [`cut_out`](crate::Textured::cut_out), sprites may be drawn in any order, because holes leave depths as
    /// they are.
    ///
    /// ```
    /// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Gray8};
    /// use fixel::prelude::*;
    /// const NO: Gray8 = Gray8::new(0);
    /// const IS: Gray8 = Gray8::new(9);
    /// static TREE: [[Gray8; 4]; 4] = [
    ///     [NO, IS, IS, NO],
    ///     [IS, IS, IS, IS],
    ///     [NO, IS, IS, NO],
    ///     [NO, IS, IS, NO],
    /// ];
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
    /// let leaves = Textured::new(&TREE).clamped().cut_out(NO);
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
    pub fn draw_sprites<M: Mode, Z: DepthTest, B: Blending<C>, V: AsMvp>(
        &mut self,
        options: &DrawOptions<M, Z, B>,
        sprites: &Sprites<'_>,
        mvp: &V,
        shader: &impl ShaderFor<C>,
    ) -> Drawn {
        let screen = options.screen(self.frame_size());
        let scissor = screen.scissor(self.rows());
        let quads = Quads::new(sprites, mvp, &screen.viewport);
        let shading = (*shader, options.pixels.blending);
        let modes = (options.pixels.mode, options.pixels.depth);
        let depth_shift = quads.projector.depth_shift();
        let mut blit = Blit::<_, _, _, V::Kind, _, _>::new(modes, self, shading, depth_shift);
        quads.draw(&scissor, &|halves| is_plane(&shading, halves), &mut blit)
    }

    /// Sets up a draw call and runs it.
    #[inline]
    fn run_stages<M: Mode, Z: DepthTest, B: Copy, L: Copy, V: AsMvp, P: Shading<Color = C>>(
        &mut self,
        options: &DrawOptions<M, Z, B, L>,
        (mesh, mvp): (&Mesh<'_>, &V),
        shading: P,
        stages: impl FnOnce(&Call<'_, V::Kind>, &mut dyn Blitter) -> Drawn,
    ) -> Drawn {
        let call = Call::new(&options.screen(self.frame_size()), self.rows(), mesh, mvp);
        let modes = (options.pixels.mode, options.pixels.depth);
        let mut blit =
            Blit::<_, _, _, V::Kind, _, _>::new(modes, self, shading, call.projector.depth_shift());
        stages(&call, &mut blit)
    }

    /// Sets up a draw call for prepared primitives and runs it.
    #[inline]
    fn run_prepared<M: Mode, Z: DepthTest, B, K: ProjectionKind, P: Shading<Color = C>>(
        &mut self,
        (call, pixels): (&PreparedCall<'_, K>, &PixelOptions<M, Z, B>),
        shading: P,
        stages: impl FnOnce(&Range<u32>, &mut dyn Blitter) -> Drawn,
    ) -> Result<Drawn, Error> {
        call.screen.check(self.frame_size())?;
        let rows = self.rows().clone();
        let modes = (pixels.mode, pixels.depth);
        let mut blit = Blit::<_, _, _, K, _, _>::new(modes, self, shading, call.depth_shift);
        Ok(stages(&rows, &mut blit))
    }
}
