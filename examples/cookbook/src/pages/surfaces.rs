//! Pictures of shaders and meshes.

use embedded_graphics::pixelcolor::{Gray2, Rgb565, Rgb888, RgbColor};
use fixel::mesh::{Material, Part};
use fixel::prelude::*;
use fixel::shade::{Gradient, PartColors};
use fixel::texture::Mipmap;
use fixel::{DepthView, NormalView};

use super::{
    BALL, CHECKERS, COARSE_BALL, COARSE_RING, CUBE, Drawn, ORANGE, RING, SHEET, SIZE, SLATE, ball,
    cube, ring, shown_in, sun, view,
};
use crate::scenes::Frame;

/// Three linked rings in one color each.
pub(super) fn flat(canvas: &mut Frame<'_>) -> Drawn {
    static THIN: Mesh = shape!(torus(fx!(0.16), 48, 12));
    canvas.clear(SLATE);
    let colors = [
        ORANGE,
        Rgb888::new(245, 240, 225),
        Rgb888::new(90, 160, 240),
    ];
    for (at, color) in (-1..).zip(colors) {
        let place = Transform::translate(vec3!(0.95, 0, 0) * at);
        let turn = Transform::rotate_x(Angle::from_degrees(55 + 60 * at));
        let ring = view(canvas)? * place * turn * Transform::scale(fx!(0.8));
        canvas.draw(&THIN, &ring, &Flat::rgb(color));
    }
    Ok(())
}

pub(super) fn face_colors(canvas: &mut Frame<'_>) -> Drawn {
    let reds = [24, 31, 20, 28, 16];
    let colors: Vec<_> = (0..COARSE_BALL.faces().len())
        .map(|face| {
            Rgb565::new(
                reds[face % 5],
                20 + 8 * (face % 3) as u8,
                6 + 5 * (face % 4) as u8,
            )
        })
        .collect();
    ball(canvas, &COARSE_BALL, &FaceColors::new(&colors))
}

pub(super) fn part_colors(canvas: &mut Frame<'_>) -> Drawn {
    let faces = RING.faces().len();
    let [red, white] = [Rgb888::new(220, 60, 50), Rgb888::new(250, 245, 235)].map(Material::new);
    let parts: Vec<_> = (0..8)
        .map(|at| {
            Part::new(
                faces / 8 * at..faces / 8 * (at + 1),
                if at % 2 == 0 { red } else { white },
            )
        })
        .collect();
    ring(canvas, &RING, &PartColors::rgb(&parts).lit(sun()?))
}

/// Colors by the direction from the middle of the mesh.
fn rainbow(mesh: &Mesh) -> Vec<Rgb888> {
    let channel = |v: Scalar| 128 + (v * 100).floor().clamp(-100, 100);
    mesh.positions()
        .iter()
        .map(|at| {
            let [r, g, b] = [at.x, at.y, at.z].map(|v| channel(v).cast_unsigned() as u8);
            Rgb888::new(r, g, b)
        })
        .collect()
}

pub(super) fn gouraud(canvas: &mut Frame<'_>) -> Drawn {
    let colors = rainbow(&CUBE);
    cube(canvas, &CUBE.with_colors(&colors, None)?, &Gouraud::new())
}

pub(super) fn gradient(canvas: &mut Frame<'_>) -> Drawn {
    let low = (fx!(-0.6), Rgb888::new(30, 70, 160));
    let high = (fx!(0.6), Rgb888::new(250, 240, 190));
    ball(canvas, &BALL, &Gradient::new(low, high)?)
}

pub(super) fn textured(canvas: &mut Frame<'_>) -> Drawn {
    cube(canvas, &CUBE, &Textured::new(&CHECKERS))
}

static HALF: Mesh = {
    const CORNERS: [Vec3; 4] = [
        vec3!(0, 0, 0),
        vec3!(40, 0, 0),
        vec3!(40, 0, -40),
        vec3!(0, 0, -40),
    ];
    const UVS: [Vec2; 4] = [vec2!(0, 40), vec2!(40, 40), vec2!(40, 0), vec2!(0, 0)];
    Mesh::checked(Mesh::checked(Mesh::new(&CORNERS, &[[0, 1, 2], [0, 2, 3]])).with_uvs(&UVS, None))
};

