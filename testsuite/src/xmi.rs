//! Charts as AGRAFE saves them: small ones written here, regular ones of any size, and damaged ones.

use crate::tools::{Tool, or_skip};
use fastrand::Rng;
use std::fmt::Write as _;
use std::path::PathBuf;
use std::{fs, io};

/// The charts of AGRAFE's own collection, by name; an error says what is missing.
///
/// They lie beside the project, in `../shared/charts/agrafe`, or where `AGRAFE_CHARTS` says.
pub fn collection() -> Result<Vec<(String, String)>, String> {
    let folder = std::env::var_os("AGRAFE_CHARTS").map(PathBuf::from);
    let folder = folder.unwrap_or_else(|| crate::binary::root().join("../shared/charts/agrafe"));
    let missing = |error: io::Error| format!("{}: {error}; AGRAFE_CHARTS names the charts of AGRAFE", folder.display());
    let mut charts = Vec::new();
    for entry in fs::read_dir(&folder).map_err(missing)? {
        let path = entry.map_err(missing)?.path();
        if path.extension().is_some_and(|extension| extension == "grafcet") {
            let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
            charts.push((name, fs::read_to_string(path).map_err(missing)?));
        }
    }
    charts.sort();
    Ok(charts)
}

/// The collection, or nothing and a line that says why the test that wants it does nothing.
pub fn collection_or_skip() -> Option<Vec<(String, String)>> {
    or_skip(Tool::Agrafe, collection())
}

/// What stands around the contents of a chart.
pub fn chart(contents: &str) -> String {
    format!("{HEAD}{contents}{FOOT}")
}

const HEAD: &str = "\
<?xml version=\"1.0\" encoding=\"UTF-8\"?>
<grafcet:Grafcet xmi:version=\"2.0\" xmlns:xmi=\"http://www.omg.org/XMI\" \
xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" xmlns:grafcet=\"http://www.example.org/grafcet\" \
xmlns:terms=\"http://www.example.org/terms\" name=\"Example\">
";

const FOOT: &str = "</grafcet:Grafcet>\n";

/// A ring of so many steps, with a condition at each transition and an action at every other step.
pub fn ring(steps: usize) -> String {
    let mut out = String::from(HEAD);
    out.push_str("<variableDeclarationContainer>\n");
    for (name, kind) in [("a", "input"), ("b", "input"), ("V", "output")] {
        let _ = writeln!(
            out,
            "<variableDeclarations name=\"{name}\" variableDeclarationType=\"{kind}\">\
             <sort xsi:type=\"terms:Bool\"/></variableDeclarations>"
        );
    }
    out.push_str("</variableDeclarationContainer>\n");
    out.push_str("<partialGrafcets xsi:type=\"grafcet:PartialGrafcet\" name=\"G1\">\n");
    for step in 0..steps {
        let initial = if step == 0 { " initial=\"true\"" } else { "" };
        let _ = writeln!(out, "<steps xsi:type=\"grafcet:Step\" id=\"{}\"{initial}/>", step + 1);
    }
    let variable =
        |place: usize| format!("variableDeclaration=\"//@variableDeclarationContainer/@variableDeclarations.{place}\"");
    for step in 0..steps {
        let _ = writeln!(
            out,
            "<transitions id=\"{}\"><term xsi:type=\"terms:And\">\
             <subterm xsi:type=\"terms:Variable\" {}/>\
             <subterm xsi:type=\"terms:Not\"><subterm xsi:type=\"terms:Variable\" {}/></subterm>\
             </term></transitions>",
            step + 1,
            variable(step % 2),
            variable(1 - step % 2)
        );
    }
    for step in 0..steps {
        let next = (step + 1) % steps;
        let grafcet = "//@partialGrafcets.0";
        let _ = writeln!(out, "<arcs source=\"{grafcet}/@steps.{step}\" target=\"{grafcet}/@transitions.{step}\"/>");
        let _ = writeln!(out, "<arcs source=\"{grafcet}/@transitions.{step}\" target=\"{grafcet}/@steps.{next}\"/>");
    }
    for _ in (0..steps).step_by(2) {
        let _ = writeln!(
            out,
            "<actionTypes xsi:type=\"grafcet:ContinuousAction\"><variable {}/></actionTypes>",
            variable(2)
        );
    }
    for (action, step) in (0..steps).step_by(2).enumerate() {
        let _ = writeln!(
            out,
            "<actionLinks step=\"//@partialGrafcets.0/@steps.{step}\" actionType=\"//@partialGrafcets.0/@actionTypes.{action}\"/>"
        );
    }
    out.push_str("</partialGrafcets>\n");
    out.push_str(FOOT);
    out
}

