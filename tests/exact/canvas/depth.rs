//! The depth buffer of a canvas: which calls clear it or leave it unchanged, and the resolution of its formats.

use embedded_graphics::Drawable;
use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{Dimensions, Point};
use embedded_graphics::mock_display::MockDisplay;
use embedded_graphics::mono_font::MonoTextStyle;
use embedded_graphics::mono_font::ascii::FONT_6X10;
use embedded_graphics::pixelcolor::{BinaryColor, Gray8, GrayColor, PixelColor};
use embedded_graphics::text::Text;
use fixel::Window;
use fixel::canvas::{
    Add, Biased, DepthBuffer, FloatDepth, NoTest, TestBehind, TestNearer, TestOnly, WideFloatDepth,
    WriteOnly,
};
use fixel::prelude::*;
use rand::Rng as _;
use support::moves::rounded;
use support::random::{Random, cases, sampled};

/// Draws a triangle that covers the pixels below the diagonal of an 8x8 canvas.
fn triangle<C: PixelColor, D: DepthBuffer>(
    canvas: &mut Canvas<'_, C, Native, D>,
    color: C,
    distance: i16,
) {
    let projection = Projection::orthographic(
        Window {
            left: fx!(0),
            right: fx!(8),
            bottom: fx!(-8),
            top: fx!(0),
        },
        fx!(0),
        fx!(10),
    )
    .unwrap();
    let positions = [(0, 0), (0, -8), (8, -8)].map(|(x, y)| Vec3::from_ints(x, y, -distance));
    let mesh = Mesh::new(&positions, &[[0, 1, 2]]).unwrap();
    canvas.draw(&mesh, &projection, &Flat::new(color));
}

/// Text covers the picture and does not change the depths.
#[test]
fn text_covers_the_picture_and_keeps_depths() {
    let mut pixels = [BinaryColor::Off; 64];
    let mut depths = [0; 64];
    let mut canvas = Canvas::new(&mut pixels, 8, 8)
        .unwrap()
        .with_depth(&mut depths)
        .unwrap();
    triangle(&mut canvas, BinaryColor::On, 5);
    let style = MonoTextStyle::new(&FONT_6X10, BinaryColor::On);
    Text::new("!", Point::new(3, 6), style)
        .draw(&mut canvas)
        .unwrap();
    let mut display = MockDisplay::new();
    canvas.show(&mut display).unwrap();
    display.assert_pattern(&[
        ".....#..", "#....#..", "##...#..", "###..#..", "####.#..", "#####...", "######..",
        "#######.",
    ]);
    let drawn: Vec<bool> = depths.iter().map(|&depth| depth > 0).collect();
    let covered: Vec<bool> = (0..64).map(|i| i % 8 < i / 8).collect();
    assert_eq!(drawn, covered);
}

/// `depth_at` returns `None` above, below and beside a band, and on a canvas without a depth buffer.
#[test]
fn a_pixels_depth_is_read_in_the_frames_coordinates() {
    let mut pixels = [Gray8::BLACK; 12];
    let mut depths: [u16; 12] = core::array::from_fn(|at| at as u16 + 7);
    let stored = depths;
    let band = Canvas::band(&mut pixels, 4, 9, 5).unwrap();
    assert_eq!(band.depth_at(Point::new(1, 6)), None);
    let band = band.with_depth(&mut depths).unwrap();
    for y in -1..10_i32 {
        for x in -1..5 {
            let is_inside = (0..4).contains(&x) && (5..8).contains(&y);
            let depth = is_inside.then(|| stored[((y - 5) * 4 + x).cast_unsigned() as usize]);
            assert_eq!(band.depth_at(Point::new(x, y)), depth, "{x}, {y}");
        }
    }
    for end in [i32::MIN, i32::MAX] {
        assert_eq!(band.depth_at(Point::new(end, end)), None);
    }
}

/// Draws a triangle in a depth format. The stored depth of a pixel must be the depth of the triangle's point at this
/// pixel.
fn drawn_depth<F: DepthBuffer>() {
    let projection = Projection::perspective(deg!(90), (1, 1), fx!(0.5), fx!(100)).unwrap();
    let (mut pixels, mut depths) = ([Gray8::BLACK; 64], [0; 64]);
    let canvas = Canvas::new(&mut pixels, 8, 8).unwrap();
    let mut canvas = canvas.with_depth_format::<F>(&mut depths).unwrap();
    let point = vec3!(0, 0, -20);
    let positions = [vec3!(-30, -30, -20), vec3!(30, -30, -20), vec3!(0, 30, -20)];
    let mesh = Mesh::new(&positions, &[[0, 1, 2]]).unwrap();
    canvas.draw(&mesh, &projection, &Flat::new(Gray8::WHITE));
    let at = canvas.viewport().project(point, &projection).unwrap();
    assert_eq!(canvas.depth_at(Point::new(4, 4)), Some(at.depth::<F>()));
}

