//! Triangles prepared once for all bands of a frame.

use core::ops::Range;

use embedded_graphics::geometry::Size;
use heapless::{Vec, VecView};

use super::{Needed, PreparedCall, Slot, VertexWriter, painter, vertex};
use crate::Error;
use crate::canvas::{DepthTest, Replace, TestAndWrite, check_size};
use crate::mesh::{Indices, Mesh};
use crate::pipeline::assemble::Assembly;
use crate::pipeline::call::Call;
use crate::pipeline::clip::ClippedPolygon;
use crate::pipeline::options::PixelOptions;
use crate::pipeline::run::{self, Draw};
use crate::pipeline::{DrawOptions, Drawn};
use crate::raster::{self, Blitter, ClippedVertex, Cull, Polygon, Scissor, ScreenVertex, Triangle};
use crate::span::{Mode, Newton};
use crate::view::{AsMvp, Perspective, ProjectionKind};

/// Memory for the triangles of a frame that is drawn in bands.
///
/// The triangles are transformed, culled and clipped once, and every band draws them from here.
/// [`prepare`](Self::prepare) takes one mesh and [`prepare_scene`](Self::prepare_scene) several objects. Sorted
/// [back to front](Self::prepare_back_to_front), a list replaces the depth buffer.
///
/// To sort whole objects instead, for example glass that is drawn last, sort them by the depths of their origins:
///
/// ```
/// use fixel::prelude::*;
/// let view = Projection::perspective(deg!(60), (4, 3), fx!(1), fx!(50))?
///     * Camera::look_at(vec3!(0, 1, 9), Vec3::ZERO, Vec3::Y)?;
/// let [near, far] = [5, -5].map(|z| Transform::translate(Vec3::from_ints(0, 0, z)));
/// let mut panes = [near, far];
/// // In eye space, z falls with the distance.
/// panes.sort_unstable_by_key(|&model| (view * model).model_view().point(Vec3::ZERO).z);
/// assert_eq!(panes, [far, near]);
/// # Ok::<(), Error>(())
/// ```
///
/// # Which camera, which frame
///
/// A prepared mesh or scene keeps its camera, projection, transforms and options. Drawing takes none of these, so a
/// list cannot be drawn with others. It refuses a canvas of another frame size. As long as the prepared mesh or scene
/// is in use, the list, and the objects of the scene, cannot change:
///
/// ```compile_fail,E0506
/// use fixel::{Object, prelude::*};
/// static BALL: Mesh = shape!(sphere(12, 8));
/// fn scene(view: &Mvp, list: &mut TriangleList<100, 80>) -> Result<(), Error> {
///     let mut objects = [Object::new(&BALL, Transform::IDENTITY, 1)];
///     let scene = list.prepare_scene(&DrawOptions::new(), (16, 12), view, &mut objects)?;
///     objects[0].model = Transform::rotate_y(deg!(30)); // error: borrowed by the scene
///     drop(scene);
///     Ok(())
/// }
/// ```
///
/// One mistake remains possible: to draw an earlier frame's list in a frame whose other draw calls have a new camera.
/// So prepare the list in each frame, after the camera has moved.
///
/// Without a list, each band transforms the whole mesh again. For a mesh of many small triangles, this takes longer
/// than drawing them.
///
/// The list needs room for the visible triangles (16 bytes each) and for their vertices (16 bytes each). A closed mesh
/// in which neighboring triangles follow each other needs about half as many vertices as triangles. Other meshes need
/// at most three vertices for each triangle, and up to 18 for each clipped one. If there is too little room,
/// [`prepare`](Self::prepare) returns how much is needed.
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::{Gray4, GrayColor}};
/// use fixel::prelude::*;
///
/// static BALL: Mesh = shape!(sphere(12, 8));
/// const WIDTH: u32 = 16;
/// const HEIGHT: u32 = 12;
/// const ROWS: u32 = 4;
///
/// let projection = Projection::perspective(deg!(60), (WIDTH, HEIGHT), fx!(1), fx!(10))?;
/// let mvp = projection * Transform::translate(vec3!(0, 0, -2.5));
/// let sun = Light::new(vec3!(1, 2, 3), fx!(0), fx!(1))?;
/// let white = Flat::rgb(Gray4::WHITE).lit(sun);
///
/// let mut list: TriangleList<100, 80> = TriangleList::new(); // on a microcontroller, a static
/// let ball = list.prepare(&DrawOptions::new(), (WIDTH, HEIGHT), &BALL, &mvp)?;
///
/// let mut display = MockDisplay::new();
/// let mut color = [Gray4::BLACK; (WIDTH * ROWS) as usize];
/// for first_row in (0..HEIGHT).step_by(ROWS as usize) {
///     let mut band = Canvas::band(&mut color, WIDTH, HEIGHT, first_row)?;
///     band.clear(Gray4::BLACK);
///     band.draw_prepared(&ball, &white)?; // nothing is transformed here
///     band.show(&mut display)?;
/// }
///
/// // The same picture, drawn at once.
/// let mut color = [Gray4::BLACK; (WIDTH * HEIGHT) as usize];
/// let mut frame = Canvas::new(&mut color, WIDTH, HEIGHT)?;
/// frame.draw(&BALL, &mvp, &white);
/// let mut whole = MockDisplay::new();
/// frame.show(&mut whole)?;
/// display.assert_eq(&whole);
///
/// let mut short: TriangleList<20, 80> = TriangleList::new();
/// let error = short.prepare(&DrawOptions::new(), (WIDTH, HEIGHT), &BALL, &mvp).unwrap_err();
/// assert_eq!(
///     error.to_string(),
///     "44 triangles are visible: the list must have room for all, and has room for 20",
/// );
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct TriangleList<const TRIANGLES: usize, const VERTICES: usize> {
    pub(super) triangles: Vec<Entry, TRIANGLES>,
    pub(super) vertices: Vec<Slot, VERTICES>,
}

