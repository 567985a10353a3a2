//! The surfaces of the shapes, mostly grids bent round.

use super::writer::{MeshWriter, ONE, Vertex};
use crate::{Angle, Scalar, TexCoord, Vec3};

const ZERO: TexCoord = TexCoord::ZERO;
const UNIT: TexCoord = TexCoord::ONE;

/// The `part`th of `parts` of a turn, and of half a turn if `half`; whole turns are none, so that
/// a seam closes to the last bit.
const fn angle(part: u32, parts: u32, half: bool) -> Angle {
    let bits = ((part as u64) << (32 - half as u32)) / parts as u64;
    // Whole turns drop out.
    Angle::from_bits(bits as u32)
}

/// Sine and cosine in 2⁻³⁰.
const fn sin_cos(angle: Angle) -> (i64, i64) {
    (angle.sin().to_bits() as i64, angle.cos().to_bits() as i64)
}

/// `part` / `parts` to the nearest with so many fraction bits.
const fn nearest(part: u32, parts: u32, fraction: u32) -> i32 {
    // At most one.
    (((part as u64) << (fraction + 1)) / parts as u64).div_ceil(2) as i32
}

/// The nearest `TexCoord` to `part` / `parts`.
const fn ratio(part: u32, parts: u32) -> TexCoord {
    TexCoord::from_bits(nearest(part, parts, TexCoord::FRAC_NBITS))
}

/// The nearest `Scalar` to where 0..1 becomes −1..1.
const fn across(part: u32, parts: u32) -> Scalar {
    Scalar::from_bits(2 * nearest(part, parts, Scalar::FRAC_NBITS) - Scalar::ONE.to_bits())
}

/// Which edges and triangles of a grid to draw.
struct Grid {
    columns: u32,
    rows: u32,
    /// Whether the first and the last row of vertices are one point each.
    poles: bool,
    /// Rows of vertices with edges along them, from and to before.
    along: [u32; 2],
    /// Columns of vertices with edges along them.
    across: u32,
}

/// Triangles and edges of the vertices that were written last, row by row: columns to the right
/// and rows down as seen from outside.
const fn weave(writer: &mut MeshWriter<'_>, first: u32, grid: &Grid) {
    let width = grid.columns + 1;
    let mut row = 0;
    while row <= grid.rows {
        let mut column = 0;
        while column <= grid.columns {
            let a = first + row * width + column;
            let (b, c, d) = (a + 1, a + width, a + width + 1);
            let inside = column < grid.columns;
            if inside && row >= grid.along[0] && row < grid.along[1] {
                writer.edge([a, b]);
            }
            if row < grid.rows && column < grid.across {
                writer.edge([a, c]);
            }
            if inside && row < grid.rows {
                // A pole's vertices lie each between two of the next row's.
                if grid.poles && row + 1 == grid.rows {
                    writer.triangle([a, c, b]);
                } else {
                    writer.triangle([a, c, d]);
                    if !grid.poles || row > 0 {
                        writer.triangle([a, d, b]);
                    }
                }
            }
            column += 1;
        }
        row += 1;
    }
}

pub(super) const fn sphere(writer: &mut MeshWriter<'_>, slices: u32, stacks: u32) {
    let first = writer.next();
    let mut row = 0;
    while row <= stacks {
        let (radius, y) = sin_cos(angle(row, stacks, true));
        let pole = row == 0 || row == stacks;
        let mut column = 0;
        while column <= slices {
            let (sin, cos) = sin_cos(angle(column, slices, false));
            let point = [radius * sin, y * ONE, radius * cos];
            // The texture of a pole's triangle narrows to its middle.
            let u = if pole && column < slices {
                ratio(2 * column + 1, 2 * slices)
            } else {
                ratio(column, slices)
            };
            writer.vertex(&Vertex {
                position: point,
                normal: point,
                uv: [u, ratio(row, stacks)],
            });
            column += 1;
        }
        row += 1;
    }
    let grid = Grid {
        columns: slices,
        rows: stacks,
        poles: true,
        along: [1, stacks],
        across: slices,
    };
    weave(writer, first, &grid);
}

