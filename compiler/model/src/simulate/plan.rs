//! X6: what is evaluated in a context, and in which order.
//!
//! Operands come before what they are operands of. In the pool that is so already; reading a continuously assigned
//! name adds an edge, from the name to the conditions of its continuous actions, wherever these stand. Delays lie in
//! edges and never the other way round, and conditions of continuous actions hold no edge, so one order serves: inner
//! delays, outer delays, operands of edges, everything else.
//!
//! Literals are evaluated once for all. What hangs on inputs alone is so at the first context of a reaction, for inputs
//! do not change within one (R9).

use crate::chart::{Chart, Event, ExprId, ExprKind, Mode, VariableId, VariableKind};
use index_vec::IndexVec;
use rustc_hash::FxHashSet;

/// Something that has a value in a context.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub(super) enum Valued {
    /// An expression.
    Expr(ExprId),
    /// `wire(B)`: a continuously assigned name.
    Wire(VariableId),
}

/// What edges and delays do in an evaluation.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Memory {
    /// A context: delays are updated, edges compared with the context before.
    Update,
    /// Delays keep the value of the latest context, and there is no edge.
    Hold,
    /// Before the first context: fresh delays, whose memory is then thrown away, and no edge.
    Fresh,
}

/// A set of nodes.
#[derive(Clone, Debug)]
struct Marks {
    exprs: IndexVec<ExprId, bool>,
    wires: IndexVec<VariableId, bool>,
}

/// What is evaluated when, each list operands first.
#[derive(Clone, Debug)]
pub(super) struct Plan {
    /// By name, the places of its continuous actions in [`Chart::continuous`].
    pub actions: IndexVec<VariableId, Vec<usize>>,
    /// In every context: transition-conditions, event expressions, the wires that right sides read, and all edges and
    /// delays of the chart.
    pub context: Vec<Valued>,
    /// Those of them that may change from one context of a reaction to the next.
    pub moving: Vec<Valued>,
    /// What actions that are done each scan read of continuously assigned names, once other actions have been done (R15).
    pub read_each_scan: Vec<Valued>,
    /// Event expressions with their edges replaced by 0 (R7).
    pub levels: Vec<Valued>,
    /// Continuously assigned outputs (R11).
    pub outputs: Vec<Valued>,
    /// Each edge and its operand.
    pub edges: Vec<(ExprId, ExprId)>,
    /// Each delay.
    pub delays: Vec<ExprId>,
    /// The sides of each comparison that hangs on the duration of a step.
    pub clocks: Vec<(ExprId, ExprId)>,
    /// What these sides need.
    pub clock_nodes: Vec<Valued>,
    /// Whether an expression reads the activity of a macro-step, and of a grafcet.
    pub reads: (bool, bool),
    /// All nodes of the chart but literals.
    all: Vec<Valued>,
    /// The set of `context`.
    in_context: Marks,
}

