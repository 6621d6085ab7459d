//! Generated Structured Text, as IronPLC compiles it and its virtual machine runs it.
//!
//! The machine runs a program on the clock of the computer, gives it no inputs, and shows its variables when it ends.
//! So the trace is put into the program (`play`): it takes its inputs and its time from arrays, scan by scan, and keeps
//! what came out of the last scans. IronPLC cannot run a function block that has another within, as a timer is one, and
//! forgets initial values of function blocks. So the body runs as the body of a program, with timers written out that
//! have the time of the trace. That IronPLC takes the text as it was written is asked first.

mod executor;
mod play;
mod run;
mod tools;

pub(super) use executor::Ironplc;
pub use run::{accepts, run};
pub use tools::Tools;
