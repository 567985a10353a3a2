//! Clipping in homogeneous coordinates.

use heapless::Vec;

use super::vertex::{ClipPosition, Projector};
use crate::mesh::Index;
use crate::num::block::BlockFloat;
use crate::num::wide::product;
use crate::raster::{Barycentric, ClippedVertex, ScreenVertex};
use crate::view::ProjectionKind;

/// The most corners that a clipped triangle may have: three, and at most one more for each of six planes.
const MOST_CORNERS: usize = 9;

/// A clipped triangle or line on the screen.
pub(crate) type ClippedPolygon = Vec<ClippedVertex, MOST_CORNERS>;

/// A corner of a triangle or line while it is clipped.
#[derive(Clone, Copy)]
struct ClipVertex {
    position: ClipPosition,
    barycentric: Barycentric,
}

type ClipPolygon = Vec<ClipVertex, MOST_CORNERS>;

/// Clips a line between two positions, or a triangle of three positions, to the inside of the planes in `outcode`. This
/// mask has a bit for each plane outside of which a corner lies. Adds the corners of the result to `clipped`: no corner
/// if nothing is inside. (With an out-parameter, 220 bytes need not be copied, and the routine that would copy them is
/// not linked.)
///
/// An edge is cut only by planes outside of which one of its own ends lies, in the order of the planes, and from its
/// inside end. So two triangles that share an edge get the same new corners.
#[inline(never)]
pub(crate) fn clip<K: ProjectionKind>(
    projector: &Projector<'_, K>,
    corners: &[Index],
    outcode: u8,
    clipped: &mut ClippedPolygon,
) {
    let (mut polygon, mut inside) = (&mut ClipPolygon::new(), &mut ClipPolygon::new());
    for (&index, &barycentric) in corners.iter().zip(&Barycentric::CORNERS) {
        let position = projector.clip_position(index);
        add(
            polygon,
            &ClipVertex {
                position,
                barycentric,
            },
        );
    }
    let mut rest = outcode;
    while rest != 0 {
        let plane = rest.trailing_zeros();
        rest &= rest - 1;
        inside.clear();
        clip_to_plane(projector, plane, polygon, inside);
        (polygon, inside) = (inside, polygon);
    }
    for corner in polygon {
        let mut vertex = ScreenVertex::UNSET;
        projector.project(0, Some(&corner.position), &mut vertex);
        let _ = clipped.push(ClippedVertex {
            vertex,
            barycentric: corner.barycentric,
        });
    }
}

/// Clips a polygon or a line by a plane, and writes the part that is inside to `inside`.
#[inline(never)]
fn clip_to_plane<K: ProjectionKind>(
    projector: &Projector<'_, K>,
    plane: u32,
    polygon: &[ClipVertex],
    inside: &mut ClipPolygon,
) {
    let is_outside = |corner: &ClipVertex| projector.is_outside(&corner.position, plane);
    // A polygon's last corner is joined to its first. Two corners are a line, or the rest of a polygon without area:
    // neither needs this edge.
    let mut from = polygon.last().filter(|_| polygon.len() > 2);
    let mut was_out = from.is_some_and(is_outside);
    for to in polygon {
        let is_out = is_outside(to);
        if let Some(from) = from.filter(|_| is_out != was_out) {
            let (inner, outer) = if is_out { (from, to) } else { (to, from) };
            add(inside, inner);
            if let Some(corner) = inside.last_mut() {
                cut(projector, plane, outer, corner);
            }
        }
        if !is_out {
            add(inside, to);
        }
        (from, was_out) = (Some(to), is_out);
    }
}

/// Adds a corner. There is always room, because a plane cuts the outline of a convex polygon twice.
#[inline(never)]
fn add(polygon: &mut ClipPolygon, corner: &ClipVertex) {
    let _ = polygon.push(*corner);
}

/// Moves a corner that is inside a plane along an edge, until it is where the plane cuts the edge.
///
/// ```text
///  inside          plane          outside
///    ●───── inner ───┼─── outer ─────○
/// ```
#[inline(never)]
fn cut<K: ProjectionKind>(
    projector: &Projector<'_, K>,
    plane: u32,
    outside: &ClipVertex,
    corner: &mut ClipVertex,
) {
    let distance = |end: &ClipVertex| projector.distance(&end.position, plane);
    let fraction = fraction(distance(corner), distance(outside));
    for (at, to) in corner.position.iter_mut().zip(&outside.position) {
        // Both coordinates are below 2^62.
        let difference = to.wrapping_sub(*at);
        // Multiplies `difference` by the fraction, one half of `difference` after the other. The product is below 2^63,
        // because the fraction is below 2^31 (which stands for 1).
        let (high, low) = ((difference >> 32) as i32, difference.cast_unsigned() as u32);
        let low = u64::from(low) * u64::from(fraction.cast_unsigned());
        *at += (product(high, fraction) << 1) + (low >> 31).cast_signed();
    }
    projector.put_onto(&mut corner.position, plane);
    let (Barycentric(weights), Barycentric(to)) = (&mut corner.barycentric, &outside.barycentric);
    for (at, to) in weights.iter_mut().zip(to) {
        // Weights are from 0 to 2^30, and the fraction is below 2^31.
        *at += (product(to - *at, fraction) >> 31) as i32;
    }
}

