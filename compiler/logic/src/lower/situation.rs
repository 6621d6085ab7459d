//! How the situation is held: a bit a step, or one whole number for a set of steps that exclude each other.

use super::cover::{Cover, is_small};
use super::symbols::Symbols;
use crate::scan::{Held, Role, State, Step, VarId};
use ecow::eco_format;
use grafc_formula::{Comparison, FormulaId, Pool, Type, Value};
use grafc_model::chart::{GrafcetId, StepId};
use grafc_net::Net;
use index_vec::IndexVec;
use rustc_hash::FxHashMap;
use std::collections::BTreeSet;

/// What holds a step.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Holder {
    /// A variable of its own.
    Bit(VarId),
    /// A value of the set's variable.
    State { set: usize, value: i64 },
}

/// The variables of a set of steps that exclude each other.
#[derive(Clone, Debug)]
pub(crate) struct Set {
    /// The steps, in order of declaration.
    pub(crate) steps: Vec<StepId>,
    /// The grafcet that all of them belong to.
    pub(crate) grafcet: GrafcetId,
    /// Which one is active.
    pub(crate) variable: VarId,
    /// Which one will be: the same as `variable` but within a micro-step that changes something. The variable itself
    /// where transitions write it at once.
    pub(crate) next: VarId,
    /// The value while none is.
    pub(crate) idle: i64,
    /// Whether one of them always is.
    pub(crate) always_marked: bool,
    /// Variables that keep for a while which one was active.
    pub(crate) before: Vec<VarId>,
}

/// The situation of a program.
#[derive(Clone, Debug)]
pub(crate) struct Situation {
    holder: IndexVec<StepId, Holder>,
    active: IndexVec<StepId, FormulaId>,
    step_of_bit: FxHashMap<VarId, StepId>,
    set_of_state: FxHashMap<VarId, usize>,
    pub(crate) sets: Vec<Set>,
    /// Whether transitions write states and bits at once.
    pub(crate) in_place: bool,
    /// Whether all is computed in every micro-step, since that takes fewer lines.
    pub(crate) is_small: bool,
}

impl Situation {
    /// A bit a place; with a cover, one state a set, and bits for what is left.
    pub(crate) fn new(net: &Net, cover: Option<&Cover>, short: bool, symbols: &mut Symbols, pool: &mut Pool) -> Self {
        let mut this = Situation {
            holder: IndexVec::with_capacity(net.places.len()),
            active: IndexVec::with_capacity(net.places.len()),
            step_of_bit: FxHashMap::default(),
            set_of_state: FxHashMap::default(),
            sets: Vec::new(),
            in_place: false,
            is_small: short && is_small(net),
        };
        let mut values: IndexVec<StepId, i64> = net.places.iter().map(|_| 0).collect();
        let mut named = vec![false; net.grafcets.len()];
        let in_place = cover.is_some_and(|cover| cover.moves_in_place(net));
        this.in_place = in_place;
        let cover = cover.map(|cover| cover.worth_a_number(net, this.is_small && !in_place));
        let cover = cover.as_ref();
        let next_role = if this.is_small { Role::Temporary } else { Role::Memory };
        for cover_set in cover.map_or(&[][..], |cover| &cover.sets) {
            let steps = cover_set.steps.clone();
            let Some(grafcet) = steps.first().map(|s| net.places[*s].grafcet) else { continue };
            let idle = number(net, &steps, &mut values);
            let name = &net.grafcets[grafcet].name;
            let name = if name.is_empty() { &net.name } else { name };
            // The first set is called like its grafcet, others by their first step as well.
            let base = if !std::mem::replace(&mut named[grafcet.index()], true) {
                name.to_string()
            } else {
                format!("{name}_{}", net.places[steps[0]].label)
            };
            let widest = steps.iter().map(|s| values[*s]).max().unwrap_or_default();
            let ty = if widest <= i64::from(i16::MAX) { Type::Int } else { Type::Dint };
            let variable = symbols.fresh(Role::State, eco_format!("at_{base}"), ty, None);
            // Where transitions write the states themselves there is no next one.
            let next = if in_place { variable } else { symbols.fresh(next_role, format!("next_{base}"), ty, None) };
            this.set_of_state.insert(variable, this.sets.len());
            this.sets.push(Set {
                steps,
                grafcet,
                variable,
                next,
                idle,
                always_marked: cover_set.always_marked,
                before: Vec::new(),
            });
        }
        for (s, place) in net.places.iter_enumerated() {
            let set = cover.and_then(|cover| cover.of_step[s]);
            let holder = match set {
                Some(set) => Holder::State { set, value: values[s] },
                None => {
                    let bit = symbols.bit(place);
                    this.step_of_bit.insert(bit, s);
                    Holder::Bit(bit)
                }
            };
            this.holder.push(holder);
            let active = match holder {
                Holder::Bit(v) => symbols.read(pool, v),
                Holder::State { set, value } => equals(symbols, pool, this.sets[set].variable, value),
            };
            this.active.push(active);
        }
        this
    }

