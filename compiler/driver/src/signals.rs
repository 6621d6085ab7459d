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

/// What ends a process from outside. While a file is being written, it is told between two calls of a chart, so that the
/// temporary file goes before the process does; told twice, it ends the process at once.
pub struct Interrupt {
    #[cfg(unix)]
    signal: std::sync::Arc<std::sync::atomic::AtomicUsize>,
}

#[cfg(unix)]
impl Interrupt {
    /// Waits for it from now on.
    pub fn awaited() -> Self {
        use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM};
        use std::sync::Arc;
        use std::sync::atomic::{AtomicBool, AtomicUsize};
        let (signal, is_told) = (Arc::new(AtomicUsize::new(0)), Arc::new(AtomicBool::new(false)));
        for number in [SIGINT, SIGTERM, SIGHUP] {
            // What cannot be awaited ends the process as ever. The order counts: the first is asked before it is told.
            let _ = signal_hook::flag::register_conditional_default(number, Arc::clone(&is_told));
            let _ = signal_hook::flag::register(number, Arc::clone(&is_told));
            let _ = signal_hook::flag::register_usize(number, Arc::clone(&signal), number as usize);
        }
        Interrupt { signal }
    }

    /// Whether it has come.
    pub fn has_come(&self) -> bool {
        self.signal.load(std::sync::atomic::Ordering::Relaxed) != 0
    }

    /// Does what it would have done.
    pub fn give_way(&self) {
        let signal = self.signal.load(std::sync::atomic::Ordering::Relaxed);
        // If that cannot be done, the run ends with its own words.
        let _ = signal_hook::low_level::emulate_default_handler(i32::try_from(signal).unwrap_or_default());
    }
}

#[cfg(not(unix))]
impl Interrupt {
    /// The process is ended as ever.
    pub fn awaited() -> Self {
        Interrupt {}
    }

    /// It is not seen.
    pub fn has_come(&self) -> bool {
        false
    }

    /// There is nothing to be done.
    pub fn give_way(&self) {}
}
