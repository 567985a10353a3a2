//! Runs the measurement of modes as a user does, with few planes, and checks its output.
#![cfg(not(target_os = "none"))]

use std::collections::HashMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// Options for few planes, each of which is measured once.
const LITTLE: &str = "--quick --planes 3 --repeats 1";
const SCENES: [&str; 8] = [
    "floor",
    "cube",
    "sphere",
    "sphere-flat",
    "planes-tilted",
    "planes-grazing",
    "planes-slivers",
    "planes-deep",
];

/// The values of a row, by the names of their columns.
type Row = HashMap<String, String>;

/// Makes an empty directory for a test.
fn directory(test: &str) -> PathBuf {
    let directory = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("trade-{test}"));
    let _ = fs::remove_dir_all(&directory);
    fs::create_dir_all(&directory).unwrap();
    directory
}

/// Runs the program.
fn run(directory: &Path, arguments: &str) -> Output {
    Command::new(env!("CARGO_BIN_EXE_trade"))
        .args(LITTLE.split_whitespace())
        .args(arguments.split_whitespace())
        .current_dir(directory)
        .output()
        .unwrap()
}

/// Runs the program, which must succeed. Returns the folder of its output, target/trade in the directory.
fn good(directory: &Path, arguments: &str) -> PathBuf {
    let output = run(directory, arguments);
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{arguments}: {errors}");
    directory.join("target").join("trade")
}

/// Runs the program, which must refuse its arguments with a message that contains `says`.
fn refused(directory: &Path, arguments: &str, says: &str) {
    let output = run(directory, arguments);
    let message = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{arguments}: {message}");
    assert!(
        message.contains(says),
        "{arguments}: no '{says}' in: {message}"
    );
}

/// Returns the rows of a CSV. The CSV must have these columns.
fn rows(file: &Path, columns: &str) -> Vec<Row> {
    let mut reader = csv::Reader::from_path(file).unwrap();
    let header: Vec<&str> = columns.split(' ').collect();
    assert_eq!(reader.headers().unwrap(), header, "{}", file.display());
    reader.deserialize().collect::<Result<_, _>>().unwrap()
}

fn trade(out: &Path) -> Vec<Row> {
    rows(
        &out.join("trade.csv"),
        "scene mode target unit cost_per_frame cost_per_pixel texel_error_max texel_error_p99 \
         texel_error_mean psnr_db code_bytes",
    )
}

#[track_caller]
fn number(row: &Row, column: &str) -> f64 {
    let text = &row[column];
    let value: f64 = text
        .parse()
        .unwrap_or_else(|_| panic!("{column} is '{text}'"));
    assert!(value >= 0., "{column} is {text}");
    value
}

/// Checks that a plot exists as PNG and as SVG, and that both contain the colors of the most and the least exact mode.
fn assert_plot(out: &Path, stem: &str) {
    let svg = fs::read_to_string(out.join(format!("{stem}.svg"))).unwrap();
    let picture = image::open(out.join(format!("{stem}.png")))
        .unwrap()
        .to_rgb8();
    for (mode, color) in [("exact", [0, 114, 178]), ("affine", [213, 94, 0])] {
        let [r, g, b] = color;
        assert!(
            svg.contains(mode) && svg.contains(&format!("#{r:02X}{g:02X}{b:02X}")),
            "{stem}.svg has no {mode}"
        );
        let pixels = picture.pixels().filter(|pixel| pixel.0 == color).count();
        assert!(pixels > 500, "{stem}.png has {pixels} pixels of {mode}");
    }
}

/// Returns the bound of the texel error in a scene.
fn promised(scene: &str) -> f64 {
    if scene == "planes-deep" {
        // At 1 : 1000, the farthest 1/w has 2^30 / 1000 units, with an error of up to 56.5 (tests/accuracy/bounds.rs).
        // Attributes of corners are below 2^24 and shifted by 26 bits, in units of 2^-16 texel.
        56.5 * 1000. / 2_f64.powi(30) * 2_f64.powi(26 - 16)
    } else {
        0.001
    }
}