/// A visible triangle.
#[derive(Clone, Copy, Debug)]
pub(super) struct Entry {
    /// Its index among the mesh's faces.
    pub(super) face: u32,
    /// The rows of the frame in which it may have pixels: the first, and the one after the last.
    pub(super) rows: [u16; 2],
    pub(super) corners: Corners,
}

/// The numbers of a triangle's corners in the list of vertices, counted from 1.
#[derive(Clone, Copy, Debug)]
pub(super) enum Corners {
    /// A triangle that is inside all planes: its three vertices.
    Whole([u16; 3]),
    /// A clipped triangle: `count` corners from `first` on, each a vertex and its barycentric weights.
    Clipped { first: u16, count: u16 },
}

/// A mesh's triangles, ready to be drawn to every band of a frame.
///
/// [`TriangleList::prepare`] returns it, and [`Canvas::draw_prepared`](crate::Canvas::draw_prepared) draws it.
///
/// It can be shared with another core that draws other bands of the same frame.
///
/// ```
/// use fixel::{Prepared, prelude::*};
/// fn is_shared<T: Sync>() {}
/// is_shared::<Prepared<'static>>();
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Prepared<'a, K = Perspective, M = Newton, Z = TestAndWrite, B = Replace> {
    pub(in crate::pipeline) call: PreparedCall<'a, K>,
    pub(super) triangles: &'a [Entry],
    pub(super) vertices: &'a [Slot],
    /// The rows of the frame in which any triangle may have pixels.
    pub(super) rows: [u16; 2],
    pub(in crate::pipeline) pixels: PixelOptions<M, Z, B>,
}

impl<const TRIANGLES: usize, const VERTICES: usize> Default for TriangleList<TRIANGLES, VERTICES> {
    fn default() -> Self {
        Self::new()
    }
}

impl<const TRIANGLES: usize, const VERTICES: usize> TriangleList<TRIANGLES, VERTICES> {
    /// The most vertices that a list can use, however long it is: 16-bit numbers count them from 1.
    pub const MAX_VERTICES: usize = u16::MAX as usize;

