//! `grafc import`: the charts of another tool as `.gct` texts, and a report.

use super::refuse_output_over_input;
use crate::Exit;
use crate::arguments::MessageArguments;
use crate::report::{Failure, Report};
use crate::stream::Stream;
use clap::{Args, ValueEnum};
use std::path::Path;

const AFTER_HELP: &str = "\
Example:
  grafc import plc.xml -o plant.gct
  grafc import export.xml --pou Crane --dialect codesys -o crane.gct
  grafc import export.xml -o charts/
  grafc import plant.grafcet -o plant.gct
  grafc import machine.kiss2 -o machine.gct

Reads PLCopen XML (Beremiz, OpenPLC, CODESYS, TwinCAT), sequential function charts as text of IEC 61131-3, charts of
AGRAFE (*.grafcet, XMI), and tables of automata (KISS2). The report goes to standard error: W0701 changed, W0702 doubtful, W0703 lost. The result is
in the format of `grafc fmt`; `grafc check` says whether it keeps the rules.";

/// Whose meaning of sequential function charts counts.
#[derive(ValueEnum, Clone, Copy, Debug)]
enum Dialect {
    /// IEC 61131-3 as MATIEC has it: Beremiz, OpenPLC
    Iec,
    /// CODESYS and TwinCAT: the leftmost transition goes first, actions are done once more at their end
    Codesys,
    /// ISaGRAF
    Isagraf,
}

/// Arguments of `grafc import`.
#[derive(Args, Debug)]
#[command(after_help = AFTER_HELP)]
pub struct Arguments {
    /// The file of the other tool; `-` is standard input
    #[arg(value_name = "FILE")]
    file: Stream,
    /// Where to put the chart, or a folder for all charts of the file [default: standard output]
    #[arg(short, long, value_name = "CHART")]
    output: Option<Stream>,
    /// Of several program organisation units, the one that is wanted
    #[arg(long, value_name = "NAME")]
    pou: Option<String>,
    /// Whose meaning counts where tools differ [default: that of the tool that the file names, else iec]
    #[arg(long)]
    dialect: Option<Dialect>,
    /// Take variables that are named like delays, such as `2s/X202`, for these delays
    #[arg(long)]
    delays: bool,
    #[command(flatten)]
    messages: MessageArguments,
}

/// Imports the charts of a file.
pub fn run(args: Arguments) -> Result<Exit, Failure> {
    let output = args.output.unwrap_or(Stream::Standard);
    refuse_output_over_input(&output, [&args.file])?;
    let folder = match &output {
        Stream::File(path) if Stream::is_folder(path) => Some(path.clone()),
        Stream::File(_) | Stream::Standard => None,
    };
    let options = grafc_import::Options {
        delays: args.delays,
        dialect: args.dialect.map(|dialect| match dialect {
            Dialect::Iec => grafc_import::Dialect::Iec,
            Dialect::Codesys => grafc_import::Dialect::Codesys,
            Dialect::Isagraf => grafc_import::Dialect::Isagraf,
        }),
        unit: args.pou,
    };

    let mut report = Report::new(args.messages.policy()?);
    let mut made = Vec::new();
    if let Some(file) = report.load(&args.file)? {
        let text = &report.sources.file(file).text;
        let diagnostics = if folder.is_some() {
            let (charts, diagnostics) = grafc_import::import_all(file, text, &options);
            made.extend(charts.into_iter().map(|chart| (chart.name, chart.text)));
            diagnostics
        } else {
            let (chart, diagnostics) = grafc_import::import(file, text, &options);
            made.extend(chart.map(|chart| (String::new(), chart)));
            diagnostics
        };
        report.diagnostics.append(diagnostics);
    }
    let exit = report.tell(args.messages.messages());
    if report.has_errors() {
        return Ok(exit);
    }
    for (name, text) in made {
        match &folder {
            Some(folder) => Stream::File(folder.join(file_name(&name, &args.file))).write(&text)?,
            None => output.write(&text)?,
        }
    }
    Ok(exit)
}

/// The name of the file of a chart in a folder.
fn file_name(name: &str, input: &Stream) -> String {
    let plain: String = name.chars().map(|c| if c.is_alphanumeric() || c == '_' { c } else { '_' }).collect();
    if plain.is_empty() {
        Path::new(&input.chart_name()).with_extension("gct").display().to_string()
    } else {
        plain + ".gct"
    }
}
