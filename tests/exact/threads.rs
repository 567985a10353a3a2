//! Two cores: bands of a frame drawn on two threads at once equal the frame, bit for bit.

use std::sync::Barrier;
use std::thread;

use embedded_graphics::pixelcolor::raw::{BigEndian, LittleEndian};
use embedded_graphics::pixelcolor::{BinaryColor, Gray4, Rgb565, Rgb888, RgbColor};
use fixel::canvas::NoDepth;
use fixel::mode::{Affine, Exact, Fast, Mode, Newton};
use fixel::prelude::*;
use fixel::shade::{Converted, FaceLit, Lit, Tinted};
use fixel::texture::Indexed;
use fixel::view::{Parallel, Perspective};

use crate::examples::lighthouse;
use crate::examples::scenes::{self, HEIGHT, WIDTH};
use crate::golden::draw_lighthouse;

/// Values that both cores share must be `Sync`, and values that one core passes to the other must be `Send`. All types
/// of the crate are both.
const _: () = {
    const fn both<T: Send + Sync>() {}
    type Skin = [[Rgb565; 64]; 64];
    both::<Canvas<'static, Rgb565>>();
    both::<Canvas<'static, Rgb565, Native, LinearDepth>>();
    both::<Canvas<'static, Rgb565, BigEndian, NoDepth>>();
    both::<Canvas<'static, Rgb565, LittleEndian, LinearDepth>>();
    both::<Canvas<'static, BinaryColor>>();
    both::<Mesh<'static>>();
    both::<Mvp<Perspective>>();
    both::<Mvp<Parallel>>();
    both::<Projection<Perspective>>();
    both::<Camera>();
    both::<Transform>();
    both::<Viewport>();
    both::<DrawOptions<Exact>>();
    both::<DrawOptions<Newton>>();
    both::<DrawOptions<Fast>>();
    both::<DrawOptions<Affine>>();
    both::<Skin>();
    both::<Light>();
    both::<Flat<Rgb565>>();
    both::<Gouraud<Rgb565>>();
    both::<FaceColors<'static, Rgb565>>();
    both::<Lit<Converted<Flat<Rgb888>, Rgb565>>>();
    both::<FaceLit<Converted<Flat<Rgb888>, Rgb565>>>();
    both::<Textured<&'static Skin>>();
    both::<Textured<Indexed<'static, &'static [[u8; 64]; 64], Rgb565>>>();
    both::<Lit<Textured<&'static Skin>>>();
    both::<Tinted<Textured<&'static Skin>>>();
    both::<Converted<Lit<Flat<Gray4>>, Rgb565>>();
    both::<DepthView<Rgb565>>();
    both::<NormalView<Rgb565>>();
    both::<Drawn>();
    both::<Error>();
};

/// Draws rows of the frame, from the given row on, until the pixels are full. All closures have this one type, so that
/// the code of the threads is compiled once.
type DrawRows<'d> = dyn Fn(&mut [[u8; 2]], &mut [u16], u32) + Sync + 'd;

/// A band's first row, and its pixels.
type Band<'a> = (u32, &'a mut [[u8; 2]]);

/// Draws bands one after the other with a single depth buffer, as a core does.
fn work(draw: &DrawRows<'_>, rows: u32, bands: Vec<Band<'_>>) {
    let mut depth = vec![7; (WIDTH * rows) as usize];
    for (first, pixels) in bands {
        let depth = &mut depth[..pixels.len()];
        draw(pixels, depth, first);
    }
}

