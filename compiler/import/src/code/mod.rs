//! The languages of IEC 61131-3 in which conditions and actions are written: each is read as far as charts can say the
//! same, and what is more is in its place as text.
//!
//! ```text
//! text ─ token ─▶ tokens ─ statements ─▶ pieces ─ grammar.lalrpop ─▶ tree
//! lines of an instruction list ─ il ─▶ tree
//! ```

mod builder;
pub mod il;
mod literal;
pub mod source;
pub mod statements;
pub mod token;
pub mod tree;

pub use builder::call;
pub use statements::{expression, read};

/// The parser's tables, made by LALRPOP of `grammar.lalrpop`. They are kept, and not made in each build, so that who
/// compiles grafc does not compile LALRPOP; `tests/grammar.rs` sees to it that they are up to date.
#[allow(clippy::all, missing_docs, unused)]
mod grammar {
    include!("../../generated/grammar.rs");
}
