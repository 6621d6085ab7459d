//! The scan program of a flat net, put together section by section.

use crate::analysis::components::Components;
use crate::analysis::transients::Transients;
use crate::analysis::{Analysis, Conditions};
use crate::encode;
use crate::encode::claims;
use crate::encode::controls;
use crate::encode::first_call::first_call;
use crate::encode::heading::heading;
use crate::encode::input_event::InputEvent;
use crate::encode::livelock::{self, Overriding};
use crate::encode::observe::Watch;
use crate::encode::outputs;
use crate::encode::restoring::restoring;
use crate::encode::task::Task;
use crate::lower::Lowering;
use crate::lower::cover::is_small;
use crate::options::{Encoding, Options};
use crate::scan::{Claimed, Elements, Flag, Heading, Limit, Observed, Program, Repeat, Role, Statement};
use crate::tidy::{absorb, idle_delays, join, long_chains, once, sweep};
use crate::warn::overlap;
use grafc_diagnostics::Diagnostics;
use grafc_formula::Type;
use grafc_model::reaction::{Evolution, Profile};
use grafc_net::Net;
use index_vec::IndexVec;
use std::sync::Arc;

/// The scan program of a flat net under one encoding, and a warning where that encoding does not do exactly what the
/// rules say. What is proved is used up; keep a copy to compile again.
pub fn compile(analysis: Analysis, options: &Options) -> (Program, Diagnostics) {
    make(analysis, options, Extras::default())
}

/// The same for a target that saves memory: with what gives it back, and quick.
pub fn compile_saved(analysis: Analysis, options: &Options) -> (Program, Diagnostics) {
    make(analysis, options, Extras { saved: true, quick: true, ..Extras::default() })
}

/// The same with what gives saved memory back, and with what is shown of micro-steps; where all is shown, claims as well.
///
/// Where a micro-step more would find nothing to do, it is done all the same: who looks on sees each of R9.
pub fn compile_observed(analysis: Analysis, options: &Options, observed: Observed) -> (Program, Diagnostics) {
    let claims = if observed == Observed::All { Claimed::All } else { Claimed::Nothing };
    make(analysis, options, Extras { saved: true, observed, claims, ..Extras::default() })
}

/// The same with all that is asked for.
pub fn compile_with(analysis: Analysis, options: &Options, extras: Extras) -> (Program, Diagnostics) {
    make(analysis, options, extras)
}

/// What is asked for beside a call.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub struct Extras {
    /// What gives saved memory back.
    pub saved: bool,
    /// What is shown of micro-steps.
    pub observed: Observed,
    /// Which claims are computed.
    pub claims: Claimed,
    /// Outputs of a small chart follow its states, too, where they can: written where a state moves, as by hand, they cost
    /// nothing while none does. On a controller, where they are read beside the chart, computed ones say more.
    pub quick: bool,
}

fn make(analysis: Analysis, options: &Options, extras: Extras) -> (Program, Diagnostics) {
    let mut diagnostics = Diagnostics::new();
    // What the heading chooses goes before.
    let options = &Options { profile: analysis.net().options.over(options.profile), ..*options };
    let is_small = is_small(analysis.net());
    // When this is done, the net is gone: what follows asks the program alone.
    let controls = analysis.net().controls;
    let (mut program, held) = assemble(analysis, options, extras, &mut diagnostics);
    if options.simplify {
        absorb::absorb(&mut program);
        // A small chart calls all of them, which takes fewer lines; and who looks on sees all of them.
        let is_asked = extras.claims != Claimed::Nothing || controls.assertion.is_some();
        if !is_small && extras.observed == Observed::Nothing && !is_asked {
            idle_delays::rest(&mut program);
        }
        once::once(&mut program);
    }
    program.first.splice(0..0, held);
    controls::add(&mut program, controls);
    join::join(&mut program);
    sweep::sweep(&mut program);
    long_chains::cut(&mut program);
    program.pool.shrink_to_fit();
    debug_assert_eq!(crate::scan::verify(&program), Ok(()), "the program as compiled");
    (program, diagnostics)
}