#[test]
fn a_pixels_depth_is_that_of_the_point_drawn_there() {
    drawn_depth::<LinearDepth>();
    drawn_depth::<FloatDepth>();
    drawn_depth::<WideFloatDepth>();
}

/// Draws triangles with corners in the near or the far plane, or between them. The depths of the pixels must be between
/// the depths of the corners, up to `slack` at either end.
fn depths_between_corners<F: DepthBuffer>(random: &mut Random, slack: u16) {
    const SIZE: u32 = 40;
    let window = Window::centered(fx!(40), fx!(40));
    let projection = Projection::orthographic(window, fx!(1), fx!(11)).unwrap();
    let positions = [(); 3].map(|()| {
        let depth = [-11., -11., -1., random.random_range(-11.0..-1.)];
        let depth = depth[random.random_range(0..4)];
        // Edges between pixels' centers meet other centers exactly. There, 1/w is as small as at the edge's ends.
        let [x, y] = [(); 2].map(|()| f64::from(random.random_range(-30..30)) + 0.5);
        rounded([x, y, depth])
    });
    let mesh = Mesh::new(&positions, &[[0, 1, 2], [0, 2, 1]]).unwrap();
    let (mut pixels, mut depths) = ([Gray8::BLACK; 1600], [0; 1600]);
    let canvas = Canvas::new(&mut pixels, SIZE, SIZE).unwrap();
    let mut canvas = canvas.with_depth_format::<F>(&mut depths).unwrap();
    let options = DrawOptions::new().with_depth_test(WriteOnly);
    canvas.draw_with(&options, &mesh, &projection, &Flat::new(Gray8::WHITE));
    // The depth of a corner outside the canvas is asked for at its foot on the middle axis.
    let corners = positions.map(|Vec3 { z, .. }| {
        let foot = Vec3::new(fx!(0), fx!(0), z);
        let at = canvas.viewport().project(foot, &projection).unwrap();
        at.depth::<F>()
    });
    let [least, most] = [corners.iter().min(), corners.iter().max()].map(|at| *at.unwrap());
    let between = least.saturating_sub(slack)..=most.saturating_add(slack);
    for (pixel, depth) in pixels.iter().zip(&depths) {
        assert!(
            *pixel == Gray8::BLACK || between.contains(depth),
            "{depth} is not in {between:?}: {positions:?}"
        );
    }
}

/// At the far plane, 1/w is so small that a rounding error could make it negative.
///
/// The error of an interpolated 1/w is at most 40 units, and the least 1/w is 2¹¹ units. Linear depths round it to whole
/// steps of 2¹⁵ units. At the far plane, floating-point depths of 12 and 11 bits have steps of ½ and 1 unit.
#[test]
fn depths_do_not_wrap_at_the_far_plane() {
    cases(sampled(4_000), |random| {
        depths_between_corners::<LinearDepth>(random, 1);
        depths_between_corners::<FloatDepth>(random, 80);
        depths_between_corners::<WideFloatDepth>(random, 40);
    });
}

const VIEW: (u32, u32) = (64, 48);

/// The pixels of a picture, and its depths.
type Seen = (Vec<u8>, Vec<u16>);

