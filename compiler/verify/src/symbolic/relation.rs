//! A reaction as relations: how it begins, one micro-step, and what is seen of that.

use super::bits::{Bit, Bits};
use super::run::Run;
use super::seen::Seen;
use super::sets::{Halt, Sets};
use super::updates::Updates;
use crate::claimed::Claimed;
use crate::clocks::Clocks;
use crate::facts::Fact;
use crate::live::Live;
use biodivine_lib_bdd::{Bdd, BddVariable};
use grafc_formula::VarId;
use grafc_logic::scan::{Flag, Program, Role, TransitionId};
use rustc_hash::FxHashMap;

/// The relations of a program.
pub(crate) struct Relation {
    pub(crate) bits: Bits,
    /// From a state, with inputs and time, to before the first micro-step.
    pub(crate) begin: Updates,
    /// One micro-step.
    pub(crate) step: Updates,
    /// The last one of a reaction, and what comes after it.
    pub(crate) last: Updates,
    /// In a state, inputs and times that the assumptions allow.
    pub(crate) allowed: Bdd,
    /// Whether it needs another one.
    pub(crate) again: Bdd,
    /// Before the first micro-step of the initial reaction, with all inputs.
    pub(crate) start: Bdd,
    /// What is seen before a micro-step and of it.
    pub(crate) facts: FxHashMap<Fact, Bdd>,
    /// What is seen at the start, by inputs.
    pub(crate) at_start: Vec<(Fact, Bdd)>,
    /// Whether each step is active, in a state.
    pub(crate) active: Vec<Bdd>,
    /// Of inputs and time.
    pub(crate) asked: Vec<BddVariable>,
    /// Of time alone.
    pub(crate) ends: Vec<BddVariable>,
    /// What a state needs not remember between reactions.
    pub(crate) within: Vec<BddVariable>,
    /// What it does remember.
    pub(crate) kept: Vec<BddVariable>,
    /// In a state, whether the chart may have come to its end.
    pub(crate) is_final: Bdd,
    /// In a state, of what leads to what, both.
    pub(crate) leads: Vec<(Bdd, Bdd)>,
}

impl Relation {
    pub(crate) fn new(program: &Program, sets: &mut Sets) -> Result<Relation, Halt> {
        let claimed = Claimed::new(program);
        let live = Live::new(program, &claimed.after);
        let clocks = Clocks::new(program)?;
        let marks = claimed.marks();
        let bits = Bits::new(program, &live, &marks, &clocks)?;
        let yes = bits.all.mk_true();

        let mut run = Run::at_first(program, &bits, &clocks);
        run.statements(&program.first, &yes, sets)?;
        let mut at_start = situation(program, &run, sets)?;
        at_start.extend(flags(program, &run));
        run.statements(&program.before, &yes, sets)?;
        let mut start = keeping(&claimed, &run, bits.consistent.clone(), sets)?;
        for (bit, function) in new_values(&bits, &run, sets)? {
            let becomes = sets.iff(&bits.all.mk_var(bit.now), &function)?;
            start = sets.and(&start, &becomes)?;
        }

        let mut run = Run::anywhere(program, &bits, &clocks);
        let mut active = Vec::with_capacity(program.steps.len());
        for step in &program.steps {
            active.push(run.truth(step.active, sets)?);
        }
        let mark = |v: &VarId| bits.all.mk_var(bits.of[v][0].now);
        let mut is_final = run.no();
        for v in &claimed.finals {
            is_final = sets.or(&is_final, &mark(v))?;
        }
        let leads = claimed.leads.iter().map(|(from, to)| (mark(from), mark(to))).collect();
        marks.iter().for_each(|v| run.values[*v] = Some(Seen::Truth(bits.all.mk_false())));
        run.pass(sets)?;
        run.statements(&program.before, &yes, sets)?;
        let allowed = keeping(&claimed, &run, bits.consistent.clone(), sets)?;
        let begin = Updates::new(&bits.all, new_values(&bits, &run, sets)?, sets)?;

        let mut run = Run::anywhere(program, &bits, &clocks);
        run.statements(&program.micro_step, &yes, sets)?;
        let step = Updates::new(&bits.all, new_values(&bits, &run, sets)?, sets)?;
        let again = match program.repeat {
            Some(repeat) => truth(&run, repeat.again).unwrap_or_else(|| bits.all.mk_false()),
            None => bits.all.mk_false(),
        };
        let mut facts = situation(program, &run, sets)?;
        let flagged = flags(program, &run);
        let after: Vec<Bdd> = facts[..program.steps.len()].iter().map(|(_, active)| active.clone()).collect();
        facts.extend(of_transitions(program, &run, &active, &after, sets)?);
        run.statements(&claimed.after, &yes, sets)?;
        let last = Updates::new(&bits.all, new_values(&bits, &run, sets)?, sets)?;
        facts.extend(of_claims(&claimed, &run, &again, sets)?);
        let mut by_fact: FxHashMap<Fact, Bdd> = FxHashMap::default();
        for (fact, seen) in flagged.into_iter().chain(facts) {
            let seen = match by_fact.get(&fact) {
                Some(other) => sets.or(other, &seen)?,
                None => seen,
            };
            by_fact.insert(fact, seen);
        }
        let asked: Vec<BddVariable> = bits.asked.values().copied().collect();
        let mut ends: Vec<BddVariable> = bits
            .asked
            .iter()
            .filter(|(atom, _)| matches!(atom, crate::atom::Atom::Ends(..)))
            .map(|(_, v)| *v)
            .collect();
        ends.sort_unstable();
        let lasting = |v: &VarId| live.between_calls.contains(v) || marks.contains(v);
        let of = |is: bool| {
            bits.of.iter().filter(move |(v, _)| lasting(v) == is).flat_map(|(_, of)| of.iter().map(|bit| bit.now))
        };
        let within: Vec<BddVariable> = of(false).collect();
        let timers = bits.timers.iter().flat_map(|t| std::iter::once(t.on).chain(t.passed.iter().copied()));
        let kept: Vec<BddVariable> = of(true).chain(timers.map(|bit| bit.now)).collect();
        let mut asked = asked;
        asked.sort_unstable();
        Ok(Relation {
            begin,
            step,
            last,
            allowed,
            again,
            start,
            facts: by_fact,
            at_start,
            active,
            asked,
            ends,
            within,
            kept,
            is_final,
            leads,
            bits,
        })
    }
}

