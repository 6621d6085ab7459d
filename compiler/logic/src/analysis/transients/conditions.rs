//! What changes a condition at a moment when certain steps are known to be active.
//!
//! A transition that clears had its steps active already, so that one of them has just been deactivated is no reason
//! for its condition to hold: `not 3s/X5` after step 5 does not come true by leaving step 5. Therefore conditions are
//! not taken as a whole, as other expressions are, but followed down to what they read; what tells an edge, a wire or a
//! number is left to `values`.

use super::causes::{Causes, Change, Way};
use super::values::Occasion;
use grafc_model::chart::{Comparison, ExprId, ExprKind, StepId};
use grafc_net::Net;
use index_vec::IndexVec;

/// A longer condition is taken as a whole.
const LONGEST: usize = 1024;

/// Adds what changes a condition that way in a micro-step, other than what the micro-step before did to steps of which
/// `unchanged` is true.
pub(super) fn add(
    net: &Net,
    occasions: &IndexVec<ExprId, Occasion>,
    (condition, whole): (ExprId, Way),
    unchanged: &dyn Fn(StepId) -> bool,
    effect: Change,
    causes: &mut Causes,
) {
    let (mut first, mut open) = (Some((condition, whole)), Vec::new());
    let mut followed = 0;
    while let Some((e, way)) = first.take().or_else(|| open.pop()) {
        followed += 1;
        if followed > LONGEST {
            causes.at_once(Change::Expr(condition, whole), effect);
            return;
        }
        let is_event = way == Way::Up && occasions[e] != Occasion::Level;
        match net.exprs[e].kind {
            ExprKind::And(a, b) | ExprKind::Or(a, b) if !is_event => open.extend([(a, way), (b, way)]),
            ExprKind::Not(a) => open.push((a, way.other())),
            ExprKind::Delay { on, operand, off } => {
                let follows = match way {
                    Way::Up => on.ms <= 0,
                    Way::Down => off.ms <= 0,
                };
                if follows {
                    open.push((operand, way));
                }
            }
            ExprKind::StepActive(s) => {
                if !unchanged(s) {
                    let cause = if way == Way::Up { Change::Activated(s) } else { Change::Deactivated(s) };
                    causes.next(cause, effect);
                }
            }
            ExprKind::Compare(op, a, b) => {
                for (side, op) in [(a, op), (b, op.mirrored())] {
                    match (&net.exprs[side].kind, op) {
                        // It falls to zero when its step is deactivated.
                        (ExprKind::StepTime(s), _) if unchanged(*s) => {}
                        (_, Comparison::Less | Comparison::LessEqual) => {
                            causes.at_once(Change::Expr(side, way.other()), effect);
                        }
                        (_, Comparison::Greater | Comparison::GreaterEqual) => {
                            causes.at_once(Change::Expr(side, way), effect);
                        }
                        (_, Comparison::Equal | Comparison::NotEqual) => {
                            Way::BOTH.into_iter().for_each(|w| causes.at_once(Change::Expr(side, w), effect));
                        }
                    }
                }
            }
            ExprKind::And(..)
            | ExprKind::Or(..)
            | ExprKind::Xor(..)
            | ExprKind::Literal(_)
            | ExprKind::Variable(_)
            | ExprKind::StepTime(_)
            | ExprKind::MacroActive(_)
            | ExprKind::GrafcetActive(_)
            | ExprKind::GrafcetFrozen(_)
            | ExprKind::Rise(_)
            | ExprKind::Fall(_)
            | ExprKind::Arithmetic(..)
            | ExprKind::Negate(_)
            | ExprKind::Widen(_) => causes.at_once(Change::Expr(e, way), effect),
        }
    }
}
