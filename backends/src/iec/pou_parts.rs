//! A function block and the program around it in parts, for targets that have a place for each.

use super::declarations::{self, Entry, VarBlock};
use super::frame;
use super::names::{Names, remark};
use crate::lines::Lines;
use ecow::EcoString;
use grafc_logic::scan::Program;

/// All parts.
pub(crate) struct PouParts {
    /// The name of the function block.
    pub block: EcoString,
    /// What it is, clean.
    pub description: Option<String>,
    /// Its variables.
    pub interface: Vec<VarBlock>,
    /// Its statements, and which lines of them come from what, if somebody asks.
    pub body: String,
    pub lines: Lines,
    /// The name of the program.
    pub program: EcoString,
    /// The variables of the program.
    pub program_variables: Vec<VarBlock>,
    /// The statements of the program, and their language.
    pub program_body: String,
    pub language: Language,
    /// Names for what runs the program.
    pub configuration: EcoString,
    pub resource: EcoString,
    pub task: EcoString,
    pub program_instance: EcoString,
}

/// The textual languages.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Language {
    St,
    Il,
}

impl Language {
    /// Its short name.
    pub fn name(self) -> &'static str {
        match self {
            Language::St => "ST",
            Language::Il => "IL",
        }
    }
}

impl PouParts {
    /// Puts the parts together; `more` are further values that live within one call.
    pub fn new(
        program: &Program,
        names: Names,
        language: Language,
        more: Vec<Entry>,
        body: String,
        program_body: String,
    ) -> Self {
        PouParts {
            description: remark(&program.name, &names.block, program.comment.as_deref()),
            interface: declarations::interface(program, &names, more),
            body,
            lines: Lines::default(),
            program_variables: frame::variables(program, &names),
            program_body,
            language,
            block: names.block,
            program: names.program,
            configuration: names.configuration,
            resource: names.resource,
            task: names.task,
            program_instance: names.program_instance,
        }
    }
}
