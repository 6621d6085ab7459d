//! Charts drawn as sequential function charts: what can be drawn is right by the lint and stands clear of itself; what
//! cannot is refused with every reason.

use grafc::{Options, Product};
use grafc_backends::Target;
use grafc_backends::plcopen::{self, Body, Dialect};
use grafc_diagnostics::{Code, Diagnostic, Diagnostics, FileId};
use grafc_logic::scan::StepId;
use grafc_logic::{Encoding, Options as Lowering};
use grafc_model::reaction::{Evolution, Profile};
use grafc_net::passes;
use grafc_testsuite::charts::{cases, charts_folder, check, vectors_folder};
use grafc_testsuite::drawn_chart;
use grafc_testsuite::plcopen_lint::document::{Document, Id};
use grafc_testsuite::plcopen_lint::lint;
use grafc_testsuite::plcopen_sheet::{Flow, Sheet};
use grafc_testsuite::plcopen_tools;
use std::collections::BTreeSet;
use std::sync::LazyLock;

/// A choice, branches in parallel, loops, arcs over several layers, actions of every kind that can be drawn.
const MIX: &str = "\
chart Mix \"two products, weighed and mixed\"
input  go, ready, full_a, full_b, tipped, back, test : bool
input  level : int
output fill_a, fill_b, pump, tip, motor, lamp : bool
output batches : int
initial step 1 \"ready\"
step 2 { fill_a motor }
step 3 { fill_b }
step 4
step 5
step 6 \"mix\" { motor pump if [level > 5] }
step 7 { tip  batches := batches + 1 on activation }
step 8 { lamp }
step 9 { lamp }
transition (a) 1 -> 2, 3 : go and ready and not test
transition (x) 1 -> 8 : test and not go
transition (b) 2 -> 4 : full_a
transition (c) 3 -> 5 : full_b
transition (d) 4, 5 -> 6 : 1
transition (e) 6 -> 7 : [T6 >= 5s]
transition (f) 7 -> 1 : tipped and back
transition (g) 7 -> 6 : tipped and not back
transition (h) 8 -> 9 : not go and ready
transition (i) 8 -> 7 : go and not ready
transition (j) 9 -> 1 : not ready
";

fn draw(text: &str, evolution: Evolution, dialect: Dialect) -> Result<String, Vec<Diagnostic>> {
    let profile = Profile { evolution, ..Profile::default() };
    let product =
        Product::Code(Target::Plcopen(plcopen::Options { body: Body::Sfc, dialect, ..plcopen::Options::default() }));
    let options = Options::new(Lowering { profile, encoding: Encoding::default(), simplify: true }, product);
    let (made, diagnostics) = grafc::compile(FileId::default(), text, "chart", &options);
    made.map(|made| made.text).ok_or_else(|| diagnostics.iter().cloned().collect())
}

/// All charts that can be drawn in the neutral dialect, by name.
static NEUTRAL: LazyLock<Vec<(String, String)>> = LazyLock::new(|| drawings(Dialect::Neutral));

/// All charts that can be drawn in a dialect, by name.
fn drawings(dialect: Dialect) -> Vec<(String, String)> {
    let all = charts().into_iter();
    all.filter_map(|(name, text)| Some((name, draw(&text, Evolution::Scan, dialect).ok()?))).collect()
}

