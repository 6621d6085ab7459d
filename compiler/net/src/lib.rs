//! The Petri net of a chart, and the passes that flatten it.
//!
//! ```text
//! checked chart ─ build ─▶ Net ─ passes::ORDER ─▶ flat Net
//! ```
//!
//! [`build()`] translates and decides nothing; each pass removes one construct and says so with a [`Fact`];
//! [`verify()`] checks the invariants of [`net`] and every fact, after each pass in tests and debug builds.

mod arcs;
mod build;
mod dump;
mod labels;
pub mod net;
pub mod passes;
mod verify;

pub use arcs::Arcs;
pub use build::{build, into_net};
pub use dump::dump;
pub use labels::Labels;
pub use net::{Fact, Net};
pub use verify::verify;
