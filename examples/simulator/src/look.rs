//! The background, lights and fog that the user chose, in the library's types.

use embedded_graphics::geometry::Point;
use embedded_graphics::pixelcolor::{Rgb888, RgbColor};
use fixel::canvas::Contrast;
use fixel::prelude::*;
use fixel::shade::{Colored, Light, PixelFormat, TwoSided, Viewer};

use super::Result;
use super::common::lighthouse;
use crate::args::{Args, Shade};
use crate::scene::{Moment, Motion, Scene};
use crate::view::direction;

/// The default ambient light, which reaches every face: of a model, and of the project's own scene.
const AMBIENT: f64 = 0.3;
const OWN_AMBIENT: f64 = 0.4;

/// The default background, and then the background behind dark models.
pub const DARK: Rgb888 = Rgb888::new(34, 40, 52);
pub const BRIGHT: Rgb888 = Rgb888::new(206, 212, 222);

/// A light that the user chose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lamp {
    /// The direction to the light.
    pub direction: [f64; 3],
    pub color: Rgb888,
}

/// A fog that the user chose, in the model's units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Haze {
    pub near: f64,
    pub far: f64,
    pub color: Option<Rgb888>,
}

/// The background of a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Backdrop {
    /// One color, which is converted to the color type of the canvas.
    Color(Rgb888),
    /// The sky of the project's own scene.
    Sky,
}

impl Backdrop {
    /// Returns the backdrop for a canvas of color `C`: the background that the user chose, or otherwise a background
    /// that suits the shading and the color.
    pub fn of<C: PixelFormat>(args: &Args, scene: &Scene<'_>) -> Self {
        Self::Color(match (args.background, scene.shade) {
            (Some(color), _) => color,
            (None, Some(Shade::Wire | Shade::Depth)) => Rgb888::BLACK,
            // In black and white, a dithered sky would hide the scene.
            (None, shade)
                if scene.is_own && C::MAX_STEPS[0] > 1 && shade != Some(Shade::Normal) =>
            {
                return Self::Sky;
            }
            (None, None) => Rgb888::BLACK,
            // In dithered formats, another background would show a pattern.
            _ if C::MAX_STEPS[0] < 31 => Rgb888::BLACK,
            _ => DARK,
        })
    }
}

/// Everything that determines a picture's colors, except the surface itself.
pub struct Look {
    /// `None` for a scene that has shaders of its own.
    pub shade: Option<Shade>,
    /// The background of the picture, before it is converted to the canvas's format.
    pub backdrop: Backdrop,
    /// How the grays of the picture are stretched toward black and white; `None` if they are not.
    pub contrast: Option<Contrast>,
    lights: Vec<Colored<Light>>,
    viewer: Viewer,
    haze: Option<(Scalar, Scalar, Rgb888)>,
}

impl Look {
    /// Makes the look of `args` for a `scene`. `scale` is the length at which one of the model's units is drawn.
    ///
    /// # Errors
    ///
    /// A light or the fog is out of range.
    pub fn new(
        args: &Args,
        scene: &Scene<'_>,
        scale: f64,
        backdrop: Backdrop,
        contrast: Option<Contrast>,
    ) -> Result<Self> {
        let (sun, viewer) = match scene.motion {
            Motion::Turning { view, .. } => (view.sun, view.mvp(Transform::IDENTITY).viewer()),
            measured @ Motion::Measured(_) => (Vec3::Y, measured.mvp(Moment::default())?.viewer()),
        };
        let default = if scene.is_own { OWN_AMBIENT } else { AMBIENT };
        let ambient = Scalar::try_from(args.ambient.unwrap_or(default))?;
        let diffuse = Scalar::try_from(1.0 - default)?;
        // Only the first light has the ambient light.
        let mut shares = [ambient].into_iter();
        let mut light = |toward, color: Rgb888| -> Result<Colored<Light>> {
            let light = Light::new(toward, shares.next().unwrap_or(fx!(0)), diffuse)?;
            Ok(light.colored(color))
        };
        let mut lights = Vec::new();
        for lamp in &args.light {
            lights.push(light(direction(lamp.direction)?, lamp.color)?);
        }
        if args.light.is_empty() {
            lights.push(light(sun, Rgb888::WHITE)?);
        }
        let far_away = match backdrop {
            Backdrop::Color(color) => color,
            Backdrop::Sky => lighthouse::sky_color(1, 1),
        };
        let haze = args.fog.map(|Haze { near, far, color }| {
            let number = |value: f64| {
                Scalar::try_from(value * scale)
                    .map_err(|error| format!("--fog {near},{far}: {error}"))
            };
            Ok::<_, String>((number(near)?, number(far)?, color.unwrap_or(far_away)))
        });
        Ok(Self {
            shade: scene.shade,
            backdrop,
            contrast,
            lights,
            viewer,
            haze: haze.transpose()?,
        })
    }

    /// The lights.
    pub fn light(&self) -> TwoSided<&[Colored<Light>]> {
        self.lights.as_slice().two_sided(self.viewer)
    }

    /// Whether there is fog.
    pub fn has_fog(&self) -> bool {
        self.haze.is_some()
    }

    /// The fog, in the canvas's color type.
    ///
    /// # Errors
    ///
    /// The fog ends before it begins.
    pub fn fog<C: PixelFormat>(&self) -> Result<Option<Fog<C>>> {
        let Some((near, far, color)) = self.haze else {
            return Ok(None);
        };
        match Fog::linear(C::from_rgb(color, Point::zero()), near, far) {
            Ok(fog) => Ok(Some(fog)),
            Err(error) => Err(format!("--fog: {error}").into()),
        }
    }
}
