//! The depth buffer, or its absence.

use core::marker::PhantomData;
use core::mem;
use core::ops::Range;

use super::format::{DepthFormat, Linear, linear};
use crate::num::wide::at_least;

/// A canvas's depth buffer: [`NoDepth`] or [`Depth`]. Sealed.
///
/// Use it as the bound of code that draws with or without a depth buffer. A fragment is drawn if it is at least as near
/// as the stored depth, so of two equal depths, the later one wins.
///
/// ```
/// use embedded_graphics::pixelcolor::Gray8;
/// use fixel::prelude::*;
/// use fixel::canvas::{DepthBuffer, Native};
///
/// /// Draws a scene with or without a depth buffer.
/// fn draw<D: DepthBuffer>(canvas: &mut Canvas<'_, Gray8, Native, D>) {
///     canvas.clear(Gray8::new(0));
/// }
///
/// let (mut pixels, mut depths) = ([Gray8::new(9); 4], [7; 4]);
/// draw(&mut Canvas::new(&mut pixels, 2, 2)?);
/// draw(&mut Canvas::new(&mut pixels, 2, 2)?.with_depth(&mut depths)?);
/// assert_eq!(depths, [0; 4]);
/// # Ok::<(), Error>(())
/// ```
#[allow(private_bounds)] // so that it is sealed
pub trait DepthBuffer: Buffer {}

/// No depth buffer: later fragments cover earlier ones.
///
/// ```
/// use embedded_graphics::pixelcolor::Gray8;
/// use fixel::canvas::{Canvas, Native, NoDepth};
/// let mut pixels = [Gray8::new(0); 4];
/// let canvas: Canvas<Gray8, Native, NoDepth> = Canvas::new(&mut pixels, 2, 2)?;
/// # Ok::<(), fixel::Error>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct NoDepth;

/// The caller's depth buffer, 16 bits per pixel. 65535 is the near plane, 0 is infinitely far.
///
#[cfg_attr(doc, doc = diagram!("depth"))]
/// `F` is the format of a depth: [`Linear`], [`Float`](super::Float) or [`WideFloat`](super::WideFloat). In each
/// format, a nearer depth is a greater number, so the depth test is the same comparison. The formats differ in cost,
/// and in the ratio far/near that they resolve. The table lists the greatest depth step, relative to the distance, at
/// the far end. "None" means that every depth at the far end is stored as 0.
///
/// | far / near | [`Linear`] | [`Float`](super::Float) | [`WideFloat`](super::WideFloat) |
/// |---:|---:|---:|---:|
/// | 100 | 0.15 % | 0.024 % | 0.049 % |
/// | 1,000 | 1.5 % | 0.024 % | 0.049 % |
/// | 10,000 | 15 % | 0.024 % | 0.049 % |
/// | 65,536 | none | 0.024 % | 0.049 % |
/// | 1,000,000 | none | none | 0.049 % |
///
/// Surfaces that are closer together than a step have equal depths, and the later one wins.
///
/// Under a parallel projection, depth is linear in the distance itself: use [`Linear`]. Shaders see the same linear
/// [`Fragment::depth`](crate::Fragment::depth) with every format.
///
/// ```
/// use embedded_graphics::pixelcolor::Gray8;
/// use fixel::canvas::{Canvas, Depth, Native};
/// let (mut pixels, mut depths) = ([Gray8::new(0); 4], [0; 4]);
/// let canvas: Canvas<Gray8, Native, Depth> = Canvas::new(&mut pixels, 2, 2)?.with_depth(&mut depths)?;
/// # Ok::<(), fixel::Error>(())
/// ```
#[derive(Debug)]
pub struct Depth<'d, F = Linear> {
    pub(super) cells: &'d mut [u16],
    pub(super) format: PhantomData<F>,
}

impl DepthBuffer for NoDepth {}
impl<F: DepthFormat> DepthBuffer for Depth<'_, F> {}

/// The working part of [`DepthBuffer`].
pub(crate) trait Buffer {
    /// The depth of one pixel, to be tested and changed.
    type Cell<'a>
    where
        Self: 'a;

