//! Faults of what is proved of a chart, and of the passes that shorten a program by it.

use super::Fault;

const SIMPLIFY: &str = "compiler/logic/src/tidy/absorb.rs";
const SWEEP: &str = "compiler/logic/src/tidy/sweep.rs";
const PIECES: &str = "compiler/logic/src/tidy/long_chains.rs";
const EXCLUSION: &str = "compiler/formula/src/exclusion/mod.rs";
const PROOF: &str = "compiler/formula/src/exclusion/proof.rs";
const COVER: &str = "compiler/logic/src/analysis/components/cover.rs";
const SEARCH: &str = "compiler/logic/src/analysis/components/search.rs";
const TRANSIENT: &str = "compiler/logic/src/analysis/transients/mod.rs";
const LONGEST: &str = "compiler/logic/src/analysis/transients/longest.rs";

pub(super) const FAULTS: &[Fault] = &[
    Fault {
        name: "simplify-excluded-is-active",
        file: SIMPLIFY,
        breaks: "in a condition, a step that excludes those before the transition counts as active",
        text: "known.insert(f, lowering.pool.truth(active));",
        instead: "known.insert(f, lowering.pool.truth(true));",
    },
    Fault {
        name: "simplify-all-steps-excluded",
        file: SIMPLIFY,
        breaks: "a condition is shortened as if every other step were inactive",
        text: "transition.pre.iter().any(|p| components.of(*p).iter().any(|c| components.of(*s).contains(c)))",
        instead: "true",
    },
    Fault {
        name: "simplify-operand-dropped",
        file: SIMPLIFY,
        breaks: "`a AND (NOT a OR b)` becomes `a`, not `a AND b`",
        text: "inner.iter().any(|i| operands.contains(i))",
        instead: "inner.iter().any(|i| { let not = pool.not(*i); operands.contains(i) || operands.contains(&not) })",
    },
    Fault {
        name: "simplify-rest-is-a-conjunction",
        file: SIMPLIFY,
        breaks: "`a AND (NOT a OR b OR c)` becomes `a AND b AND c`",
        text: "pool.or(left)",
        instead: "pool.and(left)",
    },
    Fault {
        name: "sweep-one-branch-counts",
        file: SWEEP,
        breaks: "a statement is removed that is needed where no branch writes the variable again",
        text: "needed > 0 || on_another",
        instead: "needed > 0",
    },
    Fault {
        name: "sweep-forgets-the-next-micro-step",
        file: SWEEP,
        breaks: "statements that only the next micro-step needs are removed from the loop",
        text: "needed.is.iter_mut_enumerated().filter(|(v, _)| at_start[*v]).for_each(|(_, needed)| *needed = true);",
        instead: "",
    },
    Fault {
        name: "sweep-forgets-the-case",
        file: SWEEP,
        breaks: "the copy of a state that only a `CASE` reads is removed",
        text: "self.set(*of, true);",
        instead: "",
    },
    Fault {
        name: "sweep-forgets-timers",
        file: SWEEP,
        breaks: "what only the input of a timer reads is removed",
        text: "self.reads(pool, *input)",
        instead: "()",
    },
    Fault {
        name: "pieces-lose-an-operand",
        file: PIECES,
        breaks: "the last operand of a full piece of a long formula is lost",
        text: "list.chunks(LONGEST).map(<[FormulaId]>::to_vec).collect()",
        instead: "list.chunks(LONGEST).map(|p| p[..p.len() - p.len() / LONGEST].to_vec()).collect()",
    },
    Fault {
        name: "exclusion-edge-upside-down",
        file: EXCLUSION,
        breaks: "a rising edge is taken to mean that its operand is false",
        text: "self.edge(*v).map(|edge| (edge.now, edge.rising))",
        instead: "self.edge(*v).map(|edge| (edge.now, !edge.rising))",
    },
    Fault {
        name: "exclusion-of-the-same",
        file: EXCLUSION,
        breaks: "two conditions with a factor in common are taken to exclude each other",
        text: "asserted_a != asserted_b",
        instead: "asserted_a == asserted_b",
    },
    Fault {
        name: "exclusion-cuts-downwards",
        file: PROOF,
        breaks: "`K < 3` is taken to follow from `K < 5`",
        text: "or(&not(&before), &here)?",
        instead: "or(&not(&here), &before)?",
    },
    Fault {
        name: "exclusion-edge-later",
        file: PROOF,
        breaks: "an edge of what changes during a reaction is taken to be over after its first micro-step",
        text: "self.stable.is_some() && when == When::Later && at == When::Always",
        instead: "self.stable.is_some() && when == When::Later",
    },
    Fault {
        name: "exclusion-everything-keeps",
        file: PROOF,
        breaks: "conditions are compared over micro-steps as if every variable kept its value",
        text: "stable(*v) && self.facts.edge(*v).is_none()",
        instead: "self.facts.edge(*v).is_none()",
    },
    Fault {
        name: "tokens-always-marked",
        file: COVER,
        breaks: "a set is taken to have an active step always although transitions take it away",
        text: "component.own.iter().all(|s| around.leaving(*s).iter().all(keeps))",
        instead: "{ let _ = keeps; true }",
    },
    Fault {
        name: "tokens-from-sources",
        file: SEARCH,
        breaks: "steps after a source transition are taken to have one token at most",
        text: "out.extend(self.rule_out_after(t, Reason::Source(t)));",
        instead: "",
    },
    Fault {
        name: "tokens-undecided-divergence",
        file: SEARCH,
        breaks: "a step of which several transitions may clear at once is taken into a component",
        text: "undecided.iter().map(Option::is_some).collect()",
        instead: "undecided.iter().map(|_| false).collect()",
    },
    Fault {
        name: "tokens-two-branches-share-a-set",
        file: COVER,
        breaks: "branches that meet at a transition share a set, and a state cannot say both",
        text: "!twice && !meets",
        instead: "!twice",
    },
    Fault {
        name: "transient-one-short",
        file: TRANSIENT,
        breaks: "a reaction is taken to need one micro-step less than it may (R9)",
        text: "result.longest = Some(time + 1);",
        instead: "result.longest = Some(time);",
    },
    Fault {
        name: "transient-never",
        file: TRANSIENT,
        breaks: "every chart is taken to be done after one micro-step (R8)",
        text: "times.of(*c).is_none_or(|time| time <= 1)",
        instead: "times.of(*c).is_none_or(|time| time <= u32::MAX)",
    },
    Fault {
        name: "transient-in-the-same-micro-step",
        file: LONGEST,
        breaks: "what a change brings about in the next micro-step is taken to be in the same (R8)",
        text: "time + u32::from(*edge.weight())",
        instead: "time + 0 * u32::from(*edge.weight())",
    },
    Fault {
        name: "transient-no-circles",
        file: LONGEST,
        breaks: "changes that bring each other about for ever are taken to end (R9)",
        text: "cyclic && reached",
        instead: "cyclic && !reached",
    },
];
