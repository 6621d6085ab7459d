//! A small change of a chart is a small change of the code made of it, in every target that is text and in every encoding:
//! what is called something is called after elements of the chart, never by how many came before it.
//!
//! In drawn bodies everything has a number and a place, so they are no part of this. Neither are, in `switch`, steps that
//! are added before others: steps that are words are numbered in their order, steps that are numbers keep them.

use grafc::{Options, Product};
use grafc_backends::choice::Chosen;
use grafc_backends::{Target, plcopen};
use grafc_diagnostics::FileId;
use grafc_logic::{Encoding, Options as Lowering};
use grafc_model::reaction::Profile;
use std::path::Path;

/// A change of a text: what it is, what is looked for, and what stands there then.
type Edit = (&'static str, &'static str, &'static str);

const GARAGE: &[Edit] = &[
    (
        "a transition at the top",
        "transition \"button\"",
        "transition \"lock\" Closed -> Stopped : obstacle and not remote\ntransition \"button\"",
    ),
    (
        "a transition in the middle",
        "transition \"closed\"",
        "transition \"jam\" Open -> Stopped : obstacle\ntransition \"closed\"",
    ),
    (
        "a transition at the end",
        "\n// the light",
        "\ntransition \"home\" Stopped -> Closed : is_closed and not remote\n// the light",
    ),
    ("no transition at the top", "transition \"button\"           Closed  -> Opening : ↑remote\n", ""),
    (
        "no transition in the middle",
        "transition \"stop\"             Opening -> Stopped : ↑remote and not is_open\n",
        "",
    ),
    ("no transition at the end", "transition \"go on\"            Stopped -> Closing : ↑remote and not obstacle\n", ""),
    (
        "an input at the top",
        "input  remote \"remote control\", ",
        "input  remote \"remote control\", key \"key switch\", ",
    ),
    ("an output of a step", "{ open_door beacon }", "{ open_door beacon light2 }"),
    ("a condition", ": ↑remote and not is_open", ": ↑remote and not is_open and not is_closed"),
    (
        "a stored action",
        "step Stopped   \"stopped on the way by the remote\"",
        "step Stopped \"stopped\" { stops := stops + 1 on activation }",
    ),
    ("a delay at the top", "Closed  -> Opening : ↑remote", "Closed  -> Opening : ↑remote and 5s/is_closed"),
    ("a comment", "\"door opens\"", "\"the door is opening\""),
    (
        "a step at the end",
        "\n// the light",
        "\nstep Service \"out of order\"\ntransition Stopped -> Service : is_open and not remote\n// the light",
    ),
];

const MODES: &[Edit] = &[
    (
        "a transition of the modes at the top",
        "  transition D1 -> A6",
        "  transition D1 -> F1 : PBES and CS\n  transition D1 -> A6",
    ),
    (
        "a transition of the cycle at the top",
        "  transition (1)",
        "  transition 1 -> 11 : z and not S0\n  transition (1)",
    ),
    (
        "a transition of the cycle at the end",
        "  transition (10)",
        "  transition 11 -> 9 : not S0 and S1\n  transition (10)",
    ),
    ("no transition at the top", "  transition D1 -> A6 : not PBES\n", ""),
    ("a step at the top of the cycle", "  step 2 \"weigh A\"", "  step 12 \"rinse\" { VC }\n  step 2 \"weigh A\""),
    ("another order", "force G10{}", "force G10{5}"),
];

fn edits() -> Vec<(String, &'static [Edit])> {
    let read = |file: &str| {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(file);
        std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
    };
    let garage = read("cases/garage/chart.gct")
        .replace("\"warning beacon\" : bool", "\"warning beacon\", light2 : bool")
        .replace("output cycles", "output stops : udint\noutput cycles");
    vec![(garage, GARAGE), (read("charts/weigh_mix_b5.gct"), MODES)]
}

/// The targets that are text.
fn targets() -> Vec<(String, Target)> {
    let mut targets = Vec::new();
    for about in Target::ALL {
        if about.name == "plcopen" {
            continue;
        }
        let target = about.target(&Chosen::new()).unwrap_or_else(|e| panic!("{}: {e:?}", about.name));
        if !target.writes_statements() {
            continue;
        }
        targets.push((about.name.to_owned(), target));
    }
    for dialect in [plcopen::Dialect::Neutral, plcopen::Dialect::Codesys] {
        let options = plcopen::Options { dialect, ..plcopen::Options::default() };
        targets.push((format!("plcopen {dialect:?}"), Target::Plcopen(options)));
    }
    targets
}

fn made(text: &str, encoding: Encoding, target: &Target) -> Vec<String> {
    let lowering = Lowering { profile: Profile::default(), encoding, simplify: true };
    let options = Options::new(lowering, Product::Code(target.clone()));
    let (made, diagnostics) = grafc::compile(FileId::default(), text, "chart", &options);
    made.unwrap_or_else(|| panic!("{diagnostics:?}\n{text}")).text.lines().map(str::to_owned).collect()
}

/// How many lines one text has and the other has not: those that a longest common sequence leaves over.
fn difference(a: &[String], b: &[String]) -> usize {
    let mut row = vec![0_usize; b.len() + 1];
    for x in a {
        let mut diagonal = 0;
        for (place, y) in b.iter().enumerate() {
            let above = row[place + 1];
            row[place + 1] = if x == y { diagonal + 1 } else { above.max(row[place]) };
            diagonal = above;
        }
    }
    a.len() + b.len() - 2 * row[b.len()]
}

/// The most lines that an edit may change: those of the text that are about what was changed, and, of a variable that is
/// new, its declarations. In XML these are several lines each, in a list an instruction is a line.
fn most(target: &str) -> usize {
    match target {
        "st" | "scl" | "tcpou" => 30,
        "iec61131-10" | "il" | "awl" | "rust" => 40,
        // What a micro-step shows stands beside what it does, and where steps overlap it is worked out anew.
        "js" => 60,
        _ => 45,
    }
}

#[test]
fn a_small_edit_changes_few_lines() {
    let mut worst: Vec<String> = Vec::new();
    for (text, edits) in edits() {
        for (what, from, to) in edits {
            assert_eq!(text.matches(from).count(), 1, "{from:?}");
            let edited = text.replace(from, to);
            for encoding in Encoding::ALL {
                for (name, target) in targets() {
                    let (before, after) = (made(&text, encoding, &target), made(&edited, encoding, &target));
                    let lines = difference(&before, &after);
                    if lines > most(&name) {
                        worst.push(format!("{lines} lines of {}: {what}, {} {name}", before.len(), encoding.name()));
                    }
                }
            }
        }
    }
    assert!(worst.is_empty(), "{}", worst.join("\n"));
}

/// Where nothing follows from it but the transition itself: one inserted at the top of the garage.
#[test]
fn a_transition_at_the_top_is_a_few_lines() {
    let (text, edits) = edits().swap_remove(0);
    let (_, from, to) = edits[0];
    let edited = text.replace(from, to);
    let targets: Vec<Target> =
        targets().into_iter().filter(|(name, _)| name == "st").map(|(_, target)| target).collect();
    for encoding in Encoding::ALL {
        let (before, after) = (made(&text, encoding, &targets[0]), made(&edited, encoding, &targets[0]));
        let lines = difference(&before, &after);
        assert!(lines <= 10, "{lines} of {}: {}", before.len(), encoding.name());
    }
}

#[test]
fn differences_are_counted() {
    let lines = |text: &str| text.split(' ').map(str::to_owned).collect::<Vec<_>>();
    assert_eq!(difference(&lines("a b c"), &lines("a b c")), 0);
    assert_eq!(difference(&lines("a b c"), &lines("a x b c")), 1);
    assert_eq!(difference(&lines("a b c"), &lines("a y c")), 2);
    assert_eq!(difference(&lines("a b c"), &lines("c a b")), 2);
}

#[test]
fn the_targets_are_those_that_there_are() {
    // So that a new one is not left out. Charts that evolve to stability are no sequential function charts.
    assert_eq!(targets().len(), Target::ALL.len());
}
