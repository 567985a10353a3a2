//! The promises of the modes for textured triangles: random triangles in a picture of 320x240, and the hardest
//! triangles.

use std::array;

use fixel::prelude::*;
use fixel::view::Perspective;
use rand::Rng;

use crate::triangle::Triangle;
use support::bounds::{self, Bound};
use support::mode::Mode;
use support::random::{Random, cases, sampled, within};

const SIZE: (u32, u32) = (320, 240);
const FOCAL: i16 = 200;
/// Units of a texture coordinate per repeat of 256 texels.
const REPEAT: f64 = 16_777_216.;
/// Units of a texture coordinate per texel.
const TEXEL: f64 = 65536.;

/// A triangle: its corners in pixels, and 1/w, u and v at each corner. u and v are in repeats.
#[derive(Clone, Copy, Debug)]
struct Case {
    screen: [[f64; 2]; 3],
    inverse_w: [f64; 3],
    uv: [[f64; 3]; 2],
}

/// A position in or near the picture.
fn about(random: &mut Random) -> [f64; 2] {
    within(random, [-40.0..360., -40.0..280.])
}

/// A triangle in or around the picture: of any shape, thin, small, with few rows, or with a row of any length.
fn shape(random: &mut Random) -> [[f64; 2]; 3] {
    match random.random_range(0..13) {
        0 => [about(random), about(random), about(random)],
        1..=2 => {
            let (a, b, way) = (about(random), about(random), random.random_range(-0.2..1.2));
            let beside = |i: usize| a[i] + way * (b[i] - a[i]) + random.random_range(-0.5..0.5);
            [a, b, array::from_fn(beside)]
        }
        3..=4 => {
            let at = within(random, [0.0..320., 0.0..240.]);
            [at; 3].map(|corner| corner.map(|x| x + random.random_range(-6.0..6.)))
        }
        5..=8 => {
            let top = random.random_range(0.0..240.);
            [about(random), about(random), about(random)].map(|[x, y]| [x, top + y / 80.])
        }
        _ => {
            // The row through the middle is half as long as the base.
            let length = f64::from(random.random_range(1..=320));
            let x = random.random_range(0.0..1.) * (320. - length);
            let y = f64::from(random.random_range(0..240));
            let apex = random.random_range(0.0..1.);
            [
                [x - length / 2., y],
                [x + 1.5 * length, y],
                [x + apex * length, y + 1.],
            ]
        }
    }
}

/// The change of 1/w per pixel to the right and down, relative to the smallest 1/w in the picture.
fn slope(random: &mut Random) -> [f64; 2] {
    if random.random_ratio(1, 4) {
        // As on a floor, 1/w is constant or nearly constant along a row.
        let across = if random.random() {
            0.
        } else {
            random.random_range(-16.0..-8_f64).exp2()
        };
        return [across, random.random_range(-8.0..0_f64).exp2()];
    }
    let steep = match random.random_range(0..5) {
        0..=1 => random.random_range(-14.0..-4_f64).exp2(),
        // Slopes near the limit. Beyond it, a reciprocal is not computed from earlier reciprocals.
        2..=3 => random.random_range(0.97..1.01) / 64.,
        _ => random.random_range(-5.0..2_f64).exp2(),
    };
    let across = if random.random() { steep } else { -steep };
    [across, steep * random.random_range(-1.0..1.)]
}

/// A triangle with 1/w on a slope across the picture, or with any values of 1/w up to a ratio of 1000.
fn case(random: &mut Random) -> Case {
    let screen = shape(random);
    let inverse_w = if random.random() {
        let slope = slope(random);
        let inverse_w = screen.map(|[x, y]| slope[0] * x + slope[1] * y);
        let least = inverse_w.into_iter().fold(f64::MAX, f64::min);
        inverse_w.map(|q| q - least + 1.)
    } else {
        let spread = random.random_range(0.0..10.);
        [(); 3].map(|()| (-spread * random.random::<f64>()).exp2())
    };
    let most = inverse_w.into_iter().fold(0., f64::max);
    let nearest = random.random_range(0.5..4.);
    let kind = random.random_range(0..7);
    let uv = [[(); 3]; 2].map(|corners| {
        corners.map(|()| match kind {
            0..=2 => random.random_range(0.0..1.),
            3 => random.random_range(0.0..4.),
            // With this many repeats, u and v have 28 bits.
            4..=5 => random.random_range(4.0..7.),
            _ => f64::from(random.random_range(0..2)),
        })
    });
    Case {
        screen,
        inverse_w: inverse_w.map(|q| q / most / nearest),
        uv,
    }
}

