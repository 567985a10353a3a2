//! The format of a file is found by its name and its contents, and formats that cannot be read are named.

mod common;

use common::read;

const STL: &[u8] = b"solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n";

#[track_caller]
fn refused(name: &str, bytes: &[u8], says: &str) {
    let problem = read(&[(name, bytes)]).unwrap_err();
    assert_eq!(problem, says, "{name}");
}

#[test]
fn formats_that_cannot_be_read_are_named() {
    let says = |what: &str| format!("it is {what} file: OBJ, STL, PLY, glTF and GLB can be read");
    let endings = [
        ("fbx", "an FBX"),
        ("dae", "a COLLADA"),
        ("3mf", "a 3MF"),
        ("OFF", "an OFF"),
        ("blend", "a Blender"),
        ("step", "a STEP"),
        ("stp", "a STEP"),
        ("x3d", "an X3D"),
        ("ms3d", "a MilkShape 3D"),
        ("3ds", "a 3D Studio"),
        ("md2", "an MD2"),
        ("usdz", "a USD"),
        ("vrml", "a VRML"),
        ("wrl", "a VRML"),
    ];
    for (ending, what) in endings {
        for bytes in [b"PK\x03\x04\0\0 anything".as_slice(), b"anything"] {
            refused(&format!("a.{ending}"), bytes, &says(what));
        }
    }
    let contents: [(&[u8], &str); 8] = [
        (b"Kaydara FBX Binary  \0\x1a\0", "an FBX"),
        (
            b"\xef\xbb\xbf<?xml version=\"1.0\"?>\n<COLLADA xmlns=\"\">",
            "a COLLADA",
        ),
        (b"<?xml version=\"1.0\"?>\n<X3D profile='Full'>", "an X3D"),
        (b"OFF\n4 4 6\n0 0 0\n", "an OFF"),
        (b"BLENDER-v279", "a Blender"),
        (b"ISO-10303-21;\nHEADER;\n", "a STEP"),
        (b"MS3D000000\x04\0", "a MilkShape 3D"),
        (b"#VRML V2.0 utf8\n", "a VRML"),
    ];
    for (bytes, what) in contents {
        for name in ["a.obj", "a.stl", "a"] {
            refused(name, bytes, &says(what));
        }
    }
}