impl Plan {
    pub fn new(chart: &Chart) -> Self {
        let mut actions: IndexVec<VariableId, Vec<usize>> = chart.variables.iter().map(|_| Vec::new()).collect();
        for (place, action) in chart.continuous.iter().enumerate() {
            actions[action.target].push(place);
        }
        let conditions = chart.transitions.iter().map(|t| Valued::Expr(t.condition));
        let events: Vec<Valued> =
            chart.stored.iter().filter_map(|s| event_expression(s.event)).map(Valued::Expr).collect();
        let pulses = chart.pulses.iter().filter_map(|pulse| event_expression(pulse.event)).map(Valued::Expr);
        let events: Vec<Valued> = events.into_iter().chain(pulses).collect();
        let each_scan = chart.stored.iter().filter_map(|s| condition_each_scan(s.event)).map(Valued::Expr);
        let outputs: Vec<Valued> = chart
            .variables
            .iter_enumerated()
            .filter(|(_, v)| v.kind == VariableKind::Output && v.mode == Mode::Wire)
            .map(|(id, _)| Valued::Wire(id))
            .collect();

        let mut context: Vec<Valued> = conditions.chain(events.iter().copied()).chain(each_scan).collect();
        let mut roots = context.clone();
        roots.extend(chart.continuous.iter().filter_map(|action| action.condition).map(Valued::Expr));
        roots.extend(chart.stored.iter().map(|stored| Valued::Expr(stored.value)));
        roots.extend(outputs.iter().copied());
        let all = everything(chart, &actions, &roots);

        // Reading has no side effects (X6): whether a wire is evaluated, and a division in it raises DIV0, does not hang
        // on whether the action that reads it is done.
        let right_sides = chart.stored.iter().map(|stored| Valued::Expr(stored.value)).collect();
        let read = reach(chart, &actions, right_sides, Memory::Hold);
        context.extend(all.iter().filter(|&&node| matches!(node, Valued::Wire(_)) && read.has(node)));

        let mut edges = Vec::new();
        for &node in &all {
            let Valued::Expr(id) = node else { continue };
            match chart.exprs[id].kind {
                ExprKind::Rise(operand) | ExprKind::Fall(operand) => {
                    edges.push((id, operand));
                    context.push(node);
                }
                ExprKind::Delay { .. } => context.push(node),
                ExprKind::Literal(_)
                | ExprKind::Variable(_)
                | ExprKind::StepActive(_)
                | ExprKind::StepTime(_)
                | ExprKind::MacroActive(_)
                | ExprKind::GrafcetActive(_)
                | ExprKind::GrafcetFrozen(_)
                | ExprKind::Not(_)
                | ExprKind::And(..)
                | ExprKind::Or(..)
                | ExprKind::Xor(..)
                | ExprKind::Compare(..)
                | ExprKind::Arithmetic(..)
                | ExprKind::Negate(_)
                | ExprKind::Widen(_) => {}
            }
        }

        let exprs = all.iter().filter_map(|node| match *node {
            Valued::Expr(id) => Some(id),
            Valued::Wire(_) => None,
        });
        let (mut delays, mut clocks) = (Vec::new(), Vec::new());
        // Whether an expression hangs on the duration of a step.
        let mut timed: IndexVec<ExprId, bool> = chart.exprs.iter().map(|_| false).collect();
        for id in exprs {
            let kind = &chart.exprs[id].kind;
            let below = kind.operands().any(|operand| timed[operand]);
            if let ExprKind::Delay { .. } = kind {
                delays.push(id);
            } else if let (ExprKind::Compare(_, a, b), true) = (kind, below) {
                clocks.push((*a, *b));
            } else {
                timed[id] = below || matches!(kind, ExprKind::StepTime(_));
            }
        }
        let reads = |wanted: fn(&ExprKind) -> bool| {
            all.iter().any(|node| matches!(*node, Valued::Expr(id) if wanted(&chart.exprs[id].kind)))
        };
        let reads = (
            reads(|k| matches!(k, ExprKind::MacroActive(_))),
            reads(|k| matches!(k, ExprKind::GrafcetActive(_) | ExprKind::GrafcetFrozen(_))),
        );
        let sides = clocks.iter().flat_map(|&(a, b)| [Valued::Expr(a), Valued::Expr(b)]).collect();
        let clock_nodes = reach(chart, &actions, sides, Memory::Hold);

        let values = chart.stored.iter().filter(|stored| matches!(stored.event, Event::EachScan(..)));
        let read = reach(chart, &actions, values.map(|stored| Valued::Expr(stored.value)).collect(), Memory::Hold);
        let wires = all.iter().copied().filter(|&node| matches!(node, Valued::Wire(_)) && read.has(node)).collect();
        let read_each_scan = reach(chart, &actions, wires, Memory::Hold).select(&all);

        let in_context = reach(chart, &actions, context, Memory::Update);
        let levels = reach(chart, &actions, events, Memory::Hold);
        let outputs = reach(chart, &actions, outputs, Memory::Hold);
        let context = in_context.select(&all);
        let moving = moving(chart, &context);
        Plan {
            context,
            moving,
            read_each_scan,
            reads,
            levels: levels.select(&all),
            outputs: outputs.select(&all),
            clock_nodes: clock_nodes.select(&all),
            delays,
            clocks,
            actions,
            edges,
            all,
            in_context,
        }
    }

