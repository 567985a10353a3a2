//! Several objects in one list.

use core::marker::PhantomData;
use core::ops::Range;

use embedded_graphics::geometry::Size;

use super::triangles::{Corners, Entry, fill};
use super::{Needed, Prepared, PreparedCall, Slot, TriangleList, painter};
use crate::canvas::{Canvas, DepthTest, Replace, Storage, TestAndWrite, check_size};
use crate::mesh::{Mesh, Outline};
use crate::pipeline::DrawOptions;
use crate::pipeline::call::{Call, Screen};
use crate::pipeline::options::PixelOptions;
use crate::raster::DepthShift;
use crate::span::{Mode, Newton};
use crate::view::{AsMvp, Mvp, Perspective, ProjectionKind};
use crate::{Error, Transform};

/// An object of a scene: a mesh, its model transform, and its material.
///
/// The material is any value that says how to draw the object: a shader, or a value of your own by which you choose
/// one.
///
/// [`TriangleList::prepare_scene`] and [`EdgeList::prepare_scene`](super::EdgeList::prepare_scene) prepare a slice of
/// objects, and note in it which vertices are whose. So triangles and edges of one frame need a slice each: copy it.
///
/// ```
/// use fixel::{Object, prelude::*};
/// static BOX: Mesh = shape!(cuboid(vec3!(1, 1, 1)));
/// let mut crate_ = Object::new(&BOX, Transform::IDENTITY, "wood");
/// crate_.model = Transform::rotate_y(deg!(30)); // in the next frame
/// assert_eq!(crate_.material, "wood");
/// ```
///
/// All objects of a slice have one type of material. For different shaders, let it be a trait of your own. (The types
/// below are those of the default options; in mode `Fast`, for example, the triangles are a
/// `Prepared<Perspective, Fast>`.)
///
/// ```
/// use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
/// use fixel::{Object, Prepared, PreparedScene, prelude::*, canvas::{LinearDepth, Native}};
/// static BOX: Mesh = shape!(cuboid(vec3!(1, 1, 1)));
/// static BALL: Mesh = shape!(sphere(16, 12));
///
/// type Band<'a> = Canvas<'a, Rgb565, Native, LinearDepth>;
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
/// fn draw(scene: &PreparedScene<&dyn Material>, band: &mut Band) -> Result<(), Error> {
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
pub struct Object<'m, T> {
    /// The mesh.
    pub mesh: &'m Mesh<'m>,
    /// From model to world space.
    pub model: Transform,
    /// How the object is drawn.
    pub material: T,
    /// The edges of the object that an [`EdgeList`](super::EdgeList) draws; all edges if it is `None`. Triangles do not
    /// depend on it.
    pub outline: Option<&'m Outline<'m>>,
    /// The number of its last vertex in the list.
    last: u16,
    depth_shift: DepthShift,
    /// How many faces the objects before it have.
    first_face: u32,
}

impl<'m, T> Object<'m, T> {
    /// An object that `model` places in the world.
    #[must_use]
    pub const fn new(mesh: &'m Mesh<'m>, model: Transform, material: T) -> Self {
        Self {
            mesh,
            model,
            material,
            outline: None,
            last: 0,
            depth_shift: DepthShift(0),
            first_face: 0,
        }
    }

    /// Gives it an outline, which is drawn in place of all edges.
    #[must_use]
    pub const fn with_outline(mut self, outline: &'m Outline<'m>) -> Self {
        self.outline = Some(outline);
        self
    }
}

/// A view of several objects, for which a list was prepared.
#[derive(Debug)]
pub(super) struct View<'a, T, K> {
    objects: &'a [Object<'a, T>],
    /// The factor of the objects' transforms.
    world: Transform,
    camera: Transform,
    kind: PhantomData<K>,
    pub(super) screen: Screen,
}

impl<'a, T, K: ProjectionKind> View<'a, T, K> {
    /// Prepares each of the objects by `prepare`, which adds to what the list needs.
    #[inline]
    pub(super) fn prepare<'m: 'a, V: AsMvp<Kind = K>>(
        screen: Screen,
        view: &V,
        objects: &'a mut [Object<'m, T>],
        mut prepare: impl FnMut(&Call<'_, K>, &Object<'m, T>, &mut Needed),
    ) -> (Self, Needed) {
        let view = Mvp {
            projection: *view.projection_of(),
            camera: *view.camera_of(),
            model: *view.model_of(),
        };
        let (mut needed, mut faces) = (Needed::default(), 0_u32);
        for object in &mut *objects {
            let mvp = view * object.model;
            let call = Call::new(&screen, &(0..screen.frame.height), object.mesh, &mvp);
            prepare(&call, object, &mut needed);
            object.last = needed.vertices as u16;
            object.depth_shift = call.projector.depth_shift();
            object.first_face = faces;
            faces = faces.wrapping_add(object.mesh.faces().len() as u32);
        }
        let view = Self {
            objects,
            world: view.model,
            camera: view.camera,
            kind: PhantomData,
            screen,
        };
        (view, needed)
    }

    /// The object that a vertex of this number belongs to, and the numbers of the object's vertices.
    pub(super) fn object_of(&self, number: u16) -> Option<(&'a Object<'a, T>, Range<u32>)> {
        let at = self.objects.partition_point(|object| object.last < number);
        let object = self.objects.get(at)?;
        let before = self.objects.get(at.wrapping_sub(1));
        let start = before.map_or(0, |before| u32::from(before.last));
        Some((object, start + 1..u32::from(object.last) + 1))
    }

    /// The draw call of an object.
    pub(super) fn call(&self, object: &Object<'a, T>) -> PreparedCall<'a, K> {
        let model = self.world * object.model;
        PreparedCall {
            mesh: object.mesh,
            model,
            model_view: self.camera * model,
            kind: PhantomData,
            screen: self.screen,
            depth_shift: object.depth_shift,
        }
    }
}

