//! Meshes built at compile time: the code that [`shape!`](crate::shape) and the macros for files expand to.

pub use embedded_graphics::pixelcolor::Rgb888;

pub use super::attribute::{Small, UvGrid, normal_of_8};
use super::{Buffers, Index, Mesh};
use crate::math::{Vec2, Vec3};
pub use crate::message::checked;

/// Lists with room for `N` elements each.
#[derive(Clone, Copy, Debug)]
pub struct Room<const N: usize> {
    pub positions: [Vec3; N],
    pub faces: [[Index; 3]; N],
    pub edges: [[Index; 2]; N],
    pub uvs: [Vec2; N],
    pub normals: [Vec3; N],
}

impl<const N: usize> Room<N> {
    pub const EMPTY: Self = Self {
        positions: [Vec3::ZERO; N],
        faces: [[0; 3]; N],
        edges: [[0; 2]; N],
        uvs: [Vec2::ZERO; N],
        normals: [Vec3::ZERO; N],
    };

    /// All lists, for a shape to fill.
    #[must_use]
    pub const fn buffers(&mut self) -> Buffers<'_> {
        Buffers {
            positions: &mut self.positions,
            faces: &mut self.faces,
            edges: &mut self.edges,
            uvs: &mut self.uvs,
            normals: &mut self.normals,
        }
    }
}

/// The first `N` elements of a list.
///
/// # Panics
///
/// If the list has fewer than `N` elements. Only the macros call this function, at compile time.
#[must_use]
pub const fn first<T: Copy, const N: usize>(list: &[T]) -> [T; N] {
    match list.first_chunk() {
        Some(first) => *first,
        None => panic!("a list is shorter than its mesh"),
    }
}

/// The first `N` positions with 16-bit components, and their number of fraction bits.
///
/// # Panics
///
/// If the list has fewer than `N` elements.
#[must_use]
pub const fn quantized_positions<const N: usize>(positions: &[Vec3]) -> ([[i16; 3]; N], u32) {
    let positions: [Vec3; N] = first(positions);
    match Mesh::checked(Mesh::new(&positions, &[])).quantized_positions() {
        Ok(quantized) => quantized,
        Err(_) => panic!("a list is shorter than its mesh"),
    }
}

/// The first `N` normals with 8-bit components.
///
/// # Panics
///
/// If the list has fewer than `N` elements. `quantized_16` and `quantized_8` panic in the same case.
#[must_use]
pub const fn normals_of_8<const N: usize>(normals: &[Vec3]) -> [[i8; 3]; N] {
    let mut short = [[0; 3]; N];
    let mut at = 0;
    while at < N {
        short[at] = normal_of_8(normals[at]);
        at += 1;
    }
    short
}

/// The first `N` texture coordinates as 16-bit steps of a grid, and the grid.
#[must_use]
pub const fn quantized_16<const N: usize>(uvs: &[Vec2]) -> ([[u16; 2]; N], UvGrid) {
    let uvs: [Vec2; N] = first(uvs);
    let grid = UvGrid::around(&uvs, u16::MAX);
    let mut steps = [[0; 2]; N];
    let mut at = 0;
    while at < N {
        steps[at] = grid.nearest(uvs[at]);
        at += 1;
    }
    (steps, grid)
}

/// The first `N` texture coordinates as 8-bit steps of a grid, and the grid.
#[must_use]
pub const fn quantized_8<const N: usize>(uvs: &[Vec2]) -> ([[u8; 2]; N], UvGrid) {
    let uvs: [Vec2; N] = first(uvs);
    let grid = UvGrid::around(&uvs, u8::MAX as u16);
    let mut steps = [[0; 2]; N];
    let mut at = 0;
    while at < N {
        let [u, v] = grid.nearest(uvs[at]);
        steps[at] = [u as u8, v as u8];
        at += 1;
    }
    (steps, grid)
}

/// Makes lists from the little-endian bytes of their elements. The macros that read files write lists as bytes, because
/// the compiler reads bytes several times as fast as numbers. The functions use only patterns and operators. At compile
/// time, reading an element by its index takes as long as several operators, and a call takes as long as ten.
///
/// # Panics
///
/// If there are more than `N` elements. Only the macros call these functions, at compile time.
macro_rules! lists {
    ($($name:ident: [$element:ty] = $first:expr, [$($byte:ident)+] => $value:expr;)+) => {$(
        #[must_use]
        #[allow(clippy::cast_possible_wrap)] // the casts are intended, and a call of cast_signed takes long
        pub const fn $name<const N: usize>(bytes: &[u8]) -> [$element; N] {
            let mut list = [$first; N];
            let mut rest = bytes;
            let mut at = 0;
            while let &[$($byte,)+ ref others @ ..] = rest {
                list[at] = $value;
                rest = others;
                at += 1;
            }
            list
        }
    )+};
    // An integer of two bytes, and a signed integer of four bytes.
    ($a:ident $b:ident) => {
        $a as u16 | ($b as u16) << 8
    };
    ($a:ident $b:ident $c:ident $d:ident) => {
        ($a as u32 | ($b as u32) << 8 | ($c as u32) << 16 | ($d as u32) << 24) as i32
    };
}

