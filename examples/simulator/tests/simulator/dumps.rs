//! The values in a dump, pixel by pixel. Bands give the same values as a frame.

use super::program::Bench;

#[test]
fn bands_equal_the_frame() {
    let bench = Bench::new("bands");
    for scene in [
        "",
        "--scene floor",
        "--scene cube",
        "--scene sphere",
        "--scene sphere-flat",
    ] {
        let whole = bench.crc(format!("{scene} --dump whole.csv"));
        for rows in [1, 7, 16, 1000] {
            let banded = bench.crc(format!("{scene} --dump bands.csv --bands {rows}"));
            assert_eq!(whole, banded, "{scene} {rows}");
            let are_equal = bench.read("whole.csv") == bench.read("bands.csv");
            assert!(
                are_equal,
                "dumps of {scene} whole and in bands of {rows} rows differ"
            );
        }
    }
}

#[test]
fn the_dump_is_exact_and_in_row_order() {
    let bench = Bench::new("dump");
    // A square straight ahead fills the frame, with u and v from 0 to 1.
    bench.write("square.obj", "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n",
    );
    bench.good("square.obj --size 4x4 --eye 0,0,1 --look-at 0,0,0 --fov 90 --near 0.5 --far 2 --dump d.csv",
    );
    let dump = bench.text("d.csv");
    let rows: Vec<&str> = dump.lines().collect();
    assert_eq!(rows.len(), 17);
    for (at, row) in rows[1..].iter().enumerate() {
        let cells: Vec<f64> = row.split(',').map(|cell| cell.parse().unwrap()).collect();
        let at = f64::from(u8::try_from(at).unwrap());
        let (x, y) = (at % 4.0, (at / 4.0).floor());
        assert_eq!(cells[..2], [x, y], "{row}");
        // u and v are the values at the pixel's center. v points down. The error is a few units of 2^-24.
        assert!(((x + 0.5) / 4.0 - cells[2]).abs() < 1e-6, "{row}");
        assert!(((y + 0.5) / 4.0 - cells[3]).abs() < 1e-6, "{row}");
        assert!((cells[4] - 1.0).abs() < 1e-4, "{row}");
        // Depth is 65535 · near / w, rounded down.
        assert!((cells[5] - 32767.0).abs() <= 1.0, "{row}");
    }
}
