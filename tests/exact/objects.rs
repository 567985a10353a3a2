//! Prepared lists with several objects.

use embedded_graphics::pixelcolor::{Gray8, GrayColor};
use fixel::canvas::Opacity;
use fixel::prelude::*;
use fixel::{Drawn, FacesOrEdges, Prepared};

use crate::{List, Screen, picture};
use support::counter::{at_subpixel, pixel_projection};

const WIDTH: u32 = 48;
const HEIGHT: u32 = 36;
const SIZE: (u32, u32) = (WIDTH, HEIGHT);
const PIXELS: usize = (WIDTH * HEIGHT) as usize;

static BALL: Mesh = shape!(sphere(12, 8));
static OUTLINE: Outline = outline!(BALL, deg!(30));
static RING: Mesh = shape!(torus(fx!(0.3), 16, 8));
static RING_OUTLINE: Outline = outline!(RING, deg!(60));
static EMPTY: Mesh = Mesh::checked(Mesh::new(&[], &[]));

/// A ball within a ring, a ball across the near plane and the frame's left edge, and an object behind the eye.
fn objects() -> [Object<'static, Flat<Gray8>>; 5] {
    let flat = |gray| Flat::new(Gray8::new(gray));
    let tilted = Transform::translate(vec3!(0.5, 0, 0)) * Transform::rotate_x(deg!(70));
    [
        Object::new(
            &BALL,
            Transform::translate(vec3!(0.5, 0, 0)) * Transform::scale(fx!(0.6)),
            flat(50),
        ),
        Object::new(&EMPTY, Transform::IDENTITY, flat(90)),
        Object::new(&RING, tilted, flat(120)),
        Object::new(
            &BALL,
            Transform::translate(vec3!(-1.5, -0.8, 2.5)),
            flat(200),
        ),
        Object::new(&BALL, Transform::translate(vec3!(0, 0, 9)), flat(250)),
    ]
}

fn view() -> Mvp {
    let projection = Projection::perspective(deg!(60), SIZE, fx!(1), fx!(20)).unwrap();
    projection
        * Camera::look_at(vec3!(0, 1, 4), Vec3::ZERO, Vec3::Y).unwrap()
        * Transform::rotate_y(deg!(5))
}

/// The frame, drawn with a depth buffer and without a list.
fn drawn() -> Vec<Gray8> {
    let draw = &mut |canvas: &mut Screen<'_, Gray8>| {
        for object in objects() {
            canvas.draw(object.thing, &(view() * object.model), &object.material);
        }
    };
    picture(SIZE, HEIGHT, (Gray8::BLACK, 0), draw).0
}

/// The frame, drawn in bands of `rows` rows, and the total number of parts in all bands.
fn in_bands(scene: &Prepared<'_, Flat<Gray8>>, rows: u32, has_depth: bool) -> (Vec<Gray8>, usize) {
    let (mut frame, mut parts) = (Vec::new(), 0);
    for first in (0..HEIGHT).step_by(rows as usize) {
        let mut color = vec![Gray8::BLACK; (WIDTH * rows) as usize];
        let mut depth = vec![0; color.len()];
        let mut band = Canvas::band(&mut color, WIDTH, HEIGHT, first).unwrap();
        for (shader, triangles) in scene.parts(&band).unwrap() {
            if !has_depth {
                band.draw_prepared(&triangles, shader).unwrap();
            }
            parts += 1;
        }
        if has_depth {
            let mut band = band.with_depth(&mut depth).unwrap();
            for (shader, triangles) in scene.parts(&band).unwrap() {
                band.draw_prepared(&triangles, shader).unwrap();
            }
        }
        frame.extend(color);
    }
    (frame, parts)
}

#[test]
fn a_list_of_objects_draws_the_same_as_each_alone() {
    let expected = drawn();
    let mut list: List = DrawList::new();
    let (options, mut objects) = (DrawOptions::new(), objects());
    let view = view();
    let scene = list.prepare(&options, SIZE, &mut objects, &view).unwrap();
    for rows in [HEIGHT, 12, 1] {
        assert!(in_bands(&scene, rows, true).0 == expected, "{rows} rows");
    }
    assert_eq!(in_bands(&scene, HEIGHT, true).1, 3);

    // With a depth buffer, the picture is the same in any order of the triangles. Here the picture is the same without
    // depths, too, because no triangles cross and no triangle is much larger than the other triangles.
    let scene = list
        .prepare_back_to_front(&options, SIZE, &mut objects, &view)
        .unwrap();
    for rows in [HEIGHT, 12, 1] {
        assert!(
            in_bands(&scene, rows, true).0 == expected,
            "{rows} rows, sorted"
        );
        assert!(
            in_bands(&scene, rows, false).0 == expected,
            "{rows} rows, sorted, without depth"
        );
    }
    let (_, parts) = in_bands(&scene, HEIGHT, false);
    assert!(parts > 3);
}

