//! The runner: phase, overruns and the end of the clock's range.

use grafc_runtime::{Chart, Flags, Runner};

/// Notes the times at which it is scanned. Its step alternates between 1 and 2.
#[derive(Default)]
struct Probe {
    scans: Vec<u32>,
    flags: Flags,
}

impl Chart for Probe {
    type Inputs = u32;
    type Outputs = Vec<u32>;
    type Step = u8;
    const NAME: &'static str = "Probe";
    const STEPS: &'static [u8] = &[1, 2];

    fn scan(&mut self, _inputs: &u32, now: u32) -> &Vec<u32> {
        self.scans.push(now);
        &self.scans
    }

    fn outputs(&self) -> &Vec<u32> {
        &self.scans
    }

    fn is_active(&self, step: u8) -> bool {
        usize::from(step) == 1 + self.scans.len() % 2
    }

    fn flags(&self) -> Flags {
        self.flags
    }

    fn clear_flags(&mut self) {
        self.flags = Flags::default();
    }

    fn reset(&mut self) {
        *self = Self::default();
    }
}

/// Polls at each of `times`: the times of the scans, and the overruns.
fn scans(period_ms: u32, times: impl IntoIterator<Item = u32>) -> (Vec<u32>, u32) {
    let mut runner = Runner::new(Probe::default(), period_ms);
    for now in times {
        let due = runner.due_in(now) == 0;
        let scanned = runner.poll(&0, now).is_some();
        assert_eq!(due, scanned, "at {now}");
        assert!(runner.due_in(now) > 0, "after the poll at {now}");
    }
    let overruns = runner.overruns();
    (runner.into_inner().scans, overruns)
}

#[test]
fn the_first_poll_scans_and_sets_the_phase() {
    assert_eq!(scans(10, 7..=37), (vec![7, 17, 27, 37], 0));
}

#[test]
fn a_late_poll_does_not_shift_the_phase() {
    // Due at 0, 10, 20, 30.
    assert_eq!(scans(10, [0, 9, 13, 19, 20, 29, 39]), (vec![0, 13, 20, 39], 0));
}

#[test]
fn missed_periods_are_counted_and_not_made_up_for() {
    // At 35 the scans of 10, 20 and 30 are due: one is done, two are missed. The next is due at 40.
    assert_eq!(scans(10, [0, 35, 39, 40]), (vec![0, 35, 40], 2));
    // At 20 those of 10 and 20 are due.
    assert_eq!(scans(10, [0, 20, 29, 30]), (vec![0, 20, 30], 1));
}

#[test]
fn the_time_until_the_next_scan() {
    let mut runner = Runner::new(Probe::default(), 10);
    assert_eq!(runner.due_in(500), 0);
    runner.poll(&0, 500);
    assert_eq!(runner.due_in(500), 10);
    assert_eq!(runner.due_in(509), 1);
    assert_eq!(runner.due_in(510), 0);
    assert_eq!(runner.due_in(999), 0);
    runner.poll(&0, 513);
    assert_eq!(runner.due_in(513), 7);
}

#[test]
fn the_clock_wraps_around() {
    // From 5 ms before the wrap to 0, every 10 ms: 5, 15. The poll at 36 does the scan of 35, that of 25 is missed.
    let start = u32::MAX - 4;
    assert_eq!(scans(10, [start, u32::MAX, 0, 4, 5, 14, 15, 36]), (vec![start, 5, 15, 36], 1));
}

#[test]
fn the_period_may_be_half_the_range_of_the_clock() {
    // 2^31 ms after 100 ms, and not a millisecond before; a longer one is taken for that.
    for period in [1 << 31, u32::MAX] {
        let due = 100 + (1 << 31);
        assert_eq!(scans(period, [100, 2_000_000_000, due - 1, due]), (vec![100, due], 0));
    }
}

#[test]
fn a_clock_that_is_put_back_starts_a_new_period() {
    // Back from 1000 to 400: no scan is due before 410, none was missed.
    assert_eq!(scans(10, [1_000, 400, 409, 410, 420]), (vec![1_000, 410, 420], 0));
    // Back by less than what has passed since the last scan makes no difference.
    assert_eq!(scans(10, [1_000, 1_008, 1_003, 1_010]), (vec![1_000, 1_010], 0));
}

#[test]
fn a_period_of_0_is_1() {
    assert_eq!(scans(0, [3, 3, 4, 6]), (vec![3, 4, 6], 1));
}

#[test]
fn the_chart_can_be_reached() {
    let chart = Probe { flags: Flags { div0: true, ..Flags::default() }, ..Probe::default() };
    let mut runner = Runner::new(chart, 10);
    assert!(runner.chart().active_steps().eq([1]));
    runner.poll(&0, 0);
    assert!(runner.chart().active_steps().eq([2]));
    assert!(runner.chart().flags().div0);
    runner.chart_mut().clear_flags();
    assert!(!runner.chart().flags().any());
    runner.chart_mut().reset();
    assert_eq!(runner.chart().outputs(), &[]);
}

#[cfg(feature = "std")]
#[test]
fn the_loop_scans_until_it_is_broken_off() {
    use std::ops::ControlFlow;

    let mut runner = Runner::new(Probe::default(), 2);
    let mut reads = Vec::new();
    let stop_after = |scans: usize| {
        move |chart: &mut Probe| {
            if chart.scans.len() == scans { ControlFlow::Break(scans) } else { ControlFlow::Continue(()) }
        }
    };
    let read = |now, inputs: &mut u32| {
        *inputs += 1;
        reads.push((now, *inputs));
    };
    assert_eq!(runner.run(read, stop_after(3)), 3);
    // Every scan is read for, and the inputs stay from one scan to the next.
    let expected: Vec<_> = runner.chart().scans.iter().copied().zip(1..).collect();
    assert_eq!(reads, expected);
    assert!(runner.chart().scans[0] < runner.chart().scans[1]);

    // A second loop goes on with the time of the first.
    assert_eq!(runner.run(|_, _| (), stop_after(5)), 5);
    assert!(runner.chart().scans.is_sorted_by(|before, after| before < after));
}
