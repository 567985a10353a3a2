//! The surfaces of the shapes; most are bent grids.

use super::pen::{Corner, ONE, Pen};
use crate::{Angle, Scalar, TexCoord, Vec3};

const ZERO: TexCoord = TexCoord::ZERO;
const UNIT: TexCoord = TexCoord::ONE;

/// `part` / `parts` of a turn, or of half a turn if `half`. A whole turn is 0 again, so that a seam closes to the
/// last bit.
const fn angle(part: u32, parts: u32, half: bool) -> Angle {
    let bits = ((part as u64) << (32 - half as u32)) / parts as u64;
    // Whole turns overflow and drop out.
    Angle::from_bits(bits as u32)
}

/// Sine and cosine in units of 2⁻³⁰.
const fn sin_cos(angle: Angle) -> (i64, i64) {
    (angle.sin().to_bits() as i64, angle.cos().to_bits() as i64)
}

/// `part` / `parts` with `fraction` fraction bits, rounded to nearest.
const fn nearest(part: u32, parts: u32, fraction: u32) -> i32 {
    // At most 1.
    (((part as u64) << (fraction + 1)) / parts as u64).div_ceil(2) as i32
}

/// The nearest `TexCoord` to `part` / `parts`.
const fn ratio(part: u32, parts: u32) -> TexCoord {
    TexCoord::from_bits(nearest(part, parts, TexCoord::FRAC_NBITS))
}

/// Maps `part` / `parts` from 0..1 to −1..1, rounded to the nearest `Scalar`.
const fn across(part: u32, parts: u32) -> Scalar {
    Scalar::from_bits(2 * nearest(part, parts, Scalar::FRAC_NBITS) - Scalar::ONE.to_bits())
}

/// Which edges and triangles of a grid to write.
struct Grid {
    columns: u32,
    rows: u32,
    /// Whether the first and the last row of vertices are one point each.
    poles: bool,
    /// The rows of vertices that are joined by edges, from the first to before the second.
    along: [u32; 2],
    /// How many columns of vertices are joined by edges.
    across: u32,
}

/// Writes the triangles and edges between the vertices of a grid, which are numbered row by row from `first`. Seen
/// from outside, columns run to the right and rows run down.
const fn write_grid(pen: &mut Pen<'_>, first: u32, grid: &Grid) {
    let width = grid.columns + 1;
    let mut row = 0;
    while row <= grid.rows {
        let mut column = 0;
        while column <= grid.columns {
            let a = first + row * width + column;
            let (b, c, d) = (a + 1, a + width, a + width + 1);
            let inside = column < grid.columns;
            if inside && row >= grid.along[0] && row < grid.along[1] {
                pen.edge([a, b]);
            }
            if row < grid.rows && column < grid.across {
                pen.edge([a, c]);
            }
            if inside && row < grid.rows {
                // Each vertex of a pole's row lies between two vertices of the next row.
                if grid.poles && row + 1 == grid.rows {
                    pen.triangle([a, c, b]);
                } else {
                    pen.triangle([a, c, d]);
                    if !grid.poles || row > 0 {
                        pen.triangle([a, d, b]);
                    }
                }
            }
            column += 1;
        }
        row += 1;
    }
}

pub(super) const fn sphere(pen: &mut Pen<'_>, slices: u32, stacks: u32) {
    let first = pen.next();
    let mut row = 0;
    while row <= stacks {
        let (radius, y) = sin_cos(angle(row, stacks, true));
        let pole = row == 0 || row == stacks;
        let mut column = 0;
        while column <= slices {
            let (sin, cos) = sin_cos(angle(column, slices, false));
            let point = [radius * sin, y * ONE, radius * cos];
            // At a pole, u lies halfway between the two other corners of the triangle.
            let u = if pole && column < slices {
                ratio(2 * column + 1, 2 * slices)
            } else {
                ratio(column, slices)
            };
            pen.vertex(&Corner {
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
    write_grid(pen, first, &grid);
}

pub(super) const fn torus(pen: &mut Pen<'_>, tube: Scalar, slices: u32, sides: u32) {
    let first = pen.next();
    let tube = tube.to_bits() as i64;
    let mut row = 0;
    while row <= sides {
        // From the inside over the top to the outside.
        let (up, inwards) = sin_cos(angle(row, sides, false));
        let radius = ONE - ((tube * inwards) >> 16);
        let mut column = 0;
        while column <= slices {
            let (sin, cos) = sin_cos(angle(column, slices, false));
            pen.vertex(&Corner {
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
    write_grid(pen, first, &grid);
}

pub(super) const fn plane(pen: &mut Pen<'_>, columns: u32, rows: u32) {
    let first = pen.next();
    let mut row = 0;
    while row <= rows {
        let mut column = 0;
        while column <= columns {
            let place = Vec3::new(across(column, columns), Scalar::ZERO, across(row, rows));
            let uv = [ratio(column, columns), ratio(row, rows)];
            pen.place(place, Vec3::Y, uv);
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
    write_grid(pen, first, &grid);
}

pub(super) const fn cylinder(pen: &mut Pen<'_>, slices: u32) {
    let first = pen.next();
    let mut row = 0;
    while row <= 1 {
        let y = if row == 0 { ONE } else { -ONE };
        let mut column = 0;
        while column <= slices {
            let (sin, cos) = sin_cos(angle(column, slices, false));
            pen.vertex(&Corner {
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
    write_grid(pen, first, &grid);
    cap(pen, slices, ONE);
    cap(pen, slices, -ONE);
}

/// Closes a cylinder at `y` with a fan of triangles.
const fn cap(pen: &mut Pen<'_>, slices: u32, y: i64) {
    let center = pen.next();
    let half = TexCoord::from_bits(UNIT.to_bits() / 2);
    pen.vertex(&Corner {
        position: [0, ONE * y, 0],
        normal: [0, ONE * y, 0],
        uv: [half, half],
    });
    let mut slice = 0;
    while slice < slices {
        let (sin, cos) = sin_cos(angle(slice, slices, false));
        // A disc of the texture; v grows toward +z on the upper cap and toward −z on the lower.
        let down = if y > 0 { cos } else { -cos };
        pen.vertex(&Corner {
            position: [ONE * sin, ONE * y, ONE * cos],
            normal: [0, ONE * y, 0],
            uv: [texture(sin), texture(down)],
        });
        let (this, next) = (center + 1 + slice, center + 1 + (slice + 1) % slices);
        if y > 0 {
            pen.triangle([center, this, next]);
        } else {
            pen.triangle([center, next, this]);
        }
        slice += 1;
    }
}

/// Maps −1..1 in units of 2⁻³⁰ to 0..1.
const fn texture(unit: i64) -> TexCoord {
    // Halved, and rounded from 2⁻³⁰ to 2⁻²⁰; at most 1.
    TexCoord::from_bits(((unit + ONE + (1 << 10)) >> 11) as i32)
}

pub(super) const fn cuboid(pen: &mut Pen<'_>, corner: Vec3) {
    /// Normal, right and down of each side as seen from outside; each is an axis and whether it points along it.
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
        let a = pen.next();
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
            pen.place(Vec3::from_bits(position), Vec3::from_bits(normal), uv);
            vertex += 1;
        }
        let (b, c, d) = (a + 1, a + 2, a + 3);
        pen.triangle([a, c, d]);
        pen.triangle([a, d, b]);
        // Each of the four upright sides writes one upright edge; top and bottom write the rest.
        pen.edge([a, c]);
        if out.0 == 1 {
            pen.edge([b, d]);
            pen.edge([a, b]);
            pen.edge([c, d]);
        }
        side += 1;
    }
}
