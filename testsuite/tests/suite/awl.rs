//! Generated STL in awlsim: it does what the chart means.
//!
//! Needs a Python with awlsim, `python3` or what `AWLSIM_PYTHON` names; without it each test says so and does nothing.

use grafc_backends::awl;
use grafc_logic::{Encoding, Options};
use grafc_model::reaction::{Evolution, Profile};
use grafc_testsuite::agreement::{Agreement, AsEvaluated, triggers_in_all_ways};
use grafc_testsuite::charts::{Case, cases, charts_folder, check, stimuli, vectors_folder};
use grafc_testsuite::compare::{first_difference, report};
use grafc_testsuite::executors::awlsim::{Tools, beyond, play_cycles, run};
use grafc_testsuite::executors::jobs::Job;
use grafc_testsuite::random::{ChartKind, checked, low_bound, profile, trace};
use grafc_testsuite::runs::{compile, simulate};

/// The share of awlsim.
const TURN: usize = 2;

/// The encodings that are exact, with formulas shortened.
fn encodings() -> impl Iterator<Item = Encoding> {
    Encoding::ALL.into_iter().filter(|encoding| !encoding.overlaps())
}

/// Runs all cases in all encodings that must agree and compares them with what is expected of them; those of them that S7-300 and
/// S7-400 can hold are at least so many.
fn agree(cases: &[Case], least: usize) {
    let Some(tools) = Tools::find_or_skip() else { return };
    let mut agreement = Agreement::default();
    for (case, encoding) in cases.iter().flat_map(|case| case.encodings().map(move |encoding| (case, encoding))) {
        let options = Options { profile: case.profile, encoding, simplify: true };
        agreement.case(case, encoding.name(), |chart| compile(chart, &options));
    }
    agreement.retain(|job| beyond(job).is_none());
    let count = agreement.count();
    agreement.hold(TURN, usize::MAX, |jobs| run(&tools, jobs));
    assert!(count >= least, "only {count} were run");
}

#[test]
fn vectors_agree() {
    let cases = cases(&vectors_folder());
    agree(&cases, 3 * cases.len() * 9 / 10);
}

#[test]
fn charts_agree() {
    let cases = cases(&charts_folder());
    agree(&cases, 3 * cases.len());
}

/// The r- and s-trigger too are written as they are evaluated, in one micro-step a call as well.
#[test]
fn overlapping_encodings_are_written_as_they_are() {
    let Some(tools) = Tools::find_or_skip() else { return };
    AsEvaluated::charts(triggers_in_all_ways, compile).hold(|jobs| run(&tools, jobs));
}

/// Charts drawn from seeds, with and without a hierarchy, compared with the simulator call by call.
#[test]
fn random_charts_agree() {
    const COUNT: usize = 60;
    let Some(tools) = Tools::find_or_skip() else { return };
    let mut agreement = Agreement::default();
    for seed in 3000.. {
        if agreement.count() == COUNT {
            break;
        }
        let drawn = checked(seed, if seed % 2 == 0 { ChartKind::Flat } else { ChartKind::Hierarchical });
        let encoding = encodings().nth(seed as usize % 3).unwrap_or_default();
        let options = Options { profile: low_bound(profile(seed)), encoding, simplify: seed % 5 > 0 };
        let program = compile(&drawn.chart, &options).unwrap_or_else(|e| panic!("seed {seed}: {e}\n{}", drawn.text));
        let stimuli = trace(seed, &drawn.chart, 25);
        let job = Job { program, stimuli };
        if beyond(&job).is_none() {
            agreement.drawn(drawn, low_bound(profile(seed)), job);
        }
    }
    agreement.hold(TURN, usize::MAX, |jobs| run(&tools, jobs));
}

/// Arithmetic and comparisons at the ends of the types, against the simulator.
#[test]
fn numbers_agree_at_the_ends_of_their_types() {
    let Some(tools) = Tools::find_or_skip() else { return };
    let types: [(&str, &[&str]); 5] = [
        ("int", &["-32768", "-7", "-1", "0", "1", "2", "181", "182", "32767"]),
        ("uint", &["0", "1", "2", "7", "255", "256", "32767", "32768", "65535"]),
        ("dint", &["-2147483648", "-65537", "-7", "-1", "0", "1", "2", "46341", "2147483647"]),
        ("udint", &["0", "1", "2", "7", "65537", "2147483647", "2147483648", "4294967294", "4294967295"]),
        ("real", &["-16777216", "-2.5", "-0.1", "0", "0.1", "3", "1.0e10", "-1.0e10", "1.0e-10"]),
    ];
    let mut jobs = Vec::new();
    let mut charts = Vec::new();
    let profile = Profile { evolution: Evolution::Scan, ..Profile::default() };
    for (ty, values) in types {
        let whole = ty != "real";
        let mut operations = vec!["p + q", "p - q", "p * q", "p / q", "p / 7", "p * 3"];
        operations.extend(["-p"].iter().filter(|_| !ty.starts_with('u')));
        operations.extend(["p mod q", "p mod 7"].iter().filter(|_| whole));
        operations.extend(["p / 3000000000", "p mod 3000000000"].iter().filter(|_| ty == "udint"));
        let comparisons = ["p = q", "p <> q", "p < q", "p <= q", "p > q", "p >= q", "p < 7", "not (p >= q)"];
        let mut text = format!("input p, q : {ty}\ninput w : time\ninput n : int\noutput w1, w2, w3 : time\n");
        let mut actions =
            "  w1 := w * n on activation\n  w2 := w / n on activation\n  w3 := w - w * 2 on activation\n".to_string();
        for (place, operation) in operations.iter().enumerate() {
            text += &format!("output r{place} : {ty}\n");
            actions += &format!("  r{place} := {operation} on activation\n");
        }
        for (place, comparison) in comparisons.iter().enumerate() {
            text += &format!("output c{place} : bool\n");
            actions += &format!("  c{place} if [{comparison}]\n");
        }
        text += &format!("initial step s1 {{\n{actions}}}\nstep s2 {{\n{actions}}}\n");
        text += "transition s1 -> s2 : true\ntransition s2 -> s1 : true\n";
        let chart = check(ty, &text).unwrap_or_else(|said| panic!("{said}\n{text}"));
        let mut rows = "t_ms,p,q,w,n\n".to_string();
        for (row, (p, q)) in values.iter().flat_map(|p| values.iter().map(move |q| (p, q))).enumerate() {
            rows += &format!("{},{p},{q},{},{}\n", row * 10, (row as i64 - 40) * 1_000_003, row as i64 % 17 - 8);
        }
        let stimuli = stimuli(ty, &rows, &chart).unwrap_or_else(|said| panic!("{said}\n{rows}"));
        for encoding in encodings() {
            let program = compile(&chart, &Options { profile, encoding, simplify: true }).expect("a scan program");
            jobs.push(Job { program, stimuli: stimuli.clone() });
            charts.push(chart.clone());
        }
    }
    for ((chart, job), actual) in charts.iter().zip(&jobs).zip(run(&tools, &jobs)) {
        assert_eq!(beyond(job), None, "{}", chart.name);
        let expected = simulate(chart, profile, &job.stimuli);
        let actual = actual.unwrap_or_else(|said| panic!("{said}"));
        if first_difference(&expected, &actual).is_some() {
            panic!("{}", report(chart, profile, &job.stimuli, &expected, &actual));
        }
    }
}

