//! Charts of AGRAFE: what they become, what is said about it, and that they then run.
//!
//! `testsuite/imports` holds `NAME.grafcet`, the chart `NAME.gct` and the report `NAME.report`, written by hand; those
//! whose name begins with `delays` are imported with that option. AGRAFE's own charts are tested where they are
//! available, see [`xmi::collection`]. A long run of them is `cargo test --release -p grafc-testsuite import:: --
//! --ignored --nocapture`.

use grafc_backends::st;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics, FileId};
use grafc_import::Options;
use grafc_model::chart::Chart;
use grafc_model::reaction::Profile;
use grafc_testsuite::compare::{first_difference, report};
use grafc_testsuite::runs::{caught, compile, evaluate, simulate};
use grafc_testsuite::ways::exact;
use grafc_testsuite::{binary, random, xmi};
use std::time::Instant;

const AS_IT_IS: Options = Options { delays: false, dialect: None, unit: None };

fn import(text: &str, options: Options) -> Result<(String, Diagnostics), Diagnostics> {
    let (chart, diagnostics) = grafc_import::import(FileId::default(), text, &options);
    assert_eq!(chart.is_none(), diagnostics.has_errors(), "a chart exactly if there is no error: {diagnostics:?}");
    chart.map(|chart| (chart, diagnostics.clone())).ok_or(diagnostics)
}

/// Code and place of a message, as a report has it.
fn line(text: &str, message: &Diagnostic) -> String {
    let before = &text[..message.primary.span.start as usize];
    let column = before.rsplit('\n').next().unwrap_or_default().chars().count() + 1;
    format!("{} {}:{column}", message.code.as_str(), before.matches('\n').count() + 1)
}

fn lines(text: &str, diagnostics: &Diagnostics) -> Vec<String> {
    let mut diagnostics = diagnostics.clone();
    diagnostics.sort_by_place();
    diagnostics.iter().map(|message| line(text, message)).collect()
}

/// Errors of an import, where they are.
fn faults(text: &str) -> Vec<String> {
    let diagnostics = import(text, AS_IT_IS).expect_err("it has errors");
    assert!(
        diagnostics.iter().all(|d| d.help.is_some() || d.code.as_str().starts_with('W')),
        "an error without help: {diagnostics:?}"
    );
    lines(text, &diagnostics)
}

fn is_canonical(text: &str) {
    let (tree, diagnostics) = grafc_syntax::parse(FileId::default(), text);
    assert!(diagnostics.is_empty(), "{diagnostics:?}\n{text}");
    assert_eq!(grafc_syntax::format(text, &tree), text);
}

#[test]
fn charts_and_reports_are_as_written_by_hand() {
    let folder = binary::root().join("testsuite/imports");
    let read = |name: String| std::fs::read_to_string(folder.join(name)).expect("a file beside the chart");
    for name in ["structure", "actions", "delays"] {
        let text = read(format!("{name}.grafcet"));
        let options = Options { delays: name.starts_with("delays"), ..AS_IT_IS };
        let (chart, diagnostics) =
            import(&text, options).unwrap_or_else(|diagnostics| panic!("{name}: {diagnostics:?}"));
        assert_eq!(chart, read(format!("{name}.gct")), "{name}");
        assert_eq!(lines(&text, &diagnostics), read(format!("{name}.report")).lines().collect::<Vec<_>>(), "{name}");
        is_canonical(&chart);
        assert!(grafc::check(FileId::new(0), &chart, name).0.is_some(), "{name}");
    }
}

#[test]
fn a_variable_called_like_a_delay_is_offered_one() {
    let text = std::fs::read_to_string(binary::root().join("testsuite/imports/delays.grafcet")).expect("the chart");
    let (chart, diagnostics) = import(&text, AS_IT_IS).expect("a chart");
    assert!(chart.contains("var `2s/X1` : bool") && chart.contains(": `2s/X1`\n"), "{chart}");
    let offers: Vec<_> = diagnostics.iter().filter_map(|d| d.help.as_deref()).collect();
    assert!(offers.iter().any(|offer| offer.contains("--delays") && offer.contains("`2s/X1`")), "{offers:?}");
}

