//! The four measured scenes. Every measurement of this crate and of other libraries draws these scenes.
//!
//! The picture has 320x240 pixels, and the focal length is 200 pixels. The near plane is at 0.25, the far plane at 100.
//! Each scene has a mesh, an mvp for each of its poses `k` = 0..8, and a function that draws it. Only this function is
//! measured, without clearing. `no_std`, so that a microcontroller can draw the same scenes.

use embedded_graphics::pixelcolor::{Rgb565, Rgb888, WebColors};
use fixel::canvas::{DepthBuffer, Storage};
use fixel::mode::Mode;
use fixel::prelude::*;
use fixel::shade::{FaceColors, Gouraud, Textured};
use fixel::view::Perspective;
use fixel::{Drawn, Vec2};

/// The width of the picture in pixels.
pub const WIDTH: u32 = 320;
/// The height of the picture in pixels.
pub const HEIGHT: u32 = 240;
/// The number of poses.
pub const POSES: i32 = 8;

/// A texture of 64x64 texels: squares of 8x8 texels in two colors.
pub static CHECKER: [[Rgb565; 64]; 64] = {
    let mut texels = [[Rgb565::CSS_IVORY; 64]; 64];
    let mut at = 0;
    while at < 64 * 64 {
        let (row, column) = (at / 64, at % 64);
        if (row / 8 + column / 8) % 2 == 1 {
            texels[row][column] = Rgb565::CSS_STEEL_BLUE;
        }
        at += 1;
    }
    texels
};

/// A floor from one unit to twenty units in front of the eye, partly outside the picture.
pub static FLOOR: Mesh = {
    const POSITIONS: [Vec3; 4] = [
        vec3!(-10, 0, -1),
        vec3!(10, 0, -1),
        vec3!(10, 0, -20),
        vec3!(-10, 0, -20),
    ];
    const UVS: [Vec2; 4] = [vec2!(0, 1), vec2!(1, 1), vec2!(1, 0), vec2!(0, 0)];
    match Mesh::new(&POSITIONS, &[[0, 1, 2], [0, 2, 3]]) {
        Ok(mesh) => Mesh::checked(mesh.with_uvs(&UVS, None)),
        error => Mesh::checked(error),
    }
};

/// A cube from −1 to 1, with the texture on each side.
pub static CUBE: Mesh = shape!(cuboid(vec3!(1, 1, 1)));

static BALL: Mesh = shape!(sphere(32, 32));

/// A sphere of 1,984 triangles, with colors baked from one directional light.
pub static SPHERE: Mesh = Mesh::checked(BALL.with_colors(&VERTEX_COLORS, None));

static VERTEX_COLORS: [Rgb888; 33 * 33] = {
    let mut colors = [Rgb888::new(0, 0, 0); 33 * 33];
    let mut at = 0;
    while at < colors.len() {
        // The normal of a unit sphere equals the position.
        let [r, g, b] = lit(place(at));
        colors[at] = Rgb888::new(r, g, b);
        at += 1;
    }
    colors
};

/// A color for each triangle of the sphere.
pub static FACE_COLORS: [Rgb565; 1984] = {
    let mut colors = [Rgb565::new(0, 0, 0); 1984];
    let mut at = 0;
    while at < colors.len() {
        let [a, b, c] = BALL.faces()[at];
        let [a, b, c] = [place(a as usize), place(b as usize), place(c as usize)];
        let [r, g, b] = lit([
            (a[0] + b[0] + c[0]) / 3,
            (a[1] + b[1] + c[1]) / 3,
            (a[2] + b[2] + c[2]) / 3,
        ]);
        colors[at] = Rgb565::new(r >> 3, g >> 2, b >> 3);
        at += 1;
    }
    colors
};

/// A position of the sphere, in units of 2⁻¹⁶.
const fn place(at: usize) -> [i32; 3] {
    match BALL.positions().get(at) {
        Some(position) => position.to_bits(),
        None => [0; 3],
    }
}

/// The color of a surface under light from (2, 3, 6)/7. The normal is in units of 2⁻¹⁶.
#[must_use]
pub const fn lit([x, y, z]: [i32; 3]) -> [u8; 3] {
    let facing = (2 * x + 3 * y + 6 * z) / 7;
    let light = if facing > 0 { facing } else { 0 };
    // A quarter of the light is ambient light.
    let light = (1 << 14) + light / 4 * 3;
    #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // at most the factor
    [
        ((250 * light) >> 16) as u8,
        ((170 * light) >> 16) as u8,
        ((90 * light) >> 16) as u8,
    ]
}

/// The projection of all scenes.
///
/// # Errors
///
/// None: the numbers are constant.
fn projection() -> Result<Projection<Perspective>, Error> {
    Projection::from_focal_length(fx!(200), (WIDTH, HEIGHT), fx!(0.25), fx!(100))
}

