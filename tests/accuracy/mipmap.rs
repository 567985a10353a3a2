//! Mipmaps: their levels, the level that a pixel shows, and how much a drawn floor differs from the mean colors of its
//! pixels.

use std::array;
use std::fmt::Debug;

use embedded_graphics::pixelcolor::raw::RawData;
use embedded_graphics::pixelcolor::{
    Bgr555, Bgr666, Gray8, GrayColor, PixelColor, Rgb565, Rgb888, RgbColor, WebColors,
};
use fixel::prelude::*;
use fixel::texture::{Blend, Mipmap};
use fixel::view::Perspective;
use rand::Rng;

use support::random::{Random, cases, sampled};
use support::reference::mipmap::{area, level, reduced};

const WIDTH: u32 = 320;
const HEIGHT: u32 = 240;
const FOCAL: f64 = 200.;

/// The two colors of the measured scenes.
const COLORS: [Rgb888; 2] = [Rgb888::CSS_IVORY, Rgb888::CSS_STEEL_BLUE];

/// The index of a texel's color in a checkered texture with squares of 8x8 texels.
fn checker(u: i64, v: i64) -> usize {
    usize::from(((u >> 3) + (v >> 3)) & 1 == 1)
}

fn projection() -> Projection<Perspective> {
    Projection::from_focal_length(fx!(200), (WIDTH, HEIGHT), fx!(0.25), fx!(100)).unwrap()
}

/// How far the eye is moved in pose `k` from its place above the measured floor: to the right, and ahead.
fn moved(k: i16) -> [f64; 2] {
    [f64::from(k) / 32., f64::from(k) / 16.]
}

fn picture(shader: &impl ShaderFor<Rgb888>, floor: &Mesh<'_>, k: i16) -> Vec<Rgb888> {
    let [x, z] = moved(k);
    let place = Vec3::try_from([-x, -1., z]).unwrap();
    let mvp = projection()
        * (Transform::rotate_x(Angle::from_bits(134_932_750)) * Transform::translate(place));
    let mut pixels = vec![Rgb888::BLACK; (WIDTH * HEIGHT) as usize];
    Canvas::new(&mut pixels, WIDTH, HEIGHT)
        .unwrap()
        .draw(floor, &mvp, shader);
    pixels
}

/// The point of the floor that pose `k` shows at a position on the screen. The point's coordinates are from 0 to 1
/// across and along the floor. Returns `None` if the position shows no floor.
fn floor(k: i16) -> impl Fn([f64; 2]) -> Option<[f64; 2]> {
    let [right, ahead] = moved(k);
    // The camera looks down a little.
    let (sine, cosine) = 0.2_f64.atan().sin_cos();
    move |[x, y]| {
        let (x, y) = ((x - 160.) / FOCAL, (120. - y) / FOCAL);
        // The ray (x, y, -1), turned by the camera.
        let (up, forth) = (y * cosine - sine, y * sine + cosine);
        let (x, z) = (x / -up + right, forth / -up + ahead);
        let inside = up < 0. && (-10. ..10.).contains(&x) && (1. ..20.).contains(&z);
        inside.then(|| [(x + 10.) / 20., 1. - (z - 1.) / 19.])
    }
}

