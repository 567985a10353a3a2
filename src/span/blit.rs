//! A draw call's shader, mode and canvas, behind the interface that the rasterizer calls.

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
use crate::raster::{Attribute, Blitter, DepthShift, Patch, SPAN, Scale, Setup};
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
            let p = Count::<S>::map(attributes, |p: &Attribute| {
                setup.precise(&p.gradient, at, up)
            });
            (q, p)
        };
        divide_anew(span, scales, at, cells, pixels);
    }
}

/// The span that begins `x` columns and `y` rows from the pixel that contains the patch's first position.
#[inline]
fn start<L: Lanes>(
    setup: &Setup,
    attributes: &L::Of<Attribute>,
    slopes: &Slopes<L>,
    [x, y]: [i32; 2],
    count: usize,
) -> Span<L> {
    let p = if setup.is_near() {
        L::map(attributes, |p: &Attribute| p.gradient.near(x, y))
    } else {
        L::map(attributes, |p: &Attribute| setup.far(&p.gradient, x, y))
    };
    Span {
        q: setup.q(x, y),
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

    fn set_up(&mut self, patch: &Patch<'_>) -> i32 {
        if !Self::VARIES {
            return i32::MAX;
        }
        self.setup.lay(self.attributes.as_mut(), patch);
        self.slopes = Slopes {
            q: self.setup.step(),
            p: Count::<S>::map(&self.attributes, |p| p.gradient.step),
            scales: Count::<S>::map(&self.attributes, |p| p.scale),
            least: self.setup.least,
        };
        if Z::IS_BIASED {
            self.test.triangle(self.setup.steepness());
        }
        if Self::COUNT == 0 {
            return SPAN;
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
        SPAN
    }

    fn span(&mut self, row: i32, columns: Range<i32>, x: i32, y: i32) {
        // Exceptions are separate calls, made before anything is in a register.
        if Self::COUNT > 0 && !Self::OVER_W && self.kernel.is_none() {
            return self.scaled_span(row, columns, [x, y]);
        }
        if Self::COUNT > 0 && Self::OVER_W && M::IS_PRECISE && self.setup.least < STEEP {
            return self.precise_span(row, columns, [x, y]);
        }
        let count = columns.len();
        let pixels = self.pixels(row, columns.start);
        let columns = columns.start.cast_unsigned()..columns.end.cast_unsigned();
        let Some(cells) = self.canvas.run(row.cast_unsigned(), columns) else {
            return;
        };
        if !Self::VARIES {
            return solid(Count::<S>::splat(0), cells, pixels);
        }
        let (setup, attributes, slopes) = (&self.setup, &self.attributes, &self.slopes);
        let mut span = start::<Count<S>>(setup, attributes, slopes, [x, y], count);
        if Self::COUNT == 0 || !Self::OVER_W {
            return straight(span, |p| *p, cells, pixels);
        }
        let kernel = match self.kernel {
            Some(Kernel::Straight) => Kernel::Straight,
            kernel => self.mode.of_span(kernel, &mut span, slopes),
        };
        let scales = slopes.scales;
        match kernel {
            Kernel::Straight | Kernel::Tangent => {
                if kernel == Kernel::Tangent {
                    tangent(&mut span);
                }
                let restore = |p: &Numbers<S>| Count::<S>::map(p, |p: &i32| *p >> Scale::AFFINE_UP);
                straight(span, restore, cells, pixels);
            }
            Kernel::Pieces(length) => pieces(span, length, scales, cells, pixels),
            Kernel::Newton => newton(span, cells, pixels),
            Kernel::Divide if M::IS_PRECISE => divide(span, scales, cells, pixels),
            Kernel::Divide => divide_apart(span, scales, cells, pixels),
        }
    }
}
