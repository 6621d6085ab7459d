//! What a chart can come to: all states that reactions lead to, found from the scan program alone.
//!
//! ```text
//! scan::Program ─ machine ─▶ one reaction, path by path ─ explore ─▶ states ─ graph ─▶ situations and what leads where
//! ```
//!
//! A *path* is a reaction as far as the inputs are known that it asks for: what it does not look at is not decided, so one
//! path stands for all vectors of inputs that agree with what it asked. A state is what a reaction leaves and the next one
//! can read: situation, stored variables, operands of edges, delays. Nothing here asks the reference simulator, which the
//! tests hold against it.
//!
//! Delays are free: one that runs may end at any later reaction, but never before one of the same operand with a shorter
//! time, and never in the reaction that started it. So there may be more here than real times allow, and never less.
//!
//! | file | what |
//! | --- | --- |
//! | `atom` | what a reaction can ask of inputs and time, and what follows from the answers so far |
//! | `beyond` | what cannot be followed |
//! | `clocks` | the timers of a program, and which of them measure the same operand |
//! | `live` | the variables that make a state |
//! | `machine` | one path through one reaction |
//! | `explore` | all paths from all states |
//! | `moves` | reactions that real times allow, each with inputs and a time |
//! | `when` | the inputs of paths, as a condition |
//! | `graph` | the graph of reachable situations, or of states |
//! | `circuit` | the program as a sequential circuit, for engines of others |

mod atom;
mod beyond;
pub mod circuit;
mod clocks;
mod explore;
mod graph;
mod live;
mod machine;
mod moves;
mod when;

pub use beyond::Beyond;
pub use graph::{Edge, Graph, Livelock, Node, Of, graph};
pub use moves::{Move, Moves, Times, moves};
