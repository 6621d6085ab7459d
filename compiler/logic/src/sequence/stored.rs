//! What the steps of a sequential function chart store.
//!
//! GRAFCET does all that is stored at once: right sides see the values and the situation of before, and what is done each
//! scan comes last (R7, R15). In a sequential function chart actions are done one after the other, tools differ in the
//! order, and steps have changed when they are done. So what would depend on any of that is refused, unless an order
//! within one action makes it right.

use super::expressions::Expressions;
use super::{Assignment, Reasons, SequenceStep, When};
use crate::analysis::Analysis;
use grafc_diagnostics::Span;
use grafc_formula::FormulaId;
use grafc_model::chart::{Event, ExprId, ExprKind, Mode, StepId, Type, Value, VariableId};
use grafc_net::Net;
use index_vec::IndexVec;
use rustc_hash::{FxHashMap, FxHashSet};

/// Of more actions on one variable not all pairs are compared.
const COMPARED: usize = 64;

/// A stored action of a step.
struct Deed {
    step: StepId,
    when: When,
    /// Whether it is one of those each scan, which see what the others have stored (R15).
    last: bool,
    /// The factors of its condition.
    guard: Vec<ExprId>,
    target: VariableId,
    value: ExprId,
    span: Span,
}

/// The actions that store into a variable.
#[derive(Default)]
struct Writers {
    places: Vec<usize>,
    /// Whether all are of one class, and whether all stand in one action of a step.
    one_class: bool,
    one_moment: bool,
}

/// The actions by what they store into.
fn writers(deeds: &[Deed]) -> FxHashMap<VariableId, Writers> {
    let mut writers: FxHashMap<VariableId, Writers> = FxHashMap::default();
    for (place, deed) in deeds.iter().enumerate() {
        let known = writers.entry(deed.target).or_default();
        let first = known.places.first().map_or(deed, |first| &deeds[*first]);
        known.one_class = (known.one_class || known.places.is_empty()) && same_class(first, deed);
        known.one_moment = (known.one_moment || known.places.is_empty()) && same_moment(first, deed);
        known.places.push(place);
    }
    writers
}

/// Notes with the steps what they store.
pub(super) fn stored(
    analysis: &Analysis,
    steps: &mut IndexVec<StepId, SequenceStep>,
    expressions: &mut Expressions,
    reasons: &mut Reasons,
) {
    let net = analysis.net();
    let deeds = deeds(net, reasons);
    let writers = writers(&deeds);
    let meet = |a: &Deed, b: &Deed| meet(analysis, a, b);
    for (place, deed) in deeds.iter().enumerate() {
        let others = &writers[&deed.target];
        let clashes = |other: &usize| {
            let other = &deeds[*other];
            !same_class(deed, other) && !same_constant(net, deed, other) && meet(deed, other)
        };
        if !others.one_class && (others.places.len() > COMPARED || others.places.iter().any(clashes)) {
            reasons
                .add(deed.span, "may be done in one scan with another action on the same variable, in whatever order");
        }
        if reads_of_others(net, &deeds, place, &writers, meet) {
            reasons.add(deed.span, "reads what another action stores");
        }
    }
    let latched = latched(net, &deeds, &writers);
    let grouped = groups(&deeds);
    for group in sorted(net, &deeds, &grouped, reasons) {
        let (step, when, target) = {
            let first = &deeds[grouped[group][0]];
            (first.step, first.when, first.target)
        };
        let variable = expressions.declared(target);
        if latched.contains(&target) {
            let set = |place: &usize| net.exprs[deeds[*place].value].kind == ExprKind::Literal(Value::Bool(true));
            steps[step].latches.extend(grouped[group].iter().map(|place| (variable, set(place))));
            continue;
        }
        let mut cases = Vec::new();
        for deed in grouped[group].iter().map(|place| &deeds[*place]) {
            let factors: Vec<FormulaId> =
                deed.guard.iter().map(|factor| expressions.deed(*factor, step, when, reasons)).collect();
            let guard = (!factors.is_empty()).then(|| expressions.pool.and(factors));
            cases.push((guard, expressions.deed(deed.value, step, when, reasons)));
        }
        // What is done in any case is what is left where no condition holds.
        cases.sort_by_key(|(guard, _)| guard.is_none());
        steps[step].stored.push(Assignment { when, target: variable, cases });
    }
}

