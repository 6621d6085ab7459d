//! The words of the page: one table, `texts.json`, with a line a word and all its languages.

use std::collections::BTreeMap;
use std::sync::LazyLock;

/// The table as the script gets it, too.
pub(crate) const TABLE: &str = include_str!("texts.json");

static WORDS: LazyLock<BTreeMap<String, BTreeMap<String, String>>> =
    LazyLock::new(|| serde_json::from_str(TABLE).expect("the table of texts is JSON, as a test says"));

/// A language of the page.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub enum Language {
    /// English.
    #[default]
    English,
    /// German.
    German,
}

impl Language {
    /// All of them, in the order of the switch.
    pub const ALL: [Language; 2] = [Language::English, Language::German];

    /// As HTML, and the command line, call it.
    pub fn code(self) -> &'static str {
        match self {
            Language::English => "en",
            Language::German => "de",
        }
    }

    /// What its speakers call it.
    pub fn own_name(self) -> &'static str {
        match self {
            Language::English => "English",
            Language::German => "Deutsch",
        }
    }
}

/// The words in one language.
#[derive(Clone, Copy)]
pub(crate) struct Texts(pub Language);

impl Texts {
    /// A word by its key; a key that there is not is shown as it is, and noticed by a test.
    pub(crate) fn get<'k>(&self, key: &'k str) -> &'k str {
        WORDS.get(key).and_then(|word| word.get(self.0.code())).map_or(key, String::as_str)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::script::FILES;
    use std::collections::BTreeSet;

    fn sources() -> impl Iterator<Item = &'static str> {
        FILES.iter().map(|(_, text)| *text).chain([include_str!("../templates/page.html"), crate::LIVE])
    }

    /// What a template or script asks for.
    fn asked() -> BTreeSet<String> {
        let forms = [
            ("texts.get(\"", '"'),
            ("data-text=\"", '"'),
            ("data-label=\"", '"'),
            ("'data-text': '", '\''),
            ("word('", '\''),
            ("refuse('", '\''),
        ];
        let mut asked = BTreeSet::new();
        for text in sources() {
            for (before, after) in forms {
                let keys = text.split(before).skip(1).filter_map(|rest| rest.split(after).next());
                asked.extend(keys.map(str::to_string));
            }
        }
        asked
    }

    #[test]
    fn every_word_is_there_in_every_language_with_the_same_gaps() {
        for (key, word) in &*WORDS {
            let gaps = |text: &str| {
                let mut gaps: Vec<String> = text
                    .split('{')
                    .skip(1)
                    .filter_map(|rest| rest.split_once('}'))
                    .map(|(gap, _)| gap.into())
                    .collect();
                gaps.sort();
                gaps
            };
            for language in Language::ALL {
                let text = word.get(language.code()).unwrap_or_else(|| panic!("`{key}` is missing in {language:?}"));
                assert!(!text.trim().is_empty(), "`{key}` is empty in {language:?}");
                assert_eq!(gaps(text), gaps(&word["en"]), "`{key}` in {language:?}");
            }
            assert_eq!(word.len(), Language::ALL.len(), "`{key}` is in a language that there is not");
        }
    }

    #[test]
    fn every_word_that_is_asked_for_is_in_the_table() {
        let asked = asked();
        let missing: Vec<&String> = asked.iter().filter(|key| !WORDS.contains_key(*key)).collect();
        assert!(missing.is_empty(), "{missing:?}");
        // Some are put together, or chosen from a list: `flag-LIVELOCK`.
        let is_used = |key: &String| {
            let forms = [format!("'{key}'"), format!("\"{key}\"")];
            key.starts_with("flag-") || sources().any(|text| forms.iter().any(|form| text.contains(form)))
        };
        let unused: Vec<&String> = WORDS.keys().filter(|key| !is_used(key)).collect();
        assert!(unused.is_empty(), "{unused:?}");
    }
}
