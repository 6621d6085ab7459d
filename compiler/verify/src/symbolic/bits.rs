//! The variables of the diagrams: bits of the program's variables, phases of timers, and what is asked of inputs and time.

use super::order;
use super::sets::Halt;
use crate::atom::{Atom, Bound, is_whole};
use crate::beyond::Beyond;
use crate::clocks::Clocks;
use crate::inputs::{bounds, computed};
use crate::live::Live;
use crate::pack;
use biodivine_lib_bdd::{Bdd, BddVariable, BddVariableSet};
use grafc_formula::{Formula, FormulaId, TimerId, Type, VarId};
use grafc_logic::scan::{Program, Role, State, Statement, TransitionId};
use index_vec::IndexVec;
use rustc_hash::{FxHashMap, FxHashSet};
use std::collections::{BTreeMap, BTreeSet};

/// The variables, and what they stand for.
pub(crate) struct Bits {
    pub(crate) all: BddVariableSet,
    /// The bits of each variable of the program that is read before it is written, the lowest first, each with a place
    /// beside it that takes its old value.
    pub(crate) of: BTreeMap<VarId, Vec<Bit>>,
    /// Of each timer whether it runs, and whether each of its times has passed.
    pub(crate) timers: IndexVec<TimerId, Phases>,
    /// What is asked, and its variable.
    pub(crate) asked: FxHashMap<Atom, BddVariable>,
    /// Variables that belong together, all in some part; they may have some in common.
    pub(crate) parts: Vec<Vec<BddVariable>>,
    /// What holds of the answers: a bound is not reached where a lower one is not.
    pub(crate) consistent: Bdd,
}

/// What is made of more variables than so many holds nothing together.
const MOST_NEAR: usize = 200;

/// A variable, and one for its old value.
#[derive(Clone, Copy)]
pub(crate) struct Bit {
    pub(crate) now: BddVariable,
    pub(crate) old: BddVariable,
}

/// The variables of a timer.
pub(crate) struct Phases {
    pub(crate) on: Bit,
    pub(crate) passed: Vec<Bit>,
}

/// How many bits a value takes in a diagram; none if it cannot be taken apart.
pub(crate) fn width(ty: Type) -> Option<usize> {
    is_whole(ty).then(|| pack::width(ty) as usize)
}

/// How many bits those variables take that hold which of some steps is active: they take no values but those of the state.
fn widths_of_states(program: &Program) -> FxHashMap<VarId, usize> {
    let width = |state: &State| {
        let most = state.values.iter().map(|(_, value)| *value).chain(state.idle).max().unwrap_or_default();
        (i64::BITS - most.leading_zeros()).max(1) as usize
    };
    program.states.iter().flat_map(|state| state.variables().map(move |v| (v, width(state)))).collect()
}

/// What a variable of a diagram is to be.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
enum Wanted {
    Bit(VarId, usize),
    On(TimerId),
    Passed(TimerId, usize),
    Asked(Atom),
}

impl Bits {
    /// For a program, of which some variables are marks: nothing reads them, and they are a part of the state.
    pub(crate) fn new(program: &Program, live: &Live, marks: &[VarId], clocks: &Clocks) -> Result<Bits, Halt> {
        let kept = live.between_micro_steps.iter().chain(&live.between_calls).chain(marks).copied();
        let kept: BTreeSet<VarId> = kept.filter(|v| Some(*v) != program.started).collect();
        let of_states = widths_of_states(program);
        let mut wanted: BTreeSet<Wanted> = BTreeSet::new();
        for v in &kept {
            let width = of_states.get(v).copied().or_else(|| width(program.variables[*v].ty));
            let width = width.ok_or_else(|| beyond(program, *v))?;
            wanted.extend((0..width).map(|bit| Wanted::Bit(*v, bit)));
        }
        for (t, times) in clocks.times.iter_enumerated() {
            wanted.insert(Wanted::On(t));
            wanted.extend((0..times.len()).map(|place| Wanted::Passed(t, place)));
            wanted.extend(times.iter().map(|time| Wanted::Asked(Atom::Ends(clocks.operand[t], *time))));
        }
        let computed = computed(program);
        for v in &computed {
            let width = width(program.variables[*v].ty).ok_or_else(|| beyond(program, *v))?;
            wanted.extend((0..width).map(|bit| Wanted::Asked(Atom::Bit(*v, bit))));
        }
        for id in program.pool.ids() {
            if let Formula::Variable(v) = program.pool.get(id)
                && program.variables[*v].role == Role::Input
                && program.variables[*v].ty == Type::Bool
            {
                wanted.insert(Wanted::Asked(Atom::Holds(*v)));
            }
        }
        let bounds = bounds(program);
        for (v, bounds) in &bounds {
            wanted.extend(bounds.iter().map(|bound| Wanted::Asked(Atom::AtLeast(*v, *bound))));
        }
        Bits::placed(program, &wanted, bounds, clocks)
    }

