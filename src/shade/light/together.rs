//! Several lights at once.

use super::{Gloss, Illumination, Lighting, SurfacePoint, Tint};

/// All lights of an array.
impl<L: Lighting, const N: usize> Lighting for [L; N] {
    type Diffuse = L::Diffuse;
    type Specular = L::Specular;

    const READS_POSITION: bool = L::READS_POSITION;
    const READS_FACE: bool = L::READS_FACE;

    #[inline]
    fn at(&self, point: &SurfacePoint) -> Illumination {
        self.as_slice().at(point)
    }
}

/// All lights of a slice. Its length may change while the program runs.
impl<L: Lighting> Lighting for &[L] {
    type Diffuse = L::Diffuse;
    type Specular = L::Specular;

    const READS_POSITION: bool = L::READS_POSITION;
    const READS_FACE: bool = L::READS_FACE;

    fn at(&self, point: &SurfacePoint) -> Illumination {
        self.iter()
            .map(|light| light.at(point))
            .fold(Illumination::white(0), Illumination::plus)
    }
}

macro_rules! tuples {
    ($($($Light:ident $light:ident)+;)+) => {$(
        /// All lights of a tuple; they may have different types.
        impl<$($Light: Lighting),+> Lighting for ($($Light,)+) {
            type Diffuse = tuples!(Tint Diffuse $($Light)+);
            type Specular = tuples!(Gloss Specular $($Light)+);

            const READS_POSITION: bool = $($Light::READS_POSITION)||+;
            const READS_FACE: bool = $($Light::READS_FACE)||+;

            #[inline]
            fn at(&self, point: &SurfacePoint) -> Illumination {
                let ($($light,)+) = self;
                Illumination::white(0)$(.plus($light.at(point)))+
            }
        }
    )+};
    ($Kind:ident $Part:ident $Last:ident) => { $Last::$Part };
    ($Kind:ident $Part:ident $First:ident $($Rest:ident)+) => {
        <$First::$Part as $Kind>::Or<tuples!($Kind $Part $($Rest)+)>
    };
}

tuples! {
    A a;
    A a B b;
    A a B b C c;
    A a B b C c D d;
}
