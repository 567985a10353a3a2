//! One table of the kinds of files that are noted or refused. The viewer, the macros and the writer of models for flash
//! have a test with this table, and must say the same.

/// A kind of file.
pub struct Kind {
    /// The files, each with its name and contents. The first file is the model.
    pub files: Vec<(&'static str, Vec<u8>)>,
    /// The sentences about the model or, if it is refused, the reason.
    pub says: Result<Vec<String>, String>,
}

const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n";
const FACE: &str = "f 1/1 2/2 3/3 4/4\n";
const CAN: &str = "OBJ, STL, PLY, glTF and GLB can be read";
const UNPACK: &str = "unpack it";
pub const POINTER: &str =
    "it is a Git LFS pointer in place of the file: fetch the file itself with git lfs pull";
const PAGE: &str = "it is an HTML file: download the file itself, not the page about it";

const WHITE: &str = "undefined materials are white: 1, the first is 'a'";

/// A square with these MTL statements for its material.
fn material(mtl: &str, notes: &[&str]) -> Kind {
    let obj = format!("mtllib a.mtl\n{SQUARE}usemtl a\n{FACE}");
    Kind {
        files: vec![("a.obj", obj.clone().into()), ("a.mtl", mtl.into())],
        ..noted(&obj, notes)
    }
}

/// An OBJ file.
fn noted(text: &str, notes: &[&str]) -> Kind {
    Kind {
        files: vec![("a.obj", text.into())],
        says: Ok(notes.iter().map(|note| (*note).into()).collect()),
    }
}

fn refused(name: &'static str, bytes: impl Into<Vec<u8>>, why: &str) -> Kind {
    Kind {
        files: vec![(name, bytes.into())],
        says: Err(why.into()),
    }
}

/// The first bytes of files in other formats, and their names. All are tried as models and as pictures.
pub fn others() -> Vec<(Vec<u8>, String, bool)> {
    let is = |what: &str| format!("it is {what} file: ");
    let iges = [" ".repeat(72).as_bytes(), b"S      1\n"].concat();
    let unpacked: [(&[u8], &str); 5] = [
        (b"PK\x03\x04\x14\0\0\0", "a zip"),
        (b"PK\x05\x06\0\0\0\0", "a zip"),
        (b"\x1f\x8b\x08\0\0\0\0\0", "a gzip"),
        (b"BZh91AY&SY", "a bzip2"),
        (b"\x28\xb5\x2f\xfd\0\0\0\0", "a Zstandard"),
    ];
    let converted: [(&[u8], &str); 24] = [
        (b"#usda 1.0\n", "a USD"),
        (b"PXR-USDC\0\0\0\0", "a USD"),
        (b"<?xml version=\"1.0\"?>\n<amf unit=\"mm\">", "an AMF"),
        (b"VOX \x96\0\0\0MAIN", "a MagicaVoxel"),
        (&iges, "an IGES"),
        (b"ISO-10303-21;\nHEADER;\n", "a STEP"),
        (b"<COLLADA version=\"1.4.1\">", "a COLLADA"),
        (b"Kaydara FBX Binary  \0\x1a\0", "an FBX"),
        (b"; FBX 7.3.0 project file\n", "an FBX"),
        (b"BLENDER-v279", "a Blender"),
        (b"<X3D profile='Full'>", "an X3D"),
        (b"II*\0\x08\0\0\0", "a TIFF"),
        (b"MM\0*\0\0\0\x08", "a TIFF"),
        (b"DDS \x7c\0\0\0", "a DDS"),
        (b"\xabKTX 20\xbb\r\n\x1a\n", "a KTX2"),
        (b"<svg xmlns=\"http://www.w3.org/2000/svg\"/>", "an SVG"),
        (b"\0\0\0\x20ftypavif\0\0\0\0", "an AVIF"),
        (b"\0\0\0\x20ftypavis\0\0\0\0", "an AVIF"),
        (b"\0\0\0\x18ftypheic\0\0\0\0", "a HEIC"),
        (b"\0\0\0\x18ftypmif1\0\0\0\0", "a HEIC"),
        (b"\xff\x0a\0\0", "a JPEG XL"),
        (b"\0\0\0\x0cJXL \r\n\x87\n", "a JPEG XL"),
        (b"8BPS\0\x01", "a Photoshop"),
        (b"OFF\n3 1 0\n", "an OFF"),
    ];
    let stand_ins: [(&[u8], &str); 4] = [
        (
            b"version https://git-lfs.github.com/spec/v1\noid sha256:1\n",
            POINTER,
        ),
        (b"<!DOCTYPE html>\n<title>404</title>", PAGE),
        (b"<!-- v -->\n<html lang=en>", PAGE),
        (b"<?xml version=\"1.0\"?>\n<html xmlns=\"\"/>", PAGE),
    ];
    let unpacked = unpacked.map(|(bytes, what)| (bytes.to_vec(), is(what) + UNPACK, true));
    let converted = converted.map(|(bytes, what)| (bytes.to_vec(), is(what), false));
    let stand_ins = stand_ins.map(|(bytes, says)| (bytes.to_vec(), says.into(), true));
    unpacked
        .into_iter()
        .chain(converted)
        .chain(stand_ins)
        .collect()
}

/// All kinds.
pub fn all() -> Vec<Kind> {
    let mut all = vec![
        noted(&format!("{SQUARE}{FACE}"), &[]),
        material("newmtl a\nKd 1 0 0\n", &[]),
        material("newmtl a\nTr 1\n", &["Tr 1 without d is read as opaque"]),
        material(
            "newmtl a\nd 0\n",
            &["all faces have the opacity 0: they are drawn opaque"],
        ),
        material(
            "version https://git-lfs.github.com/spec/v1\n",
            &[&format!("cannot read materials a.mtl: {POINTER}"), WHITE],
        ),
        material(
            "<!DOCTYPE html>\n",
            &[&format!("cannot read materials a.mtl: {PAGE}"), WHITE],
        ),
        noted(
            &format!("{SQUARE}{FACE}f 1 2\n"),
            &["a face of fewer than 3 corners is left out"],
        ),
        noted(
            &format!(
                "{SQUARE}o near\n{FACE}o bird\nv 9000 9000 0\nv 6000 9000 0\nv 9000 6000 0\nf 5/1 6/2 7/3\n"
            ),
            &[
                "1 of 3 triangles are over 1000 times farther from the middle than the others, which are therefore too small to see: the first of 'bird' is at 9000,9000,0; to leave them out, delete them from the file",
            ],
        ),
        refused(
            "a.obj",
            "v 0 0 0\nv 1\n",
            "line 2: 'v 1' is not a position: it needs 3 numbers",
        ),
        refused(
            "a.obj",
            "v 1 1 1\nf 1 1 1\n",
            "there is nothing to see: all points of its faces are at 1,1,1",
        ),
        refused(
            "a.obj",
            "v 0 0 0\nv 1 1 1\nv 2 2 2\nf 1 2 3\n",
            "there is nothing to see: the corners of each face are on a line",
        ),
        refused(
            "a.obj",
            "v 1 2 3\n",
            "it has points or lines, but no faces: only faces are drawn",
        ),
        refused("a.stl", " \n", "it is empty: it has no faces"),
        refused(
            "a.ply",
            &b"\xff\xfev\0"[..],
            "its text is UTF-16: save it as UTF-8",
        ),
        refused(
            "a.bmp",
            &b"BM\x46\0\0\0\0\0\0\0\x36"[..],
            &format!("it is a BMP file: {CAN}"),
        ),
        refused("a.tga", "anything", &format!("it is a TGA file: {CAN}")),
        refused(
            "a.usdz",
            &b"PK\x03\x04\x14\0"[..],
            &format!("it is a USD file: {CAN}"),
        ),
        refused(
            "a.3mf",
            &b"PK\x03\x04\x14\0"[..],
            &format!("it is a 3MF file: {CAN}"),
        ),
        refused(
            "a.gltf",
            include_bytes!("../../../../examples/assets/sea.png").as_slice(),
            &format!("it is a PNG file: {CAN}"),
        ),
        refused(
            "a.glb",
            "{\"a\": 1}",
            "it is JSON, but not glTF: it has no asset",
        ),
    ];
    for (bytes, says, is_whole) in others() {
        let says = if is_whole { says } else { says + CAN };
        for name in ["a.obj", "a.stl", "a.ply", "a.gltf", "a.glb", "a"] {
            all.push(refused(name, bytes.clone(), &says));
        }
    }
    all
}
