//! The build script of programs for emulated boards. The script links these programs with the runtime crate's linker
//! script and memory.x, and writes the model that `kernels` draws.
//!
//! The linker's arguments are not in .cargo/config.toml, because the settings there also hold for the project in
//! boards/. The chips of that project have their own memories and linker scripts.

use std::collections::{HashMap, HashSet};
use std::env::var;
use std::f64::consts::TAU;
use std::fmt::Write as _;
use std::fs;
use std::path::Path;

fn main() {
    println!("cargo::rerun-if-changed=../../memory.x");
    if var("CARGO_CFG_TARGET_OS").is_ok_and(|os| os == "none") {
        if var("CARGO_CFG_TARGET_ARCH").is_ok_and(|arch| arch == "riscv32") {
            println!("cargo::rustc-link-arg-bins=-Tmemory.x");
        }
        println!("cargo::rustc-link-arg-bins=-Tlink.x");
    }
    let folder = var("OUT_DIR").unwrap_or_default();
    // The macro looks for a model beside the file in which it is called.
    let program = "static WREATH: Mesh = include_mesh!(\"wreath.obj\", normals);";
    for (name, text) in [("wreath.obj", &*wreath()), ("wreath.rs", program)] {
        if let Err(error) = fs::write(Path::new(&folder).join(name), text) {
            println!("cargo::error={name}: {error}");
        }
    }
}

/// The number of quads around the wreath, and around its tube.
const QUADS: [u32; 2] = [72, 40];

/// A bumpy ring of 5,760 triangles, with a texture that repeats three times.
///
/// The faces have the order of a modeling program. The quads of the coarse mesh are in scattered order. It is subdivided
/// twice: each time, new vertices are appended, and four quads take the place of one.
fn wreath() -> String {
    let [around, along] = QUADS;
    let mut quads: Vec<[u32; 2]> = (0..around * along)
        .map(|at| [at / along, at % along])
        .collect();
    // 77 has no common divisor with the number of coarse quads, 180.
    let coarse = |[i, j]: [u32; 2]| (i / 4 * (along / 4) + j / 4) * 77 % (around * along / 16);
    quads.sort_by_key(|&[i, j]| (coarse([i, j]), i / 2, j / 2, i, j));
    let corners = |&[i, j]: &[u32; 2]| [[i, j], [i, j + 1], [i + 1, j + 1], [i + 1, j]];
    let closed = |[i, j]: [u32; 2]| [i % around, j % along];
    let mut points: Vec<_> = quads.iter().flat_map(corners).map(closed).collect();
    points.sort_by_key(|[i, j]| 2_u32.saturating_sub((i | j).trailing_zeros()));
    let mut seen = HashSet::new();
    points.retain(|&point| seen.insert(point));
    let numbers: HashMap<_, _> = points.iter().copied().zip(1..).collect();

    let mut text = String::new();
    for at in points {
        let [x, y, z] = place(at);
        _ = writeln!(text, "v {x:.6} {y:.6} {z:.6}");
    }
    for at in 0..(around + 1) * (along + 1) {
        let [u, v] = [at / (along + 1) * 3, at % (along + 1)].map(f64::from);
        _ = writeln!(
            text,
            "vt {:.6} {:.6}",
            u / f64::from(around),
            v / f64::from(along)
        );
    }
    for quad in quads {
        let corner = |at: [u32; 2]| {
            let uv = at[0] * (along + 1) + at[1] + 1;
            format!("{}/{uv}", numbers[&closed(at)])
        };
        _ = writeln!(text, "f {}", corners(&quad).map(corner).join(" "));
    }
    text
}

fn place([i, j]: [u32; 2]) -> [f64; 3] {
    let (turn, way) = (
        TAU / f64::from(QUADS[0]) * f64::from(i),
        TAU / f64::from(QUADS[1]) * f64::from(j),
    );
    let tube = 0.3 + 0.05 * (5.0 * turn + way).sin() + 0.05 * (9.0 * turn).sin();
    let radius = 0.7 + tube * way.cos();
    [radius * turn.cos(), radius * turn.sin(), tube * way.sin()]
}
