//! A mesh in a draw call: where it is placed, and what it lacks.

use core::cell::{Cell, OnceCell};
use core::ops::AddAssign;

use embedded_graphics::pixelcolor::{Rgb888, RgbColor};

use super::{CornerCache, Indices, Mesh, Primitive};
use crate::math::{Direction, NormalMatrix, Transform, Vec2, Vec3};

/// A mesh, where a draw call places it, and which attributes the shader asked for but the mesh lacks.
#[derive(Clone, Debug)]
pub(crate) struct Placement<'a> {
    pub(crate) mesh: &'a Mesh<'a>,
    /// The transform from model space to world space.
    pub(super) model: &'a Transform,
    /// The transform from model space to eye space.
    pub(super) view: Transform,
    /// The matrix for normals; computed when a shader first asks for a normal.
    normals: OnceCell<NormalMatrix>,
    pub(crate) missing: Cell<Missing>,
    /// Where an effect of the shader keeps what it computes at corners.
    pub(crate) corners: Option<&'a CornerCache>,
}

/// Lists that a draw call needed but the mesh does not have; the call returns this value as
/// [`Drawn::missing`](crate::Drawn::missing).
///
/// Without texture coordinates, a mesh shows a single texel everywhere; without colors, it is white; without edges,
/// [`Mesh::edges`] draws nothing. None of these is an error, because a program may do it on purpose.
///
/// ```
/// use embedded_graphics::pixelcolor::Gray8;
/// use fixel::prelude::*;
/// static SKIN: [[Gray8; 2]; 1] = [[Gray8::new(10), Gray8::new(20)]];
/// let positions = [vec3!(-1, -1, -2), vec3!(1, -1, -2), vec3!(0, 1, -2)];
/// let bare = Mesh::new(&positions, &[[0, 1, 2]])?;
/// let projection = Projection::perspective(deg!(60), (4, 3), fx!(0.5), fx!(50))?;
/// let mut pixels = [Gray8::new(0); 12];
/// let mut canvas = Canvas::new(&mut pixels, 4, 3)?;
/// let drawn = canvas.draw(&bare, &projection, &Textured::new(&SKIN));
/// assert!(drawn.missing.uvs);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
#[repr(align(4))] // copied as one word
pub struct Missing {
    /// Texture coordinates are missing; (0, 0) was used instead.
    pub uvs: bool,
    /// Colors are missing; white was used instead.
    pub colors: bool,
    /// Edges are missing, so [`Mesh::edges`] drew nothing. [`Mesh::with_edges`] adds edges to a mesh. Meshes of `shape!`
    /// and `include_mesh!` have edges; an [`Outline`](super::Outline) finds the edges of any mesh.
    pub edges: bool,
}

impl AddAssign for Missing {
    #[inline]
    fn add_assign(&mut self, other: Self) {
        self.uvs |= other.uvs;
        self.colors |= other.colors;
        self.edges |= other.edges;
    }
}

impl<'a> Placement<'a> {
    #[inline]
    pub(crate) fn new(mesh: &'a Mesh<'a>, model: &'a Transform, view: Transform) -> Self {
        Self {
            mesh,
            model,
            view,
            normals: OnceCell::new(),
            missing: Cell::default(),
            corners: None,
        }
    }

    /// A triangle, edge or point of the mesh, with twice its area on the screen.
    #[inline]
    pub(crate) const fn primitive(&self, indices: Indices, area: i64) -> Primitive<'_> {
        Primitive {
            placement: self,
            indices,
            area: (area >> 32) as i32,
            slope_beside: 0,
            entry: 0,
        }
    }

    /// The direction in world space of a normal in model space.
    pub(super) fn direction(&self, normal: Vec3) -> Direction {
        // This code does not call `get_or_init`, because that function has a panic path for reentrant initialization.
        if let Some(matrix) = self.normals.get() {
            return matrix.direction(normal);
        }
        let matrix = self.model.normal_matrix();
        let _ = self.normals.set(matrix);
        matrix.direction(normal)
    }

    /// Notes attributes that a shader asked for and the mesh lacks.
    #[inline]
    pub(crate) fn miss(&self, missing: Missing) {
        let mut all = self.missing.get();
        all += missing;
        self.missing.set(all);
    }

    /// Notes that there are no edges to draw.
    #[cold]
    pub(crate) fn lacks_edges(&self) {
        let mut missing = self.missing.get();
        missing.edges = true;
        self.missing.set(missing);
    }

    #[cold]
    pub(super) fn lacks_uvs(&self) -> Vec2 {
        let mut missing = self.missing.get();
        missing.uvs = true;
        self.missing.set(missing);
        Vec2::default()
    }

    #[cold]
    pub(super) fn lacks_colors(&self) -> Rgb888 {
        let mut missing = self.missing.get();
        missing.colors = true;
        self.missing.set(missing);
        Rgb888::WHITE
    }
}
