//! What elements refer to: the second reading.
//!
//! EMF refers by the way from the root, `//@partialGrafcets.0/@steps.2`: the feature and the place in it, at each
//! level. Elements with an `xmi:id` are referred to by that. A reference that leads nowhere, or to what it cannot mean,
//! is an error, since the chart without it would be another. An arc or link that does not say what it joins is left
//! over in the editor, and reported as lost.

use super::elements::{Entity, FirstReading};
use super::model::{
    ActionId, ActionKind, ActionLink, Arc, GrafcetId, GrafcetKind, NodeId, NodeKind, TermKind, VariableKind,
};
use crate::lost;
use crate::xml::{Document, Element, ElementId};
use grafc_diagnostics::{Code, Diagnostic, Diagnostics};
use index_vec::IndexVec;
use rustc_hash::FxHashMap;

/// Completes the model.
pub fn resolve(document: &Document, roots: &[ElementId], found: &mut FirstReading, diagnostics: &mut Diagnostics) {
    let mut resolver =
        Resolver { places: places(document), ids: ids(document), roots, entities: &found.entities, diagnostics };
    let model = &mut found.model;
    for (id, element) in document.elements.iter_enumerated() {
        match found.entities[id] {
            Entity::Grafcet(grafcet) => {
                let step = resolver.optional(element, "enclosingStep", "an enclosing step", as_node);
                model.grafcets[grafcet].enclosing_step = step;
            }
            Entity::Variable(variable) => {
                if let VariableKind::Step(step) = &mut model.variables[variable].kind {
                    *step = resolver.optional(element, "step", "a step", as_node);
                }
            }
            Entity::Node(node) => match &mut model.nodes[node].kind {
                NodeKind::Enclosing(grafcets) => {
                    *grafcets = resolver.list(element, "partialGrafcets", "a partial grafcet", as_grafcet);
                }
                NodeKind::Macro(expansion) => {
                    *expansion = resolver.optional(element, "expansion", "an expansion", as_grafcet);
                }
                NodeKind::Step
                | NodeKind::Entry
                | NodeKind::Exit
                | NodeKind::Transition(_)
                | NodeKind::Synchronization => {}
            },
            // The editor leaves such things behind when what they were drawn between is deleted; they show nothing.
            Entity::Arc
                if is_leftover(element, ["source", "target"], "an arc without an end", resolver.diagnostics) => {}
            Entity::ActionLink
                if is_leftover(
                    element,
                    ["step", "actionType"],
                    "a link between a step and an action",
                    resolver.diagnostics,
                ) => {}
            Entity::Arc => {
                let source = resolver.required(element, "source", "a step, transition or synchronisation", as_node);
                let target = resolver.required(element, "target", "a step, transition or synchronisation", as_node);
                if let (Some(source), Some(target)) = (source, target) {
                    model.arcs.push(Arc { source, target, span: element.span });
                }
            }
            Entity::ActionLink => {
                let step = resolver.required(element, "step", "a step", as_node);
                let action = resolver.required(element, "actionType", "an action", as_action);
                if let (Some(step), Some(action)) = (step, action) {
                    if model.nodes[step].kind.is_step() {
                        model.links.push(ActionLink { step, action, span: element.span });
                    } else {
                        resolver.misled(element, "step", "a step");
                    }
                }
            }
            Entity::Action(action) => {
                if let ActionKind::Force { grafcet, steps, .. } = &mut model.actions[action].kind {
                    *grafcet = resolver.required(element, "partialGrafcet", "a partial grafcet", as_grafcet);
                    *steps = resolver.list(element, "forcedSteps", "a step", as_node);
                }
            }
            Entity::Term(term) => {
                if let TermKind::Variable(variable) = &mut model.terms[term].kind {
                    *variable =
                        resolver.required(element, "variableDeclaration", "a variable", |entity| match entity {
                            Entity::Variable(id) => Some(id),
                            _ => None,
                        });
                }
            }
            Entity::Container | Entity::Notation | Entity::Lost => {}
        }
    }
    check_steps(document, found, diagnostics);
}

