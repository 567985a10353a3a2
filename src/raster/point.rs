//! Points: one pixel each.

use super::block::Block;
use super::{Barycentric, Patch, Rasterizer, ScreenVertex};

/// Draws the pixel that contains a point. `barycentric` is the point's place in the mesh's triangle, once for each
/// vertex of the patch.
#[inline]
pub(crate) fn point(
    raster: &mut Rasterizer<'_>,
    at: &ScreenVertex,
    barycentric: Option<&[Barycentric; 3]>,
) {
    let scissor = raster.scissor;
    // Written without `map`, because `map` stays a loop in a build for size.
    let [x, y] = at.screen;
    let [x, y] = [x >> 8, y >> 8];
    if scissor.columns.contains(&x) && scissor.rows.contains(&y) {
        set_up(raster, at, barycentric).draw_alone(y, &(x..x + 1));
    }
}

/// Sets up interpolants that have a point's values everywhere.
#[inline]
pub(super) fn set_up<'r>(
    raster: &'r mut Rasterizer<'_>,
    at: &ScreenVertex,
    barycentric: Option<&[Barycentric; 3]>,
) -> Block<'r> {
    if !raster.coloring.varies {
        return raster.set_up(&Patch::EVEN);
    }
    raster.set_up(&Patch {
        vertices: [at; 3],
        barycentric,
        ..Patch::EVEN
    })
}

#[cfg(test)]
mod tests {
    use super::super::Scissor;
    use super::*;
    use crate::fixtures::picture::{Picture, vertex};

    /// Draws points, each over the points before it.
    fn drawn(places: &[[i32; 2]], scissor: &Scissor) -> Picture {
        let mut picture = Picture::new(5, 3);
        for &place in places {
            picture.draw(scissor, |raster| point(raster, &vertex(place), None));
        }
        picture
    }

    #[test]
    fn a_border_belongs_to_the_pixel_on_its_right_and_below() {
        let whole = Picture::new(5, 3).scissor();
        // Two points at the first and the last place in pixel (1, 1), and a point on the border between two pixels.
        let picture = drawn(&[[256, 256], [511, 511], [768, 511]], &whole);
        picture.assert(&[".....", ".!.#.", "....."]);
        assert_eq!(picture.spans[2], (1, 3..4));
    }

    #[test]
    fn nothing_is_drawn_beyond_the_scissor() {
        let scissor = Scissor {
            columns: 1..4,
            rows: 1..2,
        };
        let all = (-1..6).flat_map(|x| (-1..4).map(move |y| [x * 256 + 255, y * 256]));
        let places: std::vec::Vec<_> = all.collect();
        drawn(&places, &scissor).assert(&[".....", ".###.", "....."]);
    }
}
