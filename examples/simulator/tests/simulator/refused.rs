//! Cameras and pictures that the program refuses.

use std::fs;

use super::program::{TRIANGLE, directory, refused};

#[test]
fn senseless_cameras_are_refused() {
    let directory = directory("cameras");
    fs::write(directory.join("t.obj"), TRIANGLE).unwrap();
    let range = "above 0 and below 180 degrees";
    for (arguments, says) in [
        ("--fov 0", ["field of view is 0 degrees", range]),
        ("--fov 180", ["field of view is 180 degrees", range]),
        ("--fov -60", ["field of view is -60 degrees", range]),
        // 400 degrees would be the same angle as 40 degrees, but nobody means this.
        ("--fov 400", ["field of view is 400 degrees", range]),
        ("--fov nan", ["--fov", "finite number"]),
        ("--near 0", ["--near 0", "above 0"]),
        ("--near -1", ["--near -1", "above 0"]),
        ("--near 1e-9", ["--near 0.000000001", "at least"]),
        (
            "--near 1.7 --far 1.7",
            ["--far 1.7: ", "beyond the near plane at 1.7"],
        ),
        (
            "--near 1.8 --far 1.7",
            ["--far 1.7: ", "beyond the near plane at 1.8"],
        ),
        ("--near 100", ["--near 100: the model is", "must be below"]),
        (
            "--near 100 --far 200",
            ["--near 100: the model is", "must be below"],
        ),
        ("--far 0.1", ["--far 0.1: the model is", "must be above"]),
        (
            "--eye 1,2,3 --look-at 1,2,3",
            ["eye and target are both at 1,2,3", "must differ"],
        ),
        (
            "--eye 0,0,5 --look-at 0,0,0 --up 0,0,2",
            ["--up 0,0,2 is along the line of sight", "must not be"],
        ),
        (
            "--eye 0,5,0 --look-at 0,0,0",
            [
                "the default --up 0,1,0 is along the line of sight",
                "give another one",
            ],
        ),
        ("--up 0,0,0", ["--up 0,0,0", "must not be zero"]),
        (
            "--eye 0,0,1e6",
            [
                "--eye: it reaches 1000000 from the middle of the model, 0.5,0.5,0",
                "32768 is the limit",
            ],
        ),
        (
            "--look-at 0,0,1e9",
            ["--look-at: it reaches 62500000", "32768 is the limit"],
        ),
        ("--eye 0,0", ["--eye", "three numbers"]),
        ("--eye 0,zero,0", ["zero", "must be a number"]),
        ("--look-at 0;0;0", ["0;0;0", "must be a number"]),
    ] {
        refused(&directory, &format!("t.obj {arguments}"), &says);
        // A parallel projection chooses another eye, and the near and far planes can lie behind the eye.
        if !arguments.contains("--near") && !arguments.starts_with("--far") {
            let parallel = format!("t.obj --projection orthographic {arguments}");
            refused(&directory, &parallel, &says);
        }
    }
}

#[test]
fn impossible_pictures_are_refused() {
    let directory = directory("pictures");
    fs::write(directory.join("t.obj"), TRIANGLE).unwrap();
    fs::create_dir(directory.join("folder.png")).unwrap();
    for (arguments, says) in [
        ("--size 0x240", ["--size 0x240", "from 1 to 2048"]),
        ("--size 320x0", ["--size 320x0", "from 1 to 2048"]),
        (
            "--size 100000x100000",
            ["--size 100000x100000", "from 1 to 2048"],
        ),
        ("--size 320", ["--size", "such as 320x240"]),
        ("--size -1x5", ["-1x5", ""]),
        ("--bands 0", ["--bands", "0"]),
        ("--frames 0", ["--frames", "0"]),
        ("--frames 2 --out t.png", ["2 frames", ".gif"]),
        ("--shade shiny", ["shiny", "possible values"]),
        ("--filter soft", ["soft", "possible values"]),
        ("--depth double", ["double", "linear, float"]),
        ("--color cmyk", ["cmyk", "possible values"]),
        ("--projection fisheye", ["fisheye", "possible values"]),
        ("--out t.bmp", ["t.bmp", ".png, .gif or .apng"]),
        ("--out picture", ["picture", ".png, .gif or .apng"]),
        ("--out none/t.png", ["cannot write none/t.png", ""]),
        ("--out folder.png", ["cannot write folder.png", "directory"]),
        ("--dump none/t.csv", ["cannot write none/t.csv", ""]),
        ("--sparkle", ["--sparkle", ""]),
    ] {
        refused(&directory, &format!("t.obj {arguments}"), &says);
    }
    // The eye would be so far away that the number format would leave few steps for the model.
    let far = ["--fov: it reaches", "32768 is the limit"];
    refused(&directory, "t.obj --fov 0.0001", &far);
    refused(&directory, "--scene moon", &["moon", "possible values"]);
    refused(&directory, "t.obj --scene cube", &["cannot be used with"]);
    if cfg!(not(feature = "sdl")) {
        refused(
            &directory,
            "t.obj --window",
            &["--window", "--features sdl"],
        );
    }
}
