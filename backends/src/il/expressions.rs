//! Formulas as instructions that leave their value in the accumulator.
//!
//! ```text
//! clr_3 OR (X1 AND NOT clr_1)      LD X1  ANDN clr_1  OR clr_3          the operand that needs a parenthesis comes first
//! (a AND b) OR (c AND d)           LD a  AND b  OR( c  AND d  )         a second one stands in one
//! e OR (a AND (b OR c OR (…)))     LD …  ST part_1                      and what needs one within it goes before
//! ```
//!
//! A *chain* is a formula that needs no parenthesis. Operands of `AND`, `OR`, `XOR` and comparisons may come in any order,
//! for none has an effect. Recursion is as deep as a formula, which [`crate::limits`] bounds.

use super::code::Code;
use crate::iec::literals::{self, type_name, zero};
use crate::iec::names::Names;
use ecow::{EcoString, eco_format};
use grafc_formula::{Arithmetic, Comparison, Formula, FormulaId, Type};
use grafc_logic::scan::Program;
use rustc_hash::FxHashMap;
use std::borrow::Cow;

/// How formulas of one program are loaded.
pub(super) struct Expressions<'p> {
    program: &'p Program,
    /// Which formulas need no parenthesis.
    chains: Vec<bool>,
    /// The variables that hold parts of the formula that is being loaded.
    parts: FxHashMap<FormulaId, EcoString>,
}

