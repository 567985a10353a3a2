//! The order in which opaque surfaces are drawn. With a depth buffer and the default depth test, it decides only between
//! equal stored depths: the surface that is drawn last shows.

use embedded_graphics::pixelcolor::Rgb888;
use fixel::canvas::{
    Biased, DepthBuffer, DepthTest, FloatDepth, NoTest, TestAndWrite, TestBehind, TestNearer,
    TestOnly, WideFloatDepth, WriteOnly,
};
use fixel::prelude::*;
use rand::Rng;
use rand::seq::{IndexedRandom, SliceRandom};

use crate::bands::{Band, HEIGHT, Index, Scene, WIDTH, scene};
use crate::picture;
use support::counter::BOTH_SIDES;
use support::random::{Random, cases, sampled};

fn from_afar() -> Mvp {
    let (near, far) = (fx!(0.1), fx!(50));
    let projection = Projection::perspective(deg!(70), (WIDTH, HEIGHT), near, far).unwrap();
    projection * Transform::translate(vec3!(0, 0, -4))
}

/// Draws a frame in bands of `rows` rows over black at an infinite depth.
fn frame<D: DepthBuffer>(
    rows: u32,
    draw: &mut dyn FnMut(&mut Band<'_, D>),
) -> (Vec<Rgb888>, Vec<u16>) {
    picture((WIDTH, HEIGHT), rows, (Rgb888::default(), 0), draw)
}

/// The test draws each triangle separately to find its depths. In every order of drawing, the nearest triangle must
/// show at each pixel. Of triangles at equal depths, the last one drawn must show.
#[test]
fn the_nearest_triangle_shows_in_any_order() {
    cases(sampled(256), |random| {
        let scene = scene(random);
        let mvp = from_afar();
        let draw = |faces: &[[u16; 3]]| {
            let mesh = Mesh::new(&scene.positions, faces).unwrap();
            frame(HEIGHT, &mut |canvas: &mut Band<'_>| {
                canvas.draw_with(&BOTH_SIDES, &mesh, &mvp, &Index);
            })
        };
        let mut faces = scene.faces;
        let by = random.random_range(0..faces.len().max(1));
        for _ in 0..2 {
            let alone: Vec<_> = faces.iter().map(|&face| draw(&[face])).collect();
            let (color, depth) = draw(&faces);
            for pixel in 0..depth.len() {
                let mut shown = (Rgb888::default(), 0);
                for (index, (alone, depths)) in (0..).zip(&alone) {
                    if alone[pixel] != Rgb888::default() && depths[pixel] >= shown.1 {
                        shown = (Rgb888::new(255, 0, index), depths[pixel]);
                    }
                }
                let found = (color[pixel], depth[pixel]);
                assert_eq!(found, shown, "{pixel} of {faces:?}, {:?}", scene.positions);
            }
            faces.reverse();
            faces.rotate_left(by);
        }
    });
}

/// The depth test of a draw call.
#[derive(Clone, Copy, Debug)]
enum Rule {
    TestAndWrite,
    TestOnly,
    TestNearer,
    TestBehind,
    WriteOnly,
    NoTest,
}

impl Rule {
    const ALL: [Self; 6] = [
        Self::TestAndWrite,
        Self::TestOnly,
        Self::TestNearer,
        Self::TestBehind,
        Self::WriteOnly,
        Self::NoTest,
    ];

    /// Whether a pixel is drawn over a stored depth.
    fn shows(self, depth: u16, stored: u16) -> bool {
        match self {
            Self::TestAndWrite | Self::TestOnly => depth >= stored,
            Self::TestNearer => depth > stored.saturating_add(3),
            Self::TestBehind => depth < stored,
            Self::WriteOnly | Self::NoTest => true,
        }
    }

    /// Whether the depth of a drawn pixel is stored.
    fn writes(self) -> bool {
        matches!(
            self,
            Self::TestAndWrite | Self::TestNearer | Self::WriteOnly
        )
    }
}

/// A draw call: a triangle in its own color.
#[derive(Clone, Copy, Debug)]
struct Call {
    face: [u16; 3],
    color: Rgb888,
    rule: Rule,
    /// The steps of [`Biased`] around the depth test; `None` for the depth test itself.
    bias: Option<i32>,
}

impl Call {
    fn draw<D: DepthBuffer>(&self, scene: &Scene, canvas: &mut Band<'_, D>) {
        match self.rule {
            Rule::TestAndWrite => self.draw_biased(TestAndWrite, scene, canvas),
            Rule::TestOnly => self.draw_biased(TestOnly, scene, canvas),
            Rule::TestNearer => self.draw_biased(TestNearer, scene, canvas),
            Rule::TestBehind => self.draw_biased(TestBehind, scene, canvas),
            Rule::WriteOnly => self.draw_biased(WriteOnly, scene, canvas),
            Rule::NoTest => self.draw_biased(NoTest, scene, canvas),
        }
    }

    fn draw_biased<D: DepthBuffer>(
        &self,
        test: impl DepthTest<Bias = ()>,
        scene: &Scene,
        canvas: &mut Band<'_, D>,
    ) {
        match self.bias {
            Some(steps) => self.draw_with(Biased::new(test, steps, fx!(0)), scene, canvas),
            None => self.draw_with(test, scene, canvas),
        }
    }

    fn draw_with<D: DepthBuffer>(
        &self,
        test: impl DepthTest,
        scene: &Scene,
        canvas: &mut Band<'_, D>,
    ) {
        let faces = [self.face];
        let mesh = Mesh::new(&scene.positions, &faces).unwrap();
        let options = BOTH_SIDES.with_depth_test(test);
        canvas.draw_with(&options, &mesh, &from_afar(), &Flat::new(self.color));
    }

