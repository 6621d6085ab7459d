//! The rules about what may happen at once: for each a chart that breaks it and the nearest one that does not.

use grafc_diagnostics::{Code, Diagnostic, Diagnostics, FileId};

/// What is said of what may happen at once. The charts of these tests are not made to go round, or to come to rest.
fn diagnostics(text: &str) -> Diagnostics {
    let mut diagnostics = all(text);
    diagnostics.retain(|d| d.code <= Code::W0413);
    diagnostics
}

fn all(text: &str) -> Diagnostics {
    let (tree, diagnostics) = grafc_syntax::parse(FileId::default(), text);
    assert!(!diagnostics.has_errors(), "{diagnostics:?}");
    let (chart, diagnostics) = grafc_model::check(&tree, "chart");
    let mut net = grafc_net::build(&chart.unwrap_or_else(|| panic!("{diagnostics:?}")));
    let mut diagnostics = Diagnostics::new();
    grafc_net::passes::run(&mut net, false, &mut diagnostics);
    assert!(diagnostics.is_empty(), "{diagnostics:?}");
    grafc_logic::warn(&grafc_logic::Analysis::new(net))
}

fn codes(text: &str) -> Vec<&'static str> {
    diagnostics(text).iter().map(|d| d.code.as_str()).collect()
}

/// The only message, which has this code.
fn only(code: &str, text: &str) -> Diagnostic {
    let diagnostics = diagnostics(text);
    assert_eq!(diagnostics.iter().map(|d| d.code.as_str()).collect::<Vec<_>>(), [code], "{text}");
    diagnostics.iter().next().cloned().unwrap_or_else(|| unreachable!("there is one"))
}

#[track_caller]
fn warns(code: &str, text: &str) {
    assert_eq!(codes(text), [code], "{text}");
}

#[track_caller]
fn silent(text: &str) {
    assert_eq!(codes(text), [""; 0], "{text}");
}

/// The piece of the text that a message is about.
fn place<'t>(diagnostic: &Diagnostic, text: &'t str) -> &'t str {
    piece(diagnostic.primary.span, text)
}

fn piece(span: grafc_diagnostics::Span, text: &str) -> &str {
    &text[span.start as usize..span.end as usize]
}

/// The other pieces of the text that it shows.
fn others<'t>(diagnostic: &Diagnostic, text: &'t str) -> Vec<&'t str> {
    diagnostic.secondary.iter().map(|label| piece(label.span, text)).collect()
}

mod w0409 {
    use super::*;

    /// A selection after step 1 with these two conditions.
    fn selection(a: &str, b: &str) -> String {
        format!(
            "input a, b, c : bool  input n : int  input x : real  initial step 1  step 2  step 3
             transition 1 -> 2 : {a}  transition 1 -> 3 : {b}  transition 2 -> 1 : c  transition 3 -> 1 : c"
        )
    }

    /// The case in which both are said to hold.
    fn case(a: &str, b: &str) -> Option<String> {
        let found = only("W0409", &selection(a, b));
        let case = found.notes.iter().find_map(|note| note.strip_prefix("their conditions "));
        case.map(str::to_owned)
    }

    #[test]
    fn the_places_and_the_case() {
        let text = selection("a", "b");
        let found = only("W0409", &text);
        assert_eq!(place(&found, &text), "transition 1 -> 3 : b");
        assert_eq!(others(&found, &text), ["transition 1 -> 2 : a", "1"]);
        assert!(found.message.contains("step `1`"), "{}", found.message);
        assert_eq!(case("a", "b").as_deref(), Some("both hold if `a` and `b` are true"));
    }

    #[test]
    fn cases_in_words() {
        let cases = [
            ("a", "not b", "both hold if `a` is true and `b` is false"),
            ("not a", "not b", "both hold if `a` and `b` are false"),
            ("a", "a", "both hold if `a` is true"),
            ("↑a", "b", "both hold if `↑a` and `b` are true"),
            ("↑a", "a", "both hold if `↑a` is true"),
            ("a", "a and 3s/X1", "both hold if `a` and `3s/X1` are true"),
            ("[n > 3]", "[n < 5]", "both hold if `[n > 3]` and `[n < 5]` are true"),
            ("true", "1", "hold in any case"),
        ];
        for (a, b, expected) in cases {
            assert_eq!(case(a, b).as_deref(), Some(expected), "{a} | {b}");
        }
        // The first way out of a disjunction is closed, because `a` would have to be false as well.
        assert_eq!(case("a", "not a or b").as_deref(), Some("both hold if `a` and `b` are true"));
        // Nor can `n` be more than 3 and less than 2.
        assert_eq!(
            case("[n > 3]", "[n < 2] or b").as_deref(),
            Some("both hold if `[n > 3]` and `b` are true and `[n < 2]` is false")
        );
        assert_eq!(case("a xor b", "a").as_deref(), Some("both hold if `a` is true and `b` is false"));
    }

