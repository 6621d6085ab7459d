//! What is found of a run between two rows of its trace, in words.

use crate::simulate::MOST_CALLS;
use grafc_diagnostics::{Code, Diagnostic, Span, render};

/// What was found before the row at hand.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Between {
    /// A delay ended at this time, and no call saw it.
    Unseen(i64),
    /// There were too many calls.
    TooMany,
}

impl Between {
    /// The message, at the times of the row at hand and of the row before it.
    pub fn told(self, here: Span, before: Span) -> Diagnostic {
        match self {
            Between::Unseen(at) => {
                let message = format!("at {at} ms a delay ends, and no row shows what follows");
                Diagnostic::new(Code::W0601, here, message)
                    .here("the next row")
                    .also(before, "the row before")
                    .note("a controller is called all the time, and would see it then")
                    .help("add a row at this time, or let the simulation call the chart there: `--events`, or `--scan 20ms`")
            }
            Between::TooMany => {
                let most = render::grouped(usize::try_from(MOST_CALLS).unwrap_or(usize::MAX));
                let message = format!("before this row there are more than {most} calls between rows");
                Diagnostic::new(Code::E0606, here, message)
                    .also(before, "the row before")
                    .help("scan less often, or only where a delay ends: `--events`; perhaps a time is mistyped")
            }
        }
    }
}
