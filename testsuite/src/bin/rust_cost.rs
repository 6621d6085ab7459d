//! Measures what a scan of generated Rust costs, beside a `match` by hand and, where it is there, MATIEC's C.
//!
//! ```text
//! cargo run --release -p grafc-testsuite --bin rust_cost -- [--sizes 10,100,1000,10000] [--tokens 1,10,100]
//!     [--encodings switch,single-phase,sequent] [--evolution both] [--repetitions 21] [--limit 300] [--folder DIR]
//!     [--json]
//! ```
//!
//! Needs rustc; with `iec2c` and `gcc` on PATH the SFC of MATIEC is measured too, up to 1,000 steps. `--tokens` says how
//! many rings the steps are shared out to; `--evolution` is `stable`, `scan` or `both`. `--limit` is the seconds that rustc
//! may take for one chart; a row says where it was stopped. `--folder` keeps texts and programs, and does not build again
//! what is there. `--json` writes one object instead of a table.

#![allow(clippy::print_stdout, clippy::print_stderr, reason = "a command")]

use grafc_logic::Encoding;
use grafc_model::reaction::Evolution;
use grafc_testsuite::rings::Rings;
use grafc_testsuite::rust::Tools;
use grafc_testsuite::rust_cost::{BASE, Figure, Job, Row, measure};
use grafc_testsuite::scan_cost::Library;
use serde_json::json;
use std::path::PathBuf;
use std::process::ExitCode;
use std::time::Duration;

const USAGE: &str = "usage: rust_cost [--sizes N,N,…] [--tokens N,N,…] [--encodings NAME,NAME,…] \
    [--evolution stable|scan|both] [--repetitions N] [--limit SECONDS] [--folder DIR] [--json]";

struct Options {
    sizes: Vec<usize>,
    tokens: Vec<usize>,
    encodings: Vec<Encoding>,
    evolutions: Vec<Evolution>,
    repetitions: usize,
    limit: Duration,
    folder: Option<PathBuf>,
    json: bool,
}

fn options() -> Result<Options, String> {
    let mut options = Options {
        sizes: vec![10, 100, 1000, 10000],
        tokens: vec![1, 10, 100],
        encodings: vec![Encoding::Switch, Encoding::SinglePhase, Encoding::Sequent],
        evolutions: vec![Evolution::Stable, Evolution::Scan],
        repetitions: 21,
        limit: Duration::from_secs(300),
        folder: None,
        json: false,
    };
    let mut words = std::env::args().skip(1);
    while let Some(word) = words.next() {
        if word == "--json" {
            options.json = true;
            continue;
        }
        let mut value = || words.next().ok_or_else(|| format!("`{word}` wants a value"));
        match word.as_str() {
            "--sizes" => options.sizes = numbers(&value()?)?,
            "--tokens" => options.tokens = numbers(&value()?)?,
            "--encodings" => options.encodings = value()?.split(',').map(encoding).collect::<Result<_, _>>()?,
            "--evolution" => options.evolutions = evolutions(&value()?)?,
            "--repetitions" => options.repetitions = number(&value()?)?,
            "--limit" => options.limit = Duration::from_secs(number(&value()?)? as u64),
            "--folder" => options.folder = Some(PathBuf::from(value()?)),
            _ => return Err(USAGE.to_owned()),
        }
    }
    Ok(options)
}

fn number(text: &str) -> Result<usize, String> {
    match text.parse() {
        Ok(n) if n > 0 => Ok(n),
        Ok(_) | Err(_) => Err(format!("`{text}` is not a number from 1 on")),
    }
}

fn numbers(text: &str) -> Result<Vec<usize>, String> {
    text.split(',').map(number).collect()
}

fn encoding(name: &str) -> Result<Encoding, String> {
    let found = Encoding::ALL.into_iter().find(|encoding| encoding.name() == name && !encoding.overlaps());
    found.ok_or_else(|| format!("`{name}` is no encoding that can be measured"))
}

fn evolutions(name: &str) -> Result<Vec<Evolution>, String> {
    match name {
        "stable" => Ok(vec![Evolution::Stable]),
        "scan" => Ok(vec![Evolution::Scan]),
        "both" => Ok(vec![Evolution::Stable, Evolution::Scan]),
        _ => Err("`--evolution` wants stable, scan or both".to_owned()),
    }
}

fn main() -> ExitCode {
    let (options, tools) = match options().and_then(|options| Ok((options, Tools::find()?))) {
        Ok(found) => found,
        Err(fault) => {
            eprintln!("{fault}");
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
    let library = Library::find().map_err(|missing| eprintln!("without the SFC of MATIEC: {missing}")).ok();
    let scratch = tempfile::tempdir().map_err(|e| e.to_string())?;
    let folder = options.folder.unwrap_or_else(|| scratch.path().to_path_buf());
    let sizes = options.sizes.iter();
    let rings = sizes.flat_map(|steps| options.tokens.iter().filter_map(|tokens| Rings::of(*steps, *tokens)));
    let job = Job {
        rings: rings.collect(),
        encodings: options.encodings,
        evolutions: options.evolutions,
        repetitions: options.repetitions,
        limit: options.limit,
    };
    let rows = measure(tools, library.as_ref(), &folder, &job, &|done| eprintln!("{done}"))?;
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
    let columns = format!("{:>10} {:>6} {:>6} {:>7}", "ns", "match", BASE, "SFC");
    println!("\n{:27} {:^32} {:^32}", "", "idle, and its ratios to", "clearing, and its ratios to");
    println!("{:>6} {:>6}  {:19} {columns} {columns} {:>7} {:>7}", "steps", "tokens", "", "bytes", "rustc/s");
    let mut before = None;
    for Row { rings, spelling, figures } in rows {
        if before.is_some_and(|before| before != rings) {
            println!();
        }
        before = Some(rings);
        let head = format!("{:6} {:6}  {spelling:19}", rings.steps, rings.tokens);
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
