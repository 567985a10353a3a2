//! One picture of the trade: the cost of each mode on a Cortex-M4, its error, and what the error looks like.

use std::collections::HashMap;
use std::fs;

use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor, WebColors};
use fixel::mode::Mode;
use fixel::prelude::*;
use plotters::coord::Shift;
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use super::axis::{Axis, LEAST_ERROR, error_label, label};
use super::chart::{self, Side};
use super::legend::Mark;
use super::{Figure, INK, LABEL, NAME, TITLE, color};
use crate::Result;
use crate::modes::{self, Visitor};
use crate::scenes::{self, HEIGHT, WIDTH};

/// The width of the chart, to the left of the views.
const CHART: u32 = 1000;
/// Each view shows a part of the floor. Each pixel is drawn as a square with this side.
const ZOOM: u32 = 2;
/// The left and top edges, the width and the height of the part of the floor.
const PART: (u32, u32, u32, u32) = (0, 88, 320, 152);
/// The height of a view, with the line of text above the view.
const VIEW: u32 = PART.3 * ZOOM + 64;
const SCENES: [(&str, &str, Mark); 2] = [
    ("floor", "a floor of 2 triangles", Mark::Circle),
    ("cube", "a cube of 12 triangles", Mark::Square),
];

/// The cost and the error of a mode in a scene.
struct Point {
    scene: &'static str,
    mode: &'static str,
    /// The cost in millions of instructions per frame.
    cost: f64,
    /// The largest error, in texels.
    error: f64,
}

/// The floor, drawn in a mode.
struct View {
    mode: &'static str,
    pixels: Vec<Rgb565>,
}

/// The figure.
pub struct Summary {
    points: Vec<Point>,
    views: Vec<View>,
}

impl Summary {
    /// Reads the figures that the project keeps. The working directory must be the folder of the repository.
    pub fn read() -> Result<Self> {
        let (costs, errors) = ("tests/instructions.csv", "tests/figures.csv");
        let (costs, errors) = (read(costs, 5)?, read(errors, 2)?);
        let mut points = Vec::new();
        for (scene, ..) in SCENES {
            for mode in modes::NAMES {
                let find = |figures: &HashMap<String, f64>, name: String| {
                    let found = figures.get(&name).copied();
                    found.ok_or_else(|| format!("the figures lack '{name}'"))
                };
                let cost = format!("thumbv7em-none-eabi,3,{mode},{scene},mean-of-poses");
                let error = format!("errors,{scene} {mode} error max");
                points.push(Point {
                    scene,
                    mode,
                    cost: find(&costs, cost)? / 1e6,
                    error: find(&errors, error)?,
                });
            }
        }
        let mut views = Views(Vec::new());
        modes::each(&mut views)?;
        Ok(Self {
            points,
            views: views.0,
        })
    }

    fn chart<DB: DrawingBackend>(
        &self,
        paper: &DrawingArea<DB, Shift>,
        part: &DrawingArea<DB, Shift>,
    ) -> Result<()>
    where
        DB::ErrorType: 'static,
    {
        let errors = self.points.iter().map(|point| point.error);
        let mut costs = Axis::around(self.points.iter().map(|point| point.cost));
        // Make room for the words beside the outermost points.
        (costs.low, costs.high) = (costs.low * 0.6, costs.high * 1.1);
        let mut chart = chart::draw(
            ChartBuilder::on(part)
                .caption("What exact textures cost", TITLE.into_font().color(&INK))
                .margin(20),
            76,
            Side {
                axis: costs,
                name: "millions of Cortex-M4 instructions a frame",
                label_of: label,
            },
            Side {
                axis: Axis::decades(errors.chain([LEAST_ERROR])),
                name: "largest error of a pixel, in texels",
                label_of: error_label,
            },
        )?;
        for (scene, _, mark) in SCENES {
            let points: Vec<&Point> = self.points.iter().filter(|p| p.scene == scene).collect();
            let line = points.iter().map(|point| (point.cost, point.error));
            chart.draw_series(LineSeries::new(
                line,
                RGBColor(195, 195, 195).stroke_width(2),
            ))?;
            for point in points {
                let (x, y) = chart.backend_coord(&(point.cost, point.error));
                mark.draw(paper, (x, y), color(point.mode))?;
                // The cube's points are to the left of the floor's points.
                let (side, at) = if scene == "cube" && point.mode != "exact" {
                    (HPos::Right, x - 18)
                } else {
                    (HPos::Left, x + 18)
                };
                let ink = color(point.mode);
                let style = TextStyle::from(LABEL.into_font())
                    .color(&ink)
                    .pos(Pos::new(side, VPos::Center));
                paper.draw_text(title(point.mode), &style, (at, y))?;
            }
        }
        let style = TextStyle::from(LABEL.into_font()).color(&INK);
        let (left, top) = (560, 90);
        for (row, (_, words, mark)) in (0..).zip(SCENES) {
            mark.draw(paper, (left, top + 36 * row), INK)?;
            let centered = style.pos(Pos::new(HPos::Left, VPos::Center));
            paper.draw_text(words, &centered, (left + 22, top + 36 * row))?;
        }
        // An arrow points into the corner where both axes are low.
        let (x, y) = (172, 650);
        for end in [(x + 60, y - 36), (x + 4, y - 22), (x + 20, y + 2)] {
            paper.draw(&PathElement::new([(x, y), end], INK.stroke_width(3)))?;
        }
        paper.draw_text(
            "better",
            &TextStyle::from(NAME.into_font()).color(&INK),
            (x + 70, y - 52),
        )?;
        Ok(())
    }

