//! A list that is ready to be drawn.

#![allow(private_interfaces)] // of traits that only this crate calls

use core::cell::Cell;
use core::iter;
use core::marker::PhantomData;
use core::ops::Range;
use core::ptr;

use embedded_graphics::geometry::Size;
use embedded_graphics::pixelcolor::PixelColor;

use super::{Corners, Entry, Filling, Listed, Listing, NO_ROWS, Scene};
use crate::canvas::{Blending, Canvas, DepthBuffer, DepthTest, Storage};
use crate::error::Error;
use crate::math::Transform;
use crate::mesh::{Indices, Mesh, Placement};
use crate::pipeline::call::{Region, Screen};
use crate::pipeline::clip::ClippedPolygon;
use crate::pipeline::edges::EdgesOf;
use crate::pipeline::thing::{DrawLine, Thing};
use crate::pipeline::{DrawOptions, Drawn, corner_cache, keeps_corners};
use crate::raster::{
    self, Barycentric, Blitter, ClippedVertex, Cull, DepthShift, Polygon, Rasterizer, Scissor,
    ScreenVertex,
};
use crate::sealed::Sealed;
use crate::shade::ShaderFor;
use crate::span::{Blit, Mode};
use crate::view::{AsMvp, Mvp, Perspective, ProjectionKind};

/// An object of a scene: a mesh or edges, its model transform, and its material.
///
/// The material is any value that says how to draw the object: a shader, or a value by which your program chooses a
/// shader.
///
/// [`DrawList::prepare`](crate::DrawList::prepare) prepares a slice of objects, and stores in each object which
/// triangles or edges of the list belong to it. For triangles and edges in one list, see
/// [`FacesOrEdges`](crate::FacesOrEdges).
///
/// ```
/// use fixel::prelude::*;
/// static BOX: Mesh = shape!(cuboid(vec3!(1, 1, 1)));
/// let mut crate_ = Object::new(&BOX, Transform::IDENTITY, "wood");
/// crate_.model = Transform::rotate_y(deg!(30)); // in the next frame
/// assert_eq!(crate_.material, "wood");
/// ```
///
/// The lifetime `'a` is how long the mesh is borrowed: `'static` for a mesh in flash, and a shorter lifetime for a mesh
/// that is made at run time.
///
/// ```
/// use fixel::prelude::*;
/// struct Scene<'a> {
///     objects: [Object<'a, &'static str>; 1],
/// }
/// let (positions, faces) = ([Vec3::X, Vec3::Y, Vec3::Z], [[0, 1, 2]]);
/// let leaf = Mesh::new(&positions, &faces)?;
/// let scene = Scene { objects: [Object::new(&leaf, Transform::IDENTITY, "paper")] };
/// # assert_eq!(scene.objects[0].material, "paper");
/// # Ok::<(), Error>(())
/// ```
///
/// All objects of a slice have the same type of material. For different shaders, make the material a trait object
/// (`&dyn`) of a trait of your own. The example prepares with the default options. Other options change the type of
/// `triangles`: in mode `Fast`, it is `&Prepared<(), &Mesh, DrawOptions<Fast>>`.
///
/// ```
/// use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
/// use fixel::{NormalView, Object, Prepared, prelude::*, canvas::{LinearDepth, Native}};
/// static BOX: Mesh = shape!(cuboid(vec3!(1, 1, 1)));
/// static BALL: Mesh = shape!(sphere(16, 12));
///
/// type Band<'a, 'd> = Canvas<'a, Rgb565, Native, LinearDepth>;
///
/// trait Material {
///     fn draw(&self, band: &mut Band, triangles: &Prepared) -> Result<Drawn, Error>;
/// }
///
/// impl<S: ShaderFor<Rgb565>> Material for S {
///     fn draw(&self, band: &mut Band, triangles: &Prepared) -> Result<Drawn, Error> {
///         band.draw_prepared(triangles, self)
///     }
/// }
///
/// fn draw(scene: &Prepared<&dyn Material>, band: &mut Band) -> Result<(), Error> {
///     for (material, triangles) in scene.parts(band)? {
///         material.draw(band, &triangles)?;
///     }
///     Ok(())
/// }
///
/// let (red, normals) = (Flat::new(Rgb565::RED), NormalView::new());
/// let objects: [Object<&dyn Material>; 2] = [
///     Object::new(&BOX, Transform::translate(vec3!(-1, 0, 0)), &red),
///     Object::new(&BALL, Transform::translate(vec3!(1, 0, 0)), &normals),
/// ];
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Object<'a, T, G = &'a Mesh<'a>> {
    /// A mesh, or edges of a mesh.
    pub thing: G,
    /// The transform from model space to world space.
    pub model: Transform,
    /// How the object is drawn.
    pub material: T,
    listing: Listing,
    /// The lifetime of the mesh, if `G` is not written.
    mesh: PhantomData<&'a Mesh<'a>>,
}

