//! Claims: their conditions, into a pool of their own.
//!
//! `at most one of a, b, c` becomes `not (b and a or c and (a or b))`, which grows with the list and not with its pairs;
//! `after X5 : c` becomes `not X5 or c`.

use super::expressions::{Context, Need, Scratch};
use super::parts::Parts;
use crate::chart::{Claim, ClaimBody, Claims, Expr, ExprId, ExprKind, Type, Value};
use crate::symbols::Symbols;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics, Span};
use grafc_syntax::ast;

/// What stands with the activity of a step, and what to write where it is none.
const AFTER: (&str, &str) =
    ("after", "name a step, as in `after X5 : …`; what follows from another condition is asserted as `not … or …`");
const LEADS: (&str, &str) = ("leads to", "name two steps, as in `X6 leads to X11`");

/// All claims; those with faults are reported and left out, and then the second part is false.
pub fn read<'a>(
    parts: &Parts<'a>,
    context: Context<'_, 'a>,
    symbols: &mut Symbols,
    diagnostics: &mut Diagnostics,
) -> (Claims, bool) {
    let mut reading = Reading { context, symbols, diagnostics, scratch: Scratch::default(), claims: Claims::default() };
    let mut complete = true;
    for claim in &parts.claims {
        complete &= reading.claim(claim).is_some();
    }
    (reading.claims, complete)
}

struct Reading<'r, 'c, 'a> {
    context: Context<'c, 'a>,
    symbols: &'r mut Symbols,
    diagnostics: &'r mut Diagnostics,
    scratch: Scratch,
    claims: Claims,
}

impl Reading<'_, '_, '_> {
    fn claim(&mut self, claim: &ast::Claim) -> Option<()> {
        let first = self.claims.exprs.next_idx();
        let body = match &claim.body {
            ast::ClaimBody::Condition(condition) => ClaimBody::Condition(self.condition(*condition)?),
            ast::ClaimBody::AtMostOne(conditions) => {
                // Each is looked at, so that all faults are found.
                let conditions: Vec<_> = conditions.iter().map(|condition| self.condition(*condition)).collect();
                let conditions: Option<Vec<ExprId>> = conditions.into_iter().collect();
                ClaimBody::Condition(self.at_most_one(&conditions?, claim.span))
            }
            ast::ClaimBody::After(step, holds) => {
                let (step, holds) = (self.activity(*step, AFTER), self.condition(*holds));
                let (step, holds) = (step?, holds?);
                let inactive = self.push(ExprKind::Not(step), self.claims.exprs[step].span);
                ClaimBody::Condition(self.push(ExprKind::Or(inactive, holds), claim.span))
            }
            ast::ClaimBody::Leads(from, to) => {
                let (from, to) = (self.activity(*from, LEADS), self.activity(*to, LEADS));
                ClaimBody::Leads(from?, to?)
            }
        };
        self.claims.list.push(Claim {
            kind: claim.kind,
            text: claim.text.as_ref().map(|text| text.text.clone().into()),
            written: claim.written.clone(),
            body,
            pool: (first, self.claims.exprs.next_idx()),
            keyword: claim.keyword,
            span: claim.span,
        });
        Some(())
    }

    fn condition(&mut self, written: ast::ExprId) -> Option<ExprId> {
        let Reading { context, symbols, diagnostics, scratch, claims } = self;
        context.resolve(written, Need::Condition, &mut claims.exprs, scratch, symbols, diagnostics)
    }

    /// The activity of a step or macro-step, which `after` and `leads to` are about.
    fn activity(&mut self, written: ast::ExprId, (word, help): (&str, &str)) -> Option<ExprId> {
        let id = self.condition(written)?;
        let expr = &self.claims.exprs[id];
        if matches!(expr.kind, ExprKind::StepActive(_) | ExprKind::MacroActive(_)) {
            return Some(id);
        }
        let message = format!("`{word}` is about the activity of steps");
        self.diagnostics.push(Diagnostic::new(Code::E0418, expr.span, message).help(help));
        None
    }

    fn at_most_one(&mut self, conditions: &[ExprId], span: Span) -> ExprId {
        // Whether one of those before holds, and whether two of them do.
        let (mut one, mut two) = (None, None);
        for &condition in conditions {
            let Some(before) = one else {
                one = Some(condition);
                continue;
            };
            let both = self.push(ExprKind::And(condition, before), span);
            two = Some(two.map_or(both, |two| self.push(ExprKind::Or(two, both), span)));
            one = Some(self.push(ExprKind::Or(before, condition), span));
        }
        match two {
            Some(two) => self.push(ExprKind::Not(two), span),
            None => self.push(ExprKind::Literal(Value::Bool(true)), span),
        }
    }

    fn push(&mut self, kind: ExprKind, span: Span) -> ExprId {
        self.claims.exprs.push(Expr { kind, ty: Type::Bool, span })
    }
}

