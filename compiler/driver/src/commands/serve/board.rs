//! What is shown now, for the thread that makes pages and those that serve them.

use std::hash::{DefaultHasher, Hash, Hasher};
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

/// What is shown now.
#[derive(Default)]
pub struct Board {
    shown: Mutex<Shown>,
    changed: Condvar,
}

/// The last good page, and what is wrong with the text since.
#[derive(Clone, Default)]
pub struct Shown {
    /// Counts changes.
    pub change: u64,
    /// The last good page, and the version of the chart that it is of.
    pub page: Option<(String, String)>,
    /// The errors of the text as it is now.
    pub errors: Option<String>,
}

impl Board {
    /// A page without errors.
    pub fn good(&self, version: String, page: String) {
        self.change(|shown| {
            shown.page = Some((version, page));
            shown.errors = None;
        });
    }

    /// Errors: the last good page stays.
    pub fn faulty(&self, errors: String) {
        self.change(|shown| shown.errors = Some(errors));
    }

    /// As it is now.
    pub fn shown(&self) -> Shown {
        self.lock().clone()
    }

    /// As it is after the change with this number, or after some time as it was.
    pub fn after(&self, change: u64, longest: Duration) -> Shown {
        let waited = self.changed.wait_timeout_while(self.lock(), longest, |shown| shown.change == change);
        waited.map_or_else(|poisoned| poisoned.into_inner().0.clone(), |(shown, _)| shown.clone())
    }

    fn change(&self, how: impl FnOnce(&mut Shown)) {
        let mut shown = self.lock();
        how(&mut shown);
        shown.change += 1;
        drop(shown);
        self.changed.notify_all();
    }

    /// Whoever held it before only put whole values there.
    fn lock(&self) -> MutexGuard<'_, Shown> {
        self.shown.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Tells texts of a chart apart, and what other programs would make of them.
pub fn version(text: &str) -> String {
    let mut hasher = DefaultHasher::new();
    (env!("CARGO_PKG_VERSION"), text).hash(&mut hasher);
    format!("{:016x}", hasher.finish())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn errors_leave_the_last_good_page_and_go_with_the_next() {
        let board = Board::default();
        board.faulty("E".to_string());
        assert!(board.shown().page.is_none(), "there is none yet");
        board.good("1".to_string(), "one".to_string());
        board.faulty("E".to_string());
        let shown = board.shown();
        assert_eq!((shown.change, shown.page, shown.errors), (3, Some(("1".into(), "one".into())), Some("E".into())));
        board.good("2".to_string(), "two".to_string());
        assert_eq!(board.shown().errors, None);
    }

    #[test]
    fn who_waits_is_told_of_a_change_and_else_of_the_time() {
        let board = Board::default();
        assert_eq!(board.after(0, Duration::from_millis(1)).change, 0);
        std::thread::scope(|scope| {
            scope.spawn(|| board.faulty("E".to_string()));
            assert_eq!(board.after(0, Duration::from_secs(60)).change, 1);
        });
    }

    #[test]
    fn versions_tell_texts_apart() {
        assert_eq!(version("a"), version("a"));
        assert_ne!(version("a"), version("b"));
    }
}
