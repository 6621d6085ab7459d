//! Each construct of the language gives the tree it should.

mod common;

use common::{chart, condition, faults, show, value};
use grafc_syntax::ast::*;

fn only(text: &str) -> (Chart, Item) {
    let mut chart = chart(text);
    assert_eq!(chart.items.len(), 1, "{text}");
    let item = chart.items.remove(0);
    (chart, item)
}

fn step(text: &str) -> (Chart, Step) {
    match only(text) {
        (chart, Item::Step(step)) => (chart, step),
        (_, item) => panic!("a step was written: {item:?}"),
    }
}

fn transition(text: &str) -> (Chart, Transition) {
    match only(text) {
        (chart, Item::Transition(transition)) => (chart, transition),
        (_, item) => panic!("a transition was written: {item:?}"),
    }
}

fn texts(names: &[Name]) -> Vec<&str> {
    names.iter().map(|n| n.text.as_str()).collect()
}

#[test]
fn heading() {
    let chart = chart("chart Weigh_mix \"annex B\"");
    let heading = chart.heading.expect("it was written");
    assert_eq!((heading.name.text.as_str(), heading.comment.unwrap().text.as_str()), ("Weigh_mix", "annex B"));
}

#[test]
fn declarations() {
    for (text, kind, ty, names, initial, address) in [
        ("input a \"x\", b : bool at %IX0.6", DeclarationKind::Input, Type::Bool, vec!["a", "b"], None, Some("%IX0.6")),
        ("output y : int", DeclarationKind::Output, Type::Int, vec!["y"], None, None),
        ("var n : dint := -3", DeclarationKind::Variable, Type::Dint, vec!["n"], Some("(negate 3)"), None),
        ("const t : time := 8s", DeclarationKind::Constant, Type::Time, vec!["t"], Some("8000ms"), None),
        (
            "var `step` : uint := 1 at %MW2",
            DeclarationKind::Variable,
            Type::Uint,
            vec!["step"],
            Some("1"),
            Some("%MW2"),
        ),
        (
            "var n : udint at %MD2 := 1 + 2",
            DeclarationKind::Variable,
            Type::Udint,
            vec!["n"],
            Some("(+ 1 2)"),
            Some("%MD2"),
        ),
        ("var r : real := 1.5", DeclarationKind::Variable, Type::Real, vec!["r"], Some("1.5"), None),
        ("var r : lreal := true", DeclarationKind::Variable, Type::Lreal, vec!["r"], Some("true"), None),
    ] {
        let (chart, Item::Declaration(declaration)) = only(text) else { panic!("a declaration was written: {text}") };
        assert_eq!((declaration.kind, declaration.ty), (kind, Some(ty)), "{text}");
        assert_eq!(declaration.names.iter().map(|n| n.name.text.as_str()).collect::<Vec<_>>(), names, "{text}");
        assert_eq!(declaration.initial.map(|i| show(&chart, i)).as_deref(), initial, "{text}");
        assert_eq!(declaration.address.as_ref().map(|a| a.text.as_str()), address, "{text}");
        assert_eq!(declaration.span.range(), 0..text.len(), "{text}");
    }
}

#[test]
fn retained_declarations() {
    for (text, kind, retained) in [
        ("retain var n : int", DeclarationKind::Variable, true),
        ("var n : int", DeclarationKind::Variable, false),
        ("retain output V \"c\", W : bool := 1 at %QX0.0", DeclarationKind::Output, true),
        ("retain (* kept *) var n : int", DeclarationKind::Variable, true),
        ("retain input a : bool", DeclarationKind::Input, true),
        ("var retain : int", DeclarationKind::Variable, false),
    ] {
        let (_, Item::Declaration(declaration)) = only(text) else { panic!("a declaration was written: {text}") };
        assert_eq!((declaration.kind, declaration.retain.is_some()), (kind, retained), "{text}");
        assert_eq!(declaration.span.range(), 0..text.len(), "{text}");
    }
}

/// It is a name where one is expected, whatever follows.
#[test]
fn retain_is_a_name_elsewhere() {
    for (text, items) in [
        ("output retain : bool var n : int", 2),
        ("output a, retain : bool", 1),
        ("step 1 { retain } var n : int", 2),
        ("step retain var n : int", 2),
        ("initial step retain { retain if retain } var n : int", 2),
        ("transition (1) \"back\" retain -> retain : a and retain var n : int", 2),
        ("transition (retain) 1 -> 2 : retain output V : bool", 2),
        ("transition 1 -> 2 : not retain var n : int", 2),
        ("chart retain var n : int", 1),
    ] {
        let chart = chart(text);
        assert_eq!(chart.items.len(), items, "{text}");
        let retained = chart.items.iter().filter(|i| matches!(i, Item::Declaration(d) if d.retain.is_some()));
        assert_eq!(retained.count(), 0, "{text}");
    }
}

