//! Everything around the island: sea, sky, textures, camera, light, shaders, and a line of text.

use core::convert::Infallible;

use embedded_graphics::Drawable;
use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{Point, Size};
use embedded_graphics::mono_font::{MonoTextStyle, ascii::FONT_6X10};
use embedded_graphics::pixelcolor::{Gray8, Rgb565, Rgb888, RgbColor};
use embedded_graphics::primitives::Rectangle;
use embedded_graphics::text::{Alignment, Text};
use fixel::Vec2;
use fixel::canvas::{Contrast, DepthBuffer, Storage};
use fixel::prelude::*;
use fixel::shade::{Light, PixelFormat, Texels, Textured, Within};
use fixel::view::{Aspect, Perspective};

/// The texture of the island.
pub static SKIN: [[Rgb565; 128]; 128] = rows(include_bytes!("../../assets/lighthouse.rgb565"));

/// Rows of colors from bytes. The high byte of a color comes first.
const fn rows<const W: usize, const H: usize>(bytes: &[u8]) -> [[Rgb565; W]; H] {
    let mut rows = [[Rgb565::BLACK; W]; H];
    let (texels, _) = bytes.as_chunks();
    let mut at = 0;
    while at < W * H {
        let bits = u16::from_be_bytes(texels[at]);
        rows[at / W][at % W] = Rgb565::new(
            (bits >> 11) as u8,
            (bits >> 5 & 63) as u8,
            (bits & 31) as u8,
        );
        at += 1;
    }
    rows
}

/// The sea: a level disc around the island, 112 units from its center to its edge.
pub static SEA: Mesh = {
    match Mesh::new(&SEA_CORNERS.0, &SEA_FACES) {
        Ok(mesh) => Mesh::checked(mesh.with_uvs(&SEA_CORNERS.1, None)),
        error => Mesh::checked(error),
    }
};
/// The number of corners of the disc. The center follows them in the list.
const SEA_SIDES: usize = 32;
static SEA_CORNERS: ([Vec3; SEA_SIDES + 1], [Vec2; SEA_SIDES + 1]) = {
    let mut positions = [Vec3::ZERO; SEA_SIDES + 1];
    let mut uvs = [vec2!(0, 0); SEA_SIDES + 1];
    let mut at = 0;
    while at < SEA_SIDES {
        #[allow(clippy::cast_possible_truncation)] // 32 corners
        let angle = Angle::from_bits((at << (32 - SEA_SIDES.ilog2())) as u32);
        let (sin, cos) = angle.sin_cos();
        // Converts from units of 2^-30 to units of 2^-16, and multiplies by the radius of 112 units. The texture
        // repeats every four units. Each triangle then spans fewer than 1,900 texels. Up to this number, the faster
        // modes keep their accuracy.
        let (x, z) = ((sin.to_bits() >> 14) * 112, (cos.to_bits() >> 14) * 112);
        positions[at] = Vec3::from_bits([x, 0, z]);
        // A texture coordinate is a quarter of the position, converted from units of 2^-16 to units of 2^-20.
        uvs[at] = Vec2::from_bits([x * 4, z * 4]);
        at += 1;
    }
    (positions, uvs)
};
/// The triangles of the disc: a fan around its center.
static SEA_FACES: [[u16; 3]; SEA_SIDES] = {
    const CENTER: u16 = SEA_SIDES as u16;
    let mut faces = [[0; 3]; SEA_SIDES];
    let mut at: u16 = 0;
    while (at as usize) < faces.len() {
        faces[at as usize] = [CENTER, at, (at + 1) % CENTER];
        at += 1;
    }
    faces
};
/// The texture of the sea, which repeats.
pub static WAVES: [[Rgb565; 64]; 64] = rows(include_bytes!("../../assets/sea.rgb565"));

/// A projection that shows the whole lighthouse.
///
/// # Errors
///
/// None for a picture of a possible size.
pub fn projection(size: impl Into<Aspect>) -> Result<Projection<Perspective>, Error> {
    Projection::perspective(Angle::from_degrees(40), size, fx!(1), fx!(140))
}

/// The place of the camera.
pub const EYE: Vec3 = vec3!(3.4, 3.1, 8.4);
/// The point that the camera looks at.
pub const TARGET: Vec3 = vec3!(0.45, 1.62, 0);

/// A camera in front of the island, a little above it.
///
/// # Errors
///
/// None: the numbers are constant.
pub fn camera() -> Result<Camera, Error> {
    Camera::look_at(EYE, TARGET, Vec3::Y)
}

/// The direction toward the afternoon sun, on the right.
pub const SUN: Vec3 = vec3!(5, 5, 4);

