//! The trade in one picture: the cost of each mode on a Cortex-M4, its error, and what the error looks like.

use std::fs::File;
use std::path::Path;

use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor, WebColors};
use fixel::mode::{Affine, Mode, Newton};
use fixel::prelude::*;
use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{FontStyle, register_font};

use super::Result;
use super::scenes::{self, HEIGHT, WIDTH};
use super::table::{Row, digits};

type Paper<'a> = DrawingArea<BitMapBackend<'a>, Shift>;

/// The width of the chart, to the left of the views.
const CHART: u32 = 1000;
/// Each view shows a part of the floor. Each pixel is drawn as a square with this side.
const ZOOM: u32 = 2;
/// The left and top edges, the width and the height of the part of the floor.
const PART: (u32, u32, u32, u32) = (0, 88, 320, 152);
/// The height of a view, with the line of text above the view.
const VIEW: u32 = PART.3 * ZOOM + 64;
const SIZE: (u32, u32) = (CHART + PART.2 * ZOOM + 20, 2 * VIEW + 26);

/// The name of the font.
const FONT: &str = "sans-serif";
/// The sizes of titles, names of axes, and numbers. The picture is viewed at half of its size.
const TITLE: (&str, i32) = (FONT, 32);
const NAME: (&str, i32) = (FONT, 27);
const LABEL: (&str, i32) = (FONT, 24);
/// The color of axes and letters.
const INK: RGBColor = RGBColor(40, 40, 40);
const GRID: RGBColor = RGBColor(225, 225, 225);
/// The color of the line through the modes of a scene.
const THREAD: RGBColor = RGBColor(195, 195, 195);

/// The axis of errors begins here. For comparison, half a unit of an interpolated texel is 2⁻¹⁷.
const LEAST_ERROR: f64 = 1e-5;

