//! Raster cases as pictures. Each digit is the number of times that the pixel is drawn (`.`: never).
//!
//! Corners are given in pixels and fractions of a pixel. The center of a pixel is at one half.

use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
use fixel::canvas::Add;
use fixel::prelude::*;
use fixel::view::Parallel;
use support::counter::{BOTH_SIDES, Counter, at_subpixel, pixel_projection};

const SIZE: (u32, u32) = (8, 6);
const EMPTY: &str = "
            ........
            ........
            ........
            ........
            ........
            ........
        ";

/// Model positions for these positions on the screen, in pixels. Each coordinate must be a multiple of 1/256 pixel.
fn positions(points: &[[f64; 2]]) -> Vec<Vec3> {
    let subpixels = |at: f64| (at * 256.) as i32;
    points
        .iter()
        .map(|point| at_subpixel(point.map(subpixels)))
        .collect()
}

/// Draws a triangle for every three points, and compares how often each pixel is drawn.
#[track_caller]
fn assert_picture(points: &[[f64; 2]], options: &DrawOptions, expected: &str) {
    let positions = positions(points);
    let faces: Vec<[u16; 3]> = (0..u16::try_from(points.len()).unwrap() / 3)
        .map(|i| [3 * i, 3 * i + 1, 3 * i + 2])
        .collect();
    assert_mesh(
        &Mesh::new(&positions, &faces).unwrap(),
        &pixel_projection(SIZE),
        options,
        expected,
    );
}

#[track_caller]
fn assert_mesh(mesh: &Mesh, projection: &Mvp<Parallel>, options: &DrawOptions, expected: &str) {
    let mut counter = Counter::new(SIZE);
    counter.draw(options, mesh, projection);
    assert_counts(&mut counter, expected);
}

#[track_caller]
fn assert_counts(counter: &mut Counter, expected: &str) {
    let picture = counter.picture();
    let expected: Vec<&str> = expected.split_whitespace().collect();
    assert_eq!(picture, expected, "\ndrawn:\n{}\n", picture.join("\n"));
}

/// The corners are on pixel centers. The top edge and the left edge own their centers. The long edge from the top right
/// to the bottom left does not own its centers.
#[test]
fn corners_on_centers() {
    assert_picture(
        &[[1.5, 0.5], [1.5, 4.5], [5.5, 0.5]],
        &DrawOptions::new(),
        "
            .1111...
            .111....
            .11.....
            .1......
            ........
            ........
        ",
    );
}

/// The other half of the square in `corners_on_centers`. The long edge is its left edge, so it owns its centers. The
/// bottom edge and the right edge do not.
#[test]
fn the_long_edge_belongs_to_the_lower_half() {
    assert_picture(
        &[[1.5, 4.5], [5.5, 4.5], [5.5, 0.5]],
        &DrawOptions::new(),
        "
            ........
            ....1...
            ...11...
            ..111...
            ........
            ........
        ",
    );
}

/// A horizontal edge on pixel centers: the row belongs to the triangle below the edge.
#[test]
fn a_horizontal_edge_on_centers() {
    let (upper, lower) = (
        [[3.5, 0.], [0.5, 2.5], [6.5, 2.5]],
        [[0.5, 2.5], [3.5, 5.], [6.5, 2.5]],
    );
    assert_picture(
        &upper,
        &DrawOptions::new(),
        "
            ...1....
            ..111...
            ........
            ........
            ........
            ........
        ",
    );
    assert_picture(
        &lower,
        &DrawOptions::new(),
        "
            ........
            ........
            111111..
            ..111...
            ...1....
            ........
        ",
    );
}

/// A vertical edge on pixel centers: the column belongs to the triangle to the right of the edge.
#[test]
fn a_vertical_edge_on_centers() {
    let (left, right) = (
        [[4.5, 0.], [0., 3.], [4.5, 6.]],
        [[4.5, 0.], [4.5, 6.], [8., 3.]],
    );
    assert_picture(
        &left,
        &DrawOptions::new(),
        "
            ........
            ..11....
            .111....
            .111....
            ..11....
            ........
        ",
    );
    assert_picture(
        &right,
        &DrawOptions::new(),
        "
            ....1...
            ....11..
            ....111.
            ....111.
            ....11..
            ....1...
        ",
    );
}

/// Six triangles meet at a pixel center. Exactly one of them owns the center.
#[test]
fn a_hub_on_a_center() {
    let hub = [3.5, 2.5];
    let rim = [
        [7.5, 2.5],
        [5.5, 0.5],
        [1.5, 0.5],
        [0.5, 2.5],
        [1.5, 5.5],
        [5.5, 5.5],
    ];
    let fan: Vec<_> = (0..6)
        .flat_map(|i| [hub, rim[i], rim[(i + 1) % 6]])
        .collect();
    assert_picture(
        &fan,
        &DrawOptions::new(),
        "
            .1111...
            .11111..
            1111111.
            .111111.
            .11111..
            ........
        ",
    );
}

