//! Triangles prepared once for all bands of a frame.

use core::num::NonZeroU16;
use core::ops::Range;

use embedded_graphics::geometry::Size;
use heapless::{Vec, VecView};

use super::cache::Cache;
use super::geometry::Geometry;
use super::painter::Painter;
use super::{DrawOptions, Drawn};
use crate::Error;
use crate::math::Transform;
use crate::raster::{Brush, Fan, Triangle, Window};
use crate::span::{Interpolate, Newton};
use crate::target::check_size;
use crate::view::{Mvp, ProjectionKind as Kind, Viewport};
use crate::{
    mesh::{Element, Mesh},
    pipeline::{ClippedCorner, Outline, Projected, Weights},
};

/// Memory for the triangles of a frame that is drawn in bands: transformed, culled and clipped
/// once, walked by every band.
///
/// Without it each band transforms the whole mesh again, which for a mesh of many small triangles
/// takes longer than to draw it. Room is needed for the triangles that are to be seen (16 bytes
/// each), and for their vertices (16 bytes each): about half as many in a closed mesh whose
/// triangles are in the order of neighbours, at most three times as many, and up to 18 for each
/// triangle that is clipped. Where there is too little, [`prepare`](Self::prepare) says how much
/// is needed.
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
/// let projection = Projection::perspective(Angle::from_degrees(60), (WIDTH, HEIGHT), fx!(1), fx!(10))?;
/// let mvp = projection * Transform::translate(vec3!(0, 0, -2.5));
/// let sun = Light::new(vec3!(1, 2, 3), fx!(0), fx!(1))?;
/// let white = Lit::new(Gray4::WHITE, sun);
///
/// let mut list: TriangleList<100, 80> = TriangleList::new(); // on a microcontroller, a static
/// let ball = list.prepare(&DrawOptions::new(), (WIDTH, HEIGHT), &BALL, &mvp)?;
///
/// let mut display = MockDisplay::new();
/// let mut color = [Gray4::BLACK; (WIDTH * ROWS) as usize];
/// for first_row in (0..HEIGHT).step_by(ROWS as usize) {
///     let mut band = Canvas::band(&mut color, WIDTH, HEIGHT, first_row)?;
///     band.clear(Gray4::BLACK);
///     band.draw_prepared(&ball, &white); // nothing is transformed here
///     band.show(&mut display)?;
/// }
///
/// // The same picture at once.
/// let mut color = [Gray4::BLACK; (WIDTH * HEIGHT) as usize];
/// let mut frame = Canvas::new(&mut color, WIDTH, HEIGHT)?;
/// frame.draw(&BALL, &mvp, &white);
/// let mut whole = MockDisplay::new();
/// frame.show(&mut whole)?;
/// display.assert_eq(&whole);
///
/// let mut short: TriangleList<20, 80> = TriangleList::new();
/// let error = short.prepare(&DrawOptions::new(), (WIDTH, HEIGHT), &BALL, &mvp).unwrap_err();
/// assert_eq!(error.to_string(), "44 triangles are visible: the list has room for 20");
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct TriangleList<const TRIANGLES: usize, const VERTICES: usize> {
    triangles: Vec<Entry, TRIANGLES>,
    vertices: Vec<Slot, VERTICES>,
}

/// A triangle that is to be seen.
#[derive(Clone, Copy, Debug)]
struct Entry {
    /// Its place among the mesh's faces.
    face: u32,
    /// The rows of the frame that it may have pixels in, first and last.
    rows: [u16; 2],
    corners: Corners,
}

/// Where in the list a triangle's corners are.
#[derive(Clone, Copy, Debug)]
enum Corners {
    /// All inside: three vertices.
    Whole([u16; 3]),
    /// Clipped: so many corners, each a vertex and its weights.
    Clipped { first: u16, count: u16 },
}

/// A vertex on the screen, or where in its triangle the one before it lies.
///
/// Fields of their own, and not a [`Projected`], so that the tag finds room among them.
#[derive(Clone, Copy, Debug)]
enum Slot {
    ClipVertex {
        screen: [i32; 2],
        q: u32,
        exponent: u8,
    },
    Weights(Weights),
}

impl From<Projected> for Slot {
    fn from(vertex: Projected) -> Self {
        Self::ClipVertex {
            screen: vertex.screen,
            q: vertex.q,
            exponent: vertex.exponent,
        }
    }
}

