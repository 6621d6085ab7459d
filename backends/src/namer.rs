//! Identifiers that a target takes, each given once.

use crate::keywords::{Family, Reserved};
use crate::transliterate::{identifier, is_identifier};
use ecow::{EcoString, eco_format};
use hashbrown::HashTable;
use hashbrown::hash_table::Entry;
use rustc_hash::{FxBuildHasher, FxHashMap};
use std::hash::BuildHasher;

/// The longest name that is given: more is unreadable, and some PLC editors stop there.
pub const MAX_LENGTH: usize = 63;

impl Family {
    /// The longest name that is given for a target.
    fn longest(self) -> usize {
        match self {
            Family::StatementList => 24,
            Family::Iec
            | Family::InstructionList
            | Family::RustValues
            | Family::RustTypes
            | Family::JavaScript
            | Family::C => MAX_LENGTH,
        }
    }
}

/// Gives names that are unique without regard to case and not reserved; the same wishes in the same order get the same
/// names.
#[derive(Clone)]
pub struct Namer {
    family: Family,
    reserved: Reserved,
    taken: Taken,
    /// The name that is looked at, in upper case.
    upper: String,
    /// The next suffix to try for a stem.
    next: FxHashMap<EcoString, u32>,
}

impl Namer {
    /// A namer that has given no name yet.
    pub fn new(family: Family) -> Self {
        Namer {
            family,
            reserved: Reserved::of(family),
            taken: Taken::default(),
            upper: String::new(),
            next: FxHashMap::default(),
        }
    }

    /// When no further name will be asked for: there is no need to know those that were given.
    pub fn close(&mut self) {
        (self.taken, self.next) = (Taken::default(), FxHashMap::default());
    }

    /// A name as near to the wanted one as can be.
    pub fn name(&mut self, wanted: &str) -> EcoString {
        self.name_that(wanted, |_, _| true)
    }

    /// A name for a program organisation unit.
    pub fn unit(&mut self, wanted: &str) -> EcoString {
        self.name_that(wanted, |reserved, name| !reserved.contains_unit(&name.to_ascii_uppercase()))
    }

    fn name_that(&mut self, wanted: &str, may_be: impl Fn(&Reserved, &str) -> bool) -> EcoString {
        let longest = self.family.longest();
        let stem = self.parted(identifier(wanted, longest));
        if may_be(&self.reserved, &stem) && self.take(&stem) {
            return stem;
        }
        if identifier(wanted, usize::MAX).len() > longest {
            let mark = mark(wanted);
            let kept = stem.len().min(longest - 1 - mark.len());
            let marked = eco_format!("{}_{mark}", stem[..kept].trim_end_matches('_'));
            if self.take(&marked) {
                return marked;
            }
        }
        let key = stem.to_ascii_uppercase();
        let mut number = self.next.get(&key).copied().unwrap_or(1);
        loop {
            // Rust wants no underscore between a letter and something else in the name of a type.
            let joined = self.family == Family::RustTypes && !stem.ends_with(|c: char| c.is_ascii_digit());
            let suffix = eco_format!("{}{number}", if joined { "" } else { "_" });
            let kept = stem[..stem.len().min(longest - suffix.len())].trim_end_matches('_');
            let name = eco_format!("{kept}{suffix}");
            number += 1;
            if self.take(&name) {
                self.next.insert(key, number);
                return name;
            }
        }
    }

    /// Names of equal rank: those that need no change get theirs first, so that `Tuer` stays when `Tür` is there too.
    pub fn names(&mut self, wanted: impl IntoIterator<Item = EcoString>) -> Vec<EcoString> {
        let mut names: Vec<EcoString> = wanted.into_iter().collect();
        self.taken.reserve(names.len());
        let longest = self.family.longest();
        let mut stays = |name: &EcoString| {
            is_identifier(name, longest) && self.reserved.joint_within(name).is_none() && self.take(name)
        };
        let changed: Vec<usize> = (0..names.len()).filter(|place| !stays(&names[*place])).collect();
        for place in changed {
            names[place] = self.name(&names[place]);
        }
        names
    }

    /// A name without what no name may have within it: `bend_function` as `bendfunction`.
    fn parted(&self, mut name: EcoString) -> EcoString {
        while let Some(joint) = self.reserved.joint_within(&name) {
            name = eco_format!("{}{}", &name[..joint], &name[joint + 1..]);
        }
        name
    }

    /// Takes an identifier if it is free.
    fn take(&mut self, name: &str) -> bool {
        self.upper.clear();
        self.upper.push_str(name);
        self.upper.make_ascii_uppercase();
        !self.reserved.contains(&self.upper) && self.taken.insert(&self.upper)
    }
}

/// The names that were given, in upper case. The table holds places in the list, not the names: there are very many.
#[derive(Clone, Default)]
struct Taken {
    list: Vec<EcoString>,
    places: HashTable<u32>,
}

impl Taken {
    fn reserve(&mut self, count: usize) {
        self.list.reserve(count);
        self.places.reserve(count, |place| hash(&self.list[*place as usize]));
    }

