//! A scene drawn by the crate and by the model, and all differences between the two.

use std::collections::HashMap;

use fixel::num::{TexCoord, tex_coord};
use fixel::prelude::*;
use fixel::view::Perspective;

use crate::bounds::Bound;
use crate::drawing::{Drawing, Seen};
use crate::mode::Mode;
use crate::moves::{Move, exact, product, rounded};
use crate::reference::coverage::{Bounds, center};
use crate::reference::raster::{self, Piece, culled, pieces};
use crate::reference::scenes::{SIZE, Shape, view};
use crate::reference::silhouette::{self, Silhouette};
use crate::reference::view::View;
use crate::spread::Spread;

/// Texels along a texture.
const TEXELS: f64 = 256.;
/// Fraction bits of the interpolated u and v: 4 more than a vertex has.
const UV_BITS: i32 = 24;
/// The largest rounding error of a vertex's u or v, in texels.
pub const ROUNDING: f64 = TEXELS / (2 << TexCoord::FRAC_NBITS) as f64;
/// A little more than the bound of a vertex's error: rounding moves it by up to 1/512 pixel along each axis.
const SNAP: f64 = 1. / 256.;

/// A shape in the crate's numbers, with its transforms to the picture for the crate and for the model.
pub struct Scene {
    positions: Vec<Vec3>,
    faces: Vec<[u16; 3]>,
    uvs: Vec<Vec2>,
    uv_faces: Vec<[u16; 3]>,
    /// The texture coordinates before rounding.
    unrounded: Vec<[[f64; 2]; 3]>,
    mvp: Mvp<Perspective>,
    /// The same shape for the model.
    shape: Shape,
    view: View,
}

/// The differences between the crate's pixels and the model's. Unless noted, the model uses the crate's snapped
/// vertices.
pub struct Comparison {
    /// Pixels drawn, including hidden ones.
    pub pixels: Vec<Seen<3>>,
    /// Errors of u and v, in texels.
    pub snapped: Spread,
    /// Errors of u and v, in texels, relative to texture coordinates that were not rounded to the crate's format.
    pub unrounded: Spread,
    /// Errors of u and v, in texels, given the model's own vertices.
    pub unsnapped: Spread,
    /// The part of `unsnapped` that exceeds 1/256 pixel times the gradient of the texels.
    pub excess: Spread,
    /// Errors of the distance, in units of 2⁻¹⁶.
    pub distance: Spread,
    /// Errors of u, v and distance, relative to the bounds of the formats.
    pub allowed: Spread,
    /// How far the exact depth lies outside the stored step, in steps.
    pub depth: Spread,
    /// How far the visible surface lies behind the nearest one, in steps of depth.
    pub order: Spread,
    /// Number of pairs of triangle and pixel that only the crate or only the model draws.
    pub not_alike: usize,
    /// Numbers of centers more than 1/256 pixel inside the silhouette whose pixel was drawn never, once, and more
    /// often.
    pub inside: [usize; 3],
    /// Number of centers more than 1/256 pixel outside the silhouette whose pixel was drawn.
    pub outside: usize,
}

