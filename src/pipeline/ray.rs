//! Picking: a ray, and the face of a mesh that it meets.

use embedded_graphics::geometry::Point;

use crate::error::Error;
use crate::math::{Direction, NormalMatrix, Transform, Vec3};
use crate::mesh::Mesh;
use crate::num::block::{self, BlockFloat};
use crate::num::rsqrt::unit;
use crate::num::wide::{dot, product};
use crate::num::{Fraction, Scalar};
use crate::raster::Cull;
use crate::view::{AsMvp, Viewport};

/// A half-line: the points that are seen at a pixel, or the path of a shot.
///
/// [`Viewport::ray`] makes the ray of a pixel, and [`hit`](Self::hit) finds the face of a mesh that the ray meets first.
///
/// ```
/// use fixel::prelude::*;
/// static BOX: Mesh = shape!(cuboid(vec3!(1, 1, 1)));
/// let shot = Ray::new(vec3!(5, 0.25, 0), vec3!(-1, 0, 0))?;
/// let hit = shot.hit(&BOX).unwrap();
/// assert_eq!((hit.point, hit.distance), (vec3!(1, 0.25, 0), fx!(4)));
/// assert_eq!(shot.at(hit.distance), hit.point);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Ray {
    /// The point where the ray starts.
    pub origin: Vec3,
    /// The direction of the ray.
    pub direction: Direction,
    /// Which faces the ray ignores: none, faces that it meets from behind, or faces that it meets from the front. The
    /// front of a face is the side from which its corners run counter-clockwise.
    pub cull: Cull,
}

/// The place where a ray meets a mesh; [`Ray::hit`] returns it.
///
/// ```
/// use fixel::prelude::*;
/// let positions = [vec3!(0, 0, 0), vec3!(4, 0, 0), vec3!(0, 4, 0)];
/// let triangle = Mesh::new(&positions, &[[0, 1, 2]])?;
/// let hit = Ray::new(vec3!(1, 2, 9), vec3!(0, 0, -1))?.hit(&triangle).unwrap();
/// assert_eq!((hit.face, hit.point, hit.distance), (0, vec3!(1, 2, 0), fx!(9)));
/// assert_eq!(hit.barycentric.map(f64::from), [0.25, 0.25, 0.5]);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Hit {
    /// The index of the face among the mesh's [`faces`](Mesh::faces).
    pub face: usize,
    /// The point where the ray meets the face, in model space. Its error is at most 2⁻²⁹ of the face's size, plus the
    /// rounding to the nearest `Vec3`.
    pub point: Vec3,
    /// The distance of the point from the ray's origin, in the model's units, rounded to nearest; saturates.
    pub distance: Scalar,
    /// The weights of the face's three corners at the point, from 0 to 1, accurate to 2⁻²⁹. Their sum is 1.
    pub barycentric: [Fraction; 3],
}

impl Ray {
    /// A ray in model space that meets both sides of faces. The direction may have any length.
    ///
    /// # Errors
    ///
    /// [`Error::NoDirection`] if the direction is zero.
    pub const fn new(origin: Vec3, direction: Vec3) -> Result<Self, Error> {
        if let [0, 0, 0] = direction.to_bits() {
            return Err(Error::ZERO_DIRECTION);
        }
        Ok(Self {
            origin,
            direction: Direction::of(direction),
            cull: Cull::Nothing,
        })
    }

    /// The point at a distance from the origin, rounded to nearest; saturates.
    #[must_use]
    pub fn at(&self, distance: Scalar) -> Vec3 {
        let along = self.direction.to_bits();
        let moved = along.map(|part| block::fixed(product(part, distance.to_bits()), 30, 0));
        self.origin + Vec3::from_bits(moved)
    }

