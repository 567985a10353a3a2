//! The edges of a mesh with their two faces, for silhouettes and creases.

use core::ops::Bound::Included;

use super::index::{Index, check};
use super::{Mesh, Positions};
use crate::error::{Error, check_angle, check_count, ok};
use crate::num::Angle;

/// The edges of a mesh that may be part of its outline, each with its two faces.
///
/// [`Mesh::outline`] draws the edges that show the shape, as seen from the eye.
/// [`Canvas::smooth_edges`](crate::Canvas::smooth_edges) smooths the jagged pixels along these edges. There are two kinds
/// of them:
///
/// - *creases*, where two faces meet at an angle above a limit;
/// - *silhouettes*, where a front face meets a back face, and borders, which have only one face.
///
/// An edge is drawn only if at least one of its faces is not culled. Therefore, a convex mesh shows no hidden lines
/// even without a depth buffer. For other meshes, first draw the faces into a depth buffer, as in the example of
/// [`Mesh::outline`]; the faces then hide the lines behind them.
///
/// [`outline!`](crate::outline) finds the edges at compile time and stores 8 bytes per edge in flash. At run time,
/// [`build`](Self::build) finds the edges and stores them in the caller's memory. The outline may be drawn with another
/// mesh that has the same faces, such as another frame of an animation. Silhouettes then follow the positions of the
/// mesh that is drawn; creases remain the same edges.
///
/// ```
/// use fixel::mesh::Outline;
/// use fixel::prelude::*;
/// static CRATE: Mesh = shape!(cuboid(vec3!(1, 1, 1)));
/// static CAN: Mesh = shape!(cylinder(16));
/// static EDGES: Outline = outline!(CRATE, deg!(30));
/// static RIMS: Outline = outline!(CAN, deg!(30));
/// // The 12 edges of a cuboid are creases, and the diagonals of its sides are not. The
/// // cylinder's creases are its two rims: its 16 sides meet at 22.5 degrees.
/// assert_eq!((EDGES.edges().len(), EDGES.creases()), (18, 12));
/// assert_eq!((RIMS.edges().len(), RIMS.creases()), (96, 32));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Outline<'a> {
    edges: &'a [[Index; 4]],
    creases: usize,
}

impl<'a> Outline<'a> {
    /// An outline of edges that the caller has found; the first `creases` edges are creases.
    ///
    /// An edge `[a, b, c, d]` runs from position a to position b. The faces beside this edge are the triangles (a, b,
    /// c) and (b, a, d), with corners in the same order as in the mesh. A border has one face; then d equals a.
    ///
    /// ```
    /// use fixel::mesh::Outline;
    /// use fixel::prelude::*;
    /// let positions = [vec3!(0, 0, 0), vec3!(1, 0, 0), vec3!(0, 1, 0)];
    /// let triangle = Mesh::new(&positions, &[[0, 1, 2]])?;
    /// let borders = [[0, 1, 2, 0], [1, 2, 0, 1], [2, 0, 1, 2]];
    /// assert!(Outline::new(&triangle, &borders, 0).is_ok());
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`Error::Index`] if an edge names a position that does not exist; [`Error::Count`] if there are fewer edges
    /// than `creases`.
    pub const fn new(
        mesh: &Mesh<'_>,
        edges: &'a [[Index; 4]],
        creases: usize,
    ) -> Result<Self, Error> {
        ok!(check_count("creases", creases, [0, edges.len()]));
        ok!(check(edges, mesh.positions().len(), None));
        Ok(Self::of(edges, creases))
    }

    /// An outline of edges that are known to be correct and are not checked.
    #[doc(hidden)]
    #[must_use]
    pub const fn of(edges: &'a [[Index; 4]], creases: usize) -> Self {
        Self { edges, creases }
    }

    /// Finds the outline of a mesh. Edges at which the normals of the faces differ by more than `crease` are creases.
    /// At 0 degrees, all edges of polygons are creases; at 180 degrees, there are no creases.
    ///
    /// `edges` needs room for the three sides of every face. A closed mesh uses half of this room.
    ///
    /// The sides of two faces form one edge if their ends have the same positions, even if the indices differ.
    /// Therefore, a seam of texture coordinates is not a border. Faces without area are ignored. An angle of at most
    /// 2⁻¹⁰ radians (0.056 degrees) between two faces counts as flat, so the diagonals of a flat polygon are never
    /// creases. If the corners of two faces follow an edge in the same direction, the faces do not share the edge: each
    /// face has a border there, unless the corners of another face follow the edge in the other direction. Only sides
    /// of faces count, so lines of an OBJ file are left out.
    ///
    /// ```
    /// use fixel::mesh::Outline;
    /// use fixel::prelude::*;
    /// static BALL: Mesh = shape!(sphere(8, 4));
    /// let mut room = [[0; 4]; 3 * 48];
    /// let ball = Outline::build(&BALL, deg!(60), &mut room)?;
    /// // 48 triangles have 72 edges. No two triangles meet at more than 60 degrees.
    /// assert_eq!((ball.edges().len(), ball.creases()), (72, 0));
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`Error::Angle`] if `crease` is above 180 degrees; [`Error::Count`] if `edges` is too short.
    pub const fn build(
        mesh: &Mesh<'_>,
        crease: Angle,
        edges: &'a mut [[Index; 4]],
    ) -> Result<Self, Error> {
        // Two faces cannot form an angle above 180 degrees.
        ok!(check_angle(
            "crease angle",
            crease,
            (Included(Angle::ZERO), Included(Angle::HALF))
        ));
        let [edge_count, creases] = ok!(write(mesh, crease, edges));
        let (edges, _) = edges.split_at(edge_count);
        Ok(Self::of(edges, creases))
    }

    /// The edges: creases first, then the others, each group in the order of the mesh's faces. See [`new`](Self::new).
    #[must_use]
    pub const fn edges(&self) -> &'a [[Index; 4]] {
        self.edges
    }

    /// How many of the edges are creases.
    #[must_use]
    pub const fn creases(&self) -> usize {
        self.creases
    }
}