/// `OB 1` reads inputs and writes outputs at their addresses, and the block with its number.
#[test]
fn the_organization_block_wires_addresses() {
    let Some(tools) = Tools::find_or_skip() else { return };
    let chart = check(
        "wired",
        "input go : bool at %IX1.3\ninput n : int at %IW2\noutput run : bool at %QX0.1\noutput twice : dint at %QD4\n\
         initial step 1\nstep 2 {\n run\n twice := n + n on activation\n}\ntransition 1 -> 2 : go\ntransition 2 -> 1 : not go\n",
    )
    .expect("a chart without errors");
    let program = compile(&chart, &Options::default()).expect("a scan program");
    let options = awl::Options { organization_block: true, number: 12, ..awl::Options::default() };
    let text = awl::emit(&program, &options).expect("a source");
    assert!(text.contains("FUNCTION_BLOCK FB 12\n") && text.contains("CALL  FB 12, DB 12 (\n"), "{text}");
    // Bytes 0 to 3 of the inputs: nothing; -7 alone; and with `go`, bit 3 of byte 1; then nothing again.
    let inputs = [[0, 0, 0, 0], [0, 0, 0xFF, 0xF9], [0, 8, 0xFF, 0xF9], [0, 0, 0, 0]];
    let outputs = play_cycles(&tools, &text, &inputs.map(Vec::from), 8).expect("a run");
    // `run` is bit 1 of byte 0, `twice` is the four bytes from 4 on: -14.
    let on = vec![2, 0, 0, 0, 0xFF, 0xFF, 0xFF, 0xF2];
    let off = vec![0, 0, 0, 0, 0xFF, 0xFF, 0xFF, 0xF2];
    assert_eq!(outputs, [vec![0; 8], vec![0; 8], on, off]);
}

/// `RESTART` puts the chart back into its initial situation, and a delay starts again.
#[test]
fn a_restart_begins_anew() {
    let Some(tools) = Tools::find_or_skip() else { return };
    // RESTART is an input of the block, so a chart cannot have a variable of that name without another being found.
    let text = "input a : bool\noutput n, m : int\ninitial step 1 { n := n + 1 on activation }\nstep 2 { m := m + 1 on activation }\n\
                step 3\ntransition 1 -> 2 : a and 1s/X1\ntransition 2 -> 3 : 500ms/X2\n";
    let chart = check("again", text).expect("a chart without errors");
    for encoding in encodings() {
        let program = compile(&chart, &Options { encoding, ..Options::default() }).expect("a scan program");
        let trace = "t_ms,restart,a\n0,,1\n1000,,1\n1400,,1\n1500,,1\n2000,1,1\n2999,,1\n3000,,1\n";
        let stimuli = stimuli("again", trace, &chart).expect("a trace without errors");
        let job = Job { program, stimuli };
        // At 2000 ms all is as at the start: step 1, one activation counted, a second to wait.
        let rows = run(&tools, &[job]).pop().expect("a result").expect("a run");
        let expected = "again,n,m|1,1,0|2,1,1|2,1,1|3,1,1|1,1,0|1,1,0|2,1,1"
            .split('|')
            .skip(1)
            .map(str::to_string)
            .collect::<Vec<_>>();
        let spelt: Vec<String> = rows
            .iter()
            .map(|response| {
                let step = response.situation.iter().map(|step| chart.steps[*step].label.as_str()).collect::<String>();
                let values: Vec<String> = response.outputs.iter().map(|value| format!("{value:?}")).collect();
                let values: Vec<&str> =
                    values.iter().map(|text| text.trim_start_matches("Int(").trim_end_matches(')')).collect();
                format!("{step},{}", values.join(","))
            })
            .collect();
        assert_eq!(spelt, expected, "{}", encoding.name());
    }
}
