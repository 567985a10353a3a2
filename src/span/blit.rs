//! A draw call's shader, mode and canvas, behind the interface that the rasterizer calls.

use core::hint::black_box;
use core::marker::PhantomData;
use core::ops::Range;

use embedded_graphics::geometry::Point;

use super::divide::{divide, divide_anew, divide_apart};
use super::mode::{Kernel, Policy, STEEP, Slopes, WHOLE};
use super::newton::{newton, tangent};
use super::pieces::pieces;
use super::pixels::{Count, FaceOf, Numbers, Pixels, Span};
use super::straight::{solid, straight};
use crate::mesh::Primitive;
use crate::raster::{Attribute, Blitter, Columns, DepthShift, Patch, SPAN, Scale, Setup};
use crate::shade::{Lanes, MOST_VARYINGS, Shader, Varyings};
use crate::target::{Canvas, Cells, DepthBuffer, DepthTest, Storage};
use crate::view::ProjectionKind;

/// Upper clamp of a tolerance: four times this takes 31 bits, and no attribute that is drawn affinely is as great.
const MOST_TOLERANCE: u32 = (1 << 29) - 1;

/// The [`Blitter`] of shader `S` in mode `M` under a projection of kind `K`.
pub(crate) struct Blit<'p, 'c, S: Shader, O: Storage<S::Color>, D, K, M, Z> {
    canvas: &'p mut Canvas<'c, S::Color, O, D>,
    shader: S,
    mode: M,
    test: Z,
    /// The current primitive, and the values that its pixels share for the shader.
    setup: Setup,
    attributes: <Count<S> as Lanes>::Of<Attribute>,
    slopes: Slopes<Count<S>>,
    kernel: Option<Kernel>,
    face: FaceOf<S>,
    kind: PhantomData<K>,
}

