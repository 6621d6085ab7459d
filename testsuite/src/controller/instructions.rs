//! Instruction lists: IEC 61131-3, edition 2, clause 3.2.

use super::{Memory, Typed, converted, operated};
use crate::executors::function_block::FunctionBlock;
use crate::executors::jobs::Job;
use grafc_backends::il;
use grafc_logic::scan::Program;
use grafc_model::chart::{Type, Value};
use grafc_model::reaction::Response;
use std::collections::BTreeMap;

/// So many instructions in a call are a loop without end.
const MOST: usize = 2_000_000;

/// Runs the instruction list of a job.
///
/// # Errors
/// What is no instruction, or none that can be done.
pub fn run(job: &Job) -> Result<Vec<Response>, String> {
    let emit = |program: &Program| il::emit(program, &il::Options::default());
    let block = FunctionBlock::new(0, job, emit, il::names)?;
    let (_, body) = block.text.rsplit_once("END_VAR\n").ok_or("no declarations")?;
    let list = List::read(body.split("END_FUNCTION_BLOCK").next().unwrap_or_default());
    Memory::new(&block).play(job, |memory| list.call(memory)).map_err(|said| format!("{said} in\n{}", block.text))
}

/// Operators with their operands, and where labels stand.
struct List<'t> {
    instructions: Vec<(&'t str, &'t str)>,
    labels: BTreeMap<&'t str, usize>,
}

impl<'t> List<'t> {
    /// Reads a body; comments may take several lines.
    fn read(body: &'t str) -> Self {
        let mut list = List { instructions: Vec::new(), labels: BTreeMap::new() };
        let pieces = body.split("(*").enumerate();
        let code =
            pieces.map(|(place, piece)| if place == 0 { piece } else { piece.split_once("*)").map_or("", |p| p.1) });
        for line in code.flat_map(str::lines).map(str::trim).filter(|line| !line.is_empty()) {
            match line.strip_suffix(':') {
                Some(label) => drop(list.labels.insert(label, list.instructions.len())),
                None => {
                    let (operator, operand) = line.split_once(' ').unwrap_or((line, ""));
                    list.instructions.push((operator, operand.trim()));
                }
            }
        }
        list
    }

    /// One call.
    fn call(&self, memory: &mut Memory) -> Result<(), String> {
        // What a body begins with is not said.
        let mut accumulator: Option<Typed> = None;
        let mut open: Vec<(&str, Typed)> = Vec::new();
        let mut next = 0;
        for _ in 0..MOST {
            let Some((operator, operand)) = self.instructions.get(next) else { return Ok(()) };
            let fault = |why: &str| format!("{why}: `{operator} {operand}`");
            let value = || accumulator.ok_or_else(|| fault("nothing was loaded"));
            let truth = |value: Typed| match value.0 {
                Value::Bool(truth) => Ok(truth),
                Value::Int(_) | Value::Real(_) | Value::Time(_) => Err(fault("no truth value")),
            };
            let not = |value: Typed| Ok::<_, String>((Value::Bool(!truth(value)?), Some(Type::Bool)));
            next += 1;
            match *operator {
                "LD" => accumulator = Some(loaded(memory, operand)?),
                "LDN" => accumulator = Some(not(loaded(memory, operand)?)?),
                "NOT" => accumulator = Some(not(value()?)?),
                "ST" => memory.store(operand, value()?.0)?,
                "STN" => memory.store(operand, not(value()?)?.0)?,
                "JMP" | "JMPC" | "JMPCN" => {
                    let jumps = *operator == "JMP" || truth(value()?)? == (*operator == "JMPC");
                    let target = self.labels.get(operand).ok_or_else(|| fault("no such label"))?;
                    next = if jumps { *target } else { next };
                }
                "CAL" => {
                    let [input, preset] = ["IN", "PT"].map(|pin| memory.operand(&format!("{operand}.{pin}")));
                    memory.call_timer(operand, input?.0, preset?.0)?;
                }
                ")" => {
                    let (operator, before) = open.pop().ok_or_else(|| fault("nothing is open"))?;
                    accumulator = Some(with(operator, before, value()?, not)?);
                }
                conversion if conversion.contains("_TO_") => accumulator = Some(converted(conversion, value()?)?),
                operator => match operator.strip_suffix('(') {
                    Some(operator) => {
                        open.push((operator, value()?));
                        accumulator = Some(loaded(memory, operand)?);
                    }
                    None => accumulator = Some(with(operator, value()?, loaded(memory, operand)?, not)?),
                },
            }
        }
        Err("the list does not come to its end".to_owned())
    }
}

