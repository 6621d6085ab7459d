//! What stands in the boxes: names, conditions, actions.

use crate::comment::clean;
use crate::st;
use ecow::{EcoString, eco_format};
use grafc_logic::scan::{Role, VarId};
use grafc_logic::sequence::Sequence;
use rustc_hash::{FxHashMap, FxHashSet};

/// All texts of a chart.
pub(super) struct Texts {
    /// The names of the steps, in order.
    pub steps: Vec<EcoString>,
    /// The comment on each step, clean; empty if there is none.
    pub comments: Vec<String>,
    /// The conditions of the transitions, in order.
    pub conditions: Vec<String>,
    /// What each step does.
    pub actions: Vec<Vec<Action>>,
    of_steps: FxHashSet<EcoString>,
}

/// A row of an action block.
pub(super) struct Action {
    pub qualifier: &'static str,
    pub content: Content,
}

pub(super) enum Content {
    /// A variable that is true while the step is active.
    Variable(EcoString),
    /// Statements.
    Statements(String),
}

impl Content {
    /// What is read in the row.
    pub fn text(&self) -> &str {
        match self {
            Content::Variable(text) => text,
            Content::Statements(text) => text,
        }
    }
}

impl Texts {
    /// Spells a chart.
    pub fn new(sequence: &Sequence) -> Self {
        let names = st::names(&sequence.program);
        let mut spelt: FxHashMap<VarId, EcoString> = FxHashMap::default();
        let mut of_steps = FxHashSet::default();
        for step in &sequence.steps {
            let name = &names[step.active];
            spelt.insert(step.active, eco_format!("{name}.X"));
            spelt.insert(step.duration, eco_format!("{name}.T"));
            of_steps.extend([name.clone(), names[step.duration].clone()]);
        }
        let conditions = sequence.transitions.iter().map(|transition| transition.condition);
        let values = sequence.wires.iter().map(|wire| wire.value);
        let stored = sequence.steps.iter().flat_map(|step| &step.stored).map(|assignment| assignment.value);
        let formulas: Vec<_> = conditions.chain(values).chain(stored).collect();
        let mut texts = st::spell(&sequence.program, &spelt, &formulas).into_iter();
        let conditions = texts.by_ref().take(sequence.transitions.len()).collect();
        let values: Vec<String> = texts.by_ref().take(sequence.wires.len()).collect();

        let mut actions = Vec::new();
        for step in &sequence.steps {
            let mut rows = Vec::new();
            if let Some(marker) = step.marker {
                rows.push(Action { qualifier: "N", content: Content::Variable(names[marker].clone()) });
            }
            for wire in step.wires.iter().map(|place| (&sequence.wires[*place], &values[*place])) {
                let (wire, value) = wire;
                let name = &names[wire.target];
                if wire.plain {
                    rows.push(Action { qualifier: "N", content: Content::Variable(name.clone()) });
                    continue;
                }
                // While the step is active, and once more when it is left: the value is that of the whole chart.
                let statement = format!("{name} := {value};");
                rows.push(Action { qualifier: "N", content: Content::Statements(statement.clone()) });
                rows.push(Action { qualifier: "P0", content: Content::Statements(statement) });
            }
            for assignment in &step.stored {
                let qualifier = if assignment.on_activation { "P1" } else { "P0" };
                let statement = format!("{} := {};", names[assignment.target], texts.next().unwrap_or_default());
                rows.push(Action { qualifier, content: Content::Statements(statement) });
            }
            actions.push(rows);
        }
        let steps = sequence.steps.iter().map(|step| names[step.active].clone()).collect();
        let comments = sequence.steps.iter().map(|step| clean(step.comment.as_deref().unwrap_or_default())).collect();
        debug_assert!(sequence.steps.iter().all(|step| sequence.program.variables[step.active].role == Role::Step));
        Texts { steps, comments, conditions, actions, of_steps }
    }

    /// Whether a variable is the activity or the duration of a step.
    pub fn is_of_a_step(&self, name: &str) -> bool {
        self.of_steps.contains(name)
    }
}
