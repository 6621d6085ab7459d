//! The checked chart: names resolved, types known, hierarchy known acyclic.
//!
//! Macro-steps, enclosures and forcing are still whole. Every list is in order of declaration, and ids are places in
//! these lists. Expressions lie in one pool, children before parents; walk it with loops, never by recursion.
//!
//! [`Tables`] are what a text came to, as far as it went; a [`Chart`] is tables that break no rule. Only
//! [`check`](crate::check()) makes one of the other, so what runs or lowers a chart asks for a `Chart`, and what draws
//! or describes one is content with tables.

mod bits;
mod claims;
mod controls;
mod expression;
mod note;
mod scenario;

pub use crate::profile::ChartOptions;
pub use bits::Bits;
pub use claims::{Claim, ClaimBody, ClaimKind, Claims};
pub use controls::{ControlNames, Controls};
use ecow::EcoString;
pub use expression::{Arithmetic, Comparison, DelayTime, Expr, ExprKind, below};
use grafc_diagnostics::{Allowances, Span};
pub use grafc_syntax::ast::{PulseKind, Type};
use index_vec::{IndexVec, define_index_type};
pub use note::Note;
pub use scenario::{Condition, Scenario, ScenarioExpectation, ScenarioInput, ScenarioLine, ScenarioTime};
use smallvec::SmallVec;
use std::ops::Deref;

