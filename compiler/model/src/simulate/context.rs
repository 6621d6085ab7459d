//! X1-X6: the values of expressions in a context.

use super::arithmetic::{calculate, compare, convert, negate, truth};
use super::delay::{Delay, first_value};
use super::flat::{active_grafcets, active_macro_steps};
use super::plan::{Memory, Plan, Valued};
use super::{Activity, State};
use crate::chart::{Chart, Event, Expr, ExprId, ExprKind, GrafcetId, MacroId, Mode, StepId, Value, VariableId};
use index_vec::IndexVec;

/// Values of expressions and continuously assigned names.
#[derive(Clone, Debug)]
pub(super) struct Values {
    exprs: IndexVec<ExprId, Value>,
    wires: IndexVec<VariableId, bool>,
}

impl Values {
    /// Literals have their values; others are evaluated before they are read.
    pub fn new(chart: &Chart) -> Self {
        let literal = |kind: &ExprKind| if let ExprKind::Literal(value) = kind { *value } else { Value::Bool(false) };
        Values {
            exprs: chart.exprs.iter().map(|expr| literal(&expr.kind)).collect(),
            wires: chart.variables.iter().map(|_| false).collect(),
        }
    }

    /// The same for the expressions of claims.
    pub fn of_claims(chart: &Chart) -> Self {
        let literal = |kind: &ExprKind| if let ExprKind::Literal(value) = kind { *value } else { Value::Bool(false) };
        Values {
            exprs: chart.claims.exprs.iter().map(|expr| literal(&expr.kind)).collect(),
            wires: chart.variables.iter().map(|_| false).collect(),
        }
    }

    /// Continuously assigned names have the values that they have there.
    pub fn take_wires(&mut self, values: &Values) {
        self.wires.clone_from(&values.wires);
    }

    /// The value of an expression that has been evaluated.
    pub fn of(&self, id: ExprId) -> Value {
        self.exprs[id]
    }

    /// Whether a condition that has been evaluated holds.
    pub fn holds(&self, id: ExprId) -> bool {
        truth(self.exprs[id])
    }

    /// Whether a continuously assigned name that has been evaluated is true.
    pub fn wire(&self, id: VariableId) -> bool {
        self.wires[id]
    }
}

/// What expressions are evaluated against: situation, variables, inputs and time.
struct Context<'a> {
    chart: &'a Chart,
    exprs: &'a IndexVec<ExprId, Expr>,
    plan: &'a Plan,
    active: &'a Activity,
    macro_steps: IndexVec<MacroId, bool>,
    grafcets: IndexVec<GrafcetId, bool>,
    variables: &'a IndexVec<VariableId, Value>,
    since: &'a IndexVec<StepId, i64>,
    /// `fr`: the grafcets that pulse orders have frozen.
    frozen: &'a IndexVec<GrafcetId, bool>,
    t: i64,
}

/// Evaluates the nodes in the state at the instant; operands must come first or have a value already. Delays are
/// brought up to date in the state, edges are not: those change at the end of the micro-step (R8).
pub(super) fn evaluate(
    chart: &Chart,
    plan: &Plan,
    nodes: &[Valued],
    memory: Memory,
    state: &mut State,
    t: i64,
    values: &mut Values,
) -> DividedByZero {
    let (of_macro_steps, of_grafcets) = plan.reads;
    let context = Context {
        chart,
        exprs: &chart.exprs,
        plan,
        active: &state.active,
        macro_steps: if of_macro_steps { active_macro_steps(chart, &state.active) } else { IndexVec::new() },
        grafcets: if of_grafcets { active_grafcets(chart, &state.active) } else { IndexVec::new() },
        variables: &state.variables,
        since: &state.since,
        frozen: &state.frozen,
        t,
    };
    let mut div0 = false;
    for &node in nodes {
        match node {
            Valued::Expr(id) => {
                let value = context.expression(id, memory, &mut state.delays, &state.edges, values, &mut div0);
                values.exprs[id] = value;
            }
            Valued::Wire(id) => values.wires[id] = context.wire(id, values),
        }
    }
    DividedByZero(div0)
}

