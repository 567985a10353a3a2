//! Edges: all edges of a mesh, or the edges of its outline.

use super::Drawn;
use super::assemble;
use super::cache::{self, OUTLINE_SIZE, VertexCache};
use super::call::Call;
use super::thing::{Target, Thing};
use crate::canvas::{Blending, DepthTest};
use crate::math::Vec3;
use crate::mesh::{Index, Indices, Mesh, Outline, Positions};
use crate::raster::{self, Blitter, ClippedVertex, LineStyle, Rasterizer};
use crate::sealed::Sealed;
use crate::shade::{PixelFormat, ShaderFor};
use crate::span::{Plain, Shading, Smooth};
use crate::view::{AsMvp, ProjectionKind};

/// Edges of a mesh, to be drawn as lines.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct Edges<'m, const SMOOTH: bool = false> {
    pub(super) of: EdgesOf<'m>,
    pub(super) style: LineStyle<SMOOTH>,
}

/// Edges to choose from: the edges of a mesh, or of its outline.
#[derive(Clone, Copy, Debug)]
pub(super) struct EdgesOf<'m> {
    pub(super) mesh: &'m Mesh<'m>,
    /// `None` means all edges of the mesh.
    outline: Option<&'m Outline<'m>>,
}

impl Mesh<'_> {
    /// The mesh's [edges](Self::edge_indices), to be drawn as lines by [`Canvas::draw`](crate::Canvas::draw) or listed
    /// by a [`DrawList`](crate::DrawList). If the mesh has no edges, nothing is drawn, and the draw call returns
    /// [`missing.edges`](crate::mesh::Missing::edges).
    ///
    /// ```
    /// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor};
    /// use fixel::prelude::*;
    /// static BOX: Mesh = shape!(cuboid(vec3!(1, 1, 1)));
    /// let projection = Projection::perspective(deg!(60), (2, 1), fx!(1), fx!(10))?;
    /// let mvp = projection * Transform::translate(vec3!(0, 0, -3)) * Transform::rotate_y(deg!(20));
    /// let mut color = [BinaryColor::Off; 24 * 12];
    /// let mut canvas = Canvas::new(&mut color, 24, 12)?;
    /// canvas.draw(BOX.edges(LineStyle::HAIRLINE), &mvp, &Flat::new(BinaryColor::On));
    /// assert!(canvas.pixels().any(|pixel| pixel.is_on()));
    /// # Ok::<(), Error>(())
    /// ```
    #[must_use]
    pub const fn edges<const SMOOTH: bool>(&self, style: LineStyle<SMOOTH>) -> Edges<'_, SMOOTH> {
        let (mesh, outline) = (self, None);
        let of = EdgesOf { mesh, outline };
        Edges { of, style }
    }

    /// The creases and silhouettes from an [`Outline`] of this mesh, except those whose faces are all culled. Draw or
    /// list them like [`edges`](Self::edges).
    ///
    /// Whether a face is front or back is decided as in a draw call of triangles, so the outline of a closed mesh has
    /// no gaps.
    ///
    /// To remove hidden lines, draw the faces first, in the color of the background, and then the outline with the
    /// depth test [`Biased::in_front`](crate::canvas::Biased::in_front). This test moves each line toward the eye, by
    /// more if the faces beside the line are steep.
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
    /// canvas.draw(&CAN, &mvp, &Flat::new(BinaryColor::Off));
    /// let in_front = DrawOptions::new().with_depth_test(Biased::in_front(TestAndWrite));
    /// let rims = CAN.outline(&RIMS, LineStyle::HAIRLINE);
    /// canvas.draw_with(&in_front, rims, &mvp, &Flat::new(BinaryColor::On));
    /// let mut display = MockDisplay::new();
    /// canvas.show(&mut display)?;
    /// display.assert_pattern(&[
    ///     "........................",
    ///     "........................",
    ///     "........................",
    ///     ".....##############.....",
    ///     "...##..............##...",
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
    ///     "......##........##......",
    ///     "........########........",
    ///     "........................",
    /// ]);
    /// # Ok::<(), Error>(())
    /// ```
    #[must_use]
    pub const fn outline<'m, const SMOOTH: bool>(
        &'m self,
        outline: &'m Outline<'m>,
        style: LineStyle<SMOOTH>,
    ) -> Edges<'m, SMOOTH> {
        let of = EdgesOf::outline(self, outline);
        Edges { of, style }
    }
}

