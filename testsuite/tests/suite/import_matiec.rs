//! Imported charts do, scan by scan, what MATIEC makes of the original text.
//!
//! Each file in `testsuite/imports/sfc` that is text runs over random scans, once as it is, under MATIEC, and once as the
//! chart that it becomes, in the simulator. None of them has what MATIEC is known to do wrongly: a pulse of an initial step
//! or of two steps, times compared at whole seconds, one Boolean as an action of two steps one after the other.
//!
//! Programs of others are tried where `SFC_PROGRAMS` names a folder of them, as text; where a project lies beside such a
//! text as `.xml`, it is the project that is imported:
//! `cargo test -p grafc-testsuite import_matiec:: -- --ignored --nocapture`.

use grafc_diagnostics::FileId;
use grafc_import::Options;
use grafc_model::chart::{Chart, Type, VariableKind};
use grafc_model::reaction::{Evolution, Profile};
use grafc_testsuite::binary;
use grafc_testsuite::charts::{check, stimuli};
use grafc_testsuite::executors::matiec::{Scan, Tools, play_program};
use grafc_testsuite::runs::simulate;
use std::ops::Range;

/// Scans of a run.
const SCANS: usize = 1_000;

#[test]
fn imports_do_what_matiec_makes_of_the_original() {
    let Some(tools) = Tools::find_or_skip() else { return };
    for (name, seeds) in [("sorting", 4), ("qualifiers", 12)] {
        let path = binary::root().join("testsuite/imports/sfc").join(format!("{name}.txt"));
        let text = std::fs::read_to_string(path).expect("a file of the suite");
        let chart = imported(name, &text, None);
        let changes = compare(&tools, name, (&text, &chart), (0..seeds, 10));
        assert!(changes.iter().all(|changes| *changes > 20), "{name}: {changes:?} changes");
    }
}

/// The chart that a text or a unit of a project becomes.
fn imported(name: &str, text: &str, unit: Option<&str>) -> String {
    let options = Options { unit: unit.map(str::to_owned), ..Options::default() };
    let (chart, diagnostics) = grafc_import::import(FileId::default(), text, &options);
    chart.unwrap_or_else(|| panic!("{name}: {diagnostics:?}"))
}

/// Of each file the units that are charts, alone: what is external or at an address is a variable of theirs.
#[test]
#[ignore = "needs files of others"]
#[allow(clippy::print_stderr, reason = "shown with --nocapture")]
fn programs_of_others() {
    let (Some(tools), Some(folder)) = (Tools::find_or_skip(), std::env::var_os("SFC_PROGRAMS")) else { return };
    let mut files: Vec<_> =
        std::fs::read_dir(folder).expect("a folder").map(|entry| entry.expect("a file").path()).collect();
    files.sort();
    for path in files.into_iter().filter(|path| path.extension().is_none_or(|ending| ending != "xml")) {
        let project = std::fs::read_to_string(path.with_extension("xml")).ok();
        let text = std::fs::read_to_string(&path).expect("text").replace("\r\n", "\n");
        let units = ["PROGRAM", "FUNCTION_BLOCK"].into_iter().flat_map(|kind| {
            text.split(&format!("\nEND_{kind}"))
                .filter_map(|unit| {
                    let alone = &unit[unit.rfind(&format!("{kind} "))?..];
                    alone.contains("INITIAL_STEP").then(|| format!("{alone}\nEND_{kind}\n"))
                })
                .collect::<Vec<_>>()
        });
        for unit in units {
            let name = unit.split_whitespace().nth(1).expect("its name");
            let alone = unit.replace("VAR_EXTERNAL", "VAR");
            let at = |line: &str| match line.split_once(" AT %") {
                Some((declared, address)) => format!("{declared} {}", &address[address.find(':').expect("a type")..]),
                None => line.to_owned(),
            };
            let alone: String = alone.lines().map(|line| at(line) + "\n").collect();
            // What the report tells to come a scan later, here or there, need not agree.
            let options = Options { unit: project.as_ref().map(|_| name.to_owned()), ..Options::default() };
            let from = project.as_deref().unwrap_or(&alone);
            let (_, told) = grafc_import::import(FileId::default(), from, &options);
            let is_told = |what: &str| told.iter().any(|one| one.message.contains(what));
            if is_told("as it was in the scan before") || is_told("in the scan that looks at") {
                eprintln!("{}: {name}: it is told that something comes a scan later", path.display());
                continue;
            }
            let chart = imported(name, from, options.unit.as_deref());
            let changes: usize = compare(&tools, name, (&alone, &chart), (0..10, 130)).iter().sum();
            eprintln!("{}: {name}: 10 runs of {SCANS} scans, {changes} changes of outputs", path.display());
        }
    }
}

