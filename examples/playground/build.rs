//! The build script: what the module and the server contain besides code.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::{env, fs, io};

use flate2::Compression;
use flate2::write::GzEncoder;

fn main() -> io::Result<()> {
    let out = PathBuf::from(env::var_os("OUT_DIR").unwrap_or_default());

    // The counts that estimates need, without the rest and the optimization level: a tenth of the file.
    let counts = "../../tests/instructions.csv";
    println!("cargo::rerun-if-changed={counts}");
    let lines = fs::read_to_string(counts)?;
    let lines: Vec<String> = lines.lines().filter_map(wanted).collect();
    fs::write(out.join("costs.csv"), lines.join("\n"))?;

    // The modules and the programs, if they were built before. A folder of this package is
    // …/target/release/build/playground-0/out.
    println!("cargo::rerun-if-env-changed=PLAYGROUND_MODULES");
    let modules = env::var_os("PLAYGROUND_MODULES")
        .map(PathBuf::from)
        .or_else(|| {
            let target = out.ancestors().nth(4)?;
            Some(target.join("wasm32-unknown-unknown/release"))
        });
    // What reads and writes files is built for its size, and the last two for boards.
    for (path, name) in [
        ("playground.wasm", "playground.wasm"),
        ("world.wasm", "world.wasm"),
        ("display.wasm", "display.wasm"),
        ("../size/reader.wasm", "reader.wasm"),
        ("../size/animation.wasm", "animation.wasm"),
        ("../../thumbv6m-none-eabi/release/pico_model", "pico_model"),
        (
            "../../thumbv8m.main-none-eabihf/release/pico_model",
            "pico2_model",
        ),
    ] {
        let module = modules
            .as_ref()
            .map(|modules| modules.join(path))
            .unwrap_or_default();
        println!("cargo::rerun-if-changed={}", module.display());
        pack(&module, &out.join(format!("{name}.gz")))?;
    }

    // The emulator, if npm made it. Cargo watches its folder, which always exists. If Cargo watched the file, a missing
    // file would cause a new build every time.
    let emulator = "../boards/emulator";
    println!("cargo::rerun-if-changed={emulator}");
    let script = format!("{emulator}/dist/emulator.js");
    pack(Path::new(&script), &out.join("emulator.js.gz"))?;
    Ok(())
}

/// Compresses a file; if it is missing, the result is empty.
fn pack(from: &Path, to: &Path) -> io::Result<()> {
    let mut file = fs::File::create(to)?;
    if let Ok(bytes) = fs::read(from) {
        let mut packed = GzEncoder::new(file, Compression::best());
        packed.write_all(&bytes)?;
        file = packed.finish()?;
    }
    file.flush()
}

/// A line that counts frames, or a loop that estimates need, on one of the two cores.
fn wanted(line: &str) -> Option<String> {
    let fields: Vec<&str> = line.split(',').collect();
    let [core, "3", mode, what, per, count] = fields[..] else {
        return None;
    };
    let is_core = ["thumbv6m-none-eabi", "thumbv7em-none-eabi"].contains(&core);
    let kernels = [
        "setup-no-pixel",
        "flat",
        "affine",
        "fast-16",
        "newton",
        "newton-depth-pass",
        "exact",
    ];
    let is_wanted = is_core
        && (per == "frame"
            || per == "mean-of-poses"
            || mode == "kernel" && kernels.contains(&what) && !per.contains("long"));
    is_wanted.then(|| [core, mode, what, per, count].join(","))
}
