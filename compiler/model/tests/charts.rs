//! Whole charts of the standard pass every rule, and come out as they were drawn.

use grafc_diagnostics::FileId;
use grafc_model::chart::{Chart, MacroId, Node, StepId};

/// A chart about which nothing is to be said but these warnings.
fn chart_with(warnings: &[&str], text: &str) -> Chart {
    let (tree, diagnostics) = grafc_syntax::parse(FileId::new(0), text);
    assert!(diagnostics.is_empty(), "{diagnostics:#?}");
    let (chart, diagnostics) = grafc_model::check(&tree, "file_name");
    let codes: Vec<&str> = diagnostics.iter().map(|d| d.code.as_str()).collect();
    assert_eq!(codes, warnings, "{diagnostics:#?}");
    chart.expect("there are only warnings")
}

fn chart(text: &str) -> Chart {
    chart_with(&[], text)
}

fn labels(chart: &Chart, steps: &[StepId]) -> Vec<String> {
    steps.iter().map(|&step| chart.steps[step].label.to_string()).collect()
}

/// IEC 60848, annex B: one grafcet, a divergence, a counter, a delay by a constant.
#[test]
fn weighing_and_mixing() {
    let chart = chart(
        r#"chart Weigh_mix "automatic weighing-mixing"
        input  CS "cycle start", TD, a, b, z, S0, S1 : bool
        output VA, VB, VC, BM, MR, TM_up, TM_down : bool
        var    bricks : int := 0
        const  mix_time : time := 8s
        grafcet G1 {
          initial step 1 "ready"
          step 2 { VA }  step 3 { VB }  step 4 { VC }  step 5
          step 6 { BM bricks := 0 on activation }  step 7 { BM bricks := bricks + 1 on activation }  step 8
          step 9 { MR }  step 10 { MR TM_down }  step 11 { MR TM_up }
          transition (1) 1 -> 2, 6 : CS and z and S0
          transition (2) 2 -> 3 : a  transition (3) 3 -> 4 : b  transition (4) 4 -> 5 : z
          transition (5) 6 -> 7 : ↑TD  transition (6) 7 -> 8 : ↑TD
          transition (7) 5, 8 -> 9 : 1
          transition (8) 9 -> 10 : mix_time/X9  transition (9) 10 -> 11 : S1  transition (10) 11 -> 1 : S0
        }"#,
    );
    assert_eq!(chart.name, "Weigh_mix");
    assert_eq!(chart.comment.as_deref(), Some("automatic weighing-mixing"));
    assert_eq!((chart.steps.len(), chart.transitions.len(), chart.grafcets.len()), (11, 10, 1));
    assert_eq!(chart.variables[0].comment.as_deref(), Some("cycle start"));
    assert_eq!(chart.transitions[6].designation.as_deref(), Some("7"));
    assert_eq!(chart.transitions[6].pre[..], [Node::Step(StepId::new(4)), Node::Step(StepId::new(7))]);
}

/// IEC 60848, figure 3: enclosures in an enclosure.
#[test]
fn nested_enclosures() {
    let chart = chart(
        "input p, m, a, b : bool
         grafcet X88/G24 { activated step 100 step 101 transition 100 -> 101 : b }
         grafcet X23/G1 { initial activated step 85 enclosing step 88 activated step 1 transition 85 -> 88 : a }
         grafcet X23/G2 { initial activated step 2 }
         grafcet G0 { initial enclosing step 23 step 20 transition 23 -> 20 : p transition 20 -> 23 : m }",
    );
    let levels: Vec<(&str, u32)> = chart.grafcets.iter().map(|g| (g.name.as_str(), g.level)).collect();
    assert_eq!(levels, [("G24", 2), ("G1", 1), ("G2", 1), ("G0", 0)]);
    let order: Vec<&str> = chart.hierarchy.iter().map(|&g| chart.grafcets[g].name.as_str()).collect();
    assert_eq!(order, ["G0", "G1", "G2", "G24"]);
}

/// IEC 60848, 6.3.4: a source transition and a sink transition; nothing is active at the start.
#[test]
fn shift_register() {
    let chart = chart(
        "input pp, av : bool step 1 step 2 step 3 step 4
         transition -> 1 : pp · ↑av  transition 1 -> 2 : ↑av  transition 2 -> 3 : ↑av
         transition 3 -> 4 : ↑av  transition 4 -> : ↑av",
    );
    assert_eq!(chart.name, "file_name");
    assert_eq!(chart.grafcets[0].name, "G1");
    assert!(chart.transitions[0].pre.is_empty() && chart.transitions[4].post.is_empty());
}

/// IEC 60848, table 10, symbol 42: steps of an expansion belong to the grafcet of the macro-step, wherever it stands.
#[test]
fn macro_steps() {
    let chart = chart(
        "input a, b, c, d : bool output V : bool
         expansion M3 { step E3 step 30 { V } macro step M4 step S3
                        transition E3 -> 30 : b transition 30 -> M4 : c transition M4 -> S3 : a }
         grafcet G1 { initial step 1 macro step M3 step 2 transition 1 -> M3 : a transition M3 -> 2 : d and XM3 }
         grafcet G2 { initial step 7 { V if XM4 } }
         expansion M4 { step E4 step S4 transition E4 -> S4 : 1 }",
    );
    assert_eq!(labels(&chart, &chart.grafcets[0].steps), ["E3", "30", "S3", "1", "2", "E4", "S4"]);
    let [inner, outer] = &chart.macro_steps.raw[..] else { panic!("two macro-steps") };
    assert_eq!((inner.label.as_str(), outer.label.as_str()), ("M4", "M3"));
    let (m4, m3) = (MacroId::new(0), MacroId::new(1));
    assert_eq!(
        labels(&chart, &[chart.entry(m4), chart.exit(m4), chart.entry(m3), chart.exit(m3)]),
        ["E4", "S4", "E3", "S3"]
    );
    assert_eq!(inner.expansion_of.map(|id| id.index()), Some(1));
    assert_eq!(outer.expansion_of, None);
}

/// Orders of initial steps, on an enclosure, and on two levels.
#[test]
fn forcing() {
    chart(
        "input n : bool grafcet G1 { initial step 1 { force G2{} } step 0 transition 1 -> 0 : n }
         grafcet G2 { initial step 10 }",
    );
    chart(
        "input m, z : bool grafcet G1 { initial step 0 step 1 { force G5{51} } transition 0 -> 1 : m }
         grafcet G2 { initial step 4 enclosing step 5 transition 4 -> 5 : z }
         grafcet X5/G5 { activated step 52 step 51 }",
    );
    let chart = chart(
        "input m, z, a : bool
         grafcet G1 { initial step 0 step 1 { force G3{} } step 2 { force G2{21} } transition 0 -> 1, 2 : m }
         grafcet G2 { initial step 20 step 21 { force G3{31} } transition 20 -> 21 : z }
         grafcet G3 { initial step 30 step 31 transition 30 -> 31 : a }",
    );
    let levels: Vec<u32> = chart.grafcets.iter().map(|grafcet| grafcet.level).collect();
    assert_eq!(levels, [0, 1, 2]);
}

/// An enclosing step that is active from the start and never left: its enclosure has a link all the same.
#[test]
fn an_enclosure_that_runs_empty() {
    chart_with(
        &["W0406"],
        "input a, b : bool grafcet G1 { initial enclosing step 5 }
         grafcet X5/G5 { initial activated step 51 step 52 transition 51 -> : a transition -> 52 : b }",
    );
}
