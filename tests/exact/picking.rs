//! Rays that meet edges, vertices and either side of a face; rays with numbers at the ends of the formats; and labels.

use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{Dimensions, Point, Size};
use embedded_graphics::mock_display::MockDisplay;
use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
use embedded_graphics::primitives::Rectangle;
use embedded_graphics::{Drawable, Pixel, prelude::Primitive as _, primitives::PrimitiveStyle};
use fixel::num::Subpixel;
use fixel::prelude::*;
use fixel::{ScreenPoint, Window};
use rand::Rng;

use support::random::{cases, list};

static FLOOR: Mesh = shape!(plane(8, 8));
static BALL: Mesh = shape!(sphere(16, 12));

/// No ray passes between two faces, because vertices and edges have exact coordinates.
#[test]
fn rays_through_vertices_and_edges_meet_a_face() {
    for direction in [vec3!(0, -1, 0), vec3!(0, -4, 1), vec3!(1, -2, 1)] {
        for x in -7..8 {
            for z in -7..8 {
                let on_floor = Vec3::new(fx!(0.125) * x, fx!(0), fx!(0.125) * z);
                let ray = Ray::new(on_floor - direction * fx!(3), direction).unwrap();
                let hit = ray.hit(&FLOOR).unwrap();
                // The direction is rounded to 30 bits, so the hit is not exact.
                assert!(hit.point.distance(on_floor) < fx!(0.0001), "{hit:?}");
            }
        }
    }
    for position in BALL.positions().iter() {
        let ray = Ray::new(position * fx!(3), -position).unwrap();
        assert!(ray.hit(&BALL).is_some(), "{position}");
    }
}

#[test]
fn culling_decides_which_sides_a_ray_meets() {
    let above = Ray::new(vec3!(0.3, 2, 0.1), vec3!(0, -1, 0)).unwrap();
    let below = Ray::new(vec3!(0.3, -2, 0.1), vec3!(0, 1, 0)).unwrap();
    let away = Ray::new(vec3!(0.3, 2, 0.1), vec3!(0, 1, 0)).unwrap();
    for (cull, meets) in [
        (Cull::Nothing, [true, true]),
        (Cull::Back, [true, false]),
        (Cull::Front, [false, true]),
    ] {
        let rays = [above, below].map(|ray| Ray { cull, ..ray }.hit(&FLOOR).is_some());
        assert_eq!(rays, meets, "{cull:?}");
        assert_eq!(Ray { cull, ..away }.hit(&FLOOR), None);
    }
    let error = Ray::new(Vec3::X, Vec3::ZERO).unwrap_err();
    assert_eq!(
        error.to_string(),
        "direction is (0, 0, 0): at least one component must not be 0"
    );
    // Of several faces in one place, a ray meets the last face, because the last face is drawn over the other faces.
    let positions = [vec3!(0, 0, 0), vec3!(1, 0, 0), vec3!(0, 1, 0)];
    let twice = Mesh::new(&positions, &[[0, 1, 2], [2, 0, 1]]).unwrap();
    let ray = Ray::new(vec3!(0.25, 0.25, 1), vec3!(0, 0, -1)).unwrap();
    assert_eq!(ray.hit(&twice).map(|hit| hit.face), Some(1));
}

#[test]
fn pixels_outside_and_models_without_an_inverse_have_no_ray() {
    let screen = Viewport::new(0, 0, 8, 8).unwrap();
    let projection = Projection::perspective(deg!(60), (1, 1), fx!(0.1), fx!(100)).unwrap();
    for (x, y) in [(-1, 0), (0, -1), (8, 0), (0, 8), (i32::MIN, i32::MAX)] {
        assert_eq!(screen.ray(Point::new(x, y), &projection), None);
    }
    let flat = projection * Transform::scale_axes(vec3!(1, 0, 1));
    assert_eq!(screen.ray(Point::zero(), &flat), None);
    let tiny = projection * Transform::scale(Scalar::DELTA);
    assert_eq!(
        screen
            .ray(Point::zero(), &tiny)
            .map(|ray| ray.origin.x.abs() < fx!(9999)),
        Some(true)
    );
}

