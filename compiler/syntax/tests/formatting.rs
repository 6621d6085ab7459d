//! The canonical text: what it looks like, and that it keeps meaning, spelling and comments.

mod common;

use common::{chart, check};

fn format(text: &str) -> String {
    assert!(check(text), "{text}");
    grafc_syntax::format(text, &chart(text))
}

#[test]
fn one_item_a_line_and_single_blanks() {
    assert_eq!(
        format(
            "chart  C input a,b:bool var n:int:=-3 at %MW0 grafcet X9/G4\"e\"{initial step 1{V W if a}transition(1)1->2,3:a step 2}"
        ),
        "\
chart C
input a, b : bool
var n : int := -3 at %MW0
grafcet X9/G4 \"e\" {
  initial step 1 { V   W if a }
  transition (1) 1 -> 2, 3 : a
  step 2
}
"
    );
}

#[test]
fn choices_in_the_heading_and_each_scan() {
    assert_eq!(
        format(
            "chart  M\"x\"   evolution   scan  initial_actions off step 1{n:=n/2+1 each   scan  m:=-1   each scan if\na/X1}"
        ),
        "chart M \"x\" evolution scan initial_actions off\nstep 1 { n := n / 2 + 1 each scan   m := -1 each scan if a/X1 }\n"
    );
}

#[test]
fn scenarios_have_a_line_a_line() {
    assert_eq!(
        format(
            "scenario \"s\"{0s:a=0,b=- 1\n after 8s:TD=1↑->not BM,X2 until X11 and ↑ c within 60s->MR 3s: a=1 rise}"
        ),
        "scenario \"s\" {\n  0s : a = 0, b = -1\n  after 8s : TD = 1 ↑ -> not BM, X2\n  until X11 and ↑c within 60s -> MR\n  3s : a = 1 rise\n}\n"
    );
    assert_eq!(
        format("scenario \"s\" { 0s : a = 0 until X1 within 1s }"),
        "scenario \"s\" { 0s : a = 0   until X1 within 1s }\n"
    );
}

#[test]
fn the_author_s_spellings_stay() {
    assert_eq!(
        format("transition 1→2:a AND NOT b XOR TRUE OR(NOT(c))"),
        "transition 1 → 2 : a AND NOT b XOR TRUE OR (NOT (c))\n"
    );
    assert_eq!(
        format(
            "transition 1→2:a·b&c and d|e+f or!g xor¬h·not i·↑a·↓(b)·rise a·fall(b)·[C≠2]·[C<>2]·[T#1m30s>=90s]·[16#FF≥1_0]"
        ),
        "transition 1 → 2 : a · b & c and d | e + f or !g xor ¬h · not i · ↑a · ↓(b) · rise a · fall (b) · [C ≠ 2] · [C <> 2] \
         · [T#1m30s >= 90s] · [16#FF ≥ 1_0]\n"
    );
}

#[test]
fn blanks_around_operators_follow_their_meaning() {
    assert_eq!(
        format("step 1{C:=C/2-1*-3 on event 3s / a / 7s B if 4s /[C/2=1] force G12 { 8 ,9 } force G3{ * }force G4{ }}"),
        "step 1 { C := C / 2 - 1 * -3 on event 3s/a/7s   B if 4s/[C / 2 = 1]   force G12{8, 9}   force G3{*}   force G4{} }\n"
            .replace("step 1 { ", "step 1 {\n  ")
            .replace("   ", "\n  ")
            .replace(" }\n", "\n}\n")
            .as_str()
    );
    assert_eq!(format("transition 1->2:a{C:=C/2 D:=-1- -2}"), "transition 1 -> 2 : a { C := C / 2   D := -1 - -2 }\n");
}

#[test]
fn actions_stay_on_the_line_or_on_their_own() {
    assert_eq!(format("step 1 { A\nB }"), "step 1 { A   B }\n");
    assert_eq!(format("step 1 {\nA B\n\n\n\nC }"), "step 1 {\n  A\n  B\n\n  C\n}\n");
    assert_eq!(format("step 1 { A // why\n B }"), "step 1 {\n  A // why\n  B\n}\n");
    assert_eq!(format("step 1 { }\ntransition 1 -> 2 : a { }"), "step 1\ntransition 1 -> 2 : a\n");
    let long = "B".repeat(60);
    assert_eq!(format(&format!("step 1 {{ {long} A{long} }}")), format!("step 1 {{\n  {long}\n  A{long}\n}}\n"));
}

#[test]
fn allowances_are_items_and_stand_beside_actions() {
    assert_eq!(format("allow   W0409\n\"r\" step 1"), "allow W0409 \"r\"\nstep 1\n");
    assert_eq!(format("grafcet G { allow W0401   V \"r\" }"), "grafcet G {\n  allow W0401 V \"r\"\n}\n");
    assert_eq!(format("step 1 { V  allow W0409\n\"r\" W }"), "step 1 { V   allow W0409 \"r\"   W }\n");
    assert_eq!(
        format("transition 1 -> 2 : a {\nallow W0409 \"r\" C := 1 }"),
        "transition 1 -> 2 : a {\n  allow W0409 \"r\"\n  C := 1\n}\n"
    );
}

