//! Plots. Each plot is saved as PNG and as SVG.

mod axis;
mod chart;
mod curves;
mod legend;
mod scatter;
mod summary;

use std::path::Path;

use image::RgbImage;
use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::{FontStyle, register_font};

use super::Result;
use super::modes;

pub use curves::Curves;
pub use scatter::Scatter;
pub use summary::Summary;

/// A figure that can be drawn on any kind of paper.
pub trait Figure {
    /// The width and height in pixels.
    fn size(&self) -> (u32, u32);

    fn draw<DB: DrawingBackend>(&self, paper: &DrawingArea<DB, Shift>) -> Result<()>
    where
        DB::ErrorType: 'static;
}

/// The name of the font.
const FONT: &str = "sans-serif";
/// The sizes of titles, names of axes, and numbers. The pictures are viewed at half of their size.
const TITLE: (&str, i32) = (FONT, 32);
const NAME: (&str, i32) = (FONT, 27);
const LABEL: (&str, i32) = (FONT, 24);

/// Registers the font. Call this function once, before the first plot.
pub fn fonts() -> Result<()> {
    register_font(FONT, FontStyle::Normal, dejavu::sans::regular())
        .map_err(|_| "the font cannot be read".into())
}

/// Saves a figure as PNG and as SVG. `stem` is the path without the extension.
pub fn save(stem: &Path, figure: &impl Figure) -> Result<()> {
    save_png(&stem.with_extension("png"), figure)?;
    draw(
        SVGBackend::new(&stem.with_extension("svg"), figure.size()),
        figure,
    )
}

/// Saves a figure as PNG.
pub fn save_png(path: &Path, figure: &impl Figure) -> Result<()> {
    let (width, height) = figure.size();
    let mut bytes = vec![0; 3 * width as usize * height as usize];
    draw(
        BitMapBackend::with_buffer(&mut bytes, (width, height)),
        figure,
    )?;
    let picture = RgbImage::from_raw(width, height, bytes).ok_or("the plot has no pixels")?;
    Ok(picture.save(path)?)
}

fn draw<DB: DrawingBackend>(backend: DB, figure: &impl Figure) -> Result<()>
where
    DB::ErrorType: 'static,
{
    let paper = backend.into_drawing_area();
    paper.fill(&WHITE)?;
    figure.draw(&paper)?;
    Ok(paper.present()?)
}

/// The color of a mode. Color-blind readers can tell the colors of this palette, by Okabe and Ito, apart.
fn color(mode: &str) -> RGBColor {
    const COLORS: [RGBColor; 7] = [
        RGBColor(0, 114, 178),
        RGBColor(213, 94, 0),
        RGBColor(0, 158, 115),
        RGBColor(204, 121, 167),
        RGBColor(230, 159, 0),
        RGBColor(86, 180, 233),
        RGBColor(60, 60, 60),
    ];
    let place = modes::NAMES.iter().position(|name| *name == mode);
    COLORS[place.unwrap_or(0) % COLORS.len()]
}

/// The color of the grid.
const GRID: RGBColor = RGBColor(225, 225, 225);
/// The color of axes and letters.
const INK: RGBColor = RGBColor(40, 40, 40);
