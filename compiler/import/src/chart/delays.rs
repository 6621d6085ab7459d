//! Variables that are named like delays: `2s/X202`, `2s/a/500ms`, `X2/5s`.

use super::names::ImportNames;
use crate::agrafe::model::{Model, NodeKind, VariableKind};
use crate::naming::spell;
use rustc_hash::FxHashMap;

/// What a delay can be of, by the name that the file gives it.
pub struct Steps<'a> {
    /// As it is written in a condition.
    written: FxHashMap<String, &'a str>,
    activity: FxHashMap<String, String>,
}

impl<'a> Steps<'a> {
    /// The steps that no other shares its number with, and the Boolean variables.
    pub fn of(model: &'a Model, names: &'a ImportNames) -> Self {
        let mut activity: FxHashMap<String, String> = FxHashMap::default();
        for (id, node) in model.nodes.iter_enumerated() {
            let letter = match node.kind {
                NodeKind::Step | NodeKind::Enclosing(_) => "",
                NodeKind::Entry => "E",
                NodeKind::Exit => "S",
                NodeKind::Macro(_) => "M",
                NodeKind::Transition(_) | NodeKind::Synchronization => continue,
            };
            let label = &names.labels[id];
            if *label == format!("{letter}{}", node.id) {
                activity.insert(format!("X{label}"), format!("X{label}"));
            }
        }
        let mut written = FxHashMap::default();
        for (id, variable) in model.variables.iter_enumerated() {
            if let (Some(given), false) = (&variable.name, matches!(variable.kind, VariableKind::Step(_)))
                && names.variables[id] == *given
            {
                written.insert(given.clone(), names.variables[id].as_str());
            }
        }
        Steps { written, activity }
    }

    fn operand(&self, name: &str) -> Option<String> {
        self.activity.get(name).map(|name| spell(name)).or_else(|| self.written.get(name).map(|name| spell(name)))
    }
}

/// The delay that a name spells.
pub fn read(name: &str, steps: &Steps) -> Option<String> {
    let parts: Vec<&str> = name.split('/').map(str::trim).collect();
    match parts[..] {
        [delay, operand, reset] => {
            Some(format!("{}/{}/{}", duration(delay)?, steps.operand(operand)?, duration(reset)?))
        }
        [first, second] => match (duration(first), duration(second)) {
            (Some(delay), None) => Some(format!("{delay}/{}", steps.operand(second)?)),
            (None, Some(reset)) => Some(format!("{}/{reset}", steps.operand(first)?)),
            (Some(_), Some(_)) | (None, None) => None,
        },
        _ => None,
    }
}

/// A whole number and a unit, as the language writes them.
fn duration(text: &str) -> Option<String> {
    let digits = text.bytes().take_while(u8::is_ascii_digit).count();
    let (count, unit) = text.split_at(digits);
    let unit = unit.trim_start();
    let milliseconds: i32 = match unit {
        "ms" => 1,
        "s" => 1_000,
        "min" => 60_000,
        "h" => 3_600_000,
        _ => return None,
    };
    let count: i32 = count.parse().ok()?;
    count.checked_mul(milliseconds)?;
    Some(format!("{count}{unit}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_a_delay() {
        let of = |name: &str| (name.to_string(), name.to_string());
        let steps = Steps {
            written: FxHashMap::from_iter([("a".to_string(), "a")]),
            activity: FxHashMap::from_iter([of("X202")]),
        };
        let read = |name| read(name, &steps);
        assert_eq!(read("2s/X202").as_deref(), Some("2s/X202"));
        assert_eq!(read("2 s / a / 500ms").as_deref(), Some("2s/a/500ms"));
        assert_eq!(read("X202/5min").as_deref(), Some("X202/5min"));
        // Another step, no time, too long, no unit, no delay.
        for other in ["2s/X203", "a/X202", "3000000s/a", "2/a", "2s", "2s/a/1s/1s", "2s/3s", ""] {
            assert_eq!(read(other), None, "{other}");
        }
    }
}