/// A ring of two steps in `G1`, which is grafcet 0, and what is added to it and behind it; the codes and the chart.
fn ring_with(inside: &str, behind: &str) -> (Vec<Code>, String) {
    let arc = |source: &str, target: &str| {
        format!("<arcs source=\"//@partialGrafcets.0/@{source}\" target=\"//@partialGrafcets.0/@{target}\"/>")
    };
    let variables: String = ["a", "V"]
        .map(|name| {
            let kind = if name == "V" { "output" } else { "input" };
            format!(
                "<variableDeclarations name=\"{name}\" variableDeclarationType=\"{kind}\">\
                 <sort xsi:type=\"terms:Bool\"/></variableDeclarations>"
            )
        })
        .concat();
    let text = xmi::chart(&format!(
        "<variableDeclarationContainer>{variables}</variableDeclarationContainer>\
         <partialGrafcets xsi:type=\"grafcet:PartialGrafcet\" name=\"G1\"><steps id=\"1\" initial=\"true\"/><steps id=\"2\"/>\
         <transitions id=\"1\"><term {A}</transitions><transitions id=\"2\"><term {A}</transitions>{}{}{}{}\
         {inside}</partialGrafcets>{behind}",
        arc("steps.0", "transitions.0"),
        arc("transitions.0", "steps.1"),
        arc("steps.1", "transitions.1"),
        arc("transitions.1", "steps.0"),
    ));
    let (chart, diagnostics) = import(&text, AS_IT_IS).unwrap_or_else(|diagnostics| panic!("{diagnostics:?}\n{text}"));
    (diagnostics.iter().map(|message| message.code).collect(), chart)
}

/// The rest of a term that is the input.
const A: &str =
    "xsi:type=\"terms:Variable\" variableDeclaration=\"//@variableDeclarationContainer/@variableDeclarations.0\"/>";

/// An action of step 2, which is set to the output if it is not a forcing order.
fn action(class: &str, attributes: &str, contents: &str) -> String {
    let variable = "<variable variableDeclaration=\"//@variableDeclarationContainer/@variableDeclarations.1\"/>";
    let contents = if class == "ForcingOrder" { contents.to_string() } else { format!("{contents}{variable}") };
    format!(
        "<actionTypes xsi:type=\"grafcet:{class}\" {attributes}>{contents}</actionTypes>\
         <actionLinks step=\"//@partialGrafcets.0/@steps.1\" actionType=\"//@partialGrafcets.0/@actionTypes.0\"/>"
    )
}

