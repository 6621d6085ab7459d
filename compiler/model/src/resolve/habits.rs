//! Habits of other languages that only show where names are known: what means nothing here, and what was meant.
//!
//! Those that the grammar stops at are cured there.

use grafc_syntax::ast::{Action, ActionKind, PulseKind};
use grafc_syntax::habits::words::{Qualifier, qualified, qualifier};

/// A name that means nothing, and what to write.
pub struct Habit {
    /// What is said of it.
    pub words: String,
    /// What is written instead.
    pub instead: String,
}

/// What was meant by a name that means nothing; `is_known` tells of others.
pub fn name(text: &str, is_known: impl Fn(&str) -> bool) -> Option<Habit> {
    let habit = |words: String, instead: String| Some(Habit { words, instead });
    let lower = text.to_lowercase();
    if matches!(lower.as_str(), "true" | "false") {
        return habit(format!("write `{lower}`"), lower);
    }
    // `a\u{305}` is how a drawing program writes a bar above the letter.
    let bare: String = text.chars().filter(|c| !matches!(c, '\u{304}' | '\u{305}')).collect();
    if bare != text && is_known(&bare) {
        return habit(format!("the complement is written `not {bare}`"), format!("not {bare}"));
    }
    let mut letters = text.chars();
    if let Some(letter @ ('x' | 't')) = letters.next() {
        let implicit = format!("{}{}", letter.to_uppercase(), letters.as_str());
        if is_known(&implicit) {
            return habit(format!("did you mean `{implicit}`?"), implicit);
        }
    }
    let prefix = ["x_", "step_", "step", "etape_", "etape", "étape", "schritt_", "schritt"];
    let label = prefix.into_iter().find_map(|prefix| lower.strip_prefix(prefix));
    let activity = format!("X{}", label.filter(|label| label.bytes().all(|byte| byte.is_ascii_digit()))?);
    if is_known(&activity) { habit(format!("did you mean `{activity}`?"), activity) } else { None }
}

/// What a continuous action seems to be that no output is called like.
pub enum Stray {
    /// A qualifier or an order before the action behind it; the whole in our words, if that is possible, and what is said.
    Word(Option<String>, String),
    /// `when` between an output and its condition.
    If,
}

/// Looks at a name that is no output, and at the action behind it.
pub fn stray(name: &str, next: &Action, step: &str) -> Option<Stray> {
    let words = ["when", "while", "if", "wenn", "falls", "si", "quand"];
    if words.contains(&name.to_lowercase().as_str()) {
        let is_operand = matches!(next.kind, ActionKind::Continuous { condition: None, .. });
        return is_operand.then_some(Stray::If);
    }
    if PulseKind::ALL.iter().any(|kind| kind.word() == name) {
        let ActionKind::Continuous { target, condition: None } = &next.kind else { return None };
        let right = format!("{name} {} on activation", target.text);
        let words = format!("a pulse order says when it is given: write `{right}`");
        return Some(Stray::Word(Some(right), words));
    }
    let found = qualifier(name)?;
    let target = match &next.kind {
        ActionKind::Continuous { target, condition: None } => &target.text,
        ActionKind::Continuous { .. }
        | ActionKind::Stored { .. }
        | ActionKind::Pulse { .. }
        | ActionKind::Run { .. }
        | ActionKind::Force { .. } => {
            return Some(Stray::Word(None, format!("there are no qualifiers: leave out `{name}`")));
        }
    };
    let right = qualified(found, target, None, step);
    let words = match (&right, found) {
        (Some(right), _) => format!("there are no qualifiers: write `{right}`"),
        (None, Qualifier::Delayed) => format!("there are no qualifiers: a delay is written `{target} if …/X{step}`"),
        (None, Qualifier::Limited) => {
            format!("there are no qualifiers: a limit is written `{target} if not …/X{step}`")
        }
        (None, Qualifier::LastPulse) => format!("there are no qualifiers: write `{target} := … on deactivation`"),
        (
            None,
            Qualifier::Continuous
            | Qualifier::Set
            | Qualifier::Reset
            | Qualifier::DelayedSet
            | Qualifier::Pulse
            | Qualifier::StoredTime,
        ) => format!("there are no qualifiers: write `{target} := … on activation`"),
    };
    Some(Stray::Word(right, words))
}
