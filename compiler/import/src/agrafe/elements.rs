//! What each element is: the first of two readings, which leaves out what refers to other elements.
//!
//! An element is known by the feature that holds it, so parents come first; that is the order in which elements lie.
//! What the meta-model does not know is lost, with all that is in it.

use super::attributes::{self, Declares, class};
use super::model::{
    Action, ActionId, ActionKind, AgrafeNode, Condition, Grafcet, GrafcetId, GrafcetKind, Model, NodeId, NodeKind,
    Sort, Term, TermId, TermKind, Variable, VariableId, VariableKind,
};
use crate::lost;
use crate::xml::{Document, Element, ElementId};
use grafc_diagnostics::{Code, Diagnostic, Diagnostics};
use index_vec::IndexVec;

/// What an element is.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Entity {
    Grafcet(GrafcetId),
    /// `VariableDeclarationContainer`.
    Container,
    Variable(VariableId),
    Node(NodeId),
    Arc,
    Action(ActionId),
    ActionLink,
    Term(TermId),
    /// It repeats what is known: the sort of a variable or of a term.
    Notation,
    /// Not of the chart; if it should be, a message has been given.
    Lost,
}

/// What the first reading finds.
pub struct FirstReading {
    /// Without what refers to other elements.
    pub model: Model,
    /// What each element is.
    pub entities: IndexVec<ElementId, Entity>,
}

/// The first reading, of what is in `root`.
pub fn read(document: &Document, root: ElementId, diagnostics: &mut Diagnostics) -> FirstReading {
    let entities = IndexVec::with_capacity(document.elements.len());
    let mut reader = Reader { found: FirstReading { model: Model::default(), entities }, diagnostics };
    for (id, element) in document.elements.iter_enumerated() {
        let entity = match element.parent {
            _ if id == root => reader.grafcet(element, id, GrafcetKind::Chart),
            Some(parent) => reader.element(element, id, reader.found.entities[parent]),
            None => Entity::Lost,
        };
        reader.unknown_attributes(element, entity);
        reader.found.entities.push(entity);
    }
    reader.found.model.name = document.elements[root].attribute("name").map(str::to_string);
    reader.found
}

struct Reader<'a> {
    found: FirstReading,
    diagnostics: &'a mut Diagnostics,
}

