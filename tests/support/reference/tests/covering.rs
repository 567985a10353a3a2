//! The top-left rule, shown in pictures and checked by its properties.

use super::*;
use coverage::*;

/// A triangle with corners in whole pixels.
fn pixels(t: [[i32; 2]; 3]) -> Snapped {
    t.map(|corner| corner.map(|x| x * 256))
}

#[test]
fn a_triangle_does_not_own_centers_on_its_right_edge() {
    // Centers on the edge x + y = 4 belong to the neighbor, because the edge is neither a top edge nor a left edge.
    let t = pixels([[0, 0], [4, 0], [0, 4]]);
    let expected = ["111.", "11..", "1...", "...."];
    assert_eq!(picture(&counts(&[t], 4, 4), 4), expected);
    let [a, b, c] = t;
    assert_eq!(picture(&counts(&[[c, b, a]], 4, 4), 4), expected);
    assert_eq!(area2(t), 16 * 256 * 256);
}

#[test]
fn a_triangle_owns_centers_on_its_left_edge() {
    // The edge x + y = 4 is this triangle's left edge.
    let t = pixels([[4, 0], [4, 4], [0, 4]]);
    let expected = ["...1", "..11", ".111", "1111"];
    assert_eq!(picture(&counts(&[t], 4, 4), 4), expected);
}

#[test]
fn top_and_left_edges_on_centers_are_in() {
    // Two triangles make a rectangle. The rectangle's corners are the centers of the pixels (0, 0), (3, 0), (3, 2) and
    // (0, 2).
    let corner = |x: i32, y: i32| [x * 256 + 128, y * 256 + 128];
    let [a, b, c, d] = [corner(0, 0), corner(3, 0), corner(3, 2), corner(0, 2)];
    let square = counts(&[[a, b, c], [a, d, c]], 5, 4);
    assert_eq!(picture(&square, 5), ["111..", "111..", ".....", "....."]);
}

#[test]
fn no_area_no_pixels() {
    assert_eq!(covered(pixels([[0, 0], [2, 2], [4, 4]]), 9, 9).count(), 0);
    assert_eq!(covered(pixels([[1, 1]; 3]), 9, 9).count(), 0);
}

#[test]
fn the_widest_coordinates_are_exact() {
    let all = [i32::MIN, i32::MAX];
    let t = [[all[0], all[0]], [all[1], all[0]], [all[0], all[1]]];
    assert_eq!(area2(t), ((1_i128 << 32) - 1).pow(2));
    // The longest edge is the line x + y = −1/256 pixel.
    assert_eq!(covered(t, 3, 3).count(), 0);
    assert!(covers(t, [-1, -1]) && !covers(t, [-1, 0]));
}

#[test]
fn a_fan_covers_each_pixel_once() {
    // A square is split at any point. Every pixel of the square is covered once, and no pixel outside is covered.
    let mut random = Random(2);
    for _ in 0..200 {
        let corners = [[0, 0], [9, 0], [9, 9], [0, 9]].map(|c| c.map(|x| x * 256 + 128));
        let middle = [random.range(129, 2432), random.range(129, 2432)];
        let fan: [_; 4] = std::array::from_fn(|i| [middle, corners[i], corners[(i + 1) % 4]]);
        let counts = counts(&fan, 11, 11);
        for (i, count) in counts.into_iter().enumerate() {
            assert_eq!(count, u32::from(i % 11 < 9 && i / 11 < 9), "{middle:?}");
        }
    }
}

#[test]
fn floats_agree_with_integers() {
    let mut random = Random(3);
    for round in 0..2000 {
        // Some vertices are at pixel centers, where the top-left rule decides.
        let step = [1, 16, 128][round % 3];
        let t = [(); 3].map(|()| [(); 2].map(|()| random.range(-40, 200) * step));
        let corners = t.map(view::unsnap);
        for pixel in Bounds::new(12, 12).pixels() {
            assert_eq!(
                covers(t, pixel),
                covers_f64(&corners, center(pixel)),
                "{t:?}"
            );
        }
    }
}

#[test]
fn shares_beside_a_line() {
    let share = |line| coverage::share_beside(line, [2, 1]);
    close(
        [
            // Straight down, a quarter of the pixel from its right side: the left part is on the positive side.
            share([[2.75, -9.], [2.75, 9.]]),
            share([[2.75, 9.], [2.75, -9.]]),
            // From corner to corner.
            share([[2., 1.], [3., 2.]]),
            // The triangle with the legs 1/2 and 1/4 at the top left corner.
            share([[2.5, 1.], [2., 1.25]]),
            share([[2., 1.25], [2.5, 1.]]),
            // Along a side, and past the pixel.
            share([[2., 1.], [3., 1.]]),
            share([[2., 2.], [3., 2.]]),
            share([[0., 9.], [9., 8.]]),
        ],
        [0.75, 0.25, 0.5, 0.0625, 0.9375, 1., 0., 0.],
    );
}

#[test]
fn distances_to_segments_and_triangles() {
    let t = [[0., 0.], [4., 0.], [0., 3.]];
    close(
        [
            distance::to_triangle(&t, [1., 1.]),
            distance::to_triangle(&t, [7., -4.]),
            distance::to_triangle(&t, [-2., 1.]),
            distance::to_segment(t[1], t[2], [0., 0.]),
            distance::to_segment(t[0], t[0], [3., 4.]),
        ],
        [0., 5., 2., 2.4, 5.],
    );
}
