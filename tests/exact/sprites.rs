//! Sprites have the same pixels, depths and colors as the triangles of a mesh in eye space, and the same texture
//! coordinates within the error that the modes promise. Bands equal the frame, bit for bit.

use std::cell::{Cell, RefCell};

use embedded_graphics::geometry::Point;
use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor};
use fixel::Thing;
use fixel::prelude::*;
use fixel::shade::Texels;
use fixel::view::ProjectionKind;
use fixel::{Primitive, Window};

use support::erased::Erased;
use support::recorder::Probe;

const WIDTH: u32 = 80;
const HEIGHT: u32 = 60;

static SKIN: [[Rgb565; 2]; 2] = [[Rgb565::WHITE, Rgb565::BLUE], [Rgb565::GREEN, Rgb565::RED]];

/// There are more sprites than the crate draws at a time, near and far. Some lie partly behind the near plane or
/// outside the picture.
fn positions() -> Vec<Vec3> {
    (0..29)
        .map(|i: i16| Vec3::from_ints(i * 7 % 11 - 5, i * 5 % 7 - 3, -(i * 3 % 13)))
        .collect()
}

type Screen<'c> = crate::Screen<'c, Rgb565>;

/// A picture drawn in bands of `rows` rows.
fn picture(rows: u32, draw: &dyn Fn(&mut Screen<'_>)) -> (Vec<Rgb565>, Vec<u16>) {
    let before = (Rgb565::new(1, 2, 3), 0);
    crate::picture((WIDTH, HEIGHT), rows, before, &mut |canvas| draw(canvas))
}

/// The corners of all quads in eye space, four each.
fn corners<'a, K: ProjectionKind, A: Copy>(
    options: &DrawOptions,
    sprites: &Sprites<'a, A>,
    mvp: &Mvp<K>,
) -> Vec<Vec3>
where
    for<'s> &'s Sprites<'a, A>: Thing<Rgb565>,
{
    // Corners that the shader does not see stay zero. These corners belong to triangles without pixels, and `check`
    // leaves these triangles out.
    let found = RefCell::new(vec![Vec3::ZERO; 4 * sprites.positions().len()]);
    let probe = Probe::<_, Rgb565> {
        values: &|corner| {
            let primitive = corner.primitive();
            let quad = 4 * (primitive.face().unwrap() / 2);
            let first = [[0, 1, 2], [2, 1, 3]][primitive.face().unwrap() % 2];
            for (at, position) in first.into_iter().zip(primitive.positions()) {
                found.borrow_mut()[quad + at] = position;
            }
            [0; 1]
        },
        color: None,
    };
    picture(HEIGHT, &|canvas| {
        canvas.draw_with(options, sprites, mvp, &Erased::new(&probe));
    });
    found.into_inner()
}

/// A shader that records the texture coordinates of all pixels, and counts how often it is asked for varyings. The unit
/// is 2^-16 texel of a texture with a side of 1024 texels. (The shared recorder is no use here: it gives the two
/// triangles of a sprite different varyings, their indices, so no sprite would be drawn as a rectangle.)
#[derive(Clone, Copy)]
struct TexelRecorder<'a> {
    found: &'a RefCell<Vec<(Point, [i32; 2])>>,
    asked: &'a Cell<usize>,
}

impl Shader for TexelRecorder<'_> {
    type Color = Rgb565;
    type Varyings = Texels;

    fn varyings(&self, triangle: &Primitive<'_>) -> [Texels; 3] {
        self.asked.set(self.asked.get() + 1);
        let texels = |at: fixel::num::TexCoord| at.to_bits() << 6;
        triangle.corners(|corner| Texels([texels(corner.uv().x), texels(corner.uv().y)]))
    }

    fn shade(&self, at: &Fragment, Texels(at_texel): Texels) -> Option<Rgb565> {
        self.found.borrow_mut().push((at.point, at_texel));
        None
    }
}

/// A shader that interpolates a number. The numbers at a sprite's four corners lie in no common plane, so the number is
/// not linear over the sprite.
#[derive(Clone, Copy)]
struct Bent;

