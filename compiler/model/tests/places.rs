//! Messages stand at the places that are at fault.

mod support;

use grafc_diagnostics::FileId;
use support::{annotated, placed};

/// The messages on a chart, each at its first place, are those that it is annotated with.
fn check(text: &str) {
    let (tree, diagnostics) = grafc_syntax::parse(FileId::new(0), text);
    let checked = grafc_model::examine(&tree, "chart");
    let all = diagnostics.iter().chain(&checked.diagnostics);
    let found = all.map(|d| (d.primary.span, d.code.as_str().to_owned()));
    assert_eq!(placed(text, found), annotated(text), "{text}");
}

#[test]
fn names() {
    check(
        "
        input valve, Valve : bool
        //           ^^^^^ E0203
        output V : bool
        initial step 1 { V if XFiling }
        //                    ^^^^^^^ E0201
        step 1 { W }
        //   ^ E0202
        //       ^ E0201
        step Filling
        transition 1 -> 3 : valev and Filling
        //              ^ E0301
        //                  ^^^^^ E0201
        //                            ^^^^^^^ E0201
        ",
    );
}

#[test]
fn types_and_values() {
    check(
        "
        const K : int
        //    ^ E0211
        var n : int := 70000
        //             ^^^^^ E0210
        input a : bool at %QX0.0
        //                ^^^^^^ E0212
        initial step 1 { n := a on activation a if a }
        //                    ^ E0205
        //                                    ^ E0207
        transition 1 -> 1 : [n > 3s] or n
        //                   ^^^^^^ E0205
        //                              ^ E0206
        ",
    );
}

#[test]
fn the_innermost_part_that_has_no_value() {
    check(
        "
        input n : int
        initial step 1
        transition 1 -> 1 : [n < 1 + (1 + (32767 + 1))]
        //                                 ^^^^^^^^^ E0210
        ",
    );
}

#[test]
fn structure() {
    check(
        "
        input a : bool
        grafcet G1 { initial step 1 macro step M3 macro step M4
        //                                                   ^^ E0306
            transition 1, 1 -> M3 : a
            //            ^ E0303
            step 5 transition -> : a
            //     ^^^^^^^^^^^^^^^^^ E0304
            transition 1 -> 2 : a }
            //              ^ E0305
        grafcet G2 { initial step 2 { force G3{} } }
        //                                  ^^ E0302
        expansion M3 { step E3 }
        //        ^^ E0306
        ",
    );
}

#[test]
fn beside_syntax_errors_only_what_is_certain() {
    check(
        "
        input a, a : bool
        //       ^ E0202
        initial step 1
        transition 1 => 2 : a
        //           ^ E0107
        transition 1 -> 3 : b
        ",
    );
}