    /// The depths of a run of pixels.
    type Cells<'a>
    where
        Self: 'a;

    /// Whether depths are tested and stored.
    const IS_KEPT: bool;

    /// Borrows the depths of a run of pixels; `None` if the buffer ends before them.
    fn cells(&mut self, range: Range<usize>) -> Option<Self::Cells<'_>>;

    /// Splits off the first `count` depths of a run, or all that are left.
    fn first<'a>(cells: &mut Self::Cells<'a>, count: usize) -> Self::Cells<'a>
    where
        Self: 'a;

    /// Iterates over the depths; endlessly if none are kept.
    fn each<'a>(cells: Self::Cells<'a>) -> impl Iterator<Item = Self::Cell<'a>>
    where
        Self: 'a;

    /// Encodes the depth `q` · 2^-`down` in 16 bits; see [`Encode::encode`](super::format::Encode::encode).
    fn encode(q: u32, down: u32) -> u32;

    /// Whether a fragment of this encoded depth is drawn.
    fn passes(cell: &Self::Cell<'_>, depth: u32) -> bool;

    /// Stores the depth of a fragment that was drawn.
    fn store(cell: Self::Cell<'_>, depth: u16);

    /// Sets every depth to infinity.
    fn clear(&mut self);
}

impl Buffer for NoDepth {
    type Cell<'a> = ();
    type Cells<'a> = ();

    const IS_KEPT: bool = false;

    #[inline]
    fn cells(&mut self, _: Range<usize>) -> Option<()> {
        Some(())
    }

    #[inline]
    fn first<'a>((): &mut (), _: usize)
    where
        Self: 'a,
    {
    }

    #[inline]
    fn each<'a>((): ()) -> impl Iterator<Item = ()>
    where
        Self: 'a,
    {
        // An iterator over a slice of units zips with the colors' iterator without a second check
        // for the end.
        const ANY: &[()] = &[(); usize::MAX];
        ANY.iter().copied()
    }

    #[inline]
    fn encode(q: u32, down: u32) -> u32 {
        linear(q, down)
    }

    #[inline]
    fn passes((): &(), _: u32) -> bool {
        true
    }

    #[inline]
    fn store((): (), _: u16) {}

    #[inline]
    fn clear(&mut self) {}
}

impl<F: DepthFormat> Buffer for Depth<'_, F> {
    type Cell<'a>
        = &'a mut u16
    where
        Self: 'a;
    type Cells<'a>
        = &'a mut [u16]
    where
        Self: 'a;

    const IS_KEPT: bool = true;

    #[inline]
    fn cells(&mut self, range: Range<usize>) -> Option<&mut [u16]> {
        self.cells.get_mut(range)
    }

    #[inline]
    #[allow(clippy::mut_mut)] // the slice is replaced by its rest
    fn first<'a>(cells: &mut &'a mut [u16], count: usize) -> &'a mut [u16]
    where
        Self: 'a,
    {
        first(cells, count)
    }

    #[inline]
    fn each<'a>(cells: &'a mut [u16]) -> impl Iterator<Item = &'a mut u16>
    where
        Self: 'a,
    {
        cells.iter_mut()
    }

    #[inline]
    fn encode(q: u32, down: u32) -> u32 {
        F::encode(q, down)
    }

    #[inline]
    fn passes(cell: &&mut u16, depth: u32) -> bool {
        at_least(depth, **cell)
    }

    #[inline]
    fn store(cell: &mut u16, depth: u16) {
        *cell = depth;
    }

    #[inline]
    fn clear(&mut self) {
        self.cells.fill(0);
    }
}

/// Splits off the first `count` elements of a slice, or all that are left.
#[inline]
#[allow(clippy::mut_mut)] // the slice is replaced by its rest
pub(super) fn first<'a, T>(slice: &mut &'a mut [T], count: usize) -> &'a mut [T] {
    let all = mem::take(slice);
    let (first, rest) = all.split_at_mut(count.min(all.len()));
    *slice = rest;
    first
}
