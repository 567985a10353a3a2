//! Helpers for the model's tests: shapes and comparisons.

use super::*;

/// f64 has a relative error of 2⁻⁵² ≈ 2e-16. The error of some hundred operations on values up to a thousand is far
/// smaller than this.
pub const EPSILON: f64 = 1e-9;

#[track_caller]
pub fn close(a: impl AsRef<[f64]>, b: impl AsRef<[f64]>) {
    let (a, b) = (a.as_ref(), b.as_ref());
    assert_eq!(a.len(), b.len());
    let same = a.iter().zip(b).all(|(a, b)| (a - b).abs() < EPSILON);
    assert!(same, "{a:?} is not {b:?}");
}

#[track_caller]
pub fn close_matrix(a: &Matrix, b: &Matrix) {
    close(a.concat(), b.concat());
}

/// A sequence of pseudo-random numbers: the upper bits of a linear congruential generator (Knuth's MMIX).
pub struct Random(pub u64);

impl Random {
    fn below(&mut self, n: u64) -> u64 {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % n
    }

    pub fn range(&mut self, low: i32, high: i32) -> i32 {
        low + i32::try_from(self.below(u64::try_from(high - low).unwrap())).unwrap()
    }
}

/// A closed torus about the y axis, with faces counter-clockwise as seen from outside, and u and v in turns.
pub struct Torus {
    pub positions: Vec<[f64; 3]>,
    pub faces: Vec<[usize; 3]>,
    pub attributes: Vec<[[f64; 2]; 3]>,
}

impl Torus {
    pub fn new(around: usize, tube: usize) -> Self {
        let turn = |i: usize, n: usize| i as f64 / n as f64;
        let positions = (0..around * tube)
            .map(|i| {
                let (u, v) = (turn(i / tube, around), turn(i % tube, tube));
                let (su, cu) = (u * std::f64::consts::TAU).sin_cos();
                let (sv, cv) = (v * std::f64::consts::TAU).sin_cos();
                let radius = 1. + 0.4 * cv;
                [radius * cu, 0.4 * sv, -radius * su]
            })
            .collect();
        let index = |i: usize, j: usize| (i % around) * tube + j % tube;
        let (mut faces, mut attributes) = (Vec::new(), Vec::new());
        for i in 0..around {
            for j in 0..tube {
                let corners = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)];
                for [a, b, c] in [[0, 1, 2], [0, 2, 3]] {
                    let face = [corners[a], corners[b], corners[c]];
                    faces.push(face.map(|(i, j)| index(i, j)));
                    attributes.push(face.map(|(i, j)| [turn(i, around), turn(j, tube)]));
                }
            }
        }
        Self {
            positions,
            faces,
            attributes,
        }
    }

    pub fn mesh(&self) -> raster::Mesh<'_, 2> {
        raster::Mesh {
            positions: &self.positions,
            faces: &self.faces,
            attributes: &self.attributes,
        }
    }

    /// A tilted view. The far side of the torus is partly behind its near side.
    pub fn view(size: (u32, u32)) -> view::View {
        view::View {
            eye: linear::multiply(&linear::translate([0., 0., -4.]), &linear::rotate_x(0.3)),
            projection: projection::focal(f64::from(size.1), size, 0.25, 100.),
            viewport: view::Viewport::new(size.0, size.1),
        }
    }
}
