//! A server of a few files, for one visitor.

use std::io::{self, BufRead, BufReader, Write};
use std::net::{Ipv4Addr, TcpListener, TcpStream};
use std::thread;

/// A file of the page.
pub struct File {
    pub name: &'static str,
    kind: &'static str,
    pub bytes: &'static [u8],
}

macro_rules! files {
    ($($name:literal: $kind:literal = $path:expr,)+) => {
        /// The page, the modules, the boards' programs and an emulator (empty if they were not built before), and models
        /// for a board.
        pub static FILES: [File; [$($name),+].len()] =
            [$(File { name: $name, kind: $kind, bytes: include_bytes!($path) }),+];
    };
}

files! {
    "index.html": "text/html; charset=utf-8" = "../page/index.html",
    "style.css": "text/css" = "../page/style.css",
    "main.js": "text/javascript" = "../page/main.js",
    "controls.js": "text/javascript" = "../page/controls.js",
    "module.js": "text/javascript" = "../page/module.js",
    "figures.js": "text/javascript" = "../page/figures.js",
    "files.js": "text/javascript" = "../page/files.js",
    "animation.js": "text/javascript" = "../page/animation.js",
    "board.js": "text/javascript" = "../page/board.js",
    "display.js": "text/javascript" = "../page/display.js",
    "segment.js": "text/javascript" = "../page/segment.js",
    "icon.png": "image/png" = "../page/icon.png",
    "preview.png": "image/png" = "../page/preview.png",
    "playground.wasm.gz": "application/gzip" = concat!(env!("OUT_DIR"), "/playground.wasm.gz"),
    "reader.wasm.gz": "application/gzip" = concat!(env!("OUT_DIR"), "/reader.wasm.gz"),
    "animation.wasm.gz": "application/gzip" = concat!(env!("OUT_DIR"), "/animation.wasm.gz"),
    "world.wasm.gz": "application/gzip" = concat!(env!("OUT_DIR"), "/world.wasm.gz"),
    "display.wasm.gz": "application/gzip" = concat!(env!("OUT_DIR"), "/display.wasm.gz"),
    "pico_model.gz": "application/gzip" = concat!(env!("OUT_DIR"), "/pico_model.gz"),
    "pico2_model.gz": "application/gzip" = concat!(env!("OUT_DIR"), "/pico2_model.gz"),
    "emulator.js.gz": "application/gzip" = concat!(env!("OUT_DIR"), "/emulator.js.gz"),
    "lighthouse.obj": "text/plain" = "../../assets/lighthouse.obj",
    "lighthouse.png": "image/png" = "../../assets/lighthouse.png",
    "cabin.obj": "text/plain" = "../../assets/cabin.obj",
    "cabin.mtl": "text/plain" = "../../assets/cabin.mtl",
    "planks.tga": "image/x-tga" = "../../assets/planks.tga",
    "house.obj": "text/plain" = "../../../tests/models/house.obj",
    "house.mtl": "text/plain" = "../../../tests/models/house.mtl",
    "brick.tga": "image/x-tga" = "../../../src/texture/samples/brick.tga",
    "globe.ply": "text/plain" = "../../assets/globe.ply",
}

impl File {
    /// Whether it was built.
    pub const fn is_there(&self) -> bool {
        !self.bytes.is_empty()
    }

    /// Whether the page does everything else without it.
    pub fn is_optional(&self) -> bool {
        self.name == "emulator.js.gz"
    }
}

/// What the server answers in place of the guide, which it does not contain.
const GUIDE: File = File {
    name: "doc",
    kind: "text/html; charset=utf-8",
    bytes: br#"<!doctype html>
<html lang="en">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>The guide</title>
<style>:root { color-scheme: light dark; font: 16px/1.5 system-ui, sans-serif; } body { margin: 2em; }</style>
<h1>The guide</h1>
<p>This program does not contain the guide. In a clone, this command makes and opens it:</p>
<pre>cargo doc -p fixel --all-features --no-deps --open</pre>
<p>Or read the <a href="https://fixel-rs.github.io/fixel/doc/fixel/guide/index.html">published guide</a>.</p>
</html>
"#,
};

/// Writes a line to the output, which may be closed.
pub fn say(line: &str) -> Result<(), String> {
    let mut out = io::stdout().lock();
    writeln!(out, "{line}")
        .and_then(|()| out.flush())
        .map_err(|error| format!("standard output: {error}"))
}

/// Serves the files on this computer only, until the program is ended.
pub fn serve(port: u16) -> Result<(), String> {
    let wrong = |error| format!("port {port}: {error}; --port chooses another one");
    let listener = TcpListener::bind((Ipv4Addr::LOCALHOST, port)).map_err(wrong)?;
    let port = listener.local_addr().map_err(wrong)?.port();
    say(&format!("http://localhost:{port}"))?;
    for stream in listener.incoming() {
        // Browsers open connections ahead of time. A broken connection is not an error here.
        thread::spawn(|| stream.and_then(answer));
    }
    Ok(())
}

fn answer(mut stream: TcpStream) -> io::Result<()> {
    let mut lines = BufReader::new(stream.try_clone()?).lines();
    let request = lines.next().unwrap_or(Ok(String::new()))?;
    while lines
        .next()
        .transpose()?
        .is_some_and(|line| !line.is_empty())
    {}
    let path = request.split(' ').nth(1).unwrap_or_default();
    let name = path
        .split('?')
        .next()
        .unwrap_or_default()
        .trim_start_matches('/');
    let name = if name.is_empty() { "index.html" } else { name };
    let (status, kind, bytes) = match FILES
        .iter()
        .find(|file| file.name == name && file.is_there())
    {
        Some(file) => ("200 OK", file.kind, file.bytes),
        None if name.starts_with("doc/") => ("404 Not Found", GUIDE.kind, GUIDE.bytes),
        None => ("404 Not Found", "text/plain", &b"not found\n"[..]),
    };
    let length = bytes.len();
    let head = [
        &format!("HTTP/1.1 {status}"),
        &format!("Content-Type: {kind}"),
        &format!("Content-Length: {length}"),
        "Cache-Control: no-store",
        "Connection: close",
        "\r\n",
    ];
    stream.write_all(head.join("\r\n").as_bytes())?;
    stream.write_all(bytes)
}
