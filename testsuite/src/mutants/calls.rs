//! Faults of what acts on a call as a whole: inputs that reset, LIVELOCK, memory that is given back.

use super::{At, Fault, Part};

const COMPILER: At = At::anywhere(Part::Compiler);
const RUST: At = At::anywhere(Part::Rust);

pub(super) const FAULTS: &[Fault] = &[
    Fault {
        name: "reset-leaves-timers",
        at: COMPILER,
        breaks: "a delay goes on over a reset (R10)",
        text: "body.extend(program.timers.indices().map(stops));",
        instead: "program.timers.indices().map(stops).for_each(drop);",
    },
    Fault {
        name: "reset-leaves-what-is-retained",
        at: COMPILER,
        breaks: "a reset leaves retained variables whether it shall or not",
        text: "variable.retain && keeps_retained",
        instead: "variable.retain && (keeps_retained || true)",
    },
    Fault {
        name: "control-is-an-input-event",
        at: COMPILER,
        breaks: "a change of a control counts as a change of an input (R7)",
        text: "input.kind == VariableKind::Input && !lowering.net.controls.has(v)",
        instead: "input.kind == VariableKind::Input",
    },
    Fault {
        name: "conflict-stays-lowered",
        at: COMPILER,
        breaks: "orders that disagree do not raise a flag again that an input has lowered (R2)",
        text: "!task.pulses.is_empty() || conflicts",
        instead: "!task.pulses.is_empty() || conflicts && false",
    },
    Fault {
        name: "held-after-the-start",
        at: COMPILER,
        breaks: "what outputs hold after LIVELOCK is what the initial reaction makes of them",
        text: "program.first.splice(0..0, held);",
        instead: "program.before.extend(held);",
    },
    Fault {
        name: "held-outputs-follow",
        at: COMPILER,
        breaks: "an output that was held is not computed again before its state moves",
        text: "outputs_follow || variable.kind != VariableKind::Output",
        instead: "true || outputs_follow",
    },
    Fault {
        name: "bound-without-edges",
        at: COMPILER,
        breaks: "a bound that is known to be enough cuts off what ends by itself (R9)",
        text: "self.situations()?.checked_add(2)?",
        instead: "self.situations()?.checked_add(0)?.max(2) / 2",
    },
    Fault {
        name: "rust-restores-what-cannot-be",
        at: RUST,
        breaks: "two steps that exclude each other are given back as active",
        text: "refused.push(\"!chart.is_possible()\".into());",
        instead: "",
    },
    Fault {
        name: "rust-outputs-as-saved",
        at: RUST,
        breaks: "outputs are not computed of the situation that was given back (R11)",
        text: "split.restore_outputs.map(|_| if inputs { \"inputs\" } else { \"\" })",
        instead: "split.restore_outputs.filter(|_| false).map(|_| if inputs { \"inputs\" } else { \"\" })",
    },
    Fault {
        name: "no-delay-is-not-kept",
        at: At::anywhere(Part::Restoring),
        breaks: "a delay of no time, a value of the last micro-step, is false where a chart is restored (R14)",
        text: "self.symbols.table[now].role = Role::Memory;",
        instead: "",
    },
];
