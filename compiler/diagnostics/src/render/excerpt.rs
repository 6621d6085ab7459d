//! The part of a text that a message shows.
//!
//! codespan-reporting prints whole lines, and visits every line of a span. Texts come from anywhere, so it is not
//! given the text but an excerpt of it: the lines that labels touch, of a long span its first and last lines, and of
//! a long line the surroundings of its labels. Characters that would move a terminal's cursor or reorder the line are
//! replaced by ones that can be seen.

use crate::SourceFile;
use codespan_reporting::files::{Error, Files};
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

/// Lines of up to so many characters are shown whole.
const WHOLE_LINE: usize = 160;
/// Of longer lines, so many characters are shown before and after a label …
const AROUND_LABEL: usize = 40;
/// … and at most so many of the label itself.
const OF_LABEL: usize = 60;
/// How many lines codespan shows after the first line of a span, and before its last.
pub const LINES_AFTER_START: usize = 3;
pub const LINES_BEFORE_END: usize = 1;

/// What is shown of one text.
pub struct Excerpt {
    name: String,
    text: String,
    lines: Vec<Line>,
    /// The columns in the text itself of the places that labels start at.
    columns: BTreeMap<usize, usize>,
}

/// A line of the excerpt; a gap is two empty ones, which codespan draws as a break.
struct Line {
    number: usize,
    range: Range<usize>,
}

impl Excerpt {
    /// What is shown for these places of a text, and where they lie in it.
    pub fn new(file: &SourceFile, places: &[Range<usize>]) -> (Excerpt, Vec<Range<usize>>) {
        let places: Vec<Range<usize>> = places.iter().map(|place| without_line_ends(file, place)).collect();
        let mut excerpt =
            Excerpt { name: visible(&file.name), text: String::new(), lines: Vec::new(), columns: BTreeMap::new() };
        let points: Vec<Vec<Range<usize>>> = places.iter().map(|place| points(file, place)).collect();
        // For each byte of the text that is shown, where it is shown.
        let mut shown = BTreeMap::new();
        let mut previous: Option<usize> = None;
        for line in lines_of(file, &places) {
            if let Some(previous) = previous {
                let (from, to) = (file.line_number(previous), file.line_number(line));
                match to.saturating_sub(from) {
                    0 | 1 => {}
                    // codespan shows a single line between two others, if it is at hand.
                    2 if line - previous == 2 => excerpt.push_line(file, previous + 1, &[], &mut shown),
                    _ => excerpt.push_gap(from + 1),
                }
            }
            let range = file.line(line);
            let on_line: Vec<Range<usize>> = points
                .iter()
                .flatten()
                .filter(|point| range.start <= point.start && point.end <= range.end)
                .cloned()
                .collect();
            excerpt.push_line(file, line, &on_line, &mut shown);
            previous = Some(line);
        }
        let place_of = |byte: usize| shown.range(..=byte).next_back().map_or(0, |(_, at)| *at);
        let shown_places: Vec<Range<usize>> = places.iter().map(|p| place_of(p.start)..place_of(p.end)).collect();
        for (place, shown) in places.iter().zip(&shown_places) {
            excerpt.columns.insert(shown.start, file.position(place.start).column);
        }
        (excerpt, shown_places)
    }

    fn push_line(
        &mut self,
        file: &SourceFile,
        line: usize,
        places: &[Range<usize>],
        shown: &mut BTreeMap<usize, usize>,
    ) {
        let range = file.line(line);
        let start = self.text.len();
        let mut end_of_last = range.start;
        for part in parts(&file.text, range.clone(), places) {
            if part.start > end_of_last {
                self.text.push('…');
            }
            for (byte, character) in file.text[part.clone()].char_indices() {
                shown.insert(part.start + byte, self.text.len());
                self.text.push(visible_character(character));
            }
            shown.insert(part.end, self.text.len());
            end_of_last = part.end;
        }
        if end_of_last < range.end {
            self.text.push('…');
        }
        self.lines.push(Line { number: file.line_number(line), range: start..self.text.len() + 1 });
        self.text.push('\n');
    }

    fn push_gap(&mut self, number: usize) {
        for _ in 0..2 {
            let start = self.text.len();
            self.text.push('\n');
            self.lines.push(Line { number, range: start..start + 1 });
        }
    }

    fn line_at(&self, byte: usize) -> usize {
        self.lines.partition_point(|line| line.range.start <= byte).saturating_sub(1)
    }
}

/// A place that stops before the line end it would otherwise underline.
fn without_line_ends(file: &SourceFile, place: &Range<usize>) -> Range<usize> {
    let first = file.line(file.line_of(place.start));
    let start = place.start.min(first.end);
    let mut end = place.end.max(start);
    if end > start {
        let last = file.line_of(end);
        let line = file.line(last);
        end = if end == line.start && last > 0 { file.line(last - 1).end } else { end.min(line.end) };
        end = end.max(start);
    }
    start..end
}

