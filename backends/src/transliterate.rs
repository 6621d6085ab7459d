//! Any text as letters, digits and single underscores of ASCII, still readable.

use ecow::EcoString;
use std::iter::Peekable;
use std::str::Chars;

/// The text as an identifier of at most `limit` characters: never empty, no digit first, no two underscores in a row,
/// none at the end. What has no spelling here becomes `u1F600`, its code point.
pub fn identifier(text: &str, limit: usize) -> EcoString {
    if is_plain(text, limit) { text.into() } else { spelled(text, limit).into() }
}

/// Whether a text is an identifier already.
pub fn is_identifier(text: &str, limit: usize) -> bool {
    is_plain(text, limit) || spelled(text, limit) == text
}

fn spelled(text: &str, limit: usize) -> String {
    let mut out = Spelling { out: String::new(), limit };
    let mut before = None;
    let mut chars = text.chars().peekable();
    while out.out.len() < limit {
        let Some(c) = chars.next() else { break };
        out.character(c, before, &mut chars);
        before = Some(c);
    }
    let mut name = out.out;
    name.truncate(limit);
    name.truncate(name.trim_end_matches('_').len());
    if name.is_empty() {
        name.push_str("unnamed");
    } else if name.starts_with(|c: char| c.is_ascii_digit()) {
        name.insert(0, 'n');
        name.truncate(limit);
        name.truncate(name.trim_end_matches('_').len());
    }
    name
}

/// Whether a text is easily seen to be an identifier, as most names are.
fn is_plain(text: &str, limit: usize) -> bool {
    let bytes = text.as_bytes();
    // An underscore stands neither before nor behind another, nor at an end.
    let mut may_part = false;
    bytes.len() <= limit
        && bytes.first().is_some_and(u8::is_ascii_alphabetic)
        && bytes.iter().all(|byte| {
            let parts = *byte == b'_';
            let is_good = if parts { may_part } else { byte.is_ascii_alphanumeric() };
            may_part = !parts;
            is_good
        })
        && may_part
}

/// The text with every character that is not ASCII spelt in ASCII; `?` for what has no spelling here.
pub fn ascii(text: &str) -> String {
    let mut out = Spelling { out: String::with_capacity(text.len()), limit: usize::MAX };
    let mut before = None;
    let mut chars = text.chars().peekable();
    while let Some(c) = chars.next() {
        let after = chars.peek().copied();
        match letters(lower(c), before, after) {
            _ if c.is_ascii() => out.out.push(c),
            Some(spelling) => out.letters(c, spelling, before, after),
            None => match c {
                '−' | '–' | '—' => out.out.push('-'),
                '↑' => out.out.push_str("rise "),
                '↓' => out.out.push_str("fall "),
                '→' => out.out.push_str("->"),
                '≤' => out.out.push_str("<="),
                '≥' => out.out.push_str(">="),
                '≠' => out.out.push_str("<>"),
                '¬' => out.out.push_str("not "),
                '·' => out.out.push_str("and"),
                '…' => out.out.push_str("..."),
                '\u{300}'..='\u{36F}' => {}
                _ => out.out.push('?'),
            },
        }
        before = Some(c);
    }
    out.out
}

struct Spelling {
    out: String,
    limit: usize,
}

impl Spelling {
    fn character(&mut self, c: char, before: Option<char>, rest: &mut Peekable<Chars>) {
        let after = rest.peek().copied();
        match c {
            'a'..='z' | 'A'..='Z' | '0'..='9' => self.out.push(c),
            '_' => self.separate(true),
            // Actuators are called `A+` and `A-`; elsewhere `-` only separates.
            '+' => self.word("plus"),
            '-' | '−' if !after.is_some_and(char::is_alphanumeric) => self.word("minus"),
            '↑' => self.word("up"),
            '↓' => self.word("down"),
            '°' => self.word("deg"),
            'µ' => self.out.push_str("mu"),
            '²' => self.out.push('2'),
            '³' => self.out.push('3'),
            '\u{308}' if self.out.ends_with(['a', 'o', 'u', 'A', 'O', 'U']) => self.out.push('e'),
            '\u{300}'..='\u{36F}' => {}
            '\0'..='\u{BF}' | '\u{2000}'..='\u{206F}' | '\u{3000}'..='\u{303F}' | '×' | '÷' | '−' => {
                self.separate(false);
            }
            _ => match letters(lower(c), before, after) {
                Some(spelling) => self.letters(c, spelling, before, after),
                None => self.word(&format!("u{:04X}", u32::from(c))),
            },
        }
    }