/// All charts that might be drawn, by name.
fn charts() -> Vec<(String, String)> {
    let mut all: Vec<(String, String)> = vec![("mix".to_string(), MIX.to_string())];
    for folder in [charts_folder(), vectors_folder()] {
        all.extend(cases(&folder).into_iter().map(|case| (case.name, case.text)));
    }
    // Wide, deep, and both.
    let wide: String = (2..14)
        .map(|n| format!("step {n} {{ w }}\ntransition 1 -> {n} : [n = {n}]\ntransition {n} -> 1 : a\n"))
        .collect();
    all.push(("wide".to_string(), format!("input n : int\ninput a : bool\noutput w : bool\ninitial step 1\n{wide}")));
    let deep: String = (1..400).map(|n| format!("step {} {{ w }}\ntransition {n} -> {} : a\n", n + 1, n + 1)).collect();
    all.push((
        "deep".to_string(),
        format!("input a : bool\noutput w : bool\ninitial step 1\n{deep}transition 400 -> 1 : a\n"),
    ));
    // Steps that a synchronisation leaves, and another transition as well.
    let semaphore = "input a, b, c : bool\noutput w : bool\ninitial step 1\nstep 2 { w }\nstep 3\ninitial step R\nstep 4\nstep 5\n\
                     transition 1 -> 2 : a\ntransition 1 -> 3 : not a\ntransition 2, R -> 4 : b\ntransition 3, R -> 5 : b\n\
                     transition 4 -> 1, R : c\ntransition 5 -> 1, R : c\n";
    all.push(("semaphore".to_string(), semaphore.to_string()));
    let optional = "input a, b, c : bool\noutput w : bool\ninitial step 1\nstep 2 { w }\nstep 3\nstep 4\n\
                    transition 1 -> 2 : a and not c\ntransition 1 -> 2, 3 : a and c\ntransition 2 -> 4 : b and not X3\n\
                    transition 2, 3 -> 4 : b and not a\ntransition 4 -> 1 : not b\n";
    all.push(("optional".to_string(), optional.to_string()));
    // Names that targets reserve or that differ in what is lost, comments that would end what they stand in.
    let hostile = "input вход \"]]> *)\", `a b`, BEGIN, begin_1 : bool\noutput `]]>`, `step`, ton, a__b : bool\n\
                   initial step шаг \"*) ]]>\" { `]]>` }\nstep `(* *)` { `step` ton if BEGIN }\nstep Ж1 { ton a__b }\n\
                   transition шаг -> `(* *)` : вход and not `a b`\ntransition `(* *)` -> Ж1 : BEGIN\n\
                   transition Ж1 -> шаг : begin_1\n";
    all.push(("hostile".to_string(), hostile.to_string()));
    all
}

#[test]
fn drawings_are_right_by_the_lint_and_by_other_readers() {
    let mut documents: Vec<String> = Vec::new();
    // Of the charts here many have several initial steps or an end, which no tree has.
    for (dialect, least) in [(Dialect::Neutral, 13), (Dialect::Codesys, 8)] {
        let drawings = drawings(dialect);
        assert!(drawings.len() >= least, "only {} charts can be drawn", drawings.len());
        for (name, text) in &drawings {
            assert_eq!(lint(text, dialect), [], "{name}: {text}");
        }
        documents.extend(drawings.into_iter().map(|(_, text)| text));
    }
    plcopen_tools::take_or_skip(&documents);
}

#[test]
fn nothing_stands_on_something_else() {
    for (name, text) in NEUTRAL.iter() {
        let document = Document::read(text).expect("XML");
        assert_eq!(sheet(&document).stands_clear(), Ok(()), "{name}");
    }
}

#[test]
fn wires_end_at_pins_and_run_square_and_down() {
    for (name, text) in NEUTRAL.iter() {
        let document = Document::read(text).expect("XML");
        assert_eq!(sheet(&document).is_wired(Flow::Down), Ok(()), "{name}");
    }
}

fn sheet(document: &Document) -> Sheet<'_> {
    Sheet::of(document, "SFC").expect("a chart")
}

#[test]
fn what_leads_far_down_is_a_jump() {
    let steps: String = (1..60).map(|n| format!("step {}\ntransition {n} -> {} : a\n", n + 1, n + 1)).collect();
    let far = |to: usize| format!("transition 1 -> {to} : not a\ntransition 60 -> 1 : a\n");
    let draw = |to| {
        let text = format!("input a : bool\noutput w : bool\ninitial step 1 {{ w }}\n{steps}{}", far(to));
        draw(&text, Evolution::Scan, Dialect::Neutral).expect("a drawing")
    };
    // Step n stands in layer 2n - 2, the transition after step 1 in layer 1.
    let count = |text: &str, name: &str| Document::read(text).expect("XML").all(name).count();
    for (to, jumps) in [(21, 1), (22, 2)] {
        let text = draw(to);
        assert_eq!([count(&text, "jumpStep"), count(&text, "selectionConvergence")], [jumps, 2 - jumps], "to {to}");
    }
}

