//! Anti-aliasing of edges, after the picture is drawn.

use embedded_graphics::geometry::Point;

use super::Drawn;
use super::call::{Call, Screen};
use super::edges::{self, Edges, EdgesOf};
use super::list::Prepared;
use super::options::DrawOptions;
use crate::canvas::{
    Biased, Canvas, DepthBuffer, DepthTest, Memory, Storage, TestAndWrite, WideFloatDepth,
};
use crate::error::Error;
use crate::mesh::{Mesh, Outline, Primitive};
use crate::raster::{
    self, Blitter, Coloring, Columns, DepthShift, Pair, Patch, Rows, Scissor, ScreenVertex,
    Straddle,
};
use crate::shade::PixelFormat;
use crate::view::{AsMvp, ProjectionKind};

impl<C: PixelFormat, O: Storage<C>, D: DepthBuffer> Canvas<'_, C, O, D> {
    /// Smooths the silhouette of a mesh, and its creases, in a picture that is already drawn. Call it last, once for
    /// each mesh, with the `options` and the `mvp` that drew the mesh.
    ///
    #[cfg_attr(doc, doc = page_picture!("smooth_edges", "A ring and a cube with jagged edges, and smoothed"))]
    /// Where an edge of the outline passes between the centers of two neighboring pixels, this function mixes their
    /// colors. If a [share](crate::guide::mathematics::coverage) of a pixel lies beyond the edge, the neighbor's color
    /// replaces this share of the pixel's color. So the shape neither grows nor shrinks. The function mixes the colors
    /// that are on the canvas, and calls no shader. If the canvas has a depth buffer, the function leaves out edges
    /// behind other surfaces. The result has the same counts as a draw call of [`mesh.outline`](Mesh::outline).
    ///
    /// With a crease angle of 180 degrees, an outline has silhouettes only. Use a smaller angle if the faces of a mesh
    /// differ in color where they meet, such as the sides of a lit box. Where a crease and a silhouette pass between
    /// the same two pixels, only the silhouette is smoothed.
    ///
    /// Along a long edge between two colors, the share of each color has an error of at most 3/256. If the mean of 64
    /// samples per pixel counts as exact, smoothing removes 60 to 90 % of the error beside edges, and least where faces
    /// are smaller than a pixel. On a Cortex-M4, a lit mesh takes 10 to 40 % more instructions with smoothing.
    ///
    /// In formats with at most 4 bits per channel, the mixed colors are dithered. In black and white, dithering hides
    /// most of the smoothing, so draw and smooth a canvas of `Gray8`, and dither it when it is shown
    /// ([`show_with`](Self::show_with), [`show_diffused`](Canvas::show_diffused)).
    ///
    /// Each pixel is mixed only once: to mark a mixed pixel, the function sets its depth to the nearest depth. So draw
    /// nothing with a depth test afterwards, unless you call [`clear_depth`](Self::clear_depth) first. Without a depth
    /// buffer, a pixel at a corner may be mixed twice.
    ///
    /// A pixel can be mixed only with a neighbor in memory, so edges may stay jagged at the borders of the viewport,
    /// and in the top and bottom row of a [band](Self::band). To prevent this in bands, let each band reach one row
    /// further up and down than the rows that are shown. With a depth buffer, bands then have the same bits as the
    /// whole frame. Each call searches the mesh for the outline. To do this only once for all bands of a frame, use
    /// [`smooth_prepared`](Self::smooth_prepared).
    ///
    /// ```
    /// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::{Gray4, GrayColor}};
    /// use fixel::prelude::*;
    /// static CAN: Mesh = shape!(cylinder(24));
    /// static SILHOUETTE: Outline = outline!(CAN, deg!(180));
    /// let camera = Camera::look_at(vec3!(0, 3, 5), Vec3::ZERO, Vec3::Y)?;
    /// let mvp = Projection::perspective(deg!(30), (1, 1), fx!(1), fx!(9))? * camera;
    /// let (mut color, mut depth) = ([Gray4::BLACK; 16 * 16], [0; 16 * 16]);
    /// let mut canvas = Canvas::new(&mut color, 16, 16)?.with_depth(&mut depth)?;
    /// canvas.clear(Gray4::BLACK);
    /// canvas.draw(&CAN, &mvp, &Flat::new(Gray4::WHITE));
    /// canvas.smooth_edges(&DrawOptions::new(), &CAN, &SILHOUETTE, &mvp);
    /// let mut display = MockDisplay::new();
    /// canvas.show(&mut display)?;
    /// display.assert_pattern(&[
    ///     "0000000000000000",
    ///     "0000369998720000",
    ///     "000CFFFFFFFFC000",
    ///     "00AFFFFFFFFFFA00",
    ///     "008FFFFFFFFFF900",
    ///     "008FFFFFFFFFF700",
    ///     "005FFFFFFFFFF600",
    ///     "004FFFFFFFFFF400",
    ///     "002FFFFFFFFFF300",
    ///     "001FFFFFFFFFF100",
    ///     "000EFFFFFFFFE000",
    ///     "000DFFFFFFFFD000",
    ///     "000BFFFFFFFFB000",
    ///     "0006FFFFFFFF7000",
    ///     "00007FFFFFE70000",
    ///     "0000005674100000",
    /// ]);
    /// # Ok::<(), Error>(())
    /// ```
    pub fn smooth_edges(
        &mut self,
        options: &DrawOptions<impl Copy, impl DepthTest, impl Copy>,
        mesh: &Mesh<'_>,
        outline: &Outline<'_>,
        mvp: &impl AsMvp,
    ) -> Drawn {
        let screen = Screen {
            is_biased: D::IS_KEPT,
            ..options.screen(self.frame_size())
        };
        let rows = self.rows().clone();
        let call = Call::new((&screen, &rows), mesh, mvp);
        let edges = EdgesOf::outline(mesh, outline);
        Smoother::new(self, call.scissor.clone())
            .smooth(|smoother| edges::draw(&call, edges, (raster::smooth_edge, 1), smoother))
    }

    /// Smooths edges like [`smooth_edges`](Self::smooth_edges), but takes the outlines from a list that was
    /// [prepared](crate::DrawList::prepare) once for all bands of a frame. Prepare the list with the depth test
    /// [`Biased::in_front`].
    ///
    /// ```
    /// use embedded_graphics::geometry::{Point, Size};
    /// use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
    /// use embedded_graphics::{draw_target::DrawTargetExt, mock_display::MockDisplay, primitives::Rectangle};
    /// use fixel::{prelude::*, canvas::{Biased, TestAndWrite}};
    /// static BALL: Mesh = shape!(sphere(16, 12));
    /// static SILHOUETTE: Outline = outline!(BALL, deg!(180));
    /// const SIZE: (u32, u32) = (32, 24);
    /// let mvp = Projection::perspective(deg!(45), SIZE, fx!(1), fx!(9))? * Transform::translate(vec3!(0, 0, -3));
    /// let options = DrawOptions::new();
    /// let (mut faces, mut edges) = (DrawList::<400, 250>::new(), DrawList::<64, 64>::new());
    /// let ball = faces.prepare(&options, SIZE, &BALL, &mvp)?;
    /// let in_front = options.with_depth_test(Biased::in_front(TestAndWrite));
    /// let silhouette = BALL.outline(&SILHOUETTE, LineStyle::HAIRLINE);
    /// let silhouette = edges.prepare(&in_front, SIZE, silhouette, &mvp)?;
    ///
    /// let mut display = MockDisplay::new();
    /// let (mut color, mut depth) = ([Rgb565::BLACK; 32 * 10], [0; 32 * 10]);
    /// for shown in (0..24).step_by(8) {
    ///     // Eight rows are shown. The band reaches one row further where there is one.
    ///     let (first, end) = (u32::max(shown, 1) - 1, u32::min(shown + 9, 24));
    ///     let pixels = 32 * (end - first) as usize;
    ///     let band = Canvas::band(&mut color[..pixels], 32, 24, first)?;
    ///     let mut band = band.with_depth(&mut depth[..pixels])?;
    ///     band.clear(Rgb565::BLACK);
    ///     band.draw_prepared(&ball, &Flat::new(Rgb565::WHITE))?;
    ///     band.smooth_prepared(&silhouette)?;
    ///     let rows = Rectangle::new(Point::new(0, shown as i32), Size::new(32, 8));
    ///     band.show(&mut display.clipped(&rows))?;
    /// }
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`Error::SizeDiffers`] if the canvas's frame differs in size from the frame that the list was prepared for.
    pub fn smooth_prepared<M, Z, B, K: ProjectionKind>(
        &mut self,
        prepared: &Prepared<'_, impl Sized, Edges<'_>, DrawOptions<M, Biased<Z>, B>, K>,
    ) -> Result<Drawn, Error> {
        let rows = self.rows().clone();
        let mut drawn = Drawn::default();
        prepared.each_run(self.frame_size(), (&rows, false), |edges, run| {
            drawn += Smoother::new(self, run.scissor.clone())
                .smooth(|smoother| run.draw_edges(edges.of, 1, &raster::smooth_edge, smoother));
        })?;
        Ok(drawn)
    }
}

