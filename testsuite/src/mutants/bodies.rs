//! Faults of instruction lists, ladder diagrams and sequential function charts.

use super::Fault;

const IL_CODE: &str = "backends/src/il/code.rs";
const IL_EXPRESSIONS: &str = "backends/src/il/expressions.rs";
const IL_STATEMENTS: &str = "backends/src/il/statements.rs";
const LD: &str = "backends/src/plcopen/ld/mod.rs";
const LD_BRANCHES: &str = "backends/src/plcopen/ld/branches.rs";
const LD_CALCULATE: &str = "backends/src/plcopen/ld/calculate.rs";
const LD_CIRCUIT: &str = "backends/src/plcopen/ld/circuit.rs";
const LD_REPEAT: &str = "backends/src/plcopen/ld/repeat.rs";
const LD_STATEMENTS: &str = "backends/src/plcopen/ld/statements.rs";
const LD_WRITE: &str = "backends/src/plcopen/ld/write.rs";
const SFC_GRAPH: &str = "backends/src/plcopen/sfc/graph.rs";
const SFC_PREPARED: &str = "backends/src/plcopen/sfc/prepared.rs";
const SFC_TEXTS: &str = "backends/src/plcopen/sfc/texts.rs";
const SFC_WRITE: &str = "backends/src/plcopen/sfc/write.rs";
const SFC_TREE: &str = "backends/src/plcopen/sfc/nested/tree.rs";
const SFC_NESTED_WRITE: &str = "backends/src/plcopen/sfc/nested/write.rs";

