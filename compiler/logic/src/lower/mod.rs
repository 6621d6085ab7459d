//! Conditions and values of the net to formulas, with the statements that must stand before they can be read.
//!
//! A [`Context`] is one moment of the scan at which inputs, situation and variables are fixed: the initial reaction, a
//! micro-step, or the outputs. In it every condition has one meaning (X1-X6), and whatever a formula cannot hold itself
//! becomes a definition that is emitted once, before its first use: the wire that a condition reads, the activity of a
//! macro-step, a delay, an intermediate result that has to wrap around at the width of its type.

mod arithmetic;
pub(crate) mod cover;
mod delays;
mod edges;
mod factored;
pub(crate) mod frozen;
mod lowered;
mod setters;
pub(crate) mod situation;
pub(crate) mod symbols;
pub(crate) mod words;

use crate::scan::{ActionId, OrderId, Origin, Role, Statement, Timer, TimerId, Told, VarId};
use cover::Cover;
pub(crate) use delays::LoweredDelay;
use ecow::{EcoString, eco_format};
use factored::factored;
use frozen::FrozenBits;
use grafc_formula::exclusion::EdgeOperand;
use grafc_formula::{Formula, FormulaId, Pool, Type, Value};
use grafc_model::chart::{Continuous, DelayTime, ExprId, ExprKind, GrafcetId, MacroId, Mode, Note, StepId, VariableId};
use grafc_net::Net;
use grafc_net::net::Grafcet;
use index_vec::IndexVec;
use lowered::LoweredExprs;
use rustc_hash::{FxHashMap, FxHashSet};
use setters::Setters;
use situation::Situation;
use std::collections::BTreeMap;
use std::sync::Arc;
use symbols::Symbols;

/// The moments at which conditions are evaluated.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Moment {
    /// The initial reaction before its first micro-step: no edges, delays as they start (R10).
    First,
    /// A micro-step on the old situation (R1).
    MicroStep,
    /// After the evolution: the new situation, with the delays of the last micro-step (R11, R14).
    After,
    /// When memory has been given back: the same, with the delays as they were saved.
    Restored,
}

/// What has been lowered at one moment.
#[derive(Clone)]
pub(crate) struct Context {
    moment: Moment,
    /// What the definitions come from that are emitted now.
    pub(crate) origin: Origin,
    /// The definitions, in the order in which they must be done.
    pub(crate) statements: Vec<Statement>,
    exprs: LoweredExprs,
    wires: FxHashSet<VariableId>,
    macros: FxHashMap<MacroId, FormulaId>,
    grafcets: FxHashMap<GrafcetId, FormulaId>,
    /// Variables that hold an intermediate result, and the order in which they came.
    latched: FxHashMap<FormulaId, VarId>,
    latched_in_order: Vec<FormulaId>,
    /// Variables that hold a quotient (or, marked, a remainder), and the order in which they came.
    divided: FxHashMap<Division, VarId>,
    divided_in_order: Vec<Division>,
}

/// Whether the remainder is wanted, the dividend and the divisor.
type Division = (bool, FormulaId, FormulaId);

impl Context {
    fn latch_in(&mut self, value: FormulaId, variable: VarId) {
        self.latched.insert(value, variable);
        self.latched_in_order.push(value);
    }

    /// The variable of a wire holds its value.
    pub(crate) fn has_wire(&mut self, wire: VariableId) {
        self.wires.insert(wire);
    }

    /// An expression that is lowered in a way of its own.
    pub(crate) fn know(&mut self, e: ExprId, formula: FormulaId) {
        self.exprs.insert(e, formula);
    }

