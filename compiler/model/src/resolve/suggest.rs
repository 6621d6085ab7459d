//! Near names for a name that means nothing.
//!
//! Every look goes over all names of the chart, so only the first few unknown names get one: a file of 100,000 unknown
//! names must not cost 100,000 looks.

use grafc_syntax::spelling::distance;
use std::cell::Cell;

/// How many unknown names are looked at.
const LOOKS: u32 = 20;

/// Finds near names while it is patient.
pub struct Suggestions {
    left: Cell<u32>,
}

impl Suggestions {
    /// Fresh patience.
    pub fn new() -> Self {
        Suggestions { left: Cell::new(LOOKS) }
    }

    /// Whether it still looks.
    pub fn is_patient(&self) -> bool {
        self.left.get() > 0
    }

    /// The candidate nearest to `wanted`, the first one of equals; none if all are too far off.
    pub fn nearest<'n>(&self, wanted: &str, candidates: impl Iterator<Item = &'n str>) -> Option<&'n str> {
        let left = self.left.get().checked_sub(1)?;
        self.left.set(left);
        let folded = wanted.to_lowercase();
        // Numbers are all near to each other, and nearness says nothing there.
        if folded.bytes().all(|byte| byte.is_ascii_digit()) {
            return None;
        }
        let reach = match folded.chars().count() {
            0..=2 => 0,
            3..=5 => 1,
            _ => 2,
        };
        candidates
            .filter(|candidate| candidate.len().abs_diff(wanted.len()) <= 8)
            .filter_map(|candidate| Some((distance(&folded, &candidate.to_lowercase(), reach)?, candidate)))
            .min_by_key(|&(distance, _)| distance)
            .map(|(_, candidate)| candidate)
    }
}

#[cfg(test)]
mod tests {
    use super::Suggestions;

    fn nearest(wanted: &str, candidates: &[&'static str]) -> Option<&'static str> {
        Suggestions::new().nearest(wanted, candidates.iter().copied())
    }

    #[test]
    fn a_slip_of_the_finger_is_found() {
        assert_eq!(nearest("valev", &["motor", "valve"]), Some("valve"));
        assert_eq!(nearest("CS", &["z", "cs"]), Some("cs"));
        assert_eq!(nearest("mix_tyme", &["mix_time", "mix_timer"]), Some("mix_time"));
    }

    #[test]
    fn what_is_far_off_is_not() {
        assert_eq!(nearest("a", &["b", "c"]), None);
        assert_eq!(nearest("motor", &["valve"]), None);
        assert_eq!(nearest("13", &["12", "23"]), None);
    }

    #[test]
    fn patience_ends() {
        let suggestions = Suggestions::new();
        for _ in 0..super::LOOKS {
            assert!(suggestions.nearest("valev", ["valve"].into_iter()).is_some());
        }
        assert_eq!(suggestions.nearest("valev", ["valve"].into_iter()), None);
    }
}