#[test]
fn each_change_doubt_and_loss_is_reported() {
    use Code::{W0701 as Changed, W0702 as Doubtful, W0703 as Lost};
    let grafcet =
        |kind: &str, rest: &str| format!("<partialGrafcets xsi:type=\"grafcet:{kind}\" {rest}</partialGrafcets>");
    let forced = grafcet("PartialGrafcet", "name=\"G2\"><steps id=\"9\" initial=\"true\"/>");
    let arc = |source: &str, target: &str| {
        format!("<arcs source=\"//@partialGrafcets.0/@{source}\" target=\"//@partialGrafcets.0/@{target}\"/>")
    };
    let term = format!("<term {A}");
    let value = "<value xsi:type=\"terms:BooleanConstant\" value=\"true\"/>";
    let timed = |kind: &str, times: &str| {
        let attributes = format!("continuousActionType=\"assignationCondition\" timeConditionType=\"{kind}\" {times}");
        action("ContinuousAction", &attributes, &term)
    };
    let force = |rest: &str| action("ForcingOrder", &format!("partialGrafcet=\"//@partialGrafcets.1\" {rest}"), "");
    let steps = "forcedSteps=\"//@partialGrafcets.1/@steps.0\"";
    let third = format!("<transitions id=\"3\"><term {A}</transitions>");
    // What is added inside and behind, what is reported, and a line of the chart.
    let cases: Vec<(String, String, &[Code], &str)> = vec![
        (String::new(), String::new(), &[], "transition (1) 1 -> 2 : a"),
        (arc("steps.0", "transitions.0"), String::new(), &[Changed], "transition (1) 1 -> 2 : a"),
        (arc("steps.1", "transitions.0"), String::new(), &[Doubtful], "transition (1) 1, 2 -> 2 : a"),
        (arc("transitions.0", "transitions.1"), String::new(), &[Lost], "transition (1) 1 -> 2 : a"),
        (third.clone(), String::new(), &[Lost], "transition (2) 2 -> 1 : a"),
        ("<synchronizations/>".into(), String::new(), &[Lost], "transition (2) 2 -> 1 : a"),
        // What an editor leaves behind when the other end, the step or the action has been deleted.
        ("<arcs/>".into(), String::new(), &[Lost], "transition (2) 2 -> 1 : a"),
        (
            "<arcs source=\"//@partialGrafcets.0/@steps.0\"/>".into(),
            String::new(),
            &[Lost],
            "transition (2) 2 -> 1 : a",
        ),
        (
            "<arcs target=\"//@partialGrafcets.0/@transitions.0\"/>".into(),
            String::new(),
            &[Lost],
            "transition (1) 1 -> 2 : a",
        ),
        (
            "<actionLinks step=\"//@partialGrafcets.0/@steps.1\"/>".into(),
            String::new(),
            &[Lost],
            "transition (2) 2 -> 1 : a",
        ),
        (
            action("ContinuousAction", "", "") + "<actionLinks actionType=\"//@partialGrafcets.0/@actionTypes.0\"/>",
            String::new(),
            &[Lost],
            "step 2 { V }",
        ),
        ("<notes text=\"x\"><b/></notes>".into(), String::new(), &[Lost], "transition (2) 2 -> 1 : a"),
        ("<steps id=\"3\" colour=\"red\"/>".into(), String::new(), &[Lost], "step 3"),
        ("<exitStep id=\"3\"/>".into(), String::new(), &[Lost], "transition (2) 2 -> 1 : a"),
        ("some words".into(), String::new(), &[Lost], "step 2"),
        (
            format!("<transitions id=\"3\" timeConditionType=\"timeLimited\" resetTime=\"4\">{term}</transitions>")
                + &arc("steps.0", "transitions.2"),
            String::new(),
            &[Doubtful],
            "transition (3) 1 -> : a/4s",
        ),
        (
            format!("<transitions id=\"3\" delayTime=\"4\">{term}</transitions>") + &arc("steps.0", "transitions.2"),
            String::new(),
            &[Lost],
            "transition (3) 1 -> : a",
        ),
        (
            "<transitions id=\"-3\" timeConditionType=\"timeDelayed\" delayTime=\"4\"/>".to_string()
                + &arc("transitions.2", "steps.0"),
            String::new(),
            &[],
            "transition (`-3`) -> 1 : 4s/(1)",
        ),
        (action("ContinuousAction", "", ""), String::new(), &[], "step 2 { V }"),
        (action("ContinuousAction", "", &term), String::new(), &[Lost], "step 2 { V }"),
        (
            action("ContinuousAction", "continuousActionType=\"assignationCondition\"", ""),
            String::new(),
            &[Doubtful],
            "step 2 { V }",
        ),
        (timed("none", ""), String::new(), &[], "step 2 { V if a }"),
        (timed("timeDependent", "delayTime=\"1\" unit=\"ms\""), String::new(), &[], "step 2 { V if 1ms/a }"),
        (timed("timeDependent", "resetTime=\"2\""), String::new(), &[], "step 2 { V if a/2s }"),
        (timed("timeDelayed", "delayTime=\"1\" resetTime=\"2\""), String::new(), &[Lost], "step 2 { V if 1s/a }"),
        (timed("timeLimited", "resetTime=\"6\""), String::new(), &[Doubtful], "step 2 { V if a and not 6s/a }"),
        (action("StoredAction", "", value), String::new(), &[], "step 2 { V := true on activation }"),
        (
            action("StoredAction", "", &format!("{value}{term}")),
            String::new(),
            &[Lost],
            "step 2 { V := true on activation }",
        ),
        (
            action("StoredAction", "storedActionType=\"event\"", value),
            String::new(),
            &[Doubtful],
            "step 2 { V := true on event 1 }",
        ),
        (
            action("ContinuousAction", "", "")
                + "<actionLinks step=\"//@partialGrafcets.0/@steps.1\" actionType=\"//@partialGrafcets.0/@actionTypes.0\"/>",
            String::new(),
            &[Changed],
            "step 2 { V }",
        ),
        (force("forcingOrderType=\"explicitSituation\""), forced.clone(), &[Doubtful], "step 2 { force G2{} }"),
        (force(steps), forced.clone(), &[Lost], "step 2 { force G2{*} }"),
        (
            "<steps xsi:type=\"grafcet:EnclosingStep\" id=\"3\" partialGrafcets=\"//@partialGrafcets.1\"/>".into(),
            grafcet("PartialGrafcet", "name=\"G2\"><steps id=\"9\" activationLink=\"true\"/>"),
            &[Doubtful],
            "activated step 9",
        ),
        (
            "<steps xsi:type=\"grafcet:EnclosingStep\" id=\"3\"/>".into(),
            grafcet("PartialGrafcet", "name=\"G2\" enclosingStep=\"//@partialGrafcets.0/@steps.2\">"),
            &[Doubtful],
            "grafcet X3/G2 {",
        ),
        (
            "<steps xsi:type=\"grafcet:EnclosingStep\" id=\"3\" partialGrafcets=\"//@partialGrafcets.1\"/>\
             <steps xsi:type=\"grafcet:EnclosingStep\" id=\"4\" partialGrafcets=\"//@partialGrafcets.1\"/>"
                .into(),
            grafcet("PartialGrafcet", "name=\"G2\" enclosingStep=\"//@partialGrafcets.0/@steps.3\">"),
            // Two steps claim it, and the one that does not have it encloses nothing.
            &[Doubtful, Changed],
            "grafcet X4/G2 {",
        ),
        (
            "<macrosteps id=\"3\" expansion=\"//@partialGrafcets.1\"/><macrosteps id=\"3\"/>".into(),
            grafcet("MacrostepExpansion", "name=\"x\"><entryStep id=\"3\"/><exitStep id=\"3\"/>"),
            &[Changed],
            "macro step M3_2",
        ),
        (
            "<macrosteps id=\"3\" expansion=\"//@partialGrafcets.1\"/>\
             <macrosteps id=\"4\" expansion=\"//@partialGrafcets.1\"/>"
                .into(),
            grafcet("MacrostepExpansion", "name=\"x\"><entryStep id=\"3\"/><exitStep id=\"3\"/>"),
            &[Doubtful],
            "expansion M3 {",
        ),
        (String::new(), grafcet("MacrostepExpansion", "name=\"x\">"), &[Doubtful], "expansion M0 {"),
        (String::new(), grafcet("PartialGrafcet", "name=\"1\"><steps id=\"5\"/>"), &[Changed], "grafcet `1_2` {"),
    ];
    for (inside, behind, codes, shown) in cases {
        let (found, chart) = ring_with(&inside, &behind);
        assert_eq!(found, codes, "{inside}{behind}\n{chart}");
        assert!(chart.lines().any(|line| line.trim() == shown), "no line {shown} in\n{chart}");
    }
}

