//! A shader that records its input, for tests that check more than colors.

use std::cell::RefCell;

use embedded_graphics::pixelcolor::{Gray8, PixelColor};
use fixel::Primitive;
use fixel::prelude::*;
use fixel::shade::{ColorOf, Lanes, Output, PerFace, Tolerance, Varyings};

/// A shader's input and output at a pixel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Seen<const N: usize, C = Gray8> {
    pub pixel: [i32; 2],
    pub depth: u16,
    /// The triangle's index in the mesh.
    pub face: usize,
    /// The first `N` interpolated numbers; 0 if the shader has fewer.
    pub values: [i32; N],
    /// The color as the canvas stores it; `None` for a discarded pixel.
    pub color: Option<C>,
}

impl<const N: usize, C> Seen<N, C> {
    /// The same pixel with other numbers.
    pub fn with_values<const M: usize>(self, values: [i32; M]) -> Seen<M, C> {
        Seen {
            pixel: self.pixel,
            depth: self.depth,
            face: self.face,
            values,
            color: self.color,
        }
    }
}

/// The record of a draw call.
#[derive(Debug)]
pub struct Record<const N: usize, C = Gray8> {
    /// The pixels, in the order in which they were drawn.
    pub seen: Vec<Seen<N, C>>,
    /// Each triangle's index in the mesh, and the numbers at its corners.
    pub corners: Vec<(usize, [[i32; N]; 3])>,
}

/// A shader that records the input of another shader, and draws the other shader's output.
#[derive(Clone, Copy)]
pub struct Recorder<'a, S: Shader, const N: usize> {
    shader: S,
    record: &'a RefCell<Record<N, ColorOf<S>>>,
}

/// Records the input of the shader in a draw call.
pub fn record<S: Shader, const N: usize>(
    shader: S,
    draw: impl FnOnce(&Recorder<'_, S, N>),
) -> Record<N, ColorOf<S>> {
    let record = RefCell::new(Record {
        seen: Vec::new(),
        corners: Vec::new(),
    });
    draw(&Recorder {
        shader,
        record: &record,
    });
    record.into_inner()
}

fn numbers<V: Varyings, const N: usize>(varyings: V) -> [i32; N] {
    let (numbers, _) = varyings.split();
    std::array::from_fn(|i| numbers.as_ref().get(i).copied().unwrap_or_default())
}

impl<S: Shader, const N: usize> Shader for Recorder<'_, S, N> {
    type Color = S::Color;
    type Varyings = (S::Varyings, PerFace<usize>);

    fn varyings(&self, primitive: &Primitive<'_>) -> [Self::Varyings; 3] {
        let (corners, face) = (
            self.shader.varyings(primitive),
            primitive.face().unwrap_or_default(),
        );
        let mut record = self.record.borrow_mut();
        record.corners.push((face, corners.map(numbers)));
        corners.map(|corner| (corner, PerFace(face)))
    }

    fn shade(&self, at: &Fragment, (inside, PerFace(face)): Self::Varyings) -> Option<S::Color> {
        let output = self.shader.shade(at, inside);
        self.record.borrow_mut().seen.push(Seen {
            pixel: [at.point.x, at.point.y],
            depth: at.depth,
            face,
            values: numbers(inside),
            color: output.map(|output| output.finish(at.point)),
        });
        output
    }
}

/// A shader that interpolates any values. The shader draws every pixel in the same color, or discards every pixel.
#[derive(Clone, Copy)]
pub struct Probe<'a, V, C = Gray8> {
    pub values: &'a dyn Fn(&Corner<'_>) -> V,
    pub color: Option<C>,
}

impl<V: Varyings, C: PixelColor> Shader for Probe<'_, V, C> {
    type Color = C;
    type Varyings = V;

    fn varyings(&self, primitive: &Primitive<'_>) -> [V; 3] {
        primitive.corners(|corner| (self.values)(corner))
    }

    fn shade(&self, _: &Fragment, _: V) -> Option<C> {
        self.color
    }
}

/// `[(); N]` has this trait if N numbers can be interpolated.
pub trait Few<const N: usize>: Lanes<Of<i32> = [i32; N]> {}

impl<const N: usize, L: Lanes<Of<i32> = [i32; N]>> Few<N> for L {}

/// Numbers that are interpolated as exactly as texture coordinates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coordinates<const N: usize>(pub [i32; N]);

impl<const N: usize> Varyings for Coordinates<N>
where
    [(); N]: Few<N>,
{
    type Lanes = [(); N];
    type Face = ();

    fn tolerance(_: usize) -> Tolerance {
        Tolerance::Texels
    }

    fn split(self) -> ([i32; N], ()) {
        (self.0, ())
    }

    fn join(numbers: [i32; N], (): ()) -> Self {
        Self(numbers)
    }
}
