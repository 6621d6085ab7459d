//! What the simulator does in each micro-step.
//!
//! It shows situations and variables. So the chart that it is given here has some variables more: one for each
//! transition that counts its clearings, and two for each stored action, one that counts how often it is done and one
//! that takes its value. Nothing reads them. They make some reactions longer, by micro-steps in which a transition clears
//! and nothing else changes; the rules allow these at any time.

use grafc_model::chart::{
    Arithmetic, Chart, Event, Expr, ExprKind, Mode, Stored, Tables, TransitionId, Type, Value, Variable, VariableId,
    VariableKind,
};
use grafc_model::reaction::{Evolution, Profile, Stimulus};
use grafc_model::simulate::{Activity, Simulator};
use index_vec::IndexVec;

/// One micro-step, or the start.
pub struct Seen {
    pub reaction: usize,
    pub before: Activity,
    pub after: Activity,
    pub cleared: Vec<TransitionId>,
    /// Stored actions by number, each with the value that it assigned.
    pub done: Vec<(usize, Value)>,
    /// Whether an order has contradicted another one so far.
    pub force_conflict: bool,
}

/// A run.
pub struct Watched {
    pub seen: Vec<Seen>,
    /// The situation after each reaction that came to an end of its own.
    pub stable: Vec<Activity>,
}

struct Probes {
    clearings: Vec<VariableId>,
    /// By stored action: how often it was done, and its value.
    actions: Vec<(VariableId, VariableId)>,
}

pub fn watch(chart: &Chart, profile: Profile, stimuli: &[Stimulus]) -> Watched {
    let (probed, probes) = probed(chart);
    let mut watched = Watched { seen: Vec::new(), stable: Vec::new() };
    let mut simulator = Simulator::new(&probed, profile);
    let bound = profile.bound_for(chart.steps.len(), chart.transitions.len());
    let mut active: Activity = chart.steps.iter().map(|_| false).collect();
    let mut values: IndexVec<VariableId, Value> = probed.variables.iter().map(|v| v.initial()).collect();
    for (reaction, stimulus) in stimuli.iter().enumerate() {
        let mut sights = 0;
        simulator.react_observed(stimulus, &mut |s| {
            sights += 1;
            let now = s.state().variables();
            let counted = |v: VariableId| now[v] != values[v];
            let clearings = probes.clearings.iter().enumerate().filter(|(_, v)| counted(**v));
            let actions = probes.actions.iter().enumerate().filter(|(_, (count, _))| counted(*count));
            let seen = Seen {
                reaction,
                before: std::mem::replace(&mut active, s.state().situation().clone()),
                after: s.state().situation().clone(),
                cleared: clearings.map(|(t, _)| TransitionId::new(t)).collect(),
                done: actions.map(|(i, (_, value))| (i, now[*value])).collect(),
                force_conflict: s.flags().force_conflict,
            };
            watched.seen.push(seen);
            values = now.clone();
        });
        let micro_steps = sights - u32::from(reaction == 0);
        if chart.options.over(profile).evolution == Evolution::Stable && micro_steps < bound {
            watched.stable.push(active.clone());
        }
    }
    watched
}

fn probed(chart: &Chart) -> (Chart, Probes) {
    let mut probed = chart.clone();
    let clearings =
        chart.transitions.iter_enumerated().map(|(t, _)| count(probed.edit(), Event::Clearing(t))).collect();
    let mut actions = Vec::new();
    for action in &chart.stored {
        let counted = count(probed.edit(), action.event);
        let value = variable(probed.edit(), chart.exprs[action.value].ty, chart.variables[action.target].initial());
        probed.edit().stored.push(Stored { target: value, ..action.clone() });
        actions.push((counted, value));
    }
    (probed, Probes { clearings, actions })
}

/// Counts how often an event occurs.
fn count(chart: &mut Tables, event: Event) -> VariableId {
    let counter = variable(chart, Type::Dint, Value::Int(0));
    let span = chart.steps.first().map(|s| s.span).expect("a chart has steps");
    let mut push = |kind| chart.exprs.push(Expr { kind, ty: Type::Dint, span });
    let (old, one) = (push(ExprKind::Variable(counter)), push(ExprKind::Literal(Value::Int(1))));
    let value = push(ExprKind::Arithmetic(Arithmetic::Add, old, one));
    chart.stored.push(Stored { event, target: counter, value, span });
    counter
}

/// A further variable that stored actions write.
pub fn variable(chart: &mut Tables, ty: Type, initial: Value) -> VariableId {
    let span = chart.steps.first().map(|s| s.span).expect("a chart has steps");
    let name = format!("more_{}", chart.variables.len());
    let variable = Variable::new(name, VariableKind::Output, ty, initial, span);
    chart.variables.push(Variable { mode: Mode::Stored, ..variable })
}