/// The depth of a pixel that is done. It is nearer than every edge, so no other edge changes the pixel.
const DONE: u16 = u16::MAX;

/// Smooths edges: mixes the pixels on either side of each edge.
struct Smoother<'s, 'c, C, O: Storage<C>, D> {
    canvas: &'s mut Canvas<'c, C, O, D>,
    scissor: Scissor,
    shift: DepthShift,
    /// Whether creases are smoothed; otherwise silhouettes and borders are.
    is_at_creases: bool,
    /// Whether there are creases that are not smoothed yet.
    has_creases: bool,
}

impl<'s, 'c, C: PixelFormat, O: Storage<C>, D: DepthBuffer> Smoother<'s, 'c, C, O, D> {
    const fn new(canvas: &'s mut Canvas<'c, C, O, D>, scissor: Scissor) -> Self {
        Self {
            canvas,
            scissor,
            shift: DepthShift(0),
            is_at_creases: false,
            has_creases: false,
        }
    }

    /// Smooths the edges that `draw` draws: first silhouettes and borders, then creases.
    ///
    /// Beside a face that is too narrow for a pixel, a silhouette and a crease pass between the same two pixels. If the
    /// crease came first, the pixel of the wider face would be mixed with the background.
    fn smooth(mut self, draw: impl Fn(&mut Self) -> Drawn) -> Drawn {
        let drawn = draw(&mut self);
        if self.has_creases {
            self.is_at_creases = true;
            draw(&mut self);
        }
        drawn
    }

