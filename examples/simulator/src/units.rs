//! The units in which the library draws: the model's units, moved and scaled to fit the number format.

use super::Result;
use crate::args::Args;
use crate::framing::{Framing, Point, Solid, about};

/// The largest absolute value of a coordinate: half of the format's range, so that positions relative to the eye fit,
/// too.
pub const MOST: f64 = 16_000.0;
/// The largest distance from the middle of the model, relative to the model's own size. If a distance is larger, fewer
/// than 2^14 steps are left for the model.
const FARTHEST: f64 = 65_536.0;
/// The smallest distance of the near plane: 16 steps.
const NEAREST: f64 = 16.0 / 65_536.0;

/// A map from the model's units to the units that are drawn: (p − origin) · 2^exponent, in f64.
#[derive(Clone, Copy, Debug)]
pub struct Units {
    origin: Point,
    /// The scale is a power of two, so that scaling back is exact.
    pub exponent: i32,
}

impl Units {
    /// Returns the units in which `solid` and all distances of `framing` are as large as the format allows.
    ///
    /// # Errors
    ///
    /// A distance is so much larger than the model that few steps are left for the model, or the near plane is so near
    /// that no step is left for its distance. The message names the option.
    pub fn new(args: &Args, framing: &Framing, solid: &Solid) -> Result<Self> {
        let limit = solid.radius * FARTHEST;
        let reach = framing.reach(args, solid, limit)?;
        #[allow(clippy::cast_possible_truncation)] // from -1100 to 1100
        let exponent = (MOST / reach).log2().floor().clamp(-1000.0, 1000.0) as i32;
        let units = Self {
            origin: solid.middle,
            exponent,
        };
        units.check_near(framing)?;
        Ok(units)
    }

    /// Returns the units of a scene that is compiled in: those of the scene itself.
    ///
    /// # Errors
    ///
    /// As for [`new`](Self::new).
    pub fn own(args: &Args, framing: &Framing, solid: &Solid) -> Result<Self> {
        framing.reach(args, solid, MOST)?;
        let units = Self {
            origin: [0.0; 3],
            exponent: 0,
        };
        units.check_near(framing)?;
        Ok(units)
    }

    fn check_near(&self, framing: &Framing) -> Result<()> {
        let [near, far] = [framing.near, framing.far].map(|distance| self.length(distance));
        if framing.is_perspective() && near < NEAREST {
            let least = NEAREST / self.scale();
            return Err(format!(
                "--near {}: with this camera it must be at least {}",
                framing.near,
                about(least * 1.001)
            )
            .into());
        }
        if far - near < NEAREST {
            return Err(format!(
                "--far {}: it must be beyond the near plane at {} by at least {}",
                framing.far,
                framing.near,
                about(NEAREST / self.scale() * 1.001)
            )
            .into());
        }
        Ok(())
    }

    /// Returns the length at which one of the model's units is drawn.
    pub fn scale(&self) -> f64 {
        f64::from(self.exponent).exp2()
    }

    /// Converts a length to the units that are drawn.
    pub fn length(&self, length: f64) -> f64 {
        length * self.scale()
    }

    /// Converts a position to the units that are drawn.
    pub fn point(&self, point: Point) -> Point {
        [0, 1, 2].map(|i| self.length(point[i] - self.origin[i]))
    }
}
