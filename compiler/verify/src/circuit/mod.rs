//! A scan program as a sequential circuit, for engines that prove what holds of circuits: bit by bit, exactly, but for reals.
//!
//! A clock of the circuit is a micro-step. At a clock at which the chart rests a call begins: inputs are taken, time goes on;
//! until it rests again, inputs are held. What is claimed of states is asked where it comes to rest. A reaction that finds
//! no end (R9) is a way along which the chart never rests again; the bound on micro-steps is left out.
//!
//! ```text
//! scan::Program ─ build ─▶ and-inverter graph, latches ─▶ aiger, smv
//! ```
//!
//! Delays are free as they are elsewhere in this crate: one that runs may end at the begin of any later call, with all
//! shorter ones of the same operand.
//!
//! | file | what |
//! | --- | --- |
//! | `graph` | conjunctions of two and negations |
//! | `numbers` | whole numbers as bits |
//! | `build` | the statements of a call, symbolically |
//! | `watched` | what engines of our own look for in it |
//! | `aiger`, `smv` | the circuit as text for other tools |

mod aiger;
mod build;
mod graph;
mod numbers;
mod smv;
mod watched;

pub use aiger::aiger;
pub use build::{Bad, Beyond, Circuit, Given, Latch, circuit};
pub use graph::{Graph, Literal, Node, of};
pub use smv::smv;
pub(crate) use watched::{Watched, watched};
