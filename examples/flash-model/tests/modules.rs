//! Modules by name, and values that replace theirs.

use flash_model::{Module, NO_PIN};

#[test]
fn every_module_can_be_used_and_has_a_name_of_its_own() {
    for (at, (name, text, module)) in Module::ALL.iter().enumerate() {
        assert_eq!(module.check(), Ok(()), "{name}");
        assert_eq!(Module::parse(name), Ok(*module));
        for rotation in 0..4 {
            let module = Module {
                rotation,
                ..*module
            };
            let ((left, top), (width, height)) = (module.origin(), module.size());
            let (columns, rows) = module.memory_size();
            assert!(left + width <= columns && top + height <= rows, "{name}");
        }
        let others = &Module::ALL[..at];
        assert!(
            others
                .iter()
                .all(|(other, other_text, _)| other != name && other_text != text)
        );
    }
}

/// Offsets as the makers' and other drivers state them, for each rotation: the controller counts from both sides.
#[test]
fn a_smaller_glass_begins_at_its_place_in_all_rotations() {
    let origins = |name: &str| {
        let module = Module::parse(name).unwrap();
        [0, 1, 2, 3].map(|rotation| Module { rotation, ..module }.origin())
    };
    assert_eq!(origins("st7789"), [(0, 0), (0, 0), (0, 80), (80, 0)]);
    let wanted = [(52, 40), (40, 53), (53, 40), (40, 52)];
    assert_eq!(origins("st7789-135x240"), wanted);
    assert_eq!(origins("st7735-128x160"), [(2, 1), (1, 2), (2, 1), (1, 2)]);
    assert_eq!(origins("ili9341"), [(0, 0); 4]);
}

#[test]
fn single_values_can_be_different() {
    let module =
        Module::parse("pico-display,rotation=3,light=none,offset=53x40,hz=20000000").unwrap();
    assert_eq!((module.rotation, module.pins.light), (3, NO_PIN));
    assert_eq!((module.offset, module.clock_hz), ([53, 40], 20_000_000));
    assert_eq!(module.size(), (240, 135));
}

/// The playground's page has the same modules in the same order.
#[test]
fn the_page_lists_all_modules() {
    let page = include_str!("../../playground/page/index.html");
    let list = page.split("<select id=\"panel\">").nth(1).unwrap();
    let list = list.split("</select>").next().unwrap();
    let options: Vec<_> = list.split("<option ").skip(1).map(str::trim).collect();
    let modules = Module::ALL.iter().enumerate();
    let wanted: Vec<_> = modules
        .map(|(at, (_, text, _))| format!("value=\"{at}\">{text}"))
        .collect();
    assert_eq!(options, wanted);
}

#[test]
fn what_cannot_be_used_is_refused_with_its_reason() {
    for (text, reason) in [
        (
            "st7788",
            "there is no module st7788: there are st7789, ili9341, ",
        ),
        ("st7789,rotation", "rotation is not of the form name=value"),
        ("st7789,turn=1", "nothing is named turn: size, "),
        ("st7789,size=240", "240 is no value for size"),
        ("st7789,rotation=4", "the rotation must be"),
        ("st7789,inverted=2", "must be 1 or 0"),
        ("st7789,mode=1", "the mode of SPI must be 0 or 3"),
        ("st7789,hz=70000000", "the bus must have"),
        ("st7789,offset=1x0", "the glass must lie in"),
        ("ili9488,size=319x479", "the glass must lie in"),
        ("st7789,dc=none", "clock, data and DC must be wired"),
        ("st7789,dc=25", "no pin GP25"),
        ("st7789,dc=17", "two wires go to GP17"),
        (
            "st7789,clock=17,cs=none",
            "GP17 cannot be the clock: GP2, 6, 18 and 22",
        ),
        (
            "st7789,data=11",
            "GP11 cannot be the data: the clock GP18 belongs to SPI 0, so GP3, 7 and 19 can",
        ),
        (
            "pico-lcd-1.3,data=19",
            "belongs to SPI 1, so GP11, 15 and 27 can",
        ),
        ("st7789,cs=none,reset=none", "either CS or the reset"),
    ] {
        let error = Module::parse(text).unwrap_err();
        assert!(error.contains(reason), "{text}: {error}");
    }
    // Other wires of one block can.
    assert!(Module::parse("st7789,clock=2,data=7,dc=4,cs=5,reset=6,light=22").is_ok());
}
