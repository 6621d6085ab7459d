//! What clocks can show at one moment: bounds on each and on the difference of any two (a difference bound matrix).

/// No bound.
const FREE: i64 = i64::MAX / 4;

/// Sets of values of clocks, whole milliseconds, that bounds on differences describe. Place 0 stands for zero.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) struct Zone {
    size: usize,
    /// `bounds[i * size + j]`: at most so much is clock `i` ahead of clock `j`. As tight as they can be.
    bounds: Vec<i64>,
}

impl Zone {
    /// All clocks at zero.
    pub(crate) fn new(clocks: usize) -> Zone {
        let size = clocks + 1;
        Zone { size, bounds: vec![0; size * size] }
    }

    fn at(&self, i: usize, j: usize) -> i64 {
        self.bounds[i * self.size + j]
    }

    fn set(&mut self, i: usize, j: usize, bound: i64) {
        self.bounds[i * self.size + j] = bound;
    }

    /// At least a millisecond passes.
    pub(crate) fn pass(&mut self) {
        for clock in 1..self.size {
            self.set(clock, 0, FREE);
            self.set(0, clock, self.at(0, clock) - 1);
        }
    }

    /// Only where a clock has reached a time, or has not; false if that is nowhere.
    pub(crate) fn restrict(&mut self, clock: usize, time: i64, is_reached: bool) -> bool {
        if is_reached { self.tighten(0, clock + 1, -time) } else { self.tighten(clock + 1, 0, time - 1) }
    }

    fn tighten(&mut self, i: usize, j: usize, bound: i64) -> bool {
        if bound >= self.at(i, j) {
            return true;
        }
        if bound + self.at(j, i) < 0 {
            return false;
        }
        self.set(i, j, bound);
        for a in 0..self.size {
            for b in 0..self.size {
                let through = sum(sum(self.at(a, i), bound), self.at(j, b));
                if through < self.at(a, b) {
                    self.set(a, b, through);
                }
            }
        }
        true
    }

    /// A clock begins at zero.
    pub(crate) fn begin(&mut self, clock: usize) {
        let clock = clock + 1;
        for other in 0..self.size {
            self.set(clock, other, self.at(0, other));
            self.set(other, clock, self.at(other, 0));
        }
        self.set(clock, clock, 0);
    }

    /// A clock stands for nothing: it may show anything.
    pub(crate) fn forget(&mut self, clock: usize) {
        let clock = clock + 1;
        for other in 0..self.size {
            self.set(clock, other, FREE);
            self.set(other, clock, self.at(other, 0));
        }
        self.set(0, clock, 0);
        self.set(clock, clock, 0);
    }

    /// Beyond the longest time that anything asks of a clock, what it shows makes no difference.
    pub(crate) fn widen(&mut self, longest: &[i64]) {
        let most = |place: usize| place.checked_sub(1).map_or(0, |clock| longest[clock] + 1);
        for i in 0..self.size {
            for j in (0..self.size).filter(|j| *j != i) {
                let bound = self.at(i, j);
                if i > 0 && bound > most(i) {
                    self.set(i, j, FREE);
                } else if bound < -most(j) {
                    self.set(i, j, -most(j));
                }
            }
        }
        for through in 0..self.size {
            for i in 0..self.size {
                for j in 0..self.size {
                    let bound = sum(self.at(i, through), self.at(through, j));
                    if bound < self.at(i, j) {
                        self.set(i, j, bound);
                    }
                }
            }
        }
    }

    /// Whether all that the other describes is in this one.
    pub(crate) fn holds(&self, other: &Zone) -> bool {
        self.bounds.iter().zip(&other.bounds).all(|(mine, theirs)| theirs <= mine)
    }
}

fn sum(a: i64, b: i64) -> i64 {
    if a >= FREE || b >= FREE { FREE } else { a + b }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn of_two_clocks_the_older_shows_more() {
        // By hand: the first begins, 1 ms or more later the second, and again 1 ms or more passes.
        let mut zone = Zone::new(2);
        zone.forget(1);
        zone.pass();
        zone.begin(1);
        zone.pass();
        // If the second has reached 5 ms, the first has reached 6 ms.
        let mut reached = zone.clone();
        assert!(reached.restrict(1, 5, true));
        assert!(!reached.clone().restrict(0, 6, false));
        assert!(reached.restrict(0, 7, false), "6 ms it may be");
        // And it may be any longer.
        assert!(zone.restrict(1, 5, false) && zone.restrict(0, 5000, true));
    }

    #[test]
    fn a_zone_holds_what_is_narrower() {
        let mut wide = Zone::new(1);
        wide.pass();
        let mut narrow = wide.clone();
        assert!(narrow.restrict(0, 3, true));
        assert!(wide.holds(&narrow) && !narrow.holds(&wide));
        wide.widen(&[2]);
        narrow.widen(&[2]);
        assert!(narrow.holds(&narrow.clone()));
    }
}
