//! The painting of a draw call: from elements on the screen to pixels.

use super::Drawn;
use super::geometry::{Corner, Geometry, Seen};
use crate::geometry::{Element, Face, Index, Projected, Vertex};
use crate::interpolate::Interpolate;
use crate::linear::Transform;
use crate::raster::{self, Fan, Triangle, Window};
use crate::shade::Fragment;
use crate::target::{Canvas, DepthBuffer, Storage};
use crate::view::{Kind, Viewport};

/// What is the same for all of a draw call, on one canvas.
pub(super) struct Painter<'g, K, F> {
    geometry: &'g Geometry<'g, K>,
    window: Window,
    fragment: F,
    pub(super) drawn: Drawn,
}

impl<'g, K: Kind, F> Painter<'g, K, F> {
    pub(super) fn new<C, O: Storage<C>, D, const N: usize>(
        canvas: &Canvas<'_, C, O, D>,
        geometry: &'g Geometry<'g, K>,
        viewport: &Viewport,
        fragment: &F,
        model: &Transform,
    ) -> Self
    where
        F: Fragment<N, Color = C>,
    {
        Self {
            geometry,
            window: Window::new(viewport, canvas.frame_size().width, canvas.rows()),
            fragment: fragment.begin(model),
            drawn: Drawn::default(),
        }
    }

    /// The rows that may be drawn into.
    pub(super) const fn rows(&self) -> &core::ops::Range<i32> {
        &self.window.rows
    }

    /// Draws one triangle, clipped if need be.
    #[inline]
    pub(super) fn triangle<I: Interpolate, O, D, const N: usize>(
        &mut self,
        canvas: &mut Canvas<'_, F::Color, O, D>,
        element: Element,
        corners: &[Projected; 3],
    ) where
        F: Fragment<N>,
        O: Storage<F::Color>,
        D: DepthBuffer,
    {
        self.drawn.submitted += 1;
        match Geometry::<K>::seen(corners) {
            Seen::Nothing => {}
            Seen::All => self.whole::<I, O, D, N>(canvas, element, corners),
            Seen::Inside(planes) => {
                let outline = self.geometry.clip(element, planes);
                self.outline::<I, O, D, N>(canvas, element, &outline);
            }
        }
    }

    /// Draws a triangle that is all inside.
    #[inline]
    pub(super) fn whole<I: Interpolate, O, D, const N: usize>(
        &mut self,
        canvas: &mut Canvas<'_, F::Color, O, D>,
        element: Element,
        corners: &[Projected; 3],
    ) where
        F: Fragment<N>,
        O: Storage<F::Color>,
        D: DepthBuffer,
    {
        let Some(triangle) = Triangle::new(corners, self.geometry.cull, &self.window) else {
            return;
        };
        let face = self.geometry.face(element);
        let mut varyings = [0, 1, 2].map(|corner| self.varyings(&face, corner));
        let fragment = self.fragment.face(&mut varyings, &face);
        triangle.draw::<K::Mode<I>, F, O, D, N>(
            canvas,
            &self.window,
            &varyings,
            (&fragment, self.geometry.projector.depth_shift()),
            None,
        );
        self.drawn.drawn += 1;
    }

    /// Draws a clipped triangle, as a fan.
    #[inline(never)]
    pub(super) fn outline<I: Interpolate, O, D, const N: usize>(
        &mut self,
        canvas: &mut Canvas<'_, F::Color, O, D>,
        element: Element,
        outline: &[Corner],
    ) where
        F: Fragment<N>,
        O: Storage<F::Color>,
        D: DepthBuffer,
    {
        let fan = Fan::new(outline, &self.window);
        if self.geometry.cull.leaves_out(fan.area()) {
            return;
        }
        let face = self.geometry.face(element);
        let mut varyings = [0, 1, 2].map(|corner| self.varyings(&face, corner));
        let fragment = self.fragment.face(&mut varyings, &face);
        let mut drawn = false;
        for (triangle, corners, part) in fan.parts() {
            triangle.draw::<K::Mode<I>, F, O, D, N>(
                canvas,
                &self.window,
                &corners.map(|weights| weights.mix(&varyings)),
                (&fragment, self.geometry.projector.depth_shift()),
                part.as_ref(),
            );
            drawn = true;
        }
        self.drawn.drawn += u32::from(drawn);
        self.drawn.clipped += u32::from(drawn);
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
        let face = self.geometry.face(element);
        let mut varyings = [0, 1].map(|end| self.varyings(&face, end));
        if a | b != 0 {
            let Some([from, to]) = self.geometry.clip_line(element, a | b) else {
                return;
            };
            let [start, end] = varyings;
            varyings = [from, to].map(|end_at| end_at.1.mix(&[start, end, end]));
            ends = [from.0, to.0];
            self.drawn.clipped += 1;
        }
        raster::line::<K::Mode<I>, F, O, D, N>(
            canvas,
            &self.window,
            ends,
            varyings,
            (&self.fragment, self.geometry.projector.depth_shift()),
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
        let at = self.geometry.project(index);
        if at.outside != 0 {
            return;
        }
        let face = self.geometry.face(Element {
            face: None,
            indices: [index; 3],
        });
        let varyings = self.varyings(&face, 0);
        raster::point::<K::Mode<I>, F, O, D, N>(
            canvas,
            &self.window,
            &at,
            varyings,
            (&self.fragment, self.geometry.projector.depth_shift()),
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
