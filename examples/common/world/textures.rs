//! Textures, which the compiler paints.

use embedded_graphics::pixelcolor::Rgb565;
use fixel::texture::Argb1555;

/// A number from 0 to 255 that looks random, but is always the same for the same arguments.
const fn hash(x: u32, y: u32, seed: u32) -> u32 {
    let mut h =
        x.wrapping_mul(0x9e37_79b1) ^ y.wrapping_mul(0x85eb_ca77) ^ seed.wrapping_mul(0xc2b2_ae3d);
    h = (h ^ h >> 15).wrapping_mul(0x2c1b_3c6d);
    h = (h ^ h >> 12).wrapping_mul(0x297a_2d39);
    (h ^ h >> 15) & 255
}

/// Smooth noise from 0 to 255, in cells of 2^`log2` texels. The noise repeats after 2^`period` texels.
const fn noise(x: u32, y: u32, log2: u32, period: u32, seed: u32) -> u32 {
    let (cell, mask) = (1 << log2, (1 << (period - log2)) - 1);
    let (column, row) = (x >> log2, y >> log2);
    let (right, below) = (x & (cell - 1), y & (cell - 1));
    let upper = hash(column & mask, row & mask, seed) * (cell - right)
        + hash((column + 1) & mask, row & mask, seed) * right;
    let lower = hash(column & mask, (row + 1) & mask, seed) * (cell - right)
        + hash((column + 1) & mask, (row + 1) & mask, seed) * right;
    (upper * (cell - below) + lower * below) >> (2 * log2)
}

/// A color times a brightness, at most white. A brightness of 256 leaves the color unchanged.
const fn shaded([r, g, b]: [u32; 3], light: u32) -> [u8; 3] {
    let (r, g, b) = (r * light / 256, g * light / 256, b * light / 256);
    [
        if r > 255 { 255 } else { r as u8 },
        if g > 255 { 255 } else { g as u8 },
        if b > 255 { 255 } else { b as u8 },
    ]
}

pub type Tile = [[Rgb565; 64]; 64];

/// A texture of 64x64 texels. The expression computes the color of a texel from its column `$x` and its row `$y`.
macro_rules! tile {
    (|$x:ident, $y:ident| $color:expr) => {{
        #[allow(long_running_const_eval)]
        const TEXELS: Tile = {
            let mut texels = [[Rgb565::new(0, 0, 0); 64]; 64];
            let mut at = 0_u32;
            while at < 64 * 64 {
                let ($x, $y) = (at % 64, at / 64);
                let [r, g, b]: [u8; 3] = $color;
                texels[$y as usize][$x as usize] = Rgb565::new(r >> 3, g >> 2, b >> 3);
                at += 1;
            }
            texels
        };
        TEXELS
    }};
}

pub static GRASS: Tile = tile!(|x, y| {
    // Blades are higher than they are wide.
    let blade = hash(x, y / 3 + hash(x, 0, 9) % 5, 1) / 2 + hash(x, y, 2) / 4;
    let patch = noise(x, y, 4, 6, 3);
    shaded([78 + patch / 8, 118, 62], 100 + blade + patch / 4)
});

pub static GRAVEL: Tile = tile!(|x, y| {
    let pebble = hash(x / 2, y / 2 + x / 2 % 2, 4) / 3 + hash(x, y, 5) / 3;
    shaded([196, 178, 152], 110 + pebble + noise(x, y, 4, 6, 6) / 8)
});

/// Slabs of two sizes, in rows.
pub static PAVING: Tile = tile!(|x, y| {
    let (row, along) = (y / 16, (x + y / 16 * 13) % 64);
    let (slab, edge) = if along < 36 {
        (0, along)
    } else {
        (1, along - 36)
    };
    let joint = edge == 0 || y % 16 == 0;
    let rim = edge == 1 || y % 16 == 1;
    let light = 170 + hash(slab, row, 7) / 4 + noise(x, y, 2, 6, 8) / 8 + hash(x, y, 33) / 9;
    shaded(
        [204, 194, 186],
        if joint {
            96
        } else if rim {
            light + 24
        } else {
            light
        },
    )
});

