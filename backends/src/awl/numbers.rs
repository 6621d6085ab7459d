//! Numbers and times in the accumulators.
//!
//! | type | in memory | loaded | computed |
//! | --- | --- | --- | --- |
//! | `int` | INT | 16 bits, with zeros above | `+I -I *I`; quotients with 32 bits |
//! | `uint` | WORD | 16 bits, with zeros above, so the same number with 32 | `+D -D *I /D MOD`, of which 16 bits are stored |
//! | `dint`, `time` | DINT, TIME | 32 bits | `+D -D *D /D MOD` |
//! | `udint` | DWORD | 32 bits | the same; compared with the highest bit turned round; quotients by [`super::division`] |
//! | `real` | REAL | 32 bits | `+R -R *R /R` |
//!
//! Sums, differences and products wrap around, as their lowest bits do not depend on signs. `<>R` is false of what is no number, so it is `==R` and `NOT`.

use super::code::Code;
use super::{AwlNames, local};
use ecow::{EcoString, eco_format};
use grafc_formula::{Arithmetic, Comparison, Formula, FormulaId, Type, Value};
use grafc_logic::scan::{Program, VarId};

/// What turns unsigned numbers into signed ones of the same order.
pub(super) const HIGHEST_BIT: &str = "DW#16#80000000";

/// How numbers of one program are loaded.
#[derive(Clone, Copy)]
pub(super) struct Numbers<'p> {
    pub(super) program: &'p Program,
}

impl<'p> Numbers<'p> {
    /// The numbers of a program.
    pub fn new(program: &'p Program) -> Self {
        Numbers { program }
    }

    pub(super) fn ty(self, id: FormulaId) -> Type {
        self.program.pool.ty(id)
    }

    /// Stores the value of a formula.
    pub fn assign(self, code: &mut Code, names: &mut AwlNames, target: VarId, id: FormulaId) {
        let to = names.variable(target);
        match self.program.pool.get(id) {
            Formula::Arithmetic(op @ (Arithmetic::Divide | Arithmetic::Modulo), [a, b]) => {
                self.quotient(code, names, *op == Arithmetic::Modulo, *a, *b, self.ty(id));
            }
            Formula::Arithmetic(op, [a, b]) => self.arithmetic(code, names, *op, *a, *b, self.ty(id)),
            Formula::Negate(a) => {
                self.load(code, names, *a);
                code.number(of_width(self.ty(id), ["NEGI", "NEGD", "NEGR"]), "");
            }
            Formula::Constant(_) if code.known == Some(id) => {}
            Formula::Constant(_) => {
                self.load(code, names, id);
                code.known = Some(id);
            }
            Formula::Variable(_)
            | Formula::TimerDone(_)
            | Formula::TimerElapsed(_)
            | Formula::Not(_)
            | Formula::And(_)
            | Formula::Or(_)
            | Formula::Xor(..)
            | Formula::Compare(..)
            | Formula::Widen(_) => self.load(code, names, id),
        }
        code.instruction("T", &to);
    }

    /// Loads a constant, a variable, a timer's time, or one of them converted.
    pub(super) fn load(self, code: &mut Code, names: &AwlNames, id: FormulaId) {
        let pool = &self.program.pool;
        match pool.get(id) {
            Formula::Constant(value) => code.number("L", &literal(*value, pool.ty(id))),
            Formula::Variable(v) => code.number("L", &names.variable(*v)),
            Formula::TimerElapsed(timer) => code.number("L", &local(&names.timers[*timer].elapsed)),
            Formula::Widen(a) => {
                self.load(code, names, *a);
                let (from, to) = (pool.ty(*a), pool.ty(id));
                if from == Type::Int {
                    code.number("ITD", "");
                }
                if to == Type::Real && from != Type::Real {
                    code.number("DTR", "");
                }
            }
            // None of them is a number that stands alone.
            Formula::TimerDone(_)
            | Formula::Not(_)
            | Formula::And(_)
            | Formula::Or(_)
            | Formula::Xor(..)
            | Formula::Compare(..)
            | Formula::Arithmetic(..)
            | Formula::Negate(_) => {}
        }
    }

    /// Loads a number with 32 bits.
    pub(super) fn load_long(self, code: &mut Code, names: &AwlNames, id: FormulaId) {
        match (self.ty(id), self.program.pool.as_constant(id)) {
            (Type::Int, Some(Value::Int(n))) => code.number("L", &long(n)),
            (Type::Int, _) => {
                self.load(code, names, id);
                code.number("ITD", "");
            }
            (Type::Bool | Type::Dint | Type::Uint | Type::Udint | Type::Real | Type::Lreal | Type::Time, _) => {
                self.load(code, names, id);
            }
        }
    }

