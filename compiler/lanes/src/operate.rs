//! What the operations do, in all lanes at once.

use crate::Word;
use crate::code::{At, BoolAt, LANES, Operation, RealAt, WholeAt};
use grafc_formula::number::{arithmetic, compare, divide, negate};
use grafc_formula::{Arithmetic, Comparison, TimerId, Type, Value};
use index_vec::IndexVec;

/// A number a lane.
pub(crate) type Row<T> = [T; LANES];

/// What a timer holds in each lane.
#[derive(Clone)]
pub(crate) struct Timer {
    /// Where its input is true.
    pub(crate) runs: Word,
    /// Since when.
    pub(crate) since: Row<i64>,
    /// When it was called last.
    pub(crate) at: Row<i64>,
    /// How long its input must be true.
    pub(crate) preset: i64,
}

/// The values of all lanes.
pub(crate) struct Values {
    pub(crate) bools: IndexVec<BoolAt, Word>,
    pub(crate) wholes: IndexVec<WholeAt, Row<i64>>,
    pub(crate) reals: IndexVec<RealAt, Row<f64>>,
    pub(crate) timers: IndexVec<TimerId, Timer>,
    /// The time of the call.
    pub(crate) now: Row<i64>,
}

/// The lanes of a mask.
pub(crate) fn lanes(mut mask: Word) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let lane = mask.trailing_zeros() as usize;
        mask &= mask.wrapping_sub(1);
        (lane < LANES).then_some(lane)
    })
}

/// A bit a lane.
fn word(holds: impl Fn(usize) -> bool) -> Word {
    (0..LANES).fold(0, |word, lane| word | Word::from(holds(lane)) << lane)
}

fn keep(to: &mut Word, from: Word, mask: Word) {
    *to = *to & !mask | from & mask;
}

impl Values {
    /// Does an operation; what it keeps, it keeps in the lanes of the mask.
    pub(crate) fn operate(&mut self, operation: &Operation, mask: Word) {
        let bools = &mut self.bools;
        match *operation {
            Operation::Not(to, a) => bools[to] = !bools[a],
            Operation::And(to, a, b) => bools[to] = bools[a] & bools[b],
            Operation::Or(to, a, b) => bools[to] = bools[a] | bools[b],
            Operation::Xor(to, a, b) => bools[to] = bools[a] ^ bools[b],
            Operation::CompareWholes(to, op, a, b) => bools[to] = compare_wholes(op, &self.wholes[a], &self.wholes[b]),
            Operation::CompareReals(to, op, a, b) => {
                let (a, b) = (&self.reals[a], &self.reals[b]);
                bools[to] = word(|lane| compare(op, Value::Real(a[lane]), Value::Real(b[lane])));
            }
            Operation::TimerDone(to, timer) => {
                let Timer { runs, since, at, preset } = &self.timers[timer];
                bools[to] = if *runs == 0 { 0 } else { runs & word(|lane| at[lane] - since[lane] >= *preset) };
            }
            Operation::TimerElapsed(to, timer) => {
                let Timer { runs, since, at, .. } = &self.timers[timer];
                let elapsed = |lane: usize| if runs >> lane & 1 == 1 { at[lane] - since[lane] } else { 0 };
                self.wholes[to] = std::array::from_fn(elapsed);
            }
            Operation::Wholes(to, op, ty, a, b) => self.wholes[to] = wholes(op, ty, self.wholes[a], &self.wholes[b]),
            Operation::Reals(to, op, ty, a, b) => {
                let (a, b) = (self.reals[a], &self.reals[b]);
                self.reals[to] =
                    std::array::from_fn(|lane| real(arithmetic(op, ty, Value::Real(a[lane]), Value::Real(b[lane]))));
            }
            Operation::NegateWholes(to, ty, a) => {
                let negated =
                    |n: i64| if ty == Type::Time { n.wrapping_neg() } else { whole(negate(ty, Value::Int(n))) };
                self.wholes[to] = self.wholes[a].map(negated);
            }
            Operation::NegateReals(to, ty, a) => {
                self.reals[to] = self.reals[a].map(|x| real(negate(ty, Value::Real(x))));
            }
            Operation::Widen(to, a) => self.reals[to] = self.wholes[a].map(|n| n as f64),
            Operation::KeepBool(to, from) => {
                let from = bools[from];
                keep(&mut bools[to], from, mask);
            }
            Operation::KeepWhole(to, from) => {
                let from = self.wholes[from];
                keep_row(&mut self.wholes[to], &from, mask);
            }
            Operation::KeepReal(to, from) => {
                let from = self.reals[from];
                keep_row(&mut self.reals[to], &from, mask);
            }
            Operation::DivideWholes(to, modulo, ty, (a, b), flag) => {
                let (a, b) = (self.wholes[a], self.wholes[b]);
                for lane in lanes(mask) {
                    let quotient = divide(ty, modulo, of_type(ty, a[lane]), of_type(ty, b[lane]));
                    bools[flag] |= Word::from(quotient.is_none()) << lane;
                    self.wholes[to][lane] = quotient.map_or(0, whole);
                }
            }
            Operation::DivideReals(to, modulo, ty, (a, b), flag) => {
                let (a, b) = (self.reals[a], self.reals[b]);
                for lane in lanes(mask) {
                    let quotient = divide(ty, modulo, Value::Real(a[lane]), Value::Real(b[lane]));
                    bools[flag] |= Word::from(quotient.is_none()) << lane;
                    self.reals[to][lane] = quotient.map_or(0.0, real);
                }
            }
            Operation::CallTimer(timer, input) => {
                let input = bools[input];
                let timer = &mut self.timers[timer];
                for lane in lanes(input & mask & !timer.runs) {
                    timer.since[lane] = self.now[lane];
                }
                keep(&mut timer.runs, input, mask);
                keep_row(&mut timer.at, &self.now, mask);
            }
        }
    }