/// Once the opposite side of a side has been found, this number replaces the side's number. `write` refuses meshes with
/// more than 2^32 − 1 sides, so no side has this number.
const USED: u32 = u32::MAX;

/// The two ends of the side with this number, and the third corner of its face. Face i has the sides 3i to 3i + 2.
const fn side(faces: &[[Index; 3]], number: usize) -> [Index; 3] {
    let [a, b, c] = faces[number / 3];
    match number % 3 {
        0 => [a, b, c],
        1 => [b, c, a],
        _ => [c, a, b],
    }
}

/// Whether two indices name the same position, or positions that are equal.
const fn are_same(positions: Positions<'_>, a: Index, b: Index) -> bool {
    if a == b {
        return true;
    }
    let ([ax, ay, az], [bx, by, bz]) = (positions.bits(a), positions.bits(b));
    ax == bx && ay == by && az == bz
}

/// A hash of a position. A product of 32 bits and at most 31 bits cannot overflow, and its lower 32 bits are kept. The
/// function uses only operators, because at compile time, an operator takes a tenth of the time of a call such as
/// `wrapping_mul`.
#[allow(clippy::cast_sign_loss)]
const fn hash([x, y, z]: [i32; 3]) -> u32 {
    let x = (x as u32 as u64 * 0x1E37_79B1) as u32;
    let y = (y as u32 as u64 * 0x05EB_CA77) as u32;
    let z = (z as u32 as u64 * 0x42B2_AE3D) as u32;
    let mixed = (x as u64 + y as u64 + z as u64) as u32;
    ((mixed ^ mixed >> 15) as u64 * 0x2C1B_3C6D) as u32
}

/// The vector from one position to another. If a component needs 32 bits and a sign, every component loses its lowest
/// bit.
const fn direction([a, b, c]: [i32; 3], [x, y, z]: [i32; 3]) -> [i64; 3] {
    let sides = [
        x as i64 - a as i64,
        y as i64 - b as i64,
        z as i64 - c as i64,
    ];
    if magnitude(sides) >> 31 > 0 {
        scaled(sides, 31)
    } else {
        sides
    }
}

/// A number that has as many bits as the largest component has without its sign.
const fn magnitude([x, y, z]: [i64; 3]) -> i64 {
    (x ^ x >> 63) | (y ^ y >> 63) | (z ^ z >> 63)
}

/// The vector, shifted until its largest component has `wanted` bits without its sign; a zero vector stays zero.
const fn scaled(vector: [i64; 3], wanted: u32) -> [i64; 3] {
    let [x, y, z] = vector;
    let bits = 64 - magnitude(vector).leading_zeros();
    if bits > wanted {
        let down = bits - wanted;
        // Components are rounded toward zero, so that opposite vectors remain opposite.
        let one = 1 << down;
        [x / one, y / one, z / one]
    } else {
        let up = wanted - bits;
        [x << up, y << up, z << up]
    }
}

/// The cross product of two vectors with components of at most 31 bits.
const fn cross([ax, ay, az]: [i64; 3], [bx, by, bz]: [i64; 3]) -> [i64; 3] {
    [ay * bz - az * by, az * bx - ax * bz, ax * by - ay * bx]
}

