//! Every name is known by what it declares or refers to, also in a chart with errors.

mod support;

use grafc_diagnostics::{FileId, Span};
use grafc_model::chart::{StepId, VariableId};
use grafc_model::symbols::{Entity, Form, Mention, Role, Symbols};
use grafc_model::{Checked, examine};
use support::{annotated, placed};

fn examined(text: &str) -> Checked {
    examine(&grafc_syntax::parse(FileId::new(0), text).0, "chart")
}

/// What an entity is called, by its kind and the text that declares it.
fn called(text: &str, symbols: &Symbols, entity: Entity) -> String {
    let definition = symbols.definition(entity).expect("what is referred to is declared");
    let name = definition.name.map_or("it", |name| &text[name.range()]);
    let kind = match entity {
        Entity::Chart => "chart",
        Entity::Variable(_) => "variable",
        Entity::Grafcet(_) => "grafcet",
        Entity::Step(_) => "step",
        Entity::Macro(_) => "macro",
        Entity::Transition(_) => "transition",
    };
    format!("{kind} {name}")
}

/// All names of a text, declarations as `= kind`, uses as what they refer to and how, and what refers to nothing.
fn check(text: &str) {
    let symbols = examined(text).symbols;
    let mut found: Vec<(Span, String)> = Vec::new();
    for definition in symbols.definitions() {
        let what = called(text, &symbols, definition.entity);
        let kind = what.split(' ').next().expect("there is a first word");
        found.extend(definition.name.map(|name| (name, format!("= {kind}"))));
    }
    for found_use in symbols.uses() {
        let form = match found_use.form {
            Form::Name => "",
            Form::Activity => "activity of ",
            Form::Duration => "duration of ",
            Form::Frozen => "freezing of ",
        };
        let role = match found_use.role {
            Role::Read => "read",
            Role::Assigned => "assigned",
            Role::Before => "before",
            Role::After => "after",
            Role::Forced => "forced",
            Role::Commanded => "commanded",
            Role::Parent => "parent",
            Role::Enclosing => "enclosing",
            Role::Expanded => "expanded",
            Role::Allowed => "allowed",
        };
        found.push((found_use.span, format!("{form}{}, {role}", called(text, &symbols, found_use.entity))));
    }
    for missing in symbols.unresolved() {
        found.push((missing.span, format!("no {:?}", missing.wanted)));
    }
    let unmarked = |line: &str| !line.trim_start().starts_with("//");
    assert_eq!(placed(text, found), annotated(text), "{}", text.lines().filter(|l| unmarked(l)).collect::<String>());
}

#[test]
fn variables() {
    check(
        "
        chart Mill
        //    ^^^^ = chart
        input a, `b c` : bool
        //    ^ = variable
        //       ^^^^^ = variable
        const N : int := 2
        //    ^ = variable
        const t : time := N * 3s
        //    ^ = variable
        //                ^ variable N, read
        output V : bool
        //     ^ = variable
        var n : int := N + 1
        //  ^ = variable
        //             ^ variable N, read
        initial step 1 { V if a and `b c` n := n + N on event ↑a }
        //           ^ = step
        //               ^ variable V, assigned
        //                    ^ variable a, read
        //                          ^^^^^ variable `b c`, read
        //                                ^ variable n, assigned
        //                                     ^ variable n, read
        //                                         ^ variable N, read
        //                                                     ^ variable a, read
        transition (t1) 1 -> 1 : t/a/3s or [n > (N)] { n := 0 }
        //          ^^ = transition
        //              ^ step 1, before
        //                   ^ step 1, after
        //                       ^ variable t, read
        //                         ^ variable a, read
        //                                  ^ variable n, read
        //                                       ^ variable N, read
        //                                             ^ variable n, assigned
        ",
    );
}

#[test]
fn labels() {
    check(
        "
        grafcet G1 {
        //      ^^ = grafcet
            initial enclosing step 9 { force G2{2, 3} force G2{*} }
            //                     ^ = step
            //                               ^^ grafcet G2, forced
            //                                  ^ step 2, forced
            //                                     ^ step 3, forced
            //                                              ^^ grafcet G2, forced
            macro step M4
            //         ^^ = macro
            transition 9 -> M4 : XG2 · X3
            //         ^ step 9, before
            //              ^^ macro M4, after
            //                   ^^^ activity of grafcet G2, read
            //                         ^^ activity of step 3, read
            transition M4 -> 9 : XM4 and [T3 > 2s] or 3s/X9
            //         ^^ macro M4, before
            //               ^ step 9, after
            //                   ^^^ activity of macro M4, read
            //                            ^^ duration of step 3, read
            //                                           ^^ activity of step 9, read
        }
        expansion M4 { step E4 step S4 transition E4 -> S4 : 1 }
        //        ^^ macro M4, expanded
        //                  ^^ = step
        //                          ^^ = step
        //                                        ^^ step E4, before
        //                                              ^^ step S4, after
        grafcet G2 { initial step 2 step 3 }
        //      ^^ = grafcet
        //                        ^ = step
        //                               ^ = step
        grafcet X9/G3 { activated step 5 }
        //      ^^ activity of step 9, enclosing
        //         ^^ = grafcet
        //                             ^ = step
        ",
    );
}

