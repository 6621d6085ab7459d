//! Every vector of `vectors/`, run by everything that can run a chart.
//!
//! Each test goes through all vectors and reports every one that fails, with the rows that differ. A further way to
//! run a chart is one more test that hands its function to [`agree`].

use grafc_model::chart::{Chart, GrafcetId, Order, Situation, StepId};
use grafc_model::reaction::{Evolution, Profile, Response, Stimulus};
use grafc_model::simulate::Simulator;
use grafc_testsuite::charts::{self, Case};
use grafc_testsuite::runs;
use std::fmt::Write;

/// Runs a check over all vectors and reports every fault at once. A vector that lacks one of its files fails.
fn each(check: impl Fn(&Case, &Chart, &[Stimulus]) -> Result<(), String>) {
    let cases = charts::cases(&charts::vectors_folder());
    assert!(!cases.is_empty(), "there are no vectors");
    let run = |case: &Case| {
        let chart = charts::check(&case.name, &case.text)?;
        let stimuli = charts::stimuli(&case.name, &case.trace, &chart)?;
        check(case, &chart, &stimuli)
    };
    let fault = |case: &Case| run(case).err().map(|fault| format!("{}\n{fault}", case.name));
    let faults: Vec<String> = cases.iter().filter_map(fault).collect();
    assert!(faults.is_empty(), "{} of {} vectors fail:\n\n{}", faults.len(), cases.len(), faults.join("\n"));
}

/// Whether a way to run charts gives the expected results.
fn agree(run: impl Fn(&Chart, Profile, &[Stimulus]) -> Result<Vec<Response>, String>) {
    each(|case, chart, stimuli| {
        let actual = charts::spell(chart, stimuli, &run(chart, case.profile, stimuli)?);
        if actual == case.expected { Ok(()) } else { Err(difference(&case.expected, &actual)) }
    });
}

/// Both results, row by row.
fn difference(expected: &str, actual: &str) -> String {
    let mut message = String::new();
    let (mut expected, mut actual) = (expected.lines(), actual.lines());
    loop {
        match (expected.next(), actual.next()) {
            (None, None) => return message,
            (Some(expected), Some(actual)) if expected == actual => {
                let _ = writeln!(message, "           {expected}");
            }
            (expected, actual) => {
                let _ = writeln!(message, "  expected {}", expected.unwrap_or("(no row)"));
                let _ = writeln!(message, "  actual   {}", actual.unwrap_or("(no row)"));
            }
        }
    }
}

#[test]
fn the_simulator_agrees() {
    agree(|chart, profile, stimuli| {
        let mut simulator = Simulator::new(chart, profile);
        Ok(stimuli.iter().map(|stimulus| simulator.react(stimulus)).collect())
    });
}

/// In each encoding that must agree, with formulas shortened and as they stand.
#[test]
fn the_scan_programs_agree() {
    each(|case, chart, stimuli| {
        let mut faults = String::new();
        for (way, options) in case.ways() {
            let run = runs::caught(|| runs::evaluate(chart, &options, stimuli));
            match run.map(|run| charts::spell(chart, stimuli, &run)) {
                Ok(actual) if actual == case.expected => {}
                Ok(actual) => faults.push_str(&format!("  {way}\n{}", difference(&case.expected, &actual))),
                Err(fault) => faults.push_str(&format!("  {way}\n{fault}\n")),
            }
        }
        if faults.is_empty() { Ok(()) } else { Err(faults) }
    });
}

/// I3: after a stable reaction the same stimulus once more changes nothing; outputs on arcs of automata are over then (R12).
#[test]
fn a_repeated_stimulus_changes_nothing() {
    each(|case, chart, stimuli| {
        let is_of_arcs = chart.variables.iter().any(|variable| variable.momentary);
        if is_of_arcs || chart.options.over(case.profile).evolution == Evolution::Scan {
            return Ok(());
        }
        let mut simulator = Simulator::new(chart, case.profile);
        for stimulus in stimuli {
            let response = simulator.react(stimulus);
            // A livelock is not a stable reaction, and its flag stays.
            if response.flags.livelock {
                break;
            }
            let mut again = simulator.clone();
            let repeated = again.react(&Stimulus { restart: false, ..stimulus.clone() });
            if repeated != response || again.state() != simulator.state() {
                return Err(format!("  at {} ms: {response:?}, repeated {repeated:?}", stimulus.t_ms));
            }
        }
        Ok(())
    });
}

/// I1: nothing in an enclosure is active while its enclosing step is not.
#[test]
fn an_inactive_enclosing_step_has_an_empty_enclosure() {
    each_situation(|chart, situation| {
        for grafcet in chart.grafcets.iter() {
            let enclosed = grafcet.enclosing_step.is_none_or(|step| situation.contains(&step));
            if !enclosed && grafcet.steps.iter().any(|step| situation.contains(step)) {
                return Err(format!("{} is active without its enclosing step", grafcet.name));
            }
        }
        Ok(())
    });
}

/// I2: a grafcet that is forced to a situation, its enclosing step active, is in that situation.
#[test]
fn a_forced_grafcet_is_in_the_forced_situation() {
    each_situation(|chart, situation| {
        for (id, grafcet) in chart.grafcets.iter_enumerated() {
            let enclosed = grafcet.enclosing_step.is_none_or(|step| situation.contains(&step));
            let Some(order) = in_force(chart, id, situation).filter(|_| enclosed) else { continue };
            let forced: Vec<StepId> = match &order.situation {
                Situation::Steps(steps) => steps.clone(),
                Situation::Initial => grafcet.steps.iter().copied().filter(|&step| chart.steps[step].initial).collect(),
                Situation::Current => continue,
            };
            if grafcet.steps.iter().any(|step| situation.contains(step) != forced.contains(step)) {
                return Err(format!("{} is not in its forced situation", grafcet.name));
            }
        }
        Ok(())
    });
}

/// The order in force on a grafcet: of the highest level, then the first.
fn in_force<'c>(chart: &'c Chart, grafcet: GrafcetId, situation: &[StepId]) -> Option<&'c Order> {
    let on_it = chart.orders.iter().filter(|order| order.grafcet == grafcet && situation.contains(&order.step));
    on_it.min_by_key(|order| chart.grafcets[chart.steps[order.step].grafcet].level)
}

/// Checks every situation that the simulator publishes, in both profiles.
fn each_situation(check: impl Fn(&Chart, &[StepId]) -> Result<(), String>) {
    each(|case, chart, stimuli| {
        for evolution in [Evolution::Stable, Evolution::Scan] {
            let mut simulator = Simulator::new(chart, Profile { evolution, ..case.profile });
            for stimulus in stimuli {
                let response = simulator.react(stimulus);
                check(chart, &response.situation)
                    .map_err(|fault| format!("  {evolution:?}, at {} ms: {fault}", stimulus.t_ms))?;
            }
        }
        Ok(())
    });
}
