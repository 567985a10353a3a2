//! No option is silently ignored: for each option in the help and for each kind of subject, the picture changes, or a
//! note names the option and what to do, or an error says why the option does not fit.

use std::collections::HashMap;
use std::fs;

use super::program::Bench;

/// The options of the help, each with values that are no subject's default.
const VALUES: &str = "\
--texture u.png none.png
--scene floor cube sphere sphere-flat
--eye 3,2,4 0,0,9
--look-at 0.2,0.4,0
--up z 0.2,1,0
--fov 0.5 25 179
--near 0.1 2 1e9
--far 5 100 100000
--projection orthographic cabinet cavalier
--shade texture gouraud flat wire depth normal
--filter bilinear
--mode exact fast affine
--depth float wide
--cull
--wire
--background 0000ff
--light 1,0,0 0,0,-1,ff0000
--ambient 0 1
--fog 1,9 0,0.001 1000,9999,ff0000
--color rgb888 gray8 gray4 mono
--size 1x1 63x47 2048x1
--bands 1 7 100000
--frames 2 3
--out other.png none/other.png
--dump d.csv none/d.csv
--crc
--quiet
--window
--help
--version";

/// Options that others make idle: the option, and after a bar the others.
const CONTRADICTIONS: &str = "\
--fov 25 | --projection cabinet
--fov 25 | --projection orthographic
--mode affine | --projection cavalier
--mode affine | --shade flat
--mode affine | --shade wire
--mode exact | --shade depth
--filter bilinear | --shade flat
--filter bilinear | --shade wire
--texture u.png | --shade gouraud
--texture u.png | --shade depth
--wire | --shade wire
--light 1,0,0 | --shade texture
--ambient 1 | --shade normal
--fog 1,9 | --shade wire
--fog 1,9 | --shade depth
--fog 1,9 | --shade normal
--background 0000ff | --fov 0.5
--cull | --shade wire
--color rgb888 | --shade wire
--near 0.1 | --projection orthographic
--far 100 | --projection cabinet";

/// These options change the files or the output, not the picture.
const OUTPUTS: &[&str] = &[
    "--bands",
    "--out",
    "--dump",
    "--crc",
    "--quiet",
    "--help",
    "--version",
];

/// Every kind of subject: a model with a color, one with a texture, one without anything; the project's own scene; the
/// measured scenes; and two of them with one bit a pixel.
const SUBJECTS: &[&str] = &[
    "color.obj",
    "texture.obj",
    "texture.obj --color mono",
    "",
    "--color mono",
    "--scene floor",
    "--scene cube",
    "--scene sphere",
    "--scene sphere-flat",
    "--scene cube --color mono",
];

/// What a run shows and says.
struct Run {
    is_good: bool,
    picture: Option<Vec<u8>>,
    /// The lines and the files, without measured times.
    output: Vec<String>,
    said: String,
}

fn run(bench: &Bench, arguments: &str) -> Run {
    for name in ["p.gif", "other.png", "d.csv"] {
        let _ = fs::remove_file(bench.path(name));
    }
    let out = if arguments.contains("--out") {
        ""
    } else {
        "--out p.gif"
    };
    let ran = bench.run(format!("{arguments} {out}"));
    let lines = String::from_utf8(ran.stdout).unwrap();
    let lines = lines
        .lines()
        .map(|line| line.split(" covered, ").next().unwrap().into());
    Run {
        is_good: ran.status.success(),
        picture: fs::read(bench.path("p.gif")).ok(),
        output: lines.chain(bench.files()).collect(),
        said: String::from_utf8(ran.stderr).unwrap(),
    }
}

/// Whether a line names the option, and then says what to do.
fn names(said: &str, option: &str) -> bool {
    let remedies = [
        "; ",
        "give ",
        "leave it out",
        "it needs ",
        "see --",
        "try --",
    ];
    let mut notes = said.lines().filter_map(|line| line.strip_prefix("note: "));
    notes.any(|note| {
        let rest = note.strip_prefix(&format!("{option} "));
        let rest = rest.and_then(|rest| rest.split_once(": "));
        rest.is_some_and(|(_, rest)| remedies.iter().any(|remedy| rest.contains(remedy)))
    })
}

