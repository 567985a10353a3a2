//! Lines and points. The pixels of both are compared with exact integers, and the depths and attributes of lines with
//! the f64 model.

use crate::bands::{Point, point};
use embedded_graphics::pixelcolor::Gray8;
use fixel::canvas::Add;
use fixel::prelude::*;
use fixel::view::{Perspective, ProjectionKind};
use rand::Rng;
use support::counter::{BOTH_SIDES, Counter, at_subpixel, pixel_projection};
use support::random::{Random, cases, list, within};
use support::recorder::{Probe, Seen, record};
use support::reference::clip::{ClipVertex, DEPTH_PLANES};
use support::reference::coverage::{Bounds, picture};
use support::reference::linear::IDENTITY;
use support::reference::lines::Line;
use support::reference::{projection, view};

/// The width is more than two spans of 64 pixels, because values are recomputed at the start of each span.
const SIZE: (u32, u32) = (150, 28);

/// Whether a pixel belongs to the line between two snapped ends. The line has a pixel in each column (or row, if the
/// line is steeper than 45°) with a center that the line crosses: the pixel that contains the crossing. A center
/// exactly at the end with the smaller coordinate counts; a center exactly at the other end does not. The pixels that
/// contain the ends belong to the line, too, except if the line crosses another pixel of their column (or row), or if
/// `blends`. The result is computed in exact integers.
pub fn on_line([a, b]: [Point; 2], blends: bool, pixel: [i32; 2]) -> bool {
    let [dx, dy] = [0, 1].map(|i| i64::from(b[i]) - i64::from(a[i]));
    let major = usize::from(dy.abs() > dx.abs());
    let minor = 1 - major;
    let (a, b) = if a[major] <= b[major] { (a, b) } else { (b, a) };
    let center = pixel[major] * 256 + 128;
    if center < a[major] || center >= b[major] {
        let is_in = |end: Point| end.map(|at| at.div_euclid(256)) == pixel;
        // This center is before the smaller end or not before the greater end. The pixel can belong to the line only if
        // it contains this end.
        return !blends && (center < a[major] && is_in(a) || center >= b[major] && is_in(b));
    }
    // The crossing is a + (center - a) · slope, a rational number, rounded down.
    let length = i64::from(b[major] - a[major]);
    let rise = i64::from(b[minor] - a[minor]);
    let over = i64::from(a[minor]) * length + i64::from(center - a[major]) * rise;
    over.div_euclid(length * 256) == i64::from(pixel[minor])
}

/// Draws mesh edges as lines through the pixel projection. Returns how often each pixel is drawn.
fn drawn(points: &[Point], edges: &[[u16; 2]], blends: bool) -> Vec<u32> {
    let projection = pixel_projection(SIZE);
    let mut counter = Counter::new(SIZE);
    let positions: Vec<Vec3> = points.iter().copied().map(at_subpixel).collect();
    let mesh = Mesh::new(&positions, &[])
        .unwrap()
        .with_edges(edges)
        .unwrap();
    let options = DrawOptions::new();
    let drawn = if blends {
        counter.draw_edges(&options.with_blending(Add), &mesh, &projection)
    } else {
        counter.draw_edges(&options, &mesh, &projection)
    };
    assert_eq!(drawn.clipped, 0);
    counter.take()
}

fn modeled(points: &[Point], edges: &[[u16; 2]], blends: bool) -> Vec<u32> {
    let ends = |edge: &[u16; 2]| edge.map(|index| points[usize::from(index)]);
    Bounds::new(SIZE.0, SIZE.1)
        .pixels()
        .map(|pixel| {
            edges
                .iter()
                .map(|edge| u32::from(on_line(ends(edge), blends, pixel)))
                .sum()
        })
        .collect()
}

/// A line draws exactly the model's pixels, once each. A line in the other direction draws the same pixels.
#[test]
fn lines_are_the_models() {
    cases(512, |random| {
        let ends = [point(random, SIZE), point(random, SIZE)];
        let blends = random.random();
        let model = modeled(&ends, &[[0, 1]], blends);
        for edge in [[0, 1], [1, 0]] {
            assert_eq!(
                picture(&drawn(&ends, &[edge], blends), SIZE.0),
                picture(&model, SIZE.0),
                "{ends:?}"
            );
        }
    });
}

