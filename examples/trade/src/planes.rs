//! A wall, and random and adversarial planes. Each set of triangles is difficult for a mode in a different way.
//!
//! | set | triangles |
//! |---|---|
//! | planes-tilted | seen at 60 degrees, over the whole width of 320 pixels |
//! | planes-grazing | 1/w changes by up to 1/32 of itself from one pixel of a row to the next |
//! | planes-slivers | a fraction of a pixel to a pixel and a half wide, up to 320 long, distances up to 1 : 8 |
//! | planes-deep | distances 1 : 10 to 1 : 1000 |
//!
//! A generator with a fixed seed makes the triangles, so every run has the same triangles. A run with fewer triangles
//! uses the first triangles of each set.

use fixel::prelude::*;
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

use super::Result;
use super::measure::Scene;
use support::moves::rounded;
use support::reference::coverage::area2_f64;
use support::reference::linear::IDENTITY;
use support::reference::projection::focal;
use support::reference::scenes::SIZE;
use support::reference::view::{View, Viewport};

/// A corner as it must appear: its position on the screen in pixels, its distance, and its u and v.
#[derive(Clone, Copy, Debug)]
struct Corner {
    at: [f64; 2],
    w: f64,
    uv: [f64; 2],
}

/// A function that makes a triangle of a set.
type Plane = fn(&mut Dice) -> [Corner; 3];

/// The wall of the guide's page of modes: it fills the picture, and its right end is twice as far away as its left end.
pub fn wall() -> Result<Scene> {
    let corner = |u: f64, v: f64| Corner {
        at: [u * 320., v * 240.],
        w: 1. + u,
        uv: [u, v],
    };
    let [a, b, c, d] = [
        corner(0., 0.),
        corner(0., 1.),
        corner(1., 1.),
        corner(1., 0.),
    ];
    let mut scene = Scene::new("wall");
    add(&mut scene, [a, b, c])?;
    add(&mut scene, [a, c, d])?;
    Ok(scene)
}

/// Measures the sets, with `count` triangles each.
pub fn sets(count: u32) -> impl Iterator<Item = Result<Scene>> {
    let sets: [(&str, Plane); 4] = [
        ("planes-tilted", tilted),
        ("planes-grazing", grazing),
        ("planes-slivers", sliver),
        ("planes-deep", deep),
    ];
    sets.into_iter().map(move |(name, plane)| {
        let mut scene = Scene::new(name);
        let mut dice = Dice(ChaCha8Rng::seed_from_u64(4));
        for _ in 0..count {
            add(&mut scene, plane(&mut dice))?;
        }
        Ok(scene)
    })
}

/// The point of eye space at a position on the screen and a distance `w`.
fn point([x, y]: [f64; 2], w: f64) -> [f64; 3] {
    [(x - 160.) * w / 200., (120. - y) * w / 200., -w]
}

/// Adds a triangle to a scene, rounded to the crate's numbers.
fn add(scene: &mut Scene, corners: [Corner; 3]) -> Result<()> {
    let positions = corners.map(|corner| rounded(point(corner.at, corner.w)));
    let uv = |value| TexCoord::try_from(value).expect("u and v are from 0 to 1");
    let uvs = corners.map(|corner| {
        let [u, v] = corner.uv.map(uv);
        Vec2::new(u, v)
    });
    let mesh = Mesh::new(&positions, &[[0, 1, 2]])?.with_uvs(&uvs, None)?;
    let projection = Projection::from_focal_length(fx!(200), SIZE, fx!(0.125), fx!(8000))?;
    let view = View {
        eye: IDENTITY,
        projection: focal(200., SIZE, 0.125, 8000.),
        viewport: Viewport::new(SIZE.0, SIZE.1),
    };
    scene.add(&mesh, &projection.into(), &view)
}

struct Dice(ChaCha8Rng);

