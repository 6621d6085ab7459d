//! What a reaction can ask of inputs and time, and what follows from the answers so far.

use grafc_formula::{Comparison, Type, Value, VarId};
use rustc_hash::FxHashMap;

/// A question with the answers yes and no.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub(crate) enum Atom {
    /// Whether a Boolean input is true.
    Holds(VarId),
    /// Whether a number that is given is not below a bound.
    AtLeast(VarId, Bound),
    /// A bit of a whole number that is given: asked where it is not only compared with what is known.
    Bit(VarId, usize),
    /// Whether what measures this operand has run for so many milliseconds.
    Ends(usize, i64),
}

/// Where the values of an input are parted.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Debug)]
pub(crate) enum Bound {
    /// At this whole number, or time.
    Whole(i64),
    /// At this real number, in the order of `f64::total_cmp`, or `beyond` it.
    Real {
        /// The number.
        key: i64,
        /// Whether the number itself is below.
        beyond: bool,
    },
}

impl Bound {
    /// At a value, or beyond it, for an input of a type.
    pub(crate) fn new(ty: Type, value: Value, beyond: bool) -> Bound {
        match (value, is_whole(ty)) {
            (Value::Int(n) | Value::Time(n), _) => Bound::Whole(n.saturating_add(i64::from(beyond))),
            // A whole number is at least 2.5 from 3 on.
            (Value::Real(x), true) if beyond => Bound::Whole((x.floor() as i64).saturating_add(1)),
            (Value::Real(x), true) => Bound::Whole(x.ceil() as i64),
            // Both zeros are one number.
            (Value::Real(x), false) => Bound::Real { key: key(x + 0.0), beyond },
            (Value::Bool(b), _) => Bound::Whole(i64::from(b)),
        }
    }

    /// What an input is compared with, and by which sign, where it is not below the bound, or where it is.
    pub(crate) fn spelled(self, ty: Type, not_below: bool) -> String {
        match self {
            Bound::Whole(n) => {
                let unit = if ty == Type::Time { "ms" } else { "" };
                format!("{} {n}{unit}", if not_below { ">=" } else { "<" })
            }
            Bound::Real { key, beyond } => {
                let sign = match (not_below, beyond) {
                    (true, false) => ">=",
                    (true, true) => ">",
                    (false, false) => "<",
                    (false, true) => "<=",
                };
                format!("{sign} {:?}", number(key))
            }
        }
    }

    /// The least value that is not below it, and the greatest that is.
    pub(crate) fn sides(self, ty: Type) -> (Value, Value) {
        let of = |n: i64| if ty == Type::Time { Value::Time(n) } else { Value::Int(n) };
        match self {
            Bound::Whole(n) => (of(n), of(n.saturating_sub(1))),
            // Keys are in the order of the numbers; a `real` has only some of them.
            Bound::Real { key: at, beyond } => {
                let next = |key: i64, by: i64| {
                    let x = number(key);
                    if ty != Type::Real {
                        // Both zeros are one number.
                        let other = number(key.saturating_add(by));
                        return Value::Real(if other == x { number(key.saturating_add(2 * by)) } else { other });
                    }
                    let near = x as f32;
                    let step = neighbour(near, by as i32);
                    let fits = |y: f32| if by > 0 { f64::from(y) > x } else { f64::from(y) < x };
                    Value::Real(f64::from(if fits(near) { near } else { step }))
                };
                let is_held = |x: f64| ty != Type::Real || f64::from(x as f32) == x;
                let itself = |by: i64| if is_held(number(at)) { Value::Real(number(at)) } else { next(at, by) };
                if beyond { (next(at, 1), itself(-1)) } else { (itself(1), next(at, -1)) }
            }
        }
    }

    /// Whether a value is not below it.
    pub(crate) fn is_reached(self, value: Value) -> bool {
        match (self, value) {
            (Bound::Whole(least), Value::Int(n) | Value::Time(n)) => n >= least,
            (Bound::Whole(least), Value::Bool(b)) => i64::from(b) >= least,
            (Bound::Whole(least), Value::Real(x)) => x >= least as f64,
            (Bound::Real { key: bound, beyond }, Value::Real(x)) => {
                let key = key(x + 0.0);
                if beyond { key > bound } else { key >= bound }
            }
            (Bound::Real { key: bound, beyond }, Value::Int(n) | Value::Time(n)) => {
                let key = key(n as f64);
                if beyond { key > bound } else { key >= bound }
            }
            (Bound::Real { .. }, Value::Bool(_)) => false,
        }
    }

