//! Where the output goes. No file of the user may be lost.

use std::fs;
use std::process::Stdio;
use std::time::Duration;

use super::program::{Bench, TRIANGLE};

/// A model and a texture with the same name.
fn cow(test: &str) -> Bench {
    let bench = Bench::new(test);
    bench.write("cow.obj", TRIANGLE);
    // A picture that this program did not write.
    let skin = image::RgbImage::from_pixel(4, 4, image::Rgb([9, 99, 200]));
    skin.save(bench.path("cow.png")).unwrap();
    bench
}

#[test]
fn without_arguments_it_draws_its_own_scene_and_says_where() {
    let bench = Bench::new("scene");
    let said = bench.good("");
    assert!(said.contains("wrote lighthouse.png, 320x240"), "{said}");
    assert_eq!(bench.files(), ["lighthouse.png"]);
    assert_eq!(bench.picture("lighthouse.png").dimensions(), (320, 240));
}

/// A change of these numbers is a change of the picture that every board shows.
#[test]
fn its_own_scene_is_the_picture_of_the_boards() {
    let bench = Bench::new("own");
    for (color, crc) in [("rgb565", "61c89074"), ("mono", "7af25749")] {
        assert_eq!(bench.crc(format!("--color {color}")), crc, "{color}");
    }
}

#[test]
fn an_output_is_never_an_input() {
    let bench = cow("inputs");
    let texture = bench.read("cow.png");
    fs::create_dir(bench.path("folder")).unwrap();
    let whole = bench.path("cow.png").display().to_string();
    let mut names = vec!["cow.png", "./cow.png", "folder/../cow.png", &whole];
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink("../cow.png", bench.path("folder/link.png")).unwrap();
        fs::hard_link(bench.path("cow.png"), bench.path("folder/hard.png")).unwrap();
        names.extend(["folder/link.png", "folder/hard.png"]);
    }
    for name in names {
        for outputs in [
            format!("--out {name}"),
            format!("--out t.png --dump {name}"),
        ] {
            let says = ["is an input, cow.png"];
            bench.refused(format!("cow.obj --texture cow.png {outputs}"), &says);
        }
    }
    bench.refused("cow.obj --dump cow.obj", &["is an input, cow.obj"]);
    assert_eq!(bench.read("cow.png"), texture);
    assert_eq!(bench.text("cow.obj"), TRIANGLE);
}

#[test]
fn a_default_name_replaces_only_what_the_program_wrote() {
    let bench = cow("default");
    let texture = bench.read("cow.png");
    let wrote = |arguments: &str, name: &str| {
        let said = bench.good(arguments);
        assert!(
            said.contains(&format!("wrote {name},")),
            "{arguments}: {said}"
        );
    };
    wrote("cow.obj --texture cow.png", "cow-picture.png");
    wrote("cow.obj", "cow-picture.png");
    assert_eq!(bench.read("cow.png"), texture);
    // The second run replaced the picture of the first run. But the program does not replace its own picture if this
    // picture is an input.
    wrote(
        "cow.obj --texture cow-picture.png --out other.png",
        "other.png",
    );
    let both = ["cow.png and cow-picture.png", "--out"];
    bench.refused("cow.obj --texture cow-picture.png", &both);
    fs::remove_file(bench.path("cow.png")).unwrap();
    for _ in 0..2 {
        wrote("cow.obj", "cow.png");
        wrote("cow.obj --frames 2 --size 16x16", "cow.gif");
    }
    bench.write("cow.gif", "mine");
    wrote("cow.obj --frames 2 --size 16x16", "cow-picture.gif");
}

#[test]
fn two_outputs_are_two_files() {
    let bench = cow("two");
    for outputs in [
        "--out t.png --dump t.png",
        "--out t.png --dump ./t.png",
        "--out - --dump -",
    ] {
        bench.refused(format!("cow.obj {outputs}"), &["--dump and --out are both"]);
    }
}

