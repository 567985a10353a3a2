//! A sweep: error above, cost below, along the same axis.

use plotters::coord::Shift;
use plotters::prelude::*;

use super::axis::{Axis, LEAST_ERROR, label};
use super::legend::{self, Mark};
use super::{FONT, Figure, GRID, INK, color};
use crate::Result;
use crate::modes;
use crate::sweep::Point;

const SIZE: (u32, u32) = (840, 760);
const TITLE: u32 = 44;
const LEGEND: u32 = 36;
const COST: u32 = 300;

/// The plot of a sweep.
pub struct Curves<'a> {
    pub title: &'a str,
    /// What is along the horizontal axis.
    pub axis: &'a str,
    pub points: &'a [Point],
}

/// A line of a panel.
struct Line {
    mode: &'static str,
    dashed: bool,
    points: Vec<(f64, f64)>,
}

impl Curves<'_> {
    /// A line for each mode.
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

    /// A panel: what is written along its vertical axis, and its lines.
    fn panel<DB: DrawingBackend>(
        &self,
        paper: &DrawingArea<DB, Shift>,
        part: &DrawingArea<DB, Shift>,
        (name, axis): (&str, &Axis),
        lines: &[Line],
    ) -> Result<()>
    where
        DB::ErrorType: 'static,
    {
        let along = Axis::around(self.points.iter().map(|point| point.at));
        let mut chart = ChartBuilder::on(part)
            .margin_left(12)
            .margin_right(28)
            .margin_top(8)
            .x_label_area_size(48)
            .y_label_area_size(78)
            .build_cartesian_2d(
                (along.low..along.high)
                    .log_scale()
                    .with_key_points(along.ticks),
                (axis.low..axis.high)
                    .log_scale()
                    .with_key_points(axis.ticks.clone()),
            )?;
        chart
            .configure_mesh()
            .bold_line_style(GRID)
            .light_line_style(TRANSPARENT)
            .axis_style(INK)
            .label_style((FONT, 14).into_font().color(&INK))
            .axis_desc_style((FONT, 16).into_font().color(&INK))
            .x_desc(self.axis)
            .y_desc(name)
            .x_label_formatter(&label)
            .y_label_formatter(&label)
            .draw()?;
        for line in lines {
            let color = color(line.mode);
            let points = || line.points.iter().copied();
            if line.dashed {
                chart.draw_series(DashedLineSeries::new(points(), 6, 4, color.stroke_width(1)))?;
            } else {
                chart.draw_series(LineSeries::new(points(), color.stroke_width(2)))?;
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
        let title = (FONT, 20).into_font().color(&INK);
        let (above, below) = paper.split_vertically(SIZE.1 - LEGEND);
        let (panels, costs) = above.split_vertically(SIZE.1 - LEGEND - COST);
        let (head, errors) = panels.split_vertically(TITLE);
        head.draw_text(self.title, &title, (24, 14))?;

        let shown = |error: f64| error.max(LEAST_ERROR);
        let mut lines = self.lines(false, |point| Some(shown(point.error?.max)));
        lines.extend(self.lines(true, |point| Some(shown(point.error?.mean))));
        let all = lines.iter().flat_map(|line| &line.points);
        let axis = Axis::decades(all.map(|(_, error)| *error));
        self.panel(paper, &errors, ("texel error (texels)", &axis), &lines)?;

        let lines = self.lines(false, |point| Some(point.ns_per_pixel));
        let axis = Axis::around(self.points.iter().map(|point| point.ns_per_pixel));
        self.panel(
            paper,
            &costs,
            ("this computer: ns per pixel", &axis),
            &lines,
        )?;

        let of_mode = |name: &&str| (Mark::Circle, color(name), (*name).to_owned());
        let mut entries: Vec<_> = modes::NAMES.iter().map(of_mode).collect();
        entries.push((Mark::Line, INK, "largest error, cost".into()));
        entries.push((Mark::Dashes, INK, "mean error".into()));
        legend::draw(&below, &[entries])
    }
}
