//! Implements `defmt::Format` for numbers, which are logged as decimals, and for types that contain numbers.

use defmt::{Debug2Format, Display2Format, Format, Formatter};

use crate::error::Error;
use crate::math::{Matrix4, Vec2, Vec3};
use crate::mesh::Shape;
use crate::num::{Angle, Fraction, Scalar, Subpixel, TexCoord};
use crate::pipeline::{Hit, ScreenPoint};
use crate::raster::PointStyle;
use crate::textbook::Segment;
use crate::view::{Projection, ProjectionKind, Window};

macro_rules! format {
    ($adapter:ident: $($({$K:ident: $bound:path})? $Type:ty),+) => {$(
        impl$(<$K: $bound>)? Format for $Type {
            fn format(&self, f: Formatter<'_>) {
                defmt::write!(f, "{}", $adapter(self));
            }
        }
    )+};
}

format!(Display2Format: Error, Angle, Scalar, TexCoord, Subpixel, Fraction, Vec2, Vec3);
format!(Debug2Format: Hit, Matrix4, PointStyle, ScreenPoint, Segment, Shape<'_>, Window, {K: ProjectionKind} Projection<K>);

#[cfg(test)]
mod tests {
    use super::*;
    use crate::canvas::{Biased, ColorIndex, Contrast, NoTest, TestAndWrite, TestOnly, WriteOnly};
    use crate::mesh::{Counts, Missing};
    use crate::mode::{Affine, Compact, Exact, Fast, Newton};
    use crate::shade::{Colored, PerFace, Shiny, Texels, Tolerance, TwoSided, Within};
    use crate::texture::{Bilinear, Nearest};
    use crate::{Camera, Cull, DrawOptions, Drawn, Fragment, Light, Mvp, Rate};
    use crate::{LineStyle, Transform, Viewport, math::Direction, view::Aspect};

    const fn logs<T: Format>() {}

    /// Compiles only if every type that a program may want to log implements `Format`.
    #[test]
    fn values_can_be_logged() {
        logs::<(Error, Scalar, TexCoord, Subpixel, Fraction, Angle, Rate)>();
        logs::<(Vec2, Vec3, Direction, Matrix4, Transform, Counts, Missing)>();
        logs::<(
            Shape,
            Fragment,
            Light,
            Tolerance,
            Texels,
            Within<8, Texels>,
            PerFace<u8>,
        )>();
        logs::<(Colored<Light>, Shiny<Light>, TwoSided<Light>)>();
        logs::<(
            LineStyle,
            LineStyle<true>,
            PointStyle,
            Drawn,
            DrawOptions,
            ScreenPoint,
            Cull,
        )>();
        logs::<(Exact, Affine, Newton, Fast, Compact, ColorIndex, Contrast)>();
        logs::<(
            NoTest,
            TestAndWrite,
            TestOnly,
            WriteOnly,
            Biased,
            Nearest,
            Bilinear,
        )>();
        logs::<(Aspect, Camera, Mvp, Projection, Segment, Viewport, Window)>();
    }
}
