//! Numbers: wrap-around at the declared width, single precision where declared, and a value for every division.

use crate::chart::{Arithmetic, Comparison, Type, Value};

/// The value as a condition; the checked chart has Booleans only where one is asked for.
pub(super) fn truth(value: Value) -> bool {
    match value {
        Value::Bool(b) => b,
        Value::Int(i) | Value::Time(i) => i != 0,
        Value::Real(r) => r != 0.0,
    }
}

fn integer(value: Value) -> i64 {
    match value {
        Value::Bool(b) => i64::from(b),
        Value::Int(i) | Value::Time(i) => i,
        Value::Real(r) => r as i64,
    }
}

fn real(value: Value) -> f64 {
    match value {
        Value::Bool(b) => f64::from(u8::from(b)),
        Value::Int(i) | Value::Time(i) => i as f64,
        Value::Real(r) => r,
    }
}

/// The value of the type that this whole number wraps around to.
fn wrap(ty: Type, number: i64) -> Value {
    match ty {
        Type::Bool => Value::Bool(number != 0),
        Type::Int => Value::Int(i64::from(number as i16)),
        Type::Dint => Value::Int(i64::from(number as i32)),
        Type::Uint => Value::Int(i64::from(number as u16)),
        Type::Udint => Value::Int(i64::from(number as u32)),
        Type::Real => Value::Real(f64::from(number as f32)),
        Type::Lreal => Value::Real(number as f64),
        Type::Time => Value::Time(number),
    }
}

/// The value as one of the type: the identity on values of the type, a conversion without loss on values to widen.
pub(super) fn convert(ty: Type, value: Value) -> Value {
    match ty {
        Type::Bool => Value::Bool(truth(value)),
        Type::Int | Type::Dint | Type::Uint | Type::Udint | Type::Time => wrap(ty, integer(value)),
        Type::Real => Value::Real(f64::from(real(value) as f32)),
        Type::Lreal => Value::Real(real(value)),
    }
}

/// `-e`
pub(super) fn negate(ty: Type, value: Value) -> Value {
    match ty {
        Type::Bool | Type::Int | Type::Dint | Type::Uint | Type::Udint | Type::Time => {
            wrap(ty, integer(value).wrapping_neg())
        }
        Type::Real | Type::Lreal => Value::Real(-real(value)),
    }
}

/// `a op b`. Division by zero gives 0 and sets `div0`.
pub(super) fn calculate(op: Arithmetic, ty: Type, a: Value, b: Value, div0: &mut bool) -> Value {
    match ty {
        Type::Bool | Type::Int | Type::Dint | Type::Uint | Type::Udint | Type::Time => {
            wrap(ty, whole(op, integer(a), integer(b), div0))
        }
        Type::Real => {
            // Two singles give the single nearest to their exact sum, product or quotient: one rounding an operation.
            let (a, b) = (real(a) as f32, real(b) as f32);
            let result = match op {
                Arithmetic::Add => a + b,
                Arithmetic::Subtract => a - b,
                Arithmetic::Multiply => a * b,
                Arithmetic::Divide | Arithmetic::Modulo if b == 0.0 => raise(div0, 0.0),
                Arithmetic::Divide => a / b,
                Arithmetic::Modulo => a % b,
            };
            Value::Real(f64::from(result))
        }
        Type::Lreal => {
            let (a, b) = (real(a), real(b));
            Value::Real(match op {
                Arithmetic::Add => a + b,
                Arithmetic::Subtract => a - b,
                Arithmetic::Multiply => a * b,
                Arithmetic::Divide | Arithmetic::Modulo if b == 0.0 => raise(div0, 0.0),
                Arithmetic::Divide => a / b,
                Arithmetic::Modulo => a % b,
            })
        }
    }
}

/// In 64 bits, whose low bits are right for every narrower width; the smallest number divided by -1 wraps around.
fn whole(op: Arithmetic, a: i64, b: i64, div0: &mut bool) -> i64 {
    match op {
        Arithmetic::Add => a.wrapping_add(b),
        Arithmetic::Subtract => a.wrapping_sub(b),
        Arithmetic::Multiply => a.wrapping_mul(b),
        Arithmetic::Divide | Arithmetic::Modulo if b == 0 => raise(div0, 0),
        Arithmetic::Divide => a.wrapping_div(b),
        Arithmetic::Modulo => a.wrapping_rem(b),
    }
}

fn raise<T>(div0: &mut bool, result: T) -> T {
    *div0 = true;
    result
}

