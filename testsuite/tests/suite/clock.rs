//! A clock that is put back ends no delay, in code that takes its clock as an argument.

use grafc_logic::{Encoding, Options};
use grafc_model::chart::Chart;
use grafc_model::reaction::{Response, Stimulus};
use grafc_testsuite::charts::{check, spell};
use grafc_testsuite::executors::jobs::Job;
use grafc_testsuite::executors::{awlsim, js, rust};
use grafc_testsuite::runs::compile_saved;

const CHART: &str = "\
chart Clock
output long, due : bool
output seconds : int
initial step 1 { long if [T1 >= 3h] }
step 2 { due }
transition 1 -> 2 : 3h/X1
";

/// Times, and whether step 2 is active. 3 h are 10 800 000 ms. At 999 the clock was put back, so no time has passed, and 1 ms is
/// lost for good: at 2000 the step has lasted 1000 + 0 + 1001 ms, and 10 800 000 ms are over at 10 799 999. An hour back
/// (from 3 600 000 to 0) counts as nothing, too.
const RUNS: [&[(i64, bool)]; 3] = [
    &[(0, false), (1_000, false), (999, false), (2_000, false), (10_799_998, false), (10_799_999, true)],
    &[(0, false), (3_600_000, false), (0, false), (7_199_999, false), (7_200_000, true)],
    // Twelve days in one step are still time that has passed.
    &[(0, false), (1_036_800_000, true)],
];

fn expected(times: &[(i64, bool)]) -> String {
    let row = |(t, is_over): &(i64, bool)| {
        let (due, situation) = if *is_over { (1, 2) } else { (0, 1) };
        format!("{t},0,{due},0,{situation},\n")
    };
    "t_ms,long,due,seconds,situation,flags\n".to_owned() + &times.iter().map(row).collect::<String>()
}

fn agree(run: impl Fn(&[Job]) -> Vec<Result<Vec<Response>, String>>) {
    let chart: Chart = check("clock", CHART).expect("a chart without errors");
    for encoding in [Encoding::SinglePhase, Encoding::Switch] {
        let program = compile_saved(&chart, &Options { encoding, ..Options::default() }).expect("a program");
        for times in RUNS {
            let stimulus = |(t_ms, _): &(i64, bool)| Stimulus { t_ms: *t_ms, restart: false, inputs: Vec::new() };
            let stimuli: Vec<Stimulus> = times.iter().map(stimulus).collect();
            let responses = run(&[Job { program: program.clone(), stimuli: stimuli.clone() }]).remove(0);
            let responses = responses.unwrap_or_else(|fault| panic!("{fault}"));
            assert_eq!(spell(&chart, &stimuli, &responses), expected(times));
        }
    }
}

#[test]
fn rust_counts_a_step_back_as_no_time() {
    if let Some(tools) = rust::Tools::find_or_skip() {
        agree(|jobs| rust::run(&tools, jobs));
    }
}

#[test]
fn javascript_counts_a_step_back_as_no_time() {
    if let Some(tools) = js::Tools::find_or_skip() {
        agree(|jobs| js::run(&tools, jobs));
    }
}

#[test]
fn statement_lists_count_a_step_back_as_no_time() {
    if let Some(tools) = awlsim::Tools::find_or_skip() {
        agree(|jobs| awlsim::run(&tools, jobs));
    }
}