/// Rows of blocks with light upper edges and dark joints. Every other row is shifted by half a block.
pub static STONE: Tile = tile!(|x, y| {
    let (row, shift) = (y / 12, y / 12 % 2 * 8 + y / 24 * 5);
    let (along, down) = ((x + shift) % 16, y % 12);
    let block = hash((x + shift) % 64 / 16, row, 10);
    let grain = noise(x, y, 2, 6, 11) / 6 + hash(x, y, 12) / 10;
    let light = match (along, down) {
        (0, _) | (_, 0) => 92,
        (1, _) | (_, 1) => 250,
        (15, _) | (_, 11) => 150,
        _ => 178 + block / 5,
    };
    shaded([190, 176, 166], light - 20 + grain)
});

/// Plaster between timbers.
pub static PLASTER: Tile = tile!(|x, y| {
    let brace = (x + 64 - y) % 64 < 4 && y > 32;
    if y < 5 || x % 32 < 4 || brace {
        shaded([112, 78, 58], 150 + noise(x, y, 1, 6, 13) / 3)
    } else {
        shaded([226, 204, 168], 205 + noise(x, y, 3, 6, 14) / 6)
    }
});

pub static HEDGE: Tile = tile!(|x, y| {
    let leaf = noise(x, y, 1, 6, 15);
    shaded(
        [64, 118, 58],
        70 + leaf / 2 + hash(x, y, 16) / 4 + noise(x, y, 3, 6, 17) / 3,
    )
});

pub static WATER: Tile = tile!(|x, y| {
    let wave = noise(x, y, 4, 6, 18) + noise((x + y) % 64, y, 3, 6, 19);
    let crest = wave.abs_diff(255) / 2;
    let light = 30_u32.saturating_sub(crest);
    [20 + light as u8, 34 + light as u8, 62 + light as u8]
});

/// A roof of slates.
pub static SLATE: Tile = tile!(|x, y| {
    let (row, down) = (y / 8, y % 8);
    let along = (x + row % 2 * 4) % 8;
    let slate = hash((x + row % 2 * 4) / 8 % 8, row, 31) / 3;
    let light = if along == 0 || down == 7 {
        90
    } else {
        150 + slate + down * 6
    };
    shaded([150, 128, 138], light)
});

/// A leaded window with a round arch. Light comes from inside.
pub static WINDOW: [[Argb1555; 16]; 32] = {
    let mut texels = [[Argb1555::HOLE; 16]; 32];
    let mut at = 0_u32;
    while at < 16 * 32 {
        let (x, y) = (at % 16, at / 16);
        let (aside, above) = ((2 * x).abs_diff(15), 15_u32.saturating_sub(2 * y));
        let from_middle = aside * aside + above * above;
        if from_middle < 256 {
            let frame = from_middle > 170 || aside > 12 || y > 29;
            let lead = x % 5 == 0 || y % 6 == 5;
            let light = 31 - aside / 4 - (y.abs_diff(18)) / 5;
            texels[y as usize][x as usize] = match (frame, lead) {
                (true, _) => Argb1555::new(9, 7, 6),
                (_, true) => Argb1555::new(18, 9, 3),
                _ => Argb1555::new(light as u8, light as u8 * 3 / 4, light as u8 * 3 / 8),
            };
        }
        at += 1;
    }
    texels
};

/// A plant, from its size in texels, the color of its leaves, and an expression that computes the brightness of a texel
/// from its column `$x` and its row `$y`. A brightness of 0 makes a hole.
macro_rules! plant {
    ($width:literal x $height:literal, $leaf:expr, |$x:ident, $y:ident| $light:expr) => {{
        #[allow(long_running_const_eval)]
        const TEXELS: [[Argb1555; $width]; $height] = {
            let mut texels = [[Argb1555::HOLE; $width]; $height];
            let mut at = 0_u32;
            while at < $width * $height {
                let ($x, $y) = (at % $width, at / $width);
                let light: u32 = $light;
                if light > 0 {
                    let [r, g, b] = shaded($leaf, light);
                    texels[$y as usize][$x as usize] = Argb1555::new(r / 8, g / 8, b / 8);
                }
                at += 1;
            }
            texels
        };
        TEXELS
    }};
}

