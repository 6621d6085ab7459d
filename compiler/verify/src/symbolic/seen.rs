//! What a formula is, once it stands for all states.

use biodivine_lib_bdd::Bdd;
use grafc_formula::{TimerId, VarId};

/// What a formula is, as a function.
#[derive(Clone, Debug)]
pub(crate) enum Seen {
    /// A truth.
    Truth(Bdd),
    /// A whole number, the lowest bit first, the last one its sign.
    Number(Vec<Bdd>),
    /// A real number that is known.
    Real(f64),
    /// What is given for an input that is a number.
    Given(VarId),
    /// For how long a timer has run.
    Elapsed(TimerId),
}