/// A triangle smaller than a pixel draws a pixel only if the triangle contains the pixel's center.
#[test]
fn triangles_smaller_than_a_pixel() {
    assert_picture(
        &[
            // Around a pixel center.
            [1.5, 1.25],
            [1.25, 1.75],
            [1.75, 1.75],
            // Between pixel centers.
            [3.75, 1.75],
            [3.75, 2.25],
            [4.25, 2.25],
            // One triangle has its top left corner on a pixel center, the other its bottom right corner.
            [5.5, 1.5],
            [5.5, 1.75],
            [5.75, 1.5],
            [5.25, 3.5],
            [5.5, 3.5],
            [5.5, 3.25],
            // The first sliver passes many pixel centers and contains none. The other sliver has three centers on an
            // edge, and owns only the middle one of these three.
            [0., 4.515_625],
            [7.75, 4.75],
            [7.75, 4.515_625],
            [0.5, 3.5],
            [2.5, 5.5],
            [2.5, 5.4375],
        ],
        &BOTH_SIDES,
        "
            ........
            .1...1..
            ........
            ........
            .1......
            ........
        ",
    );
}

/// A triangle without area draws no pixel, wherever it lies.
#[test]
fn no_area_no_pixel() {
    assert_picture(
        &[
            [0.5, 0.5],
            [3.5, 3.5],
            [6.5, 6.5],
            [0.5, 2.5],
            [7.5, 2.5],
            [3.5, 2.5],
            [4.5, 0.5],
            [4.5, 0.5],
            [4.5, 0.5],
        ],
        &BOTH_SIDES,
        EMPTY,
    );
}

/// Each cull mode draws the faces that it should. The default culls back faces.
#[test]
fn each_cull_mode_draws_its_faces() {
    let front = [[0., 0.], [0., 4.], [4., 0.]];
    let turned = [[8., 6.], [4., 6.], [8., 2.]];
    let both = [front, turned].concat();
    let upper = "
            111.....
            11......
            1.......
            ........
            ........
            ........
        ";
    let lower = "
            ........
            ........
            .......1
            ......11
            .....111
            ....1111
        ";
    // Both long edges run through pixel centers. The long edge of the lower triangle is its left edge, so it owns these
    // centers.
    assert_picture(&both, &DrawOptions::new(), upper);
    assert_picture(&both, &DrawOptions::new().with_cull(Cull::Back), upper);
    assert_picture(&both, &DrawOptions::new().with_cull(Cull::Front), lower);
    assert_picture(
        &both,
        &BOTH_SIDES,
        "
            111.....
            11......
            1......1
            ......11
            .....111
            ....1111
        ",
    );
}

/// The lower rows of these triangles lie completely to the left or to the right of the frame.
#[test]
fn triangles_that_slant_out_of_the_frame() {
    let corners = [
        [2., 0.],
        [6., 0.],
        [-10., 6.],
        [6., 0.],
        [10., 0.],
        [18., 6.],
    ];
    let expected = "
            .1111..1
            11......
            ........
            ........
            ........
            ........
        ";
    assert_picture(&corners, &BOTH_SIDES, expected);

    // Another function of the crate draws rows in one color.
    let positions = positions(&corners);
    let mesh = Mesh::new(&positions, &[[0, 1, 2], [3, 4, 5]]).unwrap();
    let mut pixels = [Rgb565::BLACK; (SIZE.0 * SIZE.1) as usize];
    let mut canvas = Canvas::new(&mut pixels, SIZE.0, SIZE.1).unwrap();
    canvas.draw_with(
        &BOTH_SIDES,
        &mesh,
        &pixel_projection(SIZE),
        &Flat::new(Rgb565::WHITE),
    );
    let drawn = pixels.map(|pixel| if pixel == Rgb565::BLACK { '.' } else { '1' });
    let expected = expected.chars().filter(|c| !c.is_whitespace());
    assert!(drawn.into_iter().eq(expected), "{drawn:?}");
}

/// Nothing is drawn outside the viewport, even if the mesh reaches far beyond it.
#[test]
fn a_viewport_clips() {
    let everywhere = positions(&[[-900., -900.], [-900., 900.], [900., 900.], [900., -900.]]);
    let mesh = Mesh::new(&everywhere, &[[0, 1, 2], [0, 2, 3]]).unwrap();
    let projection = pixel_projection(SIZE);
    let within = |x, y, w, h| DrawOptions::new().with_viewport(Viewport::new(x, y, w, h).unwrap());
    assert_mesh(
        &mesh,
        &projection,
        &within(2, 1, 3, 4),
        "
            ........
            ..111...
            ..111...
            ..111...
            ..111...
            ........
        ",
    );
    // This viewport lies partly outside the frame.
    assert_mesh(
        &mesh,
        &projection,
        &within(-2, 4, 4, 9),
        "
            ........
            ........
            ........
            ........
            11......
            11......
        ",
    );
    // These viewports lie completely outside the frame.
    assert_mesh(&mesh, &projection, &within(8, 0, 4, 4), EMPTY);
    assert_mesh(&mesh, &projection, &within(-4, -4, 4, 4), EMPTY);
}

