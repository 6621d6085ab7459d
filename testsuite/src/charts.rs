//! Charts that are kept as three files: `NAME.gct`, `NAME.trace.csv` and `NAME.expected.csv`.
//!
//! The expectation is derived by hand from the rules of `docs/semantics.md`, never taken from a run. A first line
//! `// test: evolution=scan initial-actions=off bound=50` sets the profile. With `encodings=all` in it the r- and
//! s-trigger must do what is expected, too: a chart in which no transition leads from step to step has no overlap.

use crate::ways;
use grafc_diagnostics::{Diagnostics, FileId};
use grafc_logic::{Encoding, Options};
use grafc_model::chart::Chart;
use grafc_model::reaction::{Evolution, LivelockOutputs, Profile, Response, Stimulus};
use std::path::{Path, PathBuf};

/// A chart, what is done to it and what it must do.
pub struct Case {
    /// The name of its files.
    pub name: String,
    /// The chart.
    pub text: String,
    /// The inputs.
    pub trace: String,
    /// The outputs, situations and flags.
    pub expected: String,
    /// How it runs.
    pub profile: Profile,
    /// Whether the encodings whose steps overlap must do what is expected, too.
    pub overlapping: bool,
}

impl Case {
    /// The encodings that must do what is expected.
    pub fn encodings(&self) -> impl Iterator<Item = Encoding> + use<> {
        let overlapping = self.overlapping;
        Encoding::ALL.into_iter().filter(move |encoding| overlapping || !encoding.overlaps())
    }

    /// All ways to lower the chart that must do what is expected, with a name each.
    pub fn ways(&self) -> Vec<(String, Options)> {
        ways::ways(self.profile, self.encodings())
    }
}

/// The folder of the example charts.
pub fn charts_folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("charts")
}

/// The folder of the test vectors.
pub fn vectors_folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("vectors")
}

/// All cases of a folder, by name.
///
/// # Panics
/// If the folder cannot be read, if a chart lacks its trace or its expectation, or if either lacks its chart.
pub fn cases(folder: &Path) -> Vec<Case> {
    let mut names: Vec<String> = std::fs::read_dir(folder)
        .unwrap_or_else(|e| panic!("{}: {e}", folder.display()))
        .filter_map(|entry| entry.ok()?.file_name().into_string().ok())
        .filter_map(|file| {
            [".gct", ".trace.csv", ".expected.csv"].iter().find_map(|end| file.strip_suffix(end)).map(str::to_string)
        })
        .collect();
    names.sort();
    names.dedup();
    names.into_iter().map(|name| case(folder, name)).collect()
}

/// The charts that restate what people of the trade asked, reported or were taught: a folder each, by name.
///
/// # Panics
/// If a folder lacks one of its files.
pub fn field_cases() -> Vec<Case> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("cases");
    let mut names: Vec<String> = std::fs::read_dir(&folder)
        .unwrap_or_else(|e| panic!("{}: {e}", folder.display()))
        .filter_map(|entry| entry.ok()?.file_name().into_string().ok())
        .collect();
    names.sort();
    names.into_iter().map(|name| read(&folder.join(&name), name, ["chart.gct", "trace.csv", "expected.csv"])).collect()
}

fn case(folder: &Path, name: String) -> Case {
    let files = [".gct", ".trace.csv", ".expected.csv"].map(|end| format!("{name}{end}"));
    read(folder, name, files)
}

fn read(folder: &Path, name: String, files: [impl AsRef<Path>; 3]) -> Case {
    let [text, trace, expected] = files.map(|file| {
        let path = folder.join(file);
        std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
    });
    let (profile, overlapping) = asked_for(&text);
    Case { text, trace, expected, profile, overlapping, name }
}

/// What the first line of a chart asks for: the profile, and whether all encodings are meant.
///
/// # Panics
/// If it asks for something unknown: a test would silently test something else.
fn asked_for(text: &str) -> (Profile, bool) {
    let (mut profile, mut overlapping) = (Profile::default(), false);
    let first = text.lines().next().unwrap_or_default();
    for word in first.strip_prefix("// test:").unwrap_or_default().split_whitespace() {
        match word.split_once('=') {
            Some(("evolution", "stable")) => profile.evolution = Evolution::Stable,
            Some(("evolution", "scan")) => profile.evolution = Evolution::Scan,
            Some(("initial-actions", "on")) => profile.initial_actions = true,
            Some(("initial-actions", "off")) => profile.initial_actions = false,
            Some(("encodings", "all")) => overlapping = true,
            Some(("livelock-outputs", "computed")) => profile.livelock_outputs = LivelockOutputs::Computed,
            Some(("livelock-outputs", "hold")) => profile.livelock_outputs = LivelockOutputs::Hold,
            Some(("livelock-outputs", "off")) => profile.livelock_outputs = LivelockOutputs::Off,
            Some(("bound", number)) => profile.bound = Some(number.parse().expect("a number after `bound=`")),
            Some(_) | None => panic!("`// test:` does not know `{word}`"),
        }
    }
    (profile, overlapping)
}

/// The line that asks for a profile, as it is read with a case.
pub fn profile_line(profile: Profile) -> String {
    let evolution = match profile.evolution {
        Evolution::Stable => "stable",
        Evolution::Scan => "scan",
    };
    let initial = if profile.initial_actions { "on" } else { "off" };
    let bound = profile.bound.map(|k| format!(" bound={k}")).unwrap_or_default();
    let outputs = match profile.livelock_outputs {
        LivelockOutputs::Computed => "",
        LivelockOutputs::Hold => " livelock-outputs=hold",
        LivelockOutputs::Off => " livelock-outputs=off",
    };
    format!("// test: evolution={evolution} initial-actions={initial}{bound}{outputs}")
}

/// The checked chart of a text, or its messages as a person would read them.
pub fn check(name: &str, text: &str) -> Result<Chart, String> {
    let (tree, mut diagnostics) = grafc_syntax::parse(FileId::default(), text);
    if diagnostics.has_errors() {
        return Err(render(name, text, &diagnostics));
    }
    let (chart, more) = grafc_model::check(&tree, name);
    diagnostics.append(more);
    chart.ok_or_else(|| render(name, text, &diagnostics))
}

/// The stimuli of a trace.
pub fn stimuli(name: &str, trace: &str, chart: &Chart) -> Result<Vec<Stimulus>, String> {
    let (stimuli, diagnostics) = grafc_model::trace::parse_trace(FileId::default(), trace, chart);
    if diagnostics.has_errors() { Err(render(name, trace, &diagnostics)) } else { Ok(stimuli) }
}

/// The responses of a chart as the expectation spells them.
pub fn spell(chart: &Chart, stimuli: &[Stimulus], responses: &[Response]) -> String {
    grafc_model::trace::write_trace(chart, stimuli, responses)
}

/// Whether nothing in it stands above something else: no enclosures, no orders.
pub fn is_flat(chart: &Chart) -> bool {
    chart.orders.is_empty() && chart.grafcets.iter().all(|g| g.enclosing_step.is_none())
}

/// Messages as a person would read them.
pub fn render(name: &str, text: &str, diagnostics: &Diagnostics) -> String {
    let mut out = String::new();
    for one in diagnostics {
        let before = &text.as_bytes()[..(one.primary.span.start as usize).min(text.len())];
        let line = before.iter().filter(|&&b| b == b'\n').count() + 1;
        out.push_str(&format!("{name}:{line}: {}: {}\n", one.code.as_str(), one.message));
    }
    out
}
