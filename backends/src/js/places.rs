//! Where each variable lies: in one of the groups of what a chart keeps, or in a local variable of a part of the scan.

use super::names::Names;
use super::text::member;
use crate::temporaries::{Uses, temporaries};
use ecow::{EcoString, eco_format};
use grafc_logic::scan::{Observing, Origins, Program, Role, SeenTransition, TimerId, VarId};
use index_vec::IndexVec;
use rustc_hash::FxHashMap;

/// How the variables of one program are read and written.
pub(super) struct Places<'p> {
    pub program: &'p Program,
    pub names: &'p Names,
    /// Where variables come from, if somebody asks.
    pub origins: Option<Origins>,
    read: IndexVec<VarId, EcoString>,
    /// What is done with each temporary.
    temporaries: FxHashMap<VarId, Uses>,
    /// What is shown in lists, by variable: its place in one.
    shown: FxHashMap<VarId, EcoString>,
}

impl<'p> Places<'p> {
    /// Finds all places.
    pub fn new(program: &'p Program, names: &'p Names) -> Self {
        let shown = program.observing.as_ref().map(|seen| shown(program, seen, names)).unwrap_or_default();
        let mut places =
            Places { program, names, origins: None, read: IndexVec::new(), temporaries: temporaries(program), shown };
        for id in program.variables.indices() {
            let text = places.spell(id);
            places.read.push(text);
        }
        places
    }

    fn spell(&self, id: VarId) -> EcoString {
        let name = &self.names.variables[id];
        match self.program.variables[id].role {
            Role::Input => member("inputs", name),
            Role::Output => member("outputs", name),
            Role::Internal => member("variables", name),
            Role::Constant => member("constants", name),
            Role::Flag(flag) => eco_format!("flags.{}", flag.name()),
            Role::Step | Role::State | Role::Memory => member("m", name),
            Role::Temporary if self.is_kept(id) => member("m", name),
            Role::Temporary => self.names.locals[id].clone(),
            Role::Observed => match self.shown.get(&id) {
                Some(place) => place.clone(),
                None => member("seen", name),
            },
        }
    }

    /// A variable as an operand.
    pub fn read(&self, id: VarId) -> &EcoString {
        &self.read[id]
    }

    /// What is done with a variable that is local to a part.
    pub fn local(&self, id: VarId) -> Option<Uses> {
        let uses = self.temporaries.get(&id).copied()?;
        (!uses.crosses()).then_some(uses)
    }

    /// Whether something of ours is part of the memory: what is kept from scan to scan, and what goes from one part of a
    /// scan to another.
    pub fn is_kept(&self, id: VarId) -> bool {
        match self.program.variables[id].role {
            Role::Step | Role::State | Role::Memory => true,
            Role::Temporary => self.temporaries.get(&id).is_some_and(|uses| uses.crosses()),
            Role::Input | Role::Output | Role::Internal | Role::Constant | Role::Flag(_) | Role::Observed => false,
        }
    }

    /// Whether a variable is shown and stands in no list.
    pub fn is_shown_alone(&self, id: VarId) -> bool {
        self.program.variables[id].role == Role::Observed && !self.shown.contains_key(&id)
    }

    /// A timer.
    pub fn timer(&self, timer: TimerId) -> EcoString {
        member("delays", &self.names.timers[timer])
    }

    /// The local variables of a part that are not constants of it, in order.
    pub fn declared(&self, part: usize) -> Vec<VarId> {
        let is = |v: &VarId| self.local(*v).is_some_and(|uses| uses.parts[part] && !uses.is_constant());
        let mut declared: Vec<VarId> = self.temporaries.keys().copied().filter(is).collect();
        declared.sort_unstable();
        declared
    }
}

/// Where the variables of the role `Observed` stand in lists: of transitions by words, so that one more changes the lines of
/// no other.
fn shown(program: &Program, observing: &Observing, names: &Names) -> FxHashMap<VarId, EcoString> {
    let mut shown = FxHashMap::default();
    for seen in &observing.transitions {
        let word = transition_word(names, seen);
        shown.insert(seen.enabled, member("seen.enabled", &word));
        shown.insert(seen.cleared, member("seen.cleared", &word));
        shown.extend(seen.satisfied.map(|v| (v, member("seen.satisfied", &word))));
    }
    let mut list = |name: &'static str, variables: &mut dyn Iterator<Item = VarId>| {
        shown.extend(variables.enumerate().map(|(place, v)| (v, eco_format!("seen.{name}[{place}]"))));
    };
    list("frozen", &mut observing.frozen.iter().map(|(_, v)| *v));
    list("forced", &mut observing.forced.iter().map(|(_, v)| *v));
    list("orders", &mut observing.orders.iter().map(|(_, v)| *v));
    list("actions", &mut observing.actions.iter().map(|(_, v)| *v));
    list("asserted", &mut claims(program, true).map(|(_, v)| v));
    list("wanted", &mut claims(program, false).map(|(_, v)| v));
    shown
}

/// The claims of which each scan says whether they are true, by their places: those that must be so always, or those that
/// are met in some states.
pub(super) fn claims(program: &Program, always: bool) -> impl Iterator<Item = (usize, VarId)> {
    let of_this_kind = program.claims.iter().filter(move |claim| claim.must_always_hold() == always);
    of_this_kind.filter_map(|claim| Some((claim.place, claim.condition()?)))
}

/// The word by which what is seen of a transition is found: that of a variable, which no other has; and none that an
/// object has by itself.
pub(super) fn transition_word(names: &Names, seen: &SeenTransition) -> EcoString {
    let name = names.variables[seen.enabled].as_str();
    eco_format!("t_{}", name.strip_prefix("enabled_").unwrap_or(name))
}
