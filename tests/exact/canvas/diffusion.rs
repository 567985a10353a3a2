//! Error diffusion: a display with few grays shows a picture of many grays.

use embedded_graphics::mock_display::MockDisplay;
use embedded_graphics::pixelcolor::{BinaryColor, Gray2, Gray4, Gray8, GrayColor};
use fixel::canvas::{Contrast, ErrorDiffusion};
use fixel::prelude::*;
use rand::rngs::SmallRng;
use rand::{Rng, SeedableRng};

use support::random::cases;

/// The colors of a display that shows rows of grays, and the errors that are left.
fn diffused<C>(grays: &mut [Gray8], width: u32) -> (Vec<C>, Vec<i16>)
where
    C: PixelFormat<Channels = i32> + Default,
{
    let (mut errors, mut shown) = (vec![0; width as usize], vec![C::default(); grays.len()]);
    let height = grays.len() as u32 / width;
    let gray = Canvas::new(grays, width, height).unwrap();
    let mut panel = Canvas::new(&mut shown, width, height).unwrap();
    let mut diffusion = ErrorDiffusion::new(&mut errors);
    let Ok(()) = gray.show_diffused(&mut panel, Contrast::default(), &mut diffusion);
    (shown, errors)
}

/// Diffusion keeps the sum of all grays; `errors` holds the part of the sum that is not shown. All grays are so far
/// from black and white that no error moves a gray past black or white.
#[test]
fn diffusion_loses_no_brightness() {
    let mut random = SmallRng::seed_from_u64(1);
    for (width, height) in [(1, 1), (1, 9), (2, 3), (17, 12), (70, 40)] {
        let pixels = (width * height) as usize;
        let mut gray = || Gray8::new(random.random_range(90..=165));
        let mut grays: Vec<Gray8> = (0..pixels).map(|_| gray()).collect();
        let sum: i32 = grays.iter().map(|gray| i32::from(gray.luma())).sum();
        let rest = |errors: &[i16]| errors.iter().map(|&error| i32::from(error)).sum::<i32>();

        let (shown, errors) = diffused::<BinaryColor>(&mut grays, width);
        let white = shown.iter().map(|color| 255 * i32::from(color.is_on()));
        assert_eq!(
            (sum - white.sum::<i32>()) * 16,
            rest(&errors),
            "{width}x{height}"
        );

        let (shown, errors) = diffused::<Gray4>(&mut grays, width);
        let white = shown.iter().map(|color| 17 * i32::from(color.luma()));
        assert_eq!(
            (sum - white.sum::<i32>()) * 16,
            rest(&errors),
            "{width}x{height}"
        );
        // An error is at most half a step, 17 / 2, plus the rounding of three shares. Each share is rounded down by
        // less than 1/16.
        assert!(errors.iter().all(|error| error.abs() <= 9 * 16));
    }
}

/// In every window of the frame, the diffused picture is as bright as the original, except for the errors that cross
/// the window's borders.
///
/// An error is at most half a step, 127.5. Each pixel of the first and last rows passes 9/16 of its error across the
/// upper or lower border. Each pixel of the first and last columns passes 7/16 + 1/16 of its error across one side, and
/// 3/16 across the other. Half an error crosses the corners. Rounding shares to 16ths loses at most one gray per three
/// pixels of a border.
#[test]
fn diffusion_keeps_the_brightness_of_every_window() {
    const SIZE: (u32, u32) = (160, 120);
    let wave = |x: f64, y: f64| 127.5 + 60. * (x / 19.).sin() + 55. * (x / 40. + y / 23.).cos();
    let places = (0..SIZE.1).flat_map(|y| (0..SIZE.0).map(move |x| (f64::from(x), f64::from(y))));
    let mut grays: Vec<Gray8> = places
        .map(|(x, y)| Gray8::new((wave(x, y).round() as i32).cast_unsigned() as u8))
        .collect();
    let (shown, _) = diffused::<BinaryColor>(&mut grays, SIZE.0);
    let mut widest: f64 = 0.;
    cases(500, |random| {
        let [width, height] = [random.random_range(1..100_u32), random.random_range(1..100)];
        // The window does not touch the sides of the frame, where diffusion has a rule of its own.
        let left = random.random_range(1..SIZE.0 - width);
        let top = random.random_range(0..=SIZE.1 - height);
        let mut excess = 0.;
        for y in top..top + height {
            for x in left..left + width {
                let is_on = shown[(y * SIZE.0 + x) as usize].is_on();
                excess += 255. * f64::from(u8::from(is_on)) - wave(x.into(), y.into()).round();
            }
        }
        let [w, h] = [width, height].map(f64::from);
        let most = 127.5 * (w * 9. / 8. + h * 11. / 8. + 0.5) + (2. * w + 2. * h) / 3.;
        assert!(
            f64::abs(excess) <= most,
            "{width}x{height} at {left}, {top}: {excess}"
        );
        widest = widest.max(f64::abs(excess) / (w * h));
    });
    // Some windows must differ by more than a gray; otherwise the bound tests nothing.
    assert!(widest > 1., "{widest}");
}

