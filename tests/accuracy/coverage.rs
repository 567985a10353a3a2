//! The pixels that a triangle covers, compared with the exact half-space model, for every kind of mesh.
//!
//! The crate walks along edges with remainders. The model tests every pixel center against three exact half-spaces.
//! With the same snapped corners, both must draw the same pixels. The tests here therefore have no tolerance, except
//! the tests of clipped triangles, because clipping makes new corners.

use std::array::from_fn;
use std::ops::Range;

use fixel::prelude::*;
use fixel::view::ProjectionKind;
use rand::Rng;
use rand::seq::IndexedRandom;
use support::counter::{BOTH_SIDES, Counter, at_subpixel, pixel_projection};
use support::meshes::{Flat, Point, fan, grid, triangulation};
use support::random::{Random, cases, list, within};
use support::reference::coverage::{self, Bounds, Snapped, area2, center};
use support::reference::distance::to_segment;
use support::reference::view::unsnap;

/// Draws a mesh through the pixel projection. Checks the position of each vertex first.
fn draw(mesh: &Flat, size: (u32, u32), options: &DrawOptions) -> Vec<u32> {
    let projection = pixel_projection(size);
    let mut counter = Counter::new(size);
    let positions: Vec<Vec3> = mesh.points.iter().copied().map(at_subpixel).collect();
    for (&point, &position) in mesh.points.iter().zip(&positions) {
        assert_eq!(counter.snapped(&projection, position), Some(point));
    }
    let mesh = Mesh::new(&positions, &mesh.faces).unwrap();
    let drawn = counter.draw(options, &mesh, &projection);
    assert_eq!(drawn.clipped, 0);
    counter.take()
}

/// Positions of vertices: on pixel corners, on sixteenths, on any of 256 subpixels, or mostly on pixel centers, where
/// the top-left rule decides.
fn places(random: &mut Random, range: Range<i32>) -> Vec<Point> {
    let grains = [(256, 0), (16, 0), (1, 0), (256, 128), (128, 0)];
    let &(step, offset) = grains.choose(random).unwrap();
    let range = range.start * 256 / step..range.end * 256 / step;
    list(random, 3..24, |random| {
        from_fn(|_| random.random_range(range.clone()) * step + offset)
    })
}

/// A mesh of triangles that share no vertex.
fn loose(points: Vec<Point>) -> Flat {
    let faces = (0..u16::try_from(points.len()).unwrap() / 3)
        .map(|i| [3 * i, 3 * i + 1, 3 * i + 2])
        .collect();
    Flat { points, faces }
}

fn check_against_model(mesh: &Flat, size: (u32, u32)) {
    let (width, height) = size;
    let drawn = draw(mesh, size, &BOTH_SIDES);
    let model = coverage::counts(&mesh.triangles(), width, height);
    assert_eq!(
        coverage::picture(&drawn, width),
        coverage::picture(&model, width)
    );
}

const SIZE: (u32, u32) = (32, 24);

/// Overlapping triangles of any shape, many of them partly outside the picture.
#[test]
fn loose_triangles_cover_what_the_model_covers() {
    cases(256, |random| {
        check_against_model(&loose(places(random, -20..50)), SIZE);
    });
}

/// Slivers: two corners lie anywhere, and the third corner lies within a pixel of the line between them.
#[test]
fn slivers_cover_what_the_model_covers() {
    cases(256, |random| {
        let mut points = Vec::new();
        for _ in 0..random.random_range(1..12) {
            let [a, b]: [Point; 2] = from_fn(|_| within(random, [-2000..12_000, -2000..9000]));
            let part = random.random_range(0..=64);
            let c = from_fn(|i| a[i] + (b[i] - a[i]) * part / 64 + random.random_range(-3..=3));
            points.extend([a, b, c]);
        }
        check_against_model(&loose(points), SIZE);
    });
}