#[cfg(test)]
mod tests {
    use crate::chart::ClaimKind;
    use crate::checks::testing::{breaks, breaks_all, chart, passes};
    use crate::dump::expression;

    const CHART: &str = "input a, b, c : bool input n : int output V : bool initial step 1 step 2 { V }
        transition 1 -> 2 : a transition 2 -> 1 : b and not c and [n > 3] ";

    #[test]
    fn every_form() {
        let text = format!(
            "{CHART} assume at most one of a, b or c, ↑a assume \"inputs\" : not (a and b) assert after X2 : V
             assert X1 leads to X2 reach [T2 >= 3s] final XG1"
        );
        let chart = chart(&text);
        let shown = |at: usize| {
            let claim = &chart.claims.list[at];
            (claim.name().to_owned(), claim.condition().map(|id| expression(&chart.claims.exprs, &chart, id)))
        };
        let condition = |text: &str| Some(text.to_owned());
        // a, then b or c with a, then ↑a with one of these.
        let one = "not (((b or c) and a) or (↑a and (a or (b or c))))";
        assert_eq!(shown(0), ("at most one of a, b or c, ↑a".to_owned(), condition(one)));
        assert_eq!(shown(1), ("inputs".to_owned(), condition("not (a and b)")));
        assert_eq!(shown(2), ("after X2 : V".to_owned(), condition("not X2 or V")));
        assert_eq!(shown(3), ("X1 leads to X2".to_owned(), None));
        assert_eq!(shown(4), ("[T2 >= 3s]".to_owned(), condition("T2 >= 3000ms")));
        assert_eq!(shown(5), ("XG1".to_owned(), condition("XG1")));
        let numbers: Vec<usize> = chart.claims.assertions().map(|(number, ..)| number).collect();
        assert_eq!((numbers, chart.claims.of(ClaimKind::Assert).count()), (vec![1], 2));
    }

    #[test]
    fn what_is_no_step() {
        breaks("E0418", &format!("{CHART} assert after a : V"));
        breaks("E0418", &format!("{CHART} assert after XG1 : V"));
        breaks_all(&["E0418", "E0418"], &format!("{CHART} assert (X1 and a) leads to V"));
        passes(&format!("{CHART} macro step M5 expansion M5 {{ step E5 step S5 }} assert XM5 leads to (X1)"));
    }

    #[test]
    fn within_blocks() {
        passes("input a : bool grafcet G1 { initial step 1 assert X1 transition 1 -> 2 : a assume not a step 2 }");
    }

    #[test]
    fn faults_of_one_do_not_hide_those_of_another() {
        breaks_all(
            &["E0201", "E0201", "E0206", "E0201", "E0206"],
            &format!("{CHART} assume at most one of x, a, y assert n assert after X2 : z reach T2"),
        );
        breaks("E0205", &format!("{CHART} assert [n > a]"));
    }
}