#[test]
fn a_list_without_room_for_all_objects_is_refused() {
    let mut list: DrawList<20, 400> = DrawList::new();
    let (options, mut objects) = (DrawOptions::new(), objects());
    let error = list
        .prepare(&options, SIZE, &mut objects, &view())
        .unwrap_err();
    assert!(
        matches!(
            error,
            Error::Full {
                of: "triangles",
                needed: 40..,
                room: 20,
                ..
            }
        ),
        "{error}"
    );
}

/// A list of one mesh or of a scene refuses a wider frame, and a frame with one row less.
#[test]
fn a_canvas_of_another_frame_is_refused() {
    let [mut of_faces, mut of_edges, mut of_smooth, mut of_scene] = [(); 4].map(|()| List::new());
    let (options, white, view) = (DrawOptions::new(), Flat::new(Gray8::WHITE), view());
    let (width, mut objects) = (LineStyle::wide(fx!(2)).unwrap(), objects());
    let (lines, smooth) = (BALL.edges(width), BALL.edges(width.smooth()));
    let ball = of_faces.prepare(&options, SIZE, &BALL, &view).unwrap();
    let edges = of_edges.prepare(&options, SIZE, lines, &view).unwrap();
    let smooth = of_smooth.prepare(&options, SIZE, smooth, &view).unwrap();
    let scene = of_scene
        .prepare(&options, SIZE, &mut objects, &view)
        .unwrap();
    let mut color = [Gray8::BLACK; PIXELS];
    for (width, height) in [(WIDTH * 2, HEIGHT / 2), (WIDTH, HEIGHT - 1)] {
        let pixels = &mut color[..(width * height) as usize];
        let mut canvas = Canvas::new(pixels, width, height).unwrap();
        let expected = format!(
            "size of the canvas's frame is {width}x{height}: it must be 48x36, like the frame of the list"
        );
        for refused in [
            canvas.draw_prepared(&ball, &white).err(),
            canvas.draw_prepared(&edges, &white).err(),
            canvas.draw_prepared(&smooth, &white).err(),
            scene.parts(&canvas).err(),
        ] {
            assert_eq!(refused.unwrap().to_string(), expected);
        }
        assert!(color.iter().all(|&pixel| pixel == Gray8::BLACK));
    }
    // A band of the same frame is accepted.
    let mut band = Canvas::band(&mut color[..WIDTH as usize], WIDTH, HEIGHT, 7).unwrap();
    assert!(band.draw_prepared(&ball, &white).is_ok());
    assert!(band.draw_prepared(&edges, &white).is_ok());
    assert!(scene.parts(&band).is_ok());
}

#[test]
fn outlines_made_at_compile_time_equal_those_made_at_run_time() {
    let mut room = vec![[0; 4]; 3 * BALL.faces().len()];
    let built = Outline::build(&BALL, deg!(30), &mut room);
    assert_eq!(Ok(OUTLINE), built);
}

/// An object with an outline adds its outline to the list. An object without an outline adds all of its edges.
#[test]
fn a_scene_of_edges_draws_outlines_or_all_edges() {
    let (options, wide) = (DrawOptions::new(), LineStyle::wide(fx!(2)).unwrap());
    let mut objects = objects().map(|object| {
        let edges = match object.material {
            first if first == Flat::new(Gray8::new(50)) => BALL.outline(&OUTLINE, wide),
            _ => object.thing.edges(wide),
        };
        Object::new(edges, object.model, object.material)
    });
    let mut direct = vec![Gray8::BLACK; PIXELS];
    let mut canvas = Canvas::new(&mut direct, WIDTH, HEIGHT).unwrap();
    let mut counts = Vec::new();
    for object in &objects {
        let drawn = canvas.draw(object.thing, &(view() * object.model), &object.material);
        if drawn.drawn > 0 {
            counts.push(drawn);
        }
    }
    let mut list: List = DrawList::new();
    let scene = list.prepare(&options, SIZE, &mut objects, &view()).unwrap();
    for rows in [HEIGHT, 12, 1] {
        let mut frame = Vec::new();
        for first in (0..HEIGHT).step_by(rows as usize) {
            let mut color = vec![Gray8::BLACK; (WIDTH * rows) as usize];
            let mut band = Canvas::band(&mut color, WIDTH, HEIGHT, first).unwrap();
            let parts = scene.parts(&band).unwrap();
            let drawn: Vec<_> = parts
                .map(|(shader, edges)| band.draw_prepared(&edges, shader).unwrap())
                .collect();
            if rows == HEIGHT {
                // Most lines of the ball across the near plane lie above the frame, and do not count.
                assert_eq!(drawn, counts);
                assert!(2 * drawn[2].drawn < drawn[2].submitted);
            }
            frame.extend(color);
        }
        assert!(frame == direct, "{rows} rows");
    }
    let mut color = [Gray8::BLACK; PIXELS];
    let other = Canvas::new(&mut color, HEIGHT, WIDTH).unwrap();
    assert!(matches!(
        scene.parts(&other).map(|_| ()),
        Err(Error::SizeDiffers { .. })
    ));
    let mut short: DrawList<99, 500> = DrawList::new();
    let refused = short.prepare(&options, SIZE, &mut objects, &view());
    assert!(matches!(
        refused.map(|_| ()),
        Err(Error::Full {
            of: "edges",
            needed: 100..,
            room: 99,
            ..
        })
    ));
}

