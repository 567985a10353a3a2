//! Runs the program in a directory of its own.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use image::RgbImage;

pub const TRIANGLE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

/// The directory of a test.
pub struct Bench(PathBuf);

impl Bench {
    /// Makes an empty directory.
    pub fn new(test: &str) -> Self {
        let directory = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("simulator-{test}"));
        let _ = fs::remove_dir_all(&directory);
        fs::create_dir_all(&directory).unwrap();
        Self(directory)
    }

    pub fn path(&self, name: impl AsRef<Path>) -> PathBuf {
        self.0.join(name)
    }

    pub fn write(&self, name: impl AsRef<Path>, bytes: impl AsRef<[u8]>) {
        fs::write(self.path(name), bytes).unwrap();
    }

    pub fn read(&self, name: impl AsRef<Path>) -> Vec<u8> {
        fs::read(self.path(name)).unwrap()
    }

    pub fn text(&self, name: &str) -> String {
        fs::read_to_string(self.path(name)).unwrap()
    }

    pub fn picture(&self, name: impl AsRef<Path>) -> RgbImage {
        image::open(self.path(name)).unwrap().into_rgb8()
    }

    pub fn files(&self) -> Vec<String> {
        let entries = fs::read_dir(&self.0).unwrap();
        let name = |entry: std::io::Result<fs::DirEntry>| entry.unwrap().file_name();
        let mut names: Vec<_> = entries
            .map(|entry| name(entry).into_string().unwrap())
            .collect();
        names.sort();
        names
    }

    pub fn command(&self, arguments: impl AsRef<str>) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_simulator"));
        let words = arguments.as_ref().split_whitespace();
        command.args(words).current_dir(&self.0);
        command
    }

    pub fn run(&self, arguments: impl AsRef<str>) -> Output {
        self.command(arguments).output().unwrap()
    }

    /// Runs the program, which must succeed. Returns what it wrote to standard output and to standard error.
    pub fn outputs(&self, arguments: impl AsRef<str>) -> (Vec<u8>, String) {
        let output = self.run(&arguments);
        let notes = String::from_utf8(output.stderr).unwrap();
        assert!(output.status.success(), "{}: {notes}", arguments.as_ref());
        (output.stdout, notes)
    }

    /// Runs the program, which must succeed. Returns the text that the program printed.
    pub fn good(&self, arguments: impl AsRef<str>) -> String {
        String::from_utf8(self.outputs(arguments).0).unwrap()
    }

    /// Runs the program, which must succeed. Returns the notes.
    pub fn notes(&self, arguments: impl AsRef<str>) -> String {
        self.outputs(arguments).1
    }

    /// Runs the program, and returns the checksum of the picture.
    pub fn crc(&self, arguments: impl AsRef<str>) -> String {
        let said = self.good(format!("{} --crc", arguments.as_ref()));
        printed(&said, "crc").into()
    }

    /// Runs the program, and returns its picture.
    pub fn draw(&self, arguments: impl AsRef<str>) -> RgbImage {
        self.good(format!("{} --out drawn.png", arguments.as_ref()));
        self.picture("drawn.png")
    }

    /// Runs the program, which must refuse its arguments with a message that contains all of `says`, and must leave no
    /// new file. Returns the message.
    pub fn refused(&self, arguments: impl AsRef<str>, says: &[&str]) -> String {
        let (arguments, before) = (arguments.as_ref(), self.files());
        let output = self.run(arguments);
        let message = String::from_utf8(output.stderr).unwrap();
        let is_refusal = matches!(output.status.code(), Some(1 | 2));
        assert!(is_refusal, "{arguments}: {:?} {message}", output.status);
        assert!(
            message.contains("error: ") && !message.contains("panicked"),
            "{message}"
        );
        for part in says {
            assert!(
                message.contains(part),
                "{arguments}: no '{part}' in: {message}"
            );
        }
        assert_eq!(self.files(), before, "{arguments}: left a file");
        message
    }
}

/// Returns the word after `label` in the simulator's output.
pub fn printed<'a>(text: &'a str, label: &str) -> &'a str {
    let after = text
        .split_once(label)
        .and_then(|(_, after)| after.split_whitespace().next());
    after.unwrap_or_else(|| panic!("no '{label}' in: {text}"))
}
