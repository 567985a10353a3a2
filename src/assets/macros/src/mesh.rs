//! `include_mesh!` and `include_materials!`.

use fixel_assets::{Disk, Image, Lists, Material, Model, Notes, Options};

use crate::arguments::Arguments;
use crate::expansion::Expansion;

/// The formats in which a mesh can store its lists, except the default format.
const FORMATS: [&str; 3] = ["quantized", "quantized_16", "quantized_8"];

/// The options that choose the faces of the mesh and their order, and its place, scale and axes.
const COMMON: [&str; 6] = ["object", "part", "file_order", "center", "scale", "up"];

/// Reads the model. Tells the compiler on which files the expansion depends.
fn read(arguments: &Arguments, expansion: &mut Expansion) -> Result<Model, String> {
    let model = fixel_assets::read(&arguments.path.path, &Disk)?;
    expansion.depend(std::slice::from_ref(&arguments.path.path));
    expansion.depend(&model.files);
    Ok(model)
}

/// Converts the macro's options into options of the reader.
fn options(arguments: &Arguments) -> Result<Options, String> {
    let z_up = match arguments.value("up") {
        None => fixel_assets::Format::of(&arguments.path.path) == Some(fixel_assets::Format::Stl),
        Some("y") => false,
        Some("z") => true,
        Some(other) => return Err(format!("up is {other}: it must be y or z")),
    };
    let scale = arguments.number("scale")?.unwrap_or(1.0);
    if scale == 0.0 {
        return Err("scale is 0: the mesh would be a point".into());
    }
    Ok(Options {
        center: arguments.has("center"),
        scale,
        z_up,
        part: arguments.text("part")?,
        object: arguments.text("object")?,
        file_order: arguments.has("file_order"),
        ..Options::default()
    })
}

/// All bytes of a list, in little-endian order. `bytes` converts one number.
fn bytes<T: Copy, const N: usize, const SIZE: usize>(
    list: &[[T; N]],
    bytes: impl Fn(T) -> [u8; SIZE],
) -> Vec<u8> {
    list.iter().flatten().flat_map(|&x| bytes(x)).collect()
}

pub fn mesh(arguments: &Arguments) -> Result<Expansion, String> {
    arguments.check(&[&FORMATS[..], &["normals", "uvs"], &COMMON].concat())?;
    let formats: Vec<&str> = FORMATS
        .into_iter()
        .filter(|format| arguments.has(format))
        .collect();
    if formats.len() > 1 {
        return Err(format!("{} cannot be used together", formats.join(" and ")));
    }
    let mut expansion = Expansion::default();
    let mut model = read(arguments, &mut expansion)?;
    if arguments.has("normals") {
        model.make_normals();
    }
    if arguments.has("uvs") {
        model.make_uvs();
    }
    let options = options(arguments)?;
    if let Some(note) = model.merging(options.scale) {
        model.notes.add(note);
    }
    let lists = model.lists(&options)?;
    if let Some(far) = &lists.far {
        let has_names = model.objects.len() + model.materials.len() > 1;
        model.notes.add(if has_names {
            format!("{far}, or name what to keep: object = \"name\" or part = \"name\"")
        } else {
            far.clone()
        });
    }
    expansion.note(&arguments.path.value, &model.notes);
    write(&mut expansion, &lists, formats.first().copied());
    Ok(expansion)
}

pub fn outline(arguments: &Arguments) -> Result<Expansion, String> {
    arguments.check(&[&["crease"], &COMMON[..]].concat())?;
    let crease = arguments.number("crease")?.unwrap_or(30.0);
    if !(0.0..=180.0).contains(&crease) {
        return Err(format!(
            "crease is {crease}: it must lie between 0 and 180 degrees"
        ));
    }
    let mut expansion = Expansion::default();
    let model = read(arguments, &mut expansion)?;
    let (edges, creases) = model.lists(&options(arguments)?)?.outline(crease);
    let list = expansion.bytes(bytes(&edges, u16::to_le_bytes));
    expansion.push(&format!(
        "#[allow(long_running_const_eval)] static EDGES: [[fixel::Index; 4]; {}] = fixel::mesh::flash::outline_edges({list});
         fixel::Outline::of(&EDGES, {creases})",
        edges.len(),
    ));
    Ok(expansion)
}

/// The least and the greatest coordinates of some positions; 0 if there are none.
fn bounds<T: Copy + Default + Ord + Into<i32>>(positions: &[[T; 3]]) -> [[i32; 3]; 2] {
    let of = |axis: usize| positions.iter().map(move |position| position[axis]);
    [
        [0, 1, 2].map(|axis| of(axis).min().unwrap_or_default().into()),
        [0, 1, 2].map(|axis| of(axis).max().unwrap_or_default().into()),
    ]
}