/// Corners lie anywhere in the guard band of ±2048 pixels. Edges are up to 4095 pixels wide and high.
#[test]
fn huge_triangles_cover_what_the_model_covers() {
    cases(256, |random| {
        let center = [SIZE.0, SIZE.1].map(|side| i32::try_from(side).unwrap() * 128);
        let points = list(random, 3..9, |random| {
            center.map(|at| at + random.random_range(-524_000..524_000))
        });
        let faces = (0..u16::try_from(points.len()).unwrap() - 2)
            .map(|i| [i, i + 1, i + 2])
            .collect();
        check_against_model(&Flat { points, faces }, SIZE);
    });
}

/// The triangles of a divided rectangle cover each of its pixels once: seen from the front, seen from behind, and with
/// triangles that face both ways.
#[test]
fn triangulations_cover_each_pixel_once() {
    cases(256, |random| {
        let points = places(random, 0..32);
        let [left, top] = from_fn(|_| random.random_range(-300..300));
        let (right, bottom) = (left + 32 * 256, top + 24 * 256);
        let inside: Vec<Point> = points
            .into_iter()
            .filter(|[x, y]| (left..=right).contains(x) && (top..=bottom).contains(y))
            .collect();
        let corners = [[left, top], [left, bottom], [right, bottom], [right, top]];
        let mesh = triangulation(corners, &inside);
        let centers = |axis: usize, [x, y]: [i32; 2]| {
            let center = [x, y][axis] * 256 + 128;
            let (from, to) = ([left, top][axis], [right, bottom][axis]);
            (from..to).contains(&center)
        };
        let expected: Vec<u32> = Bounds::new(SIZE.0, SIZE.1)
            .pixels()
            .map(|pixel| u32::from(centers(0, pixel) && centers(1, pixel)))
            .collect();
        let once = |mesh: &Flat, options: &DrawOptions| {
            assert_eq!(
                coverage::picture(&draw(mesh, SIZE, options), SIZE.0),
                coverage::picture(&expected, SIZE.0)
            );
        };
        let seed = random.random();
        let mesh = mesh.shuffled(seed, false);
        once(&mesh, &DrawOptions::new());
        let drawn = draw(&mesh, SIZE, &DrawOptions::new().with_cull(Cull::Front));
        assert!(drawn.iter().all(|&count| count == 0), "{mesh:?}");
        once(&mesh.shuffled(seed, true), &BOTH_SIDES);
    });
}

/// Fans: all triangles meet in one point.
#[test]
fn fans_cover_each_pixel_once() {
    cases(256, |random| {
        let points = places(random, -8..40);
        let mesh = fan(points[0], points[1..].to_vec());
        let drawn = draw(&mesh, SIZE, &DrawOptions::new());
        assert!(
            drawn.iter().all(|&count| count <= 1),
            "{:#?}",
            coverage::picture(&drawn, SIZE.0)
        );
        check_against_model(&mesh.shuffled(random.random(), true), SIZE);
    });
}

/// Strips and grids cover each pixel of the rectangle once.
#[test]
fn grids_cover_each_pixel_once() {
    cases(256, |random| {
        let columns = random.random_range(1..=20);
        let rows = random.random_range(1..=16);
        let cells = [columns, rows].map(i32::from);
        // Multiples of the numbers of cells, so that the width and the height of a cell are whole numbers of pixels.
        let area = [32 / cells[0] * cells[0], 24 / cells[1] * cells[1]];
        let moves = places(random, 0..32);
        let mesh = grid(columns, rows, area, &moves, random.random());
        let mesh = mesh.shuffled(random.random(), false);
        let expected: Vec<u32> = Bounds::new(SIZE.0, SIZE.1)
            .pixels()
            .map(|[x, y]| u32::from(x < area[0] && y < area[1]))
            .collect();
        assert_eq!(
            coverage::picture(&draw(&mesh, SIZE, &DrawOptions::new()), SIZE.0),
            coverage::picture(&expected, SIZE.0)
        );
    });
}

