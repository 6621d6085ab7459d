//! The `.gct` language: text to syntax tree, and back in canonical form.
//!
//! ```text
//! text ─ lexer ─▶ tokens ─ items ─▶ items ─ grammar.lalrpop ─▶ ast::Chart
//! ast::Chart ─ format ─▶ text
//! ```

pub mod ast;
mod automaton;
mod builder;
mod characters;
mod context;
pub mod dump;
mod expected;
mod faults;
mod format;
pub mod habits;
mod items;
mod lexer;
pub mod literal;
mod numeral;
mod pasted;
mod repeated;
mod same;
mod scenario;
mod shown;
pub mod spelling;
mod token;

/// The parser's tables, made by LALRPOP of `grammar.lalrpop`. They are kept, and not made in each build, so that who
/// compiles grafc does not compile LALRPOP; `tests/grammar.rs` sees to it that they are up to date.
#[allow(clippy::all, missing_docs, unused)]
mod grammar {
    include!("../generated/grammar.rs");
}

pub use dump::dump;
pub use format::format;
pub use items::parse;
pub use same::same;
