//! What a reader of generated code finds in it: each thing said once, in the words of the chart.

use grafc::{Options, Product};
use grafc_backends::{Target, plcopen, scl, st, tcpou};
use grafc_diagnostics::FileId;
use grafc_logic::{Encoding, Options as Lowering};
use grafc_model::reaction::Profile;

fn made(text: &str, encoding: Encoding, target: Target) -> String {
    let lowering = Lowering { profile: Profile::default(), encoding, simplify: true };
    let options = Options::new(lowering, Product::Code(target));
    let (made, diagnostics) = grafc::compile(FileId::default(), text, "chart", &options);
    made.unwrap_or_else(|| panic!("{diagnostics:?}")).text
}

fn st(text: &str) -> String {
    made(text, Encoding::SinglePhase, Target::St(st::Options::default()))
}

#[track_caller]
fn has(text: &str, expected: &str) {
    let words = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(words(text).contains(&words(expected)), "no\n{expected}\nin\n{text}");
}

/// Of k actions that may be done at once, the check takes k + 2 lines at most.
#[test]
fn a_conflict_is_asked_in_a_line_for_each_action() {
    for k in 3..20 {
        let mut chart = "output n : int\n".to_owned();
        for i in 0..k {
            chart += &format!(
                "input a{i} : bool\ninitial step S{i}\nstep T{i} {{ n := {i} on activation }}\n\
                 transition S{i} -> T{i} : a{i}\ntransition T{i} -> S{i} : not a{i}\n"
            );
        }
        let text = st(&chart);
        let at = text.find("ALLOC_CONFLICT :=").expect("a check");
        let check = &text[at..at + text[at..].find(';').expect("its end")];
        assert!(check.lines().count() <= k + 2, "{} lines for {k}: {check}", check.lines().count());
        // The last one wins, so it is asked first, and its value needs no comparison.
        has(&text, &format!("IF clr_S{0}_T{0} THEN n := {0};", k - 1));
        assert_eq!(check.matches("<>").count(), k - 1, "{check}");
    }
}

