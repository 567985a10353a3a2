//! Models as Rust source. The program must write the files of exported/, and these must draw the same as
//! `include_mesh!`.

use std::fs;

use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor};
use fixel::mesh::{Part, Quantized};
use fixel::prelude::*;
use fixel::shade::Shader;

use super::program::{directory, good, refused};

const OBJ: &str = include_str!("exported/tent.obj");
const MTL: &str = include_str!("exported/tent.mtl");

macro_rules! exported {
    ($($name:ident)+) => {
        $(
            #[allow(clippy::pedantic)]
            mod $name {
                include!(concat!("exported/", stringify!($name), ".rs"));
            }
        )+
        /// Each format's name and its source.
        const SOURCES: &[(&str, &str)] = &[
            $((stringify!($name), include_str!(concat!("exported/", stringify!($name), ".rs")))),+
        ];
    };
}
exported!(long short quantized_16 quantized_8);

static LONG: Mesh = include_mesh!("exported/tent.obj");
static SHORT: Mesh = include_mesh!("exported/tent.obj", short);
static OF_16: Quantized = include_mesh!("exported/tent.obj", quantized_16);
static OF_8: Quantized = include_mesh!("exported/tent.obj", quantized_8);
static PARTS: &[Part] = include_materials!("exported/tent.obj");

#[test]
fn a_model_is_written_as_statics() {
    let directory = directory("exports");
    fs::write(directory.join("tent.obj"), OBJ).unwrap();
    fs::write(directory.join("tent.mtl"), MTL).unwrap();
    for (format, source) in SOURCES {
        let said = good(
            &directory,
            &format!("tent.obj --export mesh.rs --mesh {format}"),
        );
        assert!(said.contains("wrote mesh.rs"), "{said}");
        let written = fs::read_to_string(directory.join("mesh.rs")).unwrap();
        assert_eq!(written, *source, "{format}");
    }
}

/// Draws a mesh from an eye that sees two sides of the roof, or the ground sheet.
fn picture<S: Shader<Color = Rgb565>>(mesh: &Mesh<'_>, shader: &S, eye: Vec3) -> Vec<Rgb565> {
    let mut pixels = vec![Rgb565::BLACK; 64 * 48];
    let mut depth = vec![0; 64 * 48];
    let mut canvas = Canvas::new(&mut pixels, 64, 48)
        .unwrap()
        .with_depth(&mut depth)
        .unwrap();
    let projection = Projection::perspective(deg!(45), (64, 48), fx!(0.5), fx!(20)).unwrap();
    let camera = Camera::look_at(eye, vec3!(0, 0.6, 0), Vec3::Y).unwrap();
    let drawn = canvas.draw(mesh, &(projection * camera), shader);
    assert!(drawn.drawn > 0);
    pixels
}

#[test]
fn the_statics_draw_the_same_as_include_mesh() {
    let texels: Vec<Rgb565> = (0..64_u8)
        .map(|at| Rgb565::new(at % 8 * 4, at / 8 * 8, 31 - at % 32))
        .collect();
    let texture = Texture::new(&texels, 8, 8).unwrap();
    let sun = Light::new(vec3!(1, 2, 3), fx!(0.3), fx!(0.7)).unwrap();
    let skin = Textured::new(&texture).lit(sun);
    for eye in [vec3!(2, 1.5, 3), vec3!(1, -2, 2)] {
        let plain = |mesh: &Mesh<'_>| picture(mesh, &skin, eye);
        let packed = |mesh: &Quantized<'_>| picture(mesh.mesh(), &mesh.shader(skin), eye);
        assert!(plain(&long::MESH) == plain(&LONG));
        assert!(plain(&short::MESH) == plain(&SHORT));
        assert!(packed(&quantized_16::MESH) == packed(&OF_16));
        assert!(packed(&quantized_8::MESH) == packed(&OF_8));
    }
    // The formats round differently, so their pictures differ.
    let eye = vec3!(2, 1.5, 3);
    let packed = picture(OF_8.mesh(), &OF_8.shader(skin), eye);
    assert!(packed != picture(&LONG, &skin, eye));
    for parts in [
        &long::PARTS,
        &short::PARTS,
        &quantized_16::PARTS,
        &quantized_8::PARTS,
    ] {
        assert_eq!(parts[..], *PARTS);
    }
    assert_eq!(PARTS[1].color(), Rgb888::new(51, 102, 153));
}

