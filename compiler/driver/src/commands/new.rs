//! `grafc new`: a folder with a chart that works, a trace for it, and what to do with both.

use crate::Exit;
use crate::arguments::QuietArgument;
use crate::report::Failure;
use clap::Args;
use grafc::files::{self, Refusal, print};
use grafc_diagnostics::FileId;
use std::fs;
use std::path::{Path, PathBuf};

const AFTER_HELP: &str = "\
Example:
  grafc new mixer

It makes the folder `mixer` with mixer.gct, mixer.trace.csv and README.md; nothing that is there is overwritten.";

/// What is made: the ending of each file, or its name, and its text.
const CHART: &str = include_str!("../../templates/chart.gct");
const TRACE: &str = include_str!("../../templates/trace.csv");
const README: &str = include_str!("../../templates/README.md");

/// Arguments of `grafc new`.
#[derive(Args, Debug)]
#[command(after_help = AFTER_HELP, override_usage = "grafc new [OPTIONS] <NAME>")]
pub struct Arguments {
    /// The name of the folder and of the chart in it
    #[arg(value_name = "NAME")]
    name: Option<PathBuf>,
    #[command(flatten)]
    quiet: QuietArgument,
}

/// Makes the folder; all of it or nothing.
pub fn run(args: Arguments) -> Result<Exit, Failure> {
    let folder = args.name.ok_or_else(|| wrong("`grafc new` makes a folder, and needs its name".to_string()))?;
    let name = name(&folder)?;
    let chart = chart_name(name);
    let filled = |template: &str| template.replace("{name}", name).replace("{chart}", &chart);
    let texts = [
        (format!("{name}.gct"), filled(CHART)),
        (format!("{name}.trace.csv"), filled(TRACE)),
        ("README.md".to_string(), filled(README)),
    ];
    let refused = |error| Refusal::to_write(folder.display().to_string(), error);
    if let Some(around) = folder.parent().filter(|around| !around.as_os_str().is_empty()) {
        files::make_folder(around)?;
    }
    // Fails if there is anything of that name.
    fs::create_dir(&folder).map_err(refused)?;
    if let Err(refusal) = texts.iter().try_for_each(|(file, text)| files::write(&folder.join(file), text)) {
        // All in it is ours; and what was wrong before is what is worth saying.
        let _ = fs::remove_dir_all(&folder);
        return Err(refusal.into());
    }
    if !args.quiet.quiet {
        print(&done(&folder, name, texts.map(|(file, _)| file)))?;
    }
    Ok(Exit::Done)
}

fn done(folder: &Path, name: &str, files: [String; 3]) -> String {
    let made: Vec<String> = files.iter().map(|file| folder.join(file).display().to_string()).collect();
    let cd = format!("cd {}", folder.display());
    format!("made {}\n\n  {cd}\n  grafc sim {name}.gct --trace {name}.trace.csv\n", made.join(", "))
}

/// The last part of a path, which can stand in the name of a file and, unquoted, in a command.
fn name(folder: &Path) -> Result<&str, Failure> {
    let name = folder.file_name().and_then(|name| name.to_str()).unwrap_or_default();
    let is_plain = name.chars().all(|c| c.is_alphanumeric() || c == '_' || c == '-');
    if name.is_empty() || name.starts_with('-') || !is_plain {
        return Err(wrong(format!("`{}` cannot be the name of a chart", folder.display())));
    }
    Ok(name)
}

fn wrong(what: String) -> Failure {
    let help = "give a name of letters, digits, `_` and `-`, such as `grafc new mixer`";
    Failure::WrongUse(what, help.to_string())
}

/// The name that the chart gives itself: in backquotes only if it must be.
fn chart_name(name: &str) -> String {
    let name = name.replace('-', "_");
    let text = CHART.replace("{chart}", &name);
    let (chart, _) = grafc::check(FileId::new(0), &text, &name);
    if chart.is_some() { name } else { format!("`{name}`") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_are_plain() {
        for (path, expected) in [("mixer", "mixer"), ("a/b-1", "b-1"), ("Мешалка", "Мешалка"), ("x/", "x")]
        {
            assert_eq!(name(Path::new(path)).ok(), Some(expected));
        }
        for path in ["", ".", "..", "/", "a b", "-x", "x.gct", "a`b", "a\nb"] {
            assert!(name(Path::new(path)).is_err(), "{path}");
        }
    }

    #[test]
    fn a_chart_name_is_a_name() {
        for (name, expected) in [("mixer", "mixer"), ("b-1", "b_1"), ("2nd", "`2nd`"), ("step", "`step`")] {
            assert_eq!(chart_name(name), expected);
        }
    }
}
