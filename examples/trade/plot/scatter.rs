//! Texel error against cost: a panel for each target, a point for each scene and mode.

use plotters::coord::Shift;
use plotters::prelude::*;

use super::axis::{Axis, LEAST_ERROR, label};
use super::legend::{self, Mark};
use super::{FONT, Figure, GRID, INK, color};
use crate::Result;
use crate::modes;
use crate::spread::Spread;
use crate::table::{HOST, Row, unit};

/// Width of a panel.
const PANEL: u32 = 560;
const LEGEND: u32 = 60;

/// The plot.
pub struct Scatter<'a> {
    points: Vec<(&'a Row, Spread)>,
    targets: Vec<&'a str>,
    scenes: Vec<&'a str>,
}

impl<'a> Scatter<'a> {
    /// Of the rows that have an error.
    pub fn new(rows: &'a [Row]) -> Self {
        let points: Vec<_> = rows
            .iter()
            .filter_map(|row| Some((row, row.error?)))
            .collect();
        let (mut targets, mut scenes) = (Vec::new(), Vec::new());
        for (row, _) in &points {
            if !targets.contains(&row.target.as_str()) {
                targets.push(row.target.as_str());
            }
            if !scenes.contains(&row.scene) {
                scenes.push(row.scene);
            }
        }
        Self {
            points,
            targets,
            scenes,
        }
    }

    fn mark(&self, scene: &str) -> Mark {
        let place = self.scenes.iter().position(|other| *other == scene);
        Mark::POINTS[place.unwrap_or(0) % Mark::POINTS.len()]
    }

    /// A target's panel, on a part of the paper.
    fn panel<DB: DrawingBackend>(
        &self,
        paper: &DrawingArea<DB, Shift>,
        part: &DrawingArea<DB, Shift>,
        target: &str,
        errors: &Axis,
    ) -> Result<()>
    where
        DB::ErrorType: 'static,
    {
        let points = || self.points.iter().filter(|(row, _)| row.target == target);
        let costs = Axis::around(points().map(|(row, _)| row.per_pixel));
        let title = if target == HOST {
            "this computer".to_owned()
        } else {
            target.to_owned()
        };
        let mut chart = ChartBuilder::on(part)
            .caption(title, (FONT, 20).into_font().color(&INK))
            .margin(12)
            .x_label_area_size(48)
            .y_label_area_size(78)
            .build_cartesian_2d(
                (costs.low..costs.high)
                    .log_scale()
                    .with_key_points(costs.ticks),
                (errors.low..errors.high)
                    .log_scale()
                    .with_key_points(errors.ticks.clone()),
            )?;
        chart
            .configure_mesh()
            .bold_line_style(GRID)
            .light_line_style(TRANSPARENT)
            .axis_style(INK)
            .label_style((FONT, 14).into_font().color(&INK))
            .axis_desc_style((FONT, 16).into_font().color(&INK))
            .x_desc(format!("{} per pixel", unit(target)))
            .y_desc("texel error (texels of 256)")
            .x_label_formatter(&label)
            .y_label_formatter(&label)
            .draw()?;
        // A scene's points, from mode to mode.
        for scene in &self.scenes {
            let mut line: Vec<(f64, f64)> = points()
                .filter(|(row, _)| row.scene == *scene)
                .map(|(row, error)| (row.per_pixel, error.max.max(LEAST_ERROR)))
                .collect();
            line.sort_by(|a, b| a.0.total_cmp(&b.0));
            chart.draw_series(LineSeries::new(line, RGBColor(205, 205, 205)))?;
        }
        for (row, error) in points() {
            let color = color(row.mode);
            let at = |error: f64| chart.backend_coord(&(row.per_pixel, error.max(LEAST_ERROR)));
            let [max, p99, mean] = [error.max, error.p99, error.mean].map(at);
            let line = |ends: [(i32, i32); 2]| paper.draw(&PathElement::new(ends, color));
            line([max, mean])?;
            for (x, y) in [p99, mean] {
                line([(x - 4, y), (x + 4, y)])?;
            }
            self.mark(row.scene).draw(paper, max, color)?;
        }
        Ok(())
    }
}

impl Figure for Scatter<'_> {
    fn size(&self) -> (u32, u32) {
        let panels = self.targets.len().max(2) as u32;
        (PANEL * panels, 520 + LEGEND)
    }

    fn draw<DB: DrawingBackend>(&self, paper: &DrawingArea<DB, Shift>) -> Result<()>
    where
        DB::ErrorType: 'static,
    {
        let errors = self
            .points
            .iter()
            .flat_map(|(_, error)| [error.max, error.mean])
            .map(|error| error.max(LEAST_ERROR));
        let errors = Axis::decades(errors);
        let (panels, below) = paper.split_vertically(self.size().1 - LEGEND);
        let parts = panels.split_evenly((1, self.targets.len().max(1)));
        for (target, part) in self.targets.iter().zip(&parts) {
            self.panel(paper, part, target, &errors)?;
        }
        let of_mode = |name: &&str| (Mark::Square, color(name), (*name).to_owned());
        let of_scene = |name: &&str| (self.mark(name), INK, (*name).to_owned());
        let mut modes: Vec<_> = modes::NAMES.iter().map(of_mode).collect();
        modes.push((
            Mark::Line,
            INK,
            "down from the largest error: 99 % of pixels, mean".into(),
        ));
        legend::draw(&below, &[modes, self.scenes.iter().map(of_scene).collect()])
    }
}
