//! Labels for places that passes make.

use crate::net::Net;
use ecow::EcoString;
use rustc_hash::FxHashSet;

/// The labels of places and macro-steps.
pub struct Labels(FxHashSet<EcoString>);

impl Labels {
    /// Those of a net.
    pub fn of(net: &Net) -> Labels {
        let places = net.places.iter().map(|place| &place.label);
        Labels(places.chain(net.macro_steps.iter().map(|m| &m.label)).cloned().collect())
    }

    /// The label, with a number behind it if there is such a label already; from then on there is.
    pub fn unused(&mut self, base: EcoString) -> EcoString {
        let mut label = base.clone();
        let mut number = 2_u32;
        while !self.0.insert(label.clone()) {
            label = format!("{base}_{number}").into();
            number += 1;
        }
        label
    }
}
