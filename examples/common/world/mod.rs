//! A little world: a walled garden at dusk, seen by someone who walks around its pond.
//!
//! The world needs only this crate and embedded-graphics, no memory besides the canvas, and no file: the compiler
//! builds the meshes from a map made of letters, and paints the textures. A picture depends on an angle only; a whole
//! turn is one walk around the pond. For each frame, or for each band of it, a program calls
//!
//! ```ignore
//! world::draw(&mut canvas, Newton::default(), Rate::rpm(8).angle_at(now_ms))?;
//! ```
//!
//! | file | contents |
//! |---|---|
//! | `map` | the map, and the meshes that the compiler makes of it |
//! | `buildings` | roofs, windows, lamps |
//! | `light` | the light, which the compiler bakes into the colors of vertices |
//! | `paint` | the shader of surfaces in this light |
//! | `textures` | textures, which the compiler paints |
//! | `sky` | sky, stars, moon |
//! | `hud` | compass, gauges, map |
//!
//! | on a microcontroller | 320x240 | 240x240 | 128x64 |
//! |---|---:|---:|---:|
//! | RAM of colors and depths, in KiB, without bands | 300 | 225 | 32 |
//! | stack, in KiB | 10 | 10 | 10 |
//! | flash of textures, in KiB | 90 | 90 | 90 |
//! | flash of meshes, map and places, in KiB | 50 | 50 | 50 |
//!
//! The compiler also bakes the light of dusk and lamps into the colors of the meshes' vertices. The program
//! `pico_world` of examples/boards draws the world in bands.
//!
//! The sky is drawn first, without depth: above the horizon, and what the pond mirrors of it. The mirror image in the pond
//! is drawn upside down below the water. The ground is drawn before, and hides the mirror image outside of the pond.

// Coordinates of the map, and colors, are small.
#![allow(clippy::cast_possible_wrap, clippy::cast_sign_loss)]

pub mod buildings;
pub mod hud;
pub mod light;
pub mod map;
pub mod paint;
pub mod sky;
pub mod textures;

use embedded_graphics::Drawable;
use embedded_graphics::geometry::Point;
use embedded_graphics::mono_font::{MonoTextStyle, ascii::FONT_6X10};
use embedded_graphics::pixelcolor::{Rgb565, RgbColor};
use embedded_graphics::text::{Alignment, Text};
use fixel::canvas::{Add, DepthBuffer, Opacity, Storage, TestOnly};
use fixel::mesh::Bounds;
use fixel::mode::Mode;
use fixel::num::Subpixel;
use fixel::prelude::*;
use fixel::texture::Argb1555;

use paint::{Evenly, Painted};

const STOPS: usize = 8;
/// The viewer's stops on the map.
pub static WALK: [Vec3; STOPS] = [
    vec3!(5.4, 1.15, 12),
    vec3!(7.4, 1.15, 14.2),
    vec3!(11, 1.15, 14.5),
    vec3!(14, 1.15, 13.2),
    vec3!(14.8, 1.15, 9.6),
    vec3!(13.4, 1.15, 6.8),
    vec3!(10, 1.15, 6.2),
    vec3!(6.4, 1.15, 8),
];
/// The points that the viewer looks at from the stops.
pub static LOOK: [Vec3; STOPS] = [
    vec3!(12, 1.2, 7),
    vec3!(11.5, 1.3, 5.5),
    vec3!(10.5, 1.3, 5),
    vec3!(9.5, 1.3, 4.5),
    vec3!(7, 1.2, 5),
    vec3!(4, 1.1, 8.5),
    vec3!(5, 1.1, 13),
    vec3!(9, 1.1, 16),
];

/// A point of a smooth closed curve through `points` (Catmull-Rom). A whole turn goes around the curve once.
fn along(points: &[Vec3; STOPS], turn: Angle) -> Vec3 {
    let place = u64::from(turn.to_bits()) * STOPS as u64;
    let (first, t) = (
        (place >> 32) as usize,
        Scalar::from_bits((place >> 16) as i32 & 0xffff),
    );
    let [a, b, c, d] = [STOPS - 1, 0, 1, 2].map(|step| points[(first + step) % STOPS]);
    let (cubic, square) = (
        (b - c) * fx!(3) + d - a,
        a * fx!(2) - b * fx!(5) + c * fx!(4) - d,
    );
    b + ((cubic * t + square) * t + c - a) * t / fx!(2)
}

