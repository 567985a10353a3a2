//! Two cores: bands of a frame drawn on two threads at once equal the frame, bit for bit. (`traits` checks that all types
//! may be shared.)

use std::sync::Barrier;
use std::thread;

use fixel::prelude::*;

use crate::examples::scenes::{HEIGHT, WIDTH};
use crate::golden::{Target, draw_lighthouse};

/// Draws rows of the frame, from the given row on, until the pixels are full.
fn draw(pixels: &mut [[u8; 2]], first: u32) {
    let mut depths = vec![7; pixels.len()];
    let band = Canvas::band(pixels, WIDTH, HEIGHT, first).unwrap();
    let mut band: Target<'_> = band.with_depth(&mut depths).unwrap();
    draw_lighthouse(&mut band);
}

/// The threads start together. Each thread draws every other band, or half of the frame.
#[test]
fn bands_drawn_on_two_threads_equal_the_frame() {
    let mut frame = vec![[0; 2]; (WIDTH * HEIGHT) as usize];
    draw(&mut frame, 0);
    // 37 does not divide the height, so the last band has fewer rows.
    for rows in [1, 37] {
        let half = HEIGHT.div_ceil(rows) / 2;
        let splits: [(&str, &dyn Fn(u32) -> bool); 2] = [
            ("every other", &|band| band % 2 == 0),
            ("halves", &|band| band < half),
        ];
        for (name, is_first) in splits {
            // No drawing leaves this pattern in the pixels, so pixels that were not drawn are found.
            let mut pixels = vec![[0xa5, 0x5a]; frame.len()];
            let bands = (0..).zip(pixels.chunks_mut((WIDTH * rows) as usize));
            let (first, second): (Vec<_>, Vec<_>) = bands.partition(|(band, _)| is_first(*band));
            let start = Barrier::new(2);
            thread::scope(|scope| {
                for core in [first, second] {
                    scope.spawn(|| {
                        start.wait();
                        for (band, pixels) in core {
                            draw(pixels, band * rows);
                        }
                    });
                }
            });
            let differs = (0..frame.len()).find(|&at| pixels[at] != frame[at]);
            assert_eq!(differs, None, "{name} of {rows} rows: pixel of row order");
        }
    }
}
