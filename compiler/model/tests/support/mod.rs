//! Charts that say at their places what is expected there.
//!
//! ```text
//!     transition 1 -> 5 : valev
//!     //              ^ E0301
//!     //                  ^^^^^ E0201
//! ```
//!
//! A comment that has nothing but blanks before its first `^` speaks of the last line before it that is no such comment,
//! and of the columns that stand above its `^`. The annotations are comments of the chart, so it is read as it stands.

use grafc_diagnostics::{SourceFile, Span, Unit};

/// What is said of the places of a text: `line:column-column words`, one a line.
pub fn annotated(text: &str) -> Vec<String> {
    let mut found = Vec::new();
    let mut spoken_of = 0;
    for (number, line) in text.lines().enumerate() {
        let marks = line.trim_start().strip_prefix("//").map(str::trim_start).filter(|rest| rest.starts_with('^'));
        match marks {
            None => spoken_of = number,
            Some(rest) => {
                let start = line.chars().position(|c| c == '^').expect("it begins with one");
                let length = rest.chars().take_while(|c| *c == '^').count();
                let words = rest.trim_start_matches('^').trim();
                found.push(spell(spoken_of, start, start + length, words));
            }
        }
    }
    found.sort();
    found
}

/// The same of what was found: spans of the text and words.
pub fn placed(text: &str, found: impl IntoIterator<Item = (Span, String)>) -> Vec<String> {
    let file = SourceFile::new("t", text);
    let mut spelled: Vec<String> = found
        .into_iter()
        .map(|(span, words)| {
            let start = file.place(span.start as usize, Unit::Characters);
            let end = file.place(span.end as usize, Unit::Characters);
            assert_eq!(start.line, end.line, "{words}: the place is on one line");
            spell(start.line as usize, start.column as usize, end.column as usize, &words)
        })
        .collect();
    spelled.sort();
    spelled
}

fn spell(line: usize, start: usize, end: usize, words: &str) -> String {
    format!("{:03}:{start:03}-{end:03} {words}", line + 1)
}

#[test]
fn annotations_speak_of_the_line_above() {
    let text = "a\n  bäc d\n  //^ one\n //  ^^ two  \n// no mark ^\ne f\n//^ three";
    assert_eq!(annotated(text), ["002:004-005 one", "002:005-007 two", "006:002-003 three"]);
    let found = [(2, "one", 3), (7, "two", 10)]
        .map(|(start, words, end)| (Span::new(Default::default(), start, end), words.to_owned()));
    assert_eq!(placed(text, found), ["002:000-001 one", "002:004-007 two"]);
}