impl<'p, 'c, S, O, D, K, M, Z> Blit<'p, 'c, S, O, D, K, M, Z>
where
    S: Shader,
    O: Storage<S::Color>,
    D: DepthBuffer,
    K: ProjectionKind,
    M: Policy,
    Z: DepthTest,
{
    /// How many numbers are interpolated.
    const COUNT: usize = Count::<S>::COUNT;

    /// Whether the pixels of a primitive differ in anything but their position, so that something must be
    /// interpolated.
    const VARIES: bool = Self::COUNT > 0 || D::IS_KEPT && (Z::TESTS || Z::WRITES) || S::READS_DEPTH;

    /// Whether attributes are divided by w.
    const OVER_W: bool = K::PERSPECTIVE && M::DIVIDES;

    /// The least number of bits of a scale.
    const LEAST_BITS: u32 = match (Self::OVER_W, K::PERSPECTIVE) {
        (true, _) => M::LEAST_BITS,
        (false, true) => WHOLE,
        (false, false) => M::LEAST_PARALLEL_BITS,
    };

    #[inline]
    pub(crate) fn new(
        (mode, test): (M, Z),
        canvas: &'p mut Canvas<'c, S::Color, O, D>,
        shader: S,
        shift: DepthShift,
    ) -> Self {
        const {
            assert!(
                Self::COUNT <= MOST_VARYINGS,
                "a shader has at most eight interpolated numbers"
            );
        }
        let attributes = Count::<S>::map(&S::Varyings::tolerances(), |tolerance| Attribute {
            tolerance: mode.affine_within(*tolerance).min(MOST_TOLERANCE),
            ..Attribute::ZERO
        });
        Self {
            canvas,
            shader,
            mode,
            test,
            setup: Setup::new(Self::OVER_W, Self::LEAST_BITS, shift),
            attributes,
            slopes: Slopes {
                q: 0,
                p: Count::<S>::splat(0),
                scales: Count::<S>::splat(Scale::ONE),
                least: 0,
            },
            kernel: None,
            face: FaceOf::<S>::default(),
            kind: PhantomData,
        }
    }

    /// The pixels of a row from `column` on; [`Pixels`] starts one pixel before it.
    #[inline(always)]
    fn pixels(&self, row: i32, column: i32) -> Pixels<S, Z> {
        Pixels {
            shader: self.shader,
            face: self.face,
            test: self.test,
            point: Point::new(column - 1, row),
            depth: 0,
            stored: 0,
        }
    }

    #[inline(always)]
    fn cells(&mut self, row: i32, columns: Range<i32>) -> Option<Cells<'_, S::Color, O, D>> {
        let columns = columns.start.cast_unsigned()..columns.end.cast_unsigned();
        self.canvas.run(row.cast_unsigned(), columns)
    }

    /// Draws a span whose attributes are not divided by w and are fractions in units of 2^-30, each with its own
    /// scale.
    #[inline(never)]
    fn scaled_span(&mut self, row: i32, columns: Range<i32>, at: [i32; 2]) {
        let (pixels, scales) = (self.pixels(row, columns.start), self.slopes.scales);
        let (setup, attributes, slopes) = (&self.setup, &self.attributes, &self.slopes);
        let span = start::<Count<S>>(setup, attributes, slopes, at, columns.len());
        if let Some(cells) = self.cells(row, columns) {
            let restore = |p: &Numbers<S>| {
                Count::<S>::zip(p, &scales, |p: &i32, scale: &Scale| scale.restore(*p))
            };
            straight(span, restore, cells, pixels);
        }
    }

    /// Draws rows of one color.
    #[inline(always)]
    fn solid_rows(&mut self, first: i32, rows: &[Columns]) {
        for (row, &[start, end]) in (first..).zip(rows) {
            let columns = start.into()..end.into();
            let pixels = self.pixels(row, columns.start);
            if let Some(cells) = self.cells(row, columns) {
                solid(Count::<S>::splat(0), cells, pixels);
            }
        }
    }

    /// Draws rows of a near triangle whose attributes are linear.
    #[inline(always)]
    fn near_rows(&mut self, first: i32, rows: &[Columns]) {
        let mut rest = (self, (first..).zip(rows));
        loop {
            // In memory: a loop over pixels takes all registers of a small core, and the compiler would rather keep
            // this between rows in them.
            let (blit, rows) = black_box(&mut rest);
            let Some((row, &[start, end])) = rows.next() else {
                return;
            };
            let columns = i32::from(start)..i32::from(end);
            if columns.start >= columns.end {
                continue;
            }
            let (x, y) = (columns.start, row);
            let pixels = blit.pixels(row, x);
            let span = Span::<Count<S>> {
                q: blit.setup.q.near(x, y).cast_unsigned(),
                p: Count::<S>::map(&blit.attributes, |p: &Attribute| p.gradient.near(x, y)),
                dq: blit.setup.q.step,
                dp: Count::<S>::map(&blit.attributes, |p: &Attribute| p.gradient.step),
                down: blit.setup.down,
                count: columns.len(),
            };
            if let Some(cells) = blit.cells(row, columns) {
                straight(span, Self::restored, cells, pixels);
            }
        }
    }

    /// Draws rows of any triangle.
    #[inline(always)]
    fn any_rows(&mut self, first: i32, rows: &[Columns]) {
        for (row, &[start, end]) in (first..).zip(rows) {
            let (mut start, end) = (i32::from(start), i32::from(end));
            while start < end {
                let stop = end.min(start + SPAN);
                self.any_span(row, start..stop);
                start = stop;
            }
        }
    }

    /// Draws at most [`SPAN`] pixels of any triangle.
    #[inline(never)]
    fn any_span(&mut self, row: i32, columns: Range<i32>) {
        let Some(span) = self.span(row, columns.clone()) else {
            return;
        };
        let pixels = self.pixels(row, columns.start);
        let columns = columns.start.cast_unsigned()..columns.end.cast_unsigned();
        if let Some(cells) = self.canvas.run(row.cast_unsigned(), columns) {
            let span = span.anew();
            straight(span, Self::restored, cells, pixels);
        }
    }

    /// The attributes of interpolants that nothing divides.
    #[inline(always)]
    fn restored(p: &Numbers<S>) -> Numbers<S> {
        if Self::OVER_W {
            Count::<S>::map(p, |p: &i32| *p >> Scale::AFFINE_UP)
        } else {
            *p
        }
    }

    /// Starts any span of at most [`SPAN`] pixels. Draws it, unless it is linear: then its interpolants are returned.
    #[inline(always)]
    fn span(&mut self, row: i32, columns: Range<i32>) -> Option<Span<Count<S>>> {
        let [x, y] = [columns.start, row];
        // Exceptions are separate calls, made before anything is in a register.
        if Self::COUNT > 0 && !Self::OVER_W && self.kernel.is_none() {
            self.scaled_span(row, columns, [x, y]);
            return None;
        }
        if Self::COUNT > 0 && Self::OVER_W && M::IS_PRECISE && self.setup.least < STEEP {
            self.precise_span(row, columns, [x, y]);
            return None;
        }
        let (setup, attributes, slopes) = (&self.setup, &self.attributes, &self.slopes);
        let mut span = start::<Count<S>>(setup, attributes, slopes, [x, y], columns.len());
        if Self::COUNT == 0 || !Self::OVER_W || self.kernel == Some(Kernel::Straight) {
            return Some(span);
        }
        let scales = slopes.scales;
        let kernel = self.mode.of_span(self.kernel, &mut span, slopes);
        if kernel == Kernel::Tangent {
            tangent(&mut span);
        }
        if let Kernel::Straight | Kernel::Tangent = kernel {
            return Some(span);
        }
        let pixels = self.pixels(row, columns.start);
        let columns = columns.start.cast_unsigned()..columns.end.cast_unsigned();
        let cells = self.canvas.run(row.cast_unsigned(), columns)?;
        match kernel {
            Kernel::Straight | Kernel::Tangent => {}
            Kernel::Pieces(length) => pieces(span, length, scales, cells, pixels),
            Kernel::Newton => newton(span, cells, pixels),
            Kernel::Divide if M::IS_PRECISE => divide(span, scales, cells, pixels),
            Kernel::Divide => divide_apart(span, scales, cells, pixels),
        }
        None
    }

    /// Draws a span of a triangle in which steps would accumulate too much rounding: each pixel computes its
    /// interpolants anew.
    #[cold]
    #[inline(never)]
    fn precise_span(&mut self, row: i32, columns: Range<i32>, [x, y]: [i32; 2]) {
        let (pixels, scales) = (self.pixels(row, columns.start), self.slopes.scales);
        let (setup, attributes, slopes) = (&self.setup, &self.attributes, &self.slopes);
        let span = start::<Count<S>>(setup, attributes, slopes, [x, y], columns.len());
        let columns = columns.start.cast_unsigned()..columns.end.cast_unsigned();
        let Some(cells) = self.canvas.run(row.cast_unsigned(), columns) else {
            return;
        };
        let at = |i: i32| {
            let at = [x + i, y];
            let (q, up) = setup.precise_q(at);
            let p = Count::<S>::map(attributes, |p: &Attribute| p.gradient.far.precise(at, up));
            (q, p)
        };
        divide_anew(span, scales, at, cells, pixels);
    }
}

