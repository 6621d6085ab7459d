//! What can never happen, where nothing goes on, and where nothing comes to rest.
//!
//! | file | what |
//! | --- | --- |
//! | `constant` | conditions that always hold or never |
//! | `possible` | steps that are never active, transitions that never clear, each with its cause |
//! | `region` | one grafcet by itself: its starts, what it lets clear |
//! | `situations` | the situations of a grafcet: those without a way out, steps that are entered while they are active, joins that never come about |
//! | `rings` | transitions that one row of inputs lets clear in a circle |
//!
//! What is said never to happen is proved: everything that could bring it about is counted as possible. What is said to
//! be possible comes with a way that leads there.

pub(crate) mod constant;
pub(crate) mod possible;
mod region;
pub(crate) mod rings;
pub(crate) mod situations;

use super::Analysis;
use super::together::questions::Questions;
use constant::Constant;
use possible::Never;
use rings::Ring;
use situations::Situations;

/// All of it.
#[derive(Clone)]
pub(crate) struct Liveness {
    pub(crate) constant: Vec<Constant>,
    pub(crate) never: Never,
    pub(crate) situations: Situations,
    pub(crate) rings: Vec<Ring>,
}

impl Liveness {
    /// Only what conditions say by themselves: what pulse orders may make of a situation is not looked into.
    pub(super) fn of_conditions(analysis: &Analysis) -> Self {
        let clears = analysis.net().transitions.iter().map(|_| false).collect();
        Liveness {
            constant: constant::find(&mut Questions::new(analysis)),
            never: Never { steps: Vec::new(), transitions: Vec::new(), clears },
            situations: Situations { reentries: Vec::new(), dead_ends: Vec::new() },
            rings: Vec::new(),
        }
    }
}

pub(super) fn find(analysis: &Analysis) -> Liveness {
    let mut asked = Questions::new(analysis);
    let constant = constant::find(&mut asked);
    let mut never = possible::find(&mut asked, &constant);
    let situations = situations::find(&mut asked, &mut never);
    // Where each call is one micro-step, going round is no livelock.
    let rings = if analysis.net().options.is_scan() { Vec::new() } else { rings::find(&mut asked, &never) };
    Liveness { constant, never, situations, rings }
}
