//! Values along a projected segment.

use super::*;
use lines::*;

#[test]
fn depths_fractions_and_values() {
    close([depth(1., 4., 0.5)], [1.6]);
    close([fraction_in_space(1., 4., 0.5)], [0.2]);
    close([fraction_on_screen(1., 4., 0.2)], [0.5]);
    for (w0, w1) in [(1., 4.), (3., 0.25), (2., 2.)] {
        for q in [0., 0.1, 0.5, 0.9, 1.] {
            let g = homogeneous_fraction(w0, w1, q);
            close([g], [fraction_in_space(w0, w1, q)]);
            close([interpolate(-3., 7., w0, w1, q)], [lerp(-3., 7., g)]);
            close([interpolate(w0, w1, w0, w1, q)], [depth(w0, w1, q)]);
        }
    }
}

#[test]
fn a_line_from_behind_the_eye() {
    // The segment runs from (−1, 0), two units behind the eye, to (1, 0), eight units ahead of the eye. The near plane
    // is at 2, so the segment is clipped at 0.4 of its length, at x = −0.2.
    let view = view::View {
        eye: linear::IDENTITY,
        projection: projection::frustum(-2., 2., -2., 2., 2., 10.),
        viewport: view::Viewport::new(100, 100),
    };
    let end = |x: f64, z: f64, a: f64| clip::ClipVertex {
        position: view.clip([x, 0., z]),
        attributes: [a],
        source: None,
    };
    let line = Line::new([end(-1., 2., 0.), end(1., -8., 10.)], &view).unwrap();
    close(line.w, [2., 8.]);
    close(line.attributes.concat(), [4., 10.]);
    // x' = 50 + 50x/w: 45 and 56.25.
    close(line.screen.concat(), [45., 50., 56.25, 50.]);
    // Halfway on the screen, 1/w = (1/2 + 1/8)/2, so w = 3.2, a = 5.2, and x = 0.04.
    let half = line.at(0.5);
    close([half.w, half.distance, half.attributes[0]], [3.2, 3.2, 5.2]);
    close(half.screen, [50. + 50. * 0.04 / 3.2, 50.]);
    close([line.fraction_at(0, 50.625)], [0.5]);
    close(
        [line.closest([50.625, 3.]), line.closest([0., 0.])],
        [0.5, 0.],
    );
    assert_eq!(Line::new([end(-1., 2., 0.), end(1., 1., 1.)], &view), None);
}
