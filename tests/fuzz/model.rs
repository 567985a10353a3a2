//! Compares the pixels of triangles with the f64 model.
//!
//! If all corners of a triangle are visible, the corners that the crate reports determine exactly which pixels the
//! triangle covers, whatever the scene's numbers are. Values at these pixels are compared if the model knows the
//! model-view-projection.

use embedded_graphics::pixelcolor::Rgb565;
use fixel::prelude::{Cull, DrawOptions, Vec3, Viewport};

use super::call::Call;
use super::knowledge::Knowledge;
use support::bounds::{self, Bound};
use support::mode::Mode;
use support::moves::exact;
use support::recorder::{Record, Seen};
use support::reference::attributes::at_pixel_snapped;
use support::reference::coverage::{Bounds, Snapped, area2, center, covered_in, covers_f64};
use support::reference::distance::to_triangle;
use support::reference::raster::{Mesh, Piece, pieces_clipped};

/// The largest ratio of distances within a triangle for which the modes promise a largest error.
const MOST_RATIO: f64 = 128.;
/// The largest relative error of a distance for which values are compared. With this error, a corner is still within a
/// thousandth of a pixel of the model's corner.
const MOST_ERROR: f64 = 1. / 65536.;
/// Depths are compared only if the bound on their error is at most this, in steps of depth.
const MOST_DEPTH_ERROR: f64 = 4.;
/// A bound on the error that the scale of depths causes, in steps of depth. Relative to the depth, which is below
/// 65536, the error is at most 2⁻²⁸: 2⁻³⁰ each from the reciprocals of the distance and of the near plane, and from the
/// scale of 65536.
const DEPTH_SCALE: f64 = 65536. / (1 << 28) as f64;

/// The triangles of a scene for which the model knows the exact result.
pub struct Truth {
    /// For each triangle of the mesh: its corners, if all corners are visible.
    whole: Vec<Option<Whole>>,
    /// For each other triangle: its visible part, if the model knows enough about the triangle.
    clipped: Vec<Option<Clipped>>,
    window: Bounds,
    cull: Cull,
}

/// A triangle that is not clipped.
struct Whole {
    screen: Snapped,
    ahead: Option<Ahead>,
}

/// The distances of a triangle's corners.
#[derive(Clone, Copy)]
struct Ahead {
    parallel: bool,
    w: [f64; 3],
    depth: [f64; 3],
    /// A bound on the relative error of w.
    w_error: f64,
    /// A bound on the error of a depth before the depth is rounded down.
    depth_error: f64,
}

impl Truth {
    pub fn new<K: fixel::view::ProjectionKind>(call: &Call<'_, K>, options: &DrawOptions) -> Self {
        let (width, height) = call.scene.size;
        let whole = Viewport::new(0, 0, width, height).unwrap();
        let screen = options.viewport.unwrap_or(whole);
        let window = call.window;
        let moves = call.scene.eye.moves().zip(call.scene.model.moves());
        let moves = moves.map(|(eye, model)| [eye, model].concat());
        let projection = call.scene.projection.model(call.scene.size);
        let place = |index: u16| {
            let position = call.mesh.positions().get(index.into()).unwrap();
            let place = screen.project(position, &call.mvp)?;
            Some([place.x.to_bits(), place.y.to_bits()])
        };
        let whole = |&[a, b, c]: &[u16; 3]| {
            Some(Whole {
                screen: [place(a)?, place(b)?, place(c)?],
                ahead: moves.as_ref().and_then(|moves| {
                    let corners = [a, b, c].map(|i| call.mesh.positions().get(i.into()).unwrap());
                    Knowledge::new(moves, &projection, window, corners).ahead()
                }),
            })
        };
        let faces = call.mesh.faces();
        let whole: Vec<_> = faces.iter().map(whole).collect();
        let clipped = faces.iter().zip(&whole).map(|(face, whole)| {
            let corners = face.map(|i| call.mesh.positions().get(i.into()).unwrap());
            let unknown = whole.is_some() || call.scene.cull != Cull::Nothing;
            let moves = moves.as_ref().filter(|_| !unknown)?;
            Clipped::new(
                &Knowledge::new(moves, &projection, window, corners),
                corners,
            )
        });
        Self {
            clipped: clipped.collect(),
            whole,
            window: Bounds::new(width, height).intersect(Bounds {
                left: window.top_left().x,
                top: window.top_left().y,
                right: window.top_left().x + window.size().width.cast_signed(),
                bottom: window.top_left().y + window.size().height.cast_signed(),
            }),
            cull: match call.scene.cull {
                Cull::Back if call.scene.mirrors() => Cull::Front,
                Cull::Front if call.scene.mirrors() => Cull::Back,
                cull => cull,
            },
        }
    }