    /// An underscore, unless one is there; a name may start with one only if it is the user's.
    fn separate(&mut self, written: bool) {
        if !self.out.ends_with('_') && (written || !self.out.is_empty()) {
            self.out.push('_');
        }
    }

    /// A word apart from its neighbours.
    fn word(&mut self, word: &str) {
        self.separate(false);
        if self.out.len() + word.len() <= self.limit {
            self.out.push_str(word);
        } else {
            self.limit = self.out.len(); // A code point cut short would name another one.
        }
        self.separate(false);
    }

    /// The spelling of a letter, in its case: `Щит` is `Shchit`, `ЩИТ` is `SHCHIT`.
    fn letters(&mut self, c: char, spelling: &str, before: Option<char>, after: Option<char>) {
        if !c.is_uppercase() {
            self.out.push_str(spelling);
            return;
        }
        let alphabetic_after = after.filter(|c| c.is_alphabetic());
        let all = match alphabetic_after {
            Some(after) => after.is_uppercase(),
            None => before.is_some_and(char::is_uppercase),
        };
        for (i, letter) in spelling.chars().enumerate() {
            self.out.push(if i == 0 || all { letter.to_ascii_uppercase() } else { letter });
        }
    }
}

fn lower(c: char) -> char {
    c.to_lowercase().next().unwrap_or(c)
}

/// The spelling of a small letter.
fn letters(c: char, before: Option<char>, after: Option<char>) -> Option<&'static str> {
    latin(c).or_else(|| cyrillic(c)).or_else(|| {
        let alone = ![before, after].into_iter().flatten().any(|c| greek(lower(c)).is_some());
        greek(c).map(|(name, sound)| if alone { name } else { sound })
    })
}

fn latin(c: char) -> Option<&'static str> {
    Some(match c {
        'à' | 'á' | 'â' | 'ã' | 'å' | 'ā' | 'ă' | 'ą' | 'ǎ' => "a",
        'ä' | 'æ' => "ae",
        'ç' | 'ć' | 'ĉ' | 'ċ' | 'č' => "c",
        'ď' | 'đ' | 'ð' => "d",
        'è' | 'é' | 'ê' | 'ë' | 'ē' | 'ĕ' | 'ė' | 'ę' | 'ě' | 'ə' => "e",
        'ĝ' | 'ğ' | 'ġ' | 'ģ' => "g",
        'ĥ' | 'ħ' => "h",
        'ì' | 'í' | 'î' | 'ï' | 'ĩ' | 'ī' | 'ĭ' | 'į' | 'ı' => "i",
        'ĳ' => "ij",
        'ĵ' => "j",
        'ķ' | 'ĸ' => "k",
        'ĺ' | 'ļ' | 'ľ' | 'ŀ' | 'ł' => "l",
        'ñ' | 'ń' | 'ņ' | 'ň' | 'ŉ' => "n",
        'ŋ' => "ng",
        'ò' | 'ó' | 'ô' | 'õ' | 'ō' | 'ŏ' | 'ő' => "o",
        'ö' | 'ø' | 'œ' => "oe",
        'ŕ' | 'ŗ' | 'ř' => "r",
        'ś' | 'ŝ' | 'ş' | 'š' | 'ș' | 'ſ' => "s",
        'ß' => "ss",
        'ţ' | 'ť' | 'ŧ' | 'ț' => "t",
        'þ' => "th",
        'ù' | 'ú' | 'û' | 'ũ' | 'ū' | 'ŭ' | 'ů' | 'ű' | 'ų' => "u",
        'ü' => "ue",
        'ŵ' => "w",
        'ý' | 'ÿ' | 'ŷ' => "y",
        'ź' | 'ż' | 'ž' => "z",
        _ => return None,
    })
}

fn cyrillic(c: char) -> Option<&'static str> {
    Some(match c {
        'а' => "a",
        'б' => "b",
        'в' => "v",
        'г' | 'ґ' => "g",
        'д' => "d",
        'е' => "e",
        'ё' => "yo",
        'ж' => "zh",
        'з' => "z",
        'и' | 'і' => "i",
        'й' => "y",
        'к' => "k",
        'л' => "l",
        'м' => "m",
        'н' => "n",
        'о' => "o",
        'п' => "p",
        'р' => "r",
        'с' => "s",
        'т' => "t",
        'у' => "u",
        'ф' => "f",
        'х' => "kh",
        'ц' => "ts",
        'ч' => "ch",
        'ш' => "sh",
        'щ' => "shch",
        'ъ' | 'ь' => "",
        'ы' => "y",
        'э' => "e",
        'ю' => "yu",
        'я' => "ya",
        'є' => "ye",
        'ї' => "yi",
        'ў' => "w",
        'ђ' => "dj",
        'ѓ' => "gj",
        'ѕ' => "dz",
        'ј' => "j",
        'љ' => "lj",
        'њ' => "nj",
        'ћ' => "c",
        'ќ' => "kj",
        'џ' => "dzh",
        _ => return None,
    })
}

