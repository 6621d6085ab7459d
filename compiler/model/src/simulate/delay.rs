//! X5: `t1/e/t2` is a TOF of `t2` after a TON of `t1`.

/// The memory of one delay.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub(super) struct Delay {
    /// TON: since when the operand has been true; none while it is false.
    start: Option<i64>,
    /// TOF: what it remembers of the delayed operand.
    fall: Fall,
    /// The delay's value in the latest context.
    pub value: bool,
}

/// What an off-delay remembers.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
enum Fall {
    /// The delayed operand has never been true.
    #[default]
    Never,
    /// It is true.
    High,
    /// It last fell at this instant.
    At(i64),
}

impl Delay {
    /// Takes the operand's value of one context in and gives the delay's.
    pub fn update(&mut self, operand: bool, on: i64, off: i64, t: i64) -> bool {
        let delayed = if operand {
            let start = *self.start.get_or_insert(t);
            t.wrapping_sub(start) >= on
        } else {
            self.start = None;
            false
        };
        if delayed {
            self.fall = Fall::High;
        } else if self.fall == Fall::High {
            self.fall = Fall::At(t);
        }
        self.value = match self.fall {
            Fall::Never => false,
            Fall::High => true,
            Fall::At(fall) => t.wrapping_sub(fall) < off,
        };
        self.value
    }
}

impl Delay {
    /// The first instant behind `t` at which it changes while its operand stays as it is.
    pub fn end(&self, on: i64, off: i64, t: i64) -> Option<i64> {
        let risen = self.start.map(|start| start.saturating_add(on));
        let fallen = match self.fall {
            Fall::At(fall) => Some(fall.saturating_add(off)),
            Fall::Never | Fall::High => None,
        };
        risen.into_iter().chain(fallen).filter(|at| *at > t).min()
    }
}

/// The value in a first context: the TON starts now, the TOF remembers nothing.
pub(super) fn first_value(operand: bool, on: i64) -> bool {
    operand && on <= 0
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Runs `on/e/off` over `(instant, e)` and gives the values.
    fn run(on: i64, off: i64, steps: &[(i64, bool)]) -> Vec<bool> {
        let mut delay = Delay::default();
        steps.iter().map(|&(t, e)| delay.update(e, on, off, t)).collect()
    }

    #[test]
    fn an_on_delay_is_true_from_the_instant_of_expiry_on() {
        assert_eq!(
            run(3, 0, &[(0, false), (1, true), (3, true), (4, true), (5, false)]),
            [false, false, false, true, false]
        );
    }

    #[test]
    fn an_off_delay_is_false_from_the_instant_of_expiry_on() {
        assert_eq!(
            run(0, 3, &[(0, false), (1, true), (2, false), (4, false), (5, false)]),
            [false, true, true, true, false]
        );
    }

    #[test]
    fn without_delays_the_value_is_the_operand() {
        assert_eq!(run(0, 0, &[(0, true), (0, false), (1, true), (1, false)]), [true, false, true, false]);
    }

    #[test]
    fn a_first_value_is_that_of_a_fresh_delay() {
        for (operand, on, off) in [(true, 0, 0), (true, 0, 5), (true, 5, 0), (false, 0, 5), (false, 5, 5)] {
            assert_eq!(first_value(operand, on), Delay::default().update(operand, on, off, 7));
        }
    }
}
