//! Names, numbers, durations, strings, comments: what they mean, and which faults they have.

mod common;

use common::{chart, condition, faults, value};
use grafc_diagnostics::FileId;
use grafc_syntax::ast::Item;

#[test]
fn names_have_unicode_letters_or_backquotes() {
    assert_eq!(condition("Größe and клапан_1 and _x and `on` and `2s/X202`"), {
        "(and (and (and (and Größe клапан_1) _x) on) 2s/X202)"
    });
    // An umlaut of two characters is one letter with a mark.
    assert_eq!(condition("u\u{308}ber"), "u\u{308}ber");
    assert_eq!(faults("step `a b"), ["E0104 1:6-9 the name in backquotes does not end on its line"]);
    assert_eq!(faults("step ``"), ["E0104 1:6-7 the name in backquotes is empty"]);
}

#[test]
fn words_are_names_where_they_cannot_mean_anything_else() {
    assert_eq!(condition("time and event and activation and at and bool and INIT"), {
        "(and (and (and (and (and time event) activation) at) bool) INIT)"
    });
    assert_eq!(
        faults("input at at %IX0.0 : bool"),
        ["E0107 1:10-11 expected `:`, `,` or an attached comment, found `at`"]
    );
    assert!(faults("input at : bool at %IX0.0").is_empty());
}

#[test]
fn operators_and_constants_may_be_in_capitals() {
    assert_eq!(condition("NOT a AND TRUE OR b XOR FALSE"), "(or (and (not a) true) (xor b false))");
    assert_eq!(value("[a AND NOT b]"), "(predicate (and a (not b)))");
    assert_eq!(condition("`OR` or `NOT`"), "(or OR NOT)");
    for word in ["AND", "OR", "XOR", "NOT", "TRUE", "FALSE"] {
        let found = faults(&format!("input {word} : bool"));
        assert_eq!(found, [format!("E0107 1:7-{} expected a name, found `{word}`", 6 + word.len())]);
        assert!(faults(&format!("input `{word}` : bool")).is_empty());
    }
}

#[test]
fn numbers() {
    for (written, read) in [
        ("3", "3"),
        ("007", "7"),
        ("1_000", "1000"),
        ("16#FF", "255"),
        ("16#ff_Ff", "65535"),
        ("2#1010_1010", "170"),
        ("8#17", "15"),
        ("8.5", "8.5"),
        ("1_0.2_5", "10.25"),
        ("1.5e-3", "0.0015"),
        ("1e3", "1000.0"),
        ("2E+2", "200.0"),
        ("9223372036854775807", "9223372036854775807"),
        ("-2", "(negate 2)"),
        ("- -2", "(negate (negate 2))"),
    ] {
        assert_eq!(value(written), read, "{written}");
    }
}

#[test]
fn malformed_numbers() {
    for (written, message) in [
        ("3x", "`3x` is not a number"),
        ("1.2.3", "`1.2.3` is not a number"),
        ("16#", "`16#` is not a number in base 16"),
        ("16#G", "`16#G` is not a number in base 16"),
        ("2#102", "`2#102` is not a number in base 2"),
        ("8#8", "`8#8` is not a number in base 8"),
        ("10#1", "`10#1` has an unknown base"),
        ("1__0", "`_` in `1__0` is not between two digits"),
        ("1_", "`_` in `1_` is not between two digits"),
        ("16#_F", "`_` in `16#_F` is not between two digits"),
        ("9223372036854775808", "the number `9223372036854775808` is too large"),
        ("16#8000000000000000", "the number `16#8000000000000000` is too large"),
        ("1e999", "the number `1e999` is too large"),
        ("1e", "`1e` is not a number"),
        ("1.5e+_", "`_` in `1.5e+_` is not between two digits"),
    ] {
        let columns = 16 + written.len();
        assert_eq!(
            faults(&format!("var v : int  := {written}")),
            [format!("E0105 1:17-{columns} {message}")],
            "{written}"
        );
    }
}

#[test]
fn durations() {
    for (written, read) in [
        ("3s", "3000ms"),
        ("500ms", "500ms"),
        ("1min30s", "90000ms"),
        ("2h", "7200000ms"),
        ("1.5s", "1500ms"),
        ("0.50s", "500ms"),
        ("1d2h3min4s5ms", "93784005ms"),
        ("1_000ms", "1000ms"),
        ("0s", "0ms"),
        ("90s", "90000ms"),
        ("0.0009765625d", "84375ms"),
        ("2147483647ms", "2147483647ms"),
        ("T#1m30s", "90000ms"),
        ("t#1M30S", "90000ms"),
        ("TIME#1d_2h_3m_4s_5ms", "93784005ms"),
        ("time#2.5h", "9000000ms"),
    ] {
        assert_eq!(value(written), read, "{written}");
    }
}

