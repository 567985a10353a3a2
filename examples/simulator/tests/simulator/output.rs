//! Where the output goes. No file of the user may be lost.

use std::fs;
use std::io::Read;
use std::path::Path;
use std::process::{Command, Stdio};

use super::program::{TRIANGLE, directory, files, good, refused, run};

/// Writes a model and a texture with the same name.
fn cow(test: &str) -> std::path::PathBuf {
    let directory = directory(test);
    fs::write(directory.join("cow.obj"), TRIANGLE).unwrap();
    fs::write(directory.join("cow.png"), picture(&directory)).unwrap();
    directory
}

/// The bytes of a PNG, without the simulator's mark.
fn picture(directory: &Path) -> Vec<u8> {
    let bytes = piped(directory, "--size 16x16 --out -");
    let mark = b"fixel simulator";
    let at = bytes
        .windows(mark.len())
        .position(|part| part == mark)
        .unwrap();
    // Leave out the chunk with the mark. A chunk consists of length, name, data and checksum.
    let (start, end) = (at - "Software\0".len() - 8, at + mark.len() + 4);
    [&bytes[..start], &bytes[end..]].concat()
}

/// Returns what the program wrote to standard output.
fn piped(directory: &Path, arguments: &str) -> Vec<u8> {
    let output = run(directory, arguments);
    let errors = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{arguments}: {errors}");
    output.stdout
}

#[test]
fn an_output_is_never_an_input() {
    let directory = cow("inputs");
    let texture = fs::read(directory.join("cow.png")).unwrap();
    fs::create_dir(directory.join("folder")).unwrap();
    let model = "cow.obj --texture cow.png";
    let mut names = vec![
        "cow.png".to_string(),
        "./cow.png".into(),
        "folder/../cow.png".into(),
    ];
    names.push(directory.join("cow.png").display().to_string());
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink("../cow.png", directory.join("folder/link.png")).unwrap();
        fs::hard_link(directory.join("cow.png"), directory.join("folder/hard.png")).unwrap();
        names.extend(["folder/link.png".into(), "folder/hard.png".into()]);
    }
    for name in names {
        refused(
            &directory,
            &format!("{model} --out {name}"),
            &["is an input, cow.png"],
        );
        let dump = format!("{model} --out t.png --dump {name}");
        refused(&directory, &dump, &["is an input, cow.png"]);
    }
    refused(
        &directory,
        "cow.obj --dump cow.obj",
        &["is an input, cow.obj"],
    );
    assert_eq!(fs::read(directory.join("cow.png")).unwrap(), texture);
    assert_eq!(
        fs::read_to_string(directory.join("cow.obj")).unwrap(),
        TRIANGLE
    );
}

#[test]
fn a_default_name_replaces_only_what_the_program_wrote() {
    let directory = cow("default");
    let texture = fs::read(directory.join("cow.png")).unwrap();
    for arguments in ["cow.obj --texture cow.png", "cow.obj"] {
        let said = good(&directory, arguments);
        assert!(said.contains("wrote cow-picture.png"), "{said}");
        assert_eq!(fs::read(directory.join("cow.png")).unwrap(), texture);
    }
    // The second run replaced the picture of the first run. But the program does not replace its own picture if this
    // picture is an input.
    let said = good(
        &directory,
        "cow.obj --texture cow-picture.png --out other.png",
    );
    assert!(said.contains("wrote other.png"), "{said}");
    let both = ["both", "cow.png and cow-picture.png", "--out"];
    refused(&directory, "cow.obj --texture cow-picture.png", &both[1..]);
    fs::remove_file(directory.join("cow.png")).unwrap();
    for _ in 0..2 {
        assert!(good(&directory, "cow.obj").contains("wrote cow.png"));
    }
    for _ in 0..2 {
        assert!(good(&directory, "cow.obj --frames 2 --size 16x16").contains("wrote cow.gif"));
    }
    fs::write(directory.join("cow.gif"), "mine").unwrap();
    let said = good(&directory, "cow.obj --frames 2 --size 16x16");
    assert!(said.contains("wrote cow-picture.gif"), "{said}");
}

#[test]
fn two_outputs_are_two_files() {
    let directory = cow("two");
    for dump in ["t.png", "./t.png"] {
        let arguments = format!("cow.obj --out t.png --dump {dump}");
        refused(&directory, &arguments, &["--dump and --out are both"]);
    }
    refused(
        &directory,
        "cow.obj --out - --dump -",
        &["--dump and --out are both"],
    );
}

#[test]
fn each_ending_has_its_format() {
    let directory = cow("endings");
    for (ending, start) in [
        ("png", &b"\x89PNG\r\n\x1a\n"[..]),
        ("PNG", b"\x89PNG\r\n\x1a\n"),
        ("apng", b"\x89PNG\r\n\x1a\n"),
        ("gif", b"GIF89a"),
    ] {
        good(
            &directory,
            &format!("cow.obj --size 16x12 --out t.{ending}"),
        );
        let bytes = fs::read(directory.join(format!("t.{ending}"))).unwrap();
        assert!(bytes.starts_with(start), "{ending}");
    }
    let known = ["t.webp", ".png, .gif or .apng"];
    refused(&directory, "cow.obj --out t.webp", &known);
}