/// White pixels cannot absorb errors from gray pixels beside them. These errors must not accumulate at the border
/// between white and gray, because they would whiten the darker rows below.
#[test]
fn diffusion_does_not_whiten_darker_rows_below() {
    const WIDTH: u32 = 240;
    let mut grays = vec![Gray8::new(60); (WIDTH * 280) as usize];
    for row in grays.chunks_mut(WIDTH as usize) {
        row[220..].fill(Gray8::new(255));
    }
    grays.extend(vec![Gray8::new(0); (WIDTH * 8) as usize]);
    let (shown, _) = diffused::<BinaryColor>(&mut grays, WIDTH);
    // Half a step of error can make one pixel white.
    let stray = shown[(WIDTH * 280) as usize..].chunks(WIDTH as usize);
    let stray = stray.map(|row| row[200..].iter().filter(|color| color.is_on()).count());
    assert!(stray.sum::<usize>() <= 1);
}

/// The ramp runs from black on the left to 253 of 255 on the right.
#[test]
fn diffusion_of_a_gray_ramp() {
    let ramp = |i: u8| Gray8::new(i % 24 * 11);
    let mut grays: Vec<Gray8> = (0..192).map(ramp).collect();
    let gray = Canvas::new(&mut grays, 24, 8).unwrap();
    let mut display: MockDisplay<BinaryColor> = MockDisplay::new();
    let mut errors = [0; 24];
    let mut diffusion = ErrorDiffusion::new(&mut errors);
    gray.show_diffused(&mut display, Contrast::default(), &mut diffusion)
        .unwrap();
    display.assert_pattern(&[
        "........#.#.#.##.#######",
        ".....#.#...#.#.###.#####",
        "........#.#.#.#.########",
        "...#.#..#.#.##.##.#.###.",
        ".......#..#..##.#####.##",
        ".....#..#..##.##.#.#####",
        ".......#.#.#.#.#########",
        "...#.#....#.#.#.#.#.####",
    ]);

    // Grays that the display can show do not change.
    let mut grays = [0, 85, 170, 255].map(Gray8::new);
    let (shown, _) = diffused::<Gray2>(&mut grays, 4);
    assert_eq!(shown, [0, 1, 2, 3].map(Gray2::new));
}

#[test]
fn diffused_bands_equal_the_frame() {
    let mut grays: Vec<Gray8> = (0..=255).map(|i| Gray8::new(i / 2 + 50)).collect();
    let (whole, _) = diffused::<BinaryColor>(&mut grays, 16);
    // Errors that the previous frame left have no effect.
    let (mut shown, mut errors) = ([BinaryColor::Off; 256], [i16::MAX; 16]);
    let mut panel = Canvas::new(&mut shown, 16, 16).unwrap();
    let mut diffusion = ErrorDiffusion::new(&mut errors);
    for (first, grays) in (0..).step_by(5).zip(grays.chunks_mut(5 * 16)) {
        let gray = Canvas::band(grays, 16, 16, first).unwrap();
        let Ok(()) = gray.show_diffused(&mut panel, Contrast::default(), &mut diffusion);
    }
    assert_eq!(shown[..], whole);
}

/// The list of errors may have any length, and canvases of several widths may share it.
#[test]
fn diffusion_takes_memory_of_any_length() {
    let mut errors = [i16::MIN; 20];
    for length in [0, 1, 2, 3, 20] {
        let mut diffusion = ErrorDiffusion::new(&mut errors[..length]);
        for (width, height) in [(3, 2), (6, 1), (1, 6)] {
            let mut grays = [0, 255, 128, 7, 200, 90].map(Gray8::new);
            let gray = Canvas::new(&mut grays, width, height).unwrap();
            let mut shown = [BinaryColor::Off; 6];
            let mut panel = Canvas::new(&mut shown, width, height).unwrap();
            let Ok(()) = gray.show_diffused(&mut panel, Contrast::new(9, 3), &mut diffusion);
            // With this contrast, every gray becomes black or white.
            assert_eq!(
                shown.map(BinaryColor::is_on),
                [0, 1, 1, 0, 1, 1].map(|on| on == 1)
            );
        }
    }
}
