//! Fog at every pixel, compared with the formula in f64.

use std::cell::Cell;
use std::ops::Range;

use embedded_graphics::geometry::Point;
use embedded_graphics::pixelcolor::{Gray8, GrayColor, PixelColor, Rgb565, RgbColor};
use fixel::prelude::*;
use fixel::shade::{ExponentialFog, Output};
use fixel::texture::Blend;
use rand::Rng;

use support::mode::Mode;
use support::random::{Random, cases, sampled, within};
use support::reference::fog::{exponential, linear};

const SIZE: u32 = 48;
/// The length in pixels of one unit at distance 1.
const FOCAL: f64 = 24.;

const NEAR_PLANE: Scalar = fx!(0.01);

/// A plane through (0, 0, −distance) that leans to the right and upward: 1/z is linear on the screen.
#[derive(Clone, Copy, Debug)]
struct Plane {
    distance: f64,
    lean: [f64; 2],
}

impl Plane {
    /// The distance at a position on the screen, in pixels; infinite beyond the horizon.
    fn at(&self, x: f64, y: f64) -> f64 {
        let half = f64::from(SIZE) / 2.;
        let [u, v] = [(x - half) / FOCAL, (half - y) / FOCAL];
        let share = 1. + self.lean[0] * u + self.lean[1] * v;
        if share <= 0. {
            f64::INFINITY
        } else {
            self.distance / share
        }
    }

    /// The corners of a triangle in the plane. The triangle contains the picture.
    fn corners(&self) -> Option<[Vec3; 3]> {
        let corner = |u: f64, v: f64| {
            let share = 1. + self.lean[0] * u + self.lean[1] * v;
            let z = self.distance / share;
            (share > 0.05).then(|| Vec3::try_from([u * z, v * z, -z]).ok())?
        };
        Some([corner(-1.5, -1.5)?, corner(4., -1.5)?, corner(-1.5, 4.)?])
    }
}

/// Draws a triangle in black with white fog. Returns the brightness of each pixel, from 0 to 1.
fn white<C: Blend + PixelColor + 'static>(
    shader: impl ShaderFor<C>,
    corners: &[Vec3; 3],
    near_plane: Scalar,
    black: C,
    luma: impl Fn(C) -> f64,
) -> Vec<f64> {
    let mesh = Mesh::new(corners, &[[0, 1, 2]]).unwrap();
    let projection =
        Projection::from_focal_length(fx!(24), (SIZE, SIZE), near_plane, fx!(30_000)).unwrap();
    let mut pixels = vec![black; (SIZE * SIZE) as usize];
    let mut canvas = Canvas::new(&mut pixels, SIZE, SIZE).unwrap();
    canvas.draw_with(
        &DrawOptions::new().with_cull(Cull::Nothing),
        &mesh,
        &projection,
        &shader,
    );
    pixels.into_iter().map(luma).collect()
}

/// The share that is visible may have this error.
const PROMISED: f64 = 0.01;

/// A plain color of 16 bits rounds the share to a multiple of 1/32, so its error is up to half of 1/32 more.
const ROUNDED: f64 = 0.5 / 32.;

/// Checks the fog of each pixel: the visible share may have an error of `tolerance`, and the color has a rounding error of
/// half of one of its `steps`. `left` returns the share that is visible at a distance. Because corners are rounded to
/// 1/256 pixel, a range of distances is allowed.
fn check(
    distance: impl Fn(f64, f64) -> f64,
    shown: &[f64],
    steps: f64,
    tolerance: f64,
    left: impl Fn(f64) -> f64,
) {
    let tolerance = tolerance + 0.5 / steps;
    for (i, shown) in shown.iter().enumerate() {
        let at = [i % SIZE as usize, i / SIZE as usize].map(|at| at as f64 + 0.5);
        // A corner that is rounded by 1/512 pixel tilts the plane a little.
        let moves = [-0.01, 0.01];
        let expected = moves
            .into_iter()
            .flat_map(|x| moves.map(|y| 1. - left(distance(at[0] + x, at[1] + y))));
        let (low, high) = expected.fold((1_f64, 0_f64), |(low, high), white| {
            (low.min(white), high.max(white))
        });
        assert!(
            (low - tolerance..=high + tolerance).contains(shown),
            "{shown} is not between {low} and {high} at {at:?}"
        );
    }
}