    /// Smooths an edge; `beside` is how steep the faces beside it are.
    fn edge(&mut self, [a, b]: [&ScreenVertex; 2], beside: u16) {
        let Some(mut straddle) = Straddle::new(&self.scissor, [a, b]) else {
            return;
        };
        let ([from, to, _], exponent) = ScreenVertex::weights([a, b, b]);
        let [mut q, per_step] = straddle.linear([from, to].map(u32::cast_signed));
        let down = self.shift.right_shift(exponent);
        let steepness = per_step
            .unsigned_abs()
            .max(WideFloatDepth::decode(beside.into(), down));
        let bias = Biased::in_front(TestAndWrite).bias(steepness);

        let is_steep = straddle.is_steep;
        let mut memory = self.canvas.memory();
        let width = memory.width.cast_signed();
        let start = straddle.steps.start;
        let [row, column] = if is_steep { [start, 0] } else { [0, start] };
        // The index of the pixel with the number 0 across the edge; it moves by `next` from step to step.
        let mut base = (row - memory.first_row.cast_signed()) * width + column;
        let (across, stride, next) = if is_steep {
            (&self.scissor.columns, 1, width)
        } else {
            (&self.scissor.rows, width, 1)
        };
        for step in straddle.steps.clone() {
            let Pair { first, beyond } = straddle.next();
            let depth = Biased::<TestAndWrite>::depth::<D>(bias, q.max(0).cast_unsigned(), down);
            let numbers = [first, first + 1];
            let places = numbers.map(|number| {
                if across.contains(&number) {
                    (base + number * stride).cast_unsigned() as usize
                } else {
                    usize::MAX
                }
            });
            let points = numbers.map(|number| {
                if is_steep {
                    Point::new(number, step)
                } else {
                    Point::new(step, number)
                }
            });
            mix(&mut memory, (places, points), beyond, depth);
            q = q.wrapping_add(per_step);
            base += next;
        }
    }
}

