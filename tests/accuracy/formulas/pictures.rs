//! Wireframes, as pictures.

use embedded_graphics::pixelcolor::BinaryColor;
use fixel::Window;
use fixel::prelude::*;
use fixel::view::Perspective;

use support::moves::exact;

const SIZE: u32 = 28;

static CUBE: [Vec3; 8] = [
    vec3!(-1, -1, 1),
    vec3!(1, -1, 1),
    vec3!(1, 1, 1),
    vec3!(-1, 1, 1),
    vec3!(-1, -1, -1),
    vec3!(1, -1, -1),
    vec3!(1, 1, -1),
    vec3!(-1, 1, -1),
];

static EDGES: [[u16; 2]; 12] = [
    [0, 1],
    [1, 2],
    [2, 3],
    [3, 0],
    [4, 5],
    [5, 6],
    [6, 7],
    [7, 4],
    [0, 4],
    [1, 5],
    [2, 6],
    [3, 7],
];

/// A projection with the window of the practice cube: ±1 at a distance of 2.
fn projection() -> Projection<Perspective> {
    Projection::frustum(Window::centered(fx!(2), fx!(2)), fx!(2), fx!(10)).unwrap()
}

/// A wireframe of the cube from −1 to 1, as `#` on `.`.
fn picture(model: Transform) -> Vec<String> {
    let mesh = Mesh::new(&CUBE, &[])
        .and_then(|mesh| mesh.with_edges(&EDGES))
        .unwrap();
    let mut pixels = [BinaryColor::Off; (SIZE * SIZE) as usize];
    let mut canvas = Canvas::new(&mut pixels, SIZE, SIZE).unwrap();
    let mvp = projection() * model;
    canvas.draw(
        mesh.edges(LineStyle::HAIRLINE),
        &mvp,
        &Flat::new(BinaryColor::On),
    );
    let ink = |color: &BinaryColor| if color.is_on() { '#' } else { '.' };
    pixels
        .chunks(SIZE as usize)
        .map(|row| row.iter().map(ink).collect())
        .collect()
}

/// The position of a point of the model in the picture. The projection is computed in f64 from the point's position in
/// eye space.
fn place(model: Transform, point: Vec3) -> [f64; 2] {
    let [x, y, z] = exact(model.point(point));
    let half = f64::from(SIZE) / 2.0;
    [half - 2.0 * x / z * half, half + 2.0 * y / z * half]
}

fn distance(p: [f64; 2], [a, b]: [[f64; 2]; 2]) -> f64 {
    let (along, to) = ([b[0] - a[0], b[1] - a[1]], [p[0] - a[0], p[1] - a[1]]);
    let squared = along[0] * along[0] + along[1] * along[1];
    let t = ((along[0] * to[0] + along[1] * to[1]) / squared).clamp(0.0, 1.0);
    (to[0] - t * along[0]).hypot(to[1] - t * along[1])
}

/// Checks that every pixel is on an edge, and that every edge has a pixel in each row or column that it crosses.
#[allow(clippy::cast_precision_loss)] // below 28
fn check(model: Transform, picture: &[String]) {
    let edges = EDGES.map(|edge| edge.map(|i| place(model, CUBE[usize::from(i)])));
    let on = |x: usize, y: usize| picture[y].as_bytes()[x] == b'#';
    let center = |x: usize, y: usize| [x as f64 + 0.5, y as f64 + 0.5];
    let size = SIZE as usize;
    for (x, y) in (0..size).flat_map(|y| (0..size).map(move |x| (x, y))) {
        let near = edges
            .iter()
            .any(|&edge| distance(center(x, y), edge) <= 0.51);
        // A pixel's center may be half a pixel from the edge along the edge's shorter axis, plus a subpixel for
        // rounding.
        assert!(!on(x, y) || near, "({x}, {y}) is on no edge");
    }
    for [a, b] in edges {
        let steep = (b[1] - a[1]).abs() > (b[0] - a[0]).abs();
        let axis = usize::from(steep);
        let (from, to) = (a[axis].min(b[axis]), a[axis].max(b[axis]));
        for along in 0..size {
            // Skip pixel centers that are not well between the ends.
            if along as f64 + 0.49 < from || along as f64 + 0.51 > to {
                continue;
            }
            let found = (0..size).any(|across| {
                let (x, y) = if steep {
                    (across, along)
                } else {
                    (along, across)
                };
                on(x, y) && distance(center(x, y), [a, b]) <= 0.51
            });
            assert!(found, "the edge from {a:?} to {b:?} has a hole at {along}");
        }
    }
}

