//! What is claimed of a chart.

use crate::facts::Fact;
use crate::goal::Goal;
use grafc_diagnostics::Span;
use grafc_logic::scan::{ClaimKind, Program, SeenBody, SeenClaim, StepId, TransitionId};

/// The kinds of claims.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub enum Kind {
    /// Every reaction ends (R9).
    Livelock,
    /// From every state another situation can be reached.
    Deadlock,
    /// From every state an initial situation can be reached.
    Home,
    /// Stored actions, or orders, never disagree.
    Conflict,
    /// A transition is cleared in some micro-step.
    DeadTransition,
    /// A step is active in some situation.
    DeadStep,
    /// No two transitions after a step are cleared together.
    Selection,
    /// A step is not activated while it is active.
    Reentry,
    /// In every state something is true.
    Assert,
    /// Something can be reached from everywhere after something else.
    Leads,
    /// In some state something is true.
    Reach,
}

impl Kind {
    /// Those that are always asked, in the order in which they are told.
    pub const ALWAYS: [Kind; 8] = [
        Kind::Livelock,
        Kind::Deadlock,
        Kind::Conflict,
        Kind::DeadTransition,
        Kind::DeadStep,
        Kind::Selection,
        Kind::Reentry,
        Kind::Home,
    ];

    /// The word for it.
    pub fn name(self) -> &'static str {
        match self {
            Kind::Livelock => "livelock",
            Kind::Deadlock => "deadlock",
            Kind::Home => "home",
            Kind::Conflict => "conflict",
            Kind::DeadTransition => "dead-transition",
            Kind::DeadStep => "dead-step",
            Kind::Selection => "selection",
            Kind::Reentry => "reentry",
            Kind::Assert => "assert",
            Kind::Leads => "leads",
            Kind::Reach => "reach",
        }
    }

    /// Whether one that fails is only told: it may well be meant.
    pub fn is_note(self) -> bool {
        match self {
            Kind::Selection | Kind::Reentry | Kind::Home => true,
            Kind::Livelock
            | Kind::Deadlock
            | Kind::Conflict
            | Kind::DeadTransition
            | Kind::DeadStep
            | Kind::Assert
            | Kind::Leads
            | Kind::Reach => false,
        }
    }
}

/// A claim.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct Claim {
    /// What kind of claim it is.
    pub kind: Kind,
    /// What it is called by: for one that is always asked, its kind, and what it is about.
    pub name: String,
    /// The step, by its label, the transition, by its designation or place, or what else it is about.
    pub element: Option<String>,
    /// Where that stands in the chart.
    pub span: Option<Span>,
    pub(crate) when: When,
}

/// When a claim holds.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum When {
    /// If nothing meets the goal.
    Never(Goal),
    /// If something meets it.
    Sometime(Goal),
}

impl When {
    pub(crate) fn goal(self) -> Goal {
        match self {
            When::Never(goal) | When::Sometime(goal) => goal,
        }
    }
}

/// A transition by its designation, or by its number.
pub(crate) fn designation(program: &Program, t: TransitionId) -> String {
    let designation = &program.elements.transitions[t].designation;
    designation.as_ref().map_or_else(|| format!("#{}", t.index() + 1), |designation| format!("({designation})"))
}

/// The claims that are always asked; of one kind in order of declaration.
pub(crate) fn always_asked(program: &Program) -> Vec<Claim> {
    let mut claims = Vec::new();
    let seen = program.observing.iter().flat_map(|observing| &observing.transitions);
    let transitions: Vec<TransitionId> = seen.map(|seen| seen.transition).collect();
    let mut entered = vec![false; program.steps.len()];
    let mut left = vec![0_usize; program.steps.len()];
    let is_of_chart = |s: &&StepId| s.index() < program.steps.len();
    for t in &transitions {
        let (before, after) = program.elements.around(*t);
        for s in before.iter().filter(is_of_chart) {
            left[s.index()] += 1;
        }
        for s in after.iter().filter(is_of_chart) {
            entered[s.index()] = true;
        }
    }
    let of_chart = |kind: Kind, goal: Goal| Claim {
        kind,
        name: kind.name().to_string(),
        element: None,
        span: None,
        when: When::Never(goal),
    };
    let of_step = |kind: Kind, s: StepId, when: When| {
        let step = &program.steps[s];
        let (element, span) = (Some(step.label.to_string()), Some(step.span));
        Claim { kind, name: format!("{} {}", kind.name(), step.label), element, span, when }
    };
    for kind in Kind::ALWAYS {
        match kind {
            Kind::Livelock => claims.push(of_chart(kind, Goal::Fact(Fact::Livelock))),
            // What has no transitions never moves, and is not meant to.
            Kind::Deadlock if transitions.is_empty() => {}
            Kind::Deadlock => claims.push(of_chart(kind, Goal::Stuck)),
            Kind::Home => claims.push(of_chart(kind, Goal::Homeless)),
            Kind::Conflict => {
                for (element, fact) in [("allocations", Fact::AllocConflict), ("orders", Fact::ForceConflict)] {
                    let (element, name) = (Some(element.to_string()), format!("conflict of {element}"));
                    claims.push(Claim { element, name, ..of_chart(kind, Goal::Fact(fact)) });
                }
            }
            Kind::DeadTransition => claims.extend(transitions.iter().map(|t| {
                let element = designation(program, *t);
                let name = format!("{} {element}", kind.name());
                let span = Some(program.elements.transitions[*t].span);
                Claim { kind, name, element: Some(element), span, when: When::Sometime(Goal::Fact(Fact::Cleared(*t))) }
            })),
            Kind::DeadStep => claims
                .extend(program.steps.indices().map(|s| of_step(kind, s, When::Sometime(Goal::Fact(Fact::Active(s)))))),
            Kind::Selection => {
                let steps = program.steps.indices().filter(|s| left[s.index()] > 1);
                claims.extend(steps.map(|s| of_step(kind, s, When::Never(Goal::Fact(Fact::Selection(s))))));
            }
            Kind::Reentry => {
                let steps = program.steps.indices().filter(|s| entered[s.index()]);
                claims.extend(steps.map(|s| of_step(kind, s, When::Never(Goal::Fact(Fact::Reentry(s))))));
            }
            // They are written in the chart.
            Kind::Assert | Kind::Leads | Kind::Reach => {}
        }
    }
    claims
}

/// The claims that are written in the chart, in order of the text; what is assumed, and where it may end, is none to answer.
pub(crate) fn written(program: &Program) -> Vec<Claim> {
    let (mut assertions, mut wanted, mut leads) = (0, 0, 0);
    let next = |count: &mut usize| std::mem::replace(count, *count + 1);
    let claim = |claim: &SeenClaim| {
        let (kind, when) = match (claim.kind, claim.body) {
            (_, SeenBody::Leads(..)) => (Kind::Leads, When::Never(Goal::Lost(next(&mut leads)))),
            (ClaimKind::Assert, _) => (Kind::Assert, When::Never(Goal::Fact(Fact::Broken(next(&mut assertions))))),
            (ClaimKind::Reach, _) => (Kind::Reach, When::Sometime(Goal::Fact(Fact::Wanted(next(&mut wanted))))),
            (ClaimKind::Assume | ClaimKind::Final, _) => return None,
        };
        Some(Claim { kind, name: claim.name.to_string(), element: None, span: Some(claim.span), when })
    };
    program.claims.iter().filter_map(claim).collect()
}
