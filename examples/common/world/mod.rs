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
//! | `buildings` | roofs, windows, parts of lamps |
//! | `textures` | textures, which the compiler paints |
//! | `sky` | sky, stars, moon |
//! | `hud` | compass, gauges, map |
//!
//! | on a Cortex-M4 without FPU, optimized for speed | 320x240 | 160x128 | 128x64 |
//! |---|---:|---:|---:|
//! | million instructions a frame, mean of eight | 40.9 | 19.0 | 15.2 |
//! | RAM of colors and depths, in KiB | 300 | 80 | 32 |
//! | stack, in KiB | 10.5 | 10.5 | 10.5 |
//! | flash of textures, in KiB | 110 | 110 | 110 |
//! | flash of meshes, map and places, in KiB | 40 | 40 | 40 |
//!
//! The mirror image in the pond is drawn upside down below the water. The ground is drawn before, and hides the mirror
//! image outside of the pond.

// Coordinates of the map, and colors, are small.
#![allow(clippy::cast_possible_wrap, clippy::cast_sign_loss)]

pub mod buildings;
pub mod hud;
pub mod map;
pub mod sky;
pub mod textures;

use embedded_graphics::Drawable;
use embedded_graphics::geometry::Point;
use embedded_graphics::mono_font::{MonoTextStyle, ascii::FONT_6X10};
use embedded_graphics::pixelcolor::{GrayColor, Rgb565, Rgb888, RgbColor};
use embedded_graphics::text::{Alignment, Text};
use fixel::canvas::{Add, DepthBuffer, Opacity, Storage, TestOnly};
use fixel::mesh::Bounds;
use fixel::mode::Mode;
use fixel::prelude::*;
use fixel::shade::Colored;
use fixel::texture::Argb1555;

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

/// The color of the light of all lamps: the lamps on the map, and one lamp above the door.
const LAMPLIGHT: Rgb888 = Rgb888::new(255, 172, 82);
const LAMPS: usize = map::LAMPS.len() + 1;
const DOOR: Vec3 = vec3!(10, 1.7, 5.8);
/// The range of the lamps.
const REACH: Scalar = fx!(6.5);

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
        projection,
        size: (size.width, size.height),
        view: projection * camera,
        fog: Fog::linear(sky::HAZE.into(), fx!(3), fx!(36))?,
        options: DrawOptions::new().with_mode(mode),
        turn,
    };

    canvas.clear(sky::HAZE.into());
    sky::draw(canvas, &scene.options, &(projection * camera.sky()))?;
    let above = World::upright()?;
    scene.draw(canvas, &above)?;
    if canvas.is_in_view(&scene.options, &POND, &scene.view) {
        // The ground hides the mirror image everywhere except in the pond.
        let below = World::mirrored()?;
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
    dusk: Colored<Light>,
    /// The lamps with their places on the map.
    lamps: [(Vec3, Colored<PointLight>); LAMPS],
    layers: &'static [(&'static map::Layer, &'static textures::Tile)],
}

impl World {
    fn upright() -> Result<Self, Error> {
        static LAYERS: [(&map::Layer, &textures::Tile); 6] = [
            (&map::GRASS, &textures::GRASS),
            (&map::GRAVEL, &textures::GRAVEL),
            (&map::PAVING, &textures::PAVING),
            (&map::HEDGE, &textures::HEDGE),
            (&map::STONE, &textures::STONE),
            (&map::PLASTER, &textures::PLASTER),
        ];
        Self::new(Transform::IDENTITY, &LAYERS)
    }

    /// The mirror image: upside down below the water's surface, with its lights, and without the ground.
    fn mirrored() -> Result<Self, Error> {
        static LAYERS: [(&map::Layer, &textures::Tile); 2] = [
            (&map::STONE, &textures::STONE),
            (&map::PLASTER, &textures::PLASTER),
        ];
        let down =
            Transform::translate(Vec3::Y * (WATER * 2)) * Transform::scale_axes(vec3!(1, -1, 1));
        Self::new(down, &LAYERS)
    }