#[test]
fn fog_is_correct_in_perspective_at_every_pixel() {
    cases(400, |random| {
        let distance = random.random_range(0.5..60_f64);
        let lean = within(random, [-0.54..0.54, -0.54..0.54]);
        let near = random.random_range(0.1..1.5_f64);
        let length = random.random_range(0.1..3_f64);
        let density = random.random_range(0.0..3_f64);
        let plane = Plane { distance, lean };
        let Some(corners) = plane.corners() else {
            return;
        };
        let [near, far] = [near, near + length].map(|at| Scalar::try_from(at * distance).unwrap());
        let left = |z: f64| linear(z, f64::from(near), f64::from(far));
        let gray = |color: Gray8| f64::from(color.luma()) / 255.;

        let green = |color: Rgb565| f64::from(color.g()) / 63.;
        let density = Scalar::try_from(density / distance).unwrap();
        let thin = |z: f64| exponential(z, f64::from(density));

        let black = Flat::new(Gray8::BLACK);
        let plane = |x, y| plane.at(x, y);
        let fog = Fog::linear(Gray8::WHITE, near, far).unwrap();
        let shown = white(black.in_fog(fog), &corners, NEAR_PLANE, Gray8::BLACK, gray);
        check(plane, &shown, 255., PROMISED, left);
        let fog = Fog::exponential(Gray8::WHITE, density).unwrap();
        let shown = white(black.in_fog(fog), &corners, NEAR_PLANE, Gray8::BLACK, gray);
        check(plane, &shown, 255., PROMISED, thin);

        let black = Flat::new(Rgb565::BLACK);
        let fog = Fog::linear(Rgb565::WHITE, near, far).unwrap();
        let shown = white(
            black.in_fog(fog),
            &corners,
            NEAR_PLANE,
            Rgb565::BLACK,
            green,
        );
        check(plane, &shown, 63., PROMISED + ROUNDED, left);
        let fog = Fog::exponential(Rgb565::WHITE, density).unwrap();
        let shown = white(
            black.in_fog(fog),
            &corners,
            NEAR_PLANE,
            Rgb565::BLACK,
            green,
        );
        check(plane, &shown, 63., PROMISED + ROUNDED, thin);
    });
}

/// A floor from behind the eye to a distance of 30,000, in dense fog. The near plane clips it, so the distances of its
/// points have a ratio of 100,000.
#[test]
fn a_floor_to_the_horizon_fades_where_it_should() {
    let near_plane = fx!(0.3);
    let corners = [
        vec3!(-30_000, -0.25, 5),
        vec3!(30_000, -0.25, 5),
        vec3!(0, -0.25, -30_000),
    ];
    let half = f64::from(SIZE) / 2.;
    for density in [fx!(5), fx!(4), fx!(2), fx!(0.1)] {
        let fog = Fog::exponential(Gray8::WHITE, density).unwrap();
        let shader = Flat::new(Gray8::BLACK).in_fog(fog);
        let gray = |color: Gray8| f64::from(color.luma()) / 255.;
        let shown = white(shader, &corners, near_plane, Gray8::BLACK, gray);
        // Above the floor and nearer than the near plane, nothing is drawn: this is as black as a surface without fog.
        check(
            |_, y| match 0.25 * FOCAL / (y - half) {
                distance if distance > 0.3 => distance,
                _ => 0.,
            },
            &shown,
            255.,
            PROMISED,
            |z| exponential(z, f64::from(density)),
        );
    }
}

/// The columns and the rows of the canvas of a [`Scene`]. A span has at most 64 pixels.
const WIDE: u32 = 64;
const ROWS: u32 = 8;
/// The columns and the rows in which corners lie, in units of 1/256 pixel.
const PLACES: [Range<i32>; 2] = [-(8 << 8)..72 << 8, -(8 << 8)..16 << 8];
/// The length in pixels of one unit at distance 1, for a [`Scene`].
const ZOOM: f64 = 48.;

/// The kinds of fog.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Kind {
    Linear,
    Exponential,
}

/// A triangle in fog. The rasterizer does not move its corners, because they lie on multiples of 1/256 pixel.
#[derive(Clone, Copy, Debug)]
struct Scene {
    /// The corners on the screen, in units of 1/256 pixel.
    corners: [[i32; 2]; 3],
    /// The binary logarithms of the corners' distances.
    distances: [f64; 3],
    /// Where the fog shows, from the nearest corner (0) to the farthest (1).
    place: f64,
    /// How thin or dense the fog is, from 0 to the limit of the promise, 1.
    thin: f64,
}

impl Scene {
    /// The binary logarithms of the least and the greatest distance, 0.19 and 25,000.
    const LOG: [f64; 2] = [-2.4, 14.6];

    fn random(random: &mut Random) -> Self {
        let nearest = random.random_range(Self::LOG[0]..Self::LOG[1]);
        // Most modes draw a triangle without divisions if it hardly changes in depth.
        let most = nearest
            + (Self::LOG[1] - nearest) * 2_f64.powi(-random.random_range(-8_i32..12).max(0));
        Self {
            corners: [(); 3].map(|()| within(random, PLACES)),
            distances: [(); 3].map(|()| random.random_range(nearest..=most)),
            place: random.random(),
            thin: random.random(),
        }
    }

