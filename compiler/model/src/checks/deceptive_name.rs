//! W0426: a name that is not what it looks like (UTS #39).
//!
//! Two names that look alike are two names for grafc and one for a reader; so is a name with a mark in it that cannot be
//! seen, or with its accents apart from their letters. Names of ASCII alone are not compared with each other: `I1` and `l1`
//! are a matter of the font.
//!
//! Warned of: `page` and `pаge`, the second with a Cyrillic letter
//! Not warned of: `Tür`, `Клапан`, `Клапан_A1`

use crate::deceptive::{composed, is_invisible, looks, mixed};
use crate::resolve::Resolved;
use grafc_diagnostics::{Code, Diagnostic, Diagnostics, Span};
use rustc_hash::FxHashMap;

/// At most one warning a name.
pub fn check(resolved: &Resolved, diagnostics: &mut Diagnostics) {
    let (chart, parts) = (&resolved.chart, &resolved.parts);
    names(parts.heading.iter().map(|heading| (heading.name.text.as_str(), heading.name.span)), diagnostics);
    let steps = chart.steps.iter().map(|step| (step.label.as_str(), step.span));
    let macro_steps = chart.macro_steps.iter().map(|step| (step.label.as_str(), step.span));
    names(chart.variables.iter().map(|variable| (variable.name.as_str(), variable.span)), diagnostics);
    names(steps.chain(macro_steps), diagnostics);
    let designations = parts.transitions.iter().filter_map(|part| part.ast.designation());
    names(designations.map(|name| (name.text.as_str(), name.span)), diagnostics);
    names(chart.grafcets.iter().map(|grafcet| (grafcet.name.as_str(), grafcet.span)), diagnostics);
}

/// The names of one kind.
fn names<'n>(all: impl Iterator<Item = (&'n str, Span)> + Clone, diagnostics: &mut Diagnostics) {
    if all.clone().all(|(name, _)| name.is_ascii()) {
        return;
    }
    // Of names that look alike the first; one of ASCII, if there is one.
    let mut first: FxHashMap<String, (&str, Span)> = FxHashMap::default();
    for (name, span) in all.clone() {
        let entry = first.entry(looks(name)).or_insert((name, span));
        if name.is_ascii() && !entry.0.is_ascii() {
            *entry = (name, span);
        }
    }
    for (name, span) in all.filter(|(name, _)| !name.is_ascii()) {
        let say = |message: String| Diagnostic::new(Code::W0426, span, message);
        let like = first.get(&looks(name)).filter(|(other, _)| *other != name);
        let found = if let Some(c) = name.chars().find(|c| is_invisible(*c)) {
            Some(say(format!("a name holds U+{:04X}, which cannot be seen", u32::from(c))).help("write it without"))
        } else if let Some((other, place)) = like {
            let message = format!("the name `{name}` looks like `{other}`");
            Some(say(message).also(*place, "which is another name").help("give one of them another name"))
        } else if let Some([one, another]) = mixed(name) {
            let message = format!("the name `{name}` mixes letters of two alphabets: {one} and {another}");
            Some(say(message).help("write each of its words in one alphabet"))
        } else {
            composed(name).map(|usual| {
                say(format!("accents in the name `{name}` are characters of their own"))
                    .note("a name that looks the same, as keyboards write it, is another one")
                    .help(format!("write `{usual}`"))
            })
        };
        if let Some(found) = found {
            diagnostics.push(found);
        }
    }
}

#[cfg(test)]
mod tests {
    use crate::checks::testing::{passes, passes_with};

    fn chart(first: &str, second: &str) -> String {
        format!(
            "input `{first}`, `{second}` : bool initial step 1 step 2 transition 1 -> 2 : `{first}` and not `{second}`"
        )
    }

    #[test]
    fn names_that_look_alike() {
        passes_with(&["W0426"], &chart("page", "p\u{430}ge"));
        passes_with(&["W0426"], &chart("\u{441}\u{430}\u{440}", "cap"));
        passes_with(&["W0426"], &chart("Tür", "Tu\u{308}r"));
        passes_with(&["W0426"], &chart("pump", "pu\u{200B}mp"));
        passes_with(
            &["W0426"],
            "input a : bool initial step cap step `\u{441}\u{430}\u{440}` transition cap -> `\u{441}\u{430}\u{440}` : a",
        );
    }

    #[test]
    fn of_the_chart_and_of_transitions() {
        passes_with(&["W0426"], "chart p\u{430}ge input a : bool initial step 1 transition 1 -> : a");
        let designated = |first: &str, second: &str| {
            format!(
                "chart Page input a : bool initial step 1 step 2
                 transition (`{first}`) 1 -> 2 : a transition (`{second}`) 2 -> 1 : not a"
            )
        };
        passes_with(&["W0426"], &designated("cap", "\u{441}\u{430}\u{440}"));
        passes_with(&["W0426"], &designated("t1", "t\u{200B}2"));
        passes(&designated("Öffnen", "Schließen"));
    }

    #[test]
    fn one_name_by_itself() {
        passes_with(&["W0426"], &chart("a", "p\u{430}ge"));
        passes_with(&["W0426"], &chart("a", "pu\u{202E}mp"));
        passes_with(&["W0426"], &chart("a", "Tu\u{308}r"));
    }

    #[test]
    fn what_is_what_it_looks_like() {
        passes(&chart("Tür", "Tor"));
        passes(&chart("Клапан", "Клапан_A1"));
        passes(&chart("ΔT", "Δp"));
        passes(&chart("I1", "l1"));
    }
}
