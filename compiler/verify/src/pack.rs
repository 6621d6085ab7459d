//! A state as words: each value in as many bits as its type takes.

use crate::clocks::Phase;
use grafc_formula::{TimerId, Type, Value, VarId};
use grafc_logic::scan::Program;
use grafc_model::chart::Bits;
use index_vec::IndexVec;

/// What is left after a reaction, or a micro-step, as numbers that can be compared.
pub(crate) type State = Box<[u64]>;

/// Where the parts of a state lie.
pub(crate) struct Layout {
    variables: Vec<(VarId, Type, Place)>,
    timers: Vec<Place>,
    marks: Place,
    words: usize,
}

/// Some bits of a word.
#[derive(Clone, Copy)]
struct Place {
    word: usize,
    shift: u32,
    width: u32,
}

/// A timer takes so many bits: whether its input is true, whether it is vague, and how many of its times have passed.
const TIMER: u32 = 32;

impl Layout {
    /// For these variables, all timers of the program, and so many marks.
    pub(crate) fn new(program: &Program, variables: &[VarId], marks: usize) -> Layout {
        let (mut word, mut used) = (0, 0);
        let mut place = |width: u32| {
            if used + width > u64::BITS {
                (word, used) = (word + 1, 0);
            }
            used += width;
            Place { word, shift: used - width, width }
        };
        let variables =
            variables.iter().map(|v| (*v, program.variables[*v].ty, place(width(program.variables[*v].ty))));
        let variables = variables.collect();
        let timers = program.timers.iter().map(|_| place(TIMER)).collect();
        let marks = place(marks.clamp(1, 64) as u32);
        Layout { variables, timers, marks, words: word + 1 }
    }

    /// The state that these values are.
    pub(crate) fn pack(&self, values: &IndexVec<VarId, Value>, timers: &IndexVec<TimerId, Phase>, marks: u64) -> State {
        let mut words = vec![0; self.words];
        for (v, ty, place) in &self.variables {
            place.write(&mut words, Bits::of(values[*v], *ty).word());
        }
        for (phase, place) in timers.iter().zip(&self.timers) {
            let bits = if phase.on { 1 | u64::from(phase.vague) << 1 | (phase.passed as u64) << 2 } else { 0 };
            place.write(&mut words, bits);
        }
        self.marks.write(&mut words, marks);
        words.into()
    }

    /// The marks of a state.
    pub(crate) fn marks(&self, state: &[u64]) -> u64 {
        self.marks.read(state)
    }

    /// The values that a state is.
    pub(crate) fn variables<'s>(&'s self, state: &'s [u64]) -> impl Iterator<Item = (VarId, Value)> + 's {
        self.variables.iter().map(|(v, ty, place)| (*v, Bits::of_word(place.read(state)).value(*ty)))
    }

    /// The timers of a state.
    pub(crate) fn timers<'s>(&'s self, state: &'s [u64]) -> impl Iterator<Item = Phase> + 's {
        self.timers.iter().map(|place| {
            let bits = place.read(state);
            Phase { on: bits & 1 == 1, fresh: false, vague: bits >> 1 & 1 == 1, passed: (bits >> 2) as usize }
        })
    }
}

impl Place {
    fn mask(self) -> u64 {
        u64::MAX >> (u64::BITS - self.width)
    }

    fn write(self, words: &mut [u64], bits: u64) {
        words[self.word] |= (bits & self.mask()) << self.shift;
    }

    fn read(self, words: &[u64]) -> u64 {
        words[self.word] >> self.shift & self.mask()
    }
}

/// How many bits a value of a type takes.
pub(crate) fn width(ty: Type) -> u32 {
    match ty {
        Type::Bool => 1,
        Type::Int | Type::Uint => 16,
        Type::Dint | Type::Udint => 32,
        Type::Time | Type::Real | Type::Lreal => 64,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_come_back_from_their_bits() {
        let values = [
            (Type::Bool, Value::Bool(true)),
            (Type::Int, Value::Int(-3)),
            (Type::Dint, Value::Int(i32::MIN.into())),
            (Type::Uint, Value::Int(u16::MAX.into())),
            (Type::Udint, Value::Int(u32::MAX.into())),
            (Type::Time, Value::Time(-1)),
            (Type::Lreal, Value::Real(-2.5)),
        ];
        for (ty, value) in values {
            let place = Place { word: 0, shift: 64 - width(ty), width: width(ty) };
            let mut words = [0];
            place.write(&mut words, Bits::of(value, ty).word());
            assert_eq!(Bits::of_word(place.read(&words)).value(ty), value, "{ty:?}");
        }
    }
}
