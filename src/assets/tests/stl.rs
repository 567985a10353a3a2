//! STL files as real programs write them are read, and notes say what was replaced or left out.

mod common;

use common::{notes, read};
use fixel_assets::Model;

/// A tetrahedron's four triangles.
const TRIANGLES: [[[f32; 3]; 3]; 4] = {
    let [a, b, c, d] = [
        [0.0, 0.0, 0.0],
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [0.0, 0.0, 1.0],
    ];
    [[a, c, b], [a, b, d], [b, c, d], [c, a, d]]
};

fn text() -> String {
    let facet = |triangle: &[[f32; 3]; 3]| {
        let vertices = triangle.map(|[x, y, z]| format!("    vertex {x} {y} {z}\n"));
        format!(
            "  facet normal 0 0 0\n   outer loop\n{}   endloop\n  endfacet\n",
            vertices.concat()
        )
    };
    let facets: String = TRIANGLES.iter().map(facet).collect();
    format!("solid a part\n{facets}endsolid a part\n")
}

/// A binary file with four triangles. The header promises `count` triangles, and each triangle has two bytes of
/// attributes.
fn binary(header: &[u8], count: u32, attributes: [u16; 4]) -> Vec<u8> {
    let mut bytes = header.to_vec();
    bytes.resize(80, 0);
    bytes.extend(count.to_le_bytes());
    for (triangle, attribute) in TRIANGLES.iter().zip(attributes) {
        bytes.extend([f32::NAN.to_le_bytes(); 3].as_flattened());
        bytes.extend(triangle.as_flattened().iter().flat_map(|x| x.to_le_bytes()));
        bytes.extend(attribute.to_le_bytes());
    }
    bytes
}

fn stl(bytes: impl AsRef<[u8]>) -> Model {
    read(&[("a.stl", bytes)]).expect("a model")
}

/// Checks that a model is the tetrahedron, and returns its notes.
#[track_caller]
fn whole(bytes: impl AsRef<[u8]>) -> Vec<String> {
    let model = stl(bytes);
    let positions = |at: usize| {
        let corners = model.triangles[at].corners;
        corners.map(|corner| model.positions[corner.position as usize])
    };
    let found: Vec<_> = (0..model.triangles.len()).map(positions).collect();
    assert_eq!(
        found,
        TRIANGLES.map(|triangle| triangle.map(|p| p.map(f64::from)))
    );
    assert_eq!((model.positions.len(), model.normals.len()), (4, 0));
    notes(&model)
}

#[test]
fn text_is_read_in_any_layout() {
    let text = text();
    let cases = [
        text.clone(),
        format!("\u{feff}{text}"),
        format!(" \n{text}"),
        text.to_uppercase(),
        text.replace('\n', "\r"),
        text.replace('\n', "\r\n"),
        text.replace('\n', " ").replace("a part", "facet"),
        text.replace("endsolid a part\n", ""),
        text.replace("   endloop\n", ""),
        text.replace("  endfacet\n", ""),
        text.replace("endloop", "end loop"),
        text.replace("normal 0 0 0", "normal nan nan nan"),
        text.replace("normal 0 0 0", "normal"),
        text.replace("a part", "vertex of # facets"),
        text.replace("vertex 0 0", "vertex -0 +0e0"),
    ];
    for case in cases {
        assert!(whole(&case).is_empty(), "{case}");
    }
}

#[test]
fn several_solids_are_one_model() {
    let twice = format!("{}\n{}", text(), text().replace("a part", "vertex"));
    let model = stl(twice.replace("endsolid a part\n", ""));
    assert_eq!((model.triangles.len(), model.positions.len()), (8, 4));
    let model = stl(twice);
    assert_eq!((model.triangles.len(), model.positions.len()), (8, 4));
}

#[test]
fn mistakes_in_text_are_named() {
    let problem = |text: &str| read(&[("a.stl", text)]).unwrap_err();
    let text = text();
    let cases = [
        (
            text.replacen("vertex 0 1 0", "vertex 0 one 0", 1),
            "line 5: 'one' is not a number",
        ),
        (
            text.replacen("vertex 0 1 0", "vertex 0 1", 1)
                .replace('\n', "\r"),
            "line 6: 'vertex' is not a number",
        ),
        (
            text.replace("solid", "sold"),
            "it is text, and does not begin with 'solid'",
        ),
        (
            "solid facet vertex 1 2".into(),
            "there is nothing to draw; a face of fewer than 3 corners",
        ),
        ("solid endsolid\n".into(), "it has no faces"),
    ];
    for (text, says) in cases {
        let problem = problem(&text);
        assert!(problem.contains(says), "{problem}");
    }
    // From a file that ends too early, the triangles before its end are read.
    let end = text.rfind("vertex").unwrap();
    let facet = text.rfind("facet normal").unwrap();
    let first = facet + text[facet..].find("vertex").unwrap();
    for end in [end, end + 8, first + 8] {
        let model = stl(&text[..end]);
        assert_eq!(model.triangles.len(), 3);
        assert!(notes(&model)[0].contains("fewer than 3 corners"));
    }
    let model = stl(text.replacen("vertex 0 1 0", "vertex 0 nan 0", 1));
    assert_eq!(model.triangles.len(), 3);
    assert!(notes(&model)[0].contains("a coordinate"));
}

