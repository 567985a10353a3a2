//! The transform from a model to the picture: projection · camera · model.

use core::ops::Mul;

use super::{Camera, Perspective, Projection, ProjectionKind};
use crate::math::Transform;
use crate::sealed::Sealed;

/// A model-view-projection: a projection, a camera and the transform of a model, applied from right to
/// left.
///
#[cfg_attr(doc, doc = include_str!("../guide/diagrams/pipeline.svg"))]
///
/// Write an `Mvp` as a product, `projection * camera * model`. The viewport transform would come leftmost, but it is
/// not part of the product: [`DrawOptions::with_viewport`](crate::DrawOptions::with_viewport) sets the viewport. The
/// camera and the model transform are stored separately, because light is computed in world space, after the model
/// transform and before the camera.
///
/// ```
/// use fixel::prelude::*;
/// let projection = Projection::perspective(deg!(60), (4, 3), fx!(0.5), fx!(50))?;
/// let camera = Camera::look_at(vec3!(0, 2, 5), Vec3::ZERO, Vec3::Y)?;
/// let spin = Transform::rotate_y(Angle::from_degrees(30));
/// let mvp = projection * camera * spin;
/// // The same product, with a transform of the world before the transform of the model.
/// let again = projection * camera * Transform::IDENTITY * spin;
/// assert_eq!(mvp.model_view(), again.model_view());
/// # Ok::<(), Error>(())
/// ```
///
/// Draw calls also accept a projection alone, for a model that is already in eye space:
///
/// ```
/// use embedded_graphics::pixelcolor::Gray8;
/// use fixel::prelude::*;
/// let positions = [vec3!(-1, -1, -2), vec3!(1, -1, -2), vec3!(0, 1, -2)];
/// let mesh = Mesh::new(&positions, &[[0, 1, 2]])?;
/// let projection = Projection::perspective(deg!(60), (4, 3), fx!(0.5), fx!(50))?;
/// let mut pixels = [Gray8::new(0); 12];
/// let mut canvas = Canvas::new(&mut pixels, 4, 3)?;
/// assert_eq!(canvas.draw(&mesh, &projection, &Flat::new(Gray8::new(9))).drawn, 1);
/// # Ok::<(), Error>(())
/// ```
///
/// `Mvp` without a type parameter has a perspective projection. A function that accepts both kinds of projection must
/// be generic:
///
/// ```
/// use embedded_graphics::pixelcolor::Gray8;
/// use fixel::{Window, prelude::*, view::ProjectionKind};
/// static BALL: Mesh = shape!(sphere(8, 6));
/// fn draw<K: ProjectionKind>(canvas: &mut Canvas<'_, Gray8>, view: &Mvp<K>) -> bool {
///     let ball = *view * Transform::translate(vec3!(0, 0, -4));
///     canvas.draw(&BALL, &ball, &Flat::new(Gray8::new(9))).drawn > 0
/// }
/// let mut pixels = [Gray8::new(0); 64];
/// let mut canvas = Canvas::new(&mut pixels, 8, 8)?;
/// let parallel = Projection::orthographic(Window::centered(fx!(4), fx!(4)), fx!(0), fx!(9))?;
/// assert!(draw(&mut canvas, &parallel.into()));
/// assert!(draw(&mut canvas, &Projection::perspective(deg!(60), (1, 1), fx!(0.1), fx!(9))?.into()));
/// # Ok::<(), Error>(())
/// ```
///
/// A camera or a model transform alone does not compile, because it lacks a projection:
///
/// ```compile_fail
/// use embedded_graphics::pixelcolor::Gray8;
/// use fixel::prelude::*;
/// fn draw(canvas: &mut Canvas<'_, Gray8>, mesh: &Mesh, camera: Camera) {
///     // error: `Camera` lacks a projection; note: write `projection * camera * model`, …
///     canvas.draw(mesh, &camera, &Flat::new(Gray8::new(9)));
/// }
/// ```
/// ```compile_fail
/// use fixel::prelude::*;
/// let spin = Transform::rotate_y(deg!(30));
/// // error: a `Camera` times a `Transform` lacks a projection; note: write `projection * camera * model`, …
/// let _ = Camera::default() * spin;
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Mvp<K = Perspective> {
    pub(crate) projection: Projection<K>,
    /// The transform from world to eye space.
    pub(crate) camera: Transform,
    /// The transform from model to world space.
    pub(crate) model: Transform,
}