impl Scene {
    /// Makes a scene of a shape after some moves, with every number rounded to the crate's nearest number.
    pub fn new(shape: &Shape, moves: &[Move]) -> Self {
        let positions: Vec<Vec3> = shape.positions.iter().map(|&p| rounded(p)).collect();
        let uvs: Vec<Vec2> = shape
            .uvs
            .iter()
            .flatten()
            .map(|&[u, v]| Vec2::new(tex_coord(u).unwrap(), tex_coord(v).unwrap()))
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
                    .map(|face| std::array::from_fn(|i| [face[i].x.to_num(), face[i].y.to_num()]))
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

    /// Draws and compares in some modes. Every vertex must lie between the near and far planes and in the guard band.
    pub fn compare(&self, modes: &[Mode]) -> Vec<(Mode, Comparison)> {
        let mut all: Vec<(Mode, Comparison)> = Vec::with_capacity(modes.len());
        for &mode in modes {
            let first = all.first().map(|(_, first)| first);
            all.push((mode, self.compare_in(mode, first)));
        }
        all
    }

    /// Draws and compares in one mode. If `other` is the comparison in another mode, coverage must be the same.
    fn compare_in(&self, mode: Mode, other: Option<&Comparison>) -> Comparison {
        let Self { shape, view, .. } = self;
        let drawing = self.drawing(mode);
        let values = |vertex: &Corner<'_>| {
            let [u, v] = vertex.uv().to_bits();
            [u << 4, v << 4, vertex.distance().to_bits()]
        };
        let pixels = drawing.all(&values);
        let places = drawing.places(&self.positions);

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
        let mut comparison = Comparison {
            snapped: Spread::default(),
            unrounded: Spread::default(),
            unsnapped: Spread::default(),
            excess: Spread::default(),
            distance: Spread::default(),
            allowed: Spread::default(),
            depth: Spread::default(),
            order: Spread::default(),
            not_alike: 0,
            inside: [0; 3],
            outside: 0,
            pixels,
        };
        comparison.attributes(mode, &snapped, &unsnapped, view);
        comparison.unrounded(&unrounded);
        match other {
            None => comparison.coverage(snapped.clone(), unsnapped),
            Some(other) => {
                let pixels = |of: &[Seen<3>]| -> Vec<_> {
                    of.iter().map(|seen| (seen.face, seen.pixel)).collect()
                };
                assert_eq!(pixels(&comparison.pixels), pixels(&other.pixels));
                comparison.not_alike = other.not_alike;
                comparison.inside = other.inside;
                comparison.outside = other.outside;
            }
        }
        comparison.order(&drawing.shown(&values), &snapped, view);
        comparison
    }
}

/// The model's hit of a drawn triangle at the drawn pixel.
fn at(pieces: &[Piece<2>], seen: &Seen<3>) -> raster::Hit<2> {
    let piece = &pieces[seen.face];
    assert_eq!(piece.face, seen.face, "the face is clipped");
    let value = piece.at(seen.pixel).expect("the triangle has no area");
    raster::Hit {
        face: seen.face,
        piece: seen.face,
        gap: 0.,
        distance: value.w,
        depth: 0.,
        value,
    }
}

impl Comparison {
    fn attributes(
        &mut self,
        mode: Mode,
        snapped: &[Piece<2>],
        unsnapped: &[Piece<2>],
        view: &View,
    ) {
        let unit = TEXELS / 2_f64.powi(UV_BITS);
        // The farthest pixel of each face on each row.
        let mut farthest: HashMap<(usize, i32), f64> = HashMap::new();
        for seen in &self.pixels {
            let row = farthest.entry((seen.face, seen.pixel[1])).or_default();
            *row = row.max(at(snapped, seen).distance);
        }
        let bounds: Vec<_> = snapped
            .iter()
            .map(|piece| {
                let bound = |corners: [f64; 3], unit: f64| {
                    let corners = corners.map(|value| (value * unit).round() as i32);
                    Bound::perspective(mode, corners, piece.w)
                };
                let [u, v] =
                    [0, 1].map(|k| bound(piece.attributes.map(|corner| corner[k]), TEXELS / unit));
                // A vertex's distance is rounded by half a unit, after products of 30-bit mantissas and numbers below
                // 64.
                [u, v, bound(piece.w, 65536.).plus(0.51)]
            })
            .collect();
        for (i, seen) in self.pixels.iter().enumerate() {
            let texels = [0, 1].map(|k: usize| f64::from(seen.values[k]) * unit);
            let error = |value: &[f64; 2], k: usize| (texels[k] - value[k] * TEXELS).abs();

            let hit = at(snapped, seen);
            let [u, v] = [0, 1].map(|k| error(&hit.value.attributes, k));
            self.snapped.add(u.max(v), i);
            let distance = (f64::from(seen.values[2]) - hit.distance * 65536.).abs();
            self.distance.add(distance, i);
            let farthest = farthest[&(seen.face, seen.pixel[1])];
            let errors = [u / unit, v / unit, distance];
            for (error, bound) in errors.into_iter().zip(&bounds[seen.face]) {
                self.allowed
                    .add(error / bound.at(hit.distance, farthest), i);
            }
            let depth = view.projection.depth(hit.distance);
            let stored = f64::from(seen.depth);
            self.depth
                .add((stored - depth).max(depth - stored - 1.).max(0.), i);

            let hit = at(unsnapped, seen);
            let value = &hit.value;
            let errors = [0, 1].map(|k| error(&value.attributes, k));
            let excess =
                [0, 1].map(|k: usize| errors[k] - SNAP * TEXELS * value.dx[k].hypot(value.dy[k]));
            self.unsnapped.add(errors[0].max(errors[1]), i);
            self.excess.add(excess[0].max(excess[1]), i);
        }
    }

