//! Charts that restate what people of the trade asked, reported or were taught: each does what its expectation says, in
//! the simulator and as a program, and gets the warnings that it deserves.

use grafc::backends::st;
use grafc::{Encoding, Lowering, Options, Product, Target};
use grafc_diagnostics::{Code, FileId};
use grafc_testsuite::charts::{cases, charts_folder, field_cases};
use grafc_testsuite::expected::{each, programs_agree, simulator_agrees};
use std::collections::BTreeSet;

const AT_LEAST: usize = 32;

#[test]
fn the_simulator_agrees() {
    each(&field_cases(), AT_LEAST, simulator_agrees);
}

#[test]
fn the_scan_programs_agree() {
    each(&field_cases(), AT_LEAST, programs_agree);
}

/// The mistakes that some of the cases make on purpose.
const DESERVED: &[(&str, &[Code])] = &[
    ("dead_join", &[Code::W0415, Code::W0416]),
    ("modes", &[Code::W0414]),
    ("motor_directions", &[Code::W0424]),
    ("start_and_stop_together", &[Code::W0424]),
    ("three_state_ring_hold", &[Code::W0424]),
    ("unsafe_chain", &[Code::W0418]),
];

#[test]
fn mistakes_are_warned_of() {
    for (name, codes) in DESERVED {
        let cases = field_cases();
        let case = cases.iter().find(|case| case.name == *name).expect("the case is there");
        let (_, said) = grafc::check(FileId::new(0), &case.text, name);
        let found: BTreeSet<Code> = said.iter().map(|message| message.code).collect();
        let missing: Vec<&Code> = codes.iter().filter(|code| !found.contains(code)).collect();
        assert!(missing.is_empty(), "{name}: {missing:?} missing among {found:?}");
    }
}

#[test]
fn a_ring_names_the_row_and_a_dead_end_the_way() {
    let told = |name: &str, code: Code| {
        let cases = field_cases();
        let case = cases.iter().find(|case| case.name == name).expect("the case is there");
        let (_, said) = grafc::check(FileId::new(0), &case.text, name);
        let message = said.iter().find(|message| message.code == code).expect("the warning").clone();
        format!("{}\n{}", message.message, message.notes.join("\n"))
    };
    let ring = told("start_and_stop_together", Code::W0424);
    assert!(ring.contains("`start` and `stop` are true"), "{ring}");
    let ring = told("motor_directions", Code::W0424);
    assert!(ring.contains("`S1` and `S0` are true and `S2` is false"), "{ring}");
    let end = told("dead_join", Code::W0416);
    assert!(end.contains("step `40`") && end.contains("the way there: `0 -> 10, 20`"), "{end}");
    let again = told("unsafe_chain", Code::W0418);
    assert!(again.contains("step `2` may be entered") && again.contains("`3 -> 5`, `5 -> 1`"), "{again}");
}

/// In a ring that one row makes true, encodings whose steps overlap end elsewhere, and say so.
#[test]
fn an_encoding_that_ends_elsewhere_says_so() {
    for name in ["motor_directions", "start_and_stop_together", "three_state_ring_hold"] {
        let cases = field_cases();
        let case = cases.iter().find(|case| case.name == name).expect("the case is there");
        for encoding in Encoding::ALL {
            let lowering = Lowering { encoding, ..Lowering::default() };
            let product = Product::Code(Target::St(st::Options::default()));
            let (_, said) = grafc::compile(FileId::new(0), &case.text, name, &Options::new(lowering, product));
            let found = said.iter().find(|message| message.code == Code::W0413);
            assert_eq!(found.is_some(), encoding.overlaps(), "{name}, {}", encoding.name());
            if let Some(message) = found {
                assert!(message.notes[0].contains("lost for good") && !message.notes[0].contains("one micro-step"));
            }
        }
    }
}

#[test]
fn the_charts_of_the_standard_and_of_textbooks_get_none_of_them() {
    let new = Code::W0414..=Code::W0425;
    for case in cases(&charts_folder()) {
        let (_, said) = grafc::check(FileId::new(0), &case.text, &case.name);
        let found: Vec<Code> = said.iter().map(|message| message.code).filter(|code| new.contains(code)).collect();
        assert!(found.is_empty(), "{}: {found:?}", case.name);
    }
}
