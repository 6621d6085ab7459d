//! Words for what variables of ours stand for, made of the elements of the chart alone: a name does not change because
//! something else was added before it.
//!
//! | what | word |
//! | --- | --- |
//! | a transition | its designation if no other has it, else the steps around it: `5`, `Open_Closing`, `to_1`, `4_out` |
//! | an operand | what it reads, from left to right: `start`, `XOpen`, `a_or_b`, `not_XClosed`, `C_3` |
//! | an action, an order | what it writes, the step that gives it |
//!
//! A word is short: what is long is cut, and says so by its last part. Two things of one word get a number from the namer,
//! in order of their places in the chart.

use super::Lowering;
use crate::scan::{ActionId, Origin};
use ecow::{EcoString, eco_format};
use grafc_model::chart::{ExprId, ExprKind, Note, StepId, TransitionId, Value};
use grafc_net::Net;
use rustc_hash::FxHashMap;

/// Of more steps on one side of a transition only the first is named.
const STEPS_NAMED: usize = 2;

/// Of an operand, so many parts are named.
const PARTS_NAMED: usize = 3;

/// Of an operand, so many expressions are looked at.
const LOOKED_AT: usize = 16;

/// How often each designation is used.
pub(super) fn designations(net: &Net) -> FxHashMap<Note, u32> {
    let mut uses: FxHashMap<Note, u32> = FxHashMap::default();
    for designation in net.transitions.iter().filter_map(|t| t.designation.as_ref()) {
        *uses.entry(designation.clone()).or_default() += 1;
    }
    uses
}

impl Lowering {
    /// A word for a transition.
    pub(crate) fn transition_word(&self, t: TransitionId) -> EcoString {
        let transition = &self.net.transitions[t];
        let own = transition.designation.as_ref().filter(|d| self.designations.get(*d) == Some(&1));
        own.map(|designation| designation.text().clone())
            .unwrap_or_else(|| steps_around(&self.net, &transition.pre, &transition.post))
    }

    /// A word for what something comes from.
    pub(crate) fn origin_word(&self, origin: Origin) -> EcoString {
        let net = &self.net;
        match origin {
            Origin::Transition(t) => self.transition_word(t),
            Origin::Step(s) => net.places[s].label.clone(),
            Origin::Action(a) => action_word(net, a),
            Origin::Actions(v) | Origin::Declaration(v) => net.variables[v].name.clone(),
            Origin::Orders(g) => net.grafcets[g].name.clone(),
            Origin::Order(_) | Origin::Chart => EcoString::new(),
        }
    }

    /// A word for an operand.
    pub(crate) fn operand_word(&self, operand: ExprId) -> EcoString {
        operand_word(&self.net, operand)
    }
}

/// `1_2_6`, of more steps `1_more_9`.
fn steps_around(net: &Net, pre: &[StepId], post: &[StepId]) -> EcoString {
    let mut word = EcoString::new();
    let mut side = |steps: &[StepId], none: &str| {
        let named = if steps.len() > STEPS_NAMED { 1 } else { STEPS_NAMED };
        for s in steps.iter().take(named) {
            join(&mut word, &net.places[*s].label);
        }
        match steps {
            [] => join(&mut word, none),
            _ if steps.len() > STEPS_NAMED => join(&mut word, "more"),
            _ => {}
        }
    };
    side(pre, if post.is_empty() { "out" } else { "to" });
    side(post, "out");
    word
}

fn action_word(net: &Net, action: ActionId) -> EcoString {
    let continuous = net.continuous.get(action.index()).map(|a| a.target);
    let stored = || action.index().checked_sub(net.continuous.len()).and_then(|index| net.stored.get(index));
    let target = continuous.or_else(|| stored().map(|a| a.target));
    target.map_or_else(EcoString::new, |v| net.variables[v].name.clone())
}

/// Adds a part to a word.
fn join(word: &mut EcoString, part: &str) {
    if !word.is_empty() && !part.is_empty() {
        word.push('_');
    }
    word.push_str(part);
}

