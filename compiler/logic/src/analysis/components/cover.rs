//! Which steps share a variable.
//!
//! Each component that was found gives its own steps to a set. Two components with one base share a set where the base
//! has first the one branch beside it and later the other: if no transition touches both regions that they leave out or
//! the branches, the base without both regions and with both branches is a component as well, for around each transition
//! it looks like one of the two or like the base. Rules 1, 4 and 5 are looked at once more: both branches must not bring
//! an initial step, a step with a link, or a step that the same order forces.

use super::family::{Component, Family};
use super::reason::Reason;
use super::search::Search;
use super::{Surroundings, forced};
use crate::lower::cover::{Cover, CoverSet};
use grafc_model::chart::{StepId, TransitionId};
use grafc_net::Net;
use index_vec::IndexVec;
use rustc_hash::{FxHashMap, FxHashSet};

/// No more regions than this are remembered around one transition; those around it share no set if there are more.
const CROSSING: usize = 8;

/// Sets are compared with branches no more often than this for each step of the net.
const COMPARED: usize = 16;

/// The cover, and the components that its sets belong to.
pub(super) struct Arranged {
    pub(super) cover: Cover,
    /// Why each of the other steps stays a bit.
    pub(super) reasons: Vec<(StepId, Reason)>,
    family: Family,
    /// The components whose own steps each set of the cover holds.
    members: Vec<Vec<usize>>,
}

/// Arranges the components of a search in sets.
pub(super) fn arrange(net: &Net, around: &Surroundings, search: Search) -> Arranged {
    let uncovered = net.places.indices().filter(|s| search.family.owner(*s).is_none());
    let reasons = uncovered.map(|s| (s, search.reason(s))).collect();
    let family = search.family;
    let mut members = Groups::new(net, around, &family).members;
    let first = |set: &Vec<usize>| set.iter().flat_map(|c| &family.components[*c].own).min().copied();
    members.sort_by_cached_key(first);
    let mut of_step: IndexVec<StepId, Option<usize>> = net.places.iter().map(|_| None).collect();
    let mut sets = Vec::with_capacity(members.len());
    for (number, set) in members.iter().enumerate() {
        let mut steps: Vec<StepId> = set.iter().flat_map(|c| &family.components[*c].own).copied().collect();
        steps.sort_unstable();
        steps.iter().for_each(|s| of_step[*s] = Some(number));
        let always_marked = set.iter().all(|c| always_marked(net, around, &family.components[*c]));
        sets.push(CoverSet { steps, always_marked });
    }
    Arranged { cover: Cover { sets, of_step }, reasons, family, members }
}

/// Whether a component has a token at the start, keeps it at each clearing, and gets it from each order.
fn always_marked(net: &Net, around: &Surroundings, component: &Component) -> bool {
    let Some(first) = component.own.first().filter(|_| component.base.is_none()) else { return false };
    let place = &net.places[*first];
    let into: FxHashSet<TransitionId> = component.own.iter().flat_map(|s| around.entering(*s)).copied().collect();
    let keeps = |t: &TransitionId| into.contains(t);
    component.initial.is_some()
        && place.within.is_empty()
        && forced(&net.grafcets[place.grafcet]).count() == component.forced.len()
        && component.own.iter().all(|s| around.leaving(*s).iter().all(keeps))
}

impl Arranged {
    /// Calls `tell` with the steps of a set's component that are not in the set, as long as there is `work` left.
    pub(super) fn rest(&self, set: usize, work: &mut usize, mut tell: impl FnMut(StepId)) {
        let bases: Vec<(usize, usize)> =
            self.members[set].iter().filter_map(|c| self.family.components[*c].base).collect();
        let Some((base, _)) = bases.first() else { return };
        for (c, _) in self.family.line(*base) {
            for s in &self.family.components[c].own {
                let Some(left) = work.checked_sub(1 + bases.len()) else { return };
                *work = left;
                if self.family.holds(*base, *s) && !bases.iter().any(|(_, region)| self.family.leaves_out(*region, *s))
                {
                    tell(*s);
                }
            }
        }
    }
}

/// Components whose own steps share a set.
struct Groups<'f> {
    around: &'f Surroundings<'f>,
    members: Vec<Vec<usize>>,
    /// The groups of each base.
    of_base: FxHashMap<usize, Vec<usize>>,
    /// The groups of the base, from which on the next branch beside a region may find its place.
    next: FxHashMap<usize, usize>,
    /// Whether a group leaves out a region.
    leaves_out: FxHashSet<(usize, usize)>,
    /// Whether a transition touches a branch of a group.
    touches: FxHashSet<(usize, TransitionId)>,
    brings: Vec<Brings>,
    work: usize,
}

