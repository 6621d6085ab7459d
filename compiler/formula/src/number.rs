//! Arithmetic as the types define it: whole numbers wrap around at their width, a `real` is rounded to single after each
//! operation, a time is a whole number of milliseconds.

use grafc_model::chart::{Arithmetic, Comparison, Type, Value};

/// `-a`.
pub fn negate(ty: Type, a: Value) -> Value {
    match a {
        Value::Int(n) => Value::Int(wrap(ty, -i128::from(n))),
        Value::Real(x) => Value::Real(-x),
        Value::Time(n) => Value::Time(n.wrapping_neg()),
        Value::Bool(b) => Value::Bool(b),
    }
}

/// What is left of a number in a variable of the type.
fn wrap(ty: Type, n: i128) -> i64 {
    match ty {
        Type::Int => i64::from(n as i16),
        Type::Uint => i64::from(n as u16),
        Type::Dint => i64::from(n as i32),
        Type::Udint => i64::from(n as u32),
        Type::Bool | Type::Real | Type::Lreal | Type::Time => n as i64,
    }
}

fn round(ty: Type, x: f64) -> Value {
    Value::Real(if ty == Type::Real { f64::from(x as f32) } else { x })
}

/// A time or a whole number as it is.
fn whole(value: Value) -> i128 {
    match value {
        Value::Int(n) | Value::Time(n) => i128::from(n),
        Value::Bool(_) | Value::Real(_) => 0,
    }
}

/// Whether a comparison of two values of one type holds.
pub fn compare(op: Comparison, a: Value, b: Value) -> bool {
    let order = match (a, b) {
        (Value::Real(a), Value::Real(b)) => a.partial_cmp(&b),
        _ => Some(whole(a).cmp(&whole(b))),
    };
    match op {
        Comparison::Equal => order.is_some_and(|o| o.is_eq()),
        Comparison::NotEqual => order.is_none_or(|o| o.is_ne()),
        Comparison::Less => order.is_some_and(|o| o.is_lt()),
        Comparison::LessEqual => order.is_some_and(|o| o.is_le()),
        Comparison::Greater => order.is_some_and(|o| o.is_gt()),
        Comparison::GreaterEqual => order.is_some_and(|o| o.is_ge()),
    }
}

/// The result of an operation in a type; of a division by zero, zero.
pub fn arithmetic(op: Arithmetic, ty: Type, a: Value, b: Value) -> Value {
    if let (Value::Real(a), Value::Real(b)) = (a, b) {
        return round(
            ty,
            match op {
                Arithmetic::Add => a + b,
                Arithmetic::Subtract => a - b,
                Arithmetic::Multiply => a * b,
                Arithmetic::Divide => a / b,
                Arithmetic::Modulo => a % b,
            },
        );
    }
    let (a, b) = (whole(a), whole(b));
    let result = match op {
        Arithmetic::Add => a + b,
        Arithmetic::Subtract => a - b,
        Arithmetic::Multiply => a * b,
        Arithmetic::Divide => a.checked_div(b).unwrap_or(0),
        Arithmetic::Modulo => a.checked_rem(b).unwrap_or(0),
    };
    if ty == Type::Time { Value::Time(result as i64) } else { Value::Int(wrap(ty, result)) }
}

/// A quotient or a remainder; none where the divisor is zero.
pub fn divide(ty: Type, modulo: bool, a: Value, b: Value) -> Option<Value> {
    let op = if modulo { Arithmetic::Modulo } else { Arithmetic::Divide };
    (!is_zero(b)).then(|| arithmetic(op, ty, a, b))
}

/// Whether a value is a divisor that gives no quotient.
pub fn is_zero(value: Value) -> bool {
    match value {
        Value::Int(n) | Value::Time(n) => n == 0,
        Value::Real(x) => x == 0.0,
        Value::Bool(_) => true,
    }
}

/// The initial value of a type (IEC 60848, 4.8.3).
pub fn zero(ty: Type) -> Value {
    match ty {
        Type::Bool => Value::Bool(false),
        Type::Int | Type::Dint | Type::Uint | Type::Udint => Value::Int(0),
        Type::Real | Type::Lreal => Value::Real(0.0),
        Type::Time => Value::Time(0),
    }
}
