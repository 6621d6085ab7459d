//! `grafc serve`: the page of a chart in a browser beside the editor, made again at each save.
//!
//! | file | what |
//! | --- | --- |
//! | `board` | what is shown now: the last good page, and the errors that came since |
//! | `guard` | who may ask: this machine, by its own name |
//! | `server` | requests and answers |

mod board;
mod guard;
mod server;

use super::page::{self, PageArguments};
use crate::Exit;
use crate::arguments::MessageArguments;
use crate::report::{Failure, Format, Messages, Report};
use crate::stream::Stream;
use crate::watch;
use board::Board;
use clap::Args;
use grafc::files::print;
use grafc_diagnostics::Policy;
use grafc_page::Live;
use std::sync::Arc;

const AFTER_HELP: &str = "\
Example:
  grafc serve valve.gct
  grafc serve valve.gct --port 8080 --open

The address is printed. The page is made again whenever the chart is saved, and keeps inputs, and the situation where it
still makes sense. Errors are shown over the last good drawing. Only this machine can open the page.";

/// Arguments of `grafc serve`.
#[derive(Args, Debug)]
#[command(after_help = AFTER_HELP)]
pub struct Arguments {
    /// The chart
    #[arg(value_name = "CHART")]
    chart: Stream,
    /// The port on 127.0.0.1; 0 is any that is free [default: 60848, or any if that is taken]
    #[arg(long, value_name = "PORT")]
    port: Option<u16>,
    /// Open the page in the browser
    #[arg(long)]
    open: bool,
    #[command(flatten)]
    page: PageArguments,
    #[command(flatten)]
    messages: MessageArguments,
}

/// Serves the page until the process ends.
pub fn run(args: Arguments) -> Result<Exit, Failure> {
    if args.chart == Stream::Standard {
        return Err(Failure::WrongUse(
            "standard input cannot be watched".to_string(),
            "name a file, or make a page of it with `grafc page -`".to_string(),
        ));
    }
    let policy = args.messages.policy()?;
    let board = Arc::new(Board::default());
    let server = server::bind(args.port)?;
    let address = server.address();
    let mut announced = false;
    let served = board.clone();
    std::thread::spawn(move || server.run(&served));
    watch::run([&args.chart], args.messages.messages(), || {
        let exit = make(&args, &policy, &board);
        if !announced {
            announced = true;
            print(&format!("{address}\n"))?;
            if args.open && open::that_detached(&address).is_err() {
                let help = format!("open {address} yourself");
                return Err(Failure::WrongUse("no browser could be opened".to_string(), help));
            }
        }
        exit
    })
}

/// Makes the page and puts it on the board, or what is wrong.
fn make(args: &Arguments, policy: &Policy, board: &Board) -> Result<Exit, Failure> {
    let mut report = Report::new(policy.clone());
    let file = match report.load(&args.chart) {
        Ok(file) => file,
        Err(refusal) => {
            board.faulty(refusal.to_string());
            return Err(refusal.into());
        }
    };
    let mut made = None;
    if let Some(file) = file {
        let source = report.sources.file(file);
        let version = board::version(&source.text);
        let live = Some(Live { version: &version });
        let (page, said) = page::make(source, &args.chart.chart_name(), &args.page, live)?;
        report.diagnostics.append(said);
        made = page.map(|page| (version, page));
    }
    let exit = report.tell(args.messages.messages());
    match made.filter(|_| exit == Exit::Done) {
        Some((version, page)) => board.good(version, page),
        None => board.faulty(report.render(Messages { format: Format::Human, quiet: true }, false)),
    }
    Ok(exit)
}
