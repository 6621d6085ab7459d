//! Orders on one grafcet that may be in force at once and disagree (R2).

use super::neighbours;
use crate::analysis::Analysis;
use grafc_model::chart::GrafcetId;

/// Two orders on a grafcet, as places in its list: the first wins.
#[derive(Clone, Copy)]
pub(crate) struct Disagreement {
    pub(crate) grafcet: GrafcetId,
    pub(crate) winner: usize,
    pub(crate) loser: usize,
}

pub(super) fn find(analysis: &Analysis) -> Vec<Disagreement> {
    let disagreement = |(g, grafcet): (GrafcetId, &grafc_net::net::Grafcet)| {
        let orders = &grafcet.orders;
        let pair = neighbours::first(orders.len(), |a, b| {
            orders[a].forced != orders[b].forced && !analysis.never_together(orders[a].step, orders[b].step)
        });
        pair.map(|(winner, loser)| Disagreement { grafcet: g, winner, loser })
    };
    analysis.net.grafcets.iter_enumerated().filter_map(disagreement).collect()
}
