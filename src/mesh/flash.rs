//! Meshes built at compile time: the code that [`shape!`](crate::shape) and the macros for files expand to.

pub use embedded_graphics::pixelcolor::Rgb888;

pub use super::quantized::{StoredUvs, UvGrid, short_normal};
use super::{Buffers, Index, Mesh, Outline};
pub use crate::message::checked;
use crate::{Vec2, Vec3};

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

    /// All lists, to be filled.
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

/// An outline that the macro has found.
#[must_use]
pub const fn outline(edges: &[[Index; 4]], creases: usize) -> Outline<'_> {
    Outline::of(edges, creases)
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

/// A list of integers from their little-endian bytes: the macros that read files write lists as bytes, because the
/// compiler reads these several times as fast as numbers.
///
/// # Panics
///
/// If the length is wrong. Only the macros call these functions, at compile time.
macro_rules! lists {
    ($($name:ident: [$number:ident; $count:literal] = |$at:ident, $bytes:ident| $value:expr;)+) => {$(
        #[must_use]
        pub const fn $name<const N: usize, const K: usize>($bytes: &[u8]) -> [[$number; K]; N] {
            let mut list = [[0; K]; N];
            let (mut element, mut $at) = (0, 0);
            while element < N {
                let mut component = 0;
                while component < K {
                    list[element][component] = $value;
                    component += 1;
                    $at += $count;
                }
                element += 1;
            }
            list
        }
    )+};
}

lists! {
    words: [u16; 2] = |at, bytes| bytes[at] as u16 | (bytes[at + 1] as u16) << 8;
    signed_words: [i16; 2] = |at, bytes| (bytes[at] as u16 | (bytes[at + 1] as u16) << 8).cast_signed();
}

/// The number of 32 bits at an offset.
macro_rules! bits {
    ($bytes:ident[$at:expr]) => {{
        let at = $at;
        ($bytes[at] as u32
            | ($bytes[at + 1] as u32) << 8
            | ($bytes[at + 2] as u32) << 16
            | ($bytes[at + 3] as u32) << 24)
            .cast_signed()
    }};
}

/// Vectors from the little-endian bytes of their bits.
///
/// # Panics
///
/// As for [`words`]; the same holds for the functions below.
#[must_use]
pub const fn vec3s<const N: usize>(bytes: &[u8]) -> [Vec3; N] {
    let mut list = [Vec3::ZERO; N];
    let mut at = 0;
    while at < N {
        list[at] = Vec3::from_bits([
            bits!(bytes[12 * at]),
            bits!(bytes[12 * at + 4]),
            bits!(bytes[12 * at + 8]),
        ]);
        at += 1;
    }
    list
}

/// Texture coordinates from the little-endian bytes of their bits.
#[must_use]
pub const fn vec2s<const N: usize>(bytes: &[u8]) -> [Vec2; N] {
    let mut list = [Vec2::ZERO; N];
    let mut at = 0;
    while at < N {
        list[at] = Vec2::from_bits([bits!(bytes[8 * at]), bits!(bytes[8 * at + 4])]);
        at += 1;
    }
    list
}

/// Colors from the bytes of red, green and blue.
#[must_use]
pub const fn colors<const N: usize>(bytes: &[u8]) -> [Rgb888; N] {
    let mut list = [Rgb888::new(0, 0, 0); N];
    let mut at = 0;
    while at < N {
        list[at] = Rgb888::new(bytes[3 * at], bytes[3 * at + 1], bytes[3 * at + 2]);
        at += 1;
    }
    list
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
        static QUANTIZED: $crate::mesh::Quantized<'static> =
            $crate::mesh::Quantized::checked($crate::mesh::Quantized::new(
                $crate::__mesh!($room, $counts, short).without_uvs().without_normals(),
                (&STORED_NORMALS, &[]),
                (StoredUvs::$list(&STORED_UVS), &[]),
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
        static NORMALS: [$crate::Vec3; $counts.normals] = first(&$room.normals);
        #[allow(long_running_const_eval)]
        static MESH: $crate::Mesh<'static> = $crate::Mesh::checked(
            $crate::Mesh::checked($mesh).with_lists(
                &EDGES,
                (&UVS, &[]),
                (&NORMALS, &[]),
                (&[], &[]),
            ),
        );
        MESH
    }};
}
