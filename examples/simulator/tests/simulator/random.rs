//! Random command lines.

use std::fs;
use std::path::Path;

use rand::seq::{IndexedRandom, SliceRandom};
use rand::{Rng, SeedableRng};
use rand_chacha::ChaCha8Rng;

use super::program::{Bench, TRIANGLE};

const SEED: u64 = 14;
const LINES: u32 = 400;

/// The options, each with good and bad values.
const OPTIONS: &str = "\
--texture skin.png t.obj none.png out.png
--scene floor cube sphere sphere-flat
--eye 1,2,3 0,0,0 -900,4,1e3 1e9,0,0
--look-at 0,0,0 1,2,3 0.3,0.3,0
--up z 0,1,0 0,0,0 -1,1e-9,2
--fov 1 40 100 179.9 0
--near 0.001 0.5 100 -1
--far 2 1000 0.1
--projection perspective orthographic cabinet cavalier
--shade texture gouraud flat lit wire depth normal
--filter nearest bilinear
--mode exact newton fast affine
--depth linear float wide
--cull
--wire
--background ffffff #102030 blue
--light 1,2,3 0,-1,0,ff0000 0,0,0 1e30,1,1e-30
--ambient 0 1 0.5 2
--fog 1,4 0,3,ffffff 4,1 1e-9,1e9
--color rgb565 rgb888 gray8 gray4 mono
--size 64x48 1x1 2x40 130x3 2048x8 0x9 9999x1
--bands 1 7 1000 0
--frames 1 3 0
--out out.png out.gif out.apng out.tiff skin.png t.obj - folder
--dump out.csv skin.png t.obj - out.png none/x.csv
--crc
--quiet
--window";

/// Whether a PNG has a single color. A dump can have the name of a PNG, too.
fn is_blank(path: &Path) -> bool {
    if fs::read(path).unwrap().starts_with(b"x,y,") {
        return false;
    }
    let picture = image::open(path).unwrap().into_rgb8();
    let first = picture.get_pixel(0, 0);
    picture.width() * picture.height() > 1 && picture.pixels().all(|pixel| pixel == first)
}

#[test]
fn no_command_line_panics_or_loses_a_file_or_silently_draws_nothing() {
    let bench = Bench::new("random");
    let mut random = ChaCha8Rng::seed_from_u64(SEED);
    let mut succeeded = 0;
    for line in 0..LINES {
        for name in bench.files() {
            let path = bench.path(name);
            let _ = fs::remove_file(&path).or_else(|_| fs::remove_dir_all(&path));
        }
        let cube = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
        let inputs = [
            ("t.obj", TRIANGLE.as_bytes().to_vec()),
            ("solid.obj", cube.into()),
            (
                "skin.png",
                include_bytes!("../../../assets/lighthouse.png").to_vec(),
            ),
            // The user's own file, which happens to have the output's default name.
            ("t.png", b"mine".to_vec()),
        ];
        for (name, bytes) in &inputs {
            bench.write(name, bytes);
        }
        fs::create_dir(bench.path("folder")).unwrap();
        let mut words = Vec::new();
        words.extend(
            ["", "t.obj", "solid.obj", "solid.obj", "solid.obj"]
                .choose(&mut random)
                .copied(),
        );
        let few = 1 + random.random_range(0..6);
        let mut options: Vec<&str> = OPTIONS.lines().collect();
        for option in options.partial_shuffle(&mut random, few).0 {
            let option: Vec<&str> = option.split(' ').collect();
            let values = &option[1..];
            words.push(option[0]);
            // The first value is a good value. In half of all cases, the first value is taken.
            let value = if random.random() {
                values.first()
            } else {
                values.choose(&mut random)
            };
            words.extend(value);
        }
        let arguments = words.join(" ");
        let output = bench.run(&arguments);
        let said = String::from_utf8_lossy(&output.stderr);
        let code = output.status.code();
        let is_fine = matches!(code, Some(0..=2)) && !said.contains("panicked");
        assert!(is_fine, "{line}: {arguments}: {code:?} {said}");
        for (name, bytes) in &inputs {
            // A file that is only an output is replaced, because the user asked for this.
            let follows = |options: &[&str]| {
                words
                    .windows(2)
                    .any(|pair| options.contains(&pair[0]) && pair[1] == *name)
            };
            let is_output = follows(&["--out", "--dump"]);
            if is_output && !follows(&["--texture"]) && words[0] != *name {
                continue;
            }
            let is_intact = bench.read(name) == *bytes;
            assert!(is_intact, "{line}: {arguments}: lost {name}");
        }
        let names = bench.files();
        assert!(
            !names.iter().any(|name| name.ends_with(".partial")),
            "{arguments}: {names:?}"
        );
        if code == Some(0) {
            succeeded += 1;
            // The picture can have a single color. Then a note must say so, except if the user wants no notes.
            let is_hidden = said.contains("same color") || words.contains(&"--quiet");
            let pictures = names.iter().filter(|name| {
                Path::new(name).extension() == Some("png".as_ref())
                    && !inputs.iter().any(|(input, _)| input == name)
            });
            for picture in pictures {
                assert!(
                    is_hidden || !is_blank(&bench.path(picture)),
                    "{line}: {arguments}: blank {picture}"
                );
            }
        } else {
            assert!(said.contains("error: "), "{line}: {arguments}: {said}");
        }
    }
    // Some command lines must succeed, and some must fail.
    assert!(
        (LINES / 5..LINES * 4 / 5).contains(&succeeded),
        "{succeeded} of {LINES}"
    );
}
