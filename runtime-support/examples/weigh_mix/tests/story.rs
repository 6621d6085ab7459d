//! The program plays its story.

use std::process::Command;

/// What must happen, from the chart and the figures of the plant, at scans of 100 ms:
///
/// - A flows with 20 kg/s up to 60 kg: 3 s. B with 10 kg/s up to 100 kg: 4 s. C with 25 kg/s: 4 s for 100 kg.
/// - A brick falls after each 2 s of the belt, so the second one comes 4 s after the start and stops it.
/// - Powder and bricks are in 11 s after the start. Then it mixes for 8 s, tips in 3 s, and comes back in 3 s.
/// - The emergency stop comes 1.5 s into the second batch: 30 kg of A are in the unit, and the belt is 0.5 s from the next
///   brick. D1 forces `G10{}`, which closes and stops all; then A6 forces `G10{1}`.
/// - In the third batch a brick so falls after 0.5 s and after 2.5 s, before A is weighed. All else is as in the first.
const STORY: &str = "\
time (s)  steps   weight (kg)
     0.0  operator finds the emergency stop pressed
     0.0  D1              0.0
     1.0  operator releases the emergency stop
     1.0  A6 1            0.0  manual control on
     2.0  operator selects automatic
     2.0  F1 1            0.0  manual control off
     3.0  operator presses start
     3.0  F1 2 6          0.0  valve A opens, belt runs
     3.5  operator lets go of start
     5.0  a brick falls into the mixer
     5.0  F1 2 7         40.0
     6.0  F1 3 7         60.0  valve A closes, valve B opens
     7.0  a brick falls into the mixer
     7.0  F1 3 8         70.0  belt stops
    10.0  F1 4 8        100.0  valve B closes, valve C opens
    14.0  F1 9            0.0  valve C closes, mixer turns
    22.0  F1 10           0.0  mixer tips
    25.0  100 kg and 2 bricks leave the mixer
    25.0  F1 11           0.0  mixer stops, tipping ends, mixer comes up
    28.0  F1 1            0.0  mixer is up
    30.0  operator presses start
    30.0  F1 2 6          0.0  valve A opens, belt runs
    31.5  operator presses the emergency stop
    31.5  D1             30.0  valve A closes, belt stops
    32.0  operator selects manual
    33.0  operator releases the emergency stop
    33.0  A6 1           30.0  manual control on
    34.0  operator takes the powder out of the weighing unit
    35.0  operator selects automatic
    35.0  F1 1            0.0  manual control off
    36.0  operator presses start
    36.0  F1 2 6          0.0  valve A opens, belt runs
    36.5  a brick falls into the mixer
    36.5  operator lets go of start
    36.5  F1 2 7         10.0
    38.5  a brick falls into the mixer
    38.5  F1 2 8         50.0  belt stops
    39.0  F1 3 8         60.0  valve A closes, valve B opens
    43.0  F1 4 8        100.0  valve B closes, valve C opens
    47.0  F1 9            0.0  valve C closes, mixer turns
    55.0  F1 10           0.0  mixer tips
    58.0  100 kg and 2 bricks leave the mixer
    58.0  F1 11           0.0  mixer stops, tipping ends, mixer comes up
    61.0  F1 1            0.0  mixer is up
";

#[test]
fn the_plant_does_what_the_chart_says() {
    let output = Command::new(env!("CARGO_BIN_EXE_weigh-mix")).output().expect("the program runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    assert_eq!(String::from_utf8_lossy(&output.stdout), STORY);
}
