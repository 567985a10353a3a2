//! A mesh drawn as a picture: every surface at every pixel, with its values.
//!
//! Drawing has separate steps, so that a test can inspect or modify the pieces in between: [`pieces`] projects and
//! clips, [`culled`] culls, and [`render`] evaluates each piece at each pixel. To judge a rasterizer without its
//! rounding of vertices, give the pieces the rasterizer's own snapped corners: [`Piece::snap`].

use super::attributes::{Value, at_pixel, at_pixel_snapped};
use super::clip::{ClipVertex, DEPTH_PLANES, Plane, fan, polygon};
use super::coverage::{Bounds, Corners, Snapped, area2, area2_f64, center, covers, covers_f64};
use super::distance::to_triangle;
use super::linear::{Vec3, Vec4};
use super::projection::Projection;
use super::view::{View, Viewport, unsnap};

/// The faces that are culled. Front faces run counter-clockwise on the screen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cull {
    /// No faces.
    Nothing,
    /// Faces with clockwise corners.
    Back,
    /// Faces with counter-clockwise corners.
    Front,
}

impl Cull {
    /// Whether a triangle of this winding is kept.
    fn keeps(self, clockwise: bool) -> bool {
        match self {
            Cull::Nothing => true,
            Cull::Back => !clockwise,
            Cull::Front => clockwise,
        }
    }
}

/// Triangles in model space.
#[derive(Clone, Copy, Debug)]
pub struct Mesh<'a, const N: usize> {
    /// Positions.
    pub positions: &'a [Vec3],
    /// Triangles, as indices of positions.
    pub faces: &'a [[usize; 3]],
    /// The attributes of each triangle's corners.
    pub attributes: &'a [[[f64; N]; 3]],
}

/// A triangle on the screen: a face of the mesh, or a part of a clipped face.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Piece<const N: usize> {
    /// The face's index in the mesh.
    pub face: usize,
    /// The index of each corner's position; `None` for a corner that clipping made.
    pub sources: [Option<usize>; 3],
    /// Corners in clip space.
    pub clip: [Vec4; 3],
    /// Corners in pixels: as projected, or after snapping.
    pub screen: Corners,
    /// Corners in 24.8, if they were snapped.
    pub snapped: Option<Snapped>,
    /// Homogeneous w at the corners.
    pub w: [f64; 3],
    /// Distance ahead of the eye at the corners.
    pub distance: [f64; 3],
    /// Attributes at the corners.
    pub attributes: [[f64; N]; 3],
}

impl<const N: usize> Piece<N> {
    /// The piece with its corners snapped by `snap`, in 24.8. w, distance and attributes stay the same.
    pub fn snap(self, snap: impl Fn(Option<usize>, Vec4) -> [i32; 2]) -> Self {
        self.snapped_to(std::array::from_fn(|i| snap(self.sources[i], self.clip[i])))
    }

    /// The piece with these corners, in 24.8. w, distance and attributes stay the same.
    pub fn snapped_to(self, corners: Snapped) -> Self {
        Self {
            screen: corners.map(unsnap),
            snapped: Some(corners),
            ..self
        }
    }

    /// Whether the corners run clockwise on the screen, like the corners of a back face; `None` for a piece without
    /// area.
    pub fn clockwise(&self) -> Option<bool> {
        match self.snapped {
            Some(corners) => match area2(corners) {
                0 => None,
                area => Some(area > 0),
            },
            None => match area2_f64(&self.screen) {
                0. => None,
                area => Some(area > 0.),
            },
        }
    }

    /// The values at the center of a pixel, which can be outside the piece; `None` for a piece without area.
    pub fn at(&self, pixel: [i32; 2]) -> Option<Value<N>> {
        match self.snapped {
            Some(corners) => at_pixel_snapped(corners, self.w, &self.attributes, pixel),
            None => at_pixel(&self.screen, self.w, &self.attributes, pixel),
        }
    }