/// On the line of sight, x and y are exactly 0.
#[test]
fn the_middle_pixel_of_a_frame_of_odd_size_is_on_the_line_of_sight() {
    let screen = Viewport::new(0, 0, 9, 9).unwrap();
    let place = Transform::translate(vec3!(0, 0, -5));
    let (near, far) = (fx!(1), fx!(100));
    let perspective = Projection::perspective(deg!(60), (1, 1), near, far).unwrap() * place;
    let window = Window::centered(fx!(4), fx!(4));
    let parallel = Projection::orthographic(window, near, far).unwrap() * place;
    for ray in [
        screen.ray(Point::new(4, 4), &perspective),
        screen.ray(Point::new(4, 4), &parallel),
    ] {
        let ray = ray.unwrap();
        assert_eq!(ray.origin, vec3!(0, 0, 4));
        assert_eq!(ray.hit(&BALL).map(|hit| hit.point), Some(Vec3::Z));
    }
}

#[test]
fn no_ray_and_no_mesh_panics() {
    cases(256, |random| {
        let origin = Vec3::from_bits(random.random());
        let cut = random.random_range(0..32);
        let direction = Vec3::from_bits(random.random::<[i32; 3]>().map(|v| v >> cut));
        let positions = list(random, 3..9, |random| {
            Vec3::from_bits(match random.random_range(0..3) {
                0 => random.random(),
                1 => [i32::MIN; 3],
                _ => [i32::MAX; 3],
            })
        });
        let distance = Scalar::from_bits(random.random());
        let starts = 0..positions.len() as u16 - 2;
        let faces: Vec<_> = starts.map(|i| [i, i + 1, i + 2]).collect();
        let mesh = Mesh::new(&positions, &faces).unwrap();
        for origin in [origin, Vec3::from_bits([i32::MIN; 3]), positions[0]] {
            if let Ok(ray) = Ray::new(origin, direction) {
                let _ = (ray.hit(&mesh), ray.at(distance));
            }
            // A ray toward a point of a face, so that the ray meets this face or a nearer one.
            let middle = positions[0].lerp(positions[1], fx!(0.5));
            let middle = middle.lerp(positions[2], fx!(0.25));
            if let Ok(ray) = Ray::new(origin, middle - origin) {
                let _ = ray.hit(&mesh);
            }
        }
    });
}