/// The lines to show: those of a place, or the first and last ones of a long place.
fn lines_of(file: &SourceFile, places: &[Range<usize>]) -> BTreeSet<usize> {
    let mut lines = BTreeSet::new();
    for place in places {
        let (first, last) = (file.line_of(place.start), file.line_of(place.end));
        lines.extend(first..=last.min(first + LINES_AFTER_START));
        lines.extend(last.saturating_sub(LINES_BEFORE_END).max(first)..=last);
    }
    lines
}

/// The parts of a place that must be seen: itself within one line, else its ends.
fn points(file: &SourceFile, place: &Range<usize>) -> Vec<Range<usize>> {
    if file.line_of(place.start) == file.line_of(place.end) {
        vec![place.clone()]
    } else {
        vec![place.start..place.start, place.end..place.end]
    }
}

/// The parts of a line to show: all of a short one, else the surroundings of its labels.
fn parts(text: &str, line: Range<usize>, places: &[Range<usize>]) -> Vec<Range<usize>> {
    let forward = |from: usize, count: usize| {
        text[from..line.end].char_indices().nth(count).map_or(line.end, |(byte, _)| from + byte)
    };
    let back = |from: usize, count: usize| {
        let characters = text[line.start..from].char_indices().rev();
        characters.take(count).last().map_or(from, |(byte, _)| line.start + byte)
    };
    let first = line.start..forward(line.start, WHOLE_LINE);
    if first.end == line.end || places.is_empty() {
        return vec![first];
    }
    let mut wanted: Vec<Range<usize>> = places
        .iter()
        .map(|place| {
            let cut = forward(place.start, OF_LABEL);
            let end = if place.end <= cut { forward(place.end, AROUND_LABEL) } else { cut };
            back(place.start, AROUND_LABEL)..end
        })
        .collect();
    wanted.sort_by_key(|part| (part.start, part.end));
    let mut parts: Vec<Range<usize>> = Vec::new();
    for part in wanted {
        match parts.last_mut() {
            Some(last) if part.start <= last.end => last.end = last.end.max(part.end),
            Some(_) | None => parts.push(part),
        }
    }
    parts
}

/// A text of one line that leaves the terminal as it was.
pub fn visible(text: &str) -> String {
    text.chars().map(|c| if c == '\n' { ' ' } else { visible_character(c) }).map(tab_as_blank).collect()
}

/// The same, with its lines kept.
pub fn visible_lines(text: &str) -> String {
    text.chars().map(|c| if c == '\n' { c } else { visible_character(c) }).map(tab_as_blank).collect()
}

fn tab_as_blank(character: char) -> char {
    if character == '\t' { ' ' } else { character }
}

/// Control characters as their pictures; marks without width, and those that change the direction of writing, as the
/// replacement character. codespan expands tabs.
fn visible_character(character: char) -> char {
    match character {
        '\t' => character,
        '\0'..='\x1F' => char::from_u32(0x2400 + character as u32).unwrap_or('\u{FFFD}'),
        '\x7F' => '\u{2421}',
        '\u{80}'..='\u{9F}'
        | '\u{AD}'
        | '\u{61C}'
        | '\u{200B}'..='\u{200F}'
        | '\u{2028}'..='\u{202E}'
        | '\u{2060}'..='\u{206F}'
        | '\u{FEFF}' => '\u{FFFD}',
        _ => character,
    }
}

/// The excerpts of one message, numbered in the order in which its labels name their texts.
pub struct Excerpts(pub Vec<Excerpt>);

impl Excerpts {
    fn at(&self, id: usize) -> Result<&Excerpt, Error> {
        self.0.get(id).ok_or(Error::FileMissing)
    }
}

impl<'a> Files<'a> for Excerpts {
    type FileId = usize;
    type Name = &'a str;
    type Source = &'a str;

    fn name(&'a self, id: usize) -> Result<&'a str, Error> {
        Ok(&self.at(id)?.name)
    }

    fn source(&'a self, id: usize) -> Result<&'a str, Error> {
        Ok(&self.at(id)?.text)
    }

    fn line_index(&'a self, id: usize, byte: usize) -> Result<usize, Error> {
        Ok(self.at(id)?.line_at(byte))
    }

    fn line_number(&'a self, id: usize, line: usize) -> Result<usize, Error> {
        let lines = &self.at(id)?.lines;
        lines.get(line).map(|line| line.number).ok_or(Error::LineTooLarge { given: line, max: lines.len() })
    }

    fn column_number(&'a self, id: usize, _line: usize, byte: usize) -> Result<usize, Error> {
        Ok(self.at(id)?.columns.get(&byte).copied().unwrap_or(1))
    }

    fn line_range(&'a self, id: usize, line: usize) -> Result<Range<usize>, Error> {
        let lines = &self.at(id)?.lines;
        lines.get(line).map(|line| line.range.clone()).ok_or(Error::LineTooLarge { given: line, max: lines.len() })
    }
}
