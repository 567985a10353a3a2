//! The brightness of a surface under lights, with all vectors in world space.

use super::linear::{Vec3, dot, length, normalized, subtract};

/// A point of a surface, with its unit normal.
#[derive(Clone, Copy, Debug)]
pub struct Point {
    pub at: Vec3,
    pub normal: Vec3,
}

/// How much of a lamp's light is left at a distance of `part` times its range.
fn left(part: f64) -> f64 {
    (1. - part * part).max(0.).powi(2)
}

/// A light source.
#[derive(Clone, Copy, Debug)]
pub enum Source {
    Sun {
        toward: Vec3,
        brightness: f64,
    },
    Lamp {
        at: Vec3,
        brightness: f64,
        range: f64,
        /// For a spotlight: the axis of its cone, and the cosines of the inner and the outer angle.
        cone: Option<(Vec3, [f64; 2])>,
    },
}

impl Source {
    /// The unit vector from a point toward the light, and the light's strength at the point.
    pub fn ray(&self, at: Vec3) -> (Vec3, f64) {
        match *self {
            Self::Sun { toward, brightness } => (normalized(toward), brightness),
            Self::Lamp {
                at: lamp,
                brightness,
                range,
                cone,
            } => {
                let way = subtract(lamp, at);
                let toward = normalized(way);
                let part = cone.map_or(1., |(axis, [inner, outer])| {
                    let cosine = -dot(normalized(axis), toward);
                    let t = ((cosine - outer) / (inner - outer)).clamp(0., 1.);
                    t * t * (3. - 2. * t)
                });
                (toward, brightness * left(length(way) / range) * part)
            }
        }
    }

    /// The diffuse brightness by Lambert's law.
    pub fn diffuse(&self, point: Point) -> f64 {
        let (toward, strength) = self.ray(point.at);
        strength * dot(point.normal, toward).max(0.)
    }

    /// The specular brightness by Blinn and Phong, for a unit vector toward the viewer.
    pub fn specular(&self, point: Point, viewer: Vec3, exponent: i32) -> f64 {
        let (toward, strength) = self.ray(point.at);
        if dot(point.normal, toward) <= 0. {
            return 0.;
        }
        let halfway = normalized(std::array::from_fn(|i| toward[i] + viewer[i]));
        strength * dot(point.normal, halfway).max(0.).powi(exponent)
    }
}
