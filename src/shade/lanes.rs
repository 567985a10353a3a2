//! Arrays of up to eight values, with operations that are unrolled by hand.
//!
//! In a build for size, a loop over `[T; N]` remains a loop over memory. These operations have no loop, so the values
//! stay in registers at every optimization level.

use crate::sealed::Sealed;

/// A number N from 0 to 8 as a type: the type `[(); N]` stands for N. [`Of`](Self::Of) is an array of N values.
///
/// Stable Rust cannot add array lengths, but it can add these numbers. An adapter of a [`Shader`](super::Shader) needs
/// the sum to append its own varyings to the inner shader's varyings.
#[doc(hidden)]
pub trait Lanes: Copy + Sealed {
    /// The array `[T; N]`.
    type Of<T: Copy>: Copy + AsRef<[T]> + AsMut<[T]>;

    /// The number N.
    const COUNT: usize;

    /// N + 1.
    type Next: Lanes;

    /// The sum of N and the number `B`.
    type Plus<B: Lanes>: Lanes;

    /// An array of equal values.
    fn splat<T: Copy>(value: T) -> Self::Of<T>;

    /// Applies a function to each value.
    fn map<T: Copy, U: Copy>(lanes: &Self::Of<T>, f: impl FnMut(&T) -> U) -> Self::Of<U>;

    /// Applies a function to each pair of values.
    fn zip<T: Copy, U: Copy, V: Copy>(
        a: &Self::Of<T>,
        b: &Self::Of<U>,
        f: impl FnMut(&T, &U) -> V,
    ) -> Self::Of<V>;

    /// Whether a condition holds for all values.
    fn all<T: Copy>(lanes: &Self::Of<T>, f: impl FnMut(&T) -> bool) -> bool;
}

/// The most numbers that a shader may interpolate.
pub(crate) const MOST: usize = 8;

/// Implements [`Lanes`] for a number. The arguments are the number, its successor, its predecessor (if any), and two
/// names for each value.
macro_rules! lanes {
    ($($n:tt before $next:tt $(after $less:tt)?: $($x:ident $y:ident)*;)+) => {$(
        impl Sealed for [(); $n] {}

        #[allow(unused_mut, unused_variables)] // if there are no values
        impl Lanes for [(); $n] {
            type Of<T: Copy> = [T; $n];
            const COUNT: usize = $n;
            type Next = [(); $next];
            lanes!(sum $($less)?);

            #[inline]
            fn splat<T: Copy>(value: T) -> [T; $n] {
                [value; $n]
            }

            #[inline]
            fn map<T: Copy, U: Copy>([$($x),*]: &[T; $n], mut f: impl FnMut(&T) -> U) -> [U; $n] {
                [$(f($x)),*]
            }

            #[inline]
            fn zip<T: Copy, U: Copy, V: Copy>(
                [$($x),*]: &[T; $n],
                [$($y),*]: &[U; $n],
                mut f: impl FnMut(&T, &U) -> V,
            ) -> [V; $n] {
                [$(f($x, $y)),*]
            }

            #[inline]
            fn all<T: Copy>([$($x),*]: &[T; $n], mut f: impl FnMut(&T) -> bool) -> bool {
                true $(&& f($x))*
            }

        }
    )+};
    // Sums end at eight. If a pair of varyings has more than eight numbers, `tolerance` in varyings.rs does not
    // compile.
    (sum) => {
        type Plus<B: Lanes> = B;
    };
    (sum $less:tt) => {
        type Plus<B: Lanes> = <<[(); $less] as Lanes>::Plus<B> as Lanes>::Next;
    };
}

lanes! {
    0 before 1: ;
    1 before 2 after 0: x0 y0;
    2 before 3 after 1: x0 y0 x1 y1;
    3 before 4 after 2: x0 y0 x1 y1 x2 y2;
    4 before 5 after 3: x0 y0 x1 y1 x2 y2 x3 y3;
    5 before 6 after 4: x0 y0 x1 y1 x2 y2 x3 y3 x4 y4;
    6 before 7 after 5: x0 y0 x1 y1 x2 y2 x3 y3 x4 y4 x5 y5;
    7 before 8 after 6: x0 y0 x1 y1 x2 y2 x3 y3 x4 y4 x5 y5 x6 y6;
    8 before 8 after 7: x0 y0 x1 y1 x2 y2 x3 y3 x4 y4 x5 y5 x6 y6 x7 y7;
}
