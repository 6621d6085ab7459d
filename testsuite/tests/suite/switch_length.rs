//! On small charts `switch` takes no more lines than a bit a step, in every target that is Structured Text.
//!
//! Instruction lists have no branches by a number: an arm is a comparison and a jump there, and costs more than bits. In
//! Rust each brace has a line, as rustfmt lays it out. A ladder and the other bodies of PLCopen are no text.

use grafc::{Options, Product};
use grafc_backends::Target;
use grafc_backends::choice::Chosen;
use grafc_diagnostics::FileId;
use grafc_logic::{Encoding, Options as Lowering};
use grafc_testsuite::charts::{Case, cases, charts_folder, field_cases, vectors_folder};

/// A chart with fewer steps is small.
const SMALL: usize = 20;

fn lines(case: &Case, encoding: Encoding, target: &Target) -> Option<usize> {
    let lowering = Lowering { profile: case.profile, encoding, simplify: true };
    let options = Options::new(lowering, Product::Code(target.clone()));
    let (made, _) = grafc::compile(FileId::default(), &case.text, &case.name, &options);
    made.map(|made| made.text.lines().count())
}

#[test]
fn switch_is_not_longer_than_a_bit_a_step() {
    let of_structured_text = ["st", "scl", "tcpou", "iec61131-10"];
    let targets = of_structured_text.map(|name| {
        let about = Target::ALL.iter().find(|about| about.name == name).unwrap_or_else(|| panic!("no target {name}"));
        (name, about.target(&Chosen::new()).expect("a target with what is usual"))
    });
    let (mut compared, mut longer) = (0, Vec::new());
    let all = [cases(&charts_folder()), cases(&vectors_folder()), field_cases()];
    for case in all.into_iter().flatten() {
        let is_step = |line: &&str| line.trim_start().split(' ').any(|word| word == "step");
        if case.text.lines().filter(is_step).count() >= SMALL {
            continue;
        }
        for (name, target) in &targets {
            let (Some(bits), Some(switch)) =
                (lines(&case, Encoding::SinglePhase, target), lines(&case, Encoding::Switch, target))
            else {
                continue;
            };
            compared += 1;
            if switch > bits {
                longer.push(format!("{} in {name}: {switch} lines, a bit a step takes {bits}", case.name));
            }
        }
    }
    assert!(compared > 200, "only {compared} charts");
    assert!(longer.is_empty(), "{}", longer.join("\n"));
}