    #[test]
    fn conditions_that_exclude_each_other() {
        for (a, b) in [
            ("a", "not a"),
            ("a", "b and not a"),
            ("↑a", "↓a"),
            ("↑a", "b and not a"),
            ("a and b", "not a or not b"),
            ("a xor b", "a and b"),
            ("3s/a", "not a"),
            ("[n > 3]", "[n <= 3]"),
            ("[n = 3]", "[n = 4]"),
            ("a", "0"),
        ] {
            silent(&selection(a, b));
        }
    }

    #[test]
    fn an_off_delay_outlasts_its_operand() {
        warns("W0409", &selection("a/3s", "not a"));
    }

    #[test]
    fn the_same_steps_before_and_after() {
        silent(
            "input a, b : bool  initial step 1  step 2
             transition 1 -> 2 : a  transition 1 -> 2 : b  transition 2 -> 1 : not a and not b",
        );
        // A self-loop keeps the step active while the other transition leaves it.
        warns(
            "W0409",
            "input a, b : bool  initial step 1  step 2
             transition 1 -> 1 : a  transition 1 -> 2 : b  transition 2 -> 1 : not a and not b",
        );
    }

    #[test]
    fn other_steps_before_that_exclude_each_other() {
        let chart = |second: &str| {
            format!(
                "input a, b, c : bool  initial step 1  step 2  initial step 10  step 11  step 12
                 transition 10 -> 11 : a  transition 11 -> 10 : c
                 transition 1, 10 -> 2 : b and not a  transition 1, {second} -> 12 : b and not c"
            )
        };
        // Steps 10 and 11 hold one token.
        silent(&chart("11"));
        // The first two transitions out of step 10 and the last one may meet, too.
        assert_eq!(codes(&chart("10")), ["W0409", "W0409"]);
    }

    #[test]
    fn activities_of_steps_that_exclude_each_other() {
        let chart = |a: &str, b: &str| {
            format!(
                "input a : bool  initial step 1  step 2  step 3  initial step 10  step 11
                 transition 10 -> 11 : a  transition 11 -> 10 : not a
                 transition 1 -> 2 : {a}  transition 1 -> 3 : {b}"
            )
        };
        silent(&chart("X10", "X11"));
        warns("W0409", &chart("X10", "not X11"));
        // Step 1 is active while they are looked at.
        warns("W0409", &chart("X1", "X10"));
        silent(&chart("X2 and X10", "X10 and not X2"));
    }

    #[test]
    fn one_warning_a_step_with_four_transitions_at_most() {
        let text = "input a, b, c, d, e : bool  initial step 1  step 2  step 3  step 4  step 5  step 6
                    transition 1 -> 2 : a  transition 1 -> 3 : b  transition 1 -> 4 : c
                    transition 1 -> 5 : d  transition 1 -> 6 : e";
        let found = only("W0409", text);
        let transitions = others(&found, text).into_iter().filter(|t| t.starts_with("transition")).count();
        assert_eq!(transitions, 3);
    }

    #[test]
    fn transitions_that_share_two_steps_are_named_once() {
        warns(
            "W0409",
            "input a, b : bool  initial step 1  initial step 2  step 3  step 4
             transition 1, 2 -> 3 : a  transition 1, 2 -> 4 : b",
        );
    }

    #[test]
    fn after_a_macro_step() {
        let text = "input a, b, c : bool  initial step 1  macro step M2  step 3
                    transition 1 -> M2 : c  transition M2 -> 1 : a  transition M2 -> 3 : b
                    expansion M2 { step E2  step S2  transition E2 -> S2 : c }";
        let found = only("W0409", text);
        assert!(found.message.contains("step `S2` (exit of `M2`)"), "{}", found.message);
        assert_eq!(others(&found, text), ["transition M2 -> 1 : a", "S2"]);
    }

