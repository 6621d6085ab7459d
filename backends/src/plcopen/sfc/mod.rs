//! A body drawn as a sequential function chart: with places for Beremiz and the editors that come from it, as a tree for
//! CODESYS and TwinCAT (`nested`).
//!
//! ```text
//! Sequence ─ graph ─▶ steps, transitions, jumps in layers ─ order ─▶ few crossings ─ place ─▶ columns and rows ─ write ─▶ XML
//! ```
//!
//! Whether a chart can be drawn is decided before (see `grafc_logic::sequence`). Here everything leads downwards: what
//! would lead back up, or into a step beside others that cannot be joined there, is a jump. Divergences and convergences
//! are bars between the layers.

mod graph;
pub(super) mod nested;
mod order;
mod place;
mod texts;
mod write;

use super::{Dialect, Options, project};
use crate::st::{self, Style};
use grafc_diagnostics::{Code, Diagnostic, Diagnostics};
use grafc_logic::scan::StepId;
use grafc_logic::sequence::Sequence;
use graph::Graph;
use texts::Texts;

/// Writes a sequential function chart as a project.
///
/// An error is a chart that is not nested as CODESYS wants it, or a fault of grafc.
pub fn emit(sequence: &Sequence, options: &Options) -> Result<String, Diagnostics> {
    let mut parts = st::parts(&sequence.program, Style::default())?;
    let texts = Texts::new(sequence);
    // A step brings its activity and its duration along.
    parts.interface.iter_mut().for_each(|block| block.retain(|name| !texts.is_of_a_step(name)));
    match options.dialect {
        Dialect::Neutral => {
            let mut graph = Graph::new(sequence, &texts).map_err(|step| {
                refusal(sequence, step, "joins so much later that its way there is too long for a drawing")
            })?;
            order::reduce_crossings(&mut graph);
            let placed = place::place(&graph);
            Ok(project::write(&parts, options, &[], |xml, dialect| write::write(xml, &graph, &placed, &texts, dialect)))
        }
        Dialect::Codesys => nested::emit(sequence, &texts, &parts, options),
    }
}

/// Why a chart that could be a sequential function chart is not drawn.
fn refusal(sequence: &Sequence, step: StepId, why: &str) -> Diagnostics {
    let place = sequence.program.variables[sequence.steps[step].active].span.unwrap_or_default();
    let mut diagnostics = Diagnostics::new();
    diagnostics.push(
        Diagnostic::new(Code::E0503, place, "this chart cannot be drawn as a sequential function chart")
            .here(why)
            .help("take the body in Structured Text, `--body st`, which every chart has"),
    );
    diagnostics
}
