//! Writes models as Rust source and textures as BMP files, for firmware.
//!
//! The compiler reads these lists as they are. `include_mesh!` parses a file while compiling, which takes minutes for a
//! big one.

use std::ffi::OsStr;
use std::fmt::{Debug, Write as _};
use std::fs;
use std::io::Write as _;
use std::path::{Path, PathBuf};

use embedded_graphics::pixelcolor::{Rgb888, RgbColor};
use fixel::mesh::flash::{UvGrid, short_normal};
use fixel::{Vec2, Vec3};

use super::Result;
use crate::args::{Args, MeshFormat};
use crate::output::{self, Output};
use crate::parts::{self, Part, Run};
use crate::piece::Finish;
use crate::report;
use crate::skin::Skin;
use fixel_assets::{Image, Model};

/// Files to write, each with its name and its bytes.
pub type Files = Vec<(PathBuf, Vec<u8>)>;

/// Returns the files that `--export` names, with the model in its own units.
///
/// # Errors
///
/// A name does not end in .rs or .bmp, or belongs to one of the `inputs` or to the dump; the model does not fit into
/// one mesh; or it has no texture to export.
pub fn files(
    args: &Args,
    inputs: &[PathBuf],
    model: &Model,
    (finishes, skins): (&[Finish], &[Skin]),
) -> Result<Files> {
    let mut files = Vec::new();
    let ending = |path: &Path| path.extension().and_then(OsStr::to_str).map(str::to_owned);
    let textures = (args.export.iter()).find(|path| ending(path).as_deref() == Some("bmp"));
    for path in &args.export {
        output::refuse_inputs(path, inputs)?;
        let refuse = |problem: &str| format!("cannot export {}: {problem}", path.display());
        match ending(path).as_deref() {
            Some("rs") => {
                let whole = parts::whole(model).map_err(|problem| refuse(&problem.to_string()))?;
                let mut source = mesh(&whole.0, args.mesh);
                if !model.materials.is_empty() {
                    let textures = textures.map(PathBuf::as_path);
                    materials(&mut source, model, &whole.1, finishes, textures);
                }
                files.push((path.clone(), source.into_bytes()));
            }
            Some("bmp") if skins.is_empty() => {
                return Err(refuse("the model has no texture").into());
            }
            Some("bmp") => {
                for (at, skin) in skins.iter().enumerate() {
                    let path = numbered(path, at);
                    // The user did not name these files.
                    if at > 0 && path.exists() && !is_export(&path) {
                        return Err(refuse(&format!("{} exists", path.display())).into());
                    }
                    files.push((path, bmp(skin)));
                }
            }
            _ => {
                let endings = "its name must end in .rs for the mesh or in .bmp for its textures";
                return Err(refuse(endings).into());
            }
        }
    }
    for (at, (path, _)) in files.iter().enumerate() {
        if files[..at]
            .iter()
            .any(|(other, _)| output::are_same(other, path))
        {
            return Err(format!("two exports are {}", path.display()).into());
        }
        output::refuse_inputs(path, inputs)?;
        if (args.dump.as_ref()).is_some_and(|dump| output::are_same(dump, path)) {
            return Err(format!("--dump and --export are both {}", path.display()).into());
        }
    }
    Ok(files)
}

/// Writes `files`.
///
/// # Errors
///
/// A file cannot be written.
pub fn write(args: &Args, files: &Files) -> Result<()> {
    for (path, bytes) in files {
        let mut output = Output::create(path)?;
        let failed = output.failed();
        (output.write_all(bytes)).map_err(|error| failed(error.into()))?;
        output.finish()?;
        report::say(args, format_args!("wrote {}", path.display()))?;
    }
    Ok(())
}

/// Returns the name of a texture's file: skin.bmp, skin-2.bmp, skin-3.bmp, …
fn numbered(path: &Path, at: usize) -> PathBuf {
    if at == 0 {
        return path.into();
    }
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    path.with_file_name(format!("{stem}-{}.bmp", at + 1))
}

/// Marks the textures that this program wrote, in a word of the header that readers ignore.
const MARK: &[u8; 4] = b"fixl";

