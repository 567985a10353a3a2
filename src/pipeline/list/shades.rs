//! The values of a shader, computed once for all bands.

use core::fmt;
use core::ptr;

use heapless::Vec;

use super::{Entry, Listed, Prepared};
use crate::error::Error;
use crate::mesh::{Missing, Primitive};
use crate::pipeline::{corner_cache, keeps_corners};
use crate::shade::{Fragment, Lanes, Shader, Varyings};

/// Memory for the values that a shader computes at the corners of a prepared list's triangles or edges, such as light.
///
/// Without a `ShadeList`, a shader computes its [`varyings`](Shader::varyings) for a triangle or edge once in each band
/// that contains a part of it. [`Prepared::shade`] computes them once per frame and stores them here. The pixels are
/// the same. How much this saves depends on the number of bands that a triangle reaches into. In a test with a small
/// lit ball and bands of eight rows, that is 1.3 bands on average. The `ShadeList` then saves 8 % of the instructions
/// on a Cortex-M4, or 10 % if the light is computed per face. With larger triangles or smaller bands, it saves more.
///
/// For each triangle, the list stores the values to interpolate at the three corners, and the values [per
/// face](crate::shade::PerFace). An edge takes as much memory as a triangle. White light takes 12 bytes per triangle if
/// it is computed at the corners, and 4 bytes if it is computed per face.
///
/// ```
/// use embedded_graphics::pixelcolor::{Gray8, GrayColor};
/// use fixel::{ShadeList, prelude::*, shade::Lit};
///
/// static BALL: Mesh = shape!(sphere(12, 8));
/// let projection = Projection::perspective(deg!(60), (16, 12), fx!(1), fx!(10))?;
/// let mvp = projection * Transform::translate(vec3!(0, 0, -2.5));
/// let sun = Light::new(vec3!(1, 2, 3), fx!(0), fx!(1))?;
/// let white = Flat::new(Gray8::WHITE).lit(sun);
///
/// let mut list: DrawList<100, 80> = DrawList::new(); // on a microcontroller, statics
/// let mut light: ShadeList<Lit<Flat<Gray8>>, 100> = ShadeList::new();
/// let ball = list.prepare(&DrawOptions::new(), (16, 12), &BALL, &mvp)?;
/// let lit = ball.shade(&mut light, |()| white)?;
///
/// let mut color = [Gray8::BLACK; 16 * 4];
/// for first_row in [0, 4, 8] {
///     let mut band = Canvas::band(&mut color, 16, 12, first_row)?;
///     band.clear(Gray8::BLACK);
///     band.draw_prepared(&ball, &lit(&()))?; // no light is computed here
///     // … to the display
/// }
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone)]
pub struct ShadeList<S: Shader, const ELEMENTS: usize> {
    values: Vec<Shade<S>, ELEMENTS>,
}

/// The numbers at three corners, and the values of the face.
type Shade<S> = (
    [<<<S as Shader>::Varyings as Varyings>::Lanes as Lanes>::Of<i32>; 3],
    <<S as Shader>::Varyings as Varyings>::Face,
);

impl<S: Shader, const ELEMENTS: usize> Default for ShadeList<S, ELEMENTS> {
    fn default() -> Self {
        Self::new()
    }
}

impl<S: Shader, const ELEMENTS: usize> fmt::Debug for ShadeList<S, ELEMENTS> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("ShadeList").finish_non_exhaustive()
    }
}

impl<S: Shader, const ELEMENTS: usize> ShadeList<S, ELEMENTS> {
    /// An empty list.
    #[must_use]
    pub const fn new() -> Self {
        Self { values: Vec::new() }
    }
}

impl<'a, T, G: Listed, O, K> Prepared<'a, T, G, O, K> {
    /// Computes the shader's values for each triangle or edge, once for all bands. `shader_of` returns the shader for
    /// an object's material; if there are no materials, write `|()| shader`.
    ///
    /// Returns a function that, like `shader_of`, takes a material and returns a shader. These shaders use the stored
    /// values: draw with them in each band. If there are no materials, call the returned function with `&()`. For an
    /// element that is not in the list, a shader computes the values as usual.
    ///
    /// # Errors
    ///
    /// [`Error::Full`], with the length that is needed, if `memory` holds fewer elements than the prepared list.
    pub fn shade<S: Shader, const ELEMENTS: usize, F: Fn(&T) -> S>(
        &self,
        memory: &'a mut ShadeList<S, ELEMENTS>,
        shader_of: F,
    ) -> Result<impl Fn(&T) -> Shaded<'a, S> + use<'a, T, G, O, K, S, ELEMENTS, F>, Error> {
        let values = &mut memory.values;
        values.clear();
        let none = <<S::Varyings as Varyings>::Lanes as Lanes>::splat(0);
        let empty = ([none; 3], <S::Varyings as Varyings>::Face::default());
        let needed = self.entries.len();
        values.resize(needed, empty).map_err(|_| Error::Full {
            of: G::ELEMENTS,
            needed,
            room: ELEMENTS,
        })?;
        let first = self.entries.as_ptr().addr();
        let mut missing = Missing::default();
        let frame = 0..self.screen.frame.height;
        for (material, placed, entries) in self.runs(&frame) {
            let shader = shader_of(material);
            let corners = corner_cache(keeps_corners(&shader), entries.len());
            let mut run = placed.run((&self.screen, &frame), entries, self.vertices);
            run.placement.corners = corners.as_ref();
            for entry in entries {
                let element = entry.element.wrapping_sub(placed.listing.first) as usize;
                let values = values.get_mut(index(ptr::from_ref(entry).addr(), first));
                if let (Some(indices), Some(values)) = (placed.thing.indices(element), values) {
                    let primitive = run.placement.primitive(indices, run.area(entry.corners));
                    let corners = shader.varyings(&primitive);
                    let [(a, face), (b, _), (c, _)] = corners.map(Varyings::split);
                    *values = ([a, b, c], face);
                }
            }
            missing += run.placement.missing.get();
        }
        let values = &*values;
        Ok(move |material: &T| Shaded {
            shader: shader_of(material),
            first,
            values,
            missing,
        })
    }
}

/// The index in a list of the entry at the address `entry`. `first` is the address of the list's first entry. For an
/// address outside the list, the result is beyond the list's end.
#[inline]
fn index(entry: usize, first: usize) -> usize {
    entry.wrapping_sub(first) / size_of::<Entry>()
}

/// A shader with the values that [`Prepared::shade`] computed. It borrows the [`ShadeList`].
#[doc(hidden)]
#[derive(Clone, Copy)]
pub struct Shaded<'a, S: Shader> {
    shader: S,
    /// The address of the list's first entry. The list cannot change while these values exist, so the address of an
    /// entry tells its index, and whether it belongs to this list.
    first: usize,
    values: &'a [Shade<S>],
    /// The attributes that the shaders asked for and the meshes lack.
    missing: Missing,
}

impl<S: Shader> Shader for Shaded<'_, S> {
    type Color = S::Color;
    type Varyings = S::Varyings;

    const READS_DEPTH: bool = S::READS_DEPTH;

    #[inline]
    fn varyings(&self, primitive: &Primitive<'_>) -> [S::Varyings; 3] {
        match self.values.get(index(primitive.entry, self.first)) {
            Some(&(numbers, face)) => {
                primitive.placement.miss(self.missing);
                numbers.map(|corner| Varyings::join(corner, face))
            }
            None => self.shader.varyings(primitive),
        }
    }

    #[inline]
    fn shade(&self, at: &Fragment, varyings: S::Varyings) -> Option<S::Color> {
        self.shader.shade(at, varyings)
    }
}