impl Case {
    fn triangle(&self) -> Option<Triangle<Perspective, 2>> {
        let mut positions = [Vec3::ZERO; 3];
        for ((position, q), [x, y]) in positions.iter_mut().zip(self.inverse_w).zip(self.screen) {
            let scale = 1. / q / f64::from(FOCAL);
            let at = [(x - 160.) * scale, (120. - y) * scale, -1. / q].map(Scalar::try_from);
            let [Ok(x), Ok(y), Ok(z)] = at else {
                return None;
            };
            *position = Vec3::new(x, y, z);
        }
        let w = positions.map(|p| -f64::from(p.z));
        let projection =
            Projection::from_focal_length(Scalar::from(FOCAL), SIZE, fx!(0.015_625), fx!(32767));
        Some(Triangle {
            size: SIZE,
            mvp: projection.unwrap().into(),
            positions,
            values: self
                .uv
                .map(|corners| corners.map(|at| (at * REPEAT).round() as i32)),
            w,
            depth: w.map(|w| 65535. / 64. / w),
        })
    }
}

/// A mode's largest errors: relative to the bound of the formats, and in texels beyond the mode's tolerance. The error
/// in texels, and the number of values, are only from pixels for which the mode makes a promise.
#[derive(Clone, Copy, Debug, Default)]
struct Worst {
    allowed: f64,
    texels: f64,
    pixels: usize,
    /// The number of these values that are more than 16 times as far away as the nearest corner.
    deep: usize,
    /// The largest error relative to the bound that the page of limits states for any depth ratio, and the number of
    /// values for which the mode makes no promise.
    stated: f64,
    unpromised: usize,
}

/// Whether a mode's promise holds. This depends on a product: the repeats of the texture, times the pixel's w relative
/// to the nearest corner's w.
///
/// For each repeat, an interpolant's unit is at most 4¼ · 2⁻³⁰ · w of a repeat. For a product of 1, this is 2⁻⁶ · 4¼
/// units of 2⁻¹⁶ texel, and 56½ times as much is 3¾ units. Up to a product of 16, the error of `Exact` is at most 61½ +
/// 1 units; 0.001 texel is 65½ units. To this, `Newton::NARROW` adds the larger of two errors: 28½ units where a row is
/// straight, or 8 units for each repeat. Its interpolants have 28 bits, which adds 16 units, or 21.2 units for one
/// repeat without a far corner. So the derivation proves the promise up to a product of 4 for one repeat, and of 5 for
/// two. A larger error needs roundings that all have the same sign, in a row that is as level as possible. Up to a
/// product of 16, this test shows that the promise is kept. The default adds its tolerance in small triangles, where
/// nothing else adds more than 10 units (see `bounds::newton`); elsewhere, it draws as `Newton::NARROW` does. `Fast`
/// can use 1/32 texel besides its tolerance. For one repeat, the 16-bit reciprocals use up to 0.0297 texel (see
/// `bounds::fast`). For more repeats, they use proportionally more. So the promise of `Fast` is for one repeat, at the
/// span's farthest pixel.
///
/// In a very deep triangle, `Exact` recomputes the interpolants at each pixel. A numerator is then rounded by half of
/// its unit. For a product of 1, this is 1/32 unit of 2⁻¹⁶ texel, and the truncation of a corner's 1/w moves a value by
/// 1/64 unit. For a product of 1,000, both together are 47 units, and 48½ with the quotient.
fn is_promised(mode: Mode, is_precise: bool, repeats: f64, far: f64) -> bool {
    match mode {
        Mode::Exact if is_precise => repeats * far <= 1000.,
        Mode::Fast(texels) if texels > Scalar::ZERO => repeats <= 1. && far <= 16.,
        _ => repeats * far <= 16.,
    }
}

