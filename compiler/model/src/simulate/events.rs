//! R12: when time alone changes something. With inputs as they are, the next instant at which a delay ends or a comparison
//! with the duration of a step turns out otherwise.

use super::Simulator;
use super::arithmetic::compare;
use super::context::{DividedByZero, Values, evaluate};
use super::plan::Memory;
use crate::chart::{Comparison, ExprKind};
use std::cmp::Ordering;

impl Simulator<'_> {
    /// The first instant behind `t`, the time of the latest reaction, and before `end` at which time alone changes
    /// something: a reaction there sees what none before it has.
    pub fn next_event(&self, t: i64, end: i64) -> Option<i64> {
        let delays = self.plan.delays.iter().filter_map(|&id| {
            let ExprKind::Delay { on, off, .. } = self.chart.exprs[id].kind else { return None };
            self.state.delays[id].end(on.ms, off.ms, t)
        });
        let delay = delays.min().filter(|at| *at < end);
        // A comparison is looked at up to the end of a delay, and no further.
        let compared = self.comparison(t, delay.unwrap_or(end));
        compared.or(delay)
    }

    /// The first instant behind `t` and before `end` at which the sides of a comparison stand otherwise to each other than
    /// at `t`. Durations grow evenly, so that they do so once: the instant is found by halving.
    fn comparison(&self, t: i64, end: i64) -> Option<i64> {
        if self.plan.clocks.is_empty() || end - t < 2 {
            return None;
        }
        let mut values = self.values.clone();
        let now = self.orders_at(t, &mut values);
        let differs = |at: i64, values: &mut Values| self.orders_at(at, values) != now;
        let (mut before, mut behind) = (t, end - 1);
        if !differs(behind, &mut values) {
            return None;
        }
        while behind - before > 1 {
            let middle = before + (behind - before) / 2;
            if differs(middle, &mut values) { behind = middle } else { before = middle }
        }
        Some(behind)
    }

    /// How the sides of each comparison with a duration stand to each other at an instant.
    fn orders_at(&self, t: i64, values: &mut Values) -> Vec<Ordering> {
        let mut state = self.state.clone();
        // Asking raises no flag.
        let DividedByZero(_) =
            evaluate(self.chart, &self.plan, &self.plan.clock_nodes, Memory::Hold, &mut state, t, values);
        let order = |&(a, b): &(_, _)| {
            let (a, b) = (values.of(a), values.of(b));
            if compare(Comparison::Less, a, b) {
                Ordering::Less
            } else if compare(Comparison::Greater, a, b) {
                Ordering::Greater
            } else {
                Ordering::Equal
            }
        };
        self.plan.clocks.iter().map(order).collect()
    }
}
