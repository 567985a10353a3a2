//! Formulas of the guide in MathML, which browsers show without a script.

/// Writes formulas next to each other, or below each other if the page is narrow. Each formula is in braces:
/// `formula!({x^2 = frac(1)(w[0])} {…})`. They have the style of a separate line, in which fractions have their full
/// size.
macro_rules! formula {
    ($({ $($math:tt)+ })+) => {
        concat!(
            "\n\n<div style=\"margin: 0 0 .75em 1.5em\">",
            $("<math displaystyle=\"true\" style=\"padding: .2em 0\">", math!($($math)+), "</math>&emsp; ",)+
            "</div>\n\n"
        )
    };
}

/// Writes a formula as MathML. A name of one letter is set in italics, as a variable; a longer name is set upright.
macro_rules! math {
    () => {
        ""
    };
    ($base:tt ^ $power:tt $($rest:tt)*) => {
        concat!("<msup>", math!($base), math!($power), "</msup>", math!($($rest)*))
    };
    ($base:ident [$($index:tt)+] $($rest:tt)*) => {
        concat!("<msub>", math!($base), "<mrow>", math!($($index)+), "</mrow></msub>", math!($($rest)*))
    };
    (frac($($above:tt)+)($($below:tt)+) $($rest:tt)*) => {
        concat!(
            "<mfrac><mrow>",
            math!($($above)+),
            "</mrow><mrow>",
            math!($($below)+),
            "</mrow></mfrac>",
            math!($($rest)*)
        )
    };
    (sqrt($($of:tt)+) $($rest:tt)*) => {
        concat!("<msqrt>", math!($($of)+), "</msqrt>", math!($($rest)*))
    };
    (prime($($of:tt)+) $($rest:tt)*) => {
        concat!(math!($($of)+), "<mo lspace=\"0\" rspace=\"0\">′</mo>", math!($($rest)*))
    };
    (dotted($($of:tt)+) $($rest:tt)*) => {
        concat!("<mover>", math!($($of)+), "<mo>˙</mo></mover>", math!($($rest)*))
    };
    (twice_dotted($($of:tt)+) $($rest:tt)*) => {
        concat!("<mover>", math!($($of)+), "<mo>¨</mo></mover>", math!($($rest)*))
    };
    (matrix($($([$($entry:tt)+])+);+) $($rest:tt)*) => {
        concat!(
            "<mrow><mo>(</mo><mtable displaystyle=\"true\">",
            $("<mtr>", $("<mtd>", math!($($entry)+), "</mtd>",)+ "</mtr>",)+
            "</mtable><mo>)</mo></mrow>",
            math!($($rest)*)
        )
    };
    // A variable with a Greek name. It is a string, because Rust warns about Greek letters that look like Latin
    // letters.
    (var $letter:literal $($rest:tt)*) => {
        concat!("<mi>", $letter, "</mi>", math!($($rest)*))
    };
    // A function with its argument, such as `fun sin φ`.
    (fun $name:ident $($rest:tt)*) => {
        concat!("<mspace width=\".2em\"/><mi>", stringify!($name), "</mi><mspace width=\".2em\"/>", math!($($rest)*))
    };
    (($($inner:tt)+) $($rest:tt)*) => {
        concat!("<mrow><mo>(</mo>", math!($($inner)+), "<mo>)</mo></mrow>", math!($($rest)*))
    };
    ({ $($inner:tt)+ } $($rest:tt)*) => {
        concat!("<mrow>", math!($($inner)+), "</mrow>", math!($($rest)*))
    };
    (- $($rest:tt)*) => {
        concat!("<mo>−</mo>", math!($($rest)*))
    };
    (dot $($rest:tt)*) => {
        concat!("<mo>·</mo>", math!($($rest)*))
    };
    (times $($rest:tt)*) => {
        concat!("<mo>×</mo>", math!($($rest)*))
    };
    (to $($rest:tt)*) => {
        concat!("<mo>→</mo>", math!($($rest)*))
    };
    (partial $($rest:tt)*) => {
        concat!("<mo>∂</mo>", math!($($rest)*))
    };
    ($number:literal $($rest:tt)*) => {
        concat!("<mn>", $number, "</mn>", math!($($rest)*))
    };
    ($name:ident $($rest:tt)*) => {
        concat!("<mi>", stringify!($name), "</mi>", math!($($rest)*))
    };
    ($operator:tt $($rest:tt)*) => {
        concat!("<mo>", stringify!($operator), "</mo>", math!($($rest)*))
    };
}
