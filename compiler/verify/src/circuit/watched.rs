//! A circuit with what engines of our own look for in it: facts of micro-steps and of states, and what inputs and times it
//! stands for.

use super::build::{Beyond, Builder, Circuit, Held, Of};
use super::graph::{Graph, Literal};
use super::numbers::constant;
use crate::atom::{Atom, Bound};
use crate::claimed::Claimed;
use crate::facts::Fact;
use crate::inputs::{bounds, computed};
use grafc_formula::{Comparison, VarId};
use grafc_logic::scan::{Flag, Program, Role, TransitionId};

/// A circuit that shows what happens.
pub(crate) struct Watched {
    pub(crate) circuit: Circuit,
    /// Whether a call begins.
    pub(crate) begins: Literal,
    /// Whether there was a clock before.
    pub(crate) begun: Literal,
    /// What is seen at a clock.
    pub(crate) facts: Vec<(Fact, Literal)>,
    /// What is asked of inputs and time, where a call begins.
    pub(crate) atoms: Vec<(Atom, Literal)>,
    /// Whether each step is active, before a clock.
    pub(crate) standing: Vec<Literal>,
    /// The timers.
    pub(crate) timers: Vec<Timing>,
    /// What is kept of single truths that may depend on each other: no bits of numbers, and no inputs.
    pub(crate) truths: Vec<Literal>,
}

/// A timer.
pub(crate) struct Timing {
    /// What it measures.
    pub(crate) operand: usize,
    /// The place of the latch that says whether it runs.
    pub(crate) on: usize,
    /// Its times, each with the place of the latch that says whether it has passed.
    pub(crate) times: Vec<(i64, usize)>,
}

/// The circuit of a program that shows its transitions and its claims.
///
/// # Errors
/// What has no circuit.
pub(crate) fn watched(program: &Program) -> Result<Watched, Beyond> {
    let claimed = Claimed::new(program);
    let mut builder = Builder::new(program)?;
    let begins = builder.begin()?;
    let begun = builder.latch("begun".to_string(), false, Of::Begun);
    if let Some(wanted) = program.observing.as_ref().and_then(|observing| observing.wanted) {
        builder.values[wanted] = Held::Bool(Literal::TRUE);
    }
    let standing = builder.situation()?;
    let mut facts = Vec::new();

    builder.run(&program.first, begins)?;
    // Of the initial reaction it is seen how it starts.
    let starts = builder.graph.and(begins, !begun);
    let at_start = [active(&builder.situation()?), flags(&builder)].concat();
    facts.extend(at_start.into_iter().map(|(fact, seen)| (fact, builder.graph.and(starts, seen))));
    builder.run(&program.before, begins)?;

    let before = builder.situation()?;
    builder.run(&program.micro_step, Literal::TRUE)?;
    let (again, after) = (builder.again(), builder.situation()?);
    facts.extend(active(&after));
    facts.extend(flags(&builder));
    facts.extend(of_transitions(&mut builder, &before, &after));
    builder.run(&program.after, !again)?;
    for (place, v) in claimed.assertions.iter().enumerate() {
        let holds = builder.bool_of(*v);
        facts.push((Fact::Broken(place), builder.graph.and(!again, !holds)));
    }
    for (place, v) in claimed.wanted.iter().enumerate() {
        let holds = builder.bool_of(*v);
        facts.push((Fact::Wanted(place), builder.graph.and(!again, holds)));
    }

    let atoms = atoms(&mut builder);
    let timers = timers(&builder);
    let truths = truths(&builder);
    let facts = joined(&mut builder.graph, facts);
    Ok(Watched { circuit: builder.end(begins, again, after), begins, begun, facts, atoms, standing, timers, truths })
}

fn active(situation: &[Literal]) -> Vec<(Fact, Literal)> {
    situation.iter().enumerate().map(|(s, active)| (Fact::Active(s.into()), *active)).collect()
}

fn flags(builder: &Builder) -> Vec<(Fact, Literal)> {
    let of = |flag: Flag, fact: Fact| {
        builder.program.of_role(Role::Flag(flag)).map(move |(v, _)| (fact, v)).collect::<Vec<(Fact, VarId)>>()
    };
    let all = [of(Flag::AllocConflict, Fact::AllocConflict), of(Flag::ForceConflict, Fact::ForceConflict)].concat();
    all.into_iter().map(|(fact, v)| (fact, builder.bool_of(v))).collect()
}

