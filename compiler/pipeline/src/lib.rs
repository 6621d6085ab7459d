//! The grafc compiler as a library.
//!
//! - [`Build`] compiles a chart in a build script.
//! - [`compile`] and [`check`] take a text through the stages, once.
//! - [`Document`] holds a text that changes, with all that is known of it: for editors, and whatever else asks again and
//!   again.
//!
//! The stages themselves are crates of their own; those whose types are met here are re-exported.
//!
//! Only [`Build`] and [`files`] read and write files, and print. All else is functions of their arguments alone.

mod build_script;
mod compile;
mod document;
#[cfg(feature = "drawing")]
mod draw;
pub mod fault;
pub mod files;
mod format;
mod header;
mod options;
mod simulate;
mod sources;
mod stages;

pub use build_script::{Build, BuildError};
pub use compile::{check, compile};
pub use document::{Document, chart_name};
#[cfg(feature = "drawing")]
pub use draw::draw;
pub use format::format;
pub use grafc_backends::rust::Runtime;
pub use grafc_backends::{Element, Kind, Map, Output, Target};
pub use grafc_diagnostics::{Code, Policy};
pub use grafc_logic::{Encoding, Options as Lowering};
pub use grafc_model::reaction::{Evolution, LivelockOutputs};
pub use options::{Options, Product};
pub use simulate::{Ended, KeptCall, NotShown, Outcome, Record, Results, Run, Simulation, Text, known_bound, simulate};
pub use sources::add;
/// The examples of the book.
#[cfg(doctest)]
#[doc = include_str!("../../../docs/library.md")]
struct Book;

#[cfg(feature = "drawing")]
pub use grafc_drawing as drawing;
pub use {
    grafc_backends as backends, grafc_diagnostics as diagnostics, grafc_logic as logic, grafc_model as model,
    grafc_net as net, grafc_syntax as syntax,
};
