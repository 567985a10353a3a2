//! A scene drawn by the crate and by the model, and all differences between the two pictures.

use std::collections::HashMap;

use fixel::prelude::*;
use fixel::view::Perspective;

use crate::bounds::Bound;
use crate::drawing::{Drawing, Seen};
use crate::mode::Mode;
use crate::moves::{Move, exact, product, rounded};
use crate::reference::attributes::Value;
use crate::reference::coverage::{Bounds, center};
use crate::reference::raster::{self, Piece, culled, pieces};
use crate::reference::scenes::{SIZE, Shape, view};
use crate::reference::silhouette::{self, Silhouette};
use crate::reference::view::View;
use crate::spread::Spread;

/// The side of the texture, in texels.
const TEXELS: f64 = 256.;
/// Fraction bits of the interpolated u and v: 4 more than in a vertex.
const UV_BITS: i32 = 24;
/// The largest rounding error of a vertex's u or v, in texels.
pub const ROUNDING: f64 = TEXELS / (2 << TexCoord::FRAC_BITS) as f64;
/// A little more than the bound of a vertex's error, in pixels: rounding moves the vertex by up to 1/512 pixel along
/// each axis.
const SNAP: f64 = 1. / 256.;

/// A shape and its transforms to the picture, both in the crate's numbers and in the model's numbers.
pub struct Scene {
    positions: Vec<Vec3>,
    faces: Vec<[u16; 3]>,
    uvs: Vec<Vec2>,
    uv_faces: Vec<[u16; 3]>,
    /// The texture coordinates before rounding.
    unrounded: Vec<[[f64; 2]; 3]>,
    mvp: Mvp<Perspective>,
    /// The shape in the model's numbers.
    shape: Shape,
    view: View,
}

/// The differences between the crate's pixels and the model's pixels. Unless noted, the model uses the crate's snapped
/// vertices.
pub struct Comparison {
    /// Pixels drawn, including hidden ones.
    pub pixels: Vec<Seen<3>>,
    /// Errors of u and v, in texels.
    pub snapped: Spread,
    /// Errors of u and v, in texels, compared with texture coordinates that were not rounded to the crate's format.
    pub unrounded: Spread,
    /// Errors of u and v, in texels, if the model uses its own vertices.
    pub unsnapped: Spread,
    /// The part of `unsnapped` that exceeds 1/256 pixel times the gradient of the texels.
    pub excess: Spread,
    /// Errors of the distance, in units of 2⁻¹⁶.
    pub distance: Spread,
    /// Errors of u, v and distance, divided by the bounds of the formats.
    pub allowed: Spread,
    /// How far the exact depth lies outside the stored step, in steps.
    pub depth: Spread,
    /// How far the visible surface lies behind the nearest surface, in steps of depth.
    pub order: Spread,
    pub coverage: Coverage,
}

/// The differences in coverage, which are the same in all modes.
#[derive(Clone, Copy, Debug, Default)]
pub struct Coverage {
    /// In how many cases only the crate, or only the model, draws a pixel of a triangle.
    pub not_alike: usize,
    /// Of the pixels with centers more than 1/256 pixel inside the silhouette: how many were never drawn, drawn once,
    /// and drawn more often.
    pub inside: [usize; 3],
    /// Of the pixels with centers more than 1/256 pixel outside the silhouette: how many were drawn.
    pub outside: usize,
}

/// The model's values at the drawn pixels, in drawing order. All modes are compared with these values.
struct Model {
    drawn: Vec<(usize, [i32; 2])>,
    /// Values with the crate's snapped vertices.
    snapped: Vec<Value<2>>,
    /// Values with the crate's snapped vertices, and texture coordinates that were not rounded to the crate's format.
    unrounded: Vec<Value<2>>,
    /// Values with the model's own vertices.
    unsnapped: Vec<Value<2>>,
    /// The distance of the farthest pixel of each face in each row.
    farthest: HashMap<(usize, i32), f64>,
    coverage: Coverage,
    /// The model's faces, with the crate's snapped vertices.
    pieces: Vec<Piece<2>>,
}

