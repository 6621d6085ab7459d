//! How much is tried of what takes a tool long.
//!
//! With `cargo test` each compiler and each tool from outside is given a part of the charts, mostly a third, and each
//! another, so that who changes something waits for four minutes and not for six. Where the variable `GRAFC_THOROUGH` is
//! set they are given all, as `.ci/run` and the deliberate faults do. What needs no tool is tried as a whole in both.

use std::env;

/// Asks for everything.
pub const THOROUGH: &str = "GRAFC_THOROUGH";

/// One of so many is tried.
const PARTS: usize = 3;

/// Whether everything is tried.
pub fn is_thorough() -> bool {
    env::var_os(THOROUGH).is_some_and(|value| !value.is_empty())
}

/// Of things in order, those that a tool is given: all, or the third that begins with the one at `turn`.
pub fn share<T>(turn: usize, all: impl IntoIterator<Item = T>) -> Vec<T> {
    part(is_thorough(), turn, all)
}

/// Where the share of an executor begins.
pub fn turn_of(executor: &str) -> usize {
    executor.len()
}

/// How many there must be at least, if there must be so many of all.
pub fn at_least(of_all: usize) -> usize {
    // Those that a tool can run are not spread evenly.
    if is_thorough() { of_all } else { of_all / (2 * PARTS) }
}

fn part<T>(is_thorough: bool, turn: usize, all: impl IntoIterator<Item = T>) -> Vec<T> {
    let is_given = |(place, _): &(usize, T)| is_thorough || place % PARTS == turn % PARTS;
    all.into_iter().enumerate().filter(is_given).map(|(_, one)| one).collect()
}

#[cfg(test)]
mod tests {
    use super::part;

    #[test]
    fn thirds_are_all() {
        assert_eq!(part(true, 1, 0..7), [0, 1, 2, 3, 4, 5, 6]);
        assert_eq!(part(false, 0, 0..7), [0, 3, 6]);
        assert_eq!(part(false, 1, 0..7), [1, 4]);
        assert_eq!(part(false, 2, 0..7), [2, 5]);
        assert_eq!(part(false, 3, 0..7), [0, 3, 6]);
    }
}
