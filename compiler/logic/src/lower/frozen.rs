//! What pulse orders remember (R15): which grafcets they have frozen, and which steps were active then.

use super::symbols::Symbols;
use crate::scan::{Role, VarId};
use ecow::eco_format;
use grafc_formula::Type;
use grafc_model::chart::{GrafcetId, PulseKind, StepId};
use grafc_net::Net;
use index_vec::IndexVec;

/// A bit for each grafcet that can be frozen, and one for each of its steps.
pub(crate) struct FrozenBits {
    /// `fr`
    pub(crate) frozen: IndexVec<GrafcetId, Option<VarId>>,
    /// `saved`
    pub(crate) saved: IndexVec<StepId, Option<VarId>>,
}

impl Clone for FrozenBits {
    fn clone(&self) -> Self {
        FrozenBits { frozen: self.frozen.clone(), saved: self.saved.clone() }
    }
}

impl FrozenBits {
    /// Of the grafcets that a pulse freezes, and of those that these command, however deep.
    pub(crate) fn new(net: &Net, symbols: &mut Symbols) -> Self {
        let mut bits = FrozenBits {
            frozen: net.grafcets.iter().map(|_| None).collect(),
            saved: net.places.iter().map(|_| None).collect(),
        };
        let mut can_be: IndexVec<GrafcetId, bool> = net.grafcets.iter().map(|_| false).collect();
        for pulse in net.pulses.iter().filter(|pulse| pulse.kind == PulseKind::Freeze) {
            can_be[pulse.grafcet] = true;
        }
        if !can_be.iter().any(|can_be| *can_be) {
            return bits;
        }
        // What is commanded comes after what commands it.
        let below = net.commanded_below();
        for g in &net.hierarchy {
            if can_be[*g] {
                below[*g].iter().for_each(|below| can_be[*below] = true);
            }
        }
        for (g, grafcet) in net.grafcets.iter_enumerated().filter(|(g, _)| can_be[*g]) {
            let about = "whether a pulse order has frozen it";
            let frozen = symbols.fresh(Role::Memory, eco_format!("F{}", grafcet.name), Type::Bool, Some(about.into()));
            bits.frozen[g] = Some(frozen);
            for s in &grafcet.steps {
                let name = eco_format!("saved_{}", net.places[*s].label);
                bits.saved[*s] = Some(symbols.fresh(Role::Memory, name, Type::Bool, None));
            }
        }
        bits
    }
}