impl<T, G> Object<'_, T, G> {
    /// An object that `model` places in the world: a mesh, [`mesh.edges(style)`](Mesh::edges) or
    /// [`mesh.outline(&outline, style)`](Mesh::outline).
    #[must_use]
    pub const fn new(thing: G, model: Transform, material: T) -> Self {
        Self {
            thing,
            model,
            material,
            listing: Listing {
                first: 0,
                rows: NO_ROWS,
                culled: 0,
                depth_shift: DepthShift(0),
            },
            mesh: PhantomData,
        }
    }
}

/// A thing in a list, with its transforms.
#[derive(Clone, Copy, Debug)]
pub struct Placed<G> {
    pub(super) thing: G,
    /// The transform from model space to world space.
    pub(super) model: Transform,
    /// From model to eye space.
    pub(super) view: Transform,
    pub(super) listing: Listing,
}

impl<G: Listed> Placed<G> {
    /// A draw call of some elements of the thing.
    #[inline]
    pub(super) fn run<'r>(
        &'r self,
        (screen, rows): Region<'_>,
        entries: &'r [Entry],
        vertices: &'r [ScreenVertex],
    ) -> Run<'r> {
        Run {
            placement: Placement::new(self.thing.mesh(), &self.model, self.view),
            cull: screen.cull.mirrored(self.view.is_mirror),
            scissor: screen.scissor(rows),
            entries,
            vertices,
            listing: &self.listing,
        }
    }
}

/// The things in a list.
#[derive(Clone, Copy, Debug)]
pub enum Objects<'a, G, T> {
    One(Placed<G>, T),
    Many {
        objects: &'a [Object<'a, T, G>],
        /// The transform that is applied after each object's own transform.
        world: Transform,
        camera: Transform,
    },
}

impl<G, T> Objects<'_, G, T> {
    /// The data that the list keeps about the thing to which an element belongs.
    pub(super) fn listing(&self, element: u32) -> Option<&Listing> {
        match self {
            Self::One(placed, _) => Some(&placed.listing),
            Self::Many { objects, .. } => Some(&objects.get(object_of(objects, element))?.listing),
        }
    }
}

