//! PLCopen projects, as the generator of Beremiz reads them, MATIEC compiles what it makes of them, and a C compiler runs
//! that: the round trip of every kind of body.
//!
//! `BEREMIZ` names the folder of Beremiz, with `PLCGenerator.py` in it; `PYTHON` a Python that has what Beremiz needs
//! (lxml), otherwise it is `python3`. All projects of a run go through one Python, by `generate.py`, which is ours.

mod executor;
mod run;
mod tools;

pub(super) use executor::executors;
pub use run::{Source, run};
pub use tools::Tools;
