//! Chooses the camera in the model's own units. Options that the user gave are kept. The other options get values that
//! show the whole model.
//!
//! The computation uses f64, because it runs only on the host. `units` and `view` pass the result to the library.

mod fit;
pub mod turntable;

use crate::Result;
use crate::args::{Args, DepthBuffer, Kind, Named};
use fit::range;
use fixel_assets::vector::{along, cross, dot, largest, length, sub, unit};

/// The fraction of the picture's width or height that the model fills.
const FILL: f64 = 0.94;
/// The default field of view, in degrees.
const FIELD_OF_VIEW: f64 = 40.0;
/// The field of view, in degrees, if parts of the model are behind the eye.
const WIDE: f64 = 100.0;
/// Half of the picture's height, relative to the radius of the model, if the model is a line that is seen from its end.
const LEAST: f64 = 1e-3;
/// The default direction from the model to the eye, if y is up: in front, a little to the right and above.
const FROM: Point = [0.55, 0.6, 1.0];
/// The default direction for the oblique projections, because these show the top and the side of a model even if it is
/// seen from the front.
const FRONT: Point = [0.0, 0.0, 1.0];

pub use fixel_assets::vector::Vector as Point;

/// A camera and its view.
#[derive(Clone, Copy, Debug)]
pub struct Framing {
    pub eye: Point,
    /// The point in the middle of the picture.
    pub target: Point,
    /// The direction that is up, of any length, as the user wrote it.
    pub up: Point,
    /// The vertical field of view in degrees. The picture of a parallel projection is as high as this angle spans at
    /// the target's distance.
    pub fov: f64,
    pub near: f64,
    pub far: f64,
    /// Unit vectors that point right, up, and back from the target to the eye.
    pub axes: [Point; 3],
    kind: Kind,
    aspect: f64,
    /// The distances of the nearest and the farthest point.
    range: [f64; 2],
    /// The largest distance of a point in all poses to which the user can turn the model.
    farthest: f64,
}

/// The position and the size of a model.
#[derive(Clone, Copy, Debug)]
pub struct Solid {
    /// The center of the box around the model.
    pub middle: Point,
    /// The largest distance of a point from the center, measured along one axis.
    pub radius: f64,
}

impl Solid {
    /// The points must not all be in one place.
    pub fn of(points: &[Point]) -> Self {
        let sides = [0, 1, 2].map(|axis| range(points.iter().map(|p| p[axis])));
        let radius = sides
            .iter()
            .map(|[low, high]| high / 2.0 - low / 2.0)
            .fold(0.0, f64::max);
        let middle = sides.map(|[low, high]| f64::midpoint(low, high));
        Self { middle, radius }
    }

    /// Rounds a chosen coordinate to a hundred-thousandth of the model, so that the coordinate is easy to read and
    /// type.
    fn rounded(&self, value: f64) -> f64 {
        #[allow(clippy::cast_possible_truncation)] // a logarithm
        let decimals = 5 - self.radius.log10().floor() as i32;
        let rounded = if let Ok(decimals) = usize::try_from(decimals) {
            format!("{value:.decimals$}").parse().unwrap_or(value)
        } else {
            let step = 10_f64.powi(-decimals);
            (value / step).round() * step
        };
        // Adding 0 turns -0 into 0, which is not printed as "-0".
        rounded + 0.0
    }
}

/// Returns axes that point right, up, and along `back`; `None` if `up` is within 1e-5 of the line of `back`. This check
/// is stricter than the library's.
pub fn basis(back: Point, up: Point) -> Option<[Point; 3]> {
    let (back, up) = (unit(back)?, unit(up)?);
    let right = cross(up, back);
    if largest(right) < 1e-5 {
        return None;
    }
    let right = unit(right)?;
    Some([right, cross(back, right), back])
}

