//! The largest of a range of rows, where ranges are raised again and again.

/// Numbers by row, at first -1.
pub(crate) struct MaxTree {
    size: usize,
    /// To what the whole interval was raised.
    raised: Vec<i32>,
    /// The largest within it.
    most: Vec<i32>,
}

impl MaxTree {
    pub(crate) fn new(rows: usize) -> MaxTree {
        let size = rows.max(1).next_power_of_two();
        MaxTree { size, raised: vec![-1; 2 * size], most: vec![-1; 2 * size] }
    }

    /// Makes each row of the range at least so large.
    pub(crate) fn raise(&mut self, first: usize, last: usize, value: i32) {
        let (mut low, mut high) = (first + self.size, last + self.size + 1);
        let (start, end) = (low, high - 1);
        while low < high {
            if low & 1 == 1 {
                self.raise_whole(low, value);
                low += 1;
            }
            if high & 1 == 1 {
                high -= 1;
                self.raise_whole(high, value);
            }
            low /= 2;
            high /= 2;
        }
        for mut at in [start, end] {
            while at > 1 {
                at /= 2;
                self.most[at] = self.most[at].max(value);
            }
        }
    }

    fn raise_whole(&mut self, at: usize, value: i32) {
        self.raised[at] = self.raised[at].max(value);
        self.most[at] = self.most[at].max(value);
    }

    /// The largest of a range.
    pub(crate) fn max(&self, first: usize, last: usize) -> i32 {
        let (mut low, mut high) = (first + self.size, last + self.size + 1);
        let mut found = -1;
        for mut at in [low, high - 1] {
            while at > 0 {
                found = found.max(self.raised[at]);
                at /= 2;
            }
        }
        while low < high {
            if low & 1 == 1 {
                found = found.max(self.most[low]);
                low += 1;
            }
            if high & 1 == 1 {
                high -= 1;
                found = found.max(self.most[high]);
            }
            low /= 2;
            high /= 2;
        }
        found
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_agrees_with_a_plain_list() {
        let mut random = fastrand::Rng::with_seed(1);
        let (mut tree, mut plain) = (MaxTree::new(53), vec![-1; 53]);
        for _ in 0..500 {
            let a = random.usize(0..53);
            let b = random.usize(a..53);
            assert_eq!(tree.max(a, b), plain[a..=b].iter().copied().max().unwrap_or(-1));
            let value = random.i32(0..100);
            let b = random.usize(a..(a + 9).min(53));
            tree.raise(a, b, value);
            plain[a..=b].iter_mut().for_each(|old| *old = value.max(*old));
        }
    }
}
