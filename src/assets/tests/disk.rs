//! Files on the disk are found by their names in any case, and only files are read.

use std::fs;
use std::path::PathBuf;

use fixel_assets::{Disk, Files};

/// An empty folder for a test.
fn folder(test: &str) -> PathBuf {
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(format!("assets-{test}"));
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    folder
}

#[test]
fn names_are_found_in_any_case() {
    let folder = folder("case");
    fs::create_dir_all(folder.join("Maps/inner")).unwrap();
    fs::write(folder.join("Maps/Wood.PNG"), "x").unwrap();
    for name in ["Maps/Wood.PNG", "maps/wood.png", "MAPS/WOOD.png"] {
        let found = Disk.find(&folder.join(name)).expect(name);
        assert_eq!(fs::read(found).unwrap(), b"x");
    }
    for name in [
        "maps/wood.jpg",
        "maps/inner",
        "other/wood.png",
        "Maps/Wood.PNG/x",
    ] {
        assert_eq!(Disk.find(&folder.join(name)), None, "{name}");
    }
    // A name of any length ends at its first folder that does not exist.
    let long = folder.join("none/".repeat(1_000_000));
    assert_eq!(Disk.find(&long), None);
}

/// Reading one of these would never end.
#[cfg(unix)]
#[test]
fn pipes_and_devices_are_refused() {
    let pipe = folder("pipe").join("a.obj");
    let made = std::process::Command::new("mkfifo").arg(&pipe).status();
    assert!(made.unwrap().success());
    for path in [pipe, "/dev/zero".into()] {
        let problem = Disk.read(&path).unwrap_err().to_string();
        assert_eq!(problem, "it is a pipe or a device, not a file");
        assert_eq!(Disk.find(&path), None);
        let problem = fixel_assets::read(&path, &Disk).unwrap_err();
        assert_eq!(
            problem,
            "it cannot be read: it is a pipe or a device, not a file"
        );
    }
}