/// What clearing does, as [`crate::facts::Facts::micro_step`] has it.
fn of_transitions(builder: &mut Builder, before: &[Literal], after: &[Literal]) -> Vec<(Fact, Literal)> {
    let program = builder.program;
    let seen = program.observing.iter().flat_map(|observing| &observing.transitions);
    let cleared: Vec<(TransitionId, Literal)> =
        seen.map(|seen| (seen.transition, builder.bool_of(seen.cleared))).collect();
    let steps = program.steps.len();
    let (mut left, mut entered) = (vec![Vec::new(); steps], vec![Vec::new(); steps]);
    for (t, cleared) in &cleared {
        let (pre, post) = program.elements.around(*t);
        pre.iter().filter(|s| s.index() < steps).for_each(|s| left[s.index()].push(*cleared));
        post.iter().filter(|s| s.index() < steps).for_each(|s| entered[s.index()].push(*cleared));
    }
    let graph = &mut builder.graph;
    let mut facts = Vec::new();
    for s in program.steps.indices() {
        let (mut one, mut two) = (Literal::FALSE, Literal::FALSE);
        for cleared in &left[s.index()] {
            let both = graph.and(one, *cleared);
            two = graph.or(two, both);
            one = graph.or(one, *cleared);
        }
        let into = graph.any(entered[s.index()].iter().copied());
        facts.push((Fact::Selection(s), two));
        facts.push((Fact::Reentry(s), graph.all([into, before[s.index()], after[s.index()], !one])));
    }
    facts.extend(cleared.into_iter().map(|(t, cleared)| (Fact::Cleared(t), cleared)));
    facts
}

/// Each fact once.
fn joined(graph: &mut Graph, mut facts: Vec<(Fact, Literal)>) -> Vec<(Fact, Literal)> {
    facts.sort_by_key(|(fact, _)| *fact);
    let mut out: Vec<(Fact, Literal)> = Vec::with_capacity(facts.len());
    for (fact, seen) in facts {
        match out.last_mut().filter(|(last, _)| *last == fact) {
            Some((_, before)) => *before = graph.or(*before, seen),
            None => out.push((fact, seen)),
        }
    }
    out
}

fn atoms(builder: &mut Builder) -> Vec<(Atom, Literal)> {
    let (by_bits, bounds) = (computed(builder.program), bounds(builder.program));
    let mut atoms = Vec::new();
    for (v, held) in std::mem::take(&mut builder.given) {
        match held {
            Held::Bool(literal) => atoms.push((Atom::Holds(v), literal)),
            Held::Number(bits) if by_bits.contains(&v) => {
                atoms.extend(bits.iter().enumerate().map(|(bit, literal)| (Atom::Bit(v, bit), *literal)));
            }
            Held::Number(bits) => {
                let ty = builder.program.variables[v].ty;
                for bound in bounds.get(&v).into_iter().flatten().filter(|bound| bound.trivial(ty).is_none()) {
                    let Bound::Whole(n) = bound else { continue };
                    let at_least = builder.graph.compare(Comparison::GreaterEqual, ty, &bits, &constant(ty, *n));
                    atoms.push((Atom::AtLeast(v, *bound), at_least));
                }
            }
            Held::Unknown => {}
        }
    }
    atoms.extend(builder.ends.iter().map(|((operand, ms), ends)| (Atom::Ends(*operand, *ms), *ends)));
    atoms
}

fn timers(builder: &Builder) -> Vec<Timing> {
    let of = |t| Timing { operand: builder.clocks.operand[t], on: usize::MAX, times: Vec::new() };
    let mut timers: Vec<Timing> = builder.program.timers.indices().map(of).collect();
    for (place, kept) in builder.kept.iter().enumerate() {
        match kept.of {
            Of::Timer(t) => timers[t.index()].on = place,
            Of::Passed(t, time) => timers[t.index()].times.push((builder.clocks.times[t][time], place)),
            Of::Rest | Of::Begun | Of::Variable(..) => {}
        }
    }
    timers
}

fn truths(builder: &Builder) -> Vec<Literal> {
    let is_one = |of: &Of| match of {
        Of::Rest | Of::Begun | Of::Timer(_) | Of::Passed(..) => true,
        Of::Variable(v, _) => match builder.program.variables[*v].role {
            Role::Step | Role::Memory | Role::Temporary | Role::Internal | Role::Flag(_) => {
                builder.program.variables[*v].ty == grafc_formula::Type::Bool
            }
            Role::Input | Role::Output | Role::Constant | Role::State | Role::Observed => false,
        },
    };
    builder.kept.iter().filter(|kept| is_one(&kept.of)).map(|kept| kept.now).collect()
}
