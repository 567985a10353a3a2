//! Arrays of up to eight values whose operations are unrolled by hand.
//!
//! Optimized for size, a loop over `[T; N]` remains a loop over memory. These operations have no loop, so the values
//! stay in registers at every optimization level.

mod sealed {
    pub trait Sealed {}
}

/// A number of values from 0 to 8, written as the type `[(); N]`; it names an array of this length for any type of
/// value.
///
/// These numbers can be added, which array lengths cannot be on stable Rust. An adapter of a
/// [`Shader`](super::Shader) needs the sum to append its own varyings to those of the inner shader.
///
/// ```
/// use fixel::shade::Lanes;
/// let both = <[(); 2] as Lanes>::join::<[(); 1], _>([1, 2], [3]);
/// assert_eq!(both, [1, 2, 3]);
/// ```
pub trait Lanes: Copy + sealed::Sealed {
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

/// Any number above eight: a shader with this many varyings does not compile.
///
/// ```
/// use fixel::shade::{Lanes, TooMany};
/// assert_eq!(<TooMany as Lanes>::COUNT, 9);
/// ```
#[derive(Clone, Copy, Debug)]
pub struct TooMany;

/// The most numbers that a shader may interpolate.
pub(crate) const MOST: usize = 8;

impl sealed::Sealed for TooMany {}

impl Lanes for TooMany {
    type Of<T: Copy> = [T; 1];
    const COUNT: usize = MOST + 1;
    type Next = Self;
    type Plus<B: Lanes> = Self;

    fn splat<T: Copy>(value: T) -> [T; 1] {
        [value]
    }

    fn map<T: Copy, U: Copy>([a]: &[T; 1], mut f: impl FnMut(&T) -> U) -> [U; 1] {
        [f(a)]
    }

    fn zip<T: Copy, U: Copy, V: Copy>(
        [a]: &[T; 1],
        [b]: &[U; 1],
        mut f: impl FnMut(&T, &U) -> V,
    ) -> [V; 1] {
        [f(a, b)]
    }

    fn all<T: Copy>([a]: &[T; 1], mut f: impl FnMut(&T) -> bool) -> bool {
        f(a)
    }

    fn prepend<T: Copy>(first: T, _: [T; 1]) -> [T; 1] {
        [first]
    }

    fn behead<T: Copy>([first]: [T; 1]) -> (T, [T; 1]) {
        (first, [first])
    }

    fn join<B: Lanes, T: Copy>(a: [T; 1], _: B::Of<T>) -> [T; 1] {
        a
    }

    fn split<B: Lanes, T: Copy>([first]: [T; 1]) -> ([T; 1], B::Of<T>) {
        ([first], B::splat(first))
    }
}

impl sealed::Sealed for [(); 0] {}

impl Lanes for [(); 0] {
    type Of<T: Copy> = [T; 0];
    const COUNT: usize = 0;
    type Next = [(); 1];
    type Plus<B: Lanes> = B;

    #[inline]
    fn splat<T: Copy>(_: T) -> [T; 0] {
        []
    }

    #[inline]
    fn map<T: Copy, U: Copy>(_: &[T; 0], _: impl FnMut(&T) -> U) -> [U; 0] {
        []
    }

    #[inline]
    fn zip<T: Copy, U: Copy, V: Copy>(
        _: &[T; 0],
        _: &[U; 0],
        _: impl FnMut(&T, &U) -> V,
    ) -> [V; 0] {
        []
    }

    #[inline]
    fn all<T: Copy>(_: &[T; 0], _: impl FnMut(&T) -> bool) -> bool {
        true
    }

    #[inline]
    fn prepend<T: Copy>(first: T, _: [T; 0]) -> [T; 1] {
        [first]
    }

    #[inline]
    fn behead<T: Copy>([first]: [T; 1]) -> (T, [T; 0]) {
        (first, [])
    }

    #[inline]
    fn join<B: Lanes, T: Copy>(_: [T; 0], b: B::Of<T>) -> B::Of<T> {
        b
    }

