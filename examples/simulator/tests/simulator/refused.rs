//! Command lines that the program refuses, and what its message says.

use std::fs;

use super::program::{Bench, TRIANGLE};

/// Senseless cameras. Each line has arguments, and parts of the message.
const CAMERAS: &str = "
--fov 0 | field of view is 0 degrees | above 0 and below 180 degrees
--fov 180 | field of view is 180 degrees | above 0 and below 180 degrees
--fov -60 | field of view is -60 degrees | above 0 and below 180 degrees
--fov 400 | field of view is 400 degrees | above 0 and below 180 degrees
--fov nan | --fov | finite number
--near 0 | --near 0 | above 0
--near -1 | --near -1 | above 0
--near 1e-9 | --near 0.000000001 | at least
--near 1.7 --far 1.7 | --far 1.7: | beyond the near plane at 1.7
--near 1.8 --far 1.7 | --far 1.7: | beyond the near plane at 1.8
--near 100 | --near 100: the model is | must be below
--near 100 --far 200 | --near 100: the model is | must be below
--far 0.1 | --far 0.1: the model is | must be above
--eye 1,2,3 --look-at 1,2,3 | eye and target are both at 1,2,3 | must differ
--eye 0,0,5 --look-at 0,0,0 --up 0,0,2 | --up 0,0,2 is along the line of sight | must not be
--eye 0,5,0 --look-at 0,0,0 | the default --up 0,1,0 is along the line of sight | give another one
--up 0,0,0 | --up 0,0,0 | must not be zero
--eye 0,0,1e6 | --eye: it reaches 1000000 from the middle of the model, 0.5,0.5,0 | 32768 is the limit
--look-at 0,0,1e9 | --look-at: it reaches 62500000 | 32768 is the limit
--eye 0,0 | --eye 0,0: | three numbers
--eye 0,zero,0 | zero | must be a number
--look-at 0;0;0 | 0;0;0 | must be a number";

/// Impossible pictures and other mistakes.
const PICTURES: &str = "
--fov 0.0001 | --fov: it reaches | 32768 is the limit
--size 0x240 | --size 0x240 | from 1 to 2048
--size 320x0 | --size 320x0 | from 1 to 2048
--size 100000x100000 | --size 100000x100000 | from 1 to 2048
--size 320 | --size 320: | such as 320x240
--size -1x5 | --size -1x5:
--bands 0 | --bands 0: it must be a whole number from 1
--frames 0 | --frames 0: it must be a whole number from 1 to 10000
--frames 2 --out t.png | 2 frames | .gif
--shade shiny | --shade shiny: the possible values are texture, gouraud, flat, lit, wire, depth, normal
--depth double | --depth double: the possible values are linear, float, wide
--background red | --background red: | such as ff8800
--background 12345 | such as ff8800
--background #1234567 | such as ff8800
--background 12345g | such as ff8800
--background +12345 | such as ff8800
--light 0,0,0 | --light 0,0,0: it must point somewhere
--light 1,2 | --light 1,2: it must be 3 numbers and perhaps a color
--light 1,2,3,red | --light 1,2,3,red: 'red'
--light 1,2,x | --light 1,2,x: 'x'
--light 1,2,3,ff0000,4 | --light
--ambient 1.5 | --ambient 1.5: it must be between 0 and 1
--fog 4,1 | --fog 4,1: fog ends at 1
--fog 3,3 | --fog 3,3: fog ends at 3
--fog 3 | --fog 3: it must be 2 numbers
--fog 1,2,3,4 | --fog
--fog a,b | --fog a,b: 'a'
--fog 1,1e20 | --fog: it reaches | is the limit
--out t.bmp | t.bmp | .png, .gif or .apng
--out picture | picture | .png, .gif or .apng
--out none/t.png | cannot write none/t.png: its folder does not exist
--out folder.png | cannot write folder.png | directory
--dump none/t.csv | cannot write none/t.csv
--sparkle | there is no option --sparkle
--shad lit | there is no option --shad: did you mean --shade?
--shade | --shade
--cull --cull | --cull is given twice
--cull=3 | --cull
u.obj | only one model
--scene cube | cannot be used with a model
--scene moon | --scene moon: the possible values are floor, cube, sphere, sphere-flat";

fn cases(table: &'static str) -> impl Iterator<Item = (&'static str, Vec<&'static str>)> {
    let cells = |line: &'static str| line.split('|').map(str::trim);
    let rows = table
        .lines()
        .skip(1)
        .map(move |line| cells(line).collect::<Vec<_>>());
    rows.map(|row| (row[0], row[1..].to_vec()))
}

#[test]
fn senseless_cameras_are_refused() {
    let bench = Bench::new("cameras");
    bench.write("t.obj", TRIANGLE);
    for (arguments, says) in cases(CAMERAS) {
        bench.refused(format!("t.obj {arguments}"), &says);
        // A parallel projection chooses another eye, and the near and far planes can lie behind the eye.
        if !arguments.contains("--near") && !arguments.starts_with("--far") {
            bench.refused(
                format!("t.obj --projection orthographic {arguments}"),
                &says,
            );
        }
    }
}

#[test]
fn impossible_pictures_and_mistakes_are_refused() {
    let bench = Bench::new("mistakes");
    bench.write("t.obj", TRIANGLE);
    fs::create_dir(bench.path("folder.png")).unwrap();
    for (arguments, says) in cases(PICTURES) {
        bench.refused(format!("t.obj {arguments}"), &says);
    }
    for option in ["--texture t.png", "--cull"] {
        let name = option.split(' ').next().unwrap();
        bench.refused(option, &[&format!("{name} needs a model: ")]);
    }
    for option in ["--size 9x9", "--shade wire", "--eye 1,2,3"] {
        let name = option.split(' ').next().unwrap();
        let says = format!("{name} cannot be used with --scene: ");
        bench.refused(
            format!("--scene cube {option}"),
            &[&says, "leave out --scene"],
        );
    }
    if cfg!(not(feature = "sdl")) {
        bench.refused("t.obj --window", &["--window", "--features sdl"]);
    }
}

/// The help lists every value of every option.
#[test]
fn help_is_complete() {
    let bench = Bench::new("help");
    let help = bench.good("--help");
    assert_eq!(bench.good("-h"), help);
    let lines = || help.lines().map(str::trim_start);
    for option in [
        "scene",
        "projection",
        "shade",
        "filter",
        "mode",
        "depth",
        "color",
    ] {
        let message = bench.refused(format!("--{option} ?"), &["the possible values are "]);
        let (_, names) = message
            .lines()
            .next()
            .unwrap()
            .split_once("values are ")
            .unwrap();
        for name in names.split(", ") {
            assert!(
                lines().any(|line| line.starts_with(&format!("{name} "))),
                "{option} {name}"
            );
        }
    }
    for part in ["Examples", "Camera:", "below 180", "[default: 320x240]"] {
        assert!(help.contains(part), "no '{part}' in: {help}");
    }
    assert_eq!(
        bench.good("--version"),
        concat!("simulator ", env!("CARGO_PKG_VERSION"), "\n")
    );
}