    /// The same context once stored actions have been done: edges, delays, durations and activities are as they were;
    /// variables, and what is continuously assigned by them, are read anew.
    pub(crate) fn after_actions(&self, net: &Net) -> Context {
        let stays = |e: &ExprId| match net.exprs[*e].kind {
            ExprKind::Rise(_) | ExprKind::Fall(_) | ExprKind::Delay { .. } | ExprKind::StepTime(_) => true,
            ExprKind::Literal(_)
            | ExprKind::Variable(_)
            | ExprKind::StepActive(_)
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
            | ExprKind::Widen(_) => false,
        };
        let mut after = Context::new(self.moment);
        self.exprs.iter().filter(|(e, _)| stays(e)).for_each(|(e, formula)| after.exprs.insert(e, formula));
        after.macros.clone_from(&self.macros);
        after.grafcets.clone_from(&self.grafcets);
        after
    }

    pub(crate) fn new(moment: Moment) -> Self {
        Context {
            moment,
            origin: Origin::Chart,
            statements: Vec::new(),
            exprs: LoweredExprs::default(),
            wires: FxHashSet::default(),
            macros: FxHashMap::default(),
            grafcets: FxHashMap::default(),
            latched: FxHashMap::default(),
            latched_in_order: Vec::new(),
            divided: FxHashMap::default(),
            divided_in_order: Vec::new(),
        }
    }
}

/// Everything that lowering shares between moments.
#[derive(Clone)]
pub(crate) struct Lowering {
    pub(crate) net: Arc<Net>,
    pub(crate) symbols: Symbols,
    pub(crate) situation: Situation,
    /// What pulse orders remember.
    pub(crate) frozen_bits: FrozenBits,
    pub(crate) pool: Pool,
    pub(crate) timers: IndexVec<TimerId, Timer>,
    /// Timers of step durations.
    pub(crate) step_timers: BTreeMap<StepId, TimerId>,
    /// Edge operands, in the order in which they were met.
    pub(crate) edges: Vec<EdgeOperand>,
    /// Each operand in the chart: the first of those that have the same formula.
    pub(crate) edge_operands: Vec<ExprId>,
    /// Where each operand comes from.
    pub(crate) edge_origins: Vec<Origin>,
    edge_of: FxHashMap<FormulaId, usize>,
    delay_of: FxHashMap<(FormulaId, DelayTime, DelayTime), FormulaId>,
    /// The value of each delay after the last micro-step.
    delay_values: FxHashMap<ExprId, FormulaId>,
    /// The delays that have been lowered.
    pub(crate) delays: Vec<LoweredDelay>,
    /// The continuous actions of each wire.
    setters: Setters,
    /// The number of the first order on each grafcet.
    first_order: IndexVec<GrafcetId, u32>,
    /// How often each designation is used.
    designations: FxHashMap<Note, u32>,
    /// The words that delays are called by.
    delay_words: FxHashSet<EcoString>,
    /// What waits to be built, each with whether all that it needs has been; and what one of them needs. Empty in between.
    open_needs: Vec<(Need, bool)>,
    needs: Vec<Need>,
    /// The pieces of conditions that were too deep, in the order of their definition.
    pub(crate) parts: Vec<(VarId, FormulaId)>,
    /// Wires whose variables follow the situation by themselves, so that nothing need be computed to read them.
    pub(crate) kept_wires: FxHashSet<VariableId>,
    /// Variables that have been written already, and the copies to read instead (see `allocate`).
    pub(crate) redirected: FxHashMap<VariableId, VarId>,
}

/// Compilers of PLCs take at most 150 nested parentheses; a reader takes fewer.
const DEEPEST: u8 = 40;

/// What a formula may depend on.
#[derive(Clone, Copy)]
enum Need {
    Expr(ExprId),
    Wire(VariableId),
    Macro(MacroId),
    Grafcet(GrafcetId),
}

