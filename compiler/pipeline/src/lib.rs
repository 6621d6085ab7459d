//! The grafc compiler as a library: the [`pipeline`] through all stages, and [`Build`] for build scripts.
//!
//! Only [`Build`] and [`files`] read and write files, and print. All else is functions of their arguments alone.

mod build_script;
pub mod fault;
pub mod files;
mod header;
pub mod pipeline;
mod sources;

pub use build_script::{Build, BuildError};
pub use grafc_backends::rust::Runtime;
pub use grafc_logic::Encoding;
pub use grafc_model::reaction::Evolution;
pub use header::header;
pub use sources::add;
