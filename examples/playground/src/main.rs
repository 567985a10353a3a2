//! Serves the playground, which it contains: `cargo run --release -p playground`.
//!
//! `--port N` serves on another port than 8000; `--out FOLDER` writes the files for another server; `--compare` draws
//! views that it reads from its input, and compares checksums (`.ci/playground`).

#[path = "../../common/mod.rs"]
mod common;

// It draws for `--compare` only.
#[allow(dead_code)]
mod app;
#[allow(dead_code)]
mod formats;
mod model;
mod record;
mod scene;
mod server;
mod view;

use std::error::Error;
use std::path::Path;
use std::process::ExitCode;
use std::{env, fs, io};

use crc32fast::Hasher;

use app::App;

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}

fn run() -> Result<(), Box<dyn Error>> {
    let args: Vec<String> = env::args().skip(1).collect();
    match args.iter().map(String::as_str).collect::<Vec<_>>()[..] {
        [] => server::serve(8000),
        ["--port", port] => server::serve(
            port.parse()
                .map_err(|_| format!("--port {port}: it must be 0 to 65535"))?,
        ),
        ["--out", folder] => write(Path::new(folder)),
        ["--compare"] => compare(),
        _ => Err("usage: playground [--port N | --out FOLDER | --compare]".into()),
    }
}

/// Writes the files for any file server.
fn write(folder: &Path) -> Result<(), Box<dyn Error>> {
    fs::create_dir_all(folder)?;
    for file in &server::FILES {
        fs::write(folder.join(file.name), file.bytes)?;
    }
    println!("{}", folder.display());
    Ok(())
}

/// Reads lines of a view's fields and the checksum of its picture, and draws the same here.
fn compare() -> Result<(), Box<dyn Error>> {
    static APP: spin::Mutex<App> = spin::Mutex::new(App::new());
    let app = &mut *APP.lock();
    let mut same = 0;
    for line in io::stdin().lines() {
        let line = line?;
        let (fields, wanted) = line
            .rsplit_once(' ')
            .ok_or("a line has the fields of a view and a checksum")?;
        let fields: Vec<i32> = fields
            .split(' ')
            .map(str::parse)
            .collect::<Result<_, _>>()?;
        app.view = view::View::from_fields(&fields).ok_or("a view has 22 fields")?;
        if !app.clear(0) || !app.draw(0) || !app.overlay(0) {
            return Err(format!("{line}: {}", app.message).into());
        }
        let mut crc = Hasher::new();
        for pixel in app.colors(0) {
            crc.update(&embedded_graphics::pixelcolor::raw::ToBytes::to_be_bytes(
                *pixel,
            ));
        }
        let crc = format!("{:08x}", crc.finalize());
        if crc != wanted {
            return Err(format!("{line}: the host draws {crc}").into());
        }
        same += 1;
    }
    println!("{same} pictures are the same in WebAssembly and here");
    Ok(())
}
