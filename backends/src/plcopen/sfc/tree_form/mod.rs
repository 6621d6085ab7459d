//! The form of sequential function chart that CODESYS and TwinCAT export: a tree of sequences, each divergence closed by
//! a convergence of its kind, and no places, since the tool draws by itself.
//!
//! `tree` finds the nesting, or why there is none; `write` spells its elements. The chart's arcs that are not part of
//! the tree are jumps.

mod tree;
mod write;

use super::{refusal, write_units};
use crate::plcopen::Options;
use crate::sequence::texts::{Action, Content, Qualifier, Statement, Texts};
use crate::sequence::units::{Fresh, Units};
use ecow::EcoString;
use grafc_diagnostics::Diagnostics;
use grafc_logic::sequence::Sequence;
use rustc_hash::FxHashMap;

/// An action of the function block: a name and statements.
type NamedAction = (String, String);

/// What a step does, in the words of these tools.
#[derive(Default)]
struct Does {
    /// Variables and actions by their qualifiers; such an action is done once more after its step is left.
    associated: Vec<(String, Qualifier)>,
    /// The action that is done in each scan, and not once more.
    each_scan: Option<String>,
    /// Actions on activation and on deactivation.
    entry: Option<String>,
    exit: Option<String>,
}

/// Writes a chart as a project, or says why it is not nested.
pub(super) fn emit(
    sequence: &Sequence,
    texts: &Texts,
    units: &Units,
    options: &Options,
) -> Result<String, Diagnostics> {
    let elements = tree::Tree::new(sequence)
        .build()
        .map_err(|(step, why)| refusal(sequence, step, &format!("{why}; CODESYS draws only what is nested")))?;
    let taken = units.interface().iter().flat_map(|block| block.entries()).map(|entry| entry.name.as_str());
    let mut fresh = Fresh::new(taken.chain(texts.steps.iter().map(EcoString::as_str)));
    let mut actions: Vec<NamedAction> = Vec::new();
    let mut known: FxHashMap<&String, String> = FxHashMap::default();
    let mut does = Vec::new();
    for (name, rows) in texts.steps.iter().zip(&texts.actions) {
        let mut step = Does::default();
        for row in rows {
            match &row.content {
                Content::Variable(name) => step.associated.push((name.to_string(), row.qualifier.clone())),
                // Done once more after the step is left, so it needs no action on deactivation.
                Content::Computed(Statement { flat: text, .. }) if row.qualifier == Qualifier::N => {
                    let name = known.entry(text).or_insert_with(|| {
                        let name = fresh.name(&format!("set_{}", text.split(' ').next().unwrap_or_default()));
                        actions.push((name.clone(), text.clone()));
                        name
                    });
                    step.associated.push((name.clone(), Qualifier::N));
                }
                Content::Computed(_) | Content::Stored(_) => {}
            }
        }
        let stored = |row: &&Action| matches!(row.content, Content::Stored(_));
        for (qualifier, end, place) in [
            (Qualifier::N, "active", &mut step.each_scan),
            (Qualifier::P1, "entry", &mut step.entry),
            (Qualifier::P0, "exit", &mut step.exit),
        ] {
            let rows = rows.iter().filter(stored).filter(|row| row.qualifier == qualifier);
            let statements = rows.filter_map(|row| row.content.statement());
            let text = statements.flat_map(|statement| &statement.lines).cloned().collect::<Vec<_>>().join("\n");
            if !text.is_empty() {
                let name = fresh.name(&format!("{name}_{end}"));
                actions.push((name.clone(), text));
                *place = Some(name);
            }
        }
        does.push(step);
    }
    Ok(write_units(units, options, &actions, |xml, _| write::write(xml, &elements, texts, &does)))
}
