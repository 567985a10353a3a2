//! The map, and the meshes that the compiler makes from it.
//!
//! The world is 20 units wide and long. On the map, x points to the right (east) and z points down (south); y is
//! height. Each character is a cell of one unit. A cell that is higher than its neighbors gets sides, and a cell that
//! is visible from above gets a top. Faces are sorted by blocks of 5x5 cells, so that a block out of view costs only
//! one test.

use core::ops::Range;

use embedded_graphics::pixelcolor::Rgb888;
use fixel::Index;
use fixel::mesh::Bounds;
use fixel::prelude::*;

use super::light;

/// The number of cells along a side of the map.
pub const SIDE: usize = 20;

/// `#`: wall, `M`: battlements of the wall, `%`: tower, `H`: house, `G`: gate post, `h`: hedge, `.`: grass, `,`:
/// gravel, `o`: paving, `~`: water. On grass: `L`: lamp, `C`: cypress, `T`: tree, `b`: bush. Outside of the wall: `c`:
/// cypress, `t`: tree, seen through the gate; `v`, `u`: the same, of which the wall hides the lower half.
pub static MAP: [&[u8; SIDE]; SIDE] = [
    b"  t   c t    t  c   ",
    b" t  c      c    t t ",
    b" %%#M#MHHHHHHM#M#%% ",
    b"t%%b...HHHHHH...b%% ",
    b"  MC.b.HHHHHH.b.CM t",
    b" t#T.L,,,,,,,,L.T#  ",
    b"  M.,,,,,,,,,,,,.Mc ",
    b"  #.,,.oooooo.,,.#t ",
    b"  MC,,.o~~~~o.,,CM  ",
    b"t #.,,.o~~~~o.,,.#  ",
    b"  M.,,.o~~~~o.,,.Mc ",
    b"  #C,,.o~~~~o.,,C#t ",
    b" tM.,,.oooooo.,,.M  ",
    b"  #L,,..b..b..,,L#  ",
    b"  M.,,,,,,,,,,,,.Mt ",
    b"  #.ThhhL,,LhhhT.#  ",
    b"t%%.bhh.C,,C.hhb.%% ",
    b" %%#M#M#G,,G#M#M#%%t",
    b" t   t  .,,.  t     ",
    b"  c   t t,, t   t c ",
];

/// The material of a surface.
#[derive(Clone, Copy, PartialEq, Eq)]
#[repr(u8)]
pub enum Material {
    Grass,
    Gravel,
    Paving,
    Stone,
    Plaster,
    Hedge,
}

/// A cell: its height in sixteenths of a unit, and the materials of its top and its sides.
struct Cell {
    height: i16,
    top: Option<Material>,
    side: Material,
}

/// The height of the water's surface, in sixteenths of a unit.
pub const WATER: i16 = -3;

/// Whether there is a surface, and it has this material.
const fn is(surface: Option<Material>, material: Material) -> bool {
    match surface {
        Some(surface) => surface as u8 == material as u8,
        None => false,
    }
}

/// The height of cells outside of the wall. Nothing is visible there.
const OUTSIDE: i16 = i16::MAX;

const fn cell(x: usize, z: usize) -> Cell {
    use Material::{Grass, Gravel, Hedge, Paving, Plaster, Stone};
    // Cells beyond the map count as outside of the wall, so no sides face them.
    let kind = if x < SIDE && z < SIDE {
        MAP[z][x]
    } else {
        b' '
    };
    let (height, top, side) = match kind {
        b'#' => (32, None, Stone),
        b'M' => (38, None, Stone),
        b'%' => (72, None, Stone),
        b'G' => (48, None, Stone),
        b'H' => (56, None, Plaster),
        b'h' => (10, Some(Hedge), Hedge),
        b'o' => (2, Some(Paving), Paving),
        b',' => (0, Some(Gravel), Paving),
        b'~' => (WATER, None, Paving),
        b' ' | b't' | b'c' | b'u' | b'v' => (OUTSIDE, None, Stone),
        _ => (0, Some(Grass), Paving),
    };
    Cell { height, top, side }
}

