//! Which warnings are errors, and which are not wanted, as the caller decides for all texts.

use crate::{Allowed, Code, Diagnostics, Severity};
use std::collections::BTreeSet;

/// What is done with warnings. What is allowed, here or in the text, is not denied.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub struct Policy {
    /// Every warning is an error.
    pub deny_all: bool,
    /// These warnings are errors.
    pub deny: BTreeSet<Code>,
    /// These warnings are not shown.
    pub allow: BTreeSet<Code>,
}

impl Policy {
    /// Applies it to messages. Doing so again changes nothing.
    pub fn apply(&self, said: &mut Diagnostics) {
        let is_warning = |code: Code| code.severity() == Severity::Warning;
        if !self.allow.is_empty() {
            said.set_aside(|diagnostic| {
                let allowed = is_warning(diagnostic.code) && self.allow.contains(&diagnostic.code);
                allowed.then_some(Allowed { reason: None, span: None })
            });
        }
        for diagnostic in said.iter_mut() {
            diagnostic.is_denied |=
                is_warning(diagnostic.code) && (self.deny_all || self.deny.contains(&diagnostic.code));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Diagnostic, Span};

    fn judged(policy: &Policy) -> (Vec<(Code, Severity)>, Vec<Code>) {
        let mut said = Diagnostics::new();
        for code in [Code::W0401, Code::W0409, Code::E0201] {
            said.push(Diagnostic::new(code, Span::default(), "m"));
        }
        policy.apply(&mut said);
        policy.apply(&mut said);
        let shown = said.iter().map(|d| (d.code, d.severity())).collect();
        (shown, said.allowed().iter().map(|(d, _)| d.code).collect())
    }

    #[test]
    fn what_is_denied_is_an_error_and_what_is_allowed_is_set_aside() {
        use Severity::{Error, Warning};
        let (w1, w9, e) = (Code::W0401, Code::W0409, (Code::E0201, Error));
        let nothing = Policy::default();
        assert_eq!(judged(&nothing), (vec![(w1, Warning), (w9, Warning), e], vec![]));
        let one = Policy { deny: [w9].into(), ..nothing.clone() };
        assert_eq!(judged(&one), (vec![(w1, Warning), (w9, Error), e], vec![]));
        let all_but_one = Policy { deny_all: true, allow: [w9].into(), ..nothing.clone() };
        assert_eq!(judged(&all_but_one), (vec![(w1, Error), e], vec![w9]));
        let an_error = Policy { allow: [Code::E0201].into(), ..nothing };
        assert_eq!(judged(&an_error), (vec![(w1, Warning), (w9, Warning), e], vec![]));
    }
}
