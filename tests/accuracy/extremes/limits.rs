//! Every limit that is a constant, tested with inputs from one below the limit to one above it.

use std::sync::Mutex;

use embedded_graphics::pixelcolor::Gray8;
use fixel::Window;
use fixel::mesh::Shape;
use fixel::prelude::*;
use fixel::texture::Sampler;
use fixel::view::{Perspective, ProjectionKind};

use support::counter::{BOTH_SIDES, Counter, at_subpixel, pixel_projection};

const MAX_SIZE: u32 = Canvas::<Gray8>::MAX_SIZE;
const MAX_TEXTURE: usize = Texture::<Gray8>::MAX_SIZE;

#[test]
fn canvases_beyond_their_limits_are_refused() {
    let new = |width: u32, height: u32| {
        let mut pixels = vec![Gray8::new(0); width as usize * height as usize];
        Canvas::new(&mut pixels, width, height).map(|_| ())
    };
    let refuses = |side, width, height| match new(width, height) {
        Err(Error::Count { given, max, .. }) => (given, max) == (side as usize, MAX_SIZE as usize),
        _ => false,
    };
    for side in [1, 2, MAX_SIZE - 1, MAX_SIZE] {
        assert_eq!(new(side, 1), Ok(()));
        assert_eq!(new(1, side), Ok(()));
    }
    for side in [0, MAX_SIZE + 1] {
        assert!(refuses(side, side, 1) && refuses(side, 1, side), "{side}");
    }
    assert_eq!(new(MAX_SIZE, MAX_SIZE), Ok(()));
}

/// The frame for which a list is prepared has the same limits of size as a canvas.
#[test]
fn prepared_frames_beyond_their_limits_are_refused() {
    let mesh = Mesh::new(&[], &[]).unwrap();
    let mvp = pixel_projection((1, 1));
    let mut list: DrawList<1, 1> = DrawList::new();
    for (side, is_allowed) in [
        (0, false),
        (1, true),
        (MAX_SIZE, true),
        (MAX_SIZE + 1, false),
    ] {
        for size in [(side, 1), (1, side)] {
            let prepared = list.prepare(&DrawOptions::new(), size, &mesh, &mvp);
            assert_eq!(prepared.is_ok(), is_allowed, "{size:?}");
        }
    }
}

#[test]
fn viewports_beyond_their_limits_are_refused() {
    let max = Viewport::MAX.cast_signed();
    for x in [-max - 1, -max, -max + 1, max - 1, max, max + 1] {
        assert_eq!(Viewport::new(x, 0, 1, 1).is_ok(), x.abs() <= max, "{x}");
        assert_eq!(Viewport::new(0, x, 1, 1).is_ok(), x.abs() <= max, "{x}");
    }
    for side in [0, 1, Viewport::MAX - 1, Viewport::MAX, Viewport::MAX + 1] {
        let is_allowed = (1..=Viewport::MAX).contains(&side);
        assert_eq!(Viewport::new(0, 0, side, 1).is_ok(), is_allowed, "{side}");
        assert_eq!(Viewport::new(0, 0, 1, side).is_ok(), is_allowed, "{side}");
    }
}

#[test]
fn positions_of_a_mesh_beyond_their_limit_are_refused() {
    let positions = vec![Vec3::ZERO; Mesh::MAX_POSITIONS + 1];
    for count in [Mesh::MAX_POSITIONS - 1, Mesh::MAX_POSITIONS] {
        let last = u16::try_from(count - 1).unwrap();
        let faces = [[0, last, last]];
        assert!(Mesh::new(&positions[..count], &faces).is_ok(), "{count}");
    }
    // If a mesh has one position less, it refuses the last index.
    assert!(Mesh::new(&positions[..Mesh::MAX_POSITIONS - 1], &[[0, 0, u16::MAX]]).is_err());
    let Err(Error::Count { given, max, .. }) = Mesh::new(&positions, &[]) else {
        panic!("too many positions");
    };
    assert_eq!((given, max), (Mesh::MAX_POSITIONS + 1, Mesh::MAX_POSITIONS));
}

#[test]
fn parts_of_a_shape_beyond_their_limits_are_refused() {
    let max = Shape::MAX_PARTS;
    // This is the largest cylinder, because each of its columns has four vertices.
    assert!(Shape::cylinder(max - 1).is_ok());
    assert!(Shape::plane(max - 1, 1).is_ok());
    assert!(Shape::plane(max, 1).is_ok());
    let Err(Error::Count {
        given,
        max: allowed,
        ..
    }) = Shape::plane(max + 1, 1)
    else {
        panic!("too many columns");
    };
    let most = usize::try_from(max).unwrap();
    assert_eq!((given, allowed), (most + 1, most));
    assert!(Shape::plane(0, 1).is_err());
    assert!(Shape::plane(255, 255).is_ok());
    assert!(matches!(Shape::plane(255, 256), Err(Error::Count { .. })));
}

