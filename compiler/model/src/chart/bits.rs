//! Values in tables that have the type beside them.

use super::{Type, Value};

/// A value without its type: a word, where a [`Value`] takes two. A chart has many variables, and several stages a table of
/// them.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug)]
pub struct Bits(u64);

impl Bits {
    /// Those of a value of this type.
    pub fn of(value: Value, ty: Type) -> Bits {
        let bits = Bits(match value {
            Value::Bool(b) => u64::from(b),
            Value::Int(n) | Value::Time(n) => n as u64,
            Value::Real(x) => x.to_bits(),
        });
        debug_assert!(bits.value(ty) == value, "{value:?} is no {ty:?}");
        bits
    }

    /// The value of this type that they stand for; the type must be the one that they were made with.
    pub fn value(self, ty: Type) -> Value {
        match ty {
            Type::Bool => Value::Bool(self.0 != 0),
            Type::Int | Type::Dint | Type::Uint | Type::Udint => Value::Int(self.0 as i64),
            Type::Real | Type::Lreal => Value::Real(f64::from_bits(self.0)),
            Type::Time => Value::Time(self.0 as i64),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_value_comes_back() {
        for (value, ty) in [
            (Value::Bool(true), Type::Bool),
            (Value::Bool(false), Type::Bool),
            (Value::Int(-32768), Type::Int),
            (Value::Int(4_294_967_295), Type::Udint),
            (Value::Real(-0.1), Type::Lreal),
            (Value::Real(f64::NAN), Type::Real),
            (Value::Time(i64::MIN), Type::Time),
        ] {
            assert_eq!(Bits::of(value, ty).value(ty), value);
        }
    }
}
