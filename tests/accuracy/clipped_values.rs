//! Interpolated values of triangles that the view volume or the guard band clips.

use std::array::from_fn;

use fixel::prelude::*;

use support::bounds::{self, Bound};
use support::drawing::Drawing;
use support::mode::Mode;
use support::moves::{exact, rounded};
use support::random::{Random, cases, sampled, within};
use support::recorder::Seen;
use support::reference::coverage::center;
use support::reference::distance::to_triangle;
use support::reference::linear::IDENTITY;
use support::reference::projection::focal;
use support::reference::raster::{Mesh as ModelMesh, Piece, pieces};
use support::reference::view::{View, Viewport};

const SIZE: (u32, u32) = (160, 96);

/// A little more than the bound of a corner's error. Rounding moves the corner by up to 1/512 pixel along each axis.
/// The error before rounding is far smaller.
const SNAP: f64 = 1. / 256.;

/// A position around the eye.
fn around(random: &mut Random) -> Vec3 {
    rounded(within(random, [-30_f64..30., -30_f64..30., -60_f64..20.]))
}

/// The piece that passes nearest to a pixel's center.
fn nearest<'a>(pieces: &'a [Piece<2>], pixel: [i32; 2]) -> Option<(f64, &'a Piece<2>)> {
    let gap = |piece: &'a Piece<2>| (to_triangle(&piece.screen, center(pixel)), piece);
    pieces.iter().map(gap).min_by(|a, b| a.0.total_cmp(&b.0))
}

/// Checks each pixel center. A pixel must be drawn once if its center is farther inside than a corner can move, and
/// never if its center is farther outside than a corner can move.
fn check_coverage(pieces: &[Piece<2>], seen: &[Seen<2>]) {
    let mut drawn = vec![0; SIZE.0 as usize * SIZE.1 as usize];
    for seen in seen {
        let [x, y] = seen.pixel;
        drawn[usize::try_from(y * 160 + x).unwrap()] += 1;
    }
    for y in 0..96 {
        for x in 0..160 {
            let count = drawn[usize::try_from(y * 160 + x).unwrap()];
            let gap = nearest(pieces, [x, y]).map_or(f64::MAX, |(gap, _)| gap);
            // The limit is twice the distance of the points `around`, which leaves room for the rounding of distances.
            if gap > 2. * SNAP {
                assert_eq!(count, 0, "at {:?}", [x, y]);
                continue;
            }
            let covered = |aside: [f64; 2]| {
                let [x, y] = center([x, y]);
                pieces
                    .iter()
                    .any(|piece| to_triangle(&piece.screen, [x + aside[0], y + aside[1]]) == 0.)
            };
            let around = [[-SNAP, 0.], [SNAP, 0.], [0., -SNAP], [0., SNAP]];
            if around.into_iter().all(covered) && covered([0., 0.]) {
                assert_eq!(count, 1, "at {:?}", [x, y]);
            } else if !around.into_iter().any(covered) {
                assert_eq!(count, 0, "at {:?}", [x, y]);
            }
        }
    }
}

#[test]
fn values_of_clipped_triangles_are_the_models() {
    cases(sampled(500), |random| {
        let positions: [Vec3; 3] = from_fn(|_| around(random));
        let values: [[i32; 3]; 2] =
            from_fn(|_| within(random, [-(4 << 24)..4 << 24, 0..256, 0..1 << 24]));
        let mut drawing = Drawing {
            size: SIZE,
            options: DrawOptions::new().with_cull(Cull::Nothing),
            mode: Mode::Exact,
            mesh: Mesh::new(&positions, &[[0, 1, 2]]).unwrap(),
            mvp: Projection::from_focal_length(fx!(100), SIZE, fx!(0.25), fx!(50)).unwrap()
                * Transform::IDENTITY,
        };
        let view = View {
            eye: IDENTITY,
            projection: focal(100., SIZE, 0.25, 50.),
            viewport: Viewport::new(SIZE.0, SIZE.1),
        };
        let mesh = ModelMesh {
            positions: &positions.map(exact),
            faces: &[[0, 1, 2]],
            attributes: &[[0, 1, 2].map(|corner: usize| values.map(|v| f64::from(v[corner])))],
        };
        let pieces = pieces(&mesh, &view);
        let attributes = |vertex: &Corner<'_>| {
            let corner = positions.iter().position(|&p| p == vertex.position());
            values.map(|value| value[corner.unwrap()])
        };
        let seen = drawing.all(&attributes);

        check_coverage(&pieces, &seen);

        // Clipping can make corners as near as the near plane, or as far as the far plane.
        let w = pieces.iter().flat_map(|piece| piece.w);
        let ends = [w.clone().fold(50., f64::min), w.fold(0.25, f64::max)];
        let mut farthest = [0_f64; SIZE.1 as usize];
        let mut models = Vec::with_capacity(seen.len());
        for seen in &seen {
            let (gap, piece) =
                nearest(&pieces, seen.pixel).expect("the model covers nothing there");
            assert!(gap <= SNAP, "drawn {gap} outside at {:?}", seen.pixel);
            let model = piece.at(seen.pixel).unwrap();
            let row = &mut farthest[usize::try_from(seen.pixel[1]).unwrap()];
            *row = row.max(model.w);
            models.push(model);
        }
        for mode in Mode::PERSPECTIVE {
            drawing.mode = mode;
            let again = drawing.all(&attributes);
            let bounds = values
                .map(|corners| Bound::perspective(mode, corners, [ends[0], ends[1], ends[1]]));
            assert_eq!(again.len(), seen.len());
            for ((seen, model), first) in again.iter().zip(&models).zip(&seen) {
                assert_eq!(seen.pixel, first.pixel);
                let row = usize::try_from(seen.pixel[1]).unwrap();
                for (k, bound) in bounds.iter().enumerate() {
                    let error = (f64::from(seen.values[k]) - model.attributes[k]).abs();
                    let gradient = model.dx[k].hypot(model.dy[k]);
                    // The values of a corner that clipping made are rounded down twice.
                    let bound = SNAP * gradient + 2. + bound.at(model.w, farthest[row]);
                    assert!(
                        error <= bound,
                        "{mode:?}: {:?} gives {} at {:?}, not {}: an error of {error}, over {bound}",
                        positions,
                        seen.values[k],
                        seen.pixel,
                        model.attributes[k],
                    );
                }
                let depth = view.projection.depth(model.w);
                let gradient = model.inverse_w_gradient;
                let moved = SNAP * 65535. * 0.25 * gradient[0].hypot(gradient[1]) + bounds::DEPTH;
                let stored = f64::from(seen.depth);
                assert!(
                    stored <= depth + moved && depth < stored + 1. + moved,
                    "{mode:?}: depth {stored} is not {depth}"
                );
            }
        }
    });
}
