//! The bound on micro-steps that the compiler proves is never exceeded by the reference simulator.

use grafc_diagnostics::Diagnostics;
use grafc_model::reaction::Profile;
use grafc_model::simulate::Simulator;
use grafc_testsuite::random::{Kind, checked, trace};

#[test]
fn no_reaction_needs_more_micro_steps_than_is_proved() {
    let (mut proved, mut tight) = (0, 0);
    for kind in [Kind::Plain, Kind::Flat, Kind::Hierarchical] {
        for seed in 0..120 {
            let drawn = checked(seed, kind);
            let mut net = grafc_net::build(&drawn.chart);
            grafc_net::passes::run(&mut net, false, &mut Diagnostics::new());
            let transients = grafc_logic::analyse(&net).transients;
            let Some(longest) = transients.longest else { continue };
            proved += 1;
            let mut simulator = Simulator::new(&drawn.chart, Profile { bound: Some(10_000), ..Profile::default() });
            let mut most = 0;
            for (row, stimulus) in trace(seed, &drawn.chart, 40).iter().enumerate() {
                let mut seen = 0;
                simulator.react_observed(stimulus, &mut |_| seen += 1);
                // The start of the initial reaction is seen as well.
                let micro_steps = seen - u32::from(row == 0);
                most = most.max(micro_steps);
                assert!(micro_steps <= longest, "seed {seed}, {kind:?}: {micro_steps} > {longest}\n{}", drawn.text);
            }
            tight += u32::from(most == longest);
        }
    }
    assert!(proved >= 60, "only {proved} of 360 charts have a bound");
    assert!(tight >= 15, "only {tight} of {proved} bounds were reached, so the test sees little");
}
