//! A body drawn as a sequential function chart: with places for Beremiz and the editors that come from it, as a tree for
//! CODESYS and TwinCAT (`tree_form`).
//!
//! ```text
//! Sequence ─ graph ─▶ steps, transitions, jumps and arcs ─ place ─▶ where they stand ─ write ─▶ XML
//! ```
//!
//! Whether a chart can be drawn is decided before (see `grafc_logic::sequence`). Here everything leads downwards: what
//! would lead back up, or into a step beside others that cannot be joined there, is a jump. Divergences and convergences
//! are bars between them. Places are those of `grafc-layout`, as in any drawing of grafc.

mod graph;
mod place;
mod prepared;
mod texts;
use ecow::EcoString;
pub(super) mod tree_form;
mod write;

use super::{Dialect, Options};
use crate::iec::names::Names;
use crate::keywords::Family;
use crate::limits;
use crate::xml::Xml;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics};
use grafc_logic::scan::StepId;
use grafc_logic::sequence::Sequence;
use graph::Graph;
use prepared::Units;
use texts::Texts;

/// Writes a sequential function chart as a project.
///
/// An error is a chart that is not nested as CODESYS wants it, or a fault of grafc.
pub fn emit(sequence: &Sequence, options: &Options) -> Result<String, Diagnostics> {
    limits::check(&sequence.program)?;
    let texts = Texts::new(sequence);
    let units = Units::new(sequence, &texts);
    match options.dialect {
        Dialect::Neutral => {
            let graph = Graph::new(sequence, &texts);
            let placed = place::place(&graph);
            let drawing = |xml: &mut Xml, dialect| write::write(xml, &graph, &placed, &texts, dialect);
            Ok(units.write(options, &[], drawing))
        }
        Dialect::Codesys => tree_form::emit(sequence, &texts, &units, options),
    }
}

/// The instance whose variables hold the situation, if something is found before or after the chart.
pub fn instance(sequence: &Sequence) -> Option<EcoString> {
    let mut names = Names::new(&sequence.program, Family::Iec);
    sequence.is_held().then(|| prepared::instance(&mut names))
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
