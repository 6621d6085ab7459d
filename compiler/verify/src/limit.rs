//! Why a search ended before its end.

use std::fmt;

/// What a search ran into.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Limit {
    /// There are more states than may be kept.
    States,
    /// There are more paths of inputs than may be walked.
    Paths,
    /// There are more nodes in the diagrams than may be kept.
    Nodes,
    /// A number counts on for longer than is followed.
    Numbers,
    /// Neither a way that is near nor a proof was found.
    Depth,
    /// The time is over.
    Time,
    /// Somebody interrupted it.
    Interrupted,
    /// All that was looked for was found.
    Enough,
}

impl fmt::Display for Limit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Limit::States => "there are more states than are kept",
            Limit::Paths => "there are more paths of inputs than are walked",
            Limit::Nodes => "the diagrams take more nodes than are kept",
            Limit::Numbers => "a number counts on for longer than is followed, and may be what it takes",
            Limit::Depth => "neither a way that is near nor a proof by induction was found",
            Limit::Time => "the time is over",
            Limit::Interrupted => "interrupted",
            Limit::Enough => "all that was looked for was found",
        })
    }
}
