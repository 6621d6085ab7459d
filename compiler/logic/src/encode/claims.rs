//! Claims: their conditions as variables, if somebody asks for them.
//!
//! ```text
//! before the evolution    assumed_1 := NOT (rising_a AND b)     inputs, and what was kept of those of the call before
//! after the outputs       claimed_2 := NOT X5 OR VB             the state reached, and what is published
//! at the very end         was_low_1 := NOT a                    for the edges of the next call
//! ```
//!
//! What is kept of an operand is that it was low, for a rising edge, or high, for a falling one: so both are absent in the
//! first call, when nothing has been kept.

use super::without_flag::without_flag;
use crate::lower::{Context, Lowering, Moment};
use crate::scan::{ClaimKind, Heading, Origin, Role, SeenBody, SeenClaim, Statement, VarId};
use ecow::{EcoString, eco_format};
use grafc_formula::{Comparison, FormulaId, Type, Value};
use grafc_model::chart::{Claim, ClaimBody, Expr, ExprId, ExprKind, Mode, VariableKind};
use grafc_net::Net;
use std::sync::Arc;

/// What claims add to a program.
#[derive(Default)]
pub(crate) struct Lowered {
    pub(crate) seen: Vec<SeenClaim>,
    /// Before the evolution.
    pub(crate) before: Vec<Statement>,
    /// After the outputs.
    pub(crate) after: Vec<Statement>,
}

/// Lowers the claims of the net, those of a kind that is `wanted`. The outputs have been lowered.
pub(crate) fn lower(lowering: &mut Lowering, wanted: impl Fn(ClaimKind) -> bool) -> Lowered {
    let net = lowering.net.clone();
    if !net.claims.list.iter().any(|claim| wanted(claim.kind)) {
        return Lowered::default();
    }
    // The lowering walks one pool; that of the claims goes behind it for as long as they are lowered.
    let offset = net.exprs.len();
    lowering.net = Arc::new(with_claims(&net, offset));
    let mut lowered = Lowered::default();
    let (mut given, mut reached) = (Context::new(Moment::After), after_outputs(&net));
    let mut kept = Vec::new();
    for (place, claim) in net.claims.list.iter().enumerate().filter(|(_, claim)| wanted(claim.kind)) {
        let cx = if claim.kind == ClaimKind::Assume { &mut given } else { &mut reached };
        for id in claim.nodes() {
            edge(lowering, cx, id, offset, &mut kept);
        }
        let mut variable = |id: ExprId, word: &str| {
            let value = lowering.expr(cx, moved(id, offset));
            let about = Some(EcoString::from(claim.name()).into());
            let name = eco_format!("{word}_{}", place + 1);
            let target = lowering.symbols.fresh(Role::Observed, name, Type::Bool, about);
            cx.statements.push(Statement::assign(Origin::Chart, target, value));
            target
        };
        let body = match claim.body {
            ClaimBody::Condition(id) => SeenBody::Condition(variable(id, word(claim.kind))),
            ClaimBody::Leads(from, to) => SeenBody::Leads(variable(from, "from"), variable(to, "to")),
        };
        lowered.seen.push(seen(place, claim, body));
    }
    lowered.before = without_flag(lowering, given.statements);
    lowered.after = without_flag(lowering, reached.statements);
    lowered.after.extend(kept);
    lowering.net = net;
    lowered
}