/// It begins an item behind one that is whole.
#[test]
fn retain_begins_an_item() {
    for before in [
        "chart C",
        "chart C \"c\"",
        "input a : bool",
        "output a : bool at %QX0.0",
        "const k : int := 3",
        "const k : time := 3s",
        "const k : real := 1.5",
        "const k : bool := true",
        "step 1",
        "step 1 \"c\"",
        "step 1 { V }",
        "transition 1 -> 2 : a",
        "transition 1 -> 2 : (a)",
        "transition 1 -> 2 : [C = 3]",
        "transition 1 -> 2 : retain",
        "grafcet G1 { step 1 }",
    ] {
        let chart = chart(&format!("{before} retain var n : int"));
        let last = chart.items.last().expect("there is one");
        assert!(matches!(last, Item::Declaration(d) if d.retain.is_some()), "{before}: {last:?}");
    }
}

#[test]
fn steps_of_all_kinds() {
    for (text, kind, initial, activated) in [
        ("step 2", StepKind::Plain, false, false),
        ("initial step 2", StepKind::Plain, true, false),
        ("activated step 2", StepKind::Plain, false, true),
        ("initial activated step 2", StepKind::Plain, true, true),
        ("activated initial step 2", StepKind::Plain, true, true),
        ("enclosing step 2", StepKind::Enclosing, false, false),
        ("initial enclosing step 2", StepKind::Enclosing, true, false),
        ("activated enclosing step 2", StepKind::Enclosing, false, true),
        ("initial activated enclosing step 2", StepKind::Enclosing, true, true),
        ("enclosing initial step 2", StepKind::Enclosing, true, false),
        ("macro step 2", StepKind::Macro, false, false),
        ("activated macro step 2", StepKind::Macro, false, true),
    ] {
        let (_, step) = step(text);
        assert_eq!((step.kind, step.is_initial(), step.is_activated()), (kind, initial, activated), "{text}");
        assert_eq!((step.label.text.as_str(), step.span.range()), ("2", 0..text.len()), "{text}");
    }
}

#[test]
fn actions() {
    let (chart, step) = step(
        "step 1 \"c\" { V  W if 3s/X1  C := C + 1 on activation  K := 1 on deactivation B if not 6s/X28
        H := 0 on event ↑a  force G12{8, Fill} force G3{*} force G4{} force G6{INIT} force G7{`INIT`} }",
    );
    let shown: Vec<String> = step
        .actions
        .iter()
        .map(|action| match &action.kind {
            ActionKind::Continuous { target, condition: None } => target.text.to_string(),
            ActionKind::Continuous { target, condition: Some(condition) } => {
                format!("{} if {}", target.text, show(&chart, *condition))
            }
            ActionKind::Stored { assignment, event } => {
                let event = match event {
                    Event::Activation => "activation".to_owned(),
                    Event::Deactivation => "deactivation".to_owned(),
                    Event::Event(condition) => show(&chart, *condition),
                    Event::EachScan(_) => "each scan".to_owned(),
                };
                format!("{} := {} on {event}", assignment.target.text, show(&chart, assignment.value))
            }
            ActionKind::Pulse { kind, grafcet, .. } => format!("{} {}", kind.word(), grafcet.text),
            ActionKind::Run { grafcet } => format!("run {}", grafcet.text),
            ActionKind::Force { grafcet, situation } => match situation {
                Situation::Steps(steps) => format!("{} {:?}", grafcet.text, texts(steps)),
                Situation::Current => format!("{} frozen", grafcet.text),
                Situation::Initial => format!("{} initial", grafcet.text),
            },
        })
        .collect();
    assert_eq!(
        shown,
        [
            "V",
            "W if (delay 3000ms X1)",
            "C := (+ C 1) on activation",
            "K := 1 on deactivation",
            "B if (not (delay 6000ms X28))",
            "H := 0 on (rise a)",
            "G12 [\"8\", \"Fill\"]",
            "G3 frozen",
            "G4 []",
            "G6 initial",
            "G7 [\"INIT\"]",
        ]
    );
}