/// The mean color of the floor over each pixel's area in pose `k`, row by row. The texture repeats `repeats` times
/// along each axis.
fn means(k: i16, repeats: f64) -> Vec<Option<[f64; 3]>> {
    let floor = floor(k);
    let colors = COLORS.map(parts);
    let texels = |[u, v]: [f64; 2]| [u * 64. * repeats, v * 64. * repeats];
    // The index of the color at a point. Coordinates are not negative, so the conversion rounds down.
    let index = |at: [f64; 2]| {
        let [u, v] = texels(at);
        checker(u as i64, v as i64)
    };
    let square = |at: [f64; 2]| {
        let [u, v] = texels(at);
        [(u / 8.).floor(), (v / 8.).floor()]
    };
    let corners: Vec<Vec<_>> = (0..=HEIGHT)
        .map(|y| (0..=WIDTH).map(|x| floor([x, y].map(f64::from))).collect())
        .collect();
    let rows = corners.windows(2).zip(0_u32..).flat_map(|(rows, y)| {
        let pairs = rows[0].windows(2).zip(rows[1].windows(2));
        pairs.zip(0_u32..).map(move |pixel| (pixel, y))
    });
    rows.map(|(((above, below), x), y)| {
        let (&[Some(a), Some(b)], &[Some(c), Some(d)]) = (above, below) else {
            return None;
        };
        // Perspective keeps quadrilaterals convex: if a pixel's corners are in one square, the whole pixel is.
        if [b, c, d].map(square) == [square(a); 3] {
            return Some(colors[index(a)]);
        }
        let share = area([x, y].map(f64::from), 16, |at| {
            index(floor(at).unwrap()) as f64
        });
        let [one, other] = colors;
        Some([0, 1, 2].map(|k| one[k] + (other[k] - one[k]) * share))
    })
    .collect()
}

fn parts(color: Rgb888) -> [f64; 3] {
    [color.r(), color.g(), color.b()].map(f64::from)
}

/// The mean difference between a drawn floor and the exact mean colors of its pixels. The mean is over all channels of
/// all of the floor's pixels, and in 255ths.
fn difference(
    shader: &impl ShaderFor<Rgb888>,
    floor: &Mesh<'_>,
    exact: &[Vec<Option<[f64; 3]>>],
) -> f64 {
    let (mut sum, mut count) = (0., 0.);
    for (k, exact) in (0..).zip(exact) {
        for (shown, exact) in picture(shader, floor, k).into_iter().zip(exact) {
            let Some(exact) = exact else { continue };
            for (shown, exact) in parts(shown).into_iter().zip(exact) {
                sum += (shown - exact).abs();
                count += 1.;
            }
        }
    }
    sum / count
}

/// With all numbers of repeats (see [`sampled`]), prints the table that the documentation of `Textured::mipmapped` shows.
#[test]
fn levels_bring_a_far_floor_closer_to_its_means() {
    let mut texels = vec![Rgb888::BLACK; Mipmap::<Rgb888>::len(64, 64)];
    for (i, texel) in (0..64 * 64).zip(&mut texels) {
        *texel = COLORS[checker(i % 64, i / 64)];
    }
    let mipmap = Mipmap::build(&mut texels, 64, 64).unwrap();
    for repeats in [32_i16, 8, 1].into_iter().take(sampled(3) as usize) {
        let exact: Vec<_> = (0..8).map(|k| means(k, repeats.into())).collect();
        let positions = [
            vec3!(-10, 0, -1),
            vec3!(10, 0, -1),
            vec3!(10, 0, -20),
            vec3!(-10, 0, -20),
        ];
        let n = Scalar::from(repeats);
        let uv = |u: Scalar, v: Scalar| Vec2::from_bits([u, v].map(|at| at.to_bits() << 4));
        let uvs = [uv(fx!(0), n), uv(n, n), uv(n, fx!(0)), uv(fx!(0), fx!(0))];
        let floor = Mesh::new(&positions, &[[0, 1, 2], [0, 2, 3]])
            .unwrap()
            .with_uvs(&uvs, None)
            .unwrap();
        let plain = Textured::new(mipmap);
        let levels = plain.mipmapped(&projection(), (WIDTH, HEIGHT)).unwrap();
        let found = [
            difference(&plain, &floor, &exact),
            difference(&plain.bilinear(), &floor, &exact),
            difference(&levels, &floor, &exact),
            difference(&levels.bilinear(), &floor, &exact),
            difference(&levels.trilinear(), &floor, &exact),
        ];
        println!("{repeats} repeats: {found:.2?}");
        // The more texels a far pixel covers, the more levels help.
        let [nearest, bilinear, level, smooth, blended] = found;
        let helps = [1., 0.8, 0.6][match repeats {
            1 => 0,
            8 => 1,
            _ => 2,
        }];
        assert!(level <= helps * nearest + 0.01, "nearest");
        assert!(
            smooth <= helps * bilinear + 0.1 && blended <= helps * bilinear + 0.1,
            "bilinear"
        );
    }
}