    /// The distance ahead of the eye at the center of a pixel, which can be outside the piece; `None` for a piece
    /// without area.
    pub fn distance_at(&self, pixel: [i32; 2]) -> Option<f64> {
        let distance = self.distance.map(|d| [d]);
        let value = match self.snapped {
            Some(corners) => at_pixel_snapped(corners, self.w, &distance, pixel),
            None => at_pixel(&self.screen, self.w, &distance, pixel),
        };
        value.map(|value| value.attributes[0])
    }

    /// Whether the piece covers the center of a pixel, by the top-left rule.
    pub fn covers(&self, pixel: [i32; 2]) -> bool {
        match self.snapped {
            Some(corners) => covers(corners, pixel),
            None => covers_f64(&self.screen, center(pixel)),
        }
    }
}

/// The mesh's triangles on the screen, clipped to the near and far planes, but not yet culled. [`render`] leaves out
/// pixels beyond the sides of the view.
pub fn pieces<const N: usize>(mesh: &Mesh<'_, N>, view: &View) -> Vec<Piece<N>> {
    pieces_clipped(mesh, view, &DEPTH_PLANES)
}

/// The mesh's triangles on the screen, clipped to `planes`. The planes must keep w positive.
pub fn pieces_clipped<const N: usize>(
    mesh: &Mesh<'_, N>,
    view: &View,
    planes: &[Plane],
) -> Vec<Piece<N>> {
    let clip: Vec<Vec4> = mesh.positions.iter().map(|&p| view.clip(p)).collect();
    let mut pieces = Vec::with_capacity(mesh.faces.len());
    for (face, (indices, attributes)) in mesh.faces.iter().zip(mesh.attributes).enumerate() {
        let corners: [ClipVertex<N>; 3] = std::array::from_fn(|i| ClipVertex {
            position: clip[indices[i]],
            attributes: attributes[i],
            source: Some(indices[i]),
        });
        for [a, b, c] in fan(&polygon(&corners, planes)) {
            let [at_a, at_b, at_c] = [a, b, c].map(|corner| view.on_screen(corner.position));
            pieces.push(Piece {
                face,
                sources: [a.source, b.source, c.source],
                clip: [a.position, b.position, c.position],
                screen: [at_a.screen, at_b.screen, at_c.screen],
                snapped: None,
                w: [at_a.w, at_b.w, at_c.w],
                distance: [at_a.distance, at_b.distance, at_c.distance],
                attributes: [a.attributes, b.attributes, c.attributes],
            });
        }
    }
    pieces
}

/// The pieces that a culling mode keeps. Every mode drops pieces without area.
pub fn culled<const N: usize>(mut pieces: Vec<Piece<N>>, cull: Cull) -> Vec<Piece<N>> {
    pieces.retain(|piece| piece.clockwise().is_some_and(|side| cull.keeps(side)));
    pieces
}

/// A surface at one pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit<const N: usize> {
    /// The face's index in the mesh.
    pub face: usize,
    /// The piece's index in the list that was rendered.
    pub piece: usize,
    /// The distance of the pixel's center from the piece, in pixels; 0 if the piece covers the center.
    pub gap: f64,
    /// Distance ahead of the eye.
    pub distance: f64,
    /// The depth before it is rounded down; 65535 at the near plane.
    pub depth: f64,
    /// Homogeneous w, and the attributes with their changes per pixel.
    pub value: Value<N>,
}

/// Every surface at every pixel of the canvas, including hidden surfaces.
#[derive(Clone, Debug)]
pub struct Picture<const N: usize> {
    width: u32,
    hits: Vec<Vec<Hit<N>>>,
}

