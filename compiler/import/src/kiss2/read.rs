//! Reads a table of KISS2, line by line.

use super::table::{Cube, Row, Table};
use crate::{doubtful, lost};
use grafc_diagnostics::{Code, Diagnostic, Diagnostics, FileId, Span};
use rustc_hash::FxHashMap;

/// After so many errors the rest is hardly a table.
const MOST_ERRORS: usize = 50;

/// The table of a text; what is wrong with it is reported, and then it is of no use.
pub fn read(file: FileId, text: &str, diagnostics: &mut Diagnostics) -> Table {
    let mut reader = Reader {
        file,
        text,
        diagnostics,
        errors: 0,
        table: Table::default(),
        of_name: FxHashMap::default(),
        counts: [None; 2],
        rows_told: None,
        states_told: None,
        reset: None,
        is_over: false,
    };
    let mut at = 0;
    for line in text.split_inclusive('\n') {
        if reader.errors < MOST_ERRORS && !reader.is_over {
            reader.line(at, line);
        }
        at += line.len();
    }
    reader.end();
    reader.table
}

/// A word, and where it stands.
#[derive(Clone, Copy)]
struct Word<'a> {
    text: &'a str,
    span: Span,
}

struct Reader<'a> {
    file: FileId,
    text: &'a str,
    diagnostics: &'a mut Diagnostics,
    errors: usize,
    table: Table,
    of_name: FxHashMap<&'a str, usize>,
    /// How many inputs and outputs there are said to be.
    counts: [Option<usize>; 2],
    /// How many rows, and where.
    rows_told: Option<(usize, Span)>,
    /// How many states, and where.
    states_told: Option<(usize, Span)>,
    reset: Option<Word<'a>>,
    is_over: bool,
}

impl<'a> Reader<'a> {
    fn error(&mut self, span: Span, message: impl Into<String>, help: &str) {
        self.errors += 1;
        self.diagnostics.push(Diagnostic::new(Code::E0707, span, message.into()).help(help));
    }

    fn line(&mut self, at: usize, line: &'a str) {
        // What stands behind `#` is a comment.
        let line = line.split('#').next().unwrap_or_default().trim_start_matches('\u{FEFF}');
        let start = line.as_ptr() as usize - self.text.as_ptr() as usize;
        debug_assert!(start >= at, "a part of the line");
        let words: Vec<Word> = line
            .split_whitespace()
            .map(|text| {
                let begin = text.as_ptr() as usize - self.text.as_ptr() as usize;
                Word { text, span: Span::new(self.file, begin, begin + text.len()) }
            })
            .collect();
        match words.split_first() {
            None => {}
            Some((first, rest)) if first.text.starts_with('.') => self.directive(*first, rest),
            Some(_) => self.row(&words),
        }
    }

