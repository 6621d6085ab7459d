//! E0313: no grafcet forces or encloses one that is above it (M2).
//!
//! An order puts the grafcet of its step above the grafcet that it forces, an enclosure puts the grafcet of the enclosing
//! step above what is enclosed. If both together went round in a circle, no grafcet of the circle could be settled first
//! (IEC 60848, 7.3: forcing is hierarchical; 7.4: an enclosure belongs to its enclosing step).
//!
//! Wrong: `grafcet G1 { initial step 1 { force G2{} } }  grafcet G2 { initial step 2 { force G1{} } }`
//! Right: the same without the second order.

use crate::chart::{GrafcetId, Tables};
use crate::resolve::Resolved;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics, Span};
use index_vec::{IndexVec, index_vec};

/// More edges of a circle are not shown.
const SHOWN: usize = 8;

/// `above` forces or encloses `below`.
struct Edge {
    above: GrafcetId,
    below: GrafcetId,
    span: Span,
    verb: &'static str,
}

/// Finds the levels of the grafcets, or reports each circle that prevents it.
pub fn set_levels(resolved: &mut Resolved, diagnostics: &mut Diagnostics) {
    let chart = &mut resolved.chart;
    let edges = edges(chart);
    let mut below: IndexVec<GrafcetId, Vec<usize>> = index_vec![Vec::new(); chart.grafcets.len()];
    let mut waiting: IndexVec<GrafcetId, usize> = index_vec![0; chart.grafcets.len()];
    for (index, edge) in edges.iter().enumerate() {
        below[edge.above].push(index);
        waiting[edge.below] += 1;
    }
    let mut ready: Vec<GrafcetId> = waiting.iter_enumerated().filter(|(_, n)| **n == 0).map(|(id, _)| id).collect();
    let mut next = 0;
    while next < ready.len() {
        let above = ready[next];
        next += 1;
        for &edge in &below[above] {
            let id = edges[edge].below;
            chart.grafcets[id].level = chart.grafcets[id].level.max(chart.grafcets[above].level + 1);
            waiting[id] -= 1;
            if waiting[id] == 0 {
                ready.push(id);
            }
        }
    }
    if ready.len() < chart.grafcets.len() {
        report_circles(chart, &edges, &waiting, diagnostics);
    }
    ready.sort_unstable_by_key(|&id| (chart.grafcets[id].level, id));
    ready.extend(chart.grafcets.indices().filter(|&id| waiting[id] > 0));
    chart.hierarchy = ready;
}

fn edges(chart: &Tables) -> Vec<Edge> {
    let enclosures = chart.grafcets.iter_enumerated().filter_map(|(below, grafcet)| {
        let above = chart.steps[grafcet.enclosing_step?].grafcet;
        Some(Edge { above, below, span: grafcet.span, verb: "encloses" })
    });
    let orders = chart.orders.iter().map(|order| {
        let above = chart.steps[order.step].grafcet;
        Edge { above, below: order.grafcet, span: order.span, verb: "forces" }
    });
    let children = chart.grafcets.iter_enumerated().filter_map(|(below, grafcet)| {
        Some(Edge { above: grafcet.parent?, below, span: grafcet.span, verb: "is the parent of" })
    });
    let commands =
        chart.commands().map(|(above, below, span)| Edge { above, below, span, verb: "commands" }).collect::<Vec<_>>();
    // An order on its own grafcet is E0314.
    let orders = orders.chain(commands).filter(|edge| edge.above != edge.below);
    enclosures.chain(children.filter(|edge| edge.above != edge.below)).chain(orders).collect()
}

/// Every grafcet that still waits has another such above it: going up from it leads into a circle.
fn report_circles(chart: &Tables, edges: &[Edge], waiting: &IndexVec<GrafcetId, usize>, diagnostics: &mut Diagnostics) {
    let mut up: IndexVec<GrafcetId, Option<usize>> = index_vec![None; chart.grafcets.len()];
    for (index, edge) in edges.iter().enumerate() {
        if waiting[edge.above] > 0 && waiting[edge.below] > 0 {
            up[edge.below].get_or_insert(index);
        }
    }
    let mut walk_of: IndexVec<GrafcetId, Option<GrafcetId>> = index_vec![None; chart.grafcets.len()];
    for start in chart.grafcets.indices().filter(|&id| waiting[id] > 0) {
        let mut at = start;
        while walk_of[at].is_none() {
            walk_of[at] = Some(start);
            let Some(edge) = up[at] else { break };
            at = edges[edge].above;
        }
        if walk_of[at] == Some(start) && up[at].is_some() {
            let mut circle = Vec::new();
            let mut place = at;
            while let Some(edge) = up[place] {
                circle.push(&edges[edge]);
                place = edges[edge].above;
                if place == at {
                    break;
                }
            }
            diagnostics.push(report(chart, &circle));
        }
    }
}

fn report(chart: &Tables, circle: &[&Edge]) -> Diagnostic {
    let name = |id: GrafcetId| &chart.grafcets[id].name;
    let say = |edge: &Edge| format!("`{}` {} `{}`", name(edge.above), edge.verb, name(edge.below));
    let (first, others) = circle.split_first().expect("a circle has an edge");
    let message = match circle {
        [only] => format!("`{}` {} itself", name(only.above), only.verb),
        [one, other] => format!("{} and {}", say(one), say(other)),
        _ => format!("{}, and `{}` is above it in turn", say(first), name(first.below)),
    };
    let mut diagnostic = Diagnostic::new(Code::E0313, first.span, message);
    for edge in others.iter().take(SHOWN) {
        diagnostic = diagnostic.also(edge.span, say(edge));
    }
    diagnostic
        .note("IEC 60848, 7.3 and 7.4: forcing and enclosing make a hierarchy, which has no circles")
        .help("leave out one of these orders, or let conditions do what it does")
}

#[cfg(test)]
mod tests {
    use crate::checks::testing::{breaks, passes};

    #[test]
    fn grafcets_that_force_each_other() {
        breaks("E0313", "grafcet G1 { initial step 1 { force G2{} } } grafcet G2 { initial step 2 { force G1{} } }");
    }

    #[test]
    fn an_enclosure_of_a_step_in_itself() {
        breaks("E0313", "grafcet G0 { initial step 0 } grafcet X1/G1 { activated enclosing step 1 }");
    }

    #[test]
    fn over_forcing_and_enclosing() {
        breaks(
            "E0313",
            "grafcet G1 { initial step 0 enclosing step 1 } grafcet X1/G2 { activated step 2 { force G3{} } }
             grafcet G3 { initial step 3 { force G1{0} } }",
        );
    }

    #[test]
    fn each_circle_is_reported_once() {
        let circle = |a: u32, b: u32| {
            format!(
                "grafcet G{a} {{ initial step {a} {{ force G{b}{{}} }} }}
                 grafcet G{b} {{ initial step {b} {{ force G{a}{{}} force G9{{}} }} }} "
            )
        };
        let text = circle(1, 2) + &circle(3, 4) + "grafcet G9 { initial step 9 }";
        crate::checks::testing::breaks_all(&["E0313", "E0313"], &text);
    }

    #[test]
    fn a_diamond_is_no_circle() {
        passes(
            "grafcet G1 { initial step 1 { force G2{} force G3{} } } grafcet G2 { initial step 2 { force G4{} } }
             grafcet G3 { initial step 3 { force G4{} } } grafcet G4 { initial step 4 }",
        );
    }
}
