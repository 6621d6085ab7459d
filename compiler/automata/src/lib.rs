//! Charts as automata: which transition graphs a chart is, and the classical conversions between kinds of automata.
//!
//! ```text
//! Analysis ─ system ─▶ interacting transition graphs
//! scan::Program ─ explore ─▶ Machine ─ convert ─▶ Automaton: moore, mealy, extended, minimal
//! ```
//!
//! A *machine* is what a chart is from outside: with each call it takes the inputs, publishes outputs and goes from one
//! state to another. Sets of inputs are decision diagrams, so that 30 inputs are no more than 3. The kinds of automata
//! differ in where the outputs of a call are written down, never in what they are:
//!
//! | kind | where the outputs of a call stand |
//! | --- | --- |
//! | Moore | at the vertex that the call leads to |
//! | Mealy | at the arc that it takes |
//! | extended | at the vertex in which it begins, as an expression for each output |
//!
//! | file | what |
//! | --- | --- |
//! | `machine` | machines, sets of inputs |
//! | `words` | sets of inputs as conditions and as cubes |
//! | `call` | one call of a program for all inputs at once |
//! | `explore` | from a program to the machine that it is |
//! | `refine` | classes of equivalent states, after Hopcroft |
//! | `product` | whether two machines do the same, by their product |
//! | `moore`, `mealy`, `extended`, `minimal` | the conversions |
//! | `automaton` | what a conversion comes to |
//! | `convert` | a machine to an automaton of some kind, and the proof that it is the same |
//! | `kiss2` | a machine as a table of KISS2 |
//! | `system` | the transition graphs of a chart |

mod automaton;
mod call;
mod convert;
mod explore;
mod extended;
mod kiss2;
mod machine;
mod mealy;
mod minimal;
mod moore;
mod product;
mod refine;
mod system;
#[cfg(test)]
mod tests;
mod words;

pub use automaton::{Arc, Automaton, Kind, Vertex};
pub use call::Beyond;
pub use convert::convert;
pub use explore::explore;
pub use kiss2::kiss2;
pub use machine::{Machine, Set, State};
pub use product::{Difference, product};
pub use system::{Graph, GraphArc, GraphVertex, System, system};
pub use words::condition;
