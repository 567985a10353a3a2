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

macro_rules! tuples {
    ($($($Light:ident $light:ident)+;)+) => {$(
        /// The sum of all lights of a tuple. The lights may have different types.
        impl<$($Light: Lighting),+> Lighting for ($($Light,)+) {
            type Diffuse = tuples!(type Diffuse $($Light)+);
            type Specular = tuples!(type Specular $($Light)+);

            const READS_POSITION: bool = $($Light::READS_POSITION)||+;
            const READS_FACE: bool = $($Light::READS_FACE)||+;

            #[inline]
            fn at(&self, point: &SurfacePoint) -> Illumination<Self::Diffuse, Self::Specular> {
                let ($($light,)+) = self;
                tuples!(sum point $($light)+)
            }
        }
    )+};
    (sum $point:ident $last:ident) => { $last.at($point) };
    (sum $point:ident $first:ident $($rest:ident)+) => {
        $first.at($point).plus(tuples!(sum $point $($rest)+))
    };
    (type $Part:ident $Last:ident) => { $Last::$Part };
    (type $Part:ident $First:ident $($Rest:ident)+) => {
        <$First::$Part as Channels>::Or<tuples!(type $Part $($Rest)+)>
    };
}

tuples! {
    A a;
    A a B b;
    A a B b C c;
    A a B b C c D d;
}
