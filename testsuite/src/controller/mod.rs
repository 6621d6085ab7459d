//! A small controller of IEC 61131-3, edition 2: it runs generated instruction lists and ladders where no other tool is at
//! hand, and knows no more of them than the standard.
//!
//! Here are variables, constants, operators and the timer `TON` (2.2, 2.5.1, 2.5.2.3.4); `instructions` runs lists (3.2),
//! `ladder` runs drawings (4.2). What the compiler's own evaluator computes is not asked.

pub mod instructions;
pub mod ladder;

use crate::executors::function_block::{Activity, FunctionBlock};
use crate::executors::jobs::{self, Job};
use grafc_logic::scan::{Role, VarId};
use grafc_model::chart::{Type, Value};
use grafc_model::reaction::{Response, Stimulus};
use std::collections::BTreeMap;

/// A value; what has no type yet takes that of its other operand.
type Typed = (Value, Option<Type>);

/// The variables of a function block, and its clock.
struct Memory<'b> {
    block: &'b FunctionBlock,
    variables: BTreeMap<String, (Type, Value)>,
    /// When the inputs of timers rose.
    risen: BTreeMap<String, i64>,
    now: i64,
}

impl<'b> Memory<'b> {
    fn new(block: &'b FunctionBlock) -> Self {
        let all = block.program.variables.iter_enumerated();
        let variables =
            all.map(|(id, variable)| (block.names[id].to_string(), (variable.ty, variable.initial()))).collect();
        Memory { block, variables, risen: BTreeMap::new(), now: 0 }
    }

    /// Calls the block with each stimulus; `body` is what it does.
    fn play(
        mut self,
        job: &Job,
        mut body: impl FnMut(&mut Memory) -> Result<(), String>,
    ) -> Result<Vec<Response>, String> {
        let inputs = |memory: &mut Memory, stimulus: &Stimulus| {
            let ids = memory.block.program.variables.iter_enumerated().filter(|(_, v)| v.role == Role::Input);
            for ((id, _), value) in ids.zip(&stimulus.inputs) {
                if let Some((_, variable)) = memory.variables.get_mut(memory.block.names[id].as_str()) {
                    *variable = *value;
                }
            }
        };
        let mut lines = Vec::with_capacity(job.stimuli.len());
        for stimulus in &job.stimuli {
            self.now = stimulus.t_ms;
            if stimulus.restart {
                self = self.restarted();
            }
            inputs(&mut self, stimulus);
            body(&mut self)?;
            lines.push(self.line()?);
        }
        jobs::read(job, 0, &lines.join("\n"))
    }

    /// After a warm restart, as the standard has it (2.4.2): what is declared RETAIN has kept its value.
    fn restarted(self) -> Self {
        let mut after = Memory { now: self.now, ..Memory::new(self.block) };
        for (id, _) in self.block.program.variables.iter_enumerated().filter(|(_, variable)| variable.retain) {
            let name = self.block.names[id].as_str();
            after.variables.extend(self.variables.get(name).map(|kept| (name.to_owned(), *kept)));
        }
        after
    }

    /// Outputs, activities of steps and flags, as tools print them.
    fn line(&self) -> Result<String, String> {
        let program = &self.block.program;
        let value = |id: VarId| {
            self.variables.get(self.block.names[id].as_str()).map_or(Value::Bool(false), |(_, value)| *value)
        };
        let mut values: Vec<Value> = jobs::outputs(program).map(|(id, _)| value(id)).collect();
        values.extend(self.block.activities()?.into_iter().map(|activity| match activity {
            Activity::Bit(id) => value(id),
            Activity::Value(id, wanted) => Value::Bool(value(id) == Value::Int(wanted)),
        }));
        values.extend(jobs::flags(program).map(|(id, _)| value(id)));
        let words = values.into_iter().map(|value| match value {
            Value::Bool(truth) => u8::from(truth).to_string(),
            Value::Int(number) | Value::Time(number) => number.to_string(),
            Value::Real(number) => format!("{number:?}"),
        });
        Ok(format!("0 0 {}", words.collect::<Vec<_>>().join(" ")))
    }

