//! Tests of the messages.

use super::*;
use crate::mesh::{Keyframes, Outline, Shape};
use crate::shade::{Gradient, PointLight, SpotLight};
use crate::{Camera, Canvas, DrawList, DrawOptions, Fog, LineStyle, Matrix4, Mesh, PointStyle};
use crate::{Light, Projection, Sprites, Texture, Textured, Transform, Viewport, Window};
use crate::{deg, fx, shape, vec3};
use embedded_graphics::pixelcolor::{Gray8, Rgb888};
use std::string::ToString;

#[test]
#[allow(clippy::too_many_lines)] // a list
fn each_message_names_the_value_and_what_it_must_be() {
    static PLANE: Mesh = shape!(plane(1, 1));
    let view =
        |fov, size: (u32, u32), near, far| Projection::perspective(fov, size, near, far).err();
    let window = |left, right, bottom, top| {
        let window = Window {
            left,
            right,
            bottom,
            top,
        };
        Projection::frustum(window, fx!(1), fx!(2)).err()
    };
    let parallel = Projection::orthographic(Window::centered(fx!(2), fx!(2)), fx!(0), fx!(2));
    let parallel = parallel.unwrap();
    let cone =
        |inner, outer| SpotLight::new(Vec3::ZERO, Vec3::X, (inner, outer), fx!(1), fx!(1)).err();
    let sprites = |width, height| Sprites::new(&[], (width, height)).err();
    let mut pixels = [Gray8::new(0); 12];
    let mut canvas =
        |size: usize, width, height| Canvas::<Gray8>::new(&mut pixels[..size], width, height).err();
    let mut pixels = [Gray8::new(0); 12];
    let mut band =
        |size: usize, first| Canvas::<Gray8>::band(&mut pixels[..size], 4, 3, first).err();
    let texels = [Gray8::new(0); 2];
    let [small, large] = [(&texels[..1], 1), (&texels, 2)]
        .map(|(texels, width)| Texture::new(texels, width, 1).unwrap());
    let corners = [Vec3::ZERO; 3];
    let mesh = |faces| Mesh::new(&corners, faces);
    let [first, second] = [&[[0, 1, 2]], &[[0, 2, 1]]].map(|faces| mesh(faces).unwrap());
    let mut list = DrawList::<1, 9>::new();
    let mvp = parallel * Camera::top(Vec3::ZERO, fx!(1));
    let full = list.prepare(&DrawOptions::new(), (9, 9), &PLANE, &mvp);
    let full = full.map(|_| ()).err();
    let red = Rgb888::new(255, 0, 0);

    let errors = [
        (
            Scalar::try_from(40_000.5).err(),
            "40000.5 cannot be represented: it must lie between -32768 and 32767.99999",
        ),
        (
            Scalar::try_from(f64::NAN).err(),
            "number is infinite or not a number: it must be finite",
        ),
        (
            view(deg!(0), (4, 3), fx!(1), fx!(2)),
            "field of view is 0 degrees: it must be above 0 and below 180 degrees",
        ),
        (
            Outline::build(&PLANE, deg!(181.5), &mut []).err(),
            "crease angle is 181.5 degrees: it must lie between 0 and 180 degrees",
        ),
        (
            cone(deg!(95), deg!(99)),
            "inner angle of the cone is 95 degrees: it must be at least 0 and below 90 degrees",
        ),
        (
            cone(deg!(20), deg!(10)),
            "outer angle of the cone is 10 degrees: it must be above 20 and at most 90 degrees",
        ),
        (
            cone(deg!(20), deg!(91)),
            "outer angle of the cone is 91 degrees: it must be above 20 and at most 90 degrees",
        ),
        (
            view(deg!(60), (0, 3), fx!(1), fx!(2)),
            "width of the aspect ratio is 0: it must be above 0",
        ),
        (
            Projection::perspective(deg!(60), fx!(-0.25), fx!(1), fx!(2)).err(),
            "width of the aspect ratio is -0.25: it must be above 0",
        ),
        (
            view(deg!(60), (4, 0), fx!(1), fx!(2)),
            "height of the aspect ratio is 0: it must be above 0",
        ),
        (
            view(deg!(60), (4, 3), fx!(-1), fx!(2)),
            "distance of the near plane is -1: it must be above 0",
        ),
        (
            view(deg!(60), (4, 3), fx!(3), fx!(2)),
            "distance of the far plane is 2: it must be above 3",
        ),
        (
            Projection::from_focal_length(fx!(0), (4, 3), fx!(1), fx!(2)).err(),
            "focal length is 0: it must be above 0",
        ),
        (
            window(fx!(2), fx!(1.5), fx!(0), fx!(1)),
            "right edge of the window is 1.5: it must be above 2",
        ),
        (
            window(fx!(0), fx!(1), fx!(1), fx!(1)),
            "top edge of the window is 1: it must be above 1",
        ),
        (
            Fog::linear(Gray8::new(9), fx!(5), fx!(2)).err(),
            "far end of the fog is 2: it must be above 5",
        ),
        (
            Fog::exponential(Gray8::new(9), fx!(-0.5)).err(),
            "density of the fog is -0.5: it must lie between 0 and 5",
        ),
        (
            Gradient::<Gray8>::new((fx!(5), red), (fx!(2), red)).err(),
            "top of the gradient is 2: it must be above 5",
        ),
        (
            Light::new(Vec3::X, fx!(0), fx!(2)).err(),
            "brightness is 2: it must lie between 0 and 1",
        ),
        (
            PointLight::new(Vec3::ZERO, fx!(1), fx!(0)).err(),
            "range of the light is 0: it must be above 0",
        ),
        (
            LineStyle::wide(fx!(0.5)).err(),
            "line width is 0.5: it must lie between 1 and 64",
        ),
        (
            PointStyle::square(fx!(-3)).err(),
            "point size is -3: it must be above 0",
        ),
        (
            sprites(fx!(0), fx!(1)),
            "width of a sprite is 0: it must be above 0",
        ),
        (
            sprites(fx!(1), fx!(-1)),
            "height of a sprite is -1: it must be above 0",
        ),
        (
            Shape::cuboid(vec3!(0, 1, 1)).err(),
            "half the width of the box is 0: it must be above 0",
        ),
        (
            Shape::torus(fx!(1), 3, 3).err(),
            "tube radius is 1: it must be above 0 and below 1",
        ),
        (
            Shape::sphere(2, 2).err(),
            "number of slices is 2: it must be at least 3 and at most 16384",
        ),
        (
            Shape::sphere(256, 255).err(),
            "number of positions is 65792: it must be at most 65536",
        ),
        (
            canvas(11, 4, 3),
            "number of pixels is 11: it must be exactly 12",
        ),
        (
            canvas(12, 5000, 1),
            "number of columns of the frame is 5000: it must be at least 1 and at most 2048",
        ),
        (
            canvas(12, 1, 0),
            "number of rows of the frame is 0: it must be at least 1 and at most 2048",
        ),
        (
            Viewport::new(0, 0, 4097, 1).err(),
            "number of columns of the viewport is 4097: it must be at least 1 and at most 4096",
        ),
        (
            Viewport::new(0, 0, 1, 0).err(),
            "number of rows of the viewport is 0: it must be at least 1 and at most 4096",
        ),
        (
            Viewport::new(5, -9999, 1, 1).err(),
            "viewport is at (5, -9999): both coordinates must lie between -4096 and 4096",
        ),
        (
            band(4, 3),
            "number of rows above the band is 3: it must be at most 2",
        ),
        (
            band(12, 1),
            "number of rows of the band is 3: it must be at least 1 and at most 2",
        ),
        (
            band(8, 2),
            "number of rows of the band is 2: it must be exactly 1",
        ),
        (
            Light::new(Vec3::ZERO, fx!(0), fx!(0)).err(),
            "direction is (0, 0, 0): at least one component must not be 0",
        ),
        (
            Transform::from_quaternion([fx!(0); 4]).err(),
            "quaternion is (0, 0, 0, 0): at least one component must not be 0",
        ),
        (
            Transform::try_from(Matrix4::new([[fx!(2); 4]; 4])).err(),
            "last row is (2, 2, 2, 2): it must be (0, 0, 0, 1) in an affine matrix",
        ),
        (
            Texture::<Gray8>::new(&[], 3, 1).err(),
            "width is 3: it must be a power of two, at most 32768, such as 4",
        ),
        (
            Textured::new(small).masked(large).err(),
            "size of the mask is 2x1: it must be 1x1, like its texture",
        ),
        (
            mesh(&[[0, 1, 3]]).err(),
            "index 3 in element 0 is out of range: it must be below 3",
        ),
        (
            Keyframes::new(&first, &second).err(),
            "face 0 differs: both meshes must have the same faces",
        ),
        (
            full,
            "2 triangles are visible: the list must have room for all, and has room for 1",
        ),
    ];
    for (error, expected) in errors {
        let message = error.expect(expected).to_string();
        assert_eq!(message, expected);
        // The Rust API guidelines ask for messages in lowercase, without punctuation at the end.
        assert!(!message.starts_with(char::is_uppercase), "{message}");
        assert!(!message.ends_with(['.', '!', ':']), "{message}");
    }
    for variant in VARIANTS {
        let is_variant = |error: Option<Error>| {
            let shown = std::format!("{:?}", error.unwrap());
            shown.split(' ').next() == Some(variant)
        };
        let is_shown = errors.iter().any(|&(error, _)| is_variant(error));
        assert!(is_shown, "no message of {variant}");
    }
}