/// The lines are joined end to end, all within 45° of the same direction along an axis. No pixel is blended twice, and
/// there is no gap: each column (or row) with its center between the first end and the last end has one pixel.
#[test]
fn polylines_blend_no_pixel_twice() {
    cases(512, |random| {
        // All points are in the guard band, because 500,000 plus 11 steps of 899 is less than 2048 pixels.
        let (mut last, steep, back) = (point(random, SIZE), random.random(), random.random());
        let mut points = vec![last];
        for _ in 0..random.random_range(1..12) {
            let along = random.random_range(0..900);
            let across: i32 = (along * random.random_range(-256..=256)) >> 8;
            // A line at exactly 45° counts as flat.
            let across = if across.abs() == along { 0 } else { across };
            let step = if steep {
                [across, along]
            } else {
                [along, across]
            };
            last = [0, 1].map(|i| last[i] + if back { -step[i] } else { step[i] });
            points.push(last);
        }
        let edges: Vec<[u16; 2]> = (1..u16::try_from(points.len()).unwrap())
            .map(|i| [i - 1, i])
            .collect();
        let counts = drawn(&points, &edges, true);
        assert!(counts.iter().all(|&count| count <= 1), "{points:?}");
        // No pixel is missing: the lines together have the model's pixels of all edges.
        assert_eq!(
            picture(&counts, SIZE.0),
            picture(&modeled(&points, &edges, true), SIZE.0),
            "{points:?}"
        );
    });
}

/// The sides of a rectangle have the pixels of all four corners, wherever the corners lie in these pixels.
#[test]
fn rectangles_have_their_corners() {
    cases(256, |random| {
        let [[left, top], [right, bottom]] = [(); 2].map(|()| {
            [SIZE.0, SIZE.1].map(|length| random.random_range(0..256 * length.cast_signed()))
        });
        let corners = [[left, top], [right, top], [right, bottom], [left, bottom]];
        let counts = drawn(&corners, &[[0, 1], [1, 2], [3, 2], [0, 3]], false);
        for corner in corners {
            let [x, y] = corner.map(|at| usize::try_from(at >> 8).unwrap());
            assert!(
                counts[y * SIZE.0 as usize + x] > 0,
                "{corner:?} of {corners:?}"
            );
        }
    });
}

/// A point draws the pixel that contains it. A pixel contains its left and top edges.
#[test]
fn points_are_the_pixels_they_lie_in() {
    cases(512, |random| {
        let points = list(random, 0..20, |random| point(random, SIZE));
        let projection = pixel_projection(SIZE);
        let mut counter = Counter::new(SIZE);
        let positions: Vec<Vec3> = points.iter().copied().map(at_subpixel).collect();
        let drawn = counter.draw_points(
            &DrawOptions::new(),
            &Mesh::new(&positions, &[]).unwrap(),
            &projection,
        );
        // A point counts as drawn if a row of the picture, or the row above or below the picture, contains the point.
        let rows = -1..=i32::try_from(SIZE.1).unwrap();
        let meeting = points
            .iter()
            .filter(|[_, y]| rows.contains(&y.div_euclid(256)));
        assert_eq!(
            (drawn.submitted as usize, drawn.drawn as usize),
            (points.len(), meeting.count())
        );
        let mut expected = vec![0; (SIZE.0 * SIZE.1) as usize];
        for [x, y] in points
            .iter()
            .map(|point| point.map(|at| at.div_euclid(256)))
        {
            if let (Ok(x), Ok(y)) = (u32::try_from(x), u32::try_from(y))
                && x < SIZE.0
                && y < SIZE.1
            {
                expected[(y * SIZE.0 + x) as usize] += 1;
            }
        }
        assert_eq!(
            picture(&counter.take(), SIZE.0),
            picture(&expected, SIZE.0),
            "{points:?}"
        );
    });
}

/// A drawn pixel, with its attribute and depth.
type Drawn = ([i32; 2], i32, u16);

/// The pixels of a line, with the interpolated x of the position.
fn recorded<K: ProjectionKind>(
    mvp: &Mvp<K>,
    ends: [Vec3; 2],
    edge: [u16; 2],
) -> (Vec<Drawn>, Vec<u16>) {
    let pixels = (SIZE.0 * SIZE.1) as usize;
    let (mut colors, mut depths) = (vec![Gray8::new(0); pixels], vec![0; pixels]);
    let edges = [edge];
    let mesh = Mesh::new(&ends, &[]).unwrap().with_edges(&edges).unwrap();
    let canvas = Canvas::new(&mut colors, SIZE.0, SIZE.1).unwrap();
    let mut canvas = canvas.with_depth(&mut depths).unwrap();
    let probe = Probe {
        values: &|corner| [corner.position().x.to_bits()],
        color: Some(Gray8::new(1)),
    };
    let record = record(probe, |recorder| {
        canvas.draw_with(&BOTH_SIDES, mesh.edges(LineStyle::HAIRLINE), mvp, recorder);
    });
    let drawn = |seen: Seen<1>| (seen.pixel, seen.values[0], seen.depth);
    (record.seen.into_iter().map(drawn).collect(), depths)
}

