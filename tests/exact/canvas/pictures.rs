//! Random pictures of shapes, text and images, drawn through embedded-graphics.

use std::convert::Infallible;

use embedded_graphics::Pixel;
use embedded_graphics::draw_target::{DrawTarget, DrawTargetExt};
use embedded_graphics::geometry::{Angle, Dimensions, Point, Size};
use embedded_graphics::image::{Image, ImageDrawableExt, ImageRaw};
use embedded_graphics::mono_font::ascii::{FONT_4X6, FONT_6X10, FONT_9X15_BOLD, FONT_10X20};
use embedded_graphics::mono_font::{MonoFont, MonoTextStyleBuilder};
use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::pixelcolor::raw::RawU16;
use embedded_graphics::prelude::{Drawable, Primitive};
use embedded_graphics::primitives::{
    Arc, Circle, CornerRadii, Ellipse, Line, Polyline, PrimitiveStyle, PrimitiveStyleBuilder,
    Rectangle, RoundedRectangle, Sector, StrokeAlignment, Triangle,
};
use embedded_graphics::text::{Alignment, Baseline, Text, TextStyleBuilder};
use rand::Rng;

use support::random::{Random, list};

pub const WIDTH: u32 = 41;
pub const HEIGHT: u32 = 31;

/// A target as a trait object, so that shapes are compiled once and not for every target and adapter.
trait Sink {
    fn area(&self) -> Rectangle;
    fn pixels(&mut self, pixels: &mut dyn Iterator<Item = Pixel<Rgb565>>);
    fn contiguous(&mut self, area: &Rectangle, colors: &mut dyn Iterator<Item = Rgb565>);
    fn solid(&mut self, area: &Rectangle, color: Rgb565);
    fn empty(&mut self, color: Rgb565);
}

impl<T: DrawTarget<Color = Rgb565, Error = Infallible>> Sink for T {
    fn area(&self) -> Rectangle {
        self.bounding_box()
    }

    fn pixels(&mut self, pixels: &mut dyn Iterator<Item = Pixel<Rgb565>>) {
        let Ok(()) = self.draw_iter(pixels);
    }

    fn contiguous(&mut self, area: &Rectangle, colors: &mut dyn Iterator<Item = Rgb565>) {
        let Ok(()) = self.fill_contiguous(area, colors);
    }

    fn solid(&mut self, area: &Rectangle, color: Rgb565) {
        let Ok(()) = self.fill_solid(area, color);
    }

    fn empty(&mut self, color: Rgb565) {
        let Ok(()) = self.clear(color);
    }
}

struct Target<'a>(&'a mut dyn Sink);

impl Dimensions for Target<'_> {
    fn bounding_box(&self) -> Rectangle {
        self.0.area()
    }
}

impl DrawTarget for Target<'_> {
    type Color = Rgb565;
    type Error = Infallible;

    fn draw_iter<I>(&mut self, pixels: I) -> Result<(), Infallible>
    where
        I: IntoIterator<Item = Pixel<Rgb565>>,
    {
        self.0.pixels(&mut pixels.into_iter());
        Ok(())
    }

    fn fill_contiguous<I>(&mut self, area: &Rectangle, colors: I) -> Result<(), Infallible>
    where
        I: IntoIterator<Item = Rgb565>,
    {
        self.0.contiguous(area, &mut colors.into_iter());
        Ok(())
    }

    fn fill_solid(&mut self, area: &Rectangle, color: Rgb565) -> Result<(), Infallible> {
        self.0.solid(area, color);
        Ok(())
    }

    fn clear(&mut self, color: Rgb565) -> Result<(), Infallible> {
        self.0.empty(color);
        Ok(())
    }
}

/// Draws the picture that `random` describes. The picture is the same on every target of the same size.
///
/// Without `crops`, the picture is also the same in a band. The adapter `cropped` counts coordinates from the upper
/// left corner of the visible part of its area, so a crop of a band differs from a band of the crop.
pub fn draw(
    target: &mut impl DrawTarget<Color = Rgb565, Error = Infallible>,
    random: &mut Random,
    crops: bool,
) {
    let mut target = Target(target);
    for _ in 0..random.random_range(1..=8) {
        let area = area(random);
        match random.random_range(0..if crops { 8 } else { 6 }) {
            0..4 => element(&mut target, random),
            4 => element(&mut Target(&mut target.clipped(&area)), random),
            5 => element(&mut Target(&mut target.translated(area.top_left)), random),
            6 => element(&mut Target(&mut target.cropped(&area)), random),
            _ => {
                let offset = point(random);
                let mut cropped = target.cropped(&area);
                let mut translated = cropped.translated(offset);
                element(
                    &mut Target(&mut translated.clipped(&self::area(random))),
                    random,
                );
            }
        }
    }
}