/// `a op b`; both have one type.
pub(super) fn compare(op: Comparison, a: Value, b: Value) -> bool {
    match (a, b) {
        (Value::Real(_), _) | (_, Value::Real(_)) => holds(op, &real(a), &real(b)),
        (Value::Bool(_) | Value::Int(_) | Value::Time(_), Value::Bool(_) | Value::Int(_) | Value::Time(_)) => {
            holds(op, &integer(a), &integer(b))
        }
    }
}

fn holds<T: PartialOrd>(op: Comparison, a: &T, b: &T) -> bool {
    match op {
        Comparison::Equal => a == b,
        Comparison::NotEqual => a != b,
        Comparison::Less => a < b,
        Comparison::LessEqual => a <= b,
        Comparison::Greater => a > b,
        Comparison::GreaterEqual => a >= b,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use Arithmetic::{Add, Divide, Modulo, Multiply, Subtract};

    fn int(op: Arithmetic, ty: Type, a: i64, b: i64) -> (Value, bool) {
        let mut div0 = false;
        (calculate(op, ty, Value::Int(a), Value::Int(b), &mut div0), div0)
    }

    fn float(op: Arithmetic, ty: Type, a: f64, b: f64) -> (Value, bool) {
        let mut div0 = false;
        (calculate(op, ty, Value::Real(a), Value::Real(b), &mut div0), div0)
    }

    #[test]
    fn whole_numbers_wrap_at_their_width() {
        assert_eq!(int(Add, Type::Int, 32767, 1), (Value::Int(-32768), false));
        assert_eq!(int(Add, Type::Dint, 2147483647, 1), (Value::Int(-2147483648), false));
        assert_eq!(int(Subtract, Type::Uint, 0, 1), (Value::Int(65535), false));
        assert_eq!(int(Subtract, Type::Udint, 0, 1), (Value::Int(4294967295), false));
        assert_eq!(int(Multiply, Type::Udint, 4294967295, 4294967295), (Value::Int(1), false));
        assert_eq!(int(Multiply, Type::Int, 300, 300), (Value::Int(24464), false));
        assert_eq!(negate(Type::Int, Value::Int(-32768)), Value::Int(-32768));
        assert_eq!(negate(Type::Uint, Value::Int(1)), Value::Int(65535));
    }

    #[test]
    fn division_truncates_and_never_fails() {
        assert_eq!(int(Divide, Type::Int, -7, 2), (Value::Int(-3), false));
        assert_eq!(int(Modulo, Type::Int, -7, 2), (Value::Int(-1), false));
        assert_eq!(int(Modulo, Type::Int, 7, -2), (Value::Int(1), false));
        assert_eq!(int(Divide, Type::Int, -32768, -1), (Value::Int(-32768), false));
        assert_eq!(int(Divide, Type::Dint, -2147483648, -1), (Value::Int(-2147483648), false));
        assert_eq!(int(Modulo, Type::Dint, -2147483648, -1), (Value::Int(0), false));
        for op in [Divide, Modulo] {
            assert_eq!(int(op, Type::Dint, 7, 0), (Value::Int(0), true));
            assert_eq!(float(op, Type::Real, 7.0, 0.0), (Value::Real(0.0), true));
            assert_eq!(float(op, Type::Lreal, 7.0, -0.0), (Value::Real(0.0), true));
        }
        let mut div0 = false;
        let least = Value::Time(i64::MIN);
        assert_eq!(calculate(Divide, Type::Time, least, Value::Int(-1), &mut div0), least);
        assert!(!div0);
    }

    #[test]
    fn single_precision_rounds_after_each_operation() {
        assert_eq!(float(Add, Type::Real, 16777216.0, 1.0), (Value::Real(16777216.0), false));
        assert_eq!(float(Add, Type::Lreal, 16777216.0, 1.0), (Value::Real(16777217.0), false));
        assert_eq!(float(Divide, Type::Real, 1.0, 3.0), (Value::Real(f64::from(1.0f32 / 3.0)), false));
        assert_eq!(convert(Type::Real, Value::Real(0.1)), Value::Real(f64::from(0.1f32)));
        assert_eq!(convert(Type::Lreal, Value::Int(-3)), Value::Real(-3.0));
    }

    #[test]
    fn what_is_not_a_number_is_unequal_to_itself_but_no_change() {
        let nan = Value::Real(f64::NAN);
        assert!(!compare(Comparison::Equal, nan, nan));
        assert!(compare(Comparison::NotEqual, nan, nan));
        assert_eq!(nan, nan);
        assert_ne!(nan, Value::Real(1.0));
    }
}
