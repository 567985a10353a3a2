//! The measured cases: meshes with their transforms and projections, for the crate and for the model.

use fixel::prelude::*;
use fixel::view::Perspective;

use super::Result;
use super::surface::Surface;
use support::reference::linear::{IDENTITY, Matrix};
use support::reference::projection::focal;
use support::reference::view::{View, Viewport};

/// A case: a set of drawings that are measured together.
pub struct Case {
    pub name: &'static str,
    /// The width and height of the frame.
    pub size: (u32, u32),
    pub surface: Surface,
    /// The base-2 logarithm of the side, in texels, of the texture that errors refer to.
    pub texels_log2: u32,
    /// Whether an attribute is interpolated, besides depth.
    pub interpolates: bool,
    /// The drawings. Each has its own frame.
    pub shots: Vec<Shot>,
}

/// One drawing.
pub struct Shot {
    body: Body,
    pub mvp: Mvp<Perspective>,
    /// The model's view of the same scene.
    pub view: View,
}

enum Body {
    Still(&'static Mesh<'static>),
    Made(Triangles),
}

impl Shot {
    /// Makes a drawing of a mesh and its transform to eye space, in the numbers of the crate and of the model.
    pub fn of_mesh(
        mesh: &'static Mesh<'static>,
        mvp: Mvp<Perspective>,
        eye: Matrix,
        projection: FocalProjection,
    ) -> Self {
        Self {
            body: Body::Still(mesh),
            mvp,
            view: projection.view(eye),
        }
    }

    /// Makes a drawing of triangles that are already in eye space, with the projection that shows them.
    pub fn of_triangles(triangles: Triangles, projection: FocalProjection) -> Result<Self> {
        Ok(Self {
            body: Body::Made(triangles),
            mvp: projection.mvp()?,
            view: projection.view(IDENTITY),
        })
    }

    pub fn mesh(&self) -> Result<Mesh<'_>> {
        Ok(match &self.body {
            Body::Still(mesh) => **mesh,
            Body::Made(made) => {
                Mesh::new(&made.positions, &made.faces)?.with_uvs(&made.uvs, None)?
            }
        })
    }
}

/// A projection defined by its focal length in pixels.
#[derive(Clone, Copy, Debug)]
pub struct FocalProjection {
    pub focal: f64,
    pub size: (u32, u32),
    pub near: f64,
    pub far: f64,
}

impl FocalProjection {
    fn mvp(self) -> Result<Mvp<Perspective>> {
        let Self {
            focal,
            size,
            near,
            far,
        } = self;
        let projection = Projection::from_focal_length(
            Scalar::try_from(focal)?,
            size,
            Scalar::try_from(near)?,
            Scalar::try_from(far)?,
        );
        Ok(projection?.into())
    }

    fn view(self, eye: Matrix) -> View {
        View {
            eye,
            projection: focal(self.focal, self.size, self.near, self.far),
            viewport: Viewport::new(self.size.0, self.size.1),
        }
    }

    /// Returns the point of eye space at a position on the screen and a distance `w`.
    pub fn point(self, [x, y]: [f64; 2], w: f64) -> [f64; 3] {
        let [cx, cy] = [self.size.0, self.size.1].map(|size| f64::from(size) / 2.);
        let scale = w / self.focal;
        [(x - cx) * scale, (cy - y) * scale, -w]
    }
}

/// A corner as it must appear: its position on the screen in pixels, its distance, and its u and v.
#[derive(Clone, Copy, Debug)]
pub struct Corner {
    pub at: [f64; 2],
    pub w: f64,
    pub uv: [f64; 2],
}

/// Triangles in eye space, in the crate's numbers.
#[derive(Clone, Debug, Default)]
pub struct Triangles {
    positions: Vec<Vec3>,
    faces: Vec<[u16; 3]>,
    uvs: Vec<Vec2>,
}

impl Triangles {
    /// Adds a convex polygon as a fan of triangles.
    pub fn add(&mut self, projection: FocalProjection, corners: &[Corner]) -> Result<()> {
        let first = u16::try_from(self.positions.len())?;
        for corner in corners {
            let [x, y, z] = projection.point(corner.at, corner.w);
            self.positions.push(Vec3::new(
                Scalar::try_from(x)?,
                Scalar::try_from(y)?,
                Scalar::try_from(z)?,
            ));
            let [u, v] = corner.uv;
            self.uvs
                .push(Vec2::new(TexCoord::try_from(u)?, TexCoord::try_from(v)?));
        }
        for second in 1..u16::try_from(corners.len())? - 1 {
            self.faces.push([first, first + second, first + second + 1]);
        }
        Ok(())
    }
}
