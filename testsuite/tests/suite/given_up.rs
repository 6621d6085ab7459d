//! A chart that is saved after a call that LIVELOCK ended, and goes on: its outputs are those that were published, not those
//! of a situation that was picked by chance.

use grafc_backends::js;
use grafc_backends::rust::{self, Runtime};
use grafc_logic::scan::Observed;
use grafc_logic::{Encoding, Options};
use grafc_model::reaction::{LivelockOutputs, Profile};
use grafc_testsuite::charts::check;
use grafc_testsuite::executors::{js::Tools as Node, rust::Tools as Rustc};
use grafc_testsuite::runs::{compile_observed, compile_saved};
use std::fmt::Write as _;
use std::fs;

const RING: &str = "\
chart Ring
input go, lit : bool
output A, B, C : bool
initial step 1 { A }
step 2 { B }
step 3 { C if lit }
transition 1 -> 2 : go
transition 2 -> 3 : go
transition 3 -> 1 : go
";

/// `go` and `lit` of each call. With four micro-steps a call, the situations are 1, then 2 and 3, both given up, 3 at rest, then
/// 1 and 2, given up, and 2 at rest.
const CALLS: [(bool, bool); 7] =
    [(false, true), (true, true), (true, true), (false, true), (true, true), (true, false), (false, false)];

/// A, B and C after each call. In step 3 at rest `lit` lets C act; a call that is given up shows what the last good one did,
/// or nothing.
const CHOICES: [(LivelockOutputs, [&str; 7]); 2] = [
    (LivelockOutputs::Hold, ["100", "100", "100", "001", "001", "001", "010"]),
    (LivelockOutputs::Off, ["100", "000", "000", "001", "000", "000", "010"]),
];

