//! Measures what a scan of generated Rust and C costs, beside a `match` or `switch` by hand and, where it is there, MATIEC's C.
//!
//! ```text
//! cargo run --release -p grafc-testsuite --bin rust_cost -- --sizes 100,1000 --folder /tmp/cost
//! ```
//!
//! Needs rustc; with a C compiler C is measured, too; with `iec2c` and `gcc` on PATH the SFC of MATIEC is measured too, up to 1,000 steps. What rustc could not
//! compile in time stands in the table without figures.

#![allow(clippy::print_stdout, clippy::print_stderr, reason = "a command")]

use clap::{Parser, ValueEnum};
use grafc_logic::Encoding;
use grafc_model::reaction::Evolution;
use grafc_testsuite::executors::rust::Tools;
use grafc_testsuite::executors::{c, matiec};
use grafc_testsuite::rings::Rings;
use grafc_testsuite::rust_cost::{BASE, Figure, Job, Others, Row, measure};
use serde_json::json;
use std::num::NonZero;
use std::path::PathBuf;
use std::process::ExitCode;
use std::time::Duration;

/// What a scan of generated Rust and C costs, beside a `match` or `switch` by hand and MATIEC's SFC
#[derive(Parser, Debug)]
struct Options {
    /// Steps of all rings
    #[arg(long, value_name = "N,…", value_delimiter = ',', default_value = "10,100,1000,10000")]
    sizes: Vec<NonZero<usize>>,
    /// Rings that the steps are shared out to
    #[arg(long, value_name = "N,…", value_delimiter = ',', default_value = "1,10,100")]
    tokens: Vec<NonZero<usize>>,
    /// Steps of each ring that its token goes through [default: all]
    #[arg(long, value_name = "N")]
    walked: Option<NonZero<usize>>,
    /// How the situation is held
    #[arg(long, value_name = "NAME,…", value_delimiter = ',', default_value = "switch,single-phase,sequent")]
    #[arg(value_parser = encoding)]
    encodings: Vec<Encoding>,
    /// To a stable situation, or one micro-step a scan
    #[arg(long, value_enum, default_value = "both")]
    evolution: Evolutions,
    /// Turns in which everything is timed once
    #[arg(long, value_name = "N", default_value = "21")]
    repetitions: NonZero<usize>,
    /// How long rustc may take for one chart
    #[arg(long, value_name = "SECONDS", default_value_t = 300)]
    limit: u64,
    /// Where texts and programs are kept; what is there is not built again
    #[arg(long, value_name = "DIR")]
    folder: Option<PathBuf>,
    /// Print all figures as one object
    #[arg(long)]
    json: bool,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Evolutions {
    Stable,
    Scan,
    Both,
}

impl Evolutions {
    fn all(self) -> Vec<Evolution> {
        match self {
            Evolutions::Stable => vec![Evolution::Stable],
            Evolutions::Scan => vec![Evolution::Scan],
            Evolutions::Both => vec![Evolution::Stable, Evolution::Scan],
        }
    }
}

fn encoding(name: &str) -> Result<Encoding, String> {
    let found = Encoding::ALL.into_iter().find(|encoding| encoding.name() == name && !encoding.overlaps());
    found.ok_or_else(|| "no encoding that can be measured".to_owned())
}

fn main() -> ExitCode {
    let options = Options::parse();
    let tools = match Tools::find() {
        Ok(tools) => tools,
        Err(missing) => {
            eprintln!("{missing}");
            return ExitCode::from(2);
        }
    };
    match run(options, &tools) {
        Ok(()) => ExitCode::SUCCESS,
        Err(fault) => {
            eprintln!("{fault}");
            ExitCode::FAILURE
        }
    }
}

fn run(options: Options, tools: &Tools) -> Result<(), String> {
    let matiec = matiec::Tools::find().map_err(|missing| eprintln!("without the SFC of MATIEC: {missing}")).ok();
    let c = c::Tools::find().map_err(|missing| eprintln!("without C: {missing}")).ok();
    let others = Others { c: c.as_ref(), matiec: matiec.as_ref() };
    let scratch = tempfile::tempdir().map_err(|e| e.to_string())?;
    let folder = options.folder.unwrap_or_else(|| scratch.path().to_path_buf());
    let sizes = options.sizes.iter().map(|steps| steps.get());
    let rings = sizes.flat_map(|steps| options.tokens.iter().filter_map(move |tokens| Rings::of(steps, tokens.get())));
    let rings = rings.filter_map(|rings| options.walked.map_or(Some(rings), |steps| rings.walked(steps.get())));
    let job = Job {
        rings: rings.collect(),
        encodings: options.encodings,
        evolutions: options.evolution.all(),
        repetitions: options.repetitions.get(),
        limit: Duration::from_secs(options.limit),
    };
    let rows = measure(tools, others, &folder, &job, &|done| eprintln!("{done}"))?;
    let rustc = tools.version();
    if options.json {
        let all = json!({ "rustc": rustc, "opt_level": 3, "repetitions": job.repetitions, "base": BASE, "rows": rows });
        println!("{all:#}");
    } else {
        println!("{rustc} -C opt-level=3, ns a scan, median of {}", job.repetitions);
        table(&rows);
    }
    Ok(())
}

fn table(rows: &[Row]) {
    let columns = format!("{:>10} {:>6} {:>6} {:>7}", "ns", "hand", BASE, "SFC");
    println!("\n{:33} {:^32} {:^32}", "", "idle, and its ratios to", "clearing, and its ratios to");
    println!("{:>6} {:>6}  {:25} {columns} {columns} {:>7} {:>7}", "steps", "tokens", "", "bytes", "rustc/s");
    let mut before = None;
    for Row { rings, spelling, figures } in rows {
        if before.is_some_and(|before| before != rings) {
            println!();
        }
        before = Some(rings);
        let head = format!("{:6} {:6}  {spelling:25}", rings.steps, rings.tokens);
        match figures {
            Err(why) => println!("{head} {why}"),
            Ok(figures) => {
                let rustc = figures.rustc.map_or(String::new(), |seconds| format!("{seconds:.1}"));
                let (idle, clearing) = (spell(&figures.idle), spell(&figures.clearing));
                println!("{head} {idle} {clearing} {:7} {rustc:>7}", figures.bytes);
            }
        }
    }
}

fn spell(figure: &Figure) -> String {
    let ratio = |ratio: Option<f64>| ratio.map_or(String::new(), |ratio| format!("{ratio:.2}"));
    let less = figure.sfc.map_or(String::new(), |times| format!("1/{times:.0}"));
    let (by_hand, growth) = (ratio(figure.by_hand), ratio(figure.growth));
    format!("{:10.1} {by_hand:>6} {growth:>6} {less:>7}", figure.nanoseconds)
}
