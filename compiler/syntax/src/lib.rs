//! The `.gct` language: text to syntax tree, and back in canonical form.
//!
//! ```text
//! text ─ lexer ─▶ tokens ─ items ─▶ items ─ grammar.lalrpop ─▶ ast::Chart
//! ast::Chart ─ format ─▶ text
//! ```

pub mod ast;
mod builder;
pub mod dump;
mod expected;
mod format;
mod items;
mod lexer;
mod numeral;
mod same;

lalrpop_util::lalrpop_mod!(
    #[allow(clippy::all, missing_docs, unused)]
    grammar
);

pub use dump::dump;
pub use format::format;
pub use items::parse;