/// The height of the water.
const WATER: Scalar = Scalar::from_bits((map::WATER as i32) << 12);
static POND: Bounds = Bounds::new(vec3!(8, -0.2, 8), vec3!(12, -0.1, 12));

/// The viewer's place at a moment of the walk, and the point that the viewer looks at.
#[must_use]
pub fn viewer(turn: Angle) -> (Vec3, Vec3) {
    (along(&WALK, turn), along(&LOOK, turn))
}

/// Draws the world in a mode at a moment of the walk. A whole turn is one walk around the pond.
///
/// # Errors
///
/// None: the numbers are constant.
pub fn draw(
    canvas: &mut Canvas<'_, Rgb565, impl Storage<Rgb565>, impl DepthBuffer>,
    mode: impl Mode,
    turn: Angle,
) -> Result<(), Error> {
    let (eye, target) = viewer(turn);
    let size = canvas.frame_size();
    let projection =
        Projection::perspective(deg!(58), (size.width, size.height), fx!(0.15), fx!(60))?;
    let camera = Camera::look_at(eye, target, Vec3::Y)?;
    let scene = Scene {
        eye,
        view: projection * camera,
        options: DrawOptions::new().with_mode(mode),
        turn,
    };

    canvas.clear(sky::HAZE.into());
    let (above, below) = (World::upright(), World::mirrored());
    let shows_pond = canvas.is_in_view(&scene.options, &POND, &scene.view);
    sky::draw(canvas, &scene.options, &(projection * camera.sky()))?;
    if shows_pond {
        let surface = [POND.least, POND.most].map(|at| Vec3::new(at.x, WATER, at.z));
        sky::mirror(canvas, &scene.options, &scene.view, eye, surface)?;
    }
    scene.draw(canvas, &above)?;
    if shows_pond {
        // The ground hides the mirror image everywhere except in the pond.
        scene.draw(canvas, &below)?;
        scene.glows(canvas, &below)?;
        scene.water(canvas)?;
    }
    scene.glows(canvas, &above)?;
    if size.height >= hud::LOW {
        scene.label(canvas, "The Inn", vec3!(10, 4.3, 5.4));
        scene.label(canvas, "South Gate", vec3!(10, 2.9, 16.9));
    }

    let ahead = target - eye;
    let status = hud::Status {
        place: eye,
        heading: Angle::atan2(ahead.x, -ahead.z),
        gauges: [205, 150],
    };
    let Ok(()) = status.draw(canvas, size);
    Ok(())
}

/// The world above the water, or its mirror image.
struct World {
    model: Transform,
    is_mirrored: bool,
    layers: &'static [(&'static map::Layer, &'static textures::Tile)],
}

impl World {
    const fn upright() -> Self {
        static LAYERS: [(&map::Layer, &textures::Tile); 6] = [
            (&map::GRASS, &textures::GRASS),
            (&map::GRAVEL, &textures::GRAVEL),
            (&map::PAVING, &textures::PAVING),
            (&map::HEDGE, &textures::HEDGE),
            (&map::STONE, &textures::STONE),
            (&map::PLASTER, &textures::PLASTER),
        ];
        Self {
            model: Transform::IDENTITY,
            is_mirrored: false,
            layers: &LAYERS,
        }
    }

    /// The mirror image: upside down below the water's surface, and without the ground.
    fn mirrored() -> Self {
        static LAYERS: [(&map::Layer, &textures::Tile); 2] = [
            (&map::STONE, &textures::STONE),
            (&map::PLASTER, &textures::PLASTER),
        ];
        let down =
            Transform::translate(Vec3::Y * (WATER * 2)) * Transform::scale_axes(vec3!(1, -1, 1));
        Self {
            model: down,
            is_mirrored: true,
            layers: &LAYERS,
        }
    }
}

