//! What is done each scan (R15, kind S): after all other stored actions, whose results it sees, and in no conflict with them.
//!
//! ```text
//! when  = N of the step AND the condition               in the context of the micro-step, as of all other actions
//! value  reads variables as the others have left them    edges, delays and activities as in that context
//! ```

use crate::encode::allocate::{self, Position, Tokens, Trigger, Triggers};
use crate::encode::clearings::Clearings;
use crate::encode::task::Task;
use crate::lower::{Context, Lowering};
use crate::scan::{ActionId, Origin, Role, Statement, VarId};
use ecow::eco_format;
use grafc_formula::Type;
use grafc_model::chart::Event;
use grafc_net::Net;

/// Whether a chart has any such action.
pub(crate) fn any(net: &Net) -> bool {
    net.stored.iter().any(|action| matches!(action.event, Event::EachScan(..)))
}

/// When each is done, found before any variable is written.
pub(super) fn triggers(
    lowering: &mut Lowering,
    task: &Task,
    clearings: &Clearings,
    statements: &mut Vec<Statement>,
) -> Triggers {
    let net = &*lowering.net.clone();
    let mut triggers = Triggers::new();
    for (index, action) in net.stored.iter().enumerate() {
        let Event::EachScan(s, _) = action.event else { continue };
        let origin = Origin::Action(ActionId::from(net.continuous.len() + index));
        let active = clearings.active_after(lowering, s);
        let condition = task.events.get(&index).copied();
        let mut when = lowering.pool.and([Some(active), condition].into_iter().flatten());
        if lowering.reads_written(when) {
            let name = eco_format!("scan_{}", net.places[s].label);
            let target = lowering.symbols.fresh(Role::Temporary, name, Type::Bool, None);
            statements.push(Statement::assign(origin, target, when));
            when = lowering.symbols.read(&mut lowering.pool, target);
        }
        let trigger = Trigger { when, value: action.value, origin, position: Position::To(s), repeats: false };
        triggers.entry(action.target).or_default().push(trigger);
    }
    triggers
}

/// The assignments.
pub(super) fn statements(
    lowering: &mut Lowering,
    cx: &Context,
    triggers: &Triggers,
    tokens: Tokens,
    again: Option<VarId>,
) -> Vec<Statement> {
    let mut cx = cx.after_actions(&lowering.net);
    for trigger in triggers.values().flatten() {
        cx.origin = trigger.origin;
        lowering.prepare(&mut cx, trigger.value, true);
    }
    let allocations = allocate::statements(lowering, &mut cx, triggers, Some(tokens), again);
    let mut out = std::mem::take(&mut cx.statements);
    out.extend(allocations);
    out
}