/// The rotation about x after the rotation about y: RX(`x`) · RY(`y`).
fn turned([x, y]: [Angle; 2]) -> Transform {
    Transform::rotate_x(x) * Transform::rotate_y(y)
}

/// The angle by which the camera looks down on the floor: atan 0.2. The floor is moved by [`FLOOR_AT`] first, and then
/// rotated by this angle.
pub const FLOOR_PITCH: Angle = Angle::from_bits(134_932_750);
/// The floor's place, below the eye.
pub const FLOOR_AT: Vec3 = vec3!(0, -1, 0);
/// The place of the cube. The cube is [turned](cube_turn) before it is moved there.
pub const CUBE_AT: Vec3 = vec3!(0, 0, -3.133_832_458);
/// The place of the spheres. The spheres are [turned](sphere_turn) before they are moved there.
pub const SPHERE_AT: Vec3 = vec3!(0, 0, -2.256_239_223_7);

/// The angles of the cube about x and y in pose `k`. The cube turns about y first.
pub fn cube_turn(k: i32) -> [Angle; 2] {
    [
        Angle::from_radians(fx!(0.3)) + Angle::from_turns(fx!(0.0625)) * k,
        Angle::from_radians(fx!(0.4)) + Angle::from_turns(fx!(0.125)) * k,
    ]
}

/// The angles of the spheres about x and y in pose `k`. The spheres turn about y first.
pub fn sphere_turn(k: i32) -> [Angle; 2] {
    [
        Angle::from_radians(fx!(0.35)) + Angle::from_radians(fx!(0.3)) * k,
        Angle::from_radians(fx!(0.2)) + Angle::from_turns(fx!(0.125)) * k,
    ]
}

/// The floor's mvp. The mvp is the same in all poses: the eye is one unit above the floor and looks down.
///
/// # Errors
///
/// None: the numbers are constant.
pub fn floor_mvp(_: i32) -> Result<Mvp<Perspective>, Error> {
    Ok(projection()? * (Transform::rotate_x(FLOOR_PITCH) * Transform::translate(FLOOR_AT)))
}

/// The cube's mvp in pose `k`.
///
/// # Errors
///
/// None: the numbers are constant.
pub fn cube_mvp(k: i32) -> Result<Mvp<Perspective>, Error> {
    Ok(projection()? * (Transform::translate(CUBE_AT) * turned(cube_turn(k))))
}

/// The spheres' mvp in pose `k`.
///
/// # Errors
///
/// None: the numbers are constant.
pub fn sphere_mvp(k: i32) -> Result<Mvp<Perspective>, Error> {
    Ok(projection()? * (Transform::translate(SPHERE_AT) * turned(sphere_turn(k))))
}

/// The shader of the floor and the cube.
pub fn checkered() -> impl ShaderFor<Rgb565> {
    Textured::new(&CHECKER)
}

/// The shader of the sphere: its vertices' colors.
pub fn shaded() -> impl ShaderFor<Rgb565> {
    Gouraud::new()
}

/// The shader of the flat sphere: its triangles' colors.
pub fn faceted() -> impl ShaderFor<Rgb565> {
    FaceColors::new(&FACE_COLORS)
}

/// Draws the floor.
pub fn floor<I: Mode, O: Storage<Rgb565>, D: DepthBuffer>(
    canvas: &mut Canvas<'_, Rgb565, O, D>,
    options: &DrawOptions<I>,
    mvp: &Mvp<Perspective>,
) -> Drawn {
    canvas.draw_with(options, &FLOOR, mvp, &checkered())
}

/// Draws the cube.
pub fn cube<I: Mode, O: Storage<Rgb565>, D: DepthBuffer>(
    canvas: &mut Canvas<'_, Rgb565, O, D>,
    options: &DrawOptions<I>,
    mvp: &Mvp<Perspective>,
) -> Drawn {
    canvas.draw_with(options, &CUBE, mvp, &checkered())
}

/// Draws the sphere with interpolated colors.
pub fn sphere<I: Mode, O: Storage<Rgb565>, D: DepthBuffer>(
    canvas: &mut Canvas<'_, Rgb565, O, D>,
    options: &DrawOptions<I>,
    mvp: &Mvp<Perspective>,
) -> Drawn {
    canvas.draw_with(options, &SPHERE, mvp, &shaded())
}

/// Draws the sphere with one color per triangle, for a canvas without a depth buffer.
pub fn sphere_flat<I: Mode, O: Storage<Rgb565>, D: DepthBuffer>(
    canvas: &mut Canvas<'_, Rgb565, O, D>,
    options: &DrawOptions<I>,
    mvp: &Mvp<Perspective>,
) -> Drawn {
    canvas.draw_with(options, &SPHERE, mvp, &faceted())
}
