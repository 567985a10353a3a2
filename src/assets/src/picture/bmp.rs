//! Reads BMP files with all headers of Windows and OS/2, all numbers of bits per pixel, and run-length encoding of 4
//! and 8 bits.

use super::{Picture, check, colored, indexed, masked, shown, turned, unpacked};

/// The length of the file header. A second header with the size of the picture follows it.
const FILE_HEADER: usize = 14;

/// Reads a BMP.
pub fn read(bytes: &[u8]) -> Result<Picture, String> {
    let long = |at: usize| {
        let bytes = bytes.get(at..).and_then(|rest| rest.first_chunk());
        bytes.map_or(Err("it ends in its header"), |&bytes| {
            Ok(u32::from_le_bytes(bytes))
        })
    };
    let (start, header) = (long(10)? as usize, long(14)?);
    // The oldest header of OS/2 has 16 bits for each side, and its colors have 3 bytes.
    let is_old = header == 12;
    if !is_old && !(16..=256).contains(&header) {
        return Err(format!(
            "its header has {header} bytes: 12, or 16 to 256, can be read"
        ));
    }
    let (size, depth) = (long(18)?, if is_old { long(22)? } else { long(26)? });
    let (width, rows) = if is_old {
        ((size & 0xffff) as usize, (size >> 16).cast_signed())
    } else {
        (size as usize, long(22)?.cast_signed())
    };
    // A negative height means that the top row comes first.
    let (from_bottom, height) = (rows > 0, rows.unsigned_abs() as usize);
    let bits = (depth >> 16) as usize;
    let compression = if header < 20 { 0 } else { long(30)? };
    // Without compression, a pixel takes at least 1 bit. A run of at most 255 pixels takes 2 bytes. (Jumps could skip
    // more pixels than that, but programs do not write whole pictures as jumps.)
    let len = bytes.len() as u64;
    let most = len * if compression == 0 { 16 } else { 255 } / 2;
    check(bytes, most, width as u64, height as u64)?;
    let is_os2 = header == 64;
    match (compression, bits) {
        (0, 1 | 2 | 4 | 8 | 16 | 24 | 32) | (1, 8) | (2, 4) => {}
        (3 | 6, 16 | 32) if !is_os2 => {}
        (0, _) => {
            return Err(format!(
                "it has {bits} bits a pixel: 1, 2, 4, 8, 16, 24 or 32 can be read"
            ));
        }
        _ => {
            return Err(format!(
                "its compression {compression} of {bits} bits a pixel cannot be read"
            ));
        }
    }
    let data = bytes.get(start..).ok_or("it ends before its pixels")?;
    if bits > 8 {
        let masks = match (compression, bits) {
            (3 | 6, _) => {
                let has_alpha = compression == 6 || header >= 56;
                let alpha = if has_alpha { long(66)? } else { 0 };
                [long(54)?, long(58)?, long(62)?, alpha]
            }
            (_, 16) => [0x7c00, 0x3e0, 0x1f, 0],
            (_, 24) => [0x00ff_0000, 0xff00, 0xff, 0],
            _ => [0x00ff_0000, 0xff00, 0xff, 0xff00_0000],
        };
        let pixels = rows_of(data, bits, width, height)?
            .flat_map(|row| row[..width * bits / 8].chunks_exact(bits / 8))
            .map(|raw| masked(raw, masks));
        let pixels = shown(pixels.collect());
        return colored(width, height, turned(pixels, width, from_bottom, false));
    }
    let step = if is_old { 3 } else { 4 };
    let table = FILE_HEADER + header as usize;
    let used = if header < 36 { 0 } else { long(46)? as usize };
    let most = 1 << bits;
    let used = if used == 0 || used > most { most } else { used };
    // A table can be shorter than its header says.
    let end = start.min(bytes.len()).min(table + used * step);
    let entries = bytes.get(table..end).unwrap_or_default().chunks_exact(step);
    let colors = entries.map(|bgr| [bgr[2], bgr[1], bgr[0], 255]).collect();
    let indices = if compression == 0 {
        rows_of(data, bits, width, height)?
            .flat_map(|row| unpacked(row, bits, width))
            .collect()
    } else {
        runs(data, bits, width, height)?
    };
    let indices = turned(indices, width, from_bottom, false);
    indexed(width, height, indices, colors)
}

/// The rows of a picture without compression. Each row is padded to a multiple of 4 bytes. The padding of the last row
/// can be missing.
fn rows_of(
    data: &[u8],
    bits: usize,
    width: usize,
    height: usize,
) -> Result<impl Iterator<Item = &[u8]>, String> {
    let row = (width * bits).div_ceil(8);
    let stride = row.next_multiple_of(4);
    let have = (data.len() + stride - row) / stride.max(1);
    if have < height {
        return Err(format!("it ends after {have} of {height} rows"));
    }
    Ok((0..height).map(move |y| &data[y * stride..][..row]))
}

/// The indices of pixels that are stored as runs. Pixels that the runs skip have index 0.
fn runs(mut data: &[u8], bits: usize, width: usize, height: usize) -> Result<Vec<u8>, String> {
    let mut indices = vec![0; width * height];
    let (mut x, mut y) = (0, 0);
    while y < height {
        let Some(&[count, value]) = data.split_off(..2) else {
            if y + 1 == height && x >= width {
                break;
            }
            return Err(format!("it ends in row {y} of {height}"));
        };
        let pair = [value; 255];
        let (run, count) = match (count, value) {
            (0, 0) => {
                (x, y) = (0, y + 1);
                continue;
            }
            (0, 1) => break,
            (0, 2) => {
                let step = data.split_off(..2).unwrap_or(&[0, 0]);
                (x, y) = (x + usize::from(step[0]), y + usize::from(step[1]));
                continue;
            }
            (0, count) => {
                let len = (usize::from(count) * bits).div_ceil(8);
                let run = data.split_off(..len.next_multiple_of(2).min(data.len()));
                (run.unwrap_or_default(), usize::from(count))
            }
            (count, _) => (&pair[..], usize::from(count)),
        };
        let count = count.min(run.len() * 8 / bits);
        for index in unpacked(run, bits, count) {
            if x < width {
                indices[y * width + x] = index;
            }
            x += 1;
        }
    }
    Ok(indices)
}