const NEAR: f64 = 0.25;
const FAR: f64 = 32.;
const FOCAL: f64 = 30.;

fn projection() -> Projection<Perspective> {
    Projection::from_focal_length(fx!(30), SIZE, fx!(0.25), fx!(32)).unwrap()
}

/// One unit of space, in units of 2⁻¹⁶.
const UNIT: i32 = 1 << 16;

/// A position around the eye: in front of it, behind it, or beyond the far plane.
fn around(random: &mut Random) -> Vec3 {
    let z = if random.random_ratio(4, 6) {
        -40 * UNIT..10 * UNIT
    } else {
        -2 * UNIT..-UNIT / 4
    };
    let ranges = [-12 * UNIT..12 * UNIT, -8 * UNIT..8 * UNIT, z];
    Vec3::from_bits(within(random, ranges))
}

/// Random ends. Sometimes the two ends make a line of more than 64 pixels in one row: y is below 1/32, so at a distance
/// above 3 the line is less than half a pixel from the middle.
fn ends(random: &mut Random) -> [Vec3; 2] {
    if random.random_ratio(3, 4) {
        [around(random), around(random)]
    } else {
        [-12 * UNIT..-9 * UNIT, 9 * UNIT..12 * UNIT]
            .map(|x| [x, UNIT / 64..UNIT / 32, -8 * UNIT..-3 * UNIT])
            .map(|ranges| Vec3::from_bits(within(random, ranges)))
    }
}

/// The model's line; `None` if no part of it is in view.
fn line_of(ends: [Vec3; 2]) -> Option<Line<1>> {
    let view = view::View {
        eye: IDENTITY,
        projection: projection::focal(FOCAL, SIZE, NEAR, FAR),
        viewport: view::Viewport::new(SIZE.0, SIZE.1),
    };
    let float = |p: Vec3| p.to_bits().map(|bits| f64::from(bits) / 65536.);
    Line::clipped(
        ends.map(|end| ClipVertex {
            position: view.clip(float(end)),
            attributes: [float(end)[0]],
            source: None,
        }),
        &view,
        &DEPTH_PLANES,
    )
}

/// Lines in perspective, clipped or not: every pixel is on the model's line and has the model's depth and attribute
/// there. No pixel is missing.
#[test]
fn lines_in_perspective_are_the_models() {
    cases(1024, |random| {
        loop {
            let ends = ends(random);
            let mvp = projection().into();
            let (pixels, depths) = recorded(&mvp, ends, [0, 1]);
            // A line drawn from its other end has the same pixels. The attribute of a clipped end is a blend of both
            // ends' attributes. The two attributes differ by less than 2^21 units, and the weight is in units of 2^-30.
            // The blend is rounded to the nearest unit from either side, so the two results can differ by one unit. The
            // attribute of a pixel is rounded down, so it can differ by one more unit.
            let (others, other_depths) = recorded(&mvp, ends, [1, 0]);
            let places = |pixels: &[Drawn]| {
                pixels
                    .iter()
                    .map(|&(at, _, depth)| (at, depth))
                    .collect::<Vec<_>>()
            };
            assert_eq!(
                (places(&pixels), &depths),
                (places(&others), &other_depths),
                "the other direction"
            );
            let apart = pixels
                .iter()
                .zip(&others)
                .map(|(a, b)| a.1.abs_diff(b.1))
                .max();
            assert!(
                apart.unwrap_or(0) <= 2,
                "{apart:?} units apart in the other direction"
            );

            let Some(line) = line_of(ends) else {
                assert!(pixels.is_empty(), "{ends:?}");
                break;
            };
            let extent = [0, 1].map(|i| (line.screen[1][i] - line.screen[0][i]).abs());
            // Skip lines that rounding can make steep or flat, and lines with almost no length.
            if (extent[0] - extent[1]).abs() > 0.02 && extent[0].max(extent[1]) > 0.05 {
                check_line(&line, extent, &pixels);
                break;
            }
        }
    });
}

