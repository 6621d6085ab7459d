//! Charts of other tools as `.gct` texts, with a report of what was changed, is doubtful or was lost.
//!
//! ```text
//! AGRAFE:       text ─ xml ─▶ elements ─ agrafe ─▶ model ─ chart ─▶ .gct text
//! PLCopen XML:  text ─ xml ─▶ elements ─ plcopen ┐
//! IEC 61131-3:  text ───────── iec_text ─────────┴▶ sfc ─ write ─▶ .gct text
//! KISS2:        text ─ kiss2 ─▶ table ─▶ .gct text
//! ```
//!
//! What is written is brought into the form that `grafc fmt` would give it. A folder a format: `agrafe` knows the
//! meta-model of that tool, `plcopen` the XML of PLCopen, `iec_text` the textual form of sequential function charts; none
//! of them knows our language. `kiss2` reads tables of automata, and says them in our language itself. `code` reads the languages of IEC 61131-3 that stand in charts, `chart` and `write` say in
//! our language what was read, and what does not fit; `xml` is of no format.
//!
//! The report is made of messages: W0701 changed, W0702 doubtful, W0703 lost. The file may come from anywhere, so all
//! walks are loops, nothing is quadratic, and what is kept and written grows with the file at most linearly.

mod agrafe;
mod chart;
mod code;
mod iec_text;
mod kiss2;
mod naming;
mod plcopen;
mod sfc;
mod write;
mod xml;

use grafc_diagnostics::{Code, Diagnostic, Diagnostics, FileId, Severity, Span};
use rustc_hash::FxHashSet;
use sfc::{Project, Unit};

/// Choices of the importer.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Options {
    /// Variables that are named like delays (`2s/X202`) and that nothing assigns become those delays.
    pub delays: bool,
    /// Whose meaning of sequential function charts counts; none: that of the tool that the file names.
    pub dialect: Option<Dialect>,
    /// The only program organisation unit that is wanted.
    pub unit: Option<String>,
}

/// Meanings of sequential function charts that differ.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Dialect {
    /// IEC 61131-3 as MATIEC has it, which compiles for Beremiz and OpenPLC.
    Iec,
    /// CODESYS and TwinCAT: the leftmost of several transitions, and actions once more when their step ends.
    Codesys,
    /// ISaGRAF.
    Isagraf,
}

/// A chart that was imported.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Imported {
    /// The name of its program organisation unit; of other formats that of the chart, if it has one.
    pub name: String,
    /// Its text.
    pub text: String,
}

/// The chart in canonical format, if no message is an error. Of several charts one has to be named.
pub fn import(file: FileId, text: &str, options: &Options) -> (Option<String>, Diagnostics) {
    let (mut charts, mut diagnostics) = import_all(file, text, options);
    if charts.len() > 1 {
        let names: Vec<String> = charts.iter().map(|chart| format!("`{}`", chart.name)).collect();
        diagnostics.push(
            Diagnostic::new(Code::E0706, Span::new(file, 0, 0), format!("the file has {} charts", charts.len()))
                .note(format!("they are {}", names.join(", ")))
                .help("name one with `--pou NAME`, or a folder for all with `--output FOLDER/`"),
        );
    }
    let chart = charts.pop().filter(|_| !diagnostics.has_errors());
    (chart.map(|chart| chart.text), diagnostics)
}

/// All charts of a file in canonical format; none if a message is an error.
pub fn import_all(file: FileId, text: &str, options: &Options) -> (Vec<Imported>, Diagnostics) {
    let mut diagnostics = Diagnostics::new();
    let begins = text.trim_start_matches(|c: char| c == '\u{FEFF}' || c.is_ascii_whitespace());
    let limit = text.len().saturating_mul(GROWTH).saturating_add(SMALL);
    let charts = if begins.is_empty() || begins.starts_with('<') {
        let Some(document) = xml::read(file, text, &mut diagnostics) else { return (Vec::new(), diagnostics) };
        if document.elements[xml::ElementId::new(0)].name == "project" {
            let project = plcopen::read(&document, text, &mut diagnostics);
            charts_of(&project, document.root_span(), limit, options, &mut diagnostics)
        } else {
            let model = agrafe::read(&document, &mut diagnostics);
            if model.is_none() {
                diagnostics.push(unknown(&document));
            }
            let model = model.filter(|_| !diagnostics.has_errors());
            let written = model.and_then(|model| {
                let written = chart::write(&model, &document, options, limit, &mut diagnostics);
                written.map(|text| (model.name.clone().unwrap_or_default(), document.root_span(), text))
            });
            written.into_iter().collect()
        }
    } else if kiss2::is_kiss2(text) {
        let table = kiss2::read(file, text, &mut diagnostics);
        let limit = text.len().saturating_mul(GROWTH_OF_TABLES).saturating_add(SMALL);
        let is_right = !diagnostics.has_errors();
        let written = is_right.then(|| kiss2::write(&table, limit, &mut diagnostics)).flatten();
        written.into_iter().map(|text| ("Machine".to_owned(), table.span, text)).collect()
    } else {
        // Its first character.
        let whole = Span::new(file, 0, text.chars().next().map_or(0, char::len_utf8));
        let project = iec_text::read(file, text, &mut diagnostics);
        charts_of(&project, whole, limit, options, &mut diagnostics)
    };
    let mut found = Vec::new();
    for (name, span, written) in charts {
        found.extend(formatted(file, &written, span, &mut diagnostics).map(|text| Imported { name, text }));
    }
    if diagnostics.has_errors() {
        found.clear();
    }
    (found, diagnostics)
}

