//! The viewport and snapping.

use super::*;
use view::*;

#[test]
fn ndc_to_pixels() {
    let viewport = Viewport {
        x: 10,
        y: 20,
        width: 100,
        height: 50,
    };
    close(viewport.screen([-1., 1.]), [10., 20.]);
    close(viewport.screen([1., -1.]), [110., 70.]);
    close(viewport.screen([0., 0.5]), [60., 32.5]);
}

#[test]
fn the_scenes_focal_length() {
    // The focal length is 200 pixels: x = 160 + 200·x/−z, y = 120 − 200·y/−z.
    let view = View {
        eye: linear::translate([0., 0., -1.]),
        projection: projection::focal(200., (320, 240), 0.25, 100.),
        viewport: Viewport::new(320, 240),
    };
    let p = view.project([0.5, 0.25, -3.]);
    close(p.screen, [160. + 25., 120. - 12.5]);
    close([p.w, p.distance], [4., 4.]);
    close(
        linear::apply_point(&view.matrix(), [0.5, 0.25, -3.]),
        p.clip,
    );
}

#[test]
fn snapping_rounds_to_nearest() {
    assert_eq!(snap([1.5, -1.5]), [384, -384]);
    assert_eq!(snap([0.49 / 256., 0.51 / 256.]), [0, 1]);
    assert_eq!(snap([1e30, -1e30]), [i32::MAX, i32::MIN]);
    close(unsnap([384, -1]), [1.5, -1. / 256.]);
}