    fn new(
        model: Transform,
        layers: &'static [(&'static map::Layer, &'static textures::Tile)],
    ) -> Result<Self, Error> {
        // The light of the evening sky comes from the west.
        let from = model.direction(vec3!(-3, 2.5, 1));
        let dusk = Light::new(from, fx!(0.38), fx!(0.38))?.colored(Rgb888::new(150, 140, 215));
        let door = PointLight::new(model.point(DOOR), fx!(0.9), fx!(5))?.colored(LAMPLIGHT);
        let mut lamps = [(DOOR, door); LAMPS];
        for (lamp, &place) in lamps.iter_mut().zip(&map::LAMPS) {
            *lamp = (
                place,
                PointLight::new(model.point(place), fx!(1), REACH)?.colored(LAMPLIGHT),
            );
        }
        Ok(Self {
            model,
            dusk,
            lamps,
            layers,
        })
    }

    /// Moves the lamps with light that reaches a box to the front, and returns the number of these lamps.
    fn lamps_near(&self, bounds: &Bounds, near: &mut [Colored<PointLight>; LAMPS]) -> usize {
        let reached = self.lamps.iter().filter(|(place, _)| {
            let nearest = place.max(bounds.least).min(bounds.most);
            place.distance(nearest) < REACH
        });
        near.iter_mut()
            .zip(reached)
            .map(|(near, (_, lamp))| *near = *lamp)
            .count()
    }
}

/// The view of a frame.
struct Scene<M> {
    projection: Projection,
    size: (u32, u32),
    view: Mvp,
    fog: Fog<Rgb565>,
    options: DrawOptions<M>,
    turn: Angle,
}

impl<M: Mode> Scene<M> {
    /// Draws all solid surfaces.
    fn draw(
        &self,
        canvas: &mut Canvas<'_, Rgb565, impl Storage<Rgb565>, impl DepthBuffer>,
        world: &World,
    ) -> Result<(), Error> {
        let (mvp, fog, options) = (self.view * world.model, self.fog, &self.options);
        let mut lamps = world.lamps.map(|(_, lamp)| lamp);
        let tile = |texture: &textures::Tile| {
            let tile = Textured::new(*texture).bilinear();
            tile.mipmapped(&self.projection, self.size)
        };
        for (block, bounds) in map::BOUNDS.iter().enumerate() {
            if !canvas.is_in_view(options, bounds, &mvp) {
                continue;
            }
            let near = world.lamps_near(bounds, &mut lamps);
            let lights = (world.dusk, lamps.get(..near).unwrap_or_default());
            for (layer, texture) in world.layers {
                if let Some(mesh) = layer.block(block) {
                    canvas.draw_with(
                        options,
                        &mesh,
                        &mvp,
                        &tile(texture)?.lit(lights).in_fog(fog),
                    );
                }
            }
        }
        let slates = tile(&textures::SLATE)?.lit(world.dusk).in_fog(fog);
        canvas.draw_with(options, &buildings::ROOFS, &mvp, &slates);
        let panes = Textured::new(&textures::WINDOW).clamped().bilinear();
        canvas.draw_with(options, &buildings::WINDOWS, &mvp, &panes.in_fog(fog));

        let iron = Flat::rgb(Rgb888::new(54, 50, 56))
            .lit_faces(world.dusk)
            .in_fog(fog);
        let flame = Flat::rgb(Rgb888::new(255, 226, 150));
        for &place in &map::LAMPS {
            let part = |height: Scalar, size: Vec3| {
                let place = Vec3::new(place.x, height, place.z);
                mvp * Transform::translate(place) * Transform::scale_axes(size)
            };
            canvas.draw_with(
                options,
                &buildings::BOX,
                &part(fx!(0.7), vec3!(0.05, 0.7, 0.05)),
                &iron,
            );
            canvas.draw_with(
                options,
                &buildings::BOX,
                &part(fx!(1.55), vec3!(0.1, 0.14, 0.1)),
                &flame,
            );
            canvas.draw_with(
                options,
                &buildings::CAP,
                &part(fx!(1.7), vec3!(0.19, 0.16, 0.19)),
                &iron,
            );
        }
        self.plants(
            canvas,
            world,
            &map::TREES,
            (fx!(3), fx!(3.4)),
            &textures::TREE,
        )?;
        self.plants(
            canvas,
            world,
            &map::CYPRESSES,
            (fx!(1), fx!(4)),
            &textures::CYPRESS,
        )?;
        self.plants(
            canvas,
            world,
            &map::BUSHES,
            (fx!(1), fx!(0.9)),
            &textures::BUSH,
        )
    }

