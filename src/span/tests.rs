//! Compares each kernel's spans with exact quotients, and tests which of two pixels shows.

use core::marker::PhantomData;
use std::cell::RefCell;
use std::string::String;
use std::vec::Vec;

use embedded_graphics::geometry::Point;
use embedded_graphics::pixelcolor::{Gray8, GrayColor};

use super::pixels::{Pixels, Span};
use super::scale::Scale;
use super::shading::Plain;
use crate::canvas::{Canvas, Cells, LinearDepth, Native, NoDepth, NoTest, Replace, TestAndWrite};
use crate::mesh::Primitive;
use crate::shade::{Flat, Fragment, Shader};

/// A shader that records the column and the number of each pixel.
#[derive(Clone, Copy)]
struct Note<'a>(&'a RefCell<Vec<(i32, i32)>>);

impl Shader for Note<'_> {
    type Color = Gray8;
    type Varyings = [i32; 1];

    fn varyings(&self, _: &Primitive<'_>) -> [[i32; 1]; 3] {
        [[0]; 3]
    }

    fn shade(&self, at: &Fragment, [number]: [i32; 1]) -> Option<Gray8> {
        assert_eq!(at.point.y, 0);
        self.0.borrow_mut().push((at.point.x, number));
        Some(Gray8::WHITE)
    }
}

type RowCells<'a> = Cells<'a, Gray8, Native, NoDepth>;

/// The first column of spans.
const FIRST: u32 = 3;

/// The numbers that the shader receives in a span of `count` pixels. Checks that no other pixel is drawn.
fn numbers(
    count: u32,
    draw: impl FnOnce(RowCells<'_>, Pixels<Plain<Note<'_>, Replace, NoTest>, Native, NoDepth>),
) -> Vec<i32> {
    let (mut colors, seen) = ([Gray8::BLACK; 70], RefCell::new(Vec::new()));
    let mut canvas = Canvas::new(&mut colors, 70, 1).unwrap();
    let columns = FIRST..FIRST + count;
    let pixels = Pixels {
        shading: Plain {
            shader: Note(&seen),
            blending: Replace,
            test: NoTest,
        },
        face: (),
        bias: (),
        point: Point::new(FIRST.cast_signed() - 1, 0),
        depth: 0,
        code: 0,
        canvas: PhantomData,
    };
    draw(canvas.memory().cells(0, columns.clone()).unwrap(), pixels);
    for (column, color) in (0..).zip(colors) {
        assert_eq!(color == Gray8::WHITE, columns.contains(&column), "{column}");
    }
    let (places, numbers): (Vec<i32>, Vec<i32>) = seen.into_inner().into_iter().unzip();
    assert!(places.into_iter().eq(columns.map(u32::cast_signed)));
    numbers
}

/// Spans of every length, with the relative change of 1/w per pixel. Along a span, 1/w and the varying over w rise,
/// fall or stay.
fn spans() -> impl Iterator<Item = (u32, Span<[(); 1]>, f64)> {
    // Each start is a 1/w, from 2^29 to 2^31, and a varying over w, at most half of 1/w.
    let starts = [(1 << 30, 1 << 28), ((1 << 31) - (1 << 27), -(1 << 28))];
    let steps = [0, 1, -250, 40_000, -(1 << 20), 1 << 20];
    let gains = [0, 7, -100_000, 1 << 21];
    let all = starts
        .into_iter()
        .flat_map(move |start| steps.into_iter().map(move |dq| (start, dq)));
    let all = all.flat_map(move |all| gains.into_iter().map(move |dp| (all, dp)));
    all.flat_map(|(((q, p), dq), dp)| {
        (1..=64).map(move |count| {
            let span = Span {
                q,
                p: [p],
                dq,
                dp: [dp],
                down: 15,
                count: count as usize,
            };
            (count, span, f64::from(dq.abs()) / f64::from(1 << 30))
        })
    })
}

/// The exact varying at each pixel of a span, in units of 2^-28.
fn exact(span: &Span<[(); 1]>) -> impl Fn(u32) -> f64 + use<> {
    let [q, p, dq, dp] = [
        f64::from(span.q),
        span.p[0].into(),
        span.dq.into(),
        span.dp[0].into(),
    ];
    move |pixel| {
        let pixel = f64::from(pixel);
        (p + dp * pixel) / (q + dq * pixel) * 2_f64.powi(28)
    }
}

/// Checks that the exact value minus the value found is in `range` at each pixel.
fn lacks(
    found: &[i32],
    exact: impl Fn(u32) -> f64,
    range: impl core::ops::RangeBounds<f64> + core::fmt::Debug,
) {
    for (pixel, &found) in (0..).zip(found) {
        let lacks = exact(pixel) - f64::from(found);
        let count = found;
        assert!(
            range.contains(&lacks),
            "pixel {pixel}: {count} lacks {lacks}, not {range:?}"
        );
    }
}

