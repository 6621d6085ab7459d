//! `grafc sim --batch`: each row of each result is the one that the simulator gives.

use grafc_model::reaction::Evolution;
use grafc_testsuite::binary::grafc;
use grafc_testsuite::charts::{cases, charts_folder, check, field_cases, spell};
use grafc_testsuite::named_trace::NamedTrace;
use grafc_testsuite::random::trace;
use grafc_testsuite::runs::simulate;
use std::fs;

/// More traces than lanes, of lengths that differ, so that lanes rest and a second word begins.
#[test]
fn charts_over_random_traces() {
    let mut rows = 0;
    for (number, case) in cases(&charts_folder()).into_iter().chain(field_cases()).enumerate() {
        let chart = check(&case.name, &case.text).expect("a chart without errors");
        let folder = tempfile::tempdir().expect("a folder");
        let place = |name: &str| folder.path().join(name);
        fs::create_dir(place("traces")).expect("a folder");
        fs::write(place("chart.gct"), &case.text).expect("a chart");
        let count = if number == 0 { 130 } else { 5 };
        let traces: Vec<_> = (0..count).map(|seed| trace(seed, &chart, 3 + (7 * seed as usize) % 40)).collect();
        for (seed, stimuli) in traces.iter().enumerate() {
            let text = NamedTrace::of(&chart, stimuli).to_csv();
            fs::write(place(&format!("traces/{seed}.csv")), text).expect("a trace");
        }
        let mut command = grafc();
        command.current_dir(folder.path()).args(["sim", "chart.gct", "--batch", "traces", "-o", "out", "-q"]);
        if case.profile.evolution == Evolution::Scan && !case.text.contains("evolution scan") {
            command.args(["--evolution", "scan"]);
        }
        if !case.profile.initial_actions {
            command.args(["--initial-actions", "off"]);
        }
        if let Some(bound) = case.profile.bound {
            command.args(["--bound", &bound.to_string()]);
        }
        let output = command.output().expect("the binary runs");
        // That an assertion came out false is said, and the result is there all the same.
        let told = String::from_utf8_lossy(&output.stderr);
        let others = told.lines().filter(|line| line.starts_with("error[") && !line.starts_with("error[E0609]"));
        assert_eq!(others.collect::<Vec<_>>(), Vec::<&str>::new(), "{}", case.name);
        assert!(output.status.code() == Some(i32::from(told.contains("error["))), "{}: {told}", case.name);
        for (seed, stimuli) in traces.iter().enumerate() {
            let result = fs::read_to_string(place(&format!("out/{seed}.csv"))).expect("a result");
            let expected = spell(&chart, stimuli, &simulate(&chart, case.profile, stimuli));
            assert_eq!(result, expected, "{}, trace {seed}", case.name);
            rows += stimuli.len();
        }
    }
    assert!(rows > 2_000, "{rows}");
}