    fn directive(&mut self, first: Word<'a>, rest: &[Word<'a>]) {
        match first.text {
            ".i" | ".o" => {
                let which = usize::from(first.text == ".o");
                if self.counts[which].is_some() || !self.table.rows.is_empty() {
                    self.error(
                        first.span,
                        format!("`{}` comes twice, or behind a row", first.text),
                        "say it once, at the top",
                    );
                    return;
                }
                if let Some((count, span)) = self.number(first, rest) {
                    // A row is no longer than the file.
                    if count > self.text.len() {
                        self.error(
                            span,
                            format!("no row has {count} columns"),
                            "say how many inputs, or outputs, a row has",
                        );
                    } else {
                        self.counts[which] = Some(count);
                        (self.table.inputs, self.table.outputs) =
                            (self.counts[0].unwrap_or(0), self.counts[1].unwrap_or(0));
                    }
                }
            }
            ".p" => self.rows_told = self.number(first, rest),
            ".s" => self.states_told = self.number(first, rest),
            ".r" => match rest {
                [name] => self.reset = Some(*name),
                _ => self.error(first.span, "`.r` names one state", "write `.r`, and the state in which it begins"),
            },
            ".ilb" => self.table.input_names = rest.iter().map(|word| word.text.to_owned()).collect(),
            ".ob" => self.table.output_names = rest.iter().map(|word| word.text.to_owned()).collect(),
            ".e" | ".end" | ".end_kiss" => self.is_over = true,
            ".start_kiss" | ".type" | ".model" => {}
            other => self.diagnostics.push(lost(first.span, format!("`{other}` is not read"))),
        }
    }

    fn number(&mut self, first: Word<'a>, rest: &[Word<'a>]) -> Option<(usize, Span)> {
        let number = match rest {
            [word] => word.text.parse().ok().map(|number| (number, word.span)),
            _ => None,
        };
        if number.is_none() {
            self.error(first.span, format!("behind `{}` stands no number", first.text), "write a whole number there");
        }
        number
    }

    fn row(&mut self, words: &[Word<'a>]) {
        // Without inputs, or without outputs, the column is not there.
        let (inputs, outputs) = (self.table.inputs, self.table.outputs);
        let (cube, states, given) = match (words, inputs, outputs) {
            ([cube, from, to, given], ..) => (Some(*cube), [*from, *to], Some(*given)),
            ([from, to, given], 0, _) => (None, [*from, *to], Some(*given)),
            ([cube, from, to], _, 0) => (Some(*cube), [*from, *to], None),
            ([from, to], 0, 0) => (None, [*from, *to], None),
            _ => {
                let span = words.first().map_or(self.table.span, |word| word.span);
                let help = "a row has inputs, state, next state and outputs, with blanks between";
                return self.error(span, format!("a row has four words, and this one {}", words.len()), help);
            }
        };
        if self.counts.contains(&None) {
            let span = words.first().map_or(self.table.span, |word| word.span);
            self.counts = [Some(inputs), Some(outputs)];
            return self.error(
                span,
                "a row comes before `.i` and `.o`",
                "say first how many inputs and outputs a row has",
            );
        }
        let cube = self.column(cube, inputs, "input");
        let given = self.column(given, outputs, "output");
        let [from, to] = states.map(|word| self.state(word));
        if let (Some(cube), Some(given)) = (cube, given) {
            let outputs = given.into_iter().map(|value| value == Some(true)).collect();
            self.table.rows.push(Row { cube: Cube(cube), from, to, outputs, span: states[0].span });
        }
    }

    /// The signs of a column.
    fn column(&mut self, word: Option<Word<'a>>, width: usize, what: &str) -> Option<Vec<Option<bool>>> {
        let Some(word) = word else { return Some(Vec::new()) };
        let count = word.text.chars().count();
        if count != width {
            let plural = if width == 1 { "" } else { "s" };
            self.error(word.span, format!("{count} signs for {width} {what}{plural}"), "give each one `0`, `1` or `-`");
            return None;
        }
        let signs = word.text.chars().map(|sign| match sign {
            '0' => Some(Some(false)),
            '1' => Some(Some(true)),
            '-' | '2' | '~' => Some(None),
            _ => None,
        });
        let signs: Option<Vec<Option<bool>>> = signs.collect();
        if signs.is_none() {
            self.error(
                word.span,
                format!("`{}` has a sign other than `0`, `1` and `-`", word.text),
                "write one of these",
            );
        }
        signs
    }

    /// The state of a name; none: any.
    fn state(&mut self, word: Word<'a>) -> Option<usize> {
        if matches!(word.text, "*" | "-" | "ANY") {
            return None;
        }
        let next = self.table.states.len();
        let state = *self.of_name.entry(word.text).or_insert(next);
        if state == next {
            self.table.states.push(word.text.to_owned());
        }
        Some(state)
    }

    /// What can be said only now.
    fn end(&mut self) {
        let begin = self.text.find('.').unwrap_or(0);
        let whole = Span::new(self.file, begin, (begin + 1).min(self.text.len()));
        self.table.span = whole;
        if self.errors >= MOST_ERRORS {
            return;
        }
        if self.table.rows.is_empty() && self.errors == 0 {
            self.error(whole, "the table has no rows", "write rows of inputs, state, next state and outputs");
        }
        let (inputs, outputs) = (self.table.inputs, self.table.outputs);
        for (names, count, what) in
            [(&mut self.table.input_names, inputs, ".ilb"), (&mut self.table.output_names, outputs, ".ob")]
        {
            if !names.is_empty() && names.len() != count {
                let told = format!("`{what}` has {} names for {count} columns", names.len());
                self.diagnostics.push(doubtful(whole, told));
                names.clear();
            }
        }
        for (told, found, what) in
            [(self.rows_told, self.table.rows.len(), "rows"), (self.states_told, self.table.states.len(), "states")]
        {
            if let Some((told, span)) = told
                && told != found
                && self.errors == 0
            {
                self.diagnostics.push(doubtful(span, format!("the table has {found} {what}, not {told}")));
            }
        }
        if let Some(reset) = self.reset {
            match self.of_name.get(reset.text) {
                Some(state) => self.table.reset = *state,
                None => {
                    let help = "name a state that rows have, or leave the line out";
                    self.error(reset.span, format!("no row has the state `{}`", reset.text), help);
                }
            }
        }
        if self.table.states.is_empty() && self.errors == 0 {
            self.error(whole, "no row names a state", "write the name of a state in place of `*`");
        }
    }
}
