//! Runs the measurement of modes as a user does, and checks its output.
#![cfg(not(target_os = "none"))]

use std::collections::HashMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// Runs the program in an empty directory, and returns the directory.
fn run(test: &str, arguments: &[&str]) -> PathBuf {
    let directory = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("trade-{test}"));
    let _ = fs::remove_dir_all(&directory);
    fs::create_dir_all(&directory).unwrap();
    let mut command = Command::new(env!("CARGO_BIN_EXE_trade"));
    let output = command.args(arguments).current_dir(&directory).output();
    let output = output.unwrap();
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{errors}");
    directory
}

/// A file of the repository.
fn kept(file: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../..")
        .join(file)
}

/// The bound of the error of the modes that are exact in perspective, in texels.
fn promised(scene: &str) -> f64 {
    if scene == "planes-deep" {
        // At 1 : 1000, the farthest 1/w has 2^30 / 1000 units, with an error of up to 56.5 (tests/support/bounds.rs).
        // Attributes of corners are below 2^24 and shifted by 26 bits, in units of 2^-16 texel.
        56.5 * 1000. / 2_f64.powi(30) * 2_f64.powi(26 - 16)
    } else {
        0.001
    }
}

#[test]
fn scenes_are_measured_in_every_mode() {
    let out = run("scenes", &["--quick"]).join("target/trade");
    let text = fs::read_to_string(out.join("trade.csv")).unwrap();
    let (head, rows) = text.split_once('\n').unwrap();
    assert_eq!(
        head,
        "scene,mode,texel_error_max,texel_error_mean,thumbv7em-none-eabi,thumbv6m-none-eabi"
    );
    let rows = rows.lines().map(|line| {
        let [scene, mode, max, mean, m4, m0] =
            line.split(',').collect::<Vec<_>>().try_into().unwrap();
        let [max, mean]: [f64; 2] = [max, mean].map(|error| error.parse().unwrap());
        ((scene, mode), (max, mean, [m4, m0]))
    });
    let mut rows: HashMap<_, _> = rows.collect();
    let table = fs::read_to_string(out.join("trade.md")).unwrap();
    assert_eq!(table.lines().count(), 2 + rows.len());
    assert!(table.contains("| floor | exact | 0.000016 |"), "{table}");

    for scene in [
        "floor",
        "cube",
        "sphere",
        "wall",
        "planes-tilted",
        "planes-grazing",
        "planes-slivers",
        "planes-deep",
    ] {
        for mode in ["exact", "newton", "narrow", "fast", "affine"] {
            let (max, mean, costs) = rows.remove(&(scene, mode)).expect(scene);
            assert!(mean > 0. && max >= mean, "{scene} {mode}: {max} {mean}");
            match mode {
                // The tolerance, and the 1/32 that every `Fast` adds.
                "fast" => assert!(max <= 0.25 + 1. / 32., "{scene}: {max}"),
                "affine" => assert!(max > 0.1, "{scene}: {max}"),
                // A small triangle may have a further error of 1/32 texel.
                "newton" => assert!(max <= promised(scene) + 1. / 32., "{scene}: {max}"),
                _ => assert!(max <= promised(scene), "{scene} {mode}: {max}"),
            }
            let is_counted = ["floor", "cube", "sphere"].contains(&scene) && mode != "narrow";
            if is_counted {
                let [m4, m0] = costs.map(|count| count.parse::<u32>().unwrap());
                assert!(m4 < m0, "{scene} {mode}: {m4} {m0}");
            } else {
                assert_eq!(costs, [""; 2], "{scene} {mode}");
            }
            if (scene, mode) == ("wall", "affine") {
                // The guide's page of modes derives 256 · (√2 − 1) / (√2 + 1) texels. The nearest center of a pixel is
                // half a pixel from there, where the error is smaller by 0.0005. The table's four digits add 0.005.
                assert!((max - 43.923).abs() < 0.006, "{max}");
            }
        }
    }
    assert!(rows.is_empty(), "{rows:?}");

    // The pages say what was measured: tests/figures.csv has the same errors, to four digits.
    let figures = fs::read_to_string(kept("tests/figures.csv")).unwrap();
    let lines = text.lines().filter(|line| !line.starts_with("planes"));
    for line in lines.skip(1) {
        let [scene, mode, max, mean, ..] = line.split(',').collect::<Vec<_>>()[..] else {
            panic!("{line}");
        };
        for (kind, error) in [("max", max), ("mean", mean)] {
            let name = format!("\nerrors,{scene} {mode} error {kind},");
            let (_, figure) = figures.split_once(&name).expect(&name);
            let figure = figure.lines().next().unwrap();
            let [error, figure] = [error, figure].map(|text| text.parse::<f64>().unwrap());
            assert!(
                (error / figure - 1.).abs() < 0.001,
                "{name}{figure} is now {error}: .ci/figures errors"
            );
        }
    }
}
