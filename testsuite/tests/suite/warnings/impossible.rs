//! Changes of random charts after which some steps are never active and some transitions never clear: a condition becomes
//! false, a transition waits for one step more or for a step that is not active then, a step loses what leads to it.

use fastrand::Rng;
use grafc_model::chart::{Expr, ExprId, ExprKind, Node, StepId, Tables, TransitionId, Type, Value};

fn push(chart: &mut Tables, kind: ExprKind) -> ExprId {
    let span = chart.steps[StepId::new(0)].span;
    chart.exprs.push(Expr { kind, ty: Type::Bool, span })
}

/// A few changes.
pub fn change(chart: &mut Tables, seed: u64) {
    let mut rng = Rng::with_seed(seed ^ 0x6e65_7665);
    for _ in 0..rng.usize(0..=3) {
        if chart.transitions.is_empty() {
            return;
        }
        let t = TransitionId::new(rng.usize(0..chart.transitions.len()));
        let (grafcet, condition) = (chart.transitions[t].grafcet, chart.transitions[t].condition);
        let steps = &chart.grafcets[grafcet].steps;
        let other = steps[rng.usize(0..steps.len())];
        match rng.u8(0..4) {
            0 => {
                let not = push(chart, ExprKind::Not(condition));
                chart.transitions[t].condition = match rng.bool() {
                    true => push(chart, ExprKind::And(condition, not)),
                    false => push(chart, ExprKind::Literal(Value::Bool(false))),
                };
            }
            1 => {
                let active = push(chart, ExprKind::StepActive(other));
                chart.transitions[t].condition = push(chart, ExprKind::And(condition, active));
            }
            // In the frame of the transition: what is of an expansion stays there.
            2 => {
                let is_near = |node: &Node| matches!(node, Node::Step(s) if chart.steps[*s].expansion_of == chart.steps[other].expansion_of);
                let transition = &chart.transitions[t];
                if !transition.pre.is_empty()
                    && transition.pre.iter().all(is_near)
                    && !transition.pre.contains(&Node::Step(other))
                {
                    chart.transitions[t].pre.push(Node::Step(other));
                }
            }
            _ => chart.transitions[t].post.clear(),
        }
        // A transition without steps is none.
        if chart.transitions[t].pre.is_empty() && chart.transitions[t].post.is_empty() {
            chart.transitions[t].post.push(Node::Step(other));
        }
    }
}