    /// A scene that differs in one respect, by a little or by much.
    fn neighbor(mut self, random: &mut Random) -> Self {
        let size = 2_f64.powi(-random.random_range(0..8));
        let at = random.random_range(0..3);
        let step = random.random_range(-size..size);
        let moved = |distance: f64, by: f64| (distance + by).clamp(Self::LOG[0], Self::LOG[1]);
        match random.random_range(0..6) {
            0 => self.corners[at][0] += (step * 4096.) as i32,
            1 => self.corners[at][1] += (step * 1024.) as i32,
            2 => self.distances[at] = moved(self.distances[at], step * 4.),
            3 => self.distances = self.distances.map(|distance| moved(distance, step)),
            4 => self.place = (self.place + step).clamp(0., 1.),
            _ => self.thin = (self.thin + step).clamp(0., 1.),
        }
        for corner in &mut self.corners {
            for (place, Range { start, end }) in corner.iter_mut().zip(PLACES) {
                *place = (*place).clamp(start, end);
            }
        }
        self
    }

    fn distances(&self) -> [Scalar; 3] {
        self.distances.map(|z| Scalar::try_from(z.exp2()).unwrap())
    }

    /// The nearest and the farthest distance of a corner.
    fn ends(&self) -> [f64; 2] {
        let [a, b, c] = self.distances().map(f64::from);
        [a.min(b).min(c), a.max(b).max(c)]
    }

    /// The corners in space. x and y are rounded to 2^-16, which moves a corner on the screen by less than half of
    /// 1/256 pixel.
    fn positions(&self) -> Option<[Vec3; 3]> {
        let distances = self.distances();
        let corner = |at: usize| {
            let z = f64::from(distances[at]);
            let [x, y] = self.corners[at].map(|place| f64::from(place) / 256.);
            let [x, y] = [x - f64::from(WIDE) / 2., f64::from(ROWS) / 2. - y];
            Vec3::try_from([x * z / ZOOM, y * z / ZOOM, -z]).ok()
        };
        Some([corner(0)?, corner(1)?, corner(2)?])
    }

    /// The distance at each pixel whose center is inside of the triangle.
    fn pixels(&self) -> Vec<(usize, f64)> {
        let corners = self.corners.map(|corner| corner.map(f64::from));
        let area = |[ax, ay]: [f64; 2], [bx, by]: [f64; 2], [cx, cy]: [f64; 2]| {
            (bx - ax) * (cy - ay) - (by - ay) * (cx - ax)
        };
        let [a, b, c] = corners;
        let [za, zb, zc] = self.distances().map(f64::from);
        let whole = area(a, b, c);
        let mut pixels = Vec::new();
        for at in 0..WIDE * ROWS {
            let center = [at % WIDE, at / WIDE].map(|place| f64::from(256 * place + 128));
            let weights = [area(center, b, c), area(a, center, c), area(a, b, center)];
            let [u, v, w] = weights.map(|part| part / whole);
            if whole != 0. && u > 0. && v > 0. && w > 0. {
                pixels.push((at as usize, 1. / (u / za + v / zb + w / zc)));
            }
        }
        pixels
    }
}

/// Draws the triangle in black with white fog, in a format whose colors are not rounded. Returns the share of the surface
/// that is visible at each pixel; `None` where nothing is drawn.
fn visible<S: Shader<Color: Output<Color = Gray8>>>(
    positions: &[Vec3; 3],
    mode: Mode,
    shader: &S,
) -> Vec<Option<f64>> {
    let shares = vec![Cell::new(None); (WIDE * ROWS) as usize];
    // The color is read before the canvas rounds it.
    let read = shader.map(|at, output| {
        let precise = output.map(|color| {
            let [white, ..] = color.fractions();
            let Point { x, y } = at.point;
            shares[y as usize * WIDE as usize + x as usize]
                .set(Some(1. - f64::from(white) / 65_536.));
            color
        });
        Some(precise.finish(at.point))
    });
    let mut pixels = [Gray8::BLACK; (WIDE * ROWS) as usize];
    let mut canvas = Canvas::new(&mut pixels, WIDE, ROWS).unwrap();
    let mesh = Mesh::new(positions, &[[0, 1, 2]]).unwrap();
    let options = DrawOptions::new().with_cull(Cull::Nothing);
    mode.draw(&mut canvas, &options, &mesh, &projection().into(), &read);
    shares.into_iter().map(Cell::into_inner).collect()
}

/// The projection of a [`Scene`].
fn projection() -> Projection {
    let zoom = Scalar::try_from(ZOOM).unwrap();
    Projection::from_focal_length(zoom, (WIDE, ROWS), fx!(0.125), fx!(32_000)).unwrap()
}