pub(super) const fn torus(writer: &mut MeshWriter<'_>, tube: Scalar, slices: u32, sides: u32) {
    let first = writer.next();
    let tube = tube.to_bits() as i64;
    let mut row = 0;
    while row <= sides {
        // From inside over the top to outside.
        let (up, inwards) = sin_cos(angle(row, sides, false));
        let radius = ONE - ((tube * inwards) >> 16);
        let mut column = 0;
        while column <= slices {
            let (sin, cos) = sin_cos(angle(column, slices, false));
            writer.vertex(&Vertex {
                position: [radius * sin, (tube * up) << 14, radius * cos],
                normal: [-inwards * sin, up * ONE, -inwards * cos],
                uv: [ratio(column, slices), ratio(row, sides)],
            });
            column += 1;
        }
        row += 1;
    }
    let grid = Grid {
        columns: slices,
        rows: sides,
        poles: false,
        along: [0, sides],
        across: slices,
    };
    weave(writer, first, &grid);
}

pub(super) const fn plane(writer: &mut MeshWriter<'_>, columns: u32, rows: u32) {
    let first = writer.next();
    let mut row = 0;
    while row <= rows {
        let mut column = 0;
        while column <= columns {
            let place = Vec3::new(across(column, columns), Scalar::ZERO, across(row, rows));
            let uv = [ratio(column, columns), ratio(row, rows)];
            writer.place(place, Vec3::Y, uv);
            column += 1;
        }
        row += 1;
    }
    let grid = Grid {
        columns,
        rows,
        poles: false,
        along: [0, rows + 1],
        across: columns + 1,
    };
    weave(writer, first, &grid);
}

pub(super) const fn cylinder(writer: &mut MeshWriter<'_>, slices: u32) {
    let first = writer.next();
    let mut row = 0;
    while row <= 1 {
        let y = if row == 0 { ONE } else { -ONE };
        let mut column = 0;
        while column <= slices {
            let (sin, cos) = sin_cos(angle(column, slices, false));
            writer.vertex(&Vertex {
                position: [ONE * sin, ONE * y, ONE * cos],
                normal: [ONE * sin, 0, ONE * cos],
                uv: [ratio(column, slices), ratio(row, 1)],
            });
            column += 1;
        }
        row += 1;
    }
    let grid = Grid {
        columns: slices,
        rows: 1,
        poles: false,
        along: [0, 2],
        across: slices,
    };
    weave(writer, first, &grid);
    cap(writer, slices, ONE);
    cap(writer, slices, -ONE);
}

/// A fan of triangles about the end of a cylinder at `y`.
const fn cap(writer: &mut MeshWriter<'_>, slices: u32, y: i64) {
    let center = writer.next();
    let half = TexCoord::from_bits(UNIT.to_bits() / 2);
    writer.vertex(&Vertex {
        position: [0, ONE * y, 0],
        normal: [0, ONE * y, 0],
        uv: [half, half],
    });
    let mut slice = 0;
    while slice < slices {
        let (sin, cos) = sin_cos(angle(slice, slices, false));
        // The disc of the texture, down being z on the upper cap and −z on the lower.
        let down = if y > 0 { cos } else { -cos };
        writer.vertex(&Vertex {
            position: [ONE * sin, ONE * y, ONE * cos],
            normal: [0, ONE * y, 0],
            uv: [texture(sin), texture(down)],
        });
        let (this, next) = (center + 1 + slice, center + 1 + (slice + 1) % slices);
        if y > 0 {
            writer.triangle([center, this, next]);
        } else {
            writer.triangle([center, next, this]);
        }
        slice += 1;
    }
}

/// −1..1 in 2⁻³⁰ to 0..1.
const fn texture(unit: i64) -> TexCoord {
    // Half of it, rounded from 2⁻³⁰ to 2⁻²⁰; at most 1.
    TexCoord::from_bits(((unit + ONE + (1 << 10)) >> 11) as i32)
}

pub(super) const fn cuboid(writer: &mut MeshWriter<'_>, corner: Vec3) {
    /// Normal, right and down of each side as seen from outside: axis and sign.
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
        let a = writer.next();
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
        // The four upright edges from the four sides, the others from top and bottom.
        writer.edge([a, c]);
        if out.0 == 1 {
            writer.edge([b, d]);
            writer.edge([a, b]);
            writer.edge([c, d]);
        }
        side += 1;
    }
}
