//! Every name that MATIEC or its library has for itself, and names that hold such a name, as the name of everything that
//! a chart names: what comes out is taken by MATIEC as Beremiz calls it.

use grafc::{Options, Product};
use grafc_backends::{Target, st};
use grafc_diagnostics::FileId;
use grafc_testsuite::executors::matiec::Tools;
use grafc_testsuite::share::share;
use std::fmt::Write as _;

/// So many names go into one chart, and so many charts into one file.
const TOGETHER: usize = 120;

/// Names that end or begin like keywords, that are like operators, or hold a keyword.
const LIKE_WORDS: &str = "
    Blend Blend_program bend_function x_END_FUNCTION_BLOCK END_PROGRAM lend_action send_transition tend_configuration
    end_functions var_input VAR_INPUTS varint if_ IFX case1 returned MOD_INT NOT_BOOL AND_WORD XOR_DWORD OR_BYTE
    DATE_AND_TIME_TO_DATE DATE_AND_TIME_TO_TIME_OF_DAY Cycle Run State K Auto T M N
";

/// Compiles each text as a file of its own; which of them fail, and why.
fn refused(tools: &Tools, texts: &[String]) -> Vec<String> {
    let mut found = Vec::new();
    for text in texts {
        let folder = tempfile::tempdir().expect("a folder");
        std::fs::write(folder.path().join("charts.st"), text).expect("written");
        if let Err(said) = tools.iec2c_in_any_order(folder.path()) {
            let first = said.lines().find(|line| line.contains("error")).unwrap_or(&said).to_string();
            let line = first.split(':').nth(1).and_then(|number| number.parse::<usize>().ok()).unwrap_or(1);
            let at = text.lines().nth(line - 1).unwrap_or_default();
            found.push(format!("{first}\n    {at}"));
        }
    }
    found
}

fn compiled(chart: &str) -> String {
    let options = Options::new(grafc_logic::Options::default(), Product::Code(Target::St(st::Options::default())));
    let (made, said) = grafc::compile(FileId::default(), chart, "names", &options);
    made.unwrap_or_else(|| panic!("{said:?}\n{chart}")).text
}

/// A chart whose variables, steps, transitions and grafcets have these names, in turn: each kind for itself.
fn charts(names: &[String], number: usize) -> Vec<String> {
    let quoted: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
    let all = quoted.join(", ");
    let any = quoted.join(" or ");
    let mut inputs = format!("chart I{number}\ninput {all} : bool\noutput q_{number} : bool\n");
    let _ = write!(
        inputs,
        "initial step first\nstep second {{ q_{number} }}\ntransition first -> second : {any}\ntransition second -> first : ↑({any})\n"
    );
    let mut outputs = format!(
        "chart O{number}\ninput in_{number} : bool\noutput {all} : bool\ninitial step first\nstep second {{ {} }}\n",
        quoted.join(" ")
    );
    let _ = write!(outputs, "transition first -> second : in_{number}\ntransition second -> first : not in_{number}\n");
    let mut values =
        format!("chart V{number}\ninput in_{number} : bool\nvar {all} : int\ninitial step first\nstep second {{\n");
    quoted.iter().for_each(|name| {
        let _ = writeln!(values, "  {name} := {name} + 1 on activation");
    });
    let _ =
        write!(values, "}}\ntransition first -> second : in_{number}\ntransition second -> first : not in_{number}\n");
    let mut steps = format!("chart S{number}\ninput in_{number} : bool\n");
    for (place, name) in quoted.iter().enumerate() {
        let _ = writeln!(steps, "{}step {name}", if place == 0 { "initial " } else { "" });
        let next = &quoted[(place + 1) % quoted.len()];
        let _ = writeln!(steps, "transition ({name}) {name} -> {next} : ↑in_{number} and 1s/`X{}`", &names[place]);
    }
    let mut grafcets = format!("chart G{number}\ninput in_{number} : bool\n");
    for (place, name) in quoted.iter().enumerate() {
        let _ = writeln!(
            grafcets,
            "grafcet {name} {{ initial step {place} step b{place} transition {place} -> b{place} : in_{number} }}"
        );
    }
    [inputs, outputs, values, steps, grafcets].iter().map(|chart| compiled(chart)).collect()
}

#[test]
fn every_name_is_taken_in_each_position() {
    let Some(tools) = Tools::find_or_skip() else { return };
    let mut names = tools.library_names().expect("a library that can be read");
    assert!(names.len() > 500, "only {} names", names.len());
    names.extend(LIKE_WORDS.split_ascii_whitespace().map(str::to_string));
    // In a chart names differ by more than case.
    let mut known = std::collections::BTreeSet::new();
    names.retain(|name| known.insert(name.to_ascii_uppercase()));
    let mut texts = Vec::new();
    for (number, names) in names.chunks(TOGETHER).enumerate() {
        texts.push(charts(names, number).concat());
        let one = |name: &String| {
            compiled(&format!(
                "chart `{name}`\ninput in_1 : bool\noutput out_1 : bool\ninitial step 1\nstep 2 {{ out_1 }}\n\
                 transition 1 -> 2 : in_1\ntransition 2 -> 1 : not in_1\n"
            ))
        };
        texts.push(names.iter().map(one).collect());
    }
    let texts = share(0, texts);
    let refused = refused(&tools, &texts);
    assert!(refused.is_empty(), "{} of {} files:\n{}", refused.len(), texts.len(), refused.join("\n"));
}