    /// What the right sides need beyond what the context has evaluated. What they need of that needs nothing beyond it.
    pub fn beyond_context(&self, chart: &Chart, values: impl Iterator<Item = ExprId>) -> Vec<Valued> {
        let roots: Vec<Valued> = values.map(Valued::Expr).collect();
        let mut entered = FxHashSet::default();
        let enter = |node| !self.in_context.has(node) && entered.insert(node);
        operands_first(chart, &self.actions, &roots, Memory::Hold, enter)
    }

    /// What the right sides of actions that are done each scan need anew, once other actions have been done (R15): all but
    /// edges and delays, which stay as the context has them.
    pub fn after_actions(&self, chart: &Chart, values: impl Iterator<Item = ExprId>) -> Vec<Valued> {
        let mut needed =
            reach(chart, &self.actions, values.map(Valued::Expr).collect(), Memory::Hold).select(&self.all);
        needed.retain(|node| match *node {
            Valued::Wire(_) => true,
            Valued::Expr(id) => !matches!(chart.exprs[id].kind, ExprKind::Rise(_) | ExprKind::Fall(_)),
        });
        needed
    }

    /// What continuously assigned names need, and these.
    pub fn of_wires(&self, chart: &Chart, wires: Vec<Valued>) -> Vec<Valued> {
        if wires.is_empty() {
            return wires;
        }
        // A name that nothing reads and that is no output is in no other list.
        let all = everything(chart, &self.actions, &wires);
        reach(chart, &self.actions, wires, Memory::Hold).select(&all)
    }

    /// What the right sides need before the first context.
    pub fn before_first_context(&self, chart: &Chart, values: impl Iterator<Item = ExprId>) -> Vec<Valued> {
        reach(chart, &self.actions, values.map(Valued::Expr).collect(), Memory::Fresh).select(&self.all)
    }
}

/// The expression of an action on event.
fn event_expression(event: Event) -> Option<ExprId> {
    match event {
        Event::Event(_, expression) => Some(expression),
        Event::Deactivation(_) | Event::Clearing(_) | Event::Activation(_) | Event::EachScan(..) => None,
    }
}

/// The condition of an action that is done each scan.
fn condition_each_scan(event: Event) -> Option<ExprId> {
    match event {
        Event::EachScan(_, condition) => condition,
        Event::Event(..) | Event::Deactivation(_) | Event::Clearing(_) | Event::Activation(_) => None,
    }
}

impl Marks {
    fn none(chart: &Chart) -> Self {
        Marks {
            exprs: chart.exprs.iter().map(|_| false).collect(),
            wires: chart.variables.iter().map(|_| false).collect(),
        }
    }

    fn has(&self, node: Valued) -> bool {
        match node {
            Valued::Expr(id) => self.exprs[id],
            Valued::Wire(id) => self.wires[id],
        }
    }

    /// Adds a node; says whether it is new.
    fn add(&mut self, node: Valued) -> bool {
        let mark = match node {
            Valued::Expr(id) => &mut self.exprs[id],
            Valued::Wire(id) => &mut self.wires[id],
        };
        !std::mem::replace(mark, true)
    }

    fn select(&self, nodes: &[Valued]) -> Vec<Valued> {
        nodes.iter().copied().filter(|&node| self.has(node)).collect()
    }
}

/// Everything that the roots need in an evaluation of this kind.
fn reach(chart: &Chart, actions: &IndexVec<VariableId, Vec<usize>>, roots: Vec<Valued>, memory: Memory) -> Marks {
    let mut marks = Marks::none(chart);
    let mut todo = roots;
    while let Some(node) = todo.pop() {
        if marks.add(node) {
            operands(chart, actions, node, memory, &mut todo);
        }
    }
    marks
}

