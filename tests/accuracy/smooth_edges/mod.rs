//! Smoothed edges: compared with the exact share of each pixel beyond an edge, and with means of many samples a pixel.

use embedded_graphics::pixelcolor::{Rgb888, RgbColor};
use fixel::Primitive;
use fixel::prelude::*;
use rand::Rng;
use support::random::Random;

mod bands;
mod extremes;
mod hidden;
mod samples;
mod shares;
mod storages;

static BOX: Mesh = shape!(cuboid(vec3!(0.9, 0.6, 0.7)));
static RING: Mesh = shape!(torus(fx!(0.3), 48, 20));
static BALL: Mesh = shape!(sphere(12, 9));
static CAN: Mesh = shape!(cylinder(9));
static GROUND: Mesh = shape!(plane(3, 2));
static ISLAND: Mesh = include_mesh!("../../../examples/assets/lighthouse.obj");

static CREASES_OF_BOX: Outline = outline!(BOX, deg!(30));
static OF_RING: Outline = outline!(RING, deg!(180));
static OF_BOX: Outline = outline!(BOX, deg!(180));
static HOUSE: Mesh = include_mesh!("../../models/house.obj");
static CREASES_OF_HOUSE: Outline = outline!(HOUSE, deg!(20));
static OF_BALL: Outline = outline!(BALL, deg!(180));
static OF_GROUND: Outline = outline!(GROUND, deg!(180));
static CREASES_OF_CAN: Outline = outline!(CAN, deg!(50));
static CREASES_OF_ISLAND: Outline = outline!(ISLAND, deg!(20));

type Frame<'f, C, D = LinearDepth> = Canvas<'f, C, Native, D>;

/// A color that differs from pixel to pixel and from body to body, so that every mixture shows.
#[derive(Clone, Copy)]
struct Noise(usize);

impl Shader for Noise {
    type Color = Rgb888;
    type Varyings = ();

    fn varyings(&self, _: &Primitive<'_>) -> [(); 3] {
        [(); 3]
    }

    fn shade(&self, sample: &Fragment, (): ()) -> Option<Rgb888> {
        let [x, y] = [sample.point.x, sample.point.y].map(i32::cast_unsigned);
        let mix = [x, y, self.0 as u32]
            .iter()
            .fold(0x811c_9dc5_u32, |mix, value| {
                (mix ^ value).wrapping_mul(0x0100_0193).rotate_left(13)
            });
        let [red, green, blue, _] = mix.wrapping_mul(0x9e37_79b1).to_be_bytes();
        Some(Rgb888::new(red, green, blue))
    }
}

fn channels(color: Rgb888) -> [f64; 3] {
    [color.r(), color.g(), color.b()].map(f64::from)
}

fn angle(random: &mut Random) -> Angle {
    Angle::from_bits(random.random())
}

/// A viewport that reaches beyond the frame on some sides, or the whole frame.
fn viewport(random: &mut Random) -> DrawOptions {
    let options = DrawOptions::new();
    if random.random() {
        return options;
    }
    let [left, top] = [(); 2].map(|()| random.random_range(-9..20));
    let [width, height] = [(); 2].map(|()| random.random_range(1..60));
    options.with_viewport(Viewport::new(left, top, width, height).unwrap())
}

/// Whether smoothing one pixel once gives this color: a mixture of the pixel's own color with the color of one neighbor,
/// by a share of up to 128/256, rounded to the nearest step.
fn is_mixed_once(before: &[Rgb888], width: usize, at: usize, after: Rgb888) -> bool {
    let (x, own) = (at % width, before[at]);
    let around = [
        (x > 0).then(|| at - 1),
        (x + 1 < width).then_some(at + 1),
        at.checked_sub(width),
        Some(at + width),
    ];
    let [own, after] = [own, after].map(channels);
    around.into_iter().flatten().any(|neighbor| {
        let Some(&other) = before.get(neighbor) else {
            return false;
        };
        let other = channels(other);
        (0..=128).any(|share| {
            let share = f64::from(share) / 256.;
            (0..3).all(|i| (own[i] + share * (other[i] - own[i]) - after[i]).abs() <= 0.51)
        })
    })
}
