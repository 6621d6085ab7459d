//! A function block and a trace as one program.
//!
//! Arrays cannot be shown when the machine ends, so what comes out of a scan is kept in variables of its own: a set of
//! them for each of the last scans, used in turn. A longer trace is played several times, each time further. Truths are
//! kept as the binary digits of numbers, since the compiler takes long for many variables.

use crate::executors::function_block::{Activity, FunctionBlock};
use crate::executors::jobs::{flags, outputs};
use grafc_logic::scan::{Role, VarId};
use grafc_model::chart::{Type, Value};
use grafc_model::reaction::Stimulus;
use std::collections::HashMap;
use std::fmt::Write as _;

/// At most so many variables keep what came out.
const KEPT: usize = 2_000;

/// Truths that a DINT holds.
const DIGITS: usize = 31;

/// A program that plays a trace.
pub(super) struct Play {
    /// Its text.
    pub text: String,
    /// What the names of its own variables begin with.
    prefix: String,
    /// Where each value is that comes out of a scan.
    columns: Vec<Column>,
    /// So many scans of the trace there are.
    scans: usize,
    /// And so many are kept.
    slots: usize,
}

/// A value that comes out of a scan.
struct Column {
    /// What it is in the program.
    formula: String,
    /// Its type.
    ty: Type,
    /// The one that keeps it, of the variables that keep a scan.
    word: usize,
    /// The binary digit there, of a truth.
    digit: usize,
}

impl Play {
    /// The program; an error if a step is held in a way that is not known here, or the text is not as expected.
    pub fn new(block: &FunctionBlock, stimuli: &[Stimulus]) -> Result<Self, String> {
        let prefix = prefix(&block.text);
        let columns = columns(block)?;
        let slots = (KEPT / words(&columns).max(1)).clamp(1, stimuli.len().max(1));
        let text = text(block, stimuli, &prefix, &columns, slots)?;
        Ok(Play { text, prefix, columns, scans: stimuli.len(), slots })
    }

    /// How many scans each run must have, so that every scan is among the last ones of a run.
    pub fn runs(&self) -> impl Iterator<Item = usize> {
        let whole = (1..=self.scans / self.slots).map(|run| run * self.slots);
        whole.chain((self.scans % self.slots != 0).then_some(self.scans))
    }

    /// What [`crate::executors::jobs`] reads, from the variables after so many scans: the scans since the run before.
    pub fn read(&self, index: usize, scans: usize, shown: &str) -> Result<String, String> {
        let values: HashMap<&str, &str> = shown.lines().filter_map(|line| line.split_once(": ")).collect();
        let mut out = String::new();
        for scan in (scans - 1) / self.slots * self.slots..scans {
            let _ = write!(out, "{index} {scan}");
            for column in &self.columns {
                let name = kept(&self.prefix, scan % self.slots, column.word);
                let value = values.get(name.as_str()).ok_or_else(|| format!("`{name}` is not shown"))?;
                let _ = match column.ty {
                    Type::Bool => {
                        let word: u32 = value.parse().map_err(|_| format!("`{name}` is {value}"))?;
                        write!(out, " {}", word >> column.digit & 1)
                    }
                    Type::Time => write!(out, " {}", value.trim_start_matches("T#").trim_end_matches("ms")),
                    Type::Int | Type::Dint | Type::Uint | Type::Udint | Type::Real | Type::Lreal => {
                        write!(out, " {value}")
                    }
                };
            }
            out.push('\n');
        }
        Ok(out)
    }
}

/// The beginning of names that the text does not have.
fn prefix(text: &str) -> String {
    let text = text.to_lowercase();
    (0..).map(|n| format!("play{n}_")).find(|prefix| !text.contains(prefix)).unwrap_or_default()
}

/// A variable that keeps something of a scan.
fn kept(prefix: &str, slot: usize, word: usize) -> String {
    format!("{prefix}{slot}_{word}")
}

