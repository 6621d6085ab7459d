//! X1-X6: the values of a net's expressions in a context.

use grafc_model::chart::{
    Arithmetic, Comparison, Event, ExprId, ExprKind, GrafcetId, MacroId, Mode, StepId, Type, Value, VariableId,
};
use grafc_net::net::Net;
use index_vec::IndexVec;

/// What is read besides situation, variables and instant.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Reading {
    /// A context: delays are brought up to date, edges are those since the context before.
    Context,
    /// The same, all edges being 0.
    Levels,
    /// After a context: delays as they were in it, all edges 0.
    After,
}

/// What contexts remember of those before.
#[derive(Clone)]
pub(super) struct Memory {
    /// When each place was last activated.
    since: IndexVec<StepId, i64>,
    delays: IndexVec<ExprId, Delay>,
    /// Operands of edges; other entries are not read.
    operands: IndexVec<ExprId, bool>,
    /// The places that are active again when their grafcets are resumed (R15).
    pub saved: IndexVec<StepId, bool>,
    /// The grafcets that pulse orders have frozen.
    pub frozen: IndexVec<GrafcetId, bool>,
}

impl Memory {
    pub fn new(net: &Net) -> Self {
        Memory {
            since: net.places.iter().map(|_| 0).collect(),
            delays: net.exprs.iter().map(|_| Delay::default()).collect(),
            operands: net.exprs.iter().map(|_| false).collect(),
            saved: net.places.iter().map(|_| false).collect(),
            frozen: net.grafcets.iter().map(|_| false).collect(),
        }
    }

    /// A place is activated at the instant.
    pub fn activated(&mut self, s: StepId, t: i64) {
        self.since[s] = t;
    }

    /// The context is what the next one looks back to, as far as delays go.
    pub fn keep_delays(&mut self, cx: &Context) {
        self.delays.clone_from(&cx.delays);
    }

    /// The context is what the next one looks back to, as far as edges go; says whether an operand has changed.
    pub fn keep_edges(&mut self, cx: &Context) -> bool {
        let mut changed = false;
        for (edge, operand) in &cx.edges {
            changed |= std::mem::replace(&mut self.operands[*edge], *operand) != *operand;
        }
        changed
    }
}

/// One delay (X5): a TOF after a TON.
#[derive(Clone, Copy, Default)]
struct Delay {
    /// Since when the operand has been true.
    start: Option<i64>,
    /// Whether the delayed operand is true.
    high: bool,
    /// When it fell.
    fell: Option<i64>,
    value: bool,
}

impl Delay {
    fn next(self, operand: bool, on: i64, off: i64, t: i64) -> Delay {
        let start = operand.then(|| self.start.unwrap_or(t));
        let high = start.is_some_and(|start| t.wrapping_sub(start) >= on);
        let fell = match (high, self.high) {
            (true, _) => None,
            (false, true) => Some(t),
            (false, false) => self.fell,
        };
        Delay { start, high, fell, value: high || fell.is_some_and(|fell| t.wrapping_sub(fell) < off) }
    }
}

/// The values in one context.
pub(super) struct Context {
    exprs: IndexVec<ExprId, Value>,
    wires: IndexVec<VariableId, bool>,
    /// The delays after this context.
    delays: IndexVec<ExprId, Delay>,
    /// The value of the operand of each edge.
    edges: Vec<(ExprId, bool)>,
}

impl Context {
    /// The value of an expression.
    pub fn value(&self, e: ExprId) -> Value {
        self.exprs[e]
    }

    /// Whether a condition holds.
    pub fn holds(&self, e: ExprId) -> bool {
        integer(self.exprs[e]) != 0
    }

    /// The value of a continuously assigned variable.
    pub fn wire(&self, v: VariableId) -> bool {
        self.wires[v]
    }
}

/// The expressions of a net, in an order in which each can be evaluated from those before.
pub(super) struct Expressions<'a> {
    net: &'a Net,
    order: Vec<Evaluated>,
    /// The places that the activity of each macro-step means.
    expansions: IndexVec<MacroId, Vec<StepId>>,
}

#[derive(Clone, Copy)]
enum Evaluated {
    Expr(ExprId),
    Wire(VariableId),
}

impl<'a> Expressions<'a> {
    pub fn new(net: &'a Net) -> Self {
        Expressions { net, order: order(net), expansions: expansions(net) }
    }

    /// Evaluates everything and remembers nothing.
    pub fn read(
        &self,
        active: &IndexVec<StepId, bool>,
        variables: &IndexVec<VariableId, Value>,
        memory: &Memory,
        reading: Reading,
        t: i64,
    ) -> Context {
        self.evaluate(active, (variables, memory), reading, t, None)
    }

    /// The same context with other variables: edges and delays are as they were in it.
    pub fn read_again(
        &self,
        active: &IndexVec<StepId, bool>,
        variables: &IndexVec<VariableId, Value>,
        memory: &Memory,
        t: i64,
        before: &Context,
    ) -> Context {
        self.evaluate(active, (variables, memory), Reading::Context, t, Some(before))
    }

