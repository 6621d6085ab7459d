//! What the system tells a process.

/// A write beyond the limit on the size of files (`ulimit -f`) fails like any other, and is told like any other: the
/// signal that comes with it would end the process, with a temporary file left behind.
#[cfg(unix)]
pub fn keep_running_at_the_limit_of_files() {
    use std::sync::Arc;
    use std::sync::atomic::AtomicBool;
    // Nobody asks for the flag: what counts is that the signal has a handler. Without one all is as it was.
    let _ = signal_hook::flag::register(signal_hook::consts::SIGXFSZ, Arc::new(AtomicBool::new(false)));
}

/// There is no such limit.
#[cfg(not(unix))]
pub fn keep_running_at_the_limit_of_files() {}
