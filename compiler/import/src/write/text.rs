//! Terms as text: conditions, in which a comparison opens brackets, and values behind `:=`.
//!
//! Parentheses are written where the grammar needs them. The walk has its own stack, and ends where the text is full.

use super::terms::{Amount, TermId, TermKind, Terms, VarId};
use crate::naming::spell;
use index_vec::IndexVec;

/// A text that does not grow without end.
pub struct Text {
    pub out: String,
    limit: usize,
}

impl Text {
    /// An empty text that may become so long.
    pub fn new(limit: usize) -> Self {
        Text { out: String::new(), limit }
    }

    pub fn push(&mut self, text: &str) {
        if !self.is_full() {
            self.out.push_str(text);
        }
    }

    pub fn is_full(&self) -> bool {
        self.out.len() > self.limit
    }
}

/// How tightly a term must hold together where it stands.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Binding {
    Or,
    Xor,
    And,
    Comparison,
    Sum,
    Product,
    Unary,
    Operand,
    Delay,
}

/// Whether a term stands among conditions or in arithmetic.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Use {
    Condition,
    Value,
}

enum Task {
    Term(TermId, Use, Binding),
    Text(&'static str),
    Owned(String),
}

/// What names are.
pub struct Spelling<'a> {
    pub terms: &'a Terms,
    pub variables: &'a IndexVec<VarId, String>,
    pub labels: &'a IndexVec<super::terms::StepId, String>,
    /// The grafcets of all parts, and whether pulse orders are given to them.
    pub grafcets: &'a [(String, bool)],
}

impl Spelling<'_> {
    /// Writes a term.
    pub fn term(&self, text: &mut Text, id: TermId, usage: Use) {
        let mut tasks = vec![Task::Term(id, usage, Binding::Or)];
        while let Some(task) = tasks.pop() {
            if text.is_full() {
                return;
            }
            match task {
                Task::Text(piece) => text.push(piece),
                Task::Owned(piece) => text.push(&piece),
                Task::Term(id, usage, level) => self.part(text, id, usage, level, &mut tasks),
            }
        }
    }

    /// Writes what stands before the operands, and leaves the rest as tasks, the last first.
    fn part(&self, text: &mut Text, id: TermId, usage: Use, level: Binding, tasks: &mut Vec<Task>) {
        let pair = |text: &mut Text, tasks: &mut Vec<Task>, own: Binding, sign: &'static str, a: TermId, b: TermId| {
            let right = if matches!(sign, " - " | " / " | " mod ") { next(own) } else { own };
            tasks.extend(open(text, own < level).map(Task::Text));
            tasks.push(Task::Term(b, usage, right));
            tasks.push(Task::Text(sign));
            tasks.push(Task::Term(a, usage, own));
        };
        match &self.terms.terms[id].kind {
            TermKind::Bool(value) => {
                let close = open(text, level >= Binding::Operand && usage == Use::Condition);
                text.push(match (usage, value) {
                    (Use::Condition, true) => "1",
                    (Use::Condition, false) => "0",
                    (Use::Value, true) => "true",
                    (Use::Value, false) => "false",
                });
                text.push(close.unwrap_or_default());
            }
            TermKind::Integer(number) => self.number(text, &number.to_string(), level),
            TermKind::Real(number) => self.number(text, number, level),
            TermKind::Duration(ms) => text.push(&duration(*ms)),
            TermKind::Variable(id) => text.push(&spell(&self.variables[*id])),
            TermKind::Active(step) => text.push(&spell(&format!("X{}", self.labels[*step]))),
            TermKind::Time(step) => text.push(&spell(&format!("T{}", self.labels[*step]))),
            TermKind::ChildActive(part) => text.push(&spell(&format!("X{}", self.grafcets[*part].0))),
            // What nobody freezes is not frozen, and has no such flag.
            TermKind::ChildFrozen(part) => match (&self.grafcets[*part], usage) {
                ((name, true), _) => text.push(&spell(&format!("F{name}"))),
                ((_, false), Use::Condition) => text.push("(0)"),
                ((_, false), Use::Value) => text.push("false"),
            },
            TermKind::Or(a, b) => pair(text, tasks, Binding::Or, " or ", *a, *b),
            TermKind::Xor(a, b) => pair(text, tasks, Binding::Xor, " xor ", *a, *b),
            TermKind::And(a, b) => pair(text, tasks, Binding::And, " and ", *a, *b),
            TermKind::Pair(sign @ (" + " | " - "), a, b) => pair(text, tasks, Binding::Sum, sign, *a, *b),
            TermKind::Pair(sign @ (" * " | " / " | " mod "), a, b) => pair(text, tasks, Binding::Product, sign, *a, *b),
            TermKind::Pair(sign, a, b) => {
                let close = match usage {
                    Use::Condition if level == Binding::Delay => {
                        text.push("([");
                        Some("])")
                    }
                    Use::Condition => {
                        text.push("[");
                        Some("]")
                    }
                    Use::Value => open(text, Binding::Comparison < level),
                };
                tasks.extend(close.map(Task::Text));
                tasks.push(Task::Term(*b, Use::Value, Binding::Sum));
                tasks.push(Task::Text(sign));
                tasks.push(Task::Term(*a, Use::Value, Binding::Sum));
            }
            TermKind::Not(a) => {
                tasks.extend(open(text, Binding::Unary < level).map(Task::Text));
                text.push("not ");
                tasks.push(Task::Term(*a, usage, Binding::Unary));
            }
            TermKind::Negate(a) => {
                tasks.extend(open(text, Binding::Unary < level).map(Task::Text));
                text.push("-");
                tasks.push(Task::Term(*a, usage, Binding::Operand));
            }
            kind @ (TermKind::Rise(a) | TermKind::Fall(a)) => {
                tasks.extend(open(text, Binding::Unary < level).map(Task::Text));
                text.push(if matches!(kind, TermKind::Rise(_)) { "↑" } else { "↓" });
                tasks.push(Task::Term(*a, usage, Binding::Operand));
            }
            TermKind::Delay { on, operand, off } => {
                tasks.extend(open(text, Binding::Unary < level).map(Task::Text));
                if let Some(on) = on {
                    text.push(&self.amount(on));
                    text.push("/");
                }
                if let Some(off) = off {
                    tasks.push(Task::Owned(format!("/{}", self.amount(off))));
                }
                tasks.push(Task::Term(*operand, Use::Condition, Binding::Delay));
            }
        }
    }

    fn number(&self, text: &mut Text, number: &str, level: Binding) {
        let close = open(text, number.starts_with('-') && level >= Binding::Product);
        text.push(number);
        text.push(close.unwrap_or_default());
    }

    fn amount(&self, amount: &Amount) -> String {
        match amount {
            Amount::Ms(ms) => duration(*ms),
            Amount::Constant(id) => spell(&self.variables[*id]),
        }
    }
}

fn open(text: &mut Text, needed: bool) -> Option<&'static str> {
    if needed {
        text.push("(");
    }
    needed.then_some(")")
}

/// The level that holds together more tightly.
fn next(binding: Binding) -> Binding {
    if binding == Binding::Sum { Binding::Product } else { Binding::Unary }
}

/// A duration, in the largest unit in which it is a whole number.
pub fn duration(ms: u64) -> String {
    match ms {
        0 => "0s".into(),
        _ if ms % 1_000 == 0 => format!("{}s", ms / 1_000),
        _ => format!("{ms}ms"),
    }
}
