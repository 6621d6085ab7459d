//! Faults of what warnings claim, that something never happens or that it may, and of restarts.

use super::{At, Fault, Part};

const COMPILER: At = At::anywhere(Part::Compiler);

pub(super) const FAULTS: &[Fault] = &[
    Fault {
        name: "never-active-in-spite-of-a-link",
        at: COMPILER,
        breaks: "a step with an activation link is said never to be active (W0414)",
        text: "possible.linked.entry(*around).or_default().push(step);",
        instead: "",
    },
    Fault {
        name: "never-active-in-spite-of-an-order",
        at: COMPILER,
        breaks: "a forced step is said never to be active (W0414)",
        text: "possible.placed.entry(order.step).or_default().extend(steps);",
        instead: "",
    },
    Fault {
        name: "never-cleared-during-an-off-delay",
        at: COMPILER.within("needed"),
        breaks: "a condition with an off-delay is said to ask for its operand now (W0415)",
        text: "off.ms == 0",
        instead: "true",
    },
    Fault {
        name: "never-cleared-without-all-steps-at-once",
        at: COMPILER,
        breaks: "a join is said never to be cleared although it was (W0415)",
        text: "joins(t) && !cleared.contains(*t) && before.iter().all(|step| active.contains(step))",
        instead: "joins(t) && before.iter().all(|step| active.contains(step))",
    },
    Fault {
        name: "dead-end-with-a-way-out",
        at: COMPILER,
        breaks: "a situation is said to have no way out although a transition is enabled (W0416)",
        text: "enabled.is_empty() && ends_count && dead_end.is_none()",
        instead: "ends_count && dead_end.is_none()",
    },
    Fault {
        name: "entered-while-it-is-left",
        at: COMPILER,
        breaks: "a step that is left and entered at once is said to be entered while it is active (W0418)",
        text: "stays(step) && entered.insert(*step)",
        instead: "marking.binary_search(step).is_ok() && entered.insert(*step)",
    },
    Fault {
        name: "restart-forgets-what-is-retained",
        at: COMPILER.within("restart"),
        breaks: "a restart gives retained variables their initial values",
        text: "!variable.retain",
        instead: "true",
    },
    Fault {
        name: "restart-keeps-everything",
        at: COMPILER.within("restart"),
        breaks: "a restart leaves variables as they are that are not retained",
        text: "self.values[id] = variable.initial();",
        instead: "",
    },
];
