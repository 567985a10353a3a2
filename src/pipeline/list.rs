//! Lists: triangles or edges that are prepared once for all bands of a frame.
//!
//! [`DrawList`] is the memory, and this file fills it. [`prepared`] draws from it, and [`painter`] sorts it from back
//! to front.

#![allow(private_interfaces)] // of traits that only this crate calls

mod faces_or_edges;
mod painter;
mod prepared;
mod shades;

pub use faces_or_edges::FacesOrEdges;
pub use prepared::{Object, Prepared};
pub use shades::ShadeList;

use core::cell::Cell;
use core::marker::PhantomData;

use embedded_graphics::geometry::Size;
use heapless::{Vec, VecView};

use super::Drawn;
use super::cache::{self, VertexCache};
use super::call::{Call, Screen};
use super::edges::Edges;
use super::options::DrawOptions;
use super::run::{self, OnScreen};
use crate::canvas::{DepthTest, check_size};
use crate::error::Error;
use crate::mesh::{Index, Indices, Mesh};
use crate::raster::{
    Blitter, ClippedVertex, Coverage, Cull, DepthShift, Polygon, Scissor, ScreenVertex, Triangle,
    first_center,
};
use crate::sealed::Sealed;
use crate::span::Mode;
use crate::view::{AsMvp, ProjectionKind};
use prepared::{Objects, Placed, Run};

/// Memory for the triangles or edges of a frame that is drawn in bands.
///
/// The triangles or edges are transformed, culled and clipped once, and every band draws them from the list.
/// [`prepare`](Self::prepare) takes a mesh, edges, or several [`Object`]s. A list that is sorted [back to
/// front](Self::prepare_back_to_front) replaces the depth buffer.
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
/// The list keeps the camera, the projection, the transforms and the options. You do not state them again when you draw
/// the list, so you cannot draw it with a wrong camera. (A canvas of another frame size is an error.) While you draw,
/// neither the list nor its objects can change; [`Prepared::objects`] reads them:
///
/// ```compile_fail,E0506
/// use fixel::prelude::*;
/// static BALL: Mesh = shape!(sphere(12, 8));
/// fn scene(view: &Mvp, list: &mut DrawList<100, 80>) -> Result<(), Error> {
///     let mut objects = [Object::new(&BALL, Transform::IDENTITY, 1)];
///     let scene = list.prepare(&DrawOptions::new(), (16, 12), &mut objects, view)?;
///     objects[0].model = Transform::rotate_y(deg!(30)); // error: borrowed by the scene
///     drop(scene);
///     Ok(())
/// }
/// ```
///
/// One mistake remains possible: you can draw a list that you prepared with the camera of an earlier frame. So prepare
/// the list in each frame, after the camera has moved.
///
/// The list keeps no colors. Add a [`ShadeList`] to keep light, and whatever else a shader computes at the corners, for
/// all bands.
///
/// Without a list, each band transforms the whole mesh again. For a mesh of many small triangles, this takes longer
/// than drawing the triangles.
///
/// # Memory
///
/// The list needs room for the visible triangles or edges (16 bytes each) and for their vertices (16 bytes each). A
/// closed mesh that lists neighboring triangles one after the other needs about half as many vertices as triangles. In
/// other meshes, a triangle needs at most three vertices. A clipped triangle needs up to 18 vertices in any mesh. An
/// edge needs at most two vertices, or four if it is clipped. If there is too little room, [`prepare`](Self::prepare)
/// returns how much is needed.
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
/// let mut list: DrawList<100, 80> = DrawList::new(); // on a microcontroller, a static
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
/// let mut short: DrawList<20, 80> = DrawList::new();
/// let error = short.prepare(&DrawOptions::new(), (WIDTH, HEIGHT), &BALL, &mvp).unwrap_err();
/// assert_eq!(
///     error.to_string(),
///     "44 triangles are visible: the list must have room for all, and has room for 20",
/// );
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct DrawList<const ELEMENTS: usize, const VERTICES: usize> {
    entries: Vec<Entry, ELEMENTS>,
    vertices: Vec<ScreenVertex, VERTICES>,
}

/// A visible triangle or edge.
#[derive(Clone, Copy, Debug)]
pub(super) struct Entry {
    /// The element's index, counted through the triangles or edges of all objects.
    element: u32,
    /// See [`rows`](Self::rows). While a list is sorted, the element's nearness takes the place of its rows, so that an
    /// entry needs no more memory.
    rows_or_nearness: [i16; 2],
    corners: Corners,
}

