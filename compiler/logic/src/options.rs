//! What the caller may choose of a program.

use grafc_model::reaction::Profile;

/// What the caller may choose.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub struct Options {
    /// Choices that change what the chart means.
    pub profile: Profile,
    /// How the situation is held.
    pub encoding: Encoding,
    /// Whether formulas are shortened by what has been proved; else they are those of the textbook as they stand.
    pub simplify: bool,
}

impl Default for Options {
    fn default() -> Self {
        Options { profile: Profile::default(), encoding: Encoding::default(), simplify: true }
    }
}

/// The encodings.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Encoding {
    /// A bit a step, set-dominant: `S OR X AND NOT R`.
    #[default]
    SinglePhase,
    /// A bit a step, reset by a successor that is active, reset-dominant: `NOT R AND (S OR X)`.
    RTrigger,
    /// A bit a step, reset by a successor that is active, set-dominant: `S OR NOT R AND X`.
    STrigger,
    /// A bit a step, `IF` a transition clears.
    Sequent,
    /// A multi-valued variable for each set of steps that exclude each other, bits for the rest.
    Switch,
}

impl Encoding {
    /// All of them, in the order of the textbook.
    pub const ALL: [Encoding; 5] =
        [Encoding::SinglePhase, Encoding::RTrigger, Encoding::STrigger, Encoding::Sequent, Encoding::Switch];

    /// The name, as options and reports spell it.
    pub fn name(self) -> &'static str {
        match self {
            Encoding::SinglePhase => "single-phase",
            Encoding::RTrigger => "r-trigger",
            Encoding::STrigger => "s-trigger",
            Encoding::Sequent => "sequent",
            Encoding::Switch => "switch",
        }
    }

    /// Whether a step and its successor are active together for one micro-step at each hand-over.
    pub fn overlaps(self) -> bool {
        match self {
            Encoding::RTrigger | Encoding::STrigger => true,
            Encoding::SinglePhase | Encoding::Sequent | Encoding::Switch => false,
        }
    }
}
