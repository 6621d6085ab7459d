//! Causes of changes of stored variables (R7).
//!
//! The value that a variable has after a micro-step k > 1 and had not before comes from the last action of k. That
//! action was not done in k - 1 (its event is new); or it was, and assigns another value now; or it was and another
//! action that comes later in the order and was done in k - 1 as well is not any more. Of events only a clearing can
//! occur in two micro-steps one after the other without anything new: a step that has been activated must be
//! deactivated before it can be activated again, and an event with edges needs one of them each time (its level, if it
//! has one, counts in the first micro-step only).

use super::causes::{Causes, Change, Way};
use super::situation::Ways;
use super::values::Occasion;
use grafc_model::chart::{Event, ExprId, ExprKind, Stored, TransitionId, Value, VariableId};
use grafc_net::Net;
use index_vec::IndexVec;

/// Adds the causes of all changes of stored variables.
pub(super) fn add(net: &Net, ways: &Ways, occasions: &IndexVec<ExprId, Occasion>, causes: &mut Causes) {
    let goes_on = |event: &Event| match event {
        Event::Clearing(t) => ways.goes_on(*t),
        Event::Event(..) | Event::Deactivation(_) | Event::Activation(_) | Event::EachScan(..) => false,
    };
    let mut lasting: IndexVec<VariableId, bool> = net.variables.iter().map(|_| false).collect();
    for action in net.stored.iter().filter(|a| goes_on(&a.event)) {
        lasting[action.target] = true;
    }
    for (index, action) in net.stored.iter().enumerate() {
        let done = match action.event {
            Event::Activation(s) => Change::Activated(s),
            Event::Deactivation(s) => Change::Deactivated(s),
            Event::Clearing(t) => Change::Clears(t),
            // There a call is one micro-step, and how many it could be nobody asks (E0419).
            Event::EachScan(..) => continue,
            Event::Event(_, e) => {
                causes.start(Change::Occurs(index));
                occurs(net, occasions, e, Change::Occurs(index), causes);
                Change::Occurs(index)
            }
        };
        change(net, action, done, causes);
        if goes_on(&action.event) {
            for way in Way::BOTH {
                causes.at_once(Change::Expr(action.value, way), Change::Differs(index));
            }
            causes.at_once(Change::Subsides(action.target), Change::Differs(index));
            change(net, action, Change::Differs(index), causes);
        }
        if lasting[action.target] {
            match action.event {
                Event::Clearing(t) => stops(net, t, Change::Subsides(action.target), causes),
                Event::Activation(_) => causes.next(done, Change::Subsides(action.target)),
                // These come before clearings in the order of R7.
                Event::Deactivation(_) | Event::Event(..) | Event::EachScan(..) => {}
            }
        }
    }
}

/// A transition that has cleared does not clear again, whatever the reason.
fn stops(net: &Net, t: TransitionId, effect: Change, causes: &mut Causes) {
    let transition = &net.transitions[t];
    causes.at_once(Change::Stops(t), effect);
    causes.next(Change::Frozen(transition.grafcet), effect);
    for enclosing in &transition.within {
        causes.next(Change::Deactivated(*enclosing), effect);
    }
}

/// Which way the target can change if the action is done.
fn change(net: &Net, action: &Stored, done: Change, causes: &mut Causes) {
    let ways: &[Way] = match net.exprs[action.value].kind {
        ExprKind::Literal(Value::Bool(true)) => &[Way::Up],
        ExprKind::Literal(Value::Bool(false)) => &[Way::Down],
        _ => &Way::BOTH,
    };
    for way in ways {
        causes.at_once(done, Change::Variable(action.target, *way));
    }
}

/// An event needs one of its edges.
fn occurs(net: &Net, occasions: &IndexVec<ExprId, Occasion>, e: ExprId, event: Change, causes: &mut Causes) {
    if occasions[e] != Occasion::Level {
        causes.at_once(Change::Expr(e, Way::Up), event);
        return;
    }
    let mut open = vec![e];
    while let Some(e) = open.pop() {
        match net.exprs[e].kind {
            ExprKind::Rise(_) | ExprKind::Fall(_) => causes.at_once(Change::Expr(e, Way::Up), event),
            _ => open.extend(net.exprs[e].kind.operands()),
        }
    }
}
