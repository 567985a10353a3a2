//! The mvp from a model to the picture: projection · camera · model.

use core::ops::Mul;

use super::{Camera, Perspective, Projection, ProjectionKind};
use crate::Transform;

/// A projection, a camera and the transform of a model, applied from right to left.
///
/// Written as a product, `projection * camera * model`; the viewport, leftmost, belongs to the canvas.
/// The camera stays apart from the model, because light is in world space, between the two.
///
/// ```
/// use fixel::prelude::*;
/// let projection = Projection::perspective(Angle::from_degrees(60), (4, 3), fx!(0.1), fx!(100))?;
/// let camera = Camera::look_at(vec3!(0, 2, 5), Vec3::ZERO, Vec3::Y)?;
/// let spin = Transform::rotate_y(Angle::from_degrees(30));
/// let mvp = projection * camera * spin;
/// // The same, with the world's transform given first and the part's within it after.
/// let again = projection * camera * Transform::IDENTITY * spin;
/// assert_eq!(mvp.model_view(), again.model_view());
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Mvp<K = Perspective> {
    pub(crate) projection: Projection<K>,
    /// From world to eye space.
    pub(crate) camera: Transform,
    /// From model to world space.
    pub(crate) model: Transform,
}

impl<K: ProjectionKind> Mvp<K> {
    /// The transform from model space to eye space.
    #[must_use]
    pub fn model_view(&self) -> Transform {
        self.camera * self.model
    }

    /// The projection.
    #[must_use]
    pub const fn projection(&self) -> Projection<K> {
        self.projection
    }
}

impl<K: ProjectionKind> From<Projection<K>> for Mvp<K> {
    /// A picture of eye space itself.
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

impl<K: ProjectionKind> Mul<Transform> for Projection<K> {
    type Output = Mvp<K>;

    /// The mvp of a model that is placed before the eye, without a camera.
    fn mul(self, model: Transform) -> Mvp<K> {
        Mvp {
            model,
            ..self.into()
        }
    }
}

impl<K: ProjectionKind> Mul<Transform> for Mvp<K> {
    type Output = Self;

    /// The mvp that applies `part` first.
    fn mul(self, part: Transform) -> Self {
        Self {
            model: self.model * part,
            ..self
        }
    }
}