pub(super) fn mipmapped(canvas: &mut Frame<'_>) -> Drawn {
    let projection = Projection::perspective(deg!(50), canvas.frame_size(), fx!(0.25), fx!(100))?;
    let camera = Camera::look_at(vec3!(0, 3.4, 0), vec3!(0, 0.2, -6), Vec3::Y)?;
    canvas.clear(SLATE);
    // A texture of 2x2 tiles with dark joints covers four units of the floor.
    let large = Transform::scale(fx!(4));
    let left = projection * camera * Transform::translate(vec3!(-160, 0, 0)) * large;
    let mut texels = [Rgb565::default(); Mipmap::<Rgb565>::len(32, 32)];
    for (at, texel) in texels[..32 * 32].iter_mut().enumerate() {
        *texel = match (at / 32 % 16, at % 32 % 16) {
            (0, _) | (_, 0) => Rgb565::new(5, 9, 7),
            _ if at / 512 == at % 32 / 16 => Rgb565::new(31, 57, 25),
            _ => Rgb565::new(9, 34, 22),
        };
    }
    let tiles = Textured::new(Mipmap::build(&mut texels, 32, 32)?);
    canvas.draw(&HALF, &left, &tiles);
    let smooth = tiles.mipmapped(&projection, canvas.frame_size())?;
    canvas.draw(&HALF, &(projection * camera * large), &smooth);
    Ok(())
}

pub(super) fn depth_view(canvas: &mut Frame<'_>) -> Drawn {
    ring(canvas, &RING, &DepthView::between(1250, 2750))
}

pub(super) fn normal_view(canvas: &mut Frame<'_>) -> Drawn {
    ring(canvas, &RING, &NormalView::new())
}

pub(super) fn lit(canvas: &mut Frame<'_>) -> Drawn {
    ring(canvas, &COARSE_RING, &Flat::rgb(ORANGE).lit(sun()?))
}

pub(super) fn face_lit(canvas: &mut Frame<'_>) -> Drawn {
    ring(canvas, &COARSE_RING, &Flat::rgb(ORANGE).lit_faces(sun()?))
}

pub(super) fn tinted(canvas: &mut Frame<'_>) -> Drawn {
    let colors = rainbow(&CUBE);
    let mesh = CUBE.with_colors(&colors, None)?;
    cube(canvas, &mesh, &Textured::new(&CHECKERS).tinted())
}

pub(super) fn in_fog(canvas: &mut Frame<'_>) -> Drawn {
    let projection = Projection::perspective(deg!(35), canvas.frame_size(), fx!(0.5), fx!(100))?;
    let camera = Camera::look_at(vec3!(-3.2, 1.9, 5.2), vec3!(0.4, 0, -3), Vec3::Y)?;
    let gray = Rgb565::new(22, 46, 24);
    let fog = Fog::linear(gray, fx!(3), fx!(17))?;
    let shader = Flat::rgb(ORANGE).lit(sun()?).in_fog(fog);
    canvas.clear(gray);
    for at in 0..5 {
        let place = Vec3::new(Scalar::ZERO, Scalar::ZERO, fx!(1) - fx!(2.6) * at);
        let upright = Transform::rotate_x(deg!(90)) * Transform::scale(fx!(0.9));
        canvas.draw(
            &RING,
            &(projection * camera * Transform::translate(place) * upright),
            &shader,
        );
    }
    Ok(())
}

pub(super) fn map(canvas: &mut Frame<'_>) -> Drawn {
    let ink = [
        Rgb565::new(10, 12, 2),
        Rgb565::new(24, 34, 4),
        Rgb565::new(31, 50, 10),
    ];
    let steps = Flat::new(Rgb565::WHITE).lit(sun()?).map(move |at, lit| {
        let lit = lit.finish(at.point);
        let step = usize::from(lit.g() > 26) + usize::from(lit.g() > 52); // white is 63
        Some(ink[step])
    });
    ring(canvas, &RING, &steps)
}

pub(super) fn converted(canvas: &mut Frame<'_>) -> Drawn {
    let surface = Flat::new(ORANGE).lit(sun()?);
    ring(canvas, &RING, &shown_in::<Gray2>(surface))
}

/// A textured ring with numbers of 32 bits, and a ring with numbers of 8 bits, which takes a third of the flash.
pub(super) fn quantized(canvas: &mut Frame<'_>) -> Drawn {
    static SMALL: Mesh = shape!(torus(fx!(0.45), 32, 16), quantized_8);
    canvas.clear(SLATE);
    let (half, height) = (SIZE.width / 2, SIZE.height);
    let projection = Projection::perspective(deg!(58), (half, height), fx!(0.1), fx!(50))?;
    let camera = Camera::look_at(vec3!(0, 2, 3.2), Vec3::ZERO, Vec3::Y)?;
    let mvp = projection * camera * Transform::rotate_z(deg!(25));
    let part = |x| -> Result<DrawOptions, Error> {
        Ok(DrawOptions::new().with_viewport(Viewport::new(x, 0, half, height)?))
    };
    let skin = Textured::new(&CHECKERS).lit(sun()?);
    canvas.draw_with(&part(0)?, &RING, &mvp, &skin);
    let right = part(half.cast_signed())?;
    canvas.draw_with(&right, &SMALL, &mvp, &skin);
    Ok(())
}