#[test]
fn words_before_step_have_an_order() {
    assert_eq!(format("enclosing activated initial step 1"), "initial activated enclosing step 1\n");
}

#[test]
fn one_blank_line_at_most() {
    assert_eq!(
        format("\n\n// first\n\n\n\nstep 1\n\nstep 2\ngrafcet G {\n\n  // in\n\n  step 3\n\n\n}\n\n\n// last\n\n"),
        "// first\n\nstep 1\n\nstep 2\ngrafcet G {\n  // in\n\n  step 3\n}\n\n// last\n"
    );
    assert_eq!(format(""), "");
    assert_eq!(format("\n\n"), "");
}

#[test]
fn comments_stay_where_they_are() {
    let text = "\
// head
chart C // of the chart
(* own
   line *)
input a // one
    , b // two
    : bool (* three *)
grafcet G { // open
  step 1 { // actions
    V (* inline *) if a // condition
        or b
    // own
    K := (* value *) 1 on activation
    // last
  } // closed
  transition 1 -> 2 : a // or
      // rather
      or b (* c *) · (* d *) c
  // before the end
} // of G
// tail
";
    assert_eq!(format(text), text);
    assert_eq!(format("(* only *)"), "(* only *)\n");
    assert_eq!(format("step 1 // no line end"), "step 1 // no line end\n");
    assert_eq!(format("transition 1->2:3s/(*c*)a/(*d*)(b)"), "transition 1 -> 2 : 3s/ (*c*) a/ (*d*) (b)\n");
}

#[test]
fn line_breaks_of_the_author_are_kept_at_operators_and_commas() {
    assert_eq!(
        format("transition 1\n->\n2 :\na and b\nor c and\nd"),
        "transition 1 -> 2 : a and b\n    or c and\n    d\n"
    );
    assert_eq!(format("input a,\nb\n,c\n: bool"), "input a,\n    b, c : bool\n");
}

#[test]
fn line_ends_follow_the_text() {
    assert_eq!(format("step 1\r\nstep 2 (* a\r\nb *)\r\n"), "step 1\r\nstep 2 (* a\r\nb *)\r\n");
    assert_eq!(format("\u{FEFF}step 1"), "step 1\n");
}

#[test]
fn the_sample_of_the_language_page() {
    let text = include_str!("samples/weigh_mix.gct");
    let formatted = format(text);
    assert!(formatted.contains("  step 6 { BM   bricks := 0 on activation }\n"), "{formatted}");
    assert!(formatted.contains("  transition (8) 9 -> 10 : mix_time/X9\n"), "{formatted}");
    assert!(format(include_str!("samples/every_construct.gct")).contains("macro step M3"));
}

/// The white space between the tokens of a text that has no `"` or `*)` in its comments and strings.
fn blanks(text: &str) -> Vec<usize> {
    let (mut line_comment, mut comment, mut string) = (false, 0, false);
    let mut blanks = Vec::new();
    for (at, c) in text.char_indices() {
        let rest = &text[at..];
        match c {
            '\n' => line_comment = false,
            _ if line_comment => {}
            '"' => string = !string,
            _ if string => {}
            _ if rest.starts_with("(*") => comment += 1,
            _ if rest.starts_with("*)") => comment -= 1,
            _ if rest.starts_with("//") => line_comment = true,
            _ => {}
        }
        // The end of a line comment belongs to it: what is put before it would be part of the comment.
        let ends_comment = c == '\n' && text[..at].lines().last().is_some_and(|line| line.contains("//"));
        if c.is_whitespace() && !line_comment && !ends_comment && comment == 0 && !string {
            blanks.push(at);
        }
    }
    blanks
}

/// A comment at any place between two tokens is kept, whatever stands around it.
#[test]
fn a_comment_between_any_two_tokens() {
    let text = include_str!("samples/every_construct.gct");
    let blanks = blanks(text);
    assert!(blanks.len() > 400, "{}", blanks.len());
    for comment in [" // c\n", "\n// c\n", " (* c *) ", "\n(* c *)\n", " (* c\n d *) ", "\r\n"] {
        // One text with a comment at every tenth blank tells as much as ten texts.
        for first in 0..10 {
            let mut commented = text.to_owned();
            for &at in blanks.iter().skip(first).step_by(10).rev() {
                commented.insert_str(at, comment);
            }
            assert!(check(&commented), "{commented}");
        }
        let mut commented = text.to_owned();
        for &at in blanks.iter().rev() {
            commented.insert_str(at, comment);
        }
        assert!(check(&commented), "{commented}");
    }
}

#[test]
fn comments_beside_empty_braces_stand_as_if_there_were_none() {
    let text = "expansion M3 { step E3\n(* own *) {} (* c *)  \n transition E3 -> S3 : 1 step S3 }";
    let once = "expansion M3 {\n  step E3\n  (* own *) (* c *)\n  transition E3 -> S3 : 1\n  step S3\n}\n";
    assert_eq!(format(text), once);
    assert_eq!(
        format("step 1 { } // c\nstep 2 { force G1{} }\ngrafcet G3 {}\n"),
        "step 1 // c\nstep 2 { force G1{} }\ngrafcet G3 {\n}\n"
    );
}
