//! The format of a file is found by its name and its contents, and formats that cannot be read are named.

mod common;

use common::read;

const STL: &[u8] = b"solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid\n";

#[track_caller]
fn refused(name: &str, bytes: &[u8], says: &str) {
    let problem = read(&[(name, bytes)]).unwrap_err();
    assert_eq!(problem, format!("model {name}: {says}"));
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
        ("usdz", "a USDZ"),
        ("vrml", "a VRML"),
        ("wrl", "a VRML"),
    ];
    for (ending, what) in endings {
        refused(
            &format!("a.{ending}"),
            b"PK\x03\x04\0\0 anything",
            &says(what),
        );
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