#[test]
fn children_and_pulse_orders() {
    check(
        "
        input a : bool
        //    ^ = variable
        grafcet MAIN {
        //      ^^^^ = grafcet
          initial step 1 { run P freeze P on event ↑a }
        //             ^ = step
        //                     ^ grafcet P, commanded
        //                              ^ grafcet P, commanded
        //                                          ^ variable a, read
          transition 1 -> 1 : FP and not XP { start P resume Q }
        //           ^ step 1, before
        //                ^ step 1, after
        //                    ^^ freezing of grafcet P, read
        //                               ^^ activity of grafcet P, read
        //                                          ^ grafcet P, commanded
        //                                                   ^ no Grafcet
        }
        child grafcet P of MAIN { initial step 10 }
        //            ^ = grafcet
        //                 ^^^^ grafcet MAIN, parent
        //                                     ^^ = step
        child grafcet R of NONE { initial step 20 }
        //            ^ = grafcet
        //                 ^^^^ no Grafcet
        //                                     ^^ = step
        ",
    );
}

#[test]
fn allowances() {
    check(
        "
        input a : bool
        //    ^ = variable
        allow W0401 a \"why\"
        //          ^ variable a, allowed
        allow W0401 b \"why\"
        //          ^ no Declaration
        initial step 1
        //           ^ = step
        ",
    );
}

#[test]
fn names_that_refer_to_nothing() {
    check(
        "
        input a : bool
        //    ^ = variable
        grafcet X7/G1 { initial step 1 { W V := a + k on activation force G5{1, 8} }
        //      ^^ no EnclosingStep
        //         ^^ = grafcet
        //                           ^ = step
        //                               ^ no Target
        //                                 ^ no Target
        //                                      ^ variable a, read
        //                                          ^ no Value
        //                                                                ^^ no Grafcet
        //                                                                   ^ step 1, forced
        //                                                                      ^ no Step
            transition 1 -> 6 : b or a/c }
            //         ^ step 1, before
            //              ^ no Step
            //                  ^ no Value
            //                       ^ variable a, read
        expansion M3 { }
        //        ^^ no MacroStep
        ",
    );
}

#[test]
fn of_two_declarations_names_refer_to_the_first() {
    let text = "input a : bool var a : int initial step 1 transition 1 -> 1 : a";
    let symbols = examined(text).symbols;
    let uses: Vec<&str> =
        symbols.uses_of(Entity::Variable(VariableId::new(0))).map(|u| &text[u.span.range()]).collect();
    assert_eq!(uses, ["a"]);
    assert_eq!(symbols.uses_of(Entity::Variable(VariableId::new(1))).count(), 0);
    assert_eq!(symbols.definition(Entity::Variable(VariableId::new(1))).unwrap().name.unwrap().start, 19);
}

#[test]
fn the_whole_of_a_declaration() {
    let text = "input a, b : bool initial step 1 { } transition 1 -> : a";
    let symbols = examined(text).symbols;
    let wholes: Vec<&str> = symbols.definitions().iter().map(|d| &text[d.whole.range()]).collect();
    assert_eq!(wholes, ["input a, b : bool", "input a, b : bool", text, "initial step 1 { }", "transition 1 -> : a"]);
}

#[test]
fn what_is_named_at_a_place() {
    let text = "input ab : bool initial step 1 transition 1 -> 2 : ab";
    let symbols = examined(text).symbols;
    let at = |byte: u32| match symbols.at(byte) {
        Some(Mention::Definition(definition)) => format!("= {:?}", definition.entity),
        Some(Mention::Use(found)) => format!("{:?}", found.entity),
        Some(Mention::Unresolved(missing)) => format!("{:?}", missing.wanted),
        None => String::new(),
    };
    let (a, one) = (Entity::Variable(VariableId::new(0)), Entity::Step(StepId::new(0)));
    assert_eq!([at(5), at(6), at(8), at(9)], ["", &format!("= {a:?}"), &format!("= {a:?}"), ""]);
    assert_eq!([at(41), at(42), at(43), at(44)], ["", &format!("{one:?}"), &format!("{one:?}"), ""]);
    assert_eq!([at(47), at(48)], ["Step", "Step"]);
    assert_eq!([at(51), at(53), at(54)], [format!("{a:?}"), format!("{a:?}"), String::new()]);
}

/// What is faulty is missing, and all the rest is there.
#[test]
fn a_chart_as_far_as_it_goes() {
    let checked = examined(
        "input a : bool output V : bool
         initial step 1 { V W } step 2 macro step M3 step 2
         transition 1 -> 2, 8 : a and nope transition 2 -> M3 : a",
    );
    assert!(checked.chart().is_none());
    let tables = checked.tables();
    assert_eq!((tables.variables.len(), tables.steps.len(), tables.macro_steps.len()), (2, 3, 1));
    assert_eq!(tables.continuous.len(), 1, "W is not declared");
    assert_eq!(tables.macro_steps[0].entry, None);
    let arcs: Vec<(usize, usize)> = tables.transitions.iter().map(|t| (t.pre.len(), t.post.len())).collect();
    assert_eq!(arcs, [(1, 1), (1, 1)], "there is no step 8");
    assert_eq!(checked.into_chart().0.map(|chart| chart.steps.len()), None);
}

#[test]
fn macro_steps_that_hold_each_other_do_not_go_round() {
    let checked = examined(
        "initial step 1 expansion M3 { step E3 step S3 macro step M4 } expansion M4 { step E4 step S4 macro step M3 }",
    );
    assert!(checked.chart().is_none());
    for mut at in checked.tables().macro_steps.indices().map(Some) {
        for _ in 0..3 {
            at = at.and_then(|id| checked.tables().macro_steps[id].expansion_of);
        }
        assert_eq!(at, None);
    }
}

#[test]
fn grafcets_in_a_circle_are_all_there() {
    let checked = examined(
        "grafcet G1 { initial step 1 { force G2{} } } grafcet G2 { initial step 2 { force G1{} } }
         grafcet G3 { initial step 3 }",
    );
    let names: Vec<&str> =
        checked.tables().hierarchy.iter().map(|&g| checked.tables().grafcets[g].name.as_ref()).collect();
    assert_eq!(names, ["G3", "G1", "G2"]);
}