    /// The face of a mesh that the ray meets first, and the point there; `None` if the ray meets no face.
    ///
    /// Whether the ray meets a face is computed exactly, so a ray never slips through between two faces that share an
    /// edge. If the distances of two faces differ by less than 2⁻²⁹ of the faces' extent, they count as equal. The
    /// later face in the mesh is then returned, because a draw call draws it over the earlier one.
    #[must_use]
    pub fn hit(&self, mesh: &Mesh<'_>) -> Option<Hit> {
        let view = RayView::new(self);
        let mut nearest: Option<(i64, usize, [i32; 3])> = None;
        for (face, indices) in mesh.faces().iter().enumerate() {
            let [a, b, c] = *indices;
            let [a, b, c] = [mesh.position(a), mesh.position(b), mesh.position(c)];
            let corners = [view.see(a), view.see(b), view.see(c)];
            let Some(barycentric) = view.meet(&corners, self.cull) else {
                continue;
            };
            let ([[a, ..], [b, ..], [c, ..]], [of_a, of_b, of_c]) = (corners, barycentric);
            let [a, b, c] = [
                a * i64::from(of_a),
                b * i64::from(of_b),
                c * i64::from(of_c),
            ];
            // The sum is a weighted mean of three numbers of 33 bits, so it is no greater than the greatest of these
            // numbers.
            let ahead = (a + b + c) * view.forward;
            if ahead >= 0 && nearest.is_none_or(|(least, ..)| ahead <= least) {
                nearest = Some((ahead, face, barycentric));
            }
        }
        let (ahead, face, barycentric) = nearest?;
        let [a, b, c] = mesh
            .faces()
            .get(face)?
            .map(|index| mesh.position(index).to_bits());
        let mix = |axis: usize| {
            let at = [a, b, c].map(|corner| corner[axis]);
            block::fixed(dot(&barycentric, &at), 30, 0)
        };
        Some(Hit {
            face,
            point: Vec3::from_bits([mix(0), mix(1), mix(2)]),
            distance: view.distance(ahead),
            barycentric: barycentric.map(Fraction::from_bits),
        })
    }
}

/// Space as seen along a ray: the axis along which the ray is longest points ahead, and a shear makes the coordinates
/// along the other two axes 0 on the ray.
struct RayView {
    /// The longest axis.
    main: Axis,
    /// The components of the ray's origin: first along the longest axis, then along the other two, in an order that
    /// makes the three axes right-handed. The direction's components have the same order.
    origin: [i32; 3],
    direction: [i32; 3],
    /// The sign of the direction's component along the longest axis.
    forward: i64,
}

/// An axis of model space.
#[derive(Clone, Copy)]
enum Axis {
    X,
    Y,
    Z,
}

impl Axis {
    /// Reorders three components, so that the component along this axis comes first.
    #[inline]
    const fn first(self, [x, y, z]: [i32; 3]) -> [i32; 3] {
        match self {
            Self::X => [x, y, z],
            Self::Y => [y, z, x],
            Self::Z => [z, x, y],
        }
    }
}

/// A position relative to a ray's origin, along the ray's longest axis and the other two axes, in units of 2^-16: 33
/// bits.
type Seen = [i64; 3];

impl RayView {
    fn new(ray: &Ray) -> Self {
        let direction = ray.direction.to_bits();
        let [x, y, z] = direction.map(i32::unsigned_abs);
        let main = if x >= y && x >= z {
            Axis::X
        } else if y >= z {
            Axis::Y
        } else {
            Axis::Z
        };
        let direction = main.first(direction);
        Self {
            main,
            origin: main.first(ray.origin.to_bits()),
            direction,
            forward: direction[0].signum().into(),
        }
    }

    #[inline]
    fn see(&self, position: Vec3) -> Seen {
        let [x, y, z] = self.main.first(position.to_bits());
        let [from_x, from_y, from_z] = self.origin;
        let from = |at: i32, origin: i32| i64::from(at) - i64::from(origin);
        [from(x, from_x), from(y, from_y), from(z, from_z)]
    }

