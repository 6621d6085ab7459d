//! Faults of the backends for Structured Text, the statement list of STEP 7, and Rust.

use super::{At, Fault, Part};

const ST: At = At::anywhere(Part::StructuredText);
const AWL: At = At::anywhere(Part::StatementList);
const RUST: At = At::anywhere(Part::Rust);
const SHARED: At = At::anywhere(Part::Shared);

pub(super) const FAULTS: &[Fault] = &[
    Fault {
        name: "text-without-parentheses",
        at: SHARED.within("operand"),
        breaks: "no operand stands in parentheses",
        text: "self.needs_parentheses(parent, place, id)",
        instead: "false",
    },
    Fault {
        name: "st-bound-one-late",
        at: ST,
        breaks: "the stability loop is cut off one micro-step late (R9)",
        text: "format!(\"UNTIL NOT {again} OR ({count} >= {bound})\")",
        instead: "format!(\"UNTIL NOT {again} OR ({count} > {bound})\")",
    },
    Fault {
        name: "st-micro-steps-add-up",
        at: ST,
        breaks: "micro-steps are counted from the first call on (R9)",
        text: "out.line(&format!(\"{count} := 0;\"));",
        instead: "",
    },
    Fault {
        name: "st-livelock-where-stable",
        at: ST,
        breaks: "LIVELOCK is raised where the loop was not cut off (R9)",
        text: "out.open(&format!(\"IF {again} THEN\"));",
        instead: "out.open(&format!(\"IF NOT {again} THEN\"));",
    },
    Fault {
        name: "st-remainder-is-quotient",
        at: ST,
        breaks: "a guarded remainder is written as a quotient",
        text: "if modulo { \" MOD \" } else { \" / \" }",
        instead: "\" / \"",
    },
    Fault {
        name: "st-no-div0",
        at: ST,
        breaks: "a division by zero raises no DIV0",
        text: "self.calculate(out, flag, |out| out.text(\"TRUE\"));",
        instead: "",
    },
    Fault {
        name: "st-durations-stop",
        at: ST,
        breaks: "the duration of a step stops after a second (X5)",
        text: "self.program.timers[timer].given_preset()",
        instead: "self.program.timers[timer].preset.unwrap_or(grafc_logic::scan::Preset { ms: 1000, constant: None })",
    },
    Fault {
        name: "otherwise-lost",
        at: SHARED.within("write_branches"),
        breaks: "what is done if no branch applies is not written",
        text: "!is_empty(otherwise)",
        instead: "false",
    },
    Fault {
        name: "st-less-or-equal-is-less",
        at: ST,
        breaks: "`<=` is written as `<`",
        text: "Arrangement::Infix(op.sign(), pair(*a, *b))",
        instead: "Arrangement::Infix(if op.sign() == \"<=\" { \"<\" } else { op.sign() }, pair(*a, *b))",
    },
    Fault {
        name: "rust-bound-one-early",
        at: RUST,
        breaks: "the stability loop is cut off one micro-step early (R9)",
        text: "Value::Int(limit.bound.into())",
        instead: "Value::Int(i64::from(limit.bound) - 1)",
    },
    Fault {
        name: "rust-no-livelock-flag",
        at: RUST,
        breaks: "a reaction that is cut off raises no LIVELOCK (R9)",
        text: "out.line(&format!(\"{} = true;\", self.places.read(limit.flag)));",
        instead: "",
    },
    Fault {
        name: "rust-remainder-is-quotient",
        at: RUST,
        breaks: "a guarded remainder is written as a quotient",
        text: "if modulo { \"remainder\" } else { \"divide\" }",
        instead: "\"divide\"",
    },
    Fault {
        name: "rust-compound-of-the-right",
        at: RUST,
        breaks: "`a := b - a` is written as `a -= b`",
        text: "*pool.get(*a) == Formula::Variable(target)",
        instead: "*pool.get(*b) == Formula::Variable(target)",
    },
    Fault {
        name: "awl-product-joins-the-sum",
        at: AWL,
        breaks: "a product behind a sum is not added to it",
        text: "code.bit(\"O\", \"\");",
        instead: "",
    },
    Fault {
        name: "awl-what-is-no-number-is-less",
        at: AWL.within("compare"),
        breaks: "the contrary of a comparison of reals is the comparison",
        text: "code.bit(\"NOT\", \"\");",
        instead: "",
    },
    Fault {
        name: "awl-clock-wraps-around-once",
        at: AWL,
        breaks: "where a clock of 31 bits wraps around, all timers run out",
        text: "code.number(\"AD\", \"DW#16#7FFFFFFF\");",
        instead: "",
    },
    Fault {
        name: "awl-timer-outlives-its-input",
        at: AWL,
        breaks: "a timer that has run out stays so when its input falls",
        text: "code.bit(\"A\", &run);",
        instead: "",
    },
    Fault {
        name: "rust-less-or-equal-is-less",
        at: RUST,
        breaks: "`<=` is written as `<`",
        text: "\"<=\"",
        instead: "\"<\"",
    },
    Fault {
        name: "rust-equal-bits-differ",
        at: RUST,
        breaks: "`NOT (a XOR b)` is written as `a != b`",
        text: "Arrangement::Infix(\"==\", pair(*b, *c))",
        instead: "Arrangement::Infix(\"!=\", pair(*b, *c))",
    },
    Fault {
        name: "rust-arm-misplaced",
        at: RUST,
        breaks: "in a large chart what a step does is done at the step before",
        text: "state.place(arm.value)",
        instead: "(state.place(arm.value) + state.variants.len() - 1) % state.variants.len()",
    },
    Fault {
        name: "rust-values-not-shared",
        at: RUST,
        breaks: "in a large chart a function does not see the values that another has computed",
        text: "counts.get(v).is_some_and(|count| *count > 1)",
        instead: "counts.get(v).is_some_and(|count| *count > 2)",
    },
];
