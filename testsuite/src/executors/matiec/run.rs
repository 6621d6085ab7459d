//! Function blocks through MATIEC and a C compiler.

use super::tools::Tools;
use crate::executors::c_driver::Runtime;
use crate::executors::function_block::FunctionBlock;
use crate::executors::jobs::{self, Job};
use grafc_backends::il;
use grafc_logic::scan::Program;
use grafc_model::chart::{Arithmetic, Chart, ExprKind, Type};
use grafc_model::reaction::Response;
use std::fs;

/// The language of the code.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Language {
    /// Structured Text.
    St,
    /// Instruction list.
    Il,
}

impl Language {
    /// Both.
    pub const ALL: [Language; 2] = [Language::St, Language::Il];
}

/// A job as the tools take it.
pub(crate) struct Unit {
    /// The text of its function block.
    pub text: String,
    /// The C code that runs it.
    pub driver: String,
}

/// How the C code that MATIEC writes is used. Names are written in capitals there, except that of the list of steps.
///
/// MATIEC cuts off what is behind the point of a nanosecond, so that half of all literals of a time are one too short
/// (`T#1ms` has 999,999). Here they are rounded: what is compared is what grafc wrote.
pub(crate) const RUNTIME: Runtime = Runtime {
    head: "\
#include <stdio.h>
#include <string.h>
#include \"iec_std_lib.h\"
#undef __time_to_timespec
#define __SECONDS(ms, s, m, h, d) ((((long double)(d) * 24 + (h)) * 60 + (m)) * 60 + (s) + (long double)(ms) / 1e3)
#define __time_to_timespec(sign, ms, s, m, h, d) ((IEC_TIMESPEC){ \\
    ((sign) >= 0 ? 1 : -1) * (long int)__SECONDS(ms, s, m, h, d), \\
    ((sign) >= 0 ? 1 : -1) * (long int)((__SECONDS(ms, s, m, h, d) - (long int)__SECONDS(ms, s, m, h, d)) * 1e9 + 0.5) })
TIME __CURRENT_TIME;
BOOL __DEBUG;
#include \"POUS.h\"
#include \"POUS.c\"
#define __STEP_LIST __step_list
static TIME ms(long long t) { TIME r; r.tv_sec = t / 1000; r.tv_nsec = (t % 1000) * 1000000; return r; }
static long long in_ms(TIME t) { return (long long)t.tv_sec * 1000 + t.tv_nsec / 1000000; }
",
    // The time of a step counts from the last call, and before the first one from here.
    instance: |block, start| format!("static {block} d; __CURRENT_TIME = ms({start}LL); {block}_init__(&d, 0);"),
    // MATIEC marks what is declared RETAIN when it makes an instance ready.
    restart: |block, kept| {
        let named = kept.iter().enumerate();
        let saved: String = named.clone().map(|(n, name)| format!("__typeof__(d.{name}) kept_{n} = d.{name}; ")).collect();
        let mark = |(n, name): (usize, &String)| {
            format!(" if (d.{name}.flags & __IEC_RETAIN_FLAG) d.{name}.value = kept_{n}.value;")
        };
        format!("{saved}memset(&d, 0, sizeof d); {block}_init__(&d, 0);{}", named.map(mark).collect::<String>())
    },
    clock: "__CURRENT_TIME = ms(t);",
    call: |block| format!("{block}_body__(&d);"),
    get: |name| format!("d.{name}.value"),
    set: |name, value| format!("d.{name}.value = {value};"),
};

/// Runs all jobs, in one batch if possible. A job's fault is what a tool said.
pub fn run(tools: &Tools, language: Language, jobs: &[Job]) -> Vec<Result<Vec<Response>, String>> {
    let units = jobs.iter().enumerate().map(|(index, job)| unit(language, index, job)).collect();
    jobs::run(jobs, units, |batch, units: &[&Unit]| build_and_play(tools, batch, units))
}

fn unit(language: Language, index: usize, job: &Job) -> Result<Unit, String> {
    let block = match language {
        Language::St => FunctionBlock::structured_text(index, job)?,
        Language::Il => {
            let emit = |program: &Program| il::emit(program, &il::Options::default());
            FunctionBlock::new(index, job, emit, il::names)?
        }
    };
    let driver = RUNTIME.driver(index, &block, &job.stimuli)?;
    Ok(Unit { text: block.text, driver })
}

/// Compiles the units of a batch and runs them; what they print.
pub(crate) fn build_and_play(tools: &Tools, batch: &[usize], units: &[&Unit]) -> Result<String, String> {
    let folder = tempfile::tempdir().map_err(|e| e.to_string())?;
    let source: String = units.iter().map(|u| u.text.as_str()).collect::<Vec<_>>().join("\n");
    fs::write(folder.path().join("charts.st"), &source).map_err(|e| e.to_string())?;
    tools.iec2c(folder.path()).map_err(|said| format!("{said}\n{source}"))?;
    let main = RUNTIME.main(batch, units.iter().map(|unit| unit.driver.as_str()));
    fs::write(folder.path().join("main.c"), &main).map_err(|e| e.to_string())?;
    tools.gcc(folder.path(), "-O0").map_err(|said| format!("{said}\n{source}"))?;
    tools.play(folder.path()).map_err(|said| format!("{said}\n{source}"))
}

/// Whether MATIEC computes something in a chart wrongly, so that a comparison would test MATIEC and not grafc.
///
/// It multiplies the nanoseconds of a time as 32 bits (`T#250ms * 10` is negative), and divides a time into fractions
/// of a millisecond, of which `.gct` has none.
pub fn miscalculates(chart: &Chart) -> bool {
    chart.exprs.iter().any(|expr| match expr.kind {
        ExprKind::Arithmetic(Arithmetic::Multiply | Arithmetic::Divide, _, _) => expr.ty == Type::Time,
        _ => false,
    })
}

/// Whether `iec2c` takes a text.
pub fn accepts(tools: &Tools, text: &str) -> Result<(), String> {
    let folder = tempfile::tempdir().map_err(|e| e.to_string())?;
    fs::write(folder.path().join("charts.st"), text).map_err(|e| e.to_string())?;
    tools.iec2c(folder.path())
}
