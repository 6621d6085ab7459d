//! Each invariant of a net, broken: [`verify()`] must say so.

use grafc_diagnostics::{Diagnostics, FileId};
use grafc_model::chart::{GrafcetId, MacroId, Order, Run, Situation, StepId, TransitionId};
use grafc_net::net::{Forced, RankedOrder, Steps};
use grafc_net::{Fact, Net, build, passes, verify};

/// Macro-steps, orders, nested enclosures and a ring of two.
const TEXT: &str = "
    input a : bool
    grafcet G1 {
      initial step 1 { force G2{} force G2{*} }
      step 2 { force G2{20, 21} }
      macro step M1
      transition 1 -> 2 : a
      transition 2 -> 1 : a
      transition 2 -> M1 : a
    }
    expansion M1 { step E1 step S1 transition E1 -> S1 : a }
    grafcet G2 { initial enclosing step 20 step 21 transition 20 -> 21 : a }
    grafcet X20/G3 { initial enclosing activated step 30 step 31 transition 30 -> 31 : a }
    grafcet X30/G4 { initial activated step 40 step 41 transition 40 -> 41 : a }
";

fn built() -> Net {
    net(TEXT)
}

fn net(text: &str) -> Net {
    let (tree, diagnostics) = grafc_syntax::parse(FileId::default(), text);
    assert!(!diagnostics.has_errors(), "{diagnostics:?}");
    let (chart, diagnostics) = grafc_model::check(&tree, "chart");
    build(&chart.unwrap_or_else(|| panic!("{diagnostics:?}")))
}

fn flat() -> Net {
    passed(built())
}

fn passed(mut net: Net) -> Net {
    passes::run(&mut net, true, &mut Diagnostics::new());
    net
}

fn within(step: usize) -> Steps {
    [StepId::new(step)].into_iter().collect()
}

fn step(net: &Net, label: &str) -> StepId {
    net.places.iter_enumerated().find(|(_, place)| place.label == label).expect("the step").0
}

fn grafcet(net: &Net, name: &str) -> GrafcetId {
    net.grafcets.iter_enumerated().find(|(_, grafcet)| grafcet.name == name).expect("the grafcet").0
}

/// A net that verifies must not do so after the change, and must say what this is.
fn broken(good: &Net, says: &str, change: impl Fn(&mut Net)) {
    assert_eq!(verify(good), Ok(()));
    let mut net = good.clone();
    change(&mut net);
    match verify(&net) {
        Ok(()) => panic!("not found: {says}"),
        Err(fault) => assert!(fault.contains(says), "`{fault}` does not say `{says}`"),
    }
}

#[test]
fn ids_lie_in_their_tables() {
    let (net, far) = (flat(), StepId::new(99));
    let g3 = grafcet(&net, "G3");
    broken(&net, "place 99", |n| n.transitions[TransitionId::new(0)].pre.push(far));
    broken(&net, "place 99", |n| n.transitions[TransitionId::new(0)].within = within(99));
    broken(&net, "place 99", |n| n.places[StepId::new(0)].within = within(99));
    broken(&net, "place 99", |n| n.grafcets[g3].steps.push(far));
    broken(&net, "place 99", |n| n.grafcets[g3].enclosing_step = Some(far));
    broken(&net, "place 99", |n| n.macro_steps[MacroId::new(0)].places.push(far));
    broken(&net, "macro-step 9", |n| n.macro_steps[MacroId::new(0)].inner.push(MacroId::new(9)));
    broken(&net, "transition 99", |n| n.macro_steps[MacroId::new(0)].left_by.push(TransitionId::new(99)));
    broken(&net, "grafcet 9", |n| n.grafcets[g3].frozen_with = Some(GrafcetId::new(9)));
    broken(&net, "grafcet 9", |n| n.hierarchy.push(GrafcetId::new(9)));
    let order = |step, forced| RankedOrder { step, forced, span: net.grafcets[g3].span };
    broken(&net, "place 99", |n| n.grafcets[g3].orders.push(order(far, Forced::Current)));
    let within = Forced::Steps(vec![far]);
    broken(&net, "place 99", |n| n.grafcets[g3].orders.push(order(StepId::new(0), within.clone())));
}

#[test]
fn lists_hold_each_thing_once_and_in_order() {
    let net = flat();
    let (g1, g2, g3) = (grafcet(&net, "G1"), grafcet(&net, "G2"), grafcet(&net, "G3"));
    broken(&net, "twice on one side", |n| n.transitions[TransitionId::new(0)].pre.push(StepId::new(0)));
    broken(&net, "crosses the frame", |n| {
        let outside = step(n, "20");
        n.transitions[TransitionId::new(0)].pre.push(outside);
    });
    broken(&net, "out of order", |n| n.grafcets[g1].steps.swap(0, 1));
    broken(&net, "not listed", |n| n.grafcets[g1].steps.truncate(3));
    broken(&net, "lists", |n| {
        let moved = n.grafcets[g2].steps.pop().expect("a step");
        n.grafcets[g3].steps.push(moved);
    });
    broken(&net, "twice in the hierarchy", |n| n.hierarchy.push(g1));
    broken(&net, "no place in the hierarchy", |n| n.hierarchy.truncate(3));
    broken(&net, "acts on it", |n| n.hierarchy.swap(0, 1));
    broken(&built(), "twice at an end", |n| n.macro_steps[MacroId::new(0)].entered_by.push(TransitionId::new(2)));
}

