//! The whole run: measures the cases, writes the results and plots them.

use std::collections::HashMap;
use std::fs;
use std::slice::IterMut;

use fixel::mode::Mode;
use indicatif::{ProgressBar, ProgressStyle};

use super::Result;
use super::args::Args;
use super::case::Case;
use super::firmware;
use super::measure::{Figures, Subject};
use super::modes::{self, Visitor};
use super::plot;
use super::sweep::{self, Point, Sweep};
use super::table::{self, HOST, Row};
use super::{measured, planes};

/// The repetitions are divided into this number of rounds.
const ROUNDS: u32 = 3;

/// The figures of a target other than the host.
struct Elsewhere {
    target: String,
    costs: Vec<firmware::Cost>,
    code: HashMap<String, u64>,
}

/// Runs everything that the command line asks for.
pub fn run(args: &Args) -> Result<()> {
    plot::fonts()?;
    if let Some(path) = &args.summary {
        return plot::save_png(path, &plot::Summary::read()?);
    }
    // Read the files before anything is measured, so that a mistake in a file wastes no time.
    let elsewhere = read(args)?;
    fs::create_dir_all(&args.out)?;
    let mut cases = measured::cases()?;
    cases.extend(planes::cases(args.planes())?);
    let sweeps = if args.no_sweeps {
        Vec::new()
    } else {
        sweep::sweeps(args.quick)?
    };

    let all = cases.iter().chain(sweeps.iter().flat_map(Sweep::cases));
    let mut figures = measure(&all.collect::<Vec<_>>(), args)?.into_iter();

    let mut rows = Vec::new();
    for (case, figures) in cases.iter().zip(&mut figures) {
        for figures in &figures {
            add_rows(&mut rows, case.name, figures, &elsewhere)?;
        }
    }
    // Rows are grouped by target. The host comes first.
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
    for sweep in &sweeps {
        let first = points.len();
        for ((at, _), figures) in sweep.cases.iter().zip(&mut figures) {
            points.extend(
                figures
                    .iter()
                    .map(|figures| Point::new(sweep.name, *at, figures)),
            );
        }
        swept.push((sweep, first..points.len()));
    }
    if !points.is_empty() {
        sweep::write_csv(&args.out.join("sweeps.csv"), &points)?;
    }

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

/// Reads the files that the command line names.
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
    if let Some(other) = all.iter().find(|other| other.costs.is_empty()) {
        let target = &other.target;
        return Err(format!("sizes of '{target}', and no --firmware to go with them").into());
    }
    if all.iter().any(|other| other.target == HOST) {
        return Err(format!("'{HOST}' is this computer: give the target another name").into());
    }
    Ok(all)
}

/// Measures cases in every mode. Returns the figures of each mode for each case.
///
/// The function first compares pictures. Then it measures time, in rounds over all cases and modes. So a temporary load
/// on the computer slows down only a few repetitions of each case, and the median ignores these.
fn measure(cases: &[&Case], args: &Args) -> Result<Vec<Vec<Figures>>> {
    let rounds = args.repeats().min(ROUNDS);
    let steps = cases.len() as u64 * u64::from(1 + rounds);
    let progress = ProgressBar::new(steps).with_style(ProgressStyle::with_template(
        "{bar:40} {pos}/{len} {msg} {elapsed}",
    )?);
    let mut all = Vec::new();
    for case in cases {
        progress.set_message(case.name);
        let mut looking = Looking {
            subject: Subject::new(case)?,
            figures: Vec::new(),
        };
        modes::each(&mut looking)?;
        all.push(looking.figures);
        progress.inc(1);
    }
    progress.set_message("time");
    for round in 0..rounds {
        let done = |rounds_done: u32| args.repeats() * rounds_done / rounds;
        for (case, figures) in cases.iter().zip(&mut all) {
            modes::each(&mut Timing {
                case,
                repeats: done(round + 1) - done(round),
                figures: figures.iter_mut(),
            })?;
            progress.inc(1);
        }
    }
    progress.finish_and_clear();
    Ok(all)
}

/// Code that compares a case with the model.
struct Looking<'a> {
    subject: Subject<'a>,
    figures: Vec<Figures>,
}

impl Visitor for Looking<'_> {
    fn visit<I: Mode>(&mut self, name: &'static str, mode: I) -> Result<()> {
        self.figures.push(self.subject.measure(name, mode)?);
        Ok(())
    }
}

/// Code that measures the time of a case in each mode in turn, and adds it to the mode's figures.
struct Timing<'a> {
    case: &'a Case,
    repeats: u32,
    figures: IterMut<'a, Figures>,
}

impl Visitor for Timing<'_> {
    fn visit<I: Mode>(&mut self, _: &'static str, mode: I) -> Result<()> {
        match self.figures.next() {
            Some(figures) => figures.times.add(self.case, mode, self.repeats),
            None => Ok(()),
        }
    }
}

/// Adds a row for the host, and a row for each other target that has drawn the same picture.
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
        per_frame: figures.times.ns() / figures.frames as f64,
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
        // Take the last cost, because a repeated measurement comes after earlier ones.
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