/// Every fault has a place.
#[test]
fn what_is_wrong_is_an_error_at_its_place() {
    // The outermost element stands in line 2, what is given begins in line 3.
    let in_grafcet = |contents: &str| {
        xmi::chart(&format!("<partialGrafcets xsi:type=\"grafcet:PartialGrafcet\">\n{contents}\n</partialGrafcets>\n"))
    };
    assert_eq!(faults("<a/>"), ["E0703 1:1"]);
    let said = import("<TcPlcObject Version=\"1.1.0.1\"/>", AS_IT_IS).expect_err("an error");
    let help: Vec<&str> = said.iter().filter_map(|one| one.help.as_deref()).collect();
    assert!(matches!(help[..], [help] if help.contains("`Export PLCopen XML…`")), "{help:?}");
    assert_eq!(faults(&xmi::chart("<partialGrafcets>")), ["E0701 3:18"]);
    // Three steps from line 9 on, then the first transition: its end tag is cut off.
    let whole = xmi::ring(3);
    let tag = whole.find("</transitions>").expect("a transition");
    let column = whole[..tag].rsplit('\n').next().map_or(0, str::len) + 1;
    assert_eq!(faults(&whole[..tag + 5]), [format!("E0701 12:{column}")]);
    assert_eq!(faults(&in_grafcet(" <steps id=\"one\"/>")), ["E0705 4:2"]);
    assert_eq!(faults(&in_grafcet("<steps id=\"2147483648\"/>")), ["E0705 4:1"]);
    assert_eq!(faults(&in_grafcet("<steps initial=\"yes\"/>")), ["E0705 4:1"]);
    assert_eq!(faults(&in_grafcet("<steps xsi:type=\"grafcet:Stairs\"/>")), ["E0705 4:1"]);
    let arc = "<arcs source=\"//@partialGrafcets.0\" target=\"//@partialGrafcets.0/@steps.7\"/>";
    assert_eq!(faults(&in_grafcet(arc)), ["E0704 4:1", "E0704 4:1"]);
    assert_eq!(faults(&in_grafcet("<actionTypes xsi:type=\"grafcet:StoredAction\"/>")), ["E0705 4:1"]);
    let term = |term: &str| in_grafcet(&format!("<transitions>\n{term}\n</transitions>"));
    assert_eq!(faults(&term("<term xsi:type=\"terms:And\"/>")), ["E0705 5:1"]);
    assert_eq!(faults(&term("<term xsi:type=\"terms:IntegerConstant\" value=\"1\"/>")), ["E0705 5:1"]);
    assert_eq!(faults(&term("<term xsi:type=\"terms:Variable\" variableDeclaration=\"//@x.0\"/>")), ["E0704 5:1"]);
    assert_eq!(faults(&term("<term xsi:type=\"terms:Perhaps\"/>")), ["E0705 5:1"]);
    // All of a file in one run.
    assert_eq!(faults(&in_grafcet("<steps id=\"a\"/>\n<arcs/>\n<steps id=\"b\"/>")).len(), 3);
}