/// What is done with the accumulator, operand by operand.
enum Form<'p> {
    /// An operand of other instructions.
    Simple,
    /// The value of a formula, and then an instruction with a constant or without operand.
    Then(FormulaId, Cow<'static, str>, &'static str),
    /// A constant, and then an operation.
    From(EcoString, &'static str, FormulaId),
    /// The first of two operands, and then an operation.
    Pair(FormulaId, &'static str, FormulaId),
    /// Any operand first, and then an operation on each of the others.
    Any(&'static str, &'p [FormulaId]),
}

impl<'p> Expressions<'p> {
    /// Finds the chains; operands come before operators.
    pub fn new(program: &'p Program) -> Self {
        let mut this = Expressions { program, chains: Vec::new(), parts: FxHashMap::default() };
        for id in program.pool.ids() {
            let chain = this.is_chain(id);
            this.chains.push(chain);
        }
        this
    }

    /// Loads the value of a formula.
    pub fn load(&mut self, code: &mut Code, names: &mut Names, id: FormulaId) {
        self.parts.clear();
        self.prepare(code, names, id);
        self.value(code, names, id, None);
    }

    /// The text of an operand, if a formula is one.
    pub fn operand(&self, names: &Names, id: FormulaId) -> Option<EcoString> {
        let pool = &self.program.pool;
        match pool.get(id) {
            Formula::Constant(value) => Some(literals::operand(*value, pool.ty(id))),
            Formula::Variable(variable) => Some(names.variables[*variable].clone()),
            Formula::TimerDone(timer) => Some(eco_format!("{}.Q", names.timers[*timer])),
            Formula::TimerElapsed(timer) => Some(eco_format!("{}.ET", names.timers[*timer])),
            Formula::Not(_)
            | Formula::And(_)
            | Formula::Or(_)
            | Formula::Xor(..)
            | Formula::Compare(..)
            | Formula::Arithmetic(..)
            | Formula::Negate(_)
            | Formula::Widen(_) => None,
        }
    }

    fn form(&self, id: FormulaId) -> Form<'p> {
        let pool = &self.program.pool;
        match pool.get(id) {
            Formula::Constant(_) | Formula::Variable(_) | Formula::TimerDone(_) | Formula::TimerElapsed(_) => {
                Form::Simple
            }
            Formula::Not(a) => Form::Then(*a, "NOT".into(), ""),
            Formula::And(list) => Form::Any("AND", pool.list(*list)),
            Formula::Or(list) => Form::Any("OR", pool.list(*list)),
            Formula::Xor([a, b]) if self.goes_first(*b, *a) => Form::Pair(*b, "XOR", *a),
            Formula::Xor([a, b]) => Form::Pair(*a, "XOR", *b),
            Formula::Compare(op, [a, b]) if self.goes_first(*b, *a) => Form::Pair(*b, comparison(op.mirrored()), *a),
            Formula::Compare(op, [a, b]) => Form::Pair(*a, comparison(*op), *b),
            // `TIME * n` is taken everywhere, `n * TIME` is not.
            Formula::Arithmetic(Arithmetic::Multiply, [a, b])
                if pool.ty(*b) == Type::Time && pool.ty(*a) != Type::Time =>
            {
                Form::Pair(*b, "MUL", *a)
            }
            Formula::Arithmetic(op, [a, b]) => Form::Pair(*a, arithmetic(*op), *b),
            Formula::Negate(a) => match pool.ty(id) {
                // Negates a zero, too.
                Type::Real => Form::Then(*a, "MUL".into(), "REAL#-1.0"),
                Type::Lreal => Form::Then(*a, "MUL".into(), "-1.0"),
                ty @ (Type::Bool | Type::Int | Type::Dint | Type::Uint | Type::Udint | Type::Time) => {
                    Form::From(zero(ty), "SUB", *a)
                }
            },
            Formula::Widen(a) => {
                let function = format!("{}_TO_{}", type_name(pool.ty(*a)), type_name(pool.ty(id)));
                Form::Then(*a, function.into(), "")
            }
        }
    }

    /// Whether an instruction has the formula, or its negation, as its operand.
    fn is_simple(&self, id: FormulaId) -> bool {
        self.program.pool.is_leaf(self.positive(id).0)
    }

    /// Whether it saves something that the second of two operands is loaded first.
    fn goes_first(&self, second: FormulaId, first: FormulaId) -> bool {
        !self.is_simple(second) && (self.is_simple(first) || self.chains[first.index()] && !self.chains[second.index()])
    }

    /// The place of the operand that is loaded first: one that would need most if it came later. A parenthesis cannot
    /// begin with a negation, so there that comes later.
    fn leader(&self, list: &[FormulaId], inside: bool) -> usize {
        let place = |wanted: &dyn Fn(FormulaId) -> bool| list.iter().position(|id| wanted(*id));
        place(&|id| !self.chains[id.index()])
            .or_else(|| place(&|id| !self.is_simple(id)))
            .or_else(|| place(&|id| inside && self.program.pool.is_leaf(id)))
            .unwrap_or(0)
    }

    fn is_chain(&self, id: FormulaId) -> bool {
        let chain = |id: FormulaId| self.chains[id.index()];
        match self.form(id) {
            Form::Simple => true,
            Form::Then(a, ..) => chain(a),
            Form::From(_, _, a) => self.is_simple(a),
            Form::Pair(a, _, b) => chain(a) && self.is_simple(b),
            Form::Any(_, list) => {
                list.iter().all(|id| chain(*id)) && list.iter().filter(|id| !self.is_simple(**id)).count() <= 1
            }
        }
    }

    /// Stores the parts that would need a parenthesis within one.
    fn prepare(&mut self, code: &mut Code, names: &mut Names, id: FormulaId) {
        if self.chains[id.index()] {
            return;
        }
        match self.form(id) {
            Form::Simple => {}
            Form::Then(a, ..) => self.prepare(code, names, a),
            Form::From(_, _, a) => self.part(code, names, a),
            Form::Pair(a, _, b) => {
                self.prepare(code, names, a);
                self.part(code, names, b);
            }
            Form::Any(_, list) => {
                let leader = self.leader(list, false);
                for (place, id) in list.iter().enumerate() {
                    if place == leader {
                        self.prepare(code, names, *id);
                    } else {
                        self.part(code, names, *id);
                    }
                }
            }
        }
    }

    /// Stores an operand that does not come first, if it needs a parenthesis itself.
    fn part(&mut self, code: &mut Code, names: &mut Names, id: FormulaId) {
        let (id, _) = self.positive(id);
        if self.chains[id.index()] || self.parts.contains_key(&id) {
            return;
        }
        self.prepare(code, names, id);
        self.value(code, names, id, None);
        let place = self.parts.len();
        if code.parts.len() == place {
            code.parts.push(names.namer.name(&format!("part_{}", place + 1)));
        }
        let name = code.parts[place].clone();
        code.instruction("ST", &name);
        self.parts.insert(id, name);
    }

    /// What is negated, and whether something is.
    fn positive(&self, id: FormulaId) -> (FormulaId, bool) {
        if let Formula::Not(a) = self.program.pool.get(id) { (*a, true) } else { (id, false) }
    }

    /// Loads a value; with an operator it is what a parenthesis begins with.
    fn value(&self, code: &mut Code, names: &Names, id: FormulaId, operator: Option<&str>) {
        let begin = |code: &mut Code, text: &str| match operator {
            Some(operator) => code.open(operator, text),
            None => code.operation("LD", text),
        };
        match self.form(id) {
            Form::Simple => begin(code, &self.operand(names, id).unwrap_or_default()),
            Form::Then(a, then, constant) => match self.operand(names, a) {
                Some(text) if operator.is_none() && then == "NOT" => code.operation("LDN", &text),
                Some(_) | None => {
                    self.value(code, names, a, operator);
                    code.operation(&then, constant);
                }
            },
            Form::From(constant, operation, a) => {
                begin(code, &constant);
                self.apply(code, names, operation, a);
            }
            Form::Pair(a, operation, b) => {
                self.value(code, names, a, operator);
                self.apply(code, names, operation, b);
            }
            Form::Any(operation, list) => {
                let leader = self.leader(list, operator.is_some());
                self.value(code, names, list[leader], operator);
                for (_, id) in list.iter().enumerate().filter(|(place, _)| *place != leader) {
                    self.apply(code, names, operation, *id);
                }
            }
        }
    }

    /// An operation on the accumulator and an operand.
    pub fn apply(&self, code: &mut Code, names: &Names, operation: &str, id: FormulaId) {
        let (id, negated) = self.positive(id);
        let operation = format!("{operation}{}", if negated { "N" } else { "" });
        match self.parts.get(&id).cloned().or_else(|| self.operand(names, id)) {
            Some(text) => code.operation(&operation, &text),
            None => {
                self.value(code, names, id, Some(&operation));
                code.close();
            }
        }
    }
}

fn comparison(op: Comparison) -> &'static str {
    match op {
        Comparison::Equal => "EQ",
        Comparison::NotEqual => "NE",
        Comparison::Less => "LT",
        Comparison::LessEqual => "LE",
        Comparison::Greater => "GT",
        Comparison::GreaterEqual => "GE",
    }
}

fn arithmetic(op: Arithmetic) -> &'static str {
    match op {
        Arithmetic::Add => "ADD",
        Arithmetic::Subtract => "SUB",
        Arithmetic::Multiply => "MUL",
        Arithmetic::Divide => "DIV",
        Arithmetic::Modulo => "MOD",
    }
}