    fn unrounded(&mut self, pieces: &[Piece<2>]) {
        let unit = TEXELS / 2_f64.powi(UV_BITS);
        for (i, seen) in self.pixels.iter().enumerate() {
            let wanted = at(pieces, seen).value.attributes;
            let [u, v] = [0, 1]
                .map(|k: usize| (f64::from(seen.values[k]) * unit - wanted[k] * TEXELS).abs());
            self.unrounded.add(u.max(v), i);
        }
    }

    fn coverage(&mut self, snapped: Vec<Piece<2>>, unsnapped: Vec<Piece<2>>) {
        let bounds = Bounds::new(SIZE.0, SIZE.1);
        let mut drawn: Vec<(usize, [i32; 2])> = self
            .pixels
            .iter()
            .map(|seen| (seen.face, seen.pixel))
            .collect();
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
        self.not_alike = difference(&drawn, &model) + difference(&model, &drawn);

        let mut counts = vec![0_usize; SIZE.0 as usize * SIZE.1 as usize];
        let place = |[x, y]: [i32; 2]| y as usize * SIZE.0 as usize + x as usize;
        for (_, pixel) in &drawn {
            counts[place(*pixel)] += 1;
        }
        let front: Vec<_> = culled(unsnapped, raster::Cull::Back)
            .iter()
            .map(|piece| piece.screen)
            .collect();
        let silhouette = Silhouette::new(&front, SIZE.0, SIZE.1);
        for pixel in bounds.pixels() {
            let count = counts[place(pixel)];
            match silhouette.classify(center(pixel), SNAP) {
                silhouette::Position::Inside => self.inside[count.min(2)] += 1,
                silhouette::Position::Outside => self.outside += usize::from(count > 0),
                silhouette::Position::Near => {}
            }
        }
    }

    fn order(&mut self, shown: &[Seen<3>], snapped: &[Piece<2>], view: &View) {
        let place = |[x, y]: [i32; 2]| y as usize * SIZE.0 as usize + x as usize;
        let depth = |seen: &Seen<3>| view.projection.depth(at(snapped, seen).distance);
        let mut nearest = vec![0_f64; SIZE.0 as usize * SIZE.1 as usize];
        for seen in &self.pixels {
            let nearest = &mut nearest[place(seen.pixel)];
            *nearest = nearest.max(depth(seen));
        }
        let mut last = vec![None; nearest.len()];
        for seen in shown {
            last[place(seen.pixel)] = Some(seen);
        }
        for (i, (nearest, last)) in nearest.iter().zip(last).enumerate() {
            assert_eq!(
                *nearest > 0.,
                last.is_some(),
                "pixel {i} is drawn in only one picture"
            );
            if let Some(seen) = last {
                self.order.add(nearest - depth(seen), i);
            }
        }
    }

    /// Prints the figures.
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
            self.not_alike, self.inside, self.outside
        );
    }
}

/// The number of entries of the sorted `a` that are not in the sorted `b`; repeated entries count.
fn difference<T: Ord>(a: &[T], b: &[T]) -> usize {
    let mut b = b.iter().peekable();
    a.iter()
        .filter(|&item| {
            while b.next_if(|&other| other < item).is_some() {}
            b.next_if(|&other| other == item).is_none()
        })
        .count()
}
