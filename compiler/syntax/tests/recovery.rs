//! Each mistake gives one message at its place, and the rest of the chart is still read.

mod common;

use common::faults;
use grafc_diagnostics::FileId;
use grafc_syntax::ast::{Chart, ExprKind, Item};

/// `1 2` for steps, `1->2` for transitions, `G(…)` for blocks.
fn outline(text: &str) -> String {
    fn write(items: &[Item]) -> String {
        let one = |item: &Item| match item {
            Item::Declaration(d) => d.names.iter().map(|n| n.name.text.as_str()).collect::<Vec<_>>().join(","),
            Item::Grafcet(g) => format!("{}({})", g.name.text, write(&g.items)),
            Item::Expansion(e) => format!("{}({})", e.macro_step.text, write(&e.items)),
            Item::Allow(a) => format!("allow {}", a.code.text),
            Item::Claim(c) => format!("{}:{}", c.kind.keyword(), c.written),
            Item::Scenario(s) => format!("scenario {}", s.name.text),
            Item::Step(s) => format!("{}{}", s.label.text, "'".repeat(s.actions.len())),
            Item::Transition(t) => {
                let list = |names: &[grafc_syntax::ast::Name]| {
                    names.iter().map(|n| n.text.clone()).collect::<Vec<_>>().join(",")
                };
                format!("{}->{}", list(&t.from), list(&t.to))
            }
        };
        items.iter().map(one).collect::<Vec<_>>().join(" ")
    }
    write(&parse(text).items)
}

fn parse(text: &str) -> Chart {
    grafc_syntax::parse(FileId::new(0), text).0
}