/// The number of blocks along a side of the map.
const BLOCKS: usize = 4;
/// The number of cells along a side of a block.
const BLOCK: usize = SIDE / BLOCKS;

/// The boxes around the blocks, without roofs and trees.
pub static BOUNDS: [Bounds; BLOCKS * BLOCKS] = {
    let mut bounds = [Bounds::new(Vec3::ZERO, Vec3::ZERO); BLOCKS * BLOCKS];
    let mut at = 0;
    while at < bounds.len() {
        let (x, z) = (at % BLOCKS * BLOCK, at / BLOCKS * BLOCK);
        let (mut most, mut inside) = (0, 0);
        while inside < BLOCK * BLOCK {
            let Cell { height, .. } = cell(x + inside % BLOCK, z + inside / BLOCK);
            if height != OUTSIDE && height > most {
                most = height;
            }
            inside += 1;
        }
        let (x, z, size) = ((x as i32) << 16, (z as i32) << 16, (BLOCK as i32) << 16);
        bounds[at] = Bounds::new(
            Vec3::from_bits([x, (WATER as i32) << 12, z]),
            Vec3::from_bits([x + size, (most as i32) << 12, z + size]),
        );
        at += 1;
    }
    bounds
};

/// All faces of a material.
pub struct Layer {
    mesh: Mesh<'static>,
    /// The first face of each block, and the end of the last block.
    starts: [usize; BLOCKS * BLOCKS + 1],
}

impl Layer {
    /// The faces in a block; `None` if there are none.
    pub fn block(&self, block: usize) -> Option<Mesh<'static>> {
        let faces: Range<usize> = *self.starts.get(block)?..*self.starts.get(block + 1)?;
        (!faces.is_empty()).then(|| self.mesh.part(faces))
    }
}

/// Memory in which the compiler makes a layer, with room for any layer.
struct Draft {
    positions: [[i16; 3]; 1600],
    /// Texture coordinates, in sixteenths of a unit of the world. A texture covers two units.
    uvs: [[i16; 2]; 1600],
    /// The sides on which vertices are: see `NORMALS`. They say which light vertices are in.
    sides: [u8; 1600],
    faces: [[Index; 3]; 1600],
    starts: [usize; BLOCKS * BLOCKS + 1],
    vertices: usize,
    triangles: usize,
    /// The first vertex of the current block. Vertices of other blocks are not shared.
    first: usize,
}

/// The normals of the sides of a cell, and of its top.
const NORMALS: [[i32; 3]; 5] = [[0, 0, -1], [0, 0, 1], [1, 0, 0], [-1, 0, 0], [0, 1, 0]];
const TOP: u8 = 4;

impl Draft {
    /// Returns the index of a vertex. A vertex that the block does not have yet is added to the block. Positions are in
    /// sixteenths of a unit.
    const fn vertex(&mut self, [x, y, z]: [i16; 3], [u, v]: [i16; 2], side: u8) -> Index {
        let mut at = self.first;
        while at < self.vertices {
            let ([a, b, c], [d, e]) = (self.positions[at], self.uvs[at]);
            if a == x && c == z && b == y && d == u && e == v && self.sides[at] == side {
                return at as Index;
            }
            at += 1;
        }
        self.positions[at] = [x, y, z];
        self.uvs[at] = [u, v];
        self.sides[at] = side;
        self.vertices += 1;
        at as Index
    }

    /// Adds a rectangle. The corners run counter-clockwise from the bottom left.
    const fn quad(&mut self, corners: [[i16; 3]; 4], uvs: [[i16; 2]; 4], side: u8) {
        let a = self.vertex(corners[0], uvs[0], side);
        let b = self.vertex(corners[1], uvs[1], side);
        let c = self.vertex(corners[2], uvs[2], side);
        let d = self.vertex(corners[3], uvs[3], side);
        self.faces[self.triangles] = [a, b, c];
        self.faces[self.triangles + 1] = [a, c, d];
        self.triangles += 2;
    }