/// The name of a letter that stands alone (`Δp`, `ω`) and its sound in a word.
fn greek(c: char) -> Option<(&'static str, &'static str)> {
    Some(match c {
        'α' | 'ά' => ("alpha", "a"),
        'β' => ("beta", "v"),
        'γ' => ("gamma", "g"),
        'δ' => ("delta", "d"),
        'ε' | 'έ' => ("epsilon", "e"),
        'ζ' => ("zeta", "z"),
        'η' | 'ή' => ("eta", "i"),
        'θ' => ("theta", "th"),
        'ι' | 'ί' | 'ϊ' | 'ΐ' => ("iota", "i"),
        'κ' => ("kappa", "k"),
        'λ' => ("lambda", "l"),
        'μ' => ("mu", "m"),
        'ν' => ("nu", "n"),
        'ξ' => ("xi", "x"),
        'ο' | 'ό' => ("omicron", "o"),
        'π' => ("pi", "p"),
        'ρ' => ("rho", "r"),
        'σ' | 'ς' => ("sigma", "s"),
        'τ' => ("tau", "t"),
        'υ' | 'ύ' | 'ϋ' | 'ΰ' => ("upsilon", "y"),
        'φ' => ("phi", "f"),
        'χ' => ("chi", "ch"),
        'ψ' => ("psi", "ps"),
        'ω' | 'ώ' => ("omega", "o"),
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_plain_is_spelled_as_it_is() {
        let long = "x".repeat(64);
        for (text, plain) in [
            ("a", true),
            ("X1", true),
            ("clr_5_b", true),
            ("_x", false),
            ("a_", false),
            ("a__b", false),
            ("1a", false),
            ("", false),
            ("é", false),
            ("a b", false),
            (long.as_str(), false),
        ] {
            assert_eq!(is_plain(text, 63), plain, "{text}");
            assert!(!plain || spelled(text, 63) == text, "{text}");
        }
    }

    #[test]
    fn readable() {
        for (text, expected) in [
            ("start", "start"),
            ("Насос_1", "Nasos_1"),
            ("Щит", "Shchit"),
            ("ЩИТ", "SHCHIT"),
            ("объём", "obyom"),
            ("Жёлтый свет", "Zhyoltyy_svet"),
            ("Tür_öffnen", "Tuer_oeffnen"),
            ("Tu\u{308}r", "Tuer"),
            ("arrêt d'urgence", "arret_d_urgence"),
            ("STRASSE ß", "STRASSE_ss"),
            ("Ärger", "Aerger"),
            ("Δp", "Deltap"),
            ("ω", "omega"),
            ("αντλία", "antlia"),
            ("A+", "A_plus"),
            ("A-", "A_minus"),
            ("pump-1", "pump_1"),
            ("2s/X202", "n2s_X202"),
            ("_x", "_x"),
            ("a__b_", "a_b"),
            ("___", "unnamed"),
            ("", "unnamed"),
            ("ъ", "unnamed"),
            ("😀", "u1F600"),
            ("日本", "u65E5_u672C"),
            ("a😀b", "a_u1F600_b"),
            ("a*)b", "a_b"),
        ] {
            assert_eq!(identifier(text, 63), expected, "{text}");
        }
    }

    #[test]
    fn texts() {
        for (text, expected) in [
            ("a := b; // Щит, größer — 日", "a := b; // Shchit, groesser - ?"),
            ("`x` -> ω\n\t2 − 1", "`x` -> omega\n\t2 - 1"),
        ] {
            assert_eq!(ascii(text), expected);
        }
    }

    #[test]
    fn cut_at_the_limit() {
        assert_eq!(identifier("abcdef", 4), "abcd");
        assert_eq!(identifier("abc_def", 4), "abc");
        assert_eq!(identifier("ab😀", 4), "ab");
        assert_eq!(identifier("12345", 4), "n123");
        assert_eq!(identifier(&"щ".repeat(10_000), 63).len(), 63);
    }
}