#[test]
fn scenes_are_measured_in_every_mode() {
    let out = good(&directory("scenes"), "--no-sweeps");
    let rows = trade(&out);
    let of = |mode: &str| -> Vec<&Row> { rows.iter().filter(|row| row["mode"] == mode).collect() };
    for mode in ["exact", "affine"] {
        let scenes: Vec<&str> = of(mode).iter().map(|row| row["scene"].as_str()).collect();
        assert_eq!(scenes, SCENES, "{mode}");
    }
    for row in &rows {
        let (scene, mode) = (row["scene"].as_str(), row["mode"].as_str());
        assert_eq!(
            (row["target"].as_str(), row["unit"].as_str()),
            ("host", "ns")
        );
        assert_eq!(row["code_bytes"], "");
        assert!(number(row, "cost_per_pixel") < number(row, "cost_per_frame"));
        let psnr = number(row, "psnr_db");
        let errors = ["max", "p99", "mean"].map(|part| format!("texel_error_{part}"));
        if scene == "sphere-flat" {
            // No attribute is interpolated, so the picture equals the model's picture.
            assert!(psnr.is_infinite() && errors.iter().all(|column| row[column].is_empty()));
            continue;
        }
        let [max, p99, mean] = errors.map(|column| number(row, &column));
        assert!(max >= p99 && max >= mean, "{scene} {mode}");
        match mode {
            "exact" => assert!(
                max <= promised(scene) && psnr > 50.,
                "{scene}: {max} {psnr}"
            ),
            "affine" => assert!(max > 0.1 && psnr < 60., "{scene}: {max} {psnr}"),
            _ => {}
        }
    }
    let table = fs::read_to_string(out.join("trade.md")).unwrap();
    assert_eq!(table.lines().count(), 2 + rows.len());
    assert_plot(&out, "trade");
}

#[test]
fn sweeps_write_their_steps_in_order_and_a_plot() {
    let out = good(&directory("sweeps"), "");
    let rows = rows(
        &out.join("sweeps.csv"),
        "sweep at mode host_ns_per_pixel texel_error_max texel_error_p99 texel_error_mean",
    );
    for sweep in ["depth-ratio", "slope", "texture", "resolution"] {
        for mode in ["exact", "affine"] {
            let line = rows
                .iter()
                .filter(|row| row["sweep"] == sweep && row["mode"] == mode);
            let steps: Vec<f64> = line.map(|row| number(row, "at")).collect();
            assert!(
                steps.len() >= 3 && steps.is_sorted(),
                "{sweep} {mode}: {steps:?}"
            );
        }
        assert_plot(&out, &format!("sweep-{sweep}"));
    }
    assert!(rows.iter().all(|row| number(row, "host_ns_per_pixel") > 0.));
}

#[test]
fn figures_of_other_targets_are_added() {
    let directory = directory("targets");
    let write = |name: &str, text: &str| fs::write(directory.join(name), text).unwrap();
    write(
        "thumbv8m.main.txt",
        "tick=40 instructions\n\
         scene=floor mode=exact layout=frame pixels=47610 triangles=2 ticks=75000 crc=cea20ac4\n\
         scene=floor mode=exact layout=frame stack=2892\n\
         scene=floor mode=exact layout=bands pixels=47610 triangles=20 ticks=78388 crc=cea20ac4\n\
         scene=default mode=exact layout=frame pixels=9 triangles=1 ticks=9 crc=00000000\n",
    );
    write("sizes", "exact, 12345\naffine, 99\n");
    let out = good(
        &directory,
        "--no-sweeps --firmware thumbv8m.main.txt --sizes thumbv8m.main=sizes",
    );
    let rows = trade(&out);
    let elsewhere: Vec<&Row> = rows.iter().filter(|row| row["target"] != "host").collect();
    let [row] = elsewhere[..] else {
        panic!("{elsewhere:?}");
    };
    assert_eq!(row["target"], "thumbv8m.main");
    assert_eq!(
        (row["scene"].as_str(), row["unit"].as_str()),
        ("floor", "instructions")
    );
    assert_eq!(row["cost_per_frame"], "3000000");
    assert!((number(row, "cost_per_pixel") - 75000. * 40. / 47610.).abs() < 0.001);
    assert_eq!(row["code_bytes"], "12345");
    let table = fs::read_to_string(out.join("trade.md")).unwrap();
    assert!(table.contains(" 3.00 | 63.0 | 12345 |"), "{table}");

    write(
        "stale",
        "tick=40 instructions\n\
         scene=floor mode=exact layout=frame pixels=47610 triangles=2 ticks=75000 crc=00000001\n",
    );
    write("empty", "tick=40 instructions\n");
    write(
        "tickless",
        "scene=floor mode=exact layout=frame pixels=1 triangles=2 ticks=3 crc=0\n",
    );
    let refused = |arguments: &str, says: &str| refused(&directory, arguments, says);
    refused("--no-sweeps --firmware stale", "another picture of floor");
    refused("--firmware empty", "empty: no line");
    refused("--firmware tickless", "must come first");
    refused("--firmware missing", "missing: ");
    refused("--sizes stale", "stale: ");
    refused("--sizes sizes", "no --firmware");
    refused("--firmware host=stale", "another name");
}
