//! Runs the program in its own directory.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// Makes an empty directory for a test.
pub fn directory(test: &str) -> PathBuf {
    let directory = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("simulator-{test}"));
    let _ = fs::remove_dir_all(&directory);
    fs::create_dir_all(&directory).unwrap();
    directory
}

pub fn run(directory: &Path, arguments: &str) -> Output {
    Command::new(env!("CARGO_BIN_EXE_simulator"))
        .args(arguments.split_whitespace())
        .current_dir(directory)
        .output()
        .unwrap()
}

/// Runs the program, which must succeed. Returns the text that the program printed.
pub fn good(directory: &Path, arguments: &str) -> String {
    let output = run(directory, arguments);
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{arguments}: {errors}");
    String::from_utf8(output.stdout).unwrap()
}

pub fn files(directory: &Path) -> Vec<String> {
    let mut names: Vec<String> = fs::read_dir(directory)
        .unwrap()
        .map(|entry| entry.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    names
}

/// Runs the program, which must refuse its arguments with a message that contains all of `says`, and must leave no new
/// file.
pub fn refused(directory: &Path, arguments: &str, says: &[&str]) {
    let before = files(directory);
    let output = run(directory, arguments);
    let message = String::from_utf8_lossy(&output.stderr);
    assert!(
        matches!(output.status.code(), Some(1 | 2)),
        "{arguments}: {:?} {message}",
        output.status
    );
    assert!(!message.contains("panicked"), "{arguments}: {message}");
    for part in says {
        assert!(
            message.contains(part),
            "{arguments}: no '{part}' in: {message}"
        );
    }
    assert_eq!(files(directory), before, "{arguments}: left a file");
}

pub const TRIANGLE: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

/// Returns the word after `label` in the simulator's output.
pub fn printed<'a>(text: &'a str, label: &str) -> &'a str {
    let (_, after) = text
        .split_once(label)
        .unwrap_or_else(|| panic!("no '{label}' in: {text}"));
    after.split_whitespace().next().unwrap()
}

/// Returns the width and height in the header of a PNG.
pub fn png_size(path: &Path) -> (u32, u32) {
    let bytes = fs::read(path).unwrap();
    assert_eq!(&bytes[..8], b"\x89PNG\r\n\x1a\n");
    let side = |at: usize| u32::from_be_bytes(bytes[at..at + 4].try_into().unwrap());
    (side(16), side(20))
}