/// A list refuses more visible vertices than 16 bits can count, even if the list has room for more.
#[test]
fn vertices_of_a_list_beyond_their_limit_are_refused() {
    // The list is static because it is too large for the stack.
    static LIST: Mutex<DrawList<65_600, 65_600>> = Mutex::new(DrawList::new());
    const MAX: usize = DrawList::<65_600, 65_600>::MAX_VERTICES;
    let size = (64, 64);
    let prepare = |seen: usize| {
        // Each vertex forms a triangle with the two vertices before it.
        let corners = [[10, 10], [10, 50], [50, 10]].map(|at| at_subpixel(at.map(|x| x * 256)));
        let positions: Vec<Vec3> = corners.into_iter().cycle().take(seen).collect();
        let faces: Vec<[u16; 3]> = (2..seen)
            .map(|i| [2, 1, 0].map(|back| u16::try_from(i - back).unwrap()))
            .collect();
        let mesh = Mesh::new(&positions, &faces).unwrap();
        let mut list = LIST.lock().unwrap();
        let prepared = list.prepare(&BOTH_SIDES, size, &mesh, &pixel_projection(size));
        prepared.map(|_| ()).map_err(|error| error.to_string())
    };
    assert_eq!(prepare(MAX - 1), Ok(()));
    assert_eq!(prepare(MAX), Ok(()));
    let refused =
        "65536 vertices are visible: the list must have room for all, and has room for 65535";
    assert_eq!(prepare(MAX + 1), Err(refused.to_owned()));
}

/// A texture of one row with the largest width, and a texture of one column with the largest height. A texture with one
/// more texel does not compile.
#[test]
fn textures_of_the_largest_sides_are_drawn() {
    static WIDE: [[Gray8; MAX_TEXTURE]; 1] = [[Gray8::new(7); MAX_TEXTURE]; 1];
    static HIGH: [[Gray8; 1]; MAX_TEXTURE] = [[Gray8::new(9)]; MAX_TEXTURE];
    for at in [i32::MIN, -1, 0, 32_767, 32_768, i32::MAX] {
        assert_eq!((&WIDE).texel(at, at), Gray8::new(7));
        assert_eq!((&HIGH).texel(at, at), Gray8::new(9));
    }
}

#[test]
fn numbers_beyond_their_formats_are_refused() {
    // The ends of the formats are accepted. A number half a unit beyond an end is refused, because it is rounded away
    // from zero.
    let unit = 1. / 65_536.;
    assert_eq!(Scalar::try_from(32_768. - unit), Ok(Scalar::MAX));
    assert!(Scalar::try_from(32_768. - unit / 2.).is_err());
    assert_eq!(Scalar::try_from(-32_768.), Ok(Scalar::MIN));
    assert!(Scalar::try_from(-32_768. - unit / 2.).is_err());
    let unit = 1. / 1_048_576.;
    assert_eq!(TexCoord::try_from(2048. - unit), Ok(TexCoord::MAX));
    assert!(TexCoord::try_from(2048. - unit / 2.).is_err());
    assert_eq!(TexCoord::try_from(-2048.), Ok(TexCoord::MIN));
    assert!(TexCoord::try_from(-2048. - unit / 2.).is_err());
}

#[test]
fn projections_beyond_their_limits_are_refused() {
    let fov =
        |bits: u32| Projection::perspective(Angle::from_bits(bits), (4, 3), fx!(1), fx!(2)).is_ok();
    let half = Angle::HALF.to_bits();
    assert_eq!(
        [0, 1, half - 1, half, half + 1].map(fov),
        [false, true, true, false, false]
    );
    let s = Scalar::from_bits;
    let planes = |near: i32, far: i32| {
        Projection::from_focal_length(fx!(1), (4, 3), s(near), s(far)).is_ok()
    };
    assert_eq!([-1, 0, 1].map(|near| planes(near, 2)), [false, false, true]);
    assert_eq!([6, 7, 8].map(|far| planes(7, far)), [false, false, true]);
    assert!(planes(1, i32::MAX) && planes(i32::MAX - 1, i32::MAX));
    let focal = |bits: i32| Projection::from_focal_length(s(bits), (4, 3), s(1), s(2)).is_ok();
    assert_eq!([-1, 0, 1, i32::MAX].map(focal), [false, false, true, true]);
    let edges = |left: i32, right: i32| {
        let ok = |result: Result<_, Error>| result.is_ok();
        let box_of = Projection::orthographic(
            Window {
                left: s(left),
                right: s(right),
                bottom: s(0),
                top: s(1),
            },
            s(0),
            s(1),
        );
        let frustum = Projection::frustum(
            Window {
                left: s(left),
                right: s(right),
                bottom: s(0),
                top: s(1),
            },
            s(1),
            s(2),
        );
        assert_eq!(box_of.is_ok(), frustum.is_ok());
        ok(frustum.map(|_| ()))
    };
    assert_eq!(
        [(5, 4), (5, 5), (5, 6)].map(|(l, r)| edges(l, r)),
        [false, false, true]
    );
    assert!(edges(i32::MIN, i32::MAX));
}

