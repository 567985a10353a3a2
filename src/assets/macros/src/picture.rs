//! `include_texture!`.

use std::collections::HashMap;

use fixel_assets::{Disk, Files, Format, Notes, Picture};

use crate::arguments::Arguments;
use crate::expansion::Expansion;

/// The largest width or height of a texture, in pixels.
const MOST: u32 = 1 << 15;

/// Reads a picture file, or a picture that a model contains.
fn read(arguments: &Arguments, out: &mut Expansion) -> Result<Picture, String> {
    let path = &arguments.path.path;
    if Format::of(path).is_none() {
        if arguments.value("image").is_some() {
            return Err(
                "the option image selects a picture of a model, but this file is a picture".into(),
            );
        }
        out.depend(std::slice::from_ref(path));
        let bytes = Disk.read(path);
        let bytes = bytes.map_err(|error| format!("it cannot be read: {error}"))?;
        return Picture::decode(&bytes);
    }
    let mut model = fixel_assets::read(path, &Disk)?;
    out.depend(std::slice::from_ref(path));
    out.depend(&model.files);
    let at = match arguments.value("image") {
        None => 0,
        Some(at) => at
            .parse()
            .map_err(|_| format!("image is {at}: it must be a whole number"))?,
    };
    let count = model.images.len();
    if at as usize >= count {
        return Err(format!(
            "image {at} does not exist: there are {count}, counted from 0"
        ));
    }
    // The mesh of the same file has the model's other notes.
    model.notes = Notes::default();
    let picture = model.picture(at, &Disk);
    out.note(&arguments.path.value, &model.notes);
    picture
}

/// The size that an option asks for, such as 256x256.
fn size(text: &str) -> Option<(u32, u32)> {
    let (width, height) = text.split_once('x')?;
    Some((width.parse().ok()?, height.parse().ok()?))
}

pub fn texture(arguments: &Arguments) -> Result<Expansion, String> {
    arguments.check(&["image", "mipmap", "raw", "size"])?;
    let mut out = Expansion::default();
    let mut picture = read(arguments, &mut out)?;
    if let Some(text) = arguments.text("size")? {
        let (width, height) = size(&text).ok_or_else(|| {
            format!("size is {text}: it must be two whole numbers, such as \"256x256\"")
        })?;
        check(width, height)?;
        picture = picture.resampled(width, height);
    }
    let (width, height) = (picture.width, picture.height);
    check(width, height).map_err(|problem| {
        #[allow(clippy::cast_sign_loss)] // at least 0
        let near = |side: u32| 1 << f64::from(side.clamp(1, MOST)).log2().round() as u32;
        let (width, height): (u32, u32) = (near(width), near(height));
        format!("{problem}; with size = \"{width}x{height}\" it is resampled")
    })?;
    if let Some(format) = arguments.value("raw") {
        let bytes = raw(&picture, format).ok_or_else(|| {
            let names = RAW.map(|(name, ..)| name).join(", ");
            format!(
                "raw is {format}: it must be one of {names}, or end in _le for the low byte first"
            )
        })?;
        let bytes = out.bytes(bytes);
        out.push(&bytes);
        return Ok(out);
    }
    // Each different color is converted once, and the pixels are stored as indices of these colors.
    if arguments.has("mipmap") {
        // Each level is computed from the whole picture, not from the level before, so that rounding errors do not add
        // up.
        let level = |level: u32| picture.resampled(width >> level, height >> level).pixels;
        let smaller: Vec<_> = (1..=width.min(height).ilog2()).flat_map(level).collect();
        picture.pixels.extend(smaller);
    }
    let palette = picture.palette();
    let (indices, colors) = palette.unwrap_or_else(|| indexed(&picture.pixels));
    let (pixels, count) = (picture.pixels.len(), colors.len());
    let colors = out.bytes(colors.into_iter().flat_map(formats).collect());
    let indices = out.bytes(indices);
    let path = &arguments.path.value;
    out.push(&format!(
        "enum Asset {{}}
         use fixel::texture::include::{{FromFile, Picture}};
         impl<const N: usize, const K: usize> FromFile<Asset, N, K> for Picture {{
             const VALUE: Self = Self {{
                 path: {path:?},
                 size: [{width}, {height}],
                 colors: {colors}.as_chunks().0,
                 pixels: {indices},
             }};
         }}
         <_ as FromFile<Asset, {pixels}, {count}>>::VALUE"
    ));
    Ok(out)
}