#[test]
fn five_unrelated_mistakes_give_five_errors() {
    let text = "\
chart Demo
input a, b bool
grafcet G1 {
  initial step 1 { V
  step 2 { W }
  transition 1 -> 2 : a b
  transition 2 - > 1 : b
  transition 2 -> 1 : a and
  step 3 { W if }
  step 4
}
input c : bool
";
    assert_eq!(
        faults(text),
        [
            "E0107 2:12-15 expected `:`, `,` or an attached comment, found `bool`",
            "E0107 4:18 this `{` is never closed",
            "E0107 6:25 expected an operator, `{` or the next item, found `b`",
            "E0107 7:16 expected `->` or `,`, found `-`",
            "E0107 8:^28 expected a condition, found `step`",
            "E0107 9:17 expected a condition, found `}`",
        ]
    );
    assert_eq!(outline(text), "G1(1 2' 1->2 2->1 3 4) c");
}

#[test]
fn an_unreadable_condition_keeps_its_transition() {
    let chart = parse("transition 1 -> 2 : a and or b { C := 1 }\nstep 3");
    let Some(Item::Transition(transition)) = chart.items.first() else { panic!("{:?}", chart.items) };
    assert_eq!(chart.exprs[transition.condition].kind, ExprKind::Error);
    assert_eq!((chart.items.len(), chart.exprs.len()), (2, 1));
}

#[test]
fn an_unclosed_brace_is_one_error() {
    let text = "grafcet G1 {\n  step 1 { V\n  step 2 { V }\n}\ngrafcet G2 {\n  step 3\n}\n";
    assert_eq!(faults(text), ["E0107 2:10 this `{` is never closed"]);
    assert_eq!(outline(text), "G1(1 2') G2(3)");

    // The last step of a block: the indentation tells whose the `}` is.
    let text = "grafcet G1 {\n  step 1 { V }\n  step 2 { W\n}\ninput a : bool\n";
    assert_eq!(faults(text), ["E0107 3:10 this `{` is never closed"]);
    assert_eq!(outline(text), "G1(1' 2) a");

    let text = "grafcet G1 {\n  step 1\n\ngrafcet G2 {\n  step 2\n}\n";
    assert_eq!(faults(text), ["E0107 1:12 the `{` of `grafcet G1` is never closed"]);
    assert_eq!(outline(text), "G1(1) G2(2)");

    let text = "grafcet G1 {\n  expansion M1 {\n    step 1\n}\n";
    assert_eq!(faults(text), ["E0107 1:12 the `{` of `grafcet G1` is never closed"]);
    assert_eq!(outline(text), "G1(M1(1))");

    let text = "grafcet G1 {\n  step 1\n";
    assert_eq!(faults(text), ["E0107 1:12 the `{` of `grafcet G1` is never closed"]);

    let text = "step 1 { force G1{1, 2 }\nstep 2";
    assert_eq!(faults(text), ["E0107 1:8 this `{` is never closed"]);
}

#[test]
fn a_brace_too_many_is_one_error() {
    let text = "grafcet G1 {\n  step 1 { V }}\n  step 2\n}\ngrafcet G2 { step 3 }\n";
    assert_eq!(faults(text), ["E0107 2:15 expected an item, found a `}` without its `{`"]);
    assert_eq!(outline(text), "G1(1' 2) G2(3)");
    assert_eq!(
        faults("step 1 }}}}\nstep 2 }"),
        [
            "E0107 1:8 expected an item, found a `}` without its `{`",
            "E0107 2:8 expected an item, found a `}` without its `{`",
        ]
    );
}

#[test]
fn a_forgotten_opening_brace_is_one_error() {
    let text = "grafcet G1 {\n  step 1 V }\n  step 2\n}\n";
    assert_eq!(faults(text), ["E0107 2:10 expected `{`, an attached comment or the next item, found `V`"]);
    assert_eq!(outline(text), "G1(1 2)");
    let text = "grafcet G1\n  step 1\n}\ngrafcet { step 2 }\nexpansion M1 foo { step E1 }";
    assert_eq!(
        faults(text),
        [
            "E0107 1:^11 expected `{` or an attached comment, found `step`",
            "E0107 4:9 expected a name, found `{`",
            "E0107 5:14-16 expected `{` or an attached comment, found `foo`",
        ]
    );
    assert_eq!(outline(text), "G1(1) (2) M1(E1)");
}

#[test]
fn items_in_wrong_places() {
    assert_eq!(
        faults("grafcet G1 { step 1 grafcet X1/G2 { step 2 } step 3 }\nstep 4"),
        ["E0107 1:21-27 `grafcet` cannot stand inside `grafcet G1`"]
    );
    let text = "grafcet G1 { step 1 var a : int step 2 var b : int step 3 }";
    assert_eq!(faults(text), ["E0107 1:21-23 `var` cannot stand inside `grafcet G1`"]);
    assert_eq!(outline(text), "a b G1(1 2 3)");
    assert_eq!(faults("input a : bool\nchart C"), ["E0107 2:1-7 the heading of the chart is not its first item"]);
    assert_eq!(
        faults("chart A\nchart B\nfoo bar { baz }\nstep 1"),
        [
            "E0107 2:1-7 the heading of the chart is not its first item",
            // What follows a heading on the next line belongs to it.
            "E0107 3:1-3 expected an attached comment, `evolution`, `initial_actions`, `bound` or the next item, found `foo`",
        ]
    );
    assert_eq!(
        faults("foo bar { baz }\nstep 1 { A } qux"),
        [
            "E0107 1:1-3 expected an item such as `input`, `step` or `transition`, found `foo`",
            "E0107 2:14-16 expected an item such as `input`, `step` or `transition`, found `qux`",
        ]
    );
}

#[test]
fn reserved_words_as_names_are_one_error() {
    let text = "input step : bool\ninput on : bool\noutput V : bool\n";
    assert_eq!(
        faults(text),
        ["E0107 1:7-10 expected a name, found `step`", "E0107 2:7-8 expected a name, found `on`",]
    );
    let (_, diagnostics) = grafc_syntax::parse(FileId::new(0), text);
    for diagnostic in &diagnostics {
        assert!(diagnostic.help.as_ref().is_some_and(|h| h.contains("backquotes")), "{diagnostic:?}");
    }
}

#[test]
fn what_was_expected_is_said_in_words() {
    for (text, message) in [
        ("step { A }", "E0107 1:6 expected a step label, found `{`"),
        ("step 16#FF", "E0107 1:6-10 expected a step label, found `16#FF`"),
        ("initial transition 1 -> 2 : a", "E0107 1:9-18 expected `step`, found `transition`"),
        ("initial initial step 1", "E0107 1:9-15 `initial` appears twice before `step`"),
        ("macro enclosing step 1", "E0107 1:7-15 a step is either an enclosing step or a macro-step"),
        ("transition 1 2 : a", "E0107 1:14 expected `->` or `,`, found `2`"),
        ("transition 1 -> 2", "E0107 1:^18 expected `:` or `,`, found the end of the text"),
        ("transition : a", "E0107 1:12 expected the steps before `->`, found `:`"),
        ("transition (1 1 -> 2 : a", "E0107 1:15 expected `)`, found `1`"),
        ("transition 1 -> 2 : (a or b", "E0107 1:^28 expected an operator or `)`, found the end of the text"),
        ("transition 1 -> 2 : [a", "E0107 1:^23 expected an operator or `]`, found the end of the text"),
        ("transition 1 -> 2 : a)", "E0107 1:22 expected an operator, `{` or the next item, found `)`"),
        ("transition 1 -> 2 : 3s/", "E0107 1:^24 expected a duration, a variable or `(`, found the end of the text"),
        ("transition 1 -> 2 : ↑not a", "E0107 1:22-24 expected a name, `(` or `[`, found `not`"),
        ("transition 1 -> 2 : a/b/c/d", "E0107 1:26 expected an operator, `{` or the next item, found `/`"),
        ("transition 1 -> 2 : 3/a", "E0107 1:21 expected a duration or a variable, found the number `3`"),
        ("transition 1 -> 2 : a { C := 1 on activation }", "E0107 1:32-33 expected a name or `}`, found `on`"),
        ("transition 1 -> 2 : a { V }", "E0107 1:27 expected `:=`, found `}`"),
        ("step 1 { C := }", "E0107 1:15 expected a value, found `}`"),
        ("step 1 { C := 1 on }", "E0107 1:20 expected `activation`, `deactivation` or `event`, found `}`"),
        ("step 1 { force 1{} }", "E0107 1:16 expected a name, found `1`"),
        ("step 1 { force G1 }", "E0107 1:19 expected `{`, found `}`"),
        ("step 1 { V, W }", "E0107 1:11 expected an action, `:=`, `if` or `}`, found `,`"),
        ("var a", "E0107 1:^6 expected `:`, `,` or an attached comment, found the end of the text"),
        ("var a :", "E0107 1:^8 expected a type, found the end of the text"),
        ("var a : BOOL", "E0107 1:9-12 expected a type, found `BOOL`"),
        ("var a : int = 3", "E0107 1:13 expected `:=`, `at` or the next item, found `=`"),
        ("var a : int := 3 at IX0", "E0107 1:18-19 expected an operator, `at` or the next item, found `at`"),
        ("transition 1 -> 2 : [a < b < c]", "E0107 1:28 expected an operator or `]`, found `<`"),
        ("allow W0409", "E0107 1:^12 expected a reason in quotation marks, found the end of the text"),
        ("allow W0409 step 1", "E0107 1:13-16 expected a reason in quotation marks, found `step`"),
        ("allow W0409 \" \"", "E0107 1:13-15 the reason is empty"),
        ("step 1 { allow W0409 \"\" }", "E0107 1:22-23 the reason is empty"),
        ("Step 1", "E0107 1:1-4 expected an item such as `input`, `step` or `transition`, found `Step`"),
    ] {
        assert_eq!(faults(text), [message], "{text}");
    }
}

#[test]
fn a_lexical_fault_is_not_reported_twice() {
    for text in [
        "transition 1 -> 2 : a $ b",
        "transition 1 -> $ : a",
        "transition 1 -> 2 : a and $",
        "transition 1 -> 2 : 3sec/a",
        "step 3x { A }",
        "grafcet G \"main { step 1 }\nstep 2",
        "step 1 { V; W }",
        "var a : int := 1.2.3 at %MW0",
        "step 1 { force `G{} }",
        "grafcet G { (* step 1 }",
        "$$$ foo\nstep 1",
    ] {
        let found = faults(text);
        assert_eq!(found.len(), 1, "{text}: {found:?}");
        assert!(!found[0].starts_with("E0107"), "{text}: {found:?}");
    }
}

#[test]
fn the_number_of_messages_is_bounded() {
    let text = "step step\n".repeat(5_000) + &"$ 3x ".repeat(5_000);
    let (_, diagnostics) = grafc_syntax::parse(FileId::new(0), &text);
    assert_eq!(diagnostics.iter().count(), 400);
    assert!(diagnostics.iter().any(|d| d.notes.iter().any(|n| n.ends_with("more syntax errors"))));
}

/// A semicolon within an assignment ends nothing: it is a mistake of its own.
#[test]
fn a_semicolon_within_an_assignment_without_an_event() {
    assert_eq!(
        faults("var I : int\ninitial step 1 {\n  I := 1 + ;o n\n}\n"),
        ["E0108 3:3-13 the assignment of `I` does not say when it is done", "E0101 3:12 unexpected character `;`"]
    );
}

/// What cannot stand there is not asked for its name.
#[test]
fn a_block_without_a_name_inside_another() {
    let text = "grafcet G1 {\n  initial step 1\n  grafcet {\n    step 2\n    transition 1 -> 2 : a\n  }\n}\n";
    assert_eq!(faults(text), ["E0107 3:3-9 `grafcet` cannot stand inside `grafcet G1`"]);
}
