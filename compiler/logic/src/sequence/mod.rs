//! A chart as a sequential function chart of IEC 61131-3, where it can be one without meaning something else.
//!
//! Such a chart evolves once a scan, clears one transition after a step, and acts through its steps. A GRAFCET chart that
//! needs more than that is refused with all its reasons (E0503): `fit` looks at the structure, `expressions` at what
//! conditions and values are made of, `actions` and `stored` at what the steps do. `prepare` finds edges and delays before the chart is
//! called.
//!
//! Requires a flat net. Ensures that the sequential function chart, with actions done after the transitions of the same
//! scan, gives the outputs of rules R1 to R14.

mod actions;
mod expressions;
mod fit;
mod networks;
mod prepare;
mod prepared;
mod stored;

use crate::analysis::Analysis;
use crate::scan::{Elements, Program, Role, Statement, VarId, Variable};
use ecow::eco_format;
use expressions::Expressions;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics, Span};
use grafc_formula::{FormulaId, Pool};
use grafc_model::chart::{Bits, Note, StepId, Type, Value};
use grafc_model::reaction::Profile;
use grafc_net::Net;
use index_vec::IndexVec;
use rustc_hash::FxHashSet;

/// A sequential function chart.
#[derive(Clone, Debug)]
pub struct Sequence {
    /// The variables and formulas. A step's activity and duration are among the variables. Statements are only those that
    /// are done before the chart, in each call, which find what it is given, and those after it, which find outputs from
    /// what it shows.
    pub program: Program,
    /// What the statements find for the chart; if there is nothing, there are no statements.
    pub given: Vec<VarId>,
    /// What the statements keep from call to call.
    pub memory: Vec<VarId>,
    /// The markers of steps that the statements read.
    pub shown: Vec<VarId>,
    /// The steps.
    pub steps: IndexVec<StepId, SequenceStep>,
    /// The transitions, in order of declaration.
    pub transitions: Vec<SequenceTransition>,
}

impl Sequence {
    /// Whether something is done before or after the chart, so that another block holds it.
    pub fn is_held(&self) -> bool {
        !self.given.is_empty() || !self.program.after.is_empty()
    }

    /// The outputs that are found after the chart.
    pub fn found_after(&self) -> impl Iterator<Item = VarId> + '_ {
        self.program.after.iter().filter_map(|statement| match statement {
            Statement::Assign { target, .. } => Some(*target),
            Statement::Heading(_)
            | Statement::Divide(_)
            | Statement::CallTimer { .. }
            | Statement::Case { .. }
            | Statement::If(_) => None,
        })
    }
}

/// A step.
#[derive(Clone, Debug)]
pub struct SequenceStep {
    /// Its activity.
    pub active: VarId,
    /// The time since its activation.
    pub duration: VarId,
    /// A variable that is true while it is active, if something other than itself reads its activity: not every tool
    /// lets a step be named before it is declared.
    pub marker: Option<VarId>,
    /// In the initial situation.
    pub initial: bool,
    /// Whether it is none of the chart: one in which a commanded grafcet rests, or that keeps another while it is frozen.
    pub auxiliary: bool,
    /// The attached comment.
    pub comment: Option<Note>,
    /// What it sets by continuous actions.
    pub holds: Vec<Hold>,
    /// Boolean variables that it sets (true) or resets on activation, and that nothing else does anything with.
    pub latches: Vec<(VarId, bool)>,
    /// What else it stores.
    pub stored: Vec<Assignment>,
}

/// A variable that a continuous action of a step sets.
#[derive(Clone, Copy, Debug)]
pub struct Hold {
    /// The variable.
    pub target: VarId,
    /// While what is true.
    pub during: During,
}

/// How a step sets a variable by a continuous action.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum During {
    /// While it is active.
    Step,
    /// From so long after its activation on.
    From(FormulaId),
    /// For so long from its activation on.
    For(FormulaId),
    /// As a value in terms of the situation has it, in each scan and when the step is left.
    Value(FormulaId),
}

/// What a step stores into a variable.
#[derive(Clone, Debug)]
pub struct Assignment {
    /// When it is done.
    pub when: When,
    /// What is written.
    pub target: VarId,
    /// The values, each under a condition; the first whose condition holds is taken. Without a condition it is the last.
    pub cases: Vec<(Option<FormulaId>, FormulaId)>,
}

/// When a step does something.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub enum When {
    /// In the scan in which it becomes active.
    Activation,
    /// In the scan in which it is left.
    Deactivation,
    /// In each scan in which it is active.
    EachScan,
}

/// A transition.
#[derive(Clone, Debug)]
pub struct SequenceTransition {
    /// The immediately preceding steps.
    pub before: Vec<StepId>,
    /// The immediately succeeding steps.
    pub after: Vec<StepId>,
    /// The transition-condition.
    pub condition: FormulaId,
}

