//! The items of a file as flat lists, each with the frame that holds it.
//!
//! Blocks nest (`grafcet { expansion { expansion { … } } }`), so they are walked with a stack of our own. Ids are given out
//! here, in source order; whatever is wrong with an item, it keeps its id, so that the rest of it can still be checked.

use crate::chart::{GrafcetId, MacroId, Node, StepId, TransitionId};
use grafc_diagnostics::{Scope, Span};
use grafc_syntax::ast;
use index_vec::{IndexVec, define_index_type};

define_index_type! {
    /// An `expansion` block.
    pub struct ExpansionId = u32;
}

/// What directly holds a step or a transition; no arc leaves it (E0305).
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Frame {
    /// A partial grafcet, implied or written.
    Grafcet(GrafcetId),
    /// The expansion of a macro-step.
    Expansion(ExpansionId),
}

/// All items of a file.
pub struct Parts<'a> {
    /// The heading, if there is one.
    pub heading: Option<&'a ast::Heading>,
    /// Declarations.
    pub declarations: Vec<&'a ast::Declaration>,
    /// Partial grafcets.
    pub grafcets: IndexVec<GrafcetId, GrafcetPart<'a>>,
    /// Expansions.
    pub expansions: IndexVec<ExpansionId, ExpansionPart<'a>>,
    /// Steps, macro-steps among them.
    pub steps: Vec<StepPart<'a>>,
    /// Where in `steps` each step is.
    step_places: IndexVec<StepId, u32>,
    /// Where in `steps` each macro-step is.
    macro_places: IndexVec<MacroId, u32>,
    /// Transitions.
    pub transitions: IndexVec<TransitionId, TransitionPart<'a>>,
    /// Steps and transitions in source order: the order in which their actions count.
    pub holders: Vec<Holder>,
    /// A grafcet made up for what belongs to none: bare steps beside grafcet blocks (E0317), expansions without a
    /// macro-step (E0301, E0306). Rules on grafcets leave it alone, since the fault has been reported.
    pub stray: Option<GrafcetId>,
    /// The bare steps and transitions in `stray`.
    pub bare: Vec<Span>,
    /// What is allowed, each with the part of the text that it is allowed in.
    pub allows: Vec<(&'a ast::Allow, Scope)>,
    /// Claims.
    pub claims: Vec<&'a ast::Claim>,
    /// Scenarios, in source order.
    pub scenarios: Vec<&'a ast::Scenario>,
    /// The end of the text.
    pub end: Span,
}

/// A partial grafcet.
pub struct GrafcetPart<'a> {
    /// Its block; none if it is implied.
    pub ast: Option<&'a ast::Grafcet>,
    /// Where to point at.
    pub span: Span,
}

/// An expansion.
pub struct ExpansionPart<'a> {
    /// Its block.
    pub ast: &'a ast::Expansion,
    /// What holds it; none at the top level of a file with grafcet blocks.
    pub within: Option<Frame>,
}

/// A step of any kind.
pub struct StepPart<'a> {
    /// Its item.
    pub ast: &'a ast::Step,
    /// What holds it.
    pub frame: Frame,
    /// Its id.
    pub node: Node,
}

/// A transition.
pub struct TransitionPart<'a> {
    /// Its item.
    pub ast: &'a ast::Transition,
    /// What holds it.
    pub frame: Frame,
}

/// A block of so many items is large.
const LARGE: usize = 1024;

/// An item that holds actions.
#[derive(Clone, Copy)]
pub enum Holder {
    /// A place in [`Parts::steps`].
    Step(u32),
    /// A transition.
    Transition(TransitionId),
}

