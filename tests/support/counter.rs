//! Helpers that the raster tests share: a shader that counts pixels, and a projection with units of one pixel.

use embedded_graphics::pixelcolor::Gray8;
use fixel::canvas::{Blending, TestAndWrite};
use fixel::prelude::*;
use fixel::view::{Parallel, ProjectionKind};
use fixel::{Drawn, Window, mode};

use crate::recorder::{Recorder, record};

/// Counts how often each pixel of a frame is drawn. The frame has no depth buffer.
pub struct Counter {
    pixels: Vec<Gray8>,
    counts: Vec<u32>,
    /// Width and height of the frame.
    pub size: (u32, u32),
}

/// A shader that records each pixel for which the canvas asks for a color.
type Count<'a> = Recorder<'a, Flat<Gray8>, 0>;

impl Counter {
    pub fn new(size: (u32, u32)) -> Self {
        let pixels = size.0 as usize * size.1 as usize;
        Self {
            pixels: vec![Gray8::new(0); pixels],
            counts: vec![0; pixels],
            size,
        }
    }

    fn with(&mut self, draw: &dyn Fn(&mut Canvas<'_, Gray8>, &Count<'_>) -> Drawn) -> Drawn {
        let (width, height) = self.size;
        let mut canvas = Canvas::new(&mut self.pixels, width, height).unwrap();
        let mut drawn = Drawn::default();
        let white = Flat::new(Gray8::new(255));
        let record = record(white, |count| drawn = draw(&mut canvas, count));
        for seen in record.seen {
            let [x, y] = seen.pixel.map(|at| usize::try_from(at).unwrap());
            assert!(x < width as usize, "column {x} of {width}");
            self.counts[y * width as usize + x] += 1;
        }
        drawn
    }

    /// Draws a mesh's triangles.
    pub fn draw<K: ProjectionKind>(
        &mut self,
        options: &DrawOptions,
        mesh: &Mesh,
        mvp: &Mvp<K>,
    ) -> Drawn {
        self.with(&|canvas, count| canvas.draw_with(options, mesh, mvp, count))
    }

    /// Draws a mesh's edges.
    pub fn draw_edges<K: ProjectionKind, B: Blending<Gray8>>(
        &mut self,
        options: &DrawOptions<mode::Newton, TestAndWrite, B>,
        mesh: &Mesh,
        mvp: &Mvp<K>,
    ) -> Drawn {
        self.with(&|canvas, count| {
            canvas.draw_with(options, mesh.edges(LineStyle::HAIRLINE), mvp, count)
        })
    }

    /// Draws a mesh's positions.
    pub fn draw_points<K: ProjectionKind>(
        &mut self,
        options: &DrawOptions,
        mesh: &Mesh,
        mvp: &Mvp<K>,
    ) -> Drawn {
        self.with(&|canvas, count| {
            canvas.draw_with(options, mesh.points(PointStyle::PIXEL), mvp, count)
        })
    }

    /// The position that the crate computes for a point, in 24.8 fixed point, before culling and the guard band.
    pub fn snapped<K: ProjectionKind>(&mut self, mvp: &Mvp<K>, point: Vec3) -> Option<[i32; 2]> {
        let (width, height) = self.size;
        let at = Viewport::new(0, 0, width, height)
            .unwrap()
            .project(point, mvp)?;
        Some([at.x.to_bits(), at.y.to_bits()])
    }

    /// How often each pixel was drawn since the last call, row by row.
    pub fn take(&mut self) -> Vec<u32> {
        self.counts.iter_mut().map(std::mem::take).collect()
    }

    /// The counts as text, one line per row, with `.` for 0 and `+` for more than nine.
    pub fn picture(&mut self) -> Vec<String> {
        let counts = self.take();
        counts
            .chunks(self.size.0 as usize)
            .map(|row| row.iter().map(|&count| character(count)).collect())
            .collect()
    }
}

/// A count as a character: `.` for 0, `+` for more than nine.
pub fn character(count: u32) -> char {
    match count {
        0 => '.',
        _ => char::from_digit(count, 10).unwrap_or('+'),
    }
}

/// A projection that maps a unit of model space to a pixel. x is the distance from the left edge. y is the distance
/// *up* from the top edge, so the y of a visible point is negative. z lies between -1 and 1.
///
/// Pixel coordinates are exact to the last of their eight fraction bits. The projection maps x to (2/width)·x − 1, with
/// a factor rounded to 30 bits. The viewport maps the result back to pixels. The error is less than 2⁻²⁹ · 4096 pixels,
/// which is far less than half of 1/256.
pub fn pixel_projection((width, height): (u32, u32)) -> Mvp<Parallel> {
    let [width, height] = [width, height].map(|x| Scalar::try_from(x).unwrap());
    let projection = Projection::orthographic(
        Window {
            left: fx!(0),
            right: width,
            bottom: -height,
            top: fx!(0),
        },
        fx!(-1),
        fx!(1),
    );
    projection.unwrap().into()
}

/// The model position that [`pixel_projection`] maps to this point of the picture. The point is in 24.8 fixed point.
pub fn at_subpixel([x, y]: [i32; 2]) -> Vec3 {
    Vec3::from_bits([x << 8, -y << 8, 0])
}

/// Options that draw front and back faces.
pub const BOTH_SIDES: DrawOptions = DrawOptions::new().with_cull(Cull::Nothing);