impl Entry {
    /// The rows in which the element may have pixels: the first row, and the row after the last. They may be above or
    /// below the frame, and take 14 bits and a sign.
    #[inline]
    const fn rows(&self) -> [i16; 2] {
        self.rows_or_nearness
    }
}

/// The numbers of an element's corners in the list of vertices, counted from 1.
#[derive(Clone, Copy, Debug)]
enum Corners {
    /// The vertices of a triangle that is inside all planes.
    Whole([u16; 3]),
    /// The vertices of an edge that is inside all planes, and how steep the faces beside the edge are, as in
    /// [`Primitive::area`](crate::mesh::Primitive).
    Edge { ends: [u16; 2], beside: u16 },
    /// A clipped triangle or edge: `count` corners, starting with vertex `first`. Each corner takes two vertices; the
    /// second vertex holds the corner's barycentric weights in its `screen`. For an edge, `beside` is how steep the
    /// faces beside it are.
    Clipped { first: u16, count: u16, beside: u16 },
}

impl<const ELEMENTS: usize, const VERTICES: usize> DrawList<ELEMENTS, VERTICES> {
    /// The largest number of vertices that a list can hold: 65,535, because a list numbers its vertices with 16 bits,
    /// from 1.
    pub const MAX_VERTICES: usize = u16::MAX as usize;

