//! The surfaces of the shapes; most are bent grids.

use super::Shape;
use super::writer::{MeshWriter, ONE};
use crate::math::Vec3;
use crate::num::{Angle, Scalar, TexCoord};

const ZERO: TexCoord = TexCoord::ZERO;
const UNIT: TexCoord = TexCoord::ONE;

/// The angle `part` / `parts` of a turn, or of half a turn if `half` is true. A whole turn becomes 0, so that positions
/// on both sides of a seam are equal, bit for bit.
const fn angle(part: u32, parts: u32, half: bool) -> Angle {
    let bits = ((part as u64) << (32 - half as u32)) / parts as u64;
    // The cast drops a whole turn.
    Angle::from_bits(bits as u32)
}

/// The sine and the cosine, in units of 2⁻³⁰.
const fn sin_cos(angle: Angle) -> (i64, i64) {
    (angle.sin().to_bits() as i64, angle.cos().to_bits() as i64)
}

/// `part` / `parts` with `fraction` fraction bits, rounded to nearest.
const fn nearest(part: u32, parts: u32, fraction: u32) -> i32 {
    // `part` is at most `parts`, so the result is at most 1 and fits.
    (((part as u64) << (fraction + 1)) / parts as u64).div_ceil(2) as i32
}

/// The nearest `TexCoord` to `part` / `parts`.
const fn ratio(part: u32, parts: u32) -> TexCoord {
    TexCoord::from_bits(nearest(part, parts, TexCoord::FRAC_BITS))
}

/// Maps `part` / `parts` from 0..1 to −1..1, rounded to the nearest `Scalar`.
const fn across(part: u32, parts: u32) -> Scalar {
    Scalar::from_bits(2 * nearest(part, parts, Scalar::FRAC_BITS) - Scalar::ONE.to_bits())
}

/// The surface to which the grid of a shape is bent.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Surface {
    /// A box, which is not a grid: six sides between this corner and the opposite corner.
    Cuboid(Vec3),
    Sphere,
    /// A tube of this radius.
    Torus(Scalar),
    Plane,
    Cylinder,
}

/// A row of vertices around the y axis. Returns the row's radius in units of 2⁻³⁰, its height in units of 2⁻⁶⁰, and the
/// two components of its normals away from the axis and along the axis, in units of 2⁻³⁰.
const fn ring(shape: Shape, row: u32) -> (i64, i64, i64, i64) {
    match shape.surface {
        Surface::Torus(tube) => {
            let tube = tube.to_bits() as i64;
            // Rows begin on the inside of the tube, and continue over the top to the outside.
            let (up, inwards) = sin_cos(angle(row, shape.rows, false));
            let radius = ONE - ((tube * inwards) >> 16);
            (radius, (tube * up) << 14, -inwards, up)
        }
        Surface::Cylinder if row == 0 => (ONE, ONE * ONE, ONE, 0),
        Surface::Cylinder => (ONE, -ONE * ONE, ONE, 0),
        _ => {
            let (radius, y) = sin_cos(angle(row, shape.rows, true));
            (radius, y * ONE, radius, y)
        }
    }
}

/// Writes the elements of a shape.
pub(super) const fn write(writer: &mut MeshWriter<'_>, shape: Shape) {
    if let Surface::Cuboid(corner) = shape.surface {
        cuboid(writer, corner);
        return;
    }
    let Shape { columns, rows, .. } = shape;
    // The sine, the cosine and u of a vertex depend on the column alone. To compute these numbers for every vertex
    // would take half of the time, so they are computed once. Until the last row is written, the positions of that row
    // store these numbers.
    let last = rows * (columns + 1);
    let mut column = 0;
    while column <= columns {
        let (sin, cos) = sin_cos(angle(column, columns, false));
        writer.keep(
            last + column,
            [sin as i32, cos as i32, ratio(column, columns).to_bits()],
        );
        column += 1;
    }
    let mut row = 0;
    while row <= rows {
        let (radius, y, out, up) = ring(shape, row);
        let is_pole = matches!(shape.surface, Surface::Sphere) && (row == 0 || row == rows);
        let v = ratio(row, rows);
        let mut column = 0;
        while column <= columns {
            let [sin, cos, u] = writer.kept(last + column);
            // At a pole, u is halfway between the u of the triangle's two other corners.
            let u = if is_pole && column < columns {
                ratio(2 * column + 1, 2 * columns)
            } else {
                TexCoord::from_bits(u)
            };
            if let Surface::Plane = shape.surface {
                let place = Vec3::new(across(column, columns), Scalar::ZERO, across(row, rows));
                writer.place(place, Vec3::Y, [u, v]);
            } else {
                let (sin, cos) = (sin as i64, cos as i64);
                let position = [radius * sin, y, radius * cos];
                let normal = [out * sin, up * ONE, out * cos];
                writer.vertex(position, normal, [u, v]);
            }
            column += 1;
        }
        row += 1;
    }
    write_grid(writer, shape);
    if let Surface::Cylinder = shape.surface {
        cap(writer, columns, ONE);
        cap(writer, columns, -ONE);
    }
}

