//! The feature `serde`.
#![cfg(feature = "serde")]

use grafc_runtime::{Flags, Timer};

#[test]
fn a_timer_goes_there_and_back() {
    let mut timer = Timer::new();
    timer.call(true, 40);
    timer.call(true, 100);
    let text = serde_json::to_string(&timer).unwrap();
    assert_eq!(text, r#"{"elapsed":60,"last":100,"running":true}"#);
    assert_eq!(serde_json::from_str::<Timer>(&text).unwrap(), timer);
}

#[test]
fn flags_go_there_and_back() {
    let flags = Flags { div0: true, ..Flags::default() };
    let text = serde_json::to_string(&flags).unwrap();
    assert_eq!(text, r#"{"livelock":false,"alloc_conflict":false,"force_conflict":false,"div0":true}"#);
    assert_eq!(serde_json::from_str::<Flags>(&text).unwrap(), flags);
}