impl Scene {
    /// Makes a scene of a shape after some moves. Every number is rounded to the nearest number of the crate's format.
    pub fn new(shape: &Shape, moves: &[Move]) -> Self {
        let positions: Vec<Vec3> = shape.positions.iter().map(|&p| rounded(p)).collect();
        let uvs: Vec<Vec2> = shape
            .uvs
            .iter()
            .flatten()
            .map(|&[u, v]| {
                Vec2::new(
                    TexCoord::try_from(u).unwrap(),
                    TexCoord::try_from(v).unwrap(),
                )
            })
            .collect();
        let index = |i: usize| u16::try_from(i).unwrap();
        let (transform, eye) = product(moves);
        let projection =
            Projection::from_focal_length(fx!(200), SIZE, fx!(0.25), fx!(100)).unwrap();
        Self {
            faces: shape.faces.iter().map(|face| face.map(index)).collect(),
            uv_faces: (0..shape.faces.len())
                .map(|face| [0, 1, 2].map(|corner| index(3 * face + corner)))
                .collect(),
            shape: Shape {
                positions: positions.iter().map(|&p| exact(p)).collect(),
                faces: shape.faces.clone(),
                uvs: uvs
                    .chunks(3)
                    .map(|face| {
                        std::array::from_fn(|i| [f64::from(face[i].x), f64::from(face[i].y)])
                    })
                    .collect(),
            },
            unrounded: shape.uvs.clone(),
            positions,
            uvs,
            mvp: projection * transform,
            view: view(eye),
        }
    }

    fn drawing(&self, mode: Mode) -> Drawing<'_, Perspective> {
        Drawing {
            size: SIZE,
            options: DrawOptions::new(),
            mode,
            mesh: Mesh::new(&self.positions, &self.faces)
                .unwrap()
                .with_uvs(&self.uvs, Some(&self.uv_faces))
                .unwrap(),
            mvp: self.mvp,
        }
    }

    /// Draws the scene in several modes, and compares the pictures with the model. Every vertex must lie between the
    /// near and far planes and in the guard band.
    pub fn compare(&self, modes: &[Mode]) -> Vec<(Mode, Comparison)> {
        let mut model = None;
        modes
            .iter()
            .map(|&mode| {
                let drawing = self.drawing(mode);
                let values = |vertex: &Corner<'_>| {
                    let [u, v] = vertex.uv().to_bits();
                    [u << 4, v << 4, vertex.distance().to_bits()]
                };
                let pixels = drawing.all(&values);
                let model = model
                    .get_or_insert_with(|| self.model(&pixels, &drawing.snapped(&self.positions)));
                assert_eq!(drawn(&pixels), model.drawn, "coverage in {mode:?}");
                let mut comparison = Comparison {
                    snapped: Spread::default(),
                    unrounded: Spread::default(),
                    unsnapped: Spread::default(),
                    excess: Spread::default(),
                    distance: Spread::default(),
                    allowed: Spread::default(),
                    depth: Spread::default(),
                    order: Spread::default(),
                    coverage: model.coverage,
                    pixels,
                };
                comparison.attributes(mode, model, &self.view);
                comparison.order(&drawing.shown(&values), model, &self.view);
                (mode, comparison)
            })
            .collect()
    }

    /// The model's values at the drawn pixels. Every mode must draw the same pixels.
    fn model(&self, pixels: &[Seen<3>], places: &[Option<[i32; 2]>]) -> Model {
        let Self { shape, view, .. } = self;
        let unsnapped = pieces(&shape.mesh(), view);
        let snap = |pieces: &[Piece<2>]| -> Vec<_> {
            pieces
                .iter()
                .map(|piece| piece.snap(|source, _| places[source.unwrap()].unwrap()))
                .collect()
        };
        let snapped = snap(&unsnapped);
        let unrounded = Shape {
            uvs: self.unrounded.clone(),
            ..shape.clone()
        };
        let unrounded = snap(&pieces(&unrounded.mesh(), view));
        let all = |pieces: &[Piece<2>]| pixels.iter().map(|seen| at(pieces, seen)).collect();
        let mut model = Model {
            drawn: drawn(pixels),
            snapped: all(&snapped),
            unrounded: all(&unrounded),
            unsnapped: all(&unsnapped),
            farthest: HashMap::new(),
            coverage: Coverage::default(),
            pieces: snapped,
        };
        for (seen, value) in pixels.iter().zip(&model.snapped) {
            let row = model.farthest.entry((seen.face, seen.pixel[1]));
            let farthest = row.or_default();
            *farthest = farthest.max(value.w);
        }
        model.coverage = coverage(model.drawn.clone(), model.pieces.clone(), unsnapped);
        model
    }
}