/// The values that come out of a scan, in the order of [`crate::executors::jobs`]: truths share the first words.
fn columns(block: &FunctionBlock) -> Result<Vec<Column>, String> {
    let name = |id: VarId| block.names[id].to_string();
    let mut values: Vec<(String, Type)> =
        outputs(&block.program).map(|(id, variable)| (name(id), variable.ty)).collect();
    values.extend(block.activities()?.into_iter().map(|activity| match activity {
        Activity::Bit(id) => (name(id), Type::Bool),
        Activity::Value(id, value) => (format!("{} = {value}", name(id)), Type::Bool),
    }));
    values.extend(flags(&block.program).map(|(id, _)| (name(id), Type::Bool)));
    let truths = values.iter().filter(|(_, ty)| *ty == Type::Bool).count();
    let (mut truth, mut word) = (0, truths.div_ceil(DIGITS));
    let column = |(formula, ty)| {
        let place = if ty == Type::Bool { &mut truth } else { &mut word };
        let here = *place;
        *place += 1;
        match ty {
            Type::Bool => Column { formula, ty, word: here / DIGITS, digit: here % DIGITS },
            _ => Column { formula, ty, word: here, digit: 0 },
        }
    };
    Ok(values.into_iter().map(column).collect())
}

/// How many variables keep a scan.
fn words(columns: &[Column]) -> usize {
    columns.iter().map(|column| column.word + 1).max().unwrap_or_default()
}

/// The text of the program: the block's own, with more variables, with statements before its own and behind them.
fn text(
    block: &FunctionBlock,
    stimuli: &[Stimulus],
    prefix: &str,
    columns: &[Column],
    slots: usize,
) -> Result<String, String> {
    let head = format!("FUNCTION_BLOCK {}\n", block.name);
    let (_, rest) = block.text.split_once(&head).ok_or("the text has no head")?;
    let (declared, body) = rest.rsplit_once("END_VAR\n").ok_or("the text has no variables")?;
    let (body, _) = body.rsplit_once("END_FUNCTION_BLOCK").ok_or("the text has no end")?;
    let mut out = String::new();
    if declared.contains(" : TON;") {
        timer(&mut out, prefix);
    }
    let declared = declared.replace(" : TON;", &format!(" : {prefix}TON;"));
    let _ = writeln!(out, "PROGRAM {}\n{declared}END_VAR\nVAR\n{prefix}scan, {prefix}slot : DINT;", block.name);
    let mut before = String::new();
    let mut array = |name: String, ty: Type, target: String, mut cells: Vec<String>| {
        // IronPLC knows no array of one.
        if let [only] = &cells[..] {
            cells.push(only.clone());
        }
        let (last, ty) = (cells.len().saturating_sub(1), type_name(ty));
        let _ = writeln!(out, "{prefix}{name} : ARRAY[0..{last}] OF {ty} := [{}];", cells.join(", "));
        let _ = writeln!(before, "{target} := {prefix}{name}[{prefix}scan];");
    };
    let times: Vec<String> = stimuli.iter().map(|stimulus| literal(Value::Time(stimulus.t_ms))).collect();
    for timer in timers(&declared, prefix) {
        array(format!("at_{timer}"), Type::Time, format!("{timer}.NOW"), times.clone());
    }
    // Nothing restarts the machine within a run: what is not retained is put back.
    if stimuli.iter().any(|stimulus| stimulus.restart) {
        let marks = stimuli.iter().map(|stimulus| literal(Value::Bool(stimulus.restart))).collect();
        array("restarts".into(), Type::Bool, format!("{prefix}restart"), marks);
    }
    let inputs = block.program.variables.iter_enumerated().filter(|(_, variable)| variable.role == Role::Input);
    for (place, (id, variable)) in inputs.enumerate() {
        let cells = stimuli.iter().map(|stimulus| literal(stimulus.inputs[place])).collect();
        array(format!("in_{place}"), variable.ty, block.names[id].to_string(), cells);
    }
    // What is kept of a scan, and then whatever slot it has.
    let mut after = String::new();
    let mut kinds = vec![Type::Dint; words(columns)];
    let mut sources: Vec<String> = (0..kinds.len()).map(|word| format!("{prefix}{word}")).collect();
    for column in columns {
        let word = column.word;
        if column.ty == Type::Bool {
            let (word, digit) = (&sources[word], 1 << column.digit);
            let begins = if column.digit == 0 { format!("{word} := 0;\n") } else { String::new() };
            let _ = writeln!(after, "{begins}IF {} THEN\n{word} := {word} + {digit};\nEND_IF;", column.formula);
        } else {
            kinds[word] = column.ty;
            sources[word].clone_from(&column.formula);
        }
    }
    for word in 0..kinds.len() {
        let _ = writeln!(out, "{prefix}{word} : DINT;");
    }
    // An `IF` with nothing in it is no statement.
    for slot in (0..slots).filter(|_| !kinds.is_empty()) {
        let _ = writeln!(after, "IF {prefix}slot = {slot} THEN");
        for (word, (source, ty)) in sources.iter().zip(&kinds).enumerate() {
            let name = kept(prefix, slot, word);
            let _ = writeln!(out, "{name} : {};", type_name(*ty));
            let _ = writeln!(after, "{name} := {source};");
        }
        let _ = writeln!(after, "END_IF;");
    }
    if before.contains("restarts[") {
        let _ = writeln!(out, "{prefix}restart : BOOL;");
        let _ = writeln!(before, "IF {prefix}restart THEN");
        let kept = block.program.variables.iter_enumerated().filter(|(_, v)| v.role.is_kept() && !v.retain);
        for (id, variable) in kept {
            let _ = writeln!(before, "{} := {};", block.names[id], literal(variable.initial()));
        }
        for timer in timers(&declared, prefix) {
            let _ = writeln!(before, "{timer}(IN := FALSE, PT := T#1ms);");
        }
        let _ = writeln!(before, "{prefix}restart := FALSE;\nEND_IF;");
    }
    let _ = writeln!(out, "END_VAR\n{before}{body}{after}");
    let _ = writeln!(out, "{prefix}scan := {prefix}scan + 1;\n{prefix}slot := {prefix}slot + 1;");
    let _ = writeln!(out, "IF {prefix}slot = {slots} THEN\n{prefix}slot := 0;\nEND_IF;\nEND_PROGRAM");
    Ok(out)
}

