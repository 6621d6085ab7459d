//! What all generated charts have in common, for code that works with any of them.

use crate::Flags;

/// A chart as grafc generates it.
///
/// A program that knows its chart does not need this trait: the chart has methods of the same names. It is for code
/// that takes any chart, as [`Runner`](crate::Runner) does.
pub trait Chart {
    /// The input variables.
    type Inputs;
    /// The output variables.
    type Outputs;
    /// The steps of the chart.
    type Step: Copy + 'static;

    /// The name of the chart.
    const NAME: &'static str;
    /// All steps, in the order of the text.
    const STEPS: &'static [Self::Step];

    /// One reaction to `inputs` at the time `now` (R9, or R14 in the scan profile). The first call is the initial
    /// reaction (R10).
    ///
    /// `now` counts milliseconds and wraps around: a chart must be scanned at least once in 24.8 days. A clock that is put
    /// back ends no delay.
    fn scan(&mut self, inputs: &Self::Inputs, now: u32) -> &Self::Outputs;

    /// The outputs as the last reaction published them (R11).
    fn outputs(&self) -> &Self::Outputs;

    /// Whether `step` is active.
    fn is_active(&self, step: Self::Step) -> bool;

    /// What has gone wrong since the start or since [`clear_flags`](Self::clear_flags).
    fn flags(&self) -> Flags;

    /// Lowers all flags.
    fn clear_flags(&mut self);

    /// Puts the chart back into the state before its first reaction.
    fn reset(&mut self);

    /// The active steps, in the order of the text: the situation.
    fn active_steps(&self) -> impl Iterator<Item = Self::Step> + '_ {
        Self::STEPS.iter().copied().filter(|&step| self.is_active(step))
    }
}