impl Reader<'_> {
    fn element(&mut self, element: &Element, id: ElementId, parent: Entity) -> Entity {
        match (parent, element.name.as_str()) {
            (Entity::Grafcet(_), "variableDeclarationContainer") => Entity::Container,
            (Entity::Grafcet(_), "partialGrafcets") => match class(element) {
                Some("PartialGrafcet" | "Grafcet") | None => self.grafcet(element, id, GrafcetKind::Partial),
                Some("MacrostepExpansion") => self.grafcet(element, id, GrafcetKind::Expansion),
                Some(_) => self.wrong_class(element),
            },
            (Entity::Grafcet(grafcet), "steps") => match class(element) {
                Some("Step" | "InitializableType") | None => self.node(element, id, grafcet, NodeKind::Step),
                Some("EnclosingStep") => self.node(element, id, grafcet, NodeKind::Enclosing(Vec::new())),
                Some(_) => self.wrong_class(element),
            },
            (Entity::Grafcet(grafcet), "entryStep" | "exitStep") => {
                if self.found.model.grafcets[grafcet].kind != GrafcetKind::Expansion {
                    return self.unknown(element);
                }
                let kind = if element.name == "entryStep" { NodeKind::Entry } else { NodeKind::Exit };
                self.node(element, id, grafcet, kind)
            }
            (Entity::Grafcet(grafcet), "macrosteps") => self.node(element, id, grafcet, NodeKind::Macro(None)),
            (Entity::Grafcet(grafcet), "synchronizations") => {
                self.node(element, id, grafcet, NodeKind::Synchronization)
            }
            (Entity::Grafcet(grafcet), "transitions") => {
                let condition = self.condition(element);
                self.node(element, id, grafcet, NodeKind::Transition(condition))
            }
            (Entity::Grafcet(_), "arcs") => Entity::Arc,
            (Entity::Grafcet(_), "actionTypes") => self.action(element),
            (Entity::Grafcet(_), "actionLinks") => Entity::ActionLink,
            (Entity::Container, "variableDeclarations") => self.variable(element, id),
            (Entity::Variable(variable), "sort") => {
                self.found.model.variables[variable].sort = attributes::sort(element, self.diagnostics);
                Entity::Notation
            }
            (Entity::Node(_) | Entity::Action(_), feature) => self.root_term(element, parent, feature),
            (Entity::Term(parent), "subterm") => {
                let (term, entity) = self.term(element);
                self.found.model.terms[parent].operands.push(term);
                entity
            }
            (Entity::Term(_), "output") => Entity::Notation,
            (Entity::Notation | Entity::Lost, _) => Entity::Lost,
            (_, _) => self.unknown(element),
        }
    }

    fn unknown(&mut self, element: &Element) -> Entity {
        self.diagnostics.push(
            lost(element.span, format!("the element `{}` is lost, with what is in it", element.name))
                .note("AGRAFE's meta-model has no such feature here"),
        );
        Entity::Lost
    }

    fn wrong_class(&mut self, element: &Element) -> Entity {
        attributes::wrong(element, "xsi:type", "a class that this feature can hold", self.diagnostics);
        Entity::Lost
    }

    fn grafcet(&mut self, element: &Element, id: ElementId, kind: GrafcetKind) -> Entity {
        let name = element.attribute("name").map(str::to_string);
        let (nodes, span) = (Vec::new(), element.span);
        let grafcet = Grafcet { kind, name, enclosing_step: None, nodes, span, element: id };
        Entity::Grafcet(self.found.model.grafcets.push(grafcet))
    }

    fn variable(&mut self, element: &Element, id: ElementId) -> Entity {
        let kind = match attributes::variable_declaration_type(element, self.diagnostics) {
            Declares::Input => VariableKind::Input,
            Declares::Output => VariableKind::Output,
            Declares::Internal => VariableKind::Internal,
            Declares::Step => VariableKind::Step(None),
        };
        let name = element.attribute("name").map(str::to_string);
        let variable = Variable { name, kind, sort: Sort::Bool, span: element.span, element: id };
        Entity::Variable(self.found.model.variables.push(variable))
    }

    fn node(&mut self, element: &Element, id: ElementId, grafcet: GrafcetId, kind: NodeKind) -> Entity {
        let node = self.found.model.nodes.push(AgrafeNode {
            kind,
            id: attributes::integer(element, "id", self.diagnostics),
            initial: attributes::boolean(element, "initial", self.diagnostics),
            activation_link: attributes::boolean(element, "activationLink", self.diagnostics),
            grafcet,
            span: element.span,
            element: id,
        });
        self.found.model.grafcets[grafcet].nodes.push(node);
        Entity::Node(node)
    }

    fn condition(&mut self, element: &Element) -> Condition {
        let (time, delay, reset) = attributes::time(element, self.diagnostics);
        Condition { term: None, time, delay, reset }
    }

    fn action(&mut self, element: &Element) -> Entity {
        let kind = match class(element) {
            Some("ContinuousAction") => ActionKind::Continuous {
                variable: None,
                conditional: attributes::is_conditional(element, self.diagnostics),
                condition: self.condition(element),
            },
            Some("StoredAction") => ActionKind::Stored {
                variable: None,
                event: attributes::stored_action_type(element, self.diagnostics),
                value: None,
                condition: None,
            },
            Some("ForcingOrder") => ActionKind::Force {
                grafcet: None,
                order: attributes::forcing_order_type(element, self.diagnostics),
                steps: Vec::new(),
            },
            Some(_) | None => return self.wrong_class(element),
        };
        Entity::Action(self.found.model.actions.push(Action { kind, span: element.span }))
    }

    /// A term that is not part of another.
    fn root_term(&mut self, element: &Element, parent: Entity, feature: &str) -> Entity {
        let next = TermId::new(self.found.model.terms.len());
        match slot(&mut self.found.model, parent, feature) {
            None => self.unknown(element),
            Some(Some(_)) => {
                self.diagnostics.push(
                    Diagnostic::new(Code::E0705, element.span, format!("there is a second `{feature}`"))
                        .help("delete one of them"),
                );
                Entity::Lost
            }
            Some(free) => {
                *free = Some(next);
                self.term(element).1
            }
        }
    }

    /// A term, and what its element is: of one that has no class, the rest is not looked at.
    fn term(&mut self, element: &Element) -> (TermId, Entity) {
        let kind = match (class(element), element.name.as_str()) {
            (Some("Variable"), _) | (None, "variable") => TermKind::Variable(None),
            (Some("And"), _) => TermKind::And,
            (Some("Or"), _) => TermKind::Or,
            (Some("Not"), _) => TermKind::Not,
            (Some("RisingEdge"), _) => TermKind::Rise,
            (Some("FallingEdge"), _) => TermKind::Fall,
            (Some("Equality"), _) => TermKind::Equal,
            (Some("GreaterThan"), _) => TermKind::Greater,
            (Some("LessThan"), _) => TermKind::Less,
            (Some("Addition"), _) => TermKind::Add,
            (Some("Substraction"), _) => TermKind::Subtract,
            (Some("BooleanConstant"), _) => TermKind::Boolean(attributes::boolean(element, "value", self.diagnostics)),
            (Some("IntegerConstant"), _) => TermKind::Integer(attributes::integer(element, "value", self.diagnostics)),
            (_, _) => {
                let entity = self.wrong_class(element);
                return (self.push_term(element, TermKind::Variable(None)), entity);
            }
        };
        let term = self.push_term(element, kind);
        (term, Entity::Term(term))
    }

    fn push_term(&mut self, element: &Element, kind: TermKind) -> TermId {
        self.found.model.terms.push(Term { kind, operands: Vec::new(), span: element.span })
    }

    /// What an element says that the meta-model has no place for.
    fn unknown_attributes(&mut self, element: &Element, entity: Entity) {
        let known: &[&str] = match entity {
            Entity::Notation | Entity::Lost => return,
            Entity::Container => &[],
            Entity::Grafcet(id) => match self.found.model.grafcets[id].kind {
                GrafcetKind::Partial => &["name", "enclosingStep"],
                GrafcetKind::Chart | GrafcetKind::Expansion => &["name"],
            },
            Entity::Variable(_) => &["name", "variableDeclarationType", "step"],
            Entity::Node(id) => match self.found.model.nodes[id].kind {
                NodeKind::Step => &["id", "initial", "activationLink"],
                NodeKind::Enclosing(_) => &["id", "initial", "activationLink", "partialGrafcets"],
                NodeKind::Macro(_) => &["id", "expansion"],
                NodeKind::Transition(_) => &["id", "timeConditionType", "delayTime", "resetTime", "unit"],
                NodeKind::Entry | NodeKind::Exit | NodeKind::Synchronization => &["id"],
            },
            Entity::Arc => &["source", "target"],
            Entity::ActionLink => &["step", "actionType"],
            Entity::Action(id) => match self.found.model.actions[id].kind {
                ActionKind::Continuous { .. } => {
                    &["id", "continuousActionType", "timeConditionType", "delayTime", "resetTime", "unit"]
                }
                ActionKind::Stored { .. } => &["id", "storedActionType"],
                ActionKind::Force { .. } => &["id", "partialGrafcet", "forcedSteps", "forcingOrderType"],
            },
            Entity::Term(id) => match self.found.model.terms[id].kind {
                TermKind::Variable(_) => &["id", "sort", "variableDeclaration"],
                TermKind::Boolean(_) | TermKind::Integer(_) => &["id", "sort", "input", "value"],
                TermKind::Not
                | TermKind::And
                | TermKind::Or
                | TermKind::Rise
                | TermKind::Fall
                | TermKind::Equal
                | TermKind::Greater
                | TermKind::Less
                | TermKind::Add
                | TermKind::Subtract => &["id", "sort", "input"],
            },
        };
        for (name, _) in &element.attributes {
            let of_xmi = ["xmi:", "xsi:", "xmlns"].iter().any(|prefix| name.starts_with(prefix));
            if !of_xmi && !known.contains(&name.as_str()) {
                self.diagnostics.push(
                    lost(element.span, format!("the attribute `{name}` of `{}` is lost", element.name))
                        .note("AGRAFE's meta-model has no such feature here"),
                );
            }
        }
    }
}

/// Where a feature of a transition or an action keeps its term.
fn slot<'m>(model: &'m mut Model, parent: Entity, feature: &str) -> Option<&'m mut Option<TermId>> {
    match parent {
        Entity::Node(node) => match (&mut model.nodes[node].kind, feature) {
            (NodeKind::Transition(condition), "term") => Some(&mut condition.term),
            (_, _) => None,
        },
        Entity::Action(action) => match (&mut model.actions[action].kind, feature) {
            (ActionKind::Continuous { variable, .. } | ActionKind::Stored { variable, .. }, "variable") => {
                Some(variable)
            }
            (ActionKind::Continuous { condition, .. }, "term") => Some(&mut condition.term),
            (ActionKind::Stored { condition, .. }, "term") => Some(condition),
            (ActionKind::Stored { value, .. }, "value") => Some(value),
            (_, _) => None,
        },
        Entity::Grafcet(_)
        | Entity::Container
        | Entity::Variable(_)
        | Entity::Arc
        | Entity::ActionLink
        | Entity::Term(_)
        | Entity::Notation
        | Entity::Lost => None,
    }
}
