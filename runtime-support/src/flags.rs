//! The flags by which a chart tells that something went wrong at run time.

/// What has gone wrong since the start or since the flags were last cleared. A
/// flag stays raised once it is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Flags {
    /// LIVELOCK: the situation did not become stable within the bound of
    /// micro-steps. The reaction stopped there, and the next call went on (R9).
    pub livelock: bool,
    /// ALLOC_CONFLICT: two stored actions gave one variable different values at
    /// the same time; the last assignment won (R7).
    pub alloc_conflict: bool,
    /// FORCE_CONFLICT: two forcing orders asked for different situations of one
    /// grafcet; the order of the highest grafcet, then the first, won (R2).
    pub force_conflict: bool,
    /// DIV0: something was divided by zero; the result was 0.
    pub div0: bool,
}

impl Flags {
    /// Whether any flag is raised.
    #[inline]
    pub const fn any(&self) -> bool {
        self.livelock || self.alloc_conflict || self.force_conflict || self.div0
    }
}