/// Draws a shape, text or an image, or calls one of the target's methods.
fn element(target: &mut Target<'_>, random: &mut Random) {
    let style = style(random);
    let Rectangle { top_left, size } = area(random);
    let [a, b, c] = [(); 3].map(|()| point(random));
    let diameter = size.width;
    let [start, sweep] = [(); 2].map(|()| Angle::from_degrees(random.random_range(-400. ..400.)));
    let shape = Rectangle::new(top_left, size);
    let done = match random.random_range(0..18) {
        0 => Line::new(a, b).into_styled(style).draw(target),
        1 => shape.into_styled(style).draw(target),
        2 => {
            let [first, second] = [(); 2].map(|()| Size::new(number(random), number(random)));
            let radii = CornerRadii {
                top_left: first,
                top_right: second,
                bottom_right: Size::new_equal(3),
                bottom_left: Size::zero(),
            };
            RoundedRectangle::new(shape, radii)
                .into_styled(style)
                .draw(target)
        }
        3 => Circle::new(top_left, diameter)
            .into_styled(style)
            .draw(target),
        4 => Ellipse::new(top_left, size).into_styled(style).draw(target),
        5 => Arc::new(top_left, diameter, start, sweep)
            .into_styled(style)
            .draw(target),
        6 => Sector::new(top_left, diameter, start, sweep)
            .into_styled(style)
            .draw(target),
        7 | 8 => Triangle::new(a, b, c).into_styled(style).draw(target),
        9 => {
            let points = [a, b, c, top_left];
            Polyline::new(&points[..random.random_range(2..=4)])
                .into_styled(style)
                .draw(target)
        }
        10 | 11 => text(target, random),
        12 | 13 => image(target, random),
        14 => target.draw_iter(list(random, 0..40, |random| {
            Pixel(far_point(random), color(random))
        })),
        15 => {
            // The iterator yields about as many colors as the area has pixels: up to four fewer or more.
            let count = (size.width * size.height + random.random_range(0..9)).saturating_sub(4);
            let first = random.random::<u16>();
            let colors =
                (0..count).map(|i| RawU16::new(first.wrapping_add((77 * i) as u16)).into());
            target.fill_contiguous(&shape, colors)
        }
        16 => target.fill_solid(&shape, color(random)),
        _ => target.clear(color(random)),
    };
    let Ok(()) = done;
}

fn text(target: &mut Target<'_>, random: &mut Random) -> Result<(), Infallible> {
    const FONTS: [&MonoFont<'_>; 4] = [&FONT_4X6, &FONT_6X10, &FONT_9X15_BOLD, &FONT_10X20];
    const LINES: [&str; 5] = ["fps", "60\nHz", "É?", "a b", "|"];
    let mut style = MonoTextStyleBuilder::new().font(one(random, FONTS));
    if random.random() {
        style = style.text_color(color(random));
    }
    if random.random() {
        style = style.background_color(color(random));
    }
    if random.random() {
        style = style.underline();
    }
    if random.random() {
        style = style.strikethrough_with_color(color(random));
    }
    let place = TextStyleBuilder::new()
        .alignment(one(
            random,
            [Alignment::Left, Alignment::Center, Alignment::Right],
        ))
        .baseline(one(
            random,
            [Baseline::Top, Baseline::Middle, Baseline::Alphabetic],
        ))
        .build();
    let text = one(random, LINES);
    Text::with_text_style(text, point(random), style.build(), place)
        .draw(target)
        .map(|_| ())
}

fn image(target: &mut Target<'_>, random: &mut Random) -> Result<(), Infallible> {
    let Size { width, height } = Size::new(random.random_range(1..20), random.random_range(1..20));
    let bytes: Vec<u8> = (0..2 * width * height).map(|_| random.random()).collect();
    let raw = ImageRaw::<Rgb565>::new(&bytes, width);
    if random.random() {
        return Image::new(&raw, point(random)).draw(target);
    }
    let part = raw.sub_image(&Rectangle::new(Point::new(2, 1), size(random)));
    Image::new(&part, point(random)).draw(target)
}

fn one<T: Copy, const N: usize>(random: &mut Random, all: [T; N]) -> T {
    all[random.random_range(0..N)]
}

fn color(random: &mut Random) -> Rgb565 {
    RawU16::new(random.random()).into()
}

/// A point inside the frame or around it.
fn point(random: &mut Random) -> Point {
    Point::new(random.random_range(-25..65), random.random_range(-20..50))
}

/// A point inside the frame, near it, or far from it. Far points are at most 2^30 from 0, so that adding the offsets of
/// embedded-graphics' adapters does not overflow.
fn far_point(random: &mut Random) -> Point {
    if random.random_bool(0.9) {
        return point(random);
    }
    let [x, y] = [(); 2].map(|()| one(random, [-1 << 30, -1, 0, 7, 2048, 65_536, 1 << 30]));
    Point::new(x, y)
}

fn number(random: &mut Random) -> u32 {
    let most = one(random, [2, 12, 30, 80]);
    random.random_range(0..most)
}

fn size(random: &mut Random) -> Size {
    Size::new(number(random), number(random))
}

/// An area inside the frame, across an edge, outside, around the whole frame, or empty.
fn area(random: &mut Random) -> Rectangle {
    Rectangle::new(point(random), size(random))
}

fn style(random: &mut Random) -> PrimitiveStyle<Rgb565> {
    let mut style = PrimitiveStyleBuilder::new();
    if random.random() {
        style = style.fill_color(color(random));
    }
    if random.random() {
        style = style
            .stroke_color(color(random))
            .stroke_width(random.random_range(0..6))
            .stroke_alignment(one(
                random,
                [
                    StrokeAlignment::Inside,
                    StrokeAlignment::Center,
                    StrokeAlignment::Outside,
                ],
            ));
    }
    style.build()
}
