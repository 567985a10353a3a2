//! Gives all shaders one interface, so that the simulator can choose a shader at run time.
//!
//! Firmware names its shader, and the compiler makes a rasterizer for this shader. The simulator has a hundred shaders,
//! each for several depth formats and modes. A rasterizer for each combination would take minutes to compile. Here,
//! shaders with different varyings share a rasterizer, which interpolates enough numbers for all of them. A number that
//! a shader does not use is 0 everywhere, so it changes no pixel.

use embedded_graphics::pixelcolor::raw::RawU16;
use embedded_graphics::pixelcolor::{PixelColor, Rgb565, Rgb888};
use embedded_graphics::prelude::RawData;
use fixel::shade::{
    Gouraud, Lanes, Output, PerFace, Texels, Tolerance, Translucent, Varyings, Within,
};
use fixel::{Fragment, Primitive, Shader, ShaderFor};

/// The values of a face as numbers. The values of a light take the most numbers: three channels.
type Face = [i32; 3];

/// Values that are the same at all pixels of a face, and their conversion to numbers and back.
pub trait FaceValues: Copy {
    /// How many numbers the values take.
    const COUNT: usize;

    fn put(self, numbers: &mut [i32]);
    fn take(numbers: &[i32]) -> Self;
}

impl FaceValues for () {
    const COUNT: usize = 0;

    fn put(self, _: &mut [i32]) {}
    fn take(_: &[i32]) -> Self {}
}

impl<const N: usize> FaceValues for [i32; N] {
    const COUNT: usize = N;

    fn put(self, numbers: &mut [i32]) {
        numbers[..N].copy_from_slice(&self);
    }

    fn take(numbers: &[i32]) -> Self {
        let mut values = [0; N];
        values.copy_from_slice(&numbers[..N]);
        values
    }
}

impl FaceValues for i32 {
    const COUNT: usize = 1;

    fn put(self, numbers: &mut [i32]) {
        numbers[0] = self;
    }

    fn take(numbers: &[i32]) -> Self {
        numbers[0]
    }
}

impl FaceValues for Rgb565 {
    const COUNT: usize = 1;

    fn put(self, numbers: &mut [i32]) {
        numbers[0] = RawU16::from(self).into_inner().into();
    }

    fn take(numbers: &[i32]) -> Self {
        // `put` made the number from the 16 bits of a color.
        RawU16::from_u32(numbers[0].cast_unsigned()).into()
    }
}

impl<A: FaceValues, B: FaceValues> FaceValues for (A, B) {
    const COUNT: usize = A::COUNT + B::COUNT;

    fn put(self, numbers: &mut [i32]) {
        let (a, b) = numbers.split_at_mut(A::COUNT);
        self.0.put(a);
        self.1.put(b);
    }

    fn take(numbers: &[i32]) -> Self {
        let (a, b) = numbers.split_at(A::COUNT);
        (A::take(a), B::take(b))
    }
}

/// A texture coordinate, and four numbers for light, tint and fog.
pub type Many = ((Texels, Within<64, [i32; 4]>), PerFace<Face>);
/// Three channels of a color that is computed at the corners, or a gray to be dithered, with light and fog.
pub type Channels = (
    (
        (Within<8192, [i32; 3]>, Within<1024, [i32; 1]>),
        (Within<64, [i32; 3]>, Within<64, [i32; 1]>),
    ),
    PerFace<Face>,
);
/// Three channels of the vertices' colors. Small triangles store the three channels in two numbers.
pub type Pairs = <Gouraud<Rgb565> as Shader>::Varyings;

