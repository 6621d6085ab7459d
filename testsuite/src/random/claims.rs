//! Random claims about a chart that was drawn.

use super::Drawn;
use super::expression::{Allowed, Scope};
use fastrand::Rng;
use grafc_diagnostics::FileId;
use grafc_model::chart::{Chart, Mode, Type, Variable, VariableKind};
use grafc_model::dump::name;

/// The chart with claims of all kinds behind it, those of which no check says that they make no sense.
pub fn with_claims(drawn: &Drawn) -> (String, Chart) {
    let mut rng = Rng::with_seed(drawn.seed ^ 0x636c_6169_6d73);
    let (mut text, mut chart) = (drawn.text.clone(), drawn.chart.clone());
    let inputs = scope(&chart, |variable| matches!(variable.kind, VariableKind::Input | VariableKind::Constant));
    let mut all = scope(&chart, |_| true);
    let labels = chart.steps.iter().map(|step| &step.label);
    all.durations = labels.clone().map(|label| name(&format!("T{label}"))).collect();
    all.activities = labels.map(|label| name(&format!("X{label}"))).collect();
    for number in 0..rng.usize(3..=7) {
        let claim = claim(&mut rng, &inputs, &all, number);
        let with_it = format!("{text}\n{claim}\n");
        let (tree, faults) = grafc_syntax::parse(FileId::new(0), &with_it);
        if let (false, Some(with_claim)) = (faults.has_errors(), grafc_model::check(&tree, "random").0) {
            (text, chart) = (with_it, with_claim);
        }
    }
    (text, chart)
}

fn scope(chart: &Chart, wanted: impl Fn(&Variable) -> bool) -> Scope {
    let named = |is: &dyn Fn(&Variable) -> bool| -> Vec<String> {
        let found = chart.variables.iter().filter(|variable| wanted(variable) && is(variable));
        found.map(|variable| name(&variable.name)).collect()
    };
    let is_wire = |variable: &Variable| variable.mode == Mode::Wire;
    let numbers = chart.variables.iter().filter(|variable| wanted(variable) && variable.ty != Type::Bool);
    Scope {
        bools: named(&|variable| variable.ty == Type::Bool && !is_wire(variable)),
        wires: named(&is_wire),
        numbers: numbers.map(|variable| (name(&variable.name), variable.ty)).collect(),
        constants: named(&|variable| variable.ty != Type::Bool && variable.kind == VariableKind::Constant),
        ..Scope::default()
    }
}

fn claim(rng: &mut Rng, inputs: &Scope, all: &Scope, number: usize) -> String {
    let about_inputs = Allowed { edges: true, delays: false, wires: 0, arithmetic: false };
    let about_states = Allowed { edges: false, delays: false, wires: all.wires.len(), arithmetic: false };
    let activity = |rng: &mut Rng| all.activities[rng.usize(0..all.activities.len())].clone();
    let states = |rng: &mut Rng| all.condition(rng, 2, about_states);
    let (keyword, body) = match rng.u8(0..10) {
        0..3 => ("assume", inputs.condition(rng, 2, about_inputs)),
        3 => {
            let list: Vec<String> = (0..3).map(|_| inputs.condition(rng, 1, about_inputs)).collect();
            ("assume", format!("at most one of {}", list.join(", ")))
        }
        4..6 => ("assert", states(rng)),
        6 => ("assert", format!("after {} : {}", activity(rng), states(rng))),
        7 => ("assert", format!("{} leads to {}", activity(rng), activity(rng))),
        8 => ("reach", states(rng)),
        _ => ("final", format!("at most one of {}, {}", states(rng), states(rng))),
    };
    if rng.bool() { format!("{keyword} \"claim {number}\" : {body}") } else { format!("{keyword} {body}") }
}
