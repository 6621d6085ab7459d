//! Faults of the encodings.

use super::Fault;

const SINGLE_PHASE: &str = "compiler/logic/src/encode/single_phase.rs";
const R_TRIGGER: &str = "compiler/logic/src/encode/r_trigger.rs";
const S_TRIGGER: &str = "compiler/logic/src/encode/s_trigger.rs";
const SEQUENT: &str = "compiler/logic/src/encode/sequent.rs";
const IN_ORDER: &str = "compiler/logic/src/encode/in_order.rs";
const BITS: &str = "compiler/logic/src/encode/bits.rs";
const SWITCH: &str = "compiler/logic/src/encode/switch/mod.rs";
const SWITCH_MOVES: &str = "compiler/logic/src/encode/switch/moves.rs";
const SWITCH_IN_PLACE: &str = "compiler/logic/src/encode/switch/in_place.rs";
const SWITCH_HIERARCHY: &str = "compiler/logic/src/encode/switch/hierarchy.rs";
const SWITCH_COMMIT: &str = "compiler/logic/src/encode/switch/commit.rs";
const DORMANT: &str = "compiler/logic/src/tidy/idle_delays.rs";

pub(super) const FAULTS: &[Fault] = &[
    Fault {
        name: "single-phase-reset-dominates",
        file: SINGLE_PHASE,
        breaks: "a step that is left and entered at once goes (R4, rule 5 of the standard)",
        text: "pool.or([step.set, stays])",
        instead: "{ let wanted = pool.or([step.set, stays]); pool.and([kept, wanted]) }",
    },
    Fault {
        name: "r-trigger-set-dominates",
        file: R_TRIGGER,
        breaks: "a step that its predecessor still sets stays whatever its successors do (Shalyto, table 12.1)",
        text: "pool.and([free, wanted])",
        instead: "{ let stays = pool.and([step.active, free]); pool.or([step.set, stays]) }",
    },
    Fault {
        name: "s-trigger-reset-dominates",
        file: S_TRIGGER,
        breaks: "a step that its predecessor still sets goes as soon as a successor is active",
        text: "single_phase::next(pool, step)",
        instead: "{ let n = single_phase::next(pool, step); let free = pool.not(step.reset); pool.and([free, n]) }",
    },
    Fault {
        name: "sequent-sets-before-resets",
        file: SEQUENT,
        breaks: "all sets come before all resets (R4, rule 5 of the standard)",
        text: "resets.extend(sets);",
        instead: "sets.extend(resets); resets = sets;",
    },
    Fault {
        name: "sequent-transitions-one-by-one",
        file: SEQUENT,
        breaks: "resets and sets of a transition come together where a step may be left and entered at once (R4)",
        text: "entered(s) && !task.components.covers(*s)",
        instead: "entered(s) && false",
    },
    Fault {
        name: "sequent-clearing-asks-for-nothing",
        file: SEQUENT,
        breaks: "a clearing asks for no other micro-step (R8)",
        text: "body.push(Statement::Assign { target, value: lowering.pool.truth(true), remark: None });",
        instead: "",
    },
    Fault {
        name: "no-copy-of-the-old-situation",
        file: IN_ORDER,
        breaks: "where writing goes round in a circle, those that come later read the new situation (R3)",
        text: "copies.extend(fresh);",
        instead: "",
    },
    Fault {
        name: "bits-enclosed-with-the-old-step",
        file: BITS,
        breaks: "an enclosure follows what its enclosing step was, not what it becomes (R5)",
        text: "within.and_then(|e| clearings.next[e])",
        instead: "within.map(|e| lowering.active(e))",
    },
    Fault {
        name: "bits-forced-by-the-old-step",
        file: BITS,
        breaks: "an order acts while its step was active, not when it becomes so (R5)",
        text: "known[s].unwrap_or_else(|| lowering.active(s))",
        instead: "lowering.active(s)",
    },
    Fault {
        name: "overlap-changes-as-long-as-active",
        file: BITS,
        breaks: "where steps overlap, an active step asks for another micro-step (R8)",
        text: "lowering.pool.xor(next, active)",
        instead: "next",
    },
    Fault {
        name: "switch-reads-the-present-state",
        file: SWITCH,
        breaks: "enclosures, orders and actions look at the state, not at the next one (R5, R6)",
        text: "equals(&lowering.symbols, &mut lowering.pool, lowering.situation.sets[set].next, value)",
        instead: "equals(&lowering.symbols, &mut lowering.pool, lowering.situation.sets[set].variable, value)",
    },
    Fault {
        name: "switch-token-stays-behind",
        file: SWITCH_MOVES,
        breaks: "a clearing that leads out of a set leaves its step active (R4)",
        text: "come.get(set).copied().unwrap_or(lowering.situation.sets[*set].idle)",
        instead: "come.get(set).copied().unwrap_or(*from)",
    },
    Fault {
        name: "switch-token-does-not-come",
        file: SWITCH_MOVES,
        breaks: "a clearing that leads into a set activates no step of it (R4)",
        text: "changes.extend(come.iter().filter(|(set, _)| !left.contains_key(set)).map(|(set, to)| (*set, *to)));",
        instead: "",
    },
    Fault {
        name: "switch-output-kept-in-place",
        file: SWITCH_IN_PLACE,
        breaks: "an output of a step stays true when a transition leaves the step (R11)",
        text: "wires.entry(wire).or_default().0 = Some(conditions.is_empty());",
        instead: "",
    },
    Fault {
        name: "switch-output-kept",
        file: SWITCH_COMMIT,
        breaks: "an output of a step stays true after the step (R11)",
        text: "off.push(assign_truth(lowering, target, false));",
        instead: "",
    },
    Fault {
        name: "switch-no-outputs-at-the-start",
        file: SWITCH,
        breaks: "outputs of the initial steps are false until these have been left and entered (R10, R11)",
        text: "out.extend(entered(lowering, followers, *s));",
        instead: "",
    },
    Fault {
        name: "switch-enclosure-not-emptied",
        file: SWITCH_HIERARCHY,
        breaks: "an enclosure outlives its enclosing step (R5)",
        text: "body.push(assign_number(lowering, next, idle));",
        instead: "",
    },
    Fault {
        name: "switch-enclosure-not-started",
        file: SWITCH_HIERARCHY,
        breaks: "an enclosure does not start with its enclosing step (R5)",
        text: "body.push(assign_number(lowering, next, value_of(lowering, s)));",
        instead: "",
    },
    Fault {
        name: "switch-clearing-remembered",
        file: SWITCH_COMMIT,
        breaks: "the number of the transition that clears stays, and its actions are done again (R7)",
        text: "out.push(assign_number(lowering, *variable, 0));",
        instead: "",
    },
    Fault {
        name: "switch-next-not-at-the-start",
        file: SWITCH,
        breaks: "the next state is idle at the start, and the first clearing of another set empties the set (R10)",
        text: "out.push(assign_number(lowering, set.next, value));",
        instead: "",
    },
    Fault {
        name: "switch-order-without-encloser",
        file: SWITCH_HIERARCHY,
        breaks: "an order acts on a grafcet whose enclosing step is inactive (R5)",
        text: "lowering.pool.and(around.into_iter().chain([*when]))",
        instead: "*when",
    },
    Fault {
        name: "switch-left-enclosure-not-written",
        file: SWITCH_COMMIT,
        breaks: "the state inside a step that is left is not written (R5)",
        text: "was.add(lowering, *s, body.clone());",
        instead: "",
    },
    Fault {
        name: "switch-entered-enclosure-not-written",
        file: SWITCH_COMMIT,
        breaks: "the state inside a step that is entered is not written (R5)",
        text: "will.add(lowering, *s, body);",
        instead: "",
    },
    Fault {
        name: "switch-bits-ask-for-nothing",
        file: SWITCH_COMMIT,
        breaks: "a step that is a bit and changes asks for no other micro-step (R8)",
        text: "clearings.changes(lowering, self.task, |t| told[t])",
        instead: "Vec::new()",
    },
    Fault {
        name: "dormant-timers-run-on",
        file: DORMANT,
        breaks: "the timers of a step that has been left start anew when it is entered again (X5)",
        text: "(pool.truth(true), pool.truth(false))",
        instead: "(pool.truth(true), pool.truth(true))",
    },
    Fault {
        name: "dormant-forgets-which-step",
        file: DORMANT,
        breaks: "the timers to be reset are those of the step whose timers were called last (X5)",
        text: "Statement::Assign { target: timed, value: is, remark: None }",
        instead: "Statement::Assign { target: timed, value: was, remark: None }",
    },
];
