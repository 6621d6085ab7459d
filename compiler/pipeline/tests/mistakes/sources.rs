//! Every help that grafc can give on a chart is tried: the source is searched for all places that make one, and each has
//! a row among the mistakes, a row in the table of habits, or a page that shows it.

use super::{FILE, mistakes, said};
use grafc_diagnostics::{Code, FileId};
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// What a help is made by. Of a cure the help is the first argument.
const MAKERS: [&str; 6] = [".help(", "Cure::new(", "Cure::words(", "Cure::write(", "Cure::guess(", "Cure::leave_out("];

/// Names of variables that hold a help until it is given.
const HELD: [&str; 5] = ["help", "words", "otherwise", "declaration", "cure"];

/// Where helps on other things than the text of a chart are made.
const ELSEWHERE: &[&str] = &[
    // Traces: the tests there.
    "model/src/trace/",
    // Names that options give, and no chart.
    "model/src/chart/controls.rs",
    // Encodings and drawn bodies: the pages of W0413 and E0503, which are compiled.
    "logic/src/warn/overlap.rs",
    "logic/src/sequence/",
];

/// Helps that no chart of a few lines can get.
const OUT_OF_REACH: &[&str] = &[
    "an expansion may stand outside of the others",
    // In a file of scenarios.
    "what belongs to the chart stands in its own file",
    // Of what a command line asks for.
    "ask for nothing: the chart means what its heading says; or change the heading",
    "leave `--{option}` out",
];

/// The words of a help in the source, with `{…}` where something is put in.
struct Words {
    place: String,
    words: String,
}

fn sources(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("one").path()) {
        if entry.is_dir() {
            sources(&entry, found);
        } else if entry.extension().is_some_and(|ending| ending == "rs") {
            found.push(entry);
        }
    }
    found.sort();
}

/// A string literal that begins at a quotation mark: its text, and where it ends.
fn literal(source: &str, at: usize) -> (String, usize) {
    let mut text = String::new();
    let mut rest = source[at + 1..].char_indices();
    while let Some((offset, c)) = rest.next() {
        match c {
            '"' => return (text, at + 1 + offset + 1),
            '\\' => match rest.next() {
                Some((_, 'n')) => text.push('\n'),
                Some((_, '\n')) => {
                    let behind = at + 1 + offset + 2;
                    let blanks = source[behind..].len() - source[behind..].trim_start().len();
                    (0..blanks).for_each(|_| _ = rest.next());
                }
                Some((_, other)) => text.push(other),
                None => break,
            },
            other => text.push(other),
        }
    }
    (text, source.len())
}

/// The literals from a place on, up to the end of the argument or of the statement.
fn literals(source: &str, from: usize, ends_with_comma: bool) -> Vec<String> {
    let (mut depth, mut at, mut found) = (0usize, from, Vec::new());
    while let Some(c) = source[at..].chars().next() {
        match c {
            '"' => {
                let (text, end) = literal(source, at);
                found.push(text);
                at = end;
                continue;
            }
            '(' | '{' | '[' => depth += 1,
            ')' | '}' | ']' if depth == 0 => break,
            ')' | '}' | ']' => depth -= 1,
            ';' if depth == 0 => break,
            ',' if depth == 0 && ends_with_comma => break,
            _ => {}
        }
        at += c.len_utf8();
    }
    found
}

