//! Compares the painter's order with a depth buffer: wrong pixels, memory, and instructions, which `.ci/host` counts.

use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor};
use fixel::canvas::DepthBuffer;
use fixel::prelude::*;

use super::common::lighthouse;
use super::common::scenes::{self, HEIGHT, POSES, WIDTH};

const PIXELS: usize = (WIDTH * HEIGHT) as usize;
static RING: Mesh = shape!(torus(fx!(0.12), 32, 8));
static CUBE: Mesh = shape!(cuboid(vec3!(1, 1, 1)));
static FLOOR: Mesh = shape!(plane(1, 1));
static TOWER: Mesh = shape!(cuboid(vec3!(1, 3, 1)));

/// The material of an object.
#[derive(Clone, Copy)]
enum Material {
    Color(Rgb888),
    Baked,
    Sea,
    Island,
}

/// The objects of a scene in one pose, and their view.
struct Scene {
    view: Mvp,
    objects: Vec<Object<'static, Material>>,
    /// The number of objects that are drawn first, unsorted.
    ground: usize,
}

/// The names of the scenes.
pub const SCENES: [&str; 5] = ["sphere", "rings", "towers", "island", "lighthouse"];

/// Makes a scene in pose `k`.
fn scene(name: &str, k: i32) -> Result<Scene, Error> {
    let color = |r, g, b| Material::Color(Rgb888::new(r, g, b));
    let turned = |degrees: i32| Angle::from_degrees(degrees * k);
    Ok(match name {
        "sphere" => Scene {
            view: scenes::sphere_mvp(k)?,
            objects: vec![Object::new(
                &scenes::SPHERE,
                Transform::IDENTITY,
                Material::Baked,
            )],
            ground: 0,
        },
        "rings" => {
            let upright = Transform::rotate_x(deg!(90));
            let outer = Transform::rotate_y(turned(50)) * upright;
            let inner =
                outer * Transform::rotate_x(turned(100)) * upright * Transform::scale(fx!(0.74));
            let cube = inner * Transform::rotate_z(turned(-150)) * Transform::scale(fx!(0.34));
            let camera = Camera::look_at(vec3!(0, 1.2, 3.2), Vec3::ZERO, Vec3::Y)?;
            Scene {
                view: Projection::perspective(deg!(40), (4, 3), fx!(1), fx!(10))? * camera,
                objects: vec![
                    Object::new(&RING, outer, color(255, 255, 255)),
                    Object::new(&RING, inner, color(150, 150, 150)),
                    Object::new(&CUBE, cube, color(200, 80, 80)),
                ],
                ground: 0,
            }
        }
        "towers" => {
            let mut objects = vec![Object::new(
                &FLOOR,
                Transform::scale(fx!(60)),
                color(60, 90, 50),
            )];
            for row in 0..9_u8 {
                for column in 0..3_u8 {
                    let place = Transform::translate(Vec3::from_ints(
                        5 * i16::from(column) - 5,
                        3,
                        -4 * i16::from(row),
                    ));
                    let gray = row * 25 + column * 8 + 12;
                    objects.push(Object::new(&TOWER, place, color(gray, gray, 90)));
                }
            }
            let x = fx!(0.5) * k - fx!(2);
            let camera = Camera::look_at(Vec3::new(x, fx!(2.5), fx!(6)), vec3!(1, 1, -8), Vec3::Y)?;
            Scene {
                view: Projection::perspective(deg!(60), (4, 3), fx!(0.5), fx!(100))? * camera,
                objects,
                ground: 1,
            }
        }
        _ => {
            let island = Transform::rotate_y(turned(45));
            let mut objects = vec![Object::new(&lighthouse::ISLAND, island, Material::Island)];
            if name == "lighthouse" {
                let sea = Transform::IDENTITY;
                objects.insert(0, Object::new(&lighthouse::SEA, sea, Material::Sea));
            }
            Scene {
                view: lighthouse::projection((WIDTH, HEIGHT))? * lighthouse::camera()?,
                objects,
                ground: 0,
            }
        }
    })
}

/// Calls `$draw` with the shader of a material.
macro_rules! with_shader {
    ($material:expr, $shader:ident => $draw:expr) => {
        match $material {
            Material::Color(color) => {
                let $shader = &Flat::rgb(*color).lit_faces(lighthouse::sun()?);
                $draw;
            }
            Material::Baked => {
                let $shader = &scenes::shaded();
                $draw;
            }
            Material::Sea => {
                let $shader = &lighthouse::waves();
                $draw;
            }
            Material::Island => {
                let $shader = &lighthouse::skin()?;
                $draw;
            }
        }
    };
}

