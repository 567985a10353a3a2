//! The draw call: a mesh through a chain of transforms onto a canvas.

use core::marker::PhantomData;

use heapless::Vec;

use crate::geometry::{self, ClipVertex, Cull, Element, Index, Projected, Projector};
use crate::interpolate::{Exact, Interpolate};
use crate::linear::Transform;
use crate::number::Subpixel;
use crate::raster::{self, Triangle, Window};
use crate::shade::Fragment;
use crate::target::{Canvas, DepthBuffer, Storage};
use crate::view::{Chain, Kind, Viewport};
use crate::{Face, Mesh, Vec3, Vertex};

/// How a draw call is to be done: which faces are culled, where on the canvas, by which mode.
///
/// The default culls back faces and draws to the whole frame in mode [`Exact`].
///
/// ```
/// use fixel::prelude::*;
/// let left: Pass = Pass::new().viewport(Viewport::new(0, 0, 160, 240)?);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Pass<I = Exact> {
    cull: Cull,
    viewport: Option<Viewport>,
    mode: PhantomData<I>,
}

impl Default for Pass {
    fn default() -> Self {
        Self::new()
    }
}

impl Pass {
    /// The default.
    #[must_use]
    pub const fn new() -> Self {
        Self {
            cull: Cull::Back,
            viewport: None,
            mode: PhantomData,
        }
    }
}

impl<I> Pass<I> {
    /// Leaves out other faces.
    #[must_use]
    pub const fn cull(self, cull: Cull) -> Self {
        Self { cull, ..self }
    }

    /// Draws into a part of the frame, and into that only.
    #[must_use]
    pub const fn viewport(self, viewport: Viewport) -> Self {
        Self {
            viewport: Some(viewport),
            ..self
        }
    }

    /// Interpolates in another mode.
    #[must_use]
    pub const fn mode<J: Interpolate>(self) -> Pass<J> {
        Pass {
            cull: self.cull,
            viewport: self.viewport,
            mode: PhantomData,
        }
    }
}

/// What became of a draw call's triangles, edges or points.
///
/// ```
/// use embedded_graphics::pixelcolor::Gray8;
/// use fixel::prelude::*;
/// let mut pixels = [Gray8::new(0); 64];
/// let mut canvas = Canvas::new(&mut pixels, 8, 8)?;
/// let lens = Projection::perspective(Angle::from_degrees(90), (1, 1), fx!(0.1), fx!(10))?;
/// let chain = lens * Transform::translate(vec3!(0, 0, -1));
/// let positions = [vec3!(-1, -1, 0), vec3!(1, -1, 0), vec3!(-1, 1, 0)];
/// let triangle = Mesh::new(&positions, &[[0, 1, 2], [0, 2, 1]])?;
/// let drawn = canvas.draw(&triangle, &chain, &Flat::new(Gray8::new(255)));
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

