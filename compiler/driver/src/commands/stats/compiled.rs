//! `grafc stats --compiled`: what generated C takes on microcontrollers, by the compilers that this machine has.

use crate::report::Failure;
use grafc::Document;
use grafc_backends::Target;
use grafc_backends::c::{self, Files};
use grafc_diagnostics::Diagnostics;
use grafc_logic::{Encoding, Options};
use grafc_model::reaction::Asked;
use serde::Serialize;
use std::io::Write as _;
use std::path::Path;
use std::process::{Command, Stdio};

/// A processor, what the names of its tools begin with, and how code is compiled for it.
struct Processor {
    name: &'static str,
    tools: &'static str,
    options: &'static [&'static str],
}

const PROCESSORS: [Processor; 2] = [
    Processor {
        name: "Cortex-M4",
        tools: "arm-none-eabi-",
        options: &["-mcpu=cortex-m4", "-mthumb", "-ffreestanding"],
    },
    Processor { name: "ATmega328P", tools: "avr-", options: &["-mmcu=atmega328p"] },
];

/// What a chart takes. The names of the fields are those of the JSON object.
#[derive(Serialize)]
pub struct Compiled {
    chart: String,
    processors: Vec<OnProcessor>,
}

#[derive(Serialize)]
struct OnProcessor {
    processor: &'static str,
    compiler: String,
    /// Why nothing was measured.
    missing: Option<String>,
    encodings: Vec<Size>,
}

/// Bytes.
#[derive(Serialize)]
struct Size {
    encoding: &'static str,
    /// Functions and constants.
    code: u64,
    /// The chart's struct.
    memory: u64,
}

impl Compiled {
    /// What a chart takes. There are figures exactly if no message is an error; the failure is that of a compiler.
    pub fn new(document: &mut Document, asked: &Asked) -> Result<(Option<Compiled>, Diagnostics), Failure> {
        let mut diagnostics = document.diagnostics().clone();
        diagnostics.append(document.warnings().clone());
        diagnostics.append(crate::commands::against(document, asked));
        let Some(profile) = document.chart().map(|chart| chart.options.over(asked.profile())) else {
            return Ok((None, diagnostics));
        };
        let mut sources = Vec::new();
        for encoding in Encoding::ALL {
            document.set_options(Options { profile, encoding, ..Options::default() });
            document.bound_as_known(asked.bound_as_known);
            let target = Target::C(c::Options { files: Files::One, ..c::Options::default() });
            let made = document.emit(&target).map(|output| output.text);
            let name = document.program().map(|program| c::names(program).chart.clone());
            match (made, name) {
                (Ok(text), Some(name)) => sources.push((encoding.name(), format!("{text}\n{name} grafc_measured;\n"))),
                (Ok(_), None) => {}
                (Err(found), _) => diagnostics.append(found),
            }
        }
        if diagnostics.has_errors() {
            return Ok((None, diagnostics));
        }
        let chart = document.chart().map(|chart| chart.name.to_string()).unwrap_or_default();
        let processors = PROCESSORS.iter().map(|processor| processor.measure(&sources)).collect::<Result<_, _>>()?;
        Ok((Some(Compiled { chart, processors }), diagnostics))
    }

    pub fn json(&self) -> String {
        // Strings and numbers alone cannot be refused.
        serde_json::to_string(self).unwrap_or_default() + "\n"
    }

    pub fn table(&self) -> String {
        let mut out = format!("{}: bytes of generated C with -Os, code and memory\n", self.chart);
        for found in &self.processors {
            out.push_str(&format!("\n{}\n", found.processor));
            if let Some(missing) = &found.missing {
                out.push_str(&format!("  not measured: {missing}\n"));
            }
            for Size { encoding, code, memory } in &found.encodings {
                out.push_str(&format!("  {encoding:<12}  {code:>7}  {memory:>7}\n"));
            }
        }
        out
    }
}

impl Processor {
    fn measure(&self, sources: &[(&'static str, String)]) -> Result<OnProcessor, Failure> {
        let (gcc, size) = (format!("{}gcc", self.tools), format!("{}size", self.tools));
        let lacks = |tool: &str| Command::new(tool).arg("--version").output().is_err();
        let missing = [&gcc, &size].into_iter().find(|tool| lacks(tool)).map(|tool| format!("{tool} is not on PATH"));
        let mut encodings = Vec::new();
        if missing.is_none() {
            let folder = tempfile::tempdir().map_err(|error| failed(&gcc, &error.to_string()))?;
            for (encoding, source) in sources {
                let object = folder.path().join("chart.o");
                compile(&gcc, self.options, source, &object).map_err(|said| failed(&gcc, &said))?;
                let (code, memory) = sizes(&size, &object).map_err(|said| failed(&size, &said))?;
                encodings.push(Size { encoding, code, memory });
            }
        }
        Ok(OnProcessor { processor: self.name, compiler: gcc, missing, encodings })
    }
}

fn failed(tool: &str, said: &str) -> Failure {
    let said = said.lines().find(|line| line.contains("error")).or(said.lines().next()).unwrap_or_default();
    Failure::WrongUse(format!("`{tool}` does not take the code: {said}"), "leave `--compiled` out".to_owned())
}

fn compile(gcc: &str, options: &[&str], source: &str, object: &Path) -> Result<(), String> {
    let mut command = Command::new(gcc);
    command.args(options).args(["-std=c99", "-Os", "-fno-common", "-x", "c", "-c", "-o"]).arg(object).arg("-");
    let mut child = command.stdin(Stdio::piped()).stderr(Stdio::piped()).spawn().map_err(|error| error.to_string())?;
    if let Some(mut input) = child.stdin.take() {
        // A compiler that goes away says why itself.
        let _ = input.write_all(source.as_bytes());
    }
    let output = child.wait_with_output().map_err(|error| error.to_string())?;
    if output.status.success() { Ok(()) } else { Err(String::from_utf8_lossy(&output.stderr).into_owned()) }
}

/// Bytes of code and of memory: `size` prints those of text, data and what is zero at the start.
fn sizes(size: &str, object: &Path) -> Result<(u64, u64), String> {
    let output = Command::new(size).arg(object).output().map_err(|error| error.to_string())?;
    let printed = String::from_utf8_lossy(&output.stdout).into_owned();
    let numbers: Vec<u64> = printed
        .lines()
        .nth(1)
        .into_iter()
        .flat_map(str::split_whitespace)
        .map_while(|word| word.parse().ok())
        .collect();
    match numbers.as_slice() {
        [text, data, zero, ..] => Ok((text + data, data + zero)),
        _ => Err(printed),
    }
}
