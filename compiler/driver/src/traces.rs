//! The text of a trace as it comes: how far it is read, and whether it comes faster than it is taken.

use crate::progress::Progress;
use std::cell::Cell;
use std::io::{self, Read};
use std::rc::Rc;

/// A text that is watched while it is read.
pub struct Watched {
    bytes: Box<dyn Read>,
    is_live: Rc<Cell<bool>>,
    progress: Option<Progress>,
}

impl Watched {
    /// A text; `length` is how long it is, if that is known, and whether that is to be shown at all.
    pub fn new(bytes: Box<dyn Read>, length: Option<Option<u64>>) -> Self {
        Watched { bytes, is_live: Rc::default(), progress: length.and_then(Progress::new) }
    }

    /// Whether less comes than is asked for: somebody writes it just now, and waits for what becomes of it.
    pub fn is_live(&self) -> Rc<Cell<bool>> {
        Rc::clone(&self.is_live)
    }
}

impl Read for Watched {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let read = self.bytes.read(buffer)?;
        self.is_live.set(read < buffer.len());
        if let Some(progress) = &mut self.progress {
            progress.pass(read);
        }
        Ok(read)
    }
}