#[test]
fn contents_count_more_than_names() {
    refused(
        "a.obj",
        STL,
        "it is an STL file, not an OBJ file: give it the ending .stl",
    );
    refused(
        "a.stl",
        b"{\"asset\": 1}",
        "it is a glTF file, not an STL file: give it the ending .glb or .gltf",
    );
    refused(
        "a.gltf",
        b"ply\nformat",
        "it is a PLY file, not a glTF file: give it the ending .ply",
    );
    refused(
        "a.ply",
        b"\xff\xfev\0",
        "its text is UTF-16: save it as UTF-8",
    );
    refused("a.stl", b" \n", "it is empty: it has no faces");
    for name in ["a.stl", "a.STL", "a", "a.fbx"] {
        assert_eq!(read(&[(name, STL)]).unwrap().triangles.len(), 1, "{name}");
    }
    // If neither the name nor the contents of a file show a format, OBJ is assumed.
    assert_eq!(
        read(&[("a.txt", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3")])
            .unwrap()
            .triangles
            .len(),
        1
    );
}

/// The names and the first bytes of files that are not what their extension says.
#[test]
fn what_stands_for_a_file_is_named_before_the_extension_decides() {
    let can = "OBJ, STL, PLY, glTF and GLB can be read";
    let unpack = "unpack it";
    let page = "download the file itself, not the page about it";
    let iges = [" ".repeat(72).as_bytes(), b"S      1\n"].concat();
    let starts: [(&[u8], &str, &str); 20] = [
        (
            b"version https://git-lfs.github.com/spec/v1\noid sha256:1\n",
            "a Git LFS pointer in place of the",
            "fetch the file itself with git lfs pull",
        ),
        (b"<!DOCTYPE html>\n<title>404</title>", "an HTML", page),
        (b"\n <HTML lang=en>", "an HTML", page),
        (b"PK\x03\x04\x14\0", "a zip", unpack),
        (b"\x1f\x8b\x08\0", "a gzip", unpack),
        (b"#usda 1.0\n", "a USD", can),
        (b"PXR-USDC\0", "a USD", can),
        (
            b"<?xml version=\"1.0\"?><!-- v -->\n<amf unit=\"mm\">",
            "an AMF",
            can,
        ),
        (b"VOX \x96\0\0\0", "a MagicaVoxel", can),
        (&iges, "an IGES", can),
        (b"MM\x10\0\0\0\x02\0", "a 3D Studio", can),
        (b"FORM\0\0\0\x10LWO2", "a LightWave", can),
        (b"\xff\xfe\xff\x0eS\0k\0e\0t\0c\0h\0", "a SketchUp", can),
        (b"\x89PNG\r\n\x1a\n", "a PNG", can),
        (b"\xff\xd8\xff\xe0", "a JPEG", can),
        (b"DRACO\x02\x02", "a Draco", can),
        (b"Kaydara FBX Binary", "an FBX", can),
        (b"COFF\n3 1 0\n", "an OFF", can),
        (b"RIFF\x04\0\0\0WEBPVP8 ", "a WebP", can),
        (b"\x28\xb5\x2f\xfd\0", "a Zstandard", unpack),
    ];
    for (bytes, what, remedy) in starts {
        for name in ["a.glb", "a.gltf", "a.obj", "a.stl", "a.ply", "a"] {
            refused(name, bytes, &format!("it is {what} file: {remedy}"));
        }
    }
    refused(
        "a.gltf",
        b"{\"metadata\": {\"type\": \"Object\"}}",
        "it is JSON, but not glTF: it has no asset",
    );
    // What only looks like another format is read.
    let texts = ["# <html>\n", "# PK\n", "#?\n", "g MM\n", "# glTF\n"];
    for text in texts {
        let text = format!("{text}v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        assert!(read(&[("a.obj", &text)]).is_ok(), "{text}");
    }
}

#[test]
fn pictures_in_other_formats_are_named() {
    let can = "PNG, JPEG, BMP, TGA, GIF and WebP can be read";
    let starts: [(&[u8], &str); 12] = [
        (b"II*\0\x08\0\0\0", "a TIFF"),
        (b"MM\0*\0\0\0\x08", "a TIFF"),
        (b"DDS \x7c\0\0\0", "a DDS"),
        (b"\xabKTX 20\xbb\r\n\x1a\n", "a KTX2"),
        (b"<?xml version='1.0'?>\n<svg xmlns=''>", "an SVG"),
        (b"\0\0\0\x20ftypavif", "an AVIF"),
        (b"\0\0\0\x18ftypheic", "a HEIC"),
        (b"8BPS\0\x01", "a Photoshop"),
        (b"v/1\x01\x02\0\0\0", "an OpenEXR"),
        (b"\0\0\0\x0cJXL \r\n", "a JPEG XL"),
        (b"#?RADIANCE\n", "a Radiance HDR"),
        (b"ply\nformat ascii 1.0\n", "a PLY"),
    ];
    for (bytes, what) in starts {
        let problem = fixel_assets::Picture::decode(bytes).unwrap_err();
        assert_eq!(problem, format!("it is {what} file: {can}"));
    }
    let pointer = fixel_assets::Picture::decode(b"version https://git-lfs.github.com/spec/v1\n");
    assert_eq!(
        pointer.unwrap_err(),
        "it is a Git LFS pointer in place of the file: fetch the file itself with git lfs pull"
    );
    let other = fixel_assets::Picture::decode(b"anything else").unwrap_err();
    assert_eq!(other, "it is not a PNG, JPEG, BMP, TGA, GIF or WebP");
}
