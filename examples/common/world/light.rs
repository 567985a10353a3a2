//! The light of the dusk and of the lamps, which the compiler bakes into the colors of vertices.

use embedded_graphics::pixelcolor::Rgb888;

use super::map::LAMPS;

/// A place in sixteenths of a unit.
pub type Place = [i32; 3];

/// The light of the evening sky comes from the west: the direction, in units of its length.
const DUSK_FROM: [i32; 3] = unit([-12, 10, 4]);
const DUSK: [i32; 3] = [150, 140, 215];
/// The light of all lamps: the lamps on the map, and one lamp above the door.
const LAMPLIGHT: [i32; 3] = [255, 172, 82];
/// The place, the brightness in 256ths and the range of the lamp above the door, and the two of the others.
const DOOR: (Place, i32, i32) = ([160, 27, 93], 230, 80);
const LAMP: (i32, i32) = (256, 104);

/// A direction of length 4,096.
const fn unit([x, y, z]: [i32; 3]) -> [i32; 3] {
    let length = ((x * x + y * y + z * z) as u32).isqrt() as i32;
    [x * 4096 / length, y * 4096 / length, z * 4096 / length]
}

/// The light on a surface at a place, by the direction of its normal. Something without a normal, such as a plant, is lit
/// by all lamps, and by half of the sky.
pub const fn at(place: Place, normal: Option<[i32; 3]>) -> Rgb888 {
    // In 256ths of a light.
    let facing = match normal {
        Some(normal) => dot(unit(normal), DUSK_FROM) >> 12,
        None => 1024,
    };
    let dusk = 97 + ((97 * max(facing, 0)) >> 12);
    let mut lamps = lamp(DOOR.0, DOOR.1, DOOR.2, place, normal);
    let mut at = 0;
    while at < LAMPS.len() {
        let [x, y, z] = LAMPS[at].to_bits();
        lamps += lamp([x >> 12, y >> 12, z >> 12], LAMP.0, LAMP.1, place, normal);
        at += 1;
    }
    let mut light = [0; 3];
    let mut channel = 0;
    while channel < 3 {
        let sum = (DUSK[channel] * dusk + LAMPLIGHT[channel] * lamps) >> 8;
        light[channel] = if sum > 255 { 255 } else { sum as u8 };
        channel += 1;
    }
    Rgb888::new(light[0], light[1], light[2])
}

/// The light of a lamp in 256ths: it falls to 0 at its range.
const fn lamp(
    from: Place,
    brightness: i32,
    range: i32,
    to: Place,
    normal: Option<[i32; 3]>,
) -> i32 {
    let way = [from[0] - to[0], from[1] - to[1], from[2] - to[2]];
    let square = dot(way, way);
    if square >= range * range {
        return 0;
    }
    let facing = match normal {
        Some(normal) => dot(unit(normal), unit(way)) >> 12,
        None => 2048,
    };
    let left = 256 - 256 * square / (range * range);
    (((brightness * left * left) >> 16) * max(facing, 0)) >> 12
}

const fn dot(a: [i32; 3], b: [i32; 3]) -> i32 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

const fn max(a: i32, b: i32) -> i32 {
    if a > b { a } else { b }
}
