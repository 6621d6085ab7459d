//! Messages as text: for people, for scripts, and for code-scanning tools.
//!
//! Pure functions from a [`SourceMap`] and [`Diagnostics`] to a string. They take the messages in the order given,
//! and print all of them. A span that does not fit its text is cut to fit: rendering never fails, because a message
//! that cannot be shown is worse than one whose underline is short.
//!
//! What other programs read, JSON and SARIF, is there with the feature `json` alone.

mod excerpt;
mod human;
#[cfg(feature = "json")]
mod json;
#[cfg(feature = "json")]
mod sarif;
mod summary;

pub use human::human;
#[cfg(feature = "json")]
pub use json::json;
#[cfg(feature = "json")]
pub use sarif::sarif;
pub use summary::{grouped, summary};

#[cfg(doc)]
use crate::{Diagnostics, SourceMap};
