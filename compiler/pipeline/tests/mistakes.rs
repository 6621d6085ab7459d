//! Mistakes that people make: each costs one message, which gives the place, the reason and a cure that helps.
//!
//! The charts are in `mistakes/*.txt`. `== title` begins one; under the line with the mistake stands `^^^ E0107` where
//! the message must be. Behind the chart, `cure:` is a part of the help, and each `right:` is a line that an author who
//! follows the help may write in place of the wrong one, or with `right @1:` in place of line 1 (`\n` is a line end).
//! What is checked:
//!
//! - there is one message, at that place, with that code, with help;
//! - each change that it offers is made, and the chart then has nothing wrong; the first gives the first `right:`;
//! - so has the chart with each `right:`;
//! - what the help has in backquotes is found in what became of the line (`…` stands for anything), or in the line.

#[path = "mistakes/sources.rs"]
mod sources;

use grafc_diagnostics::{Diagnostic, FileId, apply};
use std::path::Path;

const FILE: FileId = FileId::new(0);

/// How many mistakes there are at least.
const LEAST: usize = 200;

struct Mistake {
    name: String,
    chart: String,
    /// The number of the wrong line.
    line: usize,
    /// Its columns, in characters.
    columns: std::ops::Range<usize>,
    code: String,
    cure: Option<String>,
    /// Lines, and what to write there.
    right: Vec<(usize, String)>,
}

fn mistakes() -> Vec<Mistake> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/mistakes");
    let mut files: Vec<_> =
        std::fs::read_dir(folder).expect("the folder").map(|entry| entry.expect("a file").path()).collect();
    files.retain(|file| file.extension().is_some_and(|ending| ending == "txt"));
    files.sort();
    let mut found = Vec::new();
    for file in files {
        let text = std::fs::read_to_string(&file).expect("a text");
        let stem = file.file_stem().expect("a name").to_string_lossy().into_owned();
        for block in format!("\n{text}").split("\n== ").skip(1) {
            found.push(read(&stem, block));
        }
    }
    found
}

fn read(file: &str, block: &str) -> Mistake {
    let (title, rest) = block.split_once('\n').expect("a chart");
    let name = format!("{file}: {title}");
    let (mut lines, mut mark, mut cure, mut right) = (Vec::new(), None, None, Vec::new());
    for line in rest.lines() {
        let marked = line.trim_start();
        if let Some(words) = line.strip_prefix("cure: ") {
            cure = Some(words.to_owned());
        } else if let Some((head, instead)) = line.strip_prefix("right").and_then(|rest| rest.split_once(": ")) {
            let at = head.trim().strip_prefix('@').map(|at| at.parse::<usize>().expect("the number of a line") - 1);
            right.push((at, instead.replace("\\n", "\n")));
        } else if marked.starts_with('^') {
            let (carets, code) = marked.split_once(' ').expect("a code");
            let start = line.len() - marked.len();
            assert!(mark.is_none(), "{name}: two marks");
            mark = Some((lines.len() - 1, start..start + carets.len(), code.to_owned()));
        } else {
            lines.push(line);
        }
    }
    let (line, columns, code) = mark.unwrap_or_else(|| panic!("{name}: no mark"));
    let chart = format!("{}\n", lines.join("\n").trim_end());
    let right = right.into_iter().map(|(at, instead)| (at.unwrap_or(line), instead)).collect();
    Mistake { name, chart, line, columns, code, cure, right }
}

fn said(chart: &str) -> Vec<Diagnostic> {
    grafc::check(FILE, chart, "Mistake").1.iter().cloned().collect()
}

fn headlines(said: &[Diagnostic]) -> String {
    said.iter().map(|d| format!("\n    {} {} ({:?})", d.code.as_str(), d.message, d.help)).collect()
}

impl Mistake {
    fn wrong_line(&self) -> &str {
        self.chart.lines().nth(self.line).expect("the marked line")
    }

    fn with(&self, (place, right): &(usize, String)) -> String {
        let lines = self.chart.lines().enumerate();
        lines.map(|(at, line)| format!("{}\n", if at == *place { right } else { line })).collect()
    }

    /// The number of the line and the columns of a place.
    fn place(&self, message: &Diagnostic) -> (usize, std::ops::Range<usize>) {
        let range = message.primary.span.range();
        let before = &self.chart[..range.start];
        let column = before[before.rfind('\n').map_or(0, |at| at + 1)..].chars().count();
        let length = self.chart[range].chars().count().max(1);
        (before.matches('\n').count(), column..column + length)
    }

    fn faults(&self) -> Vec<String> {
        let found = said(&self.chart);
        let [message] = found.as_slice() else {
            return vec![format!("{} messages{}", found.len(), headlines(&found))];
        };
        let mut faults = Vec::new();
        if message.code.as_str() != self.code || self.place(message) != (self.line, self.columns.clone()) {
            let (line, columns) = self.place(message);
            faults.push(format!("not there: {line} {columns:?}{}", headlines(&found)));
        }
        let Some(help) = &message.help else {
            faults.push(format!("no cure{}", headlines(&found)));
            return faults;
        };
        if !self.cure.as_ref().is_some_and(|cure| help.contains(cure.as_str())) {
            faults.push(format!("the help is: {help}"));
        }
        let mut texts: Vec<String> = self.right.iter().map(|right| self.with(right)).collect();
        if texts.is_empty() && message.fixes.is_empty() {
            faults.push("nothing shows that the help helps".to_owned());
        }
        for (at, fix) in message.fixes.iter().enumerate() {
            let fixed = apply(FILE, &self.chart, &fix.edits).expect("the edits fit");
            if at == 0 && texts.first().is_some_and(|right| *right != fixed) {
                faults.push(format!("changed to:\n{fixed}"));
            }
            texts.push(fixed);
        }
        for text in &texts {
            let left = said(text);
            if !left.is_empty() {
                faults.push(format!("left is{}\n{text}", headlines(&left)));
            }
        }
        texts.push(self.wrong_line().to_owned());
        for code in help.split('`').skip(1).step_by(2) {
            if !texts.iter().any(|text| is_in(code, text)) {
                faults.push(format!("nobody writes `{code}`: {help}"));
            }
        }
        faults
    }
}

/// Whether a text has a part like the code, in which `…` stands for anything; blanks do not count.
fn is_in(code: &str, text: &str) -> bool {
    let dense = |text: &str| text.split_whitespace().collect::<String>();
    let text = dense(text);
    let mut rest = text.as_str();
    dense(code).split('…').all(|part| match rest.find(part) {
        Some(at) => {
            rest = &rest[at + part.len()..];
            true
        }
        None => false,
    })
}

#[test]
fn each_mistake_costs_one_message_that_helps() {
    let mistakes = mistakes();
    let wrong: Vec<String> = mistakes
        .iter()
        .flat_map(|mistake| mistake.faults().into_iter().map(move |fault| format!("{}: {fault}", mistake.name)))
        .collect();
    assert!(wrong.is_empty(), "{} faults\n{}", wrong.len(), wrong.join("\n"));
    assert!(mistakes.len() >= LEAST, "there are {} mistakes only", mistakes.len());
}
