//! Deliberate faults of the compiler, to see whether the suite would notice.
//!
//! A fault is a text that occurs once in one file of the compiler, and what would stand there if the compiler had the
//! fault. The project's own files know nothing of it: all faults are put into a copy of the workspace, each beside the
//! right text, and an environment variable chooses the one that a run has. So the copy is built once, and a fault costs
//! no more than the tests that it makes fail.
//!
//! The texts are expressions or whole statements; `testsuite/tests/mutants.rs` sees to it that each is still there.
//! `cargo run --release -p grafc-testsuite --bin mutants` tries them all.

mod backends;
mod bodies;
mod encodings;
mod lowering;
mod net;
mod proofs;
pub mod run;
pub mod workspace;

use std::collections::BTreeMap;
use std::path::Path;

/// Names the fault of a run.
pub const VARIABLE: &str = "GRAFC_FAULT";

/// One deliberate fault.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Fault {
    /// Its name, unique.
    pub name: &'static str,
    /// The file, from the root of the workspace.
    pub file: &'static str,
    /// What goes wrong, and the rule of `docs/semantics.md` that is broken.
    pub breaks: &'static str,
    /// An expression, or statements with their semicolons; it occurs once in the file.
    pub text: &'static str,
    /// What stands there instead; nothing for statements that are left out.
    pub instead: &'static str,
}

/// All of them, along the way of a chart through the compiler.
pub fn all() -> impl Iterator<Item = &'static Fault> {
    let files = [net::FAULTS, lowering::FAULTS, encodings::FAULTS, proofs::FAULTS, backends::FAULTS, bodies::FAULTS];
    files.into_iter().flatten()
}

impl Fault {
    /// Where the text is in the file; an error unless it occurs there once.
    pub fn place(&self, content: &str) -> Result<usize, String> {
        let mut places = content.match_indices(self.text).map(|(place, _)| place);
        match (places.next(), places.next()) {
            (Some(place), None) => Ok(place),
            (None, _) => Err(format!("`{}`: its text is not in {}", self.name, self.file)),
            (Some(_), Some(_)) => Err(format!("`{}`: its text occurs more than once in {}", self.name, self.file)),
        }
    }

    /// Both texts, and the choice between them.
    fn both(&self) -> String {
        let Fault { name, text, instead, .. } = self;
        let chosen = format!(
            "{{ static CHOSEN: std::sync::LazyLock<bool> = \
             std::sync::LazyLock::new(|| std::env::var({VARIABLE:?}).is_ok_and(|name| name == {name:?})); *CHOSEN }}"
        );
        if text.ends_with(';') {
            format!("if {chosen} {{ {instead} }} else {{ {text} }}")
        } else {
            format!("(if {chosen} {{ {instead} }} else {{ {text} }})")
        }
    }
}

/// The content of a file with all its faults put in.
pub fn with_faults(file: &str, content: &str) -> Result<String, String> {
    let mut places: BTreeMap<usize, &Fault> = BTreeMap::new();
    for fault in all().filter(|fault| fault.file == file) {
        if let Some(other) = places.insert(fault.place(content)?, fault) {
            return Err(format!("`{}` and `{}` are at the same place of {file}", fault.name, other.name));
        }
    }
    let mut out = String::new();
    let mut done = 0;
    for (place, fault) in places {
        let between = content.get(done..place).ok_or_else(|| format!("`{}` overlaps another fault", fault.name))?;
        out.push_str(between);
        out.push_str(&fault.both());
        done = place + fault.text.len();
    }
    out.push_str(&content[done..]);
    Ok(out)
}

/// Checks that every fault still applies to the workspace; what does not, line by line.
pub fn faults_that_do_not_apply(root: &Path) -> Vec<String> {
    let mut complaints = Vec::new();
    let mut files: BTreeMap<&str, &Fault> = BTreeMap::new();
    for fault in all() {
        files.entry(fault.file).or_insert(fault);
    }
    for file in files.into_keys() {
        match std::fs::read_to_string(root.join(file)) {
            Err(error) => complaints.push(format!("{file}: {error}")),
            Ok(content) => complaints.extend(with_faults(file, &content).err()),
        }
    }
    complaints
}
