//! Shaders of many types in one instance of the rasterizer.
//!
//! A rasterizer is compiled for each type of shader, and this takes most of the time in which a test is built. A test
//! that checks shaders and not the rasterizer draws them as [`Erased`] shaders: all that have the same varyings share a
//! rasterizer. With [`Padded`], shaders with different varyings share one, too.

use std::cell::RefCell;

use embedded_graphics::pixelcolor::PixelColor;
use fixel::Primitive;
use fixel::prelude::*;
use fixel::shade::{ColorOf, Lanes, Output, PerFace, Texels, Tolerance, Varyings, Within};

/// What the rasterizer asks of a shader with varyings `V`, on a canvas with color `C`.
trait Surface<V, C> {
    fn varyings(&self, primitive: &Primitive<'_>) -> [V; 3];
    fn shade(&self, at: &Fragment, varyings: V) -> Option<C>;
}

/// The color of an opaque output.
fn finish<O: Output>(output: O, at: &Fragment) -> O::Color {
    assert_eq!(output.opacity(), 255, "an erased shader is opaque");
    output.finish(at.point)
}

impl<S: Shader> Surface<S::Varyings, ColorOf<S>> for S {
    fn varyings(&self, primitive: &Primitive<'_>) -> [S::Varyings; 3] {
        self.varyings(primitive)
    }

    fn shade(&self, at: &Fragment, varyings: S::Varyings) -> Option<ColorOf<S>> {
        Some(finish(self.shade(at, varyings)?, at))
    }
}

/// An opaque shader of any type with varyings `V`, on a canvas with color `C`.
pub struct Erased<'a, V, C>(&'a dyn Surface<V, C>);

impl<V, C> Clone for Erased<'_, V, C> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<V, C> Copy for Erased<'_, V, C> {}

impl<'a, V, C> Erased<'a, V, C> {
    pub fn new<S: ShaderFor<C, Varyings = V>>(shader: &'a S) -> Self {
        Self(shader)
    }
}

impl<V: Varyings, C: PixelColor> Shader for Erased<'_, V, C> {
    type Color = C;
    type Varyings = V;

    fn varyings(&self, primitive: &Primitive<'_>) -> [V; 3] {
        self.0.varyings(primitive)
    }

    fn shade(&self, at: &Fragment, varyings: V) -> Option<C> {
        self.0.shade(at, varyings)
    }
}

/// The varyings of [`Padded`] shaders: texture coordinates, six numbers as exact as light, and the face's number.
pub type Padding = ((Texels, Within<64, [i32; 6]>), PerFace<usize>);

/// A shader with more numbers than it needs. The others are 0 everywhere, so they change no pixel.
pub struct Padded<S: Shader> {
    shader: S,
    places: Places,
    /// The shader's values of each face.
    faces: RefCell<Vec<FaceOf<S>>>,
}

type FaceOf<S> = <<S as Shader>::Varyings as Varyings>::Face;

/// For each number that a shader interpolates: its place among the numbers of [`Padding`].
struct Places(Vec<usize>);

// These functions are not generic, so that they are compiled only once.
impl Places {
    fn new(count: usize, wanted: fn(usize) -> Tolerance) -> Self {
        let mut free: Vec<_> = (0..8).collect();
        let mut place = |lane| {
            let fits = |&at: &usize| Padding::tolerance(at) == wanted(lane);
            free.remove(
                free.iter()
                    .position(fits)
                    .expect("a place for each varying"),
            )
        };
        Self((0..count).map(&mut place).collect())
    }

    fn spread(&self, numbers: &[i32], face: usize) -> Padding {
        let mut padded = [0; 8];
        for (&place, &number) in self.0.iter().zip(numbers) {
            padded[place] = number;
        }
        Padding::join(padded, (((), ()), face))
    }

    fn collect(&self, varyings: Padding, numbers: &mut [i32]) -> usize {
        let (padded, (_, face)) = varyings.split();
        for (number, &place) in numbers.iter_mut().zip(&self.0) {
            *number = padded[place];
        }
        face
    }
}

impl<S: Shader> Padded<S> {
    /// # Panics
    ///
    /// A varying has no place: it needs another accuracy, or small triangles keep it in one number with another varying.
    pub fn new(shader: S) -> Self {
        assert!(!S::Varyings::PAIRS);
        let count = <<S::Varyings as Varyings>::Lanes as Lanes>::COUNT;
        Self {
            shader,
            places: Places::new(count, S::Varyings::tolerance),
            faces: RefCell::default(),
        }
    }

    /// The shader, to be drawn.
    pub fn erased(&self) -> Erased<'_, Padding, ColorOf<S>> {
        Erased(self)
    }
}

impl<S: Shader> Surface<Padding, ColorOf<S>> for Padded<S> {
    fn varyings(&self, primitive: &Primitive<'_>) -> [Padding; 3] {
        let [a, b, c] = self.shader.varyings(primitive);
        let ((a, values), (b, _), (c, _)) = (a.split(), b.split(), c.split());
        let mut faces = self.faces.borrow_mut();
        let face = faces.len();
        faces.push(values);
        let spread = |numbers| self.places.spread(numbers, face);
        [spread(a.as_ref()), spread(b.as_ref()), spread(c.as_ref())]
    }

    fn shade(&self, at: &Fragment, varyings: Padding) -> Option<ColorOf<S>> {
        let mut numbers = <S::Varyings as Varyings>::Lanes::splat(0);
        let face = self.places.collect(varyings, numbers.as_mut());
        let varyings = Varyings::join(numbers, self.faces.borrow()[face]);
        Some(finish(self.shader.shade(at, varyings)?, at))
    }
}
