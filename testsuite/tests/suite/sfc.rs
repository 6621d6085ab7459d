//! Charts as sequential function charts in text: MATIEC runs them to the simulator's results, scan by scan, and what is
//! read back is the chart.
//!
//! What MATIEC is known to do wrongly does not occur: an action of an initial step at its activation, one Boolean of two
//! steps that hand over to each other, and pulses of two steps are no part of what is written; whole seconds of a step's
//! time are passed over.

use crate::by_executor::{of_steps, random_charts_agree, vectors_and_charts_agree, with_delays};
use grafc::{Options as Choices, Product};
use grafc_backends::{Target, sfc};
use grafc_diagnostics::FileId;
use grafc_import::Options;
use grafc_logic::{Encoding, Options as Lowering};
use grafc_model::reaction::{Evolution, Profile};
use grafc_testsuite::charts::check;
use grafc_testsuite::outline::outline;
use grafc_testsuite::random::{ChartKind, checked};

/// The executor.
const SEQUENCES: &str = "matiec:sfc";

#[test]
fn vectors_and_charts_agree_under_matiec() {
    vectors_and_charts_agree(SEQUENCES, 20);
}

#[test]
fn plain_charts_agree_under_matiec() {
    random_charts_agree(SEQUENCES, 0..200, ChartKind::Plain, |text| text, 30);
}

/// Edges and delays of inputs and of steps are found before the chart, in another block.
#[test]
fn what_is_found_before_agrees_under_matiec() {
    random_charts_agree(SEQUENCES, 200..350, ChartKind::Plain, with_delays, 12);
    random_charts_agree(SEQUENCES, 500..700, ChartKind::Plain, of_steps, 15);
}

/// Qualifiers with times, what is stored on activation, on deactivation and in each scan, conditions that read steps.
#[test]
fn qualifiers_agree_under_matiec() {
    random_charts_agree(SEQUENCES, 900..1200, ChartKind::Plain, qualified, 36);
}

/// Enclosures, children, pulse orders and forcing orders, as networks of their own.
#[test]
fn commanded_grafcets_agree_under_matiec() {
    random_charts_agree(SEQUENCES, 2000..2400, ChartKind::Ordered, |text| text, 250);
}

/// A plain chart without edges, in which steps do all that has a qualifier.
fn qualified(text: String) -> String {
    let mut turn = 0_usize;
    let plain = text.replace('↑', "").replace("output n : int", "output n, m, k : int\noutput h : bool\nvar g : bool");
    let lines = plain.lines().map(|line| {
        turn += 1;
        let Some((head, actions)) = line.split_once('{').filter(|_| line.contains("step ")) else {
            return match turn % 5 {
                _ if !line.contains("transition") => line.to_owned(),
                0 => line.replace(": a", ": a and not X101"),
                1 => line.replace(": b", ": b or X101"),
                2 => line.replace(": not c", ": (not c or g)"),
                _ => line.to_owned(),
            };
        };
        let step = head.trim().rsplit(' ').next().unwrap_or_default();
        let own = format!("T{step}");
        let actions = match turn % 9 {
            0 => actions.replace(" if a", &format!(" if [{own} >= 255ms]")),
            1 => actions.replace(" if b", &format!(" if [{own} < 155ms]")),
            2 => actions.replace("n := n + 1 on activation", "n := n + 1 on activation h := true on activation"),
            3 => actions.replace("n := n + 1 on activation", "m := m + 1 each scan if a  h := false on activation"),
            4 => actions.replace("n := n + 1 on activation", "k := k + 2 on deactivation g := true on activation"),
            5 => actions.replace(
                "n := n + 1 on activation",
                "k := 0 each scan if [k > 9] k := k + 3 each scan if not [k > 9] and c",
            ),
            6 => actions.replace(
                "n := n + 1 on activation",
                &format!("n := n + 5 each scan if not X{step} and b g := false on activation"),
            ),
            7 => actions.replace(" if c", &format!(" if not [{own} >= 355ms]")),
            _ => actions.to_owned(),
        };
        format!("{head}{{{actions}")
    });
    let text = lines.collect::<Vec<_>>().join("\n");
    // What nothing sets is an input for who reads it back.
    if text.contains("g := ") { text } else { text.replace("(not c or g)", "not c") }
}

/// A network begins with an initial step (IEC 61131-3, 2.6.2), wherever the chart has it.
#[test]
fn a_network_begins_with_an_initial_step() {
    let text = written("input a, b : bool\nstep 2\ninitial step 1\ntransition 1 -> 2 : a\ntransition 2 -> 1 : b\n");
    let text = text.expect("a text");
    let steps: Vec<&str> = text.lines().map(str::trim).filter(|line| line.contains("STEP X")).collect();
    assert_eq!(steps, ["INITIAL_STEP X1 : END_STEP", "STEP X2 : END_STEP"], "{text}");
}

