//! Makes a UF2 of the program `pico_model` and a model; draws what such a UF2 shows:
//!
//! ```sh
//! model PROGRAM MODULE MODEL [PICTURE] [-o model.uf2]
//! model UF2 MODULE [-o model.uf2]
//! model UF2 MILLISECONDS [-o picture.ppm]
//! model PROGRAM [-o program.uf2]
//! ```
//!
//! PROGRAM is the program for a Pico or a Pico 2, or a UF2 with the program and another model. MODULE is the name of a
//! module with a display. After the name, commas separate values that replace the module's own, as in
//! `st7789,rotation=1,cs=none`. If you give no model, the new UF2 has the model of the old one. Another program can be
//! made a UF2 alone. Without `-o`, the bytes go to standard output. Before it writes, the command says what the model
//! costs on the board.

use std::error::Error;
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::Path;
use std::process::{self, ExitCode};

use boards::model::Scene;
use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor};
use fixel::prelude::*;
use fixel_assets::{Disk, Files, Picture};
use flash_model::{Board, Module, board, cost, region, uf2, with_module, write};

const USAGE: &str = "give the file of the program (such as pico.uf2), the module with the display (such as st7789) and \
                     the model, and perhaps a picture and -o FILE; or a UF2 and a module, to keep the model; or a UF2 \
                     and a time in milliseconds, for a picture; or a program alone";

fn main() -> ExitCode {
    let args: Vec<String> = std::env::args().skip(1).collect();
    let args: Vec<&str> = args.iter().map(String::as_str).collect();
    match run(&args) {
        Ok(()) => ExitCode::SUCCESS,
        Err(problem) => {
            eprintln!("error: {problem}");
            ExitCode::FAILURE
        }
    }
}

fn run(args: &[&str]) -> Result<(), Box<dyn Error>> {
    let (args, to) = match args {
        [args @ .., "-o", to] => (args, Some(Path::new(to))),
        [.., "-o"] => return Err("give a file after -o".into()),
        args => (args, None),
    };
    keep(args, to)?;
    let bytes = match *args {
        [program, module, model, ref picture @ ..] if picture.len() < 2 => {
            let module = Module::parse(module)?;
            let picture = match picture {
                [path] => Some(
                    Picture::decode(&read(path)?)
                        .map_err(|problem| format!("{path}: {problem}"))?,
                ),
                _ => None,
            };
            let mut notes = Vec::new();
            let program = read(program)?;
            let board = board(&program)?;
            let words = write(model, &Disk, picture.as_ref(), board, module, &mut notes)?;
            for note in notes {
                eprintln!("note: {note}");
            }
            eprintln!("{}", cost(&words, board)?);
            uf2(&program, &words)?
        }
        [path, now] if now.starts_with(|first: char| first.is_ascii_digit()) => {
            let now_ms = now.parse().map_err(|_| {
                format!("the time is {now}: it must be a whole number of milliseconds")
            })?;
            picture(&read(path)?, now_ms)?
        }
        [path, module] => {
            let (file, module) = (read(path)?, Module::parse(module)?);
            let words =
                with_module(&words(&file), module).map_err(|problem| problem.to_string())?;
            uf2(&file, &words)?
        }
        [program] => uf2(&read(program)?, &[])?,
        _ => return Err(USAGE.into()),
    };
    let Some(to) = to else {
        return Ok(io::stdout().write_all(&bytes)?);
    };
    let name = to.display();
    save(to, &bytes).map_err(|problem| format!("cannot write {name}: {problem}").into())
}

/// Fails if the command would overwrite one of the files that it reads.
fn keep(inputs: &[&str], to: Option<&Path>) -> Result<(), String> {
    let place = |path: &Path| fs::canonicalize(path).ok();
    let Some((to, place_of_to)) = to.and_then(|to| Some((to, place(to)?))) else {
        return Ok(());
    };
    if inputs
        .iter()
        .any(|input| place(Path::new(input)).as_ref() == Some(&place_of_to))
    {
        let name = to.display();
        return Err(format!("{name} is read: give -o another file"));
    }
    Ok(())
}

/// Writes a file, which appears only when it is complete.
fn save(to: &Path, bytes: &[u8]) -> io::Result<()> {
    let mut name = to
        .file_name()
        .ok_or(io::ErrorKind::IsADirectory)?
        .to_owned();
    name.push(format!(".{}.part", process::id()));
    let temporary = to.with_file_name(name);
    let written = File::create_new(&temporary)
        .and_then(|mut file| file.write_all(bytes))
        .and_then(|()| fs::rename(&temporary, to));
    if written.is_err() {
        let _ = fs::remove_file(&temporary);
    }
    written
}

/// The bytes of a file that the user names.
fn read(path: &str) -> Result<Vec<u8>, String> {
    Disk.read(Path::new(path))
        .map_err(|problem| format!("cannot read {path}: {problem}"))
}

/// The words that a UF2 has for the model.
fn words(uf2: &[u8]) -> Vec<u32> {
    let bytes = region(uf2, Board::Pico2.flash());
    let (words, _) = bytes.as_chunks();
    words.iter().copied().map(u32::from_le_bytes).collect()
}

fn picture(uf2: &[u8], now_ms: u64) -> Result<Vec<u8>, Box<dyn Error>> {
    let words = words(uf2);
    let scene = Scene::new(&words)?;
    let (width, height) = scene.size();
    let mut pixels = vec![Rgb565::BLACK; (width * height) as usize];
    let mut depths = vec![0; pixels.len()];
    let canvas = Canvas::new(&mut pixels, width, height)?;
    scene.draw(now_ms, &mut canvas.with_depth(&mut depths)?);
    let mut picture = format!("P6 {width} {height} 255\n").into_bytes();
    for color in pixels.into_iter().map(Rgb888::from) {
        picture.extend([color.r(), color.g(), color.b()]);
    }
    Ok(picture)
}