    /// An empty list.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            entries: Vec::new(),
            vertices: Vec::new(),
        }
    }

    /// Transforms, culls and clips `thing`, and keeps the visible triangles or edges in this list. `frame` is the
    /// number of columns and rows of the frame. Without a list, [`Canvas::draw_with`](crate::Canvas::draw_with) does
    /// this work again in each band. The previous contents of the list are dropped.
    ///
    /// `thing` is a mesh, [`mesh.edges(style)`](Mesh::edges) or [`mesh.outline(&outline, style)`](Mesh::outline), or a
    /// mutable borrow of a slice of [`Object`]s. `view` is a projection times a camera; all objects share it.
    ///
    /// ```
    /// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::{Gray4, GrayColor}};
    /// use fixel::prelude::*;
    ///
    /// static BALL: Mesh = shape!(sphere(12, 8));
    /// static SILHOUETTE: Outline = outline!(BALL, deg!(60));
    /// static BOX: Mesh = shape!(cuboid(vec3!(1, 1, 1)));
    /// const SIZE: (u32, u32) = (24, 12);
    ///
    /// let view = Projection::perspective(deg!(50), SIZE, fx!(1), fx!(20))?
    ///     * Camera::look_at(vec3!(0, 1, 5), Vec3::ZERO, Vec3::Y)?;
    /// let [left, right] = [vec3!(-1.4, 0, 0), vec3!(0.8, 0, 0)].map(Transform::translate);
    /// let flat = |gray| Flat::new(Gray4::new(gray));
    /// let (ball, cube) = (BALL.outline(&SILHOUETTE, LineStyle::HAIRLINE), BOX.edges(LineStyle::HAIRLINE));
    /// let mut objects = [Object::new(ball, left, flat(3)), Object::new(cube, right, flat(7))];
    /// let mut list: DrawList<100, 100> = DrawList::new(); // on a microcontroller, a static
    /// let scene = list.prepare(&DrawOptions::new(), SIZE, &mut objects, &view)?;
    ///
    /// let mut display = MockDisplay::new();
    /// let mut color = [Gray4::BLACK; 24 * 4];
    /// for first_row in [0, 4, 8] {
    ///     let mut band = Canvas::band(&mut color, 24, 12, first_row)?;
    ///     band.clear(Gray4::BLACK);
    ///     for (shader, edges) in scene.parts(&band)? {
    ///         band.draw_prepared(&edges, shader)?;
    ///     }
    ///     band.show(&mut display)?;
    /// }
    /// display.assert_pattern(&[
    ///     "000000000000000000000000",
    ///     "000000000000000000000000",
    ///     "000000000000000000000000",
    ///     "000000033307777777000000",
    ///     "000000300037000707000000",
    ///     "000003000037000707000000",
    ///     "000003000037000707000000",
    ///     "000000300037777707000000",
    ///     "000000333307000077000000",
    ///     "000000000007777777000000",
    ///     "000000000000000000000000",
    ///     "000000000000000000000000",
    /// ]);
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`Error::Full`], with the length that is needed, if the list is too short for the visible triangles or edges;
    /// [`Error::Count`] if a side of the frame is 0 or above [`MAX_SIZE`](crate::Canvas::MAX_SIZE).
    #[allow(clippy::type_complexity)] // all of its parts are in the result
    pub fn prepare<'a, S: Scene<'a>, V: AsMvp, M: Mode, Z: DepthTest, B: Copy>(
        &'a mut self,
        options: &DrawOptions<M, Z, B>,
        frame: impl Into<Size>,
        thing: S,
        view: &V,
    ) -> Result<Prepared<'a, S::Material, S::Thing, DrawOptions<M, Z, B>, V::Kind>, Error> {
        self.fill((*options, frame.into()), thing, view, |_, _, _| ())
    }

    /// Prepares triangles or edges like [`prepare`](Self::prepare), and sorts them back to front, which is called
    /// painter's order. A canvas without a depth buffer then shows nearer triangles over farther ones.
    ///
    /// The sort key of a triangle is the distance of the farthest corner of its visible part, to a precision of 2⁻²⁵ of
    /// this distance. Triangles that are equally far away keep their order: in a mesh, the order of its faces or edges;
    /// between objects, the order of the slice. The method is heap sort: it needs no further memory, and makes at most
    /// 2 n log₂ n comparisons for n visible triangles.
    ///
    /// The table compares a sorted list with a depth buffer of 320x240 pixels, which takes 150 KiB. The numbers are
    /// means over eight poses of each scene, as the project's program `kernels painter` prints them. The instructions
    /// are x86-64 instructions, counted by `valgrind --tool=callgrind --toggle-collect='*only_drawing*'`:
    ///
    /// <!-- figures: painter -->
    /// | scene | wrong pixels | list | millions of instructions with depth | sorted |
    /// |---|--:|--:|--:|--:|
    /// | sphere | 0 | 17.1 KiB | 2.07 | 2.31 |
    /// | two rings around a cube | 0 | 13.9 KiB | 1.25 | 1.55 |
    /// | 27 towers, after the floor | 0 | 4.2 KiB | 2.56 | 0.87 |
    /// | island with a lighthouse | 0.40 % | 19.1 KiB | 4.03 | 4.52 |
    /// | the same in a sea, which crosses the island | 6.95 % | 21.6 KiB | 7.66 | 8.23 |
    /// <!-- end -->
    ///
    /// A sorted list takes time to sort its triangles, and to draw pixels that nearer triangles then cover. It saves
    /// the time to test and store depths. This saving is large if a surface has one color, as in the scene of the
    /// towers, because depths are then most of a pixel's cost.
    ///
    /// No order is right for triangles that cross each other, or for three triangles of which each covers a part of the
    /// next (A covers B, B covers C, C covers A). A large triangle may cover a small one in front of it if the small
    /// one's farthest corner is farther away. So draw a floor or a sky in a separate call before the other objects, or
    /// make its triangles as small as the triangles of the objects on it.
    ///
    /// ```
    /// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::{Gray4, GrayColor}};
    /// use fixel::prelude::*;
    ///
    /// static BALL: Mesh = shape!(sphere(12, 8));
    /// static BOX: Mesh = shape!(cuboid(vec3!(1, 1, 1)));
    /// const SIZE: (u32, u32) = (24, 12);
    ///
    /// let view = Projection::perspective(deg!(50), SIZE, fx!(1), fx!(20))?
    ///     * Camera::look_at(vec3!(0, 1, 5), Vec3::ZERO, Vec3::Y)?;
    /// let flat = |gray| Flat::new(Gray4::new(gray));
    /// let mut objects = [
    ///     Object::new(&BALL, Transform::translate(vec3!(-0.4, 0, 0)), flat(3)),
    ///     Object::new(&BOX, Transform::translate(vec3!(0.8, 0, -1.5)), flat(7)),
    /// ];
    /// let mut list: DrawList<100, 100> = DrawList::new(); // on a microcontroller, a static
    /// let scene = list.prepare_back_to_front(&DrawOptions::new(), SIZE, &mut objects, &view)?;
    ///
    /// let mut display = MockDisplay::new();
    /// let mut color = [Gray4::BLACK; 24 * 4];
    /// for first_row in [0, 4, 8] {
    ///     let mut band = Canvas::band(&mut color, 24, 12, first_row)?;
    ///     band.clear(Gray4::BLACK);
    ///     for (shader, triangles) in scene.parts(&band)? {
    ///         band.draw_prepared(&triangles, shader)?;
    ///     }
    ///     band.show(&mut display)?;
    /// }
    /// display.assert_pattern(&[
    ///     "000000000000000000000000",
    ///     "000000000000000000000000",
    ///     "000000000000000000000000",
    ///     "000000000000777700000000",
    ///     "000000000333377700000000",
    ///     "000000000333377700000000",
    ///     "000000000333377700000000",
    ///     "000000000333377700000000",
    ///     "000000000033000000000000",
    ///     "000000000000000000000000",
    ///     "000000000000000000000000",
    ///     "000000000000000000000000",
    /// ]);
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// The errors of [`prepare`](Self::prepare).
    #[cfg_attr(doc, doc = include_str!("../guide/tables.html"))]
    #[allow(clippy::type_complexity)] // as above
    pub fn prepare_back_to_front<'a, S: Scene<'a>, V: AsMvp, M: Mode, Z: DepthTest, B: Copy>(
        &'a mut self,
        options: &DrawOptions<M, Z, B>,
        frame: impl Into<Size>,
        thing: S,
        view: &V,
    ) -> Result<Prepared<'a, S::Material, S::Thing, DrawOptions<M, Z, B>, V::Kind>, Error> {
        self.fill((*options, frame.into()), thing, view, painter::sort)
    }

    /// Fills the list, and sorts it by `sort`.
    #[inline]
    #[allow(clippy::type_complexity)] // as above
    fn fill<'a, S: Scene<'a>, V: AsMvp, M: Mode, Z: DepthTest, B: Copy>(
        &'a mut self,
        (options, frame): (DrawOptions<M, Z, B>, Size),
        scene: S,
        view: &V,
        sort: impl FnOnce(&mut [Entry], &[ScreenVertex], &Objects<'_, S::Thing, S::Material>),
    ) -> Result<Prepared<'a, S::Material, S::Thing, DrawOptions<M, Z, B>, V::Kind>, Error> {
        check_size(frame.width, frame.height)?;
        let screen = options.screen(frame);
        self.entries.clear();
        self.vertices.clear();
        let mut filling = Filling {
            entries: self.entries.as_mut_view(),
            vertices: self.vertices.as_mut_view(),
            screen: &screen,
            scissor: screen.scissor(&(0..frame.height)),
            element: 0,
            needed: [0; 2],
            outside: 0,
            rows: NO_ROWS,
            numbers: [(0, 0); cache::SIZE],
            numbered: cache::Slots::new(&[]),
        };
        let objects = scene.list(&mut filling, view);
        let [elements, vertices] = filling.needed;
        let most = VERTICES.min(Self::MAX_VERTICES);
        for (of, needed, room) in [
            (S::Thing::ELEMENTS, elements, ELEMENTS),
            ("vertices", vertices, most),
        ] {
            if needed > room {
                return Err(Error::Full { of, needed, room });
            }
        }
        sort(&mut self.entries, &self.vertices, &objects);
        Ok(Prepared {
            objects,
            entries: &self.entries,
            vertices: &self.vertices,
            screen,
            options,
            kind: PhantomData,
        })
    }
}