/// The bound in texels that the page of limits states for any depth ratio up to 2¹⁹ and for `repeats` repeats: the
/// bound that the mode promises at a ratio of 1, plus an error in proportion to the ratio.
///
/// The unit of an interpolant is at most 4¼ · 2⁻³⁰ · w of a repeat, which is 1.02 · 10⁻⁶ texel · w. Stepped
/// interpolants have an error of 56½ units: 5.8 · 10⁻⁵. At a ratio of 2¹⁹, this error is a fiftieth larger, because 1/w
/// itself is too small by up to 40 units of 2,048. Interpolants that `Exact` recomputes have an error of 0.51 units. A
/// corner's 1/w adds a unit of 1/w, 2.4 · 10⁻⁷, for each repeat between the corners. There are two repeats if corners
/// have opposite signs. The sum is 10⁻⁶.
fn stated(mode: Mode, is_precise: bool, repeats: f64, far: f64) -> f64 {
    let (base, slope) = match mode {
        Mode::Exact if is_precise => (0.001, 1e-6),
        Mode::Fast(_) => (1. / 32., 6e-5),
        _ => (0.001, 6e-5),
    };
    mode.tolerance() + repeats * (base + slope * far)
}

/// For one texture coordinate of a triangle: the numbers in its bounds that are the same at all pixels.
struct Attribute {
    /// The bound in each mode.
    bounds: [Bound; MODES],
    /// The smallest and the largest value at a corner.
    least: f64,
    most: f64,
    /// The number of repeats of the texture between 0 and the corner farthest from 0; at least 1.
    repeats: f64,
    newton_from_exact: Option<f64>,
}

impl Attribute {
    fn new(corners: [i32; 3], w: [f64; 3]) -> Self {
        let values = corners.map(f64::from);
        Self {
            bounds: Mode::PERSPECTIVE.map(|mode| Bound::perspective(mode, corners, w)),
            least: values.into_iter().fold(f64::INFINITY, f64::min),
            most: values.into_iter().fold(f64::NEG_INFINITY, f64::max),
            repeats: values
                .into_iter()
                .fold(REPEAT, |most, value| most.max(value.abs()))
                / REPEAT,
            newton_from_exact: bounds::newton_from_exact(corners, w),
        }
    }
}

