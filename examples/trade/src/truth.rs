//! Exact pixels, which the model in f64 computes from the crate's snapped vertices.

use std::cell::RefCell;

use embedded_graphics::pixelcolor::Rgb565;
use fixel::mode::Exact;
use fixel::prelude::*;

use super::Result;
use super::case::{Case, Shot};
use super::record::{Recorded, Survey};
use support::reference::coverage::{Bounds, covered_in};
use support::reference::linear::Vec3 as Point;
use support::reference::raster::{self, Piece, pieces};

/// The exact result of a drawing, computed by the model.
pub struct Truth {
    /// Every pixel of every triangle that is drawn, sorted by face, row and column.
    pub pixels: Vec<Expected>,
    /// The picture: the color of each covered pixel.
    pub picture: Vec<Option<Rgb565>>,
}

/// The exact values at a pixel of a triangle.
#[derive(Clone, Copy, Debug)]
pub struct Expected {
    pub face: usize,
    pub pixel: [i32; 2],
    /// The texture coordinate, in repeats.
    pub uv: [f64; 2],
}

impl Truth {
    /// Draws a shot with the model.
    ///
    /// # Errors
    ///
    /// The crate refuses the mesh or clips it. (If the crate clips the mesh, it draws other vertices than the given
    /// vertices.)
    pub fn of(case: &Case, shot: &Shot) -> Result<Self> {
        let (width, height) = case.size;
        let mut truth = Self {
            pixels: Vec::new(),
            picture: vec![None; width as usize * height as usize],
        };
        let mut nearest = vec![f64::INFINITY; truth.picture.len()];
        let (pieces, faces) = snapped(case, shot)?;
        for piece in &pieces {
            let face = faces[piece.face];
            let Some(corners) = piece.snapped else {
                continue;
            };
            for pixel in covered_in(corners, Bounds::new(width, height)) {
                let Some(value) = piece.at(pixel) else {
                    continue;
                };
                let [u, v, ..] = value.attributes;
                let uv = [u, v];
                truth.pixels.push(Expected { face, pixel, uv });
                let place = pixel[1] as usize * width as usize + pixel[0] as usize;
                if value.w < nearest[place] {
                    nearest[place] = value.w;
                    truth.picture[place] = Some(case.surface.model(face, value.attributes));
                }
            }
        }
        truth
            .pixels
            .sort_unstable_by_key(|seen| order(seen.face, seen.pixel));
        Ok(truth)
    }
}

/// The key that sorts pixels by face, row and column.
pub fn order(face: usize, [x, y]: [i32; 2]) -> (usize, i32, i32) {
    (face, y, x)
}

/// Returns the triangles that the crate draws, with their snapped corners, and their indices in the mesh.
fn snapped(case: &Case, shot: &Shot) -> Result<(Vec<Piece<5>>, Vec<usize>)> {
    let mesh = shot.mesh()?;
    let (width, height) = case.size;
    let mut colors = vec![Rgb565::default(); width as usize * height as usize];
    let mut canvas = Canvas::new(&mut colors, width, height)?;
    // The mode does not matter, because only the corners are used.
    let options = DrawOptions::new().with_mode(Exact);
    let recorded = RefCell::new(Vec::new());
    canvas.draw_with(&options, &mesh, &shot.mvp, &Survey(&recorded));
    let recorded: Vec<Recorded> = recorded.into_inner();

    let positions: Vec<Point> = mesh
        .positions()
        .iter()
        .map(|p| [p.x, p.y, p.z].map(f64::from))
        .collect();
    let corners = |recorded: &Recorded| mesh.faces()[recorded.face].map(usize::from);
    let faces: Vec<[usize; 3]> = recorded.iter().map(corners).collect();
    let attributes: Vec<[[f64; 5]; 3]> = recorded.iter().map(|recorded| recorded.corners).collect();
    let model = raster::Mesh {
        positions: &positions,
        faces: &faces,
        attributes: &attributes,
    };
    let places: Vec<Option<[i32; 2]>> = mesh
        .positions()
        .iter()
        .map(|point| {
            let place = canvas.project(&options, &shot.mvp, point)?;
            Some([place.x.to_bits(), place.y.to_bits()])
        })
        .collect();
    let mut snapped = Vec::with_capacity(faces.len());
    for piece in pieces(&model, &shot.view) {
        let corners = piece.sources.map(|source| places[source?]);
        let [Some(a), Some(b), Some(c)] = corners else {
            return Err(format!("{}: a triangle is clipped", case.name).into());
        };
        snapped.push(piece.snapped_to([a, b, c]));
    }
    let faces = recorded.iter().map(|recorded| recorded.face).collect();
    Ok((snapped, faces))
}
