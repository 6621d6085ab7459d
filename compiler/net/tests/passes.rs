//! The net as built, its invariants, and what each pass does to it.

use grafc_diagnostics::{Diagnostics, FileId};
use grafc_model::chart::{MacroId, StepId, TransitionId};
use grafc_net::{Fact, Net, build, passes, verify};

fn net(text: &str) -> Net {
    let (tree, said) = grafc_syntax::parse(FileId::default(), text);
    assert!(!said.has_errors(), "{said:?}");
    let (chart, said) = grafc_model::check(&tree, "chart");
    build(&chart.unwrap_or_else(|| panic!("{said:?}")))
}

fn labels(net: &Net, steps: &[StepId]) -> Vec<String> {
    steps.iter().map(|s| net.places[*s].label.clone()).collect()
}

const MACRO: &str = "
    input a, b, c : bool
    initial step 1
    macro step M3
    step 2
    transition 1 -> M3 : a
    transition M3 -> 2 : b
    expansion M3 {
      step E3
      macro step M4
      step S3
      transition E3 -> M4 : c
      transition M4 -> S3 : c
    }
    expansion M4 { step E4 step S4 transition E4 -> S4 : 1 }
";

#[test]
fn arcs_of_a_macro_step_lead_to_its_entry_and_from_its_exit() {
    let mut net = net(MACRO);
    assert_eq!(labels(&net, &net.transitions[TransitionId::new(0)].post), [""; 0], "still an arc into M3");
    let mut said = Diagnostics::new();
    passes::run(&mut net, &mut said);
    assert!(said.is_empty() && net.facts.contains(&Fact::NoMacroSteps));
    let arcs: Vec<_> = net.transitions.iter().map(|t| (labels(&net, &t.pre), labels(&net, &t.post))).collect();
    let arc = |from: &str, to: &str| (vec![from.to_owned()], vec![to.to_owned()]);
    assert_eq!(arcs, [arc("1", "E3"), arc("S3", "2"), arc("E3", "E4"), arc("S4", "S3"), arc("E4", "S4")]);
}

#[test]
fn the_activity_of_a_macro_step_is_that_of_its_expansion() {
    let net = net(MACRO);
    let outer = &net.macro_steps[MacroId::new(0)];
    assert_eq!(labels(&net, &outer.places), ["E3", "S3"]);
    assert_eq!(outer.inner, [MacroId::new(1)], "nested expansions count too");
}

#[test]
fn a_broken_net_does_not_verify() {
    let good = net(MACRO);
    assert_eq!(verify(&good), Ok(()));
    let broken = |change: fn(&mut Net)| {
        let mut net = good.clone();
        change(&mut net);
        verify(&net)
    };
    assert!(broken(|n| n.transitions[TransitionId::new(0)].pre.push(StepId::new(99))).is_err(), "no such place");
    assert!(broken(|n| n.transitions[TransitionId::new(0)].pre.push(StepId::new(0))).is_err(), "a place twice");
    assert!(broken(|n| n.facts.push(Fact::NoMacroSteps)).is_err(), "a fact that does not hold");
}
