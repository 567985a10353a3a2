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

use crate::Vec3;
use crate::mesh::{Mesh, Missing, Positions};
use crate::num::Subpixel;
use crate::raster::{DepthShift, ScreenVertex};
use crate::shade::{Shader, ShaderFor};
use crate::span::{Blit, Mode};
use crate::target::{Canvas, DepthBuffer, DepthTest, Storage};
use crate::view::{ModelToPicture, ProjectionKind};

/// What became of a draw call's triangles, edges or points.
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
    /// How many there were.
    pub submitted: u32,
    /// How many may have left a pixel: triangles that face the right way and meet the viewport and the
    /// canvas' rows, lines and points that are not outside the guard band.
    pub drawn: u32,
    /// How many of those drawn were cut by a plane of the view volume or of the guard band.
    pub clipped: u32,
    /// What the shader asked for and the mesh lacks.
    pub missing: Missing,
}

/// Where a point of model space is on the screen.
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
    /// Columns from the frame's left edge, to the nearest 1/256: a pixel's center is half a column
    /// from its edges.
    pub x: Subpixel,
    /// Rows from the frame's top edge.
    pub y: Subpixel,
    /// Depth as it would be stored in the canvas' depth buffer, or in a linear one if it has none.
    pub depth: u16,
}

impl<'c, C, O: Storage<C>, D: DepthBuffer> Canvas<'c, C, O, D> {
    /// Draws a mesh's triangles: through `mvp` into the whole frame, without back faces, each pixel correct in
    /// perspective.
    ///
    /// Cannot fail: what lies outside the view is clipped away.
    pub fn draw<V: ModelToPicture, S: ShaderFor<C>>(
        &mut self,
        mesh: &Mesh<'_>,
        mvp: &V,
        shader: &S,
    ) -> Drawn {
        self.draw_with(&DrawOptions::new(), mesh, mvp, shader)
    }

    /// Draws a mesh's triangles as [`draw`](Self::draw) does, with options.
    pub fn draw_with<M: Mode, Z: DepthTest, V: ModelToPicture, S: ShaderFor<C>>(
        &mut self,
        options: &DrawOptions<M, Z>,
        mesh: &Mesh<'_>,
        mvp: &V,
        shader: &S,
    ) -> Drawn {
        let call = Call::new(options, mesh, mvp, (self.frame_size(), self.rows()));
        let mut blit = self.blit::<V::Kind, _, _, _>(options, shader, call.depth_shift());
        run::draw(&call, &mut blit)
    }

    /// Draws triangles that were [prepared](TriangleList::prepare) for this frame, as far as they
    /// are in these rows: the same pixels as [`draw_with`](Self::draw_with), without another transform.
    pub fn draw_prepared<M: Mode, Z: DepthTest, K: ProjectionKind, S: ShaderFor<C>>(
        &mut self,
        prepared: &Prepared<'_, K, M, Z>,
        shader: &S,
    ) -> Drawn {
        let (width, rows) = (self.frame_size().width, self.rows().clone());
        let (mode, test) = (prepared.mode, prepared.test);
        let mut blit =
            Blit::<_, _, _, K, _, _>::new((mode, test), self, *shader, prepared.depth_shift);
        prepared.draw(&mut blit, width, &rows)
    }

    /// Draws a mesh's [edges](Mesh::edges) as lines, one pixel wide.
    pub fn draw_edges<M: Mode, Z: DepthTest, V: ModelToPicture, S: ShaderFor<C>>(
        &mut self,
        options: &DrawOptions<M, Z>,
        mesh: &Mesh<'_>,
        mvp: &V,
        shader: &S,
    ) -> Drawn {
        let call = Call::new(options, mesh, mvp, (self.frame_size(), self.rows()));
        let mut blit = self.blit::<V::Kind, _, _, _>(options, shader, call.depth_shift());
        run::edges(&call, &mut blit)
    }

    /// Draws a mesh's positions as points, one pixel each.
    pub fn draw_points<M: Mode, Z: DepthTest, V: ModelToPicture, S: ShaderFor<C>>(
        &mut self,
        options: &DrawOptions<M, Z>,
        mesh: &Mesh<'_>,
        mvp: &V,
        shader: &S,
    ) -> Drawn {
        let call = Call::new(options, mesh, mvp, (self.frame_size(), self.rows()));
        let mut blit = self.blit::<V::Kind, _, _, _>(options, shader, call.depth_shift());
        run::points(&call, &mut blit)
    }

    /// Where a point of model space comes to lie, to the last bit as when it is drawn; `None` if it
    /// is nearer than the near plane, beyond the far plane or more than 2048 pixels from the
    /// viewport's center. It may be outside the viewport.
    ///
    /// Use it to place a label beside a thing, or to find what a touch meets.
    #[must_use]
    pub fn project<M: Copy, Z: Copy, V: ModelToPicture>(
        &self,
        options: &DrawOptions<M, Z>,
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
        let mut at = ScreenVertex::NONE;
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

    /// What a draw call draws with.
    #[inline]
    fn blit<'p, K: ProjectionKind, M: Mode, Z: DepthTest, S: Shader<Color = C>>(
        &'p mut self,
        options: &DrawOptions<M, Z>,
        shader: &S,
        shift: DepthShift,
    ) -> Blit<'p, 'c, S, O, D, K, M, Z> {
        Blit::new((options.mode, options.depth), self, *shader, shift)
    }
}