impl Shader for Bent {
    type Color = Rgb565;
    type Varyings = [i32; 1];

    fn varyings(&self, triangle: &Primitive<'_>) -> [[i32; 1]; 3] {
        triangle.corners(|corner| [(corner.uv().x * corner.uv().y).to_bits()])
    }

    fn shade(&self, _: &Fragment, [part]: [i32; 1]) -> Option<Rgb565> {
        let green = (part >> 14).clamp(0, 63);
        Some(Rgb565::new(0, u8::try_from(green).unwrap(), 0))
    }
}

/// The texture coordinates of all pixels, sorted by pixel, and how often the shader was asked for its varyings.
fn coordinates(
    draw: &dyn Fn(&mut Screen<'_>, TexelRecorder<'_>),
) -> (Vec<(Point, [i32; 2])>, usize) {
    let (found, asked) = (RefCell::new(Vec::new()), Cell::new(0));
    let shader = TexelRecorder {
        found: &found,
        asked: &asked,
    };
    picture(HEIGHT, &|canvas| draw(canvas, shader));
    let mut found = found.into_inner();
    // The sort is stable, so sprites that cover the same pixel keep their order.
    found.sort_by_key(|(point, _)| (point.y, point.x));
    (found, asked.get())
}

/// Draws sprites, and compares them with a mesh. `is_upright` is true for sprites with neither an axis nor an angle.
fn check<'a, K: ProjectionKind, A: Copy>(
    options: &DrawOptions,
    (sprites, is_upright): (Sprites<'a, A>, bool),
    colors: &'a [Rgb888],
    projection: Projection<K>,
    camera: Camera,
) where
    for<'s> &'s Sprites<'a, A>: Thing<Rgb565>,
{
    let sprites = sprites.with_colors(colors).unwrap();
    let mvp = projection * camera;
    let fog = Fog::linear(Rgb565::new(9, 9, 9), fx!(2), fx!(12)).unwrap();
    let textured = Textured::new(&SKIN)
        .cut_out(Rgb565::new(0, 0, 31))
        .tinted()
        .in_fog(fog);
    let frame = picture(HEIGHT, &|canvas| {
        let drawn = canvas.draw_with(options, &sprites, &mvp, &textured);
        assert_eq!(drawn.submitted, 2 * 29);
        assert!(!drawn.missing.uvs && !drawn.missing.colors);
    });
    for rows in [1, 7, 16] {
        let bands = picture(rows, &|canvas| {
            canvas.draw_with(options, &sprites, &mvp, &textured);
        });
        assert!(bands == frame, "bands of {rows} rows");
    }

    let positions = corners(options, &sprites, &mvp);
    let uvs: Vec<Vec2> = [vec2!(0, 1), vec2!(1, 1), vec2!(0, 0), vec2!(1, 0)].repeat(29);
    let faces: Vec<[u16; 3]> = (0..29)
        .flat_map(|i| [[0, 1, 2], [2, 1, 3]].map(|face| face.map(|at: u16| 4 * i + at)))
        .map(|face| {
            let is_seen = face
                .iter()
                .all(|&at| positions[usize::from(at)] != Vec3::ZERO);
            if is_seen { face } else { [face[0]; 3] }
        })
        .collect();
    let corner_colors: Vec<Rgb888> = colors.iter().flat_map(|&color| [color; 4]).collect();
    let mesh = Mesh::new(&positions, &faces)
        .and_then(|mesh| mesh.with_uvs(&uvs, None))
        .and_then(|mesh| mesh.with_colors(&corner_colors, None))
        .unwrap();
    let both = options.with_cull(Cull::Nothing);
    let drawn = same_as_mesh(
        &both,
        &sprites,
        &mesh,
        (&mvp, &projection),
        &Gouraud::new().in_fog(fog),
    );
    same_as_mesh(
        &both,
        &sprites,
        &mesh,
        (&mvp, &projection),
        &Erased::new(&Bent),
    );
    // The two triangles of a sprite are two faces, each with a color.
    let colors: Vec<Rgb565> = (0..58).map(|i| Rgb565::new(i / 2, i, 31)).collect();
    same_as_mesh(
        &both,
        &sprites,
        &mesh,
        (&mvp, &projection),
        &FaceColors::new(&colors),
    );

    // Each of the two texture coordinates can have an error of up to 57 units. The tolerance of the mode adds nothing,
    // because a sprite that faces the camera has only one depth, and other sprites are drawn as triangles, like the
    // mesh.
    let (found, asked) = coordinates(&|canvas, shader| {
        canvas.draw_with(options, &sprites, &mvp, &shader);
    });
    let (expected, asked_by_mesh) = coordinates(&|canvas, shader| {
        canvas.draw_with(&both, &mesh, &projection, &shader);
    });
    assert_eq!(found.len(), expected.len());
    for ((point, found), (same_point, expected)) in found.into_iter().zip(expected) {
        assert_eq!(point, same_point);
        for (found, expected) in found.into_iter().zip(expected) {
            let error = found.abs_diff(expected);
            assert!(error <= 2 * 57, "{found} is not {expected} at {point}");
        }
    }
    if is_upright {
        // A sprite asks for varyings twice to compare its halves, and a third time to draw the rectangle. Two triangles
        // ask once each, except for the few triangles that have no pixel.
        assert_eq!(drawn.clipped, 0);
        let halves = asked / 3 * 2;
        assert_eq!(asked % 3, 0);
        assert!((halves * 9 / 10..=halves).contains(&asked_by_mesh));
    } else {
        assert_eq!(asked, asked_by_mesh);
    }
}

