//! Sweeps. Each sweep varies one property of a wall.
//!
//! The wall fills the frame and shows a texture once. The frame has 320x240 pixels, except if the sweep varies the
//! resolution. One corner of the wall is the nearest, and the opposite corner is the farthest.

use std::path::Path;

use super::Result;
use super::case::{Case, Corner, FocalProjection, Shot, Triangles};
use super::measure::Figures;
use super::spread::Spread;
use super::surface::{Side, Surface};
use super::table::number;

/// A sweep of a property.
pub struct Sweep {
    /// The name in files and in the CSV.
    pub name: &'static str,
    /// The title of the plot.
    pub title: &'static str,
    /// The name of the plot's horizontal axis.
    pub axis: &'static str,
    /// Whether the labels of the axis are the numbers of the steps.
    pub stepped: bool,
    /// The cases, each with its position on the horizontal axis.
    pub cases: Vec<(f64, Case)>,
}

impl Sweep {
    pub fn cases(&self) -> impl Iterator<Item = &Case> {
        self.cases.iter().map(|(_, case)| case)
    }
}

/// The result of a step of a sweep in a mode.
#[derive(Clone, Debug)]
pub struct Point {
    pub sweep: &'static str,
    /// The position on the sweep's axis.
    pub at: f64,
    pub mode: &'static str,
    pub ns_per_pixel: f64,
    pub error: Option<Spread>,
}

impl Point {
    pub fn new(sweep: &'static str, at: f64, figures: &Figures) -> Self {
        Self {
            sweep,
            at,
            mode: figures.mode,
            ns_per_pixel: figures.ns_per_pixel(),
            error: figures.error,
        }
    }
}

/// Writes a row for each point.
pub fn write_csv(path: &Path, points: &[Point]) -> Result<()> {
    let mut out = csv::Writer::from_path(path)?;
    out.write_record([
        "sweep",
        "at",
        "mode",
        "host_ns_per_pixel",
        "texel_error_max",
        "texel_error_p99",
        "texel_error_mean",
    ])?;
    for point in points {
        let error = |figure: fn(&Spread) -> f64| {
            point
                .error
                .as_ref()
                .map(figure)
                .map_or(String::new(), number)
        };
        out.write_record([
            point.sweep.to_owned(),
            number(point.at),
            point.mode.to_owned(),
            format!("{:.3}", point.ns_per_pixel),
            error(|error| error.max),
            error(|error| error.p99),
            error(|error| error.mean),
        ])?;
    }
    Ok(out.flush()?)
}

/// The ratio of a wall's farthest distance to its nearest distance, except if the sweep varies the ratio.
const RATIO: f64 = 8.;
/// The size of the frame, except if the sweep varies the size.
const SIZE: (u32, u32) = (320, 240);

/// All sweeps. With `quick`, they have fewer steps.
pub fn sweeps(quick: bool) -> Result<Vec<Sweep>> {
    let pick = |all: &[f64]| -> Vec<f64> {
        let step = if quick { 3 } else { 1 };
        all.iter().copied().step_by(step).collect()
    };
    let ratios = pick(&[
        1.1, 1.25, 1.5, 2., 3., 4., 6., 8., 16., 32., 64., 128., 256., 512., 1000.,
    ]);
    let strips = pick(&[320., 160., 107., 80., 40., 27., 20., 10., 7., 5.]);
    let widths = pick(&[80., 112., 160., 224., 320., 448., 640., 896., 1280.]);
    let at = |all: Vec<f64>, case: &dyn Fn(f64) -> Result<(f64, Case)>| {
        all.into_iter().map(case).collect::<Result<Vec<_>>>()
    };
    Ok(vec![
        Sweep {
            name: "depth-ratio",
            title: "Depth ratio (a wall over 320x240 pixels)",
            axis: "farthest to nearest distance",
            stepped: false,
            cases: at(ratios, &|ratio| {
                Ok((ratio, case(SIZE, Side::T64, 8, wall(SIZE, ratio)?)?))
            })?,
        },
        Sweep {
            name: "slope",
            title: "Slope of 1/w (strips side by side, each from a distance to twice that)",
            axis: "relative change of 1/w per pixel at the far end",
            stepped: false,
            cases: at(strips, &|width| {
                Ok((1. / width, case(SIZE, Side::T64, 8, strips_of(width)?)?))
            })?,
        },
        Sweep {
            name: "texture",
            title: "Size of the texture (a wall over 320x240 pixels, depth ratio 8)",
            axis: "texels along the side of the texture",
            stepped: true,
            cases: Side::ALL
                .into_iter()
                .map(|side| {
                    let log2 = side.log2();
                    let case = case(SIZE, side, log2, wall(SIZE, RATIO)?)?;
                    Ok((f64::from(1 << log2), case))
                })
                .collect::<Result<_>>()?,
        },
        Sweep {
            name: "resolution",
            title: "Resolution (a wall over the frame of 4:3, depth ratio 8)",
            axis: "width of the frame in pixels",
            stepped: true,
            cases: at(widths, &|width| {
                let size = (width as u32, (width * 0.75) as u32);
                Ok((width, case(size, Side::T64, 8, wall(size, RATIO)?)?))
            })?,
        },
    ])
}

fn projection(size: (u32, u32)) -> FocalProjection {
    FocalProjection {
        focal: 0.625 * f64::from(size.0),
        size,
        near: 0.5,
        far: 4000.,
    }
}

fn case(size: (u32, u32), side: Side, texels_log2: u32, wall: Triangles) -> Result<Case> {
    Ok(Case {
        name: "sweep",
        size,
        surface: Surface::Texture(side),
        texels_log2,
        interpolates: true,
        shots: vec![Shot::of_triangles(wall, projection(size))?],
    })
}

/// A wall that fills the frame. The wall is nearest at the top left, and `ratio` times as far away at the bottom right.
/// Three quarters of the change of 1/w are along a row.
fn wall(size: (u32, u32), ratio: f64) -> Result<Triangles> {
    let [width, height] = [size.0, size.1].map(f64::from);
    let corner = |u: f64, v: f64| Corner {
        at: [u * width, v * height],
        w: 1. / (1. - (1. - 1. / ratio) * (0.75 * u + 0.25 * v)),
        uv: [u, v],
    };
    let mut wall = Triangles::default();
    let corners = [
        corner(0., 0.),
        corner(0., 1.),
        corner(1., 1.),
        corner(1., 0.),
    ];
    wall.add(projection(size), &corners)?;
    Ok(wall)
}

/// Strips from the top to the bottom, each `width` pixels wide. A strip is twice as far away at its right side as at
/// its left side, and shows the whole texture.
fn strips_of(width: f64) -> Result<Triangles> {
    let [right, bottom] = [SIZE.0, SIZE.1].map(f64::from);
    let mut strips = Triangles::default();
    let mut left = 0.;
    while left + width <= right {
        let corner = |u: f64, v: f64| Corner {
            at: [left + u * width, v * bottom],
            w: 1. + u,
            uv: [u, v],
        };
        let corners = [
            corner(0., 0.),
            corner(0., 1.),
            corner(1., 1.),
            corner(1., 0.),
        ];
        strips.add(projection(SIZE), &corners)?;
        left += width;
    }
    Ok(strips)
}
