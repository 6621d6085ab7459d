//! Messages for scripts: one JSON object a line.
//!
//! ```text
//! {"code":"E0201","slug":"unknown-name","severity":"error","message":"…","file":"a.gct",
//!  "start":{"line":1,"column":7,"byte":6},"end":{…},"labels":[…],"notes":["…"],"help":null,
//!  "fixes":[{"title":"…","certain":false,"edits":[{"file":"a.gct","start":{…},"end":{…},"text":"…"}]}]}
//! ```
//!
//! Lines and columns count from 1, columns in characters, bytes from 0; an end is the place after the last character.
//! `labels` holds the place itself, first, and then all others that are involved. `fixes` are changes of the text, each a
//! correction by itself; a certain one is only another spelling of the same.

use super::human::severity;
use crate::{Applicability, Diagnostic, Diagnostics, Fix, Label, Position, SourceMap};
use serde::Serialize;

#[derive(Serialize)]
struct Message<'a> {
    code: &'a str,
    slug: &'a str,
    severity: &'a str,
    message: &'a str,
    file: &'a str,
    start: Position,
    end: Position,
    labels: Vec<JsonLabel<'a>>,
    notes: &'a [String],
    help: Option<&'a str>,
    fixes: Vec<Cure<'a>>,
}

#[derive(Serialize)]
struct JsonLabel<'a> {
    primary: bool,
    file: &'a str,
    start: Position,
    end: Position,
    text: &'a str,
}

#[derive(Serialize)]
struct Cure<'a> {
    title: &'a str,
    certain: bool,
    edits: Vec<Change<'a>>,
}

#[derive(Serialize)]
struct Change<'a> {
    file: &'a str,
    start: Position,
    end: Position,
    text: &'a str,
}

/// All messages, in the order given, one line each.
pub fn json(sources: &SourceMap, diagnostics: &Diagnostics) -> String {
    let mut out = String::new();
    for diagnostic in diagnostics {
        let message = message(sources, diagnostic);
        // Strings and numbers alone cannot be refused.
        out.push_str(&serde_json::to_string(&message).unwrap_or_default());
        out.push('\n');
    }
    out
}

fn message<'a>(sources: &'a SourceMap, diagnostic: &'a Diagnostic) -> Message<'a> {
    let primary = json_label(sources, &diagnostic.primary, true);
    let (file, start, end) = (primary.file, primary.start, primary.end);
    let mut labels = vec![primary];
    labels.extend(diagnostic.secondary.iter().map(|label| json_label(sources, label, false)));
    Message {
        code: diagnostic.code.as_str(),
        slug: diagnostic.code.slug(),
        severity: severity(diagnostic),
        message: &diagnostic.message,
        file,
        start,
        end,
        labels,
        notes: &diagnostic.notes,
        help: diagnostic.help.as_deref(),
        fixes: diagnostic.fixes.iter().map(|fix| cure(sources, fix)).collect(),
    }
}

fn cure<'a>(sources: &'a SourceMap, fix: &'a Fix) -> Cure<'a> {
    let edits = fix.edits.iter().map(|edit| {
        let file = sources.file(edit.span.file);
        let range = file.range(edit.span);
        let (start, end) = (file.position(range.start), file.position(range.end));
        Change { file: &file.name, start, end, text: &edit.text }
    });
    Cure { title: &fix.title, certain: fix.applicability == Applicability::Certain, edits: edits.collect() }
}

fn json_label<'a>(sources: &'a SourceMap, label: &'a Label, primary: bool) -> JsonLabel<'a> {
    let file = sources.file(label.span.file);
    let range = file.range(label.span);
    let (start, end) = (file.position(range.start), file.position(range.end));
    JsonLabel { primary, file: &file.name, start, end, text: &label.text }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Code, Span};
    use expect_test::expect;

    #[test]
    fn one_object_a_line_with_columns_in_characters() {
        let mut sources = SourceMap::new();
        let file = sources.add("ä \"b\".gct", "вход a : bool\r\nшаг\n");
        let mut diagnostics = Diagnostics::new();
        diagnostics.push(
            Diagnostic::new(Code::E0201, Span::new(file, 9, 10), "unknown\nname")
                .here("here")
                .also(Span::new(file, 19, 25), "there")
                .note("n")
                .help("h")
                .fix(Fix::maybe("f").replace(Span::new(file, 9, 10), "я").delete(Span::new(file, 19, 25))),
        );
        diagnostics.push(Diagnostic::new(Code::W0401, Span::new(file, 26, 26), "m"));
        expect![[r#"
            {"code":"E0201","slug":"unknown-name","severity":"error","message":"unknown\nname","file":"ä \"b\".gct","start":{"line":1,"column":6,"byte":9},"end":{"line":1,"column":7,"byte":10},"labels":[{"primary":true,"file":"ä \"b\".gct","start":{"line":1,"column":6,"byte":9},"end":{"line":1,"column":7,"byte":10},"text":"here"},{"primary":false,"file":"ä \"b\".gct","start":{"line":2,"column":1,"byte":19},"end":{"line":2,"column":4,"byte":25},"text":"there"}],"notes":["n"],"help":"h","fixes":[{"title":"f","certain":false,"edits":[{"file":"ä \"b\".gct","start":{"line":1,"column":6,"byte":9},"end":{"line":1,"column":7,"byte":10},"text":"я"},{"file":"ä \"b\".gct","start":{"line":2,"column":1,"byte":19},"end":{"line":2,"column":4,"byte":25},"text":""}]}]}
            {"code":"W0401","slug":"output-read","severity":"warning","message":"m","file":"ä \"b\".gct","start":{"line":3,"column":1,"byte":26},"end":{"line":3,"column":1,"byte":26},"labels":[{"primary":true,"file":"ä \"b\".gct","start":{"line":3,"column":1,"byte":26},"end":{"line":3,"column":1,"byte":26},"text":""}],"notes":[],"help":null,"fixes":[]}
        "#]].assert_eq(&json(&sources, &diagnostics));
    }

    #[test]
    fn no_messages_are_no_lines() {
        assert_eq!(json(&SourceMap::new(), &Diagnostics::new()), "");
    }
}