/// The index of the object to which an element belongs.
fn object_of<T, G>(objects: &[Object<'_, T, G>], element: u32) -> usize {
    // The last object that does not begin after the element. An object without elements begins at the same index as the
    // next object.
    let after = objects.partition_point(|object| object.listing.first <= element);
    after.wrapping_sub(1)
}

impl<T, G> Sealed for &mut [Object<'_, T, G>] {}
impl<T, G, const COUNT: usize> Sealed for &mut [Object<'_, T, G>; COUNT] {}

impl<'a, T, G: Listed> Scene<'a> for &'a mut [Object<'_, T, G>] {
    type Thing = G;
    type Material = T;

    #[inline]
    fn list<V: AsMvp>(self, filling: &mut Filling<'_>, view: &V) -> Objects<'a, G, T> {
        let (projection, camera) = (*view.projection_of(), *view.camera_of());
        let world = *view.model_of();
        for object in &mut *self {
            let model = world * object.model;
            let mvp = Mvp {
                projection,
                camera,
                model,
            };
            object.listing = filling.thing(&object.thing, &mvp);
        }
        Objects::Many {
            objects: self,
            world,
            camera,
        }
    }
}

impl<'a, T, G: Listed, const COUNT: usize> Scene<'a> for &'a mut [Object<'_, T, G>; COUNT] {
    type Thing = G;
    type Material = T;

    #[inline]
    fn list<V: AsMvp>(self, filling: &mut Filling<'_>, view: &V) -> Objects<'a, G, T> {
        self.as_mut_slice().list(filling, view)
    }
}

/// A mesh, edges or several objects, ready to be drawn to every band of a frame.
///
/// [`DrawList::prepare`](crate::DrawList::prepare) returns it, and
/// [`Canvas::draw_prepared`](crate::Canvas::draw_prepared) draws it. For objects with materials, [`parts`](Self::parts)
/// yields one object after the other.
///
/// `T` is the type of the materials, `G` is the type of the listed things, `O` is the type of the options, and `K` is
/// the kind of projection. A `Prepared` can be shared with another core that draws other bands of the same frame.
///
/// ```
/// use fixel::{Prepared, prelude::*};
/// fn is_shared<T: Sync>() {}
/// is_shared::<Prepared<'static>>();
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Prepared<'a, T = (), G = &'a Mesh<'a>, O = DrawOptions, K = Perspective> {
    pub(super) objects: Objects<'a, G, T>,
    pub(super) entries: &'a [Entry],
    pub(super) vertices: &'a [ScreenVertex],
    /// The frame that the list was prepared for.
    pub(super) screen: Screen,
    pub(super) options: O,
    pub(super) kind: PhantomData<K>,
}

impl<'a, T, G: Listed, O, K> Prepared<'a, T, G, O, K> {
    /// The objects of the scene, in the order of their slice. The slice is empty if a mesh or edges were prepared
    /// alone. As long as a `Prepared` borrows the objects, read their transforms with this method:
    ///
    /// ```
    /// use embedded_graphics::pixelcolor::{Gray8, GrayColor};
    /// use fixel::prelude::*;
    /// static BALL: Mesh = shape!(sphere(12, 8));
    /// let camera = Camera::look_at(Vec3::ZERO, vec3!(0, 0, -1), Vec3::Y)?;
    /// let view = Projection::perspective(deg!(60), (16, 12), fx!(1), fx!(10))? * camera;
    /// let options = DrawOptions::new();
    /// let mut objects = [Object::new(&BALL, Transform::translate(vec3!(0, 0, -3)), "ball")];
    /// let mut list: DrawList<200, 100> = DrawList::new();
    /// let scene = list.prepare(&options, (16, 12), &mut objects, &view)?;
    /// let mut color = [Gray8::BLACK; 16 * 4];
    /// for first_row in [0, 4, 8] {
    ///     let band = Canvas::band(&mut color, 16, 12, first_row)?;
    ///     let ball = &scene.objects()[0];
    ///     let place = band.viewport().project(Vec3::ZERO, &(view * ball.model));
    ///     assert_eq!((ball.material, place.map(|at| at.x.round())), ("ball", Some(8)));
    /// }
    /// # Ok::<(), Error>(())
    /// ```
    #[must_use]
    pub const fn objects(&self) -> &'a [Object<'a, T, G>] {
        match &self.objects {
            Objects::One(..) => &[],
            Objects::Many { objects, .. } => objects,
        }
    }

    /// The options with which the list was prepared and is drawn.
    #[must_use]
    pub const fn options(&self) -> &O {
        &self.options
    }

    /// The parts of the list to draw in a canvas's rows, in drawing order, each with its object's material. In a sorted
    /// list, a part holds consecutive triangles or edges of one object; otherwise, a part is a whole object. Parts
    /// without pixels in these rows may be missing.
    ///
    /// # Errors
    ///
    /// [`Error::SizeDiffers`] if the canvas's frame differs in size from the frame that the list was prepared for.
    #[allow(clippy::type_complexity)] // it is written here alone
    pub fn parts<'s, C, S: Storage<C>, D>(
        &'s self,
        canvas: &Canvas<'_, C, S, D>,
    ) -> Result<
        impl Iterator<Item = (&'s T, Prepared<'s, (), G, O, K>)> + use<'s, 'a, T, G, O, K, C, S, D>,
        Error,
    >
    where
        O: Copy,
    {
        self.screen.check(canvas.frame_size())?;
        Ok(self.runs(canvas.rows()).map(|(material, placed, entries)| {
            let part = Prepared {
                objects: Objects::One(placed, ()),
                entries,
                vertices: self.vertices,
                screen: self.screen,
                options: self.options,
                kind: PhantomData,
            };
            (material, part)
        }))
    }

    /// Calls `draw` for the elements of each thing that may have pixels in `rows` of a canvas's frame. `keeps` tells
    /// whether shading [keeps](crate::Shader::KEEPS_CORNERS) what it computes at corners.
    #[inline]
    pub(in crate::pipeline) fn each_run(
        &self,
        frame: Size,
        (rows, keeps): (&Range<u32>, bool),
        mut draw: impl FnMut(&G, &Run<'_>),
    ) -> Result<(), Error> {
        self.screen.check(frame)?;
        for (_, placed, entries) in self.runs(rows) {
            let corners = corner_cache(keeps, entries.len());
            let mut run = placed.run((&self.screen, rows), entries, self.vertices);
            run.placement.corners = corners.as_ref();
            // A band that the thing misses costs one test.
            if !meets(placed.listing.rows, G::REACH, &run.scissor.rows) {
                run.entries = &[];
            }
            draw(&placed.thing, &run);
        }
        Ok(())
    }

    /// Runs of consecutive elements of one thing. Each run of an object begins with an element that may have pixels in
    /// `rows`. A thing that was prepared alone is a single run.
    #[inline]
    pub(super) fn runs<'s>(
        &'s self,
        rows: &Range<u32>,
    ) -> impl Iterator<Item = (&'s T, Placed<G>, &'a [Entry])> + use<'s, 'a, T, G, O, K> {
        let rows = rows.start.cast_signed()..rows.end.cast_signed();
        let mut rest = Some(self.entries);
        iter::from_fn(move || match &self.objects {
            Objects::One(placed, material) => Some((material, *placed, rest.take()?)),
            Objects::Many {
                objects,
                world,
                camera,
            } => {
                let entries = rest?;
                let start = entries
                    .iter()
                    .position(|entry| meets(entry.rows(), G::REACH, &rows))?;
                let entries = entries.get(start..)?;
                let at = object_of(objects, entries.first()?.element);
                let next = objects.get(at.wrapping_add(1));
                let end = next.map_or(u32::MAX, |next| next.listing.first);
                let object = objects.get(at)?;
                let own = object.listing.first..end;
                let length = entries
                    .iter()
                    .position(|entry| !own.contains(&entry.element));
                let (entries, others) =
                    entries.split_at_checked(length.unwrap_or(entries.len()))?;
                rest = Some(others);
                let model = *world * object.model;
                let placed = Placed {
                    thing: object.thing,
                    model,
                    view: *camera * model,
                    listing: object.listing,
                };
                Some((&object.material, placed, entries))
            }
        })
    }
}

