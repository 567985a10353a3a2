//! A mesh drawn by the crate and by the model, and the differences between the two pictures.
//!
//! There are two ways to judge a value. If nothing is clipped, the model interpolates between the crate's own snapped
//! corners. If a triangle is clipped, it has new corners, and the crate does not report the new corners. In this case,
//! the value must be one of the model's values within [`Scene::snap`] plus [`Scene::moved`] of the pixel's center. The
//! reason: interpolants are linear on the screen. Let each corner move by at most d. Then the value of the linear
//! function through the moved corners, at any point, is a value of the original function within d of this point. A
//! quotient of two linear functions is monotonic along any line, so its extremes over a square around the center are at
//! the corners of the square.

use std::collections::HashMap;

use fixel::prelude::*;

use super::parts::{gap, nearest, outline};
use super::scene::Scene;
use super::verdict::{MODES, Verdict, Worst};
use support::bounds::{self, Bound};
use support::drawing::{Drawing, Seen};
use support::mode::Mode;
use support::moves::exact;
use support::reference::attributes::{interpolate, weights};
use support::reference::clip::{FAR, NEAR};
use support::reference::coverage::{Bounds, center};
use support::reference::distance::to_segment;
use support::reference::raster::{self, Piece, pieces_clipped};
use support::reference::view;

/// Units of a texture coordinate per texel.
const TEXEL: f64 = 65536.;
/// Half of the guard band's width, in pixels.
const GUARD: f64 = 2048.;
/// Half a subpixel: the largest distance by which snapping moves a corner along each axis.
const SNAP: f64 = 1. / 512.;

/// The bound of the error of clip space, relative to the largest coefficient, for each unit of a coordinate. Rounding
/// adds half a unit of 2⁻²⁹ three times: for the mantissas of the model's matrix, of the projection's matrix, and of
/// their product. Dropping the last bit of the mantissas adds half a unit of 2⁻²⁸.
const CLIP: f64 = 5. / (1 << 30) as f64;

impl Scene {
    /// Draws in each of the measured modes, and judges every pixel of each picture.
    pub fn judge(&self) -> Verdict {
        let mesh = Mesh::new(&self.positions, &self.faces).unwrap();
        let mut drawing = Drawing {
            size: self.size,
            options: self.options,
            mode: Mode::Exact,
            mesh,
            mvp: self.mvp,
        };
        let places = drawing.snapped(&self.positions);
        let pieces = self.pieces();
        let is_whole = places.iter().all(Option::is_some);
        let mut verdict = Verdict::default();
        let judged: Vec<Piece<2>> = if is_whole {
            let at = |index: usize| places[index].unwrap();
            self.corners(&places, &mut verdict.coverage);
            let snap = |piece: &Piece<2>| piece.snap(|source, _| at(source.unwrap()));
            pieces.iter().map(snap).collect()
        } else {
            pieces
        };
        let values = |vertex: &Corner<'_>| self.texels[self.index(vertex.position())];
        let first = drawing.all(&values);
        verdict.pixels = first.len();
        if is_whole {
            self.exact_coverage(&first, &judged);
        } else {
            self.coverage(&first, &judged, &mut verdict.coverage);
        }
        let models = self.models(&first, &judged);
        let ends = self.ends(&judged);
        for (mode, worst) in MODES.into_iter().zip(&mut verdict.texels) {
            drawing.mode = mode;
            let seen = drawing.all(&values);
            let pixels = |seen: &[Seen<2>]| -> Vec<_> {
                seen.iter()
                    .map(|seen| (seen.face, seen.pixel, seen.depth))
                    .collect()
            };
            assert_eq!(pixels(&seen), pixels(&first), "{mode:?} differs");
            let bounds: Vec<_> = (0..self.faces.len())
                .map(|face| {
                    let [near, far] = ends[face];
                    let texels = self.corner_texels(face);
                    texels.map(|corners| Bound::perspective(mode, corners, [near, far, far]))
                })
                .collect();
            for (seen, (piece, about)) in seen.iter().zip(&models) {
                if let Some(about) = about {
                    self.values(mode, seen, piece, about, &bounds[seen.face], worst);
                }
            }
        }
        for (seen, (_, about)) in first.iter().zip(&models) {
            if let Some(about) = about {
                self.depth(seen, about, ends[seen.face], &mut verdict.depth);
            }
        }
        verdict
    }

