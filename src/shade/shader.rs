//! The interface between geometry and color: the values that a shader interpolates, and the color it computes from
//! them.

use embedded_graphics::geometry::Point;

use super::{
    Adapted, ByFace, ByVertex, ColorOf, Converted, Density, Dithered, FaceLit, Fog, InFog,
    Lighting, Lit, Map, Output, PixelFormat, Tint, Tinted, Varyings,
};
use crate::mesh::Primitive;

/// A pixel about to be shaded.
///
/// ```
/// use embedded_graphics::{geometry::Point, pixelcolor::Gray8};
/// use fixel::prelude::*;
/// let pixel = Fragment { point: Point::new(4, 2), depth: 65535 };
/// assert_eq!(Flat::new(Gray8::new(7)).shade(&pixel, ()), Some(Gray8::new(7)));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Fragment {
    /// Column and row in the frame, (0, 0) at the top left.
    pub point: Point,
    /// Depth: 65535 at the near plane, falling toward 0 with the distance. Whatever the format of the depth buffer,
    /// this depth is linear in 1/w; under a parallel projection, it is linear in the distance.
    pub depth: u16,
}

/// Colors a surface: a shader computes values at the corners of each triangle, and a pixel's color from the
/// interpolated values.
///
#[cfg_attr(doc, doc = page_picture!("lit", "A ring that is lit"))]
/// [`varyings`](Self::varyings) is called once for each triangle, edge or point that has pixels, or once for each of
/// the parts into which clipping cuts a triangle or edge. [`shade`](Self::shade) is called once for each visible pixel,
/// with the values interpolated in correct perspective; it returns `None` to leave the pixel as it is. [`Varyings`]
/// lists the types that can be interpolated.
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::{Rgb565, RgbColor}};
/// use fixel::prelude::*;
/// use fixel::{Primitive, Window};
///
/// /// Stripes along the texture's u.
/// #[derive(Clone, Copy)]
/// struct Stripes;
///
/// impl Shader for Stripes {
///     type Color = Rgb565;
///     type Varyings = i32;
///
///     fn varyings(&self, primitive: &Primitive) -> [i32; 3] {
///         primitive.corners(|corner| corner.uv().x.to_bits()) // 2^20 is 1
///     }
///
///     fn shade(&self, _: &Fragment, u: i32) -> Option<Rgb565> {
///         Some(if u & 0x4_0000 == 0 { Rgb565::WHITE } else { Rgb565::RED })
///     }
/// }
///
/// static SQUARE: Mesh = shape!(plane(1, 1));
/// let projection = Projection::orthographic(Window::centered(fx!(2), fx!(2)), fx!(0), fx!(2))?;
/// let mvp = projection * Camera::top(Vec3::ZERO, fx!(1));
/// let mut pixels = [Rgb565::BLACK; 16];
/// let mut canvas = Canvas::new(&mut pixels, 8, 2)?;
/// canvas.draw(&SQUARE, &mvp, &Stripes);
/// let mut display = MockDisplay::new();
/// canvas.show(&mut display)?;
/// display.assert_pattern(&["WWRRWWRR", "WWRRWWRR"]);
/// # Ok::<(), Error>(())
/// ```
///
/// A shader that wraps another shader calls the inner `varyings` and `shade`. The outer shader's
/// [`Varyings`](Self::Varyings) are the inner shader's `Varyings`, or a pair of these and further varyings. Most
/// effects need no shader of their own: see [`map`](Self::map).
///
/// To change the color, the outer shader calls [`lit`](Output::lit) or [`map`](Output::map) on the output of the inner
/// shader. The outer shader returns the result, which is a color in full precision:
///
/// ```
/// # use fixel::{Fragment, PixelFormat, Primitive, Shader};
/// # use fixel::shade::{ColorOf, Illumination, Output, PreciseOf};
/// /// A surface at half of its brightness.
/// #[derive(Clone, Copy)]
/// struct Dim<S>(S);
///
/// impl<S: Shader<Color: Output<Color: PixelFormat>>> Shader for Dim<S> {
///     type Color = PreciseOf<S>;
///     type Varyings = S::Varyings;
///
///     fn varyings(&self, primitive: &Primitive) -> [S::Varyings; 3] {
///         self.0.varyings(primitive)
///     }
///
///     fn shade(&self, at: &Fragment, varyings: S::Varyings) -> Option<PreciseOf<S>> {
///         Some(self.0.shade(at, varyings)?.lit(Illumination::white(32_768)))
///     }
/// }
/// ```
///
/// For values of your own at each position of the mesh, keep a slice in the shader, and read the element at
/// [`Corner::index`](crate::mesh::Corner::index):
///
/// ```
/// use embedded_graphics::pixelcolor::Gray8;
/// use fixel::prelude::*;
/// use fixel::{Primitive, Window};
/// /// Brightnesses from 0 to 255, one for each position.
/// #[derive(Clone, Copy)]
/// struct Heat(&'static [u8]);
///
/// impl Shader for Heat {
///     type Color = Gray8;
///     type Varyings = i32;
///
///     fn varyings(&self, primitive: &Primitive) -> [i32; 3] {
///         primitive.corners(|corner| i32::from(self.0[usize::from(corner.index())]) << 16)
///     }
///
///     fn shade(&self, _: &Fragment, heat: i32) -> Option<Gray8> {
///         Some(Gray8::new((heat >> 16) as u8))
///     }
/// }
///
/// static SQUARE: Mesh = shape!(plane(1, 1));
/// let projection = Projection::orthographic(Window::centered(fx!(2), fx!(2)), fx!(0), fx!(2))?;
/// let mvp = projection * Camera::top(Vec3::ZERO, fx!(1));
/// let mut pixels = [Gray8::new(0); 4 * 4];
/// Canvas::new(&mut pixels, 4, 4)?.draw(&SQUARE, &mvp, &Heat(&[0, 0, 200, 200]));
/// assert!(pixels[0] > pixels[15] || pixels[0] < pixels[15]);
/// # Ok::<(), Error>(())
/// ```
///
/// Each stack of shaders is a type of its own; the module says [how a struct keeps a
/// shader](crate::shade#a-shader-in-a-struct). There is no `dyn Shader`, because a call for each pixel would take
/// longer than most shaders. To keep objects with different shaders in one list, choose the shader once for each draw
/// call: by an enum, or by a trait of your own with a method that draws the object. (For a
/// [`DrawList`](crate::DrawList), see [`Object`](crate::Object).)
///
/// ```
/// use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
/// use fixel::prelude::*;
/// use fixel::NormalView;
///
/// static BALL: Mesh = shape!(sphere(16, 12));
/// static BOX: Mesh = shape!(cuboid(vec3!(1, 1, 1)));
///
/// type Frame<'a> = Canvas<'a, Rgb565, Native, LinearDepth>;
///
/// trait Draw {
///     fn draw(&self, frame: &mut Frame, view: &Mvp);
/// }
///
/// struct Model<S> {
///     mesh: &'static Mesh<'static>,
///     place: Transform,
///     shader: S,
/// }
///
/// impl<S: ShaderFor<Rgb565>> Draw for Model<S> {
///     fn draw(&self, frame: &mut Frame, view: &Mvp) {
///         frame.draw(self.mesh, &(*view * self.place), &self.shader);
///     }
/// }
///
/// let place = |x| Transform::translate(Vec3::new(x, fx!(0), fx!(0)));
/// let sun = Light::new(vec3!(1, 1, 1), fx!(0.2), fx!(0.8))?;
/// let lit = Flat::new(Rgb565::RED).lit(sun);
/// let models: [&dyn Draw; 2] = [ // or Vec<Box<dyn Draw>>
///     &Model { mesh: &BOX, place: place(fx!(-1.2)), shader: lit },
///     &Model { mesh: &BALL, place: place(fx!(1)), shader: NormalView::new() },
/// ];
/// let projection = Projection::perspective(deg!(45), (8, 6), fx!(1), fx!(10))?;
/// let view = projection * Camera::look_at(vec3!(0, 0, 6), Vec3::ZERO, Vec3::Y)?;
/// let (mut pixels, mut depths) = ([Rgb565::BLACK; 8 * 6], [0; 8 * 6]);
/// let mut frame = Canvas::new(&mut pixels, 8, 6)?.with_depth(&mut depths)?;
/// for model in models {
///     model.draw(&mut frame, &view);
/// }
/// # // In the middle, the box is red, and the ball is blue, because its middle faces the viewer.
/// # assert!(pixels[3 * 8 + 2].r() > 10 && pixels[3 * 8 + 2].b() == 0 && pixels[3 * 8 + 5].b() > 25);
/// # Ok::<(), Error>(())
/// ```
pub trait Shader: Copy {
    /// The output for a pixel: the canvas's color, a [`Precise`](super::Precise) color, or either of these with an
    /// opacity ([`Translucent`](super::Translucent)).
    type Color: Output;

