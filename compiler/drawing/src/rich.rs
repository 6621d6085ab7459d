//! A text with lines over parts of it, broken into lines where operators are.

use crate::font::{TEXT, pixels, units, width};
use crate::picture::{Anchor, Shape, Style};
use grafc_layout::Point;

/// A part of a text.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) struct Token {
    pub text: String,
    /// The lines over it, the lowest bit for the lowest one.
    pub over: u8,
    /// Whether a new line may begin with it.
    pub may_break: bool,
}

impl Token {
    pub(crate) fn plain(text: impl Into<String>) -> Token {
        Token { text: text.into(), over: 0, may_break: false }
    }
}

/// From one line to the next.
pub(crate) const LINE: i32 = 17;
/// The letters reach so far above the baseline and below it.
pub(crate) const ASCENT: i32 = 11;
pub(crate) const DESCENT: i32 = 4;
/// From one line over a text to the next, and from the letters to the first.
const OVER: i32 = 3;

/// A text that has been broken into lines.
#[derive(Clone, Debug, Default)]
pub(crate) struct Rich {
    lines: Vec<Vec<Token>>,
    /// The widest line.
    pub width: i32,
    /// The lines over the first line of text.
    over: i32,
    /// From one line of text to the next.
    step: i32,
}

impl Rich {
    /// Broken where it may be, so that it is not wider than `most` if that can be.
    pub(crate) fn new(tokens: Vec<Token>, most: i32) -> Rich {
        let mut lines: Vec<Vec<Token>> = vec![Vec::new()];
        let mut at = 0;
        // A part that cannot be broken goes to the next line as a whole.
        let mut parts: Vec<Vec<Token>> = Vec::new();
        for token in tokens {
            match parts.last_mut() {
                Some(part) if !token.may_break => part.push(token),
                Some(_) | None => parts.push(vec![token]),
            }
        }
        for part in parts {
            let wide: i32 = width(&part.iter().map(|token| token.text.as_str()).collect::<String>(), TEXT);
            if at > 0 && at + wide > most {
                lines.push(Vec::new());
                at = 0;
            }
            at += wide;
            if let Some(line) = lines.last_mut() {
                line.extend(part);
            }
        }
        let widths = lines.iter().map(|line| line_width(line));
        let levels =
            |line: &Vec<Token>| line.iter().map(|token| 8 - token.over.leading_zeros() as i32).max().unwrap_or(0);
        let most_over = lines.iter().map(levels).max().unwrap_or(0);
        Rich {
            width: widths.max().unwrap_or(0),
            over: OVER * lines.first().map_or(0, levels),
            step: LINE + OVER * (most_over - 1).max(0),
            lines,
        }
    }

    /// From the top of the first line to the bottom of the last.
    pub(crate) fn height(&self) -> i32 {
        self.over + ASCENT + DESCENT + self.step * (self.lines.len() as i32 - 1)
    }

    /// The shapes, with the upper left corner at a place.
    pub(crate) fn shapes(&self, left: i32, top: i32, class: &'static str) -> Vec<Shape> {
        let mut shapes = Vec::new();
        let mut overlines: Vec<Vec<Point>> = Vec::new();
        for (number, line) in self.lines.iter().enumerate() {
            let baseline = top + self.over + ASCENT + self.step * number as i32;
            let text: String = line.iter().map(|token| token.text.as_str()).collect();
            if !text.trim().is_empty() {
                // What is over a part must be there whatever the font of a viewer: parts have their own places.
                let is_plain = line.iter().all(|token| token.over == 0);
                for (start, text) in if is_plain { vec![(0, text)] } else { runs(line) } {
                    shapes.push(Shape::text((left + start, baseline), Anchor::Start, class, TEXT, text));
                }
            }
            for level in 0..8 {
                for (from, to) in covered(line, level) {
                    let y = baseline - ASCENT - OVER * i32::from(level);
                    overlines.push(vec![Point { x: left + from, y }, Point { x: left + to, y }]);
                }
            }
        }
        if !overlines.is_empty() {
            shapes.push(Shape::Path { lines: overlines, closed: false, style: Style::Line });
        }
        shapes
    }
}

fn line_width(line: &[Token]) -> i32 {
    width(&line.iter().map(|token| token.text.as_str()).collect::<String>(), TEXT)
}

/// Parts of a line with equal lines over them, and where each begins.
fn runs(line: &[Token]) -> Vec<(i32, String)> {
    let mut found: Vec<(i64, u8, String)> = Vec::new();
    let mut before = 0;
    for token in line {
        match found.last_mut() {
            Some((_, over, text)) if *over == token.over => text.push_str(&token.text),
            Some(_) | None => found.push((before, token.over, token.text.clone())),
        }
        before += units(&token.text);
    }
    // Blanks at the ends of a text are not drawn.
    let trimmed = found.into_iter().map(|(start, _, text)| {
        let blanks = text.len() - text.trim_start().len();
        (pixels(start + units(&text[..blanks]), TEXT), text.trim().to_string())
    });
    trimmed.filter(|(_, text)| !text.is_empty()).collect()
}

/// Where a line over parts begins and ends.
fn covered(line: &[Token], level: u8) -> Vec<(i32, i32)> {
    let mut found = Vec::new();
    let (mut begin, mut before) = (None, 0);
    for token in line {
        let is_over = token.over & (1 << level) != 0;
        match begin {
            None if is_over => begin = Some(pixels(before, TEXT)),
            Some(start) if !is_over => {
                found.push((start, pixels(before, TEXT)));
                begin = None;
            }
            None | Some(_) => {}
        }
        before += units(&token.text);
    }
    found.extend(begin.map(|start| (start, pixels(before, TEXT))));
    found
}
