//! The on-delay (rule X5). What is expected is worked out from the rule.

use grafc_runtime::Timer;

/// Calls a new timer with each input and time, and looks each time whether it has run for `preset`.
fn series(preset: i64, calls: &[(bool, u32)]) -> Vec<bool> {
    let mut timer = Timer::new();
    let look = |&(input, now): &(bool, u32)| {
        timer.call(input, now);
        timer.has_run(preset)
    };
    calls.iter().map(look).collect()
}

#[test]
fn it_takes_16_bytes() {
    assert_eq!(size_of::<Timer>(), 16);
}

#[test]
fn a_new_timer_has_not_run_even_for_no_time() {
    assert!(!Timer::new().has_run(0));
    assert_eq!(Timer::new(), Timer::default());
}

#[test]
fn three_seconds_end_at_the_very_instant() {
    let calls = [(false, 0), (true, 500), (true, 3499), (true, 3500), (true, 9000), (false, 9001)];
    assert_eq!(series(3000, &calls), [false, false, false, true, true, false]);
}

#[test]
fn the_first_call_starts_it() {
    assert_eq!(series(3000, &[(true, 0), (true, 2999), (true, 3000)]), [false, false, true]);
}

#[test]
fn a_delay_of_no_time_follows_the_input() {
    assert_eq!(series(0, &[(false, 5), (true, 5), (false, 6)]), [false, true, false]);
}

#[test]
fn an_input_that_falls_too_early_starts_over() {
    let calls = [(true, 0), (true, 2999), (false, 3000), (true, 3001), (true, 6000), (true, 6001)];
    assert_eq!(series(3000, &calls), [false, false, false, false, false, true]);
}

#[test]
fn it_does_not_start_again_while_the_input_stays() {
    let mut timer = Timer::new();
    for (now, elapsed) in [(10, 0), (20, 10), (20, 10), (1020, 1010), (5010, 5000)] {
        timer.call(true, now);
        assert_eq!(timer.elapsed(), elapsed, "at {now}");
    }
    timer.call(false, 5020);
    assert_eq!(timer.elapsed(), 0);
    timer.call(true, 5030);
    assert_eq!(timer.elapsed(), 0);
    timer.call(true, 5031);
    assert_eq!(timer.elapsed(), 1);
}

#[test]
fn one_run_serves_several_presets() {
    let mut timer = Timer::new();
    timer.call(true, 0);
    timer.call(true, 700);
    assert!(timer.has_run(699));
    assert!(timer.has_run(700));
    assert!(!timer.has_run(701));
}

#[test]
fn the_clock_wraps_around_while_it_runs() {
    // 501 ms up to the wrap to 0, so 1000 ms are over at 499.
    let start = u32::MAX - 500;
    let calls = [(true, start), (true, u32::MAX), (true, 0), (true, 498), (true, 499)];
    assert_eq!(series(1000, &calls), [false, false, false, false, true]);
}

#[test]
fn a_delay_may_be_longer_than_the_range_of_the_clock() {
    // 100 days of 86 400 000 ms, called once a day.
    const DAY: u32 = 86_400_000;
    let mut timer = Timer::new();
    let mut now = 12_345_u32;
    timer.call(true, now);
    for day in 1..100 {
        now = now.wrapping_add(DAY);
        timer.call(true, now);
        assert!(!timer.has_run(8_640_000_000), "on day {day}");
    }
    timer.call(true, now.wrapping_add(DAY - 1));
    assert!(!timer.has_run(8_640_000_000));
    timer.call(true, now.wrapping_add(DAY));
    assert!(timer.has_run(8_640_000_000));
}

/// Half the range of 2^32 ms, no more: beyond that the clock has been put back.
#[test]
fn calls_may_be_half_the_range_apart() {
    let mut timer = Timer::new();
    timer.call(true, 7);
    timer.call(true, 7 + (1 << 31));
    assert_eq!(timer.elapsed(), 2_147_483_648);
    timer.call(true, 7);
    assert_eq!(timer.elapsed(), 4_294_967_296);
    timer.call(true, 8 + (1 << 31));
    assert_eq!(timer.elapsed(), 4_294_967_296);
}

#[test]
fn a_clock_that_is_put_back_ends_no_delay() {
    // 3 h are 10 800 000 ms. Back by 1 ms, by an hour, and over the wrap to 0: no time passes, then it goes on.
    for (start, back) in [(1_000, 999), (4_000_000, 400_000), (5, u32::MAX - 5), (0, u32::MAX)] {
        let mut timer = Timer::new();
        timer.call(true, start);
        timer.call(true, back);
        assert_eq!(timer.elapsed(), 0, "from {start} to {back}");
        timer.call(true, back.wrapping_add(10_799_999));
        assert!(!timer.has_run(10_800_000));
        timer.call(true, back.wrapping_add(10_800_000));
        assert!(timer.has_run(10_800_000));
    }
}

#[test]
fn the_elapsed_time_does_not_overflow() {
    let mut timer = Timer::resumed((true, i64::MAX - 1), 0).unwrap();
    timer.call(true, 5);
    assert_eq!(timer.elapsed(), i64::MAX);
    assert!(timer.has_run(i64::MAX));
}

#[test]
fn a_resumed_timer_goes_on() {
    let mut timer = Timer::new();
    timer.call(true, 1000);
    timer.call(true, 2200);
    assert_eq!(timer.state(), (true, 1200));

    // 1200 ms are over; the remaining 1800 ms of 3 s end at 51 800 of the new clock.
    let mut timer = Timer::resumed(timer.state(), 50_000).unwrap();
    assert_eq!(timer.state(), (true, 1200));
    timer.call(true, 51_799);
    assert!(!timer.has_run(3000));
    timer.call(true, 51_800);
    assert!(timer.has_run(3000));
}

#[test]
fn a_stopped_timer_resumes_as_stopped() {
    assert_eq!(Timer::new().state(), (false, 0));
    assert_eq!(Timer::resumed((false, 0), 99), Some(Timer::new()));
}

#[test]
fn a_state_that_no_timer_has_is_refused() {
    assert_eq!(Timer::resumed((false, 1200), 99), None);
    assert_eq!(Timer::resumed((false, -1), 99), None);
    assert_eq!(Timer::resumed((true, -5), 99), None);
    assert_eq!(Timer::resumed((true, i64::MIN), 99), None);
}
