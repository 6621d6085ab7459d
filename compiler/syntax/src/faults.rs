//! How many faults are listed.

/// Beyond so many faults of one kind a text is not a chart, and the rest is not listed.
pub(crate) const MOST_FAULTS: usize = 200;