    /// The value of a lane.
    pub(crate) fn value(&self, at: At, ty: Type, lane: usize) -> Value {
        match at {
            At::Bool(at) => Value::Bool(self.bools[at] >> lane & 1 == 1),
            At::Whole(at) => of_type(ty, self.wholes[at][lane]),
            At::Real(at) => Value::Real(self.reals[at][lane]),
        }
    }

    /// The lanes in which a value is not that of others at a place of the same type. A NaN equals a NaN.
    pub(crate) fn differing(&self, at: At, others: &Values, there: At) -> Word {
        match (at, there) {
            (At::Bool(at), At::Bool(there)) => self.bools[at] ^ others.bools[there],
            (At::Whole(at), At::Whole(there)) => {
                let (mine, theirs) = (&self.wholes[at], &others.wholes[there]);
                word(|lane| mine[lane] != theirs[lane])
            }
            (At::Real(at), At::Real(there)) => {
                let (mine, theirs) = (&self.reals[at], &others.reals[there]);
                word(|lane| mine[lane] != theirs[lane] && !(mine[lane].is_nan() && theirs[lane].is_nan()))
            }
            (at, there) => unreachable!("{at:?} and {there:?} are of one type"),
        }
    }

    /// Gives the lanes of a mask a value.
    pub(crate) fn set(&mut self, at: At, value: Value, mask: Word) {
        match (at, value) {
            (At::Bool(at), Value::Bool(value)) => keep(&mut self.bools[at], if value { Word::MAX } else { 0 }, mask),
            (At::Whole(at), Value::Int(n) | Value::Time(n)) => keep_row(&mut self.wholes[at], &[n; LANES], mask),
            (At::Real(at), Value::Real(x)) => keep_row(&mut self.reals[at], &[x; LANES], mask),
            (at, value) => unreachable!("{value:?} lies in no {at:?}"),
        }
    }

    /// Gives a lane a value.
    pub(crate) fn set_lane(&mut self, at: At, value: Value, lane: usize) {
        match (at, value) {
            (At::Bool(at), Value::Bool(value)) => keep(&mut self.bools[at], Word::from(value) << lane, 1 << lane),
            (At::Whole(at), Value::Int(n) | Value::Time(n)) => self.wholes[at][lane] = n,
            (At::Real(at), Value::Real(x)) => self.reals[at][lane] = x,
            (at, value) => unreachable!("{value:?} lies in no {at:?}"),
        }
    }
}

fn keep_row<T: Copy>(to: &mut Row<T>, from: &Row<T>, mask: Word) {
    if mask == Word::MAX {
        *to = *from;
    } else {
        lanes(mask).for_each(|lane| to[lane] = from[lane]);
    }
}

fn compare_wholes(op: Comparison, a: &Row<i64>, b: &Row<i64>) -> Word {
    match op {
        Comparison::Equal => word(|lane| a[lane] == b[lane]),
        Comparison::NotEqual => word(|lane| a[lane] != b[lane]),
        Comparison::Less => word(|lane| a[lane] < b[lane]),
        Comparison::LessEqual => word(|lane| a[lane] <= b[lane]),
        Comparison::Greater => word(|lane| a[lane] > b[lane]),
        Comparison::GreaterEqual => word(|lane| a[lane] >= b[lane]),
    }
}

fn wholes(op: Arithmetic, ty: Type, a: Row<i64>, b: &Row<i64>) -> Row<i64> {
    std::array::from_fn(|lane| whole(arithmetic(op, ty, of_type(ty, a[lane]), of_type(ty, b[lane]))))
}

/// A whole number, or a time.
fn of_type(ty: Type, n: i64) -> Value {
    if ty == Type::Time { Value::Time(n) } else { Value::Int(n) }
}

fn whole(value: Value) -> i64 {
    match value {
        Value::Int(n) | Value::Time(n) => n,
        Value::Bool(_) | Value::Real(_) => unreachable!("whole numbers give whole numbers"),
    }
}

fn real(value: Value) -> f64 {
    match value {
        Value::Real(x) => x,
        Value::Bool(_) | Value::Int(_) | Value::Time(_) => unreachable!("reals give reals"),
    }
}
