//! Things that stand on the map, except blocks: roofs, windows and lamps.

use embedded_graphics::pixelcolor::Rgb888;
use fixel::Index;
use fixel::prelude::*;

use super::{light, map};

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
    #[allow(clippy::type_complexity)] // it is written here alone
    static CORNERS: ([[i16; 3]; 70], [Vec2; 70], [Rgb888; 70], [[Index; 3]; 30]) = {
        let mut positions = [[0; 3]; 70];
        let mut uvs = [vec2!(0, 0); 70];
        let mut colors = [Rgb888::new(0, 0, 0); 70];
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
                    // How steep the slope is, and to which side it falls.
                    let (rise, run) = (rise as i32, inset as i32);
                    let normal = [
                        [0, run, rise],
                        [0, run, -rise],
                        [rise, run, 0],
                        [-rise, run, 0],
                    ];
                    let place = [x as i32, y as i32, z as i32];
                    colors[first + corner] = light::at(place, Some(normal[slope]));
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
        (positions, uvs, colors, faces)
    };
    let mesh = Mesh::checked(Mesh::quantized(&CORNERS.0, 4, &CORNERS.3));
    Mesh::checked(Mesh::checked(mesh.with_uvs(&CORNERS.1, None)).with_colors(&CORNERS.2, None))
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
    static POSITIONS: [[i16; 3]; 4 * PANES] = around(4, 2);
    panes(&POSITIONS)
};

const COUNT: usize = map::LAMPS.len();

/// The parts of a lamp: half their width at their lower and at their upper end, the heights of these ends, in 128ths of
/// a unit, and their color.
const PARTS: [([i16; 2], [i16; 2], Rgb888); 4] = [
    ([6, 6], [0, 180], IRON),
    ([13, 13], [180, 216], FLAME),
    ([24, 0], [216, 240], IRON),
    ([0, 24], [206, 216], IRON),
];
const FLAME: Rgb888 = Rgb888::new(255, 226, 150);
/// Iron in the dusk.
const IRON: Rgb888 = Rgb888::new(18, 15, 27);

/// A lamp on the map.
pub fn lamp(lamp: usize) -> Mesh<'static> {
    const FACES: usize = 8 * PARTS.len();
    LAMPS.part(FACES * lamp..FACES * (lamp + 1))
}

/// The lamps on the map. Each part has four sides.
static LAMPS: Mesh = {
    const LENGTH: usize = COUNT * PARTS.len();
    static CORNERS: (
        [[i16; 3]; 8 * LENGTH],
        [Rgb888; 8 * LENGTH],
        [[Index; 3]; 8 * LENGTH],
    ) = {
        let mut positions = [[0; 3]; 8 * LENGTH];
        let mut colors = [FLAME; 8 * LENGTH];
        let mut faces = [[0; 3]; 8 * LENGTH];
        let mut at = 0;
        while at < 8 * LENGTH {
            let (widths, heights, color) = PARTS[at / 8 % PARTS.len()];
            let [x, _, z] = map::LAMPS[at / 8 / PARTS.len()].to_bits();
            // Four corners below, and four above.
            let (corner, end) = (at % 4, at / 4 % 2);
            let half = widths[end];
            positions[at] = [
                (x >> 9) as i16
                    + if corner == 1 || corner == 2 {
                        half
                    } else {
                        -half
                    },
                heights[end],
                (z >> 9) as i16 + if corner < 2 { half } else { -half },
            ];
            colors[at] = color;
            let first = at / 8 * 8;
            let [left, right] = [first + corner, first + (corner + 1) % 4];
            faces[at] = if end == 0 {
                [left as Index, right as Index, right as Index + 4]
            } else {
                [left as Index, right as Index + 4, left as Index + 4]
            };
            at += 1;
        }
        (positions, colors, faces)
    };
    let mesh = Mesh::checked(Mesh::quantized(&CORNERS.0, 7, &CORNERS.2));
    Mesh::checked(mesh.with_colors(&CORNERS.1, None))
};
