//! Faults of the Petri net and its passes.

use super::{At, Fault, Part};

const COMPILER: At = At::anywhere(Part::Compiler);

pub(super) const FAULTS: &[Fault] = &[
    Fault {
        name: "net-no-link",
        at: COMPILER,
        breaks: "activation links are dropped (R5)",
        text: "s.activated",
        instead: "false",
    },
    Fault {
        name: "net-no-inner-macro-step",
        at: COMPILER,
        breaks: "a macro-step's activity leaves out macro-steps of its expansion (M1)",
        text: "macro_steps[m].inner.push(id);",
        instead: "",
    },
    Fault {
        name: "net-macro-step-left-at-entry",
        at: COMPILER,
        breaks: "leaving a macro-step takes the entry step (M1)",
        text: "net.transitions[t].pre.push(m.exit);",
        instead: "net.transitions[t].pre.push(m.entry);",
    },
    Fault {
        name: "net-lowest-order-first",
        at: COMPILER,
        breaks: "of several orders the one of the lowest level wins (R2)",
        text: "net.grafcets[net.places[order.step].grafcet].level",
        instead: "u32::MAX - net.grafcets[net.places[order.step].grafcet].level",
    },
    Fault {
        name: "net-current-is-empty",
        at: COMPILER.within("run"),
        breaks: "`{*}` forces the empty situation (R2)",
        text: "Forced::Current",
        instead: "Forced::Steps(Vec::new())",
    },
    Fault {
        name: "net-links-of-the-start",
        at: COMPILER,
        breaks: "what is enclosed by a step that an order has made active at the start does not start (R5, R10)",
        text: "grafcet.steps.iter().filter(|s| net.places[**s].activated).for_each(|s| active[*s] = true);",
        instead: "",
    },
    Fault {
        name: "net-links-beside-initial-steps",
        at: COMPILER,
        breaks: "links count at the start even where enclosed initial steps take their place (R10)",
        text: "!net.places[enclosing].initial",
        instead: "true",
    },
    Fault {
        name: "net-start-forces-nothing",
        at: COMPILER,
        breaks: "the steps that an order forces are not active at the start (R5, R10)",
        text: "steps.iter().for_each(|s| active[*s] = true);",
        instead: "",
    },
    Fault {
        name: "net-conflict-at-start",
        at: COMPILER,
        breaks: "orders that disagree at the start raise no FORCE_CONFLICT (R2)",
        text: "net.conflict_at_start |= in_force.any(|other| other.forced != first.forced);",
        instead: "",
    },
    Fault {
        name: "net-freezing-stops-at-once",
        at: COMPILER.within("run"),
        breaks: "an order freezes no enclosure of the grafcet's steps (R2)",
        text: "Some(around)",
        instead: "None",
    },
    Fault {
        name: "net-freezing-stops-after-one",
        at: COMPILER,
        breaks: "an order freezes enclosures, but not the enclosures in these (R2)",
        text: "outer.frozen_with",
        instead: "None",
    },
    Fault {
        name: "net-transitions-not-within",
        at: COMPILER,
        breaks: "source transitions of an enclosure clear while its enclosing step is inactive (R3)",
        text: "transition.within = net.grafcets[transition.grafcet].enclosing_step.into_iter().collect();",
        instead: "",
    },
    Fault {
        name: "net-nested-though-forced",
        at: COMPILER,
        breaks: "a child on which an order sets a situation is nested, and obeys it only while it is run (R15)",
        text: "!grafcet.child || is_forced",
        instead: "!grafcet.child",
    },
    Fault {
        name: "net-nested-in-what-is-commanded",
        at: COMPILER,
        breaks: "a child whose parent is frozen or killed by a pulse is nested, and not frozen with it (R15)",
        text: "runs_in.is_some_and(|parent| !is_free[parent])",
        instead: "false",
    },
    Fault {
        name: "net-nested-with-what-it-starts",
        at: COMPILER,
        breaks: "a child that starts another one is nested, and its end does not kill that one (R15)",
        text: "below[*g].iter().any(|below| nested[*below].is_none())",
        instead: "false",
    },
    Fault {
        name: "net-rings-stay",
        at: COMPILER,
        breaks: "rings of two steps stay as they are, and the r-trigger loses their token (Shalyto, 12.1)",
        text: "flow.gives[*t].iter().for_each(|s| follows[*s] = Some(first));",
        instead: "",
    },
];
