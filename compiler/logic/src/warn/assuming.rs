//! Warnings that assumptions answer: what can happen only where an assumption is not kept is not warned of.
//!
//! Each transition-condition and each event is taken together with the assumptions on inputs that it reads, or that have
//! to do with these:
//!
//! ```text
//! 1 -> 2 : a    1 -> 3 : b    assume not (a and b)
//! 1 -> 2 : a and not (a and b)    1 -> 3 : b and not (a and b)
//! ```
//!
//! What is then proved serves warnings alone; no code is made of it. An assumption speaks of a reaction, and conditions
//! of its micro-steps: inputs are the same in all of them, but edges are over after the first. So one with edges is taken
//! only if it is no stronger without them.

use crate::analysis::Analysis;
use grafc_model::chart::{ClaimKind, Event, Expr, ExprId, ExprKind, Type, VariableId, VariableKind};
use grafc_net::Net;
use index_vec::{IndexVec, index_vec};
use rustc_hash::FxHashMap;

/// The net under its assumptions; none if there are none of use.
pub(super) fn analysis(analysis: &Analysis) -> Option<Analysis> {
    let mut net = analysis.net().clone();
    let groups = groups(&net);
    if groups.is_empty() {
        return None;
    }
    let offset = net.exprs.len();
    for expr in &net.claims.exprs {
        net.exprs.push(Expr { kind: expr.kind.moved(offset), ..*expr });
    }
    // The assumptions of each group in one.
    let mut of_variable: FxHashMap<VariableId, usize> = FxHashMap::default();
    let mut assumed = Vec::with_capacity(groups.len());
    for (number, group) in groups.iter().enumerate() {
        of_variable.extend(group.variables.iter().map(|v| (*v, number)));
        let conditions = group.conditions.iter().map(|id| ExprId::new(id.index() + offset));
        assumed.extend(conditions.reduce(|a, b| and(&mut net, a, b)));
    }
    let reads = reads(&net, &of_variable);
    for t in net.transitions.indices() {
        let condition = net.transitions[t].condition;
        net.transitions[t].condition = with(&mut net, &reads, &assumed, condition);
    }
    for place in 0..net.stored.len() {
        match net.stored[place].event {
            Event::Event(s, e) => {
                net.stored[place].event = Event::Event(s, with(&mut net, &reads, &assumed, e));
            }
            Event::EachScan(s, Some(e)) => {
                net.stored[place].event = Event::EachScan(s, Some(with(&mut net, &reads, &assumed, e)));
            }
            Event::EachScan(_, None) | Event::Activation(_) | Event::Deactivation(_) | Event::Clearing(_) => {}
        }
    }
    Some(Analysis::new(net))
}

/// Assumptions that have to do with each other.
struct Group {
    variables: Vec<VariableId>,
    conditions: Vec<ExprId>,
}

/// The assumptions that can be taken together with conditions, those that share inputs in one group.
fn groups(net: &Net) -> Vec<Group> {
    let claims = &net.claims;
    // Inputs that assumptions join, as a forest.
    let mut above: IndexVec<VariableId, VariableId> = net.variables.indices().collect();
    fn root(above: &mut IndexVec<VariableId, VariableId>, mut v: VariableId) -> VariableId {
        while above[v] != v {
            above[v] = above[above[v]];
            v = above[v];
        }
        v
    }
    let mut taken: Vec<(VariableId, ExprId)> = Vec::new();
    for claim in claims.of(ClaimKind::Assume) {
        let Some(condition) = claim.condition().filter(|_| is_no_stronger_without_edges(net, claim.pool)) else {
            continue;
        };
        let inputs = claim.nodes().filter_map(|id| match claims.exprs[id].kind {
            ExprKind::Variable(v) if net.variables[v].kind == VariableKind::Input => Some(v),
            _ => None,
        });
        let mut first = None;
        for v in inputs {
            let v = root(&mut above, v);
            let first = *first.get_or_insert(v);
            let first = root(&mut above, first);
            above[v] = first;
        }
        taken.extend(first.map(|first| (first, condition)));
    }
    let mut groups: Vec<Group> = Vec::new();
    let mut of_root: FxHashMap<VariableId, usize> = FxHashMap::default();
    for (first, condition) in taken {
        let number = *of_root.entry(root(&mut above, first)).or_insert_with(|| {
            groups.push(Group { variables: Vec::new(), conditions: Vec::new() });
            groups.len() - 1
        });
        groups[number].conditions.push(condition);
    }
    for v in net.variables.indices() {
        if let Some(number) = of_root.get(&root(&mut above, v)) {
            groups[*number].variables.push(v);
        }
    }
    groups
}

/// Whether an assumption is implied by what it says of edges where there is none: each stands under an odd number of
/// negations.
fn is_no_stronger_without_edges(net: &Net, (first, end): (ExprId, ExprId)) -> bool {
    let exprs = &net.claims.exprs;
    let count = end.index() - first.index();
    let place = |id: ExprId| id.index() - first.index();
    // In which sense each is meant, from the last, which is the whole, to the first.
    let (mut plain, mut negated) = (vec![false; count], vec![false; count]);
    if count > 0 {
        plain[count - 1] = true;
    }
    for at in (0..count).rev() {
        let (is, is_not) = (plain[at], negated[at]);
        let kind = exprs[ExprId::new(first.index() + at)].kind;
        let (keeps, turns) = match kind {
            ExprKind::Rise(_) | ExprKind::Fall(_) => {
                if is {
                    return false;
                }
                continue;
            }
            ExprKind::Not(_) => (false, true),
            ExprKind::And(..) | ExprKind::Or(..) => (true, false),
            ExprKind::Xor(..)
            | ExprKind::Delay { .. }
            | ExprKind::Compare(..)
            | ExprKind::Arithmetic(..)
            | ExprKind::Negate(_)
            | ExprKind::Widen(_) => (true, true),
            ExprKind::Literal(_)
            | ExprKind::Variable(_)
            | ExprKind::StepActive(_)
            | ExprKind::StepTime(_)
            | ExprKind::MacroActive(_)
            | ExprKind::GrafcetActive(_)
            | ExprKind::GrafcetFrozen(_) => continue,
        };
        for operand in kind.operands() {
            plain[place(operand)] |= keeps && is || turns && is_not;
            negated[place(operand)] |= keeps && is_not || turns && is;
        }
    }
    true
}