pub(super) const FAULTS: &[Fault] = &[
    Fault {
        name: "il-accumulator-after-a-jump",
        file: IL_CODE,
        breaks: "where `JMPCN` did not jump the accumulator is taken to be false",
        text: "Some(Known::Truth(true))",
        instead: "Some(Known::Truth(false))",
    },
    Fault {
        name: "il-label-keeps-the-accumulator",
        file: IL_CODE,
        breaks: "what is known of the accumulator is kept where a jump comes in",
        text: "self.out.line(&format!(\"{label}:\"));",
        instead: "self.out.line(&format!(\"{label}:\")); return;",
    },
    Fault {
        name: "il-load-not-negated",
        file: IL_EXPRESSIONS,
        breaks: "`LDN` is written as `LD`",
        text: "\"LDN\"",
        instead: "\"LD\"",
    },
    Fault {
        name: "il-operand-not-negated",
        file: IL_EXPRESSIONS,
        breaks: "`ANDN`, `ORN` and `XORN` are written without `N`",
        text: "if negated { \"N\" } else { \"\" }",
        instead: "\"\"",
    },
    Fault {
        name: "il-comparison-turns-round",
        file: IL_EXPRESSIONS,
        breaks: "a comparison whose operands have changed sides is not mirrored",
        text: "comparison(op.mirrored())",
        instead: "comparison(*op)",
    },
    Fault {
        name: "il-parts-share-a-variable",
        file: IL_EXPRESSIONS,
        breaks: "all parts of a formula are stored in one variable",
        text: "self.parts.len()",
        instead: "0",
    },
    Fault {
        name: "il-timer-called-before-its-input",
        file: IL_STATEMENTS,
        breaks: "the input of a timer is stored after `CAL`, and counts one call later (X5)",
        text: "self.load(input);\n        self.code.instruction(\"ST\", &format!(\"{name}.IN\"));\n        \
               self.code.operation(\"LD\", &preset);\n        \
               self.code.instruction(\"ST\", &format!(\"{name}.PT\"));\n        \
               self.code.operation(\"CAL\", &name);",
        instead: "self.code.operation(\"LD\", &preset); self.code.instruction(\"ST\", &format!(\"{name}.PT\")); \
                  self.code.operation(\"CAL\", &name); self.load(input); \
                  self.code.instruction(\"ST\", &format!(\"{name}.IN\"));",
    },
    Fault {
        name: "il-branch-falls-through",
        file: IL_STATEMENTS,
        breaks: "after a branch the next one is tried as well",
        text: "self.code.instruction(\"JMP\", &done);",
        instead: "",
    },
    Fault {
        name: "il-halves-meet-too-early",
        file: IL_STATEMENTS,
        breaks: "in a choice of many arms the lower ones are looked for among the upper ones",
        text: "high[0].value",
        instead: "low[low.len() - 1].value",
    },
    Fault {
        name: "il-bound-one-late",
        file: IL_STATEMENTS,
        breaks: "the stability loop is cut off one micro-step late (R9)",
        text: "\"LT\"",
        instead: "\"LE\"",
    },
    Fault {
        name: "il-livelock-forgotten",
        file: IL_STATEMENTS,
        breaks: "LIVELOCK falls in the next call (R9)",
        text: "self.code.operation(\"OR\", &self.names.variables[flag]);",
        instead: "",
    },
    Fault {
        name: "il-remainder-is-quotient",
        file: IL_STATEMENTS,
        breaks: "a guarded remainder is written as a quotient",
        text: "if modulo { \"MOD\" } else { \"DIV\" }",
        instead: "\"DIV\"",
    },
    Fault {
        name: "ld-contact-not-negated",
        file: LD_WRITE,
        breaks: "a contact that is closed while its variable is false is drawn as one that is open",
        text: "contact.negated",
        instead: "false",
    },
    Fault {
        name: "ld-set-is-reset",
        file: LD_WRITE,
        breaks: "a coil that sets is drawn as one that resets",
        text: "\"set\"",
        instead: "\"reset\"",
    },
    Fault {
        name: "ld-deactivation-wins",
        file: LD_STATEMENTS,
        breaks: "a step that is left and entered at once goes (R4, rule 5 of the standard)",
        text: "!set_first",
        instead: "set_first",
    },
    Fault {
        name: "ld-parts-outlive-what-they-read",
        file: LD_STATEMENTS,
        breaks: "the value of a part of a formula is used after what is in it was written",
        text: "self.known.clear();",
        instead: "",
    },
    Fault {
        name: "ld-inverted-twice",
        file: LD_STATEMENTS,
        breaks: "a truth value that is inverted under a condition is looked at again when it has been set",
        text: "contact.name == name",
        instead: "false",
    },
    Fault {
        name: "ld-coil-before-its-condition",
        file: LD_BRANCHES,
        breaks: "of the coils of a rung one that the condition reads is not the last",
        text: "!self.reads(condition, *target)",
        instead: "true",
    },
    Fault {
        name: "ld-functions-without-enable",
        file: LD_CALCULATE,
        breaks: "what calculates under a condition does so always",
        text: "self.items(behind.into_iter().map(Factor::Contact).collect())",
        instead: "{ let _ = behind; Vec::new() }",
    },
    Fault {
        name: "ld-branches-do-not-exclude",
        file: LD_BRANCHES,
        breaks: "a later branch is taken beside an earlier one",
        text: "before.push(contact.inverse());",
        instead: "",
    },
    Fault {
        name: "ld-timer-keeps-its-enable",
        file: LD_STATEMENTS,
        breaks: "a timer that had `EN` in one call does not have it in another",
        text: "!self.enabled.contains(&timer)",
        instead: "true",
    },
    Fault {
        name: "ld-equivalence-is-difference",
        file: LD_CIRCUIT,
        breaks: "`NOT (a XOR b)` is drawn as `a XOR b`",
        text: "Shape::Either((*a, false), (*b, negated))",
        instead: "Shape::Either((*a, false), (*b, false))",
    },
    Fault {
        name: "ld-branch-in-a-branch-lost",
        file: LD_CIRCUIT,
        breaks: "of a branch that has a group in it only the first contacts are drawn",
        text: "factors.clear();",
        instead: "",
    },
    Fault {
        name: "ld-one-micro-step",
        file: LD_REPEAT,
        breaks: "the rungs are called once although the situation is not stable (R9)",
        text: "out.line(&format!(\"{} := {}.{};\", self.further, self.instance, self.again));",
        instead: "",
    },
    Fault {
        name: "ld-input-event-lasts",
        file: LD,
        breaks: "what is done once before the micro-steps is done before each (R7)",
        text: "at_first.as_ref().filter(|_| !statements.iter().all(repeat::is_call))",
        instead: "{ let _ = &at_first; None }",
    },
    Fault {
        name: "ld-outputs-in-each-micro-step",
        file: LD,
        breaks: "outputs that divide are computed in each micro-step, and raise DIV0 in one that is not the last (R11)",
        text: "at_last.as_ref()",
        instead: "{ let _ = &at_last; None }",
    },
    Fault {
        name: "sfc-fork-drawn-as-selection",
        file: SFC_WRITE,
        breaks: "a simultaneous divergence is drawn as a selection",
        text: "(\"simultaneousDivergence\", SIMULTANEOUS)",
        instead: "(\"selectionDivergence\", SELECTION)",
    },
    Fault {
        name: "sfc-join-drawn-as-selection",
        file: SFC_WRITE,
        breaks: "a simultaneous convergence is drawn as the end of a selection",
        text: "(\"simultaneousConvergence\", SIMULTANEOUS)",
        instead: "(\"selectionConvergence\", SELECTION)",
    },
    Fault {
        name: "sfc-jump-to-the-first-step",
        file: SFC_WRITE,
        breaks: "all jumps lead to the first step",
        text: "&self.texts.steps[to]",
        instead: "&self.texts.steps[to * 0]",
    },
    Fault {
        name: "sfc-past-the-bar",
        file: SFC_WRITE,
        breaks: "what a divergence leads to is wired to the box above it, past its bar",
        text: "self.ids[from][2]",
        instead: "self.ids[from][1]",
    },
    Fault {
        name: "sfc-jump-of-another-branch",
        file: SFC_GRAPH,
        breaks: "a step of a fork that is reached by a jump is not reached if another is by an arc",
        text: "!drawn.contains(&(own, step.index()))",
        instead: "!transition.after.iter().any(|step| drawn.contains(&(own, step.index())))",
    },
    Fault {
        name: "sfc-output-is-stored",
        file: SFC_TEXTS,
        breaks: "a continuous action has the qualifier `S`, and its output outlives the step (R11)",
        text: "rows.push(Action { qualifier: \"N\", content: Content::Variable(name.clone()) });",
        instead: "rows.push(Action { qualifier: \"S\", content: Content::Variable(name.clone()) });",
    },
    Fault {
        name: "sfc-on-activation-lasts",
        file: SFC_TEXTS,
        breaks: "an action on activation is done in each call (R7)",
        text: "\"P1\"",
        instead: "\"N\"",
    },
    Fault {
        name: "sfc-activation-is-deactivation",
        file: SFC_TEXTS,
        breaks: "actions on activation are done on deactivation, and the other way round (R7)",
        text: "assignment.on_activation",
        instead: "!assignment.on_activation",
    },
    Fault {
        name: "sfc-output-not-computed-at-the-end",
        file: SFC_TEXTS,
        breaks: "a conditional action outlives its step (R11)",
        text: "rows.push(Action { qualifier: \"P0\", content: Content::Statements(statement) });",
        instead: "let _ = statement;",
    },
    Fault {
        name: "sfc-steps-not-shown",
        file: SFC_TEXTS,
        breaks: "the marker of a step is not set, and its edges and delays are those of nothing (X4, X5)",
        text: "rows.push(Action { qualifier: \"N\", content: Content::Variable(names[marker].clone()) });",
        instead: "",
    },
    Fault {
        name: "sfc-found-but-not-given",
        file: SFC_PREPARED,
        breaks: "edges and delays are found and the chart is not given them (X4, X5)",
        text: "inputs.extend(given.iter().map(String::as_str));",
        instead: "",
    },
    Fault {
        name: "sfc-tree-fork-is-selection",
        file: SFC_NESTED_WRITE,
        breaks: "for CODESYS a simultaneous divergence is written as a selection",
        text: "if *simultaneous { \"simultaneousDivergence\" } else { \"selectionDivergence\" }",
        instead: "\"selectionDivergence\"",
    },
    Fault {
        name: "sfc-tree-jump-to-the-first-step",
        file: SFC_NESTED_WRITE,
        breaks: "for CODESYS all jumps lead to the first step",
        text: "(\"targetName\", &texts.steps[*step])",
        instead: "(\"targetName\", &texts.steps[*step * 0])",
    },
    Fault {
        name: "sfc-tree-merge-forgets-a-way",
        file: SFC_TREE,
        breaks: "for CODESYS a selection is closed without the way of its last transition",
        text: "merged = true;\n                    ends.push(end);",
        instead: "merged = true; if ends.is_empty() { ends.push(end); }",
    },
];
