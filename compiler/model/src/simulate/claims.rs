//! Claims, looked at after each reaction: by the words of the chart, and beside all that it does.
//!
//! A claim is about the state reached and the inputs of the reaction. Assumptions may ask for edges: those of the inputs
//! against the reaction before, none in the first one.

use super::Simulator;
use super::context::{Values, evaluate_claims};
use super::plan::{Memory, Valued};
use crate::chart::{Chart, ClaimKind, ExprId, ExprKind, Mode, Value, VariableId};
use index_vec::IndexVec;

/// What is known of claims.
#[derive(Clone, Debug)]
pub(super) struct Watched {
    /// Of the expressions of claims.
    values: Values,
    /// The operand of each edge in the reaction before.
    operands: IndexVec<ExprId, bool>,
    /// Whether there was one.
    has_begun: bool,
    /// The continuously assigned names that claims read.
    wires: Vec<Valued>,
    broken: Vec<usize>,
}

impl Watched {
    fn new(chart: &Chart) -> Self {
        let exprs = &chart.claims.exprs;
        let mut is_read: IndexVec<VariableId, bool> = chart.variables.iter().map(|_| false).collect();
        for expr in exprs {
            if let ExprKind::Variable(id) = expr.kind {
                is_read[id] = chart.variables[id].mode == Mode::Wire;
            }
        }
        let wires = is_read.iter_enumerated().filter(|(_, is_read)| **is_read);
        Watched {
            values: Values::of_claims(chart),
            operands: exprs.iter().map(|_| false).collect(),
            has_begun: false,
            wires: wires.map(|(id, _)| Valued::Wire(id)).collect(),
            broken: Vec::new(),
        }
    }

    /// What comes next is a first reaction.
    pub(super) fn forget(&mut self) {
        self.has_begun = false;
    }
}

impl Simulator<'_> {
    /// From here on claims are looked at.
    pub fn watch_claims(&mut self) {
        self.watched = Some(Box::new(Watched::new(self.chart)));
    }

    /// The claims that the latest reaction broke, by their places in [`Claims::list`](crate::chart::Claims::list):
    /// assumptions that its inputs do not keep, assertions that are false in the state that it reached. One that was given
    /// up (R9) has reached none. None if nobody looks at claims.
    pub fn broken(&self) -> &[usize] {
        self.watched.as_ref().map_or(&[], |watched| &watched.broken)
    }

    /// Whether a condition of a claim held after the latest reaction; false if nobody looks at claims.
    pub fn claimed(&self, condition: ExprId) -> bool {
        self.watched.as_ref().is_some_and(|watched| watched.values.holds(condition))
    }

    /// A reaction at `t` is over; whether it was given up.
    pub(super) fn look_at_claims(&mut self, t: i64, given_up: bool) {
        let Some(mut watched) = self.watched.take() else { return };
        let nodes = self.plan.of_wires(self.chart, watched.wires.clone());
        // What is claimed raises no flag.
        let flags = self.flags;
        self.evaluate(&nodes, Memory::Hold, t);
        self.flags = flags;
        watched.values.take_wires(&self.values);
        let memory = if watched.has_begun { Memory::Update } else { Memory::Hold };
        evaluate_claims(self.chart, &self.plan, memory, &self.state, &watched.operands, t, &mut watched.values);
        for (id, expr) in self.chart.claims.exprs.iter_enumerated() {
            if let ExprKind::Rise(operand) | ExprKind::Fall(operand) = expr.kind {
                watched.operands[id] = watched.values.holds(operand);
            }
        }
        watched.has_begun = true;
        watched.broken.clear();
        for (place, claim) in self.chart.claims.list.iter().enumerate() {
            let is_asked = match claim.kind {
                ClaimKind::Assume => true,
                ClaimKind::Assert => !given_up,
                ClaimKind::Reach | ClaimKind::Final => false,
            };
            if let Some(condition) = claim.condition().filter(|_| is_asked)
                && !watched.values.holds(condition)
            {
                watched.broken.push(place);
            }
        }
        if let Some(assertion) = self.chart.controls.assertion
            && self.state.variables[assertion] == Value::Int(0)
            && !given_up
        {
            let mut assertions = self.chart.claims.assertions();
            let first = assertions.find(|(.., condition)| !watched.values.holds(*condition));
            self.state.variables[assertion] = Value::Int(first.map_or(0, |(number, ..)| number as i64));
        }
        self.watched = Some(watched);
    }
}

#[cfg(test)]
mod tests {
    use crate::chart::{ControlNames, Value};
    use crate::checks::testing::chart;
    use crate::reaction::{Profile, Stimulus};
    use crate::simulate::Simulator;