    /// A constant or a variable.
    fn operand(&self, text: &str) -> Result<Typed, String> {
        let number = |text: &str| text.parse::<i64>().map_err(|_| format!("`{text}` is no number"));
        let real = |text: &str| text.parse().map(Value::Real).map_err(|_| format!("`{text}` is no number"));
        if let Some((ty, value)) = self.variables.get(text) {
            return Ok((*value, Some(*ty)));
        }
        if text == "TRUE" || text == "FALSE" {
            return Ok((Value::Bool(text == "TRUE"), Some(Type::Bool)));
        }
        if let Some(time) = text.strip_prefix("T#") {
            let (digits, unit) = time.split_at(time.find(|c: char| c.is_ascii_alphabetic()).unwrap_or(time.len()));
            let unit = match unit {
                "ms" => 1,
                "s" => 1000,
                "m" => 60_000,
                "h" => 3_600_000,
                _ => return Err(format!("`{text}` is no time")),
            };
            return Ok((Value::Time(number(digits)? * unit), Some(Type::Time)));
        }
        if let Some(digits) = text.strip_prefix("REAL#") {
            return Ok((wrapped(real(digits)?, Some(Type::Real)), Some(Type::Real)));
        }
        if !text.starts_with(|c: char| c == '-' || c.is_ascii_digit()) {
            return Err(format!("`{text}` is not declared"));
        }
        if text.contains('.') { Ok((real(text)?, None)) } else { Ok((Value::Int(number(text)?), None)) }
    }

    /// Stores a value in a variable of its kind. The program does not know pins of timers and parts of formulas: they are
    /// of the kind of what is stored first.
    fn store(&mut self, name: &str, value: Value) -> Result<(), String> {
        let known = self.variables.get(name).map(|(ty, _)| *ty);
        let ty = match value {
            Value::Bool(_) => known.or(Some(Type::Bool)).filter(|ty| *ty == Type::Bool),
            Value::Int(_) => known.filter(|ty| matches!(ty, Type::Int | Type::Dint | Type::Uint | Type::Udint)),
            Value::Real(_) => known.filter(|ty| matches!(ty, Type::Real | Type::Lreal)),
            Value::Time(_) => known.or(Some(Type::Time)).filter(|ty| *ty == Type::Time),
        };
        let ty = ty.ok_or_else(|| format!("{value:?} in `{name}`, which is {known:?}"))?;
        self.variables.insert(name.to_owned(), (ty, wrapped(value, Some(ty))));
        Ok(())
    }

    /// A call of a `TON`: it counts from the call in which its input rose.
    fn call_timer(&mut self, name: &str, input: Value, preset: Value) -> Result<(), String> {
        let (Value::Bool(input), Value::Time(preset)) = (input, preset) else {
            return Err(format!("`{name}` is given {input:?} and {preset:?}"));
        };
        if !input {
            self.risen.remove(name);
        }
        let elapsed = if input { self.now - *self.risen.entry(name.to_owned()).or_insert(self.now) } else { 0 };
        self.variables.insert(format!("{name}.Q"), (Type::Bool, Value::Bool(input && elapsed >= preset)));
        self.variables.insert(format!("{name}.ET"), (Type::Time, Value::Time(elapsed.min(preset))));
        Ok(())
    }
}

/// A value of a type, after an operation that may have led out of it.
fn wrapped(value: Value, ty: Option<Type>) -> Value {
    match (value, ty) {
        (Value::Int(n), Some(Type::Int)) => Value::Int(i64::from(n as i16)),
        (Value::Int(n), Some(Type::Dint)) => Value::Int(i64::from(n as i32)),
        (Value::Int(n), Some(Type::Uint)) => Value::Int(i64::from(n as u16)),
        (Value::Int(n), Some(Type::Udint)) => Value::Int(i64::from(n as u32)),
        (Value::Real(x), Some(Type::Real)) => Value::Real(f64::from(x as f32)),
        (value, _) => value,
    }
}