/// Eight surfaces.
pub(super) fn shaders(canvas: &mut Frame<'_>) -> Drawn {
    fn ball(
        canvas: &mut Frame<'_>,
        at: i32,
        mesh: &Mesh,
        shader: &impl ShaderFor<Rgb565>,
    ) -> Drawn {
        let (width, height) = (SIZE.width / 4, SIZE.height / 2);
        let projection = Projection::perspective(deg!(40), (width, height), fx!(0.1), fx!(50))?;
        let camera = Camera::look_at(vec3!(0, 2, 4), Vec3::ZERO, Vec3::Y)?;
        let (column, row) = (at % 4, at / 4);
        let corner = (column * width.cast_signed(), row * height.cast_signed());
        let part = Viewport::new(corner.0, corner.1, width, height)?;
        let mvp = projection * camera * Transform::IDENTITY;
        canvas.draw_with(&DrawOptions::new().with_viewport(part), mesh, &mvp, shader);
        Ok(())
    }
    canvas.clear(SLATE);
    let (sun, orange) = (sun()?, Flat::rgb(ORANGE));
    let reds: Vec<_> = (0..COARSE_BALL.faces().len())
        .map(|face| Rgb565::new(16 + 5 * (face % 4) as u8, 20 + 8 * (face % 3) as u8, 8))
        .collect();
    let colors = rainbow(&BALL);
    let viewer = Viewer::of(&view(canvas)?);
    ball(canvas, 0, &BALL, &orange)?;
    ball(canvas, 1, &COARSE_BALL, &FaceColors::new(&reds))?;
    ball(
        canvas,
        2,
        &BALL.with_colors(&colors, None)?,
        &Gouraud::new(),
    )?;
    ball(canvas, 3, &BALL, &Textured::new(&CHECKERS).lit(sun))?;
    ball(canvas, 4, &COARSE_BALL, &orange.lit_faces(sun))?;
    ball(canvas, 5, &BALL, &orange.lit(sun))?;
    ball(
        canvas,
        6,
        &BALL,
        &orange.lit(sun.shiny(viewer, 30, fx!(0.7))?),
    )?;
    let steps = Flat::new(Rgb565::WHITE).lit(sun).map(|at, lit| {
        let lit = lit.finish(at.point);
        let bright = u8::from(lit.g() > 26) + u8::from(lit.g() > 52); // white is 63
        Some(Rgb565::new(13 + 9 * bright, 18 + 18 * bright, 2))
    });
    ball(canvas, 7, &BALL, &steps)
}

/// All shapes: a box, a sphere, a torus, a square; a cylinder, a cone, a disc, a vase.
pub(super) fn shapes(canvas: &mut Frame<'_>) -> Drawn {
    const VASE: &[(Scalar, Scalar)] = &[
        (fx!(0.5), fx!(1)),
        (fx!(0.25), fx!(0.7)),
        (fx!(0.25), fx!(0.5)),
        (fx!(0.6), fx!(0.15)),
        (fx!(0.75), fx!(-0.25)),
        (fx!(0.6), fx!(-0.65)),
        (fx!(0.35), fx!(-0.9)),
        (fx!(0.35), fx!(-0.9)),
        (fx!(0.5), fx!(-1)),
        (fx!(0.5), fx!(-1)),
        (fx!(0), fx!(-1)),
    ];
    static SHAPES: [Mesh; 8] = [
        shape!(cuboid(vec3!(0.75, 0.75, 0.75))),
        BALL,
        shape!(torus(fx!(0.4), 24, 12)),
        SHEET,
        shape!(cylinder(24)),
        shape!(cone(24)),
        shape!(disc(24)),
        shape!(lathe(24, VASE)),
    ];
    canvas.clear(SLATE);
    let (width, height) = (SIZE.width / 4, SIZE.height / 2);
    let projection = Projection::perspective(deg!(38), (width, height), fx!(1), fx!(20))?;
    let camera = Camera::look_at(vec3!(0, 3, 5), Vec3::ZERO, Vec3::Y)?;
    let mvp = projection * camera * Transform::rotate_y(deg!(-25));
    let skin = Textured::new(&CHECKERS).lit(sun()?);
    for (at, shape) in (0..).zip(&SHAPES) {
        let corner = (at % 4 * width.cast_signed(), at / 4 * height.cast_signed());
        let part = Viewport::new(corner.0, corner.1, width, height)?;
        let options = DrawOptions::new()
            .with_viewport(part)
            .with_cull(Cull::Nothing);
        canvas.draw_with(&options, shape, &mvp, &skin);
    }
    Ok(())
}