/// Mixes the two pixels of a pair, each with the color that the other has, if the edge is not hidden there. Each pixel is
/// given by its index in memory and its point of the frame, and by the share that lies beyond the edge; `depth` is the
/// edge's depth.
///
/// A pixel is mixed once, with the color that its neighbor had before it was mixed itself. So the result at a pixel
/// depends only on the colors and depths of this pixel and of its four neighbors, and bands that overlap by a row have
/// the bits of the whole frame. If the neighbor is missing or was mixed by another edge, the pixel is marked all the
/// same, because in another band, the neighbor may be there.
#[inline(always)]
#[allow(clippy::inline_always)] // a call would keep the loop's numbers in memory
fn mix<C: PixelFormat, O: Storage<C>, D: DepthBuffer>(
    memory: &mut Memory<'_, C, O, D>,
    (places, points): ([usize; 2], [Point; 2]),
    beyond: [i32; 2],
    depth: u32,
) {
    // An edge at the near plane must not pass pixels that are done.
    let depth = depth.min(u32::from(DONE) - 1);
    let mut is_done = [false; 2];
    let mut is_passed = beyond.map(|share| share > 0);
    for i in [0, 1] {
        // Without a depth buffer, there is no depth.
        if let Some(stored) = memory.depths.get_mut(places[i]) {
            is_done[i] = *stored == DONE;
            is_passed[i] &= depth >= u32::from(*stored);
            if is_passed[i] {
                *stored = DONE;
            }
        }
    }
    let is_mixed = [is_passed[0] && !is_done[1], is_passed[1] && !is_done[0]];
    if is_mixed == [false; 2] {
        return;
    }
    let [Some(&first), Some(&second)] = places.map(|place| memory.colors.get(place)) else {
        return;
    };
    let (first, second) = (O::load(first), O::load(second));
    for (i, own, other) in [(0, first, second), (1, second, first)] {
        if is_mixed[i]
            && let Some(cell) = memory.colors.get_mut(places[i])
        {
            *cell = O::store(own.covered(other, beyond[i] << 8, points[i]));
        }
    }
}

impl<C: PixelFormat, O: Storage<C>, D: DepthBuffer> Blitter for Smoother<'_, '_, C, O, D> {
    fn begin(&mut self, shift: DepthShift) -> Coloring {
        self.shift = shift;
        Coloring {
            varies: true,
            blends: true,
        }
    }

    fn set_up(&mut self, primitive: &Primitive<'_>, patch: &Patch<'_>) -> &mut dyn Rows {
        let [a, b, _] = patch.vertices;
        let is_crease = primitive.slope_beside & 1 != 0;
        if is_crease == self.is_at_creases {
            self.edge([a, b], primitive.slope_beside);
        }
        self.has_creases |= is_crease;
        self
    }
}

impl<C: PixelFormat, O: Storage<C>, D: DepthBuffer> Rows for Smoother<'_, '_, C, O, D> {
    /// An edge is done when it is set up.
    fn draw(&mut self, _: i32, _: &[Columns]) {}
}
