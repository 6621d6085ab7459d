//! The canonical format.

use grafc_diagnostics::{Code, Diagnostic, Diagnostics, FileId, Span};
use grafc_syntax::same;

/// The text in canonical format, if it can be parsed.
pub fn format(file: FileId, text: &str) -> (Option<String>, Diagnostics) {
    let (tree, mut diagnostics) = grafc_syntax::parse(file, text);
    if diagnostics.has_errors() {
        return (None, diagnostics);
    }
    let formatted = grafc_syntax::format(text, &tree);
    // An author's only copy may be at stake: what comes out must be the same chart.
    let (again, found) = grafc_syntax::parse(file, &formatted);
    if found.has_errors() || !same(&tree, &again) {
        let place = Span::new(file, 0, 0);
        diagnostics.push(
            Diagnostic::new(Code::E0901, place, "this is a fault of grafc: formatting would change the chart")
                .note("the chart is left as it was")
                .help(concat!("please report it, with the chart, at ", env!("CARGO_PKG_REPOSITORY"))),
        );
        return (None, diagnostics);
    }
    (Some(formatted), diagnostics)
}
