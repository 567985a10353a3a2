//! The pictures of the documentation must equal the pictures that the scenes draw.

use std::fs;
use std::path::Path;

use cookbook::world::{FRAMES, LOOK, WALK, turn_of, viewer, walk};
use cookbook::{
    MOVING, PAGE_SIZE, PAGES, SCENES, SIZE, THUMBNAIL, all, animation, frames, page, picture,
    pictures, thumbnail,
};
use embedded_graphics::geometry::{Point, Size};
use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
use embedded_graphics_simulator::{OutputSettings, SimulatorDisplay};
use fixel::prelude::*;

/// After a change that is meant to change a picture, run `cargo run -p cookbook -- --renew`, look at the picture,
/// and say why in the commit.
#[test]
fn pictures_are_those_of_the_documentation() {
    for (name, draw) in all() {
        let path = pictures().join(name).with_extension("png");
        let found = picture(draw, SIZE).unwrap();
        let shown = SimulatorDisplay::load_png(&path).unwrap();
        assert!(found.diff(&shown).is_none(), "{name} has changed");
        let found = picture(draw, THUMBNAIL).unwrap();
        let shown = SimulatorDisplay::load_png(thumbnail(name)).unwrap();
        assert!(found.diff(&shown).is_none(), "small {name} has changed");
    }
}

#[test]
fn animations_are_those_of_the_readme() {
    let mut all_bytes = fs::metadata(pictures().join("world.webp")).unwrap().len();
    for &(name, draw, period) in MOVING {
        let bytes = fs::read(animation(name)).unwrap();
        all_bytes += bytes.len() as u64;
        let shown = webp::AnimDecoder::new(&bytes).decode().unwrap();
        let shown = shown.get_frames(0..shown.len()).unwrap();
        let found = frames(draw, period).unwrap();
        assert_eq!(shown.len(), found.len(), "{name}");
        for (number, (shown, found)) in shown.iter().zip(&found).enumerate() {
            let found = found.to_rgb_output_image(&OutputSettings::default());
            let found = found.as_image_buffer();
            let rgb: Vec<u8> = shown
                .get_image()
                .chunks(4)
                .flat_map(|rgba| &rgba[..3])
                .copied()
                .collect();
            assert!(
                rgb == found.as_raw()[..],
                "{name} has changed at frame {number}"
            );
        }
    }
    assert!(
        all_bytes < 2_350_000,
        "README's animations have {all_bytes} bytes"
    );
}

#[test]
fn pictures_of_pages_are_those_of_the_documentation() {
    for &(name, draw) in PAGES {
        let found = picture(draw, PAGE_SIZE).unwrap();
        let shown = SimulatorDisplay::load_png(page(name)).unwrap();
        assert!(found.diff(&shown).is_none(), "{name} has changed");
        // A page of the documentation loads its picture, so pictures must be small.
        let bytes = fs::metadata(page(name)).unwrap().len();
        assert!(bytes <= 10_240, "{name} has {bytes} bytes");
    }
}

#[test]
fn scenes_draw_in_the_size_of_a_small_display() {
    for (name, draw) in all() {
        let drawn = picture(draw, Size::new(128, 64));
        assert!(drawn.is_ok(), "{name}: {:?}", drawn.err());
    }
}

/// The guide has a small picture and a recipe for each scene.
#[test]
fn scenes_are_in_the_guide() {
    const GUIDE: &str = include_str!("../../../src/guide/cookbook.rs");
    for (name, _) in all() {
        let (small, recipe) = (format!("\" \"{name}\""), format!("\", \"{name}\""));
        assert!(GUIDE.contains(&small) && GUIDE.contains(&recipe), "{name}");
    }
}

#[test]
fn scenes_are_short() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../src/scenes");
    for (name, _) in SCENES {
        let text = fs::read_to_string(folder.join(name).with_extension("rs")).unwrap();
        assert!(text.lines().count() <= 72, "{name} has more than 72 lines");
    }
}

/// Reflections, blended lights and labels are the same in bands as in the frame.
#[test]
fn bands_equal_frames() {
    const WIDTH: u32 = SIZE.width;
    const HEIGHT: u32 = SIZE.height;
    const ROWS: u32 = 48;
    let turn = turn_of(FRAMES / 2);
    let frame = picture(|canvas| walk(canvas, turn), SIZE).unwrap();
    let mut colors = vec![Rgb565::BLACK; (WIDTH * ROWS) as usize];
    let mut depths = vec![0; colors.len()];
    for first_row in (0..HEIGHT).step_by(ROWS as usize) {
        let band = Canvas::band(&mut colors, WIDTH, HEIGHT, first_row).unwrap();
        let mut band = band.with_depth(&mut depths).unwrap();
        walk(&mut band, turn).unwrap();
        for (at, color) in (0..).zip(band.pixels()) {
            let (x, y) = (at % WIDTH, first_row + at / WIDTH);
            let at = Point::new(x.cast_signed(), y.cast_signed());
            assert_eq!(color, frame.get_pixel(at), "{at}");
        }
    }
}

/// The walk passes each stop without a jump. The end of the walk meets its start at the first stop.
#[test]
fn the_walk_is_closed() {
    for (stop, stops) in (0..).zip(WALK.into_iter().zip(LOOK)) {
        let turn = Angle::from_bits(stop << 29);
        assert_eq!(viewer(turn), stops);
        let ((eye, target), (eye_before, target_before)) =
            (viewer(turn), viewer(turn - Angle::from_bits(1 << 9)));
        // A step is 2^-20 of the way between two stops. The stops are less than 8 units apart. Rounding makes the step
        // larger.
        assert!(
            eye_before.distance(eye) < fx!(0.001),
            "{stop}: {eye_before}"
        );
        assert!(
            target_before.distance(target) < fx!(0.001),
            "{stop}: {target_before}"
        );
    }
}
