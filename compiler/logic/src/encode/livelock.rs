//! What outputs of continuous actions do in a call that LIVELOCK ended, where they are not to be computed.

use crate::lower::Lowering;
use crate::scan::{Role, Statement, VarId};
use grafc_model::chart::{Mode, VariableKind};
use grafc_model::reaction::{Evolution, LivelockOutputs, Profile};

/// Whether outputs may have to do something else than what the situation says.
pub(crate) fn may_override(profile: Profile, ends: bool) -> bool {
    let computed = profile.livelock_outputs == LivelockOutputs::Computed;
    !computed && !ends && profile.evolution == Evolution::Stable
}

/// What keeps them before all else of a call but a reset, and what writes them after all has been computed; `again` is true at the end of a
/// call that was cut off.
pub(crate) fn statements(
    lowering: &mut Lowering,
    profile: Profile,
    again: VarId,
) -> (Vec<Statement>, Option<Statement>) {
    let net = &*lowering.net.clone();
    let (mut kept, mut body) = (Vec::new(), Vec::new());
    for (v, variable) in net.variables.iter_enumerated() {
        if variable.mode != Mode::Wire || variable.kind != VariableKind::Output {
            continue;
        }
        let (target, origin) = (lowering.symbols.declared(v), lowering.wire_origin(v));
        let value = match profile.livelock_outputs {
            LivelockOutputs::Computed => continue,
            LivelockOutputs::Hold => {
                let name = format!("held_{}", variable.name);
                let held = lowering.symbols.fresh(Role::Temporary, name, variable.ty, None);
                let now = lowering.symbols.read(&mut lowering.pool, target);
                kept.push(Statement::assign(origin, held, now));
                lowering.symbols.read(&mut lowering.pool, held)
            }
            LivelockOutputs::Off => lowering.pool.truth(false),
        };
        body.push(Statement::assign(origin, target, value));
    }
    if body.is_empty() {
        return (kept, None);
    }
    body.insert(0, Statement::Heading(crate::scan::Heading::OutputsAfterLivelock));
    let when = lowering.symbols.read(&mut lowering.pool, again);
    (kept, Some(Statement::If { branches: vec![(when, body)], otherwise: Vec::new() }))
}
