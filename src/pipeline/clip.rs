//! Clipping in homogeneous coordinates.

use heapless::Vec;

use super::vertex::{ClipPosition, Projector};
use crate::mesh::Index;
use crate::num::reciprocal;
use crate::raster::{Barycentric, ClippedVertex, ScreenVertex};
use crate::view::ProjectionKind;

/// Most corners of a clipped triangle: three, and at most one more for each of six planes.
const MOST_CORNERS: usize = 9;

/// A clipped triangle or line on the screen.
pub(crate) type ClippedPolygon = Vec<ClippedVertex, MOST_CORNERS>;

/// A corner of a triangle or line while it is clipped.
#[derive(Clone, Copy)]
struct ClipVertex {
    position: ClipPosition,
    /// [`Barycentric`] weights, as wide as the position, because they are cut in the same way.
    barycentric: [i64; 2],
}

type Polygon = Vec<ClipVertex, MOST_CORNERS>;

/// Clips a line between two positions, or a triangle of three, to the inside of `planes`. This mask has a bit for
/// each plane that any of the corners is outside of. Adds the corners of the result to `clipped`: none if nothing is
/// inside. (An out-parameter saves a copy of 220 bytes, and the routine that copies.)
///
/// An edge is cut only by the planes that its own ends are outside of, in the order of the planes, and from its
/// inside end. So two triangles that share an edge get the same new corners.
#[inline(never)]
pub(crate) fn clip<K: ProjectionKind>(
    projector: &Projector<'_, K>,
    corners: &[Index],
    planes: u8,
    clipped: &mut ClippedPolygon,
) {
    let (mut polygon, mut inside) = (&mut Polygon::new(), &mut Polygon::new());
    for (&index, weights) in corners.iter().zip(Barycentric::CORNERS) {
        let _ = polygon.push(ClipVertex {
            position: projector.clip_position(index),
            barycentric: weights.0.map(i64::from),
        });
    }
    let closed = corners.len() > 2;
    for plane in (0..6).filter(|plane| planes >> plane & 1 != 0) {
        inside.clear();
        clip_to_plane(projector, plane, (polygon, closed), inside);
        (polygon, inside) = (inside, polygon);
    }
    for corner in polygon {
        let mut vertex = ScreenVertex::UNSET;
        projector.project_inside(&corner.position, &mut vertex);
        let _ = clipped.push(ClippedVertex {
            vertex,
            // Weights are at most 2^30.
            barycentric: Barycentric(corner.barycentric.map(|weight| weight as i32)),
        });
    }
}

/// Writes to `inside` the part of a polygon that is inside a plane, or of a line if it is not `closed`.
#[inline(never)]
fn clip_to_plane<K: ProjectionKind>(
    projector: &Projector<'_, K>,
    plane: u32,
    (polygon, closed): (&[ClipVertex], bool),
    inside: &mut Polygon,
) {
    // There is room, because a plane cuts the outline of a convex polygon twice.
    let mut add = |vertex: ClipVertex| inside.push(vertex).unwrap_or(());
    // A polygon's last corner is joined to its first, a line's is not.
    let mut from = polygon.last().filter(|_| closed);
    for to in polygon {
        let to_distance = projector.distance(&to.position, plane);
        let is_out = |distance| Projector::<K>::is_outside(distance, plane);
        if let Some(from) = from {
            let from_distance = projector.distance(&from.position, plane);
            if is_out(from_distance) != is_out(to_distance) {
                let ends = [(from, from_distance), (to, to_distance)];
                add(cut(projector, plane, ends));
            }
        }
        if !is_out(to_distance) {
            add(*to);
        }
        from = Some(to);
    }
}