    /// The parts of each face inside the view volume and the guard band.
    pub fn pieces(&self) -> Vec<Piece<2>> {
        let positions: Vec<_> = self.positions.iter().map(|&p| exact(p)).collect();
        let faces: Vec<_> = self
            .faces
            .iter()
            .map(|face| face.map(usize::from))
            .collect();
        let texels = |index: usize| self.texels[index].map(f64::from);
        let attributes: Vec<_> = faces.iter().map(|face| face.map(texels)).collect();
        let mesh = raster::Mesh {
            positions: &positions,
            faces: &faces,
            attributes: &attributes,
        };
        let viewport = self.view.viewport;
        let side = |pixels: u32| f64::from(pixels) / 2. / GUARD;
        let (x, y) = (side(viewport.width), side(viewport.height));
        let sides = [
            [x, 0., 0., 1.],
            [-x, 0., 0., 1.],
            [0., y, 0., 1.],
            [0., -y, 0., 1.],
        ];
        pieces_clipped(&mesh, &self.view, &[&[NEAR, FAR], &sides[..]].concat())
    }

    /// The largest distance, in pixels, by which rounding in clip space moves a point of a clipped triangle at the
    /// distance `w`. This distance is the error relative to `w`, times half of the guard band's width.
    fn moved(&self, w: f64) -> f64 {
        GUARD * self.off(w)
    }

    /// The bound of the error of clip space for a clipped triangle, relative to `w`.
    fn off(&self, w: f64) -> f64 {
        CLIP * self.sums.iter().copied().fold(0., f64::max) / w
    }

    /// The largest bound of the error of clip space at a corner, for triangles that are not clipped.
    fn off_at_corners(&self) -> f64 {
        let parts = self.positions.iter().zip(&self.sums);
        let parts = parts.map(|(&p, sum)| sum / self.view.project(exact(p)).w);
        CLIP * parts.fold(0., f64::max)
    }

    /// The largest distance by which snapping moves a corner along an axis: half a subpixel. At the right and lower
    /// sides of the guard band, this distance is a whole subpixel, because the position is rounded down to the last
    /// subpixel.
    fn snap(&self, piece: &Piece<2>) -> f64 {
        if piece.screen.into_iter().any(|corner| self.is_last(corner)) {
            2. * SNAP
        } else {
            SNAP
        }
    }

    /// Whether a point is at the right or the lower side of the guard band.
    fn is_last(&self, [x, y]: [f64; 2]) -> bool {
        let view::Viewport {
            x: left,
            y: top,
            width,
            height,
        } = self.view.viewport;
        let last = |at: f64, first: i32, pixels: u32| {
            at - f64::from(first) - f64::from(pixels) / 2. > GUARD - 2. * SNAP
        };
        last(x, left, width) || last(y, top, height)
    }

    /// Measures the distances between snapped corners and their exact positions, along each axis.
    fn corners(&self, places: &[Option<[i32; 2]>], worst: &mut Worst) {
        for ((&position, sum), place) in self.positions.iter().zip(&self.sums).zip(places) {
            let wanted = self.view.project(exact(position));
            let place = place.unwrap().map(|at| f64::from(at) / 256.);
            let snap = if self.is_last(wanted.screen) {
                2. * SNAP
            } else {
                SNAP
            };
            for (at, wanted_at) in place.into_iter().zip(wanted.screen) {
                let what = || format!("{position:?} at {place:?}, not {:?}", wanted.screen);
                let moved = GUARD * CLIP * sum / wanted.w;
                worst.add((at - wanted_at).abs(), snap + moved, what);
            }
        }
    }

    /// With the same snapped corners, the crate must cover the same pixels as the model.
    fn exact_coverage(&self, seen: &[Seen<2>], pieces: &[Piece<2>]) {
        let mut drawn: Vec<_> = seen.iter().map(|seen| (seen.face, seen.pixel)).collect();
        drawn.sort_unstable();
        let bounds = self.bounds();
        let mut model: Vec<_> = pieces
            .iter()
            .flat_map(|piece| {
                let pixels = bounds.around(&piece.screen, 0.).pixels();
                pixels.filter(|&p| piece.covers(p)).map(|p| (piece.face, p))
            })
            .collect();
        model.sort_unstable();
        assert_eq!(drawn, model);
    }

