//! Files with mistakes anywhere. The program must draw them or report an error, but must not panic.

use std::fs;

use super::make;
use super::program::{directory, run};

/// Numbers that look random (xorshift).
struct Random(u64);

impl Random {
    fn below(&mut self, end: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        usize::try_from(self.0 % end as u64).unwrap()
    }
}

/// Changes, cuts or repeats a few bytes.
fn mutate(bytes: &mut Vec<u8>, random: &mut Random) {
    for _ in 0..=random.below(3) {
        let at = random.below(bytes.len());
        match random.below(6) {
            0 => bytes[at] = u8::try_from(random.below(256)).unwrap(),
            1 => bytes[at] ^= 1 << random.below(8),
            2 => bytes.truncate(at.max(1)),
            3 => bytes[at] = *b"0189-.e \n{\"\xff".get(random.below(12)).unwrap(),
            4 => {
                let piece = bytes[at..]
                    .iter()
                    .copied()
                    .take(1 + random.below(40))
                    .collect::<Vec<_>>();
                let to = random.below(bytes.len());
                bytes.splice(to..to, piece);
            }
            _ => {
                let end = (at + random.below(40)).min(bytes.len());
                bytes.drain(at..end.max(at));
            }
        }
        if bytes.is_empty() {
            bytes.push(b' ');
        }
    }
}

#[test]
fn mutated_models_are_drawn_or_refused() {
    let directory = directory("mutated");
    let mtl = "newmtl a\nmap_Kd -s 1 1 1 a.png\nKd 1 0 0\n";
    let obj = make::obj(true)
        + "mtllib m.mtl\nusemtl a\nvt 0 1\nvn 0 0 1\nf 1/1/1 2//1 3/1 4\nl 1 2 \\\n3\n";
    fs::write(directory.join("m.mtl"), mtl).unwrap();
    let mut models = vec![
        ("m.obj", obj.into_bytes()),
        ("m.mtl", mtl.as_bytes().to_vec()),
        ("text.stl", make::stl_text().into_bytes()),
        ("binary.stl", make::stl_binary()),
    ];
    models.push(("text.ply", make::ply_text(true).into_bytes()));
    models.push(("binary.ply", make::ply_binary()));
    let sparse = make::gltf(true, "", "").replace(
        r#""type": "SCALAR"}"#,
        r#""type": "SCALAR", "sparse": {"count": 2, "indices": {"bufferView": 2, "componentType": 5123},
           "values": {"bufferView": 2}}}"#,
    );
    let data = r#", "uri": "a%20house.bin""#;
    make::write_gltf(&directory, "m.gltf", true, "");
    models.push(("m.glb", make::glb(true, r#", "rotation": [0, 1, 0, 0]"#)));
    models.push((
        "m.gltf",
        sparse.replace("288", &format!("288{data}")).into_bytes(),
    ));
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    let rounds: usize = std::env::var("MUTATIONS").map_or(40, |count| count.parse().unwrap());
    for round in 0..rounds {
        for (name, bytes) in &models {
            let mut bytes = bytes.clone();
            mutate(&mut bytes, &mut random);
            fs::write(directory.join(name), &bytes).unwrap();
            let model = if *name == "m.mtl" { "m.obj" } else { name };
            let output = run(&directory, &format!("{model} --size 8x6 --out p.png"));
            let message = String::from_utf8_lossy(&output.stderr);
            let fine = matches!(output.status.code(), Some(0 | 1)) && !message.contains("panicked");
            assert!(fine, "{name}, round {round}: {:?} {message}", output.status);
            let one_line = output.status.success()
                || message
                    .lines()
                    .last()
                    .is_some_and(|last| last.starts_with("error: "));
            assert!(one_line, "{name}, round {round}: {message}");
        }
    }
}
