//! The scan program of a flat net, put together section by section.

use crate::allocate::{self, Place, Trigger, Triggers};
use crate::dormant;
use crate::encode::{self, Encoding, Task, switch};
use crate::formula::{FormulaId, Type};
use crate::input_event::InputEvent;
use crate::lower::{Context, Lowering, Moment};
use crate::outputs::{self, Followers};
use crate::overlap;
use crate::pieces;
use crate::scan::{Flag, Limit, Program, Repeat, Role, Statement};
use crate::simplify;
use crate::stored::heading;
use crate::sweep;
use crate::tokens::{self, Components};
use crate::transient::{self, Known};
use grafc_diagnostics::Diagnostics;
use grafc_model::chart::{Event, Mode, TransitionId, VariableKind};
use grafc_model::reaction::{Evolution, Profile};
use grafc_net::Net;
use index_vec::IndexVec;
use rustc_hash::FxHashMap;

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

/// The scan program of a flat net under one encoding.
pub fn compile(net: &Net, options: &Options) -> (Option<Program>, Diagnostics) {
    let mut diagnostics = Diagnostics::new();
    let mut lowering = Lowering::new(net, None);
    let mut cx = Context::new(Moment::MicroStep);
    let mut roots = Roots::new(&mut lowering, &mut cx);
    let analysed = tokens::analyse(net, &lowering.pool, &lowering.edges, &roots.conditions);
    let transients = (options.simplify && !options.encoding.overlaps())
        .then(|| transient::analyse(net, &Known::new(&lowering, &roots.conditions, &analysed.components)));
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
        simplify::restrict(&mut lowering, &components, &mut roots.conditions);
        // In `switch` a condition is only looked at while its step is active; a shared one would be always.
        if options.encoding != Encoding::Switch {
            let shared = simplify::share(&mut lowering, &mut roots.conditions);
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
            lowering.symbols.flag(Flag::Livelock);
            Limit { count, bound }
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
    micro_step.extend(step_timer_statements(&mut lowering));
    if repeat.is_some() {
        micro_step.extend(input_event.over(&mut lowering));
    }

    let first = first_section(&mut lowering, options.profile, followers.as_ref(), &input_event);
    let mut before = step_timer_statements(&mut lowering);
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
        before,
        micro_step,
        repeat,
        after,
    };
    if options.simplify {
        simplify::absorb(&mut program);
        dormant::rest(&mut program);
    }
    sweep::sweep(&mut program);
    pieces::cut(&mut program);
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

/// Brings the timers of step durations up to date with the situation.
fn step_timer_statements(lowering: &mut Lowering) -> Vec<Statement> {
    let timers: Vec<_> = lowering.step_timers.iter().map(|(s, t)| (*s, *t)).collect();
    timers.into_iter().map(|(s, timer)| Statement::CallTimer { timer, input: lowering.active(s) }).collect()
}

/// The initial reaction up to its first micro-step (R10), guarded from later calls.
fn first_section(
    lowering: &mut Lowering,
    profile: Profile,
    followers: Option<&Followers>,
    input_event: &InputEvent,
) -> Vec<Statement> {
    let net = lowering.net;
    let mut cx = Context::new(Moment::First);
    let yes = lowering.pool.truth(true);
    let mut body = Vec::new();
    for (s, place) in net.places.iter_enumerated() {
        if let Some(target) = lowering.situation.bit(s).filter(|_| place.initial) {
            body.push(Statement::Assign { target, value: yes, remark: None });
        }
    }
    if let Some(followers) = followers {
        body.extend(switch::start(lowering, followers));
    }
    if net.conflict_at_start {
        let target = lowering.symbols.flag(Flag::ForceConflict);
        body.push(Statement::Assign { target, value: yes, remark: None });
    }
    for (v, variable) in net.variables.iter_enumerated() {
        let kept = matches!(variable.kind, VariableKind::Output | VariableKind::Internal);
        if kept && variable.mode != Mode::Wire && variable.initial != crate::symbols::zero(variable.ty) {
            let value = lowering.pool.constant(variable.initial, variable.ty);
            body.push(Statement::Assign { target: lowering.symbols.declared(v), value, remark: None });
        }
    }
    if profile.initial_actions {
        let mut triggers = Triggers::new();
        for action in &net.stored {
            match action.event {
                Event::Activation(s) if net.places[s].initial => {
                    let trigger = Trigger { when: yes, value: action.value, place: Place::To(s), repeats: true };
                    triggers.entry(action.target).or_default().push(trigger);
                }
                Event::Event(..) | Event::Deactivation(_) | Event::Clearing(_) | Event::Activation(_) => {}
            }
        }
        for trigger in triggers.values().flatten() {
            lowering.prepare(&mut cx, trigger.value, true);
        }
        let allocations = allocate::statements(lowering, &mut cx, &triggers, None, None);
        body.append(&mut cx.statements);
        body.extend(allocations);
    }
    // What was defined for the actions no longer holds: edge operands see the variables that the actions have left.
    let mut cx = Context::new(Moment::First);
    for index in 0..lowering.edges.len() {
        let (operand, old) = (lowering.edges[index].operand, lowering.edges[index].old);
        let value = lowering.expr(&mut cx, operand);
        body.append(&mut cx.statements);
        body.push(Statement::Assign { target: old, value, remark: None });
    }
    body.extend(input_event.start(lowering));
    if body.is_empty() {
        return body;
    }
    let started =
        lowering.symbols.fresh(Role::Memory, "started", Type::Bool, Some("false until the first call".into()));
    let is_started = lowering.symbols.read(&mut lowering.pool, started);
    let at_first = lowering.pool.not(is_started);
    body.insert(0, Statement::Assign { target: started, value: yes, remark: None });
    vec![Statement::If { branches: vec![(at_first, body)], otherwise: Vec::new() }]
}