impl<'a, T, G, M: Copy, Z: Copy, B: Copy, K> Prepared<'a, T, G, DrawOptions<M, Z, B>, K> {
    /// The same triangles or edges, drawn with another blending. Use this method for a sorted scene in which some
    /// objects are translucent.
    ///
    /// ```
    /// use embedded_graphics::pixelcolor::{Gray8, GrayColor};
    /// use fixel::{prelude::*, canvas::Opacity};
    /// static BOX: Mesh = shape!(cuboid(vec3!(1, 1, 1)));
    /// let projection = Projection::perspective(deg!(60), (2, 1), fx!(1), fx!(10))?;
    /// let mvp = projection * Transform::translate(vec3!(0, 0, -3));
    /// let mut list: DrawList<12, 24> = DrawList::new();
    /// let opaque = list.prepare(&DrawOptions::new(), (24, 12), &BOX, &mvp)?;
    /// let glass = opaque.with_blending(Opacity(90));
    /// let mut pixels = [Gray8::new(100); 24 * 12];
    /// let mut canvas = Canvas::new(&mut pixels, 24, 12)?;
    /// canvas.draw_prepared(&glass, &Flat::new(Gray8::new(255)))?;
    /// assert!(canvas.pixels().any(|pixel| (101..255).contains(&pixel.luma())));
    /// # Ok::<(), Error>(())
    /// ```
    #[must_use]
    pub fn with_blending<A: Copy>(
        self,
        blending: A,
    ) -> Prepared<'a, T, G, DrawOptions<M, Z, A>, K> {
        Prepared {
            objects: self.objects,
            entries: self.entries,
            vertices: self.vertices,
            screen: self.screen,
            options: self.options.with_blending(blending),
            kind: PhantomData,
        }
    }
}

