//! The depth buffer, or its absence.

use core::fmt;
use core::marker::PhantomData;

use super::format::{DepthFormat, LinearDepth};
use crate::sealed::Sealed;

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
pub trait DepthBuffer: Sealed {
    /// The depth of a pixel in memory.
    #[doc(hidden)]
    type Cell: Copy;

    /// Whether depths are tested and stored.
    #[doc(hidden)]
    const IS_KEPT: bool;

    /// The depths of all pixels, row by row; more than there are pixels if none are kept.
    #[doc(hidden)]
    fn cells(&self) -> &[Self::Cell];

    /// The same, to be changed.
    #[doc(hidden)]
    fn cells_mut(&mut self) -> &mut [Self::Cell];

    /// Encodes the depth `q` · 2^-`down` in 16 bits; see [`DepthFormat::encode`].
    #[doc(hidden)]
    fn encode(q: u32, down: u32) -> u32;

    /// Converts an encoded depth to its stored form.
    #[doc(hidden)]
    fn store(depth: u16) -> Self::Cell;

    /// The depth that is stored for a pixel; `None` if none are kept.
    #[doc(hidden)]
    fn load(cell: Self::Cell) -> Option<u16>;
}

/// No depth buffer: later fragments cover earlier ones.
///
/// ```
/// use embedded_graphics::pixelcolor::Gray8;
/// use fixel::canvas::{Canvas, Native, NoDepth};
/// let mut pixels = [Gray8::new(0); 4];
/// let canvas: Canvas<Gray8, Native, NoDepth> = Canvas::new(&mut pixels, 2, 2)?;
/// # Ok::<(), fixel::Error>(())
/// ```
#[derive(Clone, Copy)]
pub struct NoDepth {
    /// One for each pixel, like the depths of a buffer. They take no memory.
    cells: [(); usize::MAX],
}

/// The caller's depth buffer, 16 bits per pixel. 65535 is the near plane, 0 is infinitely far.
///
#[cfg_attr(doc, doc = diagram!("depth"))]
/// `F` is the format of a depth: [`LinearDepth`], [`FloatDepth`](super::FloatDepth) or [`WideFloatDepth`](super::WideFloatDepth). In each
/// format, a nearer depth is a greater number, so the depth test is the same comparison. The formats differ in cost,
/// and in the ratio far/near that they resolve. The table lists the greatest depth step, relative to the distance, at
/// the far end. "None" means that every depth at the far end is stored as 0.
///
/// | far / near | [`LinearDepth`] | [`FloatDepth`](super::FloatDepth) | [`WideFloatDepth`](super::WideFloatDepth) |
/// |---:|---:|---:|---:|
/// | 100 | 0.15 % | 0.024 % | 0.049 % |
/// | 1,000 | 1.5 % | 0.024 % | 0.049 % |
/// | 10,000 | 15 % | 0.024 % | 0.049 % |
/// | 65,536 | none | 0.024 % | 0.049 % |
/// | 1,000,000 | none | none | 0.049 % |
///
/// Surfaces that are closer together than a step have equal depths, and the later one wins.
///
/// Under a parallel projection, depth is linear in the distance itself: use [`LinearDepth`]. Shaders see the same linear
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
pub struct Depth<'d, F = LinearDepth> {
    cells: &'d mut [u16],
    format: PhantomData<F>,
}

impl NoDepth {
    pub(super) const NEW: Self = Self {
        cells: [(); usize::MAX],
    };
}

impl fmt::Debug for NoDepth {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("NoDepth")
    }
}

impl<'d, F> Depth<'d, F> {
    pub(super) const fn new(cells: &'d mut [u16]) -> Self {
        Self {
            cells,
            format: PhantomData,
        }
    }
}

impl Sealed for NoDepth {}
impl<F> Sealed for Depth<'_, F> {}

impl DepthBuffer for NoDepth {
    type Cell = ();

    const IS_KEPT: bool = false;

    #[inline]
    fn cells(&self) -> &[()] {
        &self.cells
    }

    #[inline]
    fn cells_mut(&mut self) -> &mut [()] {
        &mut self.cells
    }

    #[inline]
    fn encode(q: u32, down: u32) -> u32 {
        LinearDepth::encode(q, down)
    }

    #[inline]
    fn store(_: u16) {}

    #[inline]
    fn load((): ()) -> Option<u16> {
        None
    }
}

impl<F: DepthFormat> DepthBuffer for Depth<'_, F> {
    type Cell = u16;

    const IS_KEPT: bool = true;

    #[inline]
    fn cells(&self) -> &[u16] {
        self.cells
    }

    #[inline]
    fn cells_mut(&mut self) -> &mut [u16] {
        self.cells
    }

    #[inline]
    fn encode(q: u32, down: u32) -> u32 {
        F::encode(q, down)
    }

    #[inline]
    fn store(depth: u16) -> u16 {
        depth
    }

    #[inline]
    fn load(depth: u16) -> Option<u16> {
        Some(depth)
    }
}
