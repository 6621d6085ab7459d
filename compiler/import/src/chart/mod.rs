//! A model of AGRAFE as the text of a chart.
//!
//! Each file takes one construct: it says what of it was changed, is doubtful or was lost, and writes it. The text comes
//! out in the order of the file: declarations by keyword, then the grafcets, the expansions among them, in each the
//! steps before the transitions.

mod actions;
mod arcs;
mod comments;
mod conditions;
mod delays;
mod hierarchy;
mod names;
mod variables;

use crate::Options;
use crate::agrafe::model::{ActionId, GrafcetId, GrafcetKind, Model, NodeId, NodeKind, VariableId};
use crate::naming::{clean, spell, spell_label};
use crate::xml::{Document, ElementId};
use comments::{Attachment, Comments};
use conditions::Binding;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics};
use hierarchy::Hierarchy;
use index_vec::IndexVec;
use names::ImportNames;
use rustc_hash::FxHashSet;
use variables::Variables;

/// A text that does not grow without end.
struct Text {
    out: String,
    limit: usize,
}

impl Text {
    fn push(&mut self, text: &str) {
        if !self.is_full() {
            self.out.push_str(text);
        }
    }

    fn is_full(&self) -> bool {
        self.out.len() > self.limit
    }
}

/// Writes a chart.
struct Writer<'a> {
    model: &'a Model,
    hierarchy: Hierarchy,
    names: ImportNames,
    variables: Variables,
    around: IndexVec<NodeId, arcs::Steps>,
    actions: IndexVec<NodeId, Vec<ActionId>>,
    left_out: Vec<bool>,
    comments: Comments,
    /// Where declarations stand in the file.
    containers: Vec<ElementId>,
    text: Text,
}

/// The text of a chart; none if it would be longer than `limit`.
pub fn write(
    model: &Model,
    document: &Document,
    options: &Options,
    limit: usize,
    diagnostics: &mut Diagnostics,
) -> Option<String> {
    let hierarchy = hierarchy::find(model, diagnostics);
    let names = names::name(model, &hierarchy, diagnostics);
    let uses = variables::uses(model);
    let variables = variables::judge(model, &names, &uses, options, diagnostics);
    let left_out = variables::left_out(model, &uses, diagnostics);
    actions::judge(model, diagnostics);
    let actions = actions::of_steps(model, diagnostics);
    let Some(around) = arcs::follow(model, limit, diagnostics) else {
        diagnostics.push(too_long(document));
        return None;
    };
    let is_container = |id: &ElementId| document.elements[*id].name == "variableDeclarationContainer";
    let containers: Vec<ElementId> = document.elements.indices().filter(is_container).collect();
    let comments = place_comments(model, document, &hierarchy, &variables, &containers);
    let text = Text { out: String::new(), limit };
    let mut writer =
        Writer { model, hierarchy, names, variables, around, actions, left_out, comments, containers, text };
    writer.chart();
    if writer.text.is_full() {
        diagnostics.push(too_long(document));
        return None;
    }
    Some(writer.text.out)
}

fn too_long(document: &Document) -> Diagnostic {
    Diagnostic::new(Code::E0702, document.root_span(), "the chart would be many times longer than its file")
        .note("a synchronisation with all transitions after it, or an action with many steps, is written at each")
        .help("join fewer steps by one synchronisation, or make intermediate steps")
}

fn place_comments(
    model: &Model,
    document: &Document,
    hierarchy: &Hierarchy,
    variables: &Variables,
    containers: &[ElementId],
) -> Comments {
    let mut items = FxHashSet::default();
    let declared = model.variables.iter_enumerated().filter(|(id, _)| variables.keywords[*id].is_some());
    items.extend(declared.map(|(_, variable)| variable.element));
    let written = model.nodes.iter().filter(|node| !matches!(node.kind, NodeKind::Synchronization));
    items.extend(written.map(|node| node.element));
    let mut blocks: FxHashSet<ElementId> = containers.iter().copied().collect();
    for (id, grafcet) in model.grafcets.iter_enumerated() {
        blocks.insert(grafcet.element);
        if grafcet.kind != GrafcetKind::Chart && hierarchy.is_block(model, id) {
            items.insert(grafcet.element);
        }
    }
    Comments::place(document, |element| items.contains(&element), |element| blocks.contains(&element))
}

