//! Where a picture is seen from.

use crate::error::{Error, ok};
use crate::math::{Direction, Vec3};
use crate::num::rsqrt::unit;
use crate::num::wide::dot;
use crate::view::AsMvp;

/// The place from which a picture is seen, in world space: a point under a perspective projection, a direction under a
/// parallel projection.
///
/// Highlights and two-sided light depend on the viewer.
///
/// ```
/// use fixel::prelude::*;
/// use fixel::shade::Viewer;
/// let projection = Projection::perspective(deg!(60), (4, 3), fx!(0.5), fx!(50))?;
/// let mvp = projection * Camera::look_at(vec3!(3, 0, 4), Vec3::ZERO, Vec3::Y)?;
/// assert_eq!(Viewer::of(&mvp), Viewer::at(vec3!(3, 0, 4)));
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Viewer(Position);

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
enum Position {
    At(Vec3),
    Toward(Direction),
}

impl Viewer {
    /// A viewer at a point of world space.
    #[must_use]
    pub const fn at(position: Vec3) -> Self {
        Self(Position::At(position))
    }

    /// A viewer infinitely far away, in this direction from the scene.
    ///
    /// # Errors
    ///
    /// [`Error::NoDirection`] if `direction` is zero.
    pub const fn toward(direction: Vec3) -> Result<Self, Error> {
        Ok(Self(Position::Toward(ok!(Direction::checked(direction)))))
    }

    /// The viewer of a picture that is drawn with this projection and camera. The camera must be a rigid transform, or
    /// [mirrored](crate::Camera::mirrored). Every [`Camera`](crate::Camera) is rigid or mirrored, unless you make it
    /// from another transform.
    #[must_use]
    pub fn of(picture: &impl AsMvp) -> Self {
        let from_eye = picture.camera_of().inverse_rigid();
        Self(match picture.projection_of().line_of_sight() {
            None => Position::At(from_eye.point(Vec3::ZERO)),
            Some(line) => Position::Toward(Direction::of(from_eye.direction(line))),
        })
    }

    /// The direction from a point of world space toward the viewer; [`Direction::NONE`] at the viewer itself.
    #[must_use]
    pub fn direction_from(&self, position: Vec3) -> Direction {
        match self.0 {
            Position::Toward(direction) => direction,
            Position::At(eye) => {
                let way = position.way_to(eye);
                Direction::from_bits(unit(way).unwrap_or_default())
            }
        }
    }

    /// Whether the viewer is behind a face: on the side of its plane to which its normal does not point. A viewer
    /// nearer to the plane than 2^-14 may count as being on either side.
    pub(super) fn sees_back(&self, face: Direction, position: Vec3) -> bool {
        match self.0 {
            Position::Toward(direction) => face.dot(direction).to_bits() < 0,
            Position::At(eye) => {
                // Each component has 33 bits, and loses the lowest two.
                let [x, y, z] = position.way_to(eye);
                dot(
                    &face.to_bits(),
                    &[(x >> 2) as i32, (y >> 2) as i32, (z >> 2) as i32],
                ) < 0
            }
        }
    }
}