/// Writes the statics of a mesh.
fn write(out: &mut Expansion, lists: &Lists, format: Option<&str>) {
    let mut list = |name: &str, kind: &str, reader: &str, count: usize, bytes: Vec<u8>| {
        let bytes = out.bytes(bytes);
        out.push(&format!(
            "#[allow(long_running_const_eval)] static {name}: [{kind}; {count}] = fixel::mesh::flash::{reader}({bytes});"
        ));
    };
    let index = "[fixel::Index; 3]";
    let mut indices = |name: &str, faces: &[[u16; 3]]| {
        list(
            name,
            index,
            "faces",
            faces.len(),
            bytes(faces, u16::to_le_bytes),
        );
    };
    indices("FACES", &lists.faces);
    indices("UV_FACES", &lists.uv_faces);
    indices("NORMAL_FACES", &lists.normal_faces);
    indices("COLOR_FACES", &lists.color_faces);
    list(
        "EDGES",
        "[fixel::Index; 2]",
        "edges",
        lists.edges.len(),
        bytes(&lists.edges, u16::to_le_bytes),
    );
    list(
        "COLORS",
        "fixel::mesh::flash::Rgb888",
        "colors",
        lists.colors.len(),
        lists.colors.concat(),
    );
    // The bits of the least and the greatest coordinates, as they are stored.
    let mut bounds = bounds(&lists.positions);
    let positions = if format.is_none() {
        let positions = bytes(&lists.positions, i32::to_le_bytes);
        list(
            "POSITIONS",
            "fixel::Vec3",
            "vec3s",
            lists.positions.len(),
            positions,
        );
        "fixel::mesh::Positions::long(&POSITIONS)".to_string()
    } else {
        let (positions, fraction) = lists.quantized_positions();
        bounds =
            self::bounds(&positions).map(|corner| corner.map(|units| units << (16 - fraction)));
        list(
            "POSITIONS",
            "[i16; 3]",
            "shorts",
            positions.len(),
            bytes(&positions, i16::to_le_bytes),
        );
        format!(
            "fixel::mesh::flash::checked(fixel::mesh::Positions::quantized(&POSITIONS, {fraction}), \"mesh\")"
        )
    };
    let [least, most] = bounds;
    let with_bounds = format!(
        ".with_bounds(fixel::mesh::Bounds::new(fixel::Vec3::from_bits({least:?}), fixel::Vec3::from_bits({most:?})))"
    );
    let uvs = bytes(&lists.uvs, i32::to_le_bytes);
    let normals = bytes(&lists.normals, i32::to_le_bytes);
    let (uv_count, normal_count) = (lists.uvs.len(), lists.normals.len());
    match format {
        None | Some("quantized") => {
            list("UVS", "fixel::Vec2", "vec2s", uv_count, uvs);
            list("NORMALS", "fixel::Vec3", "vec3s", normal_count, normals);
            out.push(&format!(
                "static MESH: fixel::Mesh<'static> = fixel::Mesh::of_lists({positions}, (&FACES, &EDGES), \
                 (&UVS, &UV_FACES), (&NORMALS, &NORMAL_FACES), (&COLORS, &COLOR_FACES)){with_bounds};\nMESH"
            ));
        }
        Some(format) => {
            let (step, small) = if format == "quantized_8" {
                ("u8", "uvs_of_8")
            } else {
                ("u16", "uvs_of_16")
            };
            let (uvs, normals) = (out.bytes(uvs), out.bytes(normals));
            out.push(&format!(
                "use fixel::mesh::flash as assets;
                 #[allow(long_running_const_eval)]
                 const STORED: ([[{step}; 2]; {uv_count}], assets::UvGrid) =
                     assets::{format}(&assets::vec2s::<{uv_count}>({uvs}));
                 static UVS: [[{step}; 2]; {uv_count}] = STORED.0;
                 static SMALL_UVS: assets::Small<'static, fixel::Vec2> = assets::Small::{small}(&UVS, STORED.1);
                 #[allow(long_running_const_eval)]
                 static NORMALS: [[i8; 3]; {normal_count}] =
                     assets::normals_of_8(&assets::vec3s::<{normal_count}>({normals}));
                 static SMALL_NORMALS: assets::Small<'static, fixel::Vec3> = assets::Small::normals(&NORMALS);
                 fixel::Mesh::of_lists({positions}, (&FACES, &EDGES), (&[], &[]), (&[], &[]), (&COLORS, &COLOR_FACES))
                     .with_quantized_attributes((&SMALL_NORMALS, &NORMAL_FACES), (&SMALL_UVS, &UV_FACES)){with_bounds}"
            ));
        }
    }
}

pub fn materials(arguments: &Arguments) -> Result<Expansion, String> {
    arguments.check(&[])?;
    let mut expansion = Expansion::default();
    let mut model = read(arguments, &mut expansion)?;
    // The mesh of the same file has the model's other notes.
    model.notes = Notes::default();
    model.find_textures(&Disk);
    expansion.note(&arguments.path.value, &model.notes);
    let parts: Vec<String> = model
        .runs()
        .into_iter()
        .map(|run| {
            let [start, end] = run.faces;
            let material = run.material.and_then(|at| model.materials.get(at as usize));
            let plain = Material::new(String::new());
            let material = material.unwrap_or(&plain);
            let texture = material.texture.and_then(|at| {
                match model.images.get(at as usize)? {
                    Image::File(path) => Some(path.file_name()?.to_string_lossy().into_owned()),
                    Image::Bytes(name, _) => Some(name.clone()),
                    Image::Glowing { .. } => Some(format!("image-{at}")),
                }
            });
            let rgb = |[r, g, b]: [u8; 3]| format!("fixel::mesh::flash::Rgb888::new({r}, {g}, {b})");
            let (color, emission) = (rgb(material.color), rgb(material.emission));
            #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // saturates
            let opacity = (material.opacity * 255.0).round() as u8;
            let (name, alpha, two_sided) = (&material.name, material.alpha, material.two_sided);
            let (clamp, unlit) = (material.clamp, material.unlit);
            format!(
                "fixel::mesh::Part::new({start}..{end}, fixel::mesh::Material {{
                     name: {name:?}, color: {color}, texture: ::core::option::Option::{texture:?},
                     alpha: fixel::mesh::TextureAlpha::{alpha:?}, opacity: {opacity}, emission: {emission},
                     two_sided: {two_sided}, clamp: {clamp:?}, unlit: {unlit},
                 }})"
            )
        })
        .collect();
    expansion.push(&format!(
        "static PARTS: [fixel::mesh::Part<'static>; {}] = [{}]; PARTS.as_slice()",
        parts.len(),
        parts.join(", ")
    ));
    Ok(expansion)
}
