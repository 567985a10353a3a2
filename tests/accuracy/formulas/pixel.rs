//! Steps of depth, and mip levels.

use embedded_graphics::pixelcolor::{Gray8, GrayColor};
use fixel::canvas::LinearDepth;
use fixel::prelude::*;
use fixel::texture::Mipmap;

use super::helpers::{STEP, assert_row, close, digits, vec};

const PAGE: &str = include_str!("../../../src/guide/mathematics/pixels.rs");

/// The stored depth of a point straight ahead, with the near plane at 1.
fn depth(w: f64) -> u16 {
    let projection =
        Projection::perspective(Angle::from_degrees(90), (1, 1), fx!(1), fx!(2000)).unwrap();
    let screen = Viewport::new(0, 0, 1, 1).unwrap();
    let place = screen.project(vec(0.0, 0.0, -w), &projection);
    place.unwrap().depth::<LinearDepth>()
}

#[test]
fn a_step_of_depth_grows_with_the_square_of_the_distance() {
    for (w, places, step_places) in [(10.0, 4, 4), (100.0, 1, 2), (300.0, 1, 1), (1000.0, 1, 1)] {
        let stored = depth(w);
        close(stored.into(), (65_535.0 / w).floor(), 0.0);
        let nearest = 65_535.0 / (f64::from(stored) + 1.0);
        let farthest = 65_535.0 / f64::from(stored);
        // Depths have an error of at most 0.003 of a step, and distances are rounded by up to half of 2^-16.
        let slack = 0.003 * (farthest - nearest) + STEP;
        assert_eq!(
            [depth(nearest + slack), depth(farthest - slack)],
            [stored; 2]
        );
        assert_eq!(depth(nearest - slack), stored + 1);
        assert_eq!(depth(farthest + slack), stored - 1);
        // The derivative differs from the difference by the step's share of the distance, at both ends.
        let step = w * w / 65_535.0;
        close(farthest - nearest, step, 2.0 * step * step / w);
        let row = [
            digits(w, 0),
            stored.to_string(),
            digits(nearest, places),
            digits(farthest, places),
            digits(step, step_places),
        ];
        assert_row(PAGE, &row);
    }
}

/// A floor one unit below the eye, with 64 texels per unit. A texel's gray is its level.
#[test]
fn the_level_is_the_logarithm_of_the_texels_in_a_pixel() {
    const SIDE: u32 = 161;
    const COUNT: usize = Mipmap::<Gray8>::len(64, 64);
    let mut texels = Vec::with_capacity(COUNT);
    for level in 0..7_u8 {
        texels.resize(texels.len() + (4096 >> (2 * level)), Gray8::new(level));
    }
    let mipmap = Mipmap::new(&texels, 64, 64).unwrap();
    let corners = [
        vec3!(-2, -1, -1),
        vec3!(2, -1, -1),
        vec3!(2, -1, -16),
        vec3!(-2, -1, -16),
    ];
    let uvs = [vec2!(-2, 1), vec2!(2, 1), vec2!(2, -14), vec2!(-2, -14)];
    let floor = Mesh::new(&corners, &[[0, 1, 2], [0, 2, 3]]).unwrap();
    let floor = floor.with_uvs(&uvs, None).unwrap();
    let frame = (SIDE, SIDE);
    let projection = Projection::from_focal_length(fx!(160), frame, fx!(0.5), fx!(20)).unwrap();
    let shader = Textured::new(mipmap).mipmapped(&projection, frame).unwrap();
    let mut pixels = vec![Gray8::new(255); (SIDE * SIDE) as usize];
    let mut canvas = Canvas::new(&mut pixels, SIDE, SIDE).unwrap();
    canvas.draw(&floor, &projection, &shader);
    for (rows, places) in [(80_u32, 0), (64, 1), (32, 0), (16, 0)] {
        let distance = 160.0 / f64::from(rows);
        let across = 64.0 * distance / 160.0;
        let along = across * distance;
        let level = along.log2();
        // The crate's level has an error of at most 1/8, so the nearest level is certain.
        assert!((level - level.round()).abs() < 0.375);
        // The horizon is at the middle of the picture, at the center of row 80.
        let seen = pixels[((80 + rows) * SIDE + 80) as usize].luma();
        close(f64::from(seen), level.round(), 0.0);
        let row = [
            rows.to_string(),
            digits(distance, places),
            digits(across, 1),
            digits(along, 1),
            digits(level, 2),
            seen.to_string(),
        ];
        assert_row(PAGE, &row);
    }
}
