//! Lines, comments and statements that do not affect the mesh.

use fixel::mesh::{Counts, obj};

use super::reading::{SQUARE, ok};

#[test]
fn comments_spaces_and_line_breaks_do_not_change_the_mesh() {
    let expected = ok(&format!("{SQUARE}f 1 2 3 4"));
    for text in [
        "\u{feff}# a comment \\\r\n\r\nv 0 0 0\r\n  v\t1 0 0  \r\nv 1 1 0\r\nv 0 1 0 # last\r\nf 1 2 3 4\r\n",
        "v 0 0 0\rv 1 0 0\rv 1 1 0\rv 0 1 0\rf 1 2 3 4\r",
        "v 0 \\\n0 0\nv 1 0\\\r\n 0\nv 1 1 0\nv 0 1 0\nf 1 2\\\n\\\n 3 4",
        "mtllib a.mtl\no x\ng\ns off\nv 0 0 0\nvp 1\nv 1 0 0\nusemtl \\\nf 9 9 9\nv 1 1 0\nv 0 1 0\np 1\nf 1 2 3 4\nfoo\nvx\n#",
        // A backslash does not continue a comment, not even one after a statement that is ignored.
        "o a # b \\\nv 0 0 0\nv 1 0 0\ng a \\\n# b \\\nv 1 1 0\nv 0 1 0\nusemtl c #\\\r\nf 1 2 3 4",
        "o a#b \\\nv 9 9 9\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4",
    ] {
        assert_eq!(ok(text), expected, "{text:?}");
    }
    assert_eq!(ok("").counts, Counts::default());
    // Names may be in Latin-1, which is not valid UTF-8.
    assert!(obj::count(b"o W\xfcrfel\nv 0 0 0").is_ok());
}