    #[inline]
    fn split<B: Lanes, T: Copy>(both: B::Of<T>) -> ([T; 0], B::Of<T>) {
        ([], both)
    }
}

/// Implements a number above 0 from itself, its predecessor, its successor, and two names for each value but the
/// first.
macro_rules! lanes {
    ($($n:tt after $less:tt before $next:ty: $($x:ident $y:ident)*;)+) => {$(
        impl sealed::Sealed for [(); $n] {}

        impl Lanes for [(); $n] {
            type Of<T: Copy> = [T; $n];
            const COUNT: usize = $n;
            type Next = $next;
            type Plus<B: Lanes> = <<[(); $less] as Lanes>::Plus<B> as Lanes>::Next;

            #[inline]
            fn splat<T: Copy>(value: T) -> [T; $n] {
                [value; $n]
            }

            #[inline]
            fn map<T: Copy, U: Copy>([first, $($x),*]: &[T; $n], mut f: impl FnMut(&T) -> U) -> [U; $n] {
                [f(first), $(f($x)),*]
            }

            #[inline]
            fn zip<T: Copy, U: Copy, V: Copy>(
                [a, $($x),*]: &[T; $n],
                [b, $($y),*]: &[U; $n],
                mut f: impl FnMut(&T, &U) -> V,
            ) -> [V; $n] {
                [f(a, b), $(f($x, $y)),*]
            }

            #[inline]
            fn all<T: Copy>([first, $($x),*]: &[T; $n], mut f: impl FnMut(&T) -> bool) -> bool {
                f(first) $(&& f($x))*
            }

            lanes!(next $n $next: first $($x)*);

            #[inline]
            fn join<B: Lanes, T: Copy>(
                [first, $($x),*]: [T; $n],
                b: B::Of<T>,
            ) -> <Self::Plus<B> as Lanes>::Of<T> {
                let rest = <[(); $less]>::join::<B, T>([$($x),*], b);
                <[(); $less] as Lanes>::Plus::<B>::prepend(first, rest)
            }

            #[inline]
            fn split<B: Lanes, T: Copy>(
                both: <Self::Plus<B> as Lanes>::Of<T>,
            ) -> ([T; $n], B::Of<T>) {
                let (first, rest) = <[(); $less] as Lanes>::Plus::<B>::behead(both);
                let ([$($x),*], b) = <[(); $less]>::split::<B, T>(rest);
                ([first, $($x),*], b)
            }
        }
    )+};
    (next 8 $next:ty: $($x:ident)*) => {
        fn prepend<T: Copy>(first: T, _: [T; 8]) -> [T; 1] {
            [first]
        }

        fn behead<T: Copy>([first]: [T; 1]) -> (T, [T; 8]) {
            (first, [first; 8])
        }
    };
    (next $n:tt $next:ty: $($x:ident)*) => {
        #[inline]
        fn prepend<T: Copy>(before: T, [$($x),*]: [T; $n]) -> <$next as Lanes>::Of<T> {
            [before, $($x),*]
        }

        #[inline]
        fn behead<T: Copy>([before, $($x),*]: <$next as Lanes>::Of<T>) -> (T, [T; $n]) {
            (before, [$($x),*])
        }
    };
}

lanes! {
    1 after 0 before [(); 2]: ;
    2 after 1 before [(); 3]: x1 y1;
    3 after 2 before [(); 4]: x1 y1 x2 y2;
    4 after 3 before [(); 5]: x1 y1 x2 y2 x3 y3;
    5 after 4 before [(); 6]: x1 y1 x2 y2 x3 y3 x4 y4;
    6 after 5 before [(); 7]: x1 y1 x2 y2 x3 y3 x4 y4 x5 y5;
    7 after 6 before [(); 8]: x1 y1 x2 y2 x3 y3 x4 y4 x5 y5 x6 y6;
    8 after 7 before TooMany: x1 y1 x2 y2 x3 y3 x4 y4 x5 y5 x6 y6 x7 y7;
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

    #[test]
    fn more_than_eight_are_counted_as_nine() {
        type Sum = <[(); 5] as Lanes>::Plus<[(); 4]>;
        assert_eq!(<Sum as Lanes>::COUNT, MOST + 1);
    }
}
