//! What the textual languages of IEC 61131-3 share: a function block differs in its body alone.
//!
//! Edition 2, and of it only what MATIEC, IronPLC, STruC++ and the vendors' tools all take: keywords in upper case, flat
//! comments, no VAR_TEMP, time literals of one unit, located variables in a block of their own.

pub(crate) mod choices;
pub(crate) mod declarations;
pub(crate) mod frame;
pub(crate) mod literals;
pub(crate) mod names;
pub(crate) mod pou_parts;

/// What is written around the function block.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Pou {
    /// The function block alone.
    #[default]
    FunctionBlock,
    /// And a program that holds an instance of it and the variables at addresses.
    Program,
    /// And a configuration with a task that runs the program.
    Configuration,
}

/// What the caller may choose.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Options {
    /// What is written around the function block.
    pub pou: Pou,
    /// The first lines of the file, as a comment: which chart, which version, which options.
    pub header: Vec<String>,
    /// The interval of the task, in milliseconds.
    pub interval_ms: u32,
}

impl Default for Options {
    fn default() -> Self {
        Options { pou: Pou::default(), header: Vec::new(), interval_ms: 20 }
    }
}
