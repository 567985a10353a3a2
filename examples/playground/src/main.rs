//! Serves the playground, which it contains, or writes its files: see [`USAGE`].

mod server;

use std::borrow::Cow;
use std::fmt::Write as _;
use std::io::Write;
use std::path::Path;
use std::process::ExitCode;
use std::{env, fs, io};

use sha2::{Digest, Sha256};

use server::{FILES, File};

const USAGE: &str = "\
Serves the playground on this computer: playground [--port N | --out FOLDER]

  --port N      serves at this port of localhost; 0 for any free port (default: 8000)
  --out FOLDER  writes the files of a static site into a folder instead

Any file server can publish the folder, at any path. Then browsers keep a copy of the site,
which opens without a network. The site's link to the guide leads to doc/ in the folder: make
the guide with `cargo doc -p fixel --all-features --no-deps`, and copy target/doc there.";

fn main() -> ExitCode {
    let args: Vec<String> = env::args().skip(1).collect();
    let args: Vec<&str> = args.iter().map(String::as_str).collect();
    let done = match args[..] {
        ["--help" | "-h"] => server::say(USAGE),
        [] => built().and_then(|()| server::serve(8000)),
        ["--port", port] => match port.parse() {
            Ok(port) => built().and_then(|()| server::serve(port)),
            Err(_) => Err(format!("--port {port}: it must be 0 to 65535")),
        },
        ["--out", folder] => built().and_then(|()| write(Path::new(folder))),
        _ => Err("usage: playground [--port N | --out FOLDER | --help]".into()),
    };
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
  cargo build --release --lib -p playground -p playground-world -p playground-display \
    --target wasm32-unknown-unknown
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
    for (name, content) in site() {
        let path = folder.join(name);
        match fs::read(&path) {
            Ok(bytes) if bytes == *content => {}
            Ok(_) => {
                let path = path.display();
                return Err(format!(
                    "{path} is there already, and another file: name a new folder"
                ));
            }
            Err(error) if error.kind() == io::ErrorKind::NotFound => missing.push((path, content)),
            Err(error) => return Err(say(&path, error)),
        }
    }
    fs::create_dir_all(folder).map_err(|error| say(folder, error))?;
    for (path, content) in missing {
        fs::File::create_new(&path)
            .and_then(|mut to| to.write_all(&content))
            .map_err(|error| say(&path, error))?;
    }
    server::say(&folder.display().to_string())
}

/// The names and contents of a static site's files: the page's, and a service worker that keeps exactly these.
fn site() -> Vec<(&'static str, Cow<'static, [u8]>)> {
    let mut digests = String::new();
    let mut site = Vec::new();
    for file in FILES.iter().filter(|file| file.is_there()) {
        let digest = Sha256::digest(file.bytes);
        let comma = if digests.is_empty() { "" } else { ", " };
        // Text has room.
        let _ = write!(digests, "{comma}\"{}\": \"{digest:x}\"", file.name);
        site.push((file.name, Cow::Borrowed(file.bytes)));
    }
    let version = format!("{:x}", Sha256::digest(&digests));
    let script = include_str!("../page/offline.js")
        .replace(r#"["", {}]"#, &format!(r#"["{version}", {{ {digests} }}]"#));
    site.push(("offline.js", Cow::Owned(script.into_bytes())));
    site
}