#[test]
fn each_ending_has_its_format() {
    let bench = cow("endings");
    let png = b"\x89PNG\r\n\x1a\n".as_slice();
    for (ending, start) in [
        ("png", png),
        ("PNG", png),
        ("apng", png),
        ("gif", b"GIF89a\x10\0\x0c\0"),
    ] {
        bench.good(format!("cow.obj --size 16x12 --out t.{ending}"));
        assert!(
            bench.read(format!("t.{ending}")).starts_with(start),
            "{ending}"
        );
    }
    bench.refused("cow.obj --out t.webp", &["t.webp", ".png, .gif or .apng"]);
}

#[test]
fn an_animated_png_has_all_frames_and_repeats() {
    let bench = cow("apng");
    bench.good("cow.obj --size 16x12 --frames 5 --out t.apng");
    let bytes = bench.read("t.apng");
    let mut chunks = Vec::new();
    let mut rest = &bytes[8..];
    while let [a, b, c, d, name @ ..] = rest {
        let length = u32::from_be_bytes([*a, *b, *c, *d]) as usize;
        chunks.push((&name[..4], &name[4..4 + length]));
        rest = &name[4 + length + 4..];
    }
    let of = |name: &[u8]| {
        let chunks = chunks.iter().filter(|(is, _)| *is == name);
        chunks.map(|(_, data)| *data).collect::<Vec<_>>()
    };
    // The animation has five frames and repeats endlessly.
    assert_eq!(of(b"acTL"), [[0, 0, 0, 5, 0, 0, 0, 0]]);
    // A frame is shown for 40/1000 of a second.
    let delays: Vec<_> = of(b"fcTL").iter().map(|control| &control[20..24]).collect();
    assert_eq!(delays, [[0, 40, 3, 232]; 5]);
    assert_eq!(of(b"IEND").len(), 1);
}

#[test]
fn standard_output_takes_pictures_and_dumps() {
    let bench = cow("stdout");
    let piped = |arguments: &str| bench.outputs(format!("cow.obj --size 16x12 {arguments}")).0;
    piped("--out t.png --dump t.csv");
    let before = bench.files();
    assert_eq!(piped("--out -"), bench.read("t.png"));
    assert_eq!(piped("--out t.png --dump -"), bench.read("t.csv"));
    assert!(piped("--frames 2 --out -").starts_with(b"GIF89a"));
    assert_eq!(bench.files(), before);
}

#[test]
fn quiet_prints_only_what_was_asked_for() {
    let bench = cow("quiet");
    let crc = bench.good("cow.obj --out t.png --crc --quiet");
    assert!(crc.starts_with("crc ") && crc.lines().count() == 1, "{crc}");
    assert!(bench.good("cow.obj --out t.png --crc").contains(&crc));
    let look = "cow.obj --out t.gif --frames 2 --size 16x12 --filter bilinear --shade flat";
    let (said, notes) = bench.outputs(look);
    assert!(!said.is_empty() && !notes.is_empty());
    let nothing = (Vec::new(), String::new());
    assert_eq!(bench.outputs(format!("{look} --quiet")), nothing);
    bench.refused("cow.obj --quiet --out t.bmp", &["error: ", "t.bmp"]);
}

/// Starts the program with other outputs, at least one of which cannot be written. Returns what it wrote to a piped
/// standard error.
fn fails(
    bench: &Bench,
    arguments: &str,
    stdout: impl Into<Stdio>,
    stderr: impl Into<Stdio>,
) -> String {
    let mut command = bench.command(arguments);
    let child = command.stdout(stdout).stderr(stderr).spawn().unwrap();
    let output = child.wait_with_output().unwrap();
    assert_eq!(output.status.code(), Some(1), "{arguments}: {output:?}");
    String::from_utf8(output.stderr).unwrap()
}

