//! Generated C, compiled and run: it does what the chart means.
//!
//! Every warning of the compiler is a fault, and so is what is undefined in C. Each chart is also saved and restored on the
//! way, and its clock wraps around.

use grafc_backends::c;
use grafc_logic::Options;
use grafc_model::chart::Chart;
use grafc_testsuite::binary::{grafc, root};
use grafc_testsuite::charts::{Case, cases, charts_folder, check, spell, stimuli, vectors_folder};
use grafc_testsuite::compare::{first_difference, report};
use grafc_testsuite::executors::c::{Tools, run};
use grafc_testsuite::executors::jobs::Job;
use grafc_testsuite::markdown::{blocks, matches, write_files};
use grafc_testsuite::random::{ChartKind, Drawn, checked, profile, trace};
use grafc_testsuite::runs::{compile_saved, simulate};
use grafc_testsuite::ways::exact;
use std::fs;

/// Charts in one program.
const BATCH: usize = 100;

/// Runs all cases, each in so many of the ways that must agree, and compares them with what is expected of them. A compiler
/// takes a while for each source, so the ways take turns.
fn agree(cases: &[Case], ways: usize) {
    let Some(tools) = Tools::find_or_skip() else { return };
    let mut faults = Vec::new();
    let mut jobs = Vec::new();
    let mut charts: Vec<(String, &Case, Chart)> = Vec::new();
    for (turn, case) in cases.iter().enumerate() {
        let chart = check(&case.name, &case.text).expect("a chart without errors");
        let stimuli = stimuli(&case.name, &case.trace, &chart).expect("a trace without errors");
        let all = case.ways();
        let count = all.len();
        for (way, options) in all.into_iter().cycle().skip(turn * ways % count).take(ways.min(count)) {
            let program = compile_saved(&chart, &options).expect("a scan program");
            jobs.push(Job { program, stimuli: stimuli.clone() });
            charts.push((format!("{}, {way}", case.name), case, chart.clone()));
        }
    }
    for (jobs, charts) in jobs.chunks(BATCH).zip(charts.chunks(BATCH)) {
        for (((name, case, chart), job), result) in charts.iter().zip(jobs).zip(run(&tools, jobs)) {
            match result {
                Err(fault) => faults.push(format!("{name}:\n{fault}")),
                Ok(responses) => {
                    let actual = spell(chart, &job.stimuli, &responses);
                    if actual != case.expected {
                        faults.push(format!("{name}:\nexpected\n{}actual\n{actual}", case.expected));
                    }
                }
            }
        }
    }
    assert!(faults.is_empty(), "{} of {} fail\n{}", faults.len(), charts.len(), faults.join("\n"));
}

#[test]
fn vectors_agree() {
    agree(&cases(&vectors_folder()), 1);
}

#[test]
fn charts_agree() {
    agree(&cases(&charts_folder()), 3);
}

#[test]
fn random_charts_agree() {
    let Some(tools) = Tools::find_or_skip() else { return };
    let kinds = [ChartKind::Hierarchical, ChartKind::Flat, ChartKind::Hierarchical, ChartKind::Plain];
    let mut faults = Vec::new();
    let drawn: Vec<Drawn> = (5000..5072).map(|seed| checked(seed, kinds[seed as usize % 4])).collect();
    for drawn in drawn.chunks(BATCH) {
        let job = |drawn: &Drawn| {
            let ways = exact(profile(drawn.seed));
            let (_, options): &(String, Options) = &ways[drawn.seed as usize % ways.len()];
            let program = compile_saved(&drawn.chart, options).unwrap_or_else(|e| panic!("{}: {e}", drawn.seed));
            Job { program, stimuli: trace(drawn.seed, &drawn.chart, 30) }
        };
        let jobs: Vec<Job> = drawn.iter().map(job).collect();
        for ((drawn, job), result) in drawn.iter().zip(&jobs).zip(run(&tools, &jobs)) {
            let expected = simulate(&drawn.chart, profile(drawn.seed), &job.stimuli);
            match result {
                Err(fault) => faults.push(format!("{}: {fault}\n{}", drawn.seed, drawn.text)),
                Ok(actual) if first_difference(&expected, &actual).is_some() => {
                    let said = report(&drawn.chart, profile(drawn.seed), &job.stimuli, &expected, &actual);
                    faults.push(format!("{}: {said}\n{}", drawn.seed, drawn.text));
                }
                Ok(_) => {}
            }
        }
    }
    assert!(faults.is_empty(), "{} fail\n{}", faults.len(), faults.join("\n"));
}