impl Dice {
    /// Returns a number with a uniform distribution between two numbers.
    fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0.random_range(low..high)
    }

    /// Returns a number between two numbers. The number's logarithm has a uniform distribution.
    fn scale(&mut self, low: f64, high: f64) -> f64 {
        self.between(low.ln(), high.ln()).exp()
    }

    /// Returns a position in the picture.
    fn place(&mut self) -> [f64; 2] {
        [self.between(0., 320.), self.between(0., 240.)]
    }

    /// Returns a triangle that covers at least an eighth of the picture.
    fn places(&mut self) -> [[f64; 2]; 3] {
        loop {
            let places = [self.place(), self.place(), self.place()];
            if area2_f64(&places).abs() > 320. * 240. / 4. {
                return places;
            }
        }
    }

    /// Returns corners with a random texture mapping, in an order that makes the triangle face the eye.
    fn corners(&mut self, at: [[f64; 2]; 3], w: [f64; 3]) -> [Corner; 3] {
        let [a, b, c] = [0, 1, 2].map(|i: usize| Corner {
            at: at[i],
            w: w[i],
            uv: [self.between(0., 1.), self.between(0., 1.)],
        });
        // The corners of a front face are counter-clockwise on the screen, so its area is negative with y down.
        if area2_f64(&at) < 0. {
            [a, b, c]
        } else {
            [a, c, b]
        }
    }
}

fn tilted(dice: &mut Dice) -> [Corner; 3] {
    let (tilt_sin, tilt_cos) = 60_f64.to_radians().sin_cos();
    loop {
        let (sin, cos) = dice.between(0., std::f64::consts::TAU).sin_cos();
        // The triangle reaches from the left edge of the picture to the right edge.
        let mut at = dice.places();
        (at[0][0], at[1][0]) = (0., 320.);
        if area2_f64(&at).abs() < 320. * 240. / 4. {
            continue;
        }
        // The ray through (x, y, −1) meets the plane where 1/w = (cos tilt − sin tilt · (x, y) · way) / distance.
        let q = at.map(|at| {
            let [x, y, _] = point(at, 1.);
            tilt_cos - tilt_sin * (cos * x + sin * y)
        });
        let (near, far) = (
            q.into_iter().fold(0., f64::max),
            q.into_iter().fold(f64::MAX, f64::min),
        );
        // Keep away from the horizon.
        if far > near / 100. {
            let distance = dice.scale(0.5, 4.);
            return dice.corners(at, q.map(|q| distance * near / q));
        }
    }
}

fn grazing(dice: &mut Dice) -> [Corner; 3] {
    let at = dice.places();
    // The increase of 1/w per pixel, starting at the far corner, where 1/w is 1.
    let slope = [dice.between(0., 1. / 32.), dice.between(0., 1. / 128.)];
    let far = [0, 1].map(|axis: usize| {
        let ends = at.map(|at| at[axis]).into_iter();
        if dice.between(0., 1.) < 0.5 {
            ends.fold(0., f64::max)
        } else {
            ends.fold(f64::MAX, f64::min)
        }
    });
    let gain = |at: [f64; 2], axis: usize| slope[axis] * (at[axis] - far[axis]).abs();
    let q = at.map(|at| 1. + gain(at, 0) + gain(at, 1));
    let distance = dice.scale(4., 40.);
    dice.corners(at, q.map(|q| distance / q))
}

fn sliver(dice: &mut Dice) -> [Corner; 3] {
    loop {
        let [a, b] = [dice.place(), dice.place()];
        let along = [b[0] - a[0], b[1] - a[1]];
        let length = along[0].hypot(along[1]);
        if length < 10. {
            continue;
        }
        let (way, width) = (dice.between(0., 1.), dice.between(0.1, 1.5));
        let c = [
            a[0] + way * along[0] - width * along[1] / length,
            a[1] + way * along[1] + width * along[0] / length,
        ];
        let nearest = dice.scale(0.5, 4.);
        let w = [(); 3].map(|()| nearest * dice.scale(1., 8.));
        return dice.corners([a, b, c], w);
    }
}

fn deep(dice: &mut Dice) -> [Corner; 3] {
    let (nearest, ratio) = (dice.scale(0.5, 4.), dice.scale(10., 1000.));
    let w = [1., ratio, dice.scale(1., ratio)].map(|w| nearest * w);
    let at = dice.places();
    dice.corners(at, w)
}