/// Each choice under each encoding, with what is to come out.
fn ways() -> impl Iterator<Item = (Options, [&'static str; 7])> {
    CHOICES.into_iter().flat_map(|(livelock_outputs, expected)| {
        let profile = Profile { bound: Some(4), livelock_outputs, ..Profile::default() };
        let exact = Encoding::ALL.into_iter().filter(|encoding| !encoding.overlaps());
        exact.map(move |encoding| (Options { profile, encoding, simplify: true }, expected))
    })
}

/// The calls as a list of rows, with brackets of a language.
fn rows(expected: &[&str], [open, close]: [char; 2]) -> String {
    let mut out = String::new();
    for ((go, lit), expected) in CALLS.iter().zip(expected) {
        let _ = writeln!(out, "    {open}{go}, {lit}, \"{expected}\"{close},");
    }
    out
}

/// After each call a chart is restored from what is saved; all of them go on, and do what the one does that never was.
const RUST_MAIN: &str = r#"
fn shown(outputs: &ring::Outputs) -> String {
    [outputs.a, outputs.b, outputs.c].map(|on| if on { '1' } else { '0' }).iter().collect()
}

fn main() {
    use ring::{Inputs, Ring};
    let mut chart = Ring::new();
    let mut others: Vec<Ring> = Vec::new();
    for (row, (go, lit, expected)) in CALLS.into_iter().enumerate() {
        let (inputs, now) = (Inputs { go, lit }, 10 * row as u32);
        assert_eq!(shown(chart.scan(&inputs, now)), expected, "row {row}");
        for (at, other) in others.iter_mut().enumerate() {
            assert_eq!(shown(other.scan(&inputs, now)), expected, "row {row}, restored after row {at}");
            assert!(other.save() == chart.save(), "row {row}, restored after row {at}");
        }
        let other = Ring::restore(&chart.save(), &inputs, now).expect("what was saved");
        assert_eq!(shown(other.outputs()), expected, "restored after row {row}");
        assert!(other.save() == chart.save(), "restored after row {row}");
        // What is published after a call that ended by itself follows `lit`; what was held, or put off, does not.
        let mut dark = Ring::restore(&chart.save(), &Inputs { go, lit: false }, now).expect("what was saved");
        let without = if row == 3 { "000" } else { expected };
        assert_eq!(shown(dark.outputs()), without, "restored after row {row}, dark");
        if row == 3 {
            // And that is held, as it is what has been shown.
            assert_eq!(shown(dark.scan(&Inputs { go: true, lit: true }, now)), "000");
        }
        others.push(other);
    }
}
"#;

#[test]
fn rust_publishes_what_it_published() {
    let Some(tools) = Rustc::find_or_skip() else { return };
    for (options, expected) in ways() {
        let chart = check("ring", RING).expect("a chart without errors");
        let program = compile_saved(&chart, &options).expect("a scan program");
        let form = rust::Options { module: Some("ring".into()), runtime: Runtime::Crate, ..rust::Options::default() };
        let module = rust::emit(&program, &form).expect("a module");
        let calls = format!("const CALLS: [(bool, bool, &str); 7] = [\n{}];\n", rows(&expected, ['(', ')']));
        let folder = tempfile::tempdir().expect("a temporary folder");
        fs::write(folder.path().join("main.rs"), module + &calls + RUST_MAIN).expect("a file in a temporary folder");
        tools.build(folder.path()).unwrap_or_else(|said| panic!("{options:?}: {said}"));
        tools.play(folder.path()).unwrap_or_else(|said| panic!("{options:?}: {said}"));
    }
}

/// The same, also saved after each micro-step; and which actions are seen to act.
const JS_MAIN: &str = r#"
const shown = ({ A, B, C }) => [A, B, C].map(Number).join('');

function again(chart, now) {
    const other = new Ring();
    const saved = JSON.parse(JSON.stringify(chart.save()));
    other.restore(saved, now);
    equal(other.save(), saved);
    return other;
}

function holds(chart, expected, about) {
    equal(shown(chart.outputs), expected, about);
    if (ALL) equal(chart.observed.actions, [0, 1, 2].filter((k) => expected[k] === '1'), about);
}

let chart = new Ring();
const others = [];
CALLS.forEach(([go, lit, expected], row) => {
    const [inputs, now] = [{ go, lit }, 10 * row];
    const before = shown(chart.outputs);
    let parted = again(chart, now);
    while (!parted.microStep(inputs, now).stable) {
        parted = again(parted, now);
        equal(shown(parted.outputs), before, `within row ${row}`);
    }
    chart.scan(inputs, now);
    holds(chart, expected, `row ${row}`);
    holds(parted, expected, `row ${row}, in parts`);
    others.forEach((other, at) => {
        other.scan(inputs, now);
        holds(other, expected, `row ${row}, restored after row ${at}`);
        equal(other.save(), chart.save());
    });
    others.push(again(chart, now));
    holds(others.at(-1), expected, `restored after row ${row}`);
});
"#;

#[test]
fn javascript_publishes_what_it_published() {
    let Some(tools) = Node::find_or_skip() else { return };
    for (options, expected) in ways() {
        for observed in [Observed::Transitions, Observed::All] {
            let chart = check("ring", RING).expect("a chart without errors");
            let program = compile_observed(&chart, &options, observed).expect("a scan program");
            let (module, _) = js::emit(&program, &js::Options::default()).expect("a module");
            let head = format!(
                "import {{ deepStrictEqual as equal }} from 'node:assert';\nimport Ring from './ring.mjs';\n\
                 const ALL = {};\nconst CALLS = [\n{}];\n",
                observed == Observed::All,
                rows(&expected, ['[', ']']),
            );
            let folder = tempfile::tempdir().expect("a temporary folder");
            let write = |name: &str, text: &str| fs::write(folder.path().join(name), text).expect("a temporary file");
            write("ring.mjs", &module);
            write("main.mjs", &(head + JS_MAIN));
            tools.play(folder.path(), "main.mjs").unwrap_or_else(|said| panic!("{options:?}, {observed:?}: {said}"));
        }
    }
}