/// Evaluates the claims, with the edges that there are by what their operands were. None of them holds a delay.
pub(super) fn evaluate_claims(
    chart: &Chart,
    plan: &Plan,
    memory: Memory,
    state: &State,
    edges: &IndexVec<ExprId, bool>,
    t: i64,
    values: &mut Values,
) {
    let context = Context {
        chart,
        exprs: &chart.claims.exprs,
        plan,
        active: &state.active,
        macro_steps: active_macro_steps(chart, &state.active),
        grafcets: active_grafcets(chart, &state.active),
        variables: &state.variables,
        since: &state.since,
        frozen: &state.frozen,
        t,
    };
    for id in chart.claims.exprs.indices() {
        let value = context.expression(id, memory, &mut IndexVec::new(), edges, values, &mut false);
        values.exprs[id] = value;
    }
}

/// Whether an evaluation divided by zero; must go into the flags.
#[must_use]
pub(super) struct DividedByZero(pub bool);

impl Context<'_> {
    /// `wire(B)`: one of its continuous actions applies.
    fn wire(&self, id: VariableId, values: &Values) -> bool {
        self.plan.actions[id].iter().any(|&place| {
            let action = &self.chart.continuous[place];
            self.active[action.step] && action.condition.is_none_or(|condition| values.holds(condition))
        })
    }

    fn expression(
        &self,
        id: ExprId,
        memory: Memory,
        delays: &mut IndexVec<ExprId, Delay>,
        edges: &IndexVec<ExprId, bool>,
        values: &Values,
        div0: &mut bool,
    ) -> Value {
        let ty = self.exprs[id].ty;
        let is = |operand| values.holds(operand);
        match self.exprs[id].kind {
            ExprKind::Literal(value) => value,
            // X1: a continuously assigned name is what its actions say in this very context.
            ExprKind::Variable(variable) => match self.chart.variables[variable].mode {
                Mode::Wire => Value::Bool(values.wire(variable)),
                Mode::Given | Mode::Stored => self.variables[variable],
            },
            ExprKind::StepActive(step) => Value::Bool(self.active[step]),
            // X2
            ExprKind::StepTime(step) if self.active[step] => Value::Time(self.t.wrapping_sub(self.since[step])),
            ExprKind::StepTime(_) => Value::Time(0),
            ExprKind::MacroActive(id) => Value::Bool(self.macro_steps[id]),
            ExprKind::GrafcetActive(id) => Value::Bool(self.grafcets[id]),
            ExprKind::GrafcetFrozen(id) => Value::Bool(self.frozen[id]),
            ExprKind::Not(a) => Value::Bool(!is(a)),
            ExprKind::And(a, b) => Value::Bool(is(a) & is(b)),
            ExprKind::Or(a, b) => Value::Bool(is(a) | is(b)),
            ExprKind::Xor(a, b) => Value::Bool(is(a) ^ is(b)),
            // X4
            ExprKind::Rise(operand) => Value::Bool(match memory {
                Memory::Update => is(operand) && !edges[id],
                Memory::Hold | Memory::Fresh => false,
            }),
            ExprKind::Fall(operand) => Value::Bool(match memory {
                Memory::Update => !is(operand) && edges[id],
                Memory::Hold | Memory::Fresh => false,
            }),
            // X5
            ExprKind::Delay { on, operand, off } => Value::Bool(match memory {
                Memory::Update => delays[id].update(is(operand), on.ms, off.ms, self.t),
                Memory::Hold => delays[id].value,
                Memory::Fresh => first_value(is(operand), on.ms),
            }),
            ExprKind::Compare(op, a, b) => Value::Bool(compare(op, values.of(a), values.of(b))),
            ExprKind::Arithmetic(op, a, b) => calculate(op, ty, values.of(a), values.of(b), div0),
            ExprKind::Negate(a) => negate(ty, values.of(a)),
            ExprKind::Widen(a) => convert(ty, values.of(a)),
        }
    }
}

/// For each stored action on event, whether its expression holds with all edges replaced by 0 (R7); false for others.
pub(super) fn levels(chart: &Chart, values: &Values) -> Vec<bool> {
    let level = |event| match event {
        Event::Event(_, expression) => values.holds(expression),
        Event::Deactivation(_) | Event::Clearing(_) | Event::Activation(_) | Event::EachScan(..) => false,
    };
    chart.stored.iter().map(|stored| level(stored.event)).collect()
}
