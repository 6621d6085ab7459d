//! What is read, what is refused and where, what is written.

use super::{parse_trace, write_trace};
use crate::chart::{Chart, Grafcet, GrafcetId, Step, StepId, Tables, Type, Value, Variable, VariableKind};
use crate::reaction::{Flags, Response, Stimulus};
use grafc_diagnostics::{Diagnostic, FileId, Span};
use index_vec::index_vec;

fn chart() -> Chart {
    let step = |label: &str| Step {
        label: label.into(),
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
        steps: vec![StepId::new(0), StepId::new(1)],
        span: Span::default(),
    };
    use VariableKind::{Input, Output};
    let variable = |name: &str, kind, ty, initial| Variable::new(name, kind, ty, initial, Span::default());
    Chart::checked(Tables {
        name: "test".into(),
        variables: index_vec![
            variable("a", Input, Type::Bool, Value::Bool(false)),
            variable("n", Input, Type::Int, Value::Int(7)),
            variable("U", Output, Type::Lreal, Value::Real(0.0)),
            variable("x", Input, Type::Real, Value::Real(0.0)),
            variable("V", Output, Type::Real, Value::Real(0.0)),
            variable("d", Input, Type::Time, Value::Time(0)),
        ],
        steps: index_vec![step("1"), step("with, comma")],
        grafcets: index_vec![grafcet],
        hierarchy: vec![GrafcetId::new(0)],
        ..Tables::default()
    })
}

fn row(t_ms: i64, a: bool, n: i64, x: f64, d: i64) -> Stimulus {
    Stimulus { t_ms, restart: false, inputs: vec![Value::Bool(a), Value::Int(n), Value::Real(x), Value::Time(d)] }
}

/// The faults of a trace: code, text under the span, headline.
fn faults(text: &str) -> Vec<(&'static str, String, String)> {
    let (_, diagnostics) = parse_trace(FileId::default(), text, &chart());
    let fault = |d: &Diagnostic| (d.code.as_str(), text[d.primary.span.range()].to_string(), d.message.clone());
    diagnostics.iter().map(fault).collect()
}

fn fault(code: &'static str, place: &str, message: &str) -> (&'static str, String, String) {
    (code, place.to_string(), message.to_string())
}

#[test]
fn cells_are_read_and_empty_ones_keep_the_value_before() {
    let text = "t_ms,d,a,x\n0,,1,0.1\n10,250,,\n10,,FALSE,-2\n";
    let (stimuli, diagnostics) = parse_trace(FileId::default(), text, &chart());
    assert!(diagnostics.is_empty(), "{diagnostics:?}");
    let tenth = f64::from(0.1f32);
    assert_eq!(stimuli, [row(0, true, 7, tenth, 0), row(10, true, 7, tenth, 250), row(10, false, 7, -2.0, 250)]);
}

#[test]
fn line_ends_quotes_blanks_and_byte_order_mark_do_not_matter() {
    let text = "\u{feff}t_ms,\"a\", n\r\n\r\n0,\"TRUE\",3\r\n 5 ,0,-4";
    let (stimuli, diagnostics) = parse_trace(FileId::default(), text, &chart());
    assert!(diagnostics.is_empty(), "{diagnostics:?}");
    assert_eq!(stimuli, [row(0, true, 3, 0.0, 0), row(5, false, -4, 0.0, 0)]);
}

#[test]
fn every_fault_is_reported_at_its_cell() {
    let text = "t_ms,a,A,U,zz,a,n\n0,2,,,,,32768\n-1,1,,,,,x\n,,,,,,\n20,1\n30,,,,,,\n29,,,,,,1e3\n";
    assert_eq!(
        faults(text),
        [
            fault("E0602", "A", "the chart has no input `A`"),
            fault("E0602", "U", "`U` is an output of the chart, not an input"),
            fault("E0602", "zz", "the chart has no input `zz`"),
            fault("E0601", "a", "column `a` appears twice"),
            fault("E0603", "2", "`2` is not a value of `a`"),
            fault("E0603", "32768", "`32768` is not a value of `n`"),
            fault("E0603", "-1", "`-1` is not a time"),
            fault("E0603", "x", "`x` is not a value of `n`"),
            fault("E0603", "", "the row has no time"),
            fault("E0601", "20,1", "the row has 2 cells, the header has 7"),
            fault("E0604", "29", "the time goes back from 30 ms to 29 ms"),
            fault("E0603", "1e3", "`1e3` is not a value of `n`"),
        ]
    );
}

#[test]
fn places_are_right_behind_carriage_returns_and_quotes() {
    let text = "t_ms,n,a\r\n\r\n0,\"1,\"\"5\",1\r\n1,2,maybe\r\n";
    assert_eq!(
        faults(text),
        [
            fault("E0603", "\"1,\"\"5\"", "`1,\"5` is not a value of `n`"),
            fault("E0603", "maybe", "`maybe` is not a value of `a`"),
        ]
    );
}

#[test]
fn numbers_out_of_range_are_refused() {
    for (column, cell) in [("x", "1e39"), ("x", "1e999"), ("n", "inf"), ("d", "1.5"), ("d", "9223372036854775808")] {
        let found = faults(&format!("t_ms,{column}\n0,{cell}\n"));
        assert_eq!(found, [fault("E0603", cell, &format!("`{cell}` is not a value of `{column}`"))]);
    }
}

#[test]
fn a_trace_needs_a_header_with_times_first() {
    assert_eq!(faults(""), [fault("E0601", "", "the trace is empty")]);
    assert_eq!(faults("a,n\n"), [fault("E0601", "a", "the first column is `a`, not `t_ms`")]);
    assert_eq!(faults("t_ms\n0\n"), []);
}

#[test]
fn results_are_written_in_order_of_declaration() {
    let response = |situation: &[usize], flags| Response {
        outputs: vec![Value::Real(0.1), Value::Real(f64::from(0.1f32))],
        situation: situation.iter().map(|&step| StepId::new(step)).collect(),
        flags,
    };
    let flags = Flags { livelock: true, alloc_conflict: false, force_conflict: true, div0: true };
    let responses = [response(&[0, 1], Flags::default()), response(&[], flags)];
    let stimuli = [row(0, false, 0, 0.0, 0), row(10, false, 0, 0.0, 0)];
    assert_eq!(
        write_trace(&chart(), &stimuli, &responses),
        "t_ms,U,V,situation,flags\n0,0.1,0.1,\"1 `with, comma`\",\n10,0.1,0.1,,LIVELOCK FORCE_CONFLICT DIV0\n"
    );
}
