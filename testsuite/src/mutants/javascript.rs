//! Faults of the backend for JavaScript.

use super::{At, Fault, Part};

const JS: At = At::anywhere(Part::JavaScript);

pub(super) const FAULTS: &[Fault] = &[
    Fault {
        name: "js-bound-one-late",
        at: JS,
        breaks: "the scan is cut off one micro-step late (R9)",
        text: "format!(\"if ({count} < {}) {{\", limit.bound)",
        instead: "format!(\"if ({count} <= {}) {{\", limit.bound)",
    },
    Fault {
        name: "js-remainder-is-quotient",
        at: JS,
        breaks: "a guarded remainder is written as a quotient",
        text: "if modulo { \"%\" } else { \"/\" }",
        instead: "\"/\"",
    },
    Fault {
        name: "js-no-div0",
        at: JS,
        breaks: "a division by zero raises no DIV0",
        text: "[format!(\"{target} = {zero};\"), format!(\"{flag} = true;\")]",
        instead: "[format!(\"{target} = {zero};\"), format!(\"{flag} = {flag};\")]",
    },
    Fault {
        name: "js-product-has-a-sign",
        at: JS,
        breaks: "a product without sign is one with a sign from half of its range on",
        text: "if ty == Type::Udint { (\"udint(Math.imul(\", \"))\") } else { (\"Math.imul(\", \")\") }",
        instead: "(\"Math.imul(\", \")\")",
    },
    Fault {
        name: "js-quotient-is-no-whole-number",
        at: JS,
        breaks: "what a guarded division gives is not wrapped around and not cut off",
        text: "eco_format!(\"{function}{text})\")",
        instead: "text.into()",
    },
    Fault {
        name: "js-single-is-double",
        at: JS,
        breaks: "a `real` has the precision of an `lreal`",
        text: "Some(\"real(\")",
        instead: "None",
    },
    Fault {
        name: "js-arms-fall-through",
        at: At::anywhere(Part::Braces).within("leave_arm"),
        breaks: "the arm of a step goes on into the next one",
        text: "out.line(\"break;\");",
        instead: "",
    },
    Fault {
        name: "js-delays-of-a-second",
        at: JS,
        breaks: "every delay without a constant takes a second (X5)",
        text: "eco_format!(\"{}\", preset.ms)",
        instead: "eco_format!(\"1000\")",
    },
    Fault {
        name: "js-stored-outputs-not-saved",
        at: JS,
        breaks: "outputs of stored actions are lost where a chart is restored",
        text: "program.derived().into_iter().map(of).collect()",
        instead: "program.variables.indices().filter(|v| program.variables[*v].role == Role::Output).map(of).collect()",
    },
    Fault {
        name: "js-enabled-is-cleared",
        at: JS,
        breaks: "transitions that are enabled are told to clear (R3)",
        text: "out.line(\"return { enabled: of(s.seen.enabled), cleared: of(s.seen.cleared), stable };\");",
        instead: "out.line(\"return { enabled: of(s.seen.enabled), cleared: of(s.seen.enabled), stable };\");",
    },
    Fault {
        name: "js-nobody-looks-on",
        at: JS,
        breaks: "nothing is told of transitions",
        text: "format!(\"{wanted} = true;\")",
        instead: "format!(\"{wanted} = false;\")",
    },
    Fault {
        name: "js-restart-forgets",
        at: JS,
        breaks: "what is retained is lost at a restart",
        text: "out.line(&format!(\"{to} = {from};\"));",
        instead: "",
    },
    Fault {
        name: "js-times-compare-as-numbers",
        at: JS,
        breaks: "a time that is stored is compared as what it is not",
        text: "self.pool().ty(a) == Type::Time && !(self.is_number(a) && self.is_number(b))",
        instead: "false",
    },
];
