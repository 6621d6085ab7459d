//! What everything is called.
//!
//! Numbers stay the labels of steps as long as they are unique over the chart, which our language wants and AGRAFE does
//! not; steps that share one get the name of their grafcet before it. Labels come first and variables give way to them,
//! since a label brings implicit variables (`X1`, `T1`) that nobody may declare.

use super::hierarchy::Hierarchy;
use crate::agrafe::model::{GrafcetId, GrafcetKind, Model, NodeId, NodeKind, VariableId, VariableKind};
use crate::naming::{Taken, clean};
use crate::{changed, doubtful};
use grafc_diagnostics::Diagnostics;
use index_vec::{IndexVec, index_vec};
use rustc_hash::FxHashMap;

/// Names, without backquotes.
pub struct ImportNames {
    /// Labels of steps and macro-steps; empty for other nodes.
    pub labels: IndexVec<NodeId, String>,
    /// Names of grafcets; of an expansion the label of its macro-step.
    pub grafcets: IndexVec<GrafcetId, String>,
    /// Names of variables; of a step variable the implicit one.
    pub variables: IndexVec<VariableId, String>,
}

/// Names everything.
pub fn name(model: &Model, hierarchy: &Hierarchy, diagnostics: &mut Diagnostics) -> ImportNames {
    let mut namer = Namer {
        model,
        hierarchy,
        taken: Taken::default(),
        names: ImportNames {
            labels: index_vec![String::new(); model.nodes.len()],
            grafcets: index_vec![String::new(); model.grafcets.len()],
            variables: index_vec![String::new(); model.variables.len()],
        },
        diagnostics,
    };
    let shared = namer.numbers();
    namer.macro_steps();
    namer.grafcets();
    namer.shared_numbers(shared);
    namer.variables();
    namer.names
}

struct Namer<'a> {
    model: &'a Model,
    hierarchy: &'a Hierarchy,
    taken: Taken,
    names: ImportNames,
    diagnostics: &'a mut Diagnostics,
}

impl Namer<'_> {
    /// Steps whose number no other has; returns the others.
    fn numbers(&mut self) -> Vec<NodeId> {
        let has_number =
            |node: &NodeId| matches!(self.model.nodes[*node].kind, NodeKind::Step | NodeKind::Enclosing(_));
        let steps: Vec<NodeId> = self.model.nodes.indices().filter(has_number).collect();
        let mut counts: FxHashMap<i32, u32> = FxHashMap::default();
        for &step in &steps {
            *counts.entry(self.model.nodes[step].id).or_default() += 1;
        }
        let (unique, shared): (Vec<_>, Vec<_>) =
            steps.into_iter().partition(|&step| counts[&self.model.nodes[step].id] == 1);
        for step in unique {
            let label = self.model.nodes[step].id.to_string();
            self.taken.insert(&label);
            self.names.labels[step] = label;
        }
        shared
    }

    /// `M3`, its expansion, and in it `E3` and `S3`.
    fn macro_steps(&mut self) {
        let three = |number: &str| ["M", "E", "S"].map(|letter| format!("{letter}{number}")).to_vec();
        for (node, macro_step) in self.model.nodes.iter_enumerated() {
            if let NodeKind::Macro(_) = macro_step.kind {
                let id = macro_step.id.to_string();
                let number = self.taken.take_all(&id, three);
                self.names.labels[node] = format!("M{number}");
                if number != id {
                    let message = format!("the macro-step {id} is called `M{number}`");
                    self.diagnostics.push(changed(macro_step.span, message).note("another has its number"));
                }
            }
        }
        for (id, expansion) in self.model.grafcets.iter_enumerated() {
            if expansion.kind != GrafcetKind::Expansion {
                continue;
            }
            let label = match self.hierarchy.expanded[id] {
                Some(macro_step) => self.names.labels[macro_step].clone(),
                None => {
                    let label = format!("M{}", self.taken.take_all("0", three));
                    let message = format!("an expansion belongs to no macro-step, and is called `{label}`");
                    self.diagnostics.push(doubtful(expansion.span, message));
                    label
                }
            };
            for &node in &expansion.nodes {
                let (letter, role) = match self.model.nodes[node].kind {
                    NodeKind::Entry => ('E', "entry"),
                    NodeKind::Exit => ('S', "exit"),
                    NodeKind::Step
                    | NodeKind::Enclosing(_)
                    | NodeKind::Macro(_)
                    | NodeKind::Transition(_)
                    | NodeKind::Synchronization => continue,
                };
                let step = &self.model.nodes[node];
                let name = format!("{letter}{}", &label[1..]);
                if name[1..] != step.id.to_string() {
                    let message = format!("the {role} step {} of `{label}` is called `{name}`", step.id);
                    self.diagnostics.push(changed(step.span, message));
                }
                self.names.labels[node] = name;
            }
            self.names.grafcets[id] = label;
        }
    }

    fn grafcets(&mut self) {
        let mut nameless = Vec::new();
        for (id, grafcet) in self.model.grafcets.iter_enumerated() {
            if !self.hierarchy.is_block(self.model, id) || grafcet.kind == GrafcetKind::Expansion {
                continue;
            }
            let Some(wanted) = grafcet.name.as_deref().filter(|name| !name.trim().is_empty()) else {
                nameless.push(id);
                continue;
            };
            let name = self.taken.take(&clean(wanted));
            if name != wanted {
                self.diagnostics.push(
                    changed(grafcet.span, format!("a grafcet is called `{name}` now"))
                        .note("names are short lines of text, and unique together with the labels of steps"),
                );
            }
            self.names.grafcets[id] = name;
        }
        let mut number = 1;
        for id in nameless {
            while !self.taken.is_free(&format!("G{number}")) {
                number += 1;
            }
            let name = self.taken.take(&format!("G{number}"));
            let message = format!("a grafcet without a name is called `{name}`");
            self.diagnostics.push(changed(self.model.grafcets[id].span, message));
            self.names.grafcets[id] = name;
        }
    }

    fn shared_numbers(&mut self, steps: Vec<NodeId>) {
        for step in steps {
            let node = &self.model.nodes[step];
            let label = self.taken.take(&format!("{}_{}", self.names.grafcets[node.grafcet], node.id));
            let message = format!("the step {} is called `{label}`", node.id);
            self.diagnostics.push(changed(node.span, message).note("another step has its number"));
            self.names.labels[step] = label;
        }
    }

    fn variables(&mut self) {
        let mut taken = Taken::default();
        for (node, label) in self.names.labels.iter_enumerated().filter(|(_, label)| !label.is_empty()) {
            taken.insert(&format!("X{label}"));
            if self.model.nodes[node].kind.is_step() {
                taken.insert(&format!("T{label}"));
            }
        }
        for name in self.names.grafcets.iter().filter(|name| !name.is_empty()) {
            taken.insert(&format!("X{name}"));
        }
        for (id, variable) in self.model.variables.iter_enumerated() {
            if let VariableKind::Step(Some(step)) = variable.kind {
                self.names.variables[id] = format!("X{}", self.names.labels[step]);
                continue;
            }
            let given = variable.name.as_deref().unwrap_or_default();
            let wanted = clean(given);
            let name = taken.take(&wanted);
            if name != wanted {
                let message = format!("the variable `{wanted}` is called `{name}`");
                self.diagnostics.push(doubtful(variable.span, message).note(
                    "another variable has its name, perhaps in another case, or a step defines a variable of this name",
                ));
            } else if name != given {
                self.diagnostics.push(changed(variable.span, format!("a variable is called `{name}` now")));
            }
            self.names.variables[id] = name;
        }
    }
}