/// Turns a direction along the shortest arc from +y to `up`, which has length one. If z points up, a model's front is
/// then at −y, where modeling programs expect the front.
fn upright([x, y, z]: Point, up: Point) -> Point {
    // For half a turn, there are many shortest arcs. A turn about z keeps the model's front in front.
    if up[1] < -1.0 + 1e-12 {
        return [-x, -y, z];
    }
    // With the axis a = (0, 1, 0) × u, Rodrigues' formula is d + a × d + a × (a × d) / (1 + cosine).
    let axis = cross([0.0, 1.0, 0.0], up);
    let once = cross(axis, [x, y, z]);
    let twice = cross(axis, once);
    [0, 1, 2].map(|i| [x, y, z][i] + once[i] + twice[i] / (1.0 + up[1]))
}

/// Returns how far the oblique projections move a point to the right and up in the picture, per unit of its distance
/// behind the near plane. Lines along depth appear at 45 degrees.
fn shear(kind: Kind) -> f64 {
    let ratio = match kind {
        Kind::Perspective | Kind::Orthographic => 0.0,
        Kind::Cabinet => 0.5,
        Kind::Cavalier => 1.0,
    };
    ratio * std::f64::consts::FRAC_1_SQRT_2
}

/// Returns the points relative to `center`, along the `axes`.
fn seen(axes: &[Point; 3], center: Point, points: &[Point]) -> Vec<Point> {
    let from = |&p: &Point| axes.map(|axis| dot(axis, sub(p, center)));
    points.iter().map(from).collect()
}

/// Returns the tangent of half of an angle, given in degrees.
fn half_tangent(degrees: f64) -> f64 {
    (degrees.to_radians() / 2.0).tan()
}

/// Formats a point as users write it in an option.
pub fn written([x, y, z]: Point) -> String {
    format!("{x},{y},{z}")
}

/// Rounds a number to five digits.
pub fn about(value: f64) -> f64 {
    to_digits(value, 5)
}

fn to_digits(value: f64, digits: usize) -> f64 {
    let decimals = digits - 1;
    format!("{value:.decimals$e}").parse().unwrap_or(value)
}

/// Returns the largest ratio of far to near that the program chooses, by the rule in the guide (concepts, Depth).
fn most_ratio(depth: DepthBuffer) -> f64 {
    match depth {
        DepthBuffer::Linear => 500.0,
        DepthBuffer::Float | DepthBuffer::Wide => 30_000.0,
    }
}

/// The input for the choice of an eye.
struct Choice<'a> {
    args: &'a Args,
    points: &'a [Point],
    solid: &'a Solid,
    aspect: f64,
}

