//! Light in a color.

use super::{Diffuse, Illumination, Lighting, SurfacePoint};

/// A light in a color; see [`Lighting::colored`].
#[doc(hidden)]
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Colored<L> {
    pub(super) light: L,
    /// Red, green and blue, in units of 2⁻¹⁶.
    pub(super) color: [i32; 3],
}

impl<L: Lighting> Lighting for Colored<L> {
    type Diffuse = [i32; 3];
    type Specular = L::Specular;

    const READS_POSITION: bool = L::READS_POSITION;
    const READS_FACE: bool = L::READS_FACE;

    #[inline]
    fn at(&self, point: &SurfacePoint) -> Illumination<[i32; 3], L::Specular> {
        let light = self.light.at(point);
        let [r, g, b] = light.diffuse.rgb();
        let [red, green, blue] = self.color;
        Illumination {
            diffuse: [share(r, red), share(g, green), share(b, blue)],
            specular: light.specular,
        }
    }
}

/// The product of two numbers in units of 2⁻¹⁶, the second at most 1; rounded down.
#[inline]
pub(super) fn share(light: i32, part: i32) -> i32 {
    ((i64::from(light) * i64::from(part)) >> 16) as i32
}
