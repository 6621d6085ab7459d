//! What everything is called.
//!
//! Numbers stay the labels of steps as long as they are unique over the chart, which our language wants and AGRAFE does
//! not; steps that share one get the name of their grafcet before it. Labels come first and variables give way to them,
//! since a label brings implicit variables (`X1`, `T1`) that nobody may declare.

use super::hierarchy::Hierarchy;
use crate::agrafe::model::{GrafcetId, GrafcetKind, Model, NodeId, NodeKind, VariableId, VariableKind};
use crate::{changed, doubtful};
use grafc_diagnostics::Diagnostics;
use grafc_syntax::spelling::is_reserved;
use index_vec::{IndexVec, index_vec};
use rustc_hash::{FxHashMap, FxHashSet};

/// How long a name may be; what stands in the file once is written again and again.
const LONGEST: usize = 200;

/// Words of the language in places only; backquotes keep them names there.
const CONTEXTUAL: [&str; 5] = ["activation", "at", "deactivation", "event", "INIT"];

/// Names, without backquotes.
pub struct ImportNames {
    /// Labels of steps and macro-steps; empty for other nodes.
    pub labels: IndexVec<NodeId, String>,
    /// Names of grafcets; of an expansion the label of its macro-step.
    pub grafcets: IndexVec<GrafcetId, String>,
    /// Names of variables; of a step variable the implicit one.
    pub variables: IndexVec<VariableId, String>,
}

/// A name as it is written.
pub fn spell(name: &str) -> String {
    let letter = |c: char| c == '_' || c.is_ascii_alphabetic() || ('À'..='ӿ').contains(&c) && c.is_alphabetic();
    let mut chars = name.chars();
    let plain = chars.next().is_some_and(letter) && chars.all(|c| letter(c) || c.is_ascii_digit());
    if plain && !is_reserved(name) && !CONTEXTUAL.contains(&name) { name.to_string() } else { format!("`{name}`") }
}

/// A label as it is written: numbers need no backquotes.
pub fn spell_label(label: &str) -> String {
    if label.bytes().all(|b| b.is_ascii_digit()) { label.to_string() } else { spell(label) }
}

/// What can stand between backquotes in a line: not too long, and something at all.
pub fn clean(name: &str) -> String {
    let clean = |c: char| if c == '`' || c.is_control() || matches!(c, '\u{2028}' | '\u{2029}') { '_' } else { c };
    let cleaned: String = name.trim().chars().take(LONGEST).map(clean).collect();
    if cleaned.is_empty() { "unnamed".to_string() } else { cleaned }
}

/// Names that are in use, without regard to case.
#[derive(Default)]
struct Taken {
    names: FxHashSet<String>,
    next: FxHashMap<String, u32>,
}

impl Taken {
    fn is_free(&self, name: &str) -> bool {
        !self.names.contains(&name.to_lowercase())
    }

    fn insert(&mut self, name: &str) {
        self.names.insert(name.to_lowercase());
    }

    /// The name wanted, or that name with the first number for which all are free that `made` makes of it.
    fn take_all(&mut self, wanted: &str, made: impl Fn(&str) -> Vec<String>) -> String {
        let mut name = wanted.to_string();
        let folded = wanted.to_lowercase();
        while !made(&name).iter().all(|name| self.is_free(name)) {
            let next = self.next.entry(folded.clone()).or_insert(2);
            name = format!("{wanted}_{next}");
            *next += 1;
        }
        for name in made(&name) {
            self.insert(&name);
        }
        name
    }

    fn take(&mut self, wanted: &str) -> String {
        self.take_all(wanted, |name| vec![name.to_string()])
    }
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_that_need_backquotes_get_them() {
        let names = ["a", "Förderband", "привет", "2s/X202", "on", "a b", "x١", "at"];
        let spelled = names.map(spell);
        assert_eq!(spelled, ["a", "Förderband", "привет", "`2s/X202`", "`on`", "`a b`", "`x١`", "`at`"]);
        assert_eq!([spell_label("12"), spell_label("G1_1"), spell_label("-1")], ["12", "G1_1", "`-1`"]);
        assert_eq!(
            [clean("a`\nb"), clean(" "), clean(&"ü".repeat(300))],
            ["a__b".into(), "unnamed".into(), "ü".repeat(200)]
        );
    }

    #[test]
    fn taken_names_get_numbers() {
        let mut taken = Taken::default();
        let names: Vec<_> = ["a", "A", "a_2", "a"].into_iter().map(|name| taken.take(name)).collect();
        assert_eq!(names, ["a", "A_2", "a_2_2", "a_3"]);
    }
}