#[test]
fn binary_is_read_whatever_it_promises() {
    for header in [b"".as_slice(), b"solid a", b"\xef\xbb\xbf"] {
        assert!(whole(binary(header, 4, [0; 4])).is_empty());
    }
    let says = |bytes: &[u8]| {
        let notes = whole(bytes);
        assert_eq!(notes.len(), 1);
        notes[0].clone()
    };
    for promised in [0, 3, 5, u32::MAX] {
        let note = says(&binary(b"solid a", promised, [0; 4]));
        let wanted = format!("its header promises {promised} triangles: 4 are read");
        assert_eq!(note, wanted);
    }
    let bytes = binary(b"", 4, [0; 4]);
    for (end, count) in [(283, 3), (150, 1), (134, 1)] {
        let model = stl(&bytes[..end]);
        assert_eq!(model.triangles.len(), count);
        assert!(notes(&model)[0].contains(&format!("promises 4 triangles: {count} are read")));
    }
    // Other bytes can follow the triangles.
    says(&[&binary(b"", 0, [0; 4])[..], b"the end"].concat());
    assert!(whole([&bytes[..], b"the end"].concat()).is_empty());
    let model = stl([&bytes[..], &[1; 70]].concat());
    assert_eq!((model.triangles.len(), notes(&model).len()), (4, 0));
    for end in [85, 133] {
        let problem = read(&[("a.stl", &bytes[..end])]).unwrap_err();
        assert!(
            problem.contains("nothing to draw; its header promises 4 triangles: 0 are read"),
            "{problem}"
        );
    }
    let problem = read(&[("a.stl", &bytes[..83])]).unwrap_err();
    assert!(
        problem.contains("it has 83 bytes: a header takes 84"),
        "{problem}"
    );
}

#[test]
fn attributes_are_colors() {
    let colors = |header: &[u8], attributes: [u16; 4]| {
        let model = stl(binary(header, 4, attributes));
        let color = |at: usize| {
            let corners = model.triangles[at].corners;
            assert!(
                corners
                    .iter()
                    .all(|corner| corner.color == corners[0].color)
            );
            Some(model.colors[corners[0].color? as usize])
        };
        ([0, 1, 2, 3].map(color), model.colors.len())
    };
    // Attributes without the highest bit are not colors.
    assert_eq!(colors(b"", [1, 2, 0x7fff, 0]), ([None; 4], 0));
    let found = colors(b"", [0x801f, 0x83e0, 0xfc00, 0x1f]);
    let [blue, green, red, white] = [[0, 0, 255], [0, 255, 0], [255, 0, 0], [255; 3]];
    assert_eq!(
        found,
        ([Some(blue), Some(green), Some(red), Some(white)], 4)
    );
    let found = colors(b"COLOR=\x01\x02\x03", [0x1f; 4]);
    assert_eq!(found, ([Some(red); 4], 1));
    let half = [0, 0, 132];
    assert_eq!(
        colors(b"", [0x8010, 0x8010, 0xffff, 0]),
        ([Some(half), Some(half), Some(white), Some(white)], 2)
    );
    let found = colors(
        b"COLOR=\x01\x02\x03\xff,MATERIAL=",
        [0x1f, 0x3e0, 0x7c00, 0xffff],
    );
    assert_eq!(
        found,
        ([Some(red), Some(green), Some(blue), Some([1, 2, 3])], 4)
    );
}

#[test]
fn an_object_color_serves_triangles_without_any() {
    let colors = |attributes| {
        let model = read(&[("a.stl", binary(b"COLOR=\xff\x80\x00\xff", 4, attributes))]).unwrap();
        let corners = model
            .triangles
            .iter()
            .map(|it| it.corners[0].color.unwrap());
        corners
            .map(|at| model.colors[at as usize])
            .collect::<Vec<_>>()
    };
    let own = [255, 128, 0];
    assert_eq!(colors([0; 4]), [own; 4]);
    // Beside a triangle with a color of its own, 0 is black.
    assert_eq!(
        colors([31, 0, 0x8000, 0]),
        [[255, 0, 0], [0; 3], own, [0; 3]]
    );
}

#[test]
fn facets_can_have_any_number_of_corners() {
    let facet = |corners: &[&str]| {
        let lines = corners.iter().map(|corner| format!("vertex {corner}\n"));
        let lines = lines.collect::<Vec<_>>().concat();
        format!("facet normal 0 0 1\nouter loop\n{lines}endloop\nendfacet\n")
    };
    let square = ["0 0 0", "1 0 0", "1 1 0", "0 1 0"];
    let read_text =
        |facets: String| read(&[("a.stl", format!("solid\n{facets}endsolid\n"))]).unwrap();
    let model = read_text(facet(&square));
    let corners = model
        .triangles
        .iter()
        .map(|it| it.corners.map(|corner| corner.position));
    assert!(corners.eq([[0, 1, 2], [0, 2, 3]]));
    assert!(model.notes.is_empty(), "{:?}", notes(&model));
    let model = read_text(facet(&square[..3]) + &facet(&square[..2]) + &facet(&square));
    assert_eq!(model.triangles.len(), 3);
    assert_eq!(
        notes(&model),
        ["a face of fewer than 3 corners is left out"]
    );
    // A loop without its end, as some programs write it, ends with the facet.
    let model = read_text(facet(&square).replace("endloop\n", "") + &facet(&square[1..]));
    assert_eq!(model.triangles.len(), 3);
}