/// Whether two actions give a variable the same constant.
fn same_constant(net: &Net, a: &Deed, b: &Deed) -> bool {
    let kind = |deed: &Deed| &net.exprs[deed.value].kind;
    matches!(kind(a), ExprKind::Literal(_)) && kind(a) == kind(b)
}

/// The stored actions that steps can have.
fn deeds(net: &Net, reasons: &mut Reasons) -> Vec<Deed> {
    let mut deeds = Vec::new();
    for action in &net.stored {
        let mut guard = Vec::new();
        let (step, when) = match action.event {
            Event::Activation(step) => (step, When::Activation),
            Event::Deactivation(step) => (step, When::Deactivation),
            Event::EachScan(step, condition) => {
                guard = condition.map(|condition| factors(net, condition)).unwrap_or_default();
                let all = guard.len();
                // In the scan of its activation a step was not active before.
                guard.retain(|factor| !is_entry(net, *factor, step));
                (step, if guard.len() < all { When::Activation } else { When::EachScan })
            }
            Event::Event(..) => {
                reasons.add(action.span, "an action on an event");
                continue;
            }
            Event::Clearing(_) => {
                reasons.add(action.span, "an action on a clearing");
                continue;
            }
        };
        if when == When::Activation && net.places[step].initial {
            reasons.add(
                action.span,
                "an action on the activation of an initial step, which some tools leave out at the start",
            );
        }
        let last = matches!(action.event, Event::EachScan(..));
        deeds.push(Deed { step, when, last, guard, target: action.target, value: action.value, span: action.span });
    }
    deeds
}

/// The factors of a condition, in order.
fn factors(net: &Net, condition: ExprId) -> Vec<ExprId> {
    let (mut open, mut found) = (vec![condition], Vec::new());
    while let Some(id) = open.pop() {
        match net.exprs[id].kind {
            ExprKind::And(a, b) => open.extend([b, a]),
            _ => found.push(id),
        }
    }
    found
}

/// Whether a condition says that a step was not active before.
fn is_entry(net: &Net, condition: ExprId, step: StepId) -> bool {
    match net.exprs[condition].kind {
        ExprKind::Not(inner) => net.exprs[inner].kind == ExprKind::StepActive(step),
        _ => false,
    }
}

/// Whether two actions may be done in one scan.
fn meet(analysis: &Analysis, a: &Deed, b: &Deed) -> bool {
    let leaves = |deed: &Deed| deed.when == When::Deactivation;
    match (leaves(a), leaves(b)) {
        _ if a.step == b.step => leaves(a) == leaves(b),
        (false, false) | (true, true) => !analysis.never_together(a.step, b.step),
        (true, false) => !analysis.never_together(a.step, b.step) || leads(analysis, a.step, b.step),
        (false, true) => !analysis.never_together(a.step, b.step) || leads(analysis, b.step, a.step),
    }
}

/// Whether a transition leads from a step to another.
fn leads(analysis: &Analysis, from: StepId, to: StepId) -> bool {
    let transitions = analysis.arcs.out_of_step(from).iter();
    transitions.flat_map(|t| &analysis.net().transitions[*t].post).any(|after| *after == to)
}

/// Whether an action reads what one that is none of its step's at that moment stores in the same scan: there is no order
/// to rely on.
fn reads_of_others(
    net: &Net,
    deeds: &[Deed],
    place: usize,
    writers: &FxHashMap<VariableId, Writers>,
    meet: impl Fn(&Deed, &Deed) -> bool,
) -> bool {
    let deed = &deeds[place];
    reads(net, deed).into_iter().any(|read| {
        let Some(others) = writers.get(&read) else { return false };
        let is_own = |other: &usize| same_moment(deed, &deeds[*other]);
        if read == deed.target && others.one_class || others.one_moment && others.places.iter().take(1).all(is_own) {
            return false;
        }
        others.places.len() > COMPARED || others.places.iter().any(|other| !is_own(other) && meet(deed, &deeds[*other]))
    })
}

/// Whether two assignments stand in one action of a step.
fn same_moment(a: &Deed, b: &Deed) -> bool {
    a.step == b.step && same_class(a, b)
}

/// Whether two assignments are of one class (R7), and done at the same moment.
fn same_class(a: &Deed, b: &Deed) -> bool {
    (a.when, a.last) == (b.when, b.last)
}