/// Compares the pixels of a line with the model's line. `extent` is the size of the model's line along each axis.
///
/// The ends are rounded to 1/256 pixel, which moves the line by less than 1/256 pixel, along and across. So if the line
/// crosses a center within 1/256 pixel of a pixel's edge, it can draw the next pixel. The pixel's values are the
/// model's values at a point within 1/256 pixel.
fn check_line(line: &Line<1>, extent: [f64; 2], pixels: &[Drawn]) {
    const ROUNDING: f64 = 1. / 256.;
    // Beyond the guard band, clipping makes new ends. The error of the new ends does not depend on the length of the
    // line in pixels.
    let major = usize::from(extent[1] > extent[0]);
    let minor = 1 - major;
    let length = extent[major];
    let low = line.screen[0][major].min(line.screen[1][major]);
    let high = line.screen[0][major].max(line.screen[1][major]);

    for &([x, y], attribute, depth) in pixels {
        let pixel = [f64::from(x), f64::from(y)];
        let q = line.fraction_at(major, pixel[major] + 0.5);
        let value = line.at(q.clamp(0., 1.));
        // The center of a pixel is between the line's ends, or the pixel contains an end. Rounding can move a pixel
        // beyond the line's end or beside the line. The error across the line includes the error along the line times
        // the slope.
        let contains =
            |end: f64| (pixel[major] - ROUNDING..=pixel[major] + 1. + ROUNDING).contains(&end);
        assert!(
            (low - ROUNDING..=high + ROUNDING).contains(&(pixel[major] + 0.5))
                || contains(low)
                || contains(high),
            "{:?} is not from {low} to {high} along the line",
            [x, y]
        );
        let across = value.screen[minor] - pixel[minor];
        assert!(
            (-2. * ROUNDING..=1. + 2. * ROUNDING).contains(&across),
            "{:?}: {across} across the line",
            [x, y]
        );

        // 1/w is linear along the line. `room` is the error of 1/w at a position with an error of ROUNDING.
        let inverse = 1. / value.w;
        let room = (1. / line.w[0] - 1. / line.w[1]).abs() / length * ROUNDING * 1.01 + 1e-6;
        let (least, most) = (
            65535. * NEAR * (inverse - room) - 1.01,
            65535. * NEAR * (inverse + room) + 0.01,
        );
        assert!(
            (least..=most).contains(&f64::from(depth)),
            "{:?}: depth {depth} not in {least}..{most}",
            [x, y]
        );

        // Attribute/w is linear, too, and the quotient of attribute/w and 1/w has the sum of both errors. Attributes
        // are below 2^20 units and scaled by 2^-21, and q is at least 2^30 · near/far. As bounds.rs derives, the errors
        // of the numerator and of q count as at most 56½ units of the numerator. In this small picture, they stay
        // within 51 units. Clipping adds two units, and rounding adds two units.
        let over_w = |i: usize| line.attributes[i][0] / line.w[i];
        let room_over = (over_w(0) - over_w(1)).abs() / length * ROUNDING * 1.01;
        let format = (f64::from(1 << 21) * 51. / (f64::from(1 << 30) * NEAR / FAR) + 4.) / 65536.;
        let room = (room_over + value.attributes[0].abs() * room) / (inverse - room) + format;
        let off = (f64::from(attribute) / 65536. - value.attributes[0]).abs();
        assert!(
            off <= room,
            "{:?}: x {attribute} instead of {}: an error of {off}, over {room}",
            [x, y],
            value.attributes[0]
        );
    }

    // The line draws a pixel wherever it crosses a center inside the picture.
    let (count, others) = if major == 0 {
        (SIZE.0, SIZE.1)
    } else {
        (SIZE.1, SIZE.0)
    };
    for step in 0..i32::try_from(count).unwrap() {
        let center = f64::from(step) + 0.5;
        let across = line
            .at(line.fraction_at(major, center).clamp(0., 1.))
            .screen[minor];
        let sure = (low + ROUNDING..=high - ROUNDING).contains(&center)
            && (2. * ROUNDING..=f64::from(others) - 2. * ROUNDING).contains(&across);
        let pixels = pixels
            .iter()
            .filter(|(pixel, ..)| pixel[major] == step)
            .count();
        assert!(pixels <= 1, "{pixels} pixels at {step} along axis {major}");
        assert!(
            !sure || pixels == 1,
            "no pixel at {step} along axis {major}"
        );
    }
}