/// The vector s3 of R15, by hand: what orders do is said by transitions of the child.
#[test]
fn orders_are_transitions_of_the_child() {
    let text = "input m, n, q, a : bool\noutput c : int\n\
        grafcet MAIN {\n initial step 0\n step 1 { start P on activation }\n step 2 { freeze P on activation }\n\
        step 3 { resume P on activation }\n transition 0 -> 1 : m\n transition 1 -> 2 : n\n transition 2 -> 3 : q\n}\n\
        child grafcet P of MAIN {\n initial step 10\n step 11 { c := c + 1 on activation }\n transition 10 -> 11 : a\n}\n";
    let text = made(text).expect("a text");
    assert!(text.contains("\nfreeze_P := drawn.at_1 AND n;\n"), "{text}");
    let transitions: Vec<&str> = text.lines().map(str::trim).filter(|line| line.starts_with("TRANSITION")).collect();
    let expected = [
        "TRANSITION FROM X0 TO X1 := m; END_TRANSITION",
        "TRANSITION FROM X1 TO X2 := n; END_TRANSITION",
        "TRANSITION FROM X2 TO X3 := q; END_TRANSITION",
        // Nothing clears beside the order, and what would clear is kept behind its transition (R15.5).
        "TRANSITION FROM X10 TO X11 := a AND NOT freeze_P; END_TRANSITION",
        "TRANSITION FROM X10 TO kept_11 := a AND freeze_P; END_TRANSITION",
        "TRANSITION FROM X10 TO kept_10 := freeze_P AND NOT a; END_TRANSITION",
        "TRANSITION FROM kept_10 TO X10 := X2.X AND q; END_TRANSITION",
        "TRANSITION FROM X11 TO kept_11 := freeze_P; END_TRANSITION",
        "TRANSITION FROM kept_11 TO X11 := X2.X AND q; END_TRANSITION",
        "TRANSITION FROM rest_P TO X10 := X0.X AND m; END_TRANSITION",
    ];
    assert_eq!(transitions, expected, "{text}");
}

/// The chart as text, if it can be a sequential function chart and is one block.
fn written(text: &str) -> Option<String> {
    made(text).filter(|text| text.matches("FUNCTION_BLOCK ").count() == 1)
}

/// The chart as text, if it can be a sequential function chart.
fn made(text: &str) -> Option<String> {
    let profile = Profile { evolution: Evolution::Scan, ..Profile::default() };
    let product = Product::Code(Target::Sfc(sfc::Options::default()));
    let options = Choices::new(Lowering { profile, encoding: Encoding::default(), simplify: true }, product);
    let (made, _) = grafc::compile(FileId::default(), text, "random", &options);
    made.map(|made| made.text)
}

/// A text that was written, read back.
fn read(text: &str) -> String {
    let (chart, diagnostics) = grafc_import::import(FileId::default(), text, &Options::default());
    let losses: Vec<_> = diagnostics.iter().filter(|said| said.code == grafc_diagnostics::Code::W0703).collect();
    assert_eq!(losses, Vec::<&grafc_diagnostics::Diagnostic>::new(), "{text}");
    chart.unwrap_or_else(|| panic!("{diagnostics:?}\n{text}"))
}

/// What is written and read back is the chart: its steps, transitions, conditions and actions, and what it does. Edges and
/// delays are found outside of the chart, so they are left out here, and so is one output of several steps that do not
/// exclude each other.
#[test]
fn what_is_read_back_is_the_chart() {
    let mut ran = 0;
    for seed in 0..900 {
        let text = alone(qualified(checked(seed, ChartKind::Plain).text)).replacen('\n', " evolution scan\n", 1);
        let Some(exported) = written(&text) else { continue };
        ran += 1;
        let chart = check("random", &text).unwrap_or_else(|fault| panic!("{fault}\n{text}"));
        let imported = read(&exported);
        let back = check("read back", &imported).unwrap_or_else(|fault| panic!("{fault}\n{imported}"));
        assert_eq!(outline(&back), outline(&chart), "{seed}:\n{text}\n{exported}\n{imported}");
        let again = written(&imported).unwrap_or_else(|| panic!("{imported}"));
        assert_eq!(read(&again), imported, "{exported}\n{again}");
    }
    assert!(ran >= 300, "only {ran} ran");
}

/// A plain chart in which each step has an output of its own.
fn alone(text: String) -> String {
    let mut outputs = Vec::new();
    let lines = text.lines().map(|line| {
        let Some((head, actions)) = line.split_once("{ w").filter(|_| line.contains("step ")) else {
            return line.to_owned();
        };
        let step = head.trim().rsplit(' ').next().unwrap_or_default();
        outputs.push(format!("w{step}"));
        format!("{head}{{ w{step}{}", &actions[1..])
    });
    let lines: Vec<String> = lines.collect();
    let text = lines.join("\n");
    let own = if outputs.is_empty() { String::new() } else { format!("output {} : bool\n", outputs.join(", ")) };
    text.replacen("output w0, w1, w2, w3 : bool\n", &own, 1)
}

/// The files of the suite, as charts and back: what comes out is what was read the first time.
#[test]
fn files_read_written_and_read_again_are_the_same() {
    let folder = grafc_testsuite::binary::root().join("testsuite/imports/sfc");
    let mut ran = Vec::new();
    for name in ["sorting.txt", "qualifiers.txt", "filling.xml", "crane.xml"] {
        let text = std::fs::read_to_string(folder.join(name)).expect("a file of the suite");
        let (first, diagnostics) = grafc_import::import(FileId::default(), &text, &Options::default());
        let first = first.unwrap_or_else(|| panic!("{name}: {diagnostics:?}"));
        let Some(exported) = written(&first) else { continue };
        ran.push(name);
        let (one, two) = (check(name, &first).expect("a chart"), check(name, &read(&exported)).expect("a chart"));
        assert_eq!(outline(&two), outline(&one), "{name}:\n{first}\n{exported}");
    }
    assert_eq!(ran, ["sorting.txt", "filling.xml"], "of these");
}
