//! Faults of the backends for Structured Text, the statement list of STEP 7, and Rust.

use super::Fault;

const FORMULAS: &str = "backends/src/formulas.rs";
const ST_STATEMENTS: &str = "backends/src/st/statements.rs";
const ST_EXPRESSIONS: &str = "backends/src/st/expressions.rs";
const AWL_CONDITIONS: &str = "backends/src/awl/conditions.rs";
const AWL_NUMBERS: &str = "backends/src/awl/numbers.rs";
const AWL_TIMERS: &str = "backends/src/awl/timers.rs";
const RUST_SCAN: &str = "backends/src/rust/scan/mod.rs";
const RUST_STATEMENTS: &str = "backends/src/rust/scan/statements.rs";
const RUST_EXPRESSIONS: &str = "backends/src/rust/expressions.rs";
const RUST_PARTS: &str = "backends/src/rust/parts.rs";
const RUST_USES: &str = "backends/src/rust/uses.rs";
const SCAN_VARIABLES: &str = "compiler/logic/src/scan/variable.rs";

pub(super) const FAULTS: &[Fault] = &[
    Fault {
        name: "text-without-parentheses",
        file: FORMULAS,
        breaks: "no operand stands in parentheses",
        text: "self.needs_parentheses(parent, place, id)",
        instead: "false",
    },
    Fault {
        name: "st-bound-one-late",
        file: ST_STATEMENTS,
        breaks: "the stability loop is cut off one micro-step late (R9)",
        text: "format!(\"UNTIL NOT {again} OR ({count} >= {bound})\")",
        instead: "format!(\"UNTIL NOT {again} OR ({count} > {bound})\")",
    },
    Fault {
        name: "st-micro-steps-add-up",
        file: ST_STATEMENTS,
        breaks: "micro-steps are counted from the first call on (R9)",
        text: "out.line(&format!(\"{count} := 0;\"));",
        instead: "",
    },
    Fault {
        name: "st-livelock-where-stable",
        file: ST_STATEMENTS,
        breaks: "LIVELOCK is raised where the loop was not cut off (R9)",
        text: "out.open(&format!(\"IF {again} THEN\"));",
        instead: "out.open(&format!(\"IF NOT {again} THEN\"));",
    },
    Fault {
        name: "st-remainder-is-quotient",
        file: ST_STATEMENTS,
        breaks: "a guarded remainder is written as a quotient",
        text: "if modulo { \" MOD \" } else { \" / \" }",
        instead: "\" / \"",
    },
    Fault {
        name: "st-no-div0",
        file: ST_STATEMENTS,
        breaks: "a division by zero raises no DIV0",
        text: "self.calculate(out, flag, |out| out.text(\"TRUE\"));",
        instead: "",
    },
    Fault {
        name: "st-durations-stop",
        file: SCAN_VARIABLES,
        breaks: "the duration of a step stops after a second (X5)",
        text: "i32::MAX as i64",
        instead: "1000",
    },
    Fault {
        name: "st-otherwise-lost",
        file: ST_STATEMENTS,
        breaks: "what is done if no branch applies is not written",
        text: "!is_empty(otherwise)",
        instead: "false",
    },
    Fault {
        name: "st-less-or-equal-is-less",
        file: ST_EXPRESSIONS,
        breaks: "`<=` is written as `<`",
        text: "\"<=\"",
        instead: "\"<\"",
    },
    Fault {
        name: "rust-bound-one-early",
        file: RUST_SCAN,
        breaks: "the stability loop is cut off one micro-step early (R9)",
        text: "Value::Int(limit.bound.into())",
        instead: "Value::Int(i64::from(limit.bound) - 1)",
    },
    Fault {
        name: "rust-no-livelock-flag",
        file: RUST_SCAN,
        breaks: "a reaction that is cut off raises no LIVELOCK (R9)",
        text: "out.line(&format!(\"{} = true;\", self.places.read(limit.flag)));",
        instead: "",
    },
    Fault {
        name: "rust-remainder-is-quotient",
        file: RUST_STATEMENTS,
        breaks: "a guarded remainder is written as a quotient",
        text: "if modulo { \"remainder\" } else { \"divide\" }",
        instead: "\"divide\"",
    },
    Fault {
        name: "rust-compound-of-the-right",
        file: RUST_STATEMENTS,
        breaks: "`a := b - a` is written as `a -= b`",
        text: "*pool.get(*a) == Formula::Variable(target)",
        instead: "*pool.get(*b) == Formula::Variable(target)",
    },
    Fault {
        name: "rust-otherwise-lost",
        file: RUST_STATEMENTS,
        breaks: "what is done if no branch applies is not written",
        text: "is_empty(otherwise)",
        instead: "true",
    },
    Fault {
        name: "awl-product-joins-the-sum",
        file: AWL_CONDITIONS,
        breaks: "a product behind a sum is not added to it",
        text: "code.bit(\"O\", \"\");",
        instead: "",
    },
    Fault {
        name: "awl-what-is-no-number-is-less",
        file: AWL_NUMBERS,
        breaks: "the contrary of a comparison of reals is the comparison",
        text: "code.bit(\"NOT\", \"\");",
        instead: "",
    },
    Fault {
        name: "awl-clock-wraps-around-once",
        file: AWL_TIMERS,
        breaks: "where a clock of 31 bits wraps around, all timers run out",
        text: "code.number(\"AD\", \"DW#16#7FFFFFFF\");",
        instead: "",
    },
    Fault {
        name: "awl-timer-outlives-its-input",
        file: AWL_TIMERS,
        breaks: "a timer that has run out stays so when its input falls",
        text: "code.bit(\"A\", &run);",
        instead: "",
    },
    Fault {
        name: "rust-less-or-equal-is-less",
        file: RUST_EXPRESSIONS,
        breaks: "`<=` is written as `<`",
        text: "\"<=\"",
        instead: "\"<\"",
    },
    Fault {
        name: "rust-equal-bits-differ",
        file: RUST_EXPRESSIONS,
        breaks: "`NOT (a XOR b)` is written as `a != b`",
        text: "Parts::Infix(\"==\", pair(*b, *c))",
        instead: "Parts::Infix(\"!=\", pair(*b, *c))",
    },
    Fault {
        name: "rust-arm-misplaced",
        file: RUST_PARTS,
        breaks: "in a large chart what a step does is done at the step before",
        text: "state.place(arm.value)",
        instead: "(state.place(arm.value) + state.variants.len() - 1) % state.variants.len()",
    },
    Fault {
        name: "rust-values-not-shared",
        file: RUST_USES,
        breaks: "in a large chart a function does not see the values that another has computed",
        text: "counts.get(v).is_some_and(|count| *count > 1)",
        instead: "counts.get(v).is_some_and(|count| *count > 2)",
    },
];