/// Writes the triangles and edges between the vertices of a shape's grid, which are numbered row by row from 0. Seen
/// from outside, columns run to the right and rows run down.
const fn write_grid(writer: &mut MeshWriter<'_>, shape: Shape) {
    let Shape {
        surface,
        columns,
        rows,
    } = shape;
    // In a sphere, all vertices of the first row are at one point, and so are all vertices of the last row.
    let poles = matches!(surface, Surface::Sphere);
    // Edges run along the rows of vertices from `along[0]` to before `along[1]`, and down the first `across` columns of
    // vertices.
    let along = match surface {
        Surface::Sphere => [1, rows],
        Surface::Torus(_) => [0, rows],
        _ => [0, rows + 1],
    };
    let across = columns + matches!(surface, Surface::Plane) as u32;
    let mut row = 0;
    while row <= rows {
        let mut column = 0;
        while column <= columns {
            let a = row * (columns + 1) + column;
            let (b, c, d) = (a + 1, a + columns + 1, a + columns + 2);
            let inside = column < columns;
            if inside && row >= along[0] && row < along[1] {
                writer.edge([a, b]);
            }
            if row < rows && column < across {
                writer.edge([a, c]);
            }
            if inside && row < rows {
                // At a pole, a quad is a single triangle. The corner at the pole lies between the two other corners.
                if poles && row + 1 == rows {
                    writer.triangle([a, c, b]);
                } else {
                    writer.triangle([a, c, d]);
                    if !poles || row > 0 {
                        writer.triangle([a, d, b]);
                    }
                }
            }
            column += 1;
        }
        row += 1;
    }
}

/// Closes a cylinder at `y` with a fan of triangles.
const fn cap(writer: &mut MeshWriter<'_>, slices: u32, y: i64) {
    let center = writer.positions;
    let half = TexCoord::from_bits(UNIT.to_bits() / 2);
    let normal = [0, ONE * y, 0];
    writer.vertex(normal, normal, [half, half]);
    let mut slice = 0;
    while slice < slices {
        let (sin, cos) = sin_cos(angle(slice, slices, false));
        // The cap shows a disc of the texture. v grows toward +z on the upper cap, and toward −z on the lower cap.
        let down = if y > 0 { cos } else { -cos };
        let position = [ONE * sin, ONE * y, ONE * cos];
        writer.vertex(position, normal, [texture(sin), texture(down)]);
        let (this, next) = (center + 1 + slice, center + 1 + (slice + 1) % slices);
        if y > 0 {
            writer.triangle([center, this, next]);
        } else {
            writer.triangle([center, next, this]);
        }
        slice += 1;
    }
}

/// Maps −1..1 in units of 2⁻³⁰ to 0..1.
const fn texture(unit: i64) -> TexCoord {
    // (`unit` + 1) / 2, rounded from units of 2⁻³⁰ to units of 2⁻²⁰; at most 1.
    TexCoord::from_bits(((unit + ONE + (1 << 10)) >> 11) as i32)
}

const fn cuboid(writer: &mut MeshWriter<'_>, corner: Vec3) {
    /// For each side, as seen from outside: the direction of its normal, the direction to the right, and the direction
    /// down. A direction is the number of an axis, and `true` if it points along the axis or `false` if it points
    /// against the axis.
    const SIDES: [[(usize, bool); 3]; 6] = [
        [(2, true), (0, true), (1, false)],
        [(0, true), (2, false), (1, false)],
        [(2, false), (0, false), (1, false)],
        [(0, false), (2, true), (1, false)],
        [(1, true), (0, true), (2, true)],
        [(1, false), (0, true), (2, false)],
    ];
    let corner = corner.to_bits();
    let mut side = 0;
    while side < SIDES.len() {
        let [out, right, down] = SIDES[side];
        let a = writer.positions;
        let mut normal = [0; 3];
        normal[out.0] = if out.1 { 1 << 16 } else { -(1 << 16) };
        let mut vertex = 0;
        while vertex < 4 {
            let (u, v) = (vertex % 2 == 1, vertex / 2 == 1);
            let mut position = corner;
            if !out.1 {
                position[out.0] = -position[out.0];
            }
            if u != right.1 {
                position[right.0] = -position[right.0];
            }
            if v != down.1 {
                position[down.0] = -position[down.0];
            }
            let uv = [if u { UNIT } else { ZERO }, if v { UNIT } else { ZERO }];
            writer.place(Vec3::from_bits(position), Vec3::from_bits(normal), uv);
            vertex += 1;
        }
        let (b, c, d) = (a + 1, a + 2, a + 3);
        writer.triangle([a, c, d]);
        writer.triangle([a, d, b]);
        // Each of the four upright sides writes one upright edge; the top and the bottom write four edges each.
        writer.edge([a, c]);
        if out.0 == 1 {
            writer.edge([b, d]);
            writer.edge([a, b]);
            writer.edge([c, d]);
        }
        side += 1;
    }
}
