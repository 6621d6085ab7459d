//! Random traces.

use fastrand::Rng;
use grafc_model::chart::{Chart, ExprKind, Type, Value, VariableKind};
use grafc_model::reaction::Stimulus;

/// Steps of time: those that delays of random charts are made of, and one millisecond to either side.
const ADVANCES: [i64; 12] = [0, 1, 10, 499, 500, 500, 501, 1000, 1000, 1500, 2000, 5000];

/// `rows` stimuli for a chart, the initial reaction first.
///
/// Time often goes on to the very millisecond at which a delay of the chart ends that began a few rows before. At times
/// many inputs change in rows that follow each other at once.
pub fn trace(seed: u64, chart: &Chart, rows: usize) -> Vec<Stimulus> {
    let mut rng = Rng::with_seed(seed ^ 0x7472_6163_6500);
    let inputs: Vec<_> = chart.variables.iter().filter(|v| v.kind == VariableKind::Input).collect();
    let delays = delays(chart);
    let mut values: Vec<Value> = inputs.iter().map(|v| v.initial()).collect();
    let mut stimuli: Vec<Stimulus> = Vec::with_capacity(rows);
    let mut t_ms = if rng.bool() { 0 } else { rng.i64(0..10_000) };
    let start = rng.f32() < 0.3;
    let mut burst = 0;
    for row in 0..rows {
        if burst == 0 && rng.f32() < 0.04 {
            burst = rng.usize(3..=6);
        }
        burst = burst.saturating_sub(1);
        if row > 0 {
            t_ms = match rng.u8(0..10) {
                _ if burst > 0 => t_ms + rng.i64(0..=1),
                0..3 if !delays.is_empty() => {
                    let begun = stimuli[row - 1 - rng.usize(0..row.min(6))].t_ms;
                    t_ms.max(begun + delays[rng.usize(0..delays.len())] + [-1, 0, 0, 0, 1][rng.usize(0..5)])
                }
                3 => t_ms + rng.i64(0..=5000),
                _ => t_ms + ADVANCES[rng.usize(0..ADVANCES.len())],
            };
        }
        // Some rows change nothing but the time: then only delays and levels are at work.
        if (row > 0 || start) && (burst > 0 || rng.f32() < 0.85) {
            let share = if burst > 0 { 0.6 } else { 0.35 };
            for (value, variable) in values.iter_mut().zip(&inputs) {
                if rng.f32() < share {
                    *value = change(&mut rng, variable.ty, *value);
                }
            }
        }
        stimuli.push(Stimulus { t_ms, restart: false, inputs: values.clone() });
    }
    restart(seed, &mut stimuli);
    stimuli
}

/// In every third trace the controller restarts now and then. It is drawn apart, so that the rest stays the same.
fn restart(seed: u64, stimuli: &mut [Stimulus]) {
    let mut rng = Rng::with_seed(seed ^ 0x7265_7374);
    if rng.u8(0..3) > 0 {
        return;
    }
    for stimulus in stimuli {
        stimulus.restart = rng.f32() < 0.06;
    }
}

/// The delays of a chart and the times that it compares with, without those of hours.
fn delays(chart: &Chart) -> Vec<i64> {
    let mut found: Vec<i64> = Vec::new();
    for expr in &chart.exprs {
        match &expr.kind {
            ExprKind::Delay { on, off, .. } => found.extend([on.ms, off.ms]),
            ExprKind::Literal(Value::Time(ms)) => found.push(*ms),
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
            | ExprKind::Rise(_)
            | ExprKind::Fall(_)
            | ExprKind::Compare(..)
            | ExprKind::Arithmetic(..)
            | ExprKind::Negate(_)
            | ExprKind::Widen(_) => {}
        }
    }
    found.retain(|ms| (1..600_000).contains(ms));
    found.sort_unstable();
    found.dedup();
    found
}

fn change(rng: &mut Rng, ty: Type, value: Value) -> Value {
    let small = rng.i64(0..=5);
    let extreme = rng.f32() < 0.15;
    match (value, ty) {
        (Value::Bool(b), _) => Value::Bool(!b),
        (Value::Time(_), _) => Value::Time([0, 1, 500, 1000, 1500, 90_000][small as usize]),
        (Value::Int(_), Type::Int) if extreme => Value::Int([32_767, -32_768, -1][rng.usize(0..3)]),
        (Value::Int(_), Type::Dint) if extreme => Value::Int([2_147_483_647, -2_147_483_648, -1][rng.usize(0..3)]),
        (Value::Int(_), Type::Uint) if extreme => Value::Int(65_535),
        (Value::Int(_), Type::Udint) if extreme => Value::Int(4_294_967_295),
        (Value::Int(_), _) => Value::Int(small),
        (Value::Real(_), Type::Real) if extreme => Value::Real(f64::from([0.1f32, -2.5, 1.0e6][rng.usize(0..3)])),
        (Value::Real(_), _) if extreme => Value::Real([0.1, -2.5, 1.0e6][rng.usize(0..3)]),
        (Value::Real(_), _) => Value::Real(small as f64 / 2.0),
    }
}