    #[test]
    fn parallel_sequences_are_no_selection() {
        silent(
            "input a : bool  initial step 1  step 2  step 3  transition 1 -> 2, 3 : a  transition 2, 3 -> 1 : not a",
        );
    }
}

/// Two parallel sequences after step 1 with what stands in steps 3 and 5, which never wait for each other.
fn parallel(in_3: &str, in_5: &str) -> String {
    format!(
        "input a, p, q : bool  var n, m : int  var v : bool  const three : int := 3
         initial step 1  step 2  step 3 {{ {in_3} }}  step 4  step 5 {{ {in_5} }}
         transition 1 -> 2, 4 : a  transition 2 -> 3 : p  transition 4 -> 5 : q  transition 3, 5 -> 1 : not a"
    )
}

/// One sequence of steps 1, 2 and 3, with what stands in steps 2 and 3.
fn sequence(in_2: &str, in_3: &str) -> String {
    format!(
        "input a, b, p, q : bool  var n, m : int  var v : bool
         initial step 1  step 2 {{ {in_2} }}  step 3 {{ {in_3} }}
         transition 1 -> 2 : a  transition 2 -> 3 : b  transition 3 -> 1 : not a"
    )
}

mod w0410 {
    use super::*;

    #[test]
    fn parallel_counters() {
        let text = parallel("n := n + 1 on activation", "n := n + 1 on activation");
        let found = only("W0410", &text);
        assert!(found.message.contains("`n`"), "{}", found.message);
        assert_eq!(place(&found, &text), "n := n + 1 on activation");
        assert!(found.primary.span > found.secondary[0].span);
        assert_eq!(others(&found, &text), ["n := n + 1 on activation"]);
    }

    #[test]
    fn in_one_sequence() {
        silent(&sequence("n := n + 1 on activation", "n := n + 1 on activation"));
    }

    #[test]
    fn two_variables() {
        silent(&parallel("n := n + 1 on activation", "m := m + 1 on activation"));
    }

    #[test]
    fn up_and_down_are_said_once() {
        warns("W0410", &parallel("n := n + 1 on activation", "n := n - 1 on activation"));
        // Step 5 is left together with step 3, so not while step 3 is entered from step 2.
        silent(&parallel("n := n + 1 on activation", "n := n - 1 on deactivation"));
    }

    #[test]
    fn leaving_one_step_is_entering_the_next() {
        warns("W0410", &sequence("n := n + 1 on deactivation", "n := n + 1 on activation"));
        // A step is not entered when it is left.
        silent(&sequence("n := n + 1 on activation  n := n + 2 on deactivation", ""));
    }

    #[test]
    fn two_events_on_a_step() {
        warns("W0410", &sequence("n := n + 1 on event ↑p  n := n - 1 on event ↑q", ""));
        silent(&sequence("n := n + 1 on event ↑p  n := n - 1 on event ↑q and not p", ""));
        silent(&sequence("n := n + 1 on event ↑p  n := n - 1 on event ↓p", ""));
    }

    #[test]
    fn conditions_of_the_transitions_exclude_each_other() {
        let chart = |p: &str, q: &str| {
            format!(
                "input a, p, q : bool  var n : int  initial step 1  step 2  step 3  step 4  step 5
                 transition 1 -> 2, 4 : a  transition 3, 5 -> 1 : not a
                 transition 2 -> 3 : {p} {{ n := n + 1 }}  transition 4 -> 5 : {q} {{ n := n - 1 }}"
            )
        };
        warns("W0410", &chart("p", "q"));
        silent(&chart("p", "q and not p"));
    }

    #[test]
    fn at_the_start() {
        let chart = |step: &str| {
            format!(
                "input a : bool  var n : int
                 initial step 1 {{ n := n + 1 on activation }}  step 2  {step} step 3 {{ n := n + 1 on activation }}  step 4
                 transition 1 -> 2 : a  transition 2 -> 1 : ↑a  transition 3 -> 4 : a  transition 4 -> 3 : ↓a"
            )
        };
        // Afterwards they never meet: one is entered at ↑a, the other at ↓a. But both are initial.
        warns("W0410", &chart("initial"));
        silent(&chart(""));
    }
}

