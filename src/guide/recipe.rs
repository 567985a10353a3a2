//! Macros for the pages of the cookbook.

/// What each recipe costs: its instructions, its frames a second, and its RAM.
#[rustfmt::skip]
macro_rules! cost {
    ("two_cores") => { "Not measured, because it starts a thread." };
    // <!-- figures: costs of recipes -->
    ("bands") => { "5.2 M instructions, about 22 frames a second on an STM32F4 at 168 MHz, 45 KB of RAM." };
    ("blending") => { "7.3 M instructions, about 15 frames a second on an STM32F4 at 168 MHz, 315 KB of RAM." };
    ("corridor") => { "2.9 M instructions, about 39 frames a second on an STM32F4 at 168 MHz, 314 KB of RAM." };
    ("cut_out") => { "7.7 M instructions, about 15 frames a second on an STM32F4 at 168 MHz, 324 KB of RAM." };
    ("detail") => { "21 M instructions, about 5.3 frames a second on an STM32F4 at 168 MHz, 313 KB of RAM." };
    ("drone") => { "5.2 M instructions, about 22 frames a second on an STM32F4 at 168 MHz, 330 KB of RAM." };
    ("files") => { "2.3 M instructions, about 48 frames a second on an STM32F4 at 168 MHz, 314 KB of RAM." };
    ("fog") => { "6.6 M instructions, about 17 frames a second on an STM32F4 at 168 MHz, 313 KB of RAM." };
    ("hello") => { "5.6 M instructions, about 20 frames a second on an STM32F4 at 168 MHz, 313 KB of RAM." };
    ("hidden") => { "3.6 M instructions, about 31 frames a second on an STM32F4 at 168 MHz, 315 KB of RAM." };
    ("instruments") => { "4.3 M instructions, about 26 frames a second on an STM32F4 at 168 MHz, 315 KB of RAM." };
    ("keyframes") => { "0.5 M instructions, about 244 frames a second on an STM32F4 at 168 MHz, 312 KB of RAM." };
    ("labels") => { "7.7 M instructions, about 15 frames a second on an STM32F4 at 168 MHz, 314 KB of RAM." };
    ("lights") => { "13 M instructions, about 8.4 frames a second on an STM32F4 at 168 MHz, 314 KB of RAM." };
    ("materials") => { "2.2 M instructions, about 50 frames a second on an STM32F4 at 168 MHz, 313 KB of RAM." };
    ("mipmaps") => { "7.0 M instructions, about 16 frames a second on an STM32F4 at 168 MHz, 313 KB of RAM." };
    ("mirror") => { "9.0 M instructions, about 12 frames a second on an STM32F4 at 168 MHz, 315 KB of RAM." };
    ("normals") => { "2.2 M instructions, about 52 frames a second on an STM32F4 at 168 MHz, 314 KB of RAM." };
    ("packed") => { "4.5 M instructions, about 25 frames a second on an STM32F4 at 168 MHz, 30 KB of RAM." };
    ("painter") => { "4.8 M instructions, about 24 frames a second on an STM32F4 at 168 MHz, 207 KB of RAM." };
    ("panels") => { "16 M instructions, about 7.2 frames a second on an STM32F4 at 168 MHz, 25 KB of RAM." };
    ("picking") => { "3.1 M instructions, about 37 frames a second on an STM32F4 at 168 MHz, 314 KB of RAM." };
    ("points") => { "5.6 M instructions, about 20 frames a second on an STM32F4 at 168 MHz, 385 KB of RAM." };
    ("quantized") => { "6.2 M instructions, about 18 frames a second on an STM32F4 at 168 MHz, 313 KB of RAM." };
    ("sky") => { "8.1 M instructions, about 14 frames a second on an STM32F4 at 168 MHz, 315 KB of RAM." };
    ("sky_box") => { "25 M instructions, about 4.5 frames a second on an STM32F4 at 168 MHz, 329 KB of RAM." };
    ("smooth") => { "4.9 M instructions, about 23 frames a second on an STM32F4 at 168 MHz, 313 KB of RAM." };
    ("sprites") => { "5.2 M instructions, about 22 frames a second on an STM32F4 at 168 MHz, 325 KB of RAM." };
    ("stencil") => { "2.3 M instructions, about 48 frames a second on an STM32F4 at 168 MHz, 315 KB of RAM." };
    ("terrain") => { "22 M instructions, about 5.0 frames a second on an STM32F4 at 168 MHz, 77 KB of RAM." };
    ("toon") => { "11 M instructions, about 10 frames a second on an STM32F4 at 168 MHz, 313 KB of RAM." };
    ("windmill") => { "2.5 M instructions, about 45 frames a second on an STM32F4 at 168 MHz, 314 KB of RAM." };
    ("wireframe") => { "4.1 M instructions, about 27 frames a second on an STM32F4 at 168 MHz, 312 KB of RAM." };
    ("world") => { "13 M instructions, about 8.4 frames a second on an STM32F4 at 168 MHz, 317 KB of RAM." };
    // <!-- end -->
}

/// Small pictures that lead to the recipes of a page. For each recipe: title, anchor, and name.
macro_rules! gallery {
    ($page:literal: $($title:literal $anchor:literal $name:literal),+) => {
        concat!("<div class=\"recipes\">\n", $(
            "<a href=\"", $page, "/index.html#", $anchor, "\">", picture!($name), $title, "</a>\n",
        )+ "</div>\n\n")
    };
}

/// A small picture, for [`gallery`]. Without the feature `assets`, the documentation has no pictures.
#[cfg(feature = "assets")]
macro_rules! picture {
    ($name:literal) => {
        concat!(
            "<img alt=\"\" src=\"",
            fixel_macros::picture_uri!("thumbnails/" $name ".png"),
            "\">"
        )
    };
}
#[cfg(not(feature = "assets"))]
macro_rules! picture {
    ($name:literal) => {
        ""
    };
}

/// A scene's title, its picture, and its costs.
macro_rules! titled {
    ($title:literal, $name:tt) => {
        concat!(page_picture!(# $title, $name), cost!($name), "\n\n")
    };
}

/// Writes a recipe: a scene's title, picture, costs and program. The tests compile the program unchanged, inside a
/// hidden module. Without the module, the program would begin with `//!`. Rustdoc would then compile the program
/// separately, which takes longer than together with the other programs. Recipes without a test here would not compile
/// here, because they read files by paths relative to the recipe's folder. The package `cookbook` compiles and tests
/// them, too.
macro_rules! recipe {
    ($title:literal, $name:tt) => {
        concat!(
            titled!($title, $name),
            "```\n# mod scene {\n",
            include_str!(concat!("../../examples/cookbook/src/scenes/", $name, ".rs")),
            "# }\n```\n"
        )
    };
}
