// Written by the simulator of the crate fixel (--export).

static FACES: [[::fixel::Index; 3]; 6] = [
    [0, 1, 2], [1, 3, 2], [3, 4, 2], [4, 0, 2], [4, 3, 1], [4, 1, 0],
];

static EDGES: [[::fixel::Index; 2]; 8] = [
    [0, 1], [0, 2], [0, 4], [1, 2], [1, 3], [2, 3], [2, 4], [3, 4],
];

static POSITIONS: [[i16; 3]; 5] = [
    [-16384, 0, 16384], [16384, 0, 16384], [1802, 25068, 0], [16384, 0, -16384], [-16384, 0, -16384],
];

static NORMAL_FACES: [[::fixel::Index; 3]; 6] = [
    [0, 0, 0], [1, 1, 1], [2, 2, 2], [3, 3, 3], [4, 4, 4], [4, 4, 4],
];

static UV_FACES: [[::fixel::Index; 3]; 6] = [
    [0, 1, 2], [0, 1, 2], [0, 1, 2], [0, 1, 2], [65535, 65535, 65535], [65535, 65535, 65535],
];

static NORMALS: [[i8; 3]; 5] = [
    [0, 95, 127], [127, 95, 0], [0, 95, -127], [-127, 95, 0], [0, -127, 0],
];

static UVS: [[u16; 2]; 3] = [
    [0, 62041], [61681, 62041], [22822, 0],
];

/// The mesh.
#[allow(long_running_const_eval)]
pub static MESH: ::fixel::mesh::Quantized<'static> = {
    let mesh = ::fixel::Mesh::checked(::fixel::Mesh::short(&POSITIONS, 14, &FACES));
    let mesh = ::fixel::Mesh::checked(mesh.with_edges(&EDGES));
    ::fixel::mesh::Quantized::checked(::fixel::mesh::Quantized::new(
        mesh,
        (&NORMALS, &NORMAL_FACES),
        (::fixel::mesh::flash::StoredUvs::Words(&UVS), &UV_FACES),
        ::fixel::mesh::flash::UvGrid::around(&[::fixel::Vec2::from_bits([0, 304087]), ::fixel::Vec2::from_bits([1048576, 1048576])], 65535),
    ))
};

/// The mesh's materials.
pub static PARTS: [::fixel::mesh::Part<'static>; 2] = [
    ::fixel::mesh::Part::new(0..4, ::embedded_graphics::pixelcolor::Rgb888::new(255, 255, 255))
        .with_material("canvas")
        .with_texture("stripes.png"),
    ::fixel::mesh::Part::new(4..6, ::embedded_graphics::pixelcolor::Rgb888::new(51, 102, 153))
        .with_material("ground sheet"),
];