/// A fog in which a promise holds for this scene. `None` if the promise holds in no fog, or if the numbers cannot be
/// represented.
enum Promised {
    Linear(Fog<Gray8>, [f64; 2]),
    Exponential(Fog<Gray8, ExponentialFog>, f64),
}

impl Promised {
    /// The conditions of [`Fog`]: the distances in a triangle have the ratio R, and k is far / (far − near).
    fn new(scene: &Scene, kind: Kind, mode: Mode) -> Option<Self> {
        let [nearest, farthest] = scene.ends();
        let ratio = farthest / nearest;
        let is_fast = matches!(mode, Mode::Fast(_));
        let (most_ratio, most_thin) = match kind {
            _ if is_fast => (1e3, 4.),
            Kind::Linear => (3e4, 3e4),
            Kind::Exponential => (1e5, 1.),
        };
        if ratio > most_ratio {
            return None;
        }
        let there = nearest * ratio.powf(scene.place);
        match kind {
            Kind::Linear => {
                let most = (most_ratio / ratio).min(most_thin);
                let far = Scalar::try_from(there).ok()?;
                let near = Scalar::try_from(there * (1. - most.powf(-scene.thin))).ok()?;
                let fog = Fog::linear(Gray8::WHITE, near, far).ok()?;
                let ends = [near, far].map(f64::from);
                let thin = ends[1] / (ends[1] - ends[0]);
                (thin <= most).then_some(Self::Linear(fog, ends))
            }
            Kind::Exponential => {
                // At the distance `there`, e^-6 of the surface is visible at least. Where this takes too great a density, the
                // fog has the greatest.
                let density = Scalar::try_from(6. * scene.thin / there).ok()?;
                let fog = |density| Some((Fog::exponential(Gray8::WHITE, density).ok()?, density));
                let (fog, density) = fog(density).or_else(|| fog(fx!(5)))?;
                Some(Self::Exponential(fog, density.into()))
            }
        }
    }

    fn left(&self, distance: f64) -> f64 {
        match *self {
            Self::Linear(_, [near, far]) => linear(distance, near, far),
            Self::Exponential(_, density) => exponential(distance, density),
        }
    }
}

/// The greatest error of the visible share in a scene; 0 if fog promises nothing for the scene.
fn worst(scene: &Scene, kind: Kind, mode: Mode) -> f64 {
    let promised = Promised::new(scene, kind, mode).zip(scene.positions());
    let Some((promised, positions)) = promised else {
        return 0.;
    };
    let black = Flat::new(Gray8::BLACK);
    let shown = match promised {
        Promised::Linear(fog, _) => visible(&positions, mode, &black.in_fog(fog)),
        Promised::Exponential(fog, _) => visible(&positions, mode, &black.in_fog(fog)),
    };
    let errors = scene.pixels().into_iter().map(|(at, distance)| {
        let shown = shown[at].expect("a pixel inside of the triangle is drawn");
        (shown - promised.left(distance)).abs()
    });
    errors.fold(0., f64::max)
}

/// Climbs from random scenes to worse neighbors, and checks that no scene breaks the promise.
fn search(kind: Kind, modes: &[Mode]) {
    for &mode in modes {
        // Each sum is derived in the guide's page about modes.
        let promised = match (mode, kind) {
            (Mode::Compact | Mode::Exact, Kind::Linear) => 0.0068,
            (Mode::Compact | Mode::Exact, Kind::Exponential) => 0.0051,
            _ => PROMISED,
        };
        let mut greatest = 0_f64;
        cases(sampled(240), |random| {
            let mut scene = Scene::random(random);
            let mut error = worst(&scene, kind, mode);
            for _ in 0..250 {
                let next = scene.neighbor(random);
                let next_error = worst(&next, kind, mode);
                if next_error >= error {
                    (scene, error) = (next, next_error);
                }
            }
            assert!(
                error <= promised,
                "{error} in {mode:?}, {kind:?}: {scene:?}"
            );
            greatest = greatest.max(error);
        });
        println!("{kind:?} fog, {mode:?}: an error of {greatest:.4}");
    }
}

/// The modes with a promise. A greater tolerance of `Fast` makes pieces longer, up to a limit that a tolerance of 4 texels
/// leaves to the condition on 1/w alone: 4 texels are 16 times the whole share of linear fog.
const MODES: [Mode; 4] = [Mode::Newton, Mode::Fast(fx!(4)), Mode::Compact, Mode::Exact];

#[test]
fn a_search_finds_no_greater_error_of_linear_fog() {
    search(Kind::Linear, &MODES);
}

#[test]
fn a_search_finds_no_greater_error_of_exponential_fog() {
    search(Kind::Exponential, &MODES);
}
