//! Numbers as functions with `EN`.
//!
//! ```text
//! IF c THEN n := a + 1        ──┤c├──[ EN ADD ]── n
//! q := a / b                  ──[ EN EQ b, 0 ]── part_1
//!                             ──┤part_1├──(S DIV0)
//!                             ──┤part_1├──[ EN MOVE 0 ]── q
//!                             ──┤/part_1├──[ EN DIV ]── q
//! ```

use super::circuit::{Factor, Ladder};
use super::rung::{BlockCall, Contact, End, Sink, Storage};
use crate::iec::literals::{literal, operand, zero};
use ecow::EcoString;
use grafc_formula::{Arithmetic, Comparison, Formula, FormulaId, Type, Value};
use grafc_logic::scan::{ByMinusOne, Division, Guard, VarId};

impl Ladder<'_> {
    /// Stores what a formula of numbers gives, behind some contacts. An operator is a function, and its operands texts:
    /// a text with a literal of a time in its middle, `t + T#1s`, is a puzzle to Beremiz.
    pub fn calculate(&mut self, target: VarId, value: FormulaId, behind: Vec<Contact>) {
        let pool = &self.program.pool;
        let ty = pool.ty(value);
        let text = |id: &FormulaId| self.text(*id);
        let (kind, operands) = match pool.get(value) {
            // `TIME * n` is taken everywhere, `n * TIME` is not.
            Formula::Arithmetic(Arithmetic::Multiply, [a, b]) if pool.ty(*b) == Type::Time => {
                ("MUL", [text(b), text(a)])
            }
            Formula::Arithmetic(op, [a, b]) => {
                let kind = match op {
                    Arithmetic::Add => "ADD",
                    Arithmetic::Subtract => "SUB",
                    Arithmetic::Multiply => "MUL",
                    Arithmetic::Divide => "DIV",
                    Arithmetic::Modulo => "MOD",
                };
                (kind, [text(a), text(b)])
            }
            // Negates a zero, too.
            Formula::Negate(a) if matches!(ty, Type::Real | Type::Lreal) => {
                ("MUL", [text(a), operand(Value::Real(-1.0), ty)])
            }
            Formula::Negate(a) => ("SUB", [zero(ty), text(a)]),
            Formula::Constant(_)
            | Formula::Variable(_)
            | Formula::TimerDone(_)
            | Formula::TimerElapsed(_)
            | Formula::Not(_)
            | Formula::And(_)
            | Formula::Or(_)
            | Formula::Xor(..)
            | Formula::Compare(..)
            | Formula::Widen(_) => return self.move_to(target, text(&value), behind),
        };
        let [a, b] = operands;
        self.function(kind, vec![("IN1", a), ("IN2", b)], target, behind);
    }

    /// Stores a number behind some contacts.
    pub fn move_to(&mut self, target: VarId, text: EcoString, behind: Vec<Contact>) {
        self.function("MOVE", vec![("IN", text)], target, behind);
    }

    /// Stores what a function makes of its inputs, behind some contacts.
    fn function(
        &mut self,
        kind: &'static str,
        inputs: Vec<(&'static str, EcoString)>,
        target: VarId,
        behind: Vec<Contact>,
    ) {
        let items = self.items(behind.into_iter().map(Factor::Contact).collect());
        let outputs = vec![("ENO", Sink::Rail), ("OUT", Sink::Variable(self.name(target)))];
        self.rung(items, End::Block(BlockCall { kind, instance: None, power: "EN", inputs, outputs }));
    }

    /// A division under the guards that it needs.
    pub fn divide(&mut self, division: &Division, guard: Option<&Contact>) {
        let Division { target, modulo, dividend: a, divisor: b, flag, .. } = *division;
        let (ty, result) = (self.program.pool.ty(b), self.program.variables[target].ty);
        let needed = self.program.guard(division);
        let behind =
            |more: &[&Contact]| -> Vec<Contact> { guard.into_iter().chain(more.iter().copied()).cloned().collect() };
        let [dividend, divisor] = [a, b].map(|id| self.text(id));
        if needed == Guard::Never {
            self.move_to(target, zero(result), behind(&[]));
            let items = self.items(behind(&[]).into_iter().map(Factor::Contact).collect());
            return self.coil(items, &self.name(flag), Storage::Set);
        }
        let by_zero = self.comparison(Comparison::Equal, [divisor.clone(), zero(ty)]);
        let items = self.items(behind(&[&by_zero]).into_iter().map(Factor::Contact).collect());
        self.coil(items, &self.name(flag), Storage::Set);
        let by_minus_one = needed.by_minus_one().map(|quotient| {
            let divisor = [divisor.clone(), literal(Value::Int(-1), ty)];
            (self.comparison(Comparison::Equal, divisor), quotient)
        });
        // Each of the quotients is stored behind contacts that exclude the others, and were found before.
        self.move_to(target, zero(result), behind(&[&by_zero]));
        let mut others = vec![by_zero.inverse()];
        if let Some((by_minus_one, quotient)) = by_minus_one {
            let behind = behind(&[&by_minus_one]);
            match quotient {
                ByMinusOne::Zero => self.move_to(target, zero(result), behind),
                // MATIEC computes with constants, and refuses the difference.
                ByMinusOne::Dividend => self.move_to(target, dividend.clone(), behind),
                ByMinusOne::Negative => {
                    let operands = vec![("IN1", zero(result)), ("IN2", dividend.clone())];
                    self.function("SUB", operands, target, behind);
                }
            }
            others.push(by_minus_one.inverse());
        }
        let others: Vec<&Contact> = others.iter().collect();
        let kind = if modulo { "MOD" } else { "DIV" };
        self.function(kind, vec![("IN1", dividend), ("IN2", divisor)], target, behind(&others));
    }
}