/// An operand; of a timer that has not been called yet, what it begins with.
fn loaded(memory: &Memory, operand: &str) -> Result<Typed, String> {
    memory.operand(operand).or_else(|fault| match operand.rsplit_once('.') {
        Some((_, "Q")) => Ok((Value::Bool(false), Some(Type::Bool))),
        Some((_, "ET")) => Ok((Value::Time(0), Some(Type::Time))),
        Some(_) | None => Err(fault),
    })
}

/// An operator with its modifier.
fn with(operator: &str, a: Typed, b: Typed, not: impl Fn(Typed) -> Result<Typed, String>) -> Result<Typed, String> {
    match operator {
        "ANDN" => operated("AND", a, not(b)?),
        "ORN" => operated("OR", a, not(b)?),
        "XORN" => operated("XOR", a, not(b)?),
        _ => operated(operator, a, b),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::charts::check;
    use crate::runs::compile;
    use grafc_backends::st;
    use grafc_logic::Options;

    /// Does a list once, with `a` true, `b` and `c` false, `n` the greatest number of its type.
    fn after(list: &str, name: &str) -> Result<Value, String> {
        let text = "input a, b, c : bool\noutput y : bool\noutput n : int\nvar t : time\ninitial step 1 { y }\n";
        let program = compile(&check("chart", text).expect("a chart"), &Options::default()).expect("a scan program");
        let job = Job { program, stimuli: Vec::new() };
        let emit = |program: &Program| st::emit(program, &st::Options::default());
        let block = FunctionBlock::new(0, &job, emit, st::names).expect("a function block");
        let mut memory = Memory::new(&block);
        memory.store("a", Value::Bool(true))?;
        memory.store("n", Value::Int(32767))?;
        List::read(&list.replace(", ", "\n")).call(&mut memory)?;
        memory.operand(name).map(|(value, _)| value)
    }

    #[test]
    fn lists_do_what_the_standard_says() {
        for (list, name, expected) in [
            // From left to right, whatever the operators.
            ("LD 1, ADD 2, MUL 3, ST n", "n", Value::Int(9)),
            ("LD 7, SUB 9, DIV 2, ST n", "n", Value::Int(-1)),
            ("LD -7, MOD 4, ST n", "n", Value::Int(-3)),
            ("LD n, ADD 1, ST n", "n", Value::Int(-32768)),
            ("LD n, INT_TO_DINT, ADD 1, GT 32767, ST y", "y", Value::Bool(true)),
            ("LD a, AND b, OR a, ST y", "y", Value::Bool(true)),
            ("LD b, AND( b, OR a, ), ST y", "y", Value::Bool(false)),
            ("LD a, AND( b, ORN c, ), ST y", "y", Value::Bool(true)),
            ("LD a, XORN b, NOT, STN y", "y", Value::Bool(false)),
            ("LDN a, JMPC x, LD TRUE, ST y, x:", "y", Value::Bool(true)),
            ("LD a, JMPC x, ST y, x:", "y", Value::Bool(false)),
            ("LD a, JMPCN x, JMP z, x:, ST y, z:", "y", Value::Bool(false)),
            ("LD T#2s, MUL 2, ST t", "t", Value::Time(4000)),
            ("LD a, ST f.IN, LD T#0ms, ST f.PT, LD f.Q, ST y", "y", Value::Bool(false)),
            ("LD a, ST f.IN, LD T#0ms, ST f.PT, CAL f, LD f.Q, ST y", "y", Value::Bool(true)),
            ("(* LD 1\nST n *)LD 2 (* two *), ST n", "n", Value::Int(2)),
        ] {
            assert_eq!(after(list, name), Ok(expected), "{list}");
        }
    }

    #[test]
    fn what_cannot_be_done_is_told() {
        for list in [
            "ST y",
            "LD n, ST y",
            "LD z, ST y",
            "JMP x",
            "x:, JMP x",
            "LD a, ), ST y",
            "LD n, DIV 0, ST n",
            "LD n, AND a, ST y",
            "LD a, S y",
            "CAL f",
            "LD n, JMPC x, x:",
            "LD a, ADD 1, ST n",
        ] {
            assert!(after(list, "y").is_err(), "{list}");
        }
    }
}
