//! What the system tells a process.

pub use ending::{Interrupt, clear_up};

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

/// What ends a process from outside.
#[cfg(unix)]
mod ending {
    use grafc::files::abandon;
    use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM};
    use signal_hook::iterator::Signals;
    use signal_hook::low_level::emulate_default_handler;
    use std::sync::atomic::{AtomicBool, AtomicI32, Ordering};

    /// Whether somebody asks for the signal, and ends the work in his own way.
    static IS_AWAITED: AtomicBool = AtomicBool::new(false);
    /// The signal that has come while it was awaited; 0 if none has.
    static COME: AtomicI32 = AtomicI32::new(0);

    /// From now on no temporary file is left behind when the process is ended from outside.
    pub fn clear_up() {
        // Where that cannot be had, the process is ended as ever.
        let Ok(mut signals) = Signals::new([SIGINT, SIGTERM, SIGHUP]) else { return };
        std::thread::spawn(move || {
            for signal in signals.forever() {
                // Told twice, it ends at once, whoever asks.
                if IS_AWAITED.load(Ordering::SeqCst) && COME.swap(signal, Ordering::SeqCst) == 0 {
                    continue;
                }
                abandon();
                // If that cannot be done, the process goes on to its own end.
                let _ = emulate_default_handler(signal);
            }
        });
    }

    /// Work that is told between two steps that it is to end, so that it can say what is known so far; told twice, the
    /// process ends at once.
    pub struct Interrupt(());

    impl Interrupt {
        /// Waits for it from now on.
        pub fn awaited() -> Self {
            IS_AWAITED.store(true, Ordering::SeqCst);
            Interrupt(())
        }

        /// Whether it has come.
        pub fn has_come(&self) -> bool {
            COME.load(Ordering::Relaxed) != 0
        }
    }

    impl Drop for Interrupt {
        fn drop(&mut self) {
            IS_AWAITED.store(false, Ordering::SeqCst);
        }
    }
}

/// What ends a process from outside is not seen: it is ended as ever.
#[cfg(not(unix))]
mod ending {
    /// Nothing can be done.
    pub fn clear_up() {}

    /// What does not come.
    pub struct Interrupt(());

    impl Interrupt {
        /// It is not seen.
        pub fn awaited() -> Self {
            Interrupt(())
        }

        /// It is not seen.
        pub fn has_come(&self) -> bool {
            false
        }
    }
}