#[test]
fn an_animated_png_has_all_frames_and_repeats() {
    let directory = cow("apng");
    good(&directory, "cow.obj --size 16x12 --frames 5 --out t.apng");
    let bytes = fs::read(directory.join("t.apng")).unwrap();
    let mut chunks = Vec::new();
    let mut rest = &bytes[8..];
    while let [a, b, c, d, name @ ..] = rest {
        let length = u32::from_be_bytes([*a, *b, *c, *d]) as usize;
        chunks.push((&name[..4], &name[4..4 + length]));
        rest = &name[4 + length + 4..];
    }
    let of = |name: &[u8]| {
        chunks
            .iter()
            .filter(|(is, _)| *is == name)
            .map(|(_, data)| *data)
            .collect::<Vec<_>>()
    };
    // The animation has five frames and repeats endlessly.
    assert_eq!(of(b"acTL"), [[0, 0, 0, 5, 0, 0, 0, 0]]);
    let controls = of(b"fcTL");
    assert_eq!(controls.len(), 5);
    for control in controls {
        // A frame is shown for 40/1000 of a second.
        assert_eq!(control[20..24], [0, 40, 3, 232]);
    }
    assert_eq!(of(b"IEND").len(), 1);
}

#[test]
fn standard_output_takes_pictures_and_dumps() {
    let directory = cow("stdout");
    let look = "cow.obj --size 16x12";
    good(&directory, &format!("{look} --out t.png --dump t.csv"));
    let file = |name: &str| fs::read(directory.join(name)).unwrap();
    let before = files(&directory);
    assert_eq!(piped(&directory, &format!("{look} --out -")), file("t.png"));
    assert_eq!(
        piped(&directory, &format!("{look} --out /dev/stdout")),
        file("t.png")
    );
    let dump = piped(&directory, &format!("{look} --out u.png --dump -"));
    assert_eq!(dump, file("t.csv"));
    fs::remove_file(directory.join("u.png")).unwrap();
    let animation = piped(&directory, &format!("{look} --frames 2 --out -"));
    assert!(animation.starts_with(b"GIF89a"));
    assert_eq!(files(&directory), before);
}

#[test]
fn quiet_prints_only_what_was_asked_for() {
    let directory = cow("quiet");
    let loud = run(&directory, "cow.obj --out t.png --crc");
    let quiet = run(&directory, "cow.obj --out t.png --crc --quiet");
    let crc = String::from_utf8(quiet.stdout).unwrap();
    assert!(crc.starts_with("crc ") && crc.lines().count() == 1, "{crc}");
    assert!(String::from_utf8(loud.stdout).unwrap().contains(&crc));
    let look = "cow.obj --out t.gif --frames 2 --size 16x12 --filter bilinear --shade flat";
    let output = run(&directory, look);
    assert!(!output.stdout.is_empty() && !output.stderr.is_empty());
    let output = run(&directory, &format!("{look} --quiet"));
    assert!(output.status.success());
    assert_eq!(
        [output.stdout, output.stderr],
        [Vec::<u8>::new(), Vec::new()]
    );
    refused(
        &directory,
        "cow.obj --quiet --out t.bmp",
        &["error: ", "t.bmp"],
    );
}

/// Starts the program. Returns its exit code and what it printed to standard error.
fn started(
    directory: &Path,
    arguments: &str,
    stdout: Stdio,
    stderr: Stdio,
) -> (Option<i32>, String) {
    let output = Command::new(env!("CARGO_BIN_EXE_simulator"))
        .args(arguments.split_whitespace())
        .current_dir(directory)
        .stdout(stdout)
        .stderr(stderr)
        .spawn()
        .unwrap()
        .wait_with_output()
        .unwrap();
    (
        output.status.code(),
        String::from_utf8_lossy(&output.stderr).into(),
    )
}

