//! Reads TGA files, with and without a table of colors, run-length encoding, and alpha. The first pixel can be in any
//! corner.

use super::{Picture, check, colored, indexed, masked, shown, turned};

/// Whether a file can be a TGA. TGA has no signature at its start, so this checks whether the fields of the header make
/// sense.
pub fn is(bytes: &[u8]) -> bool {
    let Some(&[_, has_table, kind, .., bits, flags]) = bytes.first_chunk::<18>() else {
        return false;
    };
    has_table <= 1
        && matches!(kind & !8, 1..=3)
        && matches!(bits, 8 | 15 | 16 | 24 | 32)
        && flags >> 6 == 0
}

/// Reads a TGA.
pub fn read(bytes: &[u8]) -> Result<Picture, String> {
    const SHORT: &str = "it ends before its pixels";
    let (header, mut rest) = bytes.split_first_chunk::<18>().ok_or(SHORT)?;
    let word = |at: usize| usize::from(u16::from_le_bytes([header[at], header[at + 1]]));
    let bytes_of = |bits: u8| usize::from(bits.div_ceil(8));
    let (kind, flags) = (header[2], header[17]);
    let (width, height) = (word(12), word(14));
    // Without compression, a pixel takes at least 1 byte. A run of at most 128 pixels takes at least 2 bytes.
    let len = bytes.len() as u64;
    let most = if kind & 8 == 0 { len } else { len * 128 / 2 };
    check(bytes, most, width as u64, height as u64)?;
    let color = |raw: &[u8]| {
        let [r, g, b, alpha] = match (kind & 3, raw.len()) {
            (_, 1) => [0xff; 4],
            (3, 2) => [0xff, 0xff, 0xff, 0xff00],
            (_, 2) => [0x7c00, 0x3e0, 0x1f, 0x8000],
            _ => [0x00ff_0000, 0xff00, 0xff, 0xff00_0000],
        };
        let has_alpha = flags & 15 > 0 && matches!(raw.len(), 2 | 4);
        masked(raw, [r, g, b, if has_alpha { alpha } else { 0 }])
    };
    rest.split_off(..usize::from(header[0])).ok_or(SHORT)?;
    let size = bytes_of(header[7]);
    let entries = rest.split_off(..word(5) * size * usize::from(header[1]));
    let entries = entries.ok_or(SHORT)?.chunks_exact(size.max(1));
    // The first color that the file stores can have an index greater than 0.
    let mut colors = vec![[0, 0, 0, 255]; word(3)];
    colors.extend(shown(entries.map(color).collect()));

    let size = bytes_of(header[16]);
    let (count, len) = (width * height, width * height * size);
    let mut raw = Vec::new();
    if kind & 8 == 0 {
        raw.extend(rest.split_off(..len.min(rest.len())).unwrap_or_default());
    }
    while kind & 8 != 0 && raw.len() < len {
        let Some(packet) = rest.split_off_first() else {
            break;
        };
        let times = usize::from(packet & 127) + 1;
        if packet & 128 == 0 {
            raw.extend(
                rest.split_off(..(times * size).min(rest.len()))
                    .unwrap_or_default(),
            );
        } else {
            raw.extend(rest.split_off(..size).unwrap_or_default().repeat(times));
        }
    }
    if raw.len() < len {
        return Err(format!(
            "it ends after {} of {count} pixels",
            raw.len() / size
        ));
    }
    raw.truncate(len);
    let (from_bottom, from_right) = (flags & 0x20 == 0, flags & 0x10 != 0);
    if kind & 3 == 1 && size == 1 {
        colors.truncate(256);
        return indexed(
            width,
            height,
            turned(raw, width, from_bottom, from_right),
            colors,
        );
    }
    let pixels: Option<Vec<[u8; 4]>> = raw
        .chunks_exact(size)
        .map(|raw| match *raw {
            [low, high] if kind & 3 == 1 => {
                let at = u16::from_le_bytes([low, high]);
                colors.get(usize::from(at)).copied()
            }
            _ => Some(color(raw)),
        })
        .collect();
    let pixels = shown(pixels.ok_or("a color index is not in its table")?);
    colored(
        width,
        height,
        turned(pixels, width, from_bottom, from_right),
    )
}