/// A frame of 12x6 pixels. The right half is nearer than the left half.
fn labeled(
    draw: impl FnOnce(&mut Canvas<'_, Rgb565, fixel::canvas::Native, fixel::canvas::LinearDepth>),
) -> (MockDisplay<Rgb565>, Vec<u16>) {
    let mut colors = [Rgb565::BLACK; 12 * 6];
    let mut depths: Vec<u16> = (0..12 * 6)
        .map(|i| if i % 12 < 6 { 100 } else { 200 })
        .collect();
    let mut display = MockDisplay::new();
    let mut canvas = Canvas::new(&mut colors, 12, 6)
        .unwrap()
        .with_depth(&mut depths)
        .unwrap();
    draw(&mut canvas);
    canvas.show(&mut display).unwrap();
    (display, depths)
}

/// A map, for example, is moved by moving its window. The window can then be at coordinates that are far greater than
/// the window's size.
#[test]
fn a_window_far_from_the_origin_shows_what_lies_in_it() {
    let screen = Viewport::new(0, 0, 320, 240).unwrap();
    for place in [0, 300, -7_001, 20_000, -32_760] {
        let least = Vec3::from_bits([(place << 16) + 12_345, (place << 16) + 54_321, 0]);
        let window = Window {
            left: least.x,
            right: least.x + fx!(8),
            bottom: least.y,
            top: least.y + fx!(6),
        };
        let projection = Projection::orthographic(window, fx!(-1), fx!(1)).unwrap();
        // One unit is 40 pixels on the screen.
        for [x, y] in [[0, 0], [8, 6], [4, 3], [1, 5]] {
            let point = least + Vec3::from_ints(x, y, 0);
            let at = screen.project(point, &projection);
            let at = at.unwrap();
            let expected = [x * 40, 240 - y * 40].map(i32::from);
            for (found, expected) in [at.x, at.y].into_iter().zip(expected) {
                let error = found.to_bits() - expected * 256;
                assert!(error.abs() <= 1, "{place} {x} {y}: {error}");
            }
        }
    }
}

#[test]
fn the_distance_of_a_hit_is_rounded_to_nearest() {
    // Heights are left out if the distance would lie in the middle between two numbers, because the rounding of the
    // direction would then decide.
    for height in (65_536..65_546).filter(|height| height % 4 != 2) {
        let corners = [[-9, 9], [9, 9], [0, -9]].map(|[x, z]| {
            let [x, z] = [x, z].map(|v| v << 16);
            Vec3::from_bits([x, height, z])
        });
        let mesh = Mesh::new(&corners, &[[0, 1, 2]]).unwrap();
        // The distance is 5/4 of the height.
        let hit = Ray::new(Vec3::ZERO, vec3!(3, 4, 0)).unwrap().hit(&mesh);
        let nearest = (5 * height + 2) / 4;
        assert_eq!(hit.unwrap().distance.to_bits(), nearest, "{height}");
    }
}

/// A point with a linear depth above 0.
fn at(x: i32, y: i32, depth: u16) -> ScreenPoint {
    // A nearness has an exponent of 32 for depths from 2^15 to 2^16, and then the highest 26 bits of the depth.
    let up = depth.leading_zeros();
    let at = ScreenPoint {
        x: Subpixel::from_bits(x * 256 + 255),
        y: Subpixel::from_bits(y * 256),
        nearness: (32 - up) << 26 | u32::from(depth) << (10 + up),
    };
    assert_eq!(at.depth::<LinearDepth>(), depth);
    at
}

#[test]
fn a_labels_point_gives_its_place_and_depth() {
    let (display, depths) = labeled(|canvas| {
        let style = PrimitiveStyle::with_fill(Rgb565::RED);
        let mut label = canvas.label(at(4, 2, 199));
        Rectangle::new(Point::new(-1, -1), Size::new(5, 2))
            .into_styled(style)
            .draw(&mut label)
            .unwrap();
        // A label at exactly the stored depth is drawn, because a triangle at this depth would be drawn, too.
        let mut label = canvas.label(at(8, 4, 200));
        label
            .fill_contiguous(
                &Rectangle::new(Point::new(-1, 0), Size::new(9, 9)),
                [Rgb565::BLUE; 81],
            )
            .unwrap();
        canvas
            .label(at(0, 0, 99))
            .draw_iter([Pixel(Point::new(3, 0), Rgb565::WHITE)])
            .unwrap();
        canvas
            .label(at(0, 0, 100))
            .draw_iter([Pixel(Point::new(2, 0), Rgb565::WHITE)])
            .unwrap();
        canvas
            .label(at(5, 0, 0).on_top())
            .fill_solid(
                &Rectangle::new(Point::zero(), Size::new(2, 1)),
                Rgb565::YELLOW,
            )
            .unwrap();
    });
    display.assert_pattern(&[
        "KKWKKYYKKKKK",
        "KKKRRRKKKKKK",
        "KKKRRRKKKKKK",
        "KKKKKKKKKKKK",
        "KKKKKKKBBBBB",
        "KKKKKKKBBBBB",
    ]);
    assert!(
        depths.iter().all(|depth| [100, 200].contains(depth)),
        "labels do not change depths"
    );
}

#[test]
fn labels_accept_any_place_and_any_area() {
    for x in [i32::MIN >> 8, -1, 0, 5, i32::MAX >> 8] {
        let (display, _) = labeled(|canvas| {
            let mut label = canvas.label(at(x, x, 150));
            let area = label.bounding_box();
            assert_eq!(area, Rectangle::new(Point::new(-x, -x), Size::new(12, 6)));
            for corner in [i32::MIN, -9, 0, i32::MAX] {
                for size in [0, 7, u32::MAX] {
                    let area = Rectangle::new(Point::new(corner, corner), Size::new(size, size));
                    label.fill_solid(&area, Rgb565::GREEN).unwrap();
                    label.fill_contiguous(&area, [Rgb565::GREEN; 9]).unwrap();
                }
                label
                    .draw_iter([Pixel(Point::new(corner, corner), Rgb565::GREEN)])
                    .unwrap();
            }
            label.clear(Rgb565::RED).unwrap();
        });
        display.assert_pattern(&["RRRRRRKKKKKK"; 6].map(|row| row));
    }
}
