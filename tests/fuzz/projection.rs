//! Projections made from arbitrary numbers, both by the crate and by the model.

use arbitrary::{Result, Unstructured};
use fixel::Window;
use fixel::prelude::*;
use fixel::view::{Parallel, Perspective};

use super::numbers::{angle, scalar, size};
use support::moves::radians;
use support::reference::projection::{self, Projection as ModelProjection};

/// A constructor of projections, with its arguments.
#[derive(Clone, Copy, Debug)]
pub enum ProjectionArguments {
    Perspective(Angle, Option<Scalar>, [Scalar; 2]),
    Focal(Scalar, [Scalar; 2]),
    /// Left, right, bottom, top, near, far.
    Frustum([Scalar; 6]),
    Orthographic([Scalar; 6]),
    Oblique(Angle, Scalar, [Scalar; 6]),
}

/// A projection of either kind.
#[derive(Clone, Copy, Debug)]
pub enum Projected {
    Perspective(Projection<Perspective>),
    Parallel(Projection<Parallel>),
}

/// Left, right, bottom, top, near and far: arbitrary numbers, or the numbers of a view around the origin.
fn six(u: &mut Unstructured<'_>) -> Result<[Scalar; 6]> {
    if u.ratio(1, 2)? {
        let [l, r, b, t] = u
            .arbitrary::<[u8; 4]>()?
            .map(|edge| Scalar::from_bits(i32::from(edge) << 11));
        return Ok([-l, r, -b, t, fx!(0.25), fx!(32)]);
    }
    let mut edges = [Scalar::ZERO; 6];
    for edge in &mut edges {
        *edge = scalar(u)?;
    }
    let [a, b, c, d, near, far] = edges;
    Ok([
        a.min(b),
        a.max(b),
        c.min(d),
        c.max(d),
        near.min(far),
        near.max(far),
    ])
}

/// Distances of the near and the far plane.
fn planes(u: &mut Unstructured<'_>) -> Result<[Scalar; 2]> {
    if u.ratio(2, 3)? {
        return Ok([fx!(0.125), fx!(4096)]);
    }
    let (a, b) = (size(u)?, size(u)?);
    Ok([a.min(b), a.max(b)])
}

/// A field of view, which is rarely very wide or very narrow.
fn field_of_view(u: &mut Unstructured<'_>) -> Result<Angle> {
    if u.ratio(1, 8)? {
        angle(u)
    } else {
        Ok(Angle::from_degrees(u.int_in_range(1..=179_i32)?))
    }
}

impl ProjectionArguments {
    pub fn arbitrary(u: &mut Unstructured<'_>) -> Result<Self> {
        Ok(match u.int_in_range(0..=7)? {
            0 => Self::Frustum(six(u)?),
            1 => Self::Orthographic(six(u)?),
            2 => Self::Oblique(angle(u)?, scalar(u)?, six(u)?),
            3 => Self::Focal(size(u)?, planes(u)?),
            // The focal length is about as long as the width of a small canvas.
            4 => Self::Focal(Scalar::from(u.int_in_range(1..=200_u8)?), planes(u)?),
            5 => Self::Perspective(field_of_view(u)?, Some(scalar(u)?), planes(u)?),
            _ => Self::Perspective(field_of_view(u)?, None, planes(u)?),
        })
    }

    /// The crate's projection, if the crate accepts these numbers.
    pub fn projection(self, frame: (u32, u32)) -> Result<Projected, Error> {
        Ok(match self {
            Self::Perspective(fov, aspect, [near, far]) => Projected::Perspective(match aspect {
                None => Projection::perspective(fov, frame, near, far),
                Some(ratio) => Projection::perspective(fov, ratio, near, far),
            }?),
            Self::Focal(pixels, [near, far]) => {
                Projected::Perspective(Projection::from_focal_length(pixels, frame, near, far)?)
            }
            Self::Frustum([l, r, b, t, n, f]) => {
                Projected::Perspective(Projection::frustum(window(l, r, b, t), n, f)?)
            }
            Self::Orthographic([l, r, b, t, n, f]) => {
                Projected::Parallel(Projection::orthographic(window(l, r, b, t), n, f)?)
            }
            Self::Oblique(angle, ratio, [l, r, b, t, n, f]) => Projected::Parallel(
                Projection::oblique(angle, ratio, n, window(l, r, b, t), n, f)?,
            ),
        })
    }

    /// The model's projection for numbers that the crate accepted.
    pub fn model(self, frame: (u32, u32)) -> ModelProjection {
        let exact = |numbers: [Scalar; 6]| numbers.map(f64::from);
        match self {
            Self::Perspective(fov, aspect, [near, far]) => {
                let aspect =
                    aspect.map_or_else(|| f64::from(frame.0) / f64::from(frame.1), f64::from);
                projection::perspective(radians(fov), aspect, near.into(), far.into())
            }
            Self::Focal(pixels, [near, far]) => {
                projection::focal(pixels.into(), frame, near.into(), far.into())
            }
            Self::Frustum(edges) => {
                let [l, r, b, t, n, f] = exact(edges);
                projection::frustum(l, r, b, t, n, f)
            }
            Self::Orthographic(edges) => {
                let [l, r, b, t, n, f] = exact(edges);
                projection::orthographic(l, r, b, t, n, f)
            }
            Self::Oblique(angle, ratio, edges) => {
                let [l, r, b, t, n, f] = exact(edges);
                // The crate's oblique projection keeps points of the near plane in place. The model's oblique
                // projection keeps points of the plane through the eye in place.
                let (angle, ratio) = (radians(angle), f64::from(ratio));
                let (x, y) = (n * ratio * angle.cos(), n * ratio * angle.sin());
                projection::oblique(angle, ratio, (l + x, r + x, b + y, t + y), n, f)
            }
        }
    }
}

fn window(left: Scalar, right: Scalar, bottom: Scalar, top: Scalar) -> Window {
    Window {
        left,
        right,
        bottom,
        top,
    }
}