/// Draws the bands of a frame on two threads that start together. Each thread draws every other band, or half of the
/// frame.
fn check(draw: &DrawRows<'_>) {
    let mut frame = vec![[0; 2]; (WIDTH * HEIGHT) as usize];
    let mut depth = vec![0; frame.len()];
    draw(&mut frame, &mut depth, 0);
    assert!(
        frame.iter().any(|pixel| *pixel != frame[0]),
        "nothing drawn"
    );

    // 37 does not divide the height, so the last band has fewer rows.
    for rows in [16, 37] {
        let count = HEIGHT.div_ceil(rows);
        let splits: [(&str, &dyn Fn(u32) -> bool); 2] = [
            ("every other", &|band| band % 2 == 0),
            ("halves", &|band| band < count / 2),
        ];
        for (name, is_first) in splits {
            // No drawing leaves this pattern in the pixels, so pixels that were not drawn are found.
            let mut pixels = vec![[0xa5, 0x5a]; frame.len()];
            let bands = (0..).zip(pixels.chunks_mut((WIDTH * rows) as usize));
            let (first, second): (Vec<_>, Vec<_>) = bands.partition(|(band, _)| is_first(*band));
            let start = Barrier::new(2);
            thread::scope(|scope| {
                for core in [first, second] {
                    let bands = core.into_iter().map(|(band, pixels)| (band * rows, pixels));
                    let bands = bands.collect();
                    scope.spawn(|| {
                        start.wait();
                        work(draw, rows, bands);
                    });
                }
            });
            let differs = (0..frame.len()).find(|&at| pixels[at] != frame[at]);
            assert_eq!(differs, None, "{name} of {rows} rows: pixel of row order");
        }
    }
}

fn with_depth(draw: impl Fn(&mut Canvas<'_, Rgb565, BigEndian, LinearDepth>) + Sync) {
    check(&|pixels: &mut [[u8; 2]], depth: &mut [u16], first: u32| {
        let band = Canvas::<_, BigEndian>::band(pixels, WIDTH, HEIGHT, first).unwrap();
        let mut band = band.with_depth(depth).unwrap();
        band.clear(Rgb565::BLACK);
        draw(&mut band);
    });
}

fn without_depth(draw: impl Fn(&mut Canvas<'_, Rgb565, BigEndian>) + Sync) {
    check(&|pixels: &mut [[u8; 2]], _: &mut [u16], first: u32| {
        let mut band = Canvas::<_, BigEndian>::band(pixels, WIDTH, HEIGHT, first).unwrap();
        band.clear(Rgb565::BLACK);
        draw(&mut band);
    });
}

/// Checks textured and Gouraud-shaded scenes with depth in a mode.
fn scenes_in<I: Mode + Sync>(mode: I) {
    let options = DrawOptions::new().with_mode(mode);
    let [floor, cube] = [scenes::floor_mvp(0), scenes::cube_mvp(3)].map(Result::unwrap);
    with_depth(|canvas| {
        scenes::floor(canvas, &options, &floor);
        scenes::cube(canvas, &options, &cube);
    });
    let mvp = scenes::sphere_mvp(1).unwrap();
    with_depth(|canvas| {
        scenes::sphere(canvas, &options, &mvp);
    });
}

#[test]
fn textured_and_shaded_with_depth_in_every_mode() {
    scenes_in(Exact);
    scenes_in(Newton);
    scenes_in(Fast::within(fx!(0.25)));
    scenes_in(Fast::within(fx!(4)));
    scenes_in(Affine);
}

#[test]
fn flat_without_depth() {
    let mvp = scenes::sphere_mvp(2).unwrap();
    without_depth(|canvas| {
        scenes::sphere_flat(canvas, &DrawOptions::new(), &mvp);
    });
}

/// Lines and points are drawn by other functions than triangles, not row by row.
#[test]
fn lines_and_points_without_depth() {
    let mvp = scenes::sphere_mvp(0).unwrap();
    without_depth(|canvas| {
        canvas.draw(
            scenes::CUBE.edges(LineStyle::HAIRLINE),
            &mvp,
            &Flat::new(Rgb565::RED),
        );
        canvas.draw(
            scenes::SPHERE.points(PointStyle::PIXEL),
            &mvp,
            &Flat::new(Rgb565::WHITE),
        );
    });
}

#[test]
fn the_lighthouse_with_its_caption() {
    let projection = lighthouse::projection((WIDTH, HEIGHT)).unwrap();
    let mvp = projection * lighthouse::camera().unwrap() * Transform::IDENTITY;
    with_depth(|canvas| {
        lighthouse::sky(canvas);
        draw_lighthouse(canvas, &mvp);
        lighthouse::caption(canvas);
    });
}
