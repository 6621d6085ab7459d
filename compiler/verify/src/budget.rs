//! How much may be done: a solver asks at each of its decisions whether to go on, an operation on decision diagrams at each
//! pair of nodes.

use crate::goal::Stop;
use crate::limit::Limit;
use batsat::Callbacks;
use std::cell::{Cell, RefCell};

/// So many decisions are made between two questions whether to go on.
const AT_ONCE: u64 = 256;

/// What was done, and what may be.
pub(crate) struct Budget<'s> {
    stop: RefCell<Stop<'s>>,
    /// So much is done between two questions whether to go on.
    at_once: u64,
    done: Cell<u64>,
    most: Cell<u64>,
    /// So much may be done until the question at hand is given up.
    most_of_question: Cell<u64>,
    next: Cell<u64>,
    hit: Cell<Option<Limit>>,
    /// What is told: states that were met, and how deep the search is.
    pub(crate) met: Cell<usize>,
    pub(crate) depth: Cell<usize>,
}

impl<'s> Budget<'s> {
    pub(crate) fn new(stop: Stop<'s>) -> Self {
        Budget {
            stop: RefCell::new(stop),
            at_once: AT_ONCE,
            done: Cell::new(0),
            most: Cell::new(u64::MAX),
            most_of_question: Cell::new(u64::MAX),
            next: Cell::new(0),
            hit: Cell::new(None),
            met: Cell::new(0),
            depth: Cell::new(0),
        }
    }

    /// With so much done between two questions whether to go on.
    pub(crate) fn asked_every(self, at_once: u64) -> Self {
        Budget { at_once, ..self }
    }

    /// From here on so much may be done, and so much for one question.
    pub(crate) fn allow(&self, most: u64, question: u64) {
        self.most.set(self.done.get().saturating_add(most));
        self.most_of_question.set(question);
    }

    /// Something of this size was done.
    pub(crate) fn spend(&self, amount: u64) {
        self.done.set(self.done.get() + amount);
        if self.done.get() >= self.next.get() {
            self.next.set(self.done.get() + self.at_once);
            let limit = (self.stop.borrow_mut())(self.met.get(), self.depth.get());
            self.hit.set(self.hit.get().or(limit));
        }
    }

    /// Whether to go on, for somebody else to ask.
    pub(crate) fn stop(&mut self) -> Stop<'_> {
        &mut **self.stop.get_mut()
    }

    /// What ends all of the search.
    pub(crate) fn limit(&self) -> Option<Limit> {
        self.hit.get()
    }

    /// Whether no more may be done of what is at hand.
    pub(crate) fn is_over(&self) -> bool {
        self.hit.get().is_some() || self.done.get() >= self.most.get()
    }

    /// A question begins.
    pub(crate) fn asked(&self) -> Asked<'_, 's> {
        Asked { budget: self, until: Cell::new(0) }
    }
}

/// The budget of one solver.
pub(crate) struct Asked<'b, 's> {
    budget: &'b Budget<'s>,
    until: Cell<u64>,
}

impl Callbacks for Asked<'_, '_> {
    fn on_start(&mut self) {
        self.until.set(self.budget.done.get().saturating_add(self.budget.most_of_question.get()));
    }

    fn stop(&self) -> bool {
        self.budget.spend(1);
        self.budget.is_over() || self.budget.done.get() >= self.until.get()
    }
}