/// Where a plane cuts an edge: a fraction of the way from the inner end to the outer end, in units of 2^-31. `inner`
/// and `outer` are the distances of the ends from the plane.
#[inline(never)]
fn fraction(inner: i64, outer: i64) -> i32 {
    // The inner end may lie a few units outside a side plane.
    let (inner, outer) = (inner.max(0) >> 1, outer.abs() >> 1);
    let fraction = BlockFloat::new(inner, 0).over(BlockFloat::new(inner + outer, 0));
    fraction.at(31).min((1 << 31) - 1) as i32
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fixtures::picture::Picture;
    use crate::math::{Transform, Vec3};
    use crate::mesh::Indices;
    use crate::random::{cases, within};
    use crate::raster::{Cull, area};
    use crate::view::{Parallel, Perspective, Projection, Viewport, Window};
    use crate::{Mesh, Scalar, deg, fx};
    use rand::Rng;

    /// Clips a triangle with corners in pixels and depths. Depths from -1 to 1 are inside.
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
        let outcodes = [0, 1, 2].map(|index| {
            let mut vertex = ScreenVertex::UNSET;
            projector.project(index, None, &mut vertex);
            vertex.outcode
        });
        let mut clipped = ClippedPolygon::new();
        let outcode = outcodes[0] | outcodes[1] | outcodes[2];
        clip(&projector, &[0, 1, 2], outcode, &mut clipped);
        clipped
    }

    /// Depth rises by a quarter for each column, so columns 2 to 9 are between the near and the far plane.
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
                let depth = fx!(0.25) * (x - 6);
                [fx!(1) * x, fx!(1) * y, depth]
            });
            let polygon = clip_triangle(corners);
            assert_eq!(polygon.len(), count);
            let mut picture = Picture::new(12, 8);
            let scissor = picture.scissor();
            picture.draw(&scissor, |raster| {
                raster.draw_clipped(Indices::of_point(0), &polygon, Cull::Nothing);
            });
            picture.assert(&expected);
        }
    }

    /// Each corner is beyond one side of the guard band, or a corner is beyond two sides.
    #[test]
    fn six_and_seven_corners_at_the_guard_band() {
        // `exact` is twice the area after exact clipping, in pixels.
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
            let corners = corners.map(|[x, y]| [fx!(1) * x, fx!(1) * y, fx!(0)]);
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
            // The tolerance is twice the area of a strip: half of 1/256 pixel wide, and as long as an outline of up to
            // 16,000 pixels.
            assert!((found - exact).abs() < 64., "{found} is not {exact}");
        }
    }

    /// Two triangles on both sides of an edge walk it in opposite directions. The edge reaches from a few units ahead of
    /// the eye to anywhere. Its new corners have the same bits in both triangles.
    #[test]
    fn a_shared_edge_has_the_same_corners_in_both_triangles() {
        let projection = Projection::perspective(deg!(90), (1, 1), fx!(1), fx!(10_000)).unwrap();
        let viewport = Viewport::new(0, 0, 64, 64).unwrap();
        let view = Transform::IDENTITY;
        let mut cuts = 0;
        cases(1_000, |random| {
            let inside = within(
                random,
                [-1 << 16..1 << 16, -1 << 16..1 << 16, -4 << 16..-2 << 16],
            );
            let [outside, c, d] = [(); 3].map(|()| Vec3::from_bits(random.random()));
            let positions = [Vec3::from_bits(inside), outside, c, d];
            let mesh = Mesh::new(&positions, &[]).unwrap();
            let projector =
                Projector::<Perspective>::new(mesh.positions(), &projection, &view, &viewport);
            let outcodes = [0, 1, 2, 3].map(|index| {
                let mut vertex = ScreenVertex::UNSET;
                projector.project(index, None, &mut vertex);
                vertex.outcode
            });
            let [first, second] = [[0, 1, 2], [1, 0, 3]].map(|corners: [Index; 3]| {
                let outcode = corners
                    .iter()
                    .fold(0, |all, &at| all | outcodes[usize::from(at)]);
                let mut clipped = ClippedPolygon::new();
                clip(&projector, &corners, outcode, &mut clipped);
                // On the shared edge, the third corner has no weight.
                let shared = clipped.iter().filter(|corner| corner.barycentric.0[1] == 0);
                let mut bits: std::vec::Vec<_> = shared
                    .map(|ClippedVertex { vertex, .. }| (vertex.screen, vertex.q, vertex.exponent))
                    .collect();
                bits.sort_unstable();
                bits
            });
            assert_eq!(first, second, "{positions:?}");
            assert_eq!(first.len(), 2);
            cuts += usize::from(outcodes[1] != 0);
        });
        assert!(cuts > 500, "{cuts}");
    }

    #[test]
    fn triangles_outside_the_view_volume_are_clipped_away() {
        // One triangle is in front of the near plane. Each point of the other triangle is beyond a side of the guard
        // band.
        let near = [[1, 1, 2], [5, 1, 3], [1, 5, 2]];
        let corner = [[-2100, 2000, 0], [-2100, 4000, 0], [-1000, 3100, 0]];
        for corners in [near, corner] {
            let corners = corners.map(|corner| corner.map(|x| Scalar::try_from(x).unwrap()));
            assert!(clip_triangle(corners).is_empty());
        }
    }
}
