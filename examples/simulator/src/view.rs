//! Makes the library's camera, projection and light from the framing.

use fixel::Window;
use fixel::prelude::*;
use fixel::view::{Parallel, Perspective};

use super::Result;
use super::draw::AnyMvp;
use crate::args::{Args, Kind};
use crate::framing::Framing;
use crate::units::{self, Units};

/// A projection of either kind.
#[derive(Clone, Copy, Debug)]
pub enum AnyProjection {
    Perspective(Projection<Perspective>),
    Parallel(Projection<Parallel>),
}

/// Everything about a view that is the same for all frames.
#[derive(Clone, Copy, Debug)]
pub struct View {
    pub projection: AnyProjection,
    pub camera: Camera,
    /// The direction to the light, over the viewer's left shoulder.
    pub sun: Vec3,
    /// The direction that is up, of any length.
    pub up: Vec3,
    /// The depths of the nearest and the farthest point of the model, in linear steps.
    pub depths: [u16; 2],
}

/// A direction, scaled up so that it uses all bits of the format. The length of a direction does not matter.
///
/// # Errors
///
/// A coordinate is not a number.
pub fn direction([x, y, z]: [f64; 3]) -> Result<Vec3> {
    let size = x.abs().max(y.abs()).max(z.abs());
    // The factor is a power of two, so that scaling does not round.
    let scale = if size > 0.0 && size.is_finite() {
        2_f64.powf(13.0 - size.log2().floor())
    } else {
        1.0
    };
    Ok(Vec3::try_from([x * scale, y * scale, z * scale])?)
}

impl View {
    /// Makes the view of `framing`, in the units that are drawn.
    ///
    /// # Errors
    ///
    /// The library refuses the camera, the projection or the light.
    pub fn new(args: &Args, framing: &Framing, units: &Units) -> Result<Self> {
        let eye = units.point(framing.eye);
        // Only the target's direction counts, so the target is as far away as possible.
        let ahead = [0, 1, 2].map(|i| eye[i] - framing.axes[2][i] * units::MOST);
        let camera = Camera::look_at(
            Vec3::try_from(eye)?,
            Vec3::try_from(ahead)?,
            direction(framing.up)?,
        )?;
        let near = Scalar::try_from(units.length(framing.near))?;
        let far = Scalar::try_from(units.length(framing.useful_far()))?;
        let projection = if args.projection == Kind::Perspective {
            let fov = Angle::try_from_degrees(framing.fov)?;
            AnyProjection::Perspective(Projection::perspective(fov, args.size, near, far)?)
        } else {
            let edge = |value| Scalar::try_from(units.length(value));
            let [l, r, b, t] = framing.window();
            let window = Window {
                left: edge(l)?,
                right: edge(r)?,
                bottom: edge(b)?,
                top: edge(t)?,
            };
            let angle = Angle::from_degrees(45);
            AnyProjection::Parallel(match args.projection {
                Kind::Cabinet => Projection::oblique(angle, fx!(0.5), near, window, near, far)?,
                Kind::Cavalier => Projection::oblique(angle, fx!(1), near, window, near, far)?,
                _ => Projection::orthographic(window, near, far)?,
            })
        };
        Ok(Self {
            projection,
            camera,
            up: direction(framing.up)?,
            sun: Vec3::try_from(framing.light())?,
            depths: framing.depths(),
        })
    }

    /// The transform from the model in this pose to the picture.
    pub fn mvp(&self, pose: Transform) -> AnyMvp {
        match self.projection {
            AnyProjection::Perspective(projection) => {
                AnyMvp::Perspective(projection * self.camera * pose)
            }
            AnyProjection::Parallel(projection) => {
                AnyMvp::Parallel(projection * self.camera * pose)
            }
        }
    }
}
