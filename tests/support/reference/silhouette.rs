//! Finds whether a point of the screen is inside, outside or near the outline of a union of triangles.
//!
//! The union's outline is exact, up to the rounding of f64. The outline consists of parts of the *contour* edges. With
//! each triangle on the left of its own edges, an edge is a contour edge if its opposite edge (same two ends, other
//! direction) belongs to no triangle. Every other edge has triangles on both sides, so it does not bound the union. For
//! the front faces of a closed mesh, contour edges lie between a front face and a back face, or on the near plane. A
//! contour edge bounds the union only where no other triangle lies across it, so only this part of the edge belongs to
//! the outline. (Elsewhere, the front of the mesh can hide the edge, or the back of a fold can lie under it.)
//!
//! Edges are compared by the bits of their ends, so vertices that two triangles share must have the same bits. An inner
//! edge without an exact opposite edge, for example at a T-junction, takes time but does not change the result.

use std::collections::HashSet;

use super::coverage::{Corners, area2_f64};
use super::distance::{to_segment, to_triangle};

/// The largest supported distance, in pixels. A tile lists the triangles within this distance of the tile.
pub const REACH: f64 = 1.;

/// The side of a tile, in pixels.
const TILE: usize = 8;
/// The distance from an edge, in pixels, at which the code looks for another triangle across the edge. Rounding can
/// move a point of the union out of every triangle by at most the same distance. This distance is far above the
/// rounding of f64 at coordinates of thousands (1e-12), and far below any visible distance.
const ACROSS: f64 = 1e-9;
/// If a gap between the triangles across an edge is shorter than this, in pixels, rounding has caused the gap.
const HOLE: f64 = 1e-7;

/// The position of a point relative to the union.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Position {
    /// Inside the union, and farther from the outline than the given distance.
    Inside,
    /// Outside the union, and farther from the outline than the given distance.
    Outside,
    /// Within the given distance of the outline.
    Near,
}

/// The union of a set of triangles, within a picture.
#[derive(Clone, Debug)]
pub struct Silhouette {
    triangles: Vec<Corners>,
    /// Contour edges. The triangle of an edge lies on the side where `area2_f64(a, b, p)` is positive.
    contour: Vec<[[f64; 2]; 2]>,
    tiles: Vec<Tile>,
    columns: usize,
    rows: usize,
}

#[derive(Clone, Debug, Default)]
struct Tile {
    triangles: Vec<usize>,
    contour: Vec<usize>,
}

impl Silhouette {
    /// The union of triangles of either winding in a picture of width x height. Corners are in pixels. Triangles
    /// without area add nothing.
    pub fn new(triangles: &[Corners], width: u32, height: u32) -> Self {
        let triangles: Vec<Corners> = triangles
            .iter()
            .filter_map(|t| {
                // −0 and 0 are the same position.
                let [a, b, c] = t.map(|corner| corner.map(|x| x + 0.));
                match area2_f64(&[a, b, c]) {
                    area if area > 0. => Some([a, b, c]),
                    area if area < 0. => Some([a, c, b]),
                    _ => None,
                }
            })
            .collect();
        let bits = |edge: [[f64; 2]; 2]| edge.map(|end| end.map(f64::to_bits));
        let sides = |[a, b, c]: &Corners| [[*a, *b], [*b, *c], [*c, *a]];
        let all: HashSet<_> = triangles.iter().flat_map(sides).map(bits).collect();
        let contour: Vec<_> = triangles
            .iter()
            .flat_map(sides)
            .filter(|&[a, b]| !all.contains(&bits([b, a])))
            .collect();

        let columns = (width as usize).div_ceil(TILE).max(1);
        let rows = (height as usize).div_ceil(TILE).max(1);
        let mut tiles = vec![Tile::default(); columns * rows];
        for (i, triangle) in triangles.iter().enumerate() {
            for tile in tiles_around(triangle, columns, rows) {
                tiles[tile].triangles.push(i);
            }
        }
        for (i, edge) in contour.iter().enumerate() {
            for tile in tiles_around(edge, columns, rows) {
                tiles[tile].contour.push(i);
            }
        }
        Self {
            triangles,
            contour,
            tiles,
            columns,
            rows,
        }
    }

    /// Classifies a point of the picture. The point is near the outline if the outline is within `d` pixels.
    ///
    /// # Panics
    ///
    /// If `d` is over [`REACH`] or the point is outside the picture.
    pub fn classify(&self, p: [f64; 2], d: f64) -> Position {
        let tile = self.tile(p, d);
        let distance = tile
            .triangles
            .iter()
            .map(|&i| to_triangle(&self.triangles[i], p))
            .fold(f64::MAX, f64::min);
        if distance > d {
            Position::Outside
        } else if distance > ACROSS
            || self
                .contour_near(tile, p, d)
                .any(|e| self.exposed(tile, e, p, d))
        {
            Position::Near
        } else {
            Position::Inside
        }
    }