/// The places of what one action of a step stores into one variable, in order of declaration.
fn groups(deeds: &[Deed]) -> Vec<Vec<usize>> {
    let mut known: FxHashMap<(StepId, When, VariableId), usize> = FxHashMap::default();
    let mut groups: Vec<Vec<usize>> = Vec::new();
    for (place, deed) in deeds.iter().enumerate() {
        let group = *known.entry((deed.step, deed.when, deed.target)).or_insert(groups.len());
        match groups.get_mut(group) {
            Some(group) => group.push(place),
            None => groups.push(vec![place]),
        }
    }
    groups
}

/// The groups in order of declaration, but who reads what another of the same action stores before that one.
fn sorted(net: &Net, deeds: &[Deed], groups: &[Vec<usize>], reasons: &mut Reasons) -> Vec<usize> {
    let of: FxHashMap<(StepId, When, VariableId), usize> = groups
        .iter()
        .enumerate()
        .map(|(group, places)| {
            let deed = &deeds[places[0]];
            ((deed.step, deed.when, deed.target), group)
        })
        .collect();
    // What has to come before each.
    let mut before: Vec<Vec<usize>> = vec![Vec::new(); groups.len()];
    for (group, places) in groups.iter().enumerate() {
        for deed in places.iter().map(|place| &deeds[*place]) {
            let read = reads(net, deed).into_iter().filter(|read| *read != deed.target);
            let written = read.filter_map(|read| of.get(&(deed.step, deed.when, read)));
            written.for_each(|other| before[*other].push(group));
        }
    }
    #[derive(Clone, Copy, PartialEq)]
    enum State {
        New,
        Open,
        Done,
    }
    let mut states = vec![State::New; groups.len()];
    let mut sorted = Vec::with_capacity(groups.len());
    for root in 0..groups.len() {
        if states[root] != State::New {
            continue;
        }
        states[root] = State::Open;
        let mut open = vec![(root, 0)];
        while let Some((group, next)) = open.last_mut() {
            let Some(&first) = before[*group].get(*next) else {
                states[*group] = State::Done;
                sorted.push(*group);
                open.pop();
                continue;
            };
            *next += 1;
            match states[first] {
                State::New => {
                    states[first] = State::Open;
                    open.push((first, 0));
                }
                State::Open => reasons.add(
                    deeds[groups[first][0]].span,
                    "reads what another action stores, which reads what this one stores",
                ),
                State::Done => {}
            }
        }
    }
    sorted
}

/// The Boolean variables that steps only set and reset on activation. Where one step at most is active, `S` and `R` mean
/// the same: else a step that stays active would set its variable again.
fn latched(net: &Net, deeds: &[Deed], writers: &FxHashMap<VariableId, Writers>) -> FxHashSet<VariableId> {
    let is_sequential = net.places.iter().filter(|place| place.initial).count() <= 1
        && net.transitions.iter().all(|t| t.pre.len() == 1 && t.post.len() == 1);
    let latches = |(variable, writers): &(&VariableId, &Writers)| {
        let declared = &net.variables[**variable];
        declared.ty == Type::Bool
            && declared.mode == Mode::Stored
            && declared.initial() == Value::Bool(false)
            && !declared.retain
            && writers.places.iter().all(|place| {
                let deed = &deeds[*place];
                let is_literal = matches!(net.exprs[deed.value].kind, ExprKind::Literal(_));
                deed.when == When::Activation && deed.guard.is_empty() && is_literal
            })
    };
    let all = writers.iter().filter(|_| is_sequential).filter(latches);
    all.map(|(variable, _)| *variable).collect()
}

/// The variables that an action reads, each once.
fn reads(net: &Net, deed: &Deed) -> Vec<VariableId> {
    let (mut seen, mut found) = (FxHashSet::default(), Vec::new());
    let mut open: Vec<ExprId> = deed.guard.iter().copied().chain([deed.value]).collect();
    while let Some(id) = open.pop() {
        if !seen.insert(id) {
            continue;
        }
        open.extend(net.exprs[id].kind.operands());
        if let ExprKind::Variable(variable) = net.exprs[id].kind {
            found.push(variable);
        }
    }
    found.sort_unstable();
    found.dedup();
    found
}