/// Evaluates pieces at those pixels of a canvas of width x height that are inside the viewport.
///
/// A `margin` of 0 finds the pieces that cover a pixel's center. A larger `margin`, in pixels, also finds the pieces
/// within this distance of the center, and extends their planes to the center. (If vertices are rounded by up to
/// `margin`, a piece near the center can cover the center instead.)
pub fn render<const N: usize>(
    pieces: &[Piece<N>],
    projection: &Projection,
    viewport: Viewport,
    (width, height): (u32, u32),
    margin: f64,
) -> Picture<N> {
    let bounds = Bounds::new(width, height).intersect(Bounds {
        left: viewport.x,
        top: viewport.y,
        right: viewport.x.saturating_add_unsigned(viewport.width),
        bottom: viewport.y.saturating_add_unsigned(viewport.height),
    });
    let mut hits = vec![Vec::new(); width as usize * height as usize];
    for (index, piece) in pieces.iter().enumerate() {
        for pixel in bounds.around(&piece.screen, margin).pixels() {
            let gap = if piece.covers(pixel) {
                0.
            } else if margin > 0. {
                // If the neighbor owns the edge, a center on the edge has the distance 0, but is not covered.
                to_triangle(&piece.screen, center(pixel)).max(f64::MIN_POSITIVE)
            } else {
                continue;
            };
            if gap > margin {
                continue;
            }
            let (Some(value), Some(distance)) = (piece.at(pixel), piece.distance_at(pixel)) else {
                continue;
            };
            // The extended plane ends at the horizon.
            if !(value.w > 0. && value.w.is_finite()) {
                continue;
            }
            hits[pixel[1] as usize * width as usize + pixel[0] as usize].push(Hit {
                face: piece.face,
                piece: index,
                gap,
                distance,
                depth: projection.depth(distance),
                value,
            });
        }
    }
    Picture { width, hits }
}

/// Draws the unsnapped picture of a mesh in one call: projects, clips to the near and far planes, culls and renders.
/// The canvas ends at the right and lower sides of the viewport.
pub fn draw<const N: usize>(
    mesh: &Mesh<'_, N>,
    view: &View,
    cull: Cull,
    margin: f64,
) -> (Vec<Piece<N>>, Picture<N>) {
    let pieces = culled(pieces(mesh, view), cull);
    let Viewport {
        x,
        y,
        width,
        height,
    } = view.viewport;
    let size = (
        x.saturating_add_unsigned(width).max(0) as u32,
        y.saturating_add_unsigned(height).max(0) as u32,
    );
    let picture = render(&pieces, &view.projection, view.viewport, size, margin);
    (pieces, picture)
}

impl<const N: usize> Picture<N> {
    /// Every surface at a pixel, in drawing order.
    ///
    /// # Panics
    ///
    /// If the pixel is outside the canvas.
    pub fn at(&self, [x, y]: [i32; 2]) -> &[Hit<N>] {
        assert!((0..self.width as i32).contains(&x), "column {x}");
        &self.hits[y as usize * self.width as usize + x as usize]
    }

    /// The visible surface: the nearest surface that covers the pixel. Of equally near surfaces, the last one drawn is
    /// visible.
    pub fn nearest(&self, pixel: [i32; 2]) -> Option<&Hit<N>> {
        let covering = self.at(pixel).iter().filter(|hit| hit.gap == 0.);
        covering.max_by(|a, b| a.depth.total_cmp(&b.depth))
    }

    /// Every surface that a depth buffer with a step of `step` can show: every surface within the margin that is at
    /// most `step` behind the nearest covering surface. If no surface covers the pixel, these are all surfaces within
    /// the margin.
    ///
    /// Where a surface ends within the margin (see `Silhouette::contour_within`), the surface behind it can show, too.
    /// Use all surfaces of [`at`](Self::at) there.
    pub fn candidates(&self, pixel: [i32; 2], step: f64) -> impl Iterator<Item = &Hit<N>> {
        let least = self
            .nearest(pixel)
            .map_or(f64::MIN, |nearest| nearest.depth - step);
        self.at(pixel).iter().filter(move |hit| hit.depth >= least)
    }

    /// How many pieces cover each pixel, in row order.
    pub fn counts(&self) -> Vec<u32> {
        self.hits
            .iter()
            .map(|hits| hits.iter().filter(|hit| hit.gap == 0.).count() as u32)
            .collect()
    }
}
