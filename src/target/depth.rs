//! The depth buffer, or the want of one.

use core::ops::Range;

/// What a canvas knows about depth: [`NoDepth`] or [`Depth`].
///
/// A fragment is drawn if it is at least as near as what is stored, so of equals the later wins.
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

    /// Whether depths are looked at or kept.
    const IS_KEPT: bool;

    /// The depths of a run of pixels.
    fn cells(&mut self, range: Range<usize>) -> impl ExactSizeIterator<Item = Self::Cell<'_>>;

    /// Whether a fragment of this depth, of 16 bits, is to be drawn.
    fn passes(cell: &Self::Cell<'_>, depth: u32) -> bool;

    /// Stores the depth of a fragment that was drawn.
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

    const IS_KEPT: bool = false;

    #[inline]
    fn cells(&mut self, range: Range<usize>) -> impl ExactSizeIterator<Item = ()> {
        // A slice of nothing, as a slice's iterator is walked together with the colours' without
        // a second end to look out for.
        const ANY: &[()] = &[(); usize::MAX];
        ANY.get(range).unwrap_or_default().iter().copied()
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

/// The caller's depth buffer: 0 is infinitely far, 65535 the near plane.
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

    const IS_KEPT: bool = true;

    #[inline]
    fn cells(&mut self, range: Range<usize>) -> impl ExactSizeIterator<Item = &mut u16> {
        self.0.get_mut(range).unwrap_or_default().iter_mut()
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
