//! Serves the playground, which it contains: `cargo run --release -p playground`.
//!
//! `--port N` serves on another port than 8000; `--out FOLDER` writes the files for another server.

mod server;

use std::io::Write;
use std::path::Path;
use std::process::ExitCode;
use std::{env, fs, io};

use server::{FILES, File};

fn main() -> ExitCode {
    let args: Vec<String> = env::args().skip(1).collect();
    let args: Vec<&str> = args.iter().map(String::as_str).collect();
    let done = built().and_then(|()| match args[..] {
        [] => server::serve(8000),
        ["--port", port] => match port.parse() {
            Ok(port) => server::serve(port),
            Err(_) => Err(format!("--port {port}: it must be 0 to 65535")),
        },
        ["--out", folder] => write(Path::new(folder)),
        _ => Err("usage: playground [--port N | --out FOLDER]".into()),
    });
    if let Err(error) = done {
        // If nobody reads the message, the exit code still shows the failure.
        let _ = writeln!(io::stderr(), "{error}");
        return ExitCode::FAILURE;
    }
    ExitCode::SUCCESS
}

/// Refuses to go on without a module or a program.
fn built() -> Result<(), String> {
    const BUILD: &str = "
  cargo build --release --lib -p playground -p playground-world --target wasm32-unknown-unknown
  cargo build --profile size -p playground-reader -p playground-gif --target wasm32-unknown-unknown
  cargo build --release --manifest-path examples/boards/Cargo.toml --features model,pico --bin pico_model \
    --target thumbv6m-none-eabi --target-dir target
  cargo build --release --manifest-path examples/boards/Cargo.toml --features model,pico2 --bin pico_model \
    --target thumbv8m.main-none-eabihf --target-dir target";
    match FILES
        .iter()
        .find(|file| !file.is_there() && !file.is_optional())
    {
        Some(File { name, .. }) => Err(format!("{name} was not built. First:{BUILD}")),
        None => Ok(()),
    }
}

/// Writes the files for any file server. It overwrites none: a file that already exists must have the same contents.
fn write(folder: &Path) -> Result<(), String> {
    let say = |path: &Path, error: io::Error| format!("{}: {error}", path.display());
    let mut missing = Vec::new();
    for file in FILES.iter().filter(|file| file.is_there()) {
        let path = folder.join(file.name);
        match fs::read(&path) {
            Ok(bytes) if bytes == file.bytes => {}
            Ok(_) => {
                let path = path.display();
                return Err(format!(
                    "{path} is there already, and another file: name a new folder"
                ));
            }
            Err(error) if error.kind() == io::ErrorKind::NotFound => missing.push((path, file)),
            Err(error) => return Err(say(&path, error)),
        }
    }
    fs::create_dir_all(folder).map_err(|error| say(folder, error))?;
    for (path, file) in missing {
        fs::File::create_new(&path)
            .and_then(|mut to| to.write_all(file.bytes))
            .map_err(|error| say(&path, error))?;
    }
    server::say(&folder.display().to_string())
}
