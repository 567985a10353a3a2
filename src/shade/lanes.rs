//! Arrays of up to eight values whose operations are unrolled by hand.
//!
//! Optimized for size, a loop over `[T; N]` remains a loop over memory. These operations have no loop, so the values
//! stay in registers at every optimization level.

use crate::sealed::Sealed;

/// A number of values from 0 to 8, written as the type `[(); N]`; it names an array of this length for any type of
/// value.
///
/// Unlike array lengths, these numbers can be added on stable Rust. An adapter of a [`Shader`](super::Shader) needs the
/// sum to append its own varyings to those of the inner shader.
#[doc(hidden)]
pub trait Lanes: Copy + Sealed {
    /// The array `[T; N]`.
    type Of<T: Copy>: Copy + AsRef<[T]> + AsMut<[T]>;

    /// The number N.
    const COUNT: usize;

    /// N + 1.
    type Next: Lanes;

    /// The sum of both numbers.
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

    /// Inserts a value before the others.
    fn prepend<T: Copy>(first: T, rest: Self::Of<T>) -> <Self::Next as Lanes>::Of<T>;

    /// Splits off the first value.
    fn behead<T: Copy>(lanes: <Self::Next as Lanes>::Of<T>) -> (T, Self::Of<T>);

    /// Appends the values of `b` to those of `a`.
    fn join<B: Lanes, T: Copy>(a: Self::Of<T>, b: B::Of<T>) -> <Self::Plus<B> as Lanes>::Of<T>;

    /// Splits the values that [`join`](Self::join) joined.
    fn split<B: Lanes, T: Copy>(both: <Self::Plus<B> as Lanes>::Of<T>) -> (Self::Of<T>, B::Of<T>);
}

/// The most numbers that a shader may interpolate.
pub(crate) const MOST: usize = 8;

/// Implements a number from itself, its successor, its predecessor (if any), and two names for each value.
macro_rules! lanes {
    ($($n:tt before $next:tt $(after $less:tt)?: $($x:ident $y:ident)*;)+) => {$(
        impl Sealed for [(); $n] {}

        #[allow(unused_mut, unused_variables)] // of no values
        impl Lanes for [(); $n] {
            type Of<T: Copy> = [T; $n];
            const COUNT: usize = $n;
            type Next = [(); $next];

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

            lanes!(next $n $next: $($x)*);
            lanes!(sum $n $($less)?: $($x)*);
        }
    )+};
    // A sum of more than eight does not compile where it is a pair of varyings.
    (next 8 $next:tt: $($x:ident)*) => {
        fn prepend<T: Copy>(first: T, _: [T; 8]) -> [T; 8] {
            [first; 8]
        }

        fn behead<T: Copy>(all: [T; 8]) -> (T, [T; 8]) {
            (all[0], all)
        }
    };
    (next $n:tt $next:tt: $($x:ident)*) => {
        #[inline]
        fn prepend<T: Copy>(before: T, [$($x),*]: [T; $n]) -> [T; $next] {
            [before, $($x),*]
        }

        #[inline]
        fn behead<T: Copy>([before, $($x),*]: [T; $next]) -> (T, [T; $n]) {
            (before, [$($x),*])
        }
    };
    (sum 0:) => {
        type Plus<B: Lanes> = B;

        #[inline]
        fn join<B: Lanes, T: Copy>(_: [T; 0], b: B::Of<T>) -> B::Of<T> {
            b
        }

        #[inline]
        fn split<B: Lanes, T: Copy>(both: B::Of<T>) -> ([T; 0], B::Of<T>) {
            ([], both)
        }
    };
    (sum $n:tt $less:tt: $first:ident $($x:ident)*) => {
        type Plus<B: Lanes> = <<[(); $less] as Lanes>::Plus<B> as Lanes>::Next;

        #[inline]
        fn join<B: Lanes, T: Copy>(
            [first, $($x),*]: [T; $n],
            b: B::Of<T>,
        ) -> <Self::Plus<B> as Lanes>::Of<T> {
            let rest = <[(); $less]>::join::<B, T>([$($x),*], b);
            <[(); $less] as Lanes>::Plus::<B>::prepend(first, rest)
        }

        #[inline]
        fn split<B: Lanes, T: Copy>(both: <Self::Plus<B> as Lanes>::Of<T>) -> ([T; $n], B::Of<T>) {
            let (first, rest) = <[(); $less] as Lanes>::Plus::<B>::behead(both);
            let ([$($x),*], b) = <[(); $less]>::split::<B, T>(rest);
            ([first, $($x),*], b)
        }
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_added_and_split_again() {
        let both = <[(); 3] as Lanes>::join::<[(); 5], _>([1, 2, 3], [4, 5, 6, 7, 8]);
        assert_eq!(both, [1, 2, 3, 4, 5, 6, 7, 8]);
        let parts = <[(); 3] as Lanes>::split::<[(); 5], _>(both);
        assert_eq!(parts, ([1, 2, 3], [4, 5, 6, 7, 8]));
        assert_eq!(<[(); 0] as Lanes>::join::<[(); 1], _>([], [9]), [9]);
        assert_eq!(<[(); 1] as Lanes>::split::<[(); 0], _>([9]), ([9], []));
    }
}