    /// What holds a step.
    pub(crate) fn holder(&self, s: StepId) -> Holder {
        self.holder[s]
    }

    /// The bit that holds a step, if one does.
    pub(crate) fn bit(&self, s: StepId) -> Option<VarId> {
        match self.holder[s] {
            Holder::Bit(v) => Some(v),
            Holder::State { .. } => None,
        }
    }

    /// The step that a bit holds.
    pub(crate) fn step_of(&self, v: VarId) -> Option<StepId> {
        self.step_of_bit.get(&v).copied()
    }

    /// Notes that a variable keeps the value of another; irrelevant unless that is a state.
    pub(crate) fn kept_in(&mut self, variable: VarId, copy: VarId) {
        if let Some(set) = self.set_of_state.get(&variable) {
            self.sets[*set].before.push(copy);
        }
    }

    /// Whether a step is active.
    pub(crate) fn active(&self, s: StepId) -> FormulaId {
        self.active[s]
    }

    /// The chart's own steps.
    pub(crate) fn of_chart(&self, net: &Net) -> IndexVec<StepId, Step> {
        let mut steps = IndexVec::with_capacity(net.places.len());
        for (s, place) in net.places.iter_enumerated().filter(|(_, place)| !place.auxiliary) {
            steps.push(Step {
                label: place.label.clone(),
                comment: place.comment.clone(),
                span: place.span,
                held: match self.holder[s] {
                    Holder::Bit(v) => Held::Bit(v),
                    Holder::State { set, value } => Held::State(set, value),
                },
                active: self.active[s],
            });
        }
        steps
    }

    /// The states as the program lists them.
    pub(crate) fn states(&self) -> Vec<State> {
        let value = |s: &StepId| match self.holder[*s] {
            Holder::State { value, .. } => value,
            Holder::Bit(_) => 0,
        };
        self.sets
            .iter()
            .map(|set| State {
                variable: set.variable,
                idle: (!set.always_marked).then_some(set.idle),
                values: set.steps.iter().map(|s| (*s, value(s))).collect(),
                copies: [set.next].into_iter().filter(|v| *v != set.variable).chain(set.before.clone()).collect(),
            })
            .collect()
    }
}

/// `variable = value`.
pub(crate) fn equals(symbols: &Symbols, pool: &mut Pool, variable: VarId, value: i64) -> FormulaId {
    let ty = symbols.table[variable].ty;
    let (read, constant) = (symbols.read(pool, variable), pool.constant(Value::Int(value), ty));
    pool.compare(Comparison::Equal, read, constant)
}

/// Gives each step of a set its value and returns the idle one. Steps keep their numbers: all of them if they are called
/// alike (`Y3`), else those that are nothing but a number; others get numbers that are free. Nothing is active at 0, or
/// at -1 if some step is number 0.
fn number(net: &Net, steps: &[StepId], values: &mut IndexVec<StepId, i64>) -> i64 {
    let own: Vec<Option<(&str, i64)>> = steps.iter().map(|s| numbered(&net.places[*s].label)).collect();
    let word = own.first().copied().flatten().map(|(word, _)| word);
    let alike = own.iter().all(|n| n.is_some_and(|(w, _)| Some(w) == word));
    let kept: Vec<Option<i64>> =
        own.iter().map(|n| n.filter(|(word, _)| alike || word.is_empty()).map(|(_, number)| number)).collect();
    let taken: BTreeSet<i64> = kept.iter().copied().flatten().collect();
    let mut free = (1..).filter(|n| !taken.contains(n));
    for (s, kept) in steps.iter().zip(kept) {
        values[*s] = kept.or_else(|| free.next()).unwrap_or_default();
    }
    if taken.contains(&0) { -1 } else { 0 }
}

/// A label as a word and the number behind it, which may not be written in another way: `Y3`, not `Y03`.
fn numbered(label: &str) -> Option<(&str, i64)> {
    let word = label.trim_end_matches(|c: char| c.is_ascii_digit());
    let digits = &label[word.len()..];
    let plain = digits.len() <= 4 && (digits == "0" || !digits.starts_with('0'));
    if plain { Some((word, digits.parse().ok()?)) } else { None }
}
