//! Points of a size.

use super::call::Call;
use super::{Drawn, run};
use crate::num::block::{self, BlockFloat};
use crate::num::wide::product;
use crate::raster::{self, Blitter, PointStyle};
use crate::view::{Projection, ProjectionKind, Viewport};

/// Half the size of points, in units of 1/256 pixel.
pub(super) enum HalfSize {
    /// All have the same.
    Equal(i64),
    /// A mantissa · 2^-exponent over the distance, in units of the near plane's.
    OverDistance(i32, i32),
}

impl HalfSize {
    /// Half the size of points in this style, drawn to a viewport.
    #[inline(never)]
    pub(super) fn new<K: ProjectionKind>(
        style: PointStyle,
        projection: &Projection<K>,
        viewport: &Viewport,
    ) -> Self {
        let size = BlockFloat::new(style.size().to_bits().into(), 16);
        if !style.is_attenuated() {
            return Self::Equal(BlockFloat::new(size.value, 16 - 7).at(0));
        }
        // A unit of world space at distance 1 takes `scale` halves of the viewport's height.
        let [_, row] = &projection.rows;
        let [_, scale, ..] = row.m;
        let height = viewport.size().height;
        let size = size
            .times(BlockFloat::new(scale.into(), row.exp))
            .times(BlockFloat::new(height.into(), 2));
        if K::PERSPECTIVE {
            let near = BlockFloat::new(projection.near.to_bits().into(), 16);
            let (mantissa, exp) = size.over(near).rounded();
            Self::OverDistance(mantissa, exp)
        } else {
            Self::Equal(block::shift(size.value, 8 - size.exp))
        }
    }
}

/// Draws all positions of a mesh as squares or discs.
#[inline(never)]
pub(super) fn sized_points<K: ProjectionKind>(
    call: &Call<'_, K>,
    half: &HalfSize,
    is_round: bool,
    blitter: &mut dyn Blitter,
) -> Drawn {
    run::each_point(call, blitter, |raster, at| {
        let half = match *half {
            HalfSize::Equal(half) => half,
            HalfSize::OverDistance(mantissa, exp) => {
                // near / w = q · 2^(exponent − 16 − shift), as for the depth.
                let shift = i32::from(at.exponent) - 16 - call.projector.depth_shift().0 - exp;
                block::shift(product(mantissa, at.q.cast_signed()), shift + 8)
            }
        };
        raster::sized_point(raster, at, half, is_round);
    })
}
