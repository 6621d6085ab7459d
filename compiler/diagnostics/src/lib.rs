//! What grafc says about a chart: places in source text, stable codes, and messages.
//!
//! Stages of the compiler return a value and [`Diagnostics`]; they never print. Only the binary renders
//! them, with [`render`].

mod code;
mod diagnostic;
mod fix;
mod lines;
pub mod render;
mod source;

pub use code::{Code, Severity};
pub use diagnostic::{Diagnostic, Diagnostics, Label};
pub use fix::{Applicability, Edit, Fix, Misfit, apply};
pub use lines::{EditorPosition, Position, Unit};
pub use source::{FileId, SourceFile, SourceMap, Span};