/// A file with some damage: cut off, or with pieces removed, doubled, exchanged or overwritten.
pub fn damaged(text: &str, rng: &mut Rng) -> String {
    let place = |text: &str, rng: &mut Rng| {
        let at = rng.usize(0..=text.len());
        (0..=at).rev().find(|&at| text.is_char_boundary(at)).unwrap_or_default()
    };
    let mut text = text.to_string();
    for _ in 0..rng.usize(1..=3) {
        if text.is_empty() {
            break;
        }
        match rng.u8(0..8) {
            0 => text.truncate(place(&text, rng)),
            1 | 2 => {
                let lines: Vec<&str> = text.lines().collect();
                let (one, other) = (rng.usize(0..lines.len()), rng.usize(0..lines.len()));
                let mut lines = lines.clone();
                match rng.u8(0..3) {
                    0 => drop(lines.remove(one)),
                    1 => lines.insert(one, lines[other]),
                    _ => lines.swap(one, other),
                }
                text = lines.join("\n");
            }
            3 => {
                let (mut start, mut end) = (place(&text, rng), place(&text, rng));
                if end < start {
                    std::mem::swap(&mut start, &mut end);
                }
                end = end.min(start + 40);
                let end = (start..=end).rev().find(|&at| text.is_char_boundary(at)).unwrap_or(start);
                text.replace_range(start..end, "");
            }
            4 => text.insert_str(place(&text, rng), PIECES[rng.usize(0..PIECES.len())]),
            // Numbers are references and identities.
            5 | 6 => {
                let digits: Vec<usize> = text.match_indices(|c: char| c.is_ascii_digit()).map(|(at, _)| at).collect();
                if !digits.is_empty() {
                    let at = digits[rng.usize(0..digits.len())];
                    text.replace_range(at..=at, ["0", "1", "2", "9", "-", "77"][rng.usize(0..6)]);
                }
            }
            _ => {
                let (from, to) = (WORDS[rng.usize(0..WORDS.len())], WORDS[rng.usize(0..WORDS.len())]);
                let places: Vec<usize> = text.match_indices(from).map(|(at, _)| at).collect();
                if !places.is_empty() {
                    let at = places[rng.usize(0..places.len())];
                    text.replace_range(at..at + from.len(), to);
                }
            }
        }
    }
    text
}

const PIECES: [&str; 12] =
    ["<", ">", "\"", "&", "&amp;", "&boom;", "<!-- ü -->", "<![CDATA[x]]>", "<steps/>", "ß", "\u{0}", "<!DOCTYPE x>"];

const WORDS: [&str; 24] = [
    "grafcet:Step",
    "EnclosingStep",
    "MacrostepExpansion",
    "PartialGrafcet",
    "terms:And",
    "terms:Not",
    "terms:Variable",
    "terms:Equality",
    "terms:IntegerConstant",
    "terms:BooleanConstant",
    "terms:Bool",
    "terms:Integer",
    "RisingEdge",
    "StoredAction",
    "ContinuousAction",
    "ForcingOrder",
    "steps",
    "transitions",
    "macrosteps",
    "synchronizations",
    "input",
    "output",
    "internal",
    "//@partialGrafcets.0",
];