/// Whether a file is a texture that this program wrote.
fn is_export(path: &Path) -> bool {
    fs::read(path).is_ok_and(|file| file.get(6..10) == Some(MARK))
}

/// Encodes a BMP file with 24 bits per texel, which `include_texture!` can read.
fn bmp(skin: &Skin) -> Vec<u8> {
    let ((width, height), rows) = skin.rows();
    // Rows are padded to a multiple of 4 bytes.
    let row_len = (3 * width).next_multiple_of(4);
    let size = 54 + row_len * height;
    let mut file = b"BM".to_vec();
    let mut words = |words: &[u32]| file.extend(words.iter().flat_map(|word| word.to_le_bytes()));
    // The headers of the file and of the image: one plane of 24 bits, not compressed.
    words(&[
        size,
        u32::from_le_bytes(*MARK),
        54,
        40,
        width,
        height,
        1 | 24 << 16,
        0,
        row_len * height,
        2835,
        2835,
        0,
        0,
    ]);
    for row in rows.rev() {
        let start = file.len();
        let bytes = |&[r, g, b, _]: &[u8; 4]| [b, g, r];
        file.extend(row.iter().flat_map(bytes));
        file.resize(start + row_len as usize, 0);
    }
    file
}

/// Formats a list as Rust source, with a few elements per line.
fn list(elements: impl Iterator<Item = impl Debug>) -> String {
    let mut text = String::from("[");
    let mut line = 0;
    for element in elements {
        let element = format!("{element:?}");
        if line == 0 || line + element.len() > 110 {
            text.push_str("\n    ");
            line = 0;
        } else {
            text.push(' ');
        }
        let _ = write!(text, "{element},");
        line += element.len() + 2;
    }
    text.push_str("\n]");
    text
}

/// A static list.
fn plain(out: &mut String, name: &str, kind: &str, elements: &[impl Debug]) {
    let (count, list) = (elements.len(), list(elements.iter()));
    let _ = writeln!(out, "static {name}: [{kind}; {count}] = {list};\n");
}

/// A static list of vectors, which the compiler makes from their bits.
fn vectors<const N: usize>(out: &mut String, name: &str, kind: &str, bits: &[[i32; N]]) {
    let (count, list) = (bits.len(), list(bits.iter()));
    let _ = writeln!(
        out,
        "#[allow(long_running_const_eval)]\n\
         static {name}: [::fixel::{kind}; {count}] = {{\n\
         let bits: [[i32; {N}]; {count}] = {list};\n\
         let mut list = [::fixel::{kind}::ZERO; {count}];\n\
         let mut at = 0;\n\
         while at < {count} {{\n    list[at] = ::fixel::{kind}::from_bits(bits[at]);\n    at += 1;\n}}\n\
         list\n}};\n"
    );
}

/// Rounds positions to 16 bits, with as many fraction bits (at most 16) as fit for all of them. Returns the positions
/// and the number of fraction bits. (`Mesh::shortened` gives the same, but needs the number of positions at compile
/// time.)
fn shortened(positions: &[Vec3]) -> (Vec<[i16; 3]>, u32) {
    let rounded = |bits: i32, fraction: u32| {
        let down = 16 - fraction;
        (i64::from(bits) * 2 + (1 << down)) >> (down + 1)
    };
    let fits = |fraction: &u32| {
        let mut all = positions.iter().flat_map(|position| position.to_bits());
        all.all(|bits| i16::try_from(rounded(bits, *fraction)).is_ok())
    };
    let fraction = (0..=16).rev().find(fits).unwrap_or(0);
    let short = |bits| i16::try_from(rounded(bits, fraction)).unwrap_or(i16::MAX);
    let short = positions
        .iter()
        .map(|position| position.to_bits().map(short));
    (short.collect(), fraction)
}

/// Writes an attribute's indices as a static list, unless they equal those of the positions. Returns whether it did.
fn indices(out: &mut String, name: &str, part: &Part, own: &[[u16; 3]], values: usize) -> bool {
    let differs = own != part.faces || values != part.positions.len();
    if differs {
        plain(out, name, "[::fixel::Index; 3]", own);
    }
    differs
}