    /// What each reaction breaks, to rows of `t_ms` and Boolean inputs.
    fn broken(text: &str, rows: &[(i64, &[u8])]) -> Vec<Vec<usize>> {
        let chart = chart(text);
        let mut simulator = Simulator::new(&chart, Profile::default());
        simulator.watch_claims();
        let one = |(t_ms, inputs): &(i64, &[u8])| {
            let inputs = inputs.iter().map(|bit| Value::Bool(*bit == 1)).collect();
            simulator.react(&Stimulus { t_ms: *t_ms, restart: false, inputs });
            simulator.broken().to_vec()
        };
        rows.iter().map(one).collect()
    }

    const CHART: &str = "input a, b : bool output V, W : bool initial step 1 { V } step 2 { W } step 3
        transition 1 -> 2 : ↑a transition 2 -> 3 : b transition 3 -> 1 : not b ";

    #[test]
    fn a_state_is_what_stands_after_the_reaction() {
        // Step 2 is passed through where a and b come together.
        let text = format!("{CHART} assert not W assert V or X3 assert [T2 < 20ms]");
        let rows: &[(i64, &[u8])] = &[(0, &[0, 1]), (10, &[1, 1]), (20, &[0, 0]), (30, &[1, 0]), (50, &[1, 0])];
        assert_eq!(broken(&text, rows), [vec![], vec![], vec![], vec![0, 1], vec![0, 1, 2]]);
    }

    #[test]
    fn edges_of_assumptions_are_against_the_reaction_before() {
        let text = format!("{CHART} assume not ↑a assume not ↓(a and b)");
        let rows: &[(i64, &[u8])] = &[(0, &[1, 1]), (1, &[1, 1]), (2, &[0, 1]), (3, &[1, 0]), (4, &[1, 0])];
        assert_eq!(broken(&text, rows), [vec![], vec![], vec![1], vec![0], vec![]]);
    }

    #[test]
    fn a_reaction_that_is_given_up_reaches_no_state() {
        let text = "input a : bool initial step 1 step 2 transition 1 -> 2 : a transition 2 -> 1 : a assert not a assume not a";
        let rows: &[(i64, &[u8])] = &[(0, &[0]), (1, &[1]), (2, &[0])];
        assert_eq!(broken(text, rows), [vec![], vec![1], vec![]]);
    }

    #[test]
    fn the_first_assertion_that_is_false_stays() {
        let text = "input a, b : bool output V : bool initial step 1 { V } step 2 transition 1 -> 2 : ↑a
            transition 2 -> 1 : ↓a assert \"one\" : not b or V assume not b assert not X2 assert not b";
        let mut chart = chart(text);
        let names = ControlNames { check_assertions: true, clear_flags: Some("ack".into()), ..ControlNames::default() };
        chart.control(&names).expect("names of its own");
        let comment = chart.variables.iter().find(|v| v.name == "ASSERTION").and_then(|v| v.comment.clone());
        let expected = "the first assertion that was false; 1: one, 2: not X2, 3: not b";
        assert_eq!(comment.as_deref(), Some(expected));
        let mut simulator = Simulator::new(&chart, Profile::default());
        let mut shown = |t_ms: i64, inputs: [u8; 3]| {
            let inputs = inputs.iter().map(|bit| Value::Bool(*bit == 1)).collect();
            simulator.react(&Stimulus { t_ms, restart: false, inputs }).outputs[1]
        };
        // a, b, ack
        assert_eq!(shown(0, [0, 0, 0]), Value::Int(0));
        assert_eq!(shown(1, [0, 1, 0]), Value::Int(3));
        assert_eq!(shown(2, [1, 1, 0]), Value::Int(3), "it stays");
        assert_eq!(shown(3, [1, 1, 1]), Value::Int(1), "it is lowered, and the first of three is told");
        assert_eq!(shown(4, [1, 0, 1]), Value::Int(2));
        assert_eq!(shown(5, [0, 0, 1]), Value::Int(0));
    }

    #[test]
    fn claims_raise_no_flag_and_do_nothing() {
        let text =
            "input a : bool var n : int initial step 1 step 2 transition 1 -> 2 : a { n := 0 } assert [1 / n = 3]";
        let chart = chart(text);
        let mut simulator = Simulator::new(&chart, Profile::default());
        simulator.watch_claims();
        let response = simulator.react(&Stimulus { t_ms: 0, restart: false, inputs: vec![Value::Bool(false)] });
        assert_eq!((response.flags.div0, simulator.broken()), (false, &[0][..]));
    }
}
