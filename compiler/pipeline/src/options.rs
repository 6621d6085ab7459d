//! What is asked of a compile.

use grafc_backends::Target;
use grafc_diagnostics::Policy;
use grafc_model::chart::ControlNames;
use grafc_model::reaction::Asked;

/// What is made, and what it is to mean.
#[derive(Clone, Debug)]
pub struct Options {
    /// How the chart becomes a program.
    pub lowering: grafc_logic::Options,
    /// What was asked for of what the chart means; what its heading chooses otherwise is refused (E0217).
    pub asked: Asked,
    /// The name of the chart's file, if the head of the code is to say what it was made of, and how.
    pub source: Option<String>,
    /// Whether the bound on micro-steps is the one that is known to be enough, where one is.
    pub bound_as_known: bool,
    /// Inputs that act on the chart as a whole.
    pub controls: ControlNames,
    /// What comes out.
    pub product: Product,
    /// Which warnings are errors, and which are not wanted.
    pub policy: Policy,
}

impl Options {
    /// Everything as usual: all warnings are shown, and none is an error.
    pub fn new(lowering: grafc_logic::Options, product: Product) -> Self {
        Options {
            lowering,
            asked: Asked::default(),
            source: None,
            bound_as_known: false,
            controls: ControlNames::default(),
            product,
            policy: Policy::default(),
        }
    }
}

/// What comes out: code, or what lies between two stages.
#[derive(Clone, Debug)]
pub enum Product {
    /// Code.
    Code(Target),
    /// Code, and which lines of it come from which element of the chart, if the target knows.
    Mapped(Target),
    /// The syntax tree.
    Tree,
    /// The checked chart.
    Chart,
    /// The net after the pass of this name.
    NetAfter(String),
    /// The flat net.
    Net,
    /// The equations of the scan program.
    Equations,
    /// The scan program.
    Program,
}