    /// Collects the faces of a material.
    const fn new(material: Material) -> Self {
        let mut draft = Self {
            positions: [[0; 3]; 1600],
            uvs: [[0; 2]; 1600],
            sides: [0; 1600],
            faces: [[0; 3]; 1600],
            starts: [0; BLOCKS * BLOCKS + 1],
            vertices: 0,
            triangles: 0,
            first: 0,
        };
        let mut at = 0;
        while at < SIDE * SIDE {
            let (block, inside) = (at / (BLOCK * BLOCK), at % (BLOCK * BLOCK));
            if inside == 0 {
                draft.first = draft.vertices;
                draft.starts[block] = draft.triangles;
            }
            let x = block % BLOCKS * BLOCK + inside % BLOCK;
            let z = block / BLOCKS * BLOCK + inside / BLOCK;
            draft.cell(x, z, material);
            at += 1;
        }
        draft.starts[BLOCKS * BLOCKS] = draft.triangles;
        draft
    }

    const fn cell(&mut self, column: usize, row: usize, material: Material) {
        let Cell { height, top, side } = cell(column, row);
        let (x, z) = (column as i16 * 16, row as i16 * 16);
        let (right, front) = (x + 16, z + 16);
        if is(top, material) {
            let y = height;
            let corners = [[x, y, front], [right, y, front], [right, y, z], [x, y, z]];
            self.quad(
                corners,
                [[x, front], [right, front], [right, z], [x, z]],
                TOP,
            );
        }
        if !is(Some(side), material) || height == OUTSIDE {
            return;
        }
        // For each side of the cell: the neighbor there, and the side's two lower corners, the left one first for a
        // viewer on that neighbor. A cell at the left or the upper edge of the map has no neighbor beyond this edge, so
        // the neighbor's index wraps to an index outside of the map.
        let sides = [
            (cell(column, row.wrapping_sub(1)), [right, z], [x, z]),
            (cell(column, row + 1), [x, front], [right, front]),
            (cell(column + 1, row), [right, front], [right, z]),
            (cell(column.wrapping_sub(1), row), [x, z], [x, front]),
        ];
        let mut at = 0;
        while at < 4 {
            let (Cell { height: mut y, .. }, [a, b], [c, d]) = sides[at];
            // On sides to the north and to the east, coordinates decrease from left to right.
            let (from, to) = match at {
                0 => (-a, -c),
                1 => (a, c),
                2 => (-b, -d),
                _ => (b, d),
            };
            // Light is computed at the vertices, so a side is cut into rectangles at most one unit high.
            while y < height {
                let floor = (y.div_euclid(16) + 1) * 16;
                let upper = if floor < height { floor } else { height };
                self.quad(
                    [[a, y, b], [c, y, d], [c, upper, d], [a, upper, b]],
                    [[from, -y], [to, -y], [to, -upper], [from, -upper]],
                    at as u8,
                );
                y = upper;
            }
            at += 1;
        }
    }
}

/// The first `count` elements of an array.
macro_rules! first {
    ($count:expr, $array:expr) => {{
        let mut first = [$array[0]; $count];
        let mut at = 0;
        while at < first.len() {
            first[at] = $array[at];
            at += 1;
        }
        first
    }};
}

/// A layer in flash that takes only the memory that it needs.
macro_rules! layer {
    ($material:ident) => {{
        #[allow(long_running_const_eval)]
        const DRAFT: Draft = Draft::new(Material::$material);
        static POSITIONS: [[i16; 3]; DRAFT.vertices] = first!(DRAFT.vertices, DRAFT.positions);
        static UVS: [Vec2; DRAFT.vertices] = {
            let mut uvs = [vec2!(0, 0); DRAFT.vertices];
            let mut at = 0;
            while at < uvs.len() {
                let [u, v] = DRAFT.uvs[at];
                uvs[at] = Vec2::from_bits([(u as i32) << 15, (v as i32) << 15]);
                at += 1;
            }
            uvs
        };
        static COLORS: [Rgb888; DRAFT.vertices] = {
            let mut colors = [Rgb888::new(0, 0, 0); DRAFT.vertices];
            let mut at = 0;
            while at < colors.len() {
                let [x, y, z] = DRAFT.positions[at];
                let normal = NORMALS[DRAFT.sides[at] as usize];
                colors[at] = light::at([x as i32, y as i32, z as i32], Some(normal));
                at += 1;
            }
            colors
        };
        static FACES: [[Index; 3]; DRAFT.triangles] = first!(DRAFT.triangles, DRAFT.faces);
        Layer {
            mesh: Mesh::checked(
                Mesh::checked(
                    Mesh::checked(Mesh::quantized(&POSITIONS, 4, &FACES)).with_uvs(&UVS, None),
                )
                .with_colors(&COLORS, None),
            ),
            starts: DRAFT.starts,
        }
    }};
}