#[test]
fn facts_hold() {
    let net = flat();
    let (g2, g3) = (grafcet(&net, "G2"), grafcet(&net, "G3"));
    for (fact, says) in [
        (Fact::NoMacroSteps, "still has arcs"),
        (Fact::RankedOrders, "not ranked"),
        (Fact::SettledStart, "initial within"),
        (Fact::NoEnclosures, "still has an enclosing step"),
        (Fact::NoTwoStepRings, "hand over to each other"),
    ] {
        // As built, and with the enclosing step 20 inactive while the enclosed 30 is initial.
        broken(&built(), says, |n| {
            let enclosing = step(n, "20");
            n.places[enclosing].initial = false;
            n.facts.push(fact);
        });
    }

    let span = net.grafcets[g2].span;
    let order = Order { step: StepId::new(0), grafcet: g2, situation: Situation::Current, span };
    broken(&net, "not ranked", |n| n.orders.push(order.clone()));
    broken(&net, "out of order", |n| {
        let Forced::Steps(steps) = &mut n.grafcets[g2].orders[2].forced else { panic!("{{20, 21}}") };
        steps.reverse();
    });
    broken(&net, "comes after a lower one", |n| {
        let lower = RankedOrder { step: step(n, "30"), forced: Forced::Current, span };
        let higher = RankedOrder { step: step(n, "1"), forced: Forced::Current, span };
        let g4 = grafcet(n, "G4");
        n.grafcets[g4].orders = vec![lower, higher];
    });

    broken(&net, "is forced to", |n| {
        let s = step(n, "21");
        n.places[s].initial = true;
    });
    broken(&net, "is initial within", |n| {
        let s = step(n, "30");
        n.places[s].initial = true;
    });
    broken(&net, "but no step", |n| {
        let s = step(n, "2_1");
        n.places[s].initial = true;
    });
    broken(&net, "conflict at the start is wrong", |n| n.conflict_at_start = false);

    broken(&net, "is frozen with", |n| n.grafcets[g3].frozen_with = None);
    let g4 = grafcet(&net, "G4");
    broken(&net, "is frozen with", |n| n.grafcets[g4].frozen_with = Some(g3));

    broken(&net, "still has an enclosing step", |n| n.grafcets[g3].enclosing_step = Some(step(n, "20")));
    broken(&net, "not within the same place", |n| {
        let s = step(n, "31");
        n.places[s].within.clear();
    });
    broken(&net, "not within the same place", |n| n.transitions.last_mut().expect("the last").within = within(0));
    broken(&net, "hand over to each other", |n| {
        let (one, two) = (step(n, "1"), step(n, "2"));
        let back = n.transitions.iter_mut().find(|t| t.pre[..] == [two]).expect("2 -> 2_1");
        back.post = [one].into_iter().collect();
    });
}

#[test]
fn nothing_is_said_before_its_pass() {
    let net = built();
    let g3 = grafcet(&net, "G3");
    let span = net.grafcets[g3].span;
    let order = RankedOrder { step: StepId::new(0), forced: Forced::Current, span };
    broken(&net, "orders are ranked", |n| n.grafcets[g3].orders.push(order.clone()));
    broken(&net, "before the start", |n| n.conflict_at_start = true);
    broken(&net, "freezing is closed", |n| n.grafcets[g3].frozen_with = Some(GrafcetId::new(0)));
    broken(&net, "enclosure is flat", |n| n.places[StepId::new(0)].within = within(1));
}

/// A child that steps of its parent run, and an enclosure in it.
const RUN: &str = "
    input a : bool
    grafcet G1 { initial step 1 { run G2 } step 2 { run G2 } step 3 transition 1 -> 2 : a transition 2 -> 3 : a }
    child grafcet G2 of G1 { initial enclosing step 20 step 21 transition 20 -> 21 : a }
    grafcet X20/G3 { initial activated step 30 }
";

#[test]
fn a_nested_child_follows_its_steps_alone() {
    let net = passed(net(RUN));
    let g2 = grafcet(&net, "G2");
    assert_eq!(net.within(g2), [step(&net, "1"), step(&net, "2")]);
    broken(&net, "is nested, and", |n| {
        let (run, span) = (step(n, "3"), n.grafcets[g2].span);
        n.runs.push(Run { step: run, grafcet: g2, span });
    });
    // Step 1, which runs it, is initial; without it nothing is.
    broken(&net, "is initial within", |n| {
        let one = step(n, "1");
        n.places[one].initial = false;
    });
    broken(&net, "is frozen with", |n| n.grafcets[g2].frozen_with = Some(grafcet(n, "G1")));
    let around = |steps: [usize; 2]| -> Steps { steps.into_iter().map(StepId::new).collect() };
    let put = |n: &mut Net, steps: [usize; 2]| {
        for s in n.grafcets[g2].steps.clone() {
            n.places[s].within = around(steps);
        }
        n.transitions.iter_mut().filter(|t| t.grafcet == g2).for_each(|t| t.within = around(steps));
    };
    broken(&net, "out of order", |n| put(n, [1, 0]));
    let other = passed(self::net(&format!("{RUN} grafcet G0 {{ initial step 9 }}")));
    let last = step(&other, "9").index();
    broken(&other, "of several grafcets", |n| {
        let g0 = n.hierarchy.iter().position(|g| n.grafcets[*g].name == "G0").expect("G0");
        let g0 = n.hierarchy.remove(g0);
        n.hierarchy.insert(0, g0);
        put(n, [0, last]);
    });
    broken(&self::net(RUN), "child is nested", |n| {
        n.facts.push(Fact::NoEnclosures);
        n.grafcets.iter_mut().for_each(|g| g.enclosing_step = None);
        put(n, [0, 1]);
    });
}
