//! The parts that grafc copies keep what the copying relies on.
#![cfg(feature = "source")]

use grafc_runtime::source::{FLAGS, NUMBER, SAVED, TIMER};

#[test]
fn each_part_stands_alone() {
    for part in [TIMER, NUMBER, FLAGS, SAVED] {
        assert!(part.starts_with("//! "));
        for line in part.lines() {
            assert!(line.chars().count() < 84, "too long once it is indented: {line}");
            assert!(!line.contains("crate::") && !line.contains("super::"), "{line}");
            // An import could clash with that of another part.
            assert!(!line.starts_with("use "), "{line}");
            // No feature but the one whose lines are left out, and no tests.
            assert!(!line.contains("cfg") || line.starts_with(r#"#[cfg_attr(feature = "serde", "#), "{line}");
        }
    }
}
