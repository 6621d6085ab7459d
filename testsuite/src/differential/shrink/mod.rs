//! Makes a chart and its trace smaller while a fault persists.
//!
//! Rows of the trace are deleted, halves of it first; then pieces of the text are deleted or replaced, by the places in
//! its syntax tree, the largest first; then what is left of the trace is made calmer. What remains must still show the
//! fault, which the caller decides. Nothing else is asked of a step, so any fault can be shrunk.

mod edits;

use crate::named_trace::NamedTrace;

/// The smallest chart and trace found that still show the fault, after at most `tries` runs.
pub fn shrink(
    text: &str,
    trace: &NamedTrace,
    tries: u32,
    faulty: impl FnMut(&str, &NamedTrace) -> bool,
) -> (String, NamedTrace) {
    let mut search = Search { text: text.to_string(), trace: trace.clone(), tries, faulty };
    // Each round may open the way for another.
    while search.rows() | search.text() | search.calm() {}
    (search.text, search.trace)
}

struct Search<F> {
    text: String,
    trace: NamedTrace,
    tries: u32,
    faulty: F,
}

impl<F: FnMut(&str, &NamedTrace) -> bool> Search<F> {
    /// Whether this one shows the fault, too; no more once all tries are used up.
    fn shows(&mut self, text: &str, trace: &NamedTrace) -> bool {
        self.tries = match self.tries.checked_sub(1) {
            Some(left) => left,
            None => return false,
        };
        (self.faulty)(text, trace)
    }

    /// Deletes rows: halves first, then one by one. Whether it could.
    fn rows(&mut self) -> bool {
        let mut smaller = false;
        let mut size = (self.trace.len() / 2).max(1);
        loop {
            let mut at = self.trace.len();
            while at > 0 {
                let from = at.saturating_sub(size);
                let shorter = self.trace.without(from..at);
                let text = self.text.clone();
                if self.shows(&text, &shorter) {
                    self.trace = shorter;
                    smaller = true;
                }
                at = from;
            }
            if size == 1 {
                return smaller;
            }
            size /= 2;
        }
    }

    /// Edits the text, one edit at a time; places move with each, so the tree is read again. What follows the edit is
    /// tried next, not what has just been tried in vain. Whether it could.
    fn text(&mut self) -> bool {
        let mut smaller = false;
        let mut edits = edits::of(&self.text);
        let mut at = 0;
        while let Some(edit) = edits.get(at) {
            let shorter = edit.apply(&self.text);
            let trace = self.trace.clone();
            if self.shows(&shorter, &trace) {
                self.text = shorter;
                smaller = true;
                edits = edits::of(&self.text);
            } else {
                at += 1;
            }
        }
        smaller
    }

    /// Lets less happen in the trace. Whether it could.
    fn calm(&mut self) -> bool {
        let mut smaller = false;
        'traces: loop {
            for calm in self.trace.calmer() {
                let text = self.text.clone();
                if self.shows(&text, &calm) {
                    self.trace = calm;
                    smaller = true;
                    continue 'traces;
                }
            }
            return smaller;
        }
    }
}
