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

#[allow(long_running_const_eval)]
static NORMALS: [::fixel::Vec3; 5] = {
let bits: [[i32; 3]; 5] = [
    [0, 39322, 52429], [52429, 39322, 0], [0, 39322, -52429], [-52429, 39322, 0], [0, -65536, 0],
];
let mut list = [::fixel::Vec3::ZERO; 5];
let mut at = 0;
while at < 5 {
    list[at] = ::fixel::Vec3::from_bits(bits[at]);
    at += 1;
}
list
};

#[allow(long_running_const_eval)]
static UVS: [::fixel::Vec2; 3] = {
let bits: [[i32; 2]; 3] = [
    [0, 1048576], [1048576, 1048576], [387973, 304087],
];
let mut list = [::fixel::Vec2::ZERO; 3];
let mut at = 0;
while at < 3 {
    list[at] = ::fixel::Vec2::from_bits(bits[at]);
    at += 1;
}
list
};

/// The mesh.
#[allow(long_running_const_eval)]
pub static MESH: ::fixel::Mesh<'static> = {
    let mesh = ::fixel::Mesh::checked(::fixel::Mesh::short(&POSITIONS, 14, &FACES));
    let mesh = ::fixel::Mesh::checked(mesh.with_edges(&EDGES));
    let mesh = ::fixel::Mesh::checked(mesh.with_normals(&NORMALS, Some(&NORMAL_FACES)));
    ::fixel::Mesh::checked(mesh.with_uvs(&UVS, Some(&UV_FACES)))
};

/// The mesh's materials.
pub static PARTS: [::fixel::mesh::Part<'static>; 2] = [
    ::fixel::mesh::Part::new(0..4, ::embedded_graphics::pixelcolor::Rgb888::new(255, 255, 255))
        .with_material("canvas")
        .with_texture("stripes.png"),
    ::fixel::mesh::Part::new(4..6, ::embedded_graphics::pixelcolor::Rgb888::new(51, 102, 153))
        .with_material("ground sheet"),
];
