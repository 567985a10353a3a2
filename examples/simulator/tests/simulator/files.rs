//! Outputs: pictures, animations and help.

use std::fs;

use super::program::{TRIANGLE, directory, files, good, png_size};

#[test]
fn without_arguments_it_draws_its_own_scene_and_says_where() {
    let directory = directory("scene");
    let said = good(&directory, "");
    assert!(said.contains("lighthouse.png"), "{said}");
    assert_eq!(files(&directory), ["lighthouse.png"]);
    assert_eq!(png_size(&directory.join("lighthouse.png")), (320, 240));
}

#[test]
fn an_animation_is_a_gif_of_several_frames() {
    let directory = directory("animation");
    fs::write(directory.join("t.obj"), TRIANGLE).unwrap();
    let said = good(&directory, "t.obj --size 32x32 --frames 4");
    assert!(said.contains("t.gif"), "{said}");
    let gif = fs::read(directory.join("t.gif")).unwrap();
    assert_eq!(&gif[..6], b"GIF89a");
    assert_eq!(gif[6..10], [32, 0, 32, 0]);
    assert_eq!(files(&directory), ["t.gif", "t.obj"]);
}

#[test]
fn help_names_options_and_examples() {
    let said = good(&directory("help"), "--help");
    for part in ["Examples", "--cull", "default", "Camera:", "below 180"] {
        assert!(said.contains(part), "no '{part}' in: {said}");
    }
}
