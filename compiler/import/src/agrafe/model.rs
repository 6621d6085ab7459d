//! A chart as AGRAFE has it: the classes of its meta-model, in tables.

use crate::xml::ElementId;
use grafc_diagnostics::Span;
use index_vec::{IndexVec, define_index_type};

define_index_type! {
    /// A variable declaration.
    pub struct VariableId = u32;
}
define_index_type! {
    /// A grafcet: the chart itself, a partial grafcet or an expansion.
    pub struct GrafcetId = u32;
}
define_index_type! {
    /// A step of any kind, a transition or a synchronisation.
    pub struct NodeId = u32;
}
define_index_type! {
    /// An action or a forcing order.
    pub struct ActionId = u32;
}
define_index_type! {
    /// A term.
    pub struct TermId = u32;
}

/// All of a chart, each table in the order of the file.
#[derive(Default)]
pub struct Model {
    /// The name of the chart, if it has one.
    pub name: Option<String>,
    /// Variable declarations.
    pub variables: IndexVec<VariableId, Variable>,
    /// Grafcets; the first is the chart itself.
    pub grafcets: IndexVec<GrafcetId, Grafcet>,
    /// Steps, transitions, synchronisations.
    pub nodes: IndexVec<NodeId, AgrafeNode>,
    /// Directed links.
    pub arcs: Vec<Arc>,
    /// Actions and forcing orders.
    pub actions: IndexVec<ActionId, Action>,
    /// Which step has which action.
    pub links: Vec<ActionLink>,
    /// Terms, parents before children.
    pub terms: IndexVec<TermId, Term>,
}

/// `VariableDeclaration`.
pub struct Variable {
    pub name: Option<String>,
    pub kind: VariableKind,
    pub sort: Sort,
    pub span: Span,
    pub element: ElementId,
}

/// `VariableDeclarationType`.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum VariableKind {
    Input,
    Output,
    Internal,
    /// The activity of a step, if it says of which.
    Step(Option<NodeId>),
}

/// `Sort`.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Sort {
    Bool,
    Integer,
}

/// `Grafcet` and its subclasses.
pub struct Grafcet {
    pub kind: GrafcetKind,
    pub name: Option<String>,
    /// `PartialGrafcet.enclosingStep`.
    pub enclosing_step: Option<NodeId>,
    /// Steps, macro-steps, transitions and synchronisations.
    pub nodes: Vec<NodeId>,
    pub span: Span,
    pub element: ElementId,
}

/// The subclasses of `Grafcet`.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum GrafcetKind {
    Chart,
    Partial,
    Expansion,
}

/// `Node` and its subclasses.
pub struct AgrafeNode {
    pub kind: NodeKind,
    pub id: i32,
    pub initial: bool,
    pub activation_link: bool,
    pub grafcet: GrafcetId,
    pub span: Span,
    pub element: ElementId,
}

/// The subclasses of `Node`.
pub enum NodeKind {
    Step,
    /// With the grafcets that it says it encloses.
    Enclosing(Vec<GrafcetId>),
    Entry,
    Exit,
    /// With its expansion.
    Macro(Option<GrafcetId>),
    Transition(Condition),
    Synchronization,
}

impl NodeKind {
    /// Whether it can be active by itself.
    pub fn is_step(&self) -> bool {
        match self {
            NodeKind::Step | NodeKind::Enclosing(_) | NodeKind::Entry | NodeKind::Exit => true,
            NodeKind::Macro(_) | NodeKind::Transition(_) | NodeKind::Synchronization => false,
        }
    }
}

/// `Arc`.
#[derive(Clone, Copy)]
pub struct Arc {
    pub source: NodeId,
    pub target: NodeId,
    pub span: Span,
}

/// `ActionLink`.
#[derive(Clone, Copy)]
pub struct ActionLink {
    pub step: NodeId,
    pub action: ActionId,
    pub span: Span,
}

/// `ActionType` and its subclasses.
pub struct Action {
    pub kind: ActionKind,
    pub span: Span,
}

/// The subclasses of `ActionType`. What is required and missing is an error, so that writers of charts can rely on it.
pub enum ActionKind {
    Continuous {
        variable: Option<TermId>,
        /// `ContinuousActionType.assignationCondition`: only then does the condition count.
        conditional: bool,
        condition: Condition,
    },
    Stored {
        variable: Option<TermId>,
        event: StoredActionType,
        value: Option<TermId>,
        condition: Option<TermId>,
    },
    Force {
        grafcet: Option<GrafcetId>,
        order: ForcingOrderType,
        steps: Vec<NodeId>,
    },
}

/// `StoredActionType`.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum StoredActionType {
    Activation,
    Deactivation,
    Event,
}

/// `ForcingOrderType`.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum ForcingOrderType {
    Current,
    Empty,
    Initial,
    Explicit,
}

/// `TimeCondition`.
#[derive(Clone, Copy)]
pub struct Condition {
    pub term: Option<TermId>,
    pub time: TimeConditionType,
    pub delay: Delay,
    pub reset: Delay,
}

/// `TimeConditionType`.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum TimeConditionType {
    None,
    Dependent,
    Delayed,
    Limited,
}

/// A whole number of a `TimeUnit`.
#[derive(Clone, Copy)]
pub struct Delay {
    pub count: i32,
    /// `s` or `ms`.
    pub unit: &'static str,
}

/// `Term`.
pub struct Term {
    pub kind: TermKind,
    pub operands: Vec<TermId>,
    pub span: Span,
}

/// The subclasses of `Term`.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum TermKind {
    /// Of an unreadable one an error tells.
    Variable(Option<VariableId>),
    Boolean(bool),
    Integer(i32),
    Not,
    And,
    Or,
    Rise,
    Fall,
    Equal,
    Greater,
    Less,
    Add,
    Subtract,
}