/// Files that are made to break readers.
#[test]
fn hostile_files_are_refused_soon() {
    let bomb = (1..30).fold("<!ENTITY e0 'ha'>".to_string(), |text, n| {
        text + &format!("<!ENTITY e{n} '&e{p};&e{p};&e{p};&e{p};'>", p = n - 1)
    });
    assert_eq!(faults(&format!("<!DOCTYPE x [{bomb}]>\n<x>&e29;</x>")), ["E0702 1:1"]);
    assert_eq!(faults(&xmi::chart("<partialGrafcets name=\"&e0;\"/>")), ["E0701 3:1"]);
    let deep = "<partialGrafcets>".repeat(1_000_000);
    assert_eq!(faults(&xmi::chart(&deep)), [format!("E0702 3:{}", 999 * 17 + 1)]);
    // What is short by reference and long when written out: 3,000 transitions, each behind the same 3,000 steps.
    let mut net = String::from("<synchronizations/>\n");
    for place in 0..3_000 {
        let grafcet = "//@partialGrafcets.0";
        net.push_str(&format!(
            "<steps id=\"{place}\"/><transitions/>\
             <arcs source=\"{grafcet}/@steps.{place}\" target=\"{grafcet}/@synchronizations.0\"/>\
             <arcs source=\"{grafcet}/@synchronizations.0\" target=\"{grafcet}/@transitions.{place}\"/>\n"
        ));
    }
    let net = xmi::chart(&format!("<partialGrafcets>{net}</partialGrafcets>"));
    assert!(faults(&net).contains(&"E0702 2:1".to_string()));
}