impl Choice<'_> {
    /// Returns the nearest eye that shows all points, and the point in the middle of the eye's picture.
    fn eye(&self, up: Point) -> Option<[Point; 2]> {
        let args = self.args;
        let shear = shear(args.projection);
        let from = if shear > 0.0 { FRONT } else { FROM };
        let axes = basis(upright(from, up), up)?;
        let moves = args.look_at.is_none();
        let center = args.look_at.unwrap_or(self.solid.middle);
        let seen = seen(&axes, center, self.points);
        let [back, front] = range(seen.iter().map(|p| p[2]));
        let place = |axis: usize| seen.iter().map(move |p| [p[axis], p[2]]);
        let mut middle = [0.0; 2];
        let distance = if args.projection == Kind::Perspective {
            let slope = half_tangent(args.fov.unwrap_or(FIELD_OF_VIEW)) * FILL;
            // However wide the view is, the model stays beyond the near plane, because the farthest point is at most
            // 100 times as far away as the nearest point.
            let closest = front + ((front - back) / 99.0).max(self.solid.radius * 0.01);
            let distance = fit::distance(place(0), slope * self.aspect, moves)
                .max(fit::distance(place(1), slope, moves))
                .max(closest)
                .max(self.solid.radius * 0.01);
            if moves {
                middle = [0, 1]
                    .map(|axis| fit::center(&place(axis).map(move |[x, z]| [x, distance - z])));
            }
            distance
        } else {
            let place = |axis: usize| place(axis).map(move |[x, z]| x - shear * z);
            if moves {
                middle = [0, 1].map(|axis| {
                    let [low, high] = range(place(axis));
                    f64::midpoint(low, high)
                });
            }
            let sides = [0, 1].map(|axis| range(place(axis).map(|x| (x - middle[axis]).abs()))[1]);
            let half = self.half(sides, self.solid.radius * LEAST);
            match args.fov {
                Some(fov) => half / half_tangent(fov),
                None => front.max(0.0) + half.max(self.solid.radius) * 2.0,
            }
        };
        let target = along(along(center, axes[0], middle[0]), axes[1], middle[1]);
        Some([along(target, axes[2], distance), target])
    }

    /// Returns half of the height of a picture that shows points up to `x` beside its middle and up to `y` above it.
    /// The result is at least `least` / [`FILL`], because all points can be in the middle.
    fn half(&self, [x, y]: [f64; 2], least: f64) -> f64 {
        (x / self.aspect).max(y).max(least) / FILL
    }

    /// Returns the point that `eye` must look at to have all points in the middle of its picture. The function turns
    /// the camera to the middle of the points' angles again and again, until the camera no longer moves. If the eye is
    /// among the points, the camera looks at the middle of the model.
    fn target(&self, eye: Point, up: Point) -> Point {
        let mut target = self.solid.middle;
        if self.args.projection != Kind::Perspective {
            return target;
        }
        for _ in 0..32 {
            let back = sub(eye, target);
            let Some(axes) = basis(back, up) else {
                break;
            };
            let seen = seen(&axes, eye, self.points);
            if seen.iter().any(|p| p[2] >= 0.0) {
                return self.solid.middle;
            }
            let distance = dot(back, axes[2]);
            let angles = [0, 1].map(|axis| {
                let [low, high] = range(seen.iter().map(|p| (p[axis] / -p[2]).atan()));
                f64::midpoint(low, high)
            });
            for (axis, angle) in angles.into_iter().enumerate() {
                target = along(target, axes[axis], angle.tan() * distance);
            }
            if angles.iter().all(|angle| angle.abs() < 1e-9) {
                break;
            }
        }
        target
    }
}

impl Framing {
    /// Chooses the options that `args` leave open so that all `points` are visible and as large as possible.
    ///
    /// The value of each option is rounded as it is printed, and all other numbers are derived from the rounded values.
    /// So the printed options make the same picture.
    ///
    /// # Errors
    ///
    /// The camera makes no sense, or no point lies between its near and far planes. The message names the option.
    pub fn new(args: &Args, points: &[Point], solid: &Solid) -> Result<Self> {
        let written_up = args.up();
        let up = unit(written_up)
            .ok_or_else(|| format!("--up {}: it must not be zero", written(written_up)))?;
        let aspect = f64::from(args.size.0.max(1)) / f64::from(args.size.1.max(1));
        let choice = Choice {
            args,
            points,
            solid,
            aspect,
        };
        let along_view = || {
            let line = format!("{} is along the line of sight", written(written_up));
            match args.up {
                Some(_) => format!("--up {line}: it must not be"),
                None => format!("the default --up {line}: give another one"),
            }
        };
        let round = |point: Point| point.map(|x| solid.rounded(x));
        let [eye, target] = match args.eye {
            None => {
                let [eye, target] = choice.eye(up).ok_or_else(along_view)?;
                [round(eye), args.look_at.unwrap_or_else(|| round(target))]
            }
            Some(eye) => [
                eye,
                args.look_at
                    .unwrap_or_else(|| round(choice.target(eye, up))),
            ],
        };
        if sub(eye, target).iter().all(|&x| x == 0.0) {
            return Err(format!(
                "eye and target are both at {}: --eye and --look-at must differ",
                written(eye)
            )
            .into());
        }
        let axes = basis(sub(eye, target), up).ok_or_else(along_view)?;
        let mut framing = Self {
            eye,
            target,
            up: written_up,
            fov: 0.0,
            near: 0.0,
            far: 0.0,
            axes,
            kind: args.projection,
            aspect,
            range: [0.0; 2],
            farthest: 0.0,
        };
        let seen = seen(&axes, eye, points);
        framing.range = range(seen.iter().map(|p| -p[2]));
        framing.farthest = framing.range[1];
        framing.fov = args.fov.unwrap_or_else(|| {
            if args.eye.is_none() && args.projection == Kind::Perspective {
                FIELD_OF_VIEW
            } else {
                framing.fitting(&choice, &seen)
            }
        });
        framing.planes(args)?;
        Ok(framing)
    }