/// Several objects' triangles, ready to be drawn to every band of a frame.
///
/// [`TriangleList::prepare_scene`] returns it, and [`parts`](Self::parts) yields what
/// [`Canvas::draw_prepared`](crate::Canvas::draw_prepared) draws.
///
/// It can be shared with another core that draws other bands of the same frame.
#[derive(Debug)]
pub struct PreparedScene<'a, T, K = Perspective, M = Newton, Z = TestAndWrite, B = Replace> {
    view: View<'a, T, K>,
    entries: &'a mut [Entry],
    vertices: &'a [Slot],
    pixels: PixelOptions<M, Z, B>,
}

impl<const TRIANGLES: usize, const VERTICES: usize> TriangleList<TRIANGLES, VERTICES> {
    /// Prepares several objects' triangles like [`prepare`](Self::prepare), all for one `view`: a projection and a
    /// camera.
    ///
    /// The list needs room for the visible triangles of all objects.
    ///
    /// ```
    /// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::{Gray4, GrayColor}};
    /// use fixel::{Object, prelude::*};
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
    /// let mut list: TriangleList<100, 100> = TriangleList::new(); // on a microcontroller, a static
    /// let mut scene = list.prepare_scene(&DrawOptions::new(), SIZE, &view, &mut objects)?;
    /// scene.sort_back_to_front(); // no depth buffer
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
    /// As for [`prepare`](Self::prepare).
    pub fn prepare_scene<'a, 'm: 'a, M: Mode, Z: DepthTest, B: Copy, V: AsMvp, T>(
        &'a mut self,
        options: &DrawOptions<M, Z, B>,
        frame: impl Into<Size>,
        view: &V,
        objects: &'a mut [Object<'m, T>],
    ) -> Result<PreparedScene<'a, T, V::Kind, M, Z, B>, Error> {
        let frame = frame.into();
        check_size(frame.width, frame.height)?;
        self.triangles.clear();
        self.vertices.clear();
        let lists = (&mut self.triangles, &mut self.vertices);
        let screen = options.screen(frame);
        let (view, needed) = View::prepare(screen, view, objects, |call, _, needed| {
            fill((lists.0.as_mut_view(), lists.1.as_mut_view()), call, needed);
        });
        needed.check::<TRIANGLES, VERTICES>("triangles")?;
        Ok(PreparedScene {
            view,
            entries: &mut self.triangles,
            vertices: &self.vertices,
            pixels: options.pixels,
        })
    }
}

impl Entry {
    /// The number of its first vertex, by which its object is found.
    const fn first(&self) -> u16 {
        match self.corners {
            Corners::Whole([first, ..]) | Corners::Clipped { first, .. } => first,
        }
    }
}

impl<'a, T, K: ProjectionKind, M: Mode, Z: DepthTest, B: Copy> PreparedScene<'a, T, K, M, Z, B> {
    /// Sorts the triangles of all objects back to front, as
    /// [`prepare_back_to_front`](TriangleList::prepare_back_to_front) does. Equally far triangles are in the order of
    /// the objects.
    pub fn sort_back_to_front(&mut self) {
        let screen = self.view.screen;
        let scissor = screen.scissor(&(0..screen.frame.height));
        for entry in &mut *self.entries {
            if let Some((object, _)) = self.view.object_of(entry.first()) {
                // Counted through all objects, faces are in the order of the objects.
                entry.face = entry.face.wrapping_add(object.first_face);
                painter::set_nearness(entry, self.vertices, object.depth_shift);
            }
        }
        painter::heap_sort(self.entries);
        for entry in &mut *self.entries {
            if let Some((object, _)) = self.view.object_of(entry.first()) {
                entry.face = entry.face.wrapping_sub(object.first_face);
                painter::set_rows(entry, self.vertices, &scissor.rows);
            }
        }
    }

    /// The triangles that meet a canvas's rows, in the order in which they are to be drawn. Each part holds consecutive
    /// triangles of one object, and comes with the object's material. Unless the scene is sorted, each object is one
    /// part.
    ///
    /// # Errors
    ///
    /// [`Error::Frame`] if the canvas belongs to a frame of another size than the one that the scene was prepared for.
    #[allow(clippy::type_complexity)] // it is written here alone
    pub fn parts<'s, C, O: Storage<C>, D>(
        &'s self,
        canvas: &Canvas<'_, C, O, D>,
    ) -> Result<
        impl Iterator<Item = (&'s T, Prepared<'s, K, M, Z, B>)> + use<'s, 'a, T, K, M, Z, B, C, O, D>,
        Error,
    > {
        self.view.screen.check(canvas.frame_size())?;
        let mut rest = &*self.entries;
        let rows = canvas.rows().clone();
        Ok(core::iter::from_fn(move || {
            let meets = |[start, end]: [u16; 2]| {
                u32::from(start).max(rows.start) < u32::from(end).min(rows.end)
            };
            let start = rest.iter().position(|entry| meets(entry.rows))?;
            rest = rest.get(start..)?;
            let (object, numbers) = self.view.object_of(rest.first()?.first())?;
            let is_other = |entry: &Entry| !numbers.contains(&u32::from(entry.first()));
            let length = rest.iter().position(is_other).unwrap_or(rest.len());
            let (triangles, others) = rest.split_at_checked(length)?;
            rest = others;
            Some((
                &object.material,
                Prepared {
                    call: self.view.call(object),
                    triangles,
                    vertices: self.vertices,
                    rows: [0, u16::MAX],
                    pixels: self.pixels,
                },
            ))
        }))
    }
}
