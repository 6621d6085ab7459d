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

    /// Those of a word; of a whole number as many of its lowest bits as the type has are enough.
    pub fn of_word(word: u64) -> Bits {
        Bits(word)
    }

    /// The word that they are.
    pub fn word(self) -> u64 {
        self.0
    }

    /// The value of this type that they stand for; the type must be the one that they were made with.
    pub fn value(self, ty: Type) -> Value {
        match ty {
            Type::Bool => Value::Bool(self.0 != 0),
            Type::Int => Value::Int((self.0 as u16 as i16).into()),
            Type::Dint => Value::Int((self.0 as u32 as i32).into()),
            Type::Uint | Type::Udint => Value::Int(self.0 as i64),
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
