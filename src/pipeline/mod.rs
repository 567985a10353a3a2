//! The draw call: a thing through its stages onto a canvas.
//!
//! [`Canvas::draw_with`] in this file starts the stages, and [`run`] has them in order. Two files have methods of the
//! canvas that draw nothing: [`on_screen`] tells where a point or a mesh is on the screen, and [`ray`] tells what
//! is seen at a pixel.

mod assemble;
mod cache;
mod call;
mod clip;
mod edges;
mod list;
mod on_screen;
mod options;
mod points;
mod ray;
mod run;
mod smooth_edges;
mod sprites;
mod thing;
mod vertex;

pub use list::{DrawList, FacesOrEdges, Object, Prepared, ShadeList};
pub use on_screen::ScreenPoint;
pub use options::DrawOptions;
pub use ray::{Hit, Ray};
pub use thing::Thing;

use core::cell::Cell;
use core::ops::AddAssign;

use embedded_graphics::pixelcolor::PixelColor;

use crate::canvas::{Blending, Canvas, DepthBuffer, DepthTest, Storage};
use crate::mesh::Missing;
use crate::raster::Rasterizer;
use crate::shade::ShaderFor;
use crate::span::{Blit, Mode};
use crate::view::AsMvp;
use thing::Target;

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
    /// The number of triangles, edges or points that may have changed a pixel. A triangle counts if it is not culled,
    /// and its bounding rectangle on the screen contains a pixel center of the viewport in the canvas's rows. A line or
    /// point counts if any part of it is between the near and the far plane and in the guard band (±2048 pixels around
    /// the viewport's center), and may reach a row of the viewport in the canvas.
    pub drawn: u32,
    /// The number of triangles, edges or points that were clipped by a plane of the view volume or of the guard band.
    pub clipped: u32,
    /// The attributes that the shader asked for and the mesh lacks.
    pub missing: Missing,
}

impl Drawn {
    /// The result of a draw call that had this number of triangles, edges or points.
    #[inline]
    fn new(submitted: usize, raster: &Rasterizer<'_>) -> Self {
        Self {
            submitted: submitted as u32,
            drawn: raster.drawn,
            clipped: raster.clipped,
            missing: raster.primitive.placement.missing.get(),
        }
    }
}

impl AddAssign for Drawn {
    #[inline]
    fn add_assign(&mut self, other: Self) {
        self.submitted += other.submitted;
        self.drawn += other.drawn;
        self.clipped += other.clipped;
        self.missing += other.missing;
    }
}

impl<C: PixelColor, O: Storage<C>, D: DepthBuffer> Canvas<'_, C, O, D> {
    /// Projects a thing with `mvp` to the whole frame, and draws the part of it that is in this canvas. Back faces are
    /// culled, depth is tested if the canvas has a depth buffer, and attributes are interpolated in correct
    /// perspective.
    ///
    /// | `thing` | is drawn as |
    /// |---|---|
    /// | `&mesh` or a part of it, [`&mesh.part(range)`](crate::Mesh::part) | triangles |
    /// | [`mesh.edges(style)`](crate::Mesh::edges) | lines |
    /// | [`mesh.outline(&outline, style)`](crate::Mesh::outline) | lines that show the shape |
    /// | [`style.between(from, to)`](crate::LineStyle::between) | a line |
    /// | [`mesh.points(style)`](crate::Mesh::points) | pixels, squares or discs |
    /// | [`&sprites`](crate::Sprites) | rectangles that face the viewer |
    ///
    /// `mvp` is a [`Projection`](crate::Projection) times a camera and a model transform (an [`Mvp`](crate::Mvp)), or
    /// a projection alone. Drawing cannot fail: parts outside the view are clipped away.
    ///
    /// A triangle has the pixels whose centers it covers. A center exactly on an edge belongs to the triangle if the
    /// edge is a left edge, or a level edge at the top. So triangles that share an edge draw each pixel once
    /// ([the top-left rule](crate::guide::mathematics::triangles#a-shared-edge)).
    pub fn draw(
        &mut self,
        thing: impl Thing<C>,
        mvp: &impl AsMvp,
        shader: &impl ShaderFor<C>,
    ) -> Drawn {
        self.draw_with(&DrawOptions::new(), thing, mvp, shader)
    }

    /// Draws a thing like [`draw`](Self::draw), with options.
    pub fn draw_with<T: Thing<C>, M: Mode, Z: DepthTest, B: Blending<C>, V: AsMvp>(
        &mut self,
        options: &DrawOptions<M, Z, B>,
        thing: T,
        mvp: &V,
        shader: &impl ShaderFor<C>,
    ) -> Drawn {
        let region = (&options.screen(self.frame_size()), &self.rows().clone());
        // Anti-aliased lines change the coverage with each line; other things ignore it.
        let coverage = Cell::default();
        let shading = T::Shading::from((options.shading(*shader), &coverage));
        let target = Target {
            region,
            shading: &shading, // sprites ask it whether a quad is one plane
            coverage: &coverage,
            blitter: &mut Blit::<_, _, _, V::Kind, _>::new(options.mode, self, shading),
        };
        thing.draw(mvp, target)
    }
}