    /// The values to interpolate.
    type Varyings: Varyings;

    /// Whether [`shade`](Self::shade) reads [`Fragment::depth`].
    ///
    /// The default, `true`, is always correct. With `false`, a shader that interpolates nothing is faster where no
    /// depth is tested or stored: depth is then not computed, and [`Fragment::depth`] reads as 0.
    const READS_DEPTH: bool = true;

    /// Whether an effect of this shader, such as light, keeps what it computes at corners for neighboring triangles.
    #[doc(hidden)]
    const KEEPS_CORNERS: bool = false;

    /// The values at the three corners of a triangle. For an edge, the values belong to its first end, its second end,
    /// and its second end again; for a point, the same value comes three times.
    fn varyings(&self, primitive: &Primitive<'_>) -> [Self::Varyings; 3];

    /// The color of a pixel, or `None` to leave both its color and its depth as they are.
    fn shade(&self, at: &Fragment, varyings: Self::Varyings) -> Option<Self::Color>;

    /// Puts this surface under a light. The brightness is computed at the vertices and interpolated (Gouraud
    /// shading).
    ///
    /// The light adds one varying, or three if the light is colored and the canvas is not gray. Highlights add one
    /// more. A stack of shaders with more than eight [`Varyings`] does not compile.
    ///
    #[cfg_attr(doc, doc = page_picture!("lit", "A coarse ring that looks round, because the light is interpolated"))]
    /// The light uses the mesh's normals, or each triangle's own normal if the mesh has none. The light's varyings come
    /// after the surface's own varyings. White light has one brightness. Colored light has one number for each channel
    /// of the canvas. Highlights add one more number. 65,536 is full brightness.
    ///
    /// ```
    /// use embedded_graphics::mock_display::MockDisplay;
    /// use embedded_graphics::pixelcolor::{Gray4, GrayColor, Rgb888, RgbColor};
    /// use fixel::prelude::*;
    /// use fixel::Window;
    /// static BALL: Mesh = shape!(sphere(8, 8));
    /// let projection = Projection::orthographic(Window::centered(fx!(2), fx!(2)), fx!(0), fx!(2))?;
    /// let mvp = projection * Camera::front(Vec3::ZERO, fx!(1));
    /// let sun = Light::new(vec3!(1, 2, 1), fx!(0.2), fx!(0.8))?;
    /// let mut pixels = [Gray4::BLACK; 144];
    /// let mut canvas = Canvas::new(&mut pixels, 12, 12)?;
    /// canvas.draw(&BALL, &mvp, &Flat::rgb(Rgb888::WHITE).lit(sun));
    /// let mut display = MockDisplay::new();
    /// canvas.show(&mut display)?;
    /// display.assert_pattern(&[
    ///     "0000CDEF0000",
    ///     "009ACDEEFE00",
    ///     "068ABCCDDEC0",
    ///     "0588ABCCDDD0",
    ///     "34678AABBCBB",
    ///     "33567899AAB9",
    ///     "333457788988",
    ///     "333345667775",
    ///     "033334344540",
    ///     "033333434440",
    ///     "003333333300",
    ///     "000033330000",
    /// ]);
    /// # Ok::<(), Error>(())
    /// ```
    #[must_use]
    #[inline]
    fn lit<L: Lighting>(self, light: L) -> Lit<Self, L>
    where
        ColorOf<Self>: PixelFormat,
    {
        Adapted {
            surface: self,
            effect: ByVertex(light),
        }
    }

    /// Puts this surface under a light, with one brightness for each triangle, computed from the triangle's own
    /// normal.
    ///
    #[cfg_attr(doc, doc = page_picture!("face_lit", "A coarse ring with one brightness for each triangle"))]
    /// Edges and points are fully lit.
    ///
    /// ```
    /// use embedded_graphics::mock_display::MockDisplay;
    /// use embedded_graphics::pixelcolor::{Gray4, GrayColor, Rgb888, RgbColor};
    /// use fixel::prelude::*;
    /// use fixel::Window;
    /// static BALL: Mesh = shape!(sphere(8, 8));
    /// let projection = Projection::orthographic(Window::centered(fx!(2), fx!(2)), fx!(0), fx!(2))?;
    /// let mvp = projection * Camera::front(Vec3::ZERO, fx!(1));
    /// let sun = Light::new(vec3!(1, 2, 1), fx!(0.2), fx!(0.8))?;
    /// let mut pixels = [Gray4::BLACK; 144];
    /// let mut canvas = Canvas::new(&mut pixels, 12, 12)?;
    /// canvas.draw(&BALL, &mvp, &Flat::rgb(Rgb888::WHITE).lit_faces(sun));
    /// let mut display = MockDisplay::new();
    /// canvas.show(&mut display)?;
    /// display.assert_pattern(&[
    ///     "0000CDEF0000",
    ///     "00ACDCFFFE00",
    ///     "065AABDEDED0",
    ///     "06BABAEDEEE0",
    ///     "337877BBBBBB",
    ///     "338787BBBBBB",
    ///     "333444787878",
    ///     "334444878887",
    ///     "033333333330",
    ///     "033333434340",
    ///     "003333333300",
    ///     "000033330000",
    /// ]);
    /// # Ok::<(), Error>(())
    /// ```
    #[must_use]
    #[inline]
    fn lit_faces<L: Lighting>(self, light: L) -> FaceLit<Self, L>
    where
        ColorOf<Self>: PixelFormat,
    {
        Adapted {
            surface: self,
            effect: ByFace(light),
        }
    }

    /// Multiplies this surface by the mesh's vertex colors.
    ///
    /// The colors take three of the eight [`Varyings`] that a shader may have, or one if the surface is gray.
    ///
    #[cfg_attr(doc, doc = page_picture!("tinted", "A cube with checkers, multiplied by the colors of its corners"))]
    /// A white vertex leaves the surface as it is; a black vertex makes the surface black.
    ///
    /// The tint's varyings follow the surface's own varyings: the vertex color's red, green and blue as fractions
    /// (65,536 is 1), or one fraction if the surface is gray.
    ///
    /// ```
    /// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::{Rgb565, Rgb888, RgbColor}};
    /// use fixel::prelude::*;
    /// use fixel::Window;
    /// static SKIN: [[Rgb565; 2]; 1] = [[Rgb565::YELLOW, Rgb565::BLUE]];
    /// static SQUARE: Mesh = shape!(plane(1, 1));
    /// let projection = Projection::orthographic(Window::centered(fx!(2), fx!(2)), fx!(0), fx!(2))?;
    /// let mvp = projection * Camera::top(Vec3::ZERO, fx!(1));
    /// let mut pixels = [Rgb565::BLACK; 8];
    /// let mut canvas = Canvas::new(&mut pixels, 4, 2)?;
    /// // Under red, yellow is red and blue is black.
    /// let mesh = SQUARE.with_colors(&[Rgb888::RED; 4], None)?;
    /// canvas.draw(&mesh, &mvp, &Textured::new(&SKIN).tinted());
    /// let mut display = MockDisplay::new();
    /// canvas.show(&mut display)?;
    /// display.assert_pattern(&["RRKK", "RRKK"]);
    /// # Ok::<(), Error>(())
    /// ```
    #[must_use]
    #[inline]
    fn tinted(self) -> Tinted<Self>
    where
        ColorOf<Self>: PixelFormat,
    {
        Adapted {
            surface: self,
            effect: Tint,
        }
    }

    /// Puts this surface in fog, which takes one of the eight [`Varyings`] that a shader may have.
    ///
    #[cfg_attr(doc, doc = page_picture!("in_fog", "A row of rings that fade into gray"))]
    /// Apply light first, then fog: `.lit(sun).in_fog(fog)`.
    ///
    /// ```
    /// use embedded_graphics::pixelcolor::{Gray8, GrayColor};
    /// use fixel::prelude::*;
    /// use fixel::Window;
    /// static SQUARE: Mesh = shape!(plane(1, 1));
    /// let projection = Projection::orthographic(Window::centered(fx!(2), fx!(2)), fx!(0), fx!(8))?;
    /// let mvp = projection * Camera::top(Vec3::ZERO, fx!(4));
    /// let mut pixels = [Gray8::BLACK; 1];
    /// // At a distance of 4, the share e^(-0.25 · 4) is left: 37 % of 100, plus 63 % of 200.
    /// let fog = Fog::exponential(Gray8::new(200), fx!(0.25))?;
    /// Canvas::new(&mut pixels, 1, 1)?.draw(&SQUARE, &mvp, &Flat::new(Gray8::new(100)).in_fog(fog));
    /// assert_eq!(pixels, [Gray8::new(163)]);
    /// # Ok::<(), Error>(())
    /// ```
    #[must_use]
    #[inline]
    fn in_fog<D: Density>(self, fog: Fog<ColorOf<Self>, D>) -> InFog<Self, ColorOf<Self>, D>
    where
        ColorOf<Self>: PixelFormat,
    {
        Adapted {
            surface: self,
            effect: fog,
        }
    }

    /// Applies a function to each pixel and its color: any effect in one line. `None` leaves the pixel as it is.
    ///
    /// The function may capture only [`Copy`] values. Over a surface from [`Flat::rgb`](super::Flat::rgb) or another
    /// `rgb` function, write the color's type, which the compiler does not know yet: `|_, color: Rgb565| …`.
    ///
    /// ```
    /// use embedded_graphics::pixelcolor::{Gray8, GrayColor};
    /// use fixel::prelude::*;
    /// use fixel::Window;
    /// static SQUARE: Mesh = shape!(plane(1, 1));
    /// let projection = Projection::orthographic(Window::centered(fx!(2), fx!(2)), fx!(0), fx!(2))?;
    /// let mvp = projection * Camera::top(Vec3::ZERO, fx!(1));
    /// let mut pixels = [Gray8::BLACK; 2];
    /// let mut canvas = Canvas::new(&mut pixels, 2, 1)?;
    /// // The effect skips the left column.
    /// let right = Flat::new(Gray8::WHITE).map(|at, color| (at.point.x > 0).then_some(color));
    /// canvas.draw(&SQUARE, &mvp, &right);
    /// assert_eq!(pixels, [Gray8::BLACK, Gray8::WHITE]);
    /// # Ok::<(), Error>(())
    /// ```
    ///
    #[cfg_attr(doc, doc = page_picture!("map", "A ring with three steps of brightness, like a cartoon"))]
    /// ```
    /// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::{Gray4, GrayColor}};
    /// use fixel::prelude::*;
    /// static FLOOR: Mesh = shape!(plane(1, 1));
    /// let projection = Projection::perspective(Angle::from_degrees(90), (1, 1), fx!(0.5), fx!(8))?;
    /// // The floor is eight units wide and long, half a unit below the eye.
    /// let mvp = projection * Transform::translate(vec3!(0, -0.5, -4)) * Transform::scale(fx!(4));
    /// let mut pixels = [Gray4::BLACK; 32];
    /// let mut canvas = Canvas::new(&mut pixels, 4, 8)?;
    /// // Fog: the farther, the whiter. Depth is 65535 · near / distance.
    /// let fog = Flat::new(Gray4::BLACK).map(|at, _| Some(Gray4::new(15 - (at.depth >> 12) as u8)));
    /// canvas.draw(&FLOOR, &mvp, &fog);
    /// let mut display = MockDisplay::new();
    /// canvas.show(&mut display)?;
    /// display.assert_pattern(&[
    ///     "0000", "0000", "0000", "0000", "EEEE", "AAAA", "6666", "2222",
    /// ]);
    /// # Ok::<(), Error>(())
    /// ```
    #[must_use]
    #[inline]
    fn map<C: Output, F: Fn(&Fragment, Self::Color) -> Option<C> + Copy>(
        self,
        effect: F,
    ) -> Map<Self, F> {
        Map {
            shader: self,
            effect,
        }
    }

    /// Converts this surface to the color type `C`.
    ///
    #[cfg_attr(doc, doc = page_picture!("converted", "A ring in four grays, dithered"))]
    /// Colors are rounded, or dithered if `C` has fewer than 5 bits per channel (see [`PixelFormat`]).
    ///
    /// Use it, for example, to draw a texture in another color format than the canvas's. Every pixel is converted, so a
    /// texture in the canvas's own format is faster.
    ///
    /// ```
    /// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::{BinaryColor, Rgb888, RgbColor}};
    /// use fixel::prelude::*;
    /// use fixel::Window;
    /// static SKIN: [[Rgb888; 2]; 1] = [[Rgb888::WHITE, Rgb888::new(0, 128, 0)]];
    /// static SQUARE: Mesh = shape!(plane(1, 1));
    /// let projection = Projection::orthographic(Window::centered(fx!(2), fx!(2)), fx!(0), fx!(2))?;
    /// let mvp = projection * Camera::top(Vec3::ZERO, fx!(1));
    /// let mut pixels = [BinaryColor::Off; 48];
    /// let mut canvas = Canvas::new(&mut pixels, 12, 4)?;
    /// let skin = Textured::new(&SKIN);
    /// canvas.draw(&SQUARE, &mvp, &skin.converted());
    /// let mut display = MockDisplay::new();
    /// canvas.show(&mut display)?;
    /// display.assert_pattern(&[
    ///     "######......",
    ///     "#######.#.#.",
    ///     "######......",
    ///     "#######.#.#.",
    /// ]);
    /// # Ok::<(), Error>(())
    /// ```
    #[must_use]
    #[inline]
    fn converted<C: PixelFormat>(self) -> Converted<Self, C> {
        Converted::new(self)
    }

    /// Dithers this surface, whatever its format: the mean of 8x8 pixels is then within 1/128 step of the surface's
    /// [full-precision color](super::Precise). That color is itself exact to 1/250 step for each light, tint or fog,
    /// and 1/8 step for interpolated colors. Formats with fewer than 5 bits per channel are dithered anyway. In formats
    /// of 15 and 16 bits, dithering hides the bands of soft light and fog. Call this method last.
    ///
    /// ```
    /// use embedded_graphics::pixelcolor::{Rgb565, Rgb888};
    /// use fixel::prelude::*;
    /// use fixel::Window;
    /// static SQUARE: Mesh = shape!(plane(1, 1));
    /// let projection = Projection::orthographic(Window::centered(fx!(2), fx!(2)), fx!(0), fx!(2))?;
    /// let mvp = projection * Camera::top(Vec3::ZERO, fx!(1));
    /// let mut pixels = [Rgb565::new(0, 0, 0); 64];
    /// let mut canvas = Canvas::new(&mut pixels, 8, 8)?;
    /// // 60/255 of 31 steps is 7.3 steps.
    /// canvas.draw(&SQUARE, &mvp, &Flat::rgb(Rgb888::new(60, 60, 60)).dithered());
    /// let bright = canvas.pixels().filter(|&pixel| pixel == Rgb565::new(8, 15, 8)).count();
    /// assert!((17..=20).contains(&bright));
    /// # Ok::<(), Error>(())
    /// ```
    #[must_use]
    #[inline]
    fn dithered(self) -> Dithered<Self>
    where
        ColorOf<Self>: PixelFormat,
    {
        Dithered { surface: self }
    }
}

/// A [`Shader`] for canvases of color `C`: its output is a `C`, in full precision or not, with an opacity or without.
/// Draw calls of [`Canvas`](crate::Canvas) require this trait.
///
/// Every shader whose output has the color `C` implements this trait. For a shader of another color, the compiler's
/// message says what to write:
///
/// ```compile_fail
/// use embedded_graphics::pixelcolor::{Gray8, Rgb565};
/// use fixel::prelude::*;
/// fn draw(canvas: &mut Canvas<'_, Rgb565>, mesh: &Mesh, mvp: &Mvp) {
///     // error: the color of `Flat<Gray8>` is not the canvas's color `Rgb565`; …
///     canvas.draw(mesh, mvp, &Flat::new(Gray8::new(9)));
/// }
/// ```
#[diagnostic::on_unimplemented(
    message = "the color of `{Self}` is not the canvas's color `{C}`",
    label = "not a shader of color `{C}`",
    note = "write `&shader.converted()` to convert the color of each pixel, or give the canvas the shader's color type"
)]
pub trait ShaderFor<C>: Shader<Color: Output<Color = C>> {}

// Without this attribute, the compiler's message would say only that the associated types differ.
#[diagnostic::do_not_recommend]
impl<C, S: Shader<Color: Output<Color = C>>> ShaderFor<C> for S {}
