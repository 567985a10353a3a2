//! Reads the visitor's files in a browser. It is a separate module, which the page loads at the first drop; each drop
//! gets a new instance.
//!
//! The page adds files, each as its name and its contents, and calls `read`. The parts of the answer are then:
//!
//! | part | contents |
//! |---|---|
//! | 0 | the mesh: how long its lists are, the lists in little-endian numbers, and how `include_mesh!` is called for it |
//! | 1 | the texture's pixels: red, green, blue and alpha; and how `include_texture!` is called for it |
//! | 2 | the texture's width and height |
//! | 3 | the name of the model, or of the picture if there is no model |
//! | 4 | what was replaced or left out, in lines |
//! | 5 | why nothing could be read |
//!
//! A part that does not exist is empty.

mod model;
mod texture;

use std::io;
use std::path::Path;
use std::sync::{Mutex, MutexGuard, PoisonError};

use fixel_assets::{Files, Format};

/// The files and the answer. A browser calls one function at a time, so no one waits for the lock.
static READER: Mutex<Reader> = Mutex::new(Reader {
    bytes: Vec::new(),
    answer: [const { Vec::new() }; 6],
});

struct Reader {
    /// Names and contents in turn.
    bytes: Vec<Vec<u8>>,
    answer: [Vec<u8>; 6],
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
    fn find(&self, path: &Path) -> Option<&[u8]> {
        let name = path.file_name()?.to_str()?;
        // On some systems a file has the same name in other letters.
        let is_it = |(other, _): &&(String, _)| other.eq_ignore_ascii_case(name);
        self.0.iter().find(is_it).map(|(_, contents)| *contents)
    }
}

impl Files for Dropped<'_> {
    fn read(&self, path: &Path) -> io::Result<Vec<u8>> {
        let missing = || io::Error::other("drop it together with the model");
        self.find(path).map(<[u8]>::to_vec).ok_or_else(missing)
    }

    fn has(&self, path: &Path) -> bool {
        self.find(path).is_some()
    }
}

/// The answer for a model and its texture, or for a texture alone.
fn answer(files: &Dropped) -> Result<[Vec<u8>; 6], String> {
    let mut notes = Vec::new();
    let is_model = |(name, _): &&(String, _)| Format::of(Path::new(name)).is_some();
    let (name, mesh, texture) = if let Some((name, _)) = files.0.iter().find(is_model) {
        let (mesh, model) = model::read(name, files, &mut notes)?;
        let texture = texture::of_model(name, &model, files, &mut notes);
        (name.clone(), mesh, texture)
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