/// A spindle of dense needles.
pub static CYPRESS: [[Argb1555; 32]; 128] = plant!(32 x 128, [70, 112, 72], |x, y| {
    let aside = (2 * x).abs_diff(31);
    // The tree is wide in its lower third, and pointed at the top.
    let wide = if y < 90 { y * 28 / 90 } else { 28 - (y - 90) / 6 };
    let ragged = hash(x / 2, y / 4, 20) / 40 + hash(x, y, 21) / 90;
    if y > 122 && aside < 4 {
        90
    } else if y <= 124 && aside + ragged < wide + 3 {
        let side = if 2 * x > 31 { 24 } else { 0 };
        80 + hash(x, y / 3, 22) / 2 + noise(x, y, 2, 7, 23) / 3 + side - aside
    } else {
        0
    }
});

/// A round crown of leaves in tufts, on a trunk.
pub static TREE: [[Argb1555; 64]; 64] = plant!(64 x 64, [86, 124, 60], |x, y| {
    let (aside, up) = ((2 * x).abs_diff(63), (2 * y).abs_diff(44));
    let tuft = noise(x, y, 3, 6, 24) + noise(x, y, 2, 6, 25) / 2 + hash(x, y, 26) / 3;
    let crown = (aside * aside) + up * up * 2;
    if crown + tuft * 7 < 4600 {
        let top = 44_u32.saturating_sub(y);
        60 + tuft / 4 + top * 3 + hash(x, y, 27) / 6
    } else if y > 30 && aside < 5 + y / 30 {
        70
    } else {
        0
    }
});

/// The upper halves of these two.
pub static TREETOP: &[[Argb1555; 64]; 32] = TREE.first_chunk().unwrap();
pub static CYPRESS_TOP: &[[Argb1555; 32]; 64] = CYPRESS.first_chunk().unwrap();

/// A bush with blossoms.
pub static BUSH: [[Argb1555; 32]; 32] = plant!(32 x 32, [92, 120, 74], |x, y| {
    let (aside, up) = ((2 * x).abs_diff(31), 62 - 2 * y);
    let tuft = noise(x, y, 2, 5, 28) + hash(x, y, 29) / 4;
    if aside * aside + up * up * 2 / 3 + tuft * 2 < 1250 {
        if hash(x / 2, y / 2, 30) > 236 { 480 } else { 70 + tuft / 2 + (31 - y) * 2 }
    } else {
        0
    }
});

type Glow = [[Rgb565; 32]; 32];

/// A glow: in its middle, it has this color, and it fades toward its edge, where it is less than a step of the color. The
/// core of a lamp is much brighter.
const fn glow([r, g, b]: [u32; 3], has_core: bool) -> Glow {
    let mut texels = [[Rgb565::new(0, 0, 0); 32]; 32];
    let mut at = 0_u32;
    while at < 32 * 32 {
        let (x, y) = ((2 * (at % 32)).abs_diff(31), (2 * (at / 32)).abs_diff(31));
        let square = x * x + y * y;
        let light = fading(square) + if has_core { fading(3 * square) } else { 0 };
        let [r, g, b] = [(r * light) >> 16, (g * light) >> 16, (b * light) >> 16];
        texels[at as usize / 32][at as usize % 32] = Rgb565::new(r as u8, g as u8, b as u8);
        at += 1;
    }
    texels
}

/// The light at the square of a distance, of which the edge has 31²: from 0 to 2^16. It would be 0 at 36².
const fn fading(square: u32) -> u32 {
    let inside = 1296_u32.saturating_sub(square);
    inside * inside / 26
}

pub static GLOW: Glow = glow([15, 18, 5], false);
pub static LAMPLIGHT: Glow = glow([15, 19, 6], true);
/// The light around the moon.
pub static HALO: Glow = glow([7, 15, 10], false);

/// The moon, with its seas.
pub static MOON: [[Argb1555; 32]; 32] = plant!(32 x 32, [236, 230, 214], |x, y| {
    let (across, down) = ((2 * x).abs_diff(31), (2 * y).abs_diff(31));
    if across * across + down * down < 900 {
        let seas = noise(x, y, 3, 5, 32);
        if seas > 140 { 262 - seas / 4 } else { 262 }
    } else {
        0
    }
});
