//! Draws the pictures of flash.md: the wires from a Pico to each kind of module, with the pins of the modules' records.
//!
//! `FIXEL_RENEW=1 cargo test --test wiring` writes the drawings.

use std::fmt::Write;
use std::fs;

use flash_model::Module;

/// Where the pads of the two boards begin, from left to right.
const PICO: i32 = 132;
const MODULE: i32 = 272;
const WIDTH: i32 = 400;
const HEIGHT: i32 = 372;
/// The right edge of a Pico has pin 40 at the top and pin 21 at the bottom.
const FIRST_PIN: i32 = 40;
const PICO_PITCH: i32 = 16;

/// A wire: its color, and the name and number of its pin on the Pico.
struct Wire {
    color: &'static str,
    name: String,
    pin: i32,
}

fn wire(color: &'static str, gpio: u32) -> Option<Wire> {
    let pin = match gpio {
        16 | 17 => gpio + 5,
        18..=21 => gpio + 6,
        _ => panic!("GP{gpio} is not drawn"),
    };
    Some(Wire {
        color,
        name: format!("GP{gpio}"),
        pin: pin.cast_signed(),
    })
}

fn supply(color: &'static str, name: &str, pin: i32) -> Option<Wire> {
    Some(Wire {
        color,
        name: name.into(),
        pin,
    })
}

/// The wire to a pin of a module, by the name that is printed there. Other pins have none.
fn wire_of(module: &Module, label: &str) -> Option<Wire> {
    let pins = module.pins;
    match label {
        "GND" => supply("#333333", "GND", 38),
        "VCC" => supply("#d32f2f", "3V3", 36),
        "SCL" | "SCK" => wire("#c77700", pins.clock),
        "SDA" | "SDI (MOSI)" => wire("#2e7d32", pins.data),
        "RES" | "RESET" => wire("#7b3fb5", pins.reset),
        "DC" => wire("#1565c0", pins.dc),
        "CS" => wire("#d81b78", pins.cs),
        "BLK" | "LED" => wire("#00838f", pins.light),
        _ => None,
    }
}

/// A drawing of a module with these pins, from the top down.
fn drawing(module: &Module, title: &str, color: &str, labels: &[&str]) -> String {
    let mut svg = format!(
        r##"<svg xmlns="http://www.w3.org/2000/svg" width="{WIDTH}" height="{HEIGHT}" viewBox="0 0 {WIDTH} {HEIGHT}">
<rect x="1" y="1" width="{}" height="{}" rx="8" fill="#fafafa" stroke="#9e9e9e"/>
<g font-family="DejaVu Sans, Verdana, sans-serif" font-size="12">
<text x="{}" y="20" text-anchor="middle" font-weight="bold" fill="#333333">{title}</text>
<rect x="12" y="38" width="{}" height="326" rx="6" fill="#1b5e3a"/>
<rect x="48" y="30" width="44" height="28" rx="3" fill="#bdbdbd"/>
<text x="70" y="48" text-anchor="middle" font-size="11" fill="#333333">USB</text>
<circle cx="34" cy="82" r="7" fill="#eeeeee"/>
<text x="22" y="200" font-size="14" font-weight="bold" fill="#ffffff">Pico</text>
<text x="22" y="217" font-size="11" fill="#ffffff">or Pico 2</text>
<rect x="{}" y="38" width="{}" height="326" rx="6" fill="{color}"/>
"##,
        WIDTH - 2,
        HEIGHT - 2,
        WIDTH / 2,
        PICO - 6,
        MODULE - 6,
        WIDTH - MODULE - 6,
    );
    let y_of_pin = |pin: i32| 48 + (FIRST_PIN - pin) * PICO_PITCH;
    let pitch = (320 / i32::try_from(labels.len()).unwrap()).min(36);
    let count = i32::try_from(labels.len()).unwrap();
    let y_of_label = |at: i32| 201 + pitch * (2 * at + 1 - count) / 2;
    let mut wires = String::new();
    for pin in 21..=FIRST_PIN {
        let y = y_of_pin(pin);
        writeln!(
            svg,
            r##"<circle cx="{PICO}" cy="{y}" r="4" fill="#d7b258"/>"##
        )
        .unwrap();
    }
    for (at, label) in (0..).zip(labels) {
        let (y, wire) = (y_of_label(at), wire_of(module, label));
        let (pad, ink) = if wire.is_some() {
            ("#d7b258", "#ffffff")
        } else {
            ("#8d8d8d", "#f3b8b8")
        };
        let (x, baseline) = (MODULE + 10, y + 4);
        writeln!(
            svg,
            r##"<circle cx="{MODULE}" cy="{y}" r="4" fill="{pad}"/>"##
        )
        .unwrap();
        writeln!(
            svg,
            r##"<text x="{x}" y="{baseline}" fill="{ink}">{label}</text>"##
        )
        .unwrap();
        let Some(wire) = wire else { continue };
        let (from, middle) = (y_of_pin(wire.pin), i32::midpoint(PICO, MODULE));
        let path = format!("M{PICO} {from}C{middle} {from} {middle} {y} {MODULE} {y}");
        for (width, color) in [(6, "#fafafa"), (3, wire.color)] {
            writeln!(
                wires,
                r##"<path d="{path}" fill="none" stroke="{color}" stroke-width="{width}"/>"##
            )
            .unwrap();
        }
        let (x, baseline) = (PICO - 10, from + 4);
        writeln!(
            svg,
            r##"<text x="{x}" y="{baseline}" text-anchor="end" fill="#ffffff">{} · {}</text>"##,
            wire.name, wire.pin
        )
        .unwrap();
    }
    svg + &wires + "</g>\n</svg>\n"
}

#[test]
fn drawings_have_the_pins_of_the_records() {
    let with_cs = ["GND", "VCC", "SCL", "SDA", "RES", "DC", "CS", "BLK"];
    let without = ["GND", "VCC", "SCL", "SDA", "RES", "DC", "BLK"];
    let touch = [
        "VCC",
        "GND",
        "CS",
        "RESET",
        "DC",
        "SDI (MOSI)",
        "SCK",
        "LED",
        "SDO (MISO)",
        "T_CLK",
        "T_CS",
        "T_DIN",
        "T_DO",
        "T_IRQ",
    ];
    let no_cs = Module::ALL
        .iter()
        .find(|(name, ..)| *name == "st7789-no-cs");
    let drawings = [
        (
            "8-pins",
            drawing(&Module::ST7789, "8 pins, with CS", "#1a3a5c", &with_cs),
        ),
        (
            "7-pins",
            drawing(&no_cs.unwrap().2, "7 pins, without CS", "#1a3a5c", &without),
        ),
        (
            "touch",
            drawing(
                &Module::ILI9341,
                "14 pins, with touch: no wires to the dim pins",
                "#8e1c1c",
                &touch,
            ),
        ),
    ];
    for (name, drawing) in drawings {
        let path = format!("{}/wires/{name}.svg", env!("CARGO_MANIFEST_DIR"));
        if std::env::var_os("FIXEL_RENEW").is_some() {
            fs::write(&path, &drawing).unwrap();
        }
        let kept = fs::read_to_string(&path).unwrap_or_default();
        assert!(
            kept == drawing,
            "{name}.svg is another drawing: FIXEL_RENEW=1 writes it"
        );
    }
}
