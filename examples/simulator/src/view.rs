//! Makes the library's camera, projection and light from the framing.

use fixel::num::scalar;
use fixel::prelude::*;
use fixel::view::{Parallel, Perspective};

use super::Result;
use super::mode::Mode;
use crate::args::{Args, DepthFormat, Filter, Kind};
use crate::framing::Framing;

/// A projection of either kind.
#[derive(Clone, Copy, Debug)]
pub enum Lens {
    Perspective(Projection<Perspective>),
    Parallel(Projection<Parallel>),
}

/// Everything that is the same for each frame.
#[derive(Clone, Copy, Debug)]
pub struct View {
    pub projection: Lens,
    pub camera: Camera,
    pub options: DrawOptions,
    /// Towards the light, over the viewer's left shoulder.
    pub sun: Vec3,
    /// Upwards, of any length.
    pub up: Vec3,
    pub filter: Filter,
    pub mode: Mode,
    pub depth: DepthFormat,
    /// Depths, in linear steps, of the nearest and the farthest point of the model.
    pub depths: [u16; 2],
}

fn number(what: &str, value: f64) -> Result<Scalar> {
    Ok(scalar(value).map_err(|error| format!("{what} {value}: {error}"))?)
}

fn point(what: &str, [x, y, z]: [f64; 3]) -> Result<Vec3> {
    Ok(Vec3::try_from([x, y, z]).map_err(|error| format!("{what} {x},{y},{z}: {error}"))?)
}

/// A direction, scaled up to use all bits of the format: its length does not matter.
pub fn direction(what: &str, [x, y, z]: [f64; 3]) -> Result<Vec3> {
    let size = x.abs().max(y.abs()).max(z.abs());
    // A power of two, so that scaling does not round.
    let scale = if size > 0.0 && size.is_finite() {
        2_f64.powf(13.0 - size.log2().floor())
    } else {
        1.0
    };
    point(what, [x * scale, y * scale, z * scale])
}

impl View {
    /// Makes the view of `framing`.
    ///
    /// # Errors
    ///
    /// The library refuses the camera, the projection or the light.
    pub fn new(args: &Args, framing: &Framing) -> Result<Self> {
        let what = |given: bool, option, chosen| if given { option } else { chosen };
        let eye = what(
            args.eye.is_some(),
            "--eye",
            "to see the whole model, the eye must be at",
        );
        let target = what(
            args.look_at.is_some(),
            "--look-at",
            "the middle of the model is at",
        );
        let camera = Camera::look_at(
            point(eye, framing.eye)?,
            point(target, framing.target)?,
            direction("--up", args.up())?,
        )
        .map_err(|mut error| {
            // The message names the direction as it was written.
            if let (Error::UpAlongView { up, .. }, Ok(written)) =
                (&mut error, point("--up", args.up()))
            {
                *up = written;
            }
            error
        })?;
        let near = what(
            args.near.is_some(),
            "--near",
            "the nearest point of the model is at",
        );
        let far = what(
            args.far.is_some(),
            "--far",
            "the farthest point of the model is at",
        );
        let near = number(near, framing.near)?;
        let far = number(far, framing.far)?;
        let projection = if args.projection == Kind::Perspective {
            let fov = Angle::try_from_degrees(framing.fov)?;
            Lens::Perspective(Projection::perspective(fov, args.size, near, far)?)
        } else {
            let edge = |value| number("edge of the picture at", value);
            let [l, r, b, t] = framing.window;
            let window = Window {
                left: edge(l)?,
                right: edge(r)?,
                bottom: edge(b)?,
                top: edge(t)?,
            };
            let angle = Angle::from_degrees(45);
            Lens::Parallel(match args.projection {
                Kind::Cabinet => Projection::cabinet(angle, window, near, far)?,
                Kind::Cavalier => Projection::cavalier(angle, window, near, far)?,
                _ => Projection::orthographic(window, near, far)?,
            })
        };
        let cull = if args.two_sided {
            Cull::Nothing
        } else {
            Cull::Back
        };
        Ok(Self {
            projection,
            camera,
            options: DrawOptions::new().with_cull(cull),
            up: direction("--up", args.up())?,
            sun: point("light from", framing.light)?,
            filter: args.filter,
            mode: Mode::new(args)?,
            depth: args.depth,
            depths: framing.depths(args.projection),
        })
    }

    /// The place that the picture is seen from.
    pub fn viewer(&self) -> Viewer {
        match self.projection {
            Lens::Perspective(projection) => Viewer::of(&(projection * self.camera)),
            Lens::Parallel(projection) => Viewer::of(&(projection * self.camera)),
        }
    }
}
