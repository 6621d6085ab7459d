//! Reactions that do not end by themselves: what outputs do then, which bound is enough, and that it costs little to know.

use grafc_logic::{Analysis, Options};
use grafc_model::chart::Chart;
use grafc_model::reaction::{LivelockOutputs, Profile};
use grafc_model::simulate::Simulator;
use grafc_testsuite::charts::{check, stimuli};
use grafc_testsuite::expected::all_agree;
use grafc_testsuite::random::{ChartKind, checked, trace};

const RING: &str = "\
chart Ring
input go : bool
output A, B, C : bool
output n : int
initial step 1 { A }
step 2 { B }
step 3 { C   n := n + 1 on activation }
transition 1 -> 2 : go
transition 2 -> 3 : go
transition 3 -> 1 : go
";

const TRACE: &str = "t_ms,go\n0,0\n10,1\n20,0\n30,1\n40,1\n";

/// Four micro-steps a call: at 10 ms from 1 to 2, 3 (n = 1), 1 and 2; at 30 ms from 2 to 3 (2), 1, 2 and 3 (3); at 40 ms
/// from 3 to 1, 2, 3 (4) and 1. At 0 and 20 ms nothing moves, so outputs are what the situation says in any case. `n` is
/// set by a stored action, so it keeps its value.
#[test]
fn outputs_of_steps_do_what_was_chosen() {
    let table = |rows: [&str; 3]| {
        let [ten, thirty, forty] = rows;
        format!(
            "t_ms,A,B,C,n,situation,flags\n0,1,0,0,0,1,\n10,{ten},1,2,LIVELOCK\n20,0,1,0,1,2,LIVELOCK\n\
             30,{thirty},3,3,LIVELOCK\n40,{forty},4,1,LIVELOCK\n"
        )
    };
    let chart = check("ring", RING).expect("a chart without errors");
    let stimuli = stimuli("ring", TRACE, &chart).expect("a trace without errors");
    for (livelock_outputs, rows) in [
        (LivelockOutputs::Computed, ["0,1,0", "0,0,1", "1,0,0"]),
        // What the call before showed, be it held itself.
        (LivelockOutputs::Hold, ["1,0,0", "0,1,0", "0,1,0"]),
        (LivelockOutputs::Off, ["0,0,0", "0,0,0", "0,0,0"]),
    ] {
        let expected = table(rows);
        let profile = Profile { bound: Some(4), livelock_outputs, ..Profile::default() };
        all_agree(&chart, profile, &stimuli, &expected).unwrap_or_else(|fault| panic!("{livelock_outputs:?}: {fault}"));
    }
}

/// A ring of seven steps whose conditions always hold: K micro-steps lead to step K mod 7, and the largest K there is takes
/// no time, since 2147483647 is 7 times 306783378 and 1.
#[test]
fn whole_rounds_are_left_out() {
    let mut text = String::from("output y : bool\n");
    for step in 0..7 {
        let initial = if step == 0 { "initial " } else { "" };
        text += &format!("{initial}step {step}\ntransition {step} -> {} : 1\n", (step + 1) % 7);
    }
    let chart = check("seven", &text).expect("a chart without errors");
    let row = stimuli("seven", "t_ms\n0\n", &chart).expect("a row");
    for (bound, step) in [(1, 1), (6, 6), (7, 0), (8, 1), (15, 1), (1_000, 6), (1_001, 0), (2_147_483_647, 1)] {
        let profile = Profile { bound: Some(bound), ..Profile::default() };
        let response = Simulator::new(&chart, profile).react(&row[0]);
        assert_eq!(response.situation, [grafc_model::chart::StepId::new(step)], "{bound}");
        assert!(response.flags.livelock);
    }
}

