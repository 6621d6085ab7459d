//! The page of the book on habits of other languages: each thing that is written elsewhere gives one error, and the change
//! that it offers makes what the page says is written here.

use grafc_diagnostics::{Diagnostic, FileId, Severity, apply};
use std::path::Path;

const FILE: FileId = FileId::new(0);

/// What the lines of the page refer to.
const AROUND: &str = "input a, b, start, `1B1`, `-S4` : bool var n : int output K, fill : bool\ngrafcet G2 { initial step 20 }\n\
                      grafcet G1 {\ninitial step 1 step 2\n";

fn chart(section: &str, written: &str) -> String {
    match section {
        "Conditions" => format!("{AROUND}transition 1 -> 2 : {written}\n}}\n"),
        "Actions" => format!("{AROUND}step 3 {written}\n}}\n"),
        _ if declares(written) => format!("{written}\n{AROUND}}}\n"),
        _ => format!("{AROUND}{written}\n}}\n"),
    }
}

/// Whether a line stands outside of the grafcet.
fn declares(written: &str) -> bool {
    ["input", "Eingang", "var", "VAR", "retain", "const"].iter().any(|word| written.starts_with(word))
}

fn errors(text: &str) -> Vec<Diagnostic> {
    let said = grafc::check(FILE, text, "Habits").1;
    said.iter().filter(|said| said.code.severity() == Severity::Error).cloned().collect()
}

/// The pieces of code in a cell.
fn codes(cell: &str) -> Vec<String> {
    let cell = cell.trim();
    match cell.strip_prefix("`` ").and_then(|cell| cell.strip_suffix(" ``")) {
        Some(code) => vec![code.to_owned()],
        None => cell.split('`').skip(1).step_by(2).map(str::to_owned).collect(),
    }
}

#[test]
fn what_is_written_elsewhere_becomes_what_is_written_here() {
    let page = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/habits.md");
    let page = std::fs::read_to_string(page).expect("the page");
    let dense = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
    let (mut section, mut tried, mut wrong) = ("", 0, Vec::new());
    for line in page.lines() {
        if let Some(title) = line.strip_prefix("## ") {
            section = title;
        }
        let Some((elsewhere, here)) = line.strip_prefix("| ").and_then(|line| line.split_once(" | ")) else { continue };
        let (Some(right), false) = (codes(here.trim_end_matches('|')).pop(), elsewhere == "elsewhere") else {
            continue;
        };
        let right = chart(section, &right);
        for written in codes(elsewhere) {
            tried += 1;
            let text = chart(section, &written);
            let found = errors(&text);
            let fixed = match found.as_slice() {
                [only] => only.fixes.first().map(|fix| apply(FILE, &text, &fix.edits).expect("the edits fit")),
                _ => None,
            };
            match fixed {
                // Where a blank stands is left to `grafc fmt`.
                Some(fixed) if dense(&fixed) == dense(&right) && errors(&fixed).is_empty() => {}
                _ => {
                    let said: Vec<&str> = found.iter().map(|said| said.message.as_str()).collect();
                    wrong.push(format!("{written}: {said:?}\n{}", fixed.unwrap_or_default()));
                }
            }
        }
    }
    assert!(wrong.is_empty(), "{} of {tried}\n{}", wrong.len(), wrong.join("\n"));
    assert!(tried >= 70, "{tried}");
}