/// Damaged files: no panic, and either errors with places in the text or a text that is a chart.
#[test]
fn damaged_files_give_an_error_or_a_chart() {
    damage(3_000);
}

#[test]
#[ignore = "takes minutes"]
fn many_damaged_files_give_an_error_or_a_chart() {
    damage(100_000);
}

fn damage(runs: u64) {
    let folder = binary::root().join("testsuite/imports");
    let read = |name: &str| std::fs::read_to_string(folder.join(name)).expect("a chart");
    let mut texts = vec![read("structure.grafcet"), read("actions.grafcet"), read("delays.grafcet"), xmi::ring(4)];
    texts.extend(
        xmi::collection_or_skip().into_iter().flatten().map(|(_, text)| text).filter(|text| text.len() < 20_000),
    );
    let (mut charts, mut errors, mut checked) = (0, 0, 0);
    for seed in 0..runs {
        let mut rng = fastrand::Rng::with_seed(seed);
        let text = xmi::damaged(&texts[seed as usize % texts.len()], &mut rng);
        let options = Options { delays: rng.bool(), ..AS_IT_IS };
        match caught(|| Ok(import(&text, options))).unwrap_or_else(|fault| panic!("seed {seed}: {fault}\n{text}")) {
            Ok((chart, _)) => {
                charts += 1;
                is_canonical(&chart);
                checked += usize::from(grafc::check(FileId::new(0), &chart, "damaged").0.is_some());
            }
            Err(diagnostics) => {
                errors += 1;
                for message in &diagnostics {
                    assert_ne!(message.code, Code::E0901, "seed {seed}: {message:?}\n{text}");
                    let range = message.primary.span.range();
                    assert!(text.get(range.clone()).is_some(), "seed {seed}: no such place: {range:?}");
                }
            }
        }
    }
    let least = runs as usize / 10;
    assert!(
        charts > least && errors > least && checked > least,
        "{charts} charts, {checked} of them sound, {errors} errors"
    );
}

/// What AGRAFE's own charts give to report, without places.
const REPORTS: [(&str, &[Code]); 16] = [
    ("conflictingActions1", &[]),
    ("conflictingActions2", &[]),
    ("conflictingActions3", &[]),
    ("exclusiveSelectionOfSequences", &[]),
    // A transition-condition that is the constant false.
    ("flawedTransitions1", &[Code::W0702]),
    // The fault is in the values that a variable can have, which nobody sees by reading.
    ("flawedTransitions2", &[]),
    // Two inputs that actions set, a delay as a variable, an enclosing step without enclosure.
    ("plant", &[Code::W0702, Code::W0702, Code::W0702, Code::W0701]),
    // Two outputs that nothing sets and conditions read; two resets of what continuous actions set.
    ("productionSystem_v1", &[Code::W0702, Code::W0702, Code::W0703, Code::W0703]),
    // An internal variable that nothing sets.
    ("sastisfiabilityOfConditionsExample", &[Code::W0702]),
    // A grafcet without a name.
    ("stepReachability1", &[Code::W0701]),
    ("stepReachability2", &[Code::W0701]),
    ("stepReachability3", &[Code::W0701]),
    // And a synchronisation of steps with a step.
    ("stepReachability4", &[Code::W0701, Code::W0703]),
    ("stepReachability5", &[]),
    ("stepReachability6", &[]),
    ("", &[]),
];

