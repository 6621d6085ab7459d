//! Shorter programs that mean the same.

pub(crate) mod absorb;
mod cells;
pub(crate) mod idle_delays;
pub(crate) mod join;
pub(crate) mod long_chains;
pub(crate) mod once;
pub(crate) mod sweep;
mod words;