/// The number of the model's axes that have a vanishing point.
fn vanishing_points(model: Transform) -> usize {
    [Vec3::X, Vec3::Y, Vec3::Z]
        .into_iter()
        .filter(|&axis| {
            projection()
                .vanishing_point(model.direction(axis))
                .is_some()
        })
        .count()
}

fn expect(model: Transform, expected: &[&str]) {
    let found = picture(model);
    check(model, &found);
    assert!(found == expected, "\n{}", found.join("\n"));
}

const BACK: Vec3 = vec3!(0, 0, -4);

#[test]
fn the_practice_cube_in_one_point_perspective() {
    let model = Transform::translate(BACK);
    assert_eq!(vanishing_points(model), 1);
    expect(
        model,
        &[
            "............................",
            "............................",
            "............................",
            "............................",
            "....####################....",
            "....##................##....",
            "....#.#..............#.#....",
            "....#..#............#..#....",
            "....#...############...#....",
            "....#...#..........#...#....",
            "....#...#..........#...#....",
            "....#...#..........#...#....",
            "....#...#..........#...#....",
            "....#...#..........#...#....",
            "....#...#..........#...#....",
            "....#...#..........#...#....",
            "....#...#..........#...#....",
            "....#...#..........#...#....",
            "....#...#..........#...#....",
            "....#...############...#....",
            "....#..#............#..#....",
            "....#.#..............#.#....",
            "....##................##....",
            "....####################....",
            "............................",
            "............................",
            "............................",
            "............................",
        ],
    );
}

#[test]
fn two_point_perspective() {
    let model = Transform::translate(BACK) * Transform::rotate_y(Angle::from_degrees(-30));
    assert_eq!(vanishing_points(model), 2);
    expect(
        model,
        &[
            "............................",
            "............................",
            "............................",
            "...............####.........",
            "..........#####..#.#........",
            ".....#####.......#..#.......",
            "...###...........#...#......",
            "...#..###........#.####.....",
            "...#.....##########...#.....",
            "...#........#....#....#.....",
            "...#........#....#....#.....",
            "...#........#....#....#.....",
            "...#........#....#....#.....",
            "...#........#....#....#.....",
            "...#........#....#....#.....",
            "...#........#....#....#.....",
            "...#........#....#....#.....",
            "...#........#....#....#.....",
            "...#........#....#....#.....",
            "...#.....##########...#.....",
            "...#..###........#.####.....",
            "...###...........#...#......",
            ".....#####.......#..#.......",
            "..........#####..#.#........",
            "...............####.........",
            "............................",
            "............................",
            "............................",
        ],
    );
}

#[test]
fn three_point_perspective() {
    let model = Transform::translate(BACK)
        * Transform::rotate_x(Angle::from_degrees(35))
        * Transform::rotate_y(Angle::from_degrees(-30));
    assert_eq!(vanishing_points(model), 3);
    expect(
        model,
        &[
            "............................",
            "............................",
            "............................",
            "............................",
            "..........#######...........",
            "........##.#.....######.....",
            ".....###...#...........##...",
            "...##......#...........#....",
            ".##........#..........##....",
            "..#####....#.........#.#....",
            "..#....###..#.......#..#....",
            "..#.......###.......#..#....",
            "..#.........#####..#..#.....",
            "...#........#....##...#.....",
            "...#.......####...#...#.....",
            "...#......#....##.#...#.....",
            "...#.....#.......###..#.....",
            "....#...#.........#.##......",
            "....#..#.........#...#......",
            "....#.#..........#..#.......",
            "....##...........#..#.......",
            "......#..........#.#........",
            ".......##........#.#........",
            ".........##......##.........",
            "...........##....##.........",
            ".............##..#..........",
            "...............###..........",
            "............................",
        ],
    );
}