impl Lowering {
    /// With a cover, steps that exclude each other share a state; if a `short` text is wanted, as a small chart does it.
    pub(crate) fn new(net: Arc<Net>, cover: Option<&Cover>, short: bool) -> Self {
        // Around a step and a transition there are some formulas more than variables, each of few operands.
        let around = net.places.len() + net.transitions.len();
        let mut pool = Pool::with_capacity(net.variables.len() + 3 * around, 4 * around);
        let mut symbols = Symbols::new(&net);
        let situation = Situation::new(&net, cover, short, &mut symbols, &mut pool);
        let frozen_bits = FrozenBits::new(&net, &mut symbols);
        let setters = Setters::of(&net);
        let first = |sum: &mut u32, g: &Grafcet| Some(std::mem::replace(sum, *sum + g.orders.len() as u32));
        let first_order = net.grafcets.iter().scan(0, first).collect();
        let designations = words::designations(&net);
        Lowering {
            net,
            symbols,
            situation,
            frozen_bits,
            pool,
            timers: IndexVec::new(),
            step_timers: BTreeMap::new(),
            edges: Vec::new(),
            edge_operands: Vec::new(),
            edge_origins: Vec::new(),
            edge_of: FxHashMap::default(),
            delay_of: FxHashMap::default(),
            delay_values: FxHashMap::default(),
            delays: Vec::new(),
            setters,
            first_order,
            designations,
            delay_words: FxHashSet::default(),
            open_needs: Vec::new(),
            needs: Vec::new(),
            parts: Vec::new(),
            kept_wires: FxHashSet::default(),
            redirected: FxHashMap::default(),
        }
    }

    /// What a program keeps of it.
    pub(crate) fn into_parts(self) -> (Symbols, Situation, IndexVec<TimerId, Timer>, Pool) {
        (self.symbols, self.situation, self.timers, self.pool)
    }

    /// The formula of a condition or value at a moment.
    pub(crate) fn expr(&mut self, cx: &mut Context, root: ExprId) -> FormulaId {
        self.satisfy(cx, Need::Expr(root));
        cx.exprs[root]
    }

    /// Emits the assignment of a wire at a moment, after those of the wires that it reads.
    pub(crate) fn wire(&mut self, cx: &mut Context, wire: VariableId) {
        self.satisfy(cx, Need::Wire(wire));
    }

    /// Lowers what `root` needs, then `root`: a walk with its own stack, since the depth of a condition is the author's.
    fn satisfy(&mut self, cx: &mut Context, root: Need) {
        if self.is_done(cx, root) {
            return;
        }
        let mut needs = std::mem::take(&mut self.needs);
        needs.clear();
        self.needs(cx, root, &mut needs);
        // Most conditions are one name.
        if needs.is_empty() {
            self.needs = needs;
            return self.build(cx, root);
        }
        let mut stack = std::mem::take(&mut self.open_needs);
        stack.push((root, false));
        while let Some((need, ready)) = stack.pop() {
            if self.is_done(cx, need) {
                continue;
            }
            if ready {
                self.build(cx, need);
                continue;
            }
            stack.push((need, true));
            needs.clear();
            self.needs(cx, need, &mut needs);
            stack.extend(needs.iter().rev().map(|n| (*n, false)));
        }
        (self.open_needs, self.needs) = (stack, needs);
    }

    fn is_done(&self, cx: &Context, need: Need) -> bool {
        match need {
            Need::Expr(e) => cx.exprs.get(e).is_some(),
            Need::Wire(v) => cx.wires.contains(&v) || self.kept_wires.contains(&v),
            Need::Macro(m) => cx.macros.contains_key(&m),
            Need::Grafcet(g) => cx.grafcets.contains_key(&g),
        }
    }