/// Whether the pond may show the mirror image of a box to an eye.
///
/// Let the eye be e above the water, and a point h. The line from the eye to the point's mirror image meets the water after
/// the part e / (e + h) of its length. Seen from above, this is between the point, where h is 0, and `s` of the way to it,
/// where h is the height of the box. So the pond does not show the box if the pond is north, south, east or west of the
/// box and of its copy at `s` of the distance, or if a line through the eye separates pond and box.
fn mirrors(eye: Vec3, bounds: &Bounds) -> bool {
    let above = eye.y - WATER;
    let s = above / (above + (bounds.most.y - WATER).max(fx!(0)));
    let across = |vec: Vec3| [vec.x, vec.z];
    let (eye, pond) = (across(eye), [POND.least, POND.most].map(across));
    let ends = [bounds.least, bounds.most].map(across);
    let is_beside = |axis: usize| {
        let nearer = ends.map(|end| eye[axis] + (end[axis] - eye[axis]) * s);
        ends[1][axis].max(nearer[1]) < pond[0][axis] || ends[0][axis].min(nearer[0]) > pond[1][axis]
    };
    if is_beside(0) || is_beside(1) {
        return false;
    }
    // On which sides of the lines to the box's corners the pond's corners are.
    let corner =
        |ends: &[[Scalar; 2]; 2], at: usize| [ends[at & 1][0] - eye[0], ends[at >> 1][1] - eye[1]];
    let sides = (0..16).map(|at| {
        let ([x, z], [u, v]) = (corner(&ends, at & 3), corner(&pond, at >> 2));
        x * v > z * u
    });
    let left = sides.filter(|&is_left| is_left).count();
    left != 0 && left != 16
}

/// The view of a frame.
struct Scene<M> {
    eye: Vec3,
    view: Mvp,
    options: DrawOptions<M>,
    turn: Angle,
}

impl<M: Mode> Scene<M> {
    /// Draws all solid surfaces; of the mirror image, at least those that the pond shows.
    fn draw(
        &self,
        canvas: &mut Canvas<'_, Rgb565, impl Storage<Rgb565>, impl DepthBuffer>,
        world: &World,
    ) -> Result<(), Error> {
        let (mvp, options) = (self.view * world.model, &self.options);
        // From front to back, so that most hidden pixels are never shaded.
        let mut blocks: [usize; map::BOUNDS.len()] = core::array::from_fn(|block| block);
        blocks.sort_unstable_by_key(|&block| {
            let Bounds { least, most } = map::BOUNDS[block];
            self.eye.distance(self.eye.max(least).min(most))
        });
        for block in blocks {
            let bounds = &map::BOUNDS[block];
            if !self.shows(canvas, world, bounds, &mvp) {
                continue;
            }
            for (layer, texture) in world.layers {
                if let Some(mesh) = layer.block(block) {
                    let tile = Painted(Textured::new(*texture));
                    canvas.draw_with(options, &mesh, &mvp, &tile);
                }
            }
        }
        let slates = Painted(Textured::new(&textures::SLATE));
        canvas.draw_with(options, &buildings::ROOFS, &mvp, &slates);
        let panes = Textured::new(&textures::WINDOW).clamped();
        canvas.draw_with(options, &buildings::WINDOWS, &mvp, &panes);
        for (lamp, &flame) in map::LAMPS.iter().enumerate() {
            let least = flame - vec3!(0.2, 1.6, 0.2);
            let bounds = Bounds::new(least, flame + vec3!(0.2, 0.3, 0.2));
            if self.shows(canvas, world, &bounds, &mvp) {
                canvas.draw_with(options, &buildings::lamp(lamp), &mvp, &Gouraud::new());
            }
        }

        let seen = (world, &mvp);
        self.plants(canvas, seen, &map::TREES, &textures::TREE)?;
        self.plants(canvas, seen, &map::TREETOPS, textures::TREETOP)?;
        self.plants(canvas, seen, &map::CYPRESSES, &textures::CYPRESS)?;
        self.plants(canvas, seen, &map::CYPRESS_TOPS, textures::CYPRESS_TOP)?;
        self.plants(canvas, seen, &map::BUSHES, &textures::BUSH)
    }

    /// Whether something in a box of the world above may have pixels in a canvas; in the mirror image, only if the pond
    /// may show it.
    fn shows(
        &self,
        canvas: &Canvas<'_, Rgb565, impl Storage<Rgb565>, impl DepthBuffer>,
        world: &World,
        bounds: &Bounds,
        mvp: &Mvp,
    ) -> bool {
        (!world.is_mirrored || mirrors(self.eye, bounds))
            && canvas.is_in_view(&self.options, bounds, mvp)
    }

