//! What the language of charts can say so far. What it cannot is reported as lost where a file has it.

/// `n := n + 1 each scan if c`.
pub const EACH_SCAN: bool = true;

/// `chart M evolution scan`.
pub const HEAD_OPTIONS: bool = true;
