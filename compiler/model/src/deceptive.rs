//! Names that are not what they look like, by UTS #39: letters of two alphabets that look alike, marks that cannot be seen,
//! one text in two forms.

use unicode_normalization::{UnicodeNormalization, is_nfc};
use unicode_script::{Script, UnicodeScript};
use unicode_security::MixedScript;
use unicode_security::confusable_detection::skeleton;

/// So many code points are shown of one name.
const SHOWN: usize = 4;

/// A character that leaves no trace, or changes the direction of what follows.
pub fn is_invisible(c: char) -> bool {
    matches!(c,
        '\u{AD}' | '\u{34F}' | '\u{61C}' | '\u{115F}' | '\u{1160}' | '\u{17B4}' | '\u{17B5}' | '\u{180B}'..='\u{180F}'
        | '\u{200B}'..='\u{200F}' | '\u{2028}'..='\u{202E}' | '\u{2060}'..='\u{206F}' | '\u{3164}' | '\u{FE00}'..='\u{FE0F}'
        | '\u{FEFF}' | '\u{FFA0}' | '\u{E0000}'..='\u{E0FFF}')
}

/// What a name looks like: two names that look alike give the same text.
pub fn looks(name: &str) -> String {
    let seen: String = name.chars().filter(|c| !is_invisible(*c)).collect();
    skeleton(&seen).collect()
}

/// The same name in the form that keyboards write, if it has another one.
pub fn composed(name: &str) -> Option<String> {
    (!is_nfc(name)).then(|| name.nfc().collect())
}

/// The alphabets of a word in a name that mixes them, where one of its letters looks like one of another alphabet. What
/// signs and digits part is a word of its own: `Клапан_A1` mixes nothing.
pub fn mixed(name: &str) -> Option<[&'static str; 2]> {
    let sign = |c: char| c == '_' || !(c.is_alphabetic() || matches!(c.script(), Script::Inherited));
    name.split(sign).filter(|word| !word.is_ascii() && !word.is_single_script()).find_map(|word| {
        word.chars().find(|c| is_like_another(*c))?;
        let mut scripts = word.chars().map(|c| c.script()).filter(|s| !matches!(s, Script::Common | Script::Inherited));
        let first = scripts.next()?;
        let other = scripts.find(|script| *script != first)?;
        Some([first.full_name(), other.full_name()])
    })
}

fn is_like_another(c: char) -> bool {
    let mut buffer = [0; 4];
    let text: &str = c.encode_utf8(&mut buffer);
    !c.is_ascii() && !skeleton(text).eq(text.nfd())
}

/// The code points of what misleads in a name: what cannot be seen, what looks like a letter of another alphabet in a
/// name that mixes them or looks like ASCII as a whole, marks that are apart from their letter.
pub fn code_points(name: &str) -> Option<String> {
    if name.is_ascii() {
        return None;
    }
    let alike = mixed(name).is_some() || looks(name).is_ascii();
    let apart = composed(name).is_some();
    let misleads =
        |c: &char| is_invisible(*c) || alike && is_like_another(*c) || apart && matches!(c.script(), Script::Inherited);
    let mut found: Vec<String> = Vec::new();
    for c in name.chars().filter(misleads) {
        let point = format!("U+{:04X}", u32::from(c));
        if !found.contains(&point) {
            found.push(point);
        }
    }
    if found.len() > SHOWN {
        found.truncate(SHOWN);
        found.push("…".into());
    }
    (!found.is_empty()).then(|| found.join(" "))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_of_one_alphabet_mix_nothing() {
        for name in ["pump", "Türöffner", "Клапан", "Клапан_A1", "ΔT", "温度センサー", "2s/X202", "µ1"]
        {
            assert_eq!(mixed(name), None, "{name}");
            assert_eq!(code_points(name), None, "{name}");
        }
    }

    #[test]
    fn letters_that_look_like_others_are_told_by_their_number() {
        assert_eq!(mixed("p\u{430}ge"), Some(["Latin", "Cyrillic"]));
        assert_eq!(code_points("p\u{430}ge").as_deref(), Some("U+0430"));
        // All of it in one alphabet, and yet like ASCII.
        assert_eq!(mixed("\u{440}\u{430}\u{441}\u{435}"), None);
        assert_eq!(code_points("\u{440}\u{430}\u{441}\u{435}").as_deref(), Some("U+0440 U+0430 U+0441 U+0435"));
        assert_eq!(looks("p\u{430}ge"), looks("page"));
    }

    #[test]
    fn what_cannot_be_seen_and_what_stands_apart_is_told() {
        assert_eq!(code_points("pu\u{200B}mp").as_deref(), Some("U+200B"));
        assert_eq!(looks("pu\u{200B}mp"), looks("pump"));
        assert_eq!(code_points("Tu\u{308}r").as_deref(), Some("U+0308"));
        assert_eq!(composed("Tu\u{308}r").as_deref(), Some("Tür"));
        assert_eq!(looks("Tu\u{308}r"), looks("Tür"));
    }
}