    /// The barycentric coordinates, in units of 2^-30, of the point where the ray's line meets a triangle; `None` if
    /// the line misses the triangle, or if the triangle is culled.
    #[inline]
    fn meet(&self, [a, b, c]: &[Seen; 3], cull: Cull) -> Option<[i32; 3]> {
        let [along, one, other] = self.direction.map(i64::from);
        // `first` and `second` return the sheared coordinates, times the ray's main component. Each product is a
        // component of the cross product of a vector of a length of at most √2 · 2^32 and a vector of length 2^30, so
        // it is below 2^63.
        let is_beside = |[a, b, c]: [i64; 3]| a.min(b).min(c) > 0 || a.max(b).max(c) < 0;
        let first = |at: &Seen| at[1] * along - at[0] * one;
        let firsts = [first(a), first(b), first(c)];
        if is_beside(firsts) {
            return None;
        }
        let second = |at: &Seen| at[2] * along - at[0] * other;
        let seconds = [second(a), second(b), second(c)];
        if is_beside(seconds) {
            return None;
        }
        let ([xa, xb, xc], [ya, yb, yc]) = (firsts.map(i128::from), seconds.map(i128::from));
        // Twice the areas of the triangles that two corners make with the ray: exact, 127 bits.
        let areas = [xb * yc - yb * xc, xc * ya - yc * xa, xa * yb - ya * xb];
        let is_met = areas.iter().all(|&v| v >= 0) || areas.iter().all(|&v| v <= 0);
        // Each area is at most 2^126 in magnitude, and so is the sum of the areas, which is twice the area of the
        // triangle.
        let [_, second, third] = areas.map(i128::unsigned_abs);
        let sum: i128 = areas.iter().sum();
        // Counter-clockwise is the front if the main axis points toward the viewer.
        let side = self.forward * sum.signum() as i64;
        if !is_met || cull.leaves_out(side) {
            return None;
        }
        let sum = sum.unsigned_abs();
        // Only the upper 32 bits of the sum are used, so that a share of the sum, times 2^30, has 62 bits.
        let down = (128 - sum.leading_zeros()).saturating_sub(32);
        let sum = (sum >> down) as u64;
        let share = |area: u128| {
            let share = (((area >> down) as u64) << 30).checked_div(sum);
            share.unwrap_or_default().min(1 << 30) as i32
        };
        let second = share(second);
        let third = share(third).min((1 << 30) - second);
        Some([(1 << 30) - second - third, second, third])
    }

    /// The distance between the origin and a point that lies `ahead` · 2^-46 ahead along the main axis; saturates.
    fn distance(&self, ahead: i64) -> Scalar {
        let along = u64::from(self.direction[0].unsigned_abs());
        let rounded = ahead.unsigned_abs() + along / 2;
        let distance = rounded.checked_div(along).unwrap_or_default();
        Scalar::from_bits(distance.min(i32::MAX.unsigned_abs().into()) as i32)
    }
}

/// Transforms a point and a direction from eye space back to model space; `view` transforms from model to eye space.
/// The point is rounded to nearest. `None` if the transform's matrix has no inverse, or if the point is out of range.
fn in_model(
    view: &Transform,
    point: [BlockFloat; 3],
    direction: &[BlockFloat; 3],
) -> Option<(Vec3, [i32; 3])> {
    let [x, ..] = view.linear;
    let NormalMatrix([first, second, third]) = view.normal_matrix();
    // This determinant is not negative, because the normal matrix is multiplied by the determinant's sign.
    let determinant = dot(&x, &first);
    if determinant <= 0 {
        return None;
    }
    // The columns of the inverse matrix, times the determinant and a power of two.
    let columns = [0, 1, 2].map(|axis: usize| [first[axis], second[axis], third[axis]]);
    let mut offset = point;
    for (number, &moved) in offset.iter_mut().zip(&view.translation) {
        *number = number.plus(BlockFloat::new((-moved).into(), view.translation_exp));
    }
    let mut mantissas = [0; 3];
    let exp = block::normalize(&mut mantissas, &offset) - view.linear_exp;
    let bits = columns.map(|column| {
        let at = BlockFloat::new(dot(&column, &mantissas), exp);
        let at = at.over(BlockFloat::new(determinant, 0));
        block::fixed(at.value, at.exp, 16)
    });
    if bits.iter().any(|&v| v == i32::MIN || v == i32::MAX) {
        return None;
    }
    block::normalize(&mut mantissas, direction);
    let direction = unit(columns.map(|column| dot(&column, &mantissas)))?;
    Some((Vec3::from_bits(bits), direction))
}

