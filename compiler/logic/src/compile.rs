//! The scan program of a flat net, put together section by section.

use crate::analysis::components::{self, Components};
use crate::analysis::transients::{self, Known};
use crate::encode;
use crate::encode::first_call::first_call;
use crate::encode::input_event::InputEvent;
use crate::encode::outputs;
use crate::encode::stored::heading;
use crate::encode::task::Task;
use crate::lower::{Context, Lowering, Moment};
use crate::options::{Encoding, Options};
use crate::scan::{Flag, Limit, Program, Repeat, Role};
use crate::tidy::{absorb, idle_delays, long_chains, sweep};
use crate::warn::overlap;
use grafc_diagnostics::Diagnostics;
use grafc_formula::{FormulaId, Type};
use grafc_model::chart::{Event, TransitionId};
use grafc_model::reaction::Evolution;
use grafc_net::Net;
use index_vec::IndexVec;
use rustc_hash::FxHashMap;

/// The scan program of a flat net under one encoding.
pub fn compile(net: &Net, options: &Options) -> (Option<Program>, Diagnostics) {
    let mut diagnostics = Diagnostics::new();
    let mut lowering = Lowering::new(net, None);
    let mut cx = Context::new(Moment::MicroStep);
    let mut roots = Roots::new(&mut lowering, &mut cx);
    let analysed = components::analyse(net, &lowering.pool, &lowering.edges, &roots.conditions);
    let transients = (options.simplify && !options.encoding.overlaps())
        .then(|| transients::analyse(net, &Known::new(&lowering, &roots.conditions, &analysed.components)));
    let mut followers = None;
    if options.encoding == Encoding::Switch {
        // Now that it is known which steps share a state, once more with these.
        lowering = Lowering::new(net, Some(&analysed.cover));
        followers = Some(outputs::followers(&mut lowering));
        cx = Context::new(Moment::MicroStep);
        roots = Roots::new(&mut lowering, &mut cx);
    }
    if options.encoding.overlaps()
        && let Some(warning) = overlap::check(net, options, &analysed.components)
    {
        diagnostics.push(warning);
    }
    // Where steps overlap, those of a component are active together for one micro-step.
    let proofs = options.simplify && !options.encoding.overlaps();
    let components = if proofs { analysed.components } else { Components::none(net) };

    if proofs {
        absorb::restrict(&mut lowering, &components, &mut roots.conditions);
        // In `switch` a condition is only looked at while its step is active; a shared one would be always.
        if options.encoding != Encoding::Switch {
            let shared = absorb::share(&mut lowering, &mut roots.conditions);
            cx.statements.extend(shared);
        }
    }

    // What a pass has added does not count.
    let auxiliary = net.places.iter().filter(|place| place.auxiliary).count();
    let (steps, transitions) = (net.places.len() - auxiliary, net.transitions.len() - auxiliary);
    let bound = options.profile.bound_for(steps, transitions).clamp(1, i32::MAX as u32);
    let ends = transients.as_ref().is_some_and(|t| t.ends_within(bound));
    let once = ends && transients.as_ref().is_some_and(|t| t.single);
    let repeat = (options.profile.evolution == Evolution::Stable && !once).then(|| {
        let again = lowering.symbols.fresh(Role::Temporary, "again", Type::Bool, None);
        let limit = (!ends).then(|| {
            let wide_enough = if bound <= i16::MAX as u32 { Type::Int } else { Type::Dint };
            let count = lowering.symbols.fresh(Role::Temporary, "micro_steps", wide_enough, None);
            Limit { count, bound, flag: lowering.symbols.flag(Flag::Livelock) }
        });
        Repeat { again, limit }
    });

    let mut micro_step = Vec::new();
    heading(&mut micro_step, "conditions", std::mem::take(&mut cx.statements));
    let mut input_event = InputEvent::default();
    let task = Task {
        encoding: options.encoding,
        simplify: options.simplify,
        conditions: &roots.conditions,
        events: &roots.events,
        components: &components,
        followers: followers.as_ref(),
        again: repeat.map(|r| r.again),
    };
    micro_step.extend(encode::micro_step(&mut lowering, &mut cx, &task, &mut input_event));
    // Timers of durations are known only now that every moment that reads them has been lowered.
    let mut after = Vec::new();
    heading(&mut after, "outputs", outputs::statements(&mut lowering, followers.as_ref()));
    micro_step.extend(lowering.call_step_timers());
    if repeat.is_some() {
        micro_step.extend(input_event.over(&mut lowering));
    }

    let (first, started) = first_call(&mut lowering, options.profile, followers.as_ref(), &input_event);
    let mut before = lowering.call_step_timers();
    before.extend(input_event.found(&mut lowering));

    let mut program = Program {
        name: net.name.clone(),
        comment: net.comment.clone(),
        steps: lowering.situation.of_chart(net),
        states: lowering.situation.states(),
        variables: lowering.symbols.table,
        timers: lowering.timers,
        pool: lowering.pool,
        first,
        started,
        before,
        micro_step,
        repeat,
        after,
    };
    if options.simplify {
        absorb::absorb(&mut program);
        idle_delays::rest(&mut program);
    }
    sweep::sweep(&mut program);
    long_chains::cut(&mut program);
    debug_assert_eq!(crate::scan::verify(&program), Ok(()), "the program as compiled");
    (Some(program), diagnostics)
}

/// What a micro-step evaluates: every condition has to be known before its first statement, because the operands of all
/// edges are compared at once.
struct Roots {
    conditions: IndexVec<TransitionId, FormulaId>,
    /// Expressions of actions on an event, by the number of the action.
    events: FxHashMap<usize, FormulaId>,
}

impl Roots {
    fn new(lowering: &mut Lowering, cx: &mut Context) -> Self {
        let net = lowering.net;
        let conditions = net.transitions.iter().map(|t| lowering.expr(cx, t.condition)).collect();
        let mut events = FxHashMap::default();
        for (index, action) in net.stored.iter().enumerate() {
            if let Event::Event(_, e) = action.event {
                events.insert(index, lowering.expr(cx, e));
            }
            lowering.prepare(cx, action.value, true);
        }
        for action in &net.continuous {
            if let Some(condition) = action.condition {
                lowering.prepare(cx, condition, false);
            }
        }
        Roots { conditions, events }
    }
}