    /// The pixels inside both the canvas and the viewport.
    fn bounds(&self) -> Bounds {
        let viewport = self.view.viewport;
        Bounds::new(self.size.0, self.size.1).intersect(Bounds {
            left: viewport.x,
            top: viewport.y,
            right: viewport.x + viewport.width.cast_signed(),
            bottom: viewport.y + viewport.height.cast_signed(),
        })
    }

    /// Checks that a pixel is drawn once if its center is farther inside a face than the corners can move, and is not
    /// drawn if its center is farther outside than that.
    fn coverage(&self, seen: &[Seen<2>], pieces: &[Piece<2>], worst: &mut Worst) {
        let mut drawn: HashMap<(usize, [i32; 2]), usize> = HashMap::new();
        for seen in seen {
            *drawn.entry((seen.face, seen.pixel)).or_default() += 1;
        }
        for (&(face, pixel), &times) in &drawn {
            assert_eq!(times, 1, "{pixel:?} of {face} is drawn again");
            let own = pieces.iter().filter(|piece| piece.face == face);
            let Some((piece, gap)) = nearest(own, center(pixel)) else {
                panic!("{pixel:?} of {face} is drawn, but the model covers nothing");
            };
            let reach = self.edge_reach(piece);
            worst.add(gap, reach, || {
                format!("{pixel:?} outside face {face}: {self:?}")
            });
        }
        for face in pieces.chunk_by(|a, b| a.face == b.face) {
            let index = face[0].face;
            let outline = outline(face);
            for piece in face {
                for pixel in self.bounds().around(&piece.screen, 0.).pixels() {
                    let p = center(pixel);
                    if drawn.contains_key(&(index, pixel)) || gap(piece, p) > 0. {
                        continue;
                    }
                    let depth = outline
                        .iter()
                        .map(|&[a, b]| to_segment(a, b, p))
                        .fold(f64::MAX, f64::min);
                    let reach = self.edge_reach(piece);
                    worst.add(depth, reach, || {
                        format!("{pixel:?} inside face {index}, not drawn: {self:?}")
                    });
                }
            }
        }
    }

    /// The largest distance by which an edge moves at right angles to its direction.
    fn edge_reach(&self, piece: &Piece<2>) -> f64 {
        let nearest = piece.w.into_iter().fold(f64::MAX, f64::min);
        (self.snap(piece) + self.moved(nearest)) * 2_f64.sqrt()
    }

    /// The model's values within reach of a pixel's center; `None` if a part of this area lies beyond the horizon.
    fn about(&self, piece: &Piece<2>, pixel: [i32; 2]) -> Option<About> {
        if piece.snapped.is_some() {
            let value = piece.at(pixel)?;
            return Some(About::new(value.w, value.attributes));
        }
        let [x, y] = center(pixel);
        let at = |[dx, dy]: [f64; 2]| {
            let weights = weights(&piece.screen, [x + dx, y + dy])?;
            let value = interpolate(&weights, piece.w, &piece.attributes);
            (value.w > 0. && value.w.is_finite()).then_some(value)
        };
        let middle = at([0., 0.])?;
        let r = self.snap(piece) + self.moved(middle.w);
        let mut about = About::new(middle.w, middle.attributes);
        for corner in [[-r, -r], [r, -r], [-r, r], [r, r]] {
            let value = at(corner)?;
            for (range, value) in about.values.iter_mut().zip(value.attributes) {
                widen(range, value);
            }
            widen(&mut about.inverse_w, 1. / value.w);
        }
        Some(about)
    }