/// A shader in the layout that it needs. The shader's colors are converted to colors of 24 bits.
pub enum Surface<'a> {
    Many(Any<'a, Many>),
    Channels(Any<'a, Channels>),
    Pairs(Any<'a, Pairs>),
}

/// A shader that is adapted to the layout `V`: its varyings are at some places among the numbers of `V`.
trait Shade<V: Varyings> {
    fn varyings(&self, primitive: &Primitive<'_>) -> [V; 3];
    fn shade(&self, at: &Fragment, varyings: V) -> Option<Translucent<Rgb888>>;
}

struct Placed<S, C> {
    shader: S,
    screen: Screen<C>,
    /// For each number that the shader interpolates: its index among the layout's numbers.
    places: [usize; 8],
}

/// Converts a color to a color of 24 bits.
pub type Screen<C> = fn(C) -> Rgb888;

/// Gives each of `count` wanted numbers a place of its own among the `offered` numbers, with the same tolerance. `None`
/// if there are too few places.
fn places(
    (count, wanted): (usize, fn(usize) -> Tolerance),
    (offered, tolerance): (usize, fn(usize) -> Tolerance),
) -> Option<[usize; 8]> {
    let mut places = [0; 8];
    let mut free: Vec<usize> = (0..offered).collect();
    for (number, place) in places.iter_mut().enumerate().take(count) {
        let at = free
            .iter()
            .position(|&at| tolerance(at) == wanted(number))?;
        *place = free.remove(at);
    }
    Some(places)
}

impl<C, S, V> Shade<V> for Placed<S, C>
where
    C: PixelColor,
    S: ShaderFor<C, Varyings: Varyings<Face: FaceValues>>,
    V: Varyings<Face: FaceValues>,
{
    fn varyings(&self, primitive: &Primitive<'_>) -> [V; 3] {
        let place = |varyings: S::Varyings| {
            let (inner, values) = varyings.split();
            let mut numbers = V::Lanes::splat(0);
            for (number, &place) in inner.as_ref().iter().zip(&self.places) {
                numbers.as_mut()[place] = *number;
            }
            let mut face = Face::default();
            values.put(&mut face);
            V::join(numbers, FaceValues::take(&face))
        };
        // Not `map`, which would add 7 % to the code that the compiler makes of this program.
        let [a, b, c] = self.shader.varyings(primitive);
        [place(a), place(b), place(c)]
    }

    fn shade(&self, at: &Fragment, varyings: V) -> Option<Translucent<Rgb888>> {
        let (numbers, values) = varyings.split();
        let mut face = Face::default();
        values.put(&mut face);
        let mut inner = <S::Varyings as Varyings>::Lanes::splat(0);
        for (number, &place) in inner.as_mut().iter_mut().zip(&self.places) {
            *number = numbers.as_ref()[place];
        }
        let varyings = S::Varyings::join(inner, FaceValues::take(&face));
        let output = self.shader.shade(at, varyings)?;
        Some(Translucent {
            color: (self.screen)(output.finish(at.point)),
            opacity: output.opacity(),
        })
    }
}

/// A shader of any kind, in a box.
pub struct Any<'a, V>(Box<dyn Shade<V> + 'a>);

impl<V: Varyings> Shader for &Any<'_, V> {
    type Color = Rgb888;
    type Varyings = V;

    fn varyings(&self, primitive: &Primitive<'_>) -> [V; 3] {
        self.0.varyings(primitive)
    }

    fn shade(&self, at: &Fragment, varyings: V) -> Option<Rgb888> {
        Some(self.0.shade(at, varyings)?.color)
    }
}

/// A shader that returns colors with opacities.
pub struct Glass<'s, 'a, V>(pub &'s Any<'a, V>);

impl<V> Clone for Glass<'_, '_, V> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<V> Copy for Glass<'_, '_, V> {}

impl<V: Varyings> Shader for Glass<'_, '_, V> {
    type Color = Translucent<Rgb888>;
    type Varyings = V;

    fn varyings(&self, primitive: &Primitive<'_>) -> [V; 3] {
        self.0.0.varyings(primitive)
    }

    fn shade(&self, at: &Fragment, varyings: V) -> Option<Self::Color> {
        self.0.0.shade(at, varyings)
    }
}

impl<'a> Surface<'a> {
    /// Wraps a shader of 24-bit colors.
    ///
    /// # Errors
    ///
    /// As for [`new`](Self::new).
    pub fn of_rgb<S>(shader: S) -> super::Result<Self>
    where
        S: ShaderFor<Rgb888, Varyings: Varyings<Face: FaceValues>> + 'a,
    {
        Self::new(Self::Many, shader, |color| color)
    }

    /// Wraps a shader in a layout, for example in [`Surface::Many`]. The layout must have places for the shader's
    /// varyings.
    ///
    /// # Errors
    ///
    /// A varying has no place, which is a mistake in this program.
    pub fn new<C, V, S>(
        layout: fn(Any<'a, V>) -> Self,
        shader: S,
        screen: Screen<C>,
    ) -> super::Result<Self>
    where
        C: PixelColor + 'a,
        V: Varyings<Face: FaceValues>,
        S: ShaderFor<C, Varyings: Varyings<Face: FaceValues>> + 'a,
    {
        let places = places(
            (
                <S::Varyings as Varyings>::Lanes::COUNT,
                S::Varyings::tolerance,
            ),
            (V::Lanes::COUNT, V::tolerance),
        );
        match places.filter(|_| S::Varyings::PAIRS == V::PAIRS) {
            Some(places) => Ok(layout(Any(Box::new(Placed {
                shader,
                screen,
                places,
            })))),
            None => Err("no rasterizer of the simulator interpolates what this look needs".into()),
        }
    }
}