    /// Returns the field of view that shows all points. `seen` are the points, seen from the eye.
    fn fitting(&self, choice: &Choice<'_>, seen: &[Point]) -> f64 {
        let least = choice.solid.radius * LEAST;
        let half = if self.kind == Kind::Perspective {
            if self.range[0] <= 0.0 {
                return WIDE;
            }
            let slope = |axis: usize| range(seen.iter().map(|p| (p[axis] / p[2]).abs()))[1];
            choice.half([slope(0), slope(1)], least / self.range[0])
        } else {
            let (distance, shear) = (self.distance(), shear(self.kind));
            let side = |axis: usize| {
                let place = |p: &Point| (p[axis] - shear * (p[2] + distance)).abs();
                range(seen.iter().map(place))[1]
            };
            choice.half([side(0), side(1)], least) / distance
        };
        // Many digits are kept, because near 180 degrees the size of the picture depends on the last digits.
        to_digits((half.atan() * 2.0).to_degrees().min(179.99), 8)
    }

    /// Sets the near and far planes: as the user gave them, or a little in front of all points and behind them.
    fn planes(&mut self, args: &Args) -> Result<()> {
        let [low, high] = self.range;
        let is_perspective = self.is_perspective();
        if is_perspective && high <= 0.0 {
            let (eye, target) = (written(self.eye), written(self.target));
            return Err(format!(
                "nothing is visible: the whole model is behind an eye at {eye} that looks at {target}"
            )
            .into());
        }
        let place = format!(
            "the model is {} to {} from the eye",
            about(low),
            about(high)
        );
        if let Some(near) = args.near.filter(|&near| near > high) {
            let most = about(high);
            return Err(format!("--near {near}: {place}: it must be below {most}").into());
        }
        if let Some(far) = args.far.filter(|&far| far < low) {
            let least = about(low);
            return Err(format!("--far {far}: {place}: it must be above {least}").into());
        }
        let margin = (high - low) * 0.02 + high.abs() * 0.001;
        let behind = about(high + margin);
        self.far = args.far.unwrap_or(behind);
        // If the eye is inside the model, `ratio` limits the near plane. Anything nearer is not drawn.
        let ratio = most_ratio(args.depth);
        self.near = args.near.unwrap_or(about(if is_perspective {
            (low - margin).max(self.far.min(behind) / ratio)
        } else {
            low - margin
        }));
        let (near, far) = (self.near, self.far);
        if is_perspective && near <= 0.0 {
            return Err(format!("--near {near}: it must be above 0, in front of the eye").into());
        }
        if far <= near {
            return Err(match args.far {
                Some(_) => format!("--far {far}: it must be beyond the near plane at {near}"),
                None => format!("--near {near}: it must be in front of the far plane at {far}"),
            }
            .into());
        }
        Ok(())
    }

    /// Moves the near and far planes, except if the user gave them, so that the user can turn the model in any way
    /// about the point `middle`, and enlarge it up to `zoom` times.
    pub fn widen(&mut self, args: &Args, points: &[Point], middle: Point, zoom: f64) {
        let distance = |p: Point| length(sub(p, middle));
        let eye = distance(self.eye);
        // The last term is larger than the rounding errors.
        let reach = points.iter().map(|&p| distance(p)).fold(0.0, f64::max) * zoom + eye * 0.001;
        self.farthest = self.farthest.max(eye + reach);
        let far = self.far.max(eye + reach);
        let near = if self.is_perspective() {
            (eye - reach).max(far / most_ratio(args.depth))
        } else {
            eye - reach
        };
        self.near = args.near.unwrap_or(about(near.min(self.near)));
        self.far = args.far.unwrap_or(about(far));
    }

