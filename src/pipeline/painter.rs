//! The painting of a draw call: from elements on the screen to pixels.

use core::ops::Range;

use embedded_graphics::geometry::Size;

use super::cache::Cache;
use super::geometry::Geometry;
use super::{DrawOptions, Drawn};
use crate::raster::{self, Brush, Fan, Triangle, Window};
use crate::view::{Mvp, ProjectionKind as Kind};
use crate::{
    mesh::{Element, Index, Mesh},
    pipeline::{ClippedCorner, Projected, Weights},
};

/// What is the same for all of a draw call, but for what it paints with.
pub(super) struct Painter<'m, K> {
    pub(super) geometry: Geometry<'m, K>,
    window: Window,
    pub(super) drawn: Drawn,
}

impl<'m, K: Kind> Painter<'m, K> {
    /// That of a mesh on `rows` of a frame.
    #[inline(never)]
    pub(super) fn new<I: Copy>(
        pass: &DrawOptions<I>,
        (frame, rows): (Size, &Range<u32>),
        mesh: &'m Mesh<'m>,
        mvp: &Mvp<K>,
    ) -> Self {
        let viewport = pass.viewport_in(frame);
        Self::over(
            Geometry::new(pass, mesh, mvp, &viewport),
            Window::new(&viewport, frame.width, rows),
        )
    }

    /// That of geometry already worked out.
    #[inline]
    pub(super) fn over(geometry: Geometry<'m, K>, window: Window) -> Self {
        Self {
            geometry,
            window,
            drawn: Drawn::default(),
        }
    }

    /// The rows that may be drawn into.
    pub(super) const fn rows(&self) -> &Range<i32> {
        &self.window.rows
    }

    /// Draws all triangles.
    #[inline(never)]
    pub(super) fn triangles(&mut self, brush: &mut dyn Brush) {
        let mut cache = Cache::<()>::new();
        let faces = self.geometry.mesh.faces();
        self.drawn.submitted += faces.len() as u32;
        for (face, &indices) in faces.iter().enumerate() {
            let Some((planes, area)) = self.geometry.planes(&mut cache, indices) else {
                continue;
            };
            let element = Element {
                face: Some(face),
                indices,
            };
            if planes == 0 {
                let corners = cache.corners(&self.geometry, indices);
                self.whole(
                    brush,
                    element,
                    Triangle::of_area(&corners, area, &self.window),
                );
            } else {
                let outline = self.geometry.clip(element, 3, planes);
                self.outline(brush, element, &outline);
            }
        }
    }

    /// Draws a triangle that is all inside, if it is in the window.
    #[inline]
    pub(super) fn whole(
        &mut self,
        brush: &mut dyn Brush,
        element: Element,
        triangle: Option<Triangle<'_>>,
    ) {
        if let Some(triangle) = triangle {
            brush.element(&self.geometry.face(element));
            triangle.draw(brush, &self.window);
            self.drawn.drawn += 1;
        }
    }

    /// A triangle that is all inside, unless it is culled or not in the window.
    #[inline]
    pub(super) fn seen<'c>(&self, corners: &'c [Projected; 3]) -> Option<Triangle<'c>> {
        Triangle::new(corners, self.geometry.cull, &self.window)
    }

    /// Draws a clipped triangle, as a fan.
    #[inline(never)]
    pub(super) fn outline(
        &mut self,
        brush: &mut dyn Brush,
        element: Element,
        outline: &[ClippedCorner],
    ) {
        if let Some(fan) = Fan::new(outline, self.geometry.cull) {
            brush.element(&self.geometry.face(element));
            let drawn = u32::from(fan.draw(brush, &self.window));
            self.drawn.drawn += drawn;
            self.drawn.clipped += drawn;
        }
    }

    /// Draws all edges as lines.
    #[inline(never)]
    pub(super) fn lines(&mut self, brush: &mut dyn Brush) {
        let mut cache = Cache::<()>::new();
        for &[a, b] in self.geometry.mesh.edges() {
            let element = Element {
                face: None,
                indices: [a, b, b],
            };
            self.drawn.submitted += 1;
            let ends = [a, b].map(|index| cache.vertex(&self.geometry, index).projected);
            let [start, end] = [ends[0].outside, ends[1].outside];
            if start & end != 0 {
                continue;
            }
            let [vertex, other] = ends;
            let [weights, other_weights, _] = Weights::CORNERS;
            let mut line = [
                ClippedCorner { vertex, weights },
                ClippedCorner {
                    vertex: other,
                    weights: other_weights,
                },
            ];
            if start | end != 0 {
                match *self.geometry.clip(element, 2, start | end) {
                    [from, to] => line = [from, to],
                    _ => continue,
                }
                self.drawn.clipped += 1;
            }
            brush.element(&self.geometry.face(element));
            raster::line(brush, &self.window, line.each_ref());
            self.drawn.drawn += 1;
        }
    }

    /// Draws all positions as points.
    #[inline(never)]
    pub(super) fn points(&mut self, brush: &mut dyn Brush) {
        for index in 0..self.geometry.mesh.positions().len() {
            // A mesh has at most 65,536 positions.
            let Ok(index) = Index::try_from(index) else {
                break;
            };
            self.drawn.submitted += 1;
            let mut at = Projected::NONE;
            self.geometry.project(index, &mut at);
            if at.outside == 0 {
                brush.element(&self.geometry.face(Element {
                    face: None,
                    indices: [index; 3],
                }));
                raster::point(brush, &self.window, &at);
                self.drawn.drawn += 1;
            }
        }
    }
}
