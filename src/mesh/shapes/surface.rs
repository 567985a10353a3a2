//! The surfaces of the shapes; most are grids, bent to rings around the y axis.

use super::Shape;
use super::writer::MeshWriter;
use crate::math::Vec3;
use crate::mesh::Index;
use crate::num::rsqrt::unit;
use crate::num::{Angle, Scalar, TexCoord};

const ZERO: TexCoord = TexCoord::ZERO;
const UNIT: TexCoord = TexCoord::ONE;
/// The number 1 with the 30 fraction bits of a `Fraction`.
const ONE: i64 = 1 << 30;

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

/// The bits of the `Scalar` nearest to a number with `fraction` fraction bits, of which there must be more than 16.
const fn rounded(number: i64, fraction: u32) -> i32 {
    // Components have magnitudes of at most 2, or the magnitude of a `Scalar`, so the cast loses nothing.
    ((number + (1 << (fraction - 17))) >> (fraction - 16)) as i32
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

/// What a shape is made of: a box, a grid, or rings of vertices around the y axis.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Surface<'p> {
    /// A box, which is not a grid: six sides between this corner and the opposite corner.
    Cuboid(Vec3),
    Sphere,
    /// A tube of this radius.
    Torus(Scalar),
    Plane,
    /// Rings through the points (radius, height) of a profile, and discs of radius 1 that face up and down at these
    /// heights.
    Lathe(&'p Profile, [Option<Scalar>; 2]),
}

/// The points of a profile.
pub(super) type Profile = [(Scalar, Scalar)];

/// The number of rings of a profile, and the first of its points that has one. If the first point is repeated, only the
/// second of both has a ring, because there are no triangles between them; and so at the end.
const fn rings(profile: &Profile) -> (u32, usize) {
    let (mut from, mut to) = (0, profile.len());
    if to > 1 && is_same(profile[0], profile[1]) {
        from += 1;
    }
    if to > from + 1 && is_same(profile[to - 2], profile[to - 1]) {
        to -= 1;
    }
    ((to - from) as u32, from)
}

const fn is_same(a: (Scalar, Scalar), b: (Scalar, Scalar)) -> bool {
    a.0.to_bits() == b.0.to_bits() && a.1.to_bits() == b.1.to_bits()
}

/// The step from one point of a profile to the next, turned outwards by a right angle: away from the axis, and along
/// it. A component has at most 33 bits and a sign.
const fn across_step(profile: &Profile, at: usize) -> [i64; 2] {
    let ((radius, y), (next_radius, next_y)) = (profile[at], profile[at + 1]);
    [
        y.to_bits() as i64 - next_y.to_bits() as i64,
        next_radius.to_bits() as i64 - radius.to_bits() as i64,
    ]
}

/// The vector of length one in the direction of `[out, up]`, in units of 2⁻³⁰; zero for zero.
const fn unit_of([out, up]: [i64; 2]) -> [i64; 2] {
    match unit([out, up, 0]) {
        Some([out, up, _]) => [out as i64, up as i64],
        None => [0; 2],
    }
}

/// The length of a profile's step, in units of 2⁻¹⁶.
const fn length(profile: &Profile, at: usize) -> u64 {
    let (step, unit) = (across_step(profile, at), unit_of(across_step(profile, at)));
    ((step[0] * unit[0] + step[1] * unit[1]) >> 30).cast_unsigned()
}

/// The normal at a point of a profile: the mean of the normals on both sides. Between two equal points, there is no
/// side. If the profile ends on the axis, it continues in its mirror image, so that the normal points along the axis.
const fn normal_at(profile: &Profile, at: usize) -> [i64; 2] {
    let last = profile.len() - 1;
    let is_loop = last > 1 && is_same(profile[0], profile[last]);
    let is_end = !is_loop && (at == 0 || at == last);
    let before = if at > 0 || is_loop {
        unit_of(across_step(profile, (if at > 0 { at } else { last }) - 1))
    } else {
        [0; 2]
    };
    let after = if at < last || is_loop {
        unit_of(across_step(profile, if at < last { at } else { 0 }))
    } else {
        [0; 2]
    };
    let out = if is_end && profile[at].0.to_bits() == 0 {
        0
    } else {
        before[0] + after[0]
    };
    match unit_of([out, before[1] + after[1]]) {
        // The profile turns back here, or runs along the axis: there is no better normal.
        [0, 0] => after,
        normal => normal,
    }
}

/// A ring of vertices around the y axis: its radius in units of 2^-`fraction`, and its height. In all rings of a shape,
/// `fraction` is the same.
struct Ring {
    radius: i64,
    fraction: u32,
    y: i32,
}

impl Ring {
    const fn of(shape: &Shape<'_>, row: u32) -> Self {
        match shape.surface {
            Surface::Torus(tube) => {
                let tube = tube.to_bits() as i64;
                // Rows begin on the inside of the tube, and continue over the top to the outside.
                let (up, inwards) = sin_cos(angle(row, shape.rows, false));
                Self {
                    radius: ONE - ((tube * inwards) >> 16),
                    fraction: 30,
                    y: rounded(tube * up, 46),
                }
            }
            Surface::Lathe(profile, _) => {
                let (radius, y) = profile[rings(profile).1 + row as usize];
                Self {
                    radius: radius.to_bits() as i64,
                    fraction: 16,
                    y: y.to_bits(),
                }
            }
            _ => {
                let (radius, y) = sin_cos(angle(row, shape.rows, true));
                Self {
                    radius,
                    fraction: 30,
                    y: rounded(y, 30),
                }
            }
        }
    }

    /// The two components of the normals at a ring, away from the axis and along the axis, in units of 2⁻³⁰.
    const fn normal(shape: &Shape<'_>, row: u32) -> [i64; 2] {
        match shape.surface {
            Surface::Torus(_) => {
                let (up, inwards) = sin_cos(angle(row, shape.rows, false));
                [-inwards, up]
            }
            Surface::Lathe(profile, _) => normal_at(profile, rings(profile).1 + row as usize),
            _ => {
                let (radius, y) = sin_cos(angle(row, shape.rows, true));
                [radius, y]
            }
        }
    }

    /// Whether all vertices are at one point of the axis.
    const fn is_pole(&self) -> bool {
        self.radius == 0
    }

    const fn is_same(&self, other: &Self) -> bool {
        self.radius == other.radius && self.y == other.y
    }
}

/// What a grid has below a row of vertices, for each column.
pub(super) struct Row {
    /// Whether an edge runs along the row.
    pub(super) has_edge: bool,
    /// Whether an edge runs down, from a vertex to the next row.
    pub(super) has_edge_down: bool,
    /// Whether the two triangles of a quad are there: the one with a side in the next row, and the one with a side in
    /// this row. At a pole, a quad is a single triangle.
    pub(super) triangles: [bool; 2],
}

impl Row {
    pub(super) const fn of(shape: &Shape<'_>, row: u32) -> Self {
        let is_last = row + 1 == row_count(shape);
        if let Surface::Plane = shape.surface {
            return Self {
                has_edge: true,
                has_edge_down: !is_last,
                triangles: [!is_last; 2],
            };
        }
        let ring = Ring::of(shape, row);
        // Where a profile has a corner, two rings are the same; and in a torus, the first and the last one.
        let is_repeated = row > 0 && ring.is_same(&Ring::of(shape, row - 1))
            || row > 1 && is_last && ring.is_same(&Ring::of(shape, 0));
        let has_edge = !ring.is_pole() && !is_repeated;
        if is_last {
            return Self {
                has_edge,
                has_edge_down: false,
                triangles: [false; 2],
            };
        }
        let next = Ring::of(shape, row + 1);
        let is_open = !(ring.is_same(&next) || ring.is_pole() && next.is_pole());
        Self {
            has_edge,
            has_edge_down: is_open,
            triangles: [is_open && !next.is_pole(), is_open && !ring.is_pole()],
        }
    }
}

/// The number of rows of vertices in the grid of a shape.
pub(super) const fn row_count(shape: &Shape<'_>) -> u32 {
    match shape.surface {
        Surface::Cuboid(_) => 0,
        Surface::Lathe(profile, _) => rings(profile).0,
        _ => shape.rows + 1,
    }
}

/// Writes the elements of a shape.
pub(super) const fn write(writer: &mut MeshWriter<'_>, shape: &Shape<'_>) {
    if let Surface::Cuboid(corner) = shape.surface {
        cuboid(writer, corner);
        return;
    }
    if row_count(shape) > 0 {
        write_vertices(writer, shape);
        write_grid(writer, shape);
    }
    if let Surface::Lathe(_, [upper, lower]) = shape.surface {
        if let Some(y) = upper {
            disc(writer, shape, y, true);
        }
        if let Some(y) = lower {
            disc(writer, shape, y, false);
        }
    }
}

const fn write_vertices(writer: &mut MeshWriter<'_>, shape: &Shape<'_>) {
    let (columns, rows) = (shape.columns, row_count(shape));
    // The sine, the cosine and u of a vertex depend on the column alone. To compute these numbers for every vertex
    // would take half of the time, so they are computed once. Until the last row is written, the positions of that row
    // store these numbers.
    let last = (rows - 1) * (columns + 1);
    let mut column = 0;
    while column <= columns {
        let (sin, cos) = sin_cos(angle(column, columns, false));
        writer.keep(
            last + column,
            [sin as i32, cos as i32, ratio(column, columns).to_bits()],
        );
        column += 1;
    }
    let mut heights = Heights::of(shape);
    let mut row = 0;
    while row < rows {
        let v = heights.next(shape, row);
        let mut column = 0;
        if let Surface::Plane = shape.surface {
            while column <= columns {
                let u = TexCoord::from_bits(writer.kept(last + column)[2]);
                let place = Vec3::new(
                    across(column, columns),
                    Scalar::ZERO,
                    across(row, shape.rows),
                );
                writer.vertex(place, Vec3::Y, [u, v]);
                column += 1;
            }
        } else {
            let ring = Ring::of(shape, row);
            let [out, up] = Ring::normal(shape, row);
            while column <= columns {
                let [sin, cos, u] = writer.kept(last + column);
                let (mut sin, mut cos, mut u) = (sin as i64, cos as i64, TexCoord::from_bits(u));
                // At a pole, u is halfway between the u of the triangle's two other corners, and so is the normal.
                if ring.is_pole() && column < columns {
                    u = ratio(2 * column + 1, 2 * columns);
                    if out != 0 {
                        (sin, cos) = sin_cos(angle(2 * column + 1, 2 * columns, false));
                    }
                }
                let x = rounded(ring.radius * sin, ring.fraction + 30);
                let z = rounded(ring.radius * cos, ring.fraction + 30);
                let normal = [
                    rounded(out * sin, 60),
                    rounded(up, 30),
                    rounded(out * cos, 60),
                ];
                let place = Vec3::from_bits([x, ring.y, z]);
                writer.vertex(place, Vec3::from_bits(normal), [u, v]);
                column += 1;
            }
        }
        row += 1;
    }
}

/// The texture coordinates v of the rows. In a lathe, they are in proportion to the length of the profile.
struct Heights {
    /// The length before the present row, and the length of the profile.
    before: u64,
    whole: u64,
}

impl Heights {
    const fn of(shape: &Shape<'_>) -> Self {
        let mut whole = 0;
        if let Surface::Lathe(profile, _) = shape.surface {
            let mut at = 0;
            while at + 1 < profile.len() {
                whole += length(profile, at);
                at += 1;
            }
        }
        Self { before: 0, whole }
    }

    const fn next(&mut self, shape: &Shape<'_>, row: u32) -> TexCoord {
        let Surface::Lathe(profile, _) = shape.surface else {
            return ratio(row, shape.rows);
        };
        let at = rings(profile).1 + row as usize;
        if row > 0 {
            self.before += length(profile, at - 1);
        }
        // At most 16,384 lengths of 33 bits have 47 bits. Drop as many bits as a division by 31 bits needs.
        let down = 33_u32.saturating_sub(self.whole.leading_zeros());
        match (self.whole >> down) as u32 {
            0 => ZERO,
            whole => ratio((self.before >> down) as u32, whole),
        }
    }
}

/// Writes the triangles and edges between the vertices of a shape's grid, which are numbered row by row from 0. Seen
/// from outside, columns run to the right and rows run down.
const fn write_grid(writer: &mut MeshWriter<'_>, shape: &Shape<'_>) {
    let columns = shape.columns;
    // Edges run down the first `down` columns of vertices. Around the axis, the last column is the first.
    let down = columns + matches!(shape.surface, Surface::Plane) as u32;
    let mut row = 0;
    while row < row_count(shape) {
        let Row {
            has_edge,
            has_edge_down,
            triangles,
        } = Row::of(shape, row);
        let mut column = 0;
        while column <= columns {
            let a = row * (columns + 1) + column;
            let (b, c, d) = (a + 1, a + columns + 1, a + columns + 2);
            let inside = column < columns;
            if inside && has_edge {
                writer.edge([a, b]);
            }
            if column < down && has_edge_down {
                writer.edge([a, c]);
            }
            if inside {
                // At a pole, the corner of a triangle lies between the two other corners.
                match triangles {
                    [true, true] => {
                        writer.triangle([a, c, d]);
                        writer.triangle([a, d, b]);
                    }
                    [true, false] => writer.triangle([a, c, d]),
                    [false, true] => writer.triangle([a, c, b]),
                    [false, false] => {}
                }
            }
            column += 1;
        }
        row += 1;
    }
}

/// Writes a disc of radius 1 at `y`, as a fan of triangles that face up or down.
const fn disc(writer: &mut MeshWriter<'_>, shape: &Shape<'_>, y: Scalar, faces_up: bool) {
    let (center, slices) = (writer.positions, shape.columns);
    let half = TexCoord::from_bits(UNIT.to_bits() / 2);
    let normal = Vec3::from_bits([0, if faces_up { 1 << 16 } else { -1 << 16 }, 0]);
    writer.vertex(Vec3::from_bits([0, y.to_bits(), 0]), normal, [half, half]);
    let mut slice = 0;
    while slice < slices {
        let (sin, cos) = sin_cos(angle(slice, slices, false));
        // The texture shows a disc. v grows toward +z if the disc faces up, and toward −z if it faces down.
        let down = if faces_up { cos } else { -cos };
        let position = Vec3::from_bits([rounded(sin, 30), y.to_bits(), rounded(cos, 30)]);
        writer.vertex(position, normal, [texture(sin), texture(down)]);
        let (this, next) = (center + 1 + slice, center + 1 + (slice + 1) % slices);
        if faces_up {
            writer.triangle([center, this, next]);
        } else {
            writer.triangle([center, next, this]);
        }
        // If there is a ring, too, it has the edges of the rim.
        if row_count(shape) == 0 {
            writer.edge([this, next]);
        }
        slice += 1;
    }
}

/// Maps −1..1 in units of 2⁻³⁰ to 0..1.
const fn texture(unit: i64) -> TexCoord {
    // (`unit` + 1) / 2, rounded from units of 2⁻³⁰ to units of 2⁻²⁰; at most 1.
    TexCoord::from_bits(((unit + ONE + (1 << 10)) >> 11) as i32)
}

/// The corners of a side of a box, in the texture: row by row.
const CORNERS: [[bool; 2]; 4] = [[false, false], [true, false], [false, true], [true, true]];
/// The indices of a side's triangles among its corners.
const HALVES: [[Index; 3]; 2] = [[0, 2, 3], [0, 3, 1]];

/// The triangles of a box, as indices of texture coordinates: all sides have the same four.
static UV_FACES: [[Index; 3]; 12] = {
    let mut faces = [HALVES[0]; 12];
    let mut face = 0;
    while face < 12 {
        faces[face] = HALVES[face % 2];
        face += 1;
    }
    faces
};
/// The triangles of a box, as indices of normals: each side has one.
static NORMAL_FACES: [[Index; 3]; 12] = {
    let mut faces = [[0; 3]; 12];
    let mut face = 0;
    while face < 12 {
        faces[face] = [face as Index / 2; 3];
        face += 1;
    }
    faces
};

/// The triangles as indices of texture coordinates and of normals; empty if both have the indices of the positions.
pub(super) const fn own_faces(shape: &Shape<'_>) -> [&'static [[Index; 3]]; 2] {
    match shape.surface {
        Surface::Cuboid(_) => [&UV_FACES, &NORMAL_FACES],
        _ => [&[]; 2],
    }
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
    let ends = corner.to_bits();
    // Bit n of a position's index is set if the position lies on the negative half of axis n.
    let mut index = 0;
    while index < 8 {
        let mut position = ends;
        let mut axis = 0;
        while axis < 3 {
            if index >> axis & 1 == 1 {
                position[axis] = -position[axis];
            }
            axis += 1;
        }
        writer.position(Vec3::from_bits(position));
        index += 1;
    }
    let mut at = 0;
    while at < 4 {
        let [u, v] = CORNERS[at];
        writer.uv([if u { UNIT } else { ZERO }, if v { UNIT } else { ZERO }]);
        at += 1;
    }
    let mut side = 0;
    while side < SIDES.len() {
        let [out, right, down] = SIDES[side];
        let mut normal = [0; 3];
        normal[out.0] = if out.1 { 1 << 16 } else { -(1 << 16) };
        writer.normal(Vec3::from_bits(normal));
        let mut corners = [0; 4];
        let mut at = 0;
        while at < 4 {
            let [u, v] = CORNERS[at];
            corners[at] = (!out.1 as u32) << out.0
                | ((u != right.1) as u32) << right.0
                | ((v != down.1) as u32) << down.0;
            at += 1;
        }
        let mut half = 0;
        while half < 2 {
            let [i, j, k] = HALVES[half];
            writer.triangle([
                corners[i as usize],
                corners[j as usize],
                corners[k as usize],
            ]);
            half += 1;
        }
        let [a, b, c, d] = corners;
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