    /// Whether another camera has the same near and far planes.
    pub fn has_planes_of(&self, other: &Self) -> bool {
        self.near.total_cmp(&other.near).is_eq() && self.far.total_cmp(&other.far).is_eq()
    }

    pub fn is_perspective(&self) -> bool {
        self.kind == Kind::Perspective
    }

    fn distance(&self) -> f64 {
        dot(self.axes[2], sub(self.eye, self.target))
    }

    /// Returns the left, right, bottom and top edges of a parallel projection's picture.
    pub fn window(&self) -> [f64; 4] {
        let half = half_tangent(self.fov) * self.distance();
        // The shear does not move the near plane, but moves the target, which is behind it.
        let middle = shear(self.kind) * (self.distance() - self.near);
        let side = half * self.aspect;
        [middle - side, middle + side, middle - half, middle + half]
    }

    /// Returns the direction toward the light: over the viewer's left shoulder.
    pub fn light(&self) -> Point {
        let [right, up, back] = self.axes;
        [0, 1, 2].map(|i| back[i] + up[i] * 0.9 - right[i] * 0.6)
    }

    /// Returns the distance of the far plane, or of a nearer plane behind the model that gives the same picture.
    pub fn useful_far(&self) -> f64 {
        let behind = self.farthest * 2.0;
        if self.is_perspective() && behind > self.near {
            self.far.min(behind)
        } else {
            self.far
        }
    }

    /// Returns the largest number that must fit into the format: a coordinate of the model or of the eye, relative to
    /// the middle of the model, or the distance of a plane or of the window's edge. (The target counts as a sixteenth,
    /// and fog as a half.)
    ///
    /// # Errors
    ///
    /// A value exceeds `limit`. The message names the option.
    pub fn reach(&self, args: &Args, solid: &Solid, limit: f64) -> Result<f64> {
        let window = self.window().map(f64::abs);
        let window = if self.is_perspective() {
            0.0
        } else {
            window.into_iter().fold(0.0, f64::max)
        };
        // Fog is not a position, so it can use the whole range of the format, which is twice as large.
        let fog = args
            .fog
            .map_or(0.0, |fog| fog.near.abs().max(fog.far.abs()));
        let eye = largest(sub(self.eye, solid.middle));
        let reaches = [
            ("--look-at", largest(sub(self.target, solid.middle)) / 16.0),
            ("--fog", fog / 2.0),
            (if args.eye.is_some() { "--eye" } else { "--fov" }, eye),
            ("--far", self.useful_far().abs()),
            ("--near", self.near.abs()),
            ("--fov", window),
            ("the model", solid.radius),
        ];
        for (option, reach) in reaches {
            if reach > limit {
                return Err(format!(
                    "{option}: it reaches {} from the middle of the model, {}: with this model, {} is the limit",
                    about(reach),
                    written(solid.middle.map(about)),
                    about(limit)
                )
                .into());
            }
        }
        Ok(reaches.iter().fold(0.0, |most, (_, reach)| reach.max(most)))
    }

    /// Returns the stored depths of the model's nearest and farthest points.
    pub fn depths(&self) -> [u16; 2] {
        self.range.map(|distance| {
            let depth = if self.is_perspective() {
                self.near / distance.max(self.near)
            } else {
                (self.far - distance) / (self.far - self.near)
            };
            #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // saturates
            let depth = (depth * 65535.0) as u16;
            depth
        })
    }

    /// Returns options that make the same camera.
    pub fn options(&self) -> String {
        let projection = if self.is_perspective() {
            String::new()
        } else {
            format!(" --projection {}", self.kind.name())
        };
        format!(
            "--eye {} --look-at {} --up {} --fov {} --near {} --far {}{projection}",
            written(self.eye),
            written(self.target),
            written(self.up),
            self.fov,
            self.near,
            self.far
        )
    }
}
