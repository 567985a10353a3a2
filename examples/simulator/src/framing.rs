//! Chooses the parts of the camera that the user did not give, so that the model fills the picture.
//!
//! Set-up on the host, in f64. The library receives the results and checks them.

use crate::args::{Args, Kind};

/// Part of the picture's width and height that the model fills.
const FILL: f64 = 0.94;
/// Default field of view, in degrees.
const FIELD_OF_VIEW: f64 = 40.0;
/// Default direction from the model to the eye: in front, a little right and above.
const FROM: [f64; 3] = [0.55, 0.6, 1.0];
/// The same for the oblique projections, which show top and side of a model seen from the front.
const FRONT: [f64; 3] = [0.0, 0.0, 1.0];

type Point = [f64; 3];

/// A camera and its view.
#[derive(Clone, Copy, Debug)]
pub struct Framing {
    pub eye: Point,
    pub target: Point,
    /// Vertical field of view in degrees; used by perspective only.
    pub fov: f64,
    /// Left, right, bottom, top of the picture at any distance; used by parallel projections only.
    pub window: [f64; 4],
    pub near: f64,
    pub far: f64,
    /// Towards the light: over the viewer's left shoulder.
    pub light: Point,
    /// Distances of the nearest and the farthest point.
    range: [f64; 2],
}