/// The chart as a sequential function chart, or all reasons why it is none.
pub fn sequence(analysis: &Analysis, profile: Profile) -> Result<Sequence, Diagnostics> {
    let mut reasons = Reasons::default();
    fit::form(analysis.net(), &mut reasons);
    // What commanded grafcets would do is known only of networks of their own.
    let (alone, names) = match networks::find(analysis) {
        Ok(Some(networks)) => (Some(Analysis::of(networks.net.into(), &networks.situations)), networks.names),
        Ok(None) => Default::default(),
        Err(more) => {
            reasons.list.extend(more.list);
            return Err(reasons.diagnostics());
        }
    };
    let analysis = alone.as_ref().unwrap_or(analysis);
    let net = analysis.net();
    let profile = net.options.over(profile);
    fit::meaning(analysis, profile, &mut reasons);

    let mut variables = declared(net);
    let taken: FxHashSet<String> = variables.iter().map(|variable| variable.name.to_lowercase().to_string()).collect();
    let steps: IndexVec<StepId, SequenceStep> =
        net.places.iter().map(|place| step(place, &taken, &mut variables)).collect();
    let mut expressions = Expressions::new(net, &steps, names, profile);
    let transitions = net.transitions.iter().map(|transition| SequenceTransition {
        before: transition.pre.to_vec(),
        after: transition.post.to_vec(),
        condition: expressions.formula(transition.condition, own(&transition.pre), &mut reasons),
    });
    let transitions = transitions.collect();
    let mut steps = steps;
    actions::continuous(analysis, &mut steps, &mut expressions, &mut reasons);
    stored::stored(analysis, &mut steps, &mut expressions, &mut reasons);
    reasons.refuse()?;
    for (step, marker) in &expressions.markers {
        steps[*step].marker = Some(*marker);
    }
    let (first, started) = expressions.first_call();
    variables.extend(expressions.more);
    let prepared = expressions.prepared;

    let program = Program {
        name: net.name.to_string(),
        comment: net.comment.clone(),
        variables,
        timers: prepared.timers,
        pool: expressions.pool,
        steps: IndexVec::new(),
        states: Vec::new(),
        elements: Elements::default(),
        first,
        started,
        before: [prepared.before, prepared.last].concat(),
        micro_step: Vec::new(),
        repeat: None,
        most: 1,
        after: prepared.after,
        restoring: None,
        observing: None,
        claims: Vec::new(),
        assertion: None,
    };
    let (given, memory, shown) = (prepared.given, prepared.memory, prepared.shown);
    Ok(Sequence { program, given, memory, shown, steps, transitions })
}

/// The step of which a condition or action is one of its own, if there is just one.
fn own(steps: &[StepId]) -> Option<StepId> {
    match steps {
        [step] => Some(*step),
        _ => None,
    }
}

/// The chart's variables, with the values that they start from; the first of the table, in order of declaration.
fn declared(net: &Net) -> IndexVec<VarId, Variable> {
    net.variables.iter().map(Variable::declared).collect()
}

/// A step brings its label as a name, since `Fill.X` and `Fill.T` are its activity and its time; a number or the name of a
/// variable cannot be one, nor can what MATIEC uses in the code around it.
fn step(
    place: &grafc_net::net::Place,
    taken: &FxHashSet<String>,
    variables: &mut IndexVec<VarId, Variable>,
) -> SequenceStep {
    let (label, lower) = (&place.label, place.label.to_lowercase().to_string());
    let is_name = label.starts_with(|c: char| !c.is_ascii_digit()) && !["x", "t", "null"].contains(&lower.as_str());
    let mut active = Variable::of_step(place);
    if is_name && !taken.contains(&lower) {
        active.name = label.as_str().into();
    }
    let duration = Variable {
        role: Role::Temporary,
        name: eco_format!("T{}", place.label),
        ty: Type::Time,
        start: Bits::of(Value::Time(0), Type::Time),
        ..active.clone()
    };
    SequenceStep {
        active: variables.push(active),
        duration: variables.push(duration),
        marker: None,
        initial: place.initial,
        auxiliary: place.auxiliary,
        comment: place.comment.clone(),
        holds: Vec::new(),
        latches: Vec::new(),
        stored: Vec::new(),
    }
}

/// Why a chart is no sequential function chart.
#[derive(Default)]
struct Reasons {
    list: Vec<(Span, String)>,
}

impl Reasons {
    fn add(&mut self, place: Span, what: impl Into<String>) {
        self.list.push((place, what.into()));
    }

    /// Refuses the chart if there are any.
    fn refuse(self) -> Result<(), Diagnostics> {
        if self.list.is_empty() { Ok(()) } else { Err(self.diagnostics()) }
    }

    /// One error with a place for each reason.
    fn diagnostics(mut self) -> Diagnostics {
        self.list.sort();
        self.list.dedup();
        let mut diagnostics = Diagnostics::new();
        let mut reasons = self.list.into_iter();
        let Some((place, what)) = reasons.next() else { return diagnostics };
        let message = "this chart cannot be a sequential function chart that means the same";
        let mut diagnostic = Diagnostic::new(Code::E0503, place, message).here(what);
        for (place, what) in reasons {
            diagnostic = diagnostic.also(place, what);
        }
        diagnostics.push(
            diagnostic
                .note("a sequential function chart evolves once a scan and clears one transition after a step")
                .help("take Structured Text, which every chart has: `--target st`, or `--body st` in a project"),
        );
        diagnostics
    }
}

/// How large a formula is when it is written out: the nodes of its tree, and its depth.
fn is_small(pool: &Pool, id: FormulaId) -> bool {
    /// Readers take far fewer parentheses than compilers.
    const DEEPEST: u8 = 60;
    /// A condition stands on one line beside its transition.
    const LARGEST: u32 = 2_000;
    let mut sizes = std::collections::BTreeMap::new();
    for below in pool.below(id) {
        let size = pool
            .operands(below)
            .fold(1_u32, |sum, operand| sum.saturating_add(sizes.get(&operand).copied().unwrap_or_default()));
        sizes.insert(below, size);
    }
    pool.depth(id) <= DEEPEST && sizes.get(&id).is_some_and(|size| *size <= LARGEST)
}