/// An on-delay timer that is told the time.
fn timer(out: &mut String, prefix: &str) {
    let _ = writeln!(
        out,
        "FUNCTION_BLOCK {prefix}TON
VAR_INPUT
IN : BOOL;
PT, NOW : TIME;
END_VAR
VAR_OUTPUT
Q : BOOL;
ET : TIME;
END_VAR
VAR
runs : BOOL;
since : TIME;
END_VAR
IF NOT IN THEN
Q := FALSE;
runs := FALSE;
ET := T#0ms;
ELSIF NOT runs THEN
runs := TRUE;
since := NOW;
ELSE
ET := NOW - since;
Q := ET >= PT;
IF Q THEN
ET := PT;
END_IF;
END_IF;
END_FUNCTION_BLOCK"
    );
}

/// The timers among declared variables.
fn timers<'d>(declared: &'d str, prefix: &str) -> Vec<&'d str> {
    let end = format!(" : {prefix}TON;");
    declared.lines().filter_map(|line| Some(line.split_once(&end)?.0.trim())).collect()
}

fn type_name(ty: Type) -> &'static str {
    match ty {
        Type::Bool => "BOOL",
        Type::Int => "INT",
        Type::Dint => "DINT",
        Type::Uint => "UINT",
        Type::Udint => "UDINT",
        Type::Real => "REAL",
        Type::Lreal => "LREAL",
        Type::Time => "TIME",
    }
}

fn literal(value: Value) -> String {
    match value {
        Value::Bool(b) => if b { "TRUE" } else { "FALSE" }.to_string(),
        Value::Int(n) => n.to_string(),
        Value::Time(ms) => format!("T#{ms}ms"),
        Value::Real(x) => {
            let text = format!("{x:?}").replace('e', "E");
            if text.contains('.') { text } else { text.replace('E', ".0E") }
        }
    }
}
