//! Where in the chart a statement comes from.

use super::{StepId, TransitionId, VarId};
use grafc_model::chart::{GrafcetId, VariableId};
use index_vec::define_index_type;

define_index_type! {
    /// An action of the chart: the continuous ones, then the stored ones, each in order of declaration.
    pub struct ActionId = u32;
    DISPLAY_FORMAT = "a{}";
    DEBUG_FORMAT = "a{}";
}

define_index_type! {
    /// A forcing order: those on one grafcet after those on another, the one that wins first.
    pub struct OrderId = u32;
    DISPLAY_FORMAT = "o{}";
    DEBUG_FORMAT = "o{}";
}

/// What part of the chart a statement comes from: no larger than a number, so that each statement can say it. What it
/// stands for is in the tables of the program, see [`super::Elements`].
#[derive(Clone, Copy, PartialEq, Eq, Hash, Debug, Default)]
pub enum Origin {
    /// The chart as a whole, or whatever the statements around come from.
    #[default]
    Chart,
    /// A step.
    Step(StepId),
    /// A transition.
    Transition(TransitionId),
    /// An action.
    Action(ActionId),
    /// All actions on a variable, where they are carried out together.
    Actions(VariableId),
    /// A forcing order.
    Order(OrderId),
    /// All forcing orders on a grafcet.
    Orders(GrafcetId),
    /// The declaration of a variable.
    Declaration(VariableId),
}

impl Origin {
    /// The declaration of a variable of the chart: those come first in the table of a program.
    pub fn declaration(variable: VarId) -> Origin {
        Origin::Declaration(VariableId::from(variable.index()))
    }

    /// This one, or the other where this is the chart as a whole.
    pub fn or(self, other: Origin) -> Origin {
        if self == Origin::Chart { other } else { self }
    }
}

/// How much of its origin is said beside a statement.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Told {
    /// Nothing.
    #[default]
    Nothing,
    /// What it is called.
    Name,
    /// And the comment that the chart attaches to it.
    All,
    /// The comment alone, where the name of what is written says the rest.
    Comment,
    /// The steps that have a part in it, where values of states do not name them.
    Steps,
    /// Why it does not stand where the chart has it: it reads a variable that is written later.
    Before(VariableId),
}

/// What a part of a program is about, as a heading.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Heading {
    /// An input lowers the flags.
    FlagsAreLowered,
    /// An input starts the chart anew.
    StartsAnew,
    /// Outputs on arcs of automata are over with the call.
    OutputsOnArcs,
    /// Edges, delays and intermediate results of transition-conditions.
    Conditions,
    /// What edges were, for the next micro-step.
    MemoryOfEdges,
    /// Which transitions clear, where that is latched.
    TransitionsThatClear,
    /// Transitions that write the situation themselves.
    Transitions,
    /// The next situation, where it is computed before it is written.
    NextSituation,
    /// Which grafcets orders freeze.
    FrozenGrafcets,
    /// What the steps enclose, and what orders force.
    EnclosuresAndOrders,
    /// Stored actions.
    StoredActions,
    /// Outputs that follow a state.
    OutputsOfTheSteps,
    /// The situation is written.
    Situation,
    /// What is done where something clears.
    WhatTheClearingsBringAbout,
    /// Delays that rest from here on.
    TimersOfTheStepBefore,
    /// Delays that run.
    TimersOfTheActiveStep,
    /// Continuous actions.
    Outputs,
    /// What outputs do in a call that was cut off.
    OutputsAfterLivelock,
    /// Which assertion is false.
    Assertions,
    /// What is shown of transitions.
    WhatIsSeenOfTransitions,
    /// What is shown of grafcets, steps and orders.
    WhatIsSeenOfTheSituation,
    /// What is shown of actions.
    WhatIsSeenOfActions,
    /// A part that is about one of several grafcets.
    Of(Part, GrafcetId),
}

/// Parts that each grafcet has.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Part {
    /// Which transitions clear, where that is latched.
    TransitionsThatClear,
    /// Transitions that write the situation themselves.
    Transitions,
    /// The next situation, where it is computed before it is written.
    NextSituation,
    /// The situation is written.
    Situation,
    /// Continuous actions.
    Outputs,
}

impl Part {
    /// The heading over the parts of all grafcets.
    pub fn of_all(self) -> Heading {
        match self {
            Part::TransitionsThatClear => Heading::TransitionsThatClear,
            Part::Transitions => Heading::Transitions,
            Part::NextSituation => Heading::NextSituation,
            Part::Situation => Heading::Situation,
            Part::Outputs => Heading::Outputs,
        }
    }
}

impl Heading {
    /// Its words; of one that is about a grafcet, those that do not name it.
    pub fn text(self) -> &'static str {
        match self {
            Heading::Of(part, _) => part.of_all().text(),
            Heading::FlagsAreLowered => "flags are lowered",
            Heading::StartsAnew => "the chart starts anew: all as before the first call",
            Heading::OutputsOnArcs => "outputs on arcs of the call before are over",
            Heading::FrozenGrafcets => "grafcets that orders freeze",
            Heading::Conditions => "conditions",
            Heading::MemoryOfEdges => "memory of edges",
            Heading::TransitionsThatClear => "transitions that clear",
            Heading::Transitions => "transitions",
            Heading::NextSituation => "next situation",
            Heading::EnclosuresAndOrders => "enclosures and orders",
            Heading::StoredActions => "stored actions",
            Heading::OutputsOfTheSteps => "outputs of the steps left and entered",
            Heading::Situation => "situation",
            Heading::WhatTheClearingsBringAbout => "what the clearings bring about",
            Heading::TimersOfTheStepBefore => "timers of the step that was active before",
            Heading::TimersOfTheActiveStep => "timers of the active step",
            Heading::Outputs => "outputs",
            Heading::OutputsAfterLivelock => "outputs where no stable situation was found",
            Heading::Assertions => "assertions",
            Heading::WhatIsSeenOfTransitions => "what is seen of transitions",
            Heading::WhatIsSeenOfTheSituation => "what is seen of grafcets, steps and orders",
            Heading::WhatIsSeenOfActions => "what is seen of actions",
        }
    }
}