/// The faces and pixels that were drawn, in order.
fn drawn(pixels: &[Seen<3>]) -> Vec<(usize, [i32; 2])> {
    pixels.iter().map(|seen| (seen.face, seen.pixel)).collect()
}

/// The model's values at a drawn pixel of a triangle.
fn at(pieces: &[Piece<2>], seen: &Seen<3>) -> Value<2> {
    let piece = &pieces[seen.face];
    assert_eq!(piece.face, seen.face, "the face is clipped");
    piece.at(seen.pixel).expect("the triangle has no area")
}

impl Comparison {
    fn attributes(&mut self, mode: Mode, model: &Model, view: &View) {
        let unit = TEXELS / 2_f64.powi(UV_BITS);
        let bounds: Vec<_> = model
            .pieces
            .iter()
            .map(|piece| {
                let bound = |corners: [f64; 3], unit: f64| {
                    let corners = corners.map(|value| (value * unit).round() as i32);
                    Bound::perspective(mode, corners, piece.w)
                };
                let [u, v] =
                    [0, 1].map(|k| bound(piece.attributes.map(|corner| corner[k]), TEXELS / unit));
                // A vertex's distance is computed from products of 30-bit mantissas and numbers below 64, and rounding
                // adds an error of half a unit.
                [u, v, bound(piece.w, 65536.).plus(0.51)]
            })
            .collect();
        for (i, seen) in self.pixels.iter().enumerate() {
            let texels = [0, 1].map(|k: usize| f64::from(seen.values[k]) * unit);
            let errors = |value: &Value<2>| {
                [0, 1].map(|k: usize| (texels[k] - value.attributes[k] * TEXELS).abs())
            };

            let value = &model.snapped[i];
            let [u, v] = errors(value);
            self.snapped.add(u.max(v), i);
            let distance = (f64::from(seen.values[2]) - value.w * 65536.).abs();
            self.distance.add(distance, i);
            let farthest = model.farthest[&(seen.face, seen.pixel[1])];
            let relative = [u / unit, v / unit, distance];
            for (error, bound) in relative.into_iter().zip(&bounds[seen.face]) {
                self.allowed.add(error / bound.at(value.w, farthest), i);
            }
            let depth = view.projection.depth(value.w);
            let stored = f64::from(seen.depth);
            self.depth
                .add((stored - depth).max(depth - stored - 1.).max(0.), i);

            let [u, v] = errors(&model.unrounded[i]);
            self.unrounded.add(u.max(v), i);

            let value = &model.unsnapped[i];
            let errors = errors(value);
            let excess =
                [0, 1].map(|k: usize| errors[k] - SNAP * TEXELS * value.dx[k].hypot(value.dy[k]));
            self.unsnapped.add(errors[0].max(errors[1]), i);
            self.excess.add(excess[0].max(excess[1]), i);
        }
    }

