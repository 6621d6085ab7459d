//! Charts of other tools as `.gct` texts, with a report of what was changed, is doubtful or was lost.
//!
//! ```text
//! text ─ xml ─▶ elements ─ agrafe ─▶ model ─ chart ─▶ .gct text ─ format ─▶ the text that `grafc fmt` would give
//! ```
//!
//! One dialect so far: the XMI of AGRAFE, `*.grafcet`. `agrafe` knows its meta-model and nothing of our language;
//! `chart` writes a model in our language and says what does not fit; `xml` is of no dialect.
//!
//! The report is made of messages: W0701 changed, W0702 doubtful, W0703 lost. The file may come from anywhere, so all
//! walks are loops, nothing is quadratic, and what is kept and written grows with the file at most linearly.

mod agrafe;
mod chart;
mod xml;

use grafc_diagnostics::{Code, Diagnostic, Diagnostics, FileId, Severity, Span};

/// Choices of the importer.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Options {
    /// Variables that are named like delays (`2s/X202`) and that nothing assigns become those delays.
    pub delays: bool,
}

/// The chart in canonical format, if no message is an error.
pub fn import(file: FileId, text: &str, options: Options) -> (Option<String>, Diagnostics) {
    let mut diagnostics = Diagnostics::new();
    let Some(document) = xml::read(file, text, &mut diagnostics) else { return (None, diagnostics) };
    let model = agrafe::read(&document, &mut diagnostics);
    let Some(model) = model.filter(|_| !diagnostics.has_errors()) else { return (None, diagnostics) };
    let limit = text.len().saturating_mul(GROWTH).saturating_add(SMALL);
    let Some(written) = chart::write(&model, &document, options, limit, &mut diagnostics) else {
        return (None, diagnostics);
    };
    // What comes out must at least be a text of ours, whatever came in.
    let (tree, found) = grafc_syntax::parse(file, &written);
    if let Some(fault) = found.iter().find(|fault| fault.code.severity() == Severity::Error) {
        let at = written[..fault.primary.span.range().start].rfind('\n').map_or(0, |at| at + 1);
        let line = written[at..].lines().next().unwrap_or_default();
        diagnostics.push(
            Diagnostic::new(Code::E0901, document.root_span(), "this is a fault of grafc: the import is not a chart")
                .note(format!("the line `{line}` would give: {}", fault.message))
                .help(concat!("please report it, with the file, at ", env!("CARGO_PKG_REPOSITORY"))),
        );
        return (None, diagnostics);
    }
    (Some(grafc_syntax::format(&written, &tree)), diagnostics)
}

/// How much longer than its file a chart may be. XMI says everything at greater length, so only a file that repeats
/// itself by reference comes near to it: thousands of transitions behind one synchronisation of thousands of steps.
const GROWTH: usize = 4;

/// What small files may have beyond that.
const SMALL: usize = 64 * 1024;

/// The report: something differs from the file but means the same.
fn changed(span: Span, message: impl Into<String>) -> Diagnostic {
    Diagnostic::new(Code::W0701, span, message)
}

/// The report: the file does not say for certain what is meant.
fn doubtful(span: Span, message: impl Into<String>) -> Diagnostic {
    Diagnostic::new(Code::W0702, span, message)
}

/// The report: something is in the file and not in the chart.
fn lost(span: Span, message: impl Into<String>) -> Diagnostic {
    Diagnostic::new(Code::W0703, span, message)
}
