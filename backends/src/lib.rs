//! Code generators: each spells a scan program in the words of a target.
//!
//! A backend chooses names, layout and notation, never meaning. [`namer`] makes every identifier that reaches a target,
//! by the tables of [`keywords`]; [`comment`] makes every text of the user's harmless inside a comment.

pub mod awl;
mod braces;
mod branches;
pub mod c;
pub mod choice;
pub mod comment;
mod formulas;
mod iec;
pub mod iec61131_10;
pub mod il;
pub mod js;
pub mod keywords;
mod limits;
mod lines;
mod map;
mod matiec;
pub mod namer;
mod output;
pub mod plcopen;
pub mod rust;
mod s7;
pub mod scl;
mod sequence;
pub mod sfc;
pub mod st;
mod target;
pub mod tcpou;
mod temporaries;
mod transliterate;
mod types;
mod writer;
mod xml;

pub use map::{Element, Kind, Map};
pub use output::{Output, Source};
pub use target::{About, Target};