/// The error on a document that is of no tool whose files are read.
fn unknown(document: &xml::Document) -> Diagnostic {
    let element = &document.elements[xml::ElementId::new(0)].name;
    let help = match element.as_str() {
        "TcPlcObject" => {
            "let TwinCAT write PLCopen XML: `Export PLCopen XML…` in the context menu of the object in the PLC project"
        }
        _ => "let the tool write PLCopen XML; of AGRAFE give the model, a file `*.grafcet`",
    };
    Diagnostic::new(
        Code::E0703,
        document.root_span(),
        format!("a file that begins with `{element}` is none that is read"),
    )
    .note("PLCopen XML begins with `project`, a chart of AGRAFE with `grafcet:Grafcet`")
    .help(help)
}

/// The texts of the units that have charts, with their names and places.
fn charts_of(
    project: &Project,
    whole: Span,
    limit: usize,
    options: &Options,
    diagnostics: &mut Diagnostics,
) -> Vec<(String, Span, String)> {
    if diagnostics.has_errors() {
        return Vec::new();
    }
    let has_steps = |unit: &Unit| unit.charts().any(|chart| !chart.steps.is_empty());
    let with_charts: Vec<usize> = (0..project.units.len()).filter(|&unit| has_steps(&project.units[unit])).collect();
    let name = |unit: usize| project.units[unit].name.as_str();
    let wanted = |unit: &usize| options.unit.as_deref().is_none_or(|wanted| name(*unit).eq_ignore_ascii_case(wanted));
    let chosen: Vec<usize> = with_charts.iter().copied().filter(wanted).collect();
    if chosen.is_empty() {
        let message = match &options.unit {
            Some(wanted) => format!("no program organisation unit `{wanted}` has a sequential function chart"),
            None => "there is no sequential function chart in the file".to_string(),
        };
        let names: Vec<String> = with_charts.iter().map(|&unit| format!("`{}`", name(unit))).collect();
        let mut fault = Diagnostic::new(Code::E0703, whole, message);
        if !names.is_empty() {
            fault = fault.note(format!("those with charts are {}", names.join(", ")));
        }
        diagnostics
            .push(fault.help("give a file in which a program or a function block is drawn as steps and transitions"));
        return Vec::new();
    }
    let dialect = options.dialect.unwrap_or_else(|| dialect_of(project));
    // A program that another one commands is a part of its chart.
    let roots = write::roots(project, dialect, &chosen);
    let first: FxHashSet<usize> = roots.iter().copied().collect();
    let others = chosen.iter().copied().filter(|unit| !first.contains(unit));
    let mut children = FxHashSet::default();
    let mut texts = Vec::new();
    for unit in roots.iter().copied().chain(others) {
        if !children.contains(&unit) {
            let written = write::write(project, unit, dialect, limit, &mut children, diagnostics);
            texts.extend(written.map(|text| (unit, text)));
        }
    }
    texts.sort_by_key(|(unit, _)| *unit);
    texts.into_iter().map(|(unit, text)| (name(unit).to_string(), project.units[unit].span, text)).collect()
}

/// The meaning that the tool has which wrote a file.
fn dialect_of(project: &Project) -> Dialect {
    let product = project.product.as_deref().unwrap_or_default().to_ascii_uppercase();
    match product.as_str() {
        _ if ["CODESYS", "TWINCAT", "MACHINE EXPERT", "CTRLX"].iter().any(|name| product.contains(name)) => {
            Dialect::Codesys
        }
        _ if product.contains("ISAGRAF") => Dialect::Isagraf,
        _ => Dialect::Iec,
    }
}

/// What comes out must at least be a text of ours, whatever came in.
fn formatted(file: FileId, written: &str, span: Span, diagnostics: &mut Diagnostics) -> Option<String> {
    let (tree, found) = grafc_syntax::parse(file, written);
    if let Some(fault) = found.iter().find(|fault| fault.code.severity() == Severity::Error) {
        let at = written[..fault.primary.span.range().start].rfind('\n').map_or(0, |at| at + 1);
        let line = written[at..].lines().next().unwrap_or_default();
        diagnostics.push(
            Diagnostic::new(Code::E0901, span, "this is a fault of grafc: the import is not a chart")
                .note(format!("the line `{line}` would give: {}", fault.message))
                .help(concat!("please report it, with the file, at ", env!("CARGO_PKG_REPOSITORY"))),
        );
        return None;
    }
    Some(grafc_syntax::format(written, &tree))
}

/// How much longer than its file a chart may be. XMI says everything at greater length, so only a file that repeats
/// itself by reference comes near to it: thousands of transitions behind one synchronisation of thousands of steps.
const GROWTH: usize = 4;

/// The same of a table: what is a sign there is a name here, in each row and in rows that exclude it.
const GROWTH_OF_TABLES: usize = 100;

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
