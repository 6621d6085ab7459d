//! Certification tests of the textbook (A. A. Shalyto, *Logical control*): round trips through the graph of what a chart can
//! come to, each as a trace with what the reference simulator makes of it.
//!
//! A trip is found in the explored states of the scan program. What is expected comes from the rules alone: the simulator
//! runs each trip, and a trip on which it does anything else, or on which a controller that calls all the time would see
//! what no row shows, is not taken.

use crate::trips::{Cover, Item, Leg, Plan, Totals};
use grafc_model::chart::{Chart, Mode, Value, VariableKind};
use grafc_model::reaction::{Evolution, Profile, Response, Stimulus};
use grafc_model::simulate::{Call, Calls, Onlooker, Probe, Run, Simulator};
use grafc_model::trace::write_test;
use grafc_verify::Moves;
use std::collections::BTreeSet;

/// The tests of a chart, and how good they are.
#[derive(Clone, Debug)]
pub struct Certified {
    /// The tests.
    pub tests: Vec<CertifiedTest>,
    /// How many tests and rows, and how few there can be.
    pub totals: Totals,
    /// So many things are covered.
    pub covered: usize,
    /// What can be covered only if delays end otherwise than was tried, in words.
    pub open: Vec<String>,
    /// The transitions that nothing clears, in words; of transitions alone.
    pub dead: Vec<String>,
    /// Whether all that the chart can come to was looked at.
    pub complete: bool,
}

/// One test.
#[derive(Clone, Debug)]
pub struct CertifiedTest {
    /// The table.
    pub text: String,
    /// The calls.
    pub stimuli: Vec<Stimulus>,
    /// What it covers first, in words.
    pub covers: Vec<String>,
    /// Whether it ends in an initial situation.
    pub comes_home: bool,
}

/// So often trips are searched anew because a controller would see more of one than its rows do.
const MOST_ROUNDS: usize = 50;

/// Makes tests of a chart from what was found by the clock, and what is found if delays end at any time. `period` is that at
/// which a controller calls the chart.
pub fn certify(
    chart: &Chart,
    profile: Profile,
    cover: Cover,
    period: i64,
    (moves, free): (&Moves, &Moves),
) -> Certified {
    let profile = chart.options.over(profile);
    let mut plan = Plan::new(moves, cover, chart.transitions.len());
    let mut trips = plan.trips();
    let mut runs: Vec<Ran> = Vec::new();
    for round in 0..=MOST_ROUNDS {
        runs = trips.iter().map(|trip| ran(chart, profile, period, &plan, trip)).collect();
        let bad: Vec<Leg> = trips.iter().zip(&runs).filter_map(|(trip, ran)| ran.wrong_at.map(|at| trip[at])).collect();
        if bad.is_empty() || round == MOST_ROUNDS {
            break;
        }
        plan.banned.extend(bad);
        trips = plan.trips();
    }
    let (trips, runs): (Vec<_>, Vec<_>) = trips.into_iter().zip(runs).filter(|(_, ran)| ran.wrong_at.is_none()).unzip();
    let mut covered: BTreeSet<Item> = BTreeSet::new();
    let mut tests = Vec::new();
    let home = plan.home();
    for (trip, ran) in trips.iter().zip(runs) {
        let mut covers = Vec::new();
        for item in trip.iter().flat_map(|leg| plan.items(*leg)) {
            if covered.insert(item) {
                covers.push(words(chart, cover, moves, item));
            }
        }
        let last = trip.last().map(|leg| moves.situation_of[plan.at(*leg).to]);
        let text = write_test(chart, &ran.stimuli, &ran.responses, &ran.probes, &ran.looks);
        let comes_home = last.is_some_and(|last| home.contains(&last));
        tests.push(CertifiedTest { text, stimuli: ran.stimuli, covers, comes_home });
    }
    // Situations have other numbers in the other list.
    let possible = Plan::new(free, cover, chart.transitions.len()).coverable_from_any_start();
    let told: BTreeSet<String> = covered.iter().map(|item| words(chart, cover, moves, *item)).collect();
    let open = possible.iter().map(|item| words(chart, cover, free, *item)).filter(|words| !told.contains(words));
    let dead = match cover {
        Cover::Transitions => {
            let dead = (0..chart.transitions.len()).filter(|t| !possible.contains(&(*t, 0)));
            dead.map(|t| words(chart, cover, free, (t, 0))).collect()
        }
        Cover::Situations | Cover::Edges => Vec::new(),
    };
    let rows = tests.iter().map(|test| test.stimuli.len()).sum();
    Certified {
        totals: Totals { rows, ..plan.totals(&trips) },
        covered: covered.len(),
        open: open.collect(),
        dead,
        complete: moves.complete && free.complete
            || cover == Cover::Transitions && covered.len() == chart.transitions.len(),
        tests,
    }
}

/// What an item is called.
fn words(chart: &Chart, cover: Cover, moves: &Moves, (one, other): Item) -> String {
    let situation = |number: usize| {
        let labels: Vec<&str> =
            moves.situations[number].iter().map(|step| chart.steps.raw[*step].label.as_str()).collect();
        format!("{{{}}}", labels.join(", "))
    };
    match cover {
        Cover::Transitions => match &chart.transitions.raw[one].designation {
            Some(designation) => format!("({designation})"),
            None => format!("#{}", one + 1),
        },
        Cover::Situations => situation(one),
        Cover::Edges => format!("{} -> {}", situation(one), situation(other)),
    }
}