    /// An empty list.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            triangles: Vec::new(),
            vertices: Vec::new(),
        }
    }

    /// Transforms, culls and clips a mesh's triangles for a `frame` of this many columns and rows, as
    /// [`Canvas::draw_with`](crate::Canvas::draw_with) would for each of its bands. The previous contents of the list
    /// are dropped.
    ///
    /// # Errors
    ///
    /// [`Error::Full`], with the length that is needed, if the list is too short for the visible triangles;
    /// [`Error::Size`] if a side of the frame is 0 or above [`MAX_SIZE`](crate::canvas::MAX_SIZE).
    pub fn prepare<'a, M: Mode, Z: DepthTest, B: Copy, V: AsMvp>(
        &'a mut self,
        options: &DrawOptions<M, Z, B>,
        frame: impl Into<Size>,
        mesh: &'a Mesh<'a>,
        mvp: &V,
    ) -> Result<Prepared<'a, V::Kind, M, Z, B>, Error> {
        self.prepare_in_order::<false, _, _, _, _>(options, frame.into(), mesh, mvp)
    }

    /// Prepares a mesh's triangles like [`prepare`](Self::prepare), and sorts them back to front, which is called
    /// painter's order. A canvas without a depth buffer then shows nearer triangles over farther ones.
    ///
    /// Triangles are compared by the farthest corners of their visible parts, with a precision of 2⁻²⁵ of the distance.
    /// Equally far triangles keep the order of the mesh. The method is heap sort, which needs no further memory, and at
    /// most 2 n log₂ n comparisons for n visible triangles.
    ///
    /// The table compares the list with a depth buffer of 320x240, which takes 150 KiB. Figures are means of eight
    /// poses, printed by `kernels painter`; the instructions are those of x86-64, counted by
    /// `valgrind --tool=callgrind --toggle-collect='*only_drawing*'`:
    ///
    /// | scene | wrong pixels | list | millions of instructions with depth | sorted |
    /// |---|--:|--:|--:|--:|
    /// | sphere | 0 | 17.1 KiB | 2.23 | 2.62 |
    /// | two rings around a cube | 0 | 13.9 KiB | 1.55 | 1.87 |
    /// | 27 towers, after the floor | 0 | 5.0 KiB | 2.88 | 1.16 |
    /// | island with a lighthouse | 0.40 % | 19.1 KiB | 5.14 | 5.73 |
    /// | the same in a sea, which crosses the island | 6.95 % | 21.6 KiB | 9.37 | 10.1 |
    ///
    /// Sorting takes time for each triangle, and hidden pixels are drawn, too. But no pixel's depth is tested and
    /// stored, which is most of the cost of a pixel of one color, such as the towers'.
    ///
    /// No order is right for triangles that cross each other, or that cover each other in a circle. A large triangle
    /// may cover a small one in front of it if the small one's farthest corner is farther away. So draw a floor, or a
    /// sky, in a call of its own before the others, or make its triangles as small as those of the objects on it.
    ///
    /// ```
    /// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::{Gray4, GrayColor}};
    /// use fixel::prelude::*;
    ///
    /// // The first triangle is in front of the second.
    /// let positions = [
    ///     vec3!(-1, -1, 1), vec3!(1, -1, 1), vec3!(-1, 1, 1),
    ///     vec3!(-1, -1, 0), vec3!(1, -1, 0), vec3!(1, 1, 0),
    /// ];
    /// let mesh = Mesh::new(&positions, &[[0, 1, 2], [3, 4, 5]])?;
    /// let projection = Projection::perspective(deg!(60), (1, 1), fx!(1), fx!(10))?;
    /// let mvp = projection * Transform::translate(vec3!(0, 0, -3));
    /// let colors = [Gray4::new(1), Gray4::new(2)];
    /// let options: DrawOptions = DrawOptions::new();
    ///
    /// let mut list: TriangleList<2, 6> = TriangleList::new();
    /// let mut picture = |is_sorted: bool| {
    ///     let triangles = if is_sorted {
    ///         list.prepare_back_to_front(&options, (10, 10), &mesh, &mvp)?
    ///     } else {
    ///         list.prepare(&options, (10, 10), &mesh, &mvp)?
    ///     };
    ///     let mut color = [Gray4::BLACK; 100];
    ///     let mut canvas = Canvas::new(&mut color, 10, 10)?;
    ///     canvas.draw_prepared(&triangles, &FaceColors::new(&colors))?;
    ///     let mut display = MockDisplay::new();
    ///     canvas.show(&mut display)?;
    ///     Ok::<_, Error>(display)
    /// };
    /// picture(false)?.assert_pattern(&[
    ///     "0000000000",
    ///     "0000000000",
    ///     "0100000200",
    ///     "0110002200",
    ///     "0111022200",
    ///     "0111222200",
    ///     "0112222200",
    ///     "0122222200",
    ///     "0111111100",
    ///     "0000000000",
    /// ]);
    /// picture(true)?.assert_pattern(&[
    ///     "0000000000",
    ///     "0000000000",
    ///     "0100000200",
    ///     "0110002200",
    ///     "0111022200",
    ///     "0111122200",
    ///     "0111112200",
    ///     "0111111200",
    ///     "0111111100",
    ///     "0000000000",
    /// ]);
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// As for [`prepare`](Self::prepare).
    pub fn prepare_back_to_front<'a, M: Mode, Z: DepthTest, B: Copy, V: AsMvp>(
        &'a mut self,
        options: &DrawOptions<M, Z, B>,
        frame: impl Into<Size>,
        mesh: &'a Mesh<'a>,
        mvp: &V,
    ) -> Result<Prepared<'a, V::Kind, M, Z, B>, Error> {
        self.prepare_in_order::<true, _, _, _, _>(options, frame.into(), mesh, mvp)
    }

    /// Prepares a mesh's triangles, in the order of the mesh or back to front.
    #[inline]
    fn prepare_in_order<'a, const SORTED: bool, M: Mode, Z: DepthTest, B: Copy, V: AsMvp>(
        &'a mut self,
        options: &DrawOptions<M, Z, B>,
        frame: Size,
        mesh: &'a Mesh<'a>,
        mvp: &V,
    ) -> Result<Prepared<'a, V::Kind, M, Z, B>, Error> {
        check_size(frame.width, frame.height)?;
        let screen = options.screen(frame);
        let call = Call::new(&screen, &(0..frame.height), mesh, mvp);
        self.triangles.clear();
        self.vertices.clear();
        let mut needed = Needed::default();
        let lists = (self.triangles.as_mut_view(), self.vertices.as_mut_view());
        let rows = fill(lists, &call, &mut needed);
        needed.check::<TRIANGLES, VERTICES>("triangles")?;
        let (list, shift) = (&mut self.triangles, call.projector.depth_shift());
        if SORTED {
            painter::sort(list, &self.vertices, shift, &call.shared.scissor.rows);
        }
        Ok(Prepared {
            call: PreparedCall::new(screen, mesh, mvp, shift),
            triangles: &self.triangles,
            vertices: &self.vertices,
            rows,
            pixels: options.pixels,
        })
    }
}