    /// Draws plants of one kind. The plants turn about their stems to face the viewer.
    fn plants<const W: usize, const H: usize>(
        &self,
        canvas: &mut Canvas<'_, Rgb565, impl Storage<Rgb565>, impl DepthBuffer>,
        world: &World,
        places: &[Vec3],
        size: (Scalar, Scalar),
        texture: &[[Argb1555; W]; H],
    ) -> Result<(), Error> {
        let plants = Sprites::new(places, size)?
            .with_axis(Vec3::Y)?
            .with_anchor(vec2!(0.5, 1));
        let leaves = Textured::new(texture).clamped().bilinear();
        let lamps = world.lamps.map(|(_, lamp)| lamp);
        let leaves = leaves.lit((world.dusk, lamps)).in_fog(self.fog);
        let options = self.options.with_cull(Cull::Nothing);
        canvas.draw_with(&options, &plants, &(self.view * world.model), &leaves);
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
        let waves = Textured::new(textures::WATER).bilinear();
        let waves = waves.mipmapped(&self.projection, self.size)?;
        let options = self
            .options
            .with_depth_test(TestOnly)
            .with_blending(Opacity(92));
        canvas.draw_with(&options, &mesh, &self.view, &waves.in_fog(self.fog));
        Ok(())
    }

    /// Draws the light in the air around lamps, and on the water.
    fn glows(
        &self,
        canvas: &mut Canvas<'_, Rgb565, impl Storage<Rgb565>, impl DepthBuffer>,
        world: &World,
    ) -> Result<(), Error> {
        let shine = self.options.with_depth_test(TestOnly).with_blending(Add);
        let glow = Textured::new(&textures::GLOW)
            .clamped()
            .bilinear()
            .map(|_, light| {
                let light = light.luma() >> 4;
                Some(Rgb565::new(light, light + light / 4, light / 3))
            });
        let glow = glow.in_fog(Fog::linear(Rgb565::BLACK, fx!(3), fx!(36))?);
        let mvp = self.view * world.model;
        canvas.draw_with(&shine, &buildings::HALOS, &mvp, &glow);
        // The lamps flicker, each at its own time.
        let scales: [Scalar; map::LAMPS.len()] = core::array::from_fn(|lamp| {
            let wave = (self.turn * (31 + 2 * lamp as i32)).sin();
            fx!(1) + fx!(0.05) * wave
        });
        for (places, size) in [
            (map::LAMPS.as_slice(), fx!(2.6)),
            (map::LAMPS.as_slice(), fx!(0.9)),
        ] {
            let sprites = Sprites::new(places, (size, size))?.with_scales(&scales)?;
            canvas.draw_with(&shine, &sprites, &mvp, &glow);
        }
        Ok(())
    }

    /// Writes a name at a point. Nearer surfaces hide it.
    fn label(
        &self,
        canvas: &mut Canvas<'_, Rgb565, impl Storage<Rgb565>, impl DepthBuffer>,
        name: &str,
        point: Vec3,
    ) {
        if let Some(at) = canvas.viewport().project(point, &self.view) {
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
