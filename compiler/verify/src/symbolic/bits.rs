//! The variables of the diagrams: bits of the program's variables, phases of timers, and what is asked of inputs and time.

use super::order;
use super::sets::Halt;
use crate::atom::{Atom, Bound, Question, is_whole};
use crate::beyond::Beyond;
use crate::clocks::{Clocks, constant};
use crate::live::Live;
use crate::pack;
use biodivine_lib_bdd::{Bdd, BddVariable, BddVariableSet};
use grafc_formula::{Formula, FormulaId, TimerId, Type, Value, VarId};
use grafc_logic::scan::{Program, Role, Statement};
use index_vec::IndexVec;
use rustc_hash::FxHashMap;
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
    /// What holds of the answers: a bound is not reached where a lower one is not.
    pub(crate) consistent: Bdd,
}

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

/// The input that a formula is, perhaps as another type.
fn given(program: &Program, mut formula: FormulaId) -> Option<VarId> {
    while let Formula::Widen(inner) = program.pool.get(formula) {
        formula = *inner;
    }
    match program.pool.get(formula) {
        Formula::Variable(v) => (program.variables[*v].role == Role::Input).then_some(*v),
        Formula::TimerDone(_)
        | Formula::TimerElapsed(_)
        | Formula::Constant(_)
        | Formula::Not(_)
        | Formula::And(_)
        | Formula::Or(_)
        | Formula::Xor(..)
        | Formula::Compare(..)
        | Formula::Arithmetic(..)
        | Formula::Negate(_)
        | Formula::Widen(_) => None,
    }
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
    /// For a program.
    pub(crate) fn new(program: &Program, live: &Live, clocks: &Clocks) -> Result<Bits, Halt> {
        let kept = live.between_micro_steps.iter().chain(&live.between_calls).copied();
        let kept: BTreeSet<VarId> = kept.filter(|v| Some(*v) != program.started).collect();
        let mut wanted: BTreeSet<Wanted> = BTreeSet::new();
        for v in &kept {
            let width = width(program.variables[*v].ty).ok_or_else(|| beyond(program, *v))?;
            wanted.extend((0..width).map(|bit| Wanted::Bit(*v, bit)));
        }
        for (t, times) in clocks.times.iter_enumerated() {
            wanted.insert(Wanted::On(t));
            wanted.extend((0..times.len()).map(|place| Wanted::Passed(t, place)));
            wanted.extend(times.iter().map(|time| Wanted::Asked(Atom::Ends(clocks.operand[t], *time))));
        }
        let mut bounds: BTreeMap<VarId, BTreeSet<Bound>> = BTreeMap::new();
        for id in program.pool.ids() {
            if let Formula::Variable(v) = program.pool.get(id)
                && program.variables[*v].role == Role::Input
                && program.variables[*v].ty == Type::Bool
            {
                wanted.insert(Wanted::Asked(Atom::Holds(*v)));
            }
            let Formula::Compare(op, a, b) = *program.pool.get(id) else { continue };
            for (side, other, op) in [(a, b, op), (b, a, op.mirrored())] {
                let (Some(v), Some(value)) = (given(program, side), constant(program, other)) else { continue };
                let ty = program.variables[v].ty;
                if ty != Type::Bool && !matches!(value, Value::Real(x) if x.is_nan()) {
                    let Question { from, to, .. } = Question::new(op, ty, value);
                    bounds.entry(v).or_default().extend(from.into_iter().chain(to));
                }
            }
        }
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
        let groups = groups(program, &wanted, clocks);
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
        Ok(Bits { all, of, timers, asked, consistent })
    }
}

pub(crate) fn beyond(program: &Program, v: VarId) -> Halt {
    Halt::Beyond(Beyond::Input(program.variables[v].name.to_string()))
}

/// What stands in one statement should be near; variables of the program that are no bits of a state hold them together.
fn groups(program: &Program, wanted: &[Wanted], clocks: &Clocks) -> Vec<Vec<usize>> {
    let mut of_variable: BTreeMap<VarId, Vec<usize>> = BTreeMap::new();
    let mut of_timer: BTreeMap<TimerId, Vec<usize>> = BTreeMap::new();
    for (place, w) in wanted.iter().enumerate() {
        match w {
            // The lowest bits are those that count.
            Wanted::Bit(v, bit) if *bit < 4 => of_variable.entry(*v).or_default().push(place),
            Wanted::Bit(..) => {}
            Wanted::On(t) | Wanted::Passed(t, _) => of_timer.entry(*t).or_default().push(place),
            Wanted::Asked(Atom::Holds(v) | Atom::AtLeast(v, _)) => of_variable.entry(*v).or_default().push(place),
            Wanted::Asked(Atom::Ends(operand, _)) => {
                for (t, _) in clocks.operand.iter_enumerated().filter(|(_, other)| *other == operand) {
                    of_timer.entry(t).or_default().push(place);
                }
            }
        }
    }
    let variable = |v: VarId| of_variable.get(&v).cloned().unwrap_or_else(|| vec![wanted.len() + v.index()]);
    let read = |formula: FormulaId| -> Vec<usize> {
        let mut out = Vec::new();
        for id in program.pool.below(formula) {
            match program.pool.get(id) {
                Formula::Variable(v) if program.variables[*v].role != Role::Constant => out.extend(variable(*v)),
                Formula::TimerDone(t) | Formula::TimerElapsed(t) => {
                    out.extend(of_timer.get(t).into_iter().flatten());
                }
                Formula::Variable(_)
                | Formula::Constant(_)
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
        out
    };
    let mut groups: Vec<Vec<usize>> = of_variable.values().chain(of_timer.values()).cloned().collect();
    // The bits of a number follow each other.
    for pair in wanted.windows(2) {
        if let [Wanted::Bit(a, low), Wanted::Bit(b, _)] = pair
            && a == b
        {
            let place = wanted.binary_search(&Wanted::Bit(*a, *low)).unwrap_or_default();
            groups.push(vec![place, place + 1]);
        }
    }
    groups.sort();
    for statement in program.statements() {
        let mut group = match statement {
            Statement::Assign { target, value, .. } => [variable(*target), read(*value)].concat(),
            Statement::CallTimer { timer, input, .. } => {
                [of_timer.get(timer).cloned().unwrap_or_default(), read(*input)].concat()
            }
            Statement::If { branches, .. } => branches.iter().flat_map(|(when, _)| read(*when)).collect(),
            Statement::Heading(_) | Statement::Divide(_) | Statement::Case { .. } => continue,
        };
        group.sort_unstable();
        group.dedup();
        // What everything stands in holds nothing together.
        if group.len() > 1 && group.len() < 40 {
            groups.push(group);
        }
    }
    groups
}
