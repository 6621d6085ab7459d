//! Pairs of which something is true, without comparing each with each.

/// Each is compared with this many that follow it.
const NEAR: usize = 16;

/// The first pair of which something is true, those looked at first that stand next to each other.
pub(super) fn first(count: usize, mut is_wanted: impl FnMut(usize, usize) -> bool) -> Option<(usize, usize)> {
    (1..=NEAR).find_map(|distance| {
        let last = count.saturating_sub(distance);
        (0..last).map(|a| (a, a + distance)).find(|(a, b)| is_wanted(*a, *b))
    })
}
