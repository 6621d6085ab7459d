//! A trace under the reference simulator: what is shown to people has been seen there.

use crate::facts::{Active, Fact, Facts};
use crate::goal::Goal;
use crate::machine::End;
use grafc_formula::Value;
use grafc_logic::scan::{Program, TransitionId};
use grafc_model::chart::{Chart, ClaimKind};
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
    simulator.watch_claims();
    let mut facts = Facts::new(program);
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
        if !claims(chart, &simulator, &mut facts) {
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

/// Notes what the chart's own claims say after a reaction; whether its assumptions were kept.
fn claims(chart: &Chart, simulator: &Simulator, facts: &mut Facts) -> bool {
    let (mut assertions, mut wanted) = (0.., 0..);
    chart.claims.list.iter().filter_map(|claim| Some((claim.kind, claim.condition()?))).all(|(kind, condition)| {
        let holds = simulator.claimed(condition);
        match kind {
            ClaimKind::Assume => return holds,
            ClaimKind::Assert => {
                let broken = assertions.next().map(Fact::Broken).filter(|_| !holds);
                broken.into_iter().for_each(|fact| facts.note(fact));
            }
            ClaimKind::Reach => {
                let met = wanted.next().map(Fact::Wanted).filter(|_| holds);
                met.into_iter().for_each(|fact| facts.note(fact));
            }
            ClaimKind::Final => {}
        }
        true
    })
}

fn active(simulator: &Simulator) -> Active {
    simulator.state().situation().iter().copied().collect()
}
