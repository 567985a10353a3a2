//! Properties of materials beyond colors and textures.

use image::{Rgb, Rgba, RgbaImage};

use super::program::{Bench, printed};

/// Two squares of one unit, with the material `front` in the plane z = 0 and `back` in z = -1. The texture repeats
/// twice along each side.
const SQUARES: &str = "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 -1\nv 1 0 -1\nv 1 1 -1\nv 0 1 -1\n\
                       vt 0 0\nvt 2 0\nvt 2 2\nvt 0 2\n\
                       usemtl front\nf 1/1 2/2 3/3 4/4\nusemtl back\nf 5/1 6/2 7/3 8/4\n";
/// In this view, the squares fill the picture.
const VIEW: &str = "--eye 0.5,0.5,2 --look-at 0.5,0.5,0 --fov 28.0725 --near 1 --far 4 --projection orthographic \
                    --size 32x32 --color rgb888 --shade texture --background 0000ff";

/// Draws the squares with the materials of `mtl`. Returns the picture.
fn draw(bench: &Bench, mtl: &str, look: &str) -> image::RgbImage {
    bench.write("s.obj", SQUARES);
    bench.write("m.mtl", mtl);
    bench.draw(format!("s.obj {VIEW} {look}"))
}

fn near(found: Rgb<u8>, wanted: [u8; 3], what: &str) {
    let errors = found.0.into_iter().zip(wanted);
    for (found, wanted) in errors {
        assert!(found.abs_diff(wanted) <= 2, "{what}: {found} for {wanted}");
    }
}

#[test]
fn opacity_blends_from_back_to_front() {
    let bench = Bench::new("opacity");
    let middle = |mtl: &str, look| *draw(&bench, mtl, look).get_pixel(9, 9);
    let red = "newmtl back\nKd 1 0 0\n";
    near(
        middle(&format!("newmtl front\nKd 0 1 0\nd 0.25\n{red}"), ""),
        [191, 64, 0],
        "one",
    );
    // The order of the squares in the file does not matter.
    let two = "newmtl front\nKd 0 1 0\nd 0.5\nnewmtl back\nKd 1 0 0\nd 0.5\n";
    near(middle(two, ""), [64, 128, 64], "two");
    let view = VIEW.replace("--eye 0.5,0.5,2", "--eye 0.5,0.5,-3");
    let picture = bench.draw(format!(
        "s.obj {}",
        view.replace("--fov 28.0725", "--fov 20")
    ));
    near(*picture.get_pixel(16, 16), [128, 64, 64], "from behind");
    // Every color of canvas and every look draws the squares.
    for color in ["rgb565", "gray8", "gray4", "mono"] {
        for shade in ["lit", "gouraud", "flat", "wire", "depth", "normal"] {
            let look = format!("s.obj --size 32x32 --color {color} --shade {shade}");
            let said = bench.notes(&look);
            let is_coarse = ["gray4", "mono"].contains(&color);
            let is_blended = ["lit", "gouraud", "flat"].contains(&shade);
            let is_told = said.contains("few colors show blended faces as patterns");
            assert_eq!(is_told, is_coarse && is_blended, "{look}: {said}");
        }
    }
}

/// Faces that are sorted keep their texture coordinates. The front square comes first in the file, but is drawn last.
#[test]
fn sorted_faces_keep_their_texels() {
    let bench = Bench::new("sorted");
    let texel = |x, _| {
        Rgba([
            if x < 2 { 255 } else { 0 },
            if x < 2 { 0 } else { 255 },
            0,
            255,
        ])
    };
    let skin = RgbaImage::from_fn(4, 4, texel);
    skin.save(bench.path("skin.png")).unwrap();
    let (points, _) = SQUARES.split_once("vt").unwrap();
    let faces = "vt 0.25 0\nvt 0.75 0\nusemtl skin\nf 1/1 2/1 3/1 4/1\nf 5/2 6/2 7/2 8/2\n";
    bench.write("t.obj", format!("{points}{faces}"));
    bench.write("m.mtl", "newmtl skin\nmap_Kd skin.png\nd 0.5\n");
    let picture = bench.draw(format!("t.obj {VIEW}"));
    near(
        *picture.get_pixel(9, 9),
        [128, 64, 64],
        "red before green before blue",
    );
}

#[test]
fn colors_of_vertices_are_multiplied_by_the_material() {
    let bench = Bench::new("tinted");
    let points = ["0 0", "1 0", "1 1", "0 1"].map(|xy| format!("v {xy} 0 1 0.5 0\n"));
    bench.write(
        "t.obj",
        format!("mtllib m.mtl\n{}usemtl half\nf 1 2 3 4\n", points.concat()),
    );
    bench.write("m.mtl", "newmtl half\nKd 0.5 1 1\n");
    let picture = bench.draw(format!("t.obj {VIEW}"));
    near(*picture.get_pixel(9, 9), [128, 128, 0], "tinted");
}

