//! What was probably meant by a word that is no command: it looks like a chart that is not there.

use clap::Command;
use std::path::Path;

/// Words by which other tools, and people, call what a command does, or what needs none.
const OTHER_WORDS: &[(&[&str], &str, &str)] = &[
    (&["run", "simulate", "simulation", "exec", "execute", "play"], "sim", "grafc sim CHART --trace IN.csv"),
    (&["compile", "build", "make", "gen", "generate", "translate"], "", "grafc CHART --target st"),
    (&["emit", "dump"], "", "grafc CHART --emit STAGE"),
    (&["watch"], "", "grafc CHART -o FILE --watch"),
    (&["lint", "validate"], "check", "grafc check CHART"),
    (&["prove", "proof", "claims", "model-check"], "verify", "grafc verify CHART"),
    (&["format", "pretty", "indent"], "fmt", "grafc fmt CHART"),
    (&["init", "create", "template", "start"], "new", "grafc new NAME"),
    (&["convert", "open", "load"], "import", "grafc import FILE"),
    (&["automaton", "fsm", "moore", "mealy", "minimize", "minimise", "kiss2"], "automata", "grafc automata CHART"),
    (&["statistics", "size", "measure", "info"], "stats", "grafc stats CHART"),
    (&["error", "describe", "why", "doc"], "explain", "grafc explain CODE"),
    (&["manual"], "man", "grafc man"),
    (&["coverage", "cover", "scenario", "scenarios"], "test", "grafc test [PATH]"),
    (&["version"], "", "grafc --version"),
];

/// A message, if the first of these words, of which none is a file, was probably meant as a command; or another, behind a chart.
pub fn command(words: &[&str], root: &Command) -> Option<String> {
    let names: Vec<&str> = root.get_subcommands().map(Command::get_name).collect();
    if let Some(behind) = words.iter().find(|word| names.contains(word)) {
        // As the first word it would have been taken as the command that it is.
        return Some(format!("`{behind}` is no chart\n\n  tip: a command comes first: `grafc {behind} ...`"));
    }
    let first = words.first().filter(|word| is_word(word) && !Path::new(word).exists())?;
    let lower = first.to_lowercase();
    if let Some((_, _, call)) = OTHER_WORDS.iter().find(|(words, ..)| words.contains(&lower.as_str())) {
        return Some(format!("grafc has no command `{first}`\n\n  tip: that is `{call}`"));
    }
    let near = names.iter().map(|name| (strsim::jaro_winkler(name, &lower), *name)).filter(|(near, _)| *near > 0.85);
    if let Some((_, near)) = near.max_by(|one, two| one.0.total_cmp(&two.0)) {
        return Some(format!("grafc has no command `{first}`\n\n  tip: a similar command exists: `grafc {near}`"));
    }
    let chart = format!("{first}.gct");
    Path::new(&chart).exists().then(|| format!("there is no file `{first}`\n\n  tip: there is `{chart}`"))
}

/// Whether it could be a command: not a path, no ending, and no option.
fn is_word(text: &str) -> bool {
    !text.is_empty() && !text.starts_with('-') && text.chars().all(|c| c.is_alphanumeric() || c == '-' || c == '_')
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::command_line::CommandLine;
    use clap::CommandFactory;

    fn meant(words: &[&str]) -> String {
        command(words, &CommandLine::command()).unwrap_or_default()
    }

    #[test]
    fn other_words_lead_to_commands_that_exist() {
        let root = CommandLine::command();
        for (words, name, call) in OTHER_WORDS {
            assert!(name.is_empty() || root.get_subcommands().any(|command| command.get_name() == *name), "{name}");
            assert!(call.starts_with("grafc ") && call.contains(name), "{call}");
            for word in *words {
                assert!(root.get_subcommands().all(|command| command.get_name() != *word), "{word} is a command");
                assert!(meant(&[word, "x.gct"]).ends_with(&format!("that is `{call}`")), "{word}");
            }
        }
    }

    #[test]
    fn near_words_and_commands_behind_a_chart_are_seen() {
        assert!(meant(&["chek", "x.gct"]).contains("`grafc check`"));
        assert!(meant(&["Check"]).contains("`grafc check`"));
        assert!(meant(&["x.gct", "check"]).contains("a command comes first: `grafc check ...`"));
        for no_command in [&["x.gct", "y.gct"][..], &["pumpe"], &["./run"], &["run.gct"], &[]] {
            assert_eq!(meant(no_command), "", "{no_command:?}");
        }
    }
}
