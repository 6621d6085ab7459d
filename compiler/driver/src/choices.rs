//! What targets leave to choose, as arguments of the command line: made of their own lists.

use crate::report::Failure;
use clap::builder::{PossibleValue, PossibleValuesParser, ValueParser};
use clap::{Arg, ArgAction, ArgMatches, Args, Command, Error, FromArgMatches, value_parser};
use grafc::files;
use grafc_backends::choice::{Choice, Chosen, Value, Values};
use grafc_backends::{About, Target};
use std::path::Path;

/// Arguments that say something only where code is made.
pub const NO_CODE: [&str; 2] = ["emit", "dump_after"];

/// The values of `--target`.
pub fn targets() -> PossibleValuesParser {
    PossibleValuesParser::new(Target::ALL.iter().map(|about| PossibleValue::new(about.name).help(about.title)))
}

/// What was chosen.
#[derive(Debug)]
pub struct Choices(Chosen);

impl Choices {
    /// The target with what was chosen.
    pub fn target(&self, about: &About) -> Result<Target, Failure> {
        // An option that only other targets know would be without effect.
        if let Some(other) = self.0.made().find(|made| about.choices.iter().all(|choice| choice.name != *made)) {
            let what = format!("`--{other}` is an option of {}", sentence(known_to(other), "--target "));
            return Err(Failure::WrongUse(what, "leave it out".to_string()));
        }
        about.target(&self.0).map_err(|refusal| Failure::WrongUse(refusal.what, refusal.help))
    }
}

impl FromArgMatches for Choices {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, Error> {
        let mut chosen = Chosen::new();
        for choice in all() {
            let value = match choice.values {
                Values::Names(_) => matches.get_one::<String>(choice.name).cloned().map(Value::Name),
                Values::Number(..) | Values::Interval => {
                    matches.get_one::<u32>(choice.name).copied().map(Value::Number)
                }
                Values::Flag => matches.get_flag(choice.name).then_some(Value::Set),
                Values::File => matches.get_one::<Value>(choice.name).cloned(),
            };
            chosen = value.into_iter().fold(chosen, |chosen, value| chosen.with(choice, value));
        }
        Ok(Choices(chosen))
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), Error> {
        *self = Choices::from_arg_matches(matches)?;
        Ok(())
    }
}

impl Args for Choices {
    fn augment_args(command: Command) -> Command {
        command.args(all().into_iter().map(argument))
    }

    fn augment_args_for_update(command: Command) -> Command {
        Choices::augment_args(command)
    }
}

/// All choices, each once.
fn all() -> Vec<&'static Choice> {
    let mut all: Vec<&Choice> = Vec::new();
    for choice in Target::ALL.iter().flat_map(|about| about.choices) {
        if all.iter().all(|known| known.name != choice.name) {
            all.push(choice);
        }
    }
    all
}

/// The targets that have a choice.
fn known_to(name: &str) -> impl Iterator<Item = &'static About> {
    Target::ALL.iter().filter(move |about| about.choices.iter().any(|choice| choice.name == name))
}

fn argument(choice: &'static Choice) -> Arg {
    let Choice { name, formerly, placeholder, about, default, values } = choice;
    let default = if default.is_empty() { String::new() } else { format!(" [default: {default}]") };
    let help = format!("For {}: {about}{default}", sentence(known_to(name), ""));
    let argument = Arg::new(*name).long(*name).aliases(*formerly).help(help).conflicts_with_all(NO_CODE);
    let parser: ValueParser = match values {
        Values::Names(names) => {
            PossibleValuesParser::new(names().into_iter().map(|(name, about)| PossibleValue::new(name).help(about)))
                .into()
        }
        Values::Number(least, greatest) => value_parser!(u32).range(i64::from(*least)..=i64::from(*greatest)).into(),
        Values::Interval => ValueParser::new(interval),
        Values::File => ValueParser::new(file),
        Values::Flag => return argument.action(ArgAction::SetTrue),
    };
    argument.value_name(*placeholder).value_parser(parser)
}

/// Targets in a sentence: `a`, `b` and `c`.
pub fn sentence(targets: impl Iterator<Item = &'static About>, before: &str) -> String {
    let names: Vec<String> = targets.map(|about| format!("`{before}{}`", about.name)).collect();
    match names.split_last() {
        Some((last, [])) => last.clone(),
        Some((last, others)) => format!("{} and {last}", others.join(", ")),
        None => String::new(),
    }
}

/// The endings that say which target is meant, and those that do not say it alone.
pub fn endings() -> String {
    let mut endings: Vec<(&str, usize)> = Vec::new();
    for ending in Target::ALL.iter().flat_map(About::endings) {
        match endings.iter_mut().find(|(known, _)| *known == ending) {
            Some((_, targets)) => *targets += 1,
            None => endings.push((ending, 1)),
        }
    }
    let (clear, open): (Vec<_>, Vec<_>) = endings.into_iter().partition(|(_, targets)| *targets == 1);
    let listed = |endings: Vec<(&str, usize)>| {
        endings.iter().map(|(ending, _)| format!(".{ending}")).collect::<Vec<_>>().join(", ")
    };
    if open.is_empty() { listed(clear) } else { format!("{}; not {} alone", listed(clear), listed(open)) }
}

/// What a file says.
fn file(path: &str) -> Result<Value, String> {
    let text = files::read(Path::new(path)).map_err(|refusal| refusal.to_string())?;
    let text = String::from_utf8(text).map_err(|_| "it is not UTF-8".to_owned())?;
    let name = Path::new(path).file_name().unwrap_or_default().to_string_lossy().into_owned();
    Ok(Value::File(name, text))
}

/// A cycle time in milliseconds.
fn interval(text: &str) -> Result<u32, &'static str> {
    const FORM: &str = "expected whole milliseconds or seconds, such as 20ms or 1s";
    let (number, factor) = match (text.strip_suffix("ms"), text.strip_suffix('s')) {
        (Some(number), _) => (number, 1),
        (None, Some(number)) => (number, 1000),
        (None, None) => return Err(FORM),
    };
    if number.is_empty() || !number.bytes().all(|b| b.is_ascii_digit()) {
        return Err(FORM);
    }
    let ms = number.parse::<u32>().ok().and_then(|n| n.checked_mul(factor)).filter(|ms| *ms <= i32::MAX as u32);
    match ms {
        Some(0) => Err("a task needs a time between its runs"),
        Some(ms) => Ok(ms),
        None => Err("too long: a time has at most 2147483647 ms"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn endings_are_told_apart() {
        let endings = endings();
        assert!(endings.starts_with(".st, .il, ") && endings.ends_with("; not .xml alone"), "{endings}");
        for about in Target::ALL {
            assert_eq!(endings.matches(&format!(".{}", about.extension)).count(), 1, "{endings}");
        }
    }

    #[test]
    fn intervals_are_whole_milliseconds_above_zero() {
        assert_eq!(interval("20ms"), Ok(20));
        assert_eq!(interval("2s"), Ok(2000));
        for wrong in ["", "20", "ms", "s", "0ms", "-1ms", "+1ms", "1.5s", "1 s", "2147484s", "99999999999ms", "1m"] {
            assert!(interval(wrong).is_err(), "{wrong}");
        }
    }
}
