//! What vectors cannot show: charts of a size that no one writes.

use super::Simulator;
use crate::chart::*;
use crate::reaction::{Profile, Response, Stimulus};
use grafc_diagnostics::Span;
use index_vec::index_vec;

/// Negations above an input, and continuously assigned names each of which reads the one before.
const DEPTH: usize = 100_000;

/// One initial step, two inputs, and whatever the caller adds.
fn chart() -> Tables {
    let step = Step {
        label: "1".into(),
        comment: None,
        grafcet: GrafcetId::new(0),
        expansion_of: None,
        initial: true,
        activated: false,
        enclosing: false,
        span: Span::default(),
    };
    let grafcet = Grafcet {
        name: "G1".into(),
        comment: None,
        enclosing_step: None,
        child: false,
        parent: None,
        level: 0,
        steps: vec![StepId::new(0)],
        span: Span::default(),
    };
    let mut chart = Tables {
        name: "test".into(),
        steps: index_vec![step],
        grafcets: index_vec![grafcet],
        hierarchy: vec![GrafcetId::new(0)],
        ..Tables::default()
    };
    declare(&mut chart, VariableKind::Input, Mode::Given);
    chart
}

fn declare(chart: &mut Tables, kind: VariableKind, mode: Mode) -> VariableId {
    let name = format!("v{}", chart.variables.len());
    let variable = Variable::new(name, kind, Type::Bool, Value::Bool(false), Span::default());
    chart.variables.push(Variable { mode, ..variable })
}

fn expression(chart: &mut Tables, kind: ExprKind) -> ExprId {
    chart.exprs.push(Expr { kind, ty: Type::Bool, span: Span::default() })
}

fn assign(chart: &mut Tables, target: VariableId, condition: ExprId) {
    let step = StepId::new(0);
    chart.continuous.push(Continuous { step, target, condition: Some(condition), span: Span::default() });
}

/// One call with the input false, one with the input true.
fn run(tables: &Tables) -> [Response; 2] {
    let chart = &Chart::checked(tables.clone());
    let mut simulator = Simulator::new(chart, Profile::default());
    [false, true].map(|value| simulator.react(&Stimulus { t_ms: 0, restart: false, inputs: vec![Value::Bool(value)] }))
}

#[test]
fn deep_expressions_do_not_exhaust_the_stack() {
    let mut chart = chart();
    let mut top = expression(&mut chart, ExprKind::Variable(VariableId::new(0)));
    for _ in 0..DEPTH {
        top = expression(&mut chart, ExprKind::Not(top));
    }
    let output = declare(&mut chart, VariableKind::Output, Mode::Wire);
    assign(&mut chart, output, top);
    let [first, second] = run(&chart);
    assert_eq!(first.outputs, [Value::Bool(false)]);
    assert_eq!(second.outputs, [Value::Bool(true)]);
}

#[test]
fn long_chains_of_continuous_actions_do_not_exhaust_the_stack() {
    let mut chart = chart();
    let input = expression(&mut chart, ExprKind::Variable(VariableId::new(0)));
    let wires: Vec<VariableId> = (0..DEPTH).map(|_| declare(&mut chart, VariableKind::Internal, Mode::Wire)).collect();
    // The pool holds the reading of the last name first: its order is no help.
    for pair in wires.windows(2).rev() {
        let read = expression(&mut chart, ExprKind::Variable(pair[0]));
        assign(&mut chart, pair[1], read);
    }
    assign(&mut chart, wires[0], input);
    let last = expression(&mut chart, ExprKind::Variable(wires[DEPTH - 1]));
    let output = declare(&mut chart, VariableKind::Output, Mode::Wire);
    assign(&mut chart, output, last);
    let [first, second] = run(&chart);
    assert_eq!(first.outputs, [Value::Bool(false)]);
    assert_eq!(second.outputs, [Value::Bool(true)]);
}
