//! Several lights at once.

use super::{Illumination, Lighting, SurfacePoint};
use crate::shade::Channels;

/// The sum of all lights of an array.
impl<L: Lighting, const N: usize> Lighting for [L; N] {
    type Diffuse = L::Diffuse;
    type Specular = L::Specular;

    const READS_POSITION: bool = L::READS_POSITION;
    const READS_FACE: bool = L::READS_FACE;

    #[inline]
    fn at(&self, point: &SurfacePoint) -> Illumination<L::Diffuse, L::Specular> {
        self.as_slice().at(point)
    }
}

/// The sum of all lights of a slice. The number of lights may change while the program runs.
impl<L: Lighting> Lighting for &[L] {
    type Diffuse = L::Diffuse;
    type Specular = L::Specular;

    const READS_POSITION: bool = L::READS_POSITION;
    const READS_FACE: bool = L::READS_FACE;

    fn at(&self, point: &SurfacePoint) -> Illumination<L::Diffuse, L::Specular> {
        let mut sum = Illumination::default();
        for light in *self {
            sum = sum.join(light.at(point));
        }
        sum
    }
}

/// The sum of both lights, which may have different types.
impl<A: Lighting, B: Lighting> Lighting for (A, B) {
    type Diffuse = <A::Diffuse as Channels>::Or<B::Diffuse>;
    type Specular = <A::Specular as Channels>::Or<B::Specular>;

    const READS_POSITION: bool = A::READS_POSITION || B::READS_POSITION;
    const READS_FACE: bool = A::READS_FACE || B::READS_FACE;

    #[inline]
    fn at(&self, point: &SurfacePoint) -> Illumination<Self::Diffuse, Self::Specular> {
        let (a, b) = self;
        a.at(point).plus(b.at(point))
    }
}

/// The sum of all three lights.
impl<A: Lighting, B: Lighting, C: Lighting> Lighting for (A, B, C) {
    type Diffuse = <((A, B), C) as Lighting>::Diffuse;
    type Specular = <((A, B), C) as Lighting>::Specular;

    const READS_POSITION: bool = <((A, B), C)>::READS_POSITION;
    const READS_FACE: bool = <((A, B), C)>::READS_FACE;

    #[inline]
    fn at(&self, point: &SurfacePoint) -> Illumination<Self::Diffuse, Self::Specular> {
        let (a, b, c) = self;
        a.at(point).plus(b.at(point)).plus(c.at(point))
    }
}

/// The sum of all four lights.
impl<A: Lighting, B: Lighting, C: Lighting, D: Lighting> Lighting for (A, B, C, D) {
    type Diffuse = <((A, B, C), D) as Lighting>::Diffuse;
    type Specular = <((A, B, C), D) as Lighting>::Specular;

    const READS_POSITION: bool = <((A, B, C), D)>::READS_POSITION;
    const READS_FACE: bool = <((A, B, C), D)>::READS_FACE;

    #[inline]
    fn at(&self, point: &SurfacePoint) -> Illumination<Self::Diffuse, Self::Specular> {
        let (a, b, c, d) = self;
        let three = a.at(point).plus(b.at(point)).plus(c.at(point));
        three.plus(d.at(point))
    }
}
