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

/// The width of the picture, and the height of the chart above the views.
const WIDE: u32 = 1000;
const CHART: u32 = 700;
/// Each view shows a part of the floor. Each pixel is drawn as a square with this side.
const ZOOM: u32 = 2;
/// The left and top edges, the width and the height of the part of the floor.
const PART: (u32, u32, u32, u32) = (40, 88, 240, 152);
/// The height of the lines of text above a view.
const WORDS: u32 = 84;
const SIZE: (u32, u32) = (WIDE, CHART + WORDS + PART.3 * ZOOM);

/// The name of the font.
const FONT: &str = "sans-serif";
/// The sizes of names and of numbers. On a screen of 400 points, the letters are still 9 points high.
const NAME: (&str, i32) = (FONT, 30);
const LABEL: (&str, i32) = (FONT, 27);

/// The colors of a picture.
pub struct Theme {
    paper: RGBColor,
    /// The color of axes and letters.
    ink: RGBColor,
    grid: RGBColor,
    /// The color of the line through the modes of a scene.
    thread: RGBColor,
    /// The colors of the modes `Exact`, `Newton`, `Fast` and `Affine`. Color-blind readers can tell the colors of this
    /// palette, by Okabe and Ito, apart.
    modes: [RGBColor; 4],
}

pub const LIGHT: Theme = Theme {
    paper: WHITE,
    ink: RGBColor(40, 40, 40),
    grid: RGBColor(225, 225, 225),
    thread: RGBColor(195, 195, 195),
    modes: [
        RGBColor(0, 114, 178),
        RGBColor(213, 94, 0),
        RGBColor(0, 158, 115),
        RGBColor(204, 121, 167),
    ],
};

/// For a dark page: the palette's colors are lighter.
pub const DARK: Theme = Theme {
    paper: RGBColor(13, 17, 23),
    ink: RGBColor(225, 225, 225),
    grid: RGBColor(48, 54, 61),
    thread: RGBColor(95, 100, 108),
    modes: [
        RGBColor(86, 180, 233),
        RGBColor(240, 140, 50),
        RGBColor(40, 190, 145),
        RGBColor(222, 150, 190),
    ],
};

/// The axis of errors begins here. For comparison, half a unit of an interpolated texel is 2⁻¹⁷.
const LEAST_ERROR: f64 = 1e-5;