/// An empty range of rows, which grows as elements are added.
const NO_ROWS: [i16; 2] = [i16::MAX, i16::MIN];

/// The data that a list keeps about each thing in it.
#[derive(Clone, Copy, Debug)]
struct Listing {
    /// How many triangles or edges the things before this thing have.
    first: u32,
    /// The rows in which any element of the thing may have pixels: the first row, and the row after the last.
    rows: [i16; 2],
    /// How many elements of the thing are culled.
    culled: u32,
    depth_shift: DepthShift,
}

/// A list that is being filled. Once the list is full, a `Filling` only counts what the list would need.
pub struct Filling<'l> {
    entries: &'l mut VecView<Entry>,
    vertices: &'l mut VecView<ScreenVertex>,
    screen: &'l Screen,
    scissor: Scissor,
    /// How many triangles or edges the things before the present thing have.
    element: u32,
    /// How many elements and vertices the list needs so far.
    needed: [usize; 2],
    /// How many elements of the present thing are outside the view.
    outside: u32,
    /// The rows in which the present thing may have pixels.
    rows: [i16; 2],
    /// For recently added vertices of the present thing: the index of the mesh's position, and the vertex's number in
    /// the list, counted from 1. The number 0 means that there is no vertex.
    numbers: [(Index, u16); cache::SIZE],
    numbered: cache::Slots,
}

