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
const OVER: i32 = 4;
const TO_OVER: i32 = 2;
/// A line over one narrow letter is wider than that.
const LEAST_OVER: i32 = 8;

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
    /// Broken where it may be, so that it is not wider than `most` if that can be; never under a line, which would look
    /// like several then, so that what is negated and wider than that is written `¬( )`.
    pub(crate) fn new(tokens: Vec<Token>, most: i32) -> Rich {
        let tokens = with_signs(tokens, most);
        let mut lines: Vec<Vec<Token>> = vec![Vec::new()];
        let mut at = 0;
        // A part that cannot be broken goes to the next line as a whole.
        let mut parts: Vec<Vec<Token>> = Vec::new();
        for token in tokens {
            match parts.last_mut() {
                Some(part) if !token.may_break || token.over != 0 => part.push(token),
                Some(_) | None => parts.push(vec![token]),
            }
        }
        for mut part in parts {
            let wide: i32 = width(&part.iter().map(|token| token.text.as_str()).collect::<String>(), TEXT);
            if at > 0 && at + wide > most {
                lines.push(Vec::new());
                at = 0;
                // No blank begins a line.
                part[0].text = part[0].text.trim_start().to_string();
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
            over: lines.first().map_or(0, |line| room(levels(line))),
            step: LINE + (room(most_over) - TO_OVER).max(0),
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
                    let y = baseline - ASCENT - TO_OVER - OVER * i32::from(level);
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

/// The room that so many lines over a text take.
fn room(levels: i32) -> i32 {
    if levels == 0 { 0 } else { TO_OVER + OVER * (levels - 1) + 1 }
}

/// With `¬( )` in place of each line that would be wider than `most`, the uppermost ones first.
fn with_signs(mut tokens: Vec<Token>, most: i32) -> Vec<Token> {
    for bit in (0..8).rev().map(|level| 1 << level) {
        let mut out: Vec<Token> = Vec::with_capacity(tokens.len());
        let mut rest = tokens.into_iter().peekable();
        while let Some(token) = rest.next() {
            if token.over & bit == 0 {
                out.push(token);
                continue;
            }
            let mut run = vec![token];
            while let Some(token) = rest.next_if(|token| token.over & bit != 0) {
                run.push(token);
            }
            if line_width(&run) > most {
                run.iter_mut().for_each(|token| token.over &= !bit);
                let sign = |text: &str, over: u8| Token { over, ..Token::plain(text) };
                let (first, last) = (run[0].over, run[run.len() - 1].over);
                // A line within may not reach over the signs.
                let outer = !(bit - 1);
                run.insert(0, sign("¬(", first & outer));
                run.push(sign(")", last & outer));
            }
            out.append(&mut run);
        }
        tokens = out;
    }
    tokens
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
                found.push(wide_enough(start, pixels(before, TEXT)));
                begin = None;
            }
            None | Some(_) => {}
        }
        before += units(&token.text);
    }
    found.extend(begin.map(|start| wide_enough(start, pixels(before, TEXT))));
    found
}

/// A line reaches a little beyond what it is over, and can be seen.
fn wide_enough(start: i32, end: i32) -> (i32, i32) {
    let more = (LEAST_OVER - (end - start) + 1).max(2) / 2;
    (start - more, end + more)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn token(text: &str, over: u8, may_break: bool) -> Token {
        Token { text: text.into(), over, may_break }
    }

    /// Texts and overlines, in order.
    fn drawn(tokens: Vec<Token>, most: i32) -> (Vec<String>, Vec<Vec<Point>>) {
        let (mut texts, mut overlines) = (Vec::new(), Vec::new());
        for shape in Rich::new(tokens, most).shapes(0, 0, "condition") {
            match shape {
                Shape::Text { text, .. } => texts.push(text),
                Shape::Path { lines, .. } => overlines.extend(lines),
                Shape::Rect { .. } | Shape::Dot { .. } => panic!("only texts and lines"),
            }
        }
        (texts, overlines)
    }

    #[test]
    fn a_line_over_a_text_is_never_broken() {
        // What is negated is wider than the place for it, and what is outside of it may be broken.
        let long = "a_name_of_some_length";
        let negated = || vec![token(long, 1, false), token(" · ", 1, true), token(long, 1, false)];
        let mut tokens = vec![token("a", 0, false), token(" + ", 0, true)];
        tokens.extend(negated());
        let (texts, overlines) = drawn(tokens.clone(), 2 * width(long, TEXT) + 40);
        assert_eq!(overlines.len(), 1);
        assert!(texts.contains(&format!("{long} · {long}")), "{texts:?}");
        let (texts, overlines) = drawn(tokens, width(long, TEXT) + 30);
        assert_eq!(overlines, Vec::<Vec<Point>>::new());
        assert_eq!(texts, ["a".to_string(), format!("+ ¬({long}"), format!("· {long})")]);
    }

    #[test]
    fn a_line_over_one_letter_can_be_seen() {
        for text in ["f", "i", "j", "a", "W"] {
            let (_, overlines) = drawn(vec![token(text, 1, false)], 100);
            let (from, to) = (overlines[0][0], overlines[0][1]);
            // As wide as the letter and one more on each side; clear of the letters, which are 10 high.
            assert!(to.x - from.x >= 8.max(width(text, TEXT) + 1), "{text}");
            assert!(from.x <= -1 && to.x >= width(text, TEXT));
            let Shape::Text { at, .. } = &Rich::new(vec![token(text, 1, false)], 100).shapes(0, 0, "condition")[0]
            else {
                panic!("a text")
            };
            assert!(at.y - from.y >= 13, "{text}");
        }
    }

    #[test]
    fn two_lines_side_by_side_stay_apart() {
        let (_, overlines) = drawn(vec![token("i", 1, false), token(" · ", 0, true), token("j", 1, false)], 100);
        assert!(overlines[1][0].x - overlines[0][1].x >= 4, "{overlines:?}");
    }
}