impl Case {
    /// Draws the triangle in every mode. Checks each pixel against the bound of the formats and against the promise, if
    /// the mode makes one.
    fn check(&self, worst: &mut [Worst; MODES]) {
        let Some(triangle) = self.triangle() else {
            return;
        };
        let Some(screen) = triangle.screen() else {
            return;
        };
        let model = triangle.model(screen);
        let nearest = triangle.w.into_iter().fold(f64::MAX, f64::min);
        let farthest = triangle.w.into_iter().fold(0., f64::max);
        let is_precise = bounds::is_precise(triangle.w);
        let attributes = triangle
            .values
            .map(|corners| Attribute::new(corners, triangle.w));
        let exact = triangle.draw(Mode::Exact);
        for (i, (mode, worst)) in Mode::PERSPECTIVE.into_iter().zip(worst).enumerate() {
            let seen = triangle.draw(mode);
            assert!(
                seen.iter()
                    .map(|seen| seen.pixel)
                    .eq(model.iter().map(|model| model.pixel)),
                "{self:?}"
            );
            let (tolerance, promised) = (mode.tolerance(), mode.promised());
            for ((seen, exact), model) in seen.iter().zip(&exact).zip(&model) {
                let [w, far_w] = [model.w, model.farthest];
                let far = match mode {
                    Mode::Fast(_) => far_w,
                    _ => w,
                };
                for (k, attribute) in attributes.iter().enumerate() {
                    let value = f64::from(seen.values[k]);
                    let error = (value - model.values[k]).abs();
                    let at = || format!("{mode:?}: {self:?} at {:?}: {error}", seen.pixel);
                    let allowed = attribute.bounds[i].at(w, far_w);
                    assert!(error <= allowed, "{}, over {allowed}", at());
                    worst.allowed = worst.allowed.max(error / allowed);
                    if farthest <= 524_288. * nearest {
                        let stated = stated(mode, is_precise, attribute.repeats, far / nearest);
                        assert!(
                            allowed <= stated * TEXEL,
                            "{}: {allowed} is over {stated} texels",
                            at()
                        );
                        worst.stated = worst.stated.max(error / TEXEL / stated);
                    }
                    // Values must stay between the values of the corners, because a color beyond white would wrap to
                    // black. The tolerance is not allowed here, because straight pieces end within the triangle.
                    let beyond = allowed - tolerance * TEXEL;
                    assert!(
                        value >= attribute.least - beyond && value <= attribute.most + beyond,
                        "{}: {value} is beyond the corners",
                        at()
                    );
                    if let (Mode::NewtonNarrow, Some(allowed)) = (mode, attribute.newton_from_exact)
                    {
                        let by = seen.values[k].abs_diff(exact.values[k]);
                        assert!(f64::from(by) <= allowed, "{}, an error of {by}", at());
                    }

                    if is_promised(mode, is_precise, attribute.repeats, far / nearest) {
                        let texels = error / TEXEL;
                        assert!(texels <= promised, "{} is {texels} texels", at());
                        worst.texels = worst.texels.max(texels - tolerance);
                        worst.pixels += 1;
                        worst.deep += usize::from(is_precise && far / nearest > 16.);
                    } else {
                        worst.unpromised += 1;
                    }
                }
                // The depth is the largest 16-bit number at the near plane, which is at a distance of 1/64.
                let (stored, depth) = (f64::from(seen.depth), model.depth);
                assert!(
                    stored <= depth + bounds::DEPTH && depth < stored + 1. + bounds::DEPTH,
                    "{mode:?}: {self:?} at {:?}: depth {stored} is not {depth}",
                    seen.pixel
                );
            }
        }
    }
}

const MODES: usize = Mode::PERSPECTIVE.len();

fn print(name: &str, worst: &[Worst; MODES]) {
    println!("{name}");
    for (mode, worst) in Mode::PERSPECTIVE.iter().zip(worst) {
        println!(
            "  {mode:?}: {:.6} texels beyond its tolerance, at {} values; {:.3} of the bound; {:.3} of what is stated, {} \
             without promise",
            worst.texels, worst.pixels, worst.allowed, worst.stated, worst.unpromised
        );
    }
}

#[test]
fn textured_triangles_keep_the_promises() {
    let mut worst = [Worst::default(); MODES];
    cases(sampled(1200), |random| case(random).check(&mut worst));
    print("random triangles", &worst);
    for worst in worst {
        // The modes make a promise for nearly all values.
        assert!(worst.pixels > sampled(200_000) as usize, "{}", worst.pixels);
    }
}

/// Triangles with a corner 16 to 1,000 times as far away as another corner, and triangles with a corner up to 490,000
/// times as far away. Up to 1,000, `Exact` promises 0.001 texel at every pixel.
#[test]
fn deep_triangles_keep_the_promises() {
    let mut worst = [Worst::default(); MODES];
    cases(sampled(400), |random| {
        // The nearest corner is either far outside the picture, so that many pixels are far away, or in the picture.
        let (nearest, most): (_, f64) = if random.random() {
            let beyond = within(random, [-1500.0..1800., -1500.0..1700.]);
            (beyond, random.random_range(4.01..9.96))
        } else {
            (about(random), random.random_range(9.96..18.9))
        };
        let other = random.random_range(0.5..1.);
        let case = Case {
            screen: [nearest, about(random), about(random)],
            inverse_w: [1., (-most * other).exp2(), (-most).exp2()].map(|q| q * 60.),
            uv: [[(); 3]; 2].map(|corners| corners.map(|()| random.random_range(0.0..=1.))),
        };
        case.check(&mut worst);
    });
    print("deep triangles", &worst);
    let [exact, _, _, newton, ..] = worst;
    // With ten other seeds and all triangles, both numbers were 1.95 to 2.49 million.
    for judged in [exact.deep, newton.unpromised] {
        assert!(judged > sampled(1_500_000) as usize, "{judged}");
    }
}

