//! The part of the program that runs on the host. This part draws a frame as a whole, and compares the frame with the
//! emulator's panel.

use std::error::Error;
use std::path::{Path, PathBuf};

use clap::Parser;
use embedded_graphics::geometry::{Point, Size};
use embedded_graphics::pixelcolor::{Gray4, GrayColor};
use embedded_graphics_simulator::{OutputSettingsBuilder, SimulatorDisplay};
use fixel::prelude::*;

use super::gyroscope::{FRAMES, HEIGHT, Lists, WIDTH};

/// In QEMU's window, a pixel of the panel is this many pixels wide and high.
const SCALE: u32 = 4;

/// Draws the picture of the board's panel.
#[derive(Parser)]
#[command(name = "oled", version)]
struct Args {
    /// Picture to write.
    #[arg(value_name = "PICTURE.png", default_value = "oled.png")]
    picture: PathBuf,

    /// Which frame to draw.
    #[arg(long, default_value_t = FRAMES - 1, value_parser = clap::value_parser!(u32).range(..i64::from(FRAMES)))]
    frame: u32,

    /// Screen dump of QEMU to compare with; it is an error if a pixel differs.
    #[arg(long, value_name = "DUMP.png")]
    compare: Option<PathBuf>,
}

pub fn run() -> Result<(), Box<dyn Error>> {
    let args = Args::parse();
    let panel = draw(args.frame)?;
    let settings = OutputSettingsBuilder::new().scale(SCALE).build();
    let picture = panel.to_grayscale_output_image(&settings);
    picture
        .save_png(&args.picture)
        .map_err(|error| format!("cannot write {}: {error}", args.picture.display()))?;
    println!("frame {}: {}", args.frame, args.picture.display());
    if let Some(dump) = args.compare {
        compare(&panel, &dump).map_err(|error| format!("{}: {error}", dump.display()))?;
        println!(
            "{}: all {} pixels are the same",
            dump.display(),
            WIDTH * HEIGHT
        );
    }
    Ok(())
}

fn draw(frame: u32) -> Result<SimulatorDisplay<Gray4>, fixel::Error> {
    let mut grays = vec![Gray4::BLACK; (WIDTH * HEIGHT) as usize];
    let mut depths = vec![0; grays.len()];
    let mut canvas = Canvas::new(&mut grays, WIDTH, HEIGHT)?.with_depth(&mut depths)?;
    Lists::new().prepare(frame)?.draw(&mut canvas)?;
    let mut panel = SimulatorDisplay::new(Size::new(WIDTH, HEIGHT));
    canvas.show(&mut panel)?;
    Ok(panel)
}

/// Compares the gray of each pixel.
///
/// # Errors
///
/// The dump is not a picture of the panel, or a pixel differs. The message names the first pixel that differs.
fn compare(panel: &SimulatorDisplay<Gray4>, dump: &Path) -> Result<(), Box<dyn Error>> {
    let dump = image::open(dump)?.to_rgb8();
    let (width, height) = (WIDTH * SCALE, HEIGHT * SCALE);
    if dump.dimensions() != (width, height) {
        let size = format!("{}x{}", dump.width(), dump.height());
        return Err(format!("its size is {size}, not {width}x{height}").into());
    }
    for (x, y, shown) in dump.enumerate_pixels() {
        let at = Point::new(x.cast_signed(), y.cast_signed()) / SCALE.cast_signed();
        let gray = panel.get_pixel(at).luma();
        // White is 15 on the panel and 255 in the dump.
        if shown.0 != [gray * 17; 3] {
            let (x, y) = (at.x, at.y);
            let problem = format!("pixel {x},{y} is {:?}, on the host {}", shown.0, gray * 17);
            return Err(problem.into());
        }
    }
    Ok(())
}