impl<C, O: Storage<C>, D: DepthBuffer> Canvas<'_, C, O, D> {
    /// Draws a mesh's triangles: through `chain` into the whole frame, without back faces, each
    /// pixel correct in perspective.
    ///
    /// Cannot fail: what cannot be seen is left out, what is partly to be seen is clipped.
    pub fn draw<K: Kind, F: Fragment<N, Color = C>, const N: usize>(
        &mut self,
        mesh: &Mesh<'_>,
        chain: &Chain<K>,
        fragment: &F,
    ) -> Drawn {
        self.draw_with(&Pass::new(), mesh, chain, fragment)
    }

    /// Draws a mesh's triangles as [`draw`](Self::draw) does, in the way that `pass` says.
    pub fn draw_with<I: Interpolate, K: Kind, F: Fragment<N, Color = C>, const N: usize>(
        &mut self,
        pass: &Pass<I>,
        mesh: &Mesh<'_>,
        chain: &Chain<K>,
        fragment: &F,
    ) -> Drawn {
        let mut call = Call::new(self, pass, mesh, chain, fragment);
        let mut cache = Cache::new();
        for (face, &indices) in mesh.faces().iter().enumerate() {
            let corners = indices.map(|index| cache.project(&call, index));
            let element = Element {
                face: Some(face),
                indices,
            };
            call.triangle::<I, O, D, N>(self, element, corners);
        }
        call.drawn
    }

    /// Draws a mesh's [edges](Mesh::edges) as lines, one pixel wide.
    pub fn draw_edges<I: Interpolate, K: Kind, F: Fragment<N, Color = C>, const N: usize>(
        &mut self,
        pass: &Pass<I>,
        mesh: &Mesh<'_>,
        chain: &Chain<K>,
        fragment: &F,
    ) -> Drawn {
        let mut call = Call::new(self, pass, mesh, chain, fragment);
        let mut cache = Cache::new();
        for &[a, b] in mesh.edges() {
            let ends = [a, b].map(|index| cache.project(&call, index));
            let element = Element {
                face: None,
                indices: [a, b, b],
            };
            call.line::<I, O, D, N>(self, element, ends);
        }
        call.drawn
    }

    /// Where a point of model space comes to lie, to the last bit as when it is drawn; `None` if it
    /// is nearer than the near plane, beyond the far plane or more than 2048 pixels from the
    /// viewport's centre. It may be outside the viewport.
    ///
    /// For a label beside a thing, or a touch upon it.
    #[must_use]
    pub fn project<I, K: Kind>(
        &self,
        pass: &Pass<I>,
        chain: &Chain<K>,
        point: Vec3,
    ) -> Option<Place> {
        let viewport = pass.viewport.unwrap_or(Viewport::whole(self.frame_size()));
        let projector = Projector::new(&chain.projection, &chain.model_view(), &viewport);
        let at = projector.project(projector.clip_position(point));
        if at.outside != 0 {
            return None;
        }
        let [x, y] = at.screen.map(Subpixel::from_bits);
        Some(Place {
            x,
            y,
            depth: (at.q >> projector.depth_shift(at.exponent)) as u16,
        })
    }

    /// Draws a mesh's positions as points, one pixel each.
    pub fn draw_points<I: Interpolate, K: Kind, F: Fragment<N, Color = C>, const N: usize>(
        &mut self,
        pass: &Pass<I>,
        mesh: &Mesh<'_>,
        chain: &Chain<K>,
        fragment: &F,
    ) -> Drawn {
        let mut call = Call::new(self, pass, mesh, chain, fragment);
        for index in 0..mesh.positions().len() {
            // A mesh has at most 65,536 positions.
            let Ok(index) = Index::try_from(index) else {
                break;
            };
            call.point::<I, O, D, N>(self, index);
        }
        call.drawn
    }
}

/// Where a point of model space is on the screen.
///
/// ```
/// use embedded_graphics::pixelcolor::Gray8;
/// use fixel::prelude::*;
/// let mut pixels = [Gray8::new(0); 64];
/// let canvas = Canvas::new(&mut pixels, 8, 8)?;
/// let lens = Projection::perspective(Angle::from_degrees(90), (1, 1), fx!(0.5), fx!(10))?;
/// let place = canvas.project(&Pass::new(), &(lens * Transform::IDENTITY), vec3!(0.5, 1, -2)).unwrap();
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
    /// Depth as it would be stored.
    pub depth: u16,
}

/// What is the same for all of a draw call.
struct Call<'m, K, F> {
    mesh: &'m Mesh<'m>,
    view: Transform,
    projector: Projector<K>,
    window: Window,
    cull: Cull,
    fragment: F,
    drawn: Drawn,
}

impl<'m, K: Kind, F> Call<'m, K, F> {
    fn new<I, C, O: Storage<C>, D, const N: usize>(
        canvas: &Canvas<'_, C, O, D>,
        pass: &Pass<I>,
        mesh: &'m Mesh<'m>,
        chain: &Chain<K>,
        fragment: &F,
    ) -> Self
    where
        F: Fragment<N, Color = C>,
    {
        let size = canvas.frame_size();
        let viewport = pass.viewport.unwrap_or(Viewport::whole(size));
        let view = chain.model_view();
        let [columns, rows] = viewport.pixels();
        let meet = |a: core::ops::Range<i32>, start: u32, end: u32| {
            a.start.max(start.cast_signed())..a.end.min(end.cast_signed())
        };
        Self {
            mesh,
            projector: Projector::new(&chain.projection, &view, &viewport),
            view,
            window: Window {
                columns: meet(columns, 0, size.width),
                rows: meet(rows, canvas.rows().start, canvas.rows().end),
            },
            cull: pass.cull,
            fragment: fragment.begin(&chain.model),
            drawn: Drawn::default(),
        }
    }

