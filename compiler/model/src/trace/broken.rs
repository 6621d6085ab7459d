//! Claims that a run breaks, in words: each where it is broken first.

use crate::chart::{Chart, ClaimKind};
use grafc_diagnostics::{Code, Diagnostic, Span};

/// The claims that a run has broken so far.
#[derive(Clone, Debug, Default)]
pub struct BrokenClaims {
    /// By their places in [`Claims::list`](crate::chart::Claims::list).
    known: Vec<usize>,
    /// Those that were found since the last row, and when.
    found: Vec<(usize, i64)>,
    /// The first assumption among them that was told of.
    assumed: Option<usize>,
}

impl BrokenClaims {
    /// A call at `t_ms` broke these.
    pub fn called(&mut self, t_ms: i64, broken: &[usize]) {
        for &place in broken {
            // There are few claims, and each is found once.
            if !self.known.contains(&place) {
                self.known.push(place);
                self.found.push((place, t_ms));
            }
        }
    }

    /// The messages on those found since this was last asked, at the time of the row at hand.
    pub fn told(&mut self, chart: &Chart, here: Span) -> Vec<Diagnostic> {
        let found = std::mem::take(&mut self.found);
        let told = found.into_iter().filter_map(|(place, t_ms)| self.message(chart, here, place, t_ms));
        told.collect()
    }

    /// Whether something waits to be told.
    pub fn has_found(&self) -> bool {
        !self.found.is_empty()
    }

    fn message(&mut self, chart: &Chart, here: Span, place: usize, t_ms: i64) -> Option<Diagnostic> {
        let claim = chart.claims.list.get(place)?;
        let name = claim.name();
        match claim.kind {
            ClaimKind::Assume => {
                self.assumed.get_or_insert(place);
                let message = format!("at {t_ms} ms the inputs break an assumption: {name}");
                Some(
                    Diagnostic::new(Code::W0602, here, message)
                        .also(claim.span, "assumed here")
                        .note("nothing is claimed of what a chart does where its assumptions are not kept"),
                )
            }
            ClaimKind::Assert => {
                let message = format!("at {t_ms} ms an assertion is false: {name}");
                let mut error = Diagnostic::new(Code::E0609, here, message).also(claim.span, "asserted here");
                if let Some(assumed) = self.assumed.and_then(|place| chart.claims.list.get(place)) {
                    error = error.note(format!("an assumption has been broken by then: {}", assumed.name()));
                }
                Some(error)
            }
            ClaimKind::Reach | ClaimKind::Final => None,
        }
    }
}
