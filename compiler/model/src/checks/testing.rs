//! What the tests of the rules share.

use grafc_diagnostics::{Diagnostics, FileId, Severity, apply};

/// The codes of all messages on a chart but those on names that are not used: the charts of most tests declare more than
/// they use.
pub fn codes(text: &str) -> Vec<&'static str> {
    let mut codes = all_codes(text);
    codes.retain(|code| !matches!(*code, "W0419" | "W0420"));
    codes
}

/// The codes of all messages on a chart.
pub fn all_codes(text: &str) -> Vec<&'static str> {
    let (tree, mut diagnostics) = grafc_syntax::parse(FileId::new(0), text);
    let (chart, more) = crate::check(&tree, "test");
    diagnostics.append(more);
    assert_eq!(
        chart.is_some(),
        !diagnostics.has_errors(),
        "a chart comes out if and only if nothing is wrong: {diagnostics:#?}"
    );
    try_fixes(text, &diagnostics);
    diagnostics.iter().map(|diagnostic| diagnostic.code.as_str()).collect()
}

/// Each fix takes away its fault, and brings no other error.
fn try_fixes(text: &str, found: &Diagnostics) {
    for diagnostic in found {
        for fix in &diagnostic.fixes {
            let fixed =
                apply(FileId::new(0), text, &fix.edits).unwrap_or_else(|misfit| panic!("{misfit}: {fix:?}\n{text}"));
            let mut left: Vec<&str> = found.iter().map(|other| other.message.as_str()).collect();
            left.remove(left.iter().position(|message| *message == diagnostic.message).expect("it is among them"));
            let (tree, mut now) = grafc_syntax::parse(FileId::new(0), &fixed);
            now.append(crate::check(&tree, "test").1);
            for new in now.iter().filter(|new| new.code.severity() == Severity::Error) {
                match left.iter().position(|message| *message == new.message) {
                    Some(place) => _ = left.remove(place),
                    None => panic!("{fix:?} brings {:?}\n{text}\n{fixed}", new.message),
                }
            }
        }
    }
}

/// The chart breaks this rule once, and no other.
pub fn breaks(code: &str, text: &str) {
    assert_eq!(codes(text), [code], "{text}");
}

/// The chart gets these messages, in order of place.
pub fn breaks_all(expected: &[&str], text: &str) {
    assert_eq!(codes(text), expected, "{text}");
}

/// There is no message on the chart.
pub fn passes(text: &str) {
    breaks_all(&[], text);
}

/// There are these warnings on the chart and no other message.
pub fn passes_with(warnings: &[&str], text: &str) {
    let severity = |code: &&str| grafc_diagnostics::Code::parse(code).map(|code| code.severity());
    assert!(warnings.iter().all(|code| severity(code) == Some(Severity::Warning)), "{warnings:?} are warnings");
    breaks_all(warnings, text);
}

/// The only help that is given on a chart.
pub fn help(text: &str) -> Option<String> {
    let (tree, _) = grafc_syntax::parse(FileId::new(0), text);
    let (_, diagnostics) = crate::check(&tree, "test");
    try_fixes(text, &diagnostics);
    let told = diagnostics.iter().filter(|d| !matches!(d.code.as_str(), "W0419" | "W0420"));
    let helps: Vec<String> = told.filter_map(|diagnostic| diagnostic.help.clone()).collect();
    assert!(helps.len() <= 1, "{helps:?}");
    helps.into_iter().next()
}

/// The other places of the only message on a chart, each with what is said there.
pub fn labels(text: &str) -> Vec<String> {
    let (tree, _) = grafc_syntax::parse(FileId::new(0), text);
    let (_, mut diagnostics) = crate::check(&tree, "test");
    diagnostics.retain(|d| !matches!(d.code.as_str(), "W0419" | "W0420"));
    labels_in(text, &diagnostics)
}

/// The other places of the only message on a chart, whatever it is about.
pub fn labels_of(text: &str) -> Vec<String> {
    let (tree, _) = grafc_syntax::parse(FileId::new(0), text);
    labels_in(text, &crate::check(&tree, "test").1)
}

fn labels_in(text: &str, diagnostics: &Diagnostics) -> Vec<String> {
    assert_eq!(diagnostics.iter().count(), 1, "{diagnostics:#?}");
    let labels = diagnostics.iter().flat_map(|diagnostic| &diagnostic.secondary);
    labels
        .map(|label| format!("{}: {}", &text[label.span.start as usize..label.span.end as usize], label.text))
        .collect()
}

/// A chart in which nothing is wrong.
pub fn chart(text: &str) -> crate::chart::Chart {
    let (tree, diagnostics) = grafc_syntax::parse(FileId::new(0), text);
    assert!(!diagnostics.has_errors(), "{diagnostics:#?}");
    let (chart, diagnostics) = crate::check(&tree, "test");
    chart.unwrap_or_else(|| panic!("{diagnostics:#?}"))
}