#[test]
fn malformed_durations() {
    for (written, message) in [
        ("3sec", "`3sec` is not a duration"),
        ("1m", "`1m` is not a duration"),
        ("20µs", "`20µs` is not a duration"),
        ("1min30", "`1min30` is not a duration"),
        ("T#", "`T#` has no value"),
        ("T#5", "`T#5` is not a duration"),
        ("T#s", "`T#s` is not a duration"),
        ("T#1s_", "`_` in `T#1s_` is not between two digits"),
        ("30s1min", "the units of `30s1min` are not in order"),
        ("1s2s", "the units of `1s2s` are not in order"),
        ("1.5min3s", "`1.5min3s` has a fraction before its last part"),
        ("0.5ms", "the duration `0.5ms` is finer than a millisecond"),
        ("0.0001s", "the duration `0.0001s` is finer than a millisecond"),
        ("1.33333333333333333333s", "the duration `1.33333333333333333333s` is finer than a millisecond"),
        ("2147483648ms", "the duration `2147483648ms` is too long"),
        ("25d", "the duration `25d` is too long"),
        ("99999999999999999999d", "the duration `99999999999999999999d` is too long"),
    ] {
        let columns = 16 + written.chars().count();
        let found = faults(&format!("var v : int  := {written}"));
        let code = if message.starts_with("`_`") { "E0105" } else { "E0106" };
        assert_eq!(found, [format!("{code} 1:17-{columns} {message}")], "{written}");
    }
}

#[test]
fn strings() {
    let comment = |text: &str| match &chart(text).items[0] {
        Item::Step(step) => step.comment.as_ref().map(|c| c.text.clone()),
        item => panic!("a step was written: {item:?}"),
    };
    assert_eq!(comment("step 1"), None);
    assert_eq!(comment(r#"step 1 """#).as_deref(), Some(""));
    assert_eq!(comment(r#"step 1 "say ""go"" twice""#).as_deref(), Some("say \"go\" twice"));
    assert_eq!(comment(r#"step 1 "C:\new // no comment (*""#).as_deref(), Some(r"C:\new // no comment (*"));
    assert_eq!(faults("step 1 \"ready\nstep 2 \"a\""), ["E0103 1:8-13 the string does not end on its line"]);
    assert_eq!(faults("step 1 \"a\"\"\nstep 2"), ["E0103 1:8-11 the string does not end on its line"]);
}

#[test]
fn comments_are_kept_aside_and_nest() {
    let text = "// one\r\nstep 1 (* two (* three *) *) { A } // four";
    let chart = chart(text);
    let comments: Vec<&str> = chart.comments.iter().map(|c| &text[c.span.range()]).collect();
    assert_eq!(comments, ["// one", "(* two (* three *) *)", "// four"]);
    assert_eq!(faults("step 1\nstep 2 (* open (* closed *)\nstep 3 {"), ["E0102 2:8-9 the comment is never closed"]);
    assert_eq!(faults("grafcet G { step 1 (*)"), ["E0102 1:20-21 the comment is never closed"]);
    // Braces, not parentheses: no comment begins here.
    assert!(faults("step 1 { force G3{*} }").is_empty());
}

#[test]
fn wrong_characters_in_a_run_are_one_fault() {
    assert_eq!(faults("transition 1 -> 2 : a $?$ b"), ["E0101 1:23-25 unexpected characters `$?$`"]);
    assert_eq!(faults("step 1 ?\nstep 2 ?").len(), 2);
    // Semicolons are one habit, and its cure takes out all of them.
    let text = "step 1 ;\nstep 2 ; ;";
    assert_eq!(faults(text), ["E0101 1:8 unexpected character `;`"]);
    let said = grafc_syntax::parse(FileId::new(0), text).1;
    let places: Vec<u32> = said.iter().flat_map(|d| &d.secondary).map(|label| label.span.start).collect();
    let edits = said.iter().flat_map(|d| &d.fixes[0].edits).map(|edit| edit.span.start);
    assert_eq!((places, edits.collect()), (vec![16, 18], vec![7, 16, 18]));
    assert_eq!(faults("step 1 \u{200B}"), ["E0101 1:8 unexpected character (U+200B)"]);
    assert_eq!(faults("step 1 \u{1}\u{2}"), ["E0101 1:8-9 unexpected characters"]);
    assert_eq!(faults("step 1 ⊕"), ["E0101 1:8 unexpected character `⊕` (U+2295)"]);
}

#[test]
fn byte_order_mark_and_all_blanks_are_white_space() {
    assert!(faults("\u{FEFF}step\u{A0}1\r\n\tstep\u{3000}2\r\n").is_empty());
    assert!(faults("").is_empty());
    assert!(faults("\u{FEFF}").is_empty());
}