#[test]
fn the_charts_of_agrafe_are_imported_and_run() {
    run_collection(150);
}

#[test]
#[ignore = "takes minutes"]
fn the_charts_of_agrafe_run_for_long() {
    run_collection(10_000);
}

fn run_collection(rows: usize) {
    let Some(collection) = xmi::collection_or_skip() else { return };
    assert!(collection.len() >= 15, "only {} charts", collection.len());
    for (name, text) in &collection {
        let (chart, diagnostics) =
            import(text, AS_IT_IS).unwrap_or_else(|diagnostics| panic!("{name}: {diagnostics:?}"));
        let mut diagnostics = diagnostics;
        diagnostics.sort_by_place();
        let codes: Vec<Code> = diagnostics.iter().map(|d| d.code).collect();
        if let Some((_, expected)) = REPORTS.iter().find(|(known, _)| known == name) {
            assert_eq!(codes, *expected, "{name}: {diagnostics:?}");
        }
        is_canonical(&chart);
        runs(name, &chart, rows);
        let (with_delays, _) = import(text, Options { delays: true, ..AS_IT_IS }).expect("the same with delays");
        if with_delays != chart {
            runs(name, &with_delays, rows);
        }
    }
}

/// The chart is sound, and each exact encoding is written as Structured Text and does what the simulator does.
fn runs(name: &str, text: &str, rows: usize) {
    let (chart, diagnostics) = grafc::check(FileId::new(0), text, name);
    let chart: Chart = chart.unwrap_or_else(|| panic!("{name}: {diagnostics:?}"));
    let profile = Profile::default();
    let stimuli = random::trace(7, &chart, rows);
    let expected = simulate(&chart, profile, &stimuli);
    for (way, options) in exact(profile) {
        let program = compile(&chart, &options).unwrap_or_else(|fault| panic!("{name}, {way}: {fault}"));
        let code = st::emit(&program, &st::Options::default());
        assert!(code.is_ok_and(|code| code.contains("END_FUNCTION_BLOCK")), "{name}, {way}");
        let actual = evaluate(&chart, &options, &stimuli).unwrap_or_else(|fault| panic!("{name}, {way}: {fault}"));
        if first_difference(&expected, &actual).is_some() {
            panic!("{name}, {way}\n{}", report(&chart, profile, &stimuli, &expected, &actual));
        }
    }
}

/// Long charts are imported whole; that the time is linear, the ignored test shows.
#[test]
fn a_long_chart_is_imported_whole() {
    let (chart, diagnostics) = import(&xmi::ring(2_000), AS_IT_IS).expect("a chart");
    assert!(diagnostics.is_empty());
    assert_eq!(chart.matches("\n  step ").count() + chart.matches("\n  initial step ").count(), 2_000);
    assert!(chart.contains("\n  transition (2000) 2000 -> 1 : b and not a\n"), "{chart}");
    assert!(chart.contains("\n  step 3 { V }\n  step 4\n"), "{chart}");
}

#[test]
#[ignore = "measures"]
#[allow(clippy::print_stdout, reason = "figures are what it is for")]
fn import_takes_time_in_proportion() {
    let mut last = None;
    for steps in [4_096, 8_192, 16_384, 32_768] {
        let text = xmi::ring(steps);
        let best = (0..3).map(|_| {
            let started = Instant::now();
            assert!(import(&text, AS_IT_IS).is_ok());
            started.elapsed()
        });
        let best = best.min().expect("three runs");
        println!("{steps:6} steps, {:6} kB: {:7.1} ms", text.len() / 1000, best.as_secs_f64() * 1000.0);
        if let Some(half) = last.replace(best) {
            assert!(best < half * 4, "twice the steps take {best:?}, not near twice {half:?}");
        }
    }
}