/// Compares every level of the mipmap of random texels with the model.
fn check_levels<C>(random: &mut Random, [width, height]: [u32; 2], channels: fn(C) -> [u8; 3])
where
    C: Blend + PixelColor + From<C::Raw> + Debug,
{
    let mut texels: Vec<C> = (0..Mipmap::<C>::len(width as usize, height as usize))
        .map(|_| C::Raw::from_u32(random.random()).into())
        .collect();
    // The memory behind level 0 can have any contents before.
    let (w, h) = (width as usize, height as usize);
    let first = texels[..w * h].to_vec();
    let mipmap = Mipmap::build(&mut texels, width, height).unwrap();
    assert_eq!([mipmap.width(), mipmap.height()], [width, height]);
    assert_eq!(mipmap.texels()[..w * h], first);
    assert_eq!(Mipmap::new(mipmap.texels(), width, height), Ok(mipmap));
    for channel in 0..3 {
        let value = |texel: &C| f64::from(channels(*texel)[channel]);
        let mut rest = mipmap.texels();
        let mut rows: Vec<Vec<f64>> = rest[..w * h]
            .chunks(w)
            .map(|row| row.iter().map(value).collect())
            .collect();
        let last = width.min(height).ilog2();
        for n in 0..=last {
            let (level, after) = rest.split_at((w * h) >> (2 * n));
            let found: Vec<f64> = level.iter().map(value).collect();
            assert_eq!(found, rows.concat(), "level {n}");
            rest = after;
            if n < last {
                rows = reduced(&rows);
            }
        }
        assert!(rest.is_empty());
    }
}

fn rgb<C: RgbColor>(color: C) -> [u8; 3] {
    [color.r(), color.g(), color.b()]
}

#[test]
fn a_level_is_the_mean_of_the_level_before() {
    cases(256, |random| {
        check_levels::<Rgb565>(random, [8, 8], rgb);
        check_levels::<Rgb565>(random, [32, 2], rgb);
        check_levels::<Bgr555>(random, [4, 16], rgb);
        check_levels::<Rgb888>(random, [16, 4], rgb);
        check_levels::<Bgr666>(random, [1, 64], rgb);
        check_levels::<Gray8>(random, [8, 8], |gray| [gray.luma(); 3]);
    });
}

