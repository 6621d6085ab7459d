//! Deliberate faults of the compiler, to see whether the suite would notice.
//!
//! A fault is a text of the compiler, and what would stand there if the compiler had the fault. The project's own files
//! know nothing of it: all faults are put into a copy of the workspace, each beside the right text, and an environment
//! variable chooses the one that a run has. So the copy is built once, and a fault costs no more than the tests that it
//! makes fail.
//!
//! A switch in the compiler itself (`cfg` around a right and a wrong line) would not hang on texts. It would put two
//! hundred wrong lines between the right ones, inside conditions and arguments, where rustfmt does not look and where a
//! reader must tell them apart each time. So a fault stays a text, but one that hangs on as little as possible
//! (`spot`): tokens, not characters; in any file of a part of the compiler; in a function only where the text is in
//! several; under other names of local variables, if need be. Code can be moved, laid out and renamed in this way without
//! a change here. A line that is written differently needs its fault written differently: `testsuite/tests/suite/mutants.rs`
//! says at once which fault has no place any more. `cargo run --release -p grafc-testsuite --bin mutants` tries them
//! all.

mod automata;
mod backends;
mod bodies;
mod c;
mod calls;
mod encodings;
mod javascript;
mod lowering;
mod net;
mod proofs;
mod prover;
pub mod run;
pub mod spot;
mod tokens;
mod warnings;
pub mod workspace;

use spot::{Index, Source, Spot, sources};
use std::collections::BTreeMap;
use std::path::Path;

/// Names the fault of a run.
pub const VARIABLE: &str = "GRAFC_FAULT";

/// A part of the compiler that has tests of its own.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Part {
    /// What comes before the backends, and is judged by the simulator.
    Compiler,
    /// What proves claims on charts.
    Prover,
    /// Automata: as blocks of the language, and as what charts are.
    Automata,
    /// The evaluation of 64 scenarios at once.
    Lanes,
    /// Structured Text.
    StructuredText,
    /// Instruction lists.
    InstructionList,
    /// The statement list of STEP 7.
    StatementList,
    /// Ladder diagrams.
    Ladder,
    /// Sequential function charts.
    Chart,
    /// What gives saved memory back, which only targets that save it show.
    Restoring,
    /// Rust.
    Rust,
    /// JavaScript.
    JavaScript,
    /// C.
    C,
    /// What backends share.
    Shared,
    /// What the languages with braces share.
    Braces,
}

impl Part {
    /// All of them.
    pub const ALL: [Part; 15] = [
        Part::Compiler,
        Part::Prover,
        Part::Automata,
        Part::Lanes,
        Part::StructuredText,
        Part::InstructionList,
        Part::StatementList,
        Part::Ladder,
        Part::Chart,
        Part::Restoring,
        Part::Rust,
        Part::JavaScript,
        Part::C,
        Part::Shared,
        Part::Braces,
    ];

    /// Where it lies, from the root of the workspace.
    pub fn folders(self) -> &'static [&'static str] {
        match self {
            Part::Compiler => &["compiler/net/src", "compiler/formula/src", "compiler/logic/src"],
            Part::Prover => &["compiler/verify/src"],
            Part::Automata => &["compiler/model/src/resolve", "compiler/automata/src"],
            Part::Lanes => &["compiler/lanes/src"],
            Part::StructuredText => &["backends/src/st"],
            Part::InstructionList => &["backends/src/il"],
            Part::StatementList => &["backends/src/awl"],
            Part::Ladder => &["backends/src/plcopen/ld"],
            Part::Chart => &[
                "compiler/logic/src/sequence",
                "backends/src/plcopen/sfc",
                "backends/src/sequence",
                "backends/src/sfc",
            ],
            Part::Restoring => &["compiler/logic/src"],
            Part::Rust => &["backends/src/rust"],
            Part::JavaScript => &["backends/src/js"],
            Part::C => &["backends/src/c"],
            Part::Shared | Part::Braces => &["backends/src"],
        }
    }
}

/// Where the text of a fault is looked for.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct At {
    /// The part of the compiler.
    pub part: Part,
    /// The function, where the text is in several.
    pub within: Option<&'static str>,
}

impl At {
    const fn anywhere(part: Part) -> At {
        At { part, within: None }
    }

    const fn within(self, function: &'static str) -> At {
        At { within: Some(function), ..self }
    }
}

/// One deliberate fault.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Fault {
    /// Its name, unique.
    pub name: &'static str,
    /// Where its text is looked for.
    pub at: At,
    /// What goes wrong, and the rule of `docs/semantics.md` that is broken.
    pub breaks: &'static str,
    /// An expression, or statements with their semicolons.
    pub text: &'static str,
    /// What stands there instead; nothing for statements that are left out.
    pub instead: &'static str,
}

/// All of them, along the way of a chart through the compiler.
pub fn all() -> impl Iterator<Item = &'static Fault> {
    let compiler = [
        net::FAULTS,
        lowering::FAULTS,
        encodings::FAULTS,
        proofs::FAULTS,
        warnings::FAULTS,
        prover::FAULTS,
        automata::FAULTS,
    ];
    compiler
        .into_iter()
        .chain([backends::FAULTS, bodies::FAULTS, calls::FAULTS, javascript::FAULTS, c::FAULTS])
        .flatten()
}

impl Fault {
    /// Both texts, and the choice between them.
    fn both(&self, text: &str, instead: &str) -> String {
        let name = self.name;
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

/// What was found in the workspace.
pub struct Places {
    /// The place of each fault that has one, file by file from the top.
    pub found: Vec<(&'static Fault, Spot)>,
    /// What is wrong with the others.
    pub complaints: Vec<String>,
}

/// The place of each fault in the workspace.
///
/// # Errors
/// What cannot be read.
pub fn places(root: &Path) -> Result<Places, String> {
    let (mut found, mut complaints) = (Vec::<(&Fault, Spot)>::new(), Vec::new());
    for part in Part::ALL {
        let sources: Vec<Source> = sources(root, part)?;
        let index = Index::new(&sources);
        for fault in all().filter(|fault| fault.at.part == part) {
            match index.place(fault) {
                Ok(place) => found.push((fault, place)),
                Err(said) => complaints.push(said),
            }
        }
    }
    found.sort_by(|(_, a), (_, b)| (&a.file, a.range.start).cmp(&(&b.file, b.range.start)));
    for pair in found.windows(2) {
        let ((one, a), (other, b)) = (&pair[0], &pair[1]);
        if a.file == b.file && b.range.start < a.range.end {
            complaints.push(format!("`{}` and `{}` are at the same place of {}", one.name, other.name, a.file));
        }
    }
    Ok(Places { found, complaints })
}

/// The contents of all files that have faults, with all their faults put in.
///
/// # Errors
/// What cannot be read, and which faults have no place.
pub fn faulty_files(root: &Path) -> Result<BTreeMap<String, String>, String> {
    let Places { found, complaints } = places(root)?;
    if !complaints.is_empty() {
        return Err(complaints.join("\n"));
    }
    let mut files: BTreeMap<String, String> = BTreeMap::new();
    // From the end of each file, so that what is left to do stays where it is.
    for (fault, Spot { file, range, instead }) in found.iter().rev() {
        if !files.contains_key(file) {
            let content = std::fs::read_to_string(root.join(file)).map_err(|error| format!("{file}: {error}"))?;
            files.insert(file.clone(), content);
        }
        if let Some(content) = files.get_mut(file) {
            let both = fault.both(&content[range.clone()], instead);
            content.replace_range(range.clone(), &both);
        }
    }
    Ok(files)
}