/// The light of the afternoon sun.
///
/// # Errors
///
/// None: the numbers are constant.
pub fn sun() -> Result<Light, Error> {
    Light::new(SUN, fx!(0.4), fx!(0.6))
}

/// Fills the canvas with a sky, blue above and pale toward the horizon. A canvas in black and white becomes black.
pub fn sky<C: PixelFormat>(canvas: &mut Canvas<'_, C, impl Storage<C>, impl DepthBuffer>) {
    canvas.clear(C::from_rgb(Rgb888::new(0, 0, 0), Point::zero()));
    if is_mono::<C>() {
        return;
    }
    let frame = canvas.frame_size();
    let rows = canvas.rows().clone();
    let colors = rows.clone().flat_map(|y| {
        let color = sky_color(y, frame.height);
        (0..frame.width)
            .map(move |x| C::from_rgb(color, Point::new(x.cast_signed(), y.cast_signed())))
    });
    let area = Rectangle::new(
        Point::new(0, rows.start.cast_signed()),
        Size::new(frame.width, rows.end - rows.start),
    );
    let Ok(()) = canvas.fill_contiguous(&area, colors);
}

/// The color of the sky in row `y` of a picture with `height` rows, at least 1. Row 0 is at the top.
#[inline]
pub fn sky_color(y: u32, height: u32) -> Rgb888 {
    // Products are at most 4096 · 256.
    let mix = |from: u32, to: u32| (from * (height - y) + to * y) / height;
    #[allow(clippy::cast_possible_truncation)] // between two bytes
    let color = Rgb888::new(mix(96, 236) as u8, mix(156, 232) as u8, mix(214, 216) as u8);
    color
}

/// The varyings of a lit texture.
pub type LitTexels = (Texels, Within<64, (i32, ())>);

/// The shader of the sea.
pub fn waves<C: PixelFormat>() -> impl ShaderFor<C, Varyings = Texels> {
    Textured::new(&WAVES).converted()
}

/// The shader of the island.
///
/// # Errors
///
/// None: the light's numbers are constant.
pub fn skin<C: PixelFormat>() -> Result<impl ShaderFor<C, Varyings = LitTexels>, Error> {
    Ok(Textured::new(&SKIN).lit(sun()?).converted())
}

/// Whether the format has only black and white. In such a format, the scene is drawn at night, because a dithered sky
/// and sea would be noise around the island.
pub const fn is_mono<C: PixelFormat>() -> bool {
    C::MAX_STEPS[0] == 1
}

/// The shader of the sea at night: black water with crests of waves.
pub fn crests<C: PixelFormat>() -> impl ShaderFor<C, Varyings = Texels> {
    const CREST: u8 = 40;
    let gray = |luma| C::from_rgb(Gray8::new(luma).into(), Point::zero());
    let [black, white] = [0, 255].map(gray);
    Textured::new(&WAVES).map(move |_, color| Some(if color.g() > CREST { white } else { black }))
}

/// The shader of the island at night, with more contrast.
///
/// # Errors
///
/// None: the light's numbers are constant.
pub fn stretched<C: PixelFormat>() -> Result<impl ShaderFor<C, Varyings = LitTexels>, Error> {
    const CONTRAST: Contrast = Contrast::new(50, 170);
    Ok(Textured::new(&SKIN)
        .lit(sun()?)
        .map(|at, color| {
            let gray = color.converted::<Gray8>().finish(at.point);
            Some(CONTRAST.stretch(gray))
        })
        .converted())
}

/// Writes the name of the project into the lower left corner. If the format has only black and white, the background of
/// the text is black.
pub fn caption<C: PixelFormat>(canvas: &mut Canvas<'_, C, impl Storage<C>, impl DepthBuffer>) {
    let size = canvas.frame_size();
    caption_on(canvas, size, is_mono::<C>());
}

/// Writes the name of the project into a picture of this size, on a black background or directly on the picture.
pub fn caption_on<T>(target: &mut T, Size { width, height }: Size, on_black: bool)
where
    T: DrawTarget<Color: PixelFormat, Error = Infallible>,
{
    const TEXT: &str = "fixel: drawn with integers only";
    let fits = width as usize >= TEXT.len() * 6 + 10;
    let text = if fits { TEXT } else { "fixel" };
    for (offset, gray) in [(1, 0), (0, 255)] {
        let color = |gray| T::Color::from_rgb(Rgb888::new(gray, gray, gray), Point::zero());
        let mut style = MonoTextStyle::new(&FONT_6X10, color(gray));
        style.background_color = on_black.then(|| color(0));
        let at = Point::new(5 + offset, height.cast_signed() - 6 + offset);
        let Ok(_) = Text::with_alignment(text, at, style, Alignment::Left).draw(target);
    }
}