    fn placed(
        program: &Program,
        wanted: &BTreeSet<Wanted>,
        bounds: BTreeMap<VarId, BTreeSet<Bound>>,
        clocks: &Clocks,
    ) -> Result<Bits, Halt> {
        let wanted: Vec<Wanted> = wanted.iter().copied().collect();
        let (groups, parts) = groups(program, &wanted, clocks);
        let places = order::places(wanted.len() + program.variables.len(), &groups);
        let mut sorted: Vec<usize> = (0..wanted.len()).collect();
        sorted.sort_by_key(|w| places[*w]);
        // A bit takes two variables.
        let mut at: FxHashMap<Wanted, Bit> = FxHashMap::default();
        let mut next = 0;
        for w in sorted {
            let now = BddVariable::from_index(next);
            next += if matches!(wanted[w], Wanted::Asked(_)) { 1 } else { 2 };
            at.insert(wanted[w], Bit { now, old: BddVariable::from_index(next - 1) });
        }
        let count = u16::try_from(next).ok().filter(|count| *count < u16::MAX - 1);
        let all = BddVariableSet::new_anonymous(count.ok_or(Halt::Limit(crate::limit::Limit::Nodes))?);
        let mut of: BTreeMap<VarId, Vec<Bit>> = BTreeMap::new();
        for w in &wanted {
            if let Wanted::Bit(v, _) = w {
                of.entry(*v).or_default().push(at[w]);
            }
        }
        let phases = |(t, times): (TimerId, &Vec<i64>)| Phases {
            on: at[&Wanted::On(t)],
            passed: (0..times.len()).map(|place| at[&Wanted::Passed(t, place)]).collect(),
        };
        let timers = clocks.times.iter_enumerated().map(phases).collect();
        let asked: FxHashMap<Atom, BddVariable> = wanted
            .iter()
            .filter_map(|w| match w {
                Wanted::Asked(atom) => Some((*atom, at[w].now)),
                Wanted::Bit(..) | Wanted::On(_) | Wanted::Passed(..) => None,
            })
            .collect();
        let mut consistent = all.mk_true();
        let mut chain = |chain: Vec<Atom>| {
            for pair in chain.windows(2) {
                let (lower, higher) = (asked[&pair[0]], asked[&pair[1]]);
                let follows = all.mk_var(higher).imp(&all.mk_var(lower));
                consistent = consistent.and(&follows);
            }
        };
        for (v, bounds) in &bounds {
            chain(bounds.iter().map(|bound| Atom::AtLeast(*v, *bound)).collect());
        }
        let mut ends: BTreeMap<usize, BTreeSet<i64>> = BTreeMap::new();
        for (t, times) in clocks.times.iter_enumerated() {
            ends.entry(clocks.operand[t]).or_default().extend(times);
        }
        for (operand, times) in ends {
            chain(times.into_iter().map(|time| Atom::Ends(operand, time)).collect());
        }
        let mut parts: Vec<Vec<BddVariable>> =
            parts.into_iter().map(|part| part.into_iter().map(|place| at[&wanted[place]].now).collect()).collect();
        let held: FxHashSet<BddVariable> = parts.iter().flatten().copied().collect();
        let rest = wanted.iter().map(|w| at[w].now).filter(|v| !held.contains(v));
        parts.extend(rest.map(|v| vec![v]));
        Ok(Bits { all, of, timers, asked, parts, consistent })
    }
}

pub(crate) fn beyond(program: &Program, v: VarId) -> Halt {
    Halt::Beyond(Beyond::Input(program.variables[v].name.to_string()))
}