impl Slot {
    #[inline]
    fn projected(self) -> Option<Projected> {
        match self {
            Self::ClipVertex {
                screen,
                q,
                exponent,
            } => Some(Projected {
                screen,
                q,
                exponent,
                outside: 0,
                index: 0,
            }),
            Self::Weights(_) => None,
        }
    }
}

/// A mesh's triangles, ready to be drawn into every band of a frame: what
/// [`TriangleList::prepare`] makes and [`Canvas::draw_prepared`](crate::Canvas::draw_prepared) draws.
///
/// It can be shared with another core, which draws other bands of the same frame.
///
/// ```
/// use fixel::{Prepared, prelude::*};
/// fn is_shared<T: Sync>() {}
/// is_shared::<Prepared<'static>>();
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Prepared<'a, K = crate::view::Perspective, I = Newton> {
    pub(super) geometry: Geometry<'a, K>,
    pub(super) model: Transform,
    viewport: Viewport,
    triangles: &'a [Entry],
    vertices: &'a [Slot],
    pub(super) mode: I,
}

impl<const TRIANGLES: usize, const VERTICES: usize> Default for TriangleList<TRIANGLES, VERTICES> {
    fn default() -> Self {
        Self::new()
    }
}

impl<const TRIANGLES: usize, const VERTICES: usize> TriangleList<TRIANGLES, VERTICES> {
    /// Most vertices that can be used, whatever there is room for: they are counted from 1 in 16 bits.
    pub const MAX_VERTICES: usize = u16::MAX as usize;

    /// An empty list.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            triangles: Vec::new(),
            vertices: Vec::new(),
        }
    }

    /// Transforms, culls and clips a mesh's triangles for a `frame` of so many columns and rows:
    /// what [`Canvas::draw_with`](crate::Canvas::draw_with) would do for each of its bands. What was in the list before is
    /// dropped.
    ///
    /// # Errors
    ///
    /// [`Error::Full`] if the list is too short for what is to be seen, with the length that is
    /// needed; [`Error::Size`] if a side of the frame is 0 or above [`MAX_SIZE`](crate::target::MAX_SIZE).
    pub fn prepare<'a, I: Interpolate, K: Kind>(
        &'a mut self,
        pass: &DrawOptions<I>,
        frame: impl Into<Size>,
        mesh: &'a Mesh<'a>,
        mvp: &Mvp<K>,
    ) -> Result<Prepared<'a, K, I>, Error> {
        let frame = frame.into();
        check_size(frame.width, frame.height)?;
        let viewport = pass.viewport_in(frame);
        let geometry = Geometry::new(pass, mesh, mvp, &viewport);
        let window = Window::new(&viewport, frame.width, &(0..frame.height));
        let mut filling = Filling {
            triangles: self.triangles.as_mut_view(),
            vertices: self.vertices.as_mut_view(),
            needed: Needed::default(),
        };
        filling.fill(&geometry, &window);
        let Needed {
            triangles,
            vertices,
        } = filling.needed;
        for (of, needed, room) in [
            ("triangles", triangles, TRIANGLES),
            ("vertices", vertices, VERTICES.min(Self::MAX_VERTICES)),
        ] {
            if needed > room {
                return Err(Error::Full { of, needed, room });
            }
        }
        Ok(Prepared {
            geometry,
            model: mvp.model,
            viewport,
            triangles: &self.triangles,
            vertices: &self.vertices,
            mode: pass.mode,
        })
    }
}

/// Elements that a list must have room for.
#[derive(Clone, Copy, Debug, Default)]
struct Needed {
    triangles: usize,
    vertices: usize,
}

/// A list on its way to be filled; when there is no more room it goes on counting.
struct Filling<'l> {
    triangles: &'l mut VecView<Entry>,
    vertices: &'l mut VecView<Slot>,
    needed: Needed,
}