/// No bar of a selection leads to a bar of a synchronisation: such wires come from the step itself.
#[test]
fn a_synchronisation_is_fed_by_steps() {
    for name in ["semaphore", "optional"] {
        let (_, text) = NEUTRAL.iter().find(|(other, _)| other == name).expect("a drawing");
        let document = Document::read(text).expect("XML");
        let sheet = document.all("SFC").next().expect("a chart");
        let number = |id: Id| document.attribute(id, "localId").map(str::to_owned);
        let objects: Vec<Id> = document.get(sheet).children.clone();
        let step = |wire: Id| {
            let from = document.attribute(wire, "refLocalId").map(str::to_owned);
            objects.iter().any(|id| number(*id) == from && document.name(*id) == "step")
        };
        let bars: Vec<Id> = document.all("simultaneousConvergence").collect();
        assert!(!bars.is_empty(), "{name}");
        for bar in bars {
            let pins: Vec<Id> = document.children(bar, "connectionPointIn").collect();
            assert!(
                pins.len() == 2 && pins.iter().all(|pin| document.children(*pin, "connection").all(step)),
                "{name}"
            );
        }
    }
}

/// Every transition leaves and enters the steps of the chart, whatever stands between them in the drawing.
#[test]
fn drawings_read_as_their_charts() {
    for (dialect, least) in [(Dialect::Neutral, 13), (Dialect::Codesys, 8)] {
        let mut count = 0;
        for (name, text) in charts() {
            let Ok(drawing) = draw(&text, Evolution::Scan, dialect) else { continue };
            let mut net = grafc_net::build(&check(&name, &text).expect("a chart"));
            passes::run(&mut net, false, &mut Diagnostics::new());
            let plain = |label: &str| label.bytes().all(|byte| byte.is_ascii_alphanumeric());
            if !net.places.iter().all(|place| plain(&place.label)) {
                continue;
            }
            count += 1;
            let step = |id: &StepId| {
                let label = &net.places[*id].label;
                let is_number = label.starts_with(|c: char| c.is_ascii_digit());
                if is_number { format!("X{label}") } else { label.to_string() }
            };
            let ends = net.transitions.iter().map(|t| [&t.pre, &t.post].map(|ids| ids.iter().map(step).collect()));
            let mut expected: Vec<[BTreeSet<String>; 2]> = ends.collect();
            expected.sort();
            let initial = net.places.iter_enumerated().filter(|(_, place)| place.initial);
            let drawn = drawn_chart::read(&Document::read(&drawing).expect("XML"));
            let drawn = drawn.unwrap_or_else(|said| panic!("{name}, {dialect:?}: {said} in {drawing}"));
            let mut ends: Vec<_> = drawn.transitions.into_iter().map(|t| [t.before, t.after]).collect();
            ends.sort();
            let initial: BTreeSet<String> = initial.map(|(id, _)| step(&id)).collect();
            // Of a commanded grafcet the orders are transitions as well, and it may rest.
            let commanded = net.grafcets.iter().any(|grafcet| !grafcet.orders.is_empty() || grafcet.child)
                || net.places.iter().any(|place| !place.within.is_empty());
            if commanded {
                let mut wanted = expected.clone();
                ends.retain(|ends| wanted.iter().position(|known| known == ends).map(|at| wanted.remove(at)).is_some());
                assert!(drawn.initial.is_superset(&initial), "{name}");
            } else {
                assert_eq!(drawn.initial, initial, "{name}");
            }
            assert_eq!(ends, expected, "{name}, {dialect:?}: {drawing}");
        }
        assert!(count >= least, "only {count} drawings were read");
    }
}