/// Draws every triangle with corners on multiples of half a pixel in a small picture. Some offsets move all corners.
#[test]
fn all_small_triangles_cover_what_the_model_covers() {
    const SIDE: i32 = 7;
    let size = (4, 4);
    let mut counter = Counter::new(size);
    let projection = pixel_projection(size);
    for offset in [[0, 0], [1, 127], [-128, 0], [129, -1], [64, 200]] {
        let points: Vec<Point> = (0..SIDE * SIDE)
            .map(|i| [i % SIDE * 128 + offset[0], i / SIDE * 128 + offset[1]])
            .collect();
        every_triangle(&mut counter, &projection, &points);
    }
}

/// Draws every triangle with corners within two subpixels of a pixel's center or corner.
#[test]
fn all_tiny_triangles_cover_what_the_model_covers() {
    const SIDE: i32 = 5;
    let size = (2, 2);
    let mut counter = Counter::new(size);
    let projection = pixel_projection(size);
    for center in [[128, 128], [256, 256], [384, 128]] {
        let points: Vec<Point> = (0..SIDE * SIDE)
            .map(|i| [i % SIDE - 2 + center[0], i / SIDE - 2 + center[1]])
            .collect();
        every_triangle(&mut counter, &projection, &points);
    }
}

fn every_triangle<K: ProjectionKind>(counter: &mut Counter, projection: &Mvp<K>, points: &[Point]) {
    let (width, height) = counter.size;
    let positions: Vec<Vec3> = points.iter().copied().map(at_subpixel).collect();
    let count = u16::try_from(points.len()).unwrap();
    for a in 0..count {
        for b in a + 1..count {
            for c in b + 1..count {
                let corners = [a, b, c].map(|i| points[usize::from(i)]);
                let model = coverage::counts(&[corners], width, height);
                for (face, front) in [
                    ([a, b, c], area2(corners) < 0),
                    ([c, b, a], area2(corners) > 0),
                ] {
                    let faces = [face];
                    let mesh = Mesh::new(&positions, &faces).unwrap();
                    counter.draw(&DrawOptions::new(), &mesh, projection);
                    let expected = if front {
                        model.clone()
                    } else {
                        vec![0; model.len()]
                    };
                    assert_eq!(counter.take(), expected, "{corners:?}, front {front}");
                    counter.draw(&BOTH_SIDES, &mesh, projection);
                    assert_eq!(counter.take(), model, "{corners:?}");
                }
            }
        }
    }
}

/// One unit of space, in units of 2⁻¹⁶.
const METER: i32 = 1 << 16;

/// Positions in space are seen in perspective. The crate reports where it snaps corners, and it must cover the same
/// pixels as the model with these corners.
#[test]
fn triangles_in_perspective_cover_what_the_model_covers() {
    cases(128, |random| {
        let positions = list(random, 3..16, |random| {
            let ranges = [
                -6 * METER..6 * METER,
                -5 * METER..5 * METER,
                -6 * METER..6 * METER,
            ];
            Vec3::from_bits(within(random, ranges))
        });
        let turn = Angle::from_bits(random.random());
        let size = (48, 32);
        let projection =
            Projection::perspective(Angle::from_degrees(70), size, fx!(0.5), fx!(60)).unwrap();
        let mvp = projection * Transform::translate(vec3!(0, 0, -8)) * Transform::rotate_y(turn);
        let mut counter = Counter::new(size);
        let count = u16::try_from(positions.len()).unwrap();
        let faces: Vec<[u16; 3]> = (0..count)
            .map(|i| [i, (i + 1) % count, (i + 2) % count])
            .collect();
        let mut places = Vec::new();
        for &position in &positions {
            places.push(counter.snapped(&mvp, position));
        }
        let place = |index: u16| places[usize::from(index)];
        // Clipped triangles have new corners. Other tests check them.
        let whole: Vec<[u16; 3]> = faces
            .into_iter()
            .filter(|face| face.iter().all(|&index| place(index).is_some()))
            .collect();
        let triangles: Vec<Snapped> = whole
            .iter()
            .map(|face| face.map(|i| place(i).unwrap()))
            .collect();
        let mesh = Mesh::new(&positions, &whole).unwrap();
        for cull in [Cull::Nothing, Cull::Back, Cull::Front] {
            let drawn = counter.draw(&DrawOptions::new().with_cull(cull), &mesh, &mvp);
            assert_eq!(drawn.clipped, 0);
            let kept: Vec<Snapped> = triangles
                .iter()
                .copied()
                .filter(|&t| match cull {
                    Cull::Nothing => true,
                    Cull::Back => area2(t) < 0,
                    Cull::Front => area2(t) > 0,
                })
                .collect();
            assert_eq!(
                coverage::picture(&counter.take(), size.0),
                coverage::picture(&coverage::counts(&kept, size.0, size.1), size.0)
            );
        }
    });
}

