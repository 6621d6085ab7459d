//! Changes of random charts that bring them to the border between what is warned of and what is not.

use super::probes::variable;
use fastrand::Rng;
use grafc_diagnostics::{FileId, Span};
use grafc_model::chart::{
    Arithmetic, Comparison, Event, Expr, ExprId, ExprKind, Mode, StepId, Stored, Tables, TransitionId, Type, Value,
    VariableId, VariableKind,
};

fn push(chart: &mut Tables, kind: ExprKind, ty: Type) -> ExprId {
    let span = chart.steps[StepId::new(0)].span;
    chart.exprs.push(Expr { kind, ty, span })
}

fn step(rng: &mut Rng, chart: &Tables) -> StepId {
    StepId::new(rng.usize(0..chart.steps.len()))
}

fn transition(rng: &mut Rng, chart: &Tables) -> TransitionId {
    TransitionId::new(rng.usize(0..chart.transitions.len()))
}

/// An input of type bool, or `1`.
fn input(rng: &mut Rng, chart: &mut Tables) -> ExprId {
    let inputs = chart.variables.iter_enumerated().filter(|(_, v)| v.kind == VariableKind::Input && v.ty == Type::Bool);
    let inputs: Vec<VariableId> = inputs.map(|(v, _)| v).collect();
    match rng.choice(inputs) {
        Some(input) => push(chart, ExprKind::Variable(input), Type::Bool),
        None => push(chart, ExprKind::Literal(Value::Bool(true)), Type::Bool),
    }
}

/// A stored action of its own place in the text.
fn act(chart: &mut Tables, event: Event, target: VariableId, value: ExprId) {
    let place = 1_000_000 + 2 * chart.stored.len();
    let span = Span::new(FileId::default(), place, place + 1);
    chart.stored.push(Stored { event, target, value, span });
}

/// Many selections become exclusive, and a few variables get several assignments.
pub fn for_meetings(chart: &mut Tables, seed: u64) {
    let mut rng = Rng::with_seed(seed ^ 0x6d65_6574);
    if chart.transitions.is_empty() {
        return;
    }
    for later in 0..chart.transitions.len() {
        for earlier in 0..later {
            let (a, b) = (TransitionId::new(earlier), TransitionId::new(later));
            let shared = chart.transitions[a].pre.iter().any(|s| chart.transitions[b].pre.contains(s));
            if shared && rng.f32() < 0.6 {
                let not = push(chart, ExprKind::Not(chart.transitions[a].condition), Type::Bool);
                let both = push(chart, ExprKind::And(not, chart.transitions[b].condition), Type::Bool);
                chart.transitions[b].condition = both;
            }
        }
    }
    for _ in 0..rng.usize(0..=3) {
        let target = variable(chart, Type::Dint, Value::Int(0));
        for _ in 0..rng.usize(2..=3) {
            let level = input(&mut rng, chart);
            let event = match rng.usize(0..6) {
                0 | 1 => Event::Activation(step(&mut rng, chart)),
                2 => Event::Deactivation(step(&mut rng, chart)),
                3 => Event::Clearing(transition(&mut rng, chart)),
                4 => Event::Event(step(&mut rng, chart), level),
                _ => Event::Event(step(&mut rng, chart), push(chart, ExprKind::Rise(level), Type::Bool)),
            };
            let value = if rng.bool() {
                let (old, one) = (ExprKind::Variable(target), ExprKind::Literal(Value::Int(1)));
                let (old, one) = (push(chart, old, Type::Dint), push(chart, one, Type::Dint));
                push(chart, ExprKind::Arithmetic(Arithmetic::Add, old, one), Type::Dint)
            } else {
                push(chart, ExprKind::Literal(Value::Int(rng.i64(0..2))), Type::Dint)
            };
            act(chart, event, target, value);
        }
    }
}

/// One thing that may show that steps overlap, or none.
pub fn for_overlap(chart: &mut Tables, seed: u64) {
    let mut rng = Rng::with_seed(seed ^ 0x6f76_6572);
    let seen = step(&mut rng, chart);
    let at = step(&mut rng, chart);
    let activity = push(chart, ExprKind::StepActive(seen), Type::Bool);
    let choice = rng.usize(0..15);
    match choice {
        0..=3 => {
            let factor = match choice {
                0 => activity,
                1 => push(chart, ExprKind::Rise(activity), Type::Bool),
                2 => wire(&mut rng, chart),
                _ => {
                    let counter = counter(chart, Event::Activation(seen));
                    let (count, two) = (ExprKind::Variable(counter), ExprKind::Literal(Value::Int(2)));
                    let (count, two) = (push(chart, count, Type::Dint), push(chart, two, Type::Dint));
                    push(chart, ExprKind::Compare(Comparison::Less, count, two), Type::Bool)
                }
            };
            let t = transition(&mut rng, chart);
            let factor = if rng.bool() { factor } else { push(chart, ExprKind::Not(factor), Type::Bool) };
            let condition = push(chart, ExprKind::And(factor, chart.transitions[t].condition), Type::Bool);
            chart.transitions[t].condition = condition;
        }
        4 => drop(counter(chart, Event::Deactivation(seen))),
        5 => {
            let t = transition(&mut rng, chart);
            counter(chart, Event::Clearing(t));
        }
        6 | 7 => {
            let operand = if choice == 6 { activity } else { wire(&mut rng, chart) };
            let edge = if rng.bool() { ExprKind::Rise(operand) } else { ExprKind::Fall(operand) };
            let edge = push(chart, edge, Type::Bool);
            counter(chart, Event::Event(at, edge));
        }
        8 => {
            let level = input(&mut rng, chart);
            let event = if rng.bool() { level } else { push(chart, ExprKind::Rise(level), Type::Bool) };
            counter(chart, Event::Event(at, event));
        }
        9 | 10 => {
            let value = if choice == 9 { activity } else { wire(&mut rng, chart) };
            let target = variable(chart, Type::Bool, Value::Bool(false));
            act(chart, Event::Activation(at), target, value);
        }
        11 => {
            let count = counter(chart, Event::Activation(seen));
            let target = variable(chart, Type::Dint, Value::Int(0));
            let value = push(chart, ExprKind::Variable(count), Type::Dint);
            act(chart, Event::Activation(at), target, value);
        }
        12 | 13 => {
            let target = variable(chart, Type::Dint, Value::Int(0));
            for (s, value) in [(seen, 1), (at, 2)] {
                let value = push(chart, ExprKind::Literal(Value::Int(value)), Type::Dint);
                act(chart, Event::Activation(s), target, value);
            }
        }
        _ => {}
    }
}

fn counter(chart: &mut Tables, event: Event) -> VariableId {
    let target = variable(chart, Type::Dint, Value::Int(0));
    let (old, one) = (ExprKind::Variable(target), ExprKind::Literal(Value::Int(1)));
    let (old, one) = (push(chart, old, Type::Dint), push(chart, one, Type::Dint));
    let value = push(chart, ExprKind::Arithmetic(Arithmetic::Add, old, one), Type::Dint);
    act(chart, event, target, value);
    target
}

/// An output of continuous actions, or `1`.
fn wire(rng: &mut Rng, chart: &mut Tables) -> ExprId {
    let wires = chart.variables.iter_enumerated().filter(|(_, v)| v.mode == Mode::Wire);
    let wires: Vec<VariableId> = wires.map(|(v, _)| v).collect();
    match rng.choice(wires) {
        Some(wire) => push(chart, ExprKind::Variable(wire), Type::Bool),
        None => push(chart, ExprKind::Literal(Value::Bool(true)), Type::Bool),
    }
}