/// For each expression the groups of assumptions whose inputs it reads.
fn reads(net: &Net, of_variable: &FxHashMap<VariableId, usize>) -> IndexVec<ExprId, Vec<usize>> {
    let mut reads: IndexVec<ExprId, Vec<usize>> = index_vec![Vec::new(); net.exprs.len()];
    for (id, expr) in net.exprs.iter_enumerated() {
        let mut found: Vec<usize> = match expr.kind {
            ExprKind::Variable(v) => of_variable.get(&v).copied().into_iter().collect(),
            _ => expr.kind.operands().flat_map(|operand| reads[operand].iter().copied()).collect(),
        };
        found.sort_unstable();
        found.dedup();
        reads[id] = found;
    }
    reads
}

fn with(net: &mut Net, reads: &IndexVec<ExprId, Vec<usize>>, assumed: &[ExprId], condition: ExprId) -> ExprId {
    let Some(groups) = reads.get(condition) else { return condition };
    groups.iter().fold(condition, |condition, group| and(net, condition, assumed[*group]))
}

fn and(net: &mut Net, a: ExprId, b: ExprId) -> ExprId {
    let span = net.exprs[a].span;
    net.exprs.push(Expr { kind: ExprKind::And(a, b), ty: Type::Bool, span })
}

#[cfg(test)]
mod tests {
    use crate::analysis::Analysis;
    use grafc_diagnostics::{Diagnostics, FileId};
    use grafc_net::passes;

    /// The codes of what is warned of that inputs decide.
    fn codes(text: &str) -> Vec<&'static str> {
        let (tree, faults) = grafc_syntax::parse(FileId::new(0), text);
        let (chart, said) = grafc_model::check(&tree, "test");
        let chart = chart.unwrap_or_else(|| panic!("{text} has errors: {faults:?} {said:?}"));
        let mut net = grafc_net::build(&chart);
        passes::run(&mut net, false, &mut Diagnostics::new());
        let warnings = crate::warn(&Analysis::new(net));
        warnings.iter().map(|warning| warning.code.as_str()).collect()
    }

    const CHOICE: &str = "input a, b, c, d : bool initial step 1 step 2 step 3 transition 1 -> 2 : a
        transition 1 -> 3 : b transition 2 -> 1 : ↑d transition 3 -> 1 : ↑d ";

    #[test]
    fn a_choice() {
        assert_eq!(codes(CHOICE), ["W0409"]);
        assert_eq!(codes(&format!("{CHOICE} assume not (a and b)")), [""; 0]);
        assert_eq!(codes(&format!("{CHOICE} assume at most one of c, a, b")), [""; 0]);
        // a is c, and c is never with b.
        assert_eq!(codes(&format!("{CHOICE} assume not a or c assume not (b and c)")), [""; 0]);
        assert_eq!(codes(&format!("{CHOICE} assume not (a and c)")), ["W0409"]);
    }

    #[test]
    fn an_assertion_is_no_assumption() {
        assert_eq!(codes(&format!("{CHOICE} assert not (a and b)")), ["W0409"]);
    }

    #[test]
    fn edges() {
        let edges = CHOICE.replace("2 : a", "2 : ↑a").replace("3 : b", "3 : ↑b");
        assert_eq!(codes(&edges), ["W0409"]);
        assert_eq!(codes(&format!("{edges} assume not (↑a and ↑b)")), [""; 0]);
        // With an edge, a row of inputs keeps this in its first micro-step, and conditions hold in later ones as well.
        assert_eq!(codes(&format!("{CHOICE} assume not (a and b) or ↑c")), ["W0409"]);
    }

    #[test]
    fn orders_and_assignments() {
        let orders = "input a, b, c : bool grafcet G1 { initial step 1 step 2 { force G2{21} } step 3 { force G2{22} }
            transition 1 -> 2 : ↑a transition 1 -> 3 : ↑b transition 2 -> 1 : ↑c transition 3 -> 1 : ↑c }
            grafcet G2 { initial step 20 step 21 step 22 } ";
        assert!(codes(orders).contains(&"W0411"), "{:?}", codes(orders));
        assert!(!codes(&format!("{orders} assume not (↑a and ↑b)")).contains(&"W0411"));
        let stored = "input a, b : bool output n : int initial step 1 { n := 1 on event ↑a  n := 2 on event ↑b } ";
        assert!(codes(stored).contains(&"W0412"), "{:?}", codes(stored));
        assert!(!codes(&format!("{stored} assume not (↑a and ↑b)")).contains(&"W0412"));
    }

    #[test]
    fn rings() {
        let ring = "input a, b : bool initial step 1 step 2 transition 1 -> 2 : a transition 2 -> 1 : b ";
        assert_eq!(codes(ring), ["W0424"]);
        assert_eq!(codes(&format!("{ring} assume not (a and b)")), [""; 0]);
    }

    #[test]
    fn what_is_proved_without_assumptions_stays() {
        // Under the assumption the transition is never cleared; a chart says nothing false of itself by assuming it.
        assert_eq!(codes(&format!("{CHOICE} assume not a assume not b")), [""; 0]);
    }
}