/// A line between two points.
#[doc(hidden)]
#[derive(Clone, Copy, Debug)]
pub struct Line<const SMOOTH: bool = false> {
    ends: [Vec3; 2],
    style: LineStyle<SMOOTH>,
}

impl<const SMOOTH: bool> LineStyle<SMOOTH> {
    /// A line in this style between two points of model space; no mesh is needed.
    ///
    /// ```
    /// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::BinaryColor};
    /// use fixel::prelude::*;
    /// use fixel::Window;
    /// let projection = Projection::orthographic(Window::centered(fx!(8), fx!(4)), fx!(-1), fx!(1))?;
    /// let mut color = [BinaryColor::Off; 8 * 4];
    /// let mut canvas = Canvas::new(&mut color, 8, 4)?;
    /// let ray = LineStyle::HAIRLINE.between(vec3!(-4, -2, 0), vec3!(3, 2, 0));
    /// canvas.draw(ray, &projection, &Flat::new(BinaryColor::On));
    /// let mut display = MockDisplay::new();
    /// canvas.show(&mut display)?;
    /// display.assert_pattern(&[
    ///     ".....###",
    ///     "....#...",
    ///     "..##....",
    ///     "##......",
    /// ]);
    /// # Ok::<(), Error>(())
    /// ```
    #[must_use]
    pub const fn between(self, from: Vec3, to: Vec3) -> Line<SMOOTH> {
        Line {
            ends: [from, to],
            style: self,
        }
    }
}

impl<const SMOOTH: bool> Sealed for Line<SMOOTH> {}

impl<C, const SMOOTH: bool> Thing<C> for Line<SMOOTH>
where
    Edges<'static, SMOOTH>: Thing<C>,
{
    type Shading<'c, S: ShaderFor<C>, B: Blending<C>, Z: DepthTest> =
        <Edges<'static, SMOOTH> as Thing<C>>::Shading<'c, S, B, Z>;

    #[inline]
    fn draw<V: AsMvp>(self, mvp: &V, to: Target<'_, impl Shading>) -> Drawn {
        let positions = Positions::long(&self.ends);
        let edges = (&[][..], &[[0, 1]][..]);
        let mesh = Mesh::of_lists(positions, edges, (&[], &[]), (&[], &[]), (&[], &[]));
        mesh.edges(self.style)
            .draw_lines(&Call::new(to.region, &mesh, mvp), to)
    }
}

impl<const SMOOTH: bool> Sealed for Edges<'_, SMOOTH> {}

impl<C> Thing<C> for Edges<'_> {
    type Shading<'c, S: ShaderFor<C>, B: Blending<C>, Z: DepthTest> = Plain<S, B, Z>;

    #[inline]
    fn draw<V: AsMvp>(self, mvp: &V, to: Target<'_, impl Shading>) -> Drawn {
        self.draw_lines(&Call::new(to.region, self.of.mesh, mvp), to)
    }
}

impl<C: PixelFormat> Thing<C> for Edges<'_, true> {
    type Shading<'c, S: ShaderFor<C>, B: Blending<C>, Z: DepthTest> = Smooth<'c, S, B, Z>;

    #[inline]
    fn draw<V: AsMvp>(self, mvp: &V, to: Target<'_, impl Shading>) -> Drawn {
        self.draw_lines(&Call::new(to.region, self.of.mesh, mvp), to)
    }
}

impl<const SMOOTH: bool> Edges<'_, SMOOTH> {
    #[inline]
    fn draw_lines<K: ProjectionKind>(
        self,
        call: &Call<'_, K>,
        to: Target<'_, impl Shading>,
    ) -> Drawn {
        let (Self { of, style }, blitter) = (self, to.blitter);
        style.with_line(to.coverage, |line| {
            // The line is drawn by a direct call, not through a `DrawLine`. So a program that draws only hairlines is
            // smaller.
            if of.outline.is_none() && style.is_hairline() {
                draw(call, of, (raster::line, 0), blitter)
            } else {
                draw(call, of, (line, style.reach()), blitter)
            }
        })
    }
}