    /// Whether all values of the type, or none, are not below it.
    pub(crate) fn trivial(self, ty: Type) -> Option<bool> {
        let Bound::Whole(n) = self else { return None };
        let (least, most) = match ty {
            Type::Bool => (0, 1),
            _ => ty.whole_range().unwrap_or((i64::MIN, i64::MAX)),
        };
        if n <= least {
            Some(true)
        } else if n > most {
            Some(false)
        } else {
            None
        }
    }
}

/// Whether the values of a type are whole numbers, times or truths.
pub(crate) fn is_whole(ty: Type) -> bool {
    match ty {
        Type::Real | Type::Lreal => false,
        Type::Bool | Type::Int | Type::Dint | Type::Uint | Type::Udint | Type::Time => true,
    }
}

/// The bits of a real, in the order of its values.
fn key(x: f64) -> i64 {
    let bits = x.to_bits() as i64;
    bits ^ (((bits >> 63) as u64) >> 1) as i64
}

/// The next number of single precision, upwards or downwards; both zeros are one.
fn neighbour(x: f32, by: i32) -> f32 {
    let key = |bits: i32| bits ^ (((bits >> 31) as u32) >> 1) as i32;
    let beside = |by: i32| f32::from_bits(key(key(x.to_bits() as i32).saturating_add(by)) as u32);
    if beside(by) == x { beside(2 * by) } else { beside(by) }
}

fn number(key: i64) -> f64 {
    f64::from_bits((key ^ (((key >> 63) as u64) >> 1) as i64) as u64)
}

/// A comparison of what is given with a value, as questions: true if the first is answered yes and the second no, or the
/// other way round.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Question {
    /// Must be reached, if there is one.
    pub(crate) from: Option<Bound>,
    /// Must not be reached, if there is one.
    pub(crate) to: Option<Bound>,
    /// Whether the comparison is false there, and true elsewhere.
    pub(crate) negated: bool,
}

impl Question {
    /// `input op value`.
    pub(crate) fn new(op: Comparison, ty: Type, value: Value) -> Question {
        let (at, beyond) = (Bound::new(ty, value, false), Bound::new(ty, value, true));
        let (from, to, negated) = match op {
            Comparison::Equal => (Some(at), Some(beyond), false),
            Comparison::NotEqual => (Some(at), Some(beyond), true),
            Comparison::Less => (None, Some(at), false),
            Comparison::LessEqual => (None, Some(beyond), false),
            Comparison::Greater => (Some(beyond), None, false),
            Comparison::GreaterEqual => (Some(at), None, false),
        };
        Question { from, to, negated }
    }
}

/// What has been answered on a path, in the order in which it was asked.
///
/// To walk all paths it is run again and again: what was answered before is answered the same, and what is new is answered
/// no at first.
#[derive(Clone, Debug, Default)]
pub(crate) struct Path {
    answers: Vec<(Atom, bool)>,
    asked: usize,
    /// What new questions are answered by.
    given: FxHashMap<Atom, bool>,
}

impl Path {
    /// The path of these answers.
    pub(crate) fn of(answers: &[(Atom, bool)]) -> Path {
        Path { answers: answers.to_vec(), ..Path::default() }
    }

    /// A path on which all questions are answered by what is given.
    pub(crate) fn given(answers: &[(Atom, bool)]) -> Path {
        Path { given: answers.iter().copied().collect(), ..Path::default() }
    }

    /// From the start of the reaction again.
    pub(crate) fn rewind(&mut self) {
        self.asked = 0;
    }

    /// The next path; false if this was the last one.
    pub(crate) fn advance(&mut self) -> bool {
        self.answers.truncate(self.asked);
        while let Some((atom, answer)) = self.answers.pop() {
            if !answer {
                self.answers.push((atom, true));
                return true;
            }
        }
        false
    }

    /// The answers so far.
    pub(crate) fn answers(&self) -> &[(Atom, bool)] {
        &self.answers[..self.asked]
    }