    /// The depth at each pixel of the triangle, as this draw call tests and stores it.
    fn depths<D: DepthBuffer>(&self, scene: &Scene) -> Vec<Option<u16>> {
        let (colors, depths) = frame(HEIGHT, &mut |canvas: &mut Band<'_, D>| {
            let always = Biased::new(WriteOnly, self.bias.unwrap_or(0), fx!(0));
            self.draw_with(always, scene, canvas);
        });
        let is_drawn = colors.iter().map(|&color| color == self.color);
        let pixels = is_drawn.zip(depths);
        pixels
            .map(|(is_drawn, depth)| is_drawn.then_some(depth))
            .collect()
    }
}

/// A few triangles, each drawn by one or more draw calls of different colors. This way, many draw calls have equal depths.
fn calls(random: &mut Random, scene: &Scene, rules: &[Rule]) -> Vec<Call> {
    (1..=random.random_range(2..20))
        .filter_map(|number| {
            Some(Call {
                face: *scene.faces.choose(random)?,
                color: Rgb888::new(255, 0, number),
                rule: *rules.choose(random)?,
                bias: None,
            })
        })
        .collect()
}

/// Draws the calls one after another.
fn draw<D: DepthBuffer>(rows: u32, scene: &Scene, calls: &[Call]) -> (Vec<Rgb888>, Vec<u16>) {
    frame(rows, &mut |canvas: &mut Band<'_, D>| {
        for call in calls {
            call.draw(scene, canvas);
        }
    })
}

/// The pictures of the same draw calls in two orders are equal wherever one call alone is the nearest. Where several
/// calls are the nearest, each picture shows the last of them.
fn order_decides_equal_depths<D: DepthBuffer>(random: &mut Random) -> [usize; 2] {
    let scene = scene(random);
    let mut calls = calls(random, &scene, &[Rule::TestAndWrite]);
    let before = draw::<D>(HEIGHT, &scene, &calls);
    let shown_last = |calls: &[Call]| -> Vec<(Option<Rgb888>, usize)> {
        let depths: Vec<_> = calls.iter().map(|call| call.depths::<D>(&scene)).collect();
        let at = |pixel: usize| {
            let nearest = depths.iter().filter_map(|depths| depths[pixel]).max();
            let is_nearest = |depths: &[Option<u16>]| nearest.is_some() && depths[pixel] == nearest;
            let all = calls.iter().zip(&depths);
            let nearest = all.filter(|(_, depths)| is_nearest(depths));
            let colors: Vec<_> = nearest.map(|(call, _)| call.color).collect();
            (colors.last().copied(), colors.len())
        };
        (0..before.0.len()).map(at).collect()
    };
    let first = shown_last(&calls);
    calls.shuffle(random);
    let second = shown_last(&calls);
    let after = draw::<D>(random.random_range(1..HEIGHT), &scene, &calls);
    assert_eq!(before.1, after.1, "{calls:?}, {scene:?}");
    let mut decided = [0; 2];
    for (pixel, ((one, count), (other, _))) in first.into_iter().zip(second).enumerate() {
        let (before, after) = (before.0[pixel], after.0[pixel]);
        if count == 1 {
            assert_eq!(before, after, "pixel {pixel}: {calls:?}, {scene:?}");
        }
        assert_eq!(
            [before, after],
            [one, other].map(Option::unwrap_or_default),
            "pixel {pixel}: {calls:?}, {scene:?}"
        );
        decided[0] += usize::from(count == 1);
        decided[1] += usize::from(before != after);
    }
    decided
}

#[test]
fn the_order_of_draw_calls_decides_only_between_equal_depths() {
    let mut decided = [0; 2];
    cases(sampled(256), |random| {
        let formats = [
            order_decides_equal_depths::<LinearDepth>,
            order_decides_equal_depths::<FloatDepth>,
            order_decides_equal_depths::<WideFloatDepth>,
        ];
        for format in formats {
            let [by_depth, by_order] = format(random);
            decided = [decided[0] + by_depth, decided[1] + by_order];
        }
    });
    let least = sampled(256) as usize * 200;
    assert!(
        decided.into_iter().all(|count| count > least),
        "{decided:?}"
    );
}

/// Draw calls with all depth tests, mixed. Each shows where its rule says. At equal depths, it shows over the calls before
/// it, except with `TestNearer` and `TestBehind`, which keep the first. Only a call that writes changes what later calls
/// are tested against.
fn tests_keep_their_rules<D: DepthBuffer>(random: &mut Random) {
    let scene = scene(random);
    let mut calls = calls(random, &scene, &Rule::ALL);
    for call in &mut calls {
        call.bias = random.random::<bool>().then(|| random.random_range(-6..=6));
    }
    let depths: Vec<_> = calls.iter().map(|call| call.depths::<D>(&scene)).collect();
    let found = draw::<D>(random.random_range(1..=HEIGHT), &scene, &calls);
    for pixel in 0..found.0.len() {
        let (mut color, mut stored) = (Rgb888::default(), 0);
        for (call, depths) in calls.iter().zip(&depths) {
            if let Some(depth) = depths[pixel]
                && call.rule.shows(depth, stored)
            {
                color = call.color;
                if call.rule.writes() {
                    stored = depth;
                }
            }
        }
        let found = (found.0[pixel], found.1[pixel]);
        assert_eq!(
            found,
            (color, stored),
            "pixel {pixel}: {calls:?}, {scene:?}"
        );
    }
}

#[test]
fn each_depth_test_keeps_its_rule_in_any_order() {
    cases(sampled(256), |random| {
        tests_keep_their_rules::<LinearDepth>(random);
        tests_keep_their_rules::<FloatDepth>(random);
        tests_keep_their_rules::<WideFloatDepth>(random);
    });
}