lists! {
    edges: [[Index; 2]] = [0; 2], [a b c d] => [lists!(a b), lists!(c d)];
    faces: [[Index; 3]] = [0; 3], [a b c d e f] => [lists!(a b), lists!(c d), lists!(e f)];
    outline_edges: [[Index; 4]] = [0; 4], [a b c d e f g h] =>
        [lists!(a b), lists!(c d), lists!(e f), lists!(g h)];
    shorts: [[i16; 3]] = [0; 3], [a b c d e f] =>
        [(lists!(a b)) as i16, (lists!(c d)) as i16, (lists!(e f)) as i16];
    vec3s: [Vec3] = Vec3::ZERO, [a b c d e f g h i j k l] =>
        Vec3::from_bits([lists!(a b c d), lists!(e f g h), lists!(i j k l)]);
    vec2s: [Vec2] = Vec2::ZERO, [a b c d e f g h] =>
        Vec2::from_bits([lists!(a b c d), lists!(e f g h)]);
    colors: [Rgb888] = Rgb888::new(0, 0, 0), [r g b] => Rgb888::new(r, g, b);
}

/// Makes a mesh of the first elements of each list in `$room`; `$counts` has their numbers. `$own` has the triangles as
/// indices of texture coordinates and of normals, or two empty lists. The other lists of the mesh are statics of exactly
/// these lengths. With `quantized`, positions have 16 bits per component; with `quantized_8`, attributes have fewer bits,
/// too.
#[doc(hidden)]
#[macro_export]
macro_rules! __mesh {
    ($room:expr, $counts:expr, $own:expr) => {{
        static POSITIONS: [$crate::Vec3; $counts.positions] =
            $crate::mesh::flash::first(&$room.positions);
        $crate::__mesh!($room, $counts, $own, @ $crate::mesh::Positions::long(&POSITIONS))
    }};
    ($room:expr, $counts:expr, $own:expr, quantized) => {{
        #[allow(long_running_const_eval)]
        const QUANTIZED: ([[i16; 3]; $counts.positions], u32) =
            $crate::mesh::flash::quantized_positions(&$room.positions);
        static POSITIONS: [[i16; 3]; $counts.positions] = QUANTIZED.0;
        const STORED: $crate::mesh::Positions<'static> = $crate::mesh::flash::checked(
            $crate::mesh::Positions::quantized(&POSITIONS, QUANTIZED.1),
            "mesh",
        );
        $crate::__mesh!($room, $counts, $own, @ STORED)
    }};
    ($room:expr, $counts:expr, $own:expr, quantized_8) => {{
        use $crate::mesh::flash::{self, Small, UvGrid};
        #[allow(long_running_const_eval)]
        const STORED: ([[u8; 2]; $counts.uvs], UvGrid) = flash::quantized_8(&$room.uvs);
        static UVS: [[u8; 2]; $counts.uvs] = STORED.0;
        static SMALL_UVS: Small<'static, $crate::Vec2> = Small::uvs_of_8(&UVS, STORED.1);
        #[allow(long_running_const_eval)]
        static NORMALS: [[i8; 3]; $counts.normals] = flash::normals_of_8(&$room.normals);
        static SMALL_NORMALS: Small<'static, $crate::Vec3> = Small::normals(&NORMALS);
        $crate::__mesh!($room, $counts, $own, quantized)
            .without_uvs()
            .without_normals()
            .with_quantized_attributes((&SMALL_NORMALS, $own[1]), (&SMALL_UVS, $own[0]))
    }};
    ($room:expr, $counts:expr, $own:expr, $other:ident) => {
        ::core::compile_error!("the last argument must be `quantized`, `quantized_8` or nothing")
    };
    ($room:expr, $counts:expr, $own:expr, @ $positions:expr) => {{
        use $crate::mesh::flash::first;
        static FACES: [[$crate::Index; 3]; $counts.faces] = first(&$room.faces);
        static EDGES: [[$crate::Index; 2]; $counts.edges] = first(&$room.edges);
        static UVS: [$crate::Vec2; $counts.uvs] = first(&$room.uvs);
        static NORMALS: [$crate::Vec3; $counts.normals] = first(&$room.normals);
        #[allow(long_running_const_eval)]
        static MESH: $crate::Mesh<'static> = $crate::Mesh::checked(Ok($crate::Mesh::of_lists(
            $positions,
            (&FACES, &EDGES),
            (&UVS, $own[0]),
            (&NORMALS, $own[1]),
            (&[], &[]),
        )));
        MESH
    }};
}
