//! Runs of a chart in the simulator and as a scan program, kept as what could be seen on the way.

use grafc_logic::scan::evaluate::Evaluator;
use grafc_logic::scan::{Program, VarId};
use grafc_model::chart::{Chart, Mode, StepId, Value, VariableId};
use grafc_model::reaction::{Flags, Profile, Response, Stimulus};
use grafc_model::simulate::Simulator;
use grafc_testsuite::compare::first_difference;
use grafc_testsuite::net_steps::same;

/// What can be seen after a micro-step.
pub struct Sight {
    active: Vec<StepId>,
    /// The values of stored variables.
    stored: Vec<Value>,
    /// Without DIV0, which says nothing of the moment, and LIVELOCK, which is raised after the last micro-step.
    flags: Flags,
}

impl Sight {
    fn same(&self, other: &Sight) -> bool {
        self.active == other.active
            && self.flags == other.flags
            && self.stored.iter().zip(&other.stored).all(|(a, b)| same(*a, *b))
    }

    fn spell(&self, chart: &Chart) -> String {
        let labels: Vec<&str> = self.active.iter().map(|s| chart.steps[*s].label.as_str()).collect();
        let raised: Vec<&str> = self.flags.names().collect();
        format!("{{{}}} {:?} {raised:?}", labels.join(", "), self.stored)
    }
}

/// All that a run showed, with the reaction in which it was seen, and what each call published.
#[derive(Default)]
pub struct Run {
    pub seen: Vec<(usize, Sight)>,
    pub responses: Vec<Response>,
    /// Micro-steps, and how many of them changed nothing that can be seen.
    pub micro_steps: usize,
    pub idle: usize,
}

impl Run {
    /// `start` is what a reaction starts from; after the first one that is what the one before has left.
    fn see(&mut self, reaction: usize, start: bool, sight: Sight) {
        let changed = self.seen.last().is_none_or(|(_, last)| !last.same(&sight));
        self.micro_steps += usize::from(!start);
        self.idle += usize::from(!start && !changed);
        if changed {
            self.seen.push((reaction, sight));
        }
    }
}

fn without_moment(flags: Flags) -> Flags {
    Flags { div0: false, livelock: false, ..flags }
}

fn stored(chart: &Chart) -> Vec<VariableId> {
    chart.variables.iter_enumerated().filter(|(_, v)| v.mode == Mode::Stored).map(|(v, _)| v).collect()
}

pub fn simulated(chart: &Chart, profile: Profile, stimuli: &[Stimulus]) -> Run {
    let stored = stored(chart);
    let mut run = Run::default();
    let mut simulator = Simulator::new(chart, profile);
    for (reaction, stimulus) in stimuli.iter().enumerate() {
        // It shows the start of the first reaction only.
        let mut start = reaction == 0;
        let response = simulator.react_observed(stimulus, &mut |s| {
            let active = s.state().situation().iter_enumerated().filter(|(_, active)| **active).map(|(s, _)| s);
            let sight = Sight {
                active: active.collect(),
                stored: stored.iter().map(|v| s.state().variables()[*v]).collect(),
                flags: without_moment(s.flags()),
            };
            run.see(reaction, std::mem::take(&mut start), sight);
        });
        run.responses.push(response);
    }
    run
}

/// `settled` says which of the active steps count.
pub fn evaluated(
    chart: &Chart,
    program: &Program,
    stimuli: &[Stimulus],
    settled: impl Fn(Vec<StepId>) -> Vec<StepId>,
) -> Run {
    // The chart's variables come first in a program, in order.
    let stored: Vec<VarId> = stored(chart).into_iter().map(|v| VarId::new(v.index())).collect();
    // A reaction begins with outputs on arcs false (R9), which the simulator shows after its first micro-step.
    let has_outputs_on_arcs = chart.variables.iter().any(|variable| variable.momentary);
    let mut run = Run::default();
    let mut evaluator = Evaluator::new(program);
    for (reaction, stimulus) in stimuli.iter().enumerate() {
        let mut start = true;
        let response = evaluator.react_observed(stimulus, |e| {
            let is_start = std::mem::take(&mut start);
            if is_start && has_outputs_on_arcs && reaction > 0 && !stimulus.restart {
                return;
            }
            let sight = Sight {
                active: settled(e.situation()),
                stored: stored.iter().map(|v| e.value_of(*v)).collect(),
                flags: without_moment(e.flags()),
            };
            run.see(reaction, is_start, sight);
        });
        run.responses.push(response);
    }
    run
}

/// The first place at which two runs differ, spelt out.
pub fn difference(chart: &Chart, expected: &Run, actual: &Run) -> Option<String> {
    let place =
        (0..expected.seen.len().max(actual.seen.len())).find(|i| match (expected.seen.get(*i), actual.seen.get(*i)) {
            (Some((row, expected)), Some((other, actual))) => row != other || !expected.same(actual),
            (_, _) => true,
        });
    if let Some(i) = place {
        let spell = |run: &Run| match run.seen.get(i) {
            Some((row, sight)) => format!("in reaction {row}: {}", sight.spell(chart)),
            None => "nothing more".to_owned(),
        };
        let before = i.checked_sub(1).and_then(|i| expected.seen.get(i));
        let before = before.map_or("nothing".to_owned(), |(_, sight)| sight.spell(chart));
        return Some(format!("after {before}\n  simulator {}\n  program   {}", spell(expected), spell(actual)));
    }
    let row = first_difference(&expected.responses, &actual.responses)?;
    Some(format!("row {row}\n  simulator {:?}\n  program   {:?}", expected.responses[row], actual.responses[row]))
}