#[test]
fn transitions_of_all_forms() {
    for (text, designation, comment, from, to) in [
        ("transition 1 -> 2 : c", None, None, vec!["1"], vec!["2"]),
        ("transition (5) 1 -> 2 : c", Some("5"), None, vec!["1"], vec!["2"]),
        ("transition (t5) \"why\" 1 -> 2 : c", Some("t5"), Some("why"), vec!["1"], vec!["2"]),
        ("transition \"why\" 1 -> 2 : c", None, Some("why"), vec!["1"], vec!["2"]),
        ("transition 18, 34, D1 -> 12, 13 : c", None, None, vec!["18", "34", "D1"], vec!["12", "13"]),
        ("transition -> 1 : c", None, None, vec![], vec!["1"]),
        ("transition (5) -> 1 : c", Some("5"), None, vec![], vec!["1"]),
        ("transition \"why\" -> 1 : c", None, Some("why"), vec![], vec!["1"]),
        ("transition 4 -> : c", None, None, vec!["4"], vec![]),
        ("transition -> : c", None, None, vec![], vec![]),
        ("transition 1 → 2 : c {}", None, None, vec!["1"], vec!["2"]),
    ] {
        let (_, transition) = transition(text);
        assert_eq!(transition.designation().map(|d| d.text.as_str()), designation, "{text}");
        assert_eq!(transition.comment().as_ref().map(|c| c.text.as_str()), comment, "{text}");
        assert_eq!((texts(&transition.from), texts(&transition.to)), (from, to), "{text}");
        assert_eq!(transition.span.range(), 0..text.len(), "{text}");
    }
    let (chart, transition) = transition("transition 3 -> 4 : b { C := C + 1 D := -C E := (1) }");
    let actions: Vec<_> =
        transition.actions().iter().map(|a| (a.target.text.as_str(), show(&chart, a.value))).collect();
    assert_eq!(actions, [("C", "(+ C 1)".into()), ("D", "(negate C)".into()), ("E", "(paren 1)".into())]);
}

#[test]
fn blocks() {
    let text = "grafcet X9/G4 \"e\" { step 1 expansion M3 { step E3 expansion M4 { step E4 } } } expansion 5 \"x\" { }";
    let chart = chart(text);
    let [Item::Grafcet(grafcet), Item::Expansion(last)] = chart.items.as_slice() else { panic!("{:?}", chart.items) };
    assert_eq!((texts(&grafcet.path), grafcet.name.text.as_str()), (vec!["X9"], "G4"));
    assert_eq!(&text[grafcet.span.range()], &text[..text.rfind(" expansion").unwrap()]);
    let [Item::Step(_), Item::Expansion(expansion)] = grafcet.items.as_slice() else { panic!("{:?}", grafcet.items) };
    assert_eq!((expansion.macro_step.text.as_str(), expansion.items.len()), ("M3", 2));
    assert_eq!((last.macro_step.text.as_str(), last.comment.as_ref().unwrap().text.as_str()), ("5", "x"));
    let (_, Item::Grafcet(deep)) = only("grafcet X1/G2/X3/G4 { }") else { panic!("a grafcet was written") };
    assert_eq!((texts(&deep.path), deep.name.text.as_str()), (vec!["X1", "G2", "X3"], "G4"));
}

#[test]
fn precedence_in_conditions() {
    for (written, read) in [
        ("a or b and c", "(or a (and b c))"),
        ("a and b or c", "(or (and a b) c)"),
        ("a xor b and c", "(xor a (and b c))"),
        ("a xor b or c xor d", "(or (xor a b) (xor c d))"),
        ("a or b or c", "(or (or a b) c)"),
        ("a + b · c", "(or a (and b c))"),
        ("a | b & c", "(or a (and b c))"),
        ("not a and b", "(and (not a) b)"),
        ("not not !¬a", "(not (not (not (not a))))"),
        ("not ↑a · ↓b", "(and (not (rise a)) (fall b))"),
        ("rise a and fall b", "(and (rise a) (fall b))"),
        ("↑(a + b)", "(rise (paren (or a b)))"),
        ("↑[C = 3]", "(rise (predicate (= C 3)))"),
        ("1", "1"),
        ("true or 0", "(or true 0)"),
        ("3s/a/7s", "(delay 3000ms a 7000ms)"),
        ("4s/X27", "(delay 4000ms X27)"),
        ("X2/5s", "(delay X2 5000ms)"),
        ("t1/(a or b)/t2", "(delay t1 (paren (or a b)) t2)"),
        ("3s/[C = 3]", "(delay 3000ms (predicate (= C 3)))"),
        ("not 3s/a and b", "(and (not (delay 3000ms a)) b)"),
        ("↑(3s/a)", "(rise (paren (delay 3000ms a)))"),
        ("X4/X25/X12", "(delay X4 X25 X12)"),
    ] {
        assert_eq!(condition(written), read, "{written}");
    }
}

