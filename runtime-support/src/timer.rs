//! The on-delay: TON of IEC 61131-3, over a clock that wraps around.

/// An on-delay in the sense of TON (IEC 61131-3): it measures for how long its
/// input has been true without interruption.
///
/// The clock `now` counts milliseconds and wraps around every 49.7 days. So a
/// timer must be called at least once in half that time, but it may run longer.
/// What looks like more than half the range between two calls is a clock that was
/// put back: it counts as no time, so that no delay ends by it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Timer {
    /// How long the input had been true at the last call, in milliseconds.
    elapsed: i64,
    /// The time of the last call in which the input was true.
    last: u32,
    /// The input of the last call.
    running: bool,
}

impl Timer {
    /// The longest time between two calls, in milliseconds: half the range.
    const LONGEST_GAP: u32 = 1 << 31;

    /// A timer whose input is false.
    #[inline]
    pub const fn new() -> Self {
        Self {
            elapsed: 0,
            // It is not read before the timer starts.
            last: 0,
            running: false,
        }
    }

    /// Brings the timer up to date. All that is asked of it afterwards holds for
    /// this very `now`.
    #[inline]
    pub fn call(&mut self, input: bool, now: u32) {
        if !input {
            self.elapsed = 0;
        } else if self.running {
            // The difference is right across the end of the clock's range too.
            let passed = now.wrapping_sub(self.last);
            if passed <= Self::LONGEST_GAP {
                self.elapsed = self.elapsed.saturating_add(i64::from(passed));
            }
            self.last = now;
        } else {
            self.elapsed = 0;
            self.last = now;
        }
        self.running = input;
    }

    /// Whether the input has been true for `preset` milliseconds. The interval is
    /// closed (rule X5): this is so from the very instant start + preset.
    #[inline]
    pub const fn has_run(&self, preset: i64) -> bool {
        self.running && self.elapsed >= preset
    }

    /// How long the input has been true, in milliseconds; 0 while it is false.
    #[inline]
    pub const fn elapsed(&self) -> i64 {
        self.elapsed
    }

    /// What is to be saved of the timer: whether it runs, and for how long it has.
    #[inline]
    pub const fn state(&self) -> (bool, i64) {
        (self.running, self.elapsed)
    }

    /// The timer that was saved as `state`, going on at `now`. The time in between
    /// does not count. None if no timer has this state: an elapsed time is not
    /// negative, and of a timer that does not run it is 0.
    pub const fn resumed(state: (bool, i64), now: u32) -> Option<Self> {
        let (running, elapsed) = state;
        if elapsed < 0 || (!running && elapsed > 0) {
            return None;
        }
        let mut timer = Self::new();
        if running {
            timer.running = true;
            timer.last = now;
            timer.elapsed = elapsed;
        }
        Some(timer)
    }
}
