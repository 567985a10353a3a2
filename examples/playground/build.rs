//! The build script: what the module and the server contain besides code.

use std::path::{Path, PathBuf};
use std::{env, fs};

fn main() -> std::io::Result<()> {
    let out = PathBuf::from(env::var_os("OUT_DIR").unwrap_or_default());

    // The counts of the cores that the page estimates for, without the rest: a tenth of the file.
    let counts = "../../tests/instructions.csv";
    println!("cargo::rerun-if-changed={counts}");
    let wanted = |line: &&str| {
        let fields: Vec<&str> = line.split(',').collect();
        let is_core = ["thumbv6m-none-eabi", "thumbv7em-none-eabi"].contains(&fields[0]);
        is_core && fields[1] == "3" && ["frame", "mean-of-poses", "1000 pixels", "1000 triangles"].contains(&fields[4])
    };
    let lines: Vec<String> = fs::read_to_string(counts)?.lines().filter(wanted).map(str::to_owned).collect();
    fs::write(out.join("costs.csv"), lines.join("\n"))?;

    // The module, if it was built already, in the same target folder as the server: …/target/release/build/x/out.
    let module = env::var_os("PLAYGROUND_WASM").map_or_else(
        || built(&out).unwrap_or_default(),
        PathBuf::from,
    );
    println!("cargo::rerun-if-env-changed=PLAYGROUND_WASM");
    println!("cargo::rerun-if-changed={}", module.display());
    fs::write(out.join("playground.wasm"), fs::read(module).unwrap_or_default())
}

fn built(out: &Path) -> Option<PathBuf> {
    Some(out.ancestors().nth(4)?.join("wasm32-unknown-unknown/release/playground.wasm"))
}
