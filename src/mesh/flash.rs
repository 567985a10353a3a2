//! Meshes built at compile time: the code that [`include_obj!`](crate::include_obj) and [`shape!`](crate::shape) share.

pub use embedded_graphics::pixelcolor::Rgb888;

pub use super::quantized::{StoredUvs, UvGrid, short_normal};
use super::{Buffers, Index, Mesh};
pub use crate::message::checked;
use crate::{Vec2, Vec3};

/// Lists with room for `N` elements each.
#[derive(Clone, Copy, Debug)]
pub struct Room<const N: usize> {
    pub positions: [Vec3; N],
    pub faces: [[Index; 3]; N],
    pub edges: [[Index; 2]; N],
    pub uvs: [Vec2; N],
    pub uv_faces: [[Index; 3]; N],
    pub normals: [Vec3; N],
    pub normal_faces: [[Index; 3]; N],
    pub colors: [Rgb888; N],
}

impl<const N: usize> Room<N> {
    pub const EMPTY: Self = Self {
        positions: [Vec3::ZERO; N],
        faces: [[0; 3]; N],
        edges: [[0; 2]; N],
        uvs: [Vec2::ZERO; N],
        uv_faces: [[0; 3]; N],
        normals: [Vec3::ZERO; N],
        normal_faces: [[0; 3]; N],
        colors: [Rgb888::new(0, 0, 0); N],
    };

    /// All lists, to be filled.
    #[must_use]
    pub const fn buffers(&mut self) -> Buffers<'_> {
        Buffers {
            positions: &mut self.positions,
            faces: &mut self.faces,
            edges: &mut self.edges,
            uvs: &mut self.uvs,
            uv_faces: &mut self.uv_faces,
            normals: &mut self.normals,
            normal_faces: &mut self.normal_faces,
            colors: &mut self.colors,
        }
    }
}

/// The first elements of a list, as many as the result's length says.
///
/// # Panics
///
/// If the list is shorter. Only the macros call this function, at compile time.
#[must_use]
pub const fn first<T: Copy, const N: usize>(list: &[T]) -> [T; N] {
    match list.first_chunk() {
        Some(first) => *first,
        None => panic!("a list is shorter than its mesh"),
    }
}

/// The first positions with 16-bit components, and their number of fraction bits.
///
/// # Panics
///
/// If the list is shorter than the result.
#[must_use]
pub const fn shortened<const N: usize>(positions: &[Vec3]) -> ([[i16; 3]; N], u32) {
    let positions: [Vec3; N] = first(positions);
    match Mesh::checked(Mesh::new(&positions, &[])).shortened() {
        Ok(short) => short,
        Err(_) => panic!("a list is shorter than its mesh"),
    }
}

/// The first normals with 8-bit components.
///
/// # Panics
///
/// If the list is shorter than the result; the same holds for the functions below.
#[must_use]
pub const fn normals_of_8<const N: usize>(normals: &[Vec3]) -> [[i8; 3]; N] {
    let mut short = [[0; 3]; N];
    let mut at = 0;
    while at < N {
        short[at] = short_normal(normals[at]);
        at += 1;
    }
    short
}

/// The first texture coordinates in steps of 16 bits, and their grid.
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

/// The first texture coordinates in steps of 8 bits, and their grid.
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

/// A mesh of the first elements in `$room`, as many as `$counts` says, in statics of exactly those lengths. With
/// `short`, positions have 16 bits a component; with `quantized_16` or `quantized_8`, the result is a quantized mesh.
#[doc(hidden)]
#[macro_export]
macro_rules! __mesh {
    ($room:expr, $counts:expr) => {{
        static POSITIONS: [$crate::Vec3; $counts.positions] =
            $crate::mesh::flash::first(&$room.positions);
        $crate::__mesh!($room, $counts, @ $crate::Mesh::new(&POSITIONS, &FACES))
    }};
    ($room:expr, $counts:expr, short) => {{
        #[allow(long_running_const_eval)]
        const SHORT: ([[i16; 3]; $counts.positions], u32) =
            $crate::mesh::flash::shortened(&$room.positions);
        static POSITIONS: [[i16; 3]; $counts.positions] = SHORT.0;
        $crate::__mesh!($room, $counts, @ $crate::Mesh::short(&POSITIONS, SHORT.1, &FACES))
    }};
    ($room:expr, $counts:expr, quantized_8) => {
        $crate::__mesh!($room, $counts, quantized_8 Bytes u8)
    };
    ($room:expr, $counts:expr, quantized_16) => {
        $crate::__mesh!($room, $counts, quantized_16 Words u16)
    };
    ($room:expr, $counts:expr, $quantized:ident $list:ident $step:ty) => {{
        use $crate::mesh::flash::{self, StoredUvs, UvGrid};
        #[allow(long_running_const_eval)]
        const STORED: ([[$step; 2]; $counts.uvs], UvGrid) = flash::$quantized(&$room.uvs);
        static STORED_UVS: [[$step; 2]; $counts.uvs] = STORED.0;
        #[allow(long_running_const_eval)]
        static STORED_NORMALS: [[i8; 3]; $counts.normals] = flash::normals_of_8(&$room.normals);
        static UV_INDICES: [[$crate::Index; 3]; $counts.uv_faces] = flash::first(&$room.uv_faces);
        static NORMAL_INDICES: [[$crate::Index; 3]; $counts.normal_faces] =
            flash::first(&$room.normal_faces);
        static QUANTIZED: $crate::mesh::Quantized<'static> =
            $crate::mesh::Quantized::checked($crate::mesh::Quantized::new(
                $crate::__mesh!($room, $counts, short).without_uvs().without_normals(),
                (&STORED_NORMALS, &NORMAL_INDICES),
                (StoredUvs::$list(&STORED_UVS), &UV_INDICES),
                STORED.1,
            ));
        QUANTIZED
    }};
    ($room:expr, $counts:expr, $other:ident) => {
        ::core::compile_error!(
            "the last argument must be `short`, `quantized_16`, `quantized_8` or nothing"
        )
    };
    ($room:expr, $counts:expr, @ $mesh:expr) => {{
        use $crate::mesh::flash::first;
        static FACES: [[$crate::Index; 3]; $counts.faces] = first(&$room.faces);
        static EDGES: [[$crate::Index; 2]; $counts.edges] = first(&$room.edges);
        static UVS: [$crate::Vec2; $counts.uvs] = first(&$room.uvs);
        static UV_FACES: [[$crate::Index; 3]; $counts.uv_faces] = first(&$room.uv_faces);
        static NORMALS: [$crate::Vec3; $counts.normals] = first(&$room.normals);
        static NORMAL_FACES: [[$crate::Index; 3]; $counts.normal_faces] = first(&$room.normal_faces);
        static COLORS: [$crate::mesh::flash::Rgb888; $counts.colors] = first(&$room.colors);
        #[allow(long_running_const_eval)]
        static MESH: $crate::Mesh<'static> = $crate::Mesh::checked(
            $crate::Mesh::checked($mesh).with_lists(
                &EDGES,
                (&UVS, &UV_FACES),
                (&NORMALS, &NORMAL_FACES),
                &COLORS,
            ),
        );
        MESH
    }};
}