/// Right sides with operators are computed once, from old values.
#[test]
fn a_conflict_of_computed_values() {
    let text = st("input a, b, c : bool output n : int
        initial step 1 initial step 3 initial step 5
        step 2 { n := n + 1 on activation } step 4 { n := n + 1 on activation } step 6 { n := 7 on activation }
        transition 1 -> 2 : a transition 2 -> 1 : not a transition 3 -> 4 : b transition 4 -> 3 : not b
        transition 5 -> 6 : c transition 6 -> 5 : not c");
    has(&text, "new_n := n + 1;");
    assert_eq!(text.matches("n + 1").count(), 1, "{text}");
    has(&text, "ALLOC_CONFLICT := ALLOC_CONFLICT OR ((clr_1_2 OR clr_3_4) AND (n <> new_n));");
}

#[test]
fn equal_guards_are_joined_and_say_why_their_order_is_not_the_charts() {
    let text = st("input shift, part : bool output p1, p2, p3 : int
        initial step 1
        step 2 { p1 := 1 on activation  p2 := p1 on activation  p3 := p2 on activation }
        transition 1 -> 2 : shift transition 2 -> 1 : not shift");
    has(
        &text,
        "IF clr_1_2 THEN
            p3 := p2;  (* reads p2 before that is written *)
            p2 := p1;  (* reads p1 before that is written *)
            p1 := 1;   (* activation of 2 *)
        END_IF;",
    );
}

#[test]
fn common_factors_are_written_once() {
    let text = st("input a, b, c : bool output v, w : bool
        initial step 1 { v if c  w if a and c } step 2 { v if c  w if b and c }
        transition 1 -> 2 : a transition 2 -> 1 : not a");
    has(&text, "v := (X1 OR X2) AND c;");
    has(&text, "w := ((X1 AND a) OR (X2 AND b)) AND c;");
}

#[test]
fn what_is_written_twice_is_computed_once() {
    let text = st("input a, b, c, d : bool output v, w : bool
        initial step 1 { v if (a or b or c) and d } step 2 { w if (a or b or c) and not d }
        transition 1 -> 2 : a transition 2 -> 1 : not a");
    has(&text, "any_a_b_c := a OR b OR c;");
    assert_eq!(text.matches("a OR b OR c").count(), 1, "{text}");
}

#[test]
fn constants_take_no_variables() {
    let text = st("input a : bool output n : int
        initial step 1 step 2
        transition 1 -> 2 : a and not a
        transition -> 2 : 1
        transition 2 -> 1 : [n > 2 + 3]");
    assert!(!text.contains("clr_1_2") && !text.contains("clr_to_2") && !text.contains("2 + 3"), "{text}");
    has(&text, "n > 5");
}

#[test]
fn helpers_explain_themselves() {
    let text = st("input light_barrier : bool output v, w : bool const wait : time := 2s
        initial step 5 { v if wait/(X5 and not light_barrier)  w if 1s/light_barrier/wait }");
    has(&text, "on_X5_not_light_barrier : TON;  (* wait/(X5 · ¬light_barrier) *)");
    has(&text, "(* 1s/light_barrier/wait *)");
    // In files that are ASCII, too.
    let text = made(
        "input b : bool output v : bool initial step 5 { v if 2s/(X5 and not b) }",
        Encoding::SinglePhase,
        Target::Scl(scl::Options::default()),
    );
    assert!(text.is_ascii());
    has(&text, "// 2s/(X5 and not b)");
}

#[test]
fn grafcets_and_steps_are_seen() {
    let chart = "input a, b : bool output v, w : bool
        grafcet G1 \"the belt\" {
          initial step 1 \"ready\" step 2 \"moves\" { v }
          transition 1 -> 2 : a transition 2 -> 1 : not a
        }
        grafcet G2 \"the lamp\" {
          initial step 3 step 4 { w }
          transition 3 -> 4 : b transition 4 -> 3 : not b
        }";
    let text = st(chart);
    for grafcet in ["G1: the belt", "G2: the lamp"] {
        for part in ["steps of", "transitions that clear in", "situation in", "outputs in"] {
            has(&text, &format!("(* {part} {grafcet} *)"));
        }
    }
    has(&text, "X2 := clr_1_2 OR (X2 AND NOT clr_2_1);  (* moves *)");
    let text = made(chart, Encoding::Switch, Target::St(st::Options::default()));
    has(&text, "(* transitions in G2: the lamp *)");
    // One grafcet alone is none to tell from others.
    let text = st("input a : bool initial step 1 step 2 transition 1 -> 2 : a transition 2 -> 1 : not a");
    has(&text, "(* situation *)");
}

#[test]
fn states_say_which_number_is_which_step() {
    let text = made(
        "input a, b : bool output v : bool
        initial step Closed step Opening { v } step Open step Closing step Stopped initial step Lamp
        transition Closed -> Opening : a transition Opening -> Open : b transition Open -> Closing : a
        transition Closing -> Closed : b transition Opening -> Stopped : a and not b transition Stopped -> Closed : b",
        Encoding::Switch,
        Target::St(st::Options::default()),
    );
    has(&text, "at_G1 : INT;  (* 1 Closed, 2 Opening, 3 Open, 4 Closing, 5 Stopped *)");
    has(&text, "XLamp : BOOL;");
    has(&text, "v := (at_G1 = 2);  (* Opening *)");
}

/// Where the target has a place for what lives within one call, it is there; portable Structured Text has none.
#[test]
fn values_within_one_call() {
    let chart = "input a : bool initial step 1 step 2 transition 1 -> 2 : ↑a transition 2 -> 1 : not a";
    let of = |target| made(chart, Encoding::SinglePhase, target);
    let codesys = plcopen::Options { dialect: plcopen::Dialect::Codesys, ..plcopen::Options::default() };
    for (target, place) in [
        (Target::Scl(scl::Options::default()), "VAR_TEMP"),
        (Target::Tcpou(tcpou::Options::default()), "VAR_TEMP"),
        (Target::Plcopen(codesys), "<tempVars>"),
    ] {
        let text = of(target);
        let at = text.find(place).unwrap_or_else(|| panic!("no {place} in {text}"));
        assert!(text[at..].contains("clr_1_2") && text[..at].contains("old_a"), "{text}");
    }
    for target in [Target::St(st::Options::default()), Target::Plcopen(plcopen::Options::default())] {
        let text = of(target);
        assert!(!text.contains("VAR_TEMP") && !text.contains("tempVars"), "{text}");
    }
}
