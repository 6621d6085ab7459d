//! How wide a text is: by the widths of the embedded font, which are those of Liberation Sans, Arial and Helvetica.

use std::sync::LazyLock;
use ttf_parser::Face;

/// The font, as a file of TrueType; its licence lies beside it.
pub const FILE: &[u8] = include_bytes!("../font/grafc-sans.ttf");
/// The name of its family.
pub const FAMILY: &str = "Grafc Sans";

/// The size of most texts.
pub const TEXT: i32 = 13;
/// The size of the labels of steps.
pub const LABEL: i32 = 14;
/// The size of comments.
pub const COMMENT: i32 = 11;

static FACE: LazyLock<Face<'static>> = LazyLock::new(|| Face::parse(FILE, 0).expect("the embedded font is one"));

/// Whether the embedded font has this character; if not, a box stands for it in PDF and PNG.
pub fn has(character: char) -> bool {
    FACE.glyph_index(character).is_some()
}

/// What is shown of a text: characters that would end up elsewhere, or nowhere, are shown as one that has a place.
pub fn shown(text: &str) -> String {
    let harmless = |c: char| match c {
        '\n' | '\t' | '\r' => ' ',
        c if c.is_control() || is_invisible(c) => '\u{fffd}',
        c => c,
    };
    text.chars().map(harmless).collect()
}

/// Marks that turn the direction of what follows, or take no room.
fn is_invisible(c: char) -> bool {
    matches!(c, '\u{61c}' | '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2060}'..='\u{206f}' | '\u{feff}'
        | '\u{fffe}' | '\u{ffff}')
}

/// The width of a text, rounded up.
pub fn width(text: &str, size: i32) -> i32 {
    pixels(units(text), size) + 1
}

/// A text in lines no wider than `most`, as far as it has blanks to be broken at.
pub(crate) fn wrapped(text: &str, size: i32, most: i32) -> Vec<String> {
    // A blank is a little more than a quarter of the size.
    const BLANK: i32 = 3;
    let mut lines: Vec<(String, i64)> = Vec::new();
    for word in text.split_whitespace() {
        match lines.last_mut() {
            Some((line, wide)) if pixels(*wide, size) + 1 + width(word, size) + BLANK <= most => {
                line.push(' ');
                line.push_str(word);
                *wide += units(" ") + units(word);
            }
            Some(_) | None => lines.push((word.to_string(), units(word))),
        }
    }
    lines.into_iter().map(|(line, _)| line).collect()
}

/// The width of a text in units of the font, which can be added.
pub(crate) fn units(text: &str) -> i64 {
    text.chars().map(|c| i64::from(advance(c))).sum()
}

/// Such units at a size, rounded down.
pub(crate) fn pixels(units: i64, size: i32) -> i32 {
    i32::try_from((units * i64::from(size)).div_euclid(i64::from(FACE.units_per_em()))).unwrap_or(i32::MAX / 8)
}

/// What a character takes; one that the font lacks takes as much as it is high.
fn advance(c: char) -> u16 {
    let glyph = FACE.glyph_index(c);
    glyph.and_then(|glyph| FACE.glyph_hor_advance(glyph)).unwrap_or_else(|| FACE.units_per_em())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn widths_are_those_of_helvetica() {
        // In thousandths of the size: A 667, i 222, 0 556, the arrow upwards 500 of 1000 rounded by the em of 2048.
        assert_eq!(width("A", 1000), 667);
        assert_eq!(width("i", 1000), 223);
        assert_eq!(width("00", 1000), 1113);
    }

    #[test]
    fn the_signs_of_conditions_are_there() {
        for c in "·+↑↓⊕≤≥≠×¬«»“”\u{fffd}".chars().filter(|c| *c != '\u{fffd}') {
            assert!(has(c), "{c}");
        }
    }
}
