//! How far a long run has come: a bar on standard error, where somebody sits before it.

use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::io::IsTerminal;
use std::time::{Duration, Instant};

/// A run that is over by then needs no bar.
const PATIENCE: Duration = Duration::from_secs(2);

/// How far a run has come.
pub struct Progress {
    bar: ProgressBar,
    begun: Instant,
    is_shown: bool,
}

impl Progress {
    /// A run over a text of so many bytes, if that is known; none if nobody would see it.
    pub fn new(length: Option<u64>) -> Option<Progress> {
        std::io::stderr().is_terminal().then(|| Progress::on(length, ProgressDrawTarget::hidden()))
    }

    /// A search, of which nobody knows how long it takes; none if nobody would see it.
    pub fn of_search() -> Option<Progress> {
        let progress = Progress::new(None)?;
        if let Ok(style) = ProgressStyle::with_template("{spinner} {msg}, {elapsed}") {
            progress.bar.set_style(style);
        }
        Some(progress)
    }

    fn on(length: Option<u64>, target: ProgressDrawTarget) -> Progress {
        let bar = ProgressBar::with_draw_target(length, target);
        let form = match length {
            Some(_) => "{wide_bar} {percent}%, {eta} left",
            None => "{spinner} {bytes} read",
        };
        // The form is ours; without it the bar has another one.
        if let Ok(style) = ProgressStyle::with_template(form) {
            bar.set_style(style);
        }
        Progress { bar, begun: Instant::now(), is_shown: false }
    }

    /// So many more bytes are read.
    pub fn pass(&mut self, bytes: usize) {
        self.bar.inc(bytes as u64);
        self.show();
    }

    /// How far a search has come, in words.
    pub fn say(&mut self, words: String) {
        self.bar.set_message(words);
        self.bar.tick();
        self.show();
    }

    fn show(&mut self) {
        if !self.is_shown && is_due(self.begun.elapsed()) {
            self.is_shown = true;
            self.bar.set_draw_target(ProgressDrawTarget::stderr());
        }
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.bar.finish_and_clear();
    }
}

/// Whether a run takes so long that a bar is worth its while.
fn is_due(elapsed: Duration) -> bool {
    elapsed > PATIENCE
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bar_is_for_long_runs() {
        assert!(!is_due(Duration::from_secs(2)) && is_due(Duration::from_millis(2001)));
        let mut progress = Progress::on(Some(1000), ProgressDrawTarget::hidden());
        progress.pass(250);
        assert!(!progress.is_shown);
        assert_eq!(progress.bar.position(), 250);
        progress.begun = Instant::now().checked_sub(Duration::from_secs(3)).expect("the machine runs that long");
        progress.pass(250);
        assert!(progress.is_shown);
        assert_eq!((progress.bar.position(), progress.bar.length()), (500, Some(1000)));
    }
}