    /// Draws a part of the floor below the name of its mode.
    fn view<DB: DrawingBackend>(
        &self,
        paper: &DrawingArea<DB, Shift>,
        view: &View,
        top: i32,
    ) -> Result<()>
    where
        DB::ErrorType: 'static,
    {
        let (left, first, width, height) = PART;
        let ink = color(view.mode);
        let style = TextStyle::from(LABEL.into_font()).color(&ink);
        let point = self
            .points
            .iter()
            .find(|p| p.scene == "floor" && p.mode == view.mode);
        let point = point.ok_or("a view has no figures")?;
        let words = format!(
            "{}: {:.2} million, {} texels",
            title(view.mode),
            point.cost,
            digits(point.error)
        );
        paper.draw_text(&words, &style, (0, top + 22))?;
        for row in 0..height {
            for column in 0..width {
                let at = (first + row) * WIDTH + left + column;
                let color = Rgb888::from(view.pixels[at as usize]);
                let color = RGBColor(color.r(), color.g(), color.b());
                let (x, y) = (
                    (column * ZOOM).cast_signed(),
                    top + 58 + (row * ZOOM).cast_signed(),
                );
                let side = ZOOM.cast_signed();
                let square = Rectangle::new([(x, y), (x + side, y + side)], color.filled());
                paper.draw(&square)?;
            }
        }
        Ok(())
    }
}

impl Figure for Summary {
    fn size(&self) -> (u32, u32) {
        (CHART + PART.2 * ZOOM + 20, 2 * VIEW + 26)
    }

    fn draw<DB: DrawingBackend>(&self, paper: &DrawingArea<DB, Shift>) -> Result<()>
    where
        DB::ErrorType: 'static,
    {
        let (chart, views) = paper.split_horizontally(CHART);
        self.chart(paper, &chart)?;
        let mut top = 0;
        for mode in ["affine", "newton"] {
            let view = self.views.iter().find(|view| view.mode == mode);
            self.view(&views, view.ok_or("a mode is missing")?, top)?;
            top += VIEW.cast_signed();
        }
        Ok(())
    }
}

/// The name of a mode in the picture.
fn title(mode: &str) -> &'static str {
    match mode {
        "exact" => "Exact",
        "newton" => "Newton, the default",
        "fast" => "Fast, within ¼ texel",
        "affine" => "Affine",
        _ => "another mode",
    }
}

/// A number with one significant digit, or without a fraction if it is at least 1.
fn digits(value: f64) -> String {
    if value >= 1. {
        format!("{value:.0}")
    } else {
        let places = (-value.log10()).ceil().max(0.) as usize;
        format!("{value:.places$}")
    }
}

/// Reads the last column of a table as numbers. The key of each number is the text of the columns before it.
fn read(file: &str, columns: usize) -> Result<HashMap<String, f64>> {
    let text = fs::read_to_string(file).map_err(|error| format!("{file}: {error}"))?;
    let lines = text.lines().filter_map(|line| line.rsplit_once(','));
    Ok(lines
        .filter(|(names, _)| names.split(',').count() == columns)
        .filter_map(|(names, value)| Some((names.to_owned(), value.parse().ok()?)))
        .collect())
}

/// Draws the floor in each mode.
struct Views(Vec<View>);

impl Visitor for Views {
    fn visit<I: Mode>(&mut self, name: &'static str, mode: I) -> Result<()> {
        let mut pixels = vec![Rgb565::CSS_LIGHT_STEEL_BLUE; (WIDTH * HEIGHT) as usize];
        let mut canvas = Canvas::new(&mut pixels, WIDTH, HEIGHT)?;
        let options = DrawOptions::new().with_mode(mode);
        scenes::floor(&mut canvas, &options, &scenes::floor_mvp(0)?);
        self.0.push(View { mode: name, pixels });
        Ok(())
    }
}