/// Checks that sprites and a mesh give the same picture, bit for bit.
fn same_as_mesh<'a, K: ProjectionKind, A: Copy>(
    both: &DrawOptions,
    sprites: &Sprites<'a, A>,
    mesh: &Mesh<'_>,
    (mvp, projection): (&Mvp<K>, &Projection<K>),
    shader: &impl ShaderFor<Rgb565>,
) -> Drawn
where
    for<'s> &'s Sprites<'a, A>: Thing<Rgb565>,
{
    let total = Cell::new(Drawn::default());
    let frame = picture(HEIGHT, &|canvas| {
        total.set(canvas.draw_with(both, sprites, mvp, shader));
    });
    let expected = picture(HEIGHT, &|canvas| {
        let drawn = canvas.draw_with(both, mesh, projection, shader);
        assert!(drawn.drawn > 20, "{drawn:?}");
        // The mesh lacks the few triangles that have no pixel, because no shader sees these triangles: those of sprites
        // with a scale of 1/8, and turned ones of which the border of the view leaves only a corner.
        let Drawn {
            submitted, missing, ..
        } = total.get();
        assert_eq!((submitted, missing), (drawn.submitted, drawn.missing));
        let unseen = total.get().drawn - drawn.drawn;
        assert!(
            unseen <= 4 && total.get().clipped - drawn.clipped <= unseen,
            "{drawn:?} of {:?}",
            total.get()
        );
    });
    assert!(frame == expected, "the mesh's picture differs");
    total.get()
}