/// A list that is being filled. Once it is full, it only counts.
struct Filling<'l> {
    triangles: &'l mut VecView<Entry>,
    needed: usize,
    vertices: VertexWriter<'l>,
    /// The rows of all triangles.
    rows: [u16; 2],
    cull: Cull,
    scissor: &'l Scissor,
}

/// Prepares the triangles of one mesh, and adds to what the lists need. Returns the rows of the frame in which any of
/// them may have pixels.
#[inline]
pub(super) fn fill<K: ProjectionKind>(
    (triangles, vertices): (&mut VecView<Entry>, &mut VecView<Slot>),
    call: &Call<'_, K>,
    needed: &mut Needed,
) -> [u16; 2] {
    let mut filling = Filling {
        triangles,
        needed: needed.elements,
        vertices: VertexWriter::new(vertices, needed.vertices),
        rows: [u16::MAX, 0],
        cull: call.shared.cull,
        scissor: &call.shared.scissor,
    };
    run::triangles(call, &mut filling);
    (needed.elements, needed.vertices) = (filling.needed, filling.vertices.needed);
    filling.rows
}

impl Filling<'_> {
    fn add_triangle(&mut self, indices: Indices, rows: &Range<i32>, corners: Corners) {
        // Rows of a frame are 0 to 2048.
        let row = |row: i32| {
            let inside = row.max(self.scissor.rows.start).min(self.scissor.rows.end);
            inside.cast_unsigned() as u16
        };
        let rows = [row(rows.start), row(rows.end)];
        let [start, end] = self.rows;
        self.rows = [start.min(rows[0]), end.max(rows[1])];
        self.needed += 1;
        // If there is no room, the list will not be used.
        let _ = self.triangles.push(Entry {
            face: indices.face.unwrap_or_default() as u32,
            rows,
            corners,
        });
    }
}

