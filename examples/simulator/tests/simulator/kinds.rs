//! The viewer says what the other readers say about a file.

#[path = "../../../../src/assets/tests/common/kinds.rs"]
mod table;

use super::program::{Bench, TRIANGLE};

/// What the program must say, as lines.
fn lines(says: Result<Vec<String>, String>, name: &str) -> String {
    match says {
        Ok(notes) => {
            let lines: Vec<_> = notes.iter().map(|note| format!("note: {note}\n")).collect();
            lines.concat()
        }
        Err(why) => format!("error: model {name}: {why}\n"),
    }
}

#[test]
fn the_viewer_says_what_the_other_readers_say() {
    let bench = Bench::new("kinds");
    for kind in table::all() {
        for (name, bytes) in &kind.files {
            bench.write(name, bytes);
        }
        let name = kind.files[0].0;
        let output = bench.run(format!("{name} --size 32x24 --out o.png"));
        let said = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.success(), kind.says.is_ok(), "{name}: {said}");
        assert_eq!(said, lines(kind.says, name), "{:?}", kind.files);
    }
}

/// Files in other formats in place of a texture: on the command line, in an MTL, in a glTF and inside of a glTF.
#[test]
fn pictures_in_other_formats_are_named_wherever_they_are() {
    let bench = Bench::new("kinds-pictures");
    let corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n";
    bench.write("t.obj", TRIANGLE);
    bench.write(
        "m.obj",
        format!("mtllib m.mtl\n{corners}usemtl a\nf 1/1 2/2 3/3\n"),
    );
    let gltf = |image: &str| {
        format!(
            r#"{{"asset": {{"version": "2.0"}}, "nodes": [{{"mesh": 0}}],
"meshes": [{{"primitives": [{{"attributes": {{"POSITION": 0, "TEXCOORD_0": 1}}, "material": 0}}]}}],
"materials": [{{"pbrMetallicRoughness": {{"baseColorTexture": {{"index": 0}}}}}}],
"textures": [{{"source": 0}}], "images": [{image}], "buffers": [{{"byteLength": 60, "uri": "b.bin"}}],
"bufferViews": [{{"buffer": 0, "byteLength": 36}}, {{"buffer": 0, "byteOffset": 36, "byteLength": 24}}],
"accessors": [{{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}},
{{"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC2"}}]}}"#
        )
    };
    let floats: [f32; 15] = [0., 0., 0., 1., 0., 0., 0., 1., 0., 0., 1., 1., 1., 0., 0.];
    bench.write(
        "b.bin",
        floats
            .into_iter()
            .flat_map(f32::to_le_bytes)
            .collect::<Vec<_>>(),
    );
    for (bytes, mut says, is_whole) in table::others() {
        if !is_whole {
            says += "PNG, JPEG, BMP, TGA, GIF and WebP can be read";
        }
        for file in ["a.png", "a.tiff"] {
            bench.write(file, &bytes);
            bench.write("m.mtl", format!("newmtl a\nmap_Kd {file}\n"));
            bench.write("g.gltf", gltf(&format!(r#"{{"uri": "{file}"}}"#)));
            let message = bench.refused(format!("t.obj --texture {file}"), &[]);
            assert_eq!(
                message,
                format!("error: cannot read texture {file}: {says}\n")
            );
            for model in ["m.obj", "g.gltf"] {
                let notes = bench.notes(format!("{model} --size 32x24 --out o.png"));
                let wanted =
                    format!("note: cannot read texture {file}: {says}; its faces have one color\n");
                assert_eq!(notes, wanted, "{model}");
            }
        }
        let escaped: Vec<_> = bytes.iter().map(|byte| format!("%{byte:02x}")).collect();
        let escaped = escaped.concat();
        bench.write(
            "g.gltf",
            gltf(&format!(r#"{{"uri": "data:image/png,{escaped}"}}"#)),
        );
        let notes = bench.notes("g.gltf --size 32x24 --out o.png");
        let wanted =
            format!("note: cannot read texture image-0: {says}; its faces have one color\n");
        assert_eq!(notes, wanted);
    }
    // A pointer in place of a buffer.
    bench.write("b.bin", "version https://git-lfs.github.com/spec/v1\n");
    bench.refused(
        "g.gltf",
        &[&format!("buffer 0: cannot read b.bin: {}", table::POINTER)],
    );
}