    /// Draws plants of one kind. They turn about their stems to face the viewer.
    fn plants<const W: usize, const H: usize>(
        &self,
        canvas: &mut Canvas<'_, Rgb565, impl Storage<Rgb565>, impl DepthBuffer>,
        (world, mvp): (&World, &Mvp),
        plants: &map::Plants,
        texture: &[[Argb1555; W]; H],
    ) -> Result<(), Error> {
        let (half, height) = (plants.size.0 / 2, plants.size.1);
        let (mut places, mut lights) = (
            [Vec3::ZERO; map::MOST_PLANTS],
            [RgbColor::BLACK; map::MOST_PLANTS],
        );
        let mut count = 0;
        for (&place, &light) in plants.places.iter().zip(plants.lights) {
            let least = place - Vec3::new(half, fx!(0), half);
            let most = place + Vec3::new(half, height, half);
            if !world.is_mirrored || mirrors(self.eye, &Bounds::new(least, most)) {
                (places[count], lights[count]) = (place, light);
                count += 1;
            }
        }
        let sprites = Sprites::new(&places[..count], plants.size)?
            .with_axis(Vec3::Y)?
            .with_anchor(vec2!(0.5, 1))
            .with_colors(&lights[..count])?;
        let leaves = Evenly(Textured::new(texture).clamped());
        canvas.draw_with(&self.options, &sprites, mvp, &leaves);
        Ok(())
    }

    /// Draws the water's surface. The mirror image is visible through it.
    fn water(
        &self,
        canvas: &mut Canvas<'_, Rgb565, impl Storage<Rgb565>, impl DepthBuffer>,
    ) -> Result<(), Error> {
        let (least, most) = (POND.least, POND.most);
        let corners = [
            [least.x, most.z],
            [most.x, most.z],
            [most.x, least.z],
            [least.x, least.z],
        ];
        // The waves move by two repeats of the texture in a whole turn.
        let drift = TexCoord::from_bits((self.turn.to_bits() >> 11).cast_signed());
        let positions = corners.map(|[x, z]| Vec3::new(x, WATER, z));
        let uvs = corners
            .map(|[x, z]| Vec2::new(TexCoord::ONE * (x / 2) + drift, TexCoord::ONE * (z / 2)));
        let mesh = Mesh::new(&positions, &[[0, 1, 2], [0, 2, 3]])?.with_uvs(&uvs, None)?;
        let waves = Textured::new(&textures::WATER);
        let options = self
            .options
            .with_depth_test(TestOnly)
            .with_blending(Opacity(92));
        canvas.draw_with(&options, &mesh, &self.view, &waves);
        Ok(())
    }

    /// Draws the light in the air around lamps, and on the water.
    fn glows(
        &self,
        canvas: &mut Canvas<'_, Rgb565, impl Storage<Rgb565>, impl DepthBuffer>,
        world: &World,
    ) -> Result<(), Error> {
        let shine = self.options.with_depth_test(TestOnly).with_blending(Add);
        let glow = Textured::new(&textures::GLOW).clamped();
        let mvp = self.view * world.model;
        canvas.draw_with(&shine, &buildings::HALOS, &mvp, &glow);
        let glow = Textured::new(&textures::LAMPLIGHT).clamped();
        let (mut places, mut scales) = (map::LAMPS, [fx!(1); map::LAMPS.len()]);
        let mut count = 0;
        for (lamp, &flame) in map::LAMPS.iter().enumerate() {
            let reach = vec3!(0.63, 0.63, 0.63);
            if !world.is_mirrored || mirrors(self.eye, &Bounds::new(flame - reach, flame + reach)) {
                // The lamps flicker, each at its own time.
                let wave = (self.turn * (31 + 2 * lamp as i32)).sin();
                (places[count], scales[count]) = (flame, fx!(1) + fx!(0.05) * wave);
                count += 1;
            }
        }
        let sprites =
            Sprites::new(&places[..count], (fx!(1.2), fx!(1.2)))?.with_scales(&scales[..count])?;
        canvas.draw_with(&shine, &sprites, &mvp, &glow);
        Ok(())
    }

