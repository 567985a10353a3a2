//! The values in a file's buffers: buffer views and accessors.

use serde_json::Value;

use super::{Reader, STEP, check_compression, whole};
use crate::MOST;

impl Reader<'_> {
    /// The values of an attribute. The list is empty if the attribute is missing, or has more or fewer values than
    /// there are positions.
    pub(super) fn attribute<const N: usize>(
        &mut self,
        accessor: &Value,
        count: usize,
    ) -> Result<Vec<[f64; N]>, String> {
        let Some(at) = whole(accessor) else {
            return Ok(Vec::new());
        };
        if whole(&self.item("accessors", at)?["count"]) != Some(count) {
            let note = "an attribute with another number of values than positions is left out";
            self.model.notes.add(note);
            return Ok(Vec::new());
        }
        self.values(at)
    }

    /// Whether some value of an attribute of colors is not opaque.
    pub(super) fn has_alpha(&mut self, accessor: &Value, count: usize) -> Result<bool, String> {
        let Some(at) = whole(accessor) else {
            return Ok(false);
        };
        if self.item("accessors", at)?["type"] != "VEC4" {
            return Ok(false);
        }
        let colors = self.attribute::<4>(accessor, count)?;
        Ok(colors.iter().any(|color| color[3] < 1.0))
    }

    /// The bytes of a buffer view, and the stride of its values if the view states one.
    pub(super) fn view(&self, at: usize) -> Result<(&[u8], Option<usize>), String> {
        let view = self.item("bufferViews", at)?;
        let number = |name: &str| whole(&view[name]);
        let (start, length) = (
            number("byteOffset").unwrap_or(0),
            number("byteLength").unwrap_or(0),
        );
        let buffer = number("buffer").unwrap_or(0);
        self.item("buffers", buffer)?;
        let buffer = &self.buffers[buffer];
        if buffer.is_empty() {
            check_compression(|name| view["extensions"][name].is_object())?;
        }
        let bytes = buffer.get(start..).and_then(|rest| rest.get(..length));
        let bytes = bytes.ok_or_else(|| {
            format!(
                "bufferView {at} reaches beyond its buffer of {} bytes",
                buffer.len()
            )
        })?;
        Ok((bytes, number("byteStride").filter(|&stride| stride > 0)))
    }

    /// The first `N` components of each value of an accessor, as numbers.
    pub(super) fn values<const N: usize>(&mut self, at: usize) -> Result<Vec<[f64; N]>, String> {
        let accessor = self.item("accessors", at)?;
        let components = match accessor["type"].as_str() {
            Some("SCALAR") => 1,
            Some("VEC2") => 2,
            Some("VEC3") => 3,
            Some("VEC4") => 4,
            Some("MAT4") => 16,
            _ => 0,
        };
        if components < N {
            return Err(format!(
                "accessor {at}: it has {components} components per value, and needs {N}"
            ));
        }
        let kind = whole(&accessor["componentType"]).unwrap_or(0);
        let size = component_size(kind)
            .ok_or_else(|| format!("accessor {at}: there is no componentType {kind}"))?;
        let count = whole(&accessor["count"]).unwrap_or(0);
        let normalized = accessor["normalized"].as_bool().unwrap_or(false);
        let value = |bytes: &[u8]| -> [f64; N] {
            let mut components = bytes
                .chunks_exact(size)
                .map(|bytes| number(kind, bytes, normalized));
            [(); N].map(|()| components.next().unwrap_or(0.0))
        };
        let leaves = || format!("accessor {at} reaches beyond its buffer view");
        let offset = |object: &Value| whole(&object["byteOffset"]).unwrap_or(0);
        let whole_size = components * size;
        let sparse = &accessor["sparse"];
        let changes = whole(&sparse["count"]);
        let mut values = match whole(&accessor["bufferView"]) {
            Some(view) => {
                let (bytes, stride) = self.view(view)?;
                let stride = stride.unwrap_or(whole_size);
                let rows =
                    rows(bytes, offset(accessor), stride, whole_size, count).ok_or_else(leaves)?;
                rows.map(value).collect()
            }
            None if count <= MOST => vec![[0.0; N]; count],
            None => {
                return Err(format!(
                    "accessor {at} has {count} values but no bytes: at most {MOST} are read"
                ));
            }
        };
        if let Some(count) = changes {
            let (places, changed) = (&sparse["indices"], &sparse["values"]);
            let place_kind = whole(&places["componentType"]).unwrap_or(0);
            let place_size = component_size(place_kind).ok_or_else(leaves)?;
            let view =
                |object: &Value| self.view(whole(&object["bufferView"]).unwrap_or(usize::MAX));
            let (place_bytes, _) = view(places)?;
            let (changed_bytes, _) = view(changed)?;
            let indices = rows(place_bytes, offset(places), place_size, place_size, count)
                .ok_or_else(leaves)?;
            let changed = rows(
                changed_bytes,
                offset(changed),
                whole_size,
                whole_size,
                count,
            );
            for (index, bytes) in indices.zip(changed.ok_or_else(leaves)?) {
                #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)]
                // a whole number of 32 bits
                let index = number(place_kind, index, false) as usize;
                *values.get_mut(index).ok_or_else(leaves)? = value(bytes);
            }
        }
        self.spend(STEP + (count + changes.unwrap_or(0)) * whole_size)?;
        Ok(values)
    }
}

/// Splits `bytes` after `offset` into `count` values of `size` bytes that begin every `stride` bytes; `None` if there
/// are too few bytes.
fn rows(
    bytes: &[u8],
    offset: usize,
    stride: usize,
    size: usize,
    count: usize,
) -> Option<impl Iterator<Item = &[u8]>> {
    let end = match count.checked_sub(1) {
        Some(last) => offset
            .checked_add(stride.checked_mul(last)?)?
            .checked_add(size)?,
        None => offset,
    };
    let bytes = bytes.get(offset..end)?;
    Some((0..count).map(move |at| &bytes[at * stride..][..size]))
}

/// How many bytes a component takes.
fn component_size(kind: usize) -> Option<usize> {
    match kind {
        5120 | 5121 => Some(1),
        5122 | 5123 => Some(2),
        5125 | 5126 => Some(4),
        _ => None,
    }
}

/// Reads a component of a value. A `normalized` integer stands for a fraction.
fn number(kind: usize, bytes: &[u8], normalized: bool) -> f64 {
    let (value, most) = match (kind, bytes) {
        (5120, &[a]) => (i8::from_le_bytes([a]).into(), 127.0),
        (5121, &[a]) => (a.into(), 255.0),
        (5122, &[a, b]) => (i16::from_le_bytes([a, b]).into(), 32_767.0),
        (5123, &[a, b]) => (u16::from_le_bytes([a, b]).into(), 65_535.0),
        (5125, &[a, b, c, d]) => (u32::from_le_bytes([a, b, c, d]).into(), f64::from(u32::MAX)),
        (5126, &[a, b, c, d]) => return f32::from_le_bytes([a, b, c, d]).into(),
        _ => return 0.0,
    };
    if normalized {
        f64::max(value / most, -1.0)
    } else {
        value
    }
}
