//! Formulas of truth values as chains of the one-bit accumulator.
//!
//! ```text
//! clr_3 OR (X1 AND NOT clr_1)      A X1  AN clr_1  O clr_3              what needs a parenthesis comes first
//! (a AND b) OR e OR (c AND d)      A a  A b  O e  O  A c  A d           a bare O: AND goes before OR
//! (a OR b) AND (c OR d)            O a  O b  A( O c  O d )              the second needs a parenthesis
//! ```
//!
//! After a bare `O` the chain is not one value until it ends, so it stands only where it ends at once: before `=`, `S`,
//! `R`, a jump, or a closing parenthesis (an *end*). What would need more than seven open parentheses goes through a
//! variable first. Operands may come in any order, since none has an effect. Recursion is as deep as a formula, which
//! [`crate::limits`] bounds.

use super::code::Code;
use super::numbers::Numbers;
use super::{AwlNames, local};
use ecow::EcoString;
use grafc_formula::{Formula, FormulaId, List, Type};
use grafc_logic::scan::Program;
use rustc_hash::FxHashMap;

/// So many parentheses may be open.
const DEEPEST: u32 = 7;

/// How conditions of one program are loaded.
pub(super) struct Conditions<'p> {
    program: &'p Program,
    /// For each formula, how many parentheses it opens: as a chain that may go on, and at an end.
    needs: Vec<(u32, u32)>,
    /// The variables that hold parts of the formula that is being loaded.
    parts: FxHashMap<FormulaId, EcoString>,
}

impl<'p> Conditions<'p> {
    /// Counts the parentheses of all formulas; operands come before operators.
    pub fn new(program: &'p Program) -> Self {
        let mut this = Conditions { program, needs: Vec::new(), parts: FxHashMap::default() };
        for id in program.pool.ids() {
            let needs = this.count(id);
            this.needs.push(needs);
        }
        this
    }

    /// Gives the result of logic operation the value of a formula that is no constant.
    pub fn load(&mut self, code: &mut Code, names: &mut AwlNames, id: FormulaId) {
        self.parts.clear();
        self.prepare(code, names, id);
        self.end(code, names, id);
    }

