//! Everything that can run a chart, behind one trait.
//!
//! The reference simulator says what a chart does; each other executor takes the chart through some of the compiler's
//! stages, the last ones through tools from outside, and must do the same. Each tool has a folder: `tools` finds and
//! calls it, `run` has it run programs, `executor` puts it behind the trait. Tools are looked for on PATH or where an
//! environment variable says; an executor without its tool says so and is not run.

pub mod awlsim;
pub mod beremiz;
pub mod c;
mod c_driver;
pub(crate) mod function_block;
pub mod ironplc;
pub mod jobs;
pub mod js;
mod lanes;
pub mod matiec;
mod net;
pub mod rust;
mod scan;
mod sequences;
mod simulator;
pub mod strucpp;
mod task;

use crate::tools::{Tool, or_skip};
pub use simulator::Simulator;
pub use task::{Executor, Outcome, Task};

/// All executors, the reference first.
pub fn all() -> Vec<Box<dyn Executor>> {
    let mut all: Vec<Box<dyn Executor>> = vec![Box::new(Simulator)];
    all.extend(net::executors());
    all.extend(scan::executors());
    all.push(Box::new(lanes::AtOnce));
    all.push(Box::new(rust::Rust::find()));
    all.push(Box::new(js::JavaScript::find()));
    all.push(Box::new(c::C::find()));
    all.extend(matiec::executors());
    all.push(matiec::sequences());
    all.push(Box::new(ironplc::Ironplc::find()));
    all.push(Box::new(strucpp::Strucpp::find()));
    all.push(Box::new(awlsim::Awlsim::find()));
    all.extend(beremiz::executors());
    all
}

/// The executors of a list of names separated by commas: whole names, names of groups, `built-in` and `all`. An error
/// names what is unknown, or asked for by its own name and missing.
pub fn select(names: &str) -> Result<Vec<Box<dyn Executor>>, String> {
    let all = all();
    let mut chosen = vec![false; all.len()];
    for name in names.split(',').map(str::trim) {
        let mut known = false;
        for (executor, chosen) in all.iter().zip(&mut chosen) {
            let group = executor.name().split(':').next();
            let broad = name == "all" || name == "built-in" && !executor.is_external();
            if !broad && executor.name() != name && group != Some(name) {
                continue;
            }
            known = true;
            match executor.missing() {
                None => *chosen = true,
                Some(missing) if !broad => return Err(format!("`{name}` cannot be used: {missing}")),
                Some(_) => {}
            }
        }
        if !known {
            let names: Vec<&str> = all.iter().map(|executor| executor.name()).collect();
            return Err(format!("there is no executor `{name}`; there are {}, built-in, all", names.join(", ")));
        }
    }
    Ok(all.into_iter().zip(chosen).filter_map(|(executor, chosen)| chosen.then_some(executor)).collect())
}

/// The executor of a name, or nothing and a line that says what the test lacks that wants it.
///
/// # Panics
/// If there is no executor of this name, or its tool is required.
pub fn find_or_skip(name: &str) -> Option<Box<dyn Executor>> {
    let executor = all().into_iter().find(|executor| executor.name() == name).expect("an executor of this name");
    is_here_or_skip(executor.as_ref()).then_some(executor)
}

/// Whether an executor can be used; a line says what it lacks, if it cannot.
///
/// # Panics
/// If its tool is required.
pub fn is_here_or_skip(executor: &dyn Executor) -> bool {
    let here = executor.missing().map_or(Ok(()), |missing| Err(missing.to_string()));
    executor.tool().is_none_or(|tool| or_skip(tool, here).is_some())
}

/// What a tool lacks that some executor is about, if it lacks something.
pub fn missing(tool: Tool) -> Option<String> {
    all().iter().find(|executor| executor.tool() == Some(tool))?.missing().map(str::to_owned)
}