mod w0412 {
    use super::*;

    #[test]
    fn parallel_assignments() {
        let text = parallel("v := 1 on activation", "v := 0 on activation");
        let found = only("W0412", &text);
        assert!(found.message.contains("`v`"), "{}", found.message);
        assert_eq!(place(&found, &text), "v := 0 on activation");
        assert_eq!(others(&found, &text), ["v := 1 on activation"]);
    }

    #[test]
    fn the_same_value() {
        silent(&parallel("v := 1 on activation", "v := 1 on deactivation"));
        silent(&parallel("n := m + 1 on activation", "n := m + 1 on activation"));
    }

    #[test]
    fn values_that_are_not_literals() {
        warns("W0412", &parallel("n := m on activation", "n := 3 on activation"));
        silent(&parallel("n := three on activation", "n := 3 on activation"));
        warns("W0412", &parallel("n := three on activation", "n := 4 on activation"));
    }

    #[test]
    fn in_one_sequence() {
        silent(&sequence("v := 1 on activation  v := 0 on deactivation", ""));
        silent(&sequence("v := 1 on activation", "v := 0 on activation"));
        // Leaving step 2 is entering step 3 (vector 3b).
        warns("W0412", &sequence("v := 0 on deactivation", "v := 1 on activation"));
    }

    #[test]
    fn a_counter_that_is_set_elsewhere() {
        warns("W0412", &parallel("n := n + 1 on activation", "n := 0 on activation"));
        silent(&sequence("n := n + 1 on activation", "n := 0 on activation"));
    }

    #[test]
    fn both_warnings_for_different_pairs() {
        let text = parallel("n := n + 1 on activation  n := 0 on event ↑p", "n := n + 1 on activation");
        // Both at the assignment in step 5.
        assert_eq!(codes(&text), ["W0410", "W0412"]);
    }

    #[test]
    fn two_on_one_clearing() {
        warns(
            "W0412",
            "input a : bool  var n : int  initial step 1  step 2
             transition 1 -> 2 : a { n := 1  n := 2 }  transition 2 -> 1 : not a",
        );
    }

    #[test]
    fn forced_into_a_step() {
        // Step 12 may be forced active from step 11, whose deactivation then meets its activation.
        let chart = |forced: &str| {
            format!(
                "input a, m : bool  var v : bool
                 grafcet G1 {{ initial step 1  step 2 {{ force G2{{{forced}}} }}  transition 1 -> 2 : m  transition 2 -> 1 : not m }}
                 grafcet G2 {{ initial step 10  step 11 {{ v := 0 on deactivation }}  step 12 {{ v := 1 on activation }}
                   transition 10 -> 11 : a  transition 11 -> 10 : ↓a  transition 10 -> 12 : ↑m and not a  transition 12 -> 10 : ↓m }}"
            )
        };
        warns("W0412", &chart("12"));
        silent(&chart("*"));
    }

    #[test]
    fn forced_steps_of_one_grafcet() {
        let chart = |in_11: &str, in_12: &str| {
            format!(
                "input m, n : bool  var v : bool
                 grafcet G1 {{ initial step 1  step 2 {{ force G2{{11}} }}  step 3 {{ force G2{{12}} }}
                   transition 1 -> 2 : m  transition 2 -> 3 : n  transition 3 -> 1 : not m }}
                 grafcet G2 {{ initial step 10  step 11 {{ {in_11} }}  step 12 {{ {in_12} }}
                   transition 10 -> 11 : m  transition 11 -> 12 : n  transition 12 -> 10 : n }}"
            )
        };
        // After a micro-step one of them is active.
        silent(&chart("v := 1 on activation", "v := 0 on activation"));
        // What is activated is not deactivated.
        silent(&chart("v := 1 on activation  v := 0 on deactivation", ""));
        // Step 12 comes when step 11 goes.
        warns("W0412", &chart("v := 1 on deactivation", "v := 0 on activation"));
    }