    /// Compares the pixels that were recorded in a mode with the model.
    pub fn check<const N: usize>(&self, mode: Mode, record: &Record<N, Rgb565>) {
        // The pixels of a face directly follow each other.
        let mut faces = record.seen.chunk_by(|a, b| a.face == b.face).peekable();
        for (face, whole) in self.whole.iter().enumerate() {
            let seen = faces
                .next_if(|seen| seen[0].face == face)
                .unwrap_or_default();
            let mut pixels: Vec<[i32; 2]> = seen.iter().map(|seen| seen.pixel).collect();
            pixels.sort_unstable_by_key(|&[x, y]| (y, x));
            let once = pixels.windows(2).all(|pair| pair[0] != pair[1]);
            assert!(once, "{mode:?}: a pixel is drawn twice in triangle {face}");
            if let Some(clipped) = &self.clipped[face] {
                clipped.check(mode, self.window, &pixels);
            }
            let Some(whole) = whole else { continue };
            let keeps = match area2(whole.screen) {
                0 => false,
                area => match self.cull {
                    Cull::Nothing => true,
                    Cull::Back => area < 0,
                    Cull::Front => area > 0,
                },
            };
            let expected: Vec<[i32; 2]> = if keeps {
                covered_in(whole.screen, self.window).collect()
            } else {
                Vec::new()
            };
            assert!(
                pixels == expected,
                "{mode:?}: triangle {face} at {:?} covers {pixels:?}, not {expected:?}",
                whole.screen
            );
            let corners = record.corners.iter().find(|(at, _)| *at == face);
            if let (Some(ahead), Some((_, corners))) = (whole.ahead, corners) {
                ahead.compare(mode, whole.screen, seen, corners);
            }
        }
        assert!(faces.next().is_none(), "faces are not in order");
    }
}

impl Ahead {
    /// Compares values and depths at a triangle's pixels.
    fn compare<const N: usize>(
        &self,
        mode: Mode,
        screen: Snapped,
        seen: &[Seen<N, Rgb565>],
        corners: &[[i32; N]; 3],
    ) {
        let attributes = corners.map(|corner| corner.map(f64::from));
        let divides = !self.parallel && !matches!(mode, Mode::Affine);
        let weights = if divides { self.w } else { [1.; 3] };
        let at = |pixel| at_pixel_snapped(screen, weights, &attributes, pixel).unwrap();
        let bounds: [Bound; N] = std::array::from_fn(|k| {
            let corners = corners.map(|corner| corner[k]);
            if divides {
                Bound::perspective(mode, corners, self.w).plus(self.moved(corners))
            } else {
                Bound::parallel(mode, corners)
            }
        });
        for row in seen.chunk_by(|a, b| a.pixel[1] == b.pixel[1]) {
            let farthest = row.iter().map(|seen| at(seen.pixel).w);
            let farthest = farthest.fold(0., f64::max);
            for seen in row {
                let model = at(seen.pixel);
                for (k, &got) in seen.values.iter().enumerate() {
                    let corners = corners.map(|corner| corner[k]);
                    let bound = bounds[k].at(model.w, farthest);
                    let error = (f64::from(got) - model.attributes[k]).abs();
                    assert!(
                        error <= bound,
                        "{mode:?}: {corners:?} at {:?} on {screen:?} gives {got} at {:?}, not {}: an error of {error}, over {bound}",
                        self.w,
                        seen.pixel,
                        model.attributes[k],
                    );
                }
                self.compare_depth(mode, screen, seen.pixel, seen.depth);
            }
        }
    }

    /// The largest change of a value that the errors of the corners' distances w can cause.
    ///
    /// If each w has a relative error of ε, the barycentric weights change by at most 2ε/(1 − ε). The value then
    /// changes by at most this fraction of its range over the corners.
    fn moved(&self, corners: [i32; 3]) -> f64 {
        let [a, b, c] = corners;
        let spread = a.max(b).max(c).abs_diff(a.min(b).min(c));
        2. * self.w_error / (1. - self.w_error) * f64::from(spread)
    }

