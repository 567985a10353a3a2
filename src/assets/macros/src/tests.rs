//! The macros warn about what the reader of models notes, and stop with its errors. No message names a file twice.

#[path = "../../tests/common/kinds.rs"]
mod kinds;

use std::fs;
use std::path::{Path, PathBuf};

use fixel_assets::Disk;

use crate::arguments::Arguments;
use crate::expansion::Expansion;
use crate::{mesh, picture};
use kinds::{all, others};

const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

/// A folder with these files.
fn folder(test: &str, files: &[(&str, &str)]) -> PathBuf {
    let folder = std::env::temp_dir().join(format!("fixel-macros-{test}-{}", std::process::id()));
    fs::create_dir_all(&folder).unwrap();
    for (name, text) in files {
        fs::write(folder.join(name), text).unwrap();
    }
    folder
}

type Macro = fn(&Arguments) -> Result<Expansion, String>;

fn expanded(path: &Path, of: Macro) -> Result<Vec<String>, String> {
    let expansion = of(&Arguments::of(path, &[]))?;
    let (name, notes) = (path.display().to_string(), expansion.notes().iter());
    // The warning begins with the path in the program.
    Ok(notes
        .map(|note| note.strip_prefix(&format!("{name}: ")).unwrap().into())
        .collect())
}

#[test]
fn warnings_are_the_notes_of_the_reader() {
    let files = [
        (
            "tr.obj",
            &*format!("mtllib tr.mtl\n{SQUARE}usemtl a\nf 1 2 3 4\n"),
        ),
        ("tr.mtl", "newmtl a\nTr 1\n"),
        (
            "d.obj",
            &format!("mtllib d.mtl\n{SQUARE}usemtl a\nf 1 2 3 4\n"),
        ),
        ("d.mtl", "newmtl a\nd 0\n"),
        (
            "glow.obj",
            &format!("mtllib glow.mtl\n{SQUARE}usemtl a\nf 1 2 3 4\n"),
        ),
        (
            "glow.mtl",
            "newmtl a\nmap_Kd a.png\nmap_Ke -s 2 2 2 b.png\n",
        ),
        (
            "far.obj",
            &format!("{SQUARE}v 9999 9999 0\nf 1 2 3 4\nf 1 2 5\n"),
        ),
        ("good.obj", &format!("{SQUARE}f 1 2 3 4\n")),
    ];
    let folder = folder("notes", &files);
    for (name, count) in [("tr", 1), ("d", 1), ("glow", 1), ("far", 1), ("good", 0)] {
        let path = folder.join(format!("{name}.obj"));
        let model = fixel_assets::read(&path, &Disk).unwrap();
        let notes: Vec<String> = model.notes.iter().chain(model.far).collect();
        assert_eq!(expanded(&path, mesh::mesh), Ok(notes.clone()), "{name}");
        assert_eq!(notes.len(), count, "{name}: {notes:?}");
    }
    // The materials of the same file repeat none of these, but name textures that are missing.
    assert_eq!(
        expanded(&folder.join("tr.obj"), mesh::materials),
        Ok(vec![])
    );
    let [note] = &expanded(&folder.join("glow.obj"), mesh::materials).unwrap()[..] else {
        panic!("one note");
    };
    let texture = folder.join("a.png").display().to_string();
    assert_eq!(*note, format!("cannot find texture {texture}"));
    fs::remove_dir_all(folder).unwrap();
}

#[test]
fn errors_have_the_line_and_no_path() {
    let files = [
        ("line.obj", "v 0 0 0\nv 1\n"),
        ("point.obj", "v 1 1 1\nf 1 1 1\n"),
        (
            "pointer.glb",
            "version https://git-lfs.github.com/spec/v1\n",
        ),
        ("page.png", "<html>"),
        (
            "image.obj",
            &*format!("mtllib image.mtl\n{SQUARE}usemtl a\nf 1 2 3 4\n"),
        ),
        ("image.mtl", "newmtl a\nmap_Kd page.png\n"),
    ];
    let folder = folder("errors", &files);
    let cases: [(&str, Macro, &str); 6] = [
        (
            "line.obj",
            mesh::mesh,
            "line 2: 'v 1' is not a position: it needs 3 numbers",
        ),
        (
            "point.obj",
            mesh::outline,
            "there is nothing to see: all points of its faces are at 1,1,1",
        ),
        (
            "pointer.glb",
            mesh::materials,
            "it is a Git LFS pointer in place of the file: fetch the file itself with git lfs pull",
        ),
        (
            "pointer.glb",
            picture::texture,
            "it is a Git LFS pointer in place of the file: fetch the file itself with git lfs pull",
        ),
        (
            "page.png",
            picture::texture,
            "it is an HTML file: download the file itself, not the page about it",
        ),
        ("none.png", picture::texture, "it cannot be read: "),
    ];
    for (name, of, says) in cases {
        let problem = expanded(&folder.join(name), of).unwrap_err();
        assert!(problem.starts_with(says), "{name}: {problem}");
        assert!(!problem.contains(name), "{name}: {problem}");
    }
    // A texture that a model names is another file.
    let problem = expanded(&folder.join("image.obj"), picture::texture).unwrap_err();
    assert!(
        problem.contains("page.png: it is an HTML file: "),
        "{problem}"
    );
    fs::remove_dir_all(folder).unwrap();
}

/// The table that the viewer and the writer of models for flash are tested with, too.
#[test]
fn the_macros_say_what_the_other_readers_say() {
    for kind in all() {
        let files = &kind.files;
        let folder = folder("kinds", &[]);
        for (name, bytes) in files {
            fs::write(folder.join(name), bytes).unwrap();
        }
        // The path of the macro is absolute.
        let short = |text: String| text.replace(&format!("{}/", folder.display()), "");
        let said = expanded(&folder.join(files[0].0), mesh::mesh);
        let said = said.map(|notes| notes.into_iter().map(short).collect());
        let advice = ", or name what to keep: object = \"name\" or part = \"name\"";
        let wanted = kind.says.clone().map(|notes| {
            let notes = notes.into_iter().map(|note| {
                if note.contains("too small to see") {
                    note + advice
                } else {
                    note
                }
            });
            notes.collect::<Vec<_>>()
        });
        assert_eq!(said.map_err(short), wanted, "{files:?}");
        fs::remove_dir_all(folder).unwrap();
    }
    let folder = folder("pictures", &[]);
    for (bytes, mut says, is_whole) in others() {
        if !is_whole {
            says += "PNG, JPEG, BMP, TGA, GIF and WebP can be read";
        }
        for name in ["a.png", "a.jpg", "a.tga", "a.usdz", "a"] {
            fs::write(folder.join(name), &bytes).unwrap();
            let said = expanded(&folder.join(name), picture::texture);
            assert_eq!(said, Err(says.clone()), "{name}");
        }
    }
    fs::remove_dir_all(folder).unwrap();
}