    /// Takes a name, unless it is taken.
    fn insert(&mut self, name: &str) -> bool {
        let Taken { list, places } = self;
        let of = |place: &u32| list[*place as usize].as_str();
        match places.entry(hash(name), |place| of(place) == name, |place| hash(of(place))) {
            Entry::Occupied(_) => false,
            Entry::Vacant(entry) => {
                entry.insert(list.len() as u32);
                list.push(name.into());
                true
            }
        }
    }
}

fn hash(name: &str) -> u64 {
    FxBuildHasher.hash_one(name)
}

/// Three signs that stand for a whole name that was cut: so it does not depend on which others were cut like it.
fn mark(name: &str) -> EcoString {
    const SIGNS: &[u8; 30] = b"0123456789bcdfghjklmnpqrstvwxz";
    // FNV-1a.
    let step = |hash: u64, byte: u8| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
    let mut hash = name.bytes().fold(0xcbf2_9ce4_8422_2325, step) >> 8;
    let mut sign = || {
        let sign = SIGNS[(hash % SIGNS.len() as u64) as usize];
        hash /= SIGNS.len() as u64;
        char::from(sign)
    };
    [sign(), sign(), sign()].into_iter().collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn names(wanted: &[&str]) -> Vec<EcoString> {
        Namer::new(Family::Iec).names(wanted.iter().copied().map(EcoString::from))
    }

    #[test]
    fn without_regard_to_case() {
        assert_eq!(names(&["Pump", "pump", "PUMP"]), ["Pump", "pump_1", "PUMP_2"]);
    }

    #[test]
    fn reserved() {
        assert_eq!(
            names(&["on", "STEP", "en", "NaN", "m_pi", "ton", "Int_to_Real", "add_int", "this", "file", "eof"]),
            [
                "on_1",
                "STEP_1",
                "en_1",
                "NaN_1",
                "m_pi_1",
                "ton_1",
                "Int_to_Real_1",
                "add_int_1",
                "this_1",
                "file_1",
                "eof_1"
            ]
        );
    }

    #[test]
    fn what_ends_a_unit_is_in_no_name() {
        let wanted =
            ["bend_function", "x_END_FUNCTION_BLOCK", "END_PROGRAM", "lend_program_end_action", "END_VAR", "end"];
        let given = ["bendfunction", "x_ENDFUNCTION_BLOCK", "ENDPROGRAM", "lendprogram_endaction", "END_VAR_1", "end"];
        assert_eq!(names(&wanted), given);
        // What makes such a word only together with something of ours.
        let mut namer = Namer::new(Family::Iec);
        assert_eq!(namer.unit("Blend"), "Blend");
        assert_eq!(namer.unit("Blend_program"), "Blendprogram");
        assert_eq!(Namer::new(Family::RustValues).name("bend_function"), "bend_function");
    }

    #[test]
    fn pins_of_the_library_are_no_units() {
        let mut namer = Namer::new(Family::Iec);
        for (wanted, given) in [("Cycle", "Cycle_1"), ("RUN", "RUN_1"), ("State", "State_1"), ("Runs", "Runs")] {
            assert_eq!(namer.unit(wanted), given);
        }
        assert_eq!(namer.name("Cycle"), "Cycle");
    }

    #[test]
    fn what_charts_use_stays() {
        let usual =
            "X1 T1 S1 R1 X T S R N P D L SD DS SL P0 P1 I J Q Q1 ET PT IN CLK CU CD PV CV INIT STATE RUN _x a_1";
        let usual: Vec<&str> = usual.split_ascii_whitespace().collect();
        assert_eq!(names(&usual), usual);
    }

    #[test]
    fn the_suffix_collides_with_nothing() {
        assert_eq!(names(&["a_b", "a__b", "a_b_1", "A_B_2"]), ["a_b", "a_b_3", "a_b_1", "A_B_2"]);
    }

    #[test]
    fn unchanged_names_come_first() {
        assert_eq!(names(&["Tür", "Tuer"]), ["Tuer_1", "Tuer"]);
        let mut namer = Namer::new(Family::Iec);
        assert_eq!(namer.name("Tür"), "Tuer");
        assert_eq!(namer.name("Tuer"), "Tuer_1");
    }

    #[test]
    fn long_names_stay_unique() {
        let long = "x".repeat(10_000);
        let longer = format!("{long}y");
        let given = names(&[&long, &longer, &long]);
        assert_eq!(given[0], "x".repeat(63));
        let mark = |name: &str| name.strip_prefix(&format!("{}_", "x".repeat(59))).map(str::len);
        assert_eq!((mark(&given[1]), mark(&given[2])), (Some(3), Some(3)));
        assert!(given[1] != given[2]);
        // Whatever else was cut before it.
        let mut namer = Namer::new(Family::Iec);
        namer.name(&format!("{long}z"));
        assert_eq!(namer.name(&longer), given[1]);
    }

    #[test]
    fn many_of_one_name_take_linear_time() {
        let mut namer = Namer::new(Family::Iec);
        let mut last = EcoString::new();
        for _ in 0..200_000 {
            last = namer.name("é");
        }
        assert_eq!(last, "e_199999");
    }
}
