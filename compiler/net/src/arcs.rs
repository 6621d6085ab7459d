//! Which transitions touch which step: the arcs of a net, looked at from its steps.

use crate::net::Net;
use grafc_model::chart::{StepId, TransitionId};

/// The transitions around each step, each list in order of declaration. A transition that leads out of a step and back
/// into it at once is a *loop* of that step.
#[derive(Clone, Debug)]
pub struct Arcs {
    entering: Lists,
    leaving: Lists,
    into: Lists,
    out_of: Lists,
    loops: Lists,
}

impl Arcs {
    /// The arcs of those transitions that are `wanted`.
    pub fn of(net: &Net, wanted: impl Fn(TransitionId) -> bool) -> Arcs {
        // Most transitions have one step before them and one behind.
        let many = || Vec::with_capacity(net.transitions.len());
        let (mut entering, mut leaving, mut into, mut out_of) = (many(), many(), many(), many());
        let mut loops = Vec::new();
        // The last transition before and after a step, to tell loops in one pass.
        let mut before = vec![None; net.places.len()];
        let mut after = before.clone();
        for (t, transition) in net.transitions.iter_enumerated().filter(|(t, _)| wanted(*t)) {
            transition.pre.iter().for_each(|s| before[s.index()] = Some(t));
            transition.post.iter().for_each(|s| after[s.index()] = Some(t));
            for s in &transition.pre {
                leaving.push((*s, t));
                if after[s.index()] == Some(t) { &mut loops } else { &mut out_of }.push((*s, t));
            }
            for s in &transition.post {
                entering.push((*s, t));
                if before[s.index()] != Some(t) {
                    into.push((*s, t));
                }
            }
        }
        let lists = |arcs: Vec<(StepId, TransitionId)>| Lists::new(net.places.len(), &arcs);
        Arcs {
            entering: lists(entering),
            leaving: lists(leaving),
            into: lists(into),
            out_of: lists(out_of),
            loops: lists(loops),
        }
    }

    /// Transitions that lead to a step.
    pub fn entering(&self, step: StepId) -> &[TransitionId] {
        self.entering.of(step)
    }

    /// Transitions that a step comes before.
    pub fn leaving(&self, step: StepId) -> &[TransitionId] {
        self.leaving.of(step)
    }

    /// Transitions that lead to a step, except its loops.
    pub fn into_step(&self, step: StepId) -> &[TransitionId] {
        self.into.of(step)
    }

    /// Transitions that a step comes before, except its loops.
    pub fn out_of_step(&self, step: StepId) -> &[TransitionId] {
        self.out_of.of(step)
    }

    /// Transitions that lead out of a step and back into it at once.
    pub fn loops(&self, step: StepId) -> &[TransitionId] {
        self.loops.of(step)
    }
}

/// A list a step, one behind the other.
#[derive(Clone, Debug)]
struct Lists {
    /// Where the list of each step begins, and at the end where the last one ends.
    begins: Box<[u32]>,
    all: Box<[TransitionId]>,
}

impl Lists {
    fn new(steps: usize, arcs: &[(StepId, TransitionId)]) -> Lists {
        let mut begins = vec![0_u32; steps + 1];
        arcs.iter().for_each(|(s, _)| begins[s.index() + 1] += 1);
        for s in 0..steps {
            begins[s + 1] += begins[s];
        }
        let mut next = begins.clone();
        let mut all = vec![TransitionId::from_usize(0); arcs.len()];
        for (s, t) in arcs {
            let place = &mut next[s.index()];
            all[*place as usize] = *t;
            *place += 1;
        }
        Lists { begins: begins.into(), all: all.into() }
    }

    fn of(&self, step: StepId) -> &[TransitionId] {
        let s = step.index();
        &self.all[self.begins[s] as usize..self.begins[s + 1] as usize]
    }
}

#[cfg(test)]
mod tests {
    use super::Lists;
    use grafc_model::chart::{StepId, TransitionId};

    #[test]
    fn each_step_has_its_own_in_order() {
        let arc = |s, t| (StepId::from_usize(s), TransitionId::from_usize(t));
        let lists = Lists::new(4, &[arc(2, 0), arc(0, 1), arc(2, 3), arc(0, 4)]);
        let of = |s| lists.of(StepId::from_usize(s)).iter().map(|t| t.index()).collect::<Vec<_>>();
        assert_eq!([of(0), of(1), of(2), of(3)], [vec![1, 4], vec![], vec![0, 3], vec![]]);
    }
}
