//! Several objects' edges in one list.

use core::iter;

use embedded_graphics::geometry::Size;

use super::edges::{self, Edge};
use super::scene::View;
use super::{EdgeList, Object, PreparedEdges, Slot};
use crate::Error;
use crate::canvas::{Canvas, DepthTest, Replace, Storage, TestAndWrite, check_size};
use crate::pipeline::cache::VertexCache;
use crate::pipeline::call::Call;
use crate::pipeline::options::PixelOptions;
use crate::pipeline::{DrawOptions, outline};
use crate::raster::Hairline;
use crate::span::{Mode, Newton};
use crate::view::{AsMvp, Perspective, ProjectionKind};

/// Several objects' edges, ready to be drawn to every band of a frame.
///
/// [`EdgeList::prepare_scene`] returns it, and [`parts`](Self::parts) yields what
/// [`Canvas::draw_prepared_edges`](crate::Canvas::draw_prepared_edges) draws.
#[derive(Debug)]
pub struct PreparedEdgeScene<
    'a,
    T,
    K = Perspective,
    M = Newton,
    Z = TestAndWrite,
    B = Replace,
    L = Hairline,
> {
    view: View<'a, T, K>,
    edges: &'a [Edge],
    vertices: &'a [Slot],
    pixels: PixelOptions<M, Z, B>,
    line: L,
}

impl<const EDGES: usize, const VERTICES: usize> EdgeList<EDGES, VERTICES> {
    /// Prepares several objects' edges, all for one `view`: a projection and a camera. If an object has an
    /// [outline](Object::outline), only those edges are prepared that
    /// [`Canvas::draw_outline`](crate::Canvas::draw_outline) would draw.
    ///
    /// The list needs room for the visible edges of all objects.
    ///
    /// ```
    /// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::{Gray4, GrayColor}};
    /// use fixel::{Object, prelude::*};
    ///
    /// static BALL: Mesh = shape!(sphere(12, 8));
    /// static SILHOUETTE: Outline = outline!(BALL, deg!(60));
    /// static BOX: Mesh = shape!(cuboid(vec3!(1, 1, 1)));
    /// const SIZE: (u32, u32) = (24, 12);
    ///
    /// let view = Projection::perspective(deg!(50), SIZE, fx!(1), fx!(20))?
    ///     * Camera::look_at(vec3!(0, 1, 5), Vec3::ZERO, Vec3::Y)?;
    /// let flat = |gray| Flat::new(Gray4::new(gray));
    /// let mut objects = [
    ///     Object::new(&BALL, Transform::translate(vec3!(-1.4, 0, 0)), flat(3)).with_outline(&SILHOUETTE),
    ///     Object::new(&BOX, Transform::translate(vec3!(0.8, 0, 0)), flat(7)),
    /// ];
    /// let mut list: EdgeList<100, 100> = EdgeList::new(); // on a microcontroller, a static
    /// let scene = list.prepare_scene(&DrawOptions::new(), SIZE, &view, &mut objects)?;
    ///
    /// let mut display = MockDisplay::new();
    /// let mut color = [Gray4::BLACK; 24 * 4];
    /// for first_row in [0, 4, 8] {
    ///     let mut band = Canvas::band(&mut color, 24, 12, first_row)?;
    ///     band.clear(Gray4::BLACK);
    ///     for (shader, edges) in scene.parts(&band)? {
    ///         band.draw_prepared_edges(&edges, shader)?;
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
    ///     "000000033307000077000000",
    ///     "000000000007777777000000",
    ///     "000000000000000000000000",
    ///     "000000000000000000000000",
    /// ]);
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// As for [`prepare`](Self::prepare).
    #[allow(clippy::type_complexity)] // it is written here alone
    pub fn prepare_scene<'a, 'm: 'a, M: Mode, Z: DepthTest, B: Copy, L: Copy, V: AsMvp, T>(
        &'a mut self,
        options: &DrawOptions<M, Z, B, L>,
        frame: impl Into<Size>,
        view: &V,
        objects: &'a mut [Object<'m, T>],
    ) -> Result<PreparedEdgeScene<'a, T, V::Kind, M, Z, B, L>, Error> {
        let frame = frame.into();
        check_size(frame.width, frame.height)?;
        self.edges.clear();
        self.vertices.clear();
        let lists = (&mut self.edges, &mut self.vertices);
        let screen = options.screen(frame);
        let (view, needed) = View::prepare(screen, view, objects, |call, object, needed| {
            let lists = (lists.0.as_mut_view(), lists.1.as_mut_view());
            if let Some(outline) = object.outline {
                let edges = (outline.edges(), outline::ends_of(outline));
                edges::add(call, edges, lists, needed);
            } else {
                let all = |_: &Call<'_, _>, _: &mut VertexCache, _, &edge: &_| Some(edge);
                edges::add(call, (object.mesh.edges(), all), lists, needed);
            }
        });
        needed.check::<EDGES, VERTICES>("edges")?;
        Ok(PreparedEdgeScene {
            view,
            edges: &self.edges,
            vertices: &self.vertices,
            pixels: options.pixels,
            line: options.line,
        })
    }
}

impl<'a, T, K: ProjectionKind, M: Mode, Z: DepthTest, B: Copy, L: Copy>
    PreparedEdgeScene<'a, T, K, M, Z, B, L>
{
    /// The edges of each object that has visible ones, with the object's material.
    ///
    /// # Errors
    ///
    /// [`Error::Frame`] if the canvas belongs to a frame of another size than the one that the scene was prepared for.
    #[allow(clippy::type_complexity)] // it is written here alone
    pub fn parts<'s, C, O: Storage<C>, D>(
        &'s self,
        canvas: &Canvas<'_, C, O, D>,
    ) -> Result<
        impl Iterator<Item = (&'s T, PreparedEdges<'s, K, M, Z, B, L>)>
        + use<'s, 'a, T, K, M, Z, B, L, C, O, D>,
        Error,
    > {
        self.view.screen.check(canvas.frame_size())?;
        let mut rest = self.edges;
        Ok(iter::from_fn(move || {
            let (object, numbers) = self.view.object_of(rest.first()?.first())?;
            let is_other = |edge: &Edge| !numbers.contains(&u32::from(edge.first()));
            let length = rest.iter().position(is_other).unwrap_or(rest.len());
            let (edges, others) = rest.split_at_checked(length)?;
            rest = others;
            let all = match object.outline {
                Some(outline) => outline.edges().len(),
                None => object.mesh.edges().len(),
            };
            Some((
                &object.material,
                PreparedEdges {
                    call: self.view.call(object),
                    submitted: all as u32,
                    edges,
                    vertices: self.vertices,
                    pixels: self.pixels,
                    line: self.line,
                },
            ))
        }))
    }
}