/// The sections of the program, each as it comes about by itself; and what stands before all others.
fn assemble(
    analysis: Analysis,
    options: &Options,
    extras: Extras,
    diagnostics: &mut Diagnostics,
) -> (Program, Vec<Statement>) {
    // Where steps overlap, those of a component are active together for one micro-step: what is proved does not hold.
    let overlaps = options.encoding.overlaps();
    let proofs = options.simplify && !overlaps;
    let evolution = Ends::new(analysis.net(), options.profile, proofs.then(|| analysis.transients()));
    if overlaps {
        if let Some(warning) = overlap::check(&analysis, options) {
            diagnostics.push(warning);
        }
    }

    let (mut net, arcs, mut conditions, components, cover) = analysis.into_parts();
    let mut followers = None;
    if options.encoding == Encoding::Switch {
        // Now that it is known which steps share a state, once more with these.
        let cover = cover.with_lone(|s| components.covers(s));
        let mut lowering = Lowering::new(net.clone(), Some(&cover), options.simplify);
        let outputs_follow = !livelock::may_override(options.profile, evolution.ends);
        followers = Some(outputs::followers(&mut lowering, outputs_follow, extras.quick));
        conditions = Conditions::new(lowering);
    }
    let components = if proofs { components } else { Components::none(&net) };
    let Conditions { mut lowering, mut cx, mut of_transition, of_event, of_pulse } = conditions;
    let mut watch = Watch::new(extras.observed);
    let as_in_chart = watch.is_some().then(|| of_transition.clone());
    if proofs {
        absorb::restrict(&mut lowering, &components, &mut of_transition);
        // In `switch` a condition is only looked at while its step is active; a shared one would be always.
        if options.encoding != Encoding::Switch {
            let shared = absorb::share(&mut lowering, &mut of_transition);
            cx.statements.extend(shared);
        }
    }
    let is_seen = watch.is_some() && options.profile.evolution == Evolution::Stable;
    let repeat = (is_seen || evolution.repeats(options.profile)).then(|| {
        let again = lowering.symbols.fresh(Role::Temporary, "again", Type::Bool, None);
        let limit = (!evolution.ends).then(|| {
            let wide_enough = if evolution.bound <= i16::MAX as u32 { Type::Int } else { Type::Dint };
            let count = lowering.symbols.fresh(Role::Temporary, "micro_steps", wide_enough, None);
            Limit { count, bound: evolution.bound, flag: lowering.symbols.flag(Flag::Livelock) }
        });
        Repeat { again, limit }
    });

    let mut micro_step = Vec::new();
    heading(&mut micro_step, Heading::Conditions, std::mem::take(&mut cx.statements));
    let mut input_event = InputEvent::default();
    let task = Task {
        encoding: options.encoding,
        simplify: options.simplify,
        arcs: &arcs,
        conditions: &of_transition,
        events: &of_event,
        pulses: &of_pulse,
        components: &components,
        followers: followers.as_ref(),
        again: repeat.map(|r| r.again),
    };
    if let (Some(watch), Some(conditions)) = (&mut watch, &as_in_chart) {
        micro_step.extend(watch.before(&mut lowering, &task, conditions, &mut input_event));
    }
    encode::micro_step(&mut lowering, &mut cx, &task, &mut input_event, &mut micro_step);
    drop((arcs, components));
    // Timers of durations are known only now that every moment that reads them has been lowered.
    let mut after = outputs::statements(&mut lowering, followers.as_ref());
    let overriding = repeat.map(|r| r.again).filter(|_| livelock::may_override(options.profile, evolution.ends));
    if let Some(watch) = &mut watch {
        after.extend(watch.with_outputs(&mut lowering));
    }
    let mut overriding = overriding.map_or_else(Overriding::default, |again| {
        let seen = watch.as_ref().map(|watch| watch.acting_on_outputs(&lowering)).unwrap_or_default();
        livelock::statements(&mut lowering, options.profile, again, seen, extras.saved)
    });
    let claimed = claims::lower(&mut lowering, |_| extras.claims == Claimed::All);
    after.extend(claimed.after);
    let cut_off = repeat.filter(|repeat| repeat.limit.is_some()).map(|repeat| repeat.again);
    after.extend(claims::check(&mut lowering, cut_off));
    after.append(&mut overriding.after);
    if let Some(watch) = &mut watch {
        micro_step.extend(watch.after_micro_step(&mut lowering, options.profile));
    }
    micro_step.extend(lowering.call_step_timers());
    if repeat.is_some() {
        micro_step.extend(input_event.over(&mut lowering));
    }

    let (mut first, started) = first_call(&mut lowering, options.profile, followers.as_ref(), &input_event);
    if let Some(watch) = &watch
        && let (Some(at_start), Some(Statement::If(choice))) = (watch.at_start(&mut lowering), first.last_mut())
    {
        choice.branches.iter_mut().for_each(|(_, body)| body.push(at_start.clone()));
    }
    let mut before = encode::momentary::statements(&mut lowering);
    before.extend(lowering.call_step_timers());
    before.extend(input_event.found(&mut lowering));
    before.extend(claimed.before);

    let restoring = extras.saved.then(|| {
        // Steps that overlap are active together, whatever excludes each other by the rules.
        let cover = Some(&cover).filter(|_| !overlaps);
        let seen = watch.as_mut().map(|watch| watch.restored(&mut lowering)).unwrap_or_default();
        let calls = [&first[..], &before, &micro_step, &after];
        restoring(&mut lowering, started, calls, cover, seen, overriding.restored.take())
    });

    let most = match repeat {
        None => 1,
        Some(Repeat { limit: Some(limit), .. }) => limit.bound,
        // One that is there only to be seen finds nothing to do.
        Some(Repeat { limit: None, .. }) => evolution.longest.max(if evolution.once { 2 } else { 1 }),
    };
    let observing = watch.map(|watch| watch.finish(&lowering));
    let assertion = net.controls.assertion.map(|assertion| lowering.symbols.declared(assertion));
    // From here on the program takes the place of what it was made of: a chart with many steps has no room for both.
    drop((cover, cx, of_transition, of_event, of_pulse));
    let (symbols, situation, timers, pool) = lowering.into_parts();
    if let Some(net) = Arc::get_mut(&mut net) {
        (net.variables, net.exprs) = (IndexVec::new(), IndexVec::new());
    }
    let (steps, states) = (situation.of_chart(&net), situation.states());
    drop(situation);
    let mut elements = Elements::of(&net);
    if options.encoding == Encoding::Switch {
        elements.find_setters(&net);
    }
    let program = Program {
        name: net.name.to_string(),
        comment: net.comment.clone(),
        steps,
        states,
        elements,
        variables: symbols.table,
        timers,
        pool,
        first,
        started,
        before,
        micro_step,
        repeat,
        most,
        after,
        restoring,
        observing,
        claims: claimed.seen,
        assertion,
    };
    (program, overriding.kept)
}

