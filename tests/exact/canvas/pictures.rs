//! Random calls of the four methods of an embedded-graphics target. Every shape, text and image becomes such calls.

use std::convert::Infallible;

use embedded_graphics::Pixel;
use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{Point, Size};
use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::pixelcolor::raw::RawU16;
use embedded_graphics::primitives::Rectangle;
use rand::Rng;

use support::random::{Random, list};

pub const WIDTH: u32 = 41;
pub const HEIGHT: u32 = 31;

/// Draws the picture that `random` describes. The picture is the same on every target of the same size, and in bands.
pub fn draw(target: &mut impl DrawTarget<Color = Rgb565, Error = Infallible>, mut random: Random) {
    let random = &mut random;
    for _ in 0..random.random_range(1..=12) {
        let area = area(random);
        let Ok(()) = match random.random_range(0..10) {
            0..3 => target.draw_iter(list(random, 0..40, |random| {
                Pixel(far_point(random), color(random))
            })),
            3..6 => {
                // The iterator yields about as many colors as the area has pixels: up to four fewer or more.
                let pixels = area.size.width * area.size.height;
                let count = (pixels + random.random_range(0..9)).saturating_sub(4);
                let first = random.random::<u16>();
                let colors = (0..count).map(|i| first.wrapping_add((77 * i) as u16));
                target.fill_contiguous(&area, colors.map(|bits| RawU16::new(bits).into()))
            }
            6..9 => target.fill_solid(&area, color(random)),
            _ => target.clear(color(random)),
        };
    }
}

fn color(random: &mut Random) -> Rgb565 {
    RawU16::new(random.random()).into()
}

/// A point inside the frame or around it.
fn point(random: &mut Random) -> Point {
    Point::new(random.random_range(-25..65), random.random_range(-20..50))
}

/// A point inside the frame, near it, or far from it.
fn far_point(random: &mut Random) -> Point {
    if random.random_bool(0.9) {
        return point(random);
    }
    let [x, y] = [(); 2].map(|()| one(random, [-1 << 30, -1, 0, 7, 2048, 65_536, 1 << 30]));
    Point::new(x, y)
}

/// An area inside the frame, across an edge, outside, around the whole frame, or empty.
fn area(random: &mut Random) -> Rectangle {
    let mut number = || {
        let most = one(random, [2, 12, 30, 80]);
        random.random_range(0..most)
    };
    let size = Size::new(number(), number());
    Rectangle::new(point(random), size)
}

fn one<T: Copy, const N: usize>(random: &mut Random, all: [T; N]) -> T {
    all[random.random_range(0..N)]
}
