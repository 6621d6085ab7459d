//! Child programs and pulse orders: what is read, what of it a mistake loses, and how it is laid out.

mod common;

use common::{chart, check, faults};
use grafc_diagnostics::FileId;
use grafc_syntax::ast::{Action, ActionKind, Chart, Event, Item, Pulse};

fn format(text: &str) -> String {
    assert!(check(text), "{text}");
    let formatted = grafc_syntax::format(text, &chart(text));
    assert_eq!(grafc_syntax::format(&formatted, &chart(&formatted)), formatted, "laid out twice");
    formatted
}

fn action(action: &Action) -> String {
    match &action.kind {
        ActionKind::Continuous { target, .. } => target.text.to_string(),
        ActionKind::Stored { assignment, .. } => format!("{} :=", assignment.target.text),
        ActionKind::Pulse { kind, grafcet, event } => {
            let event = match event {
                Event::Activation => "activation",
                Event::Deactivation => "deactivation",
                Event::Event(_) => "event",
                Event::EachScan(_) => "each scan",
            };
            format!("{}({}) on {event}", kind.word(), grafcet.text)
        }
        ActionKind::Run { grafcet } => format!("run({})", grafcet.text),
        ActionKind::Force { grafcet, .. } => format!("force({})", grafcet.text),
    }
}

fn pulse(pulse: &Pulse) -> String {
    format!("{}({})", pulse.kind.word(), pulse.grafcet.text)
}

/// Blocks, and what stands in the braces of steps and transitions.
fn outline(chart: &Chart) -> Vec<String> {
    let mut found = Vec::new();
    for item in &chart.items {
        match item {
            Item::Grafcet(grafcet) => {
                let of = grafcet.parent.as_ref().map(|parent| format!(" of {}", parent.text)).unwrap_or_default();
                found.push(format!("grafcet {}{of}, {} items", grafcet.name.text, grafcet.items.len()));
                for item in &grafcet.items {
                    match item {
                        Item::Step(step) => found.extend(step.actions.iter().map(action)),
                        Item::Transition(transition) => {
                            found.extend(transition.actions().iter().map(|a| format!("{} :=", a.target.text)));
                            found.extend(transition.pulses().iter().map(pulse));
                        }
                        Item::Declaration(_)
                        | Item::Grafcet(_)
                        | Item::Expansion(_)
                        | Item::Allow(_)
                        | Item::Claim(_)
                        | Item::Scenario(_) => {}
                    }
                }
            }
            Item::Step(step) => found.extend(step.actions.iter().map(action)),
            Item::Transition(transition) => found.extend(transition.pulses().iter().map(pulse)),
            Item::Declaration(declaration) => found.push(format!("{} names", declaration.names.len())),
            Item::Expansion(_) | Item::Allow(_) | Item::Claim(_) | Item::Scenario(_) => found.push("more".into()),
        }
    }
    found
}

fn read(text: &str) -> Vec<String> {
    assert!(check(text), "{text}");
    outline(&chart(text))
}

/// What is left of a chart with mistakes.
fn left(text: &str) -> Vec<String> {
    outline(&grafc_syntax::parse(FileId::new(0), text).0)
}

#[test]
fn a_child_and_all_orders_on_it() {
    let text = "\
grafcet MAIN {
  initial step 1 { start P on activation  kill P on deactivation V freeze P on event ↑a  resume P on event b and c run P }
  transition 1 -> 2 : a { C := 1 start P kill Q resume P freeze Q }
}
child grafcet P of MAIN \"below\" { initial step 10 }
";
    assert_eq!(
        read(text),
        [
            "grafcet MAIN, 2 items",
            "start(P) on activation",
            "kill(P) on deactivation",
            "V",
            "freeze(P) on event",
            "resume(P) on event",
            "run(P)",
            "C :=",
            "start(P)",
            "kill(Q)",
            "resume(P)",
            "freeze(Q)",
            "grafcet P of MAIN, 1 items",
        ]
    );
}

