//! Generated Structured Text and instruction lists, compiled by MATIEC and run: they do what the chart means.
//!
//! Needs `iec2c` and `gcc` on PATH (and MATIEC's library beside `iec2c`, or where MATIEC_LIB says); without them each
//! test says so and does nothing.

use grafc_logic::{Encoding, Options};
use grafc_testsuite::agreement::{Agreement, AsEvaluated, triggers_in_all_ways};
use grafc_testsuite::charts::{Case, cases, charts_folder, check, spell, stimuli, vectors_folder};
use grafc_testsuite::executors::jobs::Job;
use grafc_testsuite::executors::matiec::{Language, Tools, miscalculates, run};
use grafc_testsuite::random::profile;
use grafc_testsuite::random::{ChartKind, checked, trace};
use grafc_testsuite::runs::compile;

/// The share of a language.
fn turn(language: Language) -> usize {
    match language {
        Language::St => 0,
        Language::Il => 1,
    }
}

/// The encodings that are exact, with formulas shortened.
fn encodings() -> impl Iterator<Item = Encoding> {
    Encoding::ALL.into_iter().filter(|encoding| !encoding.overlaps())
}

/// Runs all cases in all encodings that must agree and compares them with what is expected of them.
fn agree(language: Language, cases: &[Case]) {
    let Some(tools) = Tools::find_or_skip() else { return };
    let mut agreement = Agreement::default();
    for (case, encoding) in cases.iter().flat_map(|case| case.encodings().map(move |encoding| (case, encoding))) {
        let options = Options { profile: case.profile, encoding, simplify: true };
        agreement.case(case, encoding.name(), |chart| compile(chart, &options));
    }
    agreement.hold(turn(language), usize::MAX, |jobs| run(&tools, language, jobs));
}

#[test]
fn vectors_agree() {
    agree(Language::St, &cases(&vectors_folder()));
}

#[test]
fn vectors_agree_as_instruction_lists() {
    agree(Language::Il, &cases(&vectors_folder()));
}

#[test]
fn charts_agree() {
    agree(Language::St, &cases(&charts_folder()));
}

#[test]
fn charts_agree_as_instruction_lists() {
    agree(Language::Il, &cases(&charts_folder()));
}

/// The r- and s-trigger too are written as they are evaluated, in one micro-step a call as well.
#[test]
fn overlapping_encodings_are_written_as_they_are() {
    let Some(tools) = Tools::find_or_skip() else { return };
    let evaluated = AsEvaluated::charts(triggers_in_all_ways, compile);
    for language in Language::ALL {
        evaluated.hold(|jobs| run(&tools, language, jobs));
    }
}

/// What is retained stands in lists of its own, which MATIEC takes, and whose values it keeps over a restart.
#[test]
fn retained_values_are_kept() {
    let Some(tools) = Tools::find_or_skip() else { return };
    let text = "input a : bool\nretain var n : int\nvar m : int\nretain output kept : int\noutput lost : int\n\
                initial step 1\n\
                step 2 { n := n + 1 on activation  m := m + 1 on activation\n\
                         kept := n on deactivation  lost := m on deactivation }\n\
                transition 1 -> 2 : a\ntransition 2 -> 1 : not a\n";
    let chart = check("Retained", text).expect("a chart without errors");
    // Twice there and back, a restart, once more: `n` counts on, `m` begins anew.
    let rows = "t_ms,a,restart\n0,0,\n10,1,\n20,0,\n30,1,\n40,0,\n50,0,1\n60,1,\n70,0,\n";
    let stimuli = stimuli("Retained", rows, &chart).expect("a trace without errors");
    for encoding in encodings() {
        let program = compile(&chart, &Options { encoding, ..Options::default() }).expect("a scan program");
        let text = grafc_backends::st::emit(&program, &grafc_backends::st::Options::default())
            .expect("a program for any controller");
        assert!(text.contains("VAR RETAIN\n") && text.contains("VAR_OUTPUT RETAIN\n"), "{text}");
        for language in Language::ALL {
            let jobs = [Job { program: program.clone(), stimuli: stimuli.clone() }];
            let responses = run(&tools, language, &jobs).remove(0).unwrap_or_else(|fault| panic!("{fault}"));
            let expected = "t_ms,kept,lost,situation,flags\n0,0,0,1,\n10,0,0,2,\n20,1,1,1,\n30,1,1,2,\n40,2,2,1,\n\
                            50,2,0,1,\n60,2,0,2,\n70,3,1,1,\n";
            assert_eq!(spell(&chart, &stimuli, &responses), expected, "{} {language:?}", encoding.name());
        }
    }
}

#[test]
fn random_charts_agree() {
    random_charts(Language::St, 1000, 36);
}

#[test]
fn random_charts_agree_as_instruction_lists() {
    random_charts(Language::Il, 2000, 36);
}

/// Charts drawn from seeds that begin at one, compared with the simulator call by call.
fn random_charts(language: Language, first: u64, count: usize) {
    let Some(tools) = Tools::find_or_skip() else { return };
    let mut agreement = Agreement::default();
    for seed in first.. {
        if agreement.count() == count {
            break;
        }
        let drawn = checked(seed, if seed % 2 == 0 { ChartKind::Flat } else { ChartKind::Hierarchical });
        if miscalculates(&drawn.chart) {
            continue;
        }
        let encoding = encodings().nth(seed as usize % 3).unwrap_or_default();
        let options = Options { profile: profile(seed), encoding, simplify: true };
        let program = compile(&drawn.chart, &options).unwrap_or_else(|e| panic!("seed {seed}: {e}\n{}", drawn.text));
        let stimuli = trace(seed, &drawn.chart, 30);
        agreement.drawn(drawn, profile(seed), Job { program, stimuli });
    }
    agreement.hold(turn(language), usize::MAX, |jobs| run(&tools, language, jobs));
}
