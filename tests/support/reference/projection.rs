//! Projections from eye space to clip space, and the depth at a distance.

use super::linear::{IDENTITY, Matrix, Vec3, Vec4, multiply};

/// The stored depth at the near plane.
pub const DEPTH_MAX: f64 = 65535.;

/// The kind of a projection. The kind determines how depth decreases with distance.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Rays meet in the eye. Homogeneous w is the distance ahead.
    Perspective,
    /// Rays are parallel. Homogeneous w is 1.
    Parallel,
}

/// A projection with its near and far planes.
///
/// Clip space is OpenGL's: −w ≤ x, y, z ≤ w, and the near plane is at z = −w.
#[derive(Clone, Copy, Debug)]
pub struct Projection {
    /// The matrix from eye space to clip space.
    pub matrix: Matrix,
    /// The distance of the near plane.
    pub near: f64,
    /// The distance of the far plane.
    pub far: f64,
    /// Perspective or parallel.
    pub kind: Kind,
}

impl Projection {
    /// The distance of a point in clip space ahead of the eye: −z in eye space.
    pub fn distance(&self, clip: Vec4) -> f64 {
        match self.kind {
            Kind::Perspective => clip[3],
            // z/w = (2d − (f + n))/(f − n), solved for d.
            Kind::Parallel => f64::midpoint(
                (self.far - self.near) * clip[2] / clip[3],
                self.far + self.near,
            ),
        }
    }

    /// The depth at the distance d ahead, before it is rounded down to a u16. At the near plane, the depth is 65535.
    /// The depth decreases with the distance: 65535·n/d in perspective, 65535·(f − d)/(f − n) for parallel rays.
    pub fn depth(&self, distance: f64) -> f64 {
        match self.kind {
            Kind::Perspective => DEPTH_MAX * self.near / distance,
            Kind::Parallel => DEPTH_MAX * (self.far - distance) / (self.far - self.near),
        }
    }

    /// The distance at which a surface has this depth. The inverse of [`depth`](Self::depth).
    pub fn distance_at_depth(&self, depth: f64) -> f64 {
        match self.kind {
            Kind::Perspective => DEPTH_MAX * self.near / depth,
            Kind::Parallel => self.far - depth / DEPTH_MAX * (self.far - self.near),
        }
    }
}

/// An off-center perspective projection, as in OpenGL, from the left, right, bottom and top of the window on the near
/// plane, and the distances of the near and far planes.
pub fn frustum(l: f64, r: f64, b: f64, t: f64, n: f64, f: f64) -> Projection {
    Projection {
        matrix: [
            [2. * n / (r - l), 0., (r + l) / (r - l), 0.],
            [0., 2. * n / (t - b), (t + b) / (t - b), 0.],
            [0., 0., -(f + n) / (f - n), -2. * f * n / (f - n)],
            [0., 0., -1., 0.],
        ],
        near: n,
        far: f,
        kind: Kind::Perspective,
    }
}

/// Left, right, bottom and top of the window on the near plane, for a vertical field of view in radians and the aspect
/// ratio width/height.
pub fn window(fov: f64, aspect: f64, near: f64) -> [f64; 4] {
    let top = near * (fov / 2.).tan();
    let right = top * aspect;
    [-right, right, -top, top]
}

/// A symmetric perspective projection. `fov` is the vertical field of view in radians, `aspect` is width/height.
pub fn perspective(fov: f64, aspect: f64, near: f64, far: f64) -> Projection {
    let [l, r, b, t] = window(fov, aspect, near);
    frustum(l, r, b, t, near, far)
}

/// A symmetric perspective projection from a focal length in pixels, for a picture of width x height pixels: screen x =
/// width/2 + focal·x/−z.
pub fn focal(focal: f64, size: (u32, u32), near: f64, far: f64) -> Projection {
    let right = near * f64::from(size.0) / (2. * focal);
    let top = near * f64::from(size.1) / (2. * focal);
    frustum(-right, right, -top, top, near, far)
}

/// A parallel projection along −z. The projection maps the box between the six planes to the cube from −1 to 1.
pub fn orthographic(l: f64, r: f64, b: f64, t: f64, n: f64, f: f64) -> Projection {
    Projection {
        matrix: [
            [2. / (r - l), 0., 0., -(r + l) / (r - l)],
            [0., 2. / (t - b), 0., -(t + b) / (t - b)],
            [0., 0., -2. / (f - n), -(f + n) / (f - n)],
            [0., 0., 0., 1.],
        ],
        near: n,
        far: f,
        kind: Kind::Parallel,
    }
}

/// A parallel projection with oblique rays: an orthographic projection after a shear that leaves the plane z = 0 in
/// place.
///
/// A point at distance d moves by d·ratio in the direction of `angle`, and keeps its distance. The angle is in radians,
/// from +x toward +y, so edges recede to the upper right for 0 < angle < π/2.
pub fn oblique(
    angle: f64,
    ratio: f64,
    (l, r, b, t): (f64, f64, f64, f64),
    n: f64,
    f: f64,
) -> Projection {
    let mut shear = IDENTITY;
    shear[0][2] = -ratio * angle.cos();
    shear[1][2] = -ratio * angle.sin();
    let straight = orthographic(l, r, b, t, n, f);
    Projection {
        matrix: multiply(&straight.matrix, &shear),
        ..straight
    }
}

/// An [`oblique`] projection that shows receding edges at their full length.
pub fn cavalier(angle: f64, window: (f64, f64, f64, f64), near: f64, far: f64) -> Projection {
    oblique(angle, 1., window, near, far)
}

/// An [`oblique`] projection that shows receding edges at half of their length.
pub fn cabinet(angle: f64, window: (f64, f64, f64, f64), near: f64, far: f64) -> Projection {
    oblique(angle, 0.5, window, near, far)
}

/// The perspective transform alone. The transform maps x and y to (n·x, n·y)/−z, and −z to (n + f) − nf/−z. z is
/// negative ahead of the eye. Together with an orthographic projection after it, this transform gives a [`frustum`].
pub fn perspective_transform(n: f64, f: f64) -> Matrix {
    [
        [n, 0., 0., 0.],
        [0., n, 0., 0.],
        [0., 0., n + f, n * f],
        [0., 0., -1., 0.],
    ]
}

/// A point projected onto the plane at distance n: (−n x/z, −n y/z); `None` at z = 0.
pub fn project_on_plane(p: Vec3, n: f64) -> Option<[f64; 2]> {
    (p[2] != 0.).then(|| [-n * p[0] / p[2], -n * p[1] / p[2]])
}

/// The point on the plane at distance n where all lines with a direction meet; `None` if they are parallel to the
/// plane.
pub fn vanishing_point(direction: Vec3, n: f64) -> Option<[f64; 2]> {
    project_on_plane(direction, n)
}

/// ∂x'/∂t, where x' is the image of the point P + t·v on the plane at distance n.
pub fn speed(p: Vec3, v: Vec3, t: f64, n: f64) -> f64 {
    -n * (v[0] * p[2] - p[0] * v[2]) / (p[2] + v[2] * t).powi(2)
}