#[test]
fn a_closed_pipe_is_reported_in_one_line() {
    let bench = cow("closed");
    // The end for writing of a pipe that nobody reads.
    let closed = || std::io::pipe().unwrap().1;
    for arguments in ["--out t.png", "--out -", "--out t.png --dump -"] {
        let arguments = format!("cow.obj {arguments}");
        let said = fails(&bench, &arguments, closed(), Stdio::piped());
        assert!(
            said.starts_with("error: cannot write"),
            "{arguments}: {said}"
        );
        assert_eq!(said.lines().count(), 1, "{arguments}: {said}");
        // A closed standard error must not cause a panic, either.
        let refused = format!("{arguments} --fov 40 --eye 1,2,3 --look-at 1,2,3");
        fails(&bench, &refused, Stdio::null(), closed());
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_reported_in_one_line() {
    let bench = cow("full");
    for outputs in [
        "--out /dev/full",
        "--out t.png --dump /dev/full",
        "--frames 2 --out /dev/full",
    ] {
        let said = fails(
            &bench,
            &format!("cow.obj {outputs}"),
            Stdio::null(),
            Stdio::piped(),
        );
        assert!(
            said.contains("cannot write /dev/full: No space left"),
            "{said}"
        );
    }
    let full = fs::OpenOptions::new()
        .write(true)
        .open("/dev/full")
        .unwrap();
    let said = fails(&bench, "cow.obj --out t.png", full, Stdio::piped());
    assert!(said.contains("standard output: No space left"), "{said}");
    assert!(!fs::metadata("/dev/full").unwrap().is_file());
}

/// The unfinished file has a name of its own, and this name is always short, even if the name of the output is long.
#[test]
fn a_file_name_may_have_the_maximum_length() {
    let bench = cow("long");
    let name = "n".repeat(251) + ".png";
    bench.good(format!("cow.obj --size 16x12 --out {name}"));
    assert!(bench.files().contains(&name));
}

#[cfg(unix)]
#[test]
fn links_and_permissions_stay() {
    use std::os::unix::fs::{PermissionsExt, symlink};
    let bench = cow("links");
    let private = |mode| {
        fs::set_permissions(bench.path("private.png"), fs::Permissions::from_mode(mode)).unwrap();
    };
    bench.write("real.png", "old");
    symlink("real.png", bench.path("link.png")).unwrap();
    symlink("later.png", bench.path("dangling.png")).unwrap();
    bench.write("private.png", "old");
    private(0o600);
    for name in ["link", "dangling", "private"] {
        bench.good(format!("cow.obj --size 16x12 --out {name}.png"));
    }
    for (name, file) in [("link.png", "real.png"), ("dangling.png", "later.png")] {
        assert!(bench.path(name).is_symlink() && bench.read(file).starts_with(b"\x89PNG"));
    }
    let mode = fs::metadata(bench.path("private.png"))
        .unwrap()
        .permissions()
        .mode();
    assert_eq!(mode & 0o777, 0o600);
    private(0o400);
    bench.refused(
        "cow.obj --out private.png",
        &["private.png: it is read-only"],
    );
}

#[cfg(unix)]
#[test]
fn a_pipe_is_written_to() {
    let bench = cow("fifo");
    let fifo = bench.path("t.png");
    let made = std::process::Command::new("mkfifo").arg(&fifo).status();
    assert!(made.unwrap().success());
    let path = fifo.clone();
    let reader = std::thread::spawn(move || fs::read(path).unwrap());
    bench.good("cow.obj --size 16x12 --out t.png");
    // Check first that the pipe is still a pipe. If the program had replaced the pipe, the reader would wait forever.
    assert!(!fs::metadata(fifo).unwrap().is_file());
    assert!(reader.join().unwrap().starts_with(b"\x89PNG"));
}

#[test]
fn an_interrupt_leaves_no_file() {
    let bench = cow("interrupt");
    let before = bench.files();
    let mut child = bench
        .command("cow.obj --frames 10000 --size 640x480 --out t.gif")
        .spawn()
        .unwrap();
    std::thread::sleep(Duration::from_millis(500));
    assert!(child.try_wait().unwrap().is_none());
    child.kill().unwrap();
    child.wait().unwrap();
    assert_eq!(bench.files(), before);
}
