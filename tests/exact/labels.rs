//! The labels of drawings can be read on a phone.

/// The width of a drawing in pixels on a page of 400, of rustdoc; GitHub gives a little more.
const WIDTH: f32 = 358.0;
const LEAST: f32 = 9.0;
const FOLDERS: [&str; 4] = [
    "src/guide",
    "src/guide/diagrams",
    "examples/assets",
    "examples/boards/wires",
];

/// The values of an attribute in a drawing.
fn values(drawing: &str, attribute: &str) -> Vec<f32> {
    let begin = format!(" {attribute}=\"");
    drawing
        .split(&begin)
        .skip(1)
        .map(|rest| rest.split('"').next().unwrap().parse().unwrap())
        .collect()
}

#[test]
fn labels_have_nine_pixels_on_a_phone() {
    for folder in FOLDERS {
        let mut drawings = 0;
        for file in std::fs::read_dir(format!("{}/{folder}", env!("CARGO_MANIFEST_DIR"))).unwrap() {
            let path = file.unwrap().path();
            if !path
                .extension()
                .is_some_and(|extension| extension == "svg" || extension == "md")
            {
                continue;
            }
            let page = std::fs::read_to_string(&path).unwrap();
            for drawing in page.split("<svg").skip(1) {
                let (drawing, _) = drawing.split_once("</svg>").unwrap();
                let width = values(drawing, "width")[0];
                let font = values(drawing, "font-size")
                    .into_iter()
                    .reduce(f32::min)
                    .unwrap();
                let label = font * (WIDTH / width).min(1.0);
                assert!(
                    label >= LEAST,
                    "{}: labels of {label} pixels on a phone, less than {LEAST}",
                    path.display()
                );
                drawings += 1;
            }
        }
        assert_ne!(drawings, 0, "no drawing in {folder}");
    }
}
