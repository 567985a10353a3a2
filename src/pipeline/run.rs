//! The stages of a draw call:
//!
//! | | stage | |
//! |---|---|---|
//! | 1 | vertices: projected once, and kept for neighboring triangles | [`VertexCache`], [`Projector`](super::vertex::Projector) |
//! | 2 | rejection of triangles outside of one plane | the outcodes of a [`ScreenVertex`] |
//! | 3 | clipping of triangles that cross a plane | [`clip`](super::clip) |
//! | 4 | culling | [`Cull`](crate::Cull) |
//! | 5 | rows | [`Triangle`], [`Rasterizer`] |
//! | 6 | set-up of interpolants, if a row has pixels | [`Blitter::set_up`] |
//! | 7 | pixels | [`Rows::draw`](crate::raster::Rows::draw) |

use super::Drawn;
use super::cache::{self, VertexCache};
use super::call::Call;
use super::clip::{ClippedPolygon, clip};
use crate::mesh::{Index, Indices, Primitive};
use crate::raster::{self, Blitter, ClippedVertex, Rasterizer, ScreenVertex, Triangle};
use crate::view::ProjectionKind;

/// Draws all triangles of a mesh, in code that exists once for all shaders and canvases.
#[inline(never)]
pub(super) fn draw<K: ProjectionKind>(call: &Call<'_, K>, blitter: &mut dyn Blitter) -> Drawn {
    let mut raster = call.rasterizer(blitter);
    // If the cache were made after the faces are found, Cortex-M0+ would need more registers.
    let mut entries = cache::empty();
    let mut vertices = VertexCache::new(&mut entries, call.slots);
    let faces = call.placement.mesh.faces();
    let culled = draw_faces(call, (0, faces), &mut vertices, &mut raster);
    let counts = [faces.len() as u32, culled];
    Drawn::new(counts, &raster, &call.placement)
}

/// Draws triangles with the caller's cache. `first` is the index of the first triangle. (If [`draw`] had this loop, each
/// triangle would take a call in programs that also draw quads.)
#[inline]
fn draw_faces<K: ProjectionKind>(
    call: &Call<'_, K>,
    (first, faces): (usize, &[[Index; 3]]),
    vertices: &mut VertexCache<'_>,
    raster: &mut Rasterizer<'_>,
) -> u32 {
    let mut culled = 0;
    for (face, corners) in (first..).zip(faces) {
        triangle(call, vertices, corners, |on_screen| {
            let indices = Indices::of_face(face, *corners);
            // 5 to 7. Rows, set-up, pixels.
            match on_screen {
                OnScreen::Whole(corners, area) => raster.draw_whole(indices, corners, area),
                OnScreen::Clipped(outline) => {
                    culled += raster.draw_clipped(indices, outline, call.cull);
                }
                OnScreen::Culled => culled += 1,
                OnScreen::Outside => {}
            }
        });
    }
    culled
}