/// The hardest deep triangles that a search found. The search changed the worst of many random triangles again and
/// again. The errors are three fifths of the bounds that the pages of limits and modes state.
#[test]
fn errors_of_deep_triangles_come_close_to_the_bound() {
    let newton = Case {
        screen: [
            [189.981_873_941_290_73, 2.213_188_513_161_602],
            [327.104_307_117_853_3, 205.192_071_163_883_75],
            [71.100_160_409_894_33, 90.200_072_375_685_11],
        ],
        inverse_w: [
            0.000_495_019_545_464_662_1,
            0.000_495_019_545_464_662_1,
            34.945_771_137_884_634,
        ],
        uv: [
            [0.592_024_191_087_893_4, 1., 1.],
            [0., 0.926_906_847_545_787_3, 1.],
        ],
    };
    let exact = Case {
        screen: [
            [-28.547_906_266_056_522, 129.168_365_261_283_58],
            [54.627_925_622_640_27, 46.380_715_344_070_13],
            [323.989_569_977_742_5, 162.541_126_555_980_8],
        ],
        inverse_w: [
            32.624_477_367_970_75,
            0.000_138_344_152_056_665_1,
            0.000_134_759_915_398_851_88,
        ],
        uv: [
            [0., 0.939_852_068_456_704_7, 1.],
            [0.945_861_383_335_324, 0.551_338_212_426_916_8, 1.],
        ],
    };
    for (case, modes) in [
        (newton, [Mode::Compact, Mode::NewtonNarrow]),
        (exact, [Mode::Exact; 2]),
    ] {
        let mut worst = [Worst::default(); MODES];
        case.check(&mut worst);
        let of_mode = Mode::PERSPECTIVE.into_iter().zip(worst);
        for (mode, worst) in of_mode.filter(|(mode, _)| modes.contains(mode)) {
            println!("{mode:?}: {:.3} of what is stated", worst.stated);
            assert!(worst.stated > 0.55, "{mode:?}: {}", worst.stated);
        }
    }
}

/// A triangle is drawn affinely if the error of its texture coordinates is below the tolerance: 1/32 texel by default if
/// the triangle is small (its width and its height add up to at most 43 pixels), otherwise 1/4096 texel.
#[test]
fn only_small_triangles_are_drawn_affinely_within_a_32nd_of_a_texel() {
    // The largest error in a triangle whose sides along the axes have this length, in units. Let r be the ratio of the
    // distances of its corners. A triangle that is drawn affinely has an error of a quarter of 8 texels times r − 1.
    let error = |mode, side: f64, texels: f64| {
        let near = 1. / (1. + 4. * texels / 8.);
        let case = Case {
            screen: [[100., 100.], [100. + side, 100.], [100., 100. + side]],
            inverse_w: [1., near, near].map(|q| q / 64.),
            uv: [[0., 8. / 256., 8. / 256.]; 2],
        };
        let triangle = case.triangle().unwrap();
        let model = triangle.model(triangle.screen().unwrap());
        let errors = triangle
            .draw(mode)
            .into_iter()
            .zip(model)
            .map(|(seen, model)| {
                let [u, _] = seen.values;
                (f64::from(u) - model.values[0]).abs()
            });
        errors.fold(0., f64::max)
    };
    let (tolerance, promised) = (TEXEL / 32., 0.001 * TEXEL);
    let below = error(Mode::Newton, 21., 0.99 / 32.);
    // A pixel is at most half a pixel, a 42nd of the side, away from the line with the largest error. There, the error is
    // smaller by (2/42)². 1/w changes by 1/64, so the error is smaller by 1/64 than the bound, too.
    assert!(below > 0.95 * tolerance && below < tolerance, "{below}");
    for (mode, side, texels) in [
        (Mode::Newton, 21., 1.01 / 32.),
        (Mode::Newton, 22., 0.99 / 32.),
        (Mode::NewtonNarrow, 21., 0.99 / 32.),
    ] {
        let other = error(mode, side, texels);
        assert!(other < promised, "{mode:?}, {side}, {texels}: {other}");
    }
}

