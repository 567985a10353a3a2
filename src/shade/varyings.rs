//! The values that a shader interpolates. The types of the values say how exact each value must be, and which values
//! belong to a whole face.

use super::lanes::{Lanes, MOST};

/// The error that a varying may have. If linear interpolation stays within this error, a mode can avoid the perspective
/// division.
///
/// The type of the [`Varyings`] determines the tolerance: [`Texels`] have the tolerance of the mode, [`Within`] states
/// its tolerance, and plain numbers have the tolerance 0.
///
/// ```
/// use fixel::shade::{Texels, Tolerance, Varyings, Within};
/// assert_eq!(Texels::tolerance(0), Tolerance::Texels);
/// assert_eq!(Within::<64, i32>::tolerance(0), Tolerance::Units(64));
/// assert_eq!(i32::tolerance(0), Tolerance::Units(0));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Tolerance {
    /// The varying is a texture coordinate, in texels times 2^16; the [mode](crate::mode) decides which error it may
    /// have.
    Texels,
    /// The error may be at most this many units of the varying.
    Units(u32),
}

/// Values that a [`Shader`](super::Shader) computes at the corners of a triangle and receives back at each pixel.
///
/// | type | value at a pixel |
/// |---|---|
/// | `i32`, or `[i32; N]`, N up to 8 | interpolated in perspective |
/// | [`Within<UNITS, V>`](Within) | like `V`, but a triangle that hardly changes in depth may be interpolated linearly if the error is at most `UNITS` |
/// | [`Texels`] | two texture coordinates, as exact as the [mode](crate::mode) promises |
/// | [`PerFace<T>`](PerFace) | the value of the first corner, of any type; nothing is interpolated |
/// | `(A, B)` | both values |
/// | `()` | nothing |
///
/// A shader interpolates at most eight numbers; a shader with more does not compile.
///
/// ```compile_fail
/// use fixel::shade::{Texels, Varyings};
/// let _ = <(Texels, ([i32; 4], [i32; 3]))>::tolerance(0); // nine
/// ```
/// ```
/// use fixel::shade::{Texels, Varyings};
/// let _ = <(Texels, ([i32; 3], [i32; 3]))>::tolerance(0);
/// ```
///
/// If even one number must be exact, all numbers of the shader are interpolated exactly, even in triangles in which a
/// texture alone would be interpolated linearly. So prefer [`Within`] if a small error cannot be seen.
///
/// The shader chooses the unit of an interpolated number. The default mode returns a number with an error of up to
/// about 60 units. The number may also be outside the range of the corners' values, by the same amount. So choose a
/// unit far below anything that an eye can see, such as 2⁻¹⁶.
///
/// ```
/// use fixel::shade::{PerFace, Texels, Varyings, Within};
/// // A texture, its brightness to within 64/65,536, and a color for the whole face.
/// type Mine = ((Texels, Within<64, i32>), PerFace<u8>);
/// let corner: Mine = ((Texels([1 << 16, 0]), Within(65_536)), PerFace(7));
/// let (numbers, face) = corner.split();
/// assert_eq!(numbers, [1 << 16, 0, 65_536]);
/// assert_eq!(Mine::join(numbers, face), corner);
/// ```
#[cfg_attr(doc, doc = include_str!("../guide/tables.html"))]
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot be interpolated",
    note = "varyings are `i32`, `[i32; N]` with N up to 8, `Texels`, `Within<UNITS, V>`, `PerFace<T>`, `()` or a pair of these"
)]
pub trait Varyings: Copy {
    /// The number of interpolated numbers, as a type.
    type Lanes: Lanes;

    /// The values that all pixels of a face share.
    type Face: Copy + Default;

    /// Whether there are three numbers, of which the first and the third are levels of at most five bits, raised by
    /// half a step (as [`Precise`](super::Precise) stores them). Small triangles then interpolate these two levels in
    /// one number.
    #[doc(hidden)]
    const PAIRS: bool = false;

    /// How exact the number at this index must be; by default, it must be exact.
    #[must_use]
    #[inline]
    fn tolerance(_lane: usize) -> Tolerance {
        Tolerance::Units(0)
    }

    /// Splits a corner's values into the numbers to interpolate and the values that belong to the face.
    fn split(self) -> (<Self::Lanes as Lanes>::Of<i32>, Self::Face);

    /// Joins the numbers at a pixel and the face's values.
    fn join(numbers: <Self::Lanes as Lanes>::Of<i32>, face: Self::Face) -> Self;
}

impl<const N: usize> Varyings for [i32; N]
where
    [(); N]: Lanes<Of<i32> = [i32; N]>,
{
    type Lanes = [(); N];
    type Face = ();

    #[inline]
    fn split(self) -> (Self, ()) {
        (self, ())
    }

    #[inline]
    fn join(numbers: Self, (): ()) -> Self {
        numbers
    }
}