    #[test]
    fn emptied_by_an_order() {
        let chart = |forced: &str| {
            format!(
                "input a, m, p : bool  var v : bool
                 grafcet G1 {{ initial step 1  step 2 {{ force G2{{{forced}}} }}  transition 1 -> 2 : m  transition 2 -> 1 : not m }}
                 grafcet G2 {{ initial step 20  step 21 {{ v := 0 on deactivation }}
                   transition 20 -> 21 : p  transition 21 -> 20 : not a }}
                 grafcet G3 {{ initial step 30  step 31 {{ v := 1 on activation }}
                   transition 30 -> 31 : a  transition 31 -> 30 : not a }}"
            )
        };
        // By itself step 21 goes when a is false, and step 31 comes when it is true.
        silent(&chart("*"));
        silent(&chart("21"));
        warns("W0412", &chart(""));
        warns("W0412", &chart("20"));
    }

    #[test]
    fn activated_by_a_link() {
        let chart = |link_20: &str, link_21: &str| {
            format!(
                "input a, m : bool  var v : bool
                 grafcet G1 {{ initial step 1  enclosing step 2  transition 1 -> 2 : m  transition 2 -> 1 : not m }}
                 grafcet X2/G2 {{ {link_20} step 20 {{ v := 0 on activation }}  {link_21} step 21
                   transition 20 -> 21 : a  transition 21 -> 20 : not a }}
                 grafcet G3 {{ initial step 30  step 31 {{ v := 1 on activation }}
                   transition 30 -> 31 : a  transition 31 -> 30 : not a }}"
            )
        };
        silent(&chart("", "activated"));
        warns("W0412", &chart("activated", ""));
    }

    #[test]
    fn emptied_by_an_enclosing_step() {
        // Step 20 goes when step 2 goes, and that may be together with whatever happens in G3.
        warns(
            "W0412",
            "input a, m : bool  var v : bool
             grafcet G1 { initial step 1  enclosing step 2  transition 1 -> 2 : m  transition 2 -> 1 : not m }
             grafcet X2/G2 { activated step 20 { v := 0 on deactivation } }
             grafcet G3 { initial step 30  step 31 { v := 1 on activation }  transition 30 -> 31 : a  transition 31 -> 30 : ↓a }",
        );
    }

    #[test]
    fn enclosed_by_steps_of_one_sequence() {
        // Steps 20 and 30 lie within steps 2 and 3, of which one is active; their events are looked at.
        silent(
            "input a, b, m, p, q : bool  var v : bool
             grafcet G1 { initial step 1  enclosing step 2  enclosing step 3
               transition 1 -> 2 : m  transition 2 -> 3 : a  transition 3 -> 1 : not m }
             grafcet X2/G2 { activated step 20 { v := 0 on event ↑p } }
             grafcet X3/G3 { activated step 30 { v := 1 on event ↑q } }",
        );
    }
}

mod w0411 {
    use super::*;

    /// Two grafcets that force G3, from step 2 and from step 20.
    fn chart(in_2: &str, in_20: &str) -> String {
        format!(
            "input stop, run, a : bool
             grafcet G1 {{ initial step 1  step 2 {{ {in_2} }}  transition 1 -> 2 : stop  transition 2 -> 1 : not stop }}
             grafcet G2 {{ initial step 20 {{ {in_20} }}  step 21  transition 20 -> 21 : run  transition 21 -> 20 : not run }}
             grafcet G3 {{ initial step 30  step 31  transition 30 -> 31 : a }}"
        )
    }

    #[test]
    fn two_grafcets() {
        let text = chart("force G3{}", "force G3{INIT}");
        let found = only("W0411", &text);
        assert_eq!(place(&found, &text), "force G3{INIT}");
        assert_eq!(others(&found, &text), ["force G3{}"]);
        for word in ["`2`", "`20`", "`G3`"] {
            assert!(found.message.contains(word), "{}", found.message);
        }
    }

    #[test]
    fn the_same_situation() {
        silent(&chart("force G3{INIT}", "force G3{30}"));
        silent(&chart("force G3{*}", "force G3{*}"));
        warns("W0411", &chart("force G3{*}", "force G3{30}"));
    }

    #[test]
    fn steps_of_one_sequence() {
        silent(
            "input a : bool
             grafcet G1 { initial step 1 { force G2{} }  step 2 { force G2{INIT} }
               transition 1 -> 2 : a  transition 2 -> 1 : not a }
             grafcet G2 { initial step 20 }",
        );
    }