/// Wide lines and clipped lines reach above and below the frame. Bands of prepared edges must equal the frame drawn
/// directly.
#[test]
fn prepared_edges_in_bands_equal_the_frame() {
    let near = view() * Transform::translate(vec3!(0, 0.2, 2.3)) * Transform::scale(fx!(1.3));
    let (options, white) = (DrawOptions::new(), Flat::new(Gray8::WHITE));
    let mut list: List = DrawList::new();
    let picture = |rows: u32, draw: &dyn Fn(&mut Canvas<'_, Gray8>) -> Drawn| {
        let mut color = [Gray8::BLACK; PIXELS];
        let mut drawn = Vec::new();
        for (band, first) in color
            .chunks_mut((rows * WIDTH) as usize)
            .zip((0..).step_by(rows as usize))
        {
            drawn.push(draw(&mut Canvas::band(band, WIDTH, HEIGHT, first).unwrap()));
        }
        (color, drawn)
    };
    /// Checks that lines from a list equal lines drawn directly. Returns the counts of the direct draw call, and of the
    /// bands.
    macro_rules! check {
        ($lines:expr, $rows:expr, $options:expr) => {{
            let (lines, options) = ($lines, $options);
            let edges = list.prepare(&options, SIZE, lines, &near).unwrap();
            let (direct, counts) = picture(HEIGHT, &|canvas| {
                canvas.draw_with(&options, lines, &near, &white)
            });
            let (prepared, drawn) =
                picture($rows, &|band| band.draw_prepared(&edges, &white).unwrap());
            assert!(prepared == direct);
            (counts, drawn)
        }};
    }
    for width in [fx!(1), fx!(3.5), fx!(20)] {
        let width = LineStyle::wide(width).unwrap();
        for rows in [HEIGHT, 5, 1] {
            let (counts, drawn) = check!(BALL.edges(LineStyle::HAIRLINE), rows, options);
            assert!(counts[0].clipped > 5 && counts[0].drawn > 100, "{counts:?}");
            assert!(rows < HEIGHT || drawn == counts);
            assert!(
                rows > 1 || drawn.iter().any(|drawn| drawn.drawn < 40),
                "{drawn:?}"
            );
            check!(BALL.edges(width), rows, options);
            // Blended edges must be equal, too.
            check!(
                BALL.edges(width.smooth()),
                rows,
                options.with_blending(Opacity(99))
            );
            let (counts, drawn) = check!(BALL.outline(&OUTLINE, width), rows, options);
            assert!(rows < HEIGHT || drawn == counts);
        }
    }
    let mut short: DrawList<8, 600> = DrawList::new();
    let edges = BALL.edges(LineStyle::HAIRLINE);
    let error = short.prepare(&options, SIZE, edges, &near).unwrap_err();
    assert!(
        matches!(
            error,
            Error::Full {
                of: "edges",
                needed: 100..,
                room: 8,
                ..
            }
        ),
        "{error}"
    );
}

