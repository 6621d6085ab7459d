//! Generated Structured Text, compiled by MATIEC and run: it does what the chart means.
//!
//! Needs `iec2c` and `gcc` on PATH (and MATIEC's library beside `iec2c`, or where MATIEC_LIB says); without them each
//! test says so and does nothing.

use grafc_testsuite::charts::{Case, cases, charts_folder, check, is_flat, spell, stimuli, vectors_folder};
use grafc_testsuite::differential::{compile, first_difference, profile, report, simulate};
use grafc_testsuite::matiec::{Job, Tools, misreckons, run};
use grafc_testsuite::random::{Kind, checked, trace};

/// Runs all flat cases and compares them with what is expected of them.
fn agree(tools: &Tools, cases: &[Case]) {
    let mut faults = Vec::new();
    let mut jobs = Vec::new();
    let mut run_cases = Vec::new();
    for case in cases {
        let prepared = check(&case.name, &case.text).and_then(|chart| {
            let stimuli = stimuli(&case.name, &case.trace, &chart)?;
            Ok((chart, stimuli))
        });
        match prepared {
            Err(fault) => faults.push(format!("{}:\n{fault}", case.name)),
            Ok((chart, stimuli)) if is_flat(&chart) => match compile(&chart, case.profile) {
                Err(fault) => faults.push(format!("{}:\n{fault}", case.name)),
                Ok(program) => {
                    jobs.push(Job { program, stimuli });
                    run_cases.push((case, chart));
                }
            },
            Ok(_) => {}
        }
    }
    assert!(jobs.len() >= 10, "only {} of {} charts are flat", jobs.len(), cases.len());
    for (((case, chart), job), result) in run_cases.iter().zip(&jobs).zip(run(tools, &jobs)) {
        match result {
            Err(fault) => faults.push(format!("{}:\n{fault}", case.name)),
            Ok(responses) => {
                let actual = spell(chart, &job.stimuli, &responses);
                if actual != case.expected {
                    faults.push(format!("{}:\nexpected\n{}actual\n{actual}", case.name, case.expected));
                }
            }
        }
    }
    assert!(faults.is_empty(), "{} of {} fail\n{}", faults.len(), cases.len(), faults.join("\n"));
}

#[test]
fn flat_vectors_agree() {
    let Some(tools) = Tools::find_or_skip() else { return };
    agree(&tools, &cases(&vectors_folder()));
}

#[test]
fn flat_charts_agree() {
    let Some(tools) = Tools::find_or_skip() else { return };
    agree(&tools, &cases(&charts_folder()));
}

#[test]
fn random_charts_agree() {
    let Some(tools) = Tools::find_or_skip() else { return };
    let mut jobs = Vec::new();
    let mut drawn_charts = Vec::new();
    for seed in 1000.. {
        if jobs.len() == 40 {
            break;
        }
        let drawn = checked(seed, Kind::Flat);
        if misreckons(&drawn.chart) {
            continue;
        }
        let program =
            compile(&drawn.chart, profile(seed)).unwrap_or_else(|e| panic!("seed {seed}: {e}\n{}", drawn.text));
        let stimuli = trace(seed, &drawn.chart, 30);
        jobs.push(Job { program, stimuli });
        drawn_charts.push((seed, drawn));
    }
    let mut faults = Vec::new();
    for (((seed, drawn), job), result) in drawn_charts.iter().zip(&jobs).zip(run(&tools, &jobs)) {
        let expected = simulate(&drawn.chart, profile(*seed), &job.stimuli);
        match result {
            Err(fault) => faults.push(format!("seed {seed}: {fault}\n{}", drawn.text)),
            Ok(actual) if first_difference(&expected, &actual).is_some() => {
                let report = report(&drawn.chart, profile(*seed), &job.stimuli, &expected, &actual);
                faults.push(format!("seed {seed}\n{}\n{report}", drawn.text));
            }
            Ok(_) => {}
        }
    }
    assert!(faults.is_empty(), "{} of {} charts fail\n{}", faults.len(), jobs.len(), faults.join("\n"));
}