/// What an operand reads, from left to right; a walk with its own stack, which ends after a few parts.
pub(crate) fn operand_word(net: &Net, root: ExprId) -> EcoString {
    enum Piece {
        Operand(ExprId),
        Word(&'static str),
    }
    let mut word = EcoString::new();
    let (mut parts, mut looked_at) = (0, 0);
    let mut open = vec![Piece::Operand(root)];
    while let Some(piece) = open.pop() {
        if looked_at == LOOKED_AT {
            join(&mut word, "more");
            break;
        }
        let e = match piece {
            Piece::Word(text) => {
                join(&mut word, text);
                continue;
            }
            Piece::Operand(e) => e,
        };
        looked_at += 1;
        let two = |open: &mut Vec<Piece>, between: &'static str, a: ExprId, b: ExprId| {
            open.extend([Piece::Operand(b), Piece::Word(between), Piece::Operand(a)]);
        };
        let part = match &net.exprs[e].kind {
            ExprKind::Variable(v) => net.variables[*v].name.clone(),
            ExprKind::StepActive(s) => eco_format!("X{}", net.places[*s].label),
            ExprKind::StepTime(s) => eco_format!("T{}", net.places[*s].label),
            ExprKind::MacroActive(m) => eco_format!("X{}", net.macro_steps[*m].label),
            ExprKind::GrafcetActive(g) => eco_format!("X{}", net.grafcets[*g].name),
            ExprKind::GrafcetFrozen(g) => eco_format!("F{}", net.grafcets[*g].name),
            ExprKind::Literal(Value::Bool(b)) => eco_format!("{b}"),
            ExprKind::Literal(Value::Int(n)) => eco_format!("{n}"),
            ExprKind::Literal(Value::Time(ms)) => duration_word(*ms),
            ExprKind::Literal(Value::Real(x)) => eco_format!("{x}"),
            ExprKind::Not(a) => {
                open.extend([Piece::Operand(*a), Piece::Word("not")]);
                continue;
            }
            ExprKind::Rise(a) => {
                open.extend([Piece::Operand(*a), Piece::Word("rise")]);
                continue;
            }
            ExprKind::Fall(a) => {
                open.extend([Piece::Operand(*a), Piece::Word("fall")]);
                continue;
            }
            ExprKind::Delay { operand: a, .. } => {
                open.extend([Piece::Operand(*a), Piece::Word("delayed")]);
                continue;
            }
            ExprKind::Negate(a) | ExprKind::Widen(a) => {
                open.push(Piece::Operand(*a));
                continue;
            }
            ExprKind::And(a, b) => {
                two(&mut open, "", *a, *b);
                continue;
            }
            ExprKind::Or(a, b) => {
                two(&mut open, "or", *a, *b);
                continue;
            }
            ExprKind::Xor(a, b) => {
                two(&mut open, "xor", *a, *b);
                continue;
            }
            ExprKind::Compare(_, a, b) | ExprKind::Arithmetic(_, a, b) => {
                two(&mut open, "", *a, *b);
                continue;
            }
        };
        if parts == PARTS_NAMED {
            join(&mut word, "more");
            break;
        }
        parts += 1;
        join(&mut word, &part);
    }
    word
}

/// `5s`, `500ms`.
pub(super) fn duration_word(ms: i64) -> EcoString {
    if ms % 1000 == 0 { eco_format!("{}s", ms / 1000) } else { eco_format!("{ms}ms") }
}

#[cfg(test)]
mod tests {
    use crate::scan::Program;
    use crate::{Analysis, Options, compile};
    use grafc_diagnostics::{Diagnostics, FileId};

    fn names(text: &str) -> Vec<String> {
        let (tree, diagnostics) = grafc_syntax::parse(FileId::default(), text);
        assert!(!diagnostics.has_errors(), "{diagnostics:?}");
        let (chart, diagnostics) = grafc_model::check(&tree, "chart");
        let mut net = grafc_net::build(&chart.unwrap_or_else(|| panic!("{diagnostics:?}")));
        grafc_net::passes::run(&mut net, false, &mut Diagnostics::new());
        let program: Program = compile(Analysis::new(net), &Options::default()).0;
        let timers = program.timers.iter().map(|timer| timer.name.to_string());
        program.variables.iter().map(|variable| variable.name.to_string()).chain(timers).collect()
    }

    #[track_caller]
    fn has(text: &str, expected: &[&str]) {
        let names = names(text);
        for name in expected {
            assert!(names.iter().any(|n| n == name), "no `{name}` in {names:?}");
        }
    }

    #[test]
    fn transitions_are_called_by_their_designation_or_by_their_steps() {
        has(
            "input a, b : bool output P : bool
            initial step 1 step 2 step Open { P } step 4 step 5
            transition (in) 1 -> 2 : a
            transition 2 -> Open, 4, 5 : b
            transition Open, 4, 5 -> 1 : a
            transition -> 4 : ↑b
            transition 5 -> : a and b
            transition (x) 4 -> 5 : ↑a
            transition (x) 5 -> 4 : ↑b",
            &["clr_in", "clr_2_Open_more", "clr_Open_more_1", "clr_to_4", "clr_5_out", "clr_4_5", "clr_5_4"],
        );
    }

    #[test]
    fn operands_are_called_by_what_they_read() {
        has(
            "input a, b, c, d : bool output P, Q : bool
            initial step 1 { P if 3s/(a and not b)/2s } step 2 { Q if 3s/a  P if 5s/a }
            transition 1 -> 2 : ↑(a or b) and ↑c
            transition 2 -> 1 : ↓(a and b and c and d)",
            &[
                "rise_a_or_b",
                "now_a_or_b",
                "rise_c",
                "fall_a_b_c_more",
                "on_a_not_b",
                "off_a_not_b",
                "held_a_not_b",
                "on_a",
                "on_a_5s",
            ],
        );
    }
}