/// Checks the assertions of the net, if an output is to tell the first that is false: once one was, it stays. A call that
/// was `cut_off` has reached no state. The outputs have been lowered.
pub(crate) fn check(lowering: &mut Lowering, cut_off: Option<VarId>) -> Vec<Statement> {
    let net = lowering.net.clone();
    let Some(assertion) = net.controls.assertion else { return Vec::new() };
    let offset = net.exprs.len();
    lowering.net = Arc::new(with_claims(&net, offset));
    let mut cx = after_outputs(&net);
    let target = lowering.symbols.declared(assertion);
    let ty = lowering.symbols.table[target].ty;
    let (mut branches, mut otherwise) = (Vec::new(), Vec::new());
    for (number, _, condition) in net.claims.assertions() {
        let holds = lowering.expr(&mut cx, moved(condition, offset));
        let fails = lowering.pool.not(holds);
        let value = lowering.pool.constant(Value::Int(number as i64), ty);
        let told = vec![Statement::assign(Origin::Declaration(assertion), target, value)];
        match lowering.pool.as_constant(fails) {
            Some(Value::Bool(true)) => {
                otherwise = told;
                break;
            }
            Some(_) => {}
            None => branches.push((fails, told)),
        }
    }
    lowering.net = net;
    let body = if branches.is_empty() { otherwise } else { vec![Statement::choice(branches, otherwise)] };
    if body.is_empty() {
        return Vec::new();
    }
    let (none, now) = (lowering.pool.constant(Value::Int(0), ty), lowering.symbols.read(&mut lowering.pool, target));
    let mut when = vec![lowering.pool.compare(Comparison::Equal, now, none)];
    if let Some(again) = cut_off {
        let again = lowering.symbols.read(&mut lowering.pool, again);
        when.push(lowering.pool.not(again));
    }
    let when = lowering.pool.and(when);
    let mut out = vec![Statement::Heading(Heading::Assertions)];
    out.extend(without_flag(lowering, cx.statements));
    out.push(Statement::when(when, body));
    out
}

/// The moment after the outputs, which have their values by then.
fn after_outputs(net: &Net) -> Context {
    let mut cx = Context::new(Moment::After);
    for (v, variable) in net.variables.iter_enumerated() {
        if variable.mode == Mode::Wire && variable.kind == VariableKind::Output {
            cx.has_wire(v);
        }
    }
    cx
}

fn word(kind: ClaimKind) -> &'static str {
    match kind {
        ClaimKind::Assume => "assumed",
        ClaimKind::Assert => "asserted",
        ClaimKind::Reach => "wanted",
        ClaimKind::Final => "final",
    }
}

fn seen(place: usize, claim: &Claim, body: SeenBody) -> SeenClaim {
    SeenClaim { place, kind: claim.kind, name: EcoString::from(claim.name()), body, span: claim.span }
}

/// An edge of an assumption, against what was kept; and what the next call will be compared with.
fn edge(lowering: &mut Lowering, cx: &mut Context, id: ExprId, offset: usize, kept: &mut Vec<Statement>) {
    let (operand, name) = match lowering.net.claims.exprs[id].kind {
        ExprKind::Rise(operand) => (operand, "was_low"),
        ExprKind::Fall(operand) => (operand, "was_high"),
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
        | ExprKind::Delay { .. }
        | ExprKind::Compare(..)
        | ExprKind::Arithmetic(..)
        | ExprKind::Negate(_)
        | ExprKind::Widen(_) => return,
    };
    let now = lowering.expr(cx, moved(operand, offset));
    let low = lowering.pool.not(now);
    let (is, was): (FormulaId, FormulaId) = if name == "was_low" { (now, low) } else { (low, now) };
    let memory: VarId = lowering.symbols.fresh(Role::Memory, eco_format!("{name}_{}", id.index()), Type::Bool, None);
    let before = lowering.symbols.read(&mut lowering.pool, memory);
    let edge = lowering.pool.and([is, before]);
    cx.know(moved(id, offset), edge);
    kept.push(Statement::assign(Origin::Chart, memory, was));
}

fn moved(id: ExprId, offset: usize) -> ExprId {
    ExprId::new(id.index() + offset)
}

/// The net with the conditions of its claims behind its own.
fn with_claims(net: &Net, offset: usize) -> Net {
    let mut net = net.clone();
    for expr in &net.claims.exprs {
        net.exprs.push(Expr { kind: expr.kind.moved(offset), ..*expr });
    }
    net
}
