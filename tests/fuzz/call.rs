//! Draws a scene in all ways that must give the same picture: with and without depth, twice, in bands, as bytes, and
//! prepared.

use std::iter;
use std::ops::Range;

use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{Point, Size};
use embedded_graphics::pixelcolor::raw::{BigEndian, LittleEndian, ToBytes};
use embedded_graphics::pixelcolor::{BinaryColor, Gray8, Rgb565, Rgb888, RgbColor};
use embedded_graphics::primitives::Rectangle;
use fixel::Drawn;
use fixel::canvas::{
    Add, Biased, Blending, ColorIndex, Contrast, DepthBuffer, ErrorDiffusion, Multiply, Opacity,
    Storage, TestAndWrite,
};
use fixel::mesh::flash::{Small, UvGrid, normal_of_8};
use fixel::mesh::{Material, Part};
use fixel::mode::Mode;
use fixel::prelude::*;
use fixel::shade::{PartColors, Translucent};
use fixel::view::ProjectionKind;

use super::scene::{Attribute, Scene, What};
use super::shaders::Bits;
use support::recorder::{Record, Seen, record};

/// A scene with numbers that the crate has accepted.
#[derive(Clone, Copy, Debug)]
pub struct Call<'a, K> {
    pub scene: &'a Scene,
    pub mesh: &'a Mesh<'a>,
    pub mvp: Mvp<K>,
    pub window: Viewport,
}

/// A picture with its depths.
#[derive(Clone, PartialEq)]
pub struct Picture {
    colors: Vec<Rgb565>,
    depths: Vec<u16>,
}

/// The color of every pixel before drawing.
const BACKGROUND: Rgb565 = Rgb565::new(1, 2, 3);

/// A list with room for two copies of all edges of a scene's few triangles, and of all pieces that clipping makes.
type List = DrawList<96, 400>;

/// Draws a thing from a list, in a frame and in bands. Returns the frame, and the counts of its draw call.
macro_rules! listed {
    ($call:expr, $list:ident.$prepare:ident($options:expr, $thing:expr), $shader:expr) => {{
        let call = $call;
        let listed = $list.$prepare($options, call.scene.size, $thing, &call.mvp);
        let listed = listed.unwrap();
        let draw = &mut |canvas: &mut Frame<'_>| canvas.draw_prepared(&listed, $shader).unwrap();
        let (frame, drawn) = call.frame(draw);
        assert!(call.in_bands(draw) == frame, "bands of a list differ");
        (frame, drawn)
    }};
}

/// Draws a thing as two objects of a scene, in a frame and in bands. The objects' material is not the shader, because
/// with the shader as material, scenes would be compiled for each shader.
macro_rules! objects {
    ($call:expr, $list:ident.$prepare:ident($options:expr, $thing:expr), $shader:expr) => {{
        let call = $call;
        let mut objects = [Object::new($thing, Transform::IDENTITY, ()); 2];
        let scene = $list.$prepare($options, call.scene.size, &mut objects, &call.mvp);
        let scene = scene.unwrap();
        let draw = &mut |canvas: &mut Frame<'_>| {
            let parts = scene.parts(canvas).unwrap();
            let drawn = parts.map(|((), part)| canvas.draw_prepared(&part, $shader).unwrap());
            drawn.last().unwrap_or_default()
        };
        assert!(
            call.in_bands(draw) == call.frame(draw).0,
            "bands of a scene differ"
        );
    }};
}

