//! The settings of a picture that the page asks for.

use core::ops::Range;

use embedded_graphics::geometry::Size;
use fixel::prelude::*;
use fixel::view::Perspective;

use super::common::{lighthouse, scenes};
use super::scene::Scene;

/// The settings of a picture as the page names them, the camera's last; then the results.
///
/// Angles are in degrees, lengths in units; `tolerance`, `near` and `far` are exponents of powers of two; `right` and
/// `down` move the picture by parts of a pixel; `is_two_sided` is 1 for yes and 0 for no. In the little world, `yaw` is
/// the moment of the walk. Results are triangles in, drawn and clipped; pixels drawn; the largest and the mean error in
/// texels; million instructions on two cores; the picture's checksum. NaN stands for a number that is not known.
pub const NAMES: &str = "scene mode tolerance width height format first_row rows band is_two_sided \
    yaw pitch distance fov near far right down center_x center_y center_z scale \
    submitted drawn clipped pixels max mean m0 m4 checksum";
/// How many there are.
pub const FIELDS: usize = 31;
/// The places of the camera's settings, of the counts of triangles and pixels, of the errors, of the instructions, and
/// of the checksum.
pub const CAMERA: Range<usize> = 10..22;
pub const COUNTS: Range<usize> = 22..26;
pub const ERRORS: Range<usize> = 26..28;
pub const INSTRUCTIONS: Range<usize> = 28..30;
pub const CHECKSUM: usize = 30;

/// A field of view of 200 pixels of focal length at 240 rows, in degrees.
const MEASURED_FOV: f64 = 61.927_513_064_147_04;

/// The settings in the crate's numbers.
#[derive(Clone, Copy, Debug)]
pub struct View {
    pub scene: Scene,
    /// 0 `Exact`, 1 `Newton`, 2 `Fast`, 3 `Affine`, 4 `Compact`.
    pub mode: u32,
    /// Of mode `Fast`, in texels.
    pub tolerance: Scalar,
    pub size: Size,
    /// A display's format, by its place in the page's list.
    pub format: u32,
    /// The first row that is drawn, and how many are.
    pub first_row: u32,
    pub rows: u32,
    /// The rows of a band, for the program that is printed.
    pub band: u32,
    /// Whether this is the scene's own camera, in which it is measured.
    pub is_home: bool,
    /// The eye's turn about the center.
    pub yaw: Angle,
    pub pitch: Angle,
    /// Of the eye from the center.
    pub distance: Scalar,
    /// Vertical field of view.
    pub fov: Angle,
    pub near: Scalar,
    pub far: Scalar,
    /// Turns of the eye by less than a pixel, to the right and down.
    pub shift: [Angle; 2],
    /// Whether back faces are drawn too.
    pub is_two_sided: bool,
    /// The center, after the model was scaled.
    pub center: Vec3,
    pub scale: Scalar,
}

impl View {
    /// Reads the fields.
    ///
    /// # Errors
    ///
    /// A number is out of range.
    #[allow(clippy::cast_sign_loss)] // saturates
    pub fn new(fields: &[f64; FIELDS]) -> Result<Self, Error> {
        let mut rest = fields.iter().copied();
        let mut next = || rest.next().unwrap_or_default();
        let angle = |degrees: f64| Angle::try_from_degrees(libm::remainder(degrees, 360.0));
        // A pixel in the middle of the picture, as an angle.
        let pixel =
            libm::atan(2.0 * libm::tan(fields[13].to_radians() / 2.0) / fields[4]).to_degrees();
        let scene = Scene::at(next() as usize);
        let mut camera = fields[CAMERA].iter().zip(Self::home(scene, [fx!(0); 4]));
        // A browser's slider keeps 15 digits.
        let is_home = camera.all(|(now, home)| (now - home).abs() < 1e-9);
        Ok(Self {
            scene,
            mode: next() as u32,
            tolerance: Scalar::try_from(libm::exp2(next()))?,
            size: Size::new(next() as u32, next() as u32),
            format: next() as u32,
            first_row: next() as u32,
            rows: next() as u32,
            band: next() as u32,
            is_two_sided: next() > 0.0,
            is_home,
            yaw: angle(next())?,
            pitch: angle(next())?,
            distance: Scalar::try_from(next())?,
            fov: angle(next())?,
            near: Scalar::try_from(libm::exp2(next()))?,
            far: Scalar::try_from(libm::exp2(next()))?,
            shift: [angle(next() * pixel)?, angle(next() * pixel)?],
            center: Vec3::new(
                Scalar::try_from(next())?,
                Scalar::try_from(next())?,
                Scalar::try_from(next())?,
            ),
            scale: Scalar::try_from(next())?,
        })
    }