/// A mark around a point.
type Mark = fn(&Paper<'_>, (i32, i32), RGBColor, RGBColor) -> Result<()>;

const SCENES: [(&str, &str, Mark); 2] = [
    ("floor", "a floor of 2 triangles", circle),
    ("cube", "a cube of 12 triangles", square),
];

/// Draws the rows of the floor and the cube, and saves the picture as PNG.
pub fn save(path: &Path, rows: &[Row], theme: &Theme) -> Result<()> {
    // The font is part of this program, so that none must be installed.
    register_font(FONT, FontStyle::Normal, dejavu::sans::regular())
        .map_err(|_| "the font cannot be read")?;
    let (width, height) = SIZE;
    let mut bytes = vec![0; 3 * width as usize * height as usize];
    let paper = BitMapBackend::with_buffer(&mut bytes, SIZE).into_drawing_area();
    paper.fill(&theme.paper)?;
    let (upper, lower) = paper.split_vertically(CHART);
    chart(&paper, &upper, rows, theme)?;
    let (left, right) = lower.split_horizontally(WIDE - PART.2 * ZOOM);
    view(&left, rows, "affine", Affine, theme)?;
    view(&right, rows, "newton", Newton::default(), theme)?;
    paper.present()?;
    drop((paper, upper, lower, left, right));

    let file = File::create(path).map_err(|error| format!("{}: {error}", path.display()))?;
    let mut encoder = png::Encoder::new(file, width, height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_compression(png::Compression::High);
    encoder.write_header()?.write_image_data(&bytes)?;
    Ok(())
}

/// The name of a mode in the picture, and its color.
fn style<'m>(mode: &'m str, theme: &Theme) -> (&'m str, RGBColor) {
    let [exact, newton, fast, affine] = theme.modes;
    match mode {
        "exact" => ("Exact", exact),
        "newton" => ("Newton, the default", newton),
        "fast" => ("Fast, within ¼ texel", fast),
        "affine" => ("Affine", affine),
        _ => (mode, theme.ink),
    }
}

/// Draws the errors over the costs.
fn chart(paper: &Paper<'_>, part: &Paper<'_>, rows: &[Row], theme: &Theme) -> Result<()> {
    let ink = theme.ink;
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
        .margin(20)
        .x_label_area_size(84)
        .y_label_area_size(150)
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
        .bold_line_style(theme.grid.stroke_width(2))
        .light_line_style(TRANSPARENT)
        .axis_style(ink.stroke_width(2))
        .label_style(LABEL.into_font().color(&ink))
        .axis_desc_style(NAME.into_font().color(&ink))
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
        chart.draw_series(LineSeries::new(line, theme.thread.stroke_width(2)))?;
        for (mode, point) in points {
            let (x, y) = chart.backend_coord(point);
            let (name, color) = style(mode, theme);
            mark(paper, (x, y), color, theme.paper)?;
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
    let text = TextStyle::from(LABEL.into_font()).color(&ink);
    let text = text.pos(Pos::new(HPos::Left, VPos::Center));
    for ((words, mark, _), y) in lines.iter().zip([46, 86]) {
        mark(paper, (600, y), ink, theme.paper)?;
        paper.draw_text(words, &text, (622, y))?;
    }
    // An arrow points into the corner where both axes are low.
    let (x, y) = (192, 574);
    for end in [(x + 60, y - 36), (x + 4, y - 22), (x + 20, y + 2)] {
        paper.draw(&PathElement::new([(x, y), end], ink.stroke_width(3)))?;
    }
    let text = TextStyle::from(NAME.into_font()).color(&ink);
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

fn circle(paper: &Paper<'_>, center: (i32, i32), color: RGBColor, rim: RGBColor) -> Result<()> {
    // A rim separates overlapping marks.
    paper.draw(&Circle::new(center, 10, rim.filled()))?;
    Ok(paper.draw(&Circle::new(center, 8, color.filled()))?)
}

fn square(paper: &Paper<'_>, (x, y): (i32, i32), color: RGBColor, rim: RGBColor) -> Result<()> {
    let corners = [(-8, -8), (8, -8), (8, 8), (-8, 8), (-8, -8)].map(|(dx, dy)| (x + dx, y + dy));
    paper.draw(&Polygon::new(&corners[..4], color.filled()))?;
    Ok(paper.draw(&PathElement::new(corners, rim.stroke_width(2)))?)
}

/// Draws a part of the floor below the name and the figures of its mode.
fn view(paper: &Paper<'_>, rows: &[Row], name: &str, mode: impl Mode, theme: &Theme) -> Result<()> {
    let mut pixels = vec![Rgb565::CSS_LIGHT_STEEL_BLUE; (WIDTH * HEIGHT) as usize];
    let mut canvas = Canvas::new(&mut pixels, WIDTH, HEIGHT)?;
    let options = DrawOptions::new().with_mode(mode);
    scenes::floor(&mut canvas, &options, &scenes::floor_mvp(0)?);

    let row = rows
        .iter()
        .find(|row| (row.scene, row.mode) == ("floor", name));
    let row = row.ok_or("a view has no figures")?;
    let (title, color) = style(name, theme);
    let (cost, error) = (row.cost()?, digits(row.max, 1));
    let text = TextStyle::from(LABEL.into_font()).color(&color);
    paper.draw_text(title, &text, (0, 4))?;
    paper.draw_text(
        &format!("{cost:.2} million, {error} texels"),
        &text,
        (0, 40),
    )?;
    let (left, top, width, height) = PART;
    for row in 0..height {
        for column in 0..width {
            let color = Rgb888::from(pixels[((top + row) * WIDTH + left + column) as usize]);
            let color = RGBColor(color.r(), color.g(), color.b());
            let [x, y, side] = [column * ZOOM, WORDS + row * ZOOM, ZOOM].map(u32::cast_signed);
            let square = Rectangle::new([(x, y), (x + side, y + side)], color.filled());
            paper.draw(&square)?;
        }
    }
    Ok(())
}