/// Each level has a gray proportional to its number, so the gray of a trilinear filter shows the level.
#[test]
fn the_level_of_a_pixel_follows_the_formula() {
    const SIZE: u32 = 48;
    const STEPS: f64 = 40.;
    cases(256, |random| {
        let distance = random.random_range(0.5..60.);
        let lean: [f64; 2] = array::from_fn(|_| random.random_range(-0.95..0.95));
        // 1/z is linear on the screen. In the middle of the screen, z is `distance`.
        let share = |u: f64, v: f64| 1. + lean[0] * u + lean[1] * v;
        let corners = [[-1.2, -1.2], [3.2, -1.2], [-1.2, 3.2]].map(|[u, v]| {
            let z = distance / share(u, v);
            (share(u, v) > 0.02).then_some([u * z, v * z, -z])
        });
        let [Some(a), Some(b), Some(c)] = corners else {
            return;
        };
        let corners = [a, b, c];
        let [Ok(a), Ok(b), Ok(c)] = corners.map(Vec3::try_from) else {
            return;
        };
        let (bits, uvs) = loop {
            let bits: [[i32; 2]; 3] =
                array::from_fn(|_| array::from_fn(|_| random.random_range(-4 << 20..4 << 20)));
            let uvs = bits.map(|uv| uv.map(|at| f64::from(at) / f64::from(1 << 20)));
            let side = |i: usize, axis: usize| uvs[i][axis] - uvs[0][axis];
            if (side(1, 0) * side(2, 1) - side(1, 1) * side(2, 0)).abs() > 0.05 {
                break (bits, uvs);
            }
        };

        let (width, height) = if random.random() { (256, 64) } else { (64, 64) };
        let mut texels = Vec::new();
        for n in 0..7 {
            let gray = Gray8::new((40. * f64::from(n)) as u8);
            texels.extend(std::iter::repeat_n(
                gray,
                (width * height) as usize >> (2 * n),
            ));
        }
        let mipmap = Mipmap::new(&texels, width, height).unwrap();
        let projection =
            Projection::from_focal_length(fx!(24), (SIZE, SIZE), fx!(0.25), fx!(4000)).unwrap();
        let uv = bits.map(Vec2::from_bits);
        let positions = [a, b, c];
        let mesh = Mesh::new(&positions, &[[0, 1, 2]])
            .unwrap()
            .with_uvs(&uv, None)
            .unwrap();
        let size = [width, height].map(f64::from);
        let texels = uvs.map(|[u, v]| [u * size[0], v * size[1]]);
        let surface = Textured::new(mipmap);
        let surface = surface.mipmapped(&projection, (SIZE, SIZE)).unwrap();
        let draw = |shader: &dyn Fn(&mut Canvas<'_, Gray8>)| {
            let mut pixels = vec![Gray8::WHITE; (SIZE * SIZE) as usize];
            shader(&mut Canvas::new(&mut pixels, SIZE, SIZE).unwrap());
            pixels
        };
        let options = DrawOptions::new().with_cull(Cull::Nothing);
        let blended = draw(&|canvas| {
            canvas.draw_with(&options, &mesh, &projection, &surface.trilinear());
        });
        let nearest = draw(&|canvas| {
            canvas.draw_with(&options, &mesh, &projection, &surface);
        });
        for (i, (blended, nearest)) in blended.iter().zip(nearest).enumerate() {
            let [x, y] = [i % SIZE as usize, i / SIZE as usize].map(|at| at as f64 + 0.5 - 24.);
            let share = share(x / 24., -y / 24.);
            let z = distance / share;
            // Snapping a corner to 1/256 pixel moves `share` by up to 0.0005, far less than this limit.
            if share < 0.1 || 65535. * 0.25 / z < 33. || blended.luma() == 255 {
                continue;
            }
            let exact = level(corners, texels, 24., z).clamp(0., 6.);
            let shown = f64::from(blended.luma()) / STEPS;
            // The allowed error consists of the promised 1/8; the snapped corners, twice 0.0005 / 0.1 / ln 2; half a
            // step and a truncated weight, 2^-8; and the texels, 2^-8.
            let allowed = 1. / 8. + 0.015 + 0.5 / STEPS + 1. / 256. + 1. / 256.;
            assert!(
                (shown - exact).abs() <= allowed,
                "{shown}, not {exact}, at {x}, {y}"
            );
            let shown = f64::from(nearest.luma()) / STEPS;
            assert!(
                (shown - exact).abs() <= 0.5 + 1. / 8. + 0.02,
                "{shown}, not {exact}, at {x}, {y}"
            );
        }
    });
}

#[test]
fn a_mipmap_of_another_length_is_refused() {
    let mut texels = [Gray8::BLACK; 21];
    let error = Mipmap::new(&texels[..20], 4, 4).unwrap_err();
    assert_eq!(
        error.to_string(),
        "number of texels is 20: it must be exactly 21"
    );
    let error = Mipmap::build(&mut texels, 4, 5).unwrap_err();
    assert_eq!(
        error.to_string(),
        "height is 5: it must be a power of two, at most 32768, such as 8"
    );
    let mipmap = Mipmap::build(&mut texels, 4, 4).unwrap();
    let error = Textured::new(mipmap)
        .mipmapped(&projection(), (0, 9))
        .unwrap_err();
    assert_eq!(
        error.to_string(),
        "number of columns of the viewport is 0: it must be at least 1 and at most 4096"
    );
}