/// Reports an element that does not say what it joins as lost.
fn is_leftover(element: &Element, ends: [&str; 2], what: &str, said: &mut Diagnostics) -> bool {
    let missing: Vec<String> =
        ends.iter().filter(|end| element.attribute(end).is_none()).map(|end| format!("`{end}`")).collect();
    if missing.is_empty() {
        return false;
    }
    let message = format!("{what} is lost: it has no {}", missing.join(" and no "));
    said.push(lost(element.span, message).help("delete it in the tool that made the chart, or draw it again"));
    true
}

/// References to nodes that must be steps of a kind.
fn check_steps(document: &Document, found: &FirstReading, diagnostics: &mut Diagnostics) {
    let model = &found.model;
    let is_enclosing = |node: NodeId| matches!(model.nodes[node].kind, NodeKind::Enclosing(_));
    for grafcet in &model.grafcets {
        if grafcet.enclosing_step.is_some_and(|step| !is_enclosing(step)) {
            diagnostics.push(misled(&document.elements[grafcet.element], "enclosingStep", "an enclosing step"));
        }
    }
    let has_activity =
        |node: NodeId| model.nodes[node].kind.is_step() || matches!(model.nodes[node].kind, NodeKind::Macro(_));
    for variable in &model.variables {
        if matches!(variable.kind, VariableKind::Step(Some(step)) if !has_activity(step)) {
            diagnostics.push(misled(&document.elements[variable.element], "step", "a step"));
        }
    }
    let is_partial = |id: GrafcetId| model.grafcets[id].kind == GrafcetKind::Partial;
    for node in &model.nodes {
        let element = &document.elements[node.element];
        match &node.kind {
            NodeKind::Macro(Some(id)) if model.grafcets[*id].kind != GrafcetKind::Expansion => {
                diagnostics.push(misled(element, "expansion", "an expansion"));
            }
            NodeKind::Enclosing(grafcets) if !grafcets.iter().all(|&id| is_partial(id)) => {
                diagnostics.push(misled(element, "partialGrafcets", "a partial grafcet"));
            }
            NodeKind::Step
            | NodeKind::Enclosing(_)
            | NodeKind::Entry
            | NodeKind::Exit
            | NodeKind::Macro(_)
            | NodeKind::Transition(_)
            | NodeKind::Synchronization => {}
        }
    }
    for action in &model.actions {
        if matches!(action.kind, ActionKind::Force { grafcet: Some(id), .. } if !is_partial(id)) {
            let message = "what a forcing order forces is not a partial grafcet";
            diagnostics.push(Diagnostic::new(Code::E0704, action.span, message).help("let it force a partial grafcet"));
        }
        if let ActionKind::Force { steps, .. } = &action.kind
            && steps.iter().any(|&step| !has_activity(step))
        {
            diagnostics.push(
                Diagnostic::new(Code::E0704, action.span, "a forced step is not a step")
                    .help("name steps of the grafcet"),
            );
        }
    }
}

fn as_node(entity: Entity) -> Option<NodeId> {
    match entity {
        Entity::Node(id) => Some(id),
        _ => None,
    }
}

fn as_grafcet(entity: Entity) -> Option<GrafcetId> {
    match entity {
        Entity::Grafcet(id) => Some(id),
        _ => None,
    }
}

fn as_action(entity: Entity) -> Option<ActionId> {
    match entity {
        Entity::Action(id) => Some(id),
        _ => None,
    }
}

/// A step of a way: from which element, by which feature, to which place in it.
type Hop<'a> = (ElementId, &'a str, u32);

