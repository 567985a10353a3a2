//! Models of which nothing can be seen are refused, and faces that make the others too small are noted.

mod common;

use common::{notes, read};
use fixel_assets::Options;

fn refused(text: &str) -> String {
    read(&[("a.obj", text)]).unwrap_err()
}

#[test]
fn what_has_no_size_is_refused() {
    let says = "there is nothing to see: all points of its faces are at 1,2,3";
    assert_eq!(
        refused("v 1 2 3\nv 9 9 9\nv 1 2 3\nv 1 2 3\nf 1 3 4\nf 1 1 1\n"),
        says
    );
    let says = "there is nothing to see: the corners of each face are on a line";
    assert_eq!(
        refused("v 0 0 0\nv 1 1 1\nv 0.1 0.1 0.1\nf 1 2 3\nf 1 1 2\n"),
        says
    );
    // On a line except for the rounding of three decimals, and so for one part in 2^52.
    assert_eq!(
        refused("v 0.1 0.2 0.3\nv 0.2 0.4 0.6\nv 0.7 1.4 2.1\nf 1 2 3\n"),
        says
    );
    // A thin face has an area, and so does one of any size.
    for scale in ["e-30", "e0", "e28"] {
        let text = format!("v 0 0 0\nv 1{scale} 0 0\nv 0 0.0001{scale} 0\nf 1 2 3\n");
        assert!(read(&[("a.obj", text)]).is_ok(), "{scale}");
    }
}

#[test]
fn points_and_lines_alone_are_refused() {
    let says = "it has points or lines, but no faces: only faces are drawn";
    for text in ["v 1 2 3\nv 1 2 4\nl 1 2\n", "v 1 2 3\n"] {
        assert_eq!(refused(text), says, "{text}");
    }
    assert_eq!(
        refused("v 1 2 3\np 1\n"),
        format!("{says}; not drawn: points")
    );
    assert_eq!(
        refused("# nothing\n"),
        "it has no faces: there is nothing to draw"
    );
    let says = refused("v 1 2 3\nf 1 2 3\n");
    assert_eq!(
        says,
        "there is nothing to draw; a face is left out: it names a vertex that does not exist"
    );
}

/// A square, which `far` follows.
fn noted(far: &str) -> Vec<String> {
    let square = "o near\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
    let model = read(&[("a.obj", format!("{square}{far}"))]).unwrap();
    let mut notes = notes(&model);
    notes.extend(model.far);
    notes
}

#[test]
fn faces_far_away_are_named() {
    let [note] = &noted("o bird\nv 5000 5000 0\nf 1 2 5\n")[..] else {
        panic!("one note");
    };
    let wanted = "1 of 3 triangles are over 1000 times farther from the middle than the others";
    assert!(note.starts_with(wanted), "{note}");
    assert!(
        note.contains("the first of 'bird' is at 5000,5000,0; to leave them out, delete them"),
        "{note}"
    );
    // Not as far, not few, or not used.
    for far in [
        "v 500 500 0\nf 1 2 5\n",
        "v 5000 5000 0\nv 5001 5000 0\nv 5001 5001 0\nf 5 6 7\nf 5 6 7\n",
        "v 5000 5000 0\n",
    ] {
        assert_eq!(noted(far), [""; 0], "{far}");
    }
    // Faces without area in the middle do not make the others far.
    assert_eq!(noted(&"f 1 1 1\n".repeat(30)), [""; 0]);
}

/// The advice of `include_mesh!` works: with an object or a part, only its own faces count.
#[test]
fn faces_that_are_not_selected_do_not_count() {
    let text = "o near\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\nf 1 2 4\nusemtl feather\no bird\nv 5000 5000 0\n\
                f 1 2 5\no dot\nusemtl dot\nf 1 1 2\n";
    let model = read(&[("a.obj", text)]).unwrap();
    assert!(model.far.is_some());
    let lists = |object: Option<&str>, part: Option<&str>| {
        let [object, part] = [object, part].map(|name| name.map(str::to_string));
        let options = Options {
            object,
            part,
            ..Options::default()
        };
        model.lists(&options).map(|lists| lists.far)
    };
    assert_eq!(lists(None, None), Ok(model.far.clone()));
    assert_eq!(lists(Some("near"), None), Ok(None));
    assert_eq!(lists(None, Some("feather")), Ok(None));
    let nothing = "there is nothing to see: the corners of each face are on a line";
    assert_eq!(lists(Some("dot"), None), Err(nothing.into()));
}
