//! Options without effect.

use std::fs;

use image::{Rgb, RgbImage};

use super::program::{TRIANGLE, directory, printed, run};

#[test]
fn an_option_without_effect_is_named() {
    let directory = directory("idle");
    fs::write(directory.join("t.obj"), TRIANGLE).unwrap();
    let colored = TRIANGLE
        .replace("0\nv", "0 1 0.5 0\nv")
        .replace("1 0\nf", "1 0 0 1 0\nf");
    fs::write(directory.join("colored.obj"), colored).unwrap();
    let texture = RgbImage::from_pixel(4, 4, Rgb([9, 99, 200]));
    texture.save(directory.join("t.png")).unwrap();
    let shot = |arguments: &str| {
        let output = run(&directory, &format!("{arguments} --out out.gif --crc"));
        let errors = String::from_utf8(output.stderr).unwrap();
        assert!(output.status.success(), "{arguments}: {errors}");
        let said = String::from_utf8(output.stdout).unwrap();
        (printed(&said, "crc").to_string(), errors)
    };
    // Each option, with the rest of its command line. Without the option, the result must be the same.
    for (option, rest) in [
        ("--mode affine", "t.obj --shade flat"),
        ("--mode affine", "t.obj --shade wire"),
        ("--mode fast", "t.obj --shade depth"),
        ("--mode exact", "t.obj --projection cabinet"),
        ("--mode affine", "--scene sphere-flat"),
        ("--texture t.png", "t.obj --shade gouraud"),
        ("--texture t.png", "t.obj --shade normal"),
        ("--filter bilinear", "t.obj"),
        ("--filter bilinear", "colored.obj"),
        ("--filter bilinear", "t.obj --shade wire"),
        ("--light 1,2,3", "t.obj --shade texture"),
        ("--ambient 0.5", "t.obj --shade normal"),
        ("--fog 1,9", "t.obj --shade depth"),
        ("--wire", "t.obj --shade wire"),
        ("--fov 60", "t.obj --projection orthographic --shade normal"),
    ] {
        let (with, notes) = shot(&format!("{rest} {option}"));
        let (without, none) = shot(rest);
        let name = option.split(' ').next().unwrap();
        assert!(
            notes.starts_with(&format!("note: {name}")) && notes.contains(" has no effect "),
            "{rest} {option}: {notes}"
        );
        assert_eq!(none, "", "{rest}");
        assert_eq!(with, without, "{rest} {option}");
    }
    for effective in [
        "t.obj --mode affine --shade flat --dump d.csv",
        "t.obj --texture t.png --filter bilinear",
        "t.obj --cull",
        "t.obj --fog 1,9 --ambient 0",
        "t.obj --projection orthographic --eye 0.3,0.3,4 --fov 60",
        "--mode affine",
    ] {
        assert_eq!(shot(effective).1, "", "{effective}");
    }
}