/// Of inputs those that keep all assumptions.
fn keeping(claimed: &Claimed, run: &Run, mut inputs: Bdd, sets: &mut Sets) -> Result<Bdd, Halt> {
    for assumed in claimed.assumptions.iter().filter_map(|v| truth(run, *v)) {
        inputs = sets.and(&inputs, &assumed)?;
    }
    Ok(inputs)
}

/// What is seen of claims in the state that a reaction ends in.
fn of_claims(claimed: &Claimed, run: &Run, again: &Bdd, sets: &mut Sets) -> Result<Vec<(Fact, Bdd)>, Halt> {
    let mut facts = Vec::new();
    for (place, v) in claimed.assertions.iter().enumerate() {
        let broken = truth(run, *v).map(|holds| holds.not());
        facts.extend(broken.map(|broken| (Fact::Broken(place), broken)));
    }
    for (place, v) in claimed.wanted.iter().enumerate() {
        facts.extend(truth(run, *v).map(|holds| (Fact::Wanted(place), holds)));
    }
    facts.into_iter().map(|(fact, seen)| Ok((fact, sets.minus(&seen, again)?))).collect()
}

fn truth(run: &Run, v: VarId) -> Option<Bdd> {
    match &run.values[v] {
        Some(Seen::Truth(truth)) => Some(truth.clone()),
        _ => None,
    }
}

/// What each bit becomes.
fn new_values(bits: &Bits, run: &Run, sets: &mut Sets) -> Result<Vec<(Bit, Bdd)>, Halt> {
    let mut out = Vec::new();
    for (v, of) in &bits.of {
        match &run.values[*v] {
            Some(Seen::Truth(truth)) => out.push((of[0], truth.clone())),
            Some(Seen::Number(number)) => {
                out.extend(of.iter().enumerate().map(|(place, bit)| (*bit, super::number::bit(number, place).clone())));
            }
            // What holds no value is written before it is read.
            _ => out.extend(of.iter().map(|bit| (*bit, bits.all.mk_false()))),
        }
    }
    for (phases, running) in bits.timers.iter().zip(&run.timers) {
        out.push((phases.on, running.on.clone()));
        for (bit, passed) in phases.passed.iter().zip(&running.passed) {
            out.push((*bit, sets.and(&running.on, passed)?));
        }
    }
    Ok(out)
}

fn situation(program: &Program, run: &Run, sets: &mut Sets) -> Result<Vec<(Fact, Bdd)>, Halt> {
    let steps = program.steps.iter_enumerated();
    steps.map(|(s, step)| Ok((Fact::Active(s), run.truth(step.active, sets)?))).collect()
}

fn flags(program: &Program, run: &Run) -> Vec<(Fact, Bdd)> {
    let of = |flag: Flag, fact: Fact| {
        let variables = program.variables.iter_enumerated();
        let found = variables.filter(move |(_, variable)| variable.role == Role::Flag(flag));
        found.filter_map(|(v, _)| Some((fact, truth(run, v)?))).collect::<Vec<_>>()
    };
    [of(Flag::AllocConflict, Fact::AllocConflict), of(Flag::ForceConflict, Fact::ForceConflict)].concat()
}

fn of_transitions(
    program: &Program,
    run: &Run,
    before: &[Bdd],
    after: &[Bdd],
    sets: &mut Sets,
) -> Result<Vec<(Fact, Bdd)>, Halt> {
    let mut facts = Vec::new();
    let seen = program.observing.iter().flat_map(|observing| &observing.transitions);
    let cleared: Vec<(TransitionId, Bdd)> =
        seen.filter_map(|seen| Some((seen.transition, truth(run, seen.cleared)?))).collect();
    let steps = program.steps.len();
    let mut left: Vec<Vec<usize>> = vec![Vec::new(); steps];
    let mut entered: Vec<Vec<usize>> = vec![Vec::new(); steps];
    for (place, (t, _)) in cleared.iter().enumerate() {
        let (pre, post) = program.elements.around(*t);
        pre.iter().filter(|s| s.index() < steps).for_each(|s| left[s.index()].push(place));
        post.iter().filter(|s| s.index() < steps).for_each(|s| entered[s.index()].push(place));
    }
    for (s, _) in program.steps.iter_enumerated() {
        let (mut one, mut two) = (run.no(), run.no());
        for place in &left[s.index()] {
            let both = sets.and(&one, &cleared[*place].1)?;
            two = sets.or(&two, &both)?;
            one = sets.or(&one, &cleared[*place].1)?;
        }
        let mut into = run.no();
        for place in &entered[s.index()] {
            into = sets.or(&into, &cleared[*place].1)?;
        }
        let stays = sets.and(&before[s.index()], &after[s.index()])?;
        let into = sets.and(&into, &stays)?;
        facts.push((Fact::Selection(s), two));
        facts.push((Fact::Reentry(s), sets.minus(&into, &one)?));
    }
    facts.extend(cleared.into_iter().map(|(t, cleared)| (Fact::Cleared(t), cleared)));
    Ok(facts)
}