fn places(document: &Document) -> FxHashMap<Hop<'_>, ElementId> {
    let mut places = FxHashMap::default();
    let mut counts: FxHashMap<&str, u32> = FxHashMap::default();
    for (parent, element) in document.elements.iter_enumerated() {
        counts.clear();
        for &child in &element.children {
            let feature = document.elements[child].name.as_str();
            let count = counts.entry(feature).or_default();
            places.insert((parent, feature, *count), child);
            *count += 1;
        }
    }
    places
}

fn ids(document: &Document) -> FxHashMap<&str, ElementId> {
    document.elements.iter_enumerated().filter_map(|(id, element)| Some((element.attribute("xmi:id")?, id))).collect()
}

struct Resolver<'a> {
    places: FxHashMap<Hop<'a>, ElementId>,
    ids: FxHashMap<&'a str, ElementId>,
    roots: &'a [ElementId],
    entities: &'a IndexVec<ElementId, Entity>,
    diagnostics: &'a mut Diagnostics,
}

impl Resolver<'_> {
    /// The element that a reference means.
    fn find(&self, reference: &str) -> Option<ElementId> {
        let reference = reference.strip_prefix('#').unwrap_or(reference);
        let Some(way) = reference.strip_prefix('/') else { return self.ids.get(reference).copied() };
        let mut segments = way.split('/');
        let root = match segments.next() {
            None | Some("") => 0,
            Some(number) => number.parse().ok()?,
        };
        let mut at = *self.roots.get(root)?;
        for segment in segments.filter(|segment| !segment.is_empty()) {
            let segment = segment.strip_prefix('@')?;
            let (feature, place) = match segment.rsplit_once('.') {
                Some((feature, place)) => (feature, place.parse().ok()?),
                None => (segment, 0),
            };
            at = *self.places.get(&(at, feature, place))?;
        }
        Some(at)
    }

    fn one<T>(
        &mut self,
        element: &Element,
        (name, reference): (&str, &str),
        what: &str,
        kind: impl Fn(Entity) -> Option<T>,
    ) -> Option<T> {
        match self.find(reference) {
            None => {
                let message = format!("`{name}` of `{}` refers to `{reference}`, which is not there", element.name);
                self.diagnostics.push(
                    Diagnostic::new(Code::E0704, element.span, message)
                        .help("restore what is missing, or delete what refers to it"),
                );
                None
            }
            Some(target) => {
                let meant = kind(self.entities[target]);
                if meant.is_none() {
                    self.misled(element, name, what);
                }
                meant
            }
        }
    }

    fn misled(&mut self, element: &Element, name: &str, what: &str) {
        self.diagnostics.push(misled(element, name, what));
    }

    fn optional<T>(
        &mut self,
        element: &Element,
        name: &str,
        what: &str,
        kind: impl Fn(Entity) -> Option<T>,
    ) -> Option<T> {
        let reference = element.attribute(name)?;
        self.one(element, (name, reference.trim()), what, kind)
    }

    fn required<T>(
        &mut self,
        element: &Element,
        name: &str,
        what: &str,
        kind: impl Fn(Entity) -> Option<T>,
    ) -> Option<T> {
        if element.attribute(name).is_none() {
            let message = format!("`{}` has no `{name}`", element.name);
            self.diagnostics.push(
                Diagnostic::new(Code::E0704, element.span, message).help(format!("say which, {what}, or delete it")),
            );
        }
        self.optional(element, name, what, kind)
    }

    fn list<T>(&mut self, element: &Element, name: &str, what: &str, kind: impl Fn(Entity) -> Option<T>) -> Vec<T> {
        let references = element.attribute(name).unwrap_or_default();
        let references = references.split_ascii_whitespace();
        references.filter_map(|reference| self.one(element, (name, reference), what, &kind)).collect()
    }
}

fn misled(element: &Element, name: &str, what: &str) -> Diagnostic {
    let reference = element.attribute(name).unwrap_or_default();
    let message = format!("`{name}` of `{}` refers to `{reference}`, which is not {what}", element.name);
    Diagnostic::new(Code::E0704, element.span, message).help(format!("let it refer to {what}"))
}