#[test]
fn alpha_of_a_texture_is_a_hole() {
    let bench = Bench::new("holes");
    let texel = |x, _| Rgba([0, 255, 0, if x < 2 { 0 } else { 255 }]);
    let leaf = RgbaImage::from_fn(4, 4, texel);
    leaf.save(bench.path("leaf.png")).unwrap();
    let mtl = "newmtl front\nmap_Kd leaf.png\nmap_d leaf.png\nnewmtl back\nKd 1 0 0\n";
    // A texel is four pixels wide. Each pixel is a hole or opaque, even if the texture is smooth.
    for filter in ["nearest", "bilinear"] {
        let picture = draw(&bench, mtl, &format!("--filter {filter}"));
        for x in 0..32 {
            let color = if x % 16 < 8 { [255, 0, 0] } else { [0, 255, 0] };
            assert_eq!(picture.get_pixel(x, 9).0, color, "{filter} {x}");
        }
    }
}

#[test]
fn emission_is_added_and_textures_clamped() {
    let bench = Bench::new("emission");
    let mtl = "newmtl front\nKd 0 0.5 0\nKe 1 0 0.2\nnewmtl back\n";
    near(
        *draw(&bench, mtl, "").get_pixel(9, 9),
        [255, 128, 51],
        "texture",
    );
    // In the dark, only the emission is visible.
    let dark = "--shade lit --ambient 0 --light 0,0,-1 --cull";
    let look = VIEW.replace("--shade texture", dark);
    let picture = bench.draw(format!("s.obj {look}"));
    near(*picture.get_pixel(9, 9), [255, 0, 51], "dark");
    let texel = |x, _| Rgba([if x < 8 { 200 } else { 100 }, 0, 0, 255]);
    RgbaImage::from_fn(16, 16, texel)
        .save(bench.path("skin.png"))
        .unwrap();
    for (clamp, last) in [("off", 200), ("on", 100)] {
        let mtl = format!("newmtl front\nmap_Kd -clamp {clamp} skin.png\nnewmtl back\n");
        let picture = draw(&bench, &mtl, "");
        let row = [4, 12, 20].map(|x| picture.get_pixel(x, 28).0[0]);
        assert_eq!(row, [200, 100, last], "{clamp}");
    }
}

/// glTF calls the square one-sided. The test looks at the square from the front and from behind.
#[test]
fn one_sided_materials_hide_backs_but_not_the_whole_model() {
    let bench = Bench::new("one-sided");
    let numbers: [f32; 12] = [0., 0., 0., 1., 0., 0., 1., 1., 0., 0., 1., 0.];
    let bytes: Vec<u8> = numbers.into_iter().flat_map(f32::to_le_bytes).collect();
    let faces = [0_u16, 1, 2, 0, 2, 3]
        .into_iter()
        .flat_map(u16::to_le_bytes);
    bench.write("b.bin", bytes.into_iter().chain(faces).collect::<Vec<_>>());
    let gltf = |two_sided: bool| {
        let text = format!(
            r#"{{"asset": {{"version": "2.0"}}, "scenes": [{{"nodes": [0]}}], "nodes": [{{"mesh": 0}}],
"meshes": [{{"primitives": [{{"attributes": {{"POSITION": 0}}, "indices": 1, "material": 0}}]}}],
"materials": [{{"doubleSided": {two_sided}}}], "buffers": [{{"byteLength": 60, "uri": "b.bin"}}],
"bufferViews": [{{"buffer": 0, "byteLength": 48}}, {{"buffer": 0, "byteOffset": 48, "byteLength": 12}}],
"accessors": [{{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [0, 0, 0], "max": [1, 1, 0]}},
{{"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"}}]}}"#
        );
        bench.write("s.gltf", text);
    };
    let view = "--eye 0.5,0.5,-3 --look-at 0.5,0.5,0 --size 32x32";
    let sentence = "their materials are one-sided";
    for (two_sided, camera, is_told) in
        [(true, view, false), (false, view, true), (false, "", false)]
    {
        gltf(two_sided);
        let (said, notes) = bench.outputs(format!("s.gltf {camera}"));
        assert_eq!(notes.contains(sentence), is_told, "{two_sided}: {notes}");
        let said = String::from_utf8(said).unwrap();
        assert_ne!(printed(&said, "pixels"), "0");
    }
    bench.refused(
        format!("s.gltf {view} --cull"),
        &["--cull hides their backs"],
    );
}

#[test]
fn no_model_is_invisible() {
    let bench = Bench::new("opaque");
    for opacity in ["Tr 1", "d 0"] {
        let mtl = format!("newmtl front\nKd 1 0 0\n{opacity}\nnewmtl back\nKd 1 0 0\n{opacity}\n");
        let picture = draw(&bench, &mtl, "");
        assert_eq!(picture.get_pixel(9, 9).0, [255, 0, 0], "{opacity}");
        let notes = bench.notes(format!("s.obj {VIEW}"));
        assert_eq!(notes.matches("opaque").count(), 1, "{notes}");
    }
    // One invisible material of several stays invisible.
    let picture = draw(&bench, "newmtl front\nd 0\nnewmtl back\nKd 0 1 0\n", "");
    assert_eq!(picture.get_pixel(9, 9).0, [0, 255, 0]);
}

