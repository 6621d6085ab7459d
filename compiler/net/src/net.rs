//! The Petri net: places, transitions with what comes before and after, and side tables.
//!
//! Meaning: a place is a step of IEC 60848 (Boolean: its token is its activity), a transition is a transition. Step
//! `s3` of the chart is place `s3`; grafcets, variables, expressions and transitions keep their ids as well. Conditions
//! stay in the chart's pool of expressions: an expression that names the activity of a macro-step or of a grafcet means
//! the disjunction of the places that the side table lists.
//!
//! What removes a construct leaves behind what it means, place by place and transition by transition:
//!
//! | construct | before | after |
//! | --- | --- | --- |
//! | macro-step | `entered_by`, `left_by` of [`MacroStep`] | arcs |
//! | forcing order | [`Net::orders`] | [`Grafcet::orders`], the one that wins first; every situation a set or the current one |
//! | initial situation | `initial` as the chart marks it | `initial` as rules R5 and R10 settle it, [`Net::conflict_at_start`] |
//! | freezing | follows the hierarchy | [`Grafcet::frozen_with`] |
//! | enclosure | [`Grafcet::enclosing_step`] | `within` of [`Place`] and [`Transition`] |
//! | child that only steps run | [`Net::runs`] | the same: an enclosure of these steps |
//!
//! Invariants, which [`crate::verify()`] checks:
//! - every id lies in its table;
//! - `pre` and `post` of a transition hold no place twice, and only places of the transition's grafcet;
//! - an operand of an expression comes before the expression;
//! - a transition is in `entered_by` (`left_by`) of a macro-step at most once;
//! - what a [`Fact`] that was reached says.

use ecow::EcoString;
use grafc_diagnostics::Span;
use grafc_model::chart::{
    ChartOptions, Claims, Continuous, Controls, Event, Expr, ExprId, GrafcetId, MacroId, Note, Order, Pulse, Run,
    StepId, Stored, TransitionId, Variable, VariableId,
};
use index_vec::IndexVec;
use rustc_hash::FxHashSet;
use smallvec::SmallVec;

/// What a pass has brought about, for good.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Fact {
    /// No arc leads into or out of a macro-step: `entered_by` and `left_by` are empty.
    NoMacroSteps,
    /// `orders` of the net is empty; each grafcet has its own, in the order in which they win.
    RankedOrders,
    /// `initial` marks the situation after R10, before the first micro-step.
    SettledStart,
    /// `frozen_with` says from where freezing reaches a grafcet.
    ClosedFreezing,
    /// No grafcet has an enclosing step; places and transitions say what they are within.
    NoEnclosures,
    /// A child that does nothing but run with steps is within them, and no command on it is left.
    NestedChildren,
    /// No two places hand over to each other: `a -> b -> a`, where neither is before and after one transition.
    NoTwoStepRings,
}

/// A chart as a Petri net.
#[derive(Clone, Debug)]
pub struct Net {
    /// The chart's name.
    pub name: EcoString,
    /// The chart's attached comment.
    pub comment: Option<Note>,
    /// What its heading chooses of its meaning.
    pub options: ChartOptions,
    /// Declared variables.
    pub variables: IndexVec<VariableId, Variable>,
    /// Places: the steps of the chart.
    pub places: IndexVec<StepId, Place>,
    /// Transitions.
    pub transitions: IndexVec<TransitionId, Transition>,
    /// Partial grafcets.
    pub grafcets: IndexVec<GrafcetId, Grafcet>,
    /// Grafcets from the top of the hierarchy down.
    pub hierarchy: Vec<GrafcetId>,
    /// Macro-steps: their arcs until they are expanded, and for good the places that their activity means.
    pub macro_steps: IndexVec<MacroId, MacroStep>,
    /// Continuous actions.
    pub continuous: Vec<Continuous>,
    /// Stored actions.
    pub stored: Vec<Stored>,
    /// Forcing orders, until they are ranked.
    pub orders: Vec<Order>,
    /// Pulse orders.
    pub pulses: Vec<Pulse>,
    /// Grafcets that run while steps are active.
    pub runs: Vec<Run>,
    /// Whether orders disagree in the initial situation; known once that is settled.
    pub conflict_at_start: bool,
    /// Conditions and values.
    pub exprs: IndexVec<ExprId, Expr>,
    /// What is said of the chart and changes nothing in it.
    pub claims: Claims,
    /// Inputs that act on the chart as a whole.
    pub controls: Controls,
    /// What the passes so far have brought about.
    pub facts: Vec<Fact>,
}

impl Net {
    /// Whether a grafcet is commanded by pulses.
    pub fn has_commands(&self) -> bool {
        !self.pulses.is_empty() || !self.runs.is_empty()
    }

    /// Whether each grafcet is commanded by pulses.
    pub fn commanded(&self) -> IndexVec<GrafcetId, bool> {
        let mut commanded: IndexVec<GrafcetId, bool> = self.grafcets.iter().map(|_| false).collect();
        self.commands().for_each(|(_, g)| commanded[g] = true);
        commanded
    }