#[test]
fn textures_are_written_as_bmp() {
    let directory = directory("skins");
    fs::write(directory.join("tent.obj"), OBJ).unwrap();
    fs::write(directory.join("tent.mtl"), MTL).unwrap();
    let texel = |x: u32, y: u32| {
        image::Rgb([
            40 * u8::try_from(x).unwrap(),
            90,
            200 - 60 * u8::try_from(y).unwrap(),
        ])
    };
    let stripes = image::RgbImage::from_fn(2, 4, texel);
    stripes.save(directory.join("stripes.png")).unwrap();
    good(&directory, "tent.obj --export skin.bmp --export mesh.rs");
    let bmp = fs::read(directory.join("skin.bmp")).unwrap();
    let format = image::ImageFormat::Bmp;
    let image = image::load_from_memory_with_format(&bmp, format).unwrap();
    let image = image.into_rgb8();
    assert_eq!(image.dimensions(), (2, 4));
    for (x, y, pixel) in stripes.enumerate_pixels() {
        assert_eq!(image.get_pixel(x, y), pixel, "{x}, {y}");
    }
    let mesh = fs::read_to_string(directory.join("mesh.rs")).unwrap();
    assert!(mesh.contains(r#".with_texture("skin.bmp")"#), "{mesh}");
}

/// The user did not name the second texture's file. The program replaces such a file only if it wrote it.
#[test]
fn numbered_textures_replace_no_other_file() {
    let directory = directory("numbered");
    let obj = "mtllib two.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nvt 0 0\nvt 1 0\nvt 0 1\n\
               usemtl a\nf 1/1 2/2 3/3\nusemtl b\nf 2/1 4/2 3/3\n";
    fs::write(directory.join("two.obj"), obj).unwrap();
    let mtl = "newmtl a\nmap_Kd a.png\nnewmtl b\nmap_Kd b.png\n";
    fs::write(directory.join("two.mtl"), mtl).unwrap();
    for (name, gray) in [("a.png", 50), ("b.png", 200)] {
        let image = image::RgbImage::from_pixel(2, 2, image::Rgb([gray; 3]));
        image.save(directory.join(name)).unwrap();
    }
    fs::write(directory.join("skin-2.bmp"), "precious").unwrap();
    refused(
        &directory,
        "two.obj --export skin.bmp",
        &["skin-2.bmp exists"],
    );
    let kept = fs::read(directory.join("skin-2.bmp")).unwrap();
    assert_eq!(kept, b"precious");
    fs::remove_file(directory.join("skin-2.bmp")).unwrap();
    for _ in 0..2 {
        good(&directory, "two.obj --export skin.bmp");
    }
    assert!(directory.join("skin-2.bmp").exists());
}

#[test]
fn exports_over_inputs_or_other_outputs_are_refused() {
    let directory = directory("bad-exports");
    fs::write(directory.join("tent.rs"), OBJ).unwrap();
    fs::write(
        directory.join("plain.obj"),
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\nmtllib tent.bmp\n",
    )
    .unwrap();
    fs::write(directory.join("tent.bmp"), MTL).unwrap();
    fs::create_dir(directory.join("sub")).unwrap();
    for (arguments, says) in [
        (
            "tent.rs --export sub/../tent.rs",
            "cannot write sub/../tent.rs: it is an input, tent.rs",
        ),
        (
            "plain.obj --export tent.bmp",
            "cannot write tent.bmp: it is an input, tent.bmp",
        ),
        (
            "tent.rs --export mesh.rs --export ./mesh.rs",
            "two exports are ./mesh.rs",
        ),
        (
            "plain.obj --export mesh.txt",
            "cannot export mesh.txt: its name must end in .rs",
        ),
        (
            "tent.rs --export mesh.rs --dump ./mesh.rs",
            "--dump and --export are both mesh.rs",
        ),
        ("--export mesh.rs", "<MODEL>"),
        ("plain.obj --mesh short", "--export"),
    ] {
        refused(&directory, arguments, &[says]);
    }
    assert_eq!(fs::read_to_string(directory.join("tent.rs")).unwrap(), OBJ);
    assert_eq!(fs::read_to_string(directory.join("tent.bmp")).unwrap(), MTL);
}