/// Draws the chosen edges, each by `line`. A line reaches up to `reach` rows beyond the rows of its ends.
#[inline(never)]
pub(super) fn draw<K: ProjectionKind>(
    call: &Call<'_, K>,
    edges: EdgesOf<'_>,
    (line, reach): (impl Fn(&mut Rasterizer<'_>, [&ClippedVertex; 2]), i32),
    blitter: &mut dyn Blitter,
) -> Drawn {
    let mut raster = call.rasterizer(blitter);
    let count = edges.count();
    let kept = edges.assemble(call, |indices, ends, is_clipped, beside| {
        let [a, b] = ends;
        // Most edges have no pixel in a band. For such edges, no shader is called.
        if raster.meets([a.vertex.screen[1], b.vertex.screen[1]], reach) {
            raster.next_thin(indices, beside, is_clipped);
            line(&mut raster, ends);
        }
    });
    if count == 0 {
        call.placement.lacks_edges();
    }
    let counts = [count as u32, count.wrapping_sub(kept) as u32];
    Drawn::new(counts, &raster, &call.placement)
}

impl<'m> EdgesOf<'m> {
    pub(super) const fn outline(mesh: &'m Mesh<'m>, outline: &'m Outline<'m>) -> Self {
        let outline = Some(outline);
        Self { mesh, outline }
    }

    /// How many edges there are to choose from.
    pub(super) const fn count(self) -> usize {
        match self.outline {
            None => self.mesh.edge_indices().len(),
            Some(outline) => outline.edges().len(),
        }
    }

    /// The edge with this index among the edges to choose from.
    #[inline]
    pub(super) fn indices(self, edge: usize) -> Option<Indices> {
        let [a, b] = match self.outline {
            None => *self.mesh.edge_indices().get(edge)?,
            Some(outline) => {
                let [a, b, ..] = *outline.edges().get(edge)?;
                [a, b]
            }
        };
        Some(Indices::of_edge(edge, [a, b]))
    }

    /// Assembles the chosen edges: all edges of a mesh, or the creases, silhouettes and borders of an outline with at
    /// least one face that is not culled. `each` receives the indices of an edge, the two ends of the part that is
    /// inside all planes, whether the edge was clipped, and how steep the faces beside it are. Returns how many edges
    /// are not culled: the chosen edges, and edges with both faces outside the view.
    #[inline]
    pub(super) fn assemble<K: ProjectionKind>(
        self,
        call: &Call<'_, K>,
        mut each: impl FnMut(Indices, [&ClippedVertex; 2], bool, u16),
    ) -> usize {
        match self.outline {
            _ if call.is_outside() => self.count(),
            None => {
                let mut entries = cache::empty();
                let mut vertices = <VertexCache<'_>>::new(&mut entries, call.slots);
                for (edge, &ends) in self.mesh.edge_indices().iter().enumerate() {
                    let indices = Indices::of_edge(edge, ends);
                    assemble::edge(call, &mut vertices, (indices, 0), &mut each);
                }
                self.count()
            }
            Some(outline) => {
                let mut kept = 0;
                let mut entries = cache::empty::<OUTLINE_SIZE>();
                let mut vertices = VertexCache::new(&mut entries, call.slots);
                for (edge, faces) in outline.edges().iter().enumerate() {
                    let [left, right] = assemble::areas(call, &mut vertices, faces);
                    let is_crease = edge < outline.creases();
                    // Most edges lie between two faces that are turned the same way.
                    let is_inner = (left ^ right) < 0 && left != 0 && right != 0;
                    if is_inner && !is_crease {
                        continue;
                    }
                    let hides = [left, -right].map(|area| call.cull.leaves_out(area));
                    if hides == [true; 2] {
                        // Faces outside the view have no area.
                        kept += usize::from(left == 0 && right == 0);
                        continue;
                    }
                    kept += 1;
                    let beside = if call.screen.is_biased {
                        steepness_beside(call, &mut vertices, *faces, (hides, is_crease))
                    } else {
                        0
                    };
                    let beside = beside & !1 | u16::from(is_inner);
                    let &[a, b, ..] = faces;
                    let indices = Indices::of_edge(edge, [a, b]);
                    assemble::edge(call, &mut vertices, (indices, beside), &mut each);
                }
                kept
            }
        }
    }
}

/// How steep the faces beside an edge of an outline are; a face that is hidden does not count.
#[inline(never)]
fn steepness_beside<K: ProjectionKind>(
    call: &Call<'_, K>,
    vertices: &mut VertexCache<'_, OUTLINE_SIZE>,
    [a, b, c, d]: [Index; 4],
    (hides, is_crease): ([bool; 2], bool),
) -> u16 {
    let mut beside = 0;
    for (face, is_hidden) in [[a, b, c], [b, a, d]].into_iter().zip(hides) {
        if !is_hidden {
            beside = beside.max(assemble::steepness(call, vertices, face, is_crease));
        }
    }
    beside
}
