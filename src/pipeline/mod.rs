//! The draw call: a mesh through a mvp of transforms onto a canvas.

mod cache;
mod clip;
mod cull;
mod geometry;
mod painter;
mod pass;
mod prepared;
mod project;
mod projected;

pub(crate) use clip::{ClippedCorner, Outline, Weights, clip};
pub use cull::Cull;
pub use pass::DrawOptions;
pub use prepared::{Prepared, TriangleList};
pub(crate) use project::Projector;
pub(crate) use projected::{DepthShift, Projected};

use geometry::Geometry;
use painter::Painter;

use crate::Vec3;
use crate::math::Transform;
use crate::mesh::{Mesh, Positions};
use crate::num::Subpixel;
use crate::raster::Paint;
use crate::shade::Shader;
use crate::span::Interpolate;
use crate::target::{Canvas, DepthBuffer, Storage};
use crate::view::{Mvp, ProjectionKind as Kind};

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
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Drawn {
    /// How many there were.
    pub submitted: u32,
    /// How many may have left a pixel: triangles that face the right way and meet the viewport and the
    /// canvas' rows, lines and points that are not outside the guard band.
    pub drawn: u32,
    /// How many of those drawn were cut by a plane of the view volume or of the guard band.
    pub clipped: u32,
}

/// Where a point of model space is on the screen.
///
/// ```
/// use embedded_graphics::pixelcolor::Gray8;
/// use fixel::prelude::*;
/// let mut pixels = [Gray8::new(0); 64];
/// let canvas = Canvas::new(&mut pixels, 8, 8)?;
/// let projection = Projection::perspective(Angle::from_degrees(90), (1, 1), fx!(0.5), fx!(10))?;
/// let place = canvas.project(&DrawOptions::new(), &(projection * Transform::IDENTITY), vec3!(0.5, 1, -2)).unwrap();
/// assert_eq!((place.x.to_num(), place.y.to_num()), (5, 2));
/// assert_eq!(place.depth, 65535 / 4);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    /// Columns from the frame's left edge, to the nearest 1/256: a pixel's centre is half a column
    /// from its edges.
    pub x: Subpixel,
    /// Rows from the frame's top edge.
    pub y: Subpixel,
    /// Depth as it would be stored in the canvas' depth buffer, or in a linear one if it has none.
    pub depth: u16,
}

impl<'c, C, O: Storage<C>, D: DepthBuffer> Canvas<'c, C, O, D> {
    /// Draws a mesh's triangles: through `mvp` into the whole frame, without back faces, each
    /// pixel correct in perspective.
    ///
    /// Cannot fail: what cannot be seen is left out, what is partly to be seen is clipped.
    pub fn draw<K: Kind, F: Shader<N, Color = C>, const N: usize>(
        &mut self,
        mesh: &Mesh<'_>,
        mvp: &Mvp<K>,
        shader: &F,
    ) -> Drawn {
        self.draw_with(&DrawOptions::new(), mesh, mvp, shader)
    }

    /// Draws a mesh's triangles as [`draw`](Self::draw) does, in the way that `pass` says.
    pub fn draw_with<I: Interpolate, K: Kind, F: Shader<N, Color = C>, const N: usize>(
        &mut self,
        pass: &DrawOptions<I>,
        mesh: &Mesh<'_>,
        mvp: &Mvp<K>,
        shader: &F,
    ) -> Drawn {
        let mut painter = self.painter(pass, mesh, mvp);
        let mut brush = self.brush(pass.mode, &painter.geometry, shader, &mvp.model);
        painter.triangles(&mut brush);
        painter.drawn
    }

    /// Draws triangles that were [prepared](TriangleList::prepare) for this frame, as far as they
    /// are in these rows: the same pixels as [`draw_with`](Self::draw_with), without another transform.
    pub fn draw_prepared<I: Interpolate, K: Kind, F: Shader<N, Color = C>, const N: usize>(
        &mut self,
        prepared: &Prepared<'_, K, I>,
        shader: &F,
    ) -> Drawn {
        let (width, rows) = (self.frame_size().width, self.rows().clone());
        let mut brush = self.brush(prepared.mode, &prepared.geometry, shader, &prepared.model);
        prepared.draw(&mut brush, width, &rows)
    }

    /// Draws a mesh's [edges](Mesh::edges) as lines, one pixel wide.
    pub fn draw_edges<I: Interpolate, K: Kind, F: Shader<N, Color = C>, const N: usize>(
        &mut self,
        pass: &DrawOptions<I>,
        mesh: &Mesh<'_>,
        mvp: &Mvp<K>,
        shader: &F,
    ) -> Drawn {
        let mut painter = self.painter(pass, mesh, mvp);
        let mut brush = self.brush(pass.mode, &painter.geometry, shader, &mvp.model);
        painter.lines(&mut brush);
        painter.drawn
    }

    /// Where a point of model space comes to lie, to the last bit as when it is drawn; `None` if it
    /// is nearer than the near plane, beyond the far plane or more than 2048 pixels from the
    /// viewport's centre. It may be outside the viewport.
    ///
    /// For a label beside a thing, or a touch upon it.
    #[must_use]
    pub fn project<I: Copy, K: Kind>(
        &self,
        pass: &DrawOptions<I>,
        mvp: &Mvp<K>,
        point: Vec3,
    ) -> Option<Place> {
        let viewport = pass.viewport_in(self.frame_size());
        let projector = Projector::new(
            Positions::of_one(&point),
            &mvp.projection,
            &mvp.model_view(),
            &viewport,
        );
        let mut at = Projected::NONE;
        projector.project(0, &mut at);
        if at.outside != 0 {
            return None;
        }
        let [x, y] = at.screen.map(Subpixel::from_bits);
        Some(Place {
            x,
            y,
            depth: D::encode(at.q, projector.depth_shift().of(at.exponent)) as u16,
        })
    }

    /// Draws a mesh's positions as points, one pixel each.
    pub fn draw_points<I: Interpolate, K: Kind, F: Shader<N, Color = C>, const N: usize>(
        &mut self,
        pass: &DrawOptions<I>,
        mesh: &Mesh<'_>,
        mvp: &Mvp<K>,
        shader: &F,
    ) -> Drawn {
        let mut painter = self.painter(pass, mesh, mvp);
        let mut brush = self.brush(pass.mode, &painter.geometry, shader, &mvp.model);
        painter.points(&mut brush);
        painter.drawn
    }

    /// What a draw call needs to know but for what it paints with.
    #[inline]
    fn painter<'m, I: Copy, K: Kind>(
        &self,
        pass: &DrawOptions<I>,
        mesh: &'m Mesh<'m>,
        mvp: &Mvp<K>,
    ) -> Painter<'m, K> {
        Painter::new(pass, (self.frame_size(), self.rows()), mesh, mvp)
    }

    /// What a draw call paints with.
    #[inline]
    fn brush<'p, I: Interpolate, K: Kind, F: Shader<N, Color = C>, const N: usize>(
        &'p mut self,
        mode: I,
        geometry: &Geometry<'_, K>,
        shader: &F,
        model: &Transform,
    ) -> Paint<'p, 'c, K::Mode<I>, F, O, D, N> {
        let depth_shift = geometry.projector.depth_shift();
        Paint::new(K::mode(mode), self, shader.begin(model), depth_shift)
    }
}
