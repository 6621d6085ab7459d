//! Generated instruction lists and ladders, run by the suite's own small controller, so on any machine: they do what the
//! chart means.

use grafc_logic::Options;
use grafc_model::chart::Chart;
use grafc_model::reaction::{Evolution, Profile, Stimulus};
use grafc_testsuite::charts::{cases, charts_folder, check, spell, stimuli, vectors_folder};
use grafc_testsuite::compare::{first_difference, report};
use grafc_testsuite::controller::{instructions, ladder};
use grafc_testsuite::executors::jobs::Job;
use grafc_testsuite::random::profile;
use grafc_testsuite::random::{ChartKind, checked, trace};
use grafc_testsuite::runs::{compile, simulate};
use grafc_testsuite::ways::exact;

#[test]
fn vectors_and_charts_agree_as_instruction_lists() {
    let mut faults = Vec::new();
    for case in [vectors_folder(), charts_folder()].iter().flat_map(|folder| cases(folder)) {
        let chart = check(&case.name, &case.text).unwrap_or_else(|fault| panic!("{fault}"));
        for (way, options) in exact(case.profile) {
            let stimuli = stimuli(&case.name, &case.trace, &chart).unwrap_or_else(|fault| panic!("{fault}"));
            let job = Job { program: compile(&chart, &options).expect("a scan program"), stimuli };
            match instructions::run(&job).map(|responses| spell(&chart, &job.stimuli, &responses)) {
                Ok(actual) if actual == case.expected => {}
                Ok(actual) => faults.push(format!("{}, {way}\nexpected\n{}actual\n{actual}", case.name, case.expected)),
                Err(said) => faults.push(format!("{}, {way}: {said}", case.name)),
            }
        }
    }
    assert!(faults.is_empty(), "{} fail\n{}", faults.len(), faults.join("\n"));
}

#[test]
fn random_charts_agree_as_instruction_lists() {
    for seed in 4000..4030 {
        let drawn = checked(seed, if seed % 2 == 0 { ChartKind::Flat } else { ChartKind::Hierarchical });
        let stimuli = trace(seed, &drawn.chart, 30);
        let ways = exact(profile(seed));
        let program = compile(&drawn.chart, &ways[seed as usize % ways.len()].1).expect("a scan program");
        let job = Job { program, stimuli };
        let actual = instructions::run(&job).unwrap_or_else(|said| panic!("seed {seed}: {said}"));
        let expected = simulate(&drawn.chart, profile(seed), &job.stimuli);
        let report = || report(&drawn.chart, profile(seed), &job.stimuli, &expected, &actual);
        assert_eq!(first_difference(&expected, &actual), None, "seed {seed}\n{}\n{}", drawn.text, report());
    }
}

/// Runs a chart as a ladder of one micro-step a call; whether it could be run.
fn ladder_agrees(name: &str, chart: &Chart, options: &Options, stimuli: Vec<Stimulus>) -> bool {
    let job = Job { program: compile(chart, options).expect("a scan program"), stimuli };
    let Some(actual) = ladder::run(&job).unwrap_or_else(|said| panic!("{name}: {said}")) else { return false };
    let expected = simulate(chart, options.profile, &job.stimuli);
    let report = || report(chart, options.profile, &job.stimuli, &expected, &actual);
    assert_eq!(first_difference(&expected, &actual), None, "{name}\n{}", report());
    true
}

#[test]
fn charts_agree_as_ladders() {
    let mut count = 0;
    let folders = [vectors_folder(), charts_folder()];
    for (turn, case) in folders.iter().flat_map(|folder| cases(folder)).enumerate() {
        let chart = check(&case.name, &case.text).unwrap_or_else(|fault| panic!("{fault}"));
        let ways = exact(Profile { evolution: Evolution::Scan, ..case.profile });
        for (way, options) in [&ways[turn % ways.len()], &ways[(turn + 1) % ways.len()]] {
            let stimuli = stimuli(&case.name, &case.trace, &chart).unwrap_or_else(|fault| panic!("{fault}"));
            count += usize::from(ladder_agrees(&format!("{}, {way}", case.name), &chart, options, stimuli));
        }
    }
    assert!(count >= 200, "only {count} ladders ran");
}

#[test]
fn random_charts_agree_as_ladders() {
    let mut count = 0;
    for seed in 5000..5040 {
        let drawn = checked(seed, if seed % 2 == 0 { ChartKind::Flat } else { ChartKind::Hierarchical });
        let ways = exact(Profile { evolution: Evolution::Scan, ..Profile::default() });
        let (way, options) = &ways[seed as usize % ways.len()];
        let name = format!("seed {seed}, {way}\n{}", drawn.text);
        count += usize::from(ladder_agrees(&name, &drawn.chart, options, trace(seed, &drawn.chart, 30)));
    }
    assert!(count >= 30, "only {count} ladders ran");
}