/// A trip as the simulator runs it.
struct Ran {
    stimuli: Vec<Stimulus>,
    responses: Vec<Response>,
    /// What is expected beside outputs, and its values.
    probes: Vec<Probe>,
    looks: Vec<Vec<Value>>,
    /// The leg that is not what a controller does, if there is one.
    wrong_at: Option<usize>,
}

fn ran(chart: &Chart, profile: Profile, period: i64, plan: &Plan, trip: &[Leg]) -> Ran {
    let inputs = chart.variables.iter().filter(|variable| variable.kind == VariableKind::Input);
    let mut values: Vec<Value> = inputs.map(|input| input.initial()).collect();
    let mut t_ms = 0;
    let (mut stimuli, mut leg_of): (Vec<Stimulus>, Vec<usize>) = (Vec::new(), Vec::new());
    let mut simulator = Simulator::new(chart, profile);
    let mut shown: Option<Response> = None;
    for (place, leg) in trip.iter().enumerate() {
        let to = plan.at(*leg);
        let next = t_ms + to.after_ms;
        // Where the end of a delay changes outputs alone on the way, there is a row that shows it.
        while let (Some(before), Some(event)) = (&shown, simulator.next_event(t_ms, next)) {
            let waits = Stimulus { t_ms: event, restart: false, inputs: values.clone() };
            let mut other = simulator.clone();
            let response = other.react(&waits);
            if response != *before {
                if response.situation != before.situation {
                    break;
                }
                stimuli.push(waits);
                leg_of.push(place);
                shown = Some(response);
            }
            simulator = other;
            t_ms = event;
        }
        t_ms = next;
        to.given.iter().for_each(|(place, value)| values[*place] = *value);
        let stimulus = Stimulus { t_ms, restart: false, inputs: values.clone() };
        shown = Some(simulator.react(&stimulus));
        stimuli.push(stimulus);
        leg_of.push(place);
    }
    let probes: Vec<Probe> = chart
        .variables
        .iter_enumerated()
        .filter(|(_, variable)| variable.kind == VariableKind::Internal && variable.mode != Mode::Given)
        .map(|(id, _)| Probe::Variable(id))
        .collect();
    let mut watch = Watch { responses: Vec::new(), looks: Vec::new(), unseen: None };
    let mut run = Run::new(chart, profile, Calls::Rows, &probes);
    for stimulus in &stimuli {
        if run.row(stimulus.clone(), &mut watch).is_err() {
            break;
        }
    }
    let Watch { responses, looks, unseen } = watch;
    // The last row of each leg comes to its situation.
    let is_other = |row: usize| {
        let situation: Vec<usize> = responses[row].situation.iter().map(|step| step.index()).collect();
        leg_of.get(row + 1) != Some(&leg_of[row]) && plan.situation(trip[leg_of[row]]) != situation
    };
    let other = (0..responses.len()).find(|row| is_other(*row));
    let moved = match profile.evolution {
        Evolution::Stable => None,
        Evolution::Scan => moves_between(chart, profile, period, &stimuli, &responses),
    };
    let wrong_at = [unseen, other, moved].into_iter().flatten().min().map(|row| leg_of[row]);
    Ran { stimuli, responses, probes, looks, wrong_at }
}

/// The first row before which a chart that is called at each period moves on by itself.
fn moves_between(
    chart: &Chart,
    profile: Profile,
    period: i64,
    stimuli: &[Stimulus],
    responses: &[Response],
) -> Option<usize> {
    let mut simulator = Simulator::new(chart, profile);
    for (place, stimulus) in stimuli.iter().enumerate() {
        if let Some(before) = place.checked_sub(1).map(|before| &stimuli[before]) {
            let mut t_ms = before.t_ms + period;
            // After a call in which nothing moves, only the end of a delay can make something move: that is seen elsewhere.
            while t_ms < stimulus.t_ms {
                let response = simulator.react(&Stimulus { t_ms, restart: false, inputs: before.inputs.clone() });
                if response != responses[place - 1] {
                    return Some(place);
                }
                let event = simulator.next_event(t_ms, stimulus.t_ms);
                t_ms = event.unwrap_or(stimulus.t_ms).max(t_ms + period);
            }
        }
        if simulator.react(stimulus) != responses[place] {
            return Some(place);
        }
    }
    None
}

/// What looks on: it keeps what each row comes to, and the first row before which a delay ends unseen.
struct Watch {
    responses: Vec<Response>,
    looks: Vec<Vec<Value>>,
    unseen: Option<usize>,
}

impl Onlooker for Watch {
    type End = ();

    fn called(&mut self, call: Call) -> Result<(), ()> {
        self.responses.push(call.response.clone());
        self.looks.push(call.looks.to_vec());
        Ok(())
    }

    fn unseen(&mut self, _: i64) -> Result<(), ()> {
        self.unseen = self.unseen.or(Some(self.responses.len()));
        Ok(())
    }

    fn too_many(&mut self) {}
}