#[test]
fn light_of_a_texture_is_drawn_with_the_surface() {
    let bench = Bench::new("glow");
    let texels = |name: &str, left: [u8; 3], right: [u8; 3]| {
        let texel = |x, _| Rgb(if x < 2 { left } else { right });
        image::RgbImage::from_fn(4, 4, texel)
            .save(bench.path(name))
            .unwrap();
    };
    texels("skin.png", [0, 90, 0], [0, 90, 0]);
    texels("lamp.png", [0, 0, 0], [200, 0, 0]);
    let mtl = "newmtl front\nmap_Kd skin.png\nmap_Ke lamp.png\nKe 1 1 1\nnewmtl back\n";
    let picture = draw(&bench, mtl, "");
    // The texture repeats twice along the square's 32 pixels.
    for (x, wanted) in [(4, [0, 90, 0]), (12, [200, 90, 0]), (20, [0, 90, 0])] {
        assert_eq!(picture.get_pixel(x, 9).0, wanted, "{x}");
    }
    // Without the texture, the surface does not shine.
    let picture = draw(
        &bench,
        "newmtl front\nKd 0 0 1\nmap_Ke none.png\nKe 1 1 1\nnewmtl back\n",
        "",
    );
    assert_eq!(picture.get_pixel(9, 9).0, [0, 0, 255]);
}

/// A glTF square of one color, which is drawn without light.
fn unlit(bench: &Bench) {
    let positions = [[-1_f32, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    let bytes = positions.iter().flat_map(|[x, y]| [*x, *y, 0.0]);
    let escaped = bytes
        .flat_map(f32::to_le_bytes)
        .map(|byte| format!("%{byte:02x}"));
    let bytes = escaped.collect::<Vec<_>>().concat();
    let file = format!(
        r#"{{"asset": {{"version": "2.0"}}, "nodes": [{{"mesh": 0}}],
        "meshes": [{{"primitives": [{{"attributes": {{"POSITION": 0}}, "mode": 6, "material": 0}}]}}],
        "materials": [{{"pbrMetallicRoughness": {{"baseColorFactor": [1, 0.5, 0, 1]}}, "extensions": {{"KHR_materials_unlit": {{}}}}}}],
        "accessors": [{{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"}}],
        "bufferViews": [{{"buffer": 0, "byteLength": 48}}],
        "buffers": [{{"byteLength": 48, "uri": "data:,{bytes}"}}]}}"#
    );
    bench.write("s.gltf", file);
}

#[test]
fn surfaces_without_light_keep_their_color() {
    let bench = Bench::new("unlit");
    unlit(&bench);
    let dark = "s.gltf --eye 0,0,5 --look-at 0,0,0 --size 32x32 --color rgb888";
    for look in ["", "--shade gouraud", "--shade flat", "--shade texture"] {
        let light = if look.contains("texture") {
            ""
        } else {
            "--ambient 0 --light 0,0,-1"
        };
        let picture = bench.draw(format!("{dark} {light} {look}"));
        // Half of the light is 188 in sRGB.
        assert_eq!(picture.get_pixel(16, 16).0, [255, 188, 0], "{look}");
    }
}

#[test]
fn alpha_of_the_given_texture_cuts_holes() {
    let bench = Bench::new("given");
    let texel = |x, _| Rgba([0, 255, 0, if x < 2 { 100 } else { 200 }]);
    RgbaImage::from_fn(4, 4, texel)
        .save(bench.path("leaf.png"))
        .unwrap();
    let picture = draw(&bench, "newmtl front\nnewmtl back\n", "--texture leaf.png");
    for x in 0..32 {
        // In the holes of the front square, its twin behind has holes, too.
        let color = if x % 16 < 8 { [0, 0, 255] } else { [0, 255, 0] };
        assert_eq!(picture.get_pixel(x, 9).0, color, "{x}");
    }
    RgbaImage::from_pixel(4, 4, Rgba([0, 255, 0, 0]))
        .save(bench.path("clear.png"))
        .unwrap();
    let picture = draw(&bench, "newmtl front\nnewmtl back\n", "--texture clear.png");
    assert_eq!(picture.get_pixel(9, 9).0, [0, 255, 0]);
    let notes = bench.notes(format!("s.obj {VIEW} --texture clear.png"));
    assert!(
        notes.contains("note: a texture without a visible texel is drawn opaque"),
        "{notes}"
    );
}

#[test]
fn lines_beside_faces_are_noted_unless_they_are_drawn() {
    let bench = Bench::new("lines");
    bench.write(
        "l.obj",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nf 1 2 3\nl 2 4\n",
    );
    let note = "note: not drawn: lines: see --wire\n";
    assert!(bench.notes("l.obj").contains(note));
    for look in ["--wire", "--shade wire"] {
        assert!(
            !bench.notes(format!("l.obj {look}")).contains("not drawn"),
            "{look}"
        );
    }
}