/// The nodes of a list, operands first, that do not hang on inputs alone.
fn moving(chart: &Chart, nodes: &[Valued]) -> Vec<Valued> {
    let mut is_moving = Marks::none(chart);
    for &node in nodes {
        let moves = match node {
            Valued::Wire(_) => true,
            Valued::Expr(id) => match chart.exprs[id].kind {
                ExprKind::Literal(_) => false,
                ExprKind::Variable(variable) => match chart.variables[variable].mode {
                    Mode::Given => false,
                    Mode::Wire | Mode::Stored => true,
                },
                ExprKind::StepActive(_)
                | ExprKind::StepTime(_)
                | ExprKind::MacroActive(_)
                | ExprKind::GrafcetActive(_)
                | ExprKind::GrafcetFrozen(_)
                | ExprKind::Rise(_)
                | ExprKind::Fall(_)
                | ExprKind::Delay { .. } => true,
                ExprKind::Not(_)
                | ExprKind::And(..)
                | ExprKind::Or(..)
                | ExprKind::Xor(..)
                | ExprKind::Compare(..)
                | ExprKind::Arithmetic(..)
                | ExprKind::Negate(_)
                | ExprKind::Widen(_) => chart.exprs[id].kind.operands().any(|id| is_moving.has(Valued::Expr(id))),
            },
        };
        if moves {
            is_moving.add(node);
        }
    }
    is_moving.select(nodes)
}

/// Everything that the roots reach but literals, operands first.
fn everything(chart: &Chart, actions: &IndexVec<VariableId, Vec<usize>>, roots: &[Valued]) -> Vec<Valued> {
    let mut entered = Marks::none(chart);
    let mut nodes = operands_first(chart, actions, roots, Memory::Update, |node| entered.add(node));
    nodes.retain(|node| !matches!(*node, Valued::Expr(id) if matches!(chart.exprs[id].kind, ExprKind::Literal(_))));
    nodes
}

/// What the roots reach in an evaluation of this kind, operands first; `enter` says once of each node whether it is to be
/// entered. A cycle of continuous actions, which a checked chart has not, is cut where it is met.
fn operands_first(
    chart: &Chart,
    actions: &IndexVec<VariableId, Vec<usize>>,
    roots: &[Valued],
    memory: Memory,
    mut enter: impl FnMut(Valued) -> bool,
) -> Vec<Valued> {
    enum Visit {
        Enter(Valued),
        Leave(Valued),
    }
    let mut order = Vec::new();
    let mut todo: Vec<Visit> = roots.iter().rev().map(|&node| Visit::Enter(node)).collect();
    let mut found = Vec::new();
    while let Some(visit) = todo.pop() {
        match visit {
            Visit::Enter(node) => {
                if enter(node) {
                    todo.push(Visit::Leave(node));
                    operands(chart, actions, node, memory, &mut found);
                    todo.extend(found.drain(..).rev().map(Visit::Enter));
                }
            }
            Visit::Leave(node) => order.push(node),
        }
    }
    order
}

/// Appends what a node needs in an evaluation of this kind.
fn operands(
    chart: &Chart,
    actions: &IndexVec<VariableId, Vec<usize>>,
    node: Valued,
    memory: Memory,
    found: &mut Vec<Valued>,
) {
    let id = match node {
        Valued::Expr(id) => id,
        Valued::Wire(variable) => {
            let conditions = actions[variable].iter().filter_map(|&place| chart.continuous[place].condition);
            found.extend(conditions.map(Valued::Expr));
            return;
        }
    };
    match chart.exprs[id].kind {
        ExprKind::Literal(_)
        | ExprKind::StepActive(_)
        | ExprKind::StepTime(_)
        | ExprKind::MacroActive(_)
        | ExprKind::GrafcetActive(_)
        | ExprKind::GrafcetFrozen(_) => {}
        ExprKind::Variable(variable) => match chart.variables[variable].mode {
            Mode::Wire => found.push(Valued::Wire(variable)),
            Mode::Given | Mode::Stored => {}
        },
        ExprKind::Rise(operand) | ExprKind::Fall(operand) => match memory {
            Memory::Update => found.push(Valued::Expr(operand)),
            Memory::Hold | Memory::Fresh => {}
        },
        ExprKind::Delay { operand, .. } => match memory {
            Memory::Update | Memory::Fresh => found.push(Valued::Expr(operand)),
            Memory::Hold => {}
        },
        ExprKind::Not(_)
        | ExprKind::And(..)
        | ExprKind::Or(..)
        | ExprKind::Xor(..)
        | ExprKind::Compare(..)
        | ExprKind::Arithmetic(..)
        | ExprKind::Negate(_)
        | ExprKind::Widen(_) => found.extend(chart.exprs[id].kind.operands().map(Valued::Expr)),
    }
}