/// Beyond the guard band, triangles are clipped and get new corners. Rounding moves the new corners by up to 1/512
/// pixel along each axis, so it moves a point of an edge by at most √2/512 = 0.0028 pixel. With the rounding of clip
/// space (a fraction of 2⁻³¹ of an edge of at most 65,536 pixels: 3e-5 pixel), the point moves by less than 1/256
/// pixel. So pixels can differ from the exact model only if their centers are within 1/256 pixel of an edge.
#[test]
fn triangles_beyond_the_guard_band_cover_what_the_model_covers() {
    cases(192, |random| {
        let corners: [Point; 3] = from_fn(|_| {
            if random.random_ratio(3, 4) {
                from_fn(|_| random.random_range(-32_000..32_000) * 256)
            } else {
                within(random, [-1000..9000, -1000..7000])
            }
        });
        let mut counter = Counter::new(SIZE);
        let positions = corners.map(at_subpixel);
        counter.draw(
            &BOTH_SIDES,
            &Mesh::new(&positions, &[[0, 1, 2]]).unwrap(),
            &pixel_projection(SIZE),
        );
        let drawn = counter.take();
        for (count, pixel) in drawn.into_iter().zip(Bounds::new(SIZE.0, SIZE.1).pixels()) {
            let model = u32::from(coverage::covers(corners, pixel));
            if count != model {
                let [a, b, c] = corners.map(unsnap);
                let near = [(a, b), (b, c), (c, a)]
                    .into_iter()
                    .map(|(a, b)| to_segment(a, b, center(pixel)))
                    .fold(f64::MAX, f64::min);
                assert!(
                    count < 2 && near < 1. / 256.,
                    "{pixel:?}: drawn {count}, model {model}, {near} from an edge"
                );
            }
        }
    });
}

/// A mesh that reaches far beyond the guard band on all sides covers each pixel of the picture once.
#[test]
fn clipped_triangulations_cover_each_pixel_once() {
    cases(192, |random| {
        const EDGE: i32 = 32_000 * 256;
        let corners = [[-EDGE, -EDGE], [-EDGE, EDGE], [EDGE, EDGE], [EDGE, -EDGE]];
        let mut points = list(random, 0..8, |random| {
            from_fn(|_| random.random_range(-31_000..31_000) * 256)
        });
        points.extend(places(random, -4..36));
        let mesh = triangulation(corners, &points).shuffled(random.random(), false);
        let mut counter = Counter::new(SIZE);
        let positions: Vec<Vec3> = mesh.points.iter().copied().map(at_subpixel).collect();
        let drawn = counter.draw(
            &DrawOptions::new(),
            &Mesh::new(&positions, &mesh.faces).unwrap(),
            &pixel_projection(SIZE),
        );
        assert!(drawn.clipped > 0, "{mesh:?}");
        let picture = counter.picture();
        assert!(
            picture.iter().all(|row| row.chars().all(|c| c == '1')),
            "{picture:#?}"
        );
    });
}
