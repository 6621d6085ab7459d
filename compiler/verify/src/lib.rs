//! What a chart can come to: all states that reactions lead to, found from the scan program alone.
//!
//! ```text
//! scan::Program ─ machine ─▶ one reaction, path by path ─ explore ─▶ states ─ graph ─▶ situations and what leads where
//! ```
//!
//! A *path* is a reaction as far as the inputs are known that it asks for: what it does not look at is not decided, so one
//! path stands for all vectors of inputs that agree with what it asked. A state is what a reaction leaves and the next one
//! can read: situation, stored variables, operands of edges, delays. The reference
//! simulator is asked for nothing but whether a trace replays; the tests hold it against all of this.
//!
//! Delays are free: one that runs may end at any later reaction, but never before one of the same operand with a shorter
//! time, and never in the reaction that started it. So there may be more here than real times allow, and never less.
//!
//! | file | what |
//! | --- | --- |
//! | `atom` | what a reaction can ask of inputs and time, and what follows from the answers so far |
//! | `beyond`, `limit` | what cannot be followed, and why a search ends before its end |
//! | `clocks` | the timers of a program, and which of them measure the same operand |
//! | `live`, `pack` | the variables that make a state, and how it is kept |
//! | `cone` | a program without what no claim depends on |
//! | `machine` | one path through one reaction |
//! | `facts` | what is seen of micro-steps |
//! | `explore` | all paths from all states |
//! | `moves` | reactions that real times allow, each with inputs and a time |
//! | `when` | the inputs of paths, as a condition |
//! | `graph` | the graph of reachable situations, or of states |
//! | `claim`, `claimed`, `goal` | what is claimed, how the program computes it, and what engines look for |
//! | `explicit`, `edges` | the engine that looks at one state after the other |
//! | `symbolic` | the engine that looks at all states at once |
//! | `sat` | the engine that asks a solver of clauses |
//! | `times`, `timed`, `zone` | real times for a way, and the search in real times |
//! | `inputs`, `trace`, `replay` | a trace, and whether the reference simulator does what it shows |
//! | `verify` | the claims with their answers |
//! | `circuit` | the program as a sequential circuit, for engines of others |

mod atom;
mod beyond;
mod budget;
pub mod circuit;
mod claim;
mod claimed;
mod clocks;
mod cone;
mod edges;
mod explicit;
mod explore;
mod facts;
mod goal;
mod graph;
mod inputs;
mod limit;
mod live;
mod machine;
mod moves;
mod pack;
mod replay;
mod sat;
mod symbolic;
mod timed;
mod times;
mod trace;
mod verify;
mod when;
mod zone;

pub use beyond::Beyond;
pub use claim::{Claim, Kind};
pub use goal::{Reason, Searched};
pub use graph::{Edge, Graph, Livelock, Node, Of, graph};
pub use limit::Limit;
pub use moves::{Move, Moves, Times, moves};
pub use trace::{Row, Trace, cell};
pub use verify::{Answer, Method, Progress, Subject, Verdict, Verified, verify};
