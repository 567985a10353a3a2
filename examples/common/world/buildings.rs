//! Things that stand on the map, except blocks: roofs, windows and lamps.

use fixel::Index;
use fixel::prelude::*;

/// For each roof, in sixteenths of a unit: its west, north, east and south edges, the height of its eaves, and its
/// rise.
static EAVES: [[i16; 6]; 5] = [
    [108, 28, 212, 84, 55, 26],
    [13, 29, 51, 67, 72, 40],
    [285, 29, 323, 67, 72, 40],
    [13, 253, 51, 291, 72, 40],
    [285, 253, 323, 291, 72, 40],
];

/// Hipped roofs with a ridge from west to east. A roof on a square is a pyramid.
pub static ROOFS: Mesh = {
    static CORNERS: ([[i16; 3]; 70], [Vec2; 70], [[Index; 3]; 30]) = {
        let mut positions = [[0; 3]; 70];
        let mut uvs = [vec2!(0, 0); 70];
        let mut faces = [[0; 3]; 30];
        let mut at = 0;
        while at < EAVES.len() {
            let [west, north, east, south, y, rise] = EAVES[at];
            let (ridge, inset) = (y + rise, (south - north) / 2);
            let middle = north + inset;
            let [left, right] = [[west + inset, ridge, middle], [east - inset, ridge, middle]];
            let corners = [
                [west, y, south],
                [east, y, south],
                [east, y, north],
                [west, y, north],
            ];
            // Each slope has its own corners, in this order: lower left, lower right, upper right, upper left.
            let slopes = [
                [corners[0], corners[1], right, left],
                [corners[2], corners[3], left, right],
                [corners[1], corners[2], right, right],
                [corners[3], corners[0], left, left],
            ];
            let mut slope = 0;
            while slope < 4 {
                let first = 14 * at + 4 * slope - if slope == 3 { 1 } else { 0 };
                let mut corner = 0;
                while corner < if slope < 2 { 4 } else { 3 } {
                    let [x, y, z] = slopes[slope][corner];
                    positions[first + corner] = [x, y, z];
                    let along = if slope < 2 { x } else { z };
                    uvs[first + corner] =
                        Vec2::from_bits([(along as i32) << 15, -(y as i32) << 15]);
                    corner += 1;
                }
                let (face, first) = (
                    6 * at + 2 * slope - if slope == 3 { 1 } else { 0 },
                    first as Index,
                );
                faces[face] = [first, first + 1, first + 2];
                if slope < 2 {
                    faces[face + 1] = [first, first + 2, first + 3];
                }
                slope += 1;
            }
            at += 1;
        }
        (positions, uvs, faces)
    };
    Mesh::checked(
        Mesh::checked(Mesh::quantized(&CORNERS.0, 4, &CORNERS.2)).with_uvs(&CORNERS.1, None),
    )
};

/// A window: the middle of its sill in sixteenths of a unit, whether it faces north, and half its width and its height.
type Window = ([i16; 3], bool, [i16; 2]);

const GLAZED: [Window; 13] = [
    ([160, 0, 80], false, [6, 25]),
    ([120, 12, 80], false, [4, 14]),
    ([138, 12, 80], false, [4, 14]),
    ([184, 12, 80], false, [4, 14]),
    ([202, 12, 80], false, [4, 14]),
    ([120, 37, 80], false, [4, 14]),
    ([160, 37, 80], false, [4, 14]),
    ([202, 37, 80], false, [4, 14]),
    ([138, 37, 80], false, [4, 14]),
    ([32, 48, 64], false, [3, 12]),
    ([304, 48, 64], false, [3, 12]),
    ([32, 48, 256], true, [3, 12]),
    ([304, 48, 256], true, [3, 12]),
];

const PANES: usize = GLAZED.len();

/// The corners of rectangles that reach beyond the windows by `more`, and are in front of the walls by `before`.
const fn around(more: i16, before: i16) -> [[i16; 3]; 4 * PANES] {
    let mut positions = [[0; 3]; 4 * PANES];
    let mut at = 0;
    while at < 4 * PANES {
        let ([x, sill, wall], is_north, [half, height]) = GLAZED[at / 4];
        let is_left = matches!(at % 4, 0 | 3) != is_north;
        let side = half + more;
        let y = if at % 4 < 2 {
            sill - more
        } else {
            sill + height + more
        };
        positions[at] = [
            if is_left { x - side } else { x + side },
            y,
            if is_north {
                wall - before
            } else {
                wall + before
            },
        ];
        at += 1;
    }
    positions
}

static PANE_UVS: [Vec2; 4 * PANES] = {
    let corners = [vec2!(0, 1), vec2!(1, 1), vec2!(1, 0), vec2!(0, 0)];
    let mut uvs = [corners[0]; 4 * PANES];
    let mut at = 0;
    while at < uvs.len() {
        uvs[at] = corners[at % 4];
        at += 1;
    }
    uvs
};

static PANE_FACES: [[Index; 3]; 2 * PANES] = {
    let mut faces = [[0; 3]; 2 * PANES];
    let mut at = 0;
    while at < PANES {
        let first = 4 * at as Index;
        faces[2 * at] = [first, first + 1, first + 2];
        faces[2 * at + 1] = [first, first + 2, first + 3];
        at += 1;
    }
    faces
};

const fn panes(positions: &'static [[i16; 3]; 4 * PANES]) -> Mesh<'static> {
    let mesh = Mesh::checked(Mesh::quantized(positions, 4, &PANE_FACES));
    Mesh::checked(mesh.with_uvs(&PANE_UVS, None))
}

/// Windows, a little in front of their walls.
pub static WINDOWS: Mesh = {
    static POSITIONS: [[i16; 3]; 4 * PANES] = around(0, 1);
    panes(&POSITIONS)
};

/// The light around windows, a little in front of the windows.
pub static HALOS: Mesh = {
    static POSITIONS: [[i16; 3]; 4 * PANES] = around(9, 2);
    panes(&POSITIONS)
};

/// A box from −1 to 1, for posts and lanterns.
pub static BOX: Mesh = shape!(cuboid(vec3!(1, 1, 1)));
/// Two pyramids base to base, for the caps of lanterns.
pub static CAP: Mesh = shape!(sphere(4, 2));