    /// Draws one triangle, clipped if need be.
    #[inline]
    fn triangle<I: Interpolate, O, D, const N: usize>(
        &mut self,
        canvas: &mut Canvas<'_, F::Color, O, D>,
        element: Element,
        corners: [Projected; 3],
    ) where
        F: Fragment<N>,
        O: Storage<F::Color>,
        D: DepthBuffer,
    {
        self.drawn.submitted += 1;
        let [a, b, c] = corners.map(|corner| corner.outside);
        if a & b & c != 0 {
            return;
        }
        let face = Face {
            mesh: self.mesh,
            view: &self.view,
            element,
        };
        if a | b | c != 0 {
            let drawn = self.clipped_triangle::<I, O, D, N>(canvas, &face, a | b | c);
            self.drawn.drawn += u32::from(drawn);
            self.drawn.clipped += u32::from(drawn);
            return;
        }
        let Some(triangle) = Triangle::new(corners, self.cull, &self.window) else {
            return;
        };
        let mut varyings = [0, 1, 2].map(|corner| self.varyings(&face, corner));
        let fragment = self.fragment.face(&mut varyings, &face);
        let depth_shift = |exponent| self.projector.depth_shift(exponent);
        triangle.draw::<K::Mode<I>, F, O, D, N>(
            canvas,
            &self.window,
            varyings,
            (&fragment, depth_shift),
        );
        self.drawn.drawn += 1;
    }

    /// Draws what of a triangle is inside the `planes`; tells whether anything was.
    #[inline(never)]
    fn clipped_triangle<I: Interpolate, O, D, const N: usize>(
        &self,
        canvas: &mut Canvas<'_, F::Color, O, D>,
        face: &Face<'_>,
        planes: u8,
    ) -> bool
    where
        F: Fragment<N>,
        O: Storage<F::Color>,
        D: DepthBuffer,
    {
        let mut varyings = [0, 1, 2].map(|corner| self.varyings(face, corner));
        let fragment = self.fragment.face(&mut varyings, face);
        let [a, b, c] = face
            .positions()
            .map(|position| self.projector.clip_position(position));
        let corners = [(a, varyings[0]), (b, varyings[1]), (c, varyings[2])]
            .map(|(position, varyings)| ClipVertex { position, varyings });
        let polygon = geometry::clip_triangle(&self.projector, &corners, planes);
        // A fan of triangles.
        let mut corners = polygon.iter().map(|vertex| {
            (
                self.projector.project_inside(vertex.position),
                vertex.varyings,
            )
        });
        let (Some(first), Some(mut from)) = (corners.next(), corners.next()) else {
            return false;
        };
        let mut parts: Vec<_, 7> = Vec::new();
        let mut area = 0;
        for to in corners {
            let fan = [first, from, to];
            let part = Triangle::new(fan.map(|corner| corner.0), Cull::Nothing, &self.window);
            area += raster::area(fan.map(|corner| corner.0.screen));
            if let Some(part) = part {
                // There is room: nine corners make seven parts.
                let _ = parts.push((part, fan.map(|corner| corner.1)));
            }
            from = to;
        }
        if self.cull.leaves_out(area) {
            return false;
        }
        // Rounding may have turned some of them over.
        let clockwise = area > 0;
        let folded = parts
            .iter()
            .any(|(part, _)| part.is_clockwise() != clockwise);
        for (at, (part, varyings)) in parts.iter().enumerate() {
            if part.is_clockwise() == clockwise {
                let keep = |pixel| raster::is_drawn_by_part(&parts, at, clockwise, pixel);
                part.draw_where::<K::Mode<I>, F, O, D, N>(
                    canvas,
                    &self.window,
                    *varyings,
                    (&fragment, |exponent| self.projector.depth_shift(exponent)),
                    folded.then_some(&keep),
                );
            }
        }
        !parts.is_empty()
    }

