//! What is proved of a flat net.

pub(crate) mod components;
#[cfg(test)]
mod exclusion_tests;
pub(crate) mod transients;