impl<K: ProjectionKind> Call<'_, K> {
    /// Draws the scene once.
    fn draw(
        &self,
        canvas: &mut Canvas<'_, Rgb565, impl Storage<Rgb565>, impl DepthBuffer>,
        options: &DrawOptions<impl Mode>,
        shader: &impl ShaderFor<Rgb565>,
    ) -> Drawn {
        let drawn = match self.scene.what {
            What::Triangles => canvas.draw_with(options, self.mesh, &self.mvp, shader),
            What::Edges if self.scene.style & 1 != 0 => {
                let mut room = vec![[0; 4]; 3 * self.mesh.faces().len()];
                let outline = self.any_outline(&mut room);
                let lines = self.mesh.outline(&outline, self.line());
                canvas.draw_with(options, lines, &self.mvp, shader)
            }
            What::Edges => {
                let lines = self.mesh.edges(self.line());
                canvas.draw_with(options, lines, &self.mvp, shader)
            }
            What::Points if self.scene.style != 0 => {
                let style = self.point_style();
                canvas.draw_with(options, self.mesh.points(style), &self.mvp, shader)
            }
            What::Points => canvas.draw_with(
                options,
                self.mesh.points(PointStyle::PIXEL),
                &self.mvp,
                shader,
            ),
            What::Sprites(billboard) => {
                let lists = billboard.lists(self.scene.positions.len());
                match billboard.sprites(&self.scene.positions, &lists) {
                    Ok(sprites) => canvas.draw_with(options, &sprites, &self.mvp, shader),
                    Err(_) => Drawn::default(),
                }
            }
        };
        assert!(drawn.clipped <= drawn.drawn && drawn.drawn + drawn.culled <= drawn.submitted);
        drawn
    }

    /// Picks at some pixels, and draws labels at the points that were hit and at some positions.
    pub fn check_picking(&self, options: &DrawOptions) {
        let (width, height) = self.scene.size;
        let (picture, _) = self.frame(&mut |canvas| {
            let screen = options.viewport.unwrap_or(canvas.viewport());
            let label = |canvas: &mut Frame<'_>, point| {
                if let Some(at) = screen.project(point, &self.mvp) {
                    let area = Rectangle::new(Point::new(-2, -1), Size::new(4, 3));
                    let Ok(()) = canvas.label(at).fill_solid(&area, BACKGROUND);
                }
            };
            for step in 0..4 {
                let [x, y] = [width, height].map(|size| (size * step / 3).cast_signed());
                let ray = screen.ray(Point::new(x, y), &self.mvp);
                let cull = options.cull;
                if let Some(hit) = ray.and_then(|ray| Ray { cull, ..ray }.hit(self.mesh)) {
                    assert!(hit.face < self.mesh.faces().len());
                    label(canvas, hit.point);
                }
            }
            for &position in &self.scene.positions {
                label(canvas, position);
            }
            Drawn::default()
        });
        assert!(
            picture == self.blank(),
            "labels in the background's color are visible"
        );
    }

    /// Checks that a single call, a call for each part, and bands draw the parts in the same colors.
    pub fn check_parts(&self, options: &DrawOptions) {
        let faces = self.mesh.faces().len();
        let mut ends = [0, 0, faces];
        for (end, byte) in ends.iter_mut().zip(&self.scene.bands[1..]) {
            *end = usize::from(*byte) % (faces + 1);
        }
        ends.sort_unstable();
        let [a, b, c] = ends;
        let parts = [(0..a, 0), (a..b, 120), (b..c, 250)];
        let parts =
            parts.map(|(faces, level)| Part::new(faces, Material::new(Rgb888::new(level, 50, 99))));

        let colors = PartColors::rgb(&parts);
        let (whole, _) =
            self.frame(&mut |canvas| canvas.draw_with(options, self.mesh, &self.mvp, &colors));
        let one_by_one = &mut |canvas: &mut Frame<'_>| {
            let mut drawn = Drawn::default();
            for part in &parts {
                let (mesh, color) = (self.mesh.part(part.faces()), Flat::rgb(part.material.color));
                drawn = canvas.draw_with(options, &mesh, &self.mvp, &color);
            }
            drawn
        };
        assert!(self.frame(one_by_one).0 == whole, "parts differ");
        assert!(self.in_bands(one_by_one) == whole, "bands of parts differ");
    }

    /// Checks that a quantized mesh with the scene's attributes looks the same in a frame, in bands, and prepared.
    pub fn check_quantized(&self, options: &DrawOptions) {
        if self.mesh.faces().is_empty() {
            return;
        }
        let (uvs, normals) = (&self.scene.uvs, &self.scene.normals);
        let coordinates = uvs.as_ref().map_or(&[][..], |uvs| &uvs.values);
        let grid = UvGrid::around(coordinates, 255);
        let stored: Vec<_> = coordinates.iter().map(|&uv| grid.nearest(uv)).collect();
        let bytes: Vec<_> = stored.iter().map(|uv| uv.map(|x| x as u8)).collect();
        assert!(stored.iter().flatten().all(|&x| x < 256));
        let short =
            |normals: &Attribute<Vec3>| normals.values.iter().copied().map(normal_of_8).collect();
        let stored: Vec<_> = normals.as_ref().map_or(vec![], short);
        let own = |faces: Option<&'_ [[u16; 3]]>| faces.unwrap_or_default().to_vec();
        let uv_faces = own(uvs.as_ref().and_then(Attribute::faces));
        let normal_faces = own(normals.as_ref().and_then(Attribute::faces));
        let (stored, bytes) = (Small::normals(&stored), Small::uvs_of_8(&bytes, grid));
        let bare = self.mesh.without_normals().without_uvs();
        let quantized =
            bare.with_quantized_attributes((&stored, &normal_faces), (&bytes, &uv_faces));
        let sun = Light::new(vec3!(1, 2, 3), fx!(0.3), fx!(0.7)).unwrap();
        let call = Call {
            mesh: &quantized,
            ..*self
        };
        call.check_frames(options, &Bits::<3>.lit(sun));
    }

    /// Checks that a mesh that is reported as out of view has no pixels, that no mesh has pixels outside its rectangle,
    /// and that normals can be computed for every mesh.
    pub fn check_mesh(&self, options: &DrawOptions) {
        let (bounds, white) = (self.mesh.bounds(), Flat::new(Rgb565::WHITE));
        let (picture, _) = self.frame(&mut |canvas| {
            let screen = options.viewport.unwrap_or(canvas.viewport());
            let _ = screen.size_on_screen(&bounds, &self.mvp);
            if !canvas.is_in_view(options, &bounds, &self.mvp) {
                return canvas.draw_with(options, self.mesh, &self.mvp, &white);
            }
            let drawn = canvas.draw_with(options, self.mesh, &self.mvp, &white);
            if let Some(area) = screen.rectangle_on_screen(&bounds, &self.mvp, 0) {
                let Ok(()) = canvas.fill_solid(&area, BACKGROUND);
            }
            drawn
        });
        assert!(
            picture.colors == self.blank().colors,
            "a mesh has pixels outside its rectangle"
        );

        let mut normals = vec![Vec3::ZERO; self.mesh.positions().len()];
        let smooth = self.mesh.with_smooth_normals(&mut normals);
        assert!(smooth.is_ok(), "{smooth:?}");
    }

    /// A line style 1 to 63 pixels wide.
    fn line(&self) -> LineStyle {
        let width = match i32::from(self.scene.style >> 1) {
            width if width % 4 > 0 => (width / 2).max(1),
            _ => 1,
        };
        LineStyle::wide(Scalar::try_from(width).unwrap()).unwrap()
    }

    /// A style of squares or discs of any size.
    fn point_style(&self) -> PointStyle {
        let style = u32::from(self.scene.style);
        let size = Scalar::from_bits(1 << (style % 31));
        let style = match style & 1 {
            0 => PointStyle::square(size).unwrap(),
            _ => PointStyle::round(size).unwrap(),
        };
        if self.scene.style & 64 == 0 {
            style
        } else {
            style.attenuated()
        }
    }

    /// Draws without a depth buffer, and records every pixel for which the shader is asked.
    pub fn record<I: Mode, F: ShaderFor<Rgb565>, const N: usize>(
        &self,
        options: &DrawOptions<I>,
        shader: F,
    ) -> Record<N, Rgb565> {
        let mut colors = vec![BACKGROUND; self.scene.pixels()];
        let (width, height) = self.scene.size;
        let mut canvas = Canvas::new(&mut colors, width, height).unwrap();
        let record = record(shader, |recorder| {
            self.draw(&mut canvas, options, recorder);
        });

        // Each pixel must have the color that was drawn there last. A pixel where no color was drawn must be unchanged.
        let mut expected = vec![BACKGROUND; colors.len()];
        for seen in &record.seen {
            if let Some(color) = seen.color {
                expected[self.index(seen.pixel)] = color;
            }
        }
        assert!(colors == expected, "without depth: other pixels");
        record
    }

    /// The index of a pixel in memory. Panics if the pixel lies outside the canvas or the viewport.
    fn index(&self, [x, y]: [i32; 2]) -> usize {
        let (width, height) = self.scene.size;
        let window = &self.window;
        let inside = |at: i32, start: i32, length: u32, most: u32| {
            (0..most.cast_signed()).contains(&at)
                && (start..start + length.cast_signed()).contains(&at)
        };
        assert!(
            inside(x, window.top_left().x, window.size().width, width)
                && inside(y, window.top_left().y, window.size().height, height),
            "a pixel at {x}, {y}"
        );
        y as usize * width as usize + x as usize
    }

    /// The canvas and its depths before anything is drawn.
    fn blank(&self) -> Picture {
        let (width, height) = self.scene.size;
        let [top, bottom] = self.scene.depths;
        let depth = |row: u32| {
            if row < height / 2 { top } else { bottom }
        };
        Picture {
            colors: vec![BACKGROUND; self.scene.pixels()],
            depths: (0..height)
                .flat_map(|row| iter::repeat_n(depth(row), width as usize))
                .collect(),
        }
    }

    /// Draws in all ways, compares the pictures, and returns the recorded pixels.
    pub fn check<I: Mode, F: ShaderFor<Rgb565>, const N: usize>(
        &self,
        options: &DrawOptions<I>,
        shader: &F,
    ) -> Record<N, Rgb565> {
        let record = self.record(options, *shader);
        let expected = self.depth_test(options, *shader, &record.seen);
        let frame = self.check_frames(options, shader);
        assert!(frame == expected, "the picture without recording differs");
        record
    }

    /// Checks that a frame, bands and prepared triangles show the same picture. Returns the frame.
    pub fn check_frames<I: Mode>(
        &self,
        options: &DrawOptions<I>,
        shader: &impl ShaderFor<Rgb565>,
    ) -> Picture {
        let draw = &mut |canvas: &mut Frame<'_>| self.draw(canvas, options, shader);
        let (frame, drawn) = self.frame(draw);
        // Drawing again over the same picture changes nothing, because triangles at equal depths cover earlier ones.
        let mut again = frame.clone();
        assert_eq!(self.on_frame(&mut again, draw), drawn);
        assert!(again == frame, "drawn again, the picture differs");
        assert!(self.in_bands(draw) == frame, "bands differ");
        match self.scene.what {
            What::Triangles => self.check_listed(options, shader, &frame, drawn),
            What::Edges => self.check_listed_edges(options, shader, &frame),
            What::Points | What::Sprites(_) => {}
        }
        frame
    }

    /// Draws with a depth buffer. Of the pixels that were `seen` without a depth buffer, exactly the pixels that are
    /// not hidden must be drawn.
    fn depth_test<I: Mode, F: ShaderFor<Rgb565>, const N: usize>(
        &self,
        options: &DrawOptions<I>,
        shader: F,
        seen: &[Seen<N, Rgb565>],
    ) -> Picture {
        let mut expected = self.blank();
        let mut visible = Vec::new();
        for seen in seen {
            let at = self.index(seen.pixel);
            if seen.depth >= expected.depths[at] {
                visible.push(*seen);
                if let Some(color) = seen.color {
                    expected.colors[at] = color;
                    expected.depths[at] = seen.depth;
                }
            }
        }

        let mut frame = self.blank();
        let record = record(shader, |recorder| {
            self.on_frame(&mut frame, &mut |canvas| {
                self.draw(canvas, options, recorder)
            });
        });
        assert!(record.seen == visible, "pixels differ with depth");
        assert!(
            frame == expected,
            "the picture differs from the recorded pixels"
        );
        expected
    }

    /// Draws listed triangles, in a frame and in bands.
    fn check_listed<I: Mode>(
        &self,
        options: &DrawOptions<I>,
        shader: &impl ShaderFor<Rgb565>,
        expected: &Picture,
        drawn: Drawn,
    ) {
        let mut list = List::new();
        let (frame, counts) = listed!(self, list.prepare(options, self.mesh), shader);
        assert!(frame == *expected, "prepared triangles differ");
        // If clipping removes a triangle, only a direct draw call reports that the triangle lacks attributes.
        let missing = drawn.missing;
        assert_eq!(Drawn { missing, ..counts }, drawn);
        // In another order, other triangles can show. But the number of drawn triangles is the same.
        let (_, counts) = listed!(self, list.prepare_back_to_front(options, self.mesh), shader);
        assert_eq!(Drawn { missing, ..counts }, drawn);
        objects!(self, list.prepare_back_to_front(options, self.mesh), shader);
    }

    /// Draws listed edges in a frame and in bands. Compares smooth listed edges with smooth edges that are drawn
    /// directly.
    fn check_listed_edges<I: Mode>(
        &self,
        options: &DrawOptions<I>,
        shader: &impl ShaderFor<Rgb565>,
        expected: &Picture,
    ) {
        let (mesh, mut list) = (self.mesh, List::new());
        let mut room = vec![[0; 4]; 3 * mesh.faces().len()];
        let outline = self.outline(&mut room);
        let lines = match &outline {
            Some(outline) => mesh.outline(outline, self.line()),
            None => mesh.edges(self.line()),
        };
        let (frame, _) = listed!(self, list.prepare(options, lines), shader);
        assert!(frame == *expected, "prepared edges differ");

        let lines = match &outline {
            Some(outline) => mesh.outline(outline, self.line().smooth()),
            None => mesh.edges(self.line().smooth()),
        };
        let direct = |canvas: &mut Frame<'_>| canvas.draw_with(options, lines, &self.mvp, shader);
        let (direct, _) = self.frame(&mut { direct });
        let (frame, _) = listed!(self, list.prepare(options, lines), shader);
        assert!(frame == direct, "prepared smooth edges differ");
        objects!(self, list.prepare(options, lines), shader);
    }

    /// Checks that edges are smoothed in the same way in a frame, in bands that overlap by a row, and prepared.
    pub fn check_smoothed(&self, options: &DrawOptions) {
        let mut room = vec![[0; 4]; 3 * self.mesh.faces().len()];
        let outline = &self.any_outline(&mut room);
        let pattern = Flat::new(BACKGROUND).map(|at, _| {
            let [x, y] = [at.point.x, at.point.y].map(i32::cast_unsigned);
            Some(Rgb565::new(
                (37 * x) as u8,
                (x ^ (11 * y)) as u8,
                (5 * y) as u8,
            ))
        });
        let draw = |canvas: &mut Frame<'_>| {
            canvas.draw_with(options, self.mesh, &self.mvp, &pattern);
        };
        let smooth = &mut |canvas: &mut Frame<'_>| {
            draw(canvas);
            canvas.smooth_edges(options, self.mesh, outline, &self.mvp)
        };
        let (frame, drawn) = self.frame(smooth);
        assert!(drawn.clipped <= drawn.drawn && drawn.drawn <= drawn.submitted);
        let bands = self.in_overlapping_bands(smooth);
        assert!(bands == frame.colors, "smoothed bands differ");

        let in_front = options.with_depth_test(Biased::in_front(TestAndWrite));
        let edges = self.mesh.outline(outline, LineStyle::HAIRLINE);
        let mut list = List::new();
        let listed = list.prepare(&in_front, self.scene.size, edges, &self.mvp);
        let listed = listed.unwrap();
        let smooth = &mut |canvas: &mut Frame<'_>| {
            draw(canvas);
            canvas.smooth_prepared(&listed).unwrap()
        };
        assert!(
            self.frame(smooth).0 == frame,
            "prepared edges are smoothed differently"
        );
        let bands = self.in_overlapping_bands(smooth);
        assert!(
            bands == frame.colors,
            "smoothed bands of prepared edges differ"
        );
    }

    /// The mesh's outline; `None` for half of the styles.
    fn outline<'r>(&self, room: &'r mut [[u16; 4]]) -> Option<Outline<'r>> {
        let has_outline = self.scene.style & 1 != 0;
        has_outline.then(|| self.any_outline(room))
    }

    /// The mesh's outline, with creases above an angle that the style gives.
    fn any_outline<'r>(&self, room: &'r mut [[u16; 4]]) -> Outline<'r> {
        let crease = Angle::from_bits(u32::from(self.scene.style) << 23);
        Outline::build(self.mesh, crease, room).unwrap()
    }

    /// Draws a frame.
    fn frame(&self, draw: &mut Draw<'_>) -> (Picture, Drawn) {
        let mut picture = self.blank();
        let drawn = self.on_frame(&mut picture, draw);
        (picture, drawn)
    }

    /// Draws over a whole picture.
    fn on_frame(&self, picture: &mut Picture, draw: &mut Draw<'_>) -> Drawn {
        let (width, height) = self.scene.size;
        let canvas = Canvas::new(&mut picture.colors, width, height).unwrap();
        draw(&mut canvas.with_depth(&mut picture.depths).unwrap())
    }

    /// Checks that a canvas of bytes, in either order and without depths, shows the same picture.
    pub fn check_bytes<I: Mode>(&self, options: &DrawOptions<I>, shader: &impl ShaderFor<Rgb565>) {
        let (width, height) = self.scene.size;
        let mut colors = vec![BACKGROUND; self.scene.pixels()];
        let mut canvas = Canvas::new(&mut colors, width, height).unwrap();
        self.draw(&mut canvas, options, shader);

        let mut bytes = vec![BigEndian::store(BACKGROUND); colors.len()];
        let mut canvas: Canvas<Rgb565, BigEndian> = Canvas::new(&mut bytes, width, height).unwrap();
        self.draw(&mut canvas, options, shader);
        assert!(canvas.pixels().eq(colors.iter().copied()));
        let sent = colors.iter().flat_map(|color| color.to_be_bytes());
        assert!(canvas.as_bytes().iter().copied().eq(sent));

        let mut bytes = vec![LittleEndian::store(BACKGROUND); colors.len()];
        let mut canvas: Canvas<Rgb565, LittleEndian> =
            Canvas::new(&mut bytes, width, height).unwrap();
        self.draw(&mut canvas, options, shader);
        assert!(canvas.pixels().eq(colors.iter().copied()));
    }

    /// Checks that diffusion gives the same grays in a frame and in bands, and that palette indices are drawn at the
    /// same pixels as colors.
    pub fn check_panels(&self, options: &DrawOptions) {
        let (width, height) = self.scene.size;
        let gray = Flat::new(Gray8::new(0)).map(|at, _| {
            let [x, y] = [at.point.x, at.point.y].map(i32::cast_unsigned);
            Some(Gray8::new(((37 * x) ^ (11 * y)) as u8))
        });
        // Returns the pixels of a panel that was drawn in bands of `rows` rows, with this contrast.
        let panel = |rows: u32, contrast: Option<Contrast>| {
            let mut shown = vec![BinaryColor::Off; self.scene.pixels()];
            let mut panel = Canvas::new(&mut shown, width, height).unwrap();
            let mut errors = vec![0; width as usize];
            let mut diffusion = ErrorDiffusion::new(&mut errors);
            let mut seen = contrast;
            for first in (0..height).step_by(rows as usize) {
                let mut grays = vec![Gray8::new(90); (rows.min(height - first) * width) as usize];
                let mut band = Canvas::band(&mut grays, width, height, first).unwrap();
                band.draw_with(options, self.mesh, &self.mvp, &gray);
                let contrast = *seen.get_or_insert(Contrast::of(&band, self.scene.bands[0]));
                let Ok(()) = band.show_diffused(&mut panel, contrast, &mut diffusion);
            }
            (shown, seen)
        };
        let (frame, contrast) = panel(height, None);
        let rows = u32::from(self.scene.bands[1]).clamp(height.div_ceil(12), height);
        let (bands, _) = panel(rows, contrast);
        assert!(bands == frame, "bands are diffused differently");

        let mut indices = vec![ColorIndex(0); self.scene.pixels()];
        let mut canvas = Canvas::new(&mut indices, width, height).unwrap();
        canvas.draw_with(options, self.mesh, &self.mvp, &Flat::new(ColorIndex(7)));
        let mut colors = vec![Rgb565::BLACK; self.scene.pixels()];
        let mut canvas = Canvas::new(&mut colors, width, height).unwrap();
        canvas.draw_with(options, self.mesh, &self.mvp, &Flat::new(Rgb565::WHITE));
        let indexed = indices.iter().map(|index| index.0 == 7);
        assert!(indexed.eq(colors.iter().map(|color| *color == Rgb565::WHITE)));
    }

    /// Checks that blending gives the same colors in frames and in bands.
    pub fn check_blended<I: Mode>(
        &self,
        options: &DrawOptions<I>,
        shader: &impl ShaderFor<Rgb565>,
    ) {
        self.check_blending(
            &options.with_blending(Opacity(self.scene.depths[0] as u8)),
            shader,
        );
        self.check_blending(&options.with_blending(Add), shader);
        self.check_blending(&options.with_blending(Multiply), shader);
        let translucent = shader.map(|at, color| {
            let opacity = (at.point.x ^ at.point.y).cast_unsigned() as u8;
            Some(Translucent { color, opacity })
        });
        self.check_blending(&options.with_blending(fixel::canvas::Replace), &translucent);
    }

    fn check_blending(
        &self,
        options: &DrawOptions<impl Mode, TestAndWrite, impl Blending<Rgb565>>,
        shader: &impl ShaderFor<Rgb565>,
    ) {
        // Triangles are enough, because edges and points reach the pixels by the same code.
        let draw =
            &mut |canvas: &mut Frame<'_>| canvas.draw_with(options, self.mesh, &self.mvp, shader);
        assert!(
            self.in_bands(draw) == self.frame(draw).0,
            "blended bands differ"
        );

        let smooth = self.mesh.edges(self.line().smooth());
        let draw =
            &mut |canvas: &mut Frame<'_>| canvas.draw_with(options, smooth, &self.mvp, shader);
        let (frame, drawn) = self.frame(draw);
        assert!(drawn.clipped <= drawn.drawn && drawn.drawn + drawn.culled <= drawn.submitted);
        assert!(self.in_bands(draw) == frame, "bands of smooth lines differ");
    }

    /// The rows of bands. The scene gives their heights.
    fn bands(&self) -> impl Iterator<Item = Range<u32>> {
        let (_, height) = self.scene.size;
        // There are at most twelve bands, because more bands would take long and find few mistakes.
        let least = height.div_ceil(12);
        let mut heights = self.scene.bands.iter().cycle();
        let mut first = 0;
        iter::from_fn(move || {
            let rows = heights.next().map_or(1, |&rows| u32::from(rows));
            let start = first;
            first += rows.max(least).min(height - first);
            (start < height).then_some(start..first)
        })
    }

    /// Draws a picture in bands that reach one row further up and down than the rows that are kept. Returns its colors.
    fn in_overlapping_bands(&self, draw: &mut Draw<'_>) -> Vec<Rgb565> {
        let (width, height) = self.scene.size;
        let mut shown = Vec::new();
        for rows in self.bands() {
            let (first, end) = (rows.start.max(1) - 1, height.min(rows.end + 1));
            let pixels =
                |rows: Range<u32>| (rows.start * width) as usize..(rows.end * width) as usize;
            let Picture {
                mut colors,
                mut depths,
            } = self.blank();
            let all = pixels(first..end);
            let band = Canvas::band(&mut colors[all.clone()], width, height, first).unwrap();
            draw(&mut band.with_depth(&mut depths[all]).unwrap());
            shown.extend(&colors[pixels(rows)]);
        }
        shown
    }

    /// Draws a picture in bands.
    fn in_bands(&self, draw: &mut Draw<'_>) -> Picture {
        let mut picture = self.blank();
        let (width, height) = self.scene.size;
        let (mut colors, mut depths) = (&mut picture.colors[..], &mut picture.depths[..]);
        for Range { start: first, end } in self.bands() {
            let rows = end - first;
            let (band, other_colors) = colors.split_at_mut((rows * width) as usize);
            let (depth, other_depths) = depths.split_at_mut((rows * width) as usize);
            let band = Canvas::band(band, width, height, first).unwrap();
            draw(&mut band.with_depth(depth).unwrap());
            (colors, depths) = (other_colors, other_depths);
        }
        picture
    }
}

type Frame<'f> = Canvas<'f, Rgb565, Native, LinearDepth>;

/// Draws into a frame or a band. All closures have this one type. Generic functions would take minutes to compile,
/// because there are hundreds of closures.
type Draw<'d> = dyn FnMut(&mut Frame<'_>) -> Drawn + 'd;