impl Writer<'_> {
    fn chart(&mut self) {
        self.comments_of(Attachment::Head);
        if let Some(name) = &self.model.name {
            let name = spell(&clean(name));
            self.text.push(&format!("chart {name}\n"));
        }
        for keyword in ["input", "output", "var"] {
            self.text.push("\n");
            let declared = |id: &VariableId| self.variables.keywords[*id] == Some(keyword);
            let variables: Vec<VariableId> = self.model.variables.indices().filter(declared).collect();
            for variable in variables {
                self.declaration(variable);
            }
        }
        for container in std::mem::take(&mut self.containers) {
            self.comments_of(Attachment::End(container));
        }
        for grafcet in self.model.grafcets.indices() {
            if self.hierarchy.is_block(self.model, grafcet) {
                self.grafcet(grafcet);
            }
        }
        self.text.push("\n");
        self.comments_of(Attachment::End(self.model.grafcets[GrafcetId::new(0)].element));
        self.comments_of(Attachment::End(ElementId::new(0)));
    }

    fn grafcet(&mut self, id: GrafcetId) {
        let grafcet = &self.model.grafcets[id];
        self.text.push("\n");
        let name = spell(&self.names.grafcets[id]);
        let head = match (grafcet.kind, self.hierarchy.encloser[id]) {
            (GrafcetKind::Expansion, _) => format!("expansion {name}"),
            (GrafcetKind::Chart | GrafcetKind::Partial, None) => format!("grafcet {name}"),
            (GrafcetKind::Chart | GrafcetKind::Partial, Some(step)) => {
                format!("grafcet {}/{name}", spell(&format!("X{}", self.names.labels[step])))
            }
        };
        if grafcet.kind != GrafcetKind::Chart {
            self.comments_before(grafcet.element);
        }
        self.text.push(&head);
        self.text.push(" {\n");
        for &node in &grafcet.nodes {
            self.step(node);
        }
        self.text.push("\n");
        for &node in &grafcet.nodes {
            self.transition(node);
        }
        if grafcet.kind != GrafcetKind::Chart {
            self.comments_of(Attachment::End(grafcet.element));
        }
        self.text.push("}\n");
    }

    fn step(&mut self, id: NodeId) {
        let node = &self.model.nodes[id];
        let keyword = match node.kind {
            NodeKind::Transition(_) | NodeKind::Synchronization => return,
            NodeKind::Macro(_) => "macro step",
            NodeKind::Enclosing(_) if self.hierarchy.enclosing.contains(&id) => "enclosing step",
            NodeKind::Enclosing(_) | NodeKind::Step | NodeKind::Entry | NodeKind::Exit => "step",
        };
        self.comments_before(node.element);
        let initial = if node.initial { "initial " } else { "" };
        let activated =
            node.activation_link && !hierarchy::is_unenclosed(self.model, &self.hierarchy.encloser, node.grafcet);
        let activated = if activated { "activated " } else { "" };
        let label = spell_label(&self.names.labels[id]);
        self.text.push(&format!("{initial}{activated}{keyword} {label}"));
        let actions: Vec<ActionId> =
            self.actions[id].iter().copied().filter(|action| !self.left_out[action.index()]).collect();
        if !actions.is_empty() {
            self.text.push(" { ");
            for action in actions {
                self.action(action, id);
            }
            self.text.push(" }");
        }
        self.text.push("\n");
    }

    fn transition(&mut self, id: NodeId) {
        let node = &self.model.nodes[id];
        let NodeKind::Transition(condition) = &node.kind else { return };
        self.comments_before(node.element);
        let steps = std::mem::take(&mut self.around[id]);
        if steps.before.is_empty() && steps.behind.is_empty() {
            return;
        }
        self.text.push("transition ");
        if node.id != 0 {
            self.text.push(&format!("({}) ", spell_label(&node.id.to_string())));
        }
        self.labels(&steps.before);
        self.text.push(" -> ");
        self.labels(&steps.behind);
        self.text.push(" : ");
        self.transition_condition(condition, &steps.before);
        self.text.push("\n");
    }

    /// Labels, separated by commas.
    fn labels(&mut self, steps: &[NodeId]) {
        for (place, &step) in steps.iter().enumerate() {
            self.text.push(if place > 0 { ", " } else { "" });
            let label = spell_label(&self.names.labels[step]);
            self.text.push(&label);
        }
    }

    /// A variable in a term: its name, or the delay that it stands for.
    fn variable(&mut self, id: VariableId, level: Binding) {
        let name = match self.variables.delays.get(&id) {
            Some(delay) if level >= Binding::Operand => format!("({delay})"),
            Some(delay) => delay.clone(),
            None => spell(&self.names.variables[id]),
        };
        self.text.push(&name);
    }

    fn comments_before(&mut self, element: ElementId) {
        self.comments_of(Attachment::Before(element));
    }

    fn comments_of(&mut self, place: Attachment) {
        for line in self.comments.take(place) {
            self.text.push(&line);
            self.text.push("\n");
        }
    }
}