    /// All commands by pulses: the grafcet that gives it, and the one that it is given to.
    pub fn commands(&self) -> impl Iterator<Item = (GrafcetId, GrafcetId)> + '_ {
        let pulses = self.pulses.iter().map(|pulse| (self.commander(pulse.event), pulse.grafcet));
        pulses.chain(self.runs.iter().map(|run| (self.places[run.step].grafcet, run.grafcet)))
    }

    /// For each grafcet the pulse orders on it, as places in the list, and the steps that it runs with.
    pub fn commands_on(&self) -> IndexVec<GrafcetId, CommandsOn> {
        let mut on: IndexVec<GrafcetId, CommandsOn> = self.grafcets.iter().map(|_| CommandsOn::default()).collect();
        self.pulses.iter().enumerate().for_each(|(place, pulse)| on[pulse.grafcet].pulses.push(place));
        self.runs.iter().for_each(|run| on[run.grafcet].runs.push(run.step));
        on
    }

    /// What stored actions and pulse orders wait for, one after the other.
    pub fn awaited(&self) -> impl Iterator<Item = Event> + '_ {
        self.stored.iter().map(|action| action.event).chain(self.pulses.iter().map(|pulse| pulse.event))
    }

    /// The transitions whose clearing something waits for, a stored action or a pulse order, as often as something does.
    pub fn awaited_clearings(&self) -> impl Iterator<Item = TransitionId> + '_ {
        self.awaited().filter_map(|event| match event {
            Event::Clearing(t) => Some(t),
            Event::Event(..) | Event::Activation(_) | Event::Deactivation(_) | Event::EachScan(..) => None,
        })
    }

    /// The grafcet that gives a pulse.
    pub fn commander(&self, event: Event) -> GrafcetId {
        match event {
            Event::Event(s, _) | Event::Deactivation(s) | Event::Activation(s) | Event::EachScan(s, _) => {
                self.places[s].grafcet
            }
            Event::Clearing(t) => self.transitions[t].grafcet,
        }
    }

    /// The grafcet around one, before and after enclosures are flattened.
    pub fn around(&self, g: GrafcetId) -> Option<GrafcetId> {
        let grafcet = &self.grafcets[g];
        let within = grafcet.enclosing_step.or_else(|| self.within(g).first().copied())?;
        Some(self.places[within].grafcet)
    }

    /// What a grafcet is within, once that is flat. One without places does not say.
    pub fn within(&self, g: GrafcetId) -> &[StepId] {
        self.grafcets[g].steps.first().map_or(&[], |s| &self.places[*s].within)
    }

    /// For each grafcet what its steps command by pulses, and those of its enclosures, however deep.
    pub fn commanded_below(&self) -> IndexVec<GrafcetId, Vec<GrafcetId>> {
        let mut below: IndexVec<GrafcetId, Vec<GrafcetId>> = self.grafcets.iter().map(|_| Vec::new()).collect();
        self.commands().for_each(|(above, commanded)| below[above].push(commanded));
        // What is enclosed comes after what encloses it.
        for g in self.hierarchy.iter().rev() {
            below[*g].sort_unstable();
            below[*g].dedup();
            if let Some(around) = self.around(*g) {
                let inside = below[*g].clone();
                below[around].extend(inside);
            }
        }
        below
    }
}

/// What commands a grafcet by pulses.
#[derive(Clone, Debug, Default)]
pub struct CommandsOn {
    /// Pulse orders, as places in the list of the net.
    pub pulses: Vec<usize>,
    /// The steps that it runs with.
    pub runs: Vec<StepId>,
}

impl CommandsOn {
    /// Whether nothing does.
    pub fn is_empty(&self) -> bool {
        self.pulses.is_empty() && self.runs.is_empty()
    }
}

/// A place: one step.
#[derive(Clone, Debug)]
pub struct Place {
    /// The step's label.
    pub label: EcoString,
    /// The attached comment.
    pub comment: Option<Note>,
    /// The grafcet that it belongs to.
    pub grafcet: GrafcetId,
    /// In the initial situation.
    pub initial: bool,
    /// Has an activation link: activated together with the step that encloses it.
    pub activated: bool,
    /// The places of one grafcet of which one must be active for this one to be, once enclosures are flattened: the step
    /// that encloses it, or those that run its child. None if it stands alone.
    pub within: Steps,
    /// Whether a start of its grafcet activates it: it is initial in the chart.
    pub started: bool,
    /// Whether it is active again when its grafcet is resumed, as far as the start goes.
    pub saved: bool,
    /// Made by a pass: no step of the chart, and no part of its situation.
    pub auxiliary: bool,
    /// The label in the chart.
    pub span: Span,
}

impl Place {
    /// One that a pass makes: no step of the chart, inactive at the start, within nothing.
    pub fn auxiliary(label: EcoString, grafcet: GrafcetId, span: Span) -> Place {
        Place {
            label,
            comment: None,
            grafcet,
            initial: false,
            activated: false,
            within: Steps::new(),
            started: false,
            saved: false,
            auxiliary: true,
            span,
        }
    }