impl Filling<'_> {
    /// Adds the visible elements of a thing.
    #[inline]
    fn thing<G: Listed, V: AsMvp>(&mut self, thing: &G, mvp: &V) -> Listing {
        let rows = 0..self.screen.frame.height;
        let call = Call::new((self.screen, &rows), thing.mesh(), mvp);
        self.rows = NO_ROWS;
        self.numbers = [(0, 0); cache::SIZE];
        self.numbered = call.slots;
        self.outside = 0;
        let listed = self.needed[0];
        thing.fill(&call, self);
        let (first, count) = (self.element, thing.count() as u32);
        self.element = first.wrapping_add(count);
        let listed = self.needed[0].wrapping_sub(listed) as u32;
        Listing {
            first,
            rows: self.rows,
            culled: count.wrapping_sub(listed.wrapping_add(self.outside)),
            depth_shift: call.projector.depth_shift(),
        }
    }

    #[inline]
    fn add(&mut self, element: usize, rows: [i16; 2], corners: Corners) {
        let [start, end] = self.rows;
        self.rows = [start.min(rows[0]), end.max(rows[1])];
        self.needed[0] += 1;
        // If there is no room, the list will not be used.
        let _ = self.entries.push(Entry {
            element: self.element.wrapping_add(element as u32),
            rows_or_nearness: rows,
            corners,
        });
    }

    /// Adds a vertex and returns its number. If there is no room, the number is wrong.
    fn add_vertex(&mut self, vertex: &ScreenVertex) -> u16 {
        self.needed[1] += 1;
        let _ = self.vertices.push(*vertex);
        self.needed[1] as u16
    }

    /// The number of a vertex. Adds the vertex, unless it was added recently.
    fn number(&mut self, vertex: &ScreenVertex) -> u16 {
        let slot = self.numbered.slot::<{ cache::SIZE }>(vertex.index);
        let (index, number) = self.numbers[slot];
        if number != 0 && index == vertex.index {
            return number;
        }
        let number = self.add_vertex(vertex);
        self.numbers[slot] = (vertex.index, number);
        number
    }

    /// Adds the corners of a clipped triangle or edge.
    fn corners(&mut self, corners: &[ClippedVertex], beside: u16) -> Corners {
        let first = (self.needed[1] as u16).wrapping_add(1);
        for corner in corners {
            self.add_vertex(&corner.vertex);
            self.add_vertex(&corner.barycentric.stored());
        }
        // There are at most nine corners.
        let count = corners.len() as u16;
        Corners::Clipped {
            first,
            count,
            beside,
        }
    }

    /// Adds a triangle that is inside all planes, if it may have pixels.
    fn whole(&mut self, face: usize, corners: [&ScreenVertex; 3], area: i64) {
        if let Some(triangle) = &Triangle::new(corners, None, area, &self.scissor) {
            // Rows of a frame are 0 to 2048.
            let rows = [triangle.rows.start as i16, triangle.rows.end as i16];
            let numbers = corners.map(|corner| self.number(corner));
            self.add(face, rows, Corners::Whole(numbers));
        } else {
            self.outside += 1;
        }
    }

    /// Adds what clipping left of a triangle, if it is not culled and may have pixels.
    fn clipped(&mut self, face: usize, outline: &[ClippedVertex], cull: Cull) {
        let Some(polygon) = Polygon::new(outline, cull) else {
            self.outside += u32::from(outline.is_empty());
            return;
        };
        if let Some(rows) = polygon.rows(&self.scissor) {
            let corners = self.corners(outline, 0);
            self.add(face, [rows.start as i16, rows.end as i16], corners);
        } else {
            self.outside += 1;
        }
    }
}

/// A thing that a list can hold: triangles or edges.
#[doc(hidden)]
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot be listed",
    note = "a list takes `&mesh`, `mesh.edges(style)`, `mesh.outline(&outline, style)`, `FacesOrEdges` or `&mut objects`"
)]
pub trait Listed: Copy + Sealed {
    /// The name of the thing's elements, for error messages.
    const ELEMENTS: &'static str;

    /// The most rows that an element may reach beyond the rows in its entry.
    const REACH: i32;

    fn mesh(&self) -> &Mesh<'_>;

    /// The number of the thing's elements.
    fn count(&self) -> usize;

    /// The indices of an element's data in the mesh.
    fn indices(&self, element: usize) -> Option<Indices>;

    /// Adds the visible elements to a list.
    fn fill<K: ProjectionKind>(&self, call: &Call<'_, K>, filling: &mut Filling<'_>);

    /// The first row of an element, and the row after its last. `least` and `most` are the y of its top and its bottom
    /// corner, in units of 1/256 row.
    fn rows(least: i32, most: i32) -> [i16; 2];