#[test]
fn no_option_is_silently_ignored() {
    let bench = Bench::new("options");
    let points = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0.2\nv 0.5 0.5 1\nvt 0 0\nvt 1 0\nvt 1 1\n";
    let faces = "f 1/1 2/2 5/3\nf 2/1 3/2 5/3\nf 3/1 4/2 5/3\nf 4/1 1/2 5/3\n";
    for name in ["color", "texture"] {
        let faces = if name == "color" {
            faces.replace("/1", "").replace("/2", "").replace("/3", "")
        } else {
            faces.into()
        };
        let text = format!("mtllib m.mtl\n{points}usemtl {name}\n{faces}");
        bench.write(format!("{name}.obj"), text);
    }
    bench.write(
        "m.mtl",
        "newmtl color\nKd 0.9 0.5 0.1\nnewmtl texture\nmap_Kd t.png\n",
    );
    bench.write("t.png", include_bytes!("../../../assets/sea.png"));
    bench.write("u.png", include_bytes!("../../../assets/lighthouse.png"));

    let help = bench.good("--help");
    let options = help.lines().filter_map(|line| line.strip_prefix("  --"));
    for option in options {
        let name = option.split([' ', ',']).next().unwrap();
        let has = VALUES
            .lines()
            .any(|line| line.split(' ').next() == Some(&format!("--{name}")));
        assert!(has, "--{name} has no values in this test");
    }
    let values = VALUES.lines().flat_map(|line| {
        let (option, values) = line.split_once(' ').unwrap_or((line, ""));
        values.split(' ').map(move |value| (option, value, ""))
    });
    let contradictions = CONTRADICTIONS.lines().map(|line| {
        let (option, others) = line.split_once(" | ").unwrap();
        let (option, value) = option.split_once(' ').unwrap_or((option, ""));
        (option, value, others)
    });
    let cases: Vec<_> = values.chain(contradictions).collect();
    let mut failures = Vec::new();
    for subject in SUBJECTS {
        let mut plain = HashMap::new();
        for (option, value, others) in &cases {
            let is_given = |other: &str| subject.split(' ').any(|word| word == other);
            if is_given(option) || others.split(' ').any(is_given) {
                continue;
            }
            // The measured scenes have a size of their own.
            let size = if *option == "--size" || is_given("--scene") {
                ""
            } else {
                "--size 64x48"
            };
            let base = format!("{subject} {others} {size}");
            let with = run(&bench, &format!("{base} {option} {value}"));
            let without = plain
                .entry(base.clone())
                .or_insert_with(|| run(&bench, &base));
            let is_file = ["--texture", "--out", "--dump"].contains(option);
            let is_clear = if !with.is_good {
                // The error of a base is about the other options.
                !without.is_good
                    || with.said.contains("error: ")
                        && (with.said.contains(option) || is_file && with.said.contains(value))
            } else if OUTPUTS.contains(option) {
                with.output != without.output || names(&with.said, option)
            } else {
                with.picture != without.picture || names(&with.said, option)
            };
            if !is_clear {
                failures.push(format!("{base} {option} {value}: {}", with.said));
            }
        }
    }
    assert!(failures.is_empty(), "{}", failures.join("\n"));
}

#[test]
fn an_empty_value_is_refused() {
    let bench = Bench::new("empty");
    let help = bench.good("--help");
    let lines = help.lines().filter_map(|line| line.strip_prefix("  --"));
    let with_value = lines.filter(|line| line.contains(' ') && !line.contains(", -"));
    for line in with_value {
        let name = line.split(' ').next().unwrap();
        bench.refused(
            format!("--{name}="),
            &[&format!("--{name}: its value is empty")],
        );
    }
}
