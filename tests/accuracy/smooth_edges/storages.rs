//! Mixtures in every storage and in dithered formats.

use embedded_graphics::pixelcolor::raw::{BigEndian, LittleEndian};
use embedded_graphics::pixelcolor::{BinaryColor, Gray4, GrayColor, Rgb565, RgbColor};
use fixel::canvas::{Storage, Words};
use fixel::prelude::*;
use fixel::shade::PixelFormat;
use support::counter::{BOTH_SIDES, at_subpixel, pixel_projection};

const PANEL: (u32, u32) = (64, 24);

/// A level edge between white above and black below, at this y in 256ths of a pixel. Returns the smoothed cells of the
/// row in which the edge is.
fn level<C: PixelFormat, O: Storage<C>>(y: i32, [black, white]: [C; 2]) -> Vec<C> {
    let corners = [[-2000, -2000], [40_000, -2000], [40_000, y], [-2000, y]];
    let positions = corners.map(at_subpixel);
    let faces = [[0, 1, 2], [0, 2, 3]];
    let mesh = Mesh::new(&positions, &faces).unwrap();
    let mut room = [[0; 4]; 6];
    let outline = Outline::build(&mesh, deg!(180), &mut room).unwrap();
    let mvp = pixel_projection(PANEL);
    let mut cells = vec![O::store(black); (PANEL.0 * PANEL.1) as usize];
    let mut canvas: Canvas<'_, C, O> = Canvas::new(&mut cells, PANEL.0, PANEL.1).unwrap();
    canvas.draw_with(&BOTH_SIDES, &mesh, &mvp, &Flat::new(white));
    canvas.smooth_edges(&BOTH_SIDES, &mesh, &outline, &mvp);
    let (width, row) = (PANEL.0 as usize, (y >> 8) as usize);
    let of_row = |(at, cell): (usize, O::Cell)| {
        let color = O::load(cell);
        let expected = if at / width < row { white } else { black };
        assert!(
            at / width == row || color == expected,
            "another row has changed"
        );
        (at / width == row).then_some(color)
    };
    cells.into_iter().enumerate().filter_map(of_row).collect()
}

/// A share is within 3/256 of the exact share, and for 16-bit colors, it is rounded to 1/32. The mixture is rounded to a
/// step. All storages hold the same colors.
#[test]
fn storages_hold_the_same_mixtures() {
    let colors = [Rgb565::new(3, 60, 31), Rgb565::new(29, 10, 0)];
    for y in 8 << 8..9 << 8 {
        let native = level::<_, Native>(y, colors);
        assert!(native == level::<_, Words>(y, colors));
        assert!(native == level::<_, BigEndian>(y, colors));
        assert!(native == level::<_, LittleEndian>(y, colors));
        let share = f64::from(y & 255) / 256.;
        let [black, white] = colors.map(channels_of_565);
        for color in native {
            for (i, channel) in channels_of_565(color).into_iter().enumerate() {
                let exact = black[i] + share * (white[i] - black[i]);
                let allowed = (white[i] - black[i]).abs() * (3. / 256. + 1. / 64.) + 0.5;
                assert!((channel - exact).abs() <= allowed, "{channel}, not {exact}");
            }
        }
    }
}

fn channels_of_565(color: Rgb565) -> [f64; 3] {
    [color.r(), color.g(), color.b()].map(f64::from)
}

/// Checks the mean of a format with `steps` steps between black and white over 8 rows and 64 columns, which have each of
/// the 64 thresholds 8 times. The thresholds are 1/64 step apart, so the mean has an error of up to 1/128 step.
fn check_dithered<C: PixelFormat>(colors: [C; 2], steps: f64, step: impl Fn(C) -> f64) {
    for offset in 0..256 {
        let rows = (8..16).flat_map(|row| level::<C, Native>(row << 8 | offset, colors));
        let steps_of_all: Vec<f64> = rows.map(&step).collect();
        let mean = steps_of_all.iter().sum::<f64>() / steps_of_all.len() as f64 / steps;
        let share = f64::from(offset) / 256.;
        let allowed = 3. / 256. + 1. / 128. / steps;
        assert!((mean - share).abs() <= allowed, "{mean}, not {share}");
    }
}

#[test]
fn dithered_mixtures_have_the_mean_of_the_share() {
    let binary = [BinaryColor::Off, BinaryColor::On];
    check_dithered(binary, 1., |color| f64::from(u8::from(color.is_on())));
    let gray = [Gray4::BLACK, Gray4::WHITE];
    check_dithered(gray, 15., |color| f64::from(color.luma()));
}
