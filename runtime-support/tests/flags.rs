//! The flags.

use grafc_runtime::Flags;

#[test]
fn each_flag_counts() {
    let none = Flags::default();
    assert!(!none.any());
    assert!(Flags { livelock: true, ..none }.any());
    assert!(Flags { alloc_conflict: true, ..none }.any());
    assert!(Flags { force_conflict: true, ..none }.any());
    assert!(Flags { div0: true, ..none }.any());
}
