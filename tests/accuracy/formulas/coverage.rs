//! Edge functions, areas, and centers on edges.

use fixel::prelude::*;
use rand::Rng;

use support::counter::{BOTH_SIDES, Counter, at_subpixel, pixel_projection};
use support::random::{Random, cases};

const SIZE: (u32, u32) = (12, 12);

/// (b − a) × (p − a), in any unit.
fn edge(a: [i64; 2], b: [i64; 2], p: [i64; 2]) -> i64 {
    (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])
}

/// Whether a triangle with corners that run clockwise covers a center, after the center has moved by an infinitely
/// small step to the right, and by a far smaller step down.
fn covers(corners: [[i64; 2]; 3], center: [i64; 2]) -> bool {
    (0..3).all(|i| {
        let (a, b) = (corners[i], corners[(i + 1) % 3]);
        // The edge function, and by how much it grows to the right and down. The first number that is not zero decides.
        let numbers = [edge(a, b, center), a[1] - b[1], b[0] - a[0]];
        numbers.into_iter().find(|&number| number != 0) > Some(0)
    })
}

/// A point of which every second one is the center of a pixel, in units of half a pixel.
fn halves(random: &mut Random) -> [i64; 2] {
    [0; 2].map(|_: i64| random.random_range(0..24))
}

/// How often the crate draws each pixel of triangles, with corners in units of half a pixel.
fn drawn(triangles: &[[[i64; 2]; 3]]) -> Vec<u32> {
    let mut counter = Counter::new(SIZE);
    for corners in triangles {
        let corners = corners.map(|corner| at_subpixel(corner.map(|at| (at * 128) as i32)));
        let mesh = Mesh::new(&corners, &[[0, 1, 2]]).unwrap();
        counter.draw(&BOTH_SIDES, &mesh, &pixel_projection(SIZE));
    }
    counter.take()
}

fn centers() -> impl Iterator<Item = [i64; 2]> {
    (0..12).flat_map(|y| (0..12).map(move |x| [2 * x + 1, 2 * y + 1]))
}

#[test]
fn edge_functions_add_up_to_twice_the_area() {
    cases(256, |random| {
        let [a, b, c, p] = [0; 4].map(|_: i32| halves(random));
        let twice = edge(a, b, c);
        assert_eq!(edge(a, b, p) + edge(b, c, p) + edge(c, a, p), twice);
        assert_eq!(edge(b, a, p), -edge(a, b, p));
        // One step to the right and one step down.
        assert_eq!(edge(a, b, [p[0] + 1, p[1]]) - edge(a, b, p), a[1] - b[1]);
        assert_eq!(edge(a, b, [p[0], p[1] + 1]) - edge(a, b, p), b[0] - a[0]);
        // The default options cull clockwise triangles, which have a positive area.
        let corners = [a, b, c].map(|corner| at_subpixel(corner.map(|at| (at * 128) as i32)));
        let mesh = Mesh::new(&corners, &[[0, 1, 2]]).unwrap();
        let mut counter = Counter::new(SIZE);
        let front = counter.draw(&DrawOptions::new(), &mesh, &pixel_projection(SIZE));
        assert!(twice < 0 || front.drawn == 0);
    });
}

/// Corners are pixel centers or lie halfway between two, so many centers are exactly on edges and corners.
#[test]
fn the_top_left_rule_moves_centers_to_the_right_and_down() {
    cases(2_048, |random| {
        let [a, b, c] = [0; 3].map(|_: i32| halves(random));
        let clockwise = match edge(a, b, c) {
            0 => return,
            1.. => [a, b, c],
            _ => [a, c, b],
        };
        let counts = drawn(&[[a, b, c]]);
        for (center, count) in centers().zip(counts) {
            assert_eq!(
                count,
                u32::from(covers(clockwise, center)),
                "{center:?} of {clockwise:?}"
            );
        }
    });
}

/// Four triangles around a point: together, they have each pixel of their square once.
#[test]
fn a_fan_has_each_pixel_once() {
    cases(256, |random| {
        let middle = [0; 2].map(|_: i64| random.random_range(4..20));
        let square = [[3, 3], [21, 3], [21, 21], [3, 21]];
        let fan = [0, 1, 2, 3].map(|i: usize| [square[i], square[(i + 1) % 4], middle]);
        for (center, count) in centers().zip(drawn(&fan)) {
            let inside = center.iter().all(|at| (3..21).contains(at));
            assert_eq!(count, u32::from(inside), "{center:?} around {middle:?}");
        }
    });
}

#[test]
fn the_guides_shared_edge() {
    let figure = include_str!("../../../src/guide/diagrams/shared_edge.svg");
    let [a, b, c, d] = [[3, 3], [11, 3], [3, 11], [11, 11]];
    // By hand: the edge functions at (3.5, 3.5), in units of a quarter of a pixel's area.
    let center = [7, 7];
    assert_eq!(edge(c, b, center), 0);
    assert_eq!([edge(b, d, center), edge(d, c, center)], [4 * 8, 4 * 8]);
    let mut rects = 0;
    for (corners, color, count) in [([a, b, c], "#d9822b", 10), ([b, d, c], "#3b8fd9", 6)] {
        let pixels = drawn(&[corners]);
        assert_eq!(pixels.iter().sum::<u32>(), count);
        for ([x, y], _) in centers().zip(pixels).filter(|(_, count)| *count > 0) {
            let [left, top] = [x, y].map(|at| 12 + 36 * (at / 2));
            let rect = format!(
                "<rect x=\"{left}\" y=\"{top}\" width=\"36\" height=\"36\" fill=\"{color}\""
            );
            assert!(figure.contains(&rect), "no {rect}");
            rects += 1;
        }
    }
    assert_eq!(figure.matches("<rect ").count(), rects);
}