    fn compare_depth(&self, mode: Mode, screen: Snapped, pixel: [i32; 2], stored: u16) {
        let corners = self.depth.map(|depth| [depth]);
        let value = at_pixel_snapped(screen, [1.; 3], &corners, pixel).unwrap();
        let ([depth], stored) = (value.attributes, f64::from(stored));
        let allowed = bounds::depth(self.w) + self.depth_error;
        assert!(
            stored <= depth + allowed && depth < stored + 1. + allowed,
            "{mode:?}: depth {stored} at {pixel:?} is not {depth}, within {allowed}"
        );
    }
}

impl Knowledge {
    /// The distances of the corners; `None` if their errors or the ratio between them are too large.
    fn ahead(&self) -> Option<Ahead> {
        let most = |of: &dyn Fn(usize) -> f64| of(0).max(of(1)).max(of(2));
        let w = self.at.map(|at| at.w);
        let depth = self.at.map(|at| self.view.projection.depth(at.distance));
        let (w_error, depth_error) = if self.is_parallel() {
            (0., most(&|i| self.of_depth(i) * 65536.))
        } else {
            let of_itself = most(&|i| self.of_depth(i) / w[i]);
            (of_itself, of_itself * most(&|i| depth[i]))
        };
        let [least, greatest] = [w.into_iter().fold(f64::MAX, f64::min), most(&|i| w[i])];
        let known = (0. ..=MOST_ERROR).contains(&w_error) && depth_error <= MOST_DEPTH_ERROR;
        (known && greatest <= MOST_RATIO * least).then_some(Ahead {
            parallel: self.is_parallel(),
            w,
            depth,
            w_error,
            depth_error: depth_error + DEPTH_SCALE,
        })
    }
}

/// The visible part of a clipped triangle.
struct Clipped {
    /// Pixels in this part must be drawn, except next to the part's outline.
    inner: Vec<Piece<0>>,
    /// Only pixels in this part can be drawn.
    outer: Vec<Piece<0>>,
    /// A bound on the outline's error, in pixels.
    margin: f64,
}

/// A little more than the bound of a corner's error: rounding moves the corner by up to 1/512 pixel along each axis.
const SNAP: f64 = 1. / 256.;
/// A triangle is not compared if its errors other than [`SNAP`] are larger than this, in pixels.
const MOST_MOVED: f64 = 1. / 64.;
/// If the distances of a pixel and of the near or the far plane differ by less than this factor, the pixel may be drawn
/// or not. The crate's planes deviate by 2⁻¹⁶ plus rounding.
const CLOSE: f64 = 1.01;

impl Clipped {
    fn new(knowledge: &Knowledge, corners: [Vec3; 3]) -> Option<Self> {
        let moved = knowledge.of_place();
        if knowledge.is_parallel() || moved > MOST_MOVED || moved.is_nan() {
            return None;
        }
        let positions = corners.map(exact);
        let mesh = Mesh {
            positions: &positions,
            faces: &[[0, 1, 2]],
            attributes: &[[[]; 3]],
        };
        let pieces =
            |near, far| pieces_clipped(&mesh, &knowledge.view, &knowledge.planes(near, far));
        Some(Self {
            inner: pieces(CLOSE, 1. / CLOSE),
            outer: pieces(1. / CLOSE, CLOSE),
            margin: SNAP + moved,
        })
    }

    /// Checks the pixels of a triangle. The pixels are in row order.
    fn check(&self, mode: Mode, window: Bounds, drawn: &[[i32; 2]]) {
        let diagonal = 2_f64.sqrt() * self.margin;
        let around = [
            [0., 0.],
            [-diagonal, 0.],
            [diagonal, 0.],
            [0., -diagonal],
            [0., diagonal],
        ];
        let mut drawn = drawn.iter().peekable();
        for pixel in window.pixels() {
            let is_drawn = drawn.next_if(|at| **at == pixel).is_some();
            let [x, y] = center(pixel);
            let must = || {
                around.iter().all(|[right, down]| {
                    let at = [x + right, y + down];
                    self.inner.iter().any(|piece| covers_f64(&piece.screen, at))
                })
            };
            let may = || {
                let mut pieces = self.outer.iter();
                pieces.any(|piece| to_triangle(&piece.screen, [x, y]) <= self.margin)
            };
            assert!(
                !is_drawn || may(),
                "{mode:?}: {pixel:?} is outside a clipped triangle"
            );
            assert!(
                is_drawn || !must(),
                "{mode:?}: {pixel:?} is missing in a clipped triangle"
            );
        }
    }
}
