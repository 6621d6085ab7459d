//! The outputs of continuous actions (R11).
//!
//! Most are computed from the situation after the evolution. Where one state holds all steps that assign a wire, what is
//! not active need cost nothing: the wire follows the state. It becomes false when such a step is left and true when one
//! is entered; a condition is only looked at while its step is active.

use crate::encode::by_grafcet;
use crate::encode::heading::heading;
use crate::encode::state_case::StateCase;
use crate::lower::situation::Holder;
use crate::lower::{Context, Lowering, Moment};
use crate::scan::{ActionId, Heading, Origin, Part, Statement};
use grafc_formula::FormulaId;
use grafc_model::chart::{ExprId, ExprKind, Mode, StepId, Variable, VariableId, VariableKind};
use grafc_net::Net;
use rustc_hash::{FxHashMap, FxHashSet};
use std::collections::BTreeMap;

/// The wires that follow a state, by set.
pub(crate) struct Followers {
    /// For each set its wires, in order of declaration.
    pub(crate) of_set: Vec<Vec<VariableId>>,
    /// Wires with an assignment condition.
    conditional: FxHashSet<VariableId>,
    /// The continuous actions of each step that assign a wire that follows.
    of_step: FxHashMap<StepId, Vec<usize>>,
}

/// Finds wires that can follow a state, and tells the lowering that their variables hold their values. Outputs do not where
/// something else may write them at the end of a call. In a small chart none follows, unless a `quick` program is wanted and
/// transitions move the states themselves.
pub(crate) fn followers(lowering: &mut Lowering, outputs_follow: bool, quick: bool) -> Followers {
    let net = &*lowering.net.clone();
    let mut followers = Followers {
        of_set: lowering.situation.sets.iter().map(|_| Vec::new()).collect(),
        conditional: FxHashSet::default(),
        of_step: FxHashMap::default(),
    };
    if lowering.situation.is_small && !(quick && lowering.situation.in_place) {
        return followers;
    }
    let mut read: FxHashSet<VariableId> = FxHashSet::default();
    for expr in &net.exprs {
        if let ExprKind::Variable(v) = expr.kind {
            read.insert(v);
        }
    }
    // The set of each wire; none if a step of no set, or of another, assigns it as well.
    let mut set_of: Vec<Option<Option<usize>>> = vec![None; net.variables.len()];
    for action in &net.continuous {
        let set = match lowering.situation.holder(action.step) {
            Holder::State { set, .. } => Some(set),
            Holder::Bit(_) => None,
        };
        let entry = &mut set_of[action.target.index()];
        *entry = Some(if entry.is_none_or(|known| known == set) { set } else { None });
        if action.condition.is_some() {
            followers.conditional.insert(action.target);
        }
    }
    for (v, variable) in net.variables.iter_enumerated() {
        let may_follow = variable.mode == Mode::Wire && (outputs_follow || variable.kind != VariableKind::Output);
        let Some(Some(set)) = set_of[v.index()].filter(|_| may_follow) else { continue };
        // Between micro-steps only what depends on the situation alone has its value.
        let shown = variable.kind == VariableKind::Output && !read.contains(&v);
        if shown || !followers.conditional.contains(&v) {
            followers.of_set[set].push(v);
            lowering.kept_wires.insert(v);
        }
    }
    for (index, action) in net.continuous.iter().enumerate() {
        if lowering.kept_wires.contains(&action.target) {
            followers.of_step.entry(action.step).or_default().push(index);
        }
    }
    followers
}

impl Followers {
    /// The wires that follow and that a step assigns, each with the conditions of the actions; none if one of these has
    /// no condition.
    pub(crate) fn on_step(&self, net: &Net, s: StepId) -> Vec<(VariableId, Vec<ExprId>)> {
        let mut found: BTreeMap<VariableId, Option<Vec<ExprId>>> = BTreeMap::new();
        for index in self.of_step.get(&s).map_or(&[][..], Vec::as_slice) {
            let action = &net.continuous[*index];
            let entry = found.entry(action.target).or_insert_with(|| Some(Vec::new()));
            match (action.condition, entry.as_mut()) {
                (Some(condition), Some(list)) => list.push(condition),
                (None, _) => *entry = None,
                (Some(_), None) => {}
            }
        }
        found.into_iter().map(|(wire, conditions)| (wire, conditions.unwrap_or_default())).collect()
    }
}

impl Followers {
    /// The action of a step on a wire that follows, the first if there are several.
    pub(crate) fn origin(&self, net: &Net, s: StepId, wire: VariableId) -> Origin {
        let mut actions = self.of_step.get(&s).map_or(&[][..], Vec::as_slice).iter();
        let found = actions.find(|index| net.continuous[**index].target == wire);
        found.map_or(Origin::Step(s), |index| Origin::Action(ActionId::from(*index)))
    }
}

/// All that is computed after the evolution.
pub(crate) fn statements(lowering: &mut Lowering, followers: Option<&Followers>) -> Vec<Statement> {
    let net = &*lowering.net.clone();
    let mut cx = Context::new(Moment::After);
    let is_shown =
        |(_, variable): &(VariableId, &Variable)| variable.mode == Mode::Wire && variable.kind == VariableKind::Output;
    let shown = net.variables.iter_enumerated().filter(is_shown).map(|(v, _)| v);
    let mut last = None;
    for (of, v) in by_grafcet::wires(lowering, shown) {
        let heading = of.filter(|_| net.grafcets.len() > 1).map_or(Heading::Outputs, |g| Heading::Of(Part::Outputs, g));
        if last.replace(heading) != Some(heading) {
            cx.statements.push(Statement::Heading(heading));
        }
        cx.origin = lowering.wire_origin(v);
        lowering.wire(&mut cx, v);
    }
    let Some(followers) = followers.filter(|f| !f.conditional.is_empty()) else { return cx.statements };
    // All conditions are evaluated, whether or not they decide anything: one of them may divide by zero.
    let conditional = net.continuous.iter().enumerate();
    for (index, action) in conditional.filter(|(_, action)| followers.conditional.contains(&action.target)) {
        cx.origin = Origin::Action(ActionId::from(index));
        if let Some(condition) = action.condition.filter(|_| lowering.kept_wires.contains(&action.target)) {
            lowering.expr(&mut cx, condition);
        }
    }
    let mut cases = Vec::new();
    for set in 0..followers.of_set.len() {
        let mut arms = StateCase::default();
        for s in lowering.situation.sets[set].steps.clone() {
            let mut body = Vec::new();
            for (wire, condition) in followers.on_step(net, s) {
                if !condition.is_empty() {
                    let terms: Vec<FormulaId> = condition.iter().map(|c| lowering.expr(&mut cx, *c)).collect();
                    let value = lowering.pool.or(terms);
                    let target = lowering.symbols.declared(wire);
                    body.push(Statement::assign(followers.origin(net, s, wire), target, value));
                }
            }
            arms.add(lowering, s, body);
        }
        cases.extend(arms.case(lowering.situation.sets[set].variable));
    }
    let mut out = cx.statements;
    heading(&mut out, Heading::Outputs, cases);
    out
}
