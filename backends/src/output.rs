//! What a target is made of, and what comes out.

use crate::lines::Lines;
use crate::map::Map;
use grafc_diagnostics::Diagnostics;
use grafc_logic::scan::{Observed, Program};
use grafc_logic::sequence::Sequence;

/// What a target may ask for. Each is the result of a stage with messages of its own, so a target asks for what it
/// writes and for nothing else; whoever writes both asks for the sequence first.
///
/// The error is what the stage said, if one of its messages is an error.
pub trait Source {
    /// The scan program.
    fn program(&mut self) -> Result<&Program, Diagnostics>;

    /// The scan program with what gives saved memory back; a target asks for one of these.
    fn saved_program(&mut self) -> Result<&Program, Diagnostics>;

    /// The same, and what is shown of micro-steps.
    fn observed_program(&mut self, observed: Observed) -> Result<&Program, Diagnostics>;

    /// The chart as a sequential function chart.
    fn sequence(&mut self) -> Result<&Sequence, Diagnostics>;

    /// Whether somebody asks which lines come from which element of the chart.
    fn wants_map(&self) -> bool {
        false
    }
}

/// What a target has made.
#[derive(Clone, PartialEq, Eq, Debug)]
#[non_exhaustive]
pub struct Output {
    /// The text of the file.
    pub text: String,
    /// Which lines of it come from which element of the chart, if that was asked for and the target knows.
    pub map: Option<Map>,
    /// The text of the file beside it, if the target writes two.
    pub beside: Option<String>,
}

impl Output {
    /// A text, and its map if somebody asks for one.
    pub(crate) fn mapped(program: &Program, wants_map: bool, (text, lines): (String, Lines)) -> Self {
        Output { text, map: wants_map.then(|| Map::new(program, &lines)), beside: None }
    }
}

impl From<String> for Output {
    fn from(text: String) -> Self {
        Output { text, map: None, beside: None }
    }
}