    /// For each drawn pixel: the part of the face to which it belongs, and the model's values around the pixel.
    fn models<'a>(
        &self,
        seen: &[Seen<2>],
        pieces: &'a [Piece<2>],
    ) -> Vec<(&'a Piece<2>, Option<About>)> {
        let mut farthest: HashMap<(usize, i32), f64> = HashMap::new();
        let off_at_corners = self.off_at_corners();
        let ends = self.ends(pieces);
        let mut models: Vec<_> = seen
            .iter()
            .map(|seen| {
                let own = pieces.iter().filter(|piece| piece.face == seen.face);
                let (piece, _) = nearest(own, center(seen.pixel)).unwrap();
                let about = self.about(piece, seen.pixel).map(|about| About {
                    off: match piece.snapped {
                        Some(_) => off_at_corners,
                        None => self.off(ends[seen.face][0]),
                    },
                    ..about
                });
                let row = farthest.entry((seen.face, seen.pixel[1])).or_default();
                *row = about.as_ref().map_or(*row, |about| row.max(about.w));
                (piece, about)
            })
            .collect();
        for (seen, (_, about)) in seen.iter().zip(&mut models) {
            if let Some(about) = about {
                about.farthest = farthest[&(seen.face, seen.pixel[1])];
            }
        }
        models
    }

    /// The smallest and the largest w of each face's pieces.
    fn ends(&self, pieces: &[Piece<2>]) -> Vec<[f64; 2]> {
        let mut ends = vec![[f64::MAX, 0.]; self.faces.len()];
        for piece in pieces {
            for w in piece.w {
                widen(&mut ends[piece.face], w);
            }
        }
        ends
    }

    /// The u of a face's three corners, and the v of its three corners.
    fn corner_texels(&self, face: usize) -> [[i32; 3]; 2] {
        let corners = self.faces[face].map(usize::from);
        [0, 1].map(|k| corners.map(|corner| self.texels[corner][k]))
    }

    fn values(
        &self,
        mode: Mode,
        seen: &Seen<2>,
        piece: &Piece<2>,
        about: &About,
        bounds: &[Bound; 2],
        worst: &mut Worst,
    ) {
        let all = self.corner_texels(seen.face).into_iter().zip(bounds);
        for (k, (corners, bound)) in all.enumerate() {
            let [least, most] = about.values[k];
            let value = f64::from(seen.values[k]);
            let error = (least - value).max(value - most).max(0.);
            let formats = bound.at(about.w, about.farthest);
            // Clipping rounds a new corner's attribute down twice, and its weight to 2⁻³⁰ at each of six planes. The
            // attribute also has the relative error of w in clip space, at both ends of the clipped edge.
            let [a, b, c] = corners.map(i32::unsigned_abs);
            let size = f64::from(a.max(b).max(c));
            let cut = match piece.snapped {
                Some(_) => 0.,
                None => 2. + 12. * size / 2_f64.powi(30),
            };
            let off = 2. * size * about.off;
            worst.add(error / TEXEL, (formats + cut + off) / TEXEL, || {
                let at = seen.pixel;
                format!("{mode:?}: {value} at {at:?}, not {least} to {most}: {self:?}")
            });
        }
    }

    fn depth(&self, seen: &Seen<2>, about: &About, [near, far]: [f64; 2], worst: &mut Worst) {
        let scale = 65535. * self.view.projection.near;
        let [least, most] = about.inverse_w.map(|q| q * scale);
        let stored = f64::from(seen.depth);
        let bound = bounds::depth([near, far, far]) + 2. * most * about.off;
        let error = (stored - most).max(least - stored - 1.).max(0.);
        worst.add(error, bound, || {
            let at = seen.pixel;
            format!("depth {stored} at {at:?}, not {least} to {most}: {self:?}")
        });
    }
}

/// The model's values around a pixel.
struct About {
    w: f64,
    /// The greatest w of the face's pixels in the same row.
    farthest: f64,
    /// The bound of the relative error of w.
    off: f64,
    /// The smallest and the largest value of each attribute around the pixel.
    values: [[f64; 2]; 2],
    inverse_w: [f64; 2],
}

impl About {
    fn new(w: f64, values: [f64; 2]) -> Self {
        Self {
            w,
            farthest: w,
            off: 0.,
            values: values.map(|value| [value; 2]),
            inverse_w: [1. / w; 2],
        }
    }
}

fn widen([least, most]: &mut [f64; 2], value: f64) {
    *least = least.min(value);
    *most = most.max(value);
}
