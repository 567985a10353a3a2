//! The draw call: a mesh through its stages onto a canvas.

mod assemble;
mod cache;
mod call;
mod clip;
mod list;
mod options;
mod run;
mod vertex;

pub use list::{Prepared, TriangleList};
pub use options::DrawOptions;

use call::Call;
use vertex::Projector;

use embedded_graphics::pixelcolor::PixelColor;

use crate::Vec3;
use crate::mesh::{Bounds, Mesh, Missing, Positions};
use crate::num::Subpixel;
use crate::raster::{Blitter, Scissor, ScreenVertex};
use crate::shade::ShaderFor;
use crate::span::{Blit, Mode};
use crate::target::{Blending, Canvas, DepthBuffer, DepthTest, Storage};
use crate::view::{ModelToPicture, ProjectionKind};

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
    /// The number of these that may have changed a pixel: triangles that are not culled and that meet the viewport
    /// and the canvas's rows, and lines and points that are not entirely outside the guard band, ±2048 pixels around
    /// the viewport's center.
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
    /// culled, and every pixel is correct in perspective.
    ///
    /// `mvp` is a [`Projection`](crate::Projection) times a camera and a model transform (an [`Mvp`](crate::Mvp)), or
    /// a projection alone. Drawing cannot fail: parts outside the view are clipped away.
    pub fn draw<V: ModelToPicture, S: ShaderFor<C>>(
        &mut self,
        mesh: &Mesh<'_>,
        mvp: &V,
        shader: &S,
    ) -> Drawn {
        self.draw_with(&DrawOptions::new(), mesh, mvp, shader)
    }

    /// Draws a mesh's triangles like [`draw`](Self::draw), with options.
    pub fn draw_with<
        M: Mode,
        Z: DepthTest,
        B: Blending<C>,
        V: ModelToPicture,
        S: ShaderFor<B::Source>,
    >(
        &mut self,
        options: &DrawOptions<M, Z, B>,
        mesh: &Mesh<'_>,
        mvp: &V,
        shader: &S,
    ) -> Drawn {
        self.call(options, (mesh, mvp), shader, run::draw)
    }

    /// Draws the triangles that were [prepared](TriangleList::prepare) for this frame and meet this canvas's rows. The
    /// pixels are those of [`draw_with`](Self::draw_with), but nothing is transformed again.
    ///
    /// A canvas that is narrower than this frame draws the columns that it has.
    pub fn draw_prepared<
        M: Mode,
        Z: DepthTest,
        B: Blending<C>,
        K: ProjectionKind,
        S: ShaderFor<B::Source>,
    >(
        &mut self,
        prepared: &Prepared<'_, K, M, Z, B>,
        shader: &S,
    ) -> Drawn {
        let (width, rows) = (self.frame_size().width, self.rows().clone());
        let (mode, test) = (prepared.mode, prepared.test);
        let mut blit = Blit::<_, _, _, K, _, _>::new(
            (mode, test),
            self,
            (*shader, prepared.blending),
            prepared.depth_shift,
        );
        prepared.draw(&mut blit, width, &rows)
    }

    /// Draws a mesh's [edges](Mesh::edges) as lines, one pixel wide.
    ///
    /// A line gets one pixel for each pixel center that it passes along its longer axis. Its right end (lower end, if
    /// it is steep) does not belong to it, so lines that continue each other draw no pixel twice.
    pub fn draw_edges<
        M: Mode,
        Z: DepthTest,
        B: Blending<C>,
        V: ModelToPicture,
        S: ShaderFor<B::Source>,
    >(
        &mut self,
        options: &DrawOptions<M, Z, B>,
        mesh: &Mesh<'_>,
        mvp: &V,
        shader: &S,
    ) -> Drawn {
        self.call(options, (mesh, mvp), shader, run::edges)
    }

    /// Draws a mesh's positions as points: the pixel that contains each.
    pub fn draw_points<
        M: Mode,
        Z: DepthTest,
        B: Blending<C>,
        V: ModelToPicture,
        S: ShaderFor<B::Source>,
    >(
        &mut self,
        options: &DrawOptions<M, Z, B>,
        mesh: &Mesh<'_>,
        mvp: &V,
        shader: &S,
    ) -> Drawn {
        self.call(options, (mesh, mvp), shader, run::points)
    }

    /// The screen position of a point of model space, with the same bits as when it is drawn.
    ///
    /// The result is `None` if the point is nearer than the near plane, beyond the far plane, or more than 2048
    /// pixels left or right of, above or below the viewport's center. The position may lie outside the viewport.
    ///
    /// Use it to place a label beside an object, or to find the object under a touch.
    #[must_use]
    pub fn project<M: Copy, Z: Copy, B: Copy, V: ModelToPicture>(
        &self,
        options: &DrawOptions<M, Z, B>,
        mvp: &V,
        point: Vec3,
    ) -> Option<ScreenPoint> {
        let viewport = options.viewport_in(self.frame_size());
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

    /// Whether a mesh within `bounds` may have a pixel in this canvas; `false` is certain.
    ///
    /// On a Cortex-M4 the test takes 4,400 instructions, most of which a draw call takes before its first vertex. So a
    /// mesh that is out of view, or in another band, costs no more than that.
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
    pub fn is_in_view<M: Copy, Z: Copy, B: Copy, V: ModelToPicture>(
        &self,
        options: &DrawOptions<M, Z, B>,
        bounds: &Bounds,
        mvp: &V,
    ) -> bool {
        let (frame, rows) = (self.frame_size(), self.rows());
        let viewport = options.viewport_in(frame);
        let projector = Projector::new(
            Positions::of_one(&Vec3::ZERO),
            mvp.projection_of(),
            &mvp.model_view_of(),
            &viewport,
        );
        let scissor = Scissor::new(&viewport, frame.width, rows);
        !scissor.is_empty() && !projector.misses(bounds, &scissor)
    }

    /// Sets up a draw call and runs it.
    #[inline]
    fn call<M: Mode, Z: DepthTest, B: Blending<C>, V: ModelToPicture, S: ShaderFor<B::Source>>(
        &mut self,
        options: &DrawOptions<M, Z, B>,
        (mesh, mvp): (&Mesh<'_>, &V),
        shader: &S,
        stages: impl FnOnce(&Call<'_, V::Kind>, &mut dyn Blitter) -> Drawn,
    ) -> Drawn {
        let call = Call::new(options, mesh, mvp, (self.frame_size(), self.rows()));
        let modes = (options.mode, options.depth);
        let mut blit = Blit::<_, _, _, V::Kind, _, _>::new(
            modes,
            self,
            (*shader, options.blending),
            call.depth_shift(),
        );
        stages(&call, &mut blit)
    }
}
