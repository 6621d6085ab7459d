//! What types are in languages whose numbers are those of the machine.

use ecow::{EcoString, eco_format};
use grafc_formula::Type;

/// The bytes of a type; its address is a multiple of them.
pub(crate) fn size(ty: Type) -> usize {
    match ty {
        Type::Bool => 1,
        Type::Int | Type::Uint => 2,
        Type::Dint | Type::Udint | Type::Real => 4,
        Type::Lreal | Type::Time => 8,
    }
}

/// The shortest form that is read back as the same number of the type.
pub(crate) fn shortest(x: f64, ty: Type) -> EcoString {
    match ty {
        Type::Real => eco_format!("{:?}", x as f32),
        Type::Bool | Type::Int | Type::Dint | Type::Uint | Type::Udint | Type::Lreal | Type::Time => {
            eco_format!("{x:?}")
        }
    }
}