macro_rules! ids {
    ($($(#[$doc:meta])* $name:ident $format:literal;)*) => {
        $(define_index_type! {
            $(#[$doc])*
            pub struct $name = u32;
            DISPLAY_FORMAT = $format;
            DEBUG_FORMAT = $format;
        })*
    };
}

ids! {
    /// A declared variable.
    VariableId "v{}";
    /// A step; macro-steps are not among them.
    StepId "s{}";
    /// A macro-step.
    MacroId "m{}";
    /// A transition.
    TransitionId "t{}";
    /// A partial grafcet.
    GrafcetId "g{}";
    /// An expression.
    ExprId "e{}";
}

/// A chart that breaks no rule.
#[derive(Clone, Debug)]
pub struct Chart(Tables);

impl Chart {
    /// The tables of a chart, once every rule has been applied to them.
    pub(crate) fn checked(tables: Tables) -> Self {
        Chart(tables)
    }

    /// The tables, to be changed in place. A caller that does so, as tests do, must make sure that no rule is broken.
    pub fn edit(&mut self) -> &mut Tables {
        &mut self.0
    }

    /// Where arcs into a macro-step lead.
    ///
    /// # Panics
    /// If an edit took it away.
    pub fn entry(&self, id: MacroId) -> StepId {
        self.macro_steps[id].entry.expect("the expansion of a macro-step has an entry step (E0306)")
    }

    /// Where arcs out of a macro-step start.
    ///
    /// # Panics
    /// If an edit took it away.
    pub fn exit(&self, id: MacroId) -> StepId {
        self.macro_steps[id].exit.expect("the expansion of a macro-step has an exit step (E0306)")
    }
}

impl From<Chart> for Tables {
    fn from(chart: Chart) -> Self {
        chart.0
    }
}

impl Tables {
    /// The value of an expression that never changes, by itself: a literal, a constant.
    pub fn constant(&self, kind: &ExprKind) -> Option<Value> {
        match kind {
            ExprKind::Literal(value) => Some(*value),
            ExprKind::Variable(id) if self.variables[*id].kind == VariableKind::Constant => {
                Some(self.variables[*id].initial())
            }
            ExprKind::Variable(_)
            | ExprKind::StepActive(_)
            | ExprKind::StepTime(_)
            | ExprKind::MacroActive(_)
            | ExprKind::GrafcetActive(_)
            | ExprKind::GrafcetFrozen(_)
            | ExprKind::Not(_)
            | ExprKind::And(..)
            | ExprKind::Or(..)
            | ExprKind::Xor(..)
            | ExprKind::Rise(_)
            | ExprKind::Fall(_)
            | ExprKind::Delay { .. }
            | ExprKind::Compare(..)
            | ExprKind::Arithmetic(..)
            | ExprKind::Negate(_)
            | ExprKind::Widen(_) => None,
        }
    }
}

impl Deref for Chart {
    type Target = Tables;

    fn deref(&self) -> &Tables {
        &self.0
    }
}

/// A chart as far as it goes: complete as part of a [`Chart`], else without what was faulty.
///
/// What there is has its place: every id is in its table, the operands of an expression come before it, and going up from
/// a macro-step to the one that holds it ends. In place of an expression that makes no sense stands `false`.
#[derive(Clone, Debug, Default)]
pub struct Tables {
    /// The name in its heading, or the name that the caller chose (of the file).
    pub name: EcoString,
    /// The attached comment.
    pub comment: Option<Note>,
    /// What its heading chooses of its meaning.
    pub options: ChartOptions,
    /// Inputs, outputs, internal variables and constants, in order of declaration.
    pub variables: IndexVec<VariableId, Variable>,
    /// Steps, those of expansions included.
    pub steps: IndexVec<StepId, Step>,
    /// Macro-steps.
    pub macro_steps: IndexVec<MacroId, MacroStep>,
    /// Transitions.
    pub transitions: IndexVec<TransitionId, Transition>,
    /// Partial grafcets.
    pub grafcets: IndexVec<GrafcetId, Grafcet>,
    /// All grafcets, sorted by (level, declaration): an encloser or forcer comes before what it encloses or forces. Those
    /// that go round in a circle come last.
    pub hierarchy: Vec<GrafcetId>,
    /// Continuous actions, in order of declaration.
    pub continuous: Vec<Continuous>,
    /// Stored actions, in order of declaration.
    pub stored: Vec<Stored>,
    /// Forcing orders, in order of declaration: the first of one level has precedence.
    pub orders: Vec<Order>,
    /// Pulse orders, in order of declaration.
    pub pulses: Vec<Pulse>,
    /// Grafcets that run while steps are active, in order of declaration.
    pub runs: Vec<Run>,
    /// The pool of expressions.
    pub exprs: IndexVec<ExprId, Expr>,
    /// What is said of the chart and changes nothing in it.
    pub claims: Claims,
    /// The warnings that the text allows.
    pub allowances: Allowances,
    /// Inputs that act on the chart as a whole, if somebody asked for some.
    pub controls: Controls,
    /// The tests in its text; they change nothing of what it does.
    pub scenarios: Vec<Scenario>,
}

/// A declared variable.
#[derive(Clone, Debug)]
pub struct Variable {
    /// The name as declared, without backquotes.
    pub name: EcoString,
    /// The attached comment.
    pub comment: Option<Note>,
    /// Input, output, internal or constant.
    pub kind: VariableKind,
    /// The type.
    pub ty: Type,
    /// The [initial](Variable::initial) value.
    pub start: Bits,
    /// Whether its value is kept over a restart of the controller (`retain`).
    pub retain: bool,
    /// Whether it is false again before the first micro-step of each reaction: an output on arcs of automata in a chart that
    /// evolves to stability.
    pub momentary: bool,
    /// `%IX0.0`, counted on where several names shared one.
    pub address: Option<Note>,
    /// How it gets its value.
    pub mode: Mode,
    /// The name in its declaration.
    pub span: Span,
}

impl Variable {
    /// A variable that starts with a value of its type, gets others from outside, and has nothing else to be said of it.
    pub fn new(name: impl Into<EcoString>, kind: VariableKind, ty: Type, initial: Value, span: Span) -> Variable {
        Variable {
            name: name.into(),
            comment: None,
            kind,
            ty,
            start: Bits::of(initial, ty),
            retain: false,
            momentary: false,
            address: None,
            mode: Mode::Given,
            span,
        }
    }

    /// `:= value`, or the zero of the type; the value of a constant.
    pub fn initial(&self) -> Value {
        self.start.value(self.ty)
    }

    /// Gives it another initial value of its type.
    pub fn set_initial(&mut self, initial: Value) {
        self.start = Bits::of(initial, self.ty);
    }
}

/// The kinds of variable.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum VariableKind {
    /// Given from outside before each reaction.
    Input,
    /// Published after each reaction.
    Output,
    /// Internal.
    Internal,
    /// Never changes.
    Constant,
}

/// How a variable gets its value (`M` of rule A1: a name is either a wire or stored, never both).
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Mode {
    /// From outside, or constant, or never: the value is the input or `initial`.
    Given,
    /// By continuous actions: true while one of them applies.
    Wire,
    /// By stored actions.
    Stored,
}

/// A value. `Bool`, the four integers as `Int`, both reals as `Real` (a `real` is rounded to single), `time` as `Time`.
///
/// Two are equal if one in the place of the other is no change. That is not what a chart asks with `=`: there a real that
/// is no number differs from itself.
#[derive(Clone, Copy, Debug)]
pub enum Value {
    /// `bool`
    Bool(bool),
    /// `int`, `dint`, `uint`, `udint`
    Int(i64),
    /// `real`, `lreal`
    Real(f64),
    /// `time`, in milliseconds
    Time(i64),
}

impl PartialEq for Value {
    fn eq(&self, other: &Self) -> bool {
        match (*self, *other) {
            (Value::Bool(a), Value::Bool(b)) => a == b,
            (Value::Int(a), Value::Int(b)) | (Value::Time(a), Value::Time(b)) => a == b,
            (Value::Real(a), Value::Real(b)) => a == b || a.is_nan() && b.is_nan(),
            (Value::Bool(_) | Value::Int(_) | Value::Real(_) | Value::Time(_), _) => false,
        }
    }
}

/// A step.
#[derive(Clone, Debug)]
pub struct Step {
    /// The label: `X` + label is its activity, `T` + label its duration.
    pub label: EcoString,
    /// The attached comment.
    pub comment: Option<Note>,
    /// The partial grafcet that it belongs to; steps of an expansion belong to their macro-step's (M1).
    pub grafcet: GrafcetId,
    /// The macro-step whose expansion holds it directly.
    pub expansion_of: Option<MacroId>,
    /// In the initial situation.
    pub initial: bool,
    /// Has an activation link.
    pub activated: bool,
    /// Is an enclosing step.
    pub enclosing: bool,
    /// The label in its declaration.
    pub span: Span,
}

/// A macro-step and its expansion (M1).
#[derive(Clone, Debug)]
pub struct MacroStep {
    /// The label: `X` + label is its activity.
    pub label: EcoString,
    /// The attached comment.
    pub comment: Option<Note>,
    /// The partial grafcet that it belongs to.
    pub grafcet: GrafcetId,
    /// The macro-step whose expansion holds it directly.
    pub expansion_of: Option<MacroId>,
    /// The comment attached to its expansion.
    pub expansion_comment: Option<Note>,
    /// Where arcs into it lead; a [`Chart`] has it.
    pub entry: Option<StepId>,
    /// Where arcs out of it start; a [`Chart`] has it.
    pub exit: Option<StepId>,
    /// The label in its declaration.
    pub span: Span,
}

/// One end of an arc.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Node {
    /// A step.
    Step(StepId),
    /// A macro-step.
    Macro(MacroId),
}

/// The ends of the arcs of a transition on one side: mostly few, which then lie in the transition itself.
pub type Nodes = SmallVec<[Node; 2]>;

/// A transition.
#[derive(Clone, Debug)]
pub struct Transition {
    /// The designation in parentheses.
    pub designation: Option<Note>,
    /// The attached comment.
    pub comment: Option<Note>,
    /// The partial grafcet that it belongs to.
    pub grafcet: GrafcetId,
    /// The immediately preceding steps, without repetition.
    pub pre: Nodes,
    /// The immediately succeeding steps, without repetition.
    pub post: Nodes,
    /// The transition-condition; Boolean.
    pub condition: ExprId,
    /// The whole item.
    pub span: Span,
}

/// A partial grafcet.
#[derive(Clone, Debug)]
pub struct Grafcet {
    /// The name: `X` + name is its activity.
    pub name: EcoString,
    /// The attached comment.
    pub comment: Option<Note>,
    /// The step that encloses it.
    pub enclosing_step: Option<StepId>,
    /// Whether it is a child: not active at the start, and started by an order.
    pub child: bool,
    /// The grafcet whose steps command it, of a child that names one that there is.
    pub parent: Option<GrafcetId>,
    /// Longest chain of orders and enclosures above it (M2); 0 at the top.
    pub level: u32,
    /// Its steps, those of expansions included, in order of declaration.
    pub steps: Vec<StepId>,
    /// The name in its heading (of an implied grafcet: the start of the text).
    pub span: Span,
}

/// A continuous action: `target` is true while `step` is active and `condition` holds.
#[derive(Clone, Debug)]
pub struct Continuous {
    /// The step.
    pub step: StepId,
    /// The output or internal variable.
    pub target: VariableId,
    /// The assignment condition; none is always true.
    pub condition: Option<ExprId>,
    /// The whole action.
    pub span: Span,
}

/// A stored action: `target := value` when `event` occurs.
#[derive(Clone, Debug)]
pub struct Stored {
    /// When.
    pub event: Event,
    /// What is assigned.
    pub target: VariableId,
    /// The value; of the target's type.
    pub value: ExprId,
    /// The whole action.
    pub span: Span,
}

/// When a stored action is done (R7).
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum Event {
    /// Kind E: the step is active in the old situation and the expression is true.
    Event(StepId, ExprId),
    /// Kind D: the step is deactivated.
    Deactivation(StepId),
    /// Kind T: the transition is cleared.
    Clearing(TransitionId),
    /// Kind A: the step is activated.
    Activation(StepId),
    /// Kind S: once a scan, while the step is active after it and the expression is true (R15).
    EachScan(StepId, Option<ExprId>),
}

/// A forcing order, in force while its step is active (R2).
#[derive(Clone, Debug)]
pub struct Order {
    /// The forcing step.
    pub step: StepId,
    /// The forced grafcet.
    pub grafcet: GrafcetId,
    /// The forced situation.
    pub situation: Situation,
    /// The whole order.
    pub span: Span,
}

/// A pulse order (R15).
#[derive(Clone, Debug)]
pub struct Pulse {
    /// What is ordered.
    pub kind: PulseKind,
    /// When, as of a stored action.
    pub event: Event,
    /// Of which grafcet.
    pub grafcet: GrafcetId,
    /// The whole order.
    pub span: Span,
}

/// A grafcet that runs while a step is active (R15): started when the first of such steps becomes active, and killed when the
/// last of them no longer is.
#[derive(Clone, Debug)]
pub struct Run {
    /// The step.
    pub step: StepId,
    /// The grafcet.
    pub grafcet: GrafcetId,
    /// The whole order.
    pub span: Span,
}

impl Tables {
    /// The step or transition whose grafcet gives a pulse.
    pub fn commander(&self, event: Event) -> Option<GrafcetId> {
        match event {
            Event::Event(step, _) | Event::Deactivation(step) | Event::Activation(step) | Event::EachScan(step, _) => {
                self.steps.get(step).map(|step| step.grafcet)
            }
            Event::Clearing(transition) => self.transitions.get(transition).map(|transition| transition.grafcet),
        }
    }

    /// All commands by pulses: the grafcet that gives it, the one that it is given to, and its place.
    pub fn commands(&self) -> impl Iterator<Item = (GrafcetId, GrafcetId, Span)> + '_ {
        let pulses =
            self.pulses.iter().filter_map(|pulse| Some((self.commander(pulse.event)?, pulse.grafcet, pulse.span)));
        let runs = self.runs.iter().filter_map(|run| Some((self.steps.get(run.step)?.grafcet, run.grafcet, run.span)));
        pulses.chain(runs)
    }
}

/// A forced situation.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Situation {
    /// Exactly these steps of the grafcet, in order of declaration, without repetition.
    Steps(Vec<StepId>),
    /// The current situation, frozen.
    Current,
    /// The initial situation.
    Initial,
}