/// Conditions and actions stand at their transitions and steps. An output of one step is a variable with `N`, and so is one
/// of several that do not hand over to each other; one with a condition is computed while its step is active and once more
/// at the end. Others are found behind the chart.
#[test]
fn conditions_and_actions_stand_where_they_belong() {
    let text = draw(MIX, Evolution::Scan, Dialect::Neutral).expect("a drawing");
    let drawn = drawn_chart::read(&Document::read(&text).expect("XML")).expect("a chart");
    let rows = |step: &str| -> Vec<String> {
        let rows = drawn.actions.get(step).into_iter().flatten();
        rows.map(|(qualifier, text)| format!("{qualifier} {}", text.split(" := ").next().unwrap_or_default())).collect()
    };
    for (step, expected) in [
        ("X1", &[][..]),
        ("X2", &["N fill_a", "N motor"]),
        ("X3", &["N fill_b"]),
        ("X4", &[]),
        ("X6", &["N motor", "N pump", "P0 pump"]),
        ("X7", &["N tip", "P1 batches"]),
        ("X8", &["N at_8"]),
    ] {
        let mut rows = rows(step);
        let mut expected = expected.to_vec();
        rows.sort();
        expected.sort_unstable();
        assert_eq!(rows, expected, "{step} in {text}");
    }
    let after = |condition: &str| {
        let found = drawn.transitions.iter().find(|transition| transition.condition == condition);
        found.map(|transition| transition.after.iter().map(String::as_str).collect::<Vec<_>>().join(" "))
    };
    for (condition, expected) in [
        ("go AND ready AND NOT test", "X2 X3"),
        ("test AND NOT go", "X8"),
        ("full_a", "X4"),
        ("full_b", "X5"),
        ("X6.T >= T#5s", "X7"),
        ("tipped AND back", "X1"),
        ("tipped AND NOT back", "X6"),
        ("NOT ready", "X1"),
    ] {
        assert_eq!(after(condition).as_deref(), Some(expected), "{condition} in {text}");
    }
}

/// Qualifiers with a time, what is set and reset, and what is done each scan, in both dialects.
#[test]
fn qualifiers_are_drawn() {
    let chart = "chart C evolution scan\ninput a : bool\noutput late, early, h : bool\noutput n : int\nconst wait : time := 2s\n\
                 initial step 1\nstep 2 { late if [T2 >= wait]  early if not [T2 >= 500ms]  h := true on activation }\n\
                 step 3 { h := false on activation  n := 0 each scan if [n > 9]  n := n + 1 each scan if [n <= 9] and a }\n\
                 transition 1 -> 2 : a\ntransition 2 -> 3 : not a\ntransition 3 -> 1 : a\n";
    let counts = "IF n > 9 THEN n := 0; ELSIF (n <= 9) AND a THEN n := n + 1; END_IF;";
    let text = draw(chart, Evolution::Scan, Dialect::Neutral).expect("a drawing");
    assert_eq!(lint(&text, Dialect::Neutral), [], "{text}");
    let drawn = drawn_chart::read(&Document::read(&text).expect("XML")).expect("a chart");
    let rows = |step: &str| drawn.actions.get(step).cloned().unwrap_or_default();
    let row = |qualifier: &str, what: &str| (qualifier.to_owned(), what.to_owned());
    assert_eq!(rows("X2"), [row("D", "late"), row("L", "early"), row("S", "h")]);
    assert_eq!(rows("X3"), [row("R", "h"), row("N", counts)]);
    assert!(text.contains("qualifier=\"D\" duration=\"wait\"") && text.contains("duration=\"T#500ms\""), "{text}");

    let text = draw(chart, Evolution::Scan, Dialect::Codesys).expect("a drawing");
    assert_eq!(lint(&text, Dialect::Codesys), [], "{text}");
    for part in [
        "qualifier=\"L\" duration=\"T#500ms\"",
        ">D wait</attribute>",
        "<attribute guid=\"700a583f-b4d4-43e4-8c14-629c7cd3bec8\">X3_active</attribute>",
        "ELSIF (n &lt;= 9) AND a THEN",
    ] {
        assert!(text.contains(part), "{part} in {text}");
    }
}

/// What is done when a step is left, beside what is done when it is entered.
#[test]
fn actions_on_activation_and_deactivation_keep_apart() {
    let chart = "input a : bool\noutput n, m : int\ninitial step 1\nstep 2 { n := 1 on activation  m := 2 on deactivation }\n\
                 transition 1 -> 2 : a\ntransition 2 -> 1 : not a\n";
    let text = draw(chart, Evolution::Scan, Dialect::Neutral).expect("a drawing");
    let drawn = drawn_chart::read(&Document::read(&text).expect("XML")).expect("a chart");
    let expected =
        [("P1", "n := 1;"), ("P0", "m := 2;")].map(|(qualifier, text)| (qualifier.to_owned(), text.to_owned()));
    assert_eq!(drawn.actions.get("X2").map(Vec::as_slice), Some(&expected[..]), "{text}");
}

