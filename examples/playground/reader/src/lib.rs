//! Reads the visitor's files in a browser. It is a separate module, which the page loads at the first drop; each drop
//! gets a new instance.
//!
//! The page adds files, each as its name and its contents, and calls `read`. The parts of the answer are then:
//!
//! | part | contents |
//! |---|---|
//! | 0 | the mesh: its lists in little-endian numbers, each after its length; 1 if all faces have texture coordinates in the file; and how `include_mesh!` is called for it |
//! | 1 | the texture's pixels: red, green, blue and alpha; and how `include_texture!` is called for it |
//! | 2 | the texture's width and height |
//! | 3 | the name of the model, or of the picture if there is no model |
//! | 4 | what was replaced or left out, in lines |
//! | 5 | why nothing could be read |
//!
//! A part that does not exist is empty.
//!
//! For a board, the page first adds the board's program, then the files, and calls `flash`. Part 0 is then a UF2 of
//! both, part 1 has the words of the model, part 2 says what the model costs on the board, and parts 3 to 5 are as
//! above.

mod model;
mod texture;

use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

use fixel_assets::{Files, Format};
use flash_model::Module;

/// The files and the answer. A browser calls one function at a time, so no one waits for the lock.
static READER: Mutex<Reader> = Mutex::new(Reader {
    bytes: Vec::new(),
    answer: [const { Vec::new() }; 6],
});

type Answer = [Vec<u8>; 6];

struct Reader {
    /// Names and contents in turn.
    bytes: Vec<Vec<u8>>,
    answer: Answer,
}

fn reader() -> MutexGuard<'static, Reader> {
    READER.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Returns `size` bytes of memory for a file: its name, then its contents.
#[allow(unsafe_code)] // promises that no other symbol has this name
#[unsafe(no_mangle)]
pub extern "C" fn add(size: usize) -> *mut u8 {
    let bytes = &mut reader().bytes;
    bytes.push(vec![0; size]);
    bytes
        .last_mut()
        .map_or(std::ptr::null_mut(), Vec::as_mut_ptr)
}

/// Reads the files.
#[allow(unsafe_code)] // promises that no other symbol has this name
#[unsafe(no_mangle)]
pub extern "C" fn read() {
    respond(answer);
}

/// Makes a UF2 of a program, which is the first file, and the model of the others, for the panel of this number.
#[allow(unsafe_code)] // promises that no other symbol has this name
#[unsafe(no_mangle)]
pub extern "C" fn flash(panel: u32) {
    respond(|files| flashed(files, panel));
}

/// Keeps the answer to the files, which it takes.
fn respond(answer: impl Fn(&Dropped) -> Result<Answer, String>) {
    let mut reader = reader();
    let bytes = std::mem::take(&mut reader.bytes);
    let files = bytes.chunks_exact(2);
    let files = files.map(|file| {
        (
            String::from_utf8_lossy(&file[0]).into_owned(),
            file[1].as_slice(),
        )
    });
    reader.answer = answer(&Dropped(files.collect())).unwrap_or_else(|problem| {
        let mut answer = [const { Vec::new() }; 6];
        answer[5] = problem.into_bytes();
        answer
    });
}

/// A part of the answer.
#[allow(unsafe_code)] // promises that no other symbol has this name
#[unsafe(no_mangle)]
pub extern "C" fn part(number: usize) -> *const u8 {
    reader().answer[number].as_ptr()
}

/// How many bytes it has.
#[allow(unsafe_code)] // promises that no other symbol has this name
#[unsafe(no_mangle)]
pub extern "C" fn part_size(number: usize) -> usize {
    reader().answer[number].len()
}

/// Names and contents of files that were dropped together, without their folders.
struct Dropped<'a>(Vec<(String, &'a [u8])>);

impl Dropped<'_> {
    fn named(&self, path: &Path) -> Option<&(String, &[u8])> {
        let name = path.file_name()?.to_str()?;
        // On some systems a file has the same name in other letters.
        let is_it = |(other, _): &&(String, _)| other.eq_ignore_ascii_case(name);
        self.0.iter().find(is_it)
    }

    /// The name of the first model.
    fn model(&self) -> Option<&str> {
        let mut names = self.0.iter().map(|(name, _)| name.as_str());
        names.find(|name| Format::of(Path::new(name)).is_some())
    }
}

impl Files for Dropped<'_> {
    fn read(&self, path: &Path) -> io::Result<Vec<u8>> {
        let missing = || io::Error::other("drop it together with the model");
        self.named(path)
            .map(|(_, contents)| contents.to_vec())
            .ok_or_else(missing)
    }

    fn find(&self, path: &Path) -> Option<PathBuf> {
        self.named(path).map(|_| path.into())
    }
}

/// A file's name as the macros read it: with no escapes but these two. macOS takes letters apart, and `{:?}` would write
/// an accent as `\u{308}`.
fn quoted(name: &str) -> String {
    let name = name.replace('\\', r"\\").replace('"', r#"\""#);
    format!("\"{name}\"")
}

/// The answer for a model and its texture, or for a texture alone.
fn answer(files: &Dropped) -> Result<Answer, String> {
    let mut notes = Vec::new();
    let (name, mesh, texture) = if let Some(name) = files.model() {
        let (mesh, mut model) = model::read(name, files, &mut notes)?;
        let texture = texture::of_model(name, &mut model, files, &mut notes);
        (name.into(), mesh, texture)
    } else {
        let texture = texture::dropped(files.0.iter())?;
        (texture.name.clone(), Vec::new(), Some(texture))
    };
    let (pixels, size) = texture.map(texture::Texture::bytes).unwrap_or_default();
    Ok([
        mesh,
        pixels,
        size,
        name.into_bytes(),
        notes.join("\n").into_bytes(),
        Vec::new(),
    ])
}

/// The answer for a board: a UF2 of its program and a model. The panel is four times the number of the module in
/// [`Module::ALL`], and by how many more right angles the picture is turned.
fn flashed(files: &Dropped, panel: u32) -> Result<Answer, String> {
    let module = Module::ALL.get((panel / 4) as usize);
    let &(.., mut module) = module.ok_or_else(|| format!("there is no panel {panel}"))?;
    module.rotation = (module.rotation + panel) % 4;
    let (program, files) = files.0.split_first().ok_or("there is no program")?;
    let files = Dropped(files.to_vec());
    let name = files.model().ok_or("there is no model")?;
    let spare = texture::dropped(files.0.iter().filter(|(other, _)| other != name));
    let spare = spare.ok().map(|texture| texture.picture);
    let mut notes = Vec::new();
    let board = flash_model::board(program.1)?;
    let words = flash_model::write(name, &files, spare.as_ref(), board, module, &mut notes)?;
    let uf2 = flash_model::uf2(program.1, &words)?;
    let cost = flash_model::cost(&words, board)?.into_bytes();
    let words = words.iter().flat_map(|word| word.to_le_bytes()).collect();
    let notes = notes.join("\n").into_bytes();
    Ok([uf2, words, cost, name.into(), notes, Vec::new()])
}