/// Whether the faces a b c and b a d meet at an angle above a limit. An angle of at most 2⁻¹⁰ radians counts as flat
/// and is never above the limit. The limit is given by its sine and cosine in units of 2^-30.
const fn is_crease([a, b, c, d]: [[i32; 3]; 4], [limit_sine, limit_cosine]: [i128; 2]) -> bool {
    // The normals of the two faces, each with a largest component of 20 bits.
    let side = direction(a, b);
    let n = scaled(cross(side, direction(a, c)), 20);
    let m = scaled(cross(direction(a, d), side), 20);
    let [x, y, z] = cross(n, m);
    let (x, y, z) = (x as i128, y as i128, z as i128);
    // The squares of the angle's sine and cosine, both multiplied by the same factor; they are below 2^84.
    let sine = x * x + y * y + z * z;
    let dot = (n[0] * m[0] + n[1] * m[1] + n[2] * m[2]) as i128;
    let cosine = dot * dot;
    if dot > 0 && sine << 20 <= cosine {
        return false;
    }
    if (dot < 0) != (limit_cosine <= 0) {
        // 90 degrees lie between the angle and the limit, so the sign of the angle's cosine decides.
        return dot < 0;
    }
    // Compares the squares of the two tangents, multiplied out to products below 2^124. Above 90 degrees, the greater
    // angle has the smaller squared tangent.
    let this = (sine >> 20) * (limit_cosine * limit_cosine);
    let limit = (cosine >> 20) * (limit_sine * limit_sine);
    if dot < 0 { this < limit } else { this > limit }
}

/// Writes the outline of a mesh; returns how many edges it has, and how many of them are creases.
const fn write(
    mesh: &Mesh<'_>,
    crease: Angle,
    edges: &mut [[Index; 4]],
) -> Result<[usize; 2], Error> {
    let (positions, faces) = (mesh.positions(), mesh.faces());
    let sides = 3 * faces.len();
    let max = if edges.len() < USED as usize {
        edges.len()
    } else {
        USED as usize
    };
    ok!(check_count("sides", sides, [0, max]));
    // Each entry has a hash of a side's ends, and the side's number. The sides of one edge have the same hash, so they
    // become neighbors when the entries are sorted.
    let mut count = 0;
    let mut first = 0;
    while first < sides {
        let [a, b, c] = side(faces, first);
        let (a, b, c) = (positions.bits(a), positions.bits(b), positions.bits(c));
        // Faces without area are left out.
        if !matches!(cross(direction(a, b), direction(a, c)), [0, 0, 0]) {
            let hashes = [hash(a), hash(b), hash(c)];
            let mut corner = 0;
            while corner < 3 {
                // The sum of the hashes of both ends is the same for both sides of an edge.
                let hash = (hashes[corner] as u64 + hashes[(corner + 1) % 3] as u64) as u32;
                let number = first + corner;
                edges[count] = [
                    (hash >> 16) as Index,
                    hash as Index,
                    (number >> 16) as Index,
                    number as Index,
                ];
                count += 1;
                corner += 1;
            }
        }
        first += 3;
    }
    sort(edges, (0, count), 64);

    let (sine, cosine) = crease.sin_cos();
    let limit = [sine.to_bits() as i128, cosine.to_bits() as i128];
    // An edge overwrites the entry of its first side or an earlier entry, and these entries are no longer needed.
    let (mut kept, mut creases) = (0, 0);
    let mut at = 0;
    while at < count {
        let entry = edges[at];
        if number_of(entry) != USED {
            let [a, b, c] = side(faces, number_of(entry) as usize);
            let (d, is_crease) = match opposite_side(mesh, [a, b], entry, edges, (at + 1, count)) {
                None => (a, false),
                // No angle is above 180 degrees, so no edge is a crease. This limit is usual if only silhouettes are
                // wanted.
                Some(d) if crease.to_bits() == 1 << 31 => (d, false),
                Some(d) => {
                    let [from, to] = [positions.bits(a), positions.bits(b)];
                    let faces = [from, to, positions.bits(c), positions.bits(d)];
                    (d, is_crease(faces, limit))
                }
            };
            // A crease takes the place of the first edge that is not a crease, and that edge moves to the end.
            edges[kept] = edges[creases];
            let place = if is_crease { creases } else { kept };
            edges[place] = [entry[2], entry[3], d, 0];
            creases += is_crease as usize;
            kept += 1;
        }
        at += 1;
    }
    // Edges in the order of the mesh find their vertices in the cache. So far, an edge begins with the number of its
    // first side.
    let bits = 64 - ((sides as u64) << 32).leading_zeros() as usize;
    sort(edges, (0, creases), bits);
    sort(edges, (creases, kept), bits);
    let mut at = 0;
    while at < kept {
        let [high, low, d, _] = edges[at];
        let [a, b, c] = side(faces, number_of([0, 0, high, low]) as usize);
        edges[at] = [a, b, c, d];
        at += 1;
    }
    Ok([kept, creases])
}