    /// Writes a name at a point below the compass. Nearer surfaces hide it.
    fn label(
        &self,
        canvas: &mut Canvas<'_, Rgb565, impl Storage<Rgb565>, impl DepthBuffer>,
        name: &str,
        point: Vec3,
    ) {
        // The compass would cover a higher name.
        let top = Subpixel::from_bits(((hud::COMPASS + FONT_6X10.baseline) as i32) << 8);
        let at = canvas.viewport().project(point, &self.view);
        if let Some(at) = at.filter(|at| at.y >= top) {
            for (offset, color) in [(1, Rgb565::BLACK), (0, Rgb565::new(31, 58, 24))] {
                let style = MonoTextStyle::new(&FONT_6X10, color);
                let text = Text::with_alignment(
                    name,
                    Point::new(offset, offset),
                    style,
                    Alignment::Center,
                );
                let Ok(_) = text.draw(&mut canvas.label(at));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use embedded_graphics::geometry::Size;

    use super::*;

    /// Whether the water mirrors some of the points in a box to an eye inside the pond's edges.
    fn mirrors_points(eye: Vec3, bounds: &Bounds) -> bool {
        let part = |axis: usize, of: i32| {
            let [least, most] = [bounds.least, bounds.most].map(|end| end.to_bits()[axis]);
            f64::from(least) + f64::from(most - least) * f64::from(of) / 8.0
        };
        let [x, y, z] = eye.to_bits().map(f64::from);
        let (pond, water) = ([8.0 * 65536.0, 12.0 * 65536.0], f64::from(WATER.to_bits()));
        (0..9 * 9 * 9).any(|at| {
            let (px, py, pz) = (part(0, at % 9), part(1, at / 9 % 9), part(2, at / 81));
            let s = (y - water) / (y - water + (py - water).max(0.0));
            let meets = [x + (px - x) * s, z + (pz - z) * s];
            meets.iter().all(|at| pond[0] < *at && *at < pond[1])
        })
    }

    /// The first and the last row in which something is drawn.
    #[allow(clippy::large_stack_arrays)] // a test has 2 MiB of stack, and the programs for boards have no heap
    fn rows(draw: impl FnOnce(&mut Canvas<'_, Rgb565>)) -> Option<(usize, usize)> {
        let mut pixels = [Rgb565::BLACK; 320 * 240];
        draw(&mut Canvas::new(&mut pixels, 320, 240).unwrap());
        let is_drawn = |row: &[Rgb565]| row.iter().any(|&color| color != Rgb565::BLACK);
        let mut rows = pixels.chunks(320);
        let first = rows.position(is_drawn)?;
        Some((
            first,
            rows.rposition(is_drawn)
                .map_or(first, |after| first + 1 + after),
        ))
    }

    #[test]
    fn names_are_below_the_compass() {
        let size = Size::new(320, 240);
        let status = hud::Status {
            place: Vec3::ZERO,
            heading: deg!(40),
            gauges: [0; 2],
        };
        let (_, compass) = rows(|canvas| status.compass(canvas, size).unwrap()).unwrap();
        let projection = Projection::perspective(deg!(58), (320, 240), fx!(0.15), fx!(60)).unwrap();
        let scene = Scene {
            eye: Vec3::ZERO,
            view: projection * Camera::default(),
            options: DrawOptions::new(),
            turn: deg!(0),
        };
        // From above the frame to the middle of its height.
        let mut first = None;
        for step in (0..=500).rev() {
            let point = vec3!(0, 0, -3) + Vec3::Y * Scalar::from_bits(step << 9);
            if let Some((top, _)) = rows(|canvas| scene.label(canvas, "The Inn", point)) {
                assert!(top > compass, "{top}");
                first.get_or_insert(top);
            }
        }
        // Between them is only the empty row at the top of the font's cells.
        assert_eq!(first, Some(compass + 2));
    }

    #[test]
    fn everything_that_the_pond_mirrors_is_drawn() {
        let (mut seen, mut left_out) = (0, 0);
        for turn in (0..64).map(|turn| Angle::from_bits(turn << 26)) {
            let (eye, _) = viewer(turn);
            for place in map::BOUNDS.iter().copied().chain(map::LAMPS.map(|flame| {
                Bounds::new(flame - vec3!(0.2, 1.6, 0.2), flame + vec3!(0.2, 0.3, 0.2))
            })) {
                let is_seen = mirrors_points(eye, &place);
                assert!(mirrors(eye, &place) || !is_seen, "{place:?} from {eye:?}");
                seen += usize::from(is_seen);
                left_out += usize::from(!mirrors(eye, &place));
            }
        }
        assert!(
            seen > 100 && left_out > 100,
            "{seen} seen, {left_out} left out"
        );
    }
}
