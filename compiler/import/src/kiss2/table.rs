//! A table of KISS2: rows with a cube of inputs, a state, the next one, and outputs.

use grafc_diagnostics::Span;

/// A table as the file has it.
#[derive(Clone, Debug, Default)]
pub struct Table {
    /// How many inputs a row has.
    pub inputs: usize,
    /// How many outputs.
    pub outputs: usize,
    /// The names of inputs, if the file gives them.
    pub input_names: Vec<String>,
    /// Those of outputs.
    pub output_names: Vec<String>,
    /// The names of the states, in the order in which they are met.
    pub states: Vec<String>,
    /// Where it begins.
    pub reset: usize,
    /// The rows, in the order of the file.
    pub rows: Vec<Row>,
    /// What it begins with.
    pub span: Span,
}

/// A row.
#[derive(Clone, Debug)]
pub struct Row {
    /// The inputs with which it is taken.
    pub cube: Cube,
    /// From this state; none: from any.
    pub from: Option<usize>,
    /// To this one; none: it is left open.
    pub to: Option<usize>,
    /// Which outputs are true; what is left open is false.
    pub outputs: Vec<bool>,
    /// Its line.
    pub span: Span,
}

/// A value for some of the inputs: `true`, `false`, or none for any.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Cube(pub Vec<Option<bool>>);

impl Cube {
    /// Whether some inputs are in both.
    pub fn meets(&self, other: &Cube) -> bool {
        self.0.iter().zip(&other.0).all(|(a, b)| a.is_none() || b.is_none() || a == b)
    }

    /// Whether all inputs of the other are in this one.
    pub fn holds(&self, other: &Cube) -> bool {
        self.0.iter().zip(&other.0).all(|(a, b)| a.is_none() || a == b)
    }

    /// How many inputs it leaves open.
    pub fn open(&self) -> usize {
        self.0.iter().filter(|value| value.is_none()).count()
    }
}