impl Assembly for Filling<'_> {
    fn whole(&mut self, indices: Indices, corners: [&ScreenVertex; 3], area: i64) {
        if let Some(triangle) = &Triangle::new(corners, None, area, self.scissor) {
            let numbers = corners.map(|corner| self.vertices.number(corner));
            self.add_triangle(indices, &triangle.rows, Corners::Whole(numbers));
        }
    }

    fn clipped(&mut self, indices: Indices, polygon: &[ClippedVertex]) {
        let part = Polygon::new(polygon, self.cull);
        let Some(rows) = part.and_then(|part| part.rows(self.scissor)) else {
            return;
        };
        let first = (self.vertices.needed as u16).wrapping_add(1);
        for corner in polygon {
            self.vertices.add_clipped(corner);
        }
        let corners = Corners::Clipped {
            first,
            // At most nine.
            count: polygon.len() as u16,
        };
        self.add_triangle(indices, &rows, corners);
    }
}

impl<'a, K, M, Z, B> Prepared<'a, K, M, Z, B> {
    /// The same triangles, with another way to blend their colors with those on the canvas: for a sorted scene in which
    /// some objects are translucent.
    ///
    /// ```
    /// use fixel::{prelude::*, canvas::Opacity};
    /// static BOX: Mesh = shape!(cuboid(vec3!(1, 1, 1)));
    /// let projection = Projection::perspective(deg!(60), (2, 1), fx!(1), fx!(10))?;
    /// let mvp = projection * Transform::translate(vec3!(0, 0, -3));
    /// let mut list: TriangleList<12, 24> = TriangleList::new();
    /// let opaque = list.prepare(&DrawOptions::new(), (24, 12), &BOX, &mvp)?;
    /// assert_eq!(opaque.with_blending(Opacity(90)).blending(), Opacity(90));
    /// # Ok::<(), Error>(())
    /// ```
    #[must_use]
    pub fn with_blending<A>(self, blending: A) -> Prepared<'a, K, M, Z, A> {
        Prepared {
            call: self.call,
            triangles: self.triangles,
            vertices: self.vertices,
            rows: self.rows,
            pixels: PixelOptions {
                mode: self.pixels.mode,
                depth: self.pixels.depth,
                blending,
            },
        }
    }

    /// Returns how colors are blended with those on the canvas.
    #[must_use]
    pub const fn blending(&self) -> B
    where
        B: Copy,
    {
        self.pixels.blending
    }
}

impl<K: ProjectionKind, M, Z, B> Prepared<'_, K, M, Z, B> {
    /// Draws the triangles that meet `rows`, a band of the frame.
    #[inline(never)]
    pub(in crate::pipeline) fn draw(&self, rows: &Range<u32>, blitter: &mut dyn Blitter) -> Drawn {
        let shared = self.call.shared(rows);
        let (mut draw, rows) = (Draw::new(blitter, &shared), &shared.scissor.rows);
        let misses = |[start, end]: [u16; 2]| {
            i32::from(start).max(rows.start) >= i32::from(end).min(rows.end)
        };
        // A band that the mesh misses costs one test.
        let triangles = if misses(self.rows) {
            &[]
        } else {
            self.triangles
        };
        for entry in triangles {
            if misses(entry.rows) {
                continue;
            }
            let face = entry.face as usize;
            let Some(&indices) = self.call.mesh.faces().get(face) else {
                continue;
            };
            let indices = Indices::of_face(face, indices);
            match entry.corners {
                Corners::Whole([a, b, c]) => {
                    let vertex = |number| vertex(self.vertices, number);
                    let corners = (vertex(a), vertex(b), vertex(c));
                    if let (Some(a), Some(b), Some(c)) = corners {
                        let corners = [&a, &b, &c];
                        let area = raster::area(&ScreenVertex::screens(corners));
                        draw.whole(indices, corners, area);
                    }
                }
                Corners::Clipped { first, count } => {
                    draw.clipped(indices, &self.polygon(first, count));
                }
            }
        }
        draw.drawn()
    }

    fn polygon(&self, first: u16, count: u16) -> ClippedPolygon {
        let start = usize::from(first).wrapping_sub(1);
        let slots = self
            .vertices
            .get(start..start.wrapping_add(usize::from(2 * count)));
        let mut polygon = ClippedPolygon::new();
        for pair in slots.unwrap_or_default().chunks_exact(2) {
            if let [vertex, Slot::Barycentric(barycentric)] = *pair
                && let Some(vertex) = vertex.vertex()
            {
                // At most as many as were clipped.
                let _ = polygon.push(ClippedVertex {
                    vertex,
                    barycentric,
                });
            }
        }
        polygon
    }
}
