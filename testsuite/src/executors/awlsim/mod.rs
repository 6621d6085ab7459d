//! Generated STL, run by awlsim, a simulator of S7 CPUs written in Python.
//!
//! A text of ours (`play.py`) loads the source of each chart into a CPU of its own, writes inputs and clock into the
//! instance data block before each cycle of `OB 1`, and reads outputs, steps and flags from it afterwards.
//!
//! `AWLSIM_PYTHON` names a Python that has awlsim (`pip install awlsim`); otherwise it is `python3`.

mod executor;
mod run;
mod tools;

pub(super) use executor::Awlsim;
pub use run::{accepts, beyond, play_cycles, run};
pub use tools::Tools;