/// What belongs together, the closest first: what transitions ask for, then what statements do; and what those transitions ask
/// for that are connected.
fn groups(program: &Program, wanted: &[Wanted], clocks: &Clocks) -> (Vec<Vec<usize>>, Vec<Vec<usize>>) {
    let mut of_variable: BTreeMap<VarId, Vec<usize>> = BTreeMap::new();
    let mut of_timer: BTreeMap<TimerId, Vec<usize>> = BTreeMap::new();
    for (place, w) in wanted.iter().enumerate() {
        match w {
            Wanted::Bit(v, _) => of_variable.entry(*v).or_default().push(place),
            Wanted::On(t) | Wanted::Passed(t, _) => of_timer.entry(*t).or_default().push(place),
            Wanted::Asked(Atom::Holds(v) | Atom::AtLeast(v, _) | Atom::Bit(v, _)) => {
                of_variable.entry(*v).or_default().push(place)
            }
            Wanted::Asked(Atom::Ends(operand, _)) => {
                for (t, _) in clocks.operand.iter_enumerated().filter(|(_, other)| *other == operand) {
                    of_timer.entry(t).or_default().push(place);
                }
            }
        }
    }
    let mut values: FxHashMap<VarId, FormulaId> = FxHashMap::default();
    for statement in program.statements() {
        if let Statement::Assign { target, value, .. } = statement {
            values.entry(*target).or_insert(*value);
        }
    }
    // What variables and formulas are made of; what is no bit of a state stands for what it is made of itself.
    let made_of = |variables: &[VarId], formulas: &[FormulaId]| -> Vec<usize> {
        let (mut out, mut numbers) = (Vec::new(), Vec::new());
        let mut met: FxHashSet<VarId> = FxHashSet::default();
        let mut open: Vec<VarId> = variables.to_vec();
        let mut formulas: Vec<FormulaId> = formulas.to_vec();
        loop {
            for v in std::mem::take(&mut open) {
                if met.len() >= MOST_NEAR || !met.insert(v) {
                    continue;
                }
                match of_variable.get(&v) {
                    Some(number) if number.len() > 1 => numbers.push(number),
                    Some(bit) => out.extend(bit),
                    None => formulas.extend(values.get(&v)),
                }
            }
            let Some(formula) = formulas.pop() else { break };
            for id in program.pool.below(formula) {
                match program.pool.get(id) {
                    Formula::Variable(v) => open.push(*v),
                    Formula::TimerDone(t) | Formula::TimerElapsed(t) => {
                        out.extend(of_timer.get(t).into_iter().flatten());
                    }
                    Formula::Constant(_)
                    | Formula::Not(_)
                    | Formula::And(_)
                    | Formula::Or(_)
                    | Formula::Xor(..)
                    | Formula::Compare(..)
                    | Formula::Arithmetic(..)
                    | Formula::Negate(_)
                    | Formula::Widen(_) => {}
                }
            }
        }
        // Numbers that are compared, or added, bit by bit.
        let longest = numbers.iter().map(|number| number.len()).max().unwrap_or(0);
        out.extend((0..longest).flat_map(|bit| numbers.iter().filter_map(move |number| number.get(bit).copied())));
        out
    };
    // What a transition asks for is beside the steps before it.
    let observing = program.observing.iter().flat_map(|observing| &observing.transitions);
    let shown: FxHashMap<TransitionId, [VarId; 2]> =
        observing.map(|seen| (seen.transition, [seen.enabled, seen.cleared])).collect();
    let mut groups: Vec<Vec<usize>> = Vec::new();
    let mut parts = Vec::new();
    for connected in order::transitions(program) {
        let first = groups.len();
        groups.extend(connected.iter().filter_map(|t| shown.get(t)).map(|seen| made_of(seen, &[])));
        let of_part: BTreeSet<usize> = groups[first..].iter().flatten().copied().collect();
        parts.push(of_part.into_iter().collect());
    }
    // Each statement, with what the innermost choice around it asks for.
    let mut open: Vec<(&Statement, Vec<FormulaId>)> = Vec::new();
    for section in [&program.after, &program.micro_step, &program.before] {
        open.extend(section.iter().rev().map(|statement| (statement, Vec::new())));
    }
    while let Some((statement, around)) = open.pop() {
        let (variables, formulas): (Vec<VarId>, Vec<FormulaId>) = match statement {
            Statement::Heading(_) => continue,
            Statement::Assign { target, value, .. } => (vec![*target], vec![*value]),
            Statement::Divide(division) => (vec![division.target], vec![division.dividend, division.divisor]),
            Statement::CallTimer { timer, input, .. } => {
                groups.extend(of_timer.get(timer).cloned());
                (Vec::new(), vec![*input])
            }
            Statement::Case { of, .. } => (vec![*of], Vec::new()),
            Statement::If(choice) => (Vec::new(), choice.branches.iter().map(|(when, _)| *when).collect()),
        };
        groups.push(made_of(&variables, &[formulas.clone(), around].concat()));
        open.extend(statement.bodies().flatten().map(|within| (within, formulas.clone())));
    }
    groups.extend(of_variable.into_values().chain(of_timer.into_values()));
    (groups, parts)
}