    fn needs(&self, cx: &Context, need: Need, out: &mut Vec<Need>) {
        match need {
            Need::Wire(v) => {
                out.extend(self.setters.on(v).filter_map(|a| self.net.continuous[a].condition).map(Need::Expr));
            }
            Need::Macro(m) => out.extend(self.net.macro_steps[m].inner.iter().map(|i| Need::Macro(*i))),
            Need::Grafcet(_) => {}
            Need::Expr(e) => match &self.net.exprs[e].kind {
                ExprKind::Literal(_) | ExprKind::StepActive(_) | ExprKind::StepTime(_) | ExprKind::GrafcetFrozen(_) => {
                }
                ExprKind::Variable(v) => {
                    if self.net.variables[*v].mode == Mode::Wire {
                        out.push(Need::Wire(*v));
                    }
                }
                ExprKind::MacroActive(m) => out.push(Need::Macro(*m)),
                ExprKind::GrafcetActive(g) => out.push(Need::Grafcet(*g)),
                ExprKind::And(..) | ExprKind::Or(..) => out.extend(self.chain(e).into_iter().map(Need::Expr)),
                ExprKind::Not(_)
                | ExprKind::Xor(..)
                | ExprKind::Compare(..)
                | ExprKind::Arithmetic(..)
                | ExprKind::Negate(_)
                | ExprKind::Widen(_) => out.extend(self.net.exprs[e].kind.operands().map(Need::Expr)),
                ExprKind::Rise(a) | ExprKind::Fall(a) => {
                    if cx.moment == Moment::MicroStep {
                        out.push(Need::Expr(*a));
                    }
                }
                ExprKind::Delay { on, operand, .. } => {
                    let read = match cx.moment {
                        Moment::First => on.ms == 0,
                        Moment::MicroStep => true,
                        Moment::After | Moment::Restored => false,
                    };
                    if read {
                        out.push(Need::Expr(*operand));
                    }
                }
            },
        }
    }

    /// The operands of a conjunction or disjunction, through all operators of the same kind below it.
    fn chain(&self, root: ExprId) -> Vec<ExprId> {
        let conjunction = matches!(self.net.exprs[root].kind, ExprKind::And(..));
        let mut operands = Vec::new();
        let mut stack = vec![root];
        while let Some(e) = stack.pop() {
            match (&self.net.exprs[e].kind, conjunction) {
                (ExprKind::And(a, b), true) | (ExprKind::Or(a, b), false) => stack.extend([*b, *a]),
                _ => operands.push(e),
            }
        }
        operands
    }

    fn build(&mut self, cx: &mut Context, need: Need) {
        match need {
            Need::Wire(v) => self.build_wire(cx, v),
            Need::Macro(m) => {
                let net = &*self.net.clone();
                let table = &net.macro_steps[m];
                let inner: Vec<FormulaId> = table.inner.iter().map(|i| cx.macros[i]).collect();
                let activity = self.any_active(&table.places, &inner);
                let activity = self.named_activity(cx, &table.label, activity);
                cx.macros.insert(m, activity);
            }
            Need::Grafcet(g) => {
                let net = &*self.net.clone();
                let grafcet = &net.grafcets[g];
                let activity = self.any_active(&grafcet.steps, &[]);
                let activity = self.named_activity(cx, &grafcet.name, activity);
                cx.grafcets.insert(g, activity);
            }
            Need::Expr(e) => {
                let formula = self.build_expr(cx, e);
                let formula = self.split(cx, formula);
                cx.exprs.insert(e, formula);
            }
        }
    }

    /// A Boolean formula that has become too deep to be written in one piece continues as a variable.
    fn split(&mut self, cx: &mut Context, formula: FormulaId) -> FormulaId {
        if self.pool.depth(formula) < DEEPEST || self.pool.ty(formula) != Type::Bool {
            return formula;
        }
        let target =
            self.symbols.fresh(Role::Temporary, eco_format!("part_{}", self.origin_word(cx.origin)), Type::Bool, None);
        cx.statements.push(Statement::assign(cx.origin, target, formula));
        self.parts.push((target, formula));
        self.symbols.read(&mut self.pool, target)
    }

    fn any_active(&mut self, steps: &[StepId], others: &[FormulaId]) -> FormulaId {
        let steps: Vec<FormulaId> = steps.iter().map(|s| self.active(*s)).collect();
        self.pool.or(steps.into_iter().chain(others.iter().copied()))
    }

    /// `XM3 := XE3 OR X30 OR XS3`, so that no condition has to spell it out again.
    fn named_activity(&mut self, cx: &mut Context, label: &str, activity: FormulaId) -> FormulaId {
        if self.pool.is_leaf(activity) {
            return activity;
        }
        self.in_new(cx.origin, &format!("X{label}"), activity, &mut cx.statements)
    }

