//! Texel error against cost: a point for each scene and mode, in panels.

use plotters::coord::Shift;
use plotters::prelude::*;

use super::axis::{Axis, LEAST_ERROR, error_label, label};
use super::chart::{self, Side};
use super::legend::{self, Mark};
use super::{Figure, INK, TITLE, color};
use crate::Result;
use crate::modes;
use crate::spread::Spread;
use crate::table::{HOST, Row, unit};

/// The width and height of a panel.
const PANEL: (u32, u32) = (880, 720);
const LEGEND: u32 = 136;
/// The color of the line through the modes of a scene that no other mode beats both in cost and in error.
const THREAD: RGBColor = RGBColor(195, 195, 195);

/// The plot. There is a panel for the measured scenes on each target, and a panel for the planes on the host.
pub struct Scatter<'a> {
    panels: Vec<Panel<'a>>,
    scenes: Vec<&'static str>,
}

struct Panel<'a> {
    title: String,
    target: &'a str,
    points: Vec<(&'a Row, Spread)>,
}

impl<'a> Scatter<'a> {
    /// Makes the plot of all rows that have an error.
    pub fn new(rows: &'a [Row]) -> Self {
        let mut panels: Vec<Panel> = Vec::new();
        let mut scenes = Vec::new();
        for row in rows {
            let Some(error) = row.error else { continue };
            if !scenes.contains(&row.scene) {
                scenes.push(row.scene);
            }
            let what = if row.scene.starts_with("planes") {
                "planes"
            } else {
                "scenes"
            };
            let target = if row.target == HOST {
                format!("this computer ({})", std::env::consts::ARCH)
            } else {
                row.target.clone()
            };
            let title = format!("{what} on {target}");
            let place = panels.iter().position(|panel| panel.title == title);
            let place = place.unwrap_or_else(|| {
                panels.push(Panel {
                    title,
                    target: &row.target,
                    points: Vec::new(),
                });
                panels.len() - 1
            });
            panels[place].points.push((row, error));
        }
        Self { panels, scenes }
    }

    fn mark(&self, scene: &str) -> Mark {
        let place = self.scenes.iter().position(|other| *other == scene);
        Mark::POINTS[place.unwrap_or(0) % Mark::POINTS.len()]
    }

    /// Returns the number of columns and rows of panels.
    fn grid(&self) -> (u32, u32) {
        let rows = self.panels.len().div_ceil(2).max(1);
        (2, u32::try_from(rows).unwrap_or(1))
    }

    /// Draws a panel in a part of the paper.
    fn panel<DB: DrawingBackend>(
        &self,
        paper: &DrawingArea<DB, Shift>,
        part: &DrawingArea<DB, Shift>,
        panel: &Panel<'_>,
        errors: &Axis,
    ) -> Result<()>
    where
        DB::ErrorType: 'static,
    {
        let costs = Axis::around(panel.points.iter().map(|(row, _)| row.per_pixel));
        let across = Side {
            axis: costs,
            name: &format!("{} per pixel", unit(panel.target)),
            label_of: label,
        };
        let up = Side {
            axis: errors.clone(),
            name: "largest texel error (texture of 256x256)",
            label_of: error_label,
        };
        let mut chart = chart::draw(
            ChartBuilder::on(part)
                .caption(&panel.title, TITLE.into_font().color(&INK))
                .margin(20),
            76,
            across,
            up,
        )?;
        for scene in &self.scenes {
            let mut line: Vec<(f64, f64)> = panel
                .points
                .iter()
                .filter(|(row, _)| row.scene == *scene)
                .map(|(row, error)| (row.per_pixel, error.max.max(LEAST_ERROR)))
                .collect();
            line.sort_by(|a, b| a.0.total_cmp(&b.0));
            let mut least = f64::INFINITY;
            line.retain(|&(_, error)| {
                let better = error < least;
                least = least.min(error);
                better
            });
            chart.draw_series(LineSeries::new(line, THREAD.stroke_width(2)))?;
        }
        let at =
            |row: &Row, error: f64| chart.backend_coord(&(row.per_pixel, error.max(LEAST_ERROR)));
        for (row, error) in &panel.points {
            let color = color(row.mode).stroke_width(2);
            let line = |ends: [(i32, i32); 2]| paper.draw(&PathElement::new(ends, color));
            let (p99, mean) = (at(row, error.p99), at(row, error.mean));
            line([at(row, error.max), mean])?;
            for (x, y) in [p99, mean] {
                line([(x - 6, y), (x + 6, y)])?;
            }
        }
        // Draw the points last, over all lines.
        for (row, error) in &panel.points {
            let mark = self.mark(row.scene);
            mark.draw(paper, at(row, error.max), color(row.mode))?;
        }
        Ok(())
    }
}

impl Figure for Scatter<'_> {
    fn size(&self) -> (u32, u32) {
        let (columns, rows) = self.grid();
        (PANEL.0 * columns, PANEL.1 * rows + LEGEND)
    }

    fn draw<DB: DrawingBackend>(&self, paper: &DrawingArea<DB, Shift>) -> Result<()>
    where
        DB::ErrorType: 'static,
    {
        let points = self.panels.iter().flat_map(|panel| &panel.points);
        let errors = points.flat_map(|(_, error)| [error.max, error.mean]);
        let errors = Axis::decades(errors.map(|error| error.max(LEAST_ERROR)));
        let (panels, below) = paper.split_vertically(self.size().1 - LEGEND);
        let (columns, rows) = self.grid();
        let parts = panels.split_evenly((rows as usize, columns as usize));
        for (panel, part) in self.panels.iter().zip(&parts) {
            self.panel(paper, part, panel, &errors)?;
        }
        let of_mode = |name: &&str| (Mark::Square, color(name), (*name).to_owned());
        let of_scene = |name: &&str| (self.mark(name), INK, (*name).to_owned());
        legend::draw(
            &below,
            &[
                modes::NAMES.iter().map(of_mode).collect(),
                self.scenes.iter().map(of_scene).collect(),
                vec![
                    (Mark::Reach, INK, "99 % of the pixels, the mean".into()),
                    (
                        Mark::Line,
                        THREAD,
                        "no mode is both cheaper and more exact".into(),
                    ),
                ],
            ],
        )
    }
}