/// Rows of every possible length, in triangles in which 1/w has a slope of either sign. The steepest slope is too steep
/// to compute a reciprocal from earlier reciprocals.
#[test]
fn spans_of_every_length_keep_the_promises() {
    let mut worst = [Worst::default(); MODES];
    for length in 1..=SIZE.0 {
        let long = f64::from(length);
        let slopes = [
            0.,
            1. / 1024.,
            1. / 320.,
            1. / 65.,
            1. / 63.,
            1. / 32.,
            1. / 8.,
            2.,
        ];
        // Each length with some slopes, and each slope with some lengths.
        let step = 8 / sampled(8) as usize;
        for slope in slopes
            .into_iter()
            .skip(length as usize % step)
            .step_by(step)
        {
            for [left, right] in [[0., 2. * long], [2. * long, 0.]] {
                let screen = [[0., 7.], [2. * long, 7.], [0.5 * long, 8.]];
                // The corners are at the left end of the base, at its right end, and between them.
                let at = |along: f64| 1. + slope * (left + (right - left) * along / (2. * long));
                let q = [at(0.), at(2. * long), at(0.5 * long)];
                let most = q.into_iter().fold(0., f64::max);
                let case = Case {
                    screen,
                    inverse_w: q.map(|q| q / most),
                    uv: [[0., 1., 0.3], [1., 0., 0.9]],
                };
                case.check(&mut worst);
            }
        }
    }
    print("spans of every length", &worst);
    // With all slopes, there are 1,560,572 values. (For other values, which are too far away, there is no promise.)
    for worst in worst {
        assert!(
            worst.pixels > sampled(1_500_000) as usize,
            "{}",
            worst.pixels
        );
    }
}

/// The rows lie along an edge, and 1/w changes by less than rounding can add. The format leaves no room there: all 31
/// bits of the nearest corner's 1/w are set, or the farthest corner has a quarter of this 1/w.
#[test]
fn rows_at_the_ends_of_the_format_keep_the_promises() {
    // All bits of a corner's 1/w are set if w / near is a power of two, in units that put the near plane at
    // 65,535/65,536.
    const NEAREST: f64 = 4096. * 65535. / 65536.;
    let unit = 1. / 65536.;
    let mut worst = [Worst::default(); MODES];
    for first in -8..8 {
        for second in (60..400).step_by(88 / sampled(8) as usize) {
            let ends = [first, second].map(f64::from);
            for flip in [false, true] {
                for (corner, toward) in [(NEAREST + 3. * unit, -unit), (8. * NEAREST, unit)] {
                    let mut ends = ends.map(|end| 4. * NEAREST + end * toward);
                    if flip {
                        ends.reverse();
                    }
                    let [from, to] = ends;
                    let case = Case {
                        screen: [[5.5, 0.5], [314.5, 0.5], [150., 2.3]],
                        inverse_w: [from, to, corner.min(32_000.)].map(f64::recip),
                        uv: [[0., 1., 1.], [1., 0.5, 0.]],
                    };
                    case.check(&mut worst);
                }
            }
        }
    }
    print("ends of the format", &worst);
    // With all rows, there are 1,769,728 values.
    for worst in worst {
        assert!(
            worst.pixels > sampled(1_700_000) as usize,
            "{}",
            worst.pixels
        );
    }
}
