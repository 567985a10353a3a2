//! One draw call, element by element: attributes, clipping, rasterization.

use heapless::Vec;

use super::{Drawn, Pass};
use crate::geometry::{
    self, ClipVertex, Cull, Element, Face, Index, Mesh, Projected, Projector, Vertex,
};
use crate::interpolate::Interpolate;
use crate::linear::Transform;
use crate::raster::{self, Triangle, Window};
use crate::shade::Fragment;
use crate::target::{Canvas, DepthBuffer, Storage};
use crate::view::{Chain, Kind, Viewport};

/// What is the same for all of a draw call.
pub(super) struct Call<'m, K, F> {
    pub(super) mesh: &'m Mesh<'m>,
    view: Transform,
    pub(super) projector: Projector<K>,
    window: Window,
    cull: Cull,
    fragment: F,
    pub(super) drawn: Drawn,
}

impl<'m, K: Kind, F> Call<'m, K, F> {
    pub(super) fn new<I, C, O: Storage<C>, D, const N: usize>(
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
    pub(super) fn triangle<I: Interpolate, O, D, const N: usize>(
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
    pub(super) fn line<I: Interpolate, O, D, const N: usize>(
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
    pub(super) fn point<I: Interpolate, O, D, const N: usize>(
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