/// The point where `plane` cuts an edge that has one end inside and one outside. Each end comes with its distance
/// from the plane.
///
/// ```text
///  inside          plane          outside
///    ●───── inner ───┼─── outer ─────○
/// ```
fn cut<K: ProjectionKind>(
    projector: &Projector<'_, K>,
    plane: u32,
    [mut inside, mut outside]: [(&ClipVertex, i64); 2],
) -> ClipVertex {
    if inside.1 < outside.1 {
        (inside, outside) = (outside, inside);
    }
    // The fraction of the way from inside to outside, inner / (inner + outer), in units of 2^-31, rounded down.
    let (inner, outer) = (inside.1.max(0).unsigned_abs(), outside.1.unsigned_abs());
    let sum = ((inner >> 1) + (outer >> 1)) | 1;
    let up = sum.leading_zeros();
    let (part, whole) = ((inner >> 1 << up >> 33) as u32, (sum << up >> 33) as u32);
    let fraction = ((u64::from(part) * u64::from(reciprocal(whole))) >> 30)
        .min((1 << 31) - 1)
        .cast_signed();

    let (mut vertex, outside) = (*inside.0, outside.0);
    let values = vertex.position.iter_mut().chain(&mut vertex.barycentric);
    let others = outside.position.iter().chain(&outside.barycentric);
    for (from, to) in values.zip(others) {
        let difference = to.saturating_sub(*from);
        // The product of 64 bits and the fraction, from the halves of `difference`: below 2^63, because the fraction
        // is below 2^31.
        *from += (((difference >> 32) * fraction) << 1)
            + (((difference & 0xffff_ffff) * fraction) >> 31);
    }
    projector.put_onto(&mut vertex.position, plane);
    vertex
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::math::{Transform, Vec3};
    use crate::raster::Rasterizer;
    use crate::raster::picture::Picture;
    use crate::raster::{Cull, Polygon, area};
    use crate::view::{Parallel, Projection, Viewport, Window};
    use crate::{Mesh, Scalar, fx};

    /// A triangle of pixels and depths, clipped. Seen are depths from -1 to 1.
    fn clip_triangle(corners: [[Scalar; 3]; 3]) -> ClippedPolygon {
        let positions = corners.map(|[x, y, z]| Vec3::new(x, -y, z));
        let mesh = Mesh::new(&positions, &[]).unwrap();
        let window = Window {
            left: fx!(0),
            right: fx!(12),
            bottom: fx!(-8),
            top: fx!(0),
        };
        let projection = Projection::orthographic(window, fx!(-1), fx!(1)).unwrap();
        let viewport = Viewport::new(0, 0, 12, 8).unwrap();
        let projector = Projector::<Parallel>::new(
            mesh.positions(),
            &projection,
            &Transform::IDENTITY,
            &viewport,
        );
        let planes = [0, 1, 2].map(|index| {
            let mut vertex = ScreenVertex::UNSET;
            projector.project(index, &mut vertex);
            vertex.outcode
        });
        let mut clipped = ClippedPolygon::new();
        let planes = planes[0] | planes[1] | planes[2];
        clip(&projector, &[0, 1, 2], planes, &mut clipped);
        clipped
    }

    /// Depth rises by a quarter for each column, so that the near and the far plane cut columns 2 to 9 out.
    #[test]
    fn three_to_five_corners_between_near_and_far() {
        let cases = [
            (
                [[8, 1], [14, 3], [14, 7]],
                3,
                [
                    "............",
                    "........#...",
                    ".........#..",
                    "............",
                    "............",
                    "............",
                    "............",
                    "............",
                ],
            ),
            (
                [[4, 1], [14, 2], [7, 7]],
                4,
                [
                    "............",
                    "....#####...",
                    ".....#####..",
                    ".....#####..",
                    "......####..",
                    "......###...",
                    ".......#....",
                    "............",
                ],
            ),
            (
                [[-2, 2], [14, 1], [6, 8]],
                5,
                [
                    "............",
                    "......####..",
                    "..########..",
                    "..########..",
                    "..########..",
                    "...######...",
                    "....####....",
                    ".....##.....",
                ],
            ),
        ];
        for (corners, count, expected) in cases {
            let corners = corners.map(|[x, y]| {
                let depth = Scalar::from_num(x - 6) / 4;
                [Scalar::from_num(x), Scalar::from_num(y), depth]
            });
            let polygon = clip_triangle(corners);
            assert_eq!(polygon.len(), count);
            let mut picture = Picture::new(12, 8);
            let scissor = picture.scissor();
            let fan = Polygon::new(&polygon, Cull::Nothing).unwrap();
            fan.draw(&mut Rasterizer::new(&mut picture, &scissor));
            picture.assert(&expected);
        }
    }

    /// Each corner is beyond one side of the guard band, or one of them beyond two.
    #[test]
    fn six_and_seven_corners_at_the_guard_band() {
        // Twice the areas, in pixels, are those of exact clipping.
        for (corners, count, exact) in [
            ([[-3000, 0], [1000, -3000], [1000, 3000]], 6, 20_206_500.67),
            ([[-3000, 500], [3000, -500], [0, 3000]], 6, 14_338_557.49),
            (
                [[-3000, -1200], [2900, -3000], [1500, 2900]],
                7,
                25_819_565.06,
            ),
            (
                [[-2900, -2300], [2900, -900], [-900, 2900]],
                7,
                23_729_605.82,
            ),
        ] {
            let corners = corners.map(|[x, y]| [Scalar::from_num(x), Scalar::from_num(y), fx!(0)]);
            let polygon = clip_triangle(corners);
            assert_eq!(polygon.len(), count, "{corners:?}");
            let places: std::vec::Vec<_> =
                polygon.iter().map(|corner| corner.vertex.screen).collect();
            for [x, y] in &places {
                assert!(x.abs_diff(6 << 8) <= 2048 << 8 && y.abs_diff(4 << 8) <= 2048 << 8);
            }
            let triangles = places.windows(2).skip(1);
            let sum: i64 = triangles
                .map(|side| area(&[places[0], side[0], side[1]]))
                .sum();
            #[allow(clippy::cast_precision_loss)] // of 42 bits
            let found = sum as f64 / 65_536.;
            // Half of a 256th of a pixel along an outline of up to 16,000 pixels.
            assert!((found - exact).abs() < 64., "{found} is not {exact}");
        }
    }

    #[test]
    fn nothing_is_left_of_what_is_beyond() {
        // In front of the near plane; and beyond one side or another, but nowhere inside.
        let near = [[1, 1, 2], [5, 1, 3], [1, 5, 2]];
        let corner = [[-2100, 2000, 0], [-2100, 4000, 0], [-1000, 3100, 0]];
        for corners in [near, corner] {
            let corners = corners.map(|corner| corner.map(Scalar::from_num));
            assert!(clip_triangle(corners).is_empty());
        }
    }
}