fn sub(a: Point, b: Point) -> Point {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn along(a: Point, direction: Point, by: f64) -> Point {
    [0, 1, 2].map(|i| a[i] + direction[i] * by)
}

fn dot(a: Point, b: Point) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn cross(a: Point, b: Point) -> Point {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

fn unit(a: Point) -> Option<Point> {
    let length = dot(a, a).sqrt();
    (length > 1e-12).then(|| a.map(|x| x / length))
}

/// Returns the smallest and the largest of `values`.
fn range(values: impl Iterator<Item = f64>) -> (f64, f64) {
    values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| {
        (low.min(x), high.max(x))
    })
}

/// Returns the middle of the box around `points`.
pub fn middle(points: &[Point]) -> Point {
    [0, 1, 2].map(|axis| {
        let (low, high) = range(points.iter().map(|p| p[axis]));
        f64::midpoint(low, high)
    })
}

/// Returns how far the oblique projections move a point right and up in the picture, for each unit that it lies
/// behind the near plane. Depth recedes at 45 degrees.
fn shear(kind: Kind) -> f64 {
    let ratio = match kind {
        Kind::Perspective | Kind::Orthographic => 0.0,
        Kind::Cabinet => 0.5,
        Kind::Cavalier => 1.0,
    };
    ratio * std::f64::consts::FRAC_1_SQRT_2
}

/// Axes to use if `args` give no usable ones.
const AXES: [Point; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// The camera's axes: to the right, up, and back to the eye.
fn basis(back: Point, up: Point) -> Option<[Point; 3]> {
    let back = unit(back)?;
    let right = unit(cross(up, back))?;
    Some([right, cross(back, right), back])
}

/// Returns the axes that `args` ask for.
fn axes(args: &Args, center: Point) -> Option<[Point; 3]> {
    let back = match args.eye {
        Some(eye) => sub(eye, center),
        None if shear(args.projection) > 0.0 => FRONT,
        None => FROM,
    };
    basis(back, args.up())
}

/// Returns the positions of `points` relative to `center`, along the `axes`.
fn seen(axes: &[Point; 3], center: Point, points: &[Point]) -> Vec<Point> {
    let from = |&p: &Point| axes.map(|axis| dot(axis, sub(p, center)));
    points.iter().map(from).collect()
}

/// Returns the point near `center` that an eye must look at to see `points` in the middle of its picture.
fn aim(eye: Point, mut center: Point, up: Point, points: &[Point]) -> Point {
    for _ in 0..4 {
        let back = sub(eye, center);
        let Some(axes) = basis(back, up) else {
            break;
        };
        let ahead: Vec<Point> = seen(&axes, eye, points);
        if ahead.iter().any(|p| p[2] > -1e-3) {
            // The eye is among the points.
            break;
        }
        let distance = dot(back, back).sqrt();
        for axis in [0, 1] {
            let (low, high) = range(ahead.iter().map(|p| p[axis] / -p[2]));
            center = along(center, axes[axis], f64::midpoint(low, high) * distance);
        }
    }
    center
}

impl Framing {
    /// Chooses the options that `args` leave open so that all `points` are visible and as large as possible.
    ///
    /// Passes on a camera that makes no sense (the eye at its target, up along the view): the library refuses it with
    /// a better message than this function could give.
    pub fn new(args: &Args, points: &[Point]) -> Self {
        let mut center = args.look_at.unwrap_or_else(|| middle(points));
        if let (Some(eye), None, Kind::Perspective) = (args.eye, args.look_at, args.projection) {
            center = aim(eye, center, args.up(), points);
        }
        let axes = axes(args, center).unwrap_or(AXES);
        let seen = seen(&axes, center, points);
        let aspect = f64::from(args.size.0.max(1)) / f64::from(args.size.1.max(1));
        let mut framing = match args.projection {
            Kind::Perspective => Self::perspective(args, center, axes, &seen, aspect),
            _ => Self::parallel(args, center, axes, &seen, aspect),
        };
        framing.light = [0, 1, 2].map(|i| axes[2][i] + axes[1][i] * 0.9 - axes[0][i] * 0.6);
        framing.near = args.near.unwrap_or(framing.near);
        framing.far = args.far.unwrap_or(framing.far);
        framing
    }

    fn perspective(
        args: &Args,
        center: Point,
        axes: [Point; 3],
        seen: &[Point],
        aspect: f64,
    ) -> Self {
        let (eye, target, distance, fov);
        if let Some(given) = args.eye {
            distance = dot(axes[2], sub(given, center));
            let tangent = seen
                .iter()
                .filter(|p| distance - p[2] > 0.0)
                .map(|p| (p[1].abs()).max(p[0].abs() / aspect) / (distance - p[2]))
                .fold(0.0, f64::max);
            // Beyond 100 degrees the picture is mostly distortion: the eye is in the model or close to it.
            let fitting = (tangent / FILL).atan().to_degrees() * 2.0;
            fov = args.fov.unwrap_or(fitting.clamp(1.0, 100.0));
            (eye, target) = (given, center);
        } else {
            fov = args.fov.unwrap_or(FIELD_OF_VIEW);
            let tangent = (fov.to_radians() / 2.0).tan() * FILL;
            // All of |x − cx| ≤ k·(d − z): two lines in (cx, d), which meet at the smallest d.
            let fit = |axis: usize, k: f64| {
                let high = range(seen.iter().map(|p| p[axis] + k * p[2])).1;
                let low = range(seen.iter().map(|p| p[axis] - k * p[2])).0;
                if args.look_at.is_some() {
                    (high.max(-low) / k, 0.0)
                } else {
                    ((high - low) / (2.0 * k), f64::midpoint(high, low))
                }
            };
            let (dx, mut cx) = fit(0, tangent * aspect);
            let (dy, mut cy) = fit(1, tangent);
            // Keep the eye out of the model, however wide the view.
            let (back, front) = range(seen.iter().map(|p| p[2]));
            let closest = front + (front - back) * 0.01 + 1e-3;
            distance = dx.max(dy).max(closest);
            if args.look_at.is_none() {
                // The axis with room to spare: center the model.
                for (axis, center) in [(0, &mut cx), (1, &mut cy)] {
                    for _ in 0..8 {
                        let slope = |p: &Point| (p[axis] - *center) / (distance - p[2]);
                        let (low, high) = range(seen.iter().map(slope));
                        *center += f64::midpoint(low, high) * distance;
                    }
                }
            }
            target = along(along(center, axes[0], cx), axes[1], cy);
            eye = along(target, axes[2], distance);
        }
        let (nearest, farthest) = Self::planes(seen, distance);
        Self {
            eye,
            target,
            fov,
            window: [0.0; 4],
            near: nearest,
            far: farthest,
            light: axes[2],
            range: Self::distances(seen, distance),
        }
    }

    fn parallel(args: &Args, center: Point, axes: [Point; 3], seen: &[Point], aspect: f64) -> Self {
        let depth = range(seen.iter().map(|p| p[2]));
        let reach = seen.iter().map(|p| dot(*p, *p).sqrt()).fold(1e-3, f64::max);
        let (eye, distance) = if let Some(eye) = args.eye {
            (eye, dot(axes[2], sub(eye, center)))
        } else {
            let distance = depth.1.max(0.0) + reach * 0.1;
            (along(center, axes[2], distance), distance)
        };
        // The near plane does not move, but points behind it do: move the window with them.
        let (near, far) = Self::planes(seen, distance);
        let near = args.near.unwrap_or(near);
        let shear = shear(args.projection);
        let at = |p: &Point, axis: usize| p[axis] + shear * (distance - p[2] - near);
        let (left, right) = range(seen.iter().map(|p| at(p, 0)));
        let (bottom, top) = range(seen.iter().map(|p| at(p, 1)));
        let fitting = ((top - bottom) / 2.0)
            .max((right - left) / 2.0 / aspect)
            .max(1e-3)
            / FILL;
        let half = match args.fov {
            Some(fov) => (fov.to_radians() / 2.0).tan() * distance.abs(),
            None => fitting,
        };
        let (x, y) = if args.look_at.is_some() {
            (shear * (distance - near), shear * (distance - near))
        } else {
            (f64::midpoint(left, right), f64::midpoint(bottom, top))
        };
        let half = if args.fov.is_none() {
            half.max((top - y).abs().max((bottom - y).abs()) / FILL)
                .max((right - x).abs().max((left - x).abs()) / aspect / FILL)
        } else {
            half
        };
        Self {
            eye,
            target: center,
            fov: 0.0,
            window: [x - half * aspect, x + half * aspect, y - half, y + half],
            near,
            far,
            light: axes[2],
            range: Self::distances(seen, distance),
        }
    }

    /// Returns the distances of the nearest and the farthest point; the points are `seen` from the eye's `distance`.
    fn distances(seen: &[Point], distance: f64) -> [f64; 2] {
        let (low, high) = range(seen.iter().map(|p| distance - p[2]));
        [low, high]
    }

    /// Returns the near and far plane, a little in front of and behind all points.
    fn planes(seen: &[Point], distance: f64) -> (f64, f64) {
        let [low, high] = Self::distances(seen, distance);
        let margin = (high - low) * 0.02 + high.abs() * 0.001;
        let far = (high + margin).max(0.01);
        // 16-bit depth needs a far / near below 1000. An eye inside the model may not see all of it.
        ((low - margin).max(far / 500.0), far)
    }

    /// Returns the model's nearest and farthest stored depth.
    pub fn depths(&self, kind: Kind) -> [u16; 2] {
        self.range.map(|distance| {
            let depth = match kind {
                Kind::Perspective => self.near / distance.max(self.near),
                _ => (self.far - distance) / (self.far - self.near),
            };
            #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // saturates
            let depth = (depth * 65535.0) as u16;
            depth
        })
    }
}
