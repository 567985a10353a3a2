//! A shader with colors that depend on every bit of its input.

use embedded_graphics::pixelcolor::Rgb565;
use fixel::Primitive;
use fixel::prelude::*;

use support::recorder::{Coordinates, Few};

/// A shader with colors that depend on every bit of up to three values. The shader discards some pixels.
///
/// The first two values are texture coordinates in their whole range. The third value jumps between the ends of its
/// format.
#[derive(Clone, Copy, Debug)]
pub struct Bits<const N: usize>;

impl<const N: usize> Shader for Bits<N>
where
    [(); N]: Few<N>,
{
    type Color = Rgb565;
    type Varyings = Coordinates<N>;

    fn varyings(&self, primitive: &Primitive<'_>) -> [Coordinates<N>; 3] {
        primitive.corners(|corner| {
            let [u, v] = corner.uv().to_bits();
            let far = corner.position().y.to_bits() & 0x1000 == 0;
            let all = [u, v, if far { i32::MIN } else { i32::MAX }];
            Coordinates(std::array::from_fn(|i| all[i]))
        })
    }

    fn shade(&self, at: &Fragment, Coordinates(values): Coordinates<N>) -> Option<Rgb565> {
        let [x, y] = [at.point.x, at.point.y];
        let rest = [x, y, i32::from(at.depth)];
        let mix = values
            .iter()
            .chain(&rest)
            .fold(0x811c_9dc5_u32, |mix, &value| {
                (mix ^ value.cast_unsigned())
                    .wrapping_mul(0x0100_0193)
                    .rotate_left(7)
            });
        let [red, green, blue, holes] = mix.to_be_bytes();
        (holes > 5).then_some(Rgb565::new(red, green, blue))
    }
}
