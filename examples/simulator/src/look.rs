//! The background, lights and fog that the user chose, in the library's types.

use embedded_graphics::geometry::Point;
use embedded_graphics::pixelcolor::{Rgb888, RgbColor};
use fixel::num::scalar;
use fixel::prelude::*;
use fixel::shade::{Colored, Fog, Levels, Light, TwoSided, Viewer};
use fixel::texture::Blend;

use super::Result;
use super::common::lighthouse;
use crate::args::{Args, Shade};
use crate::draw::Backdrop;
use crate::job::Model;
use crate::view::direction;

/// Default ambient light, which reaches every face.
const AMBIENT: f64 = 0.3;

/// A light that the user chose.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lamp {
    /// Points to the light.
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

/// Everything about a picture's colors except the surface itself.
pub struct Look {
    /// `None` for the project's own scene as a microcontroller draws it.
    pub shade: Option<Shade>,
    /// Whether it is the project's own scene, with sea and sky.
    pub is_scene: bool,
    /// The background of the picture. Its color is not yet in the canvas's format, and differs from all shades.
    pub backdrop: Backdrop,
    lights: Vec<Colored<Light>>,
    /// The lights, if all of them are white, which needs one number instead of three.
    white: Option<Vec<Light>>,
    viewer: Viewer,
    haze: Option<(Scalar, Scalar, Rgb888)>,
    /// Whether edges are drawn over the surface.
    pub wire: bool,
}

impl Look {
    /// Makes the look of `args` for `model` on a canvas of color `C`. `scale` is the length of one of the model's units
    /// as it is drawn.
    ///
    /// # Errors
    ///
    /// A light or the fog is out of range.
    pub fn new<C: Levels>(args: &Args, model: &Model<'_>, scale: f64) -> Result<Self> {
        const WHITE: Rgb888 = Rgb888::WHITE;
        let ambient = scalar(args.ambient.unwrap_or(AMBIENT))?;
        let diffuse = scalar(1.0 - AMBIENT)?;
        let mut lights = Vec::new();
        // The first lamp carries the ambient light.
        let mut shares = [ambient].into_iter();
        let mut add = |toward, color: Rgb888| -> Result<()> {
            let light = Light::new(toward, shares.next().unwrap_or(fx!(0)), diffuse)?;
            lights.push((light, color));
            Ok(())
        };
        for lamp in &args.light {
            let toward = direction(lamp.direction)?;
            add(toward, lamp.color)?;
        }
        if args.light.is_empty() {
            add(model.view.sun, WHITE)?;
        }
        let backdrop = backdrop::<C>(args.background, model);
        let far_away = match backdrop {
            Backdrop::Color(color) => color,
            // The approximate height of the horizon in the default view.
            Backdrop::Sky => lighthouse::sky_color(1, 3),
        };
        let haze = args.fog.map(|Haze { near, far, color }| {
            let number = |value: f64| {
                scalar(value * scale).map_err(|error| format!("--fog {near},{far}: {error}"))
            };
            Ok::<_, String>((number(near)?, number(far)?, color.unwrap_or(far_away)))
        });
        Ok(Self {
            shade: model.shade,
            is_scene: model.is_scene,
            backdrop,
            white: lights
                .iter()
                .map(|&(light, color)| (color == WHITE).then_some(light))
                .collect(),
            lights: lights
                .iter()
                .map(|&(light, color)| light.colored(color))
                .collect(),
            viewer: model.view.viewer(),
            haze: haze.transpose()?,
            wire: args.wire && model.shade != Some(Shade::Wire),
        })
    }

    /// The lights, if all are white.
    pub fn white(&self) -> Option<TwoSided<&[Light]>> {
        let lights = self.white.as_deref()?;
        Some(lights.two_sided(self.viewer))
    }

    /// The lights in their colors.
    pub fn colored(&self) -> TwoSided<&[Colored<Light>]> {
        self.lights.as_slice().two_sided(self.viewer)
    }

    /// Whether there is fog.
    pub fn has_fog(&self) -> bool {
        self.haze.is_some()
    }

    /// The fog, in the texture's color type.
    ///
    /// # Errors
    ///
    /// The fog ends before it begins.
    pub fn fog<C: Levels + Blend>(&self) -> Result<Option<Fog<C>>> {
        let Some((near, far, color)) = self.haze else {
            return Ok(None);
        };
        let color = C::from_rgb(color, Point::zero());
        match Fog::linear(color, near, far) {
            Ok(fog) => Ok(Some(fog)),
            Err(error) => Err(format!("--fog: {error}").into()),
        }
    }

    /// The color of lines: white on black, and black on a surface.
    pub fn line<C: Levels + Into<Rgb888>>(&self) -> Rgb888 {
        let color = match self.shade {
            Some(Shade::Wire) => Rgb888::WHITE,
            _ => Rgb888::BLACK,
        };
        C::from_rgb(color, Point::zero()).into()
    }
}

/// Returns the backdrop of a model: the background that the user chose, or else one that suits its shading and colors.
fn backdrop<C: Levels>(background: Option<Rgb888>, model: &Model<'_>) -> Backdrop {
    Backdrop::Color(match (background, model.shade) {
        (Some(color), _) => color,
        (None, Some(Shade::Wire | Shade::Depth)) => Rgb888::BLACK,
        // In the dithered formats, the background would show a pattern.
        _ if lighthouse::is_mono::<C>() => Rgb888::BLACK,
        _ if model.is_scene => return Backdrop::Sky,
        _ if C::MAX_STEPS[0] < 31 => Rgb888::BLACK,
        _ => Rgb888::new(34, 40, 52),
    })
}
