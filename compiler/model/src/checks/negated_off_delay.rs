//! W0423: `not` before an off-delay, without parentheses.
//!
//! `not a/5s` is `not (a/5s)`: a time operator binds more tightly than `not`. It can be taken for `(not a)/5s`, which is
//! something else: the first is true once `a` has been false for 5 s, the second while `a` is false and for 5 s after.
//! A duration cannot be negated, so `not 6s/X28` (symbol 25) has one reading only.
//!
//! Warned of: `V if not a/5s`
//! Not warned of: `V if not (a/5s)`, `V if (not a)/5s`, `V if not 6s/X28`

use crate::chart::ExprKind;
use crate::resolve::Resolved;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics, Fix};

/// One warning per `not`.
pub fn check(resolved: &Resolved, diagnostics: &mut Diagnostics) {
    let exprs = &resolved.chart.exprs;
    for expr in exprs {
        let ExprKind::Not(inner) = expr.kind else { continue };
        let ExprKind::Delay { on, operand, off } = exprs[inner].kind else { continue };
        // With parentheses the negation ends behind them.
        let (whole, delay) = (expr.span, exprs[inner].span);
        let begins_with_operand = exprs[operand].span.start <= delay.start + 1 && on.ms == 0 && on.constant.is_none();
        if !begins_with_operand || (off.ms == 0 && off.constant.is_none()) || whole.end != delay.end {
            continue;
        }
        let mut diagnostic = Diagnostic::new(Code::W0423, whole, "`not` before an off-delay can be read in two ways")
            .note(
                "it is `not (e/t)`: true once `e` has been false for the time; `(not e)/t` is true while `e` is \
                   false, and for the time after that",
            )
            .help("write the parentheses")
            .fix(
                Fix::maybe("write `not (e/t)`, which it is now")
                    .replace(delay.before(), "(")
                    .replace(delay.behind(), ")"),
            );
        if is_name(exprs[operand].kind) {
            let title = Fix::maybe("write `(not e)/t`, which is something else");
            diagnostic = diagnostic.fix(title.replace(whole.before(), "(").replace(exprs[operand].span.behind(), ")"));
        }
        diagnostics.push(diagnostic);
    }
}

/// Whether an operand of a delay is written without parentheses.
fn is_name(kind: ExprKind) -> bool {
    matches!(
        kind,
        ExprKind::Variable(_)
            | ExprKind::StepActive(_)
            | ExprKind::MacroActive(_)
            | ExprKind::GrafcetActive(_)
            | ExprKind::GrafcetFrozen(_)
    )
}

#[cfg(test)]
mod tests {
    use crate::checks::testing::{passes, passes_with};

    fn with(condition: &str) -> String {
        format!("input a, b : bool output V : bool const t : time := 1s initial step 1 {{ V if {condition} }}")
    }

    #[test]
    fn without_parentheses() {
        passes_with(&["W0423"], &with("not a/5s"));
        passes_with(&["W0423"], &with("b and not a/t or b"));
        passes_with(&["W0423"], &with("not (a or b)/5s"));
    }

    #[test]
    fn with_parentheses_or_an_on_delay() {
        passes(&with("not (a/5s)"));
        passes(&with("(not a)/5s"));
        passes(&with("not 6s/X1"));
        passes(&with("not 6s/a/2s"));
        passes(&with("not t/a"));
    }
}
