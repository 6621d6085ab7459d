//! The form of sequential function chart that CODESYS and TwinCAT export: a tree of sequences, each divergence closed by
//! a convergence of its kind, and no places, since the tool draws by itself.
//!
//! `tree` finds the nesting, or why there is none; `write` spells its elements. The chart's arcs that are not part of
//! the tree are jumps.

mod tree;
mod write;

use super::prepared::Units;
use super::refusal;
use super::texts::{Action, Content, Texts};
use crate::plcopen::Options;
use ecow::EcoString;
use grafc_diagnostics::Diagnostics;
use grafc_logic::sequence::Sequence;
use rustc_hash::{FxHashMap, FxHashSet};

/// An action of the function block: a name and statements.
type NamedAction = (String, String);

/// What a step does, in the words of these tools.
#[derive(Default)]
struct Does {
    /// Variables and actions while it is active.
    while_active: Vec<String>,
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
    let mut known: FxHashMap<&str, String> = FxHashMap::default();
    let mut does = Vec::new();
    for (name, rows) in texts.steps.iter().zip(&texts.actions) {
        let of =
            |rows: &mut dyn Iterator<Item = &Action>| rows.map(|row| row.content.text()).collect::<Vec<_>>().join("\n");
        let mut step = Does::default();
        for row in rows.iter().filter(|row| row.qualifier == "N") {
            step.while_active.push(match &row.content {
                Content::Variable(name) => name.to_string(),
                // Done once more after the step is left, so it needs no action on deactivation.
                Content::Statements(text) => known
                    .entry(text)
                    .or_insert_with(|| {
                        let name = fresh.name(&format!("set_{}", text.split(' ').next().unwrap_or_default()));
                        actions.push((name.clone(), text.clone()));
                        name
                    })
                    .clone(),
            });
        }
        let while_active: FxHashSet<&str> =
            rows.iter().filter(|row| row.qualifier == "N").map(|row| row.content.text()).collect();
        let once = |qualifier: &'static str| {
            let while_active = &while_active;
            rows.iter().filter(move |row| row.qualifier == qualifier && !while_active.contains(row.content.text()))
        };
        for (qualifier, end, place) in [("P1", "entry", &mut step.entry), ("P0", "exit", &mut step.exit)] {
            let text = of(&mut once(qualifier));
            if !text.is_empty() {
                let name = fresh.name(&format!("{name}_{end}"));
                actions.push((name.clone(), text));
                *place = Some(name);
            }
        }
        does.push(step);
    }
    Ok(units.write(options, &actions, |xml, _| write::write(xml, &elements, texts, &does)))
}

/// Names that nothing else has.
struct Fresh {
    taken: FxHashSet<String>,
}

impl Fresh {
    fn new<'n>(taken: impl Iterator<Item = &'n str>) -> Self {
        Fresh { taken: taken.map(str::to_ascii_uppercase).collect() }
    }

    fn name(&mut self, wanted: &str) -> String {
        let suffixes = std::iter::once(String::new()).chain((1_u64..).map(|number| format!("_{number}")));
        let mut names = suffixes.map(|suffix| format!("{wanted}{suffix}"));
        let free = names.find(|name| self.taken.insert(name.to_ascii_uppercase()));
        free.unwrap_or_else(|| wanted.to_owned())
    }
}
