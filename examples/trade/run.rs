//! The whole of it: measure, write, plot.

use std::collections::HashMap;
use std::fs;
use std::mem;

use fixel::interpolate::Interpolate;
use indicatif::{ProgressBar, ProgressStyle};

use super::Result;
use super::args::Args;
use super::firmware;
use super::measure::{Figures, Subject};
use super::modes::{self, Visitor};
use super::plot;
use super::sweep::{self, Point};
use super::table::{self, HOST, Row};
use super::{measured, planes};

/// What was measured on other targets, in the order given.
struct Elsewhere {
    target: String,
    costs: Vec<firmware::Cost>,
    code: HashMap<String, u64>,
}

/// Does everything that the command line asks for.
pub fn run(args: &Args) -> Result<()> {
    // Before anything is measured in vain.
    let elsewhere = read(args)?;
    fs::create_dir_all(&args.out)?;
    let mut cases = measured::cases()?;
    cases.extend(planes::cases(args.planes())?);
    let sweeps = if args.no_sweeps {
        Vec::new()
    } else {
        sweep::sweeps(args.quick)?
    };

    let steps = cases.len() + sweeps.iter().map(|sweep| sweep.cases.len()).sum::<usize>();
    let progress = ProgressBar::new((steps * modes::NAMES.len()) as u64).with_style(
        ProgressStyle::with_template("{bar:40} {pos}/{len} {msg} {elapsed}")?,
    );
    let mut rows = Vec::new();
    for case in cases {
        let scene = case.name;
        for figures in measure(Subject::new(case)?, args, &progress)? {
            add_rows(&mut rows, scene, &figures, &elsewhere)?;
        }
    }
    // Targets apart from each other, the host first.
    let rank = |row: &Row| {
        elsewhere
            .iter()
            .position(|other| other.target == row.target)
    };
    rows.sort_by_key(rank);
    table::write_csv(&args.out.join("trade.csv"), &rows)?;
    let text = table::markdown(&rows);
    fs::write(args.out.join("trade.md"), &text)?;

    let mut points = Vec::new();
    let mut swept = Vec::new();
    for mut sweep in sweeps {
        let first = points.len();
        for (at, case) in mem::take(&mut sweep.cases) {
            for figures in measure(Subject::new(case)?, args, &progress)? {
                points.push(Point::new(sweep.name, at, &figures));
            }
        }
        swept.push((sweep, first..points.len()));
    }
    progress.finish_and_clear();
    if !points.is_empty() {
        sweep::write_csv(&args.out.join("sweeps.csv"), &points)?;
    }

    plot::fonts()?;
    plot::save(&args.out.join("trade"), &plot::Scatter::new(&rows))?;
    for (sweep, range) in swept {
        let figure = plot::Curves {
            title: sweep.title,
            axis: sweep.axis,
            stepped: sweep.stepped,
            points: &points[range],
        };
        plot::save(&args.out.join(format!("sweep-{}", sweep.name)), &figure)?;
    }
    println!("{text}\nsaved in {}", args.out.display());
    Ok(())
}

/// What the command line names files of.
fn read(args: &Args) -> Result<Vec<Elsewhere>> {
    let mut all: Vec<Elsewhere> = Vec::new();
    let mut of = |target: &str| -> usize {
        all.iter()
            .position(|other| other.target == target)
            .unwrap_or_else(|| {
                all.push(Elsewhere {
                    target: target.into(),
                    costs: Vec::new(),
                    code: HashMap::new(),
                });
                all.len() - 1
            })
    };
    let places: Vec<usize> = args
        .firmware
        .iter()
        .chain(&args.sizes)
        .map(|named| of(&named.target))
        .collect();
    let (of_costs, of_sizes) = places.split_at(args.firmware.len());
    for (named, &place) in args.firmware.iter().zip(of_costs) {
        all[place].costs.extend(firmware::costs(named)?);
    }
    for (named, &place) in args.sizes.iter().zip(of_sizes) {
        all[place].code.extend(firmware::sizes(named)?);
    }
    if all.iter().any(|other| other.target == HOST) {
        return Err(format!("'{HOST}' is this computer: give the target another name").into());
    }
    Ok(all)
}

/// Measures a subject in every mode.
fn measure(subject: Subject, args: &Args, progress: &ProgressBar) -> Result<Vec<Figures>> {
    struct Measuring<'a> {
        subject: Subject,
        repeats: u32,
        progress: &'a ProgressBar,
        figures: Vec<Figures>,
    }
    impl Visitor for Measuring<'_> {
        fn visit<I: Interpolate>(&mut self, name: &'static str, mode: I) -> Result<()> {
            self.progress.set_message(self.subject.case.name);
            let figures = self.subject.measure(name, mode, self.repeats)?;
            self.figures.push(figures);
            self.progress.inc(1);
            Ok(())
        }
    }
    let mut measuring = Measuring {
        subject,
        repeats: args.repeats(),
        progress,
        figures: Vec::new(),
    };
    modes::each(&mut measuring)?;
    Ok(measuring.figures)
}

/// A row for the host, and one for each other target that has drawn the same.
fn add_rows(
    rows: &mut Vec<Row>,
    scene: &'static str,
    figures: &Figures,
    elsewhere: &[Elsewhere],
) -> Result<()> {
    let mode = figures.mode;
    let host = Row {
        scene,
        mode,
        target: HOST.into(),
        per_frame: figures.ns / figures.frames as f64,
        per_pixel: figures.ns_per_pixel(),
        error: figures.error,
        psnr: figures.psnr,
        code: None,
    };
    rows.push(host.clone());
    for Elsewhere {
        target,
        costs,
        code,
    } in elsewhere
    {
        // The last, as one that was measured again is after those before.
        let mut costs = costs.iter().rev();
        let Some(cost) = costs.find(|cost| cost.scene == scene && cost.mode == mode) else {
            continue;
        };
        if cost.crc.is_some_and(|crc| crc != figures.crc) {
            return Err(format!(
                "{target} drew another picture of {scene} in mode {mode}: its figures are of another version, \
                 run its firmware again"
            )
            .into());
        }
        rows.push(Row {
            target: target.clone(),
            per_frame: cost.instructions as f64,
            per_pixel: cost.instructions as f64 / cost.pixels as f64,
            code: code.get(mode).copied(),
            ..host.clone()
        });
    }
    Ok(())
}