#[test]
fn a_closed_pipe_is_reported_in_one_line() {
    let directory = cow("closed");
    for arguments in [
        "cow.obj --out t.png",
        "cow.obj --out -",
        "cow.obj --out t.png --dump -",
    ] {
        let (reader, writer) = std::io::pipe().unwrap();
        drop(reader);
        let (code, said) = started(&directory, arguments, writer.into(), Stdio::piped());
        assert_eq!(code, Some(1), "{arguments}: {said}");
        assert!(
            said.starts_with("error: cannot write"),
            "{arguments}: {said}"
        );
        assert_eq!(said.lines().count(), 1, "{arguments}: {said}");
        // A closed standard error must not cause a panic, either.
        let (reader, writer) = std::io::pipe().unwrap();
        drop(reader);
        let refused = format!("{arguments} --fov 40 --eye 1,2,3 --look-at 1,2,3");
        let (code, _) = started(&directory, &refused, Stdio::null(), writer.into());
        assert_eq!(code, Some(1), "{refused}");
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_reported_in_one_line() {
    let directory = cow("full");
    let full = || {
        fs::OpenOptions::new()
            .write(true)
            .open("/dev/full")
            .unwrap()
    };
    for arguments in [
        "--out /dev/full",
        "--out t.png --dump /dev/full",
        "--frames 2 --out /dev/full",
    ] {
        let arguments = format!("cow.obj --size 64x48 {arguments}");
        let (code, said) = started(&directory, &arguments, Stdio::null(), Stdio::piped());
        assert_eq!(code, Some(1), "{arguments}: {said}");
        assert!(
            said.contains("cannot write /dev/full: No space left"),
            "{said}"
        );
    }
    let (code, said) = started(
        &directory,
        "cow.obj --out t.png",
        full().into(),
        Stdio::piped(),
    );
    assert_eq!(code, Some(1), "{said}");
    assert!(said.contains("standard output: No space left"), "{said}");
    let metadata = fs::metadata("/dev/full").unwrap();
    assert!(!metadata.is_file());
}

/// The unfinished file has a name of its own, and this name is always short, even if the name of the output is long.
#[test]
fn a_file_name_may_have_the_maximum_length() {
    let directory = cow("long");
    let name = "n".repeat(251) + ".png";
    good(&directory, &format!("cow.obj --size 16x12 --out {name}"));
    assert!(files(&directory).contains(&name));
}

#[cfg(unix)]
#[test]
fn links_and_permissions_stay() {
    use std::os::unix::fs::{PermissionsExt, symlink};
    let directory = directory("links");
    fs::write(directory.join("t.obj"), TRIANGLE).unwrap();
    let path = |name: &str| directory.join(name);
    fs::write(path("real.png"), "old").unwrap();
    symlink("real.png", path("link.png")).unwrap();
    symlink("later.png", path("dangling.png")).unwrap();
    fs::write(path("private.png"), "old").unwrap();
    fs::set_permissions(path("private.png"), fs::Permissions::from_mode(0o600)).unwrap();
    for name in ["link", "dangling", "private"] {
        good(&directory, &format!("t.obj --size 16x12 --out {name}.png"));
    }
    let is_png = |name: &str| fs::read(path(name)).unwrap().starts_with(b"\x89PNG");
    assert!(path("link.png").is_symlink() && is_png("real.png"));
    assert!(path("dangling.png").is_symlink() && is_png("later.png"));
    let mode = fs::metadata(path("private.png"))
        .unwrap()
        .permissions()
        .mode();
    assert_eq!(mode & 0o777, 0o600);
    fs::set_permissions(path("private.png"), fs::Permissions::from_mode(0o400)).unwrap();
    refused(
        &directory,
        "t.obj --out private.png",
        &["private.png: it is read-only"],
    );
}

#[cfg(unix)]
#[test]
fn a_pipe_is_written_to() {
    let directory = directory("fifo");
    fs::write(directory.join("t.obj"), TRIANGLE).unwrap();
    let fifo = directory.join("t.png");
    assert!(
        Command::new("mkfifo")
            .arg(&fifo)
            .status()
            .unwrap()
            .success()
    );
    let reader = std::thread::spawn(move || {
        let mut bytes = Vec::new();
        fs::File::open(fifo)
            .unwrap()
            .read_to_end(&mut bytes)
            .unwrap();
        bytes
    });
    good(&directory, "t.obj --size 16x12 --out t.png");
    // Check first that the pipe is still a pipe. If the program had replaced the pipe, the reader would wait forever.
    assert!(!fs::metadata(directory.join("t.png")).unwrap().is_file());
    assert!(reader.join().unwrap().starts_with(b"\x89PNG"));
}

#[cfg(unix)]
#[test]
fn an_interrupt_leaves_no_file() {
    let directory = cow("interrupt");
    let before = files(&directory);
    for signal in ["INT", "TERM"] {
        let mut child = Command::new(env!("CARGO_BIN_EXE_simulator"))
            .args("cow.obj --frames 10000 --size 640x480 --out t.gif".split(' '))
            .current_dir(&directory)
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        let begun = || {
            files(&directory)
                .iter()
                .any(|name| name.ends_with(".partial"))
        };
        for _ in 0..1000 {
            if begun() {
                break;
            }
            std::thread::sleep(std::time::Duration::from_millis(10));
        }
        assert!(begun());
        let pid = child.id().to_string();
        assert!(
            Command::new("kill")
                .args(["-s", signal, &pid])
                .status()
                .unwrap()
                .success()
        );
        assert_eq!(child.wait().unwrap().code(), Some(130));
        assert_eq!(files(&directory), before);
    }
}
