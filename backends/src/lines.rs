//! Which lines of a text come from which element of the chart.

use grafc_logic::scan::Origin;

/// Lines, counted from 1, by what they come from.
#[derive(Clone, PartialEq, Eq, Debug, Default)]
pub(crate) struct Lines {
    /// What they come from, the first and the last. A line may come from several things.
    pub ranges: Vec<(Origin, u32, u32)>,
}

impl Lines {
    fn add(&mut self, origin: Origin, first: u32, last: u32) {
        match self.ranges.last_mut() {
            _ if origin == Origin::Chart || last < first => {}
            Some((known, _, end)) if *known == origin && *end + 1 >= first => *end = last,
            _ => self.ranges.push((origin, first, last)),
        }
    }

    /// What each line comes from, for as many lines as there are.
    pub fn by_line(&self, count: usize) -> Vec<Vec<Origin>> {
        let mut by_line = vec![Vec::new(); count];
        for (origin, first, last) in &self.ranges {
            by_line[*first as usize - 1..*last as usize].iter_mut().for_each(|line| line.push(*origin));
        }
        by_line
    }
}

/// Follows a text that grows.
#[derive(Debug, Default)]
pub(crate) struct Trace {
    lines: Lines,
    /// How many lines are complete, and the bytes that they take.
    complete: u32,
    bytes: usize,
    /// What is written now.
    now: Origin,
    /// And what else it comes from.
    also: Vec<Origin>,
}

impl Trace {
    /// What comes now, instead of what came until now.
    pub fn set(&mut self, origin: Origin) -> Origin {
        self.also.clear();
        std::mem::replace(&mut self.now, origin)
    }

    /// What else comes until something else is set.
    pub fn also(&mut self, origin: Origin) {
        if origin != self.now && !self.also.contains(&origin) {
            self.also.push(origin);
        }
    }

    /// Lines that come from nothing are complete.
    pub fn skip(&mut self, text: &str) {
        self.complete += self.fresh(text);
        self.bytes = text.len();
    }

    /// Lines of what is written now are complete.
    pub fn complete(&mut self, text: &str) {
        let (first, last) = (self.complete + 1, self.complete + self.fresh(text));
        self.lines.add(self.now, first, last);
        self.also.iter().for_each(|origin| self.lines.add(*origin, first, last));
        (self.complete, self.bytes) = (last, text.len());
    }

    /// Lines follow that were written apart.
    pub fn append(&mut self, block: Trace, text: &str) {
        for (origin, first, last) in block.lines.ranges {
            self.lines.add(origin, self.complete + first, self.complete + last);
        }
        self.complete += block.complete;
        self.bytes = text.len();
    }

    /// All lines.
    pub fn finish(self) -> Lines {
        self.lines
    }

    fn fresh(&self, text: &str) -> u32 {
        text.as_bytes()[self.bytes..].iter().filter(|byte| **byte == b'\n').count() as u32
    }
}

#[cfg(test)]
mod tests {
    use crate::writer::{IEC, Writer};
    use grafc_logic::scan::{Origin, StepId};

    fn step(n: usize) -> Origin {
        Origin::Step(StepId::new(n))
    }

    #[test]
    fn lines_are_counted_whatever_stands_in_them() {
        let mut out = Writer::new(&IEC).traced(true);
        out.line("head");
        out.blank();
        // A blank line comes from nothing.
        let outer = out.inner_origin(step(1));
        out.line("one");
        out.line("two\nthree");
        let one = out.inner_origin(Origin::Chart);
        out.line("still one");
        out.origin(one);
        out.origin(outer);
        out.line("nothing");
        let mut apart = out.apart();
        apart.origin(step(2));
        apart.also(step(3));
        apart.line("both");
        apart.blank();
        apart.line("both again");
        out.blank();
        out.append(apart);
        let (text, lines) = out.finish_traced();
        assert_eq!(text, "head\n\none\ntwo\nthree\nstill one\nnothing\n\nboth\n\nboth again\n");
        let both = [(step(2), 9, 9), (step(3), 9, 9), (step(2), 11, 11), (step(3), 11, 11)];
        assert_eq!(lines.ranges, [&[(step(1), 3, 6)][..], &both].concat());
        let by_line = lines.by_line(11);
        assert_eq!((by_line[8].as_slice(), by_line[9].as_slice()), (&[step(2), step(3)][..], &[][..]));
    }

    #[test]
    fn who_does_not_ask_gets_nothing() {
        let mut out = Writer::new(&IEC);
        out.origin(step(1));
        out.also(step(2));
        out.line("one");
        let (text, lines) = out.finish_traced();
        assert_eq!((text.as_str(), lines.ranges.len()), ("one\n", 0));
    }
}