impl Filling<'_> {
    /// Puts in what is to be seen.
    fn fill<K: Kind>(&mut self, geometry: &Geometry<'_, K>, window: &Window) {
        self.triangles.clear();
        self.vertices.clear();
        // A vertex's note is its number in the list, from 1.
        let mut cache = Cache::<Option<NonZeroU16>>::new();
        for (face, &indices) in geometry.mesh.faces().iter().enumerate() {
            let Some((planes, area)) = geometry.planes(&mut cache, indices) else {
                continue;
            };
            let element = Element {
                face: Some(face),
                indices,
            };
            let (rows, corners) = if planes == 0 {
                let corners = cache.corners(geometry, indices);
                let Some(triangle) = Triangle::of_area(&corners, area, window) else {
                    continue;
                };
                let rows = triangle.row_range();
                let corners = indices.map(|index| {
                    let vertex = cache.vertex(geometry, index);
                    let number = vertex
                        .note
                        .unwrap_or_else(|| self.add(vertex.projected.into()));
                    vertex.note = Some(number);
                    number.get()
                });
                (rows, Corners::Whole(corners))
            } else {
                let outline = geometry.clip(element, 3, planes);
                let fan = Fan::new(&outline, geometry.cull);
                let Some(rows) = fan.and_then(|fan| fan.row_range(window)) else {
                    continue;
                };
                (rows, self.add_outline(&outline))
            };
            // Rows of a frame: 0 to 2048.
            let row = |row: i32| {
                let inside = row.max(window.rows.start).min(window.rows.end);
                inside.cast_unsigned() as u16
            };
            self.needed.triangles += 1;
            // If there is no room the list is not used.
            let _ = self.triangles.push(Entry {
                face: face as u32,
                rows: [row(rows.start), row(rows.end)],
                corners,
            });
        }
    }

    /// Adds a vertex; its number, which is wrong if there is no room.
    fn add(&mut self, slot: Slot) -> NonZeroU16 {
        self.needed.vertices += 1;
        let _ = self.vertices.push(slot);
        NonZeroU16::new(self.needed.vertices as u16).unwrap_or(NonZeroU16::MIN)
    }

    fn add_outline(&mut self, outline: &[ClippedCorner]) -> Corners {
        let first = (self.needed.vertices as u16).wrapping_add(1);
        for corner in outline {
            self.add(corner.vertex.into());
            self.add(Slot::Weights(corner.weights));
        }
        Corners::Clipped {
            first,
            // At most nine.
            count: outline.len() as u16,
        }
    }
}

impl<K: Kind, I> Prepared<'_, K, I> {
    /// Draws those that meet `rows` of a frame so wide.
    #[inline(never)]
    pub(super) fn draw(&self, brush: &mut dyn Brush, width: u32, rows: &Range<u32>) -> Drawn {
        let window = Window::new(&self.viewport, width, rows);
        let mut painter = Painter::over(self.geometry, window);
        let rows = painter.rows().clone();
        for entry in self.triangles {
            let [start, end] = entry.rows.map(i32::from);
            if start.max(rows.start) >= end.min(rows.end) {
                continue;
            }
            let face = entry.face as usize;
            let Some(&indices) = self.geometry.mesh.faces().get(face) else {
                continue;
            };
            let element = Element {
                face: Some(face),
                indices,
            };
            match entry.corners {
                Corners::Whole([a, b, c]) => {
                    let corners = (self.vertex(a), self.vertex(b), self.vertex(c));
                    if let (Some(a), Some(b), Some(c)) = corners {
                        let corners = [a, b, c];
                        let triangle = painter.seen(&corners);
                        painter.whole(brush, element, triangle);
                    }
                }
                Corners::Clipped { first, count } => {
                    let outline = self.outline(first, count);
                    painter.outline(brush, element, &outline);
                }
            }
        }
        painter.drawn.submitted = self.geometry.mesh.faces().len() as u32;
        painter.drawn
    }

    #[inline]
    fn vertex(&self, number: u16) -> Option<Projected> {
        let slot = self.vertices.get(usize::from(number).wrapping_sub(1))?;
        slot.projected()
    }

    fn outline(&self, first: u16, count: u16) -> Outline {
        let start = usize::from(first).wrapping_sub(1);
        let slots = self
            .vertices
            .get(start..start.wrapping_add(usize::from(2 * count)));
        let mut outline = Outline::new();
        for pair in slots.unwrap_or_default().chunks_exact(2) {
            if let [vertex, Slot::Weights(weights)] = *pair {
                if let Some(vertex) = vertex.projected() {
                    // At most as many as were clipped.
                    let _ = outline.push(ClippedCorner { vertex, weights });
                }
            }
        }
        outline
    }
}