type Frame<'c, D> = Canvas<'c, Rgb565, Native, D>;

fn draw_each<D: DepthBuffer>(
    canvas: &mut Frame<'_, D>,
    view: &Mvp,
    objects: &[Object<Material>],
) -> Result<(), Error> {
    for object in objects {
        let mvp = *view * object.model;
        with_shader!(&object.material, shader => canvas.draw(object.thing, &mvp, shader));
    }
    Ok(())
}

/// A list with room for the visible triangles of any scene.
type List = DrawList<700, 1200>;

/// The number of bytes that the list of a scene needs: 16 for each visible triangle, and 16 for each of their vertices.
fn list_bytes(scene: &mut Scene) -> usize {
    let (options, size, others) = (
        DrawOptions::new(),
        (WIDTH, HEIGHT),
        &mut scene.objects[scene.ground..],
    );
    let mut bytes = 0;
    let mut needs = |error: Option<Error>| {
        if let Some(Error::Full { needed, .. }) = error {
            bytes += 16 * needed;
        }
    };
    let mut no_triangles = DrawList::<0, 1200>::new();
    needs(
        no_triangles
            .prepare(&options, size, &mut *others, &scene.view)
            .err(),
    );
    let mut no_vertices = DrawList::<700, 0>::new();
    needs(
        no_vertices
            .prepare(&options, size, &mut *others, &scene.view)
            .err(),
    );
    bytes
}

/// Draws a scene without a depth buffer.
fn draw_sorted<D: DepthBuffer>(
    canvas: &mut Frame<'_, D>,
    list: &mut List,
    scene: &mut Scene,
) -> Result<(), Error> {
    let (ground, others) = scene.objects.split_at_mut(scene.ground);
    draw_each(canvas, &scene.view, ground)?;
    let (options, frame) = (DrawOptions::new(), (WIDTH, HEIGHT));
    let prepared = list.prepare_back_to_front(&options, frame, others, &scene.view)?;
    for (material, triangles) in prepared.parts(canvas)? {
        with_shader!(material, shader => canvas.draw_prepared(&triangles, shader)?);
    }
    Ok(())
}

/// Calls `draw`. Callgrind counts the instructions in functions with this name.
#[inline(never)]
fn only_drawing(draw: impl FnOnce() -> Result<(), Error>) -> Result<(), Error> {
    draw()
}

/// Draws the poses of a scene. With a `way`, draws them with a depth buffer or sorted. Without a `way`, draws them both
/// ways and prints how many pixels differ.
pub fn run(name: &str, way: Option<&str>) -> Result<(), Error> {
    let mut list = Box::new(List::new());
    let (mut wrong, mut most, mut bytes) = (0, 0, 0);
    for k in 0..POSES {
        let mut scene = scene(name, k)?;
        let mut pictures = [vec![Rgb565::BLACK; PIXELS], vec![Rgb565::BLACK; PIXELS]];
        let mut depths = vec![0; PIXELS];
        let [buffered, sorted] = &mut pictures;
        if way != Some("sorted") {
            let mut canvas = Canvas::new(buffered, WIDTH, HEIGHT)?.with_depth(&mut depths)?;
            only_drawing(|| draw_each(&mut canvas, &scene.view, &scene.objects))?;
        }
        if way != Some("depth") {
            let mut canvas = Canvas::new(sorted, WIDTH, HEIGHT)?;
            only_drawing(|| draw_sorted(&mut canvas, &mut list, &mut scene))?;
        }
        if way.is_none() {
            bytes = bytes.max(list_bytes(&mut scene));
        }
        let [buffered, sorted] = &pictures;
        let differ = buffered
            .iter()
            .zip(sorted)
            .map(|(a, b)| u32::from(a != b))
            .sum();
        wrong += differ;
        most = most.max(differ);
    }
    if way.is_none() {
        let percent = |pixels: u32| f64::from(pixels) * 100. / f64::from(WIDTH * HEIGHT);
        println!(
            "{name}: wrong {:.2} % of the frame, at most {:.2} %; list {bytes} bytes, depth buffer {}",
            percent(wrong) / f64::from(POSES),
            percent(most),
            PIXELS * 2,
        );
    }
    Ok(())
}