    /// What follows from them.
    pub(crate) fn known(&self, atom: Atom, ty: Type) -> Option<bool> {
        let mut so_far = self.answers().iter();
        match atom {
            Atom::Holds(_) | Atom::Bit(..) => so_far.find(|(other, _)| *other == atom).map(|(_, answer)| *answer),
            Atom::AtLeast(v, bound) => bound.trivial(ty).or_else(|| {
                so_far.find_map(|(other, answer)| match *other {
                    Atom::AtLeast(w, other) if w == v => follows(bound, other, *answer),
                    Atom::Holds(_) | Atom::AtLeast(..) | Atom::Bit(..) | Atom::Ends(..) => None,
                })
            }),
            Atom::Ends(operand, time) => so_far.find_map(|(other, answer)| match *other {
                Atom::Ends(same, other) if same == operand => follows(time, other, *answer),
                Atom::Holds(_) | Atom::AtLeast(..) | Atom::Bit(..) | Atom::Ends(..) => None,
            }),
        }
    }

    /// Answers what does not follow.
    pub(crate) fn ask(&mut self, atom: Atom) -> bool {
        if self.asked == self.answers.len() {
            self.answers.push((atom, self.given.get(&atom).copied().unwrap_or_default()));
        }
        self.asked += 1;
        self.answers[self.asked - 1].1
    }
}

/// Whether something is reached, if it is known of another place whether that is.
fn follows<T: Ord>(place: T, other: T, reached: bool) -> Option<bool> {
    if reached && place <= other {
        Some(true)
    } else if !reached && place >= other {
        Some(false)
    } else {
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn reals_keep_their_order_and_come_back() {
        let values = [f64::NEG_INFINITY, -2.5, -0.0, 1.0e-300, 2.5, f64::INFINITY];
        for pair in values.windows(2) {
            assert!(key(pair[0]) < key(pair[1]), "{pair:?}");
        }
        for x in values {
            assert_eq!(number(key(x)).to_bits(), x.to_bits());
        }
    }

    #[test]
    fn whole_numbers_are_parted_between_reals() {
        assert_eq!(Bound::new(Type::Int, Value::Real(2.5), false), Bound::Whole(3));
        assert_eq!(Bound::new(Type::Int, Value::Real(2.5), true), Bound::Whole(3));
        assert_eq!(Bound::new(Type::Int, Value::Real(3.0), false), Bound::Whole(3));
        assert_eq!(Bound::new(Type::Int, Value::Real(3.0), true), Bound::Whole(4));
    }

    #[test]
    fn the_sides_of_a_bound_are_values_of_the_type() {
        let sides = |ty, value, beyond| Bound::new(ty, value, beyond).sides(ty);
        assert_eq!(sides(Type::Int, Value::Int(5), false), (Value::Int(5), Value::Int(4)));
        assert_eq!(sides(Type::Int, Value::Int(5), true), (Value::Int(6), Value::Int(5)));
        assert_eq!(sides(Type::Time, Value::Time(5), false), (Value::Time(5), Value::Time(4)));
        let real = |ty, x: f64, beyond| match sides(ty, Value::Real(x), beyond) {
            (Value::Real(a), Value::Real(b)) => (a, b),
            other => panic!("{other:?}"),
        };
        for ty in [Type::Real, Type::Lreal] {
            // 0.1 is no number of single precision.
            for x in [-2.5, 0.0, 0.1, 8.0] {
                let (at, below) = real(ty, x, false);
                assert!(at >= x && below < x, "{ty:?} {x}: {at} {below}");
                let (above, at) = real(ty, x, true);
                assert!(above > x && at <= x, "{ty:?} {x}: {above} {at}");
                let held = |y: f64| ty == Type::Lreal || f64::from(y as f32) == y;
                assert!([at, below, above].into_iter().all(held), "{ty:?} {x}");
            }
        }
    }

    #[test]
    fn what_follows_is_not_asked() {
        let v = VarId::from_usize(0);
        let at = |n| Atom::AtLeast(v, Bound::Whole(n));
        let mut path = Path::default();
        assert_eq!(path.known(at(5), Type::Int), None);
        assert_eq!(path.known(at(-40000), Type::Int), Some(true));
        assert_eq!(path.known(at(40000), Type::Int), Some(false));
        assert!(!path.ask(at(5)));
        assert_eq!((path.known(at(6), Type::Int), path.known(at(4), Type::Int)), (Some(false), None));
        assert!(path.advance());
        path.rewind();
        assert!(path.ask(at(5)));
        assert_eq!((path.known(at(6), Type::Int), path.known(at(4), Type::Int)), (None, Some(true)));
        assert!(!path.advance());
    }
}