#[test]
fn the_words_stay_names() {
    // As variables, with all that may stand behind them.
    let text = "output child, of, start, kill, freeze, resume, run : bool \
                step 1 { start kill if freeze resume := 1 on activation run child of } \
                transition 1 -> 1 : start and run { kill := 1 freeze := 0 }";
    assert_eq!(read(text), ["7 names", "start", "kill", "resume :=", "run", "child", "of"]);
    // As grafcets, steps and children.
    let text =
        "grafcet start { step run { run run start start on activation } } child grafcet child of start { step of }";
    assert_eq!(
        read(text),
        ["grafcet start, 1 items", "run(run)", "start(start) on activation", "grafcet child of start, 1 items"]
    );
    // Two outputs, each its own action: a declared `run` is one.
    assert_eq!(read("output run, P : bool step 1 { run P }"), ["2 names", "run", "P"]);
    assert_eq!(read("output P, V : bool step 1 { run P }"), ["2 names", "run(P)"]);
    // Without an event, `start P` is two names, too.
    assert_eq!(read("step 1 { start P V }"), ["start", "P", "V"]);
    assert_eq!(read("step 1 { start P := 1 on activation }"), ["start", "P :="]);
    // In the heading of a chart and as its name.
    assert_eq!(read("chart child step 1 { run P }"), ["run(P)"]);
}

#[test]
fn a_mistake_costs_its_own_item() {
    let text = "\
grafcet MAIN {
  initial step 1 { start P on }
  step 2 { freeze P on event }
  step 3 { run P }
  transition 1 -> 2 : a { kill }
}
child grafcet P of { initial step 10 }
child grafcet Q of MAIN initial step 20 }
child grafcet R of MAIN { initial step 30 }
";
    assert_eq!(
        faults(text).iter().map(|fault| fault.split_once(' ').unwrap_or_default().0).collect::<Vec<_>>(),
        ["E0107"; 5]
    );
    let places: Vec<String> =
        faults(text).iter().map(|fault| fault.split(' ').nth(1).unwrap_or_default().into()).collect();
    let lines: Vec<&str> = places.iter().map(|place| place.split(':').next().unwrap_or_default()).collect();
    assert_eq!(lines, ["2", "3", "5", "7", "8"], "{places:?}");
    let left = left(text);
    assert!(left.contains(&"run(P)".to_owned()), "{left:?}");
    assert!(left.contains(&"grafcet R of MAIN, 1 items".to_owned()), "{left:?}");
    assert!(left.iter().any(|line| line.starts_with("grafcet Q of MAIN")), "{left:?}");
}

#[test]
fn a_child_stands_outside_of_braces() {
    let found = faults(
        "grafcet MAIN {\n  initial step 1 { run P }\n  child grafcet P of MAIN {\n    initial step 10\n  }\n}\n",
    );
    assert_eq!(found.len(), 1, "{found:?}");
    assert!(found[0].starts_with("E0107 3:"), "{found:?}");
}

#[test]
fn laid_out() {
    assert_eq!(
        format(
            "grafcet MAIN{initial step 1{run P freeze   P on event ↑a\nresume P on   activation V}\
             transition 1->1:b{C:=1 start  P kill Q}}child   grafcet P of   MAIN\"x\"{step 10}"
        ),
        "\
grafcet MAIN {
  initial step 1 { run P   freeze P on event ↑a   resume P on activation   V }
  transition 1 -> 1 : b { C := 1   start P   kill Q }
}
child grafcet P of MAIN \"x\" {
  step 10
}
"
    );
    // Comments stay with what they are behind, and long lists take a line each.
    assert_eq!(
        format("step 1 { start P on activation // why\nkill Q on deactivation }"),
        "step 1 {\n  start P on activation // why\n  kill Q on deactivation\n}\n"
    );
    let long = "Q".repeat(60);
    assert_eq!(
        format(&format!("step 1 {{ start {long} on activation kill {long} on activation }}")),
        format!("step 1 {{\n  start {long} on activation\n  kill {long} on activation\n}}\n")
    );
}
