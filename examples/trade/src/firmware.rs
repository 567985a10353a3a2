//! Figures of other programs: instructions that the program `firmware` printed, and code sizes from another tool.

use std::collections::HashMap;
use std::fs;

use super::Result;
use super::args::Named;

/// The cost of a scene on a target in a mode.
#[derive(Clone, Debug, PartialEq)]
pub struct Cost {
    pub scene: String,
    pub mode: String,
    pub pixels: u64,
    pub instructions: u64,
    /// The CRC-32 of the picture, if the program printed it.
    pub crc: Option<u32>,
}

/// Reads the output of `firmware`: `tick=N instructions`, and for each scene `scene=… mode=… layout=frame pixels=…
/// ticks=… crc=…`. Other lines and layouts are ignored.
pub fn costs(named: &Named) -> Result<Vec<Cost>> {
    let text = read(named)?;
    let costs = parse(&text).map_err(|problem| format!("{}: {problem}", named.file.display()))?;
    if costs.is_empty() {
        return Err(format!(
            "{}: no line with scene=… mode=… layout=frame pixels=… ticks=…",
            named.file.display()
        )
        .into());
    }
    Ok(costs)
}

fn parse(text: &str) -> Result<Vec<Cost>> {
    let mut tick = None;
    let mut costs = Vec::new();
    for line in text.lines() {
        let values: HashMap<&str, &str> = line
            .split_whitespace()
            .filter_map(|word| word.split_once('='))
            .collect();
        let value = |key: &str| values.get(key).copied();
        let number = |key: &str, text: &str| -> Result<u64> {
            text.parse()
                .map_err(|_| format!("'{key}={text}' must be a whole number").into())
        };
        if let Some(text) = value("tick") {
            tick = Some(number("tick", text)?);
        }
        let (Some(scene), Some(mode), Some("frame"), Some(pixels), Some(ticks)) = (
            value("scene"),
            value("mode"),
            value("layout"),
            value("pixels"),
            value("ticks"),
        ) else {
            continue;
        };
        let tick = tick.ok_or("'tick=… instructions' must come first")?;
        costs.push(Cost {
            scene: scene.into(),
            mode: mode.into(),
            pixels: number("pixels", pixels)?,
            instructions: number("ticks", ticks)? * tick,
            crc: match value("crc") {
                Some(text) => Some(
                    u32::from_str_radix(text, 16)
                        .map_err(|_| format!("'crc={text}' must be hexadecimal"))?,
                ),
                None => None,
            },
        });
    }
    Ok(costs)
}

/// Reads lines of `mode,bytes`.
pub fn sizes(named: &Named) -> Result<HashMap<String, u64>> {
    let text = read(named)?;
    let mut reader = csv::ReaderBuilder::new()
        .has_headers(false)
        .trim(csv::Trim::All)
        .from_reader(text.as_bytes());
    let rows = reader.deserialize();
    rows.collect::<Result<_, _>>()
        .map_err(|error| format!("{}: {error}", named.file.display()).into())
}

fn read(named: &Named) -> Result<String> {
    fs::read_to_string(&named.file)
        .map_err(|error| format!("{}: {error}", named.file.display()).into())
}
