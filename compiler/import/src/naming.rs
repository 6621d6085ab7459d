//! Names as our texts can have them, each one once.

use grafc_syntax::spelling::is_reserved;
use rustc_hash::{FxHashMap, FxHashSet};

/// How long a name may be; what stands in the file once is written again and again.
const LONGEST: usize = 200;

/// Words of the language in places only; backquotes keep them names there.
const CONTEXTUAL: [&str; 5] = ["activation", "at", "deactivation", "event", "INIT"];

/// A name as it is written.
pub fn spell(name: &str) -> String {
    let letter = |c: char| c == '_' || c.is_ascii_alphabetic() || ('À'..='ӿ').contains(&c) && c.is_alphabetic();
    let mut chars = name.chars();
    let plain = chars.next().is_some_and(letter) && chars.all(|c| letter(c) || c.is_ascii_digit());
    if plain && !is_reserved(name) && !CONTEXTUAL.contains(&name) { name.to_string() } else { format!("`{name}`") }
}

/// A label as it is written: numbers need no backquotes.
pub fn spell_label(label: &str) -> String {
    if label.bytes().all(|b| b.is_ascii_digit()) { label.to_string() } else { spell(label) }
}

/// What can stand between backquotes in a line: not too long, and something at all.
pub fn clean(name: &str) -> String {
    let clean = |c: char| if c == '`' || c.is_control() || matches!(c, '\u{2028}' | '\u{2029}') { '_' } else { c };
    let cleaned: String = name.trim().chars().take(LONGEST).map(clean).collect();
    if cleaned.is_empty() { "unnamed".to_string() } else { cleaned }
}

/// Names that are in use, without regard to case.
#[derive(Default)]
pub struct Taken {
    names: FxHashSet<String>,
    next: FxHashMap<String, u32>,
}

impl Taken {
    /// Whether nothing has the name.
    pub fn is_free(&self, name: &str) -> bool {
        !self.names.contains(&name.to_lowercase())
    }

    /// Takes a name that may be in use.
    pub fn insert(&mut self, name: &str) {
        self.names.insert(name.to_lowercase());
    }

    /// The name wanted, or that name with the first number for which all are free that `made` makes of it.
    pub fn take_all(&mut self, wanted: &str, made: impl Fn(&str) -> Vec<String>) -> String {
        let mut name = wanted.to_string();
        let folded = wanted.to_lowercase();
        while !made(&name).iter().all(|name| self.is_free(name)) {
            let next = self.next.entry(folded.clone()).or_insert(2);
            name = format!("{wanted}_{next}");
            *next += 1;
        }
        for name in made(&name) {
            self.insert(&name);
        }
        name
    }

    /// The name wanted, or that name with the first number with which it is free.
    pub fn take(&mut self, wanted: &str) -> String {
        self.take_all(wanted, |name| vec![name.to_string()])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_that_need_backquotes_get_them() {
        let names = ["a", "Förderband", "привет", "2s/X202", "on", "a b", "x١", "at"];
        let spelled = names.map(spell);
        assert_eq!(spelled, ["a", "Förderband", "привет", "`2s/X202`", "`on`", "`a b`", "`x١`", "`at`"]);
        assert_eq!([spell_label("12"), spell_label("G1_1"), spell_label("-1")], ["12", "G1_1", "`-1`"]);
        assert_eq!(
            [clean("a`\nb"), clean(" "), clean(&"ü".repeat(300))],
            ["a__b".into(), "unnamed".into(), "ü".repeat(200)]
        );
    }

    #[test]
    fn taken_names_get_numbers() {
        let mut taken = Taken::default();
        let names: Vec<_> = ["a", "A", "a_2", "a"].into_iter().map(|name| taken.take(name)).collect();
        assert_eq!(names, ["a", "A_2", "a_2_2", "a_3"]);
    }
}