impl<K: ProjectionKind> Mvp<K> {
    /// Returns the transform from model space to eye space.
    #[must_use]
    pub fn model_view(&self) -> Transform {
        self.camera * self.model
    }

    /// Returns the projection.
    #[must_use]
    pub const fn projection(&self) -> Projection<K> {
        self.projection
    }
}

impl<K> Sealed for Mvp<K> {}
impl<K> Sealed for Projection<K> {}

/// What a draw call accepts as a model-view-projection: an [`Mvp`], or a [`Projection`] alone.
#[doc(hidden)]
#[diagnostic::on_unimplemented(
    message = "`{Self}` lacks a projection",
    label = "this is not a model-view-projection",
    note = "write `projection * camera * model`, or a `Projection` alone for a model in eye space"
)]
pub trait AsMvp: Sealed {
    /// The kind of projection.
    type Kind: ProjectionKind;

    fn projection_of(&self) -> &Projection<Self::Kind>;

    /// Returns the transform from world to eye space.
    #[inline]
    fn camera_of(&self) -> &Transform {
        &Transform::IDENTITY
    }

    /// Returns the transform from model to world space.
    #[inline]
    fn model_of(&self) -> &Transform {
        &Transform::IDENTITY
    }

    /// Returns the transform from model to eye space.
    #[inline]
    fn model_view_of(&self) -> Transform {
        Transform::IDENTITY
    }
}

impl<K: ProjectionKind> AsMvp for Mvp<K> {
    type Kind = K;

    #[inline]
    fn projection_of(&self) -> &Projection<K> {
        &self.projection
    }

    #[inline]
    fn camera_of(&self) -> &Transform {
        &self.camera
    }

    #[inline]
    fn model_of(&self) -> &Transform {
        &self.model
    }

    #[inline]
    fn model_view_of(&self) -> Transform {
        self.model_view()
    }
}

impl<K: ProjectionKind> AsMvp for Projection<K> {
    type Kind = K;

    #[inline]
    fn projection_of(&self) -> &Self {
        self
    }
}

impl<K: ProjectionKind> From<Projection<K>> for Mvp<K> {
    /// Makes the transform for a model in eye space: the camera and the model transform move nothing.
    fn from(projection: Projection<K>) -> Self {
        Self {
            projection,
            camera: Transform::IDENTITY,
            model: Transform::IDENTITY,
        }
    }
}

impl<K: ProjectionKind> Mul<Camera> for Projection<K> {
    type Output = Mvp<K>;

    fn mul(self, camera: Camera) -> Mvp<K> {
        Mvp {
            camera: camera.view(),
            ..self.into()
        }
    }
}

/// What can be multiplied by a camera without a projection: nothing. The compiler says so in the words below.
#[doc(hidden)]
#[diagnostic::on_unimplemented(
    message = "a `Camera` times a `{Self}` lacks a projection",
    label = "the projection comes first",
    note = "write `projection * camera * model`, or keep `let view = projection * camera` for several models"
)]
pub trait InView: Sealed {}

#[doc(hidden)]
impl<T: InView> Mul<T> for Camera {
    type Output = Self;

    fn mul(self, _: T) -> Self {
        self
    }
}

impl<K: ProjectionKind> Mul<Transform> for Projection<K> {
    type Output = Mvp<K>;

    /// Makes the transform without a camera. `model` places the mesh in eye space.
    fn mul(self, model: Transform) -> Mvp<K> {
        Mvp {
            model,
            ..self.into()
        }
    }
}

impl<K: ProjectionKind> Mul<Transform> for Mvp<K> {
    type Output = Self;

    /// Applies `part` first: the model becomes `model * part`.
    fn mul(self, part: Transform) -> Self {
        Self {
            model: self.model * part,
            ..self
        }
    }
}