    fn evaluate(
        &self,
        active: &IndexVec<StepId, bool>,
        (variables, memory): (&IndexVec<VariableId, Value>, &Memory),
        reading: Reading,
        t: i64,
        before: Option<&Context>,
    ) -> Context {
        let net = self.net;
        let mut cx = Context {
            exprs: net.exprs.iter().map(|_| Value::Bool(false)).collect(),
            wires: net.variables.iter().map(|_| false).collect(),
            delays: memory.delays.clone(),
            edges: Vec::new(),
        };
        for node in &self.order {
            let e = match *node {
                Evaluated::Expr(e) => e,
                Evaluated::Wire(v) => {
                    let mut actions = net.continuous.iter().filter(|action| action.target == v);
                    cx.wires[v] = actions.any(|a| active[a.step] && a.condition.is_none_or(|c| cx.holds(c)));
                    continue;
                }
            };
            if let (Some(before), ExprKind::Rise(_) | ExprKind::Fall(_) | ExprKind::Delay { .. }) =
                (before, &net.exprs[e].kind)
            {
                cx.exprs[e] = before.exprs[e];
                continue;
            }
            let any = |steps: &[StepId]| steps.iter().any(|s| active[*s]);
            let ty = net.exprs[e].ty;
            cx.exprs[e] = match net.exprs[e].kind {
                ExprKind::Literal(value) => value,
                ExprKind::Variable(v) => match net.variables[v].mode {
                    Mode::Wire => Value::Bool(cx.wires[v]),
                    Mode::Given | Mode::Stored => variables[v],
                },
                ExprKind::StepActive(s) => Value::Bool(active[s]),
                ExprKind::StepTime(s) => Value::Time(if active[s] { t.wrapping_sub(memory.since[s]) } else { 0 }),
                ExprKind::MacroActive(m) => Value::Bool(any(&self.expansions[m])),
                ExprKind::GrafcetActive(g) => Value::Bool(any(&net.grafcets[g].steps)),
                ExprKind::GrafcetFrozen(g) => Value::Bool(memory.frozen[g]),
                ExprKind::Not(a) => Value::Bool(!cx.holds(a)),
                ExprKind::And(a, b) => Value::Bool(cx.holds(a) && cx.holds(b)),
                ExprKind::Or(a, b) => Value::Bool(cx.holds(a) || cx.holds(b)),
                ExprKind::Xor(a, b) => Value::Bool(cx.holds(a) != cx.holds(b)),
                ExprKind::Rise(a) => {
                    cx.edges.push((e, cx.holds(a)));
                    Value::Bool(reading == Reading::Context && cx.holds(a) && !memory.operands[e])
                }
                ExprKind::Fall(a) => {
                    cx.edges.push((e, cx.holds(a)));
                    Value::Bool(reading == Reading::Context && !cx.holds(a) && memory.operands[e])
                }
                ExprKind::Delay { on, operand, off } => {
                    if reading != Reading::After {
                        cx.delays[e] = memory.delays[e].next(cx.holds(operand), on.ms, off.ms, t);
                    }
                    Value::Bool(cx.delays[e].value)
                }
                ExprKind::Compare(op, a, b) => Value::Bool(compare(op, cx.exprs[a], cx.exprs[b])),
                ExprKind::Arithmetic(op, a, b) => calculate(op, ty, cx.exprs[a], cx.exprs[b]),
                // Times -1 rather than from 0: zero has a sign.
                ExprKind::Negate(a) => calculate(Arithmetic::Multiply, ty, cx.exprs[a], Value::Int(-1)),
                ExprKind::Widen(a) => convert(ty, cx.exprs[a]),
            };
        }
        cx
    }
}

/// Sweeps over what is asked for until all of it has its place.
fn order(net: &Net) -> Vec<Evaluated> {
    let mut asked: IndexVec<ExprId, bool> = net.exprs.iter().map(|_| false).collect();
    let conditions = net.transitions.iter().map(|t| t.condition);
    let values = net.stored.iter().map(|action| action.value);
    for e in conditions.chain(values).chain(net.continuous.iter().filter_map(|action| action.condition)) {
        asked[e] = true;
    }
    for action in &net.stored {
        if let Event::Event(_, e) | Event::EachScan(_, Some(e)) = action.event {
            asked[e] = true;
        }
    }
    for pulse in &net.pulses {
        if let Event::Event(_, e) = pulse.event {
            asked[e] = true;
        }
    }
    // Operands come before what they are operands of.
    for e in net.exprs.indices().rev() {
        if asked[e] {
            net.exprs[e].kind.operands().for_each(|operand| asked[operand] = true);
        }
    }
    let mut order = Vec::new();
    let mut placed: IndexVec<ExprId, bool> = net.exprs.iter().map(|_| false).collect();
    let mut known: IndexVec<VariableId, bool> = net.variables.iter().map(|v| v.mode != Mode::Wire).collect();
    loop {
        let before = order.len();
        for v in net.variables.indices() {
            let mut conditions = net.continuous.iter().filter(|a| a.target == v).filter_map(|a| a.condition);
            if !known[v] && conditions.all(|c| placed[c]) {
                known[v] = true;
                order.push(Evaluated::Wire(v));
            }
        }
        for (e, expr) in net.exprs.iter_enumerated() {
            let reads = if let ExprKind::Variable(v) = expr.kind { known[v] } else { true };
            if asked[e] && !placed[e] && reads && expr.kind.operands().all(|operand| placed[operand]) {
                placed[e] = true;
                order.push(Evaluated::Expr(e));
            }
        }
        if order.len() == before {
            return order;
        }
    }
}

