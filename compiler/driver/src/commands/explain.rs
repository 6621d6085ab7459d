//! `grafc explain`: the page on a diagnostic code.

use crate::Exit;
use crate::report::Failure;
use clap::Args;
use grafc::files::print;
use grafc_diagnostics::{Code, Severity};

const AFTER_HELP: &str = "\
Example:
  grafc explain E0304

A code may also be given by its name: `grafc explain transition-without-steps`.";

/// Arguments of `grafc explain`.
#[derive(Args, Debug)]
#[command(after_help = AFTER_HELP)]
pub struct Arguments {
    /// A code such as E0304, or its name
    #[arg(value_name = "CODE")]
    code: String,
}

/// Prints the page, or names codes that were perhaps meant.
pub fn run(args: Arguments) -> Result<Exit, Failure> {
    let asked = args.code.trim();
    match Code::find(asked) {
        Some(code) => {
            print(code.page())?;
            Ok(Exit::Done)
        }
        None => {
            let near: Vec<String> =
                near(asked).into_iter().map(|c| format!("`{}` ({})", c.as_str(), c.slug())).collect();
            let help = match near.is_empty() {
                false => format!("perhaps {}", near.join(" or ")),
                true => {
                    let of = |severity| Code::ALL.iter().filter(move |c| c.severity() == severity).map(|c| c.as_str());
                    let ends = |severity| (of(severity).next().unwrap_or(""), of(severity).next_back().unwrap_or(""));
                    let (errors, warnings) = (ends(Severity::Error), ends(Severity::Warning));
                    let (e0, e1, w0, w1) = (errors.0, errors.1, warnings.0, warnings.1);
                    format!("errors run from {e0} to {e1}, warnings from {w0} to {w1}, with gaps")
                }
            };
            Err(Failure::WrongUse(format!("no diagnostic has the code `{asked}`"), help))
        }
    }
}

/// At most three codes that differ by a slip or two, or whose name holds what was asked, the nearest first.
fn near(asked: &str) -> Vec<Code> {
    // No code is longer, and the distance costs time that grows with both lengths.
    let asked: String = asked.to_lowercase().chars().take(60).collect();
    let mut near: Vec<(usize, Code)> = Vec::new();
    for code in Code::ALL.iter().copied() {
        let by_code = strsim::osa_distance(&asked, &code.as_str().to_lowercase());
        let by_name = strsim::osa_distance(&asked, code.slug());
        let in_name = asked.chars().count() >= 4 && code.slug().contains(&asked);
        if by_code <= 2 {
            near.push((by_code, code));
        } else if in_name || by_name <= code.slug().len() / 4 {
            near.push((by_name, code));
        }
    }
    near.sort();
    near.into_iter().map(|(_, code)| code).take(3).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_code_is_found_in_any_case_and_by_name() {
        assert_eq!(Code::find("e0201"), Some(Code::E0201));
        assert_eq!(Code::find("Unknown-Name"), Some(Code::E0201));
        assert_eq!(Code::find("E201"), None);
    }

    #[test]
    fn near_codes_are_named() {
        assert_eq!(near("E201")[0], Code::E0201);
        assert!(near("W0201").contains(&Code::E0201));
        assert_eq!(near("unknwon-name"), [Code::E0201]);
        assert!(near("enclosure").len() == 3);
        assert!(near("zzzzzzzzzzzz").is_empty());
        assert!(near(&"x".repeat(1_000_000)).is_empty());
    }
}
