//! A chart that is scanned with a fixed period, as a cyclic task of a PLC does it.

use crate::Chart;

/// Half the range of the clock.
const HALF: u32 = 1 << 31;

/// A chart with a fixed period.
///
/// A scan is due at the first poll and then at each multiple of the period after it. A scan that comes late does not
/// shift those that follow. Scans that were missed altogether are not made up for, they are counted.
///
/// The clock `now` counts milliseconds and wraps around. Polls must not be more than half its range apart, 24.8 days: what
/// looks like more is a clock that was put back, and the next scan is due a period after that.
#[derive(Clone, Debug)]
pub struct Runner<C> {
    chart: C,
    period: u32,
    /// The last instant at which a scan was due. None before the first.
    ///
    /// The instant that has passed is kept, not the next one: the difference from it to `now` is right for any period,
    /// whereas whether a coming instant has been reached could not be told for a period of more than half the range.
    last_due: Option<u32>,
    overruns: u32,
    /// When the last scan was done: at its due instant or later.
    #[cfg(feature = "std")]
    last_scan: u32,
}

impl<C: Chart> Runner<C> {
    /// Scans `chart` every `period_ms` milliseconds; 0 is taken as 1, and more than half the range of the clock as half.
    pub const fn new(chart: C, period_ms: u32) -> Self {
        Self {
            chart,
            period: match period_ms {
                0 => 1,
                HALF.. => HALF,
                within => within,
            },
            last_due: None,
            overruns: 0,
            #[cfg(feature = "std")]
            last_scan: 0,
        }
    }

    /// Scans the chart if that is due, and gives its outputs if it was.
    pub fn poll(&mut self, inputs: &C::Inputs, now: u32) -> Option<&C::Outputs> {
        let due = match self.last_due {
            None => now,
            Some(last) if now.wrapping_sub(last) > HALF => {
                self.last_due = Some(now);
                return None;
            }
            Some(last) => {
                let periods = now.wrapping_sub(last) / self.period;
                let missed = periods.checked_sub(1)?;
                self.overruns = self.overruns.saturating_add(missed);
                last.wrapping_add(periods * self.period)
            }
        };
        self.last_due = Some(due);
        #[cfg(feature = "std")]
        {
            self.last_scan = now;
        }
        Some(self.chart.scan(inputs, now))
    }

    /// In how many milliseconds the next scan is due; 0 if it is due now.
    pub const fn due_in(&self, now: u32) -> u32 {
        match self.last_due {
            None => 0,
            Some(last) if now.wrapping_sub(last) > HALF => self.period,
            Some(last) => self.period.saturating_sub(now.wrapping_sub(last)),
        }
    }

    /// How many scans were missed because the poll came a period late, or several.
    pub const fn overruns(&self) -> u32 {
        self.overruns
    }

    /// The chart.
    pub const fn chart(&self) -> &C {
        &self.chart
    }

    /// The chart, to clear its flags or to reset it.
    pub const fn chart_mut(&mut self) -> &mut C {
        &mut self.chart
    }

    /// Gives the chart back.
    pub fn into_inner(self) -> C {
        self.chart
    }
}

#[cfg(feature = "std")]
impl<C: Chart<Inputs: Default>> Runner<C> {
    /// Scans the chart with its period until `write` breaks, and gives the value that it breaks with. In between the
    /// thread sleeps.
    ///
    /// Each time a scan is due, `read` updates the inputs, which begin with their defaults and keep what they are
    /// given. Then the chart is scanned, and `write` gets it: for its outputs, for its flags, which it may clear, and
    /// for its situation. The time begins at 0. In a runner that has scanned before it goes on from the last scan, as
    /// if the time since then had not passed.
    ///
    /// ```
    /// use core::ops::ControlFlow;
    /// use grafc_runtime::{Chart, Flags, Runner};
    ///
    /// /// A lamp that is on in step 2: 1 -(button)- 2 -(not button)- 1.
    /// #[derive(Default)]
    /// struct Lamp {
    ///     in_step_2: bool,
    ///     outputs: Outputs,
    /// }
    ///
    /// #[derive(Default)]
    /// struct Inputs {
    ///     button: bool,
    /// }
    ///
    /// #[derive(Default)]
    /// struct Outputs {
    ///     lamp: bool,
    /// }
    ///
    /// #[derive(Clone, Copy, PartialEq)]
    /// enum Step {
    ///     S1,
    ///     S2,
    /// }
    ///
    /// impl Chart for Lamp {
    ///     type Inputs = Inputs;
    ///     type Outputs = Outputs;
    ///     type Step = Step;
    ///     const NAME: &'static str = "lamp";
    ///     const STEPS: &'static [Step] = &[Step::S1, Step::S2];
    ///
    ///     fn scan(&mut self, inputs: &Inputs, _now: u32) -> &Outputs {
    ///         self.in_step_2 = inputs.button;
    ///         self.outputs.lamp = self.in_step_2;
    ///         &self.outputs
    ///     }
    ///
    ///     fn outputs(&self) -> &Outputs {
    ///         &self.outputs
    ///     }
    ///
    ///     fn is_active(&self, step: Step) -> bool {
    ///         self.in_step_2 == (step == Step::S2)
    ///     }
    ///
    ///     fn flags(&self) -> Flags {
    ///         Flags::default()
    ///     }
    ///
    ///     fn clear_flags(&mut self) {}
    ///
    ///     fn reset(&mut self) {
    ///         *self = Self::default();
    ///     }
    /// }
    ///
    /// let mut runner = Runner::new(Lamp::default(), 10);
    /// let lit_after = runner.run(
    ///     // The button is pressed after 20 ms; the time of the scan serves as its clock.
    ///     |now, inputs| inputs.button = now >= 20,
    ///     |lamp| if lamp.outputs().lamp { ControlFlow::Break("pressed") } else { ControlFlow::Continue(()) },
    /// );
    /// assert_eq!(lit_after, "pressed");
    /// assert!(runner.chart().is_active(Step::S2));
    /// ```
    pub fn run<T>(
        &mut self,
        mut read: impl FnMut(u32, &mut C::Inputs),
        mut write: impl FnMut(&mut C) -> core::ops::ControlFlow<T>,
    ) -> T {
        use core::time::Duration;

        let start = std::time::Instant::now();
        let base = self.last_scan;
        let mut inputs = C::Inputs::default();
        loop {
            let elapsed = start.elapsed();
            // Cut off on purpose: this is the wrapping clock of the chart.
            let now = base.wrapping_add(elapsed.as_millis() as u32);
            let wait = self.due_in(now);
            if wait > 0 {
                // Up to the instant itself: `now` has lost the part of a millisecond that has passed already.
                let begun = Duration::from_nanos(u64::from(elapsed.subsec_nanos() % 1_000_000));
                std::thread::sleep(Duration::from_millis(u64::from(wait)).saturating_sub(begun));
                continue;
            }
            read(now, &mut inputs);
            self.poll(&inputs, now);
            if let core::ops::ControlFlow::Break(value) = write(&mut self.chart) {
                return value;
            }
        }
    }
}