impl Varyings for i32 {
    type Lanes = [(); 1];
    type Face = ();

    #[inline]
    fn split(self) -> ([Self; 1], ()) {
        ([self], ())
    }

    #[inline]
    fn join([number]: [Self; 1], (): ()) -> Self {
        number
    }
}

impl Varyings for () {
    type Lanes = [(); 0];
    type Face = ();

    #[inline]
    fn split(self) -> ([i32; 0], ()) {
        ([], ())
    }

    #[inline]
    fn join(_: [i32; 0], (): ()) -> Self {}
}

/// A column and a row of a texture, in texels with 16 fraction bits. Their error is at most what the
/// [mode](crate::mode) promises for textures.
///
/// ```
/// use fixel::shade::Texels;
/// let Texels([column, row]) = Texels([3 << 16, 1 << 15]); // column 3, row ½
/// assert_eq!((column >> 16, row >> 16), (3, 0));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Texels(pub [i32; 2]);

impl Varyings for Texels {
    type Lanes = [(); 2];
    type Face = ();

    #[inline]
    fn tolerance(_: usize) -> Tolerance {
        Tolerance::Texels
    }

    #[inline]
    fn split(self) -> ([i32; 2], ()) {
        (self.0, ())
    }

    #[inline]
    fn join(numbers: [i32; 2], (): ()) -> Self {
        Self(numbers)
    }
}

/// Numbers that may each have an error of `UNITS` units, so that a mode can avoid the perspective division.
///
/// A color channel with 16 fraction bits, for example, may have an error of 1/8 step, which is invisible:
///
/// ```
/// use fixel::shade::Within;
/// type Color = Within<8192, [i32; 3]>;
/// let white: Color = Within([31 << 16, 63 << 16, 31 << 16]);
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Within<const UNITS: u32, V>(pub V);

impl<const UNITS: u32, V: Varyings> Varyings for Within<UNITS, V> {
    type Lanes = V::Lanes;
    type Face = V::Face;

    const PAIRS: bool = V::PAIRS;

    #[inline]
    fn tolerance(_: usize) -> Tolerance {
        Tolerance::Units(UNITS)
    }

    #[inline]
    fn split(self) -> (<V::Lanes as Lanes>::Of<i32>, V::Face) {
        self.0.split()
    }

    #[inline]
    fn join(numbers: <V::Lanes as Lanes>::Of<i32>, face: V::Face) -> Self {
        Self(V::join(numbers, face))
    }
}

/// A value that all pixels of a face share: the value of its first corner.
///
/// ```
/// use fixel::shade::{PerFace, Varyings};
/// // Nothing is interpolated.
/// assert_eq!(PerFace('a').split(), ([], 'a'));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PerFace<T>(pub T);

impl<T: Copy + Default> Varyings for PerFace<T> {
    type Lanes = [(); 0];
    type Face = T;

    #[inline]
    fn split(self) -> ([i32; 0], T) {
        ([], self.0)
    }

    #[inline]
    fn join(_: [i32; 0], face: T) -> Self {
        Self(face)
    }
}

type Both<A, B> = <<A as Varyings>::Lanes as Lanes>::Plus<<B as Varyings>::Lanes>;

impl<A: Varyings, B: Varyings> Varyings for (A, B) {
    type Lanes = Both<A, B>;
    type Face = (A::Face, B::Face);

    #[inline]
    fn tolerance(lane: usize) -> Tolerance {
        const {
            assert!(
                A::Lanes::COUNT + B::Lanes::COUNT <= MOST,
                "a shader interpolates at most eight numbers"
            );
        }
        match lane.checked_sub(A::Lanes::COUNT) {
            None => A::tolerance(lane),
            Some(lane) => B::tolerance(lane),
        }
    }

    #[inline]
    fn split(self) -> (<Both<A, B> as Lanes>::Of<i32>, (A::Face, B::Face)) {
        let ((a, a_face), (b, b_face)) = (self.0.split(), self.1.split());
        let mut both = Both::<A, B>::splat(0);
        let (first, second) = both.as_mut().split_at_mut(A::Lanes::COUNT);
        first.copy_from_slice(a.as_ref());
        second.copy_from_slice(b.as_ref());
        (both, (a_face, b_face))
    }

    #[inline]
    fn join(numbers: <Both<A, B> as Lanes>::Of<i32>, (a_face, b_face): (A::Face, B::Face)) -> Self {
        let (mut a, mut b) = (A::Lanes::splat(0), B::Lanes::splat(0));
        let (first, second) = numbers.as_ref().split_at(A::Lanes::COUNT);
        a.as_mut().copy_from_slice(first);
        b.as_mut().copy_from_slice(second);
        (A::join(a, a_face), B::join(b, b_face))
    }
}