/// `INT_TO_DINT` and its like.
fn converted(function: &str, (value, _): Typed) -> Result<Typed, String> {
    let unknown = || format!("`{function}` of {value:?}");
    let ty = match function.split_once("_TO_").ok_or_else(unknown)?.1 {
        "INT" => Type::Int,
        "DINT" => Type::Dint,
        "UINT" => Type::Uint,
        "UDINT" => Type::Udint,
        "REAL" => Type::Real,
        "LREAL" => Type::Lreal,
        _ => return Err(unknown()),
    };
    let value = match (value, ty) {
        (Value::Int(n), Type::Real | Type::Lreal) => Value::Real(n as f64),
        (value, _) => value,
    };
    Ok((wrapped(value, Some(ty)), Some(ty)))
}

/// What an operator makes of two operands.
fn operated(operator: &str, (a, a_type): Typed, (b, b_type): Typed) -> Result<Typed, String> {
    let wrong = || format!("{a:?} {operator} {b:?}");
    let ty = a_type.or(b_type);
    let compares: Option<fn(&f64, &f64) -> bool> = match operator {
        "EQ" => Some(f64::eq),
        "NE" => Some(f64::ne),
        "LT" => Some(f64::lt),
        "LE" => Some(f64::le),
        "GT" => Some(f64::gt),
        "GE" => Some(f64::ge),
        _ => None,
    };
    if let Some(compares) = compares {
        let (a, b) = numbers(a, b).ok_or_else(wrong)?;
        return Ok((Value::Bool(compares(&a, &b)), Some(Type::Bool)));
    }
    let value = match (operator, a, b) {
        ("AND", Value::Bool(a), Value::Bool(b)) => Value::Bool(a && b),
        ("OR", Value::Bool(a), Value::Bool(b)) => Value::Bool(a || b),
        ("XOR", Value::Bool(a), Value::Bool(b)) => Value::Bool(a != b),
        (_, Value::Int(a), Value::Int(b)) => Value::Int(integer(operator, a, b).ok_or_else(wrong)?),
        ("ADD" | "SUB", Value::Time(a), Value::Time(b)) | ("MUL" | "DIV", Value::Time(a), Value::Int(b)) => {
            Value::Time(integer(operator, a, b).ok_or_else(wrong)?)
        }
        ("ADD", Value::Real(a), Value::Real(b)) => Value::Real(a + b),
        ("SUB", Value::Real(a), Value::Real(b)) => Value::Real(a - b),
        ("MUL", Value::Real(a), Value::Real(b)) => Value::Real(a * b),
        ("DIV", Value::Real(a), Value::Real(b)) => Value::Real(a / b),
        _ => return Err(wrong()),
    };
    Ok((wrapped(value, ty), ty))
}

/// Whole numbers, right in the lower 64 bits; nothing for a division by zero, and for what is no operator.
fn integer(operator: &str, a: i64, b: i64) -> Option<i64> {
    match operator {
        "ADD" => Some(a.wrapping_add(b)),
        "SUB" => Some(a.wrapping_sub(b)),
        "MUL" => Some(a.wrapping_mul(b)),
        "DIV" => a.checked_div(b),
        "MOD" => a.checked_rem(b),
        _ => None,
    }
}

/// Two numbers of one kind, as reals: the whole ones have 32 bits, and times are far from 53.
fn numbers(a: Value, b: Value) -> Option<(f64, f64)> {
    match (a, b) {
        (Value::Int(a), Value::Int(b)) | (Value::Time(a), Value::Time(b)) => Some((a as f64, b as f64)),
        (Value::Real(a), Value::Real(b)) => Some((a, b)),
        _ => None,
    }
}