    /// A sum, a difference or a product.
    fn arithmetic(self, code: &mut Code, names: &AwlNames, op: Arithmetic, a: FormulaId, b: FormulaId, ty: Type) {
        let operators = match op {
            Arithmetic::Add => ["+I", "+D", "+R"],
            Arithmetic::Subtract => ["-I", "-D", "-R"],
            Arithmetic::Multiply | Arithmetic::Divide | Arithmetic::Modulo => ["*I", "*D", "*R"],
        };
        if matches!(ty, Type::Int | Type::Uint) {
            self.load(code, names, a);
            self.load(code, names, b);
        } else {
            self.load_long(code, names, a);
            self.load_long(code, names, b);
        }
        code.number(of_width(ty, operators), "");
    }

    /// Loads a number without sign as one with sign of the same order.
    pub(super) fn load_turned(self, code: &mut Code, names: &AwlNames, id: FormulaId) {
        match self.program.pool.as_constant(id) {
            Some(Value::Int(n)) => code.number("L", &long(i64::from(n as i32 ^ i32::MIN))),
            _ => {
                self.load(code, names, id);
                code.number("XOD", HIGHEST_BIT);
            }
        }
    }

    /// Compares two numbers of one type; the opposite of what is asked, if `negated`.
    pub fn compare(self, code: &mut Code, names: &AwlNames, op: Comparison, a: FormulaId, b: FormulaId, negated: bool) {
        let ty = self.ty(a);
        let ordered = !matches!(op, Comparison::Equal | Comparison::NotEqual);
        if ty == Type::Udint && ordered {
            self.load_turned(code, names, a);
            self.load_turned(code, names, b);
        } else {
            self.load(code, names, a);
            self.load(code, names, b);
        }
        let suffix = match ty {
            Type::Int => "I",
            Type::Real | Type::Lreal => "R",
            Type::Bool | Type::Dint | Type::Uint | Type::Udint | Type::Time => "D",
        };
        // What is no number is neither less nor not less.
        let unsure = suffix == "R";
        let (op, not) = match (op, unsure) {
            (Comparison::NotEqual, true) => (Comparison::Equal, !negated),
            (_, true) => (op, negated),
            (_, false) if negated => (op.opposite(), false),
            (_, false) => (op, false),
        };
        code.comparison(&format!("{}{suffix}", symbol(op)));
        if not {
            code.bit("NOT", "");
        }
    }
}

/// The operator for 16 bits, for 32, or for reals.
pub(super) fn of_width(ty: Type, operators: [&'static str; 3]) -> &'static str {
    let [short, long, real] = operators;
    match ty {
        // Of a number without sign, 16 bits of a sum are the same.
        Type::Int | Type::Uint => short,
        Type::Bool | Type::Dint | Type::Udint | Type::Time => long,
        Type::Real | Type::Lreal => real,
    }
}

fn symbol(op: Comparison) -> &'static str {
    match op {
        Comparison::Equal => "==",
        Comparison::NotEqual => "<>",
        Comparison::Less => "<",
        Comparison::LessEqual => "<=",
        Comparison::Greater => ">",
        Comparison::GreaterEqual => ">=",
    }
}

/// A constant of 32 bits with sign.
pub(super) fn long(n: i64) -> EcoString {
    eco_format!("L#{n}")
}

/// The zero of a type.
pub(super) fn zero(ty: Type) -> &'static str {
    match ty {
        Type::Bool => "FALSE",
        Type::Int => "0",
        Type::Dint | Type::Uint | Type::Udint | Type::Time => "L#0",
        Type::Real | Type::Lreal => "0.0",
    }
}

/// A constant as an operand of `L`.
pub(super) fn literal(value: Value, ty: Type) -> EcoString {
    match (value, ty) {
        (Value::Bool(true), _) => "TRUE".into(),
        (Value::Bool(false), _) => "FALSE".into(),
        (Value::Int(n), Type::Int) => eco_format!("{n}"),
        (Value::Int(n), Type::Udint) => long(i64::from(n as i32)),
        (Value::Int(n), Type::Dint | Type::Uint | Type::Bool | Type::Time) => long(n),
        (Value::Time(ms), _) => long(ms),
        (Value::Int(_) | Value::Real(_), _) => crate::iec::literals::initial(value, ty),
    }
}
