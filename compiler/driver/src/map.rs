//! `--map`: which lines of the code come from which element of the chart, as JSON; `docs/map.md` says what is what.

use grafc_backends::{Element, Map};
use grafc_diagnostics::SourceMap;
use serde::Serialize;
use std::collections::BTreeMap;

/// Goes up where a reader of the old form would read the new one wrongly.
const VERSION: u32 = 1;

/// What was made of what.
pub struct Made<'m> {
    /// The name of the chart's file, without folders.
    pub chart: &'m str,
    /// The name of the code's file, without folders; none if that is standard output.
    pub output: Option<&'m str>,
    /// The target and the encoding.
    pub target: &'m str,
    pub encoding: &'m str,
}

#[derive(Serialize)]
struct Document<'m> {
    version: u32,
    chart: &'m str,
    output: Option<&'m str>,
    target: &'m str,
    encoding: &'m str,
    elements: Vec<Entry<'m>>,
    lines: Vec<Run>,
}

/// An element and its lines.
#[derive(Serialize)]
struct Entry<'m> {
    kind: &'static str,
    name: &'m str,
    #[serde(skip_serializing_if = "Option::is_none")]
    at: Option<&'m str>,
    #[serde(skip_serializing_if = "Option::is_none")]
    comment: Option<&'m str>,
    start: LineColumn,
    end: LineColumn,
    lines: &'m [(u32, u32)],
}

/// A place in the chart, from 1; columns in characters.
#[derive(Serialize)]
struct LineColumn {
    line: usize,
    column: usize,
}

/// Lines in a row, and the elements that all of them come from.
#[derive(Serialize)]
struct Run {
    first: u32,
    last: u32,
    elements: Vec<usize>,
}

/// The text of a map.
pub fn json(map: &Map, made: &Made, sources: &SourceMap) -> String {
    let document = Document {
        version: VERSION,
        chart: made.chart,
        output: made.output,
        target: made.target,
        encoding: made.encoding,
        elements: map.elements.iter().map(|element| entry(element, sources)).collect(),
        lines: lines(&map.elements),
    };
    let mut text = String::from("{\n");
    // An element a line and a run a line: a map can be read and compared as well as parsed.
    for (name, value) in [
        ("version", line(&document.version)),
        ("chart", line(&document.chart)),
        ("output", line(&document.output)),
        ("target", line(&document.target)),
        ("encoding", line(&document.encoding)),
        ("elements", list(&document.elements)),
        ("lines", list(&document.lines)),
    ] {
        text += &format!("  \"{name}\": {value}{}\n", if name == "lines" { "" } else { "," });
    }
    text + "}\n"
}

/// A value on a line; what is written here has no form that JSON lacks.
fn line(value: &impl Serialize) -> String {
    serde_json::to_string(value).unwrap_or_default()
}

fn list<T: Serialize>(items: &[T]) -> String {
    if items.is_empty() {
        return "[]".to_owned();
    }
    let items: Vec<String> = items.iter().map(|item| format!("    {}", line(item))).collect();
    format!("[\n{}\n  ]", items.join(",\n"))
}

fn entry<'m>(element: &'m Element, sources: &SourceMap) -> Entry<'m> {
    let file = sources.file(element.span.file);
    let range = file.range(element.span);
    let place = |byte| {
        let position = file.position(byte);
        LineColumn { line: position.line, column: position.column }
    };
    Entry {
        kind: element.kind.name(),
        name: &element.name,
        at: element.at.as_deref(),
        comment: element.comment.as_deref(),
        start: place(range.start),
        end: place(range.end),
        lines: &element.lines,
    }
}

/// Runs of lines that come from the same elements; lines that come from none are left out.
fn lines(elements: &[Element]) -> Vec<Run> {
    // Where runs of elements begin and, one line behind them, end.
    let mut changes: BTreeMap<u32, Vec<(usize, bool)>> = BTreeMap::new();
    for (index, element) in elements.iter().enumerate() {
        for (first, last) in &element.lines {
            changes.entry(*first).or_default().push((index, true));
            changes.entry(last + 1).or_default().push((index, false));
        }
    }
    let mut runs = Vec::new();
    let mut open: Vec<usize> = Vec::new();
    let mut since = 0;
    for (line, changes) in changes {
        if !open.is_empty() {
            runs.push(Run { first: since, last: line - 1, elements: open.clone() });
        }
        for (index, begins) in changes {
            if begins {
                open.push(index);
            } else {
                open.retain(|other| *other != index);
            }
        }
        open.sort_unstable();
        since = line;
    }
    runs
}
