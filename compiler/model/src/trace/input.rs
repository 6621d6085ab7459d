//! What a trace is read from: bytes as they come, of which those of the row at hand are kept.
//!
//! The parser of CSV gives cells; where a cell lies, and what its line looks like, only the bytes themselves tell. So
//! they pass through here, and stay until the row behind theirs is begun.

use std::io::{self, Read};

/// A longer row is no row of a trace: perhaps a quote is not closed.
pub(super) const LONGEST_ROW: usize = 4 << 20;

/// Bytes that remembers those behind a mark.
pub(super) struct Input<R> {
    from: R,
    /// What has come and is not forgotten yet.
    kept: Vec<u8>,
    /// Where the first of them lies in the whole text.
    offset: u64,
    /// What lies before is not asked for any more.
    mark: u64,
    /// Whether a row is longer than rows are.
    pub is_too_long: bool,
}

impl<R: Read> Input<R> {
    /// Bytes that begin here in the whole text.
    pub fn new(from: R, offset: u64) -> Self {
        Input { from, kept: Vec::new(), offset, mark: offset, is_too_long: false }
    }

    /// What lies before is not asked for any more.
    pub fn forget(&mut self, before: u64) {
        self.mark = before;
    }

    /// The bytes of a part of the text behind the mark.
    pub fn part(&self, start: u64, end: u64) -> &[u8] {
        let place =
            |at: u64| usize::try_from(at.saturating_sub(self.offset)).unwrap_or(usize::MAX).min(self.kept.len());
        &self.kept[place(start)..place(end)]
    }
}

impl<R: Read> Read for Input<R> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let done = (self.mark - self.offset) as usize;
        if self.kept.len() - done > LONGEST_ROW {
            self.is_too_long = true;
            return Err(io::Error::other("a row is too long"));
        }
        self.kept.drain(..done);
        self.offset = self.mark;
        let read = self.from.read(buffer)?;
        self.kept.extend_from_slice(&buffer[..read]);
        Ok(read)
    }
}