/// Whether an evolution of a call ends by itself (R9).
struct Ends {
    /// The bound on micro-steps.
    bound: u32,
    /// Whether it is proved that no evolution hits it.
    ends: bool,
    /// Whether it is proved that a second micro-step never does anything.
    once: bool,
    /// How many micro-steps the longest evolution takes, or the bound.
    longest: u32,
}

impl Ends {
    fn new(net: &Net, profile: Profile, proved: Option<&Transients>) -> Ends {
        // What a pass has added does not count.
        let steps = net.places.iter().filter(|place| !place.auxiliary).count();
        let transitions = net.transitions.iter().filter(|transition| !transition.auxiliary).count();
        let bound = profile.bound_for(steps, transitions).clamp(1, i32::MAX as u32);
        let ends = proved.is_some_and(|transients| transients.ends_within(bound));
        let longest = proved.and_then(|transients| transients.longest).unwrap_or(bound);
        Ends { bound, ends, longest, once: ends && proved.is_some_and(|transients| transients.single) }
    }

    fn repeats(&self, profile: Profile) -> bool {
        match profile.evolution {
            Evolution::Scan => false,
            Evolution::Stable => !self.once,
        }
    }
}

impl Analysis {
    /// Whether a call may need several micro-steps, under an encoding without overlap.
    pub(crate) fn may_repeat(&self, profile: Profile) -> bool {
        let profile = self.net().options.over(profile);
        profile.evolution == Evolution::Stable
            && Ends::new(self.net(), profile, Some(self.transients())).repeats(profile)
    }
}