/// The lines are a third of a row apart, from above the frame to below it. In each band of two rows, a thin line counts
/// if it passes a row of the band. A wide line counts if it passes at most two rows above or below the band.
#[test]
fn prepared_edges_count_in_the_bands_that_they_reach() {
    let (size, rows) = ((6, 6), 2_u32);
    let middles: Vec<i32> = (-30..=48).map(|third| third * 256 / 3).collect();
    let positions: Vec<Vec3> = middles
        .iter()
        .flat_map(|&y| [[128, y], [1000, y]].map(at_subpixel))
        .collect();
    let edges: Vec<[u16; 2]> = (0..middles.len() as u16)
        .map(|edge| [2 * edge, 2 * edge + 1])
        .collect();
    let mesh = Mesh::new(&positions, &[]).unwrap();
    let mesh = mesh.with_edges(&edges).unwrap();
    let mut list: List = DrawList::new();
    let (options, mvp, pen) = (
        DrawOptions::new(),
        pixel_projection(size),
        Flat::new(Gray8::new(9)),
    );
    let thin = mesh.edges(LineStyle::HAIRLINE);
    let mut wide: List = DrawList::new();
    let width = LineStyle::wide(fx!(3)).unwrap();
    let wide = wide.prepare(&options, size, mesh.edges(width), &mvp);
    let wide = wide.unwrap();
    let listed = list.prepare(&options, size, thin, &mvp).unwrap();
    let mut color = [Gray8::new(0); 12];
    for first in (0..size.1).step_by(rows as usize) {
        let mut band = Canvas::band(&mut color, size.0, size.1, first).unwrap();
        // A line 3 pixels wide covers at most two rows beyond the row that its middle passes.
        for (reach, drawn) in [
            (0, band.draw_prepared(&listed, &pen).unwrap()),
            (2, band.draw_prepared(&wide, &pen).unwrap()),
        ] {
            let [start, end] = [first, first + rows].map(u32::cast_signed);
            let band = start - reach..end + reach;
            let reached = middles.iter().filter(|&y| band.contains(&(y >> 8)));
            assert_eq!(drawn.drawn as usize, reached.count(), "{first} {reach}");
        }
    }
    // In a viewport that begins at row 4, lines above row 4 do not count.
    let lower = DrawOptions::new().with_viewport(Viewport::new(0, 4, 6, 6).unwrap());
    let listed = list.prepare(&lower, size, thin, &mvp).unwrap();
    let counts = [2, 4].map(|first| {
        let mut band = Canvas::band(&mut color, size.0, size.1, first).unwrap();
        band.draw_prepared(&listed, &pen).unwrap().drawn
    });
    let reached = middles.iter().filter(|&y| (0..2).contains(&(y >> 8)));
    assert_eq!(counts, [0, reached.count() as u32]);
}

/// Faces and edges of one list, drawn in the order of the slice, equal the draw calls of the mesh and of its edges. The
/// ball crosses the near plane and the frame's left edge, and wide lines reach into bands that their ends do not touch.
#[test]
fn faces_and_edges_share_a_list() {
    let flat = |gray| Flat::new(Gray8::new(gray));
    let near = Transform::translate(vec3!(-1.5, -0.8, 2.5));
    let wide = BALL.edges(LineStyle::wide(fx!(5)).unwrap());
    let outline = RING.outline(&RING_OUTLINE, LineStyle::HAIRLINE);
    let mut objects = [
        Object::new(FacesOrEdges::from(&BALL), near, flat(60)),
        Object::new(FacesOrEdges::from(wide), near, flat(120)),
        Object::new((&RING).into(), Transform::IDENTITY, flat(180)),
        Object::new(outline.into(), Transform::IDENTITY, flat(250)),
    ];
    let (options, view) = (DrawOptions::new(), view());
    let mut expected = [Gray8::BLACK; PIXELS];
    let mut frame = Canvas::new(&mut expected, WIDTH, HEIGHT).unwrap();
    for object in &objects {
        let (mvp, shader) = (view * object.model, &object.material);
        let drawn = match object.thing {
            FacesOrEdges::Faces(mesh) => frame.draw(mesh, &mvp, shader),
            FacesOrEdges::Edges(edges) => frame.draw(edges, &mvp, shader),
        };
        assert!(drawn.drawn > 4);
        let mut same = [Gray8::BLACK; PIXELS];
        let mut canvas = Canvas::new(&mut same, WIDTH, HEIGHT).unwrap();
        assert_eq!(canvas.draw(object.thing, &mvp, shader), drawn);
    }
    let mut list: List = DrawList::new();
    let scene = list.prepare(&options, SIZE, &mut objects, &view).unwrap();
    for rows in [HEIGHT, 5, 1] {
        let mut found = Vec::new();
        for first in (0..HEIGHT).step_by(rows as usize) {
            let mut color = vec![Gray8::BLACK; (WIDTH * rows.min(HEIGHT - first)) as usize];
            let mut band = Canvas::band(&mut color, WIDTH, HEIGHT, first).unwrap();
            for (shader, part) in scene.parts(&band).unwrap() {
                band.draw_prepared(&part, shader).unwrap();
            }
            found.extend(color);
        }
        assert!(found == expected, "{rows} rows");
    }
    let mut short: DrawList<30, 600> = DrawList::new();
    let error = short.prepare(&options, SIZE, &mut objects, &view);
    let of = "triangles and edges";
    assert!(matches!(error, Err(Error::Full { of: found, .. }) if found == of));
}