/// The picture is scaled to the viewport: a viewport of half the width has half as many columns.
#[test]
fn a_viewport_scales() {
    let half = positions(&[[0., 0.], [0., 6.], [8., 6.]]);
    let mesh = Mesh::new(&half, &[[0, 1, 2]]).unwrap();
    let right = DrawOptions::new().with_viewport(Viewport::new(4, 0, 4, 6).unwrap());
    assert_mesh(
        &mesh,
        &pixel_projection(SIZE),
        &right,
        "
            ........
            ....1...
            ....11..
            ....11..
            ....111.
            ....1111
        ",
    );
}

/// From end to end, a line has one pixel per column, or per row if it is steeper than 45°. A blended line lacks its
/// last pixel if the line does not pass the center of this pixel.
#[test]
fn lines_have_the_pixels_of_their_ends() {
    let positions = positions(&[
        [0.5, 0.5],
        [7.5, 3.5],
        [1.5, 5.5],
        [0.5, 1.5],
        [7.5, 4.5],
        [2.5, 4.5],
    ]);
    let edges = [[0, 1], [2, 3], [4, 5]];
    let mesh = Mesh::new(&positions, &[])
        .unwrap()
        .with_edges(&edges)
        .unwrap();
    let mut counter = Counter::new(SIZE);
    counter.draw_edges(&DrawOptions::new(), &mesh, &pixel_projection(SIZE));
    assert_counts(
        &mut counter,
        "
            11......
            1.11....
            1...11..
            .1....11
            .1111111
            .1......
        ",
    );
    let blended = DrawOptions::new().with_blending(Add);
    counter.draw_edges(&blended, &mesh, &pixel_projection(SIZE));
    assert_counts(
        &mut counter,
        "
            11......
            1.11....
            1...11..
            .1....1.
            .111111.
            ........
        ",
    );
}

/// The vertex cache has 64 slots. Indices 0, 64 and 128 share a slot, and each must get its own vertex.
#[test]
fn corners_that_share_a_slot_of_the_vertex_cache() {
    let corners = [vec3!(-1, -1, -2), vec3!(1, -1, -3), vec3!(0, 1, -4)];
    let mut positions = [Vec3::ZERO; 129];
    for (corner, position) in corners.into_iter().enumerate() {
        positions[64 * corner] = position;
    }
    let projection = Projection::perspective(deg!(60), (16, 16), fx!(0.1), fx!(10)).unwrap();
    let draw = |positions: &[Vec3], face| {
        let mesh = Mesh::new(positions, std::slice::from_ref(&face)).unwrap();
        let (mut pixels, mut depth) = ([Rgb565::BLACK; 256], [0; 256]);
        let canvas = Canvas::new(&mut pixels, 16, 16).unwrap();
        let mut canvas = canvas.with_depth(&mut depth).unwrap();
        let drawn = canvas.draw(&mesh, &projection, &Flat::new(Rgb565::WHITE));
        assert_eq!((drawn.drawn, drawn.clipped), (1, 0));
        (pixels, depth)
    };
    assert!(draw(&corners, [0, 1, 2]) == draw(&positions, [0, 64, 128]));
}

/// A triangle counts as drawn if its bounding rectangle contains a pixel center, even if the triangle contains none.
#[test]
fn triangles_count_if_their_rectangles_have_a_center() {
    let mut counter = Counter::new(SIZE);
    for (points, count) in [
        // The rectangle contains the picture's upper left corner.
        ([[-9., 5.], [5., -9.], [-9., -9.]], 1),
        // The rectangle lies between pixel centers, or reaches a center.
        ([[1., 1.], [1.5, 1.], [1., 1.5]], 0),
        ([[1., 1.], [1.6, 1.], [1., 1.6]], 1),
        // The rectangle lies beside the picture.
        ([[-3., 5.], [-1., 5.], [-3., 1.]], 0),
    ] {
        let positions = positions(&points.map(|at| at.map(|at: f64| (at * 256.).round() / 256.)));
        let mesh = Mesh::new(&positions, &[[0, 1, 2]]).unwrap();
        let drawn = counter.draw(&BOTH_SIDES, &mesh, &pixel_projection(SIZE));
        assert_eq!(drawn.drawn, count, "{points:?}");
    }
    assert_counts(&mut counter, EMPTY);
}
