//! The limits of a mesh's size, and lists that are too short.

use fixel::mesh::{Buffers, obj};
use fixel::prelude::*;

use super::reading::{SQUARE, fails, ok};

#[test]
fn at_most_65536_positions() {
    let mut text = "v 0 0 0\n".repeat(65_536);
    text += "f 1 65536 2\n";
    assert_eq!(ok(&text).faces, [[0, 65_535, 1]]);
    text += "v 0 0 0\n";
    fails(&text, 65_538, "65536");
}

#[test]
fn lists_that_are_too_short_name_the_needed_counts() {
    let text = format!("{SQUARE}vt 0\nf 1/1 2/1 3/1").into_bytes();
    let (mut positions, mut faces) = ([Vec3::ZERO; 9], [[7; 3]; 1]);
    let mesh = obj::parse(&text, Buffers::new(&mut positions, &mut faces)).unwrap();
    assert_eq!(
        (mesh.positions().len(), mesh.has_uvs(), mesh.edges().len()),
        (4, false, 0)
    );
    let result = obj::parse(&text, Buffers::new(&mut positions[..3], &mut faces));
    assert!(matches!(
        result,
        Err(Error::TooMany {
            given: 4,
            max: 3,
            ..
        })
    ));
    let uvs = &mut [Vec2::default()];
    let result = obj::parse(
        &text,
        Buffers {
            uvs,
            ..Buffers::new(&mut positions, &mut faces)
        },
    );
    assert!(matches!(
        result,
        Err(Error::TooMany {
            given: 1,
            max: 0,
            ..
        })
    ));
}