/// A mark around a point.
type Mark = fn(&Paper<'_>, (i32, i32), RGBColor) -> Result<()>;

const SCENES: [(&str, &str, Mark); 2] = [
    ("floor", "a floor of 2 triangles", circle),
    ("cube", "a cube of 12 triangles", square),
];

/// Draws the rows of the floor and the cube, and saves the picture as PNG.
pub fn save(path: &Path, rows: &[Row]) -> Result<()> {
    // The font is part of this program, so that none must be installed.
    register_font(FONT, FontStyle::Normal, dejavu::sans::regular())
        .map_err(|_| "the font cannot be read")?;
    let (width, height) = SIZE;
    let mut bytes = vec![0; 3 * width as usize * height as usize];
    let paper = BitMapBackend::with_buffer(&mut bytes, SIZE).into_drawing_area();
    paper.fill(&WHITE)?;
    let (left, right) = paper.split_horizontally(CHART);
    chart(&paper, &left, rows)?;
    let (upper, lower) = right.split_vertically(VIEW);
    view(&upper, rows, "affine", Affine)?;
    view(&lower, rows, "newton", Newton::default())?;
    paper.present()?;
    drop((paper, left, right, upper, lower));

    let file = File::create(path).map_err(|error| format!("{}: {error}", path.display()))?;
    let mut encoder = png::Encoder::new(file, width, height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_compression(png::Compression::Fast);
    encoder.write_header()?.write_image_data(&bytes)?;
    Ok(())
}

/// The name of a mode in the picture, and its color. Color-blind readers can tell the colors of this palette, by Okabe
/// and Ito, apart.
fn style(mode: &str) -> (&str, RGBColor) {
    match mode {
        "exact" => ("Exact", RGBColor(0, 114, 178)),
        "newton" => ("Newton, the default", RGBColor(213, 94, 0)),
        "fast" => ("Fast, within ¼ texel", RGBColor(0, 158, 115)),
        "affine" => ("Affine", RGBColor(204, 121, 167)),
        _ => (mode, RGBColor(230, 159, 0)),
    }
}

/// Draws the errors over the costs.
fn chart(paper: &Paper<'_>, part: &Paper<'_>, rows: &[Row]) -> Result<()> {
    let mut lines = Vec::new();
    for (scene, words, mark) in SCENES {
        // Modes without a cost are left out: `Newton::NARROW` draws these scenes as `Newton` does.
        let rows = rows
            .iter()
            .filter(|row| row.scene == scene && row.is_counted());
        let points: Vec<(&str, (f64, f64))> = rows
            .map(|row| Ok((row.mode, (row.cost()?, row.max.max(LEAST_ERROR)))))
            .collect::<Result<_>>()?;
        lines.push((words, mark, points));
    }
    let points = || lines.iter().flat_map(|(_, _, points)| points);
    let costs = || points().map(|(_, (cost, _))| *cost);
    let (cheapest, dearest) = (
        costs().fold(f64::MAX, f64::min) / 1.25,
        costs().fold(0., f64::max) * 1.25,
    );
    let ticks = (-3..4)
        .flat_map(|power| [1., 1.5, 2., 3., 5., 7.].map(|digit: f64| digit * 10_f64.powi(power)));
    let ticks = ticks.filter(|tick| (cheapest..=dearest).contains(tick));
    let largest = points().fold(1., |largest: f64, (_, (_, error))| largest.max(*error));
    // The axis is a little longer than the largest error, so that its mark is not cut off.
    let decades = (largest * 1.2).log10().ceil() as i32;

    let mut chart = ChartBuilder::on(part)
        .caption("What exact textures cost", TITLE.into_font().color(&INK))
        .margin(20)
        .x_label_area_size(76)
        .y_label_area_size(130)
        .build_cartesian_2d(
            // There is room for the words beside the outermost points.
            (cheapest * 0.6..dearest * 1.1)
                .log_scale()
                .with_key_points(ticks.collect()),
            (LEAST_ERROR..10_f64.powi(decades))
                .log_scale()
                .with_key_points((-5..=decades).map(|power| 10_f64.powi(power)).collect()),
        )?;
    chart
        .configure_mesh()
        .bold_line_style(GRID.stroke_width(2))
        .light_line_style(TRANSPARENT)
        .axis_style(INK.stroke_width(2))
        .label_style(LABEL.into_font().color(&INK))
        .axis_desc_style(NAME.into_font().color(&INK))
        .x_desc("millions of Cortex-M4 instructions a frame")
        .y_desc("largest error of a pixel, in texels")
        .x_label_formatter(&|&cost| tick(cost))
        .y_label_formatter(&|&error| {
            // Smaller errors are drawn at the lowest tick.
            let sign = if error < LEAST_ERROR * 1.01 {
                "≤ "
            } else {
                ""
            };
            format!("{sign}{}", tick(error))
        })
        .draw()?;

    for (words, mark, points) in &lines {
        let line = points.iter().map(|(_, point)| *point);
        chart.draw_series(LineSeries::new(line, THREAD.stroke_width(2)))?;
        for (mode, point) in points {
            let (x, y) = chart.backend_coord(point);
            let (name, color) = style(mode);
            mark(paper, (x, y), color)?;
            // The cube's points are to the left of the floor's points.
            let (side, x) = if words.contains("cube") && *mode != "exact" {
                (HPos::Right, x - 18)
            } else {
                (HPos::Left, x + 18)
            };
            let text = TextStyle::from(LABEL.into_font()).color(&color);
            paper.draw_text(name, &text.pos(Pos::new(side, VPos::Center)), (x, y))?;
        }
    }
    let text = TextStyle::from(LABEL.into_font()).color(&INK);
    let text = text.pos(Pos::new(HPos::Left, VPos::Center));
    for ((words, mark, _), y) in lines.iter().zip([90, 126]) {
        mark(paper, (560, y), INK)?;
        paper.draw_text(words, &text, (582, y))?;
    }
    // An arrow points into the corner where both axes are low.
    let (x, y) = (172, 650);
    for end in [(x + 60, y - 36), (x + 4, y - 22), (x + 20, y + 2)] {
        paper.draw(&PathElement::new([(x, y), end], INK.stroke_width(3)))?;
    }
    let text = TextStyle::from(NAME.into_font()).color(&INK);
    paper.draw_text("better", &text, (x + 70, y - 52))?;
    Ok(())
}

/// The number of a tick, for example 0.001, 1.5, 20 or 1000.
fn tick(value: f64) -> String {
    let text = digits(value, 2);
    if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        text
    }
}

fn circle(paper: &Paper<'_>, center: (i32, i32), color: RGBColor) -> Result<()> {
    // A white rim separates overlapping marks.
    paper.draw(&Circle::new(center, 10, WHITE.filled()))?;
    Ok(paper.draw(&Circle::new(center, 8, color.filled()))?)
}

fn square(paper: &Paper<'_>, (x, y): (i32, i32), color: RGBColor) -> Result<()> {
    let corners = [(-8, -8), (8, -8), (8, 8), (-8, 8), (-8, -8)].map(|(dx, dy)| (x + dx, y + dy));
    paper.draw(&Polygon::new(&corners[..4], color.filled()))?;
    Ok(paper.draw(&PathElement::new(corners, WHITE.stroke_width(2)))?)
}

/// Draws a part of the floor below the name and the figures of its mode.
fn view(paper: &Paper<'_>, rows: &[Row], name: &str, mode: impl Mode) -> Result<()> {
    let mut pixels = vec![Rgb565::CSS_LIGHT_STEEL_BLUE; (WIDTH * HEIGHT) as usize];
    let mut canvas = Canvas::new(&mut pixels, WIDTH, HEIGHT)?;
    let options = DrawOptions::new().with_mode(mode);
    scenes::floor(&mut canvas, &options, &scenes::floor_mvp(0)?);

    let row = rows
        .iter()
        .find(|row| (row.scene, row.mode) == ("floor", name));
    let row = row.ok_or("a view has no figures")?;
    let (title, color) = style(name);
    let words = format!(
        "{title}: {:.2} million, {} texels",
        row.cost()?,
        digits(row.max, 1)
    );
    let text = TextStyle::from(LABEL.into_font()).color(&color);
    paper.draw_text(&words, &text, (0, 22))?;
    let (left, top, width, height) = PART;
    for row in 0..height {
        for column in 0..width {
            let color = Rgb888::from(pixels[((top + row) * WIDTH + left + column) as usize]);
            let color = RGBColor(color.r(), color.g(), color.b());
            let [x, y, side] = [column * ZOOM, 58 + row * ZOOM, ZOOM].map(u32::cast_signed);
            let square = Rectangle::new([(x, y), (x + side, y + side)], color.filled());
            paper.draw(&square)?;
        }
    }
    Ok(())
}