impl<C: PixelColor, O: Storage<C>, D: DepthBuffer> Canvas<'_, C, O, D> {
    /// Draws the part of a [prepared](crate::DrawList::prepare) list that is in this canvas's rows. The pixels are the
    /// same as with [`draw_with`](Self::draw_with), but nothing is transformed again. If several objects were prepared,
    /// all are drawn with this shader; to draw each object with its own shader, see [`Prepared::parts`].
    ///
    /// # Errors
    ///
    /// [`Error::SizeDiffers`] if the canvas's frame differs in size from the frame that the list was prepared for.
    pub fn draw_prepared<G, M, Z, B, K>(
        &mut self,
        prepared: &Prepared<'_, impl Sized, G, DrawOptions<M, Z, B>, K>,
        shader: &impl ShaderFor<C>,
    ) -> Result<Drawn, Error>
    where
        G: Listed + Thing<C>,
        M: Mode,
        Z: DepthTest,
        B: Blending<C>,
        K: ProjectionKind,
    {
        let rows = self.rows().clone();
        let coverage = Cell::default();
        let options = &prepared.options;
        let shading = G::Shading::from((options.shading(*shader), &coverage));
        let mut drawn = Drawn::default();
        prepared.each_run(
            self.frame_size(),
            (&rows, keeps_corners(shader)),
            |thing, run| {
                let mut blit = Blit::<_, _, _, K, _>::new(options.mode, self, shading);
                drawn += thing.draw_listed(run, &mut blit, &coverage);
            },
        )?;
        Ok(drawn)
    }
}

/// Whether an element may have pixels in `rows`, if it reaches up to `reach` rows beyond its own rows, `start` to
/// `end`.
#[inline]
fn meets([start, end]: [i16; 2], reach: i32, rows: &Range<i32>) -> bool {
    i32::from(start) - reach < rows.end && rows.start < i32::from(end) + reach
}

/// A draw call of some elements of one thing in a list.
pub struct Run<'r> {
    pub(super) placement: Placement<'r>,
    cull: Cull,
    pub(in crate::pipeline) scissor: Scissor,
    entries: &'r [Entry],
    vertices: &'r [ScreenVertex],
    listing: &'r Listing,
}

impl<'r> Run<'r> {
    #[inline]
    fn rasterizer<'b>(&'b self, blitter: &'b mut dyn Blitter) -> Rasterizer<'b> {
        let shift = self.listing.depth_shift;
        Rasterizer::new(blitter, shift, &self.placement, &self.scissor)
    }