/// What a triangle is on the screen.
pub(super) enum OnScreen<'v> {
    /// A triangle that is neither clipped nor culled: its corners, and twice its area.
    Whole([&'v ScreenVertex; 3], i64),
    /// What remains of a triangle after clipping. It may be empty or face away.
    Clipped(&'v [ClippedVertex]),
    /// Nothing, because the triangle is culled.
    Culled,
    /// Nothing, because all corners are outside of one plane.
    Outside,
}

/// Runs a triangle through stages 1 to 4, and calls `then` with the result. A triangle that is inside all planes is not
/// clipped.
#[inline]
#[allow(clippy::trivially_copy_pass_by_ref)] // by value, the corners would be loaded before most of them are needed
pub(super) fn triangle<K: ProjectionKind>(
    call: &Call<'_, K>,
    vertices: &mut VertexCache<'_>,
    corners: &[Index; 3],
    mut then: impl FnMut(OnScreen<'_>),
) {
    // 1. Vertices. If two corners share a slot of the cache, they are copied.
    let copies;
    let [a, b, c] = if let Some(vertices) = vertices.corners(&call.projector, *corners) {
        vertices
    } else {
        copies = vertices.copies(&call.projector, *corners);
        let [a, b, c] = &copies;
        [a, b, c]
    };
    // 2. Rejection.
    let outcode = a.outcode | b.outcode | c.outcode;
    if outcode == 0 {
        // 4. Culling. Back faces, half of most meshes, go here, before any attribute is read.
        let area = raster::area(&[a.screen, b.screen, c.screen]);
        // `then` is called in each branch, because the compiler merges calls with different variants badly.
        if call.cull.leaves_out(area) {
            then(OnScreen::Culled);
        } else {
            then(OnScreen::Whole([a, b, c], area));
        }
    } else if a.outcode & b.outcode & c.outcode == 0 {
        // 3. Clipping. `then` culls the result, because its area is only known when the fan is made.
        let mut outline = ClippedPolygon::new();
        clip(&call.projector, corners, outcode, &mut outline);
        then(OnScreen::Clipped(&outline));
    } else {
        then(OnScreen::Outside);
    }
}

/// Whether one plane goes through the varyings of both triangles of a rectangle.
pub(super) type IsPlane<'p> = &'p dyn Fn([&Primitive<'_>; 2]) -> bool;

/// Draws quads: the triangles of a mesh in pairs. `first` is the index of the first triangle. The cache must hold no
/// vertices of other meshes. If quads are upright rectangles on the screen, each at one depth, `is_plane` tells which
/// quads to draw as one primitive.
#[inline(never)]
pub(super) fn quads<K: ProjectionKind>(
    call: &Call<'_, K>,
    first: usize,
    vertices: &mut VertexCache<'_>,
    is_plane: Option<IsPlane<'_>>,
    blitter: &mut dyn Blitter,
) -> Drawn {
    let mut raster = call.rasterizer(blitter);
    let faces = call.placement.mesh.faces();
    let pairs = faces.chunks_exact(2);
    for (at, pair) in (first..).step_by(2).zip(pairs) {
        let is_done =
            is_plane.is_some_and(|is_plane| rectangle(call, (at, pair), is_plane, &mut raster));
        if !is_done {
            draw_faces(call, (at, pair), vertices, &mut raster);
        }
    }
    let counts = [faces.len() as u32, 0]; // sprites are not culled
    Drawn::new(counts, &raster, &call.placement)
}

/// Fast path for two triangles that form an axis-aligned rectangle at one depth. The rectangle reaches from the first
/// corner of the first triangle to the last corner of the second. Returns false if the rectangle must be drawn as two
/// triangles.
#[inline]
fn rectangle<K: ProjectionKind>(
    call: &Call<'_, K>,
    (first, faces): (usize, &[[Index; 3]]),
    is_plane: IsPlane<'_>,
    raster: &mut Rasterizer<'_>,
) -> bool {
    let &[one, other] = faces else {
        return false;
    };
    let ([a, ..], [.., d]) = (one, other);
    let [mut from, mut to] = [ScreenVertex::UNSET; 2];
    call.projector.project(a, None, &mut from);
    call.projector.project(d, None, &mut to);
    if from.outcode | to.outcode != 0 {
        // Either the rectangle is outside of one plane and done, or its triangles must be clipped.
        return from.outcode & to.outcode != 0;
    }
    // Each of the other two corners has x from one of these corners and y from the other.
    let ([left, bottom], [right, top]) = (from.screen, to.screen);
    let corner = |screen| ScreenVertex { screen, ..from };
    let (b, c) = (corner([right, bottom]), corner([left, top]));
    let area = raster::area(&[from.screen, b.screen, c.screen]);
    let Some(half) = &Triangle::new([&from, &b, &c], None, area, &call.scissor) else {
        return true;
    };
    let one = Indices::of_face(first, one);
    let other = Indices::of_face(first + 1, other);
    let placement = &call.placement;
    let is_plane = is_plane([
        &placement.primitive(one, area),
        &placement.primitive(other, area),
    ]);
    if is_plane {
        raster.draw_rectangle(one, half);
    }
    is_plane
}