fn some(has: bool, name: &str) -> String {
    if has {
        format!("Some(&{name})")
    } else {
        "None".into()
    }
}

fn slice(has: bool, name: &str) -> String {
    if has {
        format!("&{name}")
    } else {
        "&[]".into()
    }
}

/// The Rust source of a static `MESH`.
fn mesh(part: &Part, format: MeshFormat) -> String {
    let mut out = String::from("// Written by the simulator of the crate fixel (--export).\n\n");
    let out_ref = &mut out;
    let positions = &part.positions;
    let quantized = matches!(format, MeshFormat::Quantized16 | MeshFormat::Quantized8);
    plain(out_ref, "FACES", "[::fixel::Index; 3]", &part.faces);
    plain(out_ref, "EDGES", "[::fixel::Index; 2]", &part.edges);
    let mut mesh = if format == MeshFormat::Long {
        let bits: Vec<_> = positions
            .iter()
            .map(|position| position.to_bits())
            .collect();
        vectors(out_ref, "POSITIONS", "Vec3", &bits);
        vec!["::fixel::Mesh::new(&POSITIONS, &FACES)".to_string()]
    } else {
        let (short, fraction) = shortened(positions);
        plain(out_ref, "POSITIONS", "[i16; 3]", &short);
        vec![format!(
            "::fixel::Mesh::short(&POSITIONS, {fraction}, &FACES)"
        )]
    };
    mesh.push("mesh.with_edges(&EDGES)".into());
    if !part.colors.is_empty() {
        let color = |color: &Rgb888| rgb([color.r(), color.g(), color.b()]);
        let colors: Vec<_> = part.colors.iter().map(color).collect();
        let (count, list) = (colors.len(), colors.join(",\n    "));
        let _ = writeln!(
            out_ref,
            "static COLORS: [{RGB888}; {count}] = [\n    {list},\n];\n"
        );
        let has = indices(out_ref, "COLOR_FACES", part, &part.color_faces, count);
        mesh.push(format!(
            "mesh.with_colors(&COLORS, {})",
            some(has, "COLOR_FACES")
        ));
    }
    let (normals, uvs) = (&part.normals, &part.uvs);
    let has_uvs = !uvs.is_empty();
    let own_normals = indices(
        out_ref,
        "NORMAL_FACES",
        part,
        &part.normal_faces,
        normals.len(),
    );
    let own_uvs = has_uvs && indices(out_ref, "UV_FACES", part, &part.uv_faces, uvs.len());
    if quantized {
        let normals: Vec<_> = normals.iter().map(|&normal| short_normal(normal)).collect();
        plain(out_ref, "NORMALS", "[i8; 3]", &normals);
    } else {
        let bits: Vec<_> = normals.iter().map(|normal| normal.to_bits()).collect();
        vectors(out_ref, "NORMALS", "Vec3", &bits);
        mesh.push(format!(
            "mesh.with_normals(&NORMALS, {})",
            some(own_normals, "NORMAL_FACES")
        ));
        if has_uvs {
            let bits: Vec<_> = uvs.iter().map(|uv| uv.to_bits()).collect();
            vectors(out_ref, "UVS", "Vec2", &bits);
            mesh.push(format!(
                "mesh.with_uvs(&UVS, {})",
                some(own_uvs, "UV_FACES")
            ));
        }
    }
    // Each step except the last passes the mesh to the next one.
    let last = if quantized { None } else { mesh.pop() };
    let mut steps = String::new();
    for step in mesh {
        let _ = writeln!(steps, "    let mesh = ::fixel::Mesh::checked({step});");
    }
    if let Some(last) = last {
        let _ = writeln!(
            out_ref,
            "/// The mesh.\n#[allow(long_running_const_eval)]\n\
             pub static MESH: ::fixel::Mesh<'static> = {{\n{steps}    ::fixel::Mesh::checked({last})\n}};"
        );
    } else {
        quantize(out_ref, &steps, uvs, format, [own_normals, own_uvs]);
    }
    out
}

