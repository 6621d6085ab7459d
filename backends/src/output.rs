//! What a target is made of, and what comes out.

use grafc_diagnostics::Diagnostics;
use grafc_logic::scan::Program;
use grafc_logic::sequence::Sequence;

/// What a target may ask for. Each is the result of a stage with messages of its own, so a target asks for what it
/// writes and for nothing else.
///
/// The error is what the stage said, if one of its messages is an error.
pub trait Source {
    /// The scan program.
    fn program(&mut self) -> Result<&Program, Diagnostics>;

    /// The chart as a sequential function chart.
    fn sequence(&mut self) -> Result<&Sequence, Diagnostics>;
}

/// What a target has made.
#[derive(Clone, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub struct Output {
    /// The text of the file.
    pub text: String,
}

impl From<String> for Output {
    fn from(text: String) -> Self {
        Output { text }
    }
}
