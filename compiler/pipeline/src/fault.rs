//! Faults of grafc itself.
//!
//! No chart may make grafc panic. If one does, it is reported in the form of all other messages, with what is needed to
//! report it. Nothing has been written by then: commands write their output last, and whole.

use grafc_diagnostics::Code;
use std::any::Any;
use std::panic::{self, AssertUnwindSafe, PanicHookInfo};
use std::sync::{Arc, Mutex};

/// The exit code of a process that ends with one; it is that of a panic.
pub const EXIT_CODE: u8 = 101;

/// Runs something; if it panics, the error is the message to print.
///
/// Panics of other threads meanwhile are swallowed, so call it once, around everything.
pub fn guard<T>(run: impl FnOnce() -> T) -> Result<T, String> {
    let seen = Arc::new(Mutex::new(None));
    let sink = Arc::clone(&seen);
    let before = panic::take_hook();
    panic::set_hook(Box::new(move |info| {
        if let Ok(mut sink) = sink.lock() {
            sink.get_or_insert_with(|| describe(info));
        }
    }));
    let result = panic::catch_unwind(AssertUnwindSafe(run));
    panic::set_hook(before);
    result.map_err(|_| {
        let what = seen.lock().ok().and_then(|mut seen| seen.take());
        message(&what.unwrap_or_else(|| "a panic without a message".to_string()))
    })
}

/// The message to print of a panic that somebody else caught. The hook of the process has already told where it came
/// from.
pub fn of_panic(payload: &(dyn Any + Send)) -> String {
    message(&text_of(payload))
}

fn describe(info: &PanicHookInfo) -> String {
    let text = text_of(info.payload());
    match info.location() {
        Some(place) => format!("{text} ({}:{})", place.file(), place.line()),
        None => text,
    }
}

fn text_of(payload: &(dyn Any + Send)) -> String {
    let text = payload.downcast_ref::<&str>().copied().or(payload.downcast_ref::<String>().map(String::as_str));
    text.unwrap_or("a panic without a message").replace('\n', "\n    ")
}

fn message(what: &str) -> String {
    format!(
        "error[{}]: this is a fault of grafc\n  = note: {what}\n  = note: grafc {}; no output was written\n  \
         = help: please report it, with the chart and the command, at {}\n",
        Code::E0901.as_str(),
        env!("CARGO_PKG_VERSION"),
        env!("CARGO_PKG_REPOSITORY"),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    /// One test, because the hook belongs to the whole process.
    #[test]
    fn a_panic_becomes_a_message_and_a_value_passes() {
        assert_eq!(guard(|| 7), Ok(7));
        let message = guard(|| -> () { panic!("step {} lost", 3) }).unwrap_err();
        assert!(message.starts_with("error[E0901]: this is a fault of grafc\n  = note: step 3 lost ("), "{message}");
        assert!(message.contains("fault.rs:"), "{message}");
        assert!(message.contains("report it"), "{message}");
        assert!(of_panic(&"step 3 lost").contains("fault of grafc\n  = note: step 3 lost\n"));
        assert!(guard(|| -> () { panic::panic_any(5) }).unwrap_err().contains("a panic without a message"));
    }
}