    /// Draws elements of a list.
    fn draw_listed(
        &self,
        run: &Run<'_>,
        blitter: &mut dyn Blitter,
        coverage: &Cell<Coverage>,
    ) -> Drawn;
}

impl Listed for &Mesh<'_> {
    const ELEMENTS: &'static str = "triangles";
    const REACH: i32 = 0;

    #[inline]
    fn mesh(&self) -> &Mesh<'_> {
        self
    }

    #[inline]
    fn count(&self) -> usize {
        self.faces().len()
    }

    #[inline]
    fn indices(&self, face: usize) -> Option<Indices> {
        Some(Indices::of_face(face, *self.faces().get(face)?))
    }

    #[inline]
    fn fill<K: ProjectionKind>(&self, call: &Call<'_, K>, filling: &mut Filling<'_>) {
        if call.is_outside() {
            filling.outside = self.faces().len() as u32;
            return;
        }
        let mut entries = cache::empty();
        let mut vertices = VertexCache::new(&mut entries, call.slots);
        for (face, corners) in self.faces().iter().enumerate() {
            run::triangle(call, &mut vertices, corners, |triangle| match triangle {
                OnScreen::Whole(corners, area) => filling.whole(face, corners, area),
                OnScreen::Clipped(outline) => filling.clipped(face, outline, call.cull),
                OnScreen::Culled => {}
                OnScreen::Outside => filling.outside += 1,
            });
        }
    }

    #[inline]
    fn rows(least: i32, most: i32) -> [i16; 2] {
        [least, most].map(|y| first_center(y) as i16)
    }

    #[inline]
    fn draw_listed(&self, run: &Run<'_>, blitter: &mut dyn Blitter, _: &Cell<Coverage>) -> Drawn {
        run.draw_triangles(blitter)
    }
}

impl<const SMOOTH: bool> Listed for Edges<'_, SMOOTH> {
    const ELEMENTS: &'static str = "edges";
    const REACH: i32 = 32;

    #[inline]
    fn mesh(&self) -> &Mesh<'_> {
        self.of.mesh
    }

    #[inline]
    fn count(&self) -> usize {
        self.of.count()
    }

    #[inline]
    fn indices(&self, edge: usize) -> Option<Indices> {
        self.of.indices(edge)
    }

    #[inline]
    fn fill<K: ProjectionKind>(&self, call: &Call<'_, K>, filling: &mut Filling<'_>) {
        let listed = filling.needed[0];
        let kept = self.of.assemble(call, |edge, ends, is_clipped, beside| {
            let [a, b] = ends.map(|end| end.vertex.screen[1]);
            let corners = if is_clipped {
                filling.corners(&ends.map(|end| *end), beside)
            } else {
                let ends = ends.map(|end| filling.number(&end.vertex));
                Corners::Edge { ends, beside }
            };
            filling.add(edge.number(), Self::rows(a.min(b), a.max(b)), corners);
        });
        let listed = filling.needed[0].wrapping_sub(listed);
        filling.outside = kept.wrapping_sub(listed) as u32;
    }

    /// Rows fit into 16 bits: positions lie within the guard band, and the guard band's center is at most 6144 rows
    /// from the frame's top.
    #[inline]
    fn rows(least: i32, most: i32) -> [i16; 2] {
        [(least >> 8) as i16, ((most >> 8) + 1) as i16]
    }

    #[inline]
    fn draw_listed(
        &self,
        run: &Run<'_>,
        blitter: &mut dyn Blitter,
        coverage: &Cell<Coverage>,
    ) -> Drawn {
        self.style.with_line(coverage, |line| {
            run.draw_edges(self.of, self.style.reach(), line, blitter)
        })
    }
}

/// A thing, or several objects, to fill a list with.
#[doc(hidden)]
pub trait Scene<'a>: Sealed {
    type Thing: Listed;
    type Material;

    fn list<V: AsMvp>(
        self,
        filling: &mut Filling<'_>,
        view: &V,
    ) -> Objects<'a, Self::Thing, Self::Material>;
}

impl<'a, G: Listed> Scene<'a> for G {
    type Thing = G;
    type Material = ();

    #[inline]
    fn list<V: AsMvp>(self, filling: &mut Filling<'_>, view: &V) -> Objects<'a, G, ()> {
        let placed = Placed {
            listing: filling.thing(&self, view),
            thing: self,
            model: *view.model_of(),
            view: view.model_view_of(),
        };
        Objects::One(placed, ())
    }
}