fn expansions(net: &Net) -> IndexVec<MacroId, Vec<StepId>> {
    let all_of = |m: MacroId| {
        let (mut steps, mut todo) = (Vec::new(), vec![m]);
        while let Some(m) = todo.pop() {
            steps.extend(&net.macro_steps[m].places);
            todo.extend(&net.macro_steps[m].inner);
        }
        steps
    };
    net.macro_steps.indices().map(all_of).collect()
}

fn integer(value: Value) -> i64 {
    match value {
        Value::Bool(b) => i64::from(b),
        Value::Int(i) | Value::Time(i) => i,
        Value::Real(r) => r as i64,
    }
}

fn real(value: Value) -> f64 {
    match value {
        Value::Real(r) => r,
        Value::Bool(_) | Value::Int(_) | Value::Time(_) => integer(value) as f64,
    }
}

/// The value as one of the type.
pub(super) fn convert(ty: Type, value: Value) -> Value {
    match ty {
        Type::Real | Type::Lreal => float(ty, real(value)),
        Type::Bool | Type::Int | Type::Dint | Type::Uint | Type::Udint | Type::Time => {
            whole(ty, i128::from(integer(value)))
        }
    }
}

/// Wraps a whole number around at the width of the type.
fn whole(ty: Type, n: i128) -> Value {
    match ty {
        Type::Bool => Value::Bool(n != 0),
        Type::Int => Value::Int(i64::from(n as i16)),
        Type::Dint => Value::Int(i64::from(n as i32)),
        Type::Uint => Value::Int(i64::from(n as u16)),
        Type::Udint => Value::Int(i64::from(n as u32)),
        Type::Time => Value::Time(n as i64),
        Type::Real | Type::Lreal => float(ty, n as f64),
    }
}

/// Rounds to the precision of the type.
fn float(ty: Type, x: f64) -> Value {
    Value::Real(if ty == Type::Real { f64::from(x as f32) } else { x })
}

/// Whole numbers exactly, then wrapped; of reals the one nearest to the exact result: doubles are precise enough to
/// round the result for singles from them. What is divided by zero is 0.
fn calculate(op: Arithmetic, ty: Type, a: Value, b: Value) -> Value {
    match ty {
        Type::Real | Type::Lreal => {
            let (a, b) = (real(a), real(b));
            float(
                ty,
                match op {
                    Arithmetic::Add => a + b,
                    Arithmetic::Subtract => a - b,
                    Arithmetic::Multiply => a * b,
                    Arithmetic::Divide | Arithmetic::Modulo if b == 0.0 => 0.0,
                    Arithmetic::Divide => a / b,
                    Arithmetic::Modulo => a % b,
                },
            )
        }
        Type::Bool | Type::Int | Type::Dint | Type::Uint | Type::Udint | Type::Time => {
            let (a, b) = (i128::from(integer(a)), i128::from(integer(b)));
            whole(
                ty,
                match op {
                    Arithmetic::Add => a + b,
                    Arithmetic::Subtract => a - b,
                    Arithmetic::Multiply => a * b,
                    Arithmetic::Divide | Arithmetic::Modulo if b == 0 => 0,
                    Arithmetic::Divide => a / b,
                    Arithmetic::Modulo => a % b,
                },
            )
        }
    }
}

fn compare(op: Comparison, a: Value, b: Value) -> bool {
    let order = match (a, b) {
        (Value::Real(_), _) | (_, Value::Real(_)) => real(a).partial_cmp(&real(b)),
        (_, _) => Some(integer(a).cmp(&integer(b))),
    };
    match op {
        Comparison::Equal => order.is_some_and(|o| o.is_eq()),
        Comparison::NotEqual => order.is_none_or(|o| o.is_ne()),
        Comparison::Less => order.is_some_and(|o| o.is_lt()),
        Comparison::LessEqual => order.is_some_and(|o| o.is_le()),
        Comparison::Greater => order.is_some_and(|o| o.is_gt()),
        Comparison::GreaterEqual => order.is_some_and(|o| o.is_ge()),
    }
}

/// Equality in which what is not a number is the same as itself.
pub fn same(a: Value, b: Value) -> bool {
    match (a, b) {
        (Value::Real(a), Value::Real(b)) => a == b || a.is_nan() && b.is_nan(),
        (_, _) => a == b,
    }
}
