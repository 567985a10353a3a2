//! Exhaustive tests of coverage: every triangle on a grid.

use fixel::prelude::*;

use support::counter::{BOTH_SIDES, Counter, at_subpixel, pixel_projection};
use support::reference::coverage::covers;

/// The side of the picture, in pixels. The picture has as many pixels as a u64 has bits.
const SIDE: u32 = 8;
/// The side of the grid, in vertices.
const GRID: usize = 6;
const PLACES: usize = GRID * GRID;

type Point = [i32; 2];

/// The pixels that the crate draws for a triangle, one bit each.
fn drawn(corners: [Point; 3], counter: &mut Counter) -> u64 {
    let positions = corners.map(at_subpixel);
    let mesh = Mesh::new(&positions, &[[0, 1, 2]]).unwrap();
    counter.draw(&BOTH_SIDES, &mesh, &pixel_projection((SIDE, SIDE)));
    let mut mask = 0;
    for (i, count) in counter.take().into_iter().enumerate() {
        assert!(count < 2, "{corners:?} drawn twice at {i}");
        mask |= u64::from(count) << i;
    }
    mask
}

/// The pixels that the model covers, found with exact half-spaces at every center.
fn model(corners: [Point; 3]) -> u64 {
    let pixel = |i: u32| [(i % SIDE).cast_signed(), (i / SIDE).cast_signed()];
    (0..SIDE * SIDE)
        .filter(|&i| covers(corners, pixel(i)))
        .fold(0, |mask, i| mask | 1 << i)
}

fn turn([a, b, c]: [Point; 3]) -> i32 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// All triangles on a grid of vertices, in both windings.
struct Grid {
    places: [Point; PLACES],
    /// Pixel masks, indexed by the three corners in any order.
    masks: Vec<u64>,
}

impl Grid {
    /// Makes a grid of vertices that starts at `origin`, with steps of `cell`. `aside` gives each vertex's
    /// displacement.
    fn new(cell: i32, origin: i32, aside: impl Fn(usize) -> Point) -> Self {
        let place = |i: usize| {
            let at = [i % GRID, i / GRID].map(|at| i32::try_from(at).unwrap() * cell + origin);
            let [x, y] = aside(i);
            [at[0] + x, at[1] + y]
        };
        let places: [Point; PLACES] = std::array::from_fn(place);
        let mut masks = vec![0; PLACES * PLACES * PLACES];
        let mut counter = Counter::new((SIDE, SIDE));
        for a in 0..PLACES {
            for b in 0..PLACES {
                for c in 0..PLACES {
                    // Draw each triangle with three of the six orders of its corners. Both windings are among these
                    // orders.
                    if a < b && b < c || c < b && b < a || b < c && c < a {
                        let corners = [a, b, c].map(|i| places[i]);
                        let mask = drawn(corners, &mut counter);
                        assert_eq!(mask, model(corners), "{corners:?}");
                        for [i, j, k] in [
                            [a, b, c],
                            [b, c, a],
                            [c, a, b],
                            [c, b, a],
                            [b, a, c],
                            [a, c, b],
                        ] {
                            masks[(i * PLACES + j) * PLACES + k] = mask;
                        }
                    }
                }
            }
        }
        Self { places, masks }
    }

    fn mask(&self, [a, b, c]: [usize; 3]) -> u64 {
        self.masks[(a * PLACES + b) * PLACES + c]
    }

    fn side(&self, [a, b, c]: [usize; 3]) -> i32 {
        turn([self.places[a], self.places[b], self.places[c]]).signum()
    }

    /// Two triangles on opposite sides of an edge share no pixel, wherever their third corners are.
    fn edges_are_owned_once(&self) {
        for a in 0..PLACES {
            for b in 0..a {
                let (mut left, mut right) = (0, 0);
                for c in 0..PLACES {
                    match self.side([a, b, c]) {
                        1 => left |= self.mask([a, b, c]),
                        -1 => right |= self.mask([a, b, c]),
                        _ => {}
                    }
                }
                assert_eq!(left & right, 0, "{:?}", [a, b].map(|i| self.places[i]));
            }
        }
    }

    /// Splits every triangle at every vertex inside it (into three parts) or on one of its sides (into two parts). The
    /// parts must cover each pixel of the triangle once. Returns the number of splits.
    fn parts_cover_the_whole(&self) -> usize {
        let mut splits = 0;
        for a in 0..PLACES {
            for b in 0..a {
                for c in 0..b {
                    let whole = self.side([a, b, c]);
                    if whole == 0 {
                        continue;
                    }
                    for d in 0..PLACES {
                        let parts = [[a, b, d], [b, c, d], [c, a, d]];
                        if [a, b, c].contains(&d)
                            || parts.iter().any(|&part| self.side(part) == -whole)
                        {
                            continue;
                        }
                        let [p, q, r] = parts.map(|part| self.mask(part));
                        assert_eq!(p | q | r, self.mask([a, b, c]));
                        assert_eq!((p & q) | (q & r) | (r & p), 0);
                        splits += 1;
                    }
                }
            }
        }
        splits
    }
}

/// The vertices of a grid of 6x6 lie on corners of pixels, on their centers, or anywhere. Every triangle covers the
/// same pixels as in the model. Two triangles on opposite sides of an edge share no pixel. The parts of a split
/// triangle cover the pixels of the whole triangle.
#[test]
fn every_triangle_on_a_grid_covers_what_the_model_covers() {
    let none = |_: usize| [0, 0];
    // Multiples of the index by odd factors, modulo 2^8, spread the vertices all over the pixel.
    let anywhere = |i: usize| {
        let i = i32::try_from(i).unwrap();
        [(i * 151 + 37) % 256 - 128, (i * 89 + 201) % 256 - 128]
    };
    let nearly = |i: usize| {
        let i = i32::try_from(i).unwrap();
        [i * 5 % 3 - 1, i * 7 % 3 - 1]
    };
    for grid in [
        Grid::new(256, 256, none),
        Grid::new(256, 384, none),
        Grid::new(256, 384, nearly),
        Grid::new(256, 384, anywhere),
    ] {
        grid.edges_are_owned_once();
        assert!(grid.parts_cover_the_whole() > 5000);
    }
}
