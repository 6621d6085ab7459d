//! Code generators: each spells a scan program in the words of a target.
//!
//! A backend chooses names, layout and notation, never meaning. [`namer`] makes every identifier that reaches a target,
//! by the tables of [`keywords`]; [`comment`] makes every text of the user's harmless inside a comment.

pub mod comment;
pub mod keywords;
pub mod namer;
pub mod st;
mod transliterate;
