//! How drawn charts are laid out: as one would draw them.

use grafc::{Options, Product};
use grafc_backends::Target;
use grafc_backends::plcopen::{self, Body, Dialect};
use grafc_diagnostics::FileId;
use grafc_logic::{Encoding, Options as Lowering};
use grafc_model::reaction::{Evolution, Profile};
use grafc_testsuite::plcopen_lint::document::Document;
use grafc_testsuite::plcopen_lint::lint;
use grafc_testsuite::plcopen_sheet::Sheet;
use std::collections::BTreeMap;

fn draw(text: &str, dialect: Dialect) -> String {
    let profile = Profile { evolution: Evolution::Scan, ..Profile::default() };
    let product =
        Product::Code(Target::Plcopen(plcopen::Options { body: Body::Sfc, dialect, ..plcopen::Options::default() }));
    let options = Options::new(Lowering { profile, encoding: Encoding::default(), simplify: true }, product);
    let (made, diagnostics) = grafc::compile(FileId::default(), text, "chart", &options);
    made.unwrap_or_else(|| panic!("{diagnostics:?}")).text
}

/// The frames of all steps by their names, and of the transitions in the order of the drawing: left, top, right, bottom.
fn frames(text: &str) -> (BTreeMap<String, [i64; 4]>, Vec<[i64; 4]>) {
    let document = Document::read(text).expect("XML");
    let sheet = Sheet::of(&document, "SFC").expect("a drawing");
    sheet.stands_clear().expect("nothing stands on something else");
    let (mut steps, mut transitions) = (BTreeMap::new(), Vec::new());
    for object in sheet.objects() {
        let frame = sheet.frame(*object).expect("a frame");
        match document.name(*object) {
            "step" => {
                steps.insert(document.attribute(*object, "name").expect("a name").to_owned(), frame);
            }
            "transition" => transitions.push(frame),
            _ => {}
        }
    }
    (steps, transitions)
}

fn middle([left, _, right, _]: [i64; 4]) -> i64 {
    (left + right) / 2
}

/// Branches whose ends lie in another order than their beginnings: the beginnings stand as the text has them.
#[test]
fn branches_stand_in_the_order_of_the_text() {
    let text = draw(
        "input a, b, c, d : bool
        initial step 1 step 2 step 3 step 4 step 5 step 6 step 7
        transition 1 -> 2, 3, 4 : a
        transition 2 -> 5 : b
        transition 3 -> 6 : c
        transition 4 -> 7 : d
        transition 7, 6, 5 -> 1 : not a",
        Dialect::Neutral,
    );
    let (steps, _) = frames(&text);
    let x = |name: &str| middle(steps[name]);
    assert!(x("X2") < x("X3") && x("X3") < x("X4"), "{steps:?}");
    let choice = draw(
        "input n : int input a : bool
        initial step 1 step 4 step 3 step 2 step 5 step 6
        transition 1 -> 2 : [n = 2]
        transition 1 -> 3 : [n = 3]
        transition 1 -> 4 : [n = 4]
        transition 4 -> 5 : a
        transition 2 -> 6 : a
        transition 3 -> 5 : a
        transition 5 -> 1 : not a
        transition 6 -> 1 : not a",
        Dialect::Neutral,
    );
    let (steps, _) = frames(&choice);
    let x = |name: &str| middle(steps[name]);
    assert!(x("X2") < x("X3") && x("X3") < x("X4"), "{steps:?}");
}

/// However wide what stands beside it is.
#[test]
fn a_sequence_stands_in_one_column() {
    let text = draw(
        "input a, b, c : bool input a_very_long_name_of_an_input_that_makes_its_condition_wide : bool
        output v, w : bool
        initial step 1 step 2 { v } step 3 { w } step 4 step 5 step 6 { v w } step 7
        transition 1 -> 2, 5 : a
        transition 2 -> 3 : a_very_long_name_of_an_input_that_makes_its_condition_wide and b
        transition 3 -> 4 : b
        transition 5 -> 6 : a and b and c
        transition 6 -> 7 : c
        transition 4, 7 -> 1 : not a",
        Dialect::Neutral,
    );
    let (steps, transitions) = frames(&text);
    for column in [["X2", "X3", "X4"], ["X5", "X6", "X7"]] {
        let x = middle(steps[column[0]]);
        assert!(column.iter().all(|step| middle(steps[*step]) == x), "{column:?} in {steps:?}");
        assert!(transitions.iter().filter(|frame| middle(**frame) == x).count() >= 2, "{transitions:?}");
    }
}

#[test]
fn grafcets_stand_side_by_side() {
    let text = draw(
        "input a, b, c : bool
        grafcet G1 {
          initial step 1 step 2 step 3 step 4 step 5
          transition 1 -> 2, 3, 4 : a
          transition 2, 3, 4 -> 5 : b
          transition 5 -> 1 : not b
        }
        grafcet G2 { initial step 11 step 12 transition 11 -> 12 : c transition 12 -> 11 : not c }
        grafcet G3 { initial step 21 step 22 transition 21 -> 22 : c transition 22 -> 21 : not c }",
        Dialect::Neutral,
    );
    let (steps, _) = frames(&text);
    // G2 begins where G1 ends, as far as conditions let it; G3 where G2 ends.
    let first = ["X1", "X2", "X3", "X4", "X5"].map(|step| steps[step][2]).into_iter().max().expect("steps");
    assert!(steps["X11"][0] > first && steps["X11"][0] - first < 250, "{steps:?}");
    assert!(steps["X21"][0] > steps["X11"][2] && steps["X21"][0] - steps["X11"][2] < 250, "{steps:?}");
}

#[test]
fn comments_of_steps_are_drawn() {
    let chart = "input a : bool output v : bool
        initial step 1 \"ready\" step 2 \"under way *)\" { v }
        transition 1 -> 2 : a transition 2 -> 1 : not a";
    for (dialect, name) in [(Dialect::Neutral, "comment"), (Dialect::Codesys, "step")] {
        let text = draw(chart, dialect);
        assert_eq!(lint(&text, dialect), [], "{text}");
        let document = Document::read(&text).expect("XML");
        assert_eq!(document.all(name).count(), 2);
        assert!(text.contains("ready") && text.contains("under way * )"), "{text}");
    }
    frames(&draw(chart, Dialect::Neutral));
}

/// An output of several steps is an action of each where none hands over to another; else it is found behind the chart.
#[test]
fn outputs_of_several_steps() {
    let ring = |second: u32| {
        format!(
            "input a : bool output v : bool
            initial step 1 {{ v }} step 2 step 3 step 4
            {}
            transition 1 -> 2 : a transition 2 -> 3 : not a transition 3 -> 4 : a transition 4 -> 1 : not a",
            format_args!("step 5 {{ v }} transition {second} -> 5 : a and not a")
        )
    };
    // 5 is entered from 2, where v is not set, and left for nothing.
    let apart = draw(&ring(2), Dialect::Neutral);
    assert_eq!(apart.matches("<reference name=\"v\"/>").count(), 2, "{apart}");
    assert!(!apart.contains("drawn("), "{apart}");
    // From 1 the output goes on.
    let next = draw(&ring(1), Dialect::Neutral);
    assert_eq!(next.matches("<reference name=\"v\"/>").count(), 0, "{next}");
    assert!(next.contains("v := drawn.at_1 OR drawn.at_5;"), "{next}");
}