pub static GRASS: Layer = layer!(Grass);
pub static GRAVEL: Layer = layer!(Gravel);
pub static PAVING: Layer = layer!(Paving);
pub static STONE: Layer = layer!(Stone);
pub static PLASTER: Layer = layer!(Plaster);
pub static HEDGE: Layer = layer!(Hedge);

/// The number of cells of two kinds.
const fn count(kinds: [u8; 2]) -> usize {
    let (mut count, mut at) = (0, 0);
    while at < SIDE * SIDE {
        let cell = MAP[at / SIDE][at % SIDE];
        count += (cell == kinds[0] || cell == kinds[1]) as usize;
        at += 1;
    }
    count
}

/// Points at a height `y` near the middles of all cells of two kinds.
const fn points<const N: usize>(kinds: [u8; 2], y: Scalar, jitter: i32) -> [Vec3; N] {
    let mut points = [Vec3::ZERO; N];
    let (mut found, mut at) = (0, 0);
    while at < SIDE * SIDE {
        let (x, z) = (at % SIDE, at / SIDE);
        if MAP[z][x] == kinds[0] || MAP[z][x] == kinds[1] {
            let shift = [(at * 37 % 64) as i32 - 32, (at * 23 % 64) as i32 - 32];
            points[found] = Vec3::from_bits([
                ((x as i32) << 16) + 0x8000 + shift[0] * jitter,
                y.to_bits(),
                ((z as i32) << 16) + 0x8000 + shift[1] * jitter,
            ]);
            found += 1;
        }
        at += 1;
    }
    points
}

pub static LAMPS: [Vec3; count(*b"LL")] = points(*b"LL", fx!(1.6), 0);
/// The light on plants, at their middle.
const fn lights<const N: usize>(points: &[Vec3; N], height: i32) -> [Rgb888; N] {
    let mut lights = [Rgb888::new(0, 0, 0); N];
    let mut at = 0;
    while at < N {
        let [x, _, z] = points[at].to_bits();
        lights[at] = light::at([x >> 12, height, z >> 12], None);
        at += 1;
    }
    lights
}

/// Plants of a kind, and their size.
pub struct Plants {
    pub places: &'static [Vec3],
    pub lights: &'static [Rgb888],
    pub size: (Scalar, Scalar),
}

/// At least as many as there are plants of any kind.
pub const MOST_PLANTS: usize = 32;

/// Plants on all cells of two kinds: their height above the ground, how far they may be from the middle of their cells,
/// the height at which they are lit, and their size.
macro_rules! plants {
    ($kinds:literal, $y:literal, $jitter:literal, $lit:literal, $width:literal x $height:literal) => {{
        static PLACES: [Vec3; count(*$kinds)] = points(*$kinds, fx!($y), $jitter);
        static LIGHTS: [Rgb888; PLACES.len()] = lights(&PLACES, $lit);
        const { assert!(PLACES.len() <= MOST_PLANTS) };
        Plants {
            places: &PLACES,
            lights: &LIGHTS,
            size: (fx!($width), fx!($height)),
        }
    }};
}

pub static TREES: Plants = plants!(b"Tt", 0, 400, 32, 3 x 3.4);
pub static CYPRESSES: Plants = plants!(b"Cc", 0, 200, 24, 1 x 4);
/// The wall hides the lower halves.
pub static TREETOPS: Plants = plants!(b"uu", 1.7, 400, 32, 3 x 1.7);
pub static CYPRESS_TOPS: Plants = plants!(b"vv", 2, 200, 24, 1 x 2);
pub static BUSHES: Plants = plants!(b"bb", 0, 300, 8, 1 x 0.9);