    /// A wire is true while one of its actions applies; the name itself carries the value (B4).
    fn build_wire(&mut self, cx: &mut Context, wire: VariableId) {
        let net = &*self.net.clone();
        let actions = || self.setters.on(wire).map(|index| &net.continuous[index]);
        let term = |action: &Continuous| (self.active(action.step), action.condition.map(|c| cx.exprs[c]));
        let terms = actions().map(term).collect();
        let of_states = actions().any(|action| self.situation.bit(action.step).is_none());
        let value = factored(&mut self.pool, terms);
        let target = self.symbols.declared(wire);
        let told = if of_states { Told::Steps } else { Told::Nothing };
        cx.statements.push(Statement::Assign { target, value, origin: self.wire_origin(wire), told });
        cx.wires.insert(wire);
    }

    /// An order on a grafcet, by its rank there.
    pub(crate) fn order_origin(&self, g: GrafcetId, rank: usize) -> Origin {
        Origin::Order(OrderId::from(self.first_order[g] as usize + rank))
    }

    /// Where the value of a wire comes from: the one action on it, or all of them.
    pub(crate) fn wire_origin(&self, wire: VariableId) -> Origin {
        let mut actions = self.setters.on(wire);
        match (actions.next(), actions.len()) {
            (Some(only), 0) => Origin::Action(ActionId::from(only)),
            (Some(_) | None, _) => Origin::Actions(wire),
        }
    }

    fn build_expr(&mut self, cx: &mut Context, e: ExprId) -> FormulaId {
        let net = &*self.net.clone();
        let expr = &net.exprs[e];
        match &expr.kind {
            ExprKind::Literal(value) => self.pool.constant(*value, expr.ty),
            ExprKind::Variable(v) => {
                let variable = self.redirected.get(v).copied().unwrap_or_else(|| self.symbols.declared(*v));
                self.symbols.read(&mut self.pool, variable)
            }
            ExprKind::StepActive(s) => self.active(*s),
            ExprKind::StepTime(s) => self.step_time(cx, *s),
            ExprKind::MacroActive(m) => cx.macros[m],
            ExprKind::GrafcetActive(g) => cx.grafcets[g],
            ExprKind::GrafcetFrozen(g) => self.is_frozen(*g),
            ExprKind::Not(a) => self.pool.not(cx.exprs[*a]),
            ExprKind::And(..) => {
                let operands: Vec<FormulaId> = self.chain(e).iter().map(|o| cx.exprs[*o]).collect();
                self.pool.and(operands)
            }
            ExprKind::Or(..) => {
                let operands: Vec<FormulaId> = self.chain(e).iter().map(|o| cx.exprs[*o]).collect();
                self.pool.or(operands)
            }
            ExprKind::Xor(a, b) => self.pool.xor(cx.exprs[*a], cx.exprs[*b]),
            ExprKind::Rise(a) => self.edge(cx, *a, true),
            ExprKind::Fall(a) => self.edge(cx, *a, false),
            ExprKind::Delay { on, operand, off } => self.delay(cx, e, *on, *operand, *off),
            ExprKind::Compare(op, a, b) => {
                let (a, b) = (self.latch(cx, cx.exprs[*a]), self.latch(cx, cx.exprs[*b]));
                self.pool.compare(*op, a, b)
            }
            ExprKind::Arithmetic(op, a, b) => self.arithmetic(cx, *op, expr.ty, cx.exprs[*a], cx.exprs[*b]),
            ExprKind::Negate(a) => {
                let a = self.latch(cx, cx.exprs[*a]);
                self.pool.negate(a)
            }
            ExprKind::Widen(a) => {
                let a = self.latch(cx, cx.exprs[*a]);
                self.pool.widen(expr.ty, a)
            }
        }
    }

    /// Whether one of these steps is active.
    pub(crate) fn one_active(&mut self, steps: &[StepId]) -> FormulaId {
        let active: Vec<FormulaId> = steps.iter().map(|s| self.active(*s)).collect();
        self.pool.or(active)
    }

    /// Whether a pulse order has frozen a grafcet (R15).
    pub(crate) fn is_frozen(&mut self, g: GrafcetId) -> FormulaId {
        match self.frozen_bits.frozen[g] {
            Some(bit) => self.symbols.read(&mut self.pool, bit),
            None => self.pool.truth(false),
        }
    }