/// What is a keyword, a macro or ours, what is no identifier, and what would end a comment or a string.
const HOSTILE: &str = "\
chart `*/ #error \"no\" /*` \"*/ #error no\"
input `int`, `bool`, `INT16_MAX`, `unix`, `chart`, `put`, `*/`, `a b`, `a_b`, `A_C`, `??/` : bool
output `while` \"*/ no ??/\", `inputs`, `scan`, `none` : bool
var `now_ms`, `value`, `to_int` : int
const `H`, `SAVED_LEN`, `STEP_COUNT` : int := 3
initial step 1 { `while` if [`now_ms` = `H`] }
step `\"` \"back\\slash */\" { `value` := `to_int` + `SAVED_LEN` * `STEP_COUNT` on activation  `inputs` }
step `*/ \"` { `none` `scan` }
transition (`*/`) 1 -> `\"` : `int` and `bool` and 2s/`unix`
transition `\"` -> `*/ \"` : `INT16_MAX` or `chart` or `put` or `*/` or `a b` or `a_b` or `A_C`
transition `*/ \"` -> 1 : not `??/`
";

/// `docs/c.md`: its program does what the page shows.
#[test]
fn the_program_of_the_page_does_what_it_shows() {
    let Some(tools) = Tools::find_or_skip() else { return };
    let page = fs::read_to_string(root().join("docs/c.md")).expect("the page");
    let blocks = blocks(&page);
    let folder = tempfile::tempdir().expect("a temporary folder");
    write_files(&blocks, folder.path());
    let mut programs = 0;
    for block in blocks.iter().filter(|block| block.language == "console") {
        for (command, shown) in block.commands() {
            let words: Vec<&str> = command.split(' ').collect();
            let printed = match words[..] {
                ["grafc", ref arguments @ ..] => {
                    let run = grafc().args(arguments).current_dir(folder.path()).output();
                    assert!(run.expect("grafc").status.success(), "{command}");
                    String::new()
                }
                ["cc", ref arguments @ ..] => {
                    tools.compile(folder.path(), arguments).unwrap_or_else(|said| panic!("{said}"));
                    String::new()
                }
                [program] => {
                    programs += 1;
                    tools.play(folder.path(), program).unwrap_or_else(|said| panic!("{said}"))
                }
                _ => panic!("`{command}`: the test knows no such command"),
            };
            assert!(matches(&shown, &printed), "`{command}` printed\n{printed}\nbut the page shows\n{shown}");
        }
    }
    assert_eq!(programs, 1, "programs that were run");
}

#[test]
fn hostile_names_do_not_break_out() {
    let Some(tools) = Tools::find_or_skip() else { return };
    let chart = check("hostile", HOSTILE).unwrap_or_else(|error| panic!("{error}"));
    for encoding in grafc_logic::Encoding::ALL {
        let Ok(program) = compile_saved(&chart, &Options { encoding, ..Options::default() }) else { continue };
        let options = c::Options { header: vec!["*/ #error".into()], include: Some("chart.h".into()) };
        let (source, header) = c::emit(&program, &options).expect("a source");
        let folder = tempfile::tempdir().expect("a temporary folder");
        fs::write(folder.path().join("chart.c"), &source).expect("a temporary file");
        fs::write(folder.path().join("chart.h"), header.expect("a header")).expect("a temporary file");
        tools.object(folder.path(), "chart.c", &["-O2"]).unwrap_or_else(|said| panic!("{said}\n{source}"));
        // All in one file.
        let (source, header) = c::emit(&program, &c::Options::default()).expect("a source");
        assert!(header.is_none());
        fs::write(folder.path().join("one.c"), &source).expect("a temporary file");
        tools.object(folder.path(), "one.c", &["-O2"]).unwrap_or_else(|said| panic!("{said}\n{source}"));
    }
}