#[test]
fn a_drawing_is_the_chart() {
    let text = draw(MIX, Evolution::Scan, Dialect::Neutral).expect("a drawing");
    let document = Document::read(&text).expect("XML");
    let count = |name: &str| document.all(name).count();
    // As the chart has them: a choice after 1, 7 and 8; a fork and a join; ways to 7 from 6 and 8; loops to 1, 1 and 6.
    assert_eq!([count("step"), count("transition")], [9, 11]);
    assert_eq!([count("selectionDivergence"), count("selectionConvergence")], [3, 1]);
    assert_eq!([count("simultaneousDivergence"), count("simultaneousConvergence")], [1, 1]);
    let mut jumps: Vec<&str> = document.all("jumpStep").filter_map(|id| document.attribute(id, "targetName")).collect();
    jumps.sort_unstable();
    assert_eq!(jumps, ["X1", "X1", "X6"]);
    for expected in [
        "<![CDATA[go AND ready AND NOT test]]>",
        "<![CDATA[X6.T >= T#5s]]>",
        "<![CDATA[pump := X6.X AND (level > 5);]]>",
        "lamp := drawn.at_8 OR drawn.at_9;",
        "<reference name=\"motor\"/>",
        "<![CDATA[batches := batches + 1;]]>",
        "<reference name=\"tip\"/>",
    ] {
        assert!(text.contains(expected), "{expected} in {text}");
    }
    // A step brings its own variables along.
    assert!(!text.contains("variable name=\"X1\""), "{text}");
    assert!(text.contains("variable name=\"at_8\""), "{text}");
}

#[test]
fn a_tree_is_the_chart() {
    let text = draw(MIX, Evolution::Scan, Dialect::Codesys).expect("a drawing");
    let document = Document::read(&text).expect("XML");
    let count = |name: &str| document.all(name).count();
    assert_eq!([count("step"), count("transition")], [9, 11]);
    // Each of the choices after 1, 7 and 8 is closed, and the fork after 1.
    assert_eq!([count("selectionDivergence"), count("selectionConvergence")], [3, 3]);
    assert_eq!([count("simultaneousDivergence"), count("simultaneousConvergence")], [1, 1]);
    for expected in [
        "<expression>go AND ready AND NOT test</expression>",
        "<action name=\"set_pump\">",
        "<reference name=\"motor\"/>",
        "lamp := drawn.at_8 OR drawn.at_9;",
        "<action name=\"X7_entry\">",
        "<attribute guid=\"a6b08bd8-b696-47e3-9cbf-7408b61c9ff8\">X7_entry</attribute>",
        "<reference name=\"tip\"/>",
    ] {
        assert!(text.contains(expected), "{expected} in {text}");
    }
    // There is no such qualifier: the last run of an action, after its step, does the same.
    assert!(!text.contains("\"P0\"") && !text.contains("\"P1\""), "{text}");
}

/// A chart without nesting, and what is said of it.
const NOT_NESTED: &[(&str, &str)] = &[
    (
        "initial step 1\nstep 2\ntransition 1 -> 2 : a\ntransition 2 -> 1 : b\n\
         initial step 3\nstep 4\ntransition 3 -> 4 : a\ntransition 4 -> 3 : b",
        "a second initial step",
    ),
    (
        "initial step 1\nstep 2\nstep 3\nstep 4\nstep 5\nstep 6\ntransition 1 -> 2, 3, 4 : a\n\
         transition 2, 3 -> 5 : a\ntransition 5, 4 -> 1 : b\nstep 7\ntransition 6 -> 7 : a\ntransition 7 -> 6 : a",
        "do not end in one transition",
    ),
    (
        "initial step 1\nstep 2\nstep 3\ntransition 1 -> 2 : a\ntransition 2 -> 1 : b\ntransition 3 -> 1 : b and not a",
        "nothing leads to this step",
    ),
];

#[test]
fn what_is_not_nested_is_refused_with_its_reason() {
    for (chart, reason) in NOT_NESTED {
        let text = format!("input a, b : bool\n{chart}\n");
        let diagnostics = match draw(&text, Evolution::Scan, Dialect::Codesys) {
            Ok(_) => panic!("drawn: {chart}"),
            Err(diagnostics) => diagnostics,
        };
        let found = diagnostics.iter().any(|d| d.code == Code::E0503 && d.primary.text.contains(reason));
        assert!(found, "{chart}: {diagnostics:?}");
    }
}