#[test]
fn precedence_in_brackets_and_values() {
    for (written, read) in [
        ("1 + 2 * 3", "(+ 1 (* 2 3))"),
        ("1 - 2 - 3", "(- (- 1 2) 3)"),
        ("8 / 4 / 2 mod 3", "(mod (/ (/ 8 4) 2) 3)"),
        ("-a * b", "(* (negate a) b)"),
        ("a - -b", "(- a (negate b))"),
        ("a + 1 < b * 2", "(< (+ a 1) (* b 2))"),
        ("T27 >= 5s and C < N + 1", "(and (>= T27 5000ms) (< C (+ N 1)))"),
        ("a = 1 or b <> 2 xor c ≠ 3", "(or (= a 1) (xor (<> b 2) (<> c 3)))"),
        ("a <= 1 and b ≤ 2 and c >= 3 and d ≥ 4", "(and (and (and (<= a 1) (<= b 2)) (>= c 3)) (>= d 4))"),
        ("not a = b", "(= (not a) b)"),
        ("↑a and not ↓(b or c)", "(and (rise a) (not (fall (paren (or b c)))))"),
        ("[[a + 1] > 2]", "(predicate (> (predicate (+ a 1)) 2))"),
        ("(a + b) * c", "(* (paren (+ a b)) c)"),
    ] {
        assert_eq!(value(written), read, "{written}");
        if !written.starts_with('[') {
            assert_eq!(condition(&format!("[{written}]")), format!("(predicate {read})"), "{written}");
        }
    }
}

#[test]
fn plus_and_slash_mean_what_their_place_says() {
    assert_eq!(condition("a + [b + c > d / 2] + 3s/e"), "(or (or a (predicate (> (+ b c) (/ d 2)))) (delay 3000ms e))");
    // Parentheses within brackets are arithmetic, outside they are conditions.
    assert_eq!(condition("(a + b) and [(a + b) > 1]"), "(and (paren (or a b)) (predicate (> (paren (+ a b)) 1)))");
}

#[test]
fn an_assignment_of_a_step_says_when() {
    let text = "step 1 { A  C := C + 1  B  D := 2 }\nstep 2 { E := 3 }";
    assert_eq!(
        faults(text),
        [
            "E0108 1:13-22 the assignment of `C` does not say when it is done",
            "E0108 2:10-15 the assignment of `E` does not say when it is done",
        ]
    );
    // Within one step it is one mistake, and every place of it is shown.
    let (_, said) = grafc_syntax::parse(grafc_diagnostics::FileId::new(0), text);
    let others: Vec<&str> = said.iter().flat_map(|d| &d.secondary).map(|label| &text[label.span.range()]).collect();
    assert_eq!(others, ["D := 2"]);
}

#[test]
fn allowances() {
    let (_, Item::Allow(allow)) = only("allow W0409 \"say \"\"go\"\"\"") else { panic!("an allowance was written") };
    assert_eq!((allow.code.text.as_str(), allow.about.is_none()), ("W0409", true));
    assert_eq!(allow.reason.text, "say \"go\"");
    let (_, Item::Allow(allow)) = only("allow W0401 `V 1` \"r\"") else { panic!("an allowance was written") };
    assert_eq!(allow.about.map(|name| name.text).as_deref(), Some("V 1"));
    let (_, step) = step("step 1 { V allow W0409 \"r\" W if a allow W0410 \"s\" }");
    assert_eq!((step.actions.len(), step.allows.len()), (2, 2));
    let (_, transition) = transition("transition 1 -> 2 : a { C := C + 1 allow W0409 \"r\" }");
    assert_eq!((transition.actions().len(), transition.allows().len()), (1, 1));
    let beside = chart("input a : bool allow W0401 a \"r\" transition 1 -> 2 : a allow W0409 \"r\" step 1");
    assert_eq!(beside.items.len(), 5);
}

#[test]
fn allow_is_a_name_where_it_always_was() {
    let text = "input allow, W1 : bool output V : bool initial step allow { V } step 2 { allow W1 } step 3
        transition allow -> 2 : allow { W1 := allow  C := 2 } transition 2, allow -> 3 : not allow and a
        transition 3 -> allow : 1s/allow + allow grafcet allow { step 4 { allow } }";
    let chart = chart(text);
    assert_eq!(chart.items.iter().filter(|item| matches!(item, Item::Allow(_))).count(), 0);
    let (_, step) = step("step 2 { allow W1 allow W0409 \"r\" }");
    assert_eq!((step.actions.len(), step.allows.len()), (2, 1));
}