    #[test]
    fn one_step_says_two_things() {
        warns(
            "W0411",
            "input a : bool
             grafcet G1 { initial step 1  step 2 { force G2{}  force G2{INIT} }
               transition 1 -> 2 : a  transition 2 -> 1 : not a }
             grafcet G2 { initial step 20 }",
        );
    }

    #[test]
    fn the_higher_one_forces_the_lower_one_away() {
        silent(&chart("force G2{21}  force G3{}", "force G3{INIT}"));
        // Here it forces it to where its order is.
        warns("W0411", &chart("force G2{20}  force G3{}", "force G3{INIT}"));
        // A frozen grafcet stays where it is, which may be step 20.
        warns("W0411", &chart("force G2{*}  force G3{}", "force G3{INIT}"));
    }

    #[test]
    fn an_order_that_may_win_over_the_one_that_forces_away() {
        // From step 90, G2 is forced to step 20 whatever step 2 says.
        let text = format!(
            "input up : bool
             grafcet G0 {{ initial step 90 {{ force G2{{20}}  force G1{{*}} }}  step 91  transition 90 -> 91 : up }}
             {}",
            chart("force G2{21}  force G3{}", "force G3{INIT}")
        );
        assert_eq!(codes(&text), ["W0411", "W0411"]);
    }
}

/// What can never happen, where nothing goes on, and where nothing comes to rest.
mod liveness {
    use super::*;

    /// The codes, each with the piece of the text that it is about.
    fn told(text: &str) -> Vec<String> {
        all(text).iter().map(|d| format!("{} {}", d.code.as_str(), place(d, text))).collect()
    }

    const INPUTS: &str = "input a, b, c, d : bool output V : bool ";

    #[test]
    fn a_step_that_nothing_activates_is_one_message() {
        let text = format!(
            "{INPUTS} initial step 1 step 7 step 8 step 9 transition 7 -> 8 : a transition 8 -> 9 : b
             transition 9 -> 1 : c"
        );
        assert_eq!(told(&text), ["W0414 7"]);
        let said = all(&text);
        let notes = &said.iter().next().expect("a message").notes;
        assert!(notes.iter().any(|note| note.contains("2 other steps are never active")), "{notes:?}");
    }

    #[test]
    fn steps_that_wait_for_each_other() {
        let text = format!("{INPUTS} initial step 1 step 7 step 8 transition 7 -> 8 : a transition 8 -> 7 : not a");
        assert_eq!(told(&text), ["W0414 7"]);
    }

