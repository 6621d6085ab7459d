//! What outputs of continuous actions do in a call that LIVELOCK ended, where they are not to be computed; and in memory that
//! was saved after such a call.

use crate::lower::Lowering;
use crate::scan::{Heading, Origin, Role, Statement, VarId, Variable};
use grafc_formula::{FormulaId, Type};
use grafc_model::chart::{Mode, VariableId, VariableKind};
use grafc_model::reaction::{Evolution, LivelockOutputs, Profile};

/// Whether outputs may have to do something else than what the situation says.
pub(crate) fn may_override(profile: Profile, ends: bool) -> bool {
    let computed = profile.livelock_outputs == LivelockOutputs::Computed;
    !computed && !ends && profile.evolution == Evolution::Stable
}

/// What outputs have to do.
#[derive(Default)]
pub(crate) struct Overriding {
    /// Keeps them before all else of a call but a reset.
    pub kept: Vec<Statement>,
    /// Writes them after all has been computed.
    pub after: Vec<Statement>,
    /// Writes them after all has been computed of memory that was given back.
    pub restored: Option<Statement>,
}

/// All of it for outputs, and for which actions on outputs are `seen` to act; `again` is true at the end of a call that was
/// cut off. If memory is `saved`, it says whether the last call was, and what outputs hold since: the situation does not.
pub(crate) fn statements(
    lowering: &mut Lowering,
    profile: Profile,
    again: VarId,
    seen: Vec<(VarId, Origin)>,
    saved: bool,
) -> Overriding {
    let net = &*lowering.net.clone();
    let is_overridden =
        |v: &VariableId| net.variables[*v].mode == Mode::Wire && net.variables[*v].kind == VariableKind::Output;
    let outputs = net.variables.indices().filter(is_overridden);
    let mut targets: Vec<_> = outputs.map(|v| (lowering.symbols.declared(v), lowering.wire_origin(v))).collect();
    targets.extend(seen);
    let (mut kept, mut body) = (Vec::new(), Vec::new());
    for (target, origin) in targets {
        let value = match profile.livelock_outputs {
            LivelockOutputs::Computed => continue,
            LivelockOutputs::Hold => {
                let Variable { name, ty, .. } = &lowering.symbols.table[target];
                let (name, ty) = (format!("held_{name}"), *ty);
                let role = if saved { Role::Memory } else { Role::Temporary };
                let held = lowering.symbols.fresh(role, name, ty, None);
                let now = lowering.symbols.read(&mut lowering.pool, target);
                kept.push(Statement::assign(origin, held, now));
                lowering.symbols.read(&mut lowering.pool, held)
            }
            LivelockOutputs::Off => lowering.pool.truth(false),
        };
        body.push(Statement::assign(origin, target, value));
    }
    if body.is_empty() {
        return Overriding::default();
    }
    body.insert(0, Statement::Heading(Heading::OutputsAfterLivelock));
    let cut_off = lowering.symbols.read(&mut lowering.pool, again);
    let mut after = vec![when(cut_off, body.clone())];
    let restored = saved.then(|| {
        let about = "whether the last call was";
        let given_up = lowering.symbols.fresh(Role::Memory, "given_up", Type::Bool, Some(about.into()));
        after.push(Statement::assign(Origin::Chart, given_up, cut_off));
        when(lowering.symbols.read(&mut lowering.pool, given_up), body)
    });
    Overriding { kept, after, restored }
}

fn when(condition: FormulaId, body: Vec<Statement>) -> Statement {
    Statement::when(condition, body)
}