    fn get(&self, id: FormulaId) -> &'p Formula {
        self.program.pool.get(id)
    }

    fn list(&self, list: List) -> &'p [FormulaId] {
        self.program.pool.list(list)
    }

    /// What is negated, and whether something is.
    fn positive(&self, id: FormulaId) -> (FormulaId, bool) {
        if let Formula::Not(a) = self.get(id) { (*a, true) } else { (id, false) }
    }

    /// The operand of an instruction that has the formula or its negation for one.
    fn operand(&self, names: &AwlNames, id: FormulaId) -> Option<EcoString> {
        if let Some(part) = self.parts.get(&id) {
            return Some(part.clone());
        }
        match self.get(id) {
            Formula::Variable(variable) => Some(names.variable(*variable)),
            Formula::TimerDone(timer) => Some(local(&names.timers[*timer].done)),
            Formula::Constant(_)
            | Formula::TimerElapsed(_)
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

    /// Whether an instruction has the formula, or its negation, as its operand.
    fn is_simple(&self, id: FormulaId) -> bool {
        let (id, _) = self.positive(id);
        self.parts.contains_key(&id) || self.program.pool.is_leaf(id)
    }

    /// How many parentheses an operand that does not come first opens.
    fn parenthesis(&self, id: FormulaId) -> u32 {
        if self.is_simple(id) { 0 } else { 1 + self.needs[self.positive(id).0.index()].1 }
    }

    /// How many parentheses an operand of `OR` opens behind a bare `O`, or in a parenthesis.
    fn summand(&self, id: FormulaId) -> u32 {
        match self.get(id) {
            Formula::And(list) => self.list(*list).iter().map(|factor| self.parenthesis(*factor)).max().unwrap_or(0),
            _ => self.parenthesis(id),
        }
    }

    /// The place of the operand that comes first: one that would open most parentheses if it came later.
    fn leader(&self, list: &[FormulaId], cost: impl Fn(FormulaId) -> u32) -> usize {
        let costs: Vec<u32> = list.iter().map(|id| cost(*id)).collect();
        let most = costs.iter().copied().max().unwrap_or(0);
        costs.iter().position(|cost| *cost == most).unwrap_or(0)
    }

    fn count(&self, id: FormulaId) -> (u32, u32) {
        let chain = |list: &[FormulaId], cost: &dyn Fn(FormulaId) -> u32| {
            let leader = self.leader(list, cost);
            let others = list.iter().enumerate().filter(|(place, _)| *place != leader);
            let others = others.map(|(_, id)| cost(*id)).max().unwrap_or(0);
            others.max(self.needs[list[leader].index()].0)
        };
        let operand = |id: FormulaId| self.parenthesis(id);
        match self.get(id) {
            Formula::Not(a) => {
                let (chain, _) = self.needs[a.index()];
                (chain, chain)
            }
            Formula::And(list) => {
                let chain = chain(self.list(*list), &operand);
                (chain, chain)
            }
            Formula::Or(list) => {
                let list = self.list(*list);
                (chain(list, &operand), chain(list, &|id| self.summand(id)))
            }
            Formula::Xor([a, b]) => {
                let chain = chain(&[*a, *b], &operand);
                (chain, chain)
            }
            Formula::Constant(_)
            | Formula::Variable(_)
            | Formula::TimerDone(_)
            | Formula::TimerElapsed(_)
            | Formula::Compare(..)
            | Formula::Arithmetic(..)
            | Formula::Negate(_)
            | Formula::Widen(_) => (0, 0),
        }
    }

    /// Stores the parts that would open too many parentheses.
    fn prepare(&mut self, code: &mut Code, names: &mut AwlNames, id: FormulaId) {
        if self.needs[id.index()].0 <= DEEPEST {
            return;
        }
        for operand in self.program.pool.operands(id) {
            let (operand, _) = self.positive(operand);
            if self.is_simple(operand) || self.needs[operand.index()].0 < DEEPEST {
                continue;
            }
            self.prepare(code, names, operand);
            self.end(code, names, operand);
            let place = self.parts.len();
            let part = code.part(names, place, Type::Bool, "part");
            code.assign(&part);
            code.rlo = None;
            self.parts.insert(operand, part);
        }
    }

    /// The value of a formula where a chain begins and ends.
    fn end(&self, code: &mut Code, names: &AwlNames, id: FormulaId) {
        let Formula::Or(list) = self.get(id) else { return self.chain(code, names, id, "A") };
        if self.parts.contains_key(&id) {
            return self.chain(code, names, id, "A");
        }
        let list = self.list(*list);
        let leader = self.leader(list, |id| self.summand(id));
        self.chain(code, names, list[leader], "O");
        for (_, id) in list.iter().enumerate().filter(|(place, _)| *place != leader) {
            match self.get(*id) {
                Formula::And(factors) if !self.parts.contains_key(id) => {
                    code.bit("O", "");
                    self.list(*factors).iter().for_each(|factor| self.apply(code, names, "A", *factor));
                }
                _ => self.apply(code, names, "O", *id),
            }
        }
    }

    /// The value of a formula where a chain begins; `operator` says how the chain goes on.
    fn chain(&self, code: &mut Code, names: &AwlNames, id: FormulaId, operator: &str) {
        if self.is_simple(id) && !matches!(self.get(self.positive(id).0), Formula::Constant(_)) {
            return self.apply(code, names, operator, id);
        }
        match self.get(id) {
            Formula::Not(a) => match self.get(*a) {
                Formula::Compare(op, [x, y]) => Numbers::new(self.program).compare(code, names, *op, *x, *y, true),
                _ => {
                    self.chain(code, names, *a, "A");
                    code.bit("NOT", "");
                }
            },
            Formula::And(list) => self.operands(code, names, self.list(*list), "A"),
            Formula::Or(list) => self.operands(code, names, self.list(*list), "O"),
            Formula::Xor([a, b]) => self.operands(code, names, &[*a, *b], "X"),
            Formula::Compare(op, [x, y]) => Numbers::new(self.program).compare(code, names, *op, *x, *y, false),
            Formula::Constant(_) => code.truth(self.program.pool.as_truth(id).unwrap_or(false)),
            // These are operands, or no truth values.
            Formula::Variable(_)
            | Formula::TimerDone(_)
            | Formula::TimerElapsed(_)
            | Formula::Arithmetic(..)
            | Formula::Negate(_)
            | Formula::Widen(_) => self.apply(code, names, operator, id),
        }
    }

    /// One operand that begins a chain, and the others.
    fn operands(&self, code: &mut Code, names: &AwlNames, list: &[FormulaId], operator: &str) {
        let leader = self.leader(list, |id| self.parenthesis(id));
        self.chain(code, names, list[leader], operator);
        for (_, id) in list.iter().enumerate().filter(|(place, _)| *place != leader) {
            self.apply(code, names, operator, *id);
        }
    }

    /// An operation on the value so far and an operand; where a chain begins, the operand alone.
    fn apply(&self, code: &mut Code, names: &AwlNames, operator: &str, id: FormulaId) {
        let (id, negated) = self.positive(id);
        let operator = format!("{operator}{}", if negated { "N" } else { "" });
        match self.operand(names, id) {
            Some(text) => code.bit(&operator, &text),
            None => {
                code.open(&operator);
                self.end(code, names, id);
                code.close();
            }
        }
    }
}