    /// The place that is active whenever this one is, because this one is within it alone.
    pub fn encloser(&self) -> Option<StepId> {
        only(&self.within)
    }
}

/// The step of a list of one.
fn only(list: &[StepId]) -> Option<StepId> {
    match list {
        [one] => Some(*one),
        _ => None,
    }
}

/// The places on one side of a transition: mostly few, which then lie in the transition itself.
pub type Steps = SmallVec<[StepId; 4]>;

/// A transition.
#[derive(Clone, Debug)]
pub struct Transition {
    /// The designation.
    pub designation: Option<Note>,
    /// The attached comment.
    pub comment: Option<Note>,
    /// The grafcet that it belongs to.
    pub grafcet: GrafcetId,
    /// The immediately preceding places.
    pub pre: Steps,
    /// The immediately succeeding places.
    pub post: Steps,
    /// The places of which one must be active for it to clear, once enclosures are flattened.
    pub within: Steps,
    /// The transition-condition.
    pub condition: ExprId,
    /// Made by a pass: no transition of the chart.
    pub auxiliary: bool,
    /// The item in the chart.
    pub span: Span,
}

impl Transition {
    /// One that a pass makes, within nothing.
    pub fn auxiliary(grafcet: GrafcetId, pre: Steps, post: Steps, condition: ExprId, span: Span) -> Transition {
        let (designation, comment, within) = (None, None, Steps::new());
        Transition { designation, comment, grafcet, pre, post, within, condition, auxiliary: true, span }
    }

    /// The place that is active whenever it clears, because it is within that alone.
    pub fn encloser(&self) -> Option<StepId> {
        only(&self.within)
    }

    /// The steps that it leaves: those before it that it does not lead back to.
    pub fn left(&self) -> Vec<StepId> {
        without(&self.pre, &self.post)
    }

    /// The steps that it newly leads to: those after it that do not come before it.
    pub fn entered(&self) -> Vec<StepId> {
        without(&self.post, &self.pre)
    }
}

/// The steps of a list that are not in the other one.
pub fn without(list: &[StepId], other: &[StepId]) -> Vec<StepId> {
    // A table is worth it only for long lists.
    let table: FxHashSet<StepId> =
        if other.len() > SHORT { other.iter().copied().collect() } else { FxHashSet::default() };
    let in_other = |s: &&StepId| if table.is_empty() { other.contains(s) } else { table.contains(s) };
    list.iter().filter(|s| !in_other(s)).copied().collect()
}

/// A list of so many steps is searched one by one.
const SHORT: usize = 16;

/// A macro-step.
#[derive(Clone, Debug)]
pub struct MacroStep {
    /// The label.
    pub label: EcoString,
    /// Where arcs into it lead.
    pub entry: StepId,
    /// Where arcs out of it start.
    pub exit: StepId,
    /// The steps that its expansion holds directly. Its activity is the disjunction of theirs and of that of `inner`.
    pub places: Vec<StepId>,
    /// The macro-steps that its expansion holds directly.
    pub inner: Vec<MacroId>,
    /// Transitions with an arc into it.
    pub entered_by: Vec<TransitionId>,
    /// Transitions with an arc out of it.
    pub left_by: Vec<TransitionId>,
}

/// A partial grafcet.
#[derive(Clone, Debug)]
pub struct Grafcet {
    /// The name.
    pub name: EcoString,
    /// The attached comment.
    pub comment: Option<Note>,
    /// The step that encloses it, until enclosures are flattened.
    pub enclosing_step: Option<StepId>,
    /// Whether it is a child: not active at the start, and started by an order.
    pub child: bool,
    /// Whether a pulse order freezes it at the start.
    pub starts_frozen: bool,
    /// Longest chain of orders and enclosures above it (M2).
    pub level: u32,
    /// Its places, in order of declaration.
    pub steps: Vec<StepId>,
    /// The orders on it, the one that wins first (R2); known once orders are ranked.
    pub orders: Vec<RankedOrder>,
    /// The nearest grafcet around it that can be frozen, and freezes this one with itself; known once freezing is
    /// closed. The grafcet is frozen while a step of `orders` is active or that one is frozen.
    pub frozen_with: Option<GrafcetId>,
    /// The name in its heading.
    pub span: Span,
}

/// An order on a grafcet, in force while its step is active and no step of an order before it is.
#[derive(Clone, Debug)]
pub struct RankedOrder {
    /// The forcing step.
    pub step: StepId,
    /// The forced situation.
    pub forced: Forced,
    /// The order in the chart.
    pub span: Span,
}

/// A forced situation.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Forced {
    /// Exactly these places, in order of declaration; `{}` and `{INIT}` are such sets as well.
    Steps(Vec<StepId>),
    /// The current situation, frozen: `{*}`.
    Current,
}