impl<'a> Parts<'a> {
    /// The items of a file.
    pub fn collect(chart: &'a ast::Chart) -> Self {
        let start = Span::new(chart.span.file, chart.span.start as usize, chart.span.start as usize);
        let mut parts = Parts {
            heading: chart.heading.as_ref(),
            declarations: Vec::new(),
            grafcets: IndexVec::new(),
            expansions: IndexVec::new(),
            steps: Vec::new(),
            step_places: IndexVec::new(),
            macro_places: IndexVec::new(),
            transitions: IndexVec::new(),
            holders: Vec::new(),
            stray: None,
            bare: Vec::new(),
            allows: Vec::new(),
            claims: Vec::new(),
            scenarios: Vec::new(),
            end: chart.span.behind(),
        };
        let has_blocks = chart.items.iter().any(|item| matches!(item, ast::Item::Grafcet(_)));
        let top = (!has_blocks).then(|| Frame::Grafcet(parts.grafcets.push(GrafcetPart { ast: None, span: start })));
        parts.expect(&chart.items);
        let mut open = vec![(chart.items.iter(), top, chart.span)];
        while let Some((items, frame, block)) = open.last_mut() {
            let (frame, block) = (*frame, *block);
            let Some(item) = items.next() else {
                open.pop();
                continue;
            };
            match item {
                ast::Item::Declaration(declaration) => parts.declarations.push(declaration),
                ast::Item::Grafcet(grafcet) => {
                    let id = parts.grafcets.push(GrafcetPart { ast: Some(grafcet), span: grafcet.name.span });
                    parts.expect(&grafcet.items);
                    open.push((grafcet.items.iter(), Some(Frame::Grafcet(id)), grafcet.span));
                }
                ast::Item::Expansion(expansion) => {
                    let id = parts.expansions.push(ExpansionPart { ast: expansion, within: frame });
                    parts.expect(&expansion.items);
                    open.push((expansion.items.iter(), Some(Frame::Expansion(id)), expansion.span));
                }
                ast::Item::Step(step) => {
                    let frame = frame.unwrap_or_else(|| parts.bare_item(step.label.span));
                    let place = parts.steps.len() as u32;
                    let node = match step.kind {
                        ast::StepKind::Plain | ast::StepKind::Enclosing => Node::Step(parts.step_places.push(place)),
                        ast::StepKind::Macro => Node::Macro(parts.macro_places.push(place)),
                    };
                    parts.holders.push(Holder::Step(place));
                    parts.allows.extend(step.allows.iter().map(|allow| (allow, Scope::Item(step.span))));
                    parts.steps.push(StepPart { ast: step, frame, node });
                }
                ast::Item::Transition(transition) => {
                    let frame = frame.unwrap_or_else(|| parts.bare_item(transition.span));
                    let id = parts.transitions.push(TransitionPart { ast: transition, frame });
                    parts.holders.push(Holder::Transition(id));
                    parts.allows.extend(transition.allows().iter().map(|allow| (allow, Scope::Item(transition.span))));
                }
                ast::Item::Allow(allow) => parts.allows.push((allow, Scope::Block(block))),
                ast::Item::Claim(claim) => parts.claims.push(claim),
                ast::Item::Scenario(scenario) => parts.scenarios.push(scenario),
            }
        }
        parts
    }

    /// Makes room for the items of a large block: lists that grow by doubling are half empty in the end.
    fn expect(&mut self, items: &[ast::Item]) {
        if items.len() < LARGE {
            return;
        }
        let count = |wanted: fn(&ast::Item) -> bool| items.iter().filter(|item| wanted(item)).count();
        let steps = count(|item| matches!(item, ast::Item::Step(_)));
        let transitions = count(|item| matches!(item, ast::Item::Transition(_)));
        self.declarations.reserve_exact(count(|item| matches!(item, ast::Item::Declaration(_))));
        self.steps.reserve_exact(steps);
        self.step_places.raw.reserve_exact(steps);
        self.transitions.raw.reserve_exact(transitions);
        self.holders.reserve_exact(steps + transitions);
    }

    /// The step or macro-step as written.
    pub fn step(&self, node: Node) -> &StepPart<'a> {
        let place = match node {
            Node::Step(id) => self.step_places[id],
            Node::Macro(id) => self.macro_places[id],
        };
        &self.steps[place as usize]
    }

    /// The steps, and then the macro-steps.
    pub fn nodes(&self) -> impl Iterator<Item = Node> + use<> {
        let (steps, macro_steps) = (self.step_places.indices(), self.macro_places.indices());
        steps.map(Node::Step).chain(macro_steps.map(Node::Macro))
    }

    /// The grafcet of items that belong to none.
    pub fn stray(&mut self) -> GrafcetId {
        let span =
            self.bare.first().copied().or_else(|| self.expansions.first().map(|e| e.ast.span)).unwrap_or_default();
        *self.stray.get_or_insert_with(|| self.grafcets.push(GrafcetPart { ast: None, span }))
    }

    /// Whether rules about grafcets apply to this one.
    pub fn is_stray(&self, grafcet: GrafcetId) -> bool {
        self.stray == Some(grafcet)
    }

    fn bare_item(&mut self, span: Span) -> Frame {
        self.bare.push(span);
        Frame::Grafcet(self.stray())
    }
}