    /// Draws one line, clipped if need be.
    fn line<I: Interpolate, O, D, const N: usize>(
        &mut self,
        canvas: &mut Canvas<'_, F::Color, O, D>,
        element: Element,
        mut ends: [Projected; 2],
    ) where
        F: Fragment<N>,
        O: Storage<F::Color>,
        D: DepthBuffer,
    {
        self.drawn.submitted += 1;
        let [a, b] = ends.map(|end| end.outside);
        if a & b != 0 {
            return;
        }
        let face = Face {
            mesh: self.mesh,
            view: &self.view,
            element,
        };
        let mut varyings = [0, 1].map(|end| self.varyings(&face, end));
        if a | b != 0 {
            let [from, to, _] = face
                .positions()
                .map(|position| self.projector.clip_position(position));
            let whole = [(from, varyings[0]), (to, varyings[1])]
                .map(|(position, varyings)| ClipVertex { position, varyings });
            let Some(inside) = geometry::clip_line(&self.projector, whole, a | b) else {
                return;
            };
            ends = inside.map(|end| self.projector.project_inside(end.position));
            varyings = inside.map(|end| end.varyings);
            self.drawn.clipped += 1;
        }
        let depth_shift = |exponent| self.projector.depth_shift(exponent);
        raster::line::<K::Mode<I>, F, O, D, N>(
            canvas,
            &self.window,
            ends,
            varyings,
            (&self.fragment, depth_shift),
        );
        self.drawn.drawn += 1;
    }

    /// Draws one point.
    fn point<I: Interpolate, O, D, const N: usize>(
        &mut self,
        canvas: &mut Canvas<'_, F::Color, O, D>,
        index: Index,
    ) where
        F: Fragment<N>,
        O: Storage<F::Color>,
        D: DepthBuffer,
    {
        self.drawn.submitted += 1;
        let at = self
            .projector
            .project(self.projector.clip_position(self.mesh.position(index)));
        if at.outside != 0 {
            return;
        }
        let element = Element {
            face: None,
            indices: [index; 3],
        };
        let face = Face {
            mesh: self.mesh,
            view: &self.view,
            element,
        };
        let varyings = self.varyings(&face, 0);
        let depth_shift = |exponent| self.projector.depth_shift(exponent);
        raster::point::<K::Mode<I>, F, O, D, N>(
            canvas,
            &self.window,
            &at,
            varyings,
            (&self.fragment, depth_shift),
        );
        self.drawn.drawn += 1;
    }

    #[inline]
    fn varyings<const N: usize>(&self, face: &Face<'_>, corner: usize) -> [i32; N]
    where
        F: Fragment<N>,
    {
        self.fragment.varyings(&Vertex { face, corner })
    }
}

/// Vertices that were projected lately, as neighbouring triangles share them.
struct Cache {
    entries: [(Index, Projected); Self::SIZE],
}

impl Cache {
    /// A power of two. Rows of a mesh up to 31 vertices apart are projected once; 1 KiB of stack.
    const SIZE: usize = 64;

    const fn new() -> Self {
        // Entry 0 is for multiples of the size, so 1 marks it as empty; the others may begin with 0.
        let mut entries = [(0, Projected::NONE); Self::SIZE];
        entries[0].0 = 1;
        Self { entries }
    }

    #[inline]
    fn project<K: Kind, F>(&mut self, call: &Call<'_, K, F>, index: Index) -> Projected {
        // Never more than the size less one.
        let (entry, projected) = &mut self.entries[usize::from(index) % Self::SIZE];
        if *entry != index {
            *entry = index;
            let position = call.projector.clip_position(call.mesh.position(index));
            *projected = call.projector.project(position);
        }
        *projected
    }
}