fn helps() -> Vec<Words> {
    let compiler = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let mut files = Vec::new();
    for part in ["syntax", "model", "logic"] {
        sources(&compiler.join(part).join("src"), &mut files);
    }
    let mut found = Vec::new();
    for file in files {
        let place = file.to_string_lossy().replace('\\', "/");
        if place.contains("/tests") || ELSEWHERE.iter().any(|part| place.contains(part)) {
            continue;
        }
        let source = fs::read_to_string(&file).expect("a text").replace("\r\n", "\n");
        let source = &source[..source.find("#[cfg(test)]\nmod tests {").unwrap_or(source.len())];
        let mut add = |at: usize, by: &str, ends_with_comma: bool| {
            let line = source[..at].matches('\n').count() + 1;
            let all = literals(source, at + by.len(), ends_with_comma).into_iter();
            // What is asked for in a match, and signs that are put in, are no sentences.
            let sentences = all.filter(|words| words.contains(' ') && words.trim().len() > 4);
            found.extend(sentences.map(|words| Words { place: format!("{place}:{line}"), words }));
        };
        for by in MAKERS {
            source.match_indices(by).for_each(|(at, _)| add(at, by, by != MAKERS[0]));
        }
        for name in HELD {
            let by = format!("let {name} = ");
            source.match_indices(&by).for_each(|(at, _)| add(at, &by, false));
        }
    }
    found
}

/// The helps on all charts with mistakes that the project has.
fn given() -> BTreeSet<String> {
    let mut charts: Vec<String> = mistakes().into_iter().map(|mistake| mistake.chart).collect();
    for code in Code::ALL {
        let wrong = code.page().split("\n## ").find(|section| section.starts_with("Wrong")).unwrap_or_default();
        let blocks = wrong.split("```gct").skip(1).filter_map(|block| block.split_once('\n'));
        charts.extend(blocks.filter_map(|(_, block)| Some(block.split_once("```")?.0.to_owned())));
    }
    let table = Path::new(env!("CARGO_MANIFEST_DIR")).join("../syntax/src/habits/table.rs");
    let table = fs::read_to_string(table).expect("the table of habits");
    let rows = table.lines().filter(|line| line.starts_with("    \"") && line.contains("\" => \""));
    charts.extend(rows.map(|line| literal(line, 4).0));
    charts.iter().flat_map(|chart| said(chart)).filter_map(|message| message.help).collect()
}

/// Whether a help has been made of these words.
fn is_made_of(help: &str, words: &str) -> bool {
    // `{{` is a brace of the text.
    let words = words.replace("{{", "\u{1}").replace("}}", "\u{2}");
    let mut fixed = words.split('{').enumerate().map(|(at, part)| match at {
        0 => part,
        _ => part.split_once('}').map_or("", |(_, fixed)| fixed),
    });
    let brace = |part: &str| part.replace('\u{1}', "{").replace('\u{2}', "}");
    let first = brace(fixed.next().unwrap_or_default());
    let Some(mut rest) = help.strip_prefix(first.as_str()) else { return false };
    let parts: Vec<String> = fixed.map(brace).collect();
    let Some((last, between)) = parts.split_last() else { return rest.is_empty() };
    for part in between {
        match rest.find(part.as_str()) {
            Some(at) => rest = &rest[at + part.len()..],
            None => return false,
        }
    }
    rest.ends_with(last.as_str())
}

#[test]
fn each_help_in_the_source_is_tried() {
    let (helps, given) = (helps(), given());
    let untried: Vec<String> = helps
        .iter()
        .filter(|help| !OUT_OF_REACH.contains(&help.words.as_str()))
        .filter(|help| !given.iter().any(|given| is_made_of(given, &help.words)))
        .map(|help| format!("{}: {}", help.place, help.words))
        .collect();
    assert!(helps.len() > 250, "only {} helps were found", helps.len());
    assert!(untried.is_empty(), "{} of {} helps are not tried:\n{}", untried.len(), helps.len(), untried.join("\n"));
}

#[test]
fn words_are_matched() {
    assert!(is_made_of("write `a` or `b`", "write `{one}` or `{}`"));
    assert!(is_made_of("`{ a … }`", "`{{ {word} … }}`"));
    assert!(!is_made_of("write `a`", "write `{}` or"));
    assert!(!is_made_of("write `a` now", "write `a`"));
    // A chart with a mistake gets its help, or nothing here would mean anything.
    assert!(!said("step 1\ntransition 1 -> 1 : a b\n").is_empty() && FILE == FileId::default());
}