/// Whether the point straight ahead at the distance `bits` is visible.
fn seen<K: ProjectionKind>(mvp: &Mvp<K>, bits: i32) -> bool {
    let point = Vec3::from_bits([0, 0, -bits]);
    Counter::new((4, 4)).snapped(mvp, point).is_some()
}

/// Checks points before and beyond each plane, as near to the plane as its error permits. A point exactly in a plane
/// may be visible or not, because planes have 28 bits.
#[test]
fn points_show_between_near_and_far() {
    for (near, far) in [
        (1, 1000),
        (1000, 2000),
        (1 << 14, 100 << 16),
        (1 << 20, i32::MAX),
    ] {
        let s = Scalar::from_bits;
        let projection =
            Projection::<Perspective>::from_focal_length(fx!(4), (4, 4), s(near), s(far));
        let mvp = projection.unwrap().into();
        // The error of a plane's distance. The coefficients of planes have at least 28 bits.
        let units = |at: i32| (at >> 27) + 1;
        assert!(
            !seen(&mvp, near - units(near)) && seen(&mvp, near + units(near)),
            "{near}"
        );
        assert!(seen(&mvp, far - units(far)), "{near} to {far}");
        if let Some(beyond) = far.checked_add(units(far)) {
            assert!(!seen(&mvp, beyond), "{far}");
        }
        assert!(!seen(&mvp, 0) && !seen(&mvp, -near) && !seen(&mvp, i32::MIN + 1));
    }
}

/// Screen coordinates reach 2048 pixels from the viewport's center. A triangle within this guard band is drawn
/// unclipped. A triangle that reaches beyond the guard band is clipped. Both triangles must cover about the same area.
#[test]
fn triangles_beyond_the_guard_band_are_clipped() {
    let size = (64, 48);
    let center = [32 * 256, 24 * 256];
    let band = 2048 * 256;
    for axis in [0, 1] {
        for side in [-1, 1] {
            for beyond in [-2, -1, 0, 1, 2, 300] {
                let mut far = center;
                far[axis] += side * (band + beyond);
                let other = 1 - axis;
                let mut corners = [far, center, center];
                corners[1][other] -= 5 * 256 + 3;
                corners[2][other] += 7 * 256 + 1;
                let positions = corners.map(at_subpixel);
                let mesh = Mesh::new(&positions, &[[0, 1, 2]]).unwrap();
                let mut counter = Counter::new(size);
                let drawn = counter.draw(&BOTH_SIDES, &mesh, &pixel_projection(size));
                // Rounding in clip space moves a corner by less than a subpixel.
                if beyond.abs() > 1 {
                    assert_eq!(
                        drawn.clipped,
                        u32::from(beyond > 0),
                        "{axis} {side} {beyond}"
                    );
                }
                let counts = counter.take();
                let covered = counts.iter().sum::<u32>();
                // The approximate area of the visible part of a triangle 2048 pixels long and 12 wide.
                let length = [32., 24.][axis];
                let area = 12. * length * (1. - length / 2048. / 2.);
                assert!(
                    (f64::from(covered) - area).abs() < 0.5 * length,
                    "{covered} pixels for an area of {area}"
                );
                assert!(counts.iter().all(|&count| count < 2));
            }
        }
    }
}

/// Screen positions run from 2048 pixels before the viewport's center to one subpixel less than 2048 pixels after it.
/// Such positions have 20 bits, and the code that walks along edges relies on this.
#[test]
fn screen_positions_are_within_the_guard_band() {
    let size = (64, 48);
    let band = 2048 * 256;
    let mut ends = [0; 2];
    for beyond in -3..=3 {
        for side in [-band, band] {
            let at = side + beyond;
            let mut counter = Counter::new(size);
            for point in [[at, 0], [0, at], [at, at]] {
                let [x, y] = [point[0] + 32 * 256, point[1] + 24 * 256];
                // Move each position by half a subpixel to either side. The position at the end of the band must not be
                // rounded up.
                for half in [-128, 0, 127] {
                    let position = at_subpixel([x, y]) + Vec3::from_bits([half, half, 0]);
                    let Some(place) = counter.snapped(&pixel_projection(size), position) else {
                        continue;
                    };
                    let from = [place[0] - 32 * 256, place[1] - 24 * 256];
                    for from in from {
                        assert!((-band..band).contains(&from), "{point:?}: {from}");
                        ends = [ends[0].min(from), ends[1].max(from)];
                    }
                }
            }
        }
    }
    assert_eq!(ends, [-band, band - 1]);
}