/// Draws on a cleared canvas, and returns its pixels and its depths.
fn seen<F: DepthBuffer>(draw: impl FnOnce(&mut Canvas<'_, Gray8, Native, F>)) -> Seen {
    let pixels = (VIEW.0 * VIEW.1) as usize;
    let (mut colors, mut depths) = (vec![Gray8::BLACK; pixels], vec![0; pixels]);
    let canvas = Canvas::new(&mut colors, VIEW.0, VIEW.1).unwrap();
    let mut canvas = canvas.with_depth_format::<F>(&mut depths).unwrap();
    canvas.clear(Gray8::BLACK);
    draw(&mut canvas);
    (colors.iter().map(GrayColor::luma).collect(), depths)
}

/// A view of a square with sides of 4 at a distance of 5 to 9, tilted by up to 65 degrees. At the nearest point, w is 3,
/// and a unit of depth is 1/730. A pixel is 1/27 there, so the depth changes by at most 27 · tan 65° · 2 = 120 units.
fn tilted(random: &mut Random) -> Mvp {
    let [turn, tilt, roll] = [180., 65., 180.].map(|most: f64| random.random_range(-most..most));
    let angle = |degrees: f64| Angle::try_from_degrees(degrees).unwrap();
    let ahead = rounded([0., 0., -random.random_range(5.0..9.)]);
    Projection::perspective(deg!(60), VIEW, fx!(0.1), fx!(100)).unwrap()
        * Transform::translate(ahead)
        * Transform::rotate_z(angle(roll))
        * Transform::rotate_x(angle(90. + tilt))
        * Transform::rotate_y(angle(turn))
}

static SQUARE: Mesh = shape!(plane(1, 1));
static RING: Mesh = shape!(torus(fx!(0.45), 24, 12));

/// Presses a turned ring flat onto a square, as a planar shadow is, and draws it with [`Add`]. Every pixel of the ring
/// must be added exactly once.
fn shadow_once<F: DepthBuffer>(random: &mut Random) {
    let view = tilted(random);
    let square = view * Transform::scale(fx!(2));
    let [a, b] = random.random::<[u32; 2]>().map(Angle::from_bits);
    let flat = Transform::scale_axes(vec3!(1, 0, 1));
    let flat = view * (flat * Transform::rotate_x(a) * Transform::rotate_z(b));
    let both_sides = DrawOptions::new().with_cull(Cull::Nothing);
    let ground = |canvas: &mut Canvas<'_, Gray8, Native, F>| {
        canvas.draw_with(&both_sides, &SQUARE, &square, &Flat::new(Gray8::new(1)));
    };
    let (found, _) = seen::<F>(|canvas| {
        ground(canvas);
        let once = both_sides
            .with_depth_test(Biased::coplanar(TestNearer))
            .with_blending(Add);
        canvas.draw_with(&once, &RING, &flat, &Flat::new(Gray8::new(50)));
    });
    let (expected, _) = seen::<F>(|canvas| {
        ground(canvas);
        let over = both_sides.with_depth_test(NoTest);
        canvas.draw_with(&over, &RING, &flat, &Flat::new(Gray8::new(51)));
    });
    assert_eq!(found, expected);
}

#[test]
fn a_shadow_on_a_plane_darkens_each_pixel_once() {
    cases(sampled(400), |random| {
        shadow_once::<LinearDepth>(random);
        shadow_once::<FloatDepth>(random);
        shadow_once::<WideFloatDepth>(random);
    });
}

/// A draw call.
type Call<'d> = &'d dyn Fn(&mut Canvas<'_, Gray8, Native, LinearDepth>, &Mvp);

/// What `TestBehind` draws and what `TestOnly` draws are together what `NoTest` draws, and nothing is drawn by both. All
/// three keep the depths.
#[test]
fn what_is_hidden_is_the_rest_of_what_is_seen() {
    cases(sampled(200), |random| {
        let (view, wall) = (tilted(random), tilted(random));
        let drawn = |call: Call<'_>| {
            seen::<LinearDepth>(|canvas| {
                let both_sides = DrawOptions::new().with_cull(Cull::Nothing);
                canvas.draw_with(&both_sides, &SQUARE, &wall, &Flat::new(Gray8::BLACK));
                call(canvas, &view);
            })
        };
        macro_rules! square {
            ($test:ident) => {
                drawn(&|canvas, view| {
                    // A square has one face at each pixel, so a pixel is either hidden or not.
                    let options = DrawOptions::new()
                        .with_cull(Cull::Nothing)
                        .with_depth_test($test);
                    canvas.draw_with(&options, &SQUARE, view, &Flat::new(Gray8::WHITE));
                })
            };
        }
        let [hidden, shown, all] = [square!(TestBehind), square!(TestOnly), square!(NoTest)];
        for (at, &all) in all.0.iter().enumerate() {
            let parts = [hidden.0[at], shown.0[at]].map(u32::from);
            assert_eq!(parts[0] + parts[1], u32::from(all), "{at}");
        }
        assert!(hidden.1 == all.1 && shown.1 == all.1);
    });
}

