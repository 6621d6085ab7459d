//! E0411: no continuously assigned variable depends on itself (A1).
//!
//! Its value is the disjunction of its continuous actions in the current situation (IEC 60848, 4.10.2), not a stored
//! one. Read in the condition of one of them, directly or over others, it would define itself.
//!
//! Wrong: `step 1 { A if B }`, `step 2 { B if A }`
//! Right: `step 1 { A if b }`, `step 2 { B if A }`

use crate::chart::{ExprKind, Mode, Tables, VariableId, below};
use crate::resolve::Resolved;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics, Span};
use index_vec::{IndexVec, index_vec};
use rustc_hash::FxHashMap;

/// More of a circle is not shown.
const SHOWN: usize = 8;

/// A wire that is read for another one, and where.
type Read = (VariableId, Span);

pub fn check(resolved: &Resolved, diagnostics: &mut Diagnostics) {
    let chart = &resolved.chart;
    let reads = reads(chart);
    let reads_of = |wire: VariableId| reads.get(&wire).map_or(&[][..], Vec::as_slice);
    let mut states: IndexVec<VariableId, State> = index_vec![State::Untouched; chart.variables.len()];
    for root in chart.variables.indices() {
        if states[root] != State::Untouched || reads_of(root).is_empty() {
            continue;
        }
        states[root] = State::Open;
        // Each wire under way, and which of its reads comes next.
        let mut way = vec![(root, 0)];
        while let Some((wire, next)) = way.last_mut() {
            let Some(&(read, span)) = reads_of(*wire).get(*next) else {
                states[*wire] = State::Done;
                way.pop();
                continue;
            };
            *next += 1;
            match states[read] {
                State::Untouched => {
                    states[read] = State::Open;
                    way.push((read, 0));
                }
                State::Open => {
                    let start = way.iter().rposition(|&(wire, _)| wire == read).unwrap_or(0);
                    let circle: Vec<Read> = way[start..].iter().map(|&(wire, next)| reads_of(wire)[next - 1]).collect();
                    diagnostics.push(report(chart, read, span, &circle));
                }
                State::Done => {}
            }
        }
    }
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum State {
    Untouched,
    Open,
    Done,
}

/// The wires that the conditions of each wire read, each once; most wires read none.
fn reads(chart: &Tables) -> FxHashMap<VariableId, Vec<Read>> {
    let mut reads: FxHashMap<VariableId, Vec<Read>> = FxHashMap::default();
    for action in chart.continuous.iter() {
        let Some(condition) = action.condition else { continue };
        for id in below(&chart.exprs, condition) {
            let expr = &chart.exprs[id];
            if let ExprKind::Variable(variable) = expr.kind
                && chart.variables[variable].mode == Mode::Wire
            {
                reads.entry(action.target).or_default().push((variable, expr.span));
            }
        }
    }
    for reads in reads.values_mut() {
        reads.sort_by_key(|&(variable, span)| (variable, span));
        reads.dedup_by_key(|&mut (variable, _)| variable);
    }
    reads
}

fn report(chart: &Tables, wire: VariableId, span: Span, circle: &[Read]) -> Diagnostic {
    let name = &chart.variables[wire].name;
    let message = match circle {
        [_] => format!("the continuous action on `{name}` reads `{name}` itself"),
        _ => format!("the continuous actions on `{name}` depend on `{name}`"),
    };
    let mut diagnostic = Diagnostic::new(Code::E0411, span, message);
    for (read, place) in circle.iter().take(SHOWN).filter(|(_, place)| *place != span) {
        diagnostic = diagnostic.also(*place, format!("over `{}`", chart.variables[*read].name));
    }
    diagnostic
        .note("IEC 60848, 4.10.2: a continuous action gives a value that follows from situation and inputs at once")
        .help("what has to be remembered is assigned by stored actions, `:= … on activation`")
}

#[cfg(test)]
mod tests {
    use crate::checks::testing::{breaks, passes_with};

    #[test]
    fn a_wire_that_reads_itself() {
        breaks("E0411", "output A : bool initial step 1 { A if not A }");
        breaks("E0411", "output A : bool initial step 1 { A if 3s/A }");
    }

    #[test]
    fn two_wires_that_read_each_other() {
        breaks("E0411", "output A, B : bool initial step 1 { A if B } step 2 { B if A }");
    }

    #[test]
    fn wires_in_a_row() {
        passes_with(&["W0401"], "input c : bool output A, B : bool initial step 1 { A if B } step 2 { B if c }");
    }
}