    #[test]
    fn orders_links_and_sources_activate() {
        let text = "input a : bool grafcet G1 { initial step 1 { force G2{20} } step 2 transition 1 -> 2 : a
            transition 2 -> 1 : not a } grafcet G2 { step 20 } grafcet G3 { initial enclosing step 30 }
            grafcet X30/G4 { initial step 40 activated step 41 } grafcet G5 { step 50 transition -> 50 : ↑a }";
        assert!(!told(text).iter().any(|code| code.starts_with("W0414")), "{:?}", told(text));
    }

    #[test]
    fn what_an_inactive_step_forces() {
        let text = "input a : bool grafcet G1 { initial step 1 step 9 { force G2{21} } transition 9 -> 1 : a }
            grafcet G2 { initial step 20 step 21 }";
        assert_eq!(told(text), ["W0414 9"]);
    }

    #[test]
    fn alternatives_are_not_joined() {
        let text = format!(
            "{INPUTS} initial step 1 step 2 step 3 transition 1 -> 2 : a and not b transition 1 -> 3 : b and not a
             transition 2 -> 1 : c and not a transition 3 -> 1 : c and not b transition 2, 3 -> 1 : d and not c"
        );
        assert_eq!(told(&text), ["W0415 transition 2, 3 -> 1 : d and not c"]);
    }

    /// An on-delay asks for its operand now, an off-delay does not (X5).
    #[test]
    fn an_off_delay_outlives_its_step() {
        let is_dead = |condition: &str| {
            let text = format!(
                "{INPUTS} initial step 1 step 2 step 3 transition 1 -> 2 : a and not b transition 1 -> 3 : b and not a
                 transition 3 -> 1 : c and not b transition 2 -> 1 : d and not c transition 2 -> 1 : c and {condition}"
            );
            told(&text).iter().any(|said| said.starts_with("W0415"))
        };
        assert!(is_dead("X3"));
        assert!(is_dead("2s/X3"));
        assert!(!is_dead("2s/X3/3s"));
    }

    /// A step that is left and entered by one clearing stays active (R4): of the tokens that go around, none meets another.
    #[test]
    fn tokens_that_move_on_together_do_not_meet() {
        let meets = |last: &str| {
            let text = format!(
                "{INPUTS} initial step 1 initial step 2 step 3 transition 1 -> 2 : ↑a transition 2 -> 3 : ↑a
                 transition 3 -> 1 : {last}"
            );
            told(&text).iter().any(|said| said.starts_with("W0418"))
        };
        assert!(!meets("↑a"));
        assert!(meets("↑b"));
    }

    #[test]
    fn a_join_with_a_step_that_is_never_active_is_told_of_there() {
        let text = format!(
            "{INPUTS} initial step 1 step 2 step 3 transition 1 -> 2 : a and not b transition 2 -> 1 : b
             transition 2, 3 -> 1 : c and not b"
        );
        assert_eq!(told(&text), ["W0414 3"]);
        let said = all(&text);
        let labels = &said.iter().next().expect("a message").secondary;
        assert!(labels.iter().any(|label| text[label.span.range()].starts_with("transition 2, 3")), "{labels:?}");
        // So is one whose condition asks for the step.
        let text = format!(
            "{INPUTS} initial step 1 step 2 step 3 transition 1 -> 2 : a and not b transition 2 -> 1 : b
             transition 1 -> 2 : c and X3 and not a"
        );
        assert_eq!(told(&text), ["W0414 3"]);
        let said = all(&text);
        let labels = &said.iter().next().expect("a message").secondary;
        assert!(labels.iter().any(|label| text[label.span.range()].contains("X3")), "{labels:?}");
    }

    #[test]
    fn a_condition_that_denies_the_step_before() {
        let text = format!("{INPUTS} initial step 1 step 2 transition 1 -> 2 : a and not X1 transition 2 -> 1 : not a");
        assert_eq!(told(&text), ["W0415 transition 1 -> 2 : a and not X1"]);
    }

    #[test]
    fn constant_conditions() {
        for condition in ["0", "false", "a and not a", "a and ↓a", "(a or b) and not a and not b"] {
            let text = format!("{INPUTS} initial step 1 step 2 transition 1 -> 2 : {condition} transition 2 -> 1 : b");
            assert_eq!(told(&text), [format!("W0417 {condition}")]);
        }
        for condition in ["a or not a", "not 0", "a or 1"] {
            let text = format!("{INPUTS} initial step 1 {{ V if {condition} }}");
            assert_eq!(told(&text), [format!("W0417 {condition}")]);
        }
        for event in ["↑(a and not a)", "↑a and ↓a"] {
            let text = format!(
                "{INPUTS} grafcet M {{ initial step 1 {{ V start P on event {event} }} }}
                 child grafcet P of M {{ initial step 10 }}"
            );
            assert_eq!(told(&text), [format!("W0417 {event}")]);
        }
        for condition in ["1", "true", "a", "off and a", "a and not b or b and not a"] {
            let text = format!("{INPUTS} const off : bool := 0 initial step 1 {{ V if {condition} }}");
            assert_eq!(told(&text), [""; 0]);
        }
    }

    #[test]
    fn a_sequence_that_is_drawn_with_an_end_may_end() {
        assert_eq!(told(&format!("{INPUTS} initial step 1 step 2 transition 1 -> 2 : a")), [""; 0]);
        let text = format!(
            "{INPUTS} initial step 1 step 2 step 3 transition 1 -> 2 : a and not b transition 1 -> 3 : b and not a
             transition 2 -> 1 : not a"
        );
        assert_eq!(told(&text), ["W0416 3"]);
    }

    #[test]
    fn rings_with_an_edge_a_delay_or_what_excludes_come_to_rest() {
        let ring =
            |back: &str| format!("{INPUTS} initial step 1 step 2 transition 1 -> 2 : a transition 2 -> 1 : {back}");
        assert_eq!(told(&ring("b")), ["W0424 transition 1 -> 2 : a"]);
        for back in ["↑b", "3s/b", "b and not a", "3s/X2"] {
            assert_eq!(told(&ring(back)), [""; 0], "{back}");
        }
    }
}