/// What the branches of a group have already.
#[derive(Default)]
struct Brings {
    initial: bool,
    link: bool,
    forced: FxHashSet<usize>,
}

impl<'f> Groups<'f> {
    fn new(net: &Net, around: &'f Surroundings<'f>, family: &'f Family) -> Self {
        let mut groups = Groups {
            around,
            members: Vec::new(),
            of_base: FxHashMap::default(),
            next: FxHashMap::default(),
            leaves_out: FxHashSet::default(),
            touches: FxHashSet::default(),
            brings: Vec::new(),
            work: COMPARED * net.places.len(),
        };
        let crossing = crossing(family);
        for (number, component) in family.components.iter().enumerate() {
            let group = component.base.and_then(|(base, region)| {
                let crossing = crossing[region].as_ref()?;
                let candidates = groups.of_base.get(&base)?;
                let start = groups.next.get(&region).copied().unwrap_or_default();
                let mut index = start;
                while index < candidates.len() {
                    groups.work = groups.work.checked_sub(1 + crossing.len() + component.own.len())?;
                    if groups.fits(net, candidates[index], component, crossing) {
                        groups.next.insert(region, index + 1);
                        return Some(candidates[index]);
                    }
                    index += 1;
                }
                groups.next.insert(region, index + 1);
                None
            });
            groups.add(net, number, component, group);
        }
        groups
    }

    fn around<'a>(&'a self, component: &'a Component) -> impl Iterator<Item = TransitionId> + 'a {
        component.own.iter().flat_map(|s| self.around.leaving(*s).iter().chain(self.around.entering(*s))).copied()
    }

    fn fits(&self, net: &Net, group: usize, component: &Component, crossing: &[usize]) -> bool {
        let brings = &self.brings[group];
        let (initial, link) = initial_and_link(net, component);
        let twice = initial && brings.initial
            || link && brings.link
            || component.forced.keys().any(|order| brings.forced.contains(order));
        let meets = crossing.iter().any(|region| self.leaves_out.contains(&(group, *region)))
            || self.around(component).any(|t| self.touches.contains(&(group, t)));
        !twice && !meets
    }

    fn add(&mut self, net: &Net, number: usize, component: &Component, group: Option<usize>) {
        let group = group.unwrap_or_else(|| {
            let new = self.members.len();
            self.members.push(Vec::new());
            self.brings.push(Brings::default());
            if let Some((base, _)) = component.base {
                self.of_base.entry(base).or_default().push(new);
            }
            new
        });
        self.members[group].push(number);
        if let Some((_, region)) = component.base {
            self.leaves_out.insert((group, region));
        }
        let touched: Vec<TransitionId> = self.around(component).collect();
        self.touches.extend(touched.into_iter().map(|t| (group, t)));
        let (initial, link) = initial_and_link(net, component);
        let brings = &mut self.brings[group];
        brings.initial |= initial;
        brings.link |= link;
        brings.forced.extend(component.forced.keys());
    }
}

/// Whether the own steps of a component have an initial one, and one with a link.
fn initial_and_link(net: &Net, component: &Component) -> (bool, bool) {
    let own = || component.own.iter().map(|s| &net.places[*s]);
    (own().any(|place| place.initial), own().any(|place| place.activated && !place.within.is_empty()))
}

/// For each region those that some transition touches as well, itself too; none if there are many. Regions of different
/// bases never share a group, so that it does no harm to list them.
fn crossing(family: &Family) -> Vec<Option<Vec<usize>>> {
    let mut at: FxHashMap<TransitionId, Vec<usize>> = FxHashMap::default();
    for (number, region) in family.regions.iter().enumerate() {
        for t in &region.zone {
            let list = at.entry(*t).or_default();
            if list.len() <= CROSSING {
                list.push(number);
            }
        }
    }
    let of = |zone: &Vec<TransitionId>| {
        let mut found: Vec<usize> = Vec::new();
        for t in zone {
            let list = &at[t];
            if list.len() > CROSSING {
                return None;
            }
            found.extend(list);
        }
        found.sort_unstable();
        found.dedup();
        Some(found)
    };
    family.regions.iter().map(|region| of(&region.zone)).collect()
}