#[test]
fn scenarios() {
    let text = "scenario \"one batch\" {
        0s : a = 0, n = -3, on_time = 1s500ms
        1s :
        after 8s : TD = 1 ↑, b = TRUE -> not BM, X2, n = 16#F
        until X11 and [n > 3] within 1min -> MR
    }";
    let (_, Item::Scenario(scenario)) = only(text) else { panic!("a scenario was written") };
    assert_eq!(scenario.name.text, "one batch");
    let shape = |line: &ScenarioLine| match &line.kind {
        ScenarioLineKind::At { is_after, given, .. } => (*is_after, given.len(), line.expected.len()),
        ScenarioLineKind::Until { .. } => (false, 9, line.expected.len()),
    };
    assert_eq!(
        scenario.lines.iter().map(shape).collect::<Vec<_>>(),
        [(false, 3, 0), (false, 0, 0), (true, 2, 3), (false, 9, 1)]
    );
    let ScenarioLineKind::At { given, .. } = &scenario.lines[2].kind else { panic!("a line with a time") };
    assert_eq!(given.iter().map(|given| given.pulse.is_some()).collect::<Vec<_>>(), [true, false]);
    let values: Vec<bool> = scenario.lines[2].expected.iter().map(|e| matches!(e.value, Expected::Value(_))).collect();
    assert_eq!(values, [false, false, true]);
    let (_, Item::Scenario(empty)) = only("scenario \"s\" { }") else { panic!("a scenario was written") };
    assert!(empty.lines.is_empty());
}

/// Each of its words stands as a name wherever a name must.
#[test]
fn the_words_of_scenarios_are_names_elsewhere() {
    let text = "input scenario, until, within, after : bool output V : bool initial step scenario \"c\" { V }
        step until { after if within } transition scenario -> until : scenario and until or within
        transition until -> scenario : 3s/after grafcet scenario \"g\" { step after }
        scenario \"words\" { 0s : until = 1, after = 0, within = 1 ↑ -> until, after, not within
            1s : until until within 1s -> after after 2s : after = 1 until within and within within 3s
            until after or scenario within 5s 4s : within = 0 -> scenario, within }";
    let chart = chart(text);
    let scenarios: Vec<usize> = chart
        .items
        .iter()
        .filter_map(|item| if let Item::Scenario(s) = item { Some(s.lines.len()) } else { None })
        .collect();
    // 0s; 1s; until; after 2s; until; until; 4s
    assert_eq!(scenarios, [7]);
}

#[test]
fn every_construct_at_once() {
    let text = include_str!("samples/every_construct.gct");
    let chart = chart(text);
    assert_eq!(chart.items.len(), 20);
    assert_eq!(chart.comments.len(), 5);
    assert_eq!(chart.span.range(), 0..text.len());
}

/// What the heading chooses, as written.
fn options(text: &str) -> Vec<(&'static str, String)> {
    let chart = chart(text);
    let chosen = chart.heading.map(|heading| heading.options).unwrap_or_default();
    chosen.iter().map(|option| (option.kind.word(), text[option.span.range()].to_owned())).collect()
}

#[test]
fn the_heading_chooses() {
    let text = "chart M \"a comment\" evolution scan initial_actions on bound 16#FF step 1";
    let expected = [
        ("evolution", "evolution scan".to_owned()),
        ("initial_actions", "initial_actions on".to_owned()),
        ("bound", "bound 16#FF".to_owned()),
    ];
    assert_eq!(options(text), expected);
    assert_eq!(options("chart evolution bound 7 step 1"), [("bound", "bound 7".to_owned())]);
    assert_eq!(options("chart bound input evolution, scan, each : bool step 1 { evolution each scan }"), []);
}

#[test]
fn each_scan() {
    let text = "chart M evolution scan step 1 { n := n + 1 each scan  m := 2 each scan if a or b  each  scan }";
    let chart = chart(text);
    let Some(Item::Step(step)) = chart.items.first() else { panic!("a step") };
    let written: Vec<&str> = step.actions.iter().map(|action| &text[action.span.range()]).collect();
    assert_eq!(written, ["n := n + 1 each scan", "m := 2 each scan if a or b", "each", "scan"]);
}
