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
pub(super) mod tree_form;
mod write;

use super::{Dialect, Options, project};
use crate::limits;
use crate::sequence::texts::{Activity, Texts};
use crate::sequence::units::Units;
use crate::xml::Xml;
use ecow::EcoString;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics};
use grafc_logic::scan::StepId;
use grafc_logic::sequence::Sequence;
use graph::Graph;

/// Writes a sequential function chart as a project.
///
/// An error is a chart that is not nested as CODESYS wants it, or a fault of grafc.
pub fn emit(sequence: &Sequence, options: &Options) -> Result<String, Diagnostics> {
    limits::check(&sequence.program)?;
    let texts = Texts::new(sequence, Activity::Marked);
    let units = Units::new(sequence, &texts);
    match options.dialect {
        Dialect::Neutral => {
            let graph = Graph::new(sequence, &texts);
            let placed = place::place(&graph);
            let drawing = |xml: &mut Xml, dialect| write::write(xml, &graph, &placed, &texts, dialect);
            Ok(write_units(&units, options, &[], drawing))
        }
        Dialect::Codesys => tree_form::emit(sequence, &texts, &units, options),
    }
}

/// Writes the project; the unit that is drawn has the actions.
fn write_units(
    units: &Units,
    options: &Options,
    actions: &[(String, String)],
    drawing: impl FnOnce(&mut Xml, Dialect),
) -> String {
    let Some((name, interface)) = &units.drawn else {
        return project::write(&units.parts, options, actions, drawing);
    };
    let needed = |xml: &mut Xml| {
        xml.open("pou", &[("name", name), ("pouType", "functionBlock")]);
        project::unit(xml, interface, actions, Some("the chart, drawn"), options.dialect, drawing);
    };
    let body = |xml: &mut Xml, dialect: Dialect| dialect.body(xml, "ST", &units.parts.body);
    project::write_with(&units.parts, options, needed, &[], body)
}

/// The instance whose variables hold the situation, if something is found before or after the chart.
pub fn instance(sequence: &Sequence) -> Option<EcoString> {
    crate::sequence::instance(sequence)
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
