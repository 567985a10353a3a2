//! Two logarithmic axes with their names, numbers and grid lines.

use plotters::coord::combinators::{LogCoord, WithKeyPoints};
use plotters::prelude::*;

use super::axis::Axis;
use super::{GRID, INK, LABEL, NAME};
use crate::Result;

/// A chart in which points can be drawn.
pub type Chart<'a, DB> = ChartContext<'a, DB, Cartesian2d<Scale, Scale>>;
type Scale = WithKeyPoints<LogCoord<f64>>;

/// An axis and its labels.
pub struct Side<'a> {
    pub axis: Axis,
    pub name: &'a str,
    /// Formats the number of a tick.
    pub label_of: fn(f64) -> String,
}

/// The width of the numbers and the name to the left of a chart.
const LEFT: u32 = 130;

/// Draws the axes of a chart, with margins. There are `below` pixels for the labels below the chart.
pub fn draw<'a, DB: DrawingBackend>(
    chart: &mut ChartBuilder<'a, '_, DB>,
    below: u32,
    across: Side<'_>,
    up: Side<'_>,
) -> Result<Chart<'a, DB>>
where
    DB::ErrorType: 'static,
{
    let scale = |axis: Axis| {
        let range = (axis.low..axis.high).log_scale();
        range.with_key_points(axis.ticks)
    };
    let mut chart = chart
        .x_label_area_size(below)
        .y_label_area_size(LEFT)
        .build_cartesian_2d(scale(across.axis), scale(up.axis))?;
    chart
        .configure_mesh()
        .bold_line_style(GRID.stroke_width(2))
        .light_line_style(TRANSPARENT)
        .axis_style(INK.stroke_width(2))
        .label_style(LABEL.into_font().color(&INK))
        .axis_desc_style(NAME.into_font().color(&INK))
        .x_desc(across.name)
        .y_desc(up.name)
        .x_label_formatter(&|&value| (across.label_of)(value))
        .y_label_formatter(&|&value| (up.label_of)(value))
        .draw()?;
    Ok(chart)
}