#[test]
fn sprites_are_meshes_in_eye_space() {
    let positions = positions();
    // The scales run from -1.3 to 2.2, and include 0.
    let scales: Vec<Scalar> = (-10..19).map(|i| Scalar::from_bits(i << 13)).collect();
    let camera = Camera::look_at(vec3!(0, 2, 1), vec3!(0, 0, -6), Vec3::Y).unwrap();
    let size = (fx!(2), fx!(3));
    let world = Sprites::new(&positions, size)
        .unwrap()
        .with_scales(&scales)
        .unwrap();
    let pixels = Sprites::in_pixels(&positions, (fx!(9), fx!(7))).unwrap();
    let scaled = pixels.with_scales(&scales).unwrap();
    let trees = world
        .with_axis(vec3!(0.1, 3, 0))
        .unwrap()
        .with_anchor(vec2!(0.5, 1));
    let window = Window::centered(fx!(16), fx!(12));
    // The left edge of this viewport is outside the frame; its other edges are inside.
    let cutting = Viewport::new(-15, 5, 80, 50).unwrap();
    let angles: Vec<Angle> = (0..29).map(|i| deg!(25) * i).collect();
    let colors: Vec<Rgb888> = (0..29)
        .map(|i| Rgb888::new(i * 8, 255 - i, i * 5))
        .collect();
    for options in [
        DrawOptions::new(),
        DrawOptions::new().with_viewport(cutting),
    ] {
        let perspective = Projection::perspective(deg!(80), (4, 3), fx!(0.5), fx!(20)).unwrap();
        let parallel = Projection::orthographic(window, fx!(2), fx!(11)).unwrap();
        for (sprites, is_upright) in [
            (world, true),
            (pixels, true),
            (scaled, true),
            (trees, false),
        ] {
            let turned = (sprites.with_angles(&angles).unwrap(), false);
            let sprites = (sprites, is_upright);
            check(&options, sprites, &colors, perspective, camera);
            check(&options, sprites, &colors, parallel, camera);
            check(&options, turned, &colors, perspective, camera);
            check(&options, turned, &colors, parallel, camera);
        }
    }
}

/// Sprites of the same scale, each with an angle of its own, look like sprites that are drawn one at a time.
#[test]
fn each_sprite_has_its_own_angle() {
    let (places, angles): (Vec<Vec3>, Vec<Angle>) = (0..11_i16)
        .map(|i| {
            (
                Vec3::from_ints(i - 5, i % 3 - 1, -7),
                deg!(33) * i32::from(i),
            )
        })
        .unzip();
    let mvp = Projection::perspective(deg!(80), (4, 3), fx!(0.5), fx!(20)).unwrap();
    let draw = |canvas: &mut Screen<'_>, part: std::ops::Range<usize>| {
        let sprites = Sprites::new(&places[part.clone()], (fx!(1), fx!(2))).unwrap();
        let sprites = sprites.with_angles(&angles[part]).unwrap();
        canvas.draw(&sprites, &mvp, &Textured::new(&SKIN));
    };
    let all = picture(HEIGHT, &|canvas| draw(canvas, 0..11));
    let single = picture(HEIGHT, &|canvas| {
        (0..11).for_each(|i| draw(canvas, i..i + 1));
    });
    assert!(all == single);
}

/// The angles 0, 90, 180 and 270 degrees of a sprite with whole pixels turn its picture. No pixel's center is near an
/// edge.
#[test]
fn a_quarter_turn_turns_the_picture() {
    let window = Window::centered(fx!(80), fx!(60));
    let projection = Projection::orthographic(window, fx!(0), fx!(9)).unwrap();
    let place = [vec3!(0, 0, -1)];
    let arrow = Sprites::new(&place, (fx!(20), fx!(12))).unwrap();
    let turned = |angle| {
        let angles = [angle];
        let arrow = arrow.with_angles(&angles).unwrap();
        picture(HEIGHT, &|canvas| {
            canvas.draw(&arrow, &projection, &Textured::new(&SKIN));
        })
        .0
    };
    let at = |picture: &[Rgb565], [x, y]: [i32; 2]| {
        // Counted from the middle, in half pixels, y up.
        let [column, row] = [(x + 79) >> 1, (59 - y) >> 1];
        picture[usize::try_from(row * 80 + column).unwrap()]
    };
    let upright = turned(deg!(0));
    assert_eq!(
        upright,
        picture(HEIGHT, &|canvas| {
            canvas.draw(&arrow, &projection, &Textured::new(&SKIN));
        })
        .0
    );
    for (quarters, angle) in [deg!(90), deg!(180), deg!(270)].into_iter().enumerate() {
        let found = turned(angle);
        for y in (-29..30).step_by(2) {
            for x in (-29..30).step_by(2) {
                let (mut from, mut to) = ([x, y], [x, y]);
                for _ in 0..=quarters {
                    to = [-to[1], to[0]];
                }
                std::mem::swap(&mut from, &mut to);
                assert_eq!(at(&upright, to), at(&found, from), "{angle:?}, {x} {y}");
            }
        }
    }
}