/// The names in a list of variables of a unit.
fn declared<'d>(document: &'d Document, unit: Id, list: &str) -> Vec<&'d str> {
    let lists = document.within(unit).filter(|id| document.name(*id) == list);
    lists.flat_map(|list| document.children(list, "variable")).filter_map(|id| document.attribute(id, "name")).collect()
}

/// The one body in Structured Text that calls a drawing, its words a blank apart.
fn around(document: &Document) -> String {
    let bodies = document.all("ST").map(|id| &document.get(document.get(id).children[0]).text);
    let bodies: Vec<&String> = bodies.filter(|text| text.contains("drawn(")).collect();
    let [body] = bodies[..] else { panic!("{} calls", bodies.len()) };
    body.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// What inputs decide is found before the chart is called, and is an input of it.
#[test]
fn edges_and_delays_of_inputs_are_found_before() {
    let chart = "chart Press\ninput a, b : bool\noutput w : bool\nconst late : time := 3s\ninitial step 1\nstep 2 { w }\n\
                 step 3\ntransition 1 -> 2 : ↑a and not b\ntransition 2 -> 3 : ↓(a or b)\n\
                 transition 3 -> 1 : late/b/2s and ↑a\n";
    for dialect in [Dialect::Neutral, Dialect::Codesys] {
        let text = draw(chart, Evolution::Scan, dialect).expect("a drawing");
        assert_eq!(lint(&text, dialect), [], "{text}");
        let document = Document::read(&text).expect("XML");
        let names: Vec<&str> = document.all("pou").filter_map(|unit| document.attribute(unit, "name")).collect();
        assert_eq!(names, ["Press_chart", "Press", "Press_program"]);
        let of = |unit: usize, list: &str| declared(&document, document.all("pou").nth(unit).expect("a unit"), list);
        assert_eq!(of(0, "inputVars"), ["a", "b", "rise_a", "fall_a_or_b", "delayed_b"]);
        assert_eq!(of(0, "outputVars"), ["w"]);
        assert_eq!(of(1, "inputVars"), ["a", "b"]);
        assert_eq!(
            around(&document),
            "IF NOT started THEN started := TRUE; old_a := a; old_a_or_b := a OR b; END_IF; \
             rise_a := a AND NOT old_a; fall_a_or_b := NOT (a OR b) AND old_a_or_b; on_b(IN := b, PT := late); \
             off_b(IN := NOT on_b.Q, PT := T#2s); held_b := on_b.Q OR (held_b AND NOT off_b.Q); delayed_b := held_b; \
             old_a := a; old_a_or_b := a OR b; \
             drawn(a := a, b := b, rise_a := rise_a, fall_a_or_b := fall_a_or_b, delayed_b := delayed_b); w := drawn.w;"
        );
    }
}

/// What depends on steps is found before the call that goes on from them: their markers are outputs of the drawing.
#[test]
fn edges_and_delays_of_steps_are_found_before() {
    let chart = "chart Press\ninput a : bool\noutput w : bool\noutput n : int\ninitial step 1\nstep 2 { w  n := n + 1 on activation }\n\
                 transition 1 -> 2 : 2s/X1 and a\ntransition 2 -> 1 : ↓(X1 or [n > 3])\n";
    let text = draw(chart, Evolution::Scan, Dialect::Neutral).expect("a drawing");
    assert_eq!(lint(&text, Dialect::Neutral), [], "{text}");
    let document = Document::read(&text).expect("XML");
    let drawn = document.all("pou").next().expect("a unit");
    assert_eq!(declared(&document, drawn, "outputVars"), ["w", "n", "at_1"]);
    assert_eq!(
        around(&document),
        "IF NOT started THEN started := TRUE; old_X1_or_n_3 := drawn.at_1 OR (n > 3); END_IF; \
         on_X1(IN := drawn.at_1, PT := T#2s); delayed_X1 := on_X1.Q; \
         fall_X1_or_n_3 := NOT (drawn.at_1 OR (n > 3)) AND old_X1_or_n_3; \
         old_X1_or_n_3 := drawn.at_1 OR (n > 3); \
         drawn(a := a, delayed_X1 := delayed_X1, fall_X1_or_n_3 := fall_X1_or_n_3); w := drawn.w; n := drawn.n;"
    );
    // To stability an edge of a step is over when the call is.
    assert!(draw(chart, Evolution::Stable, Dialect::Neutral).is_err());
}

/// A chart that holds what cannot be drawn, and the reason.
const REFUSED: &[(&str, &str)] = &[
    (
        "initial step 1\nstep 2\ntransition 1 -> 2 : a\ntransition 1 -> 2 : b\ntransition -> 2 : a",
        "a source transition",
    ),
    ("initial step 1\nstep 2\ntransition 1 -> : a\ntransition 2 -> 1 : b", "a sink transition"),
    ("initial step 1\nstep 2\ntransition 1 -> 1 : a\ntransition 2 -> 1 : b", "leads back to a step that it leaves"),
    ("initial step 1\nstep 2\nstep 3\ntransition 1 -> 2 : a\ntransition 1 -> 3 : b", "may clear together"),
    (
        "initial step 1\ninitial step 2\nstep 3\ntransition 1 -> 2 : a\ntransition 2 -> 3 : b",
        "may lead to step `2` while it is active",
    ),
    (
        "initial step 1\nstep 2\ntransition 1 -> 2 : ↑([T1 > 2s])\ntransition 2 -> 1 : b",
        "an edge of what is not known before the chart is called",
    ),
    (
        "initial step 1\nstep 2\ntransition 1 -> 2 : 2s/([T1 > 2s])\ntransition 2 -> 1 : b",
        "a delay of what is not known before the chart is called, which needs a timer",
    ),
    ("initial step 1\nstep 2\ntransition 1 -> 2 : [n / i > 1]\ntransition 2 -> 1 : b", "a division"),
    ("initial step 1\nstep 2\ntransition 1 -> 2 : [n + i * 2 > 1]\ntransition 2 -> 1 : b", "an intermediate result"),
    (
        "initial step 1 { w }\nstep 2\ntransition 1 -> 2 : a and w\ntransition 2 -> 1 : b",
        "reads what continuous actions set",
    ),
    (
        "initial step 1\nstep 2 { n := n + 1 on event ↑a }\ntransition 1 -> 2 : a\ntransition 2 -> 1 : b",
        "an action on an event",
    ),
    (
        "initial step 1 { n := 1 on activation }\nstep 2\ntransition 1 -> 2 : a\ntransition 2 -> 1 : b",
        "the activation of an initial step",
    ),
    (
        "initial step 1\nstep 2 { n := 1 on activation }\nstep 3 { n := 2 on deactivation }\ntransition 1 -> 3 : a\n\
         transition 3 -> 2 : b\ntransition 2 -> 1 : a",
        "may be done in one scan with another action on the same variable",
    ),
    (
        "initial step 1\nstep 2 { n := 1 on activation }\ninitial step 3\nstep 4 { m := n on activation }\n\
         transition 1 -> 2 : a\ntransition 2 -> 1 : b\ntransition 3 -> 4 : a\ntransition 4 -> 3 : b",
        "reads what another action stores",
    ),
    (
        "initial step 1\nstep 2 { n := m on activation  m := n on activation }\ntransition 1 -> 2 : a\ntransition 2 -> 1 : b",
        "reads what another action stores, which reads what this one stores",
    ),
    (
        "var v : bool\ninitial step 1\nstep 2 { n := n + 1 on activation }\ninitial step 3 { v if [n > 2] }\ntransition 1 -> 2 : a\n\
         transition 2 -> 1 : b",
        "reads what an action stores in the same scan",
    ),
    (
        "initial step 1\nstep 2\ntransition 1 -> 2 : [T2 > 1s]\ntransition 2 -> 1 : b",
        "the time of a step other than the one right before it",
    ),
    // Commands that transitions of the commanded grafcet cannot be.
    (
        "grafcet G1 {\n initial step 1\n step 2 { force G2{4} }\n transition 1 -> 2 : a\n transition 2 -> 1 : b\n}\n\
         grafcet G2 {\n initial step 3\n step 4\n step 5\n transition 3 -> 4, 5 : a\n transition 4, 5 -> 3 : b\n}",
        "into one with some of the same steps",
    ),
    (
        "grafcet G1 {\n initial step 1 { start P on deactivation }\n step 2\n transition 1 -> 2 : a\n\
         transition 2 -> 1 : b\n}\nchild grafcet P of G1 {\n initial step 3\n step 4\n transition 3 -> 4 : a\n\
         transition 4 -> 3 : b\n}",
        "may be started while it is active",
    ),
    (
        "grafcet G1 {\n initial step 1 { start P on deactivation }\n step 2 { kill P on event a }\n\
         transition 1 -> 2 : a\n transition 2 -> 1 : b\n}\nchild grafcet P of G1 {\n initial step 3\n step 4\n\
         transition 3 -> 4 : a\n transition 4 -> 3 : b\n}",
        "an event that need not be an edge",
    ),
    (
        "grafcet G1 {\n initial step 1 { freeze P on deactivation }\n step 2 { start P on activation }\n\
         transition 1 -> 2 : a\n transition 2 -> 1 : b\n}\nchild grafcet P of G1 {\n initial step 3\n step 4\n\
         transition 3 -> 4 : a\n transition 4 -> 3 : b\n}",
        "different pulse orders at once",
    ),
    (
        "grafcet G1 {\n initial step 1\n enclosing step 2\n transition 1 -> 2 : a\n transition 2 -> 1 : b\n}\n\
         grafcet X2/G2 {\n activated step 3\n step 4\n transition 3 -> 4 : a\n transition 4 -> : b\n}",
        "a source or sink transition of a grafcet that is commanded",
    ),
    (
        "grafcet G1 {\n initial step 1\n step 2 { force G2{} }\n transition 1 -> 2 : a\n transition 2 -> 1 : b\n}\n\
         grafcet G2 {\n initial step 10\n step 11\n step 12\n step 13\n step 14\n step 15\n step 16\n step 17\n step 18\n\
         step 21\n step 22\n step 23\n step 24\n step 25\n step 26\n step 27\n step 28\n transition 10 -> 11, 12, 13, 14, 15, 16, 17, 18 : a\n\
         transition 11 -> 21 : a\n transition 12 -> 22 : b\n transition 13 -> 23 : a\n transition 14 -> 24 : b\n\
         transition 15 -> 25 : a\n transition 16 -> 26 : b\n transition 17 -> 27 : a\n transition 18 -> 28 : b\n}",
        "too many situations",
    ),
];

#[test]
fn what_cannot_be_drawn_is_refused_with_its_reason() {
    let declared = "input a, b : bool\ninput i : int\noutput w : bool\noutput n, m : int\n";
    for (chart, reason) in REFUSED {
        let diagnostics = draw(&format!("{declared}{chart}\n"), Evolution::Scan, Dialect::Neutral).expect_err(chart);
        let refused: Vec<&Diagnostic> = diagnostics.iter().filter(|d| d.code == Code::E0503).collect();
        let [refused] = refused[..] else { panic!("{chart}: {diagnostics:?}") };
        let labels = std::iter::once(&refused.primary).chain(&refused.secondary);
        assert!(labels.clone().any(|label| label.text.contains(reason)), "{chart}: {refused:?}");
        assert!(labels.clone().all(|label| label.span.end > label.span.start), "{chart}: a reason without a place");
    }
}

#[test]
fn every_reason_is_named_at_once() {
    let chart = "input a, b : bool\noutput n : int\ninitial step 1\nstep 2 { n := 1 on event ↑b }\n\
                 transition 1 -> 2 : ↑(a and X1)\ntransition 2 -> 1 : 1s/(b or X1)\n";
    let diagnostics = draw(chart, Evolution::Stable, Dialect::Neutral).expect_err("four reasons");
    let refused = diagnostics.iter().find(|d| d.code == Code::E0503).expect("a refusal");
    let texts: Vec<&str> =
        std::iter::once(&refused.primary).chain(&refused.secondary).map(|label| label.text.as_str()).collect();
    for reason in ["an edge", "a delay", "an action on an event", "several evolutions"] {
        assert!(texts.iter().any(|text| text.contains(reason)), "{reason} in {texts:?}");
    }
}