    /// Returns the camera's fields at the start: those with which a scene is measured, or in front of a model in a ball
    /// with this center and radius.
    pub fn home(scene: Scene, ball: [Scalar; 4]) -> [f64; CAMERA.end - CAMERA.start] {
        let numbers = |at: Vec3| [at.x, at.y, at.z].map(f64::from);
        let degrees =
            |angle: Angle| f64::from(angle.to_bits().cast_signed()) / 4_294_967_296.0 * 360.0;
        let [pitch, yaw] = match scene {
            Scene::Cube => scenes::cube_turn(0),
            Scene::Sphere | Scene::SphereFlat => scenes::sphere_turn(0),
            _ => [scenes::FLOOR_PITCH, Angle::ZERO],
        }
        .map(degrees);
        let (mut yaw, mut pitch, mut fov) = (yaw, pitch, MEASURED_FOV);
        let (mut near, mut far) = (0.25, 100.0);
        let (mut center, mut scale) = ([0.0; 3], 1.0);
        let distance = match scene {
            Scene::Floor => {
                center = numbers(-scenes::FLOOR_AT);
                0.0
            }
            Scene::Cube => f64::from(-scenes::CUBE_AT.z),
            Scene::Sphere | Scene::SphereFlat => f64::from(-scenes::SPHERE_AT.z),
            Scene::Lighthouse => {
                center = numbers(lighthouse::TARGET);
                let [x, y, z] = numbers(lighthouse::EYE - lighthouse::TARGET);
                yaw = -libm::atan2(x, z).to_degrees();
                pitch = libm::atan2(y, libm::hypot(x, z)).to_degrees();
                (fov, near, far) = (40.0, 1.0, 140.0);
                libm::hypot(y, libm::hypot(x, z))
            }
            Scene::World => {
                yaw = 72.0;
                0.0
            }
            Scene::Own => {
                let [x, y, z, radius] = ball.map(f64::from);
                scale = if radius > 0.0 { 1.0 / radius } else { 1.0 };
                center = [x, y, z].map(|at| at * scale);
                (yaw, pitch) = (35.0, 20.0);
                // A ball of radius 1, and a twentieth more.
                1.05 / libm::sin(fov.to_radians() / 2.0)
            }
        };
        let [x, y, z] = center;
        [
            yaw,
            pitch,
            distance,
            fov,
            libm::log2(near),
            libm::log2(far),
            0.0,
            0.0,
            x,
            y,
            z,
            scale,
        ]
    }

    /// A scene as it is measured.
    ///
    /// # Errors
    ///
    /// None.
    pub fn measured(scene: Scene, mut fields: [f64; FIELDS]) -> Result<Self, Error> {
        let (width, height) = (f64::from(scenes::WIDTH), f64::from(scenes::HEIGHT));
        fields[0] = f64::from(scene as u8);
        fields[3..8].copy_from_slice(&[width, height, 0.0, 0.0, height]);
        fields[CAMERA].copy_from_slice(&Self::home(scene, [fx!(0); 4]));
        Self::new(&fields)
    }

    /// The band's pixels in the frame's memory.
    pub fn band(&self) -> Range<usize> {
        let pixels = |rows: u32| (self.size.width as usize).saturating_mul(rows as usize);
        pixels(self.first_row)..pixels(self.first_row.saturating_add(self.rows))
    }

    /// Whether the picture keeps full precision, because the display has another format than Rgb565.
    pub fn is_deep(&self) -> bool {
        let is_night = self.scene == Scene::Lighthouse && self.is_mono();
        self.format != 0 && self.scene != Scene::World && !is_night
    }

    /// Whether the display is black and white.
    pub fn is_mono(&self) -> bool {
        self.format == 5
    }

    pub fn cull(&self) -> Cull {
        if self.is_two_sided {
            Cull::Nothing
        } else {
            Cull::Back
        }
    }

    /// The camera and projection in which a scene is drawn: its own where it is measured, or the eye on a sphere around
    /// the center, looking at it.
    ///
    /// # Errors
    ///
    /// The field of view, a plane or the size is out of range.
    pub fn mvp(&self) -> Result<Mvp<Perspective>, Error> {
        match self.scene {
            Scene::Lighthouse if self.is_home => {
                let projection = lighthouse::projection(self.size)?;
                return Ok(projection * lighthouse::camera()? * Transform::IDENTITY);
            }
            scene if self.is_measured() => match scene {
                Scene::Floor => return scenes::floor_mvp(0),
                Scene::Cube => return scenes::cube_mvp(0),
                Scene::Sphere | Scene::SphereFlat => return scenes::sphere_mvp(0),
                Scene::Lighthouse | Scene::Own | Scene::World => {}
            },
            _ => {}
        }
        let size = (self.size.width, self.size.height);
        let projection = Projection::perspective(self.fov, size, self.near, self.far)?;
        let [right, down] = self.shift;
        let view = Transform::rotate_x(down)
            * Transform::rotate_y(right)
            * Transform::translate(Vec3::new(fx!(0), fx!(0), -self.distance))
            * Transform::rotate_x(self.pitch)
            * Transform::rotate_y(self.yaw)
            * Transform::translate(-self.center);
        Ok(projection * Camera::from_view(view) * Transform::scale(self.scale))
    }

    /// Whether this is a scene's own camera, in the size in which it is measured.
    pub fn is_measured(&self) -> bool {
        self.is_home && self.size == Size::new(scenes::WIDTH, scenes::HEIGHT)
    }
}
