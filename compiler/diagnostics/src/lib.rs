//! What grafc says about a chart: places in source text, stable codes, and messages.
//!
//! Stages of the compiler return a value and [`Diagnostics`]; they never print. Only the binary renders
//! them, with [`render`].

mod allow;
mod code;
mod diagnostic;
mod extract;
mod fix;
mod lines;
mod policy;
pub mod render;
mod source;

pub use allow::{Allowance, Allowances, Scope};
pub use code::{Code, Severity};
pub use diagnostic::{Allowed, Diagnostic, Diagnostics, Label};
pub use extract::Extract;
pub use fix::{Applicability, Edit, Fix, Misfit, apply};
pub use lines::{EditorPosition, Position, Unit};
pub use policy::Policy;
pub use source::{FileId, SourceFile, SourceMap, Span};