/// Ranges of at most this many entries are sorted by insertion.
const FEW: usize = 6;

/// Sorts a range of entries as if each entry were one number of 64 bits. All bits above `bits` are equal in the range.
///
/// This is a radix sort in place, because it has the fewest steps and no calls in its loops: in the compiler, a heap
/// sort took ten times as long. It calls itself once for each bit at most, usually about log2(n) times.
const fn sort(entries: &mut [[Index; 4]], (mut start, end): (usize, usize), mut bits: usize) {
    while end - start > FEW {
        bits -= 1;
        let (word, mask) = (3 - bits / 16, 1 << (bits % 16));
        // Entries without the bit move to the front.
        let (mut front, mut back) = (start, end);
        while front < back {
            let entry = entries[front];
            if entry[word] & mask == 0 {
                front += 1;
            } else {
                back -= 1;
                entries[front] = entries[back];
                entries[back] = entry;
            }
        }
        sort(entries, (start, front), bits);
        start = front;
    }
    let mut next = start + 1;
    while next < end {
        let entry = entries[next];
        let mut at = next;
        while at > start && key(entry) < key(entries[at - 1]) {
            entries[at] = entries[at - 1];
            at -= 1;
        }
        entries[at] = entry;
        next += 1;
    }
}

/// An entry as one number, by which the entries are sorted.
const fn key([a, b, c, d]: [Index; 4]) -> u64 {
    (a as u64) << 48 | (b as u64) << 32 | (c as u64) << 16 | d as u64
}

/// The number of an entry's side.
const fn number_of([.., high, low]: [Index; 4]) -> u32 {
    (high as u32) << 16 | low as u32
}

/// Finds the opposite side, from `b` to `a`, among the entries with the same hash, and marks it as used. Returns the
/// third corner of the opposite side's face; `None` if there is no opposite side.
const fn opposite_side(
    mesh: &Mesh<'_>,
    [a, b]: [Index; 2],
    entry: [Index; 4],
    entries: &mut [[Index; 4]],
    (start, end): (usize, usize),
) -> Option<Index> {
    let mut at = start;
    while at < end && entries[at][0] == entry[0] && entries[at][1] == entry[1] {
        let number = number_of(entries[at]);
        if number != USED {
            let [from, to, third] = side(mesh.faces(), number as usize);
            if are_same(mesh.positions(), from, b) && are_same(mesh.positions(), to, a) {
                entries[at][2] = Index::MAX;
                entries[at][3] = Index::MAX;
                return Some(third);
            }
        }
        at += 1;
    }
    None
}

/// The [`Outline`](crate::mesh::Outline) of a mesh, found at compile time and stored in flash.
///
/// The first argument is a `static` or `const` mesh. The second argument is an angle: if two faces meet at a larger
/// angle, their edge is a crease. 30 to 45 degrees suit most models. [`Outline::build`](crate::mesh::Outline::build)
/// describes which edges are found.
///
/// ```standalone_crate
/// use fixel::mesh::Outline;
/// use fixel::prelude::*;
/// static HOUSE: Mesh = include_mesh!("../../tests/models/house.obj");
/// static OUTLINE: Outline = outline!(HOUSE, deg!(30));
/// assert!(OUTLINE.creases() > 0);
/// ```
/// ```compile_fail
/// use fixel::prelude::*;
/// static CRATE: Mesh = shape!(cuboid(vec3!(1, 1, 1)));
/// static OUTLINE: fixel::mesh::Outline = outline!(CRATE, deg!(181));
/// ```
#[macro_export]
macro_rules! outline {
    ($mesh:expr, $crease:expr $(,)?) => {{
        const SIDES: usize = 3 * $mesh.faces().len();
        #[allow(long_running_const_eval)]
        // The constant is a reference, because each use of a constant copies its value.
        const FOUND: &([[$crate::Index; 4]; SIDES], [usize; 2]) = &{
            let mut edges = [[0; 4]; SIDES];
            let outline = $crate::mesh::Outline::build(&$mesh, $crease, &mut edges);
            let outline = $crate::mesh::flash::checked(outline, "outline");
            let counts = [outline.edges().len(), outline.creases()];
            (edges, counts)
        };
        static EDGES: [[$crate::Index; 4]; FOUND.1[0]] = $crate::mesh::flash::first(&FOUND.0);
        let outline = $crate::mesh::Outline::new(&$mesh, &EDGES, FOUND.1[1]);
        $crate::mesh::flash::checked(outline, "outline")
    }};
}