impl Viewport {
    /// The ray of a pixel in model space: the points that `mvp` projects to the pixel's center. The ray starts at the
    /// near plane. By default, the ray passes through faces that it meets from behind, because a draw call culls these
    /// faces by default. If you draw with another [`Cull`], set [`Ray::cull`].
    ///
    /// The result is `None` if the pixel is outside the viewport, if the model's transform has no inverse, or if the
    /// ray's origin is not within ±32,768 in model space.
    ///
    /// The face that the ray [hits](Ray::hit) is the face drawn at the pixel, unless two faces have the same depth
    /// there, or the pixel's center is very close to the face's edge. Very close means within 1/200 of a pixel plus
    /// twice the on-screen size of the model's smallest unit, 2⁻¹⁶. A ray also meets faces beyond the far plane.
    ///
    /// ```
    /// use embedded_graphics::geometry::Point;
    /// use fixel::prelude::*;
    /// static BOX: Mesh = shape!(cuboid(vec3!(1, 1, 1)));
    /// let projection = Projection::perspective(deg!(60), (32, 24), fx!(0.5), fx!(20))?;
    /// let mvp = projection * Transform::translate(vec3!(0, 0, -5)) * Transform::rotate_y(deg!(90));
    /// let screen = Viewport::new(0, 0, 32, 24)?;
    ///
    /// // The side of the box with the least x has been turned toward the viewer.
    /// let touch = Point::new(16, 12);
    /// let hit = screen.ray(touch, &mvp).unwrap().hit(&BOX).unwrap();
    /// assert_eq!(hit.point.x, fx!(-1));
    /// // A hit is a point of the model, so it can be projected back.
    /// let at = screen.project(hit.point, &mvp).unwrap();
    /// assert_eq!((at.x.floor(), at.y.floor()), (16, 12));
    ///
    /// let beside = screen.ray(Point::new(2, 12), &mvp).unwrap();
    /// assert_eq!(beside.hit(&BOX), None);
    /// # Ok::<(), Error>(())
    /// ```
    ///
    /// Do not compare the distances of hits on two objects, because each distance is in the units of its own object.
    /// Compare the nearness of the two points on the screen:
    ///
    /// ```
    /// # use embedded_graphics::geometry::Point;
    /// # use fixel::prelude::*;
    /// # static BOX: Mesh = shape!(cuboid(vec3!(1, 1, 1)));
    /// # static BALL: Mesh = shape!(sphere(12, 8));
    /// # let view = Projection::perspective(deg!(60), (32, 24), fx!(0.5), fx!(20))?;
    /// # let (screen, touch) = (Viewport::new(0, 0, 32, 24)?, Point::new(16, 12));
    /// let far = Transform::translate(vec3!(0, 0, -9)) * Transform::scale(fx!(2));
    /// let objects = [(&BOX, Transform::translate(vec3!(0, 0, -5))), (&BALL, far)];
    /// let hits = objects.iter().enumerate().filter_map(|(object, &(mesh, model))| {
    ///     let mvp = view * model;
    ///     let hit = screen.ray(touch, &mvp)?.hit(mesh)?;
    ///     Some((screen.project(hit.point, &mvp)?.nearness, object, hit.face))
    /// });
    /// let nearest = hits.max_by_key(|&(nearness, ..)| nearness);
    /// assert!(matches!(nearest, Some((_, 0, _)))); // the box, although its hit has the greater distance
    /// # Ok::<(), Error>(())
    /// ```
    #[must_use]
    pub fn ray(&self, pixel: Point, mvp: &impl AsMvp) -> Option<Ray> {
        let [columns, rows] = self.pixels();
        if !columns.contains(&pixel.x) || !rows.contains(&pixel.y) {
            return None;
        }
        // The place of a pixel's center in the viewport, from −1 to 1.
        let at = |pixel: i32, start: i32, end: i32| {
            let center = 2 * (pixel - start) + 1 - (end - start);
            BlockFloat::new(center.into(), 0).over(BlockFloat::new((end - start).into(), 0))
        };
        let x = at(pixel.x, columns.start, columns.end);
        let y = at(pixel.y, rows.start, rows.end).negated();
        let [near, direction] = mvp.projection_of().sight(x, y);
        let (origin, direction) = in_model(&mvp.model_view_of(), near, &direction)?;
        Some(Ray {
            origin,
            direction: Direction::from_bits(direction),
            cull: Cull::default(),
        })
    }
}