/// Positions and sizes are at the ends of the format. A sprite that is out of range must not appear in another place.
#[test]
fn sprites_out_of_range_have_no_pixels() {
    let ends = [Scalar::MIN, -Scalar::DELTA, Scalar::ZERO, Scalar::MAX];
    let mut positions = Vec::new();
    for x in ends {
        for y in ends {
            positions.extend([Scalar::MAX, Scalar::MIN, fx!(30000)].map(|z| Vec3::new(x, y, z)));
        }
    }
    let wide = Projection::perspective(deg!(170), (1, 1), Scalar::DELTA, Scalar::MAX).unwrap();
    for size in [Scalar::DELTA, fx!(1), Scalar::MAX] {
        for place in [
            Transform::IDENTITY,
            Transform::scale(fx!(32767)),
            Transform::translate(vec3!(0, 0, -32768)),
        ] {
            for sprites in [
                Sprites::new(&positions, (size, size)),
                Sprites::in_pixels(&positions, (size, size)),
            ] {
                let sprites = sprites.unwrap();
                let turning = sprites.with_axis(Vec3::Z).unwrap();
                let angles = vec![deg!(30); positions.len()];
                for sprites in [sprites, turning] {
                    let turned = sprites.with_angles(&angles).unwrap();
                    let (mvp, gray) = (wide * place, Flat::new(Rgb565::new(9, 9, 9)));
                    picture(HEIGHT, &|canvas| {
                        canvas.draw(&sprites, &mvp, &gray);
                        canvas.draw(&turned, &mvp, &gray);
                    });
                }
            }
        }
    }
    // The transform moves this position out of the format. If the result saturated, the sprite would appear at 45
    // degrees.
    let positions = [vec3!(20000, 20000, -20000)];
    let sprites = Sprites::new(&positions, (fx!(9000), fx!(9000))).unwrap();
    let mvp = Projection::perspective(deg!(120), (1, 1), fx!(1), Scalar::MAX).unwrap()
        * Transform::scale_axes(vec3!(2, 2, 1));
    let drawn = picture(HEIGHT, &|canvas| {
        canvas.draw(&sprites, &mvp, &Flat::new(Rgb565::new(9, 9, 9)));
    });
    assert!(drawn.0.iter().all(|&color| color == Rgb565::new(1, 2, 3)));
    let sprites = sprites.with_angles(&[deg!(10)]).unwrap();
    let drawn = picture(HEIGHT, &|canvas| {
        canvas.draw(&sprites, &mvp, &Flat::new(Rgb565::new(9, 9, 9)));
    });
    assert!(drawn.0.iter().all(|&color| color == Rgb565::new(1, 2, 3)));
}

/// Corners of sprites that take most of the format have errors of more than one unit, but of less than one unit plus
/// 2^-26 of the coordinate.
#[test]
fn corners_of_the_largest_sprites_are_accurate_to_26_bits() {
    let at = Vec3::from_bits([0, 0, -114_830_873]);
    let (positions, scales) = ([at], [Scalar::from_bits(-221_200)]);
    let lens = Projection::from_focal_length(fx!(64), (WIDTH, HEIGHT), fx!(1), Scalar::MAX);
    let lens = lens.unwrap().into();
    let errors = (0..50).map(|i| {
        let size = Scalar::from_bits(26_300_479 + 1009 * i);
        let sprites = Sprites::in_pixels(&positions, (size, fx!(9)))
            .and_then(|sprites| sprites.with_scales(&scales))
            .unwrap();
        let corners = corners(&DrawOptions::new(), &sprites, &lens);
        // A pixel has the size of 1/64 of the distance.
        let parts = [size, scales[0], at.z].map(f64::from);
        let half = parts.iter().product::<f64>() / 64. / 2. * 65_536.;
        let error = (f64::from(corners[0].x.to_bits()) - half).abs();
        assert!(error < 1. + half.abs() / 2_f64.powi(26), "{error}");
        error
    });
    assert!(errors.fold(0., f64::max) > 1.);
}