#[test]
fn straight_spans_are_sums() {
    for (count, span, _) in spans() {
        let [p, dp] = [span.p[0], span.dp[0]];
        let restore = |_, _, p: &[i32; 1]| p.map(|p| p >> Scale::AFFINE_UP);
        let found = numbers(count, |cells, pixels| {
            pixels.straight::<true>(span, cells, restore);
        });
        let expected = (0..count.cast_signed()).map(|pixel| (p + dp * pixel) >> 2);
        assert!(found.into_iter().eq(expected));
    }
}

#[test]
fn solid_spans_have_one_number() {
    for count in 1..=64 {
        let found = numbers(count, |cells, mut pixels| pixels.solid(cells, [5]));
        assert!(found.into_iter().eq((0..count).map(|_| 5)));
    }
}

/// Varyings are rounded down. The reciprocal's last bits add an error of 2^-30 of a varying below 2^27.
#[test]
fn divided_spans_are_exact_quotients() {
    for (count, span, _) in spans() {
        let exact = exact(&span);
        let found = numbers(count, |cells, pixels| {
            pixels.divide(&span, cells, [Scale::AFFINE]);
        });
        lacks(&found, exact, -0.26..1.26);
    }
}

/// Tests `Plan::PerPixel`, which computes the interpolants of each pixel from the planes, not from the span. The error
/// is the same.
#[test]
fn spans_divided_per_pixel_are_exact_quotients() {
    for (count, span, _) in spans() {
        let ([q, dq], [p, dp]) = ([span.q.cast_signed(), span.dq], [span.p[0], span.dp[0]]);
        let exact = exact(&span);
        let at = |pixel: Point| {
            let pixel = pixel.x - FIRST.cast_signed();
            ((q + dq * pixel).cast_unsigned(), [p + dp * pixel])
        };
        let steps = Span {
            p: [0],
            dp: [0],
            ..span
        };
        let found = numbers(count, |cells, pixels| {
            pixels.divide_per_pixel(&steps, cells, [Scale::AFFINE], at);
        });
        lacks(&found, exact, -0.26..1.26);
    }
}

/// A varying is below 2^27. A guess has a relative error of up to 2.1 δ², so a reciprocal has a relative error of less
/// than 12 δ⁴, plus 2^-26 from rounding. The varying is rounded down.
#[test]
fn newton_spans_are_quotients_to_a_few_units() {
    for (count, span, delta) in spans() {
        let exact = exact(&span);
        let off = 2_f64.powi(27) * (2_f64.powi(-26) + 12. * delta.powi(4));
        let found = numbers(count, |cells, pixels| pixels.newton(span.clone(), cells));
        lacks(&found, exact, -off..=off + 1.);
    }
}

/// A line of L pixels has an error of |f′| δ L² / 4, and its ends have an error of 2^-13 of the greatest possible
/// varying.
#[test]
fn pieces_are_quotients_to_their_tolerance() {
    for length in 1..=6 {
        for (count, span, delta) in spans() {
            let pixels = f64::from(1 << length);
            if delta * pixels > 1. / 16. {
                continue;
            }
            let exact = exact(&span);
            let steepest = (0..count)
                .map(|pixel| (exact(pixel + 1) - exact(pixel)).abs())
                .fold(0., f64::max);
            let off = steepest * delta * pixels * pixels / 4. * 1.2 + 2_f64.powi(27 - 13);
            let found = numbers(count, |cells, pixels| {
                pixels.pieces(&span, cells, [Scale::AFFINE], length);
            });
            lacks(&found, exact, -off..=off);
        }
    }
}

/// At equal depths, the pixel drawn last shows; otherwise the nearest one.
#[test]
fn the_later_of_two_pixels_at_one_depth_shows() {
    let (mut colors, mut depths) = ([Gray8::BLACK; 8], [0; 8]);
    let canvas = Canvas::new(&mut colors, 8, 1).unwrap();
    let mut canvas = canvas.with_depth(&mut depths).unwrap();
    let mut draw = |ink: u8, columns: core::ops::Range<u32>, q: u32| {
        let pixels: Pixels<_, Native, LinearDepth> = Pixels {
            shading: Plain {
                shader: Flat::new(Gray8::new(ink)),
                blending: Replace,
                test: TestAndWrite,
            },
            face: (),
            bias: (),
            point: Point::new(columns.start.cast_signed() - 1, 0),
            depth: 0,
            code: 0,
            canvas: PhantomData,
        };
        let span: Span<[(); 0]> = Span {
            q,
            p: [],
            dq: 0,
            dp: [],
            down: 15,
            count: columns.len(),
        };
        pixels.straight::<true>(
            span,
            canvas.memory().cells(0, columns).unwrap(),
            |_, _, none| *none,
        );
    };
    let depth = 1 << 30;
    draw(b'a', 0..6, depth);
    // b is at the same depth as a. c is nearer by less than one step, so it is stored with the same depth.
    draw(b'b', 1..3, depth);
    draw(b'c', 2..4, depth + (1 << 15) - 1);
    // d is stored a step behind, e a step nearer.
    draw(b'd', 4..8, depth - 1);
    draw(b'e', 5..6, depth + (1 << 15));
    let text: String = colors
        .iter()
        .map(|color| char::from(color.luma()))
        .collect();
    assert_eq!(text, "abccaedd");
}
