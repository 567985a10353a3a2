//! The largest of many errors.

use fixel::fx;
use support::mode::Mode;

/// The modes that are measured.
pub const MODES: [Mode; 3] = [Mode::NewtonNarrow, Mode::Exact, Mode::Fast(fx!(0.25))];

/// The largest of several errors, with its bound.
#[derive(Clone, Copy, Debug, Default)]
pub struct Worst {
    pub measured: f64,
    pub bound: f64,
}

impl Worst {
    /// Adds an error, which must be within its bound.
    #[track_caller]
    pub fn add(&mut self, error: f64, bound: f64, what: impl FnOnce() -> String) {
        assert!(
            error <= bound,
            "{}: an error of {error}, over {bound}",
            what()
        );
        if error > self.measured || self.bound == 0. {
            *self = Self {
                measured: error,
                bound,
            };
        }
    }

    /// Keeps the larger of two errors.
    pub fn merge(&mut self, other: Self) {
        if other.measured > self.measured || self.bound == 0. {
            *self = other;
        }
    }
}

/// The largest differences between the crate's picture of a mesh and the model's picture.
#[derive(Clone, Copy, Debug, Default)]
pub struct Verdict {
    /// The distance of a corner from its exact position, in pixels. In clipped meshes, how far inside a face the center
    /// of an omitted pixel is, or how far outside a face the center of a drawn pixel is.
    pub coverage: Worst,
    /// The error of a texture coordinate in each of [`MODES`], in texels of a texture of 256 texels.
    pub texels: [Worst; 3],
    /// How far the exact depth is outside the stored step, in steps of the depth buffer.
    pub depth: Worst,
    /// The number of pixels drawn.
    pub pixels: usize,
}

impl Verdict {
    /// Keeps the larger error of each kind, and adds up the pixels.
    pub fn merge(&mut self, other: Self) {
        self.coverage.merge(other.coverage);
        for (worst, other) in self.texels.iter_mut().zip(other.texels) {
            worst.merge(other);
        }
        self.depth.merge(other.depth);
        self.pixels += other.pixels;
    }
}