    /// Whether a contour edge passes within `d` pixels, even if it is not part of the outline.
    ///
    /// A surface ends at a contour edge, so the rounding of its vertices can show the surface behind it.
    ///
    /// # Panics
    ///
    /// If `d` is over [`REACH`] or the point is outside the picture.
    pub fn contour_within(&self, p: [f64; 2], d: f64) -> bool {
        self.contour_near(self.tile(p, d), p, d).next().is_some()
    }

    fn tile(&self, p: [f64; 2], d: f64) -> &Tile {
        assert!(d <= REACH, "{d} is over {REACH} pixel");
        let index = |x: f64, count: usize| {
            assert!(
                x >= 0. && x <= (count * TILE) as f64,
                "{p:?} is outside the picture"
            );
            (x as usize / TILE).min(count - 1)
        };
        &self.tiles[index(p[1], self.rows) * self.columns + index(p[0], self.columns)]
    }

    fn contour_near<'a>(
        &'a self,
        tile: &'a Tile,
        p: [f64; 2],
        d: f64,
    ) -> impl Iterator<Item = [[f64; 2]; 2]> + 'a {
        let edges = tile.contour.iter().map(|&i| self.contour[i]);
        edges.filter(move |&[a, b]| to_segment(a, b, p) <= d)
    }

    /// Whether any part of an edge within `d` of `p` has no triangle across it.
    fn exposed(&self, tile: &Tile, [a, b]: [[f64; 2]; 2], p: [f64; 2], d: f64) -> bool {
        let along = [b[0] - a[0], b[1] - a[1]];
        let length = along[0].hypot(along[1]);
        let unit = along.map(|x| x / length);
        // The part of the edge within `d` of `p`, as two lengths along the edge.
        let to = [p[0] - a[0], p[1] - a[1]];
        let foot = to[0] * unit[0] + to[1] * unit[1];
        let aside = to[0] * unit[1] - to[1] * unit[0];
        let half = (d * d - aside * aside).max(0.).sqrt();
        let (start, end) = ((foot - half).max(0.), (foot + half).min(length));

        let across = [a[0] + unit[1] * ACROSS, a[1] - unit[0] * ACROSS];
        let mut covered: Vec<_> = tile
            .triangles
            .iter()
            .filter_map(|&i| inside(&self.triangles[i], across, unit, start, end))
            .collect();
        covered.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut at = start;
        for (from, to) in covered {
            if from - at > HOLE {
                return true;
            }
            at = at.max(to);
        }
        end - at > HOLE
    }
}

/// The part of a line that is inside a triangle of positive area. The line runs from the length `start` to the length
/// `end`.
fn inside(
    [a, b, c]: &Corners,
    origin: [f64; 2],
    unit: [f64; 2],
    mut start: f64,
    mut end: f64,
) -> Option<(f64, f64)> {
    for (from, to) in [(a, b), (b, c), (c, a)] {
        let side = [to[0] - from[0], to[1] - from[1]];
        let length = side[0].hypot(side[1]);
        // At the length t along the line, the point is inside this side by the distance height + t · slope.
        let height = (side[0] * (origin[1] - from[1]) - side[1] * (origin[0] - from[0])) / length;
        let slope = (side[0] * unit[1] - side[1] * unit[0]) / length;
        // The line is parallel to the side, up to rounding, so the whole line is on one of its sides.
        if slope.abs() < 1e-14 {
            if height < 0. {
                return None;
            }
        } else if slope > 0. {
            start = start.max(-height / slope);
        } else {
            end = end.min(-height / slope);
        }
    }
    (start < end).then_some((start, end))
}

/// The tiles with pixels that can be within [`REACH`] of the bounding box of `points`.
fn tiles_around(points: &[[f64; 2]], columns: usize, rows: usize) -> Vec<usize> {
    let range = |axis: usize, count: usize| {
        let low = points.iter().map(|p| p[axis]).fold(f64::MAX, f64::min) - REACH;
        let high = points.iter().map(|p| p[axis]).fold(f64::MIN, f64::max) + REACH;
        let index = |x: f64| ((x / TILE as f64).floor() as i64).clamp(-1, count as i64);
        index(low).max(0) as usize..(index(high) + 1).clamp(0, count as i64) as usize
    };
    let across = range(0, columns);
    range(1, rows)
        .flat_map(|row| across.clone().map(move |column| row * columns + column))
        .collect()
}