/// Runs the original and the chart that it becomes, by these seeds, so many milliseconds from scan to scan; how often outputs
/// changed in each run.
fn compare(tools: &Tools, name: &str, (text, written): (&str, &str), (seeds, period): (Range<u64>, i64)) -> Vec<usize> {
    let chart = check(name, written).unwrap_or_else(|fault| panic!("{fault}"));
    // MATIEC drops a Boolean for a scan where a step hands it over to another: what several steps have is left out.
    let is_of_several = |name: &str| text.matches(&format!(" {name}(N)")).count() > 1;
    let of_kind = |kind: VariableKind| chart.variables.iter().filter(move |variable| variable.kind == kind);
    let inputs: Vec<&str> = of_kind(VariableKind::Input).map(|variable| &*variable.name).collect();
    let outputs: Vec<&str> = of_kind(VariableKind::Output).map(|variable| &*variable.name).collect();
    let outputs: Vec<&str> = outputs.into_iter().filter(|name| !is_of_several(name)).collect();
    // A block takes what is true in its first call for an edge, a chart does not (W0702).
    let begins_at_rest = text.contains("_TRIG");
    let runs: Vec<Vec<Scan>> = seeds.clone().map(|seed| scans(&chart, seed, period, begins_at_rest)).collect();
    let original =
        play_program(tools, text, name, (&inputs, &outputs), &runs).unwrap_or_else(|fault| panic!("{name}: {fault}"));
    let one = |((seed, scans), original): ((u64, &Vec<Scan>), &Vec<Vec<i64>>)| {
        let mut trace = format!("t_ms,{}\n", inputs.join(","));
        for (time, values) in scans {
            let row: Vec<String> = values.iter().map(i64::to_string).collect();
            trace.push_str(&format!("{time},{}\n", row.join(",")));
        }
        let stimuli = stimuli(name, &trace, &chart).unwrap_or_else(|fault| panic!("{fault}"));
        let profile = Profile { evolution: Evolution::Scan, ..Profile::default() };
        let shown = grafc_model::trace::write_trace(&chart, &stimuli, &simulate(&chart, profile, &stimuli));
        let mut lines = shown.lines();
        let header: Vec<&str> = lines.next().expect("a header").split(',').collect();
        let column = |name: &&str| header.iter().position(|column| column == name).expect("a column of each output");
        let columns: Vec<usize> = outputs.iter().map(column).collect();
        let mut changes = 0;
        let mut last = Vec::new();
        for (scan, (line, expected)) in lines.zip(original).enumerate() {
            let cells: Vec<&str> = line.split(',').collect();
            let value = |column: &usize| cells[*column].parse::<i64>().expect("a number");
            let found: Vec<i64> = columns.iter().map(value).collect();
            assert_eq!(
                &found, expected,
                "{name}, seed {seed}, scan {scan} with {inputs:?} = {:?}: {outputs:?} of the import and of the original",
                scans[scan].1
            );
            changes += usize::from(last != found);
            last = found;
        }
        changes
    };
    assert_eq!(original.len(), runs.len(), "{name}: runs");
    seeds.zip(&runs).zip(&original).map(one).collect()
}

/// A run: inputs change now and then, so that steps stay active for a while.
fn scans(chart: &Chart, seed: u64, period: i64, begins_at_rest: bool) -> Vec<Scan> {
    let inputs = || chart.variables.iter().filter(|variable| variable.kind == VariableKind::Input);
    let mut rng = fastrand::Rng::with_seed(seed);
    let mut values = vec![0_i64; inputs().count()];
    let one = |scan: usize| {
        for (value, variable) in values.iter_mut().zip(inputs()) {
            if rng.u8(..8) == 0 && (scan > 0 || !begins_at_rest) {
                *value = if variable.ty == Type::Bool { rng.i64(..2).abs() % 2 } else { rng.i64(0..8) };
            }
        }
        (scan as i64 * period, values.clone())
    };
    (0..SCANS).map(one).collect()
}
