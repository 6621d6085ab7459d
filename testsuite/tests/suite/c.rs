//! Generated C, compiled and run: it does what the chart means.
//!
//! Every warning of the compiler is a fault, and so is what is undefined in C. Each chart is also saved and restored on the
//! way, and its clock wraps around.

use grafc_backends::c;
use grafc_logic::Options;
use grafc_testsuite::agreement::Agreement;
use grafc_testsuite::binary::root;
use grafc_testsuite::charts::{Case, cases, charts_folder, check, vectors_folder};
use grafc_testsuite::executors::c::{Checks, Tools, run};
use grafc_testsuite::markdown::play;
use grafc_testsuite::runs::compile_saved;
use std::fs;

/// The share of C.
const TURN: usize = 1;

/// Charts in one program.
const BATCH: usize = 100;

/// Runs all cases, each in so many of the ways that must agree.
fn agree(cases: &[Case], ways: usize, checks: Checks) {
    let Some(tools) = Tools::find_or_skip() else { return };
    let mut agreement = Agreement::default();
    agreement.cases(cases, ways, compile_saved);
    agreement.hold(TURN, BATCH, |jobs| run(&tools, jobs, checks));
}

#[test]
fn vectors_agree() {
    agree(&cases(&vectors_folder()), 1, Checks::Undefined);
}

#[test]
fn charts_agree() {
    agree(&cases(&charts_folder()), 3, Checks::Memory);
}

#[test]
fn random_charts_agree() {
    let Some(tools) = Tools::find_or_skip() else { return };
    let mut agreement = Agreement::default();
    agreement.random(5000..5032, 30);
    agreement.hold(TURN, BATCH, |jobs| run(&tools, jobs, Checks::Memory));
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
    let mut programs = 0;
    play(&root().join("docs/c.md"), |folder, command| {
        let printed = match command.split_once(' ') {
            Some(("cc", arguments)) => {
                let arguments: Vec<&str> = arguments.split(' ').collect();
                tools.compile(folder, &arguments).map(|()| String::new())
            }
            None => {
                programs += 1;
                tools.play(folder, command)
            }
            Some(_) => Err("the test knows no such command".to_owned()),
        };
        Some(printed.unwrap_or_else(|said| panic!("`{command}`: {said}")))
    });
    assert_eq!(programs, 1, "programs that were run");
}

#[test]
fn hostile_names_do_not_break_out() {
    let Some(tools) = Tools::find_or_skip() else { return };
    let chart = check("hostile", HOSTILE).unwrap_or_else(|error| panic!("{error}"));
    for encoding in grafc_logic::Encoding::ALL {
        let Ok(program) = compile_saved(&chart, &Options { encoding, ..Options::default() }) else { continue };
        let header = vec!["*/ #error".into()];
        let options = c::Options { header, include: Some("chart.h".into()), ..c::Options::default() };
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