/// Writes the rest of a quantized mesh: its texture coordinates, and the static. `own` says whether normals and texture
/// coordinates have indices of their own.
fn quantize(out: &mut String, steps: &str, uvs: &[Vec2], format: MeshFormat, own: [bool; 2]) {
    let (kind, list, most) = match format {
        MeshFormat::Quantized8 => ("u8", "Bytes", u16::from(u8::MAX)),
        _ => ("u16", "Words", u16::MAX),
    };
    let grid = UvGrid::around(uvs, most);
    let stored: Vec<_> = uvs.iter().map(|&uv| grid.nearest(uv)).collect();
    plain(out, "UVS", &format!("[{kind}; 2]"), &stored);
    // The grid depends only on the smallest and the largest coordinates.
    let corners: Vec<String> = corners(uvs)
        .iter()
        .map(|bits| format!("::fixel::Vec2::from_bits({bits:?})"))
        .collect();
    let corners = corners.join(", ");
    let (normal_faces, uv_faces) = (slice(own[0], "NORMAL_FACES"), slice(own[1], "UV_FACES"));
    let _ = writeln!(
        out,
        "/// The mesh.\n#[allow(long_running_const_eval)]\n\
         pub static MESH: ::fixel::mesh::Quantized<'static> = {{\n{steps}\
         \x20   ::fixel::mesh::Quantized::checked(::fixel::mesh::Quantized::new(\n\
         \x20       mesh,\n\
         \x20       (&NORMALS, {normal_faces}),\n\
         \x20       (::fixel::mesh::flash::StoredUvs::{list}(&UVS), {uv_faces}),\n\
         \x20       ::fixel::mesh::flash::UvGrid::around(&[{corners}], {most}),\n\
         \x20   ))\n}};"
    );
}

const RGB888: &str = "::embedded_graphics::pixelcolor::Rgb888";

fn rgb([r, g, b]: [u8; 3]) -> String {
    format!("{RGB888}::new({r}, {g}, {b})")
}

/// The smallest and the largest coordinates; empty for an empty list.
fn corners(uvs: &[Vec2]) -> Vec<[i32; 2]> {
    let bits = || uvs.iter().map(|uv| uv.to_bits());
    let pick =
        |pick: fn(i32, i32) -> i32| bits().reduce(|a, b| [pick(a[0], b[0]), pick(a[1], b[1])]);
    [pick(i32::min), pick(i32::max)]
        .into_iter()
        .flatten()
        .collect()
}

/// Writes the static `PARTS` in the form that `include_materials!` makes.
fn materials(
    out: &mut String,
    model: &Model,
    runs: &[Run],
    finishes: &[Finish],
    textures: Option<&Path>,
) {
    let mut parts = Vec::new();
    for (material, faces) in runs {
        let at = material.map(|at| at as usize);
        let material = at.and_then(|at| model.materials.get(at));
        let color = material.map_or([255; 3], |material| material.color);
        let mut text = format!("::fixel::mesh::Part::new({faces:?}, {})", rgb(color));
        if let Some(material) = material {
            let _ = write!(text, "\n        .with_material({:?})", material.name);
        }
        let skin = at.and_then(|at| finishes.get(at)?.texture);
        let image = material.and_then(|material| model.images.get(material.texture? as usize));
        let file = match (textures, skin, image) {
            (Some(path), Some(skin), _) => Some(numbered(path, skin)),
            (None, _, Some(Image::File(path))) => Some(path.clone()),
            (None, _, Some(Image::Bytes(name, _))) => Some(name.into()),
            _ => None,
        };
        if let Some(name) = file.as_deref().and_then(Path::file_name) {
            let _ = write!(
                text,
                "\n        .with_texture({:?})",
                name.to_string_lossy()
            );
        }
        parts.push(text);
    }
    let (count, list) = (parts.len(), parts.join(",\n    "));
    let _ = writeln!(
        out,
        "\n/// The mesh's materials.\npub static PARTS: [::fixel::mesh::Part<'static>; {count}] = [\n    {list},\n];"
    );
}
