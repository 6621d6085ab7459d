//! Which continuous actions set a variable.

use grafc_model::chart::VariableId;
use grafc_net::Net;

/// The continuous actions by what they set, one list behind the other.
#[derive(Clone)]
pub(super) struct Setters {
    /// Where the list of each variable begins, and at the end where the last one ends.
    begins: Vec<u32>,
    actions: Vec<u32>,
}

impl Setters {
    /// Those of a net.
    pub(super) fn of(net: &Net) -> Self {
        let mut begins = vec![0_u32; net.variables.len() + 1];
        net.continuous.iter().for_each(|action| begins[action.target.index() + 1] += 1);
        for v in 0..net.variables.len() {
            begins[v + 1] += begins[v];
        }
        let mut free = begins.clone();
        let mut actions = vec![0; net.continuous.len()];
        for (index, action) in net.continuous.iter().enumerate() {
            let place = &mut free[action.target.index()];
            actions[*place as usize] = index as u32;
            *place += 1;
        }
        Setters { begins, actions }
    }

    /// The numbers of the actions on a variable, in order of declaration.
    pub(super) fn on(&self, v: VariableId) -> impl ExactSizeIterator<Item = usize> + '_ {
        let range = self.begins[v.index()] as usize..self.begins[v.index() + 1] as usize;
        self.actions[range].iter().map(|index| *index as usize)
    }
}
