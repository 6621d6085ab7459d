//! Messages as text: for people, for scripts, and for code-scanning tools.
//!
//! Pure functions from a [`SourceMap`] and [`Diagnostics`] to a string. They take the messages in the order given,
//! and print all of them. A span that does not fit its text is cut to fit: rendering never fails, because a message
//! that cannot be shown is worse than one whose underline is short.

mod excerpt;
mod human;
mod json;
mod sarif;

pub use human::human;
pub use json::json;
pub use sarif::sarif;

#[cfg(doc)]
use crate::{Diagnostics, SourceMap};