/// The span that begins at a pixel.
#[inline]
fn start<L: Lanes>(
    setup: &Setup,
    attributes: &L::Of<Attribute>,
    slopes: &Slopes<L>,
    [x, y]: [i32; 2],
    count: usize,
) -> Span<L> {
    let p = L::map(attributes, |p: &Attribute| p.gradient.at(x, y));
    Span {
        q: setup.q.at(x, y).cast_unsigned(),
        p,
        dq: slopes.q,
        dp: slopes.p,
        down: setup.down,
        count,
    }
}

impl<S, O, D, K, M, Z> Blitter for Blit<'_, '_, S, O, D, K, M, Z>
where
    S: Shader,
    O: Storage<S::Color>,
    D: DepthBuffer,
    K: ProjectionKind,
    M: Policy,
    Z: DepthTest,
{
    fn primitive(&mut self, primitive: &Primitive<'_>) {
        let [a, b, c] = self.shader.varyings(primitive);
        let ((a, face), (b, _), (c, _)) = (a.split(), b.split(), c.split());
        self.face = face;
        let corners = Count::<S>::zip(
            &Count::<S>::zip(&a, &b, |a, b| [*a, *b]),
            &c,
            |[a, b], c| [*a, *b, *c],
        );
        let attributes = self.attributes.as_mut().iter_mut();
        for (attribute, corners) in attributes.zip(corners.as_ref()) {
            attribute.corners = *corners;
        }
    }

    fn set_up(&mut self, patch: &Patch<'_>) {
        if !Self::VARIES {
            return;
        }
        self.setup.lay(self.attributes.as_mut(), patch);
        self.slopes = Slopes {
            q: self.setup.q.step,
            p: Count::<S>::map(&self.attributes, |p| p.gradient.step),
            scales: Count::<S>::map(&self.attributes, |p| p.scale),
            least: self.setup.least,
        };
        if Z::IS_BIASED {
            self.test.triangle(self.setup.steepness());
        }
        if Self::COUNT == 0 {
            return;
        }
        self.kernel = if !Self::OVER_W {
            let is_whole = Count::<S>::all(&self.slopes.scales, |scale| scale.bits() == WHOLE);
            (Self::LEAST_BITS == WHOLE && is_whole).then_some(Kernel::Straight)
        } else if self.setup.is_affine {
            Some(Kernel::Straight)
        } else {
            self.mode.of_triangle(&self.slopes)
        };
        if Self::OVER_W && M::IS_PRECISE && self.setup.least < STEEP {
            self.setup.lay_precise(self.attributes.as_mut(), patch);
        }
    }

    fn rows(&mut self, first: i32, rows: &[Columns]) {
        let is_straight = Self::COUNT == 0 || self.kernel == Some(Kernel::Straight);
        if !Self::VARIES {
            self.solid_rows(first, rows);
        } else if is_straight && self.setup.is_near {
            self.near_rows(first, rows);
        } else {
            self.any_rows(first, rows);
        }
    }
}
