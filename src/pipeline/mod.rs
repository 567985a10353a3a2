//! The draw call: the stages from a mesh to the pixels of a canvas.
//!
//! [`Canvas::draw_with`] in this file starts the stages, and [`run`] calls them one after another. Three files answer
//! questions and draw nothing: [`on_screen`] tells where a point is on the screen, [`rectangle`] tells which pixels a
//! mesh may change, and [`ray`] finds the surface that a pixel shows.

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
mod rectangle;
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
use crate::mesh::{CornerCache, Missing, Placement};
use crate::raster::Rasterizer;
use crate::shade::{Shader, ShaderFor};
use crate::span::{Blit, Mode};
use crate::view::AsMvp;
use thing::Target;

/// The result of a draw call: how many triangles, edges or points there were, and what became of them.
///
/// Each triangle, edge or point counts as drawn, culled or [outside](Self::outside) the view. If you see nothing, print
/// this value:
///
/// | if all are | then |
/// |---|---|
/// | culled | the corners of the triangles run clockwise, seen from outside: see [`Cull`](crate::Cull) |
/// | outside | the mesh is behind the eye, nearer than the near plane, beyond the far plane or beside the picture |
/// | drawn | nearer depths hide them (is the depth buffer cleared in each frame?), or they have the background's color |
///
/// If the [bounds](crate::Mesh::with_bounds) of a mesh are known and out of view, all of its triangles count as
/// outside.
///
/// If [`submitted`](Self::submitted) is 0, the mesh has no faces, or, for lines, no edges: [`missing`](Self::missing)
/// then says so.
///
/// ```
/// use embedded_graphics::pixelcolor::Gray8;
/// use fixel::prelude::*;
/// static BOX: Mesh = shape!(cuboid(vec3!(1, 1, 1)));
/// let mut pixels = [Gray8::new(0); 64];
/// let mut canvas = Canvas::new(&mut pixels, 8, 8)?;
/// let projection = Projection::perspective(Angle::from_degrees(90), (1, 1), fx!(0.1), fx!(10))?;
/// let white = Flat::new(Gray8::new(255));
///
/// let ahead = projection * Transform::translate(vec3!(0, 0, -3));
/// let drawn = canvas.draw(&BOX, &ahead, &white);
/// assert_eq!((drawn.submitted, drawn.drawn, drawn.culled), (12, 2, 10)); // the two triangles of the front
/// assert_eq!((drawn.outside(), drawn.clipped), (0, 0));
///
/// let behind = projection * Transform::translate(vec3!(0, 0, 3));
/// let drawn = canvas.draw(&BOX, &behind, &white);
/// assert_eq!((drawn.drawn, drawn.culled, drawn.outside()), (0, 0, 12));
/// # Ok::<(), Error>(())
/// ```
#[cfg_attr(doc, doc = include_str!("../guide/tables.html"))]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Drawn {
    /// The number of triangles, edges or points in the mesh.
    pub submitted: u32,
    /// The number of triangles, edges or points that may have changed a pixel. A triangle counts if it is not culled,
    /// and its bounding rectangle on the screen contains a pixel center of the viewport in the canvas's rows. A line or
    /// point counts if any part of it is between the near and the far plane, is at most 2048 pixels from the viewport's
    /// center in x and y (in the guard band), and may reach a row of the viewport in the canvas.
    pub drawn: u32,
    /// The number of triangles that were [culled](crate::Cull), or that have no area on the screen. For an
    /// [outline](crate::Mesh::outline), the number of edges that do not show the shape, as seen from the eye.
    pub culled: u32,
    /// The number of triangles, edges or points that were clipped by a plane of the view volume or of the guard band.
    pub clipped: u32,
    /// The data that the draw call needed but the mesh does not have, such as normals.
    pub missing: Missing,
}

impl Drawn {
    /// The number of triangles, edges or points that were neither drawn nor culled. They are outside the view: nearer
    /// than the near plane (perhaps behind the eye), beyond the far plane, or beside the picture. This number also
    /// counts triangles that are so small that they contain no pixel center and, if the canvas is a band, everything
    /// that has no pixel in the band's rows.
    #[must_use]
    pub const fn outside(&self) -> u32 {
        self.submitted
            .saturating_sub(self.drawn.saturating_add(self.culled))
    }

    /// The result of a draw call that had this number of triangles, edges or points. (The missing attributes are read
    /// from the call's own placement, because it takes more code to follow the rasterizer's reference to it.)
    #[inline]
    fn new(
        [submitted, culled]: [u32; 2],
        raster: &Rasterizer<'_>,
        placement: &Placement<'_>,
    ) -> Self {
        Self {
            submitted,
            drawn: raster.drawn,
            culled,
            clipped: raster.clipped,
            missing: placement.missing.get(),
        }
    }
}

impl AddAssign for Drawn {
    #[inline]
    fn add_assign(&mut self, other: Self) {
        self.submitted += other.submitted;
        self.drawn += other.drawn;
        self.culled += other.culled;
        self.clipped += other.clipped;
        self.missing += other.missing;
    }
}

impl<C: PixelColor, O: Storage<C>, D: DepthBuffer> Canvas<'_, C, O, D> {
    /// Draws `thing`. `mvp` projects the thing to the whole frame; a canvas that is a band draws the rows of the band.
    /// Back faces are left out, depth is tested if the canvas has a depth buffer, and attributes are interpolated in
    /// correct perspective.
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
    /// A triangle draws the pixels whose centers it covers. A center exactly on an edge counts as covered if the edge
    /// is a left edge, or a horizontal edge at the top. So triangles that share an edge draw each pixel once ([the
    /// top-left rule](crate::guide::mathematics::triangles#a-shared-edge)).
    pub fn draw(
        &mut self,
        thing: impl Thing<C>,
        mvp: &impl AsMvp,
        shader: &impl ShaderFor<C>,
    ) -> Drawn {
        self.draw_with(&DrawOptions::new(), thing, mvp, shader)
    }

    /// Draws `thing` like [`draw`](Self::draw), with options.
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
            keeps_corners: keeps_corners(shader),
        };
        thing.draw(mvp, target)
    }
}

/// Whether an effect of the shader keeps what it computes at corners. A build for size does without.
#[inline]
const fn keeps_corners<S: Shader>(_: &S) -> bool {
    S::KEEPS_CORNERS && !cfg!(for_size)
}

/// A cache for the corners of a draw call of some elements, if an effect of the shader uses one. Few elements would
/// take less than to make the cache.
#[inline]
fn corner_cache(keeps: bool, elements: usize) -> Option<CornerCache> {
    (keeps && elements > 8).then(CornerCache::new)
}
