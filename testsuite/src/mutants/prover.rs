//! Faults of the engine that asks a solver of clauses.

use super::{At, Fault, Part};

const PROVER: At = At::anywhere(Part::Prover);

pub(super) const FAULTS: &[Fault] = &[
    Fault {
        name: "clauses-initial-value-lost",
        at: PROVER,
        breaks: "all latches are false at the start, also those that are true",
        text: "self.constant(latch.initial)",
        instead: "self.constant(false)",
    },
    Fault {
        name: "clauses-nothing-moves",
        at: PROVER,
        breaks: "a latch holds at a clock what it held before the one before",
        text: "self.known(frame - 1, latch.next)",
        instead: "self.known(frame - 1, latch.now)",
    },
    Fault {
        name: "clauses-half-a-conjunction",
        at: PROVER,
        breaks: "a conjunction may be false where both of its operands are true",
        text: "self.clause(vec![both, !a, !b]);",
        instead: "",
    },
    Fault {
        name: "clauses-assumptions-forgotten",
        at: PROVER,
        breaks: "inputs that an assumption bars are searched, too",
        text: "vec![watched.circuit.assumed]",
        instead: "vec![crate::circuit::Literal::TRUE]",
    },
    Fault {
        name: "induction-proves-what-it-supposes",
        at: PROVER.within("kept"),
        breaks: "a claim is asked at the first clock, where it was supposed, not at the one after those",
        text: "self.frames.literal(clocks, *claim)",
        instead: "self.frames.literal(0, *claim)",
    },
    Fault {
        name: "induction-supposes-what-is-out",
        at: PROVER.within("kept"),
        breaks: "what does not follow still proves the rest",
        text: "self.held(left, claims, clocks)",
        instead: "self.held(left.into_iter().chain(0..claims.len()).collect(), claims, clocks)",
    },
    Fault {
        name: "call-begins-anywhere",
        at: PROVER.within("ends_within"),
        breaks: "a reaction that is under way may go on for as long as it likes",
        text: "self.frames.literal(0, self.begins)",
        instead: "self.frames.literal(0, crate::circuit::Literal::TRUE)",
    },
    Fault {
        name: "way-out-of-more-than-was-shown",
        at: PROVER.within("needed"),
        breaks: "what a way needs to move a step is forgotten: also states leave by it that it leads nowhere from",
        text: "one_of.extend(if was { [!before, after] } else { [before, !after] });",
        instead: "let _ = (was, before, after);",
    },
    Fault {
        name: "circuit-reentry-though-it-is-left",
        at: PROVER,
        breaks: "a step that is left and entered at once counts as entered while it was active",
        text: "graph.all([into, before[s.index()], after[s.index()], !one])",
        instead: "graph.all([into, before[s.index()], after[s.index()]])",
    },
    Fault {
        name: "circuit-selection-never",
        at: PROVER.within("of_transitions"),
        breaks: "two transitions after a step that clear together are not seen",
        text: "two = graph.or(two, both);",
        instead: "two = graph.and(two, both);",
    },
];
