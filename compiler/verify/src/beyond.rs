//! What cannot be followed, in words.

use std::fmt;

/// What cannot be followed.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Beyond {
    /// A number that is given is stored or calculated with: there are too many of them to try each.
    Input(String),
    /// The time that a step has been active is used otherwise than in a comparison with a constant.
    Duration(String),
    /// A real number counts where numbers are whole.
    Real(String),
}

impl fmt::Display for Beyond {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Beyond::Input(name) => {
                write!(f, "the number `{name}` is stored or calculated with, not only compared with what is known")
            }
            Beyond::Real(name) => write!(f, "`{name}` is a real number, and a circuit has whole numbers alone"),
            Beyond::Duration(name) => write!(f, "the duration `{name}` is not only compared with constants"),
        }
    }
}