/// Formats of raw texels: for red, green and blue, the lowest bit and the number of bits.
const RAW: [(&str, [[u32; 2]; 3]); 8] = [
    ("rgb555", [[10, 5], [5, 5], [0, 5]]),
    ("bgr555", [[0, 5], [5, 5], [10, 5]]),
    ("rgb565", [[11, 5], [5, 6], [0, 5]]),
    ("bgr565", [[0, 5], [5, 6], [11, 5]]),
    ("rgb666", [[12, 6], [6, 6], [0, 6]]),
    ("bgr666", [[0, 6], [6, 6], [12, 6]]),
    ("rgb888", [[16, 8], [8, 8], [0, 8]]),
    ("bgr888", [[0, 8], [8, 8], [16, 8]]),
];

/// The fraction channel/255 in units of 2^-16, with an error of at most half a unit.
fn fraction(channel: u8) -> u32 {
    u32::from(channel) * 257 + u32::from(channel >> 7)
}

/// Converts a fraction to a number of `bits` bits, rounded as `fixel` rounds it.
fn steps(fraction: u32, bits: u32) -> u32 {
    (fraction * ((1 << bits) - 1) + (1 << 15)) >> 16
}

/// A color in the formats that `fixel::texture::include::Picture` lists.
fn formats(pixel: [u8; 4]) -> Vec<u8> {
    let [r, g, b, alpha] = pixel.map(fraction);
    // The weights add up to 2^14.
    let luma = (4899 * r + 9617 * g + 1868 * b + (1 << 13)) >> 14;
    let byte = |fraction, bits| steps(fraction, bits).to_le_bytes()[0];
    let rgb = [5, 6, 8].map(|bits| [byte(r, bits), byte(g, bits), byte(b, bits)]);
    let gray = [1, 2, 4, 8].map(|bits| byte(luma, bits));
    let packed = |alpha_bits: u32, bits: u32| {
        let first = steps(alpha, alpha_bits);
        let add = |sum: u32, &channel| sum << bits | steps(channel, bits);
        let [low, high, ..] = [r, g, b].iter().fold(first, add).to_le_bytes();
        [high, low]
    };
    let argb = [packed(1, 5), packed(4, 4)];
    [rgb.as_flattened(), &gray, argb.as_flattened()].concat()
}

/// The bytes of texels in a format: the high byte first or, if the format's name ends in `_le`, the low byte first.
fn raw(picture: &Picture, format: &str) -> Option<Vec<u8>> {
    let low_first = format.strip_suffix("_le");
    let (_, channels) = RAW
        .iter()
        .find(|(name, _)| *name == low_first.unwrap_or(format))?;
    let size = channels
        .iter()
        .map(|[low, bits]| low + bits)
        .max()?
        .div_ceil(8) as usize;
    let texel = |pixel: &[u8; 4]| {
        let channels = channels
            .iter()
            .zip(pixel)
            .map(|(&[low, bits], &channel)| steps(fraction(channel), bits) << low);
        let bytes = channels.sum::<u32>().to_le_bytes();
        let mut bytes = bytes[..size].to_vec();
        if low_first.is_none() {
            bytes.reverse();
        }
        bytes
    };
    Some(picture.pixels.iter().flat_map(texel).collect())
}

/// The pixels as indices of three bytes each, and the list of different colors.
fn indexed(pixels: &[[u8; 4]]) -> (Vec<u8>, Vec<[u8; 4]>) {
    let (mut places, mut colors) = (HashMap::new(), Vec::new());
    let mut indices = Vec::with_capacity(3 * pixels.len());
    for &pixel in pixels {
        let place = *places.entry(pixel).or_insert_with(|| {
            colors.push(pixel);
            colors.len() - 1
        });
        indices.extend_from_slice(&place.to_le_bytes()[..3]);
    }
    (indices, colors)
}

/// Refuses a width or a height that a texture cannot have.
fn check(width: u32, height: u32) -> Result<(), String> {
    for (side, name) in [(width, "width"), (height, "height")] {
        if !side.is_power_of_two() || side > MOST {
            return Err(format!(
                "{name} is {side}: it must be a power of two, at most {MOST}"
            ));
        }
    }
    Ok(())
}