    /// Whether a formula reads what stored actions write: it must not be read again once the first of them is done.
    pub(crate) fn reads_written(&self, formula: FormulaId) -> bool {
        self.pool.below(formula).into_iter().any(|f| match self.pool.get(f) {
            Formula::Variable(v) => matches!(self.symbols.table[*v].role, Role::Output | Role::Internal),
            _ => false,
        })
    }

    /// The activity of a step.
    pub(crate) fn active(&self, step: StepId) -> FormulaId {
        self.situation.active(step)
    }

    /// A value that stands for itself or, if it is longer than a variable or a test of a state, in a new temporary.
    pub(crate) fn named(
        &mut self,
        origin: Origin,
        name: &str,
        value: FormulaId,
        statements: &mut Vec<Statement>,
    ) -> FormulaId {
        let short = match self.pool.get(value) {
            Formula::Not(a) => self.pool.is_leaf(*a),
            Formula::Compare(..) => true,
            _ => self.pool.is_leaf(value),
        };
        if short { value } else { self.in_new(origin, name, value, statements) }
    }

    /// A Boolean value in a new temporary.
    pub(crate) fn in_new(
        &mut self,
        origin: Origin,
        name: &str,
        value: FormulaId,
        statements: &mut Vec<Statement>,
    ) -> FormulaId {
        let target = self.symbols.fresh(Role::Temporary, name, Type::Bool, None);
        statements.push(Statement::assign(origin, target, value));
        self.symbols.read(&mut self.pool, target)
    }

    /// Lowers a value inside a branch: the statements that it needs are returned, and what they define is forgotten,
    /// because it holds a value only where the branch is taken.
    pub(crate) fn branch_value(&mut self, cx: &mut Context, value: ExprId) -> (Vec<Statement>, FormulaId) {
        let outer = std::mem::take(&mut cx.statements);
        let (known, divided) = (cx.latched_in_order.len(), cx.divided_in_order.len());
        let formula = self.expr(cx, value);
        for inside in cx.latched_in_order.drain(known..) {
            cx.latched.remove(&inside);
        }
        for inside in cx.divided_in_order.drain(divided..) {
            cx.divided.remove(&inside);
        }
        (std::mem::replace(&mut cx.statements, outer), formula)
    }

    /// Lowers now what is the same for a whole micro-step and must not be defined inside a branch or after the
    /// evolution: delays, which run in every context even if only an output reads them (X6), and for the values of
    /// stored actions (`all`) also edges, durations, wires and macro-steps.
    pub(crate) fn prepare(&mut self, cx: &mut Context, root: ExprId, all: bool) {
        let mut stack = vec![root];
        while let Some(e) = stack.pop() {
            match &self.net.exprs[e].kind {
                ExprKind::Variable(v) => {
                    if all && self.net.variables[*v].mode == Mode::Wire {
                        self.expr(cx, e);
                    }
                }
                ExprKind::StepTime(_)
                | ExprKind::MacroActive(_)
                | ExprKind::GrafcetActive(_)
                | ExprKind::GrafcetFrozen(_)
                | ExprKind::Rise(_)
                | ExprKind::Fall(_) => {
                    if all {
                        self.expr(cx, e);
                    }
                }
                ExprKind::Delay { .. } => {
                    self.expr(cx, e);
                }
                ExprKind::Literal(_)
                | ExprKind::StepActive(_)
                | ExprKind::Not(_)
                | ExprKind::And(..)
                | ExprKind::Or(..)
                | ExprKind::Xor(..)
                | ExprKind::Compare(..)
                | ExprKind::Arithmetic(..)
                | ExprKind::Negate(_)
                | ExprKind::Widen(_) => stack.extend(self.net.exprs[e].kind.operands().rev()),
            }
        }
    }

    fn constant(&mut self, value: Value, ty: Type) -> FormulaId {
        self.pool.constant(value, ty)
    }
}
