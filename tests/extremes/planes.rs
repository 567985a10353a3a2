//! The eye and the planes before and behind it.

use fixel::prelude::*;

use crate::judge::{Scene, Verdict};
use crate::moves::{exact, quantised};
use crate::reference::linear::IDENTITY;
use crate::reference::projection::focal;
use crate::reference::view::{View, Viewport};
use crate::table::{Cases, Row, picture};

const SIZE: (u32, u32) = (160, 120);
const NEAR: f64 = 0.25;
const FAR: f64 = 100.;

/// A triangle of a texture of 256 texels before the eye.
fn scene(corners: [[f64; 3]; 3]) -> Scene {
    let positions = corners.map(quantised).to_vec();
    let sum = |p: &Vec3| exact(*p).map(f64::abs).iter().sum::<f64>();
    Scene {
        size: SIZE,
        viewport: None,
        sum: positions.iter().map(sum).fold(0., f64::max),
        positions,
        faces: vec![[0, 1, 2]],
        texels: vec![[0, 0], [256 << 16, 0], [0, 256 << 16]],
        chain: Projection::from_focal_length(fx!(100), SIZE, fx!(0.25), fx!(100)).unwrap().into(),
        view: View {
            eye: IDENTITY,
            lens: focal(100., SIZE, NEAR, FAR),
            viewport: Viewport::new(SIZE.0, SIZE.1),
        },
    }
}

/// Each corner first, which is the one that a clipped triangle's fan is about.
fn judge(corners: [[f64; 3]; 3]) -> Verdict {
    let mut verdict = Verdict::default();
    let [a, b, c] = corners;
    for corners in [[a, b, c], [b, c, a], [c, a, b]] {
        verdict.merge(scene(corners).judge());
    }
    verdict
}

/// What cuts a plane with so many corners on the other side, at many slopes.
fn crossing(behind: usize) -> Verdict {
    let mut verdict = Verdict::default();
    for step in 0..24 {
        let s = f64::from(step);
        let ahead = [[-1.5, -0.5 - s / 40., -2.], [1.2, -0.9, -3. - s], [s / 20. - 0.5, 1.1, -1.5]];
        let beyond = [[-0.7, -0.3, 0.1 + s], [0.8 + s / 4., -0.4, 3.], [0.1, 0.6, -0.125]];
        let corner = |i: usize| if i < behind { beyond[i] } else { ahead[i] };
        verdict.merge(judge([corner(0), corner(1), corner(2)]));
    }
    verdict
}

/// In planes that the eye lies in, or next to it: on the screen they are a line, or beside the eye all of it.
fn through_the_eye() -> Verdict {
    let mut verdict = Verdict::default();
    for step in 0..32 {
        let turn = f64::from(step) / 32. * std::f64::consts::TAU;
        let (sin, cos) = turn.sin_cos();
        for off in [0., 1. / 65536., 0.25] {
            let at = |along: f64, z: f64| [along * cos - off * sin, along * sin + off * cos, z];
            verdict.merge(judge([at(-4., -8.), at(5., -6.), at(0.5, 7.)]));
            verdict.merge(judge([at(0., 0.), at(3., -8.), at(-4., -8.)]));
        }
    }
    verdict
}

/// With corners and sides on the near plane, and wholly in it.
fn on_the_plane() -> Verdict {
    let mut verdict = Verdict::default();
    verdict.merge(judge([[0., 0.1, -NEAR], [-2., -1., -4.], [2., -1., -5.]]));
    verdict.merge(judge([[-0.2, 0.1, -NEAR], [0.15, 0.12, -NEAR], [0.3, -1., -5.]]));
    verdict.merge(judge([[-0.2, 0.1, -NEAR], [0.15, 0.12, -NEAR], [0.1, -0.1, -NEAR]]));
    verdict
}

pub static CASES: Cases = Cases::new(|| {
    let crossings = [1, 2].map(|behind| {
        picture(&format!("{behind} of 3 corners behind the near plane"), crossing(behind))
    });
    crossings
        .into_iter()
        .chain([
            picture("planes through the eye, or 2⁻¹⁶ beside it", through_the_eye()),
            picture("corners, sides, triangles on the near plane", on_the_plane()),
        ])
        .collect::<Vec<Row>>()
});

#[test]
fn planes_are_cut_where_the_model_cuts_them() {
    assert_eq!(CASES.len(), 4);
}

/// Nothing of what is behind is drawn, however near.
#[test]
fn all_behind_is_nothing() {
    assert_eq!(crossing(3).pixels, 0);
}
