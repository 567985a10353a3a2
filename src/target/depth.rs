//! The depth buffer, or the want of one.

use core::mem;
use core::ops::Range;

/// What a canvas knows about depth: [`NoDepth`], [`Depth`] or [`FloatDepth`](super::FloatDepth).
///
/// A shader is drawn if it is at least as near as what is stored, so of equals the later wins.
///
/// ```
/// use embedded_graphics::pixelcolor::Gray8;
/// use fixel::prelude::*;
/// use fixel::target::{DepthBuffer, Native};
///
/// /// A scene that is drawn with or without a depth buffer.
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
pub trait DepthBuffer {
    /// The depth of one pixel, open to be tested and changed.
    type Cell<'a>
    where
        Self: 'a;

    /// The depths of a run of pixels.
    type Cells<'a>
    where
        Self: 'a;

    /// Whether depths are looked at or kept.
    const IS_KEPT: bool;

    /// The depths of a run of pixels; `None` if they are not all there.
    fn cells(&mut self, range: Range<usize>) -> Option<Self::Cells<'_>>;

    /// Takes the first `count` of a run, or all that are left.
    fn first<'a>(cells: &mut Self::Cells<'a>, count: usize) -> Self::Cells<'a>
    where
        Self: 'a;

    /// The depths one by one; where there are none, without end.
    fn each<'a>(cells: Self::Cells<'a>) -> impl Iterator<Item = Self::Cell<'a>>
    where
        Self: 'a;

    /// The 16 bits that stand for a depth, more of it being nearer: of `q` · 2^-`down`, where the near plane has
    /// 2^16 and infinity 0, and `down` is 15 to 31.
    fn encode(q: u32, down: u32) -> u32;

    /// Whether a shader of this depth, as encoded, is to be drawn.
    fn passes(cell: &Self::Cell<'_>, depth: u32) -> bool;

    /// Stores the depth of a shader that was drawn.
    fn store(cell: Self::Cell<'_>, depth: u16);

    /// Stores infinite distance everywhere.
    fn clear(&mut self);
}

/// No depth buffer: what is drawn later covers what was drawn before.
///
/// ```
/// use embedded_graphics::pixelcolor::Gray8;
/// use fixel::target::{Canvas, Native, NoDepth};
/// let mut pixels = [Gray8::new(0); 4];
/// let canvas: Canvas<Gray8, Native, NoDepth> = Canvas::new(&mut pixels, 2, 2)?;
/// # Ok::<(), fixel::Error>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct NoDepth;

impl DepthBuffer for NoDepth {
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
        // A slice of nothing, as a slice's iterator is walked together with the colours' without
        // a second end to look out for.
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

/// The caller's depth buffer, linear in 1/w: 0 is infinitely far, 65535 the near plane.
///
/// As fine as a depth can be near by, and coarse far off: [`FloatDepth`](super::FloatDepth) has the figures of both.
///
/// ```
/// use embedded_graphics::pixelcolor::Gray8;
/// use fixel::target::{Canvas, Depth, Native};
/// let (mut pixels, mut depths) = ([Gray8::new(0); 4], [0; 4]);
/// let canvas: Canvas<Gray8, Native, Depth> = Canvas::new(&mut pixels, 2, 2)?.with_depth(&mut depths)?;
/// # Ok::<(), fixel::Error>(())
/// ```
#[derive(Debug)]
pub struct Depth<'d>(pub(super) &'d mut [u16]);

impl DepthBuffer for Depth<'_> {
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
        self.0.get_mut(range)
    }

    #[inline]
    #[allow(clippy::mut_mut)] // what is taken is no longer in it
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
        linear(q, down)
    }

    #[inline]
    fn passes(cell: &&mut u16, depth: u32) -> bool {
        depth >= u32::from(**cell)
    }

    #[inline]
    fn store(cell: &mut u16, depth: u16) {
        *cell = depth;
    }

    #[inline]
    fn clear(&mut self) {
        self.0.fill(0);
    }
}

/// A depth in linear steps: `q` shifted down.
#[inline]
pub(crate) const fn linear(q: u32, down: u32) -> u32 {
    // 31 bits shifted down by 15 or more.
    q >> (down & 31)
}

/// Takes the first `count` elements of a slice, or all that are left.
#[inline]
#[allow(clippy::mut_mut)] // the slice is exchanged for its rest
pub(super) fn first<'a, T>(slice: &mut &'a mut [T], count: usize) -> &'a mut [T] {
    let all = mem::take(slice);
    let (first, rest) = all.split_at_mut(count.min(all.len()));
    *slice = rest;
    first
}
