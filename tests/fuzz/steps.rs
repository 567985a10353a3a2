//! Products of transforms, made both by the crate and by the model.

use arbitrary::{Result, Unstructured};
use fixel::prelude::*;

use super::numbers::{angle, factors, few, scalar, vector};
use support::moves::Move;

/// A factor in a product of transforms.
#[derive(Clone, Copy, Debug)]
pub enum Step {
    /// A transform, multiplied from the right, so that it acts on points before the previous steps do.
    Move(Move),
    Uniform(Scalar),
    Rotate(Vec3, Angle),
    /// The inverse of the product of all previous steps, if there is one.
    Inverse,
    Renormalized,
}

impl Step {
    pub fn arbitrary(u: &mut Unstructured<'_>) -> Result<Self> {
        Ok(match u.int_in_range(0..=9)? {
            0 => Self::Uniform(factors(u)?.x),
            1 => Self::Rotate(vector(u)?, angle(u)?),
            2 => Self::Inverse,
            3 => Self::Renormalized,
            4 => Self::Move(Move::X(angle(u)?)),
            5 => Self::Move(Move::Y(angle(u)?)),
            6 => Self::Move(Move::Z(angle(u)?)),
            7 => Self::Move(Move::Scale(factors(u)?)),
            _ => Self::Move(Move::To(vector(u)?)),
        })
    }

    fn after(self, before: Transform) -> Transform {
        match self {
            Self::Move(step) => before * step.transform(),
            Self::Uniform(factor) => before * Transform::scale(factor),
            // A zero axis gives no rotation.
            Self::Rotate(axis, angle) => match Transform::rotate(axis, angle) {
                Ok(rotation) => before * rotation,
                Err(_) => before,
            },
            Self::Inverse => before.inverse().unwrap_or(before),
            Self::Renormalized => before.renormalized(),
        }
    }
}

/// A product of a few steps.
#[derive(Clone, Debug, Default)]
pub struct Steps(Vec<Step>);

impl Steps {
    pub fn arbitrary(u: &mut Unstructured<'_>) -> Result<Self> {
        let count = *u.choose(&[0, 1, 0, 1, 2, 4])?;
        few(u, count, Step::arbitrary).map(Self)
    }

    /// Whether the product mirrors, which it does if an odd number of scale factors is negative.
    pub fn mirrors(&self) -> bool {
        let negative = |factor: Scalar| factor < fx!(0);
        self.0.iter().fold(false, |mirrors, step| match step {
            Step::Uniform(factor) => mirrors ^ negative(*factor),
            Step::Move(Move::Scale(by)) => {
                mirrors ^ negative(by.x) ^ negative(by.y) ^ negative(by.z)
            }
            _ => mirrors,
        })
    }

    pub fn transform(&self) -> Transform {
        let mut transform = Transform::IDENTITY;
        for step in &self.0 {
            transform = step.after(transform);
        }
        transform
    }

    /// The steps as f64 matrices, if the model supports them.
    pub fn moves(&self) -> Option<Vec<Move>> {
        let known = |step: &Step| match step {
            Step::Move(step) => Some(*step),
            _ => None,
        };
        self.0.iter().map(known).collect()
    }
}

/// How the camera is placed.
#[derive(Clone, Debug)]
pub enum Eye {
    AtOrigin,
    View(Steps),
    Placed(Steps),
    LookAt([Vec3; 3]),
    Trimetric(Vec3, Scalar, [Angle; 2]),
}

impl Eye {
    pub fn arbitrary(u: &mut Unstructured<'_>) -> Result<Self> {
        Ok(match u.int_in_range(0..=7)? {
            0 => Self::View(Steps::arbitrary(u)?),
            1 => Self::Placed(Steps::arbitrary(u)?),
            2 => Self::LookAt([vector(u)?, vector(u)?, vector(u)?]),
            3 => Self::Trimetric(vector(u)?, scalar(u)?, [angle(u)?, angle(u)?]),
            4 => Self::AtOrigin,
            // The camera is up to 16 units back, so that the surroundings of the origin are in view.
            _ => {
                let distance = i32::from(u.arbitrary::<u8>()?) << 12;
                let back = Vec3::from_bits([0, 0, -distance]);
                Self::View(Steps(vec![Step::Move(Move::To(back))]))
            }
        })
    }

    /// Whether the camera mirrors the view.
    pub fn mirrors(&self) -> bool {
        match self {
            Self::View(steps) | Self::Placed(steps) => steps.mirrors(),
            _ => false,
        }
    }

    /// The camera, if the crate accepts these numbers.
    pub fn camera(&self) -> Result<Camera, Error> {
        match self {
            Self::AtOrigin => Ok(Camera::from_view(Transform::IDENTITY)),
            Self::View(steps) => Ok(Camera::from_view(steps.transform())),
            Self::Placed(steps) => Ok(Camera::at_pose(steps.transform())),
            &Self::LookAt([eye, target, up]) => Camera::look_at(eye, target, up),
            &Self::Trimetric(target, distance, [turn, tilt]) => {
                Ok(Camera::trimetric(target, distance, turn, tilt))
            }
        }
    }

    /// The camera's steps as f64 matrices, if the model supports them.
    pub fn moves(&self) -> Option<Vec<Move>> {
        match self {
            Self::AtOrigin => Some(Vec::new()),
            Self::View(steps) => steps.moves(),
            _ => None,
        }
    }
}