/// Draws a near triangle, calls `between`, and draws a farther one. Returns how many pixels show the near triangle
/// (gray 1) and the farther one (gray 2).
fn shown<F: DepthBuffer>(between: fn(&mut Canvas<'_, Gray8, Native, F>)) -> [usize; 2] {
    let mut pixels = [Gray8::BLACK; 64];
    let mut depths = [0; 64];
    let canvas = Canvas::new(&mut pixels, 8, 8).unwrap();
    let mut canvas = canvas.with_depth_format::<F>(&mut depths).unwrap();
    triangle(&mut canvas, Gray8::new(1), 2);
    between(&mut canvas);
    triangle(&mut canvas, Gray8::new(2), 3);
    [1, 2].map(|gray| pixels.iter().filter(|pixel| pixel.luma() == gray).count())
}

fn clearing<F: DepthBuffer>() {
    assert_eq!(
        shown::<F>(|_| ()),
        [28, 0],
        "the nearer triangle hides the other"
    );
    let solid = shown::<F>(|canvas| {
        let Ok(()) = canvas.fill_solid(&canvas.bounding_box(), Gray8::BLACK);
    });
    assert_eq!(solid, [0, 0], "a fill keeps the depths");
    assert_eq!(shown::<F>(|canvas| canvas.clear(Gray8::BLACK)), [0, 28]);
    let cleared = shown::<F>(|canvas| {
        let Ok(()) = DrawTarget::clear(canvas, Gray8::BLACK);
    });
    assert_eq!(
        cleared,
        [0, 28],
        "embedded-graphics' clear also clears the depths"
    );
    // Without a depth test, the second triangle covers the first one.
    let uncovered = shown::<F>(|canvas| {
        canvas.clear_depth();
    });
    assert_eq!(uncovered, [0, 28]);
    assert_eq!(
        shown::<F>(|canvas| {
            canvas.clear_depth();
            triangle(canvas, Gray8::new(1), 2);
        }),
        [28, 0],
        "the depth test is on again"
    );
}

#[test]
fn clear_resets_depths_and_fill_keeps_them() {
    clearing::<LinearDepth>();
    clearing::<FloatDepth>();
    clearing::<WideFloatDepth>();
}

/// Without a depth buffer, clearing sets only the colors.
#[test]
fn clear_works_without_a_depth_buffer() {
    let mut pixels = [Gray8::WHITE; 4];
    let mut canvas = Canvas::new(&mut pixels, 2, 2).unwrap();
    canvas.clear_depth();
    assert!(canvas.pixels().all(|pixel| pixel == Gray8::WHITE));
    let Ok(()) = DrawTarget::clear(&mut canvas, Gray8::BLACK);
    assert_eq!(pixels, [Gray8::BLACK; 4]);
}

/// Draws three plates (`#`), at 4, 3,200 and 522,240 times the distance of the near plane. After each plate, draws a
/// larger plate (`.`) that is a hundredth farther away. Distance 2^14 lies between the last two plates, so their 1/w
/// have different exponents.
fn plates<F: DepthBuffer>() -> MockDisplay<BinaryColor> {
    const SIZE: (u32, u32) = (26, 6);
    const FOCAL: f64 = 16.;
    let projection = Projection::from_focal_length(
        Scalar::try_from(FOCAL).unwrap(),
        SIZE,
        Scalar::try_from(1. / 32.).unwrap(),
        Scalar::try_from(31_250.).unwrap(),
    )
    .unwrap();
    let mut pixels = [BinaryColor::Off; 26 * 6];
    let mut depths = [0; 26 * 6];
    let canvas = Canvas::new(&mut pixels, SIZE.0, SIZE.1).unwrap();
    let mut canvas = canvas.with_depth_format::<F>(&mut depths).unwrap();
    canvas.clear(BinaryColor::Off);
    let mut plate = |[left, top, right, bottom]: [i32; 4], distance: f64, color| {
        let corners = [(left, bottom), (right, bottom), (right, top), (left, top)];
        let positions = corners.map(|(x, y)| {
            let [x, y] = [x - 13, 3 - y].map(|at| f64::from(at) * distance / FOCAL);
            let [x, y, z] = [x, y, -distance].map(|at| Scalar::try_from(at).unwrap());
            Vec3::new(x, y, z)
        });
        let mesh = Mesh::new(&positions, &[[0, 1, 2], [0, 2, 3]]).unwrap();
        canvas.draw(&mesh, &projection, &Flat::new(color));
    };
    for (left, distance) in [(1, 0.125), (10, 100.), (19, 16_320.)] {
        let front = [left + 1, 1, left + 5, 5];
        plate(front, distance, BinaryColor::On);
        plate([left, 0, left + 6, 6], 1.01 * distance, BinaryColor::Off);
    }
    let mut display = MockDisplay::new();
    canvas.show(&mut display).unwrap();
    display
}

/// If the format stores equal depths for both plates, the farther plate shows, because it is drawn last.
#[test]
fn the_resolution_of_each_depth_format() {
    plates::<LinearDepth>().assert_pattern(&[
        "..........................",
        "..####....................",
        "..####....................",
        "..####....................",
        "..####....................",
        "..........................",
    ]);
    plates::<FloatDepth>().assert_pattern(&[
        "..........................",
        "..####.....####...........",
        "..####.....####...........",
        "..####.....####...........",
        "..####.....####...........",
        "..........................",
    ]);
    plates::<WideFloatDepth>().assert_pattern(&[
        "..........................",
        "..####.....####.....####..",
        "..####.....####.....####..",
        "..####.....####.....####..",
        "..####.....####.....####..",
        "..........................",
    ]);
}