/// What nobody looks at is left out, what somebody looks at is not, and both come to the same.
#[test]
fn what_is_left_out_makes_no_difference() {
    let kinds = [ChartKind::Hierarchical, ChartKind::Flat];
    let mut hits = 0;
    for seed in 8000..8120_u64 {
        let drawn = checked(seed, kinds[seed as usize % 2]);
        let profile = Profile { bound: Some(40 + seed as u32 % 50), ..Profile::default() };
        let (mut short, mut long) = (Simulator::new(&drawn.chart, profile), Simulator::new(&drawn.chart, profile));
        for stimulus in trace(seed, &drawn.chart, 20) {
            let response = short.react(&stimulus);
            assert_eq!(response, long.react_observed(&stimulus, &mut |_| ()), "seed {seed}");
            hits += usize::from(response.flags.livelock);
        }
    }
    assert!(hits > 100, "{hits} calls after a livelock");
}

fn known_bound(chart: &Chart) -> Option<u32> {
    let mut net = grafc_net::build(chart);
    grafc_net::passes::run(&mut net, false, &mut grafc_diagnostics::Diagnostics::new());
    Analysis::new(net).known_bound()
}

#[test]
fn a_bound_is_known_where_the_situation_decides() {
    let known = |text: &str| known_bound(&check("chart", text).expect("a chart without errors"));
    let ring = RING.replace("   n := n + 1 on activation", "");
    // Three situations, one for edges of inputs, and one that finds nothing.
    assert_eq!(known(&ring), Some(5));
    // A counter may let it go round as often as it likes.
    assert_eq!(known(RING), None);
    // An edge of an input is over after one micro-step, so no step can follow another: one that moves, one that finds nothing.
    let edges = "input a : bool initial step 1 step 2 transition 1 -> 2 : ↑a transition 2 -> 1 : ↑a";
    assert_eq!(known(edges), Some(2));
    // How long a step has lasted says more than the situation.
    assert_eq!(known(&ring.replace("2 -> 3 : go", "2 -> 3 : [T2 < 5s]")), None);
}

/// A reaction that the known bound ends is one that would never end.
#[test]
fn no_reaction_that_ends_hits_the_known_bound() {
    let kinds = [ChartKind::Hierarchical, ChartKind::Flat, ChartKind::Plain];
    let (mut known, mut hits) = (0, 0);
    for seed in 9000..9800_u64 {
        let drawn = checked(seed, kinds[seed as usize % 3]);
        let Some(bound) = known_bound(&drawn.chart) else { continue };
        known += 1;
        let profile = |bound| Profile { bound: Some(bound), ..Profile::default() };
        let (mut tight, mut wide) =
            (Simulator::new(&drawn.chart, profile(bound)), Simulator::new(&drawn.chart, profile(1_000_000)));
        for stimulus in trace(seed, &drawn.chart, 30) {
            let (tight, wide) = (tight.react(&stimulus), wide.react(&stimulus));
            assert_eq!(tight.flags.livelock, wide.flags.livelock, "seed {seed}, bound {bound}\n{}", drawn.text);
            if wide.flags.livelock {
                hits += 1;
                break;
            }
            assert_eq!(tight, wide, "seed {seed}");
        }
    }
    assert!(known > 200 && hits > 3, "{known} charts, {hits} of them without rest");
}

#[test]
fn code_says_its_worst_case() {
    let mut options = grafc::Options::new(Options::default(), grafc::Product::Program);
    let mut first_lines = |as_known| {
        let target = grafc_backends::st::Options { header: vec!["ring.gct".into()], ..Default::default() };
        options.product = grafc::Product::Code(grafc::Target::St(target));
        options.bound_as_known = as_known;
        let text = RING.replace("   n := n + 1 on activation", "");
        let (made, diagnostics) = grafc::compile(Default::default(), &text, "ring", &options);
        let text = made.unwrap_or_else(|| panic!("{diagnostics:?}")).text;
        text.lines().find(|line| line.contains("at most")).expect("a line").trim().to_owned()
    };
    assert!(first_lines(false).contains("A call takes at most 200 micro-steps, "));
    assert!(first_lines(true).contains("A call takes at most 5 micro-steps, "));
}
