//! Numbers that count on: beyond all that they are compared with, one value is as good as another. Sets of states are made
//! wider so, and never narrower: what no state of them does, nothing does.

use super::bits::Bits;
use super::number;
use super::seen::Seen;
use super::sets::{Halt, Sets};
use crate::clocks::constant;
use biodivine_lib_bdd::{Bdd, BddVariable};
use grafc_formula::{Comparison, Formula, Type, Value, VarId};
use grafc_logic::scan::{Program, Statement};
use std::collections::BTreeMap;

/// The numbers of a program.
pub(super) struct Counters {
    list: Vec<Counter>,
}

/// One of them.
struct Counter {
    bits: Vec<BddVariable>,
    /// Its values above all that it is compared with, and those below.
    beyond: Vec<Bdd>,
}

impl Counters {
    /// The numbers among the bits.
    pub(super) fn new(program: &Program, bits: &Bits, sets: &mut Sets) -> Result<Counters, Halt> {
        let mut ends: BTreeMap<VarId, (i64, i64)> = BTreeMap::new();
        let mut note = |v: VarId, value: Option<Value>| {
            if let Some(Value::Int(n) | Value::Time(n)) = value {
                let (least, most) = ends.entry(v).or_insert((n, n));
                (*least, *most) = ((*least).min(n), (*most).max(n));
            }
        };
        for id in program.pool.ids() {
            let Formula::Compare(_, [a, b]) = *program.pool.get(id) else { continue };
            for (side, other) in [(a, b), (b, a)] {
                if let Formula::Variable(v) = program.pool.get(side) {
                    note(*v, constant(program, other));
                }
            }
        }
        for statement in program.statements() {
            if let Statement::Assign { target, value, .. } = statement {
                note(*target, constant(program, *value));
            }
        }
        for (v, variable) in program.variables.iter_enumerated() {
            note(v, Some(variable.initial()));
        }
        let mut list = Vec::new();
        for (v, of) in &bits.of {
            let ty = program.variables[*v].ty;
            let is_whole = ty != Type::Bool && super::bits::width(ty) == Some(of.len());
            let Some((least, most)) = ends.get(v).filter(|_| is_whole) else { continue };
            let functions = of.iter().map(|bit| bits.all.mk_var(bit.now)).collect();
            let Seen::Number(now) = number::of_bits(&bits.all, ty, functions) else { continue };
            let mut than = |op, n: &i64| number::compare(op, &now, &number::whole(&bits.all, *n), sets);
            let beyond = vec![than(Comparison::Greater, most)?, than(Comparison::Less, least)?];
            list.push(Counter { bits: of.iter().map(|bit| bit.now).collect(), beyond });
        }
        Ok(Counters { list })
    }

    /// Whether there are none.
    pub(super) fn is_empty(&self) -> bool {
        self.list.is_empty()
    }

    /// With a state beyond what a number is compared with, all states that differ in nothing but how far.
    pub(super) fn widened(&self, states: Bdd, sets: &mut Sets) -> Result<Bdd, Halt> {
        let mut states = states;
        for Counter { bits, beyond } in &self.list {
            for beyond in beyond {
                let there = sets.and(&states, beyond)?;
                if there.is_false() {
                    continue;
                }
                let anywhere = sets.exists(&there, bits)?;
                let anywhere = sets.and(&anywhere, beyond)?;
                states = sets.or(&states, &anywhere)?;
            }
        }
        Ok(states)
    }
}