    fn order(&mut self, shown: &[Seen<3>], model: &Model, view: &View) {
        let depth = |value: &Value<2>| view.projection.depth(value.w);
        let mut nearest = vec![0_f64; SIZE.0 as usize * SIZE.1 as usize];
        for (seen, value) in self.pixels.iter().zip(&model.snapped) {
            let nearest = &mut nearest[pixel_index(seen.pixel)];
            *nearest = nearest.max(depth(value));
        }
        let mut last = vec![None; nearest.len()];
        for seen in shown {
            last[pixel_index(seen.pixel)] = Some(seen);
        }
        for (i, (nearest, last)) in nearest.iter().zip(last).enumerate() {
            assert_eq!(
                *nearest > 0.,
                last.is_some(),
                "pixel {i} is drawn in only one picture"
            );
            if let Some(seen) = last {
                self.order.add(nearest - depth(&at(&model.pieces, seen)), i);
            }
        }
    }

    /// Prints the errors.
    pub fn print(&self, name: &str) {
        println!("{name}: {} pixels", self.pixels.len());
        println!(
            "{}",
            self.snapped.line("texels, given snapped vertices", "")
        );
        println!(
            "  within 0.001 texel: {:.5} %",
            100. * self.snapped.within(0.001)
        );
        println!(
            "{}",
            self.unrounded
                .line("texels, given snapped vertices and unrounded u and v", "")
        );
        println!(
            "  within 0.001 texel: {:.5} %",
            100. * self.unrounded.within(0.001)
        );
        println!(
            "{}",
            self.unsnapped.line("texels, given unsnapped vertices", "")
        );
        println!(
            "  beyond 1/256 pixel's gradient: {:.5} texels",
            self.excess.max()
        );
        println!("{}", self.distance.line("distance", "of 2^-16"));
        println!("  relative to the bound: {:.5}", self.allowed.max());
        println!("{}", self.depth.line("depth outside its step", "steps"));
        println!("  behind the nearest: {:.5} steps", self.order.max());
        println!(
            "  different {}; inside, drawn never, once, more often: {:?}; outside, drawn: {}",
            self.coverage.not_alike, self.coverage.inside, self.coverage.outside
        );
    }
}

/// The index of a pixel, row by row.
fn pixel_index([x, y]: [i32; 2]) -> usize {
    y as usize * SIZE.0 as usize + x as usize
}

fn coverage(
    mut drawn: Vec<(usize, [i32; 2])>,
    snapped: Vec<Piece<2>>,
    unsnapped: Vec<Piece<2>>,
) -> Coverage {
    let bounds = Bounds::new(SIZE.0, SIZE.1);
    drawn.sort_unstable();
    let mut model: Vec<(usize, [i32; 2])> = culled(snapped, raster::Cull::Back)
        .iter()
        .flat_map(|piece| {
            bounds
                .around(&piece.screen, 0.)
                .pixels()
                .filter(|&pixel| piece.covers(pixel))
                .map(|pixel| (piece.face, pixel))
        })
        .collect();
    model.sort_unstable();
    let mut found = Coverage {
        not_alike: difference(&drawn, &model) + difference(&model, &drawn),
        ..Coverage::default()
    };

    let mut counts = vec![0_usize; SIZE.0 as usize * SIZE.1 as usize];
    for (_, pixel) in &drawn {
        counts[pixel_index(*pixel)] += 1;
    }
    let front: Vec<_> = culled(unsnapped, raster::Cull::Back)
        .iter()
        .map(|piece| piece.screen)
        .collect();
    let silhouette = Silhouette::new(&front, SIZE.0, SIZE.1);
    for pixel in bounds.pixels() {
        let count = counts[pixel_index(pixel)];
        match silhouette.classify(center(pixel), SNAP) {
            silhouette::Position::Inside => found.inside[count.min(2)] += 1,
            silhouette::Position::Outside => found.outside += usize::from(count > 0),
            silhouette::Position::Near => {}
        }
    }
    found
}

/// The number of entries of the sorted `a` that are not in the sorted `b`. Repeated entries count separately.
fn difference<T: Ord>(a: &[T], b: &[T]) -> usize {
    let mut b = b.iter().peekable();
    a.iter()
        .filter(|&item| {
            while b.next_if(|&other| other < item).is_some() {}
            b.next_if(|&other| other == item).is_none()
        })
        .count()
}
