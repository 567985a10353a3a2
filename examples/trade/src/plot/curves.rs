//! The plot of a sweep: the error above, and the cost below, along the same axis.

use plotters::coord::Shift;
use plotters::prelude::*;

use super::axis::{Axis, LEAST_ERROR, error_label, label};
use super::chart::{self, Side};
use super::legend::{self, Mark};
use super::{Figure, INK, TITLE, color};
use crate::Result;
use crate::modes;
use crate::sweep::Point;

const SIZE: (u32, u32) = (1280, 1230);
const HEAD: u32 = 70;
const LEGEND: u32 = 100;
/// The height of the panel of costs, including the name of the axis.
const COST: u32 = 490;

/// The plot of a sweep.
pub struct Curves<'a> {
    pub title: &'a str,
    /// The name of the horizontal axis.
    pub axis: &'a str,
    /// Whether the labels of the axis are the numbers of the steps.
    pub stepped: bool,
    pub points: &'a [Point],
}

/// The content of a panel.
struct Panel<'a> {
    /// The name of the horizontal axis. The name is empty in the upper panel, because the lower panel shows the shared
    /// axis.
    along: &'a str,
    up: Side<'a>,
    lines: Vec<Line>,
}

/// A line of a panel.
struct Line {
    mode: &'static str,
    dashed: bool,
    points: Vec<(f64, f64)>,
}

impl Curves<'_> {
    /// Makes a line for each mode.
    fn lines(&self, dashed: bool, value: impl Fn(&Point) -> Option<f64>) -> Vec<Line> {
        let line = |&mode: &&'static str| {
            let points = self.points.iter().filter(|point| point.mode == mode);
            Line {
                mode,
                dashed,
                points: points
                    .filter_map(|point| Some((point.at, value(point)?)))
                    .collect(),
            }
        };
        modes::NAMES.iter().map(line).collect()
    }

    /// Draws a panel in a part of the paper.
    fn panel<DB: DrawingBackend>(
        &self,
        paper: &DrawingArea<DB, Shift>,
        part: &DrawingArea<DB, Shift>,
        panel: Panel<'_>,
    ) -> Result<()>
    where
        DB::ErrorType: 'static,
    {
        let Panel { along, up, lines } = panel;
        let steps = self.points.iter().map(|point| point.at);
        let horizontal = if self.stepped {
            Axis::at(steps)
        } else {
            Axis::around(steps)
        };
        let below = if along.is_empty() { 40 } else { 84 };
        let across = Side {
            axis: horizontal,
            name: along,
            label_of: label,
        };
        let mut chart = chart::draw(
            ChartBuilder::on(part)
                .margin_left(20)
                .margin_right(50)
                .margin_top(14),
            below,
            across,
            up,
        )?;
        for line in lines {
            let color = color(line.mode);
            let points = || line.points.iter().copied();
            if line.dashed {
                chart.draw_series(DashedLineSeries::new(
                    points(),
                    10,
                    7,
                    color.stroke_width(2),
                ))?;
            } else {
                chart.draw_series(LineSeries::new(points(), color.stroke_width(3)))?;
                for point in points() {
                    Mark::Circle.draw(paper, chart.backend_coord(&point), color)?;
                }
            }
        }
        Ok(())
    }
}

impl Figure for Curves<'_> {
    fn size(&self) -> (u32, u32) {
        SIZE
    }

    fn draw<DB: DrawingBackend>(&self, paper: &DrawingArea<DB, Shift>) -> Result<()>
    where
        DB::ErrorType: 'static,
    {
        let title = TITLE.into_font().color(&INK);
        let (above, below) = paper.split_vertically(SIZE.1 - LEGEND);
        let (panels, costs) = above.split_vertically(SIZE.1 - LEGEND - COST);
        let (head, errors) = panels.split_vertically(HEAD);
        head.draw_text(self.title, &title, (40, 24))?;

        let shown = |error: f64| error.max(LEAST_ERROR);
        let mut lines = self.lines(false, |point| Some(shown(point.error?.max)));
        lines.extend(self.lines(true, |point| Some(shown(point.error?.mean))));
        let all = lines.iter().flat_map(|line| &line.points);
        let axis = Axis::decades(all.map(|(_, error)| *error));
        let panel = Panel {
            along: "",
            up: Side {
                axis,
                name: "texel error (texels)",
                label_of: error_label,
            },
            lines,
        };
        self.panel(paper, &errors, panel)?;

        let lines = self.lines(false, |point| Some(point.ns_per_pixel));
        let axis = Axis::around(self.points.iter().map(|point| point.ns_per_pixel));
        let panel = Panel {
            along: self.axis,
            up: Side {
                axis,
                name: "ns per pixel (this computer)",
                label_of: label,
            },
            lines,
        };
        self.panel(paper, &costs, panel)?;

        let of_mode = |name: &&str| (Mark::Circle, color(name), (*name).to_owned());
        let entries = modes::NAMES.iter().map(of_mode).collect();
        let lines = vec![
            (Mark::Line, INK, "largest error, cost".into()),
            (Mark::Dashes, INK, "mean error".into()),
        ];
        legend::draw(&below, &[entries, lines])
    }
}
