//! The visible parts of a face, as polygons on the screen.

use support::reference::coverage::area2_f64;
use support::reference::distance::{to_segment, to_triangle};
use support::reference::raster::Piece;

/// The part of a face that is nearest to a point, and its distance from the point.
pub fn nearest<'a>(
    pieces: impl Iterator<Item = &'a Piece<2>>,
    p: [f64; 2],
) -> Option<(&'a Piece<2>, f64)> {
    let gaps = pieces.map(|piece| (piece, gap(piece, p)));
    gaps.min_by(|a, b| a.1.total_cmp(&b.1))
}

/// The distance of a point from a triangle. The triangle can be as thin as a line.
pub fn gap(piece: &Piece<2>, p: [f64; 2]) -> f64 {
    // Below this area, f64 cannot tell inside from outside. A triangle of this area and a length of one pixel is
    // narrower than 10⁻⁶ pixel.
    if area2_f64(&piece.screen).abs() < 1e-6 {
        let [a, b, c] = piece.screen;
        let sides = [(a, b), (b, c), (c, a)];
        return sides
            .map(|(a, b)| to_segment(a, b, p))
            .into_iter()
            .fold(f64::MAX, f64::min);
    }
    to_triangle(&piece.screen, p)
}

/// The outer sides of a face that clipping split into triangles.
pub fn outline(face: &[Piece<2>]) -> Vec<[[f64; 2]; 2]> {
    let key = |side: [[f64; 2]; 2]| side.map(|end| end.map(f64::to_bits));
    let sides = |[a, b, c]: [[f64; 2]; 3]| [[a, b], [b, c], [c, a]];
    let all: Vec<_> = face.iter().flat_map(|piece| sides(piece.screen)).collect();
    let is_outer = |&&[a, b]: &&[[f64; 2]; 2]| !all.iter().any(|&side| key(side) == key([b, a]));
    all.iter().filter(is_outer).copied().collect()
}
