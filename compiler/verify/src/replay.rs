//! A trace under the reference simulator: what is shown to people has been seen there.

use crate::claimed::Claimed;
use crate::facts::{Active, Fact, Facts};
use crate::goal::Goal;
use crate::machine::End;
use grafc_formula::{Value, VarId};
use grafc_logic::scan::evaluate::Evaluator;
use grafc_logic::scan::{Program, TransitionId};
use grafc_model::chart::Chart;
use grafc_model::reaction::{Profile, Stimulus};
use grafc_model::simulate::Simulator;

/// Whether the simulator ends each reaction as it was found to end, and shows in the last one what was looked for.
pub(crate) fn replays(
    chart: &Chart,
    profile: Profile,
    program: &Program,
    rows: &[(i64, Vec<Value>)],
    ends: &[End],
    goal: Goal,
) -> bool {
    let mut simulator = Simulator::new(chart, profile);
    let mut facts = Facts::new(program);
    // What claims say is computed by the program, whose states are compared with the simulator's.
    let mut evaluator = Evaluator::new(program);
    let claimed = Claimed::new(program);
    for (place, ((t_ms, inputs), end)) in rows.iter().zip(ends).enumerate() {
        facts.forget();
        let before = simulator.flags();
        let stimulus = Stimulus { t_ms: *t_ms, restart: false, inputs: inputs.clone() };
        // Of the initial reaction it is shown how it starts.
        let mut at: Option<Active> = (place > 0).then(|| active(&simulator));
        simulator.react_observed(&stimulus, &mut |simulator| {
            let now = active(simulator);
            match at.replace(now.clone()) {
                None => facts.situation(&now),
                Some(before) => {
                    let cleared = simulator.cleared().iter_enumerated().filter(|(_, cleared)| **cleared);
                    let cleared: Vec<TransitionId> = cleared.map(|(t, _)| t).collect();
                    facts.micro_step(&before, &cleared, &now);
                }
            }
        });
        let after = simulator.flags();
        evaluator.react(&stimulus);
        let holds = |v: &VarId| evaluator.value_of(*v) == Value::Bool(true);
        let broken =
            claimed.assertions.iter().enumerate().filter(|(_, v)| !holds(v)).map(|(place, _)| Fact::Broken(place));
        let met = claimed.wanted.iter().enumerate().filter(|(_, v)| holds(v)).map(|(place, _)| Fact::Wanted(place));
        broken.chain(met).for_each(|fact| facts.note(fact));
        if claimed.assumptions.iter().any(|v| !holds(v)) {
            return false;
        }
        for (was, is, fact) in [
            (before.livelock, after.livelock, Fact::Livelock),
            (before.alloc_conflict, after.alloc_conflict, Fact::AllocConflict),
            (before.force_conflict, after.force_conflict, Fact::ForceConflict),
        ] {
            if is && !was {
                facts.note(fact);
            }
        }
        let agrees = match end {
            End::Livelock(_) => after.livelock,
            End::Barred => false,
            End::Rest(_, situation) => {
                let active = active(&simulator);
                after.livelock == before.livelock
                    && situation.iter().copied().eq((0..active.len()).filter(|s| active[*s]))
            }
        };
        if !agrees {
            return false;
        }
    }
    match goal {
        Goal::Fact(fact) => facts.seen().any(|seen| seen == fact),
        // That there is no way on is proved; the situation is the one.
        Goal::Stuck | Goal::Homeless | Goal::Lost(_) => true,
    }
}

fn active(simulator: &Simulator) -> Active {
    simulator.state().situation().iter().copied().collect()
}