    /// The elements within `reach` rows of the rows to draw. Each comes with its index in the thing.
    #[inline]
    fn elements(&self, reach: i32) -> impl Iterator<Item = (usize, &'r Entry)> + use<'r> {
        let (rows, first) = (self.scissor.rows.clone(), self.listing.first);
        let entries = self.entries.iter();
        let met = entries.filter(move |entry| meets(entry.rows(), reach, &rows));
        met.map(move |entry| (entry.element.wrapping_sub(first) as usize, entry))
    }

    #[inline(never)]
    pub(super) fn draw_triangles(&self, blitter: &mut dyn Blitter) -> Drawn {
        let faces = self.placement.mesh.faces();
        let mut raster = self.rasterizer(blitter);
        for (face, entry) in self.elements(0) {
            let Some(&indices) = faces.get(face) else {
                continue;
            };
            raster.next_entry(ptr::from_ref(entry).addr());
            let indices = Indices::of_face(face, indices);
            match entry.corners {
                Corners::Whole([a, b, c]) => {
                    let corners = (self.vertex(a), self.vertex(b), self.vertex(c));
                    if let (Some(a), Some(b), Some(c)) = corners {
                        let corners = [a, b, c];
                        let area = raster::area(&ScreenVertex::screens(corners));
                        raster.draw_whole(indices, corners, area);
                    }
                }
                Corners::Edge { .. } => {}
                Corners::Clipped { first, count, .. } => {
                    raster.draw_clipped(indices, &self.polygon(first, count), self.cull);
                }
            }
        }
        self.drawn(faces.len(), &raster)
    }

    /// Draws edges, each by `line`. A line reaches up to `reach` rows beyond the rows of its ends.
    #[inline(never)]
    pub(in crate::pipeline) fn draw_edges(
        &self,
        edges: EdgesOf<'_>,
        reach: i32,
        line: DrawLine<'_>,
        blitter: &mut dyn Blitter,
    ) -> Drawn {
        let mut raster = self.rasterizer(blitter);
        for (edge, entry) in self.elements(reach) {
            let (is_clipped, beside) = match entry.corners {
                Corners::Whole(_) => continue,
                Corners::Edge { beside, .. } => (false, beside),
                Corners::Clipped { beside, .. } => (true, beside),
            };
            let Some(indices) = edges.indices(edge) else {
                continue;
            };
            if let Some([from, to]) = &self.ends(entry.corners) {
                raster.next_entry(ptr::from_ref(entry).addr());
                raster.next_thin(indices, beside, is_clipped);
                line(&mut raster, [from, to]);
            }
        }
        if edges.count() == 0 {
            self.placement.lacks_edges();
        }
        self.drawn(edges.count(), &raster)
    }

    /// The result of a draw call of a thing with `submitted` elements.
    #[inline]
    fn drawn(&self, submitted: usize, raster: &Rasterizer<'_>) -> Drawn {
        let counts = [submitted as u32, self.listing.culled];
        Drawn::new(counts, raster, &self.placement)
    }

    /// Twice the area of a triangle on the screen; 0 for an edge. If culling has left only areas of one sign, the
    /// result is 1 or -1, with this sign.
    pub(super) fn area(&self, corners: Corners) -> i64 {
        match (self.cull, corners) {
            (_, Corners::Edge { .. }) => 0,
            (Cull::Back, _) => -1,
            (Cull::Front, _) => 1,
            (Cull::Nothing, Corners::Whole([a, b, c])) => {
                match (self.vertex(a), self.vertex(b), self.vertex(c)) {
                    (Some(a), Some(b), Some(c)) => raster::area(&ScreenVertex::screens([a, b, c])),
                    _ => 0,
                }
            }
            (Cull::Nothing, Corners::Clipped { first, count, .. }) => {
                Polygon::area(&self.polygon(first, count))
            }
        }
    }

    /// The vertex of this number.
    #[inline]
    fn vertex(&self, number: u16) -> Option<&'r ScreenVertex> {
        self.vertices.get(usize::from(number).wrapping_sub(1))
    }

    /// The ends of an edge.
    #[inline]
    fn ends(&self, corners: Corners) -> Option<[ClippedVertex; 2]> {
        let (from, to) = match corners {
            Corners::Whole(_) => return None,
            Corners::Edge { ends: [a, b], .. } => (self.vertex(a)?, self.vertex(b)?),
            Corners::Clipped { first, count, .. } => {
                return self.polygon(first, count).first_chunk().copied();
            }
        };
        let [a, b, _] = Barycentric::CORNERS;
        let end = |vertex: &ScreenVertex, barycentric| ClippedVertex {
            vertex: *vertex,
            barycentric,
        };
        Some([end(from, a), end(to, b)])
    }

    /// The corners of a clipped triangle, or the ends of a clipped edge.
    fn polygon(&self, first: u16, count: u16) -> ClippedPolygon {
        let start = usize::from(first).wrapping_sub(1);
        let corners = self
            .vertices
            .get(start..start.wrapping_add(usize::from(2 * count)));
        let mut polygon = ClippedPolygon::new();
        for pair in corners.unwrap_or_default().chunks_exact(2) {
            if let [vertex, stored] = pair {
                // There is room, because clipping made no more corners than fit.
                let _ = polygon.push(ClippedVertex {
                    vertex: *vertex,
                    barycentric: Barycentric::from_stored(stored),
                });
            }
        }
        polygon
    }
}
